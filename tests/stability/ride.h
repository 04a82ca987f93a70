/* An orbit of the spherical top in any tier and by any method, whose points are read as the five reduced states. */
#ifndef JLT_TESTS_RIDE_H
#define JLT_TESTS_RIDE_H

#include "unit/check.h"

#include "integrate/orbit.h"
#include "kernel/descriptor.h"
#include "scene/tier.h"
#include "top/top.h"

/* (5.1) of Kilin and Ivanova (2023). */
static const jlt_top top_51 = { 1, 1, 1, 0.51, 1.0 / 3, 1.0 / 3 };

enum { RIDE_COLUMNS = 24 };

typedef struct {
    jlt_tier tier;
    jlt_tier_view view;
    jlt_instance *instance; /* owned by the view */
    jlt_field field;
    jlt_orbit *orbit;
    double start[RIDE_COLUMNS]; /* in the tier's coordinates */
} ride;

/* Bind a tier of the top to the start x. */
static inline jlt_status ride_look(jlt_tier_view *view, double *y, const char *tier, const jlt_top *top, const double *x)
{
    const double params[] = { top->m, top->R, top->g, top->a3, top->I1, top->I3 };
    char refusal[JLT_TIER_TEXT_MAX];
    jlt_tier found;

    assert_true(jlt_tier_find(&found, jlt_descriptor_find("spherical_top", NULL, NULL, NULL), NULL, tier));
    return jlt_tier_open(view, y, refusal, &found, params, x);
}

static inline void ride_open(ride *out, const char *tier, const jlt_top *top, const double *x, const jlt_method *method,
                             const jlt_options *options, int direction)
{
    double y[JLT_WAY_VALUES_MAX];

    *out = (ride){ .orbit = NULL };
    assert_ok(ride_look(&out->view, y, tier, top, x));
    out->tier = out->view.tier;
    const jlt_descriptor *special = out->view.instance->descriptor;
    /* use the general field, also where a more special one serves for these parameters */
    const jlt_descriptor *d = jlt_descriptor_sibling(special, NULL, special->time, special->elimination);
    assert_ok(jlt_instance_create(&out->instance, d, out->view.instance->params));
    jlt_instance_destroy(out->view.instance);
    out->view.instance = out->instance;
    assert_true(d->state_count <= RIDE_COLUMNS);
    memcpy(out->start, y, d->state_count * sizeof *y);
    assert_ok(jlt_field_of(&out->field, out->instance));
    jlt_options watched = *options;
    watched.invariants = (jlt_invariants){ d->integral_count, d->integral_values.call, d->integral_gradients.call,
                                            out->instance->prepared };
    assert_ok(jlt_orbit_create(&out->orbit, method, &out->field, &watched));
    assert_ok(jlt_orbit_start(out->orbit, 0, y, direction));
}

static inline void ride_states(const ride *self, double *x, const double *y)
{
    jlt_tier_extract(&self->view, x, y);
}

/* The largest drift of any of the tier's integrals so far. */
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
    jlt_tier_close(&self->view);
}

#endif
