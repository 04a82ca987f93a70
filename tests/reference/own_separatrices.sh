#!/usr/bin/env bash
# Separatrices of a saddle with large multipliers: no piece of them is the tangent line.
set -uo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
export XDG_CACHE_HOME=$scratch/cache LC_ALL=C
fail() { echo "$*" | head -5; status=1; }

# A particle in a double well, seen once a period of a clock that does nothing: multipliers exp(+-2 pi/w). The separatrices of the
# saddle at rest lie on v^2 = x^2 - x^4/2, where its energy is. Their points are images of starts on the tangent at most 1e-4 away,
# of energy 1e-17; the rest is what the method errs by, 1e-13 a few times.
cat > well.tt <<'TABLE'
model well
param w > 0
default w = 1
state x
state v
state phi
angle c s = cos(phi) sin(phi)
eq x = v
eq v =
    + x
    - x^3
eq phi = w
periodic phi = 2*pi
TABLE
status=0
for w in 1 2/3; do
    jellett manifolds ./well.tt --set w=$w --section phi=0 --start x=1e-9,v=0 --length 1.2 --no-crossings > out 2> err < /dev/null \
        || cat err
    awk -F, '/^(un)?stable,/ { off = $6^2 - $5^2 + $5^4/2; if (off*off > worst) worst = off*off; n++ }
        END { if (n > 100 && worst < 1e-24) exit 0; print n " points, the worst off by " sqrt(worst); exit 1 }' out ||
        { echo "w = $w: not on the separatrix"; status=1; }
done

# Unstable and stable branches are one curve. Where their polygons cross there is no homoclinic point to tell.
jellett manifolds ./well.tt --section phi=0 --start x=1e-9,v=0 --length 2.4 --crossings points.csv > out 2> err < /dev/null ||
    cat err
[ "$(grep -vc '^#' points.csv)" -eq 1 ] ||
    { echo "homoclinic points of an integrable system: $(grep -v '^#' points.csv | head -3)"; status=1; }
grep -qE 'at [0-9]+ places separatrices touch, or cross by no more than errors at this --tol tell' err ||
    { echo "nothing is said of touching: $(cat err)"; status=1; }

# Where the saddle hardly stretches there are thousands of such places, each hundreds of returns away: the search ends early.
timeout 300 jellett manifolds ./well.tt --set w=50 --section phi=0 --start x=1e-9,v=0 --length 4 --crossings points.csv > out \
    2> err < /dev/null || cat err
[ "$(grep -vc '^#' points.csv)" -eq 1 ] && grep -qE 'at [0-9]{3,} places .*, or follow a row of 64 such places' err ||
    { echo "where separatrices are one: $(cat err)"; status=1; }

# In other units angles are small, and their errors with them. That of the mirror images at the outermost point is
# 2 atan(tan(angle/2)/1e6) where x counts in millionths.
sed -e 's/^model well/model driven/' -e 's/^param w.*/param L > 0/' -e 's/^default .*/default L = 1/' -e 's/^eq x = v/eq x = v*L/' \
    -e 's|^    + x$|    + x/L|' -e 's|^    - x^3|    - x^3/L^3 + c/20|' -e 's/^eq phi = w/eq phi = 1/' well.tt > driven.tt
echo 'reversor v -> -v, phi -> -phi' >> driven.tt
for L in 1 1e-6; do
    jellett manifolds ./driven.tt --set L=$L --section phi=0 --start "x=$(awk -v L=$L 'BEGIN { print -L/40 }'),v=0" --length 2.5 \
        --crossings points.csv > out 2> err < /dev/null || cat err
    awk -F, -v L=$L '$1/L < -1.4 { sub(/-/, "", $7); print $7, $8 }' points.csv
done > angles
awk 'NR == 1 { t = sin($1/2)/cos($1/2)*1e-6; want = 2*atan2(t, 1); error = $2*1e-6 }
    NR == 2 { off = $1 - want; error += $2; known = $2 > 0 && off*off <= error*error }
    END { exit !(NR == 2 && known) }' angles || { echo "small angles: $(cat angles)"; status=1; }

