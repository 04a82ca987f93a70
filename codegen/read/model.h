/** A model: what one term table says, with names resolved and all expressions in one graph.
 *
 *  Everything is plain data, which later passes read and never change. A symbol is known by its number, which is its index in
 *  `symbols` and its number in the graph; a claim by its index in `claims`. Lists are in the order of the table. An array has the
 *  count that stands beside it. */
#ifndef TTC_MODEL_H
#define TTC_MODEL_H

#include "base/diagnostic.h"
#include "expression/graph.h"

typedef struct {
    uint32_t line, column; /* 1-based; column counts bytes */
} ttc_place;

typedef enum {
    TTC_PARAM,
    TTC_STATE,
    TTC_ROOT,   /* definition = radicand: symbol^2 = radicand and symbol > 0 */
    TTC_COSINE, /* definition = angle; partner = the sine */
    TTC_SINE,
    TTC_LET,    /* definition = what it stands for */
    TTC_LEVEL,  /* the value of an integral, named by `eliminate`; a parameter of the eliminated kernels */
    TTC_LAMBDA, /* the indeterminate of characteristic polynomials; always present, named lambda */
    TTC_EXP,    /* definition = exponent; symbol > 0 */
    TTC_LOG,    /* definition = argument, which is positive */
    TTC_PI      /* the number, named pi; present where a table uses it */
} ttc_symbol_kind;

typedef enum { TTC_ANY_SIGN, TTC_POSITIVE, TTC_NONNEGATIVE, TTC_NONZERO } ttc_sign; /* of a parameter */

typedef struct {
    char *name, *unit, *meaning; /* unit and meaning may be NULL */
    ttc_symbol_kind kind;
    ttc_place place;
    ttc_id node;       /* the symbol itself in the graph */
    ttc_id definition; /* see the kinds; TTC_NONE otherwise. Its node stands before `node` in the graph */
    uint32_t partner;  /* TTC_COSINE, TTC_SINE: the other symbol of the pair */
    ttc_sign sign;     /* TTC_PARAM */
    ttc_id period;     /* TTC_STATE: the period that `periodic` claims, a number > 0; TTC_NONE: the state is no angle */
    bool in_pi;        /* that number is in units of pi */
    ttc_id low, high;  /* TTC_STATE: open interval, constants or expressions in parameters; TTC_NONE: unbounded */
    ttc_id value;      /* TTC_PARAM: the default, a number; TTC_NONE: none given */
} ttc_symbol_entry;

/* One line of an equation: sign and expression together. */
typedef struct {
    ttc_id expression;
    ttc_place place;
} ttc_term;

typedef struct {
    uint32_t state; /* symbol */
    ttc_term *terms;
    size_t term_count;
    ttc_id sum;     /* of the terms: d(state)/dt */
    ttc_place place;
} ttc_equation;

/* SYMBOL = expression: a substitution, in `variant`, `when`, `equilibria`, `reduction`. */
typedef struct {
    uint32_t symbol;
    ttc_id expression;
    ttc_place place;
} ttc_binding;

typedef struct {
    ttc_binding *items;
    size_t count;
} ttc_bindings;

typedef struct {
    char *name;
    ttc_bindings bindings;
    ttc_place place;
} ttc_variant;

typedef struct {
    char *name;
    ttc_id factor; /* dt = factor * dtau */
    uint32_t *lifted; /* roots that become states */
    size_t lifted_count;
    ttc_place place;
} ttc_time;

typedef struct {
    char *name;
    uint32_t state; /* symbol of the state that goes */
    uint32_t integral; /* index into claims */
    uint32_t level; /* symbol: TTC_LEVEL, or a TTC_PARAM that the table declares itself */
    ttc_id solution; /* the state in terms of the others and the level; the integral is linear in it */
    ttc_id slope;    /* of the integral in the state: what the solution divides by */
    ttc_place place;
} ttc_elimination;

