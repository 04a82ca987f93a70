#!/usr/bin/env bash
# What an edit of a table does to the answers: a symmetry that is broken by little, a rate that jumps, a rate that divides by zero,
# a density that is kept no longer. What is said is of the table as it is, or the table's record is named that forbids the question.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
rows() { grep -v '^#' out | tail -n +2; }

# 1. x'' = a x - x^3 - x'/5 + e is at rest where a x - x^3 + e = 0. For e = 0 two branches cross at a = 0. For any other e they do
# not: one goes on without a bifurcation, the other one has a fold at a = 3 (e/2)^(2/3), where x^3 = -e/2.
cat > pitchfork.tt <<'TABLE'
model pitchfork
param a
param e
default a = 1/2, e = 0
state x
state v
state phi
eq x = + v
eq v = + a*x - x^3 - v/5 + e
eq phi = + 1
periodic phi = 2*pi
TABLE
follow() {
    expect 0 'the range ends' jellett continue ./pitchfork.tt --section phi=0 --set a=1/2,e="$1" --along a=-1:1 \
        --start x="$2",v=0 --decreasing
}
follow 0 0.7
[ "$(rows | cut -d, -f17 | grep .)" = 'branch point' ] || fail "e = 0: $(rows | grep -E 'fold|point')"
for e in 1e-10 1e-9 1e-6 1e-3; do
    follow $e 0.7
    [ -z "$(rows | cut -d, -f17 | grep .)" ] || fail "e = $e, upper branch: $(rows | grep -E 'fold|point')"
    rows | awk -F, -v e=$e '($5^3 - $2*$5 - e)^2 > 1e-26 { exit 1 }' || fail "e = $e: no equilibria"
    follow $e -0.7
    rows | awk -F, -v e=$e '$17 != "" { kinds = kinds $17; at = $2/(3*(e/2)^(2/3)) }
        END { exit !(kinds == "fold" && (at - 1)^2 < 1e-12) }' ||
        fail "e = $e, lower branch: $(rows | grep -E 'fold|point')"
done
# From an orbit that is small, e/a, to one that is not, to the end of the range.
expect 0 'the range ends' jellett continue ./pitchfork.tt --section phi=0 --set a=-1/2,e=1e-6 --along a=-1:1 --start x=0,v=0
rows | tail -1 | awk -F, '{ exit !(($2 - 1)^2 < 1e-26 && ($5^3 - $5 - 1e-6)^2 < 1e-26) }' ||
    fail "from a small orbit: $(rows | tail -1)"
# Branches cross at a small angle, x = a and x = 1.01 a: each is followed, with its branch point at a = 0, in long steps too.
sed 's/+ a\*x - x^3 /- x^2 + 2.01*a*x - 1.01*a^2 /' pitchfork.tt > oblique.tt
for slope in 1 1.01; do
    for range in -1:1 -10:0.9; do
        for tolerance in 1e-9 1e-13 1e-14 1e-15; do
            expect 0 'the range ends' jellett continue ./oblique.tt --section phi=0 --along a=$range --decreasing --tol $tolerance \
                --start x="$(awk "BEGIN { print $slope/2 }")",v=0
            rows | awk -F, -v s=$slope '$17 != "" { kinds = kinds $17; at = $2 } END { x = $5/$2 - s
                exit !(kinds == "branch point" && at^2 < 1e-6 && x^2 < 1e-16) }' ||
                fail "x = $slope a, $range, $tolerance: $(rows | grep point) $(rows | tail -1)"
        done
    done
done

# 2. Where a rate jumps on all ways, the map has nowhere a derivative, and the search for orbits says so.
cat > dry.tt <<'TABLE'
model dry
param k >= 0
default k = 1/5
state x
state v
state phi
root r = sqrt(v^2)
angle c s = cos(phi) sin(phi)
eq x = + v
eq v = - x - v/10 - k*v/r + c
eq phi = + 6/5
periodic phi = 2*pi
measure volume = 1
TABLE
search=(jellett orbits ./dry.tt --section phi=0 --grid x=-3:3:4,v=-3:3:4 --period 1)
expect 0 'no orbit is found: at none of the starts does the map have a derivative: .* a rate jumps' "${search[@]}"
expect 0 '^1,-2.11538461538461[0-9]*,0.69230769230769[0-9]*,' "${search[@]}" --set k=0
expect 0 'no orbit is found: a finer --grid' "${search[@]}" --set k=0 --near 1e-3 --settle 0

# 3. A start at which a rate divides by zero is outside the domain, whatever the command.
printf '%s\n' 'model divided' 'state x' 'state v' 'eq x = v' 'eq v = - x + 1/(10*v)' > divided.tt
for how in section 'section --direction both' fates lyapunov 'plan section'; do
    expect 3 'v=0: outside the domain of divided: a division needs v != 0' jellett $how ./divided.tt --section x=0 --start v=0
done
printf '%s\n' 'model hole' 'param m > 0' 'state x' 'state y' 'state u' 'state v' 'domain off : x^2 + y^2 - 1/100 > 0' \
    'root r = sqrt(x^2 + y^2)' 'eq x = u' 'eq y = v' 'eq u = - m*x/r^3' 'eq v = - m*y/r^3' \
    'integral E = (u^2 + v^2)/2 - m/r' > hole.tt
for how in section fates lyapunov orbits drift manifolds 'continue --along m=1:2'; do
    expect 3 'x=1/20,u=0: outside the domain of hole: off needs x.2 . y.2 - 1/100 > 0, and it is -0[.]0075 here' \
        jellett $how ./hole.tt --set m=1 --section y=0 --level E=-1/2 --solve v=1 --start x=1/20,u=0
done

# 4. The verdict on a density is in every form of the report.
expect 1 '; its claim is refuted' jellett measure ./dry.tt
expect 1 '"verdict": "refuted"' jellett measure ./dry.tt --json
sed -i 's/ - v.10//' dry.tt
expect 0 '"verdict": "proved"' jellett measure ./dry.tt --json
exit $status
