#!/usr/bin/env bash
# simulate, rod, portrait, run and plan as typed: the quadruple-precision orbits within 1e-11 at --tol 1e-13, ends at poles,
# comparisons of tiers, quadratures against integration, scenes with every mistake at its line.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
set -e
cd "$JLT_SOURCE_DIR"

# expect STATUS TEXT COMMAND...: the exit status, and TEXT somewhere in what is said on standard error.
expect() {
    local want=$1 text=$2 got=0
    shift 2
    "$@" > "$scratch/out" 2> "$scratch/err" || got=$?
    [ "$got" = "$want" ] || fail "$*: status $got, not $want: $(cat "$scratch/err")"
    grep -qF -- "$text" "$scratch/err" || fail "$*: does not say '$text': $(cat "$scratch/err")"
}

# largest difference of columns 2 to 6 of the rows of FILE from those of the reference with the same time; rows compared
against() {
    awk -F, 'FNR == 1 { file++ } /^#/ || $1 == "t" { next }
        file == 1 { for (i = 2; i <= 6; i++) want[$1 + 0, i] = $i; known[$1 + 0]; next }
        ($1 + 0) in known { rows++; for (i = 2; i <= 6; i++) { d = $i - want[$1 + 0, i]; if (d < 0) d = -d;
        if (d > worst) worst = d } }
        END { printf "%d %.3g\n", rows, worst }' "$1" "$2"
}

generic=(jellett simulate --set m=1.3,R=0.7,g=9.81,I1=0.29,I3=0.21,a3=-0.12
         --start gamma3=0.25,v_nu=0.8,omega_tau=-0.6,omega_n=1.1,omega3=-2.3)
rod=(jellett simulate --set I1=0.7,I3=0,a3=0.3 --start gamma3=0.2,v_nu=0.6,omega_tau=0.4,omega_n=1.3,omega3=-0.8)
for method in dop853 taylor rk8pd msadams; do
    "${generic[@]}" --times 0,0.5,1 --tol 1e-13 --method $method -o "$scratch/generic.csv"
    read -r rows worst < <(against tests/reference/data/flow_generic.csv "$scratch/generic.csv")
    awk -v r="$rows" -v w="$worst" 'BEGIN { exit !(r == 3 && w <= 1e-11) }' ||
        fail "$method, generic orbit: $rows rows, error $worst"
done
for tier in quadrature level five track; do
    "${rod[@]}" --times 0,1,3,10 --tol 1e-13 --tier $tier -o "$scratch/rod.csv"
    read -r rows worst < <(against tests/reference/data/flow_rod.csv "$scratch/rod.csv")
    awk -v r="$rows" -v w="$worst" 'BEGIN { exit !(r == 4 && w <= 1e-11) }' || fail "$tier, rod: $rows rows, error $worst"
done

# The pole at t = 1.74782627825...: a last row with its time and fate, and words about it.
expect 0 'reaches the pole gamma3 = +1 at t = 1.74782627825' "${generic[@]}" --times 1,2,4 --tol 1e-13
awk -F, '/^[0-9]/ { n++; t = $1; fate = $NF } END { exit !(n == 2 && t > 1.747826278 && t < 1.747826279 && fate == "pole+") }' \
    "$scratch/out" || fail "no row for the pole"
# Projected onto the levels of the start the integrals are off by a part of the last step's error alone, in every tier, and
# the rows stay on the orbit: its error is that of the tolerance.
start=gamma3=0.25,v_nu=0.8,omega_tau=-0.6,omega_n=1.1,omega3=-2.3
jellett simulate --start $start --times 20 --tol 1e-13 --method gauss -o "$scratch/true.csv"
for tier in level five track; do
    jellett simulate --start $start --times 20 --tol 1e-9 --tier $tier --project -o "$scratch/projected.csv"
    awk -F, '/^20,/ && $7 < 1e-11 && $8 < 1e-11 { good = 1 } END { exit !good }' "$scratch/projected.csv" ||
        fail "$tier, projected: $(tail -1 "$scratch/projected.csv")"
    read -r rows worst < <(against "$scratch/true.csv" "$scratch/projected.csv")
    awk -v r="$rows" -v w="$worst" 'BEGIN { exit !(r == 1 && w <= 1e-7) }' || fail "$tier, projected: error $worst"
