/* Every tier gives the same motion as the tiers above it, and all of them the quadruple-precision reference. */
#include "unit/check.h"

#include <stdio.h>
#include <stdlib.h>

#include "kernel/descriptor.h"
#include "kernel/observed.h"
#include "scene/course.h"
#include "top/top.h"

enum { ROWS_MAX = 16, STATES = JLT_TOP_STATES };

/* m, R, g, a3, I1, I3: the order of the table */
typedef struct {
    double params[6], start[STATES];
    double times[ROWS_MAX];
    size_t count;
} orbit;

static const orbit generic = { { 1.3, 0.7, 9.81, -0.12, 0.29, 0.21 }, { 0.25, 0.8, -0.6, 1.1, -2.3 }, { 0.5, 1, 1.5 }, 3 };
static const orbit rod = { { 1, 1, 1, 0.3, 0.7, 0 }, { 0.2, 0.6, 0.4, 1.3, -0.8 }, { 1, 3, 10 }, 3 };
static const orbit balanced = { { 1, 1, 1, 0, 0.4, 0.25 }, { 0.3, 0.5, 0.2, 0.3, 0.9 }, { 1, 5, 20 }, 3 };
static const orbit flat = { { 1, 1, 1, 0, 0.25, 0.4 }, { 0.3, -1.5, 0.2, 0.3, 0.2 }, { 1, 5, 20 }, 3 };
static const orbit equal_moments = { { 1, 1, 1, 0, 0.4, 0.4 }, { 0.3, 0.5, 0.2, 0.3, 0.9 }, { 1, 5, 20 }, 3 };

/* How a tier tells where the sphere is and how it stands, by the names of its quantities. */
enum { ATTITUDE = 12 };
static const char *const attitude_names[ATTITUDE] = { "x", "y", "x_contact", "y_contact", "alpha1", "alpha2", "alpha3",
                                                      "beta1", "beta2", "beta3", "gamma1", "gamma2" };

static void tell(double *attitude, const jlt_course *course, const jlt_course_row *row)
{
    const jlt_quantity *more;
    const unsigned count = jlt_course_tells_more(course, &more, NULL);

    for (unsigned k = 0; k < ATTITUDE; k++) {
        unsigned i = 0;
        while (i < count && strcmp(more[i].name, attitude_names[k]) != 0) i++;
        assert_true(i < count);
        attitude[k] = row->more[i];
    }
}

/* States at the times, shape (count, STATES); attitudes, shape (count, ATTITUDE), when wanted. */
static void follow(double *states, double *attitudes, const orbit *o, const char *tier, double tolerance)
{
    const jlt_descriptor *model = jlt_descriptor_find("spherical_top", NULL, NULL, NULL);
    const jlt_question question = { model, o->params, o->start, attitudes != NULL, false, tier, NULL };
    jlt_plan plan;
    jlt_course *course = NULL;
    jlt_course_row row;

    assert_int_equal(jlt_plan_make(&plan, &question), JLT_OK);
    assert_int_equal(jlt_course_create(&course, &plan, &question, &(jlt_course_options){ .tolerance = tolerance }), JLT_OK);
    for (size_t i = 0; i < o->count; i++) {
        assert_int_equal(jlt_course_to(course, o->times[i], &row), JLT_OK);
        assert_int_equal(row.end, JLT_END_TIME);
        memcpy(states + i * STATES, row.x, STATES * sizeof *states);
        if (attitudes != NULL) tell(attitudes + i * ATTITUDE, course, &row);
    }
    jlt_course_destroy(course);
}

static double distance(const double *a, const double *b, size_t count)
{
    double worst = 0;

    for (size_t i = 0; i < count; i++) worst = fmax(worst, fabs(a[i] - b[i]));
    return worst;
}

static void compare(const orbit *o, const char *tier, const char *above, double bound)
{
    double a[ROWS_MAX * STATES], b[ROWS_MAX * STATES];

    follow(a, NULL, o, tier, 1e-13);
    follow(b, NULL, o, above, 1e-13);
    if (!(distance(a, b, o->count * STATES) <= bound))
        fail_msg("%s differs from %s by %.3g", tier, above, distance(a, b, o->count * STATES));
}

/* Bound: 200 steps of local error 1e-13, amplified by less than ten over these orbits (seen by moving the start). */
static const double bound = 2e-11;

