/* Products written out, what cancels in them, and reciprocals of roots and of their powers. */
#include "optimize/system.h"

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

/* The power of a reciprocal that divides all its powers in use, at least 1; 0 when it is not used. */
static unsigned common_power(const ttc_system *system, uint32_t reciprocal)
{
    unsigned common = 0;
    for (uint32_t v = 0; v < system->count; v++)
        for (uint32_t i = 0; i < system->variables[v].definition.count; i++) {
            unsigned a = common, b = ttc_cube_power(system->variables[v].definition.cubes + i, reciprocal);
            while (b != 0) {
                unsigned rest = a % b;
                a = b;
                b = rest;
            }
            common = a;
        }
    return common;
}

/* A variable that holds r^power, from the radicand where it can. */
static uint32_t root_power(ttc_system *system, uint32_t root, unsigned power)
{
    ttc_cube cube = ttc_cube_one(system);
    uint32_t radicand = system->variables[root].operand;
    if (power == 2) return radicand;
    for (unsigned k = 0; k < power / 2; k++) ttc_cube_multiply(&cube, radicand);
    if (power % 2 == 1) ttc_cube_multiply(&cube, root);
    uint32_t unit = ttc_system_add_variable(system, TTC_VARIABLE_UNIT, 0);
    if (!system->failed) ttc_polynomial_add(system, &system->variables[unit].definition, &cube);
    return unit;
}

void ttc_system_raise_reciprocals(ttc_system *system)
{
    uint32_t count = system->count;
    for (uint32_t r = 0; r < count && !system->failed; r++) {
        if (system->variables[r].kind != TTC_VARIABLE_RECIPROCAL
            || system->variables[system->variables[r].operand].kind != TTC_VARIABLE_ROOT)
            continue;
        unsigned power = common_power(system, r);
        if (power < 2 || power > TTC_CUBE_LIMIT) continue;
        uint32_t operand = root_power(system, system->variables[r].operand, power);
        uint32_t raised = ttc_system_add_variable(system, TTC_VARIABLE_RECIPROCAL, operand);
        for (uint32_t v = 0; v < count && !system->failed; v++)
            for (uint32_t i = 0; i < system->variables[v].definition.count; i++) {
                ttc_cube *cube = system->variables[v].definition.cubes + i;
                for (unsigned e = ttc_cube_power(cube, r) / power; e > 0; e--) {
                    for (unsigned k = 0; k < power; k++) ttc_cube_remove(cube, r);
                    ttc_cube_multiply(cube, raised);
                }
            }
    }
}

/* The reciprocal of a variable: the one there is, or a new one. */
static uint32_t reciprocal_of(ttc_system *system, uint32_t variable)
{
    for (uint32_t v = 0; v < system->count; v++)
        if (system->variables[v].kind == TTC_VARIABLE_RECIPROCAL && system->variables[v].operand == variable) return v;
    return ttc_system_add_variable(system, TTC_VARIABLE_RECIPROCAL, variable);
}

/* The radicand of a root r is called r^2, unless it has a name. */
static void name_radicand(ttc_system *system, uint32_t root)
{
    uint32_t radicand = system->variables[root].operand;
    ttc_text text = { 0 };
    if (system->variables[root].label == NULL || system->variables[radicand].label != NULL) return;
    ttc_text_format(&text, "%s^2", system->variables[root].label);
    ttc_system_name(system, radicand, &text);
}

bool ttc_system_divide_by_radicands(ttc_system *system)
{
    uint32_t count = system->count;
    bool changed = false;
    for (uint32_t v = 0; v < count && !system->failed; v++) {
        uint32_t root = system->variables[v].operand;
        if (system->variables[v].kind != TTC_VARIABLE_RECIPROCAL || system->variables[root].kind != TTC_VARIABLE_ROOT) continue;
        name_radicand(system, root);
        ttc_cube cube = ttc_cube_one(system);
        ttc_cube_multiply(&cube, root);
        ttc_cube_multiply(&cube, reciprocal_of(system, system->variables[root].operand));
        system->variables[v].kind = TTC_VARIABLE_UNIT;
        if (!system->failed) ttc_polynomial_add(system, &system->variables[v].definition, &cube);
        ttc_system_inline(system, v);
        changed = true;
    }
    if (changed) ttc_system_cancel(system);
    return changed;
}
