#include "integrate/orbit.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/memory.h"
#include "integrate/edge.h"
#include "integrate/locate.h"
#include "integrate/loss.h"
#include "integrate/pole.h"
#include "integrate/step_control.h"
#include "integrate/watch.h"

static const size_t default_steps = 10000000;
static const double same_point = 1e-13; /* of a step: so near to the point handed out, a crossing is that point */
enum { PACE = 1 << 17 }; /* steps after which the pace of an orbit is looked at */

struct jlt_orbit {
    jlt_stepper *stepper;
    jlt_options options;
    jlt_observer observer;
    void *observer_context;

    jlt_watch watch[JLT_ORBIT_EVENTS_MAX];
    unsigned watch_count;
    jlt_crossing pending[JLT_ORBIT_EVENTS_MAX * JLT_CROSSINGS_MAX]; /* of the last step, ascending, from `next_pending` on */
    unsigned pending_count, next_pending;
    double cursor;  /* theta up to which the last step has been handed out */
    double told;    /* physical time of the point handed out last, the start at first; NaN: the orbit is not started */
    double *at, *slope; /* (stride,): the state handed out, and work; the watches' arrays follow */

    double pace_time, paced; /* where the last PACE steps began, and the time that the PACE steps before them took the orbit */
    size_t pace_step;        /* steps before the last PACE steps */

    jlt_invariant_watch invariants;
    jlt_pole_verdict pole;
};

jlt_status jlt_orbit_create(jlt_orbit **out, const jlt_method *method, const jlt_field *field, const jlt_options *options)
{
    JLT_OWNED(jlt_orbit) *self = NULL;

    *out = NULL;
    const jlt_options defaults = { .tolerance = 0 };
    if (options == NULL) options = &defaults;
    if (options->tolerance < 0 || options->max_step < 0) return JLT_ERR_ARG;
    if (!(options->first_step >= 0) || !isfinite(options->first_step) || isnan(options->t_last)) return JLT_ERR_ARG;
    if (options->invariants.count > JLT_INVARIANTS_MAX) return JLT_ERR_ARG;
    if (options->project && options->invariants.gradients == NULL) return JLT_ERR_ARG;
    if (options->project && method != NULL && method->multistep) return JLT_ERR_UNSUPPORTED;
    self = jlt_memory_array(1, sizeof *self);
    if (self == NULL) return JLT_ERR_NOMEM;
    self->options = *options;
    if (self->options.tolerance == 0) self->options.tolerance = JLT_ORBIT_TOLERANCE;
    if (self->options.max_step == 0) self->options.max_step = INFINITY;
    if (self->options.max_steps == 0) self->options.max_steps = default_steps;
    JLT_PASS(jlt_stepper_create(&self->stepper, method, field, self->options.tolerance, self->options.max_step));
    self->at = jlt_memory_array((2 + 2 * JLT_ORBIT_EVENTS_MAX) * (size_t)self->stepper->stride, sizeof *self->at);
    if (self->at == NULL) return JLT_ERR_NOMEM;
    self->slope = self->at + self->stepper->stride;
    self->told = NAN;
    for (size_t e = 0; e < JLT_ORBIT_EVENTS_MAX; e++) self->watch[e].zero = self->at + (2 + 2 * e) * self->stepper->stride;
    *out = self;
    self = NULL;
    return JLT_OK;
}

void jlt_orbit_destroy(jlt_orbit *self)
{
    if (self == NULL) return;
    jlt_stepper_destroy(self->stepper);
    free(self->at);
    free(self);
}

static jlt_status look_for_pole(jlt_orbit *self)
{
    if (self->stepper->field->root < 0 || self->options.ignore_pole) return JLT_OK;
    return jlt_pole_judge(&self->pole, self->stepper);
}

jlt_status jlt_orbit_start(jlt_orbit *self, double t, const double *x, int direction)
{
    if (direction != 1 && direction != -1) return JLT_ERR_ARG;
    self->watch_count = self->pending_count = self->next_pending = 0;
    self->cursor = 1;
    self->told = NAN;
    self->pole = (jlt_pole_verdict){ .ends = false };
    JLT_PASS(jlt_stepper_start(self->stepper, t, x, direction, self->options.first_step));
    jlt_invariant_begin(&self->invariants, &self->options.invariants, self->stepper->x);
    self->pace_step = self->stepper->steps + self->stepper->rejected;
    self->pace_time = jlt_stepper_time(self->stepper);
    self->paced = 0;
    self->told = t;
    return look_for_pole(self);
}

void jlt_orbit_observe(jlt_orbit *self, jlt_observer observer, void *context)
{
    self->observer = observer;
    self->observer_context = context;
}

