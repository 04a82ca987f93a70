#include "dynamics/symmetric.h"

#include "core/memory.h"
#include "dynamics/section_batch.h"

#include <math.h>
#include <string.h>

enum {
    BLOCK = 1024,      /* samples that are followed together */
    WAVES = 7,         /* how often the space between two samples is halved at most */
    NUMBERS = 1 << 22, /* of a table beyond which no samples are added */
};
static const double step = 0.25; /* the largest change of an h from sample to sample that needs none between */
static const double pi = 3.14159265358979323846;

typedef struct {
    jlt_map *map;
    jlt_section *both;  /* the flow's section, crossed in both directions, */
    jlt_section_batch *many; /* and for many orbits at once */
    const jlt_symmetric_line *line;
    unsigned mirrored;
    unsigned char held[JLT_CHART_DIM_MAX]; /* coordinates that Newton keeps: fixed on the line, mirrored only if dim is 2 */
    const jlt_symmetric_sink *sink;
} search;

/* Points of the line in order, and h_1 .. h_crossings for each. */
typedef struct {
    size_t count, crossings;
    double *u;     /* (count,) */
    double *table; /* (count, crossings) */
} samples;

static void tell(const search *self, const char *what, size_t done, size_t all)
{
    if (self->sink->progress != NULL) self->sink->progress(self->sink->context, what, done, all);
}

static void clear_samples(samples *self)
{
    free(self->u);
    free(self->table);
}

static bool make_samples(samples *self, size_t count, size_t crossings)
{
    *self = (samples){ .count = count, .crossings = crossings, .u = malloc(count * sizeof *self->u),
                       .table = malloc(count * crossings * sizeof *self->table) };
    return self->u != NULL && self->table != NULL;
}

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
static jlt_status deliver(const search *self, double u, size_t period)
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
    return self->sink->found(self->sink->context, &orbit);
}

/* Compute the table of all samples whose first number is infinite. In/out: *done, how many have been computed. */
static jlt_status compute(const search *self, samples *of, size_t *done)
{
    const unsigned d = jlt_map_flow(self->map)->chart->dim;
    JLT_FREED double *q = malloc((size_t)BLOCK * d * sizeof *q);
    JLT_FREED size_t *index = malloc(BLOCK * sizeof *index);

    if (q == NULL || index == NULL) return JLT_ERR_NOMEM;
    for (size_t next = 0; next < of->count;) {
        size_t count = 0;
        for (; next < of->count && count < BLOCK; next++) {
            if (!isinf(of->table[next * of->crossings])) continue;
            point_of(self, q + count * d, of->u[next]);
            index[count++] = next;
        }
        JLT_PASS(jlt_section_batch_run(self->many, q, count, of->crossings));
        if (jlt_section_batch_begun(self->many) < count) return JLT_ERR_NO_CONVERGENCE;
        for (size_t i = 0; i < count; i++)
            JLT_PASS(halves(self, of->table + index[i] * of->crossings, of->u[index[i]], of->crossings, i));
        *done += count;
        tell(self, "samples", *done, of->count);
    }
    return JLT_OK;
}

/* Whether h_(j+1) may touch zero next to sample i, between two samples of one sign: a parabola through three values goes below the
 * least of them by an eighth of their largest difference at most. */
static bool may_dip(const samples *of, size_t i, size_t j)
{
    if (i == 0 || i + 1 == of->count) return false;
    const double *here = of->table + i * of->crossings + j, least = fabs(*here);
    const double before = here[-(ptrdiff_t)of->crossings], after = here[of->crossings];
    if ((before > 0) != (*here > 0) || (after > 0) != (*here > 0)) return false;
    return least <= fabs(before) && least <= fabs(after) && least < (fmax(fabs(before), fabs(after)) - least) / 4;
}

/* Whether a zero between samples i and i + 1 may not be seen. */
static bool is_coarse(const samples *of, size_t i)
{
    for (size_t j = 0; j < of->crossings; j++) {
        const double a = of->table[i * of->crossings + j], b = of->table[(i + 1) * of->crossings + j];
        if (isnan(a) != isnan(b) || fabs(a - b) > step || may_dip(of, i, j) || may_dip(of, i + 1, j)) return true;
    }
    return false;
}

