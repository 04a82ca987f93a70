/** Follows an orbit from one return to a surface of section to the next, and says how it ends. Rows come one at a time, so memory
 *  does not grow with their number. */
#ifndef JLT_DYNAMICS_SECTION_H
#define JLT_DYNAMICS_SECTION_H

#include "dynamics/chart.h"
#include "integrate/orbit.h"
#include "kernel/observed.h"

/** A flow with a section, on which everything in dynamics/ works. Plain data; nothing is owned, and chart and field must live
 *  as long as what is made from it. In all members after `field`, zero means the default. */
typedef struct {
    const jlt_chart *chart;
    const jlt_field *field;
    jlt_kernel_function rhs_jacobian; /* computes f, then df/dx, on the field's prepared values; NULL: field->call and
                                         field->jacobian do */
    const jlt_method *method;         /* default: the first of the table */
    double tolerance;                 /* see integrate/method.h; default JLT_ORBIT_TOLERANCE */
    jlt_direction direction;          /* crossings that count, for growing t; default JLT_BOTH */
    size_t max_steps;                 /* of the integrator, for one return; default 10^5 */
    double t_max;                     /* physical time for one return; default: no limit */
    jlt_invariants kept;              /* after every step the state is put back onto the start's levels of these; zero: none */
    const jlt_observed *observed;     /* tells where the model holds, from states in the field's units; default: everywhere */
    bool end_where_invalid;           /* an orbit ends where a condition of the model breaks; default: it goes on, and rows hold the
                                         least value met, */
    bool seeks_least;                 /* within steps as well, to a millionth of it; default: there only where a condition breaks */
    const volatile sig_atomic_t *interrupt;
    struct {
        int state[JLT_CHART_STATES_MAX], time;
    } units; /* binary exponents: x and t in rows are 2^these times those of chart and field; default 0 (factor 1) */
} jlt_flow;

typedef enum {
    JLT_FATE_ALIVE,
    JLT_FATE_POLE_PLUS,    /* ended at the pole of side +1, see chart.h */
    JLT_FATE_POLE_MINUS,   /* ended at that of side -1 */
    JLT_FATE_INVALID,      /* ended where a condition of the model breaks */
    JLT_FATE_EQUILIBRIUM,  /* has come to rest (integrate/rest.h): crossings would be errors alone; x is the limit */
    JLT_FATE_LEFT_DOMAIN,  /* came to the edge of its table's domain, which that table does not call a pole */
    JLT_FATE_BUDGET,       /* max_steps or t_max was spent without a return or an end; or the orbit has settled on the section */
    /* The method failed; x is the last point it accepted. */
    JLT_FATE_NONFINITE,
    JLT_FATE_NO_CONVERGENCE,
    JLT_FATE_NO_PROGRESS,
    JLT_FATE_COUNT
} jlt_fate;

/** alive, pole+, pole-, invalid, equilibrium, left_domain, budget, nonfinite, no_convergence, no_progress. */
const char *jlt_section_fate_name(jlt_fate fate);

enum { JLT_FATE_TEXT_MAX = 72 };

/** Write the fate's name; for invalid, lost_NAME, NAME being that of the condition that broke (jlt_observed_condition). */
void jlt_section_fate_text(char text[JLT_FATE_TEXT_MAX], const jlt_observed *observed, jlt_fate fate, unsigned lost);

/** The fate of an orbit that ends at a pole of this side, as jlt_chart's `side` tells it. */
jlt_fate jlt_section_fate_at_pole(int side);

/** Set *fate to what the status of a failed function means for the orbit. Returns false if it says nothing of the orbit (NOMEM). */
bool jlt_section_fate_of(jlt_fate *fate, jlt_status status);

/** The status that a fate means: OK for alive, DOMAIN for an orbit that ended, BUDGET, or the failure of the method. */
jlt_status jlt_section_fate_status(jlt_fate fate);

/** Whether this fate is a failure of the method: nonfinite, no_convergence or no_progress. */
bool jlt_section_failed(jlt_fate fate);

typedef struct {
    size_t number;               /* 0 is the start; of an end, and where interrupted, one more than the last return's */
    double t;                    /* time since the start, negative when the orbit is followed backwards */
    double q[JLT_CHART_DIM_MAX]; /* NaN where the orbit ended off the section */
    int direction;               /* +1, -1: of the crossing, for growing t; 0 at the start and at an end */
    jlt_fate fate;
    unsigned lost;               /* JLT_FATE_INVALID: the index of the condition that broke; else of the one that is `least` */
    unsigned unbounded;          /* of a failure: the state that grows without bound; JLT_CHART_STATES_MAX: none is known */
    bool interrupted;            /* flow->interrupt became nonzero before the next return; the row holds the point reached */
    double x[JLT_CHART_STATES_MAX];
    double residual;             /* x[column] - level as the integrator left it */
    double least;                /* least value of the model's conditions since the start: at this point, at the ends of earlier
                                    steps, and, if it is not positive, within steps; INFINITY: there are none; NaN: one of them had
                                    no value, and all known values are positive */
} jlt_return;

typedef struct jlt_section jlt_section;

/** Create a section; *flow is copied. Call jlt_section_start before jlt_section_next. Errors: ARG, chart and field do not fit, or
 *  direction or t_max are not valid;
 *  UNSUPPORTED, end_where_invalid with more conditions than events fit (JLT_ORBIT_EVENTS_MAX); as jlt_orbit_create; NOMEM. */
JLT_CHECKED jlt_status jlt_section_create(jlt_section **out, const jlt_flow *flow);
void jlt_section_destroy(jlt_section *self); /* NULL is legal */
JLT_OWNED_TYPE(jlt_section)

/** Start at q (dim,) on the section, time_direction +1 or -1. row (may be NULL) gets the start itself, number 0.
 *  Errors: ARG, another time_direction; as the chart's lift. */
JLT_CHECKED jlt_status jlt_section_start(jlt_section *self, jlt_return *row, const double *q, int time_direction);

/** Start at any state x (states,), on the section or not; row->q is NaN off the section. Errors: ARG, as above; NONFINITE, x; a
 *  field that is not finite there is a fate. */
JLT_CHECKED jlt_status jlt_section_start_state(jlt_section *self, jlt_return *row, const double *x, int time_direction);

/** Find the next return, or the end: after a row with a fate other than alive, or interrupted, call start again.
 *  Errors: ARG, NOMEM; other failures of jlt_orbit_next become fates. */
JLT_CHECKED jlt_status jlt_section_next(jlt_section *self, jlt_return *row);

/** Tell the section that another integrator has found the next return: at time t since the start, at x, shape (states,), both
 *  in the units of chart and field. *row becomes as jlt_section_next would have set it, except that `least` takes
 *  conditions at this point alone into account; jlt_section_next goes on from here. Not to be called after an end. */
void jlt_section_accept(jlt_section *self, jlt_return *row, double t, const double *x);

/** Go on from the point (t, x), in the units of chart and field, to which another integrator has led the orbit after `number`
 *  returns. */
void jlt_section_resume(jlt_section *self, size_t number, double t, const double *x);

/** Take into account the least value of the model's conditions that another integrator met; condition: the index of that one. */
void jlt_section_note(jlt_section *self, double least, unsigned condition);

/** End the orbit at (t, x), in the units above, with this fate, as if jlt_section_next had found it. */
void jlt_section_end(jlt_section *self, jlt_return *row, double t, const double *x, jlt_fate fate, unsigned lost);

/** Accepted and rejected steps, and field evaluations, since the section was created. */
void jlt_section_cost(const jlt_section *self, size_t *steps, size_t *evaluations);

#endif
