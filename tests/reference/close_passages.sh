#!/usr/bin/env bash
# What is small where other states are not. A fall past the centre, in t and by every method, against Kepler's equation: a root
# that is a state of its own beside what it is the root of loses it there, and is asked for by name alone. An equilibrium at which
# a state is 0 beside irrational ones, and an orbit in a plane that it never leaves, are proved.
source "$JLT_SOURCE_DIR/tests/scratch.sh"

cat > kepler.tt << 'T'
model kepler
state x
state y
state vx
state vy
root r = sqrt(x^2 + y^2)
eq x = vx
eq y = vy
eq vx = - x/r^3
eq vy = - y/r^3
integral L = x*vy - y*vx
time sundman : r lifting r
T
# From the apocentre (1, 0) with vy = 1e-3, at t = 1.2. The pericentre is at a distance of 5e-7: an error of the position by the
# tolerance, 1e-12, turns the orbit by 2e-6 there, and y changes by 2e-6 of itself; a factor of ten is room for several steps.
reference=$(python3 - << 'P'
from decimal import Decimal as D, getcontext
getcontext().prec = 60
def series(x, first):  # sin, cos by their series, for |x| <= 7
    term = total = D(1) if first == 0 else x
    k = first
    while abs(term) > D(10) ** -58:
        term *= -x * x / ((k + 1) * (k + 2)); k += 2; total += term
    return total
v = D("1e-3"); a = 1 / (2 - v * v); e = 1 / a - 1; n = 1 / (a ** 3).sqrt()
pi = D("3.14159265358979323846264338327950288419716939937510582097494459")
M = D("1.2") * n + pi  # the apocentre is at the mean anomaly pi
E = M
for _ in range(100): E -= (E - e * series(E, 1) - M) / (1 - e * series(E, 0))
print(-a * (1 - e * e).sqrt() * series(E, 1))
P
)
for method in gauss dop853 taylor rk8pd rkf45; do
    jellett simulate ./kepler.tt --start x=1,y=0,vx=0,vy=1e-3 --times 1.2 --method $method > out 2> err ||
        fail "$method: $(cat err)"
    tail -1 out | awk -F, -v y="$reference" '{ exit !($3/y - 1 < 2e-5 && 1 - $3/y < 2e-5) }' ||
        fail "$method: y = $(tail -1 out | cut -d, -f3), and Kepler's equation has $reference"
done
jellett plan simulate ./kepler.tt --start x=1,y=0,vx=0,vy=1 --times 1 > out
grep -q 'kepler_sundman .* by name only' out || fail "the other time is not by name alone: $(cat out)"

# x = sqrt 2, y = 0: lambda^4 = 2.
cat > saddle.tt << 'T'
model saddle
state x
state y
state u
state v
eq x = u
eq y = v
eq u = (x^2 - 2)*x/2 - y
eq v = (x^2 - 2)*x/2 - 2*y
T
jellett eigen ./saddle.tt --at x=1.41 --find --digits 20 > out 2> err || fail "eigen: $(cat err)"
grep -q '^verdict *unstable' out && grep -q ' 1\.1892071150027210667 ' out || fail "the saddle is not proved: $(cat out err)"

# At the origin every term vanishes with the states. DP of a cycle on which a relaxation is 0 in doubles has no defect.
jellett eigen lorenz --at x=0.1,y=0.1,z=0.1 --find > out 2> err || fail "eigen at the origin: $(cat err)"
grep -q '^state *x=0 y=0 z=0$' out || fail "the origin is not found: $(grep ^state out)"
printf '%s\n' 'model relaxation' 'param mu' 'state x' 'state y' 'eq x = + y' 'eq y = mu*(1-x^2)*y - x' 'default mu = 10' \
    > relaxation.tt
jellett section ./relaxation.tt --section x=0 --start y=1 --returns 2 --check > out 2> err ||
    fail "--check where DP is 0: $(cat err)"

