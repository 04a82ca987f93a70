#!/usr/bin/env bash
# A section that stands in a smaller table of the user's own: found, planned, in batches, and refused where the smaller table does
# not know what the model's conditions are. Its parameters and levels are what the reduction says, by whatever names; what cannot be
# followed so is refused, as is the section of a larger table, which may have other parameters.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
# A hard spring whose stiffness is a state that stays; the smaller table has it as a parameter, and sees the spring where it turns.
cat > big.tt <<'TABLE'
model big
state x
state p
state z in (0, inf)
eq x = p
eq p =
    - z*x
    - x^3
eq z = 0*z
integral K = z
reduction held : by small.tt with x = x, p = p, K = K
TABLE
cat > small.tt <<'TABLE'
model small
param K > 0
default K = 1
state x
state p
eq x = p
eq p =
    - K*x
    - x^3
integral E = p^2/2 + K*x^2/2 + x^4/4
embedding whole : into big.tt with x = x, p = p, z = K
section turning : by turns.tt at p = 0 with x = x
TABLE
printf 'model turns\nparam K > 0\ndefault K = 1\nstate x\nlift into small.tt with x = x, p = 0\nstart regular : x = -1\n' > turns.tt

# The period is 4 F/sqrt(K + x0^2), F the complete elliptic integral of parameter x0^2/(2 (K + x0^2)): by the arithmetic-geometric
# mean pi/(2 agm(1, sqrt(1 - m))).
period() { awk -v K="$1" -v x="$2" 'BEGIN { a = 1; b = sqrt(1 - x^2/(2*(K + x^2))); for (i = 0; i < 30; i++) { c = (a + b)/2;
    b = sqrt(a*b); a = c }
    printf "%.17g", 2*3.141592653589793/a/sqrt(K + x^2) }'; }
for K in 1 2; do
    for how in '' '--start x=-0.5'; do # two orbits go in lanes
        expect 0 '^# levels K=' jellett section ./big.tt --level K=$K --start x=-1 --returns 3 $how
        awk -F, -v T="$(period $K 1)" \
            '/^0,[0-3],/ { n++; bad += ($3 - $2*T)^2 + ($4 + 1)^2 > 1e-22 } END { exit !(n == 4 && !bad) }' out ||
            fail "K = $K $how: T = $(period $K 1), not $(tail -3 out)"
    done
done
# All of its orbits are periodic: the one asked for is found, and no other of the family.
expect 0 '^1,-(1|0.99999999)' jellett orbits ./big.tt --start x=-1 --period 1
expect 0 '^  \* small .*the smallest that answers' jellett plan section ./big.tt --start x=-1
grep -q 'on levels K=1 (an integral, proved)' out || fail "the plan: $(cat out)"

# A condition of the model alone would be passed over; said in both tables, it ends orbits.
echo 'valid near : 4 - x^2 > 0' >> big.tt
expect 3 "does not say where near of this table is lost: write 'valid near" jellett section ./big.tt --start x=-3
expect 3 "does not say where near" jellett fates ./big.tt --grid x=-3:-1:2
expect 0 'lost_near' jellett section ./big.tt --section p=0 --start x=-3,z=1 --contact end --returns 1
echo 'valid near : 4 - x^2 > 0' >> small.tt
expect 0 '^0,0,0,-3,lost_near$' jellett section ./big.tt --start x=-3 --contact end --returns 1
expect 0 '^0,1,.*,alive$' jellett section ./big.tt --start x=-1 --contact end --returns 1

# A level that the section's table has as a parameter keeps the sign that it has there.
expect 3 'K = -1: small needs K > 0' jellett section ./big.tt --level K=-1 --start x=-1 --returns 1
expect 3 'K = -1: small needs K > 0' jellett section ./big.tt --sweep K=-1:0:2 --start x=-1 --returns 1

# A parameter of which the section's table knows nothing may be set and swept as any other, and moves no orbit.
sed 's/model big/model more/; s/^state x/param q >= 0\ndefault q = 0\n&/; s/^integral K/observe moved = x + q\n&/' big.tt > more.tt
expect 0 '^0,1,' jellett section ./more.tt --set q=1 --start x=-1 --returns 1
awk -F, -v T="$(period 1 1)" '/^0,1,/ { exit !(($3 - T)^2 < 1e-22) }' out || fail "beside q: $(tail -1 out)"
expect 0 '^# q=1 K=1$' jellett section ./more.tt --set q=1 --start x=-1 --returns 1
expect 0 '^1,0,1,' jellett section ./more.tt --sweep q=0:1:2 --start x=-1 --returns 1
expect 0 '^1,1,' jellett fates ./more.tt --sweep q=0:1:2 --grid x=-1 --returns 1
expect 3 'q = -1: more needs q >= 0' jellett section ./more.tt --set q=-1 --start x=-1 --returns 1
expect 3 "there is no parameter 'w'; there are q" jellett section ./more.tt --set w=1 --start x=-1 --returns 1

