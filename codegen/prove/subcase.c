#include "prove/subcase.h"

static ttc_id term_node(ttc_task *task, const fmpz_mpoly_t polynomial, slong index)
{
    ttc_graph *graph = task->model->graph;
    fmpq_t coefficient;
    fmpq_init(coefficient);
    fmpz_mpoly_get_term_coeff_fmpz(fmpq_numref(coefficient), polynomial, index, task->ring->context);
    ttc_id node = ttc_number(graph, coefficient);
    for (size_t v = 0; v < task->ring->variable_count; v++) {
        ulong exponent = fmpz_mpoly_get_term_var_exp_ui(polynomial, index, (slong)v, task->ring->context);
        size_t symbol = exponent == 0 ? SIZE_MAX : ttc_valuation_symbol(task->field, (slong)v);
        if (exponent == 0) continue;
        ttc_id factor = symbol == SIZE_MAX ? TTC_NONE : ttc_symbol(graph, (uint32_t)symbol);
        node = ttc_multiply(graph, node, ttc_power(graph, factor, (long)exponent));
    }
    fmpq_clear(coefficient);
    return node;
}

ttc_id ttc_subcase_expression(ttc_task *task, const fmpz_mpoly_t polynomial)
{
    ttc_id sum = ttc_integer(task->model->graph, 0);
    for (slong i = 0; i < fmpz_mpoly_length(polynomial, task->ring->context); i++)
        sum = ttc_add(task->model->graph, sum, term_node(task, polynomial, i));
    return sum;
}

ttc_id ttc_subcase_others(ttc_task *task, const fmpz_mpoly_factor_t factors, slong one)
{
    ttc_id product = TTC_NONE;
    for (slong i = 0; i < factors->num; i++) {
        if (i == one) continue;
        ttc_id other = ttc_subcase_expression(task, factors->poly + i);
        product = product == TTC_NONE ? other : ttc_multiply(task->model->graph, product, other);
    }
    return product;
}

/* The price of solving for a variable: lowest for states, then parameters and levels, then cosines; 0: it cannot be solved for. */
static slong price_of(ttc_task *task, slong variable)
{
    size_t symbol = ttc_valuation_symbol(task->field, variable);
    if (symbol == SIZE_MAX) return 0;
    if (symbol >= task->model->symbol_count) return 1;
    switch (task->model->symbols[symbol].kind) {
    case TTC_STATE: return 1;
    case TTC_PARAM:
    case TTC_LEVEL: return 1000;
    case TTC_COSINE: return 100000;
    default: return 0;
    }
}

static bool in_some_radicand(ttc_task *task, const fmpz_mpoly_t polynomial, slong variable)
{
    for (size_t i = task->ring->generator_count; i-- > 0;) {
        const ttc_generator *generator = &task->ring->generators[i];
        if (fmpz_mpoly_degree_si(polynomial, generator->variable, task->ring->context) < 1) continue;
        if (ttc_ratio_uses(task->ring, &generator->square, variable)) return true;
        if (in_some_radicand(task, generator->square.numerator, variable)) return true;
    }
    return false;
}

/* Returns true if an exponential or logarithm in the factor depends on the variable, which then cannot be solved for. */
static bool in_some_transcendental(ttc_task *task, const fmpz_mpoly_t factor, slong variable)
{
    const ttc_model *model = task->model;
    size_t symbol = ttc_valuation_symbol(task->field, variable);
    for (uint32_t i = 0; i < model->symbol_count; i++) {
        if (model->symbols[i].kind != TTC_EXP && model->symbols[i].kind != TTC_LOG) continue;
        if (fmpz_mpoly_degree_si(factor, ttc_valuation_variable(task->field, i), task->ring->context) < 1) continue;
        if (symbol < model->symbol_count && ttc_model_depends(model, model->symbols[i].node, (uint32_t)symbol)) return true;
    }
    return false;
}

/* Choose the variable to solve for, -1 if there is none: of the cheapest kind; among these with a leading coefficient that cannot
 * vanish, else with a short one; then with degree 1 rather than 2. */
static slong choose_variable(ttc_task *task, const fmpz_mpoly_t factor, ulong *degree)
{
    slong best = -1, best_cost = WORD_MAX;
    fmpz_mpoly_t leading;
    fmpz_mpoly_init(leading, task->ring->context);
    for (slong v = 0; v < (slong)task->ring->variable_count; v++) {
        slong d = fmpz_mpoly_degree_si(factor, v, task->ring->context), price = price_of(task, v);
        if (d < 1 || d > 2 || price == 0 || ttc_ring_generator(task->ring, v) != NULL) continue;
        if (in_some_radicand(task, factor, v) || in_some_transcendental(task, factor, v)) continue;
        ulong exponent = (ulong)d;
        fmpz_mpoly_get_coeff_vars_ui(leading, factor, &v, &exponent, 1, task->ring->context);
        bool safe = !(ttc_conditions_signs(&task->domain, leading) & TTC_CAN_BE_ZERO);
        slong cost = price + (safe ? d - 1 : 10 + 2 * fmpz_mpoly_length(leading, task->ring->context) + d - 1);
        if (cost < best_cost) {
            best = v;
            best_cost = cost;
            *degree = exponent;
        }
    }
    fmpz_mpoly_clear(leading, task->ring->context);
    return best;
}

