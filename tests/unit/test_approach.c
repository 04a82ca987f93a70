/* How an orbit decays onto an equilibrium, on linear fields whose rates and way left are known by hand. */
#include "unit/check.h"

#include "integrate/approach.h"

/* dx/dt = a x + c, shape (3, 3) and (3,), both in p. */
static void call(const double *restrict x, const double *restrict p, double *restrict f)
{
    for (int i = 0; i < 3; i++) f[i] = p[3 * i] * x[0] + p[3 * i + 1] * x[1] + p[3 * i + 2] * x[2] + p[9 + i];
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict a)
{
    (void)x;
    for (int i = 0; i < 9; i++) a[i] = p[i];
}

typedef struct {
    const char *what;
    double p[12], x[3], direction;
    bool decays;
    double slowest, fastest, left[3];
} problem;

/* By hand: eigenvalues off the diagonal blocks, and left = y with a y = f. */
static const problem problems[] = {
    { "a node", { -2, 1, 0, 0, -3, 0, 0, 0, -5 }, { 1e-3, 2e-3, 1e-3 }, 1, true, 2, 5, { 1e-3, 2e-3, 1e-3 } },
    { "a focus, with a faster state",
      { -0.5, -1, 0, 1, -0.5, 0, 0, 0, -2 },
      { 1e-3, 0, 1e-3 },
      1,
      true,
      0.5,
      2,
      { 1e-3, 0, 1e-3 } },
    { "a line of equilibria, on which it comes to rest farther on",
      { -1, 0, 0, 0, -2, 0, 3, 0, 0 },
      { 1e-3, 1e-3, 5 },
      1,
      true,
      1,
      2,
      { 1e-3, 1e-3, -3e-3 } },
    { "backwards in time it decays", { 2, 0, 0, 0, 3, 0, 0, 0, 7 }, { 1e-3, 1e-3, 1e-3 }, -1, true, 2, 7, { 1e-3, 1e-3, 1e-3 } },
    { "forwards it grows", { 2, 0, 0, 0, 3, 0, 0, 0, 7 }, { 1e-3, 1e-3, 1e-3 }, 1, false, 0, 0, { 0 } },
    { "one state grows", { -2, 0, 0, 0, 1e-3, 0, 0, 0, -1 }, { 1e-3, 1e-3, 1e-3 }, 1, false, 0, 0, { 0 } },
    { "one would grow, but rests and is not pushed",
      { -2, 0, 0, 0, 1, 0, 0, 0, -1 },
      { 1e-3, 0, 1e-3 },
      1,
      true,
      1,
      2,
      { 1e-3, 0, 1e-3 } },
    { "it rests, and is pushed", { -2, 0, 0, 1, 1, 0, 0, 0, -1 }, { 1e-3, -1e-3, 1e-3 }, 1, false, 0, 0, { 0 } },
    { "it drifts as fast as it decays", { -1, 0, 0, 0, -1, 0, 0, 0, 0, 0, 0, 1e-9 }, { 1e-9, 1e-9, 0 }, 1, false, 0, 0, { 0 } },
    { "its drift is slow against the decay",
      { -1, 0, 0, 0, -1, 0, 0, 0, 0, 0, 0, 1e-9 },
      { 1e-3, 1e-3, 0 },
      1,
      true,
      1,
      1,
      { 1e-3, 1e-3, 0 } },
    { "it is there", { -1, 0, 0, 0, -1, 0, 0, 0, -1 }, { 0, 0, 0 }, 1, false, 0, 0, { 0 } },
};

static void judge(const problem *p, bool by_differences)
{
    const double scale[] = { 1, 1, 1 };
    const jlt_field field = {
        .dim = 3, .call = call, .p = p->p, .jacobian = by_differences ? NULL : jacobian, .root = -1, .scale = scale
    };
    const double near = by_differences ? 1e-9 : 1e-14;
    double longest = 0;
    jlt_stepper *stepper;
    jlt_approach approach;

    assert_int_equal(jlt_stepper_create(&stepper, jlt_method_find("dop853"), &field, 1e-6, INFINITY), JLT_OK);
    assert_int_equal(jlt_stepper_start(stepper, 0, p->x, p->direction, 0), JLT_OK);
    assert_int_equal(jlt_approach_judge(&approach, stepper), JLT_OK);
    if (approach.decays != p->decays) fail_msg("%s: %s", p->what, approach.decays ? "decays" : "does not decay");
    for (int i = 0; i < 3 && p->decays; i++) {
        if (!(fabs(approach.left[i] - p->left[i]) <= 2 * near)) fail_msg("%s: left %d is %.17g", p->what, i, approach.left[i]);
        longest = fmax(longest, fabs(p->left[i]) / fmax(1, fabs(p->x[i])));
    }
    if (p->decays) {
        assert_true(fabs(approach.slowest - p->slowest) <= near * 1e2 && fabs(approach.fastest - p->fastest) <= near * 1e2);
        assert_true(fabs(approach.longest - longest) <= 2 * near);
    }
    jlt_stepper_destroy(stepper);
}

static void rates_and_the_way_left_are_those_by_hand(void **unused)
{
    (void)unused;
    for (size_t i = 0; i < sizeof problems / sizeof *problems; i++)
        for (int by_differences = 0; by_differences < 2; by_differences++) judge(&problems[i], by_differences != 0);
}

/* Second order, y^2 fastest/slowest, is below a hundredth of the tolerance, or below 1e-16. */
static void the_limit_is_known_where_second_order_is_below_a_hundredth_of_the_tolerance(void **unused)
{
    jlt_stepper stepper = { .asked = 1e-6 };
    jlt_approach approach = { .decays = true, .slowest = 0.25, .fastest = 1, .longest = 0.999e-4 / 2 };

    (void)unused;
    assert_true(jlt_approach_is_known(&approach, &stepper));
    approach.longest = 1.001e-4 / 2;
    assert_false(jlt_approach_is_known(&approach, &stepper));
    stepper.asked = 1e-300;
    approach.longest = 0.999e-8 / 2;
    assert_true(jlt_approach_is_known(&approach, &stepper));
    approach.longest = 1.001e-8 / 2;
    assert_false(jlt_approach_is_known(&approach, &stepper));
    approach.decays = false;
    approach.longest = 0;
    assert_false(jlt_approach_is_known(&approach, &stepper));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rates_and_the_way_left_are_those_by_hand),
        cmocka_unit_test(the_limit_is_known_where_second_order_is_below_a_hundredth_of_the_tolerance),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
