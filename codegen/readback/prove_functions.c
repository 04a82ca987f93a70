#include "readback/prove_functions.h"

#include "algebra/derive.h"
#include "emit/emit.h"
#include "prove/section_chart.h"
#include "prove/way_table.h"
#include "readback/function_check.h"

#include <stdlib.h>
#include <string.h>

/* What the functions of one general field are checked with. */
typedef struct {
    const ttc_field *field;
    const ttc_model *model;
    const char *text;
    ttc_proof_report *report;
    ttc_function_reading own, free; /* on its states; in `free` lifted roots are coordinates */
    ttc_function_output *expected;  /* room for the outputs of any function */
    size_t capacity;
} checker;

/* The record in question; names of its functions begin with `what` and `number`. */
typedef struct {
    const ttc_claim *claim;
    const char *what;
    size_t number;
} record;

static bool has_room(checker *c, size_t count)
{
    if (count <= c->capacity) return true;
    ttc_function_output *grown = realloc(c->expected, count * sizeof *grown);
    if (grown == NULL) return false;
    c->expected = grown;
    c->capacity = count;
    return true;
}

static void expect(checker *c, size_t index, ttc_id value, uint32_t by)
{
    c->expected[index] = (ttc_function_output){ value, by };
}

static char *copy(const ttc_text *text)
{
    const char *string = ttc_text_string(text);
    char *out = text->failed ? NULL : malloc(strlen(string) + 1);
    if (out != NULL) strcpy(out, string);
    return out;
}

/* Check the record's function `name` against a polynomial in a symbol or, if that is TTC_NONE, the first `count` expected
 * outputs. */
static bool check_one(checker *c, const record *r, const char *name, ttc_function_reading *reading, size_t count, ttc_id polynomial,
                      uint32_t symbol)
{
    ttc_text function = { 0 }, title = { 0 };
    ttc_proof proof = { .kind = "kernel", .place = r->claim->place };
    ttc_text_format(&function, "%s%zu_%s", r->what, r->number, name);
    ttc_emit_stem(&title, c->field);
    ttc_text_format(&title, " %s.%s.%s", ttc_claim_kind_name(r->claim->kind), r->claim->name, name);
    ttc_proof *grown = realloc(c->report->proofs, (c->report->proof_count + 1) * sizeof *grown);
    if (grown != NULL) c->report->proofs = grown;
    proof.name = copy(&title);
    bool ok = grown != NULL && proof.name != NULL && !function.failed;
    if (ok && polynomial != TTC_NONE)
        ok = ttc_function_check_polynomial(&proof, c->text, ttc_text_string(&function), reading, polynomial, symbol, count);
    else if (ok) ok = ttc_function_check(&proof, c->text, ttc_text_string(&function), reading, c->expected, count);
    if (ok) {
        grown[c->report->proof_count++] = proof;
        c->report->proved += proof.status == TTC_PROVED;
        c->report->refuted += proof.status == TTC_REFUTED;
        c->report->unsettled += proof.status == TTC_UNSETTLED;
    } else {
        free(proof.name);
        free(proof.remainder);
    }
    ttc_text_clear(&function);
    ttc_text_clear(&title);
    return ok;
}

static bool check(checker *c, const record *r, const char *name, ttc_function_reading *reading, size_t count)
{
    return check_one(c, r, name, reading, count, TTC_NONE, 0);
}

/* ---- readings ---- */

/* States, then the roots that the time lifts. NULL when memory is out. */
static uint32_t *states_of(const ttc_model *model, const ttc_time *time, size_t *count)
{
    const size_t lifted = time == NULL ? 0 : time->lifted_count;
    uint32_t *out = calloc(model->state_count + lifted + 1, sizeof *out);
    *count = model->state_count + lifted;
    for (size_t i = 0; out != NULL && i < *count; i++)
        out[i] = i < model->state_count ? model->states[i] : time->lifted[i - model->state_count];
    return out;
}

static bool open_table(ttc_function_reading *out, const ttc_model *model, const ttc_time *time, bool lifted_free)
{
    size_t count;
    uint32_t *states = states_of(model, time, &count);
    const bool ok = states != NULL
                    && ttc_function_reading_open(out, model, states, count, model->params, model->param_count, lifted_free, NULL);
    free(states);
    return ok;
}

