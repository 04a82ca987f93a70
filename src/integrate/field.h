/** A field to integrate: dx/dtau = f(x), autonomous, with its time and whatever else is known of it. Plain data; nothing is
 *  owned.
 *
 *  A field in a time of its own (dt = factor(x) dtau) carries the physical time t as a quadrature: the integrator keeps it
 *  as one more component after the states, with the same order and in the same error control. */
#ifndef JLT_INTEGRATE_FIELD_H
#define JLT_INTEGRATE_FIELD_H

#include <stdbool.h>

#include "core/status.h"
#include "integrate/state_set.h"
#include "kernel/instance.h"
#include "kernel/region.h"

/* JLT_FIELD_DIM_MAX: 128 states, their derivatives by 127 coordinates, and one integral. JLT_JACOBIAN_DIM_MAX: orbits of a field
 * with more states are not tested for poles, and come to rest only where they are slower than JLT_REST_STILL. */
enum { JLT_FIELD_DIM_MAX = 128 * 128 + 1, JLT_JACOBIAN_DIM_MAX = 32 };

enum { JLT_DOMAIN_STATES_MAX = JLT_STATE_SET_MAX }; /* as in a table, with lifted roots */

/** Where a field is defined: in open intervals of its states, and where conditions on them are positive. */
typedef struct {
    unsigned states;               /* leading columns that are restricted, <= JLT_DOMAIN_STATES_MAX */
    const jlt_quantity *intervals; /* (states,); NULL: not watched */
    unsigned conditions;           /* <= JLT_REGION_CONDITIONS_MAX; 0: none */
    jlt_kernel_function values,    /* x, p -> (conditions,), > 0 inside */
        gradients;                 /* x, p -> (conditions, states); needed as well where there are conditions */
    const double *p;               /* passed through */
} jlt_domain;

/** A state's error is relative to larger states beside it, but to at most this many times the state itself: six bits, or less than
 *  two digits, of it are lost. */
enum { JLT_FIELD_SPREAD = 64 };

typedef struct {
    unsigned dim;                  /* 1 .. JLT_FIELD_DIM_MAX */
    jlt_kernel_function call;      /* x (dim,), p -> dx/dtau (dim,) */
    const double *p;               /* passed through: prepared values, or a structure aligned for double, cast */
    jlt_kernel_function time_rate; /* x, p -> dt/dtau > 0 (1,); NULL: tau is t */
    jlt_kernel_function jacobian;  /* x, p -> df/dx (dim, dim); NULL where not known */
    jlt_kernel_jet jet;            /* NULL where not known; the method taylor needs it */
    const jlt_kernel_batch *batch; /* the same field on vectors, for the method gauss; NULL where not known */
    unsigned controlled;           /* leading states in the error norm; 0: all of them */
    int root;                      /* the lifted root whose zero is the pole, as an index into x. Set -1 for none: a zeroed
                                      structure makes x[0] the root */
    jlt_domain domain;             /* which orbits do not leave */
    const double *scale;           /* (dim,), >= 0, the size below which a state counts as small: its error is measured
                                      against max(|x_i|, scale_i). NULL: 1, and 0 for the root and the kept states,
                                      whose errors are relative */
    jlt_state_set kept;            /* the kept states: each keeps its sign, as its rate goes to 0 with it; its error is relative */
    jlt_state_groups groups;       /* of states that are 0 only together: their errors are relative to JLT_FIELD_SPREAD times
                                      jlt_field_group_size, where that is less than their scales */
    unsigned tangents;             /* how many tangent vectors along the domain's states follow these: where a group is 0, a
                                      vector's components along it are 0 only together */
    jlt_state_set angles;          /* these may grow by whole turns: in lanes other states' errors are not relative to them */
    unsigned sized;                /* leading states for which a scale of 1 means jlt_field_size of an orbit's start; 0: none */
} jlt_field;

/** dx/dtau at x, shape (dim,), and behind it dt/dtau where the field has a time of its own: f, shape (dim,) or (dim + 1,). */
static inline void jlt_field_rates(const jlt_field *field, double *f, const double *x)
{
    field->call(x, field->p, f);
    if (field->time_rate != NULL) field->time_rate(x, field->p, f + field->dim);
}

/** dt/dtau at x, shape (dim,): 1 where tau is t. */
static inline double jlt_field_time_rate(const jlt_field *field, const double *x)
{
    double rate = 1;

    if (field->time_rate != NULL) field->time_rate(x, field->p, &rate);
    return rate;
}

/** The size of an orbit, below which its states count as small. largest: the largest |state| at its start, the root left out. The
 *  size is 1 where largest is 0 or at least 1/64; else the largest power of two that is at most `largest`, but at least 2^-400, the
 *  squares of whose errors are doubles. */
double jlt_field_size(double largest);

/** The size of an orbit of this field that starts at x, shape (dim,): of the first `sized` states those with scale 1 count, and the
 *  kept ones. */
double jlt_field_size_at(const jlt_field *field, const double *x);

/** Whether state i is one of the kept ones. */
bool jlt_field_keeps(const jlt_field *field, unsigned i);

/** The scale of state i as the field declares it: 1 also for a state whose scale is in fact the orbit's size (`sized`). */
double jlt_field_scale(const jlt_field *field, unsigned i);

/** The size below which state i counts as small on an orbit of this size. */
double jlt_field_small(const jlt_field *field, unsigned i, double size);

/** How near a state may come to a finite bound of its domain, relative to the bound. Nearer, fewer than 16 bits of the distance
 *  are left, and a field that divides by the root of that distance has no correct digits worth speaking of. */
#define JLT_FIELD_NEAREST 0x1p-37

/** Whether the field's domain restricts orbits: by a finite interval, or a condition. */
bool jlt_field_restricts(const jlt_field *field);

/** The largest |x_j| in the smallest of the groups that state i is in; INFINITY where it is in none. */
double jlt_field_group_size(const jlt_field *field, const double *x, unsigned i);

/** Whether orbits may end within the field: its domain restricts them, or states may be lost near 0 (edge.h). */
bool jlt_field_watches(const jlt_field *field);

/** Name the state that grows without bound, where an integration has stopped at x, shape (dim,), at physical time t because its
 *  steps no longer change t. Returned is the index of the state that doubles first at its present rate, among those with |x_i| > 1
 *  that do so within 10^5 roundings of t; field->dim: none does. (Before a pole of the solution steps are no shorter than a
 *  thousandth of the time to the pole, so that 10^5 roundings cover it. A state that stays bounded, while its rate does not, is not
 *  named.) Cost: one evaluation of the field. */
unsigned jlt_field_unbounded(const jlt_field *field, const double *x, double t);

/** Make the field of a generated kernel, in the units of its instance, which must live as long as the field. It watches the
 *  conditions of the table's domain and the intervals of its states; the latter not in a time that lifts roots to states, where it
 *  need not. All states are sized; those are angles whose period the table proves; which ones are kept, or in groups, is judged by
 *  rates (signs.h). The last state is taken for the root that vanishes at a pole when the kernel has a time of its own
 *  and that state is bounded below by 0. Errors: ARG, NULL; UNSUPPORTED, the descriptor has no right-hand side, or more than
 *  JLT_FIELD_DIM_MAX states. */
JLT_CHECKED jlt_status jlt_field_of(jlt_field *out, const jlt_instance *instance);

#endif
