/* A reduction or embedding: the images of our states move as the other model says and lie in its domain; those of a reduction
 * have its dimension, those of an embedding ours. */
#include "prove/domain.h"
#include "prove/way_table.h"

#include <stdlib.h>
#include <string.h>

void ttc_prove_constant(ttc_task *task, const char *name, ttc_id expression)
{
    ttc_ratio rate;
    ttc_ratio_init(task->ring, &rate);
    ttc_evaluate(task->field, &rate, ttc_derive_field(task->model, expression));
    ttc_task_require_zero(task, &rate, "d%s/dt, which should be constant", name);
    ttc_ratio_clear(task->ring, &rate);
}

static void bind_target(ttc_task *task, const ttc_model *target, ttc_valuation *map)
{
    for (uint32_t i = 0; i < target->symbol_count && ttc_task_open(task); i++) {
        const ttc_symbol_entry *entry = &target->symbols[i];
        uint32_t own;
        const ttc_id expression = ttc_given_for(task->claim, entry->name);
        if (expression != TTC_NONE) {
            if (entry->kind != TTC_STATE && entry->kind != TTC_ROOT && entry->kind != TTC_PARAM)
                ttc_task_unsettle(task, "%s is no state, root or parameter of %s", entry->name, target->name);
            ttc_valuation_bind(map, i, expression);
        } else if (entry->kind == TTC_STATE) {
            ttc_task_unsettle(task, "the state %s of %s is given no image", entry->name, target->name);
        } else if (entry->kind == TTC_PARAM) {
            if (ttc_model_find_symbol(task->model, entry->name, &own) && task->model->symbols[own].kind == TTC_PARAM)
                ttc_valuation_bind(map, i, task->model->symbols[own].node);
            else ttc_task_unsettle(task, "the parameter %s of %s is given no value", entry->name, target->name);
        }
    }
    for (size_t i = 0; i < task->claim->bindings.count && ttc_task_open(task); i++) {
        uint32_t symbol;
        if (!ttc_model_find_symbol(target, task->claim->target_names[i], &symbol))
            ttc_task_unsettle(task, "%s names nothing in %s", task->claim->target_names[i], target->name);
    }
}

void ttc_prove_chain_rule(ttc_task *task, const ttc_claim *claim, const ttc_model *target, ttc_valuation *map)
{
    ttc_ratio left, right;
    ttc_ratio_init(task->ring, &left);
    ttc_ratio_init(task->ring, &right);
    for (size_t i = 0; i < target->state_count && ttc_task_open(task); i++) {
        const ttc_symbol_entry *state = &target->symbols[target->states[i]];
        const ttc_id image = ttc_given_for(claim, state->name);
        if (image == TTC_NONE) continue;
        ttc_evaluate(task->field, &left, ttc_derive_field(task->model, image));
        ttc_evaluate(map, &right, ttc_model_field(target, i));
        ttc_ratio_subtract(task->ring, &left, &left, &right);
        ttc_task_require_zero(task, &left, "chain rule - field of %s in %s", target->name, state->name);
    }
    ttc_ratio_clear(task->ring, &right);
    ttc_ratio_clear(task->ring, &left);
}

static void require_alike(ttc_task *task, ttc_valuation *map, ttc_id own, ttc_id theirs, const char *what, const char *name)
{
    ttc_ratio left, right;
    ttc_ratio_init(task->ring, &left);
    ttc_ratio_init(task->ring, &right);
    ttc_evaluate(task->field, &left, own);
    ttc_evaluate(map, &right, theirs);
    ttc_ratio_subtract(task->ring, &left, &left, &right);
    if (ttc_task_open(task)) ttc_task_require_zero(task, &left, "%s %s here - there", what, name);
    ttc_ratio_clear(task->ring, &right);
    ttc_ratio_clear(task->ring, &left);
}

/* One without conditions. */
static bool is_plain_integral(const ttc_claim *claim)
{
    return claim->kind == TTC_CLAIM_INTEGRAL && claim->when.count == 0 && claim->modulo_count == 0;
}

