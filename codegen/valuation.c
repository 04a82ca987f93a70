#include "valuation.h"

#include "angle.h"

#include <stdlib.h>

typedef enum { UNKNOWN, BUSY, KNOWN } knowledge;

#define NO_SYMBOL UINT32_MAX

struct ttc_valuation {
    const ttc_model *model;
    ttc_valuation *base;
    ttc_ring *ring; /* owned when base is NULL */
    size_t symbol_count;
    ttc_ratio *values;
    knowledge *known;
    ttc_id *bound, *square; /* by symbol; TTC_NONE: not so */
    slong *variable;        /* by symbol; -1: none */
    bool *freed;            /* by symbol: a root that is a variable */
    const char **names;     /* by variable */
    bool *positive;
    uint32_t *basis;  /* cosines of independent angles, of which all others are sums; plain valuations only */
    size_t basis_count;
    bool has_basis;
    ttc_ratio *memo; /* by node */
    bool *seen;
    size_t memo_size;
};

static const char *const spare_names[TTC_SPARE_VARIABLES] = { "root1", "root2", "root3",  "root4",  "root5",  "root6",
                                                              "root7", "root8", "root9", "root10", "root11", "root12" };

static ttc_valuation *allocate(const ttc_model *model)
{
    ttc_valuation *v = calloc(1, sizeof *v);
    if (v == NULL) return NULL;
    v->model = model;
    v->symbol_count = model->symbol_count + TTC_SPARE_SYMBOLS;
    v->values = calloc(v->symbol_count, sizeof *v->values);
    v->known = calloc(v->symbol_count, sizeof *v->known);
    v->bound = calloc(v->symbol_count, sizeof *v->bound);
    v->square = calloc(v->symbol_count, sizeof *v->square);
    v->variable = calloc(v->symbol_count, sizeof *v->variable);
    v->freed = calloc(v->symbol_count, sizeof *v->freed);
    v->names = calloc(v->symbol_count + TTC_SPARE_VARIABLES, sizeof *v->names);
    v->positive = calloc(v->symbol_count + TTC_SPARE_VARIABLES, sizeof *v->positive);
    v->basis = calloc(v->symbol_count, sizeof *v->basis);
    if (v->values == NULL || v->known == NULL || v->bound == NULL || v->square == NULL || v->variable == NULL || v->freed == NULL
        || v->names == NULL || v->positive == NULL || v->basis == NULL) {
        v->symbol_count = 0;
        ttc_valuation_destroy(v);
        return NULL;
    }
    for (size_t i = 0; i < v->symbol_count; i++) v->variable[i] = -1;
    return v;
}

static bool is_positive(const ttc_model *model, const ttc_symbol_entry *entry)
{
    switch (entry->kind) {
    case TTC_ROOT: return true;
    case TTC_PARAM: return entry->sign == TTC_POSITIVE || entry->sign == TTC_NONNEGATIVE;
    case TTC_STATE:
        return entry->low != TTC_NONE && ttc_kind_of(model->graph, entry->low) == TTC_NUMBER
               && fmpq_sgn(ttc_coefficient(model->graph, entry->low)) >= 0;
    default: return false;
    }
}

/* Variables in the order of symbols, spare symbols and spare roots last. */
static void name_variables(ttc_valuation *v, size_t *used)
{
    for (size_t i = 0; i < v->model->symbol_count; i++) {
        const ttc_symbol_entry *entry = &v->model->symbols[i];
        if (entry->kind == TTC_LET) continue;
        v->variable[i] = (slong)*used;
        v->names[*used] = entry->name;
        v->positive[*used] = is_positive(v->model, entry);
        ++*used;
    }
}

