/** What a table claims, proved and compared with what its compiled kernels compute. Each part gathers its findings as plain
 *  data; nothing in them depends on time, place or addresses, so that the same seed gives the same findings. */
#ifndef JLT_CLAIMS_VERIFY_H
#define JLT_CLAIMS_VERIFY_H

#include "analysis/measure.h"
#include "prove/prove.h"
#include "spectrum/oracle.h"

#include <signal.h>

/* One comparison over all samples of a family; it holds when no error passes the bound derived for it.
 * A number's size is the sum of the moduli of what is rounded on the way to it, each with the weight it has in the result;
 * an ulp here is 2^-53 of that, so that errors and bounds count roundings, whatever cancels. */
typedef struct {
    const char *name, *bound; /* what is compared; where the bound comes from */
    size_t compared;          /* numbers compared */
    double worst_part;        /* largest error as a part of its bound; the next two are that error and that bound */
    double error_ulp, bound_ulp;
    double lost;              /* decimal digits that the table's formula loses where terms cancel most: log10(size / |number|) */
} jlt_verify_check;

enum { JLT_VERIFY_CHECKS_MAX = 16 };

typedef struct {
    const jlt_equilibria *family;
    size_t samples, refused; /* refused: an overflow or underflow on the way, reported as an error by the kernels */
    jlt_verify_check checks[JLT_VERIFY_CHECKS_MAX];
    size_t check_count;
    double gsl_worst, arpack_worst; /* largest difference to other eigenvalue routes, relative to the matrix: measured only */
    size_t arpack_used;
} jlt_verify_family;

/* A certificate at one rational point. */
typedef struct {
    const jlt_equilibria *family;
    char *point;       /* "a = 1, x = 3/5, ..." */
    bool exact;        /* every component of f is exactly zero, in rational arithmetic */
    bool excludes_zero;
    char *trace, *enclosure; /* exact fraction (NULL when irrational); 256-bit ball */
} jlt_verify_certificate;

/* The attempt at a density on one kernel. */
typedef struct {
    const jlt_descriptor *descriptor;
    double *params;          /* owned */
    jlt_measure_attempt attempt;
    double residual;         /* worst div(rho f) of the table's densities, relative to its terms */
    bool contradicted;       /* an equilibrium excludes the density that was found */
    jlt_status status;
} jlt_verify_density;

typedef struct {
    const jlt_descriptor *descriptor; /* general field */
    const char *file;                 /* of the user's own table, beside which lie those that its claims speak of; NULL: built in */
    size_t seed, samples;             /* samples: points on each family */
    jlt_oracle *oracle;
    jlt_random random;
    const volatile sig_atomic_t *interrupt;
    ttc_proof_report *proofs;
    jlt_verify_family *families;
    size_t family_count;
    jlt_verify_certificate *certificates;
    size_t certificate_count;
    jlt_verify_density *densities;
    size_t density_count;
    size_t held, failed; /* totals over all sections */
} jlt_verify_run;

/** The exact proofs. In: descriptor, seed and samples of *run, the rest zeroed; to be given to jlt_verify_clear whatever is
 *  returned. Errors: NOMEM; UNSUPPORTED when the embedded table does not read. */
JLT_CHECKED jlt_status jlt_verify_prove(jlt_verify_run *run);

/** After them: families of equilibria, certificates and densities through the kernels. interrupt: raised, the samples end
 *  early. Errors: UNSUPPORTED (a family of more states or parameters than samples have), NOMEM. */
JLT_CHECKED jlt_status jlt_verify_measure(jlt_verify_run *run, const volatile sig_atomic_t *interrupt);
void jlt_verify_clear(jlt_verify_run *run);

/* Each fills its part of the run and counts what held and what failed. */
JLT_CHECKED jlt_status jlt_verify_families(jlt_verify_run *run);
JLT_CHECKED jlt_status jlt_verify_certify(jlt_verify_run *run);
JLT_CHECKED jlt_status jlt_verify_densities(jlt_verify_run *run);

/* The claim of the table that a family comes from. */
const ttc_claim *jlt_verify_claim(const jlt_verify_run *run, const jlt_equilibria *family);

/* Random parameters that satisfy the table's conditions: moderate, extreme, or the defaults. Shape (params,). */
void jlt_verify_draw_params(double *params, const jlt_descriptor *descriptor, jlt_random *random, unsigned kind);

#endif
