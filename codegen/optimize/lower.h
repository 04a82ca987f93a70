/** Translates expressions into straight-line programs as they stand: the reference (ball kernels), the yardstick of the optimizer,
 *  and good enough where speed does not matter. */
#ifndef TTC_LOWER_H
#define TTC_LOWER_H

#include "fields/prepared.h"
#include "optimize/program.h"

typedef struct {
    bool share;                   /* equal subexpressions are computed once; else only units, roots and functions are */
    const ttc_bindings *bindings; /* expressions of the model that replace states or parameters; may be NULL */
    const ttc_bindings *when;     /* further replacements, used where `bindings` has none; may be NULL */
    bool factor_roots;            /* compute p^2 - (q x)^2 under a root as (p - q x)(p + q x), which keeps its digits near zero */
    ttc_prepared *prepared;       /* receives expressions in parameters alone; NULL: the program computes them */
} ttc_lowering;

/** Make a program whose outputs are expressions in the field's symbols. It reads states and raw parameters or, with
 *  options.prepared, states and prepared values.
 *  Returns NULL when memory is out, or when bindings refer to each other in a circle. */
ttc_program *ttc_lower(ttc_field *field, const ttc_id *expressions, size_t count, ttc_lowering options);

#endif
