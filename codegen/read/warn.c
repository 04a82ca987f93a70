/* Warnings that need the whole table. */
#include "read/parser.h"

#include <flint/fmpq_vec.h>
#include <stdlib.h>
#include <string.h>

static void warn_unused(ttc_parser *parser)
{
    const ttc_model *model = parser->model;
    for (size_t i = 1; i < model->symbol_count; i++) {
        const ttc_symbol_entry *entry = model->symbols + i;
        const char *kind = entry->kind == TTC_PARAM && model->lift.file == NULL ? "parameter"
                           : entry->kind == TTC_LET  ? "let"
                           : entry->kind == TTC_ROOT ? "root"
                           : entry->kind == TTC_EXP  ? "exponential"
                           : entry->kind == TTC_LOG  ? "logarithm"
                           : entry->kind == TTC_COSINE && !parser->used[entry->partner] ? "angle"
                                                                                        : NULL;
        if (kind != NULL && !parser->used[i])
            ttc_report(parser->diagnostics, TTC_WARNING, entry->place.line, entry->place.column, "the %s '%s' is never used", kind,
                       entry->name);
    }
}

/* Values at the defaults, by expression. They are not nodes of the graph: new nodes would change the order of programs. */
typedef enum { NOT_LOOKED_AT, HAS_NUMBER, IS_NO_NUMBER, DIVIDES_BY_ZERO } found;

typedef struct {
    const ttc_model *model;
    unsigned char *found;
    fmpq *numbers;
} values;

static found look_at(values *v, ttc_id id);

static found look_at_function(values *v, ttc_id id, const ttc_symbol_entry *entry)
{
    const found of = look_at(v, entry->definition);
    if (of != HAS_NUMBER) return of;
    return ttc_symbol_rational(v->numbers + id, entry->kind, v->numbers + entry->definition) ? HAS_NUMBER : IS_NO_NUMBER;
}

static found look_at_symbol(values *v, ttc_id id)
{
    const uint32_t symbol = ttc_symbol_of(v->model->graph, id);
    const ttc_symbol_entry *entry = v->model->symbols + symbol;
    if (symbol < v->model->symbol_count && ttc_symbol_is_function(entry->kind)) return look_at_function(v, id, entry);
    if (symbol >= v->model->symbol_count || (entry->kind != TTC_LET && entry->kind != TTC_PARAM)) return IS_NO_NUMBER;
    const ttc_id value = entry->kind == TTC_LET ? entry->definition : entry->value;
    if (value == TTC_NONE) return IS_NO_NUMBER;
    const found result = look_at(v, value);
    fmpq_set(v->numbers + id, v->numbers + value);
    return result;
}

static found look_at_parts(values *v, ttc_id id)
{
    const ttc_graph *graph = v->model->graph;
    const bool is_sum = ttc_kind_of(graph, id) == TTC_SUM;
    fmpq *value = v->numbers + id;
    found result = HAS_NUMBER;
    fmpq_set(value, ttc_coefficient(graph, id));
    for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
        const ttc_part part = ttc_part_at(graph, id, i);
        const found of_part = look_at(v, part.id);
        const bool divides = of_part == HAS_NUMBER && !is_sum && part.exponent < 0 && fmpq_is_zero(v->numbers + part.id);
        if (divides || of_part > result) result = divides ? DIVIDES_BY_ZERO : of_part;
        if (result != HAS_NUMBER) continue;
        const ulong bits = fmpq_height_bits(v->numbers + part.id) * (ulong)(is_sum ? 1 : labs(part.exponent));
        if (bits + fmpq_height_bits(value) > TTC_COEFFICIENT_BITS) return IS_NO_NUMBER; /* too large to be looked at */
        fmpq_t term;
        fmpq_init(term);
        if (is_sum) fmpq_mul(term, part.coefficient, v->numbers + part.id);
        else fmpq_pow_si(term, v->numbers + part.id, part.exponent);
        if (is_sum) fmpq_add(value, value, term);
        else fmpq_mul(value, value, term);
        fmpq_clear(term);
    }
    return result;
}

