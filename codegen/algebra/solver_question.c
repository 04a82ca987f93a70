#include "algebra/solver_question.h"

#include <stdlib.h>
#include <string.h>

/* Larger questions are not asked, as the cost of nonlinear arithmetic is doubly exponential. */
enum { TERM_LIMIT = 4000, DEGREE_LIMIT = 40, VARIABLE_LIMIT = 40 };

static Z3_ast variable_of(ttc_question *q, slong v)
{
    if (q->variables[v] == NULL) {
        q->variables[v] = Z3_mk_const(q->z3, Z3_mk_int_symbol(q->z3, (int)v), q->real);
        if (++q->variable_count > VARIABLE_LIMIT) q->too_large = true;
    }
    return q->variables[v];
}

static Z3_ast number_of(ttc_question *q, const fmpz_t value)
{
    char *digits = fmpz_get_str(NULL, 10, value);
    Z3_ast number = Z3_mk_numeral(q->z3, digits, q->real);
    flint_free(digits);
    return number;
}

static Z3_ast term_of(ttc_question *q, const fmpz_mpoly_t polynomial, slong index)
{
    Z3_ast factors[DEGREE_LIMIT + 1];
    unsigned count = 1;
    fmpz_t coefficient;
    fmpz_init(coefficient);
    fmpz_mpoly_get_term_coeff_fmpz(coefficient, polynomial, index, q->point->ring->context);
    factors[0] = number_of(q, coefficient);
    for (slong v = 0; v < (slong)q->point->ring->variable_count; v++) {
        ulong exponent = fmpz_mpoly_get_term_var_exp_ui(polynomial, index, v, q->point->ring->context);
        q->too_large |= exponent > DEGREE_LIMIT || count + exponent > DEGREE_LIMIT;
        while (!q->too_large && exponent-- > 0) factors[count++] = variable_of(q, v);
    }
    fmpz_clear(coefficient);
    return count == 1 ? factors[0] : Z3_mk_mul(q->z3, count, factors);
}

static Z3_ast polynomial_of(ttc_question *q, const fmpz_mpoly_t polynomial)
{
    slong length = fmpz_mpoly_length(polynomial, q->point->ring->context);
    q->terms += (size_t)length;
    if (q->terms > TERM_LIMIT) q->too_large = true;
    Z3_ast *terms = q->too_large || length == 0 ? NULL : malloc((size_t)length * sizeof(Z3_ast));
    if (terms == NULL) {
        q->too_large |= length > 0;
        return Z3_mk_numeral(q->z3, "0", q->real);
    }
    for (slong i = 0; i < length; i++) terms[i] = term_of(q, polynomial, i);
    Z3_ast sum = length == 1 ? terms[0] : Z3_mk_add(q->z3, (unsigned)length, terms);
    free(terms);
    return sum;
}

static void state_condition(ttc_question *q, const fmpz_mpoly_t polynomial, ttc_relation relation)
{
    Z3_ast left = polynomial_of(q, polynomial), zero = Z3_mk_numeral(q->z3, "0", q->real);
    Z3_ast statement = Z3_mk_eq(q->z3, left, zero);
    if (relation == TTC_IS_POSITIVE) statement = Z3_mk_gt(q->z3, left, zero);
    if (relation == TTC_IS_NONNEGATIVE) statement = Z3_mk_ge(q->z3, left, zero);
    if (relation == TTC_IS_NONZERO) statement = Z3_mk_not(q->z3, statement);
    if (!q->too_large) Z3_solver_assert(q->z3, q->solver, statement);
}

static void state_sign(ttc_question *q, const ttc_generator *generator)
{
    fmpz_mpoly_t variable;
    if (!generator->positive) return;
    fmpz_mpoly_init(variable, q->point->ring->context);
    fmpz_mpoly_gen(variable, generator->variable, q->point->ring->context);
    state_condition(q, variable, TTC_IS_POSITIVE);
    fmpz_mpoly_clear(variable, q->point->ring->context);
}

