/* Makes the kernels of a field: their expressions and programs. */
#include "kernels/kernels.h"

#include "fields/survey.h"

#include <stdlib.h>
#include <string.h>

const char *ttc_kernel_name(ttc_kernel_kind kind)
{
    static const char *const names[] = { "rhs", "jacobian", "rhs_jacobian", "divergence", "integral_values",
                                         "integral_gradients", "measure_values", "measure_divergences", "time_factor",
                                         "eliminated", "observe_values", "valid_values", "domain_values", "domain_gradients" };
    return names[kind];
}

static bool reserve(ttc_kernels *k, ttc_kernel_kind kind, size_t count)
{
    k->kernels[kind].outputs = calloc(count + 1, sizeof(ttc_id));
    return k->kernels[kind].outputs != NULL;
}

static void append(ttc_kernels *k, ttc_kernel_kind kind, ttc_id id)
{
    k->kernels[kind].outputs[k->kernels[kind].count++] = id;
}

/* The model's node: the field does not know a state that no right-hand side uses. */
static ttc_id eliminated_state(const ttc_field *field) { return field->model->symbols[field->elimination->state].node; }

static bool add_field_kernels(ttc_kernels *k)
{
    ttc_field *field = k->field;
    size_t n = field->state_count;
    if (!reserve(k, TTC_KERNEL_RHS, n) || !reserve(k, TTC_KERNEL_JACOBIAN, n * n)
        || !reserve(k, TTC_KERNEL_RHS_JACOBIAN, n + n * n) || !reserve(k, TTC_KERNEL_DIVERGENCE, 1)
        || !reserve(k, TTC_KERNEL_TIME_FACTOR, 1) || !reserve(k, TTC_KERNEL_ELIMINATED, 1))
        return false;
    for (size_t i = 0; i < n; i++) {
        append(k, TTC_KERNEL_RHS, field->rhs[i]);
        append(k, TTC_KERNEL_RHS_JACOBIAN, field->rhs[i]);
    }
    ttc_id trace = ttc_integer(field->graph, 0);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) {
            ttc_id partial = ttc_field_partial(field, field->rhs[i], j);
            append(k, TTC_KERNEL_JACOBIAN, partial);
            append(k, TTC_KERNEL_RHS_JACOBIAN, partial);
            if (i == j) trace = ttc_add(field->graph, trace, partial);
        }
    append(k, TTC_KERNEL_DIVERGENCE, trace);
    if (field->time != NULL) append(k, TTC_KERNEL_TIME_FACTOR, field->factor);
    if (field->elimination != NULL) append(k, TTC_KERNEL_ELIMINATED, ttc_field_specialise(field, eliminated_state(field)));
    return !field->failed && trace != TTC_NONE;
}

/* The same kernels by the gathered right-hand sides: a second start for the optimizer. */
static bool add_gathered(ttc_kernels *k)
{
    static const ttc_kernel_kind kinds[] = { TTC_KERNEL_RHS, TTC_KERNEL_JACOBIAN, TTC_KERNEL_RHS_JACOBIAN, TTC_KERNEL_DIVERGENCE };
    ttc_field *field = k->field;
    size_t n = field->state_count;
    ttc_id *rhs = calloc(n + 1, sizeof *rhs), trace = ttc_integer(field->graph, 0);
    bool ok = rhs != NULL && ttc_field_gather(field, rhs), differs = false;
    for (size_t i = 0; ok && i < n; i++) differs |= rhs[i] != field->rhs[i];
    for (size_t i = 0; ok && differs && i < sizeof kinds / sizeof *kinds; i++) {
        k->kernels[kinds[i]].gathered = calloc(k->kernels[kinds[i]].count + 1, sizeof(ttc_id));
        ok = k->kernels[kinds[i]].gathered != NULL;
    }
    for (size_t i = 0; ok && differs && i < n; i++) {
        k->kernels[TTC_KERNEL_RHS].gathered[i] = k->kernels[TTC_KERNEL_RHS_JACOBIAN].gathered[i] = rhs[i];
        for (size_t j = 0; j < n && ok; j++) {
            ttc_id partial = ttc_field_partial(field, rhs[i], j);
            k->kernels[TTC_KERNEL_JACOBIAN].gathered[i * n + j] = partial;
            k->kernels[TTC_KERNEL_RHS_JACOBIAN].gathered[n + i * n + j] = partial;
            if (i == j) trace = ttc_add(field->graph, trace, partial);
            ok = partial != TTC_NONE && trace != TTC_NONE;
        }
    }
    if (ok && differs) k->kernels[TTC_KERNEL_DIVERGENCE].gathered[0] = trace;
    free(rhs);
    return ok;
}

