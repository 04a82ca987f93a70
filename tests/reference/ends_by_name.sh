#!/usr/bin/env bash
# Every orbit ends by a name and a time, in its own row, whatever the method: at rest, at a pole, where its coordinates end, or by a
# failure of the method; and every field is a number or empty.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
set -e

# run STATUS ARGUMENTS...: jellett's table in $scratch/out, its words in $scratch/err; fields that are neither numbers nor names
# fail.
run() {
    local want=$1 got=0
    shift
    jellett "$@" > "$scratch/out" 2> "$scratch/err" || got=$?
    [ "$got" = "$want" ] || fail "$*: status $got, not $want: $(tail -1 "$scratch/err")"
    ! grep -v '^#' "$scratch/out" | tr ', ' '\n\n' | grep -qE '^[-+]?(nan|inf)' || fail "$*: a field that is no number"
    ! tr '=, (' '\n\n\n\n' < "$scratch/err" | grep -qE '^[-+]?(nan|inf)' || fail "$*: says a number that is none"
}
last() { tail -1 "$scratch/out" | awk -F, "{ print \$$1 }"; }
near() { awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { d = a - b; if (d < 0) d = -d; exit !(a != "" && b != "" && d <= t) }'; }

# What begins at an equilibrium (spin without weight) stays there to the last bit, by every method, however far it goes.
for tier in five five_plain; do
    for method in gauss dop853 taylor rk8pd rkf45 msadams; do
        run 0 simulate --set g=0 --start gamma3=-0.25,v_nu=-0.125,omega_tau=0,omega_n=0,omega3=-0.75 --tier $tier --method $method \
            --times 0,1,1e6
        [ "$(tail -1 "$scratch/out" | cut -d, -f 1-4)" = "1000000,-0.25,-0.125,0" ] ||
            fail "$tier, $method: an equilibrium moves: $(tail -1 "$scratch/out")"
    done
done

# A balanced sphere spirals into an equilibrium (4.4). The row has the limit, which all methods agree on to the error of twenty
# returns, a thousand tolerances at most.
spiral=(--set a3=0 --level E=1,G=-0.3 --start eta=-0.5235987755982987,gamma3=-0.066 --returns 100)
for how in "--method gauss" "--method dop853" "--method taylor" "--method rk8pd" "--method rkf45" "--method msadams" \
    "--start eta=1,gamma3=0.3"; do
    run 0 section "${spiral[@]}" $how
    grep -E '^(o|0,)' "$scratch/out" > "$scratch/first" && mv "$scratch/first" "$scratch/out"
    [ "$(last 9)" = equilibrium ] || fail "spiral, $how: ends by '$(last 9)'"
    near "$(last 5)" -0.673987147562 1e-9 || fail "spiral, $how: limit gamma3 = $(last 5)"
    near "$(last 7)" 0 1e-9 || fail "spiral, $how: omega_n = $(last 7)"
done
# At a loose tolerance, by methods that step at their limit of stability and hold the orbit at some tolerances: at rest all the
# same.
stiff=(--set m=0.046734604353749626,R=22.446218763535271,g=0.025455591964824414,I1=0.29057800922835364,I3=0.29057800922835364,a3=0
    --level E=0.0039105511413038392,G=0.9313121078740304 --start eta=1.8457677938053836,gamma3=-0.99999999261361949 --tol 1.67e-06)
for method in gauss dop853 taylor rk8pd rkf45 msadams; do
    run 0 section "${stiff[@]}" --direction both --backward --method $method
    [ "$(last 9)" = equilibrium ] || fail "stiff spiral, $method: ends by '$(last 9)'"
done
# At an equilibrium of nobody's attraction, at rest: the start alone.
run 0 section --set a3=0,g=0,I1=1/3,I3=1/3 --level E=0.5,G=0 --start eta=pi,gamma3=0.3 --returns 5
run 0 fates --set a3=0 --level E=1,G=-0.3 --start eta=-0.5235987755982987,gamma3=-0.066
[ "$(last 3)" = equilibrium ] && near "$(last 6)" 0 1e-9 || fail "fates of the spiral: $(tail -1 "$scratch/out")"

# Balanced spheres of all kinds (masses, radii, inertias, levels; no gravity, G = 0): no start takes another's row away.
awk 'BEGIN { srand(7); for (k = 0; k < 10; k++) {
    m = 10^(2*rand() - 1); R = 10^(rand() - 0.5); I1 = m*R*R*10^(1.8*rand() - 1.5); I3 = I1*(rand() < 0.5 ? 1 : 0.2 + 1.7*rand())
    E = m*10^(3*rand() - 2); G = rand() < 0.2 ? 0 : (2*rand() - 1)*0.9*R*sqrt(2*I1*E)
    printf "m=%.6g,R=%.6g,I1=%.6g,I3=%.6g,g=%d,a3=0 E=%.6g,G=%.6g\n", m, R, I1, I3, k % 2, E, G } }' > "$scratch/spheres"
