/** Proves what a table claims, and compares it with what its compiled kernels compute. The findings are plain data that depend on
 *  neither time, place nor addresses: the same seed gives the same findings. */
#ifndef JLT_CLAIMS_VERIFY_H
#define JLT_CLAIMS_VERIFY_H

#include "analysis/measure.h"
#include "prove/prove.h"
#include "spectrum/oracle.h"

#include <signal.h>

/* One comparison over all samples of the domain or of a family; it holds if no error exceeds its derived bound. The size of
 * a number is the sum of the moduli of all values rounded on the way to it, each weighted by its influence on the result. An ulp
 * here is 2^-53 of that size, so errors and bounds count roundings, however much cancels. */
typedef struct {
    const char *name, *bound; /* what is compared; how the bound is derived */
    size_t compared;          /* numbers compared */
    double worst_part;        /* largest ratio of an error to its bound; the next two members are that error and that bound */
    double error_ulp, bound_ulp;
    double lost;              /* most decimal digits that the table's formula loses to cancellation: log10(size / |number|) */
} jlt_verify_check;

enum { JLT_VERIFY_CHECKS_MAX = 16 };

typedef struct {
    const jlt_equilibria *family; /* NULL: the whole domain */
    bool expands; /* kernels may multiply out what the table's expressions factor */
    size_t samples, refused; /* refused: samples at which a kernel reported an error, such as an overflow or underflow */
    jlt_verify_check checks[JLT_VERIFY_CHECKS_MAX];
    size_t check_count;
    double lapack_worst, arpack_worst; /* largest difference to other routes, relative to the matrix; not judged */
    size_t arpack_used;
} jlt_verify_family;

/* A certificate at one rational point. */
typedef struct {
    const jlt_equilibria *family;
    char *point;       /* "a = 1, x = 3/5, ..." */
    bool exact;        /* every component of f is exactly zero */
    bool excludes_zero;
    char *trace, *enclosure; /* exact fraction, NULL if irrational; 256-bit ball */
} jlt_verify_certificate;

/* The search for an invariant density with one descriptor's kernels. */
typedef struct {
    const jlt_descriptor *descriptor;
    double *params;          /* owned */
    jlt_measure_attempt attempt;
    double residual;         /* largest div(rho f) over the table's densities, relative to its terms */
    bool contradicted;       /* an equilibrium excludes the density that was found */
    jlt_status status;
} jlt_verify_density;

typedef struct {
    const jlt_descriptor *descriptor; /* general field */
    const char *file;                 /* the user's own table; tables that its claims name lie beside it; NULL: built in */
    size_t seed, samples;             /* samples: points of the domain, and on each family */
    jlt_oracle *oracle;
    jlt_random random;
    const volatile sig_atomic_t *interrupt;
    ttc_proof_report *proofs;
    jlt_verify_family domain, *families;
    size_t family_count;
    jlt_verify_certificate *certificates;
    size_t certificate_count;
    jlt_verify_density *densities;
    size_t density_count;
    size_t held, failed; /* totals over all parts */
} jlt_verify_run;

/** Prove all claims exactly. In: descriptor, file, seed and samples of *run; all other members zero. The caller passes *run to
 *  jlt_verify_clear whatever is returned. Errors: NOMEM; UNSUPPORTED if the embedded table cannot be parsed. */
JLT_CHECKED jlt_status jlt_verify_prove(jlt_verify_run *run);

/** After jlt_verify_prove, check the field on its domain, families of equilibria, certificates and densities through the kernels;
 *  the domain only of tables that a sample can hold. Raising *interrupt ends the sampling early. Errors: UNSUPPORTED (families of a
 *  table with more states than a sample holds), NOMEM. */
JLT_CHECKED jlt_status jlt_verify_measure(jlt_verify_run *run, const volatile sig_atomic_t *interrupt);
void jlt_verify_clear(jlt_verify_run *run);

/* The three parts of jlt_verify_measure; each fills its members of the run and adds to `held` and `failed`. */
JLT_CHECKED jlt_status jlt_verify_families(jlt_verify_run *run);
JLT_CHECKED jlt_status jlt_verify_certify(jlt_verify_run *run);
JLT_CHECKED jlt_status jlt_verify_densities(jlt_verify_run *run);

/* The table's claim that defines a family; NULL if there is none. */
const ttc_claim *jlt_verify_claim(const jlt_verify_run *run, const jlt_equilibria *family);

/* Draw random parameters, shape (params,), that satisfy the table's sign conditions: the defaults where there are any (kind 0),
 * extreme (kind 2) or moderate (any other kind) values. */
void jlt_verify_draw_params(double *params, const jlt_descriptor *descriptor, jlt_random *random, unsigned kind);

#endif
