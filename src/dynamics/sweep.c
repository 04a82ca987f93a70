#include "dynamics/sweep.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>


/* A part of a branch is short enough where what tangents lead past its end by, times its length, is no more: an area, in squares of
 * the coordinates' sizes. */
static const double enough = 1e-11;

/* Nodes and weights of Gauss on [0, 1]; one node is the middle. */
enum { NODES = 5, MIDDLE = 2 };
static const double node[NODES] = { 0.04691007703066800, 0.23076534494715845, 0.5, 0.76923465505284155, 0.95308992296933200 },
                    weight[NODES] = { 0.11846344252809454, 0.23931433524968324, 0.28444444444444444, 0.23931433524968324,
                                      0.11846344252809454 };

/* So many sides of the polygon are integrated at once: they turn by 0.8, as far as they turn by the default at most. */
enum { SIDES = 4 };

/* The point of a piece of the branch, from the joint to the next one, that is first. */
typedef struct {
    double sigma, q[2], area; /* area: between the piece and its chord */
    size_t index;             /* of a point that was asked for, else SIZE_MAX */
    bool ends;                /* a fundamental domain ends, and the piece is the step to the next, by O(seed) along the branch */
} joint;

static int compare(const void *left, const void *right)
{
    const joint *a = left, *b = right;

    return a->sigma != b->sigma ? (a->sigma > b->sigma) - (a->sigma < b->sigma) : b->ends - a->ends;
}

static void add(joint *list, size_t *count, double sigma, const double *q, size_t index)
{
    list[*count] = (joint){ .sigma = sigma, .index = index };
    memcpy(list[(*count)++].q, q, sizeof list->q);
}

/* In order along the branch, from the first of the points to the last, for free(): the points, corners of the polygon, and where
 * fundamental domains end and begin, whose q are to be found. */
static joint *joints_of(size_t *joint_count, const jlt_manifold *curve, const double *sigma, const double *q, size_t count)
{
    double low = INFINITY, high = -INFINITY;
    size_t n = 0;

    for (size_t i = 0; i < count; i++) {
        low = fmin(low, sigma[i]);
        high = fmax(high, sigma[i]);
    }
    joint *list = calloc(count + curve->count + 2 * (size_t)(high - low) + 3, sizeof *list);
    if (list == NULL) return NULL;
    for (size_t i = 0; i < count; i++) add(list, &n, sigma[i], q + 2 * i, i);
    for (size_t i = 0; i < curve->count; i += SIDES)
        if (curve->sigma[i] > low && curve->sigma[i] < high) add(list, &n, curve->sigma[i], curve->points + 2 * i, SIZE_MAX);
    for (double whole = floor(low) + 1; whole < high; whole++) {
        add(list, &n, whole, (const double[]){ 0, 0 }, SIZE_MAX);
        list[n - 1].ends = true;
        add(list, &n, nextafter(whole, INFINITY), (const double[]){ 0, 0 }, SIZE_MAX);
    }
    qsort(list, n, sizeof *list, compare);
    *joint_count = n;
    return list;
}

/* A part of the piece of a joint that is to be integrated. */
typedef struct {
    double sigma[2], q[2][2];
    double gap; /* between the part's end and where tangents lead, of what it is a half of; infinite where that tells no order */
    size_t joint;
} part;

/* Points of the branch with tangents, of which there are count, as jlt_branch_points has them. */
typedef struct {
    double *sigma, *q, *tangent;
    const jlt_branch **branches;
    jlt_status *status;
    size_t count;
} samples;

static void clear_samples(samples *self)
{
    free(self->sigma);
    free(self->branches);
    free(self->status);
}

static jlt_status make_samples(samples *self, size_t count, const jlt_branch *branch)
{
    *self = (samples){ .sigma = calloc(5 * count + 1, sizeof *self->sigma),
                       .branches = calloc(count + 1, sizeof(jlt_branch *)),
                       .status = calloc(count + 1, sizeof *self->status),
                       .count = count };
    if (self->sigma == NULL || self->branches == NULL || self->status == NULL) {
        clear_samples(self);
        return JLT_ERR_NOMEM;
    }
    self->q = self->sigma + count;
    self->tangent = self->q + 2 * count;
    for (size_t i = 0; i < count; i++) self->branches[i] = branch;
    return JLT_OK;
}

static jlt_status take_samples(samples *self, jlt_map_batch *maps)
{
    return jlt_branch_points(self->branches, maps, self->status, self->q, self->tangent, self->sigma, self->count);
}

/* Where fundamental domains end and begin. */
static jlt_status find_ends(joint *list, size_t joint_count, const jlt_branch *branch, jlt_map_batch *maps)
{
    samples s;
    size_t i = 0;
    jlt_status st = make_samples(&s, joint_count, branch);

    if (st != JLT_OK) return st;
    for (size_t k = 0; k < joint_count; k++)
        if (list[k].ends || (k > 0 && list[k - 1].ends)) s.sigma[i++] = list[k].sigma;
    s.count = i;
    st = take_samples(&s, maps);
    for (size_t k = 0, of = 0; st == JLT_OK && of < i; k++) {
        if (!list[k].ends && !(k > 0 && list[k - 1].ends)) continue;
        if (s.status[of] != JLT_OK) list[k].area = NAN;
        else memcpy(list[k].q, s.q + 2 * of, sizeof list[k].q);
        of++;
    }
    clear_samples(&s);
    return st;
}

static double cross(const double *a, const double *b) { return a[0] * b[1] - a[1] * b[0]; }

/* The area of a part, into its joint's; false where it is to be halved, and the area is that between its chord and those of the
 * halves. It is not where half of a part that is nearly straight is hardly better than that: halves would be by 2^11, so that what
 * is left are errors of the points. In: what was found at its nodes, from the first one on. */
