#include "prove/way_table.h"

#include "base/text.h"

#include <string.h>

ttc_id ttc_given_for(const ttc_claim *claim, const char *name)
{
    for (size_t i = 0; i < claim->bindings.count; i++)
        if (strcmp(claim->target_names[i], name) == 0) return claim->bindings.items[i].expression;
    return TTC_NONE;
}

const ttc_way *ttc_way_of(const ttc_model *model, const ttc_claim *claim)
{
    size_t i = 0;
    while (model->claims + model->ways[i].claim != claim) i++;
    return model->ways + i;
}

typedef struct {
    const ttc_model *model, *table;
    const ttc_way *way;
    const char *file;
    char *reason;
    size_t size;
} fitting;

static bool descends(const fitting *f) { return f->model->claims[f->way->claim].kind == TTC_CLAIM_DESCENT; }

static bool gives_states(const ttc_model *model, const ttc_claim *back)
{
    for (size_t i = 0; i < model->state_count; i++)
        if (ttc_given_for(back, model->symbols[model->states[i]].name) == TTC_NONE) return false;
    return true;
}

static bool find_back(const fitting *f, uint32_t *back)
{
    const ttc_claim_kind kind = descends(f) ? TTC_CLAIM_EMBEDDING : TTC_CLAIM_REDUCTION;
    const char *own = ttc_model_base_name(f->model);
    for (int by_name = 1; by_name >= 0; by_name--)
        for (uint32_t i = 0; i < f->table->claim_count; i++) {
            const ttc_claim *claim = f->table->claims + i;
            if (claim->kind != kind || (by_name && strcmp(claim->target, own) != 0) || !gives_states(f->model, claim)) continue;
            *back = i;
            return true;
        }
    return ttc_refuse(f->reason, f->size, "%s has no %s that gives all states of %s", f->file,
                      descends(f) ? "embedding" : "reduction onto a table", f->model->name);
}

static bool names_fit(const fitting *f)
{
    const ttc_image *image = &f->way->image;
    if (!ttc_image_has_states(image, f->table, f->file, f->reason, f->size)) return false;
    for (size_t k = 0; k < image->count; k++) {
        uint32_t symbol;
        const bool known = ttc_model_find_symbol(f->table, image->names[k], &symbol);
        const ttc_symbol_kind kind = known ? f->table->symbols[symbol].kind : TTC_LET;
        if (kind != TTC_STATE && kind != TTC_PARAM && (kind != TTC_ROOT || descends(f)))
            return ttc_refuse(f->reason, f->size, "%s is no state%s or parameter of %s", image->names[k],
                              descends(f) ? "" : ", root", f->file);
        if (kind == TTC_PARAM && image->forms[k] == TTC_GIVEN_ANGLE)
            return ttc_refuse(f->reason, f->size, "%s is a parameter of %s, and no angle", image->names[k], f->file);
    }
    for (size_t k = 0; k < image->level_count; k++)
        if (ttc_param_of(f->table, image->levels[k]) == UINT32_MAX)
            return ttc_refuse(f->reason, f->size, "%s is no parameter of %s", image->levels[k], f->file);
    for (size_t i = 0; i < f->table->param_count; i++) {
        bool is_root;
        if (ttc_image_param(f->model, f->model->claims + f->way->claim, image, f->table, i, &is_root) == TTC_NONE)
            return ttc_refuse(f->reason, f->size, "the parameter %s of %s is given no value",
                              f->table->symbols[f->table->params[i]].name, f->file);
    }
    return true;
}

static bool roots_fit(const fitting *f, const ttc_claim *back)
{
    const ttc_model *model = f->model;
    for (size_t i = 0; i < model->time_count; i++)
        for (size_t k = 0; k < model->times[i].lifted_count; k++) {
            const char *root = model->symbols[model->times[i].lifted[k]].name;
            if (ttc_given_for(back, root) == TTC_NONE)
                return ttc_refuse(f->reason, f->size, "the root %s, a state in the time %s, is not given by %s of %s", root,
                                  model->times[i].name, back->name, f->file);
        }
    return true;
}

char *ttc_way_untold(const ttc_model *model, const ttc_claim *way, const ttc_model *table, const ttc_claim *back)
{
    ttc_text names = { 0 };
    for (size_t i = 0; i < model->param_count; i++) {
        const char *name = model->symbols[model->params[i]].name;
        bool is_told = ttc_param_of(table, name) != UINT32_MAX || ttc_given_for(back, name) != TTC_NONE;
        for (size_t k = 0; k < way->when.count; k++) is_told |= way->when.items[k].symbol == model->params[i];
        if (!is_told) ttc_text_format(&names, "%s%s", names.length > 0 ? ", " : "", name);
    }
    if (names.length > 0) ttc_text_format(&names, " may have any value: the embedding %s of %s gives none", back->name,
                                          way->target);
    return names.bytes;
}

bool ttc_way_fits(const ttc_model *model, const ttc_way *way, const ttc_model *table, uint32_t *back, char *reason, size_t size)
{
    const fitting f = { model, table, way, model->claims[way->claim].target, reason, size };
    if (table->equation_count == 0)
        return ttc_refuse(f.reason, f.size, "%s is a table of coordinates, in which nothing moves", f.file);
    return find_back(&f, back) && names_fit(&f) && roots_fit(&f, table->claims + *back);
}

ttc_model *ttc_way_table(const ttc_model *model, const ttc_way *way, ttc_resolver resolver, void *context, uint32_t *back,
                         char *reason, size_t size)
{
    const char *file = model->claims[way->claim].target;
    ttc_model *table = ttc_resolve(resolver, context, model, "the table", file, reason, size);
    if (table == NULL) return NULL;
    if (ttc_way_fits(model, way, table, back, reason, size)) return table;
    ttc_model_destroy(table);
    return NULL;
}
