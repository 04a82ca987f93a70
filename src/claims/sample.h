/** Points of a family of equilibria, drawn at random, with all that is compared there enclosed in balls. */
#ifndef JLT_CLAIMS_SAMPLE_H
#define JLT_CLAIMS_SAMPLE_H

#include "analysis/deflation.h"
#include "claims/verify.h"

enum { JLT_SAMPLE_STATES_MAX = JLT_DEFLATION_SIZE_MAX, JLT_SAMPLE_PARAMS_MAX = 256 };

typedef struct {
    double params[JLT_SAMPLE_PARAMS_MAX], x[JLT_SAMPLE_STATES_MAX];
    ttc_enclosure jacobian[JLT_SAMPLE_STATES_MAX * JLT_SAMPLE_STATES_MAX], trace, field[JLT_SAMPLE_STATES_MAX];
    ttc_enclosure gradient[JLT_SAMPLE_STATES_MAX * JLT_SAMPLE_STATES_MAX];
    double majorant[JLT_SAMPLE_STATES_MAX * JLT_SAMPLE_STATES_MAX]; /* of each entry, cancellation undone: rounding / 2^-53,
                                                                     * at least |entry| */
} jlt_sample;

/* A family with the expressions that are enclosed at every sample. */
typedef struct {
    const jlt_equilibria *family;
    const ttc_claim *claim;
    ttc_id *gradients; /* shape (left_null_count, n), owned */
} jlt_sample_subject;

/** Errors: NOMEM; UNSUPPORTED when the embedded table lacks a claim of the family, which says that the build is broken. */
JLT_CHECKED jlt_status jlt_sample_subject_init(jlt_sample_subject *subject, const jlt_verify_run *run,
                                               const jlt_equilibria *family);
void jlt_sample_subject_clear(jlt_sample_subject *subject);

/* Sample number `number` inside the domain: moderate and extreme ones in turn. False when none comes up. */
bool jlt_sample_draw(jlt_sample *sample, jlt_verify_run *run, const jlt_sample_subject *subject, size_t number);

/** Enclose everything there. Errors: those of jlt_oracle_estimate. */
JLT_CHECKED jlt_status jlt_sample_enclose(jlt_sample *sample, jlt_verify_run *run,
                                                 const jlt_sample_subject *subject);

#endif
