#include "optimize/lower.h"

#include <stdlib.h>

typedef struct {
    ttc_field *field;
    ttc_program *program;
    ttc_lowering options;
    ttc_value *symbols; /* by symbol; TTC_NO_VALUE: not yet */
    unsigned char *open; /* by symbol: its binding is being evaluated */
    ttc_value *nodes;   /* by graph id, when sharing */
    size_t node_count;
    bool failed;
} lowering;

static ttc_value lower(lowering *l, ttc_id id);

static const ttc_binding *find_binding(const ttc_bindings *bindings, uint32_t symbol)
{
    if (bindings == NULL) return NULL;
    for (size_t i = 0; i < bindings->count; i++)
        if (bindings->items[i].symbol == symbol) return bindings->items + i;
    return NULL;
}

static ttc_value lower_bound(lowering *l, uint32_t symbol, const ttc_binding *binding)
{
    if (l->open[symbol]) {
        l->failed = true;
        return TTC_NO_VALUE;
    }
    l->open[symbol] = 1;
    ttc_id id = ttc_field_specialise(l->field, binding->expression);
    ttc_value value = id == TTC_NONE ? TTC_NO_VALUE : lower(l, id);
    l->open[symbol] = 0;
    return value;
}

/* Lower p^2 - q^2 x^2 as (p - q x)(p + q x). Returns TTC_NO_VALUE, without failing, for other radicands. */
static ttc_value lower_difference_of_squares(lowering *l, ttc_id id)
{
    const ttc_graph *graph = l->field->graph;
    if (ttc_kind_of(graph, id) != TTC_SUM || ttc_part_count(graph, id) != 1) return TTC_NO_VALUE;
    ttc_part term = ttc_part_at(graph, id, 0);
    if (ttc_kind_of(graph, term.id) != TTC_PRODUCT || ttc_part_count(graph, term.id) != 1) return TTC_NO_VALUE;
    ttc_part square = ttc_part_at(graph, term.id, 0);
    if (square.exponent != 2) return TTC_NO_VALUE;

    ttc_value product = TTC_NO_VALUE;
    fmpq_t p, q;
    fmpq_init(p);
    fmpq_init(q);
    fmpq_neg(q, term.coefficient);
    if (!fmpq_is_zero(ttc_coefficient(graph, id)) && ttc_symbol_rational(p, TTC_ROOT, ttc_coefficient(graph, id))
        && ttc_symbol_rational(q, TTC_ROOT, q)) {
        ttc_value base = lower(l, square.id);
        if (base != TTC_NO_VALUE) {
            ttc_value constant = ttc_program_constant(l->program, p);
            ttc_value scaled = ttc_program_multiply(l->program, ttc_program_constant(l->program, q), base);
            ttc_value difference = ttc_program_subtract(l->program, constant, scaled);
            ttc_value sum = ttc_program_add(l->program, constant, scaled);
            product = ttc_program_multiply(l->program, difference, sum);
        }
    }
    fmpq_clear(q);
    fmpq_clear(p);
    return product;
}

static ttc_value lower_symbol(lowering *l, uint32_t symbol)
{
    static const ttc_op functions[] = { [TTC_ROLE_COSINE] = TTC_OP_COSINE, [TTC_ROLE_SINE] = TTC_OP_SINE,
                                        [TTC_ROLE_EXP] = TTC_OP_EXP, [TTC_ROLE_LOG] = TTC_OP_LOG };
    if (l->symbols[symbol] != TTC_NO_VALUE) return l->symbols[symbol];
    const ttc_field_symbol *s = l->field->symbols + symbol;
    const ttc_binding *binding = find_binding(l->options.bindings, symbol);
    ttc_value value = TTC_NO_VALUE;
    if (binding == NULL) binding = find_binding(l->options.when, symbol);
    if (binding != NULL) {
        value = lower_bound(l, symbol, binding);
    } else {
        switch (s->role) {
        case TTC_ROLE_STATE: value = ttc_program_input(l->program, s->position); break;
        case TTC_ROLE_PARAM: value = ttc_program_parameter(l->program, s->position); break;
        case TTC_ROLE_UNIT: value = lower(l, s->definition); break;
        case TTC_ROLE_ROOT:
            if (l->options.factor_roots) value = lower_difference_of_squares(l, s->definition);
            if (value == TTC_NO_VALUE) value = lower(l, s->definition);
            if (value != TTC_NO_VALUE) value = ttc_program_root(l->program, value);
            break;
        case TTC_ROLE_PI: value = ttc_program_pi(l->program); break;
        case TTC_ROLE_COSINE:
        case TTC_ROLE_SINE:
        case TTC_ROLE_EXP:
        case TTC_ROLE_LOG:
            value = lower(l, s->definition);
            if (value != TTC_NO_VALUE)
                value = ttc_program_apply(l->program, functions[s->role], value, TTC_NO_VALUE, TTC_NO_VALUE);
            break;
        case TTC_ROLE_ABSENT: break;
        }
    }
    l->failed |= value == TTC_NO_VALUE;
    if (!l->failed) ttc_program_label(l->program, value, s->name);
    l->symbols[symbol] = value;
    return value;
}