/* Put samples halfway where these are coarse. Out: *added, how many. */
static jlt_status refine(samples *of, size_t *added)
{
    const size_t width = of->crossings;
    JLT_FREED bool *coarse = calloc(of->count, sizeof *coarse);
    JLT_CLEARED(clear_samples) samples old = *of;
    size_t n = 0;

    *added = 0;
    *of = (samples){ .count = 0 };
    if (coarse == NULL) return JLT_ERR_NOMEM;
    for (size_t i = 0; i + 1 < old.count; i++) *added += coarse[i] = is_coarse(&old, i);
    if (!make_samples(of, old.count + *added, width)) return JLT_ERR_NOMEM;
    for (size_t i = 0; i < old.count; i++) {
        of->u[n] = old.u[i];
        memcpy(of->table + n++ * width, old.table + i * width, width * sizeof *of->table);
        if (!coarse[i]) continue;
        of->u[n] = old.u[i] + (old.u[i + 1] - old.u[i]) / 2;
        of->table[n++ * width] = INFINITY;
    }
    return JLT_OK;
}

static jlt_status sample(const search *self, samples *of, size_t crossings)
{
    const jlt_symmetric_line *line = self->line;
    size_t done = 0;

    if (!make_samples(of, line->samples, crossings)) return JLT_ERR_NOMEM;
    for (size_t i = 0; i < of->count; i++) {
        of->u[i] = line->low + (line->high - line->low) * (double)i / (double)(of->count - 1);
        of->table[i * crossings] = INFINITY;
    }
    for (size_t wave = 0, added = 1; added > 0; wave++) {
        JLT_PASS(compute(self, of, &done));
        if (wave == WAVES || of->count * crossings > NUMBERS) break;
        JLT_PASS(refine(of, &added));
    }
    return JLT_OK;
}

/* Whether h_j changes sign between samples i and i + 1. */
static bool has_zero(const samples *of, size_t i, size_t j)
{
    const double a = of->table[i * of->crossings + j - 1], b = of->table[(i + 1) * of->crossings + j - 1];

    return !isnan(a) && !isnan(b) && (a > 0) != (b > 0);
}

/* Find the zeros between samples, and hand over the orbits through them. */
static jlt_status find_zeros(const search *self, const samples *of)
{
    const size_t crossings = of->crossings, returns = jlt_map_flow(self->map)->direction == JLT_BOTH ? 2 : 1;
    JLT_FREED double *work = malloc(crossings * sizeof *work);
    size_t done = 0, all = 0;

    if (work == NULL) return JLT_ERR_NOMEM;
    for (size_t j = 1; j <= crossings; j++)
        for (size_t i = 0; i + 1 < of->count; i++) all += has_zero(of, i, j);
    for (size_t j = 1; j <= crossings; j++)
        for (size_t i = 0; i + 1 < of->count; i++) {
            const double *h = of->table + i * crossings + j - 1;
            double root = 0;
            bool found;
            if (!has_zero(of, i, j)) continue;
            JLT_PASS(bisect(self, &root, &found, work, of->u[i], h[0], of->u[i + 1], h[crossings], j));
            if (found) JLT_PASS(deliver(self, root, returns * j));
            tell(self, "zeros", ++done, all);
        }
    return JLT_OK;
}

jlt_status jlt_symmetric_search(jlt_map *map, const jlt_symmetric_line *line, size_t period_max, const jlt_kernel_batch *kernels,
                                unsigned threads, const jlt_symmetric_sink *sink)
{
    const jlt_flow *flow = jlt_map_flow(map);
    const jlt_chart *chart = flow->chart;
    search self = { .map = map, .line = line, .mirrored = JLT_CHART_DIM_MAX, .sink = sink };
    jlt_flow both = *flow;
    jlt_status st = JLT_OK;
    JLT_CLEARED(clear_samples) samples of = { .count = 0 };
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
    JLT_TRY(sample(&self, &of, crossings));
    JLT_TRY(find_zeros(&self, &of));
done:
    jlt_section_batch_destroy(self.many);
    jlt_section_destroy(self.both);
    return st;
}
