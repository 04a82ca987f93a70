#!/usr/bin/env bash
# What a picture writes and draws: units of its axes, the rows of a long orbit, and letters that no font has.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
gnuplot --version > /dev/null 2>&1 || exit 77
export LC_ALL=C.UTF-8 XDG_CACHE_HOME=$scratch/.cache
top="--start gamma3=0.25,v_nu=0.8,omega_tau=-0.6,omega_n=1.1,omega3=-2.3 --times 0,1"
base=(jellett simulate lorenz --start x=1,y=1,z=20 --times "0,1/2,1")

# Times and rates are in seconds where the table has units of time, and numbers where it has none.
while read -r unit line; do
    # shellcheck disable=SC2086
    jellett $line --plot p.svg --keep p.gp -o rows.csv 2> log || fail "$line: $(cat log)"
    said=$(grep -cE "label '.*\[(1/)?s\]" p.gp)
    case $unit in s) [ "$said" -gt 0 ] ;; *) [ "$said" -eq 0 ] ;; esac || fail "$line: $(grep label p.gp)"
done << END
s simulate $top
s simulate $top --axes t,gamma3
s simulate $top --sweep a3=0.5:0.51:2 --axes t,contact_force
s lyapunov --returns 4
- simulate lorenz --start x=1,y=1,z=20 --times 0,1/2,1
- simulate lorenz --start x=1,y=1,z=20 --times 0,1/2,1 --axes t,z
- lyapunov lorenz --section z=27 --start x=-13.76,y=-19.58 --returns 4
- lyapunov lorenz --section z=27 --start x=-13.76,y=-19.58 --returns 3 --sweep rho=27:28:2 --axes rho,lambda1
- lyapunov lorenz --section z=27 --grid x=-14:-13:2,y=-20:-19:2 --returns 1
- eigen lorenz
END
# What a table observes has its unit in the picture of a sweep too; exponents are raised wherever a unit stands.
for sweep in '' '--sweep a3=0.5:0.51:2'; do
    # shellcheck disable=SC2086
    jellett simulate $top $sweep --axes t,contact_force --plot p.svg --keep p.gp -o rows.csv 2> log
    grep -qF 'kg*m/s^{2}]' p.gp || fail "contact_force $sweep: $(grep label p.gp)"
done
grep -qF 'jellett simulate at each a_{3}' p.gp || fail "the title of a sweep: $(grep title p.gp)"
# The title has all that the points share, also where it was typed.
while read -r title line; do
    # shellcheck disable=SC2086
    jellett $line --plot p.svg --keep p.gp -o rows.csv 2> log || fail "$line: $(cat log)"
    grep -qF "m=1, R=1, g=1, I_{1}=0.333333, I_{3}=${title//,/, }}'" p.gp || fail "$line: $(grep 'set title' p.gp)"
done << 'END'
0.3,a_{3}=0.4,G=−0.5 section --set a3=0.4,I3=0.3 --level G=-0.5 --sweep E=2:2.1:2 --start eta=0.1,gamma3=-0.6 --returns 2
0 measure --set I3=0 --sweep a3=0.1:0.5:2
END
[ "$(grep -c '^#.* m=1' rows.csv)" -eq 1 ] || fail "measure: what the points share stands in $(grep -c '^#.* m=1' rows.csv) lines"
jellett rod --start gamma3=0.2,v_nu=0.6,omega_tau=0.4,omega_n=1,omega3=0 --sweep omega_n=1:2:3 --plot p.svg --keep p.gp -o rows.csv
grep -q 'start γ_{3}=0.2, v_{ν}=0.6, ω_{τ}=0.4, ω_{3}=0}' p.gp || fail "rod: $(grep title p.gp)"
# --axes of a sweep are refused when its first point has said which columns there are.
printf '%s\n' 'model drops' 'param k' 'default k = 1' 'state y' 'eq y = -k' 'valid up : y > 0' > drops.tt
jellett simulate ./drops.tt --start y=1 --times 2 --sweep k=1:2:2 --axes k,none --plot p.svg -o rows.csv 2> log
{ [ $? -eq 2 ] && grep -q "no 'none' to draw; there are k, t, y, fate" log && grep -q 'at k=1' log && ! grep -q 'at k=2' log; } ||
    fail "--axes k,none: $(cat log)"

