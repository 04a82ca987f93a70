#!/usr/bin/env bash
# States that are 0 only together, as both parts of an oscillation's amplitude, or the infected of all stages of an epidemic, keep
# their digits however small they become.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
# z = x + i y is z0 exp(k (cos t - 1) + i w t): it falls to 1e-26 of z0 and is z0 again after 2 pi, w being 3. Another oscillation,
# u, which z drives, keeps its size. An error of the tolerance, 1e-12, a step is 64 times that beside it, in fewer than 400 steps.
cat > turned.tt << 'T'
model turned
param k
param w
default k = 30, w = 3
state x
state y
state u
state v
state phase
angle c s = cos(phase) sin(phase)
periodic phase = 2*pi
eq x = - k*s*x - w*y
eq y = w*x - k*s*y
eq u = v
eq v = x - u
eq phase = 1
T
turn=6.283185307179586
is_back() { # X Y WHAT, the columns of x and y: the last row of `out`
    awk -F, -v x="$1" -v y="$2" '/^[0-9]/ { off = ($x - 1)^2 + $y^2 } END { exit !(off < (64*400*1e-12)^2) }' out ||
        fail "z does not come back $3: $(tail -1 out)"
}
for method in gauss dop853 taylor rk8pd rkf45 msadams; do
    expect 0 ',alive$' jellett simulate ./turned.tt --start x=1,y=0,u=0,v=1,phase=0 --times $turn --method $method
    is_back 2 3 "by $method"
    expect 0 '^0,1,' jellett section ./turned.tt --section phase=0 --start x=1,y=0,u=0,v=1 --returns 1 --method $method
    is_back 4 5 "on a section by $method"
done
expect 0 '^1,1,' jellett section ./turned.tt --section phase=0 --grid x=0.5:1:2,y=0,u=0,v=1 --returns 1
is_back 4 5 "in lanes"
# Nor do tangents along the pair lose theirs where it is 0, though steps do not see it: the derivative over a turn is a rotation.
sed '/^state [uv]$/d; /^eq [uv] /d' turned.tt > alone.tt
for how in "--start x=0,y=0" "--grid x=0:0:1,y=0:0:1" "--start x=0,y=0 --method "{dop853,rk8pd,rkf45,msadams}; do
    for w in 3.25,0 3.1,1.618033988749895; do
        expect 0 '^0,1,' jellett section ./alone.tt --set w=${w%,*} --section phase=0 $how --returns 1 --check
        awk -F, -v trace="${w#*,}" '/^0,1,/ { exit !(($7 - trace)^2 + ($8 - 1)^2 < 1e-16) }' out ||
            fail "derivative, w = ${w%,*}, $how: $(tail -1 out)"
    done
done
# From x = 0 and y > 0 crossings of x = 0 upwards are where w t is pi, 3 pi, ..., however small z is there.
for how in "" "--method gauss" "--method dop853"; do
    expect 0 '^1,6,' jellett section ./turned.tt --section x=0 --grid y=0.5:1:2,u=0,v=1,phase=0 --returns 6 $how
    awk -F, -v how="$how" '/^[01],[1-6],/ { n++; off = $3 - 3.141592653589793*(2*$2 - 1)/3; bad += !(off*off < 1e-16) }
        END { exit !(n == 12 && !bad) }' out || fail "crossings of x = 0 ${how:-in lanes}: $(grep -v '^#' out)"
done
# So it is at a level of 1e-20, to which z falls between the second and the third crossing of x = 0: y exp(k cos t - k) sin w t.
for how in "" "--method gauss"; do
    expect 0 '^1,2,' \
        jellett section ./turned.tt --section x=1e-20 --direction both --grid y=0.5:1:2,u=0,v=1,phase=0 --returns 2 $how
    awk -F, -v how="$how" '/^[01],2,/ { n++; off = $3 - (/^0/ ? 2.039464456611461 : 2.05400518132331); bad += !(off*off < 1e-16) }
        END { exit !(n == 2 && !bad) }' out || fail "crossings of x = 1e-20 ${how:-in lanes}: $(grep -v '^#' out)"
done
# Slowly through a Hopf point: the same orbit in polar coordinates, whose radius keeps its sign.
printf '%s\n' 'model slow' 'state x' 'state y' 'state mu' 'eq x = mu*x - y - x*(x^2 + y^2)' 'eq y = x + mu*y - y*(x^2 + y^2)' \
    'eq mu = 1/100' > slow.tt
