#include "dynamics/branch_area.h"

#include "core/memory.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/* Tolerated error of a piece's area, in scaled coordinates. */
static const double enough = 1e-11;

/* Gauss-Legendre nodes and weights on [0, 1]; node[MIDDLE] is the midpoint. */
enum { NODES = 5, MIDDLE = 2 };
static const double node[NODES] = { 0.04691007703066800, 0.23076534494715845, 0.5, 0.76923465505284155, 0.95308992296933200 },
                    weight[NODES] = { 0.11846344252809454, 0.23931433524968324, 0.28444444444444444, 0.23931433524968324,
                                      0.11846344252809454 };

/* Corners through which a piece is interpolated; fewer, for the error estimate; how often pieces are halved at most. */
enum { CORNERS = 8, FEWER = 6, REFINEMENTS = 16 };

/* A point of the branch, and the piece from there to the next joint. */
typedef struct {
    double sigma, q[2], area; /* area: between the piece and its chord; NaN: the branch has no point there */
    double error;             /* of area: its change by fewer corners, or by the tangents' displacement in place of the chord */
    double gap;               /* while open, of the piece that this is half of, as of `part` */
    size_t index;             /* of a requested point, else SIZE_MAX */
    bool ends;                /* a fundamental domain ends; the piece is the jump, O(seed) along the branch, to the next one */
    bool is_open;             /* the piece is not integrated yet */
} joint;

static int compare(const void *left, const void *right)
{
    const joint *a = left, *b = right;

    return a->sigma != b->sigma ? (a->sigma > b->sigma) - (a->sigma < b->sigma) : b->ends - a->ends;
}

static void add(joint *list, size_t *count, double sigma, const double *q, size_t index)
{
    list[*count] = (joint){ .sigma = sigma, .index = index, .gap = INFINITY };
    memcpy(list[(*count)++].q, q, sizeof list->q);
}

/* Make the joints in order along the branch, from the first requested point to the last: these points, the polygon's corners, and
 * the ends and beginnings of fundamental domains, whose q find_ends sets. The caller frees the list. */
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
    for (size_t i = 0; i < curve->count; i++) {
        const double at = curve->sigma[i];
        if (at > low && at < high && at != floor(at)) add(list, &n, at, curve->points + 2 * i, SIZE_MAX);
    }
    for (double whole = floor(low) + 1; whole < high; whole++) {
        add(list, &n, whole, (const double[]){ 0, 0 }, SIZE_MAX);
        list[n - 1].ends = true;
        add(list, &n, nextafter(whole, INFINITY), (const double[]){ 0, 0 }, SIZE_MAX);
    }
    qsort(list, n, sizeof *list, compare);
    *joint_count = n;
    return list;
}

static double cross(const double *a, const double *b) { return a[0] * b[1] - a[1] * b[0]; }

/* Collect the joints through which the piece from joint k is interpolated, nearest first: corners, and the ends of the fundamental
 * domain, where the parametrization jumps by O(seed); no requested points, nor joints that almost coincide. Returns how many. */
static unsigned corners_about(size_t *corners, const joint *list, size_t joint_count, size_t k)
{
    const double apart = 1e-3 * (list[k + 1].sigma - list[k].sigma);
    double low = INFINITY, high = -INFINITY;
    size_t left = k + 1, right = k + 1; /* the next to the left is left - 1 */
    bool is_left = true, is_right = true;
    unsigned count = 0;

    while (count < CORNERS && (is_left || is_right)) {
        const bool goes_left = is_left && (!is_right || count % 2 == 0);
        const size_t i = goes_left ? --left : right++;
        if (goes_left) is_left = left > 0 && !list[left - 1].ends;
        else is_right = right < joint_count && !list[i].ends;
        if (list[i].index != SIZE_MAX || !(list[i].sigma < low - apart || list[i].sigma > high + apart)) continue;
        low = fmin(low, list[i].sigma);
        high = fmax(high, list[i].sigma);
        corners[count++] = i;
    }
    return count;
}

/* Replace the values of two functions at the nodes `at`, shape (CORNERS,), by Newton's divided differences. */
static void divide(double values[CORNERS][2], const double *at)
{
    for (int order = 1; order < CORNERS; order++)
        for (int i = CORNERS - 1; i >= order; i--)
            for (int c = 0; c < 2; c++) values[i][c] = (values[i][c] - values[i - 1][c]) / (at[i] - at[i - order]);
}

