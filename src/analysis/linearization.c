#include "analysis/linearization.h"

#include "analysis/charpoly.h"
#include "analysis/family.h"
#include "kernel/descriptor.h"
#include "kernel/instance.h"
#include "kernel/kernel.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { SIZE = JLT_LINEARIZATION_SIZE_MAX, REVERSORS_MAX = 8 };

static const double roundoff = DBL_EPSILON / 2;

/* An eigenvalue whose real part may be zero is taken to be on the imaginary axis if the error of that part is at most this part of
 * its modulus; otherwise its side stays undecided. */
static const double on_axis = 1e-6;

const char *jlt_linearization_verdict(jlt_verdict verdict)
{
    static const char *const texts[] = { "stable", "unstable", "centre", "not settled" };
    return (unsigned)verdict < sizeof texts / sizeof *texts ? texts[verdict] : "unknown verdict";
}

const char *jlt_linearization_motion(jlt_motion motion)
{
    static const char *const texts[] = { "not settled", "asymptotically stable", "stable", "unstable" };
    return (unsigned)motion < sizeof texts / sizeof *texts ? texts[motion] : "unknown motion";
}

/* The least change of x_j that exceeds, in some component of the field, the effect of rounding all states. It matters for a state
 * that is zero, or nearly so, while others are rounded. */
static double visible_move(const jlt_linearization *r, const double *x, size_t j)
{
    double least = INFINITY;

    for (size_t i = 0; i < r->n; i++) {
        const double slope = fabs(r->jacobian[i * r->n + j]);
        double noise = 0.0;
        for (size_t k = 0; k < r->n; k++) noise += fabs(r->jacobian[i * r->n + k] * x[k]);
        if (slope > 0.0) least = fmin(least, roundoff * noise / slope);
    }
    return isfinite(least) ? least : 0.0;
}

/* How far from x_j an equilibrium may lie for x to count as one. */
static double reach_of(const jlt_linearization *r, const double *x, size_t j)
{
    const jlt_quantity *state = &r->descriptor->states[j];
    const double room = fmin(x[j] - state->low, state->high - x[j]), size = fmin(fabs(x[j]), room);
    const double rounding = 4 * fmax(roundoff * fabs(x[j]), visible_move(r, x, j));

    return fmin(fmax(JLT_LINEARIZATION_TOLERANCE * size, rounding), 1e-3 * room);
}

/* Evaluate the gradients of the integrals that are proved; where one of them has a pole, as y/x has at x = 0, none is used. */
static jlt_status measure_gradients(jlt_linearization *r, const jlt_instance *instance, const double *x)
{
    const jlt_descriptor *d = r->descriptor;
    double gradients[SIZE * SIZE];

    r->integrals = 0;
    if (d->integral_gradients.call == NULL || d->integral_count > SIZE) return JLT_OK;
    const jlt_status st = jlt_instance_gradients(instance, gradients, x);
    if (st != JLT_OK) return st == JLT_ERR_DOMAIN || st == JLT_ERR_NONFINITE ? JLT_OK : st;
    for (unsigned k = 0; k < d->integral_count; k++) {
        if (!jlt_descriptor_proves(d, "integral", d->integrals[k].name)) continue;
        memcpy(r->gradients + r->integrals * r->n, gradients + k * r->n, r->n * sizeof *gradients);
        r->held[r->integrals++] = d->integrals[k];
    }
    return JLT_OK;
}

/* Compare the field's sizes with its changes over the states' reach: moved, shape (n,), the sum over j of |df_i/dx_j| reach_j. */
static void compare(jlt_linearization *r, const double *sizes, const double *moved)
{
    r->residual = r->residual_ratio = 0.0;
    for (size_t i = 0; i < r->n; i++) {
        const double size = moved[i] / JLT_LINEARIZATION_TOLERANCE;
        r->residual = fmax(r->residual, fabs(r->f[i]));
        if (sizes[i] > 0.0) r->residual_ratio = fmax(r->residual_ratio, size > 0.0 ? sizes[i] / size : INFINITY);
    }
}

