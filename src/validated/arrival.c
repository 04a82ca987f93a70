#include "validated/arrival.h"

void jlt_arrival_init(jlt_arrival *self, unsigned dim)
{
    self->dim = dim;
    self->x = _arb_vec_init((slong)dim);
    arb_mat_init(self->slope, dim, dim);
    arb_init(self->time);
    arb_init(self->window);
    arb_init(self->expansion);
    for (unsigned i = 0; i < JLT_ARRIVAL_VALIDS_MAX; i++) arf_init(self->least + i);
    self->steps = 0;
}

void jlt_arrival_clear(jlt_arrival *self)
{
    _arb_vec_clear(self->x, (slong)self->dim);
    arb_mat_clear(self->slope);
    arb_clear(self->time);
    arb_clear(self->window);
    arb_clear(self->expansion);
    for (unsigned i = 0; i < JLT_ARRIVAL_VALIDS_MAX; i++) arf_clear(self->least + i);
}

/* Whether the step h, unless it is the last, exceeds 2^-22 of the whole time: shorter ones mean that enclosures grow too fast. */
static bool gets_on(const arf_t h, const arf_t left, const arf_t instant)
{
    JLT_SCOPED(arf, least);

    arf_mul_2exp_si(least, instant, -22);
    return arf_cmp(h, least) > 0 || arf_sgn(left) == 0;
}

static jlt_status carry(jlt_arrival *self, jlt_step *step, jlt_set *set, const arf_t instant)
{
    JLT_SCOPED(arf, left, h);

    arf_set(left, instant);
    for (self->steps = 0; arf_sgn(left) > 0; self->steps++) {
        arf_set(h, left);
        JLT_PASS(jlt_step_advance(step, set, h, self->expansion, self->least));
        arf_sub(left, left, h, ARF_PREC_EXACT, ARF_RND_DOWN);
        if (!gets_on(h, left, instant)) return JLT_ERR_NO_PROGRESS;
    }
    return JLT_OK;
}

/* The rate of component i at the box last evaluated; 0 for a free parameter. */
static void rate(arb_t out, const jlt_step *step, unsigned i)
{
    if (i < jlt_step_formulas(step)->states) arb_set(out, jlt_step_output(step, i));
    else arb_zero(out);
}

/* Enclose the crossing: its time tau, and in y all solutions from x over span = [-d, d], d about twice what the crossing needs. */
static jlt_status cross(jlt_step *step, arb_ptr y, arb_t tau, arb_t span, arb_srcptr x, unsigned n, unsigned column,
                        const arb_t level, int direction)
{
    const slong bits = jlt_step_bits(step);
    bool inside = false;
    JLT_SCOPED(arb, f, z);
    JLT_SCOPED(mag, size);

    jlt_step_evaluate(step, x);
    rate(f, step, column);
    arb_sub(tau, level, x + column, bits);
    arb_div(tau, tau, f, bits);
    arb_get_mag(size, tau);
    mag_mul_2exp_si(size, size, 1);
    arb_zero(span);
    arb_add_error_mag(span, size);
    for (unsigned i = 0; i < n; i++) {
        rate(f, step, i);
        arb_mul(f, f, span, bits);
        arb_mul_2exp_si(f, f, 1);
        arb_add(y + i, x + i, f, bits);
        mag_mul_2exp_si(size, arb_radref(y + i), -20);
        mag_add(arb_radref(y + i), arb_radref(y + i), size);
        if (mag_is_zero(arb_radref(y + i))) mag_set_ui_2exp_si(arb_radref(y + i), 1, -bits); /* a state that stays 0 lies inside */
    }
    for (unsigned attempt = 0; attempt < 4 && !inside; attempt++) {
        jlt_step_evaluate(step, y);
        inside = jlt_step_holds(step);
        for (unsigned i = 0; inside && i < jlt_step_formulas(step)->states; i++) {
            rate(f, step, i);
            arb_mul(z, f, span, bits);
            arb_add(z, z, x + i, bits);
            if (arb_is_finite(z) && arb_contains_interior(y + i, z)) continue;
            inside = false;
            if (arb_is_finite(z)) {
                arb_union(y + i, y + i, z, bits);
                mag_mul_2exp_si(arb_radref(y + i), arb_radref(y + i), 1);
            }
        }
    }
    if (!inside) return jlt_step_holds(step) ? JLT_ERR_NO_CONVERGENCE : JLT_ERR_DOMAIN;
    rate(f, step, column);
    if (direction > 0 ? !arb_is_positive(f) : !arb_is_negative(f)) return JLT_ERR_NO_CONVERGENCE;
    arb_sub(tau, level, x + column, bits);
    arb_div(tau, tau, f, bits);
    return arb_contains(span, tau) ? JLT_OK : JLT_ERR_NO_CONVERGENCE;
}

/* Over the box y last evaluated, enclose the derivatives of the crossing's state, local, shape (dim, dim), and of its time, delay,
 * shape (1, dim), by the state before. */
