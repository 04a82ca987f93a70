/* A million returns on a regular orbit of (5.1): every crossing once, E and G as drifted as the method lets them. */
#include "unit/check.h"

#include "integrate/orbit.h"
#include "kernel/descriptor.h"
#include "reference/spherical_top.h"

enum { RETURNS = 1000000, COMPARED = 50000 };
static const double params[6] = { 1, 1, 1, 0.51, 1.0 / 3, 1.0 / 3 }; /* m, R, g, a3, I1, I3 */
static const double by_hand[6] = { 1, 1, 1, 1.0 / 3, 1.0 / 3, 0.51 };

typedef struct {
    size_t changes;
    int sign;
} sign_count;

/* Sign changes of omega_tau between step ends: a count that knows nothing of events. */
static int count_signs(void *context, jlt_orbit *orbit)
{
    sign_count *self = context;
    const double value = jlt_orbit_stepper(orbit)->x[2];
    const int sign = (value > 0) - (value < 0);
    if (sign != 0 && sign != self->sign) {
        self->changes++;
        self->sign = sign;
    }
    return 0;
}

static jlt_field field_of_top(jlt_instance **instance)
{
    jlt_field field;
    const jlt_descriptor *descriptor = jlt_descriptor_find("spherical_top", NULL, "regular", NULL);
    assert_non_null(descriptor);
    assert_ok(jlt_instance_create(instance, descriptor, params));
    assert_ok(jlt_field_of(&field, *instance));
    return field;
}

/* The two runs use different methods and steps; on a regular orbit errors grow linearly and stay far below a return time. */
static void crossings_are_as_many_as_the_changes_of_sign(void **unused)
{
    (void)unused;
    jlt_instance *instance;
    const jlt_field field = field_of_top(&instance);
    const jlt_event section = { .column = 2 };
    double start[6];
    jlt_orbit *orbit = NULL;
    jlt_outcome at;
    sign_count count = { .sign = 1 };

    top_section_point(start, by_hand, 0.44, -0.62, 2.15, -0.56);
    assert_ok(jlt_orbit_create(&orbit, jlt_method_find("gauss"), &field, &(jlt_options){ .tolerance = 1e-14 }));
    assert_ok(jlt_orbit_start(orbit, 0, start, +1));
    for (size_t k = 0; k < COMPARED; k++) assert_ok(jlt_orbit_next(orbit, INFINITY, &section, 1, &at));
    const double t_end = at.t + 1e-3;
    jlt_orbit_destroy(orbit);

    assert_ok(jlt_orbit_create(&orbit, jlt_method_find("dop853"), &field, &(jlt_options){ .tolerance = 1e-13, .max_step = 0.05 }));
    jlt_orbit_observe(orbit, count_signs, &count);
    assert_ok(jlt_orbit_start(orbit, 0, start, +1));
    assert_ok(jlt_orbit_next(orbit, t_end, NULL, 0, &at));
    assert_int_equal(at.end, JLT_END_TIME);
    assert_int_equal(count.changes, COMPARED);
    jlt_orbit_destroy(orbit);
    jlt_instance_destroy(instance);
}

/* Upward and downward crossings alternate, and no two are nearer than half the shortest time seen in the first hundred. Rounding
 * in some 2e7 steps of 1e-16 each at random gives 5e-13; systematically, 2e-9. Between the two is what is accepted. */
static void a_million_returns_alternate_and_keep_the_integrals(void **unused)
{
    (void)unused;
    jlt_instance *instance;
    const jlt_field field = field_of_top(&instance);
    const jlt_descriptor *descriptor = instance->descriptor;
    const jlt_invariants invariants = { descriptor->integral_count, descriptor->integral_values.call, NULL, instance->prepared };
    const jlt_event section = { .column = 2 };
    double start[6], last = 0, shortest = INFINITY, drift[JLT_INVARIANTS_MAX];
    int direction = JLT_RISING;
    jlt_orbit *orbit = NULL;
    jlt_outcome at;

    top_section_point(start, by_hand, 0.44, -0.62, 2.15, -0.56);
    assert_ok(jlt_orbit_create(&orbit, jlt_method_find("gauss"), &field,
                               &(jlt_options){ .tolerance = 1e-14, .invariants = invariants }));
    assert_ok(jlt_orbit_start(orbit, 0, start, +1));
    for (size_t k = 0; k < 2 * RETURNS; k++) {
        assert_ok(jlt_orbit_next(orbit, INFINITY, &section, 1, &at));
        assert_int_equal(at.end, JLT_END_EVENT);
        assert_int_equal(at.crossing.direction, -direction);
        assert_near(at.crossing.residual, 0, 1e-15);
        direction = at.crossing.direction;
        if (k < 100) shortest = fmin(shortest, at.t - last);
        assert_true(at.t - last > 0.5 * shortest);
        last = at.t;
    }
    jlt_orbit_drift(orbit, drift);
    for (unsigned i = 0; i < invariants.count; i++) {
        print_message("drift of %s: %.2g\n", descriptor->integrals[i].name, drift[i]);
        assert_below(drift[i], 1e-10);
    }
    jlt_orbit_destroy(orbit);
    jlt_instance_destroy(instance);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(crossings_are_as_many_as_the_changes_of_sign),
        cmocka_unit_test(a_million_returns_alternate_and_keep_the_integrals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
