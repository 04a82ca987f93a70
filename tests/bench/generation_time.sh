#!/usr/bin/env bash
# With quick effort, the default, the kernels of a table come while one waits: those of spherical_top.tt in a second of
# processor time, of two states with 500 monomials of degrees up to 40 in five, and of 32 states with 264 quadratic terms
# each in five.
set -uo pipefail
awk() { LC_ALL=C command awk "$@"; } # numbers have points in any locale
grep -q '^CMAKE_BUILD_TYPE:STRING=Release' "$JLT_BINARY_DIR/CMakeCache.txt" ||
    { echo "times are those of a release build"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
status=0

# Terms without a pattern, the same on every machine (a linear congruential generator modulo 2^31 - 1).
awk 'function random(n) { seed = (seed * 48271) % 2147483647; return seed % n }
BEGIN {
    seed = 7
    print "model monomials\nstate x\nstate y"
    for (equation = 0; equation < 2; equation++) {
        print "eq " (equation ? "y" : "x") " ="
        for (count = 0; count < 250;) {
            a = 1 + random(20); b = 1 + random(20)
            if ((equation, a, b) in used) continue
            used[equation, a, b] = 1
            printf "    %s %d/%d*x^%d*y^%d\n", random(2) ? "+" : "-", 1 + random(9999), 2 + random(9997), a, b
            count++
        }
    }
}' > monomials.tt
awk 'function random(n) { seed = (seed * 48271) % 2147483647; return seed % n }
BEGIN {
    seed = 11
    print "model quadratic"
    for (i = 0; i < 32; i++) print "state u" i
    for (i = 0; i < 32; i++) {
        print "eq u" i " ="
        for (j = 0; j < 32; j++) for (k = j; k < 32; k++)
            if (random(2)) printf "    %s %d/%d*u%d*u%d\n", random(2) ? "+" : "-", 1 + random(999), 2 + random(997), j, k
    }
}' > quadratic.tt
[ "$(grep -c '^    [+-]' monomials.tt)" -eq 500 ] && [ "$(grep -c '^    [+-]' quadratic.tt)" -gt 8000 ] ||
    { echo "the tables are not what they should be"; exit 1; }

# Processors differ, and the same one is not always as fast: a second is what gzip needs for so much text, by which the bounds leave
# a fifth to differences between machines.
for _ in $(seq 40); do cat quadratic.tt; done > text

# The less of two, in seconds of processor time: what else runs takes caches and clock away, and adds to it.
least() { # COMMAND...
    local TIMEFORMAT='%U %S' k
    for k in 1 2; do { time "$@" > out.said 2>&1 || echo 1000; } 2>&1; done |
        awk '{ sum = $1 + $2; if (NR == 1 || sum < best) best = sum } END { print best }'
}
second=$(least gzip -9 -c text)
within() { # SECONDS TABLE
    local taken
    taken=$(least ttc generate --out out "$2")
    awk -v taken="$taken" -v most="$1" -v second="$second" 'BEGIN { exit !(taken <= most * second) }' && return
    echo "$2: $taken s of processor time, which is more than $1 where gzip takes $second s for what takes one"
    cat out.said
    status=1
}
within 1 "$JLT_SOURCE_DIR/codegen/models/spherical_top.tt"
within 5 monomials.tt
within 5 quadratic.tt
exit $status
