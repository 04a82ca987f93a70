/* The chart of the section and the return map of the spherical top, over random parameters, levels and starts. */
#include "unit/check.h"

#include "core/random.h"
#include "dynamics/map.h"
#include "witness/top_section.h"
#include "kernel/descriptor.h"

enum { SYSTEMS = 40 };

/* A random top with a nonempty section and a point on it, away from the poles. */
static jlt_system *random_system(double q[2], jlt_random *random)
{
    for (;;) {
        const jlt_flow options = { .tolerance = 1e-13, .direction = JLT_RISING };
        jlt_system *system;
        jlt_top_values v = { .m = jlt_random_between(random, 0.5, 2), .R = jlt_random_between(random, 0.5, 2) };
        double low, high;
        v.g = jlt_random_between(random, 0.5, 10);
        v.I1 = jlt_random_between(random, 0.1, 1);
        v.I3 = jlt_random_between(random, 0.1, 1);
        v.a3 = jlt_random_between(random, -0.9, 0.9) * v.R;
        v.E = jlt_random_between(random, 0, 20);
        v.G = jlt_random_between(random, -2, 2);
        if (jlt_system_top(&system, &v, &options) != JLT_OK) continue;
        assert_true(jlt_surface_interval(system, 1, &low, &high));
        q[0] = jlt_random_between(random, -3.1, 3.1);
        q[1] = low + (high - low) * jlt_random_between(random, 0.1, 0.9);
        return system;
    }
}

/* Oracle: the generated energy integral; the paper's formula for eta, in omega3; Jellett's integral in omega_n and omega3. */
static void chart_lies_on_its_levels_and_agrees_with_the_paper(void **unused)
{
    jlt_random random;
    double q[2], back[2], x[5];

    (void)unused;
    jlt_random_seed(&random, 1);
    for (int i = 0; i < SYSTEMS; i++) {
        jlt_system *system = random_system(q, &random);
        const jlt_chart *chart = &jlt_surface_chart(system)->base;
        const jlt_descriptor *d = system->instance->descriptor;
        const jlt_top_values v = jlt_system_top_values(system);
        double values[8], omega_n, omega3, s, b, Theta, eta;
        size_t energy = 0;

        assert_ok(chart->lift(chart, x, NULL, q));
        chart->lower(chart, back, NULL, x);
        assert_near(back[0], q[0], 1e-13);
        assert_near(back[1], q[1], 0);
        assert_true(d->integral_count <= 8);
        jlt_instance *kernel;
        assert_ok(jlt_instance_create(&kernel, d, system->instance->params));
        d->integral_values.call(x, kernel->prepared, values);
        jlt_instance_destroy(kernel);
        while (strcmp(d->integrals[energy].name, "E") != 0) energy++;
        assert_near(values[energy], v.E, 1e-12 * (1 + fabs(v.E)));
        jlt_chart_top_rotation(jlt_system_top_chart(system), &omega_n, &omega3, x);
        s = sqrt(1 - q[1] * q[1]);
        b = v.a3 + v.R * q[1];
        Theta = v.I1 * v.I3 + v.I1 * v.m * v.R * v.R * s * s + v.I3 * v.m * b * b;
        assert_near(v.I1 * v.R * s * omega_n - v.I3 * b * omega3, v.G, 1e-12 * (1 + fabs(v.G)));
        eta = atan2(v.m * v.I1 * v.R * s * x[JLT_CHART_TOP_V_NU],
                    sqrt(Theta * (Theta - v.I1 * v.I3)) * (omega3 + v.m * v.G * b / (Theta - v.I1 * v.I3)));
        assert_near(eta, q[0], 1e-11);
        jlt_system_destroy(system);
    }
}

/* Oracle: the chart typed by hand from the paper. Slopes are compared along directions that keep gamma3^2 + s^2 = 1, for off it the
 * two differ. States are of the size 10 and slopes of 1000 with s > 0.01: some 100 roundings of that, relative to s. */
