/** The attempt at a density of one state alone, as `jellett verify` and `jellett measure` make it. */
#ifndef JLT_CLI_MEASURE_H
#define JLT_CLI_MEASURE_H

#include "analysis/density.h"
#include "core/random.h"
#include "kernel/instance.h"

#include <stdbool.h>
#include <stdio.h>

enum { JLT_MEASURE_STATES_MAX = 64 };

typedef struct {
    double defects[JLT_MEASURE_STATES_MAX]; /* of every state; NaN where it could not be measured */
    size_t along;             /* the state with the least defect */
    double defect;
    bool found;               /* the defect is rounding */
    bool singular;            /* found, but it has a pole or a zero where f_q vanishes: not smooth and positive */
    jlt_density_point *points; /* shape (count,), owned; NULL when none was found or it cannot be tabulated */
    size_t count;
    double *closed;           /* shape (count,), owned: the closed form, normalized alike; NULL when there is none */
    const char *closed_form;  /* a density of the table that depends on that state alone, or NULL */
    double difference, difference_bound; /* relative; the bound is the quadrature's estimate and 1e-12 for rounding */
} jlt_measure_attempt;

JLT_CHECKED jlt_status jlt_measure_try(jlt_measure_attempt *attempt, const jlt_instance *instance, size_t count,
                                       jlt_random *random);
/* "NAME 0.12, NAME 3.4e-05, ...": the defects, by name. */
void jlt_measure_write_defects(FILE *stream, const double *defects, const jlt_descriptor *descriptor);
void jlt_measure_clear(jlt_measure_attempt *attempt); /* legal when zeroed */

#endif