# A script that is kept draws without a warning, also a logarithmic panel below one of negative numbers.
printf '%s\n' 'model below' 'state y [m^-2]' 'eq y = 0' 'integral kept = y' > below.tt
jellett simulate ./below.tt --start y=-9 --until 1 --every 1/8 --plot p.svg --keep p.gp -o rows.csv 2> log
grep -qF "ylabel '[m^{−2}]'" p.gp || fail "the unit of a panel: $(grep ylabel p.gp)"
gnuplot p.gp > log 2>&1
[ ! -s log ] || fail "gnuplot warns of a script that is kept: $(head -3 log)"

# Neither memory nor gnuplot's time grows with the rows of an orbit; its end is drawn.
jellett simulate --start gamma3=-0.6,v_nu=0.5,omega_tau=0.3,omega_n=1,omega3=0.8 --until 10 --every 1/20000 --axes t,gamma3 \
    --plot p.svg --keep p.gp -o rows.csv 2> log || fail "an orbit of many rows: $(cat log)"
grep -c '^[0-9]' rows.csv > rows
sed -n '/^\$ROWS/,/^END/p' p.gp | grep '^[0-9]' > drawn
[ "$(cat rows)" -gt 100000 ] && [ "$(wc -l < drawn)" -le 100001 ] && grep -q 'title .*one row in 2' p.gp ||
    fail "of $(cat rows) rows $(wc -l < drawn) are drawn: $(grep title p.gp | head -1)"
grep '^[0-9]' rows.csv | sed -n '3p;$p' | cut -d, -f 1,2 | tr , ' ' > wanted
sed -n '2p;$p' drawn | cut -d ' ' -f 1,2 | cmp -s - wanted || fail "other rows are drawn: $(sed -n '2p;$p' drawn)"
jellett simulate lorenz --start x=1,y=1,z=20 --until 10.0001 --every 1/10000 --axes t,z --plot p.svg --keep p.gp -o rows.csv 2> log
sed -n '/^\$ROWS/,/^END/p' p.gp | tail -2 | grep -q '^10.0001 ' || fail "the last of 100002 rows is not drawn: $(cat log)"

# A name that is broken at the end of a line stays an index on the next one, and nothing behind it grows.
long=quantity_with_a_name_that_no_line_of_a_small_picture_holds
printf '%s\n' 'model long' "state $long" "eq $long = 0" "integral squared = $long^2" > long.tt
jellett simulate ./long.tt --start $long=1 --until 1 --every 1 --size 8x6cm --plot p.svg --keep p.gp -o rows.csv 2> log ||
    fail "a long name: $(cat log)"
grep -qF ",}}'.\"\\n\".'{/*0.85 _{holds}=1; tier model" p.gp ||
    fail "a long name: $(grep '^set multiplot' p.gp)"
# Drifts are drawn where one has a value, and those of less than 1e-17 are said to be.
grep -q 'label .drift ≥ 10^{−17}' p.gp || fail "drifts of 0: $(grep label p.gp)"
# In a low panel the label is one word.
jellett simulate --start gamma3=-0.6,v_nu=0.5,omega_tau=0.3,omega_n=1,omega3=0.8 --until 1 --every 0.1 --size 8x6cm --plot p.svg \
    --keep low.gp -o rows.csv 2> log || fail "low panels: $(cat log)"
grep -q "ylabel 'drift'" low.gp || fail "low panels: $(grep label low.gp)"
jellett simulate ./long.tt --start $long=1e200 --until 1 --every 1 --plot p.svg --keep p.gp -o rows.csv 2> log ||
    fail "drifts without values: $(cat log)"
! grep -q drift p.gp || fail "drifts without values: $(grep label p.gp)"
# A power of ten that counts stands beside its panel, where no title runs into it.
jellett simulate ./long.tt --start $long=1e100 --until 1 --every 1 --plot p.svg --keep p.gp -o rows.csv 2> log
grep -q 'label .*×10^{100}}. at graph 1,' p.gp || fail "the power of ten of a panel: $(grep label p.gp)"