static const ttc_time *time_of(const ttc_model *table, const ttc_time *time)
{
    for (size_t i = 0; time != NULL && i < table->time_count; i++)
        if (strcmp(table->times[i].name, time->name) == 0) return table->times + i;
    return NULL;
}

static const char *state_name(const checker *c, size_t i) { return c->model->symbols[c->field->states[i]].name; }

/* Coordinates of another table at the states here: two entries each. */
static void expect_entries(checker *c, const ttc_claim *claim, const ttc_image *image, const ttc_model *table)
{
    for (size_t i = 0; i < 2 * table->state_count; i++)
        expect(c, i, claim->entries[2 * ttc_image_state(image, table, i / 2) + i % 2], UINT32_MAX);
}

/* ---- ways ---- */

static bool check_conditions(checker *c, const record *r, const ttc_way *way)
{
    const ttc_bindings *when = &r->claim->when;
    const size_t count = when->count + way->where.count;
    for (size_t i = 0; i < when->count; i++)
        expect(c, i, ttc_subtract(c->model->graph, c->model->symbols[when->items[i].symbol].node, when->items[i].expression),
               UINT32_MAX);
    for (size_t i = 0; i < way->where.count; i++) expect(c, when->count + i, way->where.items[i].expression, UINT32_MAX);
    return count == 0 || check(c, r, "condition_values", &c->own, count);
}

static bool check_way(checker *c, const record *r, const ttc_way *way, const ttc_model *table, const ttc_claim *back)
{
    ttc_function_reading there = { 0 };
    const size_t n = c->field->state_count;
    bool is_root;
    bool ok = has_room(c, n + 2 * table->state_count + table->param_count + r->claim->when.count + way->where.count);
    if (ok) expect_entries(c, r->claim, &way->image, table);
    ok = ok && check(c, r, "coordinates", &c->own, 2 * table->state_count);
    for (size_t i = 0; ok && i < table->param_count; i++)
        expect(c, i, ttc_image_param(c->model, r->claim, &way->image, table, i, &is_root), UINT32_MAX);
    ok = ok && check(c, r, "params", &c->own, table->param_count) && check_conditions(c, r, way);
    ok = ok && open_table(&there, table, time_of(table, c->field->time), false);
    for (size_t i = 0; ok && i < n; i++) expect(c, i, ttc_given_for(back, state_name(c, i)), UINT32_MAX);
    ok = ok && check(c, r, "back", &there, n);
    ttc_function_reading_close(&there);
    return ok;
}

static bool check_ways(checker *c)
{
    bool ok = true;
    for (size_t i = 0, number = 0; ok && i < c->model->way_count; i++) {
        const ttc_way *way = c->model->ways + i;
        char reason[240];
        uint32_t back;
        ttc_model *table = ttc_way_table(c->model, way, ttc_resolve_beside, NULL, &back, reason, sizeof reason);
        if (table == NULL) continue;
        const record r = { c->model->claims + way->claim, "way", number++ };
        ok = check_way(c, &r, way, table, table->claims + back);
        ttc_model_destroy(table);
    }
    return ok;
}

/* ---- sections ---- */

/* The chart's parameters by place, and the symbols to differentiate a lift by: coordinates, then levels. The caller frees both. */
static bool place(uint32_t **params, uint32_t **slopes, const checker *c, const ttc_section *section, const ttc_model *chart)
{
    const size_t own = c->model->param_count, levels = section->image.level_count, q = chart->state_count;
    *params = malloc((own + levels + 1) * sizeof **params);
    *slopes = calloc(q + levels + 1, sizeof **slopes);
    if (*params == NULL || *slopes == NULL) return false;
    for (size_t i = 0; i < own + levels; i++) (*params)[i] = UINT32_MAX;
    for (size_t i = 0; i < q; i++) (*slopes)[i] = chart->states[i];
    for (size_t i = 0; i < chart->param_count; i++) {
        const uint32_t at = ttc_section_place(c->model, section, chart, i);
        (*params)[at] = chart->params[i];
        if (at >= own) (*slopes)[q + at - own] = chart->params[i];
    }
    return true;
}

