/* Writes what a field says of tables that serve in place of its own: its tier, the ways to them and back, all on raw parameters,
 * and its states completed by lifted roots. Functions of another table's states are in that table's graph. */
#include "emit/emit.h"

#include "prove/way_table.h"

#include <stdlib.h>
#include <string.h>

static void add_string(ttc_text *text, const char *value)
{
    ttc_text_add(text, "\"");
    ttc_text_add_escaped(text, value);
    ttc_text_add(text, "\"");
}

/* ---- the field's own ---- */

bool ttc_emit_lifted(ttc_text *text, const ttc_field *field)
{
    if (ttc_field_lifted_count(field) == 0) return true;
    ttc_field *plain = NULL;
    ttc_id *ids = calloc(field->state_count + 1, sizeof *ids);
    bool ok = ids != NULL && ttc_field_create(&plain, field->model, field->variant, NULL, field->elimination) == TTC_FIELD_OK;
    for (size_t i = 0; ok && i < field->state_count; i++)
        ids[i] = ttc_field_specialise(plain, field->model->symbols[field->states[i]].node);
    ok = ok && ttc_emit_outputs(text, "lifted", plain, ids, field->state_count);
    ttc_field_destroy(plain);
    free(ids);
    return ok;
}

static void add_inequalities(ttc_text *text, const ttc_inequalities *list)
{
    for (size_t i = 0; i < list->count; i++) {
        ttc_text_add(text, "    { ");
        add_string(text, list->items[i].text);
        ttc_text_add(text, ", 0 },\n");
    }
}

bool ttc_emit_tier(ttc_text *text, ttc_field *field)
{
    const ttc_inequalities *conditions = &field->model->tier.conditions;
    if (!ttc_field_is_general(field) || conditions->count == 0) return true;
    ttc_id *ids = calloc(conditions->count, sizeof *ids);
    for (size_t i = 0; ids != NULL && i < conditions->count; i++)
        ids[i] = ttc_field_specialise(field, conditions->items[i].expression);
    const bool ok = ids != NULL && ttc_emit_outputs(text, "tier_values", field, ids, conditions->count);
    free(ids);
    ttc_text_add(text, "static const jlt_way_condition tier_conditions[] = {\n");
    add_inequalities(text, conditions);
    ttc_text_add(text, "};\n\n");
    return ok;
}

void ttc_emit_way_members(ttc_text *text, const ttc_field *field, size_t ways)
{
    const ttc_tier *tier = &field->model->tier;
    if (ttc_field_lifted_count(field) > 0) ttc_text_add(text, "    .lifted = lifted,\n");
    if (ttc_field_is_general(field) && tier->name != NULL) {
        ttc_text_format(text, "    .tier = \"%s\", .tier_meaning = ", tier->name);
        add_string(text, tier->meaning);
        ttc_text_add(text, ",\n");
        if (tier->conditions.count > 0)
            ttc_text_format(text, "    .tier_condition_count = %zu, .tier_conditions = tier_conditions,\n"
                                  "    .tier_values = tier_values,\n", tier->conditions.count);
    }
    if (ways > 0) ttc_text_format(text, "    .way_count = %zu, .ways = ways,\n", ways);
}

/* ---- ways ---- */

typedef struct {
    ttc_text *text;
    const ttc_kernels *kernels;
    const ttc_way *way;
    const ttc_claim *claim;
    size_t number;           /* index among the ways that are written */
    ttc_model *table;        /* the other table */
    const ttc_claim *back;   /* the other table's claim that leads back */
    ttc_field *field;        /* its field, in the time of the same name */
    ttc_id *ids;             /* room for the outputs of any kernel */
    unsigned char *is_root;  /* by parameter of the other table */
    unsigned char *sources;
} way_emitter;

static bool emit_kernel(way_emitter *e, const char *name, ttc_field *field, size_t count)
{
    return ttc_emit_numbered(e->text, "way", e->number, name, field, e->ids, count);
}

