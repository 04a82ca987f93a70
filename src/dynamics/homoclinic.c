#include "dynamics/homoclinic.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/memory.h"

static const double pi = 3.14159265358979323846;

/* A crossing's residual is at most this, and what rounding in one F moves its points along transverse branches. Below it Newton's
 * method, which squares residuals, has reached the errors of the map once a trial gains less than a factor of 8; more trials would
 * only pick the luckiest of those errors. */
static const double small_residual = 1e-8, rounding = 512 * DBL_EPSILON;

/* Whether the segments p + a u and r + b w, 0 <= a, b < 1, meet; sets a and b. */
static bool segments_cross(const jlt_chart *chart, double *a, double *b, const double *p, const double *p_next,
                           const double *r, const double *r_next)
{
    double u[2], w[2], gap[2], cross;

    jlt_chart_difference(chart, u, p_next, p);
    jlt_chart_difference(chart, w, r_next, r);
    jlt_chart_difference(chart, gap, r, p);
    cross = u[0] * w[1] - u[1] * w[0];
    if (cross == 0) return false;
    *a = (gap[0] * w[1] - gap[1] * w[0]) / cross;
    *b = (gap[0] * u[1] - gap[1] * u[0]) / cross;
    return *a >= 0 && *a < 1 && *b >= 0 && *b < 1;
}

/* Newton's method on gamma_u(sigma_u) = gamma_s(sigma_s), for one crossing. */
typedef struct {
    jlt_homoclinic best;
    double sigma[2]; /* of the next trial, on the unstable and on the stable branch */
    double sway;     /* by how much rounding in one F moves the points of `best` along the branches, times the sine between them */
    double enough;   /* iteration ends at a residual that is not above this */
    bool has_twin;   /* its mirror image is another crossing of the same branches */
    bool goes_on;
    jlt_status status; /* of the last trial */
} refinement;

static void begin_refinement(refinement *self, const jlt_homoclinic *at)
{
    *self = (refinement){ .best = *at, .sigma = { at->sigma_unstable, at->sigma_stable }, .goes_on = true };
    self->best.residual = INFINITY;
}

static double scaled_length(const double *v, const jlt_chart *chart)
{
    return hypot(ldexp(v[0], -chart->scale[0]), ldexp(v[1], -chart->scale[1]));
}

/* By how much a tangent's direction turns, in section coordinates, for a unit of error across it, in scaled ones. */
static double turn_of(const double *tangent, const jlt_chart *chart)
{
    const double ratio = scaled_length(tangent, chart) / hypot(tangent[0], tangent[1]);

    return ldexp(ratio * ratio, chart->scale[0] + chart->scale[1]);
}

/* Judge a trial by its points and tangents, shape (2, 2) each, on the unstable and on the stable branch, and set the next trial.
 * unseen: of either branch, the piece of sigma that shows rounding alone. */
static void take_step(refinement *self, const jlt_chart *chart, const double q[2][2], const double tangent[2][2],
                      const double unseen[2])
{
    const double *du = tangent[0], *ds = tangent[1], cross = du[0] * ds[1] - du[1] * ds[0];
    const double inner = du[0] * ds[0] + du[1] * ds[1];
    jlt_homoclinic *best = &self->best;
    double gap[2];

    jlt_chart_difference(chart, gap, q[1], q[0]);
    const double residual = scaled_length(gap, chart);
    self->goes_on = residual < best->residual * (residual > small_residual ? 1 : 0.125) && residual > self->enough;
    if (!(residual < best->residual)) return;
    best->residual = residual;
    best->sigma_unstable = self->sigma[0];
    best->sigma_stable = self->sigma[1];
    memcpy(best->q, q[0], sizeof best->q);
    best->turn = turn_of(du, chart) + turn_of(ds, chart);
    best->angle = inner > 0 || (inner == 0 && cross > 0) ? atan2(cross, inner) : atan2(-cross, -inner);
    self->sway = fabs(sin(best->angle)) * (unseen[0] * scaled_length(du, chart) + unseen[1] * scaled_length(ds, chart));
    /* u + du x = s + ds y */
    self->sigma[0] += (gap[0] * ds[1] - gap[1] * ds[0]) / cross;
    self->sigma[1] += (gap[0] * du[1] - gap[1] * du[0]) / cross;
    for (unsigned k = 0; k < 2; k++)
        if (!(self->sigma[k] >= 0 && isfinite(self->sigma[k]))) self->goes_on = false;
}

/* Room for one trial of each of count crossings. */
typedef struct {
    size_t *index;               /* (count,): the crossing of each */
    const jlt_branch **branches; /* (2 count,), as the arrays below: first on the unstable branch, then on the stable one */
    jlt_status *status;
    double *sigma, *q, *tangent; /* q and tangent: (2 count, 2) */
} trials;

