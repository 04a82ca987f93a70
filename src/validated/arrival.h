/** Where a box of states arrives on a section, when, with which derivative.
 *
 *  The box is carried to an instant near the crossing. There, over [-d, d], solutions stay in a box Y with f_c != 0, c the
 *  section's column, so that each crosses once, and transversally: at a time tau in (level - x_c)/f_c(Y), by the mean value
 *  theorem, which must lie within [-d, d]. The state there is in x + tau f(Y), and its derivative, with V that of the flow,
 *      (1 - f e_c^T/f_c) V,
 *  the factor being the variation of the time. The whole set follows from its middle by the mean value theorem, so that what it is
 *  late by does not count. */
#ifndef JLT_VALIDATED_ARRIVAL_H
#define JLT_VALIDATED_ARRIVAL_H

#include "validated/step.h"

enum { JLT_ARRIVAL_VALIDS_MAX = 16 };

typedef struct {
    unsigned dim;
    arb_ptr x;         /* (dim,), on the section */
    arb_mat_t slope;   /* (dim, dim), of x in the start; its row of the section's column is 0 */
    arb_t time;        /* that it took */
    arb_t window;      /* around the instant: in it each start of the box crosses the section once */
    arb_t expansion;   /* integral of the divergence on the way */
    arf_struct least[JLT_ARRIVAL_VALIDS_MAX]; /* lower bounds of the model's conditions on the way */
    unsigned steps;
} jlt_arrival;

void jlt_arrival_init(jlt_arrival *self, unsigned dim); /* ends with jlt_arrival_clear */
void jlt_arrival_clear(jlt_arrival *self);

/** Enclose the arrival of all starts of a box. In: start, shape (dim,), dim that of the step's formulas; the section x[column] =
 *  level; instant > 0, exact, near the crossing; direction, the sign of the crossing. On failure *self is not meaningful.
 *  Errors: NO_PROGRESS, also where steps become shorter than 2^-22 of the way; DOMAIN, as jlt_step_advance, or the crossing is not
 *  shown to lie in the table's domain; NO_CONVERGENCE, it is not shown to be one; ARG, more conditions than there is room for. */
JLT_CHECKED jlt_status jlt_arrival_compute(jlt_arrival *self, jlt_step *step, arb_srcptr start, unsigned column, const arb_t level,
                                           const arf_t instant, int direction);

#endif