static bool integrate(joint *of, part *p, const double *q, const double *tangent, const jlt_chart *chart)
{
    const double width = p->sigma[1] - p->sigma[0];
    double chord[2], led[2] = { 0, 0 }, area = 0, length = 0, from[2], step[2];

    jlt_chart_difference(chart, chord, p->q[1], p->q[0]);
    for (int j = 0; j < NODES; j++) {
        for (int c = 0; c < 2; c++) step[c] = weight[j] * width * tangent[2 * j + c];
        jlt_chart_difference(chart, from, q + 2 * j, p->q[0]);
        area += cross(from, step) / 2;
        for (int c = 0; c < 2; c++) led[c] += step[c];
        jlt_chart_scaled(chart, step, step);
        length += hypot(step[0], step[1]);
    }
    for (int c = 0; c < 2; c++) led[c] -= chord[c];
    jlt_chart_scaled(chart, led, led);
    const double gap = hypot(led[0], led[1]);
    const bool done = gap * length <= enough || gap > p->gap / 8;
    p->gap = gap <= length / 1000 ? gap : INFINITY;
    jlt_chart_difference(chart, from, q + 2 * MIDDLE, p->q[0]);
    jlt_chart_difference(chart, step, p->q[1], q + 2 * MIDDLE);
    of->area += done ? area : cross(from, step) / 2;
    return done;
}

/* All parts that are left, and their halves as far as there have to be any. */
static jlt_status integrate_all(joint *list, part *parts, size_t count, const jlt_branch *branch, jlt_map_batch *maps)
{
    const jlt_chart *chart = jlt_map_batch_flow(maps)->chart;
    part *now = parts;
    jlt_status st = JLT_OK;

    while (st == JLT_OK && count > 0) {
        samples s;
        size_t left = 0;
        part *next = calloc(2 * count, sizeof *next);
        st = next != NULL ? make_samples(&s, NODES * count, branch) : JLT_ERR_NOMEM;
        for (size_t i = 0; st == JLT_OK && i < NODES * count; i++) {
            const part *p = &now[i / NODES];
            s.sigma[i] = p->sigma[0] + node[i % NODES] * (p->sigma[1] - p->sigma[0]);
        }
        if (st == JLT_OK && (st = take_samples(&s, maps)) != JLT_OK) clear_samples(&s);
        for (size_t i = 0; st == JLT_OK && i < count; i++) {
            const double *q = s.q + 2 * NODES * i, *middle = q + 2 * MIDDLE;
            bool known = true;
            for (int j = 0; j < NODES; j++) known = known && s.status[NODES * i + (size_t)j] == JLT_OK;
            if (!known) list[now[i].joint].area = NAN;
            if (!known || integrate(&list[now[i].joint], &now[i], q, s.tangent + 2 * NODES * i, chart)) continue;
            for (int k = 0; k < 2; k++) {
                part *half = &next[left++];
                *half = now[i];
                half->sigma[1 - k] = s.sigma[NODES * i + MIDDLE];
                memcpy(half->q[1 - k], middle, sizeof half->q[1 - k]);
            }
        }
        if (st == JLT_OK) clear_samples(&s);
        if (now != parts) free(now);
        now = next;
        count = left;
    }
    if (now != parts) free(now);
    return st;
}

jlt_status jlt_sweep_to(jlt_sweep *sweeps, const jlt_branch *branch, const jlt_manifold *curve, const double *sigma,
                        const double *q, size_t count, jlt_map_batch *maps)
{
    const jlt_chart *chart = jlt_map_batch_flow(maps)->chart;
    size_t joint_count = 0, part_count = 0;
    part *parts = NULL;
    jlt_sweep now = { .area = 0 };
    jlt_status st = JLT_OK;

    if (count == 0) return JLT_OK;
    joint *list = joints_of(&joint_count, curve, sigma, q, count);
    if (list == NULL || (parts = calloc(joint_count, sizeof *parts)) == NULL) st = JLT_ERR_NOMEM;
    if (st == JLT_OK) st = find_ends(list, joint_count, branch, maps);
    for (size_t k = 0; st == JLT_OK && k + 1 < joint_count; k++) {
        part *p = &parts[part_count];
        if (list[k].ends || !(list[k].sigma < list[k + 1].sigma)) continue;
        for (int c = 0; c < 2; c++) {
            p->sigma[c] = list[k + (size_t)c].sigma;
            memcpy(p->q[c], list[k + (size_t)c].q, sizeof p->q[c]);
        }
        p->gap = INFINITY;
        parts[part_count++].joint = k;
    }
    if (st == JLT_OK) st = integrate_all(list, parts, part_count, branch, maps);
    for (size_t k = 0; st == JLT_OK && k < joint_count; k++) {
        double chord[2];
        if (list[k].index != SIZE_MAX) sweeps[list[k].index] = now;
        if (k + 1 == joint_count) break;
        jlt_chart_difference(chart, chord, list[k + 1].q, list[k].q);
        now.area += list[k].area + cross(now.at, chord) / 2;
        for (int c = 0; c < 2; c++) now.at[c] += chord[c];
    }
    free(parts);
    free(list);
    return st;
}

double jlt_sweep_between(const jlt_sweep *from, const jlt_sweep *to)
{
    const double chord[2] = { to->at[0] - from->at[0], to->at[1] - from->at[1] };

    return to->area - from->area - cross(from->at, chord) / 2;
}

jlt_sweep jlt_sweep_mirrored(const jlt_sweep *sweep, const jlt_chart *chart)
{
    const int *sign = chart->mirror;

    return (jlt_sweep){ .at = { sign[0] * sweep->at[0], sign[1] * sweep->at[1] }, .area = sign[0] * sign[1] * sweep->area };
}