static found look_at(values *v, ttc_id id)
{
    if (v->found[id] != NOT_LOOKED_AT) return (found)v->found[id];
    const ttc_kind kind = ttc_kind_of(v->model->graph, id);
    found result = HAS_NUMBER;
    if (kind == TTC_NUMBER) fmpq_set(v->numbers + id, ttc_coefficient(v->model->graph, id));
    else result = kind == TTC_SYMBOL ? look_at_symbol(v, id) : look_at_parts(v, id);
    v->found[id] = (unsigned char)result;
    return result;
}

static void warn_outside(ttc_parser *parser, ttc_place place, const char *before, const char *what, const char *after)
{
    ttc_report(parser->diagnostics, TTC_WARNING, place.line, place.column, "the defaults lie outside the domain: %s%s%s", before,
               what, after);
}

/* Returns true if an expression that has to be positive is not, or divides by zero. */
static bool is_broken(values *v, ttc_id id)
{
    const found result = look_at(v, id);
    return result == DIVIDES_BY_ZERO || (result == HAS_NUMBER && fmpq_sgn(v->numbers + id) <= 0);
}

static void warn_of_values(ttc_parser *parser, values *v)
{
    const ttc_model *model = parser->model;
    for (size_t i = 0; i < model->region_count; i++)
        if (is_broken(v, model->regions[i].expression))
            warn_outside(parser, model->regions[i].place, "", model->regions[i].text, " does not hold");
    for (size_t i = 1; i < model->symbol_count; i++) {
        const ttc_symbol_entry *entry = model->symbols + i;
        const bool has_ends = entry->kind == TTC_STATE && entry->low != TTC_NONE && entry->high != TTC_NONE;
        if (entry->kind == TTC_ROOT && is_broken(v, entry->definition))
            warn_outside(parser, entry->place, "what ", entry->name, " is the root of is not positive");
        if (entry->kind == TTC_LOG && is_broken(v, entry->definition))
            warn_outside(parser, entry->place, "what ", entry->name, " is the logarithm of is not positive");
        if (has_ends && look_at(v, entry->low) == HAS_NUMBER && look_at(v, entry->high) == HAS_NUMBER &&
            fmpq_cmp(v->numbers + entry->low, v->numbers + entry->high) >= 0)
            warn_outside(parser, entry->place, "the interval of ", entry->name, " is empty");
    }
    for (size_t i = 0; i < model->equation_count; i++)
        if (look_at(v, model->equations[i].sum) == DIVIDES_BY_ZERO)
            warn_outside(parser, model->equations[i].place, "the equation of ", model->symbols[model->equations[i].state].name,
                         " divides by zero");
}

static void warn_of_defaults(ttc_parser *parser)
{
    const slong size = (slong)ttc_graph_size(parser->model->graph) + 1;
    values v = { parser->model, calloc((size_t)size, 1), _fmpq_vec_init(size) };
    if (v.found == NULL) ttc_parse_no_memory(parser);
    else warn_of_values(parser, &v);
    _fmpq_vec_clear(v.numbers, size);
    free(v.found);
}

static bool has_dimension(const char *name, size_t length)
{
    static const char *const names[] = { "kg", "m", "s" };
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strlen(names[i]) == length && memcmp(names[i], name, length) == 0) return true;
    return false;
}

/* Warn of names in units of parameters and states that count as numbers, except of rad. */
static void warn_of_units(ttc_parser *parser)
{
    for (size_t i = 1; i < parser->model->symbol_count; i++) {
        const ttc_symbol_entry *entry = parser->model->symbols + i;
        const bool counts = entry->unit != NULL && (entry->kind == TTC_PARAM || entry->kind == TTC_STATE);
        for (const char *at = counts ? entry->unit : ""; *at != '\0';) {
            const size_t length = strcspn(at, "*/ ^()");
            const bool is_name = length > 0 && *at >= 'A' && !(length == 3 && memcmp(at, "rad", length) == 0);
            if (is_name && !has_dimension(at, length))
                ttc_report(parser->diagnostics, TTC_WARNING, entry->place.line, entry->place.column,
                           "'%.*s' in the unit of %s counts as a number (only kg, m and s have dimensions)", (int)length, at,
                           entry->name);
            at += length + (at[length] != '\0');
        }
    }
}

void ttc_parse_warn(ttc_parser *parser)
{
    warn_unused(parser);
    warn_of_defaults(parser);
    warn_of_units(parser);
}
