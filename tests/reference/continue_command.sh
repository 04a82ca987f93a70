#!/usr/bin/env bash
# What `jellett continue` lists does not depend on its steps: bifurcations that a long step crosses are rows, sharp folds are
# followed around, no branch is listed twice, and the range's end is reached.
set -euo pipefail
awk() { LC_ALL=C command awk "$@"; } # numbers have points in any locale
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
data=$(cd "$(dirname "$0")" && pwd)/data
cd "$scratch"
failures=0
fail() { printf '%s\n' "$*"; failures=$((failures + 1)); }

# STEP NAME=LOW:HIGH: rows of bifurcations as "branch kind value", all rows in rows.csv. They are located to 1e-10 of arc, but for
# the period doubling where a branch ends: a double point, which steps near it find to 1e-6 only, and which is left out.
bifurcations() {
    jellett continue --branches --along "$2" --step "$1" -o rows.csv 2> log || fail "$2, step $1: status $?"
    awk -F, '/^[0-9]/ && $17 != "" && ($1 == 0 || $17 != "period doubling") { printf "%s %s %.8f\n", $1, $17, $2 }' rows.csv
}

# At a branch point where the period-2 orbits of G lose their symmetry, Newton's method leaves for the other branch.
for step in 0.01 0.003; do
    bifurcations $step G=-0.56:-0.2 > found
    for row in '0 period doubling -0.27198467' '1 fold -0.27181958' '1 branch point -0.27243466'; do
        grep -qxF -- "$row" found || fail "G, step $step: no '$row' among: $(tr '\n' ';' < found)"
    done
    [ "$(cut -d' ' -f2- found | sort | uniq -d)" = "" ] || fail "G, step $step: listed twice: $(cat found)"
    # The asymmetric orbits on the way out of the range: the last row is on its end.
    awk -F, '/^0,/ { last = $2 } END { exit !(last > -0.2 - 1e-12 && last < -0.2 + 1e-12) }' rows.csv ||
        fail "G: the end -0.2 is not reached"
done

# The branch of I3 turns by half a circle within 0.01 before its fold.
for step in 0.01 0.004; do
    bifurcations $step I3=0.28:0.39 > found
    printf '%s\n' '0 period doubling 0.38340270' '1 fold 0.28672235' | cmp -s - found || fail "I3, step $step: $(cat found)"
    grep -q 'it ends at a period doubling' log || fail "I3, step $step: $(cat log)"
done
# A branch point of orbits that are symmetric at no point of the section: a row all the same, whose bracket holds 0.5041034, where
# the trace is 2.
for step in 0.01 0.003; do
    bifurcations $step a3=0.503:0.52 > found
    awk -F, '$17 == "branch point" && $18 < 0.50410347 && $19 > 0.50410331 { found = 1 } END { exit !found }' rows.csv ||
        fail "a3, step $step: $(cat found)"
done

# Orbits x = sqrt(a) turn at a pitchfork, a = 0, which is no fold as well; and with a push e they turn where
# a = x^2 - e/x is least, x = -(e/2)^(1/3): this is a fold.
printf '%s\n' 'model pitchfork' 'param a' 'param e' 'default a = 1/10, e = 0' 'state x' 'state v' 'state phi' \
    'periodic phi = 2*pi' 'eq x = v' 'eq v = a*x - x^3 - v/5 + e' 'eq phi = 1' > pitchfork.tt
for step in 0.003 0.02 0.05; do
    jellett continue ./pitchfork.tt --section phi=0 --start x=0.4,v=0 --along a=-0.1:0.2 --decreasing --step $step -o rows.csv \
        2> log || fail "pitchfork: $(cat log)"
    awk -F, '$17 ~ /./ && /^0/ { n++; bad += $17 != "branch point" || $2^2 > 1e-12 } END { exit !(n == 1 && !bad) }' rows.csv ||
        fail "pitchfork, step $step: $(awk -F, '/^0/ && $17 != "" { print $2, $17 }' rows.csv)"
    jellett continue ./pitchfork.tt --section phi=0 --start x=-0.4,v=0 --set e=1e-6 --along a=-0.1:0.2 --decreasing --step $step \
        -o rows.csv 2> log || fail "pushed pitchfork: $(cat log)"
    awk -F, '$17 ~ /./ && /^0/ { n++; bad += $17 != "fold" || ($2 - 3*(5e-7)^(2/3))^2 > 1e-24 }
        END { exit !(n == 1 && !bad) }' rows.csv ||
        fail "pushed pitchfork, step $step: $(awk -F, '/^0/ && $17 != "" { print $2, $17 }' rows.csv)"