# Beside a colour box the numbers below the axis have less room.
for command in "eigen --set a3=0 --at v_nu=0.7,omega3=1.1 --sweep gamma3=-0.9:0.9:9" \
    "lyapunov --grid eta=-0.5:0.5:20,gamma3=-0.7:-0.6:2 --returns 2"; do
    # shellcheck disable=SC2086
    jellett $command --size 8x6cm --plot p.svg --keep p.gp -o rows.csv 2> log || fail "$command: $(cat log)"
    grep -qx 'set xtics 0.5' p.gp || fail "$command: numbers run into each other: $(grep xtics p.gp)"
done

# An index has parts, each a letter or a word; an ending in capitals is the same ending.
printf '%s\n' 'model parts' 'state gamma3_end' 'state A__b_omega2_' 'eq gamma3_end = 0' 'eq A__b_omega2_ = 1' > parts.tt
jellett simulate ./parts.tt --start gamma3_end=1,A__b_omega2_=0 --until 1 --every 1 --axes A__b_omega2_,gamma3_end --plot p.PNG \
    --keep p.gp -o rows.NPY 2> log || fail "an index of parts: $(cat log)"
{ grep -qF "xlabel 'A_{b,ω2}'" p.gp && grep -qF "ylabel 'γ_{3,end}'" p.gp; } || fail "an index of parts: $(grep label p.gp)"
head -c 4 p.PNG | grep -qF PNG && head -c 6 rows.NPY | grep -qF NUMPY || fail "endings in capitals are other endings"

"${base[@]}" --plot p.svg --keep - -o rows.csv > p.gp 2> log && gnuplot p.gp && [ ! -e ./- ] || fail "--keep -: $(cat log)"

# No file in /tmp is needed to draw. The program may lie there itself.
shut() {
    unshare --mount bash -c 'mount -t tmpfs -o nr_inodes=1 none /tmp && cd /dev/fd/9 && exec /dev/fd/8 "${@:2}"' shut "$@" \
        8< "$(command -v "$1")" 9< .
}
if shut jellett --version > out 2> log; then
    shut "${base[@]}" --plot p.svg -o /dev/null 2> log && [ ! -s log ] || fail "where /tmp is full: $(cat log)"
else echo "skipped: no /tmp of its own may be mounted"; fi

# Fixed points on M^2 are told from orbits in grey too.
jellett portrait --set I1=2/5,I3=1/4 --start gamma3=0.5,v_nu=0.8,omega_tau=0,omega_n=0,omega3=0.9 --orbits 2 --until 1 \
    --style grey --plot p.svg --keep p.gp -o rows.csv 2> log || fail "a portrait in grey: $(cat log)"
orbits=$(grep -o "(1\*\$3>0?\$2:NaN) with lines lc rgb '[^']*" p.gp | grep -o '#[0-9a-f]*$')
points=$(grep -oE "with points lc rgb '[^']*" p.gp | grep -o '#[0-9a-f]*$' | sort -u)
[ -n "$orbits" ] && [ -n "$points" ] && [[ $points != *"$orbits"* ]] || fail "a portrait in grey: orbits $orbits, points $points"
# Twelve lines in grey differ by dashes, and those with the same dashes by black and grey.
{ echo model twelve; printf 'state s%d\n' {1..12}; printf 'eq s%d = 1\n' {1..12}; } > twelve.tt
jellett simulate ./twelve.tt --start "$(printf 's%d=1\n' {1..12} | paste -sd,)" --times 0,1 --style grey --plot p.svg --keep p.gp \
    -o rows.csv 2> log || fail "twelve lines: $(cat log)"
[ "$(grep -oE "with lines lc rgb '[^']*' dt [^ ]*" p.gp | sort -u | wc -l)" -eq 12 ] || fail "twelve lines: $(grep '^plot' p.gp)"

# Orbits that multipliers of 1 leave open are not drawn as unstable; those that a larger one decides are.
printf '%s\n' 'model swing' 'param a > 0' 'state x' 'state y' 'eq x = a*y' 'eq y = -a*x' > swing.tt
sed 's/swing/saddle/; s/^eq x/state z\n&/' swing.tt > saddle.tt
echo 'eq z = z' >> saddle.tt
for case in "swing y=1 degenerate" "saddle y=1,z=0 unstable"; do
    read -r table start title <<< "$case"
    jellett continue ./$table.tt --set a=1 --section x=0 --start $start --along a=1:1.5 --plot p.svg --keep p.gp -o rows.csv \
        2> log || fail "$table: $(cat log)"
    [ "$(grep -o "title '[a-z]*stable'\|title 'degenerate'" p.gp)" = "title '$title'" ] || fail "$table: $(grep ^plot p.gp)"
