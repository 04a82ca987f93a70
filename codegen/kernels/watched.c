#include "kernels/watched.h"

#include <stdlib.h>
#include <string.h>

#include "show/print.h"

/* Whether it is the radicand of a lifted root, which stays positive: only rounding could make it zero. */
static bool is_radicand(ttc_field *field, ttc_id value)
{
    for (size_t i = 0; i < ttc_field_lifted_count(field); i++)
        if (value == ttc_field_specialise(field, field->model->symbols[field->time->lifted[i]].definition)) return true;
    return false;
}

typedef struct {
    uint32_t state;
    ttc_id end;
} replacement;

static ttc_id put_end(void *context, uint32_t symbol)
{
    const replacement *self = context;
    return symbol == self->state ? self->end : TTC_NONE;
}

bool ttc_watched_is_lifted(const ttc_field *field, uint32_t state, ttc_id end)
{
    replacement at = { state, end };
    for (size_t i = 0; i < ttc_field_lifted_count(field); i++) {
        const ttc_id radicand = ttc_model_expand(field->model, field->model->symbols[field->time->lifted[i]].definition);
        const ttc_id there = ttc_substitute(field->graph, radicand, put_end, &at);
        if (there == TTC_NONE) ttc_graph_clear_error(field->graph);
        else if (ttc_is_number(field->graph, there, 0)) return true;
    }
    return false;
}

/* Whether an end needs no condition: there is none, or it is watched without a kernel. */
static bool is_kept(const ttc_field *field, uint32_t state, ttc_id end)
{
    if (end == TTC_NONE) return true;
    if (field->elimination != NULL && field->elimination->state == state) return false;
    if (ttc_field_lifted_count(field) > 0) return ttc_watched_is_lifted(field, state, end);
    return ttc_kind_of(field->graph, end) == TTC_NUMBER;
}

static bool add_record(ttc_watched *condition, const ttc_region *region)
{
    *condition = (ttc_watched){ region->name, strdup(region->text), region->expression };
    return condition->text != NULL;
}

static bool add_end(ttc_watched *condition, const ttc_field *field, uint32_t state, bool is_high)
{
    const ttc_id value = ttc_model_inside(field->model, state, is_high);
    *condition = (ttc_watched){ field->model->symbols[state].name, ttc_print_relation(field->model, value, " > 0"), value };
    return condition->text != NULL;
}

bool ttc_watched_find(ttc_watched **list, size_t *count, ttc_field *field)
{
    const ttc_model *model = field->model;
    bool good = true;
    *count = 0;
    *list = calloc(model->region_count + 2 * model->state_count + 1, sizeof **list);
    if (*list == NULL) return false;
    for (size_t i = 0; good && i < model->region_count; i++) {
        const ttc_id value = ttc_field_specialise(field, model->regions[i].expression);
        if (is_radicand(field, value) || ttc_extent_is_positive(ttc_field_extent(field, value))) continue;
        good = add_record(*list + (*count)++, model->regions + i);
    }
    for (size_t i = 0; i < model->state_count; i++) {
        const uint32_t state = model->states[i];
        if (good && !is_kept(field, state, model->symbols[state].low)) good = add_end(*list + (*count)++, field, state, false);
        if (good && !is_kept(field, state, model->symbols[state].high)) good = add_end(*list + (*count)++, field, state, true);
    }
    return good;
}

void ttc_watched_destroy(ttc_watched *list, size_t count)
{
    for (size_t i = 0; i < count; i++) free(list[i].text);
    free(list);
}
