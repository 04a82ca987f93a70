#include "analysis/transfer.h"

#include "core/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void jlt_transfer_destroy(jlt_transfer *self)
{
    if (self == NULL) return;
    free(self->box);
    free(self->kept);
    free(self->share);
    free(self->row);
    free(self->to);
    free(self->weight);
    free(self->lost);
    free(self->time);
    free(self->known);
    free(self);
}

void jlt_transfer_push(const jlt_transfer *self, double *out, const double *v)
{
    memset(out, 0, self->count * sizeof *out);
    for (size_t i = 0; i < self->count; i++)
        for (size_t e = self->row[i]; e < self->row[i + 1]; e++) out[self->to[e]] += v[i] * self->weight[e];
}

double jlt_transfer_distance(const double *a, const double *b, size_t count)
{
    double sum = 0;

    for (size_t i = 0; i < count; i++) sum += fabs(a[i] - b[i]);
    return sum / 2;
}

/* Work space of coarsening: the fine boxes of each coarse box, and a row being summed. Indices are those among kept boxes. */
typedef struct {
    const jlt_transfer *fine;
    uint32_t *parent;      /* (fine->count,): index of the coarse box of each fine one */
    size_t *first, *part;  /* (coarse->count + 1,), (fine->count,): the fine boxes of coarse box I, from part[first[I]] on */
    double *sum;           /* (coarse->count,): the row; nonzero only at the columns in `touched` */
    uint32_t *touched;     /* (coarse->count,), of which touched_count are used */
    size_t touched_count;
} merger;

static void forget(merger *m)
{
    free(m->parent);
    free(m->first);
    free(m->part);
    free(m->sum);
    free(m->touched);
}

static int ascending(const void *a, const void *b)
{
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x > y) - (x < y);
}

/* Number the coarse boxes that contain a fine one, in ascending order, and list the fine boxes of each. */
static jlt_status number_parts(jlt_transfer *out, merger *m, size_t all)
{
    const jlt_transfer *fine = m->fine;
    size_t *fill;

    for (size_t i = 0; i < fine->count; i++) {
        m->parent[i] = (uint32_t)jlt_boxes_parent(&fine->boxes, &out->boxes, fine->box[i]);
        out->kept[m->parent[i]] = 0;
    }
    for (size_t box = 0; box < all; box++)
        if (out->kept[box] == 0) {
            out->kept[box] = (uint32_t)out->count;
            out->box[out->count++] = (uint32_t)box;
        }
    m->first = jlt_memory_array(out->count + 2, sizeof *m->first);
    m->sum = jlt_memory_array(out->count, sizeof *m->sum);
    m->touched = jlt_memory_array(out->count, sizeof *m->touched);
    if (m->first == NULL || m->sum == NULL || m->touched == NULL) return JLT_ERR_NOMEM;
    fill = m->first + 1;
    for (size_t i = 0; i < fine->count; i++) fill[(m->parent[i] = out->kept[m->parent[i]]) + 1]++;
    for (size_t i = 0; i < out->count; i++) fill[i + 1] += fill[i];
    for (size_t i = 0; i < fine->count; i++) m->part[fill[m->parent[i]]++] = i;
    return JLT_OK;
}

/* Add a fine box, which carries `share` of its coarse box's mass, to the coarse row; *back grows by the share with an image. */
static void add_part(jlt_transfer *out, merger *m, size_t coarse, size_t i, double share, double *back)
{
    const jlt_transfer *fine = m->fine;
    double returned = 0;

    for (size_t e = fine->row[i]; e < fine->row[i + 1]; e++) {
        const uint32_t to = m->parent[fine->to[e]];
        if (m->sum[to] == 0) m->touched[m->touched_count++] = to;
        m->sum[to] += share * fine->weight[e];
        returned += share * fine->weight[e];
    }
    for (unsigned k = 0; k < fine->losses; k++) out->lost[coarse * fine->losses + k] += share * fine->lost[i * fine->losses + k];
    if (returned > 0) out->time[coarse] += returned * fine->time[i];
    if (out->known != NULL) out->known[coarse] += fine->known[i];
    *back += returned;
}