printf '%s\n' 'model polar' 'state r' 'state mu' 'eq r = mu*r - r^3' 'eq mu = 1/100' > polar.tt
expect 0 '^200,' jellett simulate ./polar.tt --start r=0.5,mu=-1 --times 200
radius=$(tail -1 out | cut -d, -f2)
for method in gauss dop853 taylor rk8pd rkf45 msadams; do
    expect 0 '^200,' jellett simulate ./slow.tt --start x=0.5,y=0,mu=-1 --times 200 --method $method
    awk -F, -v r="$radius" '/^200,/ { off = sqrt($2^2 + $3^2)/r - 1 } END { exit !(off*off < 1e-18) }' out ||
        fail "slowly through a Hopf point by $method: $(tail -1 out), r = $radius"
done
# Beside a focus that repels, and a saddle, an orbit is not at rest, however near it is, while others of its states are: from 1e-30
# it grows as exp(t/10), or as exp(t), beyond all numbers. Where it is exactly there, and where the focus attracts, it is at rest.
printf '%s\n' 'model beside' 'param a' 'param b' 'param c' 'default a = 1/10, b = -1, c = 1' 'state x' 'state y' 'state u' \
    'state w' 'eq x = a*x + b*y' 'eq y = c*x + a*y' 'eq u = -u' 'eq w = w*(1 - w)' > beside.tt
at_rest() { # START OPTION...: follow an orbit that never comes to the section, and tell whether it comes to rest
    jellett fates ./beside.tt --section u=-1 --start "$1,w=1" --returns 1 "${@:2}" > out 2> err
    grep -q ',equilibrium,' out
}
for how in "" "--set a=0,b=1" "--set a=0,b=1 --method dop853"; do
    at_rest x=0,y=0 $how || fail "exactly there, ${how:-a focus}: $(tail -1 out)"
    ! at_rest x=1e-30,y=0 $how || fail "near ${how:-a focus}: $(tail -1 out)"
done
at_rest x=1,y=0 --set a=-1/10 || fail "a focus that attracts: $(tail -1 out)"
# Nor does a group grow where it is at rest: x = z = R = 1 attracts, by eigenvalues -1 and (-9 +- sqrt(41))/2, though with z = 1
# held it would repel x. Rates are below 1e-9 from t = 21 on, and an orbit is at rest 64 steps later, none of which is longer
# than 1.
printf '%s\n' 'model held' 'state x' 'state z' 'state R' 'state q' 'eq x = x*(x - z)' 'eq z = 10*(2*x - 1 - z)' 'eq R = x - R' \
    'eq q = -q' > held.tt
for method in gauss taylor; do
    expect 0 ',equilibrium,' jellett fates ./held.tt --section q=-1 --start x=1.1,z=1,R=0.3 --returns 1 --method $method
    awk -F, '/equilibrium/ && $5 < 100 { n++ } END { exit !n }' out || fail "at rest late, by $method: $(tail -1 out)"
done
# The infected of an epidemic, in three stages that feed each other, fall to 1e-29 between two outbreaks: the same orbit in their
# logarithms. `who` turns beside it, so that the orbit has a section.
printf '%s\n' 'model staged' 'state S' 'state E' 'state F' 'state I' 'state who' 'state turns' 'eq S = (1 - S)/50 - 100*S*I' \
    'eq E = 100*S*I - 20*E' 'eq F = 20*E - 20*F' 'eq I = 20*F - 30*I' 'eq who = turns' 'eq turns = -who' > staged.tt
printf '%s\n' 'model logs' 'state S' 'state e' 'state f' 'state i' 'exp N = exp(i - e)' 'exp P = exp(e - f)' 'exp Q = exp(f - i)' \
    'exp J = exp(i)' 'eq S = (1 - S)/50 - 100*S*J' 'eq e = 100*S*N - 20' 'eq f = 20*P - 20' 'eq i = 20*Q - 30' > logs.tt
start=$(awk 'BEGIN { x = log(1e-3); printf "S=0.99,e=%.17g,f=%.17g,i=%.17g", x, x, x }')
expect 0 'alive$' jellett simulate ./logs.tt --start "$start" --times 18.84955592153876 # 6 pi
infected=$(tail -1 out | cut -d, -f3-5)
is_small() { # COLUMN HOW: e, f and i are the logarithms of the three columns from this one on, in the rows of 6 pi
    awk -F, -v at="$1" -v right="$infected" 'BEGIN { split(right, log_of) } !/^#/ && /18[.]84955592/ { n++
        for (k = 1; k <= 3; k++) { off = log($(at + k - 1)) - log_of[k]; bad += !(off*off < 1e-18) } }
        END { exit bad || !n }' out ||
        fail "an epidemic in stages $2: $(tail -1 out), and the logarithms are $infected"
}
for method in gauss dop853 taylor rk8pd rkf45 msadams; do
    expect 0 'alive$' jellett simulate ./staged.tt --start S=0.99,E=1e-3,F=1e-3,I=1e-3,who=0,turns=1 --times 18.84955592153876 \
        --method $method
    is_small 3 "by $method"
