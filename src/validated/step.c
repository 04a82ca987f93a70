#include "validated/step.h"

#include <math.h>
#include <stdlib.h>

enum {
    PIECES = 16,
    TRIES = 60,
    REST_BITS = 64 /* what only remainders are made of: they are below the tolerance, so that their own digits do not matter */
};

struct jlt_step {
    const jlt_formulas *of;
    jlt_step_accuracy accuracy;
    arb_ptr params;
    jlt_jets *point, *hull, *rough, *plain; /* over the middle, the set, the rough enclosure; plain: order 0 */
    arb_ptr x, y;                           /* (dim,): middle or set; rough enclosure */
    arb_ptr V, W;                           /* coefficients of the derivative over set and rough enclosure, (dim, dim, order + 1) */
    arb_mat_t image, slope, derivative, rest;
    double caution;                         /* by which steps are shorter than coefficients say */
};

jlt_step_accuracy jlt_step_accuracy_for(unsigned digits)
{
    const slong tolerance = (slong)(digits * 3.3219281) + 20;
    return (jlt_step_accuracy){ .order = (unsigned)tolerance / 4 + 8, .bits = tolerance + 40, .tolerance = tolerance };
}

jlt_status jlt_step_create(jlt_step **step, const jlt_formulas *of, arb_srcptr params, jlt_step_accuracy accuracy)
{
    jlt_step *self = calloc(1, sizeof *self);
    const slong n = (slong)of->dim;
    jlt_status st;

    *step = NULL;
    if (self == NULL) return JLT_ERR_NOMEM;
    self->of = of;
    self->accuracy = accuracy;
    self->caution = 0.7;
    self->params = _arb_vec_init((slong)of->params + 1);
    self->x = _arb_vec_init(n);
    self->y = _arb_vec_init(n);
    self->V = _arb_vec_init(n * n * (accuracy.order + 1));
    self->W = _arb_vec_init(n * n * (accuracy.order + 1));
    arb_mat_init(self->image, n, 1);
    arb_mat_init(self->slope, n, n);
    arb_mat_init(self->derivative, n, n);
    arb_mat_init(self->rest, n, n);
    _arb_vec_set(self->params, params, (slong)of->params);
    JLT_TRY(jlt_jets_create(&self->point, of, of->motion, accuracy.order));
    JLT_TRY(jlt_jets_create(&self->hull, of, of->variation, accuracy.order));
    JLT_TRY(jlt_jets_create(&self->rough, of, of->variation, accuracy.order));
    JLT_TRY(jlt_jets_create(&self->plain, of, of->variation, 0));
    *step = self;
    self = NULL; /* ownership moved to the caller */
done:
    jlt_step_destroy(self);
    return st;
}

void jlt_step_destroy(jlt_step *step)
{
    if (step == NULL) return;
    const slong n = (slong)step->of->dim, order = (slong)step->accuracy.order;
    _arb_vec_clear(step->params, (slong)step->of->params + 1);
    _arb_vec_clear(step->x, n);
    _arb_vec_clear(step->y, n);
    _arb_vec_clear(step->V, n * n * (order + 1));
    _arb_vec_clear(step->W, n * n * (order + 1));
    arb_mat_clear(step->image);
    arb_mat_clear(step->slope);
    arb_mat_clear(step->derivative);
    arb_mat_clear(step->rest);
    jlt_jets_destroy(step->point);
    jlt_jets_destroy(step->hull);
    jlt_jets_destroy(step->rough);
    jlt_jets_destroy(step->plain);
    free(step);
}

static arb_ptr entry(const jlt_step *self, arb_ptr V, unsigned i, unsigned l)
{
    return V + (i * self->of->dim + l) * (self->accuracy.order + 1);
}

