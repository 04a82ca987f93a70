#!/usr/bin/env bash
# On a terminal, orbits that are computed many at once and then written are counted once: what is shown never falls and ends
# below the whole; the rate is that of the time since the start. A second or more, for a line appears every 0.2 s.
set -uo pipefail
awk() { LC_ALL=C command awk "$@"; } # numbers have points in any locale
command -v script > /dev/null || { echo "script is missing: there is no terminal to write to"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

begun=$(date +%s%N)
script -qec "jellett section --grid 100x100 --returns 300 --output '$scratch/section.csv'" "$scratch/terminal" < /dev/null > \
    /dev/null ||
    { echo "section ends with $?"; exit 1; }
seconds=$(( ($(date +%s%N) - begun)/1000000 ))e-3
tr '\r' '\n' < "$scratch/terminal" | sed -n 's/^\([0-9]*\) of \([0-9]*\) returns.*/\1 \2/p' > "$scratch/shown"
awk '$1 < last || $1 > $2 || $2 != 3000000 { print "after " last ": " $0; bad = 1 } { last = $1 } END { exit bad || NR == 0 }' \
    "$scratch/shown" || exit 1
# Of what was computed in all that time, which holds the start and the writing of the table.
tr '\r' '\n' < "$scratch/terminal" | sed -n 's/^\([0-9]*\) of .* returns, \([-0-9.e+]*\) a second, .*/\1 \2/p' | tail -1 |
    awk -v seconds="$seconds" '{ least = $1/seconds; if (!($2 >= least &&
        $2 < 10*least)) { print $2 " a second, " $1 " in " seconds " s"; exit 1 } }'

# A picture that is being drawn is told of, and the line is wiped.
if gnuplot --version > /dev/null 2>&1; then
    script -qec "jellett simulate lorenz --start x=1,y=1,z=1 --times 0,1 -o '$scratch/rows.csv' --plot '$scratch/p.svg'" \
        "$scratch/terminal" < /dev/null > /dev/null || { echo "simulate ends with $?"; exit 1; }
    grep -q 'picture is being drawn.*\[K$' "$scratch/terminal" || { cat "$scratch/terminal"; echo 'no word of it'; exit 1; }
fi

# The steps of a proof are counted too.
script -qec "jellett check '$JLT_SOURCE_DIR/tools/certificates/turn_over.json'" "$scratch/terminal" < /dev/null > /dev/null ||
    { echo "check ends with $?"; exit 1; }
tr '\r' '\n' < "$scratch/terminal" | sed -n 's/^\([0-9]*\) validated steps, .*/\1/p' > "$scratch/shown"
sort -nuc "$scratch/shown" && [ -s "$scratch/shown" ] || { echo "steps of a proof:"; cat "$scratch/shown"; exit 1; }

# And the zeros on a line of symmetric orbits.
script -qec "jellett orbits restricted_three_body --section y=0 --direction both --mirror y,vx --period 8 \
    --start x=0.5,vx=0,vy=1 --line vy=0.2:1.5:600 -o '$scratch/line.csv'" "$scratch/terminal" < /dev/null > /dev/null ||
    { echo "orbits on a line end with $?"; exit 1; }
tr '\r' '\n' < "$scratch/terminal" | sed -n 's/^\([0-9]*\) of [0-9]* zeros, .*/\1/p' > "$scratch/shown"
sort -nuc "$scratch/shown" && [ -s "$scratch/shown" ] || { echo "zeros on a line:"; cat "$scratch/shown"; exit 1; }

# A line fits the terminal, which would go on with it on the next; a terminal that cannot rewrite a line gets none.
grid="jellett section --grid 100x100 --returns 100 --output '$scratch/section.csv'"
script -qec "stty cols 30; $grid" "$scratch/terminal" < /dev/null > /dev/null || { echo "section ends with $?"; exit 1; }
tr '\r' '\n' < "$scratch/terminal" | sed -n 's/\x1b\[K//; /^[0-9]* of 1000000 returns/p' > "$scratch/shown"
awk 'length($0) > 29 { print "30 columns: " $0; bad = 1 } END { exit bad || NR == 0 }' "$scratch/shown" || exit 1
script -qec "TERM=dumb $grid" "$scratch/terminal" < /dev/null > /dev/null || { echo "section ends with $?"; exit 1; }
! grep -q "$(printf '\033')" "$scratch/terminal" || { echo "TERM=dumb: $(cat -v "$scratch/terminal")"; exit 1; }