typedef enum {
    TTC_CLAIM_INTEGRAL,
    TTC_CLAIM_INVARIANT,
    TTC_CLAIM_MEASURE,
    TTC_CLAIM_REVERSOR,   /* bindings: STATE = its image, affine in the states */
    TTC_CLAIM_EQUILIBRIA, /* bindings: STATE = expression */
    TTC_CLAIM_TRACE,      /* these five: family = index of their equilibria claim */
    TTC_CLAIM_CHARPOLY,
    TTC_CLAIM_OBSTRUCTS,
    TTC_CLAIM_MATRIX,     /* entries: the Jacobian on the family, row by row */
    TTC_CLAIM_LEFT_NULL,  /* members: integrals whose gradients on the family are left null vectors */
    TTC_CLAIM_EQUAL,      /* expression = other */
    TTC_CLAIM_RATE,       /* d(expression)/dt = other */
    TTC_CLAIM_POSITIVE,   /* expression > 0 */
    TTC_CLAIM_REDUCTION,  /* bindings_of_target: target's STATE or ROOT = expression here, see `target` */
    TTC_CLAIM_EMBEDDING,  /* the same; the target is the larger model */
    TTC_CLAIM_SYMMETRY,   /* as REVERSOR; named by its keyword where it has no name */
    TTC_CLAIM_PERIODIC,   /* the symmetry STATE = STATE + period; named by its state */
    TTC_CLAIM_SECTION,    /* when: STATE = number; target: the table of coordinates; see ttc_section */
    TTC_CLAIM_DESCENT,    /* a reduction by a smaller table, `target`, which has an embedding into this one; see ttc_way */
    TTC_CLAIM_LIFT        /* into a larger table, `target`, which has a reduction onto this one; see ttc_way */
} ttc_claim_kind;

typedef struct {
    ttc_claim_kind kind;
    char *name;
    ttc_place place;
    ttc_id expression, other;
    ttc_bindings bindings;
    ttc_bindings when;    /* substitutions made first; in parameters or states */
    uint32_t *modulo;     /* claims (integral or invariant) whose zero level is taken */
    size_t modulo_count;
    uint32_t family;
    ttc_id *entries;      /* n*n */
    size_t entry_count;
    uint32_t *members;
    size_t member_count;
    char *target;         /* REDUCTION, EMBEDDING, SECTION, DESCENT, LIFT: file name of the other model, beside this one */
    char **target_names;  /* of the first two: names in it, one a binding */
} ttc_claim;

/* An end of a state's interval at which orbits end. */
typedef struct {
    uint32_t state; /* symbol */
    char *meaning;  /* may be NULL */
    ttc_place place;
} ttc_pole;

typedef enum { TTC_GIVEN_PLAIN, TTC_GIVEN_ANGLE, TTC_GIVEN_ROOT } ttc_given_form;

/* Where a point of this table lies in another one, beside what its claim holds: `entries`, two a name, which are the sine
 * and the cosine of an angle times one positive number, of a root the radicand and 1, otherwise the value and 1; and
 * `members`, the integrals whose values are `levels`. */
typedef struct {
    char **names; /* in the other table, in the order of the record */
    ttc_given_form *forms;
    size_t count;
    char **levels; /* parameters of that table */
    size_t level_count;
} ttc_image;

/* A section and its coordinates, which are states of another table. */
typedef struct {
    uint32_t claim;
    ttc_image image;
    uint32_t *beside, *ending; /* symbols */
    size_t beside_count, ending_count;
} ttc_section;

/* expression > 0 */
typedef struct {
    ttc_id expression;
    char *text; /* of the whole, as the table writes it */
} ttc_inequality;

typedef struct {
    ttc_inequality *items;
    size_t count;
} ttc_inequalities;

/* A table that may serve in place of this one: a smaller or a larger one, by the kind of the claim. */
typedef struct {
    uint32_t claim;
    ttc_image image;
    ttc_inequalities where;
} ttc_way;

/* What this table is called among tables that serve in place of each other. */
typedef struct {
    char *name, *meaning; /* NULL: there is no such record */
    ttc_inequalities conditions; /* its coordinates are good for computing while they hold */
    ttc_place place;
} ttc_tier;