static bool emit_coordinates(way_emitter *e)
{
    const size_t n = e->table->state_count;
    for (size_t i = 0; i < 2 * n; i++) {
        const size_t k = ttc_image_state(&e->way->image, e->table, i / 2);
        e->ids[i] = ttc_field_specialise(e->kernels->field, e->claim->entries[2 * k + i % 2]);
    }
    return emit_kernel(e, "coordinates", e->kernels->field, 2 * n);
}

static bool emit_params(way_emitter *e)
{
    const size_t count = e->table->param_count;
    for (size_t i = 0; i < count; i++) {
        bool is_root;
        const ttc_id value = ttc_image_param(e->kernels->field->model, e->claim, &e->way->image, e->table, i, &is_root);
        const char *name = e->table->symbols[e->table->params[i]].name;
        const int source = ttc_emit_source(e->kernels->field->model, name, value, is_root);
        if (source < 0) return false;
        e->sources[i] = (unsigned char)source;
        e->is_root[i] = is_root;
        e->ids[i] = ttc_field_specialise(e->kernels->field, value);
    }
    return emit_kernel(e, "params", e->kernels->field, count);
}

static size_t condition_count(const way_emitter *e) { return e->claim->when.count + e->way->where.count; }

static bool emit_conditions(way_emitter *e)
{
    ttc_field *field = e->kernels->field;
    const ttc_bindings *when = &e->claim->when;
    const size_t count = condition_count(e);
    if (count == 0) return true;
    ttc_text_format(e->text, "static const jlt_way_condition way%zu_conditions[] = {\n", e->number);
    for (size_t i = 0; i < when->count; i++) {
        const ttc_bindings one = { when->items + i, 1 };
        const ttc_id symbol = field->model->symbols[when->items[i].symbol].node;
        e->ids[i] = ttc_field_specialise(field, ttc_subtract(field->graph, symbol, when->items[i].expression));
        ttc_text_add(e->text, "    { \"");
        ttc_emit_condition(e->text, field, &one);
        ttc_text_add(e->text, "\", 1 },\n");
    }
    for (size_t i = 0; i < e->way->where.count; i++)
        e->ids[when->count + i] = ttc_field_specialise(field, e->way->where.items[i].expression);
    add_inequalities(e->text, &e->way->where);
    ttc_text_add(e->text, "};\n\n");
    return emit_kernel(e, "condition_values", field, count);
}

static bool emit_back(way_emitter *e)
{
    const ttc_field *own = e->kernels->field;
    for (size_t i = 0; i < own->state_count; i++) {
        const ttc_id given = ttc_given_for(e->back, own->model->symbols[own->states[i]].name);
        e->ids[i] = ttc_field_specialise(e->field, given);
    }
    return emit_kernel(e, "back", e->field, own->state_count);
}

static void add_flags(way_emitter *e, const char *name, size_t count, const unsigned char *flags)
{
    if (count == 0) return;
    ttc_text_format(e->text, "static const unsigned char way%zu_%s[] = {", e->number, name);
    for (size_t i = 0; i < count; i++) ttc_text_format(e->text, "%s %d", i == 0 ? "" : ",", flags[i]);
    ttc_text_add(e->text, " };\n\n");
}

static bool add_forms(way_emitter *e)
{
    const size_t n = e->table->state_count;
    unsigned char *is_angle = calloc(n + 1, 1);
    for (size_t i = 0; is_angle != NULL && i < n; i++)
        is_angle[i] = e->way->image.forms[ttc_image_state(&e->way->image, e->table, i)] == TTC_GIVEN_ANGLE;
    if (is_angle != NULL) add_flags(e, "is_angle", n, is_angle);
    add_flags(e, "is_root", e->table->param_count, e->is_root);
    add_flags(e, "sources", e->table->param_count, e->sources);
    free(is_angle);
    return is_angle != NULL;
}

