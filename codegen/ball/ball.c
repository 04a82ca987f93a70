#include "ball/ball.h"

#include "ball/ball_exact.h"

#include <flint/fmpq.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FULL_PRECISION = 256, DOUBLE_PRECISION = 53, KEEP_BITS = 100 };

/* In balls of 256, 512, 1024, 2048 bits; in 53-bit balls with radicands in full precision, or as written. */
typedef enum { FULL, FULLEST = FULL + 3, ROUNDED, PLAIN, MODES } evaluation;

typedef enum { UNKNOWN, GOOD, BAD } knowledge;

/* The balls of all nodes, by id, as far as they are known. */
typedef struct {
    size_t size;
    arb_ptr balls;
    unsigned char *state; /* knowledge */
    bool used;            /* a state may not be UNKNOWN */
} ball_memory;

struct ttc_ball {
    ttc_ball_symbols symbols;
    arb_ptr given; /* by symbol: its value, or not finite */
    ball_memory balls[MODES];
    ttc_ball_exact exact;
};

ttc_ball *ttc_ball_create(const ttc_model *model)
{
    ttc_ball *ball = calloc(1, sizeof *ball);
    ttc_ball_symbols *symbols;

    if (ball == NULL) return NULL;
    symbols = &ball->symbols;
    symbols->model = model;
    symbols->values = malloc((model->symbol_count + 1) * sizeof *symbols->values);
    symbols->known = calloc(model->symbol_count + 1, 1);
    symbols->bound = calloc(model->symbol_count + 1, sizeof *symbols->bound);
    if (symbols->values == NULL || symbols->known == NULL || symbols->bound == NULL) {
        free(symbols->values);
        free(symbols->known);
        free(symbols->bound);
        free(ball);
        return NULL;
    }
    for (size_t i = 0; i < model->symbol_count; i++) fmpq_init(&symbols->values[i]);
    ball->given = _arb_vec_init((long)model->symbol_count);
    for (size_t i = 0; i < model->symbol_count; i++) arb_indeterminate(ball->given + i);
    return ball;
}

static void forget_balls(ball_memory *m)
{
    if (m->balls != NULL) _arb_vec_clear(m->balls, (long)m->size);
    free(m->state);
    *m = (ball_memory){ 0 };
}

void ttc_ball_destroy(ttc_ball *ball)
{
    if (ball == NULL) return;
    for (int mode = 0; mode < MODES; mode++) forget_balls(&ball->balls[mode]);
    ttc_ball_exact_clear(&ball->exact);
    _arb_vec_clear(ball->given, (long)ball->symbols.model->symbol_count);
    for (size_t i = 0; i < ball->symbols.model->symbol_count; i++) fmpq_clear(&ball->symbols.values[i]);
    free(ball->symbols.values);
    free(ball->symbols.known);
    free(ball->symbols.bound);
    free(ball);
}

/* Make room for all nodes; if the graph has grown, all is forgotten. */
static bool room(ttc_ball *ball)
{
    const size_t size = ttc_graph_size(ball->symbols.model->graph) + 1;

    for (int mode = 0; mode < MODES; mode++) {
        ball_memory *m = &ball->balls[mode];
        if (m->size >= size) continue;
        forget_balls(m);
        m->state = calloc(size, 1);
        if (m->state == NULL) return false;
        m->balls = _arb_vec_init((long)size);
        m->size = size;
    }
    return true;
}

static void forget_values(ttc_ball *ball)
{
    for (int mode = 0; mode < MODES; mode++)
        if (ball->balls[mode].used) memset(ball->balls[mode].state, UNKNOWN, ball->balls[mode].size);
    for (int mode = 0; mode < MODES; mode++) ball->balls[mode].used = false;
    ttc_ball_exact_forget(&ball->exact);
}

bool ttc_ball_set(ttc_ball *ball, uint32_t symbol, double value)
{
    arf_t exact;

    if (!isfinite(value)) return false;
    arf_init(exact);
    arf_set_d(exact, value);
    arf_get_fmpq(&ball->symbols.values[symbol], exact);
    arf_clear(exact);
    ball->symbols.known[symbol] = 1;
    forget_values(ball);
    return true;
}

bool ttc_ball_set_fraction(ttc_ball *ball, uint32_t symbol, const char *fraction)
{
    fmpq_t value;
    fmpq_init(value);
    const bool good = fmpq_set_str(value, fraction, 10) == 0 && !fmpz_is_zero(fmpq_denref(value));
    if (good) {
        fmpq_canonicalise(value);
        fmpq_set(&ball->symbols.values[symbol], value);
        ball->symbols.known[symbol] = 1;
        forget_values(ball);
    }
    fmpq_clear(value);
    return good;
}

