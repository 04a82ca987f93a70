#!/usr/bin/env bash
# Orbits of a table of one's own that leave the interval of a state: where they end, one at a time and in batches.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
section() { # FILE OPTION...: rows without comments
    local file=$1
    shift
    jellett section "$@" > all.csv 2> err || fail "section $*: $(cat err)"
    grep -v '^#' all.csv > "$file"
}

# g = g0 + p t - t^2/8: three orbits leave |g| < 1 before the first return, two of them over the top, and one after it.
cat > fall.tt <<'T'
model fall
state g in (-1, 1)
state p
state h
state q
eq g = p
eq p = - 1/4
eq h = q
eq q = - h
T
falling=(./fall.tt --section h=0 --returns 3)
for at in g=0,p=0.1 g=0,p=0.75 g=-0.9,p=1 g=-0.9,p=0.95; do falling+=(--start "$at,q=1"); done
section one.csv --method gauss "${falling[@]}"
section many.csv "${falling[@]}"
cmp -s <(cut -d, -f1,2,7 one.csv) <(cut -d, -f1,2,7 many.csv) ||
    fail "where orbits leave an interval, orbits, returns or fates differ"
[ "$(grep -c ',left_domain$' many.csv)" -eq 4 ] || fail "not all orbits leave the interval: $(cat many.csv)"

# The end of each is where the parabola says: a state is followed to the tolerance of its end, 1e-12, or 2^-37, at a rate of 0.22 or
# more, and the time to it is as good. So an orbit that ends 1e-9 after a return still makes it, and one that ends 1e-9 before does
# not.
turn=6.283185307179586
p_of() { awk -v t="$1" 'BEGIN { printf "%.17g", (t*t/8 - 1)/t }'; } # from g = 0
ends_near() { # FILE ORBIT TIME
    awk -F, -v orbit="$2" -v t="$3" \
        '$1 == orbit && /left_domain/ { off = $3 - t; found = 1 } END { exit !(found && off*off <= 25e-22) }' "$1" ||
        fail "$1: orbit $2 does not end at $3: $(cat "$1")"
}
after=$(awk -v t=$turn 'BEGIN { printf "%.17g", t + 1e-9 }') before=$(awk -v t=$turn 'BEGIN { printf "%.17g", t - 1e-9 }')
falling+=(--start "g=0,p=$(p_of "$after"),q=1" --start "g=0,p=$(p_of "$before"),q=1" --start "g=0,p=$(p_of 6.395),q=1")
for how in "--method gauss" "--method dop853" "--method taylor" "--method rkf45" "--method msadams" ""; do # the last: in lanes
    section ends.csv $how "${falling[@]}"
    ends_near ends.csv 0 "$(awk 'BEGIN { printf "%.17g", 0.4 + sqrt(8.16) }')"
    ends_near ends.csv 1 2
    ends_near ends.csv 2 "$(awk 'BEGIN { printf "%.17g", 4 - sqrt(0.8) }')"
    ends_near ends.csv 3 "$(awk 'BEGIN { printf "%.17g", 3.8 + sqrt(15.24) }')"
    ends_near ends.csv 4 "$after"
    ends_near ends.csv 5 "$before"
    ends_near ends.csv 6 6.395
    [ "$(cut -d, -f1,2,7 ends.csv | grep -E '^[456],1' | tr '\n' ' ')" = "4,1,alive 5,1,left_domain 6,1,alive " ] ||
        fail "${how:-lanes}: a return before the end is lost, or one beyond it is told: $(cat ends.csv)"
done
# dx/dt = -sqrt(x) from x = 1 comes to 0 at t = 2, as (1 - t/2)^2 does, which does not obey it from there on. A series runs smoothly
# through, also in the time that lifts another root, and where no interval and no condition of the table says that it may not.
printf '%s\n' 'model drain' 'state x' 'root r = sqrt(x)' 'eq x = -r' > drain.tt
printf '%s\n' 'model tilted' 'state x' 'state g in (-1, 1)' 'root r = sqrt(x)' 'root s = sqrt(1 - g^2)' 'eq x = -r' 'eq g = s/10' \
    'pole g' 'time regular : s lifting s' > tilted.tt
