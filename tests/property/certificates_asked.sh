#!/usr/bin/env bash
# A certificate is one of what was asked, exactly: of a section's value as its table has it, of turns in the periods of the table,
# of a sink with any number of multipliers, of a level whatever its name, of parameters that are computed from those asked for, of a
# homoclinic orbit by whichever reversor serves, of an orbit as near the edge of its domain as can be told, in any unit of time.
source "$JLT_SOURCE_DIR/tests/scratch.sh"

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
    expect_text 0 "" jellett certify cycle ./thirtieth.tt $section --level H=1/12 --start y=0.2548,py=0 -o cut.json
    expect_text 0 "Section: x = 1/30, crossed upwards" jellett check -m ./thirtieth.tt cut.json
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
expect_text 3 "in the period of damped, which is 6.28" jellett certify cycle "${damped[@]}" --modulo phi=4*pi
expect_text 0 "" jellett certify cycle "${damped[@]}" --modulo phi=2*pi

# Three multipliers, exp(-2*pi*rate) twice and exp(-pi), of a matrix that is far from diagonal: at first it makes some vectors
# longer.
expect_text 0 "" jellett certify sink "${damped[@]}" -o damped.json
expect_text 0 "All multipliers lie inside the unit circle" jellett check -m ./damped.tt damped.json
expect_text 0 "" jellett certify sink "${damped[@]}" --set rate=1/20 -o damped.json
python3 - << 'P' || fail "not the trace and the determinant of damped"
import json, math
c = json.load(open("damped.json"))
def holds(ball, value): return abs(float(ball["middle"]) - value) <= float(ball["radius"]) + 4e-16
assert holds(c["shown"]["trace"], 2*math.exp(-math.pi/10) + math.exp(-math.pi))
assert holds(c["shown"]["determinant"], math.exp(-math.pi/5 - math.pi)) and c["shown"]["multipliers"] == []
P
expect_text 1 "not shown to attract" jellett certify sink "${damped[@]}" --set rate=-1/20

# A level may have the name that a symmetry goes by which has none of its own.
cat > named.tt << 'T'
model named
state x
state y
state z
eq x = y
eq y = -x
eq z = -z
symmetry x -> -x, y -> -y
integral symmetry = x^2 + y^2
T
expect_text 0 "" jellett certify sink ./named.tt --section y=0 --direction down --level symmetry=1 --solve x=1 \
    --start z=0 -o named.json
expect_text 0 "Levels: symmetry = 1." jellett check -m ./named.tt named.json

# Parameters of the section's table that are computed from those asked for have exact values too; what has none is said.
cat > computed.tt << 'T'
model computed
param J > 0
default J = 2
state x
state p
state z in (0, inf)
eq x = p
eq p = J/2*(1 - x^2)*p - z*x
eq z = 0*z
integral K = z
reduction held : by pol.tt with x = x, p = p, K = K, c = J/2
T
cat > pol.tt << 'T'
model pol
param c > 0
param K > 0
default K = 1, c = 5
state x
state p
eq x = p
eq p = c*(1 - x^2)*p - K*x
embedding whole : into computed.tt with x = x, p = p, z = K, J = 2*c
section turning : by heights.tt at p = 0 with x = x
T
printf 'model heights\nparam c > 0\nparam K > 0\ndefault K = 1, c = 5\nstate x\nlift into pol.tt with x = x, p = 0\n' > heights.tt
expect_text 0 "" jellett certify sink ./computed.tt --set J=4/3 --start x=-2.0086198608748 -o pol.json
expect_text 0 " with K = 1, c = 2/3. " jellett check -m ./pol.tt pol.json
expect_text 3 "it speaks of pol, to which computed leads: name pol.tt by --model" jellett check -m ./computed.tt pol.json
expect_text 0 "" jellett certify sink ./computed.tt --spread c=1e-12 --start x=-2.0086198608748 -o pol.json
expect_text 0 " with K = 1, c = 1 +- 1/1000000000000. " jellett check -m ./pol.tt pol.json
sed -i 's/c = J.2$/c = sqrt(J)/; s/J.2.(1/j*(1/; s/^state x/root j = sqrt(J)\n&/' computed.tt
sed -i 's/J = 2.c/J = c^2/' pol.tt
expect_text 3 "ask pol itself, with --set c=VALUE" jellett certify sink ./computed.tt --start x=-2.0086198608748

