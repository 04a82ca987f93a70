#include "spectrum/exact_point.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The most bits of a number here; larger ones are left to ball arithmetic. */
enum { HEIGHT_MAX = 16384 };

typedef enum { UNKNOWN, GOOD, BAD } knowledge;

typedef struct {
    const ttc_model *model;
    jlt_surd_field *field;
    const jlt_ball_value **values; /* by symbol; NULL where it has no value */
    ttc_id *bound;                 /* by symbol: the expression that the family gives for it, or TTC_NONE */
    jlt_surd *numbers;             /* by node, like `state`; initialized where that is not UNKNOWN */
    unsigned char *state;
    jlt_surd *inverses;            /* by node, of numbers that are not zero; initialized where `inverted` */
    unsigned char *inverted;
    size_t size;
} walk;

static bool evaluate(walk *w, ttc_id id);

static bool take_value(jlt_surd *out, const jlt_ball_value *value)
{
    bool good = value->fraction == NULL ? isfinite(value->value) : true;
    JLT_SCOPED(fmpq, exact);
    JLT_SCOPED(arf, dyadic);

    if (value->fraction != NULL) {
        good = fmpq_set_str(exact, value->fraction, 10) == 0 && !fmpz_is_zero(fmpq_denref(exact));
        if (good) fmpq_canonicalise(exact);
    } else if (good) {
        arf_set_d(dyadic, value->value);
        arf_get_fmpq(exact, dyadic);
    }
    if (good) jlt_surd_set_rational(out, exact);
    return good;
}

/* A function's value at an argument where it is known to be rational: log at 1, the others at 0. Returns false elsewhere. */
static bool function_of(jlt_surd *out, const jlt_surd *of, ttc_symbol_kind kind)
{
    const bool one = of->roots == 0 && fmpq_is_one(of->coordinates), zero = jlt_surd_is_zero(of);

    if (kind == TTC_LOG ? !one : !zero) return false;
    JLT_SCOPED(fmpq, value);
    if (kind == TTC_COSINE || kind == TTC_EXP) fmpq_one(value);
    jlt_surd_set_rational(out, value);
    return true;
}

static bool evaluate_symbol(jlt_surd *out, walk *w, uint32_t symbol)
{
    const ttc_symbol_entry *entry = &w->model->symbols[symbol];
    const ttc_id meaning = w->bound[symbol] != TTC_NONE ? w->bound[symbol] : entry->definition;

    if (w->bound[symbol] == TTC_NONE && w->values[symbol] != NULL) return take_value(out, w->values[symbol]);
    if (meaning == TTC_NONE || entry->kind == TTC_PI || !evaluate(w, meaning)) return false;
    if (entry->kind == TTC_ROOT) return jlt_surd_root(out, &w->numbers[meaning], w->field);
    if (ttc_symbol_is_function(entry->kind)) return function_of(out, &w->numbers[meaning], entry->kind);
    jlt_surd_set(out, &w->numbers[meaning]);
    return true;
}

/* 1/numbers[id]; that number is not zero. */
static const jlt_surd *inverse_of(walk *w, ttc_id id)
{
    if (!w->inverted[id]) {
        jlt_surd_init(&w->inverses[id]);
        w->inverted[id] = jlt_surd_invert(&w->inverses[id], &w->numbers[id], w->field);
    }
    return &w->inverses[id];
}

static bool evaluate_sum(jlt_surd *out, walk *w, ttc_id id)
{
    const ttc_graph *graph = w->model->graph;
    JLT_SCOPED(jlt_surd, factor);

    jlt_surd_set_rational(out, ttc_coefficient(graph, id));
    for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
        const ttc_part part = ttc_part_at(graph, id, i);
        if (!evaluate(w, part.id)) return false;
        if (fmpq_is_one(part.coefficient)) {
            jlt_surd_add(out, out, &w->numbers[part.id]);
        } else {
            jlt_surd_set_rational(factor, part.coefficient);
            jlt_surd_multiply(factor, factor, &w->numbers[part.id], w->field);
            jlt_surd_add(out, out, factor);
        }
    }
    return true;
}