done
expect 2 'the multistep method msadams: take gauss' jellett simulate --start $start --times 20 --project --method msadams
expect 2 'lorenz has no integrals to go back to' jellett simulate lorenz --start x=1,y=1,z=1 --times 1 --project

# Drift of E and G by every method: grows with the returns, and not when projected.
jellett drift --returns 256 --tol 1e-10 -o "$scratch/drift.csv"
jellett drift --returns 256 --tol 1e-10 --project -o "$scratch/projected.csv"
for method in dop853 gauss taylor rk8pd rkf45 msadams; do
    awk -F, -v m=$method '$1 == m && $2 == 256 { found = $5 > 1e-14 && $5 < 1e-5 } END { exit !found }' "$scratch/drift.csv" ||
        fail "drift: no row for $method"
    [ $method = msadams ] && continue
    awk -F, -v m=$method '$1 == m && $2 == 256 { found = $5 < 1e-10 && $6 < 1e-10 } END { exit !found }' \
        "$scratch/projected.csv" || fail "drift: $method is not projected"
done
grep -q '^# rk8pd: E drifts as returns^' "$scratch/drift.csv" || fail "drift: no slopes"
# From G = 0, or rounding of that, G's drift is not divided: it is in the table's units, a million times as large as the mass is.
from_zero() { # MASS ENERGY
    jellett drift --level "E=$2,G=0" --set "m=$1,I1=$1/3,I3=$1/3" --start eta=0.3,gamma3=0.1 --returns 2 --method dop853 \
        --tol 1e-6 | awk -F, '/^dop853,2/ { print $6 }'
}
light=$(from_zero 1 2.15) heavy=$(from_zero 1000000 2150000)
awk -v light="$light" -v heavy="$heavy" 'BEGIN { exit !(light > 1e-10 && light < 1e-7 && (heavy/light/1e6 - 1)^2 < 0.01) }' ||
    fail "drift of G from 0: $light, and of a heavy top $heavy"
# An orbit that ends has its rows until then, and its end by name; (4.4) is where a balanced sphere may come to rest.
ends() {
    jellett drift --tol 1e-10 "${@:2}" -o "$scratch/end.csv" 2> "$scratch/err" || fail "drift to its end: $(cat "$scratch/err")"
    [ "$(grep -c "^# .*: ends by $1 at t = .*, after [0-9]* returns$" "$scratch/end.csv")" = 6 ] ||
        fail "drift: not every method ends by $1: $(grep 'ends by' "$scratch/end.csv")"
    awk -F, '/^[a-z]/ { last[$1] = $2 } /^# .*ends by/ { split($1, name, "[ :]+"); split($2, after, " ")
        if (last[name[2]] != after[2]) bad = 1 } END { exit bad }' "$scratch/end.csv" || fail "drift: the last return has no row"
}
ends pole+ --start eta=2,gamma3=-0.5
ends equilibrium --set m=1.3,R=0.9,g=0,I1=0.4,I3=0.4,a3=0 --level E=1,G=0.5 --start eta=1.4,gamma3=-0.4 --returns 100000
# A single chart loses where it divides by something small: b = 0 at gamma3 = -0.51.
jellett simulate --start gamma3=-0.5,v_nu=0.3,omega_tau=-0.4,omega_n=0.8,omega3=1 --until 5 --every 1/10 --tol 1e-12 \
    --compare level_omega_n,level_omega3,five -o "$scratch/charts.csv" 2> "$scratch/err" || fail "comparison of charts failed"
awk -F, '/^t/ { next } /^[0-9]/ { good = $(NF - 1) > good ? $(NF - 1) : good; if ($(NF - 2) == "") lost = 1
        else if ($(NF - 2) > bad) bad = $(NF - 2) } END { exit !(good < 1e-9 && (lost || bad > 100 * good)) }' \
    "$scratch/charts.csv" || fail "the chart without omega3 is not seen to lose at b = 0"

