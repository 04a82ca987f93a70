/* Signs of numbers, of polynomials in one state, and on pieces of one state's interval. Nothing of the domain is used but this
 * interval: what is shown holds on all of it. */
#include "prove/one_state.h"

#include "ball/ball.h"
#include "prove/subcase.h"

#include <flint/fmpq_poly.h>
#include <flint/fmpz_poly.h>

#include <stdlib.h>

enum { PRECISION = 256, PIECES = 400, DIVISIONS = 48, DERIVATIVES = 6, FAR = 16, FARTHEST = 9, NODES = 100000, WORK = 20000 };

/* An open piece of the interval; `known` says which of its ends, 0 and 1, are numbers. */
typedef struct {
    fmpq_t end[2];
    bool known[2];
} piece;

typedef struct {
    ttc_task *task;
    ttc_valuation *valuation;
    const ttc_model *model;
    ttc_ball *ball;
    uint32_t symbol; /* the state, and its number */
    size_t state;
    bool has_root; /* or angle: a normal form may hold only on a part of the interval, or bring another function into the ring */
    unsigned pieces, work; /* numbers of pieces, and of expressions on pieces, that may still be examined */
    ttc_state_value *negative;
} one_state;

static unsigned signs_on(one_state *s, ttc_id id, const piece *p, unsigned derivatives);

/* The signs of an expression, by a ball, for all values of the state from low to high, both included. */
static unsigned signs_between(one_state *s, ttc_id id, const fmpq_t low, const fmpq_t high)
{
    unsigned signs = TTC_CAN_BE_ANY;
    arb_t value, end;
    arb_init(value);
    arb_init(end);
    arb_set_fmpq(value, low, PRECISION);
    arb_set_fmpq(end, high, PRECISION);
    arb_union(value, value, end, PRECISION);
    ttc_ball_set_ball(s->ball, s->symbol, value);
    if (ttc_ball_value(value, s->ball, id)) {
        if (arb_is_nonnegative(value)) signs &= ~(unsigned)TTC_CAN_BE_NEGATIVE;
        if (arb_is_nonpositive(value)) signs &= ~(unsigned)TTC_CAN_BE_POSITIVE;
        if (!arb_contains_zero(value)) signs &= ~(unsigned)TTC_CAN_BE_ZERO;
    }
    arb_clear(end);
    arb_clear(value);
    return signs;
}

/* Whether an expression is smooth on a piece: nothing by which it divides is zero there, no radicand or argument of a logarithm
 * other than positive. */
static bool is_smooth(one_state *s, ttc_id id, const piece *p, unsigned derivatives)
{
    const ttc_graph *graph = s->model->graph;
    bool smooth = true;
    if (ttc_kind_of(graph, id) == TTC_SYMBOL) {
        const ttc_symbol_entry *entry = s->model->symbols + ttc_symbol_of(graph, id);
        if (entry->definition == TTC_NONE) return true;
        const bool is_bounded = entry->kind == TTC_ROOT || entry->kind == TTC_LOG;
        return is_smooth(s, entry->definition, p, derivatives) &&
               (!is_bounded || signs_on(s, entry->definition, p, derivatives) == TTC_CAN_BE_POSITIVE);
    }
    for (size_t i = 0; smooth && i < ttc_part_count(graph, id); i++) {
        const ttc_part part = ttc_part_at(graph, id, i);
        smooth = is_smooth(s, part.id, p, derivatives);
        if (smooth && ttc_kind_of(graph, id) == TTC_PRODUCT && part.exponent < 0)
            smooth = !(signs_on(s, part.id, p, derivatives) & TTC_CAN_BE_ZERO);
    }
    return smooth;
}

