/** Exact proofs of the claims of a model.
 *
 *  A claim is proved if it is true at every point of the table's domain that meets its conditions, and such a point is shown;
 *  refuted if it is false at such a point, which is shown; otherwise it is not settled, with a reason. codegen/README.md
 *  defines the domain. Identities are proved over Q(params)(states, roots), in exact arithmetic; that a point does not exist
 *  may rest on the solver for real arithmetic, and the verdict then says so. */
#ifndef TTC_PROVE_H
#define TTC_PROVE_H

#include "read/model.h"

/** Reads the table `target` that a claim of `model` names, for the caller to destroy. NULL on failure; diagnostics may say why. */
typedef ttc_model *(*ttc_resolver)(void *context, const ttc_model *model, const char *target,
                                   ttc_diagnostics *diagnostics);

/* Read the table `target`, FILE.tt, in the folder of the file `of`. Returns NULL after a report, or when memory is out. */
ttc_model *ttc_model_beside(const char *of, const char *target, ttc_diagnostics *diagnostics);

/* The resolver that reads FILE.tt beside the model's own file; context is ignored. A process, and those that it forks later, go by
 * the text that it has read first, also if the file is edited meanwhile: what is proved of a table, and the digest that is written
 * with the proof, are of one text. */
ttc_model *ttc_resolve_beside(void *context, const ttc_model *model, const char *target, ttc_diagnostics *diagnostics);

/** Read a table by the resolver, and give it a symbol for pi (ttc_model_with_pi). Returns NULL on failure, also if the resolver is
 *  NULL; reason, `size` bytes, is then "WHAT FILE could not be read: why", or says that memory is out. */
ttc_model *ttc_resolve(ttc_resolver resolver, void *context, const ttc_model *model, const char *what, const char *file,
                       char *reason, size_t size);

typedef enum { TTC_PROVED, TTC_REFUTED, TTC_UNSETTLED } ttc_proof_status;

const char *ttc_proof_status_name(ttc_proof_status status); /* "proved", "refuted", "not settled" */

/* How the search for a proof ended: by a verdict; at a bound on time or memory, see command/command_guard.h; by the system, which
 * may let it end another day; or by a fault of the prover: a crash of its process, or a proof that a second witness contradicts.
 * All but the first leave the claim not settled. */
typedef enum {
    TTC_ENDED_BY_VERDICT,
    TTC_ENDED_LATE,
    TTC_ENDED_OUT_OF_MEMORY,
    TTC_ENDED_BY_SYSTEM,
    TTC_ENDED_BY_FAULT
} ttc_proof_ending;

typedef struct {
    char *name;
    const char *kind;  /* keyword of the claim; of derived claims, that of their record */
    ttc_place place;
    ttc_proof_status status;
    ttc_proof_ending ending;
    char *remainder;   /* refuted: the value that is not zero or not positive, as text; not settled: the reason; else NULL */
    char *point;       /* proved: a point of the domain that meets the claim's conditions; refuted: one at which it is false */
    char *note;        /* of a measure: where its density is positive and smooth, zero, negative, or has poles; of an integral that
                          is constant on a level which was split: this; else NULL */
    bool has_smooth_density; /* a proved measure whose density is positive and smooth on the whole domain */
    bool relies_on_solver;   /* that some point does not exist rests on the solver for real arithmetic alone */
    double seconds;
} ttc_proof;

typedef struct {
    char *model, *file, *title;
    char sha256[65];
    ttc_proof *proofs; /* the table's claims in their order, then the derived ones */
    size_t proof_count, proved, refuted, unsettled;
} ttc_proof_report;

typedef enum { TTC_PROVE_ALL, TTC_PROVE_UNTIL_REFUTED } ttc_prove_extent;

/** Prove every claim of a model, and every derived one, see prove_derived.h.
 *  resolver: with NULL, claims about other tables are not settled. The caller owns the report, for ttc_proof_report_destroy.
 *  UNTIL_REFUTED stops after the first claim that is refuted.
 *  Returns false, and no report, when memory is out. Adds nodes to the model's graph, changes nothing else. */
bool ttc_prove(const ttc_model *model, ttc_resolver resolver, void *context, ttc_prove_extent extent,
               ttc_proof_report **report);
void ttc_proof_report_destroy(ttc_proof_report *report); /* legal on NULL */

/** Returns true if a quantity is proved to be equal, under the conditions `when` on parameters, at points that differ by claimed
 *  periods; the periods are taken for granted. */
bool ttc_prove_turns(const ttc_model *model, ttc_id quantity, const ttc_bindings *when);

/** A run proves the claims of a model one by one, so that a caller can bound the resources of each. A claim on which others rest
 *  is proved when it is first needed, and once. */
typedef struct ttc_proof_run ttc_proof_run;

ttc_proof_run *ttc_proof_run_create(const ttc_model *model, ttc_resolver resolver, void *context); /* NULL: memory is out */
void ttc_proof_run_destroy(ttc_proof_run *run); /* legal on NULL */
size_t ttc_proof_run_count(const ttc_proof_run *run); /* the table's claims in their order, then the derived ones */
/* The proof of a claim; its name, kind and place are set from the start, the rest once it is proved. */
const ttc_proof *ttc_proof_run_proof(const ttc_proof_run *run, size_t index);
/* Prove a claim, unless that was done before. */
void ttc_proof_run_prove(ttc_proof_run *run, size_t index);
/* Called with each claim that is proved, as soon as it is: returns how this is contradicted, for free(), or NULL. A contradicted
 * claim is not settled, for a fault of the prover. */
typedef char *(*ttc_proof_witness)(void *context, const ttc_proof *proof);
void ttc_proof_run_set_witness(ttc_proof_run *run, ttc_proof_witness witness, void *context);
/* Set a verdict that was reached elsewhere: status, texts and flags of `verdict`, whose texts the run then owns. */
void ttc_proof_run_accept(ttc_proof_run *run, size_t index, const ttc_proof *verdict);
/* Move the first `count` proofs from the run to a report. Returns NULL when memory is out. */
ttc_proof_report *ttc_proof_run_report(ttc_proof_run *run, size_t count);

#endif
