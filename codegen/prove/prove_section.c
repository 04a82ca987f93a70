/* A section and its coordinates. In the ring of their table, its chart: every point of it is lifted into the section, the model's
 * domain and the levels, and the way back leads to it. In the ring of the model: what crosses the section, in the direction in
 * which lifted points do, is lifted from where the way back leads, on its own levels. So nothing is missed, but for points
 * at which an angle has no value, and for tangencies. */
#include "prove/domain.h"
#include "prove/section_chart.h"

#include <stdlib.h>
#include <string.h>

static const ttc_section *section_of(const ttc_task *task)
{
    size_t i = 0;
    while (task->model->claims + task->model->sections[i].claim != task->claim) i++;
    return task->model->sections + i;
}

static uint32_t symbol_of(const ttc_model *model, const char *name)
{
    uint32_t symbol = 0;
    ttc_model_find_symbol(model, name, &symbol);
    return symbol;
}

/* out -= the value of an expression. */
static void take_off(ttc_task *task, ttc_ratio *out, ttc_valuation *valuation, ttc_id id)
{
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    ttc_evaluate(valuation, &value, id);
    ttc_ratio_subtract(task->ring, out, out, &value);
    ttc_ratio_clear(task->ring, &value);
}

/* Roots of the other model are positive, whichever sign makes one of them rational here. */
static void add_roots(ttc_task *task, ttc_valuation *map)
{
    const ttc_model *model = ttc_valuation_model(map);
    ttc_ratio root;
    ttc_ratio_init(task->ring, &root);
    for (size_t i = 0; i < model->symbol_count && ttc_task_open(task); i++) {
        if (model->symbols[i].kind != TTC_ROOT) continue;
        ttc_evaluate(map, &root, model->symbols[i].node);
        ttc_conditions_add(&task->domain, &root, TTC_IS_POSITIVE);
    }
    ttc_ratio_clear(task->ring, &root);
}

/* The model seen from its chart: states and roots as they are lifted, parameters by their names. */
static void bind_lift(ttc_task *task, ttc_valuation *map, const ttc_model *model)
{
    for (uint32_t i = 0; i < model->symbol_count && ttc_task_open(task); i++) {
        const ttc_symbol_entry *entry = model->symbols + i;
        uint32_t own;
        const ttc_id lifted = ttc_chart_lift(task->model, entry->name);
        if (entry->kind == TTC_STATE || (entry->kind == TTC_ROOT && lifted != TTC_NONE)) ttc_valuation_bind(map, i, lifted);
        if (entry->kind != TTC_PARAM) continue;
        if (ttc_model_find_symbol(task->model, entry->name, &own) && task->model->symbols[own].kind == TTC_PARAM)
            ttc_valuation_bind(map, i, task->model->symbols[own].node);
        else ttc_task_unsettle(task, "the parameter %s of %s is missing in %s", entry->name, model->name, task->model->name);
    }
}

/* The way back from a lifted point. Of an angle q whose sine and cosine are A and B over one positive number, A cos q - B sin q = 0
 * and A sin q + B cos q > 0. */
static void require_return(ttc_task *task, ttc_valuation *map, const ttc_section *section, const ttc_id *entries, size_t state)
{
    enum { A, B, COSINE, SINE, ACROSS, ALONG, COUNT };
    const ttc_model *chart = task->model;
    const ttc_symbol_entry *coordinate = chart->symbols + chart->states[state];
    const size_t k = ttc_section_coordinate(section, chart, state);
    uint32_t cosine;
    ttc_ratio *r = ttc_task_ratios(task, COUNT);
    if (r == NULL) return;
    ttc_evaluate(map, &r[A], entries[2 * k]);
    ttc_evaluate(map, &r[B], entries[2 * k + 1]);
    if (section->is_angle[k] && ttc_chart_cosine(chart, chart->states[state], &cosine)) {
        ttc_evaluate(task->field, &r[COSINE], chart->symbols[cosine].node);
        ttc_evaluate(task->field, &r[SINE], chart->symbols[chart->symbols[cosine].partner].node);
        ttc_ratio_add_product(task->ring, &r[ALONG], &r[A], &r[SINE]);
        ttc_ratio_add_product(task->ring, &r[ALONG], &r[B], &r[COSINE]);
        ttc_ratio_multiply(task->ring, &r[ACROSS], &r[A], &r[COSINE]);
        ttc_ratio_multiply(task->ring, &r[B], &r[B], &r[SINE]);
        ttc_ratio_subtract(task->ring, &r[ACROSS], &r[ACROSS], &r[B]);
        ttc_task_require_zero(task, &r[ACROSS], "the way back from the lift is not %s: across it", coordinate->name);
        ttc_task_require(task, &r[ALONG], TTC_IS_POSITIVE, "the way back from the lift is opposite to %s: along it", coordinate->name);
    } else {
        take_off(task, &r[A], task->field, coordinate->node);
        ttc_task_require_zero(task, &r[A], "the way back from the lift - %s", coordinate->name);
    }
    ttc_task_free(task, r, COUNT);
}

