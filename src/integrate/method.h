/** Methods of integration, as a table of records that advance a stepper.
 *
 *  Each method keeps its estimate of a step's error below tolerance * share * max(|x_i|, scale_i), in its own norm (see its
 *  file). Some estimates are more cautious than others, and errors of steps add up, so each method has a share of its own,
 *  which is measured: after ten returns of regular orbits the error is about the tolerance by every method. */
#ifndef JLT_INTEGRATE_METHOD_H
#define JLT_INTEGRATE_METHOD_H

#include "integrate/stepper.h"

struct jlt_method {
    const char *name;        /* as typed on the command line */
    const char *meaning;     /* one line, with its source */
    unsigned order;          /* of the accepted solution; 0: variable */
    double share;            /* part of the tolerance that the error estimate of a step may reach; a power of two */
    bool needs_jet;          /* serves fields with Taylor coefficients alone (jlt_field.jet) */
    bool multistep;          /* uses past steps: moving the point restarts it at order 1 */
    jlt_status (*create)(jlt_stepper *self);    /* makes self->state */
    void (*destroy)(jlt_stepper *self);         /* legal when create failed */
    jlt_status (*start)(jlt_stepper *self);     /* x and f changed: forget the past, set h_next when it is 0 */
    /* Make one accepted step of length <= limit (> 0): sets h, h_next, x, x_low, f, x_start, f_start. */
    jlt_status (*step)(jlt_stepper *self, double limit);
    jlt_status (*dense)(jlt_stepper *self);     /* fill dense and dense_degree (>= 3) for the last step */
    /* Compute the state at tau_start + theta*h by a step of its own from the start, local error not above the whole step's;
     * out has shape (stride,) and must not be one of the stepper's arrays. theta may leave [0, 1] by a hundredth; it is as low as
     * -max(1, h_next/|h|) where a crossing at the start of the step is looked for before it (locate.h). */
    jlt_status (*partial)(jlt_stepper *self, double theta, double *out);
    /* These two make a step far from an event cheap; one of them may be NULL. variation: an upper estimate of the total
     * variation of a column over the last step, without an evaluation of the field. bernstein: the column's polynomial in
     * Bernstein form, b (degree + 1,), without an evaluation; it fills dense_error and returns the degree. */
    double (*variation)(const jlt_stepper *self, unsigned column);
    unsigned (*bernstein)(jlt_stepper *self, unsigned column, double *b);
    /* The states at jlt_gauss_node inside the last step, shape (dim, JLT_STEPPER_NODES); NULL where they are not computed. */
    const double *(*nodes)(const jlt_stepper *self);
    /* The same at jlt_gauss_place_between, one between each two of the nodes; NULL where they are not at hand any more. */
    const double *(*between)(const jlt_stepper *self);
};

extern const jlt_method jlt_method_gauss, jlt_method_dop853, jlt_method_taylor, jlt_method_rk8pd, jlt_method_rkf45,
    jlt_method_msadams;

/** The table: gauss (the default: the fastest at every accuracy in `jellett bench`), dop853, taylor, rk8pd, rkf45, msadams.
 *  NULL past the end. */
const jlt_method *jlt_method_at(size_t index);

/** By name; NULL when there is none; the default for NULL. A method of NULL means the default elsewhere: check a name that a user
 *  typed. */
const jlt_method *jlt_method_find(const char *name);

#endif
