#!/usr/bin/env bash
# What `jellett eigen` proves of an equilibrium of one's own table, and what it says not to be settled. Each table is made so that
# one reason alone can serve. Oracle: eigenvalues by hand, beside each.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
says() { # TEXT ARGUMENT...: this line, blanks pressed together
    local text=$1
    shift
    jellett eigen "$@" 2>&1 | tr -s ' ' | grep -xF -- "$text" > /dev/null ||
        fail "$*: not '$text', but: $(jellett eigen "$@" 2>&1 | tail -8)"
}

# At q = 2^(1/2), p = 0: lambda^2 = -2 q. That the entry u + v is zero there, no ball tells; the reversor does.
cat > even.tt <<'END'
model even
state q
state p
let u = p + q
let v = p - q
eq q =
    + p
eq p =
    + 2
    + u*v
reversor p -> -p
END
sed '/reversor/d; s/model even/model odd/' even.tt > odd.tt
says 'verdict centre' even.tt --at q=1.4 --find
says 'verdict not settled at 6144 bits' odd.tt --at q=1.4 --find
says 'verdict unstable' odd.tt --at q=-1.4 --find

# c moves as p does, so that rows of the Jacobian are the same: that both are zero where one is, the integral tells.
cat > carried.tt <<'END'
model carried
state q
state p
state c
eq q =
    + p
    - q
eq p =
    + 2
    - p^2
eq c =
    + 2
    - p^2
integral C = c - p
END
sed '/integral/d; s/model carried/model loose/' carried.tt > loose.tt
says 'verdict stable' carried.tt --at q=1.4,p=1.4,c=1 --find
says 'verdict not settled at 6144 bits' loose.tt --at q=1.4,p=1.4,c=1 --find

# -1 twice, with one eigenvector or two, and -2. Of the point 2^(1/2) there is no exact number, so that -2 2^(1/2) twice is not
# told from a pair close together; both decay.
cat > multiple.tt <<'END'
model multiple
param k
default k = 1
state x
state y
state z
eq x =
    - x
    + k*y
eq y =
    - y
eq z =
    - 2*z
END
says ' -1 exactly, condition infinite: defective' multiple.tt
says ' -2 exactly, condition 1' multiple.tt
says ' -1 exactly, condition not defined' multiple.tt --set k=0
says ' -1 exactly, condition infinite: defective' multiple.tt --fast
says ' -1 exactly, condition not defined' multiple.tt --set k=0 --fast
says 'verdict stable' multiple.tt
cat > alike.tt <<'END'
model alike
state q1
state q2
eq q1 =
    + 2
    - q1^2
eq q2 =
    + 2
    - q2^2
END
says ' -2.8284271247461903 error < 2e-16, condition not defined' alike.tt --at q1=1.4,q2=1.4 --find
says 'verdict stable' alike.tt --at q1=1.4,q2=1.4 --find
# K is an integral where a = b. These differ by 1e-80, which no double tells: zero is an eigenvalue by M alone, and what is nearly
# zero is well-conditioned: its eigenvectors are (0, 1, 0) and (1, 1, 0) to 80 digits.
cat > close.tt <<'END'
model close
param a
param b
default a = 1, b = 1
variant same : b = a
state x
state y
state z
eq x =
    - x
eq y =
    + x
    + a*y
    - b*y
eq z =
    + x
integral K = x + y when b = a
integral M = x + z
END
b=0.$(printf '%080d' 0 | tr 0 9)
says ' 0 exactly by the integral K' close.tt
says 'verdict stable' close.tt
says ' 0 exactly by the integral M' close.tt --set b=$b
says ' 9.9999999999999996e-81 error < 3.9e-97, condition 1.41' close.tt --set b=$b
says 'verdict unstable' close.tt --set b=$b

# What follows for the motion itself. r' = a r^3 around a linear centre: no eigenvalue tells whether it attracts. With a mirror it
# is a centre, as is the minimum of q^4, of which the linearization, p alone, says nothing. x' = x^2 hides behind zero, unless an
# integral that is proved makes it zero: K = x is none.
cat > focus.tt <<'END'
model focus
param a
default a = 1
state x
state y
eq x =
    - y
    + a*x*(x^2 + y^2)
eq y =
    + x
    + a*y*(x^2 + y^2)
