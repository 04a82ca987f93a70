/* Writes poles, and sections with coordinates of their own: tables, and kernels on raw parameters followed by the levels.
 * Functions of the coordinates come from their table, the chart, whose expressions are in its own graph. */
#include "emit/emit.h"

#include "prove/section_chart.h"

#include <stdlib.h>

void ttc_emit_poles(ttc_text *text, const ttc_field *field)
{
    const ttc_model *model = field->model;
    if (!ttc_field_is_general(field) || model->pole_count == 0) return;
    ttc_text_add(text, "static const jlt_pole poles[] = {\n");
    for (size_t i = 0; i < model->pole_count; i++) {
        ttc_text_format(text, "    { %u, \"", (unsigned)field->symbols[model->poles[i].state].position);
        ttc_text_add_escaped(text, model->poles[i].meaning);
        ttc_text_add(text, "\" },\n");
    }
    ttc_text_add(text, "};\n\n");
}

void ttc_emit_pole_member(ttc_text *text, const ttc_field *field)
{
    if (ttc_field_is_general(field) && field->model->pole_count > 0)
        ttc_text_format(text, "    .pole_count = %zu, .poles = poles,\n", field->model->pole_count);
}

typedef struct {
    ttc_text *text;
    const ttc_kernels *kernels;
    const ttc_section *section;
    const ttc_claim *claim;
    size_t number; /* index among the sections that are written */
    ttc_model *chart;
    ttc_field *field;   /* of the chart */
    uint32_t *slopes;   /* symbols of the chart: coordinates, then levels */
    size_t slope_count;
    bool *is_angle;     /* by coordinate, in the order of the chart */
    ttc_id *ids;        /* room for the outputs of any kernel */
} section_emitter;

/* A kernel of the first `count` expressions in e->ids, in the symbols of `field`. */
static bool emit_program(section_emitter *e, const char *name, ttc_field *field, size_t count)
{
    return ttc_emit_numbered(e->text, "section", e->number, name, field, e->ids, count);
}

static ttc_id lifted(const section_emitter *e, size_t state)
{
    const ttc_field *field = e->kernels->field;
    return ttc_chart_lift(e->chart, field->model->symbols[field->states[state]].name);
}

static bool emit_lift(section_emitter *e)
{
    const size_t n = e->kernels->field->state_count;
    for (size_t i = 0; i < n; i++) e->ids[i] = ttc_field_specialise(e->field, lifted(e, i));
    return emit_program(e, "lift", e->field, n);
}

static bool emit_lift_slopes(section_emitter *e)
{
    const size_t n = e->kernels->field->state_count;
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < e->slope_count; j++) {
            const ttc_id slope = ttc_model_partial(e->chart, lifted(e, i), e->slopes[j]);
            if (slope == TTC_NONE) return false;
            e->ids[i * e->slope_count + j] = ttc_field_specialise(e->field, slope);
        }
    return emit_program(e, "lift_slopes", e->field, n * e->slope_count);
}

static bool emit_region(section_emitter *e)
{
    const size_t count = e->chart->region_count;
    for (size_t i = 0; i < count; i++) e->ids[i] = ttc_field_specialise(e->field, e->chart->regions[i].expression);
    return count == 0 || emit_program(e, "region", e->field, count);
}

static bool emit_turn(section_emitter *e)
{
    if (e->chart->turn == TTC_NONE) return true;
    e->ids[0] = ttc_field_specialise(e->field, e->chart->turn);
    return emit_program(e, "turn", e->field, 1);
}

static bool emit_back(section_emitter *e)
{
    ttc_field *field = e->kernels->field;
    const size_t n = field->state_count, count = 2 * e->chart->state_count;
    ttc_id *back = calloc(count + 1, sizeof *back);
    for (size_t i = 0; back != NULL && i < count; i++) {
        const size_t k = ttc_image_state(&e->section->image, e->chart, i / 2);
        back[i] = e->ids[i] = ttc_field_specialise(field, e->claim->entries[2 * k + i % 2]);
    }
    bool ok = back != NULL && emit_program(e, "back", field, count);
    for (size_t i = 0; ok && i < count; i++)
        for (size_t j = 0; ok && j < n; j++) {
            e->ids[i * n + j] = ttc_field_partial(field, back[i], j);
            ok = e->ids[i * n + j] != TTC_NONE;
        }
    ok = ok && emit_program(e, "back_slopes", field, count * n);
    free(back);
    return ok;
}

