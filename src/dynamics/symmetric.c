#include "dynamics/symmetric.h"

#include "core/memory.h"
#include "dynamics/section_batch.h"

#include <math.h>
#include <string.h>

enum { BLOCK = 1024 }; /* samples that are followed together */
static const double pi = 3.14159265358979323846;

typedef struct {
    jlt_map *map;
    jlt_section *both;  /* the flow's section, crossed in both directions, */
    jlt_section_batch *many; /* and for many orbits at once */
    const jlt_symmetric_line *line;
    unsigned mirrored;
    unsigned char held[JLT_CHART_DIM_MAX]; /* coordinates that Newton keeps: fixed on the line, mirrored only if dim is 2 */
} search;

static void point_of(const search *self, double *q, double u)
{
    memcpy(q, self->line->base, jlt_map_flow(self->map)->chart->dim * sizeof *q);
    q[self->line->free] = u;
}

/* h of a crossing. */
static double half(const search *self, const jlt_return *row)
{
    const jlt_chart *chart = jlt_map_flow(self->map)->chart;
    const double q = row->q[self->mirrored], period = chart->period[self->mirrored];

    return period != 0 ? sin(q * (2 * pi / period)) : ldexp(q, -chart->scale[self->mirrored]);
}

/* h_1 .. h_count along the orbit from u; NaN after its end. Sample `index` of those that run together, or with SIZE_MAX alone. */
static jlt_status halves(const search *self, double *h, double u, size_t count, size_t index)
{
    const bool alone = index == SIZE_MAX;
    double q[JLT_CHART_DIM_MAX];
    jlt_return row = { .fate = JLT_FATE_ALIVE };
    jlt_status st;

    for (size_t j = 0; j < count; j++) h[j] = NAN;
    point_of(self, q, u);
    st = alone ? jlt_section_start(self->both, NULL, q, 1) : jlt_section_batch_start(self->many, &row, index);
    if (st == JLT_ERR_EMPTY || st == JLT_ERR_DOMAIN) return JLT_OK;
    for (size_t j = 0; st == JLT_OK && j < count; j++) {
        st = alone ? jlt_section_next(self->both, &row) : jlt_section_batch_next(self->many, &row);
        if (st != JLT_OK || row.interrupted || row.fate != JLT_FATE_ALIVE) break;
        h[j] = half(self, &row);
    }
    if (row.interrupted) return JLT_ERR_NO_CONVERGENCE;
    return st;
}

/* Find the zero of h_j between a and b by the Illinois method, bisecting where that is slow. *found is false at a jump. */
static jlt_status bisect(const search *self, double *root, bool *found, double *work, double a, double ha, double b,
                         double hb, size_t j)
{
    const double unit = ldexp(1, jlt_map_flow(self->map)->chart->scale[self->line->free]);
    double last = fmin(fabs(ha), fabs(hb)), previous = fabs(b - a);
    int side = 0, iteration;

    *found = false;
    for (iteration = 0; iteration < 80 && fabs(b - a) > 4e-16 * fmax(unit, fabs(a)); iteration++) {
        double u = (a * hb - b * ha) / (hb - ha), h;
        if (iteration % 3 == 2) {
            if (fabs(b - a) > previous / 4 || !(u > fmin(a, b) && u < fmax(a, b))) u = (a + b) / 2;
            previous = fabs(b - a);
        }
        JLT_PASS(halves(self, work, u, j, SIZE_MAX));
        h = work[j - 1];
        if (isnan(h)) return JLT_OK;
        *root = u;
        last = fabs(h);
        if (last < 1e-14) break;
        if ((h > 0) == (hb > 0)) {
            b = u, hb = h;
            if (side == 1) ha /= 2;
            side = 1;
        } else {
            a = u, ha = h;
            if (side == -1) hb /= 2;
            side = -1;
        }
    }
    *found = last < 1e-6;
    return JLT_OK;
}