void ttc_prove_same_observations(ttc_task *task, const ttc_model *target, ttc_valuation *map)
{
    const ttc_model *model = task->model;
    for (size_t i = 0; i < model->observed_count; i++)
        for (size_t k = 0; k < target->observed_count && ttc_task_open(task); k++) {
            const ttc_symbol_entry *own = model->symbols + model->observed[i], *theirs = target->symbols + target->observed[k];
            if (strcmp(own->name, theirs->name) == 0) require_alike(task, map, own->node, theirs->node, "observe", own->name);
        }
    for (size_t i = 0; i < model->validity_count; i++)
        for (size_t k = 0; k < target->validity_count && ttc_task_open(task); k++) {
            const ttc_validity *own = model->validities + i, *theirs = target->validities + k;
            if (strcmp(own->name, theirs->name) == 0)
                require_alike(task, map, own->expression, theirs->expression, "valid", own->name);
        }
    for (size_t i = 0; i < model->claim_count; i++)
        for (size_t k = 0; k < target->claim_count && ttc_task_open(task); k++) {
            const ttc_claim *own = model->claims + i, *theirs = target->claims + k;
            if (is_plain_integral(own) && is_plain_integral(theirs) && strcmp(own->name, theirs->name) == 0)
                require_alike(task, map, own->expression, theirs->expression, "integral", own->name);
        }
}

/* The rows of a matrix of ratios that are linearly independent, by elimination in the field; the matrix is used up.
 * minor *= the minor that shows it, up to its sign. */
static size_t rank_of(ttc_task *task, ttc_ratio *matrix, size_t rows, size_t columns, ttc_ratio *minor)
{
    size_t rank = 0;
    ttc_ratio factor;
    ttc_ratio_init(task->ring, &factor);
    for (size_t j = 0; j < columns && rank < rows && ttc_task_open(task); j++) {
        size_t pivot = rank;
        while (pivot < rows && ttc_ratio_is_zero(task->ring, &matrix[pivot * columns + j])) pivot++;
        if (pivot == rows) continue;
        ttc_ratio_multiply(task->ring, minor, minor, &matrix[pivot * columns + j]);
        for (size_t k = 0; k < columns && pivot != rank; k++) {
            ttc_ratio moved = matrix[pivot * columns + k];
            matrix[pivot * columns + k] = matrix[rank * columns + k];
            matrix[rank * columns + k] = moved;
        }
        for (size_t i = rank + 1; i < rows && ttc_task_open(task); i++) {
            if (ttc_ratio_is_zero(task->ring, &matrix[i * columns + j])) continue;
            ttc_ratio_divide(task->ring, &factor, &matrix[i * columns + j], &matrix[rank * columns + j]);
            ttc_ratio_scale(task->ring, &factor, &factor, task->ring->minus_one);
            for (size_t k = j; k < columns; k++)
                ttc_ratio_add_product(task->ring, &matrix[i * columns + k], &factor, &matrix[rank * columns + k]);
        }
        rank++;
    }
    ttc_ratio_clear(task->ring, &factor);
    return rank;
}

/* Appends the gradient of an expression in the states. */
static void add_gradient(ttc_task *task, ttc_ratio *row, ttc_id expression)
{
    for (size_t j = 0; j < task->model->state_count; j++)
        ttc_evaluate(task->field, &row[j], ttc_derive_state(task->model, expression, j));
}

/* Sort the terms of a polynomial by what moves in them: the sum of those of the first term's kind goes to `same`, the others
 * stay. What does not move is left of the terms in `same`. */
