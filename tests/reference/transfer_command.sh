#!/usr/bin/env bash
# jellett transfer: densities that are known come back, in a measured order; the attractor, its mirror image, and where the sink is;
# what cannot be done is refused, and nothing is half-written.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
refuse() { # STATUS WORDS OPTION...
    local want=$1 words=$2
    shift 2
    expect "$want" "$words" jellett transfer "$@" -o rows.csv
    [ ! -e rows.csv ] || fail "$*: leaves a file"
}
column() { awk -F, -v name="$1" '/^#/ { next } !at { for (i = 1; i <= NF; i++) if ($i == name) at = i; next } { print $at }' "$2"; }

# I3 = 0: Euler and Jacobi's density on the section is |m g a3 + I1 gamma3 omega_n^2/s^2| with omega_n = G/(I1 R s), up to a factor,
# derived by hand from the table's rho = (I1 + m a3^2 s^2)/s, dv_nu dv_tau = dE deta/m and omega_tau'. A box's mean differs from its
# centre by h^2/24 of the second derivative, h = 0.01: below 1e-3 here; random points add h/sqrt(12*100*30), 30 of them in a row.
jellett transfer --set I3=0 --boxes eta=-pi:pi:30,gamma3=-0.7:-0.4:30 --eigenvalues 0 --tol 1e-9 -o rod.csv 2> err ||
    fail "I3=0: $(cat err)"
awk -F, '/^#/ { next } !at { for (i = 1; i <= NF; i++) if ($i == "known_density") at = i; next }
    { s2 = 1 - $2^2; row[$2] += $at; count[$2]++; want[$2] = 0.51 + $2*0.56^2*3/s2^2; if (want[$2] < 0) want[$2] = -want[$2] }
    END { for (k in row) { n++; ratio[k] = row[k]/count[k]/want[k]; sum += ratio[k] }
          for (k in row) if ((ratio[k]*n/sum - 1)^2 > 2e-3^2) bad++
          exit !(n > 10 && !bad) }' rod.csv || fail "I3=0: the known density is another"
# It is invariant: with as many strata as boxes, points at random err by the power 3/2 of the boxes' width. In 16 and 64 boxes:
for n in 16 64; do
    expect 0 "known density density" jellett transfer --set I3=0 --boxes ${n}x$n --strata $((n / 2)) --eigenvalues 0 \
        --tol 1e-9 --json
    jq -r '.operators[0].known_defect' out
done > defects
awk 'NR == 1 { wide = $1 } NR == 2 { order = log(wide/$1)/log(4); exit !(order > 1.2 && $1 < 2e-3) }' defects ||
    fail "I3=0: $(cat defects)"

# The thermostat of Nose and Hoover keeps its canonical density times the flux, which is not even, and the map mixes: Ulam's method
# is of first order in the boxes' width.
expect 0 '"known_defect_order"' jellett transfer nose_hoover --section z=0 --boxes q=-5:5:32,p=-5:5:32 --strata 20 --coarse 2,4 \
    --eigenvalues 0 \
    --tol 1e-8 --json
jq -e '.operators | length == 3 and .[0].known_defect < 0.02 and .[2].known_defect_order > 0.7 and .[2].known_defect_order < 1.5 and
    .[0].known_defect_order == null and ((.[2].known_defect/.[1].known_defect | log2) - .[2].known_defect_order |
    fabs) < 1e-12' out > /dev/null ||
    fail "Nose and Hoover: $(jq -c '[.operators[] | .known_defect, .known_defect_order]' out)"
# Eigenvalues come in the order of their magnitude, which ARPACK's is not, each with its vector.
expect 0 '"residual"' jellett transfer nose_hoover --section z=0 --boxes q=-5:5:32,p=-5:5:32 --eigenvalues 12 --tol 1e-6 --json
jq -e '.operators[0] | (.eigenvalues | map(pow(.re; 2) + pow(.im; 2)) | length == 12 and . == (sort | reverse)) and
    ([.eigenvalues[].residual] | max) < 1e-10 and .negative < 1e-12' out > /dev/null ||
        fail "eigenvalues: $(jq -c '.operators[0].eigenvalues' out)"
# Where eigenvalue 1 is not simple its vector has both signs; what is told as masses has one.
jellett transfer --set I3=0 --boxes 16x16 --tol 1e-9 -o many.csv 2> err
column mass many.csv | awk '{ sum += $1; bad += $1 < -1e-9 } END { exit !((sum - 1)^2 < 1e-18 && !bad) }' ||
    fail "I3=0: masses of both signs"

