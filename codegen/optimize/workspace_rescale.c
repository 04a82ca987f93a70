/* Takes constant factors out of units: where a unit is u = k u', its users can use u' and multiply their own scales by k,
 * which costs nothing at run time. */
#include "optimize/workspace.h"

#include <stdlib.h>

typedef struct {
    ttc_workspace *workspace;
    uint32_t unit, reciprocal; /* reciprocal: of the unit; the unit itself when there is none */
    ttc_id scale;
    uint32_t *users; /* variables whose sums contain either, and the unit; room for all */
    uint32_t user_count;
} rescaling;

/* Whether another function than one reciprocal has the unit as operand; *reciprocal: that one, else the unit. */
static bool is_operand_of_other(const ttc_workspace *workspace, uint32_t unit, uint32_t *reciprocal)
{
    *reciprocal = unit;
    for (uint32_t v = 0; v < workspace->count; v++) {
        const ttc_variable *variable = workspace->variables + v;
        if (variable->kind <= TTC_VARIABLE_UNIT || variable->operand != unit) continue;
        if (variable->kind != TTC_VARIABLE_RECIPROCAL || *reciprocal != unit) return true;
        *reciprocal = v;
    }
    return false;
}

/* A user's cube after the change. */
static ttc_cube changed(const rescaling *r, const ttc_cube *cube)
{
    ttc_cube after = *cube;
    long power = (long)ttc_cube_power(cube, r->unit);
    if (r->reciprocal != r->unit) power -= (long)ttc_cube_power(cube, r->reciprocal);
    if (power != 0) ttc_cube_scale(r->workspace, &after, ttc_power(r->workspace->field->graph, r->scale, power));
    return after;
}

static ttc_cube divided(const rescaling *r, const ttc_cube *cube)
{
    ttc_cube after = *cube;
    ttc_cube_scale(r->workspace, &after, ttc_power(r->workspace->field->graph, r->scale, -1));
    return after;
}

/* For each variable, those whose sums contain it, ascending. Rescaling changes no factors, so they are found once. */
typedef struct {
    size_t *first; /* by variable, shape (count + 1,): its first user in `all` */
    uint32_t *all;
} user_lists;

/* Add each sum once to the users of each factor; all == NULL: count only. last: by factor, the sum visited last. */
static void visit_factors(const ttc_workspace *workspace, size_t *position, uint32_t *all, uint32_t *last)
{
    for (uint32_t v = 0; v < workspace->count; v++) last[v] = UINT32_MAX;
    for (uint32_t v = 0; v < workspace->count; v++)
        for (uint32_t i = 0; i < workspace->variables[v].definition.count; i++) {
            const ttc_cube *cube = workspace->variables[v].definition.cubes + i;
            for (unsigned j = 0; j < cube->count; j++) {
                uint32_t factor = cube->factors[j];
                if (last[factor] == v) continue;
                last[factor] = v;
                if (all != NULL) all[position[factor]] = v;
                position[factor]++;
            }
        }
}

static bool list_users(const ttc_workspace *workspace, user_lists *lists)
{
    uint32_t *last = malloc((workspace->count + 1) * sizeof *last);
    size_t *position = calloc(workspace->count + 1, sizeof *position), total = 0;
    lists->first = calloc((size_t)workspace->count + 1, sizeof *lists->first);
    bool ok = last != NULL && position != NULL && lists->first != NULL;
    if (ok) visit_factors(workspace, position, NULL, last);
    for (uint32_t v = 0; v < workspace->count && ok; v++) {
        lists->first[v] = total;
        total += position[v];
        position[v] = lists->first[v];
    }
    if (ok) lists->first[workspace->count] = total;
    lists->all = ok ? malloc((total + 1) * sizeof *lists->all) : NULL;
    if (lists->all != NULL) visit_factors(workspace, position, lists->all, last);
    free(last);
    free(position);
    return lists->all != NULL;
}

