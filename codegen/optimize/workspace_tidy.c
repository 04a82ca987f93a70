/* Tidies a workspace between and after extractions: inlines units used once, drops unused ones, settles signs. */
#include "optimize/workspace.h"

#include <stdlib.h>

/* Uses of each variable as a factor or operand. */
static uint32_t *count_uses(const ttc_workspace *workspace)
{
    uint32_t *uses = calloc(workspace->count + 1, sizeof *uses);
    if (uses == NULL) return NULL;
    for (uint32_t v = 0; v < workspace->count; v++) {
        const ttc_variable *variable = workspace->variables + v;
        if (variable->kind == TTC_VARIABLE_UNIT) {
            for (uint32_t i = 0; i < variable->definition.count; i++)
                for (unsigned j = 0; j < variable->definition.cubes[i].count; j++)
                    uses[variable->definition.cubes[i].factors[j]]++;
        } else if (variable->kind != TTC_VARIABLE_INPUT) {
            uses[variable->operand]++;
        }
    }
    return uses;
}

/* Empty variables that nothing uses, until none is left. */
static void drop_unused(ttc_workspace *workspace)
{
    for (bool changed = true; changed && !workspace->failed;) {
        uint32_t *uses = count_uses(workspace);
        changed = false;
        workspace->failed |= uses == NULL;
        for (uint32_t v = 0; v < workspace->count && !workspace->failed; v++) {
            ttc_variable *variable = workspace->variables + v;
            if (uses[v] > 0 || variable->is_output || variable->kind == TTC_VARIABLE_INPUT) continue;
            changed |= variable->kind != TTC_VARIABLE_UNIT || variable->definition.count > 0;
            variable->kind = TTC_VARIABLE_UNIT;
            variable->definition.count = 0;
        }
        free(uses);
    }
}

/* *out = cube with one factor replaced by the cube `by`. Returns false if it is too long. */
static bool substitute_cube(ttc_workspace *workspace, ttc_cube *out, const ttc_cube *cube, uint32_t variable, const ttc_cube *by)
{
    *out = *cube;
    ttc_cube_remove(out, variable);
    out->sign = (int8_t)(out->sign * by->sign);
    for (unsigned i = 0; i < by->count; i++)
        if (!ttc_cube_multiply(out, by->factors[i])) return false;
    if (by->scale != workspace->one) ttc_cube_scale(workspace, out, by->scale);
    return true;
}

static bool fits(const ttc_workspace *workspace, uint32_t variable)
{
    const ttc_polynomial *definition = &workspace->variables[variable].definition;
    unsigned longest = 0;
    for (uint32_t i = 0; i < definition->count; i++)
        if (definition->cubes[i].count > longest) longest = definition->cubes[i].count;
    for (uint32_t v = 0; v < workspace->count; v++) {
        const ttc_polynomial *p = &workspace->variables[v].definition;
        if (workspace->variables[v].kind != TTC_VARIABLE_UNIT && workspace->variables[v].operand == variable
            && workspace->variables[v].kind != TTC_VARIABLE_INPUT)
            return false;
        for (uint32_t i = 0; i < p->count; i++) {
            unsigned power = ttc_cube_power(p->cubes + i, variable);
            if (power > 0 && p->cubes[i].count - power + power * longest > TTC_CUBE_LIMIT) return false;
        }
    }
    return true;
}

static void inline_into(ttc_workspace *workspace, uint32_t user, uint32_t variable)
{
    ttc_polynomial fresh = { 0 };
    const ttc_polynomial *p = &workspace->variables[user].definition, *by = &workspace->variables[variable].definition;
    bool again = false;
    for (uint32_t i = 0; i < p->count && !workspace->failed; i++) {
        if (ttc_cube_power(p->cubes + i, variable) == 0) {
            ttc_polynomial_merge(workspace, &fresh, p->cubes + i);
            continue;
        }
        for (uint32_t j = 0; j < by->count && !workspace->failed; j++) {
            ttc_cube cube;
            if (!substitute_cube(workspace, &cube, p->cubes + i, variable, by->cubes + j)) workspace->failed = true;
            again |= ttc_cube_power(&cube, variable) > 0;
            ttc_polynomial_merge(workspace, &fresh, &cube);
        }
    }
    free(workspace->variables[user].definition.cubes);
    workspace->variables[user].definition = fresh;
    if (again && !workspace->failed) inline_into(workspace, user, variable);
}

bool ttc_workspace_inline(ttc_workspace *workspace, uint32_t variable)
{
    if (workspace->variables[variable].kind != TTC_VARIABLE_UNIT || workspace->variables[variable].is_output
        || !fits(workspace, variable))
        return false;
    for (uint32_t v = 0; v < workspace->count && !workspace->failed; v++) {
        const ttc_polynomial *p = &workspace->variables[v].definition;
        bool used = false;
        for (uint32_t i = 0; i < p->count && !used; i++) used = ttc_cube_power(p->cubes + i, variable) > 0;
        if (used) inline_into(workspace, v, variable);
    }
    workspace->variables[variable].definition.count = 0;
    return true;
}

/* The last variable that uses each one. */
static uint32_t *find_users(const ttc_workspace *workspace)
{
    uint32_t *user = calloc(workspace->count + 1, sizeof *user);
    for (uint32_t v = 0; user != NULL && v < workspace->count; v++) {
        const ttc_variable *variable = workspace->variables + v;
        if (variable->kind > TTC_VARIABLE_UNIT) user[variable->operand] = v;
        for (uint32_t i = 0; i < variable->definition.count; i++)
            for (unsigned j = 0; j < variable->definition.cubes[i].count; j++) user[variable->definition.cubes[i].factors[j]] = v;
    }
    return user;
}

