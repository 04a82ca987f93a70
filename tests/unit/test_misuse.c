/* Arguments outside a contract are refused by JLT_ERR_ARG: times that turn back, names that are not found, options that are no
 * numbers, NULL from another language. Oracle: the comments in the headers. */
#include "unit/check.h"

#include "analysis/charpoly.h"
#include "analysis/density.h"
#include "analysis/linearization.h"
#include "dynamics/lyapunov.h"
#include "dynamics/map_batch.h"
#include "dynamics/orbits.h"
#include "dynamics/section_batch.h"
#include "dynamics/separation.h"
#include "dynamics/surface.h"
#include "integrate/orbit.h"
#include "kernel/batch_isa.h"
#include "kernel/descriptor.h"
#include "kernel/kernel.h"
#include "kernel/load.h"
#include "scene/course.h"
#include "scene/handle.h"
#include "top/top.h"

#define refused(call) assert_int_equal((call), JLT_ERR_ARG)

static void oscillate(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[1];
    out[1] = -x[0];
}

static const double lorenz_params[] = { 10, 28, 8. / 3 }, lorenz_start[] = { 1, 2, 20 };

static const jlt_descriptor *lorenz(void)
{
    return jlt_descriptor_find("lorenz", NULL, NULL, NULL);
}

static void times_do_not_turn_back(void **unused)
{
    const jlt_field field = { .dim = 2, .call = oscillate, .root = -1 };
    const double start[] = { 1, 0 }, nearly = 2 * (1 - 0x1p-53);
    const jlt_event rising = { .column = 0, .direction = JLT_RISING };
    (void)unused;

    for (size_t m = 0; jlt_method_at(m) != NULL; m++)
        for (int direction = -1; direction <= 1; direction += 2) {
            double x[4] = { 7, 7, 7, 7 };
            jlt_orbit *orbit;
            jlt_outcome at;
            size_t done;
            if (jlt_method_at(m)->needs_jet) continue;
            assert_ok(jlt_orbit_create(&orbit, jlt_method_at(m), &field, NULL));
            refused(jlt_orbit_propagate(orbit, direction, x)); /* not started */
            assert_ok(jlt_orbit_start(orbit, 0, start, direction));
            refused(jlt_orbit_propagate(orbit, -direction, x));
            refused(jlt_orbit_sample(orbit, x, &done, (const double[]){ 5 * direction, direction }, 2));
            assert_int_equal(done, 1);
            assert_near(x[0], cos(5), 1e-9);
            assert_near(x[2], 7, 0);
            assert_ok(jlt_orbit_start(orbit, 0, start, direction));
            assert_ok(jlt_orbit_sample(orbit, x, &done, (const double[]){ 2 * direction, nearly * direction }, 2));
            assert_near(x[2], cos(2), 1e-9);
            /* a crossing inside a step, then a time before the step's end, but not before the crossing */
            assert_ok(jlt_orbit_start(orbit, 0, start, direction));
            assert_ok(jlt_orbit_next(orbit, INFINITY, &rising, 1, &at));
            const double crossed = at.t;
            assert_ok(jlt_orbit_propagate(orbit, crossed + 1e-3 * direction, x));
            assert_near(x[0], cos(crossed + 1e-3 * direction), 1e-9);
            refused(jlt_orbit_propagate(orbit, crossed, x));
            jlt_orbit_destroy(orbit);
        }
}

static void fields_events_and_options_are_numbers(void **unused)
{
    const double scale[] = { 1, NAN }, below[] = { 1, -1 };
    jlt_orbit *orbit;
    jlt_outcome at;
    (void)unused;

    refused(jlt_orbit_create(&orbit, NULL, &(jlt_field){ .dim = 2, .call = oscillate, .root = 2 }, NULL));
    refused(jlt_orbit_create(&orbit, NULL, &(jlt_field){ .dim = 2, .call = oscillate, .root = -1, .scale = scale }, NULL));
    refused(jlt_orbit_create(&orbit, NULL, &(jlt_field){ .dim = 2, .call = oscillate, .root = -1, .scale = below }, NULL));
    /* a domain's conditions need gradients; it restricts states that there are */
    const jlt_domain domains[] = { { .states = 2, .conditions = 1, .values = oscillate }, { .states = 2, .conditions = 1 },
                                   { .states = 3, .conditions = 1, .values = oscillate, .gradients = oscillate } };
    for (size_t i = 0; i < sizeof domains / sizeof *domains; i++) {
        const jlt_field restricted = { .dim = 2, .call = oscillate, .root = -1, .domain = domains[i] };
        refused(jlt_orbit_create(&orbit, NULL, &restricted, NULL));
    }
    const jlt_field field = { .dim = 2, .call = oscillate, .root = -1 };
    refused(jlt_orbit_create(&orbit, NULL, &field, &(jlt_options){ .t_last = NAN }));
    assert_ok(jlt_orbit_create(&orbit, NULL, &field, NULL));
    assert_ok(jlt_orbit_start(orbit, 0, (const double[]){ 1, 0 }, 1));
    refused(jlt_orbit_next(orbit, 1, &(jlt_event){ .column = 0, .direction = (jlt_direction)5 }, 1, &at));
    jlt_orbit_destroy(orbit);
}

