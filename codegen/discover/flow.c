#include "discover/flow.h"

#include "algebra/derive.h"

#include <flint/ulong_extras.h>

#include <stdlib.h>

enum { ATTEMPTS = 4096, PRIMES_MAX = 256 };

static bool is_quantity(const ttc_flow *flow, slong variable)
{
    for (size_t i = 0; i < flow->count; i++)
        if (flow->variables[i] == variable) return true;
    return false;
}

bool ttc_flow_moves(const ttc_flow *flow, const ttc_ratio *a)
{
    for (size_t i = 0; i < flow->count; i++)
        if (ttc_ratio_uses(flow->ring, a, flow->variables[i])) return true;
    return false;
}

/* The variable of a symbol, or -1 if the symbol's value, set in any case, is another. */
static slong own_variable(ttc_flow *flow, uint32_t symbol, ttc_ratio *value)
{
    const slong variable = ttc_valuation_variable(flow->valuation, symbol);
    ttc_ratio own;
    ttc_ratio_init(flow->ring, &own);
    ttc_evaluate(flow->valuation, value, flow->model->symbols[symbol].node);
    if (variable >= 0) ttc_ratio_set_variable(flow->ring, &own, variable);
    const bool is_own = variable >= 0 && flow->ring->status == TTC_RING_OK && ttc_ratio_equal(flow->ring, value, &own);
    ttc_ratio_clear(flow->ring, &own);
    return is_own ? variable : -1;
}

static void add_quantity(ttc_flow *flow, slong variable, bool is_root)
{
    flow->variables[flow->count] = variable;
    flow->degrees[flow->count] = 1;
    flow->is_root[flow->count++] = is_root;
}

/* States, and functions with a variable of their own and a nonzero rate, are quantities; other variables are parameters. */
static void add_plain(ttc_flow *flow)
{
    ttc_ratio value;
    ttc_ratio_init(flow->ring, &value);
    for (uint32_t i = 0; i < flow->model->symbol_count; i++) {
        const ttc_symbol_kind kind = flow->model->symbols[i].kind;
        if (kind == TTC_LET || kind == TTC_LAMBDA) continue;
        const slong variable = own_variable(flow, i, &value);
        if (variable < 0 || ttc_ring_generator(flow->ring, variable) != NULL) continue;
        const bool moves = !fmpz_mpoly_is_zero(flow->slopes[variable].numerator, flow->ring->context);
        if (kind == TTC_STATE || moves) add_quantity(flow, variable, false);
        else flow->parameters[flow->parameter_count++] = variable;
    }
    ttc_ratio_clear(flow->ring, &value);
}

int ttc_flow_degree(const ttc_flow *flow, const fmpz_mpoly_t a)
{
    int most = 0;
    ulong *exponents = flint_calloc(flow->ring->variable_count, sizeof *exponents);
    for (slong t = 0; t < fmpz_mpoly_length(a, flow->ring->context); t++) {
        int degree = 0;
        fmpz_mpoly_get_term_exp_ui(exponents, a, t, flow->ring->context);
        for (size_t i = 0; i < flow->count; i++) degree += (int)exponents[flow->variables[i]] * flow->degrees[i];
        if (degree > most) most = degree;
    }
    flint_free(exponents);
    return most;
}

/* Roots whose radicands contain quantities. (r^2)' = 2 r r'. */
static void add_roots(ttc_flow *flow)
{
    fmpq_t half;
    ttc_ratio root;
    fmpq_init(half);
    fmpq_set_si(half, 1, 2);
    ttc_ratio_init(flow->ring, &root);
    for (size_t i = 0; i < flow->ring->generator_count; i++) {
        const ttc_generator *generator = &flow->ring->generators[i];
        if (!ttc_flow_moves(flow, &generator->square)) continue;
        ttc_ratio *slope = &flow->slopes[generator->variable];
        ttc_ratio_derive(flow->ring, slope, &generator->square, flow->slopes);
        ttc_ratio_scale(flow->ring, slope, slope, half);
        ttc_ratio_set_variable(flow->ring, &root, generator->variable);
        ttc_ratio_divide(flow->ring, slope, slope, &root);
        const int degree = ttc_flow_degree(flow, generator->square.numerator);
        flow->is_graded &= ttc_flow_degree(flow, generator->square.denominator) == 0;
        add_quantity(flow, generator->variable, true);
        if (degree > 2) flow->degrees[flow->count - 1] = (degree + 1) / 2;
    }
    ttc_ratio_clear(flow->ring, &root);
    fmpq_clear(half);
}

