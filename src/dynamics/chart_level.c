#include "dynamics/chart_level.h"

#include <math.h>
#include <string.h>

#include "dynamics/linear.h"
#include "ext/eigen.h"

enum { M = JLT_INVARIANTS_MAX, ROUNDS = 60, HALVINGS = 8 };

/* Number of unknowns: the levels' states, and lifted roots. */
static unsigned unknowns(const jlt_chart *base) { return base->solved_count + base->roots; }

static const double met = 1e-13;     /* a level is met to this part of the size of its integral's terms: rounding */
static const double singular = 1e-13; /* singular values below this part of the largest count as 0, see correct */
static const double rounding = 1e-3; /* the part of the largest state of which `met` is the rounding */

/* Out: off, F - value of every level, (count,); sizes, of its terms, to first order, (count,); by_solved, gradients by the
 * unknowns, (count, count); by_all, unless NULL, by all states, (count, states). All terms may vanish, as those of v - sin(phi) on
 * level 0 at phi = 0: a size is at least what this part of the largest state, or of 1 if that is less, changes the level by.
 * Returns the largest |F - value|/size. */
static double look(const jlt_chart_level *self, double *off, double *sizes, double *by_solved, double *by_all, const double *x,
                   double part_of_largest)
{
    const unsigned n = self->base.states, count = unknowns(&self->base);
    double values[JLT_CHART_INTEGRALS_MAX], gradients[JLT_CHART_INTEGRALS_MAX * JLT_CHART_STATES_MAX], worst = 0, largest = 0;

    self->integrals.values(x, self->integrals.p, values);
    self->integrals.gradients(x, self->integrals.p, gradients);
    for (unsigned k = 0; k < n; k++) largest = fmax(largest, fabs(x[k]));
    for (unsigned i = 0; i < count; i++) {
        const jlt_level *level = &self->levels[i];
        const double *gradient = gradients + level->integral * n;
        double size = fabs(level->value);
        for (unsigned k = 0; k < n; k++)
            size = fmax(size, fabs(gradient[k]) * fmax(fabs(x[k]), part_of_largest * fmin(1, largest)));
        sizes[i] = size;
        off[i] = values[level->integral] - level->value;
        const double part = off[i] == 0 ? 0 : fabs(off[i]) / size;
        if (part > worst || isnan(part)) worst = part; /* and stays so */
        for (unsigned j = 0; j < count; j++) by_solved[i * count + j] = gradient[self->base.solved[j]];
        if (by_all != NULL) memcpy(by_all + i * n, gradient, n * sizeof *gradient);
    }
    return worst;
}

/* The matrix of gradients by the unknowns, its rows relative to the sizes of the levels' terms, and its columns divided by their
 * largest entries, effect, shape (count,), so that units do not make it look singular. */
static void scale_matrix(double *matrix, double *effect, const double *by_solved, const double *sizes, unsigned count)
{
    for (unsigned j = 0; j < count; j++) effect[j] = 0;
    for (unsigned i = 0; i < count; i++)
        for (unsigned j = 0; j < count; j++) {
            matrix[i * count + j] = by_solved[i * count + j] / (sizes[i] > 0 ? sizes[i] : 1);
            effect[j] = fmax(effect[j], fabs(matrix[i * count + j]));
        }
    for (unsigned i = 0; i < count; i++)
        for (unsigned j = 0; j < count; j++)
            if (effect[j] > 0) matrix[i * count + j] /= effect[j];
}

/* The unknowns' change for which the levels change by `off`, to first order. */
static jlt_status correct(double *change, const double *by_solved, const double *off, const double *sizes, unsigned count)
{
    double matrix[M * M] = { 0 }, right[M] = { 0 }, effect[M];

    for (unsigned i = 0; i < count; i++) right[i] = off[i] / (sizes[i] > 0 ? sizes[i] : 1);
    scale_matrix(matrix, effect, by_solved, sizes, count);
    JLT_PASS(jlt_eigen_least_squares(change, matrix, right, count, count, singular));
    for (unsigned j = 0; j < count; j++)
        if (effect[j] > 0) change[j] /= effect[j];
    return JLT_OK;
}

/* Newton's method for the unknowns in x, in place; each step is halved until the residual falls. */
static jlt_status iterate(const jlt_chart_level *self, double *x, double least)
{
    const unsigned count = unknowns(&self->base);
    double off[M], sizes[M], matrix[M * M], step[M], from[M], now = look(self, off, sizes, matrix, NULL, x, least), before;

    for (unsigned round = 0; round < ROUNDS && now > 0; round++) {
        double part = 1;
        unsigned halving;
        if (!isfinite(now) || correct(step, matrix, off, sizes, count) != JLT_OK) break;
        for (unsigned i = 0; i < count; i++) from[i] = x[self->base.solved[i]];
        before = now;
        for (halving = 0; halving < HALVINGS; halving++, part /= 2) {
            for (unsigned i = 0; i < count; i++) x[self->base.solved[i]] = from[i] - part * step[i];
            now = look(self, off, sizes, matrix, NULL, x, least);
            if (now < before) break;
        }
        if (halving < HALVINGS) continue;
        for (unsigned i = 0; i < count; i++) x[self->base.solved[i]] = from[i];
        now = before;
        break;
    }
    return now <= met ? JLT_OK : JLT_ERR_EMPTY;
}

