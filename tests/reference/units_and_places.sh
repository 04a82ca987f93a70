#!/usr/bin/env bash
# What a command finds out about a table it finds wherever the table's motion is, and in whatever units its numbers are: nothing
# hangs on a few points that no orbit comes to.
set -uo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
export XDG_CACHE_HOME=$scratch/cache LC_ALL=C
status=0
fail() { echo "$*" | cut -c1-400; status=1; }
row() { "$@" 2> err | grep -v '^#' | tail -1; }

# 1. Labels of units change nothing where a plain number hides a unit: v/10 is by 10 s. Where x < y the field has no value.
cat > bead.tt <<'TABLE'
model bead
param R > 0 [m]
param k [m/s^2]
default R = 1000, k = 1
state x [m]
state y [m]
state v [m/s]
domain apart : x - y > 0
root r = sqrt((x - y)/R)
eq x = v
eq y = v/2
eq v = -k*r - v/10
TABLE
sed 's/ \[[^]]*\]//' bead.tt > plain.tt
for R in 1 1000; do
    for table in bead plain; do row jellett simulate ./$table.tt --set R=$R --start x=10,y=3,v=40 --times 1 > $table.row; done
    grep -q alive plain.row && cmp -s bead.row plain.row || fail "R = $R: $(cat bead.row), without labels $(cat plain.row)"
done

# 2. An oscillator in two directions about y = c, wherever that is: z' = w, w' = -z, with y = c + z.
about() { # C INTERVAL: its tables
    cat > rising.tt <<TABLE
model rising
param H
default H = 1/20
state y $2
state py
let q = 2*H - py^2 - (y - $1)^2
domain reached : q > 0
root px = sqrt(q)
lift into pair.tt with x = 0, y = y, px = px, py = py
start regular : y = $1, py = 0
TABLE
    cat > pair.tt <<TABLE
model pair
state x
state y $2
state px
state py
eq x = px
eq y = py
eq px = -x - x^2/4
eq py = -(y - $1)
integral H = (px^2 + py^2 + x^2 + (y - $1)^2)/2 + x^3/12
reversor px -> -px, py -> -py
section cut : by rising.tt at x = 0 with y = y, py = py, H = H
TABLE
}
for c in 0 10 1000; do
    about $c ""
    row jellett section ./pair.tt --direction down --start y=$c.1,py=0 --returns 1 > out
    grep -q 'crossed the other way' err || fail "c = $c: the other half is taken for this one: $(cat out err)"
done
about 0 'in (-1000, 1000)'
row jellett section ./pair.tt --start y=0.1,py=0 --returns 1 > out
grep -q 'alive$' out || fail "a section in a wide interval: $(cat err)"

# 3. A period that is proved is not doubted where the field has no value; one that is none is refused, small as the force may be.
cat > far.tt <<'TABLE'
model far
state x
state v
state phi
angle c s = cos(phi) sin(phi)
domain far : x - 10 > 0
root q = sqrt(x - 10)
eq x = v
eq v = 2 - q + c/10
eq phi = 2
periodic phi = 2*pi
TABLE
row jellett section ./far.tt --section phi=0 --start x=14,v=0.1 --returns 2 > out
grep -q 'alive$' out || fail "a proved period: $(cat err)"
cat > weak.tt <<'TABLE'
model weak
param A
default A = 1e-12
state x
state v
state phi
angle c s = cos(6/5*phi) sin(6/5*phi)
eq x = v
eq v = -x - v/5 + A*c
eq phi = 1
TABLE
for A in 1 1e-12; do
    row jellett section ./weak.tt --set A=$A --section phi=0 --modulo phi=4 --start x=0,v=0 --returns 1 > out
    grep -q 'phi is no angle' err || fail "A = $A: 4 is no period: $(cat out)"
    row jellett section ./weak.tt --set A=$A --section phi=0 --modulo phi=5*pi/3 --start x=0,v=0 --returns 1 > out
    grep -q 'alive$' out || fail "A = $A: 5 pi/3 is one: $(cat err)"
done

