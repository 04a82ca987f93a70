#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/guard.h"
#include "core/memory.h"
#include "integrate/edge.h"
#include "integrate/method.h"
#include "integrate/step_control.h"

enum { ATTEMPTS_MAX = 12, APPROACHES_MAX = 30 };

static const double long_again = 0x1p-30; /* part of tau: after a longer step leaps are counted anew */

/* A step that is long enough to change the time. */
static double shortest_step(const jlt_stepper *self) { return 8 * DBL_EPSILON * fabs(self->tau); }

/* Set the scales for an orbit that starts at self->x with the rates self->f. Scales past the columns, where all is 0, are 1. The
 * shortest step moves a state by a hundredth of its scale at most, unless the scale is 1: otherwise no step would be short enough
 * for a phase that starts at 0 beside states of 1e-20. */
static void set_scales(jlt_stepper *self)
{
    const jlt_field *field = self->field;
    const unsigned controlled = field->controlled != 0 ? field->controlled : field->dim;

    self->size = jlt_field_size_at(field, self->x);
    for (unsigned i = 0; i < self->stride; i++) self->scale[i] = 1;
    for (unsigned i = 0; i < field->dim; i++) {
        const bool stays = jlt_field_keeps(field, i) && self->x[i] == 0; /* a kept state that starts at 0 stays 0 */
        const double small = stays ? self->size : jlt_field_small(field, i, self->size);
        const double moved = 100 * shortest_step(self) * fabs(self->f[i]);
        self->scale[i] = i >= controlled ? INFINITY : small > 0 ? fmax(small, fmin(1, moved)) : JLT_STEPPER_SCALE_LEAST;
    }
    memcpy(self->full_scale, self->scale, self->stride * sizeof *self->scale);
}

/* Fit the scale of state i, if it is controlled, to the size of its group. Returns whether it changes. */
static bool fit_scale(jlt_stepper *self, unsigned i, double largest)
{
    const double before = self->scale[i], full = self->full_scale[i];
    const double fitted = largest > 0 ? jlt_larger(JLT_FIELD_SPREAD * largest, JLT_STEPPER_SCALE_LEAST) : full;

    if (full < INFINITY) self->scale[i] = jlt_smaller(full, fitted);
    return self->scale[i] < before || self->scale[i] > before;
}

/* The largest state of a group; x: the states, or the components of a tangent vector along them. */
static double largest_of(const double *x, const jlt_state_groups *groups, unsigned g)
{
    double largest = 0;

    for (unsigned k = groups->first[g]; k < groups->first[g + 1]; k++) largest = jlt_larger(largest, fabs(x[groups->member[k]]));
    return largest;
}

/* Fit the scales of states that are 0 only together to the largest of them, in the smallest of a state's groups; where a group is
 * 0, those of the components of tangent vectors along it. */
static void fit_groups(jlt_stepper *self)
{
    const jlt_state_groups *groups = &self->field->groups;
    const unsigned members = groups->first[groups->count];
    double size[JLT_STATE_SET_MAX];

    self->rescaled = false;
    for (unsigned v = 0; v <= self->field->tangents && members > 0; v++) {
        const unsigned first = v * self->field->domain.states;
        for (unsigned k = 0; k < members; k++) size[groups->member[k]] = INFINITY;
        for (unsigned g = 0; g < groups->count; g++) {
            if (v > 0 && largest_of(self->x, groups, g) > 0) continue;
            const double largest = largest_of(self->x + first, groups, g);
            for (unsigned k = groups->first[g]; k < groups->first[g + 1]; k++)
                size[groups->member[k]] = jlt_smaller(largest, size[groups->member[k]]);
        }
        for (unsigned k = 0; k < members; k++) {
            const unsigned i = groups->member[k];
            if (size[i] < INFINITY) self->rescaled |= fit_scale(self, first + i, size[i]);
        }
    }
}

/* Whether the domain is one that steps can watch: of states that the field has, and with gradients of its conditions. */
static bool can_watch(const jlt_domain *domain, unsigned dim)
{
    if (domain->states > dim || domain->states > JLT_DOMAIN_STATES_MAX) return false;
    if (domain->conditions > JLT_REGION_CONDITIONS_MAX) return false;
    return domain->conditions == 0 || (domain->values != NULL && domain->gradients != NULL);
}