/* In the chart: the lift is defined, and lies in the domain, in the section and on the levels; the way back undoes it. */
static void prove_lift(ttc_task *task)
{
    const ttc_model *model = task->section->model, *chart = task->model;
    const ttc_claim *claim = task->section->claim;
    const ttc_section *section = section_of(task->section);
    ttc_valuation *map = ttc_valuation_map(model, task->field);
    unsigned char *used = ttc_domain_support(task), *back = ttc_model_support(model, claim->entries, claim->entry_count);
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    if (map == NULL || used == NULL || back == NULL) {
        ttc_task_unsettle(task, "out of memory");
        goto done;
    }
    ttc_domain_require_divisors(task, task->field, chart, TTC_DIVIDES_LIFT, 0, used, " in the table of coordinates");
    bind_lift(task, map, model);
    if (ttc_task_open(task)) ttc_domain_require_image(task, map, model, " of the lift");
    for (size_t i = 0; i < model->symbol_count && ttc_task_open(task); i++)
        if (model->symbols[i].kind == TTC_ROOT && ttc_valuation_is_bound(map, (uint32_t)i))
            ttc_domain_require_root(task, map, model->symbols + i);
    ttc_domain_require_divisors(task, map, model, TTC_DIVIDES_CLAIM, section->claim, back, " in the way back from the lift");
    add_roots(task, map);
    if (ttc_task_open(task)) {
        const ttc_binding *at = claim->when.items;
        ttc_evaluate(map, &value, model->symbols[at->symbol].node);
        take_off(task, &value, map, at->expression);
        ttc_task_require_zero(task, &value, "%s of the lift - its value on the section", model->symbols[at->symbol].name);
    }
    for (size_t i = 0; i < section->level_count && ttc_task_open(task); i++) {
        ttc_evaluate(map, &value, model->claims[claim->members[i]].expression);
        take_off(task, &value, task->field, chart->symbols[symbol_of(chart, section->levels[i])].node);
        ttc_task_require_zero(task, &value, "%s of the lift - its level %s", model->claims[claim->members[i]].name, section->levels[i]);
    }
    for (size_t i = 0; i < chart->state_count && ttc_task_open(task); i++) require_return(task, map, section, claim->entries, i);
done:
    ttc_ratio_clear(task->ring, &value);
    free(back);
    free(used);
    ttc_valuation_destroy(map);
}

/* The chart's own claims, and what it says of this section, once for all leaves. */
static void look_at_chart(ttc_task *task, const ttc_model *chart)
{
    ttc_claim lift = { .kind = TTC_CLAIM_EQUAL, .name = task->claim->name, .place = chart->lift.place,
                       .bindings = chart->lift.bindings };
    ttc_task inner = { .model = chart, .claim = &lift, .role = TTC_DIVIDES_LIFT, .section = task };
    ttc_proof_report *report = NULL;
    if (chart->turn != TTC_NONE) lift.expression = chart->turn;
    if (!ttc_prove(chart, task->resolver, task->resolver_context, TTC_PROVE_ALL, &report)) ttc_task_unsettle(task, "out of memory");
    for (size_t i = 0; report != NULL && i < report->proof_count; i++) {
        const ttc_proof *proof = report->proofs + i;
        task->relies_on_solver |= proof->relies_on_solver;
        if (proof->status != TTC_PROVED)
            ttc_task_unsettle(task, "the %s %s of %s is %s", proof->kind, proof->name, chart->name, ttc_proof_status_name(proof->status));
    }
    ttc_proof_report_destroy(report);
    if (!ttc_task_open(task)) return;
    ttc_task_run(&inner, prove_lift);
    ttc_task_adopt(task, &inner);
}

