/** What the optimizer works on: named variables, each defined by a sum of signed monomials.
 *
 *  A monomial ("cube") is sign * scale * product of variables; its scale holds parameters alone, is prepared ahead of
 *  time, and so costs at most one multiplication, whatever it looks like. A variable is an input, a unit (a sum with a
 *  name: an author's grouping, a derivative, or a shared part that the optimizer made), or a function of another
 *  variable. Nothing here ever multiplies out an author's sum: rounding errors stay those of the table's grouping. */
#ifndef TTC_WORKSPACE_H
#define TTC_WORKSPACE_H

#include "fields/field.h"
#include "base/text.h"

enum { TTC_CUBE_LIMIT = 24 }; /* factors of a cube; longer products are split into units */

typedef struct {
    ttc_id scale;       /* parameters alone, of positive leading sign; the number 1 when there is none */
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
    bool is_extracted;         /* made by the optimizer, so it may be undone */
    bool is_output;
    uint32_t operand;          /* INPUT: position of the state; functions: variable */
    ttc_polynomial definition; /* UNIT */
    const char *label;         /* borrowed from the field, or from `names`; NULL when it has none */
    ttc_id divisor;            /* the variable is its label divided by this; TTC_NONE: by nothing */
} ttc_variable;

typedef struct {
    ttc_field *field;
    ttc_id one;
    ttc_variable *variables;
    uint32_t count, capacity;
    uint32_t *outputs; /* variables */
    uint32_t output_count;
    struct ttc_scale_ratios *ratios; /* quotients of scales that extractions share, borrowed; NULL: each makes its own */
    char **names; /* labels made here; a clone does not have them */
    size_t name_count;
    bool failed;       /* memory is out, or the graph refused */
} ttc_workspace;

/** Make a workspace of expressions in the field's symbols. NULL: memory is out. */
ttc_workspace *ttc_workspace_create(ttc_field *field, const ttc_id *outputs, size_t count);
ttc_workspace *ttc_workspace_clone(const ttc_workspace *workspace); /* NULL: memory */
void ttc_workspace_destroy(ttc_workspace *workspace);            /* legal on NULL */

/* What a variable is called in comments, "" when it has no name. */
void ttc_workspace_write_name(const ttc_workspace *workspace, ttc_text *text, uint32_t variable);

/* Give a variable a label; takes ownership of the text. It has none when memory is out. */
void ttc_workspace_name(ttc_workspace *workspace, uint32_t variable, ttc_text *label);

uint32_t ttc_workspace_add_variable(ttc_workspace *workspace, ttc_variable_kind kind, uint32_t operand);
/* p += cube; the cubes of p stay as they are. */
void ttc_polynomial_add(ttc_workspace *workspace, ttc_polynomial *p, const ttc_cube *cube);
/* The same, but where p has a cube with the same factors, the scales are added in that one. */
void ttc_polynomial_merge(ttc_workspace *workspace, ttc_polynomial *p, const ttc_cube *cube);
void ttc_polynomial_close_gaps(ttc_polynomial *p); /* removes cubes of sign 0 */

ttc_cube ttc_cube_one(const ttc_workspace *workspace);
/* cube *= variable. False when the cube is full. */
bool ttc_cube_multiply(ttc_cube *cube, uint32_t variable);
void ttc_cube_remove(ttc_cube *cube, uint32_t variable); /* one occurrence, which must be there */
unsigned ttc_cube_power(const ttc_cube *cube, uint32_t variable);
bool ttc_cube_same_factors(const ttc_cube *a, const ttc_cube *b);
/* cube *= sign and scale of an expression in parameters alone */
void ttc_cube_scale(ttc_workspace *workspace, ttc_cube *cube, ttc_id factor);
/* Multiplications that the cube takes. */
unsigned ttc_cube_cost(const ttc_workspace *workspace, const ttc_cube *cube);

/* True when a scale is never zero, whatever the parameters, so that others may be divided by it. */
bool ttc_scale_is_safe(const ttc_field *field, ttc_id scale);

/** Make one division serve all reciprocals that do not need each other: 1/(d_1 ... d_k), from which the single ones, and the
 *  products of them that are in use, are recovered by multiplications: along a tree of subsets, or each written out, for an
 *  extraction to find what they share. To be done last. */
void ttc_workspace_share_reciprocals(ttc_workspace *workspace, bool written_out);

/** Take out common factors, common products and common sums until nothing is gained. seed 0 always takes what gains
 *  most; others prefer it with some chance. pair_limit: where sums have more pairs of terms than this, each term is compared
 *  with some others alone, and a step takes all that is worth the same. Returns the work done, in comparisons. */
uint64_t ttc_workspace_extract(ttc_workspace *workspace, uint64_t seed, uint64_t pair_limit);

/* Write units that are used once back into their user, drop variables that are not used, and choose signs so that few negations are
 * left. */
void ttc_workspace_tidy(ttc_workspace *workspace);

/* Put a unit back where it is used. False when a cube would be too long; nothing is changed then. */
bool ttc_workspace_inline(ttc_workspace *workspace, uint32_t variable);

/* In every cube, cancel variables against their reciprocals, and replace the square of a root by its radicand. */
void ttc_workspace_cancel(ttc_workspace *workspace);

/** Write products out where they are used, so that they cancel there. Returns whether there were any. */
bool ttc_workspace_write_out(ttc_workspace *workspace);

/* Where the reciprocal of a root occurs in multiples of one power only, r^-3 say, it becomes that of r^3 = r r^2. */
void ttc_workspace_raise_reciprocals(ttc_workspace *workspace);

/** Every reciprocal of a root, 1/r, becomes r (1/r^2): a division by what the root is taken of need not wait for the root.
 *  Returns whether there were any. */
bool ttc_workspace_divide_by_radicands(ttc_workspace *workspace);

/* Divide units by one of their scales where that saves multiplications. */
void ttc_workspace_rescale(ttc_workspace *workspace);

#endif