/* The signs of a polynomial, by its factors. */
static unsigned signs_of_factors(one_state *s, const fmpz_mpoly_t polynomial, const piece *p, unsigned derivatives)
{
    enum { LONGEST = 64 };
    const fmpz_mpoly_ctx_struct *context = s->task->ring->context;
    unsigned signs = TTC_CAN_BE_ANY;
    fmpz_mpoly_factor_t factors;
    if (fmpz_mpoly_is_zero(polynomial, context)) return TTC_CAN_BE_ZERO;
    if (fmpz_mpoly_length(polynomial, context) > LONGEST) return signs;
    fmpz_mpoly_factor_init(factors, context);
    if (fmpz_mpoly_factor(factors, polynomial, context)) {
        signs = fmpz_sgn(factors->constant) > 0 ? TTC_CAN_BE_POSITIVE : TTC_CAN_BE_NEGATIVE;
        for (slong i = 0; i < factors->num; i++) {
            const unsigned own = signs_on(s, ttc_task_expression(s->task, factors->poly + i), p, derivatives);
            signs = ttc_conditions_signs_of_product(signs, ttc_conditions_signs_of_power(own, fmpz_get_ui(factors->exp + i)));
        }
    }
    fmpz_mpoly_factor_clear(factors, context);
    return signs;
}

/* The signs of an expression by its normal form. */
static unsigned signs_in_normal_form(one_state *s, ttc_id id, const piece *p, unsigned derivatives)
{
    unsigned signs = TTC_CAN_BE_ANY;
    ttc_ratio value;
    if (s->has_root || s->valuation != s->task->field || s->work == 0) return signs;
    ttc_ratio_init(s->task->ring, &value);
    ttc_evaluate(s->valuation, &value, id);
    const bool good = s->task->ring->status == TTC_RING_OK;
    const unsigned below = good ? signs_of_factors(s, value.denominator, p, derivatives) : TTC_CAN_BE_ANY;
    if (!(below & TTC_CAN_BE_ZERO))
        signs = ttc_conditions_signs_of_product(signs_of_factors(s, value.numerator, p, derivatives), below);
    ttc_ratio_clear(s->task->ring, &value);
    return signs;
}

/* The signs of an expression by those of its derivative: one that grows on the open piece is positive if it is not negative at the
 * lower end, and so for the other sign, for one that falls, and for the upper end. */
static unsigned signs_by_derivative(one_state *s, ttc_id id, const piece *p, unsigned derivatives)
{
    if (derivatives == 0 || !is_smooth(s, id, p, derivatives - 1)) return TTC_CAN_BE_ANY;
    const ttc_id slope = ttc_derive_state(s->model, id, s->state);
    if (slope == TTC_NONE) return TTC_CAN_BE_ANY;
    unsigned slopes = signs_on(s, slope, p, derivatives - 1);
    if (slopes == TTC_CAN_BE_ANY) slopes = signs_in_normal_form(s, slope, p, derivatives - 1);
    for (int end = 0; end < 2; end++) {
        const unsigned away = end == 0 ? slopes : ttc_conditions_signs_of_product(slopes, TTC_CAN_BE_NEGATIVE);
        const unsigned start = p->known[end] ? signs_between(s, id, p->end[end], p->end[end]) : TTC_CAN_BE_ANY;
        if (away == TTC_CAN_BE_POSITIVE && !(start & TTC_CAN_BE_NEGATIVE)) return TTC_CAN_BE_POSITIVE;
        if (away == TTC_CAN_BE_NEGATIVE && !(start & TTC_CAN_BE_POSITIVE)) return TTC_CAN_BE_NEGATIVE;
    }
    return TTC_CAN_BE_ANY;
}

static unsigned signs_of_symbol(one_state *s, uint32_t symbol, const piece *p, unsigned derivatives)
{
    const ttc_symbol_entry *entry = s->model->symbols + symbol;
    if (symbol == s->symbol) {
        if (p->known[0] && fmpq_sgn(p->end[0]) >= 0) return TTC_CAN_BE_POSITIVE;
        return p->known[1] && fmpq_sgn(p->end[1]) <= 0 ? TTC_CAN_BE_NEGATIVE : TTC_CAN_BE_ANY;
    }
    if (entry->kind == TTC_EXP || entry->kind == TTC_PI) return TTC_CAN_BE_POSITIVE;
    if (entry->kind == TTC_LET || entry->kind == TTC_ROOT) return signs_on(s, entry->definition, p, derivatives);
    if (entry->kind == TTC_LOG)
        return signs_on(s, ttc_subtract(s->model->graph, entry->definition, ttc_integer(s->model->graph, 1)), p, derivatives);
    return signs_by_derivative(s, entry->node, p, derivatives);
}

