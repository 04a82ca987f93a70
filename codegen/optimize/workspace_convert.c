/* Converts expressions into a workspace of sums. */
#include "fields/simplify.h"
#include "optimize/workspace.h"

#include <stdlib.h>

typedef struct {
    ttc_workspace *workspace;
    ttc_field *field;
    uint32_t *by_symbol;     /* variable + 1 */
    uint32_t *by_id;         /* variable + 1 of an anonymous sum or product */
    unsigned char *below_root; /* by id: some root or angle depends on it */
    size_t id_count;
    uint32_t *reciprocals;   /* by variable, + 1 */
    size_t reciprocal_capacity;
} converter;

static uint32_t variable_of(converter *c, ttc_id id);

static uint32_t reciprocal_of(converter *c, uint32_t variable)
{
    if (variable >= c->reciprocal_capacity) {
        size_t capacity = 2 * (size_t)variable + 64;
        uint32_t *reciprocals = realloc(c->reciprocals, capacity * sizeof *reciprocals);
        if (reciprocals == NULL) {
            c->workspace->failed = true;
            return 0;
        }
        for (size_t i = c->reciprocal_capacity; i < capacity; i++) reciprocals[i] = 0;
        c->reciprocals = reciprocals;
        c->reciprocal_capacity = capacity;
    }
    if (c->reciprocals[variable] == 0)
        c->reciprocals[variable] = ttc_workspace_add_variable(c->workspace, TTC_VARIABLE_RECIPROCAL, variable) + 1;
    return c->reciprocals[variable] - 1;
}

/* cube *= variable. A full cube first moves all factors but one into a unit. */
static void multiply(converter *c, ttc_cube *cube, uint32_t variable)
{
    if (cube->count == TTC_CUBE_LIMIT) {
        ttc_cube head = ttc_cube_one(c->workspace);
        while (cube->count > 1) {
            ttc_cube_multiply(&head, cube->factors[0]);
            ttc_cube_remove(cube, cube->factors[0]);
        }
        uint32_t unit = ttc_workspace_add_variable(c->workspace, TTC_VARIABLE_UNIT, 0);
        if (c->workspace->failed) return;
        ttc_polynomial_add(c->workspace, &c->workspace->variables[unit].definition, &head);
        ttc_cube_multiply(cube, unit);
    }
    ttc_cube_multiply(cube, variable);
}

/* cube *= variable^exponent. The square of a root is its radicand, which is known before the root. */
static void multiply_power(converter *c, ttc_cube *cube, uint32_t variable, int32_t exponent)
{
    const ttc_variable *v = c->workspace->variables + variable;
    if (v->kind == TTC_VARIABLE_ROOT && exponent >= 2) {
        multiply_power(c, cube, v->operand, exponent / 2);
        exponent %= 2;
    }
    if (exponent < 0) variable = reciprocal_of(c, variable);
    for (int32_t k = 0; k < abs(exponent) && !c->workspace->failed; k++) multiply(c, cube, variable);
}

static ttc_cube cube_of(converter *c, ttc_id id)
{
    const ttc_graph *graph = c->field->graph;
    ttc_cube cube = ttc_cube_one(c->workspace);
    if (ttc_field_is_constant(c->field, id)) {
        ttc_cube_scale(c->workspace, &cube, id);
        return cube;
    }
    if (ttc_kind_of(graph, id) != TTC_PRODUCT) {
        multiply_power(c, &cube, variable_of(c, id), 1);
        return cube;
    }
    ttc_cube_scale(c->workspace, &cube, ttc_number(c->field->graph, ttc_coefficient(graph, id)));
    for (size_t i = 0; i < ttc_part_count(graph, id) && !c->workspace->failed; i++) {
        ttc_part part = ttc_part_at(graph, id, i);
        if (ttc_field_is_constant(c->field, part.id))
            ttc_cube_scale(c->workspace, &cube, ttc_power(c->field->graph, part.id, part.exponent));
        else multiply_power(c, &cube, variable_of(c, part.id), part.exponent);
    }
    return cube;
}

/* Define a unit. Terms with equal factors become one, whatever their scales. */
static void fill(converter *c, uint32_t unit, ttc_id id)
{
    ttc_graph *graph = c->field->graph;
    bool is_sum = ttc_kind_of(graph, id) == TTC_SUM && !ttc_field_is_constant(c->field, id);
    if (ttc_is_number(graph, id, 0)) return;
    ttc_cube cube = is_sum ? ttc_cube_one(c->workspace) : cube_of(c, id);
    if (is_sum) ttc_cube_scale(c->workspace, &cube, ttc_number(graph, ttc_coefficient(graph, id)));
    bool has_first = !is_sum || !fmpq_is_zero(ttc_coefficient(graph, id));
    if (has_first && !c->workspace->failed) ttc_polynomial_add(c->workspace, &c->workspace->variables[unit].definition, &cube);
    for (size_t i = 0; is_sum && i < ttc_part_count(graph, id) && !c->workspace->failed; i++) {
        ttc_part part = ttc_part_at(graph, id, i);
        cube = cube_of(c, part.id);
        ttc_cube_scale(c->workspace, &cube, ttc_number(graph, part.coefficient));
        if (!c->workspace->failed) ttc_polynomial_merge(c->workspace, &c->workspace->variables[unit].definition, &cube);
    }
}

