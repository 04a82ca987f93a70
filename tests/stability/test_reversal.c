/* There and back: P^-N P^N = id, and by the reversor S of (3.2), (S P^N)^2 = id, all forwards. The defects grow with the returns as
 * the map's own derivative lets errors of single steps grow: by a power on a regular orbit, as exp(lambda T) on a chaotic one. Most
 * methods give the two defects bit by bit the same, because kernels and sums do not round differently under a change of signs. */
#include "unit/check.h"
#include "table.h"

#include "dynamics/map.h"
#include "witness/top_section.h"

enum { RETURNS = 1000, STEPS = 150 };
static const size_t lengths[] = { 1, 3, 10, 30, 100, 300, 1000 };
enum { LENGTHS = sizeof lengths / sizeof *lengths };

static const struct {
    const char *name;
    double q[2];
} orbits[] = { { "regular", { 0.44, -0.62 } }, { "chaotic", { 0.02, -0.61 } }, { "saddle", { 1e-6, -0.61358438970663813576 } } };

/* Sum over the returns k = 1 .. N of |DP^-k|, which carries an error made then back to the start; sums: (LENGTHS,). */
static void transport(double *sums, const double *q)
{
    const jlt_top_values values = jlt_system_top_defaults();
    double sum = 0, here[2] = { q[0], q[1] }, m[4] = { 1, 0, 0, 1 }, root = 1;
    jlt_system *system = NULL;
    jlt_map *map = NULL;

    assert_ok(jlt_system_top(&system, &values, &(jlt_flow){ .tolerance = 1e-11 }));
    assert_ok(jlt_map_create(&map, &system->flow));
    for (size_t k = 1, next = 0; k <= RETURNS; k++) {
        jlt_image image;
        assert_ok(jlt_map_apply(map, &image, here, 1, 1));
        const double *a = image.slope;
        const double product[4] = { a[0] * m[0] + a[1] * m[2], a[0] * m[1] + a[1] * m[3],
                                    a[2] * m[0] + a[3] * m[2], a[2] * m[1] + a[3] * m[3] };
        const double unit = sqrt(fabs(image.determinant)); /* m is kept at determinant 1, DP^k = root m */
        root *= unit;
        for (int i = 0; i < 4; i++) m[i] = product[i] / unit;
        sum += sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2] + m[3] * m[3]) / root;
        memcpy(here, image.q, sizeof here);
        if (k == lengths[next]) sums[next++] = sum;
    }
    jlt_map_destroy(map);
    jlt_system_destroy(system);
}

typedef struct {
    double reversal[LENGTHS], reversor[LENGTHS], t[LENGTHS];
} defects;

static void walk(jlt_section *section, jlt_return *row, size_t returns)
{
    for (size_t k = 0; k < returns; k++) {
        assert_ok(jlt_section_next(section, row));
        assert_int_equal(row->fate, JLT_FATE_ALIVE);
    }
}

static defects measure(const char *method, double tolerance, const double *q)
{
    const jlt_top_values values = jlt_system_top_defaults();
    const jlt_flow options = { .tolerance = tolerance, .method = jlt_method_find(method) };
    jlt_system *system = NULL;
    jlt_section *there = NULL, *back = NULL;
    jlt_return row, end;
    defects d;

    assert_ok(jlt_system_top(&system, &values, &options));
    assert_ok(jlt_section_create(&there, &system->flow));
    assert_ok(jlt_section_create(&back, &system->flow));
    assert_ok(jlt_section_start(there, &row, q, 1));
    for (size_t i = 0; i < LENGTHS; i++) {
        const jlt_chart *chart = system->flow.chart;
        double mirrored[2];
        walk(there, &row, lengths[i] - (i == 0 ? 0 : lengths[i - 1]));
        d.t[i] = row.t;
        assert_ok(jlt_section_start_state(back, &end, row.x, -1));
        walk(back, &end, lengths[i]);
        d.reversal[i] = jlt_chart_distance(chart, end.q, q);

        double x[JLT_CHART_STATES_MAX];
        memcpy(x, row.x, sizeof x);
        x[JLT_CHART_TOP_V_NU] = -x[JLT_CHART_TOP_V_NU];
        assert_ok(jlt_section_start_state(back, &end, x, 1));
        walk(back, &end, lengths[i]);
        jlt_chart_mirror(chart, mirrored, end.q);
        d.reversor[i] = jlt_chart_distance(chart, mirrored, q);
    }
    jlt_section_destroy(back);
    jlt_section_destroy(there);
    jlt_system_destroy(system);
    return d;
}

/* A return of at most STEPS steps adds sqrt(STEPS) times the tolerance and a rounding, in both directions, and (eta, gamma3) move
 * by less than five times what states do. Where the bound passes 1e-3 the linear theory behind it ends. */
static void defects_stay_below_the_transported_errors_of_the_steps(void **state)
{
    static const char *const methods[] = { "dop853", "gauss", "taylor", "rk8pd" };
    const double tolerance = 1e-14, each = sqrt(STEPS) * (tolerance + 0x1p-53);

    for (size_t o = 0; o < sizeof orbits / sizeof *orbits; o++) {
        double sums[LENGTHS];
        transport(sums, orbits[o].q);
        for (size_t m = 0; m < 4; m++) {
            const defects d = measure(methods[m], tolerance, orbits[o].q);
            for (size_t i = 0; i < LENGTHS; i++) {
                const double bound = 2 * 5 * each * sums[i];
                table_row(*state, "%s,%s,%zu,%.6g,%.3e,%.3e,%.3e", orbits[o].name, methods[m], lengths[i], d.t[i], d.reversal[i],
                          d.reversor[i], bound);
                if (i + 1 == LENGTHS)
                    print_message("%s, %s, %zu returns: %.1e and %.1e, bound %.1e\n", orbits[o].name, methods[m], lengths[i],
                                  d.reversal[i], d.reversor[i], bound);
                if (bound > 1e-3) continue;
                assert_below(d.reversal[i], bound);
                assert_below(d.reversor[i], bound);
            }
        }
    }
}

static int prepare(void **state)
{
    *state = table_open("reversal", "orbit,method,returns,t,reversal,reversor,bound");
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(defects_stay_below_the_transported_errors_of_the_steps) };
    return cmocka_run_group_tests(tests, prepare, table_close);
}
