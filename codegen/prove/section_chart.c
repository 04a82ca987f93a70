#include "prove/section_chart.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static size_t position_of(char *const *names, size_t count, const char *name)
{
    size_t i = 0;
    while (i < count && strcmp(names[i], name) != 0) i++;
    return i;
}

size_t ttc_section_coordinate(const ttc_section *section, const ttc_model *chart, size_t i)
{
    return position_of(section->coordinates, section->coordinate_count, chart->symbols[chart->states[i]].name);
}

uint32_t ttc_section_place(const ttc_model *model, const ttc_section *section, const ttc_model *chart, size_t i)
{
    const char *name = chart->symbols[chart->params[i]].name;
    const size_t level = position_of(section->levels, section->level_count, name);
    size_t k = 0;
    if (level < section->level_count) return (uint32_t)(model->param_count + level);
    while (k < model->param_count && strcmp(model->symbols[model->params[k]].name, name) != 0) k++;
    return (uint32_t)k;
}

bool ttc_chart_cosine(const ttc_model *chart, uint32_t state, uint32_t *cosine)
{
    for (uint32_t i = 0; i < chart->symbol_count; i++)
        if (chart->symbols[i].kind == TTC_COSINE && chart->symbols[i].definition == chart->symbols[state].node) {
            *cosine = i;
            return true;
        }
    return false;
}

ttc_id ttc_chart_lift(const ttc_model *chart, const char *name)
{
    const size_t i = position_of(chart->lift.names, chart->lift.bindings.count, name);
    return i < chart->lift.bindings.count ? chart->lift.bindings.items[i].expression : TTC_NONE;
}

typedef struct {
    const ttc_model *model, *chart;
    const ttc_section *section;
    const char *file;
    char *reason;
    size_t size;
} fitting;

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
static bool refuse(const fitting *f, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(f->reason, f->size, format, arguments);
    va_end(arguments);
    return false;
}

static bool coordinates_fit(const fitting *f)
{
    const ttc_section *section = f->section;
    const ttc_model *chart = f->chart;
    uint32_t symbol;
    for (size_t i = 0; i < chart->state_count; i++) {
        const char *name = chart->symbols[chart->states[i]].name;
        const size_t k = ttc_section_coordinate(section, chart, i);
        if (k == section->coordinate_count) return refuse(f, "the state %s of %s is given no way back", name, f->file);
        if (section->is_angle[k] && !ttc_chart_cosine(chart, chart->states[i], &symbol))
            return refuse(f, "%s is an angle, and %s has no record 'angle' for it", name, f->file);
        const ttc_symbol_entry *entry = chart->symbols + chart->states[i];
        if (section->is_angle[k] && (entry->low != TTC_NONE || entry->high != TTC_NONE))
            return refuse(f, "%s is an angle, which has no interval in %s", name, f->file);
    }
    for (size_t k = 0; k < section->coordinate_count; k++)
        if (!ttc_model_find_symbol(chart, section->coordinates[k], &symbol) || chart->symbols[symbol].kind != TTC_STATE)
            return refuse(f, "%s is no state of %s", section->coordinates[k], f->file);
    return true;
}

static bool params_fit(const fitting *f)
{
    const ttc_model *model = f->model, *chart = f->chart;
    uint32_t symbol;
    for (size_t k = 0; k < f->section->level_count; k++)
        if (!ttc_model_find_symbol(chart, f->section->levels[k], &symbol) || chart->symbols[symbol].kind != TTC_PARAM)
            return refuse(f, "%s is no parameter of %s", f->section->levels[k], f->file);
    for (size_t k = 0; k < f->section->level_count; k++)
        if (ttc_model_find_symbol(model, f->section->levels[k], &symbol) && model->symbols[symbol].kind == TTC_PARAM)
            return refuse(f, "%s, a level of %s, is a parameter of %s as well", f->section->levels[k], f->file, model->name);
    for (size_t i = 0; i < chart->param_count; i++) {
        const ttc_symbol_entry *entry = chart->symbols + chart->params[i];
        const uint32_t place = ttc_section_place(model, f->section, chart, i);
        const bool is_level = position_of(f->section->levels, f->section->level_count, entry->name) < f->section->level_count;
        if (place == model->param_count && !is_level)
            return refuse(f, "the parameter %s of %s is given no value", entry->name, f->file);
        if (place < model->param_count && model->symbols[model->params[place]].sign != entry->sign)
            return refuse(f, "the parameter %s has another condition in %s", entry->name, f->file);
    }
    return true;
}

static bool is_root_or_state(const ttc_model *model, const char *name)
{
    uint32_t symbol;
    return ttc_model_find_symbol(model, name, &symbol) &&
           (model->symbols[symbol].kind == TTC_STATE || model->symbols[symbol].kind == TTC_ROOT);
}

static bool lift_fits(const fitting *f)
{
    const ttc_model *model = f->model;
    const ttc_lift *lift = &f->chart->lift;
    if (lift->file == NULL) return refuse(f, "%s is no table of coordinates: it has no 'lift'", f->file);
    for (size_t i = 0; i < lift->bindings.count; i++)
        if (!is_root_or_state(model, lift->names[i]))
            return refuse(f, "%s, which %s lifts, is no state or root of %s", lift->names[i], f->file, model->name);
    for (size_t i = 0; i < model->state_count; i++)
        if (ttc_chart_lift(f->chart, model->symbols[model->states[i]].name) == TTC_NONE)
            return refuse(f, "the state %s is not lifted in %s", model->symbols[model->states[i]].name, f->file);
    for (size_t i = 0; i < model->time_count; i++)
        for (size_t k = 0; k < model->times[i].lifted_count; k++)
            if (ttc_chart_lift(f->chart, model->symbols[model->times[i].lifted[k]].name) == TTC_NONE)
                return refuse(f, "the root %s, a state in the time %s, is not lifted in %s",
                              model->symbols[model->times[i].lifted[k]].name, model->times[i].name, f->file);
    return true;
}

bool ttc_section_fits(const ttc_model *model, const ttc_section *section, const ttc_model *chart, char *reason, size_t size)
{
    const fitting f = { model, chart, section, model->claims[section->claim].target, reason, size };
    return lift_fits(&f) && coordinates_fit(&f) && params_fit(&f);
}

ttc_model *ttc_section_chart(const ttc_model *model, const ttc_section *section, ttc_resolver resolver, void *context, char *reason,
                             size_t size)
{
    const char *file = model->claims[section->claim].target;
    ttc_diagnostics *ignored = resolver == NULL ? NULL : ttc_diagnostics_create();
    ttc_model *chart = ignored == NULL ? NULL : resolver(context, model, file, ignored);
    ttc_diagnostics_destroy(ignored);
    if (chart == NULL) snprintf(reason, size, "the table of coordinates %s could not be read", file);
    else if (ttc_section_fits(model, section, chart, reason, size)) return chart;
    ttc_model_destroy(chart);
    return NULL;
}
