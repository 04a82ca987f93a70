/* The section omega_tau = 0 touched: orbits whose omega_tau has an extremum of value delta, so that they cross twice within
 * 2 sqrt(2 |delta|/c), or not at all, c the second derivative there. And starts on the section.
 * Oracle: the extremum's own state, from which the orbit is followed backwards to its start; times by the parabola. */
#include "ride.h"

#include "integrate/batch.h"
#include "kernel/batch_isa.h"
#include "reference/csv.h"
#include "reference/spherical_top.h"

static const double by_hand[6] = { 1, 1, 1, 1.0 / 3, 1.0 / 3, 0.51 };
static const double before = 0.25; /* time from the start to the extremum */

/* omega_tau' at a state, by the field written by hand. */
static double slope(const double *x)
{
    double f[JLT_TOP_STATES];
    top_plain(x, by_hand, f);
    return f[2];
}

/* omega_tau'' by a central difference along the flow: good to 1e-8, and needed to a percent. */
static double curvature(const double *x)
{
    const double h = 1e-5;
    double f[JLT_TOP_STATES], ahead[JLT_TOP_STATES], behind[JLT_TOP_STATES];
    top_plain(x, by_hand, f);
    for (int i = 0; i < JLT_TOP_STATES; i++) {
        ahead[i] = x[i] + h * f[i];
        behind[i] = x[i] - h * f[i];
    }
    return (slope(ahead) - slope(behind)) / (2 * h);
}

/* A state with omega_tau = delta and omega_tau' = 0, which is linear in omega3; twice for the rounding. */
static void extremum(double *x, double gamma3, double v_nu, double omega_n, double delta)
{
    const double start[JLT_TOP_STATES] = { gamma3, v_nu, delta, omega_n, 0 };

    memcpy(x, start, sizeof start);
    for (int i = 0; i < 2; i++) {
        const double here = slope(x);
        double shifted[JLT_TOP_STATES];
        memcpy(shifted, x, sizeof shifted);
        shifted[4] += 1;
        x[4] -= here / (slope(shifted) - here);
    }
}

typedef struct {
    double x[JLT_TOP_STATES]; /* `before` the extremum */
    double c;
} tangency;

/* Some extrema that are neither too flat nor near a pole. */
static size_t make_tangencies(tangency *out, size_t most, double delta)
{
    size_t count = 0;
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 4 && count < most; j++) {
            double x[JLT_TOP_STATES], y[RIDE_COLUMNS];
            ride r;
            extremum(x, -0.6 + 0.2 * i, -1.8 + 1.1 * j, i % 2 == 0 ? -1.3 : 0.8, delta);
            const double c = curvature(x);
            if (!(fabs(c) > 0.1)) continue;
            ride_open(&r, "level", &top_51, x, jlt_method_find("gauss"), &(jlt_options){ .tolerance = 1e-15 }, -1);
            assert_ok(jlt_orbit_propagate(r.orbit, -before, y));
            ride_states(&r, out[count].x, y);
            ride_close(&r);
            out[count++].c = c;
        }
    return count;
}

typedef struct {
    int count, grazing, direction[8];
    double t[8];
} met;

static met crossings(const tangency *from, const char *tier, const jlt_method *method, double tolerance)
{
    const jlt_event section = { .column = 2, .grazing = true };
    met m = { 0 };
    jlt_outcome at;
    ride r;

    ride_open(&r, tier, &top_51, from->x, method, &(jlt_options){ .tolerance = tolerance }, +1);
    for (;;) {
        assert_ok(jlt_orbit_next(r.orbit, 2 * before, &section, 1, &at));
        if (at.end == JLT_END_TIME) break;
        assert_int_equal(at.end, JLT_END_EVENT);
        if (at.crossing.direction == 0) {
            m.grazing++;
            continue;
        }
        assert_true(m.count < 8);
        m.direction[m.count] = at.crossing.direction;
        m.t[m.count++] = at.t;
    }
    ride_close(&r);
    return m;
}

