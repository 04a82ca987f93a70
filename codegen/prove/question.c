#include "prove/question.h"

#include <stdlib.h>

bool ttc_question_is_tested(const ttc_task *task, uint32_t symbol)
{
    ttc_symbol_kind kind = task->model->symbols[symbol].kind;
    for (size_t i = 0; task->tested != NULL && i < task->tested->count; i++)
        if (task->tested->items[i].symbol == symbol) return true;
    return task->tested_root != 0 && symbol >= task->tested_root && (kind == TTC_ROOT || kind == TTC_LOG);
}

bool ttc_question_depends(const ttc_task *task, ttc_id id)
{
    if (task->tested == NULL && task->tested_root == 0) return false;
    unsigned char *support = ttc_model_support(task->model, &id, 1);
    bool result = support == NULL;
    for (uint32_t i = 0; !result && i < task->model->symbol_count; i++) result = support[i] && ttc_question_is_tested(task, i);
    free(support);
    return result;
}

bool ttc_question_has(const ttc_task *task, uint32_t symbol)
{
    const ttc_symbol_entry *entry = &task->model->symbols[symbol];
    return (entry->kind == TTC_ROOT || entry->kind == TTC_LOG) && symbol >= task->shown && ttc_question_depends(task, entry->node);
}

uint32_t ttc_question_last(const ttc_task *task, ttc_id id)
{
    if (task->tested == NULL && task->tested_root == 0) return 0;
    unsigned char *support = ttc_model_support(task->model, &id, 1);
    uint32_t last = support == NULL ? UINT32_MAX : (uint32_t)task->model->symbol_count - 1;
    while (support != NULL && last > 0 && !(support[last] && ttc_question_has(task, last))) last--;
    free(support);
    return last;
}

bool ttc_question_uses_root(const ttc_task *task, ttc_id id) { return ttc_question_last(task, id) != 0; }

void ttc_question_withhold(ttc_task *task)
{
    if (task->tested == NULL && task->tested_root == 0) return;
    for (uint32_t i = 0; i < task->model->symbol_count; i++) {
        const ttc_symbol_entry *entry = &task->model->symbols[i];
        const bool may_join = entry->kind == TTC_COSINE || entry->kind == TTC_EXP || entry->kind == TTC_LOG;
        if (may_join && ttc_question_uses_root(task, entry->node)) ttc_valuation_withhold(task->field, i);
    }
}
