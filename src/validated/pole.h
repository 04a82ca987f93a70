/** All motions from a box that end at a pole: they come to an end of a state's interval, in a finite time.
 *
 *  The record `pole` claims what such an end is: in a time tau that lifts a root r, dt/dtau is r times what does not vanish there,
 *  and the state's end and r = 0 are kept, so that motions come there as tau goes to infinity alone. That some do is shown here:
 *  the box is carried to an instant tau, from where it settles on a plane of equilibria with r = 0 (settle.h). On it the state is
 *  at an end of its interval, since the root is positive wherever the table is defined. t, carried as one more state, has a limit
 *  too. */
#ifndef JLT_VALIDATED_POLE_H
#define JLT_VALIDATED_POLE_H

#include "validated/settle.h"

typedef struct {
    const jlt_descriptor *descriptor; /* general field, in its own time */
    const char *time;                 /* of the table: it lifts a root that is zero at the pole */
    unsigned state;                   /* whose interval ends there */
    arb_srcptr params;                /* (params,), any of which may be an interval */
    arb_srcptr box;                   /* (states,) */
    unsigned digits;                  /* decimals that count */
} jlt_pole_question;

typedef enum {
    JLT_POLE_PROVED,
    JLT_POLE_OPEN,    /* from the instant on the box is not shown to settle */
    JLT_POLE_OUTSIDE, /* the box is not shown to lie in the table's domain */
    JLT_POLE_EITHER   /* it settles, and is not shown to do so at one end of this state's interval */
} jlt_pole_verdict;

typedef struct {
    jlt_pole_verdict verdict;
    bool is_high;              /* which end */
    unsigned states;           /* of the table */
    bool *vanishes;            /* (states,): those whose limit is exactly 0 */
    arb_ptr limit;             /* (states,); that of the pole's state is its end */
    arb_t time;                /* t at the end, less t at the start */
    arf_struct *least;         /* the model's conditions all the way, (valid_count,), lower bounds */
    unsigned valid_count;
} jlt_pole_result;

/** Room for what is found. Ends with jlt_pole_result_clear. */
void jlt_pole_result_init(jlt_pole_result *self, const jlt_descriptor *descriptor);
void jlt_pole_result_clear(jlt_pole_result *self);

/** The proof. In and out: instant, exact, > 0, in the time that is named: where the flight ends; 0: as soon as the box settles, or
 *  after 1000 steps, and it is then set. Errors: as jlt_formulas_create_lifted, jlt_step_advance; NOMEM. Cost: some 100 steps. */
JLT_CHECKED jlt_status jlt_pole_prove(jlt_pole_result *result, const jlt_pole_question *question, arf_t instant);

#endif
