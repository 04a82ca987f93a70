#!/usr/bin/env bash
# A row of a section knows of the losses before it, and of no other: not of those on the rest of the step that leads over it. What
# loses a condition for good is lost from that time on, where orbits go on and where they end.
source "$JLT_SOURCE_DIR/tests/scratch.sh"

# The section y = 0 is crossed upwards at pi, 3 pi, 5 pi = 15.708, ...; one condition is lost at z = a, the other between b - c and
# b + c alone, which no end of a step meets.
cat > late.tt <<'T'
model late
param a
param b
param c > 0
default a = 1000, b = 1000, c = 0.001
state x
state y
state z
eq x = y
eq y = - x
eq z = 1
integral H = x^2 + y^2
valid open : a - z > 0
valid dry : (z - b)^2 - c^2 > 0
T
section() { jellett section ./late.tt --section y=0 --start x=1,z=0 --returns 5 "$@" 2> err; }
# The first row with a least value below 0: its number and that value.
lost() { section --contact report "$@" | awk -F, '/^[0-9]/ && $2 > 0 && $7 < 0 { print $2, $7; exit }'; }
for how in --method=gauss --method=dop853 --project; do
    for case in a=15.70:3 a=15.709:4 a=15.8:4 b=15.69:3 b=15.70:3 b=15.71:4 b=15.8:4 b=21.98:4; do
        read -r row least <<< "$(lost "$how" --set "${case%:*}")"
        [ "$row" = "${case#*:}" ] || fail "$how, ${case%:*}: lost in row $row ($least), not ${case#*:}: $(cat err)"
        row=$(section --contact end "$how" --set "${case%:*}" | tail -1 | cut -d, -f2)
        [ "$row" = "${case#*:}" ] || fail "--contact end $how, ${case%:*}: the orbit ends in row $row, not ${case#*:}"
    done
    read -r row least <<< "$(lost "$how" --set a=15.70)"
    awk -v least="$least" 'BEGIN { exit (least - (15.70 - 15.707963267948966))^2 > 1e-22 }' ||
        fail "$how: the least value before the crossing at 5 pi is $least"
done

# Once a condition is broken its least value is told as it is between steps, also of steps that end broken, up to the row's time.
# x = exp(t/20) cos t is least where tan t = 1/20: after the upward crossings of y = 0, at t = pi, 3 pi, ..., and before the
# downward ones. The bound is a hundred tolerances, for the orbit until then and for the step's polynomial.
cat > spiral.tt <<'T'
model spiral
param b
default b = 1/2
state x
state y
eq x = y + x/20
eq y = - x + y/20
valid high : b + x > 0
valid far : b + 5 - x^2 - y^2 > 0
T
for how in --method=gauss --method=dop853 --method=taylor --method=rk8pd lanes; do
    for way in up:-1:0.999 down:1:1; do
        IFS=: read -r direction x other <<< "$way"
        start=(--start "x=$x")
        [ "$how" = lanes ] && start=(--grid "x=$x:$(awk "BEGIN { print $x * $other }"):2")
        for command in section fates; do
            report=(jellett $command ./spiral.tt --section y=0 --direction "$direction" "${start[@]}" --returns 3 --contact report)
            [ "$how" = lanes ] || report+=("$how")
            "${report[@]}" 2> err | awk -F, -v up="$x" -v command=$command '
                /^orbit/ || /^x,/ { for (i = 1; i <= NF; i++) column[$i] = i; next }
                /^#/ || (command == "section" && ($1 > 0 || $2 == 0)) || seen++ > 2 { next }
                { k = command == "section" ? $2 : 3; pi = atan2(0, -1)
                  t = up < 0 ? 2*pi*k : atan2(1, 20) + pi*(2*k - 1)
                  want = 0.5 - exp(t/20)*(up < 0 ? 1 : 20/sqrt(401)); miss = $column["valid_min"] - want
                  if (miss*miss > 1e-20*exp(t/10)) { print k, $column["valid_min"], want; bad = 1 }
                  if (command == "fates") exit }
                END { exit bad || seen < (command == "fates" ? 1 : 3) }' > said ||
                fail "${report[*]}: the least values are others: $(cat said err)"
        done
    done
done

# Commands that find orbits say where conditions break on them: the cycle x^2 + y^2 = a reaches x = sqrt a at each turn, z = 1/2 is
# reached at t = 10 ln 2 = 6.93, in the second return.
printf '%s\n' 'model ring' 'param a > 0' 'default a = 1/2' 'state x' 'state y' 'eq x = - y + x*(a - x^2 - y^2)' \
    'eq y = x + y*(a - x^2 - y^2)' 'valid near : 1 - x > 0' > ring.tt
