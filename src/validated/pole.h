/** Proves that all motions from a box of states end at a pole: an end of a state's interval, which they reach in finite time.
 *
 *  The record `pole` of a table claims that in a time tau that lifts a root r, dt/dtau is r times a factor other than 0 at the
 *  pole, and that r = 0 is invariant there, so that motions reach the pole only as tau tends to infinity. To show that they do,
 *  the box is carried to an instant tau from which it settles on equilibria with r = 0 (settle.h). These lie at an end of the
 *  state's interval: roots are positive wherever the table is defined, and all other conditions of its domain are shown to hold
 *  there, as on the way. So until then motions stay away from the ends, where r = 0, and other lifted roots stay positive. The
 *  table's time t is one of the states, and has a finite limit. */
#ifndef JLT_VALIDATED_POLE_H
#define JLT_VALIDATED_POLE_H

#include "validated/settle.h"

typedef struct {
    const jlt_descriptor *descriptor; /* general field, in its own time */
    const char *time;                 /* name of the time, which lifts a root that is 0 at the pole */
    unsigned state;                   /* index of the state whose interval ends at the pole */
    arb_srcptr params;                /* (params,), numbers or intervals */
    arb_srcptr box;                   /* (states,), where the motions begin */
    unsigned digits;                  /* decimals to compute with */
    jlt_step_watch *watch;            /* is called after the steps of the proof; NULL: nobody */
} jlt_pole_question;

typedef enum {
    JLT_POLE_PROVED,
    JLT_POLE_OPEN,    /* not shown to settle from the instant on */
    JLT_POLE_OUTSIDE, /* the box is not shown to lie in the table's domain */
    JLT_POLE_LEAVES,  /* the motions are not shown to stay in it on the way to the instant */
    JLT_POLE_EITHER   /* the motions settle, but are not shown to do so at one particular end of this state's interval */
} jlt_pole_verdict;

typedef struct {
    jlt_pole_verdict verdict;
    bool is_high;      /* whether the pole is the upper end of the interval */
    unsigned states;   /* number of the table's states */
    bool *vanishes;    /* (states,): states whose limit is exactly 0 */
    arb_ptr limit;     /* (states,): enclosures of the limits */
    arb_t time;        /* that the motions take, in the table's own time */
    arf_struct *least; /* (valid_count,): lower bounds of the model's conditions all the way */
    unsigned valid_count;
} jlt_pole_result;

/** Allocate the result; free it with jlt_pole_result_clear. */
void jlt_pole_result_init(jlt_pole_result *self, const jlt_descriptor *descriptor);
void jlt_pole_result_clear(jlt_pole_result *self);

/** Carry out the proof. In and out: instant, exact, in the time `time`: how far the box is carried before it is to settle. If it is
 *  0, the box is carried until it settles, through at most 1000 steps, and the instant is set. Errors: as
 *  jlt_formulas_create_lifted and jlt_step_create. Cost: some 100 steps. */
JLT_CHECKED jlt_status jlt_pole_prove(jlt_pole_result *result, const jlt_pole_question *question, arf_t instant);

#endif