enum { TANGENCIES = 24 };
static const double depths[] = { 1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15, 0 };
enum { DEPTHS = sizeof depths / sizeof *depths };

/* The extremum is known to the method's error: 100 steps of the tolerance. Beyond, two crossings or none, as it must be; within,
 * two, none or a touch, but never one. Their times: the cubic term moves both by less than 3 h^2 (h < 0.1), and an error of the
 * extremum by e/(c h). */
static void two_crossings_or_none_never_one(void **state)
{
    static const double tolerances[] = { 1e-13, 1e-10, 1e-7 };

    (void)state;
    for (size_t d = 0; d < 2 * DEPTHS - 1; d++) {
        const double delta = d < DEPTHS ? depths[d] : -depths[d - DEPTHS];
        tangency all[TANGENCIES];
        const size_t count = make_tangencies(all, TANGENCIES, delta);
        assert_true(count >= 8);
        for (size_t m = 0; jlt_method_at(m) != NULL; m++)
            for (size_t k = 0; k < 6; k++) {
                const double tolerance = tolerances[k % 3], error = 1000 * tolerance;
                for (size_t i = 0; i < count; i++) {
                    const met got = crossings(&all[i], k < 3 ? "level" : "five_plain", jlt_method_at(m), tolerance);
                    const bool twice = delta * all[i].c < 0;
                    const double h = sqrt(2 * fabs(delta / all[i].c));
                    assert_true(got.count % 2 == 0 && got.count + got.grazing <= 2);
                    if (got.count == 2) {
                        assert_int_equal(got.direction[0], all[i].c > 0 ? JLT_FALLING : JLT_RISING);
                        assert_int_equal(got.direction[1], -got.direction[0]);
                        const double reach = sqrt(2 * (fabs(delta) + error) / fabs(all[i].c));
                        for (int j = 0; j < 2; j++) assert_near(got.t[j], before, reach + 3 * reach * reach);
                    }
                    if (fabs(delta) <= error) continue;
                    assert_int_equal(got.count, twice ? 2 : 0);
                    assert_int_equal(got.grazing, 0);
                    if (twice) {
                        assert_near(got.t[0], before - h, 3 * h * h + error / (fabs(all[i].c) * h));
                        assert_near(got.t[1], before + h, 3 * h * h + error / (fabs(all[i].c) * h));
                    }
                }
            }
    }
}

typedef struct {
    int count;
    double x[8][5];
} batch_rows;

static int keep_row(void *context, size_t orbit, size_t number, const double *x)
{
    batch_rows *r = context;
    (void)orbit, (void)number;
    if (r->count < 8) memcpy(r->x[r->count], x, sizeof r->x[0]);
    r->count++;
    return 0;
}

static int keep_end(void *context, size_t orbit, jlt_lane_end end, size_t returns, const double *x)
{
    (void)context, (void)orbit, (void)end, (void)returns, (void)x;
    return 0;
}

static jlt_batch_map batch_of(const ride *r, const jlt_batch_case *only, double tolerance, int direction)
{
    return (jlt_batch_map){ .kernels = jlt_batch_isa_best(r->instance->descriptor, 0), .cases = only, .dim = 5,
                            .column = 2, .direction = direction, .root = 4, .root_floor = 1e-10, .tolerance = tolerance,
                            .max_steps = 100000 };
}

/* Batches look for hidden pairs as well: the first two crossings of an orbit are those of a single orbit, and so are their states,
 * where the section is crossed all but along itself. */
