/* A unit u = k u' is as good as u' wherever users have scales of their own, for those take k in at no cost. */
#include "optimize/system.h"

#include <stdlib.h>

typedef struct {
    ttc_system *system;
    uint32_t unit, reciprocal; /* reciprocal: of the unit; the unit itself when there is none */
    ttc_id scale;
    uint32_t *users; /* variables whose sums hold either, the unit itself among them; room for all */
    uint32_t user_count;
} rescaling;

static bool is_operand_of_other(const ttc_system *system, uint32_t unit, uint32_t *reciprocal)
{
    *reciprocal = unit;
    for (uint32_t v = 0; v < system->count; v++) {
        const ttc_variable *variable = system->variables + v;
        if (variable->kind <= TTC_VARIABLE_UNIT || variable->operand != unit) continue;
        if (variable->kind != TTC_VARIABLE_RECIPROCAL || *reciprocal != unit) return true;
        *reciprocal = v;
    }
    return false;
}

/* The cube after the change. */
static ttc_cube changed(const rescaling *r, const ttc_cube *cube)
{
    ttc_cube after = *cube;
    long power = (long)ttc_cube_power(cube, r->unit);
    if (r->reciprocal != r->unit) power -= (long)ttc_cube_power(cube, r->reciprocal);
    if (power != 0) ttc_cube_scale(r->system, &after, ttc_power(r->system->field->graph, r->scale, power));
    return after;
}

static ttc_cube divided(const rescaling *r, const ttc_cube *cube)
{
    ttc_cube after = *cube;
    ttc_cube_scale(r->system, &after, ttc_power(r->system->field->graph, r->scale, -1));
    return after;
}

static bool holds(const ttc_polynomial *p, uint32_t a, uint32_t b)
{
    for (uint32_t i = 0; i < p->count; i++)
        for (unsigned j = 0; j < p->cubes[i].count; j++)
            if (p->cubes[i].factors[j] == a || p->cubes[i].factors[j] == b) return true;
    return false;
}

static void find_users(rescaling *r)
{
    r->user_count = 0;
    for (uint32_t v = 0; v < r->system->count; v++)
        if (v == r->unit || holds(&r->system->variables[v].definition, r->unit, r->reciprocal)) r->users[r->user_count++] = v;
}

static int gain_of(const rescaling *r)
{
    const ttc_system *system = r->system;
    int gain = 0;
    for (uint32_t k = 0; k < r->user_count && !system->failed; k++)
        for (uint32_t v = r->users[k], i = 0; i < system->variables[v].definition.count; i++) {
            const ttc_cube *cube = system->variables[v].definition.cubes + i;
            ttc_cube after = v == r->unit ? divided(r, cube) : changed(r, cube);
            gain += (int)ttc_cube_cost(system, cube) - (int)ttc_cube_cost(system, &after);
        }
    return gain;
}

static void apply(const rescaling *r)
{
    ttc_system *system = r->system;
    for (uint32_t k = 0; k < r->user_count && !system->failed; k++)
        for (uint32_t v = r->users[k], i = 0; i < system->variables[v].definition.count; i++) {
            ttc_cube *cube = system->variables[v].definition.cubes + i;
            *cube = v == r->unit ? divided(r, cube) : changed(r, cube);
        }
    ttc_variable *unit = system->variables + r->unit;
    unit->divisor = unit->divisor == TTC_NONE ? r->scale : ttc_multiply(system->field->graph, unit->divisor, r->scale);
    if (r->reciprocal != r->unit) system->variables[r->reciprocal].label = NULL;
}

static bool rescale_unit(ttc_system *system, uint32_t unit, uint32_t *users)
{
    rescaling best = { .system = system, .unit = unit, .reciprocal = unit, .users = users };
    int best_gain = 0;
    bool has_scale = false;
    const ttc_polynomial *definition = &system->variables[unit].definition;
    for (uint32_t i = 0; i < definition->count; i++) has_scale |= definition->cubes[i].scale != system->one;
    if (!has_scale || system->variables[unit].kind != TTC_VARIABLE_UNIT || system->variables[unit].is_output
        || is_operand_of_other(system, unit, &best.reciprocal))
        return false;
    find_users(&best);
    for (uint32_t i = 0; i < definition->count && !system->failed; i++) {
        rescaling r = best;
        r.scale = definition->cubes[i].scale;
        if (r.scale == system->one || !ttc_scale_is_safe(system->field, r.scale)) continue;
        int gain = gain_of(&r);
        if (gain <= best_gain) continue;
        best_gain = gain;
        best = r;
    }
    if (best_gain > 0 && !system->failed) apply(&best);
    return best_gain > 0;
}

void ttc_system_rescale(ttc_system *system)
{
    uint32_t *users = calloc(system->count + 1, sizeof *users);
    system->failed |= users == NULL;
    for (bool changed_any = true; changed_any && !system->failed;) {
        changed_any = false;
        for (uint32_t v = 0; v < system->count && !system->failed; v++) changed_any |= rescale_unit(system, v, users);
    }
    free(users);
}
