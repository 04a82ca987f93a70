/** The return map of a section as the map of a transfer operator: maps many points at once by one return each. Its space is the
 *  part of the section that the flow crosses in its direction. */
#ifndef JLT_ANALYSIS_TRANSFER_SECTION_H
#define JLT_ANALYSIS_TRANSFER_SECTION_H

#include "analysis/transfer.h"
#include "dynamics/failures.h"
#include "dynamics/section_batch.h"
#include "dynamics/system.h"

/* Kinds of loss: 0, an image outside the boxes; a jlt_fate, an orbit that ended; and a return on another branch of a chart that
 * solves for states. */
enum { JLT_TRANSFER_SECTION_BRANCH = JLT_FATE_COUNT, JLT_TRANSFER_SECTION_LOSSES };

typedef struct jlt_transfer_section jlt_transfer_section;

/** Create the map. system, and batch, which must be one of this system with last_only, must outlive it. If the system's table
 *  claims an invariant density rho at its parameters, the return map preserves the density rho |flux of f| for the field f.
 *  Errors: NOMEM; as jlt_instance_create. */
JLT_CHECKED jlt_status jlt_transfer_section_create(jlt_transfer_section **out, const jlt_system *system, jlt_section_batch *batch);
void jlt_transfer_section_destroy(jlt_transfer_section *self); /* NULL is legal */

/** The map, for jlt_transfer_build; self must outlive it. */
jlt_transfer_map jlt_transfer_section_map(jlt_transfer_section *self);

/** The name of the claimed density in its table; NULL if there is none. */
const char *jlt_transfer_section_density(const jlt_transfer_section *self);

/** The orbits on which the integration failed; valid as long as self. */
const jlt_failures *jlt_transfer_section_failures(const jlt_transfer_section *self);

/** Mirror masses by the reversor: stationary masses become those of the inverse map. In: v, shape (transfer->count,). Out:
 *  mirrored, the same shape, 0 for a box whose mirror image is not kept. Returns false without a reversor. */
bool jlt_transfer_section_mirror(double *mirrored, const jlt_transfer *transfer, const double *v, const jlt_chart *chart);

#endif
