#include "integrate/method.h"

#include <string.h>

static const jlt_method *const table[] = {
    &jlt_method_gauss, &jlt_method_dop853, &jlt_method_taylor, &jlt_method_rk8pd, &jlt_method_rkf45, &jlt_method_msadams,
};

const jlt_method *jlt_method_at(size_t index)
{
    return index < sizeof table / sizeof *table ? table[index] : NULL;
}

const jlt_method *jlt_method_find(const char *name)
{
    if (name == NULL) return table[0];
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        if (strcmp(table[i]->name, name) == 0) return table[i];
    return NULL;
}
