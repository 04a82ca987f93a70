#!/usr/bin/env bash
# Conditions of a table's `domain`: starts and parameters outside are refused, and orbits end where a condition, or an interval,
# does: at the time of the closed form, also where they would be back within one step; one at a time by every method, and in lanes.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
methods="gauss dop853 taylor rk8pd rkf45 msadams"
refuses() { # TEXT COMMAND...: status 3, and this text
    local text=$1
    shift
    jellett "$@" > out 2> err
    [ $? -eq 3 ] && grep -qF -- "$text" err || fail "jellett $* does not say '$text': $(cat err)"
}
ends() { # COMMAND-NAME FILE COLUMN-OF-T TIME ALLOWED: the last row is that of an orbit that has left the domain at this time
    tail -1 "$2" | awk -F, -v c="$3" -v t="$4" -v e="$5" '/left_domain/ { off = $c - t; ok = off*off <= e*e } END { exit !ok }' ||
        fail "$1 does not end at $4: $(tail -1 "$2")"
}

says() { # WHAT TEXT: in the file err
    grep -qF -- "$2" err || fail "$1 does not say '$2': $(cat err)"
}

# u = cos t dips below -(1 - depth) for 2 arccos(1 - depth), which steps of a smooth motion pass over.
motion='state v
eq u = v
eq v = - u
eq z = w
eq w = - z'
table() { # NAME STATE-U CONDITION
    printf 'model %s\nparam depth\nparam top\ndefault depth = 1e-6, top = 2\nstate z\nstate w\n%s\n%s\n%s\n' "$1" "$2" "$3" \
        "$motion" > "$1.tt"
}
table linear 'state u' $'domain above : 1 - depth + u > 0\ndomain order : top - depth - 1 > 0'
table curved 'state u' 'domain above : (1 - depth)^2 - u^2 + 3*(1 + u) > 0'
table between 'state u in (-0.999999, 3)' 'domain trivial : 4 - u > 0'
table moving 'state u in (depth - 1, pi)' '' # ends that are no numbers

refuses "--start: outside the domain of linear: above needs 1 - depth + u > 0, and it is -0.500001 here" \
    simulate ./linear.tt --start u=-1.5,v=0,z=0,w=1 --times 1
refuses "--start: outside the domain of moving: u needs -depth + u + 1 > 0, and it is -0.500001 here" \
    simulate ./moving.tt --start u=-1.5,v=0,z=0,w=1 --times 1
refuses "outside the domain of linear: above needs 1 - depth + u > 0, and it is -0.500001 here" \
    section ./linear.tt --section z=0 --start u=-1.5,v=0,w=1
refuses "outside the domain of linear: above needs 1 - depth + u > 0, and it is -1.000001 here" eigen ./linear.tt \
    --at u=-2,v=0,z=0,w=0
