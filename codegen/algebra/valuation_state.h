/** Inside of a valuation, shared by its files: symbols in general, angles, exponentials, logarithms. */
#ifndef TTC_VALUATION_STATE_H
#define TTC_VALUATION_STATE_H

#include "algebra/independence.h"
#include "algebra/valuation.h"

typedef enum { TTC_VALUE_UNKNOWN, TTC_VALUE_BUSY, TTC_VALUE_KNOWN } ttc_value_state;

/* The value of a function's symbol that is not bound. */
typedef void (*ttc_function_value)(ttc_valuation *v, ttc_ratio *out, uint32_t symbol);

struct ttc_valuation {
    const ttc_model *model;
    const ttc_function_value *functions; /* by ttc_symbol_kind; NULL: no function */
    ttc_valuation *base;
    ttc_ring *ring; /* owned when base is NULL */
    size_t symbol_count;
    ttc_ratio *values;      /* by symbol, with what is known of them */
    ttc_value_state *known;
    ttc_id *bound, *square; /* by symbol; TTC_NONE: not so */
    slong *variable;        /* by symbol; -1: none */
    bool *freed;            /* by symbol: a root that is a variable */
    bool *rooted;           /* by symbol: of `square` it is the positive root */
    bool *withheld;         /* by symbol: a function that stays out of the bases until it is asked for */
    const char **names;     /* by variable */
    bool *positive;
    uint32_t *basis; /* cosines of independent angles, of which all others are sums; plain valuations only */
    size_t basis_count;
    bool has_basis;
    uint32_t *exponentials; /* independent ones, of which all others are products; plain valuations only */
    size_t exponential_count;
    bool has_exponentials;
    uint32_t *logarithms; /* independent ones, of which all others are sums; plain valuations only */
    size_t logarithm_count;
    bool met; /* every function of the table has a value */
    ttc_ratio *memo; /* by node */
    bool *seen;
    size_t memo_size;
};

/* The valuation that this is a map into, or a map of a map into: where functions have their bases. */
ttc_valuation *ttc_valuation_plain(ttc_valuation *v);

/* The value of any symbol; failure is the ring's sticky status. */
void ttc_valuation_value(ttc_valuation *v, ttc_ratio *out, uint32_t symbol);

/* The value of a cosine or sine that is not bound. */
void ttc_valuation_angle_value(ttc_valuation *v, ttc_ratio *out, uint32_t symbol);

/* The values of an exponential, or a logarithm, that is not bound, and of pi. */
void ttc_valuation_exp_value(ttc_valuation *v, ttc_ratio *out, uint32_t symbol);
void ttc_valuation_log_value(ttc_valuation *v, ttc_ratio *out, uint32_t symbol);
void ttc_valuation_pi_value(ttc_valuation *v, ttc_ratio *out, uint32_t symbol);

/* Functions join a basis when they are met. Where a value follows from no basis, all of the table are met first: true when that
 * has been done now, so that another attempt is worth while. */
bool ttc_valuation_meet(ttc_valuation *v);

/* Whether a function of the table may join a basis before it is asked for: it is not withheld, and its definition has a value.
 * One without is left to whoever asks for it. */
bool ttc_valuation_may_join(ttc_valuation *v, uint32_t symbol);

/* What is known of the functions of an angle or exponent, see ttc_ring_trust. basis, shape (count,): symbols whose definitions,
 * and logarithms whose values, it is compared with; those that are not free are left out. */
ttc_trust ttc_valuation_trust(ttc_valuation *v, const ttc_ratio *angle, const uint32_t *basis, size_t count);

#endif