/* State g^2 = square, and g > 0 for a positive root, for all generators that are used; stating one may use others. */
static void state_generators(ttc_question *q, const ttc_conditions *conditions)
{
    const ttc_ring *ring = q->point->ring;
    bool stated[TTC_GENERATOR_LIMIT] = { false }, again = true;
    while (again && !q->too_large) {
        again = false;
        for (size_t i = 0; i < ring->generator_count; i++) {
            const ttc_generator *generator = &ring->generators[i];
            if (stated[i] || q->variables[generator->variable] == NULL) continue;
            stated[i] = again = true;
            if (conditions->at_denominator &&
                (ttc_conditions_signs(conditions, generator->square.denominator) & TTC_CAN_BE_ZERO)) {
                state_sign(q, generator);
                continue;
            }
            fmpz_mpoly_t relation, variable;
            fmpz_mpoly_init(relation, ring->context);
            fmpz_mpoly_init(variable, ring->context);
            fmpz_mpoly_gen(variable, generator->variable, ring->context);
            fmpz_mpoly_mul(relation, variable, variable, ring->context);
            fmpz_mpoly_mul(relation, relation, generator->square.denominator, ring->context);
            fmpz_mpoly_sub(relation, relation, generator->square.numerator, ring->context);
            state_condition(q, relation, TTC_IS_ZERO);
            state_condition(q, generator->square.denominator, TTC_IS_NONZERO);
            state_sign(q, generator);
            fmpz_mpoly_clear(variable, ring->context);
            fmpz_mpoly_clear(relation, ring->context);
        }
    }
}

/* 1 - c^2 >= 0 */
static void state_cosine(ttc_question *q, const fmpz_mpoly_t cosine)
{
    const fmpz_mpoly_ctx_struct *context = q->point->ring->context;
    fmpz_mpoly_t rest;
    fmpz_mpoly_init(rest, context);
    fmpz_mpoly_mul(rest, cosine, cosine, context);
    fmpz_mpoly_neg(rest, rest, context);
    fmpz_mpoly_add_ui(rest, rest, 1, context);
    state_condition(q, rest, TTC_IS_NONNEGATIVE);
    fmpz_mpoly_clear(rest, context);
}

static bool is_of_numbers(const ttc_question *q, const ttc_ratio *ratio);

/* Returns true if a variable is one number at all points, whose digits are known: pi, exp(1), a positive root of such numbers. */
static bool is_number(const ttc_question *q, slong v)
{
    ttc_ring *ring = q->point->ring;
    ttc_valuation *valuation = q->point->valuation;
    if (ttc_witness_is_function(q->point, v)) {
        const ttc_symbol_entry *entry = ttc_valuation_model(valuation)->symbols + ttc_valuation_symbol(valuation, v);
        if (entry->kind == TTC_PI) return true;
        ttc_ratio argument;
        ttc_ratio_init(ring, &argument);
        ttc_evaluate(valuation, &argument, entry->definition);
        const bool result = is_of_numbers(q, &argument);
        ttc_ratio_clear(ring, &argument);
        return result;
    }
    const ttc_generator *root = ttc_ring_generator(ring, v);
    return root != NULL && root->positive && is_of_numbers(q, &root->square);
}

static bool is_of_numbers(const ttc_question *q, const ttc_ratio *ratio)
{
    for (slong v = 0; v < (slong)q->point->ring->variable_count; v++)
        if (ttc_ratio_uses(q->point->ring, ratio, v) && !is_number(q, v)) return false;
    return true;
}

static Z3_ast end_of(ttc_question *q, const arf_t end)
{
    fmpq_t value;
    fmpq_init(value);
    arf_get_fmpq(value, end);
    char *digits = fmpq_get_str(NULL, 10, value);
    Z3_ast number = Z3_mk_numeral(q->z3, digits, q->real);
    flint_free(digits);
    fmpq_clear(value);
    return number;
}