for command in "simulate --start u=1,v=0,z=0,w=1 --times 1" "section --section z=0 --start u=1,v=0,w=1" \
    "eigen --at u=0,v=0,z=0,w=0"; do
    refuses "parameters: outside the domain of linear: order needs top - depth - 1 > 0, and it is -0.500001 here" \
        ${command%% *} ./linear.tt --set top=0.5 ${command#* }
done
# What the equations divide by is not zero, also where kernels cancel it; of any size otherwise.
divides() { # NAME DIVISOR
    printf 'model %s\nparam w\ndefault w = -3/10\nroot r = sqrt(w^2)\nstate x\nstate y\n%s\neq x = y*(%s)/(%s)\neq y = - x\n' "$1" \
        'domain some : w^2 > 0' "$2" "$2" > "$1.tt"
    jellett simulate ./"$1".tt --start x=1,y=0 --times 1 > rows.csv 2> err || fail "$1 is refused at w = -0.3: $(cat err)"
}
for divisor in 'r - w' '(r - w)*(x^2 + 2)' 'r^2 - (w + 1)^2 + (2*r + 1)'; do
    divides divided "$divisor"
    for command in "simulate --start x=1,y=0 --times 1" "section --section y=0 --start x=1" "eigen --at x=0,y=0"; do
        refuses " != 0, and it is" ${command%% *} ./divided.tt --set w=0.3 ${command#* }
    done
done
divides small 'r - w + x'
refuses "--start: outside the domain of small: a division needs -w + r + x != 0, and it is 0 here" \
    simulate ./small.tt --set w=0.3 --start x=0,y=1 --times 1
jellett simulate ./small.tt --set w=1e-150 --start x=1e-155,y=0 --times 1 > rows.csv 2> err || fail "small numbers: $(cat err)"
# Nor is what roots and logarithms divide by, whether or not anything uses them.
for unused in 'root r = sqrt(1/x^2)' 'log l = log(1/x^2)'; do
    printf 'model unused\nstate x\nstate y\n%s\neq x = y\neq y = - x\n' "$unused" > unused.tt
    refuses "--start: outside the domain of unused: a division needs x != 0, and it is 0 here" \
        simulate ./unused.tt --start x=0,y=1 --times 1
done
# A root that divides is zero where its radicand is.
for root in 'v != 0|v^2|v/r' 'x^2 + v^2 != 0|x^2 + v^2|x/r^3'; do
    IFS='|' read -r condition radicand term <<< "$root"
    printf 'model rooted\nstate x\nstate v\nroot r = sqrt(%s)\neq x = v\neq v = - x - %s\n' "$radicand" "$term" > rooted.tt
    refuses "--start: outside the domain of rooted: a division needs $condition, and it is 0 here" \
        simulate ./rooted.tt --start x=0,v=0 --times 1
    jellett simulate ./rooted.tt --start x=1e-9,v=1e-9 --times 1e-12 > rows.csv 2> err || fail "rooted: $(cat err)"
done
# Near a place that is not 0 its distance is far above rounding, though the square of that is not.
for y in 1e-9 1e-10 1e-14; do
    jellett simulate restricted_three_body --start x=-0.012277471,y=$y,vx=0,vy=0 --times 0 > rows.csv 2> err ||
        fail "beside a body, y=$y: $(cat err)"
done
refuses "--start: outside the domain of restricted_three_body: a division needs" \
    simulate restricted_three_body --start x=0.987722529,y=0,vx=0,vy=0 --times 0
# Of an angle the divisor counts, whichever of its two names the equations use.
for part in c s; do
    printf 'model turned\nstate x\nstate y\nangle c s = cos(1/x) sin(1/x)\neq x = 0\neq y = %s\n' $part > turned.tt
    refuses "--start: outside the domain of turned: a division needs x != 0, and it is 0 here" \
        simulate ./turned.tt --start x=0,y=1 --times 1
done
printf 'model zero\nstate x\nlet d = 0\neq x = x/d\n' > zero.tt
refuses "the equations divide by what is zero everywhere" simulate ./zero.tt --start x=1 --times 1
# Nor is what integrals and densities divide by, where it is made of parameters: what is prepared of these is shared.
shared='state x\nstate y\neq x = y\neq y = - x\nintegral F = (x^2 + y^2)/(a - b)\n'
shared+='integral G = (x^2 + y^2)^2/(x^2 + y^2)\nmeasure rho = 1/a^2\n'
printf "model shared\nparam a\nparam b\ndefault a = 2, b = 1\n$shared" > shared.tt
for command in "simulate --start x=1,y=0 --times 1" "section --section y=0 --start x=1" "eigen --at x=1,y=0"; do
    refuses "parameters: outside the domain of shared: the integral F needs a - b != 0, and it is 0 here" \
        ${command%% *} ./shared.tt --set b=2 ${command#* }
    refuses "parameters: outside the domain of shared: the measure rho needs a != 0, and it is 0 here" \
        ${command%% *} ./shared.tt --set a=0 ${command#* }
done
# Also where factors and terms show that they vanish with a parameter. What has no value for another reason is said to have none.
printf '%s\n' 'model sums' 'param a' 'param b' 'param c' 'default a = 2, b = 0, c = 0' 'state x' 'state y' 'let d = a*x^2 + a' \
    'eq x = y' 'eq y = - x' 'integral F = (x^2 + y^2)*(1 + x^2)/d' 'integral G = 1/(b*(x^2 + y^2) + c)' > sums.tt
refuses "parameters: outside the domain of sums: the integral F needs a != 0, and it is 0 here" \
    simulate ./sums.tt --set a=0 --start x=1,y=0 --times 1
jellett simulate ./sums.tt --start x=1,y=0 --times 0,1 > rows.csv 2> err || fail "sums: $(cat err)"
grep -q 'G has no value by t = 1 .*: its drift is empty' err || fail "sums: $(cat err)"
jellett simulate ./shared.tt --start x=0,y=1 --times 1 > rows.csv 2> err && grep -qF "'rho' divides by the parameter 'a'" err ||
    fail "shared: $(cat err)"
# That a parameter may be 0 is not said where a domain record speaks of it; whether it may is then what the claim says.
printf "model shared\nparam a\nparam b > 0\ndefault a = 2, b = 1\n${shared}observe q = x/a\ndomain order : a - b > 0\n" > shared.tt
ttc prove shared.tt > proofs 2>&1 && ! grep -q 'may be 0' proofs && grep -q 'proved  *observe  *q' proofs ||
    fail "shared: $(cat proofs)"
sed 's/a - b > 0/a + b > 0/' shared.tt > weaker.tt
ttc prove weaker.tt > proofs 2>&1
grep -q 'refuted  *observe  *q' proofs || fail "weaker: $(cat proofs)"
# What follows from an interval has no kernel.
ttc cost --json between.tt > cost.json 2> err
grep -q domain_values cost.json && fail "a condition that follows from an interval has a kernel"
ttc cost --json linear.tt | grep domain_gradients > /dev/null || fail "a condition has no kernel"

named() { # MODEL: what ends its orbits
    case $1 in
    linear) echo "above needs 1 - depth + u > 0" ;;
    between) echo "u is at the end -0.999999 of its interval" ;;
    moving) echo "u needs -depth + u + 1 > 0" ;;
    esac
}

# The state errs by tolerances, 1e-12, of which ten are allowed, and is at the end of an interval from 2^-37 of it on; both divided
# by the rate at which it comes there, 1.4e-3.
allowed=1.2e-8
time=$(awk 'BEGIN { d = 1e-6; printf "%.15g", atan2(0, -1) - atan2(sqrt(2*d - d*d), 1 - d) }')
for method in $methods; do
    for model in linear between moving; do
        for sign in "" -; do
            jellett simulate ./$model.tt --start u=1,v=0,z=0,w=1 --times "${sign}1,${sign}20" --method $method > rows.csv 2> err
            ends "simulate $model $method" rows.csv 1 "$sign$time" $allowed
            says "simulate $model $method" "the orbit comes to the edge of the domain of $model: $(named $model)"
        done
    done
    # The condition is u^2's too: (1 - depth)^2 - u^2 + 3 (1 + u) = 0 at a u near -1 + depth/5.
    jellett simulate ./curved.tt --start u=1,v=0,z=0,w=1 --times 1,20 --method $method > rows.csv 2> err
    ends "simulate curved $method" rows.csv 1 "$(awk 'BEGIN { d = 1e-6; q = 1 - d; u = (3 - sqrt(9 + 4*(q*q + 3)))/2
                                                       printf "%.15g", atan2(sqrt(1 - u*u), u) }')" 2e-8
    # A dip that ends as far above is none.
    jellett simulate ./linear.tt --set depth=-1e-6 --start u=1,v=0,z=0,w=1 --times 1,20 --method $method > rows.csv 2> err
    tail -1 rows.csv | grep -q '^20,.*,alive$' || fail "$method ends an orbit that stays inside: $(tail -1 rows.csv)"
