#include "fields/numerator.h"

#include <string.h>

enum { PASSES = 64 };

/* The number of factors of a term; a symbol or a sum is a single factor, a number has none. */
static size_t factor_count(const ttc_graph *graph, ttc_id term)
{
    ttc_kind kind = ttc_kind_of(graph, term);
    return kind == TTC_PRODUCT ? ttc_part_count(graph, term) : kind == TTC_NUMBER ? 0 : 1;
}

static ttc_part factor_at(const ttc_graph *graph, ttc_id term, size_t index)
{
    if (ttc_kind_of(graph, term) == TTC_PRODUCT) return ttc_part_at(graph, term, index);
    return (ttc_part){ .id = term, .exponent = 1 };
}

void ttc_signature_of(ttc_signature *signature, ttc_scratch *scratch, ttc_id term)
{
    const ttc_graph *graph = scratch->graph;
    bool has_coefficient = ttc_kind_of(graph, term) == TTC_PRODUCT || ttc_kind_of(graph, term) == TTC_NUMBER;
    *signature = (ttc_signature){ .sign = has_coefficient ? fmpq_sgn(ttc_coefficient(graph, term)) : 1 };
    for (size_t i = 0; i < factor_count(graph, term); i++) {
        ttc_part part = factor_at(graph, term, i);
        ttc_extent extent = ttc_scratch_extent(scratch, part.id);
        if (part.exponent % 2 == 0 || ttc_extent_is_nonnegative(extent)) continue;
        if (ttc_extent_is_nonpositive(extent)) signature->sign = -signature->sign;
        else if (signature->count < TTC_TERMS_LIMIT) signature->odd[signature->count++] = part.id;
        else signature->sign = 0;
    }
}

bool ttc_signature_same(const ttc_signature *a, const ttc_signature *b)
{
    return a->count == b->count && memcmp(a->odd, b->odd, a->count * sizeof *a->odd) == 0;
}

bool ttc_is_like_signed(ttc_scratch *scratch, ttc_id id)
{
    const ttc_graph *graph = scratch->graph;
    ttc_signature first, other;
    if (ttc_kind_of(graph, id) != TTC_SUM) return true;
    for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
        ttc_part part = ttc_part_at(graph, id, i);
        ttc_signature_of(&other, scratch, part.id);
        other.sign *= fmpq_sgn(part.coefficient);
        if (i == 0) first = other;
        if (other.sign == 0 || other.sign != first.sign || !ttc_signature_same(&first, &other)) return false;
    }
    int constant = fmpq_sgn(ttc_coefficient(graph, id));
    return constant == 0 || (constant == first.sign && first.count == 0);
}

size_t ttc_terms_of(ttc_graph *graph, ttc_id *terms, ttc_id sum)
{
    size_t count = 0, parts = ttc_part_count(graph, sum);
    if (parts + 1 > TTC_TERMS_LIMIT) return 0;
    if (!fmpq_is_zero(ttc_coefficient(graph, sum))) terms[count++] = ttc_number(graph, ttc_coefficient(graph, sum));
    for (size_t i = 0; i < parts; i++) {
        ttc_part part = ttc_part_at(graph, sum, i);
        terms[count++] = ttc_scale(graph, part.id, part.coefficient);
    }
    for (size_t i = 0; i < count; i++)
        if (terms[i] == TTC_NONE) return 0;
    return count;
}

ttc_id ttc_common_factor(ttc_graph *graph, const ttc_id *terms, size_t count)
{
    ttc_id bases[TTC_TERMS_LIMIT];
    long exponents[TTC_TERMS_LIMIT];
    size_t uses[TTC_TERMS_LIMIT], found = 0;
    for (size_t t = 0; t < count; t++)
        for (size_t i = 0; i < factor_count(graph, terms[t]); i++) {
            ttc_part part = factor_at(graph, terms[t], i);
            size_t at = 0;
            while (at < found && bases[at] != part.id) at++;
            if (at == TTC_TERMS_LIMIT) return TTC_NONE;
            if (at == found) {
                bases[found] = part.id;
                exponents[found] = part.exponent;
                uses[found++] = 0;
            }
            if (part.exponent < exponents[at]) exponents[at] = part.exponent;
            uses[at]++;
        }
    for (size_t i = 0; i < found; i++)
        if (uses[i] < count && exponents[i] > 0) exponents[i] = 0;
    return ttc_product(graph, bases, exponents, found);
}

