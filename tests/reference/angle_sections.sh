#!/usr/bin/env bash
# States that are angles: a section in a phase is met once a turn and sees a forced system once a period, and orbits that differ by
# whole turns are one.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
cp "$JLT_SOURCE_DIR"/tests/reference/data/forced_pendulum.tt .
strobe=(./forced_pendulum.tt --section phi=0 --modulo 'phi=2*pi,theta=2*pi')

# Without gravity v' = -c v + A cos w t: from v(0) = 0 at t_n = 2 pi n/w it is v = A (c + ...)/(c^2 + w^2) (1 - exp(-c t_n)). Ten
# returns err by about the tolerance of 1e-12.
expect 0 '^0,10,' jellett section "${strobe[@]}" --set k=0 --start theta=0.1,v=0 --returns 10
awk -F, -v pi=3.141592653589793 '/^0,[0-9]/ { n++; t = 2*pi*$2*3/2; A = w = 0; c = 0.5; w = 2/3; A = 0.5
    bad += ($3 - t)^2 > 1e-20 || ($5 - A*c/(c^2 + w^2)*(1 - exp(-c*t)))^2 > 1e-22 || $4 > pi || $4 < -pi } END { exit !(n == 11 &&
    !bad) }' out ||
    fail "returns of the linear system: $(cat out)"
# What is no period of the field, or is known at no point of it, is refused.
expect 3 'theta is no angle' jellett section ./forced_pendulum.tt --section phi=0 --modulo phi=2*pi,theta=3 --start theta=0.1,v=0 \
    --returns 1
printf 'model apart\nstate r in (2, 9)\nstate b\nroot s = sqrt(r - 2)\neq r = 0*r\neq b = s*(1 + b^2)\n' > apart.tt
expect 3 'b is no angle' jellett section ./apart.tt --section r=2.9 --modulo 'b=2*pi' --start b=1 --returns 1
printf 'model sizes\nparam k\ndefault k = 1e12\nstate a\nstate b\neq a = k\neq b = -b\n' > sizes.tt
expect 3 'b is no angle' jellett section ./sizes.tt --section a=0 --modulo b=1 --start b=2.5 --returns 1
# Its multipliers are 1, of theta, and exp(-2 pi c/w); its exponents 0 and -c.
expect 0 '^1,' jellett orbits "${strobe[@]}" --set k=0 --start theta=0,v=0 --hold theta --period 1
awk -F, '/^1,/ { good = ($7 - 1)^2 < 1e-20 && ($9 - exp(-1.5*3.141592653589793))^2 < 1e-22 &&
    ($4 - 3*3.141592653589793)^2 < 1e-20 } END { exit !good }' out ||
    fail "the orbit of the linear system: $(tail -1 out)"
expect 0 '^100,' jellett lyapunov "${strobe[@]}" --set k=0 --start theta=0,v=0.3 --returns 100
awk -F, '/^100,/ { s = $3 + $4; good = (s + 0.5)^2 < 1e-18 && $3^2 < 1e-3 } END { exit !good }' out ||
    fail "its exponents: $(tail -1 out)"

# Without damping a weak torque leaves an orbit near each equilibrium, the upper one a saddle; from starts in many turns of theta
# each is found once.
expect 0 'centre' jellett orbits "${strobe[@]}" --set A=0.05,c=0 --grid theta=-6*pi:6*pi:13,v=0 --period 1
awk -F, '/^1,/ { n++; for (i in at) { d = $2 - at[i]; bad += d^2 + ($3 - v[i])^2 < 1e-6 } at[n] = $2;
    v[n] = $3 } END { exit !(n > 0 && !bad) }' out ||
    fail "an orbit is listed twice: $(cat out)"
awk -F, '/^1,/ && !($2 > -3.2 && $2 < 3.2) { bad = 1 } END { exit bad }' out ||
    fail "theta is not within half a period of 0: $(cat out)"

for theta in pi -pi 7*pi; do
    expect 0 '^1,.*,saddle' jellett orbits "${strobe[@]}" --set A=0.05,c=0,w=3 --start theta=$theta,v=0 --period 1
    tail -1 out | cut -c1-14
done | uniq > saddles
[ "$(wc -l < saddles)" -eq 1 ] || fail "one saddle has several places: $(cat saddles)"

