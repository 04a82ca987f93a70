/** Encloses the arrival of a box of states on a section: state, time and derivative.
 *
 *  The box is carried to an instant near the crossing. Over [-d, d] around it, solutions stay in a box Y with f_c != 0, c being
 *  the section's column, so each crosses once, and transversally. By the mean value theorem the time tau of the crossing, which
 *  must lie within [-d, d], is in
 *      (level - x_c)/f_c(Y).
 *  The state at the crossing is in x + tau f(Y), and its derivative, with V that of the flow, is
 *      (1 - f e_c^T/f_c) V,
 *  where the factor accounts for the variation of the crossing time. The whole set is enclosed from its middle and this derivative
 *  by the mean value theorem, so the spread of crossing times does not widen the enclosure. */
#ifndef JLT_VALIDATED_ARRIVAL_H
#define JLT_VALIDATED_ARRIVAL_H

#include "validated/step.h"

enum { JLT_ARRIVAL_VALIDS_MAX = 16 };

typedef struct {
    unsigned dim;
    arb_ptr x;         /* (dim,), on the section */
    arb_mat_t slope;   /* (dim, dim), derivative of x by the start; the row of the section's column is 0 */
    arb_t time;        /* from the start to the crossing */
    arb_t window;      /* around the instant: within it each start of the box crosses the section once */
    arb_t expansion;   /* integral of the divergence up to the crossing */
    arf_struct least[JLT_ARRIVAL_VALIDS_MAX]; /* lower bounds of the model's conditions up to the crossing */
    unsigned steps;
} jlt_arrival;

void jlt_arrival_init(jlt_arrival *self, unsigned dim); /* release with jlt_arrival_clear */
void jlt_arrival_clear(jlt_arrival *self);

/** Enclose the arrival of all starts of a box. In: start, shape (dim,), dim that of the step's formulas; the section x[column] =
 *  level; instant > 0, exact, near the crossing; direction, the sign of the crossing. On failure *self is not meaningful.
 *  Errors: NO_PROGRESS, also if steps become shorter than 2^-22 of `instant`; DOMAIN, as jlt_step_advance, or the crossing is not
 *  proved to lie in the table's domain; NO_CONVERGENCE, a unique transversal crossing is not proved; ARG, too many conditions. */
JLT_CHECKED jlt_status jlt_arrival_compute(jlt_arrival *self, jlt_step *step, arb_srcptr start, unsigned column, const arb_t level,
                                           const arf_t instant, int direction);

#endif
