#!/usr/bin/env bash
# A stiff orbit that would not arrive with its budget of 10^7 steps ends long before they are made, and simulate says why; one that
# does arrive is followed to its end. Van der Pol's slow manifold: (1 - x^2) dx = x dt/mu, up to terms of the order of mu^-2.
source "$JLT_SOURCE_DIR/tests/scratch.sh"

cat > pol.tt << 'T'
model pol
param mu > 0
default mu = 1e4
state x
state y
eq x = y
eq y = mu*y - mu*x^2*y - x
T
orbit=(jellett simulate ./pol.tt --start x=2,y=0)
for method in gauss dop853 taylor rk8pd rkf45 msadams; do
    "${orbit[@]}" --times 20000 --method $method > out 2> err
    [ $? -eq 4 ] || fail "$method: status"
    t=$(tail -1 out | cut -d, -f1)
    step=$(sed -n 's/.* within the budget of steps: its steps take \([^ ]*\) of time, .* stiff, .*/\1/p' err)
    # not a fourth of the budget is spent
    awk -v t="$t" -v step="$step" 'BEGIN { exit !(step > 0 && t > 0 && t < 1e7 / 4 * step) }' || fail "$method: $(cat out err)"
done
# Nor is it with many rows on the way, at each of which the orbit would arrive.
for every in 200 5; do
    timeout 100 "${orbit[@]}" --until 20000 --every $every > out 2> err
    [ $? -eq 4 ] || fail "every $every: status"
    t=$(tail -1 out | cut -d, -f1) step=$(sed -n 's/.*: its steps take \([^ ]*\) of time, .* stiff, .*/\1/p' err)
    awk -v t="$t" -v step="$step" 'BEGIN { exit !(step > 0 && t > 0 && t < 1e7 / 4 * step) }' || fail "every $every: $(cat err)"
done
"${orbit[@]}" --times 20 > out 2> err || fail "20: $(cat err)"
tail -1 out | awk -F, '{ d = log($2/2) - $2^2/2 + 2 - 20/1e4; exit !($4 == "alive" && d < 1e-7 && d > -1e-7) }' || fail "$(cat out)"

# Dry friction stops a body at t = |v|/mu = 1, which is where the domain ends, and found there: u and v keep their signs before. On
# a slope they do not, and what is said ends the orbit where 1e-6 of velocity are left, on the plane at t = 1 - 2e-6.
printf '%s\n' 'model friction' 'state x' 'state u' 'state v' 'root w = sqrt(u^2 + v^2)' 'eq x = u' 'eq u = - u/w/2' \
    'eq v = - v/w/2' 'domain moving : u^2 + v^2 > 0' > friction.tt
for method in gauss dop853 taylor rk8pd rkf45 msadams; do
    expect 4 'comes to the edge of the domain' jellett simulate ./friction.tt --start x=0,u=0.3,v=0.4 --times 2 --method $method
    tail -1 out | awk -F, '{ d = $1 - 1; exit !($5 == "left_domain" && d < 1e-11 && d > -1e-11) }' || fail "friction: $(cat out)"
done
sed 's/w.2/&+ 1\/20/; s/friction/slope/' friction.tt > slope.tt
expect 4 'dry friction stops a body, which .domain moving : u.2 [+] v.2 - 1e-12 > 0' \
    jellett simulate ./slope.tt --start x=0,u=0.3,v=0.4 --times 3
sed -i 's/^domain .*/domain moving : u^2 + v^2 - 1e-12 > 0/' friction.tt
jellett simulate ./friction.tt --start x=0,u=0.3,v=0.4 --times 2 > out 2> err
tail -1 out | awk -F, '{ d = $1 - 1 + 2e-6; exit !($5 == "left_domain" && d < 1e-11 && d > -1e-11) }' ||
    fail "friction: $(cat out err)"

# Commands of maps say so as well, seen once a period of a clock.
sed -e 's/model pol/model clocked/' pol.tt > clocked.tt
printf '%s\n' 'state phi' 'eq phi = 1' 'periodic phi = 2*pi' >> clocked.tt
for command in lyapunov 'orbits --period 1' 'continue --along mu=1e9:1e10' manifolds; do
    jellett $command ./clocked.tt --section phi=0 --start x=2,y=0 --set mu=1e9 > out 2> err
    [ $? -eq 4 ] && grep -q 'motion is stiff: no --method here is made for that' err || fail "$command: $(cat err)"