# A branch of Hill's problem runs into a collision. Its orbit at J = -1.84407479 passes at 8.3e-7, where tangent vectors are 1e7
# times as long as at the return. By Taylor series of 40 terms in quadruple precision it starts at 0.50966440460483458 and has the
# trace -262.39643163. A tolerance turns the orbit by 1e-6 there, and each half of it has tangents of 1.6e3 beside DP's 2.6e2: a
# hundredth of the trace, if errors of states counted as far away, and 1e-8 of it where they are relative to the distance; room is
# for a hundred steps. Later orbits pass at 1e-8; who reads their multipliers is told.
printf '%s\n' 'model hill' 'state x' 'state y' 'state u' 'state v' 'root r = sqrt(x^2 + y^2)' 'eq x = u' 'eq y = v' \
    'eq u = 2*v + 3*x - x/r^3' 'eq v = -2*u - y/r^3' 'integral J = (u^2 + v^2)/2 - 3*x^2/2 - 1/r' \
    'reversor y -> -y, u -> -u' > hill.tt
branch=(jellett continue ./hill.tt --section y=0 --start x=0.5,u=0 --level J=-2.2 --solve v=1)
expect 0 'from -1.8[0-9]* on det DP differs from what flux and divergence make it by up to' "${branch[@]}" --along J=-3:-1
expect 0 'branch 0: the range ends' "${branch[@]}" --along J=-3:-2
for method in gauss dop853; do
    jellett orbits ./hill.tt --section y=0 --solve v=1 --level J=-1.84407479 --start x=0.5096644046,u=0 --period 1 \
        --method $method --tol 1e-12 > out 2> err || fail "$method, Hill's orbit: $(cat err)"
    tail -1 out | awk -F, '{ exit !($5 > -262.3975 && $5 < -262.3955 && $2 > 0.509664403 && $2 < 0.509664406) }' ||
        fail "$method: the trace is $(tail -1 out | cut -d, -f5), not -262.39643163"
done
grep -q 'det DP differs' err && fail "an orbit far from the collision is told to have lost digits: $(cat err)"

# In lanes such returns are left to the method of a single orbit: ln |DP|/T beside that orbit, by the same series.
for how in '' '--method gauss'; do
    jellett lyapunov ./hill.tt --section y=0 --solve v=1 --level J=-1.84407479 --grid x=0.5096644:0.5096645:2,u=0:1e-7:2 $how \
        --returns 1 > out 2> err || fail "exponents beside Hill's orbit: $(cat err)"
    awk -F, '/^0.5096644,0,/ { first = $3 } /^0.5096645,1e-07,/ { last = $3 }
        END { exit !((first - 1.764313)^2 < 1e-10 && (last - 1.764307)^2 < 1e-10) }' out ||
        fail "exponents beside Hill's orbit, $how: $(tail -4 out)"
done

# The same orbit comes back to its start: what `section` says of its error is within three times the distance from there.
for start in '--start x=0.50966440460483458,u=0' '--grid x=0.50966440460483458:0.6:2,u=0:0:1'; do
    jellett section ./hill.tt --section y=0 --solve v=1 --level J=-1.84407479 $start --returns 1 > out 2> err ||
        fail "Hill's orbit, $start: $(cat err)"
    said=$(sed -n 's/.*return 1 orbit 0 changes J by .* this return differs by \([^ ]*\) in u$/\1/p' err)
    awk -F, -v said="${said:-0}" '/^0,1,/ { u = $5 < 0 ? -$5 : $5; seen = said > u/3 && said < 3*u } END { exit !seen }' out ||
        fail "$start: Hill's orbit comes back at $(grep ^0,1, out), and what is said is $(cat err)"
done
jellett section ./hill.tt --section y=0 --solve v=1 --level J=-2.2 --start x=0.3,u=0 --returns 20 > out 2> err ||
    fail "an ordinary orbit of Hill's: $(cat err)"
[ -s err ] && fail "an ordinary orbit of Hill's: $(cat err)"
# In the anisotropic Kepler problem (M. C. Gutzwiller, J. Math. Phys. 14, 1973) returns come to lie close to the collision
# themselves, where nothing is left of H = -1/2 beside energies of 3e5; later ones have H = -0.468. `section` says so.
printf '%s\n' 'model anisotropic' 'param mu' 'domain d : mu > 0' 'default mu = 2' 'state x' 'state y' 'state u' 'state v' \
    'root r = sqrt(mu*x^2 + y^2)' 'eq x = u' 'eq y = v' 'eq u = -mu*x/r^3' 'eq v = -y/r^3' 'integral H = (u^2 + v^2)/2 - 1/r' \
    > anisotropic.tt