/* The slopes df_i/dx_j with x_j moved: shape (n,). They are infinite where there are none. */
static jlt_status slopes_beside(double *slopes, const jlt_linearization *r, const jlt_instance *instance, const double *x, size_t j,
                                double move)
{
    const size_t n = r->n;
    double there[SIZE], jacobian[SIZE * SIZE];

    memcpy(there, x, n * sizeof *there);
    there[j] += move;
    const jlt_status st = jlt_instance_jacobian(instance, jacobian, there);
    for (size_t i = 0; i < n; i++) slopes[i] = st == JLT_OK ? jacobian[i * n + j] : INFINITY;
    return st == JLT_ERR_DOMAIN || st == JLT_ERR_NONFINITE ? JLT_OK : st;
}

/* How much the slopes by x_j may change within a reach, shape (n,): by a third, or, as near a multiple root, by 128 roundings of
 * those at x_j (1 +- 1/8) if that is more. */
static jlt_status bends_allowed(double *bends, const jlt_linearization *r, const jlt_instance *instance, const double *x, size_t j)
{
    double slopes[SIZE];

    for (size_t i = 0; i < r->n; i++) bends[i] = fabs(r->jacobian[i * r->n + j]) / 3;
    for (int side = -1; side <= 1; side += 2) {
        JLT_PASS(slopes_beside(slopes, r, instance, x, j, side * x[j] / 8));
        for (size_t i = 0; i < r->n; i++)
            if (isfinite(slopes[i])) bends[i] = fmax(bends[i], 128 * roundoff * fabs(slopes[i]));
    }
    return JLT_OK;
}

/* The slopes at x hold for states within reach only as far as they hardly change: sin x is not linear over a reach of 10. Shorten
 * each slope's reach, by factors of 8, to where bends_allowed holds. sizes: as measure_residual takes them. */
static jlt_status keep_straight(jlt_linearization *r, const jlt_instance *instance, const double *x, const double *sizes)
{
    enum { LEVELS = 5 };
    const size_t n = r->n;
    double moved[SIZE] = { 0 }, slopes[SIZE], bends[SIZE];

    for (size_t j = 0; j < n; j++) {
        double move = ldexp(r->reach[j], -3 * (LEVELS - 1)), reach[SIZE] = { 0 }, farthest = 0.0;
        bool straight[SIZE];
        for (size_t i = 0; i < n; i++) straight[i] = r->jacobian[i * n + j] != 0.0;
        JLT_PASS(bends_allowed(bends, r, instance, x, j));
        for (int level = 0; level < LEVELS; level++, move *= 8) {
            for (int side = -1; side <= 1; side += 2) {
                JLT_PASS(slopes_beside(slopes, r, instance, x, j, side * move));
                for (size_t i = 0; i < n; i++)
                    straight[i] = straight[i] && fabs(slopes[i] - r->jacobian[i * n + j]) <= bends[i];
            }
            for (size_t i = 0; i < n; i++)
                if (straight[i]) reach[i] = farthest = move;
        }
        for (size_t i = 0; i < n; i++) moved[i] += sizes[n + i * n + j] * reach[i];
        r->reach[j] = farthest;
    }
    compare(r, sizes, moved);
    return JLT_OK;
}

/* exact: sizes of the field, shape (n,), and of the Jacobian, shape (n, n), at exact inputs; NULL: those in doubles. */
static jlt_status measure_residual(jlt_linearization *r, const jlt_instance *instance, const double *x, const double *exact)
{
    const size_t n = instance->descriptor->state_count;
    double moved[SIZE] = { 0 }, sizes[SIZE + SIZE * SIZE];

    r->descriptor = instance->descriptor;
    r->n = n;
    JLT_PASS(jlt_instance_rhs(instance, r->f, x));
    JLT_PASS(jlt_instance_jacobian(instance, r->jacobian, x));
    for (size_t i = 0; i < n * n; i++) r->jacobian[i] += 0.0; /* -0 becomes 0 */
    JLT_PASS(measure_gradients(r, instance, x));
    for (size_t i = 0; exact == NULL && i < n + n * n; i++) sizes[i] = fabs(i < n ? r->f[i] : r->jacobian[i - n]);
    if (exact == NULL) exact = sizes;
    for (size_t j = 0; j < n; j++) r->reach[j] = reach_of(r, x, j);
    for (size_t k = 0; k < n * n; k++) moved[k / n] += exact[n + k] * r->reach[k % n];
    compare(r, exact, moved);
    const bool is_near = r->residual_ratio > 0.0 && r->residual_ratio <= JLT_LINEARIZATION_TOLERANCE;
    return is_near ? keep_straight(r, instance, x, exact) : JLT_OK;
}

