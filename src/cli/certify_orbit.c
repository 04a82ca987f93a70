#include "cli/certify_orbit.h"

#include "dynamics/periodic.h"
#include "integrate/orbit.h"
#include "kernel/descriptor.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/* Move x, shape (the chart's states,), along the orbit for a time T; angles are not reduced by their periods. */
static jlt_status move_along(double *x, const jlt_flow *flow, double T)
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
    JLT_OWNED(jlt_map) *map = NULL;
    jlt_image image;

    set_periods(period_of, system, general);
    JLT_PASS(jlt_map_create(&map, flow));
    JLT_PASS(jlt_periodic_find(map, &orbit, q, period, NULL));
    for (size_t i = 0; i < orbit.period; i++) {
        double *next = x + (i + 1) % orbit.period * states;
        JLT_PASS(jlt_map_point(map, &image, orbit.points + i * chart->dim, 1, 1));
        T[i] = image.T;
        memcpy(next, image.x, states * sizeof *x);
        JLT_PASS(chart->lift(chart, end, NULL, orbit.points + i * chart->dim));
        JLT_PASS(move_along(end, flow, T[i]));
        JLT_PASS(chart->lift(chart, image.x, NULL, orbit.points + (i + 1) % orbit.period * chart->dim));
        for (unsigned s = 0; s < states; s++) {
            turns[i * states + s] = period_of[s] != 0 ? (int)lrint((end[s] - image.x[s]) / period_of[s]) : 0;
            if (turns[i * states + s] != 0) next[s] = ldexp(image.x[s], flow->units.state[s]);
        }
    }
    *legs = (unsigned)orbit.period;
    *near_one = INFINITY;
    for (unsigned i = 0; i < chart->dim; i++) *near_one = fmin(*near_one, hypot(orbit.re[i] - 1, orbit.im[i]));
    return JLT_OK;
}

enum { SAMPLES = 48, BISECTIONS = 60 };

typedef struct {
    const jlt_certify_search *search;
    const jlt_chart *chart;
    jlt_map *whole, *half; /* the return map of the section's direction; the map to the next crossing in either direction */
    unsigned flipped;      /* the state that the reversor flips, besides the section's */
    double direction[2], growth; /* unstable eigenvector of length 1, and its multiplier */
} chase;

/* Compute the unstable direction, of length 1 in units of the coordinates' sizes, and multiplier at the saddle. */
static jlt_status aim(chase *self)
{
    jlt_image image;
    double slope[4], half, root, b, a;

    JLT_PASS(jlt_map_apply(self->whole, &image, self->search->saddle, 1, 1));
    half = (image.slope[0] + image.slope[3]) / 2;
    root = sqrt(half * half - image.determinant);
    if (!(root > 0)) return JLT_ERR_NO_CONVERGENCE;
    self->growth = half < 0 ? half - root : half + root;
    jlt_chart_scaled_slope(self->chart, slope, image.slope);
    a = self->growth - slope[3];
    b = slope[2];
    if (fabs(a) + fabs(b) < 1e-9) a = slope[1], b = self->growth - slope[0];
    self->direction[0] = a / hypot(a, b);
    self->direction[1] = b / hypot(a, b);
    jlt_chart_unscaled(self->chart, self->direction, self->direction);
    return JLT_OK;
}

static void start_at(double q[2], const chase *self, double away)
{
    for (unsigned i = 0; i < 2; i++) q[i] = self->search->saddle[i] + away * self->direction[i];
}

/* The flipped state at the next crossing after q, in either direction, and the time until then. */
static jlt_status cross(double *value, double *T, const chase *self, const double q[2])
{
    jlt_image image;

    JLT_PASS(jlt_map_point(self->half, &image, q, 1, 1));
    *value = image.x[self->flipped];
    *T = image.T;
    return JLT_OK;
}

/* Follow the start at distance `away`. Out: *value, the flipped state at the crossing after the last return; x and T, unless NULL,
 * the points, in the table's units, and times on the way. */
