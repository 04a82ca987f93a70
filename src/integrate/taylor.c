/* A. Jorba, M. Zou, A software package for the numerical integration of ODEs by means of high-order Taylor methods,
 * Experimental Mathematics 14 (2005), with this analysis.
 *
 * Coefficients of a solution with radius of convergence rho fall like |c_k| ~ C rho^-k. A step h = q rho leaves out
 *     sum over k > p of |c_k| h^k  ~  |c_p| h^p q/(1 - q).
 * A jet costs p^2 to leading order, so cost per time is p^2/(rho q) with q^p = eps (relative to C): with L = -ln eps,
 * minimizing p^2 exp(L/p) gives p = L/2 and q = exp(-2) whatever rho. One order more pays for C above the scale.
 * With q = exp(-2) the left-out part is 0.1565 |c_p| h^p, so the last term may be as large as eps/0.1565 = 6.39 eps, the one
 * before it exp(2) times that, and the third from the end exp(4) times: each gives a bound for h, and the least is taken,
 * so that a coefficient that happens to vanish does no harm.
 *
 * What is left out is no estimate with a margin, as in an embedded pair, but the error itself, and the errors of the steps
 * add up: an eighth of the tolerance is given to each, which shortens them by 8^(-1/p), an eighth at p = 15. */
#include "integrate/taylor.h"

#include <stddef.h>
#include <stdlib.h>

#include "core/memory.h"
#include "integrate/step_control.h"

typedef struct {
    unsigned order, usable; /* of the jet; the order of the step's polynomial, lower where doubles do not hold the coefficients */
    double *jet;     /* (order + 1, columns) */
    double *move;    /* (columns,) */
    double *inside;  /* (2, PARTS, dim): states and slopes within the step */
} taylor;

enum { PARTS = 8 }; /* of a step, at whose ends the polynomial is compared with the field */

unsigned jlt_taylor_order(double tolerance)
{
    const double order = ceil(-0.5 * log(tolerance)) + 1;
    return order < 4 ? 4 : order > JLT_JET_ORDER_MAX ? JLT_JET_ORDER_MAX : (unsigned)order;
}

static jlt_status create(jlt_stepper *stepper)
{
    taylor *self = jlt_memory_array(1, sizeof *self);
    stepper->state = self;
    if (self == NULL) return JLT_ERR_NOMEM;
    self->order = jlt_taylor_order(stepper->tolerance);
    const size_t rows = self->order + 2;
    self->jet = jlt_memory_array(rows * stepper->columns + 2 * PARTS * (size_t)stepper->field->dim, sizeof *self->jet);
    if (self->jet == NULL) return JLT_ERR_NOMEM;
    self->move = self->jet + (rows - 1) * stepper->columns;
    self->inside = self->jet + rows * stepper->columns;
    return JLT_OK;
}

static void destroy(jlt_stepper *stepper)
{
    taylor *self = stepper->state;
    if (self == NULL) return;
    free(self->jet);
    free(self);
}

static jlt_status start(jlt_stepper *stepper)
{
    if (!(stepper->h_next > 0)) stepper->h_next = INFINITY; /* the jet at the point decides */
    return JLT_OK;
}

/* Sizes of the jet's coefficients, each relative to the states', and the order up to which doubles hold them: those of a state fall
 * or grow as powers of its rate, and one that underflows would pass for the end of a polynomial. Those of lost states (edge.h) are
 * errors, and may underflow. */
static unsigned measure(double sizes[JLT_JET_ORDER_MAX + 1], const taylor *self, const jlt_stepper *stepper)
{
    static const double most = 1e290, least = 0x1p-1018; /* 16 times the least double that has all digits */
    const unsigned columns = stepper->columns;

    for (unsigned k = 0; k <= self->order; k++) {
        bool underflows = false, is_held = false;
        sizes[k] = 0;
        for (unsigned i = 0; i < columns; i++) {
            const double *at = self->jet + k * (size_t)columns + i;
            const double coefficient = fabs(*at);
            const double size = coefficient / jlt_larger(fabs(stepper->x[i]), stepper->scale[i]);
            if (k > 0 && !(coefficient < most && size < most)) return k - 1;
            sizes[k] = jlt_larger(sizes[k], size);
            is_held |= coefficient >= least;
            if (k < 2 || jlt_state_set_has(&stepper->lost, i)) continue;
            const double last = fabs(at[-(ptrdiff_t)columns]), before = fabs(at[-2 * (ptrdiff_t)columns]);
            underflows |= last > 0 && last / before < least / last;
        }
        if (underflows && !is_held) return k - 1;
    }
    return self->order;
}

