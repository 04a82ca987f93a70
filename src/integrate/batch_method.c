#include "integrate/batch_coefficients.h"

static const jlt_batch_method *const table[] = { &jlt_batch_verner8, &jlt_batch_stepanov10 };

const jlt_batch_method *jlt_batch_method_at(size_t index)
{
    return index < sizeof table / sizeof *table ? table[index] : NULL;
}

const jlt_batch_method *jlt_batch_method_for(double tolerance)
{
    return tolerance > 1e-9 ? &jlt_batch_verner8 : &jlt_batch_stepanov10;
}
