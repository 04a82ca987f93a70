/* Writes families of equilibria: kernels on raw parameters, and their table. */
#include "emit/emit.h"
#include "fields/coefficients.h"

#include <stdlib.h>

typedef struct {
    ttc_text *text;
    ttc_kernels *kernels;
    const ttc_claim *family;
    uint32_t claim;
    size_t number;
    const ttc_claim *trace, *charpoly, *matrix, *left_null;
    bool obstructs;
} family_emitter;

static const ttc_binding *binding_of(const ttc_bindings *bindings, uint32_t symbol)
{
    for (size_t i = 0; i < bindings->count; i++)
        if (bindings->items[i].symbol == symbol) return bindings->items + i;
    return NULL;
}

/* A kernel of the family, with its states, and with_condition its parameters, replaced by what they are bound to. */
static bool emit_program(family_emitter *e, const char *name, const ttc_id *ids, size_t count, bool with_condition)
{
    ttc_text function = { 0 };
    ttc_lowering options = { .share = true, .factor_roots = true, .bindings = &e->family->bindings,
                             .when = with_condition ? &e->family->when : NULL };
    ttc_program *program = ttc_lower(e->kernels->field, ids, count, options);
    bool ok = program != NULL;
    if (ok) {
        ttc_text_format(&function, "family%zu_%s", e->number, name);
        ttc_emit_function(e->text, ttc_text_string(&function), program, e->kernels->field, NULL);
        ttc_text_add(e->text, "\n");
    }
    ttc_text_clear(&function);
    ttc_program_destroy(program);
    return ok;
}

static bool emit_nodes(family_emitter *e, const char *name, const uint32_t *symbols, size_t count, bool with_condition)
{
    ttc_id *ids = calloc(count + 1, sizeof *ids);
    bool ok = ids != NULL;
    for (size_t i = 0; ok && i < count; i++) ids[i] = e->kernels->field->model->symbols[symbols[i]].node;
    ok = ok && emit_program(e, name, ids, count, with_condition);
    free(ids);
    return ok;
}

static bool emit_specialised(family_emitter *e, const char *name, const ttc_id *expressions, size_t count)
{
    ttc_id *ids = calloc(count + 1, sizeof *ids);
    bool ok = ids != NULL;
    for (size_t i = 0; ok && i < count; i++) {
        ids[i] = ttc_field_specialise(e->kernels->field, expressions[i]);
        ok = ids[i] != TTC_NONE;
    }
    ok = ok && emit_program(e, name, ids, count, false);
    free(ids);
    return ok;
}

static bool emit_charpoly(family_emitter *e)
{
    ttc_field *field = e->kernels->field;
    size_t n = field->state_count;
    uint32_t lambda = ttc_model_lambda(field->model);
    ttc_id *coefficients = calloc(n + 1, sizeof *coefficients);
    bool ok = coefficients != NULL;
    ttc_id id = ok ? ttc_field_specialise(field, e->charpoly->expression) : TTC_NONE;
    ok = ok && id != TTC_NONE && ttc_polynomial_coefficients(field->graph, coefficients, n, id, lambda)
         && emit_program(e, "charpoly", coefficients, n + 1, false);
    free(coefficients);
    return ok;
}

static bool emit_left_null(family_emitter *e)
{
    ttc_field *field = e->kernels->field;
    size_t n = field->state_count, count = e->left_null->member_count;
    ttc_id *ids = calloc(n * count + 1, sizeof *ids);
    bool ok = ids != NULL;
    for (size_t i = 0; ok && i < count; i++) {
        ttc_id value = ttc_field_specialise(field, field->model->claims[e->left_null->members[i]].expression);
        for (size_t j = 0; ok && j < n; j++) {
            ids[i * n + j] = ttc_field_partial(field, value, j);
            ok = ids[i * n + j] != TTC_NONE;
        }
    }
    ok = ok && emit_program(e, "left_null_gradients", ids, n * count, false);
    free(ids);
    if (!ok) return false;
    ttc_text_format(e->text, "static const jlt_named family%zu_left_null[] = {\n", e->number);
    for (size_t i = 0; i < count; i++) {
        const ttc_claim *member = field->model->claims + e->left_null->members[i];
        ttc_text_format(e->text, "    { \"%s\", \"", member->name);
        ttc_emit_condition(e->text, field, &member->when);
        ttc_text_add(e->text, "\" },\n");
    }
    ttc_text_add(e->text, "};\n\n");
    return true;
}

