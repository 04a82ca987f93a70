#include "dynamics/continuation_locate.h"

#include <math.h>
#include <string.h>

#include "integrate/step_control.h"

enum { LOCATE = 120, FAILURES = 20 };

typedef jlt_continuation_runner runner;
typedef jlt_continuation_place place;

bool jlt_continuation_locate_interrupted(const runner *self)
{
    return self->options.interrupt != NULL && *self->options.interrupt;
}

/* The next trial for a zero between a and b, where fa and fb differ in sign: in turn the secant's zero; a point twice as far from
 * the end with the smaller value, so that both ends close in (Alefeld, Potra, Shi, ACM TOMS 21 (1995) 327-344); the midpoint. */
static double look(int count, double a, double fa, double b, double fb)
{
    const double middle = a + (b - a) / 2, slope = (fb - fa) / (b - a), end = fabs(fa) < fabs(fb) ? a : b;
    double s = end - (count % 3 + 1) * (end == a ? fa : fb) / slope;

    if (count % 3 == 2 || !(fabs(s - end) <= fabs(b - a) / 2)) s = middle;
    return s > fmin(a, b) && s < fmax(a, b) ? s : middle;
}

/* The place at this part of the way between two others, to which steps from `from` lead, on the cubic through both with their
 * tangents. */
static void between(place *out, const place *from, const place *low, const place *high, double part, unsigned d)
{
    const double rest = 1 - part, width = high->arc - low->arc;
    double along[2] = { 0, 0 }; /* cosines of the tangents with that of the steps */

    for (unsigned i = 0; i <= d; i++) {
        along[0] += from->tangent[i] * low->tangent[i];
        along[1] += from->tangent[i] * high->tangent[i];
    }
    for (unsigned i = 0; i <= d; i++) {
        const double bend = rest * low->tangent[i] / along[0] - part * high->tangent[i] / along[1];
        out->u[i] = (1 + 2 * part) * rest * rest * low->u[i] + (1 + 2 * rest) * part * part * high->u[i] +
                    part * rest * width * bend;
        out->tangent[i] = rest * low->tangent[i] + part * high->tangent[i];
    }
    out->arc = low->arc + part * width;
}

/* Whether a place between the sides of a bracket, which is this part of a step, has their tangents, up to the turn of a branch over
 * that part. If not, the step arrived on another branch, which crosses at a small angle. */
static bool keeps_way(const jlt_continuation_bracket *b, const place *next, double part, unsigned d)
{
    const double least = cos(2 * JLT_CONTINUATION_TURN * fmax(part, 0.01));

    return jlt_along(b->before.tangent, next->tangent, d + 1) >= least &&
           jlt_along(next->tangent, b->after.tangent, d + 1) >= least;
}

void jlt_continuation_locate(jlt_continuation_bracket *out, const runner *self, const place *from, const place *before,
                             const place *after, unsigned k)
{
    const unsigned d = self->d;
    double a = before->arc - from->arc, b = after->arc - from->arc, fa = before->test[k], fb = after->test[k];
    place *const next = &out->trial;
    bool ends = false;
    double failed = NAN; /* a step that did not arrive; the next trials are halfway from it to either end */

    out->at = fabs(fa) < fabs(fb) ? *before : *after;
    out->before = *before;
    out->after = *after;
    out->trial = *before;
    out->joined = false;
    for (int i = 0; i < LOCATE && !ends; i++) {
        ends = fabs(b - a) <= 1e-10 * fmax(1, fabs(b)); /* the last trial is the secant's */
        const double s = isnan(failed) ? look(ends ? 0 : i, a, fa, b, fb) : (failed + (i % 2 == 0 ? a : b)) / 2;
        if (jlt_continuation_locate_interrupted(self)) break;
        /* Newton's method begins on the cubic, from where it leaves for another branch at a crossing alone. */
        between(next, from, &out->before, &out->after, (s - a) / (b - a), d);
        memcpy(next->tangent, from->tangent, sizeof next->tangent);
        if (jlt_continuation_step_to(self, next, next, 0, NULL) != JLT_OK ||
            !jlt_continuation_step_straight(from, next, JLT_CONTINUATION_TURN, d) ||
            !keeps_way(out, next, (b - a) / (after->arc - before->arc), d)) {
            if (isnan(failed)) failed = s;
            else if (i > FAILURES) break;
            continue;
        }
        if (fabs(next->test[k]) <= fabs(out->at.test[k])) out->at = *next;
        if ((next->test[k] > 0) == (fb > 0)) b = s, fb = next->test[k], out->after = *next;
        else a = s, fa = next->test[k], out->before = *next;
        if (next->test[k] == 0) {
            out->before = out->after = *next;
            break;
        }
        if (!(failed > fmin(a, b) && failed < fmax(a, b))) failed = NAN;
    }
    if (isnan(failed)) return;
    *next = out->at;
    between(next, from, &out->before, &out->after, fa / (fa - fb), d);
    out->joined = jlt_continuation_step_evaluate(self, &next->at, next->u) == JLT_OK;
    for (unsigned i = 0; i < d; i++) out->joined = out->joined && fabs(next->at.f[i]) < next->at.noise;
    if (out->joined) out->at = *next;
}
