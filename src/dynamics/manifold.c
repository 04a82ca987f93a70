#include "dynamics/manifold.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/memory.h"

/* Parameter steps are not halved below this: the branch ends where that would be needed. */
static const double smallest_step = 1e-9;

void jlt_manifold_clear(jlt_manifold *self)
{
    free(self->points);
    free(self->sigma);
    free(self->length);
    *self = (jlt_manifold){ .count = 0 };
}

static jlt_status reserve(jlt_manifold *self, size_t count)
{
    self->points = malloc(count * 2 * sizeof *self->points);
    self->sigma = malloc(count * sizeof *self->sigma);
    self->length = malloc(count * sizeof *self->length);
    return self->points != NULL && self->sigma != NULL && self->length != NULL ? JLT_OK : JLT_ERR_NOMEM;
}

static void append(jlt_manifold *self, const jlt_chart *chart, const double *q, double sigma)
{
    const size_t n = self->count;

    self->length[n] = n == 0 ? 0 : self->length[n - 1] + jlt_chart_distance(chart, q, self->points + 2 * (n - 1));
    memcpy(self->points + 2 * n, q, 2 * sizeof *q);
    self->sigma[n] = sigma;
    self->count++;
}

typedef struct {
    double sigma, q[2];
    bool is_known;
    jlt_status status; /* of a known point */
} corner;

/* A branch that is being grown, with its polygon and the stretch beyond it: whole fundamental domains. */
typedef struct {
    const jlt_branch *branch;
    const jlt_chart *chart;
    const jlt_manifold_options *options;
    double width, longest; /* of the stretch, and of its first steps, in sigma */
    jlt_manifold curve;
    corner *list; /* owned */
    size_t count;
    double greatest; /* length of a stretch so far */
    double returns;  /* made for all points so far */
    bool is_last;   /* the branch ends with this stretch, */
    bool is_over;   /* or before it: nothing is left to do */
} stretch;

/* Point k of the stretch; 0 is the polygon's last point, from which it goes on. */
static const double *point_at(const stretch *self, size_t k)
{
    return k > 0 ? self->list[k - 1].q : self->curve.points + 2 * (self->curve.count - 1);
}

static double sigma_at(const stretch *self, size_t k)
{
    return k > 0 ? self->list[k - 1].sigma : self->curve.sigma[self->curve.count - 1];
}

/* Angle by which the polygon turns at point k. */
static double turn_at(const stretch *self, size_t k)
{
    const double *here = point_at(self, k);
    double before[2], after[2];

    if ((k == 0 && self->curve.count < 2) || k == self->count || self->list[k].status != JLT_OK) return 0;
    jlt_chart_difference(self->chart, before, here, k > 0 ? point_at(self, k - 1) : here - 2);
    jlt_chart_difference(self->chart, after, point_at(self, k + 1), here);
    jlt_chart_scaled(self->chart, before, before);
    jlt_chart_scaled(self->chart, after, after);
    return fabs(atan2(before[0] * after[1] - before[1] * after[0], before[0] * after[0] + before[1] * after[1]));
}

/* Whether the polygon is too coarse before corner k. */
static bool is_coarse(const stretch *self, size_t k)
{
    const double distance = jlt_chart_distance(self->chart, point_at(self, k + 1), point_at(self, k)), turn = self->options->turn;

    if (self->list[k].status != JLT_OK) return true; /* the branch ends on the way there */
    if (!(distance > self->options->finest)) return false;
    return distance > self->options->spacing || turn_at(self, k) > turn || turn_at(self, k + 1) > turn;
}

static bool is_finest(const stretch *self, size_t k)
{
    return self->list[k].sigma - sigma_at(self, k) < smallest_step;
}

/* Leave the stretch out, and end the branch before it. */
static void stop(stretch *self, jlt_manifold_end end)
{
    self->curve.end = end;
    self->is_over = true;
}

/* End the branch with the first `count` points of the stretch. */
static void cut(stretch *self, size_t count, jlt_manifold_end end)
{
    self->curve.end = end;
    self->is_last = true;
    self->count = count;
}

/* Whether orbits with this status end, do not return, or grow without bound in finite time. */
static bool ends_orbits(jlt_status st)
{
    return st == JLT_ERR_DOMAIN || st == JLT_ERR_EMPTY || st == JLT_ERR_BUDGET || st == JLT_ERR_NO_PROGRESS
           || st == JLT_ERR_NONFINITE;
}

/* Cut the stretch after a point where orbits end, after the length asked for, before a point where the finest step is still too
 * coarse, and to the number of points asked for. */
