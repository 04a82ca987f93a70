#include "dynamics/separation.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "dynamics/section_batch.h"

enum { ROWS = 48, BLOCK = 256 /* orbits that are followed at once, for each thread */ };

typedef struct {
    const jlt_chart *chart;
    const jlt_separation_options *options;
    unsigned char *first[2]; /* per cell: 1 + row from which it counts as visited, 0 never; forwards and backwards */
    size_t alive[2];         /* orbits forwards and backwards */
    size_t strayed;          /* orbits that left the chart's branch of the states it solves for */
} cells;

typedef struct {
    double q[2];
    bool mirrored; /* its mirror image is a start too: the orbit backwards of that is the mirror image of this one's */
} start;

static size_t cell_of(const cells *self, const double *q)
{
    const jlt_separation_options *o = self->options;
    size_t index[2];
    unsigned k;

    for (k = 0; k < 2; k++) {
        const double period = self->chart->period[k], above = q[k] - o->low[k];
        const double off = period != 0 ? above - period * floor(above / period) : above;
        const double at = off / (o->high[k] - o->low[k]) * (double)o->cells[k];
        if (!(at >= 0 && at <= (double)o->cells[k])) return SIZE_MAX;
        index[k] = at < (double)o->cells[k] ? (size_t)at : o->cells[k] - 1;
    }
    return index[1] * o->cells[0] + index[0];
}

/* The first row, returns = 2^row, that counts return number n after the settling. */
static unsigned row_of(size_t n)
{
    unsigned row = 0;

    while (((size_t)1 << row) < n) row++;
    return row;
}

static void visit(cells *self, bool backwards, const double *q, size_t number)
{
    unsigned char *first = self->first[backwards];
    const size_t cell = cell_of(self, q);
    const unsigned when = 1 + row_of(number);

    if (cell != SIZE_MAX && (first[cell] == 0 || first[cell] > when)) first[cell] = (unsigned char)when;
}

/* An orbit of a batch. `mirrored`: its mirror image is the orbit backwards of a start, and is counted too. */
static jlt_status count_orbit(cells *self, jlt_section_batch *batch, size_t index, bool backwards, bool mirrored)
{
    const jlt_separation_options *o = self->options;
    double image[2];
    jlt_return row;
    jlt_status st = jlt_section_batch_start(batch, &row, index);

    if (st == JLT_ERR_EMPTY || st == JLT_ERR_DOMAIN) return JLT_OK;
    while (st == JLT_OK && row.fate == JLT_FATE_ALIVE && row.number < o->settle + o->returns) {
        st = jlt_section_batch_next(batch, &row);
        if (st != JLT_OK || row.fate != JLT_FATE_ALIVE) break;
        if (row.interrupted) return JLT_ERR_NO_CONVERGENCE;
        if (!jlt_chart_follows(self->chart, row.x)) {
            self->strayed += 1 + mirrored;
            return JLT_OK; /* its cells would be those of other states */
        }
        if (row.number <= o->settle) continue;
        visit(self, backwards, row.q, row.number - o->settle);
        if (!mirrored) continue;
        jlt_chart_mirror(self->chart, image, row.q);
        visit(self, true, image, row.number - o->settle);
    }
    if (st == JLT_OK && row.fate == JLT_FATE_ALIVE) {
        self->alive[backwards]++;
        self->alive[1] += mirrored;
    }
    return st;
}

/* Orbits in one direction of time. */
static jlt_status follow(cells *self, const jlt_flow *flow, const start *starts, size_t count, bool backwards)
{
    const jlt_separation_options *o = self->options;
    const size_t most = BLOCK * (o->threads > 1 ? o->threads : 1);
    double *q = malloc(2 * most * sizeof *q);
    jlt_section_batch *batch = NULL;
    jlt_status st = JLT_ERR_NOMEM;

    if (q == NULL) goto done;
    JLT_TRY(jlt_section_batch_create(&batch, flow, o->kernels,
                                     &(jlt_section_batch_options){ .threads = o->threads, .backwards = backwards }));
    for (size_t first = 0; first < count; first += most) {
        const size_t here = count - first < most ? count - first : most;
        for (size_t i = 0; i < here; i++) memcpy(q + 2 * i, starts[first + i].q, sizeof starts->q);
        JLT_TRY(jlt_section_batch_run(batch, q, here, o->settle + o->returns));
        for (size_t i = 0; i < here; i++)
            JLT_TRY(count_orbit(self, batch, i, backwards, !backwards && starts[first + i].mirrored));
    }
done:
    jlt_section_batch_destroy(batch);
    free(q);
    return st;
}

