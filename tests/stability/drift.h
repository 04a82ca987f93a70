/* Measures the drift of the integrals over many returns, on a regular orbit of (5.1), on a chaotic one, and on one near a
 * saddle. */
#ifndef JLT_TESTS_DRIFT_H
#define JLT_TESTS_DRIFT_H

#include "ride.h"
#include "table.h"
#include "witness/chart_top.h"

#include "dynamics/system.h"

enum { DRIFT_ORBITS = 3 };

static const struct {
    const char *name;
    double q[2]; /* eta, gamma3 */
} drift_orbits[DRIFT_ORBITS] = { { "regular", { 0.44, -0.62 } }, { "chaotic", { 0.02, -0.61 } },
                                 { "saddle", { 1e-6, -0.61358438970663813576 } } };

typedef struct {
    const char *name, *tier, *method;
    double tolerance;
    bool project;
} drift_run;

static const drift_run drift_runs[] = {
    { "dop853", "level", "dop853", 1e-12, false },
    { "dop853", "five", "dop853", 1e-12, false },
    { "projected", "five", "dop853", 1e-12, true },
    { "gauss", "level", "gauss", 1e-12, false },
    { "taylor", "level", "taylor", 1e-12, false },
    { "rk8pd", "level", "rk8pd", 1e-12, false },
    { "rkf45", "level", "rkf45", 1e-12, false },
    { "msadams", "level", "msadams", 1e-12, false },
    { "dop853", "level", "dop853", 1e-14, false },
    { "gauss", "level", "gauss", 1e-14, false },
    { "taylor", "level", "taylor", 1e-14, false },
    { "rk8pd", "level", "rk8pd", 1e-14, false },
};
enum { DRIFT_RUNS = sizeof drift_runs / sizeof *drift_runs };

/* A bound on the drift of E. The error of ten returns is about one tolerance (test_equal_tolerances.c), that of one about a tenth;
 * a return at least doubles the error of the last, which makes up for |grad E| < 5. So a return adds at most a tenth of the
 * tolerance, and random rounding errors of 2^-53 in each of its 200 steps. With projection only one step counts: it adds at most
 * its share of the tolerance to each state, and five times that to E. */
static inline double drift_bound(const drift_run *run, size_t returns)
{
    const double n = (double)returns;
    if (run->project) return 5 * run->tolerance * jlt_method_find(run->method)->share + 5 * 0x1p-52;
    return 0.1 * run->tolerance * n + 5 * 0x1p-53 * sqrt(200 * n);
}

/* The five reduced states at (eta, gamma3). */
static inline void drift_start(double *x, const double *q)
{
    jlt_chart_top chart;
    double y[JLT_CHART_TOP_S + 1];

    jlt_chart_top_init(&chart, 1, 1, 1, 1.0 / 3, 1.0 / 3, 0.51, 2.15, -0.56);
    assert_ok(chart.base.lift(&chart.base, y, NULL, q));
    for (int i = 0; i < 3; i++) x[i] = y[i];
    jlt_chart_top_rotation(&chart, &x[3], &x[4], y);
}

typedef struct {
    double last, slope; /* drift at the end; its growth over the last two decades of returns, as an exponent of their number */
    double steps;       /* steps for each return, rejected ones included */
} drift_result;

/* Follow one orbit, and write rows to the table after 1, 2, 5, 10, 20, 50, ... returns. */
static inline drift_result drift_follow(const drift_run *run, int orbit, size_t returns, FILE *table)
{
    const jlt_event upward = { .column = 2, .direction = JLT_RISING };
    double x[JLT_TOP_STATES], early = 0;
    jlt_options options = { .tolerance = run->tolerance, .project = run->project };
    drift_result d = { 0 };
    jlt_outcome at;
    ride r;

    drift_start(x, drift_orbits[orbit].q);
    ride_open(&r, run->tier, &top_51, x, jlt_method_find(run->method), &options, +1);
    for (size_t k = 1, mark = 1; k <= returns; k++) {
        assert_ok(jlt_orbit_next(r.orbit, INFINITY, &upward, 1, &at));
        assert_int_equal(at.end, JLT_END_EVENT);
        if (k != mark) continue;
        d.last = ride_drift(&r);
        if (k == returns / 100) early = d.last;
        table_row(table, "%s,%s,%s,%g,%zu,%.3e", drift_orbits[orbit].name, run->tier, run->name, run->tolerance, k, d.last);
        size_t leading = k;
        while (leading >= 10) leading /= 10;
        mark = leading == 2 ? k / 2 * 5 : 2 * k;
    }
    d.slope = log10(d.last / early) / 2;
    d.steps = (double)(jlt_orbit_stepper(r.orbit)->steps + jlt_orbit_stepper(r.orbit)->rejected) / (double)returns;
    ride_close(&r);
    return d;
}

#endif
