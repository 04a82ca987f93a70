#!/usr/bin/env bash
# Densities of tables of one's own: a field that keeps volume by terms that cancel, and densities along angles.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
expect() { # STATUS WORDS COMMAND...
    local want=$1 words=$2 code
    shift 2
    "$@" > out 2> err < /dev/null
    code=$?
    [ $code -eq "$want" ] || fail "$*: status $code, not $want: $(head -c 300 err)"
    grep -qE -- "$words" out err || fail "$*: '$words' is in neither '$(head -c 600 out)' nor '$(head -c 300 err)'"
}

# Two equal pendulums, one below the other, in angles and momenta: Liouville's theorem, by derivatives that cancel to rounding.
cat > liouville.tt <<'TABLE'
model liouville
param g >= 0
default g = 1
state a
state b
state p
state q
angle ca sa = cos(a) sin(a)
angle cb sb = cos(b) sin(b)
angle cd sd = cos(a - b) sin(a - b)
let den = 2 - cd^2
let u = (p - cd*q)/den
let w = (2*q - cd*p)/den
eq a = u
eq b = w
eq p =
    - u*w*sd
    - 2*g*sa
eq q =
    + u*w*sd
    - g*sb
measure volume = 1
TABLE
expect 0 'checks hold, 0 fail' jellett verify ./liouville.tt
expect 0 'density volume: .div\(rho f\). is at most [0-9.]*e-1[5-9] of its terms' jellett measure ./liouville.tt
# A density that is none is seen all the same: with u damped the divergence is -1/10.
sed -e 's/^    - u.w.sd$/&\n    - p\/10/' liouville.tt > damped.tt
expect 1 'div\(rho f\) of the table.s density: [0-9.]*(e-0[1-4])? of its terms, bound 1e-09: FAILS' jellett verify ./damped.tt

# Where a parameter stops a state, every function of it is a density, and none is wrong.
printf '%s\n' 'model stopped' 'param a' 'default a = 1' 'state x in (0, inf)' 'state y' 'eq x = a*x*y' 'eq y = x - 1' \
    'measure inverse = 1/x' > stopped.tt
expect 0 'against the closed form inverse: largest relative difference [0-9.]*(e-1[4-9])? ' jellett measure ./stopped.tt
expect 0 'density inverse: .div\(rho f\). is at most 0 of its terms' jellett measure ./stopped.tt --set a=0

# The divergence of a forced oscillator is -delta, so exp(delta phi/w) grows with the phase. Over a turn of 2 pi that is
# exp(pi/2) = 4.81048 at delta = 1/4: a density of the unrolled phase, but not of the angle that the table says it is.
cat > forced.tt <<'TABLE'
model forced
param delta >= 0
default delta = 1/4
state x
state v
state phi
angle c s = cos(phi) sin(phi)
eq x = v
eq v =
    - delta*v
    - x^3
    + c
eq phi = 1
TABLE
expect 0 '^ +-2 +0.6065306597126' jellett measure ./forced.tt
echo 'periodic phi = 2*pi' >> forced.tt
expect 0 'it changes by the factor 4.81048 in a period of phi, so it is no density of an angle' jellett measure ./forced.tt
grep -q '^ *-2 ' out && fail "a density of an angle is shown: $(cat out)"
expect 0 '"turn": 4.8104' jellett measure ./forced.tt --json
expect 0 '^ +-2 +1$' jellett measure ./forced.tt --set delta=0
# At a rate of 2 + cos it is 1/(2 + cos), which is the same after a turn.
sed -i -e 's/^eq phi = 1$/eq phi = 2 + c/' -e 's/- delta.v/- 0*v/' forced.tt
expect 0 '^ +0 +1$' jellett measure ./forced.tt

