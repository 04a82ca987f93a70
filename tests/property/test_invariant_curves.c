/* Branches of manifolds, homoclinic points, continuation and exponents: what must hold of each. */
#include "property/top_51.h"

#include <stdlib.h>
#include <string.h>

#include "dynamics/separatrices.h"
#include "dynamics/lyapunov.h"
#include "kernel/descriptor.h"

static jlt_periodic saddle_of(jlt_map *map)
{
    const double guess[2] = { 0, -0.6136 };
    jlt_periodic saddle;

    assert_ok(jlt_periodic_find(map, &saddle, guess, 1, NULL));
    assert_int_equal(saddle.type, JLT_ORBIT_FLIP_SADDLE);
    return saddle;
}

/* F(gamma(sigma)) = gamma(sigma + 1) by construction up to rounding, and gamma lies on the manifold up to the square of the
 * seed: halving the seed, with sigma shifted to match, moves points along the curve alone. */
static void branches_are_invariant(void **unused)
{
    jlt_system *system = top_51(1e-13);
    jlt_branch branch;
    jlt_image image;
    jlt_map *map;
    double q[2], next[2];

    (void)unused;
    assert_ok(jlt_map_create(&map, &system->flow));
    const jlt_periodic saddle = saddle_of(map);
    for (int stable = 0; stable < 2; stable++) {
        assert_ok(jlt_branch_init(&branch, map, &saddle, stable, 1, 1e-4));
        assert_int_equal(branch.returns, 2);
        assert_near(branch.lambda, 1.24275395055591 * 1.24275395055591, 1e-10);
        for (double sigma = 0.3; sigma < 20; sigma += 4.2) {
            assert_ok(jlt_branch_point(&branch, q, sigma));
            assert_ok(jlt_branch_point(&branch, next, sigma + 1));
            assert_ok(jlt_map_point(map, &image, q, branch.returns, branch.time_direction));
            assert_true(jlt_chart_distance(system->flow.chart, image.q, next) < 1e-9);
        }
    }
    jlt_map_destroy(map);
    jlt_system_destroy(system);
}

/* The stable branch, grown backwards in time, is the mirror image of the unstable one. Polygons of different points on one
 * curve: each point is near the other polygon by the sag of a piece, spacing^2 times curvature over 8. */
static void stable_branch_mirrors_the_unstable_one(void **unused)
{
    const jlt_manifold_options options = { .spacing = 0.004, .length_max = 0.5 };
    const jlt_manifold_options wrong[] = { { .spacing = 1e-5 }, { .spacing = NAN }, { .finest = -1 }, { .turn = NAN },
                                           { .length_max = -1 }, { .length_max = NAN }, { .points_max = 1 } };
    jlt_system *system = top_51(1e-12);
    const jlt_chart *chart = system->flow.chart;
    jlt_manifold unstable = { 0 }, stable = { 0 }, mirrored = { 0 };
    jlt_branch u, s;
    jlt_map *map;

    (void)unused;
    assert_ok(jlt_map_create(&map, &system->flow));
    const jlt_periodic saddle = saddle_of(map);
    assert_ok(jlt_branch_init(&u, map, &saddle, false, 1, 1e-4));
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        assert_int_equal(jlt_manifold_grow(&unstable, &(const jlt_branch *){ &u }, 1, &wrong[i]), JLT_ERR_ARG);
    assert_ok(jlt_manifold_grow(&unstable, &(const jlt_branch *){ &u }, 1, &options));
    assert_int_equal(unstable.end, JLT_MANIFOLD_LENGTH);
    assert_ok(jlt_manifold_reflect(&mirrored, &unstable, chart));
    for (int side = -1; side <= 1; side += 2) {
        assert_ok(jlt_branch_init(&s, map, &saddle, true, side, 1e-4));
        if (-u.v[0] * s.v[0] + u.v[1] * s.v[1] < 0) continue;
        assert_ok(jlt_manifold_grow(&stable, &(const jlt_branch *){ &s }, 1, &options));
        for (size_t i = 0; i < stable.count && stable.length[i] < 0.49; i++) {
            double nearest = 1;
            for (size_t j = 0; j < mirrored.count; j++)
                nearest = fmin(nearest, jlt_chart_distance(chart, stable.points + 2 * i, mirrored.points + 2 * j));
            assert_true(nearest < 0.0041);
        }
        jlt_manifold_clear(&stable);
    }
    for (size_t i = 1; i < unstable.count; i++) {
        assert_true(unstable.sigma[i] > unstable.sigma[i - 1]);
        assert_true(unstable.length[i] - unstable.length[i - 1] < 0.0041);
    }
    jlt_manifold_clear(&unstable);
    jlt_manifold_clear(&mirrored);
    jlt_map_destroy(map);
    jlt_system_destroy(system);
}