static jlt_status follow(double *value, double *x, double *T, const chase *self, double away, unsigned returns)
{
    const unsigned states = self->search->states;
    double q[2], lifted[JLT_CHART_STATES_MAX], last;
    jlt_image image;

    start_at(q, self, away);
    for (unsigned i = 0; i <= returns; i++) {
        if (x != NULL) {
            JLT_PASS(self->chart->lift(self->chart, lifted, NULL, q));
            for (unsigned s = 0; s < states; s++) x[i * states + s] = ldexp(lifted[s], jlt_map_flow(self->whole)->units.state[s]);
        }
        if (i == returns) break;
        JLT_PASS(jlt_map_point(self->whole, &image, q, 1, 1));
        memcpy(q, image.q, sizeof q);
        if (T != NULL) T[i] = image.T;
    }
    return cross(value, T != NULL ? T + returns : &last, self, q);
}

/* Find the wanted pair of neighbouring starts, numbered from 1 in the order in which the signs of their flipped states first
 * differ. Out: the number of returns after which they do, and the distances of the pair. NO_CONVERGENCE: there are fewer pairs. */
static jlt_status scan(const chase *self, unsigned *returns, double *from, double *to)
{
    const double step = pow(fabs(self->growth), 2.0 / SAMPLES); /* over two returns, since a negative multiplier swaps the sides */
    double q[SAMPLES + 1][2], away[SAMPLES + 1];
    bool seen[SAMPLES + 1] = { false };
    unsigned count = 0;

    for (unsigned j = 0; j <= SAMPLES; j++) {
        away[j] = self->search->distance * pow(step, j);
        start_at(q[j], self, away[j]);
    }
    for (*returns = 0; *returns < JLT_CERTIFY_RETURNS_MAX; (*returns)++) {
        double before = NAN;
        for (unsigned j = 0; j <= SAMPLES; j++) {
            jlt_image image;
            double value, T;
            JLT_PASS(cross(&value, &T, self, q[j]));
            JLT_PASS(jlt_map_point(self->whole, &image, q[j], 1, 1));
            memcpy(q[j], image.q, sizeof q[j]);
            if (before * value < 0 && !seen[j]) {
                seen[j] = true;
                *from = away[j - 1];
                *to = away[j];
                if (++count == self->search->which) return JLT_OK;
            }
            before = value;
        }
    }
    return JLT_ERR_NO_CONVERGENCE;
}

static jlt_status find(chase *self, double *x, double *T, unsigned *legs)
{
    unsigned returns;
    double from, to, low;

    JLT_PASS(aim(self));
    JLT_PASS(scan(self, &returns, &from, &to));
    JLT_PASS(follow(&low, NULL, NULL, self, from, returns));
    for (unsigned i = 0; i < BISECTIONS; i++) {
        const double middle = (from + to) / 2;
        double value;
        JLT_PASS(follow(&value, NULL, NULL, self, middle, returns));
        if (value * low > 0) from = middle;
        else to = middle;
    }
    JLT_PASS(follow(&low, x, T, self, (from + to) / 2, returns));
    *legs = returns + 1;
    return JLT_OK;
}

jlt_status jlt_certify_homoclinic_find(double *x, double *T, unsigned *legs, const jlt_flow *flow, const jlt_certify_search *search)
{
    chase self = { .search = search, .chart = flow->chart };
    jlt_flow either = *flow;
    unsigned flipped = 0;
    jlt_status st = JLT_ERR_UNSUPPORTED;

    if (flow->chart->dim != 2) goto done;
    if (search->signs[flow->chart->column] > 0) goto done;
    for (unsigned i = 0; i < search->states; i++)
        if (search->signs[i] < 0 && i != flow->chart->column) self.flipped = i, flipped++;
    if (flipped != 1) goto done;
    either.direction = JLT_BOTH;
    JLT_TRY(jlt_map_create(&self.whole, flow));
    JLT_TRY(jlt_map_create(&self.half, &either));
    st = find(&self, x, T, legs);
done:
    jlt_map_destroy(self.whole);
    jlt_map_destroy(self.half);
    return st;
}