# Of two reversors the second one takes the section to itself: it is named.
sed '/^section /d; s/^reversor/reversor px -> -px, py -> -py\n&/' "$JLT_SOURCE_DIR/tools/docs/henon.tt" > two.tt
homoclinic=(./two.tt --section x=0 --level H=1/8 --solve px=0.4 --start y=-0.2,py=0)
expect_text 0 "" jellett certify homoclinic "${homoclinic[@]}" --digits 16 -o two.json
expect_text 0 "Its image under the reversor x -> -x, py -> -py passes" jellett check -m ./two.tt two.json
for flipped in '["px", "py"]' '["x"]' '[]' '"x"' None absent; do
    python3 - "$flipped" << 'P'
import hashlib, json, sys
c = json.load(open("two.json"))
part = c["given"]["homoclinic"]
if sys.argv[1] == "absent": del part["reversor"]
else: part["reversor"] = eval(sys.argv[1])
del c["digest"]
c["digest"] = hashlib.sha256(json.dumps(c, sort_keys=True, separators=(",", ":")).encode()).hexdigest()
json.dump(c, open("other.json", "w"))
P
    case $flipped in # the other one, which is also meant where none is named
        *px* | absent) expect_text 1 "is not shown to be its own mirror image" jellett check -m ./two.tt other.json ;;
        *) expect_text 3 "no proved reversor of the table flips the states" jellett check -m ./two.tt other.json ;;
    esac
done
sed -i '/^reversor x/d' two.tt
expect_text 3 "no proved reversor of henon flips the section's state" jellett certify homoclinic "${homoclinic[@]}"

# A wall 1e-9 beside the orbit, which comes as far as y = 2.67844147915...; and one among whose places some are too near. None is
# said to be passed.
cat > wall.tt << 'T'
model wall
param edge > 0
default edge = 2.67844148
state x
state y
eq x = y
eq y = (1 - x^2)*y - x
domain inside : edge - y > 0
T
orbit=(./wall.tt --section y=0 --direction down --start x=2.0086198608748)
expect_text 0 "" jellett certify sink "${orbit[@]}" -o wall.json
expect_text 0 proved jellett check -m ./wall.tt wall.json
expect_text 1 "is not shown, with 20 digits, to stay in the domain" jellett certify sink "${orbit[@]}" --spread edge=1e-8

# Van der Pol's oscillator, whose period is 6.6632868593231, in a unit of time 1e9 times as long.
cat > fast.tt << 'T'
model fast
state x
state p
eq x = 1e9*p
eq p = 1e9*((1 - x^2)*p - x)
T
expect_text 0 "" jellett certify sink ./fast.tt --section p=0 --direction down --start x=2.0086198608748 -o fast.json
expect_text 0 "the time T = 6.6632868593231" jellett check -m ./fast.tt fast.json

# The same with an amplitude of 10 micrometres, in a second and in a microsecond: a box is as small as the problem.
cat > small.tt << 'T'
model small
param R > 0 [m]
param w > 0 [1/s]
state x [m]
state p [m/s]
eq x = p
eq p = w*(1 - x^2/R^2)*p - w^2*x
T
for w in 1 1e6; do
    expect_text 0 "" jellett certify sink ./small.tt --set R=5e-6,w=$w --section p=0 --direction down \
        --start x=1.0043099304374e-5 -o small.json
    expect_text 0 "multiplier (0.00085969506360" jellett check -m ./small.tt small.json
done

# So is the distance at which a homoclinic orbit begins: Henon's and Heiles' oscillators, with a length of a micrometre.
cat > micro.tt << 'T'
model micro
param L > 0 [m]
param w > 0 [1/s]
default w = 1
state x [m]
state y [m]
state px [m/s]
state py [m/s]
eq x = px
eq y = py
eq px = - w^2*x - 2*w^2*x*y/L
eq py = - w^2*y - w^2*x^2/L + w^2*y^2/L
integral H = (px^2 + py^2)/2 + w^2*(x^2 + y^2)/2 + w^2*(x^2*y - y^3/3)/L
reversor x -> -x, py -> -py
T
expect_text 0 "" jellett certify homoclinic ./micro.tt --set L=1e-6 --section x=0 --level H=1.25e-13 --solve px=4e-7 \
    --start y=-2e-7,py=0 --digits 16 -o micro.json
expect_text 0 "the manifolds cross transversally" jellett check -m ./micro.tt micro.json

# Levels of an integral that is one under a condition alone: what to do is said.
printf '%s\n' 'model damped' 'param k >= 0' 'default k = 0' 'state x' 'state v' 'state y' 'eq x = v' \
    'eq v = - x - k*v' 'eq y = x - y' \
    'integral E = x^2 + v^2 when k = 0' 'variant free : k = 0' > damped.tt
expect_text 3 "proved without a condition: write a table in which it is one, with k = 0 put into its equations" \
    jellett certify cycle ./damped.tt --section v=0 --direction down --level E=1 --solve x=1 --start y=0.5
exit $status