static bool check_lift(checker *c, const record *r, const ttc_section *section, const ttc_model *chart)
{
    const size_t n = c->field->state_count, width = chart->state_count + section->image.level_count;
    ttc_function_reading there = { 0 };
    uint32_t *params = NULL, *slopes = NULL;
    bool ok = place(&params, &slopes, c, section, chart)
              && ttc_function_reading_open(&there, chart, chart->states, chart->state_count, params,
                                           c->model->param_count + section->image.level_count, false, NULL);
    for (size_t i = 0; ok && i < n; i++) expect(c, i, ttc_chart_lift(chart, state_name(c, i)), UINT32_MAX);
    ok = ok && check(c, r, "lift", &there, n);
    for (size_t i = 0; ok && i < n * width; i++) expect(c, i, ttc_chart_lift(chart, state_name(c, i / width)), slopes[i % width]);
    ok = ok && check(c, r, "lift_slopes", &there, n * width);
    for (size_t i = 0; ok && i < chart->region_count; i++) expect(c, i, chart->regions[i].expression, UINT32_MAX);
    if (chart->region_count > 0) ok = ok && check(c, r, "region", &there, chart->region_count);
    if (ok && chart->turn != TTC_NONE) {
        expect(c, 0, chart->turn, UINT32_MAX);
        ok = check(c, r, "turn", &there, 1);
    }
    ttc_function_reading_close(&there);
    free(params);
    free(slopes);
    return ok;
}

static bool check_shown(checker *c, const record *r, const char *name, const uint32_t *symbols, size_t count)
{
    for (size_t i = 0; i < count; i++) expect(c, i, c->model->symbols[symbols[i]].node, UINT32_MAX);
    return count == 0 || check(c, r, name, &c->own, count);
}

static bool check_section(checker *c, const record *r, const ttc_section *section, const ttc_model *chart)
{
    const size_t n = c->field->state_count, entries = 2 * chart->state_count;
    const size_t width = chart->state_count + section->image.level_count;
    bool ok = has_room(c, n * (width + entries) + chart->region_count + section->beside_count + section->ending_count + 1);
    ok = ok && check_lift(c, r, section, chart);
    if (ok) expect_entries(c, r->claim, &section->image, chart);
    ok = ok && check(c, r, "back", &c->own, entries);
    for (size_t i = entries; ok && i-- > 0;) /* backwards: the n derivatives of an entry overwrite later ones */
        for (size_t j = n; j-- > 0;) expect(c, i * n + j, c->expected[i].value, c->field->states[j]);
    ok = ok && check(c, r, "back_slopes", &c->free, entries * n);
    return ok && check_shown(c, r, "beside_values", section->beside, section->beside_count)
           && check_shown(c, r, "ending_values", section->ending, section->ending_count);
}

static bool check_sections(checker *c)
{
    bool ok = true;
    for (size_t i = 0, number = 0; ok && i < c->model->section_count; i++) {
        const ttc_section *section = c->model->sections + i;
        char reason[200];
        ttc_model *chart = ttc_section_chart(c->model, section, ttc_resolve_beside, NULL, reason, sizeof reason);
        if (chart == NULL) continue;
        const record r = { c->model->claims + section->claim, "section", number++ };
        ok = check_section(c, &r, section, chart);
        ttc_model_destroy(chart);
    }
    return ok;
}

/* ---- families of equilibria ---- */

static bool open_family(ttc_function_reading *out, const checker *c, const ttc_claim *family, bool imposed)
{
    const ttc_function_bound bound = { { &family->bindings, &family->when }, imposed ? 2 : 1 };
    return ttc_function_reading_open(out, c->model, c->model->states, c->model->state_count, c->model->params,
                                     c->model->param_count, false, &bound);
}