done

# Both sides of that branch point, whose branches are steep.
jellett continue --along G=-0.56:-0.2 --generations 2 -o rows.csv 2> log || fail "generations: status $?"
[ "$(grep -c '^jellett: branch [23], from the branch point at -0.2724346596:' log)" = 2 ] || fail "generations: $(cat log)"

# Roessler's cascade, generation by generation: each branch begins where the one before it loses its stability.
for step in 0.05 0.02; do
    jellett continue roessler --set c=2.5 --section y=0 --direction down --start x=-4,z=0 --along c=2:4.2 --step $step \
        --generations 3 \
        -o rows.csv 2> log || fail "cascade: status $?"
    awk -F, '/^[0-9]/ && /period doubling/ { printf "%s:%s:%.8f ", $1, $4, $2 }' rows.csv > found
    [ "$(cat found)" = "0:1:2.83244503 1:2:3.83735817 2:4:4.12421473 3:8:4.18699700 " ] || fail "cascade, step $step: $(cat found)"
    tail -1 log | grep -q 'not followed: what begins at 1 .* --generations 4$' || fail "cascade: $(tail -1 log)"
done

# Sprott's jerk: the cycle that doubles moves along the eigenvector of -1 as A varies. The cascade is that of SciPy; branches are
# those that begin at the doublings, and not cycles of half their period, nor branches from elsewhere.
printf '%s\n' 'model jerk' 'param A' 'default A = 2.017' 'state x' 'state y' 'state z' 'eq x = y' 'eq y = z' \
    'eq z = -A*z + y^2 - x' > jerk.tt
for step in 0.01 0.004; do
    jellett continue ./jerk.tt --section y=0 --start x=-0.93,z=0.465 --along A=2:2.2 --step $step --generations 3 -o rows.csv \
        2> log || fail "jerk: status $?"
    awk -F, '/^[0-9]/ && /period doubling/ { printf "%s:%s:%.8f ", $1, $4, $2 }' rows.csv > found
    [ "$(cat found)" = "0:1:2.12629949 1:2:2.07138302 2:4:2.06065481 3:8:2.05836803 " ] || fail "jerk, step $step: $(cat found)"
    awk -F, '/^1,/ && $2 > 2.12629949 { exit 1 }' rows.csv || fail "jerk, step $step: a cycle is repeated"
done
# Enough points are enough, also where steps were halved on the way.
jellett continue ./jerk.tt --section y=0 --start x=-0.93,z=0.465 --along A=2:2.4 --count 14 -o rows.csv 2> log
grep -q 'branch 0: the number of points is reached' log || fail "jerk, 14 points: $(cat log)"

# Two quartic oscillators, which k = 1/3 makes independent in x + y and x - y. The branch of that value is a family: it has no
# folds, and meets the orbit it comes from, its image y -> -y, and in between the straight one, y = 0.
printf '%s\n' 'model quartic' 'param k' 'state x' 'state y' 'state px' 'state py' 'eq x = px' 'eq y = py' 'eq px = -x*y^2 - k*x^3' \
    'eq py = -x^2*y - k*y^3' 'integral E = (px^2 + py^2 + x^2*y^2)/2 + k*(x^4 + y^4)/4' > quartic.tt
jellett continue ./quartic.tt --section x=0 --level E=1 --solve px=1 --set k=0 --start y=1.2,py=0 --along k=0:1 --branches \
    -o rows.csv 2> log || fail "quartic: status $?"
awk -F, '/^[12],/ { if ($17 != "") printf "%s %.4f;", $17, $5 < 0 ? -$5 : $5; if (($2 - 1/3)^2 > 1e-18) print "off" }' \
    rows.csv > found
[ "$(cat found)" = "branch point 0.0000;branch point 1.1979;" ] || fail "quartic: $(cat found)"

# The orbit of Henon and Heiles along the axis of symmetry turns ever faster as its energy comes to 1/6: all values of 6 H at which
# its trace is 2 or -2, by SciPy, of which a step far from the end leaps over two or four.
printf '%s\n' 'model axis' 'state x' 'state y' 'state px' 'state py' 'eq x = px' 'eq y = py' 'eq px = - x - 2*x*y' \
    'eq py = - y - x^2 + y^2' 'integral H = (px^2 + py^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3' > axis.tt
