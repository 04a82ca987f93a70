/* The motion of the top in quadruple precision, from (3.2) of Kilin & Ivanova (2023) alone: what random tops are held against.
 *
 * Field: (3.2) times s, in (gamma3, s) together. Method: Taylor series of order 24, errors of a step below 1e-21 of scale.
 * Shadows are the same orbit in 64 bits with a random error of one tolerance in every state after every step: their distance from
 * the orbit is the tolerance times what the orbit makes of errors, and where they do not agree on an end, nobody can. */
#ifndef JLT_TESTS_ORACLE_H
#define JLT_TESTS_ORACLE_H

#include <stdbool.h>

#include "core/random.h"

enum { ORACLE_ROWS_MAX = 16, ORACLE_SHADOWS = 3 };

typedef enum {
    ORACLE_GAMMA3, ORACLE_V_NU, ORACLE_OMEGA_TAU, ORACLE_OMEGA_N, ORACLE_OMEGA3, ORACLE_S, ORACLE_T,
    ORACLE_STATES
} oracle_state;

typedef struct {
    double m, R, g, I1, I3, a3;
} oracle_top;

typedef enum {
    ORACLE_ALIVE, /* all rows are there */
    ORACLE_POLE_PLUS,
    ORACLE_POLE_MINUS,
    ORACLE_REST,   /* nothing moves any more */
    ORACLE_BUDGET, /* its own steps are spent */
    ORACLE_ENDS
} oracle_end;

/* Which states get errors: v_tau, or omega_n and omega3, or one of these, the other then by G. */
typedef enum { ORACLE_EXACT, ORACLE_LEVEL_NOISE, ORACLE_FIVE_NOISE, ORACLE_OMEGA_N_NOISE, ORACLE_OMEGA3_NOISE } oracle_noise;

typedef struct {
    oracle_top top;
    double gamma3, v_nu, omega_tau, omega_n, omega3; /* of the start; */
    bool level;                                      /* omega_n and omega3 by v_tau and G: */
    double v_tau, G;
    int time_direction;  /* +1, -1 */
    int crossings;       /* +1 rising, -1 falling for growing t, 0 both; */
    const double *times; /* or the state at times, NULL: crossings */
    int count;           /* rows that are wanted */
    double tolerance, speed; /* speed: the scale of velocities */
    bool plain;              /* shadows have s by gamma3 alone, as in plain time */
} oracle_question;

typedef struct {
    int count;    /* rows */
    oracle_end end;
    long double rows[ORACLE_ROWS_MAX + 1][ORACLE_STATES]; /* from 1; where it ended by name one more, the limit */
    long double pace[ORACLE_ROWS_MAX + 1]; /* how fast it is there, relative to scale: 0 at rest */
    long double depth[ORACLE_ROWS_MAX + 2]; /* crossings: largest |omega_tau| since the one before, in scale */
    long double lean[ORACLE_ROWS_MAX + 1]; /* crossings: how fast anything changes for omega_tau, all in scale: what errors of its
                                              zero make */
    long double least_s, least_pace; /* met on the way */
    long double drift;               /* of E, G and s^2 + gamma3^2, in scale */
    unsigned long steps;
} oracle_orbit;

/* The orbit; with noise (not EXACT) a shadow. */
void oracle_follow(oracle_orbit *out, const oracle_question *question, oracle_noise noise, jlt_random *random);

#endif
