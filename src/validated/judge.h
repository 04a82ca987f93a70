/** What the outcome of a proof means for its certificate: the verdict, and, unless it is GOOD, the reason in words. */
#ifndef JLT_VALIDATED_JUDGE_H
#define JLT_VALIDATED_JUDGE_H

#include "validated/certificate.h"
#include "validated/elliptic.h"
#include "validated/homoclinic.h"

/** A report of this verdict, with a copy of the reason; "" for GOOD. */
jlt_certificate_report jlt_judge_say(jlt_certificate_verdict verdict, const char *problem);

/** The proof could not be carried out. */
jlt_certificate_report jlt_judge_failure(jlt_status status);

/** jlt_judge_failure of a proof that follows an orbit: one that may leave the table's domain, or miss the section, is refused. */
jlt_certificate_report jlt_judge_failure_along(jlt_status status);

/** Whether the orbit, y of shape (legs, unknowns), is proved to lie in the boxes as `legs` writes them, which may differ by
 *  rounding from those of the proof. */
jlt_certificate_report jlt_judge_boxes(const json_t *legs, const jlt_given *given, arb_srcptr y);

/** Whether the cycle is what a certificate of this kind says, as far as its multipliers tell. */
jlt_certificate_report jlt_judge_cycle(const jlt_cycle_result *result, const char *kind);

jlt_certificate_report jlt_judge_symmetry(const jlt_symmetry_result *result);
jlt_certificate_report jlt_judge_elliptic(const jlt_elliptic_result *result, const arb_t trace);
jlt_certificate_report jlt_judge_homoclinic(const jlt_homoclinic_result *result);

#endif
