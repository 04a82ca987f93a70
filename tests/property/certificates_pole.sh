#!/usr/bin/env bash
# Motions that end at a pole: certificates of the folder are made again, and replayed; integration from corners of their
# boxes and from inside ends where they say, and when. Tables whose motion is known have it in what is enclosed. Certificates that
# say something else are refused, and so are boxes that are not shown to end.
set -euo pipefail
cd "$JLT_SOURCE_DIR"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export XDG_CACHE_HOME=$scratch/cache
status=0

expect() { # STATUS TEXT COMMAND...
    local want=$1 text=$2 got=0
    shift 2
    "$@" > "$scratch/out" 2>&1 || got=$?
    [ $got -eq "$want" ] && grep -qF -- "$text" "$scratch/out" && return 0
    echo "$*: status $got, wanted $want and '$text':"
    cat "$scratch/out"
    status=1
}

sed -n '/^start=/,/^around/p; /certify pole/p' tools/certificates/make > "$scratch/make"
folder=$scratch bash "$scratch/make"
for name in turn_over turn_over_box; do
    expect 0 'ends at the pole gamma3 = 1 ' jellett check tools/certificates/$name.json "$scratch/$name.json"
done

# Starts by STATE=VALUE,..., parameters behind them: all corners of states, then some from inside.
cat > "$scratch/starts.py" << 'END'
import itertools, json, random, sys
from fractions import Fraction as F
given = json.load(open(sys.argv[1]))["given"]
side = lambda v, u: F(v) if isinstance(v, str) else F(v["middle"]) + u * F(v["radius"])
random.seed(1)
inside = [[random.uniform(-1, 1) for _ in given["box"]] for _ in range(16)]
for corner in [*itertools.product((-1, 1), repeat=len(given["box"])), *inside]:
    put = lambda part, units: ",".join("%s=%.17g" % (name, side(v, F(u))) for (name, v), u in zip(part.items(), units))
    print(put(given["box"], corner), put(given["parameters"], [random.choice((-1, 1)) for _ in given["parameters"]]))
END
cat > "$scratch/compare.py" << 'END'
import json, sys
shown = json.load(open(sys.argv[1]))["shown"]
rows = [line.rstrip("\n").split(",") for line in sys.stdin if line[0] != "#"]
names, least, row = rows[0], min(float(r[rows[0].index("contact_force")]) for r in rows[1:]), dict(zip(rows[0], rows[-1]))
assert row["fate"] == "pole+" and row["gamma3"] == shown["end"], row
assert abs(float(row["omega_n"])) < 1e-9 and shown["vanish"] == ["omega_n"], row
for name, ball in [("t", shown["time"]), *shown["limit"].items()]:
    assert abs(float(row[name]) - float(ball["middle"])) <= float(ball["radius"]), (name, row, ball)
assert least >= float(shown["conditions"]["contact"]), least
END
for name in turn_over turn_over_box; do
    while read -r start params; do
        jellett simulate --set "$params" --start "$start" --until 4 --every 0.05 2> /dev/null |
            python3 "$scratch/compare.py" tools/certificates/$name.json || { echo "$name: $start $params"; status=1; }
    done < <(python3 "$scratch/starts.py" tools/certificates/$name.json)
done

# CERTIFICATE NAME STATEMENT: a copy changed by a statement of Python on its question g and what is shown, s, with a good digest.
change() {
    python3 - "$1" "$scratch/$2.json" "$3" << 'END'
import hashlib, json, sys
source, target, statement = sys.argv[1:]
c = json.load(open(source))
g, s = c["given"], c["shown"]
exec(statement)
c.pop("digest")
c["digest"] = hashlib.sha256(json.dumps(c, sort_keys=True, separators=(",", ":")).encode()).hexdigest()
json.dump(c, open(target, "w"), indent=1)
END
}
# x = 1 - cos(t) from x = 1, and its mirror image: both come to an end of x at pi/2, where y = t. A second program proves it too,
# and refuses what is changed.
for sign in + -; do
    cat > "$scratch/slide.tt" << END
model slide
title "x = 1 - cos(t)"
source "made for a test"
state x in (-1/10, 19/10)
state y
root r = sqrt((x + 1/10)*(19/10 - x))
eq x = $sign r
eq y = + 1
pole x "the slide ends"
time regular : r lifting r
END
    end=$([ $sign = + ] && echo 19/10 || echo -1/10)
    expect 0 "ends at the pole x = $end (the slide ends)" jellett certify pole "$scratch/slide.tt" --start x=9/10,y=0 -o /dev/stdout
    python3 - "$scratch/out" << 'END' || status=1
import json, math, sys
shown = json.load(open(sys.argv[1]))["shown"]
for ball in shown["time"], shown["limit"]["y"]:
    assert abs(float(ball["middle"]) - math.pi/2) <= float(ball["radius"]) < 1e-2, shown
assert shown["vanish"] == []
END
    cp "$scratch/out" "$scratch/slide.json"
    again=(python3 tools/check_certificate.py --table "$scratch/slide.tt")
    expect 0 "pole proved by a second program: x = $end after 1.5" "${again[@]}" "$scratch/slide.json"
    [ $sign = + ] || continue
    refuse_again() { change "$scratch/slide.json" "$1" "$3"; expect 1 "$2" "${again[@]}" "$scratch/$1.json"; }
    refuse_again end 'not shown to end there' 's["end"] = "-1/10"'
    refuse_again late 'the time is another one' 's["time"] = {"middle": "1.6", "radius": "0.01"}'
    refuse_again limit 'the limit of y is another one' 's["limit"]["y"]["middle"] = "1.65"'
    refuse_again early 'not shown to settle' 'g["instant"] = "0.1"'
    refuse_again nothing 'before it moves' 'g["instant"] = "0"'
    refuse_again outside 'outside the interval' 'g["box"]["x"] = {"middle": "1.8", "radius": "0.1"}'
    refuse_again vanish 'not shown to settle' 's["vanish"] = ["y"]; s["limit"] = {}'
    refuse_again missing 'not of the table' 's["limit"] = {}'
    refuse_again state 'the table claims no pole y' 'g["pole"] = "y"; s["limit"] = {"x": "1"}; s["claims"] = ["pole y"]'
