#!/usr/bin/env bash
# Tables that serve in place of one: all ways to each are tried, and tiers of one name are told apart.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
run() { # STATUS OPTION...
    local want=$1 code
    shift
    jellett "$@" > out 2> err < /dev/null
    code=$?
    [ $code -eq "$want" ] || fail "jellett $*: status $code: $(cat err)"
}

long=name_of_three_and_sixty_letters_which_is_all_that_a_table_lends
cat > wide.tt <<T
model wide
state a
state b
state c in (-1, 1)
root s = sqrt(1 - c^2)
eq a = b
eq b = - a
eq c = s*a/8
time regular : s lifting s
pole c
tier $long "all three"
reduction right : by polar.tt with phi = atan2(b, a), r = sqrt(a^2 + b^2), c = c where a > 0
reduction left : by polar.tt with phi = atan2(b, a), r = sqrt(a^2 + b^2), c = c where - a > 0
reduction other : by again.tt with phi = atan2(b, a), r = sqrt(a^2 + b^2), c = c where a + 2 > 0
T
cat > polar.tt <<'T'
model polar
param r > 0
default r = 1
state phi
state c in (-1, 1)
root s = sqrt(1 - c^2)
angle C S = cos(phi) sin(phi)
eq phi = - 1
eq c = s*r*C/8
time regular : s lifting s
pole c
embedding out : into wide.tt with a = r*C, b = r*S, c = c, s = s
periodic phi = 2*pi
tier circle "an angle, on a circle"
T
sed 's/^model polar/model again/; s/on a circle/once more/' polar.tt > again.tt
ttc prove wide.tt polar.tt again.tt > proofs || fail "claims: $(cat proofs)"

# The first way to polar.tt is meant where a > 0, the second where a < 0. phi falls evenly: a = cos t, or -cos t.
for a in 1 -1; do
    run 0 plan simulate ./wide.tt --start a=$a,b=0,c=0 --times 1
    grep -q '^  \* polar.circle .* taken: the smallest that answers' out || fail "from a = $a: $(cat out)"
    run 0 simulate ./wide.tt --start a=$a,b=0,c=0 --times 1
    tail -1 out | awk -F, -v a=$a '{ d = $2 - a*cos(1); exit !(d < 1e-12 && d > -1e-12) }' || fail "from a = $a: $(tail -1 out)"
done

# Two tables have a tier `circle`: neither is taken for the other.
run 0 simulate ./wide.tt --start a=1,b=0,c=0 --times 1 --tier again.circle
grep -q 'tier again.circle' out || fail "the tier is not named: $(grep '^#' out)"
run 3 simulate ./wide.tt --start a=1,b=0,c=0 --times 1 --tier circle
grep -q "there is no tier 'circle' of wide" err || fail "a name of two tiers is taken: $(cat err)"
run 3 simulate ./wide.tt --start a=-3,b=0,c=0 --times 1 --tier again.circle
grep -q 'a + 2 > 0' err || fail "what refuses a way is not said: $(cat err)"

# A name is kept whole, with what is added to it; one that is longer is refused where it is read.
for tier in $long ${long}_plain; do
    run 0 simulate ./wide.tt --start a=1,b=0,c=0 --times 1 --tier $tier
    grep -q "tier $tier:" out || fail "the tier $tier has lost letters: $(grep '^#' out)"
done
sed "s/^tier $long/tier x$long/" wide.tt > longer.tt
ttc check longer.tt > out 2> err && fail "a name of 64 letters is read"
grep -q 'longer.tt:11:6: error: .*63' err || fail "a name of 64 letters: $(cat err)"

