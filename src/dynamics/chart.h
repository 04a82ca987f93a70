/** Coordinates on a surface of section: how a point of the section becomes a state, and back.
 *
 *  A section is where one state has a fixed value, restricted to the levels of known integrals. A chart names its
 *  coordinates q (dim of them), gives the state x(q) with its derivative, the coordinates q(x) with their derivative, and
 *  what the map needs to know of the geometry: the flux form, the reversor, the poles and bounds at which orbits end.
 *
 *  jlt_chart is a base: the charts of particular models embed it as their first member. Plain data, immutable once made,
 *  shared freely between threads. */
#ifndef JLT_DYNAMICS_CHART_H
#define JLT_DYNAMICS_CHART_H

#include "integrate/event.h"
#include "integrate/invariant.h"

enum {
    JLT_CHART_DIM_MAX = 127,   /* one coordinate less than states */
    JLT_CHART_STATES_MAX = 128 /* as in a table */
};

typedef struct jlt_chart jlt_chart;
struct jlt_chart {
    unsigned dim,                        /* of q */
        states;                          /* of x */
    unsigned column;                     /* the section is x[column] = level */
    double level;
    const char *names[JLT_CHART_DIM_MAX]; /* of the coordinates; a single one is followed by "", since pictures show two */
    double period[JLT_CHART_DIM_MAX];    /* of an angle; 0 for a coordinate on a line */
    double turn;                         /* period of x[column] where it is an angle: the section is x[column] = level + k turn for
                                            every integer k; 0: it is no angle */
    unsigned solved_count;               /* states that the levels determine, and which they are */
    unsigned solved[JLT_INVARIANTS_MAX];
    unsigned roots;                      /* on planes and their levels: how many of the last states are lifted roots */
    const jlt_quantity *bounds;          /* (states,): a lift lies within their open intervals; NULL: anywhere */
    const jlt_domain *domain;            /* whose conditions hold at a lift; NULL: none */
    bool turns_over;                     /* the reversor changes the sign of x[column] */
    bool reversible;                     /* q -> mirror * q with time reversed maps the return map to its inverse */
    int mirror[JLT_CHART_DIM_MAX];       /* +1 or -1 */
    int scale[JLT_CHART_DIM_MAX],        /* binary exponents of the typical sizes of coordinates, in which lengths are counted, */
        column_scale;                    /* and of that of x[column] (dynamics/scale.h); 0: not scaled */
    int unit[JLT_CHART_DIM_MAX];         /* tangent vectors of varied orbits are derivatives by q[k]/2^unit[k] */

    /* x (states,), and when tangent is not NULL dx/dq (states, dim), row-major. Errors: EMPTY, the levels have no state
     * there; DOMAIN, q is at or beyond a pole or a bound; NONFINITE. */
    jlt_status (*lift)(const jlt_chart *self, double *x, double *tangent, const double *q);

    /* q (dim,), angles in (-period/2, period/2], and when slope is not NULL dq/dx (dim, states), row-major. */
    void (*lower)(const jlt_chart *self, double *q, double *slope, const double *x);

    /* Density F(q), in the coordinates q, of the flux of volume through the section on its levels: the volume F dq crosses dq in
     * unit tau. On a plane section without levels F = f_column. f, shape (states,): dx/dtau at x. */
    double (*flux)(const jlt_chart *self, const double *x, const double *f);

    /* Side (+1, -1) of the pole at which an orbit has ended in the state x, in the table's units; 0: the table that was asked for
     * names none there. x is changed as by jlt_chart_pole_side. NULL: the section has no poles. */
    int (*side)(const jlt_chart *self, double *x);

    /* See jlt_chart_follows. NULL: the states have one branch only. */
    bool (*follows)(const jlt_chart *self, const double *x);
};

/** The chart of a plain section x[column] = level: q are the other states, in order. signs, shape (states,), +1 or -1, when
 *  the model has the reversor x -> signs * x; NULL: none. It is used when the section contains the reversor's fixed points
 *  (signs[column] = -1, and jlt_chart_is_mirrored). names: shape (states,), kept by reference. Errors: ARG, states outside
 *  2 .. JLT_CHART_STATES_MAX, column >= states, a level that is not finite, or a sign other than +1 and -1. */