# Without torque it turns over and over: T = integral of 1/sqrt(v0^2 - 2 (1 - cos theta)) over a turn, by the trapezoidal rule,
# which for a periodic function errs by rounding. It does so one way and the other, and swings through theta = 0 below H = k.
free=(./forced_pendulum.tt --section theta=0 --modulo 'phi=2*pi,theta=2*pi' --set A=0,c=0)
turn() { awk 'BEGIN { v0 = 2.3; n = 4096; for (i = 0; i < n; i++) s += 1/sqrt(v0^2 - 2*(1 - cos(6.283185307179586*i/n)));
    printf "%.17g", s*6.283185307179586/n }'; }
T=$(turn)
for way in up down; do
    v=$([ $way = up ] && echo 2.3 || echo -2.3)
    expect 0 '^0,5,' jellett section "${free[@]}" --direction $way --start v=$v,phi=0 --returns 5
    awk -F, -v T="$T" '/^0,5,/ { exit !(($3 - 5*T)^2 < 1e-20 && ($4^2 - 2.3^2)^2 < 1e-20) }' out ||
        fail "turning $way: $(tail -1 out), T = $T"
done
expect 0 '^0,0,.*^|^0,3,' jellett section "${free[@]}" --direction both --start v=1,phi=0 --returns 4
awk -F, '/^0,[1-4],/ { n++; bad += ($4 - (n % 2 ? -1 : 1))^2 > 1e-22 } END { exit !(n == 4 && !bad) }' out ||
    fail "swinging: $(cat out)"
expect 0 '^0,1,' jellett section "${free[@]}" --level H=1.5 --solve v=2 --start phi=0 --returns 1
awk -F, '/^0,0,/ { exit !(($5^2 - 5)^2 < 1e-24) }' out || fail "the level of H: $(cat out)"

# What cannot be an angle, and what else is refused.
start=(--start theta=0,v=0)
expect 3 "phi is no angle: the field of forced_pendulum, its domain or a condition changes when it grows by 6" \
    jellett section ./forced_pendulum.tt --section phi=0 --modulo phi=6 "${start[@]}"
# Nor is what has an interval, or what changes a condition: within half a turn of the section other points are outside.
for bound in 'state b in (-1, 100)' $'state b\ndomain inside : b + 1 > 0' $'state b\nvalid inside : b + 1 > 0'; do
    printf '%s\n' 'model bounded' "$bound" 'state a' 'angle c s = cos(b) sin(b)' 'eq b = 1' 'eq a = c' > bounded.tt
    expect 3 'b is no angle: the field of bounded, its domain or a condition' \
        jellett section ./bounded.tt --section b=0 --modulo 'b=2*pi' --start a=0 --returns 3
done
expect 3 "v is no angle" jellett section ./forced_pendulum.tt --section phi=0 --modulo v=1 "${start[@]}"
expect 3 "the period of phi must be positive" jellett section ./forced_pendulum.tt --section phi=0 --modulo phi=-1 "${start[@]}"
expect 3 "has no state 'psi'" jellett section ./forced_pendulum.tt --section phi=0 --modulo psi=1 "${start[@]}"
expect 3 "'2pi' is no finite number" jellett section ./forced_pendulum.tt --section phi=0 --modulo phi=2pi "${start[@]}"
expect 3 "'2\*pi/0' is no finite number" jellett section ./forced_pendulum.tt --section phi=0 --modulo 'phi=2*pi/0' "${start[@]}"
expect 2 "--modulo goes with --section" jellett section --start eta=0.1,gamma3=-0.6 --modulo eta=1
expect 3 "H is an integral of forced_pendulum only when A = 0" jellett section "${strobe[@]}" "${start[@]}" --level H=1 --solve v=1
# What the table proves to be a period needs no option, which takes it back by 0; one that is refuted makes no angle.
{ cat forced_pendulum.tt; printf 'periodic phi = 2*pi\nperiodic theta = 2*pi\n'; } > periodic.tt
{ cat forced_pendulum.tt; printf 'periodic phi = 3\nperiodic theta = 2*pi\n'; } > refuted.tt
turns=(--start theta=0.1,v=5 --returns 12)
expect 0 '^0,12,' jellett section "${strobe[@]}" "${turns[@]}"
grep -v '^#' out > wanted
expect 0 '^0,12,' jellett section ./periodic.tt --section phi=0 "${turns[@]}"
grep -v '^#' out | cmp -s - wanted || fail "by 'periodic': $(cat out)"
expect 0 '^0,12,' jellett section ./periodic.tt --section phi=0 --modulo theta=0 "${turns[@]}"
awk -F, '/^0,/ && ($4 > 4 || $4 < -4) { far = 1 } END { exit !far }' out || fail "theta is still an angle: $(cat out)"
# A phase that is no angle never comes back: its rate is w everywhere.
expect 3 "'periodic phi' is not proved of this table" jellett section ./refuted.tt --section phi=0 "${turns[@]}"
expect 3 "^jellett: --modulo phi=0 sets aside its period, which the table proves$" \
    jellett section ./periodic.tt --section phi=0 --modulo phi=0 "${turns[@]}"
