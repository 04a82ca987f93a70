/* Replaces several divisions by one. With R_S the reciprocal of the product of the denominators d_i in a set S, R_S = R_(S + j)
 * d_j: all reciprocals in use are nodes of a tree whose root is the full set. Or each is written out as that of the full set times
 * the denominators outside S, for an extraction to find common parts. */
#include "optimize/workspace.h"

#include <stdlib.h>
#include <string.h>

enum { MOST = 12 }; /* denominators in one division */

typedef struct {
    ttc_workspace *workspace;
    uint32_t members[MOST]; /* reciprocal variables of one level */
    unsigned count;
    bool written_out;
    uint32_t operands[MOST];
    uint32_t *variable;     /* by subset: 1 + the variable of its reciprocal */
} group;

/* 1 + the number of reciprocals within each other in a variable, itself included: 2 for one whose operand contains none. levels: 0
 * where not yet known. */
static unsigned level_of(const ttc_workspace *workspace, unsigned *levels, uint32_t variable)
{
    const ttc_variable *v = workspace->variables + variable;
    unsigned level = 1;
    if (levels[variable] != 0) return levels[variable];
    if (v->kind != TTC_VARIABLE_UNIT) {
        if (v->kind != TTC_VARIABLE_INPUT) level = level_of(workspace, levels, v->operand);
        if (v->kind == TTC_VARIABLE_RECIPROCAL) level++;
    }
    for (uint32_t i = 0; i < v->definition.count; i++)
        for (unsigned j = 0; j < v->definition.cubes[i].count; j++) {
            unsigned inner = level_of(workspace, levels, v->definition.cubes[i].factors[j]);
            if (inner > level) level = inner;
        }
    levels[variable] = level;
    return level;
}

/* The subset of members whose product a variable is; 0 if it is none, or contains a power. */
static unsigned subset_of(const group *g, uint32_t variable)
{
    for (unsigned i = 0; i < g->count; i++)
        if (g->members[i] == variable) return 1u << i;
    const ttc_variable *v = g->workspace->variables + variable;
    if (v->kind != TTC_VARIABLE_UNIT || v->is_output || v->definition.count != 1) return 0;
    const ttc_cube *cube = v->definition.cubes;
    unsigned subset = 0;
    if (cube->sign < 0 || cube->scale != g->workspace->one) return 0;
    for (unsigned i = 0; i < cube->count; i++) {
        unsigned part = subset_of(g, cube->factors[i]);
        if (part == 0 || (part & subset) != 0) return 0;
        subset |= part;
    }
    return subset;
}

static unsigned size_of(unsigned subset)
{
    unsigned size = 0;
    for (; subset != 0; subset &= subset - 1) size++;
    return size;
}

/* Name it "1/(a*b)" if all operands have names. */
static void name_subset(group *g, uint32_t variable, unsigned subset)
{
    ttc_workspace *workspace = g->workspace;
    ttc_text text = { 0 };
    bool named = true;
    ttc_text_add(&text, size_of(subset) > 1 ? "1/(" : "1/");
    for (unsigned i = 0, k = 0; i < g->count && named; i++) {
        if ((subset & 1u << i) == 0) continue;
        if (k++ > 0) ttc_text_add(&text, "*");
        ttc_text name = { 0 };
        ttc_workspace_write_name(workspace, &name, g->operands[i]);
        named = name.length > 0 && !name.failed;
        bool bracket = named && strchr(name.bytes, '/') != NULL;
        ttc_text_format(&text, bracket ? "(%s)" : "%s", ttc_text_string(&name));
        ttc_text_clear(&name);
    }
    if (size_of(subset) > 1) ttc_text_add(&text, ")");
    if (named) ttc_workspace_name(workspace, variable, &text);
    else ttc_text_clear(&text);
}

static void define_by(ttc_workspace *workspace, uint32_t variable, const ttc_cube *cube)
{
    ttc_variable *v = workspace->variables + variable;
    v->kind = TTC_VARIABLE_UNIT;
    v->definition.count = 0;
    ttc_polynomial_add(workspace, &v->definition, cube);
}

/* The member of `target` outside `subset` whose addition gives a wanted subset or, failing that, one that contains most wanted
 * ones. */
static unsigned next_member(const group *g, const unsigned char *wanted, unsigned subset, unsigned target)
{
    unsigned best = 0, best_score = 0;
    for (unsigned i = 0; i < g->count; i++) {
        unsigned bit = 1u << i, larger = subset | bit, score = 1;
        if ((subset & bit) != 0 || (target & bit) == 0) continue;
        for (unsigned s = 1; s < 1u << g->count; s++) score += wanted[s] && (s & ~larger) == 0;
        score += wanted[larger] ? 1u << MOST : 0;
        if (score > best_score) {
            best_score = score;
            best = i;
        }
    }
    return best;
}

