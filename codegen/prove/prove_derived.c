#include "prove/prove_derived.h"

#include "prove/domain.h"
#include "prove/observed.h"
#include "prove/signs.h"

/* A radicand, or the argument of a logarithm, is positive wherever all other conditions of the domain hold. */
static void prove_root(ttc_task *task)
{
    const ttc_symbol_entry *root = &task->model->symbols[task->claim->family];
    ttc_signs_require(task, task->field, root->definition, TTC_IS_POSITIVE,
                         "not positive everywhere, so that a domain record is missing: the %s of %s",
                         root->kind == TTC_LOG ? "argument" : "radicand", root->name);
}

static void prove_nothing(ttc_task *task) { (void)task; }

/* Check, in a task without the substitutions, that the variant's expressions have values except at points that others surround. */
static void look_at_values(ttc_task *task)
{
    const ttc_claim values = { .kind = TTC_CLAIM_EQUAL, .name = task->claim->name, .place = task->claim->place,
                               .family = task->claim->family };
    ttc_task inner = { .model = task->model, .claim = &values, .role = task->role, .owner = task->owner, .outer = task };
    ttc_task_run(&inner, prove_nothing);
    ttc_task_adopt(task, &inner);
    task->is_lifted = true;
}

/* The values obey the signs of the parameters that they replace, and the field is defined under the substitution. */
static void prove_variant(ttc_task *task)
{
    ttc_ratio value;
    if (!task->is_lifted) look_at_values(task);
    if (task->tested != NULL) {
        ttc_domain_require_tested(task);
        return;
    }
    ttc_ratio_init(task->ring, &value);
    for (size_t i = 0; i < task->model->state_count; i++) ttc_evaluate(task->field, &value, ttc_model_field(task->model, i));
    ttc_ratio_clear(task->ring, &value);
}

/* dt = factor dtau keeps the direction of time, and a lifted root r, as a state, stays on r^2 = radicand:
 * 2 r dr/dtau = d(radicand)/dtau. */
static void prove_time(ttc_task *task)
{
    const ttc_time *time = &task->model->times[task->claim->family];
    ttc_graph *graph = task->model->graph;
    ttc_signs_require(task, task->field, time->factor, TTC_IS_POSITIVE, "not positive: dt/dtau");
    for (size_t i = 0; i < time->lifted_count && ttc_task_open(task); i++) {
        const ttc_symbol_entry *root = &task->model->symbols[time->lifted[i]];
        const ttc_id of_root = ttc_multiply(graph, time->factor, ttc_derive_field(task->model, root->node)),
                     of_square = ttc_multiply(graph, ttc_multiply(graph, ttc_integer(graph, 2), root->node), of_root),
                     of_radicand = ttc_multiply(graph, time->factor, ttc_derive_field(task->model, root->definition));
        ttc_task_require_equal(task, task->field, of_square, task->field, of_radicand, "d(%s^2 - radicand)/dtau", root->name);
    }
}

static const ttc_elimination *elimination_of(const ttc_task *task)
{
    return &task->model->eliminations[task->claim->family];
}

static void prove_slope(ttc_task *task)
{
    ttc_ratio slope;
    ttc_ratio_init(task->ring, &slope);
    ttc_evaluate(task->field, &slope, elimination_of(task)->slope);
    const bool zero = ttc_task_open(task) && ttc_ratio_is_zero(task->ring, &slope);
    if (ttc_task_open(task) && zero && ttc_task_may_have_point(task))
        ttc_task_unsettle(task, "on a whole part of the domain the integral does not tell the state: its slope is zero there");
    ttc_ratio_clear(task->ring, &slope);
}

/* Check in a task of its own, with the eliminated state free, that the slope of the integral is not zero on a whole part of the
 * domain; the solution divides by the slope, so that it has no points at which this is zero. */
static void look_at_slope(ttc_task *task)
{
    const ttc_claim slope = { .kind = TTC_CLAIM_EQUAL, .name = task->claim->name, .place = task->claim->place,
                              .family = task->claim->family };
    ttc_task inner = { .model = task->model, .claim = &slope, .role = TTC_DIVIDES_FIELD, .outer = task };
    ttc_task_run(&inner, prove_slope);
    ttc_task_adopt(task, &inner);
    task->is_lifted = true;
}

/* With the solution in place of the state, the integral has the level's value, and the solution has the state's rate. */
static void prove_elimination(ttc_task *task)
{
    const ttc_elimination *elimination = elimination_of(task);
    const ttc_claim *integral = &task->model->claims[elimination->integral];
    const ttc_symbol_entry *state = &task->model->symbols[elimination->state];
    size_t at = 0;
    if (!task->is_lifted) look_at_slope(task);
    ttc_task_require_equal(task, task->field, integral->expression, task->field, task->model->symbols[elimination->level].node,
                           "%s - its level", integral->name);
    while (task->model->states[at] != elimination->state) at++;
    ttc_task_require_equal(task, task->field, ttc_derive_field(task->model, elimination->solution), task->field,
                           ttc_model_field(task->model, at), "rate of the solution for %s - its equation", state->name);
    ttc_prove_level_is_periodic(task, integral, elimination->state);
}