while read -r set level; do
    run 0 fates --set "$set" --level "$level" --grid 6x4 --returns 60
    [ "$(grep -c '^-\?[0-9]' "$scratch/out")" = 24 ] || fail "$set $level: $(grep -c '^-\?[0-9]' "$scratch/out") of 24 rows"
    run 0 section --set "$set" --level "$level" --grid 6x4 --returns 60
    [ "$(last 1)" = 23 ] || fail "$set $level: in batches the last orbit is $(last 1)"
done < "$scratch/spheres"

# A failure of the method is a row as well: of an orbit that begins where Lorenz's field overflows, beside a good one. The status
# says so at the end.
run 4 section lorenz --section x=0 --start y=1e200,z=1 --start y=1,z=1 --returns 3
grep -q '^0,[01],.*,\(nonfinite\|no_progress\)$' "$scratch/out" || fail "the orbit that fails has no row"
[ "$(last 1),$(last 2),$(last 6)" = 1,3,alive ] || fail "an orbit that fails took the next one away: $(tail -1 "$scratch/out")"
grep -q 'failed on 1 of 2 orbits' "$scratch/err" || fail "the failure is not said: $(cat "$scratch/err")"

# Kernels of a variant end at the poles of the table: with a3 = 0 as simulate says, which gives gamma3 itself.
plane=(--set a3=0 --start gamma3=-0.9,v_nu=-2,omega_tau=-3.5,omega_n=0.3)
run 0 simulate "${plane[@]}",omega3=0.2 --times 0,5
[ "$(last 12)" = pole- ] || fail "a variant's orbit ends by $(last 12)"
for what in "section --returns 9" fates; do
    run 0 $what --section omega3=0.2 --direction both "${plane[@]}"
    grep -q ',pole-\(,\|$\)' "$scratch/out" && ! grep -q 'pole+' "$scratch/out" ||
        fail "$what, a variant: $(tail -1 "$scratch/out")"
done

# What has no limit at a pole, or is not told there, is an empty field.
for how in "section --returns 3" "section --returns 3 --start eta=0.3,gamma3=0.2" fates; do
    run 0 $how --set I3=0 --level E=1,G=0 --start eta=0.3,gamma3=0.2
    grep -q ',pole-' "$scratch/out" || fail "$how, I3 = G = 0: no pole"
done
run 0 simulate --set I3=0 --start gamma3=0.2,v_nu=0.1,omega_tau=0.2,omega_n=0,omega3=0.3 --until 5 --every 1
! grep -q 'not positive' "$scratch/err" || fail "a force that is not known is said not to be positive"
run 0 simulate --set I3=0,a3=0 --start gamma3=-0.9,v_nu=-2,omega_tau=-3.5,omega_n=0,omega3=1 --until 5 --every 1
run 0 simulate --set a3=-1 --start gamma3=0.3,v_nu=-0.5,omega_tau=1.1,omega_n=0,omega3=0 --until 5 --every 1

run 0 separation --set m=0.42,R=0.5,g=0,I1=0.03,I3=0.014,a3=0.19 --level E=0.043,G=0.0012 --returns 20 \
    --grid eta=-0.5:0.5:4,gamma3=-0.7:-0.5:4
run 0 drift --returns 2 --set a3=0 --level E=1,G=0 --start eta=0.8,gamma3=-0.5 --method gauss
run 0 section --check --set a3=0 --level E=1,G=-0.3 --start eta=-0.5235987755982987,gamma3=-0.066 --returns 3

# Planar motion (omega_n = omega3 = 0) runs into the pole. By the quadrature of the energy, with gamma3 = (g0 - 1)/2 - (g0 + 1)/2
# cos u, t = integral from 0 to pi of sqrt((I1 + m a3^2 s^2)/(2 m g a3 (1 - gamma3))) du, smooth and periodic: 64 points of the
# midpoint rule.
planar=(--start gamma3=0.3,v_nu=0,omega_tau=0,omega_n=0,omega3=0 --times 1,2.1,3)
end=$(awk 'BEGIN { pi = atan2(0, -1); for (k = 0; k < 64; k++) { c = -0.35 - 0.65*cos(pi*(k + 0.5)/64)
    sum += sqrt((1/3 + 0.51^2*(1 - c*c))/(1.02*(1 - c))) } printf "%.15g", sum*pi/64 }')
