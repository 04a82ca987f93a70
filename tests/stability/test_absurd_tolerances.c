/* Tolerances that nobody can keep, and those that ask for nothing: below rounding a run is as good as rounding allows or ends by
 * name, and down to 1e-16 it does not end; at 0.5 what is wrong by more than the orbit's size shows in a drift of E.
 * Oracle: grid_regular_51.csv, quadruple precision. */
#include "ride.h"

#include "reference/csv.h"

enum { ROWS = 11, COLUMNS = 7, BUDGET = 200000 };

static void runs_are_right_or_end_by_name_or_drift(void **unused)
{
    static const double tolerances[] = { 1e-15, 1e-16, 1e-18, 1e-20, 1e-30, 1e-100, 1e-300, 0.5, 0.9 };
    static double rows[ROWS][COLUMNS]; /* orbit, return, t, gamma3, v_nu, omega_n, omega3 */
    const jlt_event upward = { .column = 2, .direction = JLT_RISING };

    (void)unused;
    assert_int_equal(csv_read(&rows[0][0], ROWS, COLUMNS, "grid_regular_51.csv"), ROWS);
    for (size_t m = 0; jlt_method_at(m) != NULL; m++)
        for (size_t k = 0; k < sizeof tolerances / sizeof *tolerances; k++) {
            double x[JLT_TOP_STATES] = { rows[0][3], rows[0][4], 0, rows[0][5], rows[0][6] }, error = 0;
            jlt_status st = JLT_OK;
            jlt_outcome at;
            int made = 0;
            ride r;
            ride_open(&r, "level", &top_51, x, jlt_method_at(m), &(jlt_options){ .tolerance = tolerances[k], .max_steps = BUDGET },
                      +1);
            while (made + 1 < ROWS && st == JLT_OK) {
                st = jlt_orbit_next(r.orbit, 1000, &upward, 1, &at);
                if (st != JLT_OK || at.end != JLT_END_EVENT) break;
                made++;
                error = fmax(error, fabs(at.t - rows[made][2]));
            }
            const bool complete = st == JLT_OK && made + 1 == ROWS;
            if (tolerances[k] >= 1e-16 && tolerances[k] < 0.1) assert_true(complete); /* 2^-53 is something to go by */
            if (tolerances[k] < 0.1) {
                assert_true(complete || st == JLT_ERR_BUDGET || st == JLT_ERR_NO_PROGRESS);
                /* a rounding in each of at most 1e6 steps, at random, amplified by less than a hundred */
                assert_below(error, 1e-11);
            } else {
                assert_true(made > 0);
            }
            if (tolerances[k] > 0.1 && (error > 1 || !complete)) {
                assert_true(st != JLT_OK || ride_drift(&r) > 1e-2);
            }
            ride_close(&r);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(runs_are_right_or_end_by_name_or_drift) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
