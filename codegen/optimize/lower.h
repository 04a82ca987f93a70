/** From expressions to straight-line programs as the expressions stand: the naive form, which serves as the reference
 *  (ball kernels), as the yardstick of the optimizer, and where speed is of no matter. */
#ifndef TTC_LOWER_H
#define TTC_LOWER_H

#include "fields/prepared.h"
#include "optimize/program.h"

typedef struct {
    bool share;                   /* equal subexpressions once; otherwise only units, roots and angles are */
    const ttc_bindings *bindings; /* STATE = expression or PARAM = expression of the model, put in first; may be NULL */
    const ttc_bindings *when;     /* further ones; may be NULL */
    bool factor_roots;            /* the radicand p^2 - (q x)^2 as (p - q x)(p + q x), which keeps its digits near zero */
    ttc_prepared *prepared;       /* where expressions in parameters alone go; NULL: everything is computed here */
} ttc_lowering;

/** A program on states and raw parameters, or on states and the prepared values, whose outputs are the expressions, in the
 *  field's symbols.
 *  Returns NULL when memory is out, or when bindings refer to each other in a circle. */
ttc_program *ttc_lower(ttc_field *field, const ttc_id *expressions, size_t count, ttc_lowering options);

#endif