static void take_coefficient(ttc_task *task, fmpz_mpoly_t same, fmpz_mpoly_t polynomial, const bool *moves)
{
    const fmpz_mpoly_ctx_struct *context = task->ring->context;
    slong count = (slong)task->ring->variable_count;
    fmpz_mpoly_t rest, term, power;
    fmpz_mpoly_init(rest, context);
    fmpz_mpoly_init(term, context);
    fmpz_mpoly_init(power, context);
    fmpz_mpoly_zero(same, context);
    for (slong i = 0; i < fmpz_mpoly_length(polynomial, context); i++) {
        bool alike = true;
        for (slong v = 0; alike && v < count; v++)
            alike = !moves[v] || fmpz_mpoly_get_term_var_exp_ui(polynomial, i, v, context)
                                     == fmpz_mpoly_get_term_var_exp_ui(polynomial, 0, v, context);
        fmpz_mpoly_get_term(term, polynomial, i, context);
        for (slong v = 0; alike && v < count; v++) {
            ulong exponent = moves[v] ? fmpz_mpoly_get_term_var_exp_ui(polynomial, i, v, context) : 0;
            if (exponent == 0) continue;
            fmpz_mpoly_gen(power, v, context);
            fmpz_mpoly_pow_ui(power, power, exponent, context);
            fmpz_mpoly_divides(term, term, power, context);
        }
        fmpz_mpoly_struct *sum = alike ? same : rest;
        fmpz_mpoly_add(sum, sum, term, context);
    }
    fmpz_mpoly_swap(polynomial, rest, context);
    fmpz_mpoly_clear(power, context);
    fmpz_mpoly_clear(term, context);
    fmpz_mpoly_clear(rest, context);
}

/* Whatever the parameters, the minor is not zero at all states: its coefficients do not vanish together. */
static void require_minor(ttc_task *task, const ttc_ratio *minor)
{
    bool *moves = calloc(task->ring->variable_count + 1, sizeof *moves);
    fmpz_mpoly_t rest, coefficient;
    ttc_ratio variable;
    size_t mark = ttc_conditions_mark(&task->domain);
    bool contradictory = task->domain.contradictory;
    fmpz_mpoly_init(rest, task->ring->context);
    fmpz_mpoly_init(coefficient, task->ring->context);
    ttc_ratio_init(task->ring, &variable);
    for (slong v = 0; moves != NULL && v < (slong)task->ring->variable_count; v++) {
        ttc_ratio_set_variable(task->ring, &variable, v);
        moves[v] = ttc_task_moves(task, &variable);
    }
    fmpz_mpoly_set(rest, minor->numerator, task->ring->context);
    while (moves != NULL && !fmpz_mpoly_is_zero(rest, task->ring->context)) {
        take_coefficient(task, coefficient, rest, moves);
        ttc_ratio_set_polynomial(task->ring, &variable, coefficient);
        ttc_conditions_add(&task->domain, &variable, TTC_IS_ZERO);
    }
    ttc_search_result result = ttc_task_search(task, NULL, TTC_IS_ZERO, NULL);
    ttc_conditions_rewind(&task->domain, mark, contradictory);
    if (moves == NULL || (result != TTC_POINT_IMPOSSIBLE && result != TTC_POINT_EXCLUDED))
        ttc_task_unsettle(task, "for some parameters the image may be of lower dimension");
    ttc_ratio_clear(task->ring, &variable);
    fmpz_mpoly_clear(coefficient, task->ring->context);
    fmpz_mpoly_clear(rest, task->ring->context);
    free(moves);
}

/* Onto: on a level of the parameters that are given by expressions, and of what the claim is restricted to, the images of the
 * states have the target's dimension, so that the rank of all gradients is that of the parameters' and the number of the target's
 * states. Into: the rank is ours. */
