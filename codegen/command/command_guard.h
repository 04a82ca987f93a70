/** Proves a table's claims within bounds of time and memory, whatever the table. */
#ifndef TTC_COMMAND_GUARD_H
#define TTC_COMMAND_GUARD_H

#include "prove/prove.h"

/* Processor time for one claim; FULL where a verdict is needed even on a slow machine. */
enum { TTC_GUARD_SECONDS = 20, TTC_GUARD_SECONDS_FULL = 120 };

/** Prove every claim in a process beside this one, which may take claim_seconds > 0 of processor time for a claim, 5/2 of that
 *  for the table, and 1536 MiB. A claim whose proof passes a bound, or ends its process, is not settled, says why, and has an
 *  ending other than TTC_ENDED_BY_VERDICT.
 *  In: resolver and context as ttc_prove takes them; the worker calls them in its own copy of the memory.
 *  Returns NULL when memory is out, or no process can be made. */
ttc_proof_report *ttc_prove_guarded(const ttc_model *model, int claim_seconds, ttc_resolver resolver, void *context);

/* The same for only those claims for which `wanted` returns true. It is called before anything is proved, when name, kind and
 * place of a claim are known. Other claims are not settled in the report, unless a wanted one rests on them. */
typedef bool (*ttc_proof_filter)(void *context, const ttc_proof *proof);
ttc_proof_report *ttc_prove_some_guarded(const ttc_model *model, int claim_seconds, ttc_proof_filter wanted, void *wanted_context,
                                         ttc_resolver resolver, void *context);

#endif