/* The parameters and the states of the family. */
static bool check_points(checker *c, const record *r, ttc_function_reading *on)
{
    const ttc_model *model = c->model;
    ttc_function_reading imposed = { 0 };
    bool ok = has_room(c, model->param_count + model->state_count) && open_family(&imposed, c, r->claim, true);
    for (size_t i = 0; ok && i < model->param_count; i++) expect(c, i, model->symbols[model->params[i]].node, UINT32_MAX);
    ok = ok && check(c, r, "impose", &imposed, model->param_count);
    for (size_t i = 0; ok && i < model->state_count; i++) expect(c, i, model->symbols[model->states[i]].node, UINT32_MAX);
    ok = ok && check(c, r, "point", on, model->state_count);
    ttc_function_reading_close(&imposed);
    return ok;
}

static bool check_gradients(checker *c, const record *r, ttc_function_reading *on, const ttc_claim *member)
{
    const size_t n = c->model->state_count, count = n * member->member_count;
    if (!has_room(c, count)) return false;
    for (size_t i = 0; i < count; i++) {
        const ttc_id value = c->model->claims[member->members[i / n]].expression;
        expect(c, i, ttc_derive_state(c->model, value, i % n), UINT32_MAX);
    }
    return check(c, r, "left_null_gradients", on, count);
}

/* Check what another record says of the family. */
static bool check_member(checker *c, const record *r, ttc_function_reading *on, const ttc_claim *member)
{
    switch (member->kind) {
    case TTC_CLAIM_TRACE:
        expect(c, 0, member->expression, UINT32_MAX);
        return check(c, r, "trace", on, 1);
    case TTC_CLAIM_CHARPOLY:
        return check_one(c, r, "charpoly", on, c->model->state_count + 1, member->expression, ttc_model_lambda(c->model));
    case TTC_CLAIM_MATRIX:
        if (!has_room(c, member->entry_count)) return false;
        for (size_t i = 0; i < member->entry_count; i++) expect(c, i, member->entries[i], UINT32_MAX);
        return check(c, r, "matrix", on, member->entry_count);
    case TTC_CLAIM_LEFT_NULL: return check_gradients(c, r, on, member);
    default: return true;
    }
}

static bool check_families(checker *c, const ttc_kernels *kernels)
{
    bool ok = true;
    for (size_t k = 0; ok && k < kernels->family_count; k++) {
        const uint32_t claim = kernels->families[k];
        const record r = { c->model->claims + claim, "family", k };
        ttc_function_reading on = { 0 };
        ok = open_family(&on, c, r.claim, false) && check_points(c, &r, &on);
        for (size_t i = 0; ok && i < c->model->claim_count; i++) {
            const ttc_claim *member = c->model->claims + i;
            const bool is_member = member->kind >= TTC_CLAIM_TRACE && member->kind <= TTC_CLAIM_LEFT_NULL
                                   && member->family == claim;
            if (is_member) ok = check_member(c, &r, &on, member);
        }
        ttc_function_reading_close(&on);
    }
    return ok;
}

bool ttc_prove_functions_emit(ttc_text *text, ttc_kernels *kernels)
{
    size_t sections = 0, ways = 0;
    return ttc_emit_equilibria(text, kernels) && ttc_emit_sections(text, kernels, &sections) && ttc_emit_ways(text, kernels, &ways)
           && !text->failed;
}

bool ttc_prove_functions_in(const char *text, const ttc_kernels *kernels, ttc_proof_report *report)
{
    checker c = { .field = kernels->field, .model = kernels->field->model, .text = text, .report = report };
    const bool ok = open_table(&c.own, c.model, c.field->time, false) && open_table(&c.free, c.model, c.field->time, true)
                    && check_families(&c, kernels) && check_sections(&c) && check_ways(&c);
    ttc_function_reading_close(&c.own);
    ttc_function_reading_close(&c.free);
    free(c.expected);
    return ok;
}

bool ttc_prove_functions(const ttc_catalogue *catalogue, ttc_proof_report *report)
{
    bool ok = true;
    for (size_t i = 0; ok && i < catalogue->count; i++) {
        ttc_kernels *kernels = catalogue->fields[i].kernels;
        ttc_text text = { 0 };
        if (kernels == NULL || !ttc_field_is_general(kernels->field)) continue;
        ok = ttc_prove_functions_emit(&text, kernels) && ttc_prove_functions_in(ttc_text_string(&text), kernels, report);
        ttc_text_clear(&text);
    }
    return ok;
}
