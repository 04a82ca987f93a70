/** From a workspace to a straight-line program. */
#ifndef TTC_WORKSPACE_LOWER_H
#define TTC_WORKSPACE_LOWER_H

#include "fields/prepared.h"
#include "optimize/program.h"
#include "optimize/workspace.h"

/** Make the program. Products are multiplied in the order in which their factors are ready, sums are added likewise, so that chains
 *  are short. Scales go to the prepared values. NULL: memory. */
ttc_program *ttc_workspace_lower(const ttc_workspace *workspace, ttc_prepared *prepared);

/** A new program in which a product that is used once, in a sum, is one operation with it, and a
 *  reciprocal that is used once, in a product, makes a quotient. NULL: memory. */
ttc_program *ttc_program_fuse(const ttc_program *program);

#endif
