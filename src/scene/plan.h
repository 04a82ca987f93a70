/** The planner: chooses the smallest model that can answer a question.
 *
 *  A question names a model, its parameters, a start, and whether it wants quantities that the model's table does not have, such as
 *  attitude and track. The planner tries the model's tiers (scene/tier.h) from the smallest up, and takes the first that serves,
 *  with the most special kernel for the parameters. A tier serves if proved claims lead to it, and its conditions hold at the
 *  parameters and at the start. */
#ifndef JLT_SCENE_PLAN_H
#define JLT_SCENE_PLAN_H

#include "scene/tier.h"

enum { JLT_PLAN_PARAMS_MAX = JLT_WAY_VALUES_MAX, JLT_PLAN_STATES_MAX = JLT_WAY_VALUES_MAX };

typedef struct {
    const jlt_descriptor *model; /* the general field of the model asked for */
    const double *params;        /* shape (model->param_count,), checked */
    const double *start;         /* shape (model->state_count,), checked; NULL: any */
    bool more;                   /* the tier's table must observe something that the asked one does not */
    bool section;                /* the tier's table must describe a section */
    const char *tier;            /* take this tier; NULL: the planner chooses; "model": the asked model's own kernel in t */
    const jlt_way_tables *others; /* tables beside the built-in ones; NULL: none */
} jlt_question;

typedef struct {
    jlt_tier tier;
    const jlt_descriptor *descriptor; /* its kernel; NULL: none (quadratures), or not built in */
    char refusal[JLT_TIER_TEXT_MAX];  /* why it does not serve; "": it serves */
    const jlt_claim *broken;          /* the unproved claim because of which it is refused; NULL: another reason, or none */
    bool may_serve_elsewhere;         /* it is refused for these parameters, or from this start, only */
} jlt_candidate;

typedef struct {
    jlt_candidate candidates[JLT_TIERS_MAX]; /* (count,), from the smallest up */
    unsigned count, chosen;           /* chosen: index of the candidate that answers */
    bool forced;                      /* the question named the tier */
    const jlt_descriptor *reduced;    /* the asked model's most special kernel in t, whose integrals are watched */
} jlt_plan;

/** Say in words why a candidate does not serve, with the unproved claim if there is one: "... (reduction level: dG/dt = ...)". Out:
 *  text, `size` bytes. */
void jlt_plan_refusal(char *text, size_t size, const jlt_candidate *candidate);

/** Make the plan. Errors: ARG, no model, no params, or no such tier; UNSUPPORTED, none serves, or the tier asked for does not
 *  (plan->chosen then is that tier, and its refusal says why); NOMEM. */
JLT_CHECKED jlt_status jlt_plan_make(jlt_plan *out, const jlt_question *question);

/** Whether a candidate serves for the question's orbit from another start, shape (states,), where the orbit has left the region of
 *  a smaller tier. Out: *by, the candidate's tier by the way that serves from this start. */
bool jlt_plan_serves(jlt_tier *by, const jlt_candidate *candidate, const jlt_question *question, const double *start);

/** Name of the chosen tier. */
const char *jlt_plan_tier(const jlt_plan *plan);

#endif
