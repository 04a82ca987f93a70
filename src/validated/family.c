#include "validated/family.h"

#include "validated/over_box.h"

#include <flint/fmpq_vec.h>
#include <stdlib.h>
#include <string.h>

enum { DEPTH_MAX = 30, CORNERS_MAX = 10 }; /* most halvings of a side; most sides of an undecided box whose corners are examined */

typedef struct {
    ttc_id expression;
    ttc_sign sign; /* on the domain */
} condition;

typedef struct {
    const jlt_family_question *q;
    jlt_family_result *result;
    jlt_over_box *over;
    ttc_id trace, formula; /* by differentiation; from the table, or TTC_NONE */
    jlt_range both;        /* intersection of the enclosures of these two */
    condition *conditions;
    size_t condition_count;
    fmpq *low, *high;    /* the current box */
    unsigned char *depth;
    bool seen[2];        /* a point of the domain with trace < 0, > 0 is known: `other`, `point` of the result */
} search;

typedef enum { OUT, NEGATIVE, OPEN, POSITIVE } look;

static void copy(fmpq *out, const fmpq *x, unsigned dim)
{
    for (unsigned i = 0; i < dim; i++) fmpq_set(&out[i], &x[i]);
}

void jlt_family_result_init(jlt_family_result *self, const jlt_family_question *question)
{
    *self = (jlt_family_result){ .dim = question->dim, .valid_count = (unsigned)question->model->validity_count };
    self->point = _fmpq_vec_init(self->dim + 1);
    self->other = _fmpq_vec_init(self->dim + 1);
    jlt_range_init(&self->trace);
    self->least = flint_malloc((self->valid_count + 1) * sizeof *self->least);
    for (unsigned i = 0; i < self->valid_count; i++) arf_init(self->least + i);
}

void jlt_family_result_clear(jlt_family_result *self)
{
    _fmpq_vec_clear(self->point, self->dim + 1);
    _fmpq_vec_clear(self->other, self->dim + 1);
    jlt_range_clear(&self->trace);
    for (unsigned i = 0; i < self->valid_count; i++) arf_clear(self->least + i);
    flint_free(self->least);
}

/* ---- the table's domain ---- */

static void require(search *s, ttc_id expression, ttc_sign sign)
{
    if (sign != TTC_ANY_SIGN) s->conditions[s->condition_count++] = (condition){ expression, sign };
}

/* Collect the conditions of the domain: signs of parameters, intervals of states, records `domain`, radicands of roots and
 * arguments of logarithms are positive, and no divisor of the field, of these, or of the family is zero. */
static jlt_status gather_conditions(search *s)
{
    const ttc_model *m = s->q->model;
    unsigned char *used = ttc_model_uses(m);

    s->conditions = calloc(m->param_count + 2 * m->state_count + m->region_count + m->symbol_count + m->divisor_count + 1,
                           sizeof *s->conditions);
    if (used == NULL || s->conditions == NULL) {
        free(used);
        return JLT_ERR_NOMEM;
    }
    for (size_t i = 0; i < m->param_count; i++) require(s, m->symbols[m->params[i]].node, m->symbols[m->params[i]].sign);
    for (size_t i = 0; i < m->state_count; i++) {
        const ttc_symbol_entry *x = &m->symbols[m->states[i]];
        if (x->low != TTC_NONE) require(s, ttc_subtract(m->graph, x->node, x->low), TTC_POSITIVE);
        if (x->high != TTC_NONE) require(s, ttc_subtract(m->graph, x->high, x->node), TTC_POSITIVE);
    }
    for (size_t i = 0; i < m->region_count; i++) require(s, m->regions[i].expression, TTC_POSITIVE);
    for (size_t i = 0; i < m->symbol_count; i++) {
        if (m->symbols[i].kind != TTC_ROOT && m->symbols[i].kind != TTC_LOG) continue;
        require(s, m->symbols[i].definition, TTC_POSITIVE);
        used[i] = 1;
    }
    ttc_model_close_uses(m, used);
    for (size_t i = 0; i < m->divisor_count; i++) {
        const ttc_divisor *d = &m->divisors[i];
        if (d->role == TTC_DIVIDES_FIELD || (d->role == TTC_DIVIDES_SYMBOL && used[d->owner])
            || (d->role == TTC_DIVIDES_CLAIM && &m->claims[d->owner] == s->q->family))
            require(s, d->divisor, TTC_NONZERO);
    }
    free(used);
    return JLT_OK;
}

