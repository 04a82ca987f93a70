/* One return that passes a pole at s = 1e-1 ... 1e-8 and goes on. Two families of passages forget where they came from (their
 * condition is 13 and 55 at any s), their mirror images under the reversor amplify errors by up to 1/s^2.
 * Oracle: passages_51.csv, quadruple precision, with the condition of each return. */
#include "ride.h"
#include "table.h"

#include "integrate/batch.h"
#include "kernel/batch_isa.h"
#include "reference/csv.h"

#include <float.h>

enum { PASSAGES = 32, COLUMNS = 14 };
enum { POLE, ETA, K, CLOSEST, CONDITION, START, T = START + 4, END };

static double rows[PASSAGES][COLUMNS];

static void start_of(double *x, const double *row)
{
    const double start[JLT_TOP_STATES] = { row[START], row[START + 1], 0, row[START + 2], row[START + 3] };
    memcpy(x, start, sizeof start);
}

static double error_of(const double *x, double t, const double *row)
{
    const double off[] = { x[0] - row[END], x[1] - row[END + 1], x[3] - row[END + 2], x[4] - row[END + 3], t - row[T] };
    double worst = 0;
    for (int i = 0; i < 5; i++)
        if (!(fabs(off[i]) <= worst)) worst = fabs(off[i]);
    return worst;
}

typedef struct {
    jlt_status st;
    jlt_end end;
    double error, drift;
    size_t steps;
} passage;

static passage pass(const char *tier, const jlt_method *method, double tolerance, const double *row)
{
    const jlt_event crossing = { .column = 2, .direction = row[POLE] > 0 ? JLT_RISING : JLT_FALLING };
    passage p = { .error = NAN };
    double x[JLT_TOP_STATES];
    jlt_outcome at;
    ride r;

    start_of(x, row);
    ride_open(&r, tier, &top_51, x, method, &(jlt_options){ .tolerance = tolerance, .max_steps = 20000 }, +1);
    p.st = jlt_orbit_next(r.orbit, 2 * row[T], &crossing, 1, &at);
    p.end = at.end;
    if (p.st == JLT_OK && at.end == JLT_END_EVENT) {
        ride_states(&r, x, at.x);
        p.error = error_of(x, at.t, row);
    }
    p.drift = ride_drift(&r);
    p.steps = jlt_orbit_stepper(r.orbit)->steps + jlt_orbit_stepper(r.orbit)->rejected;
    ride_close(&r);
    return p;
}

static const char *end_of(const passage *p)
{
    return p->st != JLT_OK ? jlt_status_text(p->st) : p->end == JLT_END_EVENT ? "return" : p->end == JLT_END_POLE ? "pole" : "time";
}

static void note(FILE *table, const char *tier, const char *method, double tolerance, const double *row, const passage *p)
{
    table_row(table, "%s,%s,%g,%g,%g,1e-%g,%.3e,%zu,%.3e,%.3e,%s", tier, method, tolerance, row[POLE], row[ETA], row[K],
              row[CONDITION], p->steps, p->error, p->drift, end_of(p));
}

/* Roundings of 2^-53 a step that add up at random, and local errors below the tolerance that do so too: sqrt(steps) of them, and a
 * factor 2. The methods of order 8 and more stay far below the tolerance, whose steps are bound by it only at the pole; the errors
 * of msadams have a sign, and all of them add. */
static void lifted_the_error_is_rounding_times_the_condition(void **state)
{
    static const char *const tiers[] = { "level", "five" };
    const double tolerance = 1e-14;

    for (size_t i = 0; i < 2; i++)
        for (size_t m = 0; jlt_method_at(m) != NULL; m++) {
            const char *name = jlt_method_at(m)->name;
            const bool high = strcmp(name, "dop853") == 0 || strcmp(name, "gauss") == 0 || strcmp(name, "rk8pd") == 0;
            double ratio = 0;
            for (int k = 0; k < PASSAGES; k++) {
                const passage p = pass(tiers[i], jlt_method_at(m), tolerance, rows[k]);
                const double steps = strcmp(name, "msadams") == 0 ? (double)p.steps : sqrt((double)p.steps);
                const double each = DBL_EPSILON / 2 + (high ? 0 : tolerance);
                note(*state, tiers[i], name, tolerance, rows[k], &p);
                assert_ok(p.st);
                assert_int_equal(p.end, JLT_END_EVENT);
                assert_below(p.error, 2 * rows[k][CONDITION] * steps * each);
                ratio = fmax(ratio, p.error / rows[k][CONDITION] / (DBL_EPSILON / 2));
            }
            print_message("%-5s %-8s at most %.0f units of rounding times the condition\n", tiers[i], name, ratio);
        }
}

