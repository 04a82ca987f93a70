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
    [ $got -eq "$1" ] && grep -qF -- "$3" "$scratch/out" || { echo "second program on $2: status $got"; cat "$scratch/out"; status=1; }
}
second 0 "$certificate" 'proved by a second program'
second 1 "$scratch/type.json" 'it is not hyperbolic'
second 1 "$scratch/reversor.json" 'the table claims another reversor'

refuse() { # STATUS TEXT OPTION...
    local got=0 want=$1 text=$2
    shift 2
    jellett certify "$@" -o "$scratch/nothing.json" > "$scratch/out" 2>&1 || got=$?
    [ $got -eq "$want" ] && grep -qF -- "$text" "$scratch/out" && [ ! -e "$scratch/nothing.json" ] || { echo "certify $*: status $got"; cat "$scratch/out"; status=1; }
}
refuse 1 'no reversor of the table' symmetric lorenz --section z=27 --period 2 --start x=-13.76,y=-19.58 --digits 12
refuse 1 'not shown to be its own mirror image' symmetric "${centre[@]:0:7}" --start y=0.3014,py=-0.29987
refuse 1 'not shown to be its own mirror image' symmetric "${centre[@]:0:7}" --period 4 --start y=-0.12188955,py=-0.26566932
# Elliptic: the twist is what rotation numbers of curves around the point make of it. With r the amplitude of y along a curve, (angle of
# a return - that at the point)/r^2 differs from it by about c r^2: what two curves make of it by extrapolation is nearer than a tenth
# of their difference.
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
change coordinate 'c["shown"]["twist"]["coordinate"] = "px"'
expect 1 "$scratch/coordinate.json" 'does not follow'
change less 'c["kind"] = "symmetric"'
expect 1 "$scratch/less.json" 'does not follow'
change theorem 'c["theorem"][-1] = c["theorem"][-1].replace("stable", "unstable")'
expect 1 "$scratch/theorem.json" 'its theorem is not what its numbers say'
second 3 "$scratch/theorem.json" 'it is of kind elliptic'
refuse 1 'not shown to be elliptic: its trace is 4.02' elliptic "${centre[@]:0:7}" --start y=-0.2,py=0
# where the trace is -1, to 1e-13, with all levels within 1e-11
refuse 1 'a resonance of order 4 or 3' elliptic "$table" --section x=0 --level H=0.127217901796567 --spread H=1e-11 --solve px=0.4 \
    --start y=0.3048951758579,py=0 --radius 1e-9
[ $status -ne 0 ] || echo "symmetric orbits are certified, and false certificates refused"
exit $status