static uint32_t *claims_of_kind(ttc_kernels *k, ttc_claim_kind kind, size_t *count)
{
    const ttc_model *model = k->field->model;
    uint32_t *list = calloc(model->claim_count + 1, sizeof *list);
    if (list == NULL) return NULL;
    for (uint32_t i = 0; i < model->claim_count; i++) {
        const ttc_claim *claim = model->claims + i;
        bool is_level = k->field->elimination != NULL && k->field->elimination->integral == i;
        bool all = kind == TTC_CLAIM_EQUILIBRIA && k->field->variant == NULL;
        if (claim->kind == kind && !is_level && (all || ttc_field_implies(k->field, claim))) list[(*count)++] = i;
    }
    return list;
}

/* Whether the last expressions have values in the field: a variant may set to zero what they divide by. failed: of the field,
 * before them. */
static bool have_values(ttc_field *field, bool failed)
{
    if (ttc_graph_error(field->graph) != TTC_GRAPH_DIVISION_BY_ZERO) return true;
    ttc_graph_clear_error(field->graph);
    field->failed = failed;
    return false;
}

/* The same of a family and the claims about it. */
static bool has_values(ttc_field *field, uint32_t family)
{
    const bool failed = field->failed;
    ttc_graph_clear_error(field->graph);
    for (size_t i = 0; i < field->model->claim_count; i++) {
        const ttc_claim *claim = field->model->claims + i;
        const bool is_about = claim->kind >= TTC_CLAIM_TRACE && claim->kind <= TTC_CLAIM_LEFT_NULL && claim->family == family;
        if (i != family && !is_about) continue;
        for (size_t j = 0; j < claim->bindings.count; j++) ttc_field_specialise(field, claim->bindings.items[j].expression);
        for (size_t j = 0; j < claim->entry_count; j++) ttc_field_specialise(field, claim->entries[j]);
        if (claim->expression != TTC_NONE) ttc_field_specialise(field, claim->expression);
    }
    return have_values(field, failed);
}

static bool add_integral_kernels(ttc_kernels *k)
{
    ttc_field *field = k->field;
    size_t n = field->state_count;
    k->integrals = claims_of_kind(k, TTC_CLAIM_INTEGRAL, &k->integral_count);
    if (k->integrals == NULL || !reserve(k, TTC_KERNEL_INTEGRAL_VALUES, k->integral_count)
        || !reserve(k, TTC_KERNEL_INTEGRAL_GRADIENTS, k->integral_count * n))
        return false;
    const size_t count = k->integral_count;
    k->integral_count = 0;
    for (size_t i = 0; i < count; i++) {
        const bool failed = field->failed;
        ttc_id value = ttc_field_specialise(field, field->model->claims[k->integrals[i]].expression);
        if (!have_values(field, failed)) continue;
        k->integrals[k->integral_count++] = k->integrals[i];
        append(k, TTC_KERNEL_INTEGRAL_VALUES, value);
        for (size_t j = 0; j < n; j++) append(k, TTC_KERNEL_INTEGRAL_GRADIENTS, ttc_field_partial(field, value, j));
    }
    return !field->failed;
}

/* If rho is a density of f, rho/c is one of c f, and rho/(dI/dz) one on a level I = const, z the eliminated state. A density is
 * none on the larger space of a lifted root, so such fields have no measures. */
static ttc_id density(ttc_kernels *k, uint32_t claim)
{
    ttc_field *field = k->field;
    ttc_id rho = ttc_field_specialise(field, field->model->claims[claim].expression);
    if (rho != TTC_NONE) rho = ttc_field_distribute(field, rho, ttc_power(field->graph, field->factor, -1));
    if (field->elimination == NULL || rho == TTC_NONE) return rho;
    ttc_id integral = field->model->claims[field->elimination->integral].expression;
    ttc_id slope = ttc_field_specialise(field, ttc_model_partial(field->model, integral, field->elimination->state));
    return slope == TTC_NONE ? TTC_NONE : ttc_field_distribute(field, rho, ttc_power(field->graph, slope, -1));
}

