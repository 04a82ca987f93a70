/** The eighth-order method of Dormand and Prince with the error control and the dense output of Hairer, Norsett and Wanner. */
#ifndef JLT_INTEGRATE_DOP853_H
#define JLT_INTEGRATE_DOP853_H

#include "integrate/method.h"

typedef struct jlt_dop853 jlt_dop853;

jlt_dop853 *jlt_dop853_new(const jlt_stepper *stepper); /* NULL: out of memory */
void jlt_dop853_free(jlt_dop853 *self);                     /* NULL is legal */

/** x(h) from `x`, where the field is `f`, into out (stride,): a single step without error estimate. Cost: 11 evaluations. */
void jlt_dop853_single(jlt_dop853 *self, const jlt_stepper *stepper, const double *x, const double *f, double h,
                       double *out);

/** After jlt_dop853_single: its polynomial of degree 7 into stepper->dense. Cost: 4 evaluations. */
void jlt_dop853_dense(jlt_dop853 *self, jlt_stepper *stepper, const double *x, double h, const double *x_end);

#endif
