/* The batched section map: an orbit's rows do not depend on its company, and agree with quadruple precision. */
#include "batch_grid.h"

#include "kernel/descriptor.h"

typedef struct {
    double x[ORBITS][RETURNS][STATES], last[ORBITS][STATES];
    size_t rows;
} rows;

static int keep(void *context, size_t orbit, size_t number, const double *x)
{
    rows *r = context;
    memcpy(r->x[orbit][number - 1], x, sizeof r->x[0][0]);
    __atomic_fetch_add(&r->rows, 1, __ATOMIC_RELAXED);
    return 0;
}

static int all_made(void *context, size_t orbit, jlt_lane_end end, size_t returns, const double *x)
{
    (void)context, (void)orbit, (void)x;
    assert_int_equal(end, JLT_LANE_DONE);
    assert_int_equal(returns, RETURNS);
    return 0;
}

static int keep_last(void *context, size_t orbit, jlt_lane_end end, size_t returns, const double *x)
{
    memcpy(((rows *)context)->last[orbit], x, sizeof ((rows *)context)->last[0]);
    return all_made(context, orbit, end, returns, x);
}

static double section; /* its level, in what follows */

static void run(const jlt_kernel_batch *kernels, double tolerance, unsigned project, unsigned threads,
                const double *starts, size_t count, rows *out)
{
    const jlt_descriptor *d = level();
    double params[] = { 1, 1, 1, I1, I3, a3, G }, block[256];

    assert_true(d->prepared_count <= 256 && d->param_count == 7 && d->state_count == STATES);
    d->prepare(params, block);
    const jlt_batch_map map = { .kernels = kernels,
                                .cases = &(jlt_batch_case){ .p = block, .level = section, .params = params },
                                .dim = STATES,
                                .column = 2,
                                .direction = 1,
                                .root = 4,
                                .root_floor = 1e-9,
                                .tolerance = tolerance,
                                .threads = threads,
                                .project = project ? d : NULL,
                                .max_steps = 300 /* of a return: all of an orbit take more at the last tolerance */ };
    out->rows = 0;
    assert_int_equal(jlt_batch_section(&map, starts, count, RETURNS, keep, keep_last, out, NULL), JLT_OK);
    assert_int_equal(out->rows, count * RETURNS);
}

/* The error after ten returns falls in step with the tolerance to its floor. At tolerance 1e-14 some 1300 steps a return
 * time, each with roundings of 2^-53, amplified by less than 100 over ten returns: sqrt(1300)*100*1e-16 = 4e-13. */
static void check_accuracy(const char *name)
{
    static grid g;
    static rows r;
    static const double tolerance[] = { 1e-8, 1e-11, 1e-14 }, bound[] = { 2e-6, 2e-9, 1e-12 };

    read_grid(name, &g);
    for (int i = 0; i < 3; i++) {
        double error = 0;
        run(jlt_batch_isa_best(level(), 0), tolerance[i], 0, 1, g.start[0], ORBITS, &r);
        for (int orbit = 0; orbit < ORBITS; orbit++)
            for (int number = 0; number < RETURNS; number++) {
                const double *x = r.x[orbit][number], *expected = g.expected[orbit][number];
                double b = a3 + x[0], K = I1 * x[4] * x[4] + I3 * b * b, omega3 = (I1 * x[4] * x[3] - b * G) / K;
                error = fmax(error, fmax(fabs(x[0] - expected[0]), fmax(fabs(x[1] - expected[1]), fabs(omega3 - expected[2]))));
            }
        print_message("%s: tolerance %g, error %.2e\n", name, tolerance[i], error);
        assert_true(error < bound[i]);
    }
}

static void returns_on_a_regular_island_match_quadruple_precision(void **unused)
{
    (void)unused;
    check_accuracy("grid_regular_51.csv");
}

static void returns_that_graze_the_pole_match_quadruple_precision(void **unused)
{
    (void)unused;
    check_accuracy("grid_grazing_51.csv");
}

/* At 1e-4 an eighth of the crossings take a second step. */
static void rows_do_not_depend_on_lane_company_or_thread(void **unused)
{
    static const double tolerance[] = { 1e-4, 1e-10 };
    static grid g;
    static rows together, alone, threaded;

    (void)unused;
    read_grid("grid_grazing_51.csv", &g);
    for (int isa = 0; isa < JLT_ISA_COUNT; isa++) {
        const jlt_kernel_batch *kernels = level()->batches[isa];
        if (!jlt_batch_isa_runs(kernels)) continue;
        for (int i = 0; i < 4; i++) {
            const unsigned project = i % 2 != 0;
            run(kernels, tolerance[i / 2], project, 1, g.start[0], ORBITS, &together);
            run(kernels, tolerance[i / 2], project, 2, g.start[0], ORBITS, &threaded);
            assert_memory_equal(together.x, threaded.x, sizeof together.x);
            for (int orbit = 0; orbit < ORBITS; orbit += 9) {
                run(kernels, tolerance[i / 2], project, 1, g.start[orbit], 1, &alone);
                assert_memory_equal(together.x[orbit], alone.x[0], sizeof alone.x[0]);
            }
        }
    }
}

