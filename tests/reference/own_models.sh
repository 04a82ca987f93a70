#!/usr/bin/env bash
# Models of one's own through the commands: three bodies on the figure of eight, Suslov's problem on levels, a sleigh with a rotor,
# a rattleback, separatrices of a Henon-Heiles level.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
cp "$JLT_SOURCE_DIR"/tests/reference/data/{figure_eight,suslov,sleigh_rotor,rattleback,henon_heiles}.tt .

# Oracle: A. Chenciner, R. Montgomery, Ann. Math. 152 (2000), with C. Simo's start to eight digits, and period 6.32591398. Body 3
# comes down through y3 = 0 twice a period. Held are where along x it does so and the size, x1; T goes as the size to 3/2, so that
# its error is 1.5 T times that of x1, 5e-9, and as much of the other digits: 1e-7, twice. Simo's orbit is elliptic: all multipliers
# have modulus 1; the double one of H is off by the root of the derivative's error, 1e-12.
free=x1=0.97000436,y1=-0.24308753,x2=-0.97000436,y2=0.24308753,x3=0,u1=0.46620368,v1=0.43236573,u2=0.46620368,v2=0.43236573
eight=(./figure_eight.tt --section y3=0 --direction down --level Px=0,Py=0 --solve u3=-0.93,v3=-0.86)
expect 0 '^2,0.97000436,' jellett orbits "${eight[@]}" --start $free --period 2 --hold x1,x3
awk -F, '/^2,/ { bad = ($11 - 6.32591398)^2 > 4e-14 || ($3 + 0.24308753)^2 > 1e-15 || ($9 - 0.46620368)^2 > 1e-15 || $NF > 1e-12
    for (i = 14; i < 32; i += 2) bad += (sqrt($i^2 + $(i + 1)^2) - 1)^2 > 4e-12 } END { exit bad != 0 }' out ||
    fail "the figure of eight: $(tail -1 out)"
# u3 and v3 from the levels are Simo's; after half a period the bodies 1 and 2 have changed places.
expect 0 '^0,1,' jellett section "${eight[@]}" --start $free --returns 2
awk -F, '/^0,0,/ { bad = ($13 + 0.93240737)^2 > 1e-15 || ($14 + 0.86473146)^2 > 1e-15 }
    /^0,1,/ { bad += ($4 + 0.97000436)^2 + ($6 - 0.97000436)^2 + ($8)^2 > 1e-13 || ($13 - 0.93240737)^2 > 1e-13 }
    /^0,2,/ { bad += ($3 - 6.32591398)^2 > 4e-14 } END { exit bad != 0 }' out || fail "returns on the eight: $(tail -3 out)"
expect 0 '^8,' jellett lyapunov ./figure_eight.tt --section y3=0 --direction down --start $free,u3=-0.93240737,v3=-0.86473146 \
    --returns 8
awk -F, '/^8,/ { exit !(NF == 14 && $14 == 0) }' out || fail "exponents of twelve states: $(tail -1 out)"
expect 0 '19 checks hold, 0 fail' jellett verify ./figure_eight.tt

# Suslov with levels: without the products of inertia the flow keeps volume, whose flux through the section has the density
# gamma1'/det d(E, gamma)/d(omega1, gamma3) = -omega2/(2 omega1) in (omega2, gamma2): det DP is the ratio of it. The fifth return
# has another sign of omega1, another branch: there is no derivative of it.
two=(./suslov.tt --section gamma1=0 --direction down --level E=2,gamma=1 --solve omega1=1,gamma3=0.9)
expect 0 '^0,5,' jellett section "${two[@]}" --start omega2=0.3,gamma2=0.2 --returns 5 --check
awk -F, '/^0,[0-5],/ { flux = $4/$6; if ($2 >= 1 && $2 <= 4) { n++; bad += ($10 - last/flux)^2 > 1e-20 } last = flux;
    of_last = $10 }
    END { exit !(n == 4 && !bad && $6 < 0 && of_last == "") }' out || fail "Suslov: $(tail -6 out)"
# Where omega2 = 0 gamma1 stays 0: such an orbit lies in the section, which it meets by rounding alone, and is no periodic point of
# it.
expect 4 "finds no periodic orbit" jellett orbits "${two[@]}" --start omega2=0.3,gamma2=0.2 --period 1
expect 3 "reversor that takes the section to itself" jellett separation "${two[@]}" --grid omega2=0.1:0.5:2,gamma2=0.1:0.3:2 \
    --cells omega2=0.1:0.5:2,gamma2=0.1:0.3:2 --returns 2
expect 4 "a return left the branch of --solve" jellett lyapunov "${two[@]/#down/both}" --start omega2=0.3,gamma2=0.2 --returns 9

# A sleigh that a rotor drives: det DP is the exponential of the divergence; the phase is met once in 2 pi/w.
rotor=(./sleigh_rotor.tt --section phi=0 --modulo 'phi=2*pi')
expect 0 'worst relative defect' jellett section "${rotor[@]}" --start v=1,om=0.1 --returns 10 --check
awk -F, '/^0,10,/ { exit !(($3 - 62.83185307179586)^2 < 1e-18) }' out || fail "the sleigh's tenth return: $(tail -1 out)"
expect 0 '^10,' jellett lyapunov "${rotor[@]}" --start v=1,om=0.1 --returns 10 --skip 5

# A rattleback: P^(1/lambda) R is kept as well, so that orbits on a level of E close: P and R of S = 0 change places and come back.
expect 0 '^0,4,' jellett section ./rattleback.tt --section S=0 --direction both --level E=0.05 --solve R=0.3 --start P=0.1 \
    --returns 4