/* Both unstable branches of a saddle, grown side by side from different seeds, are those that grow alone. */
static void branches_do_not_depend_on_their_company(void **unused)
{
    const jlt_manifold_options options = { .spacing = 0.01, .length_max = 0.3 };
    jlt_system *system = top_51(1e-11);
    jlt_manifold together[2], alone;
    jlt_branch branches[2];
    jlt_map *map;

    (void)unused;
    assert_ok(jlt_map_create(&map, &system->flow));
    const jlt_periodic saddle = saddle_of(map);
    for (int i = 0; i < 2; i++) {
        assert_ok(jlt_branch_init(&branches[i], map, &saddle, false, 2 * i - 1, i == 0 ? 1e-4 : 1e-6));
        branches[i].kernels = system->field.batch;
    }
    assert_ok(jlt_manifold_grow(together, (const jlt_branch *const[]){ &branches[0], &branches[1] }, 2, &options));
    assert_memory_not_equal(together[0].points, together[1].points, 2 * sizeof *alone.points);
    for (int i = 0; i < 2; i++) {
        assert_ok(jlt_manifold_grow(&alone, &(const jlt_branch *){ &branches[i] }, 1, &options));
        assert_true(alone.count == together[i].count && alone.end == together[i].end);
        assert_memory_equal(alone.points, together[i].points, 2 * alone.count * sizeof *alone.points);
        jlt_manifold_clear(&alone);
        jlt_manifold_clear(&together[i]);
    }
    jlt_map_destroy(map);
    jlt_system_destroy(system);
}

/* The primary homoclinic points of Figure 3b: on both branches to rounding, transverse beyond their error bars. */
static void separatrices_cross_transversally(void **unused)
{
    const jlt_manifold_options options = { .length_max = 0.55 };
    jlt_system *system = top_51(1e-13), *rough = top_51(1e-12);
    jlt_manifold curves[2] = { { 0 } };
    jlt_homoclinic *points = NULL;
    jlt_branch branches[2];
    jlt_map_batch *fine, *coarse;
    jlt_map *map;
    size_t count = 0, transverse = 0;

    (void)unused;
    assert_ok(jlt_map_create(&map, &system->flow));
    assert_ok(jlt_map_batch_create(&fine, &system->flow, system->field.batch, NULL, 2));
    assert_ok(jlt_map_batch_create(&coarse, &rough->flow, rough->field.batch, NULL, 2));
    const jlt_periodic saddle = saddle_of(map);
    for (int stable = 0; stable < 2; stable++) {
        assert_ok(jlt_branch_init(&branches[stable], map, &saddle, stable, 1, 1e-4));
        assert_ok(jlt_manifold_grow(&curves[stable], &(const jlt_branch *){ &branches[stable] }, 1, &options));
    }
    assert_ok(jlt_homoclinic_find(&points, &count, NULL, &curves[0], &branches[0], &curves[1], &branches[1], false, fine, coarse));
    for (size_t i = 0; i < count; i++) {
        assert_true(points[i].residual < 1e-8);
        transverse += fabs(points[i].angle) > 0.1 && points[i].angle_error < 1e-4;
        if (i + 1 < count) assert_true(points[i].sigma_unstable < points[i + 1].sigma_unstable);
    }
    assert_true(transverse >= 2);
    free(points);
    for (int k = 0; k < 2; k++) jlt_manifold_clear(&curves[k]);
    jlt_map_destroy(map);
    jlt_map_batch_destroy(coarse);
    jlt_map_batch_destroy(fine);
    jlt_system_destroy(system);
    jlt_system_destroy(rough);
}