# The spring's other constant is half of J here, and c there: in the section's table it is computed from J.
cat > mapped.tt <<'TABLE'
model mapped
param J > 0
default J = 2
state x
state p
state z in (0, inf)
eq x = p
eq p =
    - z*x
    - J*x^3/2
eq z = 0*z
integral K = z
reduction held : by hard.tt with x = x, p = p, K = K, c = J/2
TABLE
cat > hard.tt <<'TABLE'
model hard
param c > 0
param K > 0
default K = 1, c = 5
state x
state p
eq x = p
eq p =
    - K*x
    - c*x^3
integral E = p^2/2 + K*x^2/2 + c*x^4/4
embedding whole : into mapped.tt with x = x, p = p, z = K, J = 2*c
section turning : by spots.tt at p = 0 with x = x
TABLE
printf 'model spots\nparam c > 0\nparam K > 0\ndefault K = 1, c = 5\nstate x\nlift into hard.tt with x = x, p = 0\n' > spots.tt
row='NR > 1 && /^0,1,/ { exit !(($3 - T)^2 < 1e-22) } END { if (NR < 2) exit 1 }'
expect 0 '^# J=2 c=1 K=1$' jellett section ./mapped.tt --start x=-1 --returns 1
awk -F, -v T="$(period 1 1)" "$row" out || fail "c from the default of J: $(tail -1 out)"
expect 0 '^# J=4 c=2 K=2$' jellett section ./mapped.tt --set J=4 --level K=2 --start x=-1 --returns 1
awk -F, -v T="$(period 2 1.4142135623730951)" "$row" out || fail "c from J=4: $(tail -1 out)"
expect 0 '^2,0,1,' jellett section ./mapped.tt --sweep J=2:4:2 --start x=-1 --returns 1
expect 0 '^# K=1$' jellett section ./mapped.tt --sweep J=2:4:2 --start x=-1 --returns 1
expect 3 "there is no parameter 'c'; there are J" jellett section ./mapped.tt --set c=1 --start x=-1 --returns 1
expect 3 'J = -1: mapped needs J > 0' jellett section ./mapped.tt --set J=-1 --start x=-1 --returns 1
expect 3 'K = -1: hard needs K > 0' jellett section ./mapped.tt --level K=-1 --start x=-1 --returns 1
expect 0 'hard' jellett orbits ./mapped.tt --start x=-1 --period 1
# c has the exact value J/2 for a theorem too; there is none that says of one orbit of a family that it is the only one.
expect 4 'could not be refined .* a multiplier is 1 to within .* families' jellett certify sink ./mapped.tt --start x=-1
# So where both tables call theirs c.
mkdir same
cp spots.tt same
sed 's/\<J\>/c/g' mapped.tt > same/mapped.tt
sed 's/J = 2/c = 2/' hard.tt > same/hard.tt
expect 0 '^# c=4 K=2$' jellett section same/mapped.tt --set c=4 --level K=2 --start x=-1 --returns 1
awk -F, -v T="$(period 2 1.4142135623730951)" "$row" out || fail "c from c=4: $(tail -1 out)"
expect 0 '' jellett section same/mapped.tt --set c=4 --level K=2 --start x=-1 --returns 1 --plot shown.svg --keep shown.gp
grep -q 'c=4, K=2}' shown.gp || fail "the caption of a picture is not in what is typed: $(grep 'set title' shown.gp)"
expect 0 '^# K=1$' jellett section same/mapped.tt --sweep c=2:4:2 --start x=-1 --returns 1
# Another quantity is called K here: the level of the section's table has no name.
sed 's/integral K = z/integral K = 2*z/; s/K = K,/K = K\/2,/' mapped.tt > other.tt
sed 's/model mapped/model other/' -i other.tt
for command in 'section --returns 1' 'orbits --period 1' lyapunov 'certify sink'; do
    expect 3 'the reduction held sets K of hard to something other than K of other: rename one' \
        jellett $command --start x=-1 ./other.tt
done
# What has another name, or its interval in other words, is told with what to write.
mkdir words
printf 'model low\nparam k > 0\ndefault k = 1\nstate x\nstate v\neq x = v\neq v = -k*x\n'\
'section rest : by low_section.tt at v = 0 with x = x\n' > words/low.tt
printf 'model low_section\nparam k > 0\nstate x\nlift into low.tt with x = x, v = 0\n' > words/low_section.tt
printf 'model high\nparam stiff > 0\nstate x\nstate v\nstate z\neq x = v\neq v = -stiff*x\neq z = x\n'\
'reduction down : onto low.tt with k = stiff, x = x, v = v\n' > words/high.tt
expect 3 'the reduction down gives k of low, which high does not have: call it k there too, or ask low' \
    jellett section words/high.tt --set stiff=2 --start x=-1 --returns 1
