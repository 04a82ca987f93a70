#include "kernel/observed.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "kernel/batch_isa.h"
#include "kernel/descriptor.h"

struct jlt_observed {
    jlt_instance *general;
    bool scaled;                   /* some exponent is not 0, so states need conversion */
    const jlt_kernel_batch *batch; /* of the conditions, for states that need none; NULL: there are no such kernels */
    double *spread;                /* prepared values, in every lane */
    int *exponents;                /* (states,): state i in the table's units is 2^exponents[i] times the caller's */
};

jlt_status jlt_observed_create(jlt_observed **observed, const jlt_descriptor *of, const double *params, const jlt_units *units)
{
    JLT_OWNED(jlt_observed) *self = NULL;

    *observed = NULL;
    if (of == NULL) return JLT_ERR_ARG;
    const jlt_descriptor *general = jlt_descriptor_sibling(of, NULL, of->time, NULL);
    if (general == NULL || general->valid_count > JLT_OBSERVED_CONDITIONS_MAX || of->state_count > JLT_OBSERVED_STATES_MAX)
        return JLT_ERR_UNSUPPORTED;
    self = calloc(1, sizeof *self);
    if (self == NULL) return JLT_ERR_NOMEM;
    self->exponents = calloc(of->state_count, sizeof *self->exponents);
    if (self->exponents == NULL) return JLT_ERR_NOMEM;
    JLT_PASS(jlt_instance_create(&self->general, general, params));
    for (unsigned i = 0; i < of->state_count; i++) {
        self->exponents[i] = jlt_units_exponent(units, of->states[i].unit);
        self->scaled |= self->exponents[i] != 0;
    }
    self->batch = self->scaled || general->valid_count == 0 ? NULL : jlt_batch_isa_best(general, 0);
    if (self->batch != NULL && self->batch->valid_values == NULL) self->batch = NULL;
    if (self->batch != NULL && self->batch->prepared > 0) {
        self->spread = jlt_batch_isa_spread(self->batch, self->general->prepared);
        if (self->spread == NULL) return JLT_ERR_NOMEM;
    }
    *observed = self;
    self = NULL; /* ownership moved to the caller */
    return JLT_OK;
}

void jlt_observed_destroy(jlt_observed *observed)
{
    if (observed == NULL) return;
    jlt_instance_destroy(observed->general);
    free(observed->spread);
    free(observed->exponents);
    free(observed);
}

unsigned jlt_observed_count(const jlt_observed *observed) { return observed->general->descriptor->observe_count; }

const jlt_quantity *jlt_observed_quantities(const jlt_observed *observed) { return observed->general->descriptor->observes; }

unsigned jlt_observed_conditions(const jlt_observed *observed)
{
    return observed != NULL ? observed->general->descriptor->valid_count : 0;
}

const char *jlt_observed_condition(const jlt_observed *observed, unsigned condition)
{
    const jlt_descriptor *d = observed->general->descriptor;
    if (d->valid_count == 1) condition = 0;
    return condition < d->valid_count ? d->valids[condition].name : "valid";
}

/* Convert the state to the table's units, in which the quantities are computed whatever unit they declare. */
static const double *in_table(const jlt_observed *self, double *room, const double *x)
{
    if (!self->scaled) return x;
    for (unsigned i = 0; i < self->general->descriptor->state_count; i++) room[i] = ldexp(x[i], self->exponents[i]);
    return room;
}

void jlt_observed_values(const jlt_observed *observed, double *values, const double *x)
{
    const jlt_instance *general = observed->general;
    double room[JLT_OBSERVED_STATES_MAX];

    if (general->descriptor->observe_count == 0) return;
    general->descriptor->observe_values.call(in_table(observed, room, x), general->prepared, values);
}

double jlt_observed_least(const jlt_observed *observed, unsigned *condition, const double *x)
{
    const jlt_descriptor *d = observed->general->descriptor;
    double values[JLT_OBSERVED_CONDITIONS_MAX], room[JLT_OBSERVED_STATES_MAX], least = INFINITY;

    if (d->valid_count == 0) return least;
    d->valid_values.call(in_table(observed, room, x), observed->general->prepared, values);
    unsigned of = d->valid_count;
    for (unsigned i = 0; i < d->valid_count; i++)
        if (values[i] < least) {
            least = values[i];
            of = i;
        }
    for (unsigned i = 0; i < d->valid_count && least > 0; i++)
        if (isnan(values[i])) {
            least = NAN;
            of = i;
        }
    if (condition != NULL && of < d->valid_count) *condition = of;
    return least;
}

const jlt_kernel_batch *jlt_observed_lanes(const jlt_observed *observed, const double **p, const int **exponents, unsigned lanes)
{
    const jlt_kernel_batch *kernels = jlt_batch_isa_best(observed->general->descriptor, lanes);

    *p = observed->general->prepared;
    *exponents = observed->scaled ? observed->exponents : NULL;
    return kernels != NULL && kernels->lanes == lanes && kernels->valid_values != NULL ? kernels : NULL;
}

double jlt_observed_condition_value(void *condition, const double *x)
{
    const jlt_observed_one *one = condition;
    const jlt_instance *general = one->observed->general;
    double values[JLT_OBSERVED_CONDITIONS_MAX], room[JLT_OBSERVED_STATES_MAX];

    general->descriptor->valid_values.call(in_table(one->observed, room, x), general->prepared, values);
    return values[one->index];
}

void jlt_observed_condition_values(void *condition, double *out, const double *x)
{
    enum { COUNT = 8 };
    const jlt_observed_one *one = condition;
    const jlt_observed *observed = one->observed;
    const unsigned states = observed->general->descriptor->state_count;
    _Alignas(64) double values[JLT_OBSERVED_CONDITIONS_MAX * COUNT];
    double of[JLT_OBSERVED_STATES_MAX];

    if (observed->batch != NULL) {
        for (unsigned k = 0; k < COUNT; k += observed->batch->lanes)
            observed->batch->valid_values(x + k, observed->spread, values + k, COUNT);
        memcpy(out, values + one->index * COUNT, COUNT * sizeof *out);
        return;
    }
    for (unsigned k = 0; k < COUNT; k++) {
        for (unsigned i = 0; i < states; i++) of[i] = x[i * COUNT + k];
        out[k] = jlt_observed_condition_value(condition, of);
    }
}
