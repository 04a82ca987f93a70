/** How an orbit decays onto an equilibrium, judged by the field's Jacobian at the orbit's current point.
 *
 *  The remaining displacement y solves J y = x' in the decaying subspace: x(infinity) = x - y up to second order. A state whose
 *  rate is exactly 0 and depends on no moving state, such as a coordinate across an invariant plane, is left out: an orbit in that
 *  plane is judged by its motion in the plane alone. */
#ifndef JLT_INTEGRATE_APPROACH_H
#define JLT_INTEGRATE_APPROACH_H

#include "integrate/method.h"

typedef struct {
    bool decays;             /* all rates across the equilibria are negative, and y accounts for the field here */
    double slowest, fastest; /* when decays: rates of decay in tau, > 0 */
    double left[JLT_JACOBIAN_DIM_MAX]; /* when decays: y, shape (dim,) */
    double longest;          /* when decays: the largest |y_i| relative to jlt_approach_size */
    double root_left_out;    /* when decays: bound on how far the part of the field that y misses can move the root (absolute) */
} jlt_approach;

/** Whether y is known well enough: the terms of second order that it leaves out, y^2 times the ratio of the fastest rate to the
 *  slowest, are below a hundredth of the tolerance. */
bool jlt_approach_is_known(const jlt_approach *self, const jlt_stepper *stepper);

/** Whether an equilibrium lies within `distance` of x, shape (dim,), relative to max(|x_i|, size): J y = x' has such a solution y,
 *  up to rounding and terms of second order. An orbit without one goes farther, however slowly. A field with more than
 *  JLT_JACOBIAN_DIM_MAX states is taken to have one where no rate is above distance times size; there is one where eigenvalues are
 *  not found, and none where the Jacobian is not finite, as far out. Cost: as jlt_approach_judge. */
bool jlt_approach_is_near(const jlt_field *field, const double *x, double size, double distance);

/** Judge the stepper's current point. Cost: a Jacobian and its eigenvalues. A field with more than JLT_JACOBIAN_DIM_MAX states is
 *  not judged: it never decays. Errors: NO_CONVERGENCE (eigenvalues). */
JLT_CHECKED jlt_status jlt_approach_judge(jlt_approach *out, const jlt_stepper *stepper);

/** The size that state i is measured against: itself or its scale; 1 for a root. */
double jlt_approach_size(const jlt_stepper *stepper, unsigned i);

#endif
