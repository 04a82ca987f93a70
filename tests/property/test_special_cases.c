/* I3 = 0 and a3 = 0: quadratures, levels and fixed points against integration and against the generated kernels. */
#include "unit/check.h"

#include "core/random.h"
#include "kernel/descriptor.h"
#include "kernel/instance.h"
#include "scene/course.h"
#include "top/balanced.h"
#include "top/rod.h"

enum { STATES = JLT_TOP_STATES, TRIALS = 40 };

static const double pi = 3.14159265358979323846;

static jlt_top random_top(jlt_random *random)
{
    return (jlt_top){ .m = jlt_random_between(random, 0.5, 2), .R = jlt_random_between(random, 0.5, 2),
                      .g = jlt_random_between(random, 0, 3), .a3 = jlt_random_between(random, -0.4, 0.4),
                      .I1 = jlt_random_between(random, 0.2, 1), .I3 = jlt_random_between(random, 0.2, 1) };
}

static void random_state(double *x, jlt_random *random)
{
    x[0] = jlt_random_between(random, -0.8, 0.8);
    for (int i = 1; i < STATES; i++) x[i] = jlt_random_between(random, -1.5, 1.5);
}

static void integrate(double *out, const jlt_top *top, const double *start, double t)
{
    const double params[] = { top->m, top->R, top->g, top->a3, top->I1, top->I3 };
    const jlt_question question = { jlt_descriptor_find("spherical_top", NULL, NULL, NULL), params, start, false, false,
                                    "five", NULL };
    jlt_plan plan;
    jlt_course *course = NULL;
    jlt_course_row row;

    assert_int_equal(jlt_plan_make(&plan, &question), JLT_OK);
    assert_int_equal(jlt_course_create(&course, &plan, &question, &(jlt_course_options){ .tolerance = 1e-15 }), JLT_OK);
    assert_int_equal(jlt_course_to(course, t, &row), JLT_OK);
    assert_int_equal(row.end, JLT_END_TIME);
    memcpy(out, row.x, STATES * sizeof *out);
    jlt_course_destroy(course);
}

static jlt_status open_rod(jlt_rod *out, const jlt_top *top, const double *x)
{
    const jlt_descriptor *model = jlt_descriptor_find(JLT_DEFAULT_MODEL, NULL, NULL, NULL);
    double params[JLT_WAY_VALUES_MAX];

    jlt_top_write(params, model, top);
    return jlt_rod_open(out, model, params, x);
}

/* Over one period of the quadrature the integrated tilt comes back and (v_nu, v_tau) has turned by the quadrature's angle.
 * Budget 1e-12, as asked for; orbits with a turning point within 0.1 of a pole lose more in the integration, and are left out. */
static void rod_period_and_rotation_by_quadrature_are_those_of_integration(void **unused)
{
    jlt_random random;
    int tried = 0;

    (void)unused;
    jlt_random_seed(&random, 1);
    while (tried < TRIALS) {
        jlt_top top = random_top(&random);
        double x[STATES], end[STATES];
        jlt_rod orbit;
        top.I3 = 0;
        random_state(x, &random);
        assert_int_equal(open_rod(&orbit, &top, x), JLT_OK);
        if (orbit.below < 0.1 || orbit.above < 0.1) continue;
        tried++;
        integrate(end, &top, x, orbit.period);
        assert_true(fabs(end[JLT_TOP_GAMMA3] - x[JLT_TOP_GAMMA3]) <= 1e-12);
        assert_true(fabs(end[JLT_TOP_OMEGA_TAU] - x[JLT_TOP_OMEGA_TAU]) <= 1e-12 * (1 + orbit.E2));
        const double turn = atan2(jlt_top_v_tau(&top, end), end[JLT_TOP_V_NU])
                            - atan2(jlt_top_v_tau(&top, x), x[JLT_TOP_V_NU]);
        assert_true(fabs(remainder(turn - orbit.turn, 2 * pi)) <= 1e-12 * (1 + fabs(orbit.turn)));
        assert_true(jlt_rod_rotation(&orbit) == orbit.turn / (2 * pi));
    }
}