static void the_tables_chart_is_that_of_the_witness(void **unused)
{
    static const double rounding = 100 * 1000 * 2.3e-16 / 0.01;
    jlt_random random;
    double q[2];

    (void)unused;
    jlt_random_seed(&random, 5);
    for (int i = 0; i < SYSTEMS; i++) {
        jlt_system *system = random_system(q, &random);
        const jlt_chart *chart = &jlt_surface_chart(system)->base, *witness = &jlt_system_top_chart(system)->base;
        double x[5], tangent[10], lowered[2], slope[10], x_there[5], tangent_there[10], lowered_there[2], slope_there[10], way[5];

        assert_int_equal(chart->dim, witness->dim);
        assert_int_equal(chart->reversible, witness->reversible);
        for (unsigned k = 0; k < 2; k++) {
            assert_string_equal(chart->names[k], witness->names[k]);
            assert_int_equal(chart->mirror[k], witness->mirror[k]);
            assert_near(chart->period[k], witness->period[k], 0);
        }
        assert_ok(chart->lift(chart, x, tangent, q));
        assert_ok(witness->lift(witness, x_there, tangent_there, q));
        for (unsigned k = 0; k < 5; k++) assert_near(x[k], x_there[k], rounding);
        for (unsigned k = 0; k < 10; k++) assert_near(tangent[k], tangent_there[k], rounding * (1 + fabs(tangent_there[k])));
        for (unsigned k = 0; k < 4; k++) way[k] = jlt_random_between(&random, -1, 1);
        way[4] = -x[0] / x[4] * way[0];
        chart->lower(chart, lowered, slope, x);
        witness->lower(witness, lowered_there, slope_there, x);
        for (unsigned j = 0; j < 2; j++) {
            double here = 0, there = 0;
            assert_near(lowered[j], lowered_there[j], rounding);
            for (unsigned k = 0; k < 5; k++) here += slope[5 * j + k] * way[k], there += slope_there[5 * j + k] * way[k];
            assert_near(here, there, rounding * (1 + fabs(there)));
        }
        assert_near(chart->flux(chart, x, way), witness->flux(witness, x, way),
                    rounding * (1 + fabs(witness->flux(witness, x, way))));
        jlt_system_destroy(system);
    }
}

/* Oracle: the paper's normal reaction, from the two multipliers of the full system; here it comes from the height alone. */
static void contact_force_is_that_of_the_full_system(void **unused)
{
    jlt_random random;
    double q[2], x[5];

    (void)unused;
    jlt_random_seed(&random, 2);
    for (int i = 0; i < SYSTEMS; i++) {
        jlt_system *system = random_system(q, &random);
        const jlt_chart *chart = &jlt_surface_chart(system)->base;
        const jlt_top_values v = jlt_system_top_values(system);
        double omega_n, omega3, s, D, N;
        jlt_observed *observed;

        assert_ok(chart->lift(chart, x, NULL, q));
        x[JLT_CHART_TOP_OMEGA_TAU] = jlt_random_between(&random, -2, 2);
        assert_ok(jlt_observed_create(&observed, system->instance->descriptor, system->instance->params, &(jlt_units){ 0 }));
        jlt_chart_top_rotation(jlt_system_top_chart(system), &omega_n, &omega3, x);
        s = x[JLT_CHART_TOP_S];
        D = v.I1 + v.m * v.a3 * v.a3 * s * s;
        N = v.m *
            (v.I1 * v.g - v.a3 * (v.I1 * q[1] * (omega_n * omega_n + x[2] * x[2]) + v.I3 * s * omega3 * omega_n)) / D;
        const double bound = 1e-11 * (1 + fabs(N) + omega_n * omega_n + omega3 * omega3);
        _Alignas(64) double eight[5 * 8];
        double forces[8];
        assert_near(jlt_observed_least(observed, NULL, x), N, bound);
        for (int k = 0; k < 40; k++) eight[k] = x[k / 8];
        jlt_observed_condition_values(&(jlt_observed_one){ observed, 0 }, forces, eight);
        for (int k = 0; k < 8; k++) assert_near(forces[k], N, bound);
        jlt_observed_destroy(observed);
        jlt_system_destroy(system);
    }
}

