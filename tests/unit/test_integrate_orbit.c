/* Orbits: how runs end, invariants, variational equations, poles that are and are not reached. */
#include "unit/check.h"
#include "unit/sample_fields.h"

#include "integrate/orbit.h"
#include "integrate/pole.h"
#include "reference/spherical_top.h"

static const double p51[6] = { 1, 1, 1, 1.0 / 3, 1.0 / 3, 0.51 };
static const jlt_field regular = { .dim = 6, .call = top_regular, .p = p51, .time_rate = top_time_rate, .root = 5 };
static const jlt_field oscillator_field = { .dim = 2, .call = oscillator, .root = -1 };

static void energy(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = 0.5 * (x[0] * x[0] + x[1] * x[1]);
}

static void energy_gradient(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[0];
    out[1] = x[1];
}

static const jlt_invariants oscillator_energy = { .count = 1, .values = energy, .gradients = energy_gradient };

static int stop_after(void *context, jlt_orbit *orbit)
{
    (void)orbit;
    return --*(int *)context == 0;
}

/* The point of an end is handed out: what lies before it, even by many steps, cannot be asked for any more. */
static void runs_end_by_budget_observer_and_interrupt_with_the_last_point(void **unused)
{
    (void)unused;
    const double x[2] = { 1, 0 };
    volatile sig_atomic_t flag = 0;
    jlt_orbit *orbit = NULL;
    jlt_outcome at;
    int left = 7;

    assert_ok(jlt_orbit_create(&orbit, NULL, &oscillator_field,
                               &(jlt_options){ .tolerance = 1e-10, .max_steps = 20, .interrupt = &flag }));
    assert_ok(jlt_orbit_start(orbit, 0, x, +1));
    assert_int_equal(jlt_orbit_next(orbit, 1e6, NULL, 0, &at), JLT_ERR_BUDGET);
    const jlt_stepper *stepper = jlt_orbit_stepper(orbit);
    assert_int_equal(stepper->steps + stepper->rejected, 20);
    assert_near(at.t, stepper->tau, 0);
    assert_near(at.x[0], cos(at.t), 1e-8);
    assert_int_equal(jlt_orbit_next(orbit, at.t / 2, NULL, 0, &at), JLT_ERR_ARG);

    jlt_orbit_observe(orbit, stop_after, &left);
    assert_ok(jlt_orbit_next(orbit, 1e6, NULL, 0, &at));
    assert_int_equal(at.end, JLT_END_OBSERVER);
    assert_int_equal(stepper->steps + stepper->rejected, 27);
    assert_int_equal(jlt_orbit_next(orbit, at.t - 1, NULL, 0, &at), JLT_ERR_ARG);

    jlt_orbit_observe(orbit, NULL, NULL);
    flag = 1;
    assert_ok(jlt_orbit_next(orbit, 1e6, NULL, 0, &at));
    assert_int_equal(at.end, JLT_END_INTERRUPT);
    flag = 0;
    assert_ok(jlt_orbit_next(orbit, at.t + 1, NULL, 0, &at));
    assert_int_equal(at.end, JLT_END_TIME);
    assert_near(at.x[0], cos(at.t), 1e-7);
    jlt_orbit_destroy(orbit);
}

/* At a loose tolerance the energy drifts by far more than rounding, with a method that does not keep quadratic integrals by
 * itself; projected it ends at rounding, and the drift noted is that of single steps before their projection. */
static void projection_holds_the_energy_and_drift_is_reported(void **unused)
{
    (void)unused;
    const double x[2] = { 1, 0 };
    double drift[2];
    for (int project = 0; project < 2; project++) {
        double end[2];
        jlt_orbit *orbit = NULL;
        assert_ok(jlt_orbit_create(&orbit, jlt_method_find("dop853"), &oscillator_field,
                                   &(jlt_options){ .tolerance = 3e-5, .invariants = oscillator_energy, .project = project }));
        assert_ok(jlt_orbit_start(orbit, 0, x, +1));
        assert_ok(jlt_orbit_propagate(orbit, 300, end));
        jlt_orbit_drift(orbit, &drift[project]);
        if (project) assert_near(hypot(end[0], end[1]), 1, 1e-15);
        jlt_orbit_destroy(orbit);
    }
    assert_true(drift[0] > 1e-6);
    assert_below(drift[1], 1e-5);
}

/* The sums are compensated, so what remains systematic is the rounding of the coefficients b_i, 2^-54 relative: at h = 0.02
 * at most 1.1e-18 a step, 1.1e-12 in 10^6 steps. In the phase the same acts on every step: 20000 * 2^-54. */
static void sums_are_compensated_over_a_million_steps(void **unused)
{
    (void)unused;
    const double x[2] = { 1, 0 };
    double end[2], drift;
    jlt_orbit *orbit = NULL;
    assert_ok(jlt_orbit_create(&orbit, NULL, &oscillator_field,
                               &(jlt_options){ .tolerance = 1e-15, .max_step = 0.02, .invariants = oscillator_energy }));
    assert_ok(jlt_orbit_start(orbit, 0, x, +1));
    assert_ok(jlt_orbit_propagate(orbit, 20000, end));
    jlt_orbit_drift(orbit, &drift);
    assert_below(drift, 1.1e-12);
    assert_near(end[0], cos(20000), 1e-11);
    assert_near(end[1], -sin(20000), 1e-11);
    jlt_orbit_destroy(orbit);
}