/* Cosine and sine of an angle, A and B over r with r^2 = A^2 + B^2, r a name of its own, are bound to the chart's symbols. */
static bool bind_angle(ttc_task *task, ttc_valuation *map, uint32_t cosine, const ttc_id *entries, uint32_t spare)
{
    ttc_graph *graph = task->model->graph;
    const ttc_id square = ttc_add(graph, ttc_power(graph, entries[0], 2), ttc_power(graph, entries[1], 2));
    const ttc_id length = ttc_symbol(graph, spare);
    const ttc_id sine_value = ttc_divide(graph, entries[0], length), cosine_value = ttc_divide(graph, entries[1], length);
    ttc_ratio value;
    if (square == TTC_NONE || sine_value == TTC_NONE || cosine_value == TTC_NONE) return false;
    ttc_valuation_bind_root(task->field, spare, square);
    ttc_valuation_bind(map, cosine, cosine_value);
    ttc_valuation_bind(map, ttc_valuation_model(map)->symbols[cosine].partner, sine_value);
    ttc_ratio_init(task->ring, &value);
    ttc_evaluate(task->field, &value, square);
    ttc_conditions_add(&task->domain, &value, TTC_IS_POSITIVE);
    ttc_evaluate(task->field, &value, length);
    ttc_conditions_add(&task->domain, &value, TTC_IS_POSITIVE);
    ttc_ratio_clear(task->ring, &value);
    return true;
}

/* The chart seen from the model: coordinates by the way back, levels by their integrals. */
static void bind_back(ttc_task *task, ttc_valuation *map, const ttc_section *section)
{
    const ttc_model *model = task->model, *chart = ttc_valuation_model(map);
    uint32_t spares = 0;
    for (size_t i = 0; i < chart->state_count && ttc_task_open(task); i++) {
        const size_t k = ttc_section_coordinate(section, chart, i);
        uint32_t cosine;
        if (!section->is_angle[k]) ttc_valuation_bind(map, chart->states[i], task->claim->entries[2 * k]);
        else if (!ttc_chart_cosine(chart, chart->states[i], &cosine) || spares == TTC_SPARE_SYMBOLS ||
                 !bind_angle(task, map, cosine, task->claim->entries + 2 * k, (uint32_t)model->symbol_count + spares++))
            ttc_task_unsettle(task, "out of memory, or more than %d angles", TTC_SPARE_SYMBOLS);
    }
    for (size_t i = 0; i < chart->param_count && ttc_task_open(task); i++) {
        const uint32_t place = ttc_section_place(model, section, chart, i);
        const bool is_level = place >= model->param_count;
        const ttc_id level = is_level ? model->claims[task->claim->members[place - model->param_count]].expression : TTC_NONE;
        ttc_valuation_bind(map, chart->params[i], is_level ? level : model->symbols[model->params[place]].node);
    }
}

/* The rate of the section's state, seen through a map, or here: out *= it. */
static void times_rate(ttc_task *task, ttc_ratio *out, ttc_valuation *valuation)
{
    const ttc_model *model = task->model;
    ttc_ratio rate;
    size_t i = 0;
    while (model->states[i] != task->claim->when.items[0].symbol) i++;
    ttc_ratio_init(task->ring, &rate);
    ttc_evaluate(valuation, &rate, ttc_model_field(model, i));
    ttc_ratio_multiply(task->ring, out, out, &rate);
    ttc_ratio_clear(task->ring, &rate);
}

