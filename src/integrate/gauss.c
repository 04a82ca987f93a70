/* Collocation at the eight Gauss nodes (E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, II.1.3 and
 * VIII.6): order 16 at the ends, symmetric, and exact on quadratic integrals. The implicit equations are solved by sweeps over
 * all nodes, x <- x0 + h A f(x), which a vector processor does for the price of one evaluation. The first guess is the last step's
 * polynomial, continued. The field at the guess is evaluated already at the end of the last step, so that the processor does it
 * while events are looked for.
 * Errors of steps are estimated in gauss_error.h and gauss_between.h.
 *
 * Sweeps. They contract by a factor proportional to h. They end when what is left, change * rate/(1 - rate), is below a
 * twentieth of the tolerance or at the rounding level; a step that contracts slower than 0.7 is halved. */
#include "integrate/method.h"

#include <stdlib.h>
#include <string.h>

#include "core/memory.h"
#include "integrate/gauss_batch.h"
#include "integrate/gauss_between.h"
#include "integrate/gauss_coefficients.h"
#include "integrate/gauss_nodes.h"
#include "integrate/leap.h"
#include "kernel/batch_isa.h"

enum { N = JLT_GAUSS_NODES, SWEEPS_MAX = 24 };
static const double rounding = 8e-16; /* half a unit in each of 48 values, root of the sum of squares */
static const double slowest_rate = 0.7, growth_max = 2.5, safety = 0.65;
static const double left_by_sweeps = 0.05; /* of the tolerance */
static const double farthest = 128; /* in lengths of the last step: continued farther, its polynomial is rounding errors */

typedef struct {
    double *block;             /* all arrays below */
    const jlt_gauss_batch *batch;
    jlt_gauss_nodes nodes;     /* of the step being tried */
    jlt_gauss_nodes inside;    /* of a partial step; between nodes */
    bool has_between;          /* `inside` is between the nodes of the last step */
    double *past;              /* (dim, N): states at the nodes of the last accepted step */
    double guessed;            /* length of the step from the point for which `nodes` holds a guess; 0: none */
    double *clock;             /* (N,): dt/dtau at nodes */
    double *legendre;          /* (columns, N): of the last accepted step */
    double *trial;             /* (columns, N): of the step being tried */
    double *partial;           /* (columns, N): of a partial step, or the powers of a polynomial */
    double *end, *end_low;     /* (stride,): the point a step leads to, and its rounding error */
    double *end_f;             /* (stride,): the slope there */
    double *sizes;             /* (N,): of the Legendre coefficients, relative to the states, as binary logarithms */
    double *scratch;           /* work, (2, columns); of a field without batched kernels (2, N, columns) */
    double *spread;            /* the field's prepared values in every lane, for batched kernels; NULL: none are needed */
    const double *p;           /* these, or what the field passes through */
    double dense_error;
    double rate;               /* by which the last sweep of a whole step contracted */
    bool has_past;
} gauss;

static const jlt_gauss_batch *instance(const jlt_kernel_batch *kernels)
{
#if defined(JLT_HAVE_X86)
    if (kernels != NULL && strcmp(kernels->isa, "avx512") == 0) return &jlt_gauss_batch_avx512;
    if (kernels != NULL && strcmp(kernels->isa, "avx2") == 0) return &jlt_gauss_batch_avx2;
#else
    (void)kernels;
#endif
    return &jlt_gauss_batch_baseline;
}

/* Place the arrays of nodes: rows of eight from *rows, the others from *rest on. Moves both pointers behind them. */
static void place(jlt_gauss_nodes *nodes, double **rows, double **rest, const jlt_stepper *stepper)
{
    nodes->dim = stepper->field->dim;
    nodes->x = *rows;
    nodes->f = nodes->x + nodes->dim * N;
    *rows = nodes->f + nodes->dim * N;
    nodes->origin = *rest;
    nodes->inverse_weight = nodes->origin + nodes->dim;
    *rest = nodes->inverse_weight + stepper->columns;
}