done

# Where parameters have units motions are counted in units of their own, in which intervals lie elsewhere: x = 5 cos t comes to -3
# at arccos(-3/5), whatever L is, which chooses the unit of length: L/2 or more. It is there from 1e-12 of max(3, that unit) on, at
# a rate of 4.
printf 'model lengths\nparam L > 0 [m]\nparam k > 0 [1/s]\ndefault L = 1, k = 1\nstate x in (-3, 3000) [m]\nstate v [m/s]
eq x = v\neq v = - k^2*x\n' > lengths.tt
for length in 1 1000 1/1000; do
    for method in $methods; do
        jellett simulate ./lengths.tt --set L=$length --start x=5,v=0 --times 1,4 --method $method > rows.csv 2> err
        ends "simulate lengths $length $method" rows.csv 1 2.214297435588181 2.5e-10
        says "simulate lengths $length $method" "the domain of lengths: x is at the end -3 of its interval"
    done
done

# In a time that lifts a root, which keeps orbits from the pole, the other intervals end them.
printf 'model lifted\nparam top\ndefault top = 0.5\nstate x in (-1, 1)\nstate u in (-2, top)\nstate z in (-3, 0.25)\n'\
'root s = sqrt(1 - x^2)
eq x = s^2/2\neq u = 1\neq z = - 1\ntime slow : s lifting s\npole x\n' > lifted.tt
jellett plan simulate ./lifted.tt --start x=0,u=-1,z=0 --times 1 | grep -E '^  \* .*lifted in slow' > /dev/null ||
    fail "lifted is not computed in its time"