awk -F, '/^0,[024],/ { n++; bad += ($4 - 0.1)^2 > 1e-22 } /^0,[13],/ { bad += !($4 > 0.1) } END { exit !(n == 3 && !bad) }' out ||
    fail "rattleback: $(tail -5 out)"

# Chua's circuit with a cubic: Newton's steps from here lead to where nothing returns, though the start does, 1.5 later. orbits goes
# on to where the start settles, and no command calls its return too long. Oracle: multipliers of the variational equations by
# scipy's DOP853 at 1e-13: 0.778295434, 1, and 3.5e-10.
cat > chua.tt << 'T'
model chua
state x
state y
state z
eq x = 17*(y - x^3 + 143*x/1000)/2
eq y = x - y + z
eq z = -16*y
T
expect 0 'attracting' jellett orbits ./chua.tt --section x=0 --start y=0.3,z=-1
awk -F, '/^1,/ { exit !(($4 - 1.7552189906362285)^2 < 1e-20 && ($7 - 0.778295434)^2 < 1e-18) }' out || fail "Chua: $(tail -1 out)"
expect 4 "finds no periodic orbit from y=0.3,z=-1: try another" jellett certify sink ./chua.tt --section x=0 --start y=0.3,z=-1

# Separatrices on a level: columns and words have the section's own names.
level=(./henon_heiles.tt --section x=0 --level E=1/12 --solve px=0.3)
expect 0 '^branch,side,sigma,length,y,py$' jellett manifolds "${level[@]}" --start y=-0.12,py=0 --length 0.3 --no-crossings
grep -q '^# saddle of period 1: y=-0.12030059' out || fail "the saddle: $(grep saddle out)"
expect 3 "the orbit near .* \(y=-?0.[0-9]*, py=.*\) is no saddle but centre" jellett manifolds "${level[@]}" --start y=0.25,py=0
expect 0 '^y,py,exponent,t$' jellett lyapunov "${level[@]}" --grid y=-0.1:0.1:2,py=0 --returns 3
expect 3 "y has no range" jellett separation "${level[@]}" --mirror x,py
expect 3 "^jellett: --cells, by default 200x200: y has no range" jellett separation "${level[@]}" --mirror x,py \
    --grid y=-0.1:0.2:2,py=0.05
expect 0 '^4,' jellett separation "${level[@]}" --mirror x,py --grid y=-0.1:0.2:2,py=0.05 --cells y=-0.5:0.6:9,py=-0.4:0.4:9 \
    --returns 4 --settle 2

# Returns of a start beside a strongly unstable orbit lead away from it, so that three of them are no guess of its points. Orbits
# about the point between two bodies, with v at y = 0 and the time as found by a Runge-Kutta method and bisection: multipliers of
# 2592 and 1839. With a residual of 1e-12 T is known to 1e-11.
printf '%s\n' 'model between' 'param m > 0' 'default m = 1/100' 'state x' 'state y' 'state u' 'state v' \
    'root r1 = sqrt((x + m)^2 + y^2)' 'root r2 = sqrt((x - 1 + m)^2 + y^2)' 'eq x = u' 'eq y = v' \
    'eq u = 2*v + x - (1 - m)*(x + m)/r1^3 - m*(x - 1 + m)/r2^3' 'eq v = -2*u + y - (1 - m)*y/r1^3 - m*y/r2^3' \
    'integral J = (u^2 + v^2)/2 - (x^2 + y^2)/2 - (1 - m)/r1 - m/r2' 'reversor y -> -y, u -> -u' > between.tt
while read -r x v T; do
    J=$(awk -v x="$x" -v v="$v" 'BEGIN { printf "%.17g", v^2/2 - x^2/2 - 0.99/(x + 0.01) - 0.01/(0.99 - x) }')
    for off in 1e-10 1e-8 1e-7 -1e-6; do
        expect 0 '^1,.*,saddle,' jellett orbits ./between.tt --section y=0 --level J="$J" --solve v="$v" \
            --start "u=0,x=$(awk -v x="$x" -v off=$off 'BEGIN { printf "%.17g", x + off }')"
        awk -F, -v x="$x" -v T="$T" '/^1,/ { good = ($2 - x)^2 < 1e-20 && ($4 - T)^2 < 1e-20 } END { exit !good }' out ||
            fail "$off beside the orbit at $x: $(tail -1 out)"
    done
done << 'ORBITS'
0.8430787129760952 0.04295275123192166 2.718521164653545
0.8280787129760952 0.1955617105491525 2.8656162465701187
ORBITS

# The orbit that attracts, of as many returns as are asked for, comes before shorter ones, to which Newton's method goes from afar.
printf '%s\n' 'model two_wells' 'state x' 'state v' 'state phi' 'angle c s = cos(phi) sin(phi)' 'eq x = v' \
    'eq v = x - x^3 - 3*v/10 + 7*c/25' 'eq phi = 6/5' 'periodic phi = 2*pi' > two_wells.tt
for start in x=0.569,v=-0.942 x=-0.248,v=-0.013; do
    expect 0 '^2,.*,attracting,' jellett orbits ./two_wells.tt --section phi=0 --period 2 --settle 300 --start $start
done
# So it does where they are beside the start: of the Roessler system from c = 2.9, the cycle that has doubled its period; also where
# more returns are asked for than any orbit has.
for period in 2 4 6; do
    expect 0 '^2,.*,attracting,' \
        jellett orbits roessler --section y=0 --direction down --set c=3.5 --start x=-5,z=0.04 --period $period
done
exit $status
