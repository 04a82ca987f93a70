/* Fates of orbits from a section, and the cells that orbits visit. */
#include "property/top_51.h"

#include "dynamics/fates.h"
#include "dynamics/separation.h"

/* The option decides whether loss of contact ends an orbit; orbits of (5.1) that turn over lose it on the way. */
static void loss_of_contact_ends_orbits_when_asked(void **unused)
{
    const double q[2] = { 2, -0.5 };
    jlt_system *system = top_51(1e-12);
    jlt_flow ending = system->flow;
    jlt_section *section;
    jlt_fates_count count = { 0 };
    jlt_fates_end end;
    double share, error;

    (void)unused;
    assert_ok(jlt_section_create(&section, &system->flow));
    assert_ok(jlt_fates_follow(section, &end, q, 50));
    assert_int_equal(end.fate, JLT_FATE_POLE_PLUS);
    assert_true(end.least < 0);
    jlt_fates_add(&count, &end);
    jlt_section_destroy(section);
    ending.end_where_invalid = true;
    assert_ok(jlt_section_create(&section, &ending));
    assert_ok(jlt_fates_follow(section, &end, q, 50));
    assert_int_equal(end.fate, JLT_FATE_INVALID);
    assert_near(jlt_observed_least(system->observed, NULL, end.x), 0, 1e-10);
    jlt_fates_add(&count, &end);
    jlt_fates_share(&share, &error, count.by_fate[JLT_FATE_POLE_PLUS], count.starts);
    assert_near(share, 0.5, 0);
    assert_near(error, sqrt((0.5 + error) * (0.5 - error) / 2), 1e-15); /* the standard error of the interval's end */
    jlt_fates_share(&share, &error, count.valid[JLT_FATE_POLE_PLUS], count.starts);
    assert_near(share, 0, 0);
    assert_near(error, sqrt(error * (1 - error) / 2), 1e-15);
    assert_true(error > 0);
    jlt_section_destroy(section);
    jlt_system_destroy(system);
}

/* With a3 = 0 the family (4.4) of the paper attracts where its trace is negative: an orbit comes to rest there, with
 * omega_tau = omega_n = 0, and is not followed into rounding errors. */
static void orbits_come_to_rest_on_attracting_equilibria(void **unused)
{
    const double q[2] = { 1.0471975511965974, 0.3 };
    const jlt_flow options = { .tolerance = 1e-12, .direction = JLT_RISING };
    jlt_top_values values = jlt_system_top_defaults();
    jlt_section *section;
    jlt_system *system;
    jlt_fates_end end;
    double omega_n, omega3;

    (void)unused;
    values.a3 = 0;
    assert_ok(jlt_system_top(&system, &values, &options));
    assert_ok(jlt_section_create(&section, &system->flow));
    assert_ok(jlt_fates_follow(section, &end, q, 100000));
    assert_int_equal(end.fate, JLT_FATE_EQUILIBRIUM);
    assert_true(end.returns < 1000);
    jlt_chart_top_rotation(jlt_system_top_chart(system), &omega_n, &omega3, end.x);
    assert_near(omega_n, 0, 1e-11);
    assert_near(end.x[JLT_CHART_TOP_OMEGA_TAU], 0, 1e-11);
    /* (4.6): tr A = -m R I3 gamma3 v_nu/(s Theta) < 0 */
    assert_true(end.x[JLT_CHART_TOP_GAMMA3] * end.x[JLT_CHART_TOP_V_NU] > 0);
    jlt_section_destroy(section);
    jlt_system_destroy(system);
}

/* Two known cases: an island of symmetric tori, where the forward and backward sets agree, and an attracting fixed point whose
 * mirror image repels, where they share nothing. */
