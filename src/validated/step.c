#include "validated/step.h"

#include <math.h>
#include <stdlib.h>

enum { PIECES = 16, FINEST = PIECES << 20 }; /* parts of a step over which conditions are enclosed, at first and at most */

struct jlt_step {
    const jlt_formulas *of;
    jlt_rough_accuracy accuracy;
    arb_ptr params;
    jlt_rough around;
    jlt_jets *point, *plain;                /* jets over the midpoint; jets of order 0 */
    arb_ptr x;                              /* (dim,): midpoint or hull of the set */
    arb_ptr V;                              /* (dim, dim, order + 1): Taylor coefficients of the derivative over the set */
    mag_ptr W, A;                           /* the same shape: bounds of them, and of those of Df, over the rough enclosure */
    arb_ptr inverse;                        /* (order + 1,): 1/k at k > 0 */
    arb_mat_t image, slope, derivative, rest;
    jlt_step_watch *watch;
};

jlt_rough_accuracy jlt_step_accuracy_for(unsigned digits)
{
    const slong tolerance = (slong)(digits * 3.3219281) + 20;
    return (jlt_rough_accuracy){ .order = (unsigned)tolerance / 4 + 8, .bits = tolerance + 40, .tolerance = tolerance };
}

jlt_status jlt_step_create(jlt_step **step, const jlt_formulas *of, arb_srcptr params, jlt_rough_accuracy accuracy,
                           jlt_step_watch *watch)
{
    JLT_OWNED(jlt_step) *self = calloc(1, sizeof *self);
    const slong n = (slong)of->dim;

    *step = NULL;
    if (self == NULL) return JLT_ERR_NOMEM;
    self->of = of;
    self->accuracy = accuracy;
    self->watch = watch;
    self->params = _arb_vec_init((slong)of->params + 1);
    self->x = _arb_vec_init(n);
    self->V = _arb_vec_init(n * n * (accuracy.order + 1));
    self->inverse = _arb_vec_init(accuracy.order + 1);
    self->W = _mag_vec_init(n * n * (accuracy.order + 1));
    self->A = _mag_vec_init(n * n * (accuracy.order + 1));
    arb_mat_init(self->image, n, 1);
    arb_mat_init(self->slope, n, n);
    arb_mat_init(self->derivative, n, n);
    arb_mat_init(self->rest, n, n);
    for (unsigned k = 1; k <= accuracy.order; k++) {
        arb_set_ui(self->inverse + k, k);
        arb_inv(self->inverse + k, self->inverse + k, accuracy.bits);
    }
    _arb_vec_set(self->params, params, (slong)of->params);
    JLT_PASS(jlt_jets_create(&self->point, of, of->motion, accuracy.order, 0));
    JLT_PASS(jlt_rough_init(&self->around, of, of->variation, self->params, accuracy, 0));
    JLT_PASS(jlt_jets_create(&self->plain, of, of->variation, 0, 0));
    *step = self;
    self = NULL; /* ownership moved to the caller */
    return JLT_OK;
}

void jlt_step_destroy(jlt_step *step)
{
    if (step == NULL) return;
    const slong n = (slong)step->of->dim, order = (slong)step->accuracy.order;
    _arb_vec_clear(step->params, (slong)step->of->params + 1);
    _arb_vec_clear(step->x, n);
    _arb_vec_clear(step->V, n * n * (order + 1));
    _arb_vec_clear(step->inverse, order + 1);
    _mag_vec_clear(step->W, n * n * (order + 1));
    _mag_vec_clear(step->A, n * n * (order + 1));
    arb_mat_clear(step->image);
    arb_mat_clear(step->slope);
    arb_mat_clear(step->derivative);
    arb_mat_clear(step->rest);
    jlt_jets_destroy(step->point);
    jlt_rough_clear(&step->around);
    jlt_jets_destroy(step->plain);
    free(step);
}

/* Where the series of entry (i, l) begins in V, W, A. */
static size_t entry(const jlt_step *self, unsigned i, unsigned l)
{
    return (i * self->of->dim + l) * (self->accuracy.order + 1);
}

/* Taylor coefficients of the derivative, V_(k+1) = (sum over j of Df_j V_(k-j))/(k+1), V_0 = 1, from the series of Df over the
 * set. */
