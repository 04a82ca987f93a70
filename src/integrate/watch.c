#include "integrate/watch.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "integrate/bernstein.h"
#include "integrate/locate.h"
#include "integrate/step_control.h"

enum { SIZE = JLT_BERNSTEIN_DEGREE_MAX + 1, NODES = 13 };
static const double near_section = 1e-13; /* of the size of g's terms: on the section, as far as rounding can tell */

static int sign(double v)
{
    return (v > 0) - (v < 0);
}

void jlt_watch_begin(jlt_watch *self, const jlt_event *event, const jlt_stepper *stepper)
{
    self->event = *event;
    self->value = jlt_locate_value(event, stepper->x);
    const double size = event->value == NULL ? jlt_locate_unit(event, stepper) : 1;
    self->side = fabs(self->value) <= near_section * size ? 0 : sign(self->value);
    self->has_zero = false;
}

static void column_polynomial(double *b, unsigned *degree, const jlt_event *event, jlt_stepper *stepper)
{
    if (!stepper->dense_ready) {
        *degree = stepper->method->bernstein(stepper, event->column, b);
    } else {
        *degree = stepper->dense_degree;
        jlt_bernstein_of(b, stepper->dense + event->column, stepper->stride, *degree);
    }
    for (unsigned j = 0; j <= *degree; j++) b[j] -= event->level;
}

/* Least and largest of the coefficients, between which g lies; the latter INFINITY where one is not finite. */
static void bounds(double *least, double *most, const double *b, unsigned degree)
{
    *least = *most = b[0];
    for (unsigned j = 1; j <= degree; j++) {
        *least = jlt_smaller(b[j], *least);
        *most = isfinite(b[j]) ? jlt_larger(b[j], *most) : INFINITY;
    }
}

/* Chebyshev-Lobatto points of the step, (1 - cos(pi j/(NODES - 1)))/2; every other one is such a set too. */
static const double nodes[NODES] = {
    0.0, 0.017037086855465844, 0.06698729810778065, 0.1464466094067262, 0.24999999999999994,
    0.37059047744873963, 0.49999999999999994, 0.6294095225512604, 0.7499999999999999, 0.8535533905932737,
    0.9330127018922194, 0.9829629131445341, 1.0,
};

static void sample(double value[NODES], unsigned from, const jlt_event *event, const jlt_stepper *stepper)
{
    double x[JLT_FIELD_DIM_MAX + 1];

    for (unsigned j = from; j < NODES; j += 2) {
        jlt_stepper_values(stepper, nodes[j], x);
        value[j] = event->value(event->context, x);
    }
}

/* The polynomial through every `apart`-th of the values, by divided differences. Returns its degree. */
static unsigned interpolate(double *b, const double value[NODES], unsigned apart)
{
    const unsigned degree = (NODES - 1) / apart;
    double node[NODES], difference[NODES], c[NODES] = { 0 };

    for (unsigned j = 0; j <= degree; j++) {
        node[j] = nodes[j * apart];
        difference[j] = value[j * apart];
    }
    for (unsigned round = 1; round <= degree; round++)
        for (unsigned j = degree; j >= round; j--)
            difference[j] = (difference[j] - difference[j - 1]) / (node[j] - node[j - round]);
    for (unsigned j = degree + 1; j-- > 0;) { /* c <- difference_j + (theta - node_j) c */
        for (unsigned k = degree; k >= 1; k--) c[k] = c[k - 1] - node[j] * c[k];
        c[0] = difference[j] - node[j] * c[0];
    }
    jlt_bernstein_of(b, c, 1, degree);
    return degree;
}

/* A bound on the error of a polynomial through every other value: four times its last two coefficients in Chebyshev's polynomials.
 * It is at least twice the sum of all that follow, where each is at most half of the one before. */
static double left_out(const double value[NODES])
{
    static const double half_root = 0.86602540378443865; /* cos(pi/6) */
    const double *v = value;
    const double last = 0.5 * (v[0] + v[12]) - (v[2] + v[10]) + (v[4] + v[8]) - v[6];
    const double but_one = 0.5 * (v[0] - v[12]) - half_root * (v[2] - v[10]) + 0.5 * (v[4] - v[8]);
    return 4 * (fabs(last) / 6 + fabs(but_one) / 3);
}