/* Remark 2: on E1 = 0, that is v_nu = v_tau = 0, every orbit is periodic. */
static void rod_orbits_without_translation_are_periodic(void **unused)
{
    jlt_random random;

    (void)unused;
    jlt_random_seed(&random, 2);
    for (int trial = 0; trial < TRIALS; trial++) {
        jlt_top top = random_top(&random);
        double x[STATES], end[STATES];
        jlt_rod orbit;
        top.I3 = 0;
        random_state(x, &random);
        x[JLT_TOP_V_NU] = 0;
        x[JLT_TOP_OMEGA3] = -(top.a3 + top.R * x[0]) * x[JLT_TOP_OMEGA_N] / (top.R * jlt_top_sine(x[0]));
        assert_int_equal(open_rod(&orbit, &top, x), JLT_OK);
        if (orbit.below < 0.1 || orbit.above < 0.1) continue;
        assert_true(orbit.E1 <= 1e-30);
        integrate(end, &top, x, orbit.period);
        for (int i = 0; i < STATES; i++) assert_true(fabs(end[i] - x[i]) <= 1e-11);
    }
}

/* At a relative equilibrium both turning points are the start, a double root, and the period is that of small oscillations:
 * D gamma3'' = P'/2, with P = 2 (1 - gamma3^2) (E2 - m g a3 gamma3) - c. Turning points are known to some roundings of 1. */
static void rod_stays_at_relative_equilibria(void **unused)
{
    const jlt_top top = { 1, 1, 1, 0.3, 0.7, 0 };
    jlt_rod orbit;

    (void)unused;
    for (int i = 1; i < 9; i++) {
        const double gamma3 = -0.05 * i, E2 = top.a3 * (3 * gamma3 * gamma3 - 1) / (2 * gamma3); /* P' = 0 */
        const double x[STATES] = { gamma3, 0.6, 0, sqrt(2 * (E2 - top.a3 * gamma3) / top.I1), 0 };
        const double D = top.I1 + top.a3 * top.a3 * (1 - gamma3 * gamma3);
        assert_int_equal(open_rod(&orbit, &top, x), JLT_OK);
        assert_true(fabs(orbit.E2 - E2) <= 1e-15 * E2);
        assert_true(fabs(orbit.below - (1 + gamma3)) <= 1e-15 && fabs(orbit.above - (1 - gamma3)) <= 1e-15);
        assert_true(fabs(orbit.period / (2 * pi * sqrt(D / (2 * E2 - 6 * top.a3 * gamma3))) - 1) <= 1e-14);
    }
}

/* Hanging in a plane but for omega_n = 1e-12, it passes beside the pole at 1e-12 of the swing: half a turn, but for about as much.
 * A period is half a pendulum's, by whose series it is longer by at most twice the swing's s^2. */
static void rod_that_swings_beside_the_pole_turns_by_half(void **unused)
{
    (void)unused;
    for (double below = 1e-10; below < 1e-3; below *= 10)
        for (double side = -1; side <= 1; side += 2) {
            const jlt_top top = { 1, 1, 1, -0.51 * side, 0.7, 0 };
            const double x[STATES] = { side * (1 - below), 0.6, 0, 1e-12, 0 }, small = pi * sqrt(top.I1 / fabs(top.a3));
            jlt_rod orbit;
            assert_int_equal(open_rod(&orbit, &top, x), JLT_OK);
            assert_true(fabs(fabs(jlt_rod_rotation(&orbit)) - 0.5) <= 1e-14);
            assert_true(fabs(orbit.period / small - 1) <= 1e-14 + 4 * below);
        }
}