/* Append the row of one coarse box. parts: number of fine boxes that a coarse box consists of. */
static void add_row(jlt_transfer *out, merger *m, size_t coarse, double parts)
{
    double whole = 0, back = 0;
    size_t at = out->row[coarse];

    for (size_t p = m->first[coarse]; p < m->first[coarse + 1]; p++) whole += m->fine->share[m->part[p]];
    m->touched_count = 0;
    for (size_t p = m->first[coarse]; p < m->first[coarse + 1]; p++)
        add_part(out, m, coarse, m->part[p], m->fine->share[m->part[p]], &back);
    out->share[coarse] = whole / parts;
    if (whole == 0) whole = out->lost[coarse * out->losses] = 1;
    out->time[coarse] = back > 0 ? out->time[coarse] / back : NAN;
    qsort(m->touched, m->touched_count, sizeof *m->touched, ascending);
    for (size_t k = 0; k < m->touched_count; k++) {
        out->to[at] = m->touched[k];
        out->weight[at++] = m->sum[m->touched[k]] / whole;
        m->sum[m->touched[k]] = 0;
    }
    for (unsigned k = 0; k < out->losses; k++) out->lost[coarse * out->losses + k] /= whole;
    out->row[coarse + 1] = at;
}

static jlt_status allocate(jlt_transfer *out, merger *m, size_t all)
{
    const jlt_transfer *fine = m->fine;
    const size_t count = fine->count, entries = fine->row[fine->count];

    out->losses = fine->losses;
    out->box = jlt_memory_array(count, sizeof *out->box);
    out->kept = jlt_memory_array(all, sizeof *out->kept);
    out->share = jlt_memory_array(count, sizeof *out->share);
    out->row = jlt_memory_array(count + 1, sizeof *out->row);
    out->to = jlt_memory_array(entries, sizeof *out->to);
    out->weight = jlt_memory_array(entries, sizeof *out->weight);
    out->lost = jlt_memory_array(count * fine->losses, sizeof *out->lost);
    out->time = jlt_memory_array(count, sizeof *out->time);
    if (fine->known != NULL) out->known = jlt_memory_array(count, sizeof *out->known);
    m->parent = jlt_memory_array(count, sizeof *m->parent);
    m->part = jlt_memory_array(count, sizeof *m->part);
    if (out->box == NULL || out->kept == NULL || out->share == NULL || out->row == NULL || out->to == NULL || out->weight == NULL ||
        out->lost == NULL || out->time == NULL || (fine->known != NULL && out->known == NULL) || m->parent == NULL ||
        m->part == NULL)
        return JLT_ERR_NOMEM;
    memset(out->kept, 0xff, all * sizeof *out->kept);
    return JLT_OK;
}

jlt_status jlt_transfer_coarsen(jlt_transfer **out, const jlt_transfer *fine, size_t factor)
{
    JLT_OWNED(jlt_transfer) *self = calloc(1, sizeof *self);
    JLT_CLEARED(forget) merger m = { .fine = fine };
    double parts = 1;
    size_t all;

    *out = NULL;
    if (self == NULL) return JLT_ERR_NOMEM;
    JLT_PASS(jlt_boxes_coarser(&self->boxes, &fine->boxes, factor));
    JLT_PASS(jlt_boxes_count(&all, &self->boxes));
    JLT_PASS(allocate(self, &m, all));
    JLT_PASS(number_parts(self, &m, all));
    for (unsigned k = 0; k < fine->boxes.dim; k++) parts *= (double)(fine->boxes.count[k] / self->boxes.count[k]);
    for (size_t i = 0; i < self->count; i++) add_row(self, &m, i, parts);
    *out = self;
    self = NULL; /* ownership moved to the caller */
    return JLT_OK;
}
