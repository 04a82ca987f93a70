#include "dynamics/varied.h"

#include <stdlib.h>
#include <string.h>

#include "integrate/batch.h"
#include "integrate/gauss_batch.h"
#include "kernel/batch_isa.h"

void jlt_varied_linear(const jlt_varied *self, const double *x, double *both)
{
    const jlt_field *plain = self->plain;

    if (self->rhs_jacobian != NULL) {
        self->rhs_jacobian(x, plain->p, both);
        return;
    }
    plain->call(x, plain->p, both);
    plain->jacobian(x, plain->p, both + plain->dim);
}

static void call(const double *restrict x, const double *restrict p, double *restrict out)
{
    const jlt_varied *self = (const jlt_varied *)(const void *)p;
    const unsigned n = self->plain->dim, columns = self->tangents;
    double both[JLT_CHART_STATES_MAX * (1 + JLT_CHART_STATES_MAX)];
    const double *jacobian = both + n;
    double trace = 0;

    jlt_varied_linear(self, x, both);
    memcpy(out, both, n * sizeof *out);
    for (unsigned i = 0; i < n; i++) {
        const double *row = jacobian + i * n;
        unsigned used[JLT_CHART_STATES_MAX], count = 0;
        for (unsigned j = 0; j < n; j++)
            if (row[j] != 0) used[count++] = j;
        for (unsigned k = 0; k < columns; k++) {
            const double *y = x + n * (1 + k);
            double sum = 0;
            for (unsigned j = 0; j < count; j++) sum += row[used[j]] * y[used[j]];
            out[n * (1 + k) + i] = sum;
        }
    }
    for (unsigned i = 0; i < n; i++) trace += jacobian[i * n + i];
    out[n * (1 + columns)] = trace;
}

static void time_rate(const double *restrict x, const double *restrict p, double *restrict out)
{
    const jlt_varied *self = (const jlt_varied *)(const void *)p;

    self->plain->time_rate(x, self->plain->p, out);
}

/* A row has one value for each Gauss node of a step. */
static jlt_varied_batch *instance(const jlt_kernel_batch *kernels)
{
#if defined(JLT_HAVE_X86)
    if (strcmp(kernels->isa, "avx512") == 0) return jlt_varied_batch_avx512;
    if (strcmp(kernels->isa, "avx2") == 0) return jlt_varied_batch_avx2;
#else
    (void)kernels;
#endif
    return jlt_varied_batch_baseline;
}

static void call_on_lanes(const double *restrict x, const double *restrict p, double *restrict out, size_t stride)
{
    const jlt_varied *self = (const jlt_varied *)(const void *)p;
    const jlt_kernel_batch *kernels = self->plain->batch;
    _Alignas(64) double both[JLT_BATCH_STATES_MAX * (1 + JLT_BATCH_STATES_MAX) * JLT_GAUSS_BATCH_NODES];

    kernels->rhs_jacobian(x, self->spread, both, stride);
    self->products(x, both, out, stride, self->plain->dim, self->tangents);
}

static void time_rate_on_lanes(const double *restrict x, const double *restrict p, double *restrict out, size_t stride)
{
    const jlt_varied *self = (const jlt_varied *)(const void *)p;

    self->plain->batch->time_factor(x, self->spread, out, stride);
}

jlt_status jlt_varied_make(jlt_varied *self, const jlt_field *plain, jlt_kernel_function rhs_jacobian, unsigned tangents)
{
    const jlt_kernel_batch *kernels = plain->batch;

    if (plain->jacobian == NULL && rhs_jacobian == NULL) return JLT_ERR_UNSUPPORTED;
    self->plain = plain;
    self->rhs_jacobian = rhs_jacobian;
    self->tangents = tangents;
    self->spread = NULL;
    self->field = (jlt_field){ .dim = plain->dim * (1 + tangents) + 1,
                               .call = call,
                               .p = (const double *)(const void *)self,
                               .time_rate = plain->time_rate != NULL ? time_rate : NULL,
                               .root = -1,
                               .domain = plain->domain,
                               .scale = self->scale,
                               .kept = plain->kept,
                               .groups = plain->groups,
                               .tangents = tangents,
                               .sized = plain->sized };
    if (kernels != NULL && kernels->rhs_jacobian != NULL && plain->dim <= JLT_BATCH_STATES_MAX) {
        self->batch = (jlt_kernel_batch){ .isa = kernels->isa,
                                          .lanes = kernels->lanes,
                                          .rhs = call_on_lanes,
                                          .time_factor = plain->time_rate != NULL ? time_rate_on_lanes : NULL };
        self->products = instance(kernels);
        self->field.batch = &self->batch;
        self->spread = jlt_batch_isa_spread(kernels, plain->p);
        if (self->spread == NULL) return JLT_ERR_NOMEM;
    }
    for (unsigned i = 0; i < self->field.dim; i++) self->scale[i] = 1;
    for (unsigned i = 0; i < plain->dim; i++) self->scale[i] = jlt_field_scale(plain, i);
    return JLT_OK;
}

static bool stays(const jlt_field *plain, const double *x, unsigned i)
{
    return x[i] == 0 && jlt_field_keeps(plain, i);
}

bool jlt_varied_is_kept(const jlt_field *plain, const double *x)
{
    for (unsigned i = 0; i < plain->dim; i++)
        if (stays(plain, x, i) || !(jlt_field_group_size(plain, x, i) > 0)) return true;
    return false;
}

void jlt_varied_begin(jlt_varied *self, const double *x)
{
    const unsigned n = self->plain->dim;

    for (unsigned i = 0; i < n * self->tangents; i++) self->scale[n + i] = stays(self->plain, x, i % n) ? 0 : 1;
}

void jlt_varied_clear(jlt_varied *self)
{
    free(self->spread);
    self->spread = NULL;
}
