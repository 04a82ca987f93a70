#!/usr/bin/env bash
# A symmetric orbit is certified and replayed: the elliptic fixed point of Henon's and Heiles' oscillators, whose rotation number
# `jellett orbits` gives in doubles. An orbit that is another one than its image is refused, one whose table has no reversor, and
# certificates that say something else. So for the twist that makes the point stable.
set -euo pipefail
cd "$JLT_SOURCE_DIR"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
status=0
table=$scratch/henon.tt # without its own section
sed '/^section /d' tools/docs/henon.tt > "$table"
centre=("$table" --section x=0 --level H=1/8 --solve px=0.4 --start y=0.3,py=0)
certificate=$scratch/centre.json

jellett certify symmetric "${centre[@]}" -o "$certificate"

expect() { # STATUS FILE TEXT
    local got=0
    jellett check --model "$table" "$2" > "$scratch/out" 2>&1 || got=$?
    if [ $got -ne "$1" ] || ! grep -qF -- "$3" "$scratch/out"; then
        echo "$2: status $got, wanted $1 and '$3':"
        cat "$scratch/out"
        status=1
    fi
}

# NAME STATEMENT: a copy changed by a statement of Python on c, with a digest of its own.
change() {
    python3 - "$certificate" "$scratch/$1.json" "$2" << 'END'
import hashlib, json, sys
source, target, statement = sys.argv[1:]
c = json.load(open(source))
s = c["shown"].get("symmetry")
exec(statement)
c.pop("digest")
c["digest"] = hashlib.sha256(json.dumps(c, sort_keys=True, separators=(",", ":")).encode()).hexdigest()
json.dump(c, open(target, "w"), indent=1)
END
}

expect 0 "$certificate" 'det DP = 1 exactly. It is elliptic'
# in doubles: arccos(trace/2)/(2 pi) of the row, to 1e-12, as its error is some 1e-15
jellett orbits "${centre[@]}" --period 1 | tail -n 1 | cut -d, -f5 > "$scratch/trace"
python3 - "$certificate" "$scratch/trace" << 'END' || { echo "another rotation number than in doubles"; status=1; }
import json, math, sys
rotation = float(json.load(open(sys.argv[1]))["shown"]["symmetry"]["rotation"]["middle"])
sys.exit(abs(rotation - math.acos(float(open(sys.argv[2]).read()) / 2) / (2 * math.pi)) > 1e-12)
END
change rotation 's["rotation"]["middle"] = "0.32460020136925830999"'
expect 1 "$scratch/rotation.json" 'does not follow'
change type 's["type"] = "hyperbolic"'
expect 1 "$scratch/type.json" 'does not follow'
change reversor 's["reversor"] = ["y"]'
expect 1 "$scratch/reversor.json" 'does not follow'
change cycle 'c["kind"] = "cycle"'
expect 1 "$scratch/cycle.json" 'does not follow'

# The second program proves the same, and refuses another type and another reversor.
second() { # STATUS FILE TEXT
    local got=0
    python3 tools/check_certificate.py --table "$table" "$2" > "$scratch/out" 2>&1 || got=$?
    [ $got -eq "$1" ] && grep -qF -- "$3" "$scratch/out" ||
        { echo "second program on $2: status $got"; cat "$scratch/out"; status=1; }
}
second 0 "$certificate" 'proved by a second program'
# A reversor that the table claims, but that does not turn its motion around, or does more than change signs.
for claim in 'x -> -x, y -> -y' 'x -> -x, px -> y, y -> px'; do
    sed "s/^reversor .*/reversor $claim/" "$table" > "$scratch/claimed.tt"
    change claimed 's["reversor"] = ["x"] + ["y"] * ("-y" in "'"$claim"'")
c["given"]["table"]["sha256"] = "'"$(sha256sum < "$scratch/claimed.tt" | cut -c1-64)"'"'
    table=$scratch/claimed.tt second 1 "$scratch/claimed.json" 'the table claims another reversor, or none'
done
change hyperbolic 's["type"] = "hyperbolic"; del s["rotation"]'
second 1 "$scratch/hyperbolic.json" 'it is not hyperbolic'
second 1 "$scratch/reversor.json" 'the table claims another reversor'

