/** Many orbits seen through a surface of section: followed at once on batched kernels, one a lane, and then read one after another
 *  as those of a jlt_section are.
 *
 *      JLT_TRY(jlt_section_batch_run(batch, q, count, returns));
 *      for (size_t i = 0; i < jlt_section_batch_begun(batch); i++) {
 *          JLT_TRY(jlt_section_batch_start(batch, &row, i));
 *          while (row.fate == JLT_FATE_ALIVE && row.number < returns) JLT_TRY(jlt_section_batch_next(batch, &row));
 *      }
 *
 *  Where a lane ends early, near a pole above all, its orbit goes on one at a time with the flow's method from its last return when
 *  it is read, so that fates are found as a jlt_section finds them; so does one that has all but come to rest. The least reaction
 *  in a row is that of the returns, and not of the steps between them. Rows do not depend on the orbits beside them or on the
 *  number of threads. */
#ifndef JLT_DYNAMICS_SECTION_BATCH_H
#define JLT_DYNAMICS_SECTION_BATCH_H

#include "dynamics/section.h"
#include "integrate/batch.h"

typedef struct {
    unsigned threads; /* 0 and 1: the caller's alone */
    unsigned project; /* integrals of the kernels, and the relation of a root, that are restored at crossings; 0: none */
    /* Told how many returns have been made since the run began, by all threads; NULL: nobody. */
    void (*progress)(void *context, size_t returns);
    void *context;
} jlt_section_batch_options;

typedef struct jlt_section_batch jlt_section_batch;

/** kernels: those of the flow's field. Everything must live on. Forwards in time alone.
 *  Errors: as jlt_section_create; UNSUPPORTED, the flow asks for a section other than STATE = 0, for the end where the model no longer holds,
 *  or for an end in time; NOMEM. */
JLT_CHECKED jlt_status jlt_section_batch_create(jlt_section_batch **out, const jlt_flow *flow, const jlt_kernel_batch *kernels,
                                                const jlt_section_batch_options *options);
void jlt_section_batch_destroy(jlt_section_batch *self); /* NULL is legal */

/** Follow the orbits from starts q (count, dim) on the section for so many returns; what was there before is forgotten. An
 *  interrupt ends it early, with OK. Errors: ARG; as jlt_batch_section; IO, the temporary file.
 *  Memory: count * min(returns, 1024) rows, 256 MiB or a row each at most; older rows wait in a temporary file (core/spool.h). */
JLT_CHECKED jlt_status jlt_section_batch_run(jlt_section_batch *self, const double *q, size_t count, size_t returns);

/** Orbits with a number below are there to be read: all, but after an interrupt none beyond the last that has a return. */
size_t jlt_section_batch_begun(const jlt_section_batch *self);

/** Read an orbit from its start on, number 0. Errors: as the chart's lift. */
JLT_CHECKED jlt_status jlt_section_batch_start(jlt_section_batch *self, jlt_return *row, size_t orbit);

/** Its next return, or the end, as jlt_section_next. Errors: IO; as jlt_section_next. */
JLT_CHECKED jlt_status jlt_section_batch_next(jlt_section_batch *self, jlt_return *row);

#endif