static void flows_have_a_direction_and_a_time(void **unused)
{
    const jlt_flow flows[] = { { .direction = (jlt_direction)5 }, { .t_max = -1 }, { .t_max = NAN }, { .tolerance = 1 } };
    jlt_section *section;
    jlt_map *map;
    (void)unused;

    for (size_t i = 0; i < sizeof flows / sizeof *flows; i++) {
        jlt_system *system;
        assert_ok(jlt_system_plane(&system, lorenz(), lorenz_params, 2, 27, NULL, &flows[i]));
        refused(jlt_section_create(&section, &system->flow));
        refused(jlt_map_create(&map, &system->flow));
        jlt_system_destroy(system);
    }
    refused(jlt_section_create(&section, NULL));
    refused(jlt_map_create(&map, NULL));
}

/* The section that the tables of a model describe may be another table's; the model's own kernels would follow another motion. */
static void batches_take_the_kernels_of_their_field(void **unused)
{
    const jlt_descriptor *top = jlt_descriptor_find("spherical_top", NULL, NULL, NULL);
    static const double start[] = { 0.1, -0.6 };
    static jlt_surface surface;
    const jlt_claim *broken;
    jlt_section_batch *batch;
    jlt_map_batch *maps;
    jlt_system *system;
    jlt_return row, alone;
    jlt_section *section;
    (void)unused;

    assert_ok(jlt_surface_find(&surface, &broken, top, NULL, NULL));
    assert_ok(jlt_surface_system(&system, &surface, surface.defaults, NULL));
    refused(jlt_section_batch_create(&batch, &system->flow, jlt_batch_isa_best(top, 0), NULL));
    refused(jlt_map_batch_create(&maps, &system->flow, jlt_batch_isa_best(top, 0), NULL, 1));
    refused(jlt_section_batch_create(&batch, NULL, NULL, NULL));
    refused(jlt_map_batch_create(&maps, NULL, NULL, NULL, 1));
    for (unsigned lanes = 2; lanes <= jlt_batch_isa_lanes(); lanes *= 2) {
        assert_ok(jlt_map_batch_create(&maps, &system->flow, jlt_batch_isa_best(system->instance->descriptor, lanes), NULL, 1));
        jlt_map_batch_destroy(maps);
    }
    assert_ok(jlt_section_batch_create(&batch, &system->flow, system->field.batch, NULL)); /* all defaults */
    refused(jlt_section_batch_last(batch, &row, 0)); /* nothing was run */
    assert_ok(jlt_section_batch_run(batch, start, 1, 3));
    refused(jlt_section_batch_start(batch, &row, 1));
    refused(jlt_section_batch_last(batch, &row, 1));
    assert_ok(jlt_section_batch_last(batch, &row, 0));
    assert_ok(jlt_section_create(&section, &system->flow));
    assert_ok(jlt_section_start(section, &alone, start, 1));
    while (alone.number < 3) assert_ok(jlt_section_next(section, &alone));
    assert_near(row.q[0], alone.q[0], 1e-9);
    jlt_section_destroy(section);
    jlt_section_batch_destroy(batch);
    jlt_system_destroy(system);
}

