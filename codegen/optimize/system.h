/** What the optimizer works on: named variables, each defined by a sum of signed monomials.
 *
 *  A monomial ("cube") is sign * scale * product of variables; its scale holds parameters alone, is prepared ahead of
 *  time, and so costs at most one multiplication, whatever it looks like. A variable is an input, a unit (a sum with a
 *  name: an author's grouping, a derivative, or a shared part that the optimizer made), or a function of another
 *  variable. Nothing here ever multiplies out an author's sum: rounding errors stay those of the table's grouping. */
#ifndef TTC_SYSTEM_H
#define TTC_SYSTEM_H

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
} ttc_system;

/** From expressions in the field's symbols. NULL: memory. */
ttc_system *ttc_system_create(ttc_field *field, const ttc_id *outputs, size_t count);
ttc_system *ttc_system_clone(const ttc_system *system); /* NULL: memory */
void ttc_system_destroy(ttc_system *system);            /* legal on NULL */

/* What a variable is called in comments, "" when it has no name. */
void ttc_system_write_name(const ttc_system *system, ttc_text *text, uint32_t variable);

/* Give a variable a label; takes ownership of the text. It has none when memory is out. */
void ttc_system_name(ttc_system *system, uint32_t variable, ttc_text *label);

uint32_t ttc_system_add_variable(ttc_system *system, ttc_variable_kind kind, uint32_t operand);
void ttc_polynomial_add(ttc_system *system, ttc_polynomial *p, const ttc_cube *cube);
/* The same, where a cube of equal factors takes the new one in, scales added. */
void ttc_polynomial_merge(ttc_system *system, ttc_polynomial *p, const ttc_cube *cube);
void ttc_polynomial_remove(ttc_polynomial *p, uint32_t index); /* keeps the order of the rest */
void ttc_polynomial_close_gaps(ttc_polynomial *p); /* cubes of sign 0 leave */

ttc_cube ttc_cube_one(const ttc_system *system);
/* False when the cube is full. */
bool ttc_cube_multiply(ttc_cube *cube, uint32_t variable);
void ttc_cube_remove(ttc_cube *cube, uint32_t variable); /* one occurrence, which must be there */
unsigned ttc_cube_power(const ttc_cube *cube, uint32_t variable);
bool ttc_cube_same_factors(const ttc_cube *a, const ttc_cube *b);
/* cube *= sign and scale of an expression in parameters alone */
void ttc_cube_scale(ttc_system *system, ttc_cube *cube, ttc_id factor);
/* Multiplications that the cube takes. */
unsigned ttc_cube_cost(const ttc_system *system, const ttc_cube *cube);

/* True when a scale is never zero, whatever the parameters, so that others may be divided by it. */
bool ttc_scale_is_safe(const ttc_field *field, ttc_id scale);

/** One division for all reciprocals that do not need each other: 1/(d_1 ... d_k), from which the single ones, and the
 *  products of them that are in use, are recovered by multiplications: along a tree of subsets, or each written out, for an
 *  extraction to find what they share. To be done last. */
void ttc_system_share_reciprocals(ttc_system *system, bool written_out);

/** Take out common factors, common products and common sums until nothing is gained. seed 0 always takes what gains
 *  most; others prefer it with some chance. pair_limit: where sums have more pairs of terms than this, each term is compared
 *  with some others alone, and a step takes all that is worth the same. Returns the work done, in comparisons. */
uint64_t ttc_system_extract(ttc_system *system, uint64_t seed, uint64_t pair_limit);

/* Undo what is used once, drop what is not used, and turn signs so that few negations are left. */
void ttc_system_tidy(ttc_system *system);

/* Put a unit back where it is used. False when a cube would be too long; nothing is changed then. */
bool ttc_system_inline(ttc_system *system, uint32_t variable);

/* In every cube, a variable goes against its reciprocal, and the square of a root becomes its radicand. */
void ttc_system_cancel(ttc_system *system);

/** Write products out where they are used, so that they cancel there. Returns whether there were any. */
bool ttc_system_write_out(ttc_system *system);

/* Where the reciprocal of a root occurs in multiples of one power only, r^-3 say, it becomes that of r^3 = r r^2. */
void ttc_system_raise_reciprocals(ttc_system *system);

/** Every reciprocal of a root, 1/r, becomes r (1/r^2): a division by what the root is taken of need not wait for the root.
 *  Returns whether there were any. */
bool ttc_system_divide_by_radicands(ttc_system *system);

/* Divide units by one of their scales where that saves multiplications. */
void ttc_system_rescale(ttc_system *system);

#endif
