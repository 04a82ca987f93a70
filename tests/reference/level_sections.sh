#!/usr/bin/env bash
# Sections on levels of a table's own integrals: Newton's method meets the levels, the rest is that of the plain section, and what
# is no integral, no state or no branch is refused by name.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
cp "$JLT_SOURCE_DIR"/tests/reference/data/{henon_heiles,suslov}.tt .

# At E = 1/12 and x = 0: px = sqrt(1/6 - y^2 - py^2 + 2 y^3/3). Rows are those of the plain section from there: ten returns err by
# about the tolerance of 1e-12, four of this regular orbit by less.
level=(--section x=0 --level E=1/12 --solve px=0.3)
expect 0 '^# levels E=0.0833333333333333[0-9]*; solved for px from 0.3$' \
    jellett section ./henon_heiles.tt "${level[@]}" --start y=0.1,py=0.05 --returns 4 --check
grep -v '^#' out > on_level
px=$(awk 'BEGIN { y = 0.1; py = 0.05; printf "%.17g", sqrt(1/6 - y^2 - py^2 + 2*y^3/3) }')
expect 0 alive jellett section ./henon_heiles.tt --section x=0 --start y=0.1,py=0.05,px="$px" --returns 4
grep -v '^#' out > plain
paste -d , on_level plain | awk -F, '
    NR == 1 { for (i = 12; i <= NF; i++) at[$i] = i; bad = !($4 == "y" && $5 == "py" && $6 == "px"); next }
    { rows++; bad += ($4 - $at["y"])^2 + ($5 - $at["py"])^2 + ($6 - $at["px"])^2 > 1e-22 }
    END { exit !(rows == 5 && !bad) }' || fail "on the level rows differ: $(paste on_level plain)"
# The same section as the tables describe it, whose lift is that formula: the same rows, to ten roundings of the start stretched by
# DP.
cp "$JLT_SOURCE_DIR"/tools/docs/henon{,_section}.tt .
sed -i 's/^state \(p*y\) .*/state \1/' henon_section.tt
expect 0 '^# levels H=0.0833333333333333[0-9]*$' jellett section ./henon.tt --level H=1/12 --start y=0.1,py=0.05 --returns 4 --check
grep -v '^#' out > described
paste -d , on_level described | awk -F, '
    NR == 1 { half = NF/2; next }
    { rows++; for (i = 3; i <= 6; i++) bad += ($i - $(half + i))^2 > 1e-22 }
    END { exit !(rows == 5 && !bad) }' || fail "the described section has other rows: $(paste on_level described)"
expect 3 'crossings in this --direction lie on the other half' jellett section ./henon.tt --start y=0.1,py=0.05 \
    --direction both
expect 3 'no state has the levels asked for' jellett section ./henon.tt --level H=-1 --start y=0.1,py=0.05
expect 3 'no state has the levels asked for' jellett section ./henon.tt --start y=0.9,py=0
cat > described.scene <<'SCENE'
model = "./henon.tt";
levels = { H = "1/12"; };
compute = ( { what = "section"; section = "crossing"; start = { y = 0.1; py = 0.05; }; returns = 4; output = "scene.csv"; } );
SCENE
jellett run described.scene 2> err < /dev/null || fail "the scene: $(cat err)"
grep -v '^#' scene.csv | cmp - <(cut -d, -f1-7 described) || fail "the scene has other rows"
expect 2 "'nope' is no section" jellett section ./henon.tt --section nope --start y=0.1,py=0.05
expect 3 'py has no range' jellett section ./henon.tt --grid y=-0.3:0.3:3
expect 0 'crossing +x = 0 in y, py on levels H = 0.125$' jellett models ./henon.tt
sed -i 's/px = px/px = -px/' henon_section.tt # the lift goes to the other half
expect 0 ',-0.48[0-9]*,alive$' jellett section ./henon.tt --start y=0.1,py=0.05 --direction down --returns 1
expect 3 'crossings in this --direction lie on the other half' jellett section ./henon.tt --start y=0.1,py=0.05
sed -i 's/py = py$/py = 2*py/' henon_section.tt # and is on other levels
expect 3 'section crossing is not proved of this table: ' jellett section ./henon.tt --start y=0.1,py=0.05 --direction down

