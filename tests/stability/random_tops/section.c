/* Sections by every method, single and batched, and fates. */
#include "stability/random_tops/trial.h"

#include <math.h>
#include <string.h>

#include "dynamics/fates.h"
#include "dynamics/section_batch.h"
#include "kernel/batch_isa.h"

enum { RETURNS_MAX = 5, STEPS = 100000, MORE = 30 };
static const double on_section = 1e-13; /* in scale, however slowly the orbit crosses it */

static void row_of(double row[ROW_SIZE], const jlt_chart_top *chart, const double *x, double t)
{
    row[ROW_GAMMA3] = x[JLT_CHART_TOP_GAMMA3];
    row[ROW_V_NU] = x[JLT_CHART_TOP_V_NU];
    row[ROW_OMEGA_TAU] = x[JLT_CHART_TOP_OMEGA_TAU];
    row[ROW_V_TAU] = x[JLT_CHART_TOP_V_TAU];
    row[ROW_T] = t;
    jlt_chart_top_rotation(chart, &row[ROW_OMEGA_N], &row[ROW_OMEGA3], x);
}

/* An orbit that jellett ends at rest: it is where the oracle comes to rest, if not before long; or the oracle creeps on, slower
 * than a thousand tolerances. */
static void check_rest(trial *t, const family *f, const char *how, const double row[ROW_SIZE])
{
    oracle_question q = f->question;
    const double never = 1e300 * q.time_direction;
    family end;
    double limit[ROW_SIZE];

    q.times = &never;
    q.count = 1;
    family_follow(&end, t, &q, ORACLE_LEVEL_NOISE);
    memcpy(limit, row, sizeof limit);
    limit[ROW_T] = NAN; /* when an orbit is slow enough is for the method to say */
    if (end.truth.end == ORACLE_REST && end.ends) family_check(&end, t, how, 1, limit);
    else if (end.truth.end == ORACLE_REST || end.truth.least_pace < 1e3L * q.tolerance) sum.unsure++;
    else if (end.truth.end != ORACLE_BUDGET) trial_complain(t, "%s: at rest, and the oracle ends by %d", how, end.truth.end);
}

/* Row `number` of jellett's: is there such a row, and is it right? False: nothing more can be said of this orbit. */
static bool check(trial *t, const family *f, const char *how, int number, jlt_fate fate, const double row[ROW_SIZE])
{
    const int returns = f->truth.count;
    const bool at_end = fate == JLT_FATE_POLE_PLUS || fate == JLT_FATE_POLE_MINUS;
    const oracle_end end = fate == JLT_FATE_POLE_PLUS ? ORACLE_POLE_PLUS : ORACLE_POLE_MINUS;

    if (fate == JLT_FATE_EQUILIBRIUM) {
        check_rest(t, f, how, row);
        return false;
    }
    if (fate == JLT_FATE_BUDGET && number > f->certain && returns > f->certain) { /* slower than errors of the tolerance */
        sum.unsure++;
        return false;
    }
    const bool known = number <= f->certain + f->ends, chaotic = known && 3 * f->stray[number] > 1e-3L;
    if (chaotic && (at_end || number > f->certain) && fate <= JLT_FATE_POLE_MINUS) { /* shadows agree by chance */
        sum.unsure++;
        return false;
    }
    if (fate == JLT_FATE_LEFT_DOMAIN && family_may_lose_v_tau(f, t, number)) {
        sum.left++;
        return false;
    }
    if (fate != JLT_FATE_ALIVE && !at_end) {
        trial_complain(t, "%s, row %d: ends by %s, and the oracle has %d rows, then %d", how, number, jlt_section_fate_name(fate),
                       returns, f->truth.end);
        return false;
    }
    if (!at_end && number <= f->certain) return family_check(f, t, how, number, row);
    if (at_end && f->ends && f->truth.end == end && number == returns + 1) return family_check(f, t, how, number, row);
    if (number > f->certain && !f->ends) { /* shadows part ways here */
        sum.unsure++;
        return false;
    }
    trial_complain(t, "%s, row %d: %s, and the oracle has %d rows, then %d", how, number, jlt_section_fate_name(fate), returns,
                   f->truth.end);
    return false;
}

