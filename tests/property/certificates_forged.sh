#!/usr/bin/env bash
# Certificates that were forged, with digests made good, are refused in words, whatever stands in place of a member; none ends the
# program. Nor does a certificate say more than its proof: of orbits around angles, what is unique is unique for their turns.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
# FILE STATUS TEXT STATEMENT...: a copy of FILE.json, of the table FILE.tt, by each statement of Python on c is refused with this
# text.
forged() {
    local source=$1 code=$2 text=$3 got=0
    shift 3
    rm -rf forgeries
    mkdir forgeries
    python3 - "$source.json" "$@" << 'P' || fail "$source: cannot be forged"
import copy, hashlib, json, sys
original = json.load(open(sys.argv[1]))
for i, statement in enumerate(sys.argv[2:]):
    c = copy.deepcopy(original)
    exec(statement)
    if c == original: sys.exit(statement + ": changes nothing")
    c.pop("digest")
    c["digest"] = hashlib.sha256(json.dumps(c, sort_keys=True, separators=(",", ":"), ensure_ascii=False).encode()).hexdigest()
    json.dump(c, open(f"forgeries/{i + 1}.json", "w"), ensure_ascii=False)
P
    jellett check -m "./$source.tt" forgeries/*.json > out 2> err || got=$?
    [ $got -eq "$code" ] && [ ! -s out ] || fail "$source: $got, not $code: $(head -3 out err)"
    for ((i = 1; i <= $#; i++)); do
        grep -F "forgeries/$i.json" err | grep -qF -- "$text" || fail "${!i}: not '$text': $(grep -F "forgeries/$i.json" out err)"
    done
}

cat > fast.tt << 'T'
model fast
param mu
default mu = 1
state x
state y
eq x = y
eq y = mu*(1 - x^2)*y - x
valid fast : 10 - y > 0 "speed"
T
expect_text 0 "" jellett certify cycle ./fast.tt --section y=0 --direction down --start x=2.0086198608748 -o fast.json
expect_text 0 proved jellett check -m ./fast.tt fast.json

# Words are made of what is shown, after that is compared.
statements=()
for value in None 7 True '[]' '{}' '"x"' '{"middle": "7"}' '{"middle": None}'; do
    for member in '["conditions"]["fast"]' '["period"]["middle"]' '["orbit"][0]["x"]' '["multipliers"][0]["re"]'; do
        statements+=("c['shown']$member = $value")
    done
done
for member in conditions period orbit determinant trace claims; do
    statements+=("c['shown']['$member'] = None" "c['shown']['$member'] = 7" "del c['shown']['$member']")
done
forged fast 1 "does not follow" "${statements[@]}"
forged fast 1 "its theorem is not what its numbers say" "c['theorem'] = None" "c['theorem'] = 'proved'" "c['theorem'] = []" \
    "c['theorem'][1] = 7" "c['theorem'] += ['Each orbit attracts.']"

# A state that is said to have grown by 0 periods would be said to have one; numbers of periods stand in an object, and are whole.
statements=()
for turns in "{'x': 0}" "{'x': 0, 'y': 0}" "{'y': 1.0}" "{'y': '1'}" "{'z': 1}" "{'y': None}" "{'y': 1000001}"; do
    statements+=("c['given']['legs'][0]['turns'] = $turns")
done
forged fast 3 "no state with a whole number from -1000000 to 1000000 other than 0" "${statements[@]}"
statements=()
for turns in None 7 True "'abc'" '[1]' '[]' '{}'; do
    statements+=("c['given']['legs'][0]['turns'] = $turns")
done
forged fast 3 "turns: no states with their numbers of periods" "${statements[@]}"
forged fast 3 "turns: y has no period that fast proves" "c['given']['legs'][0]['turns'] = {'y': 1}"

# Levels and parameters stand in objects, also where there are none.
statements=("del c['given']['levels']")
for levels in None 7 True "'abc'" '[]'; do statements+=("c['given']['levels'] = $levels"); done
forged fast 3 "levels: no object of integrals" "${statements[@]}"
sed '/^param/d; /^default/d; s/mu.(/(/' fast.tt > plain.tt
sed -i 's/^model fast/model plain/' plain.tt
expect_text 0 "" jellett certify cycle ./plain.tt --section y=0 --direction down --start x=2.0086198608748 -o plain.json
statements=("del c['given']['parameters']")
for parameters in None 7 "'abc'" '[]'; do statements+=("c['given']['parameters'] = $parameters"); done
forged plain 3 "it must give all 0 parameters of plain" "${statements[@]}"

# Roots and logarithms that the table does not prove to be defined.
for record in 'root r = sqrt(y + 5)' 'log r = log(y + 5)'; do
    { cat fast.tt; echo "$record"; } | sed 's/^model fast/model doubted/' > doubted.tt
    kind=${record%% *}
    expect_text 3 "the $kind claim r of this table is not proved" jellett certify cycle ./doubted.tt --section y=0 \
        --direction down --start x=2.0086198608748 -o doubted.json
    sed 's/"name": "fast"/"name": "doubted"/; s/'"$(sha256sum < fast.tt | cut -c1-64)/$(sha256sum < doubted.tt | cut -c1-64)/" \
        fast.json > doubted.json
    forged doubted 1 "refused: the $kind claim r of this table is not proved" "c['theorem'] = []"
done
# What else is not proved is said, as where certificates are made.
{ cat fast.tt; echo 'integral E = x^2 + y^2'; } | sed 's/^model fast/model claimed/' > claimed.tt
expect_text 0 "" jellett certify cycle ./claimed.tt --section y=0 --direction down --start x=2.0086198608748 -o claimed.json
expect_text 0 "kernels of claimed rest on claims that are not proved: integral E" jellett check -m ./claimed.tt claimed.json
exit $status