static jlt_status create(jlt_stepper *stepper)
{
    const jlt_field *field = stepper->field;
    const size_t columns = stepper->columns, dim = field->dim;
    gauss *self = jlt_memory_array(1, sizeof *self);
    stepper->state = self;
    if (self == NULL) return JLT_ERR_NOMEM;

    /* Rows of eight first, so that all of them stay aligned. */
    const size_t scratch = 2 * columns * (field->batch == NULL ? N : 1);
    double *block =
        jlt_memory_array((5 * dim + 2 + 3 * columns) * N + 3 * stepper->stride + 2 * dim + 2 * columns + scratch, sizeof *block);
    if (block == NULL) return JLT_ERR_NOMEM;
    self->block = self->legendre = block;
    self->trial = self->legendre + columns * N;
    self->partial = self->trial + columns * N;
    self->sizes = self->partial + columns * N;
    self->clock = self->sizes + N;
    self->past = self->clock + N;
    double *rows = self->past + dim * N;
    self->end = rows + 4 * dim * N;
    self->end_low = self->end + stepper->stride;
    self->end_f = self->end_low + stepper->stride;
    self->scratch = self->end_f + stepper->stride;
    double *rest = self->scratch + scratch;
    place(&self->nodes, &rows, &rest, stepper);
    place(&self->inside, &rows, &rest, stepper);
    self->batch = instance(field->batch);
    self->p = field->p;
    if (field->batch == NULL || field->batch->prepared == 0) return JLT_OK;
    self->p = self->spread = jlt_batch_isa_spread(field->batch, field->p);
    return self->spread == NULL ? JLT_ERR_NOMEM : JLT_OK;
}

static void destroy(jlt_stepper *stepper)
{
    gauss *self = stepper->state;
    if (self == NULL) return;
    free(self->block);
    free(self->spread);
    free(self);
}

static void evaluate(gauss *self, jlt_stepper *stepper, const jlt_gauss_nodes *nodes)
{
    stepper->evaluations += N;
    jlt_gauss_nodes_evaluate(self->batch, stepper->field, self->p, self->scratch, nodes);
}

/* Legendre coefficients of the solved step. */
static void expand(gauss *self, const jlt_field *field, const jlt_gauss_nodes *nodes, double *legendre)
{
    self->batch->transform(legendre, nodes->f, jlt_gauss_legendre, field->dim);
    if (field->time_rate == NULL) return;
    for (unsigned i = 0; field->batch != NULL && i < N; i += self->batch->lanes)
        field->batch->time_factor(nodes->x + i, self->p, self->clock + i, N);
    for (unsigned i = 0; field->batch == NULL && i < N; i++) {
        for (unsigned c = 0; c < field->dim; c++) self->scratch[c] = nodes->x[c * N + i];
        field->time_rate(self->scratch, field->p, self->clock + i);
    }
    self->batch->transform(legendre + field->dim * N, self->clock, jlt_gauss_legendre, 1);
}

static void begin_at(const jlt_gauss_nodes *nodes, const jlt_stepper *stepper, const double *x0)
{
    for (unsigned c = 0; c < nodes->dim; c++) nodes->origin[c] = x0[c];
    for (unsigned c = 0; c < stepper->columns; c++)
        nodes->inverse_weight[c] = 1 / jlt_larger(fabs(x0[c]), stepper->scale[c]);
}

/* Guess the nodes of a step h from the point, `growth` times as long as the last one: by the last step's polynomial, continued; by
 * a straight line if there is no last step, or it is too short for that. */
static void guess(gauss *self, jlt_stepper *stepper, double h, double growth)
{
    const jlt_gauss_nodes *nodes = &self->nodes;
    const bool told = self->has_past && growth < farthest;

    begin_at(nodes, stepper, stepper->x);
    if (told) {
        self->batch->transform(self->partial, self->legendre, jlt_gauss_power_ahead, nodes->dim);
        self->batch->follow(nodes, self->partial, stepper->h, growth);
    }
    for (unsigned c = 0; !told && c < nodes->dim; c++)
        for (unsigned i = 0; i < N; i++) nodes->x[c * N + i] = nodes->origin[c] + h * jlt_gauss_node[i] * stepper->f[c];
    evaluate(self, stepper, nodes);
    self->guessed = h;
}

