/* NaN and both infinities on every number that the library takes: a status says so; nothing is computed with them, and nothing
 * hangs. (For equilibria see test_linearization.c.) */
#include "ride.h"

#include "analysis/linearization.h"
#include "dynamics/branch.h"
#include "dynamics/fates.h"
#include "dynamics/lyapunov.h"
#include "witness/top_section.h"
#include "integrate/batch.h"
#include "kernel/batch_isa.h"
#include "scene/course.h"
#include "top/rod.h"

static const double bad[] = { NAN, INFINITY, -INFINITY };
static const double start[JLT_TOP_STATES] = { 0.2, 0.6, 0.4, 1.3, -0.8 }, point[2] = { 0.44, -0.62 };

#define FOR_BAD(value) for (const double *value = bad; value < bad + 3; value++)
#define assert_refused(call) assert_int_not_equal(call, JLT_OK)

static void orbits_refuse_them(void **unused)
{
    const jlt_event section = { .column = 2 };
    jlt_outcome at;

    (void)unused;
    for (size_t m = 0; jlt_method_at(m) != NULL; m++) FOR_BAD(value) {
        double y[RIDE_COLUMNS], changed[RIDE_COLUMNS];
        jlt_orbit *orbit = NULL;
        ride r;
        ride_open(&r, "five", &top_51, start, jlt_method_at(m), &(jlt_options){ .tolerance = 1e-10 }, +1);
        memcpy(y, r.start, sizeof r.start);
        for (unsigned i = 0; i < r.field.dim; i++) {
            memcpy(changed, y, sizeof changed);
            changed[i] = *value;
            assert_int_equal(jlt_orbit_start(r.orbit, 0, changed, +1), JLT_ERR_NONFINITE);
        }
        assert_int_equal(jlt_orbit_start(r.orbit, *value, y, +1), JLT_ERR_NONFINITE);
        assert_ok(jlt_orbit_start(r.orbit, 0, y, +1));
        if (isnan(*value)) assert_int_equal(jlt_orbit_next(r.orbit, *value, NULL, 0, &at), JLT_ERR_ARG);
        const jlt_event level = { .column = 2, .level = *value };
        assert_int_equal(jlt_orbit_next(r.orbit, 1, &level, 1, &at), JLT_ERR_ARG);
        assert_ok(jlt_orbit_next(r.orbit, INFINITY, &section, 1, &at));
        assert_int_equal(jlt_orbit_create(&orbit, jlt_method_at(m), &r.field, &(jlt_options){ .tolerance = *value }), JLT_ERR_ARG);
        assert_int_equal(jlt_orbit_create(&orbit, jlt_method_at(m), &r.field, &(jlt_options){ .first_step = *value }), JLT_ERR_ARG);
        if (*value < 0 || isnan(*value))
            assert_int_equal(jlt_orbit_create(&orbit, jlt_method_at(m), &r.field, &(jlt_options){ .max_step = *value }),
                             JLT_ERR_ARG);
        ride_close(&r);
    }
}

static jlt_status open_rod(jlt_rod *out, const jlt_descriptor *model, const jlt_top *top, const double *x)
{
    double params[JLT_WAY_VALUES_MAX];

    jlt_top_write(params, model, top);
    return jlt_rod_open(out, model, params, x);
}

