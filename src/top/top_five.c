#include "top/top_five.h"

#include <string.h>

#include "kernel/descriptor.h"
#include "top/system_top.h"
#include "top/tier.h"

_Static_assert((int)JLT_TOP_FIVE_STATES == JLT_TOP_STATES + 1, "the five states and s");

/* The start on the section as the tier five has it, in the flow's units. */
static jlt_status lift(double *x, const jlt_system *system, const double *q)
{
    const jlt_chart *chart = system->flow.chart;
    double level[JLT_CHART_STATES_MAX];
    const jlt_status st = chart->lift(chart, level, NULL, q);

    if (st != JLT_OK) return st;
    memcpy(x, level, 3 * sizeof *x);
    jlt_chart_top_rotation((const jlt_chart_top *)(const void *)chart, &x[JLT_TOP_OMEGA_N], &x[JLT_TOP_OMEGA3], level);
    x[JLT_TOP_STATES] = level[JLT_CHART_TOP_S];
    return JLT_OK;
}

jlt_status jlt_top_five_open(jlt_top_five *out, const jlt_system *system, const double *q)
{
    const jlt_tier *five = jlt_tier_find("five");
    const jlt_top_values v = jlt_system_top_values(system);
    const double params[] = { v.m, v.R, v.g, v.a3, v.I1, v.I3 };
    const jlt_units units = jlt_chart_top_units(jlt_system_top_chart(system));
    const jlt_descriptor *general = jlt_descriptor_find(five->model, NULL, five->time, five->elimination);
    jlt_status st = JLT_OK;

    *out = (jlt_top_five){ .column = JLT_TOP_OMEGA_TAU, .time = units.time };
    if (general == NULL || general->param_count != sizeof params / sizeof *params) return JLT_ERR_UNSUPPORTED;
    JLT_TRY(lift(out->start, system, q));
    JLT_TRY(jlt_instance_create_in(&out->instance, general, params, &units));
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
