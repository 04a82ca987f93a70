/** Follows many orbits at once, one in each lane of a vector: section maps by explicit Runge-Kutta methods on batched kernels.
 *
 *  Every lane has its own step, its own error control and its own fate; a finished lane is refilled from the list of
 *  starts, so that none runs empty before the list ends. Crossings are queued and refined a full vector at a time. Orbits
 *  under different parameters, or on different levels, go side by side.
 *  Lanes do not see each other: an orbit's rows do not depend on its neighbours or on its lane. */
#ifndef JLT_INTEGRATE_BATCH_H
#define JLT_INTEGRATE_BATCH_H

#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "integrate/field.h"
#include "kernel/instance.h"

/** The factor by which a tangent vector may lengthen in a lane. A longer one may come from a close passage, in which lanes lose
 *  more digits than a return may. */
enum { JLT_BATCH_STRETCHED = 10000 };

enum {
    JLT_BATCH_COLUMNS_MAX = 64,
    JLT_BATCH_STATES_MAX = JLT_BATCH_COLUMNS_MAX - 1, /* of a field; the clock is a column too */
    JLT_BATCH_CONDITIONS_MAX = 16
};

/** How a lane's orbit ended. */
typedef enum {
    JLT_LANE_DONE,    /* all its returns are made */
    JLT_LANE_ROOT,    /* the lifted root fell below root_floor and all else has come to rest: near a pole; go on from there with a
                         scalar method */
    JLT_LANE_DOMAIN,  /* the orbit would have left the domain, or may have: go on from there with a scalar method */
    JLT_LANE_STALLED, /* the step fell below what time resolves, a value is not finite, a tangent vector has more than
                         JLT_BATCH_STRETCHED times its length, or the root came back (root_least): go on from there with a scalar
                         method */
    JLT_LANE_BUDGET,  /* max_steps are spent on one return */
    JLT_LANE_DOUBTED  /* steps that were taken again, in two halves, differed by far more than their estimated errors, or
                         watch->ends applies: the rows so far are void; x is the start, from which to begin again with a scalar
                         method */
} jlt_lane_end;

/** What orbits of one map may differ in. Plain data; what it points to must live as long as it is used. */
typedef struct {
    const double *p;       /* prepared values, (kernels->prepared,) */
    double level;          /* the section is x[column] = level */
    const double *params;  /* for `project`: the parameters, in the states' units, that the descriptor's relation of a root takes */
    const double *watched; /* for `watch`: prepared values, (watch->kernels->prepared,) */
    const double *unit;    /* for `watch`: (dim,), its kernels take the states times these; NULL: states as they are */
} jlt_batch_case;

/** Conditions under which the model holds, by the kernel `valid_values`: evaluated at the end of every accepted step, and within it
 *  where one may break and hold again. A condition holds while its value is > 0. */
typedef struct {
    const jlt_kernel_batch *kernels; /* of the instruction set that the map's kernels have */
    unsigned count;                  /* 1 .. JLT_BATCH_CONDITIONS_MAX */
    bool until_lost;                 /* steps are watched only until a value is <= 0; rows count values at their points as well */
    bool seeks_least;                /* look within a step also where a value may only be less than the least so far */
    bool ends;                       /* an orbit on which a value is <= 0 or NaN ends as doubted: another method finds where */
} jlt_batch_watch;

