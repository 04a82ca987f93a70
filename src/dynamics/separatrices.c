#include "dynamics/separatrices.h"

#include <math.h>
#include <stdlib.h>

void jlt_separatrices_clear(jlt_separatrices *self)
{
    for (int k = 0; k < JLT_SEPARATRICES; k++) jlt_manifold_clear(&self->curve[k]);
    for (int u = 0; u < 2; u++)
        for (int s = 0; s < 2; s++) free(self->crossings[u][s]);
}

/* The unstable branch whose mirror image stable branch k is: where the saddle lies on the reversor's line. JLT_SEPARATRICES:
 * none. */
static int mirror_of(const jlt_separatrices *self, int k)
{
    const jlt_chart *chart = self->chart;
    double q[2], v[2];

    jlt_chart_mirror(chart, q, self->branch[0].q);
    if (k < 2 || !chart->reversible || jlt_chart_distance(chart, q, self->branch[0].q) > 1e-9) return JLT_SEPARATRICES;
    for (int i = 0; i < 2; i++) {
        for (int c = 0; c < 2; c++) v[c] = chart->mirror[c] * self->branch[i].v[c];
        if (hypot(v[0] - self->branch[k].v[0], v[1] - self->branch[k].v[1]) < 1e-6) return i;
    }
    return JLT_SEPARATRICES;
}

/* One branch, on a map of its own. */
static jlt_status grow(jlt_manifold *curve, const jlt_branch *branch, const jlt_manifold_options *options)
{
    jlt_branch own = *branch;
    jlt_status st = JLT_OK;

    JLT_TRY(jlt_map_create(&own.map, jlt_map_flow(branch->map)));
    st = jlt_manifold_grow(curve, &own, options);
    jlt_map_destroy(own.map);
done:
    return st;
}

jlt_status jlt_separatrices_grow(jlt_separatrices *self, jlt_map *map, const jlt_periodic *saddle, double seed,
                                 const jlt_manifold_options *options, unsigned threads)
{
    int image[JLT_SEPARATRICES], failure = JLT_OK;
    jlt_status st = JLT_OK;

    self->chart = jlt_map_flow(map)->chart;
    for (int k = 0; k < JLT_SEPARATRICES; k++) {
        JLT_TRY(jlt_branch_init(&self->branch[k], map, saddle, 0, k >= 2, k % 2 == 0 ? 1 : -1, seed));
        image[k] = mirror_of(self, k);
    }
#if defined(_OPENMP)
#pragma omp parallel for num_threads((int)threads) schedule(dynamic, 1) reduction(max : failure)
#else
    (void)threads;
#endif
    for (int k = 0; k < JLT_SEPARATRICES; k++) {
        const int failed = image[k] < JLT_SEPARATRICES ? (int)JLT_OK : (int)grow(&self->curve[k], &self->branch[k], options);
        if (failed > failure) failure = failed;
    }
    st = (jlt_status)failure;
    for (int k = 0; k < JLT_SEPARATRICES && st == JLT_OK; k++)
        if (image[k] < JLT_SEPARATRICES) st = jlt_manifold_reflect(&self->curve[k], &self->curve[image[k]], self->chart);
done:
    return st;
}

jlt_status jlt_separatrices_cross(jlt_separatrices *self, const jlt_kernel_batch *kernels, unsigned threads)
{
    const jlt_flow *flow = jlt_map_flow(self->branch[0].map);
    jlt_flow coarse = *flow;
    jlt_map_batch *maps[2] = { NULL, NULL };
    jlt_status st = JLT_OK;

    coarse.tolerance *= 10;
    JLT_TRY(jlt_map_batch_create(&maps[0], flow, kernels, NULL, threads));
    JLT_TRY(jlt_map_batch_create(&maps[1], &coarse, kernels, NULL, threads));
    for (int u = 0; u < 2; u++)
        for (int s = 0; s < 2; s++)
            JLT_TRY(jlt_homoclinic_find(&self->crossings[u][s], &self->count[u][s], &self->touching[u][s], &self->curve[u],
                                        &self->branch[u], &self->curve[2 + s], &self->branch[2 + s], maps[0], maps[1]));
done:
    for (int k = 0; k < 2; k++) jlt_map_batch_destroy(maps[k]);
    return st;
}
