/** Inside of a valuation, shared by its two files: symbols in general, and angles. */
#ifndef TTC_VALUATION_STATE_H
#define TTC_VALUATION_STATE_H

#include "algebra/valuation.h"

typedef enum { TTC_VALUE_UNKNOWN, TTC_VALUE_BUSY, TTC_VALUE_KNOWN } ttc_value_state;

struct ttc_valuation {
    const ttc_model *model;
    ttc_valuation *base;
    ttc_ring *ring; /* owned when base is NULL */
    size_t symbol_count;
    ttc_ratio *values;      /* by symbol, with what is known of them */
    ttc_value_state *known;
    ttc_id *bound, *square; /* by symbol; TTC_NONE: not so */
    slong *variable;        /* by symbol; -1: none */
    bool *freed;            /* by symbol: a root that is a variable */
    const char **names;     /* by variable */
    bool *positive;
    uint32_t *basis; /* cosines of independent angles, of which all others are sums; plain valuations only */
    size_t basis_count;
    bool has_basis;
    ttc_ratio *memo; /* by node */
    bool *seen;
    size_t memo_size;
};

/* The value of any symbol; failure is the ring's sticky status. */
void ttc_valuation_value(ttc_valuation *v, ttc_ratio *out, uint32_t symbol);

/* The value of a cosine or sine that is not bound. */
void ttc_valuation_angle_value(ttc_valuation *v, ttc_ratio *out, uint32_t symbol);

#endif
