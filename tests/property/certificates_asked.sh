#!/usr/bin/env bash
# A certificate is one of what was asked, exactly: of a section's value as its table has it, of turns in the periods of the table,
# and of a sink with any number of multipliers.
set -uo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
export TMPDIR=$scratch XDG_CACHE_HOME=$scratch/cache LC_ALL=C
status=0
fail() { echo "$*"; status=1; }
expect() { # STATUS TEXT COMMAND...
    local code=$1 text=$2 got=0
    shift 2
    "$@" > out 2> err || got=$?
    [ $got -eq "$code" ] && { [ -z "$text" ] || cat out err | grep -qF -- "$text"; } ||
        fail "$*: $got, not $code with '$text': $(head -3 out err)"
}

# A section at x = 1/30, which no double is.
cat > thirtieth.tt << 'T'
model thirtieth
state x
state y
state px
state py
eq x = px
eq y = py
eq px = - x - 2*x*y
eq py = - y - x^2 + y^2
integral H = (px^2 + py^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3
section cut : by cut.tt at x = 1/30 with y = y, py = py, H = H
T
cat > cut.tt << 'T'
model cut
param H
default H = 1/8
state y
state py
let square = 2*H - py^2 - y^2 + 2*y^3/3 - 2*(1/30)^2*y - (1/30)^2
domain reached : square > 0
root px = sqrt(square)
lift into thirtieth.tt with x = 1/30, y = y, px = px, py = py
start regular : y = 0.1, py = 0
T
for section in "--section cut" "--section x=1/30 --solve px=0.3"; do
    expect 0 "" jellett certify cycle ./thirtieth.tt $section --level H=1/12 --start y=0.2548,py=0 -o cut.json
    expect 0 "Section: x = 1/30, crossed upwards" jellett check -m ./thirtieth.tt cut.json
done

# Turns are counted in the table's periods.
cat > damped.tt << 'T'
model damped
param rate
default rate = 1
state x
state y
state z
state phi
angle c s = cos(phi) sin(phi)
eq x = 4*y - rate*x
eq y = s - rate*y
eq z = c + 3*x - z/2
eq phi = 1
periodic phi = 2*pi
T
damped=(./damped.tt --section phi=0 --start x=-2,y=-0.5,z=-2)
expect 3 "in the period of damped, which is 6.28" jellett certify cycle "${damped[@]}" --modulo phi=4*pi
expect 0 "" jellett certify cycle "${damped[@]}" --modulo phi=2*pi

# Three multipliers, exp(-2*pi*rate) twice and exp(-pi), of a matrix that is far from diagonal: at first it makes some vectors
# longer.
expect 0 "" jellett certify sink "${damped[@]}" -o damped.json
expect 0 "All multipliers lie inside the unit circle" jellett check -m ./damped.tt damped.json
expect 0 "" jellett certify sink "${damped[@]}" --set rate=1/20 -o damped.json
python3 - << 'P' || fail "not the trace and the determinant of damped"
import json, math
c = json.load(open("damped.json"))
def holds(ball, value): return abs(float(ball["middle"]) - value) <= float(ball["radius"]) + 4e-16
assert holds(c["shown"]["trace"], 2*math.exp(-math.pi/10) + math.exp(-math.pi))
assert holds(c["shown"]["determinant"], math.exp(-math.pi/5 - math.pi)) and c["shown"]["multipliers"] == []
P
expect 1 "not shown to attract" jellett certify sink "${damped[@]}" --set rate=-1/20
exit $status