# The flow keeps volume, so the map keeps area: DP in (y, py) has determinant 1, which --check holds its own against.
awk -F, 'NR > 2 { n++; bad += ($9 - 1)^2 > 1e-20 } END { exit !(n == 4 && !bad) }' on_level ||
    fail "det DP is not 1: $(cat on_level)"

# The orbits of one level, not a family in E: multipliers of the two coordinates alone. Those with x <-> -x on either side of y have
# one period, and every multiplier comes with its inverse.
expect 0 '^1,.*centre' jellett orbits ./henon_heiles.tt "${level[@]}" --mirror x,py --grid y=-0.3:0.4:5,py=-0.3:0.3:5 --period 1
awk -F, '/^1,/ { n++; bad += ($6 - 1)^2 > 1e-18; T[n] = $4 } END { exit !(n >= 5 && !bad && (T[1] - T[2])^2 < 1e-20) }' out ||
    fail "periodic orbits: $(cat out)"
expect 0 '^64,' jellett lyapunov ./henon_heiles.tt "${level[@]}" --start y=0.1,py=0.05 --returns 64
awk -F, '/^64,/ { good = NF == 5 && ($3 + $4)^2 < 1e-18 } END { exit !good }' out || fail "exponents of a level: $(tail -1 out)"

# A sweep over a level follows at each value the orbits that --level follows there.
fates=(jellett fates ./henon_heiles.tt --section x=0 --solve px=1 --grid y=0:0.2:3,py=0:0.1:2)
expect 0 '^0' "${fates[@]}" --sweep E=1/12:1/6:2 --returns 20
cut -d, -f1,2,5 out | grep '^0' > swept
for e in 1/12 1/6; do
    "${fates[@]}" --level E=$e --returns 20 2> err |
        awk -F, '/alive/ { n++ } END { print n }'
done > alive
cut -d, -f3 swept | diff - alive > /dev/null || fail "a sweep over E: $(cat out) beside $(cat alive)"
expect 3 "there is no 'L'; there are the parameters .none." "${fates[@]}" --sweep L=1:2:2

# Two levels of a nonholonomic table, where one is the length of a unit vector: rows keep both. Four returns err by the tolerance.
two=(--section gamma1=0 --level E=2,gamma=1 --solve omega1=1,gamma3=0.9)
expect 0 alive jellett section ./suslov.tt "${two[@]}" --start omega2=0.3,gamma2=0.2 --returns 4 --direction both
awk -F, '/^[0-9]/ { n++; bad += (($5^2 + $7^2) - 1)^2 + (($6^2 + 2*$4^2)/2 + $7 - 2)^2 > 1e-22 }
    END { exit !(n == 5 && !bad) }' out ||
    fail "off the levels: $(cat out)"

# After every step back onto the levels, a thousand returns at a loose tolerance drift no more than a step errs.
drift() { jellett section ./henon_heiles.tt --section x=0 --start y=0.1,py=0.05,px="$px" --returns 300 --tol 1e-6 --method rk8pd \
    "$@" |
    awk -F, '$2 == 300 { y = $4; px = $5; py = $6; e = (px^2 + py^2 + y^2)/2 - y^3/3 - 1/12; printf "%.3g", e < 0 ? -e : e }'; }
loose=$(drift) projected=$(drift --project)
awk -v a="$loose" -v b="$projected" 'BEGIN { exit !(b < 1e-9 && a > 20*b) }' ||
    fail "--project: drift $projected, without it $loose"

# So does an orbit that its lane leaves to the flow's own method, as where y falls to 1e-9 in a step, or nearly so, but for what the
# lane has drifted before. All orbits of prey and predators are closed, and on x = 1 the level says where y is.
printf '%s\n' 'model prey' 'state x in (0, inf)' 'state y in (0, inf)' 'log X = log(x)' 'log Y = log(y)' 'eq x = x - x*y' \
    'eq y = 3/10*x*y - y' 'integral V = 3/10*x - X + y - Y' > prey.tt
off() { jellett section ./prey.tt --section x=1 --grid y=1e-9:1e-9:1 --returns 300 --tol 1e-7 "$@" |
    awk -F, '/^0,300,/ { e = $4/1e-9 - 1; printf "%.3g", e < 0 ? -e : e }'; }
