/* The optimizer's workspace: creates and changes its variables, cubes and sums. */
#include "optimize/workspace.h"

#include "fields/formula.h"

#include <stdlib.h>
#include <string.h>

ttc_workspace *ttc_workspace_clone(const ttc_workspace *workspace)
{
    ttc_workspace *copy = calloc(1, sizeof *copy);
    if (copy == NULL) return NULL;
    *copy = *workspace;
    copy->names = NULL;
    copy->name_count = 0;
    copy->capacity = workspace->count + 32;
    copy->variables = calloc(copy->capacity, sizeof *copy->variables);
    copy->outputs = calloc(workspace->output_count + 1, sizeof *copy->outputs);
    copy->failed = copy->variables == NULL || copy->outputs == NULL;
    copy->count = 0;
    for (uint32_t i = 0; i < workspace->count && !copy->failed; i++) {
        ttc_variable *v = copy->variables + copy->count++;
        *v = workspace->variables[i];
        v->definition = (ttc_polynomial){ 0 };
        uint32_t n = workspace->variables[i].definition.count;
        if (n == 0) continue;
        v->definition.cubes = malloc(n * sizeof *v->definition.cubes);
        copy->failed |= v->definition.cubes == NULL;
        if (copy->failed) break;
        memcpy(v->definition.cubes, workspace->variables[i].definition.cubes, n * sizeof *v->definition.cubes);
        v->definition.count = v->definition.capacity = n;
    }
    if (!copy->failed) {
        memcpy(copy->outputs, workspace->outputs, workspace->output_count * sizeof *copy->outputs);
        return copy;
    }
    ttc_workspace_destroy(copy);
    return NULL;
}

void ttc_workspace_destroy(ttc_workspace *workspace)
{
    if (workspace == NULL) return;
    for (uint32_t i = 0; i < workspace->count; i++) free(workspace->variables[i].definition.cubes);
    for (size_t i = 0; i < workspace->name_count; i++) free(workspace->names[i]);
    free(workspace->names);
    free(workspace->variables);
    free(workspace->outputs);
    free(workspace);
}

void ttc_workspace_write_name(const ttc_workspace *workspace, ttc_text *text, uint32_t variable)
{
    const ttc_variable *v = workspace->variables + variable;
    const ttc_field *field = workspace->field;
    if (v->kind == TTC_VARIABLE_INPUT) ttc_text_add(text, field->symbols[field->states[v->operand]].name);
    if (v->label == NULL) return;
    ttc_text_add(text, v->label);
    if (v->divisor == TTC_NONE) return;
    bool bracket = ttc_kind_of(field->graph, v->divisor) != TTC_SYMBOL;
    ttc_text_add(text, bracket ? "/(" : "/");
    ttc_emit_formula(text, field->graph, v->divisor, ttc_emit_symbol_name, (void *)(uintptr_t)field);
    if (bracket) ttc_text_add(text, ")");
}

void ttc_workspace_name(ttc_workspace *workspace, uint32_t variable, ttc_text *label)
{
    char **names = label->failed ? NULL : realloc(workspace->names, (workspace->name_count + 1) * sizeof *names);
    if (names == NULL) {
        ttc_text_clear(label);
        return;
    }
    workspace->names = names;
    names[workspace->name_count++] = label->bytes;
    workspace->variables[variable].label = label->bytes;
}

uint32_t ttc_workspace_add_variable(ttc_workspace *workspace, ttc_variable_kind kind, uint32_t operand)
{
    if (workspace->count == workspace->capacity) {
        uint32_t capacity = 2 * workspace->capacity + 32;
        ttc_variable *variables = realloc(workspace->variables, capacity * sizeof *variables);
        if (variables == NULL) {
            workspace->failed = true;
            return 0;
        }
        workspace->variables = variables;
        workspace->capacity = capacity;
    }
    workspace->variables[workspace->count] = (ttc_variable){ .kind = kind, .operand = operand };
    return workspace->count++;
}

void ttc_polynomial_add(ttc_workspace *workspace, ttc_polynomial *p, const ttc_cube *cube)
{
    if (p->count == p->capacity) {
        uint32_t capacity = p->capacity == 0 ? 4 : 2 * p->capacity;
        ttc_cube *cubes = realloc(p->cubes, capacity * sizeof *cubes);
        if (cubes == NULL) {
            workspace->failed = true;
            return;
        }
        p->cubes = cubes;
        p->capacity = capacity;
    }
    p->cubes[p->count++] = *cube;
}

/* The others keep their order. */
static void remove_cube(ttc_polynomial *p, uint32_t index)
{
    p->count--;
    for (uint32_t i = index; i < p->count; i++) p->cubes[i] = p->cubes[i + 1];
}

