/* The drift of test_energy_drift.c over 10^5 returns by every method, and over 10^6 by batches, free and projected onto the levels
 * (JLT_RETURNS in the environment: so many projected ones instead). */
#include "drift_batch.h"

enum { RETURNS = 100000, BATCH_RETURNS = 1000000 };

/* As there. The slope tells the systematic from the random: 1 where every step errs to the same side, 1/2 where not. Linear growth
 * that begins late, as where an orbit has to leave the saddle first, shows as up to four times the ratio of the returns. */
static void over_a_hundred_thousand_returns_the_drift_is_linear_at_most(void **state)
{
    for (size_t i = 0; i < DRIFT_RUNS; i++)
        for (int orbit = 0; orbit < DRIFT_ORBITS; orbit++) {
            const drift_run *run = &drift_runs[i];
            const size_t returns = strcmp(run->method, "rkf45") == 0 || strcmp(run->method, "msadams") == 0 ? RETURNS / 10
                                                                                                            : RETURNS;
            const drift_result d = drift_follow(run, orbit, returns, *state);
            print_message("%-8s %-5s %-9s %g: %.1e, slope %.2f, %.0f steps a return\n", drift_orbits[orbit].name, run->tier,
                          run->name, run->tolerance, d.last, d.slope, d.steps);
            assert_below(d.last, drift_bound(run, returns));
            assert_below(d.slope, 1 + log10(4) / 2);
        }
}

static void a_million_batched_returns_drift_no_faster(void **state)
{
    drift_batch w = { .returns = BATCH_RETURNS, .name = "batch", .table = *state };

    drift_batch_follow(&w, false);
    for (int i = 0; i < DRIFT_ORBITS; i++) {
        const double slope = log10(w.worst[i] / w.early[i]) / 2;
        print_message("%-8s batch, %zu returns: %.1e, slope %.2f\n", drift_orbits[i].name, w.returns, w.worst[i], slope);
        assert_below(w.worst[i], 0.1 * 1e-12 * (double)w.returns);
        assert_below(slope, 1 + log10(4) / 2);
    }
}

static void over_a_million_returns_projected_batches_do_not_drift(void **state)
{
    const char *asked = getenv("JLT_RETURNS");

    drift_batch_stays(asked != NULL ? strtoull(asked, NULL, 10) : BATCH_RETURNS, *state);
}

static int prepare(void **state)
{
    *state = table_open("energy_drift_long", "orbit,form,method,tolerance,returns,drift");
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(over_a_hundred_thousand_returns_the_drift_is_linear_at_most),
        cmocka_unit_test(a_million_batched_returns_drift_no_faster),
        cmocka_unit_test(over_a_million_returns_projected_batches_do_not_drift),
    };
    return cmocka_run_group_tests(tests, prepare, table_close);
}