static void each_tier_agrees_with_the_tier_above_it(void **unused)
{
    (void)unused;
    compare(&rod, "quadrature", "level", bound);
    compare(&balanced, "plane", "balanced", bound);
    compare(&balanced, "balanced", "level", bound);
    compare(&flat, "plane", "balanced", bound);
    compare(&flat, "balanced", "level", bound);
    compare(&equal_moments, "plane", "balanced", bound);
    compare(&equal_moments, "balanced", "level", bound);
    compare(&generic, "level", "five", bound);
    compare(&rod, "level", "five", bound);
    compare(&generic, "level_plain", "level", bound);
    compare(&generic, "five_plain", "five", bound);
    compare(&generic, "five", "track", bound);
    compare(&generic, "track", "full", bound);
    compare(&balanced, "track", "full", bound);
}

/* Reads rows t, five states; returns their number. */
static size_t read_reference(double (*rows)[1 + STATES], const char *name)
{
    char path[512], line[1024];
    size_t count = 0;
    FILE *file;

    snprintf(path, sizeof path, "%s/tests/reference/data/%s", JLT_SOURCE_DIR, name);
    file = fopen(path, "r");
    assert_non_null(file);
    assert_non_null(fgets(line, sizeof line, file));
    while (count < ROWS_MAX && fgets(line, sizeof line, file) != NULL) {
        char *at = line;
        for (size_t k = 0; k < 1 + STATES; k++) {
            rows[count][k] = strtod(at, &at);
            if (*at == ',') at++;
        }
        count++;
    }
    fclose(file);
    return count;
}

/* Error against the reference over rows 1 .. last. */
static double reference_error(const orbit *o, double (*rows)[1 + STATES], size_t last, const char *tier, double tolerance)
{
    orbit here = *o;
    double states[ROWS_MAX * STATES], worst = 0;

    memcpy(here.start, rows[0] + 1, sizeof here.start);
    here.count = last;
    for (size_t i = 0; i < last; i++) here.times[i] = rows[1 + i][0];
    follow(states, NULL, &here, tier, tolerance);
    for (size_t i = 0; i < last; i++) worst = fmax(worst, distance(states + i * STATES, rows[1 + i] + 1, STATES));
    return worst;
}

/* The generic orbit reaches the pole gamma3 = 1 at t = 1.74782627825..., where the model ends: its rows up to there. */
static void reference_orbits_are_met_within_1e11_and_errors_fall_with_the_tolerance(void **unused)
{
    static const char *const tiers[] = { "level", "five", "track" };
    double rows[ROWS_MAX][1 + STATES];

    (void)unused;
    assert_true(read_reference(rows, "flow_generic.csv") >= 3);
    for (size_t i = 0; i < sizeof tiers / sizeof *tiers; i++) {
        assert_true(reference_error(&generic, rows, 2, tiers[i], 1e-13) <= 1e-11);
        assert_true(reference_error(&generic, rows, 2, tiers[i], 1e-10)
                    < 0.1 * reference_error(&generic, rows, 2, tiers[i], 1e-7));
    }
    assert_true(reference_error(&generic, rows, 2, "full", 1e-13) <= 1e-11);
    assert_int_equal(read_reference(rows, "flow_rod.csv"), 4);
    for (size_t i = 0; i < sizeof tiers / sizeof *tiers; i++)
        assert_true(reference_error(&rod, rows, 3, tiers[i], 1e-13) <= 1e-11);
    assert_true(reference_error(&rod, rows, 3, "quadrature", 1e-13) <= 1e-13);
}

static void the_planner_takes_the_smallest_tier_that_serves(void **unused)
{
    static const struct {
        const orbit *orbit;
        bool more;
        const char *tier;
    } cases[] = { { &rod, false, "quadrature" }, { &balanced, false, "plane" }, { &flat, false, "plane" },
                  { &equal_moments, false, "plane" }, { &generic, false, "level" }, { &generic, true, "track" } };
    const jlt_descriptor *model = jlt_descriptor_find("spherical_top", NULL, NULL, NULL);
    jlt_plan plan;

    (void)unused;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const jlt_question question = { model, cases[i].orbit->params, cases[i].orbit->start, cases[i].more, false,
                                        NULL, NULL };
        assert_int_equal(jlt_plan_make(&plan, &question), JLT_OK);
        assert_string_equal(jlt_plan_tier(&plan), cases[i].tier);
    }
    const jlt_question forced = { model, generic.params, generic.start, false, false, "plane", NULL };
    assert_int_equal(jlt_plan_make(&plan, &forced), JLT_ERR_UNSUPPORTED);
    const jlt_question unknown = { model, generic.params, generic.start, false, false, "six", NULL };
    assert_int_equal(jlt_plan_make(&plan, &unknown), JLT_ERR_ARG);
}

