/** Which shard of a study a process computes: the one given on its command line, or the one that the launcher (mpirun, srun, ...)
 *  gives in the environment. */
#ifndef JLT_SHARDS_RANK_H
#define JLT_SHARDS_RANK_H

#include <stddef.h>

#include "core/status.h"

enum { JLT_RANK_TEXT_MAX = 256 };

typedef struct {
    size_t index, count; /* 1 <= index <= count */
    char engine[64];     /* which launcher gave the numbers, for messages; "": none */
} jlt_rank;

/** Find the shard of this process. text: "I/N", shard I of N; "/N", with I from the environment; NULL, both from the environment,
 *  or 1/1 if the environment has neither.
 *
 *  Variables are looked for in this order: Open MPI (OMPI_COMM_WORLD_RANK, _SIZE); MPICH and Slurm's PMI (PMI_RANK, PMI_SIZE);
 *  steps of srun (SLURM_PROCID, SLURM_STEP_NUM_TASKS); PMIx (PMIX_RANK) and GNU parallel (PARALLEL_SEQ), which do not give the
 *  number of processes, so that they need "/N". Slurm's arrays (SLURM_ARRAY_TASK_ID, _MIN, _STEP, _COUNT) combine with the first
 *  three: where ranks run in the tasks of an array, the shards are all ranks of all tasks. With "/N" and one process in each task,
 *  the tasks must be numbered from 1 to N. Out: on failure `message`, shape (JLT_RANK_TEXT_MAX,): what is wrong, without a full
 *  stop. Errors: ARG. */
JLT_CHECKED jlt_status jlt_rank_find(jlt_rank *out, char *message, const char *text);

#endif
