/** One end of a state's interval at which a pole is claimed, and limits of expressions as the state approaches it. */
#ifndef TTC_POLE_END_H
#define TTC_POLE_END_H

#include "prove/prove_task.h"

typedef struct {
    ttc_task *task;
    uint32_t state;
    bool is_high;                        /* the upper end of the interval */
    slong variable;                      /* of the state */
    fmpz_mpoly_t way;                    /* distance of the state from the end, up to a factor: b x + c, positive inside */
    bool vanishes[TTC_GENERATOR_LIMIT];  /* by generator: it is zero at the end */
} ttc_pole_end;

typedef enum { TTC_POLE_GOES_TO_ZERO, TTC_POLE_GOES_ELSEWHERE, TTC_POLE_IS_NOT_FOLLOWED } ttc_pole_limit;

/* out = the polynomial with zero for the generators that are flagged in `roots`. */
void ttc_pole_drop(const ttc_pole_end *end, fmpz_mpoly_t out, const fmpz_mpoly_t polynomial, const bool *roots);

/* Returns true if a polynomial is a multiple of way. */
bool ttc_pole_has_factor(const ttc_pole_end *end, const fmpz_mpoly_t polynomial);

/* out = the polynomial with the state at its end, but roots as they are: its resultant with way = b x + c over (-b)^degree. */
void ttc_pole_put_state(const ttc_pole_end *end, ttc_ratio *out, const fmpz_mpoly_t polynomial);

/* Returns true if a polynomial, and the radicands of roots in it, are shown not to be zero with the state at its end. Factors that
 * are such roots apart, each depends on parameters alone, and is nonzero for parameters in general; or its terms are of one sign,
 * and their part in parameters alone is not zero (the others may be, as other states may go to ends of their own at the time). */
bool ttc_pole_is_nonzero(const ttc_pole_end *end, const fmpz_mpoly_t polynomial);

/* Returns true if the limit of a polynomial at the end is found by replacing the state and the roots that vanish: it uses no
 * function of the state, functions of other states in it stay bounded, and denominators in squares of its other roots do not become
 * zero. is_apart: moreover none of these other roots depends on the state. */
bool ttc_pole_is_followed(const ttc_pole_end *end, const fmpz_mpoly_t polynomial, bool is_apart);

/* Fill end->vanishes. */
void ttc_pole_find_vanishing(ttc_pole_end *end);

/* The limit of a ratio at the end, and its value, unless it is not followed. lifted: NULL, or flags of roots that vanish; the limit
 * is then GOES_TO_ZERO only if the numerator lies in the ideal of way and these roots, and so vanishes as fast as they do. */
ttc_pole_limit ttc_pole_follow(const ttc_pole_end *end, ttc_ratio *value, const ttc_ratio *ratio, const bool *lifted);

#endif
