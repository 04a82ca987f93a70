/* Collocation: instances for all instruction sets agree, quadratic integrals stay, steps have their order and stand alone, and
 * what is not finite is not accepted. */
#include "unit/check.h"
#include "unit/sample_fields.h"

#include "integrate/orbit.h"
#include "kernel/batch_isa.h"
#include "kernel/descriptor.h"
#include "reference/spherical_top.h"

static const double params[6] = { 1, 1, 1, 0.51, 1.0 / 3, 1.0 / 3 }; /* m, R, g, a3, I1, I3 */
static const double by_hand[6] = { 1, 1, 1, 1.0 / 3, 1.0 / 3, 0.51 };

/* The sums are ordered alike, but fused on some sets: differences of rounding, amplified less than 1e4 on this orbit. */
static void all_instruction_sets_give_the_same_orbit(void **unused)
{
    (void)unused;
    const jlt_descriptor *descriptor = jlt_descriptor_find("spherical_top", NULL, "regular", NULL);
    const jlt_event upward = { .column = 2, .direction = JLT_RISING };
    jlt_instance *instance = NULL;
    double start[6], expected[7] = { 0 };
    jlt_field field;

    assert_non_null(descriptor);
    assert_ok(jlt_instance_create(&instance, descriptor, params));
    assert_ok(jlt_field_of(&field, instance));
    top_section_point(start, by_hand, 0.44, -0.62, 2.15, -0.56);
    for (int set = -1; set < JLT_ISA_COUNT; set++) {
        jlt_orbit *orbit = NULL;
        jlt_outcome at;
        field.batch = set < 0 ? NULL : descriptor->batches[set];
        if (set >= 0 && !jlt_batch_isa_runs(field.batch)) continue;
        assert_ok(jlt_orbit_create(&orbit, jlt_method_find("gauss"), &field, &(jlt_options){ .tolerance = 1e-14 }));
        assert_ok(jlt_orbit_start(orbit, 0, start, +1));
        for (int k = 0; k < 10; k++) assert_ok(jlt_orbit_next(orbit, INFINITY, &upward, 1, &at));
        for (unsigned i = 0; i < 6; i++) {
            if (set < 0) expected[i] = at.x[i];
            assert_near(at.x[i], expected[i], 1e-12);
        }
        if (set < 0) expected[6] = at.t;
        assert_near(at.t, expected[6], 1e-12);
        jlt_orbit_destroy(orbit);
    }
    jlt_instance_destroy(instance);
}

static void square(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[0] * x[0] + x[1] * x[1];
}

/* Gauss methods keep quadratic integrals exactly; what is left is where the sweeps stop, a few roundings a step: 1e5 steps. */
static void quadratic_integrals_are_kept_to_rounding_at_any_step(void **unused)
{
    (void)unused;
    const jlt_field field = { .dim = 2, .call = oscillator, .root = -1 };
    const jlt_invariants invariants = { .count = 1, .values = square };
    const double x[2] = { 1, 0 };
    double end[2], drift;
    jlt_orbit *orbit = NULL;
    assert_ok(jlt_orbit_create(&orbit, jlt_method_find("gauss"), &field,
                               &(jlt_options){ .tolerance = 1e-15, .max_step = 0.5, .invariants = invariants }));
    assert_ok(jlt_orbit_start(orbit, 0, x, +1));
    assert_ok(jlt_orbit_propagate(orbit, 50000, end));
    jlt_orbit_drift(orbit, &drift);
    assert_below(drift, 1e-11);
    assert_near(end[0], cos(50000), 1e-9);
    jlt_orbit_destroy(orbit);
}

/* At the start of a circular orbit of length 2 pi. The field lives as long as the stepper. */
static jlt_stepper *on_a_circle(const jlt_field *field, double tolerance, double first_step)
{
    const double x[4] = { 1, 0, 0, 1 };
    jlt_stepper *stepper = NULL;

    assert_ok(jlt_stepper_create(&stepper, jlt_method_find("gauss"), field, tolerance, INFINITY));
    assert_ok(jlt_stepper_start(stepper, 0, x, +1, first_step));
    return stepper;
}

/* Error of one step by the partial step of a solved longer one, against a circular orbit: h and 0.8 h differ by 0.8^-17 = 44.
 * 25 to 80 is accepted, the second error being near 1e-14. */
