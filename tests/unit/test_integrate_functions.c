/* Crossings of functions of the state, which are followed by values within steps. Oracles are closed forms. */
#include "unit/oscillator_orbit.h"

static double product(void *context, const double *x)
{
    (void)context;
    return x[0] * x[1];
}

/* x y = -sin(2t)/2: any smooth function of the state serves, with and without its rate. */
static double product_rate(void *context, const double *x, const double *f)
{
    (void)context;
    return x[0] * f[1] + f[0] * x[1];
}

static void events_of_functions_are_found_with_and_without_their_rate(void **unused)
{
    (void)unused;
    for (int with = 0; with < 2; with++) {
        jlt_orbit *orbit = oscillator_orbit("dop853", 1e-13, 0.1, +1);
        const jlt_event event = { .value = product, .rate = with ? product_rate : NULL };
        jlt_outcome at;
        for (int k = 1; k < 20; k++) {
            assert_ok(jlt_orbit_next(orbit, INFINITY, &event, 1, &at));
            assert_near(at.t, k * pi / 2 - 0.1, 1e-11);
        }
        jlt_orbit_destroy(orbit);
    }
}

typedef struct {
    int order;
    double level;
} harmonic;

/* T_k(cos t) = cos(k t). */
static double harmonic_value(void *context, const double *x)
{
    const harmonic *self = context;
    double before = 1, now = x[0];

    for (int k = 1; k < self->order; k++) {
        const double next = 2 * x[0] * now - before;
        before = now;
        now = next;
    }
    return now - self->level;
}

/* Short dips below zero, and such that end a little above it, in a function that is far from zero at the ends of most steps. */
static void dips_of_a_function_within_steps_are_found_and_none_is_made_up(void **unused)
{
    static const double depths[] = { 0.3, 0.1, 1e-2, 1e-3, 1e-4, -1e-4, -1e-3, -1e-2 };
    const double start = 0.1, end = 60;

    (void)unused;
    for (unsigned m = 0; m < METHODS; m++)
        for (double tolerance = 1e-5; tolerance > 1e-12; tolerance *= 1e-2)
            for (unsigned i = 0; i < sizeof depths / sizeof *depths; i++)
                for (int order = 1; order <= 5; order++) {
                    harmonic self = { order, depths[i] - 1 };
                    const jlt_event event = { .value = harmonic_value, .context = &self };
                    jlt_orbit *orbit = oscillator_orbit(methods[m], tolerance, start, +1);
                    jlt_outcome at;
                    int crossings = 0, expected = 0;
                    if (depths[i] > 0)
                        for (int n = 0; n < 200; n++)
                            for (int side = -1; side <= 1; side += 2) {
                                const double t = ((2 * n + 1) * pi + side * acos(1 - depths[i])) / order - start;
                                expected += t > 0 && t <= end;
                            }
                    do {
                        assert_ok(jlt_orbit_next(orbit, end, &event, 1, &at));
                        crossings += at.end == JLT_END_EVENT;
                    } while (at.end == JLT_END_EVENT);
                    assert_int_equal(crossings, expected);
                    jlt_orbit_destroy(orbit);
                }
}

typedef struct {
    unsigned order;
    double step;
} alias;

/* 1 + T_k - T_(12-k) over the first step: one in each of seven Lobatto points, as polynomials of a lower degree see it. */
static double alias_at(const alias *self, double time)
{
    double before = 1, now = 2 * time / self->step - 1, value = 1;
    const double slope = 2 * now;

    for (unsigned k = 0; k <= 12; k++) {
        value += (k == self->order ? before : 0) - (k == 12 - self->order ? before : 0);
        const double next = slope * now - before;
        before = now;
        now = next;
    }
    return value;
}

static double alias_value(void *context, const double *x)
{
    return alias_at(context, atan2(-x[1], x[0]));
}

static double alias_step(void *context, const double *x, const double *f, double direction)
{
    (void)x, (void)f, (void)direction;
    return ((const alias *)context)->step;
}

static void a_function_that_looks_constant_in_seven_points_is_seen(void **unused)
{
    const unsigned grid = 100000;

    (void)unused;
    for (unsigned m = 0; m < METHODS; m++)
        for (unsigned order = 7; order <= 12; order++) {
            alias self = { order, 0.02 };
            const jlt_event event = { .value = alias_value, .longest_step = alias_step, .context = &self };
            jlt_orbit *orbit = oscillator_orbit(methods[m], 1e-6, 0, +1);
            jlt_outcome at;
            int crossings = 0, expected = 0;
            for (unsigned i = 0; i < grid; i++)
                expected += alias_at(&self, self.step * i / grid) * alias_at(&self, self.step * (i + 1) / grid) < 0;
            assert_true(expected >= 4);
            do {
                assert_ok(jlt_orbit_next(orbit, self.step, &event, 1, &at));
                crossings += at.end == JLT_END_EVENT;
            } while (at.end == JLT_END_EVENT);
            assert_int_equal(crossings, expected);
            jlt_orbit_destroy(orbit);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(events_of_functions_are_found_with_and_without_their_rate),
        cmocka_unit_test(dips_of_a_function_within_steps_are_found_and_none_is_made_up),
        cmocka_unit_test(a_function_that_looks_constant_in_seven_points_is_seen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
