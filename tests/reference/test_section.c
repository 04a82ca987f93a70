/* Section maps of the spherical top against quadruple precision (tests/reference/data). */
#include "dynamics/fates.h"
#include "dynamics/periodic.h"
#include "witness/top_section.h"

#include "unit/check.h"

#include <stdio.h>
#include <stdlib.h>

static FILE *open_data(const char *name)
{
    char path[512], line[512];
    FILE *file;

    snprintf(path, sizeof path, "%s/tests/reference/data/%s", JLT_SOURCE_DIR, name);
    file = fopen(path, "r");
    assert_non_null(file);
    assert_non_null(fgets(line, sizeof line, file));
    return file;
}

/* Numbers of the next row; false at the end. */
static int next_row(FILE *file, double *values, int count)
{
    char line[512], *at = line;

    if (fgets(line, sizeof line, file) == NULL) return 0;
    for (int i = 0; i < count; i++) {
        values[i] = strtod(at, &at);
        if (*at == ',') at++;
    }
    return 1;
}

static jlt_system *open_system(double tolerance, const char *method)
{
    const jlt_flow options = { .tolerance = tolerance, .direction = JLT_RISING, .method = jlt_method_find(method) };
    const jlt_top_values values = jlt_system_top_defaults();
    jlt_system *system;

    assert_int_equal(jlt_system_top(&system, &values, &options), JLT_OK);
    return system;
}

/* Largest error over all rows of returns_51.csv. */
static double worst_return(double tolerance, const char *method)
{
    jlt_system *system = open_system(tolerance, method);
    FILE *file = open_data("returns_51.csv");
    jlt_section *section;
    jlt_return row;
    double want[8], worst = 0;

    assert_int_equal(jlt_section_create(&section, &system->flow), JLT_OK);
    while (next_row(file, want, 8)) {
        double got[6];
        if (want[1] == 0) assert_int_equal(jlt_section_start(section, &row, want + 2, 1), JLT_OK);
        else assert_int_equal(jlt_section_next(section, &row), JLT_OK);
        assert_int_equal(row.fate, JLT_FATE_ALIVE);
        assert_int_equal(row.number, (size_t)want[1]);
        got[0] = row.q[0];
        got[1] = row.q[1];
        got[2] = row.t;
        got[3] = row.x[JLT_CHART_TOP_V_NU];
        jlt_chart_top_rotation(jlt_system_top_chart(system), &got[4], &got[5], row.x);
        for (int i = 0; i < 6; i++) worst = fmax(worst, fabs(got[i] - want[i + 2]));
    }
    fclose(file);
    jlt_section_destroy(section);
    jlt_system_destroy(system);
    return worst;
}

/* Oracle: quadruple-precision Taylor integration. Budget: 1e-11 is the amplification of ten returns (under 100, from DP)
 * times the tolerance 1e-13. */
static void returns_match_quadruple_precision(void **unused)
{
    (void)unused;
    assert_true(worst_return(1e-13, "dop853") < 1e-11);
    assert_true(worst_return(1e-13, "rk8pd") < 1e-11);
}

/* A method of local error control has an error that falls with the tolerance, and stays within 1000 of it here: the
 * amplification of ten returns times about ten steps a return. */
static void error_falls_with_tolerance(void **unused)
{
    static const double tolerances[] = { 1e-5, 1e-7, 1e-9, 1e-11 };
    double last = INFINITY;

    (void)unused;
    for (size_t i = 0; i < sizeof tolerances / sizeof *tolerances; i++) {
        const double worst = worst_return(tolerances[i], "dop853");
        assert_true(worst < last / 10);
        assert_true(worst < 1000 * tolerances[i]);
        last = worst;
    }
}

/* Rows counted one by one. */
static size_t returns_before_end(jlt_section *section, const double *q)
{
    jlt_return row;
    size_t count = 0;

    assert_int_equal(jlt_section_start(section, &row, q, 1), JLT_OK);
    while (jlt_section_next(section, &row) == JLT_OK && row.fate == JLT_FATE_ALIVE) count++;
    return count;
}

/* Oracle: as above. At a pole omega_n tends to 0 and s to 0; limits to 1e-10, times to 1e-11. */
static void poles_match_quadruple_precision(void **unused)
{
    jlt_system *system = open_system(1e-13, "dop853");
    FILE *file = open_data("poles_51.csv");
    jlt_section *section;
    jlt_fates_end end;
    double want[7], omega_n, omega3;
    int rows = 0;

    (void)unused;
    assert_int_equal(jlt_section_create(&section, &system->flow), JLT_OK);
    while (next_row(file, want, 7)) {
        assert_int_equal(jlt_fates_follow(section, &end, want, 100), JLT_OK);
        assert_int_equal(end.fate, want[2] > 0 ? JLT_FATE_POLE_PLUS : JLT_FATE_POLE_MINUS);
        assert_int_equal(end.returns, returns_before_end(section, want));
        assert_true(fabs(end.t - want[3]) < 1e-11);
        assert_true(fabs(end.x[JLT_CHART_TOP_V_NU] - want[4]) < 1e-10);
        assert_true(fabs(end.x[JLT_CHART_TOP_OMEGA_TAU] - want[5]) < 1e-10);
        jlt_chart_top_rotation(jlt_system_top_chart(system), &omega_n, &omega3, end.x);
        assert_true(fabs(omega3 - want[6]) < 1e-10);
        assert_true(fabs(omega_n) < 1e-10);
        rows++;
    }
    assert_int_equal(rows, 4);
    fclose(file);
    jlt_section_destroy(section);
    jlt_system_destroy(system);
}

/* Oracle: quadruple precision, tests/reference/data/PROVENANCE.md; the determinant is 1 because the orbit is symmetric. */
static void symmetric_fixed_point_matches_quadruple_precision(void **unused)
{
    const double guess[2] = { 0.01, -0.61 };
    jlt_system *system = open_system(1e-13, "dop853");
    jlt_periodic orbit;
    jlt_map *map;

    (void)unused;
    assert_int_equal(jlt_map_create(&map, &system->flow), JLT_OK);
    assert_int_equal(jlt_periodic_find(map, &orbit, guess, 1, NULL), JLT_OK);
    assert_true(fabs(orbit.points[0]) < 1e-12);
    assert_true(fabs(orbit.points[1] + 0.61358438970663813576) < 1e-13);
    assert_true(fabs(orbit.trace + 2.04741846162242181656) < 1e-11);
    assert_true(fabs(orbit.determinant - 1) < 1e-11);
    assert_true(fabs(orbit.determinant_slope - 1) < 1e-11);
    assert_true(orbit.residual < 1e-14);
    assert_true(orbit.symmetric);
    assert_int_equal(orbit.type, JLT_ORBIT_FLIP_SADDLE);
    jlt_map_destroy(map);
    jlt_system_destroy(system);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(returns_match_quadruple_precision),
        cmocka_unit_test(error_falls_with_tolerance),
        cmocka_unit_test(poles_match_quadruple_precision),
        cmocka_unit_test(symmetric_fixed_point_matches_quadruple_precision),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
