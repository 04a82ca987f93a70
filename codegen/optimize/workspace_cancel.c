/* Writes products out, cancels their factors, and rewrites reciprocals of roots and of their powers. */
#include "optimize/workspace.h"

#include <stdlib.h>

static bool is_product(const ttc_workspace *workspace, uint32_t variable)
{
    const ttc_variable *v = workspace->variables + variable;
    return v->kind == TTC_VARIABLE_UNIT && !v->is_output && v->definition.count == 1 && v->definition.cubes[0].count > 1;
}

/* Apply v * (1/v) = 1 or r * r = radicand once. Returns whether it applied. */
static bool cancel_once(const ttc_workspace *workspace, ttc_cube *cube)
{
    for (unsigned i = 0; i < cube->count; i++) {
        uint32_t factor = cube->factors[i];
        const ttc_variable *v = workspace->variables + factor;
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

void ttc_workspace_cancel(ttc_workspace *workspace)
{
    for (uint32_t v = 0; v < workspace->count && !workspace->failed; v++) {
        ttc_polynomial old = workspace->variables[v].definition;
        bool changed = false;
        for (uint32_t i = 0; i < old.count; i++)
            while (cancel_once(workspace, old.cubes + i)) changed = true;
        if (!changed) continue;
        workspace->variables[v].definition = (ttc_polynomial){ 0 };
        for (uint32_t i = 0; i < old.count && !workspace->failed; i++)
            ttc_polynomial_merge(workspace, &workspace->variables[v].definition, old.cubes + i);
        free(old.cubes);
    }
}

bool ttc_workspace_write_out(ttc_workspace *workspace)
{
    bool changed = false;
    for (uint32_t v = 0; v < workspace->count && !workspace->failed; v++)
        if (is_product(workspace, v)) changed |= ttc_workspace_inline(workspace, v);
    if (changed) ttc_workspace_cancel(workspace);
    return changed;
}

/* The greatest common divisor of the powers of a reciprocal in use; 0 if there are none. */
static unsigned common_power(const ttc_workspace *workspace, uint32_t reciprocal)
{
    unsigned common = 0;
    for (uint32_t v = 0; v < workspace->count; v++)
        for (uint32_t i = 0; i < workspace->variables[v].definition.count; i++) {
            unsigned a = common, b = ttc_cube_power(workspace->variables[v].definition.cubes + i, reciprocal);
            while (b != 0) {
                unsigned rest = a % b;
                a = b;
                b = rest;
            }
            common = a;
        }
    return common;
}

/* A variable equal to r^power: powers of the radicand, times r if that is odd. */
static uint32_t root_power(ttc_workspace *workspace, uint32_t root, unsigned power)
{
    ttc_cube cube = ttc_cube_one(workspace);
    uint32_t radicand = workspace->variables[root].operand;
    if (power == 2) return radicand;
    for (unsigned k = 0; k < power / 2; k++) ttc_cube_multiply(&cube, radicand);
    if (power % 2 == 1) ttc_cube_multiply(&cube, root);
    uint32_t unit = ttc_workspace_add_variable(workspace, TTC_VARIABLE_UNIT, 0);
    if (!workspace->failed) ttc_polynomial_add(workspace, &workspace->variables[unit].definition, &cube);
    return unit;
}

void ttc_workspace_raise_reciprocals(ttc_workspace *workspace)
{
    uint32_t count = workspace->count;
    for (uint32_t r = 0; r < count && !workspace->failed; r++) {
        if (workspace->variables[r].kind != TTC_VARIABLE_RECIPROCAL
            || workspace->variables[workspace->variables[r].operand].kind != TTC_VARIABLE_ROOT)
            continue;
        unsigned power = common_power(workspace, r);
        if (power < 2 || power > TTC_CUBE_LIMIT) continue;
        uint32_t operand = root_power(workspace, workspace->variables[r].operand, power);
        uint32_t raised = ttc_workspace_add_variable(workspace, TTC_VARIABLE_RECIPROCAL, operand);
        for (uint32_t v = 0; v < count && !workspace->failed; v++)
            for (uint32_t i = 0; i < workspace->variables[v].definition.count; i++) {
                ttc_cube *cube = workspace->variables[v].definition.cubes + i;
                for (unsigned e = ttc_cube_power(cube, r) / power; e > 0; e--) {
                    for (unsigned k = 0; k < power; k++) ttc_cube_remove(cube, r);
                    ttc_cube_multiply(cube, raised);
                }
            }
    }
}

/* The existing reciprocal of a variable, or a new one. */
static uint32_t reciprocal_of(ttc_workspace *workspace, uint32_t variable)
{
    for (uint32_t v = 0; v < workspace->count; v++)
        if (workspace->variables[v].kind == TTC_VARIABLE_RECIPROCAL && workspace->variables[v].operand == variable) return v;
    return ttc_workspace_add_variable(workspace, TTC_VARIABLE_RECIPROCAL, variable);
}

/* Name the radicand of a root r "r^2" if it has no name. */
static void name_radicand(ttc_workspace *workspace, uint32_t root)
{
    uint32_t radicand = workspace->variables[root].operand;
    ttc_text text = { 0 };
    if (workspace->variables[root].label == NULL || workspace->variables[radicand].label != NULL) return;
    ttc_text_format(&text, "%s^2", workspace->variables[root].label);
    ttc_workspace_name(workspace, radicand, &text);
}

bool ttc_workspace_divide_by_radicands(ttc_workspace *workspace)
{
    uint32_t count = workspace->count;
    bool changed = false;
    for (uint32_t v = 0; v < count && !workspace->failed; v++) {
        uint32_t root = workspace->variables[v].operand;
        if (workspace->variables[v].kind != TTC_VARIABLE_RECIPROCAL || workspace->variables[root].kind != TTC_VARIABLE_ROOT)
            continue;
        name_radicand(workspace, root);
        ttc_cube cube = ttc_cube_one(workspace);
        ttc_cube_multiply(&cube, root);
        ttc_cube_multiply(&cube, reciprocal_of(workspace, workspace->variables[root].operand));
        workspace->variables[v].kind = TTC_VARIABLE_UNIT;
        if (!workspace->failed) ttc_polynomial_add(workspace, &workspace->variables[v].definition, &cube);
        ttc_workspace_inline(workspace, v);
        changed = true;
    }
    if (changed) ttc_workspace_cancel(workspace);
    return changed;
}
