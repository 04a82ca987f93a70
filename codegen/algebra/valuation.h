/** Evaluation of a model's expressions as exact ratios, under substitutions.
 *
 *  A symbol is free (a variable of the ring), bound to an expression, or bound to a square root. Functions follow from their
 *  definitions: cosines and sines of angles that are linearly independent over the rationals are variables with c^2 + s^2 = 1,
 *  those of integer combinations of these angles follow by the addition theorems; likewise exponentials of independent exponents,
 *  and logarithms of multiplicatively independent arguments, are variables from which others follow.
 *
 *  A plain valuation evaluates bound expressions in itself, so that `when a = b, b = 1` means a = b = 1, and a circle is an error.
 *  A map (base != NULL) evaluates them in its base: it is the model at an image point, or another model seen from the base. */
#ifndef TTC_VALUATION_H
#define TTC_VALUATION_H

#include "read/model.h"
#include "algebra/ratio.h"

typedef struct ttc_valuation ttc_valuation;

/* Spare symbols, numbered from the model's symbol_count on, such as to complete squares; and variables for them and for roots. */
enum { TTC_SPARE_SYMBOLS = 4, TTC_SPARE_VARIABLES = 12 };

/** Create a ring with one variable for each symbol of `model` that is no let, and spare ones, and the plain valuation in it.
 *  choices: see ttc_ring. Returns NULL when memory is out. The model must outlive the valuation. */
ttc_valuation *ttc_valuation_create(const ttc_model *model, unsigned choices);

/* Create a plain valuation, with a ring of its own, of the same model with the same bindings. Returns NULL when memory is out. */
ttc_valuation *ttc_valuation_alike(const ttc_valuation *valuation, unsigned choices);

/* Create a map into the ring of `base`, which must outlive it. Parameters, states and levels must be bound before they are used. */
ttc_valuation *ttc_valuation_map(const ttc_model *model, ttc_valuation *base);
void ttc_valuation_destroy(ttc_valuation *valuation); /* legal on NULL */

ttc_ring *ttc_valuation_ring(ttc_valuation *valuation);
const ttc_model *ttc_valuation_model(const ttc_valuation *valuation);

void ttc_valuation_bind(ttc_valuation *valuation, uint32_t symbol, ttc_id expression);
void ttc_valuation_bind_square(ttc_valuation *valuation, uint32_t symbol, ttc_id square); /* to a square root of either sign */
void ttc_valuation_bind_root(ttc_valuation *valuation, uint32_t symbol, ttc_id radicand); /* to the positive square root */
/* Give a spare symbol a name for texts, which is borrowed; and get its name, NULL if it was given none. */
void ttc_valuation_name(ttc_valuation *valuation, uint32_t symbol, const char *name);
const char *ttc_valuation_name_of(const ttc_valuation *valuation, uint32_t symbol);
/* Make a root or a let, unless it is bound, a free variable, as a lifted root is a state. Call this before anything is evaluated.
 * Returns false, with nothing done, for a let for which there is no spare variable. */
bool ttc_valuation_free(ttc_valuation *valuation, uint32_t symbol);
/* The same for an expression, wherever it occurs as a node of the graph. Returns false as well if it has a value already. */
bool ttc_valuation_free_expression(ttc_valuation *valuation, ttc_id id);
bool ttc_valuation_is_free(const ttc_valuation *valuation, slong variable); /* true if one of these made it free */
/* Do not evaluate a function, nor its definition, to choose a basis; only when its own value is used. */
void ttc_valuation_withhold(ttc_valuation *valuation, uint32_t symbol);
bool ttc_valuation_has_value(const ttc_valuation *valuation, uint32_t symbol); /* true if it has been evaluated */
bool ttc_valuation_has_met(const ttc_valuation *valuation, ttc_id id);         /* the same of an expression */
bool ttc_valuation_is_bound(const ttc_valuation *valuation, uint32_t symbol);
/* The ring's variable for a symbol, or -1; the symbol of a variable, or SIZE_MAX. */
slong ttc_valuation_variable(const ttc_valuation *valuation, uint32_t symbol);
size_t ttc_valuation_symbol(const ttc_valuation *valuation, slong variable);

/* out = value of the expression. On failure, also for TTC_NONE, the ring fails and out is unchanged. */
void ttc_evaluate(ttc_valuation *valuation, ttc_ratio *out, ttc_id id);

/** cos or sin of an angle, in a plain valuation, that is an integer combination of angles which the table names; for others the
 *  ring fails with ANGLE or ANGLE_FRACTION. */
void ttc_valuation_angle(ttc_valuation *valuation, ttc_ratio *out, const ttc_ratio *angle, bool is_sine);

/** The exponential of an exponent, or logarithm of an argument, that follows from those of the table; for others the ring fails. */
void ttc_valuation_exp(ttc_valuation *valuation, ttc_ratio *out, const ttc_ratio *exponent);
void ttc_valuation_log(ttc_valuation *valuation, ttc_ratio *out, const ttc_ratio *argument);

/** Add the rates of functions that have a value or that bound symbols use, by the chain rule, to rates, shape (variable_count,),
 *  which has those of the states. Repeated until none changes, as a function may follow from one that the table defines later. */
void ttc_valuation_add_function_rates(ttc_valuation *valuation, ttc_ratio *rates);

void ttc_valuation_pi(ttc_valuation *valuation, ttc_ratio *out); /* fails where the table has no pi */

#endif
