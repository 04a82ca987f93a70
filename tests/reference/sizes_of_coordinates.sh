#!/usr/bin/env bash
# A model may count in any units: periodic orbits, their branches and separatrices are the same ones, as large as the unit says; and
# where coordinates are small no point is an orbit for that.
set -uo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
export XDG_CACHE_HOME=$scratch/cache LC_ALL=C
status=0
fail() { echo "$*" | cut -c1-300 | head -5; status=1; }

# Duffing's oscillator in a double well at +-L, driven; x and v are proportional to L.
cat > well.tt <<'TABLE'
model well
param d >= 0
param f
param w > 0
param L > 0
default d = 0.2, f = 0.3, w = 1, L = 1
state x
state v
state phi
angle C S = cos(phi) sin(phi)
eq x = v
eq v = -d*v + x - x^3/L^2 + f*L*C
eq phi = w
periodic phi = 2*pi
TABLE
times() { awk -v k="$1" -v L="$2" 'BEGIN { printf "%.17g", k*L }'; }
rows() { grep -v '^#' "$1" | tail -n +2; }
# COLUMN COLUMN BOUND NAME: these columns of rows.csv, over L, against those of ones.csv.
same() {
    paste -d, ones.csv rows.csv | awk -F, -v L="$L" -v a="$1" -v b="$2" -v bound="$3" '
        { half = NF/2; for (k = a; k <= b; k++) worst = (d = $k - $(half + k)/L)^2 > worst ? d^2 : worst }
        END { exit !(NR > 0 && worst < bound*bound) }' || fail "L = $L: $4: $(cat rows.csv), not L times $(cat ones.csv)"
}

# 1. Three orbits of one period: a weak one in either well, and the strongly unstable one between. Errors are those of a return,
# tenfold the tolerance 1e-13, times |(I - DP)^-1| DP < 3, and those of small L, whose tolerance is that part of 1.
for L in 1 1e3 1e9 1e-3 1e-6; do
    reach=$(times 2 "$L")
    jellett orbits ./well.tt --set L="$L" --section phi=0 --period 1 --near 2 --grid "x=-$reach:$reach:20,v=-$reach:$reach:20" \
        > out 2> err || fail "L = $L: $(cat err)"
    rows out | cut -d, -f2,3 > rows.csv
    [ "$L" != 1 ] || cp rows.csv ones.csv
    [ "$(wc -l < rows.csv)" -eq 3 ] || fail "L = $L: not three orbits but $(cat rows.csv)"
    same 1 2 "$(awk -v L="$L" 'BEGIN { print 1e-11 * (L < 1 ? 1/L : 1) }')" orbits
done
grep -q '^-0.14984260287' ones.csv || fail "no saddle between the wells: $(cat ones.csv)" # -f/2 to first order, and by SciPy

# 2. No orbit begins near here: from a start that Newton's method does not improve nothing is told, small as it is.
for L in 1e-9 1e-10 1e-12; do
    jellett orbits ./well.tt --set L="$L" --section phi=0 --period 1 --start "x=$(times -2 "$L"),v=$(times 0.6 "$L")" > out 2> err
    [ $? -eq 4 ] || fail "L = $L: an orbit where there is none: $(rows out)"
done

# 3. The branch of the orbit in the left well, up to where the force ends.
for L in 1 1e6 1e-7 1e-12; do
    start=x=$(times -1.18 "$L"),v=$(times 0.569 "$L")
    jellett continue ./well.tt --set L="$L" --section phi=0 --along f=0.25:0.3 --start "$start" > out 2> err ||
        fail "L = $L: $(cat err)"
    rows out | tail -1 | cut -d, -f5,6 > rows.csv
    [ "$L" != 1 ] || cp rows.csv ones.csv
    same 1 2 1e-11 branch
done

# 4. A branch in a parameter of whatever size ends where the range does, and has its fold on the way: x = +-sqrt(p/q).
cat > fold.tt <<'TABLE'
model fold
param p
param q > 0
default p = 0, q = 1
state x
state phi
eq x = p/q - x^2
eq phi = 1
periodic phi = 2*pi
TABLE
for q in 1 1e-6 1e6; do
    jellett continue ./fold.tt --section phi=0 --set "q=$q,p=$(times 0.25 "$q")" --along "p=$(times -0.25 "$q"):$(times 0.3 "$q")" \
        --start x=0.5 --decreasing > out 2> err || fail "q = $q: $(cat err)"
    [ "$(grep -c ',fold,' out)" -eq 1 ] || fail "q = $q: $(grep -c ',fold,' out) folds"
    grep -q 'branch 0: the range ends' err || fail "q = $q: $(cat err)"