/* What may come back: a return whose error is at most condition * 2^-53/s^2 (see test_pole_approach.c) beside that of the steps; or
 * a status; or integrals that have visibly drifted. */
static void in_plain_time_digits_go_with_s_and_then_the_run_is_refused(void **state)
{
    static const char *const tiers[] = { "level_plain", "five_plain", "level_omega_n" };
    static const double tolerances[] = { 1e-12, 1e-14 };

    for (size_t i = 0; i < 6; i++)
        for (size_t m = 0; jlt_method_at(m) != NULL; m++) {
            const char *tier = tiers[i / 2], *name = jlt_method_at(m)->name;
            const double tolerance = tolerances[i % 2];
            int wrong = 0, refused = 0;
            for (int k = 0; k < PASSAGES; k++) {
                const passage p = pass(tier, jlt_method_at(m), tolerance, rows[k]);
                const double bound = rows[k][CONDITION]
                                     * (10 * (double)p.steps * tolerance + DBL_EPSILON * pow(10, 2 * rows[k][K]));
                if (i % 2 == 0) note(*state, tier, name, tolerance, rows[k], &p);
                if (p.st != JLT_OK) {
                    refused++;
                } else if (p.end != JLT_END_EVENT || p.error > bound) {
                    wrong++;
                    if (!(p.drift > 1e3 * tolerance))
                        fail_msg("%s by %s at s = 1e-%g: %s, error %.1e, drift %.1e", tier, name, rows[k][K], end_of(&p), p.error,
                                 p.drift);
                }
            }
            print_message("%-13s %-8s %g: refused %2d of %d, wrong with a drift to show it %d\n", tier, name, tolerance, refused,
                          PASSAGES, wrong);
        }
}

typedef struct {
    double x[PASSAGES][5];
    int made;
} batch_rows;

static int keep_row(void *context, size_t orbit, size_t number, const double *x)
{
    batch_rows *r = context;
    (void)number;
    memcpy(r->x[orbit], x, sizeof r->x[0]);
    r->made++;
    return 0;
}

static int keep_end(void *context, size_t orbit, jlt_lane_end end, size_t returns, const double *x)
{
    (void)context, (void)orbit, (void)x;
    assert_int_equal(end, JLT_LANE_DONE);
    assert_int_equal(returns, 1);
    return 0;
}

/* The same bound for batches, eight orbits beside each other. Their G is one for all, so each batch is a single orbit's level. */
static void batches_pass_as_well_as_single_orbits(void **state)
{
    double worst = 0;

    for (int k = 0; k < PASSAGES; k++) {
        double x[JLT_TOP_STATES], y[5], end[JLT_TOP_STATES];
        batch_rows made = { .made = 0 };
        ride r;
        start_of(x, rows[k]);
        ride_open(&r, "level", &top_51, x, NULL, &(jlt_options){ .tolerance = 1e-12 }, +1);
        memcpy(y, r.start, sizeof y);
        const jlt_batch_map map = { .kernels = jlt_batch_isa_best(r.instance->descriptor, 0),
                                    .cases = &(jlt_batch_case){ .p = r.instance->prepared },
                                    .dim = 5,
                                    .column = 2,
                                    .direction = (int)rows[k][POLE],
                                    .root = 4,
                                    .root_floor = 1e-10,
                                    .tolerance = 1e-14,
                                    .max_steps = 10000 };
        assert_ok(jlt_batch_section(&map, y, 1, 1, keep_row, keep_end, &made, NULL));
        assert_int_equal(made.made, 1);
        ride_states(&r, end, made.x[0]);
        const passage p = { .end = JLT_END_EVENT, .error = error_of(end, rows[k][T], rows[k]) };
        note(*state, "level", "batch", map.tolerance, rows[k], &p);
        assert_below(p.error, 2 * rows[k][CONDITION] * sqrt(500) * DBL_EPSILON / 2);
        worst = fmax(worst, p.error / rows[k][CONDITION] / (DBL_EPSILON / 2));
        ride_close(&r);
    }
    print_message("batch: at most %.0f units of rounding times the condition\n", worst);
}

static int prepare(void **state)
{
    *state = table_open("pole_passages", "form,method,tolerance,pole,eta,s,condition,steps,error,drift,end");
    return csv_read(&rows[0][0], PASSAGES, COLUMNS, "passages_51.csv") == PASSAGES ? 0 : -1;
}

int main(void)
{
    const struct CMUnitTest tests[] = { 
        cmocka_unit_test(lifted_the_error_is_rounding_times_the_condition),
        cmocka_unit_test(batches_pass_as_well_as_single_orbits),
        cmocka_unit_test(in_plain_time_digits_go_with_s_and_then_the_run_is_refused),
     };
    return cmocka_run_group_tests(tests, prepare, table_close);
}
