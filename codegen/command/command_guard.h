/** Proofs of a table's claims within bounds of time and memory, whatever the table. */
#ifndef TTC_COMMAND_GUARD_H
#define TTC_COMMAND_GUARD_H

#include "prove/prove.h"

/** Every claim in a process beside this one: 20 s a claim, 50 s a table, 1536 MiB. What passes a bound is not settled, and says so.
 *  NULL: memory is out, or no process can be made. */
ttc_proof_report *ttc_prove_guarded(const ttc_model *model);

#endif
