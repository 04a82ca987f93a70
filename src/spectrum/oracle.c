#include "spectrum/oracle.h"

#include "fields/coefficients.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static uint32_t *symbols_of(const ttc_model *model, const jlt_quantity *quantities, size_t count)
{
    uint32_t *symbols = calloc(count + 1, sizeof *symbols);

    for (size_t i = 0; symbols != NULL && i < count; i++)
        if (!ttc_model_find_symbol(model, quantities[i].name, &symbols[i])) {
            free(symbols);
            symbols = NULL;
        }
    return symbols;
}

static jlt_status differentiate(jlt_oracle *o)
{
    const size_t n = o->model->state_count;

    const size_t slopes = o->model->claim_count * n;

    o->field = calloc(n + 1, sizeof *o->field);
    o->jacobian = calloc(n * n + 1, sizeof *o->jacobian);
    o->gradients = calloc(slopes + 1, sizeof *o->gradients);
    o->charpoly = calloc(slopes + o->model->claim_count + 1, sizeof *o->charpoly);
    if (o->field == NULL || o->jacobian == NULL || o->gradients == NULL || o->charpoly == NULL) return JLT_ERR_NOMEM;
    for (size_t i = 0; i < slopes; i++) o->gradients[i] = TTC_NONE;
    for (size_t i = 0; i < slopes + o->model->claim_count; i++) o->charpoly[i] = TTC_NONE;
    o->trace = ttc_integer(o->model->graph, 0);
    for (size_t i = 0; i < n; i++) {
        o->field[i] = ttc_model_field(o->model, i);
        for (size_t j = 0; j < n; j++)
            o->jacobian[i * n + j] = ttc_model_partial(o->model, o->field[i], o->model->states[j]);
        o->trace = ttc_add(o->model->graph, o->trace, o->jacobian[i * n + i]);
    }
    return o->trace == TTC_NONE ? JLT_ERR_NOMEM : JLT_OK;
}

static jlt_status read_defaults(jlt_oracle *o)
{
    const size_t count = o->descriptor->param_count;

    o->defaults = calloc(count + 1, sizeof *o->defaults);
    if (o->defaults == NULL) return JLT_ERR_NOMEM;
    for (size_t i = 0; i < count; i++) {
        const ttc_id written = o->model->symbols[o->params[i]].value;
        if (written != TTC_NONE && (o->defaults[i] = ttc_ball_exact_text(o->ball, written)) == NULL) return JLT_ERR_NOMEM;
    }
    return JLT_OK;
}

jlt_status jlt_oracle_create(jlt_oracle **oracle, const jlt_descriptor *descriptor, const char *file)
{
    JLT_OWNED(jlt_oracle) *self = calloc(1, sizeof *self);
    char built_in[256];

    *oracle = NULL;
    if (self == NULL) return JLT_ERR_NOMEM;
    self->descriptor = descriptor;
    snprintf(built_in, sizeof built_in, "%s.tt", descriptor->model);
    self->model = ttc_model_again(descriptor->table, file != NULL ? file : built_in);
    if (self->model == NULL || self->model->state_count != descriptor->state_count) return JLT_ERR_UNSUPPORTED;
    self->ball = ttc_ball_create(self->model);
    self->states = symbols_of(self->model, descriptor->states, descriptor->state_count);
    self->params = symbols_of(self->model, descriptor->params, descriptor->param_count);
    if (self->ball == NULL || self->states == NULL || self->params == NULL) return JLT_ERR_NOMEM;
    JLT_PASS(read_defaults(self));
    JLT_PASS(differentiate(self));
    *oracle = self;
    self = NULL; /* ownership moved to the caller */
    return JLT_OK;
}

void jlt_oracle_destroy(jlt_oracle *oracle)
{
    if (oracle == NULL) return;
    ttc_ball_destroy(oracle->ball);
    ttc_model_destroy(oracle->model);
    free(oracle->states);
    free(oracle->params);
    for (size_t i = 0; oracle->defaults != NULL && i < oracle->descriptor->param_count; i++) free(oracle->defaults[i]);
    free(oracle->defaults);
    free(oracle->field);
    free(oracle->jacobian);
    free(oracle->gradients);
    free(oracle->charpoly);
    free(oracle);
}

