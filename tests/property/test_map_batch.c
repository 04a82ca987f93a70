/* Return maps and derivatives of many points at once: against quadruple precision, against one point at a time, and against
 * themselves in other company. */
#include "unit/check.h"

#include <stdio.h>
#include <stdlib.h>

#include "dynamics/lyapunov.h"
#include "dynamics/periodic.h"
#include "dynamics/surface.h"
#include "kernel/batch_isa.h"
#include "kernel/descriptor.h"
#include "top/top.h"

enum { POINTS_MAX = 512 };

typedef struct {
    double q[2 * POINTS_MAX], slope[4 * POINTS_MAX], T[POINTS_MAX], determinant[POINTS_MAX], expansion[POINTS_MAX],
        defect[POINTS_MAX];
    jlt_status status[POINTS_MAX];
} images;

static jlt_system *system_51(double tolerance)
{
    const jlt_flow flow = { .tolerance = tolerance, .direction = JLT_RISING };
    const jlt_claim *broken;
    jlt_surface surface;
    jlt_system *system;

    assert_ok(jlt_surface_find(&surface, &broken, jlt_descriptor_find(JLT_DEFAULT_MODEL, NULL, NULL, NULL), NULL, NULL));
    assert_ok(jlt_surface_system(&system, &surface, surface.defaults, &flow));
    return system;
}

static void apply(images *out, const jlt_system *system, const jlt_kernel_batch *kernels, unsigned threads, const double *q,
                  size_t count, size_t returns)
{
    const jlt_map_images into = { out->status, out->q, out->slope, out->T, out->determinant, out->expansion, out->defect, NULL };
    jlt_map_batch *batch;

    assert_true(count <= POINTS_MAX);
    assert_ok(jlt_map_batch_create(&batch, &system->flow, kernels, NULL, threads));
    assert_ok(jlt_map_batch_apply(batch, &into, q, count, returns, 1));
    jlt_map_batch_destroy(batch);
}

static const jlt_kernel_batch *best(const jlt_system *system) { return jlt_batch_isa_best(system->instance->descriptor, 0); }

/* DP of 64 points of a regular island, relative to its largest entry. A step errs by a tolerance in states and tangent vectors;
 * there are 100 steps at most, and DP's entries reach 3 from tangent vectors of 1: errors of a step are amplified by no more than
 * 10. Rounding:
 * 100 steps of 15 stages, whose weights are at most 3, so that 1e-13 holds at any tolerance. */
static void derivatives_match_quadruple_precision(void **unused)
{
    static const double tolerance[] = { 1e-7, 1e-10, 1e-12, 1e-14 };
    static double row[POINTS_MAX][10], q[2 * POINTS_MAX];
    static images out;
    size_t rows = 0;
    char line[1024];
    FILE *file = fopen(JLT_SOURCE_DIR "/tests/reference/data/slopes_regular_51.csv", "r");

    (void)unused;
    assert_non_null(file);
    assert_non_null(fgets(line, sizeof line, file));
    while (fgets(line, sizeof line, file) != NULL) {
        double *r = row[rows++];
        assert_int_equal(sscanf(line, "%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf", r, r + 1, r + 2, r + 3, r + 4, r + 5, r + 6, r + 7,
                                r + 8, r + 9),
                         10);
        memcpy(q + 2 * (rows - 1), r + 1, 2 * sizeof *q);
    }
    fclose(file);
    for (int i = 0; i < 4; i++) {
        jlt_system *system = system_51(tolerance[i]);
        const double bound = 1000 * tolerance[i] + 1e-13;
        double worst = 0;
        apply(&out, system, best(system), 1, q, rows, 1);
        for (size_t k = 0; k < rows; k++) {
            double size = 0, off = 0;
            assert_ok(out.status[k]);
            for (unsigned j = 0; j < 4; j++) {
                size = fmax(size, fabs(row[k][6 + j]));
                off = fmax(off, fabs(out.slope[4 * k + j] - row[k][6 + j]));
            }
            worst = fmax(worst, off / size);
            assert_near(out.q[2 * k], row[k][3], bound);
            assert_near(out.q[2 * k + 1], row[k][4], bound);
            assert_near(out.T[k], row[k][5], bound);
            assert_below(fabs(out.defect[k]), bound);
            assert_near(out.determinant[k], out.slope[4 * k] * out.slope[4 * k + 3] - out.slope[4 * k + 1] * out.slope[4 * k + 2],
                        1e-14 * size * size);
        }
        print_message("tolerance %g: DP is off by %.1e\n", tolerance[i], worst);
        assert_below(worst, bound);
        jlt_system_destroy(system);
    }
}

