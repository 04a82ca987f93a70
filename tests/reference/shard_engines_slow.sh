#!/usr/bin/env bash
# The same study by the engines that start many processes, each by its job script in tools/scenes, has the same bytes: mpirun, also
# when it kills a rank on the way; GNU parallel; arrays and steps of a Slurm of this machine alone. One that is not installed is
# passed over.
set -uo pipefail
scratch=$(mktemp -d)
trap '[ -z "${slurm[1]:-}" ] || exec {slurm[1]}>&-; wait; rm -rf "$scratch"' EXIT
scenes=$JLT_SOURCE_DIR/tools/scenes
cd "$scratch" || exit 1
slurm=() status=0 engines=0
fail() { echo "$*"; status=1; }
cat > small.scene << 'END'
levels = { G = -0.56; };
accuracy = { tolerance = 1e-10; };
compute = ( { what = "fates"; grid = "36x24"; returns = 120; sweep = { a3 = (0.1, 0.7, 9); E = (0.8, 4, 8); }; } );
END
jellett sweep small.scene --into=one --shard=1/1 2> log || { cat log; exit 1; }
for kind in csv npy sqlite; do jellett merge one -o one.$kind; done
jellett run small.scene 2> log | grep -v '^#' | cmp - <(grep -v '^#' one.csv) || fail "other rows than jellett run"
same() { # TITLE FILE-WITHOUT-ENDING
    engines=$((engines + 1))
    for kind in csv npy sqlite; do cmp "$2.$kind" one.$kind || fail "$1: another $kind"; done
    rm -f "$2".csv "$2".npy "$2".sqlite
}

if command -v mpirun > /dev/null && mpirun --version | grep -q 'Open MPI'; then
    export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
    "$scenes/sweep-mpirun" small.scene mpi -n 4 --oversubscribe > log 2>&1 || { fail "mpirun:"; cat log; }
    [ "$(find mpi -name '*-of-4.shard' | wc -l)" = 4 ] || fail "mpirun -n 4: $(ls mpi)"
    same mpirun small
    # A rank that dies takes no other down: all but its own pieces are there.
    { "$scenes/sweep-mpirun" small.scene killed -n 4 --oversubscribe > log 2>&1; echo "status $?" >> log; } &
    for _ in $(seq 200); do [ -s killed/2-of-4.shard ] && break; sleep 0.02; done
    rank=$(python3 - killed/2-of-4.shard << 'END'
import fcntl, struct, sys
lock = struct.pack("hhqqi4x", fcntl.F_WRLCK, 0, 0, 0, 0)
print(struct.unpack("hhqqi4x", fcntl.fcntl(open(sys.argv[1], "r+"), fcntl.F_GETLK, lock))[4])
END
)
    [ "$rank" -gt 1 ] && kill -9 "$rank" || fail "rank 2 of 4 was not there to be killed" # 0: this test and all about it
    wait
    for i in 1 3 4; do grep -q "$i-of-4.shard has its" log ||
        { fail "a rank was killed, and shard $i is not whole:"; cat log; }; done
    ! grep -q "2-of-4.shard has its" log || fail "rank 2 of 4 was killed too late"
    "$scenes/sweep-mpirun" small.scene killed -n 4 --oversubscribe > log 2>&1 || { fail "mpirun again:"; cat log; }
    same "mpirun, a rank of which was killed" small
else echo "skipped: Open MPI is not installed"; fi

if parallel --version 2> /dev/null | grep -q '^GNU parallel'; then
    "$scenes/sweep-parallel" small.scene parallel 9 > log 2>&1 || { fail "GNU parallel:"; cat log; }
    same "GNU parallel" small
    # Blanks and letters with a meaning to the shell are parts of names.
    cp small.scene 'a small > study.scene'
    "$scenes/sweep-parallel" 'a small > study.scene' 'its $(shards)' 2 > log 2>&1 ||
        { fail "GNU parallel, a name with blanks:"; cat log; }
    same "GNU parallel, a name with blanks" 'a small > study'
    # As the environment says.
    seq 5 | parallel -N0 jellett sweep small.scene --into=seq --shard=/5 > log 2>&1 || { fail "GNU parallel by itself:"; cat log; }
    jellett merge seq -o small.csv -o small.npy -o small.sqlite
    same "GNU parallel by itself" small
else echo "skipped: GNU parallel is not installed"; fi

if command -v slurmctld > /dev/null && command -v slurmd > /dev/null && command -v munged > /dev/null; then
    coproc slurm { bash "$JLT_SOURCE_DIR/tests/reference/one_node_slurm" "$scratch/slurm"; } 2>&1
    read -r -t 60 ready <&"${slurm[0]}"
    if [ "$ready" = ready ]; then
        export SLURM_CONF=$scratch/slurm/slurm.conf
        sbatch --wait --array=1-6 -o array.%a.log "$scenes/sweep-slurm" small.scene array > log 2>&1 ||
            { fail "Slurm array:"; cat log array.*.log; }
        [ "$(find array -name '*-of-6.shard' | wc -l)" = 6 ] || fail "--array=1-6: $(ls array)"
        rm array/2-of-6.shard array/5-of-6.shard
        SHARDS=6 sbatch --wait --array=2,5 -o array.%a.log "$scenes/sweep-slurm" small.scene array > log 2>&1 ||
            { fail "Slurm array again:"; cat log; }
        jellett merge array -o small.csv -o small.npy -o small.sqlite
        same "a Slurm array" small
        timeout 300 srun --overcommit -n 4 jellett sweep small.scene --into=steps > log 2>&1 || { fail "srun:"; cat log; }
        [ "$(find steps -name '*-of-4.shard' | wc -l)" = 4 ] || fail "srun -n 4: $(ls steps)"
        jellett merge steps -o small.csv -o small.npy -o small.sqlite
        same srun small
        if command -v mpirun > /dev/null; then # as many ranks as the job has tasks
            sbatch --wait --ntasks="$(nproc)" -o job.log "$scenes/sweep-mpirun" small.scene job > log 2>&1 ||
                { fail "mpirun in a job of Slurm:"; cat log job.log; }
            [ "$(find job -name "*-of-$(nproc).shard" | wc -l)" = "$(nproc)" ] ||
                fail "mpirun in a job of $(nproc) tasks: $(ls job)"
            same "mpirun in a job of Slurm" small
        fi
    else
        fail "Slurm is installed and does not start: $ready"
        tail -n 20 slurm/*.log slurm/*.out
    fi
else echo "skipped: Slurm is not installed"; fi

echo "$engines ways to start them"
[ $engines -gt 0 ] || exit 77
exit $status
