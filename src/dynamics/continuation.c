#include "dynamics/continuation.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/memory.h"
#include "dynamics/continuation_locate.h"

enum { CLIPPING = 120, EXTREMUM = 8, FOLD_TEST = 0, DOUBLING_TEST, BRANCH_TEST, TORUS_TEST };

typedef jlt_continuation_runner runner;
typedef jlt_continuation_place place;
typedef jlt_continuation_bracket bracket;

static const double turn_across = 0.15; /* most radians by which the tangent turns in each half of a step across a branch point */
static const double same_place = 1e-6;
/* Error of a test function, from the map's tolerance, amplified: det DP is 1 up to this where the map preserves areas, and that of
 * the bordered matrix is 0 where orbits form families; so is the tangent's last component where a family has one value. */
static const double noise = 1e-9;

const char *jlt_continuation_bifurcation_name(jlt_bifurcation kind)
{
    static const char *const names[] = { "", "fold", "period doubling", "branch point", "torus" };
    return (unsigned)kind < sizeof names / sizeof *names ? names[kind] : "unknown";
}

/* Measure the bifurcation and pass it to the sink; where it cannot be measured, the place before it stands for it. */
static jlt_status deliver(const runner *self, const bracket *b, const place *from, jlt_bifurcation kind,
                          jlt_continuation_sink sink, void *context)
{
    jlt_continuation_point point;
    jlt_status st = jlt_continuation_step_measure(self, &point, b->at.u, b->at.tangent, b->at.arc, kind);

    if (st != JLT_OK && st != JLT_ERR_NOMEM)
        st = jlt_continuation_step_measure(self, &point, from->u, from->tangent, from->arc, kind);
    if (st != JLT_OK) return st;
    const double before = b->before.u[self->d] * self->options.scale, after = b->after.u[self->d] * self->options.scale;
    point.low = fmin(before, after);
    point.high = fmax(before, after);
    return sink(context, &point);
}

/* Whether the branch has gone through an orbit of half the period: the points half a period apart have changed sides. */
static bool halves(const runner *self, const jlt_continuation_point *before, const jlt_continuation_point *after)
{
    const unsigned d = self->d;
    const size_t half = self->period / 2;
    const jlt_chart *chart = &self->chart;
    double first[JLT_CHART_DIM_MAX], second[JLT_CHART_DIM_MAX], sum = 0, size = 0;

    if (self->period % 2 != 0) return false;
    jlt_chart_difference(chart, first, before->orbit.points + half * d, before->orbit.points);
    jlt_chart_scaled(chart, first, first);
    jlt_chart_difference(chart, second, after->orbit.points + half * d, after->orbit.points);
    jlt_chart_scaled(chart, second, second);
    for (unsigned i = 0; i < d; i++) sum += first[i] * second[i], size = fmax(size, fabs(first[i]));
    return sum < 0 && size < 0.5; /* a difference of angles changes sign at half a period as well */
}

/* Whether two multipliers of product 1 are a complex pair, not two of 1 or -1 that errors make one. */
static bool rotates(const place *at)
{
    return fabs(at->at.slope[0] + at->at.slope[3]) < 2 - noise;
}

static bool changes(const place *from, const place *to, unsigned k) { return (from->test[k] > 0) != (to->test[k] > 0); }

static bool is_noise(const place *from, const place *to, unsigned k)
{
    return fmax(fabs(from->test[k]), fabs(to->test[k])) < noise;
}

/* Whether the branch goes straight across the point where another one crosses it. Where the two only come near each other, both
 * turn away, and steps go from one to the other: as on x*y = e, where the chord from x = -s to s has the slope of the tangents at
 * its ends, but of the other sign. So where steps cease to converge, the branch must turn as little as the bracket is short, or
 * the points straight between its ends must be orbits up to noise, as where branches cross at a small angle. */