# 4. The orbit x = px = 0 lies in the section x = 0, at the edge of the level. It is no point of the map, nor are many.
about 0 ""
jellett orbits ./pair.tt --period 1 --grid y=-0.3:0.3:12,py=-0.3:0.3:12 > out 2> err || fail "orbits: $(cat err)"
awk -F, '/^1,/ { rows++; n += $2^2 + $3^2 > 0.0999 } END { exit !rows || n > 0 }' out ||
    fail "orbits along the section: $(grep ^1, out)"

# 5. A length that has nothing to do with the motion is no measure of its errors. x = cos(sqrt(5) t), to 1e-12 a return.
cat > inert.tt <<'TABLE'
model inert
param L > 0 [m]
param k > 0 [1/s^2]
default L = 1, k = 5
state x [m]
state v [m/s]
eq x = v
eq v = -k*x
integral H = v^2/2 + k*x^2/2
observe far = L [m]
TABLE
for L in 1 1e12 1e100; do
    row jellett simulate ./inert.tt --set L=$L --start x=1,v=0 --times 100 > out
    awk -F, '{ d = $2 - cos(100*sqrt(5)); h = $3^2/2 + 5*$2^2/2 - 2.5; good = d*d < 1e-20 && h*h < 1e-20 && $4 < 1e-10 }
        END { exit !good }' out ||
        fail "L = $L: $(cat out)"
done

# 6. A multiplier below rounding on a section of one coordinate is what the divergence says it is: exp of its integral.
cat > relaxing.tt <<'TABLE'
model relaxing
param mu > 0
default mu = 10
state x
state y
eq x = y
eq y = mu*(1 - x^2)*y - x
TABLE
row jellett orbits ./relaxing.tt --section x=0 --start y=15 --period 1 > out
awk -F, '{ good = $4 == $5 && $5 == $6 && $5 > 3.5e-136 && $5 < 3.9e-136 } END { exit !good }' out ||
    fail "a small multiplier: $(cat out)"

# 7. The limits at a pole are told as the last row has them, beside velocities of any size.
far=R=1e18,g=1e18,a3=0.51e18,I1=1e36/3,I3=1e36/3
row jellett simulate --set $far --start gamma3=0.25,v_nu=0.8e18,omega_tau=-0.6,omega_n=1.1,omega3=-2.3 --times 200 > out
awk -F, 'NR == FNR { tau = $4; spin = $6; next } match($0, /omega_tau = [^,]*/) { told = substr($0, RSTART + 12, RLENGTH - 12) }
    match($0, /omega3 = [^;]*/) { turn = substr($0, RSTART + 9, RLENGTH - 9) }
    function off(a, b) { return a > b ? a - b : b - a }
    END { exit !(tau > 0.37 && spin < -1.86 && off(told, tau) < 1e-9 && off(turn, spin) < 1e-8) }' out err ||
    fail "limits at a pole: $(cat out err)"

# 8. Momenta that a field shifts by a are small or large with a: that -px is on another level is seen at every size. A turn is 2 pi.
cat > shifted_up.tt <<'TABLE'
model shifted_up
param a > 0
param H
default a = 1, H = 1/20
state y
state py
let q = 2*H - py^2 - y^2
domain reached : q > 0
root speed = sqrt(q)
let px = speed - a
lift into shifted.tt with x = 0, y = y, px = px, py = py
TABLE
cat > shifted.tt <<'TABLE'
model shifted
param a > 0
default a = 1
state x
state y
state px
state py
eq x = px + a
eq y = py
eq px = -x
eq py = -y
integral H = ((px + a)^2 + py^2 + x^2 + y^2)/2
section cut : by shifted_up.tt at x = 0 with y = y, py = py, H = H
TABLE
for a in 1 1e-5 1e-7 1e-9 1e-12 1e12; do
    at=$(awk "BEGIN { printf \"%.17g,%.17g\", $a*$a/20, $a/10 }")
    row jellett section ./shifted.tt --set a=$a --level H="${at%,*}" --start y="${at#*,}",py=0 --returns 1 > out
    awk -F, -v a=$a '$NF == "alive" { good = ($3 - 6.283185307179586)^2 < 1e-22 && ($4/a - 0.1)^2 < 1e-22 }
        END { exit !good }' out ||
        fail "shifted by $a: $(cat out err)"
done
exit $status
