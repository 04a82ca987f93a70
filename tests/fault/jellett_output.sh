#!/usr/bin/env bash
# What jellett writes to a file is there whole or not at all: status 5 and the old file untouched where it cannot be
# written; the old file or the new one, which has the first rows where the program is asked to stop, and nothing beside it, however
# the program is stopped.
source "$JLT_SOURCE_DIR/tests/scratch.sh"

at=v_nu=0.7,omega3=1.1
sweep=(jellett eigen --set a3=0 --at "$at" --sweep gamma3=-0.99:0.99:501)

expect() { # STATUS TITLE COMMAND...
    local want=$1 title=$2 code
    shift 2
    "$@" > /dev/null 2> "$scratch/err"
    code=$?
    [ $code -eq "$want" ] || { fail "$title: status $code, not $want"; head -5 "$scratch/err"; }
    [ "$want" -eq 0 ] || [ -s "$scratch/err" ] || fail "$title: nothing said on standard error"
}

# The comment header quotes the command line, and with it the name of the file.
same() { diff -q <(grep -v '^#' "$1") <(grep -v '^#' "$2") > /dev/null; }
begins() { diff -q <(grep -v '^#' "$1") <(grep -v '^#' "$2" | head -n "$(grep -vc '^#' "$1")") > /dev/null; }

mkdir "$scratch/d"
start=$(date +%s%N)
expect 0 "a plain run" "${sweep[@]}" --output "$scratch/whole"
lasts=$(($(date +%s%N) - start))
touch "$scratch/file"
expect 5 "output below a file" "${sweep[@]}" --output "$scratch/file/below"
expect 5 "output is a folder" "${sweep[@]}" --output "$scratch/d"
expect 5 "no such folder" "${sweep[@]}" --output "$scratch/none/out"
expect 5 "full device" "${sweep[@]}" --output /dev/full
expect 5 "picture in no such folder" "${sweep[@]}" --plot "$scratch/none/out.svg"
expect 5 "picture to where nothing can be made" "${sweep[@]}" --plot /proc/out.svg

# A full disk, played by a limit on the size of files.
limited() { (ulimit -f 4; trap '' XFSZ; "${sweep[@]}" "$@"); }
echo old > "$scratch/d/out"
expect 5 "disk full" limited --output "$scratch/d/out"
[ "$(cat "$scratch/d/out")" = old ] || fail "disk full: the old file is damaged"
[ "$(ls -A "$scratch/d")" = out ] || fail "disk full: leaves $(ls -A "$scratch/d")"

for signal in INT TERM KILL; do
    for k in $(seq 1 8); do
        echo old > "$scratch/d/out"
        # With job control, because a background job of a script ignores SIGINT otherwise.
        set -m
        "${sweep[@]}" --output "$scratch/d/out" > /dev/null 2>&1 &
        job=$!
        set +m
        sleep "$(awk -v ns="$lasts" -v k="$k" 'BEGIN { printf "%.6f", ns * 1e-9 * k / 8 }')"
        kill -$signal $job 2>/dev/null
        wait $job 2>/dev/null
        same "$scratch/d/out" "$scratch/whole" || [ "$(cat "$scratch/d/out")" = old ] ||
            { [ $signal != KILL ] && begins "$scratch/d/out" "$scratch/whole"; } ||
            fail "SIG$signal at $k/8: the file is neither the old one nor the new one"
        [ $signal = KILL ] || [ "$(ls -A "$scratch/d")" = out ] || fail "SIG$signal at $k/8: leaves $(ls -A "$scratch/d")"
        find "$scratch/d" -name 'out?*' -delete
    done
done

