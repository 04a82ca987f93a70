#include "validated/formulas.h"

#include "core/memory.h"
#include "kernels/watched.h"
#include "optimize/lower.h"

#include <limits.h>
#include <string.h>

/* The derivative by a state or a free parameter, in the field's symbols. */
static ttc_id partial(const jlt_formulas *self, ttc_field *field, ttc_id expression, unsigned column)
{
    const uint32_t by = column < self->states ? self->model->states[column]
                                                : self->model->params[self->free[column - self->states]];
    const ttc_id slope = ttc_model_partial(self->model, expression, by);

    return slope == TTC_NONE ? TTC_NONE : ttc_field_specialise(field, slope);
}

static ttc_id rate_of(const jlt_formulas *self, const ttc_field *field, unsigned i)
{
    return self->lifted_count > 0 && i + 1 == self->states ? field->factor : field->rhs[i];
}

static ttc_id slope_of(const jlt_formulas *self, ttc_field *field, unsigned i, unsigned k)
{
    if (self->lifted_count == 0) return partial(self, field, ttc_model_field(self->model, i), k);
    return k + 1 == self->states ? ttc_integer(field->graph, 0) : ttc_field_partial(field, rate_of(self, field, i), k);
}

static ttc_program *lower(ttc_field *field, const ttc_id *ids, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (ids[i] == TTC_NONE) return NULL;
    return ttc_lower(field, ids, count, (ttc_lowering){ .share = true });
}

/* The value with lifted roots divided out: these are positive at every finite time. */
static ttc_id without_lifted(const ttc_field *field, ttc_id value)
{
    ttc_graph *graph = field->graph;
    ttc_id rest = value;

    for (size_t i = 0; i < ttc_field_lifted_count(field); i++) {
        const ttc_id root = field->symbols[field->time->lifted[i]].node;
        if (rest == root) return ttc_integer(graph, 1);
        if (rest == TTC_NONE || ttc_kind_of(graph, rest) != TTC_PRODUCT) continue;
        for (size_t k = 0; k < ttc_part_count(graph, value); k++) {
            const ttc_part part = ttc_part_at(graph, value, k);
            if (part.id == root) rest = ttc_multiply(graph, rest, ttc_power(graph, root, -part.exponent));
        }
    }
    return rest;
}

static bool is_lifted(const ttc_field *field, uint32_t symbol)
{
    for (size_t i = 0; i < ttc_field_lifted_count(field); i++)
        if (field->time->lifted[i] == symbol) return true;
    return false;
}

/* Whether the state's distance from this end is left out of the domain's conditions. */
static bool is_left_out(const jlt_formulas *self, const ttc_field *field, uint32_t state, bool is_high)
{
    const ttc_symbol_entry *entry = &self->model->symbols[state];

    return self->lifted_count > 0 && state == self->model->states[self->pole]
           && !ttc_end_is_condition(self->model, field->time, NULL, state, is_high ? entry->high : entry->low);
}

/* Collect records `domain` and distances from the ends of intervals. Returns their number. */
static unsigned add_region(const jlt_formulas *self, ttc_field *field, ttc_id *ids)
{
    const ttc_model *model = self->model;
    unsigned count = 0;

    for (size_t i = 0; i < model->region_count; i++, count++)
        if (ids != NULL) ids[count] = without_lifted(field, ttc_field_specialise(field, model->regions[i].expression));
    for (size_t i = 0; i < 2 * model->state_count; i++) {
        const ttc_id inside = ttc_model_inside(model, model->states[i / 2], i % 2 == 1);
        if (inside == TTC_NONE || is_left_out(self, field, model->states[i / 2], i % 2 == 1)) continue;
        if (ids != NULL) ids[count] = without_lifted(field, ttc_field_specialise(field, inside));
        count++;
    }
    return count;
}

/* Collect the quantities that are positive in the domain: records `domain`, distances from the ends of intervals, radicands of
 * roots, arguments of logarithms, and squares of the divisors of these and of the field. Returns their number, UINT_MAX if memory
 * is out; they are built only if ids is not NULL. */
