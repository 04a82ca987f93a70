#!/usr/bin/env bash
# Which crossings of a section count does not hang on the tolerance: a regular orbit that stays within 5e-6 of the section has the same
# returns at all of them and by every method.
set -uo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
export XDG_CACHE_HOME=$scratch/cache LC_ALL=C
status=0
fail() { echo "$*"; status=1; }
cp "$JLT_SOURCE_DIR"/tests/reference/data/henon_heiles.tt .

# x'' = -(1 + 2 y) x near x = 0: linear in x, so that it turns as often however small it is. Ten returns err by about the tolerance, a
# hundred by ten times that in y; near x = 0 the time of crossing is that of y's phase.
orbit=(jellett section ./henon_heiles.tt --section x=0 --start y=0.1,py=0,px=4e-6 --returns 100)
"${orbit[@]}" --tol 1e-14 | tail -1 > best
t=$(cut -d, -f3 best)
grep -q '^0,100,' best || fail "no hundred returns: $(cat best)"
for tolerance in 1e-6 1e-7 1e-8 1e-9 1e-10 1e-11 1e-12 1e-13; do
    for how in "--method gauss" "--method dop853" "--method taylor" "--method rk8pd" "--method rkf45" "--method msadams"; do
        # shellcheck disable=SC2086
        "${orbit[@]}" --tol $tolerance $how > out 2> err || fail "$how at $tolerance: status $?: $(cat err)"
        awk -F, -v t="$t" -v e=$tolerance '/^0,/ { rows++ } /^0,100,/ { good = ($3 - t)^2 < (100*e + 1e-11)^2 } END { exit !(rows == 101 && good) }' out ||
            fail "$how at $tolerance: $(grep -c '^0,' out) rows, the last one $(tail -1 out), t = $t"
    done
done

# A table that is compiled behind the command has no kernels on vectors; for one that is built in they count alike.
"${orbit[@]}" --batch > out 2> err
[ $? -eq 2 ] && grep -q "the kernels of henon_heiles follow one orbit at a time: leave out --batch" err || fail "--batch: $(cat err)"
for tolerance in 1e-6 1e-8 1e-10 1e-13; do
    jellett section --start eta=0.44,gamma3=-0.62 --returns 200 --direction both --tol $tolerance | grep -v '^#' | cut -d, -f1,2,9 | md5sum
    jellett section --start eta=0.44,gamma3=-0.62 --returns 200 --direction both --tol $tolerance --batch | grep -v '^#' | cut -d, -f1,2,9 | md5sum
done | sort -u > counts
[ "$(wc -l < counts)" -eq 1 ] || fail "batches count otherwise than single orbits"

# All returns in a fixed time, in both directions, counted: the same at every tolerance.
count() { jellett section ./henon_heiles.tt --section x=0 --direction both --start y=0.1,py=0,px=4e-6 --returns 400 --tol "$1" |
    awk -F, '/^0,[1-9]/ && $3 <= 600 { n++ } END { print n }'; }
for tolerance in 1e-6 1e-8 1e-10 1e-13; do count $tolerance; done | sort -u > counts
[ "$(wc -l < counts)" -eq 1 ] && [ "$(cat counts)" -gt 150 ] || fail "counts differ: $(tr '\n' ' ' < counts)"
exit $status
