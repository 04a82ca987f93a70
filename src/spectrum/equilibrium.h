/** One equilibrium of a table with its spectrum: completed from its family or found by Newton's method, checked, and linearized
 *  at exact values. */
#ifndef JLT_SPECTRUM_EQUILIBRIUM_H
#define JLT_SPECTRUM_EQUILIBRIUM_H

#include "analysis/linearization.h"
#include "kernel/region.h"
#include "spectrum/oracle.h"

#include <stdbool.h>

typedef struct {
    const jlt_descriptor *descriptor; /* general field, of JLT_LINEARIZATION_SIZE_MAX states at most */
    jlt_oracle *oracle;               /* of its table */
    const char **params;              /* shape (params,): "p/q" where that counts and not the double it was rounded to; NULL */
    const char *x[JLT_LINEARIZATION_SIZE_MAX];        /* the same of states */
    unsigned char given[JLT_LINEARIZATION_SIZE_MAX];  /* states that the family must not set */
    bool find;                                        /* the states are a guess: an equilibrium nearby is meant */
    size_t order[JLT_LINEARIZATION_SIZE_MAX], held;   /* the states given, in order of importance */
    bool fast;                                        /* doubles are enough */
    long digits;                                      /* of texts; 0: none */
} jlt_equilibrium_question;

/* The step at which `status` arose. */
typedef enum {
    JLT_EQUILIBRIUM_PARAMS, /* the table's conditions on parameters */
    JLT_EQUILIBRIUM_STATES, /* intervals of the states */
    JLT_EQUILIBRIUM_DOMAIN, /* conditions of the table's domain */
    JLT_EQUILIBRIUM_SEARCH, /* Newton's method, where `find` is asked */
    JLT_EQUILIBRIUM_POINT,  /* the linearization in doubles; also where `status` is JLT_OK */
    JLT_EQUILIBRIUM_DIGITS  /* the linearization in balls */
} jlt_equilibrium_stage;

typedef struct {
    jlt_status status; /* of a point EMPTY: it is no equilibrium, and only the residual is there */
    jlt_equilibrium_stage stage;
    size_t index;      /* of the parameter or state that the table does not allow */
    const jlt_region *region; /* of its domain, the condition that does not hold, NULL where memory is out */
    double region_value;
    jlt_linearization result;
} jlt_equilibrium;

/** The equilibrium at these parameters, shape (param_count,), and states, shape (state_count,), both changed in place, as
 *  jlt_linearization_enclose gives it. Where enclosing fails it is an error if digits were asked for; otherwise the numbers are
 *  those of doubles, and the verdict is open. Where doubles are enough (`fast`) the verdict is theirs, and not proved. The caller
 *  gives out->result.texts to jlt_ball_texts_destroy. */
void jlt_equilibrium_compute(jlt_equilibrium *out, const jlt_equilibrium_question *question, double *params, double *x);

#endif