/* By how much slopes move, relative to the states' sizes, where states are moved by a part of their sizes, or of their values: not
 * at all where a state stays 0, or a tangent that falls as it does would seem to be driven. */
static double moved_by(gauss *self, jlt_stepper *stepper, double part, bool of_size)
{
    const jlt_field *field = stepper->field;
    double *x = self->scratch, *f = self->scratch + field->dim, moved = 0;

    for (unsigned c = 0; c < field->dim; c++) {
        const double value = fabs(stepper->x[c]), scale = jlt_field_keeps(field, c) ? 0 : stepper->scale[c];
        const double size = !of_size ? value : scale < INFINITY ? jlt_larger(value, scale) : 0;
        x[c] = stepper->x[c] + (c % 2 == 0 ? part : -part) * size;
    }
    field->call(x, field->p, f);
    stepper->evaluations++;
    for (unsigned c = 0; c < field->dim; c++)
        moved = jlt_larger(moved, fabs(f[c] - stepper->f[c]) / jlt_larger(fabs(stepper->x[c]), stepper->scale[c]));
    return moved;
}

/* Solve for the nodes of a step h, beginning with those in place. The field is evaluated before a sweep is judged, so that the two
 * overlap. *rate: the factor by which a sweep contracts, 1 if not known; replaced where it is measured. insist: go on where sweeps
 * do not contract, in a part of a step already solved: they do so in pairs there, or only rounding is left. */
static bool solve(gauss *self, jlt_stepper *stepper, const jlt_gauss_nodes *nodes, double h, double *rate, bool insist)
{
    const double enough = left_by_sweeps * stepper->tolerance;
    double last = INFINITY;

    for (unsigned sweeps = 2; sweeps <= SWEEPS_MAX; sweeps++) {
        const double square = self->batch->move(nodes, h);
        evaluate(self, stepper, nodes);
        const double change = sqrt(square), before = sweeps == 2 ? change / *rate : last;
        last = change;
        if (!(change < 1e3)) return false;
        if (change <= rounding) return true;
        if (change * change <= enough * (before - change)) {
            *rate = change / before;
            return true;
        }
        if (sweeps > 2 && change > slowest_rate * before) {
            if (change < jlt_larger(1e-13, fabs(h) * moved_by(self, stepper, rounding, false))) return true; /* rounding cycles */
            if (sweeps > 3 && !insist) return false;
        }
    }
    return insist && last <= jlt_larger(stepper->tolerance, 1e-12);
}

