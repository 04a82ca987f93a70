/* Crossings: none missed, doubled or invented, at rounding level. Oracles are closed forms. */
#include "unit/oscillator_orbit.h"

/* cos t = 0 alternately downwards and upwards, at pi/2 + k pi. Phase errors grow by about the tolerance a step. */
static void crossings_of_the_oscillator_come_once_each_in_order(void **unused)
{
    (void)unused;
    for (unsigned m = 0; m < METHODS; m++) {
        const double tolerance = 1e-11, slack = strcmp(methods[m], "msadams") == 0 ? 1e5 : 1e3;
        jlt_orbit *orbit = oscillator_orbit(methods[m], tolerance, 0, +1);
        const jlt_event event = { .column = 0 };
        jlt_outcome at;
        for (int k = 0; k < 50; k++) {
            assert_ok(jlt_orbit_next(orbit, INFINITY, &event, 1, &at));
            assert_int_equal(at.end, JLT_END_EVENT);
            assert_int_equal(at.crossing.direction, k % 2 == 0 ? JLT_FALLING : JLT_RISING);
            assert_near(at.t, pi / 2 + k * pi, slack * tolerance);
            assert_near(at.x[0], 0, 1e-15);
        }
        jlt_orbit_destroy(orbit);
    }
}

/* Backwards, directions are still those of growing t. */
static void a_backward_run_meets_the_same_crossings_with_the_same_directions(void **unused)
{
    (void)unused;
    jlt_orbit *orbit = oscillator_orbit("dop853", 1e-13, 0, -1);
    const jlt_event rising = { .column = 0, .direction = JLT_RISING };
    jlt_outcome at;
    for (int k = 0; k < 5; k++) {
        assert_ok(jlt_orbit_next(orbit, -INFINITY, &rising, 1, &at));
        assert_near(at.t, -pi / 2 - 2 * k * pi, 1e-11);
    }
    jlt_orbit_destroy(orbit);
}

/* From the section itself, or off it by rounding on either side: the first crossing is half a period later. */
static void a_start_on_the_section_is_no_crossing(void **unused)
{
    (void)unused;
    const double offsets[] = { 0, 1e-17, -1e-17, 3e-14, -3e-14 };
    for (unsigned m = 0; m < METHODS; m++)
        for (unsigned i = 0; i < 5; i++)
            for (int leaving = -1; leaving <= 1; leaving += 2) {
                const double x[2] = { offsets[i], leaving };
                const jlt_event event = { .column = 0 };
                jlt_orbit *orbit = NULL;
                jlt_outcome at;
                assert_ok(jlt_orbit_create(&orbit, jlt_method_find(methods[m]), &oscillator_field,
                                           &(jlt_options){ .tolerance = 1e-12 }));
                assert_ok(jlt_orbit_start(orbit, 0, x, +1));
                assert_ok(jlt_orbit_next(orbit, INFINITY, &event, 1, &at));
                assert_near(at.t, pi, 1e-9);
                assert_int_equal(at.crossing.direction, -leaving);
                jlt_orbit_destroy(orbit);
            }
}

/* Restarted from each crossing, as a section map does, the count stays exact. */
static void restarting_from_crossings_neither_repeats_nor_skips(void **unused)
{
    (void)unused;
    jlt_orbit *orbit = oscillator_orbit("dop853", 1e-12, 0.3, +1);
    const jlt_event event = { .column = 0 };
    jlt_outcome at;
    double t = 0;
    for (int k = 0; k < 200; k++) {
        assert_ok(jlt_orbit_next(orbit, INFINITY, &event, 1, &at));
        assert_near(at.t - t, k == 0 ? pi / 2 - 0.3 : pi, 1e-10);
        t = at.t;
        const double x[2] = { at.x[0], at.x[1] };
        assert_ok(jlt_orbit_start(orbit, t, x, +1));
    }
    jlt_orbit_destroy(orbit);
}

static double twice_x(void *context, const double *x)
{
    (void)context;
    return 2 * x[0];
}

/* Another list of events begins at the crossing that was handed out, which it does not hand out again, under any function. */
static void another_list_neither_repeats_nor_skips(void **unused)
{
    const jlt_event zero = { .column = 0 }, same = { .value = twice_x }, other = { .column = 1, .level = 0.8 };
    const jlt_event lists[3][2] = { { zero, other }, { other, zero }, { same, other } };
    const double crossings[] = { pi / 2, pi + asin(0.8), 3 * pi / 2, 2 * pi - asin(0.8) }; /* of a period */
    (void)unused;

    for (unsigned m = 0; m < METHODS; m++) {
        const double slack = strcmp(methods[m], "msadams") == 0 ? 1e-6 : 1e-8;
        jlt_orbit *orbit = oscillator_orbit(methods[m], 1e-11, 0, +1);
        jlt_outcome at;
        for (int k = 0; k < 80; k++) {
            assert_ok(jlt_orbit_next(orbit, INFINITY, lists[k % 3], 2, &at));
            assert_near(at.t, crossings[k % 4] + k / 4 * 2 * pi, slack);
        }
        jlt_orbit_destroy(orbit);
    }
}

