#!/usr/bin/env bash
# States that are integrals over what is followed without error, or nearly so: stages of a step that stand at one instant agree
# there, and tell nothing of what is left out. In lanes of every width and by both methods against closed forms, and against one
# orbit alone.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
near() { # WHAT FILE COLUMN ROW VALUE ALLOWED: a row of the first orbit
    awk -F, -v n="$4" -v c="$3" -v v="$5" -v e="$6" '$1 == 0 && $2 == n { off = $c - v; ok = off*off <= e*e }
        END { exit !ok }' "$2" ||
        fail "$1: $(grep "^0,$4," "$2") and not $5"
}

# s = sin th + e sin(n th), th' = 1: ten turns take 20 pi.
cat > ripple.tt << 'T'
model ripple
param e
param n > 0
default e = 0, n = 40
state s
state th
angle C S = cos(th) sin(th)
angle D R = cos(n*th) sin(n*th)
eq s = C + e*n*D
eq th = 1
T
# A hundred tolerances for some hundred steps; a ripple is one that steps have to resolve.
for lanes in 2 4 8; do
    for tolerance in 1e-4 1e-6 1e-8 1e-10 1e-12 1e-14; do
        JELLETT_LANES=$lanes jellett section ./ripple.tt --section s=0 --start th=0.1 --start th=0.2 -n 10 \
            --tol $tolerance > rows.csv
        near "a quadrature in $lanes lanes at $tolerance" rows.csv 3 10 62.83185307179586 "$(awk -v t=$tolerance \
            'BEGIN { print 100*t + 1e-13 }')"
    done
    for tolerance in 1e-8 1e-10 1e-12; do
        JELLETT_LANES=$lanes jellett section ./ripple.tt --section s=0 --set e=0.001 --start th=0.1 --start th=0.2 -n 10 \
            --tol $tolerance > rows.csv
        near "a ripple in $lanes lanes at $tolerance" rows.csv 3 10 62.83185307179586 "$(awk -v t=$tolerance \
            'BEGIN { print 1000*t + 1e-13 }')"
    done
done

# Ripples of which the estimates see nothing: steps that are taken again in halves show them, and gauss follows those orbits. Rows
# stay independent of threads and company.
for lanes in 2 4 8; do
    export JELLETT_LANES=$lanes
    for case in n=8,e=1.25e-5 n=8,e=1.25e-6 n=13,e=7.7e-6 n=13,e=7.7e-7 n=20,e=5e-6 n=20,e=5e-7; do
        for tolerance in 1e-9 1e-12; do
            jellett section ./ripple.tt --section s=0 --set $case --grid th=0.1:0.4:16 -n 10 --tol $tolerance > rows.csv
            awk -F, -v t=$tolerance '/^[0-9]/ && $2 == 10 { off = $3 - 62.83185307179586; n++; bad += off^2 > (100*t + 1e-13)^2 }
                END { exit n != 16 || bad }' rows.csv || fail "ripples $case in $lanes lanes at $tolerance: $(grep ',10,' rows.csv)"
        done
    done
    for threads in 1 2; do
        jellett section ./ripple.tt --section s=0 --set n=13,e=7.7e-7 --grid th=0.1:0.4:16 -n 10 --threads $threads |
            grep -v '^#' > rows_$threads.csv
    done
    cmp -s rows_1.csv rows_2.csv || fail "ripples in $lanes lanes on two threads: $(cat rows_2.csv)"
    jellett section ./ripple.tt --section s=0 --set n=13,e=7.7e-7 --start th=0.4 --start th=0.38 -n 10 > rows.csv
    cmp -s <(grep '^15,' rows_1.csv | cut -d, -f2-) <(grep '^0,' rows.csv | cut -d, -f2-) ||
        fail "a ripple in $lanes lanes in other company: $(cat rows.csv)"
done
unset JELLETT_LANES

