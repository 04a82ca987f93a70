#!/usr/bin/env bash
# Certificates replay from their files, and one that says something else is refused: a changed digit, with its digest made good or
# not, another table, another hash, another theorem. Digests are made by Python here, and by jansson and the project's own SHA-256
# there.
set -euo pipefail
cd "$JLT_SOURCE_DIR"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
status=0
certificate=tools/certificates/lorenz_ab.json

expect() { # STATUS FILE TEXT OPTION...
    local got=0
    jellett check "${@:4}" "$2" > "$scratch/out" 2>&1 || got=$?
    if [ $got -ne "$1" ] || ! grep -qF -- "$3" "$scratch/out"; then
        echo "$2: status $got, wanted $1 and '$3':"
        cat "$scratch/out"
        status=1
    fi
}

expect 0 $certificate proved

# NAME STATEMENT [digest]: a copy changed by a statement of Python on c, with a digest of its own where asked.
change() {
    python3 - "$certificate" "$scratch/$1.json" "$2" "${3:-}" << 'END'
import hashlib, json, sys
source, target, statement, mend = sys.argv[1:]
c = json.load(open(source))
exec(statement)
if mend:
    c.pop("digest")
    c["digest"] = hashlib.sha256(json.dumps(c, sort_keys=True, separators=(",", ":")).encode()).hexdigest()
json.dump(c, open(target, "w"), indent=1)
END
}

