/** The one-step methods of the batched section map, as lists for the kernel `stages`; zero weights are left out. */
#ifndef JLT_INTEGRATE_BATCH_METHOD_H
#define JLT_INTEGRATE_BATCH_METHOD_H

#include <stddef.h>

#include "kernel_abi.h"

enum { JLT_BATCH_STAGES_MAX = 15 };

typedef struct jlt_batch_method {
    const char *name;
    unsigned order;       /* of the solution */
    unsigned error_order; /* the error estimate of a step h is O(h^error_order) */
    double power;         /* the estimate is held below caution * tolerance^power */
    double caution;       /* both were measured on section maps, so that one tolerance gives about the same error by every method */
    unsigned stages;      /* slopes beyond k[0]; the last is at the end of the step, and the next step's k[0] */
    jlt_stage_sum sum[JLT_BATCH_STAGES_MAX]; /* [i - 1] leads to slope i; the last one is the solution */
    jlt_stage_sum error;                     /* its error estimate */
    jlt_stage_sum high, low; /* divided differences of the slopes in time, of orders n and n - 2, at instants of the step */
    double quadrature;       /* three times the error, in a time integral over a step, of an oscillation that advances a radian in
                                it is quadrature high (high/low)^2 */
} jlt_batch_method;

/** The table: verner8, stepanov10. NULL past the end. */
const jlt_batch_method *jlt_batch_method_at(size_t index);

/** The usual one for a tolerance of the local error in (0, 1): stepanov10 from 1e-9 down. On section maps verner8 is cheaper down
 *  to 1e-10, by a tenth at 1e-9, but its nodes crowd near the end of the step, and bends of a rate hide from its differences. */
const jlt_batch_method *jlt_batch_method_for(double tolerance);

#endif
