/* Asymmetric periodic orbits with det DP != 1 exclude an invariant measure with smooth positive density for a3 != 0: a
 * periodic orbit of a map that keeps rho dq has det D(P^n) = rho(q)/rho(q) = 1. Found by this project's own search; here
 * they are confirmed by a second method and a second tolerance, and by their mirror images. */
#include "unit/check.h"

#include "dynamics/orbits.h"
#include "witness/top_section.h"

typedef struct {
    jlt_top_values values;
    double q[2];
    size_t period;
    double determinant, error; /* as found at tolerance 1e-13, and how far the last digit is to be trusted */
    jlt_orbit_type type;
} finding;

static const finding findings[] = {
    /* (5.1) of Kilin & Ivanova (2023) itself */
    { { 1, 1, 1, 1. / 3, 1. / 3, 0.51, 2.15, -0.56 }, { -0.3307161930411, -0.6269322295053 }, 18, 0.848381972, 1e-8,
      JLT_ORBIT_SADDLE },
    { { 1, 1, 1, 1. / 3, 1. / 3, 0.51, 2.15, -0.56 }, { -0.1646634049987, -0.6119732064821 }, 26, 0.412189442, 1e-7,
      JLT_ORBIT_SADDLE },
    /* an attracting fixed point, its mirror image repels */
    { { 1, 1, 1, 0.591, 0.494, 0.548, 2.15, 0.161 }, { 2.83951717365456, -0.95874074049751 }, 1, 0.04450501424, 1e-10,
      JLT_ORBIT_ATTRACTING },
};

static jlt_periodic find(const finding *f, const double *q, double tolerance, const char *method, double *contact)
{
    const jlt_flow options = { .tolerance = tolerance, .direction = JLT_RISING, .method = jlt_method_find(method) };
    jlt_system *system;
    jlt_section *section;
    jlt_periodic orbit;
    jlt_return row;
    jlt_map *map;

    assert_ok(jlt_system_top(&system, &f->values, &options));
    assert_ok(jlt_map_create(&map, &system->flow));
    assert_ok(jlt_periodic_find(map, &orbit, q, f->period, NULL));
    assert_ok(jlt_section_create(&section, &system->flow));
    assert_ok(jlt_section_start(section, &row, orbit.points, 1));
    while (row.number < f->period) assert_ok(jlt_section_next(section, &row));
    *contact = row.least;
    jlt_section_destroy(section);
    jlt_map_destroy(map);
    jlt_system_destroy(system);
    return orbit;
}

static void asymmetric_orbits_contract_and_their_mirror_images_expand(void **unused)
{
    (void)unused;
    for (size_t i = 0; i < sizeof findings / sizeof *findings; i++) {
        const finding *f = &findings[i];
        const double mirror[2] = { -f->q[0], f->q[1] };
        double contact;
        const jlt_periodic orbit = find(f, f->q, 1e-13, "dop853", &contact);
        const jlt_periodic again = find(f, f->q, 1e-12, "rk8pd", &contact);
        const jlt_periodic image = find(f, mirror, 1e-13, "dop853", &contact);

        assert_int_equal(orbit.period, f->period);
        assert_int_equal(orbit.type, f->type);
        assert_false(orbit.symmetric);
        assert_true(orbit.residual < 1e-13);
        assert_near(orbit.determinant, f->determinant, f->error);
        assert_near(again.determinant, orbit.determinant, 10 * f->error);
        assert_near(image.determinant * orbit.determinant, 1, 1e-8);
        assert_near(image.T, orbit.T, 1e-9);
        /* the two ways to the determinant: far apart from 1, near each other */
        assert_near(orbit.determinant_slope / orbit.determinant, 1, 1e-8);
        /* the support pushes all along the orbit: the model holds on it */
        assert_true(contact > 0);
    }
}

/* Symmetric orbits cannot show it: multipliers mu, 1/mu. */
static void symmetric_orbits_have_determinant_one(void **unused)
{
    const finding f = { { 1, 1, 1, 1. / 3, 1. / 3, 0.51, 2.15, -0.56 }, { 0 }, 2, 1, 0, JLT_ORBIT_CENTRE };
    const jlt_symmetric_line lines[2] = {
        { .base = { 0, 0 }, .free = 1, .low = -0.999, .high = 0.999, .samples = 800 },
        { .base = { 3.14159265358979323846, 0 }, .free = 1, .low = -0.999, .high = 0.999, .samples = 800 },
    };
    const jlt_orbits_options options = { .period_max = 2, .lines = lines, .line_count = 2 };
    const jlt_flow flow = { .tolerance = 1e-13, .direction = JLT_RISING };
    jlt_orbits list = { 0 };
    jlt_system *system;
    jlt_map *map;

    (void)unused;
    assert_ok(jlt_system_top(&system, &f.values, &flow));
    assert_ok(jlt_map_create(&map, &system->flow));
    assert_ok(jlt_orbits_search(&list, map, &options));
    assert_int_equal(list.count, 4);
    for (size_t i = 0; i < list.count; i++) {
        assert_true(list.orbits[i].symmetric);
        assert_near(list.orbits[i].determinant, 1, 1e-11);
        assert_int_equal(jlt_orbits_mirror(&list, system->flow.chart, i), i);
    }
    jlt_orbits_clear(&list);
    jlt_map_destroy(map);
    jlt_system_destroy(system);
}

/* Two algorithms that share no step: zeros on the reversor's lines, and Newton's method on a grid. */
static void lines_and_grid_find_the_same_symmetric_orbits(void **unused)
{
    const finding f = { { 1, 1, 1, 1. / 3, 1. / 3, 0.51, 2.15, -0.56 }, { 0 }, 2, 1, 0, JLT_ORBIT_CENTRE };
    const jlt_orbits_options options = { .period_max = 2, .low = { -0.6, -0.68 }, .high = { 0.6, -0.56 },
                                         .counts = { 12, 6 }, .near = 0.5 };
    static const double found[3][2] = { { 0, -0.6135843897066 }, { -0.4344789217203, -0.6213208220279 },
                                        { 0.3125851067367, -0.6157682753091 } };
    const jlt_flow flow = { .tolerance = 1e-13, .direction = JLT_RISING };
    jlt_orbits list = { 0 };
    jlt_system *system;
    jlt_map *map;

    (void)unused;
    assert_ok(jlt_system_top(&system, &f.values, &flow));
    assert_ok(jlt_map_create(&map, &system->flow));
    assert_ok(jlt_orbits_search(&list, map, &options));
    for (size_t k = 0; k < 3; k++) {
        double nearest = 1;
        for (size_t i = 0; i < list.count; i++)
            for (size_t j = 0; j < list.orbits[i].period; j++)
                nearest = fmin(nearest, jlt_chart_distance(system->flow.chart, list.orbits[i].points + 2 * j, found[k]));
        assert_true(nearest < 1e-11);
    }
    jlt_orbits_clear(&list);
    jlt_map_destroy(map);
    jlt_system_destroy(system);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(asymmetric_orbits_contract_and_their_mirror_images_expand),
        cmocka_unit_test(symmetric_orbits_have_determinant_one),
        cmocka_unit_test(lines_and_grid_find_the_same_symmetric_orbits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
