#!/usr/bin/env bash
# The verdict of a condition is that of the table's units, whatever units a problem is counted in: a number beside a length is one
# in metres.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
run() { # STATUS OPTION...
    local want=$1 code
    shift
    jellett "$@" > out 2> err < /dev/null
    code=$?
    [ $code -eq "$want" ] || fail "jellett $*: status $code: $(cat err)"
}
near() { awk -v a="$1" -v b="$2" 'BEGIN { d = a - b; exit !(d < 1e-11 && d > -1e-11) }'; }

# a = 10 cos t. The unit of length is that of L, so that a is counted in hundreds of metres; the coordinates are good while a > -3
# m.
cat > spring.tt <<'T'
model spring
param L > 0 [m] "what lengths are compared with"
param w > 0 [rad/s]
default L = 1000, w = 1
state a [m]
state b [m/s]
eq a = b
eq b = - w^2*a
observe part = a/L
tier near while a + 3 > 0 "near"
T
end=$(awk 'BEGIN { c = -0.3; printf "%.17g", atan2(sqrt(1 - c*c), c) }')
for L in 1 1000 1e6 1e-6; do
    run 4 simulate ./spring.tt --set L=$L --start a=10,b=0 --times 1,3
    [ "$(tail -1 out | cut -d, -f5)" = left_domain ] && near "$(tail -1 out | cut -d, -f1)" "$end" &&
        near "$(tail -1 out | cut -d, -f2)" -3 ||
        fail "L = $L: $(tail -1 out)"
done

# On a circle of radius r; the way there is meant where a < 3 m, and the orbit goes on in the table asked where it comes to that
# edge.
cat > turning.tt <<'T'
model turning
param L > 0 [m]
default L = 1000
param r > 0 [m]
state phi [rad]
angle C S = cos(phi) sin(phi)
eq phi = - L/L
embedding out : into spring.tt with a = r*C, b = r*S, w = 1
periodic phi = 2*pi
tier circle while 5 - r*C > 0 "a circle"
T
sed -i 's/ while a + 3 > 0//' spring.tt
echo 'reduction left : by turning.tt with phi = atan2(b, a), r = sqrt(a^2 + b^2) when w = 1 where 3 - a > 0' >> spring.tt
ttc prove spring.tt turning.tt > proofs || fail "claims: $(cat proofs)"
for L in 1 1000 1e6 1e-6; do
    run 0 simulate ./spring.tt --set L=$L --start a=-10,b=0 --times 1,3
    end=$(awk 'BEGIN { c = -0.5; printf "%.10g", atan2(sqrt(1 - c*c), c) }')
    grep -q "from t = ${end:0:9}[0-9]* on the tier near in place of circle" err || fail "L = $L: $(cat err)"
    near "$(tail -1 out | cut -d, -f2)" "$(awk 'BEGIN { printf "%.17g", -10*cos(3) }')" || fail "L = $L: $(tail -1 out)"
done

# A section whose coordinates are metres and metres a second without saying so: its returns are those of the table's own states.
cat > stiff.tt <<'T'
model stiff
param L > 0 [m]
param w > 0 [rad/s]
default L = 1000, w = 1
state a [m]
state b [m/s]
state h [m]
state q [m/s]
eq a = b
eq b = - w^2*a - w^2*a^3/L^2
eq h = q
eq q = - 4*w^2*h
integral N = (4*w^2*h^2 + q^2)/2
section cut : by stiff_cut.tt at h = 0 with u = a, v = b, N = N
T
cat > stiff_cut.tt <<'T'
model stiff_cut
param N > 0
param L > 0 [m]
param w > 0 [rad/s]
default N = 1, w = 1, L = 1
state u
state v
root q = sqrt(2*N*L/L)
lift into stiff.tt with a = u, b = v, h = 0, q = q
T
ttc prove stiff.tt > proofs || fail "claims: $(cat proofs)"
for L in 1000 3e5; do
    run 0 section ./stiff.tt --set L=$L --section h=0 --start a=-200,b=0.5,q=1.4142135623730951 --returns 2 --tol 1e-14
    own=$(tail -1 out)
    run 0 section ./stiff.tt --set L=$L --start u=-200,v=0.5 --returns 2
    for column in 3 4 5; do
        near "$(tail -1 out | cut -d, -f$column)" "$(echo "$own" | cut -d, -f$column)" ||
            fail "section, L = $L: $(tail -1 out), not $own"
    done
