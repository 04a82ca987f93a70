#include "challenge/random_point.h"

#include "base/array.h"

#include <stdlib.h>

bool ttc_situation_has_record(const ttc_situation *situation, ttc_divisor_role role, uint32_t owner)
{
    if (role == situation->role && owner == situation->owner) return true;
    if (role != TTC_DIVIDES_CLAIM || situation->role != TTC_DIVIDES_CLAIM) return false;
    const ttc_claim *own = situation->model->claims + situation->owner;
    return ttc_array_has(own->modulo, own->modulo_count, owner) || ttc_array_has(own->members, own->member_count, owner)
           || (ttc_claim_speaks_of_family(own->kind) && own->family == owner);
}

/* Fills the member `used`. Returns NULL when memory is out. */
static unsigned char *used_definitions(const ttc_situation *situation)
{
    const ttc_model *model = situation->model;
    unsigned char *used = ttc_model_uses_of_domain(model);
    if (used == NULL) return NULL;
    for (size_t i = 0; i < model->use_count; i++)
        if (ttc_situation_has_record(situation, model->uses[i].role, model->uses[i].owner))
            used[model->uses[i].symbol] = 1;
    ttc_model_close_uses(model, used);
    return used;
}

static bool may_vanish(const ttc_model *model, ttc_id id)
{
    if (ttc_kind_of(model->graph, id) == TTC_SUM) return true;
    if (ttc_kind_of(model->graph, id) != TTC_SYMBOL) return false;
    const ttc_symbol_kind kind = model->symbols[ttc_symbol_of(model->graph, id)].kind;
    return kind == TTC_COSINE || kind == TTC_SINE;
}

/* The last node that the table made; the prover adds others, of symbols that the model does not know. */
static ttc_id last_node(const ttc_model *model)
{
    ttc_id last = TTC_NONE;
    for (size_t i = 0; i < model->symbol_count; i++)
        if (model->symbols[i].node > last) last = model->symbols[i].node;
    for (size_t i = 0; i < model->equation_count; i++)
        if (model->equations[i].sum > last) last = model->equations[i].sum;
    for (size_t i = 0; i < model->claim_count; i++) {
        if (model->claims[i].expression > last) last = model->claims[i].expression;
        if (model->claims[i].other > last) last = model->claims[i].other;
    }
    for (size_t i = 0; i < model->lift.bindings.count; i++)
        if (model->lift.bindings.items[i].expression > last) last = model->lift.bindings.items[i].expression;
    return last;
}

static void list_sums(ttc_random_point *point, const ttc_model *model)
{
    const ttc_id last = last_node(model);
    point->sums = malloc((last + 1) * sizeof *point->sums);
    for (ttc_id id = 1; point->sums != NULL && id <= last; id++)
        if (may_vanish(model, id)) point->sums[point->sum_count++] = id;
}

bool ttc_random_point_init(ttc_random_point *point, const ttc_situation *situation)
{
    size_t count = situation->model->symbol_count;
    *point = (ttc_random_point){ 0 };
    point->numbers = malloc((count + 1) * sizeof *point->numbers);
    point->bound = calloc(count + 1, 1);
    point->used = used_definitions(situation);
    list_sums(point, situation->model);
    if (point->numbers == NULL || point->bound == NULL || point->used == NULL || point->sums == NULL) {
        ttc_random_point_clear(point);
        return false;
    }
    point->symbol_count = count;
    for (size_t i = 0; i < count; i++) fmpq_init(&point->numbers[i]);
    for (size_t k = 0; k < situation->bound_count; k++)
        for (size_t i = 0; i < situation->bound[k]->count; i++) point->bound[situation->bound[k]->items[i].symbol] = 1;
    return true;
}

void ttc_random_point_clear(ttc_random_point *point)
{
    for (size_t i = 0; i < point->symbol_count; i++) fmpq_clear(&point->numbers[i]);
    free(point->numbers);
    free(point->bound);
    free(point->used);
    free(point->sums);
    *point = (ttc_random_point){ 0 };
}

static bool is_quantity(const ttc_symbol_entry *entry)
{
    return entry->kind == TTC_PARAM || entry->kind == TTC_STATE || entry->kind == TTC_LEVEL || entry->kind == TTC_LAMBDA;
}

/* Take the default one time in four: with defaults, the domain of a table is not empty. */
static void draw_parameter(fmpq_t out, const ttc_model *model, const ttc_symbol_entry *entry, ttc_random *random,
                           ttc_sample_range range)
{
    if (entry->value != TTC_NONE && ttc_random_below(random, 4) == 0) {
        fmpq_set(out, ttc_coefficient(model->graph, entry->value));
        return;
    }
    if (entry->sign == TTC_POSITIVE) {
        ttc_sample_positive(out, random, range);
        return;
    }
    do ttc_sample_any(out, random, range);
    while (entry->sign == TTC_NONZERO && fmpq_is_zero(out));
    if (entry->sign == TTC_NONNEGATIVE) fmpq_abs(out, out);
}