jlt_status jlt_stepper_create(jlt_stepper **out, const jlt_method *method, const jlt_field *field, double tolerance,
                              double max_step)
{
    static const double finest = 1e-15; /* no share makes the tolerance smaller: error estimates drown in rounding there */
    jlt_status st = JLT_OK;
    jlt_stepper *self = NULL;
    double *block;

    *out = NULL;
    if (method == NULL) method = jlt_method_find(NULL);
    if (field == NULL || field->call == NULL) return JLT_ERR_ARG;
    if (field->dim == 0 || field->dim > JLT_FIELD_DIM_MAX || field->controlled > field->dim) return JLT_ERR_ARG;
    if (field->root >= (int)field->dim || !can_watch(&field->domain, field->dim)) return JLT_ERR_ARG;
    for (unsigned i = 0; field->scale != NULL && i < field->dim; i++)
        if (!(field->scale[i] >= 0)) return JLT_ERR_ARG;
    if (!(tolerance > 0) || !(tolerance < 1) || !(max_step > 0)) return JLT_ERR_ARG;
    if (method->needs_jet && field->jet == NULL) return JLT_ERR_UNSUPPORTED;

    self = jlt_memory_array(1, sizeof *self);
    if (self == NULL) return JLT_ERR_NOMEM;
    self->method = method;
    self->field = field;
    self->asked = tolerance;
    self->tolerance = jlt_larger(tolerance * method->share, jlt_smaller(tolerance, finest));
    self->max_step = max_step;
    self->direction = 1;
    self->columns = field->dim + (field->time_rate != NULL);
    self->controlled = self->columns - (field->controlled != 0 ? field->dim - field->controlled : 0);
    self->stride = (self->columns + JLT_STEPPER_WIDTH - 1) / JLT_STEPPER_WIDTH * JLT_STEPPER_WIDTH;
    block = jlt_memory_array((7 + JLT_DENSE_DEGREE_MAX + 1) * (size_t)self->stride
                                 + (size_t)field->domain.conditions * field->domain.states, sizeof *block);
    if (block == NULL) {
        st = JLT_ERR_NOMEM;
        goto done;
    }
    self->x = block;
    self->x_low = self->x + self->stride;
    self->f = self->x_low + self->stride;
    self->x_start = self->f + self->stride;
    self->f_start = self->x_start + self->stride;
    self->scale = self->f_start + self->stride;
    self->full_scale = self->scale + self->stride;
    self->dense = self->full_scale + self->stride;
    self->gradients = self->dense + (JLT_DENSE_DEGREE_MAX + 1) * (size_t)self->stride;
    JLT_TRY(method->create(self));
    *out = self;
    self = NULL;
done:
    jlt_stepper_destroy(self);
    return st;
}

void jlt_stepper_destroy(jlt_stepper *self)
{
    if (self == NULL) return;
    self->method->destroy(self);
    free(self->x);
    free(self);
}

/* Make the last step an empty one at the point. */
static void forget_step(jlt_stepper *self)
{
    const size_t size = self->stride * sizeof *self->x;
    self->tau_start = self->tau;
    self->h = 0;
    self->dense_ready = false;
    memcpy(self->x_start, self->x, size);
    memcpy(self->f_start, self->f, size);
}

/* Note state i as lost: nothing is left of it but errors. From 0 itself it would never come back, as no rate moves it there, and
 * the orbit would seem to go on; so it gets the size of an error. */
static void lose(jlt_stepper *self, unsigned i)
{
    static const double error = DBL_EPSILON * JLT_STEPPER_SCALE_LEAST;

    jlt_state_set_add(&self->lost, i);
    self->watches = true;
    if (fabs(self->x[i]) >= error) return;
    self->x[i] = copysign(error, self->x_start[i]);
    self->x_low[i] = 0;
}

/* Whether what had this size is below the least scale, and not because it grows from 0, where no rate keeps it. */
static bool is_lost(double before, double now) { return now < JLT_STEPPER_SCALE_LEAST && before > 0 && before >= now; }