# From whichever seed, the angle at a crossing is the same within its errors.
sed -e 's/^model driven/model faster/' -e 's/^eq phi = 1/eq phi = 3/' driven.tt > faster.tt
for seed in 1e-3 3e-4 1e-4 1e-5 1e-6; do
    jellett manifolds ./faster.tt --section phi=0 --start x=-1/40,v=0 --length 2.2 --seed $seed --crossings points.csv > out \
        2> err < /dev/null || cat err
    awk -F, -v seed=$seed '$5 == $6 && $5 ~ /1/ { print $5, $7, $8, seed }' points.csv
done > seeds
awk '{ for (i = 1; i < NR; i++) if (side[i] == $1 && ($2 - angle[i])^2 > ($3 + error[i])^2) off = 1
    side[NR] = $1; angle[NR] = $2; error[NR] = $3 } END { exit off || NR != 10 }' seeds ||
    { echo "angles from several seeds: $(cat seeds)"; status=1; }

# same FIRST SECOND LEAST: angles at crossings of both files, LEAST of them at least, are the same within their errors.
same() {
    awk -F, -v least="$3" 'FNR == 1 { file++ } !/^[-0-9]/ { next }
        file == 1 { x[n] = $1; v[n] = $2; side[n] = $5 $6; angle[n] = $7; error[n++] = $8; next }
        { for (i = 0; i < n; i++) if (side[i] == $5 $6 && (x[i] - $1)^2 + (v[i] - $2)^2 < 1e-16) {
              met++
              if (($7 - angle[i])^2 > ($8 + error[i])^2)
                  print "an angle at " $1 ": " angle[i] " +- " error[i] " and " $7 " +- " $8 } }
        END { if (met < least) print met " crossings of " n " met again" }' "$1" "$2" > wrong
    [ ! -s wrong ] || { head -3 wrong; status=1; }
}

# At whichever tolerance, too: that the angle hardly changes with it is no error of less than the tolerance.
for tol in 1e-7 1e-13; do
    jellett manifolds ./faster.tt --section phi=0 --start x=-1/40,v=0 --length 4 --seed 1e-3 --tol $tol \
        --crossings points-$tol.csv > out 2> err < /dev/null || cat err
done
same points-1e-7.csv points-1e-13.csv 8

# So are those of all crossings of a weakly driven well, where branches are not bent to second order: also of crossings near the
# saddle, where the beginning from the greater seed errs by what the cubic term makes.
sed -e 's/^model driven/model weakly/' -e 's/^eq phi = 1/eq phi = 3/' -e 's|c/20|c/2783|' driven.tt > weakly.tt
for seed in 1e-4 1e-5; do
    jellett manifolds ./weakly.tt --section phi=0 --start x=0,v=0 --length 6 --seed $seed --crossings points-$seed.csv > out \
        2> err < /dev/null || cat err
done
same points-1e-4.csv points-1e-5.csv 100

# The map keeps areas, and half a period later the forced well is its own image under x -> -x: neighbouring lobes beside the
# outermost points, and those of the other side, have one area. Errors tell so at any tolerance, and are the
# tolerance times the multiplier, 535, and the turns of the branches, few.
sed -e 's/^model driven/model less/' -e 's|c/20|c/50|' driven.tt > less.tt
for how in 'driven --tol 1e-7 --seed 1e-3 --spacing 0.2 --turn 1' 'less --tol 5e-8 --seed 1e-3'; do
    table=${how%% *}
    for what in '--tol 1e-13' "${how#* }"; do
        jellett manifolds ./$table.tt --section phi=0 --start x=-1/40,v=0 --length 6 $what --crossings points.csv > out 2> err \
            < /dev/null || cat err
        awk -F, -v what="$what" '$5 == $6 && $3 < 2 && $10 != "" && $10^2 < 0.1 { sub(/-/, "", $10); print $10, $11, what }' \
            points.csv
    done > lobes
    awk '{ area[NR] = $1; error[NR] = $2; for (i = 1; i < NR; i++) if (($1 - area[i])^2 > ($2 + error[i])^2) off = 1 }
        !($2 > 0 && $2 < 1e4*$4) { off = 1 } END { exit off || NR != 8 }' lobes ||
        { echo "areas of lobes: $(cat lobes)"; status=1; }
