/** What a verdict is about: the claim, or the record that it is derived from, what points must meet, and what is looked at. */
#ifndef TTC_SUBJECT_H
#define TTC_SUBJECT_H

#include "challenge/check.h"

typedef struct {
    const ttc_claim *claim; /* NULL for what is derived */
    uint32_t index;         /* of the claim; of the root's symbol, the variant, time, elimination or observed record */
    ttc_checker checker;
    ttc_situation situation;
    bool fails_on_open_set; /* where it is false, it is false almost everywhere */
    bool refuted_by_witness; /* it is false when nothing differs from zero */
} ttc_subject;

/* Find what a proof is about by its kind, name and place. False when that cannot be challenged. */
bool ttc_subject_find(ttc_subject *subject, const ttc_model *model, const char *kind, const char *name, ttc_place place);

#endif
