/** Computes one equilibrium of a table with its spectrum: completes it from its family or finds it by Newton's method, checks it,
 *  and linearizes the field at exact values. */
#ifndef JLT_SPECTRUM_EQUILIBRIUM_H
#define JLT_SPECTRUM_EQUILIBRIUM_H

#include "analysis/linearization.h"
#include "kernel/region.h"
#include "spectrum/oracle.h"

#include <stdbool.h>

typedef struct {
    const jlt_descriptor *descriptor; /* a general field of at most JLT_LINEARIZATION_SIZE_MAX states */
    jlt_oracle *oracle;               /* oracle of the descriptor's table */
    const char **params;              /* shape (params,): the exact value "p/q"; NULL where the double is exact */
    const char *x[JLT_LINEARIZATION_SIZE_MAX];        /* the same for states */
    unsigned char given[JLT_LINEARIZATION_SIZE_MAX];  /* 1 for states that the caller gives and the family must not set */
    bool find;                                        /* the states are a guess: search for an equilibrium nearby */
    size_t order[JLT_LINEARIZATION_SIZE_MAX], held;   /* states to hold in the search, the most important first; their number */
    bool fast;                                        /* doubles are enough: compute no balls */
    bool proved_only; /* what balls prove is enough: eigenvalues in doubles, and their differences by several routes, are computed
                       * only where balls settle nothing */
    long digits;                                      /* decimal digits of the texts to make; 0: none */
} jlt_equilibrium_question;

/* The step at which `status` arose. */
typedef enum {
    JLT_EQUILIBRIUM_PARAMS, /* check of the table's conditions on parameters */
    JLT_EQUILIBRIUM_STATES, /* check of the intervals of states */
    JLT_EQUILIBRIUM_DOMAIN, /* check of the conditions of the table's domain */
    JLT_EQUILIBRIUM_SEARCH, /* Newton's method, if `find` is set */
    JLT_EQUILIBRIUM_POINT,  /* linearization in doubles; also if `status` is JLT_OK */
    JLT_EQUILIBRIUM_DIGITS  /* linearization in balls */
} jlt_equilibrium_stage;

typedef struct {
    jlt_status status; /* EMPTY at stage POINT: x is no equilibrium, and only the residual is computed */
    jlt_equilibrium_stage stage;
    size_t index;      /* index of the parameter or state that the table does not allow */
    const jlt_region *region; /* the condition of the domain that does not hold; NULL if memory is out */
    double region_value;
    jlt_linearization result;
} jlt_equilibrium;

/** Compute the equilibrium at these parameters, shape (param_count,), and states, shape (state_count,). x is completed and, if
 *  `find` is set, moved to the equilibrium. Numbers and verdict are those of jlt_linearization_enclose. If enclosing fails, that
 *  is an error if digits were asked for; otherwise the numbers are those of doubles, and the verdict is undecided. With `fast`,
 *  numbers and verdict are those of doubles, and not proved. The caller passes out->result.texts to jlt_ball_texts_destroy. */
void jlt_equilibrium_compute(jlt_equilibrium *out, const jlt_equilibrium_question *question, double *params, double *x);

#endif