static void a_model_that_is_not_found_is_none(void **unused)
{
    const jlt_descriptor *none = jlt_descriptor_find("no such model", NULL, NULL, NULL), *loaded;
    const jlt_question question = { .model = lorenz(), .params = lorenz_params, .start = lorenz_start };
    const jlt_claim *broken;
    jlt_instance *instance;
    jlt_system *system;
    jlt_course *course;
    jlt_course_row row;
    jlt_units units = { 0 };
    jlt_observed *observed;
    const jlt_region *region;
    jlt_top top;
    double value, x[3];
    size_t index;
    (void)unused;

    static jlt_linearization report;
    static jlt_surface surface;
    static jlt_surface_family family;
    static jlt_plan plan;
    refused(jlt_instance_create(&instance, none, lorenz_params));
    refused(jlt_system_plane(&system, none, lorenz_params, 2, 27, NULL, NULL));
    refused(jlt_descriptor_check_params(none, lorenz_params, &index));
    refused(jlt_descriptor_check_state(none, lorenz_start, &index));
    refused(jlt_region_check(&region, &value, none, lorenz_params, NULL));
    refused(jlt_kernel_prepare_params(&value, none, lorenz_params));
    refused(jlt_instance_units(&units, none, lorenz_params, lorenz_start));
    refused(jlt_observed_create(&observed, none, lorenz_params, &units));
    refused(jlt_linearization_compute(&report, none, lorenz_params, lorenz_start, NULL, NULL, NULL));
    refused(jlt_linearization_find(x, none, lorenz_params, NULL, 0));
    refused(jlt_top_read(&top, none, lorenz_params));
    refused(jlt_surface_find(&surface, &broken, none, NULL, NULL));
    refused(jlt_surface_family_init(&family, none, "E"));
    refused(jlt_surface_family_init(&family, jlt_descriptor_find("spherical_top", NULL, NULL, NULL), NULL));
    refused(jlt_plan_make(&plan, &(jlt_question){ .model = none }));
    refused(jlt_plan_make(&plan, &(jlt_question){ .model = lorenz() }));
    refused(jlt_load(&loaded, NULL));
    refused(jlt_load(&loaded, "libm.so.6"));
    assert_ok(jlt_plan_make(&plan, &question));
    refused(jlt_course_create(&course, &plan, &(jlt_question){ .model = lorenz(), .params = lorenz_params }, NULL));
    assert_ok(jlt_course_create(&course, &plan, &question, NULL)); /* all defaults */
    assert_ok(jlt_course_to(course, 0.5, &row));
    jlt_course_destroy(course);
}

static jlt_status forget(void *count, const jlt_continuation_point *point)
{
    (void)point;
    ++*(size_t *)count;
    return JLT_OK;
}

static void continuation_takes_its_options_as_they_are(void **unused)
{
    const jlt_continuation_options wrong[] = { { .low = 2.2, .high = 2 }, { .low = NAN, .high = 3 }, { .step = -1 },
                                               { .step = NAN }, { .step_min = -1 }, { .step_max = NAN }, { .scale = -1 },
                                               { .low = 2.2, .high = 3 }, { .step = INFINITY }, { .scale = INFINITY } };
    static jlt_continuation_point first = { .value = 2.15 };
    static jlt_surface_family top;
    jlt_system_family systems = { .make = jlt_surface_at, .context = &top };
    const jlt_family family = { jlt_system_map_at, &systems, jlt_system_map_near };
    jlt_continuation_end end;
    jlt_map *map;
    size_t count = 0;
    (void)unused;

    assert_ok(jlt_surface_family_init(&top, jlt_descriptor_find("spherical_top", NULL, NULL, NULL), "E"));
    assert_ok(family.map_at(family.context, &map, first.value));
    assert_ok(jlt_periodic_find(map, &first.orbit, (const double[]){ 0, -0.61 }, 1, NULL));
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        refused(jlt_continuation_run(&end, &family, &first, -1, &wrong[i], forget, &count));
    assert_int_equal(count, 0);
    assert_ok(jlt_continuation_run(&end, &family, &first, -1, &(jlt_continuation_options){ .points_max = 3 }, forget, &count));
    assert_int_equal(end, JLT_CONTINUATION_POINTS); /* without ends */
    assert_true(count >= 3);
    jlt_system_family_clear(&systems);
}

