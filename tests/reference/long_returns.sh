#!/usr/bin/env bash
# Exponents of returns that stretch or contract by more than numbers resolve: the sum of all is known from flux and divergence, and
# what is not known is left out, and told.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
# u' = v, v' = u once a period of 20 pi: exponents 1 and -1, from vectors that are not the eigenvectors, whose growth is exp(t)/2.
# After n returns the first is 1 - log(2)/(20 pi n) or a little more; z' = -z/2 makes a third.
cat > saddle.tt <<'TABLE'
model saddle
state u
state v
state phi
angle c s = cos(phi) sin(phi)
eq u = v
eq v = u + 0*c
eq phi = 1/10
periodic phi = 2*pi
TABLE
sed -e 's/^state phi/state z\nstate phi/' -e 's/^eq phi/eq z = -z\/2\neq phi/' saddle.tt > three.tt
jellett lyapunov ./saddle.tt --section phi=0 --start u=0,v=0 --returns 100 > out 2> err < /dev/null || fail "saddle: $(cat err)"
awk -F, '/^[0-9]/ { n++; bad += ($3 + $4)^2 > 1e-24 || !($3 < 1 + 1e-12 && $3 > 1 - 0.7/$2) || $5^2 > 1e-24 } END { exit !(n > 20 &&
    !bad) }' out ||
    fail "exponents of the saddle: $(tail -1 out)"
[ -s err ] && grep -q resolves err && fail "of two exponents that stretch none is lost: $(cat err)"
jellett lyapunov ./three.tt --section phi=0 --start u=0,v=0,z=0 --returns 9 > out 2> err < /dev/null || fail "three: $(cat err)"
awk -F, '/^9,/ { exit !(($6 + 0.5)^2 < 1e-24 && $3 > 0.998 && $4 $5 == "") }' out || fail "three exponents: $(tail -1 out)"
grep -q '9 of 9 returns contract some directions by more than the tolerance' err || fail "nothing is told of it: $(cat err)"
# Met ten times as often nothing is lost.
sed -i 's/^eq phi = 1.10/eq phi = 1/' three.tt
jellett lyapunov ./three.tt --section phi=0 --start u=0,v=0,z=0 --returns 90 > out 2> err < /dev/null || fail "three: $(cat err)"
# From a frame that favours no axis: what a vector has of each direction, a tenth or more, is over t as much in the exponents.
awk -F, '/^90,/ { e = 3/$2; sum = $3 + $4 + $5
    exit !(($3 - 1)^2 < e*e && ($4 + 0.5)^2 < e*e && ($5 + 1)^2 < e*e && (sum + 0.5)^2 < 1e-24) }' out ||
    fail "three exponents: $(tail -1 out)"
[ -s err ] && grep -q resolves err && fail "nothing is lost there: $(cat err)"

# Two directions that contract by e^-20 pi and e^-30 pi: neither is known, but for their sum; of one alone it is known.
printf '%s\n' 'model sink' 'state u' 'state v' 'state phi' 'eq u = -u + v/3' 'eq v = -3*v/2' 'eq phi = 1/10' \
    'periodic phi = 2*pi' > sink.tt