/* Lifted points that are crossed the same way: `lifted` is the model seen from the chart that is seen from the model. */
static void add_direction(ttc_task *task, ttc_valuation *lifted)
{
    ttc_ratio product;
    ttc_ratio_init(task->ring, &product);
    ttc_ratio_set_integer(task->ring, &product, 1);
    times_rate(task, &product, task->field);
    times_rate(task, &product, lifted);
    ttc_conditions_add(&task->domain, &product, TTC_IS_POSITIVE);
    ttc_ratio_clear(task->ring, &product);
}

/* The lift of where the way back leads is the point itself. The direction matters only where it is not. */
static void require_same(ttc_task *task, ttc_valuation *map)
{
    const ttc_model *model = task->model, *chart = ttc_valuation_model(map);
    ttc_valuation *lifted = ttc_valuation_map(model, map);
    ttc_ratio difference;
    bool knows_direction = false;
    if (lifted == NULL) {
        ttc_task_unsettle(task, "out of memory");
        return;
    }
    ttc_ratio_init(task->ring, &difference);
    for (uint32_t i = 0; i < model->symbol_count; i++) {
        const ttc_id lift = ttc_chart_lift(chart, model->symbols[i].name);
        const ttc_symbol_kind kind = model->symbols[i].kind;
        if (kind == TTC_STATE || (kind == TTC_ROOT && lift != TTC_NONE)) ttc_valuation_bind(lifted, i, lift);
        if (kind == TTC_PARAM) ttc_valuation_bind(lifted, i, chart->symbols[symbol_of(chart, model->symbols[i].name)].node);
    }
    for (uint32_t i = 0; i < model->symbol_count && ttc_task_open(task); i++) {
        if (!ttc_valuation_is_bound(lifted, i) || model->symbols[i].kind == TTC_PARAM) continue;
        ttc_evaluate(lifted, &difference, model->symbols[i].node);
        take_off(task, &difference, task->field, model->symbols[i].node);
        if (!knows_direction && ttc_task_open(task) && !ttc_ratio_is_zero(task->ring, &difference)) {
            add_direction(task, lifted);
            knows_direction = true;
        }
        ttc_task_require_zero(task, &difference, "%s of the lift of where the way back leads - %s", model->symbols[i].name,
                              model->symbols[i].name);
    }
    ttc_ratio_clear(task->ring, &difference);
    ttc_valuation_destroy(lifted);
}

/* In the model: what crosses the section comes from the chart. */
static void prove_back(ttc_task *task, const ttc_model *chart, const ttc_section *section)
{
    ttc_valuation *map = ttc_valuation_map(chart, task->field);
    ttc_ratio rate;
    if (map == NULL) {
        ttc_task_unsettle(task, "out of memory");
        return;
    }
    ttc_ratio_init(task->ring, &rate);
    ttc_ratio_set_integer(task->ring, &rate, 1);
    times_rate(task, &rate, task->field);
    ttc_conditions_add(&task->domain, &rate, TTC_IS_NONZERO);
    bind_back(task, map, section);
    if (ttc_task_open(task) && ttc_task_search(task, NULL, TTC_IS_ZERO, NULL) != TTC_POINT_FOUND)
        ttc_task_unsettle(task, "no point is known at which the section is crossed and every angle has a value");
    if (ttc_task_open(task)) ttc_domain_require_image(task, map, chart, " of the coordinates, where the section is crossed");
    add_roots(task, map);
    if (ttc_task_open(task)) require_same(task, map);
    ttc_ratio_clear(task->ring, &rate);
    ttc_valuation_destroy(map);
}

void ttc_prove_section(ttc_task *task)
{
    const ttc_section *section = section_of(task);
    char reason[240];
    ttc_model *chart = ttc_section_chart(task->model, section, task->resolver, task->resolver_context, reason, sizeof reason);
    if (chart == NULL) {
        ttc_task_unsettle(task, "%s", reason);
        return;
    }
    if (!task->is_lifted) look_at_chart(task, chart);
    task->is_lifted = true;
    if (ttc_task_open(task)) prove_back(task, chart, section);
    ttc_model_destroy(chart);
}