static bool holds(const jlt_range *value, ttc_sign sign)
{
    if (value == NULL) return false;
    if (sign == TTC_NONNEGATIVE) return arf_sgn(value->low) >= 0;
    return sign == TTC_NONZERO ? jlt_range_sign(value) != 0 : jlt_range_sign(value) > 0;
}

static bool fails(const jlt_range *value, ttc_sign sign)
{
    if (value == NULL) return false;
    if (sign == TTC_NONNEGATIVE) return jlt_range_sign(value) < 0;
    return sign == TTC_NONZERO ? jlt_range_is_zero(value) : arf_sgn(value->high) <= 0;
}

/* ---- what is known of a box ---- */

static void set_box(search *s, const fmpq *low, const fmpq *high)
{
    for (unsigned i = 0; i < s->q->dim; i++) jlt_over_box_set(s->over, s->q->symbols[i], &low[i], &high[i]);
}

/* Returns NULL if the trace may be undefined. */
static const jlt_range *enclose_trace(search *s)
{
    const jlt_range *trace = jlt_over_box_enclose(s->over, s->trace), *formula = jlt_over_box_enclose(s->over, s->formula);
    jlt_range *both = &s->both;

    if (trace == NULL || formula == NULL) return trace != NULL ? trace : formula;
    arf_max(both->low, trace->low, formula->low);
    arf_min(both->high, trace->high, formula->high);
    return arf_cmp(both->low, both->high) <= 0 ? both : NULL;
}

static look sign_of(const jlt_range *trace)
{
    const int sign = trace == NULL ? 0 : jlt_range_sign(trace);

    return sign < 0 ? NEGATIVE : sign > 0 ? POSITIVE : OPEN;
}

static look look_at_box(search *s)
{
    set_box(s, s->low, s->high);
    for (size_t i = 0; i < s->condition_count; i++)
        if (fails(jlt_over_box_enclose(s->over, s->conditions[i].expression), s->conditions[i].sign)) return OUT;
    return sign_of(enclose_trace(s));
}

/* JLT_FAMILY_ZERO or JLT_FAMILY_CHANGES if the point is certainly in the domain and refutes the claim; else PROVED. */
static jlt_family_verdict look_at_point(search *s, const fmpq *x)
{
    const jlt_range *trace;
    look found;

    set_box(s, x, x);
    for (size_t i = 0; i < s->condition_count; i++)
        if (!holds(jlt_over_box_enclose(s->over, s->conditions[i].expression), s->conditions[i].sign)) return JLT_FAMILY_PROVED;
    trace = enclose_trace(s);
    found = sign_of(trace);
    if (found != OPEN) {
        const bool is_positive = found == POSITIVE;
        if (!s->seen[is_positive]) copy(is_positive ? s->result->point : s->result->other, x, s->q->dim);
        s->seen[is_positive] = true;
    } else if (trace != NULL && jlt_range_is_zero(trace)) {
        copy(s->result->point, x, s->q->dim);
        return JLT_FAMILY_ZERO;
    }
    return s->seen[0] && s->seen[1] ? JLT_FAMILY_CHANGES : JLT_FAMILY_PROVED;
}

/* Include a box on which the trace has a sign in the result. */
static void record(search *s)
{
    const ttc_model *m = s->q->model;
    const jlt_range *trace = enclose_trace(s);
    jlt_range *all = &s->result->trace;
    const bool first = arf_is_zero(all->low) && arf_is_zero(all->high);

    if (first || arf_cmp(trace->low, all->low) < 0) arf_set(all->low, trace->low);
    if (first || arf_cmp(trace->high, all->high) > 0) arf_set(all->high, trace->high);
    for (unsigned i = 0; i < s->result->valid_count; i++) {
        const jlt_range *value = jlt_over_box_enclose(s->over, m->validities[i].expression);
        arf_struct *least = s->result->least + i;
        if (value == NULL) arf_nan(least);
        else if (first || arf_cmp(value->low, least) < 0) arf_set(least, value->low);
    }
}