/* The square root of a scale: of a square number and, where digits are to be kept, of even powers; else TTC_NONE. */
static ttc_id scale_root(const ttc_field *field, ttc_id scale)
{
    ttc_graph *graph = field->graph;
    ttc_kind kind = ttc_kind_of(graph, scale);
    if (kind != TTC_NUMBER && (kind != TTC_PRODUCT || !field->keeps_digits)) return TTC_NONE;
    fmpq_t root;
    fmpq_init(root);
    const bool is_square = ttc_symbol_rational(root, TTC_ROOT, ttc_coefficient(graph, scale));
    ttc_id result = is_square ? ttc_number(graph, root) : TTC_NONE;
    fmpq_clear(root);
    for (size_t i = 0; i < ttc_part_count(graph, scale) && result != TTC_NONE; i++) {
        ttc_part part = ttc_part_at(graph, scale, i);
        result = part.exponent % 2 != 0 ? TTC_NONE : ttc_multiply(graph, result, ttc_power(graph, part.id, part.exponent / 2));
    }
    return result;
}

/* Returns false if the cube is no square. */
static bool square_root(converter *c, ttc_cube *out, const ttc_cube *cube)
{
    *out = ttc_cube_one(c->workspace);
    if (cube->count % 2 != 0) return false;
    for (unsigned i = 0; i < cube->count; i += 2) {
        if (cube->factors[i] != cube->factors[i + 1]) return false;
        ttc_cube_multiply(out, cube->factors[i]);
    }
    out->scale = scale_root(c->field, cube->scale);
    return out->scale != TTC_NONE;
}

/* Take common factors that are no squares out of two cubes: x y^2 and x z^2 become y^2 and z^2, and x is returned. */
static ttc_cube take_common(converter *c, ttc_cube *a, ttc_cube *b)
{
    ttc_cube common = ttc_cube_one(c->workspace);
    if (!c->field->keeps_digits) return common;
    if (a->scale == b->scale && scale_root(c->field, a->scale) == TTC_NONE) {
        common.scale = a->scale;
        a->scale = b->scale = c->workspace->one;
    }
    for (unsigned i = 0; i < a->count;) {
        uint32_t factor = a->factors[i];
        if (ttc_cube_power(a, factor) % 2 == 1 && ttc_cube_power(b, factor) % 2 == 1) {
            ttc_cube_multiply(&common, factor);
            ttc_cube_remove(a, factor);
            ttc_cube_remove(b, factor);
        } else {
            i++;
        }
    }
    return common;
}

/* C A^2 - C B^2 = C (A - B)(A + B): near A = B this keeps the digits that the difference of squares loses. */
static void split_squares(converter *c, uint32_t unit)
{
    ttc_polynomial *p = &c->workspace->variables[unit].definition;
    ttc_cube a, b;
    if (p->count != 2 || p->cubes[0].sign == p->cubes[1].sign) return;
    unsigned positive = p->cubes[0].sign > 0 ? 0 : 1;
    ttc_cube plus = p->cubes[positive], minus = p->cubes[1 - positive], product = take_common(c, &plus, &minus);
    bool is_plain = product.count == 0 && product.scale == c->workspace->one
                    && ttc_kind_of(c->field->graph, plus.scale) == TTC_NUMBER
                    && ttc_kind_of(c->field->graph, minus.scale) == TTC_NUMBER;
    if (product.count + 2 > TTC_CUBE_LIMIT || !square_root(c, &a, &plus) || !square_root(c, &b, &minus)) return;
    c->field->form_count += !is_plain;
    for (int8_t sign = -1; sign <= 1; sign = (int8_t)(sign + 2)) {
        uint32_t side = ttc_workspace_add_variable(c->workspace, TTC_VARIABLE_UNIT, 0);
        if (c->workspace->failed) return;
        b.sign = sign;
        ttc_polynomial_add(c->workspace, &c->workspace->variables[side].definition, &a);
        ttc_polynomial_add(c->workspace, &c->workspace->variables[side].definition, &b);
        if (sign < 0 && c->field->keeps_digits && !c->workspace->failed) split_squares(c, side);
        ttc_cube_multiply(&product, side);
    }
    p = &c->workspace->variables[unit].definition;
    p->count = 0;
    ttc_polynomial_add(c->workspace, p, &product);
}