static void evaluate(double *value, double *slope, double divided[CORNERS][2], const double *at, int count, double t)
{
    for (int c = 0; c < 2; c++) {
        value[c] = divided[count - 1][c];
        slope[c] = 0;
        for (int i = count - 2; i >= 0; i--) {
            slope[c] = slope[c] * (t - at[i]) + value[c];
            value[c] = value[c] * (t - at[i]) + divided[i][c];
        }
    }
}

/* Set a joint's area, between the interpolating polynomial on [0, 1] and its chord, and the error. Returns the largest distance,
 * scaled, between that polynomial and the one through fewer corners. */
static double polynomial_area(joint *of, double divided[CORNERS][2], const double *at, const jlt_chart *chart)
{
    double start[2], value[2], slope[2], fewer[2], fewer_slope[2], fewer_area = 0, apart = 0;

    of->area = 0;
    evaluate(start, slope, divided, at, CORNERS, 0);
    for (int j = 0; j < NODES; j++) {
        evaluate(fewer, fewer_slope, divided, at, FEWER, node[j]);
        evaluate(value, slope, divided, at, CORNERS, node[j]);
        for (int c = 0; c < 2; c++) value[c] -= start[c], fewer[c] -= start[c];
        of->area += weight[j] * cross(value, slope) / 2;
        fewer_area += weight[j] * cross(fewer, fewer_slope) / 2;
        for (int c = 0; c < 2; c++) fewer[c] -= value[c];
        jlt_chart_scaled(chart, fewer, fewer);
        apart = fmax(apart, hypot(fewer[0], fewer[1]));
    }
    of->error = fabs(of->area - fewer_area);
    return apart;
}

/* Set the area of the piece from joint k to the next by interpolation. Returns false, and sets the gap alone, if the piece is to
 * be halved. It is not if the polynomials through more and through fewer corners agree to `enough`, and the first has the piece's
 * ends; or if the gap between them was at most `tolerance`, the least error of points, before the last halving, which reduced it
 * by less than a factor of 8, where 2^6 is the rule; or if the piece is no wider than `unseen`. */
static bool interpolate(joint *list, size_t joint_count, size_t k, const jlt_chart *chart, double tolerance, double unseen)
{
    const double from = list[k].sigma, width = list[k + 1].sigma - from;
    size_t corners[CORNERS];
    double at[CORNERS], divided[CORNERS][2], chord[2], off[2], slope[2];
    joint tried = list[k];

    if (corners_about(corners, list, joint_count, k) < CORNERS) return false;
    for (int i = 0; i < CORNERS; i++) {
        if (isnan(list[corners[i]].area)) return false;
        at[i] = (list[corners[i]].sigma - from) / width;
        jlt_chart_difference(chart, divided[i], list[corners[i]].q, list[k].q);
    }
    divide(divided, at);
    jlt_chart_difference(chart, chord, list[k + 1].q, list[k].q);
    double gap = polynomial_area(&tried, divided, at, chart);
    for (int end = 0; end < 2; end++) {
        evaluate(off, slope, divided, at, CORNERS, end);
        for (int c = 0; c < 2; c++) off[c] -= end * chord[c];
        jlt_chart_scaled(chart, off, off);
        gap = fmax(gap, hypot(off[0], off[1]));
    }
    jlt_chart_scaled(chart, chord, chord);
    const double length = hypot(chord[0], chord[1]);
    const bool done = gap * length <= enough || gap > tried.gap / 8 || width <= unseen;
    if (gap * length > enough) tried.error = fmax(tried.error, gap * length);
    if (done) list[k] = tried;
    list[k].gap = gap <= tolerance ? gap : INFINITY;
    return done;
}

/* Arguments of jlt_branch_points for count points of one branch. */
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
    if (self->sigma == NULL || self->branches == NULL || self->status == NULL) return JLT_ERR_NOMEM;
    self->q = self->sigma + count;
    self->tangent = self->q + 2 * count;
    for (size_t i = 0; i < count; i++) self->branches[i] = branch;
    return JLT_OK;
}

/* Interpolate all pieces; where that fails, add a corner in the middle, up to REFINEMENTS times. Pieces that still fail stay open.
 * A point without its tangent costs a fifth of one with it. */