static void kernels_and_quadratures_refuse_them(void **unused)
{
    const jlt_descriptor *d = jlt_descriptor_find("spherical_top", NULL, NULL, NULL);
    const double params[] = { 1, 1, 1, 0.3, 0.7, 0.2 };
    const jlt_top rod_top = { 1, 1, 1, 0.3, 0.7, 0 };
    jlt_instance *instance = NULL, *changed_instance = NULL;
    jlt_rod rod;

    (void)unused;
    assert_ok(jlt_instance_create(&instance, d, params));
    FOR_BAD(value) {
        for (int i = 0; i < 6; i++) {
            double changed[6];
            jlt_top top = rod_top;
            memcpy(changed, params, sizeof params);
            changed[i] = *value;
            assert_int_equal(jlt_instance_create(&changed_instance, d, changed), JLT_ERR_NONFINITE);
            assert_null(changed_instance);
            double *const entries[] = { &top.m, &top.R, &top.g, &top.a3, &top.I1, &top.I3 };
            *entries[i] = *value;
            assert_refused(open_rod(&rod, d, &top, start));
        }
        for (int i = 0; i < JLT_TOP_STATES; i++) {
            double changed[JLT_TOP_STATES], out[JLT_TOP_STATES * JLT_TOP_STATES];
            memcpy(changed, start, sizeof start);
            changed[i] = *value;
            assert_int_equal(jlt_instance_rhs(instance, out, changed), JLT_ERR_NONFINITE);
            assert_int_equal(jlt_instance_jacobian(instance, out, changed), JLT_ERR_NONFINITE);
            assert_int_equal(jlt_instance_divergence(instance, out, changed), JLT_ERR_NONFINITE);
            assert_int_equal(open_rod(&rod, d, &rod_top, changed), JLT_ERR_NONFINITE);
        }
        double x[JLT_TOP_STATES];
        assert_ok(open_rod(&rod, d, &rod_top, start));
        assert_refused(jlt_rod_at(&rod, x, *value));
    }
    jlt_instance_destroy(instance);
}

/* A value that is none has a word, and a tolerance that is none a number of steps. */
static void words_and_steps_are_there(void **unused)
{
    (void)unused;
    assert_string_equal(jlt_linearization_verdict((jlt_verdict)77), "unknown verdict");
    assert_string_equal(jlt_linearization_motion((jlt_motion)-1), "unknown motion");
    FOR_BAD(value) assert_in_range(jlt_batch_most_steps(*value), 100, 400);
}

static void sections_and_maps_refuse_them(void **unused)
{
    const jlt_top_values values = jlt_system_top_defaults();
    jlt_system *system = NULL, *changed_system = NULL;
    jlt_section *section = NULL;
    jlt_map *map = NULL;
    jlt_return row;
    jlt_image image;
    jlt_periodic saddle, orbit;
    jlt_fates_end end;
    jlt_lyapunov_state state;
    jlt_branch branch;

    (void)unused;
    assert_ok(jlt_system_top(&system, &values, NULL));
    assert_ok(jlt_section_create(&section, &system->flow));
    assert_ok(jlt_map_create(&map, &system->flow));
    assert_ok(jlt_periodic_find(map, &saddle, (double[2]){ 0, -0.6136 }, 1, NULL));
    FOR_BAD(value) {
        static const char *const names[] = { "m", "R", "g", "I1", "I3", "a3", "E", "G" };
        for (int i = 0; i < 8; i++) {
            jlt_top_values changed = values;
            *jlt_system_top_value(&changed, names[i]) = *value;
            assert_refused(jlt_system_top(&changed_system, &changed, NULL));
            assert_null(changed_system);
        }
        for (int i = 0; i < 2; i++) {
            double q[2] = { point[0], point[1] };
            q[i] = *value;
            assert_refused(jlt_section_start(section, &row, q, 1));
            assert_refused(jlt_map_apply(map, &image, q, 1, 1));
            assert_refused(jlt_map_point(map, &image, q, 1, -1));
            assert_refused(jlt_periodic_find(map, &orbit, q, 1, NULL));
            assert_refused(jlt_fates_follow(section, &end, q, 3));
            assert_refused(jlt_lyapunov_run(map, &state, q, 3, NULL, NULL));
        }
        assert_ok(jlt_section_start(section, &row, point, 1));
        for (int i = 0; i <= JLT_CHART_TOP_S; i++) {
            double x[JLT_CHART_STATES_MAX];
            memcpy(x, row.x, sizeof x);
            x[i] = *value;
            assert_refused(jlt_section_start_state(section, &row, x, 1));
            assert_ok(jlt_section_start(section, &row, point, 1));
        }
        assert_refused(jlt_branch_init(&branch, map, &saddle, false, 1, *value));
        assert_ok(jlt_branch_init(&branch, map, &saddle, false, 1, 1e-4));
        double q[2];
        assert_refused(jlt_branch_point(&branch, q, *value));
        const jlt_flow odd = { .tolerance = *value };
        jlt_system *odd_system = NULL;
        jlt_section *odd_section = NULL;
        if (jlt_system_top(&odd_system, &values, &odd) == JLT_OK)
            assert_refused(jlt_section_create(&odd_section, &odd_system->flow));
        jlt_system_destroy(odd_system);
    }
    jlt_map_destroy(map);
    jlt_section_destroy(section);
    jlt_system_destroy(system);
}