static bool emit_shown(section_emitter *e, const char *what, const uint32_t *symbols, size_t count)
{
    ttc_field *field = e->kernels->field;
    ttc_text name = { 0 };
    if (count == 0) return true;
    for (size_t i = 0; i < count; i++) e->ids[i] = ttc_field_specialise(field, field->model->symbols[symbols[i]].node);
    ttc_text_format(&name, "%s_values", what);
    const bool ok = !name.failed && emit_program(e, ttc_text_string(&name), field, count);
    ttc_text_clear(&name);
    ttc_text_format(&name, "section%zu_%s", e->number, what);
    ttc_emit_quantities(e->text, ttc_text_string(&name), field->model, symbols, count, NULL);
    ttc_text_clear(&name);
    return ok;
}

static void add_coordinates(section_emitter *e)
{
    ttc_text name = { 0 };
    const size_t n = e->chart->state_count, levels = e->section->image.level_count;
    ttc_text_format(&name, "section%zu_coordinates", e->number);
    ttc_emit_quantities(e->text, ttc_text_string(&name), e->chart, e->chart->states, n, e->is_angle);
    ttc_text_clear(&name);
    ttc_text_format(e->text, "static const unsigned char section%zu_is_angle[] = { ", e->number);
    for (size_t i = 0; i < n; i++) ttc_text_format(e->text, "%s%d", i == 0 ? "" : ", ", e->is_angle[i]);
    ttc_text_add(e->text, " };\n\n");
    if (levels == 0) return;
    ttc_text_format(&name, "section%zu_levels", e->number);
    ttc_emit_quantities(e->text, ttc_text_string(&name), e->chart, e->slopes + n, levels, NULL);
    ttc_text_clear(&name);
    ttc_text_format(e->text, "static const unsigned section%zu_integrals[] = { ", e->number);
    for (size_t i = 0; i < levels; i++) {
        size_t k = 0;
        while (k < e->kernels->integral_count && e->kernels->integrals[k] != e->claim->members[i]) k++;
        ttc_text_format(e->text, "%s%zu", i == 0 ? "" : ", ", k);
    }
    ttc_text_add(e->text, " };\n\n");
}

static void add_starts(section_emitter *e)
{
    const ttc_model *chart = e->chart;
    if (chart->start_count == 0) return;
    for (size_t i = 0; i < chart->start_count; i++) {
        ttc_text_format(e->text, "static const double section%zu_start%zu[] = { ", e->number, i);
        for (size_t k = 0; k < chart->state_count; k++) {
            ttc_text_add(e->text, k == 0 ? "" : ", ");
            ttc_emit_constant(e->text, ttc_coefficient(chart->graph, chart->starts[i].point[k]));
        }
        ttc_text_add(e->text, " };\n");
    }
    ttc_text_format(e->text, "static const jlt_section_point section%zu_starts[] = {\n", e->number);
    for (size_t i = 0; i < chart->start_count; i++)
        ttc_text_format(e->text, "    { \"%s\", section%zu_start%zu },\n", chart->starts[i].name, e->number, i);
    ttc_text_add(e->text, "};\n\n");
}

static void add_list(ttc_text *table, const section_emitter *e, const char *what, size_t count)
{
    if (count > 0)
        ttc_text_format(table, "      .%s_count = %zu, .%s = section%zu_%s, .%s_values = section%zu_%s_values,\n", what, count,
                        what, e->number, what, what, e->number, what);
}

static void add_entry(ttc_text *table, const section_emitter *e)
{
    const ttc_model *chart = e->chart;
    const ttc_field *field = e->kernels->field;
    const size_t k = e->number;
    ttc_text_format(table,
                    "    { .name = \"%s\", .chart = \"%s\", .file = \"", e->claim->name, chart->name);
    ttc_text_add_escaped(table, e->claim->target);
    ttc_text_format(table,
                    "\",\n      .sha256 = \"%s\",\n      .table = jlt_chart_%s_%u,\n      .claim = %u, .column = %u, .level = ",
                    chart->sha256, e->kernels->field->model->name, (unsigned)e->section->claim, (unsigned)e->section->claim,
                    (unsigned)field->symbols[e->claim->when.items[0].symbol].position);
    ttc_emit_constant(table, ttc_coefficient(field->graph, e->claim->when.items[0].expression));
    ttc_text_format(table,
                    ",\n      .coordinate_count = %zu, .coordinates = section%zu_coordinates, .is_angle = section%zu_is_angle,\n",
                    chart->state_count, k, k);
    if (e->section->image.level_count > 0)
        ttc_text_format(table, "      .level_count = %zu, .levels = section%zu_levels, .integrals = section%zu_integrals,\n",
                        e->section->image.level_count, k, k);
    ttc_text_format(table, "      .lift = section%zu_lift, .lift_slopes = section%zu_lift_slopes,\n", k, k);
    if (chart->region_count > 0)
        ttc_text_format(table, "      .region_count = %zu, .region = section%zu_region,\n", chart->region_count, k);
    ttc_text_format(table, "      .back = section%zu_back, .back_slopes = section%zu_back_slopes,\n", k, k);
    add_list(table, e, "beside", e->section->beside_count);
    add_list(table, e, "ending", e->section->ending_count);
    if (chart->start_count > 0)
        ttc_text_format(table, "      .start_count = %zu, .starts = section%zu_starts,\n", chart->start_count, k);
    if (chart->turn != TTC_NONE) ttc_text_format(table, "      .turn = section%zu_turn,\n", k);
    ttc_text_add(table, "      .turn_meaning = \"");
    ttc_text_add_escaped(table, chart->turn_meaning);
    ttc_text_add(table, "\" },\n");
}