done

# Beside another saddle, of multiplier 535, separatrices of a pendulum run so fast in sigma that errors of a return move their
# points along them by 1e-7: where polygons cross at right angles there is a crossing all the same.
printf '%s\n' 'model pendulum' 'param a' 'default a = 1/5' 'state q' 'state p' 'state phi' 'angle c s = cos(phi) sin(phi)' \
    'angle C S = cos(q) sin(q)' 'eq q = p' 'eq p = a*c - S' 'eq phi = 1' 'periodic q = 2*pi' 'periodic phi = 2*pi' > pendulum.tt
jellett manifolds ./pendulum.tt --section phi=0 --start q=2.232,p=0.854 --length 12 --crossings points.csv > out 2> err \
    < /dev/null || cat err
[ "$(grep -c '^[-0-9]' points.csv)" -eq 15 ] && [ ! -s err ] ||
    { echo "$(grep -c '^[-0-9]' points.csv) of 15 crossings: $(cat err)"; status=1; }
# Undriven, its separatrices are one curve, and a loose tolerance makes no crossing of it.
jellett manifolds ./pendulum.tt --set a=0 --section phi=0 --start q=pi,p=0 --length 8 --tol 1e-6 --crossings points.csv > out \
    2> err < /dev/null || cat err
! grep -q '^[-0-9]' points.csv || { echo "crossings of one curve: $(grep '^[-0-9]' points.csv)"; status=1; }
# Those of x'' = x - x^3 lead back to their saddle: within 1e-7 of it errors cross at any angle.
printf '%s\n' 'model back' 'state x' 'state v' 'state phi' 'eq x = v' 'eq v = x - x^3' 'eq phi = 1' 'periodic phi = 2*pi' \
    'reversor v -> -v, phi -> -phi' > back.tt
for tolerance in 1e-13 1e-12 1e-9; do
    jellett manifolds ./back.tt --section phi=0 --start x=0,v=0 --length 5 --tol $tolerance --crossings points.csv > out 2> err \
        < /dev/null || cat err
    ! grep -q '^[-0-9]' points.csv || { echo "crossings of one curve: $(grep '^[-0-9]' points.csv)"; status=1; }
done

# Where crossings are not looked for, no list of them begins.
jellett manifolds ./driven.tt --section phi=0 --start x=-1/40,v=0 --no-crossings > out 2> err < /dev/null || cat err
! grep -q homoclinic out || { echo "a list of what was not looked for: $(grep -A 2 homoclinic out)"; status=1; }

jellett manifolds ./well.tt --section phi=0 --start x=1e-9,v=0 --seed 1e-9 > out 2> err < /dev/null
[ $? -eq 3 ] && grep -q -- '--seed:' err || { echo "a seed out of range: $(cat err)"; status=1; }
# At loose tolerances pieces of branches are halved until errors of their points are left, and no longer: lobes of the top are
# those at a tight tolerance, within both error bars.
jellett manifolds --length 0.5 --tol 1e-12 --crossings tight.csv > out 2> err < /dev/null || fail "lobes at 1e-12: $(cat err)"
timeout 60 jellett manifolds --length 0.5 --tol 1e-6 --crossings loose.csv > out 2> err < /dev/null ||
    fail "lobes at 1e-6: $(cat err)"
timeout 60 jellett manifolds --length 0.5 --tol 1e-5 --crossings loose.csv > out 2> err < /dev/null ||
    fail "lobes at 1e-5: $(cat err)"
