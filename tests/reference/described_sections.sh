#!/usr/bin/env bash
# Sections that tables describe where the section's state or a coordinate is an angle, where the lift takes one root of two, where
# orbits run through the end of an interval, and in units that make the section small: rows are those of the plain section, or none.
source "$JLT_SOURCE_DIR/tests/scratch.sh"

# f' = 2 + p, p' = -p: f = 2 t + p0 (1 - exp(-t)) comes to 2 pi k at the plain section's times.
cat > turning.tt <<'T'
model turning
state f
state p
eq f = 2 + p
eq p = -p
periodic f = 2*pi
section cut : by turning_cut.tt at f = 0 with p = p
T
printf 'model turning_cut\nstate p\nlift into turning.tt with f = 0, p = p\n' > turning_cut.tt
expect 0 ',alive$' jellett section ./turning.tt --start p=0.5 --returns 3
grep -v '^#' out > described
expect 0 ',alive$' jellett section ./turning.tt --section f=0 --start p=0.5 --returns 3
grep -v '^#' out | cmp - described || fail "at an angle rows differ: $(cat described)"

# A pendulum with a phase: the coordinate is the angle, which comes back within half a turn of 0.
cat > pendulum.tt <<'T'
model pendulum
state f
state a
state p
angle c s = cos(a) sin(a)
angle cf sf = cos(f) sin(f)
eq f = 1
eq a = p
eq p = - s + cf/2
periodic f = 2*pi
periodic a = 2*pi
section cut : by pendulum_cut.tt at f = 0 with turn = a, p = p
T
printf 'model pendulum_cut\nstate turn\nstate p\nlift into pendulum.tt with f = 0, a = turn, p = p\n' > pendulum_cut.tt
expect 0 ',alive$' jellett section ./pendulum.tt --start turn=0.1,p=2.5 --returns 9
grep -v '^#' out | cut -d, -f3-5 | tail -n +2 > described
expect 0 ',alive$' jellett section ./pendulum.tt --section f=0 --start a=0.1,p=2.5 --returns 9
grep -v '^#' out | cut -d, -f3-5 | tail -n +2 | cmp - described || fail "an angle is not within half a turn: $(cat described)"

# So is a coordinate that the angle moves evenly, here by half a turn for a whole one, or beside another: within half a period of
# its own, points that differ by periods are one, and the one closed orbit is listed once.
sed -e 's/pendulum/halved/; s/- s + cf/- p\/10 &/; s/pendulum_cut/halved_cut/; s/turn = a/turn = 1 - a\/2 + p/' \
    pendulum.tt > halved.tt
printf 'model halved_cut\nstate turn\nstate p\nlift into halved.tt with f = 0, a = 2 + 2*p - 2*turn, p = p\n' > halved_cut.tt
expect 0 ',alive$' jellett section ./halved.tt --start turn=3.45,p=2.5 --returns 9
grep -v '^#' out | tail -n +2 > described
expect 0 ',alive$' jellett section ./halved.tt --section f=0 --start a=0.1,p=2.5 --returns 9
grep -v '^#' out | tail -n +2 | paste -d, described - | awk -F, '
    { k = ($4 - 1 + $10/2 - $5)/3.141592653589793; if ($4 > 1.5707963267949 || $4 < -1.5707963267949) exit 1
      if (k - sprintf("%.0f", k) > 1e-9 || sprintf("%.0f", k) - k > 1e-9) exit 1 } END { exit NR != 10 }' ||
    fail "a coordinate with the period pi: $(cat described)"
expect 0 '^# 1 orbit' jellett orbits ./halved.tt --grid turn=-1:1.5:6,p=-2:2:5 --period 1

# q = u^2 forgets the sign of u, and x' = -u: lifted points, of u > 0, are crossed downwards.
cat > folded.tt <<'T'
model folded
state x
state u
state z
eq x = - u
eq u = x
eq z = - z
section cut : by folded_cut.tt at x = 0 with q = u^2, z = z
T
printf 'model folded_cut\nstate q in (0, inf)\nstate z\nroot u = sqrt(q)\nlift into folded.tt with x = 0, u = u, z = z\n' > \
    folded_cut.tt