/* State the value of a function of numbers, to some fifty digits, unless it is so large or small that the digits fill pages. */
static void state_number(ttc_question *q, slong v)
{
    enum { PRECISION = 170, EXPONENT_LIMIT = 1024 };
    ttc_ratio variable;
    arb_t ball;
    arf_t end;
    if (!ttc_witness_is_function(q->point, v) || !is_number(q, v)) return;
    ttc_ratio_init(q->point->ring, &variable);
    arb_init(ball);
    arf_init(end);
    ttc_ratio_set_variable(q->point->ring, &variable, v);
    ttc_witness_enclose(ball, q->point, &variable, PRECISION);
    if (labs(arf_abs_bound_lt_2exp_si(arb_midref(ball))) < EXPONENT_LIMIT && arb_is_finite(ball)) {
        arb_get_lbound_arf(end, ball, PRECISION);
        Z3_solver_assert(q->z3, q->solver, Z3_mk_ge(q->z3, q->variables[v], end_of(q, end)));
        arb_get_ubound_arf(end, ball, PRECISION);
        Z3_solver_assert(q->z3, q->solver, Z3_mk_ge(q->z3, end_of(q, end), q->variables[v]));
    }
    arf_clear(end);
    arb_clear(ball);
    ttc_ratio_clear(q->point->ring, &variable);
}

/* State the bounds of all variables that are used: signs of parameters and functions, values of functions of numbers, and ends of
 * intervals if they give a sign. */
static void state_signs(ttc_question *q)
{
    const ttc_ring *ring = q->point->ring;
    const ttc_model *model = ttc_valuation_model(q->point->valuation);
    fmpz_mpoly_t variable;
    fmpz_mpoly_init(variable, ring->context);
    for (slong v = 0; v < (slong)ring->variable_count; v++) {
        size_t symbol = ttc_valuation_symbol(q->point->valuation, v);
        if (q->variables[v] == NULL || symbol >= model->symbol_count) continue;
        const ttc_symbol_entry *entry = &model->symbols[symbol];
        fmpz_mpoly_gen(variable, v, ring->context);
        if (entry->kind == TTC_COSINE) state_cosine(q, variable);
        if (entry->kind == TTC_EXP || entry->kind == TTC_ROOT) state_condition(q, variable, TTC_IS_POSITIVE);
        state_number(q, v);
        if (entry->kind == TTC_PARAM && entry->sign == TTC_POSITIVE) state_condition(q, variable, TTC_IS_POSITIVE);
        if (entry->kind == TTC_PARAM && entry->sign == TTC_NONNEGATIVE) state_condition(q, variable, TTC_IS_NONNEGATIVE);
        if (entry->kind == TTC_PARAM && entry->sign == TTC_NONZERO) state_condition(q, variable, TTC_IS_NONZERO);
        const ttc_id ends[2] = { entry->low, entry->high };
        for (int i = 0; i < 2 && entry->kind == TTC_STATE; i++) {
            const fmpq *end = ttc_number_value(model->graph, ends[i]);
            if (end == NULL || (i == 0 ? fmpq_sgn(end) < 0 : fmpq_sgn(end) > 0)) continue;
            if (i == 1) fmpz_mpoly_neg(variable, variable, ring->context);
            state_condition(q, variable, TTC_IS_POSITIVE);
        }
    }
    fmpz_mpoly_clear(variable, ring->context);
}

/* State bound >= 0, with equality only where `at` is zero: where none of the two has a value, this says nothing. */
static void state_bound(ttc_question *q, const ttc_ratio *bound, const ttc_ratio *at)
{
    const ttc_ring *ring = q->point->ring;
    Z3_ast zero = Z3_mk_numeral(q->z3, "0", q->real);
    fmpz_mpoly_t product;
    fmpz_mpoly_init(product, ring->context);
    fmpz_mpoly_mul(product, bound->numerator, bound->denominator, ring->context);
    Z3_ast value = polynomial_of(q, product), ways[3] = { Z3_mk_gt(q->z3, value, zero) };
    ways[1] = Z3_mk_eq(q->z3, polynomial_of(q, at->numerator), zero);
    ways[2] = Z3_mk_eq(q->z3, polynomial_of(q, bound->denominator), zero);
    if (!q->too_large) Z3_solver_assert(q->z3, q->solver, Z3_mk_ge(q->z3, value, zero));
    if (!q->too_large) Z3_solver_assert(q->z3, q->solver, Z3_mk_or(q->z3, 3, ways));
    fmpz_mpoly_clear(product, ring->context);
}