static unsigned add_domain(const jlt_formulas *self, ttc_field *field, ttc_id *ids)
{
    const ttc_model *model = self->model;
    unsigned count = add_region(self, field, ids);
    JLT_FREED unsigned char *used = ttc_model_uses(model);

    if (used == NULL) return UINT_MAX;
    for (size_t i = 0; i < model->symbol_count; i++) {
        if (model->symbols[i].kind != TTC_ROOT && model->symbols[i].kind != TTC_LOG) continue;
        if (is_lifted(field, (uint32_t)i)) continue;
        if (ids != NULL) ids[count] = ttc_field_specialise(field, model->symbols[i].definition);
        used[i] = 1;
        count++;
    }
    ttc_model_close_uses(model, used);
    for (size_t i = 0; i < model->divisor_count; i++) {
        const ttc_divisor *d = &model->divisors[i];
        if (d->role != TTC_DIVIDES_FIELD && !(d->role == TTC_DIVIDES_SYMBOL && used[d->owner])) continue;
        if (ids != NULL) {
            const ttc_id rest = without_lifted(field, ttc_field_specialise(field, d->divisor));
            ids[count] = ttc_multiply(model->graph, rest, rest);
        }
        count++;
    }
    return count;
}

static ttc_program *make_variation(const jlt_formulas *self, ttc_field *field)
{
    const unsigned n = self->states, count = jlt_formulas_radicand(self, self->lifted_count);
    JLT_FREED ttc_id *ids = calloc(count, sizeof *ids);
    ttc_id *divergence = NULL;
    ttc_program *program = NULL;

    if (ids == NULL) return NULL;
    for (unsigned i = 0; i < n; i++) ids[i] = rate_of(self, field, i);
    divergence = &ids[jlt_formulas_divergence(self)];
    *divergence = ttc_integer(field->graph, 0);
    for (unsigned i = 0; i < n; i++) {
        for (unsigned k = 0; k < self->dim; k++)
            ids[jlt_formulas_slope(self, i, k)] = slope_of(self, field, i, k);
        if (*divergence != TTC_NONE && ids[jlt_formulas_slope(self, i, i)] != TTC_NONE)
            *divergence = ttc_add(field->graph, *divergence, ids[jlt_formulas_slope(self, i, i)]);
    }
    for (unsigned i = 0; i < self->valid_count; i++)
        ids[jlt_formulas_valid(self, i)] = ttc_field_specialise(field, self->model->validities[i].expression);
    add_domain(self, field, ids + jlt_formulas_domain(self, 0));
    for (unsigned i = 0; i < self->lifted_count; i++)
        ids[jlt_formulas_radicand(self, i)] =
            ttc_field_specialise(field, self->model->symbols[field->time->lifted[i]].definition);
    program = lower(field, ids, count);
    return program;
}

static jlt_status make_levels(jlt_formulas *self, ttc_field *field, const char *const *levels)
{
    ttc_id ids[JLT_FORMULAS_LEVELS_MAX * (1 + 256)];
    const unsigned m = self->level_count;

    if (self->dim > 256) return JLT_ERR_ARG;
    for (unsigned i = 0; i < m; i++) {
        uint32_t claim;
        if (!ttc_model_find_claim(self->model, levels[i], &claim) || self->model->claims[claim].kind != TTC_CLAIM_INTEGRAL)
            return JLT_ERR_UNSUPPORTED;
        ids[i] = ttc_field_specialise(field, self->model->claims[claim].expression);
        for (unsigned k = 0; k < self->dim; k++)
            ids[m + i * self->dim + k] = partial(self, field, self->model->claims[claim].expression, k);
    }
    self->levels = lower(field, ids, m * (1 + self->dim));
    return self->levels == NULL ? JLT_ERR_NOMEM : JLT_OK;
}

static const ttc_time *time_of(const ttc_model *model, const char *name)
{
    for (size_t i = 0; i < model->time_count; i++)
        if (strcmp(model->times[i].name, name) == 0 && model->times[i].lifted_count > 0) return &model->times[i];
    return NULL;
}