/* In a table of coordinates: the states and lifted roots of the model, as expressions in the coordinates. */
typedef struct {
    char *file;   /* the model's table; NULL: this is no table of coordinates */
    char **names; /* in it, one a binding */
    ttc_bindings bindings;
    ttc_place place;
} ttc_lift;

/* In a table of coordinates: a point to begin with. */
typedef struct {
    char *name;
    ttc_id *point; /* shape (state_count,), numbers */
    ttc_place place;
} ttc_start;

/* `domain NAME : expression > 0`: a part of the domain that no sign of a parameter and no interval of a state can say. */
typedef struct {
    char *name;
    char *text; /* of the condition, as it is written */
    ttc_id expression;
    ttc_place place;
} ttc_region;

/* `valid NAME : expression > 0`: the model holds while it is. */
typedef struct {
    char *name, *unit, *meaning; /* unit and meaning may be NULL */
    ttc_id expression;
    ttc_place place;
} ttc_validity;

/* What a table divides by, as it is written, before anything is cancelled: it is not zero on the domain. */
typedef enum {
    TTC_DIVIDES_FIELD,  /* in an equation, an interval or a domain record: wherever the model is looked at */
    TTC_DIVIDES_SYMBOL, /* in the definition of symbol `owner`: wherever that is used */
    TTC_DIVIDES_CLAIM,  /* in claim `owner` */
    TTC_DIVIDES_VARIANT,
    TTC_DIVIDES_TIME,
    TTC_DIVIDES_VALID,  /* in validity `owner`, which is looked at where it is defined, and nowhere else */
    TTC_DIVIDES_TIER,   /* the same of the conditions of `tier` */
    TTC_DIVIDES_LIFT    /* in what a table of coordinates says of its points, all of which it must be defined at */
} ttc_divisor_role;

typedef struct {
    ttc_id divisor;
    ttc_divisor_role role;
    uint32_t owner;
} ttc_divisor;

/* A definition (let, root, function) that a record names, as it is written, before anything is cancelled. */
typedef struct {
    uint32_t symbol;
    ttc_divisor_role role; /* of the record, as of divisors */
    uint32_t owner;
} ttc_use;

typedef struct ttc_model {
    char *file;  /* as given, for diagnostics */
    char *name, *title, *source; /* title and source may be NULL */
    char sha256[65]; /* of the text, hexadecimal */
    char *text;  /* the table itself, NUL-terminated */
    ttc_graph *graph;
    ttc_symbol_entry *symbols;
    size_t symbol_count;
    uint32_t *params, *states; /* symbols in order of appearance */
    size_t param_count, state_count;
    ttc_equation *equations; /* in the order of states */
    size_t equation_count;   /* equals state_count in a complete model; 0 in a table of coordinates */
    ttc_variant *variants;
    size_t variant_count;
    ttc_time *times;
    size_t time_count;
    ttc_elimination *eliminations;
    size_t elimination_count;
    ttc_claim *claims;
    size_t claim_count;
    ttc_region *regions;
    size_t region_count;
    uint32_t *observed; /* lets that `observe` defines or names */
    size_t observed_count;
    ttc_validity *validities;
    size_t validity_count;
    ttc_pole *poles;
    size_t pole_count;
    ttc_section *sections;
    size_t section_count;
    ttc_way *ways;
    size_t way_count;
    ttc_tier tier;
    ttc_lift lift;
    ttc_start *starts;
    size_t start_count;
    ttc_id turn;        /* of a table of coordinates, or TTC_NONE: what starts are called where it is negative */
    char *turn_meaning;
    ttc_divisor *divisors;
    size_t divisor_count;
    ttc_use *uses;
    size_t use_count;
} ttc_model;

/** Read a table. text: `length` bytes, need not be NUL-terminated; file: a name for messages.
 *  Returns NULL when there was an error; `diagnostics` then holds every one that was found, in order of place; it may hold
 *  warnings in any case. Cost: linear in the text, and in the nodes it makes. */