/* Evaluate the factors of a product. Returns false if one has no value, or is to be divided by and zero; *zero becomes true if one
 * that is not divided by is zero. */
static bool evaluate_factors(bool *zero, walk *w, ttc_id id)
{
    for (size_t i = 0; i < ttc_part_count(w->model->graph, id); i++) {
        const ttc_part part = ttc_part_at(w->model->graph, id, i);
        if (!evaluate(w, part.id)) return false;
        if (!jlt_surd_is_zero(&w->numbers[part.id])) continue;
        if (part.exponent < 0) return false;
        *zero = true;
    }
    return true;
}

/* Multiply a fraction, which need not be in lowest terms, by a power of a rational number. */
static void multiply_power(fmpq_t out, const fmpq_t number, int32_t exponent)
{
    JLT_SCOPED(fmpq, power);

    fmpz_pow_ui(fmpq_numref(power), fmpq_numref(number), (ulong)abs(exponent));
    fmpz_pow_ui(fmpq_denref(power), fmpq_denref(number), (ulong)abs(exponent));
    if (exponent < 0) fmpz_swap(fmpq_numref(power), fmpq_denref(power));
    fmpz_mul(fmpq_numref(out), fmpq_numref(out), fmpq_numref(power));
    fmpz_mul(fmpq_denref(out), fmpq_denref(out), fmpq_denref(power));
}

static bool evaluate_product(jlt_surd *out, walk *w, ttc_id id)
{
    const ttc_graph *graph = w->model->graph;
    const size_t count = ttc_part_count(graph, id);
    bool zero = false;
    JLT_SCOPED(fmpq, rational);

    if (!evaluate_factors(&zero, w, id)) return false;
    if (zero) return true;
    fmpq_set(rational, ttc_coefficient(graph, id));
    for (size_t i = 0; i < count; i++) {
        const ttc_part part = ttc_part_at(graph, id, i);
        if (w->numbers[part.id].roots == 0) multiply_power(rational, w->numbers[part.id].coordinates, part.exponent);
    }
    fmpq_canonicalise(rational);
    jlt_surd_set_rational(out, rational);
    for (size_t i = 0; i < count; i++) {
        const ttc_part part = ttc_part_at(graph, id, i);
        if (w->numbers[part.id].roots == 0) continue;
        const jlt_surd *number = part.exponent < 0 ? inverse_of(w, part.id) : &w->numbers[part.id];
        for (int32_t k = abs(part.exponent); k > 0; k--) jlt_surd_multiply(out, out, number, w->field);
    }
    return true;
}

static bool evaluate(walk *w, ttc_id id)
{
    const ttc_graph *graph = w->model->graph;
    jlt_surd *out = &w->numbers[id];
    bool good = true;

    if (w->state[id] != UNKNOWN) return w->state[id] == GOOD;
    jlt_surd_init(out);
    w->state[id] = BAD; /* a definition that contains itself has no value */
    switch (ttc_kind_of(graph, id)) {
    case TTC_NUMBER: jlt_surd_set_rational(out, ttc_coefficient(graph, id)); break;
    case TTC_SYMBOL: good = evaluate_symbol(out, w, ttc_symbol_of(graph, id)); break;
    case TTC_PRODUCT: good = evaluate_product(out, w, id) && jlt_surd_height(out) <= HEIGHT_MAX; break;
    default: good = evaluate_sum(out, w, id) && jlt_surd_height(out) <= HEIGHT_MAX;
    }
    w->state[id] = good ? GOOD : BAD;
    return good;
}