static void the_planner_names_a_parameter_without_a_value(void **unused)
{
    const jlt_descriptor *model = jlt_descriptor_find("spherical_top", NULL, NULL, NULL);
    double params[JLT_PLAN_PARAMS_MAX];
    const jlt_question question = { model, params, generic.start, false, false, "five", NULL };
    jlt_plan plan;
    size_t index;

    (void)unused;
    memcpy(params, generic.params, model->param_count * sizeof *params);
    assert_true(jlt_descriptor_param(model, "g", &index));
    params[index] = NAN;
    assert_int_equal(jlt_plan_make(&plan, &question), JLT_ERR_UNSUPPORTED);
    for (unsigned i = 0; i < plan.count; i++)
        if (strcmp(plan.candidates[i].tier.name, "five") == 0)
            assert_string_equal(plan.candidates[i].refusal, "g of spherical_top has no value");
}

/* Time reversed, the plane's other half: v_slip < 0 is integrated as the reversor's image of v_slip > 0. */
static void an_orbit_run_backwards_returns_to_its_start(void **unused)
{
    (void)unused;
    const orbit *all[] = { &generic, &balanced, &flat, &rod };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        orbit there = *all[i], back = *all[i];
        double end[STATES], start[STATES];
        there.count = back.count = 1;
        there.times[0] = 1;
        back.times[0] = -1;
        follow(end, NULL, &there, NULL, 1e-13);
        memcpy(back.start, end, sizeof back.start);
        follow(start, NULL, &back, NULL, 1e-13);
        assert_true(distance(start, there.start, STATES) <= bound);
    }
}

/* Where v_slip comes near 0 the half of M^2 ends: the orbit goes on in three states, and says so. Bound: as above, 400 steps. */
static void an_orbit_that_leaves_its_tier_goes_on_in_the_next(void **unused)
{
    const jlt_descriptor *model = jlt_descriptor_find("spherical_top", NULL, NULL, NULL);
    const double params[] = { 1, 1, 1, 0, 0.4, 0.15 };
    unsigned changed = 0;

    (void)unused;
    for (int i = 0; i < 12; i++) {
        const double start[STATES] = { 0.1 * i - 0.6, 0.5, 0.1, 0.4 + 0.1 * i, 1.5 };
        const orbit o = { { 1, 1, 1, 0, 0.4, 0.15 }, { start[0], start[1], start[2], start[3], start[4] }, { 10 }, 1 };
        const jlt_question question = { model, params, start, false, false, NULL, NULL };
        const char *from, *to, *why;
        double whole[STATES], t;
        jlt_course *course = NULL;
        jlt_course_row row;
        jlt_plan plan;
        follow(whole, NULL, &o, "balanced", 1e-13);
        assert_int_equal(jlt_plan_make(&plan, &question), JLT_OK);
        if (strcmp(jlt_plan_tier(&plan), "plane") == 0) {
            assert_int_equal(jlt_course_create(&course, &plan, &question, &(jlt_course_options){ .tolerance = 1e-13 }), JLT_OK);
            assert_int_equal(jlt_course_to(course, 10, &row), JLT_OK);
            assert_true(distance(row.x, whole, STATES) <= 2 * bound);
            if (jlt_course_changes(course) > 0) {
                jlt_course_change(course, 0, &t, &from, &to, &why);
                assert_string_equal(from, "plane");
                assert_string_equal(to, "balanced");
                assert_true(t > 0 && t < 10 && strstr(why, "m*I1^2*v_slip^2") != NULL);
                changed++;
            }
            jlt_course_destroy(course);
        }
    }
    assert_true(changed >= 3);
}

/* The largest entry of |A A^T - 1|; rows of A: alpha, beta, and gamma, whose last component is a state. */
static double distance_from_orthonormal(const double *axes, double gamma3)
{
    const double A[3][3] = { { axes[0], axes[1], axes[2] }, { axes[3], axes[4], axes[5] }, { axes[6], axes[7], gamma3 } };
    double worst = 0;

    for (int i = 0; i < 3; i++)
        for (int j = 0; j <= i; j++) {
            const double product = A[i][0] * A[j][0] + A[i][1] * A[j][1] + A[i][2] * A[j][2];
            worst = fmax(worst, fabs(product - (i == j)));
        }
    return worst;
}