/* div(rho f) = rho div f + grad rho . f */
static ttc_id density_divergence(ttc_kernels *k, ttc_id rho)
{
    ttc_field *field = k->field;
    ttc_graph *graph = field->graph;
    ttc_id sum = ttc_multiply(graph, rho, k->kernels[TTC_KERNEL_DIVERGENCE].outputs[0]);
    for (size_t j = 0; j < field->state_count; j++)
        sum = ttc_add(graph, sum, ttc_multiply(graph, ttc_field_partial(field, rho, j), field->rhs[j]));
    return sum;
}

static bool add_measure_kernels(ttc_kernels *k)
{
    k->measures = claims_of_kind(k, TTC_CLAIM_MEASURE, &k->measure_count);
    if (k->measures == NULL) return false;
    if (ttc_field_lifted_count(k->field) > 0) k->measure_count = 0;
    if (!reserve(k, TTC_KERNEL_MEASURE_VALUES, k->measure_count)
        || !reserve(k, TTC_KERNEL_MEASURE_DIVERGENCES, k->measure_count))
        return false;
    const size_t count = k->measure_count;
    k->measure_count = 0;
    for (size_t i = 0; i < count; i++) {
        const bool failed = k->field->failed;
        ttc_id rho = density(k, k->measures[i]);
        if (!have_values(k->field, failed)) continue;
        if (rho == TTC_NONE) return false;
        k->measures[k->measure_count++] = k->measures[i];
        append(k, TTC_KERNEL_MEASURE_VALUES, rho);
        append(k, TTC_KERNEL_MEASURE_DIVERGENCES, density_divergence(k, rho));
    }
    return !k->field->failed;
}

/* Only for the general field: the states of any other give its states. */
static bool add_observed_kernels(ttc_kernels *k)
{
    ttc_field *field = k->field;
    const ttc_model *model = field->model;
    if (field->variant != NULL || field->elimination != NULL) return true;
    if (!reserve(k, TTC_KERNEL_OBSERVE_VALUES, model->observed_count)
        || !reserve(k, TTC_KERNEL_VALID_VALUES, model->validity_count))
        return false;
    for (size_t i = 0; i < model->observed_count; i++)
        append(k, TTC_KERNEL_OBSERVE_VALUES, ttc_field_specialise(field, model->symbols[model->observed[i]].node));
    for (size_t i = 0; i < model->validity_count; i++)
        append(k, TTC_KERNEL_VALID_VALUES, ttc_field_specialise(field, model->validities[i].expression));
    return !field->failed;
}

static bool add_domain_kernels(ttc_kernels *k)
{
    ttc_field *field = k->field;
    if (!ttc_watched_find(&k->watched, &k->watched_count, field) ||
        !reserve(k, TTC_KERNEL_DOMAIN_VALUES, k->watched_count) ||
        !reserve(k, TTC_KERNEL_DOMAIN_GRADIENTS, k->watched_count * field->state_count))
        return false;
    for (size_t i = 0; i < k->watched_count; i++) {
        ttc_id value = ttc_field_specialise(field, k->watched[i].expression);
        append(k, TTC_KERNEL_DOMAIN_VALUES, value);
        for (size_t j = 0; j < field->state_count; j++) append(k, TTC_KERNEL_DOMAIN_GRADIENTS, ttc_field_partial(field, value, j));
    }
    return !field->failed;
}

/* Whether outputs divide by something that may vanish where the field has a value. */
static bool may_divide_by_zero(const ttc_kernels *k, ttc_kernel_kind kind)
{
    ttc_field *field = k->field;
    ttc_survey of_field, here;
    const bool begun = ttc_survey_init(&of_field, field);
    bool may = !ttc_survey_init(&here, field) || !begun;
    for (size_t i = 0; i < field->state_count && !may; i++) ttc_survey_add(&of_field, field->rhs[i]);
    for (size_t i = 0; i < k->kernels[kind].count && !may; i++) ttc_survey_add(&here, k->kernels[kind].outputs[i]);
    for (ttc_id id = 1; id < here.size && !may; id++)
        may = here.denominator[id] && !of_field.denominator[id] && !here.root[id] && !ttc_field_is_constant(field, id)
              && !(ttc_field_extent(field, id).low > 0);
    ttc_survey_clear(&here);
    ttc_survey_clear(&of_field);
    return may;
}

