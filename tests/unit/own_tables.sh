#!/usr/bin/env bash
# A table of one's own works as a model that is built in: it is compiled behind the command, kept in a private cache, and an edit of
# its physics is followed, or refused with the claim that it broke.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
rows() { grep -v '^#' "$1"; }
# Whether rows of numbers agree to the tolerance of the integration; their kernels may round in another order.
agree() { # FILE FILE
    paste -d , "$1" "$2" | awk -F, '
        NR > 1 { for (i = 1; i <= 6; i++) { d = $i - $(i + NF/2); if (d > 1e-12 || d < -1e-12) exit 1 } } END { exit NR != 3 }'
}

cp "$JLT_SOURCE_DIR"/codegen/models/*.tt .

# The same table gives the same numbers, whether it is built in or not, and the second time at once.
start=gamma3=0.25,v_nu=0.8,omega_tau=-0.6,omega_n=1.1,omega3=-2.3
expect 0 alive jellett simulate --start $start --times 0,1 --tier five
rows out > built_in
expect 0 "tier level" jellett simulate ./spherical_top.tt --start $start --times 0,1
expect 0 alive jellett simulate spherical_top.tt --start $start --times 0,1 --tier five
rows out > own
agree own built_in || fail "the table's own kernels give other numbers than those built in"
[ "$(find cache -name '*.so' | wc -l)" -eq 1 ] || fail "one table has several objects: $(find cache -type f)"
[ "$(stat -c %a cache/jellett)" = 700 ] || fail "the cache is not private"

# Friction against the turning about n: 21 of the table's claims fall. G decays as dG/dt = -mu R I1 s omega_n says.
sed -i -e 's/^param a3 /param mu >= 0 "friction"\n&/' -e 's/^    + m\*R\*e\*I3\*omega3\*omega_tau\/Theta$/&\n    - mu*omega_n/' \
    -e 's/^default m = 1, R = 1/default mu = 0, m = 1, R = 1/' spherical_top.tt
expect 1 "37 claims: 16 proved, 21 refuted" ttc prove spherical_top.tt
expect 0 "integral claim 'G' is refuted" jellett simulate ./spherical_top.tt --set mu=1 --start $start --until 1 --every 1/64
grep -q "no longer serve in place of each other" err || fail "nobody says that the smaller model no longer serves"
rows out | awk -F, '
    NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
    {
        s = sqrt(1 - $at["gamma3"]^2)
        rate = -s * $at["omega_n"] / 3 # mu = R = 1, I1 = 1/3
        if (NR == 2) G0 = s * $at["omega_n"] / 3 - (0.51 + $at["gamma3"]) * $at["omega3"] / 3
        # Simpson: weights 1 4 2 4 ... 4 1, 64 intervals
        k = NR - 2
        sum += rate * (k == 0 || k == 64 ? 1 : k % 2 ? 4 : 2) / (3 * 64)
        drift = $at["drift_G"]
    }
    END {
        size = G0 < 0 ? -G0 : G0
        expected = (sum < 0 ? -sum : sum) / (size > 1 ? size : 1)
        difference = drift - expected
        # The error of the rule is below 64^-4 of a fourth derivative of some hundreds.
        exit !(k == 64 && expected > 0.1 && difference < 1e-6 && difference > -1e-6)
    }' || fail "drift_G is not what friction makes it: $(tail -1 out)"
expect 0 alive jellett simulate ./spherical_top.tt --start $start --times 0,1 --tier five
[ "$(find cache -name '*.so' | wc -l)" -eq 2 ] || fail "larger tables are compiled though the tier asked for is no tier of theirs"
grep -q "the reduction level of spherical_top is refuted: spherical_top_level.tt and this table do not serve" err ||
    fail "of kernels in the cache nobody says that the smaller model no longer serves: $(cat err)"
rows out > without
agree without built_in || fail "without friction the motion is another"
expect 3 "a claim that it rests on is refuted .reduction level: dG/dt" \
    jellett simulate ./spherical_top.tt --set mu=1 --start $start --times 1 --tier level
expect 3 "reduction reduced: the parameter mu of spherical_top is given no value" \
    jellett simulate ./spherical_top.tt --start $start --times 1 --tier full
expect 3 "G is no integral of this table any more: d.G./dt = -R.mu.I1" \
    jellett section ./spherical_top.tt --start eta=0.3,gamma3=0.2 --returns 3
grep -q -- "--section omega_tau=0" err || fail "section does not say what can be asked instead"
expect 0 alive jellett section ./spherical_top.tt --set mu=0.01 --section omega_tau=0 --returns 1 \
    --start gamma3=0.2,v_nu=0.4,omega_n=0.5,omega3=-2
expect 0 "UNPROVED: rests on" jellett models ./spherical_top.tt

# A number with a dimension of its own, a unit that is left out or wrong: whatever units an orbit is integrated in, it is that of
# the table. The same friction with a parameter that has its dimension is another way to it.
mkdir dimension
cp *.tt dimension
awk '{ print } /R.omega_n.omega3$/ && ++n == 1 { print "    - v_nu/10" }
    /^valid contact/ { print "observe spin = omega_n + 1\nobserve unit = omega_n*1 [m]" }' \
        "$JLT_SOURCE_DIR/codegen/models/spherical_top.tt" \
    > dimension/spherical_top.tt
heavy="m=1000,R=100,I1=3000000,I3=3000000,a3=51,g=10"
expect 0 alive jellett simulate ./dimension/spherical_top.tt --set $heavy --start $start --times 0,1
rows out > number
awk '{ print } /R.omega_n.omega3$/ && ++n == 1 { print "    - nu*v_nu" }
    /^param g/ { print "param nu [1/s] \"friction\"\ndefault nu = 1/10" }' \
    "$JLT_SOURCE_DIR/codegen/models/spherical_top.tt" > dimension/spherical_top.tt
expect 0 alive jellett simulate ./dimension/spherical_top.tt --set $heavy --start $start --times 0,1
rows out > parameter
paste -d, number parameter | awk -F, \
    'END { exit !(NR == 3 && $3 < -140.98 && $3 > -140.99 && ($3 - $15)^2 < 1e-16 && ($10 - $5 - 1)^2 < 1e-24 && $11 == $5) }' ||
    fail "a number with a dimension: $(paste -d, number parameter | tail -1)"

# What is wrong with a table is said with its place; its name reaches no shell.
printf 'model bad\nstate x\neq x = -x\nobserve t = 2*x\n' > bad.tt
expect 3 "bad.tt:4:9: error: 't' is a column of every table" jellett simulate ./bad.tt --start x=1 --times 1
printf 'model bad\nstate x\neq x = y\n' > bad.tt
expect 3 'bad.tt:3:8: error' jellett simulate ./bad.tt --start x=1 --times 1
name='a table; touch shell $(touch shell).tt'
printf 'model decay\nstate x\neq x = -x\n' > "$name"
expect 0 0.36787944117144 jellett simulate "./$name" --start x=1 --times 1
[ ! -e shell ] || fail "the name of a table reached a shell"
# What is no regular file is not waited for, nor read without an end.
mkfifo pipe.tt
mkdir folder.tt
ln -s /dev/zero endless.tt
expect 5 "pipe.tt: error: cannot read the file: it is a pipe or a device" timeout -s KILL 10 jellett simulate ./pipe.tt \
    --start x=1 --times 1
expect 5 "endless.tt: error: cannot read the file: it is a pipe or a device" timeout -s KILL 10 ttc check endless.tt
expect 5 "folder.tt: error: cannot read the file: Is a directory" ttc check folder.tt
expect 5 "cannot open|No such file" jellett simulate ./absent.tt --start x=1 --times 1

# Many orbits get kernels on vectors of their own; rows agree with those of one orbit at a time, and on any number of
# threads with themselves.
printf 'model swing\nparam k > 0\ndefault k = 1\nstate x\nstate v\nstate u\neq x = v\neq v = -k*x^3\neq u = x - u\n' > swing.tt
grid=(--section v=0 --grid x=0.5:1:3,u=-1:1:3 --returns 3 --direction down)
expect 0 '^8,3,' jellett section ./swing.tt "${grid[@]}" --method gauss
grep -v '^#' out > single
JELLETT_LANES=2 jellett section ./swing.tt "${grid[@]}" | grep -v '^#' > narrow
for threads in 1 2; do
    expect 0 '^8,3,' jellett section ./swing.tt "${grid[@]}" --threads $threads
    grep -v '^#' out > batch.$threads
done
cmp -s batch.1 batch.2 || fail "batches of an own table hang on the number of threads"
for other in narrow batch.1; do
    paste -d, single $other | awk -F, -v OFMT=%g '
        NR > 1 { for (i = 3; i < 6; i++) { d = $i - $(i + 6); if (d*d > 1e-20) bad++ } n++ }
        END { exit !(n == 36 && !bad) }' || fail "batches of an own table ($other) disagree with its single orbits"
done

# Claims that lead to other tables are verified against those that lie beside it, whatever their names.
mkdir renamed
for table in "$JLT_SOURCE_DIR"/codegen/models/spherical_top*.tt; do
    sed -E 's/spherical_top/egg/g; s/\<gamma3\>/tilt/g' "$table" > "renamed/egg${table##*/spherical_top}"
