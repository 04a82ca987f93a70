#!/usr/bin/env bash
# `jellett bench` measures against true values, and its errors are those that theory says: methods reach rounding, differences
# and multiple eigenvalues do not. Oracles: quadruple precision (section, slope, tiers), ball arithmetic (jacobian, eigenvalues).
set -euo pipefail
awk() { LC_ALL=C command awk "$@"; } # numbers have points in any locale
data=$JLT_SOURCE_DIR/tests/reference/data
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
status=0
fail() { echo "$*"; status=1; }

# TABLE CONDITION: an awk condition on a row that exactly one row or more must meet, and none may break.
each() {
    awk -F, -v OFS=, "$2"' { seen++; if (!('"$3"')) { print FILENAME ": " $0; bad = 1 } } END { exit bad || !seen }' \
        "$folder/$1.csv" \
        || fail "$1: rows with $2 should have $3"
}

for kind in section slope jacobian eigenvalues tiers; do
    options=(--quick --repeats 1)
    case $kind in
    section) options+=(--reference "$data/grid_regular_51.csv" --returns 10 --form level) ;;
    slope) options+=(--reference "$data/slopes_regular_51.csv" --method dop853) ;;
    tiers) options+=(--reference "$data") ;;
    esac
    jellett bench $kind "${options[@]}" --output "$folder/$kind.csv"
    columns=$(grep -v '^#' "$folder/$kind.csv" | awk -F, '{ print NF }' | sort -u | wc -l)
    [ "$columns" = 1 ] || fail "$kind: rows of different length"
done

# Ten returns multiply errors by less than 3e2 (from DP); a tolerance is met within 1e3 of it by every method at 1e-11.
# An error of exactly 0 would be that of no orbit.
each section '$1 == "jellett" && $5 == "1e-11"' '$6 != "" && $6 > 0 && $6 < 1e-7 && $14 == 0'
each section '$2 == "gauss" && $5 == "1e-14"' '$6 < 1e-12 && $7 < 1e-12 && $8 < 1e-12'
# Central differences of a map computed to 1e-14 with step h keep 1e-14/h and lose h^2: never better than (1e-14)^(2/3)/10.
each slope '$3 == "variational" && $5 == "1e-14"' '$6 < 1e-11'
each slope '$3 == "central"' '$6 > 4e-11'
each slope '$3 == "central" && $5 == "1e-14"' '$6 < 1e-7'
# Generated Jacobians err by a few units of rounding of a column; one-sided differences by their square root at best.
each jacobian '$2 ~ /^generated/' '$7 < 1e-14'
each jacobian '$2 == "forward" && $3 == "generic"' '$5 > 1e-9'
# Step h = 1e-4 leaves h^2 of central and h of forward differences, times ratios of derivatives within 1e-2 .. 1e2; rounding 1e-12.
each jacobian '$2 == "central" && $3 == "generic" && $4 == "1e-04"' '$5 > 1e-10 && $5 < 1e-6'
each jacobian '$2 == "forward" && $3 == "generic" && $4 == "1e-04"' '$5 > 1e-6 && $5 < 1e-2'
# A fourfold defective zero: the square root of rounding for QR, a fourth root for the polynomial, rounding where it is taken out.
each eigenvalues '$2 == "closed form"' '$6 < 1e-14'
each eigenvalues '$2 == "deflated" && $3 != "defective_turned"' '$6 < 1e-14 && $10 == 0'
each eigenvalues '$2 == "deflated" && $3 == "defective_turned"' '$4 < 1e-14'
each eigenvalues '$2 == "QR" && $3 == "defective_turned"' '$4 > 1e-11'
each tiers '$1 == "rod" && $2 == "quadrature"' '$5 < 1e-13 && $7 == 0'
each tiers '$4 + 0 > 0 && $6 != "" && $2 != "quadrature"' '$6 > 0 && $7 > $6' # no step without an evaluation of the field
each tiers '$4 == "1e-14" && $2 != "level_omega3"' '$5 < 1e-11'

expect() { # STATUS COMMAND...
    local wanted=$1 got=0
    shift
    "$@" > "$folder/out" 2> "$folder/err" || got=$?
    [ "$got" = "$wanted" ] || fail "$*: status $got, not $wanted"
    [ -s "$folder/err" ] || fail "$*: says nothing"
}
expect 2 jellett bench
expect 2 jellett bench section
# An option that would have no effect is refused: --list, above all, measures nothing.
expect 2 jellett bench jacobian --list
expect 2 jellett bench eigenvalues --returns 3
expect 2 jellett bench tiers --reference "$data" --threads 2
expect 2 jellett bench slope --reference "$data/slopes_regular_51.csv" --form level
expect 5 jellett bench section --reference "$folder/nothing.csv"
echo "orbit,return,t,gamma3,v_nu,omega_n,omega3" > "$folder/empty.csv"
expect 3 jellett bench section --reference "$folder/empty.csv"
# That the table has no place is said before anything is measured, or read.
expect 5 jellett bench section --reference "$folder/empty.csv" --output "$folder/nowhere/table.csv"
expect 5 jellett bench section --reference "$folder/empty.csv" --output "$folder"
printf '0,0,0,0.1,0.2,0.3,0.4\n0,2,0,0.1,0.2,0.3,0.4\n' > "$folder/gap.csv"
expect 3 jellett bench section --reference "$folder/gap.csv"
printf '0,0,0,0.1\n' > "$folder/short.csv"
expect 3 jellett bench slope --reference "$folder/short.csv"
exit $status