END
says 'verdict centre' focus.tt
says 'motion not settled by the linearization' focus.tt
says 'measure the trace is zero, and excludes no invariant measure' focus.tt --set a=-1
says 'motion stable' even.tt --at q=1.4 --find
says 'motion not settled by the linearization' odd.tt --at q=1.4 --find
says 'motion unstable' odd.tt --at q=-1.4 --find
cat > quartic.tt <<'END'
model quartic
state q
state p
eq q =
    + p
eq p =
    - q^3
reversor p -> -p
END
says 'verdict unstable' quartic.tt
says 'motion not settled by the linearization' quartic.tt
cat > hidden.tt <<'END'
model hidden
param k
default k = 1
state x
state y
eq x =
    + k*x^2
eq y =
    - y
integral K = x
integral L = x when k = 0
variant still : k = 0
END
says 'verdict stable' hidden.tt
says 'motion not settled by the linearization' hidden.tt
says ' 0 exactly, condition not defined' hidden.tt
says 'motion stable' hidden.tt --set k=0
says 'motion stable' carried.tt --at q=1.4,p=1.4,c=1 --find
says 'motion asymptotically stable' multiple.tt
says 'motion not settled by the linearization' multiple.tt --fast
# A positive real part far below the digits of the imaginary part.
printf '%s\n' 'model slow' 'state x' 'state y' 'eq x = 1e-30*x - y/3 + x^3' 'eq y = x/3 + 1e-30*y' > slow.tt
says 'motion unstable' slow.tt
# A mirror that leaves y, which is not zero, says nothing of the pair.
printf '%s\n' 'model beside' 'state x' 'state y' 'eq x = 1 - y' 'eq y = x + x^3*(1 - y)' 'reversor x -> -x' > beside.tt
says 'motion stable' beside.tt --at y=1

# x and y at 2^(1/2), lambda^2 = -2 x twice and the oscillators coupled one way: eigenvalues on the axis without eigenvectors.
cat > resonant.tt <<'END'
model resonant
state x
state p
state y
state q
eq x =
    + p
eq p =
    + 2
    - x^2
eq y =
    + q
eq q =
    + 2
    - y^2
    + x^2 - 2
reversor p -> -p, q -> -q
END
says 'verdict not settled at 53 bits' resonant.tt --at x=1.4,y=2 --find
jellett eigen resonant.tt --at x=1.4,y=2 --find --digits 20 > out 2> err
code=$?
[ $code -eq 4 ] && [ ! -s out ] && grep -q 'too close together' err || fail "--digits: status $code, says '$(cat err)'"

# x' > 0 everywhere, though by doubles 2^(1/2) is at rest: there is a density, exp(-3 t)/x' with the time t since x = 0. So the
# trace, 3 at y = 0, excludes nothing; and no more digits of it are given than the place where x' nearly vanishes has.
printf '%s\n' 'model passed' 'param p > 0' 'default p = 1e-31' 'state x' 'state y' 'eq x = (x^2 - 2)^2 + p' 'eq y = 3*y' > passed.tt
nothing='measure the trace is not zero here, but that an equilibrium with such a trace exists is not proved: nothing follows'
says "$nothing" passed.tt --at x=1.4142135623730951
says "$nothing" passed.tt --at x=1.4142135623730951 --fast
says ' 0 or near it, condition not defined' passed.tt --at x=1.4142135623730951
says 'trace 3' passed.tt --at x=1.4142135623730951 --digits 30
says ' 3 condition 1' passed.tt --at x=1.4142135623730951 --digits 30

# y/x is an integral that has no value at the node: it says nothing there, and the field is what it is.
printf '%s\n' 'model node' 'state x' 'state y' 'eq x = -x' 'eq y = -y' 'integral slope = y/x' \
    'equilibria rest : x = 0, y = 0' > node.tt
says 'verdict stable' node.tt --at x=0,y=0
jellett verify node.tt > out 2>&1 || fail "jellett verify node.tt: $(cat out)"

# A formula whose claim is refuted is shown as that, beside the value.
printf '%s\n' 'model doubted' 'param k > 0' 'default k = 2' 'state x' 'state y' 'eq x = y - k*x' 'eq y = -y' \
    'equilibria rest : x = 0, y = 0' '  trace rest = -k' '  charpoly rest = lambda^2 + (k + 1)*lambda + k' > doubted.tt