done
# A caption of many parameters does not take the room of a panel.
{ echo model many; printf 'param parameter_%d\n' {0..23}; printf '%s\n' 'state x' 'eq x = -x'; } > many.tt
jellett simulate ./many.tt --set "$(printf 'parameter_%d=1/3\n' {0..23} | paste -sd,)" --start x=1 --times 0,1 \
    --size 8x6cm --plot p.svg --keep p.gp -o rows.csv 2> log || fail "many parameters: $(cat log)"
grep -q "title 'Motion of many' margins" p.gp || fail "many parameters: $(grep title p.gp)"
# A title leaves room for the axes, or is refused before anything is computed.
for lines in 8 9; do
    "${base[@]}" --axes x,z --size 8x6cm --title "$(seq $lines)" --plot p.svg -o rows_$lines.csv 2> log
    [ $? -eq $((lines == 8 ? 0 : 2)) ] || fail "a title of $lines lines: $(cat log)"
done
[ ! -e rows_9.csv ] && grep -q '9 lines are more than half of the height' log || fail "a title of 9 lines: $(cat log)"

# Letters that would leave no room for axes are refused, whatever is drawn; of those that leave some, the caption keeps to one line.
expect 2 '^jellett simulate: --font: letters of 14 points leave no room for axes in 7x6cm: 9.4 points at most, or another --size$' \
    "${base[@]}" --size 7x6cm --font Times,14 --plot small.svg -o small.csv
[ ! -e small.svg ] && [ ! -e small.csv ] || fail "letters of 14 points: something is written"
jellett section --grid 2x2 --returns 2 --size 8x6cm --font Times,10 --plot p.svg --keep p.gp -o rows.csv 2> log ||
    fail "letters of 10 points: $(cat log)"
jellett section --grid 2x2 --returns 2 --size 8x8cm --font Times,12 --style nokey --plot p.svg -o rows.csv 2> log ||
    fail "letters of 12 points, without a key: $(cat log)"
! grep -q '^set title .*I_' p.gp || fail "a caption of parameters takes the room of axes: $(grep '^set title' p.gp)"

# Keys and labels of panels fit with the largest letters that are not refused: a letter is half as wide as high.
jellett separation --grid eta=0.40:0.48:3,gamma3=-0.63:-0.61:2 --returns 2 --settle 0 --cells 10x10 --size 8x6cm \
    --font Times,10.7 --plot p.svg --keep p.gp -o rows.csv 2> log || fail "separation: $(cat log)"
grep -oP "(?<= title ')[^']*(?=')" p.gp | awk 'length > 29 { exit 1 }' || fail "a key is too wide: $(grep '^plot' p.gp)"
jellett rod --start gamma3=0.2,v_nu=0.6,omega_tau=0.4,omega_n=1,omega3=0 --sweep omega_n=0.2:2:3 --size 8x6cm --font Times,10.7 \
    --plot p.svg --keep p.gp -o rows.csv 2> log || fail "rod: $(cat log)"
grep -oP "(?<=^set ylabel ')[^']*" p.gp | awk '{ n += length } END { exit !(n / 4 < (6 / 2.54 * 72 / 10.7 - 6) / 2) }' ||
    fail "labels of panels run into each other: $(grep ylabel p.gp)"

# A letter that no font has is named, where the picture is drawn here.
base_title() { "${base[@]}" --title "$1" --plot p.$2 -o rows.csv 2> log || fail "--title '$1': $(cat log)"; }
if command -v fc-list > fonts && [ -n "$(fc-list ':charset=3b3')" ]; then
    base_title $'\u03b3, of \U10fffd' pdf
    grep -qF $'no font here has \'\U10fffd\'' log || fail "a letter of no font: $(cat log)"
    base_title $'\u03b3, of \U10fffd' svg
    [ ! -s log ] || fail "a letter of no font in SVG: $(cat log)"
    base_title $'\u03b3, of \u03c9' png
    [ ! -s log ] || fail "letters of a font: $(cat log)"
fi
exit $status