jellett continue ./axis.tt --section y=0 --solve py=0.3 --level H=0.05 --start x=0,px=0 --along H=0.01:0.166666 -o rows.csv \
    2> log || fail "the axis: status $?"
grep -q "^# solved for py from 0.3$" rows.csv || fail "the header of a level that runs: $(grep solved rows.csv)"
awk -F, '/^0,/ && $17 != "" { printf "%.9f %s\n", 6*$2, $17 }' rows.csv > found
printf '%s\n' '0.811715516 period doubling' '0.915214413 period doubling' '0.969309091 branch point' '0.986709235 branch point' \
    '0.995013005 period doubling' '0.997849055 period doubling' '0.999187843 branch point' '0.999649824 branch point' \
    '0.999867627 period doubling' '0.999942925 period doubling' '0.999978420 branch point' '0.999990695 branch point' > wanted
cmp -s found wanted || fail "the axis: $(diff found wanted)"

# Lorenz's cycle around one wing sinks below z = 19 at rho = 24.07403, far from any bifurcation: its multiplier is 1.0286668 there,
# by the section z = 22.5 too. Where it touches the section the branch ends: down to a part of 2e-5 of the velocity that crosses,
# multipliers err by the residual, 1e-10, over that part at most.
jellett continue lorenz --set rho=20 --section z=19 --start x=10,y=15 --along rho=13:25 -o rows.csv 2> log || fail "touching: $?"
grep -q 'branch 0: no shorter step converges' log || fail "touching: $(cat log)"
awk -F, '/^[0-9]/ && $2 > 24.07402 { n++; if ($17 != "" || ($8 - 1.0286668)^2 > 5e-6^2) wrong = 1 }
    END { exit !(n > 3) || wrong }' rows.csv || fail "a cycle that touches the section: $(tail -3 rows.csv)"
# Lorenz's orbit around one wing comes from a homoclinic one, at rho = 13.926.
jellett continue lorenz --section z=15 --set rho=20 --along rho=13:25 --start x=10,y=15 --decreasing --count 1000 -o rows.csv \
    2> log || fail "homoclinic: $?"
grep -q 'branch 0: .*homoclinic to one' log || fail "homoclinic: $(cat log)"
# It shrinks onto the equilibrium on the wing, and has a multiplier above 1, up to Hopf's bifurcation at rho = 470/19. Turns around
# that equilibrium come back to within their size times what its own multiplier is off 1, and are no orbits.
printf '%s\n' 'model wing' 'param rho' 'state x' 'state y' 'state u "z - (rho - 1)"' 'eq x = 10*y - 10*x' 'eq y = x - y - x*u' \
    'eq u = x*y - 8/3*u - 8/3*rho + 8/3' > wing.tt
jellett continue ./wing.tt --section u=0 --set rho=24 --start x=9.57,y=11.1 --along rho=14:25 -o rows.csv 2> log
grep -q 'branch 0: .*equilibrium onto which orbits shrink' log || fail "Hopf: $(cat log)"
awk -F, '/^0,/ { n++; last = $2; if ($2 > 470/19 + 1e-7 || $15 != "degenerate" && ($10 < 1 || $15 != "saddle")) wrong = 1 }
    END { exit !(n > 40 && last > 470/19 - 1e-5) || wrong }' rows.csv || fail "beyond Hopf's: $(tail -3 rows.csv)"

# Two bifurcations within one step: the edges of the second and the third gap of Mathieu's equation, at its characteristic values
# b2, a2, b3 and a3 for q = 1 (SciPy), where the orbit x = 0 has trace 2, and -2; and the folds of p = x^3 - e x.
cat > mathieu.tt <<'TABLE'
model mathieu
param a
param q
default a = -1, q = 1
state x
state v
state phi
angle C S = cos(phi) sin(phi)
periodic phi = 2*pi
eq x = v
eq v = -(a + 2*q*C)*x - x^3
eq phi = 2
TABLE
cat > cusp.tt <<'TABLE'
model cusp
param p
param e
default p = -1, e = 0
state x
state phi
periodic phi = 2*pi
eq x = p - x^3 + e*x
eq phi = 1
TABLE
# Narrow gaps, down to 4e-4 at a = 25 for q = 2, by default steps: b2, a2, b3, ... from 1 to 28 (SciPy). Not told are those of which
# the trace passes 2 by less than its noise of 1e-9: the fourth and the fifth, of 5e-5 and 4e-7, for q = 0.5.
while read -r q want; do
    jellett continue ./mathieu.tt --section phi=0 --start x=0,v=0 --set a=1,q=$q --along a=0.99:28 -o rows.csv 2> log
    awk -F, '/^0,/ && $17 != "" { printf "%s%.8f", n++ ? " " : "", $2 }' rows.csv > found
    [ "$(cat found)" = "$want" ] || fail "Mathieu, q = $q: $(cat found)"