for command in "section --returns 1" orbits fates lyapunov "continue --along A=0:1"; do
    expect 3 "write 'periodic phi = PERIOD' in the table, or --modulo phi=PERIOD" \
        jellett ${command%% *} ./forced_pendulum.tt --section phi=0 "${start[@]}" $(cut -s -d ' ' -f 2- <<< "$command")
done

# On a torus b x - a y is kept along orbits, and counts turns: at returns to x = 0 it is another, which is no drift. What the rest
# of the integrals do is told.
printf 'model torus\nparam a != 0\nparam b\ndefault a = 1, b = 3/5\nstate x\nstate y\nstate z\nangle c s = cos(x) sin(x)\n'\
'eq x = a\neq y = b\n' > torus.tt
printf 'eq z = a*c\nperiodic x = 2*pi\nperiodic y = 2*pi\nintegral turning = b*x - a*y\nintegral height = z - s\n' >> torus.tt
expect 0 'turning is another after a turn of x, and returns do not count turns: its drift is left out' \
    jellett drift ./torus.tt --section x=0 --start y=0.1,z=0 --returns 4
grep -q '^method,returns,t,evaluations,drift_height$' out || fail "drift of what counts turns: $(cat out)"
awk -F, '/^[a-z0-9]*,[0-9]/ { n++; bad += $5 > 1e-10 } END { exit !(n > 9 && !bad) }' out || fail "drift on the torus: $(cat out)"
sed -i '/^integral height/d' torus.tt
expect 3 'torus proves no other integral' jellett drift ./torus.tt --section x=0 --start y=0.1,z=0 --returns 4

# b = 1 + 20 sin t turns back after three turns: it passes the section upwards where 20 sin t = 2 pi k and cos t > 0, at t = asin(pi
# k/10) + 2 pi n, and downwards at pi - that, seven times a period either way. With derivatives the same: from one crossing to the
# next a change of t stays what it is.
printf '%s\n' 'model swing' 'state b' 'state t' 'angle c s = cos(t) sin(t)' 'eq b = 20*c' 'eq t = 1' 'periodic b = 2*pi' > swing.tt
crossings() { # DIRECTION: of the first 21 rows of `out`, times of the closed form
    awk -F, -v way="$1" -v pi=3.141592653589793 '/^0,[0-9]/ { n++; if ($2 == 0) next
        i = $2 + 3; k = i % 7 - 3; turn = int(i/7)
        if (way == "down") k = -k
        x = pi*k/10; at = atan2(x, sqrt(1 - x*x)); t = way == "up" ? 2*pi*turn + at : 2*pi*turn + pi - at
        if (way == "down") t -= pi
        bad += ($3 - t)^2 > 1e-18 } END { exit !(n == 22 && !bad) }' out
}
expect 0 '^0,21,' jellett section ./swing.tt --section b=1 --start t=0 --returns 21
crossings up || fail "crossings of what turns back: $(cut -d, -f3 out | tr '\n' ' ')"
expect 0 '^0,21,' jellett section ./swing.tt --section b=1 --direction down --start t=3.141592653589793 --returns 21
[ ! -s err ] || fail "what crosses both ways is said to cross one way: $(cat err)"
crossings down || fail "crossings downwards of what turns back: $(cut -d, -f3 out | tr '\n' ' ')"
expect 0 '^21,' jellett lyapunov ./swing.tt --section b=1 --start t=0 --returns 21
awk -F, '/^21,/ { exit !(($2 - 18.849555921538759)^2 < 1e-18) }' out || fail "returns with derivatives: $(tail -1 out)"
# In lanes as alone, whatever turns where; theta grows by 5 turns a return.
as_alone() { # ARGUMENTS of section
    jellett section "$@" > lanes 2> err || fail "$*: $(cat err)"
    jellett section "$@" --method gauss > alone 2> err || fail "$* alone: $(cat err)"
    grep -q '^# many orbits at once' lanes || fail "not in lanes: $*"
    paste -d, <(grep 'alive$' lanes) <(grep 'alive$' alone) | awk -F, '{ for (i = 1; i <= NF/2; i++) { d = $i - $(i + NF/2)
        bad += d*d > 1e-18*(1 + $i*$i) || ($i == "") != ($(i + NF/2) == "") } } END { exit !(NR > 20 && !bad) }' ||
        fail "lanes and alone differ: $*"
}
for way in up down both; do
    for time in "" --backward; do
        as_alone ./swing.tt --section b=1 --direction $way --grid t=0:6:7 --returns 15 $time
        as_alone ./forced_pendulum.tt --section theta=1 --modulo 'phi=2*pi,theta=2*pi' --set A=0,c=0 --direction $way \
            --grid phi=0:5:3,v=-3:3:5 --returns 4 $time
    done