ttc_model *ttc_model_parse(const char *text, size_t length, const char *file, ttc_diagnostics *diagnostics);

/** Read a table that was read before, such as one that its kernels carry. text: ends with a NUL. NULL: memory is out, or it does
 *  not read. */
ttc_model *ttc_model_again(const char *text, const char *file);

/* The same from a file; an unreadable one is a diagnostic too. */
ttc_model *ttc_model_read(const char *path, ttc_diagnostics *diagnostics);

void ttc_model_destroy(ttc_model *model); /* legal on NULL */

void ttc_claim_clear(ttc_claim *claim); /* frees what it holds */

/* Whether it is a reversor or a symmetry that is called by its keyword. */
bool ttc_claim_is_unnamed(const ttc_claim *claim);

/* Find a symbol or a claim by its name; false when there is none. */
bool ttc_model_find_symbol(const ttc_model *model, const char *name, uint32_t *symbol);
bool ttc_model_find_claim(const ttc_model *model, const char *name, uint32_t *claim);

/* The indeterminate of characteristic polynomials: a table may have a quantity of its own that is called lambda. */
uint32_t ttc_model_lambda(const ttc_model *model);

/* The name of the table's file without its folder; borrowed. */
const char *ttc_model_base_name(const ttc_model *model);

/* Whether symbols of this kind are functions of their definition: roots, cosines, sines, exponentials, logarithms. */
bool ttc_symbol_is_function(ttc_symbol_kind kind);

/* What such a function is called, "sqrt", "cos", ...; "" for other kinds. */
const char *ttc_symbol_function(ttc_symbol_kind kind);

/* Replace every `let` by its definition, all the way down. Functions stay symbols. */
ttc_id ttc_model_expand(const ttc_model *model, ttc_id id);

/* Whether an expression depends on a symbol, also through definitions. */
bool ttc_model_depends(const ttc_model *model, ttc_id id, uint32_t symbol);

/* Which symbols the expressions, shape (count,), depend on, also through definitions: an array, shape (symbol_count,), of 1 and 0,
 * for the caller to free; NULL when memory is out. */
unsigned char *ttc_model_support(const ttc_model *model, const ttc_id *ids, size_t count);

/* The definitions that equations, intervals and domain records name, and those that these name in their turn, as written: shape
 * (symbol_count,), 1 or 0, for the caller to free; NULL when memory is out. */
unsigned char *ttc_model_uses(const ttc_model *model);
/* Whether the claim number `claim` is an integral or density without conditions that divides by it, itself or in a definition: such
 * kernels of the model share with the others what is prepared of parameters. */
bool ttc_model_prepares(const ttc_model *model, uint32_t claim, const ttc_divisor *divisor);
/* Adds to `used` the definitions that those in it name. */
void ttc_model_close_uses(const ttc_model *model, unsigned char *used);

/** Partial derivative with respect to a state (or parameter), through definitions by the chain rule; lets
 *  themselves stay as they are in the factors. */
ttc_id ttc_model_partial(const ttc_model *model, ttc_id id, uint32_t symbol);

/** Rate of an expression along the flow of the table's equations, which must be complete. Each term of an equation is multiplied
 *  out separately, so that common factors cancel. TTC_NONE, with the graph's error set, when that fails. */
ttc_id ttc_model_rate(const ttc_model *model, ttc_id id);

/* What is positive where a state stands on the inner side of this end of its interval; TTC_NONE: it has no such end. */
ttc_id ttc_model_inside(const ttc_model *model, uint32_t state, bool is_high);

/* The right-hand side of equation number k: the sum of its terms. */
ttc_id ttc_model_field(const ttc_model *model, size_t k);

/* Whether claims of this kind have the name of a claim `equilibria` and speak of its family: trace, charpoly, obstructs, matrix,
 * leftnull. */
bool ttc_claim_speaks_of_family(ttc_claim_kind kind);

const char *ttc_claim_kind_name(ttc_claim_kind kind); /* as written in the table: "integral", ... */

#endif