expect 3 'crossings in this --direction lie on the other half' jellett orbits ./folded.tt --grid q=1:2:3,z=-0.1:0.1:3 --period 1
# Downwards it is met once a turn, 2 pi, on which z decays by exp(-2 pi) = 0.0018674427.
expect 0 '^0,1,6\.28318530717[0-9]*,(1|0\.99999999999|1\.00000000000)[0-9]*,0\.000186744273[0-9]*,alive$' \
    jellett section ./folded.tt --direction down --start q=1,z=0.1 --returns 1
expect 3 'q must lie above 0' jellett section ./folded.tt --direction down --start q=-1,z=0

# Where x' = - u z lifted points of u > 0 are crossed downwards at z > 0, upwards at z < 0, so that neither direction has them all.
sed -e 's/folded/mixed/; s/^eq x = - u/eq x = - u*z/; s/folded_cut/mixed_cut/' folded.tt > mixed.tt
sed -e 's/folded/mixed/g' folded_cut.tt > mixed_cut.tt
for direction in up down both; do
    expect 3 'crossings in this --direction lie on the other half' \
        jellett section ./mixed.tt --direction $direction --start q=1,z=0.1 --returns 1
done

# The slope p = v/u forgets the sign of both velocities at once: lifted points, of u > 0, are crossed upwards. Downwards an orbit of
# half a turn would seem to be closed. A planar oscillator of frequencies 1 and 2; upwards every orbit is closed after 2 pi.
cat > slope.tt <<'T'
model slope
state x
state y
state u
state v
eq x = u
eq y = v
eq u = - x
eq v = - 4*y
integral H = (u^2 + v^2 + x^2 + 4*y^2)/2
section cut : by slope_cut.tt at x = 0 with y = y, p = v/u, H = H
T
cat > slope_cut.tt <<'T'
model slope_cut
param H
default H = 1/2
state y
state p
let square = 2*H - 4*y^2
domain reached : square > 0
root speed = sqrt(square)
root norm = sqrt(1 + p^2)
lift into slope.tt with x = 0, y = y, u = speed/norm, v = p*speed/norm
T
expect 0 '^0,1,6\.28318530717[0-9]*,(0.1|0.0999999999|0.1000000000)[0-9]*,(0.2|0.1999999999|0.2000000000)[0-9]*,alive$' \
    jellett section ./slope.tt --start y=0.1,p=0.2 --returns 1
for direction in down both; do
    expect 3 'crossings in this --direction lie on the other half' \
        jellett orbits ./slope.tt --direction $direction --start y=0.1,p=0.2 --period 1
done

# g' = p, p' = -1: orbits run through g = -1 at speed, which is no pole to come to; in the time of s they would come back in time.
cat > ball.tt <<'T'
model ball
state g in (-1, 1)
state p
state h
state q
root s = sqrt(1 - g^2)
eq g = p
eq p = - 1
eq h = q
eq q = - h
time slow : s lifting s
pole g "the end"
integral N = (h^2 + q^2)/2
section cut : by ball_cut.tt at h = 0 with g = g, p = p, N = N
T
cat > ball_cut.tt <<'T'
model ball_cut
param N > 0
default N = 1
state g in (-1, 1)
state p
root s = sqrt(1 - g^2)
root q = sqrt(2*N)
lift into ball.tt with g = g, p = p, h = 0, q = q, s = s
T
# h = sqrt(2) sin t; g = p t - t^2/2 is at -1 before 2 pi.
expect 0 '^0,1,.*,left_domain$' jellett section ./ball.tt --start g=0,p=0.1 --returns 3

# A section of the size 1e-3, in coordinates without bounds.
cat > small.tt <<'T'
model small
state x
state y
state u
state v
eq x = u
eq y = v
eq u = - x
eq v = - y
integral H = (x^2 + y^2 + u^2 + v^2)/2
section cut : by small_cut.tt at x = 0 with y = y, v = v, H = H
T
cat > small_cut.tt <<'T'
model small_cut
param H
default H = 1/2
state y
state v
domain reached : 2*H - y^2 - v^2 > 0
root u = sqrt(2*H - y^2 - v^2)
lift into small.tt with x = 0, y = y, u = u, v = v
T
expect 0 '^0,1,6\.2831853071[0-9]*,' jellett section ./small.tt --level H=1/1000000 --start y=0.001,v=0 --returns 1

