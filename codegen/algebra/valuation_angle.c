/* Angles of a valuation: a basis that is linearly independent over the rationals, and the others as integer combinations of it. If
 * the table uses pi, the quarter turn pi/2 is one more angle of the basis, of which others may contain fractions too. */
#include "algebra/angle.h"
#include "algebra/valuation_state.h"
#include "base/array.h"

#include <stdlib.h>

#define NO_SYMBOL UINT32_MAX

static bool in_basis(const ttc_valuation *v, uint32_t cosine) { return ttc_array_has(v->basis, v->basis_count, cosine); }

static bool has_pi(const ttc_valuation *v)
{
    for (size_t i = 0; i < v->model->symbol_count; i++)
        if (v->model->symbols[i].kind == TTC_PI) return true;
    return false;
}

static void set_quarter_turn(ttc_valuation *v, ttc_ratio *out)
{
    fmpq_t half;
    fmpq_init(half);
    fmpq_set_si(half, 1, 2);
    ttc_valuation_pi(v, out);
    ttc_ratio_scale(v->ring, out, out, half);
    fmpq_clear(half);
}

/* The relation of an angle to the quarter turn and the basis. multiples: shape (basis_count + 1,), the first one is not used. */
static ttc_angle_relation relate(ttc_valuation *v, long *multiples, fmpq *quarters, const ttc_ratio *angle)
{
    ttc_angle_relation relation = TTC_ANGLE_FREE;
    const size_t count = v->basis_count;
    const bool has_turn = has_pi(v);
    ttc_ratio *angles = calloc(count + 1, sizeof *angles);
    if (angles == NULL) {
        ttc_ring_fail(v->ring, TTC_RING_NO_MEMORY);
        return relation;
    }
    for (size_t i = 0; i <= count; i++) {
        ttc_ratio_init(v->ring, angles + i);
        if (i > 0) ttc_evaluate(v, angles + i, v->model->symbols[v->basis[i - 1]].definition);
    }
    if (has_turn) set_quarter_turn(v, angles);
    if (v->ring->status == TTC_RING_OK)
        relation = has_turn ? ttc_angle_relate(v->ring, multiples, quarters, angle, angles, count + 1)
                            : ttc_angle_relate(v->ring, multiples + 1, NULL, angle, angles + 1, count);
    for (size_t i = 0; i <= count; i++) ttc_ratio_clear(v->ring, angles + i);
    free(angles);
    return relation;
}

/* Add a cosine to the basis, and classify it; its sine is a generator over it. */
static void join(ttc_valuation *v, uint32_t cosine, const ttc_ratio *angle)
{
    v->ring->trust[v->variable[cosine]] = (unsigned char)ttc_valuation_trust(v, angle, v->basis, v->basis_count);
    v->basis[v->basis_count++] = cosine;
}

static bool is_angle(ttc_symbol_kind kind) { return kind == TTC_COSINE || kind == TTC_SINE; }

/* The table's angles that contain no cosines and sines themselves; the others join the basis when they are evaluated. Their number
 * is bounded, since the cost of comparing them is cubic. */
static size_t plain_angles(ttc_valuation *v, uint32_t *cosines)
{
    const ttc_model *model = v->model;
    size_t count = 0;
    for (uint32_t i = 0; i < model->symbol_count; i++) {
        const ttc_symbol_entry *entry = &model->symbols[i];
        if (entry->kind != TTC_COSINE) continue;
        unsigned char *support = ttc_model_support(model, &entry->definition, 1);
        bool plain = support != NULL;
        if (support == NULL) ttc_ring_fail(v->ring, TTC_RING_NO_MEMORY);
        for (uint32_t k = 0; plain && k < model->symbol_count; k++) plain = !support[k] || !is_angle(model->symbols[k].kind);
        free(support);
        if (plain && ttc_valuation_may_join(v, i)) cosines[count++] = i;
        if (count > TTC_ANGLE_LIMIT) ttc_ring_fail(v->ring, TTC_RING_MANY_ANGLES);
        if (v->ring->status != TTC_RING_OK) return 0;
    }
    return count;
}

