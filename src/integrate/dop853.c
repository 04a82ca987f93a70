/* E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., II.5 and II.6.
 *
 * The stage sums are straight-line code on vectors of eight columns. The newest slope enters each sum last and by scalars:
 * the kernel has just stored it entry by entry, and a vector load of it would wait for those stores. */
#include "integrate/dop853.h"

#include <stdlib.h>

#include "core/memory.h"
#include "integrate/dop853_coefficients.h"
#include "integrate/leap.h"

enum { WIDTH = JLT_STEPPER_WIDTH, SLOPES = 16 };
typedef double lanes __attribute__((vector_size(WIDTH * sizeof(double))));

struct jlt_dop853 {
    double *k;       /* (SLOPES, stride): the slopes k1 .. k16 */
    double *part;    /* (stride,): stage sum without its newest slope */
    double *stage;   /* (stride,): where the field is evaluated */
    double *trial, *trial_low; /* (stride,) */
    double error_before;       /* of the last accepted step, in units of the tolerance */
};

jlt_dop853 *jlt_dop853_new(const jlt_stepper *stepper)
{
    const size_t stride = stepper->stride;
    jlt_dop853 *self = jlt_memory_array(1, sizeof *self);
    if (self == NULL) return NULL;
    double *block = jlt_memory_array((SLOPES + 4) * stride, sizeof *block);
    if (block == NULL) {
        free(self);
        return NULL;
    }
    self->k = block;
    self->part = block + SLOPES * stride;
    self->stage = self->part + stride;
    self->trial = self->stage + stride;
    self->trial_low = self->trial + stride;
    self->error_before = 1;
    return self;
}

/* Add the newest slope to the sum, and evaluate the field there. */
static inline void close_stage(jlt_dop853 *self, const jlt_field *field, double ha, const double *newest, double *k)
{
    const unsigned dim = field->dim;
    double *stage = self->stage;
    const double *part = self->part;
#if defined(__clang__)
#pragma clang loop vectorize(disable)
#endif
    for (unsigned i = 0; i < dim; i++) stage[i] = part[i] + ha * newest[i];
    jlt_field_rates(field, k, stage);
}

#define K(j) k[((j) - 1) * blocks + b]
#define A(i, j) (jlt_dop853_a[i][j] * K(j))
#define E5(j) (jlt_dop853_e5[j] * K(j))
#define E3(j) ((jlt_dop853_a[13][j] - jlt_dop853_e3[j]) * K(j))
#define ROW(j) (self->k + ((j) - 1) * (size_t)stride)
#define FOR_BLOCKS for (unsigned b = 0; b < blocks; b++)
#define STAGE(i, last, older)                                              \
    FOR_BLOCKS part[b] = x0[b] + h * (older);                              \
    close_stage(self, field, h * jlt_dop853_a[i][last], ROW(last), ROW(i))

/* Compute k2 .. k12 from k1, and in `part` the increment of the solution but for k12. */
static inline __attribute__((always_inline)) void stages(jlt_dop853 *self, const jlt_field *field, const double *x,
                                                         double h, unsigned blocks)
{
    const unsigned stride = blocks * WIDTH;
    const lanes *k = (const lanes *)(const void *)self->k;
    const lanes *x0 = (const lanes *)(const void *)x;
    lanes *part = (lanes *)(void *)self->part;

    FOR_BLOCKS part[b] = x0[b];
    close_stage(self, field, h * jlt_dop853_a[2][1], ROW(1), ROW(2));
    STAGE(3, 2, A(3, 1));
    STAGE(4, 3, A(4, 1));
    STAGE(5, 4, A(5, 1) + A(5, 3));
    STAGE(6, 5, A(6, 1) + A(6, 4));
    STAGE(7, 6, A(7, 1) + A(7, 4) + A(7, 5));
    STAGE(8, 7, A(8, 1) + A(8, 4) + A(8, 5) + A(8, 6));
    STAGE(9, 8, A(9, 1) + A(9, 4) + A(9, 5) + A(9, 6) + A(9, 7));
    STAGE(10, 9, A(10, 1) + A(10, 4) + A(10, 5) + A(10, 6) + A(10, 7) + A(10, 8));
    STAGE(11, 10, A(11, 1) + A(11, 4) + A(11, 5) + A(11, 6) + A(11, 7) + A(11, 8) + A(11, 9));
    STAGE(12, 11, A(12, 1) + A(12, 4) + A(12, 5) + A(12, 6) + A(12, 7) + A(12, 8) + A(12, 9) + A(12, 10));
    FOR_BLOCKS part[b] = h * (A(13, 1) + A(13, 6) + A(13, 7) + A(13, 8) + A(13, 9) + A(13, 10) + A(13, 11));
}