/* Longest step that each of the last three terms allows; NaN where doubles do not hold enough of the jet for steps of any use. */
static double longest_step(taylor *self, const jlt_stepper *stepper)
{
    static const double allowance[3] = { 6.39 / 8, 47.2 / 8, 349.0 / 8 };
    double longest = INFINITY, sizes[JLT_JET_ORDER_MAX + 1];

    self->usable = measure(sizes, self, stepper);
    if (self->usable < 5 && self->usable < self->order) return NAN;
    for (unsigned back = 0; back < 3; back++) {
        const unsigned k = self->usable - back;
        const double over = sizes[k] / (allowance[back] * stepper->tolerance);
        if (over > 0) longest = jlt_smaller(longest, jlt_inverse_root(over, 1.0 / k));
    }
    return longest;
}

/* Make the step's polynomial, and the increment of the point. Returns false if that is not finite. */
static bool expand(taylor *self, jlt_stepper *stepper, double h)
{
    const unsigned columns = stepper->columns, stride = stepper->stride, dim = stepper->field->dim;
    double power = 1;

    for (unsigned k = 0; k <= self->usable; k++) {
        for (unsigned i = 0; i < columns; i++) {
            const double coefficient = self->jet[k * (size_t)columns + i];
            stepper->dense[k * (size_t)stride + i] = coefficient != 0 ? power * coefficient : 0; /* at rest h^k may be infinite */
        }
        power *= h;
    }
    if (columns > dim) stepper->dense[dim] = stepper->x[dim];
    stepper->dense_degree = self->usable;
    for (unsigned i = 0; i < columns; i++) {
        double move = 0; /* small terms first */
        for (unsigned k = self->usable; k >= 1; k--) move += stepper->dense[k * (size_t)stride + i];
        self->move[i] = move + stepper->x_low[i];
        if (!isfinite(self->move[i])) return false;
    }
    return true;
}

/* Whether a condition rises at the step's end by the polynomial's slope, but falls by the field there, so fast that it would come
 * to zero within a step of this length. */
static bool turned_at_edge(const jlt_stepper *stepper, const double *end, const double *slope, const double *f, double h)
{
    const jlt_domain *domain = &stepper->field->domain;
    double value[JLT_REGION_CONDITIONS_MAX];

    if (domain->conditions == 0) return false;
    domain->values(end, domain->p, value);
    domain->gradients(end, domain->p, stepper->gradients);
    for (unsigned k = 0; k < domain->conditions; k++) {
        const double *gradient = stepper->gradients + (size_t)k * domain->states;
        if (jlt_along(gradient, slope, domain->states) > 0 && value[k] < -h * jlt_along(gradient, f, domain->states)) return true;
    }
    return false;
}

/* By how much the polynomial's slope may miss the field, relative to the states. The truncation error of the slope is the order
 * times that of the state; a miss a hundred times as large has another cause. */
static double slope_allowance(const taylor *self, const jlt_stepper *stepper)
{
    return 100 * self->usable * jlt_larger(stepper->tolerance, 1e-15);
}

/* Whether the polynomial still obeys the field where it ends. A series runs smoothly through a pole, where the field's root would
 * change its sign, and beyond it obeys the field no more. Where the end is nearer to an interval's end than the allowance, the miss
 * is too small to tell, and the signs decide: a step whose slope is opposite to the field's went through, and is halved. */
static bool follows_field(const taylor *self, const jlt_stepper *stepper, double h)
{
    double end[JLT_FIELD_DIM_MAX], f[JLT_FIELD_DIM_MAX], slopes[JLT_FIELD_DIM_MAX];
    const unsigned dim = stepper->field->dim;
    const jlt_domain *domain = &stepper->field->domain;
    const double allowed = slope_allowance(self, stepper);

    memcpy(end, stepper->x, dim * sizeof *end);
    for (unsigned i = 0; i < dim; i++) end[i] += self->move[i];
    stepper->field->call(end, stepper->field->p, f);
    for (unsigned i = 0; i < dim; i++) {
        double slope = 0;
        for (unsigned k = self->usable; k >= 1; k--) slope += k * stepper->dense[k * (size_t)stepper->stride + i];
        const double size = jlt_larger(jlt_larger(fabs(stepper->x[i]), fabs(end[i])), stepper->scale[i]);
        slopes[i] = slope;
        if (!(fabs(slope - h * f[i]) <= allowed * size)) return false;
        if (domain->intervals == NULL || i >= domain->states) continue;
        const double left = jlt_smaller(end[i] - domain->intervals[i].low, domain->intervals[i].high - end[i]);
        if (slope * (h * f[i]) < 0 && left < allowed * size) return false;
    }
    return !turned_at_edge(stepper, end, slopes, f, h);
}

