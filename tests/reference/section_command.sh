#!/usr/bin/env bash
# The commands of the dynamics, as typed: rows against quadruple precision, headers that repeat the run, exit statuses,
# pictures, and what an interrupt leaves.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
data=$JLT_SOURCE_DIR/tests/reference/data
expect() { # STATUS COMMAND...
    local want=$1
    shift
    "$@" > out 2> err < /dev/null
    local got=$?
    [ $got -eq "$want" ] || { fail "$*: status $got, not $want"; head -3 err; }
}

# Returns: eta, gamma3, t, v_nu, omega_n, omega3 of all four orbits within 1e-11.
jellett section --level E=2.15,G=-0.56 --tol 1e-13 --returns 10 \
    $(awk -F, 'NR > 1 && $2 == 0 { printf "--start eta=%s,gamma3=%s ", $3, $4 }' "$data/returns_51.csv") > rows.csv 2> err ||
    fail "section: $(cat err)"
sed '/^#/d; q' rows.csv | grep -qx 'orbit,return,t,eta,gamma3,v_nu,omega_n,omega3,fate' || fail "section: columns"
worst=$(paste -d, <(grep -v '^[#o]' rows.csv) <(tail -n +2 "$data/returns_51.csv") | awk -F, '
    function abs(x) { return x < 0 ? -x : x }
    { if ($1 != $10 || $2 != $11 || $9 != "alive") print "rows differ: " $0
      d[1] = $4 - $12; d[2] = $5 - $13; d[3] = $3 - $14; d[4] = $6 - $15; d[5] = $7 - $16; d[6] = $8 - $17
      for (i in d) if (abs(d[i]) > worst) worst = abs(d[i])
      n++ }
    END { if (n != 44) print n " rows"; print worst > "worst"; exit !(worst < 1e-11) }') || fail "section: $worst $(cat worst)"
[ -z "$worst" ] || fail "section: $worst"

# The header repeats the run, bit for bit.
command=$(sed -n 's/^# command: //p' rows.csv)
eval "$command" 2> /dev/null | cmp -s - rows.csv || fail "the header's command gives other rows"

# --check: at every return det DP is what flux and divergence make of it, and an orbit's own determinant is their product.
jellett section --check --returns 10 --start eta=0.1,gamma3=-0.6 --tol 1e-13 > check.csv 2> err || fail "--check: $(cat err)"
awk -F, '$2 > 0 && /^[0-9]/ { n++; if ($13 == "" || $13 > 1e-12 || $13 < -1e-12) bad = 1 } END { exit !(n == 10 && !bad) }' \
    check.csv ||
    fail "--check: $(tail -1 check.csv)"
jellett section --check --returns 1 --start eta=0,gamma3=-0.613584389706638 > check.csv 2> err || fail "--check: $(cat err)"
awk -F, 'function abs(x) { return x < 0 ? -x : x }
    $2 == 1 { exit !(abs($10 + 2.047418461622422) < 1e-9 && abs($11 - 1) < 1e-9 && abs($12) < 1e-9) }' check.csv ||
    fail "--check at the fixed point: $(tail -1 check.csv)"

# Fates: pole, time and limits.
jellett fates --tol 1e-13 $(awk -F, 'NR > 1 { printf "--start eta=%s,gamma3=%s ", $1, $2 }' "$data/poles_51.csv") \
    > fates.csv 2> err || fail "fates: $(cat err)"
sed '/^#/d; q' fates.csv | grep -qx 'eta,gamma3,fate,t_end,v_nu_end,omega_tau_end,omega3_end' || fail "fates: columns"
paste -d, <(grep -v '^[#e]' fates.csv) <(tail -n +2 "$data/poles_51.csv") | awk -F, '
    function abs(x) { return x < 0 ? -x : x }
    $3 != ($10 > 0 ? "pole+" : "pole-") { exit 1 }
    abs($4 - $11) > 1e-11 || abs($5 - $12) > 1e-10 || abs($6 - $13) > 1e-10 || abs($7 - $14) > 1e-10 { exit 1 }
    END { exit NR != 4 }' || fail "fates: not those of the reference"

# Orbits: the symmetric fixed point.
jellett orbits --period 1 --grid 0x0 > orbits.csv || fail "orbits"
sed '/^#/d; q' orbits.csv | grep -qx 'period,eta,gamma3,T,trace,det,mu1_re,mu1_im,mu2_re,mu2_im,symmetric,type,residual' ||
    fail "orbits: columns"
awk -F, '
    function abs(x) { return x < 0 ? -x : x }
    $1 == 1 && abs($2) < 1e-11 && abs($3 + 0.613584389706638) < 1e-11 && abs($5 + 2.047418461622422) < 1e-11 &&
    abs($6 - 1) < 1e-11 && $11 == "yes" { found = 1 }
    END { exit !found }' orbits.csv || fail "orbits: the symmetric fixed point is missing"

# Other systems, published numbers to their digits: Lorenz AB and Roessler (T, and the product of multipliers or the larger one),
# Arenstorf (T, by symmetry).
orbit_is() { # COLUMN VALUE ERROR COLUMN VALUE ERROR COMMAND...
    local want=("${@:1:6}")
    shift 6
    "$@" > orbit.csv 2> err || fail "$*: $(cat err)"
    tail -1 orbit.csv | awk -F, -v a="${want[0]}" -v x="${want[1]}" -v e="${want[2]}" -v b="${want[3]}" -v y="${want[4]}" \
        -v f="${want[5]}" 'function abs(x) { return x < 0 ? -x : x } { exit !(abs($a - x) < e && abs($b - y) < f) }' ||
        fail "$*: $(tail -1 orbit.csv)"
}
orbit_is 4 1.5586522107161747 1e-12 6 5.60842940466e-10 1e-20 jellett orbits lorenz --section z=27 --period 2 \
    --start x=-13.76,y=-19.58
orbit_is 4 5.88108845555 1e-11 7 -2.40395353185 1e-10 \
    jellett orbits roessler --section y=0 --direction down --period 1 --start x=-7,z=0.02
orbit_is 5 17.06521656015796 1e-11 4 -2.001585106379082 1e-12 jellett orbits restricted_three_body --section y=0 --direction both \
    --mirror y,vx --period 6 --start x=0.994,vx=0,vy=-2.0016 --line vy=-2.0017:-2.0015:20

# What cannot be used says so.
expect 3 jellett section --level E=-5 --start eta=0,gamma3=0
grep -q 'raise E' err || fail "an empty level: $(cat err)"
# In units of 1e-27 kg, 1 nm and 1 us the least energy is 1e-33 times as large.
jellett section --set m=1e-27,R=1e-9,g=1000,a3=0.51e-9,I1=1e-45,I3=1e-45 --level E=1e-34,G=-1.68e-48 --start eta=0.1,gamma3=-0.6 \
    2> err
small=$(sed -n 's/.*raise E above \([^,]*\)e-33,.*/\1/p' err)
jellett section --set I1=1,I3=1 --level E=0.1,G=-1.68 --start eta=0.1,gamma3=-0.6 2> err
[ -n "$small" ] && grep -q "raise E above ${small:0:8}" err || fail "an empty level in small units: $small, not $(cat err)"
# A level on which an oscillator has states is above 0, also where 0 is asked for.
printf '%s\n' 'model oscillator' 'state x' 'state y' 'state z in (-1, 1)' 'eq x = y' 'eq y = -x' 'eq z = 0' \
    'integral E = (x^2 + y^2)/2' 'section rising : by rising.tt at x = 0 with w = z, E = E' > oscillator.tt
printf '%s\n' 'model rising' 'param E' 'default E = 1' 'state w in (-1, 1)' 'domain moving : E > 0' 'root v = sqrt(2*E)' \
    'lift into oscillator.tt with x = 0, y = v, z = w' > rising.tt
for level in -1 0; do
    expect 3 jellett section ./oscillator.tt --section rising --level E=$level --start w=0.1
    grep -q "has E = $level: raise E above 0," err || fail "the level $level of an oscillator: $(cat err)"
done
expect 3 jellett section --level E=0.4 --start eta=0,gamma3=0.5
expect 3 jellett section --start eta=0,gamma3=1
expect 3 jellett section --start eta=x,gamma3=0
expect 3 jellett section --start eta=0
expect 3 jellett section --set mass=1 --start eta=0,gamma3=0
expect 3 jellett section --start eta=0,gamma3=0 --tol 2
expect 2 jellett section
expect 2 jellett section --start eta=0,gamma3=0 --direction sideways
expect 2 jellett section --start eta=0,gamma3=0 --method euler
expect 3 jellett manifolds --start eta=0.43,gamma3=-0.62 --period 2
# Errors of the map that are 1e4 times as large along the branches hide lobes and crossings: the command ends, and says how many.
# At the default tolerance there are 196.
expect 0 timeout 100 jellett manifolds --tol 1e-7 --crossings points.csv
listed=$(grep -c '^[-0-9]' points.csv)
unlisted=$(sed -n 's/^jellett: at \([0-9]*\) places.*not listed$/\1/p' err)
[ "$listed" -lt 196 ] && [ $((listed + unlisted)) -ge 190 ] || fail "$listed crossings listed, $unlisted told of"
expect 2 jellett continue
expect 3 jellett continue --along mass=1:2
expect 5 jellett section --start eta=0,gamma3=-0.6 --returns 1 --output no/such/folder.csv
expect 0 jellett lyapunov --returns 20
expect 0 jellett continue --along E=2.1:2.2
expect 0 jellett separation --grid 2x2 --returns 4 --settle 0
expect 0 jellett fates --grid 4x4 --sweep E=1:2:2
expect 0 jellett section --start eta=2,gamma3=-0.5 --contact end
grep -q ',lost_contact$' out || fail "--contact end: no lost_contact"
expect 0 jellett section --grid 6x4 --returns 20 --plot picture.svg --keep picture.gp
grep -q '<svg' picture.svg && [ -s picture.gp ] || fail "no picture"
[ "$(head -c 4 picture.svg)" = "<?xm" ] || fail "the picture is no SVG"

# An interrupt ends with whole rows, says what is saved, and is the status: 128 and the signal, also of a scene, whose other
# commands are not begun. Job control, because a background job of a script ignores SIGINT otherwise.
cat > long.scene <<'SCENE'
compute = ( { what = "section"; start = { eta = 0.1; gamma3 = -0.6; }; returns = 100000000; output = "long.csv"; },
            { what = "section"; start = { eta = 0.1; gamma3 = -0.6; }; output = "never.csv"; } );
SCENE
interrupted() { # SIGNAL STATUS COMMAND...
    local signal=$1 want=$2 got=0
    shift 2
    rm -f long.csv
    set -m
    "$@" 2> err &
    local child=$!
    set +m
    for _ in $(seq 300); do # until it writes
        sleep 0.1
        [ -n "$(find . -name 'long.csv.*' -size +8k)" ] && break
    done
    kill -"$signal" $child
    wait $child 2> /dev/null || got=$?
    [ $got -eq "$want" ] || fail "$*: status $got after SIG$signal, not $want"
    grep -q 'interrupted; [0-9]* whole rows' err || fail "interrupted: $(cat err)"
    [ "$(grep -c '^0,' long.csv)" -eq "$(sed -n 's/.*interrupted; \([0-9]*\) whole rows.*/\1/p' err)" ] || fail "saved rows"
    tail -1 long.csv | grep -qE '^0(,[-+.e0-9]+){7},alive$' || fail "the last row is broken"
    [ -z "$(find . -name 'long.csv.*' -o -name 'never.csv*')" ] || fail "$*: files are left"
}
for signal in INT TERM; do
    code=$((128 + $(kill -l $signal)))
    interrupted $signal $code jellett section --start eta=0.1,gamma3=-0.6 --returns 100000000 --output long.csv
    interrupted $signal $code jellett run long.scene
    grep -q 'the last 1 were not begun' err || fail "the scene says nothing: $(cat err)"
done

# The row of a start has its coordinates as they were given, one at a time and in lanes.
for eta in 0.1 0.3 0.6 0.7 -0.9 1.1; do
    for how in --start --grid; do
        expect 0 jellett section $how eta=$eta,gamma3=-0.61 --returns 1
        grep -q "^0,0,0,$eta,-0.61,.*alive$" out || fail "start $eta: $(grep '^0,0,' out)"
    done
done

# Rows are the same where a library that is loaded before the program makes doubles round upwards.
cat > upwards.c << 'LIBRARY'
#include <fenv.h>
__attribute__((constructor)) static void round_upwards(void) { fesetround(FE_UPWARD); }
LIBRARY
"$JLT_CC" -shared -fPIC -o upwards.so upwards.c -lm || fail "the library that rounds upwards is not compiled"
expect 0 jellett section --start eta=0.1,gamma3=-0.6 --returns 5
mv out nearest
expect 0 env LD_PRELOAD="$PWD/upwards.so" ASAN_OPTIONS=verify_asan_link_order=0 \
    jellett section --start eta=0.1,gamma3=-0.6 --returns 5
cmp -s out nearest || fail "rounding is not set back: $(diff out nearest | head -4)"
exit $status
