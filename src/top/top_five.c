#include "top/top_five.h"

#include <string.h>

#include "dynamics/surface.h"
#include "kernel/descriptor.h"
#include "top/level.h"
#include "top/tier.h"

_Static_assert((int)JLT_TOP_FIVE_STATES == JLT_TOP_STATES + 1, "the five states and s");

/* The start on the section as the tier five has it, in the table's units. */
static jlt_status lift(double *x, const jlt_top *top, double G, const jlt_chart *chart, const double *q)
{
    double level[JLT_LEVEL_STATES];
    const jlt_status st = chart->states == JLT_LEVEL_STATES ? chart->lift(chart, level, NULL, q) : JLT_ERR_UNSUPPORTED;

    if (st != JLT_OK) return st;
    memcpy(x, level, 3 * sizeof *x);
    jlt_level_rotation(top, G, &x[JLT_TOP_OMEGA_N], &x[JLT_TOP_OMEGA3], level);
    x[JLT_TOP_STATES] = level[JLT_LEVEL_S];
    return JLT_OK;
}

jlt_status jlt_top_five_open(jlt_top_five *out, const jlt_system *system, const double *q)
{
    const jlt_tier *five = jlt_tier_find("five");
    const jlt_descriptor *general = jlt_descriptor_find(five->model, NULL, five->time, five->elimination);
    const unsigned level = jlt_surface_value(system->surface, "G");
    double params[JLT_CHART_VALUES_MAX];
    jlt_top top;
    jlt_status st = JLT_ERR_UNSUPPORTED;

    *out = (jlt_top_five){ .column = JLT_TOP_OMEGA_TAU, .time = system->units.time };
    if (general == NULL || general->param_count > JLT_CHART_VALUES_MAX || level == system->surface->count) return st;
    for (unsigned i = 0; i < general->param_count; i++) {
        const unsigned value = jlt_surface_value(system->surface, general->params[i].name);
        if (value == system->surface->count) return st;
        params[i] = system->values[value];
    }
    JLT_TRY(jlt_top_read(&top, general, params));
    JLT_TRY(lift(out->start, &top, system->values[level], &jlt_surface_chart(system)->base, q));
    jlt_units_count(out->start, out->start, general->states, general->state_count, &system->units);
    JLT_TRY(jlt_instance_create_in(&out->instance, general, params, &system->units));
    JLT_TRY(jlt_field_of(&out->field, general, out->instance->block));
    JLT_TRY(jlt_conserved_of(&out->invariants, &out->conserved, general, &out->field));
done:
    return st;
}

void jlt_top_five_close(jlt_top_five *self)
{
    jlt_instance_destroy(self->instance);
    self->instance = NULL;
}

int jlt_top_five_side(const double *x)
{
    return x[JLT_TOP_GAMMA3] > 0 ? 1 : -1;
}