# Those that are published are of the tables as they stand, and their digests of their texts.
python3 - tools/certificates/*.json << 'END' || status=1
import hashlib, json, sys
for name in sys.argv[1:]:
    c = json.load(open(name))
    table = c["given"]["table"]
    digest = c.pop("digest")
    text = json.dumps(c, sort_keys=True, separators=(",", ":")).encode()
    known = hashlib.sha256(open(f"codegen/models/{table['name']}.tt", "rb").read()).hexdigest()
    if hashlib.sha256(text).hexdigest() != digest or known != table["sha256"]:
        sys.exit(f"{name}: make it again, tools/certificates/make")
END

change same 'pass' digest
expect 0 "$scratch/same.json" proved
change digit 'c["shown"]["period"]["middle"] = "1.5586522107161747277"'
expect 1 "$scratch/digit.json" 'its digest is not that of its text'
change period 'c["shown"]["period"]["middle"] = "1.5586522107161747277"' digest
expect 1 "$scratch/period.json" 'does not follow'
change radius 'c["shown"]["trace"]["radius"] = "1e-40"' digest
expect 1 "$scratch/radius.json" 'does not follow'
# What is found is compared as it is: balls are written twice as wide, so that one may be wider, or a little narrower, or elsewhere;
# but not so narrow that what is found is not in it.
beside='from decimal import Decimal as D; r = c["shown"]["determinant_of_matrix"]; w = D(r["radius"])
r["middle"], r["radius"] = str(D(r["middle"]) + w*D(%s)), str(w*D(%s))'
for place in '0 10' '0.3 1' '-0.3 1' '0 0.6'; do
    change beside "$(printf "$beside" $place)" digest
    expect 0 "$scratch/beside.json" proved
done
for place in '0.6 1' '0 0.45'; do
    change beside "$(printf "$beside" $place)" digest
    expect 1 "$scratch/beside.json" 'does not follow'
done
change theorem 'c["theorem"][1] = c["theorem"][1].replace("exactly one", "no")' digest
expect 1 "$scratch/theorem.json" \
    "its theorem is not what its numbers say in the words of this version: 'jellett certify' writes one anew"
change box 'c["given"]["legs"][1]["box"]["x"]["middle"] = "13.763620"' digest
expect 1 "$scratch/box.json" 'no orbit is shown to be there'
change parameter 'c["given"]["parameters"]["rho"] = "28001/1000"' digest
expect 1 "$scratch/parameter.json" 'no orbit is shown to be there'
change sink 'c["kind"] = "sink"' digest
expect 1 "$scratch/sink.json" 'not shown to attract'
change hash 'c["given"]["table"]["sha256"] = "0" * 64' digest
expect 3 "$scratch/hash.json" 'no table lorenz with SHA-256 000'
change table 'c["given"]["table"]["name"] = "roessler"' digest
expect 3 "$scratch/table.json" 'no table roessler'
change level 'c["given"]["levels"]["E"] = "1"' digest
expect 3 "$scratch/level.json" 'no integral of lorenz'
change number 'c["given"]["parameters"]["rho"] = "nan"' digest
expect 3 "$scratch/number.json" 'parameter rho: no number'
change instant 'c["given"]["legs"][0]["instant"] = "-1"' digest
expect 3 "$scratch/instant.json" 'instant: a time > 0'
change words 'c["given"]["legs"][0]["box"]["for every rho, a"] = {"middle": "1", "radius": "0"}
c["theorem"][1] = c["theorem"][1].replace(" of the section, and", ", for every rho, a = 1 +- 0 of the section, and")' digest
expect 3 "$scratch/words.json" 'it names more than the 2 states'
change legs 'c["given"]["legs"] = []' digest
expect 3 "$scratch/legs.json" 'legs: 1 to 128'
change order 'c["given"]["legs"].reverse()' digest
expect 1 "$scratch/order.json" 'does not follow'
change fewer 'c["given"]["legs"].pop()' digest
expect 1 "$scratch/fewer.json" 'no orbit is shown to be there'
change still 'legs, orbit = c["given"]["legs"], c["shown"]["orbit"]
legs.insert(0, json.loads(json.dumps(legs[0]))); legs[0]["instant"] = "1e-9"; orbit.insert(0, orbit[0])' digest
expect 1 "$scratch/still.json" 'a leg of the orbit is not shown to take time'
change form 'del c["given"]' digest
expect 3 "$scratch/form.json" 'no certificate'
head -c 1000 $certificate > "$scratch/half.json"
expect 3 "$scratch/half.json" half.json
expect 5 "$scratch/nowhere.json" 'cannot read'

# An orbit of van der Pol's that leaves the domain of its table at another wall is none of the table's.
cycle=(--section y=0 --direction down --start x=2.0086198608748)
for wall in 'domain inside : wall^2 - y^2 > 0' 'domain inside : wall - 14/5 > 0' 'state u in (-wall, wall)' \
    'state u in (-14/5, wall)'; do
    y=y
    [ "${wall%% *}" = domain ] || y=u
    printf 'model vdp\nparam wall > 0\ndefault wall = 3\nstate x\n%s\n%s\neq x = %s\neq %s = - x + %s - x^2*%s\n' \
        "$([ $y = u ] || echo 'state y')" "$wall" $y $y $y $y > "$scratch/vdp.tt"
    jellett certify cycle "$scratch/vdp.tt" "${cycle[@]/y=0/$y=0}" -o "$scratch/vdp.json" > "$scratch/out" 2>&1 ||
        { cat "$scratch/out"; status=1; }
    certificate=$scratch/vdp.json change wall 'c["given"]["parameters"]["wall"] = "2.6"' digest
    expect 1 "$scratch/wall.json" "refused: the orbit is not shown to stay in the domain of its table" --model "$scratch/vdp.tt"
done
# So for the second program, which serves two coordinates, of an orbit of Lorenz's beyond z = 30; and of parameters. Tables are the
# same otherwise, so that one certificate is that of all.
for wall in 'domain inside : 30 - z > 0' 'param wall > 0'; do
    sed '/^eq x/i '"$wall" codegen/models/lorenz.tt > "$scratch/lorenz.tt"
    certificate=tools/certificates/lorenz_ab.json change beyond \
        "c['given']['table']['sha256'] = '$(sha256sum < "$scratch/lorenz.tt" | cut -c1-64)'
if 'param' in '$wall': c['given']['parameters']['wall'] = '-1'" digest
    got=0
    python3 tools/check_certificate.py --table "$scratch/lorenz.tt" "$scratch/beyond.json" > "$scratch/out" 2>&1 || got=$?
    [ $got -eq 1 ] || { echo "second program beyond $wall: status $got"; cat "$scratch/out"; status=1; }
done

# Nor does it let a condition have a larger bound than its least value, here 20.17 of the height that is left.
sed '/^eq x/i valid high : 60 - z > 0 "height"' codegen/models/lorenz.tt > "$scratch/lorenz.tt"
jellett certify cycle "$scratch/lorenz.tt" --section z=27 --period 2 --start x=-13.76,y=-19.58 -o "$scratch/high.json" > /dev/null
python3 tools/check_certificate.py --table "$scratch/lorenz.tt" "$scratch/high.json" > "$scratch/out" 2>&1 ||
    { cat "$scratch/out"; status=1; }
certificate=$scratch/high.json change higher 'c["shown"]["conditions"]["high"] = "20.5"' digest
got=0
python3 tools/check_certificate.py --table "$scratch/lorenz.tt" "$scratch/higher.json" > "$scratch/out" 2>&1 || got=$?
[ $got -eq 1 ] && grep -q 'less than the bound' "$scratch/out" ||
    { echo "second program, a bound: $got"; cat "$scratch/out"; status=1; }
expect 1 "$scratch/higher.json" 'does not follow' --model "$scratch/lorenz.tt"

# Nor does it leave anything unread that stands in `given` or `shown`.
second_refuses() { # TEXT STATEMENT
    local got=0
    certificate=tools/certificates/roessler_1.json change unread "s = c['shown']; $2" digest
    python3 tools/check_certificate.py "$scratch/unread.json" > "$scratch/out" 2>&1 || got=$?
    [ $got -eq 1 ] && grep -qF -- "refused: $1" "$scratch/out" ||
        { echo "second program on $2: status $got"; cat "$scratch/out"; status=1; }
}
second_refuses 'a multiplier is another one' 's["multipliers"][0]["re"]["middle"] = "0.5"'
second_refuses 'a multiplier is another one' 's["multipliers"][1]["im"]["middle"] = "1e-3"'
second_refuses 'its multipliers are not as many as its coordinates' 's["multipliers"].pop()'
for statement in 's["exponent"] = "1"' 's["symmetry"] = {"type": "elliptic"}' 's["conditions"]["high"] = "1"' \
    's["orbit"][0]["y"] = "1"' 's["multipliers"][0]["note"] = "1"' 'c["given"]["note"] = "1"' 'c["note"] = "1"' \
    'c["given"]["legs"][0]["note"] = "1"' 'c["given"]["section"]["note"] = "1"'; do
    second_refuses "" "$statement"
    grep -q "has other members than those that are replayed" "$scratch/out" || { cat "$scratch/out"; status=1; }
done
second_refuses 'a ball has no middle and radius' 's["trace"]["radius"] = "-1e-25"'
second_refuses 'the section is crossed in no direction' 'c["given"]["section"]["direction"] = -7'
second_refuses 'it says to rest on other claims' 's["claims"] = ["integral E"]'

# The second program proves the same, and refuses the same.
python3 tools/check_certificate.py $certificate > "$scratch/out" 2>&1 || { cat "$scratch/out"; status=1; }
for name in box still; do
    got=0
    python3 tools/check_certificate.py "$scratch/$name.json" > "$scratch/out" 2>&1 || got=$?
    [ $got -eq 1 ] || { echo "second program on $name: status $got"; cat "$scratch/out"; status=1; }
done

# Nothing is written where nothing is proved: a saddle is no sink, and no orbit begins there.
refuse() { # STATUS TEXT OPTION...
    local got=0 want=$1 text=$2
    shift 2
    jellett certify "$@" -o "$scratch/none.json" > "$scratch/out" 2>&1 || got=$?
    [ $got -eq "$want" ] && grep -qF -- "$text" "$scratch/out" && [ ! -e "$scratch/none.json" ] ||
        { echo "certify $*: status $got"; cat "$scratch/out"; status=1; }
}
orbit=(lorenz --section z=27 --period 2 --start x=-13.76,y=-19.58 --digits 12)
refuse 1 'not shown to attract' sink "${orbit[@]}"
refuse 1 'no orbit is shown to be there' cycle "${orbit[@]}" --radius 0.01
refuse 4 'the proof could not be carried out' cycle "${orbit[@]}" --radius 1
refuse 3 "neither a parameter nor a level 'a3'" cycle "${orbit[@]}" --spread a3=1e-9
refuse 4 'finds no periodic orbit' cycle lorenz --section z=27 --start x=100,y=-100
refuse 2 'no kind of certificate' saddle "${orbit[@]}"
refuse 2 "unrecognized option '--plot'" cycle "${orbit[@]}" --plot "$scratch/none.svg"
refuse 2 'say near which orbit' cycle lorenz --section z=27
refuse 2 '--distance is an option of homoclinic, not of cycle' cycle "${orbit[@]}" --distance 1e-6
refuse 2 '--orbit is an option of homoclinic, not of sink' sink "${orbit[@]}" --orbit 2
refuse 2 '--box is an option of equilibria, not of cycle' cycle "${orbit[@]}" --box rho=1:2
refuse 2 '--limit is an option of equilibria, not of cycle' cycle "${orbit[@]}" --limit 7
refuse 2 '--period is an option of cycle, elliptic, obstruction, sink and symmetric, not of homoclinic' homoclinic "${orbit[@]}"
for option in '--period 2' '--start x=1' '--radius 1e-9' '--spread a3=1e-9' '--distance 1e-6' '--orbit 2'; do
    refuse 2 "${option% *} is an option of" equilibria --family spin --box I1=0.2:1 $option
done
for option in '--section z=27' '--level E=1' '--solve gamma3=0' '--modulo gamma3=1' '--mirror gamma3' '--direction down' \
    '--tol 1e-9' '--method rk8pd' '--max-steps 7'; do
    refuse 2 "${option% *} is an option of orbits" equilibria --family spin --box I1=0.2:1 $option
done
refuse 2 'one way, up or down' cycle "${orbit[@]}" --direction both

[ $status -ne 0 ] || echo "certificates are replayed, and false ones refused"
exit $status