static void a_search_has_starts(void **unused)
{
    const jlt_orbits_options wrong[] = {
        { .period_max = 0 },
        { .period_max = 1, .counts = { 2 }, .high = { 1, 1 } },
        { .period_max = 1, .counts = { 2, 2 }, .low = { NAN }, .high = { 1, 1 } },
        { .period_max = 1, .counts = { 2, 2 }, .high = { 1, INFINITY } },
        { .period_max = 1, .counts = { 2, 2 }, .high = { 1, 1 }, .near = -1 },
        { .period_max = 1, .counts = { SIZE_MAX / 2, 3 }, .high = { 1, 1 } },
        { .period_max = 1, .counts = { 2, 2 }, .high = { 1, 1 }, .settle = SIZE_MAX },
    };
    jlt_orbits found = { .count = 0 };
    jlt_system *system;
    jlt_map *map;
    (void)unused;

    assert_ok(jlt_system_plane(&system, lorenz(), lorenz_params, 2, 27, NULL, NULL));
    assert_ok(jlt_map_create(&map, &system->flow));
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) refused(jlt_orbits_search(&found, map, &wrong[i]));
    refused(jlt_orbits_search(&found, map, NULL));
    jlt_map_destroy(map);
    jlt_system_destroy(system);
}

/* The region of a separation is none, or its cells or returns are more than can be counted; and so are signs that are none. */
static void cells_cover_a_region(void **unused)
{
    const jlt_separation_options right = { .low = { -1, -1 }, .high = { 1, 1 }, .cells = { 4, 4 }, .returns = 2 };
    jlt_separation_options wrong[9];
    jlt_separation rows[48];
    const jlt_claim *broken;
    jlt_surface surface;
    jlt_system *system, *none;
    size_t count;
    (void)unused;

    for (size_t i = 0; i < 9; i++) wrong[i] = right;
    wrong[0].cells[0] = wrong[0].cells[1] = SIZE_MAX / 2;
    wrong[1].cells[0] = wrong[1].cells[1] = (size_t)1 << 32;
    wrong[2].low[0] = NAN;
    wrong[3].low[1] = 1;
    wrong[4].high[0] = -2;
    wrong[5].high[1] = INFINITY;
    wrong[6].returns = 0;
    wrong[7].returns = SIZE_MAX;
    wrong[8].settle = SIZE_MAX;
    assert_ok(jlt_surface_find(&surface, &broken, jlt_descriptor_find("spherical_top", NULL, NULL, NULL), NULL, NULL));
    assert_ok(jlt_surface_system(&system, &surface, surface.defaults, &(jlt_flow){ .direction = JLT_RISING }));
    for (size_t i = 0; i < 9; i++)
        refused(jlt_separation_measure(rows, &count, &system->flow, (const double[]){ 0.1, -0.6 }, 1, &wrong[i]));
    assert_ok(jlt_separation_measure(rows, &count, &system->flow, (const double[]){ 0.1, -0.6 }, 1, &right));
    jlt_system_destroy(system);
    refused(jlt_system_plane(&none, lorenz(), lorenz_params, 2, 27, (const int[]){ -1, 0, 3 }, NULL));
}

static void batches_know_their_flows_and_returns(void **unused)
{
    const double q[] = { -13, -19, 1, 2 };
    const size_t flows[] = { 0, 1 }, none[] = { 0, 1 }, many[] = { 3, 1 };
    jlt_section_batch *batch;
    jlt_map_batch *maps;
    jlt_map_images images;
    jlt_lyapunov_state states[2];
    jlt_status each[2];
    jlt_system *system;
    (void)unused;

    assert_ok(jlt_system_plane(&system, lorenz(), lorenz_params, 2, 27, NULL, NULL));
    assert_ok(jlt_section_batch_create(&batch, &system->flow, NULL, NULL));
    assert_ok(jlt_map_batch_create(&maps, &system->flow, NULL, NULL, 1));
    assert_ok(jlt_map_batch_images(&images, 2, 2));
    refused(jlt_section_batch_run_each(batch, q, flows, NULL, 2, 2));
    refused(jlt_section_batch_run_each(batch, q, NULL, none, 2, 2));
    refused(jlt_section_batch_run_each(batch, q, NULL, many, 2, 2));
    refused(jlt_map_batch_apply_flows(maps, &images, q, flows, 2, 1, NULL, NULL));
    refused(jlt_lyapunov_run_each(maps, states, each, q, flows, 2, 0, 1));
    refused(jlt_lyapunov_run_each(maps, states, each, q, none, 1, SIZE_MAX, 2));
    jlt_map_batch_images_clear(&images);
    jlt_map_batch_destroy(maps);
    jlt_section_batch_destroy(batch);
    jlt_system_destroy(system);
}