/* cos t = 1 - d has two zeros 2 sqrt(2 d) apart at each multiple of 2 pi, both inside a step. Their places have the condition
 * 1/sqrt(2 d), so errors of the state of 1e-12 become 1e-12/sqrt(2 d). */
static void two_zeros_within_a_step_are_two_crossings(void **unused)
{
    (void)unused;
    const double depths[] = { 1e-2, 1e-4, 1e-6, 1e-8 };
    for (unsigned i = 0; i < 8; i++) {
        const double d = depths[i % 4], half = acos(1 - d);
        jlt_orbit *orbit = oscillator_orbit(methods[i / 4], 1e-13, 1, +1);
        const jlt_event event = { .column = 0, .level = 1 - d };
        jlt_outcome at;
        for (int k = 0; k < 6; k++) {
            const double expected = 2 * pi * (k / 2 + 1) - 1 + (k % 2 == 0 ? -half : half);
            assert_ok(jlt_orbit_next(orbit, INFINITY, &event, 1, &at));
            assert_int_equal(at.crossing.direction, k % 2 == 0 ? JLT_RISING : JLT_FALLING);
            assert_near(at.t, expected, 1e-11 / half);
        }
        jlt_orbit_destroy(orbit);
    }
}

/* cos t touches 1: within rounding of the amplitude it is a grazing or two crossings, never one; at 1 + 1e-9 it is nothing,
 * and the tolerance is far from resolving that in the polynomial (1e-7) so that the flow must decide. */
static void a_touch_is_grazing_and_a_near_miss_is_nothing(void **unused)
{
    (void)unused;
    jlt_outcome at;
    jlt_orbit *orbit = oscillator_orbit("dop853", 1e-14, 1, +1);
    const jlt_event miss = { .column = 0, .level = 1 + 1e-9, .grazing = true };
    assert_ok(jlt_orbit_next(orbit, 100, &miss, 1, &at));
    assert_int_equal(at.end, JLT_END_TIME);
    jlt_orbit_destroy(orbit);

    /* x1 = sin t from an exact start touches its amplitude after a quarter turn: one step, so within 16 roundings. */
    const double x[2] = { 1, 0 };
    const jlt_event touch = { .column = 0, .level = -1, .grazing = true };
    assert_ok(jlt_orbit_create(&orbit, NULL, &oscillator_field, &(jlt_options){ .tolerance = 1e-15 }));
    assert_ok(jlt_orbit_start(orbit, 0, x, +1));
    assert_ok(jlt_orbit_next(orbit, 4, &touch, 1, &at));
    assert_int_equal(at.end, JLT_END_EVENT);
    assert_near(at.t, pi, 1e-7);
    if (at.crossing.direction != 0) {
        assert_int_equal(at.crossing.direction, JLT_FALLING);
        assert_ok(jlt_orbit_next(orbit, 4, &touch, 1, &at));
        assert_int_equal(at.end, JLT_END_EVENT);
        assert_int_equal(at.crossing.direction, JLT_RISING);
    }
    assert_ok(jlt_orbit_next(orbit, 4, &touch, 1, &at));
    assert_int_equal(at.end, JLT_END_TIME);
    jlt_orbit_destroy(orbit);
}

/* Loose polynomial, tight truth: at tolerance 1e-6 crossings that the orbit itself has must come in pairs. */
static void near_tangencies_come_in_pairs_or_not_at_all_at_any_tolerance(void **unused)
{
    (void)unused;
    for (unsigned m = 0; m < 2; m++)
        for (double tolerance = 1e-5; tolerance > 1e-13; tolerance *= 0.1)
            for (int i = -20; i < 20; i++) {
                jlt_orbit *orbit = oscillator_orbit(methods[m], tolerance, 1, +1);
                const jlt_event event = { .column = 0, .level = 1 + i * tolerance };
                int balance = 0;
                for (;;) {
                    jlt_outcome at;
                    assert_ok(jlt_orbit_next(orbit, 30, &event, 1, &at));
                    if (at.end != JLT_END_EVENT) break;
                    balance += at.crossing.direction;
                    assert_true(balance == 0 || balance == 1);
                    assert_near(at.x[0], event.level, 1e-14);
                }
                assert_int_equal(balance, 0);
                jlt_orbit_destroy(orbit);
            }
}