refuse() { # STATUS TEXT OPTION...
    local got=0 want=$1 text=$2
    shift 2
    jellett certify "$@" -o "$scratch/nothing.json" > "$scratch/out" 2>&1 || got=$?
    [ $got -eq "$want" ] && grep -qF -- "$text" "$scratch/out" && [ ! -e "$scratch/nothing.json" ] ||
        { echo "certify $*: status $got"; cat "$scratch/out"; status=1; }
}
# before the orbit is refined and proved, which takes its time
refuse 1 'not proved: no reversor of the table' symmetric lorenz --section z=27 --period 2 --start x=-13.76,y=-19.58 --digits 12
refuse 1 'its own mirror image: its points miss' symmetric "${centre[@]:0:7}" --start y=0.3014,py=-0.29987
refuse 1 'its own mirror image: its points miss' symmetric "${centre[@]:0:7}" --period 4 --start y=-0.12188955,py=-0.26566932
# Elliptic: the twist is what rotation numbers of curves around the point make of it. With r the amplitude of y along a curve,
# (angle of a return - that at the point)/r^2 differs from it by about c r^2: what two curves make of it by extrapolation is nearer
# than a tenth of their difference.
certificate=$scratch/twist.json
jellett certify elliptic "${centre[@]}" -o "$certificate"
expect 0 "$certificate" 'the orbit is stable on its levels'
for y in 0.3226668174698299 0.3126668174698299; do
    jellett section "${centre[@]:0:7}" --start "y=$y,py=0" --returns 2000 | grep "^0," | cut -d, -f4,5 > "$scratch/curve.$y"
done
python3 - "$certificate" "$scratch"/curve.* << 'END' || { echo "another twist than rotation numbers say"; status=1; }
import json, math, sys
shown = json.load(open(sys.argv[1]))["shown"]
y0, twist = float(shown["orbit"][0]["y"]["middle"]), float(shown["twist"]["coefficient"]["middle"])
turn = 2 * math.pi * float(shown["symmetry"]["rotation"]["middle"])

def slope(path):
    points = [(float(a) - y0, float(b)) for a, b in (line.split(",") for line in open(path))]
    wide, high = ((max(c) - min(c)) / 2 for c in zip(*points))
    angles = [math.atan2(b / high, a / wide) for a, b in points]
    total = weights = 0
    for n in range(1, len(angles)):  # Birkhoff averages with the weight of S. Das and others, Nonlinearity 30, 2017
        t = n / len(angles)
        weight = math.exp(-1 / (t * (1 - t)))
        total += weight * ((angles[n] - angles[n - 1] + math.pi) % (2 * math.pi) - math.pi)
        weights += weight
    return (abs(total / weights) - turn) / wide ** 2, wide ** 2

(a, r), (b, s) = map(slope, sys.argv[2:])
sys.exit(not abs((a * s - b * r) / (s - r) - twist) < abs(a - b) / 10)
END
change coefficient 'c["shown"]["twist"]["coefficient"]["radius"] = "1e-30"'
expect 1 "$scratch/coefficient.json" 'does not follow'
change coefficient 'c["shown"]["twist"]["coefficient"]["radius"] = "300"'
expect 1 "$scratch/coefficient.json" 'the twist, as it is written, may be 0'
change trace 'c["shown"]["trace"]["radius"] = "3"'
expect 1 "$scratch/trace.json" 'the trace, as it is written, does not tell the type of the orbit'
change coordinate 'c["shown"]["twist"]["coordinate"] = "px"'
expect 1 "$scratch/coordinate.json" 'does not follow'
change less 'c["kind"] = "symmetric"'
expect 1 "$scratch/less.json" 'does not follow'
change theorem 'c["theorem"][-1] = c["theorem"][-1].replace("stable", "unstable")'
expect 1 "$scratch/theorem.json" 'its theorem is not what its numbers say'
# The second program finds the same twist, and refuses another twist, another rotation number.
second 0 "$certificate" 'elliptic proved by a second program'
change turned 's["rotation"]["middle"] = "0.3246002013692"'
second 1 "$scratch/turned.json" 'the rotation number is another one'
change untwisted 'c["shown"]["twist"]["coefficient"]["middle"] = str(-float(c["shown"]["twist"]["coefficient"]["middle"]))'
second 1 "$scratch/untwisted.json" 'the twist is another one'
change shallow 'from decimal import Decimal as D
t = c["shown"]["twist"]["coefficient"]; t["middle"] = str(D(t["middle"]) * (1 + D("1e-6")))'
second 1 "$scratch/shallow.json" 'the twist is another one'
second 1 "$scratch/coordinate.json" 'the amplitude of another state'
# For all levels of an interval: the one in the middle has its twist within, levels at both ends theirs, and no wider one is said to
# exclude 0 than does so as it is written.
# So for a parameter, the coupling. Boxes are as wide as the orbits spread, without which none is shown to be there.
jellett certify elliptic "${centre[@]:0:3}" --level H=1/8 --spread H=1e-8 "${centre[@]:5}" -o "$scratch/levels.json"
sed 's/^state x/param c\ndefault c = 1\n&/; s/2\*x\*y/c*&/; s/- x^2/- c*x^2/; s/+ x^2\*y/+ c*x^2*y/' "$table" > \
    "$scratch/coupled.tt"
