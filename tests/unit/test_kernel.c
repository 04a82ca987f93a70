/* Core and kernel layers: seeded numbers, the floating-point guard, and evaluation that lets no wrong number pass. */
#include "unit/check.h"

#include "core/guard.h"
#include "core/memory.h"
#include "core/random.h"
#include "kernel/descriptor.h"
#include "kernel/instance.h"
#include "kernel/kernel.h"
#include "kernel/units.h"

#include <stdlib.h>

/* Oracle: xoshiro256++ from the state 1, 2, 3, 4, as published with its reference implementation. */
static void random_bits_are_the_published_ones(void **unused)
{
    static const uint64_t published[] = { 41943041u,           58720359u,           3588806011781223u,
                                          3591011842654386u,   9228616714210784205u, 9973669472204895162u };
    jlt_random random = { { 1, 2, 3, 4 } };

    (void)unused;
    for (size_t i = 0; i < sizeof published / sizeof *published; i++)
        assert_true(jlt_random_bits(&random) == published[i]);
}

static void random_numbers_stay_inside_their_ranges(void **unused)
{
    jlt_random random, again;
    double sum = 0.0;

    (void)unused;
    jlt_random_seed(&random, 9);
    jlt_random_seed(&again, 9);
    for (int i = 0; i < 100000; i++) {
        const double unit = jlt_random_unit(&random), between = jlt_random_between(&random, -3.0, 5.0);
        const double magnitude = jlt_random_magnitude(&random, -8, 8);
        assert_true(unit > 0.0 && unit < 1.0);
        assert_true(between > -3.0 && between < 5.0);
        assert_true(magnitude > 0.9e-8 && magnitude < 1.1e8);
        assert_true(jlt_random_below(&random, 7) < 7);
        assert_true(jlt_random_unit(&again) == unit && jlt_random_between(&again, -3.0, 5.0) == between);
        (void)jlt_random_magnitude(&again, -8, 8);
        (void)jlt_random_below(&again, 7);
        sum += unit;
    }
    /* The mean of 1e5 uniform numbers has a standard deviation of 1/sqrt(12e5) = 9e-4: six of them. */
    assert_true(fabs(sum / 100000 - 0.5) < 6e-3);
}

static volatile double one = 1.0, zero = 0.0, huge = 1e300, tiny = 1e-300;

static void guards_tell_what_happened_and_nest(void **unused)
{
    jlt_guard outer, inner;
    volatile double sink;

    (void)unused;
    jlt_guard_enter(&outer);
    jlt_guard_enter(&inner);
    sink = one / zero;
    assert_int_equal(jlt_guard_leave(&inner), JLT_ERR_DOMAIN);
    jlt_guard_enter(&inner);
    sink = huge * huge;
    assert_int_equal(jlt_guard_leave(&inner), JLT_ERR_NONFINITE);
    jlt_guard_enter(&inner);
    sink = tiny * tiny;
    assert_int_equal(jlt_guard_leave(&inner), JLT_ERR_NONFINITE);
    jlt_guard_enter(&inner);
    sink = one / 3.0;
    assert_int_equal(jlt_guard_leave(&inner), JLT_OK);
    assert_int_equal(jlt_guard_leave(&outer), JLT_OK);

    /* The caller's rounding and flags are back, and nothing beside them. */
    enum { TOLD = FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW | FE_UNDERFLOW };
    feclearexcept(FE_ALL_EXCEPT);
    feraiseexcept(FE_UNDERFLOW);
    fesetround(FE_UPWARD);
    jlt_guard_enter(&outer);
    const int inside = fetestexcept(TOLD), rounding_inside = fegetround();
    feraiseexcept(FE_DIVBYZERO);
    const jlt_status st = jlt_guard_leave(&outer);
    const int after = fetestexcept(TOLD), rounding_after = fegetround();
    fesetround(FE_TONEAREST);
    feclearexcept(FE_ALL_EXCEPT);
    assert_int_equal(inside, 0);
    assert_int_equal(rounding_inside, FE_TONEAREST);
    assert_int_equal(st, JLT_ERR_DOMAIN);
    assert_int_equal(after, FE_UNDERFLOW);
    assert_int_equal(rounding_after, FE_UPWARD);
    (void)sink;
}

static void arrays_are_zeroed_and_aligned(void **unused)
{
    double *array = jlt_memory_array(1000, sizeof *array);

    (void)unused;
    assert_non_null(array);
    assert_int_equal((uintptr_t)array % JLT_MEMORY_ALIGNMENT, 0);
    for (int i = 0; i < 1000; i++) assert_true(array[i] == 0.0);
    free(array);
    assert_null(jlt_memory_array(SIZE_MAX / 4, 8));
    array = jlt_memory_array(0, 0);
    assert_non_null(array);
    free(array);
}

