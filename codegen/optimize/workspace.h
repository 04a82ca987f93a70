/** What the optimizer works on: named variables, each defined by a sum of signed monomials.
 *
 *  A monomial ("cube") is sign * scale * product of variables; the scale, in parameters alone, is prepared ahead of time, and so
 *  costs at most one multiplication. A variable is an input, a unit (a sum with a name: an author's grouping, a derivative, or a
 *  shared part that the optimizer made), or a function of another variable. No pass multiplies out an author's sum: rounding
 *  errors stay those of the table's grouping. */
#ifndef TTC_WORKSPACE_H
#define TTC_WORKSPACE_H

#include "fields/field.h"
#include "base/text.h"

enum { TTC_CUBE_LIMIT = 24 }; /* factors of a cube; longer products are split into units */

typedef struct {
    ttc_id scale;       /* in parameters alone, with positive leading sign; 1 if there is none */
    int8_t sign;        /* 1 or -1 */
    uint8_t count;
    uint32_t factors[TTC_CUBE_LIMIT]; /* variables, ascending, repeated for powers */
} ttc_cube;

typedef struct {
    ttc_cube *cubes;
    uint32_t count, capacity;
} ttc_polynomial;

typedef enum { TTC_VARIABLE_INPUT, TTC_VARIABLE_UNIT, TTC_VARIABLE_RECIPROCAL, TTC_VARIABLE_ROOT, TTC_VARIABLE_COSINE,
               TTC_VARIABLE_SINE, TTC_VARIABLE_EXP, TTC_VARIABLE_LOG } ttc_variable_kind;

typedef struct {
    ttc_variable_kind kind;
    bool is_extracted;         /* made by the optimizer, which may inline it again */
    bool is_output;
    uint32_t operand;          /* INPUT: position of the state; functions: variable */
    ttc_polynomial definition; /* UNIT */
    const char *label;         /* borrowed from the field, or from `names`; NULL when it has none */
    ttc_id divisor;            /* the variable is label / divisor; TTC_NONE: it is the label */
} ttc_variable;

typedef struct {
    ttc_field *field;
    ttc_id one;
    ttc_variable *variables;
    uint32_t count, capacity;
    uint32_t *outputs; /* variables */
    uint32_t output_count;
    struct ttc_scale_ratios *ratios; /* shared by extractions, borrowed; NULL: each has its own */
    char **names; /* labels made here; a clone does not have them */
    size_t name_count;
    bool failed;       /* memory is out, or the graph is at its limits */
} ttc_workspace;

/** Make a workspace of expressions in the field's symbols. Returns NULL when memory is out. */
ttc_workspace *ttc_workspace_create(ttc_field *field, const ttc_id *outputs, size_t count);
ttc_workspace *ttc_workspace_clone(const ttc_workspace *workspace); /* returns NULL when memory is out */
void ttc_workspace_destroy(ttc_workspace *workspace);            /* legal on NULL */

/* Append a variable's name in comments, if it has one. */
void ttc_workspace_write_name(const ttc_workspace *workspace, ttc_text *text, uint32_t variable);

/* Give a variable a label; takes ownership of the text. The old one stays when memory is out. */
void ttc_workspace_name(ttc_workspace *workspace, uint32_t variable, ttc_text *label);

uint32_t ttc_workspace_add_variable(ttc_workspace *workspace, ttc_variable_kind kind, uint32_t operand);
/* Append a cube to p without merging. */
void ttc_polynomial_add(ttc_workspace *workspace, ttc_polynomial *p, const ttc_cube *cube);
/* p += cube; scales are added where the factors are equal. */
void ttc_polynomial_merge(ttc_workspace *workspace, ttc_polynomial *p, const ttc_cube *cube);
void ttc_polynomial_close_gaps(ttc_polynomial *p); /* removes cubes of sign 0 */

ttc_cube ttc_cube_one(const ttc_workspace *workspace);
/* cube *= variable. Returns false when the cube is full. */
bool ttc_cube_multiply(ttc_cube *cube, uint32_t variable);
void ttc_cube_remove(ttc_cube *cube, uint32_t variable); /* one occurrence, which must be there */
unsigned ttc_cube_power(const ttc_cube *cube, uint32_t variable);
bool ttc_cube_same_factors(const ttc_cube *a, const ttc_cube *b);
/* cube *= factor, an expression in parameters alone. */
void ttc_cube_scale(ttc_workspace *workspace, ttc_cube *cube, ttc_id factor);
/* Multiplications that a cube takes. */
unsigned ttc_cube_cost(const ttc_workspace *workspace, const ttc_cube *cube);

/* Whether a scale is known to be nonzero for all parameters, so that others may be divided by it. */
bool ttc_scale_is_safe(const ttc_field *field, ttc_id scale);

/** Make one division serve all reciprocals that do not depend on each other: 1/(d_1 ... d_k), from which multiplications recover
 *  the single ones and the products of them in use: along a tree of subsets; or, if written_out, each as a product of its own, in
 *  which an extraction may then find common parts. Only tidying, cancelling and that extraction may follow it. */
void ttc_workspace_share_reciprocals(ttc_workspace *workspace, bool written_out);

/** Extract common factors, products and sums until nothing is gained. Seed 0 always takes the greatest gain; others add noise to
 *  gains. pair_limit: if sums have more pairs of terms, each term is compared with only some others, and a step takes all
 *  candidates of equal gain. Returns the work done, in comparisons. */
uint64_t ttc_workspace_extract(ttc_workspace *workspace, uint64_t seed, uint64_t pair_limit);

/* Inline units that are used once, drop unused variables, and choose signs so that few negations are left. */
void ttc_workspace_tidy(ttc_workspace *workspace);

/* Replace a unit by its definition in all users. Returns false, without change, if it is no unit, an output, or the operand of a
 * function, or if a cube would become too long. */
bool ttc_workspace_inline(ttc_workspace *workspace, uint32_t variable);

/* Cancel variables against their reciprocals in every cube, and replace squares of roots by radicands. */
void ttc_workspace_cancel(ttc_workspace *workspace);

/** Inline all units that are products, so that factors can cancel. Returns whether there were any. */
bool ttc_workspace_write_out(ttc_workspace *workspace);

/* Where the reciprocal of a root r occurs only in multiples of a power n > 1, use that of r^n, as of r^3 = r r^2. */
void ttc_workspace_raise_reciprocals(ttc_workspace *workspace);

/** Replace reciprocals of roots, 1/r, by r (1/r^2): a division by the radicand need not wait for the root.
 *  Returns whether there were any. */
bool ttc_workspace_divide_by_radicands(ttc_workspace *workspace);

/* Divide units by one of their scales, which their users take, where this saves multiplications. */
void ttc_workspace_rescale(ttc_workspace *workspace);

#endif
