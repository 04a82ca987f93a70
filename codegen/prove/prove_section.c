/* The prover of sections. In the ring of the table of coordinates, the chart: every point is lifted into the section, the model's
 * domain and the levels, and the way back leads to the point. In the ring of the model: every point that crosses the section in the
 * direction of lifted points is the lift of its image under the way back, on its own levels, and the way back does not divide by
 * zero there. So the chart covers all crossings, except where an angle has no value, and except tangencies. */
#include "prove/domain.h"
#include "prove/prove_image.h"
#include "prove/section_chart.h"

#include <stdlib.h>

static uint32_t symbol_of(const ttc_model *model, const char *name)
{
    uint32_t symbol = 0;
    ttc_model_find_symbol(model, name, &symbol);
    return symbol;
}

/* Bind the model's states and roots to what the chart lifts to them, and its parameters to those of the same name. */
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
        else
            ttc_task_unsettle(task, "the parameter %s of %s is missing in %s: write 'param %s' there", entry->name, model->name,
                              task->model->name, entry->name);
    }
}

/* In the chart: the lift is defined, and lies in the domain, in the section and on the levels; the way back is its inverse. */
static void prove_lift(ttc_task *task)
{
    const ttc_model *model = task->outer->model, *chart = task->model;
    const ttc_claim *claim = task->outer->claim;
    const ttc_section *section = ttc_section_of(task->outer->model, task->outer->claim);
    const ttc_symbol_entry *crossed = &model->symbols[claim->when.items->symbol];
    unsigned char *used = ttc_domain_support(task, TTC_DOMAIN_WHOLE);
    if (used == NULL) ttc_task_unsettle(task, "out of memory");
    else ttc_domain_require_divisors(task, task->field, TTC_DIVIDES_LIFT, 0, used, " in the table of coordinates");
    free(used);
    ttc_valuation *map = ttc_task_open(task) ? ttc_task_enter_map(task, model, task->field) : NULL;
    if (map == NULL) return;
    bind_lift(task, map, model);
    if (ttc_task_open(task)) ttc_domain_require_image(task, map, " of the lift");
    ttc_domain_require_roots(task, map);
    ttc_prove_divisors(task, map, section->claim, section->shown_uses, " in the way back from the lift");
    if (ttc_task_open(task))
        ttc_task_require_equal(task, map, crossed->node, map, claim->when.items->expression,
                               "%s of the lift - its value on the section", crossed->name);
    for (size_t i = 0; i < section->image.level_count && ttc_task_open(task); i++) {
        ttc_prove_divisors(task, map, claim->members[i], SIZE_MAX, " in a level of the lift");
        ttc_task_require_equal(task, map, model->claims[claim->members[i]].expression, task->field,
                               chart->symbols[symbol_of(chart, section->image.levels[i])].node, "%s of the lift - its level %s",
                               model->claims[claim->members[i]].name, section->image.levels[i]);
    }
    for (size_t i = 0; i < chart->state_count && ttc_task_open(task); i++)
        ttc_prove_return(task, map, claim, &section->image, i, false);
    ttc_task_leave_map(task);
}

/* Prove the claims of the chart, and prove_lift in it, once for all leaves. */
static void look_at_chart(ttc_task *task, const ttc_model *chart)
{
    ttc_claim lift = { .kind = TTC_CLAIM_EQUAL, .name = task->claim->name, .place = chart->lift.place,
                       .bindings = chart->lift.bindings };
    ttc_task inner = { .model = chart, .claim = &lift, .role = TTC_DIVIDES_LIFT, .outer = task };
    ttc_proof_report *report = NULL;
    if (chart->turn != TTC_NONE) lift.expression = chart->turn;
    if (!ttc_prove(chart, task->resolver, task->resolver_context, TTC_PROVE_ALL, &report)) ttc_task_unsettle(task, "out of memory");
    for (size_t i = 0; report != NULL && i < report->proof_count; i++) {
        const ttc_proof *proof = report->proofs + i;
        task->relies_on_solver |= proof->relies_on_solver;
        if (proof->status != TTC_PROVED)
            ttc_task_unsettle(task, "the %s %s of %s is %s", proof->kind, proof->name, chart->name,
                              ttc_proof_status_name(proof->status));
    }
    ttc_proof_report_destroy(report);
    if (!ttc_task_open(task)) return;
    ttc_task_run(&inner, prove_lift);
    ttc_task_adopt(task, &inner);
}

/* out *= the rate of the section's state in a valuation. */
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

/* Add the condition that the point and the lift of its image are crossed in one direction. lifted: the model at that lift. */
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

