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

jlt_status jlt_separatrices_grow(jlt_separatrices *self, jlt_map *map, const jlt_periodic *saddle, double seed,
                                 const jlt_manifold_options *options)
{
    jlt_status st = JLT_OK;

    self->chart = jlt_map_flow(map)->chart;
    for (int k = 0; k < JLT_SEPARATRICES; k++) {
        JLT_TRY(jlt_branch_init(&self->branch[k], map, saddle, 0, k >= 2, k % 2 == 0 ? 1 : -1, seed));
        const int image = mirror_of(self, k);
        if (image < JLT_SEPARATRICES) JLT_TRY(jlt_manifold_reflect(&self->curve[k], &self->curve[image], self->chart));
        else JLT_TRY(jlt_manifold_grow(&self->curve[k], &self->branch[k], options));
    }
done:
    return st;
}

jlt_status jlt_separatrices_cross(jlt_separatrices *self)
{
    jlt_flow coarse = *jlt_map_flow(self->branch[0].map);
    jlt_map *map = NULL;
    jlt_status st = JLT_OK;

    coarse.tolerance *= 10;
    JLT_TRY(jlt_map_create(&map, &coarse));
    for (int u = 0; u < 2; u++)
        for (int s = 0; s < 2; s++)
            JLT_TRY(jlt_homoclinic_find(&self->crossings[u][s], &self->count[u][s], &self->touching[u][s],
                                        &self->curve[u], &self->branch[u], &self->curve[2 + s], &self->branch[2 + s], map));
done:
    jlt_map_destroy(map);
    return st;
}
