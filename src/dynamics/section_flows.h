/** The flows whose orbits a batch follows side by side (dynamics/section_batch.h), and the sections by which threads follow and
 *  read these orbits one at a time. */
#ifndef JLT_DYNAMICS_SECTION_FLOWS_H
#define JLT_DYNAMICS_SECTION_FLOWS_H

#include "dynamics/section.h"
#include "integrate/batch.h"

/* One thread's section and the flow it follows. */
typedef struct {
    jlt_section *section;
    size_t flow; /* index of the section's flow */
} jlt_section_flows_thread;

/* One flow. */
typedef struct {
    jlt_flow flow;
    const jlt_instance *project; /* its instance, where lanes restore integrals; NULL: they do not */
    double unit[JLT_BATCH_STATES_MAX]; /* its conditions take the states of lanes times these */
} jlt_section_flows_entry;

/* All zero: no flows. */
typedef struct {
    jlt_section_flows_entry *all; /* (count,), owned; moves as flows are added */
    size_t count;
    jlt_section_flows_thread *own; /* (threads,), owned */
    unsigned threads;
} jlt_section_flows;

/** Open with the first flow and one section per thread. Errors: NOMEM; as jlt_section_create. */
JLT_CHECKED jlt_status jlt_section_flows_open(jlt_section_flows *out, const jlt_flow *flow, const jlt_instance *project,
                                              unsigned threads);
void jlt_section_flows_clear(jlt_section_flows *self); /* legal on a zeroed one */

/** Whether a flow differs from the first in no more than parameters, levels and units. */
bool jlt_section_flows_fit(const jlt_flow *first, const jlt_flow *flow);

/** Add a flow. Errors: ARG, it does not fit the first, or only one of the two has a `project`; NOMEM. */
JLT_CHECKED jlt_status jlt_section_flows_add(jlt_section_flows *self, const jlt_flow *flow, const jlt_instance *project);

/** Whether these may be kernels of the flow's field: those of another table, or of another field of the same one, follow another
 *  motion. True for NULL, and for a field that no table has. */
bool jlt_section_flows_owns(const jlt_flow *flow, const jlt_kernel_batch *kernels);

/** Returns why orbits of this flow cannot go in lanes, a clause such as "returns have an end in time"; NULL: they can. */
const char *jlt_section_flows_obstacle(const jlt_flow *flow, const jlt_kernel_batch *kernels);

/** Kernels with `valid_values` for its conditions, of the instruction set of these kernels; NULL: there are none. */
const jlt_kernel_batch *jlt_section_flows_watching(const jlt_flow *flow, const jlt_kernel_batch *kernels);

/** One jlt_batch_case per flow, shape (count,), for the caller to free(); NULL: memory is out. They point into the flows: add none
 *  while they are in use.
 *  In: kernels, those of lanes; watches, whether conditions are watched. */
jlt_batch_case *jlt_section_flows_cases(jlt_section_flows *self, const jlt_kernel_batch *kernels, bool watches);

/** Set *section to the section of a thread, made anew if it is of another flow; valid until the thread asks again. Errors: as
 *  jlt_section_create. Cost: a section's creation where the thread was at another flow. */
JLT_CHECKED jlt_status jlt_section_flows_section(jlt_section_flows *self, jlt_section **section, unsigned thread, size_t flow);

#endif