/* P(q), or false where the orbit ends, comes near a pole or grazes. */
static bool image(jlt_map *map, jlt_image *out, const double *q, int direction)
{
    return jlt_map_apply(map, out, q, 1, direction) == JLT_OK && out->x[JLT_CHART_TOP_S] > 0.02 && fabs(out->T) > 0.05;
}

static double largest(const jlt_image *at)
{
    double norm = 1;

    for (int i = 0; i < 4; i++) norm = fmax(norm, fabs(at->slope[i]));
    return norm;
}

/* Oracle: central differences of the map itself. Their error is h^2 times a third derivative, which grows as a power of the
 * first, and rounding over h: 1e-5 relative to a cube of the slope with h = 1e-5. */
static void derivative_agrees_with_differences(void **unused)
{
    const double h = 1e-5;
    jlt_random random;
    double q[2];
    int compared = 0;

    (void)unused;
    jlt_random_seed(&random, 3);
    for (int i = 0; i < SYSTEMS; i++) {
        jlt_system *system = random_system(q, &random);
        jlt_image at, above, below;
        jlt_map *map;

        assert_ok(jlt_map_create(&map, &system->flow));
        for (int k = 0; image(map, &at, q, 1) && largest(&at) < 30 && k < 2; k++) {
            double up[2] = { q[0], q[1] }, down[2] = { q[0], q[1] }, difference[2];
            up[k] += h;
            down[k] -= h;
            if (!image(map, &above, up, 1) || !image(map, &below, down, 1)) break;
            jlt_chart_difference(system->flow.chart, difference, above.q, below.q);
            for (int j = 0; j < 2; j++)
                assert_near(difference[j] / (2 * h), at.slope[2 * j + k], 1e-5 * pow(largest(&at), 3));
            compared++;
        }
        jlt_map_destroy(map);
        jlt_system_destroy(system);
    }
    assert_true(compared > SYSTEMS / 2);
}

/* det DP = flux(start)/flux(end) exp(integral of the divergence), exactly: what is left is the tolerance over some hundred
 * steps, relative to the size of DP. */
static void determinant_is_flux_and_divergence(void **unused)
{
    jlt_random random;
    double q[2];
    int compared = 0;

    (void)unused;
    jlt_random_seed(&random, 4);
    for (int i = 0; i < SYSTEMS; i++) {
        jlt_system *system = random_system(q, &random);
        jlt_image at;
        jlt_map *map;

        assert_ok(jlt_map_create(&map, &system->flow));
        for (int direction = -1; direction <= 1; direction += 2) {
            if (!image(map, &at, q, direction)) continue;
            assert_true(fabs(at.defect) < 1e-10);
            compared++;
        }
        jlt_map_destroy(map);
        jlt_system_destroy(system);
    }
    assert_true(compared > SYSTEMS / 2);
}

/* With R the reversor on the section, R P R P = identity, and going back undoes going forth. */
static void reversor_turns_the_map_into_its_inverse(void **unused)
{
    jlt_random random;
    double q[2];
    int compared = 0;

    (void)unused;
    jlt_random_seed(&random, 5);
    for (int i = 0; i < SYSTEMS; i++) {
        jlt_system *system = random_system(q, &random);
        const jlt_chart *chart = system->flow.chart;
        jlt_image first, there, back;
        double mirrored[2];
        jlt_map *map;

        assert_ok(jlt_map_create(&map, &system->flow));
        /* a start may cross downwards: its first return lies in the map's domain */
        if (image(map, &first, q, 1) && image(map, &there, first.q, 1) && largest(&there) < 1000 &&
            fabs(there.determinant) > 1e-3) {
            jlt_chart_mirror(chart, mirrored, there.q);
            assert_ok(jlt_map_apply(map, &back, mirrored, 1, 1));
            jlt_chart_mirror(chart, mirrored, back.q);
            assert_true(jlt_chart_distance(chart, mirrored, first.q) < 1e-11 * largest(&there) / fabs(there.determinant));
            assert_ok(jlt_map_apply(map, &back, there.q, 1, -1));
            assert_true(jlt_chart_distance(chart, back.q, first.q) < 1e-11 * largest(&there) / fabs(there.determinant));
            compared++;
        }
        jlt_map_destroy(map);
        jlt_system_destroy(system);
    }
    assert_true(compared > SYSTEMS / 4);
}