/* On s = 0 with sigma = gamma3 the rates are -sigma omega_tau and (I1 sigma omega_tau - m b v)/(I1 + m b^2): a point that
 * attracts ends there; where the second is positive the orbit lingers and leaves, and s is the distance of the miss. */
static void an_orbit_that_only_passes_a_pole_is_not_ended(void **unused)
{
    (void)unused;
    jlt_orbit *orbit = NULL;
    jlt_outcome at;


    for (int attracts = 0; attracts < 2; attracts++)
        for (int exponent = 9; exponent <= 12; exponent++) {
            const double s = pow(10, -exponent), wt = 0.6, v = attracts ? 1 : -0.5;
            const double x[6] = { sqrt((1 - s) * (1 + s)), v, wt, s, -1, s };
            assert_ok(jlt_orbit_create(&orbit, NULL, &regular, &(jlt_options){ .tolerance = 1e-13 }));
            assert_ok(jlt_orbit_start(orbit, 0, x, +1));
            assert_ok(jlt_orbit_next(orbit, 1, NULL, 0, &at));
            assert_int_equal(at.end, attracts ? JLT_END_POLE : JLT_END_TIME);
            if (attracts) {
                assert_near(at.t, s / wt, 1e-14);
                assert_near(at.x[1], v, 1e-12);
                assert_near(at.x[2], wt, 1e-12);
                assert_near(at.pole_rates[0], wt, 1e-9);
            }
            jlt_orbit_destroy(orbit);
        }
}

/* Asked not to look for poles, a run towards one goes on until its budget ends, with t at its limit. */
static void ignoring_poles_runs_to_the_budget(void **unused)
{
    (void)unused;
    jlt_orbit *orbit = NULL;
    jlt_outcome at;
    const double x[6] = { sqrt((1 - 1e-8) * (1 + 1e-8)), 1, 0.6, 1e-8, -1, 1e-8 };
    assert_ok(jlt_orbit_create(&orbit, NULL, &regular, &(jlt_options){ .max_steps = 500, .ignore_pole = true }));
    assert_ok(jlt_orbit_start(orbit, 0, x, +1));
    assert_int_equal(jlt_orbit_next(orbit, 1, NULL, 0, &at), JLT_ERR_BUDGET);
    assert_near(at.t, 1e-8 / 0.6, 1e-14);
    jlt_orbit_destroy(orbit);
}

/* phi(-T) phi(T) = identity to the tolerance times the amplification, here below 1e3 each way. */
static void going_there_and_back_returns(void **unused)
{
    (void)unused;
    jlt_orbit *orbit = NULL;
    double start[6], x[6], back[6];
    top_section_point(start, p51, 0.44, -0.62, 2.15, -0.56);
    assert_ok(jlt_orbit_create(&orbit, NULL, &regular, &(jlt_options){ .tolerance = 1e-14 }));
    assert_ok(jlt_orbit_start(orbit, 0, start, +1));
    assert_ok(jlt_orbit_propagate(orbit, 20, x));
    assert_ok(jlt_orbit_start(orbit, 20, x, -1));
    assert_ok(jlt_orbit_propagate(orbit, 0, back));
    for (unsigned i = 0; i < 6; i++) assert_near(back[i], start[i], 1e-11);
    jlt_orbit_destroy(orbit);
}

static void options_out_of_range_are_refused(void **unused)
{
    (void)unused;
    jlt_orbit *orbit = NULL;
    const double x[2] = { 1, 0 };
    const jlt_event beyond = { .column = 2 };
    jlt_outcome at;
    assert_int_equal(jlt_orbit_create(&orbit, NULL, &oscillator_field, &(jlt_options){ .tolerance = -1 }), JLT_ERR_ARG);
    assert_int_equal(jlt_orbit_create(&orbit, NULL, &oscillator_field, &(jlt_options){ .project = true }), JLT_ERR_ARG);
    assert_null(orbit);
    assert_ok(jlt_orbit_create(&orbit, NULL, &oscillator_field, NULL));
    assert_ok(jlt_orbit_start(orbit, 0, x, +1));
    assert_int_equal(jlt_orbit_next(orbit, 1, &beyond, 1, &at), JLT_ERR_ARG);
    assert_int_equal(jlt_orbit_next(orbit, NAN, NULL, 0, &at), JLT_ERR_ARG);
    jlt_orbit_destroy(orbit);
    jlt_orbit_destroy(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(runs_end_by_budget_observer_and_interrupt_with_the_last_point),
        cmocka_unit_test(projection_holds_the_energy_and_drift_is_reported),
        cmocka_unit_test(sums_are_compensated_over_a_million_steps),
        cmocka_unit_test(an_orbit_that_only_passes_a_pole_is_not_ended),
        cmocka_unit_test(ignoring_poles_runs_to_the_budget),
        cmocka_unit_test(going_there_and_back_returns),
        cmocka_unit_test(options_out_of_range_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
