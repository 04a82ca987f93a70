/** From expressions to a short straight-line program on the prepared block. */
#ifndef TTC_OPTIMIZE_H
#define TTC_OPTIMIZE_H

#include "block.h"
#include "program.h"

/** The outputs, in the field's symbols, as a program on states and the prepared block, to which entries are added.
 *  Returns NULL when memory is out. */
ttc_program *ttc_optimize(ttc_field *field, const ttc_id *outputs, size_t count, ttc_block *block);

#endif