done
# 5. Small coordinates make no orbits: with no point of a branch beyond its fold. Radii of r' = r (b + r^2 - r^4) are roots of a
# quadratic, and cease at b = -1/4; x' = -x + x^2 + e cos t has periodic solutions up to e with a_0(2 e) = -1, Mathieu's (SciPy).
cat > radius.tt <<'TABLE'
model radius
param b
param L > 0
default b = -0.2, L = 1
state x
state y
let q = (x^2 + y^2)/L^2
eq x = x*(b + q - q^2) - y
eq y = y*(b + q - q^2) + x
TABLE
cat > riccati.tt <<'TABLE'
model riccati
param e
param L > 0
default e = 0.01, L = 1
state x
state phi
angle C S = cos(phi) sin(phi)
eq x = -x + x^2/L + L*e*C
eq phi = 1
periodic phi = 2*pi
TABLE
for L in 1 1e-3 1e-6 1e-9 1e-12 1e9; do
    jellett continue ./radius.tt --set L="$L" --section y=0 --start "x=$(times 0.85 "$L")" --along b=-0.3:0.1 --decreasing \
        > out 2> err || fail "L = $L: $(cat err)"
    rows out | awk -F, -v L="$L" '{ q = ($5/L)^2; bad += ($2 + q - q*q)^2 > 1e-18; folds += /,fold,/ && ($2 + 1/4)^2 < 1e-18 }
        END { exit !(NR > 9 && !bad && folds == 1) }' ||
        fail "L = $L: points that are no orbits: $(rows out | tail -3)"
    jellett continue ./riccati.tt --set L="$L" --section phi=0 --start x=0 --along e=0.001:0.9 > out 2> err ||
        fail "L = $L: $(cat err)"
    rows out | awk -F, '{ bad += $2 > 0.779150542352136 + 1e-9; folds += /,fold,/ && $2 > 0.779150542352136 - 1e-9 }
        END { exit !(NR > 9 && !bad && folds == 1) }' || # the orbit grows by a thousand from where it begins
        fail "L = $L: points beyond the fold: $(rows out | tail -3)"
done

# One orbit by every method: errors are relative to the start's size, and so is the drift. In 20 units of time an error of the
# tolerance 1e-12 grows by its share a step, by shear, to less than a thousand of it.
cat > spring.tt <<'TABLE'
model spring
param L > 0
default L = 1
state x
state v
eq x = v
eq v = -x - x^3/L^2
integral H = v^2/2 + x^2/2 + x^4/(4*L^2)
TABLE
spring() { jellett simulate ./spring.tt --set L="$1" --start x="$1",v=0 --times 20 --method "$2" 2> err | tail -1; }
of_one=$(spring 1 gauss)
for method in gauss dop853 taylor msadams; do
    for L in 1e-3 1e-9 1e-20 1e-60; do
        row=$(spring "$L" "$method")
        echo "$of_one,$row" | awk -F, -v L="$L" '
            function far(a, b) { return (a - b)^2 > 1e-18 }
            { exit far($2, $7/L) || far($3, $8/L) || $9 > 1e-9 || $9 == 0 }' || fail "$method, L = $L: $row, not L times $of_one"
    done
done
# On a section too, in lanes, alone and with derivatives: the orbit is closed, so that ten returns are at its start but for ten
# tolerances, and DP is 1.
returned() { jellett section ./spring.tt --set L="$1" --section v=0 --start "x=-$1" --returns 10 "${@:2}" 2> err | tail -1; }
period=$(returned 1 | cut -d, -f3)
for how in '--tol=1e-12' '--method=dop853' '--check' '--project' '--backward'; do
    for L in 1e-3 1e-9 1e-20 1e-60; do
        row=$(returned "$L" "$how")
        echo "$row" | awk -F, -v L="$L" -v period="$period" '
            function far(a, b) { return (a/b - 1)^2 > 1e-22 }
            { exit $2 != 10 || $5 != "alive" || far($4, -L) || far($3 < 0 ? -$3 : $3, period) || (NF > 5 && far($6, 1)) }' ||
            fail "section $how, L = $L: $row, not at the start after $period"
    done
