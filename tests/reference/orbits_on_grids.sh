#!/usr/bin/env bash
# A search over a grid: a degenerate orbit, to which Newton's method comes from all sides and no nearer than a root of its residual,
# is listed once; a grid none of whose points is on the levels is refused, by every command that has one; what to try where nothing
# is found is said, and finds it. And multipliers that are small, or near 1.
source "$JLT_SOURCE_DIR/tests/scratch.sh"

cat > cusp.tt << 'T'
model cusp
state x
state y
state phi
angle c s = cos(phi) sin(phi)
eq x = -x^3 + y
eq y = -y + y*c/5
eq phi = 1
periodic phi = 2*pi
T
sed -e 's/^model cusp/model two/' -e 's/^eq x = .*/eq x = -(x^2 - 1\/100)^3 + y/' cusp.tt > two.tt
for want in cusp=1 two=2; do
    jellett orbits ./${want%=*}.tt --section phi=0 --grid x=-0.5:0.5:20,y=-0.5:0.5:20 --period 2 > rows.csv 2> err
    [ "$(grep -c '^1,.*,degenerate,' rows.csv)" -eq "${want#*=}" ] && [ "$(grep -c '^[12],' rows.csv)" -eq "${want#*=}" ] ||
        fail "$want orbits: $(grep -v '^#' rows.csv; cat err)"
done

# x = 0 is the only orbit, with the multiplier exp(4 pi) = 286751, of starts of which none is nearer to it than 1/3.
sed -e 's/^model cusp/model steep/' -e 's/^eq x = .*/eq x = 2*x/' cusp.tt > steep.tt
steep=(./steep.tt --section phi=0 --grid x=-1:1:4,y=0 --period 1)
expect_text 0 "no orbit is found: a finer --grid, or a larger --near," jellett orbits "${steep[@]}"
expect 0 '^1,.*,saddle,' jellett orbits "${steep[@]}" --near 1e6