done
# Who has the time lets a return take more steps than maps do by themselves. The period of the cycle is, for large mu,
# (3 - 2 ln 2) mu + 3 a mu^(-1/3) + O(ln mu/mu), -a = -2.33810741 the first zero of Airy's function (A. A. Dorodnitsyn,
# Prikl. Mat. Mekh. 11, 1947).
for command in section 'orbits --period 1' fates 'continue --along mu=300:310'; do
    jellett $command ./pol.tt --section x=0 --start y=200 --set mu=300 > out 2> err
    grep -qE 'budget|--max-steps allows more' out err || fail "$command of many steps: $(cat out err)"
done
for method in gauss rkf45; do
    expect 0 ',alive$' jellett section ./pol.tt --section x=0 --start y=200 --set mu=300 --returns 2 --max-steps 3000000 \
        --method $method
    awk -F, '/^0,1,/ { t = $3 } /^0,2,/ { d = $3 - t - (3 - 2*log(2))*300 - 3*2.33810741*300^(-1/3); bound = 2*log(300)/300
        exit !(d < bound && d > -bound) } END { if (NR < 8) exit 1 }' out || fail "$method, the period at mu = 300: $(tail -2 out)"
done
# A spring that is stiffer on one side: every motion has the period pi/sqrt(3/2) + pi/sqrt(1/2). Its rate turns within steps, even
# where no node of theirs sees it, and each method comes back to within a hundred tolerances.
printf '%s\n' 'model bilinear' 'state x' 'state v' 'root a = sqrt(x^2 + 1e-26)' 'eq x = v' 'eq v = - x - a/2' > bilinear.tt
for method in gauss dop853 taylor rk8pd rkf45 msadams; do
    for v in 0.1 0.2 0.3 0.4 0.5 0.6 0.7 0.8 0.9; do
        jellett simulate ./bilinear.tt --start x=1,v=$v --times 7.0079825984820943 --method $method > out || fail "status $?"
        awk -F, -v v=$v '/^7/ { x = $2; y = $3 } END { exit !((x - 1)^2 + (y - v)^2 < 1e-10^2) }' out || fail "$method: $(cat out)"
    done
done
# Orbits in lanes do as well: back on the section they have the velocity with which they left it.
jellett section ./bilinear.tt --section x=0 --grid v=0.1:2:60 --returns 3 --tol 1e-12 > out || fail "lanes: status $?"
grep -q 'many orbits at once' out || fail "lanes: $(grep '^#' out)"
awk -F, '/^[0-9]/ && $2 == 0 { v = $4 } /^[0-9]/ { n++; if (($4 - v)^2 > 1e-10^2) print } END { if (n != 240) print n " rows" }' \
    out > off
[ -s off ] && fail "lanes: $(head -3 off)"
# The cosine of a large phase is known to fewer digits than a step may err by: its errors do not fall with the step. In a time of
# 1000 half a unit in the last place of 1e6, 6e-11, moves the phase of an oscillator by 6e-8; methods differ by less than 1e-6.
printf '%s\n' 'model forced' 'state x' 'state v' 'state phase' 'angle C S = cos(phase) sin(phase)' 'eq x = v' \
    'eq v = - x - x^3 + C' 'eq phase = 1' > forced.tt
jellett simulate ./forced.tt --start x=1,v=0,phase=1e6 --times 1000 --method dop853 > other || fail "dop853: status $?"
jellett simulate ./forced.tt --start x=1,v=0,phase=1e6 --times 1000 > out || fail "a phase of 1e6: status $?"
tail -q -n 1 out other | awk -F, '{ x[NR] = $2; v[NR] = $3; alive += $5 == "alive" }
    END { exit !(alive == 2 && (x[1] - x[2])^2 + (v[1] - v[2])^2 < 1e-6^2) }' || fail "a phase of 1e6: $(tail -q -n 1 out other)"
for phase in 1e7; do
    timeout 60 jellett simulate ./forced.tt --start x=1,v=0,phase=$phase --times 100 > out 2> err || fail "phase $phase: $(cat err)"