for tier in level five track; do
    for method in gauss dop853 taylor rk8pd rkf45 msadams; do
        run 0 simulate --tier $tier --method $method "${planar[@]}"
        [ "$(last 10)" = pole- ] && near "$(last 1)" "$end" 1e-10 || fail "planar, $tier, $method: $(tail -1 "$scratch/out")"
    done
done
for tier in full level_plain level_omega_n five_plain model; do # plain time: as near as it can, and no farther
    run 4 simulate --tier $tier "${planar[@]}"
    [ "$(last 10)" = left_domain ] && near "$(last 1)" "$end" 1e-4 || fail "planar, $tier: $(tail -1 "$scratch/out")"
    grep -q 'near a pole' "$scratch/err" || fail "planar, $tier: $(cat "$scratch/err")"
done
# A balanced sphere in planar motion turns evenly: t = (pi/2 - asin gamma3)/omega_tau. In plain time its series runs smoothly
# through the pole, where the field's root changes its sign, and long steps of other methods ask for the field beyond: neither is an
# orbit.
end=$(awk 'BEGIN { g = 0.63; print atan2(sqrt(1 - g*g), g)/10 }')
for tier in level_plain level_omega_n five_plain full; do
    for method in gauss dop853 taylor rk8pd rkf45 msadams; do
        if [ $tier = full ] && [ $method = taylor ]; then continue; fi # no singularity there: it ends at its edge
        run 4 simulate --tier $tier --method $method --tol 4e-6 --set a3=0 --times 0.19,0.38 \
            --start gamma3=0.63,v_nu=0,omega_tau=10,omega_n=0,omega3=0
        [ "$(last NF)" = left_domain ] && near "$(last 1)" "$end" 1e-3 || fail "even, $tier, $method: $(tail -1 "$scratch/out")"
    done
done
run 0 simulate --set a3=0 --start gamma3=0.3,v_nu=-0.5,omega_tau=1.1,omega_n=0,omega3=0 --until 5 --every 5
[ "$(last 12)" = pole+ ] || fail "planar, a3 = 0: $(tail -1 "$scratch/out")"
# With G = 0 and eta = pi/2 the section starts planar motion; the number nearest to pi/2 is pi/2.
run 0 section --set m=1.24736,R=2.86494,g=9.81,I1=0.332387,I3=0.545693,a3=2.47133 --level E=39.5229,G=0 \
    --start eta=1.5707963267948966,gamma3=-0.594
[ "$(last 9),$(last 5)" = pole-,-1 ] || fail "planar on the section: $(tail -1 "$scratch/out")"

# Into a pole with rates of decay far apart, where s is 1e-150 before the rest is known.
run 0 simulate --track --set m=0.67395,R=0.470985,g=0,I1=0.0591889,I3=0.0591889,a3=-1.2053 --until 5 --every 5 \
    --start gamma3=-0.0607461,v_nu=-1.39643,omega_tau=3.62448,omega_n=-0.986603779295012,omega3=-1.73545
tail -1 "$scratch/out" | grep -q ',pole+$' || fail "|a3| > R: $(tail -1 "$scratch/out")"

# The chart without omega3 ends before b = a3 + R gamma3 vanishes: an error of omega3 is there one of omega_n divided by b. It ends
# where I3^2 b^2 (1 + omega3^2) = 2e-6 G^2, nearer than 5e-3 for |G| < 1, and up to there the orbit is that of the level, within a
# tolerance of 1e-12 times a thousand for that and a thousand for steps and conditioning.
for start in v_nu=0,omega_tau=0,omega_n=0.3,omega3=0.2 v_nu=2.4,omega_tau=-1.1,omega_n=0.26,omega3=-0.34 \
    v_nu=1.28,omega_tau=-0.25,omega_n=-1.1,omega3=-0.36 v_nu=0.16,omega_tau=-0.24,omega_n=0.59,omega3=-0.64; do
    run 4 simulate --tier level_omega3 --compare level --start "gamma3=0.3,$start" --until 10 --every 1/20
    [ "$(last 11)" = left_domain ] && near "$(last 2)" -0.51 5e-3 || fail "level_omega3: $(tail -1 "$scratch/out")"
    awk -F, '/^[0-9]/ && $10 != "" && $10 > worst { worst = $10 } END { exit !(worst <= 1e-6) }' "$scratch/out" ||
        fail "level_omega3, $start: off before its end"
    grep -q 'G hardly contains omega3' "$scratch/err" || fail "level_omega3: $(cat "$scratch/err")"
done
run 3 simulate --tier level_omega3 --start gamma3=-0.51,v_nu=1,omega_tau=1,omega_n=0.3,omega3=0.2 --until 10 --every 5
grep -q 'G does not depend on omega3' "$scratch/err" || fail "level_omega3 from b = 0: $(cat "$scratch/err")"

