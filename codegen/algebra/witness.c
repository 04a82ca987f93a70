#include "algebra/witness.h"

#include <stdlib.h>
#include <string.h>

enum { FIRST_PRECISION = 128, LAST_PRECISION = 2048 };

struct ttc_witness_balls {
    slong precision;
    size_t count;
    arb_ptr ball;
    fmpq *exact;
    unsigned char *state; /* by variable: UNKNOWN, BUSY, ENCLOSED or EXACT */
};

enum { UNKNOWN, BUSY, ENCLOSED, EXACT };

bool ttc_witness_init(ttc_witness *point, ttc_valuation *valuation)
{
    *point = (ttc_witness){ .valuation = valuation, .ring = ttc_valuation_ring(valuation), .wide = -1 };
    size_t count = point->ring->variable_count;
    struct ttc_witness_balls *balls = calloc(1, sizeof *balls);
    point->values = calloc(count + 1, sizeof *point->values);
    point->balls = balls;
    if (balls == NULL || point->values == NULL) return false;
    balls->exact = calloc(count + 1, sizeof *balls->exact);
    balls->state = calloc(count + 1, 1);
    point->angles = calloc(count + 1, sizeof *point->angles);
    if (balls->exact == NULL || balls->state == NULL || point->angles == NULL) return false;
    for (size_t i = 0; i < count; i++) {
        fmpq_init(point->values + i);
        fmpq_init(balls->exact + i);
    }
    balls->precision = FIRST_PRECISION;
    balls->ball = _arb_vec_init((slong)count);
    balls->count = count;
    ttc_witness_find_angles(point);
    return true;
}

void ttc_witness_clear(ttc_witness *point)
{
    struct ttc_witness_balls *balls = point->balls;
    if (balls != NULL) {
        if (balls->count > 0) {
            _arb_vec_clear(balls->ball, (slong)balls->count);
            for (size_t i = 0; i < balls->count; i++) {
                fmpq_clear(balls->exact + i);
                fmpq_clear(point->values + i);
            }
        }
        free(balls->exact);
        free(balls->state);
        free(balls);
    }
    free(point->angles);
    free(point->values);
    *point = (ttc_witness){ .valuation = NULL };
}

void ttc_witness_changed(ttc_witness *point) { memset(point->balls->state, UNKNOWN, point->balls->count); }

static ttc_symbol_kind kind_of(const ttc_witness *point, slong variable)
{
    const ttc_model *model = ttc_valuation_model(point->valuation);
    size_t symbol = ttc_valuation_symbol(point->valuation, variable);
    return symbol < model->symbol_count ? model->symbols[symbol].kind : TTC_STATE;
}

bool ttc_witness_is_function(const ttc_witness *point, slong variable)
{
    const ttc_model *model = ttc_valuation_model(point->valuation);
    size_t symbol = ttc_valuation_symbol(point->valuation, variable);
    if (symbol >= model->symbol_count) return false;
    switch (model->symbols[symbol].kind) {
    case TTC_COSINE: return !ttc_valuation_is_bound(point->valuation, (uint32_t)symbol);
    case TTC_EXP:
    case TTC_LOG:
    case TTC_PI: return true;
    case TTC_SINE: return !ttc_valuation_is_bound(point->valuation, model->symbols[symbol].partner);
    default: return false;
    }
}

bool ttc_witness_is_free(const ttc_witness *point, slong variable)
{
    return ttc_ring_generator(point->ring, variable) == NULL && !ttc_witness_is_function(point, variable)
           && point->angles[variable] == 0;
}

static void enclose_variable(ttc_witness *point, slong variable, slong precision);

static void enclose_polynomial(arb_t out, ttc_witness *point, const fmpz_mpoly_t polynomial, slong precision)
{
    const fmpz_mpoly_ctx_struct *context = point->ring->context;
    arb_t term, factor;
    fmpz_t coefficient;
    arb_init(term);
    arb_init(factor);
    fmpz_init(coefficient);
    arb_zero(out);
    for (slong i = 0; i < fmpz_mpoly_length(polynomial, context); i++) {
        fmpz_mpoly_get_term_coeff_fmpz(coefficient, polynomial, i, context);
        arb_set_fmpz(term, coefficient);
        for (slong v = 0; v < (slong)point->ring->variable_count; v++) {
            ulong exponent = fmpz_mpoly_get_term_var_exp_ui(polynomial, i, v, context);
            if (exponent == 0) continue;
            enclose_variable(point, v, precision);
            arb_pow_ui(factor, point->balls->ball + v, exponent, precision);
            arb_mul(term, term, factor, precision);
        }
        arb_add(out, out, term, precision);
    }
    fmpz_clear(coefficient);
    arb_clear(factor);
    arb_clear(term);
}