static void defaults(double *params, const jlt_descriptor *d)
{
    for (unsigned i = 0; i < d->param_count; i++) params[i] = isnan(d->params[i].value) ? 1.0 : d->params[i].value;
}

static void the_most_special_variant_is_chosen(void **unused)
{
    static const struct {
        double a3, I1, I3;
        const char *variant;
    } cases[] = {
        { 0.51, 0.4, 0.3, "" },
        { 0.0, 0.4, 0.3, "balanced" },
        { 0.0, 0.4, 0.4, "balanced_equal" },
        { 0.51, 0.4, 0.0, "rod" },
        { 0.51, 0.4, 0.4, "" },
        { 1e-300, 0.4, 0.4, "" },
        { NAN, 0.4, 0.0, "rod" }, /* one that is to run: no variant of it */
        { NAN, 0.4, 0.4, "" },
    };
    const jlt_descriptor *general = jlt_descriptor_find("spherical_top", NULL, NULL, NULL);
    size_t a3, I1, I3;
    double params[64];

    (void)unused;
    assert_non_null(general);
    assert_true(jlt_descriptor_param(general, "a3", &a3) && jlt_descriptor_param(general, "I1", &I1) &&
                jlt_descriptor_param(general, "I3", &I3));
    assert_false(jlt_descriptor_param(general, "a4", &a3));
    defaults(params, general);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        params[a3] = cases[i].a3;
        params[I1] = cases[i].I1;
        params[I3] = cases[i].I3;
        const jlt_descriptor *chosen = jlt_descriptor_choose(general, "", "", params);
        assert_non_null(chosen);
        assert_string_equal(chosen->variant, cases[i].variant);
    }
    assert_null(jlt_descriptor_find("spherical_topp", NULL, NULL, NULL));
    assert_null(jlt_descriptor_choose(general, "no_such_time", NULL, params));
    assert_null(jlt_descriptor_at(jlt_descriptor_count()));
}

/* Every kernel of every descriptor, every argument: NaN and infinities are refused, and the output is left alone. */
static void nonfinite_arguments_are_refused_everywhere(void **unused)
{
    static const double bad[] = { NAN, INFINITY, -INFINITY };

    (void)unused;
    for (size_t k = 0; k < jlt_descriptor_count(); k++) {
        const jlt_descriptor *d = jlt_descriptor_at(k);
        double params[64], x[64], out[JLT_KERNEL_OUTPUTS_MAX] = { 7.0 };
        jlt_instance *instance = NULL;
        assert_true(d->param_count <= 64 && d->state_count <= 64);
        defaults(params, d);
        if (d->impose != NULL) {
            double imposed[64];
            for (unsigned i = 0; i < d->state_count; i++) x[i] = 0.5;
            d->impose(x, params, imposed);
            memcpy(params, imposed, d->param_count * sizeof *params);
        }
        for (unsigned i = 0; i < d->param_count; i++)
            for (size_t b = 0; b < 3; b++) {
                const double held = params[i];
                params[i] = bad[b];
                assert_int_equal(jlt_instance_create(&instance, d, params), JLT_ERR_NONFINITE);
                assert_null(instance);
                params[i] = held;
            }
        assert_int_equal(jlt_instance_create(&instance, d, params), JLT_OK);
        for (unsigned i = 0; i < d->state_count; i++)
            for (size_t b = 0; b < 3; b++) {
                for (unsigned j = 0; j < d->state_count; j++) x[j] = 0.5;
                x[i] = bad[b];
                assert_int_equal(jlt_kernel_eval(out, &d->rhs, x, d->state_count, instance->prepared), JLT_ERR_NONFINITE);
                assert_int_equal(jlt_instance_rhs(instance, out, x), JLT_ERR_NONFINITE);
                assert_int_equal(jlt_instance_jacobian(instance, out, x), JLT_ERR_NONFINITE);
                assert_int_equal(jlt_instance_divergence(instance, out, x), JLT_ERR_NONFINITE);
                assert_true(out[0] == 7.0);
            }
        jlt_instance_destroy(instance);
    }
}

