/* The angle at which the separatrices of the saddle of (5.1) cross, at tolerances 1e-8 ... 1e-13 of the integrator: it stays
 * within the error bar given with it, which shrinks with the tolerance until the seed's part is reached.
 * Oracle: the same crossing at tolerance 1e-14, by another method and from another seed. */
#include "unit/check.h"
#include "table.h"

#include "dynamics/homoclinic.h"
#include "witness/top_section.h"

enum { SIDES = 9 };

/* Places of homoclinic points on the two branches, seed 1e-4, with the unstable branch of positive side. */
static const struct {
    double unstable, stable;
} places[] = {
    { 16.16338149, 28.66358933 }, { 18.16338149, 26.66358933 }, { 20.16338149, 24.66358933 }, { 22.16338149, 22.66358933 }
};
enum { PLACES = sizeof places / sizeof *places };

/* A piece of a branch about sigma, as a polygon. */
static void piece(jlt_manifold *out, const jlt_branch *branch, double sigma, double points[2 * SIDES], double sigmas[SIDES],
                  double lengths[SIDES])
{
    for (int i = 0; i < SIDES; i++) {
        sigmas[i] = sigma + 0.04 * (i - SIDES / 2);
        assert_ok(jlt_branch_point(branch, points + 2 * i, sigmas[i]));
        lengths[i] = i;
    }
    *out = (jlt_manifold){ .points = points, .sigma = sigmas, .length = lengths, .count = SIDES };
}

typedef struct {
    size_t count;
    jlt_homoclinic point;
} crossing;

static crossing cross(int place, double tolerance, const char *method, double seed)
{
    const jlt_top_values values = jlt_system_top_defaults();
    const jlt_flow fine = { .tolerance = tolerance, .direction = JLT_RISING, .method = jlt_method_find(method) };
    jlt_system *system = NULL;
    jlt_map_batch *maps[2];
    jlt_map *map = NULL;
    jlt_periodic saddle;
    jlt_branch branch[2];
    jlt_manifold curve[2];
    jlt_homoclinic *found = NULL;
    double points[2][2 * SIDES], sigmas[2][SIDES], lengths[2][SIDES];
    crossing c = { 0 };

    assert_ok(jlt_system_top(&system, &values, &fine));
    jlt_flow coarse = system->flow;
    coarse.tolerance *= 10;
    assert_ok(jlt_map_create(&map, &system->flow));
    const jlt_kernel_batch *kernels = strcmp(method, "gauss") != 0 ? system->field.batch : NULL; /* in lanes, but for the oracle */
    assert_ok(jlt_map_batch_create(&maps[0], &system->flow, kernels, NULL, 1));
    assert_ok(jlt_map_batch_create(&maps[1], &coarse, kernels, NULL, 1));
    assert_ok(jlt_periodic_find(map, &saddle, (double[2]){ 0, -0.6136 }, 1, NULL));
    for (int s = 0; s < 2; s++) {
        assert_ok(jlt_branch_init(&branch[s], map, &saddle, s == 1, 1, seed));
        const double shift = log(seed / 1e-4) / log(branch[s].lambda);
        piece(&curve[s], &branch[s], (s == 0 ? places[place].unstable : places[place].stable) - shift, points[s], sigmas[s],
              lengths[s]);
    }
    assert_ok(jlt_homoclinic_find(&found, &c.count, NULL, &curve[0], &branch[0], &curve[1], &branch[1], false, maps[0], maps[1]));
    if (c.count > 0) c.point = found[0];
    free(found);
    for (int k = 0; k < 2; k++) jlt_map_batch_destroy(maps[k]);
    jlt_map_destroy(map);
    jlt_system_destroy(system);
    return c;
}

/* Branch points are up to 58 returns away from the saddle, where its multiplier 1.24 makes up to 3e5 of an error, and the angle
 * turns faster still: hence the size of the bar. */
static void the_angle_stays_within_its_error_bar(void **state)
{
    for (int place = 0; place < PLACES; place++) {
        const crossing best = cross(place, 1e-14, "gauss", 5e-5);
        assert_int_equal(best.count, 1);
        for (int k = 8; k <= 13; k++) {
            const crossing c = cross(place, pow(10, -k), "dop853", 1e-4);
            const double off = fabs(remainder(c.point.angle - best.point.angle, 3.14159265358979323846));
            table_row(*state, "%.10g,1e-%d,%zu,%.12g,%.3e,%.3e,%.3e", best.point.q[0], k, c.count, c.point.angle, off,
                      c.point.angle_error, c.point.residual);
            assert_int_equal(c.count, 1);
            assert_below(off, c.point.angle_error + best.point.angle_error);
            assert_below(c.point.angle_error, 1e5 * pow(10, -k) + 1e-8); /* the bar is worth something, too */
            if (k == 8 || k == 13)
                print_message("eta %.6f, tolerance 1e-%d: angle %.12f, off by %.1e, error bar %.1e\n", c.point.q[0], k,
                              c.point.angle, off, c.point.angle_error);
        }
    }
}

static int prepare(void **state)
{
    *state = table_open("separatrix_angle", "eta,tolerance,found,angle,off,error_bar,residual");
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(the_angle_stays_within_its_error_bar) };
    return cmocka_run_group_tests(tests, prepare, table_close);
}
