/** The eighth-order method of Dormand and Prince with the error control and the dense output of Hairer, Norsett and Wanner. */
#ifndef JLT_INTEGRATE_DOP853_H
#define JLT_INTEGRATE_DOP853_H

#include "integrate/method.h"

typedef struct jlt_dop853 jlt_dop853;

jlt_dop853 *jlt_dop853_new(const jlt_stepper *stepper); /* NULL: out of memory */
void jlt_dop853_free(jlt_dop853 *self);                     /* NULL is legal */

/** Make a single step h from x, where the field is f, without error estimate: x(h) into out. All shape (stride,). Cost: 11
 *  evaluations, which the caller adds to stepper->evaluations. */
void jlt_dop853_single(jlt_dop853 *self, const jlt_stepper *stepper, const double *x, const double *f, double h,
                       double *out);

/** Make the polynomial of degree 7 of the step from x to x_end, just made by jlt_dop853_single, in stepper->dense. Cost: 4
 *  evaluations, which are added here. */
void jlt_dop853_dense(jlt_dop853 *self, jlt_stepper *stepper, const double *x, double h, const double *x_end);

#endif