static bool crosses(const runner *self, const place *from, const place *to)
{
    JLT_FREED bracket *b = malloc(sizeof *b);

    if (b == NULL) return false;
    jlt_continuation_locate(b, self, from, from, to, BRANCH_TEST);
    const double width = b->after.arc - b->before.arc, part = width / (to->arc - from->arc);
    return b->joined || width < same_place ||
           jlt_continuation_step_straight(&b->before, &b->after, 2 * turn_across * fmax(part, 0.01), self->d);
}

/* Whether the step from one place to the other stays on the branch, as far as angles show. The bordered determinant changes sign at
 * branch points alone: where it does, the place halfway must lie on the way as well, or the tangent was reversed behind a fold. */
static bool follows(const runner *self, const place *from, const place *to, double step)
{
    if (!jlt_continuation_step_straight(from, to, JLT_CONTINUATION_TURN, self->d)) return false;
    if (!changes(from, to, BRANCH_TEST)) return true;
    JLT_FREED place *middle = malloc(sizeof *middle);
    return middle != NULL && jlt_continuation_step_to(self, middle, from, step / 2, NULL) == JLT_OK &&
           jlt_continuation_step_straight(from, middle, turn_across, self->d) &&
           jlt_continuation_step_straight(middle, to, turn_across, self->d) &&
           (is_noise(from, to, BRANCH_TEST) || crosses(self, from, to));
}

/* A place within a step, at s from its beginning, and test k there times `side`. Returns false if it is not found on the branch. */
static bool visit(const runner *self, place *within, double *value, const place *from, const place *to, double s, unsigned k,
                  double side)
{
    if (jlt_continuation_step_to(self, within, from, s, NULL) != JLT_OK || !follows(self, from, within, s)
        || !jlt_continuation_step_straight(within, to, JLT_CONTINUATION_TURN, self->d)) return false;
    *value = side * within->test[k];
    return true;
}

/* Whether test k, of one sign at both ends of a step, has the other one within, at a place that becomes *within: the extremum of
 * the parabola through three values. The first parabola uses `before`, the place before the step, and may err by half a step, and
 * by a fiftieth of the values; later ones use the extremum found and places on both sides of it, where the parabola has risen by
 * four times the value there. */
static bool changes_twice(const runner *self, place *within, const place *before, const place *from, const place *to, unsigned k)
{
    const double side = from->test[k] > 0 ? 1 : -1, end = to->arc - from->arc;
    double s[3] = { before->arc - from->arc, 0, end };
    double g[3] = { side * before->test[k], side * from->test[k], side * to->test[k] };

    for (int i = 0; i < EXTREMUM; i++) {
        const double left = (g[1] - g[0]) / (s[1] - s[0]), right = (g[2] - g[1]) / (s[2] - s[1]);
        const double bend = (right - left) / (s[2] - s[0]), at = (s[0] + s[1]) / 2 - left / (2 * bend);
        const double least = g[0] + (at - s[0]) * (left + (at - s[1]) * bend), spare = i == 0 ? end / 2 : 0;
        const double low = i == 0 ? fmax(0.9 * fmin(g[1], g[2]), 0.02 * fmax(g[0], g[2])) : fmin(g[1], g[2]) / 2;
        if (!(bend > 0 && at > -spare && at < end + spare && least < low)) return false;
        s[1] = fmin(fmax(at, spare / 8), end - spare / 8);
        if (!visit(self, within, &g[1], from, to, s[1], k, side)) return false;
        if (g[1] < -noise) return true;
        const double reach = 2 * sqrt(fmax(g[1], noise) / bend);
        s[0] = fmax(s[1] - reach, s[1] / 2);
        s[2] = fmin(s[1] + reach, (s[1] + end) / 2);
        for (unsigned j = 0; j < 3; j += 2) {
            if (!visit(self, within, &g[j], from, to, s[j], k, side)) return false;
            if (g[j] < -noise) return true;
        }
        if (g[1] <= noise) return false;
    }
    return false;
}

