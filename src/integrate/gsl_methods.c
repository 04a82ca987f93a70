/* The methods of GSL, which gives no dense output. One step of DOP853 over the accepted step provides it, of local order 7, bent to
 * end at GSL's point: its error is at most that of DOP853 on the same step, plus GSL's own. Partial steps are
 * DOP853's as well; a step of GSL's controlled methods is short enough for that, being of order 8 or lower or (msadams, order
 * up to 12) shorter still by its stability. */
#include "integrate/dop853.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/memory.h"
#include "ext/gsl_ode.h"
#include "integrate/step_control.h"

typedef struct {
    jlt_gsl_ode *ode;
    jlt_dop853 *companion;
    jlt_stepper *stepper;
    double *trial, *rates, *end; /* (stride,) */
} gsl_state;

static void field(void *context, const double *x, double *f)
{
    jlt_stepper *stepper = context;

    jlt_field_rates(stepper->field, f, x);
    stepper->evaluations++;
}

static jlt_status create_kind(jlt_stepper *stepper, jlt_gsl_ode_kind kind)
{
    gsl_state *self = jlt_memory_array(1, sizeof *self);
    stepper->state = self;
    if (self == NULL) return JLT_ERR_NOMEM;
    self->companion = jlt_dop853_new(stepper);
    self->trial = jlt_memory_array(3 * (size_t)stepper->stride, sizeof *self->trial);
    if (self->companion == NULL || self->trial == NULL) return JLT_ERR_NOMEM;
    self->rates = self->trial + stepper->stride;
    self->end = self->rates + stepper->stride;
    return jlt_gsl_ode_create(&self->ode, kind, stepper->columns, field, stepper, stepper->tolerance);
}

static void destroy(jlt_stepper *stepper)
{
    gsl_state *self = stepper->state;
    if (self == NULL) return;
    jlt_gsl_ode_destroy(self->ode);
    jlt_dop853_free(self->companion);
    free(self->trial);
    free(self);
}

/* Give GSL the stepper's scales, by `set`. GSL multiplies them: the scale of a column that is not controlled must be finite. */
static jlt_status set_scales(const jlt_stepper *stepper, jlt_status (*set)(jlt_gsl_ode *, const double *))
{
    const gsl_state *self = stepper->state;
    double scale[JLT_FIELD_DIM_MAX + 1];

    for (unsigned i = 0; i < stepper->columns; i++) scale[i] = fmin(stepper->scale[i], 1e200);
    return set(self->ode, scale);
}

static jlt_status start(jlt_stepper *stepper)
{
    if (!(stepper->h_next > 0)) stepper->h_next = fmin(1e-3, stepper->max_step);
    return set_scales(stepper, jlt_gsl_ode_reset);
}

static jlt_status step(jlt_stepper *stepper, double limit)
{
    gsl_state *self = stepper->state;
    const double asked = jlt_smaller(stepper->h_next, stepper->max_step), reach = jlt_smaller(limit, stepper->max_step);
    double h = stepper->direction * asked, taken = 0;

    if (stepper->rescaled) JLT_PASS(set_scales(stepper, jlt_gsl_ode_rescale));
    memcpy(self->trial, stepper->x, stepper->columns * sizeof *self->trial);
    JLT_PASS(jlt_gsl_ode_step(self->ode, self->trial, self->rates, &h, &taken, &stepper->rejected,
                              stepper->direction * jlt_smaller(reach, 1e300)));
    if (jlt_step_vanishes(stepper->tau, taken)) return JLT_ERR_NO_PROGRESS;
    stepper->h = taken;
    /* A step cut short by the limit alone says nothing against the longer one. */
    stepper->h_next = reach < asked && fabs(taken) >= reach ? jlt_larger(fabs(h), asked) : fabs(h);
    memcpy(stepper->x_start, stepper->x, stepper->stride * sizeof *stepper->x);
    memcpy(stepper->f_start, stepper->f, stepper->stride * sizeof *stepper->f);
    memcpy(stepper->x, self->trial, stepper->columns * sizeof *stepper->x);
    memcpy(stepper->f, self->rates, stepper->columns * sizeof *stepper->f);
    return JLT_OK;
}

static jlt_status dense(jlt_stepper *stepper)
{
    gsl_state *self = stepper->state;
    jlt_dop853_single(self->companion, stepper, stepper->x_start, stepper->f_start, stepper->h, self->end);
    jlt_dop853_dense(self->companion, stepper, stepper->x_start, stepper->h, self->end);
    stepper->evaluations += 11;
    return JLT_OK;
}

static jlt_status partial(jlt_stepper *stepper, double theta, double *out)
{
    gsl_state *self = stepper->state;
    jlt_dop853_single(self->companion, stepper, stepper->x_start, stepper->f_start, theta * stepper->h, out);
    stepper->evaluations += 11;
    return JLT_OK;
}

/* Only the slopes at the ends are at hand; four times the larger one is generous for steps under error control. */
static double variation(const jlt_stepper *stepper, unsigned column)
{
    return 4 * fabs(stepper->h) * jlt_larger(fabs(stepper->f_start[column]), fabs(stepper->f[column]));
}

static jlt_status create_rk8pd(jlt_stepper *stepper) { return create_kind(stepper, JLT_GSL_RK8PD); }
static jlt_status create_rkf45(jlt_stepper *stepper) { return create_kind(stepper, JLT_GSL_RKF45); }
static jlt_status create_msadams(jlt_stepper *stepper) { return create_kind(stepper, JLT_GSL_MSADAMS); }

#define SHARED .destroy = destroy, .start = start, .step = step, .dense = dense, .partial = partial, .variation = variation

const jlt_method jlt_method_rk8pd = {
    .name = "rk8pd",
    .meaning = "Prince and Dormand 8(7), 13 stages, from GSL",
    .order = 8,
    .share = 1.0 / 16,
    .create = create_rk8pd,
    SHARED,
};

const jlt_method jlt_method_rkf45 = {
    .name = "rkf45",
    .meaning = "Runge, Kutta and Fehlberg 4(5), from GSL",
    .order = 5,
    .share = 1.0 / 1024,
    .create = create_rkf45,
    SHARED,
};

const jlt_method jlt_method_msadams = {
    .name = "msadams",
    .meaning = "Adams of orders 1 to 12 in Nordsieck form, P(EC)^m, from GSL",
    .multistep = true,
    .share = 1.0 / 4096,
    .create = create_msadams,
    SHARED,
};