printf '%s\n' 'model decay' 'state x' 'state y' 'state z' 'eq x = y' 'eq y = - x' 'eq z = - z/10' \
    'valid high : z - 1/2 > 0' > decay.tt
ring=(./ring.tt --section x=0 --direction both)
expect 0 'on 1 of 1 orbits near is lost' jellett orbits "${ring[@]}" --start y=1 --period 2 --set a=1.001
jellett orbits "${ring[@]}" --start y=1 --period 2 --set a=0.999 > out 2> err || fail "orbits: $(cat err)"
grep -q lost err && fail "a cycle on which nothing is lost: $(cat err)"
jellett continue "${ring[@]}" --start y=0.7 --period 2 --along a=0.5:1.5 > out 2> err || fail "continue: $(cat err)"
awk -F, '$1 == 0 && $2 > 1 { lost++; if (lost == 1) first = sprintf("%.10g", $2) } $1 == 0 { all++ }
    END { print "branch 0: on " lost " of " all " orbits, first at " first ", near is lost" }' out > wanted
grep -qFf wanted err || fail "continue: not '$(cat wanted)' but $(cat err)"
expect 0 'by t = 12.5663706. high is lost' jellett lyapunov ./decay.tt --section x=0 --start y=1,z=1 --returns 9
jellett lyapunov ./decay.tt --section x=0 --start y=1,z=1 --returns 1 > out 2> err || fail "lyapunov: $(cat err)"
grep -q lost err && fail "nothing is lost in one return: $(cat err)"

# Exponents tell of the same losses as returns do: of a history, to its pole; of a sweep, in lanes or not; and of a chart.
says() { # WANT ARGUMENT...: whether `jellett lyapunov` says that contact is lost
    local want=$1
    shift
    jellett lyapunov "$@" > out 2> err
    [ "$(grep -c 'contact is lost' err)" -eq "$want" ] || fail "lyapunov $*: wanted $want: $(cat err)"
}
from=(--start eta=0.5,gamma3=-0.3 --returns 5)
for E in 2.1 2.15 2.2; do
    jellett section "${from[@]}" --level E=$E > out 2> err
    lose=$(grep -c 'orbits lose contact' err)
    says "$lose" "${from[@]}" --level E=$E
    says "$lose" "${from[@]}" --level E=$E --method dop853
    says "$lose" "${from[@]}" --sweep E=$E:$E:1
    says "$lose" "${from[@]}" --sweep E=$E:$E:1 --method gauss
done
says 1 --start eta=0.5,gamma3=-0.3 --returns 4 --skip 1
says 2 "${from[@]}" --sweep E=2.1:2.2:3
for how in "" "--method gauss"; do
    of=$(jellett section --grid 6x5 --returns 3 $how 2>&1 > out | sed -n 's/.* \([0-9]* of 30\) orbits lose.*/\1/p')
    jellett lyapunov --grid 6x5 --returns 3 $how 2> err > out
    [ -n "$of" ] && grep -q "on $of orbits contact is lost" err || fail "a chart, $how: not '$of': $(cat err)"
done

# A condition without a value at the section, sin(x)/x at 0: nothing is known, and all commands say so.
printf '%s\n' 'model none' 'state x' 'state y' 'state z' 'eq x = y' 'eq y = - x + y*(1 - x^2 - y^2)' 'eq z = - z/10' \
    'angle c s = cos(x) sin(x)' 'valid near : 2 - s/x > 0' > none.tt