static void clear_trials(trials *self)
{
    free(self->index);
    free(self->branches);
    free(self->status);
    free(self->sigma);
}

static jlt_status make_trials(trials *self, size_t count)
{
    *self = (trials){ .index = calloc(count + 1, sizeof *self->index),
                      .status = calloc(2 * count + 1, sizeof *self->status),
                      .branches = calloc(2 * count + 1, sizeof(jlt_branch *)),
                      .sigma = calloc(10 * count + 1, sizeof *self->sigma) };
    self->q = self->sigma + 2 * count;
    self->tangent = self->q + 4 * count;
    if (self->index != NULL && self->branches != NULL && self->status != NULL && self->sigma != NULL) return JLT_OK;
    clear_trials(self);
    return JLT_ERR_NOMEM;
}

/* Refine all crossings side by side, by at most so many iterations. branches: the unstable one, the stable one. */
static jlt_status refine(refinement *list, size_t count, const jlt_branch *const branches[2], jlt_map_batch *maps, int iterations)
{
    const jlt_chart *chart = jlt_map_batch_flow(maps)->chart;
    const double unseen[] = { jlt_branch_blur(branches[0], rounding), jlt_branch_blur(branches[1], rounding) };
    trials t;
    jlt_status st = make_trials(&t, count);

    if (st != JLT_OK) return st;
    for (int iteration = 0; iteration < iterations; iteration++) {
        size_t going = 0;
        for (size_t i = 0; i < count; i++)
            if (list[i].goes_on) t.index[going++] = i;
        if (going == 0) break;
        for (size_t i = 0; i < 2 * going; i++) {
            t.branches[i] = branches[i / going];
            t.sigma[i] = list[t.index[i % going]].sigma[i / going];
        }
        JLT_TRY(jlt_branch_points(t.branches, maps, t.status, t.q, t.tangent, t.sigma, 2 * going));
        for (size_t i = 0; i < going; i++) {
            refinement *at = &list[t.index[i]];
            double q[2][2], tangent[2][2];
            at->status = t.status[i] != JLT_OK ? t.status[i] : t.status[going + i];
            at->goes_on = at->status == JLT_OK;
            for (unsigned k = 0; k < 2 && at->goes_on; k++) {
                memcpy(q[k], t.q + 2 * (k * going + i), sizeof q[k]);
                memcpy(tangent[k], t.tangent + 2 * (k * going + i), sizeof tangent[k]);
            }
            if (at->goes_on) take_step(at, chart, (const double(*)[2])q, (const double(*)[2])tangent, unseen);
        }
    }
    for (size_t i = 0; i < count; i++)
        if (list[i].status == JLT_OK && !isfinite(list[i].best.residual)) list[i].status = JLT_ERR_NO_CONVERGENCE;
done:
    clear_trials(&t);
    return st;
}

/* Find the crossings again by other maps, on branches that are bent or begin near the saddle if asked, and put them into `again`.
 * angle_error becomes the largest change of the angle so far, NaN where a crossing is not found. Newton's method ends at three
 * times the residual that the point has. */
static jlt_status angles_again(jlt_homoclinic *points, size_t count, const jlt_branch *const branches[2], jlt_map_batch *maps,
                               bool bent, bool near, refinement *room)
{
    jlt_branch u = *branches[0], s = *branches[1];
    const jlt_branch *const others[] = { &u, &s };

    u.bent = s.bent = bent;
    u.near = s.near = near;
    for (size_t i = 0; i < count; i++) {
        begin_refinement(&room[i], &points[i]);
        for (unsigned k = 0; bent && k < 2; k++) room[i].sigma[k] = jlt_branch_bent_sigma(branches[k], room[i].sigma[k]);
        room[i].enough = 3 * points[i].residual;
    }
    JLT_PASS(refine(room, count, others, maps, 8));
    for (size_t i = 0; i < count; i++) {
        const double change = room[i].status == JLT_OK ? fabs(remainder(room[i].best.angle - points[i].angle, pi)) : NAN;
        if (isnan(change) || change > points[i].angle_error) points[i].angle_error = change;
        memcpy(points[i].again.q, room[i].best.q, sizeof points[i].again.q);
        points[i].again.sigma[0] = room[i].best.sigma_unstable;
        points[i].again.sigma[1] = room[i].best.sigma_stable;
    }
    return JLT_OK;
}

/* Set angle_error to twice the largest change of the angle by another tolerance, by a beginning nearer to the saddle, and by both
 * another tolerance and bent branches; to what an error of one tolerance, or of the residual, in both tangents makes, if that is
 * more: all changes may happen to be small. */
