#include "ball.h"

#include <flint/fmpq.h>

#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#else
#include <arb.h>
#endif

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FIRST_PRECISION = 256, LAST_PRECISION = 2048, DOUBLE_PRECISION = 53, KEEP_BITS = 100 };

/* In balls of full precision, or in 53-bit balls with roots taken in full or as written. */
typedef enum { FULL, ROUNDED, PLAIN, MODES } evaluation;

typedef enum { UNKNOWN, GOOD, BAD } knowledge;

/* What is known of every node, by id. */
typedef struct {
    size_t size;
    arb_ptr balls;
    unsigned char *state; /* knowledge */
} ball_memory;

typedef struct {
    size_t size;
    fmpq *fractions;
    unsigned char *state;
} exact_memory;

struct ttc_ball {
    const ttc_model *model;
    fmpq *values; /* by symbol, where known */
    unsigned char *known;
    ttc_id *bound; /* by symbol: what it stands for, TTC_NONE for its own definition */
    ball_memory balls[MODES];
    exact_memory exact;
    long precision;
};

ttc_ball *ttc_ball_create(const ttc_model *model)
{
    ttc_ball *ball = calloc(1, sizeof *ball);

    if (ball == NULL) return NULL;
    ball->model = model;
    ball->precision = FIRST_PRECISION;
    ball->values = malloc((model->symbol_count + 1) * sizeof *ball->values);
    ball->known = calloc(model->symbol_count + 1, 1);
    ball->bound = calloc(model->symbol_count + 1, sizeof *ball->bound);
    if (ball->values == NULL || ball->known == NULL || ball->bound == NULL) {
        free(ball->values);
        free(ball->known);
        free(ball->bound);
        free(ball);
        return NULL;
    }
    for (size_t i = 0; i < model->symbol_count; i++) fmpq_init(&ball->values[i]);
    return ball;
}

static void forget_balls(ball_memory *m)
{
    if (m->balls != NULL) _arb_vec_clear(m->balls, (long)m->size);
    free(m->state);
    *m = (ball_memory){ 0 };
}

static void forget_exact(exact_memory *m)
{
    for (size_t i = 0; i < m->size; i++) fmpq_clear(&m->fractions[i]);
    free(m->fractions);
    free(m->state);
    *m = (exact_memory){ 0 };
}

void ttc_ball_destroy(ttc_ball *ball)
{
    if (ball == NULL) return;
    for (int mode = 0; mode < MODES; mode++) forget_balls(&ball->balls[mode]);
    forget_exact(&ball->exact);
    for (size_t i = 0; i < ball->model->symbol_count; i++) fmpq_clear(&ball->values[i]);
    free(ball->values);
    free(ball->known);
    free(ball->bound);
    free(ball);
}

/* Room for every node there is now; what is known stays. */
static bool room(ttc_ball *ball)
{
    const size_t size = ttc_graph_size(ball->model->graph) + 1;

    for (int mode = 0; mode < MODES; mode++) {
        ball_memory *m = &ball->balls[mode];
        if (m->size >= size) continue;
        forget_balls(m);
        m->state = calloc(size, 1);
        if (m->state == NULL) return false;
        m->balls = _arb_vec_init((long)size);
        m->size = size;
    }
    if (ball->exact.size < size) {
        exact_memory *m = &ball->exact;
        forget_exact(m);
        m->state = calloc(size, 1);
        m->fractions = malloc(size * sizeof *m->fractions);
        if (m->state == NULL || m->fractions == NULL) {
            forget_exact(m);
            return false;
        }
        m->size = size;
        for (size_t i = 0; i < size; i++) fmpq_init(&m->fractions[i]);
    }
    return true;
}

static void forget_values(ttc_ball *ball)
{
    for (int mode = 0; mode < MODES; mode++)
        if (ball->balls[mode].state != NULL) memset(ball->balls[mode].state, UNKNOWN, ball->balls[mode].size);
    if (ball->exact.state != NULL) memset(ball->exact.state, UNKNOWN, ball->exact.size);
}

bool ttc_ball_set(ttc_ball *ball, uint32_t symbol, double value)
{
    arf_t exact;

    if (!isfinite(value)) return false;
    arf_init(exact);
    arf_set_d(exact, value);
    arf_get_fmpq(&ball->values[symbol], exact);
    arf_clear(exact);
    ball->known[symbol] = 1;
    forget_values(ball);
    return true;
}