/* V_(k+1) = (sum over j of Df_j V_(k-j))/(k+1), V_0 = 1, from the series of Df in `jets`. */
static void vary(const jlt_step *self, arb_ptr V, const jlt_jets *jets, slong bits)
{
    const unsigned n = self->of->dim;

    for (unsigned i = 0; i < n; i++)
        for (unsigned l = 0; l < n; l++) arb_set_si(entry(self, V, i, l), i == l);
    for (unsigned k = 0; k < self->accuracy.order; k++)
        for (unsigned i = 0; i < self->of->states; i++)
            for (unsigned l = 0; l < n; l++) {
                arb_ptr next = entry(self, V, i, l) + k + 1;
                arb_zero(next);
                for (unsigned m = 0; m < n; m++) {
                    const unsigned slope = jlt_formulas_slope(self->of, i, m), length = jlt_jets_output_length(jets, slope);
                    arb_dot(next, next, 0, jlt_jets_output(jets, slope), 1, entry(self, V, m, l) + k, -1,
                            (slong)(length <= k ? length : k + 1), bits);
                }
                arb_div_ui(next, next, k + 1, bits);
            }
}

/* sum_(i<count) t^i a_i + t^count last */
static void sum(arb_t out, arb_srcptr a, unsigned count, const arb_t last, const arb_t t, slong bits)
{
    arb_t total;

    arb_init(total);
    arb_set(total, last);
    for (unsigned i = count; i-- > 0;) {
        arb_mul(total, total, t, bits);
        arb_add(total, total, a + i, bits);
    }
    arb_swap(out, total);
    arb_clear(total);
}

/* log2 of the states' largest coefficient of this order. */
static double size_of(const jlt_step *self, const jlt_jets *jets, unsigned order)
{
    double size = -INFINITY;
    mag_t bound;

    mag_init(bound);
    for (unsigned i = 0; i < self->of->states; i++) {
        arb_get_mag(bound, jlt_jets_state(jets, i) + order);
        size = fmax(size, mag_get_d_log2_approx(bound));
    }
    mag_clear(bound);
    return size;
}

/* The length by which the last two coefficients reach the tolerance, or *h where that is shorter. */
static void choose_length(const jlt_step *self, arf_t h)
{
    const double K = self->accuracy.order, goal = -(double)self->accuracy.tolerance;
    const double length = fmin((goal - size_of(self, self->hull, self->accuracy.order)) / K,
                               (goal - size_of(self, self->hull, self->accuracy.order - 1)) / (K - 1));
    arf_t wanted;

    arf_init(wanted);
    if (isfinite(length)) {
        arf_set_d(wanted, floor(ldexp(self->caution * exp2(fmin(length, 3)), 20)));
        arf_mul_2exp_si(wanted, wanted, -20);
        if (arf_cmp(wanted, h) < 0) arf_set(h, wanted);
    }
    arf_clear(wanted);
}

/* The set over [0, h] to order K - 1, and with the remainder from y where that is known; false when it is not finite. */
static bool spread(const jlt_step *self, arb_ptr z, const arb_t span, bool with_remainder)
{
    const unsigned K = self->accuracy.order;
    bool finite = true;
    arb_t last;

    arb_init(last);
    for (unsigned i = 0; i < self->of->dim; i++) {
        if (with_remainder) arb_set(last, jlt_jets_state(self->rough, i) + K);
        sum(z + i, jlt_jets_state(self->hull, i), K, last, span, self->accuracy.bits);
        finite = finite && arb_is_finite(z + i);
    }
    arb_clear(last);
    return finite;
}

/* log2 of the remainder over a step of this length. */
static double remainder_of(const jlt_step *self, const arf_t h)
{
    return size_of(self, self->rough, self->accuracy.order) + self->accuracy.order * log2(arf_get_d(h, ARF_RND_UP));
}

