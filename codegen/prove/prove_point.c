/* A rational equilibrium inside the model's domain at which the trace is not zero, as exact evidence. Which points are
 * tried is no part of the proof; what holds at the one that is found is. */
#include "prove/prove_task.h"

#include <stdio.h>
#include <stdlib.h>

enum { ATTEMPTS = 400 };

typedef struct {
    ttc_task *task;
    ttc_valuation *values;
    ttc_ring *ring;
    ttc_id *chosen; /* by symbol; TTC_NONE: bound by the family */
} point;

/* Small numbers of both signs in a fixed, mixing order. */
static ttc_id candidate(ttc_task *task, unsigned attempt, size_t index)
{
    static const int numerators[] = { 1, 1, 2, -1, 3, -1, 1, 2, -2, 3, 1, -3, 5 };
    static const int denominators[] = { 2, 1, 3, 2, 2, 3, 3, 1, 3, 1, 5, 5, 4 };
    size_t k = (attempt * (2 * index + 1) + index) % (sizeof numerators / sizeof *numerators);
    fmpq_t value;
    fmpq_init(value);
    fmpq_set_si(value, numerators[k], (ulong)denominators[k]);
    ttc_id node = ttc_number(task->model->graph, value);
    fmpq_clear(value);
    return node;
}

static void choose(point *w, unsigned attempt)
{
    const ttc_model *model = w->task->model;
    for (uint32_t i = 0; i < model->symbol_count; i++) {
        ttc_symbol_kind kind = model->symbols[i].kind;
        w->chosen[i] = TTC_NONE;
        if ((kind != TTC_PARAM && kind != TTC_STATE) || ttc_valuation_is_bound(w->task->field, i))
            continue;
        bool by_default = attempt % 2 == 0 && kind == TTC_PARAM && model->symbols[i].value != TTC_NONE;
        w->chosen[i] = by_default ? model->symbols[i].value : candidate(w->task, attempt, i);
    }
}

static void bind_family(point *w)
{
    const ttc_claim *claim = w->task->claim, *family = ttc_task_family(w->task);
    const ttc_bindings *all[] = { &claim->when, &family->when, &family->bindings };
    for (size_t k = 0; k < 3; k++)
        for (size_t i = 0; i < all[k]->count; i++)
            ttc_valuation_bind(w->values, all[k]->items[i].symbol, all[k]->items[i].expression);
    for (uint32_t i = 0; i < w->task->model->symbol_count; i++)
        if (w->chosen[i] != TTC_NONE) ttc_valuation_bind(w->values, i, w->chosen[i]);
}

/* sign of (value of id) - bound, for rational values; 2 when it is not told */
static int compare(point *w, const fmpq_t value, ttc_id bound)
{
    int sign = 2;
    ttc_ratio ratio;
    fmpq_t number;
    ttc_ratio_init(w->ring, &ratio);
    fmpq_init(number);
    ttc_evaluate(w->values, &ratio, bound);
    if (w->ring->status == TTC_RING_OK && ttc_ratio_get_rational(w->ring, number, &ratio)) {
        int order = fmpq_cmp(value, number);
        sign = (order > 0) - (order < 0);
    }
    fmpq_clear(number);
    ttc_ratio_clear(w->ring, &ratio);
    return sign;
}

static bool quantity_in_domain(point *w, const ttc_symbol_entry *entry)
{
    bool inside = false;
    ttc_ratio ratio;
    fmpq_t value;
    ttc_ratio_init(w->ring, &ratio);
    fmpq_init(value);
    ttc_evaluate(w->values, &ratio, entry->node);
    if (w->ring->status != TTC_RING_OK) goto done;
    bool bounded = entry->kind == TTC_PARAM ? entry->sign != TTC_ANY_SIGN
                                            : entry->low != TTC_NONE || entry->high != TTC_NONE;
    inside = !bounded;
    if (inside || !ttc_ratio_get_rational(w->ring, value, &ratio)) goto done;
    int sign = fmpq_sgn(value);
    if (entry->kind == TTC_PARAM)
        inside = sign > 0 || (sign == 0 && entry->sign == TTC_NONNEGATIVE) || (sign < 0 && entry->sign == TTC_NONZERO);
    else
        inside = (entry->low == TTC_NONE || compare(w, value, entry->low) == 1)
                 && (entry->high == TTC_NONE || compare(w, value, entry->high) == -1);
done:
    fmpq_clear(value);
    ttc_ratio_clear(w->ring, &ratio);
    return inside;
}

static bool in_domain(point *w)
{
    bool inside = true;
    for (uint32_t i = 0; inside && i < w->task->model->symbol_count; i++) {
        ttc_symbol_kind kind = w->task->model->symbols[i].kind;
        if (kind == TTC_PARAM || kind == TTC_STATE) inside = quantity_in_domain(w, &w->task->model->symbols[i]);
    }
    return inside;
}

/* An equilibrium with nonzero trace, roots positive. */
static bool trace_is_nonzero(point *w)
{
    const ttc_model *model = w->task->model;
    bool ok = in_domain(w);
    ttc_ratio value, trace;
    ttc_ratio_init(w->ring, &value);
    ttc_ratio_init(w->ring, &trace);
    for (uint32_t i = 0; ok && i < model->symbol_count; i++)
        if (model->symbols[i].kind == TTC_ROOT) ttc_evaluate(w->values, &value, model->symbols[i].node);
    for (size_t i = 0; ok && i < model->state_count; i++) {
        ttc_evaluate(w->values, &value, ttc_model_field(model, i));
        ok = w->ring->status == TTC_RING_OK && ttc_ratio_is_zero(w->ring, &value);
        ttc_evaluate(w->values, &value, ttc_derive_state(model, ttc_model_field(model, i), i));
        ttc_ratio_add(w->ring, &trace, &trace, &value);
    }
    ok = ok && w->ring->status == TTC_RING_OK && w->ring->choice_count == 0 && !ttc_ratio_is_zero(w->ring, &trace);
    ttc_ratio_clear(w->ring, &trace);
    ttc_ratio_clear(w->ring, &value);
    return ok;
}

/* The numbers chosen, as "NAME = VALUE NAME = VALUE ..." */
static char *point_text(const point *w)
{
    char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    if (stream == NULL) return NULL;
    for (uint32_t i = 0; i < w->task->model->symbol_count; i++)
        if (w->chosen[i] != TTC_NONE) {
            char *value = fmpq_get_str(NULL, 10, ttc_coefficient(w->task->model->graph, w->chosen[i]));
            fprintf(stream, "%s%s = %s", ftell(stream) > 0 ? ", " : "", w->task->model->symbols[i].name, value);
            flint_free(value);
        }
    return fclose(stream) == 0 ? text : NULL;
}

void ttc_task_find_witness(ttc_task *task)
{
    char *text = NULL;
    point w = { .task = task };
    w.chosen = calloc(task->model->symbol_count, sizeof *w.chosen);
    for (unsigned attempt = 0; w.chosen != NULL && text == NULL && attempt < ATTEMPTS; attempt++) {
        choose(&w, attempt);
        w.values = ttc_valuation_create(task->model, 0);
        if (w.values == NULL) break;
        w.ring = ttc_valuation_ring(w.values);
        bind_family(&w);
        if (trace_is_nonzero(&w)) text = point_text(&w);
        ttc_valuation_destroy(w.values);
    }
    free(w.chosen);
    if (text == NULL) {
        ttc_task_reject(task, "no point of the family inside the model's domain was found");
    } else {
        free(task->remainder);
        task->remainder = text;
    }
}
