/* The drift of test_energy_drift.c over 10^5 returns by every method, and over 10^6 by batches, free and projected onto the levels
 * (JLT_RETURNS in the environment: so many projected ones instead). */
#include "drift.h"

#include "integrate/batch.h"
#include "kernel/batch_isa.h"
#include "scene/conserved.h"

enum { RETURNS = 100000, BATCH_RETURNS = 1000000 };

/* As there. The slope tells the systematic from the random: 1 where every step errs to the same side, 1/2 where not. Linear growth that
 * begins late, as where an orbit has to leave the saddle first, shows as up to four times the ratio of the returns. */
static void over_a_hundred_thousand_returns_the_drift_is_linear_at_most(void **state)
{
    for (size_t i = 0; i < DRIFT_RUNS; i++)
        for (int orbit = 0; orbit < DRIFT_ORBITS; orbit++) {
            const drift_run *run = &drift_runs[i];
            const size_t returns = strcmp(run->method, "rkf45") == 0 || strcmp(run->method, "msadams") == 0 ? RETURNS / 10 : RETURNS;
            const drift_result d = drift_follow(run, orbit, returns, *state);
            print_message("%-8s %-5s %-9s %g: %.1e, slope %.2f, %.0f steps a return\n", drift_orbits[orbit].name, run->tier, run->name,
                          run->tolerance, d.last, d.slope, d.steps);
            assert_below(d.last, 5 * run->tolerance * (run->project ? 1 : (double)returns * d.steps));
            assert_below(d.slope, 1 + log10(4) / 2);
        }
}

typedef struct {
    jlt_chart_top chart;
    double worst[DRIFT_ORBITS], early[DRIFT_ORBITS], E[DRIFT_ORBITS];
    size_t returns;
    const char *name;
    FILE *table;
} batch_watch;

static int watch_row(void *context, size_t orbit, size_t number, const double *x)
{
    batch_watch *w = context;
    w->worst[orbit] = fmax(w->worst[orbit], fabs(jlt_chart_top_energy(&w->chart, x) - w->E[orbit]) / w->E[orbit]);
    if (number == w->returns / 100) w->early[orbit] = w->worst[orbit];
    size_t leading = number;
    while (leading % 10 == 0) leading /= 10;
    if (leading == 1 || leading == 2 || leading == 5)
        table_row(w->table, "%s,level,%s,1e-12,%zu,%.3e", drift_orbits[orbit].name, w->name, number, w->worst[orbit]);
    return 0;
}

static int watch_end(void *context, size_t orbit, jlt_lane_end end, size_t returns, const double *x)
{
    (void)context, (void)orbit, (void)returns, (void)x;
    assert_int_equal(end, JLT_LANE_DONE);
    return 0;
}

/* worst and early of all orbits, at tolerance 1e-12; steps: of one orbit. */
static void follow_batch(batch_watch *w, bool project, double *steps)
{
    const double params[] = { 1, 1, 1, 1.0 / 3, 1.0 / 3, 0.51, -0.56 };
    const jlt_descriptor *d = jlt_descriptor_find("spherical_top_level", NULL, "regular", NULL);
    double starts[DRIFT_ORBITS][5];
    jlt_instance *instance = NULL;
    jlt_conserved conserved;
    jlt_invariants invariants;
    jlt_batch_work work;

    jlt_chart_top_init(&w->chart, 1, 1, 1, 1.0 / 3, 1.0 / 3, 0.51, 2.15, -0.56);
    for (int i = 0; i < DRIFT_ORBITS; i++) {
        assert_ok(w->chart.base.lift(&w->chart.base, starts[i], NULL, drift_orbits[i].q));
        w->E[i] = jlt_chart_top_energy(&w->chart, starts[i]);
    }
    assert_ok(jlt_instance_create(&instance, d, params));
    assert_ok(jlt_conserved_of(&invariants, &conserved, d, &(jlt_field){ .p = instance->block, .dim = 5, .root = 4 }));
    const jlt_batch_map map = { .kernels = jlt_batch_isa_best(d, 0), .p = instance->block, .dim = 5, .column = 2, .direction = 1,
                                .root = 4, .root_floor = 1e-10, .tolerance = 1e-12, .max_steps = SIZE_MAX,
                                .project = project ? &invariants : NULL };
    assert_ok(jlt_batch_section(&map, starts[0], DRIFT_ORBITS, w->returns, watch_row, watch_end, w, &work));
    *steps = (double)work.steps / DRIFT_ORBITS;
    jlt_instance_destroy(instance);
}

static void a_million_batched_returns_drift_no_faster(void **state)
{
    batch_watch w = { .returns = BATCH_RETURNS, .name = "batch", .table = *state };
    double steps;

    follow_batch(&w, false, &steps);
    for (int i = 0; i < DRIFT_ORBITS; i++) {
        const double slope = log10(w.worst[i] / w.early[i]) / 2;
        print_message("%-8s batch, %zu returns: %.1e, slope %.2f\n", drift_orbits[i].name, w.returns, w.worst[i], slope);
        assert_below(w.worst[i], 5e-12 * steps);
        assert_below(slope, 1 + log10(4) / 2);
    }
}

/* The energy is read at refined crossings, after up to one return from the levels: it is off by what the method errs in one, at
 * most 5 tolerances a step as above, however many returns there were. */
static void projected_batches_do_not_drift(void **state)
{
    const char *asked = getenv("JLT_RETURNS");
    batch_watch w = { .returns = asked != NULL ? strtoull(asked, NULL, 10) : BATCH_RETURNS, .name = "batch projected", .table = *state };
    double steps;

    follow_batch(&w, true, &steps);
    for (int i = 0; i < DRIFT_ORBITS; i++) {
        print_message("%-8s batch projected, %zu returns: %.1e after %zu, %.1e at the end\n", drift_orbits[i].name, w.returns,
                      w.early[i], w.returns / 100, w.worst[i]);
        assert_below(w.worst[i], 5e-12 * steps / (double)w.returns);
    }
}

static int prepare(void **state)
{
    *state = table_open("energy_drift_long", "orbit,form,method,tolerance,returns,drift");
    return 0;
}

static int finish(void **state)
{
    table_close(*state);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(over_a_hundred_thousand_returns_the_drift_is_linear_at_most),
        cmocka_unit_test(a_million_batched_returns_drift_no_faster),
        cmocka_unit_test(projected_batches_do_not_drift),
    };
    return cmocka_run_group_tests(tests, prepare, finish);
}