/* Levels without a state, and points at or beyond a pole, are refused by name. */
static void empty_levels_and_poles_are_refused(void **unused)
{
    const double at_pole[2] = { 0, 1 }, beyond[2] = { 0, -1.5 }, not_a_number[2] = { NAN, 0 };
    jlt_top_values v = jlt_system_top_defaults();
    jlt_system *system;
    jlt_section *section;

    (void)unused;
    v.E = -5;
    assert_int_equal(jlt_system_top(&system, &v, NULL), JLT_ERR_EMPTY);
    assert_null(system);
    v.E = 0.4;
    assert_ok(jlt_system_top(&system, &v, NULL));
    assert_ok(jlt_section_create(&section, &system->flow));
    assert_int_equal(jlt_section_start(section, NULL, (double[2]){ 0, 0.5 }, 1), JLT_ERR_EMPTY);
    assert_int_equal(jlt_section_start(section, NULL, at_pole, 1), JLT_ERR_DOMAIN);
    assert_int_equal(jlt_section_start(section, NULL, beyond, 1), JLT_ERR_DOMAIN);
    assert_int_equal(jlt_section_start(section, NULL, not_a_number, 1), JLT_ERR_NONFINITE);
    jlt_section_destroy(section);
    jlt_system_destroy(system);
}

static void time_runs_forwards_or_backwards_and_at_no_other_rate(void **unused)
{
    const double q[2] = { 0.1, -0.6 };
    const jlt_top_values v = jlt_system_top_defaults();
    jlt_system *system;
    jlt_section *section;

    (void)unused;
    assert_ok(jlt_system_top(&system, &v, NULL));
    assert_ok(jlt_section_create(&section, &system->flow));
    for (int direction = -3; direction <= 3; direction++)
        assert_int_equal(jlt_section_start(section, NULL, q, direction), direction == 1 || direction == -1 ? JLT_OK : JLT_ERR_ARG);
    jlt_section_destroy(section);
    jlt_system_destroy(system);
}

static const double rounding = 1e-7;

static bool holds(const jlt_system *system, double gamma3)
{
    return jlt_chart_section_holds(jlt_surface_chart(system), (const double[2]){ 0, gamma3 });
}

/* The ends of the interval are neighbours of numbers without a state, or next to a pole, and are the ends of its widest part. The
 * witness rounds in another way, 20 roundings or so of W^2, and near a double zero of that its roots are off by the root of it. */
static void the_interval_ends_where_the_levels_do(void **unused)
{
    jlt_random random;

    (void)unused;
    jlt_random_seed(&random, 11);
    for (int k = 0; k < 10 * SYSTEMS; k++) {
        double q[2], low, high, witness_low, witness_high;
        jlt_system *system = random_system(q, &random);
        const jlt_chart_top *chart = jlt_system_top_chart(system);
        assert_true(jlt_surface_interval(system, 1, &low, &high) && low < high);
        assert_true(holds(system, low) && holds(system, high));
        assert_true(low == -1 + 1e-9 || !holds(system, nextafter(low, -2)));
        assert_true(high == 1 - 1e-9 || !holds(system, nextafter(high, 2)));
        assert_true(jlt_chart_top_interval(chart, &witness_low, &witness_high));
        assert_near(low, witness_low, rounding);
        assert_near(high, witness_high, rounding);
        jlt_system_destroy(system);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(chart_lies_on_its_levels_and_agrees_with_the_paper),
        cmocka_unit_test(the_tables_chart_is_that_of_the_witness),
        cmocka_unit_test(contact_force_is_that_of_the_full_system),
        cmocka_unit_test(derivative_agrees_with_differences),
        cmocka_unit_test(determinant_is_flux_and_divergence),
        cmocka_unit_test(reversor_turns_the_map_into_its_inverse),
        cmocka_unit_test(empty_levels_and_poles_are_refused),
        cmocka_unit_test(time_runs_forwards_or_backwards_and_at_no_other_rate),
        cmocka_unit_test(the_interval_ends_where_the_levels_do),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