gutzwiller=(./anisotropic.tt --section y=0 --solve v=1 --tol 1e-8)
jellett section "${gutzwiller[@]}" --level H=-0.5 --start x=0.69,u=-0.2 --returns 60 > out 2> err ||
    fail "the anisotropic Kepler problem: $(cat err)"
change=$(awk -F, '/^0,60,/ { print ($5^2 + $6^2)/2 - 1/sqrt(2*$4^2) + 0.5 }' out)
said=$(sed -n 's/.*orbit 0 changes H by \([^,]*\), as errors of .* tolerances in every state and return would.*/\1/p' err)
awk -v change="${change#-}" -v said="${said:-0}" 'BEGIN { exit !(change > 1e-3 && said > change/2 && said < 2*change) }' ||
    fail "H is off by $change at the last return, and what is said is $(cat err)"
for which in '--start x=0.69,u=-0.2' '--grid x=0.05:1.4:16,u=-2:2:16' \
    '--sweep mu=2:2.1:2 --grid x=0.05:1.4:16,u=-2:2:16'; do
    jellett fates "${gutzwiller[@]}" --level H=-0.5 $which --returns 60 > out 2> err || fail "fates, $which: $(cat err)"
    grep -q 'on [1-9] of [1-9][0-9]* orbits a proved integral changes .*, as H by 0.[0-9]* from x=.*,u=.*: ' err ||
        fail "fates near a collision, $which: $(cat err)"
done
# Nor is anything close where a small oscillation has errors of a tolerance of the large one beside it: K changes by 1e-6 of itself.
printf '%s\n' 'model beside' 'state x' 'state y' 'state z' 'state w' 'eq x = y' 'eq y = -x' 'eq z = 20*w' 'eq w = -20*z' \
    'integral K = z^2 + w^2' > beside.tt
for start in '--start x=1,z=1e-6,w=1e-6' '--grid x=1:2:2,z=1e-6:2e-6:2,w=0'; do
    jellett section ./beside.tt --section y=0 $start --returns 5 > out 2> err || fail "a small oscillation, $start: $(cat err)"
    [ -s err ] && fail "a small oscillation, $start: $(cat err)"
    jellett fates ./beside.tt --section y=0 $start --returns 5 > out 2> err || fail "its fates, $start: $(cat err)"
    grep -q 'proved integral changes' err && fail "the fates of a small oscillation, $start: $(cat err)"
done

# The unit circle, in the plane z = 0: multipliers exp(-4 pi) and exp(-pi).
cat > plane.tt << 'T'
model plane
state x
state y
state z
eq x = x - y - x*(x^2 + y^2)
eq y = x + y - y*(x^2 + y^2)
eq z = - z/2
T
jellett certify sink ./plane.tt --section y=0 --start x=0.9,z=0.1 -o sink.json > out 2> err ||
    fail "the sink is not proved: $(cat err)"
jellett check --model plane.tt sink.json > out 2> err || fail "nor found proved again: $(cat err)"
python3 - << 'P' || fail "its determinant is not exp(-5 pi)"
import json, math
ball = json.load(open("sink.json"))["shown"]["determinant"]
assert abs(float(ball["middle"]) / math.exp(-5 * math.pi) - 1) < 1e-12
P

# A top whose centre of mass lies on its surface, |a3| = R, falls past the pole 1e-14 from it. There its level does not tell omega3:
# the smaller tier ended at a pole where there is none, or lost E. A motion in a plane is as near to it as doubles tell: gamma3 =
# cos theta, by steps of fourth order. A smaller tier may lose a thousand tolerances and more unseen: 2e-9.
python3 - > reference << 'P'
import math
def rate(y):
    theta, omega = y
    s, c = math.sin(theta), math.cos(theta)
    return -omega, (c * s * omega * omega - s) / (1 / 3 + s * s)