/* The whole section: regular and chaotic orbits, some that end at a pole, and points that are none. */
static size_t whole_section(double *q)
{
    size_t count = 0;

    for (int i = 0; i < 20; i++)
        for (int j = 0; j < 20; j++) {
            q[2 * count] = -3.1 + 0.31 * i;
            q[2 * count++ + 1] = -0.999 + 0.0999 * j;
        }
    return count;
}

static void assert_same_image(const images *a, size_t i, const images *b, size_t j)
{
    assert_int_equal(a->status[i], b->status[j]);
    if (a->status[i] != JLT_OK) return;
    assert_memory_equal(a->q + 2 * i, b->q + 2 * j, 2 * sizeof *a->q);
    assert_memory_equal(a->slope + 4 * i, b->slope + 4 * j, 4 * sizeof *a->slope);
    assert_memory_equal(a->T + i, b->T + j, sizeof *a->T);
    assert_memory_equal(a->determinant + i, b->determinant + j, sizeof *a->T);
    assert_memory_equal(a->expansion + i, b->expansion + j, sizeof *a->T);
    assert_memory_equal(a->defect + i, b->defect + j, sizeof *a->T);
}

static void images_do_not_depend_on_company_order_or_threads(void **unused)
{
    static double q[2 * POINTS_MAX], backwards[2 * POINTS_MAX];
    static images together, threaded, reversed, alone;
    static const double tolerance[] = { 1e-5, 1e-11 };
    const size_t count = whole_section(q), returns = 3;

    (void)unused;
    for (size_t i = 0; i < count; i++) memcpy(backwards + 2 * i, q + 2 * (count - 1 - i), 2 * sizeof *q);
    for (int t = 0; t < 2; t++) {
        jlt_system *system = system_51(tolerance[t]);
        for (int isa = 0; isa < JLT_ISA_COUNT; isa++) {
            const jlt_kernel_batch *kernels = system->instance->descriptor->batches[isa];
            if (!jlt_batch_isa_runs(kernels)) continue;
            apply(&together, system, kernels, 1, q, count, returns);
            apply(&threaded, system, kernels, 3, q, count, returns);
            apply(&reversed, system, kernels, 2, backwards, count, returns);
            for (size_t i = 0; i < count; i++) {
                assert_same_image(&together, i, &threaded, i);
                assert_same_image(&together, i, &reversed, count - 1 - i);
            }
            for (size_t i = 0; i < count; i += 37) {
                apply(&alone, system, kernels, 1, q + 2 * i, 1, returns);
                assert_same_image(&together, i, &alone, 0);
            }
        }
        jlt_system_destroy(system);
    }
}

/* Fates are those of one point at a time, but where an orbit comes as near to a pole or to the section's edge as methods may
 * differ; images differ by what DP makes of the errors of both. */
