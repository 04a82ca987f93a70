/** Proves a table's claims within bounds of time and memory, whatever the table. */
#ifndef TTC_COMMAND_GUARD_H
#define TTC_COMMAND_GUARD_H

#include "prove/prove.h"

/* Processor time for a claim; FULL where a verdict is needed on any machine. */
enum { TTC_GUARD_SECONDS = 20, TTC_GUARD_SECONDS_FULL = 120 };

/* The remainder of a proof with TTC_ENDED_BY_SYSTEM. */
#define TTC_GUARD_BY_SYSTEM "its proof was ended by the system, where memory or processor time is out"

/* MiB that a process which proves claims may take: 1536, or what this process may, where that is less. */
unsigned ttc_guard_memory(void);

/* Seconds of processor time that it may take, with claim_seconds a claim: 5/2 as many, or what this process may, where that is
 * less. */
unsigned ttc_guard_processor(int claim_seconds);

/** Prove every claim in a child process, with claim_seconds > 0 of processor time a claim, 5/2 as many a table, and
 *  memory as above. A claim that passes a bound, or ends its process, is not settled, says why, and has an ending other than
 *  TTC_ENDED_BY_VERDICT. A claim that is proved is challenged at some points (challenge/challenge.h) before it is called so.
 *  In: resolver and context as ttc_prove takes them; the worker calls them in its own copy of the memory.
 *  Returns NULL when memory is out, or no process can be made. */
ttc_proof_report *ttc_prove_guarded(const ttc_model *model, int claim_seconds, ttc_resolver resolver, void *context);

/* The same for those claims alone for which `wanted` returns true; it is called before anything is proved, when name, kind and
 * place are known. Others are not settled in the report, unless one of these rests on them. */
typedef bool (*ttc_proof_filter)(void *context, const ttc_proof *proof);
ttc_proof_report *ttc_prove_some_guarded(const ttc_model *model, int claim_seconds, ttc_proof_filter wanted, void *wanted_context,
                                         ttc_resolver resolver, void *context);

#endif