static jlt_status bind(jlt_instance **instance, const jlt_descriptor *descriptor, const double *params)
{
    *instance = NULL;
    if (descriptor == NULL) return JLT_ERR_ARG;
    const jlt_descriptor *special = jlt_descriptor_choose(descriptor, NULL, NULL, params);
    if (descriptor->state_count > SIZE || descriptor->state_count == 0) return JLT_ERR_UNSUPPORTED;
    return jlt_instance_create(instance, special == NULL ? descriptor : special, params);
}

jlt_status jlt_linearization_residual(jlt_linearization *result, const jlt_descriptor *descriptor, const double *params,
                                      const double *x)
{
    jlt_instance *instance;
    jlt_status st = bind(&instance, descriptor, params);

    if (st == JLT_OK) st = measure_residual(result, instance, x, NULL);
    jlt_instance_destroy(instance);
    return st;
}

static jlt_status polynomial(jlt_linearization *r, const double *error)
{
    const size_t n = r->n;
    double majorant[SIZE * SIZE], scale[SIZE + 1];

    for (size_t i = 0; i < n * n; i++)
        majorant[i] = error == NULL ? 4 * fabs(r->jacobian[i]) : fmax(fabs(r->jacobian[i]), error[i] / roundoff);
    JLT_PASS(jlt_charpoly_faddeev_leverrier(r->charpoly, scale, r->jacobian, majorant, n));
    for (size_t k = 0; k <= n; k++) {
        r->charpoly_error[k] = (double)(k * (n + 3)) * roundoff * scale[k];
        if (k > r->eigen.kept) r->charpoly[k] = r->charpoly_error[k] = 0.0;
    }
    return JLT_OK;
}

static jlt_status formulas(jlt_linearization *r, const jlt_descriptor *general, const double *params, const double *x)
{
    const size_t n = r->n;
    double on[SIZE];

    r->trace_formula = NAN;
    for (size_t k = 0; k <= n; k++) r->charpoly_formula[k] = NAN;
    r->family = jlt_family_of(general, params, x);
    if (r->family == NULL) return JLT_OK;
    jlt_family_turn_back(on, r->family, general, params, x);
    if (r->family->trace != NULL)
        JLT_PASS(jlt_kernel_eval_function(&r->trace_formula, r->family->trace, 1, on, n, params, general->param_count));
    if (r->family->charpoly != NULL) {
        double c[SIZE + 1];
        JLT_PASS(jlt_kernel_eval_function(c, r->family->charpoly, n + 1, on, n, params, general->param_count));
        for (size_t k = 0; k <= n; k++) r->charpoly_formula[k] = k == 0 ? 1.0 : c[k] / c[0];
    }
    return JLT_OK;
}

/* Mark the eigenvalues as unknown: doubles do not determine them. */
static void leave_open(jlt_deflation *eigen, size_t n)
{
    *eigen = (jlt_deflation){ .n = n, .kept = n, .doubtful_zero = 1, .arpack_note = "no eigenvalues to compare with" };
    eigen->lapack_difference = eigen->plain_difference = eigen->arpack_difference = NAN;
    for (size_t i = 0; i < n; i++) eigen->values[i] = (jlt_eigenvalue){ NAN, NAN, NAN, INFINITY, -1 };
}

/* Whether the eigenvalue may be multiple within its error; doubles do not tell how many eigenvectors it then has. */
static bool multiple(const jlt_deflation *eigen, size_t which)
{
    const jlt_eigenvalue *value = &eigen->values[which];

    for (size_t i = 0; i < eigen->n; i++) {
        const jlt_eigenvalue *other = &eigen->values[i];
        if (i != which && hypot(value->re - other->re, value->im - other->im) <= value->error + other->error) return true;
    }
    return false;
}