loose=$(off) projected=$(off --project)
awk -v a="$loose" -v b="$projected" 'BEGIN { exit !(b < a/300) }' ||
    fail "--project of an orbit that leaves its lane: off by $projected, without it by $loose"

# What stays 0, or is small and keeps its sign, alone or with others, is not moved to put an orbit back: from 1e-13 it would grow as
# exp(t/20). Beside it q and p turn, 40 times, so that z from 1e-20 ends at 1e-20 exp(4 pi), with errors of a pair, 64 tolerances a
# step, in some 1500 steps.
printf '%s\n' 'model one' 'state q' 'state p' 'state z' 'eq q = p' 'eq p = -q - z*(1 + p/10)' 'eq z = z*(p + p^2/10)' \
    'integral E = (q^2 + p^2)/2 + z' > one.tt
printf '%s\n' 'model two' 'state q' 'state p' 'state z' 'state v' 'state s' 'eq q = p' 'eq p = -q' 'eq z = z/20 - 3*v' \
    'eq v = v/20 + 3*z' 'eq s = 3*v - z/20' 'integral E = (q^2 + p^2)/2 + s + z' > two.tt
for table in one two,v=0,s=1; do
    for how in "" "--method gauss" "--method rkf45"; do
        for z in 0 1e-20; do
            jellett section ./${table%%,*}.tt --section q=0 --grid p=1,z=$z${table#???} --returns 40 --tol 1e-8 --project $how \
                > out 2> err
            awk -F, -v z=$z '/^0,40,/ { n++; grown = z*exp(4*3.141592653589793); bad = !(($5 - grown)^2 <= (1e-3*grown)^2) }
                END { exit bad || !n }' out || fail "$table from z = $z is put back elsewhere, $how: $(tail -1 out) $(cat err)"
        done
    done
done

# Lanes put orbits back onto the relation of the lifted root that the table says, whatever the order of its states.
mkdir turned && cp "$JLT_SOURCE_DIR"/codegen/models/spherical_top*.tt turned
awk '/^state gamma3/ { held = $0; next } { print } /^state v_nu/ { print held }' \
    "$JLT_SOURCE_DIR/codegen/models/spherical_top_level.tt" > turned/spherical_top_level.tt
grid=(--grid eta=0.40:0.48:3,gamma3=-0.635:-0.605:3 --returns 10 --project)
(cd turned && jellett section ./spherical_top_level.tt "${grid[@]}" -o rows.csv 2> log) ||
    fail "states in another order: $(cat turned/log)"
jellett section spherical_top_level "${grid[@]}" -o rows.csv 2> log || fail "--project: $(cat log)"
paste -d, rows.csv turned/rows.csv |
    awk -F, '/^[0-9]/ { n++; bad += ($4 - $13)^2 + ($5 - $14)^2 > 1e-20 || $9 != $18 } END { exit !(n == 99 && !bad) }' ||
    fail "states in another order are put back elsewhere: $(tail -1 rows.csv) $(tail -1 turned/rows.csv)"

# Refused by name.
section=(jellett section ./henon_heiles.tt --section x=0 --start y=0.1,py=0)
expect 3 "henon_heiles claims no integral 'L'; it has E" "${section[@]}" --level L=1 --solve px=1
expect 2 "each level needs a state to solve for; levels: 1, states that --solve names: 0" "${section[@]}" --level E=1/12
expect 2 "each level needs a state to solve for; levels: 0, states that --solve names: 1" "${section[@]}" --solve px=1
expect 4 "is crossed the other way: try --direction down" jellett orbits lorenz --section z=20 --set rho=22 --start x=7,y=5
expect 3 "has no state 'p'" "${section[@]}" --level E=1/12 --solve p=1
expect 3 "x is fixed by --section already" "${section[@]}" --level E=1/12 --solve x=1
expect 4 "Newton's method finds no state with these levels there: try another guess in --solve" "${section[@]}" --level E=-1 \
    --solve px=1
expect 4 "Newton's method finds no state with these levels" "${section[@]}" --level E=1/12 --solve px=0
expect 4 "an iteration did not converge" jellett lyapunov ./henon_heiles.tt "${level[@]}" --direction down --start y=0.1,py=0 \
    --returns 3
expect 0 "^0,1," "${section[@]}" --level E=1/12 --solve px=-1 --returns 1
awk -F, '/^0,0,/ { exit !($6 < 0) }' out || fail "the guess's sign does not choose the branch: $(cat out)"
expect 0 "at 1 point of the grid there is no state" jellett section ./henon_heiles.tt "${level[@]}" --grid y=0:2:5,py=0 --returns 1
expect 2 "--project: roessler has no integrals" jellett section roessler --section y=0 --start x=-7,z=0.02 --project
expect 2 "--project cannot be used with the multistep method msadams" \
    jellett section ./henon_heiles.tt --section x=0 --start y=0.1,py=0,px=1 --project --method msadams
# On the other branch of the level DP is not known: a check that checks nothing does not pass.
expect 1 "DP could not be computed at 3 of 3 returns" jellett section ./henon_heiles.tt --section x=0 --level E=1/12 \
    --solve px=0.3 \
    --start y=0.1,py=0 --returns 3 --check --direction both

# On the fold of a level, where the state that is solved for is 0, there is no derivative and nothing to compare.
printf 'model kepler\nstate r in (0, inf)\nstate f\nstate p\nstate L\neq r = p\neq f = L/r^2\neq p =\n    + L^2/r^3\n'\
'    - 1/r^2\neq L = 0*L\n' > kepler.tt
printf 'periodic f = 2*pi\nintegral E = p^2/2 + L^2/(2*r^2) - 1/r\n' >> kepler.tt
expect 1 'DP could not be computed at 3 of 3 returns' jellett section ./kepler.tt --section f=0 --start r=1,L=1.2 --returns 3 \
    --level E=-0.28 --solve p=0 --check
grep -qE 'inf|nan' out err && fail "numbers that are none: $(cat err)"

# Friction: what was an integral is none any more.
sed -e 's/^    - y$/&\n    - py\/100/' henon_heiles.tt > friction.tt
expect 3 "E is no integral of this table" jellett section ./friction.tt --section x=0 --start y=0.1,py=0 --level E=1/12 --solve px=1
expect 3 "E is not proved to be an integral" jellett section ./friction.tt --section x=0 --start y=0.1,py=0,px=1 --project

# Levels are met, and returns found, in whatever units they are: an electron's, with u = sqrt(2 m (E + k/x) - v^2) and v = L/x where
# y = 0. Returns of a closed orbit are its start, to a hundred tolerances.
atom() { # LABEL...: the units of m, k, x, p
    printf '%s\n' 'model atom' "param m > 0 $1" "param k > 0 $2" 'default m = 9.1e-31, k = 2.3e-28' "state x $3" "state y $3" \
        "state u $4" "state v $4" 'domain away : x^2 + y^2 > 0' 'root r = sqrt(x^2 + y^2)' 'eq x = u/m' 'eq y = v/m' \
        'eq u = -k*x/r^3' 'eq v = -k*y/r^3' 'integral E = (u^2 + v^2)/(2*m) - k/r' 'integral L = x*v - y*u' > atom.tt
    expect 0 '^0,2,' jellett section ./atom.tt --section y=0 --level E=-1.8e-18,L=1e-34 --solve u=5e-25,v=2e-24 --start x=5e-11 \
        --returns 2
    awk -F, '/^0,/ { rows++; u = sqrt(2*9.1e-31*(-1.8e-18 + 2.3e-28/5e-11) - (1e-34/5e-11)^2)
        bad += ($4/5e-11 - 1)^2 + ($5/u - 1)^2 + ($6/(1e-34/5e-11) - 1)^2 > 1e-20 } END { exit !(rows == 3 && !bad) }' out ||
        fail "an electron: $(cat out)"
}
atom '' '' '' ''
atom '[kg]' '[kg*m^3/s^2]' '[m]' '[kg*m/s]'

