#!/usr/bin/env bash
# Orbits of a sweep go in lanes side by side, whichever point they are of, and so do those of a study. Their rows are those of each
# point by itself, for every instruction set, number of threads and order of the sweep, and whatever becomes of the process that
# computes them.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
rows() { # FILE COMMAND...: rows without comments
    local file=$1
    shift
    jellett "$@" > all.csv 2> err || fail "$*: status $?, $(head -3 err)"
    grep -v '^#' all.csv > "$file"
}
same() { cmp -s "$1" "$2" || { fail "$3"; diff "$1" "$2" | head -4; }; }

grep -q "WAIT_POLICY *= *'PASSIVE'" <<< "$(OMP_DISPLAY_ENV=true jellett --version 2>&1)" || fail "threads that wait do not sleep"

# Points of a sweep one by one, their rows behind each other.
one_by_one() { # FILE NAME VALUES COMMAND...
    local file=$1 name=$2 values=$3
    shift 3
    : > "$file"
    for value in $values; do
        rows one.csv "$@" --sweep "$name=$value:$value:1"
        if [ -s "$file" ]; then tail -n +2 one.csv >> "$file"; else cp one.csv "$file"; fi
    done
}

# a3 = 0 has kernels of its own, and so has the rod; of levels below 0.4 there is nothing.
a3="-0.2 -0.1 0 0.1 0.2"
for lanes in 2 4 8; do
    export JELLETT_LANES=$lanes
    for command in "fates --level E=1.5,G=-0.4 --grid 3x2 --returns 20" "fates --start eta=0.1,gamma3=-0.6 --returns 30" \
        "section --level E=1.5,G=-0.4 --grid 3x2 --returns 20" "section --start eta=0.1,gamma3=-0.6 --returns 30 --contact report" \
        "section --start eta=0.1,gamma3=-0.6 --returns 20 --skip 5 --backward" "section --grid 3x2 --returns 10 --project" \
        "section --start eta=0.1,gamma3=-0.6 --returns 4 --contact end" \
        "section --start eta=0.1,gamma3=-0.6 --returns 20 --method gauss" \
        "lyapunov --start eta=0.1,gamma3=-0.6 --returns 12 --skip 3" \
        "lyapunov --start eta=0.1,gamma3=-0.6 --returns 5 --method gauss" \
        "lyapunov --grid 3x2 --returns 2"; do
        one_by_one each.csv a3 "$a3" $command
        [ "$(grep -c . each.csv)" -ge 6 ] || fail "$command: there are few rows"
        OMP_NUM_THREADS=1 rows all_of_them.csv $command --sweep a3=-0.2:0.2:5
        same each.csv all_of_them.csv "$command, $lanes lanes: points of a sweep differ from each by itself"
        OMP_NUM_THREADS=2 rows threads.csv $command --sweep a3=-0.2:0.2:5
        same each.csv threads.csv "$command, $lanes lanes: rows depend on threads"
        rows backwards.csv $command --sweep a3=0.2:-0.2:5
        same <(sort each.csv) <(sort backwards.csv) "$command, $lanes lanes: rows depend on the order of the sweep"
    done
    # A table whose intervals, if any, lanes watch by themselves.
    for command in "section roessler --section y=0 --start x=-5,z=0.01 --returns 20" \
        "lyapunov roessler --section y=0 --start x=-5,z=0.01 --returns 12 --skip 3" \
        "fates roessler --section y=0 --grid x=-6:-4:2,z=0:0.1:2 --returns 10"; do
        one_by_one each.csv c "5 5.25 5.5" $command
        OMP_NUM_THREADS=1 rows all_of_them.csv $command --sweep c=5:5.5:3
        same each.csv all_of_them.csv "$command, $lanes lanes: points of a sweep differ from each by itself"
    done
done
unset JELLETT_LANES

# Of a point whose states do not include the start there is a row as of one without states.
rows empty.csv fates --start eta=0.1,gamma3=0.9 --sweep E=-1:2:3 --returns 2
[ "$(cut -d, -f1,2 empty.csv | tr '\n' ' ')" = "E,starts -1,0 0.5,0 2,1 " ] || fail "points without starts: $(cat empty.csv)"

# An orbit of a sweep is followed as one of many: at one of its points alone, as that of a grid.
rows all_of_them.csv section --start eta=0.1,gamma3=-0.6 --returns 10 --sweep a3=-0.2:0.2:5
grep -q '^# many orbits at once by stepanov10 on ' all.csv || fail "the header of a sweep does not tell the method"
rows single.csv section --set a3=0.1 --grid eta=0.1:0.1:1,gamma3=-0.6:-0.6:1 --returns 10
same <(tail -n +2 single.csv | sed 's/^/0.1,/') <(grep '^0.1,' all_of_them.csv) "a point of a sweep differs from the single command"

# Each of 1200 starts with parameters of its own: more than go together, and more than one process computes.
rows many.csv section --start eta=0.1,gamma3=-0.6 --returns 3 --sweep "a3=0.3:0.6:1200"
rows few.csv section --start eta=0.1,gamma3=-0.6 --returns 3 --sweep "a3=0.3:0.6:1200@1100:60"
same <(tail -n +2 few.csv) <(grep -Fx -f few.csv many.csv | tail -n +2) "a part of a sweep differs from the whole"
[ "$(cut -d, -f1 many.csv | sort -u | grep -c .)" -eq 1201 ] || fail "not all points of a sweep have rows"

# Where there is nothing, that is told at its turn, and once: points that are begun before it are silent.
empty=(section --start eta=0.1,gamma3=-0.6 --returns 5)
jellett "${empty[@]}" --sweep E=2:-1:16 > some.csv 2> err || fail "a sweep with empty points: status $?"
[ "$(head -1 err)" = "jellett: at E=0.4:" ] || fail "the first words are of another point: $(head -2 err)"
jellett "${empty[@]}" --sweep E=-1:2:16 2> up > /dev/null
same <(sort err) <(sort up) "words depend on the order of the sweep"
[ "$(grep -c '^jellett: no state with' err)" -eq 7 ] || fail "not every empty point is told once: $(cat err)"

# Pieces of a study go together as points of a sweep do, in any shard: its rows are those of the sweep.
printf 'over = { a3 = (-0.2, 0.2, 21); };\ncompute = ( { what = "section"; grid = "3x2"; returns = 20; } );\n' > study.scene
rows sweep.csv section --grid 3x2 --returns 20 --sweep a3=-0.2:0.2:21
for shard in 2/2 1/2; do jellett sweep study.scene --into shards --shard $shard 2> err || fail "shard $shard: $(tail -1 err)"; done
jellett merge shards -o merged.csv 2> err || fail "merge: $(cat err)"
same sweep.csv <(grep -v '^#' merged.csv) "rows of a study are not those of the sweep"

# The process that computes is killed: its points are computed by another one, and nothing is lost.
long=(section --start eta=0.44,gamma3=-0.62 --returns 4000 --sweep a3=0.5:0.52:40 --threads 1)
rows undisturbed.csv "${long[@]}"
jellett "${long[@]}" > all.csv 2> err &
program=$!
for ((i = 0; i < 500; i++)); do
    child=$(cat /proc/$program/task/$program/children 2> /dev/null) && [ -n "$child" ] && break
    sleep 0.01
done
sleep 0.05
kill -KILL $child 2> /dev/null
wait $program || fail "after its process was killed: status $?, $(head -3 err)"
grep -v '^#' all.csv > again.csv
same undisturbed.csv again.csv "rows differ after the process was killed"
exit $status
