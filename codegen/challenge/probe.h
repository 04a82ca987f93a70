/** Encloses expressions of a model and their derivatives at one point: forward-mode dual balls over the graph, through
 *  definitions. A value carries its derivative along every tangent; tangent k is that of the k-th state, those after the states
 *  are for the caller to seed.
 *
 *  It shares the expression graph with the prover and nothing else: no ratio, no symbolic derivative.
 *  Source: F. Johansson, Arb, IEEE TC 66(8), 2017; A. Griewank, A. Walther, Evaluating Derivatives, 2nd ed., 3.1. */
#ifndef TTC_PROBE_H
#define TTC_PROBE_H

#include "read/model.h"

#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#else
#include <arb.h>
#endif

enum { TTC_PROBE_SPARE = 4 /* tangents in addition to those of the states */ };

typedef struct ttc_probe ttc_probe;

/* model: borrowed. Returns NULL when memory is out. */
ttc_probe *ttc_probe_create(const ttc_model *model);
void ttc_probe_destroy(ttc_probe *probe); /* legal on NULL */

/* Balls of a value: itself, and its derivative along each tangent, states first. */
size_t ttc_probe_width(const ttc_probe *probe);

/* Forget all values, and set the precision, in bits. */
void ttc_probe_begin(ttc_probe *probe, long precision);
long ttc_probe_precision(const ttc_probe *probe);

/* Set a symbol's value, with derivatives 0. Setting a symbol forgets what was evaluated. */
void ttc_probe_set(ttc_probe *probe, uint32_t symbol, const arb_t value);

/* Set a symbol's value and derivatives: shape (width,). */
void ttc_probe_set_jet(ttc_probe *probe, uint32_t symbol, arb_srcptr jet);

/* Give a symbol the derivative 1 along the tangent `slot`, and 0 along others. */
void ttc_probe_seed(ttc_probe *probe, uint32_t symbol, size_t slot);

/* Give each state the derivative 1 along its own tangent, and 0 to all else. */
void ttc_probe_seed_states(ttc_probe *probe);

/* From now on, until a symbol is set, the expression is zero: at the point meant, which the symbols' balls only enclose, it is. At
 * most TTC_PROBE_SPARE at a time. */
void ttc_probe_set_zero(ttc_probe *probe, ttc_id id);

bool ttc_probe_is_set(const ttc_probe *probe, uint32_t symbol);
arb_srcptr ttc_probe_value(const ttc_probe *probe, uint32_t symbol); /* of a symbol that is set */

/** Enclose an expression: shape (width,), valid until a symbol is set or all is forgotten. Returns NULL when a symbol has no
 *  value, a denominator may be zero, a radicand may be not positive, or memory is out. Cost: one visit a node. */
arb_srcptr ttc_probe_at(ttc_probe *probe, ttc_id id);

#endif
