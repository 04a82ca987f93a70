#include "validated/taylor_map.h"

#include "validated/cycle_map.h"

enum { DEGREE = JLT_TAYLOR_MAP_DEGREE, TERMS = JLT_TAYLOR_MAP_TERMS };

typedef struct {
    jlt_cycle *of;
    const unsigned *kept;
    slong bits;
    arb_ptr x; /* (dim, TERMS): polynomials of the states, then the free parameters */
} course;

static unsigned first_of(unsigned degree) { return degree * (degree + 1) / 2; }

/* out += a b, truncated at DEGREE. */
static void add_product(arb_ptr out, arb_srcptr a, arb_srcptr b, slong bits)
{
    for (unsigned d = 0; d <= DEGREE; d++)
        for (unsigned j = 0; j <= d; j++)
            for (unsigned e = 0; d + e <= DEGREE; e++)
                for (unsigned l = 0; l <= e; l++)
                    arb_addmul(out + first_of(d + e) + j + l, a + first_of(d) + j, b + first_of(e) + l, bits);
}

/* Set the constant coefficients, u = v = 0, to the point y of the cycle. */
static void fix(const course *self, arb_srcptr y)
{
    const jlt_cycle_question *q = self->of->question;

    for (unsigned i = 0; i < self->of->unknowns; i++) arb_set(self->x + jlt_cycle_map_state(self->of, i) * TERMS, y + i);
    arb_set(self->x + q->column * TERMS, q->section);
    for (unsigned i = 0; i < q->free_count; i++)
        arb_set(self->x + (self->of->formulas->states + i) * TERMS, q->params + q->free[i]);
}

/* F_w^-1 at y; left: the states w. Returns false if F_w may be singular. */
static bool invert_levels(const course *self, arb_mat_t inverse, unsigned *left, arb_srcptr y)
{
    const unsigned m = self->of->question->level_count;
    unsigned count = 0;
    JLT_SCOPED_MATRIX(arb, m, self->of->unknowns, gradients);
    JLT_SCOPED_MATRIX(arb, m, m, by_left);

    jlt_cycle_map_gradients(self->of, gradients, NULL, y);
    for (unsigned i = 0; i < self->of->unknowns; i++) {
        const unsigned state = jlt_cycle_map_state(self->of, i);
        if (jlt_cycle_map_is_kept(self->of, state, self->kept)) continue;
        for (unsigned j = 0; j < m; j++) arb_set(arb_mat_entry(by_left, j, count), arb_mat_entry(gradients, j, i));
        left[count++] = state;
    }
    return m == 0 || arb_mat_inv(inverse, by_left, self->bits);
}

/* Set the starts on the levels: the coefficients of w of one degree make those of F vanish, given those of lower degree. */
static jlt_status begin(const course *self, arb_srcptr y)
{
    const jlt_cycle_question *q = self->of->question;
    const unsigned m = q->level_count;
    unsigned left[JLT_CYCLE_STATES_MAX];
    JLT_OWNED(jlt_jets) *levels = NULL;
    JLT_SCOPED_MATRIX(arb, m, m, inverse);

    fix(self, y);
    for (unsigned j = 0; j < 2; j++) arb_one(self->x + self->kept[j] * TERMS + 1 + j);
    JLT_PASS(jlt_jets_create(&levels, self->of->formulas, self->of->formulas->levels, 0, DEGREE));
    if (!invert_levels(self, inverse, left, y)) return JLT_ERR_DOMAIN;
    for (unsigned degree = 1; degree <= DEGREE; degree++) {
        jlt_jets_run(levels, self->x, q->params, self->bits);
        for (unsigned term = first_of(degree); term < first_of(degree + 1); term++)
            for (unsigned i = 0; i < m; i++)
                for (unsigned j = 0; j < m; j++)
                    arb_submul(self->x + left[i] * TERMS + term, arb_mat_entry(inverse, i, j), jlt_jets_output(levels, j) + term,
                               self->bits);
    }
    return JLT_OK;
}

/* ---- transport by the flow ---- */

/* Replace x by the state after `length`, at most the step that was enclosed last. */
static void move(const jlt_rough *self, arb_ptr x, const arb_t length)
{
    const unsigned K = self->accuracy.order;

    for (unsigned i = 0; i < self->of->states * self->terms; i++)
        jlt_rough_sum(x + i, jlt_rough_series(self, self->hull, i), K, jlt_rough_series(self, self->rough, i) + K, length,
                      self->accuracy.bits);
}

/* Choose the next step h <= most. A step that would leave less than its own length is shortened to half of what is left. */
static void choose(const jlt_rough *self, arf_t h, const arf_t most, const arb_t left)
{
    JLT_SCOPED(arf, half);

    arf_set(h, most);
    jlt_rough_choose(self, h);
    arf_mul_2exp_si(half, arb_midref(left), -1);
    if (arf_cmp(h, most) < 0 && arf_cmp(h, half) > 0) arf_set_d(h, arf_get_d(half, ARF_RND_DOWN));
}

