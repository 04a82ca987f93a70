/** A field: one model under one variant, in one time, with or without one state eliminated. It is what one descriptor
 *  of the generated code stands for.
 *
 *  Symbols carry the model's numbers, and further ones for derivatives of shared subexpressions. A `let` whose specialised
 *  definition is a sum stays a unit, a symbol of its own, evaluated once; all others are written out where they stand.
 *  A lifted root is a state after the table's; the level of an eliminated integral is a parameter after the table's. */
#ifndef TTC_FIELD_H
#define TTC_FIELD_H

#include "fields/extent.h"
#include "read/model.h"

typedef enum {
    TTC_ROLE_ABSENT, /* written out, bound by the variant, or of no use in kernels */
    TTC_ROLE_PARAM,
    TTC_ROLE_PI,
    TTC_ROLE_STATE,
    TTC_ROLE_UNIT, /* definition = what it stands for */
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
    ttc_id node;        /* what the symbol is written as: itself, or the expression that replaces it */
    ttc_id definition;  /* UNIT, ROOT: see above; COSINE, SINE: the angle */
    uint32_t partner;   /* of a cosine the sine, and the other way round */
    ttc_sign sign;      /* PARAM */
    bool is_constant;   /* depends on parameters alone */
    ttc_id *partials;   /* UNIT: by state position, TTC_NONE until asked for */
} ttc_field_symbol;

typedef struct ttc_field {
    const ttc_model *model;
    const ttc_variant *variant;         /* NULL: the general field */
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
    ttc_id *rhs;      /* by state position */
    ttc_extent *extents; /* by id, as far as they have been asked for */
    size_t extent_capacity;
    struct ttc_scratch *scratch; /* see scratch.h */
    bool keeps_digits;   /* sums are written without cancellation, see simplify.h, where they become programs */
    size_t form_count;   /* how often that gave another form */
    bool failed;      /* memory ran out, or the graph refused */
} ttc_field;

typedef enum {
    TTC_FIELD_OK,
    TTC_FIELD_DIVIDES_BY_ZERO, /* the substitutions make a denominator zero: there is no such field */
    TTC_FIELD_TOO_LARGE,
    TTC_FIELD_NO_MEMORY
} ttc_field_status;

/** Make the field of a variant, a time and an elimination; each may be NULL. On success *out is owned by the caller; otherwise *out
 *  is NULL, and the graph keeps the error unless it is a division by zero. The model, whose graph grows, must outlive the field. */
ttc_field_status ttc_field_create(ttc_field **out, const ttc_model *model, const ttc_variant *variant,
                                  const ttc_time *time, const ttc_elimination *elimination);
void ttc_field_destroy(ttc_field *field); /* legal on NULL */

/** Tell the field where its parameters stand among `count` values: places, shape (param_count,). False when memory is out. */
bool ttc_field_place_params(ttc_field *field, const uint32_t *places, size_t count);

/* An expression of the model in the field's symbols. TTC_NONE, with the graph's error set, where it divides by zero. */
ttc_id ttc_field_specialise(ttc_field *field, ttc_id expression);

/** Partial derivative of an expression in the field's symbols with respect to the state at `position`, through units
 *  and functions by the chain rule. Derivatives of units are units where they are sums. */
ttc_id ttc_field_partial(ttc_field *field, ttc_id expression, size_t position);

/* A new symbol that stands for the expression; TTC_NONE when memory is out. */
ttc_id ttc_field_add_unit(ttc_field *field, const char *name, ttc_id expression);

/** The right-hand sides in another form, shape (states,): terms over the same unit as denominator are gathered over it,
 *  and the sum of their numerators becomes a unit. False when memory is out. */
bool ttc_field_gather(ttc_field *field, ttc_id *rhs);

/* Multiply term by term, so that factors cancel in each term of a sum on its own. */
ttc_id ttc_field_distribute(ttc_field *field, ttc_id sum, ttc_id factor);

/* True for the field of no variant that keeps all states, in any time. */
bool ttc_field_is_general(const ttc_field *field);

/* How many roots are states of the field, after the table's. */
size_t ttc_field_lifted_count(const ttc_field *field);

/* True when the expression holds parameters alone. */
bool ttc_field_is_constant(const ttc_field *field, ttc_id expression);

/* What is known of an expression's values: from sign conditions of parameters, intervals of states, and that roots are
 * positive. Cost: one visit a node, remembered. */
ttc_extent ttc_field_extent(ttc_field *field, ttc_id expression);

/* True when the substitutions of the variant make this condition on parameters hold identically; a condition on states,
 * or one modulo claims, is never implied. */
bool ttc_field_implies(ttc_field *field, const ttc_claim *claim);

#endif