done << 'GAPS'
0.5 1.46676684 3.97918922 4.10090060 9.01371984 9.01760693
2 2.37919988 3.67223271 5.17266513 9.14062774 9.37032248 16.12768795 16.14120379 25.08334903 25.08377778
5 1.85818754 2.09946045 7.44910974 9.23632771 11.54883204 16.64821994 17.09658168 25.51081605 25.54997175
GAPS
for step in 0.01 0.006; do
    jellett continue ./mathieu.tt --section phi=0 --start x=0,v=0 --along a=-1:12 --step $step -o rows.csv 2> log
    awk -F, '/^0,/ && $17 != "" { printf "%s %.8f;", $17, $2 }' rows.csv > found
    [ "$(cat found)" = "branch point -0.45513860;period doubling -0.11024882;period doubling 1.85910807;branch point 3.91702477;$(
        )branch point 4.37130098;period doubling 9.04773926;period doubling 9.07836885;" ] || fail "Mathieu, $step: $(cat found)"
    for e in 1e-3 1e-4 1e-5; do
        jellett continue ./cusp.tt --section phi=0 --start x=-1 --set e=$e --along p=-1:1 --step $step -o rows.csv 2> log
        awk -F, -v e=$e '/^0,/ && $14 == "fold" { n++; x = sqrt(e/3)*(n == 1 ? -1 : 1); if (($5 - x)^2 > 1e-20) bad = 1 }
            END { exit n != 2 || bad }' rows.csv || fail "cusp, e = $e, $step: $(grep fold rows.csv)"
    done
done

# Orbits that lie on a closed curve, (r - 2)^2 + p^2 = 1, are listed once around, with its two folds.
cat > circle.tt << 'TABLE'
model circle
param p
state phi
state r
periodic phi = 2*pi
eq phi = 1
eq r = ((r - 2)^2 + p^2 - 1)/20
TABLE
jellett continue ./circle.tt --section phi=0 --along p=-2:2 --set p=0 --start r=2.99 --step 0.05 -o rows.csv 2> log ||
    fail "circle: status $?"
grep -q 'branch 0: it closes$' log || fail "circle: $(cat log)"
awk -F, '/^0,/ && $14 == "fold" { folds++; off += ($2 - 1)*($2 - 1)*($2 + 1)*($2 + 1) } /^0,/ { rows++ }
         END { exit !(folds == 2 && off < 1e-16 && rows > 20 && rows < 60) }' rows.csv ||
             fail "circle: $(grep -c '^0,' rows.csv) rows, $(grep fold rows.csv)"

# The orbit theta = p is followed once around, and further: its angle stays in (-pi, pi].
cat > turning.tt << 'TABLE'
model turning
param p
state phi
state theta
angle c s = cos(theta - p) sin(theta - p)
periodic phi = 2*pi
periodic theta = 2*pi
eq phi = 1
eq theta = s/20
TABLE
jellett continue ./turning.tt --section phi=0 --along p=0:7 --set p=0.1 --start theta=0.1 --step 0.1 -o rows.csv 2> log ||
    fail "turning: status $?"
awk -F, '/^0,/ { off = $5 - $2 + ($2 > 3.141592653589793 ? 6.283185307179586 : 0); if (off*off > 1e-20) bad++; last = $2 }
         END { exit bad > 0 || last < 7 - 1e-12 || last > 7 + 1e-12 }' rows.csv ||
             fail "turning: $(grep '^0,' rows.csv | cut -d, -f2,5 | tr '\n' ' ')"

