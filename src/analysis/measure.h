/** Searches for an invariant measure: a density that depends on one state, computed from the divergence and compared with those
 *  that the table claims; or an equilibrium that excludes every smooth positive density. */
#ifndef JLT_ANALYSIS_MEASURE_H
#define JLT_ANALYSIS_MEASURE_H

#include "analysis/density.h"
#include "analysis/linearization.h"

#include <stdbool.h>

enum { JLT_MEASURE_STATES_MAX = 64, JLT_MEASURE_CLAIMS_MAX = 64, JLT_MEASURE_SAMPLES = 1000 };

/* The search for a density that depends on one state alone. */
typedef struct {
    double defects[JLT_MEASURE_STATES_MAX]; /* of every state; NaN if it could not be measured */
    size_t along;             /* the state with the least defect, or the density found */
    double defect;            /* its */
    bool found;               /* the defect is at rounding level */
    bool singular;            /* a density was found, but has a pole or a zero where f_q vanishes: it is not smooth and positive */
    double turn;              /* for a state with a proved period, the factor by which the density found changes over one period,
                               * else 1. If it is not 1, there is no such density on the circle */
    jlt_density_point *points; /* shape (count,), owned; NULL if no density was found or it cannot be tabulated */
    size_t count;
    double *closed;           /* shape (count,), owned: the table's density, normalized likewise; NULL if there is none */
    const char *closed_form;  /* the name of a density of the table that depends on that state alone, or NULL */
    double difference, difference_bound; /* relative; the bound is the quadrature's error estimate plus 1e-12 for rounding */
} jlt_measure_attempt;

/** Measure the defect of every state, and tabulate the density, with `count` points, along the state of least defect; where that
 *  gives no smooth positive density, along the next one that does. The caller passes *attempt to jlt_measure_clear whatever is
 *  returned. In/out: random, advanced. Errors: those of density.h; NO_CONVERGENCE also if no state within the domain was drawn;
 *  NOMEM. */
JLT_CHECKED jlt_status jlt_measure_try(jlt_measure_attempt *attempt, const jlt_instance *instance, size_t count,
                                       jlt_random *random);
void jlt_measure_clear(jlt_measure_attempt *attempt); /* legal when zeroed */

typedef struct {
    jlt_instance *instance;                  /* owned: the most special variant that holds for the parameters */
    jlt_measure_attempt attempt;
    double residual[JLT_MEASURE_CLAIMS_MAX]; /* of the claimed densities, over JLT_MEASURE_SAMPLES random states */
    bool obstructed;                         /* an equilibrium, x, is proved in balls to have a nonzero trace */
    double x[JLT_LINEARIZATION_SIZE_MAX];
    jlt_linearization obstruction;
} jlt_measure_finding;

/** Search the table's families for an equilibrium whose trace is not zero at these parameters.
 *  In/out: finding->instance, from which states are drawn; obstructed, x and obstruction of *finding; random, advanced.
 *  In: general, params, exact as for jlt_measure_find. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_measure_obstruct(jlt_measure_finding *finding, const jlt_descriptor *general, const double *params,
                                            const char *const *exact, jlt_random *random);

/** Search for a density, compute the residuals of the claimed densities, and search for an obstruction.
 *  In: general, a model's general field; params, shape (params,); exact, of the same shape, or NULL: where exact[i] is not NULL,
 *  an obstruction is proved for this value, "p/q", of which params[i] is the nearest double; count, number of rows of the table of
 *  the density. *finding must be zero before the call; the caller passes it to jlt_measure_forget whatever is returned.
 *  Errors: UNSUPPORTED (no variant holds, or too many densities); as jlt_instance_create and jlt_measure_try. */
JLT_CHECKED jlt_status jlt_measure_find(jlt_measure_finding *finding, const jlt_descriptor *general, const double *params,
                                        const char *const *exact, size_t count, jlt_random *random);
void jlt_measure_forget(jlt_measure_finding *finding);

#endif