/* Bring the orbit through the line's point u to the map's own section, polish it and hand it over. */
static jlt_status deliver(const search *self, double u, size_t period, jlt_symmetric_sink sink, void *context)
{
    const jlt_flow *flow = jlt_map_flow(self->map);
    const jlt_chart *chart = flow->chart;
    const unsigned d = chart->dim;
    double q[JLT_CHART_DIM_MAX], x[JLT_CHART_STATES_MAX], f[JLT_CHART_STATES_MAX], mirror[JLT_CHART_DIM_MAX];
    double nearest = INFINITY;
    const unsigned char *held = self->held;
    jlt_periodic orbit;
    jlt_image image;
    size_t k, first = 0;

    point_of(self, q, u);
    JLT_PASS(chart->lift(chart, x, NULL, q));
    flow->field->call(x, flow->field->p, f);
    if (flow->direction != JLT_BOTH && (int)flow->direction * f[chart->column] < 0) {
        if (jlt_map_point(self->map, &image, q, 1, 1) != JLT_OK) return JLT_OK;
        memcpy(q, image.q, sizeof q);
        if (d == 2) held = NULL;
    }
    const jlt_status st = jlt_periodic_find(self->map, &orbit, q, period, held);
    if (st != JLT_OK) return st == JLT_ERR_NOMEM ? st : JLT_OK;
    if (!orbit.symmetric && orbit.type != JLT_ORBIT_DEGENERATE) return JLT_OK; /* Newton's method went to another orbit */
    for (k = 0; k < orbit.period; k++) {
        double distance;
        jlt_chart_mirror(chart, mirror, orbit.points + k * d);
        distance = jlt_chart_distance(chart, mirror, orbit.points + k * d);
        if (distance < nearest - 1e-9) nearest = distance, first = k;
    }
    if (first != 0) JLT_PASS(jlt_periodic_rotate(self->map, &orbit, first));
    return sink(context, &orbit);
}

static jlt_status sample(const search *self, double *table, size_t crossings, double *at)
{
    const jlt_symmetric_line *line = self->line;
    const unsigned d = jlt_map_flow(self->map)->chart->dim;
    JLT_FREED double *q = malloc((size_t)BLOCK * d * sizeof *q);

    if (q == NULL) return JLT_ERR_NOMEM;
    for (size_t i = 0; i < line->samples; i++)
        at[i] = line->low + (line->high - line->low) * (double)i / (double)(line->samples - 1);
    for (size_t first = 0; first < line->samples; first += BLOCK) {
        const size_t count = line->samples - first < BLOCK ? line->samples - first : BLOCK;
        for (size_t i = 0; i < count; i++) point_of(self, q + i * d, at[first + i]);
        JLT_PASS(jlt_section_batch_run(self->many, q, count, crossings));
        if (jlt_section_batch_begun(self->many) < count) return JLT_ERR_NO_CONVERGENCE;
        for (size_t i = 0; i < count; i++)
            JLT_PASS(halves(self, table + (first + i) * crossings, at[first + i], crossings, i));
    }
    return JLT_OK;
}

jlt_status jlt_symmetric_search(jlt_map *map, const jlt_symmetric_line *line, size_t period_max, const jlt_kernel_batch *kernels,
                                unsigned threads, jlt_symmetric_sink sink, void *context)
{
    const jlt_flow *flow = jlt_map_flow(map);
    const jlt_chart *chart = flow->chart;
    search self = { .map = map, .line = line, .mirrored = JLT_CHART_DIM_MAX };
    jlt_flow both = *flow;
    jlt_status st = JLT_OK;
    JLT_FREED double *table = NULL, *at = NULL, *work = NULL;
    const size_t crossings = flow->direction == JLT_BOTH ? period_max / 2 : period_max;

    if (line->samples < 2 || line->free >= chart->dim || !(line->low < line->high)) return JLT_ERR_ARG;
    if (!chart->reversible) return JLT_ERR_UNSUPPORTED;
    for (unsigned k = 0; k < chart->dim; k++) {
        if (chart->mirror[k] > 0) {
            self.held[k] = k != line->free;
            continue;
        }
        if (self.mirrored != JLT_CHART_DIM_MAX || k == line->free) return JLT_ERR_UNSUPPORTED;
        self.mirrored = k;
    }
    if (self.mirrored == JLT_CHART_DIM_MAX) return JLT_ERR_UNSUPPORTED;
    self.held[self.mirrored] = chart->dim == 2;
    if (crossings == 0) return JLT_OK;
    both.direction = JLT_BOTH;
    JLT_TRY(jlt_section_create(&self.both, &both));
    JLT_TRY(jlt_section_batch_create(&self.many, &both, kernels, &(jlt_section_batch_options){ .threads = threads }));
    table = malloc(line->samples * crossings * sizeof *table);
    at = malloc(line->samples * sizeof *at);
    work = malloc(crossings * sizeof *work);
    st = JLT_ERR_NOMEM;
    if (table == NULL || at == NULL || work == NULL) goto done;
    JLT_TRY(sample(&self, table, crossings, at));
    for (size_t j = 1; j <= crossings; j++)
        for (size_t i = 0; i + 1 < line->samples; i++) {
            const double ha = table[i * crossings + j - 1], hb = table[(i + 1) * crossings + j - 1];
            double root = 0;
            bool found;
            if (isnan(ha) || isnan(hb) || (ha > 0) == (hb > 0)) continue;
            JLT_TRY(bisect(&self, &root, &found, work, at[i], ha, at[i + 1], hb, j));
            if (found) JLT_TRY(deliver(&self, root, flow->direction == JLT_BOTH ? 2 * j : j, sink, context));
        }
done:
    jlt_section_batch_destroy(self.many);
    jlt_section_destroy(self.both);
    return st;
}