static void set_slopes(ttc_flow *flow)
{
    const ttc_model *model = flow->model;
    ttc_ratio value;
    ttc_ratio_init(flow->ring, &value);
    for (uint32_t i = 0; i < model->symbol_count; i++) /* so that every function gets its variable */
        if (model->symbols[i].kind != TTC_LAMBDA) ttc_evaluate(flow->valuation, &value, model->symbols[i].node);
    for (size_t i = 0; i < model->state_count; i++) {
        const slong variable = ttc_valuation_variable(flow->valuation, model->states[i]);
        ttc_evaluate(flow->valuation, &flow->slopes[variable], ttc_model_field(model, i));
        ttc_evaluate(flow->valuation, &value, ttc_derive_state(model, ttc_model_field(model, i), i));
        ttc_ratio_add(flow->ring, &flow->divergence, &flow->divergence, &value);
    }
    if (flow->ring->status == TTC_RING_OK) ttc_valuation_add_function_rates(flow->valuation, flow->slopes);
    ttc_ratio_clear(flow->ring, &value);
}

ttc_flow *ttc_flow_create(const ttc_model *model, const ttc_bindings *conditions, const char **why)
{
    ttc_flow *flow = flint_calloc(1, sizeof *flow);
    flow->model = model;
    flow->is_graded = true;
    flow->valuation = ttc_valuation_create(model, 0);
    *why = "memory is out";
    if (flow->valuation == NULL) goto failed;
    flow->ring = ttc_valuation_ring(flow->valuation);
    for (size_t i = 0; conditions != NULL && i < conditions->count; i++)
        ttc_valuation_bind(flow->valuation, conditions->items[i].symbol, conditions->items[i].expression);
    const size_t count = flow->ring->variable_count;
    flow->variables = flint_calloc(count, sizeof *flow->variables);
    flow->parameters = flint_calloc(count, sizeof *flow->parameters);
    flow->degrees = flint_calloc(count, sizeof *flow->degrees);
    flow->is_root = flint_calloc(count, sizeof *flow->is_root);
    flow->slopes = flint_calloc(count, sizeof *flow->slopes);
    flow->rates = flint_calloc(count, sizeof *flow->rates);
    flow->squares = flint_calloc(TTC_GENERATOR_LIMIT, sizeof *flow->squares);
    for (size_t i = 0; i < count; i++) ttc_ratio_init(flow->ring, &flow->slopes[i]);
    ttc_ratio_init(flow->ring, &flow->divergence);
    set_slopes(flow);
    if (flow->ring->status == TTC_RING_OK) add_plain(flow);
    if (flow->ring->status == TTC_RING_OK) add_roots(flow);
    *why = ttc_ring_status_text(flow->ring->status);
    if (flow->ring->status != TTC_RING_OK) goto failed;
    *why = "a root becomes rational, with a sign that depends on where one looks (expected conditions that leave it a root)";
    if (flow->ring->choice_count > 0) goto failed;
    *why = "no point was found in a prime field (expected fewer roots of numbers)";
    if (!ttc_flow_take_prime(flow, TTC_PRIME)) goto failed;
    return flow;
failed:
    ttc_flow_destroy(flow);
    return NULL;
}