static void images_are_those_of_one_point_at_a_time(void **unused)
{
    static double q[2 * POINTS_MAX];
    static images out;
    static jlt_image image;
    const size_t count = whole_section(q);
    size_t other = 0, made = 0;
    jlt_system *system = system_51(1e-12);
    jlt_map *map;

    (void)unused;
    assert_ok(jlt_map_create(&map, &system->flow));
    apply(&out, system, best(system), 2, q, count, 1);
    for (size_t i = 0; i < count; i++) {
        const jlt_status st = jlt_map_apply(map, &image, q + 2 * i, 1, 1);
        double size = 1;
        other += st != out.status[i];
        if (st != JLT_OK || out.status[i] != JLT_OK) continue;
        made++;
        for (unsigned k = 0; k < 4; k++) size = fmax(size, fabs(image.slope[k]));
        /* An error of the states at the return, which DP's size tells, moves DP by its second derivatives: by its size once
         * more. */
        const double error = 1e-10 * size;
        for (unsigned k = 0; k < 4; k++) assert_near(out.slope[4 * i + k], image.slope[k], error * size);
        assert_near(out.q[2 * i + 1], image.q[1], error);
        assert_near(remainder(out.q[2 * i] - image.q[0], 2 * 3.14159265358979323846), 0, error);
        assert_near(out.T[i], image.T, error);
        assert_near(out.expansion[i], image.expansion, error);
    }
    print_message("%zu of %zu return, %zu with another fate\n", made, count, other);
    assert_int_equal(other, 0);
    assert_true(made > count / 4);
    jlt_map_destroy(map);
    jlt_system_destroy(system);
}

/* With an end in time no lanes go: the images are those of a jlt_map, bit for bit. */
static void points_that_no_lane_serves_go_by_themselves(void **unused)
{
    static double q[2 * POINTS_MAX];
    static images out;
    static jlt_image image;
    jlt_system *system = system_51(1e-8);
    jlt_map *map;

    (void)unused;
    whole_section(q);
    system->flow.t_max = 5;
    assert_ok(jlt_map_create(&map, &system->flow));
    apply(&out, system, best(system), 2, q, 40, 2);
    for (unsigned i = 0; i < 40; i++) {
        const jlt_status st = jlt_map_apply(map, &image, q + 2 * i, 2, 1);
        assert_int_equal(out.status[i], st);
        if (st != JLT_OK) continue;
        assert_memory_equal(out.q + 2 * i, image.q, 2 * sizeof *q);
        assert_memory_equal(out.slope + 4 * i, image.slope, 4 * sizeof *q);
        assert_memory_equal(out.T + i, &image.T, sizeof *q);
        assert_memory_equal(out.determinant + i, &image.determinant, sizeof *q);
        assert_memory_equal(out.expansion + i, &image.expansion, sizeof *q);
    }
    jlt_map_destroy(map);
    jlt_system_destroy(system);
}

/* Each point with returns and a direction of its own, by two threads, against all of them that way: the same bits. */
static void images_do_not_depend_on_the_ways_of_others(void **unused)
{
    static double q[2 * POINTS_MAX];
    static images mixed, alone;
    size_t returns[POINTS_MAX];
    int way[POINTS_MAX];
    jlt_system *system = system_51(1e-12);
    const jlt_map_images into = {
        mixed.status, mixed.q, mixed.slope, mixed.T, mixed.determinant, mixed.expansion, mixed.defect, NULL
    };
    const jlt_map_images one = {
        alone.status, alone.q, alone.slope, alone.T, alone.determinant, alone.expansion, alone.defect, NULL
    };
    const size_t count = whole_section(q);
    jlt_map_batch *batch;

    (void)unused;
    assert_ok(jlt_map_batch_create(&batch, &system->flow, best(system), NULL, 2));
    for (size_t i = 0; i < count; i++) {
        returns[i] = i % 3;
        way[i] = i % 5 < 2 ? -1 : 1;
    }
    assert_ok(jlt_map_batch_apply_each(batch, &into, q, count, returns, way));
    for (int direction = -1; direction <= 1; direction += 2)
        for (size_t made = 1; made <= 2; made++) {
            assert_ok(jlt_map_batch_apply(batch, &one, q, count, made, direction));
            for (size_t i = 0; i < count; i++)
                if (way[i] == direction && returns[i] == made) assert_same_image(&mixed, i, &alone, i);
        }
    for (size_t i = 0; i < count; i += 3) assert_memory_equal(mixed.q + 2 * i, q + 2 * i, 2 * sizeof *q);
    way[7] = 0;
    assert_int_equal(jlt_map_batch_apply_each(batch, &into, q, count, returns, way), JLT_ERR_ARG);
    jlt_map_batch_destroy(batch);
    jlt_system_destroy(system);
}