/* The last point of an orbit is a projected one: what is left is of second order in the drift of one return. */
static void projected_points_are_on_the_levels_of_their_starts(void **unused)
{
    static grid g;
    static rows unprojected, projected;
    const jlt_descriptor *d = level();
    double params[] = { 1, 1, 1, I1, I3, a3, G }, block[256], drift = 0, left = 0;

    (void)unused;
    d->prepare(params, block);
    read_grid("grid_regular_51.csv", &g);
    run(jlt_batch_isa_best(d, 0), 1e-6, 0, 1, g.start[0], ORBITS, &unprojected);
    run(jlt_batch_isa_best(d, 0), 1e-6, d->integral_count, 1, g.start[0], ORBITS, &projected);
    for (int orbit = 0; orbit < ORBITS; orbit++) {
        const double *a = g.start[orbit], *b = unprojected.last[orbit], *c = projected.last[orbit];
        double E, E_free, E_projected;
        d->integral_values.call(a, block, &E);
        d->integral_values.call(b, block, &E_free);
        d->integral_values.call(c, block, &E_projected);
        drift = fmax(drift, fmax(fabs(E_free - E), fabs(b[0] * b[0] + b[4] * b[4] - 1)));
        left = fmax(left, fmax(fabs(E_projected - E), fabs(c[0] * c[0] + c[4] * c[4] - 1)));
    }
    print_message("off the levels at tolerance 1e-6: %.1e, projected %.1e\n", drift, left);
    assert_true(left < 10 * drift * drift + 1e-15);
}

/* x[2], which has the section's level there: an integral only in name, that pulls every end back to where the orbit began. */
static void event_value(const double *restrict x, const double *restrict p, double *restrict out, size_t stride)
{
    (void)p;
    for (size_t lane = 0; lane < stride; lane++) out[lane] = x[2 * stride + lane];
}

static void event_gradient(const double *restrict x, const double *restrict p, double *restrict out, size_t stride)
{
    (void)x, (void)p;
    for (unsigned i = 0; i < STATES; i++)
        for (size_t lane = 0; lane < stride; lane++) out[i * stride + lane] = i == 2;
}

static void no_projection_leads_back_across_the_section(void **unused)
{
    (void)unused;
    jlt_kernel_batch event = *jlt_batch_isa_best(level(), 0);
    static grid g;
    static rows plain, projected;

    read_grid("grid_regular_51.csv", &g);
    event.integral_values = event_value;
    event.integral_gradients = event_gradient;
    for (section = 0; section < 0.03; section += 0.02) {
        for (unsigned orbit = 0; orbit < ORBITS; orbit++) g.start[orbit][2] = section - 0.01;
        run(jlt_batch_isa_best(level(), 0), 1e-10, 0, 1, g.start[0], ORBITS, &plain);
        run(&event, 1e-10, 1, 1, g.start[0], ORBITS, &projected);
        assert_memory_equal(plain.x, projected.x, sizeof plain.x);
    }
    section = 0;
}

/* Carried by the clock: t of the reference within what its states keep to, and rows of states that keep their own bound. */
static int keep_clock(void *context, size_t orbit, size_t number, const double *x)
{
    (*(double(*)[ORBITS][RETURNS])context)[orbit][number - 1] = x[STATES];
    return 0;
}

