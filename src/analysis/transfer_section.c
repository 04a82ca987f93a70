#include "analysis/transfer_section.h"

#include "core/memory.h"
#include "kernel/instance.h"
#include "kernel/kernel.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MEASURES_MAX = 64 };

struct jlt_transfer_section {
    const jlt_system *system;
    jlt_section_batch *batch;
    jlt_instance *known; /* in the table's own time and units, in which densities are claimed; NULL if none is claimed */
    double *starts; /* (room, dim): those points of a block that are on the section */
    size_t *index;  /* (room,): their indices in the block */
    size_t room;
    jlt_failures failures;
};

/* The same variant in the model's own time. In every time, the states of the own time come first. */
static const jlt_descriptor *in_own_time(const jlt_descriptor *d)
{
    for (size_t i = 0; d->family[i] != NULL; i++) {
        const jlt_descriptor *other = d->family[i];
        if (strcmp(other->variant, d->variant) == 0 && other->time[0] == '\0' && other->elimination[0] == '\0') return other;
    }
    return NULL;
}

jlt_status jlt_transfer_section_create(jlt_transfer_section **out, const jlt_system *system, jlt_section_batch *batch)
{
    const jlt_descriptor *own = in_own_time(system->instance->descriptor);
    jlt_transfer_section *self = calloc(1, sizeof *self);
    jlt_status st = JLT_OK;

    *out = NULL;
    if (self == NULL) return JLT_ERR_NOMEM;
    self->system = system;
    self->batch = batch;
    if (own != NULL && own->measure_count > 0 && own->measure_count <= MEASURES_MAX)
        st = jlt_instance_create(&self->known, own, system->instance->params);
    if (st == JLT_OK) *out = self;
    else jlt_transfer_section_destroy(self);
    return st;
}

void jlt_transfer_section_destroy(jlt_transfer_section *self)
{
    if (self == NULL) return;
    jlt_instance_destroy(self->known);
    free(self->starts);
    free(self->index);
    free(self);
}

const char *jlt_transfer_section_density(const jlt_transfer_section *self)
{
    return self->known != NULL ? self->known->descriptor->measures[0].name : NULL;
}

const jlt_failures *jlt_transfer_section_failures(const jlt_transfer_section *self) { return &self->failures; }

/* The state x at q and the field f there, in the flow's units. Returns false if q has no state, or the flow there crosses the
 * section the other way. */
static bool at(const jlt_transfer_section *self, double *x, double *f, const double *q)
{
    const jlt_flow *flow = &self->system->flow;

    if (flow->chart->lift(flow->chart, x, NULL, q) != JLT_OK) return false;
    flow->field->call(x, flow->field->p, f);
    return flow->direction == JLT_BOTH ? f[flow->chart->column] != 0 : (int)flow->direction * f[flow->chart->column] > 0;
}

static bool holds(void *context, const double *q)
{
    double x[JLT_CHART_STATES_MAX], f[JLT_CHART_STATES_MAX];

    return at(context, x, f, q);
}

/* Copy the points that are on the section to self->starts, and their indices to self->index; mark all points as not in the space.
 * Errors: NOMEM. */
static jlt_status choose(jlt_transfer_section *self, size_t *chosen, unsigned *loss, const double *q, size_t count)
{
    const unsigned dim = self->system->flow.chart->dim;

    if (count > self->room) {
        free(self->starts);
        free(self->index);
        self->starts = jlt_memory_array(count * dim, sizeof *self->starts);
        self->index = jlt_memory_array(count, sizeof *self->index);
        self->room = self->starts != NULL && self->index != NULL ? count : 0;
        if (self->room == 0) return JLT_ERR_NOMEM;
    }
    *chosen = 0;
    for (size_t i = 0; i < count; i++) {
        loss[i] = JLT_TRANSFER_SECTION_LOSSES;
        if (!holds(self, q + i * dim)) continue;
        memcpy(self->starts + *chosen * dim, q + i * dim, dim * sizeof *q);
        self->index[(*chosen)++] = i;
    }
    return JLT_OK;
}

static jlt_status images(void *context, double *image, unsigned *loss, double *time, const double *q, size_t count)
{
    jlt_transfer_section *self = context;
    const jlt_chart *chart = self->system->flow.chart;
    jlt_return row;
    size_t chosen;
    jlt_status st = choose(self, &chosen, loss, q, count);

    if (st != JLT_OK || chosen == 0) return st;
    st = jlt_section_batch_run(self->batch, self->starts, chosen, 1);
    for (size_t k = 0; st == JLT_OK && k < chosen; k++) {
        const size_t i = self->index[k];
        st = jlt_section_batch_last(self->batch, &row, k);
        if (st != JLT_OK || row.interrupted) continue; /* the interrupt flag is set, and images are not used */
        loss[i] = (unsigned)row.fate;
        jlt_failures_add(&self->failures, row.fate, row.unbounded, row.t);
        time[i] = fabs(row.t);
        memcpy(image + i * chart->dim, row.q, chart->dim * sizeof *row.q);
        if (row.fate == JLT_FATE_ALIVE && self->system->surface == NULL && !jlt_chart_follows(chart, row.x))
            loss[i] = JLT_TRANSFER_SECTION_BRANCH;
    }
    return st;
}

static double density(void *context, const double *q)
{
    const jlt_transfer_section *self = context;
    const jlt_flow *flow = &self->system->flow;
    const jlt_descriptor *d = self->known->descriptor;
    double x[JLT_CHART_STATES_MAX], f[JLT_CHART_STATES_MAX], values[MEASURES_MAX];

    if (!at(self, x, f, q)) return 0;
    double flux = flow->chart->flux(flow->chart, x, f) / jlt_field_time_rate(flow->field, x);
    /* The chart's flux includes the volume element of lifted roots, see chart_section.h; remove it. */
    for (unsigned k = d->state_count; k < flow->chart->states; k++) flux *= x[k];
    for (unsigned k = 0; k < flow->chart->states; k++) x[k] = ldexp(x[k], flow->units.state[k]);
    if (jlt_kernel_eval(values, &d->measure_values, x, d->state_count, self->known->prepared) != JLT_OK) return 0;
    return fabs(values[0] * flux);
}

jlt_transfer_map jlt_transfer_section_map(jlt_transfer_section *self)
{
    return (jlt_transfer_map){ .context = self, .losses = JLT_TRANSFER_SECTION_LOSSES, .holds = holds, .images = images,
                               .density = self->known != NULL ? density : NULL, .interrupt = self->system->flow.interrupt };
}

bool jlt_transfer_section_mirror(double *mirrored, const jlt_transfer *transfer, const double *v, const jlt_chart *chart)
{
    double q[JLT_CHART_DIM_MAX];
    size_t box;

    if (!chart->reversible) return false;
    for (size_t i = 0; i < transfer->count; i++) {
        jlt_boxes_centre(&transfer->boxes, q, transfer->box[i]);
        jlt_chart_mirror(chart, q, q);
        const bool is_there = jlt_boxes_find(&transfer->boxes, &box, q) && transfer->kept[box] != JLT_TRANSFER_NONE;
        mirrored[i] = is_there ? v[transfer->kept[box]] : 0;
    }
    return true;
}