static int no_row(void *context, size_t orbit, size_t number, const double *x)
{
    (void)context, (void)orbit, (void)number, (void)x;
    fail_msg("a row from a start that is no number");
    return 1;
}

static int note_end(void *context, size_t orbit, jlt_lane_end end, size_t returns, const double *x)
{
    (void)orbit, (void)returns, (void)x;
    assert_true(end == JLT_LANE_STALLED || end == JLT_LANE_ROOT);
    ++*(int *)context;
    return 0;
}

static void batches_end_such_lanes_by_name(void **unused)
{
    const double params[] = { 1, 1, 1, 1.0 / 3, 1.0 / 3, 0.51, -0.56 };
    const jlt_descriptor *d = jlt_descriptor_find("spherical_top_level", NULL, "regular", NULL);
    jlt_chart_top chart;
    jlt_instance *instance = NULL;
    double x[5], starts[15][5];
    int ended = 0;

    (void)unused;
    jlt_chart_top_init(&chart, 1, 1, 1, 1.0 / 3, 1.0 / 3, 0.51, 2.15, -0.56);
    assert_ok(chart.base.lift(&chart.base, x, NULL, point));
    for (int i = 0; i < 15; i++) {
        memcpy(starts[i], x, sizeof x);
        starts[i][i % 5] = bad[i / 5];
    }
    assert_ok(jlt_instance_create(&instance, d, params));
    const jlt_batch_map map = { .kernels = jlt_batch_isa_best(d, 0),
                                .cases = &(jlt_batch_case){ .p = instance->prepared },
                                .dim = 5,
                                .column = 2,
                                .direction = 1,
                                .root = 4,
                                .root_floor = 1e-10,
                                .tolerance = 1e-10,
                                .max_steps = 100000 };
    assert_ok(jlt_batch_section(&map, starts[0], 15, 3, no_row, note_end, &ended, NULL));
    assert_int_equal(ended, 15);
    FOR_BAD(value) {
        jlt_batch_map changed = map;
        changed.tolerance = *value;
        assert_int_equal(jlt_batch_section(&changed, starts[0], 1, 3, no_row, note_end, &ended, NULL), JLT_ERR_ARG);
    }
    jlt_instance_destroy(instance);
}

static void scenes_refuse_them(void **unused)
{
    const jlt_descriptor *model = jlt_descriptor_find("spherical_top", NULL, NULL, NULL);
    const double params[] = { 1, 1, 1, 0.3, 0.7, 0.2 };
    static const char *const tiers[] = { "level", "level_plain", "level_omega_n", "level_omega3",
                                         "five",  "five_plain",  "track",         "full" };

    (void)unused;
    for (size_t t = 0; t < sizeof tiers / sizeof *tiers; t++) FOR_BAD(value)
        for (int i = 0; i < 6 + JLT_TOP_STATES; i++) {
            double p[6], x[JLT_TOP_STATES];
            jlt_course *course = NULL;
            jlt_course_row row;
            jlt_plan plan;
            memcpy(p, params, sizeof p);
            memcpy(x, start, sizeof x);
            *(i < 6 ? &p[i] : &x[i - 6]) = *value;
            const jlt_question question = { model, p, x, false, false, tiers[t], NULL };
            jlt_status st = jlt_plan_make(&plan, &question);
            if (st == JLT_OK) st = jlt_course_create(&course, &plan, &question, &(jlt_course_options){ .tolerance = 1e-10 });
            if (st == JLT_OK) st = jlt_course_to(course, 1, &row);
            assert_refused(st);
            jlt_course_destroy(course);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(orbits_refuse_them),
        cmocka_unit_test(kernels_and_quadratures_refuse_them),
        cmocka_unit_test(words_and_steps_are_there),
        cmocka_unit_test(sections_and_maps_refuse_them),
        cmocka_unit_test(batches_end_such_lanes_by_name),
        cmocka_unit_test(scenes_refuse_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