y, n = (math.acos(-0.6), 0.0), 20000
for _ in range(n):
    h, k = 2 / n, []
    for part in (0, 0.5, 0.5, 1):
        last = k[-1] if k else (0, 0)
        k.append(rate([a + h * part * b for a, b in zip(y, last)]))
    y = [a + h / 6 * (p + 2 * q + 2 * r + v) for a, p, q, r, v in zip(y, *k)]
print(math.cos(y[0]))
P
for top in a3=1,I3=1e-9 a3=1,I3=1e-6 a3=1,I3=1e-3 a3=1,I3=1/3; do
    for spin in 1e-6 1e-8 1e-10; do
        jellett simulate --set $top --start gamma3=-0.6,v_nu=30,omega_tau=0,omega_n=0,omega3=$spin --times 2 > out 2> err ||
            fail "past the pole, $top, omega3 = $spin: $(cat err)"
        tail -1 out | awk -F, -v g="$(cat reference)" '{ exit !($NF == "alive" && $2 - g < 2e-9 && g - $2 < 2e-9) }' ||
            fail "past the pole, $top, omega3 = $spin: $(tail -1 out), and a motion in a plane has gamma3 = $(cat reference)"
    done
done
jellett simulate --set a3=1,I3=1e-3 --start gamma3=-0.6,v_nu=30,omega_tau=0,omega_n=0,omega3=1e-10 --times 2 --method dop853 \
    > out 2>&1
tail -2 out | awk -F, -v g="$(cat reference)" '/^2,/ { d = $2 - g } END { exit !(d^2 < 1e-22 && d != "") }' ||
    fail "past the pole by dop853: $(cat out)"
jellett simulate --set a3=1,I3=1e-6 --start gamma3=-0.6,v_nu=30,omega_tau=0,omega_n=0,omega3=1e-8 --times 2 2>&1 > out |
    grep -q 'tier five in place of level: the tier five passes the pole at which level ends' || fail "a change of tier is not told"
jellett simulate --tier level --set a3=1,I3=1e-6 --start gamma3=-0.6,v_nu=30,omega_tau=0,omega_n=0,omega3=1e-8 --times 2 > out 2>&1
grep -q 'pole-$' out || fail "a tier asked for by name is not kept: $(cat out)"
# A motion in the plane itself ends at the pole, in the smaller tier as in the larger one.
jellett simulate --set a3=1,I3=1e-6 --start gamma3=-0.6,v_nu=30,omega_tau=0,omega_n=0,omega3=0 --times 2 > out 2> err
grep -q 'pole-$' out && ! grep -q 'in place of' err || fail "a true pole: $(cat out err)"
# So do motions that two tiers bring to a true pole at times that differ by errors of loose tolerances; and the error of a long
# motion, which the larger tier has as well, is no reason to compute it again.
while read -r tolerance time method start; do
    jellett simulate $start --times $time --tol $tolerance --method $method > out 2> err || fail "to a true pole: $(cat err)"
    ! grep -q 'in place of' err || fail "a tier is left for its errors, $tolerance, $start: $(cat err)"
done << 'T'
1e-4 10 taylor --start gamma3=-0.672,v_nu=-0.996,omega_tau=0.371,omega_n=-0.581,omega3=-1.138
1e-4 10 gauss --start gamma3=0.868,v_nu=0.745,omega_tau=-0.211,omega_n=0.923,omega3=0.157
1e-4 -50 rkf45 --start gamma3=0.32,v_nu=-0.59,omega_tau=0.441,omega_n=0.381,omega3=1.866
1e-8 1000 gauss --set I1=2/5 --start gamma3=0.703,v_nu=0.015,omega_tau=-0.162,omega_n=0.702,omega3=-0.029
1e-8 10000 rkf45 --set I1=0.499,I3=0.364,a3=0.153 --start gamma3=-0.012,v_nu=0.212,omega_tau=-0.19,omega_n=-0.793,omega3=-0.518
1e-6 15000 dop853 --set I1=0.537,I3=0.371,a3=0.264 --start gamma3=0.302,v_nu=0.14,omega_tau=0.038,omega_n=-0.794,omega3=0.351
T
exit $status
