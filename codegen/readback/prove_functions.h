/** Proofs of translation for what stands beside the kernels of a field: its families of equilibria, the coordinates of its
 *  sections, and the ways to tables that serve in place of its own. Their functions are read back from the C that is emitted for
 *  them, word by word, and what they compute is compared, as exact ratios, with what the records say; slopes with derivatives of
 *  these. */
#ifndef TTC_PROVE_FUNCTIONS_H
#define TTC_PROVE_FUNCTIONS_H

#include "kernels/catalogue.h"
#include "base/text.h"
#include "prove/prove.h"

/** Append to `report` one proof a function of the catalogue's general fields: kind "kernel", name "FIELD KIND.RECORD.FUNCTION". Its
 *  totals are brought up to date. False when memory is out; the report is then still valid. Cost: below a second for a table of the
 *  top. */
bool ttc_prove_functions(const ttc_catalogue *catalogue, ttc_proof_report *report);

/** The C of all functions of a general field. False when memory is out. */
bool ttc_prove_functions_emit(ttc_text *text, ttc_kernels *kernels);

/** The same proofs of one general field, by the C in which its functions stand. */
bool ttc_prove_functions_in(const char *text, const ttc_kernels *kernels, ttc_proof_report *report);

#endif