ttc_valuation *ttc_valuation_create(const ttc_model *model, unsigned choices)
{
    size_t used = 0;
    ttc_valuation *v = allocate(model);
    if (v == NULL) return NULL;
    name_variables(v, &used);
    size_t total = used + TTC_SPARE_VARIABLES;
    for (size_t i = 0; i < TTC_SPARE_VARIABLES; i++) v->names[used + i] = spare_names[i];
    for (size_t i = 0; i < TTC_SPARE_SYMBOLS; i++) v->variable[model->symbol_count + i] = (slong)(used + i);
    v->ring = ttc_ring_create(total, used + TTC_SPARE_SYMBOLS, v->names, v->positive);
    if (v->ring == NULL) {
        v->symbol_count = 0;
        ttc_valuation_destroy(v);
        return NULL;
    }
    v->ring->choices = choices;
    for (size_t i = 0; i < v->symbol_count; i++) ttc_ratio_init(v->ring, &v->values[i]);
    return v;
}

ttc_valuation *ttc_valuation_map(const ttc_model *model, ttc_valuation *base)
{
    ttc_valuation *v = allocate(model);
    if (v == NULL) return NULL;
    v->base = base;
    v->ring = base->ring;
    for (size_t i = 0; i < v->symbol_count; i++) ttc_ratio_init(v->ring, &v->values[i]);
    return v;
}

void ttc_valuation_destroy(ttc_valuation *v)
{
    if (v == NULL) return;
    for (size_t i = 0; i < v->symbol_count; i++) ttc_ratio_clear(v->ring, &v->values[i]);
    for (size_t i = 0; i < v->memo_size; i++)
        if (v->seen[i]) ttc_ratio_clear(v->ring, &v->memo[i]);
    if (v->base == NULL) ttc_ring_destroy(v->ring);
    free(v->seen);
    free(v->memo);
    free(v->basis);
    free(v->positive);
    free(v->names);
    free(v->freed);
    free(v->variable);
    free(v->square);
    free(v->bound);
    free(v->known);
    free(v->values);
    free(v);
}

ttc_ring *ttc_valuation_ring(ttc_valuation *v) { return v->ring; }
const ttc_model *ttc_valuation_model(const ttc_valuation *v) { return v->model; }
void ttc_valuation_bind(ttc_valuation *v, uint32_t symbol, ttc_id expression) { v->bound[symbol] = expression; }
void ttc_valuation_bind_square(ttc_valuation *v, uint32_t symbol, ttc_id square) { v->square[symbol] = square; }
void ttc_valuation_free_root(ttc_valuation *v, uint32_t symbol) { v->freed[symbol] = true; }
slong ttc_valuation_variable(const ttc_valuation *v, uint32_t symbol) { return v->variable[symbol]; }

bool ttc_valuation_is_bound(const ttc_valuation *v, uint32_t symbol)
{
    return v->bound[symbol] != TTC_NONE || v->square[symbol] != TTC_NONE;
}

size_t ttc_valuation_symbol(const ttc_valuation *v, slong variable)
{
    for (size_t i = 0; i < v->symbol_count; i++)
        if (v->variable[i] == variable) return i;
    return SIZE_MAX;
}

static void symbol_value(ttc_valuation *v, ttc_ratio *out, uint32_t symbol);

static bool in_basis(const ttc_valuation *v, uint32_t cosine)
{
    for (size_t i = 0; i < v->basis_count; i++)
        if (v->basis[i] == cosine) return true;
    return false;
}

/* How an angle follows from the basis. */
static ttc_angle_relation relate(ttc_valuation *v, long *multiples, const ttc_ratio *angle)
{
    ttc_angle_relation relation = TTC_ANGLE_FREE;
    const size_t count = v->basis_count;
    ttc_ratio *angles = calloc(count + 1, sizeof *angles);
    if (angles == NULL) {
        ttc_ring_fail(v->ring, TTC_RING_NO_MEMORY);
        return relation;
    }
    for (size_t i = 0; i < count; i++) {
        ttc_ratio_init(v->ring, angles + i);
        ttc_evaluate(v, angles + i, v->model->symbols[v->basis[i]].definition);
    }
    if (v->ring->status == TTC_RING_OK) relation = ttc_angle_relate(v->ring, multiples, angle, angles, count);
    for (size_t i = 0; i < count; i++) ttc_ratio_clear(v->ring, angles + i);
    free(angles);
    return relation;
}

