/** A model: the content of one table, with names resolved and all expressions in one graph.
 *
 *  Everything is plain data, which later passes read and never change. A symbol is identified by its index in `symbols`, also its
 *  number in the graph, a claim by its index in `claims`. Lists are in the order of the table; the count of each is beside it. */
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
    TTC_SINE,   /* definition = angle; partner = the cosine */
    TTC_LET,    /* definition = the expression it stands for */
    TTC_LEVEL,  /* the value of an integral, named by `eliminate`; a parameter of the eliminated kernels */
    TTC_LAMBDA, /* the indeterminate of characteristic polynomials, named lambda; always symbol 0 */
    TTC_EXP,    /* definition = exponent; symbol > 0 */
    TTC_LOG,    /* definition = argument, which is positive */
    TTC_PI      /* the number pi, named pi; present only in a table that uses it */
} ttc_symbol_kind;

typedef enum { TTC_ANY_SIGN, TTC_POSITIVE, TTC_NONNEGATIVE, TTC_NONZERO } ttc_sign; /* of a parameter */

typedef struct {
    char *name, *unit, *meaning; /* unit and meaning may be NULL */
    ttc_symbol_kind kind;
    ttc_place place;
    ttc_id node;       /* the symbol itself in the graph */
    ttc_id definition; /* see the kinds; TTC_NONE otherwise. Its id is smaller than `node` */
    uint32_t partner;  /* TTC_COSINE, TTC_SINE: the other symbol of the pair */
    ttc_sign sign;     /* TTC_PARAM */
    ttc_id period;     /* TTC_STATE: the period that `periodic` claims, a number > 0; TTC_NONE: the state is no angle */
    bool in_pi;        /* `period` is to be multiplied by pi */
    ttc_id low, high;  /* TTC_STATE: open interval, constants or expressions in parameters; TTC_NONE: unbounded */
    ttc_id value;      /* TTC_PARAM: the default, a number; TTC_NONE: none given */
} ttc_symbol_entry;

/* One term of an equation, with its sign. */
typedef struct {
    ttc_id expression;
    ttc_place place;
} ttc_term;

typedef struct {
    uint32_t state; /* symbol */
    ttc_term *terms;
    size_t term_count;
    ttc_id sum;     /* the sum of the terms: d(state)/dt */
    ttc_place place;
} ttc_equation;

/* SYMBOL = expression: a substitution, as in `variant`, `when`, `equilibria`, `reduction`. */
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
    uint32_t state; /* symbol of the state that is eliminated */
    uint32_t integral; /* index into claims */
    uint32_t level; /* symbol: TTC_LEVEL, or a TTC_PARAM that the table declares itself */
    ttc_id solution; /* the state in terms of the others and the level; the integral is linear in the state */
    ttc_id slope;    /* partial derivative of the integral by the state: what the solution divides by */
    ttc_place place;
} ttc_elimination;

typedef enum {
    TTC_CLAIM_INTEGRAL,
    TTC_CLAIM_INVARIANT,
    TTC_CLAIM_MEASURE,
    TTC_CLAIM_REVERSOR,   /* bindings: STATE = its image, affine in the states */
    TTC_CLAIM_EQUILIBRIA, /* bindings: STATE = expression */
    TTC_CLAIM_TRACE,      /* this and the next four have family = index of their equilibria claim */
    TTC_CLAIM_CHARPOLY,
    TTC_CLAIM_OBSTRUCTS,
    TTC_CLAIM_MATRIX,     /* entries: the Jacobian on the family, row by row */
    TTC_CLAIM_LEFT_NULL,  /* members: integrals whose gradients on the family are left null vectors */
    TTC_CLAIM_EQUAL,      /* expression = other */
    TTC_CLAIM_RATE,       /* d(expression)/dt = other */
    TTC_CLAIM_POSITIVE,   /* expression > 0 */
    TTC_CLAIM_REDUCTION,  /* bindings, target_names: a STATE or ROOT of the model in `target` = expression in this table's names */
    TTC_CLAIM_EMBEDDING,  /* the same; the target is the larger model */
    TTC_CLAIM_SYMMETRY,   /* bindings as of REVERSOR; its name is its keyword where the table gives none */
    TTC_CLAIM_PERIODIC,   /* the symmetry STATE = STATE + period; named by its state */
    TTC_CLAIM_SECTION,    /* when: STATE = number; target: the table of coordinates; see ttc_section */
    TTC_CLAIM_DESCENT,    /* `reduction NAME : by` a smaller table, `target`, which has an embedding into this one; see ttc_way */
    TTC_CLAIM_LIFT        /* into a larger table, `target`, which has a reduction onto this one; see ttc_way */
} ttc_claim_kind;

