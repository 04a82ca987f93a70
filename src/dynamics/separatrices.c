#include "dynamics/separatrices.h"

#include "core/memory.h"

#include <math.h>
#include <string.h>

void jlt_separatrices_clear(jlt_separatrices *self)
{
    for (int k = 0; k < JLT_SEPARATRICES; k++) jlt_manifold_clear(&self->curve[k]);
    for (int u = 0; u < 2; u++)
        for (int s = 0; s < 2; s++) free(self->crossings[u][s]);
}

/* Index of the unstable branch whose mirror image is stable branch k, if the saddle is its own mirror image; JLT_SEPARATRICES:
 * none. */
static int original_of(const jlt_separatrices *self, int k)
{
    const jlt_chart *chart = self->chart;
    double q[2], v[2];

    jlt_chart_mirror(chart, q, self->branch[0].q);
    if (k < 2 || !chart->reversible || jlt_chart_distance(chart, q, self->branch[0].q) > 1e-9) return JLT_SEPARATRICES;
    for (int i = 0; i < 2; i++) {
        for (int c = 0; c < 2; c++) v[c] = chart->mirror[c] * self->branch[i].v[c];
        for (int c = 0; c < 2; c++) v[c] -= self->branch[k].v[c];
        jlt_chart_scaled(chart, v, v);
        if (hypot(v[0], v[1]) < 1e-6) return i;
    }
    return JLT_SEPARATRICES;
}

/* Make stable branch k the exact mirror image of its original. */
static void reflect_branch(jlt_separatrices *self, int k)
{
    const jlt_branch *original = &self->branch[self->original[k]];
    jlt_branch *branch = &self->branch[k];

    jlt_chart_mirror(self->chart, branch->q, original->q);
    for (int c = 0; c < 2; c++) branch->v[c] = self->chart->mirror[c] * original->v[c];
    for (int c = 0; c < 2; c++) branch->w[c] = self->chart->mirror[c] * original->w[c];
    memcpy(branch->bend, original->bend, sizeof branch->bend);
    branch->lambda = original->lambda;
}

/* Grow those of the unstable branches, first = 0, or of the stable ones, first = 2, that are no mirror images. */
static jlt_status grow(jlt_separatrices *self, int first)
{
    const jlt_branch *branches[2];
    jlt_manifold curves[2];
    int of[2], n = 0;

    for (int k = first; k < first + 2; k++) {
        if (self->original[k] < JLT_SEPARATRICES) continue;
        branches[n] = &self->branch[k];
        of[n++] = k;
    }
    if (n > 0) JLT_PASS(jlt_manifold_grow(curves, branches, (size_t)n, &self->growth));
    for (int i = 0; i < n; i++) self->curve[of[i]] = curves[i];
    return JLT_OK;
}

static jlt_status grow_all(jlt_separatrices *self)
{
    JLT_PASS(grow(self, 0));
    JLT_PASS(grow(self, 2));
    for (int k = 0; k < JLT_SEPARATRICES; k++)
        if (self->original[k] < JLT_SEPARATRICES)
            JLT_PASS(jlt_manifold_reflect(&self->curve[k], &self->curve[self->original[k]], self->chart));
    return JLT_OK;
}

jlt_status jlt_separatrices_grow(jlt_separatrices *self, jlt_map *map, const jlt_periodic *saddle, double seed,
                                 const jlt_manifold_options *options, const jlt_kernel_batch *kernels, unsigned threads)
{
    self->chart = jlt_map_flow(map)->chart;
    if (options != NULL) self->growth = *options;
    for (int k = 0; k < JLT_SEPARATRICES; k++) {
        JLT_PASS(jlt_branch_init(&self->branch[k], map, saddle, k >= 2, k % 2 == 0 ? 1 : -1, seed));
        self->branch[k].kernels = kernels;
        self->branch[k].threads = threads;
        self->original[k] = original_of(self, k);
        if (self->original[k] < JLT_SEPARATRICES) reflect_branch(self, k);
    }
    return grow_all(self);
}

/* Find the crossings of unstable branch u and stable branch 2 + s; by reflection if those of their mirror images are known. */
static jlt_status cross(jlt_separatrices *self, int u, int s, jlt_map_batch *const maps[2])
{
    const int unstable_of_s = self->original[2 + s];
    const bool mirrored = unstable_of_s == u;
    jlt_homoclinic **out = &self->crossings[u][s];

    for (int i = 0; unstable_of_s < u && i < 2; i++) { /* the crossings of (unstable_of_s, 2 + i), if that is the image of u */
        if (self->original[2 + i] != u) continue;
        self->count[u][s] = self->count[unstable_of_s][i];
        self->touching[u][s] = self->touching[unstable_of_s][i];
        return jlt_homoclinic_reflect(out, self->crossings[unstable_of_s][i], self->count[u][s], self->chart);
    }
    return jlt_homoclinic_find(out, &self->count[u][s], &self->touching[u][s], &self->curve[u], &self->branch[u],
                               &self->curve[2 + s], &self->branch[2 + s], mirrored, maps[0], maps[1]);
}

/* A crossing on branch k, or on the mirror image of branch k. */
typedef struct {
    jlt_homoclinic *of;
    bool mirrored;
} swept;