static jlt_status step(jlt_stepper *stepper, double limit)
{
    gauss *self = stepper->state;
    const jlt_field *field = stepper->field;
    const unsigned columns = stepper->columns;
    const double asked = jlt_smaller(stepper->h_next, stepper->max_step), size = jlt_smaller(asked, limit);
    double h = stepper->direction * size, error = NAN, solved_h = 0; /* error: its logarithm */
    bool rejected = false, finite = true, leaps = false;

    for (;;) {
        if (jlt_step_vanishes(stepper->tau, h)) return finite ? JLT_ERR_NO_PROGRESS : JLT_ERR_NONFINITE;
        if (solved_h != 0) { /* a longer step that was solved guesses the shorter one well */
            self->batch->transform(self->partial, self->trial, jlt_gauss_power, self->nodes.dim);
            self->batch->follow(&self->nodes, self->partial, solved_h, h / solved_h);
            evaluate(self, stepper, &self->nodes);
        } else if (h != self->guessed) {
            guess(self, stepper, h, h / stepper->h);
        }
        self->guessed = 0;
        double rate = 1, defect = 0;
        self->has_between = false;
        const bool solved = solve(self, stepper, &self->nodes, h, &rate, false);
        if (solved) {
            if (rate < 1) self->rate = rate;
            expand(self, field, &self->nodes, self->trial);
            self->batch->sizes(self->sizes, self->trial, self->nodes.inverse_weight, columns);
            jlt_gauss_error seen = jlt_gauss_error_of(self->sizes, h, stepper->tolerance, -INFINITY);
            const bool falls = seen.falls;
            const jlt_gauss_error lax = falls ? seen : jlt_gauss_error_of(self->sizes, h, stepper->tolerance, INFINITY);
            if (lax.local <= 0) seen = lax;
            error = seen.local;
            if (error <= 0 || jlt_step_is_short(stepper->tau, h)) {
                for (unsigned c = 0; c < columns; c++) {
                    const double move = h * self->trial[c * N] + stepper->x_low[c];
                    self->end[c] = stepper->x[c] + move;
                    self->end_low[c] = (stepper->x[c] - self->end[c]) + move;
                }
                jlt_field_rates(field, self->end_f, self->end);
                stepper->evaluations++;
                for (unsigned c = 0; c < columns; c++) defect += 0 * (self->end[c] + self->end_f[c]);
                const jlt_gauss_step made = {
                    .h = h, .field = field, .legendre = self->trial, .before = stepper->f, .end = self->end, .after = self->end_f,
                    .weights = self->nodes.inverse_weight, .columns = columns, .work = self->scratch,
                    .rounding = rounding, .left = jlt_larger(left_by_sweeps * stepper->tolerance, rounding)
                };
                if (!falls) stepper->evaluations += jlt_gauss_error_see_tail(&seen, &made, self->sizes, stepper->tolerance);
                /* where the step is too long anyway, an end that is not finite says nothing of a shorter one */
                if (seen.local <= 0) stepper->evaluations += jlt_gauss_error_see_ends(&seen, &made);
                else defect = 0;
                if (seen.local <= 0) {
                    stepper->evaluations += jlt_gauss_between_see(&seen, &self->inside, &made, self->batch, self->p, &self->nodes);
                    self->has_between = true;
                }
                error = seen.local;
                self->dense_error = jlt_rough_exp2(jlt_larger(jlt_smaller(seen.dense, 999), -999));
                leaps = defect == 0 && error > 0 && jlt_leap_is_taken(stepper, h, self->end);
                if (defect == 0 && (error <= 0 || leaps)) break;
            }
        }
        finite = solved && isfinite(error) && defect == 0;
        solved_h = finite ? h : 0;
        h *= finite && error > 0 ? jlt_larger(safety * jlt_rough_exp2((-1.0 / 17) * error), 0.3) : 0.5;
        stepper->rejected++;
        rejected = true;
    }

    const double factor = leaps ? 2 : jlt_smaller(safety * jlt_rough_exp2((-1.0 / 17) * error), rejected ? 1 : growth_max);
    const double proposed = fabs(h) * factor;
    stepper->h_next = !rejected && size < asked ? jlt_larger(proposed, asked) : proposed;
    stepper->h = h;
    const size_t size_of_row = stepper->stride * sizeof *stepper->x;
    memcpy(stepper->x_start, stepper->x, size_of_row);
    memcpy(stepper->f_start, stepper->f, size_of_row);
    memcpy(stepper->x, self->end, size_of_row);
    memcpy(stepper->x_low, self->end_low, size_of_row);
    memcpy(stepper->f, self->end_f, size_of_row);
    double *const legendre = self->legendre, *const past = self->past;
    self->legendre = self->trial, self->trial = legendre;
    self->past = self->nodes.x, self->nodes.x = past;
    self->has_past = true;
    /* Begin the next step at once: its evaluations overlap with the search for events on this one. */
    const double next = jlt_smaller(stepper->h_next, stepper->max_step);
    guess(self, stepper, stepper->direction * next, next == proposed ? factor : next / fabs(h));
    return JLT_OK;
}

/* The inverse of the field's Lipschitz constant, estimated in an arbitrary direction. Near an unstable equilibrium a first step
 * much longer than that may seem to be solved, since the growing part of the start is so small that no sweep detects it. */
static double time_of_change(gauss *self, jlt_stepper *stepper)
{
    static const double small = 1e-7;
    const double change = moved_by(self, stepper, small, true);

    return change > 0 && change < INFINITY ? small / change : INFINITY;
}

