/** The return map of a section, as jlt_transfer_build asks for it: many orbits at once, each for one return. Its space is where
 *  the section is crossed in the flow's direction. */
#ifndef JLT_ANALYSIS_TRANSFER_SECTION_H
#define JLT_ANALYSIS_TRANSFER_SECTION_H

#include "analysis/transfer.h"
#include "dynamics/failures.h"
#include "dynamics/section_batch.h"
#include "dynamics/system.h"

/* Kinds of loss: 0, an image outside the boxes; jlt_fate, an orbit that ended; and a return on another branch of a chart that
 * solves for states. */
enum { JLT_TRANSFER_SECTION_BRANCH = JLT_FATE_COUNT, JLT_TRANSFER_SECTION_LOSSES };

typedef struct jlt_transfer_section jlt_transfer_section;

/** Create it. system and batch, one of this system with last_only, must live as long. Where the system's table claims an
 *  invariant density at its parameters, the map has it: with the field f and density rho the return map keeps rho |flux of f|.
 *  Errors: NOMEM; as jlt_instance_create. */
JLT_CHECKED jlt_status jlt_transfer_section_create(jlt_transfer_section **out, const jlt_system *system, jlt_section_batch *batch);
void jlt_transfer_section_destroy(jlt_transfer_section *self); /* NULL is legal */

/** The map; self must live as long. */
jlt_transfer_map jlt_transfer_section_map(jlt_transfer_section *self);

/** The density's name in its table; NULL: there is none. */
const char *jlt_transfer_section_density(const jlt_transfer_section *self);

/** The orbits on which the method has failed; valid as long as self. */
const jlt_failures *jlt_transfer_section_failures(const jlt_transfer_section *self);

/** Masses in the mirror image, under the reversor, of each box: masses that stay become those of the inverse map. In: v, shape
 *  (transfer->count,). Out: mirrored, the same shape, 0 for a box whose mirror image is none of those kept. False: the section has
 *  no reversor. */
bool jlt_transfer_section_mirror(double *mirrored, const jlt_transfer *transfer, const double *v, const jlt_chart *chart);

#endif