# The domain ends before the range that is tabulated: rho = exp(-x)/x from div f = 1 + x, x' = x, normed in the middle.
for inside in 'domain inside : c^2 - (x - 5/4)^2 > 0' 'state x in (5/4 - c, 5/4 + c)'; do
    state='state x'
    [ "${inside%% *}" = domain ] || state=
    printf 'model edged\nparam c\ndefault c = 3/4\n%s\n%s\nstate y\neq x = x\neq y = x*y\n' "$state" "$inside" > edged.tt
    expect 0 'density of x alone' jellett measure ./edged.tt
    awk '/in the middle/ { reads = 1; next }
         reads && NF == 2 { x[++n] = $1; rho[n] = $2 }
         END { m = x[int(n/2) + 1]; bad = n < 10 || x[1] > 0.52 || x[n] < 1.98
               for (i = 1; i <= n; i++) { off = rho[i]/(exp(m - x[i])*m/x[i]) - 1; if (off*off > 1e-20) bad = 1 }
               exit bad }' out || fail "measure of a domain that ends: $(tail -3 out)"
done

# However narrow an interval is whose ends are parameters: rho = 1/(1 + x^2), which at 1e-9 is 1 to all digits.
printf 'model narrow\nparam a > 0\nstate x in (-a, a)\nstate y\neq x = (1 + x^2)*y\neq y = 1\n' > narrow.tt
for a in 2 1 1e-9 1e-100; do
    expect 0 'density of x alone' jellett measure ./narrow.tt --set a=$a
    awk -v a=$a '/in the middle/ { reads = 1; next }
         reads && NF == 2 { x[++n] = $1; rho[n] = $2 }
         END { bad = n < 10 || x[1] > -0.97*a || x[n] < 0.97*a
               for (i = 1; i <= n; i++) { off = rho[i]*(1 + x[i]^2) - 1; if (off*off > 1e-20) bad = 1 }
               exit bad }' out || fail "measure in an interval of $a: $(tail -3 out)"
done
# A sweep has the table of each point behind its value.
expect 0 '^1,x,0[.]' jellett measure ./narrow.tt --sweep a=1:2:2 --points 5
for a in 1 2; do
    jellett measure ./narrow.tt --csv --points 5 --set a=$a | grep '^x,' | sed "s/^/$a,/" | cmp -s - <(grep "^$a," out) ||
        fail "the sweep of measure differs at a = $a"
done
# Rows tell on which state the density depends, which may change from point to point: of y where p = 0, of x where p = 1.
printf '%s\n' 'model turned' 'param p' 'state x in (-2, 2)' 'state y in (-2, 2)' 'eq x = p*(1 + x^2)*y + 1 - p' \
    'eq y = (1 - p)*(1 + y^2)*x + p' > turned.tt
expect 0 '^p,along,at,density,' jellett measure ./turned.tt --sweep p=0:1:2 --points 5
awk -F, '/^[01],/ { off = $4*(1 + $3^2) - 1; good += $2 == ($1 ? "x" : "y") && off*off < 1e-20 } END { exit good != 10 }' out ||
    fail "a density of x, then of y: $(cat out)"
# Where x^2 is lost that is said; it is no pole of the density.
for a in 1e-150 1e-160 1e-300; do expect 4 'use units in which parameters' jellett measure ./narrow.tt --set a=$a; done
# A sweep without any row ends with 4 if one of its points does, and with 3 only where each refuses its input.
expect 4 'at a=-1:' jellett measure ./narrow.tt --sweep a=-1:1e-160:2
expect 3 'at a=-2:' jellett measure ./narrow.tt --sweep a=-1:-2:2

# At a = p the density 1/(1 - y) is invariant. The trace of the equilibrium x = a^(1/2), a - p, is then zero but for the rounding
# of x.
cat > rounded.tt <<'TABLE'
model rounded
param a > 0
param p > 0
default a = 3, p = 3
state x
state y in (-10, 1/2)
root w = sqrt(a)
eq x = y
eq y =
    + (x^2 - p)*y
    - (x^2 - a)