typedef struct {
    ttc_claim_kind kind;
    char *name;
    ttc_place place;
    ttc_id expression, other;
    ttc_bindings bindings;
    ttc_bindings when;    /* substitutions for parameters or states that are made first */
    uint32_t *modulo;     /* claims (integral or invariant) on whose common zero level this one is meant */
    size_t modulo_count;
    uint32_t family;
    ttc_id *entries;      /* MATRIX: shape (n, n); SECTION, DESCENT, LIFT: see ttc_image */
    size_t entry_count;
    uint32_t *members;    /* indices of integrals */
    size_t member_count;
    char *target;         /* REDUCTION, EMBEDDING, SECTION, DESCENT, LIFT: name of the other table's file, beside this one */
    char **target_names;  /* REDUCTION, EMBEDDING: for each binding the name in the target that it sets */
} ttc_claim;

/* A state both ends of whose interval are poles, at which orbits end. */
typedef struct {
    uint32_t state; /* symbol */
    char *meaning;  /* may be NULL */
    ttc_place place;
} ttc_pole;

typedef enum { TTC_GIVEN_PLAIN, TTC_GIVEN_ANGLE, TTC_GIVEN_ROOT } ttc_given_form;

/* A map of this table's points to those of another table. The claim holds two of its `entries` for each name, (A, B) for an angle
 * atan2(A, B), (radicand, 1) for a root, (value, 1) otherwise; and in `members` for each level the integral whose value it is. */
typedef struct {
    char **names; /* states, roots and parameters of the other table, in the order of the record */
    ttc_given_form *forms;
    size_t count;
    char **levels; /* parameters of the other table that are given by integrals */
    size_t level_count;
} ttc_image;

/* A section and its coordinates, which are states of another table. */
typedef struct {
    uint32_t claim;
    ttc_image image;
    uint32_t *beside, *ending; /* symbols to show at returns, and where an orbit ends */
    size_t beside_count, ending_count;
    size_t shown_uses; /* the uses of its claim from this number on come from `beside` and `ending` */
} ttc_section;

/* expression > 0 */
typedef struct {
    ttc_id expression;
    char *text; /* the inequality as the table writes it */
} ttc_inequality;

typedef struct {
    ttc_inequality *items;
    size_t count;
} ttc_inequalities;

/* A table that may serve in place of this one: a smaller one if the claim is a DESCENT, a larger one if it is a LIFT. */
typedef struct {
    uint32_t claim;
    ttc_image image;
    ttc_inequalities where; /* the states for which the table may serve */
    size_t where_divisors, where_uses; /* the divisors and uses of its claim from these numbers on come from `where` */
} ttc_way;

/* The name of this table among tables that serve in place of each other. */
typedef struct {
    char *name, *meaning; /* NULL: there is no such record */
    ttc_inequalities conditions; /* the table's coordinates are good for computing while these hold */
    ttc_place place;
} ttc_tier;

/* In a table of coordinates: the states and lifted roots of the model, as expressions in the coordinates. */
typedef struct {
    char *file;   /* the model's table; NULL: this is no table of coordinates */
    char **names; /* for each binding the name in the model that it sets */
    ttc_bindings bindings;
    ttc_place place;
} ttc_lift;

/* In a table of coordinates: a point at which an orbit starts. */
typedef struct {
    char *name;
    ttc_id *point; /* shape (state_count,), numbers */
    ttc_place place;
} ttc_start;

/* `domain NAME : expression > 0`: a condition on the domain beyond signs of parameters and intervals of states. */
typedef struct {
    char *name;
    char *text; /* the condition as the table writes it */
    ttc_id expression;
    ttc_place place;
} ttc_region;