/* Several events at once arrive in the order of time, also within one step, and time ends in between lose nothing. */
static void several_events_and_times_interleave_in_order(void **unused)
{
    (void)unused;
    for (unsigned m = 0; m < 2; m++) {
        jlt_orbit *orbit = oscillator_orbit(methods[m], 1e-13, 0.05, +1);
        const jlt_event events[4] = { { .column = 1 }, { .column = 0, .level = -0.5, .direction = JLT_RISING },
                                      { .column = 0, .level = -0.5, .direction = JLT_FALLING }, { .column = 0 } };
        /* Of cos t: through 0, -1/2, the minimum, -1/2, 0, the maximum. */
        const double phases[6] = { pi / 2, 2 * pi / 3, pi, 4 * pi / 3, 3 * pi / 2, 2 * pi };
        const unsigned order[6] = { 3, 2, 0, 1, 3, 0 };
        jlt_outcome at;
        int crossings = 0, times = 0;
        while (times < 20) { /* far apart: a step ends at t_end, and should hold several crossings */
            const double t_end = 5 * (times + 1);
            assert_ok(jlt_orbit_next(orbit, t_end, events, 4, &at));
            if (at.end == JLT_END_TIME) {
                assert_near(at.t, t_end, 0);
                assert_near(at.x[0], cos(t_end + 0.05), 1e-10);
                times++;
                continue;
            }
            assert_int_equal(at.crossing.event, order[crossings % 6]);
            assert_near(at.t, phases[crossings % 6] + crossings / 6 * 2 * pi - 0.05, 1e-10);
            crossings++;
        }
        int expected = 0;
        for (int turn = 0; turn < 20; turn++)
            for (unsigned k = 0; k < 6; k++) expected += phases[k] + 2 * pi * turn - 0.05 <= 100;
        assert_int_equal(crossings, expected);
        jlt_orbit_destroy(orbit);
    }
}

/* A step that ends within ten tolerances of the section leaves the crossing to the next; slopes of a hundred tolerances make that a
 * good part of a step, before its start or behind. The point handed out is on the section to rounding all the same. */
static void a_slow_crossing_is_where_the_orbit_crosses_wherever_steps_end(void **unused)
{
    (void)unused;
    const double tolerance = 1e-5, amplitude = 100 * tolerance;
    const jlt_event event = { .column = 0 };

    for (unsigned m = 0; m < METHODS; m++)
        for (int k = 0; k < 200; k++) {
            const double phase = 0.03 * k, x[2] = { amplitude * cos(phase), -amplitude * sin(phase) };
            jlt_orbit *orbit = NULL;
            jlt_outcome at;
            assert_ok(
                jlt_orbit_create(&orbit, jlt_method_find(methods[m]), &oscillator_field, &(jlt_options){ .tolerance = tolerance }));
            assert_ok(jlt_orbit_start(orbit, 0, x, +1));
            for (int n = 0; n < 4; n++) {
                assert_ok(jlt_orbit_next(orbit, INFINITY, &event, 1, &at));
                assert_near(at.x[0], 0, 1e-15);
            }
            jlt_orbit_destroy(orbit);
        }
}

static void creep(const double *restrict x, const double *restrict p, double *restrict f)
{
    (void)x;
    (void)p;
    f[0] = 1e-6;
}

/* An orbit that is within ten tolerances of the section, 1e-4, for 200 steps crosses it in the middle of them, either way. */
static void a_crossing_lies_on_the_section_however_many_steps_are_within_its_noise(void **unused)
{
    (void)unused;
    const jlt_field field = { .dim = 1, .call = creep, .root = -1 };
    const jlt_event event = { .column = 0 };

    for (unsigned m = 0; m < METHODS; m++)
        for (int direction = -1; direction <= 1; direction += 2) {
            const double x = -3e-4 * direction;
            jlt_orbit *orbit = NULL;
            jlt_outcome at;
            assert_ok(
                jlt_orbit_create(&orbit, jlt_method_find(methods[m]), &field, &(jlt_options){ .tolerance = 1e-5, .max_step = 1 }));
            assert_ok(jlt_orbit_start(orbit, 0, &x, direction));
            assert_ok(jlt_orbit_next(orbit, 1000 * direction, &event, 1, &at));
            assert_int_equal(at.end, JLT_END_EVENT);
            assert_int_equal(at.crossing.direction, JLT_RISING);
            assert_near(at.x[0], 0, 1e-17);
            assert_near(at.t, 300 * direction, 1e-10);
            assert_near(at.tau, at.t, 1e-10);
            assert_ok(jlt_orbit_next(orbit, 1000 * direction, &event, 1, &at));
            assert_int_equal(at.end, JLT_END_TIME);
            jlt_orbit_destroy(orbit);
        }
}

