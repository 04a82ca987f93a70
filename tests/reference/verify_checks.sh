#!/usr/bin/env bash
# `jellett verify` makes every comparison it speaks of, at every point. The sleigh has 2 states, so that a point gives 2 numbers of
# the field, 4 of a Jacobian, 1 divergence; 1 integral, and 2 more where it is balanced, as the last of 5 points of the domain are,
# which are compared with the kernels of both fields; a jet gives 2 numbers, stages those of the field with t, 3, and with the
# variational equations 8; and on its family there are 1 gradient, 2 coefficients and 2 eigenvalues.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
samples=5
cat > "$scratch/expected" << 'END'
12 generated field in ball enclosures of 256 bits
36 fused field and Jacobian in ball enclosures of 256 bits
8 integrals in ball enclosures of 256 bits
16 integrals' gradients in ball enclosures of 256 bits
24 generated Jacobian in ball enclosures of 256 bits
6 generated divergence in ball enclosures of 256 bits
12 jets of order 1 in ball enclosures of 256 bits
66 stages on vectors in ball enclosures of 256 bits
END
while IFS='|' read -r each name; do echo "$((each * samples)) $name"; done >> "$scratch/expected" << 'END'
2|field on the family, which is zero
4|generated Jacobian in ball enclosures of 256 bits
4|fused field and Jacobian in ball enclosures of 256 bits
1|generated divergence in ball enclosures of 256 bits
1|table's trace in ball enclosures of 256 bits
1|generated divergence against the table's trace
4|table's matrix in ball enclosures of 256 bits
4|generated Jacobian against the table's matrix
4|generated Jacobian against complex-step differentiation
2|integrals' gradients in ball enclosures of 256 bits
2|integrals' gradients as left null vectors
2|characteristic polynomial, Faddeev-LeVerrier against the table's
2|eigenvalues against the characteristic polynomial
END
jellett verify --json --samples=$samples chaplygin_sleigh |
    jq -r '.. | objects | select(has("numbers")) | "\(.numbers) \(.name)"' > "$scratch/made"
diff "$scratch/expected" "$scratch/made"

# Certificates are points of the table's domain: of intervals on both sides and on one, with numbers and parameters as ends, and of
# a condition that no small numbers for k meet.
export XDG_CACHE_HOME=$scratch/cache
cat > "$scratch/inside.tt" << 'END'
model inside
param a > 0
param k > 0
default a = 1, k = 3
state x in (2, 3)
state z in (-a, 2*a)
state w in (-inf, -4)
state y
domain near : k - x > 0
eq x = y*x
eq y = y*(x - 1)*w
eq z = y
eq w = -y
equilibria rest : y = 0
trace rest = (x - 1)*w
obstructs rest
END
jellett verify --json --samples=$samples "$scratch/inside.tt" |
    jq -r '.. | objects | select(has("point")) | .point' > "$scratch/made"
[ "$(wc -l < "$scratch/made")" = 3 ]
python3 - "$scratch/made" << 'END'
import fractions, sys
for line in open(sys.argv[1]):
    p = {name: fractions.Fraction(value) for name, value in (each.split(" = ") for each in line.strip().split(", "))}
    assert 2 < p["x"] < 3 and -p["a"] < p["z"] < 2*p["a"] and p["w"] < -4 and p["k"] > p["x"], line
END

# With functions the field is zero by balls without width, sin(0) = 0 and cos(0) = 1; the point is rational, the trace need not be.
# No rational point is a state pi: that there is no certificate is no failure.
cat > "$scratch/swing.tt" << 'END'
model swing
param c > 0
default c = 1/3
state q
state v
angle C S = cos(q) sin(q)
exp e = exp(c)
eq q = v
eq v = -S - c*e*v*C
equilibria down : q = 0, v = 0
trace down = -c*e
obstructs down
equilibria up : q = pi, v = 0
trace up = c*e
obstructs up
END
jellett verify --samples=$samples "$scratch/swing.tt" > "$scratch/made"
[ "$(grep -c 'f = 0 exactly; trace = irrational' "$scratch/made")" = 3 ]
[ "$(grep -c 'zero excluded: holds' "$scratch/made")" = 3 ]
grep -q 'up: no rational point of the domain was found where f = 0 exactly: no certificate' "$scratch/made"

# A family that excludes a measure where c = 0 says nothing of c = 1, where exp(-e x) is a density; nor does one out of range of the
# density that is found.
cat > "$scratch/elsewhere.tt" << 'END'
model elsewhere
param c
param e > 0
default c = 1, e = 1/3
state x
state y
eq x = c + y*(1 - c)
eq y = e*y - x*(1 - c^2)
equilibria rest : y = 0, x = 0 when c = 0
trace rest = e
obstructs rest
END
cat > "$scratch/beyond.tt" << 'END'
model beyond
state x
eq x = x - 7
equilibria rest : x = 7
trace rest = 1
obstructs rest
END
for table in elsewhere beyond; do
    jellett verify --samples=$samples "$scratch/$table.tt" > "$scratch/said" || { cat "$scratch/said"; exit 1; }
    grep -q 'density of x alone' "$scratch/said"