JLT_CHECKED jlt_status jlt_chart_plane(jlt_chart *out, unsigned states, unsigned column, double level,
                                       const char *const *names, const int *signs);

/** Whether x[column] = level and x[column] = -level are one section: at level 0, and half a turn from it. */
bool jlt_chart_is_mirrored(const jlt_chart *self);

/** Declare the states with periods[i] != 0 to be angles; periods: shape (states,). Their coordinates are brought into
 *  (-period/2, period/2], and points whose coordinates differ by periods are the same point. For plane sections. */
void jlt_chart_set_periods(jlt_chart *self, const double *periods);

/** Implements `side` from the table's `pole` records (jlt_descriptor_pole_side): sets the state of x, shape (states,), that is
 *  nearest to an end of a pole's interval to that end, and the lifted roots, which follow the `plain` states of the table's general
 *  field, to 0. */
int jlt_chart_pole_side(const jlt_chart *self, const jlt_descriptor *table, unsigned plain, double *x);

enum { JLT_CHART_EVENTS_MAX = 3 };

/** Set the events that catch crossings of the section. Out: events, shape (JLT_CHART_EVENTS_MAX,). Returns how many: one; or three
 *  where the section's state is an angle, with the levels one turn below and above, which are caught in both directions: beyond
 *  them are further levels that no event watches. */
unsigned jlt_chart_events(const jlt_chart *self, jlt_event *events, jlt_direction direction);

/** Whether a crossing that one of these events caught is a crossing of the section in this direction. If not, turn the state back
 *  by jlt_chart_turn_back and follow the orbit on from there. */
bool jlt_chart_counts(const jlt_chart *self, const jlt_crossing *crossing, jlt_direction direction);

/** Bring the section's state to within half a turn of its level, in place, and onto the level where only rounding keeps it off; a
 *  state that is not an angle stays. x: shape (states,). */
void jlt_chart_turn_back(const jlt_chart *self, double *x);

/** The same; also bring all coordinates that are angles into (-period/2, period/2]. For plane sections and their levels. */
void jlt_chart_wrap_state(const jlt_chart *self, double *x);

/** Whether a state is a coordinate of a plane section, or of its levels: neither the section's own, nor solved for, nor a root. */
bool jlt_chart_is_coordinate(const jlt_chart *self, unsigned state);

/** Whether x, shape (states,), lies within the bounds, and the conditions of the domain hold there. */
bool jlt_chart_holds(const jlt_chart *self, const double *x);

/** Whether x, shape (states,), a point of the section in the table's units, is on the same branch as the state that lift gives for
 *  the coordinates of x: x is on the levels, to 1e-6 of the size of their terms, and Newton's method from the solved states of x
 *  converges to those of the lift, to rounding. True for charts without solved states. Cost: two lifts. */
bool jlt_chart_follows(const jlt_chart *self, const double *x);

/** The value less the nearest multiple of the period, in (-period/2, period/2]; small differences keep their digits. 0: none. */
double jlt_chart_reduce(double value, double period);

/** out = q - p, with differences of angles brought into (-period/2, period/2]. All of shape (dim,); out may be q or p. */
void jlt_chart_difference(const jlt_chart *self, double *out, const double *q, const double *p);

/** Bring the angles of q, shape (dim,), into (-period/2, period/2], in place. */
void jlt_chart_wrap(const jlt_chart *self, double *q);

/** Convert q, shape (dim,), to units of the coordinates' typical sizes, and back; and to these units a derivative of coordinates by
 *  coordinates, shape (dim, dim). out may be the input. Exact. */
void jlt_chart_scaled(const jlt_chart *self, double *out, const double *q);
void jlt_chart_unscaled(const jlt_chart *self, double *out, const double *q);
void jlt_chart_scaled_slope(const jlt_chart *self, double *out, const double *slope);

/** Scaled length of the rates of the coordinates and of x[column], at the state x with the velocity f, both of shape (states,). */
double jlt_chart_speed(const jlt_chart *self, const double *x, const double *f);

/** Euclidean length of jlt_chart_difference, scaled. */
double jlt_chart_distance(const jlt_chart *self, const double *q, const double *p);

/** Image under the reversor; out may be q. */
void jlt_chart_mirror(const jlt_chart *self, double *out, const double *q);

#endif
