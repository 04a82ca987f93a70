/* The harness of random tops: one random top, the cases to test with it, and their comparison with the oracle. A case depends only
 * on its seed and number. */
#ifndef JLT_TESTS_TRIAL_H
#define JLT_TESTS_TRIAL_H

#include <stdio.h>

#include "witness/top_section.h"
#include "stability/random_tops/oracle.h"

typedef struct {
    unsigned long seed, number;
    jlt_random random;
    jlt_top_values top; /* its levels have a state at q, (eta, gamma3) */
    double q[2];
    double speed;       /* scale of velocities, sqrt(2 (E + m g |a3|)/m) */
    double tolerance;
    const char *kind;
    char options[256]; /* further options of the command that reproduces the case */
} trial;

/* Counts of a run; rows: how many were compared with the oracle. */
typedef struct {
    unsigned long cases, broken, rows, ends[ORACLE_ENDS], unsure, left, spent, chaotic, along, undecided, least_steps;
    long double worst; /* largest ratio of an error to its bound */
} tally;

extern tally sum;

void trial_choose(trial *t);
oracle_top trial_top(const trial *t);

/* Count a failed case, and print how to reproduce it. */
__attribute__((format(printf, 2, 3))) void trial_complain(const trial *t, const char *format, ...);

/* An orbit and its shadows, which show how far errors of one tolerance in each step move it. */
typedef struct {
    oracle_question question;
    oracle_orbit truth, shadows[ORACLE_SHADOWS];
    long double slack; /* the error that the tested result itself admits, in scale */
    bool sound;  /* the oracle ended and kept its integrals */
    int certain; /* how many rows exist for the orbit and all shadows, and are far enough from rest and tangency */
    bool ends;   /* orbit and shadows also agree on the end after these rows */
    long double stray[ORACLE_ROWS_MAX + 2]; /* the largest distance of a shadow from the orbit up to each row, in scale */
} family;

void family_follow(family *out, trial *t, const oracle_question *question, oracle_noise noise);

/* Whether row `number` is not certain, or far from the shadows', of a top whose v_tau keeps its sign, a3 = G = 0: v_tau may fall
 * below what doubles hold, which ends the orbit, where the oracle and its shadows come back each with errors of its own. */
bool family_may_lose_v_tau(const family *f, const trial *t, int number);

/* Replace the shadows by new ones with this noise. */
void family_disturb(family *f, trial *t, oracle_noise noise);

/* A row computed by jellett: gamma3, v_nu, omega_tau, omega_n, omega3, v_tau, t; NaN for a value that it does not give. */
enum { ROW_GAMMA3, ROW_V_NU, ROW_OMEGA_TAU, ROW_OMEGA_N, ROW_OMEGA3, ROW_V_TAU, ROW_T, ROW_SIZE };

/* Compare row `number`, counted from 1, with the orbit. Returns false, after trial_complain, if its error exceeds the bound. */
bool family_check(const family *f, const trial *t, const char *how, int number, const double row[ROW_SIZE]);

/* Follow the orbit of `f` with thirty times a command's limit of steps, and compare its rows. */
void section_with_more_steps(trial *t, const family *f, const jlt_method *method, const char *how, int returns);

/* The kinds of cases. */
void case_section(trial *t);
void case_motion(trial *t);
void case_periodic(trial *t);
void case_equilibrium(trial *t);
void case_command(trial *t);

/* Run `count` cases from number `first` on, and print the counts. Returns the exit status. */
int trial_run(unsigned long seed, unsigned long count, unsigned long first);

#endif
