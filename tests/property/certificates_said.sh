#!/usr/bin/env bash
# What a certificate says, in numbers and in words made of them, follows from what its replay proves: forgeries whose digests and
# words are made good are refused where a leg takes no time, where numbers are so wide that they do not bear out the words, where
# what is no number stands for one, where names of the table are those of parts of a ball, and where there is more than is read.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
# FILE STATUS TEXT STATEMENT...: a copy of FILE.json, of the table FILE.tt, by each statement of Python on c, with words and a
# digest that fit its numbers, is refused with this text. An empty text: it is not refused.
forged() {
    local source=$1 code=$2 text=$3 got
    shift 3
    rm -rf forgeries
    mkdir forgeries
    python3 - "$source.json" "$@" << 'P' || fail "$source: cannot be forged"
import copy, hashlib, json, re, sys
from fractions import Fraction as F
original = json.load(open(sys.argv[1]))
def ball(b): return b if isinstance(b, str) else f"{b['middle']} +- {b['radius']}"
def named(x): return ", ".join(f"{name} = {ball(b)}" for name, b in x.items())
def words(c): # in place: of a cycle that does not turn
    legs, s, t = c["given"]["legs"], c["shown"], c["theorem"]
    section = c["given"]["section"]
    t[0] = re.sub(r" with .*", f" with {named(c['given']['parameters'])}. Section: {section['state']} = {section['value']}, "
                  f"crossed downwards.", t[0])
    more = f", and in turn through {len(legs) - 1} more of it that are listed under \"legs\"," if len(legs) > 1 else ""
    near = legs[0]["instant"] + ". That point"
    if more: near = f"{sum(float(leg['instant']) for leg in legs):.17g}, from box to box in the times listed. Its first point"
    t[1] = f"Through the box {named(legs[0]['box'])} of the section{more} there is exactly one orbit that is " \
        f"back at its point after a time near {near} is {named(s['orbit'][0])}, the time T = {ball(s['period'])}."
    t[2] = f"det DP = exp(integral of div f over the orbit) = {ball(s['determinant'])}, trace DP = " \
        f"{ball(s['trace'])}" + "".join(f"; multiplier ({ball(m['re'])}) + i ({ball(m['im'])})" for m in s["multipliers"]) + "."
    for name, bound in dict(s["conditions"]).items():
        t[3] = re.sub(rf"(The condition {name} [^:]*: its quantity is at least )[-.0-9e]*[0-9]", rf"\g<1>{bound}", t[3])
def widen(c): # all balls, so that a replay by other legs is among them
    s = c["shown"]
    for part in s["orbit"] + s["multipliers"] + [s]:
        for b in part.values():
            if isinstance(b, dict) and "radius" in b and b is not s["conditions"]: b["radius"] = "1e-12"
check = copy.deepcopy(original)
words(check)
if check != original: sys.exit("the words are made otherwise: " + str(check["theorem"]))
for i, statement in enumerate(sys.argv[2:]):
    c = copy.deepcopy(original)
    g, s, leg = c["given"], c["shown"], c["given"]["legs"][0]
    exec(statement)
    if c == original: sys.exit(statement + ": changes nothing")
    words(c)
    c.pop("digest")
    c["digest"] = hashlib.sha256(json.dumps(c, sort_keys=True, separators=(",", ":"), ensure_ascii=False).encode()).hexdigest()
    json.dump(c, open(f"forgeries/{i + 1}.json", "w"), ensure_ascii=False)
P
    for ((i = 1; i <= $#; i++)); do
        got=0
        jellett check -m "./$source.tt" forgeries/$i.json > out 2> err || got=$?
        [ $got -eq "$code" ] && { [ -z "$text" ] || grep -qF -- "$text" err; } ||
            fail "${!i}: $got, not $code '$text': $(head -2 out err)"
    done
}

cat > pol.tt << 'T'
model pol
param mu
default mu = 1
state x
state y
eq x = y
eq y = mu*(1 - x^2)*y - x
valid near : 3 - y > 0 "one"
valid middle : 10 - y > 0 "two"
valid radius : 20 - y > 0 "three"
T
orbit=(./pol.tt --section y=0 --direction down --start x=2.0086198608748)
for kind in cycle sink obstruction; do
    expect_text 0 "" jellett certify $kind "${orbit[@]}" -o pol.json
    cp pol.json $kind.json
    cp pol.tt $kind.tt
done
forged pol 0 "" 'widen(c)' 's["period"]["radius"] = "1e-3"' 's["orbit"][0]["x"]["radius"] = "3e-10"'

# A condition without a meaning in words.
sed 's/ "one"$//; s/^valid middle.*/valid middle : 1 - y > 0/' pol.tt > bare.tt
expect_text 0 "The condition near holds all along the orbit" jellett certify cycle ./bare.tt "${orbit[@]:1}"
expect_text 0 "Of the condition middle it is not shown that it holds" jellett certify cycle ./bare.tt "${orbit[@]:1}"

# A leg that ends where it begins, and one that goes back.
still='g["legs"].append(copy.deepcopy(leg)); s["orbit"] *= 2; widen(c); '
forged cycle 1 "a leg of the orbit is not shown to take time" "$still"'g["legs"][1]["instant"] = "1e-10"' \
    "$still"'g["legs"][0]["instant"] = "1e-12"' 's["orbit"] *= 1; leg["instant"] = "1e-8"; widen(c)
g["legs"] = [copy.deepcopy(leg), copy.deepcopy(leg)]; s["orbit"] *= 2; g["legs"][1]["instant"] = "6.6632868593231304726"'

# Words conclude from numbers as they are written.
forged sink 1 "are not all inside the unit circle" 's["multipliers"][0]["re"]["radius"] = "1"' \
    's["multipliers"][0]["im"]["radius"] = "2"' 's["determinant"]["radius"] = "5"'
forged obstruction 1 "the determinant, as it is written, may be 1" 's["determinant"]["radius"] = "1"' \
    's["determinant"] = {"middle": "1", "radius": "3/2"}'
forged obstruction 1 "the period, as it is written, may be 0" 's["period"]["radius"] = "7"'
forged cycle 1 "with much more room than its box has" 's["orbit"][0]["x"]["radius"] = "1000"' \
    's["orbit"][0]["x"]["radius"] = "1e-9"'

# A box is meant as it is written: the orbit lies beside this one, and in what its radius is rounded to.
expect_text 0 "" jellett certify cycle "${orbit[@]}" --digits 40 -o pol.json
forged pol 1 "not shown to lie in its boxes as they are written" 'r = F(1, 2**60)*(1 + F(1, 2**40)); widen(c)
m = F(s["orbit"][0]["x"]["middle"]) + r*(1 + F(1, 2**32)); s["orbit"][0]["x"]["radius"] = "1e-18"
leg["box"]["x"] = {"middle": f"{m.numerator}/{m.denominator}", "radius": f"{r.numerator}/{r.denominator}"}'

# What is no number.
statements=() radii=()
for number in --2 -+1 +1 1e 1e+ 1e5.0 " 1" "1 " 0x10 nan inf -inf 1. .5 1/0 1/-2 1/2/3 1,0 "" 1e9999999 １ 1_0; do
    statements+=("g['parameters']['mu'] = '$number'")
    radii+=("s['determinant_of_matrix']['radius'] = '$number'" "s['determinant_of_matrix']['middle'] = '$number'")
done
forged cycle 3 "parameter mu: no number" "${statements[@]}" 'g["parameters"]["mu"] = "9"*20000'
forged cycle 1 "does not follow" "${radii[@]}"
forged cycle 3 "section: no value" 'g["section"]["value"] = "+0"'
forged cycle 3 "box: x has no middle and radius" 'leg["box"]["x"]["radius"] = "1E"' 'leg["box"]["x"]["note"] = "1"'
forged cycle 3 "instant: a time > 0" 'leg["instant"] = "0x10"'

# Conditions and states may be called as the parts of a ball are.
forged cycle 1 "does not follow" 's["conditions"]["middle"] = "100"; s["conditions"]["radius"] = "1000"'
cat > ball.tt << 'T'
model ball
state y
state middle
state radius
eq y = (1 - middle^2)*y - middle
eq middle = y
eq radius = -radius
T
expect_text 0 "" jellett certify cycle ./ball.tt --section y=0 --direction down --start middle=2.0086198608748,radius=0 -o ball.json
cp ball.json kept.json
python3 - << 'P'
import hashlib, json
c = json.load(open("kept.json"))
c["shown"]["orbit"][0]["middle"]["middle"] = "2"
del c["digest"]
c["digest"] = hashlib.sha256(json.dumps(c, sort_keys=True, separators=(",", ":")).encode()).hexdigest()
json.dump(c, open("ball.json", "w"))
P
expect_text 1 "does not follow" jellett check -m ./ball.tt ball.json

# Where there are no conditions, nothing is said of them; and the ball of a state that is called so is no lower bound.
cp kept.json ball.json
forged ball 1 "does not follow" 's["conditions"] = []' 's["conditions"] = ""'
printf '%s\n' 'model named' 'state y' 'state conditions' 'eq y = (1 - conditions^2)*y - conditions' 'eq conditions = y' > named.tt
expect_text 0 "" jellett certify cycle ./named.tt --section y=0 --direction down --start conditions=2.0086198608748 -o named.json
expect_text 0 "" jellett check -m ./named.tt named.json
forged named 1 "does not follow" 's["orbit"][0]["conditions"] = {"middle": "-7", "radius": "0"}' \
    's["orbit"][0]["conditions"]["middle"] = "2"; s["orbit"][0]["conditions"]["radius"] = "1e-30"'

# Nothing stands beside what is proved.
forged cycle 3 "its members are not those of a certificate of its kind" 'c["note"] = "the only cycle"' 'g["note"] = "all"' \
    'g["table"]["title"] = "another"' 'g["section"]["note"] = "1"' 'leg["note"] = 7' 'g["homoclinic"] = {}'
exit $status
