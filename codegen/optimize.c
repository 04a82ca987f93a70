#include "optimize.h"

#include "lower.h"

ttc_program *ttc_optimize(ttc_field *field, const ttc_id *outputs, size_t count, ttc_block *block)
{
    return ttc_lower(field, outputs, count, (ttc_lowering){ .share = true, .block = block });
}
