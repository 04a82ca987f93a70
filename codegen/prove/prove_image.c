#include "prove/domain.h"
#include "prove/prove_image.h"

#include <stdlib.h>

static void add_positive(ttc_task *task, ttc_id id)
{
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    ttc_evaluate(task->field, &value, id);
    ttc_conditions_add(&task->domain, &value, TTC_IS_POSITIVE);
    ttc_ratio_clear(task->ring, &value);
}

static ttc_id sum_of_squares(ttc_graph *graph, const ttc_id *pair)
{
    return ttc_add(graph, ttc_power(graph, pair[0], 2), ttc_power(graph, pair[1], 2));
}

bool ttc_prove_take_spare(uint32_t *spare, const ttc_task *task, uint32_t *spares)
{
    const uint32_t first = (uint32_t)task->model->symbol_count;

    while (*spares < TTC_SPARE_SYMBOLS && ttc_valuation_is_bound(task->field, first + *spares)) ++*spares;
    *spare = first + *spares;
    return (*spares)++ < TTC_SPARE_SYMBOLS;
}

/* The positive root of an expression, as a spare symbol; TTC_NONE if memory is out or no spare symbol is left. */
static ttc_id root_of(ttc_task *task, ttc_id square, uint32_t *spares)
{
    uint32_t spare;
    if (square == TTC_NONE || !ttc_prove_take_spare(&spare, task, spares)) return TTC_NONE;
    const ttc_id root = ttc_symbol(task->model->graph, spare);
    ttc_valuation_bind_root(task->field, spare, square);
    return root;
}

/* Bind sine and cosine of an angle atan2(A, B) to A/r and B/r, where the spare symbol r is the positive root of A^2 + B^2. */
static bool bind_angle(ttc_task *task, ttc_valuation *map, uint32_t cosine, const ttc_id *entries, uint32_t *spares)
{
    ttc_graph *graph = task->model->graph;
    const ttc_id length = root_of(task, sum_of_squares(graph, entries), spares);
    if (length == TTC_NONE) return false;
    const ttc_id sine_value = ttc_divide(graph, entries[0], length), cosine_value = ttc_divide(graph, entries[1], length);
    if (sine_value == TTC_NONE || cosine_value == TTC_NONE) return false;
    ttc_valuation_bind(map, cosine, cosine_value);
    ttc_valuation_bind(map, ttc_valuation_model(map)->symbols[cosine].partner, sine_value);
    add_positive(task, length);
    return true;
}

/* Bind a symbol to a root. Not settled unless it is excluded that the root is zero, which a generator of the ring never is. */
static bool bind_root(ttc_task *task, ttc_valuation *map, uint32_t symbol, ttc_id square, uint32_t *spares)
{
    const char *name = ttc_valuation_model(map)->symbols[symbol].name;
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    ttc_evaluate(task->field, &value, square);
    ttc_task_require(task, &value, TTC_IS_NONNEGATIVE, "negative: what %s is the root of", name);
    if (ttc_task_open(task)) {
        const ttc_search_result zero = ttc_task_search_against(task, &value, TTC_IS_NONZERO, NULL);
        if (zero != TTC_POINT_IMPOSSIBLE && zero != TTC_POINT_EXCLUDED)
            ttc_task_unsettle(task, "what %s is the root of may be zero (expected a condition that excludes it)", name);
    }
    ttc_ratio_clear(task->ring, &value);
    const ttc_id root = root_of(task, square, spares);
    if (root == TTC_NONE) return false;
    ttc_valuation_bind(map, symbol, root);
    if (ttc_task_open(task)) add_positive(task, root);
    return true;
}

/* Require that a point is known at which every angle has a value. This is done before roots are adjoined: if the sign of a root is
 * a choice, one of the choices leaves no points. */
static void require_point(ttc_task *task, const ttc_claim *claim, const ttc_image *image)
{
    for (size_t k = 0; k < image->count && ttc_task_open(task); k++)
        if (image->forms[k] == TTC_GIVEN_ANGLE) add_positive(task, sum_of_squares(task->model->graph, claim->entries + 2 * k));
    if (ttc_task_open(task) && ttc_task_search(task, NULL, TTC_IS_ZERO, NULL) != TTC_POINT_FOUND)
        ttc_task_unsettle(task, "no point is known that it speaks of, and at which every angle has a value");
}