/* ---- the search ---- */

static void middle_of(fmpq *out, const fmpq *low, const fmpq *high, unsigned dim)
{
    for (unsigned i = 0; i < dim; i++) {
        fmpq_add(&out[i], &low[i], &high[i]);
        fmpq_div_2exp(&out[i], &out[i], 1);
    }
}

/* The change of the trace along side i, with the other sides at their midpoints; infinity if it may be undefined. */
static void change_along(arf_t out, search *s, const fmpq *middle, unsigned i)
{
    const jlt_range *trace;

    set_box(s, middle, middle);
    jlt_over_box_set(s->over, s->q->symbols[i], &s->low[i], &s->high[i]);
    trace = enclose_trace(s);
    if (trace == NULL) arf_pos_inf(out);
    else arf_sub(out, trace->high, trace->low, s->q->bits, ARF_RND_DOWN);
}

/* The side to cut; dim if none may be cut any more. */
static unsigned choose(search *s, const fmpq *middle)
{
    unsigned best = s->q->dim;
    JLT_SCOPED(arf, change, most);

    for (unsigned i = 0; i < s->q->dim; i++) {
        if (fmpq_equal(&s->low[i], &s->high[i]) || s->depth[i] == DEPTH_MAX) continue;
        change_along(change, s, middle, i);
        const int order = best == s->q->dim ? 1 : arf_cmp(change, most);
        if (order < 0 || (order == 0 && s->depth[i] >= s->depth[best])) continue;
        best = i;
        arf_set(most, change);
    }
    return best;
}

/* For a box that cannot be cut further: refute the claim at one of its corners, else return JLT_FAMILY_LEFT. */
static jlt_family_verdict look_at_corners(search *s, fmpq *x)
{
    jlt_family_verdict verdict = JLT_FAMILY_PROVED;
    unsigned wide = 0;

    for (unsigned i = 0; i < s->q->dim; i++) wide += !fmpq_equal(&s->low[i], &s->high[i]);
    for (unsigned corner = 0; verdict == JLT_FAMILY_PROVED && wide <= CORNERS_MAX && corner >> wide == 0; corner++) {
        for (unsigned i = 0, k = 0; i < s->q->dim; i++) {
            const bool is_wide = !fmpq_equal(&s->low[i], &s->high[i]);
            fmpq_set(&x[i], is_wide && (corner >> k & 1) != 0 ? &s->high[i] : &s->low[i]);
            k += is_wide;
        }
        verdict = look_at_point(s, x);
    }
    if (verdict != JLT_FAMILY_PROVED) return verdict;
    copy(s->result->point, s->low, s->q->dim);
    copy(s->result->other, s->high, s->q->dim);
    return JLT_FAMILY_LEFT;
}

static jlt_family_verdict explore(search *s);

static jlt_family_verdict halve(search *s, unsigned side, const fmpq_t middle)
{
    jlt_family_verdict verdict;
    JLT_SCOPED(fmpq, end);

    fmpq_set(end, &s->high[side]);
    fmpq_set(&s->high[side], middle);
    s->depth[side]++;
    verdict = explore(s);
    fmpq_set(&s->high[side], end);
    if (verdict == JLT_FAMILY_PROVED) {
        fmpq_set(end, &s->low[side]);
        fmpq_set(&s->low[side], middle);
        verdict = explore(s);
        fmpq_set(&s->low[side], end);
    }
    s->depth[side]--;
    return verdict;
}

static jlt_family_verdict explore(search *s)
{
    const unsigned dim = s->q->dim;
    fmpq *middle = _fmpq_vec_init(dim + 1);
    const jlt_range *all = &s->result->trace;
    jlt_family_verdict verdict = JLT_FAMILY_PROVED;
    look box = look_at_box(s);

    s->result->boxes++;
    if (box == OUT) goto done;
    if ((box == NEGATIVE && jlt_range_sign(all) > 0) || (box == POSITIVE && jlt_range_sign(all) < 0))
        box = OPEN; /* part of the box may be outside the domain */
    if (box != OPEN) record(s);
    middle_of(middle, s->low, s->high, dim);
    if (box == OPEN || !s->seen[box == POSITIVE]) verdict = look_at_point(s, middle);
    if (verdict != JLT_FAMILY_PROVED || box != OPEN) goto done;
    const unsigned side = s->result->boxes < s->q->limit ? choose(s, middle) : dim;
    verdict = side < dim ? halve(s, side, &middle[side]) : look_at_corners(s, middle);
done:
    _fmpq_vec_clear(middle, dim + 1);
    return verdict;
}