# A section of more coordinates, or values, than one that a table describes may have: the table's own serves.
write_wide() { # NAME DECAYING PARAMETERS
    local name=$1 q k
    q=$(seq 1 "$2") k=$(seq 1 "$3")
    {
        echo "model $name"
        for i in $k; do printf 'param k%s\ndefault k%s = 1\n' "$i" "$i"; done
        for i in x u $(seq -f 'q%.0f' 1 "$2"); do echo "state $i"; done
        echo "eq x = u"
        echo "eq u = -x$(for i in $k; do printf ' + k%s*x*u^2 - k%s*x*u^2' "$i" "$i"; done)"
        for i in $q; do echo "eq q$i = -q$i"; done
    } > "$name.tt"
    sed '/^eq/d; /^state x/d; s/^model.*/&_cut/' "$name.tt" > "${name}_cut.tt"
    echo "lift into $name.tt with x = 0, u = u$(for i in $q; do printf ', q%s = q%s' "$i" "$i"; done)" >> "${name}_cut.tt"
    echo "section cut : by ${name}_cut.tt at x = 0 with u = u$(for i in $q; do printf ', q%s = q%s' "$i" "$i"; done)" >> "$name.tt"
}
write_wide wide 16 0
zeros=$(printf 'q%s=0,' $(seq 1 16))
expect 3 'has 17 coordinates, and 16 are the limit of sections that tables describe: ask for .*--section x=0' \
    jellett section ./wide.tt --start "${zeros}u=1" --returns 1
expect 0 ',alive$' jellett section ./wide.tt --section x=0 --start "${zeros}u=1" --returns 1
write_wide many 1 65
for cut in "" "--section cut"; do
    # shellcheck disable=SC2086
    expect 3 'has 65 parameters and levels, and 64 are the limit' jellett section ./many.tt $cut --start u=1,q1=0 --returns 1
done
expect 0 ',alive$' jellett section ./many.tt --section x=0 --start u=1,q1=0 --returns 1
# Coordinates that a reversor turns, and does not mirror: nothing is told of symmetry, nor a record asked for that is there. Where
# they are mirrored, symmetric orbits are looked for on lines of points that are their own mirror images.
{ sed 's/small/turned/; s/with y = y, v = v/with y = (3*y + 4*v)\/5, v = (3*v - 4*y)\/5/' small.tt
  echo 'reversor x -> -x, v -> -v'; } > turned.tt
sed 's/small/turned/; s/y = y,/y = (3*y - 4*v)\/5,/; s/v = v/v = (3*v + 4*y)\/5/' small_cut.tt > turned_cut.tt
expect 3 'that of turned does more to the coordinates of cut than change signs' \
    jellett separation ./turned.tt --grid y=-0.1:0.1:2,v=-0.1:0.1:2
expect 0 ',,degenerate,' jellett orbits ./turned.tt --start y=0.1,v=0.1 --period 1
{ cat small.tt; echo 'reversor x -> -x, v -> -v'; } > straight.tt
sed -i 's/small/straight/g' straight.tt
sed 's/small/straight/g' small_cut.tt > straight_cut.tt
expect 3 'with v = 0.1 is not its own mirror image: take 0 in --start' \
    jellett orbits ./straight.tt --line y=-0.1:0.1:5 --start y=0,v=0.1 --period 1
expect 3 'that of straight keeps other lines' jellett orbits ./straight.tt --line v=-0.1:0.1:5 --start y=0,v=0 --period 1
# A start that the tables name is the point that they give.
for start in saddle eta=0,gamma3=-0.61; do jellett section --start $start --returns 1 2> err | grep -v '^#' > "$start"; done
cmp -s saddle eta=0,gamma3=-0.61 && [ "$(wc -l < saddle)" -eq 3 ] || fail "a start by its name: $(cat saddle err)"
expect_text 2 "'saddles' is no start (write NAME=VALUE,... or one of regular, chaotic, saddle)" jellett section --start saddles
echo 'compute = ( { what = "section"; start = "saddle"; returns = 1; } );' > start.scene
expect 0 '' jellett run start.scene
grep -v '^#' out | cmp -s - saddle || fail "a start by its name in a scene: $(cat out err)"
sed -i 's/saddle/saddles/' start.scene
expect_text 3 "start.scene:1: error: the section has no start 'saddles' (write { NAME = VALUE; ... }, or one of regular, chaotic, \
saddle)" jellett run start.scene
exit $status
