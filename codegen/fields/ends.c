#include "fields/ends.h"

typedef struct {
    uint32_t state;
    ttc_id end;
} replacement;

static ttc_id put_end(void *context, uint32_t symbol)
{
    const replacement *self = context;
    return symbol == self->state ? self->end : TTC_NONE;
}

/* Whether some root that this time lifts is zero at this end. */
static bool is_lifted_zero(const ttc_model *model, const ttc_time *time, uint32_t state, ttc_id end)
{
    replacement at = { state, end };
    for (size_t i = 0; i < time->lifted_count; i++) {
        const ttc_id radicand = ttc_model_expand(model, model->symbols[time->lifted[i]].definition);
        const ttc_id there = ttc_substitute(model->graph, radicand, put_end, &at);
        if (there == TTC_NONE) ttc_graph_clear_error(model->graph);
        else if (ttc_is_number(model->graph, there, 0)) return true;
    }
    return false;
}

bool ttc_end_is_condition(const ttc_model *model, const ttc_time *time, const ttc_elimination *elimination, uint32_t state,
                          ttc_id end)
{
    if (end == TTC_NONE) return false;
    if (elimination != NULL && elimination->state == state) return true;
    if (time != NULL && time->lifted_count > 0) return !is_lifted_zero(model, time, state, end);
    return ttc_kind_of(model->graph, end) != TTC_NUMBER;
}