enum { FLOWS = 3, ORBITS = 24, RETURNS = 40, SKIPPED = 3 };

/* The sphere's section under parameters, and on levels, of their own; with other masses in other units. */
static void several_systems(jlt_system **systems)
{
    const jlt_flow flow = { .tolerance = 1e-11, .direction = JLT_RISING };
    const jlt_claim *broken;
    jlt_surface surface;

    assert_ok(jlt_surface_find(&surface, &broken, jlt_descriptor_find(JLT_DEFAULT_MODEL, NULL, NULL, NULL), NULL, NULL));
    for (unsigned k = 0; k < FLOWS; k++) {
        double values[JLT_CHART_VALUES_MAX];
        memcpy(values, surface.defaults, sizeof values);
        values[jlt_surface_value(&surface, "a3")] -= 0.02 * k;
        values[jlt_surface_value(&surface, "E")] += 0.01 * k;
        assert_ok(jlt_surface_system(&systems[k], &surface, values, &flow));
    }
}

static void images_of_several_flows_are_those_of_each(void **unused)
{
    static double q[2 * POINTS_MAX];
    static images mixed, alone;
    jlt_system *systems[FLOWS];
    size_t flow_of[POINTS_MAX], index;
    const jlt_map_images into = {
        mixed.status, mixed.q, mixed.slope, mixed.T, mixed.determinant, mixed.expansion, mixed.defect, NULL
    };
    const size_t count = whole_section(q);
    jlt_map_batch *batch;

    (void)unused;
    several_systems(systems);
    for (size_t i = 0; i < count; i++) flow_of[i] = i % 7 % FLOWS;
    for (int isa = 0; isa <= JLT_ISA_COUNT; isa++) { /* the last without kernels */
        const jlt_kernel_batch *kernels = isa < JLT_ISA_COUNT ? systems[0]->instance->descriptor->batches[isa] : NULL;
        if (kernels != NULL && !jlt_batch_isa_runs(kernels)) continue;
        assert_ok(jlt_map_batch_create(&batch, &systems[0]->flow, kernels, NULL, 1 + (unsigned)isa % 2));
        for (size_t k = 1; k < FLOWS; k++) {
            assert_ok(jlt_map_batch_add(batch, &index, &systems[k]->flow));
            assert_int_equal(index, k);
        }
        assert_ok(jlt_map_batch_apply_flows(batch, &into, q, flow_of, count, 2, NULL, NULL));
        jlt_map_batch_destroy(batch);
        for (size_t k = 0; k < FLOWS; k++) {
            apply(&alone, systems[k], kernels, 1, q, count, 2);
            for (size_t i = 0; i < count; i++)
                if (flow_of[i] == k) assert_same_image(&mixed, i, &alone, i);
        }
    }
    for (size_t k = 0; k < FLOWS; k++) jlt_system_destroy(systems[k]);
}

/* On the regular island an orbit's error grows no faster than its returns: over 43 of them, each of which errs by 1000 tolerances
 * at most (see above), 4e-7 in the point; DP is off by that times its slopes, some 10, and so is the growth of each return, whose
 * mean over t, more than a unit of time a return, is what is compared. */