static unsigned signs_of_parts(one_state *s, ttc_id id, const piece *p, unsigned derivatives)
{
    const ttc_graph *graph = s->model->graph;
    const bool is_sum = ttc_kind_of(graph, id) == TTC_SUM;
    unsigned signs = ttc_conditions_sign_of(ttc_coefficient(graph, id));
    for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
        const ttc_part part = ttc_part_at(graph, id, i);
        const unsigned own = signs_on(s, part.id, p, derivatives);
        const unsigned weight = ttc_conditions_sign_of(part.coefficient);
        if (is_sum) signs = ttc_conditions_signs_of_sum(signs, ttc_conditions_signs_of_product(weight, own));
        else if (part.exponent < 0 && (own & TTC_CAN_BE_ZERO)) return TTC_CAN_BE_ANY;
        else signs = ttc_conditions_signs_of_product(signs, ttc_conditions_signs_of_power(own, (unsigned long)labs(part.exponent)));
    }
    return signs;
}

static unsigned signs_on(one_state *s, ttc_id id, const piece *p, unsigned derivatives)
{
    unsigned signs = TTC_CAN_BE_ANY;
    if (id == TTC_NONE || s->work == 0) return signs;
    s->work--;
    const ttc_kind kind = ttc_kind_of(s->model->graph, id);
    if (kind == TTC_NUMBER) return ttc_conditions_sign_of(ttc_coefficient(s->model->graph, id));
    if (p->known[0] && p->known[1]) signs = signs_between(s, id, p->end[0], p->end[1]);
    if (signs != TTC_CAN_BE_ANY) return signs;
    if (kind == TTC_SYMBOL) return signs_of_symbol(s, ttc_symbol_of(s->model->graph, id), p, derivatives);
    signs = signs_of_parts(s, id, p, derivatives);
    return signs == TTC_CAN_BE_ANY && kind == TTC_SUM ? signs_by_derivative(s, id, p, derivatives) : signs;
}

/* A number inside of a piece: its middle, or far from its only end, or 0. */
static void set_inside(fmpq_t out, const piece *p)
{
    fmpq_zero(out);
    if (p->known[0] && p->known[1]) {
        fmpq_add(out, p->end[0], p->end[1]);
        fmpq_div_2exp(out, out, 1);
    } else if (p->known[0] || p->known[1]) {
        const int end = p->known[0] ? 0 : 1;
        fmpq_abs(out, p->end[end]);
        fmpq_add_si(out, out, FAR);
        if (end == 1) fmpq_neg(out, out);
        fmpq_add(out, out, p->end[end]);
    }
}

/* The signs at a number, which is noted if the expression is not positive there. */
static unsigned signs_at(one_state *s, ttc_id id, const fmpq_t number)
{
    const unsigned signs = signs_between(s, id, number, number);
    if (!(signs & TTC_CAN_BE_POSITIVE) && s->negative != NULL && !s->negative->is_known) {
        fmpq_set(s->negative->value, number);
        s->negative->symbol = s->symbol;
        s->negative->is_known = true;
    }
    return signs;
}

/* Whether an expression has the same sign at numbers all over the interval: ever closer to an end, or farther out without one. */
static bool has_sign_at_numbers(one_state *s, ttc_id id, unsigned sign, const piece *p)
{
    static const ulong powers[] = { 1, 2, 3, 4, 6, 9, 13, 19, 28, 42, 63, 95, 142 };
    bool has = true;
    fmpq_t number, length;
    fmpq_init(number);
    fmpq_init(length);
    for (size_t i = 0; has && i < 2 * sizeof powers / sizeof *powers; i++) {
        const int end = i % 2 == 0 ? 0 : 1;
        fmpq_one(length);
        if (p->known[0] && p->known[1]) fmpq_sub(length, p->end[1], p->end[0]);
        fmpq_div_2exp(length, length, powers[i / 2]);
        if (!p->known[end]) fmpq_inv(length, length);
        if (!p->known[end] && powers[i / 2] > FARTHEST) continue;
        if (p->known[end]) fmpq_set(number, p->end[end]);
        else if (p->known[1 - end]) fmpq_set(number, p->end[1 - end]);
        else fmpq_zero(number);
        const bool upwards = p->known[end] ? end == 0 : end == 1;
        if (upwards) fmpq_add(number, number, length);
        else fmpq_sub(number, number, length);
        has = (signs_at(s, id, number) & sign) != 0;
    }
    fmpq_clear(length);
    fmpq_clear(number);
    return has;
}