static bool is_angle(ttc_symbol_kind kind) { return kind == TTC_COSINE || kind == TTC_SINE; }

/* The table's angles, without those of cosines and sines of others, which join the basis when they are met. Their number
 * is bounded because that of comparisons is its cube. */
static size_t plain_angles(ttc_valuation *v, uint32_t *cosines)
{
    const ttc_model *model = v->model;
    size_t count = 0;
    for (uint32_t i = 0; i < model->symbol_count; i++) {
        const ttc_symbol_entry *entry = &model->symbols[i];
        if (entry->kind != TTC_COSINE) continue;
        unsigned char *support = ttc_model_support(model, &entry->definition, 1);
        bool plain = support != NULL;
        if (support == NULL) ttc_ring_fail(v->ring, TTC_RING_NO_MEMORY);
        for (uint32_t k = 0; plain && k < model->symbol_count; k++) plain = !support[k] || !is_angle(model->symbols[k].kind);
        free(support);
        if (plain) cosines[count++] = i;
        if (count > TTC_ANGLE_LIMIT) ttc_ring_fail(v->ring, TTC_RING_TOO_LARGE);
        if (v->ring->status != TTC_RING_OK) return 0;
    }
    return count;
}

static void find_basis(ttc_valuation *v)
{
    uint32_t *cosines = calloc(v->model->symbol_count + 1, sizeof *cosines);
    ttc_ratio angles[TTC_ANGLE_LIMIT];
    size_t chosen[TTC_ANGLE_LIMIT], count = 0, fixed = 0;

    v->has_basis = true;
    if (cosines == NULL) ttc_ring_fail(v->ring, TTC_RING_NO_MEMORY);
    else count = plain_angles(v, cosines);
    for (size_t i = 0; i < count; i++) {
        ttc_ratio_init(v->ring, angles + i);
        ttc_evaluate(v, angles + i, v->model->symbols[cosines[i]].definition);
    }
    /* An angle that is in the basis by now is part of what a state is bound to; it has its variable, and keeps it. */
    for (size_t i = 0; i < count; i++) {
        if (!in_basis(v, cosines[i])) continue;
        const uint32_t cosine = cosines[fixed];
        const ttc_ratio angle = angles[fixed];
        cosines[fixed] = cosines[i];
        angles[fixed++] = angles[i];
        cosines[i] = cosine;
        angles[i] = angle;
    }
    if (fixed < v->basis_count) ttc_ring_fail(v->ring, TTC_RING_ANGLE);
    if (v->ring->status == TTC_RING_OK) v->basis_count = ttc_angle_choose(v->ring, chosen, angles, count, fixed);
    for (size_t i = 0; i < v->basis_count; i++) v->basis[i] = cosines[chosen[i]];
    for (size_t i = 0; i < count; i++) ttc_ratio_clear(v->ring, angles + i);
    free(cosines);
}

/* cos or sin of a sum of multiples of the basis */
static void sum_of_angles(ttc_valuation *v, ttc_ratio *out, const long *multiples, size_t count, bool is_sine)
{
    ttc_ratio cosine, sine, c, s;
    ttc_ratio_init(v->ring, &cosine);
    ttc_ratio_init(v->ring, &sine);
    ttc_ratio_init(v->ring, &c);
    ttc_ratio_init(v->ring, &s);
    ttc_ratio_set_integer(v->ring, &cosine, 1);
    for (size_t i = 0; i < count; i++) {
        if (multiples[i] == 0) continue;
        symbol_value(v, &c, v->basis[i]);
        symbol_value(v, &s, v->model->symbols[v->basis[i]].partner);
        ttc_angle_turn(v->ring, &cosine, &sine, &c, &s, multiples[i]);
    }
    ttc_ratio_set(v->ring, out, is_sine ? &sine : &cosine);
    ttc_ratio_clear(v->ring, &s);
    ttc_ratio_clear(v->ring, &c);
    ttc_ratio_clear(v->ring, &sine);
    ttc_ratio_clear(v->ring, &cosine);
}