cat > oscillators.tt << 'T'
model oscillators
state x
state y
state px
state py
eq x = px
eq y = py
eq px = -x
eq py = -2*y
integral E = (px^2 + py^2 + x^2)/2 + y^2
T
for command in "orbits --period 1" "lyapunov --returns 2" "section --returns 2" "fates --returns 2"; do
    jellett ${command%% *} ./oscillators.tt ${command#* } --section x=0 --level E=-1 --solve px=0.3 \
        --grid y=-0.1:0.1:3,py=0:0.1:3 > rows.csv 2> err
    [ $? -eq 4 ] && grep -q 'finds no state with these levels' err ||
        fail "$command on an empty level: $(tail -1 rows.csv; cat err)"
done
# Multipliers of three coordinates are exp(2 pi a), with a = 1/10, b and c, however small: the smallest by the determinant, and two
# that errors of DP hide not at all.
cat > linear.tt << 'T'
model linear
param b
param c
state x
state y
state z
state phi
angle C S = cos(phi) sin(phi)
eq x = x/10 + y*C/10
eq y = b*y + z*S
eq z = c*z + C
eq phi = 1
periodic phi = 2*pi
T
for set in b=-1,c=-5 b=-1,c=-20 b=-8,c=-20; do
    jellett orbits ./linear.tt --set "$set" --section phi=0 --start x=0,y=0,z=0 --period 1 2> err | tail -1 > row.csv
    echo "${set//[bc]=/}" | awk -F, 'function is(mu, a) { return mu != "" && (mu/exp(8*atan2(1, 1)*a) - 1)^2 < 1e-16 }
        NR == FNR { b = $1; c = $2; next }
        { exit !(NF == 16 && is($8, 1/10) && (b < -7 ? $10 $12 == "" : is($10, b) && is($12, c)) && $15 == "saddle") }' - row.csv ||
        fail "multipliers with $set: $(cat row.csv err)"
done

# A centre 9e-9 from a pole, where errors of DP are as large as its multipliers are far from 1: their product is the determinant.
top=m=0.45264883301985243,R=7.2400265539988222,g=9.81,I1=2.7955972416477382,I3=0.57355983089921614,a3=0
for tolerance in 1e-11 1e-12 1e-13; do
    jellett orbits --set $top --level E=9.1690530782586067,G=-0.0022233743414763313 --tol $tolerance --period 1 \
        --start eta=-1.0790763652803357e-07,gamma3=-0.99999999127374439 2> err | tail -1 > row.csv
    awk -F, '{ exit !($12 == "centre" && ($7^2 + $8^2 - $6)^2 < 1e-30 && ($5 - 2*$7)^2 < 1e-30) }' row.csv ||
        fail "a centre by $tolerance: $(cat row.csv err)"
done

# Tori of x'' = -x^3, whose period varies from one to the next: a double multiplier 1, whatever errors of DP make of it.
printf '%s\n' 'model quartic' 'state x' 'state v' 'state phi' 'eq x = v' 'eq v = -x^3' 'eq phi = 1/4' \
    'periodic phi = 2*pi' > quartic.tt
expect 0 '' jellett orbits ./quartic.tt --section phi=0 --grid x=-1:3:9,v=-1.1:1:4 --period 1
awk -F, '/^1,/ { rows++; bad += $12 != "degenerate" } END { exit !(rows > 3 && !bad) }' out ||
    fail "orbits of tori: $(grep '^1,' out)"
# At rest it is an orbit of multiplicity three, which a residual of 1e-13 leaves open by 1e-4: one orbit, and no centre.
for samples in 0 100; do
    jellett orbits ./quartic.tt --section phi=0 --mirror v,phi --grid x=-0.5:0.5:5,v=-0.5:0.5:5 --period 1 --samples $samples \
        > out 2> err
    awk -F, '/^1,/ && $2^2 + $3^2 < 1e-8 { rows++; bad += $12 != "degenerate" } END { exit !(rows == 1 && !bad) }' out ||
        fail "orbits at rest, $samples samples: $(grep "e-0[5-9]," out) $(cat err)"
done

# Two multipliers exp(-2 pi a) and exp(-2 pi b), however small, and their sum are right to a thousandth, or are not told.
printf '%s\n' 'model shrinks' 'param a' 'param b' 'state x' 'state y' 'state phi' 'angle c s = cos(phi) sin(phi)' \
    'eq x = -a*x + c' 'eq y = -b*y' 'eq phi = 1' 'periodic phi = 2*pi' > shrinks.tt
for rates in '3 4' '5 5.1' '0.1 12' '7 9' '8 8' '60 70'; do
    for method in gauss dop853; do
        read -r a b <<< "$rates"
        jellett orbits ./shrinks.tt --section phi=0 --set "a=$a,b=$b" --start x=0.1,y=0 --method $method > out 2> err
        tail -1 out | awk -F, -v a="$a" -v b="$b" -v seen="$([ $a != 60 ] && [ $method = dop853 ] && echo 1)" '
            function power(rate) { return exp(-6.283185307179586*rate) }
            function off(known, right) { return known != "" && (known/right - 1)^2 > 1e-6 }
            { exit off($7, power(a)) || off($9, power(b)) || off($5, power(a) + power(b)) || (seen && $7 == "") }' ||
            fail "$method, rates $rates: $(tail -1 out) $(cat err)"
    done
done

# A pendulum on its separatrix, and a bead on a turning hoop: returns by rounding, from a saddle where tangent vectors grow and
# shrink by 1e16. Orbits beside it are closed, all of them: their multipliers are 1, and none is told as another.
printf '%s\n' 'model hoop' 'param W' 'state x' 'state y' 'state w' 'eq x = -y*w' 'eq y = x*w' 'eq w = W^2*x*y - y' > hoop.tt
for turning in 0 1/2 2 3; do
    hoop=(./hoop.tt --section y=0 --set W=$turning --start x=1,w=2)
    jellett orbits "${hoop[@]}" --period 1 > out 2> err
    awk -F, '/^1,/ { bad += $12 != "degenerate" || ($7 != "" && ($7 - 1)^2 > 1e-6) } END { exit !!bad }' out ||
        fail "on a separatrix, W = $turning: $(tail -1 out)"
    jellett section "${hoop[@]}" --start x=1,w=1 --returns 1 --check > out 2> err
    awk -F, 'FNR == NR { if (/^[01],1,/) { defect = $10 < 0 ? -$10 : $10; worst = defect > worst ? defect : worst }; next }
        match($0, /relative defect [^,;]*/) { split(substr($0, RSTART, RLENGTH), word, " "); said = word[3] }
        END { exit (said - worst)^2 > (worst/10)^2 }' out err || fail "the worst defect is another: $(cat out err)"
done

# Tolerances so coarse that no multiplier of a cycle keeps three digits still tell that it attracts: all are below 0.63.
printf '%s\n' 'model cycle' 'state x' 'state y' 'state z' 'state u' 'eq x = x/10 - y - x*(x^2 + y^2)' \
    'eq y = x + y/10 - y*(x^2 + y^2)' 'eq z = -z/20 + x^2 + u' 'eq u = -u/10 - z/10 + y^3' > cycle.tt
for tolerance in 1e-13 1e-4 1e-3; do
    jellett orbits ./cycle.tt --section y=0 --start x=0.316,z=0.5,u=0 --tol $tolerance --period 1 > out 2> err
    tail -1 out | grep -q ',attracting,' || fail "at tolerance $tolerance: $(tail -1 out) $(cat err)"
done

# Newton's method ends at rest, from either side, not a subnormal number beside it.
printf '%s\n' 'model settling' 'state x' 'state y' 'state f' 'angle c s = cos(f) sin(f)' 'eq x = x/10 + x^2 + x*y' \
    'eq y = -y/10 + x*y + c*x^2' 'eq f = 1' 'periodic f = 2*pi' > settling.tt
for start in x=0.01,y=0.01 x=0.001,y=0.03 x=-0.003,y=0.04; do
    expect 0 '^1,0,0,6.28' jellett orbits ./settling.tt --section f=0 --start $start
done
exit $status