/* Whether the polynomial through every other value is right between them as well. On these nodes T_k, k = 7 to 12, is aliased to
 * T_(12-k); at the point that is tested the two differ by 0.84 or more, where no point attains more than 0.85. */
static bool holds_between(const double *b, unsigned degree, double doubt, const jlt_event *event, const jlt_stepper *stepper)
{
    static const double between = 0.389;
    double x[JLT_FIELD_DIM_MAX + 1];

    jlt_stepper_values(stepper, between, x);
    return fabs(event->value(event->context, x) - jlt_bernstein_value(b, degree, between)) <= doubt;
}

/* A function of the state as the polynomial through its values: through half of them where that is enough to tell that the function
 * stays on one side of zero. */
static unsigned value_polynomial(double *b, const jlt_event *event, const jlt_stepper *stepper)
{
    double value[NODES], least, most;

    sample(value, 0, event, stepper);
    const unsigned degree = interpolate(b, value, 2);
    bounds(&least, &most, b, degree);
    const double doubt = left_out(value) + stepper->dense_error * jlt_larger(jlt_larger(most, -least), 1);
    if ((least > doubt || most < -doubt) && holds_between(b, degree, doubt, event, stepper)) return degree;
    sample(value, 1, event, stepper);
    return interpolate(b, value, 1);
}

/* g on the step as a polynomial in Bernstein form. */
static jlt_status event_polynomial(double *b, unsigned *degree, const jlt_event *event, jlt_stepper *stepper)
{
    if (event->value != NULL || stepper->method->bernstein == NULL) {
        JLT_PASS(jlt_stepper_dense(stepper));
    }
    if (event->value != NULL) *degree = value_polynomial(b, event, stepper);
    else column_polynomial(b, degree, event, stepper);
    return JLT_OK;
}

/* Whether g cannot have reached zero between two values of the same sign. */
static bool stays_away(const jlt_watch *self, const jlt_stepper *stepper, double before, double after)
{
    if (self->event.value != NULL || self->side == 0 || stepper->dense_ready || stepper->method->variation == NULL) return false;
    if (sign(before) != self->side || sign(after) != self->side) return false;
    return fabs(before) + fabs(after) > 1.5 * stepper->method->variation(stepper, self->event.column);
}

typedef struct {
    double theta, value, bend; /* an extremum: g and d2g/dtheta2 there */
    bool past;                 /* the polynomial has it on the far side of zero */
} extremum;

/* Newton's method for the zero of the slope, with the polynomial's second derivative. */
static jlt_status refine_extremum(extremum *e, const jlt_event *event, jlt_stepper *stepper)
{
    double x[JLT_FIELD_DIM_MAX + 8], f[JLT_FIELD_DIM_MAX + 8], slope;

    for (unsigned i = 0; i < 3; i++) {
        JLT_PASS(jlt_locate_state(event, stepper, e->theta, x, f, &e->value, &slope));
        const double move = -slope * stepper->h / e->bend;
        if (!(fabs(move) < 0.25)) break;
        e->value += 0.5 * slope * stepper->h * move;
        e->theta += move;
        if (fabs(move) < 1e-9) break;
    }
    return JLT_OK;
}

typedef struct {
    double roots[SIZE + 1];
    unsigned count;
    double touch[SIZE];
    unsigned touches;
} zeros;

/* Remove or insert the pair of sign changes about an extremum that nearly touches zero, according to its refined value. */
static void settle_pair(zeros *z, const extremum *e, double noise)
{
    const double depth = -e->value * (e->bend > 0 ? 1 : -1); /* > 0: past the section */
    unsigned after = 0;
    while (after < z->count && z->roots[after] < e->theta) after++;
    const double reach = sqrt(2 * fabs(e->value / e->bend));
    if (e->past && (after == 0 || after == z->count)) return; /* one of the pair lies beyond an end, whose sign is certain */

    if (depth > noise) {
        if (!e->past && z->count + 2 <= SIZE) {
            for (unsigned i = z->count; i > after; i--) z->roots[i + 1] = z->roots[i - 1];
            z->roots[after] = fmax(e->theta - reach, 0);
            z->roots[after + 1] = fmin(e->theta + reach, 1);
            z->count += 2;
        } else if (e->past) {
            z->roots[after - 1] = fmax(e->theta - reach, 0);
            z->roots[after] = fmin(e->theta + reach, 1);
        }
        return;
    }
    if (e->past) {
        for (unsigned i = after + 1; i < z->count; i++) z->roots[i - 2] = z->roots[i];
        z->count -= 2;
    }
    if (depth >= -noise && z->touches < SIZE) z->touch[z->touches++] = e->theta;
}