static void draw_state(fmpq_t out, const ttc_symbol_entry *entry, ttc_random *random, ttc_sample_range range)
{
    if (entry->low != TTC_NONE && entry->high != TTC_NONE) ttc_sample_unit(out, random, range);
    else if (entry->low != TTC_NONE || entry->high != TTC_NONE) ttc_sample_positive(out, random, range);
    else ttc_sample_any(out, random, range);
}

/* Choose the symbols for which the levels are solved: free ones on which they depend, states three times out of four. Returns false
 * if too few were found. */
static bool choose_pivots(ttc_random_point *point, const ttc_model *model, ttc_random *random)
{
    unsigned char *support = ttc_model_support(model, point->levels, point->level_count);
    size_t chosen = 0;
    if (support == NULL) return false;
    for (unsigned attempt = 0; chosen < point->level_count && attempt < 200; attempt++) {
        bool state = ttc_random_below(random, 4) != 0 || model->param_count == 0;
        uint32_t symbol = state ? model->states[ttc_random_below(random, model->state_count)]
                                : model->params[ttc_random_below(random, model->param_count)];
        if (point->bound[symbol] || !support[symbol]) continue;
        support[symbol] = 0;
        point->pivots[chosen++] = symbol;
    }
    free(support);
    return chosen == point->level_count;
}

/* Draw one symbol in eight, and an earlier symbol for it; if both are of the same kind, with the same sign and interval, copy the
 * number, so that differences vanish as well. */
static void repeat_some(ttc_random_point *point, const ttc_model *model, ttc_random *random)
{
    for (uint32_t i = 0; i < model->symbol_count; i++) {
        const ttc_symbol_entry *entry = &model->symbols[i];
        if (!is_quantity(entry) || i == 0 || ttc_random_below(random, 8) != 0) continue;
        uint32_t j = (uint32_t)ttc_random_below(random, i);
        const ttc_symbol_entry *other = &model->symbols[j];
        if (other->kind == entry->kind && other->sign == entry->sign && other->low == entry->low && other->high == entry->high)
            fmpq_set(&point->numbers[i], &point->numbers[j]);
    }
}

/* A factor of a term that has even powers alone; TTC_NONE: it has others. */
static ttc_id draw_squared(const ttc_graph *graph, ttc_id term, ttc_random *random)
{
    const size_t count = ttc_kind_of(graph, term) == TTC_PRODUCT ? ttc_part_count(graph, term) : 0;
    for (size_t i = 0; i < count; i++)
        if (ttc_part_at(graph, term, i).exponent % 2 != 0) return TTC_NONE;
    return count > 0 ? ttc_part_at(graph, term, ttc_random_below(random, count)).id : TTC_NONE;
}

/* Solve for an expression; for a factor of each term if it is a sum of even powers, whose derivatives vanish where it does. */
static void solve_for(ttc_random_point *point, const ttc_graph *graph, ttc_id id, ttc_random *random)
{
    const size_t terms = ttc_kind_of(graph, id) == TTC_SUM ? ttc_part_count(graph, id) : 0;
    ttc_id squared[TTC_PROBE_SPARE] = { TTC_NONE };
    bool even = terms > 0 && point->level_count + terms <= TTC_PROBE_SPARE && fmpq_is_zero(ttc_coefficient(graph, id));
    for (size_t i = 0; even && i < terms; i++) {
        squared[i] = draw_squared(graph, ttc_part_at(graph, id, i).id, random);
        even = squared[i] != TTC_NONE;
    }
    for (size_t i = 0; even && i < terms; i++) point->levels[point->level_count++] = squared[i];
    if (!even) point->levels[point->level_count++] = id;
}

/* What is to vanish: half of the times what the claim speaks of, else any sum. */
static ttc_id draw_sum(const ttc_random_point *point, const ttc_situation *situation, ttc_random *random)
{
    const ttc_id own = situation->role == TTC_DIVIDES_CLAIM ? situation->model->claims[situation->owner].expression : TTC_NONE;
    if (own != TTC_NONE && may_vanish(situation->model, own) && ttc_random_below(random, 2) == 0) return own;
    return point->sums[ttc_random_below(random, point->sum_count)];
}

/* Of special points, one time in four a sum is solved for together with the levels, and one time in four in place of them. */
static void choose_levels(ttc_random_point *point, const ttc_situation *situation, ttc_random *random, ttc_sample_range range)
{
    const uint64_t choice = range == TTC_SAMPLE_SPECIAL && point->sum_count > 0 ? ttc_random_below(random, 4) : 3;
    point->solves_levels = choice > 0 || situation->level_count == 0;
    point->level_count = point->solves_levels ? situation->level_count : 0;
    for (size_t i = 0; i < point->level_count; i++) point->levels[i] = situation->levels[i];
    if (choice < 2 && point->level_count < TTC_PROBE_SPARE)
        solve_for(point, situation->model->graph, draw_sum(point, situation, random), random);
}