/* cos or sin of any angle in a plain valuation; cosine: the symbol that may join the basis with it, or NO_SYMBOL. */
static void value_at_angle(ttc_valuation *v, ttc_ratio *out, const ttc_ratio *angle, bool is_sine, uint32_t cosine)
{
    if (!v->has_basis) find_basis(v);
    const size_t count = v->basis_count;
    long *multiples = calloc(count + 1, sizeof *multiples);
    if (multiples == NULL) ttc_ring_fail(v->ring, TTC_RING_NO_MEMORY);
    ttc_angle_relation relation = v->ring->status == TTC_RING_OK ? relate(v, multiples, angle) : TTC_ANGLE_FREE;
    if (v->ring->status != TTC_RING_OK) {
        free(multiples);
        return;
    }
    if (relation == TTC_ANGLE_WHOLE) sum_of_angles(v, out, multiples, count, is_sine);
    else if (relation == TTC_ANGLE_FRACTION) ttc_ring_fail(v->ring, TTC_RING_ANGLE_FRACTION);
    else if (cosine == NO_SYMBOL) ttc_ring_fail(v->ring, TTC_RING_ANGLE);
    else v->basis[v->basis_count++] = cosine;
    free(multiples);
}

void ttc_valuation_angle(ttc_valuation *v, ttc_ratio *out, const ttc_ratio *angle, bool is_sine)
{
    value_at_angle(v, out, angle, is_sine, NO_SYMBOL);
}

/* Of an angle in the basis the cosine is a free variable, and the sine a square root of 1 - cos^2. */
static void angle_value(ttc_valuation *v, ttc_ratio *out, uint32_t symbol)
{
    const ttc_symbol_entry *entry = &v->model->symbols[symbol];
    const bool is_sine = entry->kind == TTC_SINE;
    const uint32_t cosine = is_sine ? entry->partner : symbol;
    ttc_ratio angle, one;
    ttc_ratio_init(v->ring, &angle);
    ttc_ratio_init(v->ring, &one);
    ttc_evaluate(v, &angle, entry->definition);
    if (v->base != NULL) {
        ttc_valuation_angle(v->base, out, &angle, is_sine);
        goto done;
    }
    if (!v->has_basis) find_basis(v);
    if (!in_basis(v, cosine)) value_at_angle(v, out, &angle, is_sine, cosine);
    if (!in_basis(v, cosine)) goto done;
    ttc_ratio_set_variable(v->ring, out, v->variable[cosine]);
    if (is_sine) {
        ttc_ratio_multiply(v->ring, out, out, out);
        ttc_ratio_set_integer(v->ring, &one, 1);
        ttc_ratio_subtract(v->ring, &angle, &one, out);
        ttc_ring_root(v->ring, out, &angle, v->variable[symbol], false);
    }
done:
    ttc_ratio_clear(v->ring, &one);
    ttc_ratio_clear(v->ring, &angle);
}

static void defined_value(ttc_valuation *v, ttc_ratio *out, uint32_t symbol)
{
    bool spare = symbol >= v->model->symbol_count;
    const ttc_symbol_entry *entry = spare ? NULL : &v->model->symbols[symbol];
    if (v->bound[symbol] != TTC_NONE) {
        ttc_evaluate(v->base != NULL ? v->base : v, out, v->bound[symbol]);
        if (!spare && entry->kind == TTC_ROOT && ttc_ratio_is_zero(v->ring, out))
            ttc_ring_fail(v->ring, TTC_RING_ROOT_OF_ZERO);
    } else if (v->square[symbol] != TTC_NONE) {
        ttc_evaluate(v, out, v->square[symbol]);
        ttc_ring_root(v->ring, out, out, v->variable[symbol], false);
    } else if (!spare && entry->kind == TTC_LET) {
        ttc_evaluate(v, out, entry->definition);
    } else if (!spare && entry->kind == TTC_ROOT && !v->freed[symbol]) {
        ttc_evaluate(v, out, entry->definition);
        ttc_ring_root(v->ring, out, out, v->variable[symbol], true);
    } else if (!spare && is_angle(entry->kind)) {
        angle_value(v, out, symbol);
    } else if (v->variable[symbol] >= 0) {
        ttc_ratio_set_variable(v->ring, out, v->variable[symbol]);
    } else {
        ttc_ring_fail(v->ring, TTC_RING_CIRCULAR);
    }
}