for how in "drain x=1" "tilted x=1,g=0"; do
    for method in gauss dop853 taylor rkf45 msadams; do
        jellett simulate "./${how% *}.tt" --start "${how#* }" --until 4 --every 1/8 --method $method > rows.csv 2> err ||
            [ $? = 4 ] || fail "$how by $method: $(cat err)"
        # 1e-9: the tolerance is one of the slope, sqrt(x), so that x may stand on its square and a margin
        grep -v '^[#t]' rows.csv | awk -F, -v how="$how $method" '{ true = $1 < 2 ? (1 - $1/2)^2 : 0; d = $2 - true }
            !(d * d <= 1e-18) { print how, "is false:", $0; bad = 1 } END { exit bad }' || status=1
    done
done
# x = sin t, as long as x' = sqrt(1 - x^2): to t = pi/2, but for the root of twice the tolerance, 1e-12. A series that goes through
# comes out as near to the end as it went in.
printf '%s\n' 'model quarter' 'state x' 'domain below : 1 - x^2 > 0' 'root r = sqrt(1 - x^2)' 'eq x = r' > quarter.tt
for method in gauss dop853 taylor rkf45; do # rk8pd and msadams spend their steps there
    jellett simulate ./quarter.tt --start x=0 --times 5 --method $method > rows.csv 2> err
    tail -1 rows.csv | awk -F, '{ off = $1 - 1.5707963267948966; exit !(off*off < 2e-12 && $3 == "left_domain") }' ||
        fail "by $method: $(tail -1 rows.csv)"
done
# A table of the same equations whose states have no intervals: that they keep their signs is seen by their rates.
free_of() { sed -e "s/^model /&free_/" -e 's/ in (0, inf)//' "$1.tt" > "free_$1.tt"; }
# An end that is not reached, since the rate goes to 0 with the state: x = x0 exp(k cos t - k - d t) falls to 1e-26 of x0 and comes
# back, and with d it falls on. Errors are relative, of a tolerance a step, and in lanes of up to 64; there are fewer than 1000
# steps.
cat > ebb.tt << 'T'
model ebb
param k
param d
default k = 30, d = 0
state x in (0, inf)
state y
state phase
angle c s = cos(phase) sin(phase)
eq x = - k*s*x - d*x
eq y = x - y
eq phase = 1
periodic phase = 2*pi
T
free_of ebb
for table in ebb free_ebb; do
    for method in gauss dop853 taylor rk8pd rkf45 msadams; do
        expect 0 ',alive$' jellett simulate ./$table.tt --start x=1,y=0,phase=0 --times $turn --method $method
        awk -F, '/^6/ { exit !(($2 - 1)^2 <= 1e-18) }' out || fail "$table: x does not come back by $method: $(tail -1 out)"
    done
    section one.csv ./$table.tt --section phase=0 --start x=0.3,y=0 --returns 2
    section many.csv ./$table.tt --section phase=0 --grid x=0.1:0.4:4,y=0:1:2 --returns 2
    awk -F, '$2 == 0 { start = $4 } /^[0-9]/ && $2 > 0 { n++; bad += !(($4/start - 1)^2 <= 64^2*1e-18) || $6 != "alive" }
        END { exit !(n == 18 && !bad) }' one.csv many.csv || fail "$table: x does not come back: $(cat one.csv many.csv)"
    expect_text 0 "8 starts: 8 alive" jellett fates ./$table.tt --set d=40 --section phase=0 --grid x=0.1:0.4:4,y=0:1:2 --returns 2
    awk -F, '/^0/ { n++; bad += !(($5/$1/exp(-160*3.141592653589793) - 1)^2 <= 64^2*1e-18) } END { exit !(n == 8 && !bad) }' out ||
        fail "$table: what is left of x after two turns: $(cat out)"