void ttc_prove_bind_image(ttc_task *task, ttc_valuation *map, const ttc_claim *claim, const ttc_image *image)
{
    const ttc_model *table = ttc_valuation_model(map);
    uint32_t spares = 0;
    bool ok = true;
    require_point(task, claim, image);
    /* Angles first: the condition that they have a value may exclude that a root is zero. */
    for (size_t i = 0; i < table->state_count && ok && ttc_task_open(task); i++) {
        const size_t k = ttc_image_state(image, table, i);
        uint32_t cosine;
        if (image->forms[k] != TTC_GIVEN_ANGLE) ttc_valuation_bind(map, table->states[i], claim->entries[2 * k]);
        else ok = ttc_angle_cosine(table, table->states[i], &cosine) &&
                  bind_angle(task, map, cosine, claim->entries + 2 * k, &spares);
    }
    for (size_t i = 0; i < table->param_count && ok && ttc_task_open(task); i++) {
        bool is_root;
        const ttc_id value = ttc_image_param(task->model, claim, image, table, i, &is_root);
        if (!is_root) ttc_valuation_bind(map, table->params[i], value);
        else ok = bind_root(task, map, table->params[i], value, &spares);
    }
    if (!ok) ttc_task_unsettle(task, "out of memory, or more than %d angles and roots", TTC_SPARE_SYMBOLS);
}

/* q = atan2(A, B) means A cos q - B sin q = 0 and A sin q + B cos q > 0; given the first, the second is zero only if A = B = 0. */
static void return_angle(ttc_task *task, ttc_ratio *a, ttc_ratio *b, uint32_t cosine, const char *name, bool where_angles)
{
    enum { COSINE, SINE, ACROSS, ALONG, COUNT };
    const ttc_model *table = task->model;
    ttc_ratio *r = ttc_task_ratios(task, COUNT);
    if (r == NULL) return;
    ttc_evaluate(task->field, &r[COSINE], table->symbols[cosine].node);
    ttc_evaluate(task->field, &r[SINE], table->symbols[table->symbols[cosine].partner].node);
    ttc_ratio_add_product(task->ring, &r[ALONG], a, &r[SINE]);
    ttc_ratio_add_product(task->ring, &r[ALONG], b, &r[COSINE]);
    ttc_ratio_multiply(task->ring, &r[ACROSS], a, &r[COSINE]);
    ttc_ratio_multiply(task->ring, b, b, &r[SINE]);
    ttc_ratio_subtract(task->ring, &r[ACROSS], &r[ACROSS], b);
    ttc_task_require_zero(task, &r[ACROSS], "the way back does not lead to %s: across it", name);
    if (where_angles) ttc_conditions_add(&task->domain, &r[ALONG], TTC_IS_NONZERO);
    ttc_task_require(task, &r[ALONG], TTC_IS_POSITIVE, "the way back leads to the opposite of %s: along it", name);
    ttc_task_free(task, r, COUNT);
}

void ttc_prove_return(ttc_task *task, ttc_valuation *map, const ttc_claim *claim, const ttc_image *image, size_t state,
                      bool where_angles)
{
    const ttc_model *table = task->model;
    const ttc_symbol_entry *entry = table->symbols + table->states[state];
    const size_t k = ttc_image_state(image, table, state);
    uint32_t cosine;
    ttc_ratio *r = ttc_task_ratios(task, 2);
    if (r == NULL) return;
    ttc_evaluate(map, &r[0], claim->entries[2 * k]);
    ttc_evaluate(map, &r[1], claim->entries[2 * k + 1]);
    if (image->forms[k] == TTC_GIVEN_ANGLE && ttc_angle_cosine(table, table->states[state], &cosine)) {
        return_angle(task, &r[0], &r[1], cosine, entry->name, where_angles);
    } else {
        ttc_task_take_off(task, &r[0], task->field, entry->node);
        ttc_task_require_zero(task, &r[0], "where the way back leads - %s", entry->name);
    }
    ttc_task_free(task, r, 2);
}

void ttc_prove_divisors(ttc_task *task, ttc_valuation *valuation, uint32_t claim, size_t use_count, const char *where)
{
    unsigned char *used = ttc_model_uses_between(ttc_valuation_model(valuation), TTC_DIVIDES_CLAIM, claim, 0, use_count);
    if (used == NULL) ttc_task_unsettle(task, "out of memory");
    else ttc_domain_require_divisors(task, valuation, TTC_DIVIDES_CLAIM, claim, used, where);
    free(used);
}