/* Refine on the flow the extrema `at`, (count,), where the polynomial is zero within its error, and decide them. size: of g. */
static jlt_status settle_touches(zeros *z, const jlt_watch *self, jlt_stepper *stepper, const double *b, unsigned degree,
                                 const double *at, unsigned count, double size)
{
    const double noise = 16 * DBL_EPSILON * size;
    double slope[SIZE], bend[SIZE];

    jlt_bernstein_derive(slope, b, degree);
    jlt_bernstein_derive(bend, slope, degree - 1);
    for (unsigned i = 0; i < count; i++) {
        extremum e = { .theta = at[i], .value = jlt_bernstein_value(b, degree, at[i]) };
        e.bend = jlt_bernstein_value(bend, degree - 2, e.theta);
        if (e.bend == 0 || 0.5 * fabs(e.bend) < noise) continue;
        e.past = e.value * e.bend < 0;
        JLT_PASS(refine_extremum(&e, &self->event, stepper));
        if (e.theta > 0 && e.theta < 1) settle_pair(z, &e, noise);
    }
    return JLT_OK;
}

/* Drop neighbouring zeros between which g is within the noise: the orbit does not leave the section there. Zeros at the start and
 * at the end count among the neighbours; that at the start is divided out of b, `power` times. Returns the side that the orbit is
 * on at first, which is `side` unless zeros are dropped. */
static int drop_noise(zeros *z, const double *b, unsigned degree, unsigned power, bool at_start, bool at_end, int side,
                      double noise)
{
    unsigned kept = 0;
    double last = 0;

    for (unsigned i = 0; i <= z->count; i++) {
        const bool ends = i == z->count;
        const double next = ends ? 1 : z->roots[i], middle = 0.5 * (last + next);
        const bool neighbours = (kept > 0 || at_start) && (!ends || at_end);
        double most = neighbours ? fabs(jlt_bernstein_value(b, degree, middle)) : INFINITY;
        for (unsigned k = 0; k < power; k++) most *= middle;
        if (most <= noise) {
            if (kept > 0) kept--;
            else if (!ends) side = -side;
        } else if (!ends) {
            z->roots[kept++] = next;
        }
        last = kept > 0 ? z->roots[kept - 1] : next;
    }
    z->count = kept;
    return side;
}

static bool asked_for(const jlt_watch *self, const jlt_stepper *stepper, int turn)
{
    const int direction = turn * (stepper->direction > 0 ? 1 : -1);
    if (turn == 0) return self->event.grazing;
    return self->event.direction == JLT_BOTH || (int)self->event.direction == direction;
}

static int sign_right_of_zero(const double *b, unsigned degree)
{
    for (unsigned j = 0; j <= degree; j++)
        if (b[j] != 0) return sign(b[j]);
    return 0;
}

static void note(jlt_crossing *list, unsigned *count, const jlt_watch *self, const jlt_stepper *stepper, double theta,
                 int turn)
{
    if (!asked_for(self, stepper, turn) || *count == JLT_CROSSINGS_MAX) return;
    unsigned at = (*count)++;
    for (; at > 0 && list[at - 1].theta > theta; at--) list[at] = list[at - 1];
    list[at] = (jlt_crossing){ .theta = theta, .direction = turn * (stepper->direction > 0 ? 1 : -1) };
}

/* After a step that ends within the noise, past a zero that lies as near, store that zero until the orbit leaves the noise, maybe
 * many steps later. A step that begins beyond the noise may have other zeros before: the slope at its end tells where to look. */