static uint32_t new_unit(converter *c, ttc_id definition, const char *label)
{
    uint32_t unit = ttc_workspace_add_variable(c->workspace, TTC_VARIABLE_UNIT, 0);
    if (c->workspace->failed) return 0;
    c->workspace->variables[unit].label = label;
    if (definition >= c->id_count || !c->below_root[definition]) definition = ttc_simplify_roots(c->field, definition);
    if (c->field->keeps_digits) definition = ttc_write_without_cancellation(c->field, definition);
    c->workspace->failed |= definition == TTC_NONE;
    if (c->workspace->failed) return 0;
    fill(c, unit, definition);
    if (!c->workspace->failed) split_squares(c, unit);
    return unit;
}

static uint32_t symbol_variable(converter *c, uint32_t symbol)
{
    if (c->by_symbol[symbol] != 0) return c->by_symbol[symbol] - 1;
    const ttc_field_symbol *s = c->field->symbols + symbol;
    uint32_t variable = 0;
    if (s->role == TTC_ROLE_STATE) {
        variable = ttc_workspace_add_variable(c->workspace, TTC_VARIABLE_INPUT, s->position);
    } else if (s->role == TTC_ROLE_UNIT) {
        variable = new_unit(c, s->definition, s->name);
    } else if (s->role < TTC_ROLE_ROOT) { /* a symbol that was not resolved: memory is out */
        c->workspace->failed = true;
    } else {
        static const ttc_variable_kind kinds[] = { [TTC_ROLE_ROOT] = TTC_VARIABLE_ROOT, [TTC_ROLE_COSINE] = TTC_VARIABLE_COSINE,
                                                   [TTC_ROLE_SINE] = TTC_VARIABLE_SINE, [TTC_ROLE_EXP] = TTC_VARIABLE_EXP,
                                                   [TTC_ROLE_LOG] = TTC_VARIABLE_LOG };
        uint32_t operand = variable_of(c, s->definition);
        variable = ttc_workspace_add_variable(c->workspace, kinds[s->role], operand);
        if (!c->workspace->failed) c->workspace->variables[variable].label = s->name;
    }
    c->by_symbol[symbol] = variable + 1;
    return variable;
}

/* The variable of a symbol, or a unit for an anonymous sum or product. */
static uint32_t variable_of(converter *c, ttc_id id)
{
    if (c->workspace->failed) return 0;
    if (ttc_kind_of(c->field->graph, id) == TTC_SYMBOL) return symbol_variable(c, ttc_symbol_of(c->field->graph, id));
    if (id < c->id_count && c->by_id[id] != 0) return c->by_id[id] - 1;
    uint32_t unit = new_unit(c, id, NULL);
    if (id < c->id_count) c->by_id[id] = unit + 1;
    return unit;
}

/* Mark what roots and functions depend on: it must not be rewritten in terms of them. */
static void mark_below(converter *c, ttc_id id)
{
    const ttc_graph *graph = c->field->graph;
    if (id >= c->id_count || c->below_root[id]) return;
    c->below_root[id] = 1;
    if (ttc_kind_of(graph, id) == TTC_SYMBOL) {
        const ttc_field_symbol *s = c->field->symbols + ttc_symbol_of(graph, id);
        if (s->role >= TTC_ROLE_UNIT) mark_below(c, s->definition);
    }
    for (size_t i = 0; i < ttc_part_count(graph, id); i++) mark_below(c, ttc_part_at(graph, id, i).id);
}

ttc_workspace *ttc_workspace_create(ttc_field *field, const ttc_id *outputs, size_t count)
{
    converter c = { .workspace = calloc(1, sizeof(ttc_workspace)), .field = field };
    if (c.workspace == NULL) return NULL;
    c.workspace->field = field;
    c.workspace->one = ttc_integer(field->graph, 1);
    c.workspace->outputs = calloc(count + 1, sizeof *c.workspace->outputs);
    c.id_count = ttc_graph_size(field->graph) + 1;
    c.by_symbol = calloc(field->symbol_count + 1, sizeof *c.by_symbol);
    c.by_id = calloc(c.id_count, sizeof *c.by_id);
    c.below_root = calloc(c.id_count, 1);
    c.workspace->failed = c.workspace->outputs == NULL || c.by_symbol == NULL || c.by_id == NULL || c.below_root == NULL;
    for (size_t i = 0; i < field->symbol_count && !c.workspace->failed; i++)
        if (field->symbols[i].role >= TTC_ROLE_ROOT) mark_below(&c, field->symbols[i].definition);
    for (size_t i = 0; i < count && !c.workspace->failed; i++) {
        uint32_t unit = new_unit(&c, outputs[i], NULL);
        if (c.workspace->failed) break;
        c.workspace->variables[unit].is_output = true;
        c.workspace->outputs[c.workspace->output_count++] = unit;
    }
    free(c.by_symbol);
    free(c.by_id);
    free(c.below_root);
    free(c.reciprocals);
    if (!c.workspace->failed) return c.workspace;
    ttc_workspace_destroy(c.workspace);
    return NULL;
}