/* Crossings of Figure 3b, of which half are taken for images under the reversor, against all of them refined: each is there, with
 * its angle to within the sum of error bars and, of a point that differs by rounding times the conditioning of 30 returns, its
 * parameters. */
static void images_of_crossings_are_crossings(void **unused)
{
    const jlt_manifold_options options = { .length_max = 0.7 };
    jlt_system *system = top_51(1e-13), *rough = top_51(1e-12);
    jlt_separatrices all = { .chart = NULL };
    jlt_map_batch *fine, *coarse;
    jlt_map *map;
    size_t compared = 0;

    (void)unused;
    assert_ok(jlt_map_create(&map, &system->flow));
    assert_ok(jlt_map_batch_create(&fine, &system->flow, system->field.batch, NULL, 2));
    assert_ok(jlt_map_batch_create(&coarse, &rough->flow, rough->field.batch, NULL, 2));
    const jlt_periodic saddle = saddle_of(map);
    assert_ok(jlt_separatrices_grow(&all, map, &saddle, 1e-4, &options, system->field.batch, 2));
    assert_ok(jlt_separatrices_cross(&all));
    for (int u = 0; u < 2; u++)
        for (int s = 0; s < 2; s++) {
            jlt_homoclinic *points;
            size_t count, touching;
            assert_true(all.original[2 + s] < 2);
            assert_ok(jlt_homoclinic_find(&points, &count, &touching, &all.curve[u], &all.branch[u], &all.curve[2 + s],
                                          &all.branch[2 + s], false, fine, coarse));
            assert_int_equal(count, all.count[u][s]);
            assert_int_equal(touching, all.touching[u][s]);
            for (size_t i = 0; i < count; i++, compared++) {
                const jlt_homoclinic *a = &points[i], *b = &all.crossings[u][s][i];
                assert_near(a->angle, b->angle, a->angle_error + b->angle_error);
                assert_near(a->sigma_unstable, b->sigma_unstable, 1e-7);
                assert_near(a->sigma_stable, b->sigma_stable, 1e-7);
                assert_true(jlt_chart_distance(all.chart, a->q, b->q) < 1e-8);
            }
            free(points);
        }
    assert_true(compared >= 20);
    jlt_separatrices_clear(&all);
    jlt_map_destroy(map);
    jlt_map_batch_destroy(coarse);
    jlt_map_batch_destroy(fine);
    jlt_system_destroy(system);
    jlt_system_destroy(rough);
}

/* A lobe may be thinner than the sides of a polygon lie beside its curve: areas do not depend on the polygon, to 1e-11 a part of
 * the branches, of which no lobe has more than 100. Lobes of mirror images, taken for such, are those of the branches
 * themselves. */