/* Whether an expression is of one sign on a piece, which is divided as often as needed. */
static bool has_sign(one_state *s, ttc_id id, unsigned sign, const piece *p, unsigned divisions)
{
    fmpq_t inside;
    if (s->pieces == 0) return false;
    s->pieces--;
    if (signs_on(s, id, p, DERIVATIVES) == sign) return true;
    if (divisions == 0) return false;
    fmpq_init(inside);
    set_inside(inside, p);
    bool has = signs_at(s, id, inside) == sign;
    for (int end = 0; has && end < 2; end++) {
        piece part = *p; /* which borrows its ends */
        part.known[end] = true;
        *part.end[end] = *inside;
        has = has_sign(s, id, sign, &part, divisions - 1);
    }
    fmpq_clear(inside);
    return has;
}

/* The number of zeros of a polynomial, which has no double ones, from this number on, upwards or downwards, it included. */
static slong count_zeros_from(const fmpz_poly_t polynomial, const fmpq_t number, bool upwards)
{
    slong zeros = 0, below = 0, above = 0;
    fmpq_poly_t shifted, place;
    fmpq_poly_init(shifted);
    fmpq_poly_init(place); /* x + number */
    fmpq_poly_set_coeff_fmpq(place, 0, number);
    fmpq_poly_set_coeff_si(place, 1, 1);
    fmpq_poly_set_fmpz_poly(shifted, polynomial);
    fmpq_poly_compose(shifted, shifted, place);
    if (fmpz_is_zero(shifted->coeffs)) {
        zeros++;
        fmpq_poly_shift_right(shifted, shifted, 1);
    }
    if (shifted->length > 1) _fmpz_poly_num_real_roots_sturm(&below, &above, shifted->coeffs, shifted->length);
    fmpq_poly_clear(place);
    fmpq_poly_clear(shifted);
    return zeros + (upwards ? above : below);
}

/* Whether an expression is a polynomial without a zero inside of a piece: by Sturm's theorem. */
static bool has_no_zero(one_state *s, ttc_id id, const piece *p)
{
    enum { LARGEST = 1 << 14 }; /* in bits, for less than a second */
    const fmpz_mpoly_ctx_struct *context = s->task->ring->context;
    const slong variable = ttc_valuation_variable(s->valuation, s->symbol);
    slong zeros = 1;
    ttc_ratio value;
    fmpz_poly_t polynomial, common;
    if (s->has_root || s->valuation != s->task->field) return false;
    ttc_ratio_init(s->task->ring, &value);
    fmpz_poly_init(polynomial);
    fmpz_poly_init(common);
    ttc_evaluate(s->valuation, &value, id);
    if (s->task->ring->status == TTC_RING_OK && fmpz_mpoly_is_fmpz(value.denominator, context) &&
        fmpz_mpoly_is_fmpz_poly(value.numerator, variable, context) &&
        fmpz_mpoly_get_fmpz_poly(polynomial, value.numerator, variable, context) &&
        fmpz_poly_length(polynomial) > 1 && fmpz_poly_length(polynomial) * labs(fmpz_poly_max_bits(polynomial)) <= LARGEST) {
        fmpz_poly_derivative(common, polynomial);
        fmpz_poly_gcd(common, polynomial, common);
        fmpz_poly_div(polynomial, polynomial, common);
        zeros = fmpz_poly_num_real_roots_sturm(polynomial);
        for (int end = 0; end < 2; end++)
            if (p->known[end]) zeros -= count_zeros_from(polynomial, p->end[end], end == 1);
    }
    fmpz_poly_clear(common);
    fmpz_poly_clear(polynomial);
    ttc_ratio_clear(s->task->ring, &value);
    return zeros == 0;
}

