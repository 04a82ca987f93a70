/** The representation of a valuation, shared by its files: symbols in general, angles, exponentials, logarithms. */
#ifndef TTC_VALUATION_STATE_H
#define TTC_VALUATION_STATE_H

#include "algebra/independence.h"
#include "algebra/valuation.h"

typedef enum { TTC_VALUE_UNKNOWN, TTC_VALUE_BUSY, TTC_VALUE_KNOWN } ttc_value_state;

/* Computes the value of a function's symbol that is not bound. */
typedef void (*ttc_function_value)(ttc_valuation *v, ttc_ratio *out, uint32_t symbol);

struct ttc_valuation {
    const ttc_model *model;
    const ttc_function_value *functions; /* by ttc_symbol_kind; NULL: no function */
    ttc_valuation *base;
    ttc_ring *ring; /* owned if base is NULL */
    size_t symbol_count;
    ttc_ratio *values;      /* by symbol; valid if `known` is KNOWN */
    ttc_value_state *known;
    ttc_id *bound, *square; /* by symbol: the expression it is bound to; the square of what it is bound to; TTC_NONE: none */
    slong *variable;        /* by symbol; -1: none */
    bool *freed;            /* by variable: it stands for a root, a let or an expression, as if that were free */
    bool *rooted;           /* by symbol: bound to the positive root of `square` */
    bool *withheld;         /* by symbol: see ttc_valuation_withhold */
    const char **names;     /* by variable */
    bool *positive;         /* by variable */
    uint32_t *basis; /* cosines of the basis of angles, of which all other angles are combinations; plain valuations only */
    size_t basis_count;
    bool has_basis;
    uint32_t *exponentials; /* the basis of exponentials, of which all others are products; plain valuations only */
    size_t exponential_count;
    bool has_exponentials;
    uint32_t *logarithms; /* the basis of logarithms, of which all others are combinations; plain valuations only */
    size_t logarithm_count;
    bool met; /* ttc_valuation_meet has been called */
    ttc_ratio *memo; /* by node of the graph: its value, if `seen` */
    bool *seen;
    size_t memo_size;
};

/* The valuation that this one maps into, through all maps of maps: the one in whose ring functions have their bases. */
ttc_valuation *ttc_valuation_plain(ttc_valuation *v);

/* The value of any symbol. On failure the ring fails. */
void ttc_valuation_value(ttc_valuation *v, ttc_ratio *out, uint32_t symbol);

/* The value of a cosine or sine that is not bound. */
void ttc_valuation_angle_value(ttc_valuation *v, ttc_ratio *out, uint32_t symbol);

/* The value of an exponential or a logarithm that is not bound; the value of pi. */
void ttc_valuation_exp_value(ttc_valuation *v, ttc_ratio *out, uint32_t symbol);
void ttc_valuation_log_value(ttc_valuation *v, ttc_ratio *out, uint32_t symbol);
void ttc_valuation_pi_value(ttc_valuation *v, ttc_ratio *out, uint32_t symbol);

/* Evaluate all functions of the table, so that they join the bases: used once, when a value does not follow from the bases. Returns
 * true if they were evaluated by this call, so that the caller should try again. */
bool ttc_valuation_meet(ttc_valuation *v);

/* Returns true if a function may join a basis before its value is used: it is not withheld, and its definition has a value. */
bool ttc_valuation_may_join(ttc_valuation *v, uint32_t symbol);

/* ttc_ring_trust for a basis of symbols, shape (count,): cosines and exponentials stand for their definitions, logarithms for
 * themselves; those that are not free are left out. */
ttc_trust ttc_valuation_trust(ttc_valuation *v, const ttc_ratio *angle, const uint32_t *basis, size_t count);

#endif
