/** Finds the claims without a proof that a kernel rests on: such kernels are not written unless asked for, and are marked. */
#ifndef TTC_UNPROVED_H
#define TTC_UNPROVED_H

#include "base/text.h"
#include "kernels/catalogue.h"
#include "prove/prove.h"

/** Append the field's kernels that rest on the claim report->proofs[proof], joined with ", ", or "all kernels"; nothing if none
 *  does. report: of the field's own table. */
void ttc_unproved_kernels(ttc_text *text, const ttc_kernels *kernels, const ttc_proof_report *report, size_t proof);

/** Give every field the names of the unproved claims that it rests on, "KIND NAME" joined with ", ", in the order of the report.
 *  Returns false when memory is out. */
bool ttc_catalogue_mark_unproved(ttc_catalogue *catalogue, const ttc_proof_report *report);

#endif