/* State how a = log(e) lies to e: 1 + a <= e, and 1 - a <= 1/e, that is e <= 1 + a e. */
static void state_exponential(ttc_question *q, const ttc_ratio *a, const ttc_ratio *e)
{
    ttc_ring *ring = q->point->ring;
    ttc_ratio bound, one;
    ttc_ratio_init(ring, &bound);
    ttc_ratio_init(ring, &one);
    ttc_ratio_set_integer(ring, &one, 1);
    ttc_ratio_subtract(ring, &bound, e, &one);
    ttc_ratio_subtract(ring, &bound, &bound, a);
    state_bound(q, &bound, a);
    ttc_ratio_subtract(ring, &bound, &one, e);
    ttc_ratio_add_product(ring, &bound, a, e);
    state_bound(q, &bound, a);
    ttc_ratio_clear(ring, &one);
    ttc_ratio_clear(ring, &bound);
}

/* State that cos(a) >= 1 - a^2/2, or sin(a)^2 <= a^2. */
static void state_circular(ttc_question *q, const ttc_ratio *a, const ttc_ratio *f, bool is_sine)
{
    ttc_ring *ring = q->point->ring;
    ttc_ratio bound, term;
    ttc_ratio_init(ring, &bound);
    ttc_ratio_init(ring, &term);
    ttc_ratio_multiply(ring, &bound, a, a);
    ttc_ratio_set_integer(ring, &term, is_sine ? -1 : 2);
    ttc_ratio_multiply(ring, &term, &term, f);
    if (is_sine) ttc_ratio_multiply(ring, &term, &term, f);
    ttc_ratio_add(ring, &bound, &bound, &term);
    ttc_ratio_set_integer(ring, &term, is_sine ? 0 : -2);
    ttc_ratio_add(ring, &bound, &bound, &term);
    state_bound(q, &bound, a);
    ttc_ratio_clear(ring, &term);
    ttc_ratio_clear(ring, &bound);
}

/* Set a and e of a function: a = log(e), returns TTC_EXP; or e = cos(a) or sin(a), returns its kind. Else returns TTC_PI. */
static ttc_symbol_kind read_function(ttc_question *q, slong v, ttc_ratio *a, ttc_ratio *e)
{
    ttc_valuation *valuation = q->point->valuation;
    if (!ttc_witness_is_function(q->point, v)) return TTC_PI;
    const ttc_symbol_entry *entry = ttc_valuation_model(valuation)->symbols + ttc_valuation_symbol(valuation, v);
    if (entry->kind == TTC_PI) return TTC_PI;
    ttc_evaluate(valuation, entry->kind == TTC_LOG ? e : a, entry->definition);
    ttc_ratio_set_variable(q->point->ring, entry->kind == TTC_LOG ? a : e, v);
    return entry->kind == TTC_LOG ? TTC_EXP : entry->kind;
}

/* State bounds of log(e/f) = a - b; if f is the variable w, also of log(e/f^k) = a - k b, for k up to 4 and e's degree in w. */
static void state_quotient(ttc_question *q, const ttc_ratio *a, const ttc_ratio *e, const ttc_ratio *b, const ttc_ratio *f, slong w)
{
    enum { HIGHEST = 4 };
    ttc_ring *ring = q->point->ring;
    slong last = 1;
    if (fmpz_mpoly_is_gen(f->numerator, w, ring->context))
        last = fmpz_mpoly_degree_si(e->numerator, w, ring->context) - fmpz_mpoly_degree_si(e->denominator, w, ring->context);
    ttc_ratio logarithm, quotient;
    ttc_ratio_init(ring, &logarithm);
    ttc_ratio_init(ring, &quotient);
    ttc_ratio_set(ring, &logarithm, a);
    ttc_ratio_set(ring, &quotient, e);
    for (slong k = 1; k == 1 || (k <= last && k <= HIGHEST); k++) {
        ttc_ratio_subtract(ring, &logarithm, &logarithm, b);
        ttc_ratio_divide(ring, &quotient, &quotient, f);
        state_exponential(q, &logarithm, &quotient);
    }
    ttc_ratio_clear(ring, &quotient);
    ttc_ratio_clear(ring, &logarithm);
}