done

# A family of one point is certified at it once.
grep -c 'rest at x = 7$' "$scratch/said" | grep -qx 1 || { echo "one point, again:"; grep 'rest at' "$scratch/said"; exit 1; }

# Where parameters are of extreme sizes a field may vary over a length that is tiny beside 1, as over b sqrt(c)/a^2 here: a complex
# step must be far below it.
cat > "$scratch/steep.tt" << 'END'
model steep
param a > 0
param b > 0
param c > 0
state x
state y
eq x = y
eq y = -x/(c + (a^2*x/b)^2)
equilibria rest : x = 0, y = 0
trace rest = 0
END
jellett verify --seed=2 "$scratch/steep.tt" > "$scratch/said" || { cat "$scratch/said"; exit 1; }

# A kernel that is wrong off the families alone is found, here by a compiler that reads -x for x in the product of two.
cat > "$scratch/cubic.tt" << 'END'
model cubic
param c
default c = 1/3
state x
state y
eq x = y
eq y = -x - c*x^3
equilibria rest : x = 0, y = 0
trace rest = 0
END
printf '%s\n' '#!/bin/bash' 'for name; do case $name in *.c) sed -i "s/= x\[0\]\*x\[0\];/= -x[0]*x[0];/" "$name" ;; esac; done' \
    'exec cc "$@"' > "$scratch/wrong"
chmod +x "$scratch/wrong"
jellett verify --samples=$samples "$scratch/cubic.tt" > "$scratch/said" || { cat "$scratch/said"; exit 1; }
code=0
CC=$scratch/wrong jellett verify --samples=$samples "$scratch/cubic.tt" > "$scratch/said" 2> "$scratch/err" || code=$?
[ $code = 1 ] && grep -q 'generated field .* FAILS$' "$scratch/said" ||
    { echo "status $code:"; cat "$scratch/said" "$scratch/err"; exit 1; }

# So is one that is wrong on vectors alone.
printf '%s\n' '#!/bin/bash' \
    'for name; do case $name in */batch_*.c) sed -i "s/x0\*x0/-x0*x0/" "${name%/*}"/*_lanes.inc ;; esac; done' 'exec cc "$@"' \
    > "$scratch/wrong"
code=0
CC=$scratch/wrong XDG_CACHE_HOME=$scratch/other jellett verify --samples=$samples "$scratch/cubic.tt" > "$scratch/said" || code=$?
[ $code = 1 ] && [ "$(grep FAILS "$scratch/said" | cut -c5-10)" = stages ] ||
    { echo "status $code:"; cat "$scratch/said"; exit 1; }

# So is a Jacobian that is wrong in another time alone, by a lifted root, with the field or without it.
cat > "$scratch/turning.tt" << 'END'
model turning
param a > 0
state x in (-1, 1)
state y
root s = sqrt(1 - x^2)
eq x = s*y
eq y = -a*x*y^3/s
time regular : s lifting s
END
jellett verify --samples=$samples "$scratch/turning.tt" > "$scratch/said" || { cat "$scratch/said"; exit 1; }
for entry in 2 5; do
    printf '%s\n' '#!/bin/bash' 'for name; do case $name in */general_in_regular.c)' \
        "sed -i 's/out\[$entry\] = t$entry;/out[$entry] = -t$entry;/' \"\$name\" ;; esac; done" 'exec cc "$@"' > "$scratch/wrong"
    code=0
    CC=$scratch/wrong XDG_CACHE_HOME=$scratch/$entry jellett verify --samples=$samples "$scratch/turning.tt" > "$scratch/said" ||
        code=$?
    [ $code = 1 ] && [ "$(grep FAILS "$scratch/said" | cut -c5-13)" = Jacobians ] ||
        { echo "entry $entry: status $code:"; cat "$scratch/said"; exit 1; }
done

# An integral that is refuted forces no eigenvalue to be zero.
printf '%s\n' 'model decays' 'param a > 0' 'param b > 0' 'state x' 'state y' 'eq x = -(a + b)*x + b*y' 'eq y = -b*y + b*x' \
    'integral wrong = x + y + x^2' 'equilibria rest : x = 0, y = 0' > "$scratch/decays.tt"
code=0
jellett verify "$scratch/decays.tt" > "$scratch/said" 2> "$scratch/err" || code=$?
[ $code = 1 ] && ! grep 'eigenvalues .* FAILS$' "$scratch/said" ||
    { echo "status $code:"; cat "$scratch/said" "$scratch/err"; exit 1; }
