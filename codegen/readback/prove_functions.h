/** Proofs of translation for functions other than the kernels of a field: of families of equilibria, of coordinates of sections,
 *  and
 *  of ways to tables that serve in place of its own. They are read back from the C that is emitted, word by word, and compared, as
 *  exact ratios, with what the records say; slopes with derivatives of these. */
#ifndef TTC_PROVE_FUNCTIONS_H
#define TTC_PROVE_FUNCTIONS_H

#include "kernels/catalogue.h"
#include "base/text.h"
#include "prove/prove.h"

/** Append to `report` one proof for each such function of general fields, kind "kernel", name "FIELD KIND.RECORD.FUNCTION", and
 *  update its totals. Returns false when memory is out; the report is then still valid. Cost: below a second for a table of the
 *  top. */
bool ttc_prove_functions(const ttc_catalogue *catalogue, ttc_proof_report *report);

/** The C of these functions of a general field. Returns false when memory is out. */
bool ttc_prove_functions_emit(ttc_text *text, ttc_kernels *kernels);

/** The same proofs for one general field, from that C. */
bool ttc_prove_functions_in(const char *text, const ttc_kernels *kernels, ttc_proof_report *report);

#endif
