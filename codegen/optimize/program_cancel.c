#include "optimize/program_cancel.h"

#include <math.h>
#include <stdlib.h>

enum { ODD_LIMIT = 24 };
#define VALUE_ATOM (UINT64_C(1) << 32) /* marks values of the program among factors, which else are graph ids */

/* What is known of a value: bounds, and its sign as `sign` times the signs of its factors of odd power, ascending. Values with the
 * same odd factors have equal or opposite signs. is_exact: without rounding error. */
typedef struct {
    ttc_extent extent;
    uint64_t odd[ODD_LIMIT];
    unsigned count;
    int sign;
    bool is_exact;
} fact;

static fact number_fact(const fmpq_t value)
{
    fact f = { .extent = ttc_extent_of_number(value), .sign = fmpq_sgn(value) < 0 ? -1 : 1 };
    f.is_exact = f.extent.low == f.extent.high;
    return f;
}

static fact atom_fact(ttc_extent extent, uint64_t atom, bool is_exact)
{
    fact f = { .extent = extent, .odd = { atom }, .count = 1, .sign = 1, .is_exact = is_exact };
    if (ttc_extent_is_nonnegative(extent) || ttc_extent_is_nonpositive(extent)) {
        f.count = 0;
        f.sign = ttc_extent_is_nonnegative(extent) ? 1 : -1;
    }
    return f;
}

/* Odd factors of a product: those in one of the two lists only. If they do not fit, the product is one factor, `atom`. */
static fact product_fact(const fact *a, const fact *b, ttc_extent extent, uint64_t atom)
{
    fact f = { .extent = extent, .sign = a->sign * b->sign };
    unsigned i = 0, j = 0;
    while (i < a->count || j < b->count) {
        if (i < a->count && j < b->count && a->odd[i] == b->odd[j]) {
            i++;
            j++;
            continue;
        }
        if (f.count == ODD_LIMIT) return atom_fact(extent, atom, false);
        bool from_a = j == b->count || (i < a->count && a->odd[i] < b->odd[j]);
        f.odd[f.count++] = from_a ? a->odd[i++] : b->odd[j++];
    }
    if (f.count > 0) {
        bool has_sign = ttc_extent_is_nonnegative(extent) || ttc_extent_is_nonpositive(extent);
        return has_sign ? atom_fact(extent, atom, false) : f;
    }
    ttc_extent signed_values = ttc_extent_of_signs(TTC_SIGN_ZERO | (f.sign > 0 ? TTC_SIGN_POSITIVE : TTC_SIGN_NEGATIVE));
    f.extent = ttc_extent_meet(extent, signed_values);
    return f;
}

static bool is_power_of_two(const fact *f)
{
    int exponent;
    return f->is_exact && f->extent.low == f->extent.high && fabs(frexp(f->extent.low, &exponent)) == 0.5;
}

static fact multiply(const fact *a, const fact *b, bool is_square, uint64_t atom)
{
    ttc_extent extent = is_square ? ttc_extent_power(a->extent, 2) : ttc_extent_multiply(a->extent, b->extent);
    fact f = product_fact(a, b, extent, atom);
    f.is_exact = (is_power_of_two(a) && b->is_exact) || (is_power_of_two(b) && a->is_exact);
    return f;
}

static bool same_signs(const fact *a, const fact *b)
{
    if (a->sign != b->sign || a->count != b->count) return false;
    for (unsigned i = 0; i < a->count; i++)
        if (a->odd[i] != b->odd[i]) return false;
    return true;
}

/* The least and the greatest |x|. */
static double least(ttc_extent x) { return x.low > 0 ? x.low : x.high < 0 ? -x.high : 0; }

static double greatest(ttc_extent x) { return fmax(fabs(x.low), fabs(x.high)); }

