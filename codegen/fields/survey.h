/** What expressions divide by, and the roots in them, through units and functions. */
#ifndef TTC_SURVEY_H
#define TTC_SURVEY_H

#include "fields/field.h"

typedef struct {
    const ttc_field *field;
    size_t size; /* of the field's graph, in ids, as the survey was made */
    unsigned char *seen, *denominator, *root; /* by id */
} ttc_survey;

/** Returns false when memory is out; clear in either case. */
bool ttc_survey_init(ttc_survey *out, const ttc_field *field);
void ttc_survey_clear(ttc_survey *survey);

/* Add what an expression, in the field's symbols, contains. */
void ttc_survey_add(ttc_survey *survey, ttc_id expression);

#endif