/* Locate and report the zero of test k between two places, to which steps from `from` lead. */
static jlt_status report_zero(const runner *self, const place *from, const place *before, const place *after, unsigned k,
                              jlt_continuation_sink sink, void *context)
{
    JLT_FREED bracket *b = malloc(sizeof *b);

    if (b == NULL) return JLT_ERR_NOMEM;
    jlt_continuation_locate(b, self, from, before, after, k);
    if (k == TORUS_TEST && !rotates(&b->at)) return JLT_OK; /* a saddle of determinant 1 */
    return deliver(self, b, from, (jlt_bifurcation)(JLT_BIFURCATION_FOLD + k), sink, context);
}

/* Whether the branch turns in the value between two places where it crosses another branch, as one that begins at a pitchfork does
 * on its way to the other side: this is no fold of its own. Near the crossing, where steps cease to converge, tangents are known no
 * better than places to either side of it are the same. */
static bool turns_at_branch_point(const runner *self, const place *from, const place *to)
{
    if (!changes(from, to, FOLD_TEST) || !changes(from, to, BRANCH_TEST)) return false;
    JLT_FREED bracket *b = malloc(sizeof *b);
    if (b == NULL) return false;
    jlt_continuation_locate(b, self, from, from, to, FOLD_TEST);
    const double fold = b->at.arc;
    jlt_continuation_locate(b, self, from, from, to, BRANCH_TEST);
    return fabs(fold - b->at.arc) <= 100 * same_place;
}

/* Report the bifurcations between two places, then the new place; before: the place before the two, NULL if there is none. If the
 * branch ends at a period doubling in between, report that alone, and set *ends. */
static jlt_status report(const runner *self, const place *before, const place *from, const place *to, jlt_continuation_point *last,
                         bool *ends, jlt_continuation_sink sink, void *context)
{
    JLT_FREED jlt_continuation_point *point = malloc(sizeof *point);
    JLT_FREED bracket *tip = malloc(sizeof *tip);
    JLT_FREED place *within = malloc(sizeof *within);

    if (point == NULL || tip == NULL || within == NULL) return JLT_ERR_NOMEM;
    JLT_PASS(jlt_continuation_step_measure(self, point, to->u, to->tangent, to->arc, JLT_BIFURCATION_NONE));
    *ends = halves(self, last, point);
    if (*ends) {
        jlt_continuation_locate(tip, self, from, from, to, FOLD_TEST);
        return deliver(self, tip, from, JLT_BIFURCATION_DOUBLING, sink, context);
    }
    for (unsigned k = 0; k < JLT_CONTINUATION_TESTS; k++) {
        if (isnan(from->test[k]) || isnan(to->test[k])) continue;
        if (k != DOUBLING_TEST && is_noise(from, to, k)) continue;
        /* near a torus bifurcation they are a pair at least where both are inside the circle */
        if (k == TORUS_TEST && !rotates(from) && !rotates(to)) continue;
        if (k == FOLD_TEST && turns_at_branch_point(self, from, to)) continue;
        if (changes(from, to, k)) {
            JLT_PASS(report_zero(self, from, from, to, k, sink, context));
        } else if (before != NULL && changes_twice(self, within, before, from, to, k)) {
            JLT_PASS(report_zero(self, from, from, within, k, sink, context));
            JLT_PASS(report_zero(self, from, within, to, k, sink, context));
        }
    }
    *last = *point;
    return sink(context, point);
}

/* Whether the branch, within `step` of `from`, meets the orbit it began with, at any of its points. */
static bool closes(const runner *self, const place *from, double step, const jlt_continuation_point *first)
{
    const unsigned d = self->d;
    double here[JLT_CHART_DIM_MAX];
    place at;

    jlt_chart_unscaled(&self->chart, here, from->u);
    for (size_t k = 0; k < self->period; k++) {
        double way[JLT_CONTINUATION_U], along = 0, off = 0;
        jlt_chart_difference(&self->chart, way, first->orbit.points + k * d, here);
        jlt_chart_scaled(&self->chart, way, way);
        way[d] = first->value / self->options.scale - from->u[d];
        for (unsigned i = 0; i <= d; i++) along += way[i] * from->tangent[i];
        for (unsigned i = 0; i <= d; i++) off = fmax(off, fabs(way[i] - along * from->tangent[i]));
        if (!(along > 0 && along <= step && off <= step / 4)) continue;
        if (jlt_continuation_step_to(self, &at, from, along, NULL) != JLT_OK) continue;
        off = 0;
        for (unsigned i = 0; i <= d; i++) off = fmax(off, fabs(at.u[i] - from->u[i] - way[i]));
        if (off < same_place) return true;
    }
    return false;
}

