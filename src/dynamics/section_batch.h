/** Follows many orbits through a surface of section at once, in lanes of vectors and on threads; they are then read one after
 *  another, like those of a jlt_section.
 *
 *      JLT_TRY(jlt_section_batch_run(batch, q, count, returns));
 *      for (size_t i = 0; i < jlt_section_batch_begun(batch); i++) {
 *          JLT_TRY(jlt_section_batch_start(batch, &row, i));
 *          while (row.fate == JLT_FATE_ALIVE && row.number < returns) JLT_TRY(jlt_section_batch_next(batch, &row));
 *      }
 *
 *  A lane ends early near a pole, where a state comes to an end of its interval, or when its orbit has all but come to rest. The
 *  flow's own method then follows that orbit on alone, so that its fate is the one that a jlt_section finds; it follows all orbits
 *  where lanes do not serve (jlt_section_flows_obstacle). Rows depend neither on the other orbits nor on the number of threads.
 *  Orbits of several flows, such as those of one model under different parameters, go side by side: jlt_section_batch_add. */
#ifndef JLT_DYNAMICS_SECTION_BATCH_H
#define JLT_DYNAMICS_SECTION_BATCH_H

#include "dynamics/section.h"
#include "integrate/batch.h"

typedef struct {
    unsigned threads; /* 0 and 1: the caller's alone */
    const jlt_instance *project; /* the flow's instance: lanes restore its integrals, and the relation of a root, at crossings;
                                    NULL: they do not. Orbits that go alone are put back onto the levels of flow->kept */
    bool backwards;   /* in time */
    bool watches;     /* the model's conditions: `least` is <= 0 where one has broken, but the least value only if the flow
                         seeks_least */
    bool last_only;   /* orbits are read by jlt_section_batch_last alone: no other rows are kept */
    /* Called with the number of returns made since the run began, by all threads; NULL: not called. */
    void (*progress)(void *context, size_t returns);
    void *context;
} jlt_section_batch_options;

typedef struct jlt_section_batch jlt_section_batch;

/** Create a batch. kernels: those of the flow's field, flow->field->batch, which need not be the table's that was asked for; NULL:
 *  all orbits go alone, by the flow's method. options: NULL for all defaults. What the flow points to must live as long as the
 *  batch. Errors: as jlt_section_create; ARG, kernels of another field; NOMEM. */
JLT_CHECKED jlt_status jlt_section_batch_create(jlt_section_batch **out, const jlt_flow *flow, const jlt_kernel_batch *kernels,
                                                const jlt_section_batch_options *options);
void jlt_section_batch_destroy(jlt_section_batch *self); /* NULL is legal */
JLT_OWNED_TYPE(jlt_section_batch)

/** Add a flow, whose orbits jlt_section_batch_run_each follows beside those of the others. It may differ from the first in
 *  parameters, levels and units alone. project: its instance if options.project is given, else NULL. What it points to must live as
 *  long. Out: *index, unless NULL: 1, 2, ...; the flow of creation is 0. Errors: ARG, it differs in more; NOMEM. */
JLT_CHECKED jlt_status jlt_section_batch_add(jlt_section_batch *self, size_t *index, const jlt_flow *flow,
                                             const jlt_instance *project);

/** Follow the orbits from starts q, shape (count, dim), on the section for `returns` returns each; the orbits of an earlier run
 *  are dropped. An interrupt ends the run early, with OK. Errors: ARG; as jlt_batch_section; IO, the temporary file.
 *  Memory: some 24 states + 100 bytes an orbit, and unless last_only count * min(returns, 1024) rows, 256 MiB or a row each at
 *  most; older rows wait in a temporary file (core/spool.h). */
JLT_CHECKED jlt_status jlt_section_batch_run(jlt_section_batch *self, const double *q, size_t count, size_t returns);

/** The same with orbit i under the flow of index flow_of[i], shape (count,), and for each[i] returns, 1 to `returns`, shape
 *  (count,). NULL: under the first flow; for `returns`. Orbits of one flow are best put next to each other.
 *  Errors: as above; ARG, no such flow, or another number of returns. */
JLT_CHECKED jlt_status jlt_section_batch_run_each(jlt_section_batch *self, const double *q, const size_t *flow_of,
                                                  const size_t *each, size_t count, size_t returns);

/** How many orbits, from the first on, can be read: all of them, or after an interrupt those up to the last that has a
 *  return. */
size_t jlt_section_batch_begun(const jlt_section_batch *self);

/** Begin to read an orbit: *row is its start, number 0. Errors: ARG, there is no such orbit; as the chart's lift. */
JLT_CHECKED jlt_status jlt_section_batch_start(jlt_section_batch *self, jlt_return *row, size_t orbit);

/** Read its next return, or its end, as jlt_section_next. Errors: ARG, last_only; IO, the temporary file; as jlt_section_next. */
JLT_CHECKED jlt_status jlt_section_batch_next(jlt_section_batch *self, jlt_return *row);

/** The last row of an orbit: its end, or the last of its returns. Errors: as jlt_section_batch_start. */
JLT_CHECKED jlt_status jlt_section_batch_last(jlt_section_batch *self, jlt_return *row, size_t orbit);

#endif