done
# Slopes whose terms cancel are known to fewer digits than small tolerances ask for: what rounding leaves of their sums, 3e-11, does
# not fall with the step, and gauss spent its steps on it at 1e-14. Exactly: x = 500000 + y, y' = -y/2 + 20 sin t, and v' = -y -
# y^2/1000000 - v, of which y is 20 (sin t/2 - cos t + exp(-t/2))/1.25; v by steps of fourth order.
printf '%s\n' 'model cancelling' 'state x' 'state v' 'state t' 'angle C S = cos(t) sin(t)' 'eq x = 250000 - 0.5*x + 20*S' \
    'eq v = 250000 - 0.000001*x^2 - v' 'eq t = 1' > cancelling.tt
python3 - > exact << 'P'
import math
def y(t): return 16 * (math.sin(t) / 2 - math.cos(t) + math.exp(-t / 2))
def rate(t, v): return -y(t) - y(t) ** 2 / 1e6 - v
v, n, h = 1.0, 40000, 100 / 40000
for i in range(n):
    t = i * h
    a = rate(t, v); b = rate(t + h / 2, v + h / 2 * a); c = rate(t + h / 2, v + h / 2 * b); d = rate(t + h, v + h * c)
    v += h / 6 * (a + 2 * b + 2 * c + d)
print(500000 + y(100), v)
P
for tolerance in 1e-12 1e-13 1e-14 1e-15; do
    jellett simulate ./cancelling.tt --start x=500000,v=1,t=0 --times 100 --tol $tolerance > out 2> err ||
        fail "cancelling, $tolerance: $(cat err)"
    tail -1 out | tr , ' ' | cat - exact |
        awk 'NR == 1 { x = $2; v = $3 } END { exit !(($1 - x)^2 < 1e-9^2 && ($2 - v)^2 < 3e-10^2) }' ||
        fail "cancelling, $tolerance: $(tail -1 out), not $(cat exact)"
done
# Parts of the rates that turn between two nodes of gauss, or that a series does not show at the start of its step, are seen:
# smoothed friction, a pulse; exactly by small steps.
cat > friction.tt << 'T'
model friction
state x
state v
state phi
angle C S = cos(phi) sin(phi)
exp N = exp(-8*v)
eq x = v
eq v = - 0.7*x - 0.0001*(1 - N)/(1 + N) + C
eq phi = 1
T
sed 's/-8\*v/-18*v^2/; s/0.7\*x.*/1.7*x - 0.33*N + 1.5*C - 0.066*v/; s/= 1$/= 1.36/; s/friction/pulse/' friction.tt > pulse.tt
python3 - > exact << 'P'
from math import cos, exp, tanh
def follow(rate, v):
    x, n = 0.3, 60000
    h = 15 / n
    for i in range(n):
        t = i * h
        a = rate(t, x, v)
        b = rate(t + h / 2, x + h / 2 * v, v + h / 2 * a)
        c = rate(t + h / 2, x + h / 2 * v + h * h / 4 * a, v + h / 2 * b)
        d = rate(t + h, x + h * v + h * h / 2 * b, v + h * c)
        x, v = x + h * v + h * h / 6 * (a + b + c), v + h / 6 * (a + 2 * b + 2 * c + d)
    return x
for v in (-0.9, -0.2, 0.1, 0.4):
    print("friction", v, follow(lambda t, x, v: -0.7 * x - 1e-4 * tanh(4 * v) + cos(t), v))
    print("pulse", v, follow(lambda t, x, v: -1.7 * x - 0.33 * exp(-18 * v * v) + 1.5 * cos(1.36 * t) - 0.066 * v, v))
P
while read -r model v x; do
    for how in gauss:1e-7 gauss:1e-9 gauss:1e-12 taylor:1e-9 taylor:1e-12; do
        tolerance=${how#*:}
        jellett simulate "./$model.tt" --start "x=0.3,v=$v,phi=0" --times 15 --tol "$tolerance" --method "${how%:*}" > out ||
            fail "$model: status $?"
        tail -1 out | awk -F, -v x="$x" -v t="$tolerance" '{ exit !(($2 - x)^2 < (50 * t + 1e-11)^2) }' ||
            fail "$model from $v by $how: $(tail -1 out), not $x"
    done
done < exact
expect 3 "'0' is no whole number from 1" jellett section ./pol.tt --section x=0 --start y=200 --max-steps 0
exit $status
