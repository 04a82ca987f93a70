/* One random top, and what a case of the harness does with it. A case depends on its seed and number alone. */
#ifndef JLT_TESTS_TRIAL_H
#define JLT_TESTS_TRIAL_H

#include <stdio.h>

#include "witness/top_section.h"
#include "stability/random_tops/oracle.h"

typedef struct {
    unsigned long seed, number;
    jlt_random random;
    jlt_top_values top; /* with levels that have a state at q */
    double q[2];
    double speed;       /* scale of velocities, sqrt(2 (E + m g |a3|)/m) */
    double tolerance;
    const char *kind;
    char options[256]; /* more of the command that shows it */
} trial;

/* What a run has done; rows are what was held against the oracle. */
typedef struct {
    unsigned long cases, broken, rows, ends[ORACLE_ENDS], unsure, left, spent, chaotic, along, undecided, least_steps;
    long double worst; /* error over its bound */
} tally;

extern tally sum;

void trial_choose(trial *t);
oracle_top trial_top(const trial *t);

/* Counts it, and says how to see it again. */
__attribute__((format(printf, 2, 3))) void trial_complain(const trial *t, const char *format, ...);

/* An orbit, and its shadows: how far errors of one tolerance a step lead away. */
typedef struct {
    oracle_question question;
    oracle_orbit truth, shadows[ORACLE_SHADOWS];
    long double slack; /* what rows are off by their own word, in scale */
    bool sound;  /* the oracle kept its integrals */
    int certain; /* rows on which all of them agree that they exist */
    bool ends;   /* they agree on the end after these rows, too */
    long double stray[ORACLE_ROWS_MAX + 2]; /* of any shadow up to that row, in scale */
} family;

void family_follow(family *out, trial *t, const oracle_question *question, oracle_noise noise);

/* Other shadows of the same orbit. */
void family_disturb(family *f, trial *t, oracle_noise noise);

/* A row of jellett's: gamma3, v_nu, omega_tau, omega_n, omega3, v_tau, t; NaN where it is not told. */
enum { ROW_GAMMA3, ROW_V_NU, ROW_OMEGA_TAU, ROW_OMEGA_N, ROW_OMEGA3, ROW_V_TAU, ROW_T, ROW_SIZE };

/* Holds row `number` (from 1) against the orbit. False: it is wrong, and was complained of. */
bool family_check(const family *f, const trial *t, const char *how, int number, const double row[ROW_SIZE]);

/* Follows the orbit of `f` with thirty times the steps that a command has, and holds its rows. */
void section_with_more_steps(trial *t, const family *f, const jlt_method *method, const char *how, int returns);

/* The kinds of cases. */
void case_section(trial *t);
void case_motion(trial *t);
void case_periodic(trial *t);
void case_equilibrium(trial *t);
void case_command(trial *t);

/* Does `count` cases from `first`, prints what it did; the exit status. */
int trial_run(unsigned long seed, unsigned long count, unsigned long first);

#endif
