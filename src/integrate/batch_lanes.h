/** Internals of the batched section map: one instance for each instruction set, all from batch_lanes.inc. */
#ifndef JLT_INTEGRATE_BATCH_LANES_H
#define JLT_INTEGRATE_BATCH_LANES_H

#include "integrate/batch.h"

typedef struct {
    const jlt_batch_map *map;
    const double *starts;
    size_t count, returns;
    unsigned columns;     /* jlt_batch_columns of the map */
    jlt_batch_row row;
    jlt_batch_end end;
    void *context;
    jlt_batch_work *work; /* of this thread; never NULL */
    size_t *next;         /* shared by all threads: the next start; changed atomically */
    int *stop;            /* shared by all threads: set once the run is to end */
} jlt_batch_job;

/* Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_batch_lanes_baseline(const jlt_batch_job *job);
#if defined(JLT_HAVE_X86)
JLT_CHECKED jlt_status jlt_batch_lanes_avx2(const jlt_batch_job *job);
JLT_CHECKED jlt_status jlt_batch_lanes_avx512(const jlt_batch_job *job);
#endif

#endif
