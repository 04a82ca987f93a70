/* Orbits that graze the pole gamma3 = +1 (1 - gamma3 down to 1e-11): with s lifted, in regularised time, nothing is lost. */
#include "unit/check.h"

#include "integrate/orbit.h"
#include "kernel/descriptor.h"
#include "reference/csv.h"
#include "reference/spherical_top.h"

enum { ORBITS = 64, RETURNS = 10, ROWS = ORBITS * (RETURNS + 1), COLUMNS = 7, BLOCK = 512 };
static const double params[6] = { 1, 1, 1, 0.51, 1.0 / 3, 1.0 / 3 }; /* m, R, g, a3, I1, I3 */
static const double by_hand[6] = { 1, 1, 1, 1.0 / 3, 1.0 / 3, 0.51 };

/* Largest error in states over all returns of the grid, and the evaluations it took. */
static double grid_error(const char *method, const jlt_field *field, double tolerance, size_t *evaluations)
{
    static double rows[ROWS * COLUMNS]; /* orbit, return, t, gamma3, v_nu, omega_n, omega3 */
    const jlt_event upward = { .column = 2, .direction = JLT_RISING };
    jlt_orbit *orbit = NULL;
    double worst = 0;

    assert_int_equal(csv_read(rows, ROWS, COLUMNS, "grid_grazing_51.csv"), ROWS);
    assert_ok(jlt_orbit_create(&orbit, jlt_method_find(method), field, &(jlt_options){ .tolerance = tolerance }));
    for (size_t i = 0; i < ROWS; i++) {
        const double *row = rows + i * COLUMNS;
        if (row[1] < 0.5) {
            const double x[6] = { row[3], row[4], 0, row[5], row[6], sqrt((1 - row[3]) * (1 + row[3])) };
            assert_ok(jlt_orbit_start(orbit, 0, x, +1));
            continue;
        }
        jlt_outcome at;
        assert_ok(jlt_orbit_next(orbit, INFINITY, &upward, 1, &at));
        assert_int_equal(at.end, JLT_END_EVENT);
        const double expected[5] = { row[3], row[4], 0, row[5], row[6] };
        for (unsigned k = 0; k < 5; k++) worst = fmax(worst, fabs(at.x[k] - expected[k]));
        worst = fmax(worst, fabs(at.t - row[2]));
    }
    *evaluations = jlt_orbit_stepper(orbit)->evaluations;
    jlt_orbit_destroy(orbit);
    return worst;
}

/* 1e-12 is asked of the best tolerance; on the way the error stays below 100 tolerances, the amplification of ten returns. */
static void grazing_orbits_keep_twelve_digits_by_every_high_order_method(void **unused)
{
    (void)unused;
    const char *const methods[] = { "dop853", "gauss", "taylor", "rk8pd" };
    const jlt_descriptor *descriptor = jlt_descriptor_find("spherical_top", NULL, "regular", NULL);
    _Alignas(64) double block[BLOCK];
    jlt_field field;
    size_t evaluations;

    assert_non_null(descriptor);
    assert_true(descriptor->block_count <= BLOCK);
    descriptor->prepare(params, block);
    assert_ok(jlt_field_of(&field, descriptor, block));
    assert_int_equal(field.root, 5);
    for (size_t m = 0; m < 4; m++) {
        assert_below(grid_error(methods[m], &field, 1e-15, &evaluations), 1e-12);
        assert_below(grid_error(methods[m], &field, 1e-10, &evaluations), 1e-7);
    }
}

/* The same by a field written by hand: what is measured is the integrator, not the kernel. */
static void grazing_orbits_cost_no_more_than_regular_ones(void **unused)
{
    (void)unused;
    const jlt_field field = { .dim = 6, .call = top_regular, .p = by_hand, .time_rate = top_time_rate, .root = 5 };
    size_t evaluations;
    assert_below(grid_error("dop853", &field, 1e-14, &evaluations), 1e-12);
    assert_below((double)evaluations / (ORBITS * RETURNS), 2000); /* a regular orbit takes 1440 a return at 1e-14 */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(grazing_orbits_keep_twelve_digits_by_every_high_order_method),
        cmocka_unit_test(grazing_orbits_cost_no_more_than_regular_ones),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