/* ttc_angle_choose with the quarter turn, if the table uses pi, before the fixed angles; it is not among those returned. */
static size_t choose(ttc_valuation *v, size_t *chosen, const ttc_ratio *angles, size_t count, size_t fixed)
{
    ttc_ratio all[TTC_ANGLE_LIMIT], turn; /* entries of `all` are shallow copies */
    size_t found = 0;
    if (!has_pi(v)) return ttc_angle_choose(v->ring, chosen, angles, count, fixed, false);
    ttc_ratio_init(v->ring, &turn);
    set_quarter_turn(v, &turn);
    for (size_t i = 0; i <= count; i++) all[i] = i == 0 ? turn : angles[i - 1];
    size_t total = ttc_angle_choose(v->ring, chosen, all, count + 1, fixed + 1, true);
    for (size_t i = 0; i < total; i++)
        if (chosen[i] != 0) chosen[found++] = chosen[i] - 1;
    ttc_ratio_clear(v->ring, &turn);
    return found;
}

static void find_basis(ttc_valuation *v)
{
    uint32_t *cosines = calloc(v->model->symbol_count + 1, sizeof *cosines);
    ttc_ratio angles[TTC_ANGLE_LIMIT];
    size_t chosen[TTC_ANGLE_LIMIT], count = 0, fixed = 0, found = 0;

    v->has_basis = true;
    if (cosines == NULL) ttc_ring_fail(v->ring, TTC_RING_NO_MEMORY);
    else count = plain_angles(v, cosines);
    for (size_t i = 0; i < count; i++) {
        ttc_ratio_init(v->ring, angles + i);
        ttc_evaluate(v, angles + i, v->model->symbols[cosines[i]].definition);
    }
    /* Angles in the basis at this point were used by the expression of a bound state; they are fixed, and keep their variables. */
    for (size_t i = 0; i < count; i++) {
        if (!in_basis(v, cosines[i])) continue;
        const uint32_t cosine = cosines[fixed];
        const ttc_ratio angle = angles[fixed];
        cosines[fixed] = cosines[i];
        angles[fixed++] = angles[i];
        cosines[i] = cosine;
        angles[i] = angle;
    }
    if (fixed < v->basis_count) ttc_ring_fail(v->ring, TTC_RING_ANGLE);
    if (has_pi(v) && count == TTC_ANGLE_LIMIT) ttc_ring_fail(v->ring, TTC_RING_MANY_ANGLES);
    if (v->ring->status == TTC_RING_OK) found = choose(v, chosen, angles, count, fixed);
    for (size_t i = 0; i < found; i++)
        if (!in_basis(v, cosines[chosen[i]])) join(v, cosines[chosen[i]], &angles[chosen[i]]);
    v->has_basis = v->ring->status == TTC_RING_OK;
    for (size_t i = 0; i < count; i++) ttc_ratio_clear(v->ring, angles + i);
    free(cosines);
}

/* cos or sin of the sum of these quarter turns and multiples of the basis, of which the first one is not used */
static void sum_of_angles(ttc_valuation *v, ttc_ratio *out, const fmpq_t quarters, const long *multiples, size_t count,
                          bool is_sine)
{
    ttc_ratio cosine, sine, c, s;
    ttc_ratio_init(v->ring, &cosine);
    ttc_ratio_init(v->ring, &sine);
    ttc_ratio_init(v->ring, &c);
    ttc_ratio_init(v->ring, &s);
    ttc_ratio_set_integer(v->ring, &cosine, 1);
    ttc_angle_turn_exactly(v->ring, &cosine, &sine, quarters);
    for (size_t i = 0; i < count; i++) {
        if (multiples[i + 1] == 0) continue;
        ttc_valuation_value(v, &c, v->basis[i]);
        ttc_valuation_value(v, &s, v->model->symbols[v->basis[i]].partner);
        ttc_angle_turn(v->ring, &cosine, &sine, &c, &s, multiples[i + 1]);
    }
    ttc_ratio_set(v->ring, out, is_sine ? &sine : &cosine);
    ttc_ratio_clear(v->ring, &s);
    ttc_ratio_clear(v->ring, &c);
    ttc_ratio_clear(v->ring, &sine);
    ttc_ratio_clear(v->ring, &cosine);
}

