#include "prove/pole_end.h"

static const fmpz_mpoly_ctx_struct *context_of(const ttc_pole_end *end) { return end->task->ring->context; }

void ttc_pole_drop(const ttc_pole_end *end, fmpz_mpoly_t out, const fmpz_mpoly_t polynomial, const bool *roots)
{
    const ttc_ring *ring = end->task->ring;
    fmpz_t zero;
    fmpz_init(zero);
    fmpz_mpoly_set(out, polynomial, ring->context);
    for (size_t i = 0; i < ring->generator_count; i++)
        if (roots[i]) fmpz_mpoly_evaluate_one_fmpz(out, out, ring->generators[i].variable, zero, ring->context);
    fmpz_clear(zero);
}

bool ttc_pole_has_factor(const ttc_pole_end *end, const fmpz_mpoly_t polynomial)
{
    fmpz_mpoly_t quotient;
    fmpz_mpoly_init(quotient, context_of(end));
    const bool has = fmpz_mpoly_divides(quotient, polynomial, end->way, context_of(end));
    fmpz_mpoly_clear(quotient, context_of(end));
    return has;
}

void ttc_pole_put_state(const ttc_pole_end *end, ttc_ratio *out, const fmpz_mpoly_t polynomial)
{
    ttc_ring *ring = end->task->ring;
    fmpz_mpoly_t value, slope;
    ttc_ratio scale;
    fmpz_mpoly_init(value, ring->context);
    fmpz_mpoly_init(slope, ring->context);
    ttc_ratio_init(ring, &scale);
    fmpz_mpoly_derivative(slope, end->way, end->variable, ring->context);
    fmpz_mpoly_neg(slope, slope, ring->context);
    const slong degree = fmpz_mpoly_degree_si(polynomial, end->variable, ring->context);
    if (fmpz_mpoly_resultant(value, polynomial, end->way, end->variable, ring->context)) {
        ttc_ratio_set_polynomial(ring, out, value);
        ttc_ratio_set_polynomial(ring, &scale, slope);
        ttc_ratio_power(ring, &scale, &scale, degree > 0 ? degree : 0);
        ttc_ratio_divide(ring, out, out, &scale);
    } else {
        ttc_ring_fail(ring, TTC_RING_TOO_LARGE);
    }
    ttc_ratio_clear(ring, &scale);
    fmpz_mpoly_clear(slope, ring->context);
    fmpz_mpoly_clear(value, ring->context);
}

/* fixed = the terms of a polynomial that are made of parameters alone, rest = the others. */
static void split(const ttc_pole_end *end, fmpz_mpoly_t fixed, fmpz_mpoly_t rest, const fmpz_mpoly_t polynomial)
{
    const ttc_task *task = end->task;
    const ttc_model *model = task->model;
    const fmpz_mpoly_ctx_struct *context = context_of(end);
    fmpz_mpoly_t term;
    fmpz_mpoly_init(term, context);
    fmpz_mpoly_zero(fixed, context);
    fmpz_mpoly_zero(rest, context);
    for (slong i = 0; i < fmpz_mpoly_length(polynomial, context); i++) {
        bool is_fixed = true;
        for (slong v = 0; is_fixed && v < (slong)task->ring->variable_count; v++) {
            const size_t symbol = ttc_valuation_symbol(task->field, v);
            is_fixed = (symbol < model->symbol_count && model->symbols[symbol].kind == TTC_PARAM) ||
                       fmpz_mpoly_get_term_var_exp_ui(polynomial, i, v, context) == 0;
        }
        fmpz_mpoly_get_term(term, polynomial, i, context);
        fmpz_mpoly_struct *sum = is_fixed ? fixed : rest;
        fmpz_mpoly_add(sum, sum, term, context);
    }
    fmpz_mpoly_clear(term, context);
}

/* ttc_pole_is_nonzero without the radicands of roots, and of what no root divides. */
static bool is_nonzero(const ttc_pole_end *end, const fmpz_mpoly_t polynomial)
{
    const ttc_task *task = end->task;
    const unsigned one_sign[] = { TTC_CAN_BE_POSITIVE, TTC_CAN_BE_NEGATIVE };
    fmpz_mpoly_t fixed, rest;
    ttc_ratio value;
    fmpz_mpoly_init(fixed, context_of(end));
    fmpz_mpoly_init(rest, context_of(end));
    ttc_ratio_init(task->ring, &value);
    ttc_pole_put_state(end, &value, polynomial);
    split(end, fixed, rest, value.numerator);
    bool nonzero = fmpz_mpoly_is_zero(rest, context_of(end)) && !fmpz_mpoly_is_zero(fixed, context_of(end));
    const unsigned signs = ttc_conditions_signs(&task->domain, fixed), others = ttc_conditions_signs(&task->domain, rest);
    for (int i = 0; i < 2; i++) nonzero |= signs == one_sign[i] && !(others & one_sign[1 - i]);
    ttc_ratio_clear(task->ring, &value);
    fmpz_mpoly_clear(rest, context_of(end));
    fmpz_mpoly_clear(fixed, context_of(end));
    return nonzero;
}