equilibria right : x = w, y = 0
trace right = a - p
obstructs right
TABLE
expect 0 'density of y alone' jellett measure ./rounded.tt
! grep obstruction out || fail "a density is there: $(tail -2 out)"
expect 0 'the trace is 1 .error < .*, so no invariant measure' jellett measure ./rounded.tt --set p=2
# A family that excludes densities behind others whose conditions hold as well: states that are not named follow from the family to
# which the others belong, and from none that is refuted.
cat > behind.tt << 'TABLE'
model behind
param a
default a = 1
state v
state w
state z
eq v = a*w^2 + (z - 1)*v
eq w = -a*v*w
eq z = z*(z - 1)*(z - 2)
equilibria high : v = 0, w = 0, z = 2
equilibria straight : w = 0, z = 1
obstructs straight
TABLE
expect 0 '^the trace is [^ ]* \(exactly\), so no invariant measure' jellett measure ./behind.tt
grep -q '^obstruction: at the equilibrium v=[^ ]* w=0 z=1$' out || fail "not on the family: $(grep obstruction out)"
expect 0 '^state  *v=2 w=0 z=1$' jellett eigen ./behind.tt --at v=2
expect 0 '^state  *v=0 w=0 z=2$' jellett eigen ./behind.tt --at z=2
expect 0 '^0,0,1,' jellett eigen ./behind.tt --at w=0 --sweep v=0:2:3
grep -q '^2,0,1,' out || fail "a sweep leaves its family: $(cat out)"
sed '/^obstructs/d; s/w = 0, z = 1/w = 1, z = 1/' behind.tt > broken.tt
expect 3 'residual 2, .*; the family straight is refuted, and gives none' jellett eigen ./broken.tt --at v=2
# What a family excludes is told of claims that are proved: this one keeps areas.
for claim in 'trace rest = 0' 'obstructs rest'; do
    printf '%s\n' 'model turning' 'state x' 'state y' 'eq x = y' 'eq y = -x' 'equilibria rest : x = 0, y = 0' "$claim" > turning.tt
    expect 0 '^    rest' jellett models ./turning.tt
    ! grep 'excludes' out || fail "models, of a claim that is not proved"
done
# A density that is refuted is none, however little it fails by: here by 1e-12 of the terms, and by less than their rounding.
for small in 1e-12 1e-40; do
    printf '%s\n' 'model nearly' 'state x' 'state y' 'eq x = (1+x^2)*(y+2*x*y)' \
        "eq y = -(1+x^2)*(2*x+y^2) + $small*x^2*y^3" 'measure rho = 1/(1+x^2)' > nearly.tt
    expect 1 'not invariant, by less than random states show: its claim is refuted: .*x.*y' jellett measure ./nearly.tt
    grep -q 'density rho: .*random states; its claim is refuted$' out || fail "not said of the density: $(grep rho: out)"
done
# Where div f/f_q is a function of each of two states, a density that is smooth and positive is told before one that is not: one of
# v has a pole at v = 0; that of th, by d ln rho/d th = sin th, is exp(1 - cos th), and that of x is (2 - x)^-4, 1 in the middle.
printf '%s\n' 'model two_densities' 'state th' 'state v' 'angle c s = cos(th) sin(th)' 'eq th = v' 'eq v = -s*v^2/2' \
    'periodic th = 2*pi' > two_densities.tt
expect 0 '^ +-2 +4[.]1212101112050' jellett measure ./two_densities.tt --points 5
printf '%s\n' 'model two_densities' 'state x in (-inf, 2)' 'state v' 'eq x = v*(2 - x)' 'eq v = -3*v^2/2' > two_densities.tt
expect 0 '^ +0[.]95 +14[.]529753549' jellett measure ./two_densities.tt --points 5
# A density that hardly varies, 1/(1 + q^2/10^6): quadratures know it to 1e-19, the doubles printed no better than rounding.
printf '%s\n' 'model gentle' 'state q in (-2, 5)' 'state p' 'eq q = p*(1 + q^2/1000000)' 'eq p = -q*(1 + q^2/1000000)' > gentle.tt
expect 0 '^q,4[.]93,0[.]99997794563' jellett measure ./gentle.tt --csv
awk -F, '/^q,/ { n++; d = $3*(1 + $2^2/1e6)/(1 + 1.5^2/1e6) - 1; bad += $2 != 1.5 && !($4 > 1e-16 && d^2 <= ($4 + 3e-16)^2) }
    END { exit !(n == 41 && !bad) }' out || fail "errors below rounding: $(grep '^q,' out | head -2)"
exit $status
