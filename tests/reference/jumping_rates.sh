#!/usr/bin/env bash
# Dry friction on a spring, x'' = -x - mu sign(x'): a rate jumps where the velocity changes its sign. States pass there, but tangent
# vectors jump by what no Jacobian has, so that no derivative of the map is given, whatever the method and the tolerance. Where
# friction is smoothed, however sharply, there is one. Oracle: each half of a swing is a half circle about -mu or mu: a return to
# x = 0 upwards makes r = sqrt(v^2 + mu^2) smaller by 4 mu, and dv'/dv = (v/r) (r - 4 mu)/v'.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
printf '%s\n' 'model dry' 'param mu >= 0' 'param soft >= 0' 'default mu = 1/2, soft = 0' 'state x' 'state v' \
    'root size = sqrt(v^2 + soft)' 'eq x = v' 'eq v = - x - mu*v/size' > dry.tt
image=$(awk 'BEGIN { r = sqrt(9.25) - 2; printf "%.17g", sqrt(r^2 - 0.25) }')
expect 0 '^0,1,' jellett section ./dry.tt --section x=0 --start v=3 --returns 1
awk -F, -v v="$image" '/^0,1,/ { exit !(($4 - v)^2 < 1e-20) }' out || fail "states: $(cat out)"
expect 1 'DP could not be computed at 1 of 1 returns' jellett section ./dry.tt --section x=0 --start v=3 --returns 1 --check
# A check that one return of two evades does not pass: one orbit meets the jump at x = 3, the other does not.
printf '%s\n' 'model step' 'state x' 'state v' 'root a = sqrt((x - 3)^2)' 'eq x = v' 'eq v = - x - (x - 3)/a' > step.tt
expect 1 'DP could not be computed at 1 of 2 returns$' jellett section ./step.tt --section x=0 --start v=0.5 --start v=3 \
    --returns 1 --check
for how in '--method gauss' '--method dop853' '--method rkf45' '--tol 1e-5' '--tol 1e-15' '--set mu=1e-4'; do
    expect 3 'a rate jumps on the way' jellett lyapunov ./dry.tt --section x=0 --start v=3 --returns 1 $how
done
# Long steps of loose tolerances are rejected at a jump, and it is looked for in the shorter ones that follow.
for how in '--tol 1e-3' '--tol 1e-4 --set mu=0.1' '--tol 1e-5 --set mu=0.03' '--tol 1e-6 --set mu=1e-2' \
    '--tol 1e-8 --set mu=1e-4'; do
    for method in gauss dop853; do
        expect 3 'a rate jumps on the way' jellett lyapunov ./dry.tt --section x=0 --start v=3 --returns 1 $how --method $method
    done
done
for command in 'orbits --period 1' 'continue --along mu=0.4:0.6'; do
    expect 3 'a rate jumps on the way' jellett $command ./dry.tt --section x=0 --start v=3
done
for tolerance in 1e-6 1e-12; do
    expect 0 '^3,,' jellett lyapunov ./dry.tt --section x=0 --grid v=3:4:2 --returns 1 --tol $tolerance
done
# What turns quickly, but smoothly, does not jump: its exponents do not depend on the tolerance.
printf '%s\n' 'model rippled' 'param n > 0' 'default n = 300' 'state x' 'state v' 'angle c s = cos(n*x) sin(n*x)' 'eq x = v' \
    'eq v = - x - s' > rippled.tt
printf '%s\n' 'model wall' 'state x' 'state v' 'root a = sqrt((x - 1/3)^2)' 'eq x = v' 'eq v = - x - 30*(x - 1/3 + a)' > wall.tt
for model in rippled wall; do
    for v in 0.4 1 2 2.9; do
        for tolerance in 1e-5 1e-8 1e-12; do
            expect 0 '^3,' jellett lyapunov ./$model.tt --section x=0 --start v=$v --returns 3 --tol $tolerance
        done
    done
done
# What is smoothed differs from the oracle by terms of the order of sqrt(soft).
for soft in 1e-12 1e-20; do
    for given in '--start v=3' '--grid v=3:3:1'; do
        expect 0 '' jellett lyapunov ./dry.tt --section x=0 $given --returns 1 --set soft=$soft
        awk -F, -v v="$image" '/^[13],/ { slope = exp($1 == 1 ? $3*$2 : $2*$3); found = 1 }
            END { d = slope - (sqrt(9.25) - 2)/v*3/sqrt(9.25); exit !(found && d^2 < 1e-12) }' out || fail "$soft: $(cat out)"
    done