# Quadratures against integration to 1e-12; E1 = 0 is periodic in all states.
jellett rod --start gamma3=0.2,v_nu=0.6,omega_tau=0.4,omega_n=1,omega3=0 --sweep omega_n=0.5:2:31 --check -o "$scratch/rod.csv"
awk -F, '/^[0-9]/ { n++; if ($9 > 1e-12 || $10 > 1e-12) bad = 1 } END { exit !(n == 31 && !bad) }' "$scratch/rod.csv" ||
    fail "quadratures and integration differ"
# Points that fail leave fields empty, and the others their values.
code=0
jellett rod --start gamma3=0.2,v_nu=0.6,omega_tau=0.4,omega_n=1,omega3=0 --sweep v_nu=0:1e200:3 -o "$scratch/rod.csv" \
    2> "$scratch/err" || code=$?
[ $code -eq 4 ] && grep -q '^jellett: at v_nu=5e+199:' "$scratch/err" && grep -q '2 of 3 points failed' "$scratch/err" &&
    [ "$(grep -c '^0,0.25205,.*,3.76544[0-9]*,\|^[15]e+[0-9]*,,,,,,,$' "$scratch/rod.csv")" -eq 3 ] ||
    fail "rod of points that fail: $(cat "$scratch/err")"
expect 4 'nothing that could be drawn' jellett rod --set g=1e300 --start gamma3=0.2,v_nu=0.6,omega_tau=0.4,omega_n=1,omega3=0 \
    --sweep omega_n=1:2:2 --plot "$scratch/rod.svg"
jellett rod --set I1=0.7,a3=0.3 --start gamma3=0.6,v_nu=0,omega_tau=0.4,omega_n=1.2,omega3=-27/20 --check -o "$scratch/rod.csv"
awk -F, '/^[0-9]/ { exit !($10 <= 1e-12) }' "$scratch/rod.csv" || fail "an orbit with E1 = 0 does not return"
# Turns beside both poles, where psi' varies a millionfold: within ten times the quadratures' 2e-14 of mpmath's, with 40 digits.
while read -r inertia start period rotation; do
    jellett rod --set "$inertia" --start "$start" -o "$scratch/rod.csv" || fail "rod beside poles: $start"
    awk -F, -v T="$period" -v W="$rotation" '/^-?[0-9]/ { n++; off = ($6/T - 1)^2 + ($7/W - 1)^2 }
        END { exit !(n == 1 && off < 4e-26) }' "$scratch/rod.csv" || fail "rod beside poles: $(tail -1 "$scratch/rod.csv")"
done << 'T'
I1=1,a3=-0.62 gamma3=0.368,v_nu=2.74,omega_tau=0.738,omega_n=1.42e-6,omega3=-0.32 5.6084374971021789811 -0.50000077604429696453
I1=0.61,a3=-0.49 gamma3=-0.421,v_nu=3.3,omega_tau=-0.0486,omega_n=8.42e-7,omega3=-1.32 5.2814944961967525297 -0.50000047689162128997
I1=1.2,a3=0.72 gamma3=0.438,v_nu=-1.61,omega_tau=3.48,omega_n=1.12e-6,omega3=0.572 1.6853772321861765058 -1.0000000500606267749
T

# Near a pole, where the pace changes a thousandfold and Newton's steps alone went to and fro: the level's orbit, within 1e-12 times
# a hundred for steps and conditioning.
jellett simulate --tier quadrature --compare level --tol 1e-12 -o "$scratch/thin.csv" --set \
    m=0.0175,R=0.117,g=9.81,I1=1.075e-05,I3=0,a3=0.2195 \
    --start gamma3=0.9999999835,v_nu=-2.527,omega_tau=-0.5707,omega_n=1.256,omega3=22.167 --times 0.0123,0.0246,0.037 2> \
    "$scratch/err" ||
    fail "a thin rod beside a pole: $(cat "$scratch/err")"