# With --track a larger table tells of its own states and quantities. Where another takes its place, which begins at the asked
# states alone, telling ends: a phase, or a quantity of the same name, would go on from another value.
cat > swing.tt <<'T'
model swing
state q
state p
eq q = p
eq p = - q
lift half : into half.tt with q = q, p = p, phi = 0
lift whole : into whole.tt with q = q, p = p, phi = 0, chi = 1
T
cat > half.tt <<'T'
model half
state q
state p
state phi
eq q = p
eq p = - q
eq phi = 1
observe twice = 2*q
reduction onto_half : onto swing.tt with q = q, p = p
tier half while q + 1/2 > 0 "a phase"
T
sed '/^model/s/half/whole/; /^state phi/a state chi
/^eq phi/a eq chi = 2
s/2\*q/7*q/; s/onto_half/onto_whole/; s/^tier.*/tier whole "two"/' half.tt > whole.tt
run 0 simulate ./swing.tt --start q=1,p=0 --until 4 --every 1 --track
grep -q 'on the tier whole in place of half' err || fail "the tier stays: $(cat err)"
awk -F, '/^#/ { next } /^t/ { for (i = 1; i <= NF; i++) at[$i] = i; next }
         { rows++; if ($1 < 2.05 ? $at["phi"] == "" || $at["twice"] == "" : $at["phi"] $at["twice"] != "") bad = 1 }
         END { exit !(!bad && rows == 5 && at["phi"] && at["twice"]) }' out ||
             fail "a later tier is told of as if it went on: $(cat out)"

# Its states have columns though it observes nothing.
sed '/^observe/d; s/model half/model bare/; s/^tier.*/tier bare "a phase"/' half.tt > bare.tt
sed 's/model swing/model simple/; s/half/bare/g; /^lift whole/d' swing.tt > simple.tt
sed -i 's/onto_bare : onto swing/onto_bare : onto simple/; s/onto_half : onto swing/onto_bare : onto simple/' bare.tt
run 0 simulate ./simple.tt --start q=1,p=0 --times 2 --track
grep -q '^t,q,p,phi,fate$' out && grep -q '^2,.*,2,alive$' out || fail "a larger table that observes nothing: $(cat out)"
run 3 simulate ./bare.tt --start q=1,p=0,phi=0 --times 2 --track

# Where a tier of one state ends, at a turning point, its velocity is the root of rounding: the larger tier does not begin there.
cat > spring.tt <<'T'
model spring
param a > 0
param b
default a = 2, b = 3
state x
state v
eq x = v
eq v = - a*x - b*x^3
integral E = v^2/2 + a*x^2/2 + b*x^4/4
tier both "place and velocity"
reduction out : by place.tt with x = x, h = E, w = a where v > 0
T
cat > place.tt <<'T'
model place
param w > 0
param b
param h
default w = 2, b = 3, h = 1
state x
let q = 2*h - w*x^2 - b*x^4/2
domain inside : q > 0
root v = sqrt(q)
eq x = v
tier one "place alone"
embedding spring : into spring.tt with x = x, v = v, a = w
T
run 0 simulate ./spring.tt --start x=0,v=1 --times 0.5,1,4
grep -q 'from t = 0.92872535.* on the tier both in place of one' err || fail "the change of tier: $(cat err)"
grep -v '^#' out | tail -1 | awk -F, '{ d = $2 - 0.27716620375722104; exit !(d < 1e-13 && d > -1e-13) }' \
    || fail "after a turning point: $(tail -1 out)" # Taylor's method, 30 digits; and A sn(t/A)

# A level that is a difference of large numbers loses the digits of a small state: the tier on it is taken only if it is named.
cat > saddle.tt <<'T'
model saddle
state x
state y
eq x = y
eq y = x
integral L = x^2 - y^2
tier both "place and velocity"
reduction up : by branch.tt with x = x, L = L where y > 0
T
cat > branch.tt <<'T'
model branch
param L
default L = 1
state x
domain inside : x^2 - L > 0
root y = sqrt(x^2 - L)
eq x = y
tier one "place alone"
embedding saddle : into saddle.tt with x = x, y = y
T
run 0 simulate ./saddle.tt --start x=2,y=1 --times 0.001
grep -q '^# tier one' out || fail "not the smallest tier: $(cat out)"
run 0 simulate ./saddle.tt --start x=12345.678,y=1 --times 0.001
grep -q '^# tier both' out || fail "a tier without the digits of y: $(cat out)"
grep -v '^#' out | tail -1 | awk -F, '{ d = $3 - 13.345680557613147; exit !(d < 1e-12 && d > -1e-12) }' \
    || fail "y at t = 0.001: $(tail -1 out)" # x sinh t + y cosh t
expect 0 "no: its coordinates lose digits of y there" jellett plan simulate ./saddle.tt --start x=12345.678,y=1 --times 0.001
run 0 simulate ./saddle.tt --start x=12345.678,y=1 --times 0.001 --tier one
exit $status
