/* Rewriting of sums so that terms of opposite signs do not cancel. */
#include "fields/numerator.h"
#include "fields/simplify.h"

#include <stdlib.h>

/* Bound on attempts in one field, after which sums stay as they are. The tables of this project need some hundreds each. */
enum { ATTEMPT_LIMIT = 20000 };

/* The terms of a sum. `members` are the indices of the terms that are being rewritten. */
typedef struct {
    ttc_scratch *scratch;
    ttc_id terms[TTC_TERMS_LIMIT];
    ttc_signature signatures[TTC_TERMS_LIMIT];
    size_t count;
    size_t members[TTC_TERMS_LIMIT];
    size_t member_count;
} trial;

static ttc_graph *graph_of(const trial *t) { return t->scratch->graph; }

/* factor * sum, with common factors of the sum's terms taken out of the sum. */
static ttc_id product_of(ttc_graph *graph, ttc_id factor, ttc_id sum)
{
    ttc_id terms[TTC_TERMS_LIMIT];
    size_t count = ttc_kind_of(graph, sum) == TTC_SUM ? ttc_terms_of(graph, terms, sum) : 0;
    ttc_id common = count == 0 ? TTC_NONE : ttc_common_factor(graph, terms, count);
    if (common == TTC_NONE) return ttc_multiply(graph, factor, sum);
    for (size_t i = 0; i < count; i++) terms[i] = ttc_divide(graph, terms[i], common);
    ttc_id rest = ttc_sum(graph, terms, NULL, count);
    return ttc_multiply(graph, ttc_multiply(graph, factor, common), rest);
}

/* Multiply out one further factor of the expression so that it becomes like-signed. Returns TTC_NONE if none makes it so. */
static ttc_id with_one_factor_more(trial *t, ttc_id form, unsigned height)
{
    ttc_id chosen = TTC_NONE;
    for (size_t k = 0; (chosen = ttc_compound_factor(t->scratch, form, k)) != TTC_NONE; k++) {
        ttc_id more = ttc_multiply_out(t->scratch, form, height, chosen);
        if (more != TTC_NONE && ttc_is_like_signed(t->scratch, more)) return more;
    }
    return TTC_NONE;
}

/* Multiply out an expression as little as makes it like-signed, the highest sums first: a sum that contains a square is higher
 * than what is squared. Returns TTC_NONE if it does not become like-signed. */
static ttc_id like_signed_form(trial *t, ttc_id id)
{
    unsigned height = id == TTC_NONE ? 0 : ttc_scratch_height_inside(t->scratch, id) + 1;
    while (id != TTC_NONE) {
        ttc_id form = ttc_multiply_out(t->scratch, id, height, TTC_NONE);
        if (form == TTC_NONE || ttc_is_like_signed(t->scratch, form)) return form;
        ttc_id more = with_one_factor_more(t, form, height);
        unsigned greatest = ttc_scratch_height_inside(t->scratch, form);
        if (more != TTC_NONE) return more;
        if (height == 0 || greatest == 0) return TTC_NONE;
        height = greatest < height ? greatest - 1 : height - 1;
        id = form;
    }
    return TTC_NONE;
}

/* The members over their common denominator, with a like-signed numerator; TTC_NONE if there is none. */
static ttc_id over_common_denominator(trial *t)
{
    ttc_graph *graph = graph_of(t);
    ttc_id terms[TTC_TERMS_LIMIT];
    for (size_t i = 0; i < t->member_count; i++) terms[i] = t->terms[t->members[i]];
    ttc_id common = ttc_common_factor(graph, terms, t->member_count);
    if (common == TTC_NONE) return TTC_NONE;
    for (size_t i = 0; i < t->member_count; i++) terms[i] = ttc_divide(graph, terms[i], common);
    ttc_id numerator = like_signed_form(t, ttc_sum(graph, terms, NULL, t->member_count));
    return numerator == TTC_NONE ? TTC_NONE : product_of(graph, common, numerator);
}

static bool has_odd_root(ttc_scratch *scratch, ttc_id id)
{
    const ttc_graph *graph = scratch->graph;
    if (ttc_kind_of(graph, id) == TTC_SYMBOL) return ttc_scratch_definition(scratch, id, TTC_ROLE_ROOT) != TTC_NONE;
    for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
        ttc_part part = ttc_part_at(graph, id, i);
        if (part.exponent % 2 != 0 && has_odd_root(scratch, part.id)) return true;
    }
    return false;
}

/* The members, A - B, as (A^2 - B^2)/(A + B), if A + B is like-signed and never zero, and A or B contains an odd power of a root;
 * otherwise TTC_NONE. sides = { A, -B }, divided by their common factor. */
