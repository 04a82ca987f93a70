/** Events: zeros of a function along the orbit, found on the step's polynomial and refined on the flow itself.
 *
 *  Between two accepted points the event function is a polynomial in theta; all its zeros on the step are isolated by
 *  subdivision of its Bernstein form, so two zeros in a step are two crossings. Its end values are those of the computed
 *  points, shared by neighbouring steps, and the side the orbit is on is remembered: a crossing is counted where the side
 *  changes, once, wherever the step ends fall. A start on the section belongs to the side it leaves to and is no crossing.
 *  Each zero is refined by Newton's method on states computed by a fresh step from the start of the step, so its error is
 *  that of the method and not of the polynomial. Where an extremum of g is as near to 0 as the polynomial's error, so that the
 *  polynomial does not tell whether g changes sign there, the extremum is refined in the same way: zeros on both sides of it are
 *  two crossings, and an extremum that is 0 to rounding is a touch, which is reported as grazing. */
#ifndef JLT_INTEGRATE_EVENT_H
#define JLT_INTEGRATE_EVENT_H

#include "integrate/method.h"

typedef enum { JLT_FALLING = -1, JLT_BOTH = 0, JLT_RISING = 1 } jlt_direction; /* for growing t */

/** g(x) = x[column] - level when value is NULL. Otherwise g is any smooth function: value(context, x) and, when not NULL,
 *  rate(context, x, f), its derivative along the flow. Such a function is followed as a polynomial of degree 12 over a step: one
 *  that oscillates more than twice within it needs a `longest_step`. */
typedef struct {
    unsigned column;
    double level;
    double (*value)(void *context, const double *x);
    double (*rate)(void *context, const double *x, const double *f);
    /* value at JLT_STEPPER_NODES states at once, x (states, JLT_STEPPER_NODES), aligned for vectors; NULL: one at a time. */
    void (*values)(void *context, double *out, const double *x);
    void *context;
    jlt_direction direction;
    bool grazing; /* report touches too, whatever the direction asked for */
    bool loss;    /* report, instead, the first place in a step where the function ceases to be positive, near its poles too
                     (loss.h) */
    /* Largest allowed |dtau| of a step from x, where f is the field, in this direction of tau: for fields that are rough near
     * g = 0. NULL: no limit. */
    double (*longest_step)(void *context, const double *x, const double *f, double direction);
} jlt_event;

typedef struct {
    unsigned event;   /* index in the list of events that the caller gave */
    int direction;    /* JLT_RISING, JLT_FALLING for growing t; 0: grazing */
    double theta;     /* where in the last step, 0 at its start and 1 at its end; below 0: before it, see jlt_watch_refine */
    double residual;  /* g there */
    double slope;     /* dg/dtau there */
} jlt_crossing;

/** Whether a field of so many columns can watch this event: its column, level and direction are such. */
static inline bool jlt_event_is_valid(const jlt_event *event, unsigned columns)
{
    const int direction = (int)event->direction;

    return direction >= -1 && direction <= 1 && (event->value != NULL || (event->column < columns && isfinite(event->level)));
}

/** Whether two events are the same. */
static inline bool jlt_event_same(const jlt_event *a, const jlt_event *b)
{
    return a->value == b->value && a->values == b->values && a->context == b->context && a->rate == b->rate
           && a->longest_step == b->longest_step && a->direction == b->direction && a->grazing == b->grazing
           && a->loss == b->loss && a->column == b->column && !(a->level < b->level) && !(a->level > b->level);
}

/** The least value of an event's function within a step, and at which fraction of the step. */
typedef struct {
    double value, theta;
} jlt_event_least;

#endif
