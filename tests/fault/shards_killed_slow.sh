#!/usr/bin/env bash
# A shard that is killed at any moment, or meets a full disk, keeps every piece that it had written whole, computes none of them
# again, and goes on to the same bytes. Twenty times at random moments, each time one of three shards that are computing together.
set -uo pipefail
scratch=$(mktemp -d)
# A process that is killed before it is jellett is still this shell, and must not clear away what is its.
clear() { [ $BASHPID = $$ ] || return; kill $(jobs -p) 2> /dev/null; wait; umount "$scratch/disk" 2> /dev/null; rm -rf "$scratch"; }
trap clear EXIT
cd "$scratch" || exit 1
status=0
fail() { echo "$*"; status=1; }
cat > ends.scene << 'END'
levels = { E = 2.15; G = -0.56; };
accuracy = { tolerance = 1e-10; };
piece = 3;
compute = ( { what = "fates"; grid = "240x160"; returns = 100; } );
END
jellett sweep ends.scene --into=whole --shard=1/1 2> log || { cat log; exit 1; }
jellett merge whole -o whole.csv -o whole.sqlite
there() { sed -n 's/.* pieces, \([0-9]*\) of them are there/\1/p' "$1"; }

RANDOM=7
kills=0
for _ in $(seq 60); do
    pids=()
    for i in 1 2 3; do
        jellett sweep ends.scene --into=shards --shard=$i/3 --resume 2> log.$i &
        pids[i]=$!
    done
    victim=$((1 + RANDOM % 3))
    sleep "0.$(printf %03d $((RANDOM % 300)))"
    kill -9 "${pids[victim]}" 2> /dev/null
    [ -s shards/$victim-of-3.shard ] && cp shards/$victim-of-3.shard before
    for i in 1 2 3; do [ $i = $victim ] || kill -TERM "${pids[i]}" 2> /dev/null; done
    wait "${pids[victim]}"
    killed=$?
    wait
    [ $killed = 137 ] && kills=$((kills + 1))
    # What is whole in the file is there when it is opened again.
    whole=$([ -e before ] && grep -ac '^piece ' before)
    : > log # or what it said the time before is read
    jellett sweep ends.scene --into=shards --shard=$victim/3 --resume 2> log & again=$!
    for _ in $(seq 200); do grep -q 'are there' log && break; sleep 0.01; done
    kill -TERM $again 2> /dev/null
    wait $again
    [ "${whole:-0}" -lt 2 ] || { [ -n "$(there log)" ] && [ "$(there log)" -ge $((whole - 1)) ]; } ||
        fail "killed with $whole records in the file, $(there log) of which are there then"
    [ $kills -ge 20 ] && break
done
[ $kills -ge 20 ] || fail "killed only $kills times: the study is too short"
for i in 1 2 3; do jellett sweep ends.scene --into=shards --shard=$i/3 --resume 2> log || fail "shard $i of 3: $(cat log)"; done
jellett merge shards -o again.csv -o again.sqlite
cmp again.csv whole.csv && cmp again.sqlite whole.sqlite || fail "killed $kills times: other bytes"
! cat shards/*.shard | grep -a '^piece ' | cut -d' ' -f2 | sort | uniq -d | grep -q . || fail "pieces were computed twice"

# A full disk: a limit on the size of files, and, where it can be had, a small disk.
full() { # TITLE FOLDER
    grep -qE 'File too large|No space left' log && grep -q -- '--resume goes on' log || fail "$1: $(cat log)"
}
(ulimit -f 40; trap '' XFSZ; exec jellett sweep ends.scene --into=limited --shard=1/1) 2> log
[ $? = 5 ] || fail "a limit on files: status is not 5"
full "a limit on files"
jellett sweep ends.scene --into=limited --shard=1/1 --resume 2> log || fail "after a limit on files: $(cat log)"
! grep -q 'are cut' log || fail "a limit on files: half a record was left"
jellett merge limited -o again.csv && cmp again.csv whole.csv || fail "a limit on files: other bytes"
mkdir disk
if mount -t tmpfs -o size=64k none disk 2> /dev/null; then
    jellett sweep ends.scene --into=disk/ends --shard=1/1 2> log
    [ $? = 5 ] || fail "a full disk: status is not 5"
    full "a full disk"
    mount -o remount,size=10m disk
    jellett sweep ends.scene --into=disk/ends --shard=1/1 --resume 2> log || fail "after a full disk: $(cat log)"
    jellett merge disk/ends -o again.csv && cmp again.csv whole.csv || fail "a full disk: other bytes"
    mount -o remount,size=64k disk 2> /dev/null
else echo "skipped: no disk of its own may be mounted"; fi
exit $status