static void vary(const jlt_step *self)
{
    const unsigned n = self->of->dim;
    const slong bits = self->accuracy.bits;

    for (unsigned i = 0; i < n; i++)
        for (unsigned l = 0; l < n; l++) arb_set_si(self->V + entry(self, i, l), i == l);
    for (unsigned k = 0; k < self->accuracy.order; k++)
        for (unsigned i = 0; i < self->of->states; i++)
            for (unsigned l = 0; l < n; l++) {
                arb_ptr next = self->V + entry(self, i, l) + k + 1;
                arb_zero(next);
                for (unsigned m = 0; m < n; m++) {
                    const unsigned slope = jlt_formulas_slope(self->of, i, m);
                    const unsigned length = jlt_jets_output_length(self->around.hull, slope);
                    arb_dot(next, next, 0, jlt_jets_output(self->around.hull, slope), 1, self->V + entry(self, m, l) + k, -1,
                            (slong)(length <= k ? length : k + 1), bits);
                }
                arb_mul(next, next, self->inverse + k + 1, bits);
            }
}

/* Bounds of the same over the rough enclosure, W_(k+1) = (sum over j of |Df_j| W_(k-j))/(k+1), W_0 = 1. */
static void bound_variation(const jlt_step *self)
{
    const unsigned n = self->of->dim, K = self->accuracy.order;

    for (unsigned i = 0; i < self->of->states; i++)
        for (unsigned m = 0; m < n; m++) {
            const unsigned slope = jlt_formulas_slope(self->of, i, m), length = jlt_jets_output_length(self->around.rough, slope);
            for (unsigned j = 0; j < length && j < K; j++)
                arb_get_mag(self->A + entry(self, i, m) + j, jlt_jets_output(self->around.rough, slope) + j);
        }
    for (unsigned i = 0; i < n; i++)
        for (unsigned l = 0; l < n; l++) mag_set_ui(self->W + entry(self, i, l), i == l);
    for (unsigned k = 0; k < K; k++)
        for (unsigned i = 0; i < self->of->states; i++)
            for (unsigned l = 0; l < n; l++) {
                mag_ptr next = self->W + entry(self, i, l) + k + 1;
                mag_zero(next);
                for (unsigned m = 0; m < n; m++) {
                    const unsigned length = jlt_jets_output_length(self->around.rough, jlt_formulas_slope(self->of, i, m));
                    mag_srcptr a = self->A + entry(self, i, m), w = self->W + entry(self, m, l) + k;
                    for (unsigned j = 0; j <= k && j < length; j++) mag_addmul(next, a + j, w - j);
                }
                mag_div_ui(next, next, k + 1);
            }
}

/* Set the step's `rest` to the derivative's remainder over a step of length h: W_K h^K times a bound of the derivative over the
 * step. Three quarters of the digits are enough, since it multiplies sets that are already small. Returns log2 of its largest entry
 * over the size that this tolerates. */
static double vary_rest(void *context, const arf_t h)
{
    jlt_step *self = context;
    const unsigned n = self->of->dim, K = self->accuracy.order;
    const slong bits = JLT_ROUGH_REST_BITS;
    double size = -INFINITY;
    JLT_SCOPED_MATRIX(arb, n, n, growth);
    JLT_SCOPED(mag, power, around, bound);

    bound_variation(self);
    for (unsigned i = 0; i < self->of->states; i++)
        for (unsigned m = 0; m < n; m++) {
            arb_get_mag(bound, jlt_jets_output(self->around.rough, jlt_formulas_slope(self->of, i, m)));
            arf_set_mag(arb_midref(arb_mat_entry(growth, i, m)), bound);
            arb_mul_arf(arb_mat_entry(growth, i, m), arb_mat_entry(growth, i, m), h, bits);
        }
    arb_mat_exp(growth, growth, bits);
    arf_get_mag(power, h);
    mag_pow_ui(power, power, K);
    for (unsigned i = 0; i < n; i++)
        for (unsigned l = 0; l < n; l++) {
            mag_zero(bound);
            for (unsigned m = 0; m < n; m++) {
                arb_get_mag(around, arb_mat_entry(growth, m, l));
                mag_addmul(bound, self->W + entry(self, i, m) + K, around);
            }
            mag_mul(bound, bound, power);
            arb_zero(arb_mat_entry(self->rest, i, l));
            arb_add_error_mag(arb_mat_entry(self->rest, i, l), bound);
            size = fmax(size, mag_get_d_log2_approx(bound));
        }
    return size + 0.75 * (double)self->accuracy.tolerance;
}

