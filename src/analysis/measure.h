/** Search for an invariant measure: a density that depends on one state, computed from the divergence and compared with those that
 *  the table claims; or an equilibrium that excludes any. */
#ifndef JLT_ANALYSIS_MEASURE_H
#define JLT_ANALYSIS_MEASURE_H

#include "analysis/density.h"
#include "analysis/linearization.h"

#include <stdbool.h>

enum { JLT_MEASURE_STATES_MAX = 64, JLT_MEASURE_CLAIMS_MAX = 64, JLT_MEASURE_SAMPLES = 1000 };

/* The attempt at a density of one state alone. */
typedef struct {
    double defects[JLT_MEASURE_STATES_MAX]; /* of every state; NaN where it could not be measured */
    size_t along;             /* the state with the least defect */
    double defect;
    bool found;               /* the defect is rounding */
    bool singular;            /* found, but it has a pole or a zero where f_q vanishes: not smooth and positive */
    double turn;              /* of a state with a proved period: by which factor the density found changes in one; else 1. Where it
                                 is not 1 the angle has no such density */
    jlt_density_point *points; /* shape (count,), owned; NULL when none was found or it cannot be tabulated */
    size_t count;
    double *closed;           /* shape (count,), owned: the closed form, normalized alike; NULL when there is none */
    const char *closed_form;  /* a density of the table that depends on that state alone, or NULL */
    double difference, difference_bound; /* relative; the bound is the quadrature's estimate and 1e-12 for rounding */
} jlt_measure_attempt;

/** Try every state, and tabulate the density, count rows, along the state of least defect. Give *attempt to jlt_measure_clear
 *  whatever is returned. In/out: random, advanced. Errors: those of density.h, NO_CONVERGENCE also where no state within the
 *  domain was drawn; NOMEM. */
JLT_CHECKED jlt_status jlt_measure_try(jlt_measure_attempt *attempt, const jlt_instance *instance, size_t count,
                                       jlt_random *random);
void jlt_measure_clear(jlt_measure_attempt *attempt); /* legal when zeroed */

typedef struct {
    jlt_instance *instance;                  /* owned: the most special kernel that serves */
    jlt_measure_attempt attempt;
    double residual[JLT_MEASURE_CLAIMS_MAX]; /* of the densities claimed, over JLT_MEASURE_SAMPLES random states */
    bool obstructed;                         /* there is an equilibrium whose trace is not zero, proved in balls: */
    double x[JLT_LINEARIZATION_SIZE_MAX];
    jlt_linearization obstruction;
} jlt_measure_finding;

/** Look for an equilibrium of the table's families, at these parameters, whose trace is not zero.
 *  In/out: finding->instance, whose states are drawn; obstructed, x and obstruction of *finding; random, advanced.
 *  In: general, params as for jlt_measure_find. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_measure_obstruct(jlt_measure_finding *finding, const jlt_descriptor *general, const double *params,
                                            jlt_random *random);

/** The attempt, the residuals of the densities claimed, and the search for an obstruction.
 *  In: general, a model's general field; params, shape (params,); count, rows of the density. *finding, zeroed before, is to be
 *  given to jlt_measure_forget whatever is returned.
 *  Errors: UNSUPPORTED (no kernel serves, or too many densities); as jlt_instance_create and jlt_measure_try. */
JLT_CHECKED jlt_status jlt_measure_find(jlt_measure_finding *finding, const jlt_descriptor *general, const double *params,
                                        size_t count, jlt_random *random);
void jlt_measure_forget(jlt_measure_finding *finding);

#endif
