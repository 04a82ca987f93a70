/* Products written out, and what cancels in them. */
#include "system.h"

#include <stdlib.h>

static bool is_product(const ttc_system *system, uint32_t variable)
{
    const ttc_variable *v = system->variables + variable;
    return v->kind == TTC_VARIABLE_UNIT && !v->is_output && v->definition.count == 1 && v->definition.cubes[0].count > 1;
}

/* v * (1/v) = 1 and r * r = radicand; true when something changed. */
static bool cancel_once(const ttc_system *system, ttc_cube *cube)
{
    for (unsigned i = 0; i < cube->count; i++) {
        uint32_t factor = cube->factors[i];
        const ttc_variable *v = system->variables + factor;
        if (v->kind == TTC_VARIABLE_RECIPROCAL && ttc_cube_power(cube, v->operand) > 0) {
            ttc_cube_remove(cube, factor);
            ttc_cube_remove(cube, v->operand);
            return true;
        }
        if (v->kind == TTC_VARIABLE_ROOT && ttc_cube_power(cube, factor) > 1) {
            ttc_cube_remove(cube, factor);
            ttc_cube_remove(cube, factor);
            ttc_cube_multiply(cube, v->operand);
            return true;
        }
    }
    return false;
}

void ttc_system_cancel(ttc_system *system)
{
    for (uint32_t v = 0; v < system->count && !system->failed; v++) {
        ttc_polynomial old = system->variables[v].definition;
        bool changed = false;
        for (uint32_t i = 0; i < old.count; i++)
            while (cancel_once(system, old.cubes + i)) changed = true;
        if (!changed) continue;
        system->variables[v].definition = (ttc_polynomial){ 0 };
        for (uint32_t i = 0; i < old.count && !system->failed; i++)
            ttc_polynomial_merge(system, &system->variables[v].definition, old.cubes + i);
        free(old.cubes);
    }
}

bool ttc_system_write_out(ttc_system *system)
{
    bool changed = false;
    for (uint32_t v = 0; v < system->count && !system->failed; v++)
        if (is_product(system, v)) changed |= ttc_system_inline(system, v);
    if (changed) ttc_system_cancel(system);
    return changed;
}