static void a_step_has_local_order_seventeen(void **unused)
{
    (void)unused;
    const jlt_field field = { .dim = 4, .call = kepler, .root = -1 };
    const double h = 1.6;
    double error[2];
    jlt_stepper *stepper = on_a_circle(&field, 1e-4, h);

    assert_ok(jlt_stepper_advance(stepper, INFINITY));
    assert_near(stepper->h, h, 0);
    stepper->tolerance = 1e-15; /* sweeps to the rounding level */
    for (unsigned k = 0; k < 2; k++) {
        double end[8];
        const double t = k == 0 ? h : 0.8 * h;
        assert_ok(stepper->method->partial(stepper, t / h, end));
        error[k] = hypot(end[0] - cos(t), end[1] - sin(t));
    }
    assert_true(error[0] / error[1] > 25 && error[0] / error[1] < 80);
    jlt_stepper_destroy(stepper);
}

/* How fast the sweeps of a short partial step contract says nothing of a long one, which comes out the same, bit for bit, before
 * it and after it. Told 0.18 in place of 0.33, it would end its sweeps too soon where the first change is between 0.10 and 0.23
 * of the tolerance, which halving cannot miss. */
static void a_partial_step_does_not_depend_on_those_before(void **unused)
{
    (void)unused;
    const jlt_field field = { .dim = 4, .call = kepler, .root = -1 };

    for (double tolerance = 1e-2; tolerance > 1e-6; tolerance /= 2) {
        double before[8] = { 0 }, between[8] = { 0 }, after[8] = { 0 };
        jlt_stepper *stepper = on_a_circle(&field, 1e-2, 2);
        assert_ok(jlt_stepper_advance(stepper, INFINITY));
        stepper->tolerance = tolerance;
        assert_ok(stepper->method->partial(stepper, 0.9, before));
        assert_ok(stepper->method->partial(stepper, 0.1, between));
        assert_ok(stepper->method->partial(stepper, 0.9, after));
        assert_memory_equal(after, before, sizeof before);
        jlt_stepper_destroy(stepper);
    }
}

/* A step that a limit cut to a millionth or less says nothing of a whole one, which is taken at once all the same. */
static void a_step_after_one_cut_short_is_as_long_as_before_it(void **unused)
{
    (void)unused;
    const jlt_field field = { .dim = 4, .call = kepler, .root = -1 };

    for (double cut = 1e-6; cut > 1e-13; cut /= 10) {
        jlt_stepper *stepper = on_a_circle(&field, 1e-10, 0);
        for (unsigned k = 0; k < 6; k++) assert_ok(jlt_stepper_advance(stepper, INFINITY));
        const double whole = stepper->h_next;
        assert_ok(jlt_stepper_advance(stepper, cut * whole));
        const size_t rejected = stepper->rejected;
        assert_ok(jlt_stepper_advance(stepper, INFINITY));
        assert_near(stepper->h, whole, 0);
        assert_int_equal(stepper->rejected, rejected);
        jlt_stepper_destroy(stepper);
    }
}

static void unit_speed(const double *restrict x, const double *restrict p, double *restrict f)
{
    (void)x, (void)p;
    f[0] = 1;
}

/* Time is not known for p[0] < x < p[1]. */
static void broken_clock(const double *restrict x, const double *restrict p, double *restrict rate)
{
    rate[0] = x[0] > p[0] && x[0] < p[1] ? NAN : 1;
}

/* The first step, 1, has nodes in the gap and ends beyond it. Steps that halve come up to the gap and no further: none longer
 * than 1 has its first node, at 0.02 of it, beyond. */
static void a_gap_in_the_clock_is_not_stepped_over(void **unused)
{
    (void)unused;
    const double gap[2] = { 0.1, 0.9 }, x = 0;
    const jlt_field field = { .dim = 1, .call = unit_speed, .time_rate = broken_clock, .p = gap, .root = -1 };
    jlt_status st = JLT_OK;
    jlt_stepper *stepper = NULL;

    assert_ok(jlt_stepper_create(&stepper, jlt_method_find("gauss"), &field, 1e-10, 1));
    assert_ok(jlt_stepper_start(stepper, 0, &x, +1, 1));
    for (unsigned k = 0; k < 1000 && st == JLT_OK; k++) {
        st = jlt_stepper_advance(stepper, INFINITY);
        assert_near(jlt_stepper_time(stepper), stepper->x[0], 1e-15);
    }
    assert_int_equal(st, JLT_ERR_NONFINITE);
    assert_near(stepper->x[0], gap[0], 1e-15);
    jlt_stepper_destroy(stepper);
}

