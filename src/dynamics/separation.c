#include "dynamics/separation.h"

#include <stdint.h>
#include <string.h>

#include "core/memory.h"
#include "dynamics/section_batch.h"

enum { ROWS = 48, BLOCK = 256 /* orbits that are followed at once, for each thread */ };

/* Sets of cells: those with points of forward orbits, of backward orbits, and with mirror images of forward points. Points are
 * mirrored, and not cells, as the image of a half-open cell has its closed edges on the other side. */
enum { FORWARDS, BACKWARDS, IMAGES, SETS };

typedef struct {
    const jlt_chart *chart;
    const jlt_separation_options *options;
    unsigned char *first[SETS]; /* per cell: 1 + row from which it counts as visited, 0 never */
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

    for (unsigned k = 0; k < 2; k++) {
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

    while (row < ROWS && ((size_t)1 << row) < n) row++;
    return row;
}

static void visit(cells *self, int set, const double *q, size_t number)
{
    unsigned char *first = self->first[set];
    const size_t cell = cell_of(self, q);
    const unsigned when = 1 + row_of(number);

    if (cell != SIZE_MAX && (first[cell] == 0 || first[cell] > when)) first[cell] = (unsigned char)when;
}

/* Count the cells of an orbit of a batch; mirrored: and those of its mirror image, the backward orbit of another start. */
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
        visit(self, backwards ? BACKWARDS : FORWARDS, row.q, row.number - o->settle);
        if (backwards) continue;
        jlt_chart_mirror(self->chart, image, row.q);
        visit(self, IMAGES, image, row.number - o->settle);
        if (mirrored) visit(self, BACKWARDS, image, row.number - o->settle);
    }
    if (st == JLT_OK && row.fate == JLT_FATE_ALIVE) {
        self->alive[backwards]++;
        self->alive[1] += mirrored;
    }
    return st;
}

/* Follow the orbits of all starts in one direction of time. */
static jlt_status follow(cells *self, const jlt_flow *flow, const start *starts, size_t count, bool backwards)
{
    const jlt_separation_options *o = self->options;
    const size_t most = BLOCK * (o->threads > 1 ? o->threads : 1);
    JLT_FREED double *q = malloc(2 * most * sizeof *q);
    JLT_OWNED(jlt_section_batch) *batch = NULL;

    if (q == NULL) return JLT_ERR_NOMEM;
    JLT_PASS(jlt_section_batch_create(&batch, flow, o->kernels,
                                      &(jlt_section_batch_options){ .threads = o->threads, .backwards = backwards }));
    for (size_t first = 0; first < count; first += most) {
        const size_t here = count - first < most ? count - first : most;
        for (size_t i = 0; i < here; i++) memcpy(q + 2 * i, starts[first + i].q, sizeof starts->q);
        JLT_PASS(jlt_section_batch_run(batch, q, here, o->settle + o->returns));
        for (size_t i = 0; i < here; i++)
            JLT_PASS(count_orbit(self, batch, i, backwards, !backwards && starts[first + i].mirrored));
    }
    return JLT_OK;
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

/* Follow all orbits in both directions of time. */
static jlt_status follow_all(cells *self, const jlt_flow *flow, const double *q, size_t count)
{
    JLT_FREED start *starts = malloc((count > 0 ? count : 1) * sizeof *starts);

    if (starts == NULL) return JLT_ERR_NOMEM;
    for (size_t i = 0; i < count; i++) starts[i] = (start){ .q = { q[2 * i], q[2 * i + 1] } };
    if (self->options->by_mirror && !flow->end_where_invalid && !jlt_field_watches(flow->field))
        find_mirrored(starts, count, flow->chart);
    JLT_PASS(follow(self, flow, starts, count, false));
    return follow(self, flow, starts, keep_lonely(starts, count), true);
}

static bool visited(const unsigned char *first, size_t cell, unsigned row)
{
    return first[cell] != 0 && first[cell] <= row + 1;
}

static void count_row(jlt_separation *out, const cells *self, unsigned row)
{
    size_t images = 0, both = 0;

    for (size_t cell = 0; cell < self->options->cells[0] * self->options->cells[1]; cell++) {
        const bool forward = visited(self->first[FORWARDS], cell, row), backward = visited(self->first[BACKWARDS], cell, row);
        const bool image = visited(self->first[IMAGES], cell, row);
        out->forward += forward;
        out->backward += backward;
        out->common += forward && backward;
        images += image;
        both += image && backward;
    }
    out->overlap = (double)out->common / (double)(out->forward + out->backward - out->common);
    out->mirror_overlap = (double)both / (double)(images + out->backward - both);
}

/* Whether there are cells and returns, few enough to be counted, and the cells have a size. */
static bool allows(const jlt_separation_options *o)
{
    for (unsigned k = 0; k < 2; k++)
        if (o->cells[k] == 0 || !(o->low[k] < o->high[k]) || !isfinite(o->high[k] - o->low[k])) return false;
    if (o->cells[0] > SIZE_MAX / o->cells[1] || o->returns == 0 || row_of(o->returns) >= ROWS) return false;
    return o->settle <= SIZE_MAX - o->returns;
}

jlt_status jlt_separation_measure(jlt_separation *out, size_t *rows, const jlt_flow *flow, const double *starts,
                                  size_t count, const jlt_separation_options *options)
{
    const size_t all = options->cells[0] * options->cells[1];
    cells self = { .chart = flow->chart, .options = options };
    jlt_status st = JLT_OK;

    *rows = 0;
    if (flow->chart->dim != 2 || !flow->chart->reversible || !allows(options)) return JLT_ERR_ARG;
    const unsigned last = row_of(options->returns);
    for (int set = 0; set < SETS; set++)
        if ((self.first[set] = calloc(all, 1)) == NULL) st = JLT_ERR_NOMEM;
    if (st != JLT_OK) goto done;
    JLT_TRY(follow_all(&self, flow, starts, count));
    for (unsigned row = 0; row <= last; row++) {
        out[row] = (jlt_separation){
            .returns = (size_t)1 << row, .alive_forward = self.alive[0], .alive_backward = self.alive[1], .strayed = self.strayed
        };
        count_row(&out[row], &self, row);
    }
    if (out[last].returns > options->returns) out[last].returns = options->returns;
    *rows = last + 1;
done:
    for (int set = 0; set < SETS; set++) free(self.first[set]);
    return st;
}