/* y such that the set spread over [0, h] lies within its interior, see the header; false when this h is too long. */
static bool enclose(jlt_step *self, const arf_t h)
{
    const unsigned n = self->of->dim;
    const slong bits = self->accuracy.bits;
    arb_ptr z = _arb_vec_init((slong)n);
    bool inside = false;
    arb_t span, zero;
    mag_t more;

    arb_init(span);
    arb_init(zero);
    mag_init(more);
    arb_set_arf(span, h);
    arb_union(span, span, zero, bits);
    bool good = spread(self, self->y, span, false);
    mag_one(more);
    mag_mul_2exp_si(more, more, 8 - self->accuracy.tolerance);
    for (unsigned i = 0; i < n; i++) mag_add(arb_radref(self->y + i), arb_radref(self->y + i), more);
    for (unsigned attempt = 0; good && !inside && attempt < 3; attempt++) {
        jlt_jets_run(self->rough, self->y, self->params, REST_BITS);
        good = spread(self, z, span, true);
        inside = good;
        for (unsigned i = 0; good && i < n; i++) {
            if (arb_contains_interior(self->y + i, z + i)) continue;
            inside = false;
            arb_set(self->y + i, z + i);
            mag_mul_2exp_si(arb_radref(self->y + i), arb_radref(self->y + i), 1);
        }
    }
    _arb_vec_clear(z, (slong)n);
    arb_clear(span);
    arb_clear(zero);
    mag_clear(more);
    return inside;
}

/* The derivative's remainder over a step of this length, W_K h^K times the derivative's rough enclosure. Returns log2 of its largest
 * entry. */
static double vary_rest(jlt_step *self, const arf_t h)
{
    const unsigned n = self->of->dim, K = self->accuracy.order;
    const slong bits = REST_BITS;
    double size = -INFINITY;
    arb_mat_t growth;
    arb_t power;
    mag_t bound;

    arb_mat_init(growth, n, n);
    arb_init(power);
    mag_init(bound);
    vary(self, self->W, self->rough, bits);
    for (unsigned i = 0; i < self->of->states; i++)
        for (unsigned l = 0; l < n; l++) {
            arb_get_mag(bound, jlt_jets_output(self->rough, jlt_formulas_slope(self->of, i, l)));
            arf_set_mag(arb_midref(arb_mat_entry(growth, i, l)), bound);
            arb_mul_arf(arb_mat_entry(growth, i, l), arb_mat_entry(growth, i, l), h, bits);
        }
    arb_mat_exp(growth, growth, bits);
    arb_set_arf(power, h);
    arb_pow_ui(power, power, K, bits);
    for (unsigned i = 0; i < n; i++)
        for (unsigned l = 0; l < n; l++) {
            arb_ptr around = arb_mat_entry(growth, i, l);
            if (i == l) arb_sub_ui(around, around, 1, bits);
            arb_get_mag(bound, around);
            arb_set_si(around, i == l);
            arb_add_error_mag(around, bound);
            arb_mul(arb_mat_entry(self->rest, i, l), entry(self, self->W, i, l) + K, power, bits);
        }
    arb_mat_mul(self->rest, self->rest, growth, bits);
    for (unsigned i = 0; i < n; i++)
        for (unsigned l = 0; l < n; l++) {
            arb_get_mag(bound, arb_mat_entry(self->rest, i, l));
            size = fmax(size, mag_get_d_log2_approx(bound));
        }
    arb_mat_clear(growth);
    arb_clear(power);
    mag_clear(bound);
    return size;
}

/* Try lengths until one has a rough enclosure, and remainders not far above the tolerance: that of the derivative above three
 * quarters of its digits, as it multiplies sets that are small already. */
static bool validate(jlt_step *self, arf_t h)
{
    const double K = self->accuracy.order, slack = 8, tolerance = (double)self->accuracy.tolerance;

    choose_length(self, h);
    for (unsigned attempt = 0; attempt < TRIES; attempt++) {
        double factor = 0.7;
        if (enclose(self, h)) {
            double excess = remainder_of(self, h) + tolerance - slack;
            if (excess <= 0) excess = fmax(excess, vary_rest(self, h) + 0.75 * tolerance);
            if (excess <= 0) return true;
            factor = fmax(0.5, fmin(0.98, exp2(-(excess + slack) / K)));
        }
        self->caution *= factor;
        arf_set_d(h, arf_get_d(h, ARF_RND_DOWN) * factor);
    }
    return false;
}