/* iterate with sizes of the integrals' terms, which scale with units; if that fails, with sizes that are not 0 where all terms
 * vanish. */
static jlt_status solve(const jlt_chart_level *self, double *x)
{
    return iterate(self, x, 0) == JLT_OK ? JLT_OK : iterate(self, x, rounding);
}

/* dx/dq: unit rows for the coordinates; the unknowns change so as to keep the levels. */
static jlt_status tangent_of(const jlt_chart_level *self, double *tangent, const double *x)
{
    const unsigned n = self->base.states, d = self->base.dim, count = unknowns(&self->base);
    double off[M], sizes[M], matrix[M * M], gradients[M * JLT_CHART_STATES_MAX], column[M], solution[M];

    (void)look(self, off, sizes, matrix, gradients, x, 0);
    memset(tangent, 0, (size_t)n * d * sizeof *tangent);
    for (unsigned k = 0; k < d; k++) {
        tangent[self->free[k] * d + k] = 1;
        for (unsigned i = 0; i < count; i++) column[i] = -gradients[i * n + self->free[k]];
        JLT_PASS(correct(solution, matrix, column, sizes, count));
        for (unsigned i = 0; i < count; i++) tangent[self->base.solved[i] * d + k] = solution[i];
    }
    return JLT_OK;
}

/* Compute the lifted roots from the states before them. */
static void set_roots(const jlt_chart_level *self, double *x)
{
    const unsigned plain = self->base.states - self->base.roots;
    double all[JLT_CHART_STATES_MAX];

    if (self->base.roots == 0) return;
    self->descriptor->lifted(x, self->params, all);
    memcpy(x + plain, all + plain, self->base.roots * sizeof *x);
}

static jlt_status lift(const jlt_chart *base, double *x, double *tangent, const double *q)
{
    const jlt_chart_level *self = (const jlt_chart_level *)base;

    x[base->column] = base->level;
    for (unsigned k = 0; k < base->dim; k++) {
        if (!isfinite(q[k])) return JLT_ERR_NONFINITE;
        x[self->free[k]] = q[k];
    }
    for (unsigned i = 0; i < base->solved_count; i++) x[base->solved[i]] = self->levels[i].guess;
    set_roots(self, x);
    if (base->solved_count > 0) JLT_PASS(solve(self, x));
    if (!jlt_chart_holds(base, x)) return JLT_ERR_DOMAIN;
    if (tangent != NULL) JLT_PASS(tangent_of(self, tangent, x));
    return JLT_OK;
}

static void lower(const jlt_chart *base, double *q, double *slope, const double *x)
{
    const jlt_chart_level *self = (const jlt_chart_level *)base;

    if (slope != NULL) memset(slope, 0, (size_t)base->states * base->dim * sizeof *slope);
    for (unsigned k = 0; k < base->dim; k++) {
        q[k] = x[self->free[k]];
        if (slope != NULL) slope[k * base->states + self->free[k]] = 1;
    }
    jlt_chart_wrap(base, q);
}

/* The volume is dq dx_c dy, and dF = |det dF/dy| dy at fixed q and x_c: on the levels it is dq dx_c/det, up to sign. */
static double flux(const jlt_chart *base, const double *x, const double *f)
{
    double off[M], sizes[M], matrix[M * M];

    (void)look((const jlt_chart_level *)base, off, sizes, matrix, NULL, x, 0);
    return f[base->column] / jlt_linear_determinant(matrix, unknowns(base));
}

static bool is_solved(const jlt_chart *base, unsigned state)
{
    for (unsigned i = 0; i < unknowns(base); i++)
        if (base->solved[i] == state) return true;
    return false;
}

/* The side of the pole at which an orbit has ended. */
static int side(const jlt_chart *base, double *x)
{
    const jlt_chart_level *self = (const jlt_chart_level *)base;
    return jlt_chart_pole_side(base, self->descriptor, base->states - base->roots, x);
}

/* Whether two solutions for the same coordinates are one: rounding can cause their difference. It moves each level by a few `met`
 * of the size of its terms, and the unknowns accordingly, to first order. */