static void end(walk *w)
{
    for (size_t i = 0; w->numbers != NULL && w->state != NULL && i < w->size; i++)
        if (w->state[i] != UNKNOWN) jlt_surd_clear(&w->numbers[i]);
    for (size_t i = 0; w->inverses != NULL && w->inverted != NULL && i < w->size; i++)
        if (w->inverted[i]) jlt_surd_clear(&w->inverses[i]);
    free(w->inverses);
    free(w->inverted);
    free(w->numbers);
    free(w->state);
    free(w->bound);
    free(w->values);
}

static bool begin(walk *w, const jlt_oracle *oracle, jlt_surd_field *field)
{
    const ttc_model *model = oracle->model;

    *w = (walk){ .model = model, .field = field, .size = ttc_graph_size(model->graph) + 1 };
    w->values = calloc(model->symbol_count + 1, sizeof *w->values);
    w->bound = calloc(model->symbol_count + 1, sizeof *w->bound);
    w->state = calloc(w->size, 1);
    w->numbers = malloc(w->size * sizeof *w->numbers);
    w->inverted = calloc(w->size, 1);
    w->inverses = malloc(w->size * sizeof *w->inverses);
    return w->values != NULL && w->bound != NULL && w->state != NULL && w->numbers != NULL && w->inverted != NULL &&
           w->inverses != NULL;
}

static void bind(walk *w, const jlt_oracle *oracle, const char *family, const unsigned char *given)
{
    const ttc_model *model = oracle->model;

    for (size_t k = 0; family != NULL && k < model->claim_count; k++) {
        const ttc_claim *claim = &model->claims[k];
        if (claim->kind != TTC_CLAIM_EQUILIBRIA || strcmp(claim->name, family) != 0) continue;
        for (size_t b = 0; b < claim->bindings.count; b++)
            for (size_t i = 0; i < model->state_count; i++)
                if (oracle->states[i] == claim->bindings.items[b].symbol && !given[i])
                    w->bound[oracle->states[i]] = claim->bindings.items[b].expression;
    }
}

/* Evaluate field, point and Jacobian. Returns false if one cannot be evaluated, or the field does not vanish. */
static bool fill(jlt_exact_matrix *m, walk *w, const jlt_oracle *oracle)
{
    const size_t n = m->n;

    for (size_t i = 0; i < n; i++)
        if (!evaluate(w, oracle->field[i]) || !jlt_surd_is_zero(&w->numbers[oracle->field[i]])) return false;
    for (size_t i = 0; i < n; i++) {
        const ttc_id state = oracle->model->symbols[oracle->states[i]].node;
        if (!evaluate(w, state)) return false;
        jlt_surd_set(&m->point[i], &w->numbers[state]);
    }
    for (size_t i = 0; i < n * n; i++) {
        if (!evaluate(w, oracle->jacobian[i])) return false;
        jlt_surd_set(&m->entries[i], &w->numbers[oracle->jacobian[i]]);
    }
    return true;
}

jlt_status jlt_exact_point_linearize(jlt_exact_matrix **matrix, const jlt_oracle *oracle, const jlt_ball_value *params,
                                     const jlt_ball_value *x, const char *family, const unsigned char *given)
{
    const size_t n = oracle->model->state_count;
    JLT_OWNED(jlt_exact_matrix) *m = jlt_exact_matrix_create(n);
    JLT_CLEARED(end) walk w = { .size = 0 };

    *matrix = NULL;
    if (m == NULL || !begin(&w, oracle, m->field)) return JLT_ERR_NOMEM;
    for (size_t i = 0; i < oracle->descriptor->param_count; i++) w.values[oracle->params[i]] = &params[i];
    for (size_t i = 0; i < n; i++) w.values[oracle->states[i]] = &x[i];
    bind(&w, oracle, family, given);
    if (!fill(m, &w, oracle)) return JLT_OK;
    jlt_exact_matrix_analyse(m);
    *matrix = m;
    m = NULL; /* ownership moved to the caller */
    return JLT_OK;
}