done
# So it is on either side of a 0 within the interval, which the flow keeps as well, and in a time of the field's own.
sed 's/free_ebb/lifted/; s/^state y/&\nstate g in (-1, 1)\nroot h = sqrt(1 - g^2)/' free_ebb.tt > lifted.tt
printf '%s\n' 'eq g = h*y' 'pole g' 'time regular : h lifting h' >> lifted.tt
for table in free_ebb lifted,g=0; do
    rest=${table#"${table%,*}"} table=${table%,*} # what a start of lifted has besides
    for method in gauss dop853 taylor rk8pd rkf45 msadams; do
        expect 0 ',alive$' jellett simulate ./$table.tt --start x=-1,y=0,phase=0$rest --times $turn --method $method
        awk -F, '/^6/ { exit !(($2 + 1)^2 <= 1e-18) }' out || fail "x of $table does not come back by $method: $(tail -1 out)"
    done
    section many.csv ./$table.tt --section phase=0 --grid x=-0.4:0.5:4,y=0:1:2${rest:+$rest:0:1} --returns 2
    awk -F, '$2 == 0 { start = $4 } /^[0-9]/ && $2 > 0 { n++; bad += !(($4/start - 1)^2 <= 64^2*1e-18) }
        END { exit !(n == 16 && !bad) }' many.csv || fail "x of $table does not come back from either side: $(cat many.csv)"
    # Of exp(-700) nothing is left.
    expect 4 'x is at the end 0 .*the logarithm of its size' \
        jellett simulate ./$table.tt --set k=350 --start x=-1,y=0,phase=0$rest --times $turn
    section many.csv ./$table.tt --set k=350 --section phase=0 --grid x=-0.4:0.5:4,y=0:1:2${rest:+$rest:0:1} --returns 1
    awk -F, '$2 == 1 { n++; bad += $NF != "left_domain" } END { exit !(n == 8 && !bad) }' many.csv ||
        fail "what is left of x of $table: $(cat many.csv)"
done
# A sleigh that goes backwards turns round, however little it turns at first: w = 1e-30, v = tanh(t/2 + ln(w/sqrt 2)).
for method in gauss dop853 taylor rk8pd rkf45 msadams; do
    expect 0 ',alive$' jellett simulate chaplygin_sleigh --start v=-1,w=1e-30 --times 138 --method $method
    awk -F, '/^138/ { e = exp(138)*1e-60/2; exit !(($2 - (e - 1)/(e + 1))^2 <= 1e-18) }' out ||
        fail "sleigh, $method: $(tail -1 out)"
done
# A tangent along x falls and comes back as x does, or grows and falls: of the derivative over a turn the eigenvalues are 1 and
# exp(-2 pi), which is exp of the divergence. The derivative beside a y of 1e19 has few digits.
for phase in 0 4; do
    for how in "--start x="{0,0.3}",y=0" "--grid x="{0:0,0.3:0.3}":1,y=0:1:2"; do # the latter in lanes
        section many.csv ./free_ebb.tt --section phase=$phase $how --returns 1 --check
        awk -F, '/alive,[^,]/ { n++; t = 2*3.141592653589793; miss = ($7 - 1 - exp(-t))^2 + ($8 - exp(-t))^2
            bad += !(($9 + t)^2 <= 1e-16) || $5^2 < 4 && !(miss <= 1e-16) } END { exit bad || !n }' many.csv ||
            fail "derivative, $phase, $how: $(cat many.csv)"
    done
done
# Where one of two that compete is absent, by any method and in lanes, the derivative over a year has the eigenvalues exp(-2 pi)
# along the other and exp(2 pi - 4 pi c) across, as the other's mean is 1: both are the same if c is.
printf '%s\n' 'model compete' 'param c' 'default c = 1' 'state x' 'state y' 'state phase' 'periodic phase = 2*pi' \
    'angle C S = cos(phase) sin(phase)' 'eq x = x*(1 + C/5 - x - c*y)' 'eq y = y*(1 - S/5 - y - 2*c*x)' 'eq phase = 1' > compete.tt
for how in "--start x=1.101784835445132,y=0 --method "{gauss,dop853,taylor,rk8pd,rkf45,msadams} \
    "--grid x=1.101784835445132:1.101784835445132:1,y=0:0.1:2"; do
    section many.csv ./compete.tt --section phase=0 $how --returns 1 --check
    awk -F, '/^0,1,/ { n++; off = $7 - 2*exp(-2*3.141592653589793); bad = !(off*off < 1e-20) } END { exit bad || !n }' many.csv ||
        fail "one that competes, $how: $(cat many.csv)"
done
expect 0 '^1,1.10178483544513[^,]*,0,' jellett orbits ./compete.tt --section phase=0 --start x=1.1,y=0
# A bend of a rate within a step shows there too: the integral of 20 |x - 0.3| - 20 x - 1, bent over 1e-4, by quadrature. Where y is
# 0, an error of a step, 1e-12, counts up to 20 times in that time, and there are fewer than 100 steps.
printf '%s\n' 'model bent' 'state x' 'state y' 'state phase' 'periodic phase = 2*pi' 'angle C S = cos(phase) sin(phase)' \
    'root r = sqrt((x - 3/10)^2 + 1e-8)' 'eq x = -x + C' 'eq y = y*(20*r - y - 20*x)' 'eq phase = 1' > bent.tt