/* Image of the middle; slope of the Taylor polynomial, by which differences go; derivative of the flow. */
static void build(jlt_step *self, const arb_t h)
{
    const unsigned n = self->of->dim, K = self->accuracy.order;
    const slong bits = self->accuracy.bits;
    arb_t zero;

    arb_init(zero);
    for (unsigned i = 0; i < n; i++)
        sum(arb_mat_entry(self->image, i, 0), jlt_jets_state(self->point, i), K, jlt_jets_state(self->rough, i) + K, h, bits);
    for (unsigned i = 0; i < n; i++)
        for (unsigned l = 0; l < n; l++) sum(arb_mat_entry(self->slope, i, l), entry(self, self->V, i, l), K, zero, h, bits);
    arb_mat_add(self->derivative, self->slope, self->rest, bits);
    arb_clear(zero);
}

/* The integral of the divergence over [0, h] is a state whose coefficient i + 1 is that of the divergence over i + 1. */
static void expand(const jlt_step *self, arb_t expansion, const arb_t h)
{
    const unsigned K = self->accuracy.order, output = jlt_formulas_divergence(self->of);
    const slong bits = self->accuracy.bits;
    arb_ptr a = _arb_vec_init(K + 1);

    for (unsigned i = 0; i + 1 < K; i++) arb_div_ui(a + i + 1, jlt_jets_output(self->hull, output) + i, i + 1, bits);
    arb_div_ui(a + K, jlt_jets_output(self->rough, output) + K - 1, K, bits);
    sum(a, a, K, a + K, h, bits);
    arb_add(expansion, expansion, a, bits);
    _arb_vec_clear(a, K + 1);
}

static void lower(arf_t least, const arb_t value, slong bits)
{
    arf_t bound;

    arf_init(bound);
    arb_get_lbound_arf(bound, value, bits);
    if (arf_cmp(bound, least) < 0 || arf_is_nan(bound)) arf_set(least, bound);
    arf_clear(bound);
}

/* An output over a part of the step. */
static void over(const jlt_step *self, arb_t value, unsigned output, const arb_t span)
{
    const unsigned K = self->accuracy.order - 1;

    sum(value, jlt_jets_output(self->hull, output), K, jlt_jets_output(self->rough, output) + K, span, self->accuracy.bits);
}

/* Conditions over [0, h], piece by piece. False where the set may leave the domain. */
static bool watch(const jlt_step *self, arf_struct *least, const arb_t h)
{
    const slong bits = self->accuracy.bits;
    bool inside = true;
    arb_t span, value;

    arb_init(span);
    arb_init(value);
    for (unsigned p = 0; p < PIECES; p++) {
        arb_set_ui(span, 2 * p + 1); /* (2p + 1 +- 1) h/32 */
        mag_one(arb_radref(span));
        arb_mul(span, span, h, bits);
        arb_div_ui(span, span, 2 * PIECES, bits);
        for (unsigned i = 0; i < self->of->valid_count; i++) {
            over(self, value, jlt_formulas_valid(self->of, i), span);
            lower(least + i, value, bits);
        }
        for (unsigned i = 0; inside && i < self->of->domain_count; i++) {
            over(self, value, jlt_formulas_domain(self->of, i), span);
            inside = arb_is_positive(value);
        }
    }
    arb_clear(span);
    arb_clear(value);
    return inside;
}

jlt_status jlt_step_advance(jlt_step *self, jlt_set *set, arf_t h, arb_t expansion, arf_struct *least)
{
    const slong bits = self->accuracy.bits;
    arb_t length;
    bool inside;

    jlt_set_hull(self->x, set);
    jlt_jets_run(self->hull, self->x, self->params, bits);
    if (!validate(self, h)) return JLT_ERR_NO_PROGRESS;
    self->caution = fmin(self->caution * 1.02, 0.9);
    vary(self, self->V, self->hull, bits);
    for (unsigned i = 0; i < self->of->dim; i++) arb_set(self->x + i, arb_mat_entry(set->x, i, 0));
    jlt_jets_run(self->point, self->x, self->params, bits);
    arb_init(length);
    arb_set_arf(length, h);
    build(self, length);
    expand(self, expansion, length);
    inside = watch(self, least, length);
    jlt_set_move(set, self->image, self->slope, self->derivative);
    arb_clear(length);
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