/* content * rest, term by term where the content is a sum. It is the definition of one factor of a term, or the radicand for the
 * square of a root; rest is the term divided by that. */
static ttc_id distribute(ttc_graph *graph, ttc_id content, ttc_id rest)
{
    ttc_id terms[TTC_TERMS_LIMIT];
    if (ttc_kind_of(graph, content) != TTC_SUM) return ttc_multiply(graph, content, rest);
    size_t count = ttc_terms_of(graph, terms, content);
    for (size_t i = 0; i < count; i++) terms[i] = ttc_multiply(graph, terms[i], rest);
    return count == 0 ? TTC_NONE : ttc_sum(graph, terms, NULL, count);
}

/* A factor that is a sum, or the definition of one that is a unit; TTC_NONE for other symbols. */
static ttc_id sum_of(ttc_scratch *scratch, ttc_id factor)
{
    if (ttc_kind_of(scratch->graph, factor) == TTC_SUM) return factor;
    return ttc_scratch_definition(scratch, factor, TTC_ROLE_UNIT);
}

ttc_id ttc_compound_factor(ttc_scratch *scratch, ttc_id id, size_t k)
{
    const ttc_graph *graph = scratch->graph;
    bool is_sum = ttc_kind_of(graph, id) == TTC_SUM;
    for (size_t t = 0; t < (is_sum ? ttc_part_count(graph, id) : 1); t++) {
        ttc_id term = is_sum ? ttc_part_at(graph, id, t).id : id;
        for (size_t i = 0; i < factor_count(graph, term); i++) {
            ttc_part factor = factor_at(graph, term, i);
            if (factor.exponent > 0 && sum_of(scratch, factor.id) != TTC_NONE && k-- == 0) return factor.id;
        }
    }
    return TTC_NONE;
}

/* Multiply out one factor of a term. Returns the term itself if there is none to multiply out. */
static ttc_id multiply_out_once(ttc_scratch *scratch, ttc_id term, unsigned height, ttc_id chosen)
{
    ttc_graph *graph = scratch->graph;
    for (size_t i = 0; i < factor_count(graph, term); i++) {
        ttc_part factor = factor_at(graph, term, i);
        if (factor.exponent < 1) continue;
        long power = 1;
        ttc_id content = sum_of(scratch, factor.id);
        if (content != TTC_NONE && factor.id != chosen && ttc_scratch_height(scratch, factor.id) <= height) continue;
        if (content == TTC_NONE && factor.exponent > 1) {
            content = ttc_scratch_definition(scratch, factor.id, TTC_ROLE_ROOT);
            power = 2;
        }
        if (content == TTC_NONE) continue;
        return distribute(graph, content, ttc_multiply(graph, term, ttc_power(graph, factor.id, -power)));
    }
    return term;
}

ttc_id ttc_multiply_out(ttc_scratch *scratch, ttc_id id, unsigned height, ttc_id chosen)
{
    ttc_graph *graph = scratch->graph;
    for (unsigned pass = 0; pass < PASSES && id != TTC_NONE; pass++) {
        ttc_id terms[TTC_TERMS_LIMIT], before = id;
        size_t count = 1;
        terms[0] = id;
        if (ttc_kind_of(graph, id) == TTC_SUM) count = ttc_terms_of(graph, terms, id);
        if (count == 0) return TTC_NONE;
        for (size_t t = 0; t < count; t++) {
            terms[t] = multiply_out_once(scratch, terms[t], height, chosen);
            if (terms[t] == TTC_NONE) return TTC_NONE;
        }
        id = ttc_sum(graph, terms, NULL, count);
        if (id == before) return id;
    }
    return TTC_NONE;
}