done

# A variant that sets a quantity with a unit to a number holds in the table's units alone: motions, returns and drifts are those of
# the same table without units.
cat > quartic.tt <<'T'
model quartic
param a > 0 [m^-2*s^-2]
default a = 1
state x [m]
state y [m]
state px [m/s]
state py [m/s]
eq x = px
eq y = py
eq px = - a*x^3
eq py = - 2*a*y^3
variant one : a = 1
integral H = (px^2 + py^2)/2 + a*x^4/4 + a*y^4/2
integral part = px^2/2 + x^4/4 when a = 1
section up : by quartic_up.tt at x = 0 with y = y, py = py, H = H
T
cat > quartic_up.tt <<'T'
model quartic_up
param a > 0 [m^-2*s^-2]
param H [m^2/s^2]
default a = 1, H = 50
state y [m]
state py [m/s]
let square = 2*H - py^2 - a*y^4
domain reached : square > 0
root px = sqrt(square)
lift into quartic.tt with x = 0, y = y, px = px, py = py
T
sed 's/ \[.*\]//; s/quartic/bare/' quartic.tt > bare.tt
sed 's/ \[.*\]//; s/quartic/bare/' quartic_up.tt > bare_up.tt
ttc prove quartic.tt bare.tt > proofs || fail "claims: $(cat proofs)"
for command in 'simulate TABLE --start x=1,y=3,px=10,py=20 --times 1,5' 'section TABLE --start y=1.9,py=0 --returns 2' \
    'section TABLE --grid y=1:1.9:2,py=0:1:2 --returns 1' 'fates TABLE --grid y=1:1.9:2,py=0:1:2 --returns 2'; do
    run 0 ${command/TABLE/./bare.tt}
    tail -1 out | cut -d, -f1-6 > bare
    run 0 ${command/TABLE/./quartic.tt}
    tail -1 out | cut -d, -f1-6 | awk -F, -v OFS=, '
        NR == FNR { for (i = 1; i <= NF; i++) bare[i] = $i; next }
        { for (i = 1; i <= NF; i++) if ($i != bare[i] && ($i - bare[i])^2 > 1e-20*(1 + $i^2)) exit 1 }' bare - ||
        fail "${command/TABLE/quartic}: $(tail -1 out), not $(cat bare)"
done
run 0 simulate ./quartic.tt --start x=1,y=3,px=10,py=20 --times 1,5
tail -1 out | awk -F, '{ exit !($6 < 1e-11 && $7 < 1e-11) }' || fail "drifts: $(tail -1 out)"

# The end of an interval beside a lifted root is a condition, whose number no units scale: v = t/2 comes to 1 at t = 2, and from 1/4
# at t = 3/2, whatever the length that sets the unit.
cat > lifted.tt <<'TABLE'
model lifted
param a > 0 [m/s^2]
param L > 0 [m]
default a = 1/2, L = 1
state c in (-1, 1)
state w [1/s]
state v in (-1, 1) [m/s]
root s = sqrt(1 - c^2)
eq c = - s*w
eq w = - w*v/(1000*L)
eq v = a
pole c
time regular : s lifting s
TABLE
for L in 1e-3 1 1e3; do
    jellett simulate ./lifted.tt --set L=$L --start c=0.1,w=0.01,v=0 --times 5 > out 2> err
    tail -1 out | awk -F, '{ off = $1 - 2 } END { exit !(off*off < 1e-22 && /left_domain/) }' ||
        fail "v at its end, L = $L: $(tail -1 out)"
    for how in "" "--method gauss"; do
        jellett section ./lifted.tt --section v=1/4 --set L=$L --grid c=0.1,w=0.01:0.02:2 --returns 1 $how > out 2> err
        grep '^[01],1,' out | awk -F, '{ off = $3 - 3/2; n += off*off < 1e-22 && /left_domain/ } END { exit n != 2 }' ||
            fail "v at its end, L = $L ${how:-in lanes}: $(tail -2 out)"
    done
done
exit $status
