#!/usr/bin/env bash
# Orbits on the line that a reversor keeps are found over a grid that has no point near them, and no others are found there; a
# branch that comes to the end of a parameter's domain has come to the end of its range.
source "$JLT_SOURCE_DIR/tests/scratch.sh"

# y = py = 0 is an orbit for every k. There y'' = -(1 + k x^2) y; at k = 1 that has the solution y = x, so that the trace is 2
# exactly, and above k = 1 it is larger.
cat > quartic.tt << 'T'
model quartic
param k > 0
default k = 1.01
state x
state y
state px
state py
eq x = px
eq y = py
eq px = - x - x^3 - k*x*y^2
eq py = - y - k*x^2*y
integral H = px^2/2 + py^2/2 + x^2/2 + x^4/4 + y^2/2 + k*x^2*y^2/2
reversor px -> -px, py -> -py
reversor x -> -x, py -> -py
T
on_axis=(./quartic.tt --section x=0 --level H=1 --solve px=1 --period 1 --grid y=-1:1:8,py=-1:1:8)
jellett orbits "${on_axis[@]}" > out 2> err || fail "orbits: $(cat err)"
grep -v '^#' out | awk -F, 'NR > 1 && $2*$2 + $3*$3 < 1e-16 && $5 > 2 { found++ } END { exit found != 1 }' ||
    fail "the orbit y = py = 0 is not found once, unstable: $(grep -v '^#' out)"
jellett orbits "${on_axis[@]}" --samples 0 > out 2> err || fail "orbits without lines: $(cat err)"

# The damped oscillator drawn by a force: the amplitude over delta >= 0 has no place below 0.
cat > driven.tt << 'T'
model driven
param delta >= 0
default delta = 1/10
state x
state v
state phi
angle c s = cos(phi) sin(phi)
eq x = v
eq v = - 4*x - delta*v + c
eq phi = 1
periodic phi = 2*pi
T
jellett continue ./driven.tt --section phi=0 --start x=0.3,v=0 --along delta=0:0.5 --decreasing > out 2> err ||
    fail "continue: $(cat err)"
grep -q 'the range ends' err || fail "the branch does not end at delta = 0: $(cat err)"
# x = (3 cos t + delta sin t)/(9 + delta^2)
tail -1 out | awk -F, '{ x = 3/(9 + $2*$2); exit !($2 < 1e-5 && $5 - x < 1e-10 && x - $5 < 1e-10) }' ||
    fail "its end: $(tail -1 out)"

# Of a strongly unstable map all that is listed of a line is symmetric, and begins on it: Newton's method goes to no other orbit.
cat > kicked.tt << 'T'
model kicked
state x
state v
state phi
angle c s = cos(phi) sin(phi)
eq x = v
eq v = - x/2 - 3*x*c - x^3
eq phi = 2
periodic phi = 2*pi
reversor v -> -v, phi -> -phi
T
jellett orbits ./kicked.tt --section phi=0 --start x=0,v=0 --line x=-2:2:100 --period 5 > out 2> err || fail "a line: $(cat err)"
grep '^[0-9]' out | awk -F, '$3 != 0 || $11 != "yes" { bad++ } END { exit bad > 0 || NR < 10 }' ||
    fail "on the line v = 0: $(grep '^[0-9]' out | cut -d, -f1-3,10,11)"

# From few points on the lines as many symmetric orbits are found as from many: more are put where orbits differ.
for samples in 300 1000 10000; do
    jellett orbits --set I1=0.5,I3=0.3,a3=0.4 --level E=3.5,G=-0.6 --period 6 --grid 0x0 --samples $samples > out 2> err
    [ "$(grep -c ',yes,' out)" = 14 ] || fail "from $samples points: $(grep -c ',yes,' out) symmetric orbits of 14 $(cat err)"
done
exit $status