for method in $methods; do
    jellett simulate ./lifted.tt --start x=0,u=-1,z=0 --times 1,2 --method $method > rows.csv 2> err
    ends "simulate lifted $method" rows.csv 1 1.5 1e-11
    says "simulate lifted $method" "the domain of lifted: u needs top - u > 0"
    jellett simulate ./lifted.tt --start x=0,u=-1,z=0 --times -0.1,-1 --method $method > rows.csv 2> err
    ends "simulate lifted $method" rows.csv 1 -0.25 1e-11
    says "simulate lifted $method" "the domain of lifted: z needs -z + 1/4 > 0"
    jellett section ./lifted.tt --section x=0.9 --start u=-1,z=0 --start u=-1.1,z=0 --method $method > rows.csv 2> err
    ends "section lifted $method" rows.csv 3 1.6 1e-11
done
jellett section ./lifted.tt --section x=0.9 --start u=-1,z=0 --start u=-1.1,z=0 > rows.csv 2> err
ends "section lifted, in lanes" rows.csv 3 1.6 1e-11

# A condition of `valid` that is lost as shortly is told by simulate, with its time and depth.
table short 'state u' 'valid contact : 1 - depth + u > 0'
for method in gauss dop853 taylor rk8pd msadams; do
    jellett simulate ./short.tt --start u=1,v=0,z=0,w=1 --times 2,4 --method $method > rows.csv 2> err
    grep -q '^4,.*,lost_contact$' rows.csv && grep -qE 'contact is lost at t = 3.14017(8|9).*least value -(9.99|1e-06)' err ||
        fail "simulate $method does not tell a short loss: $(cat rows.csv err)"
done
# Its depth is that at t = pi, u = -1, between the ends of steps, when it is lost for longer than a step as well.
table long 'state u' 'valid contact : 1/2 + u > 0'
for method in gauss dop853 taylor rk8pd rkf45 msadams; do
    jellett simulate ./long.tt --start u=1,v=0,z=0,w=1 --times 6 --method $method > rows.csv 2> err
    grep -qF 'contact is lost at t = 2.094395102 (least value -0.5)' err || fail "depth, $method: $(cat rows.csv err)"
done

# And by section, one orbit at a time as in lanes: u = A cos(t + 1) passes -1 + depth where A does, far from the section z = 0 and
# from the ends of steps.
starts=()
for a in 0.5 0.9999989 0.9999995 1 1.1; do
    starts+=(--start "$(awk -v a=$a 'BEGIN { printf "u=%.17g,v=%.17g,w=1", a*cos(1), -a*sin(1) }')")
done
for how in "" "--tol 1e-8" "--tol 1e-5" "--method gauss" "--method dop853" "--method taylor" "--method rkf45"; do
    for lanes in 2 4 8; do
        JELLETT_LANES=$lanes jellett section ./short.tt --section z=0 --direction down --returns 2 --contact report \
            $how "${starts[@]}" > rows.csv 2> err
        grep -v '^#' rows.csv | awk -F, '$2 == 2 { lost = lost ($8 <= 0) } END { exit lost != "00111" }' &&
            grep -q '3 of 5 orbits lose' err ||
            fail "section $how in $lanes lanes does not tell short losses: $(cat rows.csv err)"
    done
done

# Where the field grows beyond bounds methods give up just before the end: x" = 1/(1 - x) from rest at 0 is there at sqrt(pi/2).
printf 'model wall\nstate x\nstate p\ndomain before : 1 - x > 0\neq x = p\neq p = 1/(1 - x)\n' > wall.tt
for method in $methods; do
    jellett simulate ./wall.tt --start x=0,p=0 --times 1,2 --method $method > rows.csv 2> err
    ends "simulate wall $method" rows.csv 1 1.2533141373155003 1.3e-8
    says "simulate wall $method" "the domain of wall: before needs 1 - x > 0"
done
# Where some points of a sweep are outside, the others have their rows, and the status is 0.
leaves() { # TEXT COMMAND...: status 0, and this text
    jellett "${@:2}" > out 2> err && grep -qF -- "$1" err || fail "jellett ${*:2} does not say '$1', with status 0: $(cat err)"
}
leaves "--sweep: at top=0.5: outside the domain of linear: order needs top - depth - 1 > 0" \
    fates ./linear.tt --section z=0 --start u=0,v=0.5,w=1 --returns 1 --sweep top=2:0.5:2
