/* A level of Jellett's integral with one rotation eliminated: omega_n = (G + I3 b omega3)/(I1 R s) loses digits near the poles
 * (test_pole_passages.c), omega3 = (I1 R s omega_n - G)/(I3 b) near b = a3 + R gamma3 = 0, through which every orbit of the regular
 * grid goes twice a return. The level's own states, with v_tau in place of both, divide by neither.
 * Oracle: grid_regular_51.csv, quadruple precision. */
#include "ride.h"
#include "table.h"

#include "reference/csv.h"

enum { ORBITS = 64, ROWS = ORBITS * 11, COLUMNS = 7 };

static double rows[ROWS][COLUMNS]; /* orbit, return, t, gamma3, v_nu, omega_n, omega3 */

typedef struct {
    double error, drift, least; /* of the first return; the least |b| at step ends */
    size_t steps;
    int failed;
} crossing;

static int note_least(void *context, jlt_orbit *orbit)
{
    double *least = context;
    *least = fmin(*least, fabs(top_51.a3 + jlt_orbit_stepper(orbit)->x[0]));
    return 0;
}

static crossing cross(const char *tier, const jlt_method *method, double tolerance)
{
    const jlt_event upward = { .column = 2, .direction = JLT_RISING };
    crossing c = { .least = 1 };

    for (size_t i = 0; i < ORBITS; i++) {
        const double *from = rows[11 * i], *to = rows[11 * i + 1];
        double x[JLT_TOP_STATES] = { from[3], from[4], 0, from[5], from[6] };
        jlt_outcome at;
        ride r;
        ride_open(&r, tier, &top_51, x, method, &(jlt_options){ .tolerance = tolerance, .max_steps = 20000 }, +1);
        jlt_orbit_observe(r.orbit, note_least, &c.least);
        const jlt_status st = jlt_orbit_next(r.orbit, 100, &upward, 1, &at);
        if (st == JLT_OK && at.end == JLT_END_EVENT) {
            ride_states(&r, x, at.x);
            const double off[] = { x[0] - to[3], x[1] - to[4], x[3] - to[5], x[4] - to[6], at.t - to[2] };
            for (int k = 0; k < 5; k++)
                if (!(fabs(off[k]) <= c.error)) c.error = fabs(off[k]);
            c.drift = fmax(c.drift, ride_drift(&r));
        } else {
            assert_true(st != JLT_OK);
            c.failed++;
        }
        c.steps += jlt_orbit_stepper(r.orbit)->steps + jlt_orbit_stepper(r.orbit)->rejected;
        ride_close(&r);
    }
    return c;
}

/* A return amplifies by less than ten; a step adds at most the tolerance. A return in the level errs by about the tolerance, in the
 * chart that divides by b by far more, or it fails. */
static void the_level_keeps_its_digits_through_b_0_and_a_single_chart_shows_its_loss_in_the_energy(void **state)
{
    static const char *const tiers[] = { "level", "level_plain", "level_omega_n", "level_omega3" };
    const double tolerance = 1e-13;
    double by_level[8] = { 0 }; /* errors of the level, by method */

    for (size_t i = 0; i < 4; i++)
        for (size_t m = 0; jlt_method_at(m) != NULL; m++) {
            const char *name = jlt_method_at(m)->name;
            const crossing c = cross(tiers[i], jlt_method_at(m), tolerance);
            table_row(*state, "%s,%s,%g,%.3e,%.3e,%.1f,%d,%.1e", tiers[i], name, tolerance, c.error, c.drift,
                      (double)c.steps / ORBITS, c.failed, c.least);
            print_message("%-13s %-8s error %.1e, drift of E %.1e, %.0f steps a return, %d fail, least |b| %.0e\n", tiers[i], name,
                          c.error, c.drift, (double)c.steps / ORBITS, c.failed, c.least);
            if (i == 0) by_level[m] = c.error;
            if (i < 3) {
                assert_int_equal(c.failed, 0);
                assert_below(c.error, 10 * (double)c.steps / ORBITS * tolerance);
            } else {
                assert_true(c.error > 100 * by_level[m] || c.failed > 0);
                assert_true(c.drift > 1e-3 * c.error);
            }
        }
}

/* b = 0 to the last bit, and to either side of it. The chart by omega3 has no field there and says so, or none to speak of. */
static void a_start_on_b_0_is_like_any_other_but_in_the_chart_that_divides_by_it(void **unused)
{
    const double starts[] = { -0.51, nextafter(-0.51, 0), nextafter(-0.51, -1), -0.51 + 1e-12 };
    double expected[JLT_TOP_STATES], y[RIDE_COLUMNS];

    (void)unused;
    for (size_t i = 0; i < 4; i++) {
        const double x[JLT_TOP_STATES] = { starts[i], 0.3, 0.5, -2, 1.2 };
        const char *const tiers[] = { "five", "level", "level_omega_n" };
        for (size_t k = 0; k < 3; k++) {
            double here[JLT_TOP_STATES];
            ride r;
            ride_open(&r, tiers[k], &top_51, x, jlt_method_find(k == 0 ? "gauss" : "dop853"), &(jlt_options){ .tolerance = 1e-13 },
                      +1);
            assert_ok(jlt_orbit_propagate(r.orbit, 1, y));
            ride_states(&r, here, y);
            for (int j = 0; j < JLT_TOP_STATES; j++) {
                if (k == 0) expected[j] = here[j];
                assert_near(here[j], expected[j], 1e-11); /* a hundred steps of 1e-13 */
            }
            ride_close(&r);
        }
    }

    const double x[JLT_TOP_STATES] = { -0.51, 0.3, 0.5, -2, 1.2 };
    jlt_tier_view view;
    assert_int_equal(ride_look(&view, y, "level_omega3", &top_51, x), JLT_ERR_UNSUPPORTED);
}

static int prepare(void **state)
{
    *state = table_open("elimination_charts", "form,method,tolerance,error,drift,steps,failed,least_b");
    return csv_read(&rows[0][0], ROWS, COLUMNS, "grid_regular_51.csv") == ROWS ? 0 : -1;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_level_keeps_its_digits_through_b_0_and_a_single_chart_shows_its_loss_in_the_energy),
        cmocka_unit_test(a_start_on_b_0_is_like_any_other_but_in_the_chart_that_divides_by_it),
    };
    return cmocka_run_group_tests(tests, prepare, table_close);
}