static void check_start(const trial *t, const jlt_system *system, const double *x)
{
    const jlt_top_values *v = &t->top;
    long double c = x[0], s = sqrtl((1 - c) * (1 + c)), b = v->a3 + v->R * c, K = v->I1 * v->R * v->R * s * s + v->I3 * b * b;
    const long double wn = (v->R * s * v->G + v->I3 * b * x[3]) / K, w3 = (v->I1 * v->R * s * x[3] - b * v->G) / K;
    const long double Theta = v->m * K + v->I1 * v->I3, C = v->m * K;
    const long double eta = atan2l(v->m * v->I1 * v->R * s * x[1], sqrtl(Theta * C) * (w3 + v->m * v->G * b / C));
    const long double E = (v->m * x[1] * x[1] + v->I1 * wn * wn + v->I3 * w3 * w3 + v->m * x[3] * x[3]) / 2
                          + v->m * v->g * v->a3 * c;
    /* W^2 is a difference of E, gravity and rotation: rounded in these, relative to W^2. */
    const long double W2 = x[1] * x[1] + Theta / C * x[3] * x[3], parts = fabsl(v->E) + v->m * v->g * fabs(v->a3) + v->G * v->G / K;
    const long double size = v->m * W2 + parts, cancelled = fabsl(v->m * v->G * b / C) + fabsl(w3);
    const long double digits = 1e-14L * (1 + cancelled * Theta / (sqrtl(W2) * v->I1 * v->R * s * v->m));
    if (system == NULL || fabsl(E - v->E) > 1e-14L * size) trial_complain(t, "start: E is off by %.3Lg", E - v->E);
    else if (fabsl(sinl((eta - t->q[0]) / 2)) > digits)
        trial_complain(t, "start: eta is off by %.3Lg, digits %.3Lg", eta - t->q[0], digits);
}

/* An orbit whose steps are spent is followed again with more: they were needed when it then ends as it should. */
static void single(trial *t, const jlt_system *system, const family *f, const char *how, int returns, size_t max_steps)
{
    jlt_flow flow = system->flow;
    jlt_section *section = NULL;
    jlt_fates_end end;
    jlt_return at;
    double row[ROW_SIZE];
    bool goes_on = true;

    flow.max_steps = max_steps;
    jlt_status st = jlt_section_create(&section, &flow);
    if (st == JLT_OK) st = jlt_section_start(section, &at, t->q, f->question.time_direction);
    while (st == JLT_OK && at.fate == JLT_FATE_ALIVE && (int)at.number < returns) {
        st = jlt_section_next(section, &at);
        row_of(row, jlt_system_top_chart(system), at.x, at.t);
        const bool known = st == JLT_OK && at.fate == JLT_FATE_ALIVE && goes_on && (int)at.number <= f->certain;
        if (known && fabs(at.residual) > on_section * t->speed / t->top.R)
            trial_complain(t, "%s, row %zu: off the section by %.3g", how, at.number, at.residual);
        const bool asked = (int)at.number <= f->certain + f->ends || (int)at.number > f->truth.count;
        const bool spent = st == JLT_OK && at.fate == JLT_FATE_BUDGET && max_steps == STEPS && asked;
        if (spent) {
            sum.spent++;
            single(t, system, f, how, returns, MORE * STEPS);
        } else if (st == JLT_OK && goes_on) goes_on = check(t, f, how, (int)at.number, at.fate, row);
    }
    if (st == JLT_OK && f->question.time_direction > 0) {
        st = jlt_fates_follow(section, &end, t->q, (size_t)returns);
        if (st == JLT_OK && (end.fate != at.fate || end.t != at.t || memcmp(end.x, at.x, 5 * sizeof *at.x) != 0))
            trial_complain(t, "%s: fates ends by %s at t = %.17g, section by %s at %.17g", how, jlt_section_fate_name(end.fate),
                           end.t, jlt_section_fate_name(at.fate), at.t);
    }
    if (st != JLT_OK) trial_complain(t, "%s: %s", how, jlt_status_text(st));
    jlt_section_destroy(section);
}

