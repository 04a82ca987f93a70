/** Exact proofs of what a model says of itself.
 *
 *  A claim is proved when it is true at every point of the table's domain that meets its conditions, and there is such a
 *  point, which is shown; refuted when it is false at such a point, which is shown; anything else is not settled, with the
 *  reason. codegen/README.md says what the domain is. Identities are proved over Q(params)(states, roots), in exact arithmetic;
 *  that a point does not exist may be the word of the solver for real arithmetic, and the verdict then says so. */
#ifndef TTC_PROVE_H
#define TTC_PROVE_H

#include "read/model.h"

/** Reads the target of a `reduction` claim of `model`. Ownership goes to the prover, which destroys it.
 *  NULL: there is none; `diagnostics` may say why. */
typedef ttc_model *(*ttc_resolver)(void *context, const ttc_model *model, const char *target,
                                   ttc_diagnostics *diagnostics);

/* The table `target`, FILE.tt, that stands in the folder of the file `of`. NULL: diagnostics say why, or memory is out. */
ttc_model *ttc_model_beside(const char *of, const char *target, ttc_diagnostics *diagnostics);

/* The resolver that reads FILE.tt beside the model's own file; context is ignored. */
ttc_model *ttc_resolve_beside(void *context, const ttc_model *model, const char *target, ttc_diagnostics *diagnostics);

/** What the resolver reads, NULL: none. Out: reason, `size` bytes: where nothing is read, "WHAT FILE could not be read: why". */
ttc_model *ttc_resolve(ttc_resolver resolver, void *context, const ttc_model *model, const char *what, const char *file,
                       char *reason, size_t size);

typedef enum { TTC_PROVED, TTC_REFUTED, TTC_UNSETTLED } ttc_proof_status;

const char *ttc_proof_status_name(ttc_proof_status status); /* "proved", "refuted", "not settled" */

/* How the search for a proof ended: by a verdict, or beyond a bound that command/command_guard.h sets, or with its process, which
 * is a fault of the prover. All but the first leave the claim not settled. */
typedef enum { TTC_ENDED_BY_VERDICT, TTC_ENDED_LATE, TTC_ENDED_OUT_OF_MEMORY, TTC_ENDED_BY_FAULT } ttc_proof_ending;

typedef struct {
    char *name;
    const char *kind;  /* as written in the table; for derived claims as of their records */
    ttc_place place;
    ttc_proof_status status;
    ttc_proof_ending ending;
    char *remainder;   /* refuted: what is not zero or not positive, as text; not settled: the reason; else NULL */
    char *point;       /* proved: a point of the domain that meets the claim's conditions; refuted: one at which it is false */
    char *note;        /* of a measure: where its density is positive and smooth, zero, negative, or has poles; else NULL */
    bool has_smooth_density; /* a measure, proved, positive and smooth on the whole domain */
    bool relies_on_solver;   /* that some point does not exist is the word of the solver for real arithmetic */
    double seconds;
} ttc_proof;

typedef struct {
    char *model, *file, *title;
    char sha256[65];
    ttc_proof *proofs; /* the table's claims in their order, then the derived ones */
    size_t proof_count, proved, refuted, unsettled;
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

/** Whether a quantity is proved to be the same at points that differ by the periods that the table claims; the periods are taken
 *  for granted. */
bool ttc_prove_turns(const ttc_model *model, ttc_id quantity);

/** The claims of a model one by one, so that a caller can bound what each may take. Claims that others rest on are proved when
 *  they are asked for, and once. */
typedef struct ttc_proof_run ttc_proof_run;

ttc_proof_run *ttc_proof_run_create(const ttc_model *model, ttc_resolver resolver, void *context); /* NULL: memory is out */
void ttc_proof_run_destroy(ttc_proof_run *run); /* legal on NULL */
size_t ttc_proof_run_count(const ttc_proof_run *run); /* the table's claims in their order, then the derived ones */
/* Name, kind and place of a claim are there before it is proved. */
const ttc_proof *ttc_proof_run_proof(const ttc_proof_run *run, size_t index);
/* Settles a claim, if it is not settled yet. */
void ttc_proof_run_prove(ttc_proof_run *run, size_t index);
/* Takes a verdict that was reached elsewhere: status, texts and flags of `verdict`, whose texts then belong to the run. */
void ttc_proof_run_accept(ttc_proof_run *run, size_t index, const ttc_proof *verdict);
/* All verdicts up to `count` as a report, which takes them out of the run. NULL: memory is out. */
ttc_proof_report *ttc_proof_run_report(ttc_proof_run *run, size_t count);

#endif
