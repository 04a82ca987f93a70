#!/usr/bin/env bash
# Signals: a command that is asked to end does so within a second, saves its whole rows or says what is lost, leaves nothing
# beside them, and ends by the signal; further signals within a second change nothing.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
now() { date +%s%N; }

# SIGNALS COMMAND...: run in $scratch/d, send each signal when it has run for $pause s, by default 0.4, one right after the other;
# into $code, $seconds, err.
interrupt() {
    local signals=$1 job begun
    shift
    rm -rf "$scratch/d"
    mkdir "$scratch/d"
    set -m # a background job of a script ignores SIGINT otherwise
    (cd "$scratch/d" && exec "$@") > "$scratch/out" 2> "$scratch/err" &
    job=$!
    set +m
    # A busy machine: wait until the program catches TERM.
    for _ in $(seq 100); do
        [ "$(cat /proc/$job/comm 2> /dev/null)" = jellett ] &&
            (((0x$(awk '/SigCgt/ { print $2 }' /proc/$job/status) >> 14) & 1)) && break
        sleep 0.05
    done
    sleep ${pause:-0.4}
    open=0 # threads beside the first that would meet INT, TERM or HUP
    for thread in /proc/$job/task/*; do
        [ "${thread##*/}" = $job ] && continue
        (((0x$(awk '/SigBlk/ { print $2 }' "$thread/status") & 0x4003) == 0x4003)) || open=$((open + 1))
    done
    begun=$(now)
    for signal in $signals; do kill -"$signal" -$job 2> /dev/null; done
    wait $job 2> /dev/null
    code=$?
    seconds=$(awk -v ns=$(($(now) - begun)) 'BEGIN { printf "%.2f", ns * 1e-9 }')
}
expect() { # CODE FILES TITLE
    [ $code -eq "$1" ] || fail "$3: status $code, not $1: $(head -3 "$scratch/err")"
    [ "$(ls -A "$scratch/d" | tr '\n' ' ')" = "$2" ] || fail "$3: leaves '$(ls -A "$scratch/d" | tr '\n' ' ')', not '$2'"
    awk -v s="$seconds" 'BEGIN { exit !(s < 1.5) }' || fail "$3: ends after $seconds s"
    [ -s "$scratch/err" ] || fail "$3: nothing said"
}

section=(jellett section --grid 300x300 --returns 2000 -o t.csv)
for signals in TERM "TERM TERM" "INT INT INT" "HUP TERM INT TERM"; do
    first=${signals%% *}
    interrupt "$signals" "${section[@]}"
    expect $((128 + $(kill -l "$first"))) "t.csv " "section, $signals"
    [ $open -eq 0 ] || fail "section, $signals: $open threads beside the first meet signals"
    grep -q "saved in t.csv" "$scratch/err" || fail "section, $signals: says '$(cat "$scratch/err")'"
    tail -c 1 "$scratch/d/t.csv" | cmp -s - <(echo) || fail "section, $signals: the last row is cut"
done
# Before the first return of any orbit there is nothing to tell of.
printf 'model slow\nstate x\nstate v\nstate r\nstate u\neq x = v\neq v = -x\neq r = u\neq u = -r/10^12\n' > slow.tt
jellett section ./slow.tt --section x=0 --grid v=1:2:8,r=0,u=1 --returns 1 > out 2>&1 || fail "slow.tt: $(cat out)"
interrupt TERM jellett section ../slow.tt --section r=0 --grid x=0.1:1:8,v=0,u=1 --returns 5 --max-steps 1000000000 -o t.csv
expect 143 "" "section before its first return"
# A row whose check is cut short is none.
for pause in 0.3 0.4 0.5; do
    interrupt TERM jellett rod --start gamma3=0.2,v_nu=0.6,omega_tau=0.4,omega_n=1,omega3=0 --sweep omega_n=0.2:2:900000 --check \
        -o t.csv
    expect 143 "t.csv " "rod"
    awk -F, '/^[0-9]/ { n++; if ($10 > 1e-12) bad = 1 } END { exit !(n > 10 && !bad) }' "$scratch/d/t.csv" ||
        fail "rod: a row of a check that was cut: $(tail -1 "$scratch/d/t.csv")"
done
unset pause
interrupt "TERM TERM" jellett fates --grid 300x300 -o t.csv
expect 143 "t.csv " "fates"
[ "$(grep -vc '^#' "$scratch/d/t.csv")" -gt 10 ] || fail "fates: saves nothing"
interrupt "INT INT" jellett eigen --set a3=0 --at v_nu=0.7,omega3=1.1 --sweep gamma3=-0.99:0.99:900000 -o t.csv
expect 130 "t.csv " "eigen"
rows=$(sed -n 's/.*the first \([0-9]*\) of 900000 rows are saved in t.csv$/\1/p' "$scratch/err")
[ "$(grep -vc '^#' "$scratch/d/t.csv")" = $((rows + 1)) ] || fail "eigen: says '$(cat "$scratch/err")'"
# The first row waits for no other's time.
interrupt "INT INT" jellett simulate lorenz --start x=1,y=1,z=1 --until 1e6 --every 1/50 -o t.csv
expect 130 "t.csv " "simulate"
rows=$(sed -n 's/.*; \([0-9]*\) whole rows of 50000001 are saved in t.csv$/\1/p' "$scratch/err")
[ "$rows" -gt 1 ] && [ "$(grep -vc '^#' "$scratch/d/t.csv")" = $((rows + 1)) ] || fail "simulate: says '$(cat "$scratch/err")'"
# The process that computes points of a sweep ends, too, and leaves the table to the one that writes it.
interrupt TERM jellett measure --set I3=0 --sweep I1=0.2:0.6:100000 -o t.csv
expect 143 "t.csv " "measure --sweep"
grep -q "whole points are saved in t.csv" "$scratch/err" || fail "measure --sweep: says '$(cat "$scratch/err")'"
interrupt TERM jellett section --sweep E=2:2.1:9000 --start eta=0.1,gamma3=-0.6 --returns 3000000 --method gauss -o t.csv
expect 143 "" "section --sweep before its first point"
grep -q "nothing is saved" "$scratch/err" || fail "section --sweep before its first point: says '$(cat "$scratch/err")'"
# While crossings are looked for, the branches are complete: they are saved.
pause=4 interrupt TERM jellett manifolds --length 100 --count 9000 --seed 1e-3 --tol 1e-8 -o t.csv
expect 143 "t.csv " "manifolds"
# Commands that save nothing before they are done say so.
interrupt "TERM TERM" jellett transfer --boxes 900x900 -o t.csv
expect 143 "" "transfer"
grep -q "nothing is saved" "$scratch/err" || fail "transfer: says '$(cat "$scratch/err")'"
# Nor do they say what they have not found out: that there is no orbit.
for command in orbits "certify cycle"; do
    interrupt TERM jellett $command --start eta=0.1,gamma3=-0.6 --period 60 --method rkf45 --tol 1e-16 -o t.csv
    expect 143 "" "$command"
    [ "$(head -1 "$scratch/err")" = "jellett: interrupted; nothing is saved" ] || fail "$command: says '$(cat "$scratch/err")'"