/* Put the solution into trial and its rounding error into trial_low; then compute k13, the slope there. */
static inline void solution(jlt_dop853 *self, const jlt_stepper *stepper, const double *x, const double *x_low, double h)
{
    const unsigned stride = stepper->stride, columns = stepper->columns;
    const double hb = h * jlt_dop853_a[13][12], *newest = ROW(12);
#if defined(__clang__)
#pragma clang loop vectorize(disable)
#endif
    for (unsigned i = 0; i < columns; i++) {
        const double move = (self->part[i] + hb * newest[i]) + x_low[i];
        self->trial[i] = x[i] + move;
        self->trial_low[i] = (x[i] - self->trial[i]) + move;
    }
    jlt_field_rates(stepper->field, ROW(13), self->trial);
}

/* max(|a|, |b|, c) lane by lane, c >= 0, by masks: C has no conditional on vectors. */
static inline void largest(lanes *out, const lanes *a, const lanes *b, const lanes *c)
{
    typedef long long bits __attribute__((vector_size(WIDTH * sizeof(long long))));
    const bits magnitude = (bits){ 0 } + 0x7fffffffffffffffLL;
    const lanes p = (lanes)((bits)*a & magnitude), q = (lanes)((bits)*b & magnitude);
    const bits first = (bits)(p > q);
    const lanes m = (lanes)(((bits)p & first) | ((bits)q & ~first));
    const bits second = (bits)(m > *c);
    *out = (lanes)(((bits)m & second) | ((bits)*c & ~second));
}

/* The error norm of dop853, in units of the tolerance; NaN where a slope is not finite. */
static inline __attribute__((always_inline)) double error_norm(const jlt_dop853 *self, const jlt_stepper *stepper,
                                                               double h, unsigned blocks)
{
    const lanes *k = (const lanes *)(const void *)self->k;
    const lanes *x0 = (const lanes *)(const void *)stepper->x, *x1 = (const lanes *)(const void *)self->trial;
    const lanes *scale = (const lanes *)(const void *)stepper->scale;
    lanes sum5 = { 0 }, sum3 = { 0 };

    FOR_BLOCKS {
        lanes weight;
        largest(&weight, &x0[b], &x1[b], &scale[b]);
        const lanes e5 = (E5(1) + E5(6) + E5(7) + E5(8) + E5(9) + E5(10) + E5(11) + E5(12)) / weight;
        const lanes e3 = (E3(1) + E3(6) + E3(7) + E3(8) + E3(9) + E3(10) + E3(11) + E3(12)) / weight;
        sum5 += e5 * e5;
        sum3 += e3 * e3;
    }
    const double five = ((sum5[0] + sum5[1]) + (sum5[2] + sum5[3])) + ((sum5[4] + sum5[5]) + (sum5[6] + sum5[7]));
    const double three = ((sum3[0] + sum3[1]) + (sum3[2] + sum3[3])) + ((sum3[4] + sum3[5]) + (sum3[6] + sum3[7]));
    /* The slope at the end takes no part in the estimate, but a point where it is not finite must not be accepted. */
    lanes last = { 0 };
    FOR_BLOCKS last += 0 * K(13);
    const double defect = ((last[0] + last[1]) + (last[2] + last[3])) + ((last[4] + last[5]) + (last[6] + last[7]));
    const double denominator = five + 0.01 * three + defect;
    if (denominator == 0) return 0;
    return fabs(h) * five / (sqrt(denominator * stepper->controlled) * stepper->tolerance);
}

static inline __attribute__((always_inline)) double attempt_blocks(jlt_dop853 *self, const jlt_stepper *stepper, double h,
                                                                   unsigned blocks)
{
    stages(self, stepper->field, stepper->x, h, blocks);
    solution(self, stepper, stepper->x, stepper->x_low, h);
    return error_norm(self, stepper, h, blocks);
}

static double attempt(jlt_dop853 *self, const jlt_stepper *stepper, double h)
{
    return stepper->stride == WIDTH ? attempt_blocks(self, stepper, h, 1)
                                    : attempt_blocks(self, stepper, h, stepper->stride / WIDTH);
}

static void copy(double *to, const double *from, unsigned stride)
{
    for (unsigned i = 0; i < stride; i++) to[i] = from[i];
}

