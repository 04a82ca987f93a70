#include "dynamics/separation.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "dynamics/section_batch.h"

enum { ROWS = 48, BLOCK = 256 /* orbits that are followed at once, for each thread */ };

typedef struct {
    const jlt_chart *chart;
    const jlt_separation_options *options;
    unsigned char *first[2]; /* per cell: 1 + row from which it counts as visited, 0 never; forwards and backwards */
} cells;

static size_t cell_of(const cells *self, const double *q)
{
    const jlt_separation_options *o = self->options;
    size_t index[2];
    unsigned k;

    for (k = 0; k < 2; k++) {
        const double at = (q[k] - o->low[k]) / (o->high[k] - o->low[k]) * (double)o->cells[k];
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

/* An orbit of a batch. */
static jlt_status count_orbit(cells *self, jlt_section_batch *batch, size_t *alive, size_t index, bool backwards)
{
    const jlt_separation_options *o = self->options;
    unsigned char *first = self->first[backwards];
    jlt_return row;
    jlt_status st = jlt_section_batch_start(batch, &row, index);

    if (st == JLT_ERR_EMPTY || st == JLT_ERR_DOMAIN) return JLT_OK;
    while (st == JLT_OK && row.fate == JLT_FATE_ALIVE && row.number < o->settle + o->returns) {
        st = jlt_section_batch_next(batch, &row);
        if (st != JLT_OK || row.fate != JLT_FATE_ALIVE) break;
        if (row.interrupted) return JLT_ERR_NO_CONVERGENCE;
        if (row.number > o->settle) {
            const size_t cell = cell_of(self, row.q);
            const unsigned when = 1 + row_of(row.number - o->settle);
            if (cell != SIZE_MAX && (first[cell] == 0 || first[cell] > when)) first[cell] = (unsigned char)when;
        }
    }
    if (st == JLT_OK && row.fate == JLT_FATE_ALIVE) ++*alive;
    return st;
}

/* All orbits in one direction of time. */
static jlt_status follow(cells *self, size_t *alive, const jlt_flow *flow, const double *starts, size_t count, bool backwards)
{
    const jlt_separation_options *o = self->options;
    const unsigned threads = o->threads > 1 ? o->threads : 1;
    jlt_section_batch *batch = NULL;
    jlt_status st = JLT_OK;

    JLT_TRY(jlt_section_batch_create(&batch, flow, o->kernels,
                                     &(jlt_section_batch_options){ .threads = threads, .backwards = backwards }));
    for (size_t first = 0; first < count; first += BLOCK * threads) {
        const size_t here = count - first < BLOCK * threads ? count - first : BLOCK * threads;
        JLT_TRY(jlt_section_batch_run(batch, starts + 2 * first, here, o->settle + o->returns));
        for (size_t i = 0; i < here; i++) JLT_TRY(count_orbit(self, batch, alive, i, backwards));
    }
done:
    jlt_section_batch_destroy(batch);
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
    size_t alive[2] = { 0, 0 };
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
    for (unsigned k = 0; k < 2; k++) JLT_TRY(follow(&self, &alive[k], flow, starts, count, k == 1));
    for (row = 0; row <= last; row++) {
        out[row] = (jlt_separation){ .returns = (size_t)1 << row, .alive_forward = alive[0], .alive_backward = alive[1] };
        count_row(&out[row], &self, row);
    }
    if (out[last].returns > options->returns) out[last].returns = options->returns;
    *rows = last + 1;
done:
    free(self.first[0]);
    free(self.first[1]);
    return st;
}