# A sink of the top with its mirror source (tools/docs/theorems.md): what stays forwards and what stays backwards are each in one
# place, apart and mirror images; from the box named Newton finds the cycle, of determinant 0.0445050142.
top=(--set I1=0.591,I3=0.494,a3=0.548 --level E=2.15,G=0.161)
expect 0 'evidence, not proof' jellett transfer "${top[@]}" --boxes 64x64 --tol 1e-8 --json --candidates 1
cp out forth
expect 0 'mapped backwards' jellett transfer "${top[@]}" --boxes 64x64 --tol 1e-8 --json --candidates 1 --backward
jq -n -e --slurpfile f forth --slurpfile b out '$f[0].operators[0] as $p | $b[0].operators[0] as $q |
    $p.asymmetry > 0.99 and $q.asymmetry > 0.99 and $p.eigenvalues[0].re > 0.9999 and $q.eigenvalues[0].re > 0.9999 and
    $p.balance < 1e-10 and ([$p.eigenvalues[], $q.eigenvalues[] | .residual] | max) < 1e-10 and
    ([$p.eigenvalues[] | pow(.re; 2) + pow(.im; 2)] | . == (sort |
    reverse)) and $f[0].candidates[0][0] == -$b[0].candidates[0][0] and $f[0].candidates[0][1] == $b[0].candidates[0][1]' > \
    /dev/null ||
    fail "sink and source: $(jq -c '.operators[0]' forth) and $(jq -c '.operators[0]' out)"
start=$(jq -r '.candidates[0] | "eta=\(.[0]),gamma3=\(.[1])"' forth)
expect 0 '^1,' jellett orbits "${top[@]}" --period 1 --start "$start"
awk -F, '/^period/ { for (i = 1; i <= NF; i++) at[$i] = i } /^1,/ { d = $at["det"] - 0.0445050142; exit !(d*d < 1e-18) }' out ||
    fail "no sink at $start: $(cat out)"

# Rows depend neither on threads nor on chance.
jellett transfer --boxes 20x20 --strata 4 --threads 1 -o one.csv 2> one.err
jellett transfer --boxes 20x20 --strata 4 --threads 2 -o two.csv 2> two.err
diff -q <(grep -v '^#' one.csv) <(grep -v '^#' two.csv) > /dev/null && diff -q one.err two.err > /dev/null ||
    fail "rows depend on threads"
awk -v n="$(column mass one.csv | awk '{ s += $1 } END { print s }')" 'BEGIN { exit !((n - 1)^2 < 1e-12) }' ||
    fail "masses have another sum than 1"
jellett transfer --boxes 20x20 --strata 4 --seed 2 -o three.csv 2> err
! diff -q <(grep -v '^#' one.csv) <(grep -v '^#' three.csv) > /dev/null || fail "the seed does nothing"

# The return map of a damped oscillator, seen once a period of its force, is so contracting that all but two eigenvalues are 0:
# blocks of them come out as square roots of rounding, which is not told as numbers.
printf 'model damped\nstate x\nstate v\nstate phi\nangle c s = cos(phi) sin(phi)\neq x = v\neq v = - x - v/2 + c/2\neq phi = 1\n'\
'periodic phi = 2*pi\n' > damped.tt
expect 0 'more, up to .*e-0.* in magnitude, are not told: computed once more they are others' \
    jellett transfer ./damped.tt --section phi=0 --boxes x=-1.9:2:40,v=-1.9:2:40 -o damped.csv
[ "$(grep -oE 'eigenvalues .*' err | wc -w)" -le 3 ] || fail "rounding is told as eigenvalues: $(grep eigenvalues err)"

refuse 3 "no whole number from 1" --boxes 0x20
refuse 3 "raise E above" --level E=-5
refuse 3 "no point of them has a state" --boxes eta=1:1.01:4,gamma3=0.5:0.51:4
# A density claimed where k = 0 is known to the variant that sets this, on a section STATE=VALUE as well: 1 in volume, so that the
# share of an interval is its flux, x + x^3 integrated over it: by a point drawn in each of ten strata, which err by 1/sqrt(12) of a
# stratum each, hence by a hundredth of what x + x^3 changes by in the interval; twice as much is allowed, where it doubles.
printf '%s\n' 'model spring' 'param k >= 0' 'default k = 0' 'state x' 'state y' 'eq x = y' 'eq y = - x - x^3 - k*y' \
    'measure volume = 1 when k = 0' 'variant free : k = 0' > spring.tt
expect 0 known_density jellett transfer ./spring.tt --section y=0 --direction down --boxes x=0.2:1:4
column known_density out | awk '{ low = 0.2*NR; high = low + 0.2
    share = (high^2/2 + high^4/4 - low^2/2 - low^4/4)/(0.5 + 0.25 - 0.02 - 0.0004)
    if (($1*0.2/share - 1)^2 > 4e-4) bad = 1 } END { exit bad || NR != 4 }' || fail "the known density: $(column known_density out)"

# x' = k x on both sides of 0, which are two maps, so that each eigenvalue comes twice, and the leading one is exp(-2 pi k). A box
# keeps one share of its points but for a stratum at its ends: 2 of 100.
printf '%s\n' 'model leaving' 'param k' 'default k = 1/20' 'state x' 'state phi' 'eq x = k*x' 'eq phi = 1' 'periodic phi = 2*pi' \
    > leaving.tt