done
# The same motion by any clock: x' = e (-x + cos phi), whose second return is at 4 pi/e; its x is that of e = 1 within the tolerance
# 1e-12 for each unit of time.
cat > clock.tt <<'TABLE'
model clock
param e > 0
default e = 1
state x
state phi
angle C S = cos(phi) sin(phi)
eq x = e*(-x + C)
eq phi = e
periodic phi = 2*pi
TABLE
clock() { jellett section ./clock.tt --set e="$1" --section phi=0 --start x=0.2 --returns 2 --method "$2" 2> err | tail -1; }
of_one=$(clock 1 gauss)
for method in gauss dop853; do
    for e in 1e-6 1e-11 1e-14 1e-50 1e9; do
        row=$(clock "$e" "$method")
        echo "$of_one,$row" | awk -F, -v e="$e" '{ exit $10 != "alive" || ($3/e/$8 - 1)^2 > 1e-22 || ($4 - $9)^2 > 1e-22 }' ||
            fail "$method, e = $e: $row, not as $of_one"
    done
done

# A state that only counts, and is far larger than the others, leaves these their digits: in lanes each errs by at most 64 times the
# tolerance a step, of which fifty returns take fewer than 4000.
printf 'model counted\nstate x\nstate v\nstate z\neq x = v\neq v = -x^3\neq z = 1/5\n' > counted.tt
counted() {
    jellett section ./counted.tt --section v=0 --start x=1,z="$1" --start x=0.9,z="$1" --returns 50 --direction down 2> err |
        grep -E '^[01],50,' | cut -d, -f3,4
}
paste -d, <(counted 0) <(counted 1e9) |
    awk -F, '{ if (($3/$1 - 1)^2 > (4000*64e-12)^2 || ($4/$2 - 1)^2 > (4000*64e-12)^2) exit 1 } END { if (NR != 2) exit 1 }' ||
    fail "beside a large state: $(counted 0) and $(counted 1e9)"

# States that hardly move, one of them by less than can be told, move each other as any do: with (b, c) = exp(A t) of A with the
# eigenvalues -1/9 +- i/10, the norm of DP is exp(-t/9) times the larger singular value of (cos, 10 sin; -sin/10, cos) at t/10.
printf '%s\n' 'model hardly' 'state b' 'state c' 'state phi' 'angle co si = cos(phi) sin(phi)' 'eq b = -b/9 + c + 1e-10*co' \
    'eq c = -c/9 - b/100' 'eq phi = 1' 'periodic phi = 2*pi' > hardly.tt
jellett lyapunov ./hardly.tt --section phi=0 --grid b=0:0:1,c=0:0:1 --returns 8 > out 2> err || fail "a chart: $(cat err)"
tail -1 out | awk -F, '{ t = $4; S = 2*cos(t/10)^2 + 100.01*sin(t/10)^2; true = log((S + sqrt(S*S - 4))/2)/2/t - 1/9
    exit !((t - 50.26548245743669)^2 < 1e-18 && ($3 - true)^2 < 1e-18) }' || fail "the exponent of a chart: $(tail -1 out)"
jellett lyapunov ./hardly.tt --section phi=0 --start b=0,c=0 --returns 4000 > out 2> err || fail "a history: $(cat err)"
tail -1 out | awk -F, '{ exit !(($3 + 1/9)^2 < 1e-6 && ($4 + 1/9)^2 < 1e-6) }' || fail "exponents: $(tail -1 out): $(cat err)"

# Beside an orbit that stretches by exp(2 pi a) motions run off by as much, and in such sizes any point that comes near it returns
# to itself. x = -1/(1 + a^2) is the only orbit, found to 1e-8 of its size, or beyond 1e11 perhaps not at all.
printf '%s\n' 'model steep' 'param a' 'default a = 3' 'state x' 'state v' 'state phi' 'angle co si = cos(phi) sin(phi)' 'eq x = v' \
    'eq v = a^2*x + co' 'eq phi = 1' 'periodic phi = 2*pi' > steep.tt
for a in 1 3.5 4 4.25 4.5 5 6; do
    for where in '--start x=0,v=0.01' '--start x=-0.05,v=0.001' '--grid x=-1:1:3,v=-1:1:3'; do
        jellett orbits ./steep.tt --set a=$a --section phi=0 --period 1 $where 2> err | grep '^1,' > rows.csv
        awk -F, -v a=$a -v grid="${where/--start*/}" '{ rows++; bad += ($2*(1 + a*a) + 1)^2 + ($3*(1 + a*a))^2 > 1e-16 }
            END { exit bad > 0 || (a < 4.1 && grid == "" && rows != 1) }' rows.csv || fail "a = $a, $where: $(cat rows.csv err)"
    done
