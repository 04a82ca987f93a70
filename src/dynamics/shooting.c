#include "dynamics/shooting.h"

#include <math.h>
#include <stdlib.h>

#include "dynamics/linear.h"

jlt_status jlt_shooting_create(jlt_shooting *out, unsigned d, size_t period)
{
    *out = (jlt_shooting){ .slopes = calloc(period, (size_t)d * (d + 1) * sizeof *out->slopes) };
    out->miss = out->slopes != NULL ? out->slopes + period * d * d : NULL;
    return out->slopes != NULL ? JLT_OK : JLT_ERR_NOMEM;
}

void jlt_shooting_clear(jlt_shooting *self)
{
    free(self->slopes);
    *self = (jlt_shooting){ 0 };
}

void jlt_shooting_reset(jlt_shooting *self)
{
    self->residual = self->T = self->expansion = self->defect = 0;
    self->scale = self->determinant = 1;
}

void jlt_shooting_add(jlt_shooting *self, const jlt_chart *chart, const double *points, size_t period, size_t index,
                      const double *q, const double *slope, const double measured[4])
{
    const unsigned d = chart->dim;

    jlt_chart_scaled_slope(chart, self->slopes + index * d * d, slope);
    jlt_chart_difference(chart, self->miss + index * d, q, points + (index + 1) % period * d);
    jlt_chart_scaled(chart, self->miss + index * d, self->miss + index * d);
    self->residual = fmax(self->residual, jlt_linear_length(self->miss + index * d, d));
    self->scale = fmax(self->scale, jlt_linear_length(self->slopes + index * d * d, d * d));
    self->T += measured[0];
    self->expansion += measured[1];
    self->determinant *= measured[2];
    if (fabs(measured[3]) > fabs(self->defect)) self->defect = measured[3];
}

jlt_status jlt_shooting_of(jlt_shooting *out, jlt_map *map, const double *points, size_t period)
{
    const jlt_chart *chart = jlt_map_flow(map)->chart;
    jlt_image image;

    jlt_shooting_reset(out);
    for (size_t i = 0; i < period; i++) {
        JLT_PASS(jlt_map_apply(map, &image, points + i * chart->dim, 1, 1));
        const double measured[4] = { image.T, image.expansion, image.determinant, image.defect };
        jlt_shooting_add(out, chart, points, period, i, image.q, image.slope, measured);
    }
    return JLT_OK;
}