/* Returns true for roots and logarithms, whose definitions must be positive. */
static bool is_of_positive(const ttc_symbol_entry *entry) { return entry->kind == TTC_ROOT || entry->kind == TTC_LOG; }

static size_t root_count(const ttc_model *model)
{
    size_t count = 0;
    for (size_t i = 0; i < model->symbol_count; i++) count += is_of_positive(&model->symbols[i]);
    return count;
}

static uint32_t root_at(const ttc_model *model, size_t index)
{
    uint32_t symbol = 0;
    while (!is_of_positive(&model->symbols[symbol]) || index-- > 0) symbol++;
    return symbol;
}

static size_t record_count(const ttc_model *model)
{
    return root_count(model) + model->variant_count + model->time_count + model->elimination_count + model->pole_count
           + ttc_observed_count(model);
}

static bool is_between_expressions(const ttc_model *model, const ttc_symbol_entry *state)
{
    return state->low != TTC_NONE && state->high != TTC_NONE
           && (ttc_kind_of(model->graph, state->low) != TTC_NUMBER || ttc_kind_of(model->graph, state->high) != TTC_NUMBER);
}

/* Where nothing else is claimed, only a claim of its own tells that conditions on the domain contradict each other. */
static bool is_domain_alone(const ttc_model *model)
{
    bool has_conditions = model->region_count > 0;
    for (size_t i = 0; i < model->state_count; i++)
        has_conditions |= is_between_expressions(model, &model->symbols[model->states[i]]);
    return has_conditions && model->claim_count + record_count(model) == 0;
}

size_t ttc_derived_count(const ttc_model *model) { return record_count(model) + is_domain_alone(model); }

void ttc_derived_claim_get(const ttc_model *model, size_t index, ttc_derived_claim *derived)
{
    *derived = (ttc_derived_claim){ .claim = { .kind = TTC_CLAIM_EQUAL }, .role = TTC_DIVIDES_FIELD };
    if (index < root_count(model)) {
        uint32_t symbol = root_at(model, index);
        derived->kind = model->symbols[symbol].kind == TTC_LOG ? "log" : "root";
        derived->name = model->symbols[symbol].name;
        derived->claim.place = model->symbols[symbol].place;
        derived->claim.family = symbol;
        derived->tested_root = symbol;
        derived->prove = prove_root;
        return;
    }
    if (index == record_count(model)) {
        derived->kind = "domain";
        derived->name = model->name;
        derived->claim.place = model->region_count > 0 ? model->regions[0].place : model->symbols[model->states[0]].place;
        derived->prove = prove_nothing;
        return;
    }
    index -= root_count(model);
    if (index < model->variant_count) {
        derived->kind = "variant";
        derived->name = model->variants[index].name;
        derived->claim.place = model->variants[index].place;
        derived->claim.when = model->variants[index].bindings;
        derived->prove = prove_variant;
        derived->role = TTC_DIVIDES_VARIANT;
        derived->tests_conditions = true;
    } else if ((index -= model->variant_count) < model->time_count) {
        derived->kind = "time";
        derived->name = model->times[index].name;
        derived->claim.place = model->times[index].place;
        derived->claim.expression = model->times[index].factor;
        derived->prove = prove_time;
        derived->role = TTC_DIVIDES_TIME;
    } else if ((index -= model->time_count) >= model->elimination_count + model->pole_count) {
        ttc_observed record;
        index -= model->elimination_count + model->pole_count;
        ttc_observed_get(model, index, &record);
        derived->kind = record.kind;
        derived->name = record.name;
        derived->claim.place = record.place;
        derived->prove = ttc_prove_observed;
    } else if (index >= model->elimination_count) {
        index -= model->elimination_count;
        derived->kind = "pole";
        derived->name = model->symbols[model->poles[index].state].name;
        derived->claim.place = model->poles[index].place;
        derived->prove = ttc_prove_pole;
    } else {
        const ttc_elimination *elimination = &model->eliminations[index];
        derived->kind = "eliminate";
        derived->name = elimination->name;
        derived->claim.place = elimination->place;
        derived->substitution = (ttc_binding){ elimination->state, elimination->solution, elimination->place };
        derived->claim.when = (ttc_bindings){ &derived->substitution, 1 };
        derived->prove = prove_elimination;
        derived->divisor = elimination->slope;
    }
    derived->claim.family = (uint32_t)index;
}
