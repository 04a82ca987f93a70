/** Proofs of translation for the functions beside the kernels of a field: of its families of equilibria, of the coordinates of its
 *  sections, and of the ways to tables that serve in place of its own. The functions are read back from the C that is emitted for
 *  them, word by word, and compared, as exact ratios, with what the records say; slopes are compared with derivatives of these. */
#ifndef TTC_PROVE_FUNCTIONS_H
#define TTC_PROVE_FUNCTIONS_H

#include "kernels/catalogue.h"
#include "base/text.h"
#include "prove/prove.h"

/** Append to `report` one proof for each such function of the catalogue's general fields: kind "kernel", name
 *  "FIELD KIND.RECORD.FUNCTION"; update its totals. Returns false when memory is out; the report is then still valid. Cost: below a
 *  second for a table of the top. */
bool ttc_prove_functions(const ttc_catalogue *catalogue, ttc_proof_report *report);

/** The C of all these functions of a general field. Returns false when memory is out. */
bool ttc_prove_functions_emit(ttc_text *text, ttc_kernels *kernels);

/** The same proofs for one general field, from the C text of its functions. */
bool ttc_prove_functions_in(const char *text, const ttc_kernels *kernels, ttc_proof_report *report);

#endif
