#!/usr/bin/env bash
# A claim whose proof outgrows the machine is not settled, by name, and takes no other claim with it: the characteristic
# polynomial of a full symbolic 9 x 9 matrix of fractions, beside a trace that is proved.
set -uo pipefail
awk() { LC_ALL=C command awk "$@"; } # numbers have points in any locale
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
awk 'BEGIN {
    n = 9
    print "model dense"
    for (i = 0; i < n; i++) for (j = 0; j < n; j++) print "param a" i j
    for (i = 0; i < n; i++) print "state x" i
    for (i = 0; i < n; i++) {
        print "eq x" i " ="
        for (j = 0; j < n; j++) print "    + a" i j "*x" j "/(1 + a" j i "^2)"
    }
    printf "equilibria rest : "
    for (i = 0; i < n; i++) printf "%sx%d = 0", i ? ", " : "", i
    print "\ncharpoly rest = lambda^" n
    printf "trace rest = "
    for (i = 0; i < n; i++) printf "%sa%d%d/(1 + a%d%d^2)", i ? " + " : "", i, i, i, i
    print ""
}' > "$scratch/dense.tt"
ttc prove --json "$scratch/dense.tt" > "$scratch/out" 2> "$scratch/err"
status=$?
[ $status -eq 3 ] || { echo "status $status, not 3"; exit 1; }
grep -Eq 'dense\.tt:[0-9]+:[0-9]+: error: the charpoly claim .* passes the limit of' "$scratch/err" ||
    { echo "the limit is not named with its place:"; cat "$scratch/err"; exit 1; }
[ "$(grep -c '"status": "proved"' "$scratch/out")" -eq 2 ] ||
    { echo "claims beside it are not proved:"; cat "$scratch/out"; exit 1; }

# A claim that needs QEPCAD is proved where no file in /tmp can be made.
printf '%s\n' 'model hill' 'state x' 'state y' 'eq x = -x' 'eq y = -y' \
    'positive above : x^4*y^2 + x^2*y^4 - 3*x^2*y^2 + 1 + 1/100' > "$scratch/hill.tt"
shut() { # the program and the folder may lie in /tmp
    unshare --mount bash -c 'mount -t tmpfs -o nr_inodes=1 none /tmp && cd /dev/fd/9 && exec /dev/fd/8 prove hill.tt' \
        8< "$(command -v ttc)" 9< "$scratch"
}
if unshare --mount true 2> /dev/null; then
    shut > "$scratch/out" 2>&1 || { echo "where /tmp is full:"; cat "$scratch/out"; exit 1; }
else echo "skipped: no /tmp of its own may be mounted"; fi
# Where no process can be made, the reason is told.
(ulimit -n 5; exec ttc prove "$scratch/hill.tt") > "$scratch/out" 2>&1
[ $? -eq 4 ] && grep -q 'Too many open files' "$scratch/out" || { echo "few descriptors:"; cat "$scratch/out"; exit 1; }
# Where the shell allows less memory, that limit is named, and a verdict that it leaves open does not outlast it in the cache.
printf '%s\n' 'model powers' 'param a' 'param b' 'state x' 'state y' 'state z' 'state w' \
    'eq x = y' 'eq y = -x' 'eq z = w' 'eq w = -z' \
    'equal same : (x + y + z + w + a + b)^24*(x - y + z - a)^12 = ((x + y + z + w + a + b)^2*(x - y + z - a))^12' \
    > "$scratch/powers.tt"
cp "$scratch/powers.tt" "$scratch/more.tt"
export XDG_CACHE_HOME=$scratch/cache
(ulimit -v 147456; exec ttc build "$scratch/powers.tt") > "$scratch/small" 2> "$scratch/err"
if grep -q 'AddressSanitizer\|ThreadSanitizer' "$scratch/err"; then echo "skipped: a sanitizer needs more memory"; exit 0; fi
grep -q "the equal claim 'same' is not settled (its proof passes the limit of 144 MiB)" "$scratch/err" ||
    { echo "little memory:"; cat "$scratch/small" "$scratch/err"; exit 1; }
ttc build "$scratch/powers.tt" > "$scratch/large" 2> "$scratch/err" && [ ! -s "$scratch/err" ] &&
    ! cmp -s "$scratch/small" "$scratch/large" || { echo "more memory:"; cat "$scratch/large" "$scratch/err"; exit 1; }
# Where memory is out before the solver begins, the proof does not fail by a signal.
for limit in $(seq 50000 1000 75000); do
    (ulimit -v $limit; exec ttc prove "$scratch/hill.tt") > "$scratch/out" 2>&1
    ! grep 'by signal' "$scratch/out" || { echo "within $limit KiB"; exit 1; }
done
# Where the system kills a proof, the next run tries again.
ttc build "$scratch/more.tt" > "$scratch/small" 2> "$scratch/err" &
build=$!
for wait in $(seq 100); do
    pkill -KILL -P $build && break
    sleep 0.02
done
wait $build && grep -q "is not settled (its proof was ended by the system" "$scratch/err" && [ -s "$(cat "$scratch/small")" ] ||
    { echo "a proof is killed:"; cat "$scratch/small" "$scratch/err"; exit 1; }
ttc build "$scratch/more.tt" > "$scratch/large" 2> "$scratch/err" && [ ! -s "$scratch/err" ] &&
    ! cmp -s "$scratch/small" "$scratch/large" || { echo "after a proof was killed:"; cat "$scratch/large" "$scratch/err"; exit 1; }
# So with --keep, which leaves files that another run would write.
ttc generate --out "$scratch/kept" "$scratch/more.tt" 2> "$scratch/err" &
generate=$!
for wait in $(seq 100); do
    pkill -KILL -P $generate && break
    sleep 0.02
done
wait $generate && grep -q "is not settled (its proof was ended by the system" "$scratch/err" &&
    ttc generate --keep --out "$scratch/kept" "$scratch/more.tt" &&
    grep -q '"same", "", JLT_PROVED' "$scratch/kept/powers/table.c" ||
    { echo "with --keep, after a proof was killed:"; cat "$scratch/err"; grep '"same"' "$scratch/kept/powers/table.c"; exit 1; }
# A limit of processor time is named and forgotten likewise.
for k in $(seq 2 8); do sed -n "s/^equal same/&$k/p" "$scratch/powers.tt"; done > "$scratch/more"
cat "$scratch/more" >> "$scratch/powers.tt"
(ulimit -t 1; exec ttc build "$scratch/powers.tt") > "$scratch/small" 2> "$scratch/err"
grep -q "is not settled (its proof was ended by the system" "$scratch/err" ||
    { echo "little time:"; cat "$scratch/small" "$scratch/err"; exit 1; }
ttc build "$scratch/powers.tt" > "$scratch/large" 2> "$scratch/err" && [ ! -s "$scratch/err" ] &&
    ! cmp -s "$scratch/small" "$scratch/large" || { echo "more time:"; cat "$scratch/large" "$scratch/err"; exit 1; }