static void areas_of_lobes_do_not_depend_on_the_polygon(void **unused)
{
    const jlt_manifold_options options[] = { { .length_max = 0.403 }, { .length_max = 0.403, .spacing = 0.04, .turn = 1 } };
    jlt_system *system = top_51(1e-13);
    jlt_separatrices all[2] = { { .chart = NULL }, { .chart = NULL } };
    jlt_homoclinic own[64];
    jlt_map_batch *maps;
    jlt_map *map;
    size_t compared = 0;

    (void)unused;
    assert_ok(jlt_map_create(&map, &system->flow));
    assert_ok(jlt_map_batch_create(&maps, &system->flow, system->field.batch, NULL, 2));
    const jlt_periodic saddle = saddle_of(map);
    for (int k = 0; k < 2; k++) {
        assert_ok(jlt_separatrices_grow(&all[k], map, &saddle, 1e-4, &options[k], system->field.batch, 2));
        assert_ok(jlt_separatrices_cross(&all[k]));
    }
    const size_t count = all[0].count[0][0];
    jlt_homoclinic *fine = all[0].crossings[0][0], *coarse = all[1].crossings[0][0];
    for (size_t i = 0, j = 0; i + 1 < count; i++) {
        assert_true(fabs(fine[i].lobe) < 1e-5);
        if (i > 0) assert_true(fine[i].lobe * fine[i - 1].lobe < 0);
        while (j < all[1].count[0][0] && coarse[j].sigma_unstable < fine[i].sigma_unstable - 1e-6) j++;
        assert_true(j + 1 < all[1].count[0][0]);
        assert_near(coarse[j + 1].sigma_unstable, fine[i + 1].sigma_unstable, 1e-6);
        assert_near(coarse[j].lobe, fine[i].lobe, 1e-9);
        assert_near(coarse[j].lobe, fine[i].lobe, coarse[j].lobe_error + fine[i].lobe_error);
        compared++;
    }
    assert_true(compared >= 9);
    for (int k = 0; k < 2; k++) {
        const jlt_branch *branch = &all[0].branch[2 * k];
        double sigma[64], q[64][2];
        jlt_branch_area areas[64];
        assert_true(count <= 64);
        if (k == 0) memcpy(own, fine, count * sizeof *own);
        for (size_t i = 0; i < count; i++) {
            sigma[i] = k == 0 ? fine[i].sigma_unstable : fine[i].sigma_stable;
            memcpy(q[i], fine[i].q, sizeof q[i]);
        }
        assert_ok(jlt_branch_area_to(areas, branch, &all[0].curve[2 * k], sigma, q[0], count, maps));
        for (size_t i = 0; i < count; i++) own[i].area[k] = areas[i];
    }
    jlt_homoclinic_measure_lobes(own, count, all[0].chart);
    for (size_t i = 0; i + 1 < count; i++) assert_near(fine[i].lobe, own[i].lobe, 1e-9);
    for (int k = 0; k < 2; k++) jlt_separatrices_clear(&all[k]);
    jlt_map_destroy(map);
    jlt_map_batch_destroy(maps);
    jlt_system_destroy(system);
}

/* A flow that leaves its tolerance to the default has the same crossings, with the same error bars, as one that names it. */
static void the_default_tolerance_has_the_error_bars_of_its_value(void **unused)
{
    const jlt_manifold_options options = { .length_max = 0.5 };
    jlt_system *system = top_51(1e-12);
    jlt_separatrices all[2] = { { .chart = NULL }, { .chart = NULL } };
    jlt_map *maps[2];
    size_t compared = 0;

    (void)unused;
    for (int k = 0; k < 2; k++) {
        jlt_flow flow = system->flow;
        flow.tolerance = k == 0 ? 1e-12 : 0;
        assert_ok(jlt_map_create(&maps[k], &flow));
        const jlt_periodic saddle = saddle_of(maps[k]);
        assert_ok(jlt_separatrices_grow(&all[k], maps[k], &saddle, 1e-4, &options, system->field.batch, 2));
        assert_ok(jlt_separatrices_cross(&all[k]));
    }
    for (int u = 0; u < 2; u++)
        for (int s = 0; s < 2; s++) {
            assert_int_equal(all[1].count[u][s], all[0].count[u][s]);
            for (size_t i = 0; i < all[0].count[u][s]; i++, compared++)
                assert_near(all[1].crossings[u][s][i].angle_error, all[0].crossings[u][s][i].angle_error, 0);
        }
    assert_true(compared > 0);
    for (int k = 0; k < 2; k++) {
        jlt_separatrices_clear(&all[k]);
        jlt_map_destroy(maps[k]);
    }
    jlt_system_destroy(system);
}

typedef struct {
    jlt_continuation_point doubling, fold;
    bool has_doubling, has_fold;
    double worst;
    size_t count;
} run_record;

static jlt_status record(void *context, const jlt_continuation_point *point)
{
    run_record *self = context;

    self->count++;
    self->worst = fmax(self->worst, point->orbit.residual);
    if (point->kind == JLT_BIFURCATION_DOUBLING && !self->has_doubling) self->doubling = *point, self->has_doubling = true;
    if (point->kind == JLT_BIFURCATION_FOLD && !self->has_fold) self->fold = *point, self->has_fold = true;
    return JLT_OK;
}

/* The fixed point doubles its period where its trace is -2; the doubled branch then folds where its trace is 2. Oracle: the
 * trace of orbits found at fixed energies on both sides, without continuation. */