/* Compute the image of the midpoint; the slope, the derivative of the Taylor polynomial, by which differences are mapped; and the
 * flow's derivative. */
static void build(jlt_step *self, const arb_t h)
{
    const unsigned n = self->of->dim, K = self->accuracy.order;
    const slong bits = self->accuracy.bits;
    JLT_SCOPED(arb, zero);

    for (unsigned i = 0; i < n; i++)
        jlt_rough_sum(arb_mat_entry(self->image, i, 0), jlt_jets_state(self->point, i), K,
                      jlt_jets_state(self->around.rough, i) + K, h, bits);
    for (unsigned i = 0; i < n; i++)
        for (unsigned l = 0; l < n; l++)
            jlt_rough_sum(arb_mat_entry(self->slope, i, l), self->V + entry(self, i, l), K, zero, h, bits);
    arb_mat_add(self->derivative, self->slope, self->rest, bits);
}

/* Add the integral of the divergence over [0, h]: a series whose coefficient i + 1 is that of the divergence divided by i + 1. */
static void expand(const jlt_step *self, arb_t expansion, const arb_t h)
{
    const unsigned K = self->accuracy.order, output = jlt_formulas_divergence(self->of);
    const slong bits = self->accuracy.bits;
    JLT_SCOPED_VECTOR(arb, a, K + 1);

    for (unsigned i = 0; i + 1 < K; i++) arb_div_ui(a + i + 1, jlt_jets_output(self->around.hull, output) + i, i + 1, bits);
    arb_div_ui(a + K, jlt_jets_output(self->around.rough, output) + K - 1, K, bits);
    jlt_rough_sum(a, a, K, a + K, h, bits);
    arb_add(expansion, expansion, a, bits);
}

void jlt_step_lower(arf_struct *least, const arf_struct *other, unsigned count)
{
    for (unsigned i = 0; i < count; i++)
        if (arf_is_nan(other + i) || arf_cmp(other + i, least + i) < 0) arf_set(least + i, other + i);
}

static void lower(arf_t least, const arb_t value, slong bits)
{
    JLT_SCOPED(arf, bound);

    arb_get_lbound_arf(bound, value, bits);
    jlt_step_lower(least, bound, 1);
}

/* Enclose an output over a part of the step. */
static void over(const jlt_step *self, arb_t value, unsigned output, const arb_t span)
{
    const unsigned K = self->accuracy.order - 1;

    jlt_rough_sum(value, jlt_jets_output(self->around.hull, output), K, jlt_jets_output(self->around.rough, output) + K, span,
                  self->accuracy.bits);
}

/* As `over`, by the mean value theorem: P(m) + P'(span)(span - m) + remainder with m the midpoint of span. This is sharper over
 * short parts, above all near a minimum of the output. */
static void over_by_slope(const jlt_step *self, arb_t value, unsigned output, const arb_t span)
{
    const unsigned K = self->accuracy.order - 1;
    const slong bits = self->accuracy.bits;
    arb_srcptr a = jlt_jets_output(self->around.hull, output);
    JLT_SCOPED(arb, middle, slope, rest);

    for (unsigned i = K - 1; i > 0; i--) {
        arb_mul(slope, slope, span, bits);
        arb_addmul_ui(slope, a + i, i, bits);
    }
    arb_get_mid_arb(middle, span);
    jlt_rough_sum(value, a, K, rest, middle, bits);
    arb_sub(middle, span, middle, bits);
    arb_addmul(value, slope, middle, bits);
    arb_pow_ui(rest, span, K, bits);
    arb_addmul(value, rest, jlt_jets_output(self->around.rough, output) + K, bits);
}