done
expect 0 'alive$' jellett section ./staged.tt --section who=0 --grid S=0.99:0.99:1,E=1e-3,F=1e-3,I=1e-3,turns=1:2:2 --returns 3
is_small 5 "in lanes"
# A state whose series is all that doubles may lose, as the others are clocks, is followed by taylor as well: exp(-t) to 665 in at
# most a step per unit of time, each with an error of 1e-12, and below 1e-290; and 1e-287 exp(5 (1 - cos t)), whose coefficients of
# odd order are 0 at the start, over a turn in fewer than 100 steps.
cat > clock.tt << 'T'
model clock
state n
state m
state s
angle C S = cos(s) sin(s)
periodic s = 2*pi
eq n = - n
eq m = 5*S*m
eq s = 1
T
expect 0 '^1000,.*,alive$' jellett simulate ./clock.tt --start n=1,m=0,s=0 --times 665,1000 --method taylor
awk -F, '/^665,/ { n++; off = $2 / 1.5637579633862188e-289 - 1 } END { exit !(n == 1 && off^2 < (665e-12)^2) }' out ||
    fail "exp(-665): $(grep ^665 out)"
expect 0 '^0,1,' jellett section ./clock.tt --section s=0 --start n=0,m=1e-287 --returns 1 --method taylor
awk -F, '/^0,1,/ { n++; off = $5 / 1e-287 - 1 } END { exit !(n == 1 && off^2 < (100e-12)^2) }' out || fail "m: $(tail -1 out)"
# A state may be in several groups. Of a rigid body any two of p, q and r stay 0 together: p and r grow from 1e-20 beside q until
# the body turns over, p = P dn(P sqrt(2) t - K) with P^2 = 1/2 + 1e-40. The infected hosts and vectors of an epidemic stay 0
# together, as do all hosts, and all vectors; at 30 they are solved for with 30 digits (mpmath).
cat > body.tt << 'T'
model body
state p
state q
state r
state s
periodic s = 2*pi
eq p = q*r
eq q = -2*p*r
eq r = p*q
eq s = 1
integral L = q^2 + 2*p^2
integral K = p^2 - r^2
T
cat > vectors.tt << 'T'
model vectors
state H
state I
state V
state J
state s
periodic s = 2*pi
eq H = - 3*H*J + I
eq I = + 3*H*J - I
eq V = - 2*V*I + J
eq J = + 2*V*I - J
eq s = 1
integral hosts = H + I
integral vectors = V + J
T
# A state that keeps its sign may drive others that are 0 only with it: R + i T is I (exp((2 + 5 i) t) - 1)/(2 + 5 i), where I is
# 1e-20 exp(-t).
cat > driven.tt << 'T'
model driven
state I
state R
state T
state u
state v
state s
periodic s = 2*pi
eq I = - I
eq R = I + R - 5*T
eq T = 5*R + T
eq u = v
eq v = - u
eq s = 1
T
is_grown() { # COLUMN VALUE WHAT: the last row of `out`, after fewer than 400 steps
    awk -F, -v at="$1" -v right="$2" '/^[0-9]/ { off = $at/right - 1 } END { exit !(off^2 < (64*400*1e-12)^2) }' out ||
        fail "$3 has not grown to $2: $(tail -1 out)"
}
for method in gauss dop853 taylor rk8pd rkf45 msadams; do
    expect 0 ',alive$' jellett simulate ./body.tt --start p=1e-20,q=1,r=0,s=0 --times 46 --method $method
    is_grown 2 0.42670736530497844 "a body's wobble, by $method,"
    expect 0 ',alive$' jellett simulate ./vectors.tt --start H=1,I=1e-20,V=1,J=0,s=0 --times 30 --method $method
    is_grown 3 0.036199530466018979 "an epidemic, by $method,"
    expect 0 ',alive$' jellett simulate ./driven.tt --start I=1e-20,R=0,T=0,u=0,v=1,s=0 --times 46 --method $method
    is_grown 3 -0.15245243351797816 "what a kept state drives, by $method,"
done
for how in "" "--project" "--method gauss --project"; do
    expect 0 ',alive$' jellett section ./body.tt --section s=0 --grid p=1e-20:1e-20:2,q=1,r=0 --returns 7 $how
    is_grown 4 0.063004909007938892 "a body's wobble on a section $how"
    expect 0 ',alive$' jellett section ./vectors.tt --section s=0 --grid H=1,I=1e-20:1e-20:2,V=1,J=0 --returns 4 $how
    is_grown 5 3.3124067142914556e-5 "an epidemic on a section $how"
    [ "${how%--project}" = "$how" ] || continue
    expect 0 ',alive$' jellett section ./driven.tt --section s=0 --grid I=1e-20:1e-20:2,R=0,T=0,u=0,v=1 --returns 7 $how
    is_grown 5 0.0087076497413244689 "what a kept state drives, on a section $how"
done
exit $status