expect 0 ^x, jellett transfer ./leaving.tt --section phi=0 --boxes x=-1:1:200 --strata 100
sed -n 's/.*escape rate \([^ ]*\) a return.*/\1/p' err |
    awk '{ off = exp(-$1) - exp(-atan2(1, 1)*4/10) } END { exit !(NR == 1 && off*off < 4e-4) }' ||
    fail "orbits that leave: $(cat err)"

# Ulam's matrix made a second time, from rows of `section` on a regular grid of 20 x 20 points in each of 8 x 8 boxes, its
# leading eigenvalue and vector by iteration; on the way orbits leave the boxes. An entry's boundary cuts through some 40 of the 400
# cells of a box, whose points fall on either side: an entry errs by sqrt(40)/2/400 = 0.008, the eigenvalue by no more than twice
# that, a row of 13 entries by 13/2 times that in total variation.
printf '%s\n' 'model duffing' 'state x' 'state v' 'state phi' 'angle c s = cos(phi) sin(phi)' 'eq x = v' \
    'eq v = x - x^3 - v/10 + 3*c/10' 'eq phi = 1' 'periodic phi = 2*pi' > duffing.tt
for way in '' --backward; do
    expect 0 'escape rate' jellett transfer ./duffing.tt --section phi=0 --boxes x=-1.5:1.5:8,v=-1.2:1.2:8 --strata 20 \
        --eigenvalues 1 --tol 1e-8 $way -o boxes.csv
    sed -n 's/^jellett:   eigenvalues //p' err > values
    expect 0 '^25599,1,' jellett section ./duffing.tt --section phi=0 --returns 1 --tol 1e-8 $way \
        --grid x=-1.490625:1.490625:160,v=-1.1925:1.1925:160
    awk -F, 'function box(x, v) { x = (x + 1.5)/3*8; v = (v + 1.2)/2.4*8
                 return x < 0 || v < 0 || x >= 8 || v >= 8 ? -1 : 8*int(x) + int(v) }
             FILENAME == "values" { wanted = $1 }
             FILENAME == "out" && /^[0-9]/ && $2 == 0 { from = box($4, $5) }
             FILENAME == "out" && /^[0-9]/ && $2 == 1 { to = box($4, $5); if (to >= 0) P[from, to] += 1/400 }
             FILENAME == "boxes.csv" && /^x/ { for (i = 1; i <= NF; i++) if ($i == "mass") at = i; next }
             FILENAME == "boxes.csv" && !/^#/ { known[box($1, $2)] = $at }
             END { for (k = 0; k < 64; k++) mass[k] = 1/64
                   for (step = 0; step < 200; step++) {
                       for (k = 0; k < 64; k++) after[k] = 0
                       for (pair in P) { split(pair, e, SUBSEP); after[e[2]] += mass[e[1]]*P[pair] }
                       value = 0
                       for (k = 0; k < 64; k++) value += after[k]
                       for (k = 0; k < 64; k++) mass[k] = after[k]/value }
                   for (k = 0; k < 64; k++) off += (mass[k] > known[k] ? mass[k] - known[k] : known[k] - mass[k])/2
                   print value, wanted, off; exit !(value > 0.3 && (value - wanted)^2 < 0.016^2 && off < 0.05) }' \
        values out boxes.csv > said || fail "the matrix from rows of section, $way: $(cat said)"
done

# Rows of a sweep are those of each point by itself, behind its value.
jellett transfer --sweep a3=0.4:0.6:3 --boxes 12x12 --strata 4 > swept.csv 2> err || fail "a sweep: $(cat err)"
for a3 in 0.4 0.5 0.6; do
    jellett transfer --set a3=$a3 --boxes 12x12 --strata 4 2> err | grep '^[-0-9]' > one.csv
    cut -d, -f1-7 one.csv | sed "s/^/$a3,/" | cmp -s - <(grep "^$a3," swept.csv | cut -d, -f1-8) ||
        fail "the sweep differs at a3 = $a3"
done

refuse 3 "nothing stays in them" --boxes eta=0:0.01:4,gamma3=-0.9:-0.89:4
refuse 3 "eigenvalues are of 3 boxes" --boxes 1x2
refuse 3 "cannot be taken 3 together" --boxes 10x10 --coarse 3
refuse 3 "longer than its period" --boxes eta=-9:9:4,gamma3=-0.5:0.5:4
refuse 3 "has no width" --boxes eta=0,gamma3=-0.5:0.5:4
refuse 3 "nothing stays in them" --set I3=0 --boxes eta=-0.5:0.5:20,gamma3=-0.61:-0.59:4 --strata 4
refuse 3 "points of a box" routh_sphere --section omega_tau=0 --boxes gamma3=-0.9:0.9:2,omega_n=-1:1:2,omega3=-1:1:2 --strata 101
refuse 2 "leave out --eigenvalues 0" --eigenvalues 0 --plot x.svg
refuse 2 "from 0 to 1" --noise 2
refuse 2 "ascending" --coarse 4,2
refuse 2 "leave out --json" --sweep a3=0:1:2 --json
refuse 2 "say which boxes" lorenz --section z=27
exit $status