void ttc_flow_destroy(ttc_flow *flow)
{
    if (flow == NULL) return;
    const size_t count = flow->slopes == NULL ? 0 : flow->ring->variable_count;
    for (size_t i = 0; i < count; i++) {
        ttc_ratio_clear(flow->ring, &flow->slopes[i]);
        ttc_modular_ratio_clear(&flow->rates[i]);
    }
    if (flow->slopes != NULL) ttc_ratio_clear(flow->ring, &flow->divergence);
    for (size_t i = 0; flow->squares != NULL && i < TTC_GENERATOR_LIMIT; i++) ttc_modular_ratio_clear(&flow->squares[i]);
    flint_free(flow->squares);
    flint_free(flow->rates);
    flint_free(flow->slopes);
    flint_free(flow->is_root);
    flint_free(flow->degrees);
    flint_free(flow->parameters);
    flint_free(flow->variables);
    ttc_valuation_destroy(flow->valuation);
    flint_free(flow);
}

/* The roots that are quantities, or those that are not, from their squares, with random signs. Returns false if a square has no
 * value, is zero, or is none mod p. */
static bool take_roots(const ttc_flow *flow, ulong *values, bool moving, uint64_t *source)
{
    for (size_t i = 0; i < flow->ring->generator_count; i++) {
        const slong variable = flow->ring->generators[i].variable;
        ulong square = 0;
        if (is_quantity(flow, variable) != moving) continue;
        if (!ttc_modular_ratio_value(&square, &flow->squares[i], values, flow->mod) || square == 0) return false;
        const ulong root = n_sqrtmod(square, flow->mod.n);
        if (root == 0) return false;
        values[variable] = ttc_modular_draw(source, flow->mod) % 2 == 0 ? root : nmod_neg(root, flow->mod);
    }
    return true;
}

bool ttc_flow_draw_parameters(const ttc_flow *flow, ulong *values, slong zero, uint64_t *source)
{
    for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
        for (size_t i = 0; i < flow->parameter_count; i++)
            values[flow->parameters[i]] = flow->parameters[i] == zero ? 0 : ttc_modular_draw(source, flow->mod);
        if (take_roots(flow, values, false, source)) return true;
    }
    return false;
}

bool ttc_flow_draw(const ttc_flow *flow, ulong *values, ulong *logarithmic, uint64_t *source)
{
    for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
        bool good = true;
        for (size_t i = 0; i < flow->count; i++)
            if (!flow->is_root[i]) values[flow->variables[i]] = ttc_modular_draw(source, flow->mod);
        good = take_roots(flow, values, true, source);
        for (size_t i = 0; good && i < flow->count; i++) {
            good = ttc_modular_ratio_value(&logarithmic[i], &flow->rates[i], values, flow->mod);
            if (good) logarithmic[i] = nmod_div(logarithmic[i], values[flow->variables[i]], flow->mod);
        }
        if (good) return true;
    }
    return false;
}

static void reduce(ttc_flow *flow, ulong prime)
{
    nmod_init(&flow->mod, prime);
    for (size_t i = 0; i < flow->count; i++)
        ttc_modular_ratio_set(&flow->rates[i], flow->ring, &flow->slopes[flow->variables[i]], flow->mod);
    for (size_t i = 0; i < flow->ring->generator_count; i++)
        ttc_modular_ratio_set(&flow->squares[i], flow->ring, &flow->ring->generators[i].square, flow->mod);
}

bool ttc_flow_take_prime(ttc_flow *flow, ulong prime)
{
    bool found = false;
    uint64_t source = 1;
    ulong *values = flint_calloc(flow->ring->variable_count, sizeof *values);
    ulong *logarithmic = flint_calloc(flow->count + 1, sizeof *logarithmic);
    for (int tried = 0; tried < PRIMES_MAX && !found; prime--) {
        if (!n_is_prime(prime)) continue;
        tried++;
        reduce(flow, prime);
        found = ttc_flow_draw_parameters(flow, values, -1, &source) && ttc_flow_draw(flow, values, logarithmic, &source);
    }
    flint_free(logarithmic);
    flint_free(values);
    return found;
}

void ttc_flow_logarithmic_rate(const ttc_flow *flow, ttc_ratio *out, const ttc_ratio *a)
{
    ttc_ratio rate;
    ttc_ratio_init(flow->ring, &rate);
    ttc_ratio_derive(flow->ring, &rate, a, flow->slopes);
    ttc_ratio_divide(flow->ring, out, &rate, a);
    ttc_ratio_clear(flow->ring, &rate);
}