static void rod_refuses_what_it_does_not_describe(void **unused)
{
    const double x[STATES] = { 0.2, 0.6, 0.4, 1.3, -0.8 }, flat[STATES] = { 0.2, 0.6, 0.4, 0, -0.8 };
    const jlt_top heavy = { 1, 1, 1, 0.3, 0.7, 0.1 }, light = { 1, 1, 1, 0.3, 0.7, 0 };
    jlt_rod orbit;

    (void)unused;
    assert_int_equal(open_rod(&orbit, &heavy, x), JLT_ERR_ARG);
    assert_int_equal(open_rod(&orbit, &light, flat), JLT_ERR_DOMAIN);
}

static double relative(double a, double b)
{
    return fabs(a - b) / fmax(1, fabs(b));
}

static void levels_and_coordinates_on_the_balanced_surface_are_inverse(void **unused)
{
    jlt_random random;

    (void)unused;
    jlt_random_seed(&random, 3);
    for (int trial = 0; trial < 1000; trial++) {
        jlt_top top = random_top(&random);
        double x[STATES], back[STATES], gamma3, v_slip, psi;
        jlt_balanced_levels levels, completed;
        top.a3 = 0;
        random_state(x, &random);
        jlt_balanced_levels_of(&levels, &top, x);
        completed = levels;
        completed.M = 0;
        assert_int_equal(jlt_balanced_complete(&completed, &top), JLT_OK);
        assert_true(fabs(completed.M * completed.M - levels.M * levels.M) <= 1e-13 * (1 + levels.M * levels.M + levels.E));
        jlt_balanced_from_state(&top, &gamma3, &v_slip, &psi, x);
        jlt_balanced_to_state(&top, &levels, back, gamma3, jlt_top_sine(gamma3), v_slip, psi);
        for (int i = 0; i < STATES; i++) assert_true(relative(back[i], x[i]) <= 1e-13);
    }
    jlt_balanced_levels none = { .E = 0.1, .G = 5, .F0 = 0 };
    assert_int_equal(jlt_balanced_complete(&none, &(jlt_top){ 1, 1, 1, 0, 0.4, 0.25 }), JLT_ERR_EMPTY);
}

/* Fixed points in closed form: the generated field vanishes there, the levels are those asked for, and trace and determinant
 * of the two remaining eigenvalues are those of the generated Jacobian (its trace, and the sum of its principal minors). */
static void balanced_fixed_points_are_those_of_the_field(void **unused)
{
    const jlt_descriptor *model = jlt_descriptor_find("spherical_top", NULL, NULL, NULL);
    jlt_random random;
    size_t found = 0, attracting = 0, repelling = 0;

    (void)unused;
    jlt_random_seed(&random, 4);
    for (int trial = 0; trial < 500; trial++) {
        jlt_top top = random_top(&random);
        double x[STATES], f[STATES], J[STATES * STATES];
        jlt_balanced_levels levels, there;
        jlt_fixed_point points[4];
        jlt_instance *instance = NULL;
        unsigned count;
        top.a3 = 0;
        const double params[] = { top.m, top.R, top.g, top.a3, top.I1, top.I3 };
        random_state(x, &random);
        x[JLT_TOP_OMEGA_TAU] = x[JLT_TOP_OMEGA_N] = 0; /* a level that has one */
        if (trial % 5 == 0) x[JLT_TOP_GAMMA3] = 0;     /* G = 0 */
        if (fabs(x[0]) < 0.05 && x[0] != 0) continue;
        jlt_balanced_levels_of(&levels, &top, x);
        assert_int_equal(jlt_balanced_fixed_points(points, &count, &top, &levels), JLT_OK);
        assert_true(count == 2 || count == 4);
        assert_int_equal(jlt_instance_create(&instance, model, params), JLT_OK);
        bool met = false;
        for (unsigned k = 0; k < count; k++) {
            const jlt_fixed_point *p = &points[k];
            double worst = 0, trace = 0, minors = 0;
            assert_int_equal(jlt_instance_rhs(instance, f, p->x), JLT_OK);
            for (int i = 0; i < STATES; i++) assert_true(f[i] == 0);
            jlt_balanced_levels_of(&there, &top, p->x);
            assert_true(relative(there.E, levels.E) <= 1e-11 && relative(there.G, levels.G) <= 1e-11
                        && relative(there.F0, levels.F0) <= 1e-11);
            assert_int_equal(jlt_instance_jacobian(instance, J, p->x), JLT_OK);
            for (int i = 0; i < STATES; i++) {
                trace += J[i * STATES + i];
                for (int j = 0; j < i; j++) minors += J[i * STATES + i] * J[j * STATES + j] - J[i * STATES + j] * J[j * STATES + i];
                worst = fmax(worst, fabs(p->x[i] - x[i]));
            }
            met = met || worst <= 1e-9;
            assert_true(relative(p->trace, trace) <= 1e-13 && relative(p->determinant, minors) <= 1e-12);
            assert_true(relative(p->re[0] + p->re[1], trace) <= 1e-13);
            assert_true(relative(p->re[0] * p->re[1] - p->im[0] * p->im[1], minors) <= 1e-12);
            attracting += p->kind == JLT_FIXED_ATTRACTING;
            repelling += p->kind == JLT_FIXED_REPELLING;
        }
        assert_true(met);
        found += count;
        jlt_instance_destroy(instance);
    }
    assert_true(found > 1000);
    assert_true(attracting == repelling); /* images of each other under the reversor */
}