static void batched(trial *t, const jlt_system *system, const family *f, int returns)
{
    enum { LANES = 9 };
    jlt_section_batch *batch = NULL;
    const bool project = jlt_random_below(&t->random, 3) == 0;
    const size_t mine = jlt_random_below(&t->random, LANES);
    const jlt_section_batch_options options = { .project = project ? system->instance : NULL };
    double q[LANES][2], row[ROW_SIZE];
    jlt_return at;

    for (size_t i = 0; i < LANES; i++) {
        q[i][0] = i == mine ? t->q[0] : 6 * jlt_random_unit(&t->random);
        q[i][1] = i == mine ? t->q[1] : 2 * jlt_random_unit(&t->random) - 1;
    }
    jlt_status st = jlt_section_batch_create(&batch, &system->flow, jlt_batch_isa_best(system->instance->descriptor, 0), &options);
    if (st == JLT_OK) st = jlt_section_batch_run(batch, q[0], LANES, (size_t)returns);
    if (st == JLT_OK) st = jlt_section_batch_start(batch, &at, mine);
    while (st == JLT_OK && at.fate == JLT_FATE_ALIVE && (int)at.number < returns) {
        st = jlt_section_batch_next(batch, &at);
        row_of(row, jlt_system_top_chart(system), at.x, at.t);
        if (st == JLT_OK && !check(t, f, project ? "batch, projected" : "batch", (int)at.number, at.fate, row)) break;
    }
    if (st != JLT_OK) trial_complain(t, "batch: %s", jlt_status_text(st));
    jlt_section_batch_destroy(batch);
}

void section_with_more_steps(trial *t, const family *f, const jlt_method *method, const char *how, int returns)
{
    const jlt_flow flow = { .method = method, .tolerance = t->tolerance, .direction = (jlt_direction)f->question.crossings };
    jlt_system *system = NULL;
    const jlt_status st = jlt_system_top(&system, &t->top, &flow);

    sum.spent++;
    if (st == JLT_OK) single(t, system, f, how, returns, MORE * STEPS);
    else trial_complain(t, "start: %s", jlt_status_text(st));
    jlt_system_destroy(system);
}

void case_section(trial *t)
{
    static const jlt_direction directions[] = { JLT_RISING, JLT_RISING, JLT_FALLING, JLT_BOTH };
    const int returns = 1 + (int)jlt_random_below(&t->random, RETURNS_MAX);
    jlt_flow flow = { .tolerance = t->tolerance, .direction = directions[jlt_random_below(&t->random, 4)] };
    jlt_system *system = NULL;
    double x[5];
    static family f;

    for (size_t m = 0; jlt_method_at(m) != NULL; m++) {
        flow.method = jlt_method_at(m);
        jlt_status st = jlt_system_top(&system, &t->top, &flow);
        if (st == JLT_OK) st = jlt_surface_chart(system)->base.lift(&jlt_surface_chart(system)->base, x, NULL, t->q);
        if (st != JLT_OK) {
            trial_complain(t, "start: %s", jlt_status_text(st));
            jlt_system_destroy(system);
            return;
        }
        if (m == 0) {
            const int back = jlt_random_below(&t->random, 4) == 0 ? -1 : 1;
            snprintf(t->options, sizeof t->options, " --direction %s --returns %d%s",
                     (const char *[]){ "down", "both", "up" }[flow.direction + 1], returns, back < 0 ? " --backward" : "");
            const oracle_question q = { .top = trial_top(t), .gamma3 = x[0], .v_nu = x[1], .level = true, .v_tau = x[3],
                                        .G = t->top.G, .time_direction = back, .crossings = (int)flow.direction,
                                        .count = returns, .tolerance = t->tolerance, .speed = t->speed };
            check_start(t, system, x);
            family_follow(&f, t, &q, ORACLE_LEVEL_NOISE);
            if (back > 0 && f.sound) batched(t, system, &f, returns);
        }
        if (f.sound) single(t, system, &f, flow.method->name, returns, STEPS);
        jlt_system_destroy(system);
        system = NULL;
    }
}