# Where orbits double, and periods and multipliers at the end of the range, at every tolerance against quadruple precision. Periods
# err by the tolerance at most, what depends on derivatives by a hundred times that; doublings are located to 1e-10 of arc.
held() { # END DOUBLING ARGUMENT...: rows of cycles.csv; DOUBLING may be empty
    local end=$1 doubling=$2 tolerance
    shift 2
    for tolerance in 1e-4 1e-6 1e-9 1e-12; do
        jellett continue "$@" --tol $tolerance -o rows.csv 2> log || fail "$end, $tolerance: status $?: $(cat log)"
        awk -F, -v end="$end" -v doubling="$doubling" -v tolerance=$tolerance '
            function off(a, b) { return a > b ? a - b : b - a }
            NR == FNR { if ($1 == end) { T = $3; mu = $4 } if ($1 == doubling) at = $2; next }
            /^0,/ { last = $7; largest = $10 } /^0,.*period doubling/ { found = $2 }
            END { exit !(off(last, T) < tolerance + 1e-13 && off(largest, mu) < 100*tolerance + 1e-10 &&
                  (doubling == "" || off(found, at) < 10*tolerance + 1e-10)) }' "$data/cycles.csv" rows.csv ||
            fail "$end, $tolerance: $(grep -e doubling rows.csv) $(tail -1 rows.csv)"
    done
}
held roessler_c roessler_doubling roessler --section y=0 --set c=2 --along c=2:3.5 --start x=3.753,z=1.354
# What a residual may be relative to the orbit is no less than the tolerance.
for tolerance in 1.5e-4 3e-4; do
    jellett continue roessler --section y=0 --set c=2 --along c=2:3.5 --start x=3.753,z=1.354 --tol $tolerance > out 2> log ||
        fail "Roessler at tolerance $tolerance: $(cat log)"
done
held lorenz_rho '' lorenz --section z=20 --set rho=22 --along rho=16:22 --decreasing --start x=10.29,y=13.36
held top_E top_doubling --along E=1.9:2.15 --decreasing

# From the upper end of the range there is one way to go, and from it no row is outside.
jellett continue --along E=2.1:2.15 -o rows.csv 2> /dev/null
awk -F, '/^[0-9]/ { if ($2 < 2.1 - 1e-12 || $2 > 2.15 + 1e-12) outside++; else rows++;
    last = $2 } END { exit outside > 0 || rows < 3 || last > 2.1 + 1e-12 }' rows.csv ||
    fail "E=2.1:2.15: $(grep '^[0-9]' rows.csv | cut -d, -f2 | tr '\n' ' ')"
! grep -q '^# levels.*E=' rows.csv || fail "the header claims a level that runs: $(grep levels rows.csv)"

# A signal ends a run within a second; whole rows are saved, or what is lost is said.
interrupted() { # SIGNAL MESSAGE COMMAND...
    local signal=$1 message=$2 code=0 begun
    shift 2
    set -m
    "$@" > /dev/null 2> err &
    local child=$!
    set +m
    sleep 1
    begun=$(date +%s%N)
    kill -"$signal" $child
    wait $child 2> /dev/null || code=$?
    [ $code -eq $((128 + $(kill -l "$signal"))) ] || fail "$1 $2: status $code after SIG$signal"
    [ $(($(date +%s%N) - begun)) -lt 1000000000 ] || fail "$1 $2: more than a second after SIG$signal"
    grep -q "$message" err || fail "$1 $2, SIG$signal: $(cat err)"
}
# A parameter that is called as a column is: both columns are told apart.
printf '%s\n' 'model arcs' 'param arc' 'default arc = 0' 'state x' 'state u' 'eq x = u' 'eq u = -x + arc*x^3' > arcs.tt
XDG_CACHE_HOME=$PWD/cache jellett continue ./arcs.tt --section x=0 --start u=0.5 --along arc=0:0.1 > arcs.csv 2> err
grep -q '^branch,along_arc,arc,period,u,' arcs.csv || fail "a parameter 'arc': $(cat err) $(grep branch arcs.csv)"

for signal in INT TERM HUP; do
    interrupted $signal 'interrupted; [0-9]* whole rows' jellett continue --along I3=0.1:0.6 --branches --step 1e-5 \
        --count 1000000 -o long.csv
    [ "$(grep -c '^[0-9]' long.csv)" -eq "$(sed -n 's/.*interrupted; \([0-9]*\) whole rows.*/\1/p' err)" ] || fail "saved rows"
done
interrupted TERM 'interrupted; the first [0-9]* of 900000 rows are saved' jellett eigen --set a3=0 --at v_nu=0.7,omega3=1.1 \
    --sweep gamma3=-0.9:0.9:900000
