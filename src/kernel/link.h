/** Which tables serve in place of each other, by proof.
 *
 *  Two tables are linked where one claims a reduction onto, or an embedding into, the other, where this is proved, and where the
 *  table that it was proved for is this very one, by its SHA-256; and where a chain of such claims leads from one to the other. */
#ifndef JLT_KERNEL_LINK_H
#define JLT_KERNEL_LINK_H

#include <stdbool.h>

#include "kernel_abi.h"

/** Whether a chain of links leads from one table to the other; every table is linked to itself. Tables between are those built in.
 *  Out: *broken, where there is no chain: the claim of either that would link them but is not proved; NULL, there is none. */
bool jlt_link_holds(const jlt_claim **broken, const jlt_descriptor *from, const jlt_descriptor *to);

#endif
