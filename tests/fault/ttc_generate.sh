#!/usr/bin/env bash
# `ttc generate` leaves whole files or none: where it cannot write it says so with status 5, and however it is stopped,
# every file under a final name is complete, and running it again gives exactly what an undisturbed run gives.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
model=$JLT_SOURCE_DIR/codegen/models/chaplygin_sleigh.tt

expect() { # STATUS TITLE COMMAND...
    local want=$1 title=$2 code
    shift 2
    "$@" > "$scratch/out" 2> "$scratch/err"
    code=$?
    [ $code -eq "$want" ] || { fail "$title: status $code, not $want"; cat "$scratch/err"; }
    [ "$want" -eq 0 ] || [ -s "$scratch/err" ] || fail "$title: nothing said on standard error"
}

start=$(date +%s%N)
expect 0 "a plain run" ttc generate "$model" --out "$scratch/whole"
lasts=$(($(date +%s%N) - start))

touch "$scratch/file"
expect 5 "output folder below a file" ttc generate "$model" --out "$scratch/file/below"
expect 5 "output folder is a file" ttc generate "$model" --out "$scratch/file"
expect 5 "output folder where nothing can be made" ttc generate "$model" --out /proc/nothing
if [ "$(id -u)" -ne 0 ]; then
    mkdir -m 555 "$scratch/readonly"
    expect 5 "output folder without permission" ttc generate "$model" --out "$scratch/readonly/out"
fi

# One place that cannot be written to: everything stays, or comes back to, what it was, and folders that were made go again.
blocked() { # TITLE PATH
    rm -rf "$scratch/blocked" "$scratch/as_before"
    cp -r "$scratch/whole" "$scratch/blocked"
    find "$scratch/blocked" -type f -exec sh -c 'for f; do echo old > "$f"; done' sh {} +
    rm -rf "$scratch/blocked/lanes.h" "$scratch/blocked/$2"
    mkdir -p "$scratch/blocked/$2/folder"
    cp -r "$scratch/blocked" "$scratch/as_before"
    expect 5 "$1" ttc generate "$model" --out "$scratch/blocked"
    grep -q "nothing was changed" "$scratch/err" || fail "$1: says $(cat "$scratch/err")"
    diff -r "$scratch/blocked" "$scratch/as_before" || fail "$1: something was changed"
}
for file in counts.tsv registry.c kernel_abi.h chaplygin_sleigh/general.c chaplygin_sleigh/table.c; do
    blocked "a folder in place of $file" $file
    # What fails only after other files are in their places.
    blocked "a folder in place of what $file was" $file.old
    blocked "a folder in place of what $file will be" $file.new
done
mkdir -p "$scratch/new/manifest.tsv"
expect 5 "a folder in place of a file of a new set" ttc generate "$model" --out "$scratch/new"
[ "$(cd "$scratch/new" && find .)" = "$(printf '.\n./manifest.tsv')" ] || fail "a new set: leaves $(ls "$scratch/new")"

# Where memory is out while the table is read, or while its kernels are made, the status says so. How much is too little is the
# system's: of these limits some are.
for limit in $(seq 44000 500 49500); do
    (ulimit -v $limit; ttc generate "$JLT_SOURCE_DIR/codegen/models/spherical_top.tt" --effort quick --out "$scratch/small") \
        > "$scratch/out" 2> "$scratch/err"
    code=$?
    [ $code -eq 4 ] || ! grep -E 'error: (out of memory|the kernels .*memory is out)' "$scratch/err" || fail "$limit KiB: $code"
done

# A full disk, played by a limit on the size of files.
full() { (ulimit -f 4; trap '' XFSZ; ttc generate "$model" --out "$1"); }
expect 5 "disk full" full "$scratch/full"
if [ -d "$scratch/full" ]; then
    while IFS= read -r file; do
        cmp -s "$scratch/full/$file" "$scratch/whole/$file" || fail "disk full: $file is left, and is not whole"
    done < <(cd "$scratch/full" && find . -type f)
fi

# A table that is edited while a reduction onto it is proved, here by what stands in for QEPCAD: the digest that is written with the
# verdict is that of the text that was read.
mkdir "$scratch/bin"
printf '#!/bin/sh\nsed -i "s/2[*]r/3*r/" "%s"\nexec "%s" "$@"\n' "$scratch/radius.tt" "$(command -v qepcad)" > "$scratch/bin/qepcad"
chmod +x "$scratch/bin/qepcad"
printf '%s\n' 'model radius' 'state r' 'eq r = -2*r' > "$scratch/radius.tt"
printf '%s\n' 'model spiral' 'state x' 'state y' 'eq x = -x + y' 'eq y = -y - x' \
    'reduction half : onto radius.tt with r = x^2 + y^2' 'positive asked : x^4 - x^3*y + y^4 + 1/8' > "$scratch/spiral.tt"