# Proofs end at once, samples after the one in hand.
interrupted TERM 'interrupted; \(nothing is reported\|what was not saved by now is lost\)' jellett verify spherical_top \
    --samples 10000000

# Multipliers exp(2 pi mu) exp(+-2 pi i w): where both cross 1 or -1 together that is told; where they cross apart it is a torus.
printf '%s\n' 'model pair' 'param mu' 'param w' 'default mu = -0.1, w = 1/2' 'state a' 'state b' 'state ph' \
    'let q = mu - a^2 - b^2' 'eq a = q*a - w*b' 'eq b = q*b + w*a' 'eq ph = 1' 'periodic ph = 2*pi' > pair.tt
export XDG_CACHE_HOME=$scratch/cache
for w in 1/2 1 2 3; do
    jellett continue ./pair.tt --section ph=0 --along mu=-0.3:0.2 --start a=0,b=0 --set w=$w -o rows.csv 2> log
    grep -q 'stability changes, from 0 multipliers outside the unit circle to 2' log ||
        fail "two multipliers together, w = $w: $(cat log)"
done
jellett continue ./pair.tt --section ph=0 --along mu=-0.3:0.2 --start a=0,b=0 --set w=0.37 -o rows.csv 2> log
grep -q 'stability changes' log && fail "a torus is told twice: $(cat log)"
awk -F, '/torus/ { found = $2^2 < 1e-16 } END { exit !found }' rows.csv || fail "no torus at mu = 0: $(grep torus rows.csv)"
# A torus that a long step leaves far outside the unit circle, with a trace beyond 2. Where multipliers are real it is none.
for w in 0.123 0.3333 0.499 1.4; do
    for way in - ''; do
        jellett continue ./pair.tt --section ph=0 --along mu=-1:1 --set mu=${way}0.95,w=$w --start a=0,b=0 --step 0.05 \
            $([ -n "$way" ] || echo --decreasing) -o rows.csv 2> log
        awk -F, '$17 == "torus" && $2^2 < 1e-20 && $18 < 1e-10 && $19 > -1e-10 { n++ } END { exit n != 1 }' rows.csv ||
            fail "a torus in a long step, $w $way: $(cat log)"
    done
done
sed -e 's/model pair/model real/' -e 's/+ w\*a/- w*a/' pair.tt > real.tt
jellett continue ./real.tt --section ph=0 --along mu=-0.3:0.2 --start a=0,b=0 --set w=0.2 -o rows.csv 2> log
! grep -q torus rows.csv || fail "a saddle of determinant 1: $(grep torus rows.csv)"

# Multipliers of some -1e3 and 1e3: folds and doublings are passed, down to where the range ends. The same orbits come, to the last
# digit, where the parameter counts in other units.
printf '%s\n' 'model swing' 'param q' 'state x' 'state v' 'state phi' 'angle c s = cos(phi) sin(phi)' 'eq x = v' \
    'eq v = x - q*c*x + s - x^3/1000' 'eq phi = 1' 'periodic phi = 2*pi' > swing.tt
sed -e 's/model swing/model small/' -e 's/q\*c/q*c\/1024/' swing.tt > small.tt
how=(--section phi=0 --start x=0,v=-0.5 --step 0.1 --count 600)
jellett continue ./swing.tt "${how[@]}" --set q=0.1 --along q=0.1:90 -o rows.csv 2> log
tail -1 log | grep -q 'the range ends' || fail "large multipliers: $(cat log)"
awk -F, '/^0,/ && $16 > 1e-10 { print "residual " $16 " at " $2 } /^0,/ && $10*$10 > 1e5 { large++ }
    END { if (large < 3) print "no multiplier is large" }' rows.csv > wrong
[ ! -s wrong ] || fail "large multipliers: $(head -3 wrong)"
jellett continue ./small.tt "${how[@]}" --set q=102.4 --along q=102.4:92160 -o small.csv 2> log
cmp -s <(grep '^0,' rows.csv | cut -d, -f1,3-17) <(grep '^0,' small.csv | cut -d, -f1,3-17) ||
    fail "in other units other orbits come"
