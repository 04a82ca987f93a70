#include "dynamics/lyapunov.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/memory.h"
#include "dynamics/linear.h"
#include "ext/eigen.h"
#include "integrate/epoch.h"

/* The relative length below which errors of the tolerance change a vector of DP by more than a thousandth. */
static double noise_of(const jlt_flow *flow)
{
    return 1e3 * (flow->tolerance != 0 ? flow->tolerance : JLT_ORBIT_TOLERANCE);
}

/* Replace the columns of `frame` by A = `slope` times them, orthonormalised by modified Gram-Schmidt, twice, and add the
 * logarithms of their lengths to growth. These add up to log |det A| = log(size), from which the last follows without its column,
 * which rounding may make 0. growth is NaN from the first length that is below `noise` times the longest row of A, or 1, if that
 * is longer. Returns whether there is such a length. */
static bool step_frame(double *frame, double *growth, const double *slope, double size, double noise, unsigned d)
{
    double next[JLT_CHART_DIM_MAX * JLT_CHART_DIM_MAX];
    double rest = log(size), longest = 1;
    bool is_lost = false;

    for (unsigned i = 0; i < d; i++) longest = fmax(longest, jlt_linear_length(slope + i * d, d));

    jlt_linear_multiply(next, slope, frame, d);
    for (unsigned j = 0; j + 1 < d; j++) {
        double length = 0;
        for (unsigned pass = 0; pass < 2; pass++)
            for (unsigned k = 0; k < j; k++) {
                double inner = 0;
                for (unsigned i = 0; i < d; i++) inner += frame[i * d + k] * next[i * d + j];
                for (unsigned i = 0; i < d; i++) next[i * d + j] -= inner * frame[i * d + k];
            }
        for (unsigned i = 0; i < d; i++) length = hypot(length, next[i * d + j]);
        is_lost |= !(length > noise * longest);
        growth[j] += is_lost ? NAN : log(length);
        rest -= log(length);
        for (unsigned i = 0; i < d; i++) frame[i * d + j] = next[i * d + j] /= length;
    }
    is_lost |= !(size > 0); /* |det A| underflowed */
    growth[d - 1] += is_lost ? NAN : rest;
    return is_lost;
}

/* Make an orthonormal frame that favours no axis, by a reflection that maps no axis to an axis: a vector in an invariant plane, or
 * along a decoupled state, would never turn to the direction that grows most. */
static void begin_frame(double *frame, unsigned d)
{
    double v[JLT_CHART_DIM_MAX], square = 0;

    for (unsigned k = 0; k < d; k++) v[k] = 1 / (k + 1.618033988749895);
    for (unsigned k = 0; k < d; k++) square += v[k] * v[k];
    for (unsigned i = 0; i < d; i++)
        for (unsigned k = 0; k < d; k++) frame[i * d + k] = (i == k) - 2 * v[i] * v[k] / square;
}

/* Add a return to the state. frame: shape (d, d); growth: shape (d,); expansion: summed over returns. */
static void count_return(jlt_lyapunov_state *state, double *frame, double *growth, double *expansion, const jlt_map_batch_return *p,
                         const jlt_flow *flow)
{
    const unsigned d = flow->chart->dim;
    double slope[JLT_CHART_DIM_MAX * JLT_CHART_DIM_MAX];

    jlt_chart_scaled_slope(flow->chart, slope, p->slope);
    if (step_frame(frame, growth, slope, p->flux_determinant, noise_of(flow), d)) state->blurred++;
    jlt_saddle_note(&state->saddle, flow, state->q, p, state->returns + 1);
    memcpy(state->q, p->q, d * sizeof *p->q);
    jlt_epoch time = { state->t, state->t_low };
    jlt_epoch_move(&time, &(double){ p->T });
    state->t = time.time, state->t_low = time.low;
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
    begin_frame(frame, d);
    while (state.returns < returns) {
        JLT_TRY(jlt_map_apply(map, &image, state.q, 1, 1));
        count_return(&state, frame, growth, &expansion,
                     &(jlt_map_batch_return){ image.q, image.slope, image.flux_determinant, image.T, image.expansion },
                     jlt_map_flow(map));
        if (observer != NULL && observer(context, &state) != 0) break;
    }
done:
    *out = state;
    return st;
}

/* What is known of all orbits; arrays without a shape are (count,). */
typedef struct {
    jlt_lyapunov_state *out;
    double *frames, *growth, *expansion; /* frames: (count, dim, dim); growth: (count, dim) */
    size_t *skipped, skip;
    const jlt_flow *flows;
    const size_t *flow_of;
} company;

static void take_return(void *context, size_t i, const jlt_map_batch_return *made)
{
    const company *all = context;
    const jlt_flow *flow = all->flows + all->flow_of[i];
    const unsigned d = flow->chart->dim;

    if (all->skipped[i]++ >= all->skip)
        count_return(&all->out[i], all->frames + i * d * d, all->growth + i * d, &all->expansion[i], made, flow);
}