static void batches_find_the_same_pairs(void **state)
{
    (void)state;
    for (size_t d = 0; d < 2 * DEPTHS - 1; d++) {
        const double delta = d < DEPTHS ? depths[d] : -depths[d - DEPTHS];
        tangency all[TANGENCIES];
        const size_t count = make_tangencies(all, TANGENCIES, delta);
        int missed = 0, spurious = 0;
        for (size_t i = 0; i < count; i++) {
            double y[RIDE_COLUMNS];
            batch_rows rows = { 0 };
            jlt_outcome at;
            const jlt_event section = { .column = 2 };
            ride r;
            ride_open(&r, "level", &top_51, all[i].x, NULL, &(jlt_options){ .tolerance = 1e-13 }, +1);
            memcpy(y, r.start, sizeof r.start);
            const jlt_batch_map map = batch_of(&r, &(jlt_batch_case){ .p = r.instance->prepared }, 1e-13, 0);
            assert_ok(jlt_batch_section(&map, y, 1, 2, keep_row, keep_end, &rows, NULL));
            double off = 0;
            for (int k = 0; k < rows.count; k++) {
                assert_ok(jlt_orbit_next(r.orbit, INFINITY, &section, 1, &at));
                if (at.end != JLT_END_EVENT) break;
                for (int j = 0; j < 5; j++) off = fmax(off, fabs(at.x[j] - rows.x[k][j]));
            }
            if (off > 1e-3) {
                if (delta * all[i].c < 0) missed++;
                else spurious++;
            }
            ride_close(&r);
        }
        if (fabs(delta) > 1e-10) assert_int_equal(missed + spurious, 0); /* a thousand tolerances, as above */
    }
}

enum { ROWS = 64 * 11, COLUMNS = 7 };
static double rows[ROWS][COLUMNS]; /* orbit, return, t, gamma3, v_nu, omega_n, omega3 */

/* From a return, or off it by rounding, the next crossing upwards is the next return, and one downwards lies between. */
static void a_start_on_the_section_is_no_crossing(void **state)
{
    static const double offsets[] = { 0, -0.0, 1e-17, -1e-17, 3e-14, -3e-14 };
    static const char *const tiers[] = { "level", "five_plain" };

    (void)state;
    assert_int_equal(csv_read(&rows[0][0], ROWS, COLUMNS, "grid_regular_51.csv"), ROWS);
    for (size_t i = 0; i < ROWS; i += 7) {
        const double *from = rows[i], *to = rows[i + 1];
        if (i + 1 == ROWS || to[1] < from[1]) continue;
        for (size_t m = 0; jlt_method_at(m) != NULL; m++)
            for (size_t k = 0; k < 12; k++) {
                const double x[JLT_TOP_STATES] = { from[3], from[4], offsets[k % 6], from[5], from[6] };
                const jlt_event section = { .column = 2 };
                jlt_outcome at;
                ride r;
                ride_open(&r, tiers[k / 6], &top_51, x, jlt_method_at(m), &(jlt_options){ .tolerance = 1e-12 }, +1);
                assert_ok(jlt_orbit_next(r.orbit, INFINITY, &section, 1, &at));
                assert_int_equal(at.crossing.direction, JLT_FALLING);
                assert_true(at.t > 0.2 * (to[2] - from[2]) && at.t < 0.8 * (to[2] - from[2]));
                assert_ok(jlt_orbit_next(r.orbit, INFINITY, &section, 1, &at));
                assert_int_equal(at.crossing.direction, JLT_RISING);
                assert_near(at.t, to[2] - from[2], 1e-8);
                ride_close(&r);
            }
        for (size_t k = 0; k < 2; k++) {
            const double x[JLT_TOP_STATES] = { from[3], from[4], offsets[k], from[5], from[6] };
            double y[RIDE_COLUMNS];
            batch_rows made = { 0 };
            ride r;
            ride_open(&r, "level", &top_51, x, NULL, &(jlt_options){ .tolerance = 1e-12 }, +1);
            memcpy(y, r.start, sizeof r.start);
            y[2] = offsets[k];
            const jlt_batch_map map = batch_of(&r, &(jlt_batch_case){ .p = r.instance->prepared }, 1e-12, 1);
            assert_ok(jlt_batch_section(&map, y, 1, 1, keep_row, keep_end, &made, NULL));
            assert_int_equal(made.count, 1);
            assert_near(made.x[0][0], to[3], 1e-9);
            ride_close(&r);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_crossings_or_none_never_one),
        cmocka_unit_test(batches_find_the_same_pairs),
        cmocka_unit_test(a_start_on_the_section_is_no_crossing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