none=(./none.tt --section x=0)
for command in "section --start y=1,z=1 --returns 2" "lyapunov --grid y=1:2:2,z=1 --returns 2" "orbits --start y=1,z=0"; do
    expect 0 'orbits it is not known whether the model holds: a cond' jellett ${command%% *} "${none[@]}" ${command#* }
done
expect 0 'jellett: it is not known whether the model holds on the way' jellett lyapunov "${none[@]}" --start y=1,z=1 --returns 2
# So at every point of a sweep: what is the same at the next ones is counted.
sed -i 's/^state x$/param k\ndefault k = 1\nstate x/; s/(1 - x/(k - x/' none.tt
for command in section lyapunov; do
    expect 0 '^jellett: the same at 2 more points, up to k=2$' jellett $command "${none[@]}" --start y=1,z=1 --returns 2 \
        --sweep k=1:2:3
    [ "$(grep -c 'not known whether' err)" -eq 1 ] || fail "$command --sweep: says '$(cat err)'"
done

# The least value of a condition that holds is that of the motion, not of the steps: 1 and 2 - sqrt(5/4), where 2 - sin t and
# 2 - cos(t)/2 - sin t are least, to a millionth of it, 2^-20.
printf '%s\n' 'model least' 'state x' 'state v' 'state z' 'state w' 'eq x = v' 'eq v = -x' 'eq z = w' 'eq w = -z/100' \
    'valid below : 2 - x > 0' 'valid above : 3 + v > 0' > least.tt
for how in "" "--method gauss" "--method dop853" "--method taylor" "--method rk8pd" "--method rkf45" "--method msadams"; do
    for contact in "section --returns 2" "fates --returns 2"; do
        jellett ${contact%% *} ./least.tt --section z=0 --grid x=0:0.5:2,v=1:1:1,w=1:1:1 ${contact#* } --contact report $how > out \
            2> err || fail "the least value by $how: $(cat err)"
        awk -F, '/^#/ { next } !name { for (i = 1; i <= NF; i++) if ($i == "valid_min") name = i; next }
            $0 !~ /^[01],0,0,/ { n++; d = $name - 1; e = $name - 0.8819660112501051; bad += d*d > 0.9e-12 && e*e > 0.7e-12 }
            END { exit bad || n < 2 }' out || fail "$contact by ${how:-lanes}: the least value is not 1, 0.88196601125: $(cat out)"
    done
done

# Conditions with poles. On x = A cos(t), 2 + c/(x - c) goes to minus infinity at the pole, 5 - 1/(x - c)^2 to zero before it, and
# 1/(x - c)^2 has no zero. Where a step has the pole in its middle, both its ends are positive.
for condition in '2 + c/q' '5 - 1/q^2' '1/q^2'; do
    cat > circle.tt <<EOF
model circle
param c
default c = 1/2
state x
state y
let q = x - c
eq x =
    - y
eq y =
    + x
valid v : $condition > 0
EOF
    case $condition in 2*) edge=0 ;; 5*) edge=0.44721359549995794 ;; *) edge=none ;; esac
    for start in 1 3 3.5 3.9; do
        for method in gauss dop853 taylor rk8pd rkf45 msadams; do
            jellett section ./circle.tt --section y=0 --start x=$start --returns 1 --contact end --method $method 2> err | tail -1 \
                | awk -F, -v start=$start -v edge=$edge '{
                    cosine = (0.5 + edge)/start; t = atan2(sqrt(1 - cosine^2), cosine); wrong = $3 - t
                    exit !(edge == "none" ? $NF == "alive" : $NF == "lost_v" && wrong^2 < 1e-20) }' \
                || fail "$condition from x=$start by $method: not lost where it is"
        done
    done
    for method in gauss dop853 taylor rk8pd rkf45 msadams; do
        jellett fates ./circle.tt --section y=0 --grid x=1:3.9:30 --returns 1 --contact report --method $method --tol 1e-9 2> err \
            | awk -F, -v edge=$edge '/^[0-9]/ { all++; lost += $NF <= 0 }
                END { exit !(all == 30 && lost == (edge == "none" ? 0 : 30)) }' \
            || fail "$condition by $method: not told of where it is lost"
    done
done

# A dip much narrower than steps, to -1 at x = 1/2, is found from what it adds to the values beside it, also where another condition
# is small all the time: its least value is told, the orbit ends there, and simulate tells of it;
# a hole of the domain likewise.
cat > dip.tt <<'T'
model dip
param d > 0
default d = 0.03
state x
state y
eq x = y
eq y = - x
valid wide : 3 - 4*d^2/((x - 1/2)^2 + d^2) > 0
valid low : (x^2 + y^2)/100 > 0
T
sed 's/model dip/model hole/; s/^valid wide/domain wide/' dip.tt > hole.tt
for case in 0.03:lanes 0.1:lanes {0.03,0.003}:{gauss,taylor} {0.03,0.01}:{dop853,rk8pd,rkf45,msadams}; do
    how=(--method "${case#*:}")
    [ "${case#*:}" = lanes ] && how=()
    dip=(section ./dip.tt --section y=0 --direction both --set "d=${case%:*}" --grid x=0.9:1.1:20 --returns 1 "${how[@]}")
    jellett "${dip[@]}" --contact report 2> err |
        awk -F, '/^[0-9]/ && $2 == 1 { n++; bad += ($6 + 1)^2 > 1e-12 } END { exit !(n == 20 && !bad) }' ||
        fail "least values of a narrow dip, $case: $(cat err)"
    [ "$(jellett "${dip[@]}" --contact end 2> err | grep -c ',lost_wide$')" -eq 20 ] ||
        fail "orbits do not end in a narrow dip, $case: $(cat err)"
    [ "$(jellett "${dip[@]/dip.tt/hole.tt}" 2> err | grep -c ',left_domain$')" -eq 20 ] ||
        fail "orbits do not end in a narrow hole of the domain, $case: $(cat err)"
done
expect 0 ',lost_wide$' jellett simulate ./dip.tt --start x=1,y=0 --times 2
exit $status