/* Returns false if some variable is not known to be rational, or powers are too large. */
static bool exact_polynomial(fmpq_t out, ttc_witness *point, const fmpz_mpoly_t polynomial)
{
    const fmpz_mpoly_ctx_struct *context = point->ring->context;
    bool exact = true;
    fmpq_t term, factor;
    fmpq_init(term);
    fmpq_init(factor);
    fmpq_zero(out);
    for (slong i = 0; exact && i < fmpz_mpoly_length(polynomial, context); i++) {
        fmpq_one(term);
        fmpz_mpoly_get_term_coeff_fmpz(fmpq_numref(term), polynomial, i, context);
        for (slong v = 0; exact && v < (slong)point->ring->variable_count; v++) {
            ulong exponent = fmpz_mpoly_get_term_var_exp_ui(polynomial, i, v, context);
            if (exponent == 0) continue;
            enclose_variable(point, v, point->balls->precision);
            exact = point->balls->state[v] == EXACT
                    && (slong)exponent * (slong)fmpq_height_bits(point->balls->exact + v) < (1 << 20);
            if (!exact) break;
            fmpq_pow_si(factor, point->balls->exact + v, (slong)exponent);
            fmpq_mul(term, term, factor);
        }
        fmpq_add(out, out, term);
    }
    fmpq_clear(factor);
    fmpq_clear(term);
    return exact;
}

static bool exact_ratio(fmpq_t out, ttc_witness *point, const ttc_ratio *ratio)
{
    fmpq_t bottom;
    fmpq_init(bottom);
    bool exact = exact_polynomial(out, point, ratio->numerator) && exact_polynomial(bottom, point, ratio->denominator)
                 && !fmpq_is_zero(bottom);
    if (exact) fmpq_div(out, out, bottom);
    fmpq_clear(bottom);
    return exact;
}

void ttc_witness_enclose(arb_t out, ttc_witness *point, const ttc_ratio *ratio, slong precision)
{
    arb_t bottom;
    if (point->balls->precision != precision) {
        ttc_witness_changed(point);
        point->balls->precision = precision;
    }
    arb_init(bottom);
    enclose_polynomial(out, point, ratio->numerator, precision);
    enclose_polynomial(bottom, point, ratio->denominator, precision);
    arb_div(out, out, bottom, precision);
    arb_clear(bottom);
}

static void enclose_root(ttc_witness *point, slong variable, const ttc_generator *generator, slong precision)
{
    struct ttc_witness_balls *balls = point->balls;
    bool negative = !generator->positive && (point->negative >> (generator - point->ring->generators) & 1);
    ttc_witness_enclose(balls->ball + variable, point, &generator->square, precision);
    if (exact_ratio(balls->exact + variable, point, &generator->square)
        && ttc_symbol_rational(balls->exact + variable, TTC_ROOT, balls->exact + variable)) {
        if (negative) fmpq_neg(balls->exact + variable, balls->exact + variable);
        arb_set_fmpq(balls->ball + variable, balls->exact + variable, precision);
        balls->state[variable] = EXACT;
        return;
    }
    arb_sqrt(balls->ball + variable, balls->ball + variable, precision);
    if (negative) arb_neg(balls->ball + variable, balls->ball + variable);
    balls->state[variable] = ENCLOSED;
}

static void enclose_function(ttc_witness *point, slong variable, ttc_symbol_kind kind, slong precision)
{
    const ttc_model *model = ttc_valuation_model(point->valuation);
    struct ttc_witness_balls *balls = point->balls;
    ttc_ratio argument;
    if (kind == TTC_PI) {
        arb_const_pi(balls->ball + variable, precision);
        balls->state[variable] = ENCLOSED;
        return;
    }
    ttc_ratio_init(point->ring, &argument);
    ttc_evaluate(point->valuation, &argument, model->symbols[ttc_valuation_symbol(point->valuation, variable)].definition);
    ttc_witness_enclose(balls->ball + variable, point, &argument, precision);
    if (kind == TTC_COSINE) arb_cos(balls->ball + variable, balls->ball + variable, precision);
    else if (kind == TTC_EXP) arb_exp(balls->ball + variable, balls->ball + variable, precision);
    else if (kind == TTC_LOG) arb_log(balls->ball + variable, balls->ball + variable, precision);
    else arb_sin(balls->ball + variable, balls->ball + variable, precision);
    /* At one rational argument the value is rational: exp(0), cos(0), sin(0), log(1). */
    fmpq *value = balls->exact + variable;
    const bool exact = exact_ratio(value, point, &argument) && (kind == TTC_LOG ? fmpq_is_one(value) : fmpq_is_zero(value));
    if (exact) fmpq_set_si(value, kind == TTC_EXP || kind == TTC_COSINE, 1);
    if (exact) arb_set_fmpq(balls->ball + variable, value, precision);
    ttc_ratio_clear(point->ring, &argument);
    balls->state[variable] = exact ? EXACT : ENCLOSED;
}