# A start beside the upper pole, as beside the lower: the level's orbit, within 1e-14 times a hundred for steps and conditioning.
for side in '' -; do
    jellett simulate --tier quadrature --compare level --tol 1e-14 -o "$scratch/beside.csv" --set I1=0.7,I3=0,a3=${side}0.3 \
        --start gamma3=${side}0.999999999999,v_nu=0.6,omega_tau=0.4,omega_n=0.7,omega3=0.5 --times 1 2> "$scratch/err"
    awk -F, '/^1,/ { n++; off = $12 } END { exit !(n == 1 && off <= 1e-12) }' "$scratch/beside.csv" ||
        fail "a start beside a pole: $(cat "$scratch/err" "$scratch/beside.csv")"
done

# M^2: two attracting and two repelling foci, as (4.5) has them.
jellett portrait --set I1=2/5,I3=1/4 --start gamma3=0.5,v_nu=0.8,omega_tau=0,omega_n=0,omega3=0.9 -o "$scratch/m2.csv" \
    --trajectories "$scratch/orbits.csv" --orbits 6
[ "$(grep -c 'attracting focus' "$scratch/m2.csv")$(grep -c 'repelling focus' "$scratch/m2.csv")" = 22 ] ||
    fail "fixed points on M^2"
[ "$(grep -c '^5,' "$scratch/orbits.csv")" -gt 100 ] || fail "orbits on M^2"
# A start at rest is a fixed point as it stands, which levels lose: without slip (a centre), slipping by 1e-9, beside a pole, and
# with omega3 = 0, where all gamma3 are served.
at_rest() { # WORDS GAMMA3 V_NU OMEGA3 COLUMNS: so many rows say so, of points with these columns but for signs
    jellett portrait --set I1=2/5,I3=1/4 --start "gamma3=$2,v_nu=$3,omega_tau=0,omega_n=0,omega3=$4" --orbits 0 > "$scratch/m2.csv"
    grep "$1" "$scratch/m2.csv" | tr -d - | grep -c "^$5,"
}
[ "$(at_rest centre 0.3 0 0.9 0.3,0,0.9)$(at_rest attracting 0.3 1e-9 0.9 0.3,1e09,0.9)" = 22 ] || fail "slow fixed points"
[ "$(at_rest attracting 0.9999999999 0.8 0.01 0.9999999999,0.8,0.01)" = 2 ] || fail "fixed points beside a pole"
at_rest centre 0.3 0.8 0 0 > "$scratch/out" || true
grep -q 'fill a curve' "$scratch/m2.csv" && [ "$(cat "$scratch/out")" = 0 ] || fail "a curve of fixed points"
# The same by levels: v_nu = 0 to within their rounding; and none at all where v_nu^2 would be -1/2.
jellett portrait --set I1=2/5,I3=1/4 --level E=0.4698,G=-0.0675,F0=0.05910975 --orbits 0 -o "$scratch/m2.csv"
[ "$(grep -c '^-\?0.3[0-9.]*,0,.*centre' "$scratch/m2.csv")" = 2 ] || fail "levels of slow ones: $(tail -4 "$scratch/m2.csv")"
# F0 is least there where I1 < I3: rounding makes no such level one without states.
jellett portrait --set I1=1/8,I3=1/4 --level E=81/200,G=-9/80,F0=-243/12800 --orbits 0 -o "$scratch/m2.csv" || fail "the least F0"
[ "$(grep -c '^-\?0.5,0,-\?0.9,.*centre' "$scratch/m2.csv")" = 2 ] || fail "the least F0: $(tail -3 "$scratch/m2.csv")"
jellett portrait --set I1=2/5,I3=1/4 --level E=1,G=0,F0=0.07 --orbits 0 | grep -E 'curve|centre' && fail "no fixed points are some"

