#include "prove/section_chart.h"

#include <string.h>

const ttc_section *ttc_section_of(const ttc_model *model, const ttc_claim *claim)
{
    size_t i = 0;
    while (model->claims + model->sections[i].claim != claim) i++;
    return model->sections + i;
}

uint32_t ttc_section_place(const ttc_model *model, const ttc_section *section, const ttc_model *chart, size_t i)
{
    const char *name = chart->symbols[chart->params[i]].name;
    size_t level = 0, k = 0;
    while (level < section->image.level_count && strcmp(section->image.levels[level], name) != 0) level++;
    if (level < section->image.level_count) return (uint32_t)(model->param_count + level);
    while (k < model->param_count && strcmp(model->symbols[model->params[k]].name, name) != 0) k++;
    return (uint32_t)k;
}

ttc_id ttc_chart_lift(const ttc_model *chart, const char *name)
{
    for (size_t i = 0; i < chart->lift.bindings.count; i++)
        if (strcmp(chart->lift.names[i], name) == 0) return chart->lift.bindings.items[i].expression;
    return TTC_NONE;
}

typedef struct {
    const ttc_model *model, *chart;
    const ttc_section *section;
    const char *file;
    char *reason;
    size_t size;
} fitting;

static bool coordinates_fit(const fitting *f)
{
    const ttc_image *image = &f->section->image;
    uint32_t symbol;
    if (!ttc_image_has_states(image, f->chart, f->file, f->reason, f->size)) return false;
    for (size_t k = 0; k < image->count; k++) {
        const bool known = ttc_model_find_symbol(f->chart, image->names[k], &symbol);
        const ttc_symbol_kind kind = known ? f->chart->symbols[symbol].kind : TTC_LET;
        if (kind == TTC_PARAM)
            return ttc_refuse(f->reason, f->size, "%s is a parameter of %s: set it to an integral, or leave it out if it is that "
                              "of this table", image->names[k], f->file);
        if (kind != TTC_STATE) return ttc_refuse(f->reason, f->size, "%s is no state of %s", image->names[k], f->file);
    }
    return true;
}

static bool params_fit(const fitting *f)
{
    const ttc_model *model = f->model, *chart = f->chart;
    const ttc_image *image = &f->section->image;
    for (size_t k = 0; k < image->level_count; k++)
        if (ttc_param_of(chart, image->levels[k]) == UINT32_MAX)
            return ttc_refuse(f->reason, f->size, "%s is no parameter of %s", image->levels[k], f->file);
    for (size_t k = 0; k < image->level_count; k++)
        if (ttc_param_of(model, image->levels[k]) != UINT32_MAX)
            return ttc_refuse(f->reason, f->size, "%s, a level of %s, is a parameter of %s as well", image->levels[k], f->file,
                              model->name);
    for (size_t i = 0; i < chart->param_count; i++) {
        const ttc_symbol_entry *entry = chart->symbols + chart->params[i];
        const uint32_t place = ttc_section_place(model, f->section, chart, i);
        bool is_root;
        if (ttc_image_param(model, model->claims + f->section->claim, image, chart, i, &is_root) == TTC_NONE)
            return ttc_refuse(f->reason, f->size, "the parameter %s of %s is given no value", entry->name, f->file);
        if (place < model->param_count && model->symbols[model->params[place]].sign != entry->sign)
            return ttc_refuse(f->reason, f->size, "the parameter %s has another condition in %s", entry->name, f->file);
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
    if (lift->file == NULL) return ttc_refuse(f->reason, f->size, "%s is no table of coordinates: it has no 'lift'", f->file);
    for (size_t i = 0; i < lift->bindings.count; i++)
        if (!is_root_or_state(model, lift->names[i]))
            return ttc_refuse(f->reason, f->size, "%s, which %s lifts, is no state or root of %s", lift->names[i], f->file,
                              model->name);
    for (size_t i = 0; i < model->state_count; i++)
        if (ttc_chart_lift(f->chart, model->symbols[model->states[i]].name) == TTC_NONE)
            return ttc_refuse(f->reason, f->size, "the state %s is not lifted in %s", model->symbols[model->states[i]].name,
                              f->file);
    for (size_t i = 0; i < model->time_count; i++)
        for (size_t k = 0; k < model->times[i].lifted_count; k++)
            if (ttc_chart_lift(f->chart, model->symbols[model->times[i].lifted[k]].name) == TTC_NONE)
                return ttc_refuse(f->reason, f->size, "the root %s, a state in the time %s, is not lifted in %s",
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
    ttc_model *chart = ttc_resolve(resolver, context, model, "the table of coordinates", file, reason, size);
    if (chart == NULL) return NULL;
    if (ttc_section_fits(model, section, chart, reason, size)) return chart;
    ttc_model_destroy(chart);
    return NULL;
}