bool ttc_ball_set_fraction(ttc_ball *ball, uint32_t symbol, const char *fraction)
{
    if (fmpq_set_str(&ball->values[symbol], fraction, 10) != 0 || fmpz_is_zero(fmpq_denref(&ball->values[symbol])))
        return false;
    fmpq_canonicalise(&ball->values[symbol]);
    ball->known[symbol] = 1;
    forget_values(ball);
    return true;
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

static bool evaluate_symbol(arb_t out, ttc_ball *ball, evaluation mode, uint32_t symbol, long precision)
{
    const ttc_symbol_entry *entry = &ball->model->symbols[symbol];
    const evaluation inner = mode == ROUNDED && entry->kind == TTC_ROOT ? FULL : mode;
    arb_srcptr of;

    if (ball->known[symbol]) {
        arb_set_fmpq(out, &ball->values[symbol], precision);
        if (mode == PLAIN) add_rounding(out);
        return true;
    }
    if (ball->bound[symbol] != TTC_NONE) {
        if (!evaluate(ball, mode, ball->bound[symbol])) return false;
        arb_set(out, ball->balls[mode].balls + ball->bound[symbol]);
        return true;
    }
    if (entry->definition == TTC_NONE || !evaluate(ball, inner, entry->definition)) return false;
    of = ball->balls[inner].balls + entry->definition;
    switch (entry->kind) {
    case TTC_ROOT:
        arb_sqrt(out, of, inner == FULL ? ball->precision : precision);
        if (mode == ROUNDED) arb_set_round(out, out, precision);
        return true;
    case TTC_COSINE: arb_cos(out, of, precision); return true;
    case TTC_SINE: arb_sin(out, of, precision); return true;
    case TTC_LET: arb_set(out, of); return true;
    default: return false;
    }
}

static bool evaluate_parts(arb_t out, ttc_ball *ball, evaluation mode, ttc_id id, long precision)
{
    const ttc_graph *graph = ball->model->graph;
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
            arb_pow_ui(term, ball->balls[mode].balls + part.id, (unsigned long)labs((long)part.exponent), precision);
            if (part.exponent < 0) arb_div(out, out, term, precision);
            else arb_mul(out, out, term, precision);
        } else if (fmpq_is_one(part.coefficient)) {
            arb_add(out, out, ball->balls[mode].balls + part.id, precision);
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
    const long precision = mode == FULL ? ball->precision : DOUBLE_PRECISION;
    ball_memory *m = &ball->balls[mode];
    const ttc_kind kind = ttc_kind_of(ball->model->graph, id);
    bool good;

    if (m->state[id] != UNKNOWN) return m->state[id] == GOOD;
    m->state[id] = BAD; /* met again on the way down, it would stand for itself */
    if (kind == TTC_NUMBER) {
        arb_set_fmpq(m->balls + id, ttc_coefficient(ball->model->graph, id), precision);
        good = true;
    } else if (kind == TTC_SYMBOL) {
        good = evaluate_symbol(m->balls + id, ball, mode, ttc_symbol_of(ball->model->graph, id), precision);
    } else {
        good = evaluate_parts(m->balls + id, ball, mode, id, precision);
    }
    m->state[id] = good ? GOOD : BAD;
    return good;
}

/* Full precision, raised until the ball is thin or holds zero at the last one. */
static bool evaluate_full(ttc_ball *ball, ttc_id id)
{
    if (!room(ball)) return false;
    for (;;) {
        arb_srcptr value = ball->balls[FULL].balls + id;
        if (!evaluate(ball, FULL, id)) return false;
        if (arb_is_zero(value) || (arb_is_finite(value) && arb_rel_accuracy_bits(value) >= KEEP_BITS)) return true;
        if (ball->precision >= LAST_PRECISION) return arb_is_finite(value);
        ball->precision *= 2;
        memset(ball->balls[FULL].state, UNKNOWN, ball->balls[FULL].size);
    }
}

static double radius_of(ttc_ball *ball, evaluation mode, ttc_id id)
{
    if (!evaluate(ball, mode, id) || !arb_is_finite(ball->balls[mode].balls + id)) return INFINITY;
    return mag_get_d(arb_radref(ball->balls[mode].balls + id));
}

bool ttc_ball_enclose(ttc_enclosure *out, ttc_ball *ball, ttc_id id)
{
    arf_t rest, value;
    arb_srcptr enclosure;
    bool good = id != TTC_NONE && evaluate_full(ball, id);

    if (!good) {
        ball->precision = FIRST_PRECISION;
        return false;
    }
    enclosure = ball->balls[FULL].balls + id;
    arf_init(rest);
    arf_init(value);
    out->value = arf_get_d(arb_midref(enclosure), ARF_RND_NEAR);
    out->rest = 0.0;
    if (isfinite(out->value)) {
        arf_set_d(value, out->value);
        arf_sub(rest, arb_midref(enclosure), value, ARF_PREC_EXACT, ARF_RND_NEAR);
        out->rest = arf_get_d(rest, ARF_RND_NEAR);
    }
    out->radius = mag_get_d(arb_radref(enclosure));
    out->rounding = radius_of(ball, ROUNDED, id);
    out->plain_rounding = radius_of(ball, PLAIN, id);
    arf_clear(value);
    arf_clear(rest);
    if (ball->precision != FIRST_PRECISION) {
        ball->precision = FIRST_PRECISION;
        memset(ball->balls[FULL].state, UNKNOWN, ball->balls[FULL].size);
    }
    return true;
}

char *ttc_ball_text(ttc_ball *ball, ttc_id id, long digits, bool *excludes_zero)
{
    char *written, *text;

    if (id == TTC_NONE || !evaluate_full(ball, id)) return NULL;
    written = arb_get_str(ball->balls[FULL].balls + id, digits, ARB_STR_MORE);
    *excludes_zero = !arb_contains_zero(ball->balls[FULL].balls + id);
    text = written == NULL ? NULL : strdup(written);
    flint_free(written);
    return text;
}

static bool exactly(ttc_ball *ball, ttc_id id);

static bool exact_root(fmpq_t out, const fmpq_t of)
{
    if (fmpq_sgn(of) < 0 || !fmpz_is_square(fmpq_numref(of)) || !fmpz_is_square(fmpq_denref(of))) return false;
    fmpz_sqrt(fmpq_numref(out), fmpq_numref(of));
    fmpz_sqrt(fmpq_denref(out), fmpq_denref(of));
    return true;
}

static bool exact_symbol(fmpq_t out, ttc_ball *ball, uint32_t symbol)
{
    const ttc_symbol_entry *entry = &ball->model->symbols[symbol];

    if (ball->known[symbol]) {
        fmpq_set(out, &ball->values[symbol]);
        return true;
    }
    if (ball->bound[symbol] != TTC_NONE) {
        if (!exactly(ball, ball->bound[symbol])) return false;
        fmpq_set(out, &ball->exact.fractions[ball->bound[symbol]]);
        return true;
    }
    if (entry->definition == TTC_NONE || (entry->kind != TTC_ROOT && entry->kind != TTC_LET)) return false;
    if (!exactly(ball, entry->definition)) return false;
    if (entry->kind == TTC_ROOT) return exact_root(out, &ball->exact.fractions[entry->definition]);
    fmpq_set(out, &ball->exact.fractions[entry->definition]);
    return true;
}

static bool exact_parts(fmpq_t out, ttc_ball *ball, ttc_id id)
{
    const ttc_graph *graph = ball->model->graph;
    const bool product = ttc_kind_of(graph, id) == TTC_PRODUCT;
    const size_t count = ttc_part_count(graph, id);
    fmpq_t term;
    bool good = true;

    fmpq_init(term);
    fmpq_set(out, ttc_coefficient(graph, id));
    for (size_t i = 0; good && i < count; i++) {
        const ttc_part part = ttc_part_at(graph, id, i);
        good = exactly(ball, part.id) &&
               !(product && part.exponent < 0 && fmpq_is_zero(&ball->exact.fractions[part.id]));
        if (!good) break;
        if (product) {
            fmpq_pow_si(term, &ball->exact.fractions[part.id], part.exponent);
            fmpq_mul(out, out, term);
        } else {
            fmpq_mul(term, &ball->exact.fractions[part.id], part.coefficient);
            fmpq_add(out, out, term);
        }
    }
    fmpq_clear(term);
    return good;
}

static bool exactly(ttc_ball *ball, ttc_id id)
{
    const ttc_graph *graph = ball->model->graph;
    const ttc_kind kind = ttc_kind_of(graph, id);
    fmpq *out = &ball->exact.fractions[id];
    bool good;

    if (ball->exact.state[id] != UNKNOWN) return ball->exact.state[id] == GOOD;
    ball->exact.state[id] = BAD;
    if (kind == TTC_NUMBER) {
        fmpq_set(out, ttc_coefficient(graph, id));
        good = true;
    } else if (kind == TTC_SYMBOL) {
        good = exact_symbol(out, ball, ttc_symbol_of(graph, id));
    } else {
        good = exact_parts(out, ball, id);
    }
    ball->exact.state[id] = good ? GOOD : BAD;
    return good;
}

bool ttc_ball_exact_sign(int *sign, ttc_ball *ball, ttc_id id)
{
    if (id == TTC_NONE || !room(ball) || !exactly(ball, id)) return false;
    *sign = fmpq_sgn(&ball->exact.fractions[id]);
    return true;
}

char *ttc_ball_exact_text(ttc_ball *ball, ttc_id id)
{
    char *written, *text;

    if (id == TTC_NONE || !room(ball) || !exactly(ball, id)) return NULL;
    written = fmpq_get_str(NULL, 10, &ball->exact.fractions[id]);
    text = written == NULL ? NULL : strdup(written);
    flint_free(written);
    return text;
}

void ttc_ball_bind(ttc_ball *ball, uint32_t symbol, ttc_id id)
{
    ball->known[symbol] = 0;
    ball->bound[symbol] = id;
    forget_values(ball);
}