static ttc_id by_conjugate(trial *t)
{
    ttc_graph *graph = graph_of(t);
    ttc_id terms[TTC_TERMS_LIMIT], sides[2] = { ttc_integer(graph, 0), ttc_integer(graph, 0) };
    for (size_t i = 0; i < t->member_count; i++) terms[i] = t->terms[t->members[i]];
    ttc_id common = ttc_common_factor(graph, terms, t->member_count);
    for (size_t i = 0; i < t->member_count && common != TTC_NONE; i++) {
        int side = t->signatures[t->members[i]].sign < 0;
        sides[side] = ttc_add(graph, sides[side], ttc_divide(graph, terms[i], common));
    }
    if (common == TTC_NONE || sides[0] == TTC_NONE || sides[1] == TTC_NONE) return TTC_NONE;
    if (!has_odd_root(t->scratch, sides[0]) && !has_odd_root(t->scratch, sides[1])) return TTC_NONE;
    ttc_id conjugate = ttc_subtract(graph, sides[0], sides[1]);
    if (conjugate == TTC_NONE || !ttc_is_like_signed(t->scratch, conjugate)
        || (ttc_scratch_extent(t->scratch, conjugate).signs & TTC_SIGN_ZERO) != 0)
        return TTC_NONE;
    ttc_id left = ttc_multiply_out(t->scratch, ttc_power(graph, sides[0], 2), 0, TTC_NONE);
    ttc_id right = ttc_multiply_out(t->scratch, ttc_power(graph, sides[1], 2), 0, TTC_NONE);
    if (left == TTC_NONE || right == TTC_NONE) return TTC_NONE;
    ttc_id numerator = like_signed_form(t, ttc_subtract(graph, left, right));
    if (numerator == TTC_NONE) return TTC_NONE;
    return ttc_divide(graph, product_of(graph, common, numerator), conjugate);
}

/* The sum with its members rewritten; TTC_NONE if no better form is found. */
static ttc_id replace_members(trial *t, ttc_id sum)
{
    ttc_graph *graph = graph_of(t);
    if (t->scratch->attempts++ >= ATTEMPT_LIMIT) return TTC_NONE;
    ttc_id form = over_common_denominator(t);
    if (form == TTC_NONE) form = by_conjugate(t);
    for (size_t i = 0; i < t->member_count && form != TTC_NONE; i++) sum = ttc_subtract(graph, sum, t->terms[t->members[i]]);
    return form == TTC_NONE || sum == TTC_NONE ? TTC_NONE : ttc_add(graph, sum, form);
}

static bool can_cancel(const ttc_signature *a, const ttc_signature *b)
{
    return a->sign * b->sign < 0 && ttc_signature_same(a, b);
}

/* Make members of all terms whose sign is, at every state, that of term `first` or its opposite. Returns false if these are the
 * whole sum, have one sign, or include an earlier term, so that they were tried before. */
static bool choose_class(trial *t, size_t first)
{
    bool cancels = false;
    t->member_count = 0;
    for (size_t i = 0; i < t->count; i++) {
        if (!ttc_signature_same(t->signatures + first, t->signatures + i)) continue;
        if (i < first) return false;
        cancels |= can_cancel(t->signatures + first, t->signatures + i);
        t->members[t->member_count++] = i;
    }
    return cancels && t->member_count < t->count;
}

/* Rewrite all terms, else a class of terms, else a pair: the first that gives a better form. Returns TTC_NONE if none does. */
static ttc_id improve(trial *t, ttc_id sum)
{
    ttc_id better = TTC_NONE;
    t->member_count = t->count;
    for (size_t i = 0; i < t->count; i++) t->members[i] = i;
    better = replace_members(t, sum);
    for (size_t i = 0; i < t->count && better == TTC_NONE; i++)
        if (choose_class(t, i)) better = replace_members(t, sum);
    for (size_t i = 0; i < t->count && t->count > 2; i++)
        for (size_t j = i + 1; j < t->count && better == TTC_NONE; j++) {
            if (!can_cancel(t->signatures + i, t->signatures + j)) continue;
            t->members[0] = i;
            t->members[1] = j;
            t->member_count = 2;
            better = replace_members(t, sum);
        }
    return better;
}

static ttc_id search(trial *t, ttc_id sum)
{
    for (bool changed = true; changed && !ttc_is_like_signed(t->scratch, sum);) {
        t->count = ttc_terms_of(graph_of(t), t->terms, sum);
        for (size_t i = 0; i < t->count; i++) ttc_signature_of(t->signatures + i, t->scratch, t->terms[i]);
        ttc_id better = t->count < 2 ? TTC_NONE : improve(t, sum);
        changed = better != TTC_NONE && better != sum;
        if (changed) sum = better;
    }
    return sum;
}

ttc_id ttc_write_without_cancellation(ttc_field *field, ttc_id sum)
{
    ttc_scratch *scratch = ttc_scratch_of(field);
    ttc_id start = scratch == NULL ? TTC_NONE : ttc_scratch_import(scratch, sum);
    if (start == TTC_NONE) return TTC_NONE;
    if (scratch->forms[sum] != TTC_NONE) {
        field->form_count += scratch->forms[sum] != sum;
        return scratch->forms[sum];
    }
    trial *t = malloc(sizeof *t);
    if (t == NULL) return TTC_NONE;
    t->scratch = scratch;
    ttc_id form = search(t, start), result = form == start ? sum : ttc_scratch_export(scratch, form);
    free(t);
    bool no_memory = scratch->failed || ttc_graph_error(scratch->graph) == TTC_GRAPH_NO_MEMORY;
    if (no_memory || result == TTC_NONE) return TTC_NONE;
    ttc_graph_clear_error(scratch->graph);
    field->form_count += result != sum;
    return scratch->forms[sum] = result;
}
