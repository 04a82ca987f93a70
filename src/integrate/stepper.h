/** The stepper, which a method advances.
 *
 *  A stepper holds the current point and the last accepted step. Its method advances it by one accepted step at a time, with
 *  its own control of the local error. It gives the solution inside that step as a polynomial, and more accurately as the
 *  state at one given fraction of it. */
#ifndef JLT_INTEGRATE_STEPPER_H
#define JLT_INTEGRATE_STEPPER_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

#include "integrate/field.h"

enum { JLT_DENSE_DEGREE_MAX = JLT_JET_ORDER_MAX, JLT_STEPPER_WIDTH = 8, JLT_STEPPER_NODES = 8 };

/** The least scale, in place of 0, since 0/0 is NaN. */
#define JLT_STEPPER_SCALE_LEAST 1e-290

typedef struct jlt_method jlt_method;

/** The point, the last step and the counters. Read freely; only methods and `jlt_stepper_*` write. Arrays have `stride`
 *  entries: the states, then t for a field in its own time, then zeros. */
typedef struct {
    const jlt_method *method;
    const jlt_field *field;
    double tolerance;     /* of a step: asked*share, at least min(asked, 1e-15) */
    double asked;         /* by the caller */
    double max_step;      /* INFINITY: none */
    unsigned columns;     /* field->dim, and one more in a time of its own */
    unsigned stride;      /* columns rounded up to a multiple of JLT_STEPPER_WIDTH */
    double direction;     /* +1 or -1: sign of the steps */

    double tau;           /* end of the last step, now; compensated by tau_low */
    double tau_low;
    double *x, *x_low;    /* the point now, and the rounding error of x that is carried along: x + x_low is the better value */
    double *f;            /* dx/dtau there */
    double h_next;        /* proposed, > 0 */

    double tau_start;     /* the last accepted step: start, length (signed), state and slope there */
    double h;
    double *x_start, *f_start;
    double *dense;        /* x(tau_start + theta*h)_i = sum_k dense[k*stride + i] theta^k, 0 <= theta <= 1 */
    unsigned dense_degree;
    double dense_error;   /* estimate of the polynomial's error inside the step, relative to max(|x_i|, scale_i) */
    bool dense_ready;

    double *gradients;    /* room for those of the field's conditions, (conditions, domain states) */
    double size;          /* jlt_field_size_at the start */
    double *scale;        /* below which a column counts as small; INFINITY: not controlled */
    double *full_scale;   /* `scale` before it is reduced for small groups (jlt_field.groups) */
    bool rescaled;        /* the last point changed scales */
    unsigned controlled;  /* columns in the error norm */
    bool watches;         /* steps look for ends of the domain: it restricts orbits, or a state is lost */
    jlt_state_set lost;   /* states, kept or in groups, that have been below the least scale, and are only errors now */
    bool at_edge;         /* the last point counts as the domain's end; the next advance returns DOMAIN */
    unsigned approaches;  /* steps that were shortened because they would have left the domain */
    unsigned leaps;       /* steps since a long one that were taken in spite of their error (leap.h) */
    size_t steps, rejected;
    size_t evaluations;   /* of the field so far; gauss: with the 8 that the next step begins with, whether it is taken or not;
                             taylor: of its jet, one a step */
    void *state;          /* the method's own */
} jlt_stepper;

/** Create a stepper; call jlt_stepper_start before jlt_stepper_advance. Out: *out, NULL on failure.
 *  In: method, NULL for the default; tolerance in (0, 1); max_step > 0 in tau, or INFINITY. The stepper keeps a pointer to
 *  `field`, which must live as long. Errors: ARG, also a field whose root, controlled states, scales or domain are out of range;
 *  UNSUPPORTED, taylor on a field without a jet; NOMEM. */
JLT_CHECKED jlt_status jlt_stepper_create(jlt_stepper **out, const jlt_method *method, const jlt_field *field,
                                          double tolerance, double max_step);
void jlt_stepper_destroy(jlt_stepper *self); /* NULL is legal */

/** Put the stepper at x, shape (dim,), at physical time t (tau starts at t as well), to go forwards (direction > 0) or backwards.
 *  first_step > 0 proposes the first step, 0 leaves it to the method. Errors: NONFINITE, x, the field there, or what
 *  overflows on the way to it. */
JLT_CHECKED jlt_status jlt_stepper_start(jlt_stepper *self, double t, const double *x, double direction,
                                         double first_step);

/** The size below which state i counts as small, for distances from an end of its interval or from a level near 0: its scale; the
 *  orbit's size for a kept one; 1 for a root or a state that is not controlled, which has no scale. */
static inline double jlt_stepper_unit(const jlt_stepper *self, unsigned i)
{
    if (self->scale[i] > JLT_STEPPER_SCALE_LEAST && self->scale[i] < INFINITY) return self->scale[i];
    return jlt_field_keeps(self->field, i) ? self->size : 1;
}

/** Replace the point by x, shape (dim,), a state near it (a projection), and the scales by `scale`, shape (dim,), unless NULL.
 *  Time, counters and the proposed step stay, and the last step's polynomial is changed to end at x. Errors: NONFINITE. Cost: 1
 *  evaluation; msadams starts again at order 1. */
JLT_CHECKED jlt_status jlt_stepper_replace(jlt_stepper *self, const double *x, const double *scale);

/** Make one accepted step, |h| <= limit in tau, limit > 0. On failure the point is that of the last accepted step.
 *  Errors: NONFINITE, no step however short gives finite values, or what overflows on the way to them; NO_PROGRESS, tau + h =
 *  tau; NO_CONVERGENCE, of a partial step where the domain's end is looked for; DOMAIN: the orbit is at an end of the field's
 *  domain and would leave it (jlt_edge_reached), it began outside, or no step can be made and the end is ahead
 *  (jlt_edge_is_ahead). */
JLT_CHECKED jlt_status jlt_stepper_advance(jlt_stepper *self, double limit);

/** Make the polynomial of the last step, once. Errors: none of the built-in methods fails; otherwise those of method->dense.
 *  Cost: none (gauss, taylor), 3 evaluations (dop853), 15 (the others). */
JLT_CHECKED jlt_status jlt_stepper_dense(jlt_stepper *self);

/** The value of that polynomial at theta in [0, 1], for one column or for all, out (columns,). Call jlt_stepper_dense
 *  before. */
double jlt_stepper_value(const jlt_stepper *self, unsigned column, double theta);
void jlt_stepper_values(const jlt_stepper *self, double theta, double *out);

/** The states inside the last step at the fractions jlt_gauss_node of it (gauss_coefficients.h), and between these at
 *  jlt_gauss_place_between, shape (dim, JLT_STEPPER_NODES); NULL where the method does not have them at hand. */
const double *jlt_stepper_nodes(const jlt_stepper *self);
const double *jlt_stepper_between(const jlt_stepper *self);

/** Physical time now, at the rounding level; and where the last step began. */
double jlt_stepper_time(const jlt_stepper *self);
double jlt_stepper_time_start(const jlt_stepper *self);

/** Whether the last step moved every controlled state by less than 1e-4 of its size. No method needs so short steps to be accurate:
 *  what limits them is a rate of the field that the motion no longer shows (a stiff motion). */
bool jlt_stepper_is_held(const jlt_stepper *self);

#endif