# Levels that leave a freedom to the states they are to determine: one follows from the others, or a state is in none.
undetermined='the levels do not determine the states of --solve'
sed 's/^integral E = \(.*\)/&\nintegral E2 = (\1)^2/' henon_heiles.tt > squared.tt
for command in 'section --returns 1' 'orbits --period 1' 'lyapunov --returns 1'; do
    expect 3 "$undetermined" jellett ${command% --*} ./squared.tt --section x=0 --level E=1/8,E2=1/64 --solve px=0.4,py=0.1 \
        --start y=0.1 --${command##* --}
done
printf '%s\n' 'model apart' 'state x' 'state p' 'state y' 'state q' 'eq x = p' 'eq p = -x' 'eq y = q' 'eq q = -2*y' \
    'integral E = x^2 + p^2' 'integral F = 2*y^2 + q^2' > apart.tt
expect 3 "$undetermined" jellett section ./apart.tt --section x=0 --level E=1 --solve q=0.3 --start p=1,y=0 --returns 1
expect 3 "$undetermined" jellett section ./apart.tt --section x=0 --level E=1,F=1 --solve y=0.3,q=0.3 --start p=1 --returns 1
expect 0 '^0,1,' jellett section ./apart.tt --section x=0 --level E=1,F=1 --solve p=0.3,q=0.3 --start y=0.1 --returns 1
# Levels that no start of a grid has are refused before anything is written.
for command in section fates; do
    expect 4 'no state with these levels' jellett $command ./apart.tt --section x=0 --level E=-1 --solve p=0.3 \
        --grid y=0:1:2,q=0:1:2
    [ ! -s out ] || fail "$command writes a header first: $(cat out)"
done
# An integral that grows with the phase is another one a turn later, so that nothing closes on its level; unless the state that is
# solved for is an angle, which has turned, too. Then an oscillator driven at phase p has one orbit, q = Im(A exp(ip)).
turning() { # RATE [PERIOD]
    printf '%s\n' 'model turning' 'state q' 'state z' 'state p' 'state f' 'angle c s = cos(p) sin(p)' 'eq q = z' \
        'eq z = s/10 - q/3 - z/10' "eq p = $1" 'eq f = 1' "integral I = p - $1*f" 'periodic f = 2*pi' ${2:+"periodic p = $2"} \
        > turning.tt
    level=(./turning.tt --section f=0 --level I=0.3 --solve p=0 --start q=0.3,z=0)
}
for system in 2 '7/5 2*pi'; do
    # shellcheck disable=SC2086
    turning $system
    expect 4 'finds no periodic orbit' jellett orbits "${level[@]}" --period 1
    expect 4 'grows with an angle' jellett lyapunov "${level[@]}" --returns 3
    expect 1 'DP could not be computed at 3 of 3 returns' jellett section "${level[@]}" --returns 3 --check
done
turning 2 '2*pi'
expect 0 '^1,.*,attracting,' jellett orbits "${level[@]}" --period 1
awk -F, '/^1,/ { a = 1/3 - 4; b = 0.2; c = cos(0.3)/10/(a^2 + b^2); s = sin(0.3)/10/(a^2 + b^2)
    good = ($2 - (a*s - b*c))^2 + ($3 - 2*(a*c + b*s))^2 < 1e-26 } END { exit !good }' out || fail "turning: $(tail -1 out)"