static void note_lost_groups(jlt_stepper *self)
{
    const jlt_state_groups *groups = &self->field->groups;

    for (unsigned g = 0; g < groups->count; g++) {
        if (!is_lost(largest_of(self->x_start, groups, g), largest_of(self->x, groups, g))) continue;
        for (unsigned k = groups->first[g]; k < groups->first[g + 1]; k++) lose(self, groups->member[k]);
    }
}

static void note_lost(jlt_stepper *self)
{
    for (unsigned at = 0; at < JLT_STATE_SET_MAX; at += 64) {
        const uint64_t kept = self->field->kept.words[at / 64];
        for (unsigned i = 0; i < 64 && kept >> i != 0; i++)
            if ((kept >> i & 1) != 0 && is_lost(fabs(self->x_start[at + i]), fabs(self->x[at + i]))) lose(self, at + i);
    }
    note_lost_groups(self);
}

jlt_status jlt_stepper_start(jlt_stepper *self, double t, const double *x, double direction, double first_step)
{
    const unsigned dim = self->field->dim;
    jlt_guard guard;

    if (!isfinite(t) || !jlt_guard_finite(x, dim)) return JLT_ERR_NONFINITE;
    memcpy(self->x, x, dim * sizeof *x);
    if (self->columns > dim) self->x[dim] = t;
    memset(self->x_low, 0, self->stride * sizeof *self->x_low);
    self->tau = t;
    self->tau_low = 0;
    self->approaches = 0;
    self->direction = direction < 0 ? -1 : 1;
    self->h_next = first_step > 0 ? first_step : 0;
    jlt_guard_enter(&guard);
    jlt_field_rates(self->field, self->f, self->x);
    JLT_PASS(jlt_guard_leave_finite(&guard));
    self->evaluations++;
    forget_step(self);
    set_scales(self);
    fit_groups(self);
    self->lost = (jlt_state_set){ 0 };
    self->watches = jlt_field_restricts(self->field);
    note_lost(self);
    self->at_edge = jlt_edge_is_outside(self);
    if (!jlt_guard_finite(self->f, self->columns)) return JLT_ERR_NONFINITE;
    JLT_PASS(self->method->start(self));
    self->h_next = fmax(self->h_next, shortest_step(self));
    return JLT_OK;
}

jlt_status jlt_stepper_replace(jlt_stepper *self, const double *x, const double *scale)
{
    if (!jlt_guard_finite(x, self->field->dim)) return JLT_ERR_NONFINITE;
    for (unsigned i = 0; scale != NULL && i < self->field->dim; i++) self->scale[i] = self->full_scale[i] = scale[i];
    for (unsigned i = 0; i < self->field->dim; i++)
        if (x[i] < self->x[i] || x[i] > self->x[i]) self->x_low[i] = 0;
    memcpy(self->x, x, self->field->dim * sizeof *x);
    fit_groups(self);
    jlt_field_rates(self->field, self->f, self->x);
    self->evaluations++;
    self->dense_ready = false;
    return self->method->start(self);
}

/* Undo the last step: go back to its start. */
static jlt_status step_back(jlt_stepper *self)
{
    const size_t size = self->stride * sizeof *self->x;
    memcpy(self->x, self->x_start, size);
    memcpy(self->f, self->f_start, size);
    memset(self->x_low, 0, size);
    forget_step(self);
    return self->method->start(self);
}

/* Replace a step that led out of the domain at theta by one that ends before that place, and within the tolerance of the domain's
 * end if the longer step's polynomial was accurate enough. Returns DOMAIN, at the step's start, if that is so near the end that no
 * step can be made. */
static jlt_status approach_edge(jlt_stepper *self, double theta)
{
    for (int attempt = 0; attempt < ATTEMPTS_MAX && self->approaches < APPROACHES_MAX; attempt++) {
        const double length = fabs(self->h);
        JLT_PASS(jlt_edge_find(&theta, self));
        JLT_PASS(step_back(self));
        self->rejected++;
        if (!(theta > 0) || self->method->step(self, theta * length) != JLT_OK) return JLT_ERR_DOMAIN;
        self->dense_ready = false;
        JLT_PASS(jlt_edge_left(&theta, self));
        if (theta > 1) {
            self->approaches++;
            self->at_edge = jlt_edge_reached(self);
            return JLT_OK;
        }
    }
    JLT_PASS(step_back(self));
    return JLT_ERR_DOMAIN;
}