done
# Where a rate bends, as at a stop with play, tangent vectors have rates that jump. At the tightest tolerances steps across are as
# short as time resolves, and are taken. Oracle: lengths scale with the force, so that all orbits of the branch are one.
cat > stop.tt <<'TABLE'
model stop
param k > 0
param F
default k = 50, F = 1
state x
state v
state phi
root a = sqrt(x^2)
angle c s = cos(phi) sin(phi)
eq x = + v
eq v = - x - k*(x + a)/2 - v/10 + F*c
eq phi = + 3/2
periodic phi = 2*pi
TABLE
for method in gauss dop853; do
    expect 0 'the range ends' jellett continue ./stop.tt --section phi=0 --start x=0.2,v=1.5 --along F=1:1.5 --method $method
    awk -F, '/^0,/ { rows++; bad += ($5/$2 - 0.21420765261538)^2 > 1e-24 || ($8 - 0.90687719831011)^2 > 1e-22 }
        END { exit !(rows > 5 && !bad) }' out || fail "$method: not one orbit, scaled: $(grep ^0 out | cut -d, -f2,5,8 | head -3)"
done
for x in 0.02 0.18 0.35 0.38 0.4 0.43; do
    for tolerance in 1e-13 1e-14; do
        expect 0 '^3,' jellett lyapunov ./stop.tt --section phi=0 --start x=$x,v=1 --returns 3 --tol $tolerance
    done
done
# So are jumps of a rate. Oracle: half circles about -1/2 while x rises, about 1/2 while it falls; in the time 1 it turns four
# times.
printf '%s\n' 'model block' 'state x' 'state v' 'root r = sqrt(v^2)' 'eq x = + v' 'eq v = - 100*x - 50*v/r' > block.tt
for x in 5.3 5.6 5.9; do
    for method in gauss dop853; do
        expect 0 '' jellett simulate ./block.tt --start x=$x,v=0.1 --times 1 --tol 1e-15 --method $method
        tail -1 out | awk -F, -v x=$x '{
            pi = atan2(0, -1); top = sqrt((x + 1/2)^2 + 1e-4) - 1/2; begun = atan2(0.01, x + 1/2)
            exit !(($2 - (-1/2 - (top - 7/2)*cos(10 - begun - 3*pi)))^2 < 1e-24) }' || fail "a block, $method: $(tail -1 out)"
    done
done
# Where the domain ends at the jump, and an orbit only passes there, parts of steps across it need not be solved: shorter steps are.
# Oracle: the orbit itself, at 1e-15.
cat > forced.tt <<'TABLE'
model forced
state x
state v
state phi
domain moves : v^2 > 0
root r = sqrt(v^2)
angle c s = cos(phi) sin(phi)
eq x = + v
eq v = - x - v/r/5 + c - v/10
eq phi = + 6/5
periodic phi = 2*pi
TABLE
for tolerance in 1e-10 1e-12; do
    expect 0 '^35,30,.*,alive$' jellett section ./forced.tt --section phi=0 --grid x=-3:3:6,v=-3:3:6 --returns 30 --tol $tolerance
    ! grep -q no_convergence out || fail "a pass, $tolerance: $(grep no_convergence out)"
    awk -F, '/^1,2,/ { exit !(($4 + 0.47560081972464)^2 + ($5 - 1.66087104895163)^2 < 1e-18) }' out ||
        fail "a pass, $tolerance: $(grep '^1,2,' out)"
done
# A quick phase turns a rate by a hundred-thousandth, of which a step's stages see little. Where steps prove to err, an orbit is
# followed alone from its start: a return that its lane has made counts no more, lest DP be that of two.
printf '%s\n' 'model quick' 'state x' 'state y' 'state phi' 'state z' 'angle c s = cos(phi) sin(phi)' 'angle C S = cos(z) sin(z)' \
    'eq x = y' 'eq y = -x + x^3/5 + c/10 + C*x/100000' 'eq phi = 1' 'eq z = 40' 'periodic phi = 2*pi' 'periodic z = 2*pi' > quick.tt
for method in '' '--method gauss'; do
    expect 0 '^119,2,' jellett section ./quick.tt --section y=0 --grid x=-1:1:20,phi=-0.5:0.5:3,z=0:3:2 --returns 2 --tol 1e-9 \
        --check --threads 1 $method
    grep 'alive' out | cut -d, -f1,2,8 > "traces${method#* }"
done
paste -d, traces tracesgauss |
    awk -F, '$2 > 0 && ($3 - $6)^2 > 1e-12*(1 + $6^2) { print $1, $2, $3, $6; bad = 1 } END { exit bad }' > off ||
    fail "traces of DP in lanes and alone: $(head -3 off)"
exit $status