done
# A table that has no row yet replaces no file.
for file in old.csv old.npy; do
    echo old > $file
    interrupt TERM jellett orbits lorenz --section z=27 --grid x=-20:20:3000,y=-20:20:3000 --near 1e-12 -o ../$file
    expect 143 "" "orbits of a grid"
    [ "$(head -1 "$scratch/err")" = "jellett: interrupted before the first row: nothing is saved in ../$file" ] &&
        ! grep -q "no orbit is found" "$scratch/err" || fail "orbits of a grid: says '$(cat "$scratch/err")'"
    [ "$(cat $file)" = old ] || fail "orbits of a grid: replaces $file by a table without rows"
done
# So on a line, whose zeros take long, each on its own: those found before the interrupt are saved.
pause=4 interrupt "INT INT" jellett orbits restricted_three_body --section y=0 --direction both --mirror y,vx --period 40 \
    --start x=0.5,vx=0,vy=1 --line vy=0.2:1.5:200 -o t.csv
expect 130 "t.csv " "orbits on a line"
[ $open -eq 0 ] || fail "orbits on a line: $open threads beside the first meet signals"
rows=$(sed -n 's/^jellett: interrupted; the \([0-9]*\) orbits found so far are saved$/\1/p' "$scratch/err")
[ "$(grep -vc '^#' "$scratch/d/t.csv")" = $((rows + 1)) ] || fail "orbits on a line: says '$(cat "$scratch/err")'"
interrupt TERM jellett section --start eta=0.1,gamma3=-0.6 --returns 1000000 --check -o t.csv
expect 143 "t.csv " "section --check"
grep -q "DP could not be computed" "$scratch/err" && fail "section --check: says '$(cat "$scratch/err")'"
# Rows whose derivative was cut off are no whole rows; those of the first block are done by then, on a busy machine too.
pause=1.5 interrupt TERM jellett section --grid 60x60 --returns 2000 --check -o t.csv
awk -F, '/^[0-9]/ { rows++; if ($2 > 0 && $9 == "alive" && $10 == "") exit 1 } END { exit rows < 2 }' "$scratch/d/t.csv" ||
    fail "section --check: rows without derivatives"
[ "$(grep -c '^[0-9]' "$scratch/d/t.csv")" = "$(sed -n 's/^jellett: interrupted; \([0-9]*\) whole.*/\1/p' "$scratch/err")" ] ||
    fail "section --check: says '$(head -1 "$scratch/err")'"
interrupt TERM jellett verify --samples 10000000
expect 143 "" "verify"
# A scene is as quick as its command.
printf 'compute = ( { what = "verify"; samples = 10000000; }, { what = "verify"; } );\n' > "$scratch/slow.scene"
for signals in TERM "INT INT"; do
    interrupt "$signals" jellett run "$scratch/slow.scene"
    expect $((128 + $(kill -l "${signals%% *}"))) "" "a scene of verify, $signals"
    grep -q "the last 1 were not begun" "$scratch/err" || fail "a scene of verify: says '$(cat "$scratch/err")'"
done
printf 'compute = ( { what = "section"; grid = "300x300"; returns = 2000; output = "t.csv"; } );\n' > "$scratch/rows.scene"
interrupt "TERM TERM" jellett run "$scratch/rows.scene"
expect 143 "t.csv " "a scene of section"

# A command that cannot look at the flag, as its standard output is a pipe that nobody empties, gets a second, also where the
# parent ignores alarms.
mkfifo "$scratch/pipe"
for parent in "" "env --ignore-signal=ALRM"; do
    sleep 4 < "$scratch/pipe" &
    reader=$!
    interrupt TERM sh -c "exec $parent jellett section --grid 300x300 --returns 2000 > $scratch/pipe"
    expect 143 "" "a pipe that is full, $parent"
    kill $reader 2> /dev/null
    wait $reader 2> /dev/null
done
# A reader that goes away leaves nothing behind either.
rm -rf "$scratch/d"
mkdir "$scratch/d"
(cd "$scratch/d" && jellett manifolds --length 0.2 --count 20 --crossings c.csv 2> /dev/null | true)
[ -z "$(ls -A "$scratch/d")" ] || fail "a broken pipe: leaves $(ls -A "$scratch/d")"
exit $status