for method in gauss dop853 taylor rk8pd rkf45 msadams; do
    section many.csv ./bent.tt --section phase=0 --start x=0.5,y=0 --method $method --returns 1 --check
    awk -F, '/^0,1,/ { n++; off = $9 - 55.4573919178419003; bad = !(off*off < 4e-18) } END { exit bad || !n }' many.csv ||
        fail "the integral over a bend by $method: $(cat many.csv)"
done
# However near x is to its end, y beside it ends where it does: y + y^2/2 = 3/2 - t from y = 1. An error of a step, 1e-12, counts
# 1 + y times in that time, and there are fewer than 1000 steps.
printf '%s\n' 'model beside' 'state x in (0, inf)' 'state y in (0, inf)' 'state z' 'state w' 'eq x = -50*x' 'eq y = -1/(1 + y)' \
    'eq z = w' 'eq w = -z' > beside.tt
ends_in_time() { # WHAT COLUMN: rows.csv
    awk -F, '/left_domain/ { off = $t - 3/2; n++; bad += off*off > 4e-18 } END { exit bad || !n }' t="$2" rows.csv ||
        fail "y comes to 0 at 3/2, $1: $(tail -2 rows.csv)"
}
for method in gauss dop853 taylor rk8pd rkf45 msadams; do
    jellett simulate ./beside.tt --start x=1,y=1,z=0,w=1 --times 100 --method $method > rows.csv 2> err
    ends_in_time $method 1
done
for how in "" "--method gauss"; do # the first: in lanes
    section rows.csv ./beside.tt --section z=0 --grid x=1:2:2,y=1:1:1,w=1:1:1 --returns 2 $how
    ends_in_time "${how:-in lanes}" 3
done
# Nor does a kernel that overflows, here in v*w at t = 340780.8, make x stand still, which falls as (1 + t/1e6)^(-power).
for power in 10 100; do
    printf '%s\n' 'model far' 'state x in (0, inf)' 'state v' 'state w' 'state s' "eq x = -$power*1e148*x/v" 'eq v = 1e148' \
        'eq w = 1e148' 'eq s = 1/w' > far.tt
    for what in "x in (0, inf)" x; do
        sed -e "s/^state x .*/state $what/" -e "s/far/now/" far.tt > now.tt
        for method in gauss dop853 taylor rk8pd rkf45 msadams; do
            jellett simulate ./now.tt --start x=1,v=1e154,w=1e154,s=0 --times 1000000 --method $method > out 2> err
            [ $? -eq 4 ] || fail "$what, power $power, by $method: $(tail -1 out)"
        done
    done
done
# In an epidemic that is over, I falls as exp(-(1 - 2 S) t), below all doubles by t = 1000. What is left of it, errors of the least
# scale, is no end of the model's domain.
printf '%s\n' 'model over' 'state S in (0, inf)' 'state I in (0, inf)' 'state z' 'state w' 'eq S = -2*S*I' \
    'eq I = 2*S*I - I' 'eq z = w' 'eq w = -z' > over.tt
for method in gauss dop853 taylor rk8pd rkf45 msadams; do
    expect 0 '^1000,' jellett simulate ./over.tt --start S=3,I=1e-3,z=0,w=1 --times 1000 --method $method
    awk -F, '/^1000,/ { i = $3 + 0; exit !(i < 1e-290 && i > -1e-290 && /alive$/) }' out || fail "over, $method: $(tail -1 out)"
done
# What comes back from there is no state any more: x = exp(-a sin t) is 1 again after t = pi, or its orbit ends on the way.
printf '%s\n' 'model regrown' 'param a' 'default a = 600' 'state x in (0, inf)' 'state z' 'state w' 'eq x = -a*x*w' 'eq z = w' \
    'eq w = -z' > regrown.tt
is_back() { # COLUMNS of t and x, HOW [HOW MUCH larger errors are than those of a state that keeps its sign]
    awk -F, '{ off = ($x - 1)/larger } END { exit !(/alive/ ? off*off < 1e-20 : /left_domain|nonfinite/ && $t > 1.3 && $t < 3) }' \
        t="$1" x="$2" larger="${4:-1}" out || fail "$3: $(tail -1 out)"
}
free_of regrown
for table in regrown free_regrown; do
    for a in 600 660 690 705 740 1000; do # by rkf45 the last falls to 0 itself
        for method in gauss dop853 taylor rk8pd rkf45 msadams; do
            jellett simulate ./$table.tt --set a=$a --start x=1,z=0,w=1 --times 3.141592653589793 --method $method > out 2> err
            is_back 1 2 "$table, a = $a by $method"
        done
        for how in "" "--method gauss"; do
            jellett section ./$table.tt --set a=$a --section z=0 --grid x=1:1:1,w=1 --returns 1 $how > out 2> err
            is_back 3 4 "$table, a = $a ${how:-in lanes}"
        done
    done
    expect 4 'x is at the end 0 .*the logarithm of its size' jellett simulate ./$table.tt --set a=700 --start x=1,z=0,w=1 --times 3