/* Whether the change of the rates within the last step is so small that it makes no error above the tolerance, even over all the
 * time until now. What an overflow removes from the rates is missing from there on. */
static bool is_steady(const jlt_stepper *self)
{
    const double time = jlt_larger(fabs(self->h), fabs(self->tau));

    for (unsigned i = 0; i < self->field->dim; i++) {
        const double change = fabs(time * (self->f[i] - self->f_start[i]));
        if (!(change <= self->asked * jlt_larger(fabs(self->x[i]), self->scale[i]))) return false;
    }
    return true;
}

/* Undo the last step if a kernel overflows at its end and the rates change there: its one division, by the product of all
 * denominators, then gives a rate of 0. A force that fades far away is 0 to rounding before that. */
static jlt_status stay_finite(jlt_stepper *self)
{
    jlt_guard guard;

    if (fetestexcept(FE_OVERFLOW) == 0) return JLT_OK;
    jlt_guard_enter(&guard);
    jlt_field_rates(self->field, self->f, self->x);
    const jlt_status st = jlt_guard_leave_finite(&guard);
    if (st == JLT_OK || is_steady(self)) return JLT_OK;
    JLT_PASS(step_back(self));
    return st;
}

/* Keep the last step if it stays in the domain, else replace it by a shorter one. On failure no step is taken. */
static jlt_status stay_inside(jlt_stepper *self)
{
    double left;

    self->dense_ready = false;
    jlt_status st = jlt_edge_left(&left, self);
    if (st == JLT_OK && left > 1) return JLT_OK;
    if (st == JLT_OK) {
        st = approach_edge(self, left);
        if (st != JLT_ERR_NO_CONVERGENCE) return st;
    }
    const jlt_status back = step_back(self);
    return back != JLT_OK ? back : st;
}

/* Make a step that stays in the domain. A partial step across a jump of a rate may not converge: then a step of half the length is
 * tried. */
static jlt_status step_inside(jlt_stepper *self, double limit)
{
    jlt_status st = JLT_ERR_NO_CONVERGENCE;

    for (int attempt = 0; attempt < ATTEMPTS_MAX && st == JLT_ERR_NO_CONVERGENCE; attempt++) {
        st = self->method->step(self, limit);
        if (st == JLT_OK) st = stay_finite(self);
        if (st != JLT_OK) break;
        limit = fabs(self->h) / 2;
        st = stay_inside(self);
    }
    return st;
}

jlt_status jlt_stepper_advance(jlt_stepper *self, double limit)
{
    static const double longest = 0x1p800; /* at rest the error control lengthens steps without end */
    const double tau = self->tau;
    jlt_status st = self->at_edge ? JLT_ERR_DOMAIN : step_inside(self, jlt_smaller(limit, longest));
    if ((st == JLT_ERR_NONFINITE || st == JLT_ERR_NO_PROGRESS) && jlt_edge_is_ahead(self)) st = JLT_ERR_DOMAIN;
    if (st != JLT_OK) return st;

    const double move = self->h + self->tau_low;
    self->tau_start = tau;
    self->tau = tau + move;
    self->tau_low = (tau - self->tau) + move;
    self->steps++;
    note_lost(self);
    fit_groups(self);
    if (fabs(self->h) > long_again * fabs(tau)) self->leaps = 0;
    return JLT_OK;
}

double jlt_stepper_time(const jlt_stepper *self)
{
    return self->columns > self->field->dim ? self->x[self->field->dim] : self->tau;
}

double jlt_stepper_time_start(const jlt_stepper *self)
{
    return self->columns > self->field->dim ? self->x_start[self->field->dim] : self->tau_start;
}

bool jlt_stepper_is_held(const jlt_stepper *self)
{
    static const double least = 1e-4;

    for (unsigned i = 0; i < self->field->dim; i++)
        if (!(fabs(self->x[i] - self->x_start[i]) < least * jlt_larger(fabs(self->x[i]), self->scale[i]))) return false;
    return true;
}
