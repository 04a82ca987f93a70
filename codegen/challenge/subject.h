/** The subject of a verdict: the claim, or the record that it is derived from, the conditions of points, and the checker. */
#ifndef TTC_SUBJECT_H
#define TTC_SUBJECT_H

#include "challenge/check.h"

typedef struct {
    const ttc_claim *claim; /* NULL for a derived claim */
    uint32_t index;         /* of the claim, or of the root's symbol, variant, time, elimination, pole or observed record */
    ttc_checker checker;
    ttc_situation situation;
    bool fails_on_open_set; /* if it is false, it fails almost everywhere */
    bool refuted_by_witness; /* it is false if and only if all its witnesses are zero */
} ttc_subject;

/* Find the subject of a proof by its kind, name and place. Returns false if it cannot be challenged. */
bool ttc_subject_find(ttc_subject *subject, const ttc_model *model, const char *kind, const char *name, ttc_place place);

#endif