static void polynomials_have_coefficients(void **unused)
{
    double coefficients[3] = { 7, 7, 7 };
    (void)unused;

    assert_int_equal(jlt_charpoly_from_roots(coefficients, NULL, (const double[]){ 1e200, 1e200 }, (const double[]){ 0, 0 }, 2),
                     JLT_ERR_NONFINITE);
    assert_near(coefficients[2], 7, 0);
}

static void a_density_is_along_a_state(void **unused)
{
    jlt_density_point points[2];
    jlt_instance *instance;
    (void)unused;
    assert_ok(jlt_instance_create(&instance, lorenz(), lorenz_params));
    refused(jlt_density_tabulate(points, 2, instance, 3, 0, 1, lorenz_start));
    jlt_instance_destroy(instance);
}

static void handles_take_null_and_names_once(void **unused)
{
    const char *twice[] = { "rho", "rho" }, *null[] = { NULL };
    const double values[] = { 20, 30 };
    jlt_handle_section *section;
    jlt_handle_motion *motion;
    double x[3], t[1];
    size_t done;
    int fate;
    (void)unused;

    refused(jlt_handle_motion_create(&motion, NULL, NULL, NULL, 0, 0));
    refused(jlt_handle_motion_create(&motion, "lorenz", NULL, values, 1, 0));
    refused(jlt_handle_motion_create(&motion, "lorenz", twice, NULL, 1, 0));
    refused(jlt_handle_motion_create(&motion, "lorenz", null, values, 1, 0));
    refused(jlt_handle_motion_create(&motion, "lorenz", twice, values, 2, 0));
    refused(jlt_handle_section_known(&section, NULL, NULL, NULL, 0, 0));
    refused(jlt_handle_section_known(&section, "spherical_top", null, values, 1, 0));
    refused(jlt_handle_section_plane(&section, NULL, "z", 27, 1, NULL, NULL, 0, 0));
    refused(jlt_handle_section_plane(&section, "lorenz", NULL, 27, 1, NULL, NULL, 0, 0));
    refused(jlt_handle_section_plane(&section, "lorenz", "z", 27, 1, twice, values, 2, 0));
    assert_null(section); /* as Python has it where the status was not looked at */
    refused(jlt_handle_section_start(section, values, 1));
    refused(jlt_handle_section_returns(section, x, t, NULL, &done, &fate, 1));
    assert_int_equal(jlt_handle_section_dim(section) + jlt_handle_section_columns(section), 0);
    assert_null(jlt_handle_section_coordinate(section, 0));
    assert_null(jlt_handle_section_column(section, 0));
    refused(jlt_handle_motion_start(NULL, lorenz_start));
    refused(jlt_handle_motion_states(NULL, x, t, &done, &fate, values, 1));
    assert_int_equal(jlt_handle_motion_dim(NULL), 0);
    assert_null(jlt_handle_motion_state(NULL, 0));
    assert_ok(jlt_handle_section_plane(&section, "lorenz", "z", 27, 1, NULL, NULL, 0, 0));
    refused(jlt_handle_section_start(section, NULL, 1));
    assert_ok(jlt_handle_section_start(section, (const double[]){ -13, -19 }, 1));
    refused(jlt_handle_section_returns(section, NULL, t, NULL, &done, &fate, 1));
    jlt_handle_section_destroy(section);
    assert_ok(jlt_handle_motion_create(&motion, "lorenz", NULL, NULL, 0, 0));
    refused(jlt_handle_motion_start(motion, NULL));
    assert_ok(jlt_handle_motion_start(motion, lorenz_start));
    refused(jlt_handle_motion_states(motion, x, t, &done, &fate, NULL, 1));
    jlt_handle_motion_destroy(motion);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(times_do_not_turn_back),
        cmocka_unit_test(fields_events_and_options_are_numbers),
        cmocka_unit_test(flows_have_a_direction_and_a_time),
        cmocka_unit_test(batches_take_the_kernels_of_their_field),
        cmocka_unit_test(a_model_that_is_not_found_is_none),
        cmocka_unit_test(continuation_takes_its_options_as_they_are),
        cmocka_unit_test(a_search_has_starts),
        cmocka_unit_test(cells_cover_a_region),
        cmocka_unit_test(batches_know_their_flows_and_returns),
        cmocka_unit_test(polynomials_have_coefficients),
        cmocka_unit_test(a_density_is_along_a_state),
        cmocka_unit_test(handles_take_null_and_names_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
