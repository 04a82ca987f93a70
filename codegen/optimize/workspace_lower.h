/** Translates a workspace into a straight-line program. */
#ifndef TTC_WORKSPACE_LOWER_H
#define TTC_WORKSPACE_LOWER_H

#include "fields/prepared.h"
#include "optimize/program.h"
#include "optimize/workspace.h"

/** Make the program. Factors are multiplied, and terms added, in the order in which they are ready, so that chains are short.
 *  Scales go to the prepared values. Returns NULL when memory is out. */
ttc_program *ttc_workspace_lower(const ttc_workspace *workspace, ttc_prepared *prepared);

/** A new program in which a product used once, by an addition or subtraction, is fused with it, and a reciprocal used once, by a
 *  product, becomes a quotient. Returns NULL when memory is out. */
ttc_program *ttc_program_fuse(const ttc_program *program);

#endif
