/* Batches whose orbits are under parameters of their own: rows are those of each alone. */
#include "batch_grid.h"

enum { CASES = 5, WATCHED = 2, TANGENTS = 2, COLUMNS = STATES * (1 + TANGENTS) + 2 };

/* Of orbits whose ends are of any kind: rows and ends, with what is watched. */
typedef struct {
    double x[ORBITS][RETURNS][COLUMNS + WATCHED], last[ORBITS][COLUMNS + WATCHED];
    size_t columns;
    size_t made[ORBITS];
    jlt_lane_end end[ORBITS];
} watched_rows;

static int keep_watched(void *context, size_t orbit, size_t number, const double *x)
{
    watched_rows *r = context;
    memcpy(r->x[orbit][number - 1], x, r->columns * sizeof *x);
    return 0;
}

static int keep_watched_end(void *context, size_t orbit, jlt_lane_end end, size_t returns, const double *x)
{
    watched_rows *r = context;
    r->made[orbit] = returns;
    r->end[orbit] = end;
    memcpy(r->last[orbit], x, r->columns * sizeof *x);
    return 0;
}

/* Levels, masses and sections of their own; states of the second are counted in other units. */
static void make_cases(jlt_batch_case *cases, double blocks[CASES][256], double params[CASES][7])
{
    static const double unit[STATES] = { 1, 2, 2, 2, 1 };

    for (unsigned c = 0; c < CASES; c++) {
        const double own[] = { 1 + 0.1 * c, 1, 1, I1 - 0.01 * c, I3, a3 - 0.02 * c, G + 0.03 * c };
        memcpy(params[c], own, sizeof own);
        level()->prepare(params[c], blocks[c]);
        cases[c] = (jlt_batch_case){ .p = blocks[c], .level = 0.004 * c * (c > 2), .params = params[c], .watched = blocks[c],
                                     .unit = c == 1 ? unit : NULL };
    }
}

/* A domain that ends where gamma3 = -0.65 m, in place of the table's; m is the first parameter, and so the first prepared value. */
static void edge_value(const double *restrict x, const double *restrict p, double *restrict out, size_t stride)
{
    for (size_t lane = 0; lane < stride; lane++) out[lane] = x[lane] + 0.65 * p[lane];
}

static void edge_gradient(const double *restrict x, const double *restrict p, double *restrict out, size_t stride)
{
    (void)x, (void)p;
    for (unsigned i = 0; i < STATES; i++)
        for (size_t lane = 0; lane < stride; lane++) out[i * stride + lane] = i == 0;
}

/* The relation of the root, times m: on lanes it is restored with the parameters of each. */
static void relation_times_m(const double *restrict x, const double *restrict params, double *restrict out)
{
    level()->root_relations(x, params, out);
    *out *= params[0];
}

static void gradient_times_m(const double *restrict x, const double *restrict params, double *restrict out)
{
    level()->root_relation_gradients(x, params, out);
    for (unsigned i = 0; i < STATES; i++) out[i] *= params[0];
}

/* A condition that some of the orbits lose on the way, and regain. */
static void above(const double *restrict x, const double *restrict p, double *restrict out, size_t stride)
{
    for (size_t lane = 0; lane < stride; lane++) out[lane] = x[lane] + 0.63 * p[lane];
}

typedef enum { PLAIN, PROJECTED, BOUNDED, VARIED, LOST, UNTIL_LOST, WAYS } way;

static void run_cases(const jlt_kernel_batch *given, const jlt_batch_case *cases, const size_t *case_of, way kind, unsigned threads,
                      const grid *g, watched_rows *out)
{
    static double starts[ORBITS * COLUMNS];
    jlt_descriptor d = *level();
    jlt_kernel_batch kernels = *given;
    const jlt_batch_watch watch = { &kernels, kind >= LOST ? 1 : d.valid_count, kind == UNTIL_LOST, false, false };
    const jlt_domain domain = { .states = STATES, .conditions = 1 };
    const jlt_batch_map map = { .kernels = &kernels,
                                .cases = cases,
                                .case_of = case_of,
                                .dim = STATES,
                                .column = 2,
                                .direction = 1,
                                .root = 4,
                                .root_floor = 1e-9,
                                .tolerance = 1e-8,
                                .threads = threads,
                                .project = kind == PROJECTED ? &d : NULL,
                                .domain = kind == BOUNDED ? &domain : NULL,
                                .tangents = kind == VARIED ? TANGENTS : 0,
                                .watch = &watch,
                                .max_steps = 300 };
    const unsigned columns = jlt_batch_columns(&map);

    kernels.domain_values = edge_value;
    if (kind >= LOST) kernels.valid_values = above;
    kernels.domain_gradients = edge_gradient;
    d.root_relations = relation_times_m;
    d.root_relation_gradients = gradient_times_m;
    memset(starts, 0, sizeof starts);
    for (unsigned orbit = 0; orbit < ORBITS; orbit++) {
        double *start = starts + orbit * columns;
        memcpy(start, g->start[orbit], sizeof g->start[0]);
        for (unsigned v = 1; v <= map.tangents; v++) start[v * STATES + v] = 1;
    }
    memset(out, 0, sizeof *out);
    out->columns = columns + WATCHED;
    assert_int_equal(jlt_batch_section(&map, starts, ORBITS, RETURNS, keep_watched, keep_watched_end, out, NULL), JLT_OK);
}

