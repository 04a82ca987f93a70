#!/usr/bin/env bash
# Which record of another table leads back: of several the one that names this table's file, else the first that gives all states.
# And what a reader is told: of a parameter that the other table has not, its name and a value.
source "$JLT_SOURCE_DIR/tests/scratch.sh"

verdict() { # VERDICT KIND NAME TABLE
    ttc prove "$4" > out 2> /dev/null
    grep -qE "^$1 +$2 +$3\$" out || fail "$4: $2 $3 is not $1: $(cat out)"
}

printf 'model small\nstate y\neq y = 1\nembedding first : into other.tt with x = -y\n'\
'embedding second : into large.tt with x = y\n' > small.tt
printf 'model large\nstate x\neq x = 1\nreduction plain : by small.tt with y = x\nreduction reversed : by small.tt with y = -x\n' \
    > large.tt
printf 'model other\nstate x\neq x = -1\nreduction plain : by small.tt with y = x\nreduction reversed : by small.tt with y = -x\n' \
    > other.tt
verdict proved reduction plain large.tt
verdict refuted reduction reversed large.tt
verdict refuted reduction plain other.tt
verdict proved reduction reversed other.tt
# Under another name: the first.
sed 's/^model large/model copy/' large.tt > copy.tt
verdict refuted reduction plain copy.tt
printf 'model tall\nstate u\nstate v\neq u = -1\neq v = v\nreduction first : onto other.tt with x = u\n'\
'reduction second : onto large.tt with x = -u\n' > tall.tt
printf 'lift up : into tall.tt with u = -x, v = 0\n' >> large.tt
printf 'lift up : into tall.tt with u = x, v = 0\n' >> other.tt
verdict proved lift up large.tt
verdict proved lift up other.tt

# Of a coordinate that is an atan2 nothing is known but its cosine and sine: it is told what to write where more is used.
printf 'model round\nstate q\nangle c s = cos(q) sin(q)\nlift into wheel.tt with q = q, z = 0\n' > round.tt
printf 'model wheel\nstate q\nstate z\nangle c s = cos(q) sin(q)\neq q = 1\neq z = 2 + c\nperiodic q = 2*pi\n'\
'section top : by round.tt at z = 0 with q = atan2(s, c)\n' > wheel.tt
verdict 'not settled' section top wheel.tt
expect 3 'given by an atan2 is used by itself .*that state in place of the atan2' ttc prove wheel.tt
sed -i 's/atan2(s, c)/q/' wheel.tt
verdict proved section top wheel.tt

# The project's tables, of which a copy may be made under any name.
cp "$JLT_SOURCE_DIR"/codegen/models/spherical_top*.tt .
mv spherical_top.tt my_top.tt
for way in "reduction level" "reduction momentum" "lift track" "lift full"; do
    # shellcheck disable=SC2086
    verdict proved $way my_top.tt
done
# With friction no level serves any more, whatever lifts say of where to begin.
sed -i -e 's/^param a3 /param mu >= 0\n&/' -e 's/^    + m\*R\*e\*I3\*omega3\*omega_tau\/Theta$/&\n    - mu*omega_n/' my_top.tt
verdict refuted reduction level my_top.tt
verdict refuted reduction momentum my_top.tt
verdict proved lift full my_top.tt

printf 'model resting\nstate y\neq y = 0*y\nembedding all : into pulled.tt with x = y\n' > resting.tt
printf 'model pulled\nparam g >= 0\nstate x\neq x = g\nreduction rest : by resting.tt with y = x\n' > pulled.tt
ttc prove pulled.tt 2> /dev/null > out
grep -q 'field of pulled in x = -g$' out && grep -q 'false at y = 1, g = 1$' out ||
    fail "the free parameter is not told: $(cat out)"
exit $status
