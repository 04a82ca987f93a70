/** From a system to a straight-line program. */
#ifndef TTC_SYSTEM_LOWER_H
#define TTC_SYSTEM_LOWER_H

#include "fields/block.h"
#include "optimize/program.h"
#include "optimize/system.h"

/** Products are multiplied in the order in which their factors are ready, sums are added likewise, so that chains are
 *  short. Scales go to the block. NULL: memory. */
ttc_program *ttc_system_lower(const ttc_system *system, ttc_block *block);

/** A new program in which a product that is used once, in a sum, is one operation with it, and a
 *  reciprocal that is used once, in a product, makes a quotient. NULL: memory. */
ttc_program *ttc_program_fuse(const ttc_program *program);

#endif