static uint32_t derive(group *g, const unsigned char *wanted, unsigned subset);

/* The reciprocal of one more member times its denominator, on the way to the smallest available superset, along wanted subsets
 * where possible. */
static ttc_cube cube_along_tree(group *g, const unsigned char *wanted, unsigned subset)
{
    ttc_cube cube = ttc_cube_one(g->workspace);
    unsigned full = (1u << g->count) - 1, target = full;
    for (unsigned s = subset; s <= full; s++)
        if (g->variable[s] != 0 && (subset & ~s) == 0 && size_of(s) < size_of(target)) target = s;
    unsigned member = next_member(g, wanted, subset, target);
    ttc_cube_multiply(&cube, derive(g, wanted, subset | 1u << member));
    ttc_cube_multiply(&cube, g->operands[member]);
    return cube;
}

static ttc_cube cube_written_out(const group *g, unsigned subset)
{
    ttc_cube cube = ttc_cube_one(g->workspace);
    ttc_cube_multiply(&cube, g->variable[(1u << g->count) - 1] - 1);
    for (unsigned i = 0; i < g->count; i++)
        if ((subset & 1u << i) == 0) ttc_cube_multiply(&cube, g->operands[i]);
    return cube;
}

/* The variable of the reciprocal of `subset`, made if it is missing. */
static uint32_t derive(group *g, const unsigned char *wanted, unsigned subset)
{
    ttc_workspace *workspace = g->workspace;
    if (g->variable[subset] != 0) return g->variable[subset] - 1;
    ttc_cube cube = g->written_out ? cube_written_out(g, subset) : cube_along_tree(g, wanted, subset);
    uint32_t variable = ttc_workspace_add_variable(workspace, TTC_VARIABLE_UNIT, 0);
    if (workspace->failed) return 0;
    define_by(workspace, variable, &cube);
    name_subset(g, variable, subset);
    g->variable[subset] = variable + 1;
    return variable;
}

static void share_group(group *g)
{
    ttc_workspace *workspace = g->workspace;
    unsigned subsets = 1u << g->count;
    uint32_t known = workspace->count;
    unsigned char *wanted = calloc(subsets, 1);
    unsigned *subset = calloc(known + 1, sizeof *subset);
    g->variable = calloc(subsets, sizeof *g->variable);
    workspace->failed |= wanted == NULL || subset == NULL || g->variable == NULL;
    if (workspace->failed) goto done;
    for (uint32_t v = 0; v < known; v++) {
        subset[v] = subset_of(g, v);
        wanted[subset[v]] = 1;
    }
    wanted[0] = 0;
    ttc_cube product = ttc_cube_one(workspace);
    for (unsigned i = 0; i < g->count; i++) ttc_cube_multiply(&product, g->operands[i]);
    uint32_t all = ttc_workspace_add_variable(workspace, TTC_VARIABLE_UNIT, 0);
    if (workspace->failed) goto done;
    ttc_polynomial_add(workspace, &workspace->variables[all].definition, &product);
    g->variable[subsets - 1] = ttc_workspace_add_variable(workspace, TTC_VARIABLE_RECIPROCAL, all) + 1;
    for (unsigned size = g->count; size > 0 && !workspace->failed; size--)
        for (unsigned s = 1; s < subsets; s++)
            if (wanted[s] && size_of(s) == size) derive(g, wanted, s);
    for (uint32_t v = 0; v < known && !workspace->failed; v++) {
        ttc_cube alias = ttc_cube_one(workspace);
        if (subset[v] == 0) continue;
        ttc_cube_multiply(&alias, g->variable[subset[v]] - 1);
        define_by(workspace, v, &alias);
    }
done:
    free(wanted);
    free(subset);
    free(g->variable);
}

void ttc_workspace_share_reciprocals(ttc_workspace *workspace, bool written_out)
{
    uint32_t count = workspace->count;
    unsigned *levels = calloc(count + 1, sizeof *levels), deepest = 0;
    workspace->failed |= levels == NULL;
    for (uint32_t v = 0; v < count && !workspace->failed; v++)
        if (workspace->variables[v].kind == TTC_VARIABLE_RECIPROCAL && level_of(workspace, levels, v) > deepest)
            deepest = levels[v];
    for (unsigned level = 2; level <= deepest && !workspace->failed; level++) {
        group g = { .workspace = workspace, .written_out = written_out };
        for (uint32_t v = 0; v < count && g.count < MOST; v++)
            if (workspace->variables[v].kind == TTC_VARIABLE_RECIPROCAL && levels[v] == level) {
                g.members[g.count] = v;
                g.operands[g.count++] = workspace->variables[v].operand;
            }
        if (g.count > 1) share_group(&g);
    }
    free(levels);
}