done
as_alone "${strobe[@]}" --grid theta=-2:3:4,v=-3:4:4 --returns 3
as_alone "${strobe[@]}" --set k=0.01,w=0.2 --grid theta=-2:3:4,v=-1:1:3 --returns 2
# Where another angle has made thousands of turns, what rounding does to it is no error of steps: the orbit stays in lanes, and its
# first rows are those of a shorter run.
printf '%s\n' 'model wheel' 'state x' 'state y' 'state z' 'angle c s = cos(z) sin(z)' 'eq x = y' 'eq y = -x - x^3 + c/10' \
    'eq z = 5 + x/3' 'periodic z = 2*pi' > wheel.tt
for n in 99 999; do
    expect 0 "^7,$n," jellett section ./wheel.tt --section x=0 --grid y=0.5:2:8,z=0 --returns $n
    grep -E '^[0-7],[0-9]{1,2},' out > first_$n
done
cmp -s first_99 first_999 || fail "rows of a long run differ: $(diff first_99 first_999 | head -4)"
# The other way round and round it is met never, and that ends.
printf '%s\n' 'model mill' 'state b' 'state t' 'eq b = -1' 'eq t = 1' 'periodic b = 2*pi' > mill.tt
expect 0 '^0,1,[0-9.]*,,budget' jellett section ./mill.tt --section b=1 --start t=0 --returns 1
grep -q 'b seems to cross its section the other way alone: --direction down' err || fail "the other way: $(cat err)"
expect 0 '^0,1,6.28' jellett section ./mill.tt --section b=1 --start t=0 --returns 1 --direction down
[ ! -s err ] || fail "the right way: $(cat err)"
# What is no angle comes back never; coordinates that are bounded do not hide that.
printf '%s\n' 'model tower' 'state x in (-1, 1)' 'state y in (-1, 1)' 'state z' 'eq x = y*(1 - x^2)' 'eq y = -x*(1 - y^2)' \
    'eq z = 1' > tower.tt
expect 3 'z changes at one rate everywhere on z=0, and' jellett section ./tower.tt --section z=0 --start x=0.1,y=0.2 --returns 1

# Mirror images of points on edges of cells are counted where they are: what stays in place visits its own mirror image, whether
# orbits backwards are followed (--mirror) or known.
printf '%s\n' 'model still' 'state a' 'state b' 'state phi' 'eq a = 0*b' 'eq b = 0*a' 'eq phi = 1' 'periodic phi = 2*pi' \
    'reversor b -> -b, phi -> -phi' > still.tt
for mirror in '' '--mirror b,phi'; do
    expect 0 '^4,25,25,25,25,25,1,1$' jellett separation ./still.tt --section phi=0 $mirror --grid a=-0.5:0.5:5,b=-0.4:0.4:5 \
        --cells a=-0.55:0.55:11,b=-0.5:0.5:10 --settle 0 --returns 4
done

# A phase that is 0 on the section, beside states that fade: a damped, driven oscillator at rest as good as, from 1 after 300
# periods and from 1e-20 or 1e-122 at once. It is linear, so that twenty returns from any start are those from 1.
printf '%s\n' 'model damped' 'state x' 'state v' 'state phi' 'angle c s = cos(phi) sin(phi)' 'periodic phi = 2*pi' 'eq x = v' \
    'eq v = -(1 + c/5)*x - v/10' 'eq phi = 1' > damped.tt