/** The map, and how to compute it. Plain data; what it points to must live as long as it is used. */
typedef struct {
    const jlt_kernel_batch *kernels; /* of one instruction set, see jlt_batch_isa_best */
    const jlt_batch_case *cases;     /* parameters and levels of orbits */
    const size_t *case_of;           /* index of each orbit's case, shape (count,); NULL: all have the first */
    const size_t *returns_of;        /* how many each orbit makes, 1 or more, shape (count,); NULL: all make `returns` */
    unsigned dim;                    /* states */
    bool clock;                      /* physical time is carried as the last column, in starts, rows and ends */
    unsigned tangents;               /* tangent vectors carried by the variational equations, column by column after the states, and
                                        after them the integral of the divergence and, asked for or not, the clock; 0: none */
    unsigned column;                 /* the section is x[column] = level */
    double turn;                     /* that state is an angle of this period: level + k turn are the section as well, and rows and
                                        ends have it within half a turn of the level; 0: no angle */
    int direction;                   /* of crossings as time grows, +1: upwards; -1: downwards; 0: both */
    bool backwards;                  /* orbits are followed back in time */
    int root;                        /* index of the lifted root, whose error is controlled relative to itself. Set -1 for none: a
                                        zeroed structure makes x[0] the root */
    uint64_t kept;                   /* bit i: state i is kept (jlt_field): its error is compared with at most
                                        JLT_FIELD_SPREAD times itself, however small it is */
    const jlt_state_groups *groups;  /* as of jlt_field; NULL: none */
    uint64_t angles;                 /* bit i: state i is an angle, as of jlt_field: no other state's error is relative to it */
    double root_floor;               /* end near a pole when root <= this and every |x_i'| <= root_rest max(size, |x_i|) */
    double root_rest;                /* 0: rates are not tested; otherwise a root <= root_floor also ends the lane once max_steps
                                        are spent, and a root <= 1e-100 at once */
    double root_least;               /* the root's error is relative to max(root, this); a root that falls below this and returns
                                        above twice it ends with JLT_LANE_STALLED. 0: relative to the root itself */
    const jlt_domain *domain;        /* orbits end with JLT_LANE_DOMAIN where they leave it: that of the map's kernels, at most
                                        JLT_BATCH_CONDITIONS_MAX conditions; NULL: not watched */
    const struct jlt_batch_method *method; /* one of jlt_batch_method_at; NULL: the usual one for the tolerance */
    double tolerance;                /* of the local error, in (0, 1): the root mean square over states, the clock added. A state's
                                        error is relative to M = max(size, largest |x_j| but for root and angles), or
                                        JLT_FIELD_SPREAD times max(size, |x_i|) if that is less, or times the largest of its group,
                                        size being jlt_field_size of the orbit's start; an angle's to M, but it may be 64
                                        roundings; the clock's to M over the size; the root's to the root */
    size_t max_steps;                /* of one return, accepted and rejected; one at a bend of the rates, and the few after it,
                                        count an eighth each */
    unsigned threads;                /* 0 and 1: the caller's alone */
    const jlt_descriptor *project;   /* descriptor whose integrals are restored: after every step that crosses the section, unless
                                        that would lead back across it, orbits are put back onto their starts' levels of its
                                        integrals and, with a root, of root^2 - radicand; NULL: no projection */
    const jlt_batch_watch *watch;    /* NULL: none. Else rows and ends have two entries after the columns: the least value of any
                                        condition so far, and the index of that condition. Values are taken at the start, at the
                                        ends of steps before, and here; within a step where one is <= 0 between ends at which all
                                        conditions hold */
    const volatile sig_atomic_t *interrupt; /* nonzero: stop after the step; no `end` is called for unfinished orbits. NULL: none */
} jlt_batch_map;

/** Called at each crossing, for one orbit in order of time: x (columns,), and what is watched; number counts from 1. A nonzero
 *  answer ends the run. With several threads it is called by several at once, though never for the same orbit. */
typedef int (*jlt_batch_row)(void *context, size_t orbit, size_t number, const double *x);

/** Called once for each orbit, with its last point x (columns,), what is watched, and the number of its returns, unless the run
 *  ends before. A nonzero answer ends the run; threads as above. */
typedef int (*jlt_batch_end)(void *context, size_t orbit, jlt_lane_end end, size_t returns, const double *x);

typedef struct {
    size_t steps;    /* of lanes, accepted and rejected */
    size_t rejected;
    size_t stages;   /* evaluations of a full vector */
} jlt_batch_work;

/** The usual max_steps for a tolerance: 400 at 1e-12, where returns take some 40; fewer at looser ones, 100 at least. An orbit that
 *  is almost at rest takes more: stability then limits the steps of explicit methods, and their error is no power of the step. */
size_t jlt_batch_most_steps(double tolerance);

/** The usual root_rest, where rates of decay are from 0.1 to 2 (integrate/approach.h). Ten tolerances at least: explicit methods at
 *  their stability limit make errors of a few. */
double jlt_batch_rest(double tolerance);

/** Columns of the map's starts, rows and ends: dim, and what is carried besides. */
unsigned jlt_batch_columns(const jlt_batch_map *map);

/** Follow the orbits from starts, shape (count, columns), for `returns` returns each, 1 or more. The error of all that is carried
 *  is controlled: that of the clock and of the divergence's integral like a state's, that of a tangent vector relative to max(1,
 *  its largest entry). A start on the section, x[column] = level, does not count as a crossing.
 *  Out: work, the work done; may be NULL. context is passed to row and end.
 *  Errors: ARG, no returns, a member of the map out of its range, `project` with tangent vectors, or too many columns;
 *  UNSUPPORTED, no code here has as many lanes as the kernels; NOMEM.
 *  Cost: 12 or 15 evaluations of the field a step, by method, each on a full row of lanes. Memory does not grow with
 *  `returns`. */
JLT_CHECKED jlt_status jlt_batch_section(const jlt_batch_map *map, const double *starts, size_t count, size_t returns,
                                         jlt_batch_row row, jlt_batch_end end, void *context, jlt_batch_work *work);

#endif