/* cos or sin of an angle in a plain valuation. cosine: the one that joins the basis if the angle is independent, or NO_SYMBOL. */
static void value_at_angle(ttc_valuation *v, ttc_ratio *out, const ttc_ratio *angle, bool is_sine, uint32_t cosine)
{
    if (!v->has_basis) find_basis(v);
    const size_t count = v->basis_count;
    long *multiples = calloc(count + 1, sizeof *multiples);
    fmpq_t quarters;
    fmpq_init(quarters);
    if (multiples == NULL) ttc_ring_fail(v->ring, TTC_RING_NO_MEMORY);
    ttc_angle_relation relation = v->ring->status == TTC_RING_OK ? relate(v, multiples, quarters, angle) : TTC_ANGLE_FREE;
    if (v->ring->status != TTC_RING_OK) goto done;
    if (relation == TTC_ANGLE_WHOLE) sum_of_angles(v, out, quarters, multiples, count, is_sine);
    else if (relation == TTC_ANGLE_FRACTION) ttc_ring_fail(v->ring, TTC_RING_ANGLE_FRACTION);
    else if (cosine != NO_SYMBOL) join(v, cosine, angle);
    else if (ttc_valuation_meet(v)) value_at_angle(v, out, angle, is_sine, cosine);
    else ttc_ring_fail(v->ring, TTC_RING_ANGLE);
done:
    fmpq_clear(quarters);
    free(multiples);
}

void ttc_valuation_angle(ttc_valuation *v, ttc_ratio *out, const ttc_ratio *angle, bool is_sine)
{
    value_at_angle(v, out, angle, is_sine, NO_SYMBOL);
}

/* Before the sine of a bound cosine, evaluate those of unbound ones. 1 - cos^2 may be the same for both: the first sine becomes a
 * generator, the other is plus or minus it by a choice. An unbound one must be first, as its angle gives its sign. */
static void meet_free_sines(ttc_valuation *v, uint32_t cosine)
{
    ttc_ratio sine;
    if (!ttc_valuation_is_bound(v, cosine)) return;
    ttc_ratio_init(v->ring, &sine);
    for (size_t i = 0; i < v->basis_count && v->ring->status == TTC_RING_OK; i++)
        if (!ttc_valuation_is_bound(v, v->basis[i])) ttc_valuation_value(v, &sine, v->model->symbols[v->basis[i]].partner);
    ttc_ratio_clear(v->ring, &sine);
}

/* The cosine of an angle in the basis is a free variable, and its sine a square root of 1 - cos^2. */
void ttc_valuation_angle_value(ttc_valuation *v, ttc_ratio *out, uint32_t symbol)
{
    const ttc_symbol_entry *entry = &v->model->symbols[symbol];
    const bool is_sine = entry->kind == TTC_SINE;
    const uint32_t cosine = is_sine ? entry->partner : symbol;
    ttc_ratio angle, one;
    ttc_ratio_init(v->ring, &angle);
    ttc_ratio_init(v->ring, &one);
    ttc_evaluate(v, &angle, entry->definition);
    if (v->base != NULL) {
        ttc_valuation_angle(ttc_valuation_plain(v), out, &angle, is_sine);
        goto done;
    }
    if (!v->has_basis) find_basis(v);
    if (!in_basis(v, cosine)) value_at_angle(v, out, &angle, is_sine, cosine);
    if (!in_basis(v, cosine)) goto done;
    if (is_sine) {
        ttc_valuation_value(v, out, cosine); /* not always its variable: a zero level may have bound it */
        meet_free_sines(v, cosine);
        ttc_ratio_multiply(v->ring, out, out, out);
        ttc_ratio_set_integer(v->ring, &one, 1);
        ttc_ratio_subtract(v->ring, &angle, &one, out);
        ttc_ring_root(v->ring, out, &angle, v->variable[symbol], false);
    } else {
        ttc_ratio_set_variable(v->ring, out, v->variable[cosine]);
    }
done:
    ttc_ratio_clear(v->ring, &one);
    ttc_ratio_clear(v->ring, &angle);
}
