/* Quick tests that an expression is zero whatever the values of quantities on which most of the work of the exact test is spent. */
#include "prove/prove_task.h"

#include <stdlib.h>
#include <string.h>

/* Makes quantities free. Returns their number. */
typedef size_t (*liberation)(ttc_valuation *general);

size_t ttc_free_functions(ttc_valuation *general)
{
    const ttc_model *model = ttc_valuation_model(general);
    size_t count = 0;
    for (uint32_t i = 0; i < model->symbol_count; i++)
        if (ttc_symbol_is_function(model->symbols[i].kind) && !ttc_valuation_is_bound(general, i))
            count += ttc_valuation_free(general, i);
    return count;
}

static size_t free_quotients(ttc_valuation *general)
{
    const ttc_model *model = ttc_valuation_model(general);
    size_t count = 0;
    for (uint32_t i = 0; i < model->symbol_count; i++)
        if (model->symbols[i].kind == TTC_LET && ttc_model_dividing_sum(model, model->symbols[i].definition) != TTC_NONE)
            count += ttc_valuation_free(general, i);
    return count;
}

static size_t free_factors(ttc_valuation *general, ttc_id divisor)
{
    const ttc_model *model = ttc_valuation_model(general);
    const ttc_id base = ttc_model_without_lets(model, divisor);
    size_t count = 0;
    if (ttc_kind_of(model->graph, base) == TTC_SUM) return ttc_valuation_free_expression(general, base);
    if (ttc_kind_of(model->graph, base) == TTC_PRODUCT)
        for (size_t i = 0; i < ttc_part_count(model->graph, base); i++)
            count += free_factors(general, ttc_part_at(model->graph, base, i).id);
    return count;
}

static size_t free_divisors(ttc_valuation *general)
{
    const ttc_model *model = ttc_valuation_model(general);
    size_t count = 0;
    for (size_t i = 0; i < model->divisor_count; i++) count += free_factors(general, model->divisors[i].divisor);
    return count;
}

static bool uses_free(ttc_valuation *general, const ttc_ratio *value);

/* Returns true if the value of a variable may depend on what was made free: a root by its square, any other function always. */
static bool is_in_question(ttc_valuation *general, slong variable)
{
    const ttc_model *model = ttc_valuation_model(general);
    const ttc_generator *root = ttc_ring_generator(ttc_valuation_ring(general), variable);
    const size_t symbol = ttc_valuation_symbol(general, variable);
    if (ttc_valuation_is_free(general, variable)) return true;
    if (root != NULL) return uses_free(general, &root->square);
    return symbol < model->symbol_count && ttc_symbol_is_function(model->symbols[symbol].kind);
}

static bool uses_free(ttc_valuation *general, const ttc_ratio *value)
{
    const ttc_ring *ring = ttc_valuation_ring(general);
    for (slong v = 0; v < (slong)ring->variable_count; v++)
        if (ttc_ratio_uses(ring, value, v) && is_in_question(general, v)) return true;
    return false;
}

/* Returns true if an expression is zero in form: whether functions depend on each other is left to the exact test; or if the signs
 * of roots are not those of the leaf. form: if not zero, gets the value's text, or NULL. */
static bool is_zero(const ttc_task *task, ttc_valuation *general, ttc_id id, char **form)
{
    ttc_ring *ring = ttc_valuation_ring(general);
    ttc_ratio value;
    bool zero = false;
    ttc_ratio_init(ring, &value);
    for (size_t i = 0; !zero && i < task->met_count; i++) {
        ttc_evaluate(general, &value, task->met[i]);
        zero = ring->status == TTC_RING_OK && !ttc_ratio_is_zero(ring, &value) && !uses_free(general, &value);
    }
    ttc_evaluate(general, &value, id);
    zero |= ring->status == TTC_RING_OK && fmpz_mpoly_is_zero(value.numerator, ring->context);
    *form = !zero && ring->status == TTC_RING_OK && ring->choice_count == 0 ? ttc_ratio_text(ring, &value) : NULL;
    ttc_ratio_clear(ring, &value);
    return zero;
}

/* Returns true if an expression is zero with quantities free, if there are at least `fewest`; for each sign of other roots whose
 * radicand is a square. form: NULL, or as above for the first sign that fails. */
static bool is_zero_with(ttc_task *task, liberation liberate, size_t fewest, ttc_id id, char **form)
{
    enum { MOST = 4 };
    size_t most = 0;
    bool zero = true;
    free(*form);
    *form = NULL;
    for (unsigned choices = 0; zero && choices < 1u << most; choices++) {
        ttc_valuation *general = ttc_valuation_alike(task->field, choices);
        if (general == NULL) return false;
        zero = liberate(general) >= fewest && is_zero(task, general, id, form);
        const size_t count = ttc_valuation_ring(general)->choice_count;
        if (count > most) most = count;
        zero &= most <= MOST;
        ttc_valuation_destroy(general);
    }
    return zero;
}

/* Returns true if an expression is zero on the leaf with functions as variables of their own (of one alone the exact test is as
 * quick), or definitions that divide by sums, as multipliers of constraints and reactions do, or sums by which something divides.
 * Else `by_functions` and `by_quotients` get the expression by names of functions and of definitions, or NULL. */
static bool is_zero_in_general(ttc_task *task, ttc_id id, char **by_functions, char **by_quotients)
{
    char *by_divisors = NULL;
    const bool zero = is_zero_with(task, ttc_free_functions, 2, id, by_functions)
                      || is_zero_with(task, free_quotients, 1, id, by_quotients)
                      || is_zero_with(task, free_divisors, 1, id, &by_divisors);
    free(by_divisors); /* divisors have no names */
    return zero;
}

static bool has_many_roots(const ttc_model *model)
{
    enum { MANY = 5 };
    size_t count = 0;
    for (size_t i = 0; i < model->symbol_count; i++) count += model->symbols[i].kind == TTC_ROOT;
    return count >= MANY;
}

/* In a refutation "what = value", show this form of the value if it is shorter. */
static void shorten(ttc_task *task, const char *form)
{
    char *value = task->status == TTC_REFUTED && task->remainder != NULL ? strstr(task->remainder, " = ") : NULL;
    if (form != NULL && value != NULL && strlen(form) < strlen(value + 3)) strcpy(value + 3, form);
}

void ttc_task_require_identity(ttc_task *task, ttc_id left, ttc_id right, const char *what)
{
    const ttc_id difference = ttc_subtract(task->model->graph, left, right);
    char *by_functions = NULL, *by_quotients = NULL;
    bool settled = ttc_task_open(task) && is_zero_in_general(task, difference, &by_functions, &by_quotients);
    if (!settled && ttc_task_open(task) && has_many_roots(task->model) && ttc_task_refute_at_point(task, difference, what)) {
        settled = true;
        shorten(task, by_functions);
    }
    if (!settled) ttc_task_require_equal(task, task->field, left, task->field, right, "%s", what);
    shorten(task, by_quotients);
    free(by_quotients);
    free(by_functions);
    if (ttc_ring_is_too_large(task->ring->status)) ttc_task_refute_at_point(task, difference, what);
}
