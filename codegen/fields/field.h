/** A field: the equations of a model under one variant, in one time, with or without one state eliminated. Each descriptor
 *  of the generated code is that of one field.
 *
 *  Symbols have the same numbers as in the model; further ones stand for derivatives of shared subexpressions. A `let` whose
 *  definition in this field is a sum is a unit: a symbol of its own, evaluated once. Other lets are replaced by their definitions.
 *  Lifted roots are states after the table's; the level of an elimination is a parameter after the table's. */
#ifndef TTC_FIELD_H
#define TTC_FIELD_H

#include "fields/extent.h"
#include "read/model.h"

typedef enum {
    TTC_ROLE_ABSENT, /* replaced by an expression, set by the variant, or not used in kernels */
    TTC_ROLE_PARAM,
    TTC_ROLE_PI,
    TTC_ROLE_STATE,
    TTC_ROLE_UNIT, /* definition = the sum it stands for */
    TTC_ROLE_ROOT, /* definition = radicand */
    TTC_ROLE_COSINE,
    TTC_ROLE_SINE,
    TTC_ROLE_EXP,  /* definition = exponent */
    TTC_ROLE_LOG   /* definition = argument */
} ttc_role;

typedef struct {
    char *name;
    ttc_role role;
    uint32_t position;  /* of a STATE or PARAM in its vector */
    ttc_id node;        /* the symbol itself, or the expression that replaces it; TTC_NONE until first used */
    ttc_id definition;  /* UNIT, ROOT, EXP, LOG: see above; COSINE, SINE: the angle */
    uint32_t partner;   /* COSINE: the sine; SINE: the cosine */
    ttc_sign sign;      /* PARAM */
    bool is_constant;   /* the symbol depends on parameters alone */
    ttc_id *partials;   /* UNIT: partial derivatives by state position, each TTC_NONE until first used */
} ttc_field_symbol;

typedef struct ttc_field {
    const ttc_model *model;
    const ttc_variant *variant;         /* NULL: none */
    const ttc_time *time;               /* NULL: the model's own */
    const ttc_elimination *elimination; /* NULL: all states are kept */
    ttc_graph *graph;
    ttc_field_symbol *symbols;
    size_t symbol_count, symbol_capacity;
    uint32_t *states; /* symbols in the order of the state vector */
    size_t state_count;
    uint32_t *params;
    size_t param_count;
    ttc_id factor;    /* dt/dtau; the number 1 in the model's own time */
    ttc_id *rhs;      /* rates dx/dtau, shape (state_count,) */
    ttc_extent *extents; /* by id; signs = 0 until computed */
    size_t extent_capacity;
    struct ttc_scratch *scratch; /* see scratch.h */
    bool keeps_digits;   /* programs are made from sums rewritten by ttc_write_without_cancellation */
    size_t form_count;   /* number of sums that this rewriting changed */
    bool failed;      /* memory is out, or an operation of the graph failed */
} ttc_field;

typedef enum {
    TTC_FIELD_OK,
    TTC_FIELD_DIVIDES_BY_ZERO, /* the variant makes a denominator zero: there is no such field */
    TTC_FIELD_TOO_LARGE,
    TTC_FIELD_NO_MEMORY
} ttc_field_status;

/** Create the field of a variant, a time and an elimination; each may be NULL. On success the caller owns *out; otherwise *out is
 *  NULL, and the graph keeps its error unless it is a division by zero. The model, to whose graph it adds, must outlive it. */
ttc_field_status ttc_field_create(ttc_field **out, const ttc_model *model, const ttc_variant *variant,
                                  const ttc_time *time, const ttc_elimination *elimination);
void ttc_field_destroy(ttc_field *field); /* legal on NULL */

/** Renumber the parameters: parameter k becomes entry places[k] of a parameter vector of length `count`; places has shape
 *  (param_count,). Returns false when memory is out. */
bool ttc_field_place_params(ttc_field *field, const uint32_t *places, size_t count);

/* An expression of the model in the field's symbols. Returns TTC_NONE, with the graph's error set, if it divides by zero there. */
ttc_id ttc_field_specialise(ttc_field *field, ttc_id expression);

/** Partial derivative of an expression in the field's symbols with respect to the state at `position`, through units
 *  and functions by the chain rule. Derivatives of units are units where they are sums. */
ttc_id ttc_field_partial(ttc_field *field, ttc_id expression, size_t position);

/* Add a unit that stands for a sum, and return its node. Other expressions are returned as they are; TTC_NONE: memory is out. */
ttc_id ttc_field_add_unit(ttc_field *field, const char *name, ttc_id expression);

/** Compute the right-hand sides rhs, shape (state_count,), in a form in which terms with the same unit as denominator are one
 *  fraction, whose numerator is a new unit. Returns false when memory is out. */
bool ttc_field_gather(ttc_field *field, ttc_id *rhs);

/* sum * factor, multiplied out term by term, so that factors cancel within each term. */
ttc_id ttc_field_distribute(ttc_field *field, ttc_id sum, ttc_id factor);

/* Returns true for a field without variant and elimination, in any time. */
bool ttc_field_is_general(const ttc_field *field);

/* The number of lifted roots, which are the last states of the field. */
size_t ttc_field_lifted_count(const ttc_field *field);

/* Returns true if the expression depends on parameters alone. */
bool ttc_field_is_constant(const ttc_field *field, ttc_id expression);

/* Signs and bounds of an expression's values, from sign conditions of parameters, intervals of states, and the signs of roots and
 * functions. Cost: one visit to each node; results are stored. */
ttc_extent ttc_field_extent(ttc_field *field, ttc_id expression);

/* Returns true if the claim's `when` holds identically under the field's variant; on states, or with `modulo`, it never does. */
bool ttc_field_implies(ttc_field *field, const ttc_claim *claim);

#endif