/* `valid NAME : expression > 0`: the model holds while the expression is positive. */
typedef struct {
    char *name, *unit, *meaning; /* unit and meaning may be NULL */
    ttc_id expression;
    ttc_place place;
} ttc_validity;

/* The kind of record in which a table divides. What it divides by, as written and before anything is cancelled, is not zero on the
 * domain; the role says where that matters. */
typedef enum {
    TTC_DIVIDES_FIELD,  /* in an equation, an interval or a domain record: on the whole domain */
    TTC_DIVIDES_SYMBOL, /* in the definition of symbol `owner`: wherever the symbol is used */
    TTC_DIVIDES_CLAIM,  /* in claim `owner` */
    TTC_DIVIDES_VARIANT,
    TTC_DIVIDES_TIME,
    TTC_DIVIDES_VALID,  /* in validity `owner`, which is evaluated only where it is defined and leaves the domain as it is */
    TTC_DIVIDES_TIER,   /* in the conditions of `tier`, which are evaluated in the same way */
    TTC_DIVIDES_LIFT    /* in `lift` or `turns` of a table of coordinates, which must be defined at all its points */
} ttc_divisor_role;

typedef struct {
    ttc_id divisor;
    ttc_divisor_role role;
    uint32_t owner;
} ttc_divisor;

/* A symbol with a definition (let, root, function) that a record names, even if it cancels from the result. */
typedef struct {
    uint32_t symbol;
    ttc_divisor_role role; /* kind of the record, as for divisors */
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
    ttc_id turn;        /* in a table of coordinates, the expression of `turns`, or TTC_NONE */
    char *turn_meaning; /* what starts are called where it is negative */
    ttc_divisor *divisors;
    size_t divisor_count;
    ttc_use *uses;
    size_t use_count;
} ttc_model;

/** Parse a table. text: `length` bytes, need not be NUL-terminated; file: a name for messages.
 *  Returns NULL if there was an error; `diagnostics` then holds the errors that were found, in order of place. It may hold
 *  warnings in any case. Cost: linear in the length of the text and the number of nodes. */
ttc_model *ttc_model_parse(const char *text, size_t length, const char *file, ttc_diagnostics *diagnostics);

/** Parse a table that parsed without errors before, such as the copy within its kernels, and drop all messages. text: ends with a
 *  NUL. Returns NULL if memory is out or the text has errors. */
ttc_model *ttc_model_again(const char *text, const char *file);

/** The same table parsed again, with a symbol for the number pi, used or not, unless the table gives that name to something else.
 *  It is compared with another table, which may contain pi where this one does not. Returns NULL if memory is out. */
ttc_model *ttc_model_with_pi(const ttc_model *model);

/* ttc_model_parse of a file. That it cannot be read is an error in `diagnostics` too. */
ttc_model *ttc_model_read(const char *path, ttc_diagnostics *diagnostics);

void ttc_model_destroy(ttc_model *model); /* legal on NULL */

void ttc_claim_clear(ttc_claim *claim); /* frees what the claim holds, not the claim itself */

/* Returns true for a reversor or symmetry without a name in the table, whose name is its keyword. */
bool ttc_claim_is_unnamed(const ttc_claim *claim);

/* Find a symbol or a claim by its name; return false if there is none. Claims about a family are not found by its name. */
bool ttc_model_find_symbol(const ttc_model *model, const char *name, uint32_t *symbol);
bool ttc_model_find_claim(const ttc_model *model, const char *name, uint32_t *claim);

/* The indeterminate of characteristic polynomials; looking up its name may give a quantity of the table that is called lambda. */
uint32_t ttc_model_lambda(const ttc_model *model);

/* The name of the table's file without its folder; borrowed. */
const char *ttc_model_base_name(const ttc_model *model);

/* Returns true if symbols of this kind are functions of their definition: roots, cosines, sines, exponentials, logarithms. */
bool ttc_symbol_is_function(ttc_symbol_kind kind);

/* The value of a function of this kind at a number. Returns false unless it is rational: a root of a square, exp(0), log(1),
 * cos(0), sin(0). */
bool ttc_symbol_rational(fmpq_t value, ttc_symbol_kind kind, const fmpq_t argument);

