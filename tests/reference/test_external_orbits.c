/* Periodic orbits of other systems against published numbers: sections, symmetry and multipliers know no particular model. */
#include "unit/check.h"

#include "dynamics/orbits.h"
#include "dynamics/system.h"
#include "kernel/descriptor.h"

static jlt_system *open_system(const char *model, const char *section, double level, const int *signs,
                               jlt_direction direction)
{
    const jlt_descriptor *descriptor = jlt_descriptor_find(model, NULL, NULL, NULL);
    const jlt_flow options = { .tolerance = 1e-14, .direction = direction };
    double params[8];
    jlt_system *system;
    size_t column;

    assert_non_null(descriptor);
    assert_true(jlt_descriptor_state(descriptor, section, &column));
    for (unsigned i = 0; i < descriptor->param_count; i++) params[i] = descriptor->params[i].value;
    assert_ok(jlt_system_plane(&system, descriptor, params, (unsigned)column, level, signs, &options));
    return system;
}

static jlt_periodic newton(jlt_system *system, const double *guess, size_t period, const unsigned char *held)
{
    jlt_periodic orbit;
    jlt_map *map;

    assert_ok(jlt_map_create(&map, &system->flow));
    assert_ok(jlt_periodic_find(map, &orbit, guess, period, held));
    jlt_map_destroy(map);
    jlt_system_destroy(system);
    return orbit;
}

/* Oracle: D. Viswanath, Physica D 190 (2004): T = 1.55865221071617; the divergence is the constant -41/3. The period is
 * known to the tolerance times the orbit's steps (some hundred) times its conditioning (of order one). */
static void lorenz_orbit_AB_has_its_period_and_multipliers(void **unused)
{
    const double guess[2] = { -13.76, -19.58 };
    const jlt_periodic orbit = newton(open_system("lorenz", "z", 27, NULL, JLT_RISING), guess, 2, NULL);

    (void)unused;
    assert_int_equal(orbit.period, 2);
    assert_near(orbit.T, 1.5586522107161747, 1e-12);
    assert_near(log(orbit.re[0] * orbit.re[1]), -41 * 1.5586522107161747 / 3, 1e-11);
    assert_near(orbit.determinant_slope / orbit.determinant, 1, 1e-6);
    assert_int_equal(orbit.type, JLT_ORBIT_SADDLE);
}

/* Oracle: the published period 5.88108845555 and multiplier -2.40395353185, to their digits. */
static void roessler_orbit_has_its_period_and_multiplier(void **unused)
{
    const double guess[2] = { -7, 0.02 };
    const jlt_periodic orbit = newton(open_system("roessler", "y", 0, NULL, JLT_FALLING), guess, 1, NULL);

    (void)unused;
    assert_near(orbit.T, 5.88108845555, 1e-11);
    assert_near(orbit.re[0], -2.40395353185, 1e-10);
    assert_int_equal(orbit.type, JLT_ORBIT_FLIP_SADDLE);
}

/* Oracle: the period 17.0652165601579625588917206249 of Hairer, Norsett, Wanner I, II.0, whose start is (0.994, 0, 0,
 * -2.00158510637908252240537862224). Found on the line of perpendicular starts x = 0.994, where v_y alone runs. The orbit's
 * large multiplier is 285 and it passes the earth at 0.006, where digits go: two of sixteen. */
static void arenstorf_orbit_is_found_by_its_symmetry(void **unused)
{
    static const int signs[4] = { 1, -1, -1, 1 };
    jlt_system *system = open_system("restricted_three_body", "y", 0, signs, JLT_BOTH);
    const jlt_symmetric_line line = { .base = { 0.994, 0, 0 }, .free = 2, .low = -2.0017, .high = -2.0015, .samples = 20 };
    const jlt_orbits_options options = { .period_max = 6, .lines = &line, .line_count = 1 };
    jlt_orbits list = { 0 };
    size_t best = 0;
    jlt_map *map;

    (void)unused;
    assert_ok(jlt_map_create(&map, &system->flow));
    assert_ok(jlt_orbits_search(&list, map, &options));
    assert_true(list.count > 0);
    for (size_t i = 0; i < list.count; i++)
        if (fabs(list.orbits[i].T - 17.0652) < 1e-3) best = i;
    assert_near(list.orbits[best].T, 17.0652165601579625588917206249, 1e-11);
    assert_near(list.orbits[best].points[2], -2.00158510637908252240537862224, 1e-12);
    assert_true(list.orbits[best].symmetric);
    assert_near(list.orbits[best].determinant, 1, 1e-12);
    jlt_orbits_clear(&list);
    jlt_map_destroy(map);
    jlt_system_destroy(system);
}

/* A point where the flow touches the section returns to it at once; it is not a periodic orbit. */
static void touching_the_section_is_no_orbit(void **unused)
{
    const double touching[2] = { 0, 0.035 }; /* y' = x + a y = 0 at x = y = 0 */
    jlt_system *system = open_system("roessler", "y", 0, NULL, JLT_FALLING);
    jlt_periodic orbit;
    jlt_map *map;

    (void)unused;
    assert_ok(jlt_map_create(&map, &system->flow));
    if (jlt_periodic_find(map, &orbit, touching, 1, NULL) == JLT_OK) assert_true(orbit.T > 1);
    jlt_map_destroy(map);
    jlt_system_destroy(system);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lorenz_orbit_AB_has_its_period_and_multipliers),
        cmocka_unit_test(roessler_orbit_has_its_period_and_multiplier),
        cmocka_unit_test(arenstorf_orbit_is_found_by_its_symmetry),
        cmocka_unit_test(touching_the_section_is_no_orbit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