/* An end of the interval; one that is no rational number is moved outwards, and one that depends on parameters left out. */
static void set_end(one_state *s, piece *p, int end, ttc_id given)
{
    arb_t value;
    arf_t bound;
    arb_init(value);
    arf_init(bound);
    p->known[end] = ttc_number_value(s->model->graph, given) != NULL;
    if (p->known[end]) {
        fmpq_set(p->end[end], ttc_number_value(s->model->graph, given));
    } else if (given != TTC_NONE && ttc_ball_value(value, s->ball, given)) {
        if (end == 0) arb_get_lbound_arf(bound, value, PRECISION);
        else arb_get_ubound_arf(bound, value, PRECISION);
        arf_get_fmpq(p->end[end], bound);
        p->known[end] = true;
    }
    arf_clear(bound);
    arb_clear(value);
}

/* Find the one state on which an expression depends, if any. Returns the number of states, SIZE_MAX if it depends on what is no
 * number otherwise. */
static size_t find_state(one_state *s, ttc_id id)
{
    unsigned char *support = ttc_model_support(s->model, &id, 1);
    size_t states = 0;
    bool good = support != NULL;
    for (uint32_t i = 0; good && i < s->model->symbol_count; i++) {
        if (!support[i]) continue;
        const ttc_symbol_kind kind = s->model->symbols[i].kind;
        good = kind != TTC_PARAM && kind != TTC_LEVEL && kind != TTC_LAMBDA && !ttc_valuation_is_bound(s->valuation, i);
        s->has_root |= kind == TTC_ROOT || kind == TTC_COSINE || kind == TTC_SINE;
        if (kind == TTC_STATE) s->symbol = i;
        states += kind == TTC_STATE;
    }
    free(support);
    while (good && states == 1 && s->model->states[s->state] != s->symbol) s->state++;
    return good ? states : SIZE_MAX;
}

static unsigned signs_of_number(one_state *s, ttc_id id)
{
    const int sign = ttc_ball_sign(s->ball, id);
    return sign > 0 ? TTC_CAN_BE_POSITIVE : sign < 0 ? TTC_CAN_BE_NEGATIVE : TTC_CAN_BE_ANY;
}

static unsigned signs_on_interval(one_state *s, ttc_id id)
{
    unsigned signs = TTC_CAN_BE_ANY;
    piece p;
    fmpq_t inside;
    for (int end = 0; end < 2; end++) fmpq_init(p.end[end]);
    fmpq_init(inside);
    set_end(s, &p, 0, s->model->symbols[s->symbol].low);
    set_end(s, &p, 1, s->model->symbols[s->symbol].high);
    set_inside(inside, &p);
    const unsigned there = signs_at(s, id, inside);
    if ((there == TTC_CAN_BE_POSITIVE || there == TTC_CAN_BE_NEGATIVE) && has_sign_at_numbers(s, id, there, &p)
        && (has_sign(s, id, there, &p, DIVISIONS) || has_no_zero(s, id, &p)))
        signs = there;
    fmpq_clear(inside);
    for (int end = 0; end < 2; end++) fmpq_clear(p.end[end]);
    return signs;
}

unsigned ttc_one_state_signs(ttc_task *task, ttc_valuation *valuation, ttc_id id, ttc_state_value *negative)
{
    one_state s = { .task = task, .valuation = valuation, .model = ttc_valuation_model(valuation), .pieces = PIECES, .work = WORK,
                    .negative = negative };
    const ttc_graph_status graph_status = ttc_graph_error(s.model->graph);
    const ttc_ring_status ring_status = task->ring->status;
    const size_t states = ttc_graph_size(s.model->graph) > NODES ? SIZE_MAX : find_state(&s, id);
    if (states > 1 || (s.ball = ttc_ball_create(s.model)) == NULL) return TTC_CAN_BE_ANY;
    const unsigned signs = states == 0 ? signs_of_number(&s, id) : signs_on_interval(&s, id);
    ttc_ball_destroy(s.ball);
    if (graph_status == TTC_GRAPH_OK) ttc_graph_clear_error(s.model->graph);
    task->ring->status = ring_status;
    return signs;
}