static void judge(jlt_linearization *r, const double *error)
{
    const size_t n = r->n;
    bool negative = true, moves = false, open = r->eigen.doubtful_zero, growing = false;

    r->precision = DBL_MANT_DIG;
    r->trace_error = 0.0;
    for (size_t i = 0; i < n; i++)
        r->trace_error += error == NULL ? 4 * roundoff * fabs(r->jacobian[i * n + i]) : error[i * n + i];
    r->trace_error += 2 * (double)n * roundoff * fabs(r->trace);
    for (size_t i = 0; i < n; i++) {
        const jlt_eigenvalue *value = &r->eigen.values[i];
        const double size = hypot(value->re, value->im);
        if (value->source >= 0 || !(size > value->error)) continue;
        moves = true;
        /* The real part of a conjugate pair is half the trace, if there are no other eigenvalues: use the trace's error. */
        const double slack = value->im != 0.0 && r->eigen.kept == 2 ? fmin(value->error, r->trace_error) : value->error;
        growing = growing || value->re > slack;
        negative = negative && value->re < -slack;
        if (fabs(value->re) <= slack) open = open || slack > on_axis * size || multiple(&r->eigen, i);
    }
    r->obstructs = fabs(r->trace) > r->trace_error;
    if (growing || r->eigen.defective_zero) r->verdict = JLT_UNSTABLE;
    else if (open) r->verdict = JLT_UNDECIDED;
    else r->verdict = moves && negative ? JLT_STABLE : JLT_CENTRE;
}

/* Fill all but polynomial, eigenvalues and verdict. */
static jlt_status place(jlt_linearization *r, const jlt_instance *instance, const jlt_descriptor *general, const double *params,
                        const double *x, const double *exact)
{
    JLT_PASS(measure_residual(r, instance, x, exact));
    if (r->residual_ratio > JLT_LINEARIZATION_TOLERANCE) return JLT_ERR_EMPTY;
    for (size_t i = 0; i < r->integrals; i++) r->sources[i] = r->held[i].name;
    JLT_PASS(jlt_instance_divergence(instance, &r->trace, x));
    return formulas(r, general, params, x);
}

jlt_status jlt_linearization_place(jlt_linearization *result, const jlt_descriptor *descriptor, const double *params,
                                   const double *x)
{
    jlt_instance *instance;
    jlt_status st;

    memset(result, 0, sizeof *result);
    JLT_TRY(bind(&instance, descriptor, params));
    JLT_TRY(place(result, instance, descriptor, params, x, NULL));
    leave_open(&result->eigen, result->n);
    result->verdict = JLT_UNDECIDED;
done:
    jlt_instance_destroy(instance);
    return st;
}

jlt_status jlt_linearization_compute(jlt_linearization *result, const jlt_descriptor *descriptor, const double *params,
                                     const double *x, const double *exact, const double *jacobian_error,
                                     const double *gradient_error)
{
    jlt_instance *instance;
    jlt_status st;

    memset(result, 0, sizeof *result);
    JLT_TRY(bind(&instance, descriptor, params));
    JLT_TRY(place(result, instance, descriptor, params, x, exact));
    st = jlt_deflation_compute(&result->eigen, result->jacobian, jacobian_error, result->n, result->gradients, gradient_error,
                               result->integrals);
    if (st == JLT_ERR_NO_CONVERGENCE) leave_open(&result->eigen, result->n);
    else if (st != JLT_OK) goto done;
    JLT_TRY(polynomial(result, jacobian_error));
    judge(result, jacobian_error);
done:
    jlt_instance_destroy(instance);
    return st;
}

/* The signs of the proved reversors; returns their number. */
static size_t reversors_of(const signed char **signs, const jlt_descriptor *d)
{
    size_t count = 0;

    for (unsigned i = 0; i < d->reversor_count && count < REVERSORS_MAX; i++)
        if (d->claims[d->reversors[i].claim].verdict == JLT_PROVED) signs[count++] = d->reversors[i].signs;
    return count;
}

