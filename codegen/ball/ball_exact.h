/** The values of the symbols of a ball, and expressions in rational arithmetic. Internal to ball/. */
#ifndef TTC_BALL_EXACT_H
#define TTC_BALL_EXACT_H

#include "read/model.h"

/* By symbol: its value if known; else the expression bound to it; TTC_NONE: its own definition. */
typedef struct {
    const ttc_model *model;
    fmpq *values;
    unsigned char *known;
    ttc_id *bound;
} ttc_ball_symbols;

/* Values of nodes, by id, as far as known. Zeroed before first use. */
typedef struct {
    size_t size;
    fmpq *fractions;
    unsigned char *state;
} ttc_ball_exact;

/** The value of an expression, valid until the next call. Returns NULL when a root on the way is irrational, another function or
 *  pi is met, a symbol has no value, a denominator vanishes, or memory is out. Cost: one visit a node, remembered. */
const fmpq *ttc_ball_exact_value(ttc_ball_exact *exact, const ttc_ball_symbols *symbols, ttc_id id);

void ttc_ball_exact_forget(ttc_ball_exact *exact); /* call it when a value or binding has changed */
void ttc_ball_exact_clear(ttc_ball_exact *exact);

#endif