bool ttc_random_point_draw(ttc_random_point *point, const ttc_situation *situation, ttc_random *random, ttc_sample_range range)
{
    const ttc_model *model = situation->model;
    for (uint32_t i = 0; i < model->symbol_count; i++) {
        const ttc_symbol_entry *entry = &model->symbols[i];
        if (!is_quantity(entry)) continue;
        if (entry->kind == TTC_PARAM) draw_parameter(&point->numbers[i], model, entry, random, range);
        else draw_state(&point->numbers[i], entry, random, range);
    }
    repeat_some(point, model, random);
    choose_levels(point, situation, random, range);
    return point->level_count == 0 || choose_pivots(point, model, random);
}

/* jet = low + t (high - low), low + t or high - t. Returns false if an end has no value yet. */
static bool state_in_interval(ttc_probe *probe, arb_ptr jet, const ttc_symbol_entry *entry, const arb_t t)
{
    long precision = ttc_probe_precision(probe);
    size_t width = ttc_probe_width(probe);
    arb_ptr low = _arb_vec_init((long)width);
    bool good = true;
    _arb_vec_zero(jet, (long)width);
    if (entry->low != TTC_NONE) {
        arb_srcptr at = ttc_probe_at(probe, entry->low);
        good = at != NULL;
        if (good) _arb_vec_set(low, at, (long)width);
    }
    if (entry->high != TTC_NONE && good) {
        arb_srcptr at = ttc_probe_at(probe, entry->high);
        good = at != NULL;
        if (good) _arb_vec_set(jet, at, (long)width);
    }
    if (good && entry->low != TTC_NONE && entry->high != TTC_NONE) {
        _arb_vec_sub(jet, jet, low, (long)width, precision);
        _arb_vec_scalar_mul(jet, jet, (long)width, t, precision);
        _arb_vec_add(jet, jet, low, (long)width, precision);
    } else if (good && entry->high != TTC_NONE) {
        arb_sub(jet, jet, t, precision);
    } else if (good) {
        _arb_vec_set(jet, low, (long)width);
        arb_add(jet, jet, t, precision);
    }
    _arb_vec_clear(low, (long)width);
    return good;
}

/* Set a free symbol from the point. Returns false if an end of its interval has no value. */
static bool set_free(ttc_probe *probe, const ttc_random_point *point, const ttc_model *model, uint32_t symbol, arb_ptr jet)
{
    const ttc_symbol_entry *entry = &model->symbols[symbol];
    bool good = true;
    arb_t number;
    arb_init(number);
    arb_set_fmpq(number, &point->numbers[symbol], ttc_probe_precision(probe));
    if (entry->kind == TTC_STATE && (entry->low != TTC_NONE || entry->high != TTC_NONE)) {
        good = state_in_interval(probe, jet, entry, number);
        if (good) ttc_probe_set_jet(probe, symbol, jet);
    } else {
        ttc_probe_set(probe, symbol, number);
    }
    arb_clear(number);
    return good;
}

static bool set_bound(ttc_probe *probe, const ttc_situation *situation, uint32_t symbol, arb_ptr jet)
{
    for (size_t k = 0; k < situation->bound_count; k++)
        for (size_t i = 0; i < situation->bound[k]->count; i++) {
            const ttc_binding *binding = &situation->bound[k]->items[i];
            if (binding->symbol != symbol) continue;
            arb_srcptr value = ttc_probe_at(probe, binding->expression);
            if (value == NULL) return false;
            _arb_vec_set(jet, value, (long)ttc_probe_width(probe));
            ttc_probe_set_jet(probe, symbol, jet);
            return true;
        }
    return false;
}

static void set_pivots(ttc_probe *probe, const ttc_random_point *point, const ttc_situation *situation, arb_srcptr pivots)
{
    for (size_t i = 0; pivots != NULL && i < point->level_count; i++) {
        ttc_probe_set(probe, point->pivots[i], pivots + i);
        ttc_probe_seed(probe, point->pivots[i], situation->model->state_count + i);
    }
}

/* Symbols are set in rounds: bound ones may need free ones, and ends of intervals both. */
bool ttc_random_point_set(ttc_probe *probe, const ttc_random_point *point, const ttc_situation *situation, long precision,
                          arb_srcptr pivots)
{
    const ttc_model *model = situation->model;
    size_t left = SIZE_MAX, before;
    arb_ptr jet = _arb_vec_init((long)ttc_probe_width(probe));
    ttc_probe_begin(probe, precision);
    set_pivots(probe, point, situation, pivots);
    do {
        before = left;
        left = 0;
        for (uint32_t i = 0; i < model->symbol_count; i++) {
            if (!is_quantity(&model->symbols[i]) || ttc_probe_is_set(probe, i)) continue;
            bool set = point->bound[i] ? set_bound(probe, situation, i, jet) : set_free(probe, point, model, i, jet);
            left += !set;
        }
    } while (left > 0 && left < before);
    _arb_vec_clear(jet, (long)ttc_probe_width(probe));
    return left == 0;
}
