/* Quick tests that an expression is zero whatever the values of quantities on which most of the work of the exact test is spent. */
#include "prove/prove_task.h"

#include <stdlib.h>

/* Returns true for a quotient, or a product with one, whose divisor is a sum, by its name or not. */
static bool divides_by_sum(const ttc_model *model, ttc_id id)
{
    if (ttc_kind_of(model->graph, id) != TTC_PRODUCT) return false;
    for (size_t i = 0; i < ttc_part_count(model->graph, id); i++) {
        const ttc_part part = ttc_part_at(model->graph, id, i);
        const ttc_id base = ttc_model_without_lets(model, part.id);
        if (part.exponent < 0 && ttc_kind_of(model->graph, base) == TTC_SUM) return true;
    }
    return false;
}

/* Make all roots, or all lets that divide by sums, free. Returns their number. */
static size_t free_all(ttc_valuation *general, ttc_symbol_kind kind)
{
    const ttc_model *model = ttc_valuation_model(general);
    size_t count = 0;
    for (uint32_t i = 0; i < model->symbol_count; i++)
        if (model->symbols[i].kind == kind && (kind != TTC_LET || divides_by_sum(model, model->symbols[i].definition)))
            count += ttc_valuation_free(general, i);
    return count;
}

static bool uses_free(ttc_valuation *general, const ttc_ratio *value)
{
    for (uint32_t i = 0; i < ttc_valuation_model(general)->symbol_count; i++)
        if (ttc_valuation_is_free(general, i)
            && ttc_ratio_uses(ttc_valuation_ring(general), value, ttc_valuation_variable(general, i)))
            return true;
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

/* Returns true if an expression is zero with all roots, or all lets that divide by sums, free, if there are at least `fewest`; for
 * each sign of other roots whose radicand is a square. form: NULL, or as above for the first sign that fails. */
static bool is_zero_with_free(ttc_task *task, ttc_id id, ttc_symbol_kind kind, size_t fewest, char **form)
{
    enum { MOST = 4 };
    size_t most = 0;
    bool zero = true;
    for (unsigned choices = 0; zero && choices < 1u << most; choices++) {
        ttc_valuation *general = ttc_valuation_alike(task->field, choices);
        if (general == NULL) return false;
        zero = free_all(general, kind) >= fewest && is_zero(task, general, id, form);
        const size_t count = ttc_valuation_ring(general)->choice_count;
        if (count > most) most = count;
        zero &= most <= MOST;
        ttc_valuation_destroy(general);
    }
    return zero;
}

/* With one root alone the exact test is as quick. */
bool ttc_task_is_zero_in_general(ttc_task *task, ttc_id id, char **form)
{
    *form = NULL;
    if (is_zero_with_free(task, id, TTC_ROOT, 2, form)) return true;
    free(*form);
    *form = NULL;
    return is_zero_with_free(task, id, TTC_LET, 1, form);
}
