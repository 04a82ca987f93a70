#!/usr/bin/env bash
# Certificates of orbits that close up to periods of states: of a forced oscillator, whose orbit is known in closed form, and of one
# that goes around an angle, on a level that turns do not change. What is no period, or no such level, is refused.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
expect() { # STATUS TEXT COMMAND...
    local code=$1 text=$2
    shift 2
    "$@" > out 2> err
    [ $? -eq "$code" ] && { [ -z "$text" ] || grep -qF -- "$text" out err; } ||
        fail "$*: not $code with '$text': $(head -3 out err)"
}
within() { # FILE EXPRESSION: of c, the certificate, and of what is known
    python3 - "$1" "$2" << 'P' || fail "$1: not $2"
import json, math, sys
from fractions import Fraction
c = json.load(open(sys.argv[1]))
def holds(ball, value):  # a double is right to 4e-16
    return abs(Fraction(ball["middle"]) - Fraction(value)) <= Fraction(ball["radius"]) + Fraction(4, 10**16)
def turns(leg): return c["given"]["legs"][leg].get("turns")
sys.exit(0 if eval(sys.argv[2]) else 1)
P
}

# x" = -2 x - x'/2 + cos(phi), phi' = 1: x = A cos t + B sin t with A = 4/5, B = 2/5; det = exp(-pi), trace
# 2 exp(-pi/2) cos(2 pi w), w^2 = 2 - 1/16.
cat > forced.tt << 'T'
model forced
param k
default k = 0
state x
state v
state phi
angle c s = cos(phi) sin(phi)
eq x = v
eq v = -2*x - v/2 + c + k*x^3
eq phi = 1
periodic phi = 2*pi
T
expect 0 "" jellett certify sink ./forced.tt --section phi=0 --start x=0.8,v=0.4 -o one.json
within one.json 'turns(0) == {"phi": 1} and c["shown"]["claims"] == ["periodic phi"]'
within one.json 'holds(c["shown"]["orbit"][0]["x"], 0.8) and holds(c["shown"]["orbit"][0]["v"], 0.4)'
within one.json 'holds(c["shown"]["period"], 2*math.pi) and holds(c["shown"]["determinant"], math.exp(-math.pi))'
within one.json 'holds(c["shown"]["trace"], 2*math.exp(-math.pi/2)*math.cos(2*math.pi*math.sqrt(2 - 1/16)))'
expect 0 "back at its point, but for phi having grown by 1 period of 2*pi, after" jellett check one.json --model ./forced.tt
expect 0 "no measure that has a continuous positive density with the period 2*pi in phi is" \
    jellett check one.json --model ./forced.tt
expect 0 "" jellett certify obstruction ./forced.tt --section phi=0 --start x=0.8,v=0.4 --spread k=1e-3 -o spread.json
expect 0 "densities have them as well" jellett check spread.json --model ./forced.tt
expect 0 "whose density rho, with the period 2*pi in phi, is" jellett check spread.json --model ./forced.tt
for turns in 2 0 -1; do # another closing, with a digest of its own, is no orbit
    python3 - one.json other.json $turns << 'P'
import hashlib, json, sys
c = json.load(open(sys.argv[1]))
c["given"]["legs"][0]["turns"]["phi"] = int(sys.argv[3])
del c["digest"]
c["digest"] = hashlib.sha256(json.dumps(c, sort_keys=True, separators=(",", ":"), ensure_ascii=False).encode()).hexdigest()
json.dump(c, open(sys.argv[2], "w"))
P
    jellett check other.json --model ./forced.tt > out 2> err && fail "a certificate with $turns turns is believed"
    grep -q 'changed after it was made' err && fail "the digest of the test is wrong"
done
{ cat forced.tt; echo '# edited'; } > edited.tt
expect 3 ", and --model names forced with " jellett check one.json --model ./edited.tt
# Nor does a table that is built in answer for an edited copy of it.
sed 's/^    - x\*z$/&\n    + x\/1000/' "$JLT_SOURCE_DIR/codegen/models/lorenz.tt" > lorenz.tt
expect 3 ", and --model names lorenz with " jellett check "$JLT_SOURCE_DIR/tools/certificates/lorenz_ab.json" --model ./lorenz.tt
# What is proved of another table that is built in is not taken for the table of --model.
expect 0 "is about lorenz as it is built in, not about the table of --model, forced" \
    jellett check "$JLT_SOURCE_DIR/tools/certificates/lorenz_ab.json" --model ./forced.tt
for kind in symmetric elliptic; do
    expect 3 "up to periods" jellett certify $kind ./forced.tt --section phi=0 --start x=0.8,v=0.4
done
# A period that was typed is proved by nobody.
sed '/^periodic/d' forced.tt > unproved.tt
expect 3 "has no period" jellett certify cycle ./unproved.tt --section phi=0 --modulo phi=2*pi --start x=0.8,v=0.4