/* State bounds of the function v, and, if it is an exponential or a logarithm, of its quotients with others that are stated. */
static void state_function(ttc_question *q, slong v, const bool *stated)
{
    ttc_ring *ring = q->point->ring;
    ttc_ratio a, e, b, f;
    ttc_ratio_init(ring, &a);
    ttc_ratio_init(ring, &e);
    ttc_ratio_init(ring, &b);
    ttc_ratio_init(ring, &f);
    const ttc_symbol_kind kind = read_function(q, v, &a, &e);
    if (kind == TTC_EXP) state_exponential(q, &a, &e);
    else if (kind != TTC_PI) state_circular(q, &a, &e, kind == TTC_SINE);
    for (slong w = 0; kind == TTC_EXP && w < (slong)ring->variable_count; w++) {
        if (w == v || !stated[w] || read_function(q, w, &b, &f) != TTC_EXP) continue;
        if (ttc_ratio_uses(ring, &f, v)) state_quotient(q, &b, &f, &a, &e, v);
        else state_quotient(q, &a, &e, &b, &f, w);
    }
    ttc_ratio_clear(ring, &f);
    ttc_ratio_clear(ring, &e);
    ttc_ratio_clear(ring, &b);
    ttc_ratio_clear(ring, &a);
}

/* State bounds of all functions that are used, and of those that their arguments use. */
static void state_functions(ttc_question *q)
{
    const size_t count = q->point->ring->variable_count;
    bool *stated = calloc(count + 1, sizeof *stated), again = stated != NULL;
    while (again && !q->too_large) {
        again = false;
        for (size_t v = 0; v < count; v++) {
            if (stated[v] || q->variables[v] == NULL) continue;
            stated[v] = again = true;
            state_function(q, (slong)v, stated);
        }
    }
    free(stated);
}

void ttc_question_state(ttc_question *q, const ttc_conditions *conditions, bool with_functions)
{
    for (size_t i = 0; i < conditions->count; i++)
        state_condition(q, conditions->items[i].polynomial, conditions->items[i].relation);
    if (with_functions) state_functions(q);
    state_generators(q, conditions);
    state_signs(q);
}

static bool read_rational(Z3_context z3, Z3_ast value, fmpq_t out)
{
    return fmpq_set_str(out, Z3_get_numeral_string(z3, value), 10) == 0;
}

static bool read_value(Z3_context z3, Z3_ast value, fmpq_t out)
{
    if (Z3_is_numeral_ast(z3, value)) return read_rational(z3, value, out);
    if (!Z3_is_algebraic_number(z3, value)) return false;
    fmpq_t upper;
    fmpq_init(upper);
    bool ok = read_rational(z3, Z3_get_algebraic_number_lower(z3, value, 100), out)
              && read_rational(z3, Z3_get_algebraic_number_upper(z3, value, 100), upper);
    fmpq_add(out, out, upper);
    fmpq_div_2exp(out, out, 1);
    fmpq_clear(upper);
    return ok;
}

static void read_sign(ttc_question *q, slong v, const fmpq_t value)
{
    const ttc_generator *root = ttc_ring_generator(q->point->ring, v);
    if (root == NULL) return;
    const unsigned bit = 1u << (root - q->point->ring->generators);
    q->point->negative &= ~bit;
    if (fmpq_sgn(value) < 0) q->point->negative |= bit;
}

bool ttc_question_read_point(ttc_question *q)
{
    Z3_model model = Z3_solver_get_model(q->z3, q->solver);
    bool ok = model != NULL;
    fmpq_t value;
    fmpq_init(value);
    if (ok) Z3_model_inc_ref(q->z3, model);
    for (slong v = 0; ok && v < (slong)q->point->ring->variable_count; v++) {
        Z3_ast said = NULL;
        if (q->variables[v] == NULL) continue;
        ok = Z3_model_eval(q->z3, model, q->variables[v], true, &said) && read_value(q->z3, said, value);
        if (ok && ttc_witness_is_free(q->point, v)) fmpq_set(q->point->values + v, value);
        if (ok) read_sign(q, v, value);
    }
    if (model != NULL) Z3_model_dec_ref(q->z3, model);
    fmpq_clear(value);
    ttc_witness_changed(q->point);
    return ok;
}
