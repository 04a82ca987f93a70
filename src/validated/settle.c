#include "validated/settle.h"

#include "core/memory.h"
#include "ext/scoped.h"


enum { ATTEMPTS = 8 };

void jlt_settle_result_init(jlt_settle_result *self, const jlt_formulas *of)
{
    self->vanishes = calloc(of->dim, sizeof *self->vanishes);
    self->limit = _arb_vec_init((slong)of->dim);
    self->least = calloc(of->valid_count + 1, sizeof *self->least);
    for (unsigned i = 0; self->least != NULL && i < of->valid_count; i++) arf_init(self->least + i);
}

void jlt_settle_result_clear(jlt_settle_result *self, const jlt_formulas *of)
{
    for (unsigned i = 0; self->least != NULL && i < of->valid_count; i++) arf_clear(self->least + i);
    free(self->least);
    free(self->vanishes);
    _arb_vec_clear(self->limit, (slong)of->dim);
}

typedef struct {
    jlt_step *step;
    arb_srcptr x;
    const bool *vanishes;
    unsigned dim, root, count; /* of states; index of the first lifted root; of states in p */
    unsigned *which;           /* (count,): indices of the states in p */
    slong bits;
    arb_ptr box, room;         /* (dim,): the box B; by how much B is wider than x in q */
    arb_mat_t decay, weights;  /* (count, count): upper bounds of M_ii and |M_ij| within p; (count, 1): w */
    arb_t size, rate;          /* upper bound of |p(0)|; lower bound of a */
} settling;

/* Set out to an upper bound of the value, or of its absolute value unless has_sign. The bound is an exact number. */
static void bound(arb_t out, const arb_t value, bool has_sign, slong bits)
{
    if (has_sign) arb_get_ubound_arf(arb_midref(out), value, bits);
    else {
        JLT_SCOPED(mag, size);
        arb_get_mag(size, value);
        arf_set_mag(arb_midref(out), size);
    }
    mag_zero(arb_radref(out));
}

static arb_srcptr slope(const settling *self, unsigned row, unsigned column)
{
    return jlt_step_output(self->step, jlt_formulas_slope(jlt_step_formulas(self->step), row, column));
}

/* Whether f = 0 for p = 0 and all q in B. */
static bool rests(settling *self)
{
    bool still = true;

    for (unsigned i = 0; i < self->dim; i++) {
        arb_set(self->box + i, self->x + i);
        if (self->vanishes[i]) arb_zero(self->box + i);
        else arb_add_error(self->box + i, self->room + i);
    }
    jlt_step_evaluate(self->step, self->box);
    for (unsigned i = 0; still && i < self->dim; i++) still = arb_is_zero(jlt_step_output(self->step, i));
    return still;
}

/* Set B, evaluate the field over it, and bound M within p. */
static void surround(settling *self)
{
    JLT_SCOPED(arb, reach);

    for (unsigned i = 0, k = 0; i < self->dim; i++) {
        arb_ptr side = self->box + i;
        arb_set(side, self->x + i);
        if (!self->vanishes[i]) {
            arb_add_error(side, self->room + i);
            continue;
        }
        arb_mul(reach, self->size, arb_mat_entry(self->weights, k++, 0), self->bits);
        arb_zero(side);
        if (i < self->root) arb_add_error(side, reach);
        else arb_union(side, side, reach, self->bits);
    }
    jlt_step_evaluate(self->step, self->box);
    for (unsigned i = 0; i < self->count; i++)
        for (unsigned j = 0; j < self->count; j++)
            bound(arb_mat_entry(self->decay, i, j), slope(self, self->which[i], self->which[j]), i == j, self->bits);
}

/* Solve decay w = -1 for the weights, and bound |p(0)|. Returns false unless all weights are positive. */
static bool weigh(settling *self)
{
    JLT_SCOPED_MATRIX(arb, self->count, 1, ones);
    JLT_SCOPED(arb, part);
    bool good;

    for (unsigned i = 0; i < self->count; i++) arb_set_si(arb_mat_entry(ones, i, 0), -1);
    good = arb_mat_solve(self->weights, self->decay, ones, self->bits);
    arb_zero(self->size);
    for (unsigned i = 0; good && i < self->count; i++) {
        arb_ptr w = arb_mat_entry(self->weights, i, 0);
        arb_get_mid_arb(w, w);
        good = arb_is_positive(w);
        arb_div(part, self->x + self->which[i], w, self->bits);
        bound(part, part, false, self->bits);
        if (arb_gt(part, self->size)) arb_set(self->size, part);
    }
    return good;
}