static jlt_status refine(joint **list, size_t *count, const jlt_branch *branch, double tolerance)
{
    const jlt_chart *chart = jlt_map_flow(branch->map)->chart;
    const double unseen = jlt_branch_blur(branch, tolerance);

    for (size_t k = 0; k + 1 < *count; k++) (*list)[k].is_open = !(*list)[k].ends && (*list)[k].sigma < (*list)[k + 1].sigma;
    for (int round = 0; round <= REFINEMENTS; round++) {
        size_t left = 0, n = 0;
        for (size_t k = 0; k + 1 < *count; k++)
            if ((*list)[k].is_open) left += (*list)[k].is_open = !interpolate(*list, *count, k, chart, tolerance, unseen);
        if (left == 0 || round == REFINEMENTS) return JLT_OK;
        JLT_CLEARED(clear_samples) samples middles = { 0 };
        JLT_PASS(make_samples(&middles, left, branch));
        joint *finer = calloc(*count + left, sizeof *finer);
        if (finer == NULL) return JLT_ERR_NOMEM;
        for (size_t k = 0, of = 0; k + 1 < *count; k++)
            if ((*list)[k].is_open) middles.sigma[of++] = (*list)[k].sigma + ((*list)[k + 1].sigma - (*list)[k].sigma) / 2;
        const jlt_status st = jlt_branch_curve(middles.branches, middles.status, middles.q, middles.sigma, left);
        for (size_t k = 0, of = 0; k < *count; k++) {
            finer[n++] = (*list)[k];
            if (!(*list)[k].is_open) continue;
            joint *middle = &finer[n++];
            *middle = (joint){ .sigma = middles.sigma[of], .index = SIZE_MAX, .is_open = true, .gap = finer[n - 2].gap };
            memcpy(middle->q, middles.q + 2 * of, sizeof middle->q);
            if (middles.status[of++] != JLT_OK) middle->area = NAN;
        }
        free(*list);
        *list = finer;
        *count = n;
        JLT_PASS(st);
    }
    return JLT_OK;
}

/* A part of a joint's piece, to be integrated with tangents. */
typedef struct {
    double sigma[2], q[2][2];
    double gap; /* of the part that this is half of: distance between its end and where its integrated tangents lead; INFINITY if
                   that is too large to tell the order of convergence */
    size_t joint;
} part;

static jlt_status take_samples(samples *self, jlt_map_batch *maps)
{
    return jlt_branch_points(self->branches, maps, self->status, self->q, self->tangent, self->sigma, self->count);
}

/* Set q of the joints where fundamental domains end and begin. */
static jlt_status find_ends(joint *list, size_t joint_count, const jlt_branch *branch, jlt_map_batch *maps)
{
    JLT_CLEARED(clear_samples) samples s = { 0 };
    size_t i = 0;

    JLT_PASS(make_samples(&s, joint_count, branch));
    for (size_t k = 0; k < joint_count; k++)
        if (list[k].ends || (k > 0 && list[k - 1].ends)) s.sigma[i++] = list[k].sigma;
    s.count = i;
    const jlt_status st = take_samples(&s, maps);
    for (size_t k = 0, of = 0; st == JLT_OK && of < i; k++) {
        if (!list[k].ends && !(k > 0 && list[k - 1].ends)) continue;
        if (s.status[of] != JLT_OK) list[k].area = NAN;
        else memcpy(list[k].q, s.q + 2 * of, sizeof list[k].q);
        of++;
    }
    return st;
}

/* Add the area of a part to its joint's; q, tangent: at the part's nodes. Returns true if the integrated tangents lead to the
 * part's end to the tolerance; or if halving has reduced the gap to the end by less than a factor of 8, where 2^11 is the rule, so
 * that only errors of the points are left; or if the part is no wider than `unseen`. Returns false if the part is to be halved: the
 * area added is then that between its chord and those of its halves. */
static bool integrate(joint *of, part *p, const double *q, const double *tangent, const jlt_chart *chart, double tolerance,
                      double unseen)
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
    const bool done = gap * length <= enough || gap > p->gap / 8 || width <= unseen;
    p->gap = gap <= fmax(length / 1000, tolerance) ? gap : INFINITY;
    jlt_chart_difference(chart, from, q + 2 * MIDDLE, p->q[0]);
    jlt_chart_difference(chart, step, p->q[1], q + 2 * MIDDLE);
    of->area += done ? area : cross(from, step) / 2;
    if (done) of->error += fabs(cross(chord, led) / 2);
    return done;
}

