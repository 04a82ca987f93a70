#include "cli/certify_cycle.h"

#include "dynamics/periodic.h"
#include "integrate/orbit.h"
#include "kernel/descriptor.h"

#include <math.h>
#include <string.h>

/* Move x, shape (the chart's states,), along the orbit for a time T; angles are not reduced by their periods. */
static jlt_status follow(double *x, const jlt_flow *flow, double T)
{
    jlt_orbit *orbit = NULL;
    jlt_status st = jlt_orbit_create(&orbit, flow->method, flow->field, &(jlt_options){ .tolerance = flow->tolerance });

    if (st == JLT_OK) st = jlt_orbit_start(orbit, 0, x, 1);
    if (st == JLT_OK) st = jlt_orbit_propagate(orbit, ldexp(T, -flow->units.time), x);
    jlt_orbit_destroy(orbit);
    return st;
}

/* The period of each state, in the flow's units, 0 for none: the table's; on a plane section, those of --modulo for the section's
 * state and its coordinates. */
static void set_periods(double *period, const jlt_system *system, const jlt_descriptor *general)
{
    const jlt_chart *chart = system->flow.chart;
    size_t state;

    for (unsigned s = 0; s < general->state_count; s++)
        period[s] = ldexp(general->states[s].period, -system->flow.units.state[s]);
    if (system->surface != NULL) return;
    period[chart->column] = chart->turn;
    for (unsigned k = 0; k < chart->dim; k++)
        if (jlt_descriptor_state(general, chart->names[k], &state)) period[state] = chart->period[k];
}

jlt_exit jlt_certify_cycle_check(const jlt_system *system)
{
    const jlt_descriptor *general = jlt_descriptor_sibling(system->instance->descriptor, NULL, NULL, NULL);
    double period[JLT_CHART_STATES_MAX];

    set_periods(period, system, general);
    for (unsigned s = 0; s < general->state_count; s++) {
        const double proved = general->states[s].period, typed = ldexp(period[s], system->flow.units.state[s]);
        if (proved == 0 || typed == 0 || fabs(typed - proved) <= 1e-14 * proved) continue;
        return jlt_command_fail(JLT_EXIT_INPUT,
                                "--modulo: certificates count the turns of %s in the period of %s, which is %.17g, not %.17g: "
                                "leave it out",
                                general->states[s].name, general->model, proved, typed);
    }
    return JLT_EXIT_DONE;
}

jlt_status jlt_certify_cycle_find(double *x, double *T, int *turns, unsigned *legs, double *near_one, const jlt_system *system,
                                  const double *q, size_t period)
{
    const jlt_flow *flow = &system->flow;
    const jlt_chart *chart = flow->chart;
    /* a field in another time may have more states, which come after these */
    const jlt_descriptor *general = jlt_descriptor_sibling(system->instance->descriptor, NULL, NULL, NULL);
    const unsigned states = general->state_count;
    double end[JLT_CHART_STATES_MAX], period_of[JLT_CHART_STATES_MAX];
    jlt_periodic orbit = { 0 };
    jlt_map *map = NULL;
    jlt_image image;
    jlt_status st;

    set_periods(period_of, system, general);
    JLT_TRY(jlt_map_create(&map, flow));
    JLT_TRY(jlt_periodic_find(map, &orbit, q, period, NULL));
    for (size_t i = 0; i < orbit.period; i++) {
        double *next = x + (i + 1) % orbit.period * states;
        JLT_TRY(jlt_map_point(map, &image, orbit.points + i * chart->dim, 1, 1));
        T[i] = image.T;
        memcpy(next, image.x, states * sizeof *x);
        JLT_TRY(chart->lift(chart, end, NULL, orbit.points + i * chart->dim));
        JLT_TRY(follow(end, flow, T[i]));
        JLT_TRY(chart->lift(chart, image.x, NULL, orbit.points + (i + 1) % orbit.period * chart->dim));
        for (unsigned s = 0; s < states; s++) {
            turns[i * states + s] = period_of[s] != 0 ? (int)lrint((end[s] - image.x[s]) / period_of[s]) : 0;
            if (turns[i * states + s] != 0) next[s] = ldexp(image.x[s], flow->units.state[s]);
        }
    }
    *legs = (unsigned)orbit.period;
    *near_one = INFINITY;
    for (unsigned i = 0; i < chart->dim; i++) *near_one = fmin(*near_one, hypot(orbit.re[i] - 1, orbit.im[i]));
done:
    jlt_map_destroy(map);
    return st;
}