/* x1' = 1/b with b = 1 - x0 is rough near b = 0, and b^2 - 1e-6 an edge: steps shrink with b, and the edge is found. */
static void toward_edge(const double *restrict x, const double *restrict p, double *restrict f)
{
    (void)p;
    f[0] = 1;
    f[1] = 1 / (1 - x[0]);
}

static double room(void *context, const double *x)
{
    (void)context;
    return (1 - x[0]) * (1 - x[0]) - 1e-6;
}

static double half_the_way(void *context, const double *x, const double *f, double direction)
{
    (void)context;
    return direction * f[0] > 0 ? (1 - x[0]) / 2 : INFINITY;
}

static int note_halving(void *context, jlt_orbit *orbit)
{
    double *worst = context;
    const jlt_stepper *stepper = jlt_orbit_stepper(orbit);
    if (room(NULL, stepper->x) > 0) *worst = fmin(*worst, (1 - stepper->x[0]) / (1 - stepper->x_start[0]));
    return 0;
}

static void steps_shrink_toward_an_edge_and_find_it(void **unused)
{
    (void)unused;
    const jlt_field field = { .dim = 2, .call = toward_edge, .root = -1 };
    const jlt_event edge = { .value = room, .longest_step = half_the_way };
    const double start[2] = { 0, 0 };

    for (unsigned m = 0; m < METHODS; m++) {
        double least = 1;
        jlt_orbit *orbit = NULL;
        jlt_outcome at;
        assert_ok(jlt_orbit_create(&orbit, jlt_method_find(methods[m]), &field, &(jlt_options){ .tolerance = 1e-3 }));
        jlt_orbit_observe(orbit, note_halving, &least);
        assert_ok(jlt_orbit_start(orbit, 0, start, +1));
        assert_ok(jlt_orbit_next(orbit, 2, &edge, 1, &at));
        assert_int_equal(at.end, JLT_END_EVENT);
        assert_near(at.x[0], 1 - 1e-3, 1e-9);
        assert_true(least >= 0.5 - 1e-9);
        jlt_orbit_destroy(orbit);
    }
}

/* At rest on the section until t = 1, then off it to the side of p. */
static void leaving_late(const double *restrict x, const double *restrict p, double *restrict f)
{
    const double since = fmax(0, x[0] - 1);
    f[0] = 1;
    f[1] = p[0] * since * since * since;
}

/* An orbit that has been on the section since its start belongs to the side it leaves to at last: that is no crossing. Not by
 * gauss, whose steps take a field for smoother than this one is. */
static void leaving_the_section_after_a_while_on_it_is_no_crossing(void **unused)
{
    (void)unused;
    for (unsigned m = 0; m < METHODS; m++)
        for (int side = -1; side <= 1; side++) {
            const double p = side, x[2] = { 0, 0 };
            const jlt_field field = { .dim = 2, .call = leaving_late, .p = &p, .root = -1 };
            const jlt_event event = { .column = 1 };
            jlt_orbit *orbit = NULL;
            jlt_outcome at;
            if (strcmp(methods[m], "gauss") == 0) continue;
            assert_ok(jlt_orbit_create(&orbit, jlt_method_find(methods[m]), &field,
                                       &(jlt_options){ .tolerance = 1e-9, .max_step = 0.25 }));
            assert_ok(jlt_orbit_start(orbit, 0, x, +1));
            assert_ok(jlt_orbit_next(orbit, 3, &event, 1, &at));
            if (at.end != JLT_END_TIME) fail_msg("%s, side %d: an event at t = %g", methods[m], side, at.t);
            assert_near(at.x[1], 4.0 * side, 1e-6);
            jlt_orbit_destroy(orbit);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(crossings_of_the_oscillator_come_once_each_in_order),
        cmocka_unit_test(a_backward_run_meets_the_same_crossings_with_the_same_directions),
        cmocka_unit_test(a_start_on_the_section_is_no_crossing),
        cmocka_unit_test(restarting_from_crossings_neither_repeats_nor_skips),
        cmocka_unit_test(another_list_neither_repeats_nor_skips),
        cmocka_unit_test(two_zeros_within_a_step_are_two_crossings),
        cmocka_unit_test(a_touch_is_grazing_and_a_near_miss_is_nothing),
        cmocka_unit_test(near_tangencies_come_in_pairs_or_not_at_all_at_any_tolerance),
        cmocka_unit_test(a_slow_crossing_is_where_the_orbit_crosses_wherever_steps_end),
        cmocka_unit_test(a_crossing_lies_on_the_section_however_many_steps_are_within_its_noise),
        cmocka_unit_test(steps_shrink_toward_an_edge_and_find_it),
        cmocka_unit_test(several_events_and_times_interleave_in_order),
        cmocka_unit_test(leaving_the_section_after_a_while_on_it_is_no_crossing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
