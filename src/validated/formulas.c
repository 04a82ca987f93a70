#include "validated/formulas.h"

#include "optimize/lower.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* The derivative by a state or a free parameter, in the field's symbols. */
static ttc_id partial(const jlt_formulas *self, ttc_field *field, ttc_id expression, unsigned column)
{
    const uint32_t by = column < self->states ? self->model->states[column]
                                                : self->model->params[self->free[column - self->states]];
    const ttc_id slope = ttc_model_partial(self->model, expression, by);

    return slope == TTC_NONE ? TTC_NONE : ttc_field_specialise(field, slope);
}

static ttc_program *lower(ttc_field *field, const ttc_id *ids, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (ids[i] == TTC_NONE) return NULL;
    return ttc_lower(field, ids, count, (ttc_lowering){ .share = true });
}

/* Collect the quantities that are positive in the domain: records `domain`, distances from the ends of intervals, radicands of
 * roots, arguments of logarithms, and squares of the divisors of these and of the field. Returns their number, UINT_MAX if memory
 * is out; they are built only if ids is not NULL. */
static unsigned add_domain(const jlt_formulas *self, ttc_field *field, ttc_id *ids)
{
    const ttc_model *model = self->model;
    unsigned char *used = ttc_model_uses(model);
    unsigned count = 0;

    if (used == NULL) return UINT_MAX;

    for (size_t i = 0; i < model->region_count; i++, count++)
        if (ids != NULL) ids[count] = ttc_field_specialise(field, model->regions[i].expression);
    for (size_t i = 0; i < 2 * model->state_count; i++) {
        const ttc_id inside = ttc_model_inside(model, model->states[i / 2], i % 2 == 1);
        if (inside == TTC_NONE) continue;
        if (ids != NULL) ids[count] = ttc_field_specialise(field, inside);
        count++;
    }
    for (size_t i = 0; i < model->symbol_count; i++) {
        if (model->symbols[i].kind != TTC_ROOT && model->symbols[i].kind != TTC_LOG) continue;
        if (ids != NULL) ids[count] = ttc_field_specialise(field, model->symbols[i].definition);
        used[i] = 1;
        count++;
    }
    ttc_model_close_uses(model, used);
    for (size_t i = 0; i < model->divisor_count; i++) {
        const ttc_divisor *d = &model->divisors[i];
        if (d->role != TTC_DIVIDES_FIELD && !(d->role == TTC_DIVIDES_SYMBOL && used[d->owner])) continue;
        if (ids != NULL) ids[count] = ttc_field_specialise(field, ttc_multiply(model->graph, d->divisor, d->divisor));
        count++;
    }
    free(used);
    return count;
}

static ttc_program *make_variation(const jlt_formulas *self, ttc_field *field)
{
    const unsigned n = self->states, count = jlt_formulas_domain(self, self->domain_count);
    ttc_id *ids = calloc(count, sizeof *ids), *divergence = NULL;
    ttc_program *program = NULL;

    if (ids == NULL) return NULL;
    memcpy(ids, field->rhs, n * sizeof *ids);
    divergence = &ids[jlt_formulas_divergence(self)];
    *divergence = ttc_integer(field->graph, 0);
    for (unsigned i = 0; i < n; i++) {
        for (unsigned k = 0; k < self->dim; k++)
            ids[jlt_formulas_slope(self, i, k)] = partial(self, field, ttc_model_field(self->model, i), k);
        if (*divergence != TTC_NONE && ids[jlt_formulas_slope(self, i, i)] != TTC_NONE)
            *divergence = ttc_add(field->graph, *divergence, ids[jlt_formulas_slope(self, i, i)]);
    }
    for (unsigned i = 0; i < self->valid_count; i++)
        ids[jlt_formulas_valid(self, i)] = ttc_field_specialise(field, self->model->validities[i].expression);
    add_domain(self, field, ids + jlt_formulas_domain(self, 0));
    program = lower(field, ids, count);
    free(ids);
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

jlt_status jlt_formulas_create(jlt_formulas **formulas, const jlt_descriptor *descriptor, const unsigned *free, unsigned free_count,
                               const char *const *levels, unsigned level_count)
{
    jlt_formulas *self = calloc(1, sizeof *self);
    ttc_field *field = NULL;
    jlt_status st = JLT_ERR_NOMEM;

    *formulas = NULL;
    if (self == NULL) goto done;
    st = JLT_ERR_ARG;
    if (free_count > JLT_FORMULAS_FREE_MAX || level_count > JLT_FORMULAS_LEVELS_MAX) goto done;
    st = JLT_ERR_UNSUPPORTED;
    self->descriptor = descriptor;
    self->model = ttc_model_again(descriptor->table, descriptor->model);
    if (self->model == NULL || self->model->state_count != descriptor->state_count
        || self->model->param_count != descriptor->param_count
        || ttc_field_create(&field, self->model, NULL, NULL, NULL) != TTC_FIELD_OK)
        goto done;
    self->states = descriptor->state_count;
    self->params = descriptor->param_count;
    self->free_count = free_count;
    for (unsigned i = 0; i < free_count; i++) self->free[i] = free[i];
    self->dim = self->states + free_count;
    self->valid_count = (unsigned)self->model->validity_count;
    self->domain_count = add_domain(self, field, NULL);
    if (self->domain_count == UINT_MAX) {
        st = JLT_ERR_NOMEM;
        goto done;
    }
    self->level_count = level_count;
    self->motion = lower(field, field->rhs, self->states);
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
