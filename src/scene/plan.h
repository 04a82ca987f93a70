/** The planner: chooses the smallest model that can answer a question.  * A question names a model, its parameters, a start,
 *  and whether attitude and track are wanted. If the model has tiers (top/tier.h), they are tried from the smallest up, and the
 *  first that can answer is taken, with the most special kernel for the parameters. Any other model answers by its own kernel,
 *  in a time in which roots are lifted when its table has one. */
#ifndef JLT_SCENE_PLAN_H
#define JLT_SCENE_PLAN_H

#include "top/tier.h"

enum { JLT_PLAN_CANDIDATES_MAX = 16, JLT_PLAN_PARAMS_MAX = 64, JLT_PLAN_STATES_MAX = 128 };

typedef struct {
    const jlt_descriptor *model; /* the general field that was asked about */
    const double *params;        /* shape (model->param_count,), checked */
    const double *start;         /* shape (model->state_count,), checked; NULL: any */
    bool attitude;
    bool section;                /* a table that describes a section is needed */
    const char *tier;            /* take this tier; NULL: the planner chooses; "model": the asked model's own kernel */
} jlt_question;

typedef struct {
    const jlt_tier *tier;             /* NULL: the model's own kernel */
    const jlt_descriptor *descriptor; /* NULL: no kernel (quadratures), or not built in */
    const char *refusal;              /* NULL when it serves */
    const jlt_claim *broken;          /* the claim without a proof for which it is refused; NULL: another reason, or none */
} jlt_candidate;

typedef struct {
    jlt_candidate candidates[JLT_PLAN_CANDIDATES_MAX]; /* in the order of the table */
    unsigned count, chosen;
    bool forced;                      /* by name */
    const jlt_descriptor *reduced;    /* the asked model's most special kernel in t: its integrals are watched */
} jlt_plan;

/** Why a candidate does not serve, with the claim that is not proved: "...: reduction on_level: dG/dt = ...". */
void jlt_plan_refusal(char *text, size_t size, const jlt_candidate *candidate);

/** Make the plan. A tier is taken only if proved claims link its table to the one that was asked about (kernel/link.h).
 *  Errors: ARG, no such tier; UNSUPPORTED, none serves, or the tier asked for does not (plan->chosen then is that tier, and
 *  its refusal says why). */
JLT_CHECKED jlt_status jlt_plan_make(jlt_plan *out, const jlt_question *question);

/** Name of the chosen tier, "model" for a model's own kernel. */
const char *jlt_plan_tier(const jlt_plan *plan);

#endif