static jlt_status cut_at_end(stretch *self)
{
    const size_t room = self->options->points_max - self->curve.count;
    double length = self->curve.length[self->curve.count - 1];

    for (size_t k = 0; k < self->count; k++) {
        const jlt_status st = self->list[k].status;
        if (ends_orbits(st)) cut(self, k + 1, JLT_MANIFOLD_POLE);
        else if (st != JLT_OK) return st;
        else length += jlt_chart_distance(self->chart, self->list[k].q, point_at(self, k));
        if (length >= self->options->length_max) cut(self, k + 1, JLT_MANIFOLD_LENGTH);
        if (st == JLT_OK && is_finest(self, k) && is_coarse(self, k)) cut(self, k, JLT_MANIFOLD_BLURRED);
    }
    if (self->count > room) cut(self, room, JLT_MANIFOLD_POINTS);
    return JLT_OK;
}

/* How many points are to be computed; none, and the branch ends, if they take more returns than a branch may. */
static size_t count_unknown(stretch *self)
{
    size_t n = 0;

    for (size_t k = 0; k < self->count && !self->is_over; k++) {
        if (self->list[k].is_known) continue;
        n++;
        self->returns += ceil(self->list[k].sigma) * (double)self->branch->returns;
    }
    if (self->returns > (double)self->options->points_max * JLT_MANIFOLD_RETURNS_A_POINT) stop(self, JLT_MANIFOLD_RETURNS);
    return self->is_over ? 0 : n;
}

/* Compute the points of all stretches that are not known yet. */
static jlt_status compute(stretch *all, size_t stretches)
{
    const volatile sig_atomic_t *interrupt = jlt_map_flow(all[0].branch->map)->interrupt;
    size_t count = 0, n = 0;

    for (size_t i = 0; i < stretches; i++) count += count_unknown(&all[i]);
    JLT_FREED double *sigma = calloc(3 * count + 1, sizeof *sigma); /* (count,), then q, (count, 2) */
    JLT_FREED jlt_status *status = calloc(count + 1, sizeof *status);
    JLT_FREED const jlt_branch **branches = calloc(count + 1, sizeof(jlt_branch *));
    JLT_FREED corner **of = calloc(count + 1, sizeof(corner *));
    double *q = sigma + count;

    if (sigma == NULL || status == NULL || branches == NULL || of == NULL) return JLT_ERR_NOMEM;
    for (size_t i = 0; i < stretches; i++)
        for (size_t k = 0; k < all[i].count && !all[i].is_over; k++) {
            if (all[i].list[k].is_known) continue;
            of[n] = &all[i].list[k];
            branches[n] = all[i].branch;
            sigma[n++] = all[i].list[k].sigma;
        }
    JLT_PASS(jlt_branch_curve(branches, status, q, sigma, count));
    for (size_t i = 0; i < count; i++)
        *of[i] = (corner){ .sigma = sigma[i], .q = { q[2 * i], q[2 * i + 1] }, .is_known = true, .status = status[i] };
    for (size_t i = 0; i < stretches && interrupt != NULL && *interrupt; i++)
        if (!all[i].is_over) stop(&all[i], JLT_MANIFOLD_INTERRUPT);
    return JLT_OK;
}

/* Add points halfway where the stretch is coarse. Out: how many. */
static jlt_status refine(stretch *self, size_t *added)
{
    corner *finer = calloc(2 * self->count + 1, sizeof *finer);
    size_t n = 0;

    if (finer == NULL) return JLT_ERR_NOMEM;
    for (size_t k = 0; k < self->count; k++) {
        const double before = sigma_at(self, k);
        if (!is_finest(self, k) && is_coarse(self, k)) finer[n++].sigma = before + (self->list[k].sigma - before) / 2;
        finer[n++] = self->list[k];
    }
    *added = n - self->count;
    free(self->list);
    self->list = finer;
    self->count = n;
    return JLT_OK;
}

/* Whether the last stretch, of this length, only shows errors of its points, although others were much longer. */
static bool has_settled(stretch *self, double length)
{
    self->greatest = fmax(self->greatest, length);
    return length <= 10 * jlt_map_flow(self->branch->map)->tolerance && length <= 1e-3 * self->greatest;
}

/* Add the stretch to the polygon, and go on to the next one, which begins at the images of as few points as the spacing allows:
 * steps in sigma stay below `longest`. */
