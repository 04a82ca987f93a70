#include "prove/vanishing.h"

#include <stdlib.h>

bool *ttc_vanishing_moves(ttc_task *task)
{
    bool *moves = calloc(task->ring->variable_count + 1, sizeof *moves);
    ttc_ratio variable;
    ttc_ratio_init(task->ring, &variable);
    for (slong v = 0; moves != NULL && v < (slong)task->ring->variable_count; v++) {
        ttc_ratio_set_variable(task->ring, &variable, v);
        moves[v] = ttc_task_moves(task, &variable);
    }
    ttc_ratio_clear(task->ring, &variable);
    return moves;
}

/* Remove from a polynomial all terms with the first term's monomial in moving variables. same = their sum divided by it. */
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

ttc_search_result ttc_vanishing_search(ttc_task *task, const fmpz_mpoly_t polynomial, const fmpz_mpoly_t below, const bool *moves,
                                       char **text)
{
    fmpz_mpoly_t rest, coefficient;
    ttc_ratio value, divisor;
    const size_t mark = ttc_conditions_mark(&task->domain), aside = task->aside_count;
    const bool contradictory = task->domain.contradictory;
    fmpz_mpoly_init(rest, task->ring->context);
    fmpz_mpoly_init(coefficient, task->ring->context);
    ttc_ratio_init(task->ring, &value);
    ttc_ratio_init(task->ring, &divisor);
    ttc_ratio_set_polynomial(task->ring, &divisor, below);
    if (!ttc_task_moves(task, &divisor) && ttc_task_put_aside(task, below))
        ttc_conditions_add(&task->domain, &divisor, TTC_IS_NONZERO);
    fmpz_mpoly_set(rest, polynomial, task->ring->context);
    while (!fmpz_mpoly_is_zero(rest, task->ring->context)) {
        take_coefficient(task, coefficient, rest, moves);
        ttc_ratio_set_polynomial(task->ring, &value, coefficient);
        ttc_conditions_add(&task->domain, &value, TTC_IS_ZERO);
    }
    ttc_search_result result = ttc_task_search(task, NULL, TTC_IS_ZERO, NULL);
    if (result == TTC_POINT_FOUND && ttc_task_search(task, &divisor, TTC_IS_NONZERO, text) != TTC_POINT_FOUND)
        result = TTC_POINT_NOT_DECIDED;
    if (result == TTC_POINT_FOUND || result == TTC_POINT_NOT_DECIDED) task->aside_count = aside;
    ttc_conditions_rewind(&task->domain, mark, contradictory);
    ttc_ratio_clear(task->ring, &divisor);
    ttc_ratio_clear(task->ring, &value);
    fmpz_mpoly_clear(coefficient, task->ring->context);
    fmpz_mpoly_clear(rest, task->ring->context);
    return result;
}
