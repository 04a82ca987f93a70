/** Exact proofs of what a model says of itself.
 *
 *  Every claim becomes ratios that must be zero, over Q(params)(states, roots). No floating point, no sampling: `proved`
 *  is a proof, and `refuted` comes with the nonzero remainder. A claim that says nothing is neither (a denominator that
 *  vanishes under its conditions, an empty zero level, a family outside the model's domain): that is an error. */
#ifndef TTC_PROVE_H
#define TTC_PROVE_H

#include "read/model.h"

/** Reads the target of a `reduction` claim of `model`. Ownership goes to the prover, which destroys it.
 *  NULL: there is none; `diagnostics` may say why. */
typedef ttc_model *(*ttc_resolver)(void *context, const ttc_model *model, const char *target,
                                   ttc_diagnostics *diagnostics);

/* The resolver that reads FILE.tt beside the model's own file; context is ignored. */
ttc_model *ttc_resolve_beside(void *context, const ttc_model *model, const char *target, ttc_diagnostics *diagnostics);

typedef enum { TTC_PROVED, TTC_REFUTED, TTC_MEANINGLESS } ttc_proof_status;

const char *ttc_proof_status_name(ttc_proof_status status); /* "proved", "refuted", "error" */

typedef struct {
    char *name;
    const char *kind;  /* as written in the table; for derived claims "root", "variant", "time", "eliminate" */
    ttc_place place;
    ttc_proof_status status;
    char *remainder;   /* refuted: what is not zero, as text; error: the reason; proved: a witness, or NULL */
    double seconds;
} ttc_proof;

typedef struct {
    char *model, *file, *title;
    char sha256[65];
    ttc_proof *proofs; /* the table's claims in their order, then the derived ones */
    size_t proof_count, proved, refuted, meaningless;
} ttc_proof_report;

typedef enum { TTC_PROVE_ALL, TTC_PROVE_UNTIL_REFUTED } ttc_prove_extent;

/** Prove every claim of a model, that no root is of what is never positive, and that each variant, time and elimination follows
 *  from its field.
 *  resolver: NULL makes every reduction an error. The report is the caller's, for ttc_proof_report_destroy.
 *  UNTIL_REFUTED stops after the first claim that is refuted.
 *  Returns false, and no report, when memory is out. Adds nodes to the model's graph, changes nothing else. */
bool ttc_prove(const ttc_model *model, ttc_resolver resolver, void *context, ttc_prove_extent extent,
               ttc_proof_report **report);
void ttc_proof_report_destroy(ttc_proof_report *report); /* legal on NULL */

#endif