jlt_status jlt_lyapunov_run_each(jlt_map_batch *maps, jlt_lyapunov_state *out, jlt_status *status, const double *q,
                                 const size_t *flow_of, size_t count, size_t skip, size_t returns)
{
    if (skip > SIZE_MAX - returns) return JLT_ERR_ARG;
    const unsigned d = jlt_map_batch_flow(maps)->chart->dim;
    const size_t frames = count * d * d;
    jlt_map_images images = { 0 };
    company all = { .out = out,
                    .frames = calloc(frames + count * (d + 1), sizeof *all.frames),
                    .skipped = calloc(count, sizeof *all.skipped),
                    .skip = skip,
                    .flows = jlt_map_batch_flow(maps),
                    .flow_of = flow_of };
    jlt_status st = JLT_ERR_NOMEM;

    if (all.frames == NULL || all.skipped == NULL) goto done;
    JLT_TRY(jlt_map_batch_images(&images, d, count));
    all.growth = all.frames + frames;
    all.expansion = all.growth + count * d;
    for (size_t i = 0; i < count; i++) {
        out[i] = (jlt_lyapunov_state){ .returns = 0 };
        memcpy(out[i].q, q + i * d, d * sizeof *q);
        begin_frame(all.frames + i * d * d, d);
    }
    JLT_TRY(jlt_map_batch_apply_flows(maps, &images, q, flow_of, count, skip + returns, take_return, &all));
    memcpy(status, images.status, count * sizeof *status);
done:
    jlt_map_batch_images_clear(&images);
    free(all.frames);
    free(all.skipped);
    return st;
}

/* Of each orbit the product of its returns' derivatives, (d, d), without a factor 2^exponent, which may be beyond doubles; and
 * its saddles, with the number of its returns and the last, (d,). */
typedef struct {
    double *slopes, *exponents, *last;
    jlt_saddle_watch *saddles;
    size_t *returns;
    const jlt_flow *flow;
} products;

static void add_slope(void *context, size_t i, const jlt_map_batch_return *made)
{
    const products *all = context;
    const jlt_chart *chart = all->flow->chart;
    const unsigned d = chart->dim;
    const size_t size = (size_t)d * d;
    double *slope = all->slopes + i * size, scaled[JLT_CHART_DIM_MAX * JLT_CHART_DIM_MAX], largest = 0;
    int most = 0;

    jlt_linear_multiply(slope, made->slope, slope, d);
    jlt_saddle_note(&all->saddles[i], all->flow, all->last + i * d, made, ++all->returns[i]);
    memcpy(all->last + i * d, made->q, d * sizeof *made->q);
    jlt_chart_scaled_slope(chart, scaled, slope); /* in any units the same factor */
    for (size_t k = 0; k < size; k++) largest = fmax(largest, fabs(scaled[k]));
    if (isfinite(largest)) (void)frexp(largest, &most);
    for (size_t k = 0; k < size; k++) slope[k] = ldexp(slope[k], -most);
    all->exponents[i] += most;
}

jlt_status jlt_lyapunov_finite_each(jlt_map_batch *maps, double *exponents, const jlt_map_images *images,
                                    jlt_saddle_watch *saddles, const double *q, size_t count, size_t returns)
{
    const jlt_flow *flow = jlt_map_batch_flow(maps);
    const unsigned d = flow->chart->dim;
    JLT_FREED size_t *flow_of = calloc(count, 2 * sizeof *flow_of);
    JLT_FREED double *slopes = calloc(count * (d + 1), d * sizeof *slopes);
    products all = { slopes, exponents, slopes + count * d * d, saddles, flow_of + count, flow };

    if (count > 0 && (flow_of == NULL || slopes == NULL)) return JLT_ERR_NOMEM;
    memcpy(all.last, q, count * d * sizeof *q);
    for (size_t i = 0; i < count; i++) {
        exponents[i] = 0;
        saddles[i] = (jlt_saddle_watch){ 0 };
        for (unsigned k = 0; k < d; k++) slopes[(i * d + k) * d + k] = 1;
    }
    JLT_PASS(jlt_map_batch_apply_flows(maps, images, q, flow_of, count, returns, add_slope, &all));
    for (size_t i = 0; i < count; i++) {
        double *slope = slopes + i * d * d;
        double norm = NAN;
        jlt_chart_scaled_slope(flow->chart, slope, slope);
        if (jlt_eigen_norm(&norm, slope, d) == JLT_ERR_NOMEM) return JLT_ERR_NOMEM;
        const double growth = log(norm) + exponents[i] * log(2);
        const bool is_told = images->status[i] == JLT_OK && growth > (double)returns * log(noise_of(flow));
        exponents[i] = is_told ? growth / images->T[i] : NAN;
    }
    return JLT_OK;
}