static jlt_status step(jlt_stepper *stepper, double limit)
{
    jlt_dop853 *self = stepper->state;
    const unsigned stride = stepper->stride;
    const double asked = jlt_smaller(stepper->h_next, stepper->max_step), size = jlt_smaller(asked, limit);
    double h = stepper->direction * size, error;
    bool rejected = false, finite = true, leaps = false;

    for (;;) {
        if (jlt_step_vanishes(stepper->tau, h)) return finite ? JLT_ERR_NO_PROGRESS : JLT_ERR_NONFINITE;
        error = attempt(self, stepper, h);
        stepper->evaluations += 12;
        leaps = error > 1 && jlt_leap_is_taken(stepper, h, self->trial);
        if (error <= 1 || leaps) break;
        finite = isfinite(error);
        h *= finite ? jlt_larger(0.9 * jlt_inverse_root(error, 1.0 / 8), 0.2) : 0.1;
        stepper->rejected++;
        rejected = true;
    }

    /* 0.9 err^-0.105 err_before^0.025: K. Gustafsson, ACM TOMS 17 (1991). It rejects far fewer steps than err^-1/8. */
    double factor = 0.9 * jlt_inverse_root(error, 0.105) / jlt_inverse_root(self->error_before, 0.025);
    factor = leaps ? 2 : jlt_smaller(jlt_larger(factor, 1.0 / 3), rejected ? 1 : 4);
    self->error_before = jlt_larger(error, 1e-4);
    const double proposed = fabs(h) * factor;
    stepper->h_next = !rejected && size < asked ? jlt_larger(proposed, asked) : proposed;

    stepper->h = h;
    copy(stepper->x_start, stepper->x, stride);
    copy(stepper->f_start, stepper->f, stride);
    copy(stepper->x, self->trial, stride);
    copy(stepper->x_low, self->trial_low, stride);
    copy(stepper->f, ROW(13), stride);
    copy(ROW(1), ROW(13), stride);
    return JLT_OK;
}

#define D(i, j) (jlt_dop853_d[i][j] * K(j))
#define D_SUM(i)                                                                                                   \
    (jlt_dop853_d[i][1] * f0[b] + D(i, 6) + D(i, 7) + D(i, 8) + D(i, 9) + D(i, 10) + D(i, 11) + D(i, 12) + D(i, 13)    \
     + D(i, 14) + D(i, 15) + D(i, 16))

/* Multiply the book's nested form, x0 + theta (r1 + (1 - theta)(r2 + theta (r3 + ...))), out into powers of theta. */
static void expand(jlt_stepper *stepper, const lanes r[8], unsigned b)
{
    lanes c[8] = { r[7] }; /* r7 is the innermost */
    for (unsigned m = 6; m >= 1; m--) {
        /* c <- r[m] + (theta or 1 - theta) c; degree of c is 6 - m */
        const unsigned degree = 6 - m;
        const bool inward = m % 2 == 1;
        for (unsigned j = degree + 1; j >= 1; j--) {
            const lanes stay = j <= degree ? c[j] : (lanes){ 0 };
            c[j] = inward ? stay - c[j - 1] : c[j - 1];
        }
        if (inward) c[0] += r[m];
        else c[0] = r[m];
    }
    for (unsigned j = 7; j >= 1; j--) c[j] = c[j - 1];
    c[0] = r[0];
    for (unsigned j = 0; j < 8; j++) *(lanes *)(void *)(stepper->dense + j * stepper->stride + b * WIDTH) = c[j];
}

/* Make the polynomial of the step from x to x_end, whose slopes k2 .. k13 are in place; f is k1. */
static void polynomial(jlt_dop853 *self, jlt_stepper *stepper, const double *x, const double *f, double h,
                       const double *x_end)
{
    const unsigned stride = stepper->stride, blocks = stride / WIDTH;
    const jlt_field *field = stepper->field;
    const lanes *k = (const lanes *)(const void *)self->k;
    const lanes *x0 = (const lanes *)(const void *)x, *f0 = (const lanes *)(const void *)f;
    const lanes *x1 = (const lanes *)(const void *)x_end;
    lanes *part = (lanes *)(void *)self->part;

    STAGE(14, 13, jlt_dop853_a[14][1] * f0[b] + A(14, 7) + A(14, 8) + A(14, 9) + A(14, 10) + A(14, 11) + A(14, 12));
    STAGE(15, 14, jlt_dop853_a[15][1] * f0[b] + A(15, 6) + A(15, 7) + A(15, 8) + A(15, 11) + A(15, 12) + A(15, 13));
    STAGE(16, 15, jlt_dop853_a[16][1] * f0[b] + A(16, 6) + A(16, 7) + A(16, 8) + A(16, 9) + A(16, 13) + A(16, 14));
    stepper->evaluations += 3;
    FOR_BLOCKS {
        const lanes move = x1[b] - x0[b];
        const lanes r[8] = { x0[b], move, h * f0[b] - move, 2 * move - h * (f0[b] + K(13)),
                             h * D_SUM(4), h * D_SUM(5), h * D_SUM(6), h * D_SUM(7) };
        expand(stepper, r, b);
    }
    stepper->dense_degree = 7;
    stepper->dense_error = 1e3 * stepper->tolerance; /* one order less than the step */
}

static jlt_status dense(jlt_stepper *stepper)
{
    polynomial(stepper->state, stepper, stepper->x_start, stepper->f_start, stepper->h, stepper->x);
    return JLT_OK;
}