grep -v '^#' out | cut -d, -f1,2 | paste -sd ' ' | grep -qx 'top,starts 2,1 0.5,0' ||
    fail "rows of a sweep that leaves the domain: $(cat out)"
leaves "--sweep: at m=-1, g=0: m = -1: spherical_top_level needs m > 0" fates --grid 3x3 --returns 1 --sweep m=-1:1:3,g=0:1:2
grep -q '4 of 6 points are outside' err && [ "$(grep -c '^[-01]*,[01],[09],' out)" -eq 6 ] ||
    fail "a sweep of masses: $(cat out err)"
leaves "2 of 3 points refused; the first: m = -1 is no value" eigen --set a3=0 --at gamma3=0.3,omega3=1 --sweep m=-1:1:3
refuses "3 of 3 points refused; the first: m = -3 is no value" eigen --set a3=0 --at gamma3=0.3,omega3=1 --sweep m=-3:-1:3
rod=(rod --start gamma3=0.2,v_nu=0.6,omega_tau=0.4,omega_n=1,omega3=0)
leaves "2 of 3 points have no values" "${rod[@]}" --sweep m=-1:1:3
refuses "3 of 3 points have no values" "${rod[@]}" --sweep m=-3:-1:3
leaves "1 of 1 points have no values" "${rod[@]}" --sweep m=-1:1:3@0:1

# Orbits of other amplitudes: those of A > 1 - depth leave, at arccos(-(1 - depth)/A); in lanes as one at a time.
starts=()
for a in 0.5 0.9999989 0.9999995 1 1.1 2; do starts+=(--start "u=$a,v=0,w=1"); done
for model in linear between moving; do
    for how in "" "--method gauss"; do
        jellett section ./$model.tt --section z=0 --direction down --returns 3 $how "${starts[@]}" > rows.csv 2> err ||
            fail "section: $(cat err)"
        grep -v '^#' rows.csv | grep left_domain | cut -d, -f1-3 | awk -F, -v from=2 '
            BEGIN { split("0.5 0.9999989 0.9999995 1 1.1 2", A, " "); b = 1 - 1e-6 }
            { a = A[$1 + 1]; off = $3 - (atan2(0, -1) - atan2(sqrt(a*a - b*b), b));
            if (off*off > (2^-37 + 1e-11)^2/(a*a - b*b) || $2 != 1) bad = 1; n++ }
            END { exit bad || n < 3 }' || fail "section $model ${how:-in lanes}: $(grep left_domain rows.csv)"
        grep -q '^0,3,.*alive' rows.csv && grep -q '^1,3,.*alive' rows.csv ||
            fail "section $model ${how:-in lanes} ends an orbit inside"
    done
done
# A condition may also end at a pole, where it grows without bound and comes back negative: 2 + tan p at pi/2, 1/(y^2 - 1)
# where y = 3 e^(-t/10) is 1, at 10 log 3. The tolerance, 1e-12, is that of a step relative to its states; there are ten steps or
# less. Steps of the other methods, which have no polynomial of their own, pass over all of tan.
printf 'model tangent\nstate p\nangle C S = cos(p) sin(p)\ndomain d : S/C + 2 > 0\neq p = 1\n' > tangent.tt
printf '%s\n' 'model inverse' 'state y' 'state z' 'state w' 'domain d : 1/(y^2 - 1) > 0' 'eq y = -y/10' \
    'eq z = w' 'eq w = -z' > inverse.tt
for method in gauss dop853 taylor; do
    jellett simulate ./tangent.tt --method $method --start p=0 --times 5 > rows.csv 2> err
    ends "tangent $method" rows.csv 1 1.5707963267948966 1e-11
done
for method in $methods; do
    jellett simulate ./inverse.tt --method $method --start y=3,z=0,w=1 --times 20 > rows.csv 2> err
    ends "inverse $method" rows.csv 1 10.986122886681098 1e-10
done
# So do the model's conditions, of which orbits go on.
sed 's/^domain/valid/' inverse.tt > held.tt
for method in $methods; do
    jellett simulate ./held.tt --method $method --start y=3,z=0,w=1 --times 20 > rows.csv 2> err
    says "held $method" "d is lost at t = 10.98612289 "
done
for how in "" "--method gauss"; do
    jellett section ./inverse.tt --section z=0 $how --start y=3,w=1 --returns 4 > rows.csv 2> err
    ends "inverse ${how:-in lanes}" rows.csv 3 10.986122886681098 1e-10
    jellett section ./held.tt --section z=0 $how --contact end --start y=3,w=1 --returns 4 2> err |
        sed s/lost_d/left_domain/ > rows.csv
    ends "held ${how:-one at a time}" rows.csv 3 10.986122886681098 1e-10