# A section map that is interrupted keeps whole rows, of every orbit the first of those that an undisturbed run writes, and says so:
# of one orbit the first rows, of many that go at once a part of each.
# It has as many returns as take some two seconds, where sanitizers make them slow.
start=$(date +%s%N)
jellett section --grid 8x8 --returns 100 > /dev/null 2>&1
returns=$((200 * 1000000000 / ($(date +%s%N) - start)))
section=(jellett section --grid 8x8 --returns $((returns < 300 ? 300 : returns < 3000 ? returns : 3000)))
"${section[@]}" --output "$scratch/rows" 2> /dev/null
for signal in INT TERM KILL; do
    rm -rf "$scratch/d"
    mkdir "$scratch/d"
    set -m
    "${section[@]}" --output "$scratch/d/out" > /dev/null 2> "$scratch/err" &
    job=$!
    set +m
    while kill -0 $job 2> /dev/null &&
        [ -z "$(find "$scratch/d" -type f -size +0 2> /dev/null)" ]; do sleep 0.01; done # its first rows
    kill -$signal $job 2>/dev/null
    wait $job 2>/dev/null
    if [ $signal = KILL ]; then
        [ ! -e "$scratch/d/out" ] || same "$scratch/d/out" "$scratch/rows" || fail "SIGKILL: section leaves a part of its rows"
        continue
    fi
    [ "$(ls -A "$scratch/d")" = out ] || { fail "SIG$signal: section leaves '$(ls -A "$scratch/d")'"; continue; }
    grep -q . "$scratch/err" || fail "SIG$signal: section does not say what is saved"
    awk -F, '/^#/ { next }
        NR == FNR { whole[$0] = 1; next }
        !($0 in whole) || ($1 != "orbit" && $2 != ($1 == last ? number + 1 : 0)) { exit 1 }
        { last = $1; number = $2 }' "$scratch/rows" "$scratch/d/out" ||
        fail "SIG$signal: section's rows are not the first ones of each orbit of a whole run"
done
# Others say as well what is saved, and draw what there is.
at=gamma3=0.2,v_nu=0.6,omega_tau=0.4,omega_n=1,omega3=0
for command in "drift --returns 10000000" "rod --start $at --sweep omega_n=1:2:10000000" "manifolds --length 100"; do
    rm -rf "$scratch/d"
    mkdir "$scratch/d"
    set -m
    # shellcheck disable=SC2086
    jellett $command --output "$scratch/d/out" --plot "$scratch/d/p.svg" > /dev/null 2> "$scratch/err" &
    job=$!
    set +m
    sleep 0.5
    kill -INT $job
    wait $job 2> /dev/null
    code=$?
    [ $code -eq 130 ] || fail "SIGINT: $command ends with $code"
    [ "$(ls -A "$scratch/d" | tr '\n' ' ')" = "out p.svg " ] || fail "SIGINT: $command leaves '$(ls -A "$scratch/d")'"
    grep -q "interrupted; .*saved in $scratch/d/out" "$scratch/err" || fail "SIGINT: $command says '$(cat "$scratch/err")'"
done
# Where every method fails before there is a row, no file is made.
printf '%s\n' 'model runaway' 'state x' 'state u' 'eq x = u' 'eq u = -x + x^3' 'integral E = u^2/2 + x^2/2 - x^4/4' > \
    "$scratch/runaway.tt"
rm -f "$scratch/out"
expect 4 "no row" env XDG_CACHE_HOME="$scratch/cache" jellett drift "$scratch/runaway.tt" --section u=0 --start x=3 --returns 10 \
    --output "$scratch/out"
[ ! -e "$scratch/out" ] || fail "no row: there is a file: $(cat "$scratch/out")"
for command in "section --start eta=0.1,gamma3=-0.6 --returns 5" "orbits --period 1 --grid 0x0 --samples 20" \
    "simulate --start gamma3=-0.6,v_nu=0.5,omega_tau=0.3,omega_n=1,omega3=0.8 --until 1 --every 0.1" measure; do
    # shellcheck disable=SC2086
    for place in "$scratch/none/out" "$scratch/file/below" "$scratch/d" /dev/full; do
        expect 5 "$command to $place" jellett $command --output "$place"
    done
done
# The reason is told also where it is some buffers ago that writing failed.
jellett section --grid 20x20 --returns 20 > /dev/full 2> "$scratch/error"
[ $? -eq 5 ] && grep -q "No space left on device" "$scratch/error" || fail "many rows to /dev/full: $(cat "$scratch/error")"
exit $status