done
expect 0 "37 of 37 proved" jellett verify renamed/egg.tt
sed -i '/^eq v_nu =/a \    v_nu +' renamed/egg_level.tt
expect 1 "not settled reduction   level|refuted     reduction   level" jellett verify renamed/egg.tt

# Whatever follows many orbits has the same kernels.
objects() { find cache -name '*.so' | wc -l; }
printf 'model oval\nstate x\nstate v\neq x = v\neq v = -x - x^3\nintegral E = v^2/2 + x^2/2 + x^4/4\n' > oval.tt
expect 0 '^3,2,' jellett section ./oval.tt --section v=0 --grid x=0.5:1:4 --returns 2
before=$(objects)
for command in "orbits --period 1" "lyapunov --returns 2" "fates --returns 2" "separation --cells x=-2:2:9 --returns 2" \
    "transfer"; do
    jellett $command ./oval.tt --section v=0 --grid x=0.5:1:4 > out 2>&1
    [ "$(objects)" -eq "$before" ] || fail "$command has other kernels than section"
done

# What is wrong with a grid as typed is said before anything is compiled.
for command in "transfer --boxes" "separation --cells" "section --grid" "fates --grid" "lyapunov --grid" "orbits --grid"; do
    # shellcheck disable=SC2086
    expect 3 "'4y4' is no whole number from 1 to 1000000000" env XDG_CACHE_HOME="$PWD/unused" \
        jellett ${command% *} ./oval.tt --section v=0 ${command#* } 4y4
done
[ ! -e unused ] || fail "a table is compiled for a grid that is none"

# A section's own table that lacks a parameter of the model is told which record to write.
printf 'model ring\nparam c\nstate x\nstate v\nstate y\neq x = v\neq v = -x\neq y = 1 - c*y\n'\
'section level : by ring_section.tt at y = 0 with x = x, v = v\n' > ring.tt
printf 'model ring_section\nstate x\nstate v\nlift into ring.tt with x = x, v = v, y = 0\n' > ring_section.tt
expect 3 "the parameter c of ring is missing in ring_section: write 'param c' there" ttc prove ring.tt
# So is one that lacks an angle, and one whose angle has an interval.
printf 'model lean\nstate th\nstate v\nangle c s = cos(th) sin(th)\ndomain up : 3 + c*s - s^3 > 0\neq th = v\neq v = c\n'\
'section level : by lean_section.tt at v = 0 with th = th\n'\
'section bound : by lean_bound.tt at v = 0 with th = atan2(s, c)\n' > lean.tt
printf 'model lean_section\nstate th\nlift into lean.tt with th = th, v = 0\n' > lean_section.tt
printf 'model lean_bound\nstate th in (-3, 3)\nangle c s = cos(th) sin(th)\nlift into lean.tt with th = th, v = 0\n' > lean_bound.tt
expect 3 "expected a record 'angle C S = cos.*sin.*' for it there" ttc prove lean.tt
grep -q "its record 'state th' in lean_bound.tt must have no interval" err || fail "an interval of an angle: $(cat err)"

# One text under two names: another table embeds itself into each, and into one of them wrongly.
printf 'model pace\nparam k\nstate y\neq y = k\nreduction same : by slow.tt with y = y\n' | tee one.tt > two.tt
printf 'model slow\nparam k\nstate y\neq y = k\nembedding a : into one.tt with y = y\n'\
'embedding b : into two.tt with y = 2*y\n' > slow.tt
expect 0 '"proved": true' jellett models ./one.tt --json
expect 0 '"proved": false' jellett models ./two.tt --json

# What is not proved is not gone back to, nor mirrored by; of several reversors the section takes one that has its fixed points on
# it.
printf 'model bad\nstate x\nstate y\nstate z\neq x = y\neq y = -x\neq z = x\n - z\nintegral Z = z\nreversor y -> -y\n' > bad.tt
expect 3 "Z is not proved to be an integral" jellett section ./bad.tt --project --section y=0 --start x=1,z=1 --start x=2,z=1
expect 3 "Z is not proved to be an integral" jellett simulate ./bad.tt --project --start x=1,y=0,z=1 --times 1
expect 3 "a reversor" jellett separation ./bad.tt --section y=0 --grid x=1:2:2,z=1:2:2 --cells x=-3:3:4,z=-3:3:4 --returns 2 \
    --settle 0
printf 'model gyre\nstate x\nstate y\nstate z\neq x = y*z\neq y = -2*x*z\neq z = x*y\nreversor x -> -x\nreversor y -> -y\n'\
'reversor z -> -z\n' > gyre.tt
for section in x:y:z y:x:z z:x:y; do
    IFS=: read -r state a b <<< "$section"
    expect 0 '^2,' jellett separation ./gyre.tt --section "$state=0" --grid "$a=1:2:2,$b=1:2:2" --cells "$a=-3:3:4,$b=-3:3:4" \
        --returns 2 --settle 0
done
printf 'model odd\nparam k\ndefault k = 1\nstate x\nstate y\nstate z\nstate w\neq x = y\neq y = -x\neq z = w\neq w = -z\n'\
'integral P = k*x*w\n - k*z*y\nreversor y -> -y, w -> -w\n' > odd.tt
for k in 1 1e-12 1e12; do
    expect 3 "a reversor" jellett separation ./odd.tt --set k=$k --section y=0 --level P=$k --solve x=1 --grid z=1:2:2,w=1:2:2 \
        --cells z=-3:3:4,w=-3:3:4 --returns 2 --settle 0
done

# Several at once, and after a run that was killed at any time, the object is whole.
rm -rf cache
for i in 1 2 3; do jellett simulate ./lorenz.tt --start x=1,y=1,z=20 --times 1 > "said.$i" 2>&1 & done
wait
for i in 1 2 3; do grep -q '^1,-4.40912038921' "said.$i" || fail "of several runs at once one fails: $(head -c 300 "said.$i")"; done
rm -rf cache
{ for delay in 0.02 0.1 0.2 0.4; do timeout -s KILL $delay ttc build lorenz.tt; done; } > /dev/null 2>&1
expect 0 '^1,-4.40912038921' jellett simulate ./lorenz.tt --start x=1,y=1,z=20 --times 1
left() { find cache -name '*.part*'; }
[ -z "$(left)" ] || fail "work of a killed run stays"
# Killed as soon as the object is there.
for round in 1 2 3 4 5; do
    rm -rf cache
    ttc build lorenz.tt > /dev/null &
    until [ -n "$(compgen -G 'cache/jellett/*.so')" ] || ! kill -0 $! 2> /dev/null; do :; done
    kill -KILL $! 2> /dev/null
    wait $! 2> /dev/null
    [ -z "$(left)" ] || fail "in round $round work stays beside the object that it made"
done

# Nothing is loaded from where others may write; without a compiler there is a clear word; as on a full or closed folder.
chmod g+w cache/jellett
expect 5 "not yours alone" jellett simulate ./lorenz.tt --start x=1,y=1,z=20 --times 1
chmod g-w cache/jellett
object=$(find cache -name '*.so')
chmod o+w "$object"
expect 0 '^1,-4.40912038921' jellett simulate ./lorenz.tt --start x=1,y=1,z=20 --times 1
[ "$(stat -c %a "$object")" = 700 ] || fail "an object that others could write to was used"
# What is cut short, or has another byte, is made anew.
for damage in 'truncate -s -4096' 'truncate -s 4096' 'truncate -s 0' \
    "sh -c 'printf x | dd of=\"\$0\" seek=9000 bs=1 conv=notrunc 2>&1'"; do
    eval "$damage" '"$object"' > /dev/null
    expect 0 '^1,-4.40912038921' jellett simulate ./lorenz.tt --start x=1,y=1,z=20 --times 1
done
# Where a sealed object cannot be loaded, as from a disk that may hold no programs, the loader's reason is told.
cp "$object" whole
python3 - "$object" << 'END'
import hashlib, os, sys
key, text = os.path.basename(sys.argv[1])[:-3], b"no object" * 1000
open(sys.argv[1], "wb").write(text + hashlib.sha256(text + key.encode()).hexdigest().encode())
END
expect 5 "of ./lorenz.tt cannot be loaded: .*invalid ELF header" jellett simulate ./lorenz.tt --start x=1,y=1,z=20 --times 1
cp whole "$object"
# What has the name of another object is made anew.
printf '%s\n' 'model decay' 'state x' 'state y' 'state z' 'eq x = -x' 'eq y = -y' 'eq z = -z' > decay.tt
ttc build decay.tt > "$scratch/other" && cp "$(cat "$scratch/other")" "$object"
expect 0 '^1,-4.40912038921' jellett simulate ./lorenz.tt --start x=1,y=1,z=20 --times 1
# An empty part of PATH, also the last one, is this folder.
printf '#!/bin/sh\nexec cc "$@"\n' > here-cc && chmod +x here-cc
expect 0 '^1,' env CC=here-cc PATH="$PATH:" jellett simulate ./lorenz.tt --start x=1,y=1,z=20 --times 1
expect 5 "no C compiler 'absent-cc'" env CC=absent-cc jellett simulate ./toda.tt --start q1=0,q2=0,q3=0,p1=0,p2=0,p3=0 --times 1
XDG_CACHE_HOME="$PWD/two"$'\n'lines jellett simulate ./toda.tt --start q1=0,q2=0,q3=0,p1=0,p2=0,p3=0 --until 1 > out 2> log ||
    fail "a cache in a folder of two lines: $(cat log)"
expect 5 "cannot make the cache" env XDG_CACHE_HOME=/dev/null jellett simulate ./toda.tt --start q1=0,q2=0,q3=0,p1=0,p2=0,p3=0 \
    --times 1

mkdir -p barred/jellett/lock-{{0..9},{a..f}}
chmod 700 barred/jellett
expect 5 "cannot lock the cache $PWD/barred/jellett: .*XDG_CACHE_HOME names another" env XDG_CACHE_HOME="$PWD/barred" \
    jellett simulate ./toda.tt --start q1=0,q2=0,q3=0,p1=0,p2=0,p3=0 --times 1

# A table is read, and nothing is written where it lies.
expect 5 '^absent/my.tt: error: cannot open the file' jellett simulate absent/my.tt --start x=1 --times 1

# What is claimed under a condition is told with it, where nothing else is to be followed.
printf '%s\n' 'model swing' 'param c >= 0' 'default c = 0' 'state x' 'state v' 'eq x = v' 'eq v = -x - c*v' \
    'integral E = x^2 + v^2 when c = 0' > swing.tt
expect 3 "E is an integral where c = 0, and is followed there in a 'variant' that sets this" \
    jellett drift ./swing.tt --section v=0 --start x=1
expect 0 "E is an integral where c = 0; its drift has a column there once a 'variant' sets this" \
    jellett simulate ./swing.tt --start x=1,v=0 --times 1
echo 'variant free : c = 0' >> swing.tt
expect 0 'drift_E' jellett simulate ./swing.tt --start x=1,v=0 --times 1
expect 0 '' jellett simulate ./swing.tt --start x=1,v=0 --times 1 --set c=1
[ ! -s err ] || fail "simulate speaks of an integral that a variant follows: $(cat err)"

# What is claimed on a zero level alone has no condition to tell.
printf '%s\n' 'model level' 'state x' 'state v' 'eq x = v' 'eq v = -v' 'invariant rest = v' 'integral X = x modulo rest' > level.tt
expect 0 "X is an integral on zero levels of other claims alone" jellett simulate ./level.tt --start x=1,v=0 --times 1
printf '%s\n' 'model level' 'param c' 'default c = 0' 'state x' 'state v' 'eq x = v' 'eq v = c - v' \
    'invariant rest = v when c = 0' 'integral X = x when c = 0 modulo rest' 'variant calm : c = 0' > level.tt
expect 0 "X is an integral where c = 0; .* unless it holds on zero levels of other claims alone" \
    jellett simulate ./level.tt --start x=1,v=0 --times 1

# Every integral has its column, as those of a body with its attitude, which has ten. Gauss's method keeps squares to rounding.
{
    printf '%s\n' 'model ten' 'state x' 'state y' 'eq x = y' 'eq y = -x'
    for i in {1..10}; do echo "integral I$i = $i*(x^2 + y^2)"; done
} > ten.tt
expect 0 '^t,x,y(,drift_I[0-9]+){10},fate$' jellett simulate ./ten.tt --start x=1,y=0 --times 1
awk -F, '/^1,/ { for (i = 4; i <= 13; i++) bad += !($i != "" && $i < 1e-14) } END { exit !(NF == 14 && !bad) }' out ||
    fail "ten integrals drift: $(tail -1 out)"

# Hundreds of parameters and integrals: 299 springs are one of 0.299. Oracle: scipy's DOP853 for x'' = -x - 0.299 x^3 - k1 x'.
{
    printf '%s\n' 'model many' 'state x' 'state v'
    for i in {1..300}; do echo "param k$i"; done
    printf '%s\n' 'variant free : k1 = 0' 'equilibria rest : x = 0, v = 0' 'eq x = v' 'eq v = -x - k1*v'
    for i in {2..300}; do echo " - k$i*x^3"; done
    echo 'integral E = v^2/2 + x^2/2'
    for i in {2..300}; do echo " + k$i*x^4/4"; done
    echo ' when k1 = 0'
    for i in {1..300}; do echo "default k$i = 1/1000"; done
} > many.tt
expect 0 '^1,0.43777324025' jellett simulate ./many.tt --start x=1,v=0 --times 1
expect 0 '^1,0.43758976000' jellett simulate ./many.tt --start x=1,v=0 --times 1 --set k1=0
grep -q '"variant":"free"' out || fail "a variant of 300 parameters does not serve: $(tail -1 out)"
expect 0 '^family *rest' jellett eigen ./many.tt
expect 0 'checks hold, 0 fail' jellett verify ./many.tt --samples 4
{
    printf '%s\n' 'model kept' 'state x' 'state v' 'state u' 'eq x = v' 'eq v = -x' 'eq u = 0*u'
    for i in {1..300}; do echo "integral I$i = $i*(x^2 + v^2)"; done
} > kept.tt
expect 0 '^1,0.5403023058681' jellett simulate ./kept.tt --start x=1,v=0,u=1 --times 1
expect 3 "levels are served of tables with up to 64" jellett section ./kept.tt --section v=0 --level I1=1 --solve x=1 --start u=1

# Names of 63 characters run along axes, as the language has them.
name=angular_velocity_about_the_axis_of_the_largest_moment_of_inerti
stiff=stiffness_${name#??????????}
printf '%s\n' 'model names' "param $stiff" "default $stiff = 1" "state $name" 'state y' "eq $name = y" \
    "eq y = -$stiff*$name" > names.tt
expect 0 '^0,1,6.28318530717' jellett section ./names.tt --section y=0 --direction down --start $name=1 --returns 1
expect 0 '^1,0,1,6.28318530717' \
    jellett section ./names.tt --section y=0 --direction down --grid $name=1:2:1 --sweep $stiff=1:4:2 --returns 1

# More states than densities are looked for in, and more densities than are compared: none of them is said to hold.
{ echo 'model long'; for i in {1..65}; do echo "state x$i"; done; for i in {1..65}; do echo "eq x$i = -x$i"; done; } > long.tt
expect 3 "long has 65 states; measure serves up to 64" jellett measure ./long.tt
expect 0 "not computed: densities are compared in tables of up to 64 states" jellett verify ./long.tt
{
    printf '%s\n' 'model many' 'state x' 'state y' 'eq x = y' 'eq y = -x'
    for i in {1..65}; do echo "measure m$i = $i + x^2"; done
} > many.tt
expect 3 "many has 65 densities; measure serves up to 64" jellett measure ./many.tt
expect 1 "not computed: densities are compared in tables of up to 64 states" jellett verify ./many.tt

# A table is read once, and its warnings come once.
sed -e 's/^param c .*/&\nparam unused/' -e 's/^default .*/&, unused = 0/' swing.tt > warned.tt
expect 0 alive jellett simulate ./warned.tt --start x=1,v=0 --times 1
[ "$(grep -c "'unused' is never used" err)" -eq 1 ] || fail "a warning comes twice: $(cat err)"

# However many names are wrong, the first of them is told.
expect 3 "the section has no coordinate 'foo'" jellett drift --start eta=0.1,gamma3=-0.6,foo=1,bar=2

# More states than eigenvalues of equilibria are looked for in.
{
    echo 'model chain'
    for i in {1..33}; do echo "state x$i"; done
    for i in {1..33}; do echo "eq x$i = -x$i"; done
    echo "equilibria rest : x1 = 0$(printf ', x%d = 0' {2..33})"
} > chain.tt
expect 3 "chain has 33 states; verify serves up to 32" jellett verify ./chain.tt
expect 3 "chain has 33 states; eigen serves up to 32" jellett eigen ./chain.tt

# As many as there may be: 16 equal masses between walls, joined by springs, swing with 2 sin(k pi/34).
{
    echo 'model masses'
    for i in {0..17}; do [ $i -eq 0 ] || [ $i -eq 17 ] || printf 'state q%d\nstate p%d\n' $i $i; done
    for i in {1..16}; do
        printf 'eq q%d = p%d\neq p%d = -2*q%d' $i $i $i $i
        [ $i -eq 1 ] || printf ' + q%d' $((i - 1))
        [ $i -eq 16 ] || printf ' + q%d' $((i + 1))
        echo
    done
} > masses.tt
expect 0 '^verdict *centre' jellett eigen ./masses.tt
awk '/eigenvalues, with/ { on = 1; next } /other routes/ { on = 0 } on && $2 ~ /^[+]/ { k++; omega = 2*sin(k*atan2(0, -1)/34)
        bad += $1 != 0 || (substr($2, 2) - omega)^2 > 1e-30 } END { exit !(k == 16 && !bad) }' out ||
    fail "sixteen masses: $(grep -A34 'eigenvalues, with' out)"

# Densities are compared at parameters of the domain: e < 1, and H > 0, as no state has y^2 < H otherwise.
printf '%s\n' 'model eccentric' 'param e >= 0' 'state v' 'state E' 'angle c s = cos(E) sin(E)' 'domain ellipse : 1 - e > 0' \
    'eq v = c' 'eq E = 1/(1 - e*c)' 'measure kepler = 1 - e*c' > eccentric.tt
printf '%s\n' 'model well' 'param H' 'state y' 'state w' 'domain inside : H - y^2 > 0' 'eq y = w*(H - y^2)' 'eq w = 1' \
    'measure inside = 1/(H - y^2)' > well.tt
for table in eccentric well; do
    for seed in 1 2 3 4 5; do expect 0 "checks hold, 0 fail" jellett verify ./$table.tt --seed $seed; done
done
# Families and densities are compared elsewhere where the defaults lie outside the domain, of which ttc warns.
sed 's/^default.*/&\ndomain near : 1\/2 - a > 0/' "$JLT_SOURCE_DIR/codegen/models/chaplygin_sleigh.tt" > outside.tt
expect 0 "the defaults lie outside the domain" ttc check outside.tt
expect 0 "checks hold, 0 fail" jellett verify ./outside.tt

# Newton's method fails numerically also where it leaves a state's interval.
printf 'model never\nstate x in (0, inf)\neq x = 1 + 1/x^2\n' > never.tt
expect 4 "finds no equilibrium" jellett eigen ./never.tt --at x=1/2 --find

# An orbit that falls into a centre has no return; a section with too many coordinates names what leaves fewer.
printf '%s\n' 'model plunge' 'state r' 'state p' 'state q' 'eq r = p' 'eq p = -1/r^2' 'eq q = 1 - q' > plunge.tt
expect 4 "runs into a singularity, or hardly ever meets the section" jellett lyapunov ./plunge.tt --section q=-2 --start r=1,p=0
expect 3 "need a section of two coordinates, not of 3: --level and --solve leave fewer" \
    jellett manifolds restricted_three_body --section y=0 --start x=0.5,vx=0,vy=1

# That ttc was killed is all that is said, also of a scene.
printf 'model = "./plunge.tt";\ncompute = ( { what = "eigen"; } );\n' > killed.scene
XDG_CACHE_HOME=$scratch/cache_of_killed jellett run killed.scene > out 2> err &
run=$!
for wait in $(seq 100); do pkill -KILL -P $run ttc && break; sleep 0.02; done
wait $run
[ $? -eq 4 ] && [ "$(cat err)" = "jellett: ttc was ended by signal 9" ] || fail "of a scene's ttc that was killed: $(cat err)"
exit $status