/* Integrate all parts, and their halves until none is to be halved. */
static jlt_status integrate_all(joint *list, part *parts, size_t count, const jlt_branch *branch, jlt_map_batch *maps)
{
    const jlt_chart *chart = jlt_map_batch_flow(maps)->chart;
    const double tolerance = jlt_map_batch_tolerance(maps);
    const double unseen = jlt_branch_blur(branch, tolerance);
    part *now = parts;
    jlt_status st = JLT_OK;

    while (st == JLT_OK && count > 0) {
        JLT_CLEARED(clear_samples) samples s = { 0 };
        size_t left = 0;
        part *next = calloc(2 * count, sizeof *next);
        st = next != NULL ? make_samples(&s, NODES * count, branch) : JLT_ERR_NOMEM;
        for (size_t i = 0; st == JLT_OK && i < NODES * count; i++) {
            const part *p = &now[i / NODES];
            s.sigma[i] = p->sigma[0] + node[i % NODES] * (p->sigma[1] - p->sigma[0]);
        }
        if (st == JLT_OK) st = take_samples(&s, maps);
        for (size_t i = 0; st == JLT_OK && i < count; i++) {
            const double *q = s.q + 2 * NODES * i, *middle = q + 2 * MIDDLE;
            bool known = true;
            for (int j = 0; j < NODES; j++) known = known && s.status[NODES * i + (size_t)j] == JLT_OK;
            if (!known) list[now[i].joint].area = NAN;
            const double *tangent = s.tangent + 2 * NODES * i;
            if (!known || integrate(&list[now[i].joint], &now[i], q, tangent, chart, tolerance, unseen)) continue;
            for (int k = 0; k < 2; k++) {
                part *half = &next[left++];
                *half = now[i];
                half->sigma[1 - k] = s.sigma[NODES * i + MIDDLE];
                memcpy(half->q[1 - k], middle, sizeof half->q[1 - k]);
            }
        }
        if (now != parts) free(now);
        now = next;
        count = left;
    }
    if (now != parts) free(now);
    return st;
}

jlt_status jlt_branch_area_to(jlt_branch_area *areas, const jlt_branch *branch, const jlt_manifold *curve, const double *sigma,
                              const double *q, size_t count, jlt_map_batch *maps)
{
    const jlt_chart *chart = jlt_map_batch_flow(maps)->chart;
    const double tolerance = jlt_map_batch_tolerance(maps);
    const int units = chart->scale[0] + chart->scale[1]; /* of areas */
    size_t joint_count = 0, part_count = 0;
    jlt_branch_area now = { .area = 0 };

    if (count == 0) return JLT_OK;
    JLT_FREED joint *list = joints_of(&joint_count, curve, sigma, q, count);
    if (list == NULL) return JLT_ERR_NOMEM;
    JLT_PASS(find_ends(list, joint_count, branch, maps));
    JLT_PASS(refine(&list, &joint_count, branch, tolerance));
    JLT_FREED part *parts = calloc(joint_count, sizeof *parts);
    if (parts == NULL) return JLT_ERR_NOMEM;
    for (size_t k = 0; k + 1 < joint_count; k++) {
        if (!list[k].is_open) continue;
        part *p = &parts[part_count];
        for (int c = 0; c < 2; c++) {
            p->sigma[c] = list[k + (size_t)c].sigma;
            memcpy(p->q[c], list[k + (size_t)c].q, sizeof p->q[c]);
        }
        p->gap = INFINITY;
        parts[part_count++].joint = k;
    }
    JLT_PASS(integrate_all(list, parts, part_count, branch, maps));
    for (size_t k = 0; k < joint_count; k++) {
        double chord[2];
        if (list[k].index != SIZE_MAX) areas[list[k].index] = now;
        if (k + 1 == joint_count) break;
        jlt_chart_difference(chart, chord, list[k + 1].q, list[k].q);
        now.area += list[k].area + cross(now.at, chord) / 2;
        now.error += list[k].error + ldexp(tolerance * jlt_chart_distance(chart, list[k].q, list[k + 1].q), units);
        for (int c = 0; c < 2; c++) now.at[c] += chord[c];
    }
    return JLT_OK;
}

double jlt_branch_area_between(const jlt_branch_area *from, const jlt_branch_area *to)
{
    const double chord[2] = { to->at[0] - from->at[0], to->at[1] - from->at[1] };

    return to->area - from->area - cross(from->at, chord) / 2;
}

jlt_branch_area jlt_branch_area_mirrored(const jlt_branch_area *area, const jlt_chart *chart)
{
    const int *sign = chart->mirror;

    return (jlt_branch_area){ .at = { sign[0] * area->at[0], sign[1] * area->at[1] }, .area = sign[0] * sign[1] * area->area,
                              .error = area->error };
}
