/* Clearing up between and after extractions: units used once go back, unused ones vanish, signs and scales settle. */
#include "optimize/system.h"

#include <stdlib.h>

/* Uses of each variable as a factor, or as the operand of a function; outputs count as one more. */
static uint32_t *count_uses(const ttc_system *system)
{
    uint32_t *uses = calloc(system->count + 1, sizeof *uses);
    if (uses == NULL) return NULL;
    for (uint32_t v = 0; v < system->count; v++) {
        const ttc_variable *variable = system->variables + v;
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

/* A unit that is used by nothing is emptied, and what it used may become unused. */
static void drop_unused(ttc_system *system)
{
    for (bool changed = true; changed && !system->failed;) {
        uint32_t *uses = count_uses(system);
        changed = false;
        system->failed |= uses == NULL;
        for (uint32_t v = 0; v < system->count && !system->failed; v++) {
            ttc_variable *variable = system->variables + v;
            if (uses[v] > 0 || variable->is_output || variable->kind == TTC_VARIABLE_INPUT) continue;
            changed |= variable->kind != TTC_VARIABLE_UNIT || variable->definition.count > 0;
            variable->kind = TTC_VARIABLE_UNIT;
            variable->definition.count = 0;
        }
        free(uses);
    }
}

/* cube without one occurrence of the variable, times another cube */
static bool substitute_cube(ttc_system *system, ttc_cube *out, const ttc_cube *cube, uint32_t variable, const ttc_cube *by)
{
    *out = *cube;
    ttc_cube_remove(out, variable);
    out->sign = (int8_t)(out->sign * by->sign);
    for (unsigned i = 0; i < by->count; i++)
        if (!ttc_cube_multiply(out, by->factors[i])) return false;
    if (by->scale != system->one) ttc_cube_scale(system, out, by->scale);
    return true;
}

static bool fits(const ttc_system *system, uint32_t variable)
{
    const ttc_polynomial *definition = &system->variables[variable].definition;
    unsigned longest = 0;
    for (uint32_t i = 0; i < definition->count; i++)
        if (definition->cubes[i].count > longest) longest = definition->cubes[i].count;
    for (uint32_t v = 0; v < system->count; v++) {
        const ttc_polynomial *p = &system->variables[v].definition;
        if (system->variables[v].kind != TTC_VARIABLE_UNIT && system->variables[v].operand == variable
            && system->variables[v].kind != TTC_VARIABLE_INPUT)
            return false;
        for (uint32_t i = 0; i < p->count; i++) {
            unsigned power = ttc_cube_power(p->cubes + i, variable);
            if (power > 0 && p->cubes[i].count - power + power * longest > TTC_CUBE_LIMIT) return false;
        }
    }
    return true;
}

static void inline_into(ttc_system *system, uint32_t user, uint32_t variable)
{
    ttc_polynomial fresh = { 0 };
    const ttc_polynomial *p = &system->variables[user].definition, *by = &system->variables[variable].definition;
    bool again = false;
    for (uint32_t i = 0; i < p->count && !system->failed; i++) {
        if (ttc_cube_power(p->cubes + i, variable) == 0) {
            ttc_polynomial_merge(system, &fresh, p->cubes + i);
            continue;
        }
        for (uint32_t j = 0; j < by->count && !system->failed; j++) {
            ttc_cube cube;
            if (!substitute_cube(system, &cube, p->cubes + i, variable, by->cubes + j)) system->failed = true;
            again |= ttc_cube_power(&cube, variable) > 0;
            ttc_polynomial_merge(system, &fresh, &cube);
        }
    }
    free(system->variables[user].definition.cubes);
    system->variables[user].definition = fresh;
    if (again && !system->failed) inline_into(system, user, variable);
}

bool ttc_system_inline(ttc_system *system, uint32_t variable)
{
    if (system->variables[variable].kind != TTC_VARIABLE_UNIT || system->variables[variable].is_output
        || !fits(system, variable))
        return false;
    for (uint32_t v = 0; v < system->count && !system->failed; v++) {
        const ttc_polynomial *p = &system->variables[v].definition;
        bool used = false;
        for (uint32_t i = 0; i < p->count && !used; i++) used = ttc_cube_power(p->cubes + i, variable) > 0;
        if (used) inline_into(system, v, variable);
    }
    system->variables[variable].definition.count = 0;
    return true;
}

/* The last variable that uses each one, as a factor or as an operand. */
static uint32_t *find_users(const ttc_system *system)
{
    uint32_t *user = calloc(system->count + 1, sizeof *user);
    for (uint32_t v = 0; user != NULL && v < system->count; v++) {
        const ttc_variable *variable = system->variables + v;
        if (variable->kind > TTC_VARIABLE_UNIT) user[variable->operand] = v;
        for (uint32_t i = 0; i < variable->definition.count; i++)
            for (unsigned j = 0; j < variable->definition.cubes[i].count; j++) user[variable->definition.cubes[i].factors[j]] = v;
    }
    return user;
}

static bool is_plain(const ttc_system *system, const ttc_cube *cube)
{
    return cube->count + (cube->scale != system->one ? 1u : 0u) <= 1;
}

/* True when the variable's one use is as a whole term of a sum, or the variable is a product, so that nothing is
 * multiplied out by putting it back. */
static bool may_return(const ttc_system *system, uint32_t variable, uint32_t user)
{
    const ttc_variable *v = system->variables + variable;
    if (system->variables[user].kind != TTC_VARIABLE_UNIT) return false;
    if (v->definition.count == 1) return true;
    const ttc_polynomial *p = &system->variables[user].definition;
    for (uint32_t i = 0; i < p->count; i++)
        if (ttc_cube_power(p->cubes + i, variable) > 0) return p->cubes[i].count == 1 && p->cubes[i].scale == system->one;
    return false;
}

static bool fits_in(const ttc_system *system, uint32_t variable, uint32_t user)
{
    const ttc_polynomial *definition = &system->variables[variable].definition, *p = &system->variables[user].definition;
    for (uint32_t i = 0; i < p->count; i++)
        for (uint32_t j = 0; j < definition->count; j++)
            if (ttc_cube_power(p->cubes + i, variable) > 0 && p->cubes[i].count + definition->cubes[j].count > TTC_CUBE_LIMIT)
                return false;
    return true;
}

static void return_single_uses(ttc_system *system)
{
    for (bool changed = true; changed && !system->failed;) {
        uint32_t *uses = count_uses(system), *users = find_users(system);
        changed = false;
        system->failed |= uses == NULL || users == NULL;
        for (uint32_t v = 0; v < system->count && !system->failed; v++) {
            const ttc_variable *variable = system->variables + v;
            if (variable->kind != TTC_VARIABLE_UNIT || variable->is_output || variable->definition.count == 0 || uses[v] == 0)
                continue;
            if (uses[v] > 1) {
                changed = variable->definition.count == 1 && is_plain(system, variable->definition.cubes)
                          && ttc_system_inline(system, v);
                if (changed) break; /* uses are not what they were */
                continue;
            }
            if (variable->definition.count > 1 && variable->label != NULL) continue;
            uint32_t user = users[v];
            if (!may_return(system, v, user) || !fits_in(system, v, user)) continue;
            inline_into(system, user, v);
            for (uint32_t i = 0; i < variable->definition.count; i++)
                for (unsigned j = 0; j < variable->definition.cubes[i].count; j++)
                    users[variable->definition.cubes[i].factors[j]] = user;
            system->variables[v].definition.count = 0;
            uses[v] = 0;
        }
        free(uses);
        free(users);
    }
}

/* A unit all of whose terms are negative changes sign, and so do the terms that use it. */
static void settle_signs(ttc_system *system)
{
    for (uint32_t v = 0; v < system->count; v++) {
        ttc_polynomial *definition = &system->variables[v].definition;
        bool negative = definition->count > 0 && !system->variables[v].is_output;
        for (uint32_t i = 0; i < definition->count; i++) negative = negative && definition->cubes[i].sign < 0;
        for (uint32_t u = 0; u < system->count && negative; u++)
            negative = system->variables[u].kind <= TTC_VARIABLE_UNIT || system->variables[u].operand != v;
        if (!negative) continue;
        for (uint32_t i = 0; i < definition->count; i++) definition->cubes[i].sign = 1;
        system->variables[v].label = NULL;
        for (uint32_t u = 0; u < system->count; u++)
            for (uint32_t i = 0; i < system->variables[u].definition.count; i++) {
                ttc_cube *cube = system->variables[u].definition.cubes + i;
                if (ttc_cube_power(cube, v) % 2 == 1) cube->sign = (int8_t)-cube->sign;
            }
    }
}

/* Unused variables leave their numbers; the order of the others is kept, and with it that of factors. */
static void renumber(ttc_system *system)
{
    uint32_t *uses = count_uses(system), *number = calloc(system->count + 1, sizeof *number), count = 0;
    system->failed |= uses == NULL || number == NULL;
    for (uint32_t v = 0; v < system->count && !system->failed; v++) {
        ttc_variable *variable = system->variables + v;
        number[v] = count;
        if (uses[v] > 0 || variable->is_output) system->variables[count++] = *variable;
        else free(variable->definition.cubes);
    }
    if (!system->failed) system->count = count;
    for (uint32_t v = 0; v < system->count && !system->failed; v++) {
        ttc_variable *variable = system->variables + v;
        if (variable->kind > TTC_VARIABLE_UNIT) variable->operand = number[variable->operand];
        for (uint32_t i = 0; i < variable->definition.count; i++)
            for (unsigned j = 0; j < variable->definition.cubes[i].count; j++) {
                uint32_t *factor = variable->definition.cubes[i].factors + j;
                *factor = number[*factor];
            }
    }
    for (uint32_t i = 0; i < system->output_count && !system->failed; i++) system->outputs[i] = number[system->outputs[i]];
    free(uses);
    free(number);
}

void ttc_system_tidy(ttc_system *system)
{
    drop_unused(system);
    if (!system->failed) return_single_uses(system);
    if (!system->failed) settle_signs(system);
    if (!system->failed) renumber(system);
}