static bool are_one(const jlt_chart_level *self, const double *a, const double *b)
{
    static const double generous = 16;
    const unsigned count = unknowns(&self->base);
    double off[M], sizes[M], matrix[M * M], error[M], open[M] = { 0 };

    (void)look(self, off, sizes, matrix, NULL, a, rounding);
    for (unsigned j = 0; j < count; j++) {
        for (unsigned i = 0; i < count; i++) off[i] = i == j ? generous * met * sizes[j] : 0;
        if (correct(error, matrix, off, sizes, count) != JLT_OK) return false;
        for (unsigned i = 0; i < count; i++) open[i] += fabs(error[i]);
    }
    for (unsigned i = 0; i < count; i++) {
        const double left = a[self->base.solved[i]], right = b[self->base.solved[i]];
        if (!(fabs(left - right) <= open[i] + 1e-15 * fabs(left))) return false;
    }
    return true;
}

static bool follows(const jlt_chart *base, const double *x)
{
    static const double on_levels = 1e-6; /* relative; far above the methods' errors in the levels */
    const jlt_chart_level *self = (const jlt_chart_level *)base;
    double q[JLT_CHART_DIM_MAX], lifted[JLT_CHART_STATES_MAX], own[JLT_CHART_STATES_MAX], off[M], sizes[M], matrix[M * M];

    lower(base, q, NULL, x);
    if (lift(base, lifted, NULL, q) != JLT_OK) return false;
    memcpy(own, lifted, base->states * sizeof *x);
    /* Where an integral grows with an angle, a turn leads to another level, unless a turn of a solved state takes that back. */
    for (unsigned i = 0; i < unknowns(base); i++) {
        const unsigned state = base->solved[i];
        own[state] = self->turns[i] == 0 ? x[state] : lifted[state] + remainder(x[state] - lifted[state], self->turns[i]);
    }
    return look(self, off, sizes, matrix, NULL, own, 1) <= on_levels && solve(self, own) == JLT_OK && are_one(self, lifted, own);
}

jlt_status jlt_chart_level_init(jlt_chart_level *out, const jlt_chart *plane, const jlt_invariants *integrals,
                                const jlt_level *levels, unsigned count, const jlt_descriptor *descriptor, const double *params)
{
    const unsigned roots = plane->roots, solved = count + roots;
    unsigned k = 0, from = 0;

    if (solved == 0 || solved > M || solved >= plane->dim || integrals->count > JLT_CHART_INTEGRALS_MAX) return JLT_ERR_ARG;
    *out = (jlt_chart_level){ .base = *plane, .descriptor = descriptor, .params = params, .integrals = *integrals };
    out->base.roots = 0;
    out->base.solved_count = 0;
    for (unsigned i = 0; i < count; i++) {
        if (levels[i].integral >= integrals->count || levels[i].state >= plane->states) return JLT_ERR_ARG;
        if (levels[i].state == plane->column || is_solved(&out->base, levels[i].state)) return JLT_ERR_ARG;
        for (unsigned j = 0; j < i; j++)
            if (levels[j].integral == levels[i].integral) return JLT_ERR_ARG;
        out->levels[i] = levels[i];
        out->base.solved[out->base.solved_count++] = levels[i].state;
    }
    for (unsigned i = 0; i < roots; i++) {
        const unsigned state = plane->states - roots + i;
        out->levels[count + i] = (jlt_level){ .integral = integrals->count - roots + i, .state = state };
        out->base.solved[count + i] = state;
    }
    out->base.roots = roots;
    out->base.dim = plane->dim - solved;
    for (unsigned i = 0; i < plane->states; i++) {
        if (i == plane->column) continue;
        if (!is_solved(&out->base, i)) {
            out->free[k] = i;
            out->base.names[k] = plane->names[from];
            out->base.period[k] = plane->period[from];
            out->base.mirror[k++] = plane->mirror[from];
        } else if (plane->mirror[from] < 0) {
            out->base.reversible = false;
        }
        from++;
    }
    if (out->base.dim == 1) out->base.names[1] = "";
    out->base.lift = lift;
    out->base.lower = lower;
    out->base.flux = flux;
    out->base.side = roots > 0 ? side : NULL;
    out->base.follows = count > 0 ? follows : NULL;
    return JLT_OK;
}

bool jlt_chart_level_determines(const jlt_chart_level *self, bool *known, const double *x)
{
    static const double independent = 1e-10; /* of numbers of the order of 1, which rounding changes by some 1e-15 */
    const unsigned count = unknowns(&self->base);
    double off[M], sizes[M], by_solved[M * M], matrix[M * M], effect[M];

    (void)look(self, off, sizes, by_solved, NULL, x, 0);
    for (unsigned i = 0; i < count; i++) { /* the sizes of levels elsewhere tell nothing here */
        sizes[i] = 0;
        for (unsigned j = 0; j < count; j++) sizes[i] = fmax(sizes[i], fabs(by_solved[i * count + j]));
    }
    scale_matrix(matrix, effect, by_solved, sizes, count);
    const double determinant = jlt_linear_determinant(matrix, count);
    *known |= isfinite(determinant);
    return fabs(determinant) > independent;
}
