/** Mutants of a table, in which the sign of one term is flipped or the term is dropped. They test a set of claims: a mutant of
 *  which no claim is refuted, a survivor, shows that a claim is missing. */
#ifndef TTC_MUTATE_H
#define TTC_MUTATE_H

#include "prove/prove.h"

typedef enum { TTC_MUTANT_REFUTED, TTC_MUTANT_SURVIVED, TTC_MUTANT_UNREADABLE /* has errors */ } ttc_mutant_fate;

typedef struct {
    ttc_place place;    /* of the term, in the model's text */
    const char *term;   /* the term as written, `term_length` bytes, in the model's text */
    size_t term_length;
    bool dropped;       /* otherwise its sign is flipped */
    ttc_mutant_fate fate;
    char *refuted;      /* name of the first refuted claim, or NULL */
} ttc_mutant;

typedef struct {
    ttc_mutant *mutants; /* in order of place; of each term first the flipped, then the dropped one */
    size_t count, refuted, survived, unreadable;
    char *broken; /* a claim that is refuted of the table itself, so that mutants would tell nothing, and none is made; else NULL */
} ttc_mutation_report;

/** Make every mutant of the terms of equations, lets and roots, sums in parentheses included, and prove the claims of each until
 *  one is refuted; for a table of coordinates, until a section of its model is no longer proved. Terms of `observe` have no
 *  mutants. The caller owns the report. Returns false, and no report, when memory is out. Cost: one proof of the table for each
 *  mutant. */
bool ttc_mutate(const ttc_model *model, ttc_resolver resolver, void *context, ttc_mutation_report **report);
void ttc_mutation_report_destroy(ttc_mutation_report *report); /* legal on NULL */

#endif