/* Require that the lift of the point's image is the point itself. The condition on the direction is added only if it is needed. */
static void require_same(ttc_task *task, ttc_valuation *map)
{
    const ttc_model *model = task->model, *chart = ttc_valuation_model(map);
    ttc_valuation *lifted = ttc_task_enter_map(task, model, map);
    ttc_ratio difference;
    bool knows_direction = false;
    if (lifted == NULL) return;
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
        ttc_task_take_off(task, &difference, task->field, model->symbols[i].node);
        if (!knows_direction && ttc_task_open(task) && !ttc_ratio_is_zero(task->ring, &difference)) {
            add_direction(task, lifted);
            knows_direction = true;
        }
        ttc_task_require_zero(task, &difference, "%s of the lift of where the way back leads - %s", model->symbols[i].name,
                              model->symbols[i].name);
    }
    ttc_ratio_clear(task->ring, &difference);
    ttc_task_leave_map(task);
}

/* Require that no divisor of the way back and the levels is zero where the section is crossed: the chart would miss that point. */
static void require_way_back(ttc_task *task, const ttc_ratio *rate)
{
    const ttc_model *model = task->model;
    unsigned char *of_claim = ttc_domain_divisors_of_claim(task);
    const ttc_conditions whole = task->domain;
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    ttc_conditions_init(&task->domain, task->field);
    ttc_domain_add(task, &task->domain, TTC_DOMAIN_WITHOUT_CLAIM);
    ttc_conditions_add(&task->domain, rate, TTC_IS_NONZERO);
    if (of_claim == NULL || task->domain.failed) ttc_task_unsettle(task, "out of memory");
    for (size_t i = 0; i < model->divisor_count && ttc_task_open(task); i++) {
        char *point = NULL;
        if (!of_claim[i]) continue;
        ttc_evaluate(task->field, &value, model->divisors[i].divisor);
        const ttc_search_result zero = ttc_task_search(task, &value, TTC_IS_ZERO, &point);
        if (zero != TTC_POINT_IMPOSSIBLE && zero != TTC_POINT_EXCLUDED)
            ttc_task_unsettle(task, "the way back divides by zero where the section is crossed%s%s",
                              point != NULL ? ", as at " : ", or that was not excluded", point != NULL ? point : "");
        free(point);
    }
    ttc_conditions_clear(&task->domain);
    task->domain = whole;
    ttc_ratio_clear(task->ring, &value);
    free(of_claim);
}

/* In the model: every point that crosses the section is the lift of a point of the chart. */
static void prove_back(ttc_task *task, const ttc_model *chart, const ttc_section *section)
{
    ttc_ratio rate;
    ttc_ratio_init(task->ring, &rate);
    ttc_ratio_set_integer(task->ring, &rate, 1);
    times_rate(task, &rate, task->field);
    ttc_conditions_add(&task->domain, &rate, TTC_IS_NONZERO);
    ttc_valuation *map = ttc_task_enter_map(task, chart, task->field);
    if (map != NULL) {
        ttc_prove_bind_image(task, map, task->claim, &section->image);
        if (ttc_task_open(task)) ttc_domain_require_image(task, map, " of the coordinates, where the section is crossed");
        if (ttc_task_open(task)) require_same(task, map);
        ttc_task_leave_map(task);
    }
    if (ttc_task_open(task)) require_way_back(task, &rate);
    ttc_ratio_clear(task->ring, &rate);
}

static bool is_proved(const ttc_task *task, uint32_t claim)
{
    return task->verdict_of != NULL && task->verdict_of(task->verdict_context, claim) == TTC_PROVED;
}

/* Require that integrals of levels and all periods are proved, and that points which differ by periods lie on one level. */
static void check_levels(ttc_task *task)
{
    const ttc_claim *claims = task->model->claims;
    for (size_t i = 0; i < task->claim->member_count && ttc_task_open(task); i++)
        if (!is_proved(task, task->claim->members[i]))
            ttc_task_unsettle(task, "it is on levels of %s, which is not proved", claims[task->claim->members[i]].name);
    for (uint32_t i = 0; i < task->model->claim_count && ttc_task_open(task); i++)
        if (claims[i].kind == TTC_CLAIM_PERIODIC && !is_proved(task, i))
            ttc_task_unsettle(task, "it takes points that differ by the period of %s for one, which is not proved", claims[i].name);
    for (size_t i = 0; i < task->claim->member_count && ttc_task_open(task); i++)
        ttc_prove_level_is_periodic(task, task->model->claims + task->claim->members[i], UINT32_MAX);
}

void ttc_prove_section(ttc_task *task)
{
    const ttc_section *section = ttc_section_of(task->model, task->claim);
    char reason[TTC_DIAGNOSTIC_LINE + 200];
    ttc_model *chart = ttc_section_chart(task->model, section, task->resolver, task->resolver_context, reason, sizeof reason);
    if (chart == NULL) {
        ttc_task_unsettle(task, "%s", reason);
        return;
    }
    if (!task->is_lifted) look_at_chart(task, chart);
    task->is_lifted = true;
    if (ttc_task_open(task)) prove_back(task, chart, section);
    check_levels(task);
    ttc_model_destroy(chart);
}
