#include "prove/image.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static size_t position_of(char *const *names, size_t count, const char *name)
{
    size_t i = 0;
    while (i < count && strcmp(names[i], name) != 0) i++;
    return i;
}

size_t ttc_image_name(const ttc_image *image, const char *name) { return position_of(image->names, image->count, name); }

size_t ttc_image_state(const ttc_image *image, const ttc_model *table, size_t i)
{
    return ttc_image_name(image, table->symbols[table->states[i]].name);
}

uint32_t ttc_param_of(const ttc_model *model, const char *name)
{
    uint32_t symbol;
    return ttc_model_find_symbol(model, name, &symbol) && model->symbols[symbol].kind == TTC_PARAM ? symbol : UINT32_MAX;
}

ttc_id ttc_image_param(const ttc_model *model, const ttc_claim *claim, const ttc_image *image, const ttc_model *table, size_t i,
                       bool *is_root)
{
    const char *name = table->symbols[table->params[i]].name;
    const size_t given = ttc_image_name(image, name), level = position_of(image->levels, image->level_count, name);
    const uint32_t own = ttc_param_of(model, name);
    *is_root = given < image->count && image->forms[given] == TTC_GIVEN_ROOT;
    if (given < image->count) return claim->entries[2 * given];
    if (level < image->level_count) return model->claims[claim->members[level]].expression;
    return own == UINT32_MAX ? TTC_NONE : model->symbols[own].node;
}

bool ttc_angle_cosine(const ttc_model *table, uint32_t state, uint32_t *cosine)
{
    for (uint32_t i = 0; i < table->symbol_count; i++)
        if (table->symbols[i].kind == TTC_COSINE && table->symbols[i].definition == table->symbols[state].node) {
            *cosine = i;
            return true;
        }
    return false;
}

bool ttc_refuse(char *reason, size_t size, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(reason, size, format, arguments);
    va_end(arguments);
    return false;
}

bool ttc_image_has_states(const ttc_image *image, const ttc_model *table, const char *file, char *reason, size_t size)
{
    for (size_t i = 0; i < table->state_count; i++) {
        const ttc_symbol_entry *entry = table->symbols + table->states[i];
        const size_t k = ttc_image_state(image, table, i);
        uint32_t cosine;
        if (k == image->count && position_of(image->levels, image->level_count, entry->name) < image->level_count)
            return ttc_refuse(reason, size, "the state %s of %s is given by an integral's bare name, as parameters are (expected "
                              "the name in parentheses)", entry->name, file);
        if (k == image->count) return ttc_refuse(reason, size, "the state %s of %s is given no way back", entry->name, file);
        if (image->forms[k] == TTC_GIVEN_ROOT)
            return ttc_refuse(reason, size, "the state %s of %s is given by sqrt, as roots and parameters are "
                              "(expected a root's name)", entry->name, file);
        if (image->forms[k] == TTC_GIVEN_ANGLE && !ttc_angle_cosine(table, table->states[i], &cosine))
            return ttc_refuse(reason, size, "%s is an angle, and %s has no record 'angle' for it", entry->name, file);
        if (image->forms[k] == TTC_GIVEN_ANGLE && (entry->low != TTC_NONE || entry->high != TTC_NONE))
            return ttc_refuse(reason, size, "%s is given by atan2, an angle of any size: its record 'state %s' in %s must have no "
                              "interval", entry->name, entry->name, file);
    }
    return true;
}