static void set(jlt_oracle *o, const uint32_t *symbols, const double *values, size_t count, const char *const *exact)
{
    for (size_t i = 0; i < count; i++)
        if (exact == NULL || exact[i] == NULL || !ttc_ball_set_fraction(o->ball, symbols[i], exact[i]))
            (void)ttc_ball_set(o->ball, symbols[i], values[i]);
}

void jlt_oracle_set_params(jlt_oracle *oracle, const double *params, const char *const *exact)
{
    set(oracle, oracle->params, params, oracle->descriptor->param_count, exact);
}

void jlt_oracle_set_states(jlt_oracle *oracle, const double *x, const char *const *exact)
{
    set(oracle, oracle->states, x, oracle->descriptor->state_count, exact);
}

jlt_status jlt_oracle_enclose(jlt_oracle *oracle, ttc_enclosure *out, const ttc_id *ids, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!ttc_ball_enclose(&out[i], oracle->ball, ids[i])) return JLT_ERR_DOMAIN;
    return JLT_OK;
}

jlt_status jlt_oracle_estimate(jlt_oracle *oracle, ttc_enclosure *out, const ttc_id *ids, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!ttc_ball_estimate(&out[i], oracle->ball, ids[i])) return JLT_ERR_DOMAIN;
    return JLT_OK;
}

const ttc_id *jlt_oracle_gradient(jlt_oracle *oracle, const char *integral)
{
    const ttc_model *model = oracle->model;
    const size_t n = model->state_count;
    uint32_t claim = 0;

    if (!ttc_model_find_claim(model, integral, &claim)) return NULL;
    ttc_id *gradient = &oracle->gradients[claim * n];
    for (size_t j = 0; j < n; j++)
        if (gradient[j] == TTC_NONE) gradient[j] = ttc_model_partial(model, model->claims[claim].expression, model->states[j]);
    return gradient;
}

jlt_status jlt_oracle_gradient_errors(jlt_oracle *oracle, double *errors, const double *gradients,
                                      const jlt_named *integrals, size_t count)
{
    const size_t n = oracle->model->state_count;

    for (size_t k = 0; k < count; k++) {
        const ttc_id *gradient = jlt_oracle_gradient(oracle, integrals[k].name);
        if (gradient == NULL) return JLT_ERR_UNSUPPORTED;
        for (size_t j = 0; j < n; j++) {
            ttc_enclosure exact;
            if (!ttc_ball_enclose(&exact, oracle->ball, gradient[j])) return JLT_ERR_DOMAIN;
            errors[k * n + j] = jlt_oracle_error(gradients[k * n + j], &exact);
            if (!isfinite(errors[k * n + j])) return JLT_ERR_NONFINITE;
        }
    }
    return JLT_OK;
}

const ttc_id *jlt_oracle_charpoly(jlt_oracle *oracle, size_t claim)
{
    const ttc_model *model = oracle->model;
    const size_t n = model->state_count;
    ttc_id *const c = oracle->charpoly + claim * (n + 1);
    uint32_t lambda = 0;

    if (c[0] != TTC_NONE) return c;
    while (model->symbols[lambda].kind != TTC_LAMBDA) lambda++;
    if (!ttc_polynomial_coefficients(model->graph, c, n, ttc_model_expand(model, model->claims[claim].expression), lambda))
        return NULL;
    for (size_t k = n + 1; k-- > 0;) c[k] = ttc_divide(model->graph, c[k], c[0]);
    return c;
}

double jlt_oracle_error(double computed, const ttc_enclosure *enclosure)
{
    const double error = fabs((computed - enclosure->value) - enclosure->rest) + enclosure->radius;
    return error * (1.0 + 0x1p-50);
}
