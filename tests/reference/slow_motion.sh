#!/usr/bin/env bash
# Motion is no rest because it is slow. A table whose rates all have the factor e moves as at e = 1, at times 1/e as long: one orbit
# at a time, in lanes, with derivatives, and by every method. What is on an equilibrium, or comes to one, is there at any e.
source "$JLT_SOURCE_DIR/tests/scratch.sh"

cat > pair.tt << 'T'
model pair
param e > 0
default e = 1
state x
state v
state z
eq x = e*v
eq v = -e*x - e*z^2/10
eq z = -e*z/5
T
slow=1.1368683772161603e-13 # 2^-43
rows() { # COMMAND...: the numbers of the rows, times and exponents in units of 1/e
    jellett "$@" 2> err | grep -v '^#'
}
# Both are right to some tolerances, 1e-12 relative to 1, a return each.
compare() { # WHAT SCALED-COLUMN POWER
    awk -F, -v what="$1" -v column="$2" -v power="$3" 'NR == FNR { fast[FNR] = $0; n = FNR; next }
        { m = split(fast[FNR], one); if (m != NF) bad = 1
          for (i = 1; i <= m; i++) { a = one[i]; b = $i
              if (a !~ /^[-+0-9.e]+$/ || b !~ /^[-+0-9.e]+$/) { if (a != b) bad = 1; continue }
              if (column == 0 || i == column) b = power < 0 ? b * 2^-43 : b * 2^43
              off = a - b; if (off < 0) off = -off; size = a < 0 ? -a : a; if (size < 1) size = 1
              if (off > 1e-10 * size) bad = 1 } last = FNR }
        END { exit bad || n < 2 || n != last }' fast.csv slow.csv || fail "$1: $(cat fast.csv slow.csv err)"
}
starts="--start x=1,z=0.1 --start x=0.5,z=0.3 --start x=-1,z=0.2 --start x=2,z=0"
for how in "" "--method gauss" "--method taylor" "--method dop853" "--check"; do
    rows section ./pair.tt --section v=0 $starts --returns 3 $how > fast.csv
    rows section ./pair.tt --section v=0 $starts --returns 3 $how --set e=$slow > slow.csv
    compare "section $how" 3 -1
done
rows simulate ./pair.tt --start x=1,v=0,z=0.1 --times 0,1,10,20 > fast.csv
rows simulate ./pair.tt --start x=1,v=0,z=0.1 --times 0,8796093022208,87960930222080,175921860444160 --set e=$slow > slow.csv
compare simulate 1 -1
rows lyapunov ./pair.tt --section v=0 --start x=1,z=0.1 --returns 4 | cut -d, -f3- > fast.csv
rows lyapunov ./pair.tt --section v=0 --start x=1,z=0.1 --returns 4 --set e=$slow | cut -d, -f3- > slow.csv
compare lyapunov 0 1
for e in 1 $slow; do
    rows section ./pair.tt --section v=0 --start x=0,z=0 --returns 1 --set e=$e | grep equilibrium > /dev/null ||
        fail "the equilibrium is not told at e = $e"
done
# What is at rest but for one slow pair moves on: half a turn is pi 2^43.
printf 'model creep\nstate x\nstate v\nstate p\nstate q\neq x = v\neq v = -x\neq p = q/2^43\neq q = -p/2^43\n' > creep.tt
rows section ./creep.tt --section q=0 --start x=0,v=0,p=1 --returns 1 > creep.csv
grep -q "0,1,27633741218861" creep.csv || fail "slow motion beside what rests: $(cat creep.csv err)"