static void bifurcations_lie_where_multipliers_say(void **unused)
{
    jlt_top_family tops = { .values = jlt_system_top_defaults(),
                            .name = "E",
                            .options = { .tolerance = 1e-13, .direction = JLT_RISING } };
    jlt_system_family family = { .make = jlt_system_top_at, .context = &tops };
    const jlt_family maps = { jlt_system_map_at, &family, jlt_system_map_near };
    const volatile sig_atomic_t raised = 1;
    const jlt_continuation_options options = { .low = 1.7, .high = 2.2, .points_max = 200 }, stopped = { .interrupt = &raised };
    jlt_continuation_point start = { .value = 2.15 }, other;
    jlt_continuation_end end;
    run_record first = { .count = 0 }, second = { .count = 0 };
    jlt_map *map;

    (void)unused;
    assert_ok(jlt_system_map_at(&family, &map, 2.15));
    start.orbit = saddle_of(map);
    assert_ok(jlt_continuation_run(&end, &maps, &start, -1, &stopped, record, &first));
    assert_int_equal(end, JLT_CONTINUATION_INTERRUPT);
    assert_int_equal(first.count, 1);
    assert_ok(jlt_continuation_run(&end, &maps, &start, -1, &options, record, &first));
    assert_int_equal(end, JLT_CONTINUATION_RANGE);
    assert_true(first.has_doubling && first.worst < 1e-12);
    assert_near(first.doubling.orbit.trace, -2, 1e-8);
    for (int side = -1; side <= 1; side += 2) {
        jlt_periodic orbit;
        assert_ok(jlt_system_map_at(&family, &map, first.doubling.value + side * 1e-4));
        assert_ok(jlt_periodic_find(map, &orbit, first.doubling.orbit.points, 1, NULL));
        assert_true(side * (orbit.trace + 2) < 0);
    }
    assert_ok(jlt_continuation_switch(&other, &maps, &first.doubling, 1, 0.01, &options));
    assert_int_equal(other.orbit.period, 2);
    assert_near(other.orbit.T, 2 * first.doubling.orbit.T, 0.02);
    assert_ok(jlt_continuation_run(&end, &maps, &other, 1, &options, record, &second));
    assert_true(second.has_fold && second.worst < 1e-11);
    assert_near(second.fold.orbit.trace, 1 + second.fold.orbit.determinant, 1e-6);
    jlt_system_family_clear(&family);
}

/* Oracle: 0.9056 for the Lorenz attractor (Viswanath 1998) within the statistics of 3000 time units; the sum is the constant
 * divergence -41/3 up to the flux at the two ends over t. */
static void exponents_of_the_lorenz_attractor(void **unused)
{
    const jlt_descriptor *d = jlt_descriptor_find("lorenz", NULL, NULL, NULL);
    const jlt_flow options = { .tolerance = 1e-10, .direction = JLT_RISING };
    const double params[3] = { 10, 28, 8. / 3 }, q[2] = { -13.7, -19.5 };
    jlt_lyapunov_state state;
    jlt_system *system;
    jlt_map *map;

    (void)unused;
    assert_ok(jlt_system_plane(&system, d, params, 2, 27, NULL, &options));
    assert_ok(jlt_map_create(&map, &system->flow));
    assert_ok(jlt_lyapunov_run(map, &state, q, 4000, NULL, NULL));
    assert_int_equal(state.returns, 4000);
    assert_near(state.exponents[0], 0.9056, 0.02);
    assert_near(state.sum_check, -41. / 3, 1e-9);
    assert_near(state.exponents[0] + state.exponents[1], -41. / 3, 10 / state.t);
    jlt_map_destroy(map);
    jlt_system_destroy(system);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(branches_are_invariant),
        cmocka_unit_test(stable_branch_mirrors_the_unstable_one),
        cmocka_unit_test(branches_do_not_depend_on_their_company),
        cmocka_unit_test(separatrices_cross_transversally),
        cmocka_unit_test(images_of_crossings_are_crossings),
        cmocka_unit_test(areas_of_lobes_do_not_depend_on_the_polygon),
        cmocka_unit_test(the_default_tolerance_has_the_error_bars_of_its_value),
        cmocka_unit_test(bifurcations_lie_where_multipliers_say),
        cmocka_unit_test(exponents_of_the_lorenz_attractor),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
