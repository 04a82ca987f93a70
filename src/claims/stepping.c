#include "claims/stepping.h"

#include "algebra/derive.h"
#include "claims/check.h"
#include "core/guard.h"
#include "core/memory.h"
#include "kernel/batch_isa.h"
#include "kernel/instance.h"
#include "kernel/kernel.h"

#include <math.h>
#include <string.h>

enum { SIZE = 2 * JLT_SAMPLE_STATES_MAX }; /* with lifted roots */

/* A field in some time at a sample, and its rates: of the states, and of t after them. */
typedef struct {
    const jlt_instance *field;
    const ttc_time *time; /* NULL: the table's own */
    double x[SIZE];
    ttc_enclosure rates[SIZE + 1];
} place;

static const ttc_time *time_named(const ttc_model *model, const char *name)
{
    for (size_t i = 0; i < model->time_count; i++)
        if (strcmp(model->times[i].name, name) == 0) return model->times + i;
    return NULL;
}

/* Enclose the rate in the field's time of what has the rate `plain` in the table's own. */
static jlt_status enclose_rate(place *p, size_t column, jlt_oracle *oracle, ttc_id plain)
{
    const ttc_id rate = p->time == NULL ? plain : ttc_multiply(oracle->model->graph, plain, p->time->factor);

    return jlt_oracle_estimate(oracle, p->rates + column, &rate, 1);
}

static jlt_status enclose(place *p, jlt_oracle *oracle)
{
    const ttc_model *model = oracle->model;
    const size_t n = model->state_count, lifted = p->time == NULL ? 0 : p->time->lifted_count;

    for (size_t i = 0; i < n; i++) JLT_PASS(enclose_rate(p, i, oracle, oracle->field[i]));
    for (size_t i = 0; i < lifted; i++)
        JLT_PASS(enclose_rate(p, n + i, oracle, ttc_derive_field(model, model->symbols[p->time->lifted[i]].node)));
    return enclose_rate(p, n + lifted, oracle, ttc_integer(model->graph, 1));
}

static void compare_jet(jlt_verify_family *f, const place *p)
{
    const jlt_descriptor *d = p->field->descriptor;
    const size_t columns = d->state_count + (p->time != NULL);
    double coefficients[2 * (SIZE + 1)];
    jlt_guard guard;

    if (d->jet == NULL) return;
    jlt_guard_enter(&guard);
    d->jet(p->x, p->field->prepared, 1, coefficients);
    if (jlt_guard_leave(&guard) == JLT_OK)
        jlt_check_enclosures(f, "jets of order 1 in ball enclosures of 256 bits", coefficients + columns, p->rates, columns);
}

/* Compare that lane of one column which is farthest from its enclosure. */
static void compare_lanes(jlt_verify_family *f, const char *name, const double *lanes, size_t row, const ttc_enclosure *exact)
{
    double worst = lanes[0];

    for (size_t k = 1; k < row; k++)
        if (!(jlt_oracle_error(lanes[k], exact) <= jlt_oracle_error(worst, exact))) worst = lanes[k];
    jlt_check_enclosures(f, name, &worst, exact, 1);
}

/* The trace as a sum of rounded entries: terms may cancel in it that a simplified trace does not have. */
static ttc_enclosure trace_in_sum(const jlt_sample *s, size_t n)
{
    ttc_enclosure trace = s->trace;

    for (size_t i = 0; i < n; i++)
        trace.plain_rounding += s->jacobian[i * n + i].plain_rounding +
                                (double)n * jlt_roundoff * fabs(s->jacobian[i * n + i].value);
    return trace;
}

