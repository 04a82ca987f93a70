#include "read/model.h"

#include <stdlib.h>
#include <string.h>

static void clear_names(char **names, size_t count)
{
    for (size_t i = 0; i < count; i++) free(names[i]);
    free(names);
}

void ttc_claim_clear(ttc_claim *claim)
{
    if (claim->target_names != NULL) clear_names(claim->target_names, claim->bindings.count);
    free(claim->target);
    free(claim->bindings.items);
    free(claim->when.items);
    free(claim->modulo);
    free(claim->entries);
    free(claim->members);
    free(claim->name);
}

static void clear_image(ttc_image *image)
{
    clear_names(image->names, image->count);
    clear_names(image->levels, image->level_count);
    free(image->forms);
}

static void clear_inequalities(ttc_inequalities *list)
{
    for (size_t i = 0; i < list->count; i++) free(list->items[i].text);
    free(list->items);
}

/* Free the records about tables that serve in place of each other: ways and the tier. */
static void clear_ways(ttc_model *model)
{
    for (size_t i = 0; i < model->way_count; i++) {
        clear_image(&model->ways[i].image);
        clear_inequalities(&model->ways[i].where);
    }
    clear_inequalities(&model->tier.conditions);
    free(model->tier.name);
    free(model->tier.meaning);
    free(model->ways);
}

/* Free the records about sections, both those of a model's table and those of a table of coordinates. */
static void clear_sections(ttc_model *model)
{
    for (size_t i = 0; i < model->pole_count; i++) free(model->poles[i].meaning);
    for (size_t i = 0; i < model->section_count; i++) {
        ttc_section *section = model->sections + i;
        clear_image(&section->image);
        free(section->beside);
        free(section->ending);
    }
    for (size_t i = 0; i < model->start_count; i++) {
        free(model->starts[i].name);
        free(model->starts[i].point);
    }
    clear_names(model->lift.names, model->lift.bindings.count);
    free(model->lift.bindings.items);
    free(model->lift.file);
    free(model->starts);
    free(model->turn_meaning);
    free(model->poles);
    free(model->sections);
}

void ttc_model_destroy(ttc_model *model)
{
    if (model == NULL) return;
    for (size_t i = 0; i < model->symbol_count; i++) {
        free(model->symbols[i].name);
        free(model->symbols[i].unit);
        free(model->symbols[i].meaning);
    }
    for (size_t i = 0; i < model->equation_count; i++) free(model->equations[i].terms);
    for (size_t i = 0; i < model->variant_count; i++) {
        free(model->variants[i].name);
        free(model->variants[i].bindings.items);
    }
    for (size_t i = 0; i < model->time_count; i++) {
        free(model->times[i].name);
        free(model->times[i].lifted);
    }
    for (size_t i = 0; i < model->elimination_count; i++) free(model->eliminations[i].name);
    for (size_t i = 0; i < model->claim_count; i++) ttc_claim_clear(model->claims + i);
    clear_sections(model);
    clear_ways(model);
    free(model->symbols);
    free(model->params);
    free(model->states);
    free(model->equations);
    free(model->variants);
    free(model->times);
    free(model->eliminations);
    for (size_t i = 0; i < model->region_count; i++) {
        free(model->regions[i].name);
        free(model->regions[i].text);
    }
    for (size_t i = 0; i < model->validity_count; i++) {
        free(model->validities[i].name);
        free(model->validities[i].unit);
        free(model->validities[i].meaning);
    }
    free(model->validities);
    free(model->observed);
    free(model->claims);
    free(model->regions);
    free(model->divisors);
    free(model->uses);
    free(model->file);
    free(model->name);
    free(model->title);
    free(model->source);
    free(model->text);
    ttc_graph_destroy(model->graph);
    free(model);
}

bool ttc_model_find_symbol(const ttc_model *model, const char *name, uint32_t *symbol)
{
    for (size_t i = model->symbol_count; i-- > 0;) /* from the end, so that a table's own name lambda is found before symbol 0 */
        if (strcmp(model->symbols[i].name, name) == 0) {
            *symbol = (uint32_t)i;
            return true;
        }
    return false;
}

const char *ttc_symbol_function(ttc_symbol_kind kind)
{
    switch (kind) {
    case TTC_ROOT: return "sqrt";
    case TTC_COSINE: return "cos";
    case TTC_SINE: return "sin";
    case TTC_EXP: return "exp";
    case TTC_LOG: return "log";
    default: return "";
    }
}