says 'trace -3, exactly; formula -2, a refuted claim' doubted.tt --at x=0,y=0
says ' lambda^1 3 formula 3' doubted.tt --at x=0,y=0

# Where |x| has no derivative the field has a value, and its Jacobian has none.
printf '%s\n' 'model bent' 'state x' 'root r = sqrt(x^2)' 'eq x = -r' > bent.tt
jellett eigen bent.tt --at x=0 > out 2> err && fail "a Jacobian at the bend of |x|: $(cat out)"
grep -q 'the field or its Jacobian divides here by what is 0' err || fail "at the bend of |x|: $(tail -1 err)"

# A disc that rolls upright, th = pi/2, at the rate w: eigenvalues 0, 0, +-sqrt(4/5 - 12/5 w^2) (by hand). No exact number is at
# hand there; that zero is semisimple follows from where the matrix is zero.
cat > disc.tt << 'TABLE'
model disc
state th in (0, 3)
state p
state v
state w
angle c s = cos(th) sin(th)
eq th = p
eq p = v^2*c/s/5 + 6/5*v*w - 4/5*c
eq v = -2*w*p - v*p*c/s
eq w = -2/3*v*p
TABLE
says 'verdict centre' disc.tt --at th=pi/2,p=0,v=0,w=1
says ' 0 +1.2649110640673518i error < 3.2e-17, condition 1.54' disc.tt --at th=pi/2,p=0,v=0,w=1
says 'verdict unstable' disc.tt --at th=pi/2,p=0,v=0,w=0.3
# A positive eigenvalue needs no word on the kind of zero: +-2 cos(1), 0, 0, where one zero is by the integral, one by the reversor.
printf '%s\n' 'model twins' 'param a' 'default a = 1' 'angle c s = cos(a) sin(a)' 'state x' 'state X' 'state y' 'state Y' \
    'eq x = c*(y + Y)' 'eq X = c*(y + Y)' 'eq y = c*(x + X)' 'eq Y = c*(x + X)' 'integral D = x - X' 'reversor y -> -y, Y -> -Y' \
    > twins.tt
says 'verdict unstable' twins.tt --at x=0,X=0,y=0,Y=0

# At x = 1/10 two equilibria meet: (x - 1/10)^2 = 0 exactly, where doubles leave 2e-18 and the slope is 0. Beside it there is none.
printf '%s\n' 'model fold' 'param mu' 'default mu = 0' 'state x' 'eq x = x^2 - x/5 + 1/100 + mu' > fold.tt
says ' 0 exactly, condition not defined' fold.tt --at x=0.1
jellett eigen fold.tt --at x=0.1 --sweep mu=0:1e-30:2 > out 2> err
cut -d, -f1,10 out | tail -2 | diff - <(printf '%s\n' 0,centre 1e-30,refused) > diff || fail "beside a fold: $(cat diff err)"
# Nor beside (x - r)^2 (x - s) = 0 with r < s, where doubles leave no field, or slopes that are rounding alone.
tangent() { printf '%s\n' 'model tangent' 'param mu' 'state x' "eq x = x^3 - ($2)*x^2 + ($3)*x - ($4) + mu" > tangent.tt
    jellett eigen tangent.tt --at x="$1" --sweep mu=-1e-30:0:2 > out 2> err
    cut -d, -f1,10 out | tail -2 | diff - <(printf '%s\n' -1e-30,refused 0,centre) > diff || fail "beside $1: $(cat diff err)"; }
tangent 3/10 13/10 51/100 63/1000
says 'verdict not settled at 53 bits' tangent.tt --at x=0.35 --set mu=0 --find
tangent 1/10 38/15 143/300 7/300
tangent 7/10 37/10 371/100 1127/1000
# A positive eigenvalue decides, also where no ball tells whether another is zero, cos(a)^2 + sin(a)^2 - 1; a negative one does not.
printf '%s\n' 'model hidden' 'param a' 'default a = 1' 'angle C S = cos(a) sin(a)' 'state x' 'state y' \
    'eq x = x' 'eq y = (C^2 + S^2 - 1)*y + x^2' > hidden.tt
says 'verdict unstable' hidden.tt --at x=0,y=0
says 'motion unstable' hidden.tt --at x=0,y=0
sed 's/eq x = x/eq x = -x/' hidden.tt > hiding.tt
says 'verdict not settled at 6144 bits' hiding.tt --at x=0,y=0
exit $status