static void differentiate(arb_mat_t local, arb_mat_t delay, const jlt_step *step, const arb_t tau, unsigned column)
{
    const jlt_formulas *of = jlt_step_formulas(step);
    const slong n = (slong)of->dim, bits = jlt_step_bits(step);
    JLT_SCOPED_MATRIX(arb, n, n, flow, slope, near_one);
    JLT_SCOPED(arb, value);
    JLT_SCOPED(mag, norm, row, bound);

    for (unsigned i = 0; i < of->states; i++) {
        mag_zero(row);
        for (unsigned k = 0; k < of->dim; k++) {
            arb_set(arb_mat_entry(slope, i, k), jlt_step_output(step, jlt_formulas_slope(of, i, k)));
            arb_get_mag(bound, arb_mat_entry(slope, i, k));
            mag_add(row, row, bound);
        }
        mag_max(norm, norm, row);
    }
    /* V(tau) - 1 = tau Df V, where |V - 1| <= e^(norm |tau|) - 1. */
    arb_get_mag(bound, tau);
    mag_mul(norm, norm, bound);
    mag_expm1(norm, norm);
    for (slong i = 0; i < n; i++)
        for (slong k = 0; k < n; k++) {
            arb_set_si(arb_mat_entry(near_one, i, k), i == k);
            arb_add_error_mag(arb_mat_entry(near_one, i, k), norm);
        }
    arb_mat_mul(flow, slope, near_one, bits);
    arb_mat_scalar_mul_arb(flow, flow, tau, bits);
    arb_mat_one(near_one);
    arb_mat_add(flow, flow, near_one, bits);
    for (slong k = 0; k < n; k++) {
        arb_div(arb_mat_entry(delay, 0, k), arb_mat_entry(flow, column, k), jlt_step_output(step, column), bits);
        arb_neg(arb_mat_entry(delay, 0, k), arb_mat_entry(delay, 0, k));
        for (unsigned i = 0; i < of->dim; i++) {
            arb_ptr out = arb_mat_entry(local, i, k);
            rate(value, step, i);
            arb_set(out, arb_mat_entry(flow, i, k));
            if (i == column) arb_zero(out);
            else arb_addmul(out, value, arb_mat_entry(delay, 0, k), bits);
        }
    }
}

/* out += slope*(C r0 + Q r), the image of the set's part around its middle, shape (rows of slope, 1). */
static void add_rest(arb_mat_t out, const arb_mat_t slope, const jlt_set *set)
{
    JLT_SCOPED_MATRIX(arb, arb_mat_nrows(slope), set->dim, product);
    JLT_SCOPED_MATRIX(arb, arb_mat_nrows(slope), 1, column);

    arb_mat_mul(product, slope, set->C, set->bits);
    arb_mat_mul(column, product, set->r0, set->bits);
    arb_mat_add(out, out, column, set->bits);
    arb_mat_mul(product, slope, set->Q, set->bits);
    arb_mat_mul(column, product, set->r, set->bits);
    arb_mat_add(out, out, column, set->bits);
}

/* State of the crossing, and its time from the instant on: those of the middle, and by the mean value theorem the derivatives times
 * the rest of the set. */
static jlt_status land(jlt_arrival *self, jlt_step *step, const jlt_set *set, const arb_mat_t local, const arb_mat_t delay,
                       unsigned column, const arb_t level, int direction)
{
    const slong bits = jlt_step_bits(step), n = (slong)self->dim;
    JLT_SCOPED_VECTOR(arb, middle, n);
    JLT_SCOPED_VECTOR(arb, y, n);
    JLT_SCOPED_MATRIX(arb, n, 1, state);
    JLT_SCOPED_MATRIX(arb, 1, 1, time);
    JLT_SCOPED(arb, span);

    for (slong i = 0; i < n; i++) arb_set(middle + i, arb_mat_entry(set->x, i, 0));
    JLT_PASS(cross(step, y, arb_mat_entry(time, 0, 0), span, middle, self->dim, column, level, direction));
    for (unsigned i = 0; i < self->dim; i++) {
        arb_ptr out = arb_mat_entry(state, i, 0);
        rate(out, step, i);
        arb_mul(out, out, arb_mat_entry(time, 0, 0), bits);
        arb_add(out, out, middle + i, bits);
    }
    add_rest(state, local, set);
    add_rest(time, delay, set);
    for (slong i = 0; i < n; i++) arb_set(self->x + i, arb_mat_entry(state, i, 0));
    arb_set(self->x + column, level);
    arb_set(self->time, arb_mat_entry(time, 0, 0));
    return JLT_OK;
}

jlt_status jlt_arrival_compute(jlt_arrival *self, jlt_step *step, arb_srcptr start, unsigned column, const arb_t level,
                               const arf_t instant, int direction)
{
    const slong bits = jlt_step_bits(step), n = (slong)self->dim;
    JLT_SCOPED_VECTOR(arb, hull, n);
    JLT_SCOPED_VECTOR(arb, y, n);
    JLT_CLEARED(jlt_set_clear) jlt_set set;

    jlt_set_init(&set, start, self->dim, bits);
    JLT_SCOPED_MATRIX(arb, n, n, V, local);
    JLT_SCOPED_MATRIX(arb, 1, n, delay);
    JLT_SCOPED(arb, tau);
    arb_zero(self->expansion);
    if (jlt_step_formulas(step)->valid_count > JLT_ARRIVAL_VALIDS_MAX) return JLT_ERR_ARG;
    for (unsigned i = 0; i < JLT_ARRIVAL_VALIDS_MAX; i++) arf_pos_inf(self->least + i);
    JLT_PASS(carry(self, step, &set, instant));
    jlt_set_hull(hull, &set);
    jlt_set_slope(V, &set);
    JLT_PASS(cross(step, y, tau, self->window, hull, self->dim, column, level, direction));
    jlt_step_conditions(step, self->least);
    arb_addmul(self->expansion, tau, jlt_step_output(step, jlt_formulas_divergence(jlt_step_formulas(step))), bits);
    differentiate(local, delay, step, tau, column);
    arb_mat_mul(self->slope, local, V, bits);
    JLT_PASS(land(self, step, &set, local, delay, column, level, direction));
    arb_add_arf(self->time, self->time, instant, bits);
    return JLT_OK;
}