/* Allocate memory, place the chart's parameters among those that kernels get, and list the symbols to differentiate by. */
static bool prepare(section_emitter *e)
{
    const ttc_model *model = e->kernels->field->model, *chart = e->chart;
    const size_t n = e->kernels->field->state_count, levels = e->section->image.level_count, q = chart->state_count;
    size_t outputs = n * (q + levels + 2 * q) + chart->region_count + e->section->beside_count + e->section->ending_count + 2 * q
                     + 1;
    uint32_t *places = calloc(chart->param_count + 1, sizeof *places);
    e->slope_count = q + levels;
    e->slopes = calloc(e->slope_count + 1, sizeof *e->slopes);
    e->is_angle = calloc(q + 1, sizeof *e->is_angle);
    e->ids = calloc(outputs, sizeof *e->ids);
    bool ok = places != NULL && e->slopes != NULL && e->is_angle != NULL && e->ids != NULL &&
              ttc_field_create(&e->field, chart, NULL, NULL, NULL) == TTC_FIELD_OK;
    for (size_t i = 0; ok && i < q; i++) {
        e->slopes[i] = chart->states[i];
        e->is_angle[i] = e->section->image.forms[ttc_image_state(&e->section->image, chart, i)] == TTC_GIVEN_ANGLE;
    }
    for (size_t i = 0; ok && i < chart->param_count; i++) {
        places[i] = ttc_section_place(model, e->section, chart, i);
        if (places[i] >= model->param_count) e->slopes[q + places[i] - model->param_count] = chart->params[i];
    }
    ok = ok && ttc_field_place_params(e->field, places, model->param_count + levels);
    free(places);
    return ok;
}

static bool emit_section(section_emitter *e)
{
    const ttc_section *section = e->section;
    if (!prepare(e)) return false;
    ttc_text_format(e->text, "/* Section %s: %s = ", e->claim->name,
                    e->kernels->field->symbols[e->claim->when.items[0].symbol].name);
    ttc_emit_formula(e->text, e->kernels->field->graph, e->claim->when.items[0].expression, ttc_emit_symbol_name,
                     e->kernels->field);
    ttc_text_format(e->text, ", in coordinates of the table %s, SHA-256\n * %s. */\n", e->chart->name, e->chart->sha256);
    const bool ok = emit_lift(e) && emit_lift_slopes(e) && emit_region(e) && emit_back(e) &&
                    emit_shown(e, "beside", section->beside, section->beside_count) &&
                    emit_shown(e, "ending", section->ending, section->ending_count) && emit_turn(e);
    add_coordinates(e);
    add_starts(e);
    return ok;
}

bool ttc_emit_sections(ttc_text *text, ttc_kernels *kernels, size_t *count)
{
    const ttc_model *model = kernels->field->model;
    ttc_text table = { 0 };
    bool ok = true;
    *count = 0;
    for (size_t i = 0; ok && i < model->section_count && ttc_field_is_general(kernels->field); i++) {
        char reason[200];
        section_emitter e = { .text = text, .kernels = kernels, .section = model->sections + i, .number = *count };
        e.claim = model->claims + e.section->claim;
        e.chart = ttc_section_chart(model, e.section, ttc_resolve_beside, NULL, reason, sizeof reason);
        if (e.chart == NULL) continue;
        ok = emit_section(&e);
        if (ok) add_entry(&table, &e);
        else kernels->failed_claim = e.claim;
        ++*count;
        ttc_field_destroy(e.field);
        ttc_model_destroy(e.chart);
        free(e.slopes);
        free(e.is_angle);
        free(e.ids);
    }
    if (*count > 0) ttc_text_format(text, "static const jlt_section_chart sections[] = {\n%s};\n\n", ttc_text_string(&table));
    text->failed |= table.failed;
    ttc_text_clear(&table);
    return ok;
}
