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
        const ttc_id ends[] = { model->symbols[state].low, model->symbols[state].high };
        for (int k = 0; k < 2; k++)
            if (good && ttc_end_is_condition(model, field->time, field->elimination, state, ends[k]))
                good = add_end(*list + (*count)++, field, state, k == 1);
    }
    return good;
}

void ttc_watched_destroy(ttc_watched *list, size_t count)
{
    for (size_t i = 0; i < count; i++) free(list[i].text);
    free(list);
}