void ttc_polynomial_close_gaps(ttc_polynomial *p)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < p->count; i++)
        if (p->cubes[i].sign != 0) p->cubes[count++] = p->cubes[i];
    p->count = count;
}

ttc_cube ttc_cube_one(const ttc_workspace *workspace)
{
    ttc_cube cube = { .scale = workspace->one, .sign = 1 };
    return cube;
}

bool ttc_cube_multiply(ttc_cube *cube, uint32_t variable)
{
    if (cube->count == TTC_CUBE_LIMIT) return false;
    unsigned at = cube->count++;
    for (; at > 0 && cube->factors[at - 1] > variable; at--) cube->factors[at] = cube->factors[at - 1];
    cube->factors[at] = variable;
    return true;
}

void ttc_cube_remove(ttc_cube *cube, uint32_t variable)
{
    unsigned at = 0;
    while (cube->factors[at] != variable) at++;
    cube->count--;
    for (; at < cube->count; at++) cube->factors[at] = cube->factors[at + 1];
    cube->factors[cube->count] = 0;
}

unsigned ttc_cube_power(const ttc_cube *cube, uint32_t variable)
{
    unsigned power = 0;
    for (unsigned i = 0; i < cube->count; i++) power += cube->factors[i] == variable;
    return power;
}

bool ttc_cube_same_factors(const ttc_cube *a, const ttc_cube *b)
{
    return a->count == b->count && memcmp(a->factors, b->factors, a->count * sizeof *a->factors) == 0;
}

static ttc_id signed_scale(ttc_workspace *workspace, const ttc_cube *cube)
{
    return ttc_multiply(workspace->field->graph, cube->scale, ttc_integer(workspace->field->graph, cube->sign));
}

void ttc_polynomial_merge(ttc_workspace *workspace, ttc_polynomial *p, const ttc_cube *cube)
{
    for (uint32_t i = 0; i < p->count; i++) {
        if (!ttc_cube_same_factors(p->cubes + i, cube)) continue;
        ttc_id mine = signed_scale(workspace, p->cubes + i), other = signed_scale(workspace, cube);
        ttc_id sum = ttc_add(workspace->field->graph, mine, other);
        workspace->failed |= sum == TTC_NONE;
        if (workspace->failed) return;
        if (ttc_is_number(workspace->field->graph, sum, 0)) {
            remove_cube(p, i);
            return;
        }
        p->cubes[i].scale = workspace->one;
        p->cubes[i].sign = 1;
        ttc_cube_scale(workspace, p->cubes + i, sum);
        return;
    }
    ttc_polynomial_add(workspace, p, cube);
}

void ttc_cube_scale(ttc_workspace *workspace, ttc_cube *cube, ttc_id factor)
{
    ttc_graph *graph = workspace->field->graph;
    ttc_id scale = ttc_multiply(graph, cube->scale, factor);
    if (scale == TTC_NONE) {
        workspace->failed = true;
        return;
    }
    const fmpq *leading = ttc_kind_of(graph, scale) == TTC_SUM ? ttc_part_at(graph, scale, 0).coefficient
                                                               : ttc_coefficient(graph, scale);
    if (ttc_kind_of(graph, scale) != TTC_SYMBOL && fmpq_sgn(leading) < 0) {
        scale = ttc_multiply(graph, scale, ttc_integer(graph, -1));
        cube->sign = (int8_t)-cube->sign;
        workspace->failed |= scale == TTC_NONE;
    }
    cube->scale = scale;
}

unsigned ttc_cube_cost(const ttc_workspace *workspace, const ttc_cube *cube)
{
    unsigned parts = cube->count + (cube->scale != workspace->one ? 1u : 0u);
    return parts > 1 ? parts - 1 : 0;
}

bool ttc_scale_is_safe(const ttc_field *field, ttc_id scale)
{
    const ttc_graph *graph = field->graph;
    switch (ttc_kind_of(graph, scale)) {
    case TTC_NUMBER: return !fmpq_is_zero(ttc_coefficient(graph, scale));
    case TTC_SYMBOL: {
        const ttc_field_symbol *s = field->symbols + ttc_symbol_of(graph, scale);
        return s->role == TTC_ROLE_PARAM && (s->sign == TTC_POSITIVE || s->sign == TTC_NONZERO);
    }
    case TTC_PRODUCT:
        for (size_t i = 0; i < ttc_part_count(graph, scale); i++)
            if (!ttc_scale_is_safe(field, ttc_part_at(graph, scale, i).id)) return false;
        return true;
    default: return false;
    }
}
