/* Periodic orbits from a grid of starts: the same whether these go together or one by one, and on however many threads. */
#include "unit/check.h"

#include "dynamics/orbits.h"
#include "dynamics/surface.h"
#include "kernel/batch_isa.h"
#include "kernel/descriptor.h"
#include "top/top.h"

/* The island of (5.1), on which an orbit of one return and two of two returns lie. */
static void search(jlt_orbits *out, jlt_map *map, const jlt_kernel_batch *kernels, unsigned threads)
{
    const jlt_orbits_options options = { .period_max = 2, .low = { -0.6, -0.64 }, .high = { 0.6, -0.6 }, .counts = { 5, 5 },
                                         .settle = 3, .kernels = kernels, .threads = threads };

    *out = (jlt_orbits){ .count = 0 };
    assert_ok(jlt_orbits_search(out, map, &options));
}

/* What is found is polished by the map itself, to residuals of 1e-13 where |(I - DP)^-1| is below 100. */
static void orbits_do_not_depend_on_lanes_or_threads(void **unused)
{
    const jlt_flow flow = { .tolerance = 1e-13, .direction = JLT_RISING };
    const jlt_claim *broken;
    jlt_surface surface;
    jlt_system *system;
    jlt_orbits one, together, threaded;
    jlt_map *map;

    (void)unused;
    assert_ok(jlt_surface_find(&surface, &broken, jlt_descriptor_find(JLT_DEFAULT_MODEL, NULL, NULL, NULL), NULL, NULL));
    assert_ok(jlt_surface_system(&system, &surface, surface.defaults, &flow));
    assert_ok(jlt_map_create(&map, &system->flow));
    search(&one, map, NULL, 2);
    search(&together, map, jlt_batch_isa_best(system->instance->descriptor, 0), 1);
    search(&threaded, map, jlt_batch_isa_best(system->instance->descriptor, 0), 3);
    assert_int_equal(together.count, 3);
    assert_int_equal(one.count, together.count);
    assert_int_equal(threaded.count, together.count);
    for (size_t i = 0; i < together.count; i++) {
        const jlt_periodic *a = &together.orbits[i], *b = &one.orbits[i], *c = &threaded.orbits[i];
        assert_int_equal(a->period, b->period);
        assert_true(jlt_periodic_same(system->flow.chart, a, b, 1e-11));
        assert_near(a->trace, b->trace, 1e-9);
        assert_int_equal(a->period, c->period);
        assert_memory_equal(a->points, c->points, a->period * 2 * sizeof *a->points);
        assert_memory_equal(a->slope, c->slope, sizeof a->slope);
    }
    jlt_orbits_clear(&one);
    jlt_orbits_clear(&together);
    jlt_orbits_clear(&threaded);
    jlt_map_destroy(map);
    jlt_system_destroy(system);
}

/* The first coordinates of two orbits that are mirror images differ by rounding alone: the second ones order them. */
static void rounding_does_not_order_orbits(void **unused)
{
    static jlt_periodic orbits[3];
    static const double points[3][2] = { { 5e-17, -0.25 }, { -7e-18, 0.25 }, { -0.5, 3 } };
    const jlt_chart chart = { .dim = 2 };
    jlt_orbits list = { .orbits = orbits, .count = 3 };

    (void)unused;
    for (int turned = 0; turned < 2; turned++) {
        for (size_t i = 0; i < 3; i++) {
            orbits[i] = (jlt_periodic){ .period = 1, .T = 2 + (double)i * 1e-15 };
            memcpy(orbits[i].points, points[turned ? 2 - i : i], sizeof points[0]);
        }
        jlt_orbits_sort(&list, &chart);
        assert_near(orbits[0].points[1], 3, 0);
        assert_near(orbits[1].points[1], -0.25, 0);
        assert_near(orbits[2].points[1], 0.25, 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(orbits_do_not_depend_on_lanes_or_threads),
        cmocka_unit_test(rounding_does_not_order_orbits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