static void take_values(jlt_deflation *eigen, const jlt_ball_spectrum *s)
{
    eigen->kept = s->n - s->attributed;
    for (size_t i = 0; i < s->zeros; i++) {
        const bool forced = i < s->attributed;
        eigen->values[i] = (jlt_eigenvalue){ 0.0, 0.0, !forced && s->defective ? INFINITY : NAN, forced || s->counted ? 0.0 : NAN,
                                             forced ? s->source[i] : -1 };
    }
    for (size_t i = s->zeros; i < s->n; i++) {
        const jlt_ball_eigenvalue *value = &s->values[i - s->zeros];
        eigen->values[i] = (jlt_eigenvalue){ value->re, value->im, value->condition, value->error, -1 };
    }
}

static bool is_zero(const jlt_ball_value *x)
{
    if (x->fraction == NULL) return !(x->value < 0.0) && !(x->value > 0.0);
    const char rest = x->fraction[strspn(x->fraction, "-0")];
    return rest == '\0' || rest == '/';
}

/* Whether, of two states, a reversor changes the sign of exactly one, and that one is zero. */
static bool is_mirrored(const jlt_ball_question *q, size_t n)
{
    bool mirrored = false;

    for (size_t k = 0; n == 2 && k < q->reversor_count; k++)
        for (size_t i = 0; i < 2; i++)
            mirrored = mirrored || (q->reversors[k][i] < 0 && q->reversors[k][1 - i] > 0 && is_zero(&q->states[i]));
    return mirrored;
}

static jlt_motion motion_of(const jlt_ball_spectrum *s, const jlt_ball_question *q)
{
    if (!s->proved) return JLT_MOTION_OPEN;
    if (s->expelling) return JLT_MOTION_UNSTABLE;
    if (s->growing || s->defective) return JLT_MOTION_OPEN;
    if (s->decaying) return s->zeros == 0 ? JLT_MOTION_ATTRACTED : s->zeros == s->attributed ? JLT_MOTION_STABLE : JLT_MOTION_OPEN;
    return s->zeros == 0 && is_mirrored(q, s->n) ? JLT_MOTION_STABLE : JLT_MOTION_OPEN;
}

jlt_status jlt_linearization_enclose(jlt_linearization *result, const jlt_descriptor *descriptor,
                                     const jlt_ball_value *params, const jlt_ball_value *x, struct jlt_exact_matrix *exact,
                                     long digits)
{
    const signed char *signs[REVERSORS_MAX];
    const jlt_ball_question question = {
        .table = descriptor->balls, .params = params, .states = x, .reach = result->reach, .integrals = result->sources,
        .integral_count = result->integrals, .reversors = signs, .reversor_count = reversors_of(signs, descriptor),
        .exact = exact, .digits = digits
    };
    jlt_ball_spectrum s;

    JLT_PASS(jlt_ball_spectrum_compute(&s, &question));
    memcpy(result->jacobian, s.jacobian, s.n * s.n * sizeof *s.jacobian);
    memcpy(result->charpoly, s.charpoly, (s.n + 1) * sizeof *s.charpoly);
    memcpy(result->charpoly_error, s.charpoly_error, (s.n + 1) * sizeof *s.charpoly_error);
    result->trace = s.trace;
    result->trace_error = s.trace_error;
    result->obstructs = fabs(s.trace) > s.trace_error;
    result->precision = s.precision;
    result->texts = s.texts;
    result->eigen.defective_zero = s.defective;
    result->eigen.doubtful_zero = 0;
    result->exists = s.exists;
    result->proved = s.proved;
    result->sure = s.sure;
    if (!s.proved) result->verdict = JLT_UNDECIDED;
    else if (s.growing || s.defective) result->verdict = JLT_UNSTABLE;
    else result->verdict = s.decaying ? JLT_STABLE : JLT_CENTRE;
    result->motion = motion_of(&s, &question);
    if (s.rooted) take_values(&result->eigen, &s);
    return JLT_OK;
}