expect 3 'omega_n as well' jellett simulate --start gamma3=0,v_nu=0,omega_tau=0 --times 1
expect 3 'strictly between -1 and 1' jellett simulate --start gamma3=1,v_nu=0,omega_tau=0,omega_n=0,omega3=0 --times 1
expect 3 "no tier 'six'" "${generic[@]}" --times 1 --tier six
expect 3 'the reduction momentum serves only where a3 = 0' "${generic[@]}" --times 1 --tier plane
expect 3 'in one direction' "${generic[@]}" --times 1,0.5
expect 2 'say when' "${generic[@]}"
expect 3 'a3 = 0' jellett portrait --set a3=0.1 --level E=1,G=0,F0=0
expect 3 'no state has these levels' jellett portrait --level E=0.1,G=5,F0=0
expect 3 'I3 = 0' jellett rod --set I3=1 --start gamma3=0,v_nu=0,omega_tau=0,omega_n=1,omega3=0
expect 3 'G = 0' jellett rod --start gamma3=0,v_nu=0,omega_tau=0,omega_n=0,omega3=0

# Scenes: shipped ones are read and planned; a mistake has its line; a job's failure is the run's.
for scene in tools/scenes/*.scene; do
    jellett plan "$scene" > "$scratch/plan" || fail "jellett plan $scene"
    jellett run --dry-run "$scene" > /dev/null || fail "jellett run --dry-run $scene"
done
# plan_takes SCENE TIER COMPLAINT: the plan is written out first, for a pipe that closes early would end it.
plan_takes() {
    jellett plan "tools/scenes/$1.scene" > "$scratch/plan" || fail "jellett plan $1"
    grep -q "^  \* $2 .*the smallest" "$scratch/plan" || fail "$1: $3"
}
printf 'accuracy = { tier = "five"; };\ncompute = ( { what = "simulate"; start = { %s }; until = 1; } );\n' \
    'gamma3 = 0.25; v_nu = 0.8; omega_tau = -0.6; omega_n = 1.1; omega3 = -2.3;' > "$scratch/forced.scene"
jellett plan "$scratch/forced.scene" > "$scratch/plan" || fail "jellett plan, a tier by name"
grep -q '^  \* five .*asked for by name' "$scratch/plan" && grep -q '^    level .*is smaller' "$scratch/plan" &&
    jellett run "$scratch/forced.scene" > "$scratch/out" && grep -q '^# tier five' "$scratch/out" ||
    fail "a tier by name: $(cat "$scratch/plan")"
plan_takes rod quadrature "not by quadratures"
plan_takes balanced plane "not on M^2"
plan_takes fig3a level "not on a level of G"
plan_takes full track "not by quadratures for attitude and track"
for scene in rod full; do
    jellett run "tools/scenes/$scene.scene" --into "$scratch" > /dev/null 2> "$scratch/err" ||
        fail "jellett run $scene: $(cat "$scratch/err")"
done
for file in rod_orbit.csv rod_orbit.svg rod.csv rod.svg rod_periodic.csv full.csv full_track.svg full_states.csv full_states.svg; do
    [ -s "$scratch/$file" ] || fail "no $file"
done
awk -F, '/^[0-9]/ { if ($(NF - 1) > 1e-9) bad = 1 } END { exit bad }' "$scratch/full.csv" ||
    fail "quadratures and the full system differ"
printf 'title = "x";\ncompute = ( { what = "simulate"; start = { gamma4 = 1; }; until = 1; } );\n' > "$scratch/bad.scene"
# Plans look at starts and grids, and say what would follow the orbits.
expect 3 "gamma3 must lie strictly between -1 and 1" jellett plan section --start eta=0.1,gamma3=3
expect 3 "give gamma3 as well" jellett plan lyapunov --start eta=0.02
planned() { # WORDS OPTION...
    local words=$1
    shift
    jellett plan "$@" > "$scratch/plan" || fail "jellett plan $*"
    grep -qE "$words" "$scratch/plan" || fail "jellett plan $*: no '$words' in $(tail -2 "$scratch/plan")"
}
planned '^  starts 1 of --start, 100 of a grid, of which 50 are on the section$' \
    section --level E=0.5 --start eta=0.1,gamma3=-0.6 --grid eta=-3:3:10,gamma3=-0.9:0.9:10
planned '^  starts 384 of a grid' section --grid 24x16
planned '^  method gauss, tolerance 1e-09, one orbit at a time$' section --start eta=0.1,gamma3=-0.6 --tol 1e-9
planned '^  method dop853, tolerance 1e-09, one orbit at a time$' fates --grid 24x16 --tol 1e-9 --method dop853
planned '^  many orbits at once by stepanov10 on .*; gauss from where an orbit comes near a pole, or where steps err$' \
    section --grid 24x16
planned '^  many orbits at once by stepanov10 on .*; gauss for orbits that lose a condition, from where' \
    section --grid 24x16 --contact end

expect 3 "bad.scene:2: error: 'start' does not know 'gamma4'" jellett run "$scratch/bad.scene"
expect 3 "bad.scene:2: error: 'start' does not know 'gamma4'" jellett plan "$scratch/bad.scene"
printf 'compute = (\n { what = "simulate"; until = 1; } );\n' > "$scratch/bad.scene"
expect 3 'bad.scene:2: error: simulate ended with status 3' jellett run "$scratch/bad.scene"
expect 5 'No such file' jellett run "$scratch/none.scene"
printf '%s\n' 'compute = ( { what = "section"; start = { eta = 0.1; gamma3 = -0.6; }; returns = 1; output = "r.csv"; } );' \
    > "$scratch/anew.scene"
for again in "" " again"; do
    jellett run "$scratch/anew.scene" --into "$scratch/made" 2> "$scratch/err"
    [ -s "$scratch/made/r.csv" ] || fail "--into a folder made$again: $(cat "$scratch/err")"
    rm -f "$scratch/made/r.csv"
done

# Kepler's orbits have more integrals than are independent: each is kept by --project all the same, and so in an oscillator of any
# size whose second integral is the square of the first. Rows of lanes, which are put back once a return, err by what one return
# does.
cd "$scratch"
cat > ellipse.tt <<'T'
model ellipse
state x
state y
state px
state py
domain off : x^2 + y^2 > 0
root r = sqrt(x^2 + y^2)
eq x = px
eq y = py
eq px = -x/r^3
eq py = -y/r^3
integral H = (px^2 + py^2)/2 - 1/r
integral L = x*py - y*px
integral ex = py*(x*py - y*px) - x/r
integral ey = -px*(x*py - y*px) - y/r
T
cat > twice.tt <<'T'
model twice
state x
state v
eq x = v
eq v = -x
integral E = v^2/2 + x^2/2
integral square = (v^2 + x^2)^2
T
for method in gauss dop853 taylor rkf45; do
    for orbit in 'ellipse x=0.5,y=0,px=0,py=1.6' 'twice x=1,v=0' 'twice x=1e-9,v=0' 'twice x=1e9,v=0'; do
        jellett simulate "./${orbit% *}.tt" --start "${orbit#* }" --times 300 --project --method $method --tol 1e-6 \
            > rows.csv 2> err
        awk -F, '/^t,/ { for (i = 1; i <= NF; i++) drift[i] = $i ~ /^drift/ }
            /^300,/ { n++; for (i = 1; i <= NF; i++) if (drift[i] && $i > 1e-14) bad = 1 } END { exit n != 1 || bad }' rows.csv ||
            fail "$orbit by $method, projected: $(tail -1 rows.csv) $(cat err)"
    done
done
jellett section ./ellipse.tt --section y=0 --start x=0.5,px=0,py=1.6 --start x=0.5,px=0,py=1.6 --returns 1000 --project --tol 1e-6 \
    > rows.csv 2> err
awk -F, '/^1,[1-9]/ { n++; off = ($5^2 + $6^2)/2 - 1/$4 + 0.72; if (n == 1) one = off; if (off*off > 4*one*one) bad = 1 }
    END { exit n != 1000 || bad }' rows.csv ||
    fail "an ellipse in lanes, projected: $(tail -1 rows.csv) $(cat err)"
exit $status