/* Neighbours in a vector are under other parameters, on other sections and in other units. An orbit's rows are those that it has
 * where all are as it is. */
static void orbits_under_parameters_of_their_own_go_side_by_side(void **unused)
{
    static watched_rows together, threaded, alone;
    static grid g;
    static double blocks[CASES][256], params[CASES][7];
    jlt_batch_case cases[CASES];
    size_t case_of[ORBITS];
    unsigned differ = 0;

    (void)unused;
    read_grid("grid_regular_51.csv", &g);
    make_cases(cases, blocks, params);
    assert_true(level()->valid_count > 0);
    for (unsigned orbit = 0; orbit < ORBITS; orbit++) case_of[orbit] = orbit * 7 % CASES;
    for (int i = 0; i < WAYS * JLT_ISA_COUNT; i++) {
        const jlt_kernel_batch *kernels = level()->batches[i / WAYS];
        const way kind = (way)(i % WAYS);
        if (!jlt_batch_isa_runs(kernels)) continue;
        run_cases(kernels, cases, case_of, kind, 1, &g, &together);
        run_cases(kernels, cases, case_of, kind, 3, &g, &threaded);
        assert_memory_equal(&together, &threaded, sizeof together);
        for (unsigned c = 0; c < CASES; c++) {
            run_cases(kernels, &cases[c], NULL, kind, 1, &g, &alone);
            for (unsigned orbit = 0; orbit < ORBITS; orbit++) {
                if (case_of[orbit] != c) {
                    differ += memcmp(together.x[orbit], alone.x[orbit], sizeof alone.x[0]) != 0;
                    continue;
                }
                assert_int_equal(together.made[orbit], alone.made[orbit]);
                assert_int_equal(together.end[orbit], alone.end[orbit]);
                assert_memory_equal(together.x[orbit], alone.x[orbit], sizeof alone.x[0]);
                assert_memory_equal(together.last[orbit], alone.last[orbit], sizeof alone.last[0]);
            }
        }
    }
    assert_true(differ > ORBITS); /* the cases are not all one */
}

/* Rows of orbits that are watched until a condition is lost are the same, and say the same of whether it is. */
static void a_condition_lost_is_lost_however_long_it_is_watched(void **unused)
{
    static watched_rows whole, until;
    static grid g;
    static double blocks[CASES][256], params[CASES][7];
    jlt_batch_case cases[CASES];
    unsigned lost = 0, kept = 0, less = 0;

    (void)unused;
    read_grid("grid_regular_51.csv", &g);
    make_cases(cases, blocks, params);
    for (unsigned isa = 0; isa < JLT_ISA_COUNT; isa++) {
        const jlt_kernel_batch *kernels = level()->batches[isa];
        if (!jlt_batch_isa_runs(kernels)) continue;
        run_cases(kernels, cases, NULL, LOST, 1, &g, &whole);
        run_cases(kernels, cases, NULL, UNTIL_LOST, 1, &g, &until);
        const size_t least = whole.columns - WATCHED;
        for (unsigned orbit = 0; orbit < ORBITS; orbit++) {
            assert_int_equal(whole.made[orbit], until.made[orbit]);
            for (size_t k = 0; k < whole.made[orbit]; k++) {
                const double *a = whole.x[orbit][k], *b = until.x[orbit][k];
                assert_memory_equal(a, b, least * sizeof *a);
                assert_int_equal(a[least] <= 0, b[least] <= 0);
                a[least] <= 0 ? lost++ : kept++;
                less += a[least] < b[least];
            }
        }
    }
    assert_true(lost > ORBITS && kept > ORBITS && less > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(orbits_under_parameters_of_their_own_go_side_by_side),
        cmocka_unit_test(a_condition_lost_is_lost_however_long_it_is_watched),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