done

# What must not be proved. y comes to 1 before x = sin(t) does, as du/dt = -u/r - 4: there u = 0, but the equations with lifted
# roots go on, to u < 0, and settle where x = 1. A state beyond the end, where the radicand is positive again. Time that runs back.
table() { # RECORDS
    printf '%s\n' 'model other' 'title "a motion that does not end at x = 1"' 'source "made for a test"' 'state x in (-1, 1)' "$@" \
        > "$scratch/other.tt"
}
table 'state y' 'root r = sqrt(1 - x^2)' 'root u = sqrt(1 - y^2)' 'domain disc : 1 - y^2 > 0' 'domain right : y > 0' 'eq x = + r' \
    'eq y = + u^2/(r*y) + 4*u/y' 'pole x' 'time regular : r lifting r, u'
expect 1 'not shown to stay in the domain' jellett certify pole "$scratch/other.tt" --start x=99/100,y=199/200
table 'root r = sqrt((1 - x)^2*(1 + x))' 'eq x = + (1 - x)*r' 'pole x' 'time regular : r lifting r'
expect 1 'not shown to lie in the domain' jellett certify pole "$scratch/other.tt" --start x=3/2
table 'root r = sqrt(1 - x^2)' 'eq x = - r' 'pole x' 'time regular : -r lifting r'
expect 1 'not proved to run forwards' jellett certify pole "$scratch/other.tt" --start x=1/2
table 'root r = sqrt(1 - x^2)' 'eq x = 1' 'pole x' 'time regular : r lifting r'
expect 1 'the pole claim x of this table is not proved: orbits run through' jellett certify pole "$scratch/other.tt" --start x=1/2

refuse() { change tools/certificates/turn_over.json "$1" "$3"; expect "$4" "$2" jellett check "$scratch/$1.json"; }
refuse end 'does not follow' 's["end"] = "-1"' 1
refuse vanish 'does not follow' 's["vanish"].append("v_nu"); del s["limit"]["v_nu"]' 1
refuse limit 'does not follow' 's["limit"]["v_nu"]["radius"] = "0.008"' 1
refuse moved 'does not follow' 's["time"]["middle"] = "2.09"' 1
refuse wide 'may be 0' 's["time"]["radius"] = "3"' 1
refuse contact 'does not follow' 's["conditions"]["contact"] = "0.4"' 1
refuse words 'its theorem is not what its numbers say' 'c["theorem"][1] = c["theorem"][1].replace("Every", "No")' 1
refuse early 'not shown to come to rest' 'g["instant"] = "1"' 1
refuse coarse 'not shown to come to rest' 'g["digits"] = 5' 1
refuse never 'instant: a number > 0' 'g["instant"] = "-1"' 3
refuse state 'has no pole' 'g["pole"] = "v_nu"' 3
refuse time 'no such time' 'g["time"] = "own"' 3
refuse outside 'not shown to lie in the domain' 'g["box"]["gamma3"] = "1"' 1
refuse missing 'it must give all 5 states' 'del g["box"]["omega3"]' 3
refuse sign 'does not allow this value' 'g["parameters"]["m"] = "-1"' 3
refuse member 'its members are not those of a certificate of its kind' 'g["turns"] = 1' 3

expect 1 'not proved: the states of the box' jellett certify pole --start gamma3=-0.9,v_nu=0,omega_tau=0,omega_n=0,omega3=0 \
    --spread gamma3=0.2
expect 1 'not proved' jellett certify pole --set I3=0 --start gamma3=-0.9,v_nu=1,omega_tau=1,omega_n=1,omega3=1 --digits 10
cat > "$scratch/two.tt" << 'END'
model two
state x in (-1, 1)
state y in (-1, 1)
root r = sqrt(1 - x^2)
root s = sqrt(1 - y^2)
eq x = r*y
eq y = -s
time across : r lifting r
time along : s lifting s
pole x
pole y
END
expect 1 '[pole x, time across]' jellett certify pole "$scratch/two.tt" --start x=0,y=2
expect 1 '[pole y, time along]' jellett certify pole "$scratch/two.tt" --start x=0,y=2
grep -v '^time' "$scratch/two.tt" > "$scratch/none.tt"
expect 1 'not proved: no time of the table lifts a root' jellett certify pole "$scratch/none.tt" --start x=0,y=0
expect 3 'lorenz has no record `pole`' jellett certify pole lorenz --start x=1,y=1,z=1
expect 3 'omega_tau has no value' jellett certify pole --start gamma3=-0.62,v_nu=0.5
expect 3 "--start: spherical_top has no state 'z'" jellett certify pole --start z=1
expect 3 "there is neither a parameter nor a state 'z' here" jellett certify pole \
    --start gamma3=-0.9,v_nu=0,omega_tau=0,omega_n=0,omega3=0 --spread z=1
expect 2 'say where the motions begin' jellett certify pole
expect 2 '--section is an option of orbits on sections, not of pole' jellett certify pole --section x=0 --start gamma3=0
exit $status