expect 0 'at most .* of its bound' jellett section "${level[@]}" --returns 3 --check
grep -q 'could not' err && fail "turning: $(cat err)"
# On level 0 of v - sin p all terms vanish at p = 0, where v is 0 but for rounding: that is no other level. Driven by v, x is
# (a sin p - cos p)/(1 + a^2) with a = 1/3, so that x = -0.9 at p = 0, with the multiplier exp(-2 pi/3).
printf '%s\n' 'model vanishing' 'state p' 'state x' 'state v' 'angle c s = cos(p) sin(p)' 'eq p = 1' 'eq x = v - x/3' 'eq v = c' \
    'integral F = v - s' 'periodic p = 2*pi' > vanishing.tt
level=(./vanishing.tt --section p=0 --level F=0 --solve v=0 --start x=0.1)
expect 0 '^1,-0[.](9|8999999999999[0-9]*),6[.]28318530717[0-9]*,0[.]12314471107[0-9]*,' jellett orbits "${level[@]}" --period 1
expect 0 '^3,18[.]84955592153[0-9]*,-0[.]3333333333333[0-9]*,' jellett lyapunov "${level[@]}" --returns 3
for tolerance in 1e-4 1e-8 1e-12; do
    expect 0 'at most .* of its bound' jellett section "${level[@]}" --returns 9 --check --method dop853 --tol $tolerance
    grep -q 'could not' err && fail "vanishing at $tolerance: $(cat err)"
done
exit $status