static void exponents_of_several_flows_are_those_of_each(void **unused)
{
    jlt_system *systems[FLOWS];
    jlt_lyapunov_state together[ORBITS], alone, single;
    jlt_status statuses[ORBITS], status;
    double q[2 * ORBITS];
    size_t flow_of[ORBITS], index;
    jlt_map_batch *batch, *own;
    jlt_image image;
    jlt_map *map;

    (void)unused;
    several_systems(systems);
    assert_ok(jlt_map_batch_create(&batch, &systems[0]->flow, best(systems[0]), NULL, 2));
    for (size_t k = 1; k < FLOWS; k++) assert_ok(jlt_map_batch_add(batch, &index, &systems[k]->flow));
    for (size_t i = 0; i < ORBITS; i++) {
        q[2 * i] = i == 5 ? 2 : 0.42 + 0.001 * (double)i; /* one ends at a pole */
        q[2 * i + 1] = i == 5 ? -0.5 : -0.62;
        flow_of[i] = i % FLOWS;
    }
    assert_ok(jlt_lyapunov_run_each(batch, together, statuses, q, flow_of, ORBITS, SKIPPED, RETURNS));
    jlt_map_batch_destroy(batch);
    assert_int_not_equal(statuses[5], JLT_OK);
    for (size_t i = 0; i < ORBITS; i++) {
        const jlt_system *system = systems[flow_of[i]];
        assert_ok(jlt_map_batch_create(&own, &system->flow, best(system), NULL, 1));
        assert_ok(jlt_lyapunov_run_each(own, &alone, &status, q + 2 * i, &(size_t){ 0 }, 1, SKIPPED, RETURNS));
        jlt_map_batch_destroy(own);
        assert_int_equal(status, statuses[i]);
        assert_int_equal(alone.returns, together[i].returns);
        assert_memory_equal(alone.exponents, together[i].exponents, 2 * sizeof *alone.exponents);
        assert_memory_equal(&alone.t, &together[i].t, sizeof alone.t);
        assert_memory_equal(&alone.sum_check, &together[i].sum_check, sizeof alone.t);
        if (status != JLT_OK) continue;
        assert_ok(jlt_map_create(&map, &system->flow));
        assert_ok(jlt_map_point(map, &image, q + 2 * i, SKIPPED, 1));
        assert_ok(jlt_lyapunov_run(map, &single, image.q, RETURNS, NULL, NULL));
        jlt_map_destroy(map);
        assert_int_equal(single.returns, alone.returns);
        assert_near(single.t, alone.t, 4e-7);
        for (unsigned k = 0; k < 2; k++) assert_near(single.exponents[k], alone.exponents[k], 4e-6);
        assert_near(single.sum_check, alone.sum_check, 4e-6);
    }
    for (size_t k = 0; k < FLOWS; k++) jlt_system_destroy(systems[k]);
}

/* On a periodic orbit the finite-time exponents are its multipliers' logarithms: the 2-norm is that of DP^n. */
static void exponents_of_a_periodic_orbit_are_its_multipliers(void **unused)
{
    jlt_system *system = system_51(1e-13);
    const double guess[] = { 0, -0.6136 };
    double exponent;
    images out;
    const jlt_map_images into = { out.status, out.q, out.slope, out.T, out.determinant, out.expansion, out.defect, NULL };
    jlt_saddle_watch passed;
    jlt_periodic saddle;
    jlt_map *map;
    jlt_map_batch *maps;

    (void)unused;
    assert_ok(jlt_map_create(&map, &system->flow));
    assert_ok(jlt_map_batch_create(&maps, &system->flow, NULL, NULL, 1));
    assert_ok(jlt_periodic_find(map, &saddle, guess, 1, NULL));
    const double *a = saddle.slope;
    const double square = a[0] * a[0] + a[1] * a[1] + a[2] * a[2] + a[3] * a[3], det = a[0] * a[3] - a[1] * a[2];
    assert_ok(jlt_lyapunov_finite_each(maps, &exponent, &into, &passed, saddle.points, 1, 1));
    assert_true(fabs(out.T[0] - saddle.T) <= 1e-12);
    assert_true(fabs(exponent * out.T[0] - log((square + sqrt(square * square - 4 * det * det)) / 2) / 2) <= 1e-12);
    jlt_map_batch_destroy(maps);
    jlt_map_destroy(map);
    jlt_system_destroy(system);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(derivatives_match_quadruple_precision),
        cmocka_unit_test(images_do_not_depend_on_company_order_or_threads),
        cmocka_unit_test(images_do_not_depend_on_the_ways_of_others),
        cmocka_unit_test(images_are_those_of_one_point_at_a_time),
        cmocka_unit_test(points_that_no_lane_serves_go_by_themselves),
        cmocka_unit_test(images_of_several_flows_are_those_of_each),
        cmocka_unit_test(exponents_of_several_flows_are_those_of_each),
        cmocka_unit_test(exponents_of_a_periodic_orbit_are_its_multipliers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
