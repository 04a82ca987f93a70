/* Sections restricted to levels, on integrals that can be solved by hand. */
#include "unit/check.h"

#include "dynamics/chart_level.h"

enum { N = 5 };

/* States (x, y, z, phi, w) on the section x = 1/2: F0 = atan(y) + z^2, F1 = w^3 + phi + x. */
static void values(const double *restrict s, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = atan(s[1]) + s[2] * s[2];
    out[1] = s[4] * s[4] * s[4] + s[3] + s[0];
}

static void gradients(const double *restrict s, const double *restrict p, double *restrict out)
{
    const double rows[2][N] = { { 0, 1 / (1 + s[1] * s[1]), 2 * s[2], 0, 0 }, { 1, 0, 0, 1, 3 * s[4] * s[4] } };
    (void)p;
    memcpy(out, rows, sizeof rows);
}

static const char *const names[N] = { "x", "y", "z", "phi", "w" };
static const jlt_invariants integrals = { .count = 2, .values = values, .gradients = gradients };

static jlt_chart plane_of(double level, const int *signs)
{
    jlt_chart plane;
    assert_ok(jlt_chart_plane(&plane, N, 0, level, names, signs));
    jlt_chart_set_periods(&plane, (double[]){ 0, 0, 0, 2, 0 });
    return plane;
}

/* From y = 2 a whole step of Newton's method for atan(y) goes to -3.5, and on without end. */
static void solved_states_are_found_from_afar_and_follow_the_coordinates(void **unused)
{
    (void)unused;
    const jlt_chart plane = plane_of(0.5, NULL);
    const jlt_level levels[2] = { { .integral = 0, .state = 1, .value = 0.25, .guess = 2 },
                                  { .integral = 1, .state = 4, .value = 2, .guess = 5 } };
    const double q[2] = { 0.25, 0.75 }, y = tan(0.25 - 0.0625), w = cbrt(0.75);
    jlt_chart_level chart;
    double x[N], tangent[N * 2], back[2], slope[2 * N];

    assert_ok(jlt_chart_level_init(&chart, &plane, &integrals, levels, 2, NULL, NULL));
    assert_int_equal(chart.base.dim, 2);
    assert_string_equal(chart.base.names[0], "z");
    assert_string_equal(chart.base.names[1], "phi");
    assert_near(chart.base.period[0], 0, 0);
    assert_near(chart.base.period[1], 2, 0);
    assert_ok(chart.base.lift(&chart.base, x, tangent, q));
    const double wanted[N] = { 0.5, y, 0.25, 0.75, w };
    for (unsigned i = 0; i < N; i++) assert_near(x[i], wanted[i], 1e-14);
    const double by_hand[N][2] = { { 0, 0 }, { -2 * 0.25 * (1 + y * y), 0 }, { 1, 0 }, { 0, 1 }, { 0, -1 / (3 * w * w) } };
    for (unsigned i = 0; i < N; i++)
        for (unsigned k = 0; k < 2; k++) assert_near(tangent[2 * i + k], by_hand[i][k], 1e-14);
    /* The flux of volume: x' over the determinant of dF/d(y, w). */
    assert_near(chart.base.flux(&chart.base, x, (double[N]){ 7, 1, 1, 1, 1 }), 7 * (1 + y * y) / (3 * w * w), 1e-13);

    x[3] = 0.75 + 2; /* one period on */
    chart.base.lower(&chart.base, back, slope, x);
    for (unsigned k = 0; k < 2; k++) {
        assert_near(back[k], q[k], 1e-15);
        for (unsigned i = 0; i < N; i++) assert_near(slope[k * N + i], i == 2 + k, 0);
    }
    x[3] = 0.75;
    assert_true(jlt_chart_follows(&chart.base, x));
    assert_true(jlt_chart_follows(&plane, x));
    x[4] = -w;
    assert_false(jlt_chart_follows(&chart.base, x));
}

static void levels_without_a_state_are_empty_and_coordinates_finite(void **unused)
{
    (void)unused;
    const jlt_chart plane = plane_of(0.5, NULL);
    const jlt_level high = { .integral = 0, .state = 1, .value = 2, .guess = 0 };
    jlt_chart_level chart;
    double x[N], q[3] = { 0, 0, 0 };

    assert_ok(jlt_chart_level_init(&chart, &plane, &integrals, &high, 1, NULL, NULL));
    assert_int_equal(chart.base.dim, 3);
    assert_int_equal(chart.base.lift(&chart.base, x, NULL, q), JLT_ERR_EMPTY);
    q[0] = 1; /* atan(y) = 1 */
    assert_ok(chart.base.lift(&chart.base, x, NULL, q));
    assert_near(x[1], tan(1), 1e-14);
    q[1] = NAN;
    assert_int_equal(chart.base.lift(&chart.base, x, NULL, q), JLT_ERR_NONFINITE);
}

static void the_reversor_stays_where_it_keeps_what_is_solved_for(void **unused)
{
    (void)unused;
    const int keeps[N] = { -1, 1, -1, -1, 1 }, turns[N] = { -1, -1, 1, 1, 1 };
    const jlt_level level = { .integral = 0, .state = 1, .value = 0.25, .guess = 0 };
    jlt_chart plane = plane_of(0, keeps);
    jlt_chart_level chart;

    assert_ok(jlt_chart_level_init(&chart, &plane, &integrals, &level, 1, NULL, NULL));
    assert_true(chart.base.reversible);
    for (unsigned k = 0; k < 3; k++) assert_int_equal(chart.base.mirror[k], keeps[k + 2]);
    plane = plane_of(0, turns);
    assert_ok(jlt_chart_level_init(&chart, &plane, &integrals, &level, 1, NULL, NULL));
    assert_false(chart.base.reversible);
}

static void levels_that_make_no_sense_are_refused(void **unused)
{
    (void)unused;
    const jlt_chart plane = plane_of(0.5, NULL);
    const jlt_level wrong[][2] = { { { .integral = 2, .state = 1 }, { .integral = 1, .state = 4 } },
                                   { { .integral = 0, .state = N }, { .integral = 1, .state = 4 } },
                                   { { .integral = 0, .state = 0 }, { .integral = 1, .state = 4 } },
                                   { { .integral = 0, .state = 4 }, { .integral = 1, .state = 4 } },
                                   { { .integral = 1, .state = 1 }, { .integral = 1, .state = 4 } } };
    const jlt_level many[4] = { { .integral = 0, .state = 1 }, { .integral = 1, .state = 2 } };
    jlt_chart_level chart;

    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        assert_int_equal(jlt_chart_level_init(&chart, &plane, &integrals, wrong[i], 2, NULL, NULL), JLT_ERR_ARG);
    assert_int_equal(jlt_chart_level_init(&chart, &plane, &integrals, many, 0, NULL, NULL), JLT_ERR_ARG);
    assert_int_equal(jlt_chart_level_init(&chart, &plane, &integrals, many, 4, NULL, NULL), JLT_ERR_ARG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(solved_states_are_found_from_afar_and_follow_the_coordinates),
        cmocka_unit_test(levels_without_a_state_are_empty_and_coordinates_finite),
        cmocka_unit_test(the_reversor_stays_where_it_keeps_what_is_solved_for),
        cmocka_unit_test(levels_that_make_no_sense_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