/* Numerator over denominator, with one division. The coefficient is divided with them where both of its numbers are exact in double
 * precision, and else is one number: two of that size could pass the range that their ratio does not. */
static ttc_value lower_product(lowering *l, ttc_id id)
{
    enum { EXACT = 53 };
    ttc_program *program = l->program;
    const fmpq *coefficient = ttc_coefficient(l->field->graph, id);
    const bool is_exact = fmpz_bits(fmpq_numref(coefficient)) <= EXACT && fmpz_bits(fmpq_denref(coefficient)) <= EXACT;
    fmpq_t unit;
    fmpq_init(unit);
    fmpq_set(unit, coefficient);
    if (is_exact) fmpz_one(fmpq_denref(unit));
    ttc_value up = ttc_program_constant(program, unit);
    fmpq_div(unit, unit, coefficient);
    ttc_value down = ttc_program_constant(program, unit);
    fmpq_clear(unit);
    for (size_t i = 0; i < ttc_part_count(l->field->graph, id) && !l->failed; i++) {
        ttc_part part = ttc_part_at(l->field->graph, id, i);
        ttc_value base = lower(l, part.id);
        if (base == TTC_NO_VALUE) return TTC_NO_VALUE;
        ttc_value *side = part.exponent > 0 ? &up : &down;
        *side = ttc_program_multiply(program, *side, ttc_program_power(program, base, labs(part.exponent)));
    }
    return l->failed ? TTC_NO_VALUE : ttc_program_divide(program, up, down);
}

/* Positive terms are added, negative ones subtracted. */
static ttc_value lower_sum(lowering *l, ttc_id id)
{
    ttc_program *program = l->program;
    ttc_value sum = ttc_program_constant(program, ttc_coefficient(l->field->graph, id));
    fmpq_t size;
    fmpq_init(size);
    for (size_t i = 0; i < ttc_part_count(l->field->graph, id) && !l->failed; i++) {
        ttc_part part = ttc_part_at(l->field->graph, id, i);
        ttc_value term = lower(l, part.id);
        if (term == TTC_NO_VALUE) break;
        fmpq_abs(size, part.coefficient);
        term = ttc_program_multiply(program, term, ttc_program_constant(program, size));
        sum = fmpq_sgn(part.coefficient) > 0 ? ttc_program_add(program, sum, term)
                                             : ttc_program_subtract(program, sum, term);
    }
    fmpq_clear(size);
    return l->failed ? TTC_NO_VALUE : sum;
}

static ttc_value lower(lowering *l, ttc_id id)
{
    ttc_value value = TTC_NO_VALUE;
    if (l->failed) return TTC_NO_VALUE;
    bool keep = l->options.share && id < l->node_count;
    if (keep && l->nodes[id] != TTC_NO_VALUE) return l->nodes[id];
    ttc_kind kind = ttc_kind_of(l->field->graph, id);
    if (l->options.prepared != NULL && kind != TTC_NUMBER && ttc_field_is_constant(l->field, id)) {
        value = ttc_program_parameter(l->program, ttc_prepared_index(l->options.prepared, id));
        if (keep) l->nodes[id] = value;
        return value;
    }
    switch (kind) {
    case TTC_NUMBER: value = ttc_program_constant(l->program, ttc_coefficient(l->field->graph, id)); break;
    case TTC_SYMBOL: value = lower_symbol(l, ttc_symbol_of(l->field->graph, id)); break;
    case TTC_PRODUCT: value = lower_product(l, id); break;
    case TTC_SUM: value = lower_sum(l, id); break;
    }
    l->failed |= value == TTC_NO_VALUE;
    if (keep) l->nodes[id] = value;
    return value;
}

ttc_program *ttc_lower(ttc_field *field, const ttc_id *expressions, size_t count, ttc_lowering options)
{
    size_t nodes = ttc_graph_size(field->graph) + 1;
    lowering l = { .field = field, .program = ttc_program_create(), .options = options, .node_count = nodes };
    l.symbols = malloc(field->symbol_count * sizeof *l.symbols);
    l.open = calloc(field->symbol_count, 1);
    l.nodes = malloc(nodes * sizeof *l.nodes);
    l.failed = l.program == NULL || l.symbols == NULL || l.open == NULL || l.nodes == NULL;
    for (size_t i = 0; !l.failed && i < field->symbol_count; i++) l.symbols[i] = TTC_NO_VALUE;
    for (size_t i = 0; !l.failed && i < nodes; i++) l.nodes[i] = TTC_NO_VALUE;
    if (!l.failed && !options.share) ttc_program_keep_duplicates(l.program);
    for (size_t i = 0; i < count && !l.failed; i++) {
        ttc_value value = lower(&l, expressions[i]);
        if (!l.failed) ttc_program_output(l.program, value);
    }
    ttc_program *trimmed = l.failed || ttc_program_failed(l.program) ? NULL : ttc_program_trim(l.program);
    ttc_program_destroy(l.program);
    free(l.symbols);
    free(l.open);
    free(l.nodes);
    return trimmed;
}