done
# No row of a branch is off by more than a step may be that Newton's method leaves: 1e-8, of a size of 1, beside 1 + a^2 < 26.
jellett continue ./steep.tt --section phi=0 --along a=2:5 --set a=2 --start x=0,v=0.01 --period 1 2> err | grep '^0,' > rows.csv
awk -F, '{ bad += ($5*(1 + $2*$2) + 1)^2 + ($6*(1 + $2*$2))^2 > (26*1e-8)^2; last = $2 }
    END { exit !(last > 4 && !bad) }' rows.csv ||
    fail "a branch: $(awk -F, '{ print $2, $5*(1 + $2*$2) + 1, $6 }' rows.csv | tail -3; cat err)"
# A coordinate of size k beside one of size 1: what Newton's method from a start finds is the orbit through Y = 0.25480616 k,
# py = 0, or nothing, though any Y is missed by less than 1e-9 where k is smaller. A grid knows the sizes, and finds it.
printf '%s\n' 'model uneven' 'param k > 0' 'state x' 'state Y' 'state px' 'state py' 'let y = Y/k' 'eq x = px' 'eq Y = k*py' \
    'eq px = -x - 2*x*y' 'eq py = -y - x^2 + y^2' 'integral H = (px^2 + py^2 + x^2 + y^2)/2 + x^2*y - y^3/3' > uneven.tt
of=(./uneven.tt --section x=0 --level H=1/12 --solve px=0.3 --period 1)
for e in e-3 e-7 e-9 e-10 e-12; do
    k=1$e
    jellett orbits "${of[@]}" --set k=$k --start Y=0.2$e,py=0.05 2> err | sed "s/$/,$k/" | grep '^1,' > rows.csv
    jellett orbits "${of[@]}" --set k=$k --grid Y=-0.3$e:0.3$e:9,py=-0.2:0.2:9 2> err | sed "s/$/,$k/" | grep '^1,' > grid.csv
    awk -F, '{ other = ($2/$NF - 0.2548061629624)^2 > 1e-20 } FILENAME == "rows.csv" { bad += other; next } !other { found++ }
        END { exit bad || !found }' rows.csv grid.csv || fail "k = $k: $(cat rows.csv grid.csv err)"
done
# Beside an unstable equilibrium all moves are small while an angle counts in radians: a forced pendulum that stands. The trace is
# that of y'' = (1 + cos(t)/2) y over 2 pi, by scipy's DOP853 at 1e-13.
printf '%s\n' 'model standing' 'param one' 'default one = 1' 'state phi' 'state theta' 'state p' \
    'angle C S = cos(theta) sin(theta)' 'angle c s = cos(phi) sin(phi)' 'eq phi = 1' 'eq theta = p' 'eq p = -S*one - S*c/2' \
    'periodic phi = 2*pi' 'periodic theta = 2*pi' > standing.tt
for theta in 3.14 3.14159 3.1415926 3.1416; do
    for command in orbits "continue --along one=1:1.1"; do
        # shellcheck disable=SC2086
        jellett $command ./standing.tt --section phi=0 --start theta=$theta,p=0 --period 1 2> err | grep '^[01],' > row.csv
        grep -Eq ',493\.81225761766[0-9]*,' row.csv || fail "${command%% *} from theta = $theta: $(cat row.csv err)"
    done
done
# A proof takes as many steps by a slow clock: x at phi = 0 is 1/2, and the multiplier exp(-2 pi).
timeout 60 jellett certify cycle ./clock.tt --set e=1e-11 --section phi=0 --start x=0.5 > out 2> err
grep -q 'That point is x = 0.5000' out || fail "e = 1e-11, a proof: $(cat err)"
# and a box as large as the orbit takes: q = (1 + sqrt(1/5))/2 at b = -1/5, x = 0.85065 L.
for L in 1e-6 1e-9 1e12; do
    timeout 60 jellett certify cycle ./radius.tt --set L="$L" --section y=0 --start "x=$(times 0.85 "$L")" > out 2> err
    grep -Eq 'That point is x = 8\.?5065080835' out || fail "L = $L, a proof: $(cat err)"
    timeout 60 jellett certify cycle ./well.tt --set L="$L" --section phi=0 --start "x=$(times -1.18 "$L"),v=$(times 0.569 "$L")" \
        > out 2> err || fail "L = $L, a proof: $(cat err)"
done
exit $status
