#!/usr/bin/env bash
# A transversal homoclinic orbit of Henon's and Heiles' oscillators is certified and replayed, and certificates that say something
# else are refused; so is a cycle of determinant 1 as an obstruction, which Lorenz' orbit AB is.
set -euo pipefail
cd "$JLT_SOURCE_DIR"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
status=0
table=$scratch/henon.tt # without its own section, and with a condition, whose bound lies just below 1.4279
{ sed '/^section /d' tools/docs/henon.tt; echo 'valid near : 2 - y > 0'; } > "$table"
henon=("$table" --section x=0 --level H=1/8 --solve px=0.4 --start y=-0.2,py=0)
certificate=$scratch/horseshoe.json

jellett certify homoclinic "${henon[@]}" --distance 1e-7 --digits 16 -o "$certificate" 2> /dev/null

expect() { # STATUS FILE TEXT
    local got=0
    jellett check --model "$table" "$2" > "$scratch/out" 2>&1 || got=$?
    if [ $got -ne "$1" ] || ! grep -qF -- "$3" "$scratch/out"; then
        echo "$2: status $got, wanted $1 and '$3':"
        cat "$scratch/out"
        status=1
    fi
}

# NAME STATEMENT: a copy changed by a statement of Python on h, the question, and s, what was shown, with a digest of its own.
change() {
    python3 - "$certificate" "$scratch/$1.json" "$2" << 'END'
import hashlib, json, sys
source, target, statement = sys.argv[1:]
c = json.load(open(source))
h, s = c["given"]["homoclinic"], c["shown"]["homoclinic"]
exec(statement)
c.pop("digest")
c["digest"] = hashlib.sha256(json.dumps(c, sort_keys=True, separators=(",", ":")).encode()).hexdigest()
json.dump(c, open(target, "w"), indent=1)
END
}

expect 0 "$certificate" 'the manifolds cross transversally'
# The same orbit on the section that tables describe.
sed 's/ in (-1, 1)//' tools/docs/henon_section.tt > "$scratch/henon_section.tt"
cp tools/docs/henon.tt "$scratch/described.tt"
jellett certify homoclinic "$scratch/described.tt" --start y=-0.2,py=0 --distance 1e-7 --digits 16 -o "$scratch/described.json" ||
    status=1
for file in "$certificate" "$scratch/described.json"; do
    python3 -c 'import json, sys
for leg in json.load(open(sys.argv[1]))["given"]["homoclinic"]["legs"]: print(leg["instant"][:14])' "$file" > "$file.instants"
done
cmp "$certificate.instants" "$scratch/described.json.instants" || status=1
expect 0 "$certificate" 'to the symmetric one: its quantity is at least 1.4284'
change tangent 's["tangent"]["y"]["middle"] = "-0.00592"; s["tangent"]["y"]["radius"] = "1e-9"'
expect 1 "$scratch/tangent.json" 'does not follow'
change wide 's["tangent"]["y"]["radius"] = s["tangent"]["px"]["radius"] = "1"'
expect 1 "$scratch/wide.json" 'the manifolds, as their tangents are written, may be tangent'
change start 's["start"]["radius"] = "1"'
expect 1 "$scratch/start.json" 'the homoclinic orbit, as its start is written, may be the saddle'
change saddle 'c["shown"]["multipliers"][0]["re"]["radius"] = "100"'
expect 1 "$scratch/saddle.json" 'the multipliers, as they are written, are not one outside and one inside'
change frame 'h["frame"] = [row[::-1] for row in h["frame"]]'
expect 1 "$scratch/frame.json" 'the cone is not mapped into itself'
change reach 'h["reach"] = "1e-2"'
expect 1 "$scratch/reach.json" 'not shown to end at one crossing of the section, in its direction'
change short 'h["reach"] = "1e-8"'
expect 1 "$scratch/short.json" 'not shown to begin on the unstable manifold'
change box 'h["legs"][3]["box"]["y"]["middle"] += "9"; h["legs"][3]["box"]["y"]["radius"] = "1e-19"'
expect 1 "$scratch/box.json" 'no homoclinic orbit is shown to be there'
change landing 'h["landing"] = 1'
expect 1 "$scratch/landing.json" 'not shown to end at one crossing of the section, in its direction'
change none 'del c["given"]["homoclinic"]'
expect 3 "$scratch/none.json" 'a saddle of one leg, and an orbit'
for turns in '{"y": 0}' '{"y": 1}' '{}' None '"y"'; do
    change turns 'h["legs"][3]["turns"] = '"$turns"
    expect 3 "$scratch/turns.json" 'its legs have no turns'
done
change slope 'h["slope"] = "-1"'
expect 3 "$scratch/slope.json" 'reach and slope are numbers > 0'
change two 'c["given"]["legs"] *= 2'
expect 3 "$scratch/two.json" 'a saddle of one leg'

refuse() { # STATUS TEXT OPTION...
    local got=0 want=$1 text=$2
    shift 2
    jellett certify "$@" -o "$scratch/nothing.json" > "$scratch/out" 2>&1 || got=$?
    [ $got -eq "$want" ] && grep -qF -- "$text" "$scratch/out" && [ ! -e "$scratch/nothing.json" ] ||
        { echo "certify $*: status $got"; cat "$scratch/out"; status=1; }
}
refuse 1 'its determinant may be 1' obstruction "${henon[@]}"
refuse 4 'no symmetric homoclinic orbit' homoclinic "${henon[@]}" --orbit 1000
refuse 3 "write 'reversor STATE -> -STATE, ...' in its table" homoclinic roessler \
    --section y=0 --direction down --start x=-7.2,z=0.0155
refuse 2 '--period is an option of cycle' homoclinic "${henon[@]}" --period 2
lorenz=(obstruction lorenz --section z=27 --period 2 --start x=-13.76,y=-19.58 --digits 12)
jellett certify "${lorenz[@]}" -o "$scratch/lorenz.json" && jellett check "$scratch/lorenz.json" > "$scratch/out" \
    && grep -q 'no measure whose density' "$scratch/out" && python3 tools/check_certificate.py "$scratch/lorenz.json" > /dev/null ||
    status=1

# The second program serves cycles alone.
got=0
python3 tools/check_certificate.py --table "$table" "$certificate" > "$scratch/out" 2>&1 || got=$?
[ $got -eq 3 ] || { echo "second program on a homoclinic orbit: status $got"; cat "$scratch/out"; status=1; }
[ $status -ne 0 ] || echo "homoclinic orbits are certified, and false certificates refused"
exit $status
