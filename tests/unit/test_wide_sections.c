/* Sections of fields with as many states as a table may have: rows, derivatives, exponents and Newton's method on 127
 * coordinates. */
#include "unit/check.h"

#include "dynamics/lyapunov.h"
#include "dynamics/periodic.h"

#include <stdio.h>

enum { PAIRS = 64, N = 2 * PAIRS };
static const double pi = 3.14159265358979323846, damping = 0.05;

/* (q_i, p_i) = x[2i], x[2i + 1]: q'' = -q for the first pair, q'' = -2 s q' - (w_i^2 + s^2) q for the others, whose solution is
 * exp(-s t) times a rotation by w_i t of (w q, q' + s q). */
static double frequency(unsigned pair)
{
    return 1 + (double)pair / PAIRS;
}

static void field(const double *restrict x, const double *restrict p, double *restrict f)
{
    (void)p;
    for (unsigned i = 0; i < PAIRS; i++) {
        const double w = frequency(i), s = i == 0 ? 0 : damping;
        f[2 * i] = x[2 * i + 1];
        f[2 * i + 1] = -(w * w + s * s) * x[2 * i] - 2 * s * x[2 * i + 1];
    }
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)x;
    (void)p;
    memset(out, 0, N * N * sizeof *out);
    for (unsigned i = 0; i < PAIRS; i++) {
        const double w = frequency(i), s = i == 0 ? 0 : damping;
        out[2 * i * N + 2 * i + 1] = 1;
        out[(2 * i + 1) * N + 2 * i] = -(w * w + s * s);
        out[(2 * i + 1) * N + 2 * i + 1] = -2 * s;
    }
}

static char names[N][8];
static jlt_chart chart;
static const jlt_field wide = { .dim = N, .call = field, .jacobian = jacobian, .root = -1 };
static const jlt_flow flow = { .chart = &chart, .field = &wide, .tolerance = 1e-10, .direction = JLT_RISING };
/* With derivatives. */
static const jlt_flow loose = { .chart = &chart, .field = &wide, .tolerance = 1e-7, .direction = JLT_RISING };

/* The section q_0 = 0: coordinate 0 is p_0, coordinates 2i - 1 and 2i are q_i and p_i. */
static int make_chart(void **unused)
{
    const char *pointers[N];

    (void)unused;
    for (unsigned i = 0; i < N; i++) {
        snprintf(names[i], sizeof names[i], "x%u", i);
        pointers[i] = names[i];
    }
    return jlt_chart_plane(&chart, N, 0, 0, pointers, NULL) != JLT_OK;
}

static void start(double *q)
{
    q[0] = 1;
    for (unsigned k = 1; k < N - 1; k++) q[k] = 0.3 * sin(k);
}

/* What becomes of a pair after so many turns of the first. */
static void turn(double *q, double *p, unsigned pair, double turns)
{
    const double w = frequency(pair), t = 2 * pi * turns, decay = exp(-damping * t), at = *q, rate = (*p + damping * at) / w;

    *q = decay * (at * cos(w * t) + rate * sin(w * t));
    *p = decay * w * (rate * cos(w * t) - at * sin(w * t)) - damping * *q;
}

/* Oracle: the solution of the linear oscillators. Ten returns err by about the tolerance; ten times that for frequencies up to
 * 2. */
static void returns_are_those_of_the_oscillators(void **unused)
{
    double q[N - 1], want[N - 1];
    jlt_section *section;
    jlt_return row;

    (void)unused;
    start(q);
    memcpy(want, q, sizeof want);
    assert_ok(jlt_section_create(&section, &flow));
    assert_ok(jlt_section_start(section, &row, q, 1));
    for (unsigned i = 0; i < 3; i++) assert_ok(jlt_section_next(section, &row));
    assert_near(row.t, 6 * pi, 1e-9);
    assert_near(row.q[0], 1, 1e-9);
    for (unsigned i = 1; i < PAIRS; i++) {
        turn(&want[2 * i - 1], &want[2 * i], i, 3);
        assert_near(row.q[2 * i - 1], want[2 * i - 1], 1e-9);
        assert_near(row.q[2 * i], want[2 * i], 1e-9);
    }
    jlt_section_destroy(section);
}

/* Oracle: all exponents are -damping but for the first pair's, which is 0; after one return they are off by the logarithm of the
 * ratio of w q and p, at most ln 2 over 2 pi. Their sum is the divergence, to the tolerance a step. */
static void exponents_add_up_to_the_divergence(void **unused)
{
    double q[N - 1], sum = 0;
    jlt_lyapunov_state state;
    jlt_map *map;

    (void)unused;
    start(q);
    assert_ok(jlt_map_create(&map, &loose));
    assert_ok(jlt_lyapunov_run(map, &state, q, 1, NULL, NULL));
    for (unsigned k = 0; k < N - 1; k++) sum += state.exponents[k];
    assert_near(sum, -2 * damping * (PAIRS - 1), 1e-5);
    assert_near(state.sum_check, -2 * damping * (PAIRS - 1), 1e-5);
    for (unsigned k = 1; k < N - 1; k++) assert_near(state.exponents[k], -damping, log(2) / (2 * pi));
    jlt_map_destroy(map);
}

/* Oracle: all damped pairs rest, the first one runs on for ever with period 2 pi; the multipliers are 1 for its family, whose
 * member is held, and exp(-2 pi damping) in modulus, whose digits are those of a return with derivative. */
static void newton_finds_the_one_orbit_that_does_not_decay(void **unused)
{
    unsigned char held[N - 1] = { 1 };
    double q[N - 1];
    jlt_periodic orbit;
    jlt_map *map;

    (void)unused;
    start(q);
    assert_ok(jlt_map_create(&map, &loose));
    assert_ok(jlt_periodic_find(map, &orbit, q, 1, held));
    assert_near(orbit.T, 2 * pi, 1e-6);
    assert_near(orbit.points[0], 1, 1e-15);
    for (unsigned k = 1; k < N - 1; k++) assert_near(orbit.points[k], 0, 1e-7);
    assert_near(hypot(orbit.re[0], orbit.im[0]), 1, 1e-6);
    for (unsigned k = 1; k < N - 1; k++) assert_near(hypot(orbit.re[k], orbit.im[k]), exp(-2 * pi * damping), 1e-5);
    jlt_map_destroy(map);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(returns_are_those_of_the_oscillators),
        cmocka_unit_test(exponents_add_up_to_the_divergence),
        cmocka_unit_test(newton_finds_the_one_orbit_that_does_not_decay),
    };
    return cmocka_run_group_tests(tests, make_chart, NULL);
}