/* Enclose a variable v that the angle k v + rest tells: v = (atan2(sine, cosine) - rest)/k, with turns. */
static void enclose_told(ttc_witness *point, slong variable, slong precision)
{
    const ttc_model *model = ttc_valuation_model(point->valuation);
    const ttc_symbol_entry *cosine = &model->symbols[point->angles[variable]];
    arb_ptr out = point->balls->ball + variable;
    ttc_ratio value;
    fmpq_t slope;
    arb_t term;
    ttc_ratio_init(point->ring, &value);
    fmpq_init(slope);
    arb_init(term);
    ttc_evaluate(point->valuation, &value, cosine->node);
    ttc_witness_enclose(term, point, &value, precision);
    ttc_evaluate(point->valuation, &value, model->symbols[cosine->partner].node);
    ttc_witness_enclose(out, point, &value, precision);
    arb_atan2(out, out, term, precision);
    ttc_witness_split_angle(slope, &value, point, variable);
    ttc_witness_enclose(term, point, &value, precision);
    arb_sub(out, out, term, precision);
    arb_mul_fmpz(out, out, fmpq_denref(slope), precision);
    arb_div_fmpz(out, out, fmpq_numref(slope), precision);
    ttc_witness_add_turns(out, slope, model, ttc_valuation_symbol(point->valuation, variable), precision);
    point->balls->state[variable] = ENCLOSED;
    arb_clear(term);
    fmpq_clear(slope);
    ttc_ratio_clear(point->ring, &value);
}

static void enclose_variable(ttc_witness *point, slong variable, slong precision)
{
    struct ttc_witness_balls *balls = point->balls;
    if (balls->state[variable] == BUSY) arb_indeterminate(balls->ball + variable);
    if (balls->state[variable] != UNKNOWN) return;
    balls->state[variable] = BUSY;
    const ttc_generator *root = ttc_ring_generator(point->ring, variable);
    if (ttc_witness_is_function(point, variable)) {
        enclose_function(point, variable, kind_of(point, variable), precision);
    } else if (point->angles[variable] != 0) {
        enclose_told(point, variable, precision);
    } else if (root != NULL) {
        enclose_root(point, variable, root, precision);
    } else {
        fmpq_set(balls->exact + variable, point->values + variable);
        arb_set_fmpq(balls->ball + variable, point->values + variable, precision);
        if (variable == point->wide) arb_add_error_2exp_si(balls->ball + variable, TTC_WITNESS_WIDTH);
        balls->state[variable] = variable == point->wide ? ENCLOSED : EXACT;
    }
}

static ttc_truth truth_of_sign(int sign, ttc_relation relation)
{
    switch (relation) {
    case TTC_IS_POSITIVE: return sign > 0 ? TTC_HOLDS : TTC_FAILS;
    case TTC_IS_NONNEGATIVE: return sign >= 0 ? TTC_HOLDS : TTC_FAILS;
    case TTC_IS_NONZERO: return sign != 0 ? TTC_HOLDS : TTC_FAILS;
    case TTC_IS_ZERO: break;
    }
    return sign == 0 ? TTC_HOLDS : TTC_FAILS;
}

static ttc_truth meets(ttc_witness *point, const ttc_condition *condition)
{
    ttc_truth truth = TTC_UNCLEAR;
    arb_t ball;
    fmpq_t value;
    arb_init(ball);
    fmpq_init(value);
    for (slong precision = FIRST_PRECISION; truth == TTC_UNCLEAR && precision <= LAST_PRECISION; precision *= 4) {
        if (point->balls->precision != precision) {
            ttc_witness_changed(point);
            point->balls->precision = precision;
        }
        enclose_polynomial(ball, point, condition->polynomial, precision);
        if (!arb_is_finite(ball)) break; /* a radicand may be negative */
        if (arb_is_positive(ball)) truth = truth_of_sign(1, condition->relation);
        else if (arb_is_negative(ball)) truth = truth_of_sign(-1, condition->relation);
        else if (arb_is_zero(ball)) truth = truth_of_sign(0, condition->relation); /* of functions as well: cos(0) - 1 */
        else if (exact_polynomial(value, point, condition->polynomial))
            truth = truth_of_sign(fmpq_sgn(value), condition->relation);
    }
    fmpq_clear(value);
    arb_clear(ball);
    return truth;
}