/* Users of the unit and of its reciprocal, and the unit itself, ascending. */
static void find_users(rescaling *r, const user_lists *lists)
{
    size_t i = lists->first[r->unit], i_end = lists->first[r->unit + 1];
    size_t j = lists->first[r->reciprocal], j_end = r->reciprocal == r->unit ? j : lists->first[r->reciprocal + 1];
    bool self = true;
    r->user_count = 0;
    while (i < i_end || j < j_end || self) {
        uint32_t next = self ? r->unit : UINT32_MAX;
        if (i < i_end && lists->all[i] < next) next = lists->all[i];
        if (j < j_end && lists->all[j] < next) next = lists->all[j];
        if (i < i_end && lists->all[i] == next) i++;
        if (j < j_end && lists->all[j] == next) j++;
        self = self && next != r->unit;
        r->users[r->user_count++] = next;
    }
}

static int gain_of(const rescaling *r)
{
    const ttc_workspace *workspace = r->workspace;
    int gain = 0;
    for (uint32_t k = 0; k < r->user_count && !workspace->failed; k++)
        for (uint32_t v = r->users[k], i = 0; i < workspace->variables[v].definition.count; i++) {
            const ttc_cube *cube = workspace->variables[v].definition.cubes + i;
            ttc_cube after = v == r->unit ? divided(r, cube) : changed(r, cube);
            gain += (int)ttc_cube_cost(workspace, cube) - (int)ttc_cube_cost(workspace, &after);
        }
    return gain;
}

static void apply(const rescaling *r)
{
    ttc_workspace *workspace = r->workspace;
    for (uint32_t k = 0; k < r->user_count && !workspace->failed; k++)
        for (uint32_t v = r->users[k], i = 0; i < workspace->variables[v].definition.count; i++) {
            ttc_cube *cube = workspace->variables[v].definition.cubes + i;
            *cube = v == r->unit ? divided(r, cube) : changed(r, cube);
        }
    ttc_variable *unit = workspace->variables + r->unit;
    unit->divisor = unit->divisor == TTC_NONE ? r->scale : ttc_multiply(workspace->field->graph, unit->divisor, r->scale);
    if (r->reciprocal != r->unit) workspace->variables[r->reciprocal].label = NULL;
}

static bool rescale_unit(ttc_workspace *workspace, uint32_t unit, uint32_t *users, const user_lists *lists)
{
    rescaling best = { .workspace = workspace, .unit = unit, .reciprocal = unit, .users = users };
    int best_gain = 0;
    bool has_scale = false;
    const ttc_polynomial *definition = &workspace->variables[unit].definition;
    for (uint32_t i = 0; i < definition->count; i++) has_scale |= definition->cubes[i].scale != workspace->one;
    if (!has_scale || workspace->variables[unit].kind != TTC_VARIABLE_UNIT || workspace->variables[unit].is_output
        || is_operand_of_other(workspace, unit, &best.reciprocal))
        return false;
    find_users(&best, lists);
    for (uint32_t i = 0; i < definition->count && !workspace->failed; i++) {
        rescaling r = best;
        r.scale = definition->cubes[i].scale;
        if (r.scale == workspace->one || !ttc_scale_is_safe(workspace->field, r.scale)) continue;
        int gain = gain_of(&r);
        if (gain <= best_gain) continue;
        best_gain = gain;
        best = r;
    }
    if (best_gain > 0 && !workspace->failed) apply(&best);
    return best_gain > 0;
}

void ttc_workspace_rescale(ttc_workspace *workspace)
{
    uint32_t *users = calloc(workspace->count + 1, sizeof *users);
    user_lists lists = { 0 };
    workspace->failed |= users == NULL || !list_users(workspace, &lists);
    for (bool changed_any = true; changed_any && !workspace->failed;) {
        changed_any = false;
        for (uint32_t v = 0; v < workspace->count && !workspace->failed; v++)
            changed_any |= rescale_unit(workspace, v, users, &lists);
    }
    free(users);
    free(lists.first);
    free(lists.all);
}