static double trace_of(const place *at, unsigned d)
{
    double trace = 0;

    for (unsigned i = 0; i < d; i++) trace += at->at.slope[i * d + i];
    return trace;
}

/* Whether the trace at `next` differs from that on the line through the two places before it, or without `before` from that at
 * `here`, by at most half of the trace, or by 1 if that is more. Between places where it changes more, multipliers may have been at
 * 1 or -1, and come back. */
static bool resolves(const place *before, const place *here, const place *next, unsigned d)
{
    const double was = trace_of(here, d), is = trace_of(next, d);
    const double slope = before != NULL ? (was - trace_of(before, d)) / (here->arc - before->arc) : 0;

    return fabs(is - was - slope * (next->arc - here->arc)) <= fmax(2, fmax(fabs(was), fabs(is))) / 2;
}

/* Find the next place, halving *step until it follows the branch. Returns false if none does; *end, or *st = NOMEM, says why. */
static bool next_place(const runner *self, place *next, double *step, unsigned *iterations, const place *before, const place *here,
                       jlt_status *st, jlt_continuation_end *end)
{
    for (; *step >= self->options.step_min && !jlt_continuation_locate_interrupted(self); *step /= 2) {
        *st = jlt_continuation_step_to(self, next, here, *step, iterations);
        if (*st == JLT_ERR_NOMEM) return false;
        if (*st == JLT_OK && *iterations <= 7 && follows(self, here, next, *step)
            && (*step < 2 * self->options.step_min || resolves(before, here, next, self->d))) return true;
        *st = JLT_OK;
    }
    *end = jlt_continuation_locate_interrupted(self) ? JLT_CONTINUATION_INTERRUPT : JLT_CONTINUATION_STUCK;
    return false;
}

/* The end of the range that the branch crosses between `here` and `next`. */
static double limit_ahead(const runner *self, const place *next, const place *here)
{
    return (next->u[self->d] > here->u[self->d] ? self->options.high : self->options.low) / self->options.scale;
}

/* Whether the end of the range is within a few shortest steps: beyond it there may be no orbits to step to. */
static bool is_at_limit(const runner *self, const place *here)
{
    const unsigned d = self->d;
    const double limit = (here->tangent[d] > 0 ? self->options.high : self->options.low) / self->options.scale;

    return here->tangent[d] != 0 && (limit - here->u[d]) / here->tangent[d] <= 4 * self->options.step_min;
}

/* Replace *next, which is outside the range, by the place where the branch leaves the range after `here`, found by the secant
 * method; *step becomes its arclength from `here`. */
static jlt_status clip(const runner *self, place *next, double *step, const place *here)
{
    const unsigned d = self->d;
    const double limit = limit_ahead(self, next, here);
    double inside = 0, outside = *step, miss_inside = here->u[d] - limit, miss_outside = next->u[d] - limit;

    for (int i = 0; i < CLIPPING && !jlt_continuation_step_is_at(next->u[d], limit) && miss_inside != 0; i++) {
        const double secant = (inside * miss_outside - outside * miss_inside) / (miss_outside - miss_inside);
        const double s = i % 3 == 2 ? (inside + outside) / 2 : secant;
        place trial;
        JLT_PASS(jlt_continuation_step_to(self, &trial, here, s, NULL));
        if ((trial.u[d] - limit > 0) == (miss_inside > 0)) {
            inside = s, miss_inside = trial.u[d] - limit;
        } else {
            outside = s, miss_outside = trial.u[d] - limit;
        }
        *next = trial;
        *step = s;
    }
    return JLT_OK;
}