static void poles_overflow_and_underflow_are_errors(void **unused)
{
    const jlt_descriptor *d = jlt_descriptor_find("spherical_top", NULL, NULL, NULL);
    double params[64], out[64], x[5] = { 0.3, 0.7, 0.1, 0.2, 1.1 };
    jlt_instance *instance = NULL;

    (void)unused;
    defaults(params, d);
    assert_int_equal(jlt_instance_create(&instance, d, params), JLT_OK);
    assert_int_equal(jlt_instance_rhs(instance, out, x), JLT_OK);
    x[0] = 1.0;
    assert_int_equal(jlt_instance_rhs(instance, out, x), JLT_ERR_DOMAIN);
    assert_int_equal(jlt_kernel_eval(out, &d->rhs, x, 5, instance->prepared), JLT_ERR_DOMAIN);
    x[0] = 1.5;
    assert_int_equal(jlt_kernel_eval(out, &d->rhs, x, 5, instance->prepared), JLT_ERR_DOMAIN);
    x[0] = 0.3;
    x[3] = 1e200;
    assert_int_equal(jlt_instance_rhs(instance, out, x), JLT_ERR_NONFINITE);
    x[1] = x[2] = 0; /* every product of velocities underflows, in whatever order it is taken */
    x[3] = x[4] = 1e-200;
    assert_int_equal(jlt_instance_rhs(instance, out, x), JLT_ERR_NONFINITE);
    jlt_instance_destroy(instance);
    params[0] = -1.0;
    assert_int_equal(jlt_instance_create(&instance, d, params), JLT_ERR_DOMAIN);
    assert_int_equal(jlt_instance_create(&instance, NULL, params), JLT_ERR_ARG);
}

/* kg counts 1, m 100 and s 10000, so that each sum tells its powers. */
/* A state that is counted in eighths of its unit has an interval eight times as wide, in numbers. */
static void states_are_held_against_intervals_in_their_units(void **unused)
{
    static const jlt_quantity length = { .name = "q", .unit = "m", .low = 0, .high = 10 };
    const jlt_descriptor *top = jlt_descriptor_find("spherical_top", NULL, NULL, NULL);
    jlt_quantity *states = jlt_memory_array(top->state_count, sizeof *states);
    jlt_descriptor own = *top;
    double x[5] = { 0.3, 20, 0.1, 0.2, 0.3 }, f[5], *params = jlt_memory_array(top->param_count, sizeof *params);
    jlt_instance *instance;

    (void)unused;
    memcpy(states, top->states, top->state_count * sizeof *states);
    states[1].low = length.low;
    states[1].high = length.high;
    states[1].unit = length.unit;
    own.states = states;
    defaults(params, top);
    assert_int_equal(jlt_instance_create_in(&instance, &own, params, &(jlt_units){ .length = -3 }), JLT_OK);
    assert_int_equal(jlt_instance_rhs(instance, f, x), JLT_OK); /* 2.5 m */
    x[1] = 81;
    assert_int_equal(jlt_instance_rhs(instance, f, x), JLT_ERR_DOMAIN); /* 10.125 m */
    jlt_instance_destroy(instance);
    assert_int_equal(jlt_instance_create_in(&instance, &own, params, &(jlt_units){ .length = 3 }), JLT_OK);
    x[1] = 5;
    assert_int_equal(jlt_instance_rhs(instance, f, x), JLT_ERR_DOMAIN); /* 40 m */
    jlt_instance_destroy(instance);
    free(params);
    free(states);
}

static void compound_units_are_read(void **unused)
{
    static const struct {
        const char *unit;
        int exponent;
    } cases[] = {
        { "", 0 }, { "1", 0 }, { "rad/s", -10000 }, { "kg*m^2/s^2", 1 + 200 - 20000 }, { "kg m^2", 201 },
        { "kg m / s", 101 - 10000 }, { "1/(m*s^2)", -100 - 20000 }, { "(kg/s)^2/m", 2 - 20000 - 100 },
        { "1/(kg*(m/s)^2)", -1 - 200 + 20000 }, { "1/s/s", -20000 },
        { "m^-2", -200 }, { "m^99999999999", 0 }, { "m)", 100 }, { "(m", 100 }, { "m)/s", 100 - 10000 },
    };
    const jlt_units units = { .mass = 1, .length = 100, .time = 10000 };

    (void)unused;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_int_equal(jlt_units_exponent(&units, cases[i].unit), cases[i].exponent);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_bits_are_the_published_ones),
        cmocka_unit_test(random_numbers_stay_inside_their_ranges),
        cmocka_unit_test(guards_tell_what_happened_and_nest),
        cmocka_unit_test(arrays_are_zeroed_and_aligned),
        cmocka_unit_test(the_most_special_variant_is_chosen),
        cmocka_unit_test(nonfinite_arguments_are_refused_everywhere),
        cmocka_unit_test(states_are_held_against_intervals_in_their_units),
        cmocka_unit_test(compound_units_are_read),
        cmocka_unit_test(poles_overflow_and_underflow_are_errors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