jellett certify elliptic "$scratch/coupled.tt" "${centre[@]:1}" --spread c=1e-8 -o "$scratch/coupled.json"
jellett check --model "$scratch/coupled.tt" "$scratch/coupled.json" > "$scratch/out" 2>&1 || { cat "$scratch/out"; status=1; }
expect 0 "$scratch/levels.json" 'What follows holds for each value'
for end in 12499999/100000000 12500001/100000000; do
    jellett certify elliptic "${centre[@]:0:3}" --level H=$end "${centre[@]:5}" -o "$scratch/end.${end:7:1}.json"
done
for c in 99999999/100000000 100000001/100000000; do
    jellett certify elliptic "$scratch/coupled.tt" "${centre[@]:1}" --set "c=$c" -o "$scratch/coupled_${c:0:1}.json"
done
cat > "$scratch/within.py" << 'END'
import json, sys
from fractions import Fraction as F
wide, *others = ([s["twist"]["coefficient"], s["trace"], s["symmetry"]["rotation"]]
                 for s in (json.load(open(path))["shown"] for path in sys.argv[1:]))
assert len(others) == 3 and abs(F(wide[0]["middle"])) > F(wide[0]["radius"])
for found in others:
    for a, b in zip(wide, found):
        assert abs(F(a["middle"]) - F(b["middle"])) <= F(a["radius"]) and F(b["radius"]) < F(a["radius"])
END
python3 "$scratch/within.py" "$scratch/levels.json" "$certificate" "$scratch"/end.*.json ||
    { echo "another twist than at single levels"; status=1; }
python3 "$scratch/within.py" "$scratch/coupled.json" "$certificate" "$scratch"/coupled_*.json ||
    { echo "another twist than with single parameters"; status=1; }
second 3 "$scratch/levels.json" 'are intervals'
refuse 1 'its twist may be 0 (try more digits, or intervals that are less wide)' elliptic "${centre[@]:0:3}" --level H=1/8 \
    --spread H=1e-6 \
    "${centre[@]:5}"
jellett certify symmetric "${centre[@]:0:3}" --level H=1/8 --spread H=1e-4 "${centre[@]:5}" -o "$scratch/wider.json" || status=1
refuse 1 'no orbit is shown to be there' symmetric "${centre[@]:0:3}" --level H=1/8 --spread H=1e-4 "${centre[@]:5}" --radius 1e-10
refuse 1 'not shown to be elliptic: its trace is 4.02' elliptic "${centre[@]:0:7}" --start y=-0.2,py=0
# where the trace is -1, to 1e-13, with all levels within 1e-11
refuse 1 'a resonance of order 4 or 3' elliptic "$table" --section x=0 --level H=0.127217901796567 --spread H=1e-11 --solve px=0.4 \
    --start y=0.3048951758579,py=0 --radius 1e-9
[ $status -ne 0 ] || echo "symmetric orbits are certified, and false certificates refused"
exit $status
