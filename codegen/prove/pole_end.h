/** One end of a state's interval at which a pole is claimed, and what can be told of expressions as it is neared. */
#ifndef TTC_POLE_END_H
#define TTC_POLE_END_H

#include "prove/prove_task.h"

typedef struct {
    ttc_task *task;
    uint32_t state;
    bool is_high;
    slong variable;                      /* of the state */
    fmpz_mpoly_t way;                    /* linear in the state, positive inside */
    bool vanishes[TTC_GENERATOR_LIMIT];  /* roots that are zero at the end */
} ttc_pole_end;

typedef enum { TTC_POLE_GOES_TO_ZERO, TTC_POLE_GOES_ELSEWHERE, TTC_POLE_IS_NOT_FOLLOWED } ttc_pole_limit;

/* out = a polynomial with these roots, of those that vanish, put to zero. */
void ttc_pole_drop(const ttc_pole_end *end, fmpz_mpoly_t out, const fmpz_mpoly_t polynomial, const bool *roots);

/* Whether a polynomial is a multiple of way. */
bool ttc_pole_has_factor(const ttc_pole_end *end, const fmpz_mpoly_t polynomial);

/* out = the polynomial, without roots that vanish, with the state at its end. Its resultant with way = b x + c is (-b)^degree
 * times that. */
void ttc_pole_put_state(const ttc_pole_end *end, ttc_ratio *out, const fmpz_mpoly_t polynomial);

/* Whether a polynomial, and what the roots in it are taken of, is not zero with the state at its end: for parameters in general; or
 * by signs, with terms of parameters alone that keep it from zero, as other states may go to ends of their own on the way. */
bool ttc_pole_is_nonzero(const ttc_pole_end *end, const fmpz_mpoly_t polynomial);

/* Whether what a polynomial is made of can be followed to the end: of functions of the state the values there are not looked
 * for, those of other states must stay bounded, and what divides under other roots must not become zero. is_apart: moreover no
 * other root changes with the state. */
bool ttc_pole_is_followed(const ttc_pole_end *end, const fmpz_mpoly_t polynomial, bool is_apart);

/* Fill end->vanishes. */
void ttc_pole_find_vanishing(ttc_pole_end *end);

/* Where a ratio goes as the end is neared. value: receives where, unless it is not followed. lifted: NULL, or roots that vanish:
 * that it goes to zero is then followed only where it does with these and the way left, at least as fast as their sum. */
ttc_pole_limit ttc_pole_follow(const ttc_pole_end *end, ttc_ratio *value, const ttc_ratio *ratio, const bool *lifted);

#endif