static void attitude_and_track_by_quadratures_are_those_of_the_full_system(void **unused)
{
    double states[ROWS_MAX * STATES];
    double by_angles[ROWS_MAX * ATTITUDE], by_axes[ROWS_MAX * ATTITUDE];

    (void)unused;
    follow(states, by_angles, &generic, "track", 1e-13);
    follow(states, by_axes, &generic, "full", 1e-13);
    for (size_t i = 0; i < generic.count; i++) {
        assert_true(distance(by_angles + i * ATTITUDE, by_axes + i * ATTITUDE, ATTITUDE) <= bound);
        assert_true(distance_from_orthonormal(by_angles + i * ATTITUDE + 4, states[i * STATES]) <= bound);
        assert_true(distance_from_orthonormal(by_axes + i * ATTITUDE + 4, states[i * STATES]) <= bound);
    }
}

/* (2.1): the contact point of a balanced sphere moves with its centre, and the horizontal momentum is constant in space, so
 * without slip along nu the track would be straight; here its direction is checked against the velocity by differences. */
static void the_centre_moves_with_the_velocity_of_the_reduced_state(void **unused)
{
    const double h = 1e-4;
    orbit o = generic;
    double states[ROWS_MAX * STATES];
    double at[ROWS_MAX * ATTITUDE];

    (void)unused;
    o.count = 3;
    o.times[0] = 0.5 - h;
    o.times[1] = 0.5;
    o.times[2] = 0.5 + h;
    follow(states, at, &o, "track", 1e-13);
    const double *x = states + STATES;
    const jlt_top top = { 1.3, 0.7, 9.81, -0.12, 0.29, 0.21 };
    const double horizontal = hypot(x[JLT_TOP_V_NU], jlt_top_v_tau(&top, x));
    const double dx = (at[2 * ATTITUDE] - at[0]) / (2 * h), dy = (at[2 * ATTITUDE + 1] - at[1]) / (2 * h);
    /* central differences: third derivative of the track (below 100 here) times h^2/6 */
    assert_true(fabs(hypot(dx, dy) - horizontal) <= 2e-7);
}

/* The normal reaction that the table observes is the one that lifts the centre of mass: z = R + a3 gamma3, m z'' = N - m g. */
static void contact_force_is_the_acceleration_of_the_centre(void **unused)
{
    const double h = 1e-3;
    orbit o = generic;
    double x[ROWS_MAX * STATES], z[5];
    const jlt_top top = { 1.3, 0.7, 9.81, -0.12, 0.29, 0.21 };
    const double params[] = { top.m, top.R, top.g, top.a3, top.I1, top.I3 };
    jlt_observed *observed = NULL;
    double force;

    (void)unused;
    assert_int_equal(jlt_observed_create(&observed, jlt_descriptor_find("spherical_top", NULL, NULL, NULL), params,
                                         &(jlt_units){ 0 }),
                     JLT_OK);
    assert_int_equal(jlt_observed_count(observed), 1);
    assert_string_equal(jlt_observed_quantities(observed)[0].name, "contact_force");
    o.count = 5;
    for (size_t i = 0; i < 5; i++) o.times[i] = 0.3 + h * (double)i;
    follow(x, NULL, &o, "five", 1e-14);
    for (size_t i = 0; i < 5; i++) z[i] = top.R + top.a3 * x[i * STATES];
    const double acceleration = (-z[0] + 16 * z[1] - 30 * z[2] + 16 * z[3] - z[4]) / (12 * h * h);
    /* rounding 1e-15/h^2 = 1e-9, truncation h^4 z^(6)/90 < 1e-9 */
    jlt_observed_values(observed, &force, x + 2 * STATES);
    assert_true(fabs(top.m * (acceleration + top.g) - force) <= 2e-8);
    assert_true(jlt_observed_least(observed, NULL, x + 2 * STATES) == force);
    jlt_observed_destroy(observed);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_tier_agrees_with_the_tier_above_it),
        cmocka_unit_test(reference_orbits_are_met_within_1e11_and_errors_fall_with_the_tolerance),
        cmocka_unit_test(the_planner_takes_the_smallest_tier_that_serves),
        cmocka_unit_test(the_planner_names_a_parameter_without_a_value),
        cmocka_unit_test(an_orbit_run_backwards_returns_to_its_start),
        cmocka_unit_test(an_orbit_that_leaves_its_tier_goes_on_in_the_next),
        cmocka_unit_test(attitude_and_track_by_quadratures_are_those_of_the_full_system),
        cmocka_unit_test(the_centre_moves_with_the_velocity_of_the_reduced_state),
        cmocka_unit_test(contact_force_is_the_acceleration_of_the_centre),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
