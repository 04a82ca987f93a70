/** Translates expressions into straight-line programs as they stand. This naive form serves as the reference (ball kernels), as
 *  the yardstick of the optimizer, and where speed does not matter. */
#ifndef TTC_LOWER_H
#define TTC_LOWER_H

#include "fields/prepared.h"
#include "optimize/program.h"

typedef struct {
    bool share;                   /* compute equal subexpressions once; otherwise only units, roots and functions are shared */
    const ttc_bindings *bindings; /* expressions of the model that replace states or parameters; may be NULL */
    const ttc_bindings *when;     /* further replacements, used where `bindings` has none; may be NULL */
    bool factor_roots;            /* compute a radicand p^2 - (q x)^2 as (p - q x)(p + q x), which keeps its digits near zero */
    ttc_prepared *prepared;       /* receives the expressions in parameters alone; NULL: the program computes them */
} ttc_lowering;

/** Make a program whose outputs are the expressions, given in the field's symbols. It reads the states and the raw parameters,
 *  or, with options.prepared, the states and the prepared values.
 *  Returns NULL when memory is out, or when bindings refer to each other in a circle. */
ttc_program *ttc_lower(ttc_field *field, const ttc_id *expressions, size_t count, ttc_lowering options);

#endif
