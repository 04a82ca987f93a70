/** Mutants of a table: one term with its sign flipped, or dropped. A set of claims is worth something when every mutant
 *  has a claim that is refuted; a survivor names a missing claim. */
#ifndef TTC_MUTATE_H
#define TTC_MUTATE_H

#include "prove/prove.h"

typedef enum { TTC_MUTANT_REFUTED, TTC_MUTANT_SURVIVED, TTC_MUTANT_UNREADABLE /* no longer a table */ } ttc_mutant_fate;

typedef struct {
    ttc_place place;    /* of the term, in the model's text */
    const char *term;   /* the term as written, `term_length` bytes, in the model's text */
    size_t term_length;
    bool dropped;       /* otherwise its sign is flipped */
    ttc_mutant_fate fate;
    char *refuted;      /* name of the first refuted claim, or NULL */
} ttc_mutant;

typedef struct {
    ttc_mutant *mutants; /* in order of place, flipped before dropped */
    size_t count, refuted, survived, unreadable;
} ttc_mutation_report;

/** Make every mutant of the terms of equations, lets and roots, sums in parentheses included, and prove each until a claim is
 *  refuted; those of a table of coordinates until a section of its model is no longer proved. The report is the caller's.
 *  False, and no report, when memory is out. Cost: one proof a mutant. */
bool ttc_mutate(const ttc_model *model, ttc_resolver resolver, void *context, ttc_mutation_report **report);
void ttc_mutation_report_destroy(ttc_mutation_report *report); /* legal on NULL */

#endif