bool ttc_symbol_is_function(ttc_symbol_kind kind) { return *ttc_symbol_function(kind) != '\0'; }

bool ttc_symbol_rational(fmpq_t value, ttc_symbol_kind kind, const fmpq_t argument)
{
    if (kind != TTC_ROOT) {
        const bool is_rational = kind == TTC_LOG ? fmpq_is_one(argument) : fmpq_is_zero(argument);
        fmpq_set_si(value, kind == TTC_EXP || kind == TTC_COSINE, 1);
        return is_rational;
    }
    if (!fmpz_is_square(fmpq_numref(argument)) || !fmpz_is_square(fmpq_denref(argument))) return false;
    fmpz_sqrt(fmpq_numref(value), fmpq_numref(argument));
    fmpz_sqrt(fmpq_denref(value), fmpq_denref(argument));
    return true;
}

bool ttc_claim_speaks_of_family(ttc_claim_kind kind)
{
    return kind == TTC_CLAIM_TRACE || kind == TTC_CLAIM_CHARPOLY || kind == TTC_CLAIM_OBSTRUCTS || kind == TTC_CLAIM_MATRIX ||
           kind == TTC_CLAIM_LEFT_NULL;
}

bool ttc_claim_is_unnamed(const ttc_claim *claim)
{
    return (claim->kind == TTC_CLAIM_REVERSOR || claim->kind == TTC_CLAIM_SYMMETRY) &&
           strcmp(claim->name, ttc_claim_kind_name(claim->kind)) == 0;
}

uint32_t ttc_model_lambda(const ttc_model *model)
{
    uint32_t symbol = 0;
    while (model->symbols[symbol].kind != TTC_LAMBDA) symbol++;
    return symbol;
}

const char *ttc_model_base_name(const ttc_model *model)
{
    const char *slash = strrchr(model->file, '/');
    return slash == NULL ? model->file : slash + 1;
}

/* A claim to which the table gives this name takes precedence over unnamed ones, whose name is their keyword. */
bool ttc_model_find_claim(const ttc_model *model, const char *name, uint32_t *claim)
{
    bool found = false;

    for (size_t i = model->claim_count; i-- > 0;) {
        const ttc_claim *c = &model->claims[i];
        if (ttc_claim_speaks_of_family(c->kind) || strcmp(c->name, name) != 0) continue;
        if (found && ttc_claim_is_unnamed(c)) continue;
        *claim = (uint32_t)i;
        found = true;
    }
    return found;
}

ttc_id ttc_model_inside(const ttc_model *model, uint32_t state, bool is_high)
{
    const ttc_symbol_entry *s = model->symbols + state;
    if ((is_high ? s->high : s->low) == TTC_NONE) return TTC_NONE;
    return is_high ? ttc_subtract(model->graph, s->high, s->node) : ttc_subtract(model->graph, s->node, s->low);
}

ttc_id ttc_model_field(const ttc_model *model, size_t k) { return model->equations[k].sum; }

static const char *const kind_names[] = {
    [TTC_CLAIM_INTEGRAL] = "integral", [TTC_CLAIM_INVARIANT] = "invariant", [TTC_CLAIM_MEASURE] = "measure",
    [TTC_CLAIM_REVERSOR] = "reversor", [TTC_CLAIM_EQUILIBRIA] = "equilibria", [TTC_CLAIM_TRACE] = "trace",
    [TTC_CLAIM_CHARPOLY] = "charpoly", [TTC_CLAIM_OBSTRUCTS] = "obstructs", [TTC_CLAIM_MATRIX] = "matrix",
    [TTC_CLAIM_LEFT_NULL] = "leftnull", [TTC_CLAIM_EQUAL] = "equal", [TTC_CLAIM_RATE] = "rate",
    [TTC_CLAIM_POSITIVE] = "positive", [TTC_CLAIM_REDUCTION] = "reduction", [TTC_CLAIM_EMBEDDING] = "embedding",
    [TTC_CLAIM_SYMMETRY] = "symmetry", [TTC_CLAIM_PERIODIC] = "periodic", [TTC_CLAIM_SECTION] = "section",
    [TTC_CLAIM_DESCENT] = "reduction", [TTC_CLAIM_LIFT] = "lift",
};

const char *ttc_claim_kind_name(ttc_claim_kind kind) { return kind_names[kind]; }