/* Carry x, shape (dim, terms), in place for a time > 0, given as a ball; the free parameters after the states stay unchanged. The
 * table's domain is not checked. Errors: NO_PROGRESS, no step can be validated. */
static jlt_status carry(jlt_rough *self, arb_ptr x, const arb_t time)
{
    const slong bits = self->accuracy.bits;
    JLT_SCOPED(arb, left, length);
    JLT_SCOPED(arf, h, most);

    arb_set(left, time);
    while (arb_is_positive(left)) {
        jlt_jets_run(self->hull, x, self->params, bits);
        arb_get_ubound_arf(most, left, bits);
        choose(self, h, most, left);
        if (!jlt_rough_validate(self, h, NULL, NULL)) return JLT_ERR_NO_PROGRESS;
        const bool last = arf_cmp(h, most) == 0;
        if (last) arb_set(length, left);
        else arb_set_arf(length, h);
        move(self, x, length);
        if (last) return JLT_OK;
        arb_sub(left, left, length, bits);
    }
    return JLT_ERR_NO_PROGRESS;
}

/* out = sum over k of c_k s^k, for one state. */
static void compose(arb_ptr out, const jlt_rough *around, unsigned state, arb_srcptr powers, slong bits)
{
    JLT_SCOPED_VECTOR(arb, c, TERMS);

    _arb_vec_zero(out, TERMS);
    for (unsigned k = 0; k <= DEGREE; k++) {
        for (unsigned term = 0; term < TERMS; term++)
            arb_set(c + term, jlt_rough_series(around, around->hull, state * TERMS + term) + k);
        add_product(out, c, powers + k * TERMS, bits);
    }
}

static void make_powers(arb_ptr powers, slong bits)
{
    for (unsigned k = 2; k <= DEGREE; k++) {
        _arb_vec_zero(powers + k * TERMS, TERMS);
        add_product(powers + k * TERMS, powers + TERMS, powers + (k - 1) * TERMS, bits);
    }
}

/* Move x from the time of the cycle's crossing to the crossing of each start. */
static void cross(const course *self, jlt_rough *around)
{
    const unsigned column = self->of->question->column;
    JLT_SCOPED_VECTOR(arb, powers, (DEGREE + 1) * TERMS); /* of s, from s^0 on */
    JLT_SCOPED_VECTOR(arb, miss, TERMS);                  /* by what the section's state misses its level */
    JLT_SCOPED(arb, change);

    arb_one(powers);
    jlt_jets_run(around->hull, self->x, around->params, self->bits);
    for (unsigned degree = 1; degree <= DEGREE; degree++) {
        compose(miss, around, column, powers, self->bits);
        for (unsigned term = first_of(degree); term < first_of(degree + 1); term++) {
            arb_div(change, miss + term, jlt_rough_series(around, around->hull, column * TERMS) + 1, self->bits);
            arb_sub(powers + TERMS + term, powers + TERMS + term, change, self->bits);
        }
        make_powers(powers, self->bits);
    }
    for (unsigned i = 0; i < self->of->formulas->states; i++)
        compose(self->x + i * TERMS, around, i, powers, self->bits);
}

jlt_status jlt_taylor_map_compute(jlt_cycle *of, arb_ptr map, const jlt_cycle_result *cycle, arb_srcptr instants,
                                  const unsigned *kept)
{
    const unsigned n = cycle->unknowns;
    JLT_SCOPED_VECTOR(arb, x, (slong)of->formulas->dim * TERMS);
    const course self = { of, kept, jlt_step_bits(of->step), x };
    const jlt_cycle_question *q = of->question;
    jlt_rough around;
    jlt_status st;

    JLT_TRY(jlt_rough_init(&around, of->formulas, of->formulas->motion, q->params, jlt_step_accuracy_for(q->digits), DEGREE));
    JLT_TRY(begin(&self, cycle->solution));
    for (unsigned i = 0; i < cycle->legs; i++) {
        JLT_TRY(jlt_cycle_map_arrive(of, cycle->solution + i * n, arb_midref(instants + i), q->direction, NULL));
        JLT_TRY(carry(&around, self.x, of->arrival.time));
        fix(&self, cycle->solution + (i + 1) % cycle->legs * n);
        cross(&self, &around);
        _arb_vec_zero(self.x + q->column * TERMS + 1, TERMS - 1); /* the section's state is constant */
    }
    for (unsigned k = 0; k < 2; k++) _arb_vec_set(map + k * TERMS, self.x + kept[k] * TERMS, TERMS);
done:
    jlt_rough_clear(&around);
    return st;
}
