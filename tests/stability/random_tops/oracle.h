/* An oracle for random tops: the motion in quadruple precision, from (3.2) of Kilin & Ivanova (2023) alone.
 *
 * Field: (3.2) times s, with both gamma3 and s as states. Method: Taylor series of order 24, with errors of a step below 1e-21 of
 * scale. A shadow is the same orbit in long double with a random error of at most one tolerance added to states after every step.
 * The distance of shadows from the orbit shows how the orbit amplifies errors; where shadows disagree on how it ends, the end
 * cannot be tested. */
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
    ORACLE_ALIVE, /* all rows were reached */
    ORACLE_POLE_PLUS,
    ORACLE_POLE_MINUS,
    ORACLE_REST,   /* the top has come to rest */
    ORACLE_BUDGET, /* the oracle's limit of steps was reached */
    ORACLE_ENDS
} oracle_end;

/* Which states get errors beside gamma3, v_nu and omega_tau. EXACT: none at all; LEVEL: v_tau, with G kept; FIVE: omega_n and
 * omega3; OMEGA_N, OMEGA3: this one, while G determines the other. */
typedef enum { ORACLE_EXACT, ORACLE_LEVEL_NOISE, ORACLE_FIVE_NOISE, ORACLE_OMEGA_N_NOISE, ORACLE_OMEGA3_NOISE } oracle_noise;

typedef struct {
    oracle_top top;
    double gamma3, v_nu, omega_tau, omega_n, omega3; /* the start */
    bool level;                                      /* v_tau and G give omega_n and omega3 of the start */
    double v_tau, G;
    int time_direction;  /* +1, -1 */
    int crossings;       /* rows at crossings of omega_tau = 0: +1 rising, -1 falling with t, 0 both */
    const double *times; /* (count,), rows at these times instead; NULL: at crossings */
    int count;           /* how many rows are wanted */
    double tolerance, speed; /* of shadows' errors; the scale of velocities */
    bool plain;              /* shadows compute s from gamma3, as methods in plain time do */
} oracle_question;

typedef struct {
    int count;    /* rows */
    oracle_end end;
    long double rows[ORACLE_ROWS_MAX + 1][ORACLE_STATES]; /* from index 1; after an end at a pole or at rest one more, the limit */
    long double pace[ORACLE_ROWS_MAX + 1]; /* at each row, the fastest rate of change of a state, in scale: 0 at rest */
    long double depth[ORACLE_ROWS_MAX + 2]; /* at crossings, the largest |omega_tau| since the crossing before, in scale */
    long double lean[ORACLE_ROWS_MAX + 1]; /* at crossings, the fastest rate of change of a state over that of omega_tau, in scale:
                                              the factor by which an error of omega_tau moves the row */
    long double least_s, least_pace; /* the least values on the way */
    long double drift;               /* the largest error of E, G and s^2 + gamma3^2 at the end, in scale */
    unsigned long steps;
} oracle_orbit;

/* Compute the orbit, or with noise other than EXACT a shadow of it. random: for shadows; else it may be NULL. */
void oracle_follow(oracle_orbit *out, const oracle_question *question, oracle_noise noise, jlt_random *random);

#endif