# A body that leaves another for good comes to no rest, however slow it is against where it has come to: one at a time and in lanes.
cat > kepler.tt << 'T'
model kepler
state x
state y
state vx
state vy
root r = sqrt(x^2 + y^2)
eq x = vx
eq y = vy
eq vx = -x/r^3
eq vy = -y/r^3
T
for start in --start=x=1,vx=0,vy=2 --grid=x=1,vx=0,vy=2; do
    jellett section ./kepler.tt --section y=0 "$start" --returns 2 > out 2> err || fail "$start: $(cat err)"
    tail -1 out | grep -q ',budget$' || fail "$start: $(tail -1 out)"
    grep -q '1 of 1 orbits ended by budget' err || fail "$start: nothing is said of the budget: $(cat err)"
done

# Rates so slow or fast that powers of them leave the range of doubles: x(30/k) of x'' = -k^2 x^3 from x = 1, v = 1/2, by Jacobi's
# cn in 25 digits. By series from 1e-50 to 1e50, where coefficients of some order still exist; by the others much farther.
printf '%s\n' 'model quartic' 'param k' 'default k = 1' 'state x' 'state v' 'eq x = k*v' 'eq v = -k*x^3' > quartic.tt
for k in -130 -100 -65 -50 -30 -20 -10 0 10 20 30 50 65 100 130; do
    for method in gauss dop853 taylor rk8pd rkf45 msadams; do
        [ $method = taylor ] && [ ${k#-} -gt 50 ] && continue
        jellett simulate ./quartic.tt --set k=1e$k --start x=1,v=0.5 --times 30e$((-k)) --method $method > out 2> err ||
            fail "$method at k = 1e$k: $(cat err)"
        tail -1 out | awk -F, '{ off = $2 + 0.91066785145926899 } END { exit !(off < 1e-10 && off > -1e-10) }' ||
            fail "$method at k = 1e$k: $(tail -1 out), and x = -0.91066785145926899"
    done
done
# A state of 1e100 beside one that is 0.
printf '%s\n' 'model turn' 'state x' 'state v' 'eq x = v' 'eq v = -x' > turn.tt
for method in gauss dop853 taylor rk8pd rkf45 msadams; do
    jellett simulate ./turn.tt --start x=1e100,v=0 --times 1 --method $method > out 2> err || fail "$method from 1e100: $(cat err)"
    tail -1 out | awk -F, '{ off = $2/1e100 - 0.54030230586813977 } END { exit !(off < 1e-10 && off > -1e-10) }' ||
        fail "$method from 1e100: $(tail -1 out), and x = 1e100 cos 1"
done
# Nor does a phase that grows at one rate for ever, however much it has grown, where all else rests.
cat > swing.tt << 'T'
model swing
state theta
state v
state phase
angle C S = cos(theta) sin(theta)
angle c s = cos(phase) sin(phase)
eq theta = v
eq v = -S*(1 + c/2)
eq phase = 1
periodic phase = 2*pi
T
for start in --start=theta=0,phase=0 --grid=theta=0,phase=0; do
    jellett section ./swing.tt --section v=0 "$start" --returns 1 > out 2> err || fail "$start: $(cat err)"
    tail -1 out | grep -q ',budget$' || fail "$start: $(tail -1 out)"
    grep -q '1 of 1 orbits ended by budget' err || fail "$start: nothing is said of the budget: $(cat err)"
done
# The same beside 32 more states, where no Jacobian is looked at.
{ cat swing.tt; for i in $(seq 32); do printf 'state y%d\neq y%d = -y%d\n' "$i" "$i" "$i"; done; } > company.tt
jellett section ./company.tt --section v=0 --start theta=0,phase=0$(printf ',y%d=0' $(seq 32)) --returns 1 > out 2> err
tail -1 out | grep -q ',budget$' || fail "beside many states: $(tail -1 out) $(cat err)"
# One oscillator decays onto the section while another goes on: there are some 80 returns, which differ by the period of the first,
# before they drown in errors, as another state, which rests at 1, might drive it. That is found in hundreds of steps, not after all
# that a return may take. If no state can drive it, or one alone that stays 0, returns go on to 1e-290.
printf '%s\n' 'model two' 'state x' 'state p' 'state y' 'state q' 'state r' 'eq x = p' 'eq p = -x - p/10 + (r - 1)' 'eq y = q' \
    'eq q = -2*y' 'eq r = 1 - r' > two.tt
sed '/state r/d; /^eq r/d; s/ + (r - 1)//; s/two/alone/' two.tt > alone.tt
sed 's/(r - 1)/r/; s/1 - r/-r/; s/two/driven/' two.tt > driven.tt
for start in --start=p=1,y=1,q=0 --grid=p=1,y=1,q=0; do
    jellett section ./two.tt --section x=0 "$start,r=1" --returns 200 > out 2> err || fail "$start: $(cat err)"
    grep alive out | awk -F, '$2 > 0 { off = $3/$2 - 6.291054045776003; bad += off*off > 1e-20; n++ }
        END { exit !(n > 70 && n < 90 && !bad) }' ||
        fail "$start: $(grep -c alive out) returns, $(grep alive out | tail -1)"
    tail -1 out | awk -F, '{ exit !($NF == "budget" && $3 < 3000) }' || fail "$start, settled: $(tail -1 out)"
    for other in alone driven; do
        [ $other = driven ] && start=$start,r=0
        jellett section ./$other.tt --section x=0 "$start" --returns 2100 > out 2> err || fail "$other, $start: $(cat err)"
        grep alive out | awk -F, '$2 > 0 { off = $3/$2 - 6.291054045776003; bad += off*off > 1e-20; n++ }
            END { exit !(n == 2100 && !bad) }' || fail "$other, $start: $(grep -c alive out) returns, $(grep alive out | tail -1)"
    done
done
# Motions that stay on their section, to within its errors, for thousands of steps, and then go on: one grows from there, one decays
# and grows again as its rate swings, one passes a saddle. Returns of the first two are a whole number of periods apart.
printf '%s\n' 'model grows' 'state x' 'state p' 'state y' 'state q' 'eq x = p + x/200' 'eq p = -x' 'eq y = 10*q' 'eq q = -10*y' \
    > grows.tt
printf '%s\n' 'model swings' 'state x' 'state p' 'state phase' 'state y' 'state q' 'angle C S = cos(phase) sin(phase)' \
    'eq x = p + x*C' 'eq p = -x + p*C' 'eq phase = 1/40' 'eq y = 20*q' 'eq q = -20*y' 'periodic phase = 2*pi' > swings.tt
printf '%s\n' 'model passes' 'state x' 'state p' 'state y' 'state q' 'eq x = p' 'eq p = x - x^3' 'eq y = 1000*q' 'eq q = -1000*y' \
    > passes.tt
pi=3.14159265358979323846
while read -r period case; do
    jellett section ./${case%% *} --section x=0 ${case#* } > out 2> err || fail "$case: $(cat err)"
    awk -F, -v T="$period" '/^0,/ && $2 > 0 { n++; turns = T > 0 ? $3/T : 0; off = turns - int(turns + 0.5)
        bad += !/alive/ || off*off > 1e-14 }
        END { exit n < 2 || bad }' out || fail "$case: $(tail -1 out)"
done <<T
$(awk -v p=$pi 'BEGIN { printf "%.17g", 2*p/sqrt(1 - 1/400^2) }') grows.tt --start p=1e-13,y=1,q=0 --returns 100
$(awk -v p=$pi 'BEGIN { printf "%.17g", 2*p }') swings.tt --start p=1,phase=0,y=1,q=0 --returns 100
$(awk -v p=$pi 'BEGIN { printf "%.17g", 2*p }') swings.tt --start p=1,phase=pi,y=1,q=0 --returns 100
$(awk -v p=$pi 'BEGIN { printf "%.17g", 2*p }') swings.tt --grid p=1,phase=pi,y=1,q=0 --returns 100
0 passes.tt --start p=1e-7,y=1,q=0 --returns 4 --tol 1e-6
T
exit $status