void ttc_ball_set_ball(ttc_ball *ball, uint32_t symbol, const arb_t value)
{
    ball->symbols.known[symbol] = 0;
    ball->symbols.bound[symbol] = TTC_NONE;
    arb_set(ball->given + symbol, value);
    forget_values(ball);
}

static bool evaluate(ttc_ball *ball, evaluation mode, ttc_id id);

static void add_rounding(arb_t ball)
{
    mag_t radius;
    mag_init(radius);
    arb_get_mag(radius, ball);
    mag_mul_2exp_si(radius, radius, -DOUBLE_PRECISION);
    arb_add_error_mag(ball, radius);
    mag_clear(radius);
}

static long precision_of(evaluation mode)
{
    return mode <= FULLEST ? (long)FULL_PRECISION << (mode - FULL) : DOUBLE_PRECISION;
}

static bool evaluate_symbol(arb_t out, ttc_ball *ball, evaluation mode, uint32_t symbol, long precision)
{
    const ttc_symbol_entry *entry = &ball->symbols.model->symbols[symbol];
    const evaluation inner = mode == ROUNDED && entry->kind == TTC_ROOT ? FULL : mode;
    arb_srcptr of;

    if (ball->symbols.known[symbol]) {
        arb_set_fmpq(out, &ball->symbols.values[symbol], precision);
        if (mode == PLAIN) add_rounding(out);
        return true;
    }
    if (ball->symbols.bound[symbol] != TTC_NONE) {
        if (!evaluate(ball, mode, ball->symbols.bound[symbol])) return false;
        arb_set(out, ball->balls[mode].balls + ball->symbols.bound[symbol]);
        return true;
    }
    if (arb_is_finite(ball->given + symbol)) {
        arb_set(out, ball->given + symbol);
        return true;
    }
    if (entry->kind == TTC_PI) {
        arb_const_pi(out, precision);
        return true;
    }
    if (entry->definition == TTC_NONE || !evaluate(ball, inner, entry->definition)) return false;
    of = ball->balls[inner].balls + entry->definition;
    switch (entry->kind) {
    case TTC_ROOT:
        arb_sqrt(out, of, precision_of(inner));
        if (mode == ROUNDED) arb_set_round(out, out, precision);
        return true;
    case TTC_COSINE: arb_cos(out, of, precision); return true;
    case TTC_SINE: arb_sin(out, of, precision); return true;
    case TTC_EXP: arb_exp(out, of, precision); return true;
    case TTC_LOG: arb_log(out, of, precision); return true;
    case TTC_LET: arb_set(out, of); return true;
    default: return false;
    }
}

static bool evaluate_parts(arb_t out, ttc_ball *ball, evaluation mode, ttc_id id, long precision)
{
    const ttc_graph *graph = ball->symbols.model->graph;
    const bool product = ttc_kind_of(graph, id) == TTC_PRODUCT;
    const size_t count = ttc_part_count(graph, id);
    arb_t term;
    bool good = true;

    arb_init(term);
    arb_set_fmpq(out, ttc_coefficient(graph, id), precision);
    for (size_t i = 0; good && i < count; i++) {
        const ttc_part part = ttc_part_at(graph, id, i);
        good = evaluate(ball, mode, part.id);
        if (!good) break;
        if (product) {
            arb_srcptr factor = ball->balls[mode].balls + part.id;
            if (abs(part.exponent) != 1) {
                arb_pow_ui(term, factor, (unsigned long)labs((long)part.exponent), precision);
                factor = term;
            }
            if (part.exponent < 0) arb_div(out, out, factor, precision);
            else if (arb_is_one(out)) arb_set(out, factor);
            else arb_mul(out, out, factor, precision);
        } else if (fmpq_is_one(part.coefficient)) {
            arb_add(out, out, ball->balls[mode].balls + part.id, precision);
        } else if (fmpq_cmp_si(part.coefficient, -1) == 0) {
            arb_sub(out, out, ball->balls[mode].balls + part.id, precision);
        } else {
            arb_set_fmpq(term, part.coefficient, precision);
            arb_mul(term, term, ball->balls[mode].balls + part.id, precision);
            arb_add(out, out, term, precision);
        }
    }
    arb_clear(term);
    return good;
}

static bool evaluate(ttc_ball *ball, evaluation mode, ttc_id id)
{
    const long precision = precision_of(mode);
    ball_memory *m = &ball->balls[mode];
    const ttc_kind kind = ttc_kind_of(ball->symbols.model->graph, id);
    bool good;

    if (m->state[id] != UNKNOWN) return m->state[id] == GOOD;
    m->used = true;
    m->state[id] = BAD; /* for a symbol that is bound to an expression in itself */
    if (kind == TTC_NUMBER) {
        arb_set_fmpq(m->balls + id, ttc_coefficient(ball->symbols.model->graph, id), precision);
        good = true;
    } else if (kind == TTC_SYMBOL) {
        good = evaluate_symbol(m->balls + id, ball, mode, ttc_symbol_of(ball->symbols.model->graph, id), precision);
    } else {
        good = evaluate_parts(m->balls + id, ball, mode, id, precision);
    }
    m->state[id] = good ? GOOD : BAD;
    return good;
}

