/** Known functions, and the span of their products, by values at common points. */
#ifndef TTC_SPAN_H
#define TTC_SPAN_H

#include "discover/flow.h"

/* A function with its degree, -1 where it is no polynomial; its cofactor (0 for an integral) is a function of parameters. */
typedef struct {
    char *name;
    int degree;
    ttc_ratio value;
    ttc_modular_ratio modular, cofactor;
} ttc_known;

typedef struct {
    ttc_known *items;
    size_t count;
} ttc_knowns;

/* Add a function. cofactor: NULL for an integral. */
void ttc_knowns_add(ttc_knowns *knowns, const ttc_flow *flow, const char *name, const ttc_ratio *value, const ttc_ratio *cofactor,
                    int degree);
void ttc_knowns_clear(ttc_knowns *knowns, const ttc_flow *flow);
/* Their images in the field that the flow has taken. */
void ttc_knowns_reduce(ttc_knowns *knowns, const ttc_flow *flow);

/* A span of vectors of values, in echelon form. */
typedef struct {
    nmod_t mod;
    ulong *rows; /* shape (count, width) */
    size_t *pivots;
    size_t count, capacity, width;
} ttc_span;

void ttc_span_init(ttc_span *span, size_t width, nmod_t mod);
void ttc_span_clear(ttc_span *span);
/* Add a vector, shape (width,). Returns false if the span had it. */
bool ttc_span_add(ttc_span *span, const ulong *vector);
void ttc_span_drop_last(ttc_span *span); /* removes the vector that was added last */

/* Points: values of the ring's variables, shape (count, variable_count), all with the same parameters. */
typedef struct {
    ulong *values;
    size_t count, width;
} ttc_points;

/* Draw points. In: parameters, shape (variable_count,), as ttc_flow_draw_parameters draws them. Returns false if one was not found;
 * clear in any case. */
bool ttc_points_draw(ttc_points *points, size_t count, const ttc_flow *flow, ulong *parameters, uint64_t *source);
void ttc_points_clear(ttc_points *points);

/* Which products are formed: of degree <= budget, where function k has degree degrees[k], or is not used if that is 0. A product
 * has at most one of the `single` functions, once; their degrees may have any sign. */
typedef struct {
    int budget;
    int *degrees;
    bool *single;
} ttc_products;

/** Add all these products whose cofactors add up to `cofactor`; the constant 1 among them if that is 0 and the budget is not
 *  negative. A function with a pole at a point is left out. */
void ttc_span_add_products(ttc_span *span, const ttc_knowns *knowns, const ttc_points *points, const ttc_products *which,
                           ulong cofactor);

#endif
