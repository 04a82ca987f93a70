#!/usr/bin/env bash
# Orbits that leave the section and are back within the first step, or touch it at the start, as they are where the flux through
# the section vanishes: batches find the first returns that single orbits find, by another method and another search.
set -uo pipefail
awk() { LC_ALL=C command awk "$@"; } # numbers have points in any locale
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
status=0
for direction in up down both; do
    grid=(--grid 300x40 --returns 1 --direction $direction)
    jellett section --method gauss "${grid[@]}" > one.csv && jellett section "${grid[@]}" > many.csv || status=1
    paste -d, <(grep -v '^[#o]' one.csv) <(grep -v '^[#o]' many.csv) | awk -F, '
        { late = $3 - $12; if ($1 != $10 || $2 != $11 || $9 != $18 || !(late*late < 1e-16)) print; soon += $2 == 1 && $3 < 0.01;
        rows++ }
        END { if (rows < 12000 || soon < 2) print rows " rows, " soon + 0 " returns within a first step" }' > wrong
    if [ -s wrong ]; then
        echo "$direction: $(wc -l < wrong) differ: $(head -1 wrong)"
        status=1
    fi
done
exit $status
