#include "challenge/series.h"

#include <stdlib.h>

#if __has_include(<flint/arb_poly.h>)
#include <flint/arb_poly.h>
#else
#include <arb_poly.h>
#endif

typedef struct {
    const ttc_model *model;
    ttc_probe *probe;
    size_t size;
    unsigned char *needed;  /* by node */
    arb_poly_struct *nodes; /* by node: its series */
    arb_poly_struct *given; /* by symbol: the series of states, and of what the probe has set */
    long precision;
} orbit;

/* Mark the nodes that marked ones need; parts, and definitions of symbols, have smaller numbers. */
static void mark_needed(orbit *o)
{
    const ttc_graph *graph = o->model->graph;
    for (size_t i = o->size; i > 0; i--) {
        if (!o->needed[i]) continue;
        for (size_t k = 0; k < ttc_part_count(graph, (ttc_id)i); k++) o->needed[ttc_part_at(graph, (ttc_id)i, k).id] = 1;
        if (ttc_kind_of(graph, (ttc_id)i) != TTC_SYMBOL) continue;
        const uint32_t symbol = ttc_symbol_of(graph, (ttc_id)i);
        const ttc_id definition = o->model->symbols[symbol].definition;
        if (!ttc_probe_is_set(o->probe, symbol) && definition != TTC_NONE) o->needed[definition] = 1;
    }
}

static bool symbol_series(orbit *o, arb_poly_t out, uint32_t symbol, long length)
{
    const ttc_symbol_entry *entry = &o->model->symbols[symbol];
    if (ttc_probe_is_set(o->probe, symbol)) {
        arb_poly_set(out, &o->given[symbol]);
        return true;
    }
    if (entry->kind == TTC_PI) {
        arb_poly_fit_length(out, 1);
        arb_const_pi(out->coeffs, o->precision);
        _arb_poly_set_length(out, 1);
        return true;
    }
    if (entry->definition == TTC_NONE) return false;
    const arb_poly_struct *of = &o->nodes[entry->definition];
    switch (entry->kind) {
    case TTC_ROOT: arb_poly_sqrt_series(out, of, length, o->precision); break;
    case TTC_COSINE: arb_poly_cos_series(out, of, length, o->precision); break;
    case TTC_SINE: arb_poly_sin_series(out, of, length, o->precision); break;
    case TTC_EXP: arb_poly_exp_series(out, of, length, o->precision); break;
    case TTC_LOG: arb_poly_log_series(out, of, length, o->precision); break;
    default: arb_poly_set(out, of);
    }
    return true;
}

static void multiply_power(orbit *o, arb_poly_t product, const arb_poly_t base, long exponent, long length)
{
    arb_poly_t factor;
    arb_poly_init(factor);
    arb_poly_pow_ui_trunc_binexp(factor, base, (ulong)labs(exponent), length, o->precision);
    if (exponent < 0) arb_poly_div_series(product, product, factor, length, o->precision);
    else arb_poly_mullow(product, product, factor, length, o->precision);
    arb_poly_clear(factor);
}

static bool node_series(orbit *o, ttc_id id, long length)
{
    const ttc_graph *graph = o->model->graph;
    arb_poly_struct *out = &o->nodes[id];
    arb_poly_t term;
    arb_t coefficient;
    if (ttc_kind_of(graph, id) == TTC_SYMBOL) return symbol_series(o, out, ttc_symbol_of(graph, id), length);
    arb_init(coefficient);
    arb_poly_init(term);
    arb_set_fmpq(coefficient, ttc_coefficient(graph, id), o->precision);
    arb_poly_set_arb(out, coefficient);
    for (size_t k = 0; k < ttc_part_count(graph, id); k++) {
        const ttc_part part = ttc_part_at(graph, id, k);
        if (ttc_kind_of(graph, id) == TTC_PRODUCT) {
            multiply_power(o, out, &o->nodes[part.id], part.exponent, length);
        } else {
            arb_set_fmpq(coefficient, part.coefficient, o->precision);
            arb_poly_scalar_mul(term, &o->nodes[part.id], coefficient, o->precision);
            arb_poly_add(out, out, term, o->precision);
        }
    }
    arb_poly_clear(term);
    arb_clear(coefficient);
    return true;
}

/* The series of all nodes that are needed, up to t^(length - 1). */
static bool evaluate(orbit *o, long length)
{
    for (size_t i = 1; i <= o->size; i++)
        if (o->needed[i] && !node_series(o, (ttc_id)i, length)) return false;
    return true;
}

/* x' = f(x): the coefficient of t^(k + 1) of a state is that of t^k of its rate, over k + 1. */
static bool follow(orbit *o, long order)
{
    arb_t coefficient;
    bool good = true;
    arb_init(coefficient);
    for (long k = 0; good && k < order; k++) {
        good = evaluate(o, k + 1);
        for (size_t i = 0; good && i < o->model->state_count; i++) {
            arb_poly_get_coeff_arb(coefficient, &o->nodes[ttc_model_field(o->model, i)], k);
            arb_div_si(coefficient, coefficient, k + 1, o->precision);
            good = arb_is_finite(coefficient);
            arb_poly_set_coeff_arb(&o->given[o->model->states[i]], k + 1, coefficient);
        }
    }
    arb_clear(coefficient);
    return good && evaluate(o, order + 1);
}

bool ttc_series_along(ttc_probe *probe, const ttc_model *model, ttc_id id, long order, arb_ptr out)
{
    orbit o = { .model = model, .probe = probe, .size = ttc_graph_size(model->graph), .precision = ttc_probe_precision(probe) };
    o.needed = calloc(o.size + 1, 1);
    o.nodes = calloc(o.size + 1, sizeof *o.nodes); /* zeroed ones are initialized */
    o.given = calloc(model->symbol_count + 1, sizeof *o.given);
    bool good = o.needed != NULL && o.nodes != NULL && o.given != NULL;
    for (uint32_t i = 0; good && i < model->symbol_count; i++)
        if (ttc_probe_is_set(probe, i)) arb_poly_set_arb(&o.given[i], ttc_probe_value(probe, i));
    if (good) {
        o.needed[id] = 1;
        for (size_t i = 0; i < model->state_count; i++) o.needed[ttc_model_field(model, i)] = 1;
        mark_needed(&o);
        good = follow(&o, order);
    }
    for (long k = 0; good && k <= order; k++) arb_poly_get_coeff_arb(out + k, &o.nodes[id], k);
    for (size_t i = 1; o.nodes != NULL && i <= o.size; i++) arb_poly_clear(&o.nodes[i]);
    for (size_t i = 0; o.given != NULL && i < model->symbol_count; i++) arb_poly_clear(&o.given[i]);
    free(o.given);
    free(o.nodes);
    free(o.needed);
    return good;
}
