#include "ext/gsl_ode.h"

#include "core/guard.h"
#include "ext/gsl.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <stdlib.h>

struct jlt_gsl_ode {
    gsl_odeiv2_system system;
    gsl_odeiv2_driver *driver;
    jlt_gsl_ode_field field;
    void *context;
    size_t dim;
    double tolerance;
    double clock; /* time since the reset, by which msadams distinguishes a new step from a repeated one */
};

static int call(double t, const double x[], double f[], void *self)
{
    const jlt_gsl_ode *ode = self;
    (void)t;
    ode->field(ode->context, x, f);
    /* GSL accepts steps whose error estimate is NaN, but halves those in which the field returns an error. */
    if (!jlt_guard_finite(f, ode->dim)) return GSL_EDOM;
    return GSL_SUCCESS;
}

jlt_status jlt_gsl_ode_create(jlt_gsl_ode **out, jlt_gsl_ode_kind kind, size_t dim, jlt_gsl_ode_field field, void *context,
                              double tolerance)
{
    const gsl_odeiv2_step_type *const types[] = { gsl_odeiv2_step_rk8pd, gsl_odeiv2_step_rkf45, gsl_odeiv2_step_msadams };
    jlt_gsl_ode *self;

    *out = NULL;
    jlt_gsl_quiet();
    self = calloc(1, sizeof *self);
    if (self == NULL) return JLT_ERR_NOMEM;
    self->system = (gsl_odeiv2_system){ .function = call, .dimension = dim, .params = self };
    self->field = field;
    self->context = context;
    self->dim = dim;
    self->tolerance = tolerance;
    self->driver = gsl_odeiv2_driver_alloc_y_new(&self->system, types[kind], 1e-3, tolerance, tolerance);
    if (self->driver == NULL) {
        free(self);
        return JLT_ERR_NOMEM;
    }
    *out = self;
    return JLT_OK;
}

void jlt_gsl_ode_destroy(jlt_gsl_ode *self)
{
    if (self == NULL) return;
    gsl_odeiv2_driver_free(self->driver);
    free(self);
}

jlt_status jlt_gsl_ode_rescale(jlt_gsl_ode *self, const double *scale)
{
    gsl_odeiv2_driver *d = self->driver;
    gsl_odeiv2_control *control = gsl_odeiv2_control_scaled_new(self->tolerance, self->tolerance, 1, 0, scale, self->dim);

    if (control == NULL) return JLT_ERR_NOMEM;
    gsl_odeiv2_control_free(d->c);
    d->c = control;
    return gsl_odeiv2_control_set_driver(control, d) == GSL_SUCCESS ? JLT_OK : JLT_ERR_ARG;
}

jlt_status jlt_gsl_ode_reset(jlt_gsl_ode *self, const double *scale)
{
    JLT_PASS(jlt_gsl_ode_rescale(self, scale));
    self->clock = 0;
    return gsl_odeiv2_driver_reset(self->driver) == GSL_SUCCESS ? JLT_OK : JLT_ERR_ARG;
}

jlt_status jlt_gsl_ode_step(jlt_gsl_ode *self, double *x, double *f, double *h, double *taken, size_t *rejected,
                            double limit)
{
    gsl_odeiv2_driver *d = self->driver;
    const unsigned long failed = d->e->failed_steps;
    const double before = self->clock;
    const int code = gsl_odeiv2_evolve_apply(d->e, d->c, d->s, &self->system, &self->clock, before + limit, h, x);

    *rejected += d->e->failed_steps - failed;
    if (code == GSL_EDOM) return JLT_ERR_NONFINITE;
    if (code != GSL_SUCCESS || self->clock == before) return JLT_ERR_NO_PROGRESS;
    if (!jlt_guard_finite(x, self->dim)) return JLT_ERR_NONFINITE;
    for (size_t i = 0; i < self->dim; i++) f[i] = d->e->dydt_out[i];
    *taken = d->e->last_step;
    return JLT_OK;
}