sed -i 's/stiff/k/g; s/with k = k, x = x/with x = y/; s/x/y/g; s/with y = y/with x = y/; s/^state y/state y in (-5, 5)/' \
    words/high.tt
sed -i 's/^state x/state x in (-5, 5)/' words/low.tt words/low_section.tt
expect 0 '^0,1,4.44288293815836' jellett section words/high.tt --set k=2 --start x=-1 --returns 1 # 2 pi/sqrt(2)
sed -i 's/y in (-5, 5)/y in (-4, 5)/' words/high.tt
expect 3 'where y does not bound the motion: give it the same bound there, in the states that the reduction gives, or ask low' \
    jellett section words/high.tt --set k=2 --start x=-1 --returns 1
# So with a record `domain`, whose words are the same in both tables where its bound is another, and differ where it is the same.
mkdir bounds
bounded() { # HERE BEYOND AS THERE...: this table's state and what bounds it; what gives x of the other; what bounds x
    printf '%s\n' 'model small' 'state x' 'state v' "${@:4}" 'eq x = v' 'eq v = 9 - x' \
        'section rest : by small_section.tt at v = 0 with x = x' > bounds/small.tt
    printf '%s\n' 'model small_section' 'state x' "${@:4}" 'lift into small.tt with x = x, v = 0' > bounds/small_section.tt
    printf '%b\n' 'model large' "state $1" 'state v' 'state z' "$2" "eq $1 = v" "eq v = 9 - ($3)" "eq z = $1" \
        "reduction down : onto small.tt with x = $3, v = v" > bounds/large.tt
}
unbounded='leads onto small, where rim does not bound the motion'
bounded y 'domain rim : y > 0' y 'domain rim : x > 0'
expect 0 '^0,1,6.28318530717958' jellett section bounds/large.tt --start x=5 --returns 1
bounded x 'domain rim : x > 0' 'x + 1' 'domain rim : x > 0'
expect 3 "$unbounded" jellett section bounds/large.tt --start x=0.5 --returns 1
bounded x 'let far = x - 2\ndomain rim : far > 0' x 'let far = x - 1' 'domain rim : far > 0'
expect 3 "$unbounded" jellett section bounds/large.tt --start x=1.5 --returns 1
bounded x 'let far = x - 1\ndomain rim : far > 0' x 'let far = x - 1' 'domain rim : far > 0'
expect 0 '^0,1,6.28318530717958' jellett section bounds/large.tt --start x=1.5 --returns 1
bounded x 'domain rim : 2*x - 2 > 0' x 'domain rim : x/3 - 1/3 > 0' # but for a positive number
expect 0 '^0,1,6.28318530717958' jellett section bounds/large.tt --start x=1.5 --returns 1
bounded x 'domain rim : 2*x - 2 > 0' x 'domain rim : x - 2/3 > 0'
expect 3 "$unbounded" jellett section bounds/large.tt --start x=1.5 --returns 1
# So where that happens on the way, in a table between the two.
sed 's/^reduction/embedding up : into wide.tt with x = x, p = p, z = z, w = J\n&/' -i other.tt
sed 's/model other/model wide/; /J > 0/d; /default/d; s/J\*x/w*x/; /^integral/d; /^embedding/d; /^reduction/d
    s/^state x/state w in (0, inf)\n&/' other.tt > wide.tt
printf 'eq w = 0*w\nreduction fixed : by other.tt with x = x, p = p, z = z, J = w\n' >> wide.tt
expect 3 'the reduction held sets K of hard to something other' jellett section ./wide.tt --start x=-1 --returns 1
# A claim that is refuted hides none that is proved.
sed 's/^reduction held/reduction wrong : by hard.tt with x = -x, p = p, K = K, c = J\/2\n&/' mapped.tt > first.tt
expect 0 '^# J=2 c=1 K=1$' jellett section ./first.tt --start x=-1 --returns 1
# Orbits turn over at both poles where the clause `turns` is positive at both.
mkdir tilted
cp "$JLT_SOURCE_DIR"/codegen/models/spherical_top*.tt tilted
sed -i 's|^turns .*|turns gamma3^2 - 1/2 "tilted"|' tilted/spherical_top_section.tt
expect_text 0 'of 24 tilted 1 +- 0.04 turn over' jellett fates tilted/spherical_top.tt --grid 6x6 --set a3=0.2
[ "$(awk -F, '/,pole[+],/ && $2^2 < 1/2' out | wc -l) $(awk -F, '/,pole-,/ && $2^2 < 1/2' out | wc -l)" = '1 23' ] ||
    fail "tilted tops end at the poles: $(cat out)"
# The balanced sphere is embedded into the top with a3 = 0, and describes no section.
for model in balanced plane; do
    expect 3 'ask spherical_top' jellett section spherical_top_$model --start eta=0.44,gamma3=-0.62 --returns 1
    expect 3 'ask spherical_top' jellett orbits spherical_top_$model --start eta=0.44,gamma3=-0.62
done
exit $status
