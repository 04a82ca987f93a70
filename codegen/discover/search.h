/** One linear question of a discovery: which polynomials P up to a degree solve P' + c P = 0, and which of them are new. */
#ifndef TTC_DISCOVER_SEARCH_H
#define TTC_DISCOVER_SEARCH_H

#include "discover/solution.h"
#include "discover/span.h"

/* How far was looked for P of one form, in numbers; remarks say the same in words. */
typedef struct {
    const char *seek, *form; /* "integrals", "factors" or "densities"; such as "P/(x)" or "P' = c P" */
    int degree;              /* of P, at most */
    bool complete;           /* what is known, and sums of products of it as remarks say, is all */
    size_t monomials, rank;  /* of the matrix that proves this; 0: another argument does */
} ttc_discovery_settled;

/* Asked by a discovery of who runs it. Each takes `context`. */
typedef struct {
    void *context;
    /* Whether all claims of the text, records in the language of tables, are proved with the table. is_smooth: receives whether a
     * measure among them is positive and smooth on the domain; NULL: nobody asks. */
    bool (*prove)(void *context, const char *claims, bool *is_smooth);
    /* The last claims were found, but are not proved. */
    void (*complain)(void *context, const char *claims);
    /* A claim of the result, which is proved, in a line or several; a remark on it, in lines of comment. */
    void (*say)(void *context, const char *text);
    void (*remark)(void *context, const char *text);
    void (*settle)(void *context, const ttc_discovery_settled *settled);
    /* What is being worked at. */
    void (*progress)(void *context, const char *text);
} ttc_discovery_host;

typedef struct {
    ttc_flow *flow;
    ttc_discovery_host host;
    uint64_t source;
    ulong *parameters;  /* at which ranks are taken, shape (variable_count,); beyond the parameters it is overwritten */
    ulong *leading;     /* the same, the parameter of the grading 0 */
    ttc_sign_changes changes;
    ttc_grading grading;
    ttc_knowns integrals, factors; /* factors: with cofactors; integrals are not among them */
    ttc_knowns densities;          /* of the table */
    const char *when;   /* the clause that ends each claim; "" for none */
    int degree;
    size_t memory;      /* bytes that a matrix may take */
    double too_large;   /* bytes that the last question would have taken, where that is more; else 0 */
    bool left_out;      /* a degree that was asked for was too large */
    size_t named;       /* names given so far */
    size_t unproved;    /* finds whose claims were not proved */
} ttc_discovery;

typedef struct {
    int degree;
    const ttc_modular_ratio *twist; /* NULL: 0 */
    ulong shift;
    bool has_cofactor;      /* a shift other than 0, which depends on parameters */
    bool keeps_signs;       /* the sign changes, and the grading, of the motion are those of the twist */
    const ttc_ratio *divisor;        /* of P/divisor; NULL: 1 */
    const ttc_modular_ratio *factor; /* 1/divisor: each solution is multiplied by it before it is compared with products; NULL: 1 */
    const ttc_knowns *products; /* what is known: products of these are not new; NULL: nothing is known, not even the constant 1 */
} ttc_question;

/* Dimension of the solutions: at most `bound`, by the rank; at least `explained`, by products of what is known, finds included.
 * Where they agree, these are all. */
typedef struct {
    size_t monomials;
    slong bound, explained;
    bool answered; /* false: no points, or no memory */
} ttc_answer;

/* Told of each new solution, which is kept as `out` is: it may be taken or not; true: it is one of `products` now. */
typedef bool (*ttc_search_taker)(ttc_discovery *d, void *context, const ttc_solution_exact *solution, int degree);

/* take: NULL where it is asked alone whether products are all there is; not answered: that was not shown. */
ttc_answer ttc_search(ttc_discovery *d, const ttc_question *question, ttc_search_taker take, void *context);

/* What the question takes, in bytes, and the columns of its largest matrix; `graded`: as one of leading parts. Nothing is
 * allocated. */
double ttc_search_bytes(const ttc_discovery *d, const ttc_question *question, bool graded, size_t *columns);

#endif
