#!/usr/bin/env bash
# Levels leave a section's other states on several branches. What is told of a return is of the orbit itself, and not of another one
# with the same coordinates; and a condition is lost when it is, neither before nor after.
set -uo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
export XDG_CACHE_HOME=$scratch/cache LC_ALL=C
status=0
fail() { echo "$*" | cut -c1-300 | head -5; status=1; }
rows() { grep -v '^#' | tail -n +2; }

cat > quartic.tt <<'TABLE'
model quartic
param w > 0
default w = 1/3
state y
state p
state phi
eq y = + p
eq p = - y - y^3
eq phi = + w
periodic phi = 2*pi
integral H = p^2/2 + y^2/2 + y^4/4
TABLE

# 1. A row has a derivative where its return begins and ends on the branch p > 0, and then it is the one from there. Returns before
# that were on the other branch are left empty.
jellett section ./quartic.tt --section phi=0 --level H=1 --solve p=1 --start y=0.3 --returns 12 --check > out 2> err ||
    fail "section: $(cat err)"
rows < out > list
awk -F, 'NR > 1 { if (($7 != "") != (before > 0 && $5 > 0)) exit 1; some += $7 != "" } { before = $5 }
         END { exit NR != 13 || some < 2 || some > 10 }' list || fail "derivatives of another branch: $(cat list)"
awk -F, 'NR > 1 && $7 != "" { print y, $7 } { y = sprintf("%s", $4) }' list | while read -r y trace; do
    jellett section ./quartic.tt --section phi=0 --level H=1 --solve p=1 --start y="$y" --returns 1 --check 2> err | rows |
        awk -F, -v trace="$trace" '$2 == 1 { found = ($7 - trace)^2 < 1e-20 } END { exit !found }' || echo "$y $trace"
done > off
[ ! -s off ] || fail "not the derivative from there: $(cat off)"

# However small the orbit is: V homogeneous of degree four, lengths times l, velocities times l^2. Crossed both ways, every return
# is on the other branch from where it began; crossed upwards, none is.
cat > four.tt <<'TABLE'
model four
state x
state y
state u
state v
eq x = u
eq y = v
eq u = -x^3 - 3*x*y^2
eq v = -y^3 - 3*x^2*y
integral H = u^2/2 + v^2/2 + x^4/4 + y^4/4 + 3*x^2*y^2/2
TABLE
for l in 1 2^-12 2^-24; do
    at=$(awk -v l="$l" 'BEGIN {
        split(l, power, "^"); l = power[1]^(power[2] == "" ? 1 : power[2])
        printf "--start=y=%.17g,v=%.17g --level=H=%.17g --solve=u=%.17g", 0.3*l, 0.2*l^2, 0.342025*l^4, 0.8*l^2 }')
    for both in both:0 up:6; do
        # shellcheck disable=SC2086
        jellett section ./four.tt --section x=0 $at --direction "${both%:*}" --returns 6 --check 2> err | rows |
            awk -F, '$8 != "" { some++ } END { print some + 0 }' > count
        [ "$(cat count)" -eq "${both#*:}" ] || fail "$l, ${both%:*}: $(cat count) of 6 returns have derivatives, not ${both#*:}"
    done
done

# 2. Exponents begin where the orbit is after --skip, or not at all.
jellett section ./quartic.tt --section phi=0 --level H=1 --solve p=1 --start y=0.3 --returns 3 2> err | tail -1 | cut -d, -f5 |
    grep -q '^-' || fail "the third return is not on the other branch"
jellett lyapunov ./quartic.tt --section phi=0 --level H=1 --solve p=1 --start y=0.3 --skip 3 --returns 1 > out 2> err
[ $? -eq 4 ] || fail "exponents of another orbit: $(rows < out)"

