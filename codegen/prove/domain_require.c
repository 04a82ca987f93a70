/* Requirements that values, in the task's field or at an image, meet the conditions of a table's records. */
#include "prove/domain.h"
#include "prove/question.h"
#include "prove/signs.h"

#include <stdlib.h>

/* Require that a state lies above (direction = 1) or below (-1) an end of its interval; end = TTC_NONE: no end. */
static void require_end(ttc_task *task, ttc_valuation *map, const ttc_symbol_entry *entry, ttc_id end, int direction,
                        const char *where)
{
    ttc_ratio value, limit;
    if (end == TTC_NONE || !ttc_task_open(task)) return;
    ttc_ratio_init(task->ring, &value);
    ttc_ratio_init(task->ring, &limit);
    ttc_evaluate(map, &value, entry->node);
    ttc_evaluate(map, &limit, end);
    if (direction > 0) ttc_ratio_subtract(task->ring, &value, &value, &limit);
    else ttc_ratio_subtract(task->ring, &value, &limit, &value);
    ttc_task_require(task, &value, TTC_IS_POSITIVE, "%s leaves its interval%s: %s", entry->name, where,
                     direction > 0 ? "above the lower end by" : "below the upper end by");
    ttc_ratio_clear(task->ring, &limit);
    ttc_ratio_clear(task->ring, &value);
}

void ttc_domain_require_symbol(ttc_task *task, ttc_valuation *map, const ttc_model *model, uint32_t symbol, const char *where)
{
    const ttc_symbol_entry *entry = &model->symbols[symbol];
    if (map == NULL) map = task->field;
    if (entry->kind == TTC_STATE) {
        require_end(task, map, entry, entry->low, 1, where);
        require_end(task, map, entry, entry->high, -1, where);
    } else if (entry->kind == TTC_ROOT || entry->kind == TTC_LOG) {
        ttc_signs_require(task, map, entry->definition, TTC_IS_POSITIVE,
                          "not positive: what the root or logarithm is taken of, %s%s", entry->name, where);
    } else if (entry->kind == TTC_PARAM && entry->sign != TTC_ANY_SIGN) {
        ttc_signs_require(task, map, entry->node, ttc_domain_relation(entry->sign), "the sign is broken, of %s%s", entry->name,
                          where);
    }
}

void ttc_domain_require_image(ttc_task *task, ttc_valuation *map, const char *where)
{
    const ttc_model *model = ttc_valuation_model(map);
    for (uint32_t i = 0; i < model->symbol_count && ttc_task_open(task); i++) ttc_domain_require_symbol(task, map, model, i, where);
    for (size_t i = 0; i < model->region_count && ttc_task_open(task); i++) {
        ttc_signs_require(task, map, model->regions[i].expression, TTC_IS_POSITIVE, "the domain record %s is broken%s",
                          model->regions[i].name, where);
    }
    unsigned char *used = ttc_model_uses_of_domain(model);
    if (used == NULL) ttc_ring_fail(task->ring, TTC_RING_NO_MEMORY);
    else ttc_domain_require_divisors(task, map, TTC_DIVIDES_FIELD, 0, used, where);
    free(used);
}

void ttc_domain_require_root(ttc_task *task, ttc_valuation *map, const ttc_symbol_entry *entry)
{
    ttc_ratio root, radicand;
    ttc_ratio_init(task->ring, &root);
    ttc_ratio_init(task->ring, &radicand);
    ttc_evaluate(map, &root, entry->node);
    ttc_evaluate(map, &radicand, entry->definition);
    ttc_task_require(task, &root, TTC_IS_POSITIVE, "not positive: the image of the root %s", entry->name);
    ttc_ratio_multiply(task->ring, &root, &root, &root);
    ttc_ratio_subtract(task->ring, &root, &root, &radicand);
    ttc_task_require_zero(task, &root, "%s^2 - its radicand", entry->name);
    ttc_ratio_clear(task->ring, &radicand);
    ttc_ratio_clear(task->ring, &root);
}

void ttc_domain_require_roots(ttc_task *task, ttc_valuation *map)
{
    const ttc_model *model = ttc_valuation_model(map);
    for (uint32_t i = 0; i < model->symbol_count && ttc_task_open(task); i++)
        if (model->symbols[i].kind == TTC_ROOT && ttc_valuation_is_bound(map, i))
            ttc_domain_require_root(task, map, model->symbols + i);
}

/* Require the domain records on symbols under test whose last root in question is symbol `last`, taking it and those before it as
 * shown; last = 0: the records without such a root. */
static void require_regions(ttc_task *task, uint32_t last)
{
    const ttc_model *model = task->model;
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    for (size_t i = 0; i < model->region_count && ttc_task_open(task); i++) {
        ttc_id region = model->regions[i].expression;
        task->shown = last;
        if (!ttc_domain_is_of_tested(task, region) || ttc_question_last(task, region) != last) continue;
        task->shown = last == 0 ? 0 : last + 1;
        ttc_evaluate(task->field, &value, region);
        ttc_task_require(task, &value, TTC_IS_POSITIVE, "the domain record %s is broken in the variant", model->regions[i].name);
    }
    ttc_ratio_clear(task->ring, &value);
}

void ttc_domain_require_tested(ttc_task *task)
{
    if (task->extent == TTC_DOMAIN_OUT_OF_QUESTION) ttc_domain_require_field(task);
    for (size_t i = 0; i < task->tested->count && ttc_task_open(task); i++)
        ttc_domain_require_symbol(task, NULL, task->model, task->tested->items[i].symbol, " in the variant");
    require_regions(task, 0);
    for (uint32_t i = 1; i < task->model->symbol_count && ttc_task_open(task); i++) {
        task->shown = i;
        if (ttc_question_has(task, i)) require_regions(task, i);
    }
}
