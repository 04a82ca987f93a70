/* Creation of a valuation: its ring, with a name for each variable, and the table of functions that compute values of symbols. */
#include "algebra/valuation_state.h"

#include <stdlib.h>
#include <string.h>

/* Names that no quantity of a table can have. */
static const char *const spare_names[TTC_SPARE_VARIABLES] = { "root[1]", "root[2]", "root[3]",  "root[4]",  "root[5]",  "root[6]",
                                                              "root[7]", "root[8]", "root[9]", "root[10]", "root[11]", "root[12]" };

static const ttc_function_value functions[TTC_PI + 1] = {
    [TTC_COSINE] = ttc_valuation_angle_value, [TTC_SINE] = ttc_valuation_angle_value, [TTC_EXP] = ttc_valuation_exp_value,
    [TTC_LOG] = ttc_valuation_log_value,      [TTC_PI] = ttc_valuation_pi_value,
};

static ttc_valuation *allocate(const ttc_model *model)
{
    ttc_valuation *v = calloc(1, sizeof *v);
    if (v == NULL) return NULL;
    v->model = model;
    v->functions = functions;
    v->symbol_count = model->symbol_count + TTC_SPARE_SYMBOLS;
    v->values = calloc(v->symbol_count, sizeof *v->values);
    v->known = calloc(v->symbol_count, sizeof *v->known);
    v->bound = calloc(v->symbol_count, sizeof *v->bound);
    v->square = calloc(v->symbol_count, sizeof *v->square);
    v->variable = calloc(v->symbol_count, sizeof *v->variable);
    v->freed = calloc(v->symbol_count + TTC_SPARE_VARIABLES, sizeof *v->freed);
    v->rooted = calloc(v->symbol_count, sizeof *v->rooted);
    v->withheld = calloc(v->symbol_count, sizeof *v->withheld);
    v->names = calloc(v->symbol_count + TTC_SPARE_VARIABLES, sizeof *v->names);
    v->positive = calloc(v->symbol_count + TTC_SPARE_VARIABLES, sizeof *v->positive);
    v->basis = calloc(v->symbol_count, sizeof *v->basis);
    v->exponentials = calloc(v->symbol_count, sizeof *v->exponentials);
    v->logarithms = calloc(v->symbol_count, sizeof *v->logarithms);
    if (v->values == NULL || v->known == NULL || v->bound == NULL || v->square == NULL || v->variable == NULL
        || v->freed == NULL || v->rooted == NULL || v->withheld == NULL || v->names == NULL || v->positive == NULL
        || v->basis == NULL || v->exponentials == NULL || v->logarithms == NULL) {
        v->symbol_count = 0;
        ttc_valuation_destroy(v);
        return NULL;
    }
    for (size_t i = 0; i < v->symbol_count; i++) v->variable[i] = -1;
    return v;
}

static bool is_positive(const ttc_model *model, const ttc_symbol_entry *entry)
{
    switch (entry->kind) {
    case TTC_ROOT:
    case TTC_EXP:
    case TTC_PI: return true;
    case TTC_PARAM: return entry->sign == TTC_POSITIVE || entry->sign == TTC_NONNEGATIVE;
    case TTC_STATE:
        return ttc_number_value(model->graph, entry->low) != NULL && fmpq_sgn(ttc_number_value(model->graph, entry->low)) >= 0;
    default: return false;
    }
}

/* Give each symbol but lets a variable, in the order of symbols. Adds their number to *used. */
static void name_variables(ttc_valuation *v, size_t *used)
{
    for (size_t i = 0; i < v->model->symbol_count; i++) {
        const ttc_symbol_entry *entry = &v->model->symbols[i];
        if (entry->kind == TTC_LET) continue;
        v->variable[i] = (slong)*used;
        v->names[*used] = entry->name;
        v->positive[*used] = is_positive(v->model, entry);
        ++*used;
    }
}

ttc_valuation *ttc_valuation_create(const ttc_model *model, unsigned choices)
{
    size_t used = 0;
    ttc_valuation *v = allocate(model);
    if (v == NULL) return NULL;
    name_variables(v, &used);
    size_t total = used + TTC_SPARE_VARIABLES;
    for (size_t i = 0; i < TTC_SPARE_VARIABLES; i++) v->names[used + i] = spare_names[i];
    for (size_t i = 0; i < TTC_SPARE_SYMBOLS; i++) v->variable[model->symbol_count + i] = (slong)(used + i);
    v->ring = ttc_ring_create(total, used + TTC_SPARE_SYMBOLS, v->names, v->positive);
    if (v->ring == NULL) {
        v->symbol_count = 0;
        ttc_valuation_destroy(v);
        return NULL;
    }
    v->ring->choices = choices;
    for (size_t i = 0; i < model->symbol_count; i++)
        if (model->symbols[i].kind == TTC_PI) v->ring->trust[v->variable[i]] = TTC_TRUST_SINGLE | TTC_TRUST_CONSTANT;
    for (size_t i = 0; i < v->symbol_count; i++) ttc_ratio_init(v->ring, &v->values[i]);
    return v;
}

ttc_valuation *ttc_valuation_alike(const ttc_valuation *v, unsigned choices)
{
    ttc_valuation *other = ttc_valuation_create(v->model, choices);
    if (other == NULL) return NULL;
    memcpy(other->bound, v->bound, v->symbol_count * sizeof *v->bound);
    memcpy(other->square, v->square, v->symbol_count * sizeof *v->square);
    memcpy(other->rooted, v->rooted, v->symbol_count * sizeof *v->rooted);
    memcpy(other->withheld, v->withheld, v->symbol_count * sizeof *v->withheld);
    return other;
}

ttc_valuation *ttc_valuation_map(const ttc_model *model, ttc_valuation *base)
{
    ttc_valuation *v = allocate(model);
    if (v == NULL) return NULL;
    v->base = base;
    v->ring = base->ring;
    for (size_t i = 0; i < v->symbol_count; i++) ttc_ratio_init(v->ring, &v->values[i]);
    return v;
}

void ttc_valuation_destroy(ttc_valuation *v)
{
    if (v == NULL) return;
    for (size_t i = 0; i < v->symbol_count; i++) ttc_ratio_clear(v->ring, &v->values[i]);
    for (size_t i = 0; i < v->memo_size; i++)
        if (v->seen[i]) ttc_ratio_clear(v->ring, &v->memo[i]);
    if (v->base == NULL) ttc_ring_destroy(v->ring);
    free(v->seen);
    free(v->memo);
    free(v->logarithms);
    free(v->exponentials);
    free(v->basis);
    free(v->positive);
    free(v->names);
    free(v->withheld);
    free(v->rooted);
    free(v->freed);
    free(v->variable);
    free(v->square);
    free(v->bound);
    free(v->known);
    free(v->values);
    free(v);
}

const char *ttc_valuation_name_of(const ttc_valuation *v, uint32_t symbol)
{
    const char *name = v->names[v->variable[symbol]];
    for (size_t i = 0; i < TTC_SPARE_VARIABLES; i++)
        if (name == spare_names[i]) return NULL;
    return name;
}