static jlt_status keep_zero(jlt_watch *self, jlt_stepper *stepper, double before, double after, double noise)
{
    const int turn = -self->side;
    const double slope = jlt_locate_slope(&self->event, stepper, stepper->x, stepper->f) * stepper->h;
    const double theta = fabs(before) <= noise ? before / (before - after) : slope * turn > 0 ? 1 - after / slope : -1;
    jlt_crossing at = { .theta = theta, .direction = turn * (stepper->direction > 0 ? 1 : -1) };

    if (sign(after) != turn || sign(before) == turn || !(theta >= 0) || !asked_for(self, stepper, turn)) return JLT_OK;
    const jlt_status st = jlt_locate_refine(&at, self->zero, self->zero + stepper->stride, &self->event, stepper);
    if (st != JLT_OK) return st == JLT_ERR_NO_CONVERGENCE ? JLT_OK : st;
    self->has_zero = true;
    self->at_zero = at;
    self->zero_tau = stepper->tau_start + at.theta * stepper->h;
    return JLT_OK;
}

jlt_status jlt_watch_step(jlt_watch *self, jlt_stepper *stepper, jlt_crossing *list, unsigned *count)
{
    double before = jlt_locate_value(&self->event, stepper->x_start), after = jlt_locate_value(&self->event, stepper->x);
    double b[SIZE], touch[SIZE], least, most;
    unsigned degree, touches = 0, divided = 0;
    zeros z;

    *count = z.count = z.touches = 0;
    self->value = after;
    /* For other functions no unit is known in which they are small. */
    const double noise = self->event.value == NULL ? jlt_locate_noise(stepper->asked) * jlt_locate_unit(&self->event, stepper) : 0;
    if (fabs(before) > noise) self->has_zero = false;
    if (stays_away(self, stepper, before, after)) return JLT_OK;
    if (self->side != 0 && fabs(after) <= noise) JLT_PASS(keep_zero(self, stepper, before, after, noise));
    JLT_PASS(event_polynomial(b, &degree, &self->event, stepper));
    if (fabs(before) <= noise) before = 0;
    if (fabs(after) <= noise) after = 0;
    b[0] = before;
    b[degree] = after;
    bounds(&least, &most, b, degree);
    if (self->event.value == NULL && !(most < INFINITY)) return JLT_ERR_NONFINITE;
    const double size = jlt_larger(most, -least), terms = size + fabs(self->event.value == NULL ? self->event.level : 0);
    const double doubt = stepper->dense_error * jlt_larger(terms, 1);
    if ((self->side > 0 && least > doubt) || (self->side < 0 && most < -doubt) || size <= noise) return JLT_OK;

    /* On the section at the start: the zero there is divided out, and again where the slope is rounding error too. */
    const bool starts_on = self->side == 0 || before == 0;
    for (; starts_on && degree > 1 && divided < 2; divided++) {
        if (divided > 0 && fabs(b[0]) > near_section * size) break;
        jlt_bernstein_deflate(b, degree--);
    }
    if (!starts_on) touches = jlt_bernstein_touches(touch, b, degree, doubt);
    int side = sign_right_of_zero(b, degree);
    /* A single crossing in a direction that is not asked for need not be located. */
    if (touches == 0 && jlt_bernstein_variations(b, degree) == 1 && !asked_for(self, stepper, -side)) z.roots[z.count++] = 0.5;
    else z.count = jlt_bernstein_sign_changes(z.roots, b, degree);
    if (touches > 0) JLT_PASS(settle_touches(&z, self, stepper, b, degree, touch, touches, terms));
    side = drop_noise(&z, b, degree, divided, starts_on, after == 0, side, noise);

    if (self->side != 0 && side == -self->side) note(list, count, self, stepper, 0, side);
    for (unsigned i = 0; i < z.count; i++) {
        side = -side;
        note(list, count, self, stepper, z.roots[i], side);
    }
    for (unsigned i = 0; i < z.touches; i++) note(list, count, self, stepper, z.touch[i], 0);
    /* A value of exactly 0 at the end leaves the decision to the next step. */
    self->side = after != 0 ? sign(after) : side;
    return JLT_OK;
}

jlt_status jlt_watch_refine(const jlt_watch *self, jlt_crossing *crossing, double *x, double *slope_work, jlt_stepper *stepper)
{
    if (crossing->theta != 0 || !self->has_zero || crossing->direction != self->at_zero.direction)
        return jlt_locate_refine(crossing, x, slope_work, &self->event, stepper);
    memcpy(x, self->zero, stepper->stride * sizeof *x);
    crossing->theta = (self->zero_tau - stepper->tau_start) / stepper->h;
    crossing->residual = self->at_zero.residual;
    crossing->slope = self->at_zero.slope;
    return JLT_OK;
}