static bool is_plain(const ttc_workspace *workspace, const ttc_cube *cube)
{
    return cube->count + (cube->scale != workspace->one ? 1u : 0u) <= 1;
}

/* Whether a variable used once can be inlined without multiplying out a sum: it is a product, or its use is a whole term. */
static bool may_return(const ttc_workspace *workspace, uint32_t variable, uint32_t user)
{
    const ttc_variable *v = workspace->variables + variable;
    if (workspace->variables[user].kind != TTC_VARIABLE_UNIT) return false;
    if (v->definition.count == 1) return true;
    const ttc_polynomial *p = &workspace->variables[user].definition;
    for (uint32_t i = 0; i < p->count; i++)
        if (ttc_cube_power(p->cubes + i, variable) > 0) return p->cubes[i].count == 1 && p->cubes[i].scale == workspace->one;
    return false;
}

static bool fits_in(const ttc_workspace *workspace, uint32_t variable, uint32_t user)
{
    const ttc_polynomial *definition = &workspace->variables[variable].definition, *p = &workspace->variables[user].definition;
    for (uint32_t i = 0; i < p->count; i++)
        for (uint32_t j = 0; j < definition->count; j++)
            if (ttc_cube_power(p->cubes + i, variable) > 0 && p->cubes[i].count + definition->cubes[j].count > TTC_CUBE_LIMIT)
                return false;
    return true;
}

static void return_single_uses(ttc_workspace *workspace)
{
    for (bool changed = true; changed && !workspace->failed;) {
        uint32_t *uses = count_uses(workspace), *users = find_users(workspace);
        changed = false;
        workspace->failed |= uses == NULL || users == NULL;
        for (uint32_t v = 0; v < workspace->count && !workspace->failed; v++) {
            const ttc_variable *variable = workspace->variables + v;
            if (variable->kind != TTC_VARIABLE_UNIT || variable->is_output || variable->definition.count == 0 || uses[v] == 0)
                continue;
            if (uses[v] > 1) {
                changed = variable->definition.count == 1 && is_plain(workspace, variable->definition.cubes)
                          && ttc_workspace_inline(workspace, v);
                if (changed) break; /* `uses` is out of date */
                continue;
            }
            if (variable->definition.count > 1 && variable->label != NULL) continue;
            uint32_t user = users[v];
            if (!may_return(workspace, v, user) || !fits_in(workspace, v, user)) continue;
            inline_into(workspace, user, v);
            for (uint32_t i = 0; i < variable->definition.count; i++)
                for (unsigned j = 0; j < variable->definition.cubes[i].count; j++)
                    users[variable->definition.cubes[i].factors[j]] = user;
            workspace->variables[v].definition.count = 0;
            uses[v] = 0;
        }
        free(uses);
        free(users);
    }
}

/* Change the sign of units whose terms are all negative, and of terms that contain them to an odd power. */
static void settle_signs(ttc_workspace *workspace)
{
    for (uint32_t v = 0; v < workspace->count; v++) {
        ttc_polynomial *definition = &workspace->variables[v].definition;
        bool negative = definition->count > 0 && !workspace->variables[v].is_output;
        for (uint32_t i = 0; i < definition->count; i++) negative = negative && definition->cubes[i].sign < 0;
        for (uint32_t u = 0; u < workspace->count && negative; u++)
            negative = workspace->variables[u].kind <= TTC_VARIABLE_UNIT || workspace->variables[u].operand != v;
        if (!negative) continue;
        for (uint32_t i = 0; i < definition->count; i++) definition->cubes[i].sign = 1;
        workspace->variables[v].label = NULL;
        for (uint32_t u = 0; u < workspace->count; u++)
            for (uint32_t i = 0; i < workspace->variables[u].definition.count; i++) {
                ttc_cube *cube = workspace->variables[u].definition.cubes + i;
                if (ttc_cube_power(cube, v) % 2 == 1) cube->sign = (int8_t)-cube->sign;
            }
    }
}

/* Remove unused variables; the others keep their order, and factors stay ascending. */
static void renumber(ttc_workspace *workspace)
{
    uint32_t *uses = count_uses(workspace), *number = calloc(workspace->count + 1, sizeof *number), count = 0;
    workspace->failed |= uses == NULL || number == NULL;
    for (uint32_t v = 0; v < workspace->count && !workspace->failed; v++) {
        ttc_variable *variable = workspace->variables + v;
        number[v] = count;
        if (uses[v] > 0 || variable->is_output) workspace->variables[count++] = *variable;
        else free(variable->definition.cubes);
    }
    if (!workspace->failed) workspace->count = count;
    for (uint32_t v = 0; v < workspace->count && !workspace->failed; v++) {
        ttc_variable *variable = workspace->variables + v;
        if (variable->kind > TTC_VARIABLE_UNIT) variable->operand = number[variable->operand];
        for (uint32_t i = 0; i < variable->definition.count; i++)
            for (unsigned j = 0; j < variable->definition.cubes[i].count; j++) {
                uint32_t *factor = variable->definition.cubes[i].factors + j;
                *factor = number[*factor];
            }
    }
    for (uint32_t i = 0; i < workspace->output_count && !workspace->failed; i++)
        workspace->outputs[i] = number[workspace->outputs[i]];
    free(uses);
    free(number);
}

void ttc_workspace_tidy(ttc_workspace *workspace)
{
    drop_unused(workspace);
    if (!workspace->failed) return_single_uses(workspace);
    if (!workspace->failed) settle_signs(workspace);
    if (!workspace->failed) renumber(workspace);
}