static void require_dimension(ttc_task *task, const ttc_model *target)
{
    size_t n = task->model->state_count, count = 0, parameters = 0;
    ttc_ratio minor;
    ttc_ratio_init(task->ring, &minor);
    ttc_ratio_set_integer(task->ring, &minor, 1);
    size_t rows = task->claim->bindings.count + task->claim->modulo_count;
    ttc_ratio *matrix = ttc_task_ratios(task, rows * n);
    ttc_ratio *levels = ttc_task_ratios(task, rows * n);
    for (size_t i = 0; matrix != NULL && levels != NULL && i < task->claim->bindings.count; i++) {
        uint32_t symbol;
        if (!ttc_model_find_symbol(target, task->claim->target_names[i], &symbol)) continue;
        if (target->symbols[symbol].kind == TTC_ROOT) continue;
        ttc_id image = task->claim->bindings.items[i].expression;
        add_gradient(task, matrix + count++ * n, image);
        if (target->symbols[symbol].kind == TTC_PARAM) add_gradient(task, levels + parameters++ * n, image);
    }
    for (size_t i = 0; matrix != NULL && levels != NULL && i < task->claim->modulo_count; i++) {
        ttc_id level = task->model->claims[task->claim->modulo[i]].expression;
        add_gradient(task, matrix + count++ * n, level);
        add_gradient(task, levels + parameters++ * n, level);
    }
    if (matrix != NULL && levels != NULL) {
        bool onto = task->claim->kind == TTC_CLAIM_REDUCTION;
        size_t fixed = rank_of(task, levels, parameters, n, &minor);
        ttc_ratio_set_integer(task->ring, &minor, 1);
        size_t dimension = rank_of(task, matrix, count, n, &minor) - (onto ? fixed : 0);
        size_t wanted = onto ? target->state_count : n;
        if (ttc_task_open(task) && dimension != wanted)
            ttc_task_refute(task, NULL, "the image has dimension %zu, and %s has %zu states", dimension,
                            onto ? target->name : task->model->name, wanted);
        if (ttc_task_open(task) && onto) require_minor(task, &minor);
        if (ttc_task_open(task) && !onto && ttc_task_search(task, &minor, TTC_IS_NONZERO, NULL) != TTC_POINT_FOUND)
            ttc_task_unsettle(task, "no point is known at which the image has the dimension of this table");
    }
    ttc_ratio_clear(task->ring, &minor);
    ttc_task_free(task, levels, rows * n);
    ttc_task_free(task, matrix, rows * n);
}

/* A root of the image may have got the sign that leaves none. */
static bool has_points(ttc_task *task)
{
    const ttc_search_result result = ttc_task_search(task, NULL, TTC_IS_ZERO, NULL);
    return result != TTC_POINT_IMPOSSIBLE && result != TTC_POINT_EXCLUDED;
}

static void prove_onto(ttc_task *task, const ttc_model *target)
{
    ttc_valuation *map = ttc_valuation_map(target, task->field);
    if (map == NULL) {
        ttc_task_unsettle(task, "out of memory");
        return;
    }
    ttc_task_enter_map(task, map);
    bind_target(task, target, map);
    /* First, as the image's roots are then not yet in the ring, where they would be positive. */
    ttc_domain_require_image(task, map, target, " of the image");
    for (size_t i = 0; i < target->symbol_count && ttc_task_open(task); i++) {
        const ttc_symbol_entry *entry = &target->symbols[i];
        const ttc_id expression = ttc_given_for(task->claim, entry->name);
        if (expression == TTC_NONE) continue;
        if (entry->kind == TTC_ROOT) ttc_domain_require_root(task, map, entry);
        if (entry->kind == TTC_PARAM) ttc_prove_constant(task, entry->name, expression);
    }
    ttc_prove_chain_rule(task, task->claim, target, map);
    ttc_prove_same_observations(task, target, map);
    if (ttc_task_open(task) && has_points(task)) require_dimension(task, target);
    ttc_task_leave_map(task);
    ttc_valuation_destroy(map);
}

void ttc_prove_reduction(ttc_task *task)
{
    if (ttc_task_restricts_states(task)) {
        ttc_task_unsettle(task, "a reduction under a condition on states (expected 'modulo' of what the flow keeps)");
        return;
    }
    char reason[2 * TTC_DIAGNOSTIC_LINE];
    ttc_model *target = ttc_resolve(task->resolver, task->resolver_context, task->model, "the target", task->claim->target, reason,
                                    sizeof reason);
    if (target == NULL) ttc_task_unsettle(task, "%s", reason);
    else prove_onto(task, target);
    ttc_model_destroy(target);
}
