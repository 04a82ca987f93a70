#include "kernel/region.h"

#include <math.h>
#include <stdlib.h>

#include "core/guard.h"
#include "core/memory.h"

/* Prepared values that no number holds make conditions that have no value, whose other ones still count. */
static void evaluate(double *values, const jlt_descriptor *descriptor, double *prepared, const double *params, const double *x)
{
    jlt_guard guard;

    jlt_guard_enter(&guard);
    descriptor->prepare(params, prepared);
    descriptor->domain_values.call(x, prepared, values);
    const jlt_status st = jlt_guard_leave(&guard);
    (void)st;
}

jlt_status jlt_region_check(const jlt_region **region, double *value, const jlt_descriptor *descriptor, const double *params,
                            const double *x)
{
    const unsigned count = descriptor->domain_count, states = descriptor->state_count;

    *region = NULL;
    if (count == 0) return JLT_OK;
    double *room = jlt_memory_array((size_t)count + states + descriptor->prepared_count, sizeof *room);
    if (room == NULL) return JLT_ERR_NOMEM;
    double *nowhere = room + count;
    for (unsigned i = 0; i < states; i++) nowhere[i] = 0;
    evaluate(room, descriptor, nowhere + states, params, x != NULL ? x : nowhere);
    for (unsigned i = 0; i < count && *region == NULL; i++) {
        if (room[i] > 0 || (x == NULL && !descriptor->domains[i].of_params)) continue;
        *region = &descriptor->domains[i];
        *value = room[i];
    }
    free(room);
    return *region == NULL ? JLT_OK : JLT_ERR_DOMAIN;
}

bool jlt_region_holds(unsigned count, jlt_kernel_function values, const double *p, const double *x)
{
    double value[JLT_REGION_CONDITIONS_MAX];
    bool hold = true;

    if (count > 0) values(x, p, value);
    for (unsigned i = 0; i < count; i++) hold &= value[i] > 0;
    return hold;
}