jlt_status jlt_orbit_replace(jlt_orbit *self, const double *x, const double *scale)
{
    return jlt_stepper_replace(self->stepper, x, scale);
}

const jlt_stepper *jlt_orbit_stepper(const jlt_orbit *self)
{
    return self->stepper;
}

jlt_status jlt_orbit_loss(jlt_orbit *self, double *theta, jlt_event_least *least, const jlt_event *event)
{
    *theta = INFINITY;
    const jlt_status st = jlt_loss_first(theta, self->stepper, event);
    if (st != JLT_OK || !(*theta <= 1)) return st;
    *least = jlt_loss_least(self->stepper, event, *theta);
    if (!(least->value <= 0)) *theta = INFINITY; /* the polynomial of values that are not all finite tells nothing */
    return st;
}

jlt_event_least jlt_orbit_least(jlt_orbit *self, const jlt_event *event)
{
    const double start = jlt_locate_value(event, self->stepper->x_start), end = jlt_locate_value(event, self->stepper->x);
    const jlt_event_least ends = end < start ? (jlt_event_least){ end, 1 } : (jlt_event_least){ start, 0 };

    if (jlt_stepper_dense(self->stepper) != JLT_OK) return ends;
    const jlt_event_least within = jlt_loss_least(self->stepper, event, 0);
    return within.value < ends.value ? within : ends;
}

jlt_status jlt_orbit_value(jlt_orbit *self, double *value, const jlt_event *event, double theta)
{
    JLT_PASS(self->stepper->method->partial(self->stepper, theta, self->slope));
    *value = jlt_locate_value(event, self->slope);
    return JLT_OK;
}

void jlt_orbit_drift(const jlt_orbit *self, double *drift)
{
    memcpy(drift, self->invariants.drift, self->options.invariants.count * sizeof *drift);
}

/* Crossings of all events on the last step, merged in order. */
static jlt_status locate_step(jlt_orbit *self)
{
    jlt_crossing list[JLT_CROSSINGS_MAX];

    self->pending_count = self->next_pending = 0;
    for (unsigned e = 0; e < self->watch_count; e++) {
        unsigned count;
        if (self->watch[e].event.loss) JLT_PASS(jlt_loss_step(&self->watch[e].event, self->stepper, list, &count));
        else JLT_PASS(jlt_watch_step(&self->watch[e], self->stepper, list, &count));
        for (unsigned i = 0; i < count; i++) {
            unsigned at = self->pending_count++;
            list[i].event = e;
            for (; at > 0 && self->pending[at - 1].theta > list[i].theta; at--) self->pending[at] = self->pending[at - 1];
            self->pending[at] = list[i];
        }
    }
    return JLT_OK;
}

/* Take over the list of events. If it is a new one, locate its crossings on the rest of the last step. */
static jlt_status watch_events(jlt_orbit *self, const jlt_event *events, unsigned count)
{
    bool same = count == self->watch_count;
    for (unsigned e = 0; same && e < count; e++) same = jlt_event_same(&events[e], &self->watch[e].event);
    if (same) return JLT_OK;
    unsigned ahead = 0;
    self->watch_count = count;
    for (unsigned e = 0; e < count; e++) jlt_watch_begin(&self->watch[e], &events[e], self->stepper);
    self->pending_count = self->next_pending = 0;
    if (self->stepper->h == 0 || self->cursor >= 1) return JLT_OK;
    for (unsigned e = 0; e < count; e++) {
        const double before = jlt_locate_value(&events[e], self->stepper->x_start);
        self->watch[e].side = (before > 0) - (before < 0);
    }
    JLT_PASS(locate_step(self));
    for (unsigned i = 0; i < self->pending_count; i++) { /* refined, as the crossing last returned, which may be among them */
        jlt_crossing crossing = self->pending[i];
        JLT_PASS(jlt_watch_refine(&self->watch[crossing.event], &crossing, self->at, self->slope, self->stepper));
        if (crossing.theta > self->cursor + same_point) self->pending[ahead++] = self->pending[i];
    }
    self->pending_count = ahead;
    return JLT_OK;
}

static void hand_out(jlt_orbit *self, jlt_outcome *out, jlt_end end, double theta)
{
    const jlt_stepper *stepper = self->stepper;
    self->cursor = theta;
    *out = (jlt_outcome){ .end = end, .x = self->at };
    out->tau = theta == 1 ? stepper->tau : stepper->tau_start + theta * stepper->h;
    self->told = out->t = stepper->columns > stepper->field->dim ? self->at[stepper->field->dim] : out->tau;
}

