/** Methods of integration, as a table of records, and the stepper that they advance.
 *
 *  A stepper holds the current point and the last accepted step. Its method advances it by one accepted step at a time, with
 *  its own control of the local error. It gives the solution inside that step as a polynomial, and more accurately as the
 *  state at one given fraction of it.
 *
 *  Each method keeps its estimate of a step's error below tolerance * share * max(|x_i|, scale_i), in its own norm (see its
 *  file). Some estimates are more cautious than others, and errors of steps add up, so each method has a share of its own,
 *  which was measured: after ten returns of the regular orbits of (5.1) the error is about the tolerance by every method. */
#ifndef JLT_INTEGRATE_METHOD_H
#define JLT_INTEGRATE_METHOD_H

#include <stdbool.h>
#include <stddef.h>

#include "integrate/field.h"

enum { JLT_DENSE_DEGREE_MAX = JLT_JET_ORDER_MAX };

typedef struct jlt_method jlt_method;

/** The point, the last step and the counters. Read freely; only methods and `jlt_stepper_*` write. Arrays have `stride`
 *  entries: the states, then t for a field in its own time, then zeros. */
typedef struct {
    const jlt_method *method;
    const jlt_field *field;
    double tolerance;     /* of a step; `asked` times the method's share */
    double asked;
    double max_step;      /* INFINITY: none */
    unsigned columns;     /* field->dim, and one more in a time of its own */
    unsigned stride;      /* columns rounded up to a multiple of 8 */
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

    double *gradients;    /* room for those of the field's conditions */
    double *scale;        /* below it a column counts as small; INFINITY: not controlled */
    unsigned controlled;  /* columns in the error norm */
    bool watches;         /* something of the field's domain */
    bool at_edge;         /* the orbit is about to leave the domain of its field, and no point of it is left to come to */
    unsigned approaches;  /* steps that were shortened because they would have left it */
    size_t steps, rejected;
    size_t evaluations;   /* of the field so far; gauss: with the 8 that the next step begins with, whether it is taken or not */
    void *state;          /* the method's own */
} jlt_stepper;

struct jlt_method {
    const char *name;        /* as typed on the command line */
    const char *meaning;     /* one line, with its source */
    unsigned order;          /* of the accepted solution; 0: variable */
    unsigned dense_order;    /* local error of the polynomial is O(h^(dense_order + 1)); 0: variable */
    unsigned evaluations;    /* of the field an accepted step; 0: variable */
    double share;            /* of the tolerance: what the error estimate of a step may be; a power of two */
    bool needs_jet;
    bool multistep;          /* lives on past steps: a point that is moved after every step would set it back to order 1 */
    jlt_status (*create)(jlt_stepper *self);    /* makes self->state */
    void (*destroy)(jlt_stepper *self);         /* legal when create failed */
    jlt_status (*start)(jlt_stepper *self);     /* x and f changed: forget the past, set h_next when it is 0 */
    /* One accepted step of length <= limit (> 0): sets h, h_next, x, x_low, f, x_start, f_start. */
    jlt_status (*step)(jlt_stepper *self, double limit);
    jlt_status (*dense)(jlt_stepper *self);     /* fill dense and dense_degree (>= 3) for the last step */
    /* The state at tau_start + theta*h by a step of its own from the start, local error not above the whole step's;
     * out has shape (stride,) and must not be one of the stepper's arrays. theta may leave [0, 1] by a little. */
    jlt_status (*partial)(jlt_stepper *self, double theta, double *out);
    /* These two make a step far from an event cheap; one of them may be NULL. variation: an upper estimate of the total
     * variation of a column over the last step, without an evaluation of the field. bernstein: the column's polynomial in
     * Bernstein form, b (degree + 1,), without an evaluation; it fills dense_error and returns the degree. */
    double (*variation)(const jlt_stepper *self, unsigned column);
    unsigned (*bernstein)(jlt_stepper *self, unsigned column, double *b);
};

/** The table: gauss (the default: the fastest at every accuracy in `jellett bench`), dop853, taylor, rk8pd, rkf45, msadams.
 *  NULL past the end. */
const jlt_method *jlt_method_at(size_t index);

/** By name; NULL when there is none; the default for NULL. */
const jlt_method *jlt_method_find(const char *name);

/** Create a stepper; call jlt_stepper_start before jlt_stepper_advance. Out: *out, NULL on failure.
 *  In: method, NULL for the default; tolerance in (0, 1); max_step > 0 in tau, or INFINITY. The stepper keeps a pointer to
 *  `field`, which must live as long. Errors: ARG; UNSUPPORTED, taylor on a field without a jet; NOMEM. */
JLT_CHECKED jlt_status jlt_stepper_create(jlt_stepper **out, const jlt_method *method, const jlt_field *field,
                                          double tolerance, double max_step);
void jlt_stepper_destroy(jlt_stepper *self); /* NULL is legal */

/** Put it at x, shape (dim,), at physical time t (tau starts at t as well), to go forwards (direction > 0) or backwards.
 *  first_step > 0 proposes the first step, 0 leaves it to the method. Errors: NONFINITE, x or the field there. */
JLT_CHECKED jlt_status jlt_stepper_start(jlt_stepper *self, double t, const double *x, double direction,
                                         double first_step);

/** Replace the point by x, shape (dim,), a state near it (a projection). Time, counters and the proposed step stay, and the
 *  last step's polynomial is changed to end at x. Errors: NONFINITE. Cost: 1 evaluation; msadams starts again at order 1. */
JLT_CHECKED jlt_status jlt_stepper_replace(jlt_stepper *self, const double *x);

/** Make one accepted step, |h| <= limit in tau. On failure the point is that of the last accepted step.
 *  Errors: NONFINITE, no step however short gives finite values; NO_PROGRESS, tau + h = tau; DOMAIN, the orbit
 *  is at an end of the field's domain, as jlt_edge_reached says, and it goes on beyond; or it began outside;
 *  or no step can be made, and jlt_edge_is_ahead. */
JLT_CHECKED jlt_status jlt_stepper_advance(jlt_stepper *self, double limit);

/** Make the polynomial of the last step, once. Cost: none (gauss, taylor), 3 evaluations (dop853), 15
 *  (the others). */
JLT_CHECKED jlt_status jlt_stepper_dense(jlt_stepper *self);

/** The value of that polynomial at theta in [0, 1], for one column or for all, out (columns,). Call jlt_stepper_dense
 *  before. */
double jlt_stepper_value(const jlt_stepper *self, unsigned column, double theta);
void jlt_stepper_values(const jlt_stepper *self, double theta, double *out);

/** Physical time now, at the rounding level. */
double jlt_stepper_time(const jlt_stepper *self);

#endif
