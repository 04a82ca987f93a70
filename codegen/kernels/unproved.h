/** Finds the claims without a proof that a kernel rests on: such kernels are not written unless asked for, and are marked. */
#ifndef TTC_UNPROVED_H
#define TTC_UNPROVED_H

#include "base/text.h"
#include "kernels/catalogue.h"
#include "prove/prove.h"

/** Append the names of the field's kernels that rest on the claim report->proofs[proof], joined with ", ", or "all kernels" if
 *  every one does; nothing if none does. report: that of the field's own table. */
void ttc_unproved_kernels(ttc_text *text, const ttc_kernels *kernels, const ttc_proof_report *report, size_t proof);

/** Give every field of the catalogue the names of the claims that it rests on and that are not proved, "KIND NAME" joined with
 *  ", ", in the order of the report. Returns false when memory is out. */
bool ttc_catalogue_mark_unproved(ttc_catalogue *catalogue, const ttc_proof_report *report);

#endif