expect 0 '^0,300,' jellett section ./damped.tt --section phi=0 --start x=1,v=0 --returns 300
expect 0 '^0,20,' jellett section ./damped.tt --section phi=0 --start x=1,v=0 --returns 20 --method taylor
cp out from_one
for method in gauss dop853 taylor rk8pd rkf45 msadams; do
    for x in 1e-12 1e-20 1e-116; do
        expect 0 '^0,20,' jellett section ./damped.tt --section phi=0 --start x=$x,v=0 --returns 20 --method $method
        awk -F, -v x=$x 'NR == FNR { if (/^0,20,/) one = $4 } /^0,20,/ { last = $4/x } END { exit !((last/one - 1)^2 < 1e-20) }' \
            from_one out || fail "from $x by $method: $(tail -1 out), not $(tail -1 from_one)"
    done
    expect 0 '^0,20,' jellett section ./damped.tt --section phi=0 --start x=1e-122,v=0 --returns 20 --method $method
done

# Where all states are small, what rounding of whole turns leaves of the phase is no crossing: the nth return is at 2 pi n.
printf 'model saddle\nstate x\nstate z\nstate phi\nperiodic phi = 2*pi\neq x = x/4\neq z = -z/4 + x^2/4\neq phi = 1\n' > saddle.tt
for options in '--tol 1e-13' '--tol 1e-12 --backward' '--tol 1e-12 --backward --method taylor'; do
    expect 0 '^1999,3,' jellett section ./saddle.tt --section phi=0 $options --returns 3 --grid x=0:0.001:10,z=1e-6:1e-3:200
    awk -F, -v pi=3.141592653589793 '/^[0-9]/ { n++; t = $3 < 0 ? -$3 : $3; bad += (t - 2*pi*$2)^2 > 1e-20 }
        END { exit !(n == 8000 && !bad) }' out || fail "a phase is crossed twice at once, with $options"
done

# Twenty thousand returns of one period: rounding errors of their times do not add up, neither one orbit at a time, where each
# return begins anew, nor in lanes.
printf '%s\n' 'model forced' 'state x' 'state v' 'state phi' 'angle c s = cos(phi) sin(phi)' 'periodic phi = 2*pi' 'eq x = v' \
    'eq v = -x - v/10 + c' 'eq phi = 1' > forced.tt
printf '%s\n' 'model circle' 'state x' 'state y' 'eq x = -y + x - x*(x^2 + y^2)' 'eq y = x + y - y*(x^2 + y^2)' > circle.tt
for what in './forced.tt --section phi=0 --start x=1,v=0' './circle.tt --section y=0 --start x=1 --start x=2'; do
    expect 0 '^0,20000,' jellett section $what --returns 1 --skip 19999
    awk -F, -v pi=3.141592653589793 '/^[01],20000,/ { n++; bad += ($3 - 2*pi*$2)^2 > 9e-20 } END { exit !(n > 0 && !bad) }' out ||
        fail "times of $what: $(tail -2 out)"
done
for sweep in '' '--sweep k=1:2:2'; do
    [ -n "$sweep" ] && printf 'param k\ndefault k = 1\n' >> forced.tt
    expect 0 '20000,' jellett lyapunov ./forced.tt --section phi=0 --start x=1,v=0 --returns 20000 $sweep
    sed 's/^[0-9],//' out | awk -F, -v pi=3.141592653589793 '/^20000,/ { n++; bad += ($2 - 2*pi*$1)^2 > 9e-20 }
        END { exit !(n > 0 && !bad) }' || fail "times of exponents $sweep: $(tail -2 out)"
done
# Half a turn from 0 a reversor that changes the phase's sign leads to the section, too. A pendulum on a shaken support: orbits
# followed backwards are the mirror images, and the equilibria are symmetric; elsewhere it leads to another section.
printf '%s\n' 'model shaken' 'state q' 'state p' 'state phi' 'angle cq sq = cos(q) sin(q)' 'angle cf sf = cos(phi) sin(phi)' \
    'eq q = p' 'eq p = - sq - 16*cf*sq' 'eq phi = 4' 'periodic phi = 2*pi' 'periodic q = 2*pi' 'reversor q -> -q, phi -> -phi' \
    > shaken.tt
for at in 0 pi -pi 3*pi; do
    expect 0 '^4,30,30,[1-9].*,1$' jellett separation ./shaken.tt --section phi=$at --mirror q,phi --grid q=-3:3:6,p=-1:1:5 \
        --cells q=-3:3:40,p=-10:10:41 --settle 0 --returns 4
    expect 0 '^1,0,0,1.57.*,yes,flip saddle' jellett orbits ./shaken.tt --section phi=$at --start q=0,p=0