/* List the crossings on branch k and on its mirror image, some of them on both, with their points on branch k. Returns how many. */
static size_t gather(const jlt_separatrices *self, swept *list, double *sigma, double *q, int k)
{
    size_t n = 0;

    for (int u = 0; u < 2; u++)
        for (int s = 2; s < JLT_SEPARATRICES; s++)
            for (size_t i = 0; i < self->count[u][s - 2]; i++) {
                jlt_homoclinic *point = &self->crossings[u][s - 2][i];
                for (int stable = 0; stable < 2; stable++) {
                    const int branch = stable ? s : u;
                    if (branch != k && self->original[branch] != k) continue;
                    list[n] = (swept){ .of = point, .mirrored = branch != k };
                    sigma[n] = stable ? point->sigma_stable : point->sigma_unstable;
                    if (branch == k) memcpy(q + 2 * n, point->q, sizeof point->q);
                    else jlt_chart_mirror(self->chart, q + 2 * n, point->q);
                    n++;
                }
            }
    return n;
}

static size_t crossings_of(const jlt_separatrices *self)
{
    return self->count[0][0] + self->count[0][1] + self->count[1][0] + self->count[1][1];
}

/* Set areas and lobes of all crossings, integrating once along every branch that is no mirror image. */
static jlt_status measure_lobes(jlt_separatrices *self, jlt_map_batch *maps)
{
    const size_t room = 2 * crossings_of(self) + 1;
    JLT_FREED swept *list = calloc(room, sizeof *list);
    JLT_FREED double *sigma = calloc(3 * room, sizeof *sigma); /* (room,), then q, (room, 2) */
    JLT_FREED jlt_branch_area *areas = calloc(room, sizeof *areas);

    if (list == NULL || sigma == NULL || areas == NULL) return JLT_ERR_NOMEM;
    for (int k = 0; k < JLT_SEPARATRICES; k++) {
        if (self->original[k] < JLT_SEPARATRICES) continue;
        double *const q = sigma + room;
        const size_t n = gather(self, list, sigma, q, k);
        JLT_PASS(jlt_branch_area_to(areas, &self->branch[k], &self->curve[k], sigma, q, n, maps));
        for (size_t i = 0; i < n; i++) {
            jlt_branch_area *out = &list[i].of->area[(k >= 2) != list[i].mirrored];
            *out = list[i].mirrored ? jlt_branch_area_mirrored(&areas[i], self->chart) : areas[i];
        }
    }
    for (int u = 0; u < 2; u++)
        for (int s = 0; s < 2; s++) jlt_homoclinic_measure_lobes(self->crossings[u][s], self->count[u][s], self->chart);
    return JLT_OK;
}

/* Add to lobe_error twice the change of each lobe along bent branches from seeds twice as large, with polygons of their own: it
 * shows the errors of points, seeds and interpolation together, but may happen to be small. */
static jlt_status find_lobe_errors(jlt_separatrices *self, jlt_map_batch *maps)
{
    jlt_separatrices other = { .chart = self->chart, .growth = self->growth };
    jlt_map *map = NULL;
    jlt_status st = jlt_map_create(&map, jlt_map_batch_flow(maps));

    for (int k = 0; k < JLT_SEPARATRICES; k++) {
        other.original[k] = self->original[k];
        other.branch[k] = self->branch[k];
        other.branch[k].map = map;
        other.branch[k].bent = true;
        other.branch[k].seed *= 2;
    }
    if (st == JLT_OK) st = grow_all(&other);
    for (int i = 0; st == JLT_OK && i < 4; i++) {
        const size_t count = other.count[i / 2][i % 2] = self->count[i / 2][i % 2];
        jlt_homoclinic *points = other.crossings[i / 2][i % 2] = calloc(count + 1, sizeof *points);
        if (points == NULL) st = JLT_ERR_NOMEM;
        for (size_t n = 0; points != NULL && n < count; n++) {
            const jlt_homoclinic *of = &self->crossings[i / 2][i % 2][n];
            points[n] = (jlt_homoclinic){ .q = { of->again.q[0], of->again.q[1] },
                                          .sigma_unstable = of->again.sigma[0] - log(2) / log(self->branch[i / 2].lambda),
                                          .sigma_stable = of->again.sigma[1] - log(2) / log(self->branch[2 + i % 2].lambda),
                                          .lobe = NAN };
        }
    }
    if (st == JLT_OK) st = measure_lobes(&other, maps);
    for (int i = 0; st == JLT_OK && i < 4; i++)
        for (size_t n = 0; n < self->count[i / 2][i % 2]; n++) {
            jlt_homoclinic *point = &self->crossings[i / 2][i % 2][n];
            point->lobe_error += 2 * fabs(other.crossings[i / 2][i % 2][n].lobe - point->lobe);
        }
    jlt_separatrices_clear(&other);
    jlt_map_destroy(map);
    return st;
}

jlt_status jlt_separatrices_cross(jlt_separatrices *self)
{
    const jlt_kernel_batch *kernels = self->branch[0].kernels;
    const unsigned threads = self->branch[0].threads;
    const jlt_flow *flow = jlt_map_flow(self->branch[0].map);
    jlt_flow coarse = *flow;
    jlt_map_batch *maps[2] = { NULL, NULL };
    jlt_status st = JLT_OK;

    coarse.tolerance = 10 * (flow->tolerance != 0 ? flow->tolerance : JLT_ORBIT_TOLERANCE);
    JLT_TRY(jlt_map_batch_create(&maps[0], flow, kernels, NULL, threads));
    JLT_TRY(jlt_map_batch_create(&maps[1], &coarse, kernels, NULL, threads));
    for (int u = 0; u < 2; u++)
        for (int s = 0; s < 2; s++)
            JLT_TRY(cross(self, u, s, maps));
    if (crossings_of(self) == 0) goto done;
    JLT_TRY(measure_lobes(self, maps[0]));
    JLT_TRY(find_lobe_errors(self, maps[1]));
done:
    for (int k = 0; k < 2; k++) jlt_map_batch_destroy(maps[k]);
    return st;
}