done
# So it is with two that are 0 only together, x = exp(-a sin t) cos 2t and y beside it, whose errors are relative to 64 times them.
printf '%s\n' 'model paired' 'param a' 'default a = 600' 'state x' 'state y' 'state z' 'state w' 'eq x = -a*x*w - 2*y' \
    'eq y = -a*y*w + 2*x' 'eq z = w' 'eq w = -z' > paired.tt
for a in 600 660 705 1000; do
    for method in gauss dop853 taylor rk8pd rkf45 msadams; do
        jellett simulate ./paired.tt --set a=$a --start x=1,y=0,z=0,w=1 --times 3.141592653589793 --method $method > out 2> err
        is_back 1 2 "a pair, a = $a by $method" 64
    done
    for how in "" "--method gauss"; do
        jellett section ./paired.tt --set a=$a --section z=0 --grid x=1:1:1,y=0,w=1 --returns 1 $how > out 2> err
        is_back 3 4 "a pair, a = $a ${how:-in lanes}" 64
    done
done
expect 4 'what is 0 with it .* nothing is left of their digits' \
    jellett simulate ./paired.tt --set a=700 --start x=1,y=0,z=0,w=1 --times 3
# A table may have more than 64 states, and the last of them keep their sign as the first do.
awk '/^state x/ { for (i = 0; i < 64; i++) print "state y" i "\neq y" i " = 0" } 1' regrown.tt > among.tt
for method in gauss dop853 taylor; do
    expect 0 '^3.14' jellett simulate ./among.tt --set a=60 --times 3.141592653589793 --method $method \
        --start "$(printf 'y%d=1,' {0..63})x=1,z=0,w=1"
    awk -F, '/^3.14/ { off = $66 - 1 } END { exit !(off*off < 1e-20 && /alive$/) }' out || fail "the 65th, $method: $(tail -1 out)"
done
# A state that looks as if it never came to 0, as rates are 0 at all T < 10, ends where it does, though it would soon be back:
# c = 9.07 - K (1 - cos t), K = 1e5 exp(-10). An error of a step, 9e-12 or less, counts 1/(K sin t) = 3.3 times in that time.
printf '%s\n' 'model burnt' 'state c in (0, inf)' 'state T in (0, inf)' 'state z' 'state w' 'exp e = exp(-1e4/T)' \
    'eq c = -1e5*e*z' 'eq T = 0' 'eq z = w' 'eq w = -z' > burnt.tt
for method in gauss dop853 taylor rk8pd rkf45 msadams; do
    jellett simulate ./burnt.tt --start c=9.07,T=1000,z=0,w=1 --times 10 --method $method > out 2> err
    tail -1 out | awk -F, '{ off = $1 - 3.0752547425164227; exit !(off*off < 9e-16 && /left_domain/) }' ||
        fail "c comes to 0, $method: $(tail -1 out)"
done
# Nor is a state kept at 0 that is driven late, by a short pulse, or where two others are positive. Values are by quadrature.
printf '%s\n' 'model late' 'param a' 'param b' 'state x' 'state y' 'exp e = exp(-a*(y - b)^2)' 'eq x = e - x' 'eq y = 1' > late.tt
printf '%s\n' 'model signs' 'state x' 'state y' 'state z' 'root r = sqrt(y^2)' 'root s = sqrt(z^2)' \
    'eq x = (y + r)*(z + s)/4 - x' 'eq y = 1' 'eq z = 1' > signs.tt
is_driven() { # VALUE WHAT
    tail -1 out | awk -F, -v x="$1" '{ exit !(($2/x - 1)^2 < 1e-18) }' || fail "driven late, $2: $(tail -1 out)"
}
for method in gauss dop853 taylor rk8pd; do
    expect 0 ',alive$' jellett simulate ./late.tt --set a=20,b=10 --start x=0,y=0 --times 12 --method $method
    is_driven 0.0543124827342887819 "$method"
    expect 0 ',alive$' jellett simulate ./late.tt --set a=2e4,b=5 --start x=0,y=0 --times 4.98,6 --method $method
    is_driven 0.0046107426784022128 "in a short time, $method"