/* The states are finite all the time; only the clock is not, at every point but the first. */
static void a_clock_that_never_runs_is_nonfinite(void **unused)
{
    (void)unused;
    const double gap[2] = { 0, INFINITY }, x = 0;
    const jlt_field field = { .dim = 1, .call = unit_speed, .time_rate = broken_clock, .p = gap, .root = -1 };
    jlt_stepper *stepper = NULL;

    assert_ok(jlt_stepper_create(&stepper, jlt_method_find("gauss"), &field, 1e-10, INFINITY));
    assert_ok(jlt_stepper_start(stepper, 0, &x, +1, 1));
    assert_int_equal(jlt_stepper_advance(stepper, INFINITY), JLT_ERR_NONFINITE);
    assert_near(stepper->x[0], 0, 0);
    jlt_stepper_destroy(stepper);
}

/* A circle of frequency p[2] in the columns p[0] and p[1]; the third of three stays. */
static void turning(const double *restrict x, const double *restrict p, double *restrict f)
{
    const unsigned a = (unsigned)p[0], b = (unsigned)p[1];
    for (unsigned c = 0; c < 3; c++) f[c] = 0;
    f[a] = p[2] * x[b];
    f[b] = -p[2] * x[a];
}

/* The numbers are the same whichever columns move, but for the order of sums: the first length is guessed from all of them, and
 * the error, the end, the polynomial and a part of the step are theirs. A change of rounding in h, of 17 factors, moves the end
 * by that much of a step's angle. */
static void all_columns_are_treated_alike(void **unused)
{
    (void)unused;
    double lengths[4] = { 0 };
    for (unsigned still = 0; still < 3; still++) {
        const unsigned a = still == 0 ? 1 : 0, b = still == 2 ? 1 : 2;
        const double p[3] = { a, b, 40 };
        const jlt_field field = { .dim = 3, .call = turning, .p = p, .root = -1 };
        double x[3] = { 1, 1, 1 }, t = 0;
        jlt_stepper *stepper = NULL;

        assert_ok(jlt_stepper_create(&stepper, jlt_method_find("gauss"), &field, 1e-12, INFINITY));
        assert_ok(jlt_stepper_start(stepper, 0, x, +1, 0));
        for (unsigned k = 0; k < 4; k++) {
            double part[3], bernstein[32];
            assert_ok(jlt_stepper_advance(stepper, INFINITY));
            if (still == 0) lengths[k] = stepper->h;
            assert_near(stepper->h, lengths[k], 1e-12 * stepper->h);
            assert_ok(stepper->method->partial(stepper, 0.7, part));
            assert_ok(stepper->method->dense(stepper));
            for (unsigned end = 0; end < 2; end++) {
                const double at = 40 * (t + (end == 0 ? 0.7 : 1) * stepper->h);
                const double *is = end == 0 ? part : stepper->x;
                assert_near(is[a], cos(at) + sin(at), 1e-11);
                assert_near(is[b], cos(at) - sin(at), 1e-11);
                assert_near(is[still], 1, 0);
            }
            for (unsigned c = 0; c < 3; c++) {
                double sum = 0;
                for (unsigned m = 0; m <= stepper->dense_degree; m++) sum += stepper->dense[m * (size_t)stepper->stride + c];
                assert_near(sum, stepper->x[c], 1e-11);
                const unsigned degree = stepper->method->bernstein(stepper, c, bernstein);
                assert_near(bernstein[0], stepper->x_start[c], 0);
                assert_near(bernstein[degree], stepper->x[c], 1e-11);
            }
            t += stepper->h;
        }
        jlt_stepper_destroy(stepper);
    }
}

/* Beyond x = 1/2 the field of column p[0] alone is unknown, the position's column being the other. */
static void blind_beyond(const double *restrict x, const double *restrict p, double *restrict f)
{
    const unsigned blind = (unsigned)p[0];
    f[1 - blind] = 1;
    f[blind] = x[1 - blind] > 0.5 ? NAN : 0;
}

/* The nodes of the first step of 0.5000001 are all before 1/2, its end is not. */
static void an_end_that_is_not_finite_in_one_column_is_refused(void **unused)
{
    (void)unused;
    for (unsigned blind = 0; blind < 2; blind++) {
        const double p = blind, x[2] = { 0, 0 };
        const jlt_field field = { .dim = 2, .call = blind_beyond, .p = &p, .root = -1 };
        jlt_stepper *stepper = NULL;

        assert_ok(jlt_stepper_create(&stepper, jlt_method_find("gauss"), &field, 1e-10, INFINITY));
        assert_ok(jlt_stepper_start(stepper, 0, x, +1, 0.5000001));
        assert_ok(jlt_stepper_advance(stepper, INFINITY));
        assert_near(stepper->h, 0.25, 1e-6);
        assert_true(isfinite(stepper->f[0]) && isfinite(stepper->f[1]));
        jlt_stepper_destroy(stepper);
    }
}