/* Returns true for a state on which no function of the table but roots depends: its solution may contain functions and roots. */
static bool is_free_state(ttc_task *task, slong variable)
{
    const ttc_model *model = task->model;
    const size_t symbol = ttc_valuation_symbol(task->field, variable);
    if (symbol >= model->symbol_count || model->symbols[symbol].kind != TTC_STATE) return false;
    for (uint32_t i = 0; i < model->symbol_count; i++)
        if (model->symbols[i].kind != TTC_ROOT && ttc_symbol_is_function(model->symbols[i].kind) &&
            ttc_model_depends(model, model->symbols[i].node, (uint32_t)symbol))
            return false;
    return true;
}

/* Returns true if each factor of a polynomial has a variable to solve for. */
static bool is_solvable(ttc_task *task, const fmpz_mpoly_t polynomial)
{
    fmpz_mpoly_factor_t factors;
    ulong degree;
    fmpz_mpoly_factor_init(factors, task->ring->context);
    bool solvable = fmpz_mpoly_factor(factors, polynomial, task->ring->context) != 0;
    for (slong i = 0; solvable && i < factors->num; i++) solvable = choose_variable(task, factors->poly + i, &degree) >= 0;
    fmpz_mpoly_factor_clear(factors, task->ring->context);
    return solvable;
}

void ttc_subcase_level(ttc_task *task, fmpz_mpoly_t level, const ttc_ratio *value)
{
    enum { FEW = 2 };
    const fmpz_mpoly_ctx_struct *context = task->ring->context;
    ulong degree = 0;
    size_t roots = 0;
    slong variable = choose_variable(task, value->numerator, &degree);
    for (size_t i = 0; i < task->ring->generator_count; i++)
        roots += fmpz_mpoly_degree_si(value->numerator, task->ring->generators[i].variable, context) > 0;
    bool is_direct = roots > 0 && variable >= 0 && is_free_state(task, variable);
    if (is_direct) fmpz_mpoly_get_coeff_vars_ui(level, value->numerator, &variable, &degree, 1, context);
    is_direct = is_direct && !(ttc_conditions_signs(&task->domain, level) & TTC_CAN_BE_ZERO);
    const bool is_sure = is_direct && (degree == 1 || roots > FEW);
    if (!is_sure) ttc_ratio_norm(task->ring, level, value);
    if (is_sure || (is_direct && task->ring->status == TTC_RING_OK && !is_solvable(task, level)))
        fmpz_mpoly_set(level, value->numerator, context);
}

static ttc_id coefficient_node(ttc_task *task, const fmpz_mpoly_t factor, slong variable, ulong exponent)
{
    fmpz_mpoly_t coefficient;
    fmpz_mpoly_init(coefficient, task->ring->context);
    fmpz_mpoly_get_coeff_vars_ui(coefficient, factor, &variable, &exponent, 1, task->ring->context);
    ttc_id node = ttc_subcase_expression(task, coefficient);
    fmpz_mpoly_clear(coefficient, task->ring->context);
    return node;
}

/* a x^2 + b x + c = 0 as x = y - b/(2a), y^2 = (b^2 - 4ac)/(4a^2); a x + b = 0 as x = -b/a. */
bool ttc_subcase_solve(ttc_subcase *b, ttc_id *lead_out, ttc_task *task, const fmpz_mpoly_t factor)
{
    ttc_graph *graph = task->model->graph;
    ulong degree = 0;
    slong variable = choose_variable(task, factor, &degree);
    if (variable < 0 || b->relation_count == TTC_SUBCASE_RELATIONS_MAX) return false;
    uint32_t symbol = (uint32_t)ttc_valuation_symbol(task->field, variable);
    ttc_id coefficients[3] = { TTC_NONE };
    for (ulong k = 0; k <= degree; k++) coefficients[k] = coefficient_node(task, factor, variable, k);
    ttc_id lead = coefficients[degree], zero = ttc_integer(graph, 0);
    if (degree == 1) {
        ttc_id value = ttc_subtract(graph, zero, ttc_divide(graph, coefficients[0], lead));
        b->solutions[b->solution_count++] = (ttc_solution){ symbol, value, false };
    } else if (coefficients[1] == zero) {
        ttc_id square = ttc_subtract(graph, zero, ttc_divide(graph, coefficients[0], lead));
        b->solutions[b->solution_count++] = (ttc_solution){ symbol, square, true };
    } else {
        if (b->spares == TTC_SPARE_SYMBOLS) return false;
        uint32_t spare = (uint32_t)(task->model->symbol_count + b->spares++);
        ttc_id middle = ttc_divide(graph, coefficients[1], ttc_multiply(graph, ttc_integer(graph, 2), lead));
        ttc_id square = ttc_power(graph, middle, 2);
        square = ttc_subtract(graph, square, ttc_divide(graph, coefficients[0], lead));
        ttc_id value = ttc_subtract(graph, ttc_symbol(graph, spare), middle);
        b->solutions[b->solution_count++] = (ttc_solution){ spare, square, true };
        b->solutions[b->solution_count++] = (ttc_solution){ symbol, value, false };
    }
    b->relation_count++;
    fmpz_mpoly_t leading;
    fmpz_mpoly_init(leading, task->ring->context);
    fmpz_mpoly_get_coeff_vars_ui(leading, factor, &variable, &degree, 1, task->ring->context);
    *lead_out = ttc_conditions_signs(&task->domain, leading) & TTC_CAN_BE_ZERO ? lead : ttc_integer(graph, 1);
    fmpz_mpoly_clear(leading, task->ring->context);
    return true;
}
