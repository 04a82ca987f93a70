/** Expressions of a model as exact ratios, under substitutions.
 *
 *  A symbol is free (a variable of the ring), bound to an expression, or, for a state, bound to a square root. Functions follow
 *  from what they are defined by: cosines and sines of angles that are linearly independent over the rationals are variables
 *  with c^2 + s^2 = 1, those of sums of their multiples follow by the addition theorems; exponentials likewise, and logarithms
 *  of arguments that are multiplicatively independent.
 *
 *  A plain valuation reads bound expressions in itself, so `when a = b, b = 1` means a = b = 1, and a circle is an error. A map
 *  (base != NULL) reads them in its base: the model at an image point, or another model seen from the base. */
#ifndef TTC_VALUATION_H
#define TTC_VALUATION_H

#include "read/model.h"
#include "algebra/ratio.h"

typedef struct ttc_valuation ttc_valuation;

/* Symbols beyond the model's own that a valuation offers, numbered from symbol_count on: to complete squares. */
enum { TTC_SPARE_SYMBOLS = 4, TTC_SPARE_VARIABLES = 12 };

/** A ring with one variable a parameter, state, root, angle function, level and spare symbol of `model`, and the plain
 *  valuation in it. choices: see ttc_ring. NULL when memory is out. The model must outlive it. */
ttc_valuation *ttc_valuation_create(const ttc_model *model, unsigned choices);

/* A map into the ring of `base`, which must outlive it. Every parameter, state and level is still unbound. */
ttc_valuation *ttc_valuation_map(const ttc_model *model, ttc_valuation *base);
void ttc_valuation_destroy(ttc_valuation *valuation); /* legal on NULL */

ttc_ring *ttc_valuation_ring(ttc_valuation *valuation);
const ttc_model *ttc_valuation_model(const ttc_valuation *valuation);

void ttc_valuation_bind(ttc_valuation *valuation, uint32_t symbol, ttc_id expression);
void ttc_valuation_bind_square(ttc_valuation *valuation, uint32_t symbol, ttc_id square);
void ttc_valuation_bind_root(ttc_valuation *valuation, uint32_t symbol, ttc_id radicand); /* to the positive square root */
/* A spare symbol stands for something that the model has no name for, and is called so in texts; name: borrowed. */
void ttc_valuation_name(ttc_valuation *valuation, uint32_t symbol, const char *name);
const char *ttc_valuation_name_of(const ttc_valuation *valuation, uint32_t symbol); /* NULL: none was given */
/* A root becomes a variable of its own, as a lifted root is a state; before anything is evaluated. */
void ttc_valuation_free_root(ttc_valuation *valuation, uint32_t symbol);
/* A function stays out of the bases, and what it is defined by is not looked at, until it is asked for. */
void ttc_valuation_withhold(ttc_valuation *valuation, uint32_t symbol);
bool ttc_valuation_has_value(const ttc_valuation *valuation, uint32_t symbol); /* whether it has been evaluated */
bool ttc_valuation_has_met(const ttc_valuation *valuation, ttc_id id);            /* the same of an expression */
bool ttc_valuation_is_bound(const ttc_valuation *valuation, uint32_t symbol);
/* The ring's variable of a symbol, or -1; and back, SIZE_MAX when there is none. */
slong ttc_valuation_variable(const ttc_valuation *valuation, uint32_t symbol);
size_t ttc_valuation_symbol(const ttc_valuation *valuation, slong variable);

/* out = value of the expression; failure is the ring's sticky status. TTC_NONE is a failure too. */
void ttc_evaluate(ttc_valuation *valuation, ttc_ratio *out, ttc_id id);

/** cos or sin of an angle in a plain valuation, where it is a sum of whole multiples of angles that the table names; else the
 *  ring fails with ANGLE or ANGLE_FRACTION. */
void ttc_valuation_angle(ttc_valuation *valuation, ttc_ratio *out, const ttc_ratio *angle, bool is_sine);

/** The same of exponentials and logarithms: the value for an exponent, or an argument, that follows from those that the table
 *  names; else the ring fails. */
void ttc_valuation_exp(ttc_valuation *valuation, ttc_ratio *out, const ttc_ratio *exponent);
void ttc_valuation_log(ttc_valuation *valuation, ttc_ratio *out, const ttc_ratio *argument);

/** The rates of the own variables of functions that were evaluated before, or that bound symbols stand for, by the chain rule.
 *  rates, shape (variable_count,), has those of the states. A function may be expressed through one that the table names after
 *  it, so that rates are taken until none changes. */
void ttc_valuation_add_function_rates(ttc_valuation *valuation, ttc_ratio *rates);

void ttc_valuation_pi(ttc_valuation *valuation, ttc_ratio *out); /* fails where the table has no pi */

#endif