/* Compare one stage, with so many tangent vectors, which are the first unit vectors; with none, of the field and t alone. */
static jlt_status compare_stage(jlt_verify_family *f, const jlt_sample *s, const place *p, unsigned tangents)
{
    static const char name[] = "stages on vectors in ball enclosures of 256 bits";
    static const jlt_stage_sum sum = { .count = 1, .weight = { 1.0 } };
    const jlt_descriptor *d = p->field->descriptor;
    const jlt_kernel_batch *kernels = jlt_batch_isa_best(d, 0);
    if (kernels == NULL || kernels->stages_clock == NULL || kernels->stages_varied == NULL) return JLT_OK;
    const size_t n = d->state_count, row = JLT_BATCH_VECTORS * kernels->lanes, varied = tangents > 0;
    const size_t columns = n * (1 + (size_t)tangents) + 1 + varied, block = kernels->prepared * kernels->lanes;
    JLT_FREED double *x = jlt_memory_array(columns * row, sizeof *x), *k = jlt_memory_array(2 * columns * row, sizeof *k);
    JLT_FREED double *z = jlt_memory_array(columns * row, sizeof *z), *h = jlt_memory_array(row, sizeof *h);
    JLT_FREED double *spread = jlt_batch_isa_spread(kernels, p->field->prepared);
    JLT_FREED double *blocks = jlt_memory_array(JLT_BATCH_VECTORS * block + 1, sizeof *blocks);
    jlt_guard guard;

    if (x == NULL || k == NULL || z == NULL || h == NULL || spread == NULL || blocks == NULL) return JLT_ERR_NOMEM;
    for (size_t v = 0; v < JLT_BATCH_VECTORS; v++) memcpy(blocks + v * block, spread, block * sizeof *spread);
    for (size_t i = 0; i < row; i++) {
        for (size_t j = 0; j < n; j++) x[j * row + i] = p->x[j];
        for (size_t j = 0; j < tangents; j++) x[(n * (1 + j) + j) * row + i] = 1.0;
    }
    jlt_guard_enter(&guard);
    if (varied) kernels->stages_varied(x, k, &sum, 1, h, blocks, z, tangents);
    else kernels->stages_clock(x, k, &sum, 1, h, blocks, z);
    if (jlt_guard_leave(&guard) != JLT_OK) return JLT_OK;
    const double *slopes = k + columns * row;
    for (size_t i = 0; i < n; i++) compare_lanes(f, name, slopes + i * row, row, p->rates + i);
    const ttc_enclosure trace = trace_in_sum(s, varied ? n : 0);
    if (varied) compare_lanes(f, name, slopes + (columns - 2) * row, row, &trace);
    compare_lanes(f, name, slopes + (columns - 1) * row, row, p->rates + n);
    for (size_t j = 0; j < tangents; j++)
        for (size_t i = 0; i < n; i++) compare_lanes(f, name, slopes + (n * (1 + j) + i) * row, row, s->jacobian + i * n + j);
    return JLT_OK;
}

/* The derivative by state number j of what has the rate `plain` in the table's own time, of its rate in the field's time. */
static jlt_status enclose_slope(ttc_enclosure *out, const place *p, jlt_oracle *oracle, ttc_id plain, size_t j)
{
    const ttc_id slope = ttc_derive_state(oracle->model, ttc_multiply(oracle->model->graph, plain, p->time->factor), j);

    return jlt_oracle_estimate(oracle, out, &slope, 1);
}

/* Compare one row of a Jacobian, shape (states,) with lifted roots, along the surface on which they are roots: with (dr/dx)_j for
 * their tangent, shape (lifted, table's states), it gives derivatives by the table's states. */
static jlt_status compare_row(jlt_verify_family *f, const place *p, jlt_oracle *oracle, ttc_id plain, const double *row,
                              const ttc_enclosure *tangents)
{
    static const char name[] = "Jacobians in other times, along the table's states, in ball enclosures of 256 bits";
    const size_t n = oracle->model->state_count, lifted = p->time->lifted_count;

    for (size_t j = 0; j < n; j++) {
        ttc_enclosure exact;
        double sum = row[j], terms = fabs(row[j]), unseen = 0.0;
        JLT_PASS(enclose_slope(&exact, p, oracle, plain, j));
        for (size_t l = 0; l < lifted; l++) {
            const ttc_enclosure *tangent = tangents + l * n + j;
            sum += row[n + l] * tangent->value;
            terms += fabs(row[n + l] * tangent->value);
            unseen += fabs(row[n + l]) * tangent->radius;
        }
        const double rounding = (double)(2 + lifted) * jlt_roundoff * terms + unseen;
        exact.rounding += rounding;
        exact.plain_rounding += rounding;
        jlt_check_enclosures(f, name, &sum, &exact, 1);
    }
    return JLT_OK;
}