/* cos t and a bump of height p[0] and width p[1] at t = 2. */
static void bump(const double *restrict x, const double *restrict p, double *restrict f)
{
    const double z = (x[1] - 2) / p[1];
    f[0] = cos(x[1]) + p[0] / (1 + z * z);
    f[1] = 1;
}

/* Coefficients fall fast to the size of the bump, and slowly from there: from the first and the last alone these steps were off by
 * 290 to 40000 tolerances. At any time within ten steps, each within a tolerance. */
static void a_small_rough_part_of_a_field_is_seen(void **unused)
{
    (void)unused;
    static const double cases[][3] = { { 7.29e-4, 0.3, 1e-13 }, { 7.29e-4, 0.45, 1e-11 }, { 2.187e-3, 0.45, 1e-10 },
                                       { 6.561e-3, 0.45, 1e-9 } };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        const double *p = cases[k], x[2] = { 0, 0 };
        const jlt_field field = { .dim = 2, .call = bump, .p = p, .root = -1 };
        jlt_orbit *orbit = NULL;
        double end[2];
        assert_ok(jlt_orbit_create(&orbit, jlt_method_find("gauss"), &field, &(jlt_options){ .tolerance = p[2] }));
        for (double t = 0.1; t < 6; t += 0.1) {
            assert_ok(jlt_orbit_start(orbit, 0, x, +1));
            assert_ok(jlt_orbit_propagate(orbit, t, end));
            assert_near(end[0], sin(t) + p[0] * p[1] * (atan((t - 2) / p[1]) + atan(2 / p[1])), 10 * p[2]);
        }
        jlt_orbit_destroy(orbit);
    }
}

/* x1' = x1 beside a state that creeps: what grows is below rounding for 20 units of time, in which steps see nothing of it. */
static void growth(const double *restrict x, const double *restrict p, double *restrict f)
{
    (void)p;
    f[0] = 1e-4;
    f[1] = x[1];
}

static int keep_first_step(void *context, jlt_orbit *orbit)
{
    double *first = context;
    if (*first == 0) *first = jlt_orbit_stepper(orbit)->h;
    return 0;
}

/* From 1e-20 to 1e-3. The field changes in 1, and so long is the first step at most, though nothing is to be seen there. Then
 * errors of the tolerance, 1e-12, may bring the crossing forward to log(1e9), and by no more than what some steps add up to, which
 * is less than e. */
static void what_grows_unseen_is_not_stepped_over(void **unused)
{
    (void)unused;
    const jlt_field field = { .dim = 2, .call = growth, .root = -1 };
    const jlt_event seen = { .column = 1, .level = 1e-3, .direction = JLT_RISING };
    const double start[2] = { 1, 1e-20 };
    double first = 0;
    jlt_orbit *orbit = NULL;
    jlt_outcome at;

    assert_ok(jlt_orbit_create(&orbit, jlt_method_find("gauss"), &field, NULL));
    jlt_orbit_observe(orbit, keep_first_step, &first);
    assert_ok(jlt_orbit_start(orbit, 0, start, +1));
    assert_ok(jlt_orbit_next(orbit, 1000, &seen, 1, &at));
    assert_int_equal(at.end, JLT_END_EVENT);
    assert_true(first > 0 && first <= 1 + 1e-6);
    assert_true(at.t > log(1e9) - 1);
    jlt_orbit_destroy(orbit);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_instruction_sets_give_the_same_orbit),
        cmocka_unit_test(quadratic_integrals_are_kept_to_rounding_at_any_step),
        cmocka_unit_test(a_step_has_local_order_seventeen),
        cmocka_unit_test(a_partial_step_does_not_depend_on_those_before),
        cmocka_unit_test(a_step_after_one_cut_short_is_as_long_as_before_it),
        cmocka_unit_test(a_gap_in_the_clock_is_not_stepped_over),
        cmocka_unit_test(a_clock_that_never_runs_is_nonfinite),
        cmocka_unit_test(all_columns_are_treated_alike),
        cmocka_unit_test(an_end_that_is_not_finite_in_one_column_is_refused),
        cmocka_unit_test(a_small_rough_part_of_a_field_is_seen),
        cmocka_unit_test(what_grows_unseen_is_not_stepped_over),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
