#include "fields/simplify.h"

/* t + ratio t = factor t */
typedef struct {
    ttc_id ratio, factor;
} identity;

enum { IDENTITIES = 3 };

static ttc_id minus(ttc_graph *graph, ttc_id id) { return ttc_multiply(graph, id, ttc_integer(graph, -1)); }

/* The identities of a root. Returns false if the symbol is no root that depends on the state, or its radicand has not two terms. */
static bool identities_of(ttc_field *field, uint32_t symbol, identity *list)
{
    ttc_graph *graph = field->graph;
    const ttc_field_symbol *s = field->symbols + symbol;
    if (s->role != TTC_ROLE_ROOT || s->is_constant || ttc_kind_of(graph, s->definition) != TTC_SUM) return false;
    bool has_constant = !fmpq_is_zero(ttc_coefficient(graph, s->definition));
    if (ttc_part_count(graph, s->definition) + has_constant != 2) return false;
    ttc_part last = ttc_part_at(graph, s->definition, has_constant ? 0 : 1), first = ttc_part_at(graph, s->definition, 0);
    ttc_id a = has_constant ? ttc_number(graph, ttc_coefficient(graph, s->definition))
                            : ttc_scale(graph, first.id, first.coefficient);
    ttc_id b = ttc_scale(graph, last.id, last.coefficient);
    ttc_id square = ttc_power(graph, s->node, 2);
    /* One new node in each declarator or statement: C leaves the order within an expression open, and ids depend on it. */
    ttc_id b_over_a = ttc_divide(graph, b, a), square_over_a = ttc_divide(graph, square, a);
    ttc_id a_over_b = ttc_divide(graph, a, b), square_over_b = ttc_divide(graph, square, b);
    list[0] = (identity){ b_over_a, square_over_a };
    list[1].ratio = minus(graph, square_over_a);
    list[1].factor = minus(graph, b_over_a);
    list[2].ratio = minus(graph, square_over_b);
    list[2].factor = minus(graph, a_over_b);
    return true;
}

static ttc_id term_at(ttc_graph *graph, ttc_id sum, size_t index)
{
    ttc_part part = ttc_part_at(graph, sum, index);
    return ttc_scale(graph, part.id, part.coefficient);
}

/* Merge one pair of terms. Returns the sum itself if there is none to merge. */
static ttc_id merge_once(ttc_graph *graph, ttc_id sum, const identity *list)
{
    size_t n = ttc_part_count(graph, sum);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) {
            if (i == j) continue;
            ttc_id t = term_at(graph, sum, i), other = term_at(graph, sum, j);
            ttc_id ratio = ttc_divide(graph, other, t);
            for (size_t k = 0; k < IDENTITIES && ratio != TTC_NONE; k++)
                if (ratio == list[k].ratio) {
                    ttc_id rest = ttc_subtract(graph, ttc_subtract(graph, sum, t), other);
                    return ttc_add(graph, rest, ttc_multiply(graph, t, list[k].factor));
                }
        }
    return sum;
}

ttc_id ttc_simplify_roots(ttc_field *field, ttc_id sum)
{
    identity list[IDENTITIES];
    for (uint32_t s = 0; s < field->symbol_count; s++) {
        if (!identities_of(field, s, list)) continue;
        for (ttc_id before = TTC_NONE; before != sum && sum != TTC_NONE;) {
            if (ttc_kind_of(field->graph, sum) != TTC_SUM) return sum;
            before = sum;
            sum = merge_once(field->graph, sum, list);
        }
    }
    return sum;
}