bool ttc_pole_is_nonzero(const ttc_pole_end *end, const fmpz_mpoly_t polynomial)
{
    const ttc_ring *ring = end->task->ring;
    bool nonzero = true;
    fmpz_mpoly_t rest, root, quotient;
    fmpz_mpoly_init(rest, ring->context);
    fmpz_mpoly_init(root, ring->context);
    fmpz_mpoly_init(quotient, ring->context);
    fmpz_mpoly_set(rest, polynomial, ring->context);
    for (size_t i = 0; nonzero && i < ring->generator_count; i++) {
        if (fmpz_mpoly_degree_si(rest, ring->generators[i].variable, ring->context) < 1) continue;
        nonzero = ttc_pole_is_nonzero(end, ring->generators[i].square.numerator);
        fmpz_mpoly_gen(root, ring->generators[i].variable, ring->context);
        while (fmpz_mpoly_divides(quotient, rest, root, ring->context)) fmpz_mpoly_swap(rest, quotient, ring->context);
    }
    nonzero = nonzero && is_nonzero(end, rest);
    fmpz_mpoly_clear(quotient, ring->context);
    fmpz_mpoly_clear(root, ring->context);
    fmpz_mpoly_clear(rest, ring->context);
    return nonzero;
}

/* Returns true if a function of other states stays bounded: a cosine or sine; an exponential if its exponent does; a logarithm if
 * its argument does and stays away from zero. */
static bool is_bounded(const ttc_pole_end *end, const ttc_symbol_entry *function, bool is_apart)
{
    ttc_task *task = end->task;
    ttc_ratio of;
    if (function->kind == TTC_COSINE || function->kind == TTC_SINE) return true;
    ttc_ratio_init(task->ring, &of);
    ttc_evaluate(task->field, &of, function->definition);
    const bool bounded = ttc_task_open(task) && is_nonzero(end, of.denominator) &&
                         (function->kind == TTC_EXP || is_nonzero(end, of.numerator)) &&
                         ttc_pole_is_followed(end, of.denominator, is_apart) && ttc_pole_is_followed(end, of.numerator, is_apart);
    ttc_ratio_clear(task->ring, &of);
    return bounded;
}

static bool function_is_followed(const ttc_pole_end *end, size_t symbol, bool is_apart)
{
    const ttc_model *model = end->task->model;
    if (symbol >= model->symbol_count) return true;
    const ttc_symbol_entry *entry = &model->symbols[symbol];
    if (entry->kind == TTC_ROOT || entry->definition == TTC_NONE || !ttc_symbol_is_function(entry->kind)) return true;
    return !ttc_model_depends(model, entry->definition, end->state) && is_bounded(end, entry, is_apart);
}

bool ttc_pole_is_followed(const ttc_pole_end *end, const fmpz_mpoly_t polynomial, bool is_apart)
{
    const ttc_ring *ring = end->task->ring;
    for (slong v = 0; v < (slong)ring->variable_count; v++) {
        if (fmpz_mpoly_degree_si(polynomial, v, ring->context) < 1) continue;
        if (!function_is_followed(end, ttc_valuation_symbol(end->task->field, v), is_apart)) return false;
        for (size_t i = 0; i < ring->generator_count; i++) {
            const ttc_ratio *square = &ring->generators[i].square;
            if (ring->generators[i].variable != v || end->vanishes[i]) continue;
            if (is_apart && ttc_ratio_uses(ring, square, end->variable)) return false;
            if (!is_nonzero(end, square->denominator) || !ttc_pole_is_followed(end, square->denominator, is_apart) ||
                !ttc_pole_is_followed(end, square->numerator, is_apart))
                return false;
        }
    }
    return true;
}

void ttc_pole_find_vanishing(ttc_pole_end *end)
{
    const ttc_ring *ring = end->task->ring;
    fmpz_mpoly_t square;
    fmpz_mpoly_init(square, ring->context);
    for (size_t i = 0; i < ring->generator_count; i++) {
        ttc_pole_drop(end, square, ring->generators[i].square.numerator, end->vanishes); /* squares use earlier ones only */
        end->vanishes[i] = ttc_pole_has_factor(end, square) && is_nonzero(end, ring->generators[i].square.denominator) &&
                           ttc_pole_is_followed(end, ring->generators[i].square.denominator, false) &&
                           ttc_pole_is_followed(end, ring->generators[i].square.numerator, false);
    }
    fmpz_mpoly_clear(square, ring->context);
}

ttc_pole_limit ttc_pole_follow(const ttc_pole_end *end, ttc_ratio *value, const ttc_ratio *ratio, const bool *lifted)
{
    ttc_task *task = end->task;
    ttc_ring *ring = task->ring;
    ttc_pole_limit found = TTC_POLE_IS_NOT_FOLLOWED;
    fmpz_mpoly_t top;
    ttc_ratio bottom;
    if (!ttc_task_open(task)) return found;
    fmpz_mpoly_init(top, ring->context);
    ttc_ratio_init(ring, &bottom);
    ttc_pole_drop(end, top, ratio->numerator, end->vanishes);
    if (ttc_pole_is_followed(end, ratio->numerator, false) && ttc_pole_is_followed(end, ratio->denominator, false) &&
        is_nonzero(end, ratio->denominator)) {
        ttc_pole_put_state(end, value, top);
        ttc_pole_put_state(end, &bottom, ratio->denominator);
        ttc_ratio_divide(ring, value, value, &bottom);
        found = ttc_pole_has_factor(end, top) ? TTC_POLE_GOES_TO_ZERO : TTC_POLE_GOES_ELSEWHERE;
        if (lifted != NULL) ttc_pole_drop(end, top, ratio->numerator, lifted);
        if (found == TTC_POLE_GOES_TO_ZERO && !ttc_pole_has_factor(end, top)) found = TTC_POLE_IS_NOT_FOLLOWED;
    }
    ttc_ratio_clear(ring, &bottom);
    fmpz_mpoly_clear(top, ring->context);
    return found;
}