digest=$(sha256sum < "$scratch/radius.tt" | cut -d' ' -f1)
PATH=$scratch/bin:$PATH expect 0 "an edited target" ttc generate "$scratch/spiral.tt" --out "$scratch/targets"
grep -q '3\*r' "$scratch/radius.tt" || fail "QEPCAD is not asked"
grep -q "\"reduction\", \"half\", \"\", JLT_PROVED, \"\", \"$digest\"" "$scratch/targets/spiral/table.c" ||
    fail "an edited target: $(grep '"reduction"' "$scratch/targets/spiral/table.c")"

# With --keep, a file that is gone is written again.
cp -r "$scratch/whole" "$scratch/kept"
(cd "$scratch/whole" && find . -type f) | while IFS= read -r file; do
    rm "$scratch/kept/$file"
    ttc generate --keep "$model" --out "$scratch/kept" && diff -r "$scratch/kept" "$scratch/whole" || echo "without $file: $?"
done > "$scratch/out" 2>&1
[ ! -s "$scratch/out" ] || fail "with --keep: $(head -5 "$scratch/out")"

# Two versions written to one folder at the same time: both runs succeed, and what is left is one of them.
mkdir "$scratch/edited"
sed 's/+ a\*w^2/+ 2*a*w^2/' "$model" > "$scratch/edited/${model##*/}"
expect 0 "an edited table" ttc generate --unproved "$scratch/edited/${model##*/}" --out "$scratch/other"
cmp -s "$scratch/whole/manifest.tsv" "$scratch/other/manifest.tsv" && fail "the edited table is the same"
for k in $(seq 1 8); do
    rm -rf "$scratch/both"
    ttc generate "$model" --out "$scratch/both" > /dev/null 2> "$scratch/err" &
    ttc generate --unproved "$scratch/edited/${model##*/}" --out "$scratch/both" > /dev/null 2>&1 ||
        fail "at the same time, $k: status $?"
    wait $! || fail "at the same time, $k: $(cat "$scratch/err")"
    diff -rq "$scratch/both" "$scratch/whole" > /dev/null || diff -rq "$scratch/both" "$scratch/other" > "$scratch/out" ||
        fail "at the same time, $k: files of both: $(head -1 "$scratch/out")"
done

# A run that waits for another one can be ended, and has changed nothing. It is seen to wait where the kernel lists it so.
rm -rf "$scratch/both"
cp -r "$scratch/other" "$scratch/both"
inode=$(stat -c %i "$scratch/both")
exec 9< "$scratch/both"
flock 9
set -m
ttc generate "$model" --out "$scratch/both" > /dev/null 2>&1 9<&- &
job=$!
set +m
for _ in $(seq 600); do grep -q -- "-> FLOCK.*:$inode " /proc/locks && break; sleep 0.1; done
kill -INT $job
for _ in $(seq 100); do kill -0 $job 2> /dev/null || break; sleep 0.1; done
kill -0 $job 2> /dev/null && fail "SIGINT does not end a run that waits for another one"
exec 9<&-
wait $job 2> /dev/null
diff -r "$scratch/both" "$scratch/other" || fail "a run that is ended while it waits has written"

# Stopped at eight moments of its life by each signal. Files of an earlier version are there already: afterwards each
# is the old one or the new one, and only SIGKILL may leave files of both versions, or a temporary file.
for signal in INT TERM QUIT XCPU KILL; do
    for k in $(seq 1 8); do
        rm -rf "$scratch/killed"
        cp -r "$scratch/whole" "$scratch/killed"
        find "$scratch/killed" -type f -exec sh -c 'for f; do echo old > "$f"; done' sh {} +
        # With job control, because a background job of a script ignores SIGINT otherwise.
        set -m
        ttc generate "$model" --out "$scratch/killed" > /dev/null 2>&1 &
        job=$!
        set +m
        sleep "$(awk -v ns="$lasts" -v k="$k" 'BEGIN { printf "%.6f", ns * 1e-9 * k / 8 }')"
        kill -$signal $job 2>/dev/null
        wait $job 2>/dev/null
        fresh=0 stale=0
        while IFS= read -r file; do
            if [ ! -e "$scratch/whole/$file" ]; then
                [ $signal = KILL ] || fail "SIG$signal at $k/8: leaves $file"
            elif cmp -s "$scratch/killed/$file" "$scratch/whole/$file"; then
                fresh=$((fresh + 1))
            elif [ "$(cat "$scratch/killed/$file")" = old ]; then
                stale=$((stale + 1))
            else
                fail "SIG$signal at $k/8: $file is neither the old one nor the new one"
            fi
        done < <(cd "$scratch/killed" && find . -type f)
        [ $signal = KILL ] || [ $fresh -eq 0 ] || [ $stale -eq 0 ] ||
            fail "SIG$signal at $k/8: files of two versions together: $fresh new, $stale old"
    done
    expect 0 "a run after SIG$signal" ttc generate "$model" --out "$scratch/killed"
    while IFS= read -r file; do
        cmp -s "$scratch/killed/$file" "$scratch/whole/$file" || fail "after SIG$signal: $file differs"
    done < <(cd "$scratch/whole" && find . -type f)
done
exit $status
