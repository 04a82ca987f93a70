/* Collocation at the eight Gauss nodes (E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, II.1.3 and
 * VIII.6): order 16 at the ends, symmetric, and exact on quadratic integrals. The implicit equations are solved by sweeps over
 * all nodes, x <- x0 + h A f(x), which a vector processor does for the price of one evaluation; the first guess is the
 * last step's polynomial for f, continued.
 *
 * Error. Let a_k be the coefficients of f on the step in Legendre polynomials, n_k their size relative to the states times h.
 * For analytic solutions n_k falls like r^k, and the quadrature at the end errs by the aliased part, ~ n_0 r^16. With
 * r = (n_7/n_0)^(1/7), where n_0 is the largest of the first three, the estimate is n_7 (n_7/n_0)^(9/7), proportional to h^17. The polynomial inside the step errs by
 * the part left out, n_8 ~ r n_7.
 *
 * Sweeps. They contract by a factor proportional to h. They end when what is left, change * rate/(1 - rate), is below a
 * twentieth of the tolerance or at the rounding level; a step that contracts slower than 0.7 is halved. */
#include "integrate/gauss.h"

#include <stdlib.h>
#include <string.h>

#include "core/memory.h"
#include "integrate/gauss_batch.h"
#include "integrate/gauss_coefficients.h"
#include "integrate/step_control.h"

enum { N = JLT_GAUSS_NODES, SWEEPS_MAX = 24 };
static const double rounding = 4e-16, slowest_rate = 0.7, growth_max = 2.5, safety = 0.75;

