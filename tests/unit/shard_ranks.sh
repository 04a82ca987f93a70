#!/usr/bin/env bash
# What engines say in the environment tells a process which shard of a study is its own.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
unset OMPI_COMM_WORLD_RANK PMI_RANK PMIX_RANK SLURM_PROCID SLURM_ARRAY_TASK_ID PARALLEL_SEQ
cat > map.scene << 'END'
levels = { E = 2.15; G = -0.56; };
piece = 7;
compute = ( { what = "section"; grid = { eta = (-3, 3, 9); gamma3 = (-0.9999, 0.9999, 15); }; returns = 3; } );
END

# The pieces of a shard are those that are shown.
shown() { # SHARD ENVIRONMENT...
    cmp -s <(jellett sweep map.scene --dry-run --shard="$1") <(env "${@:2}" jellett sweep map.scene --dry-run 2>&1) ||
        fail "${*:2}: no shard $1"
}
shown 3/4 OMPI_COMM_WORLD_RANK=2 OMPI_COMM_WORLD_SIZE=4
shown 1/5 PMI_RANK=0 PMI_SIZE=5
shown 2/5 SLURM_PROCID=1 SLURM_STEP_NUM_TASKS=5
shown 1/1 SLURM_PROCID=0 SLURM_NTASKS=5
shown 4/6 SLURM_ARRAY_TASK_ID=4 SLURM_ARRAY_TASK_MIN=1 SLURM_ARRAY_TASK_STEP=1 SLURM_ARRAY_TASK_COUNT=6
shown 3/4 SLURM_ARRAY_TASK_ID=20 SLURM_ARRAY_TASK_MIN=0 SLURM_ARRAY_TASK_STEP=10 SLURM_ARRAY_TASK_COUNT=4
shown 6/8 SLURM_ARRAY_TASK_ID=2 SLURM_ARRAY_TASK_COUNT=2 SLURM_PROCID=1 SLURM_STEP_NUM_TASKS=4
expect 2 "--array=1-N" env SLURM_ARRAY_TASK_ID=7 SLURM_ARRAY_TASK_COUNT=2 SLURM_ARRAY_TASK_MIN=1 jellett sweep map.scene --dry-run
for said in 'PMI_RANK=-1 PMI_SIZE=2' 'PMI_RANK=0 PMI_SIZE=two' 'OMPI_COMM_WORLD_RANK=1/2 OMPI_COMM_WORLD_SIZE=2' \
    'SLURM_ARRAY_TASK_ID=1.5 SLURM_ARRAY_TASK_COUNT=2' 'SLURM_ARRAY_TASK_ID=1 SLURM_ARRAY_TASK_MIN=-1 SLURM_ARRAY_TASK_COUNT=2'; do
    read -ra said <<< "$said"
    expect 2 "no whole number: give --shard I/N" env "${said[@]}" jellett sweep map.scene --dry-run
done
expect 2 "--shard /N" env PARALLEL_SEQ=3 jellett sweep map.scene --dry-run
expect 2 "which of them" jellett sweep map.scene --dry-run --shard=/3
expect 2 "counted from 1" jellett sweep map.scene --dry-run --shard=4/3
of() { cmp -s <(jellett sweep map.scene --dry-run --shard="$1") <(env "${@:3}" jellett sweep map.scene --dry-run --shard="$2") ||
    fail "${*:3}: no shard $1"; }
of 3/7 /7 PARALLEL_SEQ=3
of 3/7 /7 PMIX_RANK=2
of 5/7 /7 SLURM_ARRAY_TASK_ID=5 SLURM_ARRAY_TASK_MIN=5 SLURM_ARRAY_TASK_COUNT=1
[ "$(for i in 1 2 3 4 5; do jellett sweep map.scene --dry-run --shard=$i/5; done | sort | uniq | wc -l)" = 20 ] ||
    fail "5 shards do not have each of 20 pieces once"
exit $status
