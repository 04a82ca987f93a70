/** Draws random points of a family of equilibria, or of the whole domain, and encloses in balls all expressions that are compared
 *  there. */
#ifndef JLT_CLAIMS_SAMPLE_H
#define JLT_CLAIMS_SAMPLE_H

#include "analysis/deflation.h"
#include "claims/verify.h"
#include "kernel/descriptor.h"

enum { JLT_SAMPLE_STATES_MAX = JLT_DEFLATION_SIZE_MAX, JLT_SAMPLE_PARAMS_MAX = JLT_DESCRIPTOR_VALUES_MAX };

typedef struct {
    double params[JLT_SAMPLE_PARAMS_MAX], x[JLT_SAMPLE_STATES_MAX];
    ttc_enclosure jacobian[JLT_SAMPLE_STATES_MAX * JLT_SAMPLE_STATES_MAX], trace, field[JLT_SAMPLE_STATES_MAX];
    ttc_enclosure gradient[JLT_SAMPLE_STATES_MAX * JLT_SAMPLE_STATES_MAX];
    double majorant[JLT_SAMPLE_STATES_MAX * JLT_SAMPLE_STATES_MAX]; /* of each Jacobian entry, the sum of the moduli of its terms:
                                                                     * max(rounding / 2^-53, |entry|) */
} jlt_sample;

/* A family, its claim, and the expressions that are enclosed at every sample; all NULL: the whole domain. */
typedef struct {
    const jlt_equilibria *family;
    const ttc_claim *claim;
    ttc_id *gradients; /* shape (left_null_count, n), owned */
} jlt_sample_subject;

/** Errors: NOMEM; UNSUPPORTED if the embedded table lacks a claim of the family, which means that the build is broken. */
JLT_CHECKED jlt_status jlt_sample_subject_init(jlt_sample_subject *subject, const jlt_verify_run *run,
                                               const jlt_equilibria *family);
void jlt_sample_subject_clear(jlt_sample_subject *subject);

/* Draw sample number `number` inside the domain; number mod 4 selects defaults, moderate values, extreme values, or states near
 * the ends of their intervals; after 500 attempts all are moderate. On the whole domain, each variant of the table's own field has
 * its turn. Returns false if 1000 attempts give none. */
bool jlt_sample_draw(jlt_sample *sample, jlt_verify_run *run, const jlt_sample_subject *subject, size_t number);

/** Enclose all expressions of the subject at the sample. Errors: those of jlt_oracle_estimate. */
JLT_CHECKED jlt_status jlt_sample_enclose(jlt_sample *sample, jlt_verify_run *run,
                                                 const jlt_sample_subject *subject);

#endif
