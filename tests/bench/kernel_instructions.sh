#!/usr/bin/env bash
# No kernel takes more instructions than tests/bench/kernel_instructions.tsv says, where callgrind counted them: the scalar
# kernels and the batched ones of spherical_top_level, for gcc and clang. --write [COLUMN] counts anew, for one release, as gcc14,
# where so named; AVX-512 is unknown to valgrind.
set -euo pipefail
[ "$(uname -m)" = x86_64 ] || { echo "counts are those of x86-64"; exit 77; }
cd "$JLT_SOURCE_DIR"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cc=${JLT_CC:-cc}
column=gcc
case $("$cc" --version) in *clang*) column=clang ;; esac

model=generated/spherical_top_level
"$cc" -O2 -ffp-contract=off -Igenerated -c -o "$folder/calls.o" tests/bench/kernel_calls.c
# All fields, which their list links to each other; what is counted is in one of them.
for file in $model/{general,balanced,rod}*.c $model/table.c; do
    "$cc" -O2 -ffp-contract=off -DJLT_WITHOUT_BALLS -Igenerated -c -o "$folder/$(basename "$file").o" "$file"
done
# As CMakeLists.txt has them.
"$cc" -O3 -ffp-contract=off -Igenerated -c -o "$folder/baseline.o" $model/batch_baseline.c
"$cc" -O3 -ffp-contract=off -mavx2 -mfma -Igenerated -c -o "$folder/avx2.o" $model/batch_avx2.c
"$cc" -O3 -ffp-contract=off -mavx512f -mavx512dq -mavx512vl -mfma -Igenerated -c -o "$folder/avx512.o" $model/batch_avx512.c
"$cc" -o "$folder/calls" "$folder"/*.o -lm

counted=$folder/counted.tsv
for isa in scalar baseline avx2; do
    status=0
    valgrind --quiet --tool=callgrind --compress-strings=no --compress-pos=no --callgrind-out-file="$folder/$isa.out" \
        "$folder/calls" $isa || status=$?
    [ $status -eq 77 ] && continue
    [ $status -eq 0 ] || exit 1
    # Costs of a function itself, over the calls of it; a line after calls= is what the callee took.
    awk -v isa=$isa '
        /^fn=/ { name = substr($0, 4) }
        /^cfn=/ { callee = substr($0, 5) }
        /^calls=/ { split(substr($0, 7), part, " "); calls[callee] += part[1]; skip = 1; next }
        /^[0-9]/ { if (skip) skip = 0; else cost[name] += $2 }
        END {
            for (name in cost) {
                short = name
                sub(/^general_in_regular_+/, "", short)
                if (short ~ /^(rhs|jacobian|rhs_jacobian|divergence|integral_values|integral_gradients|stages)$/)
                    print isa "\t" short "\t" cost[name] / calls[name]
            }
        }' "$folder/$isa.out"
done | LC_ALL=C sort > "$counted"

known=tests/bench/kernel_instructions.tsv
if [ "${1-}" = --write ]; then
    awk -F'\t' -v column="${2:-$column}" '
        FNR == 1 && NR == 1 { for (i = 3; i <= NF; i++) { at[$i] = i; head[i] = $i } n = NF
            if (!(column in at)) { at[column] = ++n; head[n] = column }
            printf "lanes\tkernel"; for (i = 3; i <= n; i++) printf "\t%s", head[i]; print ""; next }
        NR == FNR { for (i = 3; i <= NF; i++) told[$1 FS $2, i] = $i; next }
        { key = $1 FS $2; told[key, at[column]] = $3
          printf "%s", key; for (i = 3; i <= n; i++) printf "\t%s", told[key, i]; print "" }' \
        "$known" "$counted" > "$folder/new.tsv"
    cp "$folder/new.tsv" "$known"
    exit 0
fi
# The compiler's own release where it has a column. Of others a few more may be taken.
release=$column$("$cc" -dumpversion | cut -d. -f1)
head -1 "$known" | tr '\t' '\n' | grep -qx "$release" && column=$release
awk -F'\t' -v column="$column" '
    NR == 1 { for (i = 3; i <= NF; i++) if ($i == column) at = i; next }
    NR == FNR { known[$1 FS $2] = $at; next }
    {
        key = $1 FS $2
        if (known[key] == "") { print key ": not in the file"; failed = 1 }
        else if ($3 > 1.03 * known[key]) { print key ": " $3 " instructions, " known[key] " in the file"; failed = 1 }
        seen++
    }
    END { if (seen < 13) { print seen " kernels counted"; failed = 1 } exit failed }' "$known" "$counted"