/* Radicands of all generators must be positive, or not negative, whether or not a condition uses them. */
static ttc_truth roots_are_real(ttc_witness *point)
{
    ttc_truth truth = TTC_HOLDS;
    ttc_conditions c;
    ttc_conditions_init(&c, point->valuation);
    for (size_t i = 0; i < point->ring->generator_count; i++) {
        const ttc_generator *generator = &point->ring->generators[i];
        if (ttc_witness_is_function(point, generator->variable)) continue;
        ttc_conditions_add(&c, &generator->square, generator->positive ? TTC_IS_POSITIVE : TTC_IS_NONNEGATIVE);
    }
    if (c.contradictory) truth = TTC_FAILS;
    for (size_t i = 0; truth == TTC_HOLDS && i < c.count; i++) truth = meets(point, &c.items[i]);
    if (c.failed) truth = TTC_UNCLEAR;
    ttc_conditions_clear(&c);
    return truth;
}

/* Check the signs that are known of states and parameters, also of those that an angle tells: conditions omit them. */
static ttc_truth values_have_their_signs(ttc_witness *point, const ttc_conditions *conditions)
{
    ttc_truth truth = TTC_HOLDS;
    ttc_ratio variable;
    arb_t ball;
    ttc_ratio_init(point->ring, &variable);
    arb_init(ball);
    for (slong v = 0; truth != TTC_FAILS && v < (slong)point->ring->variable_count; v++) {
        const ttc_symbol_kind kind = kind_of(point, v);
        if (point->angles[v] == 0 && (!ttc_witness_is_free(point, v) || (kind != TTC_STATE && kind != TTC_PARAM))) continue;
        ttc_ratio_set_variable(point->ring, &variable, v);
        const unsigned signs = ttc_conditions_signs(conditions, variable.numerator);
        ttc_witness_enclose(ball, point, &variable, FIRST_PRECISION);
        const bool may_be_zero = arb_contains_zero(ball) && !arb_is_zero(ball);
        const unsigned nonzero = arb_is_positive(ball) ? TTC_CAN_BE_POSITIVE : TTC_CAN_BE_NEGATIVE;
        if (signs != TTC_CAN_BE_ANY && may_be_zero) truth = TTC_UNCLEAR;
        else if (!may_be_zero && !(signs & (arb_is_zero(ball) ? (unsigned)TTC_CAN_BE_ZERO : nonzero))) truth = TTC_FAILS;
    }
    arb_clear(ball);
    ttc_ratio_clear(point->ring, &variable);
    return truth;
}

/* Bound symbols must have values: where a denominator of their normal form vanishes, it is not known that any value meets the
 * levels that bind them. The same holds for the sine of a bound cosine, which is not computed from its angle. */
static ttc_truth bound_values_exist(ttc_witness *point)
{
    ttc_truth truth = TTC_HOLDS;
    ttc_ratio value;
    ttc_ratio_init(point->ring, &value);
    for (uint32_t i = 1; truth == TTC_HOLDS && i < ttc_valuation_model(point->valuation)->symbol_count; i++) {
        const ttc_symbol_entry *entry = &ttc_valuation_model(point->valuation)->symbols[i];
        const uint32_t symbol = entry->kind == TTC_SINE ? entry->partner : i;
        if (!ttc_valuation_is_bound(point->valuation, symbol) || !ttc_valuation_has_value(point->valuation, i)) continue;
        ttc_condition defined = { .relation = TTC_IS_NONZERO };
        ttc_evaluate(point->valuation, &value, entry->node);
        *defined.polynomial = *value.denominator; /* a shallow copy */
        truth = meets(point, &defined);
    }
    ttc_ratio_clear(point->ring, &value);
    return truth == TTC_HOLDS ? TTC_HOLDS : TTC_UNCLEAR;
}

ttc_truth ttc_witness_meets_all(ttc_witness *point, const ttc_conditions *conditions)
{
    if (conditions->contradictory) return TTC_FAILS;
    if (point->has_obscure_angle) return TTC_UNCLEAR;
    ttc_truth truth = roots_are_real(point);
    if (truth == TTC_HOLDS) truth = values_have_their_signs(point, conditions);
    for (size_t i = 0; truth != TTC_FAILS && i < conditions->count; i++) {
        ttc_truth one = meets(point, &conditions->items[i]);
        if (one != TTC_HOLDS) truth = one;
    }
    return truth == TTC_HOLDS ? bound_values_exist(point) : truth;
}

bool ttc_witness_coordinate(fmpq_t out, ttc_witness *point, slong variable)
{
    enclose_variable(point, variable, point->balls->precision);
    if (point->balls->state[variable] != EXACT) return false;
    fmpq_set(out, point->balls->exact + variable);
    return true;
}