static void hand_out_point(jlt_orbit *self, jlt_outcome *out, jlt_end end)
{
    memcpy(self->at, self->stepper->x, self->stepper->stride * sizeof *self->at);
    hand_out(self, out, end, 1);
}

/* Up to rounding: the last step to t_end may fall short of it by an ulp. */
static bool at_time(const jlt_stepper *stepper, double t)
{
    const double now = jlt_stepper_time(stepper);
    return fabs(now - t) <= 4 * DBL_EPSILON * jlt_larger(fabs(now), fabs(stepper->h));
}

/* Hand out the state at physical time t_end inside the last step. */
static jlt_status hand_out_time(jlt_orbit *self, jlt_outcome *out, double t_end)
{
    jlt_stepper *stepper = self->stepper;
    const double now = jlt_stepper_time(stepper), from = jlt_stepper_time_start(stepper);
    jlt_crossing at = { .theta = now == from ? 1 : (t_end - from) / (now - from), .direction = 1 };

    if (at_time(stepper, t_end)) {
        hand_out_point(self, out, JLT_END_TIME);
    } else if (stepper->columns == stepper->field->dim) {
        JLT_PASS(stepper->method->partial(stepper, at.theta, self->at));
        hand_out(self, out, JLT_END_TIME, at.theta);
    } else {
        const jlt_event clock = { .column = stepper->field->dim, .level = t_end };
        JLT_PASS(jlt_locate_refine(&at, self->at, self->slope, &clock, stepper));
        hand_out(self, out, JLT_END_TIME, at.theta);
    }
    self->told = out->t = t_end;
    return JLT_OK;
}

/* Hand out what the last step still holds: a crossing, or t_end, whichever is first. *found: whether there was one. */
static jlt_status rest_of_step(jlt_orbit *self, jlt_outcome *out, bool *found, double t_end)
{
    jlt_stepper *stepper = self->stepper;
    *found = false;

    if (self->next_pending < self->pending_count) {
        jlt_crossing crossing = self->pending[self->next_pending];
        JLT_PASS(jlt_watch_refine(&self->watch[crossing.event], &crossing, self->at, self->slope, stepper));
        const double theta = fmax(crossing.theta, self->cursor < 1 ? self->cursor : 0);
        const double t = stepper->columns > stepper->field->dim ? self->at[stepper->field->dim]
                                                                : stepper->tau_start + theta * stepper->h;
        if ((t - t_end) * stepper->direction <= 0) {
            self->next_pending++;
            hand_out(self, out, JLT_END_EVENT, crossing.theta);
            out->crossing = crossing;
            *found = true;
            return JLT_OK;
        }
    }
    if ((jlt_stepper_time(stepper) - t_end) * stepper->direction >= 0 || at_time(stepper, t_end)) {
        JLT_PASS(hand_out_time(self, out, t_end));
        *found = true;
    }
    return JLT_OK;
}

/* Whether the orbit reaches the pole before t_end, or so soon that the time does not change. */
static bool ends_before(const jlt_orbit *self, double t_end)
{
    const double pole = self->pole.t_end;
    return (pole - t_end) * self->stepper->direction <= 0 || pole == jlt_stepper_time(self->stepper);
}

static void hand_out_pole(jlt_orbit *self, jlt_outcome *out)
{
    hand_out_point(self, out, JLT_END_POLE);
    for (unsigned i = 0; i < self->stepper->field->dim; i++) self->at[i] -= self->pole.approach.left[i];
    self->at[self->stepper->field->root] = 0;
    self->told = out->t = self->pole.t_end;
    out->tau = self->stepper->direction * INFINITY;
    out->pole_rates[0] = self->pole.mu;
    out->pole_rates[1] = self->pole.approach.slowest;
}

/* Make one step, then watch invariants, locate crossings, and look for a pole. */
static jlt_status advance(jlt_orbit *self, double limit)
{
    JLT_PASS(jlt_stepper_advance(self->stepper, limit));
    self->cursor = 0;
    if (self->options.invariants.count > 0)
        JLT_PASS(jlt_invariant_watch_step(&self->invariants, &self->options.invariants, self->stepper,
                                          self->options.project));
    JLT_PASS(locate_step(self));
    return look_for_pole(self);
}

/* The longest step that the events allow. */
static double longest_step(const jlt_orbit *self)
{
    const jlt_stepper *stepper = self->stepper;
    double longest = INFINITY;

    for (unsigned e = 0; e < self->watch_count; e++) {
        const jlt_event *event = &self->watch[e].event;
        if (event->longest_step != NULL)
            longest = fmin(longest, event->longest_step(event->context, stepper->x, stepper->f, stepper->direction));
    }
    return longest;
}