static void symbol_value(ttc_valuation *v, ttc_ratio *out, uint32_t symbol)
{
    if (v->known[symbol] == BUSY) ttc_ring_fail(v->ring, TTC_RING_CIRCULAR);
    if (v->ring->status != TTC_RING_OK) return;
    if (v->known[symbol] == UNKNOWN) {
        ttc_ratio value;
        ttc_ratio_init(v->ring, &value);
        v->known[symbol] = BUSY;
        defined_value(v, &value, symbol);
        ttc_ratio_set(v->ring, &v->values[symbol], &value);
        v->known[symbol] = KNOWN;
        ttc_ratio_clear(v->ring, &value);
    }
    ttc_ratio_set(v->ring, out, &v->values[symbol]);
}

static bool reserve_memo(ttc_valuation *v)
{
    size_t size = ttc_graph_size(v->model->graph) + 1;
    if (size <= v->memo_size) return true;
    ttc_ratio *memo = realloc(v->memo, size * sizeof *memo);
    if (memo != NULL) v->memo = memo;
    bool *seen = realloc(v->seen, size * sizeof *seen);
    if (seen != NULL) v->seen = seen;
    if (memo == NULL || seen == NULL) {
        ttc_ring_fail(v->ring, TTC_RING_NO_MEMORY);
        return false;
    }
    for (size_t i = v->memo_size; i < size; i++) seen[i] = false;
    v->memo_size = size;
    return true;
}

static void compound_value(ttc_valuation *v, ttc_ratio *out, ttc_id id, ttc_kind kind)
{
    const ttc_graph *graph = v->model->graph;
    ttc_ratio part_value;
    ttc_ratio_init(v->ring, &part_value);
    ttc_ratio_set_rational(v->ring, out, ttc_coefficient(graph, id));
    for (size_t i = 0; i < ttc_part_count(graph, id) && v->ring->status == TTC_RING_OK; i++) {
        ttc_part part = ttc_part_at(graph, id, i);
        ttc_evaluate(v, &part_value, part.id);
        if (kind == TTC_SUM) {
            ttc_ratio_scale(v->ring, &part_value, &part_value, part.coefficient);
            ttc_ratio_add(v->ring, out, out, &part_value);
        } else {
            ttc_ratio_power(v->ring, &part_value, &part_value, part.exponent);
            ttc_ratio_multiply(v->ring, out, out, &part_value);
        }
    }
    ttc_ratio_clear(v->ring, &part_value);
}

void ttc_evaluate(ttc_valuation *v, ttc_ratio *out, ttc_id id)
{
    const ttc_graph *graph = v->model->graph;
    if (id == TTC_NONE) ttc_ring_fail(v->ring, TTC_RING_TOO_LARGE);
    if (v->ring->status != TTC_RING_OK || !reserve_memo(v)) return;
    if (!v->seen[id]) {
        ttc_kind kind = ttc_kind_of(graph, id);
        ttc_ratio value;
        ttc_ratio_init(v->ring, &value);
        if (kind == TTC_SYMBOL) symbol_value(v, &value, ttc_symbol_of(graph, id));
        else compound_value(v, &value, id, kind);
        v->memo[id] = value;
        v->seen[id] = true;
    }
    ttc_ratio_set(v->ring, out, &v->memo[id]);
}