/* The name of the function, "sqrt", "cos", "sin", "exp" or "log"; "" for other kinds. */
const char *ttc_symbol_function(ttc_symbol_kind kind);

/* Replace every `let` by its definition, recursively. Functions stay symbols. */
ttc_id ttc_model_expand(const ttc_model *model, ttc_id id);

/* An expression, or, if it is the name of a `let`, the definition of that; repeated until the result is no such name. */
ttc_id ttc_model_without_lets(const ttc_model *model, ttc_id id);

/* The first sum, or definition of a `let` that is one, to a negative power in a product; TTC_NONE if there is none. */
ttc_id ttc_model_dividing_sum(const ttc_model *model, ttc_id id);

/* Returns true if an expression depends on a symbol, directly or through definitions; also when memory is out. */
bool ttc_model_depends(const ttc_model *model, ttc_id id, uint32_t symbol);

/* Find all symbols on which the expressions, shape (count,), depend, directly or through definitions. Returns flags 1 or 0, shape
 * (symbol_count,), for the caller to free; NULL when memory is out. */
unsigned char *ttc_model_support(const ttc_model *model, const ttc_id *ids, size_t count);

/* Find all symbols with a definition that records of this role and owner name, and recursively those that their definitions name,
 * as written. Returns flags 1 or 0, shape (symbol_count,), for the caller to free; NULL when memory is out. */
unsigned char *ttc_model_uses_of(const ttc_model *model, ttc_divisor_role role, uint32_t owner);
/* The same for the symbols that these records name at positions `first` to `end` - 1 alone, counted from 0 in the order of the
 * table. */
unsigned char *ttc_model_uses_between(const ttc_model *model, ttc_divisor_role role, uint32_t owner, size_t first, size_t end);
/* The same for equations, intervals and domain records (role TTC_DIVIDES_FIELD). */
unsigned char *ttc_model_uses(const ttc_model *model);
/* The same and all roots and logarithms, used or not: the domain requires that their arguments are positive. */
unsigned char *ttc_model_uses_of_domain(const ttc_model *model);
/* Returns true if claim number `claim` is an integral or density without conditions that divides by `divisor`, itself or in a
 * definition. Kernels of such a claim share their values prepared from parameters with all other kernels of the model. */
bool ttc_model_prepares(const ttc_model *model, uint32_t claim, const ttc_divisor *divisor);
/* Whether an expression is 0 wherever the parameter is, as its factors and terms show. */
bool ttc_model_vanishes_with(const ttc_model *model, ttc_id expression, const ttc_symbol_entry *param);
/* A parameter that may be 0, and where it is 0 the divisor is too, as its factors and terms show; NULL if there is none. */
const ttc_symbol_entry *ttc_model_zero_divisor(const ttc_model *model, ttc_id divisor);
/* Add to the flags `used`, shape (symbol_count,), recursively the symbols that definitions of flagged symbols name, and of each
 * angle the cosine with the sine. */
void ttc_model_close_uses(const ttc_model *model, unsigned char *used);

/** Partial derivative by a state (or parameter), through definitions by the chain rule. Lets remain symbols in the result. */
ttc_id ttc_model_partial(const ttc_model *model, ttc_id id, uint32_t symbol);

/** Rate of an expression along the flow of the table's equations, which must be complete. Each term of an equation is multiplied
 *  out separately, so that common factors cancel. Returns TTC_NONE, with the graph's error set, on failure. */
ttc_id ttc_model_rate(const ttc_model *model, ttc_id id);

/* An expression that is positive where the state lies inside this end of its interval; TTC_NONE if the interval has no such end. */
ttc_id ttc_model_inside(const ttc_model *model, uint32_t state, bool is_high);

/* The right-hand side of equation number k: the sum of its terms. */
ttc_id ttc_model_field(const ttc_model *model, size_t k);

/* Returns true for claims about a family of equilibria, which have its name: trace, charpoly, obstructs, matrix, leftnull. */
bool ttc_claim_speaks_of_family(ttc_claim_kind kind);

const char *ttc_claim_kind_name(ttc_claim_kind kind); /* as written in the table: "integral", ... */

#endif