/* time: NULL for the table's own; then pole has no meaning. */
static jlt_status create(jlt_formulas **formulas, const jlt_descriptor *descriptor, const char *time, unsigned pole,
                         const unsigned *free_params, unsigned free_count, const char *const *levels, unsigned level_count)
{
    jlt_formulas *self = calloc(1, sizeof *self);
    const ttc_time *lifting = NULL;
    ttc_field *field = NULL;
    JLT_FREED ttc_id *rates = NULL;
    jlt_status st = JLT_ERR_NOMEM;

    *formulas = NULL;
    if (self == NULL) goto done;
    st = JLT_ERR_ARG;
    if (free_count > JLT_FORMULAS_FREE_MAX || level_count > JLT_FORMULAS_LEVELS_MAX) goto done;
    st = JLT_ERR_UNSUPPORTED;
    self->model = ttc_model_again(descriptor->table, descriptor->model);
    if (self->model == NULL || self->model->state_count != descriptor->state_count
        || self->model->param_count != descriptor->param_count)
        goto done;
    if (time != NULL) lifting = time_of(self->model, time);
    if ((time != NULL && lifting == NULL) || ttc_field_create(&field, self->model, NULL, lifting, NULL) != TTC_FIELD_OK) goto done;
    self->lifted_count = (unsigned)ttc_field_lifted_count(field);
    self->states = (unsigned)field->state_count + (self->lifted_count > 0);
    self->pole = pole;
    self->params = descriptor->param_count;
    self->free_count = free_count;
    for (unsigned i = 0; i < free_count; i++) self->free[i] = free_params[i];
    self->dim = self->states + free_count;
    self->valid_count = (unsigned)self->model->validity_count;
    self->domain_count = add_domain(self, field, NULL);
    st = JLT_ERR_NOMEM;
    rates = calloc(self->states, sizeof *rates);
    if (self->domain_count == UINT_MAX || rates == NULL) goto done;
    for (unsigned i = 0; i < self->states; i++) rates[i] = rate_of(self, field, i);
    self->level_count = level_count;
    self->motion = lower(field, rates, self->states);
    self->variation = make_variation(self, field);
    st = self->motion == NULL || self->variation == NULL ? JLT_ERR_NOMEM : make_levels(self, field, levels);
    if (st != JLT_OK) goto done;
    *formulas = self;
    self = NULL; /* ownership moved to the caller */
done:
    ttc_field_destroy(field);
    jlt_formulas_destroy(self);
    return st;
}

jlt_status jlt_formulas_create(jlt_formulas **formulas, const jlt_descriptor *descriptor, const unsigned *free, unsigned free_count,
                               const char *const *levels, unsigned level_count)
{
    return create(formulas, descriptor, NULL, 0, free, free_count, levels, level_count);
}

jlt_status jlt_formulas_create_lifted(jlt_formulas **formulas, const jlt_descriptor *descriptor, const char *time,
                                      unsigned pole)
{
    return create(formulas, descriptor, time, pole, NULL, 0, NULL, 0);
}

void jlt_formulas_destroy(jlt_formulas *formulas)
{
    if (formulas == NULL) return;
    ttc_program_destroy(formulas->motion);
    ttc_program_destroy(formulas->variation);
    ttc_program_destroy(formulas->levels);
    ttc_model_destroy(formulas->model);
    free(formulas);
}

unsigned jlt_formulas_slope(const jlt_formulas *self, unsigned row, unsigned column)
{
    return self->states + row * self->dim + column;
}

unsigned jlt_formulas_divergence(const jlt_formulas *self)
{
    return self->states * (1 + self->dim);
}

unsigned jlt_formulas_valid(const jlt_formulas *self, unsigned index)
{
    return self->states * (1 + self->dim) + 1 + index;
}

unsigned jlt_formulas_domain(const jlt_formulas *self, unsigned index)
{
    return jlt_formulas_valid(self, self->valid_count) + index;
}

unsigned jlt_formulas_radicand(const jlt_formulas *self, unsigned index)
{
    return jlt_formulas_domain(self, self->domain_count) + index;
}
