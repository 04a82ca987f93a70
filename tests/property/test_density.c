/* Densities of invariant measures from the divergence alone, at random parameters. Oracle: the closed forms, typed in here. */
#include "unit/check.h"

#include "analysis/density.h"
#include "kernel/descriptor.h"

enum { M, R, G, A3, I1, I3, PARAMS };

static jlt_instance *bind(const double *params)
{
    jlt_instance *instance = NULL;

    assert_ok(jlt_instance_create(&instance,
                                  jlt_descriptor_choose(jlt_descriptor_find("spherical_top", NULL, NULL, NULL), NULL, NULL, params),
                                  params));
    return instance;
}

/* rho = s (I1 + m a3^2 s^2) when I3 = 0. Tolerance: the quadrature's own estimate and a few roundings a panel. */
static void the_rod_has_the_density_of_euler_and_jacobi(void **unused)
{
    jlt_random random;

    (void)unused;
    jlt_random_seed(&random, 21);
    for (int trial = 0; trial < 20; trial++) {
        double params[PARAMS], x[5] = { 0, 0.6, 0.4, 1.3, -0.8 }, defect;
        jlt_density_point points[21];
        jlt_instance *instance;
        for (int i = 0; i < PARAMS; i++) params[i] = jlt_random_magnitude(&random, -1, 1);
        params[I3] = 0.0;
        instance = bind(params);
        assert_string_equal(instance->descriptor->variant, "rod");
        assert_ok(jlt_density_defect(&defect, instance, 0, &random));
        assert_below(defect, 1e-12);
        assert_ok(jlt_density_tabulate(points, 21, instance, 0, -0.999, 0.999, x));
        for (int i = 0; i < 21; i++) {
            const double c = points[i].at, s2 = (1 - c) * (1 + c);
            const double rho = sqrt(s2) * (params[I1] + params[M] * params[A3] * params[A3] * s2) /
                               (params[I1] + params[M] * params[A3] * params[A3]);
            assert_near(points[i].density / rho, 1.0, points[i].error + 1e-13);
        }
        jlt_instance_destroy(instance);
    }
}

/* With I3 > 0 the ratio depends on the other states, by an amount that goes to zero with I3 and not before. */
static void no_density_of_gamma3_alone_exists_with_axial_inertia(void **unused)
{
    jlt_random random;
    double last = 2.0;

    (void)unused;
    for (int exponent = 0; exponent <= 8; exponent += 2) {
        const double params[PARAMS] = { 1, 1, 1, 0.51, 1.0 / 3, pow(10.0, -exponent) };
        jlt_instance *instance = bind(params);
        double defect;
        jlt_random_seed(&random, 22);
        assert_ok(jlt_density_defect(&defect, instance, 0, &random));
        assert_true(defect > JLT_DENSITY_TOLERANCE);
        last = defect;
        jlt_instance_destroy(instance);
    }
    assert_below(last, 1e-2);
}

/* A quadrature that changes its mind about direction or normalization would show here. */
static void tables_are_one_in_the_middle_and_symmetric_about_it(void **unused)
{
    const double params[PARAMS] = { 1, 1, 1, 0.51, 1.0 / 3, 0.0 };
    jlt_instance *instance = bind(params);
    double x[5] = { 0, 0.6, 0.4, 1.3, -0.8 };
    jlt_density_point points[5], even[4];

    (void)unused;
    assert_ok(jlt_density_tabulate(points, 5, instance, 0, -0.8, 0.8, x));
    assert_true(points[2].density == 1.0 && points[2].error == 0.0);
    assert_near(points[0].density, points[4].density, 1e-13);
    assert_ok(jlt_density_tabulate(even, 4, instance, 0, -0.8, 0.8, x));
    assert_true(even[2].density == 1.0);
    jlt_instance_destroy(instance);
}

static void the_table_s_density_has_no_divergence(void **unused)
{
    const double params[PARAMS] = { 1.3, 0.7, 9.8, -0.12, 0.29, 0.0 };
    jlt_instance *instance = bind(params);
    jlt_random random;
    double residual[8];

    (void)unused;
    jlt_random_seed(&random, 23);
    assert_int_equal(instance->descriptor->measure_count, 1);
    assert_ok(jlt_density_residual(residual, instance, 2000, &random));
    assert_below(residual[0], 1e-13);
    jlt_instance_destroy(instance);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_rod_has_the_density_of_euler_and_jacobi),
        cmocka_unit_test(no_density_of_gamma3_alone_exists_with_axial_inertia),
        cmocka_unit_test(tables_are_one_in_the_middle_and_symmetric_about_it),
        cmocka_unit_test(the_table_s_density_has_no_divergence),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
