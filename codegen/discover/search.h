/** One linear question of a discovery: which polynomials P up to a degree solve P' + c P = 0, and which of them are new. */
#ifndef TTC_DISCOVER_SEARCH_H
#define TTC_DISCOVER_SEARCH_H

#include "discover/solution.h"
#include "discover/span.h"

/* How far P of one form was searched for, in numbers; remarks say it in words. */
typedef struct {
    const char *seek, *form; /* "integrals", "factors" or "densities"; such as "P/(x)" or "P' = c P" */
    int degree;              /* of P, at most */
    bool complete;           /* there are no others but sums of products, as remarks say */
    size_t monomials, rank;  /* of the matrix that proves this; 0: another argument does */
} ttc_discovery_settled;

/* What a discovery calls, each with `context`. */
typedef struct {
    void *context;
    /* Whether all claims of the text, records in the language of tables, are proved with the table. is_smooth, may be NULL:
     * receives whether a measure among them is positive and smooth on the domain. */
    bool (*prove)(void *context, const char *claims, bool *is_smooth);
    /* Report claims that were found, but are not proved. */
    void (*complain)(void *context, const char *claims);
    /* Report a proved claim; a remark, in lines of comment; how far a search went. */
    void (*say)(void *context, const char *text);
    void (*remark)(void *context, const char *text);
    void (*settle)(void *context, const ttc_discovery_settled *settled);
    /* Report what is being computed. */
    void (*progress)(void *context, const char *text);
} ttc_discovery_host;

typedef struct {
    ttc_flow *flow;
    ttc_discovery_host host;
    uint64_t source;
    ulong *parameters;  /* at which ranks are computed, shape (variable_count,); other entries are overwritten */
    ulong *leading;     /* the same, with the parameter of the grading set to 0 */
    ttc_sign_changes changes;
    ttc_grading grading;
    ttc_knowns integrals, factors; /* factors: with cofactors; integrals are not among them */
    ttc_knowns densities;          /* of the table */
    const char *when;   /* the clause that ends each claim; "" for none */
    int degree;
    size_t memory;      /* bytes that a matrix may take */
    double too_large;   /* bytes of the last question, if beyond `memory`; else 0 */
    bool left_out;      /* a requested degree was too large */
    size_t named;       /* names given so far */
    size_t unproved;    /* finds whose claims were not proved */
} ttc_discovery;

typedef struct {
    int degree;
    const ttc_modular_ratio *twist; /* NULL: 0 */
    ulong shift;
    bool has_cofactor;      /* the shift is a cofactor, which depends on parameters */
    bool keeps_signs;       /* the twist respects the sign changes and the grading of the motion */
    const ttc_ratio *divisor;        /* P/divisor is asked for; NULL: 1 */
    const ttc_modular_ratio *factor; /* 1/divisor: each solution is multiplied by it before it is compared with products; NULL: 1 */
    const ttc_knowns *products; /* what is known: products of these are not new; NULL: nothing is known, not even the constant 1 */
} ttc_question;

/* The dimension of solutions is at most `bound`, by the rank, at least `explained`, by products of known functions, finds
 * included. If these agree, there are no others. */
typedef struct {
    size_t monomials;
    slong bound, explained;
    bool answered; /* false: no points, too little memory, or see ttc_search */
} ttc_answer;

/* Called with each new solution, which the caller still owns. Returns true if it added the solution to `products`. */
typedef bool (*ttc_search_taker)(ttc_discovery *d, void *context, const ttc_solution_exact *solution, int degree);

/* take == NULL asks only whether products of known functions are all solutions; `answered` then says that this was shown. */
ttc_answer ttc_search(ttc_discovery *d, const ttc_question *question, ttc_search_taker take, void *context);

/* The bytes that a question takes, and the columns of its largest matrix; graded: for leading parts. Allocates no matrix. */
double ttc_search_bytes(const ttc_discovery *d, const ttc_question *question, bool graded, size_t *columns);

#endif