# Around an angle, on the level of the energy, with a third state that decays to (cos q): two legs, the second one through q = pi.
cat > round.tt << 'T'
model round
param a
default a = 0
state q
state p
state z
angle c s = cos(q) sin(q)
eq q = p
eq p = -s + a
eq z = c - z
periodic q = 2*pi
integral E = p^2/2 - c - a*q
T
expect 3 "E is not shown to be the same a period on" jellett certify sink ./round.tt --section q=0 --level E=2 --solve p=2 \
    --start z=0.3
sed -e '/^param a/d; /^default a/d; s/ + a$//; s/ - a.q$//; /^eq z/a valid near : 9 - q > 0' round.tt > near.tt
expect 4 "the periodic claim 'q' is refuted" jellett certify sink ./near.tt --section q=0 --level E=2 --solve p=2 \
    --start z=0.3
sed -i -e '/^param a/d; /^default a/d; s/ + a$//; s/ - a.q$//' round.tt
expect 0 "" jellett certify sink ./round.tt --section q=0 --level E=2 --solve p=2 --start z=0.3 -o round.json
within round.json 'turns(0) == {"q": 1} and c["shown"]["claims"] == ["integral E", "periodic q"]'
within round.json 'holds(c["shown"]["orbit"][0]["p"], math.sqrt(6))'
expect 0 "but for q having grown by 1 period of 2*pi, after" jellett check round.json --model ./round.tt
# Seen where z passes its mean, q turns between the legs.
expect 0 "" jellett certify sink ./round.tt --section z=0.3 --level E=2 --solve p=2 --start q=0.5 -o seen.json
within seen.json 'turns(0) == {"q": 1}'
expect 0 "but for q having grown by 1 period of 2*pi, after" jellett check seen.json --model ./round.tt
within seen.json 'not any(" leg " in words for words in c["theorem"])'

# Through one box of a pendulum that is kicked once a period three orbits close, by other turns: none is the only one but by its
# own.
cat > kicked.tt << 'T'
model kicked
param e
default e = 1/10
state th
state v
state phi
angle C S = cos(th) sin(th)
angle D U = cos(phi) sin(phi)
exp W = exp(2000*D - 2000)
eq th = 4*v
eq v = -e*S*W
eq phi = 1
periodic th = 2*pi
periodic phi = 2*pi
T
kicked() { # STARTS ORBIT WORDS
    expect 0 "" jellett certify cycle ./kicked.tt --section phi=-0.08 --start "$1" --digits 10 --radius 0.3 -o kicked.json
    within kicked.json 'holds(c["given"]["legs"][0]["box"]["v"], 0) and holds(c["given"]["legs"][0]["box"]["th"], 0)'
    expect 0 "there is exactly one orbit that is back at its point, but for $2, after" \
        jellett check kicked.json --model ./kicked.tt
    expect 0 "orbits through this box close with other numbers of periods is not said" \
        jellett check kicked.json --model ./kicked.tt
}
kicked th=0,v=0 "phi having grown by 1 period of 2*pi"
kicked th=0.08,v=-0.25 "th having grown by -1 period of 2*pi and phi by 1 period of 2*pi"
kicked th=-0.08,v=0.25 "th having grown by 1 period of 2*pi and phi by 1 period of 2*pi"

# Of several legs the numbers of each are part of what is unique: they are said one by one, or once where all are alike, as of a
# pendulum whose oscillation has doubled its period.
expect 0 "" jellett certify cycle ./kicked.tt --section phi=-0.08 --period 2 --start th=0.04,v=-0.125 --digits 10 --radius 1e-5 \
    -o legs.json
within legs.json '(turns(0), turns(1)) == ({"phi": 1}, {"th": -1, "phi": 1})'
expect 0 "back at its point, but for th having grown by -1 period of 2*pi and phi by 2 periods of 2*pi, after" \
    jellett check legs.json --model ./kicked.tt
expect 0 "but for these periods: phi 1 at the end of leg 1, th -1 and phi 1 at the end of leg 2." \
    jellett check legs.json --model ./kicked.tt
cat > doubled.tt << 'T'
model doubled
state th
state v
state phi
angle C S = cos(th) sin(th)
angle D U = cos(phi) sin(phi)
eq th = v
eq v = -S - v/2 + 107/100*D
eq phi = 2/3
periodic phi = 2*pi
T
expect 0 "" jellett certify sink ./doubled.tt --section phi=0 --period 2 --start th=-0.146721,v=1.924567 -o doubled.json
expect 0 "but for phi having grown by 2 periods of 2*pi, after" jellett check doubled.json --model ./doubled.tt
expect 0 "but for these periods: phi 1 at the end of each leg." jellett check doubled.json --model ./doubled.tt

# Other kinds are refused by that, also where a search of their own would come first: x" = x + cos(phi)/100 has a saddle.
sed 's/^eq v = .*/eq v = x + c\/100\nreversor v -> -v, phi -> -phi/; s/^model forced/model hill/; /k/d' forced.tt > hill.tt
for kind in symmetric homoclinic; do
    expect 3 "served as cycle, obstruction and sink: ask for 'certify cycle'" \
        jellett certify $kind ./hill.tt --section phi=0 --start x=-0.005,v=0
done
exit $status