done
# Zeros and poles of higher order, which are small long before: x = t ends at 1 within the tolerance of a step, no longer than 1.
for condition in '(1 - x)^3' '(1 - x)^5' '1/(1 - x)^3' '(1 - x)*(2 - y)'; do
    printf 'model high\nstate x\nstate y\neq x = 1\neq y = -y\ndomain high : %s > 0\n' "$condition" > high.tt
    for method in $methods; do
        jellett simulate ./high.tt --start x=0,y=1 --times 2 --method "$method" > rows.csv 2> err
        ends "$condition by $method" rows.csv 1 1 2e-12
    done
done
# Of so high an order that the polynomial has zeros of its own: approaches end by their number, 30; and a condition that only fades.
printf 'model high\nstate x\neq x = 1\ndomain high : 1/(1 - x)^31 > 0\n' > high.tt
printf 'model fades\nstate x\neq x = 1\ndomain high : 1/(1 + x)^33 > 0\n' > fades.tt
for method in $methods; do
    jellett simulate ./high.tt --start x=0 --times 2 --method "$method" > rows.csv 2> err
    ends "a pole of order 31 by $method" rows.csv 1 1 1e-9
    jellett simulate ./fades.tt --start x=0 --times 2 --method "$method" --tol 1e-3 > rows.csv 2> err ||
        fail "what fades ends an orbit by $method: $(cat err)"
done
# A 'valid' one is lost at 1, to the ten digits that are said.
printf 'model lost\nstate x\nstate y\neq x = 1\neq y = -y\nvalid high : (1 - x)^3 > 0\n' > lost.tt
for method in $methods; do
    jellett simulate ./lost.tt --start x=0,y=1 --times 2 --method "$method" > rows.csv 2> err
    says "a loss of third order by $method" 'high is lost at t = 1 ('
done
# So is one on the way to infinity, x = 1/(1 - t), where steps are long and their polynomials err by more than the steps.
printf 'model bursts\nparam X\ndefault X = 2\nstate x\neq x = x^2\nvalid low : X - x > 0\n' > bursts.tt
for method in $methods; do
    for X in 2 5; do
        jellett simulate ./bursts.tt --set X=$X --start x=1 --until 2 --method "$method" > rows.csv 2> err
        says "a loss before x is infinite by $method" "low is lost at t = $(awk -v X=$X 'BEGIN { print 1 - 1/X }') ("
    done
done
# A dip about a zero of high order, cos t < 1/5 and cos t < 3/10 from arccos on: no polynomial of degree 12 shows it on a long step.
printf 'model slit\nstate x\nstate y\neq x = y\neq y = -x\ndomain apart : x^16 - (1/5)^16 > 0\n' > slit.tt
sed 's/^domain/valid/; s/: .*/: x^20 - (3\/10)^20 > 0/' slit.tt > narrow.tt
for method in $methods; do
    jellett simulate ./slit.tt --start x=1,y=0 --times 2.5 --method "$method" > rows.csv 2> err
    ends "a slit by $method" rows.csv 1 1.3694384060045657 1e-11
    jellett simulate ./narrow.tt --start x=1,y=0 --times 2.5 --method "$method" > rows.csv 2> err
    says "a narrow slit by $method" 'apart is lost at t = 1.266103673 ('
done
# A fall from rest at distance 1 into a centre of force: the condition is positive beyond its zero, as it is a square.
printf '%s\n' 'model plunge' 'state x' 'state y' 'state p' 'state q' 'domain apart : x^2 + y^2 > 0' 'root r = sqrt(x^2 + y^2)' \
    'eq x = p' 'eq y = q' 'eq p = -x/r^3' 'eq q = -y/r^3' > plunge.tt
for method in $methods; do
    jellett simulate ./plunge.tt --start x=0.6,y=0.8,p=0,q=0 --times 2 --method "$method" > rows.csv 2> err
    ends "a fall by $method" rows.csv 1 1.1107207345395915 1e-11
    says "a fall by $method" 'apart needs x^2 + y^2 > 0'
done
jellett fates ./plunge.tt --section p=0 --direction down --grid x=0.6,y=0.8:0.8:2,q=0 --returns 3 > rows.csv 2> err
ends "a fall in lanes" rows.csv 5 1.1107207345395915 1e-11
exit $status