/* ---- the trace on the family ---- */

typedef struct {
    const ttc_model *model;
    const ttc_bindings *bindings;
} substitution;

static ttc_id definition_of(void *context, uint32_t symbol)
{
    const ttc_symbol_entry *entry = &((const substitution *)context)->model->symbols[symbol];

    return entry->kind == TTC_LET ? entry->definition : TTC_NONE;
}

static ttc_id value_of(void *context, uint32_t symbol, ttc_id definition)
{
    const substitution *s = context;
    const ttc_symbol_entry *entry = &s->model->symbols[symbol];

    for (size_t i = 0; i < s->bindings->count; i++)
        if (s->bindings->items[i].symbol == symbol) return s->bindings->items[i].expression;
    return definition == TTC_NONE || definition == entry->definition ? entry->node : definition;
}

static ttc_id put(const ttc_model *model, const ttc_bindings *bindings, ttc_id id)
{
    substitution s = { model, bindings };
    const ttc_id out = ttc_substitute_through(model->graph, id, definition_of, value_of, &s);

    if (out == TTC_NONE) ttc_graph_clear_error(model->graph);
    return out;
}

/* Substitute the family's states and parameters in the expression, and in the `let`s that they change, so that terms cancel: states
 * first, so that parameters are then substituted in their expressions too. Returns TTC_NONE if this divides by zero. */
static ttc_id on_family(const ttc_model *model, const ttc_claim *family, ttc_id id)
{
    return put(model, &family->when, put(model, &family->bindings, id));
}

static jlt_status begin(search *s)
{
    const ttc_model *m = s->q->model;
    const ttc_claim *family = s->q->family;
    ttc_id trace;

    jlt_range_init(&s->both);
    s->low = _fmpq_vec_init(s->q->dim + 1);
    s->high = _fmpq_vec_init(s->q->dim + 1);
    copy(s->low, s->q->low, s->q->dim);
    copy(s->high, s->q->high, s->q->dim);
    s->depth = calloc(s->q->dim + 1, 1);
    if (s->depth == NULL) return JLT_ERR_NOMEM;
    trace = ttc_integer(m->graph, 0);
    for (size_t i = 0; i < m->state_count; i++)
        trace = ttc_add(m->graph, trace, ttc_model_partial(m, ttc_model_field(m, i), m->states[i]));
    if (trace == TTC_NONE) return JLT_ERR_NOMEM;
    s->trace = on_family(m, family, trace);
    if (s->trace == TTC_NONE) s->trace = trace;
    if (s->q->trace != NULL) s->formula = on_family(m, family, s->q->trace->expression);
    JLT_PASS(gather_conditions(s));
    JLT_PASS(jlt_over_box_create(&s->over, m, s->q->bits));
    for (size_t i = 0; i < family->when.count; i++)
        jlt_over_box_bind(s->over, family->when.items[i].symbol, family->when.items[i].expression);
    for (size_t i = 0; i < family->bindings.count; i++)
        jlt_over_box_bind(s->over, family->bindings.items[i].symbol, family->bindings.items[i].expression);
    return JLT_OK;
}

jlt_status jlt_family_prove(jlt_family_result *result, const jlt_family_question *question)
{
    search s = { .q = question, .result = result };
    jlt_status st = begin(&s);

    if (st == JLT_OK) {
        result->verdict = explore(&s);
        if (result->verdict == JLT_FAMILY_PROVED && !s.seen[0] && !s.seen[1]) result->verdict = JLT_FAMILY_OUTSIDE;
        if (result->verdict == JLT_FAMILY_PROVED && s.seen[0]) copy(result->point, result->other, question->dim);
    }
    jlt_over_box_destroy(s.over);
    jlt_range_clear(&s.both);
    free(s.conditions);
    free(s.depth);
    _fmpq_vec_clear(s.low, question->dim + 1);
    _fmpq_vec_clear(s.high, question->dim + 1);
    return st;
}
