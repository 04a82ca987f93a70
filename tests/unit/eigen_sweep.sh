#!/usr/bin/env bash
# Rows of a sweep of `jellett eigen` are the same bytes by one process and by several, also where one of these is killed; where the
# command is interrupted the first rows are saved, and that is said.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
at=v_nu=0.7,omega3=1.1
sweep=(eigen --set a3=0 --at omega3=1.1 --sweep gamma3=-0.9:0.9:37,v_nu=0:0.7:3)
for how in "" --fast --json; do
    for count in 1 2 5; do OMP_NUM_THREADS=$count jellett "${sweep[@]}" $how > rows.$count 2> err ||
        fail "$how, $count: $(cat err)"; done
    cmp rows.1 rows.2 && cmp rows.1 rows.5 || fail "$how: other rows by several processes"
done
for count in 1 3; do jellett "${sweep[@]}" --threads $count 2> err | grep -v '^#' > rows.$count; done
[ -s rows.1 ] && cmp rows.1 rows.3 || fail "--threads: $(cat err)"
jellett eigen --set a3=0 --at gamma3=0.3 --threads 2 > rows.1 2>&1
[ $? -eq 2 ] && grep -q -e "--sweep" rows.1 || fail "--threads without a sweep"

# A row is that of the decimals that it shows: at a = 0.3 the trace a - 3/10 is zero, which at the double nearest to 0.3 it is not.
# What a sweep gives its values needs no default.
printf '%s\n' 'model focus' 'param a' 'state x' 'state y' 'eq x = (a - 3/10)*x - y' 'eq y = x' > focus.tt
jellett eigen ./focus.tt --sweep a=0.1:0.5:5 > rows 2> err || fail "a focus: $(cat err)"
[ "$(grep '^0' rows | cut -d, -f5,15 | tr '\n' ' ')" = "-0.2,stable -0.1,stable 0,centre 0.1,unstable 0.2,unstable " ] ||
    fail "a focus: $(cat rows)"
for a in 0.1 0.2 0.3 0.4 0.5; do jellett eigen ./focus.tt --set a=$a --csv | tail -1 | sed "s/^/$a,/"; done > single
cmp single <(grep '^0' rows) || fail "rows of a sweep are not those of its points"
jellett fates ./focus.tt --section y=0 --grid x=0.1:1:3 --returns 2 --sweep a=0.1:0.2:2 > rows 2> err || fail "fates: $(cat err)"
[ "$(grep '^0' rows | cut -d, -f1,2 | tr '\n' ' ')" = "0.1,3 0.2,3 " ] || fail "fates: $(cat rows)"
# Of those, points that the table does not allow are refused, not the sweep.
sed 's/param a/& > 0/' focus.tt > focus_right.tt
jellett eigen ./focus_right.tt --sweep a=-1:1:3 > rows 2> err && grep -q "2 of 3 points refused" err || fail "a > 0: $(cat err)"
jellett fates ./focus_right.tt --section y=0 --start x=1 --returns 2 --sweep a=-1:1:3 > rows 2> err &&
    grep -q "2 of 3 points are outside" err && [ "$(grep -c '^[-01]*,[01],' rows)" -eq 3 ] || fail "fates, a > 0: $(cat err)"
many=(eigen --set a3=0 --at $at --sweep gamma3=-0.9:0.9:30000 --fast)
OMP_NUM_THREADS=1 jellett "${many[@]}" > rows.1
OMP_NUM_THREADS=2 jellett "${many[@]}" > rows.2 2> err & job=$!
for try in $(seq 200); do child=$(cat /proc/$job/task/$job/children); [ -n "$child" ] && break; sleep 0.01; done
kill -KILL $child
wait $job
[ $? -eq 0 ] && cmp rows.1 rows.2 || fail "a process was killed: $(cat err)"
OMP_NUM_THREADS=2 jellett "${many[@]}" -o first.csv 2> err & job=$!
sleep 0.3
kill -TERM $job
wait $job
[ $? -eq 143 ] || fail "an interrupt: $(cat err)"
count=$(sed -n 's/.*interrupted; the first \([0-9]*\) of 30000 rows are saved in first.csv$/\1/p' err)
[ "${count:-0}" -gt 0 ] && cmp <(grep -v '^#' rows.1 | head -n $((count + 1))) <(grep -v '^#' first.csv) ||
    fail "first rows: $(cat err)"
exit $status