ttc_purpose ttc_kernel_purpose(const ttc_kernels *k, ttc_kernel_kind kind)
{
    if (kind <= TTC_KERNEL_DIVERGENCE) return TTC_FOR_STEPS;
    return k->kernels[kind].count > 1 && may_divide_by_zero(k, kind) ? TTC_FOR_VALUES : TTC_FOR_POINTS;
}

ttc_id *ttc_kernels_jet_outputs(const ttc_kernels *kernels)
{
    size_t n = kernels->field->state_count;
    ttc_id *outputs = malloc((n + 1) * sizeof *outputs);
    if (outputs == NULL) return NULL;
    memcpy(outputs, kernels->field->rhs, n * sizeof *outputs);
    outputs[n] = kernels->field->factor;
    return outputs;
}

static bool build_jet(ttc_kernels *k, ttc_effort effort)
{
    ttc_id *outputs = ttc_kernels_jet_outputs(k);
    if (outputs == NULL) return false;
    k->jet = ttc_optimize(k->field, outputs, NULL, k->field->state_count + (k->field->time != NULL), TTC_FOR_JETS, effort,
                          &k->prepared);
    free(outputs);
    return k->jet != NULL;
}

static bool build_programs(ttc_kernels *k, ttc_effort effort)
{
    k->prepared.field = k->field;
    for (int kind = 0; kind < TTC_KERNEL_KINDS; kind++) {
        ttc_kernel *kernel = k->kernels + kind;
        if (kernel->count == 0) continue;
        for (size_t i = 0; i < kernel->count; i++)
            if (kernel->outputs[i] == TTC_NONE) return false;
        kernel->naive = ttc_lower(k->field, kernel->outputs, kernel->count, (ttc_lowering){ 0 });
        kernel->reference = ttc_lower(k->field, kernel->outputs, kernel->count, (ttc_lowering){ .share = true });
        kernel->optimized = ttc_optimize(k->field, kernel->outputs, kernel->gathered, kernel->count,
                                         ttc_kernel_purpose(k, (ttc_kernel_kind)kind), effort, &k->prepared);
        if (kernel->naive == NULL || kernel->reference == NULL || kernel->optimized == NULL) return false;
    }
    if (!build_jet(k, effort)) return false;
    k->prepare = ttc_lower(k->field, k->prepared.entries, k->prepared.count, (ttc_lowering){ .share = true });
    return k->prepare != NULL && !k->prepared.failed;
}

ttc_kernels *ttc_kernels_create(ttc_field *field, ttc_effort effort)
{
    ttc_kernels *k = calloc(1, sizeof *k);
    if (k == NULL) {
        ttc_field_destroy(field);
        return NULL;
    }
    k->field = field;
    k->effort = effort;
    bool serves_families = field->time == NULL && field->elimination == NULL;
    bool ok = add_field_kernels(k) && add_gathered(k) && add_integral_kernels(k) && add_measure_kernels(k)
              && add_observed_kernels(k) && add_domain_kernels(k);
    if (ok && serves_families) {
        k->families = claims_of_kind(k, TTC_CLAIM_EQUILIBRIA, &k->family_count);
        ok = k->families != NULL;
    }
    if (ok && build_programs(k, effort)) return k;
    ttc_kernels_destroy(k);
    return NULL;
}

void ttc_kernels_keep_families(ttc_kernels *kernels)
{
    const size_t count = kernels->family_count;
    kernels->family_count = 0;
    for (size_t i = 0; i < count; i++)
        if (has_values(kernels->field, kernels->families[i])) kernels->families[kernels->family_count++] = kernels->families[i];
}

void ttc_kernels_destroy(ttc_kernels *kernels)
{
    if (kernels == NULL) return;
    for (int kind = 0; kind < TTC_KERNEL_KINDS; kind++) {
        free(kernels->kernels[kind].outputs);
        free(kernels->kernels[kind].gathered);
        ttc_program_destroy(kernels->kernels[kind].naive);
        ttc_program_destroy(kernels->kernels[kind].reference);
        ttc_program_destroy(kernels->kernels[kind].optimized);
    }
    ttc_program_destroy(kernels->jet);
    ttc_program_destroy(kernels->prepare);
    ttc_prepared_clear(&kernels->prepared);
    free(kernels->integrals);
    free(kernels->measures);
    free(kernels->families);
    ttc_watched_destroy(kernels->watched, kernels->watched_count);
    free(kernels->unproved);
    ttc_field_destroy(kernels->field);
    free(kernels);
}
