#!/usr/bin/env bash
# What `jellett models` lists is what the tables and generated/counts.tsv say, in JSON and in print, of all models or of one.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
cd "$JLT_SOURCE_DIR" || exit 1

jellett models --json > "$scratch/listed"
# Columns of counts.tsv but for the sums and what `ttc` alone says of kernels.
listed='.[] | . as $d | .kernels | to_entries[] | [$d.model, ($d | .variant, .time, .elimination |
    if . == "" then "-" else . end), .key,
    (.value | .optimized, .naive | .add, .multiply, .fma, .divide, .root, .elementary, .depth)] | map(tostring) | join("\t")'
jq -r "$listed" "$scratch/listed" | sort > "$scratch/counts"
[ -s "$scratch/counts" ] || fail "no kernels are listed"
cut -f 1-5,7-13,16-22 generated/counts.tsv | sort | comm -13 - "$scratch/counts" | grep . &&
    fail "generated/counts.tsv has other counts"

jq -r '.[] | .model as $m | .parameters[] | select(.default != null) | [$m, .name, .default] | map(tostring) | join("\t")' \
    "$scratch/listed" |
    sort -u > "$scratch/defaults"
for table in $(grep -L '^lift into ' codegen/models/*.tt); do # tables of coordinates are no models
    # default NAME = NUMBER, ... with numbers like 1/3
    awk -v model="$(basename "$table" .tt)" '/^default / { sub(/^default /, ""); sub(/#.*/, ""); n = split($0, items, ",")
        for (i = 1; i <= n; i++) { split(items[i], pair, "="); gsub(/ /, "", pair[1]); split(pair[2], of, "/")
            printf "%s\t%s\t%.10g\n", model, pair[1], of[2] == "" ? of[1] : of[1]/of[2] } }' "$table"
done | sort > "$scratch/expected"
awk -F '\t' -v OFS='\t' '{ printf "%s\t%s\t%.10g\n", $1, $2, $3 }' "$scratch/defaults" | sort -u | diff - "$scratch/expected" ||
    fail "the tables have other defaults"
jq -e '[.[].states[] | has("default")] | any | not' "$scratch/listed" > /dev/null || fail "states have no defaults"

# Printed: a row a descriptor, with the sums of the operations, and each model's title once.
jellett models > "$scratch/printed"
grep -n ' $' "$scratch/printed" && fail "printed lines end with blanks"
jq -r 'def sum: .optimized | .add + .multiply + .fma + .divide + .root + .elementary;
    .[] | [([.variant, .time, .elimination] | if .[0] == "" then .[0] = "general" else . end | map(select(. != "")) | join(", ")),
        (.states | length), (.kernels | (.rhs | sum), (.jacobian | sum), (.rhs_jacobian | sum))] | map(tostring) | join(" ")' \
    "$scratch/listed" > "$scratch/rows"
awk '/^  kernels/ { on = 1; next } /^$/ { on = 0 } on { sub(/^ */, ""); gsub(/ +/, " "); print }' "$scratch/printed" |
    awk 'NR == FNR { row[FNR] = $0; n = FNR; next } index($0, row[FNR]) != 1 { print "printed " $0 ", not " row[FNR]; bad = 1 }
        END { exit bad || FNR != n }' "$scratch/rows" - || fail "print and JSON differ"
for model in lorenz toda; do
    jellett models $model | diff - <(awk -v RS= "/^$model:/" "$scratch/printed") > /dev/null ||
        fail "$model alone is not what it is among all"
    jellett models --json $model | jq -c . | cmp - <(jq -c "map(select(.model == \"$model\"))" "$scratch/listed") ||
        fail "$model alone, JSON"
done
exit $status