# Where the forced pendulum's symmetric orbit, of period 3 pi, loses its symmetry, no steps converge nearer than 4e-5. Oracle:
# DOP853 of scipy at 1e-13, where half a period, followed by (x, v) -> (-x, -v), is a map with the multiplier -1.
printf '%s\n' 'model pushed' 'param A' 'default A = 9/10' 'state x' 'state v' 'state p' 'angle c s = cos(p) sin(p)' \
    'angle cx sx = cos(x) sin(x)' 'eq x = v' 'eq v = - sx - v/2 + A*c' 'eq p = 2/3' 'periodic p = 2*pi' \
    'periodic x = 2*pi' > pushed.tt
jellett continue ./pushed.tt --section p=0 --start x=-0.4,v=0.6 --along A=0.8:1.07 -o rows.csv 2> log
awk -F, '$17 == "branch point" { found++; bad += ($2 - 1.00431947743)^2 > 1e-16 || $16 > 1e-10 || $18 > $2 || $19 < $2 }
    END { exit !(found == 1 && !bad) }' rows.csv || fail "a loss of symmetry: $(grep point rows.csv)"
# The orbits without symmetry, which turn there, cross the others at 0.2 rad: steps arrive on these.
jellett continue ./pushed.tt --section p=0 --set A=1.15 --start x=-0.0618509562,v=1.8809538871 --along A=0.9:1.3 --decreasing \
    -o rows.csv 2> log
awk -F, '/^0,/ && $17 ~ /point|fold/ { found++; bad += $17 != "branch point" || ($2 - 1.00431947743)^2 > 1e-20 }
    END { exit !(found == 1 && !bad) }' rows.csv || fail "back to symmetry: $(grep 'point\|fold' rows.csv)"
# The same of Duffing's oscillator, whose branches cross more steeply, by the same oracle.
printf '%s\n' 'model duffing' 'param A' 'default A = 3' 'state x' 'state v' 'state p' 'angle c s = cos(p) sin(p)' \
    'periodic p = 2*pi' 'eq x = v' 'eq v = - x/5 - v/10 - x^3 + A*c' 'eq p = 1' > duffing.tt
for step in 0.01 0.03; do
    jellett continue ./duffing.tt --section p=0 --set A=8 --start x=2.4062557,v=-0.4751984 --along A=1:12 --decreasing \
        --step $step -o rows.csv 2> log
    awk -F, '/^0,/ && $17 ~ /point|fold/ && $2 < 3 { found++; bad += $17 != "branch point" || ($2 - 2.33552445379)^2 > 1e-15 }
        END { exit !(found == 1 && !bad) }' rows.csv || fail "duffing, step $step: $(grep 'point\|fold' rows.csv)"
done
# Places have room for the largest sections, and are kept off the stack: half of the usual 8 MiB suffices.
(ulimit -s 4096 && jellett continue --along E=1.9:2.15 > rows.csv 2> log) || fail "with a stack of 4 MiB: status $?, $(cat log)"
# A branch that leaves the range ends on it, not beyond it by rounding.
for range in E=2.1:2.3 "E=2.1:2.3 --decreasing" a3=0.45:0.53 "E=2.1:2.3$(printf '0%.0s' {1..300})"; do
    jellett continue --along $range 2> log | tail -1 | cut -d, -f2 > end
    grep -qx '2.3\|2.1\|0.53' end || fail "the end of $range: $(cat end)"
done
# A multiplier stays in its column, also where all are of modulus 1: there the energy's is the first.
jellett continue restricted_three_body --section y=0 --set mu=0.01 --start x=0.4,vx=0,vy=0.9 --along mu=0.001:0.2 > rows.csv 2> log
awk -F, '/^branch/ { for (i = 1; i <= NF; i++) at[$i] = i } /^[0-9]/ { n++; bad += $at["mu1_im"] != 0 || !($at["mu2_im"] > 0) ||
    !($at["mu3_im"] < 0) } END { exit !(n > 5 && !bad) }' rows.csv || fail "multipliers change columns: $(cat rows.csv log)"

# A branch that begins at the period doubling just before the end of the range, beyond which steps lead, stays in it, to its end.
for low in 1.9804 1.980479; do
    jellett continue --along E=$low:2.15 --branches -o rows.csv 2> log || fail "to $low: status $?"
    awk -F, -v low=$low '/^1,/ { n++; bad += $2 < low - 1e-12 || $2 > 1.98047908; last = $2 }
        END { exit !(n > 1 && !bad && last < low + 1e-10) }' rows.csv || fail "to $low: $(grep ^1, rows.csv | cut -d, -f2; cat log)"
done
[ $failures = 0 ] || exit 1
echo "bifurcations are the same at all steps"