static fact add(const fact *a, const fact *b, uint64_t atom, ttc_loss *loss)
{
    ttc_extent extent = ttc_extent_add(a->extent, b->extent);
    *loss = TTC_KEEPS_DIGITS;
    if (same_signs(a, b)) {
        fact f = *a;
        f.extent = extent;
        f.is_exact = false;
        return f;
    }
    bool is_bounded = greatest(a->extent) + greatest(b->extent) <= TTC_HARMLESS_CANCELLATION * least(extent);
    if (!is_bounded && !(a->is_exact && b->is_exact)) *loss = TTC_CANCELS;
    return atom_fact(extent, atom, false);
}

static fact negate(fact f)
{
    f.extent = ttc_extent_negate(f.extent);
    f.sign = -f.sign;
    return f;
}

/* A product by its factors, a rounded sum as one factor. */
static fact expression_fact(ttc_field *field, ttc_id id)
{
    const ttc_graph *graph = field->graph;
    if (ttc_kind_of(graph, id) == TTC_NUMBER) return number_fact(ttc_coefficient(graph, id));
    if (ttc_kind_of(graph, id) != TTC_PRODUCT) {
        const bool is_symbol = ttc_kind_of(graph, id) == TTC_SYMBOL;
        const ttc_role role = is_symbol ? field->symbols[ttc_symbol_of(graph, id)].role : TTC_ROLE_UNIT;
        const bool is_input = role == TTC_ROLE_PARAM || role == TTC_ROLE_STATE;
        return atom_fact(ttc_field_extent(field, id), id, is_input);
    }
    fact f = number_fact(ttc_coefficient(graph, id));
    for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
        ttc_part part = ttc_part_at(graph, id, i);
        fact factor = expression_fact(field, part.id);
        bool is_exact = f.is_exact && factor.is_exact && part.exponent == 1 && is_power_of_two(&f);
        if (part.exponent % 2 == 0) factor.count = 0;
        if (part.exponent % 2 == 0) factor.sign = 1;
        f = product_fact(&f, &factor, ttc_extent_multiply(f.extent, ttc_extent_power(factor.extent, part.exponent)), id);
        f.is_exact = is_exact;
    }
    return f;
}

typedef struct {
    const ttc_program *program;
    ttc_field *field;
    const ttc_prepared *prepared;
    fact *facts;
} reading;

static fact parameter_fact(const reading *r, uint32_t index)
{
    if (r->prepared != NULL) return expression_fact(r->field, ttc_prepared_at(r->prepared, index));
    return expression_fact(r->field, r->field->model->symbols[r->field->params[index]].node);
}

static fact operation_fact(const reading *r, ttc_value value, ttc_loss *loss)
{
    const ttc_instruction *i = ttc_program_at(r->program, value);
    const uint64_t atom = VALUE_ATOM | value, product_atom = 2 * VALUE_ATOM | value;
    const fact *a = i->a == TTC_NO_VALUE ? NULL : r->facts + i->a, *b = i->b == TTC_NO_VALUE ? NULL : r->facts + i->b;
    fact product, other;
    switch (i->op) {
    case TTC_OP_NEGATE: return negate(*a);
    case TTC_OP_ADD: return add(a, b, atom, loss);
    case TTC_OP_SUBTRACT:
        other = negate(*b);
        return add(a, &other, atom, loss);
    case TTC_OP_MULTIPLY: return multiply(a, b, i->a == i->b, atom);
    case TTC_OP_DIVIDE: return product_fact(a, b, ttc_extent_multiply(a->extent, ttc_extent_power(b->extent, -1)), atom);
    case TTC_OP_FMA:
    case TTC_OP_FMS:
    case TTC_OP_FNMA:
        product = multiply(a, b, i->a == i->b, product_atom);
        if (i->op == TTC_OP_FNMA) product = negate(product);
        other = i->op == TTC_OP_FMS ? negate(r->facts[i->c]) : r->facts[i->c];
        return add(&product, &other, atom, loss);
    case TTC_OP_ROOT: return atom_fact(ttc_extent_root(a->extent), atom, false);
    case TTC_OP_PI: return atom_fact((ttc_extent){ TTC_SIGN_POSITIVE, 3, 4 }, atom, false);
    case TTC_OP_EXP:
        if (!a->is_exact) *loss = TTC_ROUNDED_ARGUMENT;
        return atom_fact(ttc_extent_of_signs(TTC_SIGN_POSITIVE), atom, false);
    case TTC_OP_LOG:
        if (!a->is_exact) *loss = TTC_ROUNDED_ARGUMENT;
        return atom_fact(ttc_extent_any, atom, false);
    default:
        if (!a->is_exact) *loss = TTC_ROUNDED_ARGUMENT;
        return atom_fact((ttc_extent){ TTC_SIGN_ANY, -1, 1 }, atom, false);
    }
}

