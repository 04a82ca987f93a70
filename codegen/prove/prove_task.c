#include "prove/prove_task.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { REMAINDER_LIMIT = 4000 /* characters kept of a remainder */ };

static char *format_text(const char *format, va_list arguments)
{
    va_list copy;
    va_copy(copy, arguments);
    int length = vsnprintf(NULL, 0, format, copy);
    va_end(copy);
    char *text = length < 0 ? NULL : malloc((size_t)length + 1);
    if (text != NULL) vsnprintf(text, (size_t)length + 1, format, arguments);
    return text;
}

static char *join(char *what, char *value)
{
    if (what == NULL || value == NULL) {
        free(value);
        return what;
    }
    size_t shown = strlen(value) > REMAINDER_LIMIT ? REMAINDER_LIMIT : strlen(value);
    size_t size = strlen(what) + shown + 64;
    char *text = malloc(size);
    if (text != NULL)
        snprintf(text, size, "%s = %.*s%s", what, (int)shown, value, shown < strlen(value) ? " ... (cut)" : "");
    free(value);
    free(what);
    return text;
}

void ttc_task_refute(ttc_task *task, const ttc_ratio *remainder, const char *format, ...)
{
    if (!ttc_task_open(task)) return;
    va_list arguments;
    va_start(arguments, format);
    task->status = TTC_REFUTED;
    free(task->remainder);
    task->remainder = format_text(format, arguments);
    va_end(arguments);
    if (remainder != NULL) task->remainder = join(task->remainder, ttc_ratio_text(task->ring, remainder));
}

void ttc_task_reject(ttc_task *task, const char *format, ...)
{
    if (task->status != TTC_PROVED) return;
    va_list arguments;
    va_start(arguments, format);
    task->status = TTC_MEANINGLESS;
    free(task->remainder);
    task->remainder = format_text(format, arguments);
    va_end(arguments);
}

void ttc_task_require_zero(ttc_task *task, const ttc_ratio *remainder, const char *format, ...)
{
    if (!ttc_task_open(task) || ttc_ratio_is_zero(task->ring, remainder)) return;
    va_list arguments;
    va_start(arguments, format);
    task->status = TTC_REFUTED;
    free(task->remainder);
    task->remainder = join(format_text(format, arguments), ttc_ratio_text(task->ring, remainder));
    va_end(arguments);
}

bool ttc_task_open(const ttc_task *task)
{
    return task->status == TTC_PROVED && task->ring->status == TTC_RING_OK;
}

const ttc_claim *ttc_task_family(const ttc_task *task)
{
    switch (task->claim->kind) {
    case TTC_CLAIM_EQUILIBRIA: return task->claim;
    case TTC_CLAIM_TRACE:
    case TTC_CLAIM_CHARPOLY:
    case TTC_CLAIM_OBSTRUCTS:
    case TTC_CLAIM_MATRIX:
    case TTC_CLAIM_LEFT_NULL: return &task->model->claims[task->claim->family];
    default: return NULL;
    }
}

static bool in_domain(const ttc_task *task, const ttc_symbol_entry *entry, const fmpq_t value)
{
    const ttc_graph *graph = task->model->graph;
    if (entry->kind == TTC_PARAM) {
        int sign = fmpq_sgn(value);
        if (entry->sign == TTC_POSITIVE) return sign > 0;
        if (entry->sign == TTC_NONNEGATIVE) return sign >= 0;
        return entry->sign != TTC_NONZERO || sign != 0;
    }
    if (entry->kind != TTC_STATE) return true;
    bool above = entry->low == TTC_NONE || ttc_kind_of(graph, entry->low) != TTC_NUMBER
                 || fmpq_cmp(value, ttc_coefficient(graph, entry->low)) > 0;
    bool below = entry->high == TTC_NONE || ttc_kind_of(graph, entry->high) != TTC_NUMBER
                 || fmpq_cmp(value, ttc_coefficient(graph, entry->high)) < 0;
    return above && below;
}

void ttc_task_check_domain(ttc_task *task)
{
    ttc_ratio value;
    fmpq_t number;
    ttc_ratio_init(task->ring, &value);
    fmpq_init(number);
    for (uint32_t i = 0; i < task->model->symbol_count; i++) {
        const ttc_symbol_entry *entry = &task->model->symbols[i];
        if (!ttc_valuation_is_bound(task->field, i)) continue;
        ttc_evaluate(task->field, &value, entry->node);
        if (ttc_task_open(task) && ttc_ratio_get_rational(task->ring, number, &value) && !in_domain(task, entry, number))
            ttc_task_reject(task, "%s lies outside its domain under the conditions of this claim", entry->name);
    }
    fmpq_clear(number);
    ttc_ratio_clear(task->ring, &value);
}

void ttc_task_jacobian(ttc_task *task, ttc_ratio *out, size_t row, size_t column)
{
    ttc_id entry = ttc_derive_state(task->model, ttc_model_field(task->model, row), column);
    ttc_evaluate(task->field, out, entry);
}

ttc_ratio *ttc_task_ratios(ttc_task *task, size_t count)
{
    ttc_ratio *ratios = malloc((count + 1) * sizeof *ratios);
    if (ratios == NULL) {
        ttc_task_reject(task, "out of memory");
        return NULL;
    }
    for (size_t i = 0; i < count; i++) ttc_ratio_init(task->ring, &ratios[i]);
    return ratios;
}

void ttc_task_free(ttc_task *task, ttc_ratio *ratios, size_t count)
{
    if (ratios == NULL) return;
    for (size_t i = 0; i < count; i++) ttc_ratio_clear(task->ring, &ratios[i]);
    free(ratios);
}