/* A branch may begin at a small orbit: steps grow with it, but for the change of the value in a step. */
static double longest_step(const runner *self, const place *here)
{
    const double grown = fmax(1, jlt_continuation_step_length(self, here->u) / self->length);

    return self->options.step_max * fmin(grown, 1 / fabs(here->tangent[self->d]));
}

jlt_status jlt_continuation_run(jlt_continuation_end *end, const jlt_family *family,
                                const jlt_continuation_point *start, int direction,
                                const jlt_continuation_options *options, jlt_continuation_sink sink, void *context)
{
    runner self = { .family = family, .options = jlt_continuation_step_defaults(options), .period = start->orbit.period };
    struct {
        jlt_continuation_point first, last;
        place before, here, next;
    } *on = malloc(sizeof *on); /* a megabyte: there is room for the largest sections */
    double step = self.options.step;
    bool ends = false, leaves;
    jlt_status st = JLT_OK;

    if (start->orbit.period == 0 || start->value < self.options.low || start->value > self.options.high
        || !jlt_continuation_step_allows(&self.options, direction)) st = JLT_ERR_ARG;
    else if (on == NULL) st = JLT_ERR_NOMEM;
    if (st != JLT_OK) goto done;
    JLT_TRY(jlt_continuation_step_open(&self, start->value));
    JLT_TRY(jlt_continuation_step_begin(&self, &on->here, start, direction));
    JLT_TRY(jlt_continuation_step_measure(&self, &on->first, on->here.u, on->here.tangent, 0, JLT_BIFURCATION_NONE));
    on->last = on->first;
    JLT_TRY(sink(context, &on->first));
    *end = JLT_CONTINUATION_POINTS;
    for (size_t count = 1; count < self.options.points_max; count++) {
        unsigned iterations = 0;
        double value;
        if (!next_place(&self, &on->next, &step, &iterations, count > 1 ? &on->before : NULL, &on->here, &st, end)) {
            if (st == JLT_OK && *end == JLT_CONTINUATION_STUCK && is_at_limit(&self, &on->here)) *end = JLT_CONTINUATION_RANGE;
            break;
        }
        value = on->next.u[self.d] * self.options.scale;
        leaves = value < self.options.low || value > self.options.high;
        const double at = on->here.u[self.d], beyond = limit_ahead(&self, &on->next, &on->here);
        if (leaves && jlt_continuation_step_is_at(at, beyond)) {
            *end = JLT_CONTINUATION_RANGE;
            break;
        }
        st = leaves ? clip(&self, &on->next, &step, &on->here) : JLT_OK;
        if (st == JLT_ERR_NO_CONVERGENCE && !jlt_continuation_locate_interrupted(&self)) {
            *end = JLT_CONTINUATION_STUCK;
            st = JLT_OK;
            break;
        }
        if (st != JLT_OK) goto done;
        if (count > 2 && closes(&self, &on->here, step, &on->first)) {
            *end = JLT_CONTINUATION_CLOSED;
            break;
        }
        JLT_TRY(report(&self, count > 1 ? &on->before : NULL, &on->here, &on->next, &on->last, &ends, sink, context));
        if (ends || leaves) {
            *end = ends ? JLT_CONTINUATION_HALVED : JLT_CONTINUATION_RANGE;
            break;
        }
        on->before = on->here;
        on->here = on->next;
        *end = JLT_CONTINUATION_POINTS;
        if (iterations < 6) step = fmin(1.4 * step, longest_step(&self, &on->here));
    }
done:
    if (jlt_continuation_locate_interrupted(&self) && st == JLT_ERR_NO_CONVERGENCE) {
        *end = JLT_CONTINUATION_INTERRUPT;
        st = JLT_OK;
    }
    free(on);
    return st;
}