static void find_members(family_emitter *e)
{
    const ttc_model *model = e->kernels->field->model;
    for (size_t i = 0; i < model->claim_count; i++) {
        const ttc_claim *claim = model->claims + i;
        bool is_member = claim->kind >= TTC_CLAIM_TRACE && claim->kind <= TTC_CLAIM_LEFT_NULL && claim->family == e->claim;
        if (!is_member) continue;
        if (claim->kind == TTC_CLAIM_TRACE) e->trace = claim;
        else if (claim->kind == TTC_CLAIM_CHARPOLY) e->charpoly = claim;
        else if (claim->kind == TTC_CLAIM_MATRIX) e->matrix = claim;
        else if (claim->kind == TTC_CLAIM_LEFT_NULL) e->left_null = claim;
        else e->obstructs = true;
    }
}

/* Record the claim whose kernels cannot be written. */
static bool is_done(family_emitter *e, const ttc_claim *claim, bool ok)
{
    if (!ok) e->kernels->failed_claim = claim;
    return ok;
}

static bool emit_family(family_emitter *e)
{
    ttc_field *field = e->kernels->field;
    ttc_text_format(e->text, "static const unsigned char family%zu_is_free[] = { ", e->number);
    for (size_t i = 0; i < field->state_count; i++)
        ttc_text_format(e->text, "%s%d", i == 0 ? "" : ", ", binding_of(&e->family->bindings, field->states[i]) == NULL);
    ttc_text_add(e->text, " };\n\n");
    bool ok = is_done(e, e->family, emit_nodes(e, "impose", field->params, field->param_count, true)
                                        && emit_nodes(e, "point", field->states, field->state_count, false));
    if (e->trace != NULL) ok = ok && is_done(e, e->trace, emit_specialised(e, "trace", &e->trace->expression, 1));
    if (e->charpoly != NULL) ok = ok && is_done(e, e->charpoly, emit_charpoly(e));
    if (e->matrix != NULL)
        ok = ok && is_done(e, e->matrix, emit_specialised(e, "matrix", e->matrix->entries, e->matrix->entry_count));
    if (e->left_null != NULL) ok = ok && is_done(e, e->left_null, emit_left_null(e));
    return ok;
}

static void add_member(ttc_text *table, const char *member, size_t number, bool present)
{
    if (present) ttc_text_format(table, "      .%s = family%zu_%s,\n", member, number, member);
}

static void add_entry(ttc_text *table, const family_emitter *e)
{
    ttc_text_format(table, "    { .name = \"%s\", .condition = \"", e->family->name);
    ttc_emit_condition(table, e->kernels->field, &e->family->when);
    ttc_text_add(table, "\",\n");
    add_member(table, "is_free", e->number, true);
    add_member(table, "impose", e->number, true);
    add_member(table, "point", e->number, true);
    add_member(table, "trace", e->number, e->trace != NULL);
    add_member(table, "charpoly", e->number, e->charpoly != NULL);
    add_member(table, "matrix", e->number, e->matrix != NULL);
    add_member(table, "left_null", e->number, e->left_null != NULL);
    add_member(table, "left_null_gradients", e->number, e->left_null != NULL);
    ttc_text_format(table, "      .left_null_count = %zu, .obstructs = %d },\n",
                    e->left_null == NULL ? (size_t)0 : e->left_null->member_count, e->obstructs);
}

bool ttc_emit_equilibria(ttc_text *text, ttc_kernels *kernels)
{
    ttc_text table = { 0 };
    bool ok = true;
    if (kernels->family_count == 0) return true;
    ttc_text_add(&table, "static const jlt_equilibria equilibria[] = {\n");
    for (size_t k = 0; ok && k < kernels->family_count; k++) {
        family_emitter e = { .text = text, .kernels = kernels, .claim = kernels->families[k], .number = k };
        e.family = kernels->field->model->claims + e.claim;
        find_members(&e);
        ok = emit_family(&e);
        add_entry(&table, &e);
    }
    ttc_text_add(&table, "};\n\n");
    ttc_text_add(text, ttc_text_string(&table));
    ok = ok && !table.failed;
    ttc_text_clear(&table);
    return ok;
}