done
expect 0 ',alive$' jellett simulate ./signs.tt --start x=0,y=-1,z=-2 --times 3
is_driven 0.6321205588285577 "by two"
# All orbits of x' = -k z x return to where they began, and so do those beside them: exponents are 0. In lanes errors are 64e-12 a
# step at most, as above, and t is 8 pi. An orbit that leaves the domain, at c > 0, changes nothing for others.
printf '%s\n' 'model ebbing' 'param c' 'default c = 0' 'state x in (0, inf)' 'state z' 'state w' 'eq x = -30*z*x - c' 'eq z = w' \
    'eq w = -z' > ebbing.tt
for sweep in "" "--sweep c=0.001:0:2"; do
    expect 0 '' jellett lyapunov ./ebbing.tt --section z=0 --grid x=0.5:1.4:4,w=1:1:1 --returns 4 $sweep
    grep '25[.]1327' out | awk -F, '{ e = $(NF - 1); n++; bad += !(e*e < 1e-17) } END { exit bad || n != 4 }' ||
        fail "exponents ${sweep:-in lanes}: $(grep -v '^#' out)"
done
# What lies outside an interval without one end is told from which side, of a section's starts as well.
printf '%s\n' 'model half' 'state y in (0, inf)' 'state z in (-inf, 2)' 'state w' 'eq y = -y' 'eq z = z - 2' 'eq w = z' > half.tt
expect 3 '^jellett: --start: y must lie above 0$' jellett simulate ./half.tt --start y=-1,z=0,w=0 --times 1
expect 3 '^jellett: y=1,z=3: z must lie below 2$' jellett section ./half.tt --section w=0 --start y=1,z=3 --returns 1
expect 3 '^jellett: --section: y must lie above 0$' jellett section ./half.tt --section y=0 --start z=1,w=0 --returns 1
# An epidemic that begins with a few of very many is no equilibrium, and is over where as few are left: S = exp(-2 (1 - S)). Its
# times, the period of the orbit of Lotka and Volterra through x = 1e-100, and what is below are those of DOP853 in the logarithms.
printf '%s\n' 'model epidemic' 'state S in (0, inf)' 'state I in (0, inf)' 'eq S = -S*I/2' 'eq I = S*I/2 - I/4' > epidemic.tt
is_over() { # TIME S TIME_COLUMN S_COLUMN
    awk -F, -v T="$1" -v S="$2" -v t="$3" -v s="$4" \
        '/alive/ && $t > 0 { n++; bad += ($t/T - 1)^2 > 1e-17 || ($s/S - 1)^2 > 1e-20 } END { exit !n || bad }' out ||
        fail "small states that grow: $(tail -1 out)"
}
free_of epidemic
for case in 1e-10,240.959838004 1e-13,315.137173036 1e-20,488.217621287 1e-100,2466.279887; do
    for how in "--start S=1" "--grid S=1:1:1 --check" "--start S=1 --method "{taylor,dop853,rk8pd,msadams}; do
        for table in epidemic free_epidemic; do
            expect 0 '^0,1,' jellett section ./$table.tt --section I=${case%,*} --direction down --returns 1 $how
            is_over "${case#*,}" 0.2031878699799798 3 4
        done
    done
    expect 0 '1 alive, 0 equilibrium' jellett fates ./epidemic.tt --section I=${case%,*} --direction down --returns 1 --start S=1
done
for how in "" "--method gauss"; do
    expect 0 '^0,2,' jellett section lotka_volterra --section y=1/2 --direction both --start x=1e-100 --returns 2 $how
    grep '^0,2,' out > row && mv row out && is_over 360.49833325 1e-100 3 4
done
# Nor is the saddle an end where the cycle of May and Leonard passes it, on which the time between returns grows with every one,
# whether or not the table says that states are positive.
printf '%s\n' 'model cycle' 'state x in (0, inf)' 'state y in (0, inf)' 'state z in (0, inf)' 'eq x = x*(1 - x - 4*y/5 - 13*z/10)' \
    'eq y = y*(1 - 13*x/10 - y - 4*z/5)' 'eq z = z*(1 - 4*x/5 - 13*y/10 - z)' > cycle.tt
free_of cycle
for how in "" "--start y=0.3,z=0.1"; do
    for table in cycle free_cycle; do
        expect 0 '^0,5,' jellett section ./$table.tt --section x=1/2 --start y=0.4,z=0.1 $how --returns 5
        grep '^0,5,' out > row && mv row out && is_over 3592.4600417 1.47951879577e-149 3 5
    done
done
exit $status
