#!/usr/bin/env bash
# Sections of tables of one's own: as many states as a table has, coordinates by their names, none of them guessed.
source "$JLT_SOURCE_DIR/tests/scratch.sh"

# A ring of uncoupled oscillators of frequencies 1 .. 6: after a turn of the first everything is back where it was.
{
    echo "model oscillators"
    for i in 1 2 3 4 5 6; do printf 'state q%d\nstate p%d\n' $i $i; done
    for i in 1 2 3 4 5 6; do printf 'eq q%d =\n    + %d*p%d\neq p%d =\n    - %d*q%d\n' $i $i $i $i $i $i; done
} > oscillators.tt
others=q2=0.1,p2=0.2,q3=0.3,p3=0.4,q4=0.5,p4=0.6,q5=0.7,p5=0.8,q6=0.9,p6=1
expect 0 '^0,1,' jellett section ./oscillators.tt --section q1=0 --start p1=1,$others --returns 1
grep -q '^orbit,return,t,p1,q2,p2,q3,p3,q4,p4,q5,p5,q6,p6,fate$' out || fail "columns: $(grep orbit out)"
# A return errs by about the tolerance, times the largest frequency.
awk -F, '/^0,0,/ { for (i = 4; i <= 14; i++) q[i] = $i }
    /^0,1,/ { bad = ($3 - 6.283185307179586)^2 > 1e-22; for (i = 4; i <= 14;
    i++) bad += ($i - q[i])^2 > 1e-22 } END { exit bad != 0 }' out ||
    fail "a return is not the identity: $(tail -1 out)"
# Every point is one: the search stays where it begins, and says what chooses one.
expect 0 '^1,1,0.1,0.2,.*degenerate' jellett orbits ./oscillators.tt --section q1=0 --start p1=1,$others --period 1
grep -q -- 'this is any one of it; --hold keeps' err || fail "nobody says that orbits come in a family: $(cat err)"

# Beside a clock a saddle so weak that a return hardly moves a point: the norm of DP is exp(k t). An error of k t is that of ten
# returns, each of the tolerance 1e-12, and of the norm, 1e-15.
printf 'model weak\nparam k\n' > weak.tt
printf 'state %s\n' x y u v >> weak.tt
printf 'eq x = k*y\neq y = k*x\neq u = v\neq v = -u\nintegral H = u^2 + v^2\n' >> weak.tt
for k in 1e-7 1e-5 1e-3; do
    expect 0 '' jellett lyapunov ./weak.tt --set k=$k --section u=0 --level H=1 --solve v=1 --grid x=-1:1:2,y=-1:1:2 --returns 10
    awk -F, -v k=$k '/^-?1,/ { n++; if (($3 - k)^2*$4^2 > 1e-22) exit 1 } END { if (n != 4) exit 1 }' out ||
        fail "k = $k: no exponent of k: $(grep -v '^#' out)"
done

# A coordinate that is not named is no number.
expect 3 "p6 has no range: add p6=LOW:HIGH:COUNT, or p6=VALUE" \
    jellett section ./oscillators.tt --section q1=0 --grid p1=1:2:3,${others%,p6=1}
expect 3 "no coordinate 'r'" jellett section ./oscillators.tt --section q1=0 --grid p1=1:2:3,r=1,$others
expect 0 '^2,1,' jellett section ./oscillators.tt --section q1=0 --grid p1=1:2:3,$others --returns 1
expect 3 "x has no range" jellett section lorenz --section z=27 --grid 3x3
expect 3 "y has no range" jellett lyapunov lorenz --section z=27 --grid x=1:2:3 --returns 1
expect 2 "say where to search: --start or --grid" jellett orbits lorenz --section z=27
expect 3 "q has no range" jellett separation nose_hoover --section z=0 --mirror p,z
exit $status