# 3. The force of contact comes to zero at t = 1.4785 (SciPy, DOP853 at 1e-13), between rows and between steps.
start=gamma3=0.25,v_nu=0.8,omega_tau=-0.6,omega_n=1.1,omega3=-2.3
for tier in level five; do
    jellett simulate --set g=0.2 --start "$start" --tier "$tier" \
        --times 1.24,1.4,1.478,1.479,1.5 2> err | rows | awk -F, '{ print $NF }' | tr '\n' ' ' > fates
    [ "$(cat fates)" = "alive alive alive lost_contact lost_contact " ] || fail "$tier: $(cat fates)"
    grep -q 'contact is lost at t = 1.4782' err || fail "$tier: $(cat err)"
    jellett simulate --set g=0.2 --start "$start" --tier "$tier" \
        --times 1.24,1.4 2> err > out && ! grep -q lost err && ! grep -q ',lost' out || fail "$tier, before it: $(cat err out)"
done

# 4. A pendulum on a string: an orbit that ends by losing a condition has not held it.
cat > string.tt <<'TABLE'
model string
param p
param g
default p = 0.2, g = 3
state z in (-1, 1)
state w
state phi
root s = sqrt(1 - z^2)
eq z = + s*w
eq w = - p^2*z/s^3 - g*s
eq phi = + p/s^2
periodic phi = 2*pi
valid taut : w^2 + p^2/s^2 - g*z > 0
TABLE
jellett fates ./string.tt --section z=-0.5 --grid w=0.2:3:8,phi=0:0:1 --returns 3 --contact end --sweep p=0.2:0.5:4 2> err |
    rows > list
awk -F, '$3 + $(NF) > $2 { exit 1 } { lost += $3 } END { exit !(NR == 4 && lost == 14) }' list ||
    fail "lost and held at once: $(cat list)"

# 5. Of a flow on the circle u^2 + w^2 = 1 attractors and repellers are apart; on the branch w > 0 alone one of each.
cat > circle.tt <<'TABLE'
model circle
param k
default k = 0.1
state u
state w
state z
state phi
angle C S = cos(phi) sin(phi)
eq u = - w*(w^2 - 1/4)
eq w = + u*(w^2 - 1/4)
eq z = k*z*u*w
eq phi = 1
periodic phi = 2*pi
integral square = u^2 + w^2
reversor u -> -u, phi -> -phi
TABLE
jellett separation ./circle.tt --section phi=0 --level square=1 --solve w=0.5 --grid u=-0.98:0.98:40,z=-1:1:4 \
    --cells u=-1:1:40,z=-2:2:40 --returns 64 --settle 100 > out 2> err || fail "separation: $(cat err)"
rows < out | awk -F, 'NR == 1 { exit !($4 > 0 && $6 == 0) }' || fail "attractor and repeller as one: $(rows < out)"
grep -q 'left the branch of --solve' err || fail "orbits that strayed are not told: $(cat err)"

# 6. Separatrices end with the branch: of Duffing's forced oscillator, with y = (x - 7/10)^2 in place of x, the half x < 7/10.
cat > folded.tt <<'TABLE'
model folded
param f
default f = 0.01
state x
state v
state y
state phi
angle C S = cos(phi) sin(phi)
eq x = v
eq v = x - x^3 + f*C
eq y = 2*(x - 7/10)*v
eq phi = 1
periodic phi = 2*pi
integral K = y - (x - 7/10)^2
TABLE
jellett manifolds ./folded.tt --section phi=0 --level K=0 --solve x=0 --start y=0.497,v=0 --length 5 --crossings points.csv \
    > out 2> err || fail "manifolds: $(cat err)"
cut='unstable branch, side -1: .* runs into orbits that end, or leave the branch of --solve'
grep -q "^# $cut" out || fail "ends: $(cat out)"
grep -q "^jellett: shorter than --length: $cut" err || fail "a branch that is cut off: $(cat err)"
rows < points.csv | awk -F, '{ exit !($1^2 < 1e-12 && ($2 - 4.463549)^2 < 1e-8) }' || fail "homoclinic points: $(rows < points.csv)"
[ "$(rows < points.csv | wc -l)" -eq 1 ] || fail "more homoclinic points than the branch has: $(rows < points.csv)"
exit "$status"