done
expect 3 'at STATE = 0 alone and half a turn from it, not at phi = 1:' jellett separation ./shaken.tt --section phi=1 \
    --grid q=-3:3:6,p=-1:1:5
# There a level may have another mirror image: (f - q)^2 is (pi - q)^2 at f = pi, and (-pi - q)^2 where both change signs.
printf '%s\n' 'model winding' 'state q' 'state z' 'state y' 'state f' 'eq q = 1' 'eq z = y' 'eq y = -z' 'eq f = 1' \
    'integral I = (f - q)^2 + z^2 + y^2' 'reversor q -> -q, f -> -f, z -> -z' 'periodic f = 2*pi' 'periodic q = 2*pi' > winding.tt
winding=(--level I=4 --solve y=1 --grid q=1.52:1.92:2,z=0.13:0.23:2 --cells q=-3:3:40,z=-2:2:40 --settle 0 --returns 4)
expect 0 '^4,4,4,4,' jellett separation ./winding.tt --section f=0 "${winding[@]}"
expect 3 'needs a reversor' jellett separation ./winding.tt --section f=pi "${winding[@]}"
# An inverted pendulum so stiff that squares in DP pass the range of doubles: multipliers exp(120 pi) = 5.31083074806e163 and its
# inverse (mpmath), a saddle.
printf '%s\n' 'model stiff' 'state phi' 'state q' 'state p' 'angle c s = cos(q) sin(q)' 'eq phi = 1' 'eq q = p' 'eq p = 3600*s' \
    'periodic phi = 2*pi' 'periodic q = 2*pi' > stiff.tt
expect 0 '^1,0,0,6.28.*,5.310830748.*e.163,0,1.882944585.*e-164,0,,saddle' jellett orbits ./stiff.tt --section phi=0 --start q=0,p=0
# A section that a table describes shows what one typed does, also the angles in which an orbit ends, after turns.
printf '%s\n' 'model spun' 'state q' 'state v' 'state f' 'angle C S = cos(q) sin(q)' 'angle c s = cos(f) sin(f)' \
    'eq q = v' 'eq v = -S + c*S/10' 'eq f = 1' 'periodic q = 2*pi' 'periodic f = 2*pi' \
    'section strobe : by spun_section.tt at f = 0 with q = q, v = v' > spun.tt
printf '%s\n' 'model spun_section' 'state q' 'state v' 'lift into spun.tt with q = q, v = v, f = 0' 'start regular : q = 0, v = 0' \
    > spun_section.tt
for section in strobe f=0; do
    jellett fates ./spun.tt --section $section --grid q=-3:3:5,v=-2:2:5 --returns 10 2> log | grep -v '^#' > $section.csv
done
[ "$(awk -F, '$5^2 > 10' f=0.csv)$(wc -l < f=0.csv)" = 26 ] || fail "ends after turns: $(cat f=0.csv)"
cmp -s f=0.csv strobe.csv || fail "a section that a table describes shows other ends: $(diff f=0.csv strobe.csv)"
# So it does beyond half a turn: the section's own angle stays near its level.
sed -i 's/f = 0 with/f = 4 with/' spun.tt
sed -i 's/f = 0$/f = 4/' spun_section.tt
for section in strobe f=4; do
    jellett fates ./spun.tt --section $section --grid q=-3:3:5,v=-2:2:5 --returns 10 2> log | grep -v '^#' > $section.csv
done
cmp -s f=4.csv strobe.csv || fail "other ends at a section beyond half a turn: $(diff f=4.csv strobe.csv | head -4)"
# A period at one value of a parameter alone is told of as such where the parameter runs.
printf '%s\n' 'model lattice' 'param k' 'default k = 1' 'state q' 'state v' 'state f' 'angle C S = cos(k*q) sin(k*q)' \
    'angle c s = cos(f) sin(f)' 'eq q = v' 'eq v = -S - v/10 + 2*c/5' 'eq f = 1' 'periodic f = 2*pi' > lattice.tt
expect 3 'along: at k=.*, growing q by its period changes the equations' \
    jellett continue ./lattice.tt --section f=0 --modulo q=2*pi --start q=0,v=0.1 --along k=1:2
expect 0 '^0,2,' jellett continue ./lattice.tt --section f=0 --start q=0,v=0.1 --along k=1:2
exit $status