static void attractor_and_repeller_are_told_apart(void **unused)
{
    const jlt_separation_options options = { .low = { -3.2, -1 }, .high = { 3.2, 1 }, .cells = { 80, 80 },
                                             .settle = 60, .returns = 256 };
    const double island[4] = { 0.43, -0.62, -0.43, -0.62 }, basin[2] = { 2.8395, -0.95874 };
    double starts[4];
    jlt_top_values values = { 1, 1, 1, 0.591, 0.494, 0.548, 2.15, 0.161 };
    const jlt_flow flow = { .tolerance = 1e-11, .direction = JLT_RISING };
    jlt_separation rows[48];
    jlt_system *system = top_51(1e-11);
    size_t count;

    (void)unused;
    assert_ok(jlt_separation_measure(rows, &count, &system->flow, island, 2, &options));
    assert_int_equal(count, 9);
    assert_int_equal(rows[8].alive_forward, 2);
    assert_near(rows[8].overlap, 1, 0.1);
    assert_near(rows[8].mirror_overlap, 1, 0.1);
    jlt_system_destroy(system);

    assert_ok(jlt_system_top(&system, &values, &flow));
    starts[0] = basin[0], starts[1] = basin[1];
    starts[2] = -basin[0], starts[3] = basin[1];
    assert_ok(jlt_separation_measure(rows, &count, &system->flow, starts, 2, &options));
    assert_true(rows[8].alive_forward >= 1 && rows[8].alive_backward >= 1);
    assert_near(rows[8].overlap, 0, 0);
    assert_near(rows[8].mirror_overlap, 1, 0);
    jlt_system_destroy(system);
}

/* Eighty cells around an angle are the same ones from wherever they are counted. */
static void cells_of_an_angle_go_around(void **unused)
{
    const double pi = acos(-1), starts[] = { 0.43, -0.62, -0.43, -0.62, 2, -0.5, 0.9, -0.3 };
    jlt_separation_options options = { .low = { -pi, -1 }, .high = { pi, 1 }, .cells = { 80, 80 }, .settle = 0, .returns = 100 };
    jlt_separation around[48], shifted[48];
    jlt_system *system = top_51(1e-12);
    size_t count;

    (void)unused;
    assert_ok(jlt_separation_measure(around, &count, &system->flow, starts, 4, &options));
    for (int quarter = -3; quarter <= 5; quarter += 4) {
        options.low[0] = quarter * pi / 2;
        options.high[0] = options.low[0] + 2 * pi;
        assert_ok(jlt_separation_measure(shifted, &count, &system->flow, starts, 4, &options));
        assert_memory_equal(around, shifted, count * sizeof *around);
    }
    jlt_system_destroy(system);
}

/* Orbits backwards that are taken for mirror images are those that are followed, to the cell; of the starts two have no mirror
 * image among the others and come to poles, and one is on the symmetry line, its own image. */
static void mirror_images_are_the_orbits_backwards(void **unused)
{
    const double starts[] = { 0.43, -0.62, -0.43, -0.62, 0, -0.6, 2, -0.5, 0.9, -0.3 };
    jlt_separation_options options = { .low = { -3.2, -1 }, .high = { 3.2, 1 }, .cells = { 80, 80 }, .settle = 0, .returns = 100 };
    jlt_separation followed[48], mirrored[48];
    jlt_system *system = top_51(1e-12);
    size_t count;

    (void)unused;
    assert_ok(jlt_separation_measure(followed, &count, &system->flow, starts, 5, &options));
    assert_in_range(followed[0].alive_forward, 1, 5);
    assert_true(followed[7].forward != followed[7].backward && followed[7].mirror_overlap < 1);
    options.by_mirror = true;
    assert_ok(jlt_separation_measure(mirrored, &count, &system->flow, starts, 5, &options));
    assert_int_equal(count, 8);
    for (size_t i = 0; i < count; i++) {
        assert_int_equal(mirrored[i].alive_forward, followed[i].alive_forward);
        assert_int_equal(mirrored[i].alive_backward, followed[i].alive_backward);
        assert_int_equal(mirrored[i].forward, followed[i].forward);
        assert_int_equal(mirrored[i].backward, followed[i].backward);
        assert_int_equal(mirrored[i].common, followed[i].common);
        assert_near(mirrored[i].mirror_overlap, followed[i].mirror_overlap, 0);
    }
    jlt_system_destroy(system);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(loss_of_contact_ends_orbits_when_asked),
        cmocka_unit_test(orbits_come_to_rest_on_attracting_equilibria),
        cmocka_unit_test(attractor_and_repeller_are_told_apart),
        cmocka_unit_test(cells_of_an_angle_go_around),
        cmocka_unit_test(mirror_images_are_the_orbits_backwards),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