# A plane motion whose heading turns ever more slowly, and a weak feedback: alone by gauss, in lanes by the others.
cat > walk.tt << 'T'
model walk
param k > 0
default k = 0.0001
state x
state y
state th
state w
angle c s = cos(th) sin(th)
eq x = c - k*x/10
eq y = s
eq th = w
eq w = - k*w
T
jellett section ./walk.tt --section x=0 --start y=0,th=0.3,w=1 -n 5 > alone.csv
jellett section ./walk.tt --section x=0 --start y=0,th=0.3,w=1 --start y=0,th=0.5,w=1 -n 5 > rows.csv
awk -F, 'NR == FNR { if ($1 == 0) { t[$2] = $3; y[$2] = $4 } next }
    $1 == 0 { n++; bad += ($3 - t[$2])^2 > 1e-20 || ($4 - y[$2])^2 > 1e-20 } END { exit n != 6 || bad }' alone.csv rows.csv ||
    fail "a walk alone and in lanes: $(cat alone.csv rows.csv)"
jellett lyapunov ./walk.tt --section x=0 --grid y=0:1:2,th=0.3:0.5:2,w=1:1.1:2 -n 5 > rows.csv
jellett lyapunov ./walk.tt --section x=0 --grid y=0:1:2,th=0.3:0.5:2,w=1:1.1:2 -n 5 --method gauss > alone.csv
paste -d, <(grep -v '^#' rows.csv) <(grep -v '^#' alone.csv) | awk -F, '/^[0-9]/ { n++; bad += ($4 - $9)^2 > 1e-16 }
    END { exit n != 8 || bad }' || fail "exponents alone and in lanes: $(cat alone.csv rows.csv)"

# A way travelled, s' = sqrt(x^2 + d^2) on a circle: ten turns take 40 sqrt(r^2 + d^2) E(r^2/(r^2 + d^2)); the root bends each half
# turn.
printf '%s\n' 'model way' 'param d > 0' 'default d = 1/100' 'state x' 'state y' 'state s' 'root q = sqrt(x^2 + d^2)' 'eq x = y' \
    'eq y = -x' 'eq s = q' > way.tt
for d in 1/100 3/1000 1/1000; do
    jellett section ./way.tt --section x=0 --set d=$d --grid y=0.5:1.5:64,s=0:0.1:1 -n 10 --tol 1e-9 > rows.csv
    # E by the mean of geometric and arithmetic means; a hundred tolerances a turn for a way of some 60.
    awk -F, -v d=$d 'BEGIN { split(d, part, "/"); d = part[1]/part[2] }
        function way(r, a, b, c, sum, two, k) {
            a = 1; b = d/sqrt(r*r + d*d); sum = (1 - b*b)/2; two = 1/2
            for (k = 0; k < 6; k++) { c = (a - b)/2; b = sqrt(a*b); a -= c; two *= 2; sum += two*c*c }
            return 40*sqrt(r*r + d*d)*2*atan2(1, 1)/a*(1 - sum)
        }
        /^[0-9]/ && $2 == 0 { r[$1] = $4; s[$1] = $5 }
        /^[0-9]/ && $2 == 10 { off = $5 - s[$1] - way(r[$1]); n++; bad += off^2 > (60*1000*1e-9)^2 }
        END { exit n != 64 || bad }' rows.csv || fail "a way with d = $d: $(grep ',10,' rows.csv)"
done

# The pole of a field in such a state is none that a step passes over.
printf '%s\n' 'model wall' 'state x' 'state y' 'state q' 'state r' 'eq x = 1' 'eq y = 1/(x - 1)' 'eq q = r' 'eq r = -9*q' > wall.tt
jellett section ./wall.tt --section q=0 --start x=0,y=0,r=1 --start x=0.1,y=0,r=1 -n 3 > rows.csv 2> err
[ $? -eq 4 ] && grep -q '^0,1,\(0.99999999\|1\)[0-9.]*,,,,no_progress$' rows.csv ||
    fail "past a wall: $(grep -v '^#' rows.csv; cat err)"
exit $status