static void add_entry(ttc_text *table, const way_emitter *e)
{
    const size_t k = e->number, params = e->table->param_count, conditions = condition_count(e);
    ttc_text_format(table, "    { .name = \"%s\", .kind = \"%s\", .model = \"%s\", .file = ", e->claim->name,
                    ttc_claim_kind_name(e->claim->kind), e->table->name);
    add_string(table, e->claim->target);
    ttc_text_format(table, ",\n      .sha256 = \"%s\",\n      .time = \"%s\", .claim = %u,\n", e->table->sha256,
                    e->field->time == NULL ? "" : e->field->time->name, (unsigned)e->way->claim);
    ttc_text_format(table, "      .state_count = %zu, .param_count = %zu, .coordinate_count = %zu,\n", e->field->state_count,
                    params, e->table->state_count);
    ttc_text_format(table, "      .is_angle = way%zu_is_angle,\n      .coordinates = way%zu_coordinates,\n"
                           "      .back = way%zu_back,\n", k, k, k);
    if (params > 0) ttc_text_format(table, "      .is_root = way%zu_is_root, .sources = way%zu_sources,\n", k, k);
    ttc_text_format(table, "      .params = way%zu_params,\n", k);
    if (conditions > 0)
        ttc_text_format(table, "      .condition_count = %zu, .conditions = way%zu_conditions,\n"
                               "      .condition_values = way%zu_condition_values,\n", conditions, k, k);
    ttc_text_add(table, "    },\n");
}

static const ttc_time *time_of(const ttc_model *table, const ttc_field *field)
{
    for (size_t i = 0; field->time != NULL && i < table->time_count; i++)
        if (strcmp(table->times[i].name, field->time->name) == 0) return table->times + i;
    return NULL;
}

static bool emit_way(way_emitter *e)
{
    const ttc_field *own = e->kernels->field;
    e->ids = calloc(own->state_count + 2 * e->table->state_count + e->table->param_count + condition_count(e) + 1,
                    sizeof *e->ids);
    e->is_root = calloc(e->table->param_count + 1, 1);
    e->sources = calloc(e->table->param_count + 1, 1);
    if (e->ids == NULL || e->is_root == NULL || e->sources == NULL ||
        ttc_field_create(&e->field, e->table, NULL, time_of(e->table, own), NULL) != TTC_FIELD_OK)
        return false;
    ttc_text_format(e->text, "/* The %s %s, to the table %s, SHA-256\n * %s. */\n", ttc_claim_kind_name(e->claim->kind),
                    e->claim->name, e->table->name, e->table->sha256);
    return emit_coordinates(e) && emit_params(e) && emit_conditions(e) && emit_back(e) && add_forms(e);
}

bool ttc_emit_ways(ttc_text *text, ttc_kernels *kernels, size_t *count)
{
    const ttc_model *model = kernels->field->model;
    ttc_text table = { 0 };
    bool ok = true;
    *count = 0;
    for (size_t i = 0; ok && i < model->way_count && ttc_field_is_general(kernels->field); i++) {
        char reason[240];
        uint32_t back;
        way_emitter e = { .text = text, .kernels = kernels, .way = model->ways + i, .number = *count };
        e.claim = model->claims + e.way->claim;
        e.table = ttc_way_table(model, e.way, ttc_resolve_beside, NULL, &back, reason, sizeof reason);
        if (e.table == NULL) continue;
        e.back = e.table->claims + back;
        ok = emit_way(&e);
        if (ok) add_entry(&table, &e);
        else kernels->failed_claim = e.claim;
        ++*count;
        ttc_field_destroy(e.field);
        ttc_model_destroy(e.table);
        free(e.ids);
        free(e.is_root);
        free(e.sources);
    }
    if (*count > 0) ttc_text_format(text, "static const jlt_way ways[] = {\n%s};\n\n", ttc_text_string(&table));
    text->failed |= table.failed;
    ttc_text_clear(&table);
    return ok;
}