jellett lyapunov ./sink.tt --section phi=0 --start u=0,v=0 --returns 9 > out 2> err < /dev/null || fail "sink: $(cat err)"
awk -F, '/^9,/ { exit !($3 $4 == "" && ($5 + 2.5)^2 < 1e-24) }' out || fail "exponents of the sink: $(tail -1 out)"
grep -q '9 of 9 returns contract' err || fail "nothing is told of the sink: $(cat err)"
jellett lyapunov ./sink.tt --section phi=0 --grid u=-1:1:2,v=0:1:2 --returns 2 > out 2> err < /dev/null || fail "chart: $(cat err)"
awk -F, '/^[-0-9]/ { n++; bad += $3 != "" } END { exit !(n == 4 && !bad) }' out || fail "chart of the sink: $(tail -1 out)"
grep -q 'of 4 starts contract' err || fail "nothing is told of the chart: $(cat err)"
sed -i 's/^eq phi = 1.10/eq phi = 1/' sink.tt
jellett lyapunov ./sink.tt --section phi=0 --start u=0,v=0 --returns 90 > out 2> err < /dev/null || fail "sink: $(cat err)"
awk -F, '/^90,/ { exit !(($3 + 1)^2 < 1e-4 && ($3 + $4 + 2.5)^2 < 1e-24) }' out || fail "exponents of the sink: $(tail -1 out)"
# Beside a state of its own, in a plane that is never left: the largest comes first all the same.
printf '%s\n' 'model apart' 'state u' 'state v' 'state phi' 'eq u = -u' 'eq v = v/10' 'eq phi = 1' 'periodic phi = 2*pi' > apart.tt
jellett lyapunov ./apart.tt --section phi=0 --start u=0,v=0 --returns 100 > out 2> err < /dev/null || fail "apart: $(cat err)"
awk -F, '/^100,/ { e = 3/$2; exit !(($3 - 0.1)^2 < e*e && ($4 + 1)^2 < e*e) }' out || fail "exponents apart: $(tail -1 out)"
printf '%s\n' 'model one' 'state u' 'state phi' 'eq u = -u' 'eq phi = 1/10' 'periodic phi = 2*pi' > one.tt
jellett lyapunov ./one.tt --section phi=0 --start u=0 --returns 9 > out 2> err < /dev/null || fail "one: $(cat err)"
awk -F, '/^9,/ { exit !(($3 + 1)^2 < 1e-24) }' out || fail "the one exponent: $(tail -1 out)"

# The section x = 0 is met after turns about a wing, and what DP does across the attractor is rounding, which may be 0. The sum is
# that of the divergence and the flux at both ends, 10|y| within a factor of 100, over the time.
jellett lyapunov lorenz --section x=0 --start y=1,z=20 --skip 20 --returns 200 > out 2> err || fail "x = 0: $(cat err)"
tail -1 out | awk -F, '{ off = ($3 + $4 - $5)*$2; exit !($4 != "" && off*off < log(100)^2) }' || fail "x = 0: $(tail -1 out)"

# No number is as small as exp(-240 pi), and what rests on it is told to be left out.
printf '%s\n' 'model steep' 'state x' 'state y' 'state phi' 'eq x = x/10' 'eq y = -120*y' 'eq phi = 1' 'periodic phi = 2*pi' \
    > steep.tt
jellett lyapunov ./steep.tt --section phi=0 --start x=0,y=0 --returns 9 > out 2> err || fail "steep: $(cat err)"
grep -q '9 of 9 returns contract' err || fail "nothing is told of what is below all numbers: $(tail -1 out; cat err)"

# Coordinates of the size 1e-9 beside those of the size 1 are no contraction. Two coupled oscillators keep a quadratic form, whose
# square root is a length within 64 of the one that sizes of coordinates give: exponents are 0, within log(64^2) over the time.
printf '%s\n' 'model small' 'state x' 'state y' 'state u' 'state v' 'eq x = u' 'eq y = v' 'eq u = -x - 5e-10*y' \
    'eq v = -y - 5e8*x' > small.tt
jellett lyapunov ./small.tt --section x=0 --start y=0.1,u=1e-9,v=0 --returns 100 > out 2> err || fail "small: $(cat err)"
tail -1 out | awk -F, '{ for (i = 3; i <= 6; i++) bad += $i == "" || $i*$2 > log(4096) || $i*$2 < -log(4096); exit bad > 0 }' ||
    fail "exponents of small states: $(tail -1 out)"
jellett lyapunov ./small.tt --section x=0 --grid y=0.1:0.2:2,u=1e-9,v=0 --returns 9 > out 2> err || fail "small: $(cat err)"
awk -F, '/^[0-9]/ { n++; bad += $4 == "" || $4*$5 > log(4096) || $4*$5 < 0 } END { exit !(n == 2 && !bad) }' out ||
    fail "chart of small states: $(tail -2 out)"
# A chart knows how far many returns stretch and contract, beyond the largest number and the smallest: the norm of DP^n is exp(t)
# of the saddle, exp(-t/10) where u' = -u/10, v' = -v/10. A return's DP is right to some tolerances, 1e-12, over 63 of time.
for rate in 1 -0.1; do
    [ $rate = 1 ] && cp saddle.tt even.tt || sed 's|^eq u.*|eq u = -u/10|; s|^eq v.*|eq v = -v/10|' saddle.tt > even.tt
    for how in "" "--method gauss"; do
        jellett lyapunov ./even.tt --section phi=0 --grid u=0,v=0 --returns 200 $how > out 2> err || fail "even: $(cat err)"
        tail -1 out | awk -F, -v rate=$rate '{ exit !($3 != "" && ($3 - rate)^2 < 1e-22 && ($4 - 12566.370614359)^2 < 1e-14) }' ||
            fail "a chart at rate $rate: $(tail -1 out)"
    done