static jlt_status angle_errors(jlt_homoclinic *points, size_t count, const jlt_branch *const branches[2], jlt_map_batch *fine,
                               jlt_map_batch *coarse)
{
    JLT_FREED refinement *room = calloc(count + 1, sizeof *room);

    if (room == NULL) return JLT_ERR_NOMEM;
    for (size_t i = 0; i < count; i++) points[i].angle_error = 0;
    JLT_PASS(angles_again(points, count, branches, coarse, false, false, room));
    JLT_PASS(angles_again(points, count, branches, fine, false, true, room));
    JLT_PASS(angles_again(points, count, branches, coarse, true, false, room));
    for (size_t i = 0; i < count; i++) {
        const double least = fmax(jlt_map_batch_tolerance(fine), points[i].residual) * points[i].turn;
        points[i].angle_error = points[i].angle_error < least / 2 ? least : 2 * points[i].angle_error; /* may be NaN */
    }
    return JLT_OK;
}

static int compare(const void *left, const void *right)
{
    const jlt_homoclinic *a = left, *b = right;

    return a->sigma_unstable < b->sigma_unstable ? -1 : a->sigma_unstable > b->sigma_unstable;
}

/* Uncertainty of a crossing's position along the branches, which separate at its angle. */
static double blur(const jlt_homoclinic *point) { return point->residual / fabs(sin(point->angle)); }

/* Whether two crossings are the same, as far as their residuals tell. */
static bool is_same(const jlt_homoclinic *a, const jlt_homoclinic *b, const jlt_chart *chart)
{
    const double along = fmax(fabs(a->sigma_unstable - b->sigma_unstable), fabs(a->sigma_stable - b->sigma_stable));

    return along < 1e-7 || (along < 1 && jlt_chart_distance(chart, a->q, b->q) < blur(a) + blur(b));
}

/* List the points where sides of the polygons meet; the caller frees *out. If one polygon is the mirror image of the other, sides
 * (i, j) meet where (j, i) do, and only those with j <= i are listed. Errors: NO_CONVERGENCE, interrupted; NOMEM. */
static jlt_status find_candidates(refinement **out, size_t *count, const jlt_manifold *unstable, const jlt_manifold *stable,
                                  bool mirrored, const jlt_flow *flow)
{
    const jlt_chart *chart = flow->chart;
    refinement *list = NULL;

    *count = 0;
    for (size_t i = 0; i + 1 < unstable->count; i++) {
        if (flow->interrupt != NULL && *flow->interrupt) {
            free(list);
            return JLT_ERR_NO_CONVERGENCE;
        }
        for (size_t j = 0; j + 1 < stable->count && !(mirrored && j > i); j++) {
            jlt_homoclinic point = { .lobe = NAN };
            double a, b;
            if (!segments_cross(chart, &a, &b, unstable->points + 2 * i, unstable->points + 2 * i + 2,
                                stable->points + 2 * j, stable->points + 2 * j + 2)) continue;
            point.sigma_unstable = unstable->sigma[i] + a * (unstable->sigma[i + 1] - unstable->sigma[i]);
            point.sigma_stable = stable->sigma[j] + b * (stable->sigma[j + 1] - stable->sigma[j]);
            if (!JLT_MEMORY_GROW(list, *count)) {
                free(list);
                return JLT_ERR_NOMEM;
            }
            begin_refinement(&list[*count], &point);
            list[(*count)++].has_twin = mirrored && i != j;
        }
    }
    *out = list;
    return JLT_OK;
}

/* The image of a crossing under the reversor, which exchanges the unstable and the stable branch. The angle stays: the two tangents
 * change places, and the reversor reverses the sense of angles. */
static jlt_homoclinic image_of(const jlt_homoclinic *point, const jlt_chart *chart)
{
    jlt_homoclinic image = *point;

    jlt_chart_mirror(chart, image.q, point->q);
    image.sigma_unstable = point->sigma_stable;
    image.sigma_stable = point->sigma_unstable;
    jlt_chart_mirror(chart, image.again.q, point->again.q);
    image.again.sigma[0] = point->again.sigma[1];
    image.again.sigma[1] = point->again.sigma[0];
    return image;
}

/* Whether the branches may only touch at the point, given its errors: also where both are back at their saddle, nearer than any
 * branch begins. */
static bool may_touch(const jlt_homoclinic *point, const jlt_branch *const branches[2], const jlt_chart *chart)
{
    for (int k = 0; k < 2; k++)
        if (jlt_chart_distance(chart, point->q, branches[k]->q) < JLT_BRANCH_SEED_LEAST) return true;
    return fabs(point->angle) <= point->angle_error || !(blur(point) < JLT_MANIFOLD_FINEST);
}