/* Part p of [0, h] divided into `parts` equal ones: (2p + 1 +- 1) h/(2 parts). */
static void set_part(arb_t span, const arb_t h, unsigned p, unsigned parts, slong bits)
{
    arb_set_ui(span, 2 * p + 1);
    mag_one(arb_radref(span));
    arb_mul(span, span, h, bits);
    arb_div_ui(span, span, 2 * parts, bits);
}

/* Whether an output is proved positive over such a part, which is bisected while that is undecided. */
static bool is_positive(const jlt_step *self, unsigned output, const arb_t h, unsigned p, unsigned parts)
{
    bool positive, settled;
    JLT_SCOPED(arb, span, value);

    set_part(span, h, p, parts, self->accuracy.bits);
    over(self, value, output, span);
    if (!arb_is_positive(value) && parts > PIECES) over_by_slope(self, value, output, span);
    positive = arb_is_positive(value);
    settled = positive || arb_is_nonpositive(value) || parts == FINEST;
    return settled ? positive
                   : is_positive(self, output, h, 2 * p, 2 * parts) && is_positive(self, output, h, 2 * p + 1, 2 * parts);
}

/* Lower `least` to the conditions' bounds over [0, h], piece by piece. Returns false if the set may leave the domain. */
static bool watch(const jlt_step *self, arf_struct *least, const arb_t h)
{
    const slong bits = self->accuracy.bits;
    bool inside = true;
    JLT_SCOPED(arb, span, value, sharper);

    for (unsigned p = 0; p < PIECES; p++) {
        set_part(span, h, p, PIECES, bits);
        for (unsigned i = 0; i < self->of->valid_count; i++) {
            over(self, value, jlt_formulas_valid(self->of, i), span);
            over_by_slope(self, sharper, jlt_formulas_valid(self->of, i), span);
            if (arb_is_finite(value) && arb_is_finite(sharper)) (void)arb_intersection(value, value, sharper, bits);
            lower(least + i, value, bits);
        }
        for (unsigned i = 0; inside && i < self->of->domain_count; i++)
            inside = is_positive(self, jlt_formulas_domain(self->of, i), h, p, PIECES);
    }
    return inside;
}

jlt_status jlt_step_advance(jlt_step *self, jlt_set *set, arf_t h, arb_t expansion, arf_struct *least)
{
    const slong bits = self->accuracy.bits;
    bool inside;

    jlt_set_hull(self->x, set);
    jlt_jets_run(self->around.hull, self->x, self->params, bits);
    jlt_rough_choose(&self->around, h);
    if (!jlt_rough_validate(&self->around, h, vary_rest, self)) return JLT_ERR_NO_PROGRESS;
    vary(self);
    for (unsigned i = 0; i < self->of->dim; i++) arb_set(self->x + i, arb_mat_entry(set->x, i, 0));
    jlt_jets_run(self->point, self->x, self->params, bits);
    JLT_SCOPED(arb, length);
    arb_set_arf(length, h);
    build(self, length);
    expand(self, expansion, length);
    inside = watch(self, least, length);
    jlt_set_move(set, self->image, self->slope, self->derivative);
    if (self->watch != NULL) self->watch->told(self->watch->context, ++self->watch->steps);
    return inside ? JLT_OK : JLT_ERR_DOMAIN;
}

void jlt_step_evaluate(jlt_step *self, arb_srcptr x)
{
    jlt_jets_run(self->plain, x, self->params, self->accuracy.bits);
}

arb_srcptr jlt_step_output(const jlt_step *self, unsigned index)
{
    return jlt_jets_output(self->plain, index);
}

void jlt_step_conditions(const jlt_step *self, arf_struct *least)
{
    for (unsigned i = 0; i < self->of->valid_count; i++)
        lower(least + i, jlt_step_output(self, jlt_formulas_valid(self->of, i)), self->accuracy.bits);
}

bool jlt_step_holds(const jlt_step *self)
{
    for (unsigned i = 0; i < self->of->domain_count; i++)
        if (!arb_is_positive(jlt_step_output(self, jlt_formulas_domain(self->of, i)))) return false;
    return true;
}

const jlt_formulas *jlt_step_formulas(const jlt_step *self) { return self->of; }

slong jlt_step_bits(const jlt_step *self) { return self->accuracy.bits; }