/* Whether `steps` more steps may take the orbit to t_end; or, where t_last is known, max_steps to that. They may not if the motion
 * is stiff and they would not go even a fourth of the way, supposing that the physical time of PACE steps grows by the same factor
 * each time as it did last. */
static bool may_arrive(jlt_orbit *self, double t_end, size_t steps)
{
    const size_t total = self->stepper->steps + self->stepper->rejected;

    if (total - self->pace_step < PACE) return true;
    self->pace_step = total;
    if (self->options.t_last != 0) {
        t_end = self->options.t_last;
        steps = self->options.max_steps;
    }
    const double now = jlt_stepper_time(self->stepper), made = fabs(now - self->pace_time), growth = fmax(made / self->paced, 1);
    const double rounds = (double)steps / PACE, rest = fabs(t_end - now);
    const double ahead = made * (growth > 1 ? growth * expm1(rounds * log(growth)) / (growth - 1) : rounds);
    const bool told = self->paced > 0 && isfinite(rest) && jlt_stepper_is_held(self->stepper);

    self->pace_time = now;
    self->paced = made;
    return !told || 4 * ahead >= rest;
}

/* Whether a call may ask for this time: the orbit is started, and it does not turn back, but for rounding. */
static bool lies_ahead(const jlt_orbit *self, double t_end)
{
    const double slack = 4 * DBL_EPSILON * jlt_larger(fabs(self->told), fabs(self->stepper->h));
    return !isnan(self->told) && (!isfinite(t_end) || (t_end - self->told) * self->stepper->direction >= -slack);
}

jlt_status jlt_orbit_next(jlt_orbit *self, double t_end, const jlt_event *events, unsigned count, jlt_outcome *out)
{
    jlt_status st = JLT_OK;
    jlt_stepper *stepper = self->stepper;
    const size_t spent = stepper->steps + stepper->rejected;
    bool found = false;

    if (count > JLT_ORBIT_EVENTS_MAX || isnan(t_end) || !lies_ahead(self, t_end)) return JLT_ERR_ARG;
    for (unsigned e = 0; e < count; e++)
        if (!jlt_event_is_valid(&events[e], stepper->columns)) return JLT_ERR_ARG;
    if (!isfinite(t_end)) t_end = stepper->direction * INFINITY;
    JLT_TRY(watch_events(self, events, count));

    for (;;) {
        JLT_TRY(rest_of_step(self, out, &found, t_end));
        if (found) return JLT_OK;
        if (self->pole.ends && ends_before(self, t_end)) {
            hand_out_pole(self, out);
            return JLT_OK;
        }
        if (self->options.interrupt != NULL && *self->options.interrupt) {
            hand_out_point(self, out, JLT_END_INTERRUPT);
            return JLT_OK;
        }
        const size_t used = stepper->steps + stepper->rejected - spent;
        if (used >= self->options.max_steps || !may_arrive(self, t_end, self->options.max_steps - used)) {
            st = JLT_ERR_BUDGET;
            goto done;
        }
        /* In its own time a step ends at t_end at the latest: there may be no field beyond. */
        const double limit = stepper->columns > stepper->field->dim ? INFINITY : fabs(t_end - stepper->tau);
        JLT_TRY(advance(self, jlt_smaller(limit, longest_step(self))));
        if (self->observer != NULL && self->observer(self->observer_context, self) != 0) {
            hand_out_point(self, out, JLT_END_OBSERVER);
            return JLT_OK;
        }
    }
done:
    if (st != JLT_OK) hand_out_point(self, out, JLT_END_TIME);
    return st;
}

jlt_status jlt_orbit_propagate(jlt_orbit *self, double t_end, double *x)
{
    jlt_outcome out = { .x = NULL };
    const jlt_status st = jlt_orbit_next(self, t_end, NULL, 0, &out);

    if (out.x != NULL) memcpy(x, out.x, self->stepper->field->dim * sizeof *x);
    return st == JLT_OK && out.end == JLT_END_POLE ? JLT_ERR_DOMAIN : st;
}

jlt_status jlt_orbit_sample(jlt_orbit *self, double *states, size_t *done, const double *times, size_t count)
{
    const unsigned dim = self->stepper->field->dim;
    jlt_outcome out;

    for (*done = 0; *done < count; ++*done) {
        JLT_PASS(jlt_orbit_next(self, times[*done], NULL, 0, &out));
        if (out.end == JLT_END_POLE) return JLT_ERR_DOMAIN;
        if (out.end != JLT_END_TIME) return JLT_OK;
        memcpy(states + *done * dim, out.x, dim * sizeof *states);
    }
    return JLT_OK;
}