static jlt_status advance(stretch *self)
{
    corner *images = calloc(self->count + 1, sizeof *images);
    const double *last = point_at(self, 0);
    const double before = self->curve.length[self->curve.count - 1];
    double sigma = sigma_at(self, 0);
    size_t n = 0;

    if (images == NULL) return JLT_ERR_NOMEM;
    for (size_t k = 0; k < self->count; k++) {
        const corner *at = &self->list[k];
        if (k + 1 < self->count && at[1].sigma - sigma <= self->longest && turn_at(self, k + 1) < self->options->turn / 2
            && jlt_chart_distance(self->chart, at[1].q, last) < self->options->spacing / 2) continue;
        last = at->q;
        sigma = at->sigma;
        images[n++].sigma = sigma + self->width;
    }
    for (size_t k = 0; k < self->count; k++)
        if (self->list[k].status == JLT_OK) append(&self->curve, self->chart, self->list[k].q, self->list[k].sigma);
    free(self->list);
    self->list = images;
    self->count = n;
    self->is_over = self->is_last || self->curve.count >= self->options->points_max;
    if (!self->is_over && has_settled(self, self->curve.length[self->curve.count - 1] - before)) stop(self, JLT_MANIFOLD_SETTLED);
    return JLT_OK;
}

static jlt_manifold_options with_defaults(const jlt_manifold_options *asked)
{
    jlt_manifold_options options = asked != NULL ? *asked : (jlt_manifold_options){ .spacing = 0 };

    if (options.spacing == 0) options.spacing = 0.01;
    if (options.turn == 0) options.turn = 0.2;
    if (options.finest == 0) options.finest = JLT_MANIFOLD_FINEST;
    if (options.length_max == 0) options.length_max = 5;
    if (options.points_max == 0) options.points_max = 20000;
    return options;
}

static jlt_status begin(stretch *self, const jlt_branch *branch, const jlt_manifold_options *options)
{
    /* several fundamental domains where each stretches the branch by less than a tenth */
    const double longest = 0.25 * fmax(1, 0.1 / log(branch->lambda)), width = ceil(4 * longest);
    double q[2];

    *self = (stretch){ .branch = branch, .chart = jlt_map_flow(branch->map)->chart, .options = options, .width = width,
                       .longest = longest, .curve = { .end = JLT_MANIFOLD_POINTS } };
    JLT_PASS(reserve(&self->curve, options->points_max));
    JLT_PASS(jlt_branch_point(branch, q, 0));
    append(&self->curve, self->chart, q, 0);
    self->count = (size_t)ceil(width / longest);
    self->list = calloc(self->count, sizeof *self->list);
    if (self->list == NULL) return JLT_ERR_NOMEM;
    for (size_t k = 0; k < self->count; k++) self->list[k].sigma = width * ((double)k + 0.5) / (double)self->count;
    return JLT_OK;
}

/* Refine a stretch whose points are known, or go on to the next one. */
static jlt_status go_on(stretch *self)
{
    size_t added = 0;

    JLT_PASS(cut_at_end(self));
    JLT_PASS(refine(self, &added));
    return added > 0 ? JLT_OK : advance(self);
}

static bool all_over(const stretch *all, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!all[i].is_over) return false;
    return true;
}

jlt_status jlt_manifold_grow(jlt_manifold *out, const jlt_branch *const *branches, size_t count, const jlt_manifold_options *asked)
{
    const jlt_manifold_options options = with_defaults(asked);
    stretch *all = calloc(count + 1, sizeof *all);
    jlt_status st = all != NULL ? JLT_OK : JLT_ERR_NOMEM;

    if (!(options.spacing > options.finest) || !(options.finest > 0) || !(options.turn > 0) || !(options.length_max > 0)
        || options.points_max < 2) st = JLT_ERR_ARG;
    for (size_t i = 0; st == JLT_OK && i < count; i++) st = begin(&all[i], branches[i], &options);
    while (st == JLT_OK && !all_over(all, count)) {
        st = compute(all, count);
        for (size_t i = 0; st == JLT_OK && i < count; i++)
            if (!all[i].is_over) st = go_on(&all[i]);
    }
    for (size_t i = 0; all != NULL && i < count; i++) {
        if (st == JLT_OK) out[i] = all[i].curve;
        else jlt_manifold_clear(&all[i].curve);
        free(all[i].list);
    }
    free(all);
    return st;
}

jlt_status jlt_manifold_reflect(jlt_manifold *out, const jlt_manifold *curve, const jlt_chart *chart)
{
    jlt_manifold self = { .count = curve->count, .end = curve->end };
    const jlt_status st = reserve(&self, curve->count + 1);

    if (st != JLT_OK) {
        jlt_manifold_clear(&self);
        return st;
    }
    for (size_t i = 0; i < curve->count; i++) jlt_chart_mirror(chart, self.points + 2 * i, curve->points + 2 * i);
    memcpy(self.sigma, curve->sigma, curve->count * sizeof *self.sigma);
    memcpy(self.length, curve->length, curve->count * sizeof *self.length);
    *out = self;
    return JLT_OK;
}