typedef struct {
    double *block;             /* all arrays below */
    const jlt_gauss_batch *batch;
    jlt_gauss_nodes nodes;     /* of the step being tried */
    double *legendre;          /* (columns, N): of the last accepted step */
    double *trial;             /* (columns, N): of the step being tried */
    double *partial;           /* (columns, N): of a partial step, or powers for the polynomial */
    double *end;               /* (stride,) */
    double *origin;            /* (dim,) */
    double *inverse_weight;    /* (dim,) */
    double (*basis)[N];        /* (N, N): P_k at the nodes of the next step */
    double dense_error;
    unsigned sweeps;           /* of the last solved step */
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

static jlt_status create(jlt_stepper *stepper)
{
    const jlt_field *field = stepper->field;
    const size_t columns = stepper->columns, dim = field->dim;
    gauss *self = jlt_memory_array(1, sizeof *self);
    stepper->state = self;
    if (self == NULL) return JLT_ERR_NOMEM;

    /* Rows of eight first, so that all of them stay aligned. */
    double *block = jlt_memory_array((2 * dim + 1 + 3 * columns + N) * N + stepper->stride + 4 * dim, sizeof *block);
    if (block == NULL) return JLT_ERR_NOMEM;
    self->block = self->legendre = block;
    self->trial = self->legendre + columns * N;
    self->partial = self->trial + columns * N;
    self->basis = (double (*)[N])(void *)(self->partial + columns * N);
    self->nodes.x = self->partial + columns * N + N * N;
    self->nodes.f = self->nodes.x + dim * N;
    self->end = self->nodes.f + (dim + 1) * N;
    self->origin = self->end + stepper->stride;
    self->inverse_weight = self->origin + dim;
    self->nodes.scratch = self->inverse_weight + dim;
    self->nodes.origin = self->origin;
    self->nodes.inverse_weight = self->inverse_weight;
    self->nodes.kernels = field->batch;
    self->nodes.call = field->call;
    self->nodes.time_rate = field->time_rate;
    self->nodes.p = field->p;
    self->nodes.dim = field->dim;
    self->batch = instance(field->batch);
    return JLT_OK;
}

static void destroy(jlt_stepper *stepper)
{
    gauss *self = stepper->state;
    if (self == NULL) return;
    free(self->block);
    free(self);
}

/* P_k(u_i) for all k and i, by the recurrence (k + 1) P_(k+1) = (2k + 1) u P_k - k P_(k-1). */
static void make_basis(double (*basis)[N], const double *u)
{
    static const double up[N] = { 0, 0, 3.0 / 2, 5.0 / 3, 7.0 / 4, 9.0 / 5, 11.0 / 6, 13.0 / 7 };
    static const double down[N] = { 0, 0, 1.0 / 2, 2.0 / 3, 3.0 / 4, 4.0 / 5, 5.0 / 6, 6.0 / 7 };
    for (unsigned i = 0; i < N; i++) {
        basis[0][i] = 1;
        basis[1][i] = u[i];
    }
    for (unsigned k = 2; k < N; k++)
        for (unsigned i = 0; i < N; i++) basis[k][i] = up[k] * u[i] * basis[k - 1][i] - down[k] * basis[k - 2][i];
}

/* Solve for the nodes of a step h from x0, beginning with what stands in nodes.f. */
static bool solve(gauss *self, const jlt_stepper *stepper, const double *x0, double h)
{
    const unsigned dim = stepper->field->dim;
    double last = INFINITY, enough = 0.05 * stepper->tolerance;

    for (unsigned c = 0; c < dim; c++) {
        self->origin[c] = x0[c];
        self->inverse_weight[c] = 1 / jlt_larger(fabs(x0[c]), stepper->scale[c]);
    }
    for (self->sweeps = 1; self->sweeps <= SWEEPS_MAX; self->sweeps++) {
        const double change = self->batch->sweep(&self->nodes, h);
        if (self->sweeps == 1) continue; /* the change from another step's nodes says nothing */
        if (!(change < 1e3)) return false;
        if (change <= rounding) return true;
        const double rate = change / last;
        last = change;
        if (self->sweeps == 2) continue;
        if (change * rate <= enough * (1 - rate)) return true;
        if (rate > slowest_rate) {
            if (change < 1e-13) return true; /* rounding errors go round */
            if (self->sweeps > 3) return false;
        }
    }
    return false;
}

static void guess_constant(gauss *self, const jlt_stepper *stepper)
{
    for (unsigned c = 0; c < stepper->field->dim; c++)
        for (unsigned i = 0; i < N; i++) self->nodes.f[c * N + i] = stepper->f[c];
}

/* First guess of f at the nodes of a step from `from` to `from + length`, both in units of the step that has these Legendre
 * coefficients. */
static void guess(gauss *self, const jlt_stepper *stepper, const double *legendre, double from, double length)
{
    double u[N];
    for (unsigned i = 0; i < N; i++) u[i] = 2 * (from + length * jlt_gauss_node[i]) - 1;
    make_basis(self->basis, u);
    self->batch->transform(self->nodes.f, legendre, (const double (*)[N])self->basis, stepper->field->dim);
}

/* Legendre coefficients of the solved step. */
static void expand(gauss *self, const jlt_stepper *stepper, double *legendre)
{
    if (stepper->columns > stepper->field->dim) self->batch->clock(&self->nodes);
    self->batch->transform(legendre, self->nodes.f, jlt_gauss_legendre, stepper->columns);
}

/* Local error at the end, in units of the tolerance; self->dense_error as a side result. */
static double error_norm(gauss *self, const jlt_stepper *stepper, double h)
{
    double size = 0, six = 0, seven = 0;
    for (unsigned c = 0; c < stepper->columns; c++) {
        const double *a = self->trial + c * N, unit = fabs(h) / jlt_larger(fabs(stepper->x[c]), stepper->scale[c]);
        size = jlt_larger(size, unit * jlt_larger(jlt_larger(fabs(a[0]), fabs(a[1])), fabs(a[2])));
        six = jlt_larger(six, unit * fabs(a[6]));
        seven = jlt_larger(seven, unit * fabs(a[7]));
    }
    if (!(size < INFINITY)) return NAN;
    if (size == 0) return 0;
    /* A seventh coefficient may vanish by chance; the sixth then stands in, one factor r lower. */
    const double by_six = six / jlt_inverse_root(six / size, 1.0 / 6);
    const double last = jlt_larger(seven, by_six), r = 1 / jlt_inverse_root(last / size, 1.0 / 7);
    self->dense_error = last * r;
    return last * (last / size) * r * r / stepper->tolerance;
}

static jlt_status step(jlt_stepper *stepper, double limit)
{
    gauss *self = stepper->state;
    const jlt_field *field = stepper->field;
    const unsigned columns = stepper->columns, stride = stepper->stride;
    const double asked = jlt_smaller(stepper->h_next, stepper->max_step), size = jlt_smaller(asked, limit);
    double h = stepper->direction * size, error = NAN, solved_h = 0;
    bool rejected = false, finite = true;

    for (;;) {
        if (jlt_step_vanishes(stepper->tau, h)) return finite ? JLT_ERR_NO_PROGRESS : JLT_ERR_NONFINITE;
        if (solved_h != 0) guess(self, stepper, self->trial, 0, h / solved_h);
        else if (self->has_past) guess(self, stepper, self->legendre, 1, h / stepper->h);
        else guess_constant(self, stepper);
        const bool solved = solve(self, stepper, stepper->x, h);
        stepper->evaluations += N * self->sweeps;
        if (solved) {
            expand(self, stepper, self->trial);
            error = error_norm(self, stepper, h);
            if (error <= 1) {
                for (unsigned c = 0; c < columns; c++) self->end[c] = stepper->x[c] + (h * self->trial[c * N] + stepper->x_low[c]);
                double *f = self->nodes.x; /* the nodes are not needed any more; (columns,) fits in (dim, N) */
                field->call(self->end, field->p, f);
                if (field->time_rate != NULL) field->time_rate(self->end, field->p, f + field->dim);
                stepper->evaluations++;
                double defect = 0;
                for (unsigned c = 0; c < columns; c++) defect += 0 * f[c];
                if (defect == 0) break;
            }
        }
        finite = solved && isfinite(error);
        solved_h = finite ? h : 0; /* a longer step that was solved guesses the shorter one well */
        h *= finite && error > 1 ? jlt_larger(safety * jlt_inverse_root(error, 1.0 / 17), 0.3) : 0.5;
        stepper->rejected++;
        rejected = true;
    }

    double factor = jlt_smaller(safety * jlt_inverse_root(error, 1.0 / 17), rejected ? 1 : growth_max);
    const double proposed = fabs(h) * factor;
    stepper->h_next = !rejected && size < asked ? jlt_larger(proposed, asked) : proposed;
    stepper->h = h;
    memcpy(stepper->x_start, stepper->x, stride * sizeof *stepper->x);
    memcpy(stepper->f_start, stepper->f, stride * sizeof *stepper->f);
    for (unsigned c = 0; c < columns; c++) {
        const double move = h * self->trial[c * N] + stepper->x_low[c];
        stepper->x[c] = stepper->x_start[c] + move;
        stepper->x_low[c] = (stepper->x_start[c] - stepper->x[c]) + move;
    }
    memcpy(stepper->f, self->nodes.x, columns * sizeof *stepper->f);
    double *swap = self->legendre;
    self->legendre = self->trial;
    self->trial = swap;
    self->has_past = true;
    return JLT_OK;
}

static jlt_status start(jlt_stepper *stepper)
{
    gauss *self = stepper->state;
    self->has_past = false;
    if (!(stepper->h_next > 0)) {
        /* As for dop853, but cheaper: a first guess is only the start of a fast controller. */
        double size = 0, speed = 0;
        for (unsigned c = 0; c < stepper->columns; c++) {
            const double w = jlt_larger(fabs(stepper->x[c]), stepper->scale[c]);
            size = jlt_larger(size, fabs(stepper->x[c]) / w);
            speed = jlt_larger(speed, fabs(stepper->f[c]) / w);
        }
        stepper->h_next = jlt_smaller(size < 1e-5 || speed < 1e-5 ? 1e-3 : 0.1 * size / speed, stepper->max_step);
    }
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
    guess(self, stepper, self->legendre, 0, theta);
    const bool solved = solve(self, stepper, stepper->x_start, h);
    stepper->evaluations += N * self->sweeps;
    if (!solved) return JLT_ERR_NO_CONVERGENCE;
    expand(self, stepper, self->partial);
    for (unsigned c = 0; c < stepper->columns; c++) out[c] = stepper->x_start[c] + h * self->partial[c * N];
    return JLT_OK;
}

static double variation(const jlt_stepper *stepper, unsigned column)
{
    const gauss *self = stepper->state;
    double sum = 0;
    for (unsigned k = 0; k < N; k++) sum += fabs(self->legendre[column * N + k]);
    return fabs(stepper->h) * sum;
}

const jlt_method jlt_method_gauss = {
    .name = "gauss",
    .meaning = "Gauss-Legendre collocation of order 16, eight nodes at once by vectors (Hairer, Lubich and Wanner)",
    .order = 16,
    .dense_order = 8,
    .create = create,
    .destroy = destroy,
    .start = start,
    .step = step,
    .dense = dense,
    .partial = partial,
    .variation = variation,
};
