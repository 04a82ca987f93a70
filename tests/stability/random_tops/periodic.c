/* Periodic orbits found from random starts, and followed in a value: the oracle closes them. */
#include "stability/random_tops/trial.h"

#include <math.h>
#include <string.h>

#include "dynamics/continuation.h"

enum { POINTS = 4 };

static void row_of(double row[ROW_SIZE], const jlt_chart_top *chart, const double *x, double T)
{
    row[ROW_GAMMA3] = x[JLT_CHART_TOP_GAMMA3];
    row[ROW_V_NU] = x[JLT_CHART_TOP_V_NU];
    row[ROW_OMEGA_TAU] = 0;
    row[ROW_V_TAU] = x[JLT_CHART_TOP_V_TAU];
    row[ROW_T] = T;
    jlt_chart_top_rotation(chart, &row[ROW_OMEGA_N], &row[ROW_OMEGA3], x);
}

/* What the residual, and ten tolerances of the return that it is measured by, all in eta and gamma3, make of the states: much where
 * little energy is left for velocities, and beside a pole, where a spin follows from gamma3 divided by s^2. */
static long double slack_of(const family *f, const jlt_chart_top *chart, const jlt_periodic *orbit, const double *row)
{
    const double off = 2 * orbit->residual + 10 * f->question.tolerance;
    const double U = f->question.speed, W = U / chart->R;
    const double scale[ROW_SIZE] = { 1, U, W, fmax(W, fabs(row[ROW_OMEGA_N])), fmax(W, fabs(row[ROW_OMEGA3])), U, 1 / W };
    double x[5], other[ROW_SIZE], worst = 0;

    for (int k = 0; k < 4; k++) {
        double q[2] = { orbit->points[0], orbit->points[1] };
        q[k / 2] += k % 2 == 0 ? off : -off;
        if (chart->base.lift(&chart->base, x, NULL, q) != JLT_OK) return INFINITY;
        row_of(other, chart, x, orbit->T);
        for (int i = 0; i < ROW_SIZE; i++) worst = fmax(worst, fabs(other[i] - row[i]) / scale[i]);
    }
    return 2 * worst;
}

/* From the first point the oracle comes back to it, after T. */
static bool check(const trial *t, const jlt_top_values *values, const jlt_periodic *orbit, const char *how)
{
    trial here = *t;
    jlt_chart_top chart;
    double x[5], row[ROW_SIZE];
    static family f;

    here.top = *values;
    jlt_chart_top_init(&chart, values->m, values->R, values->g, values->I1, values->I3, values->a3, values->E, values->G);
    if (orbit->period > ORACLE_ROWS_MAX || chart.base.lift(&chart.base, x, NULL, orbit->points) != JLT_OK) return true;
    memcpy(here.q, orbit->points, sizeof here.q);
    const oracle_question q = { .top = trial_top(&here), .gamma3 = x[0], .v_nu = x[1], .level = true, .v_tau = x[3],
                                .G = values->G, .time_direction = 1, .crossings = 1, .count = (int)orbit->period,
                                .tolerance = t->tolerance, .speed = t->speed };
    family_follow(&f, &here, &q, ORACLE_LEVEL_NOISE);
    if (!f.sound) return true;
    if (f.certain < (int)orbit->period) {
        sum.unsure++;
        return true;
    }
    row_of(row, &chart, x, orbit->T);
    f.slack = slack_of(&f, &chart, orbit, row);
    return family_check(&f, &here, how, (int)orbit->period, row);
}

typedef struct {
    const trial *t;
    const jlt_top_family *tops;
    size_t left;
} follower;

static jlt_status take(void *context, const jlt_continuation_point *point)
{
    follower *self = context;
    jlt_top_values values = self->tops->values;

    *jlt_system_top_value(&values, self->tops->name) = point->value;
    return check(self->t, &values, &point->orbit, "continue") && self->left-- > 1 ? JLT_OK : JLT_ERR_EMPTY;
}

static void follow(trial *t, const jlt_periodic *orbit, const jlt_flow *flow)
{
    const char *name = (const char *[]){ "E", "G", "a3", "I3" }[jlt_random_below(&t->random, 4)];
    jlt_top_family tops = { .values = t->top, .name = name, .options = *flow };
    jlt_system_family maps = { .make = jlt_system_top_at, .context = &tops };
    const double value = *jlt_system_top_value(&tops.values, name), scale = fabs(value);
    const jlt_continuation_options options = {
        .scale = scale, .low = value - scale / 2, .high = value + scale / 2, .points_max = POINTS
    };
    const jlt_continuation_point start = { .value = value, .orbit = *orbit };
    follower to = { t, &tops, POINTS };
    const jlt_family runs = { jlt_system_map_at, &maps, jlt_system_map_near };
    jlt_continuation_end end;

    if (scale > 0) (void)!jlt_continuation_run(&end, &runs, &start, 1, &options, take, &to);
    jlt_system_family_clear(&maps);
}

void case_periodic(trial *t)
{
    const jlt_flow flow = { .tolerance = t->tolerance = 1e-11, .direction = JLT_RISING };
    const size_t period = 1 + jlt_random_below(&t->random, 2);
    static jlt_periodic orbit;
    jlt_system *system = NULL;
    jlt_map *map = NULL;
    jlt_image image;

    jlt_status st = jlt_system_top(&system, &t->top, &flow);
    if (st == JLT_OK) st = jlt_map_create(&map, &system->flow);
    snprintf(t->options, sizeof t->options, " --period %zu", period);
    if (st != JLT_OK) trial_complain(t, "map: %s", jlt_status_text(st));
    /* Newton from where an orbit is after some returns, for twelve starts at most. */
    for (int k = 0; st == JLT_OK && k < 12; k++) {
        double q[2] = { jlt_random_below(&t->random, 2) == 0 ? 0 : 6.28 * jlt_random_unit(&t->random),
                        k == 0 ? t->q[1] : 2 * jlt_random_unit(&t->random) - 1 };
        if (jlt_map_point(map, &image, q, 3, 1) == JLT_OK) memcpy(q, image.q, sizeof q);
        if (jlt_periodic_find(map, &orbit, q, period, NULL) != JLT_OK) continue;
        if (check(t, &t->top, &orbit, "orbits")) follow(t, &orbit, &flow);
        break;
    }
    jlt_map_destroy(map);
    jlt_system_destroy(system);
}
