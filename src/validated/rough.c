#include "validated/rough.h"

#include <math.h>

enum { TRIES = 60 }; /* most lengths tried for a step */

jlt_status jlt_rough_init(jlt_rough *self, const jlt_formulas *of, const ttc_program *program, arb_srcptr params,
                          jlt_rough_accuracy accuracy, unsigned degree)
{
    *self = (jlt_rough){ .of = of, .params = params, .accuracy = accuracy, .terms = jlt_jets_terms(degree), .caution = 0.7 };
    self->y = _arb_vec_init((slong)(of->dim * self->terms));
    JLT_PASS(jlt_jets_create(&self->hull, of, program, accuracy.order, degree));
    return jlt_jets_create(&self->rough, of, program, accuracy.order, degree);
}

void jlt_rough_clear(jlt_rough *self)
{
    if (self->y != NULL) _arb_vec_clear(self->y, (slong)(self->of->dim * self->terms));
    jlt_jets_destroy(self->hull);
    jlt_jets_destroy(self->rough);
}

arb_srcptr jlt_rough_series(const jlt_rough *self, const jlt_jets *jets, unsigned i)
{
    return jlt_jets_state(jets, i / self->terms) + i % self->terms * (self->accuracy.order + 1);
}

void jlt_rough_sum(arb_t out, arb_srcptr a, unsigned count, const arb_t last, const arb_t t, slong bits)
{
    JLT_SCOPED(arb, total);

    arb_set(total, last);
    for (unsigned i = count; i-- > 0;) {
        arb_mul(total, total, t, bits);
        arb_add(total, total, a + i, bits);
    }
    arb_swap(out, total);
}

/* log2 of the largest coefficient of this order over all states. */
static double size_of(const jlt_rough *self, const jlt_jets *jets, unsigned order)
{
    double size = -INFINITY;
    JLT_SCOPED(mag, bound);

    for (unsigned i = 0; i < self->of->states * self->terms; i++) {
        arb_get_mag(bound, jlt_rough_series(self, jets, i) + order);
        size = fmax(size, mag_get_d_log2_approx(bound));
    }
    return size;
}

void jlt_rough_choose(const jlt_rough *self, arf_t h)
{
    const double K = self->accuracy.order, goal = -(double)self->accuracy.tolerance;
    const double length = fmin((goal - size_of(self, self->hull, self->accuracy.order)) / K,
                               (goal - size_of(self, self->hull, self->accuracy.order - 1)) / (K - 1));
    JLT_SCOPED(arf, wanted);

    if (isfinite(length)) {
        const double step = self->caution * exp2(fmin(fmax(length, -1000), 1000));
        const int places = step > 0x1p-16 ? 20 : 4 - ilogb(step); /* of powers of 2: four leading ones where 20 are too few */
        arf_set_d(wanted, floor(ldexp(step, places)));
        arf_mul_2exp_si(wanted, wanted, -places);
        if (arf_cmp(wanted, h) < 0) arf_set(h, wanted);
    }
}

/* Enclose the solutions from the set over [0, h] to order K - 1, and with the remainder over y if with_remainder. Returns false if
 * that is not finite. */
static bool spread(const jlt_rough *self, arb_ptr z, const arb_t span, bool with_remainder)
{
    const unsigned K = self->accuracy.order;
    bool finite = true;
    JLT_SCOPED(arb, last);

    for (unsigned i = 0; i < self->of->dim * self->terms; i++) {
        if (with_remainder) arb_set(last, jlt_rough_series(self, self->rough, i) + K);
        jlt_rough_sum(z + i, jlt_rough_series(self, self->hull, i), K, last, span, self->accuracy.bits);
        finite = finite && arb_is_finite(z + i);
    }
    return finite;
}

/* Find y whose interior contains the solutions from the set over [0, h]. Returns false if h is too long. */
static bool enclose(jlt_rough *self, const arf_t h)
{
    const unsigned n = self->of->dim * self->terms;
    const slong bits = self->accuracy.bits;
    JLT_SCOPED_VECTOR(arb, z, (slong)n);
    bool inside = false;
    JLT_SCOPED(arb, span, zero);
    JLT_SCOPED(mag, more);

    arb_set_arf(span, h);
    arb_union(span, span, zero, bits);
    bool good = spread(self, self->y, span, false);
    mag_one(more);
    mag_mul_2exp_si(more, more, 8 - self->accuracy.tolerance);
    for (unsigned i = 0; i < n; i++) mag_add(arb_radref(self->y + i), arb_radref(self->y + i), more);
    for (unsigned attempt = 0; good && !inside && attempt < 3; attempt++) {
        jlt_jets_run(self->rough, self->y, self->params, JLT_ROUGH_REST_BITS);
        good = spread(self, z, span, true);
        inside = good;
        for (unsigned i = 0; good && i < n; i++) {
            if (arb_contains_interior(self->y + i, z + i)) continue;
            inside = false;
            arb_set(self->y + i, z + i);
            mag_mul_2exp_si(arb_radref(self->y + i), arb_radref(self->y + i), 1);
        }
    }
    return inside;
}

bool jlt_rough_validate(jlt_rough *self, arf_t h, jlt_rough_excess further, void *context)
{
    const double K = self->accuracy.order, slack = 8, tolerance = (double)self->accuracy.tolerance;

    for (unsigned attempt = 0; attempt < TRIES; attempt++) {
        double factor = 0.7;
        if (enclose(self, h)) {
            const double remainder = size_of(self, self->rough, self->accuracy.order) + K * log2(arf_get_d(h, ARF_RND_UP));
            double excess = remainder + tolerance - slack;
            if (excess <= 0 && further != NULL) excess = fmax(excess, further(context, h));
            if (excess <= 0) {
                self->caution = fmin(self->caution * 1.02, 0.9);
                return true;
            }
            factor = fmax(0.5, fmin(0.98, exp2(-(excess + slack) / K)));
        }
        self->caution *= factor;
        arf_set_d(h, arf_get_d(h, ARF_RND_DOWN) * factor);
    }
    return false;
}