/* Whether the polynomial obeys the field within the step, between its ends. A series does not show what is yet too small at its
 * start, as a pulse that comes and goes within the step. */
static bool follows_inside(const taylor *self, const jlt_stepper *stepper, double h)
{
    const size_t dim = stepper->field->dim;
    double f[JLT_FIELD_DIM_MAX], *x = self->inside, *slopes = x + PARTS * dim;
    const double allowed = slope_allowance(self, stepper);

    for (unsigned i = 0; i < dim; i++) {
        double move[PARTS] = { 0 }, slope[PARTS] = { 0 };
        for (unsigned k = self->usable; k >= 1; k--) {
            const double term = stepper->dense[k * (size_t)stepper->stride + i], rate = k * term;
            for (unsigned l = 0; l < PARTS; l++) move[l] = (move[l] + term) * (l * (1.0 / PARTS));
            for (unsigned l = 0; l < PARTS; l++) slope[l] = slope[l] * (l * (1.0 / PARTS)) + rate;
        }
        for (unsigned l = 0; l < PARTS; l++) x[l * dim + i] = stepper->x[i] + move[l];
        for (unsigned l = 0; l < PARTS; l++) slopes[l * dim + i] = slope[l];
    }
    for (unsigned l = 1; l < PARTS; l++) {
        stepper->field->call(x + l * dim, stepper->field->p, f);
        for (unsigned i = 0; i < dim; i++) {
            const double size = jlt_larger(jlt_larger(fabs(stepper->x[i]), fabs(x[l * dim + i])), stepper->scale[i]);
            if (!(fabs(slopes[l * dim + i] - h * f[i]) <= allowed * size)) return false;
        }
    }
    return true;
}

static jlt_status step(jlt_stepper *stepper, double limit)
{
    taylor *self = stepper->state;
    const jlt_field *field = stepper->field;
    const unsigned columns = stepper->columns;

    field->jet(stepper->x, field->p, self->order, self->jet);
    stepper->evaluations++;
    const double longest = longest_step(self, stepper);
    if (isnan(longest)) return JLT_ERR_NONFINITE;
    /* At rest, and where the motion is a polynomial in time, any step is right: those that grow show what happens meanwhile. */
    const double any = stepper->h_next < INFINITY ? 4 * stepper->h_next : 1;
    double size = jlt_smaller(longest < INFINITY ? longest : any, jlt_smaller(stepper->max_step, limit));
    double h = stepper->direction * size;
    if (jlt_step_vanishes(stepper->tau, h)) return JLT_ERR_NO_PROGRESS;

    if (!expand(self, stepper, h)) return JLT_ERR_NONFINITE;
    while (!follows_field(self, stepper, h) || !follows_inside(self, stepper, h)) {
        h = stepper->direction * (size /= 2);
        if (jlt_step_vanishes(stepper->tau, h)) return JLT_ERR_NO_PROGRESS;
        if (!expand(self, stepper, h)) return JLT_ERR_NONFINITE;
    }

    stepper->h = h;
    for (unsigned i = 0; i < columns; i++) {
        const double from = stepper->x[i];
        stepper->x_start[i] = from;
        stepper->f_start[i] = stepper->f[i];
        stepper->x[i] = from + self->move[i];
        stepper->x_low[i] = (from - stepper->x[i]) + self->move[i];
    }
    jlt_field_rates(field, stepper->f, stepper->x);
    stepper->h_next = size;
    return JLT_OK;
}

static jlt_status dense(jlt_stepper *stepper)
{
    stepper->dense_error = 10 * stepper->tolerance; /* the step is its own polynomial */
    return JLT_OK;
}

static jlt_status partial(jlt_stepper *stepper, double theta, double *out)
{
    const jlt_status st = jlt_stepper_dense(stepper);
    if (st == JLT_OK) jlt_stepper_values(stepper, theta, out);
    return st;
}

static double variation(const jlt_stepper *stepper, unsigned column)
{
    double sum = 0;
    for (unsigned k = 1; k <= stepper->dense_degree; k++)
        sum += k * fabs(stepper->dense[k * (size_t)stepper->stride + column]);
    return sum;
}

const jlt_method jlt_method_taylor = {
    .name = "taylor",
    .meaning = "Taylor series from generated jets, order by tolerance (after Jorba and Zou)",
    .share = 1.0 / 16,
    .needs_jet = true,
    .create = create,
    .destroy = destroy,
    .start = start,
    .step = step,
    .dense = dense,
    .partial = partial,
    .variation = variation,
};
