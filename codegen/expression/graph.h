/** Hash-consed expression graph with exact rational numbers.
 *
 *  Expressions with the same normal form are one node, so that comparing them means comparing ids. Ids count up in order of
 *  creation, and creation follows the table, so every order derived from ids is the same on every machine. Nodes are in
 *  normal form:
 *
 *    NUMBER   an exact rational
 *    SYMBOL   index into the owner's symbol table (parameter, state, root, let, ...)
 *    PRODUCT  coefficient * base_1^e_1 * ... * base_k^e_k   bases distinct, ascending ids, SYMBOL or primitive SUM (its
 *             coefficients are integers without common factor, the first one positive), e_i != 0; not a number (k = 0), not a
 *             base alone, and not a multiple of one sum, which is a SUM
 *    SUM      constant + sum of coefficient_i * term_i      terms distinct, ascending ids, SYMBOL or PRODUCT with
 *             coefficient 1; nested sums are flattened
 *
 *  A `let` name is a SYMBOL of its own, so the grouping that its author wrote is kept until a pass expands it.
 *  Memory: nodes live until the graph is destroyed. Errors: division by zero and anything beyond the limits below give
 *  TTC_NONE, and ttc_graph_error() says which was the first until it is cleared; an operation on TTC_NONE gives TTC_NONE.
 *  The limits bound memory, time and the recursion of every later pass on hostile input. */
#ifndef TTC_GRAPH_H
#define TTC_GRAPH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <flint/fmpq.h>

typedef uint32_t ttc_id;
#define TTC_NONE ((ttc_id)0)

enum {
    TTC_EXPONENT_LIMIT = 64, /* as written in a table; the parser checks it */
    TTC_POWER_LIMIT = 256,   /* of a base in a product, as derivatives and substitutions make larger exponents */
    TTC_COEFFICIENT_BITS = 4096,  /* of a numerator or denominator */
    TTC_DEPTH_LIMIT = 1024,       /* nodes of the longest chain of parts within parts */
    TTC_PART_LIMIT = 1 << 13,     /* parts of one node */
    TTC_NODE_LIMIT = 1 << 20,
    TTC_MEMORY_LIMIT = 1 << 29    /* bytes of all nodes */
};

typedef enum { TTC_NUMBER, TTC_SYMBOL, TTC_PRODUCT, TTC_SUM } ttc_kind;

typedef enum {
    TTC_GRAPH_OK,
    TTC_GRAPH_DIVISION_BY_ZERO,
    TTC_GRAPH_EXPONENT,
    TTC_GRAPH_COEFFICIENT,
    TTC_GRAPH_DEPTH,
    TTC_GRAPH_TOO_LARGE,
    TTC_GRAPH_NO_MEMORY
} ttc_graph_status;

typedef struct {
    ttc_id id;         /* base of a factor, or term of a sum */
    int32_t exponent;  /* of a factor; 1 in a sum */
    const fmpq *coefficient; /* of a term of a sum; the number 1 in a product */
} ttc_part;

typedef struct ttc_graph ttc_graph;

ttc_graph *ttc_graph_create(void); /* NULL when memory is out */
void ttc_graph_destroy(ttc_graph *graph); /* legal on NULL */

/* The first error since the graph was created or the error was last cleared. */
ttc_graph_status ttc_graph_error(const ttc_graph *graph);
void ttc_graph_clear_error(ttc_graph *graph);
const char *ttc_graph_status_text(ttc_graph_status status); /* a phrase; never NULL */

/* Number of nodes; ids run from 1 to this number. */
size_t ttc_graph_size(const ttc_graph *graph);

/* Constructors, each returning a node in normal form. */
ttc_id ttc_number(ttc_graph *graph, const fmpq_t value);
ttc_id ttc_integer(ttc_graph *graph, long value);
ttc_id ttc_symbol(ttc_graph *graph, uint32_t symbol);
ttc_id ttc_add(ttc_graph *graph, ttc_id a, ttc_id b);
ttc_id ttc_subtract(ttc_graph *graph, ttc_id a, ttc_id b);
ttc_id ttc_multiply(ttc_graph *graph, ttc_id a, ttc_id b);
ttc_id ttc_divide(ttc_graph *graph, ttc_id a, ttc_id b);
ttc_id ttc_power(ttc_graph *graph, ttc_id a, long exponent);
ttc_id ttc_scale(ttc_graph *graph, ttc_id a, const fmpq_t factor);

/* The sum of weights[i] * terms[i], and the product of bases[i]^exponents[i]. Built at once they take linear time, where adding or
 * multiplying one by one takes quadratic time. weights == NULL means that all are 1. */
ttc_id ttc_sum(ttc_graph *graph, const ttc_id *terms, const fmpq *weights, size_t count);
ttc_id ttc_product(ttc_graph *graph, const ttc_id *bases, const long *exponents, size_t count);

/* Inspection. `part` pointers and coefficients stay valid until the graph is destroyed. */
ttc_kind ttc_kind_of(const ttc_graph *graph, ttc_id id);
const fmpq *ttc_coefficient(const ttc_graph *graph, ttc_id id); /* NUMBER: value; PRODUCT: coefficient; SUM: constant */
uint32_t ttc_symbol_of(const ttc_graph *graph, ttc_id id);      /* SYMBOL only */
size_t ttc_part_count(const ttc_graph *graph, ttc_id id);       /* PRODUCT and SUM; 0 otherwise */
ttc_part ttc_part_at(const ttc_graph *graph, ttc_id id, size_t index);
bool ttc_is_number(const ttc_graph *graph, ttc_id id, long value);
const fmpq *ttc_number_value(const ttc_graph *graph, ttc_id id); /* of a NUMBER; NULL for another node, and for TTC_NONE */

/** Replace symbols and rebuild. map(context, symbol) gives the replacement, or TTC_NONE to keep the symbol.
 *  Cost: one visit to each reachable node. */
typedef ttc_id (*ttc_symbol_map)(void *context, uint32_t symbol);
ttc_id ttc_substitute(ttc_graph *graph, ttc_id id, ttc_symbol_map map, void *context);

/** Derivative along a direction: slope(context, symbol) gives the derivative of a symbol, or TTC_NONE for zero.
 *  With slope(x) = 1 and zero otherwise it is the partial derivative by x. Cost: one visit to each reachable node. */
ttc_id ttc_derivative(ttc_graph *graph, ttc_id id, ttc_symbol_map slope, void *context);

/** Substitution and derivative that follow definitions of symbols: definition(context, symbol) gives the node that a symbol
 *  stands for, or TTC_NONE; its id must be smaller than that of the symbol's node. value(context, symbol, v) then gives the
 *  replacement of the symbol, and slope(context, symbol, v) its derivative, or TTC_NONE as above; v is the result for its
 *  definition, TTC_NONE where it has none.
 *  Cost: one visit to each reachable node, definitions included. */
typedef ttc_id (*ttc_symbol_definition)(void *context, uint32_t symbol);
typedef ttc_id (*ttc_symbol_value)(void *context, uint32_t symbol, ttc_id definition_value);
ttc_id ttc_substitute_through(ttc_graph *graph, ttc_id id, ttc_symbol_definition definition, ttc_symbol_value value,
                              void *context);
ttc_id ttc_derivative_through(ttc_graph *graph, ttc_id id, ttc_symbol_definition definition, ttc_symbol_value slope,
                              void *context);

/* Returns true if `symbol` occurs in id; definitions of symbols are not followed. Also true when memory is out. */
bool ttc_depends(const ttc_graph *graph, ttc_id id, uint32_t symbol);

#endif
