/** What the symbols of a ball stand for, and expressions of them in rational arithmetic: inside of ball.h. */
#ifndef TTC_BALL_EXACT_H
#define TTC_BALL_EXACT_H

#include "read/model.h"

/* By symbol: its value where one is known; else the expression it stands for, TTC_NONE for its own definition. */
typedef struct {
    const ttc_model *model;
    fmpq *values;
    unsigned char *known;
    ttc_id *bound;
} ttc_ball_symbols;

/* What has been found of every node, by id. Begins zeroed. */
typedef struct {
    size_t size;
    fmpq *fractions;
    unsigned char *state;
} ttc_ball_exact;

/** The value of an expression, until the next call; NULL when a root on the way is irrational, another function or pi is
 *  met, a symbol has no value, a denominator vanishes, or memory is out. Cost: one visit a node, remembered until forgotten. */
const fmpq *ttc_ball_exact_value(ttc_ball_exact *exact, const ttc_ball_symbols *symbols, ttc_id id);

void ttc_ball_exact_forget(ttc_ball_exact *exact); /* what a symbol stands for has changed */
void ttc_ball_exact_clear(ttc_ball_exact *exact);

#endif