/* A start near an attracting fixed point comes nearer, at the rate of the real part; backwards in time it is the repelling
 * one that attracts. */
static void attracting_fixed_points_attract(void **unused)
{
    const jlt_top top = { 1, 1, 1, 0, 0.4, 0.25 };
    const double x[STATES] = { 0.5, 0.8, 0, 0, 0.9 };
    double start[STATES], end[STATES];

    (void)unused;
    for (int side = -1; side <= 1; side += 2) {
        jlt_balanced_levels levels;
        jlt_fixed_point points[4];
        unsigned count;
        double gamma3, v_slip, psi, before = 0, after = 0;
        jlt_balanced_levels_of(&levels, &top, x);
        assert_int_equal(jlt_balanced_fixed_points(points, &count, &top, &levels), JLT_OK);
        unsigned k = 0;
        while (points[k].kind != (side > 0 ? JLT_FIXED_ATTRACTING : JLT_FIXED_REPELLING)) k++;
        jlt_balanced_from_state(&top, &gamma3, &v_slip, &psi, points[k].x);
        gamma3 += 1e-4;
        v_slip = copysign(jlt_balanced_slip(&top, &levels, gamma3, jlt_top_sine(gamma3), psi), v_slip);
        jlt_balanced_to_state(&top, &levels, start, gamma3, jlt_top_sine(gamma3), v_slip, psi);
        integrate(end, &top, start, side * 40.0);
        for (int i = 0; i < STATES; i++) {
            before = fmax(before, fabs(start[i] - points[k].x[i]));
            after = fmax(after, fabs(end[i] - points[k].x[i]));
        }
        /* exp(-0.5 |trace| 40) with a factor of ten for the shape of the spiral */
        assert_true(after <= 10 * before * exp(-20 * fabs(points[k].trace)));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rod_period_and_rotation_by_quadrature_are_those_of_integration),
        cmocka_unit_test(rod_orbits_without_translation_are_periodic),
        cmocka_unit_test(rod_stays_at_relative_equilibria),
        cmocka_unit_test(rod_that_swings_beside_the_pole_turns_by_half),
        cmocka_unit_test(rod_refuses_what_it_does_not_describe),
        cmocka_unit_test(levels_and_coordinates_on_the_balanced_surface_are_inverse),
        cmocka_unit_test(balanced_fixed_points_are_those_of_the_field),
        cmocka_unit_test(attracting_fixed_points_attract),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