# A level of the balanced sphere without a state. F0 is least where Theta omega3^2 is largest: -0.16 here (I1 = 2/5, I3 = 3/5,
# E = 1, G = 0: M^2 = 2.8 - 2.5 F0, and F0 >= -0.2*0.4 M^2/1.6).
run 3 portrait --set I1=1/2,I3=1/4 --level E=1,G=-0.2,F0=-0.01
grep -q 'no state has these levels' "$scratch/err" || fail "an empty level is not said"
run 3 portrait --set I1=2/5,I3=3/5 --level E=1,G=0,F0=-0.17
run 0 portrait --set I1=2/5,I3=3/5 --level E=1,G=0,F0=-0.15 --orbits 4 --until 2 --trajectories "$scratch/trajectories"
grep -q '^3,' "$scratch/trajectories" || fail "no orbits on a level that is not empty"

# A pole's limits are the orbit's, to ten tolerances: of quadruple precision. What is left of the way decays at two rates, and is
# all but gone at one of them.
for method in gauss dop853 taylor rk8pd rkf45 msadams; do
    run 0 section --set m=12.866166371398588,R=0.14524217514756682,g=9.81,I1=0.45002889890013548 \
        --set I3=2.1321580562758649,a3=-0.094012934376266802 --level E=5.7174220524306136,G=0.020454462471229184 \
        --start eta=-0.36744439882633673,gamma3=-0.32513254690187954 --tol 1.71e-08 --direction down --method $method
    [ "$(last 9)" = pole+ ] && near "$(last 6)" 1.61970498298205 1.7e-7 || fail "two rates, $method: v_nu = $(last 6) at $(last 9)"
done

# Without gravity every command answers.
run 0 section --set g=0 --start eta=0.1,gamma3=-0.6 --returns 3
run 0 section --set g=0 --grid 6x4 --returns 5
run 0 fates --set g=0 --grid 6x4
run 0 orbits --set g=0 --period 1
run 0 eigen --set g=0 --at gamma3=0.3,v_nu=0.7,omega3=1.1
run 0 measure --set g=0,I3=0
run 0 portrait --set g=0 --level E=1,G=-0.2,F0=0.15
run 0 rod --set g=0,I3=0 --start gamma3=0.2,v_nu=0.6,omega_tau=0.4,omega_n=1,omega3=0
run 0 lyapunov --set g=0 --grid 4x3 --returns 3
run 3 lyapunov --set g=0 --returns 3
grep -q 'the orbit ends before it returns' "$scratch/err" || fail "lyapunov, an orbit without a return: $(cat "$scratch/err")"
run 3 drift --returns 9 --start eta=0.1,gamma3=-0.97
grep -q 'the orbit ends before it returns' "$scratch/err" && grep -q '^# taylor: ends by pole+' "$scratch/out" ||
    fail "drift, an orbit without a return: $(cat "$scratch/err")"
for tier in level five track full; do
    run 0 simulate --set g=0 --tier $tier --start gamma3=0.2,v_nu=0.1,omega_tau=0.2,omega_n=0.1,omega3=0.3 --until 2 --every 1
done

# The end of an interval at which a start stands is named, wherever the orbit would go from there.
printf 'model between\nstate z in (-1, 1)\nstate w\neq z = w\neq w = -z\n' > "$scratch/between.tt"
for end in 1 -1; do
    for w in 0 0.1 -0.1; do
        run 4 simulate "$scratch/between.tt" --start "z=$(awk -v e="$end" 'BEGIN { printf "%.14g", e*(1 - 1e-14) }'),w=$w" --times 1
        grep -q "z is at the end $end of its interval" "$scratch/err" || fail "the end $end, w = $w: $(cat "$scratch/err")"
    done
done
# One that is invariant is not told to be reached: x = 1/(1 + exp(-t)) comes as near to 1 as digits tell, and y to its end.
printf 'model logistic\nstate x in (0, 1)\nstate y in (-1, 1)\neq x = x*(1 - x)\neq y = 1/100\n' > "$scratch/logistic.tt"
run 4 simulate "$scratch/logistic.tt" --start x=0.5,y=0 --times 1000
grep -q 'x is at the end 1 of its interval, as near as digits tell: it may never come there' "$scratch/err" ||
    fail "an invariant end: $(cat "$scratch/err")"
run 4 simulate "$scratch/logistic.tt" --start x=0.5,y=0.9 --times 1000
grep -q 'y is at the end 1 of its interval$' "$scratch/err" || fail "an end that is reached: $(cat "$scratch/err")"
exit $status