static int compare(const void *a, const void *b)
{
    const double *p = ((const start *)a)->q, *q = ((const start *)b)->q;
    const int first = (p[0] > q[0]) - (p[0] < q[0]);

    return first != 0 ? first : (p[1] > q[1]) - (p[1] < q[1]);
}

/* Put the starts in order, and mark those whose mirror image is a start too. */
static void find_mirrored(start *starts, size_t count, const jlt_chart *chart)
{
    qsort(starts, count, sizeof *starts, compare);
    for (size_t i = 0; i < count; i++) {
        start image;
        jlt_chart_mirror(chart, image.q, starts[i].q);
        starts[i].mirrored = bsearch(&image, starts, count, sizeof *starts, compare) != NULL;
    }
}

/* Keep only the starts without a mirror image; returns how many. */
static size_t keep_lonely(start *starts, size_t count)
{
    size_t kept = 0;

    for (size_t i = 0; i < count; i++)
        if (!starts[i].mirrored) starts[kept++] = starts[i];
    return kept;
}

/* All orbits in both directions of time. */
static jlt_status follow_all(cells *self, const jlt_flow *flow, const double *q, size_t count)
{
    start *starts = malloc((count > 0 ? count : 1) * sizeof *starts);
    jlt_status st = JLT_ERR_NOMEM;

    if (starts == NULL) goto done;
    for (size_t i = 0; i < count; i++) starts[i] = (start){ .q = { q[2 * i], q[2 * i + 1] } };
    if (self->options->by_mirror && !flow->end_where_invalid && !jlt_field_watches(flow->field))
        find_mirrored(starts, count, flow->chart);
    JLT_TRY(follow(self, flow, starts, count, false));
    JLT_TRY(follow(self, flow, starts, keep_lonely(starts, count), true));
done:
    free(starts);
    return st;
}

static bool visited(const unsigned char *first, size_t cell, unsigned row)
{
    return first[cell] != 0 && first[cell] <= row + 1;
}

static void count_row(jlt_separation *out, const cells *self, unsigned row)
{
    const jlt_separation_options *o = self->options;
    size_t i, j, forward_mirrored = 0, both = 0;

    for (j = 0; j < o->cells[1]; j++)
        for (i = 0; i < o->cells[0]; i++) {
            const size_t cell = j * o->cells[0] + i;
            double q[2] = { o->low[0] + ((double)i + 0.5) / (double)o->cells[0] * (o->high[0] - o->low[0]),
                            o->low[1] + ((double)j + 0.5) / (double)o->cells[1] * (o->high[1] - o->low[1]) };
            size_t mirrored;
            const bool forward = visited(self->first[0], cell, row), backward = visited(self->first[1], cell, row);
            out->forward += forward;
            out->backward += backward;
            out->common += forward && backward;
            jlt_chart_mirror(self->chart, q, q);
            mirrored = cell_of(self, q);
            if (mirrored == SIZE_MAX || !visited(self->first[0], mirrored, row)) continue;
            forward_mirrored++;
            both += backward;
        }
    out->overlap = (double)out->common / (double)(out->forward + out->backward - out->common);
    out->mirror_overlap = (double)both / (double)(forward_mirrored + out->backward - both);
}

jlt_status jlt_separation_measure(jlt_separation *out, size_t *rows, const jlt_flow *flow, const double *starts,
                                  size_t count, const jlt_separation_options *options)
{
    const size_t all = options->cells[0] * options->cells[1];
    cells self = { .chart = flow->chart, .options = options };
    unsigned row, last;
    jlt_status st = JLT_OK;

    *rows = 0;
    if (flow->chart->dim != 2 || !flow->chart->reversible || all == 0 || options->returns == 0) return JLT_ERR_ARG;
    last = row_of(options->returns);
    if (last >= ROWS) return JLT_ERR_ARG;
    self.first[0] = calloc(all, 1);
    self.first[1] = calloc(all, 1);
    st = JLT_ERR_NOMEM;
    if (self.first[0] == NULL || self.first[1] == NULL) goto done;
    JLT_TRY(follow_all(&self, flow, starts, count));
    for (row = 0; row <= last; row++) {
        out[row] = (jlt_separation){
            .returns = (size_t)1 << row, .alive_forward = self.alive[0], .alive_backward = self.alive[1], .strayed = self.strayed
        };
        count_row(&out[row], &self, row);
    }
    if (out[last].returns > options->returns) out[last].returns = options->returns;
    *rows = last + 1;
done:
    free(self.first[0]);
    free(self.first[1]);
    return st;
}
