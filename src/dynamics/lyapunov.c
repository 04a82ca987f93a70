#include "dynamics/lyapunov.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Columns of q replaced by A q, orthonormalised by modified Gram-Schmidt, twice; growth gets the logarithms of the lengths, which
 * add up to log |det A|, so that the last of them is what the others leave. Returns by how much it was not. */
static double step_frame(double *frame, double *growth, const double *slope, double size, unsigned d)
{
    double next[JLT_CHART_DIM_MAX * JLT_CHART_DIM_MAX];
    double rest = log(size);
    unsigned i, j, k, pass;

    for (i = 0; i < d; i++)
        for (j = 0; j < d; j++) {
            double sum = 0;
            for (k = 0; k < d; k++) sum += slope[i * d + k] * frame[k * d + j];
            next[i * d + j] = sum;
        }
    for (j = 0; j < d; j++) {
        double length = 0;
        for (pass = 0; pass < 2; pass++)
            for (k = 0; k < j; k++) {
                double inner = 0;
                for (i = 0; i < d; i++) inner += next[i * d + k] * next[i * d + j];
                for (i = 0; i < d; i++) next[i * d + j] -= inner * next[i * d + k];
            }
        for (i = 0; i < d; i++) length = hypot(length, next[i * d + j]);
        growth[j] += log(length);
        rest -= log(length);
        for (i = 0; i < d; i++) next[i * d + j] /= length;
    }
    memcpy(frame, next, sizeof *frame * d * d);
    growth[d - 1] += rest;
    return fabs(rest);
}

/* Logarithms that do not add up by more have lost digits that a chart would show. */
static const double resolved = 1e-3;

/* frame: shape (d, d); growth: shape (d,); expansion: of all returns. */
static void count_return(jlt_lyapunov_state *state, double *frame, double *growth, double *expansion, const jlt_map_batch_return *p,
                         unsigned d)
{
    if (step_frame(frame, growth, p->slope, p->flux_determinant, d) > resolved && d > 2) state->blurred++;
    memcpy(state->q, p->q, d * sizeof *p->q);
    state->t += p->T;
    state->returns++;
    *expansion += p->expansion;
    for (unsigned k = 0; k < d; k++) state->exponents[k] = growth[k] / state->t;
    state->sum_check = *expansion / state->t;
}

jlt_status jlt_lyapunov_run(jlt_map *map, jlt_lyapunov_state *out, const double *q, size_t returns,
                            jlt_lyapunov_observer observer, void *context)
{
    const unsigned d = jlt_map_flow(map)->chart->dim;
    double frame[JLT_CHART_DIM_MAX * JLT_CHART_DIM_MAX] = { 0 }, growth[JLT_CHART_DIM_MAX] = { 0 }, expansion = 0;
    jlt_lyapunov_state state = { .returns = 0 };
    jlt_status st = JLT_OK;
    jlt_image image;

    memcpy(state.q, q, d * sizeof *q);
    for (unsigned k = 0; k < d; k++) frame[k * d + k] = 1;
    while (state.returns < returns) {
        JLT_TRY(jlt_map_apply(map, &image, state.q, 1, 1));
        count_return(&state, frame, growth, &expansion,
                     &(jlt_map_batch_return){ image.q, image.slope, image.flux_determinant, image.T, image.expansion }, d);
        if (observer != NULL && observer(context, &state) != 0) break;
    }
done:
    *out = state;
    return st;
}

/* What is known of all orbits: shape (count, dim, dim), (count, dim), and (count,). */
typedef struct {
    jlt_lyapunov_state *out;
    double *frames, *growth, *expansion;
    size_t *skipped, skip;
    unsigned d;
} company;

static void take_return(void *context, size_t i, const jlt_map_batch_return *made)
{
    const company *all = context;
    const unsigned d = all->d;

    if (all->skipped[i]++ >= all->skip)
        count_return(&all->out[i], all->frames + i * d * d, all->growth + i * d, &all->expansion[i], made, d);
}

jlt_status jlt_lyapunov_run_each(jlt_map_batch *maps, jlt_lyapunov_state *out, jlt_status *status, const double *q,
                                 const size_t *flow_of, size_t count, size_t skip, size_t returns)
{
    const unsigned d = jlt_map_batch_flow(maps)->chart->dim;
    const size_t frames = count * d * d;
    jlt_map_images images = { 0 };
    company all = { .out = out,
                    .frames = calloc(frames + count * (d + 1), sizeof *all.frames),
                    .skipped = calloc(count, sizeof *all.skipped),
                    .skip = skip,
                    .d = d };
    jlt_status st = JLT_ERR_NOMEM;

    if (all.frames == NULL || all.skipped == NULL) goto done;
    JLT_TRY(jlt_map_batch_images(&images, d, count));
    all.growth = all.frames + frames;
    all.expansion = all.growth + count * d;
    for (size_t i = 0; i < count; i++) {
        out[i] = (jlt_lyapunov_state){ .returns = 0 };
        memcpy(out[i].q, q + i * d, d * sizeof *q);
        for (unsigned k = 0; k < d; k++) all.frames[i * d * d + k * d + k] = 1;
    }
    JLT_TRY(jlt_map_batch_apply_flows(maps, &images, q, flow_of, count, skip + returns, 1, take_return, &all));
    memcpy(status, images.status, count * sizeof *status);
done:
    jlt_map_batch_images_clear(&images);
    free(all.frames);
    free(all.skipped);
    return st;
}

double jlt_lyapunov_growth(const double *slope, unsigned d)
{
    double vector[JLT_CHART_DIM_MAX], norm2 = 0, last;
    unsigned i, j, k;

    /* Power iteration on A^T A from its longest row of A: the norm from below, to rounding. */
    for (i = 0; i < d; i++) {
        double sum = 0;
        for (j = 0; j < d; j++) sum += slope[i * d + j] * slope[i * d + j];
        if (sum <= norm2) continue;
        norm2 = sum;
        memcpy(vector, slope + i * d, sizeof *vector * d);
    }
    last = 0;
    for (k = 0; k < 200 && norm2 > 0 && fabs(norm2 - last) > 1e-15 * norm2; k++) {
        double mapped[JLT_CHART_DIM_MAX] = { 0 }, length = 0;
        for (j = 0; j < d; j++) length = hypot(length, vector[j]);
        for (i = 0; i < d; i++)
            for (j = 0; j < d; j++) mapped[i] += slope[i * d + j] * vector[j] / length;
        last = norm2;
        for (norm2 = 0, i = 0; i < d; i++) norm2 += mapped[i] * mapped[i];
        memset(vector, 0, sizeof *vector * d);
        for (i = 0; i < d; i++)
            for (j = 0; j < d; j++) vector[j] += slope[i * d + j] * mapped[i];
    }
    return log(norm2) / 2;
}

jlt_status jlt_lyapunov_finite(jlt_map *map, double *exponent, double *t, const double *q, size_t returns)
{
    jlt_image image;
    const jlt_status st = jlt_map_apply(map, &image, q, returns, 1);

    if (st != JLT_OK) return st;
    *exponent = jlt_lyapunov_growth(image.slope, jlt_map_flow(map)->chart->dim) / image.T;
    *t = image.T;
    return JLT_OK;
}
