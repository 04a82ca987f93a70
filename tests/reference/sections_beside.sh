#!/usr/bin/env bash
# A section that stands in a smaller table of the user's own: found, planned, in batches, and refused where the smaller table does
# not know what the model's conditions are.
set -uo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
export XDG_CACHE_HOME=$scratch/cache LC_ALL=C
status=0
fail() { echo "$*"; status=1; }
expect() { # STATUS WORDS COMMAND...
    local want=$1 words=$2 code
    shift 2
    "$@" > out 2> err < /dev/null
    code=$?
    [ $code -eq "$want" ] || fail "$*: status $code, not $want: $(head -c 300 err)"
    grep -qE -- "$words" out err || fail "$*: '$words' is in neither '$(head -c 300 out)' nor '$(head -c 300 err)'"
}
# A hard spring whose stiffness is a state that stays; the smaller table has it as a parameter, and sees the spring where it turns.
cat > big.tt <<'TABLE'
model big
state x
state p
state z in (0, inf)
eq x = p
eq p =
    - z*x
    - x^3
eq z = 0*z
integral K = z
reduction held : by small.tt with x = x, p = p, K = K
TABLE
cat > small.tt <<'TABLE'
model small
param K > 0
default K = 1
state x
state p
eq x = p
eq p =
    - K*x
    - x^3
integral E = p^2/2 + K*x^2/2 + x^4/4
embedding whole : into big.tt with x = x, p = p, z = K
section turning : by turns.tt at p = 0 with x = x
TABLE
printf 'model turns\nparam K > 0\ndefault K = 1\nstate x\nlift into small.tt with x = x, p = 0\nstart regular : x = -1\n' > turns.tt

# The period is 4 F/sqrt(K + x0^2), F the complete elliptic integral of parameter x0^2/(2 (K + x0^2)): by the arithmetic-geometric
# mean pi/(2 agm(1, sqrt(1 - m))).
period() { awk -v K="$1" -v x="$2" 'BEGIN { a = 1; b = sqrt(1 - x^2/(2*(K + x^2))); for (i = 0; i < 30; i++) { c = (a + b)/2;
    b = sqrt(a*b); a = c }
    printf "%.17g", 2*3.141592653589793/a/sqrt(K + x^2) }'; }
for K in 1 2; do
    for how in '' '--start x=-0.5'; do # two orbits go in lanes
        expect 0 '^# levels K=' jellett section ./big.tt --level K=$K --start x=-1 --returns 3 $how
        awk -F, -v T="$(period $K 1)" \
            '/^0,[0-3],/ { n++; bad += ($3 - $2*T)^2 + ($4 + 1)^2 > 1e-22 } END { exit !(n == 4 && !bad) }' out ||
            fail "K = $K $how: T = $(period $K 1), not $(tail -3 out)"
    done
done
# All of its orbits are periodic: the one asked for is found, and no other of the family.
expect 0 '^1,-(1|0.99999999)' jellett orbits ./big.tt --start x=-1 --period 1
expect 0 '^  \* small .*the smallest that answers' jellett plan section ./big.tt --start x=-1
grep -q 'on levels K=1 (an integral, proved)' out || fail "the plan: $(cat out)"

# A condition of the model alone would be passed over; said in both tables, it ends orbits.
echo 'valid near : 4 - x^2 > 0' >> big.tt
expect 3 "does not say where near of this table is lost: write 'valid near" jellett section ./big.tt --start x=-3
expect 3 "does not say where near" jellett fates ./big.tt --grid x=-3:-1:2
expect 0 'lost_near' jellett section ./big.tt --section p=0 --start x=-3,z=1 --contact end --returns 1
echo 'valid near : 4 - x^2 > 0' >> small.tt
expect 0 '^0,0,0,-3,lost_near$' jellett section ./big.tt --start x=-3 --contact end --returns 1
expect 0 '^0,1,.*,alive$' jellett section ./big.tt --start x=-1 --contact end --returns 1
exit $status
