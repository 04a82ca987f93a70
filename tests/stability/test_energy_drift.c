/* Drift of E (and of G where it is not the level itself) by every method over a thousand returns; test_energy_drift_slow.c goes
 * further. */
#include "drift_batch.h"

enum { RETURNS = 1000, BATCH_RETURNS = 20000 };

/* The drift is noted before a projection, so that what a single step adds is seen there, and no more however many there were. */
static void integrals_drift_by_less_than_the_steps_allow(void **state)
{
    for (size_t i = 0; i < DRIFT_RUNS; i++)
        for (int orbit = 0; orbit < DRIFT_ORBITS; orbit++) {
            const drift_run *run = &drift_runs[i];
            const drift_result d = drift_follow(run, orbit, RETURNS, *state);
            print_message("%-8s %-5s %-9s %g: %.1e, slope %.2f, %.0f steps a return\n", drift_orbits[orbit].name, run->tier,
                          run->name, run->tolerance, d.last, d.slope, d.steps);
            assert_below(d.last, drift_bound(run, RETURNS));
        }
}

/* Without projection it would be 2e-9 here, twelve times what is allowed. */
static void projected_batches_do_not_drift(void **state)
{
    drift_batch_stays(BATCH_RETURNS, *state);
}

static int prepare(void **state)
{
    *state = table_open("energy_drift", "orbit,form,method,tolerance,returns,drift");
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(integrals_drift_by_less_than_the_steps_allow),
        cmocka_unit_test(projected_batches_do_not_drift),
    };
    return cmocka_run_group_tests(tests, prepare, table_close);
}