/* Leave out points that may be no crossings (counted in *touching), and duplicates. Returns how many stay. */
static size_t keep_crossings(jlt_homoclinic *points, size_t count, size_t *touching, const jlt_branch *const branches[2],
                             const jlt_chart *chart)
{
    size_t kept = 0;

    for (size_t i = 0; i < count; i++) {
        const jlt_homoclinic *point = &points[i];
        bool known = false;
        for (size_t k = 0; !known && k < kept; k++) known = is_same(&points[k], point, chart);
        if (known) continue;
        if (may_touch(point, branches, chart)) ++*touching;
        else points[kept++] = *point;
    }
    return kept;
}

/* Sort the points and hand them to *out; with none, free them and set *out to NULL. */
static void finish(jlt_homoclinic **out, size_t *out_count, jlt_homoclinic *points, size_t count)
{
    if (count > 1) qsort(points, count, sizeof *points, compare);
    *out_count = count;
    *out = count > 0 ? points : NULL;
    if (count == 0) free(points);
}

jlt_status jlt_homoclinic_find(jlt_homoclinic **points, size_t *count, size_t *touching, const jlt_manifold *unstable,
                               const jlt_branch *unstable_branch, const jlt_manifold *stable, const jlt_branch *stable_branch,
                               bool mirrored, jlt_map_batch *fine, jlt_map_batch *coarse)
{
    const jlt_chart *chart = jlt_map_batch_flow(fine)->chart;
    const jlt_branch *const branches[] = { unstable_branch, stable_branch };
    JLT_FREED refinement *list = NULL;
    size_t candidates = 0, kept = 0, apart = 0, seen = 0;
    bool crosses = true;

    *points = NULL;
    *count = 0;
    if (touching != NULL) *touching = 0;
    JLT_PASS(find_candidates(&list, &candidates, unstable, stable, mirrored, jlt_map_batch_flow(fine)));
    if (candidates == 0) return JLT_OK;
    JLT_FREED jlt_homoclinic *found = calloc(2 * candidates, sizeof *found);
    JLT_FREED bool *has_twin = calloc(candidates, sizeof *has_twin);
    if (found == NULL || has_twin == NULL) return JLT_ERR_NOMEM;
    while (crosses && seen < candidates) {
        const size_t first = kept, end = candidates - seen < JLT_HOMOCLINIC_ROW ? candidates : seen + JLT_HOMOCLINIC_ROW;
        JLT_PASS(refine(list + seen, end - seen, branches, fine, 12));
        for (; seen < end; seen++) {
            if (list[seen].status != JLT_OK || list[seen].best.residual > small_residual + list[seen].sway) {
                apart += list[seen].has_twin ? 2 : 1;
                continue;
            }
            has_twin[kept] = list[seen].has_twin;
            found[kept++] = list[seen].best;
        }
        JLT_PASS(angle_errors(found + first, kept - first, branches, fine, coarse));
        crosses = false;
        for (size_t i = first; i < kept; i++) crosses |= !may_touch(&found[i], branches, chart);
    }
    for (size_t i = seen; i < candidates; i++) apart += list[i].has_twin ? 2 : 1;
    for (size_t i = 0, alone = kept; i < alone; i++)
        if (has_twin[i]) found[kept++] = image_of(&found[i], chart);
    kept = keep_crossings(found, kept, &apart, branches, chart);
    if (touching != NULL) *touching = apart;
    finish(points, count, found, kept);
    found = NULL; /* ownership moved to the caller */
    return JLT_OK;
}

jlt_status jlt_homoclinic_reflect(jlt_homoclinic **out, const jlt_homoclinic *points, size_t count,
                                  const jlt_chart *chart)
{
    jlt_homoclinic *images = calloc(count + 1, sizeof *images);

    *out = NULL;
    if (images == NULL) return JLT_ERR_NOMEM;
    for (size_t i = 0; i < count; i++) images[i] = image_of(&points[i], chart);
    finish(out, &count, images, count);
    return JLT_OK;
}

/* Whether the two branches wind around an angle a different number of times between the crossings: they then enclose no area. */
static bool goes_round(const jlt_branch_area *here, const jlt_branch_area *next, const jlt_chart *chart)
{
    bool round = false;

    for (int c = 0; c < 2; c++) {
        const double apart = (next[0].at[c] - here[0].at[c]) - (next[1].at[c] - here[1].at[c]);
        round = round || (chart->period[c] > 0 && fabs(apart) > chart->period[c] / 2);
    }
    return round;
}

void jlt_homoclinic_measure_lobes(jlt_homoclinic *points, size_t count, const jlt_chart *chart)
{
    for (size_t i = 0; i + 1 < count; i++) {
        const jlt_branch_area *here = points[i].area, *next = points[i + 1].area;
        points[i].lobe = goes_round(here, next, chart)
                             ? NAN
                             : jlt_branch_area_between(&here[0], &next[0]) - jlt_branch_area_between(&here[1], &next[1]);
        points[i].lobe_error = fabs(next[0].error - here[0].error) + fabs(next[1].error - here[1].error);
    }
}
