/* An orbit of the spherical top in a tier of its own choice, by a method of its own choice, seen as the five reduced states. */
#ifndef JLT_TESTS_RIDE_H
#define JLT_TESTS_RIDE_H

#include "unit/check.h"

#include "integrate/orbit.h"
#include "kernel/descriptor.h"
#include "kernel/instance.h"
#include "top/tier.h"

/* (5.1) of Kilin and Ivanova (2023). */
static const jlt_top top_51 = { 1, 1, 1, 0.51, 1.0 / 3, 1.0 / 3 };

enum { RIDE_COLUMNS = 24, RIDE_PARAMS = 16 };

typedef struct {
    const jlt_tier *tier;
    jlt_tier_view view;
    jlt_instance *instance;
    jlt_field field;
    jlt_orbit *orbit;
} ride;

static inline void ride_open(ride *out, const char *tier, const jlt_top *top, const double *x, const jlt_method *method,
                             const jlt_options *options, int direction)
{
    double params[RIDE_PARAMS], y[RIDE_COLUMNS];

    *out = (ride){ .tier = jlt_tier_find(tier) };
    assert_non_null(out->tier);
    const jlt_descriptor *d = jlt_descriptor_find(out->tier->model, NULL, out->tier->time, out->tier->elimination);
    assert_non_null(d);
    assert_true(d->param_count <= RIDE_PARAMS && d->state_count <= RIDE_COLUMNS);
    jlt_tier_look(&out->view, out->tier, d, top, x);
    assert_ok(jlt_tier_params(params, &out->view));
    assert_ok(jlt_instance_create(&out->instance, d, params));
    assert_ok(jlt_field_of(&out->field, d, out->instance->block));
    out->tier->embed(&out->view, y, x);
    jlt_options watched = *options;
    watched.invariants = (jlt_invariants){ d->integral_count, d->integral_values.call, d->integral_gradients.call,
                                            out->instance->block };
    assert_ok(jlt_orbit_create(&out->orbit, method, &out->field, &watched));
    assert_ok(jlt_orbit_start(out->orbit, 0, y, direction));
}

static inline void ride_states(const ride *self, double *x, const double *y)
{
    self->tier->extract(&self->view, x, y);
}

/* The largest drift of the integrals so far. */
static inline double ride_drift(const ride *self)
{
    double drift[JLT_INVARIANTS_MAX], worst = 0;

    jlt_orbit_drift(self->orbit, drift);
    for (unsigned i = 0; i < self->instance->descriptor->integral_count; i++) worst = fmax(worst, drift[i]);
    return worst;
}

static inline void ride_close(ride *self)
{
    jlt_orbit_destroy(self->orbit);
    jlt_instance_destroy(self->instance);
}

#endif