# A lobe reaches to the next crossing that is found, over those that are not.
awk -F, '/^#/ || /^eta/ { next }
    NR == FNR { n++; x[n] = $1; y[n] = $2; lobe[n] = $10; bar[n] = $11; next }
    { for (i = near = 1; i <= n; i++) if (($1 - x[i])^2 + ($2 - y[i])^2 < ($1 - x[near])^2 + ($2 - y[near])^2) near = i
      d = last
      for (i = from; reaches && i < near; i++) { d -= lobe[i]; error += bar[i] }
      if (reaches) { all++; bad += !(d*d <= error*error) }
      last = $10; error = $11; from = near; reaches = $10 != "" && $10 != "nan" }
    END { exit !(all > 10 && bad == 0) }' tight.csv loose.csv || fail "lobes at 1e-5 are outside their error bars"

# A separatrix from saddle to saddle, v = (1 - x^2)/sqrt(2), is 2.5426 long: beyond it nothing is left but errors, and that is said.
# The other side goes to infinity, some of it within one return.
printf '%s\n' 'model pass' 'state x' 'state v' 'state phi' 'eq x = v' 'eq v = x^3 - x' 'eq phi = 1' 'periodic phi = 2*pi' > pass.tt
jellett manifolds ./pass.tt --section phi=0 --start x=-1,v=0 --length 20 --no-crossings > out 2> err < /dev/null ||
    { echo "a separatrix between saddles: $(cat err)"; status=1; }
grep -q 'unstable branch, side +1: .* errors outgrow the spacing' err || { echo "nothing of errors: $(cat err)"; status=1; }
awk -F, '/^unstable,1,/ { length_of = $4 } /^unstable,-1,/ { other = $4 } END { exit !(length_of < 3 && other > 20) }' out ||
    { echo "branches between saddles, and to infinity: $(grep '^# .* branch' out)"; status=1; }

# Branches of two competing species end in the sinks at which one of them is left, and in the source without any; these are periodic
# orbits, on axes that stay invariant, with multipliers exp(-2 pi) and exp(2 pi). A few returns then show all of a branch.
printf '%s\n' 'model rivals' 'state x' 'state y' 'state phi' 'periodic phi = 2*pi' 'angle c s = cos(phi) sin(phi)' \
    'eq x = x*(1 + c/5 - x - 2*y)' 'eq y = y*(1 - s/5 - y - 2*x)' 'eq phi = 1' > rivals.tt
timeout 60 jellett manifolds ./rivals.tt --section phi=0 --start x=0.33,y=0.33 --no-crossings > out 2> err < /dev/null ||
    fail "branches that end in sinks: status $?, $(cat err)"
[ "$(grep -c 'unstable branch, .* settles on a periodic orbit' err)" -eq 2 ] || fail "branches that end in sinks: $(cat err)"
jellett orbits ./rivals.tt --section phi=0 --start x=1.1,y=0 2> /dev/null | grep -v '^#' | tail -1 | cut -d, -f2,3 > sink
awk -F, 'NR == FNR { x = $1; y = $2; next } /^unstable,-?1,/ { end[$2] = ($5 - x)^2 + ($6 - y)^2 }
    END { exit !(end[1] < 1e-20 || end[-1] < 1e-20) }' sink out || fail "no branch ends at the sink $(cat sink)"

# Who asks for crossings before which the branches end is told so; who gets some is not.
jellett manifolds --length 0.3 --crossings points.csv > out 2> err < /dev/null || { echo "short branches: $(cat err)"; status=1; }
grep -q 'do not cross within --length: 4 of 4 branches end there; ask for a larger one' err ||
    { echo "nothing is said of branches that end before they cross: $(cat err)"; status=1; }
jellett manifolds --crossings points.csv > out 2> err < /dev/null || { echo "the branches of Figure 3b: $(cat err)"; status=1; }
! grep 'do not cross' err || status=1
exit $status
