/** Proofs of a table's claims within bounds of time and memory, whatever the table. */
#ifndef TTC_COMMAND_GUARD_H
#define TTC_COMMAND_GUARD_H

#include "prove/prove.h"

/** Prove every claim in a process beside this one: 20 s of processor time a claim, 50 s a table, 1536 MiB. What
 *  passes a bound, or ends its process, is not settled, says so, and has an ending other than TTC_ENDED_BY_VERDICT.
 *  In: resolver and context as ttc_prove takes them; the worker calls them in its own copy of the memory.
 *  times: so many times the seconds, at least 1, where a verdict is waited for, whatever the machine.
 *  NULL: memory is out, or no process can be made. */
ttc_proof_report *ttc_prove_guarded(const ttc_model *model, int times, ttc_resolver resolver, void *context);

#endif
