/** From expressions to a short straight-line program on the prepared block. */
#ifndef TTC_OPTIMIZE_H
#define TTC_OPTIMIZE_H

#include "block.h"
#include "program.h"

/** The outputs, in the field's symbols, as a program on states and the prepared block, to which entries are added.
 *  other: the same functions written differently, a second place to start from; may be NULL.
 *  one_division: for all denominators that do not need each other, which is best for many states at a time; else several
 *  where they save at least four operations each, which is best for one.
 *  Returns NULL when memory is out. Cost: a fixed amount of search, seconds at most. */
ttc_program *ttc_optimize(ttc_field *field, const ttc_id *outputs, const ttc_id *other, size_t count, bool one_division,
                          ttc_block *block);

#endif