/* Bound the rate a over B from below; returns whether it is positive. */
static bool decays(settling *self)
{
    bool first = true, good = true;
    JLT_SCOPED_MATRIX(arb, self->count, 1, image);
    JLT_SCOPED(arb, rate);

    arb_mat_mul(image, self->decay, self->weights, self->bits);
    for (unsigned i = 0; i < self->count; i++) {
        arb_div(rate, arb_mat_entry(image, i, 0), arb_mat_entry(self->weights, i, 0), self->bits);
        arb_neg(rate, rate);
        arb_get_lbound_arf(arb_midref(rate), rate, self->bits);
        mag_zero(arb_radref(rate));
        good = good && arb_is_positive(rate);
        if (first || arb_lt(rate, self->rate)) arb_set(self->rate, rate);
        first = false;
    }
    return good;
}

/* Bound by how much a state moves, from the field as last evaluated over B. */
static void drift(arb_t out, const settling *self, unsigned state)
{
    JLT_SCOPED(arb, part);

    arb_zero(out);
    for (unsigned k = 0; k < self->count; k++) {
        bound(part, slope(self, state, self->which[k]), false, self->bits);
        arb_addmul(out, part, arb_mat_entry(self->weights, k, 0), self->bits);
    }
    arb_mul(out, out, self->size, self->bits);
    arb_div(out, out, self->rate, self->bits);
    bound(out, out, false, self->bits);
}

/* Whether B has room for q to move; a state without enough room gets twice what it needs. */
static bool has_room(settling *self)
{
    bool enough = true;
    JLT_SCOPED(arb, need);

    for (unsigned i = 0; i < self->dim; i++) {
        if (self->vanishes[i]) continue;
        drift(need, self, i);
        if (arb_is_finite(need) && arb_le(need, self->room + i)) continue;
        enough = false;
        arb_mul_2exp_si(self->room + i, need, 1);
    }
    return enough;
}

static void write(jlt_settle_result *result, const settling *self)
{
    JLT_SCOPED(arb, way);

    for (unsigned i = 0; i < self->dim; i++) {
        result->vanishes[i] = self->vanishes[i];
        arb_zero(result->limit + i);
        if (self->vanishes[i]) continue;
        drift(way, self, i);
        arb_set(result->limit + i, self->x + i);
        arb_add_error(result->limit + i, way);
    }
    for (unsigned i = 0; i < jlt_step_formulas(self->step)->valid_count; i++) arf_pos_inf(result->least + i);
    jlt_step_conditions(self->step, result->least);
}

/* Try the proof with the states that `vanishes` marks as p. */
static bool settles(jlt_settle_result *result, settling *self)
{
    bool settled = false;

    self->count = 0;
    for (unsigned i = 0; i < self->dim; i++) {
        arb_zero(self->room + i);
        if (self->vanishes[i]) self->which[self->count++] = i;
    }
    if (!rests(self)) return false;
    arb_mat_init(self->decay, self->count, self->count);
    arb_mat_init(self->weights, self->count, 1);
    for (unsigned i = 0; i < self->count; i++)
        bound(arb_mat_entry(self->weights, i, 0), self->x + self->which[i], false, self->bits);
    arb_one(self->size);
    for (unsigned attempt = 0; attempt < ATTEMPTS; attempt++) {
        surround(self);
        if (attempt > 0 && jlt_step_holds(self->step) && decays(self) && has_room(self)) {
            write(result, self);
            settled = rests(self);
            break;
        }
        if (!weigh(self)) break;
    }
    arb_mat_clear(self->decay);
    arb_mat_clear(self->weights);
    return settled;
}

bool jlt_settle(jlt_settle_result *result, jlt_step *step, arb_srcptr x)
{
    const jlt_formulas *of = jlt_step_formulas(step);
    const unsigned n = of->dim, root = of->states - 1 - of->lifted_count; /* then the lifted roots, then the clock */
    JLT_FREED bool *vanishes = calloc(n, sizeof *vanishes);
    settling self = { .step = step, .x = x, .vanishes = vanishes, .dim = n, .root = root, .bits = jlt_step_bits(step),
                      .which = calloc(n, sizeof *self.which), .box = _arb_vec_init(n), .room = _arb_vec_init(n) };
    bool settled = false;

    arb_init(self.size);
    arb_init(self.rate);
    if (vanishes != NULL && self.which != NULL && result->vanishes != NULL && result->least != NULL && of->lifted_count > 0) {
        for (unsigned i = root; i + 1 < of->states; i++) vanishes[i] = true;
        settled = settles(result, &self);
        for (unsigned i = 0; !settled && i < root; i++) {
            vanishes[i] = true;
            settled = settles(result, &self);
            for (unsigned k = i + 1; !settled && k < root; k++) {
                vanishes[k] = true;
                settled = settles(result, &self);
                vanishes[k] = false;
            }
            vanishes[i] = false;
        }
    }
    arb_clear(self.size);
    arb_clear(self.rate);
    _arb_vec_clear(self.box, n);
    _arb_vec_clear(self.room, n);
    free(self.which);
    return settled;
}