done

# A pendulum released on its separatrix never comes back: what is computed beyond errors at the saddle is told apart.
printf '%s\n' 'model pendulum' 'state q' 'state p' 'angle c s = cos(q) sin(q)' 'eq q = p' 'eq p = -s' 'periodic q = 2*pi' > free.tt
sed -e 's/^model.*/model clocked/' -e 's/^state p/&\nstate phi/' free.tt > clocked.tt
printf 'eq phi = 1\nperiodic phi = 2*pi\n' >> clocked.tt
for start in q=0,p=2 q=pi,p=0 q=0,p=2.001 q=1,p=1; do
    wanted=$([[ $start = *p=2 || $start = *p=0 ]] && echo 1 || echo 0)
    expect 0 '^300,' jellett lyapunov ./clocked.tt --section phi=0 --start $start --returns 300
    [ "$(grep -c 'return [1-4] begins nearer to a saddle than errors tell separatrices apart' err)" = $wanted ] ||
        fail "exponents from $start: $(cat err)"
    # So do charts of exponents, and sections, which have no derivatives at hand, of one orbit or in lanes, in both directions.
    for how in "lyapunov --grid" "section --start" "section --grid" "section --backward --grid" "section --method dop853 --grid"; do
        expect 0 '' jellett ${how%% *} ./clocked.tt --section phi=0 ${how#* } $start --returns 300
        [ "$(grep -c 'nearer to a saddle than errors tell separatrices apart' err)" = $wanted ] || fail "$how $start: $(cat err)"
    done
done
# Nor does a motion that starts on a separatrix beside its saddle, however near. A chaotic one, of which every return stretches by
# more than all digits, is at no saddle.
printf '%s\n' 'model well' 'state x' 'state v' 'state phi' 'periodic phi = 2*pi' 'eq x = v' 'eq v = x - x^3' 'eq phi = 1' > well.tt
for x in 1e-3 1e-5 1e-7; do
    expect 0 '^100,' jellett lyapunov ./well.tt --section phi=0 --start x=$x,v=$x --returns 100
    grep -q 'begins nearer to a saddle' err || fail "exponents of a separatrix from x=$x: $(cat err)"
done
sed -e 's/^model.*/model shaken/' -e 's/^eq p = .*/angle C S = cos(phi) sin(phi)\neq p = -s + s*C*3\/2/' -e '/^periodic phi/d' \
    clocked.tt > shaken.tt
for start in q=1,p=0.5 q=0.5,p=1 q=2,p=1; do
    expect 0 '^100,' jellett lyapunov ./shaken.tt --section phi=0 --modulo phi=100.53096491487338 --start $start --returns 100
    ! grep -q 'begins nearer to a saddle' err || fail "exponents of a chaotic orbit: $(cat err)"
done
# The period is 4 K(p/2); on the separatrix there is none.
expect 0 '^1,1.99,14.78750032957' jellett orbits ./free.tt --section q=0 --start p=1.99 --period 1
! grep -q 'det DP differs' err || fail "a period that is known is said to be none: $(cat err)"
expect 0 'det DP differs from what flux and divergence make it by up to 0\..* where T is known no better either' \
    jellett orbits ./free.tt --section q=0 --start p=2 --period 1
# A return that contracts by all digits of DP, det = exp(-86), is known as well as any.
printf '%s\n' 'model vdp' 'state x' 'state v' 'eq x = v' 'eq v = -x + 5*(1 - x^2)*v' > vdp.tt
for command in 'orbits --period 1' 'continue --along mu=4.9:5'; do
    [ "${command%% *}" = continue ] && sed -i -e 's/^model.*/&\nparam mu/' -e 's/5\*/mu*/' -e '$a default mu = 5' vdp.tt
    expect 0 '(^1|,1),2.02[0-9]*,11.6122306677' \
        jellett ${command%% *} ./vdp.tt --section v=0 --direction down --start x=2 ${command#* }
    ! grep -q 'det DP differs' err || fail "what contracts by all digits: $(cat err)"
done
exit $status