static jlt_status start(jlt_stepper *stepper)
{
    gauss *self = stepper->state;
    double size = 0, speed = 0;

    self->has_past = self->has_between = false;
    self->guessed = 0;
    if (stepper->h_next > 0) return JLT_OK;
    for (unsigned c = 0; c < stepper->columns; c++) { /* as for dop853, but cheaper: the controller is fast */
        const double w = jlt_larger(fabs(stepper->x[c]), stepper->scale[c]);
        size = jlt_larger(size, fabs(stepper->x[c]) / w);
        speed = jlt_larger(speed, fabs(stepper->f[c]) / w);
    }
    const double unit = jlt_first_unit(speed);
    const double h = unit * (size < 1e-5 || speed == 0 ? 1e-3 : 0.1 * size / (speed * unit));
    stepper->h_next = jlt_smaller(jlt_smaller(h, time_of_change(self, stepper)), stepper->max_step);
    return JLT_OK;
}

static jlt_status dense(jlt_stepper *stepper)
{
    gauss *self = stepper->state;
    self->batch->transform(self->partial, self->legendre, jlt_gauss_power, stepper->columns);
    for (unsigned c = 0; c < stepper->columns; c++) {
        stepper->dense[c] = stepper->x_start[c];
        for (unsigned m = 0; m < N; m++)
            stepper->dense[(m + 1) * (size_t)stepper->stride + c] = stepper->h * self->partial[c * N + m];
    }
    stepper->dense_degree = N;
    stepper->dense_error = self->dense_error;
    return JLT_OK;
}

static jlt_status partial(jlt_stepper *stepper, double theta, double *out)
{
    gauss *self = stepper->state;
    const double h = theta * stepper->h;
    self->has_between = false;
    begin_at(&self->inside, stepper, stepper->x_start);
    self->batch->transform(self->partial, self->legendre, jlt_gauss_power, self->inside.dim);
    self->batch->follow(&self->inside, self->partial, stepper->h, theta);
    evaluate(self, stepper, &self->inside);
    double rate = jlt_larger(self->rate, 0.2) * fabs(theta);
    if (!solve(self, stepper, &self->inside, h, &rate, true)) return JLT_ERR_NO_CONVERGENCE;
    expand(self, stepper->field, &self->inside, self->partial);
    for (unsigned c = 0; c < stepper->columns; c++) out[c] = stepper->x_start[c] + h * self->partial[c * N];
    return JLT_OK;
}

static const double *nodes(const jlt_stepper *stepper) { return ((const gauss *)stepper->state)->past; }

/* |P_k| <= 1. */
static double variation(const jlt_stepper *stepper, unsigned column)
{
    const double *legendre = ((const gauss *)stepper->state)->legendre + column * N;
    double even = 0, odd = 0;
    for (unsigned k = 0; k < N; k += 2) {
        even += fabs(legendre[k]);
        odd += fabs(legendre[k + 1]);
    }
    return fabs(stepper->h) * (even + odd);
}

static unsigned bernstein(jlt_stepper *stepper, unsigned column, double *b)
{
    const gauss *self = stepper->state;
    _Alignas(64) double sum[N];
    self->batch->transform(sum, self->legendre + column * N, jlt_gauss_bernstein, 1);
    b[0] = stepper->x_start[column];
    for (unsigned j = 0; j < N; j++) b[j + 1] = stepper->x_start[column] + stepper->h / 56 * sum[j];
    stepper->dense_error = self->dense_error;
    return N;
}

static const double *between(const jlt_stepper *stepper)
{
    const gauss *self = stepper->state;
    return self->has_between ? self->inside.x : NULL;
}

const jlt_method jlt_method_gauss = {
    .name = "gauss",
    .meaning = "Gauss-Legendre collocation of order 16, eight nodes at once by vectors (Hairer, Lubich and Wanner)",
    .order = 16,
    .share = 1,
    .create = create,
    .destroy = destroy,
    .start = start,
    .step = step,
    .dense = dense,
    .partial = partial,
    .variation = variation,
    .bernstein = bernstein,
    .nodes = nodes,
    .between = between,
};