bool ttc_program_losses(ttc_loss *losses, const ttc_program *program, ttc_field *field, const ttc_prepared *prepared)
{
    size_t n = ttc_program_size(program);
    reading r = { program, field, prepared, calloc(n + 1, sizeof(fact)) };
    if (r.facts == NULL) return false;
    for (ttc_value v = 0; v < n; v++) {
        const ttc_instruction *i = ttc_program_at(program, v);
        losses[v] = TTC_KEEPS_DIGITS;
        if (i->op == TTC_OP_INPUT)
            r.facts[v] = expression_fact(field, field->model->symbols[field->states[i->index]].node);
        else if (i->op == TTC_OP_PARAMETER) r.facts[v] = parameter_fact(&r, i->index);
        else if (i->op == TTC_OP_CONSTANT) r.facts[v] = number_fact(i->constant);
        else r.facts[v] = operation_fact(&r, v, losses + v);
    }
    free(r.facts);
    return true;
}

/* Whether the sum loses digits when its terms, taken as they are, are added in order. */
static bool sum_cancels(ttc_field *field, ttc_id sum)
{
    const ttc_graph *graph = field->graph;
    bool has_constant = !fmpq_is_zero(ttc_coefficient(graph, sum));
    fact total = number_fact(ttc_coefficient(graph, sum));
    for (size_t i = 0; i < ttc_part_count(graph, sum); i++) {
        ttc_part part = ttc_part_at(graph, sum, i);
        ttc_loss loss = TTC_KEEPS_DIGITS;
        fact coefficient = number_fact(part.coefficient), factor = expression_fact(field, part.id);
        fact term = multiply(&coefficient, &factor, false, part.id);
        total = i == 0 && !has_constant ? term : add(&total, &term, VALUE_ATOM | sum, &loss);
        if (loss != TTC_KEEPS_DIGITS) return true;
    }
    return false;
}

static bool cancels(ttc_field *field, ttc_id id, unsigned char *seen)
{
    const ttc_graph *graph = field->graph;
    if (seen[id]) return false;
    seen[id] = 1;
    if (ttc_kind_of(graph, id) == TTC_SYMBOL) {
        const ttc_field_symbol *s = field->symbols + ttc_symbol_of(graph, id);
        return s->role >= TTC_ROLE_UNIT && cancels(field, s->definition, seen);
    }
    if (ttc_kind_of(graph, id) == TTC_SUM && sum_cancels(field, id)) return true;
    for (size_t i = 0; i < ttc_part_count(graph, id); i++)
        if (cancels(field, ttc_part_at(graph, id, i).id, seen)) return true;
    return false;
}

bool ttc_expression_is_rounded(ttc_field *field, ttc_id id) { return !expression_fact(field, id).is_exact; }

bool ttc_expression_cancels(ttc_field *field, ttc_id id)
{
    unsigned char *seen = calloc(ttc_graph_size(field->graph) + 1, 1);
    bool result = seen == NULL || cancels(field, id, seen);
    free(seen);
    return result;
}