void jlt_dop853_single(jlt_dop853 *self, const jlt_stepper *stepper, const double *x, const double *f, double h,
                       double *out)
{
    const unsigned stride = stepper->stride;
    const double hb = h * jlt_dop853_a[13][12];

    copy(ROW(1), f, stride);
    stages(self, stepper->field, x, h, stride / WIDTH);
    for (unsigned i = 0; i < stride; i++) out[i] = x[i] + (self->part[i] + hb * ROW(12)[i]);
}

void jlt_dop853_dense(jlt_dop853 *self, jlt_stepper *stepper, const double *x, double h, const double *x_end)
{
    const unsigned stride = stepper->stride;
    jlt_field_rates(stepper->field, ROW(13), x_end);
    polynomial(self, stepper, x, ROW(1), h, x_end);
    stepper->evaluations++;
}

/* A partial step overwrites the slopes of the whole step, so the polynomial that needs them is made before. */
static jlt_status partial(jlt_stepper *stepper, double theta, double *out)
{
    JLT_PASS(jlt_stepper_dense(stepper));
    jlt_dop853 *self = stepper->state;
    jlt_dop853_single(self, stepper, stepper->x_start, stepper->f_start, theta * stepper->h, out);
    copy(self->k, stepper->f, stepper->stride);
    stepper->evaluations += 11;
    return JLT_OK;
}

/* First step after Hairer, Norsett and Wanner, II.4: an explicit Euler step that should change little. */
static double first_step(jlt_dop853 *self, jlt_stepper *stepper)
{
    const unsigned columns = stepper->columns;
    double size = 0, speed = 0, bend = 0;

    for (unsigned i = 0; i < columns; i++) {
        const double w = jlt_larger(fabs(stepper->x[i]), stepper->scale[i]);
        size = jlt_larger(size, fabs(stepper->x[i]) / w);
        speed = jlt_larger(speed, fabs(stepper->f[i]) / w);
    }
    const double unit = jlt_first_unit(speed);
    speed *= unit;
    double h = unit * (size < 1e-5 || speed < 1e-5 ? 1e-6 : 0.01 * size / speed);
    h = jlt_smaller(h, stepper->max_step);
    for (unsigned i = 0; i < columns; i++) self->trial[i] = stepper->x[i] + stepper->direction * h * stepper->f[i];
    jlt_field_rates(stepper->field, self->stage, self->trial);
    stepper->evaluations++;
    for (unsigned i = 0; i < columns; i++) {
        const double w = jlt_larger(fabs(stepper->x[i]), stepper->scale[i]);
        bend = jlt_larger(bend, fabs(self->stage[i] - stepper->f[i]) / w / h);
    }
    const double steepest = jlt_larger(speed, bend * unit * unit);
    const double by_order = steepest <= 1e-15 ? jlt_larger(1e-6 * unit, h * 1e-3)
                                              : unit * 0.5 * jlt_inverse_root(steepest / stepper->tolerance, 1.0 / 8);
    return isfinite(bend) ? jlt_smaller(jlt_smaller(100 * h, by_order), stepper->max_step) : h;
}

static jlt_status start(jlt_stepper *stepper)
{
    jlt_dop853 *self = stepper->state;
    copy(self->k, stepper->f, stepper->stride);
    self->error_before = 1;
    if (!(stepper->h_next > 0)) stepper->h_next = first_step(self, stepper);
    return JLT_OK;
}

/* Length of the step times the largest slope at its stages: see method.h. */
static double variation(const jlt_stepper *stepper, unsigned column)
{
    const jlt_dop853 *self = stepper->state;
    double most = jlt_larger(fabs(stepper->f_start[column]), fabs(stepper->f[column]));
    for (unsigned j = 2; j <= 12; j++) most = jlt_larger(most, fabs(self->k[(j - 1) * stepper->stride + column]));
    return fabs(stepper->h) * most;
}

static jlt_status create(jlt_stepper *stepper)
{
    stepper->state = jlt_dop853_new(stepper);
    return stepper->state != NULL ? JLT_OK : JLT_ERR_NOMEM;
}

void jlt_dop853_free(jlt_dop853 *self)
{
    if (self == NULL) return;
    free(self->k);
    free(self);
}

static void destroy(jlt_stepper *stepper)
{
    jlt_dop853_free(stepper->state);
}

const jlt_method jlt_method_dop853 = {
    .name = "dop853",
    .meaning = "Dormand and Prince 8(5,3), 12 stages, dense output of order 7 (Hairer, Norsett and Wanner)",
    .order = 8,
    .share = 1.0 / 32,
    .create = create,
    .destroy = destroy,
    .start = start,
    .step = step,
    .dense = dense,
    .partial = partial,
    .variation = variation,
};