/* Enclose at full precision, raised until the ball is zero or thin, or to the last one. Returns NULL if none is finite. */
static arb_srcptr evaluate_full(ttc_ball *ball, ttc_id id)
{
    arb_srcptr value = NULL;

    if (id == TTC_NONE || !room(ball)) return NULL;
    for (evaluation mode = FULL; mode <= FULLEST; mode++) {
        value = ball->balls[mode].balls + id;
        if (!evaluate(ball, mode, id)) return NULL;
        if (arb_is_zero(value) || (arb_is_finite(value) && arb_rel_accuracy_bits(value) >= KEEP_BITS)) return value;
    }
    return arb_is_finite(value) ? value : NULL;
}

bool ttc_ball_value(arb_t out, ttc_ball *ball, ttc_id id)
{
    if (id == TTC_NONE || !room(ball) || !evaluate(ball, FULL, id)) return false;
    arb_set(out, ball->balls[FULL].balls + id);
    return arb_is_finite(out);
}

int ttc_ball_sign(ttc_ball *ball, ttc_id id)
{
    arb_srcptr enclosure = evaluate_full(ball, id);

    if (enclosure == NULL) return 0;
    return arb_is_positive(enclosure) ? 1 : arb_is_negative(enclosure) ? -1 : 0;
}

static double radius_of(ttc_ball *ball, evaluation mode, ttc_id id)
{
    if (!evaluate(ball, mode, id) || !arb_is_finite(ball->balls[mode].balls + id)) return INFINITY;
    return mag_get_d(arb_radref(ball->balls[mode].balls + id));
}

/* The double nearest to x, which is subtracted from it. */
static double taken_from(arf_t x)
{
    const double nearest = arf_get_d(x, ARF_RND_NEAR);
    arf_t value;

    arf_init(value);
    arf_set_d(value, nearest);
    if (isfinite(nearest)) arf_sub(x, x, value, ARF_PREC_EXACT, ARF_RND_NEAR);
    else arf_zero(x);
    arf_clear(value);
    return nearest;
}

bool ttc_ball_enclose(ttc_enclosure *out, ttc_ball *ball, ttc_id id)
{
    arf_t rest;
    mag_t radius;
    arb_srcptr enclosure = evaluate_full(ball, id);

    if (enclosure == NULL) return false;
    arf_init(rest);
    mag_init(radius);
    arf_set(rest, arb_midref(enclosure));
    out->value = taken_from(rest);
    out->rest = taken_from(rest);
    arf_get_mag(radius, rest);
    mag_add(radius, radius, arb_radref(enclosure));
    out->radius = mag_get_d(radius);
    mag_clear(radius);
    arf_clear(rest);
    return true;
}

bool ttc_ball_estimate(ttc_enclosure *out, ttc_ball *ball, ttc_id id)
{
    if (!ttc_ball_enclose(out, ball, id)) return false;
    out->rounding = radius_of(ball, ROUNDED, id);
    out->plain_rounding = radius_of(ball, PLAIN, id);
    return true;
}

/* Copy FLINT's text into one for free(), and release it. */
static char *owned(char *written)
{
    char *text = written == NULL ? NULL : strdup(written);

    flint_free(written);
    return text;
}

char *ttc_ball_text(ttc_ball *ball, ttc_id id, long digits, bool *excludes_zero)
{
    arb_srcptr enclosure = evaluate_full(ball, id);

    if (enclosure == NULL) return NULL;
    *excludes_zero = !arb_contains_zero(enclosure);
    return owned(arb_get_str(enclosure, digits, ARB_STR_MORE));
}

bool ttc_ball_exact_sign(int *sign, ttc_ball *ball, ttc_id id)
{
    const fmpq *value = ttc_ball_exact_value(&ball->exact, &ball->symbols, id);

    if (value == NULL) return false;
    *sign = fmpq_sgn(value);
    return true;
}

char *ttc_ball_exact_text(ttc_ball *ball, ttc_id id)
{
    const fmpq *value = ttc_ball_exact_value(&ball->exact, &ball->symbols, id);

    return value == NULL ? NULL : owned(fmpq_get_str(NULL, 10, value));
}

void ttc_ball_bind(ttc_ball *ball, uint32_t symbol, ttc_id id)
{
    ball->symbols.known[symbol] = 0;
    ball->symbols.bound[symbol] = id;
    forget_values(ball);
}
