/* The spherical top as one of its values runs: `make` of jlt_system_family, with a top_family as context. */
#ifndef JLT_TESTS_TOP_FAMILY_H
#define JLT_TESTS_TOP_FAMILY_H

#include "top/system_top.h"

typedef struct {
    jlt_top_values values;
    const char *name; /* of the value that runs */
    jlt_flow options;
} top_family;

static jlt_status top_family_at(void *context, jlt_system **out, double value)
{
    top_family *self = context;

    *jlt_system_top_value(&self->values, self->name) = value;
    return jlt_system_top(out, &self->values, &self->options);
}

#endif