static jlt_status compare_jacobians(jlt_verify_family *f, const place *p, jlt_oracle *oracle)
{
    const ttc_model *model = oracle->model;
    const jlt_descriptor *d = p->field->descriptor;
    const size_t n = model->state_count, lifted = p->time->lifted_count, all = n + lifted;
    double alone[SIZE * SIZE], fused[SIZE + SIZE * SIZE];
    ttc_enclosure tangents[SIZE * SIZE];

    if (jlt_instance_jacobian(p->field, alone, p->x) != JLT_OK) return JLT_OK;
    if (jlt_kernel_eval(fused, &d->rhs_jacobian, p->x, all, p->field->prepared) != JLT_OK) return JLT_OK;
    for (size_t l = 0; l < lifted; l++)
        for (size_t j = 0; j < n; j++) {
            const ttc_id slope = ttc_derive_state(model, model->symbols[p->time->lifted[l]].node, j);
            if (jlt_oracle_estimate(oracle, tangents + l * n + j, &slope, 1) != JLT_OK) return JLT_OK;
        }
    for (size_t i = 0; i < all; i++) {
        const ttc_id plain = i < n ? oracle->field[i] : ttc_derive_field(model, model->symbols[p->time->lifted[i - n]].node);
        if (compare_row(f, p, oracle, plain, alone + i * all, tangents) != JLT_OK) return JLT_OK;
        if (compare_row(f, p, oracle, plain, fused + all + i * all, tangents) != JLT_OK) return JLT_OK;
    }
    return JLT_OK;
}

static jlt_status compare_field(jlt_verify_family *f, const jlt_sample *s, const place *p, jlt_oracle *oracle)
{
    const unsigned n = p->field->descriptor->state_count;
    double rates[SIZE];

    if (p->time != NULL && jlt_instance_rhs(p->field, rates, p->x) == JLT_OK)
        jlt_check_enclosures(f, "fields in other times in ball enclosures of 256 bits", rates, p->rates, n);
    compare_jet(f, p);
    JLT_PASS(compare_stage(f, s, p, 0));
    if (p->time != NULL) return compare_jacobians(f, p, oracle);
    JLT_PASS(compare_stage(f, s, p, n));
    return n > 2 ? compare_stage(f, s, p, 2) : JLT_OK;
}

jlt_status jlt_stepping_compare(jlt_verify_family *f, const jlt_sample *s, jlt_oracle *oracle, const jlt_descriptor *own)
{
    for (const jlt_descriptor *const *each = own->family; *each != NULL; each++) {
        const jlt_descriptor *d = *each;
        JLT_OWNED(jlt_instance) *instance = NULL;
        place p = { .time = time_named(oracle->model, d->time) };
        if (strcmp(d->variant, own->variant) != 0 || d->elimination[0] != '\0' || d->state_count > SIZE) continue;
        const jlt_status st = jlt_instance_create(&instance, d, s->params);
        if (st == JLT_ERR_NOMEM) return st;
        if (st != JLT_OK) continue;
        p.field = instance;
        memcpy(p.x, s->x, own->state_count * sizeof *p.x);
        if (d->lifted != NULL && jlt_kernel_eval_function(p.x, d->lifted, d->state_count, s->x, own->state_count, s->params,
                                                          d->param_count) != JLT_OK)
            continue;
        if (enclose(&p, oracle) == JLT_OK) JLT_PASS(compare_field(f, s, &p, oracle));
    }
    return JLT_OK;
}