static void the_clock_matches_quadruple_precision(void **unused)
{
    static double starts[ORBITS][STATES + 1], expected[ORBITS][RETURNS], t[ORBITS][RETURNS];
    static const double tolerance[] = { 1e-8, 1e-11, 1e-14 }, bound[] = { 2e-6, 2e-9, 1e-12 };
    static grid g;
    const jlt_descriptor *d = level();
    double params[] = { 1, 1, 1, I1, I3, a3, G }, block[256];
    char line[512];

    (void)unused;
    read_grid("grid_regular_51.csv", &g);
    FILE *file = fopen(JLT_SOURCE_DIR "/tests/reference/data/grid_regular_51.csv", "r");
    assert_non_null(file);
    assert_non_null(fgets(line, sizeof line, file));
    while (fgets(line, sizeof line, file) != NULL) {
        int orbit, number;
        double time;
        assert_int_equal(sscanf(line, "%d,%d,%lf", &orbit, &number, &time), 3);
        if (number > 0) expected[orbit][number - 1] = time;
    }
    fclose(file);
    for (int orbit = 0; orbit < ORBITS; orbit++) memcpy(starts[orbit], g.start[orbit], sizeof g.start[orbit]);
    d->prepare(params, block);
    for (int i = 0; i < 3; i++) {
        double error = 0;
        const jlt_batch_map map = { .kernels = jlt_batch_isa_best(d, 0),
                                    .cases = &(jlt_batch_case){ .p = block },
                                    .dim = STATES,
                                    .clock = true,
                                    .column = 2,
                                    .direction = 1,
                                    .root = 4,
                                    .root_floor = 1e-9,
                                    .tolerance = tolerance[i],
                                    .max_steps = 1000000 };
        assert_int_equal(jlt_batch_section(&map, starts[0], ORBITS, RETURNS, keep_clock, all_made, t, NULL), JLT_OK);
        for (int orbit = 0; orbit < ORBITS; orbit++)
            for (int n = 0; n < RETURNS; n++) error = fmax(error, fabs(t[orbit][n] - expected[orbit][n]));
        print_message("clock: tolerance %g, error %.2e\n", tolerance[i], error);
        assert_true(error < bound[i]);
    }
}

static int ignore(void *context, size_t orbit, size_t number, const double *x)
{
    (void)context, (void)orbit, (void)number, (void)x;
    return 0;
}

static int count_doubted(void *context, size_t orbit, jlt_lane_end end, size_t returns, const double *x)
{
    (void)orbit, (void)returns, (void)x;
    *(unsigned *)context += end == JLT_LANE_DOUBTED;
    assert_true(end == JLT_LANE_DONE || end == JLT_LANE_DOUBTED);
    return 0;
}

/* Of a smooth motion that turns sharply one step in some hundred differs from its halves by more than the tolerance, however long
 * it is followed: few orbits are left to a slower method for that. */
static void smooth_motions_stay_in_lanes(void **unused)
{
    enum { COUNT = 40 };
    const jlt_descriptor *d = jlt_descriptor_find("roessler", NULL, NULL, NULL);
    double params[] = { 0.2, 0.2, 5.7 }, block[256], starts[COUNT][3];

    (void)unused;
    assert_true(d != NULL && d->prepared_count <= 256 && d->param_count == 3 && d->state_count == 3);
    d->prepare(params, block);
    for (int i = 0; i < COUNT; i++) memcpy(starts[i], (double[]){ 0, -8 + i / 8.0, 0.02 }, sizeof starts[i]);
    for (int isa = 0; isa < JLT_ISA_COUNT; isa++) {
        const jlt_kernel_batch *kernels = d->batches[isa];
        for (int digits = 8; jlt_batch_isa_runs(kernels) && digits <= 9; digits++) {
            const jlt_batch_map map = { .kernels = kernels,
                                        .cases = &(jlt_batch_case){ .p = block },
                                        .dim = 3,
                                        .direction = 1,
                                        .root = -1,
                                        .tolerance = pow(10, -digits),
                                        .max_steps = 300 };
            unsigned doubted = 0;
            assert_int_equal(jlt_batch_section(&map, starts[0], COUNT, 2000, ignore, count_doubted, &doubted, NULL), JLT_OK);
            print_message("%u lanes, 1e-%d: %u of %d orbits leave their lanes\n", (unsigned)kernels->lanes, digits, doubted, COUNT);
            assert_true(doubted <= COUNT / 10);
        }
    }
}

static void the_environment_bounds_the_lanes(void **unused)
{
    (void)unused;
    assert_int_equal(setenv("JELLETT_LANES", "2", 1), 0);
    assert_int_equal(jlt_batch_isa_best(level(), 0)->lanes, 2);
    assert_int_equal(unsetenv("JELLETT_LANES"), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(returns_on_a_regular_island_match_quadruple_precision),
        cmocka_unit_test(returns_that_graze_the_pole_match_quadruple_precision),
        cmocka_unit_test(rows_do_not_depend_on_lane_company_or_thread),
        cmocka_unit_test(projected_points_are_on_the_levels_of_their_starts),
        cmocka_unit_test(no_projection_leads_back_across_the_section),
        cmocka_unit_test(the_clock_matches_quadruple_precision),
        cmocka_unit_test(smooth_motions_stay_in_lanes),
        cmocka_unit_test(the_environment_bounds_the_lanes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
