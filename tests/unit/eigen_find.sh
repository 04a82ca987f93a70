#!/usr/bin/env bash
# `jellett eigen --find` holds the states that were given, the first ones longest, and moves the others. Oracle: with a3 = 0 the
# equilibria are omega_tau = omega_n = 0, everything else free.
set -uo pipefail
status=0
awk() { LC_ALL=C command awk "$@"; } # numbers have points in any locale
finds() { # GIVEN WORDS: states that are found
    local state
    state=$(jellett eigen --set a3=0 --find --at "$1" | grep '^state ')
    for word in $2; do [[ " $state " == *" $word "* ]] || { echo "--at $1: $state, not $word"; status=1; }; done
}
finds gamma3=0.3,v_nu=0.7,omega3=1.1 "gamma3=0.3 v_nu=0.7 omega_tau=0 omega_n=0 omega3=1.1"
finds gamma3=0.3,v_nu=0.7,omega3=1.1,omega_tau=0.2,omega_n=0.1 "gamma3=0.3 v_nu=0.7 omega3=1.1"
finds v_nu=0.5,omega3=1.1,gamma3=0.25,omega_n=0.3 "gamma3=0.25 v_nu=0.5 omega3=1.1"

# A state that a sweep runs over is held before those of --at, which may not give it. Oracle: omega_n^2 = 3 (1 - gamma3^2) on the
# precessions with a3 = 0.01.
jellett eigen --set a3=0.01 --find --at omega3=1.1,v_nu=0.7 --sweep gamma3=0.1:0.5:3 2>&1 | grep -v '^#' | cut -d, -f1,4 | awk -F, '
    NR > 1 { rows += ($1 - (2*NR - 3)/10)^2 < 1e-30 && ($2^2/(3*(1 - $1^2)) - 1)^2 < 1e-28 } END { exit rows != 3 }' ||
    { echo "--find does not hold the state of --sweep"; status=1; }
said=$(jellett eigen --set a3=0 --at gamma3=0.3,v_nu=0.7 --sweep gamma3=0.1:0.5:3 2>&1)
[[ $? -eq 2 && $said == *"--at: --sweep gives gamma3"* ]] || { echo "one state by --at and --sweep: $said"; status=1; }

# States in units of their own are found as well. Oracle: x = y = sqrt(72), z = 27 in these units.
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export XDG_CACHE_HOME=$scratch
printf '%s\n' 'model convection' 'param X > 0' 'param Y > 0' 'param Z > 0' 'state x' 'state y' 'state z' 'eq x = 10*X*y/Y - 10*x' \
    'eq y = 28*Y*x/X - Y*x*z/(X*Z) - y' 'eq z = Z*x*y/(X*Y) - 8*z/3' > "$scratch/convection.tt"
convection() { # X Y Z: the units
    awk "BEGIN { printf \"x=%.17g,y=%.17g,z=%.17g\", 8*$1, 8*$2, 26*$3 }" > "$scratch/guess"
    jellett eigen "$scratch/convection.tt" --set "X=$1,Y=$2,Z=$3" --at "$(cat "$scratch/guess")" --find > "$scratch/out" 2>&1
    grep '^state ' "$scratch/out" | tr '=' ' ' | awk "
        function near(a, b) { return (a/b - 1)^2 < 1e-28 }
        { exit !near(\$3, sqrt(72)*$1) || !near(\$5, sqrt(72)*$2) || !near(\$7, 27*$3) } END { if (NR == 0) exit 1 }" ||
        { echo "units $*: $(head -3 "$scratch/out"), from $(cat "$scratch/guess")"; status=1; }
}
convection 1 1 1
convection 1024 1/1024 32
convection 1 1 1048576
convection 1/1073741824 1 1073741824

# And so are those of stiff motions.
printf '%s\n' 'model stiff' 'state x' 'state y' 'eq x = 1e12*(1 - x)' 'eq y = 3 - y' > "$scratch/stiff.tt"
jellett eigen "$scratch/stiff.tt" --at x=0,y=0 --find 2>&1 | grep -q '^state  *x=1 y=3$' ||
    { echo "stiff: no equilibrium"; status=1; }

# A state that is periods away from a family lies on it, and the formulas are those of the family's point. Oracle: the trace is -b.
printf '%s\n' 'model pendulum' 'param b >= 0' 'default b = 1/8' 'state th' 'state w' 'angle c s = cos(th) sin(th)' 'eq th = w' \
    'eq w = - s - b*w' 'periodic th = 2*pi' 'equilibria down : th = 0, w = 0' 'trace down = th - b' \
    'equilibria up : th = pi, w = 0' 'trace up = -b' > "$scratch/pendulum.tt"
sed '/^periodic/d' "$scratch/pendulum.tt" > "$scratch/line.tt"
on() { # FAMILY FORMULA TABLE OPTION...
    jellett eigen "$scratch/$3.tt" "${@:4}" > "$scratch/out" 2>&1
    grep -q "^family  *$1\$" "$scratch/out" && [ "$(sed -n 's/^trace.*formula //p' "$scratch/out")" = "$2" ] ||
        { echo "${*:3}: not $1 with $2: $(grep -E '^family|^trace|jellett' "$scratch/out")"; status=1; }
}
for turned in 0 2*pi -4*pi; do on down -0.125 pendulum --at "th=$turned"; done
for turned in pi 3*pi -pi; do on up -0.125 pendulum --at "th=$turned"; done
on down -0.125 pendulum --at th=6.2 --find
on 'none of the table' '' line --at 'th=2*pi'
# Where the digits of a state do not tell by how many periods it is away, nothing is said of its family.
on up -0.125 pendulum --at 'th=200001*pi'
on 'none of the table' '' pendulum --at th=62831853071.795

# A state far from zero is no equilibrium because one is near beside its size: slopes must stay what they are as far. Oracle:
# sin(3e13) = -0.770; 31415926535897.93 is pi*1e13 to its last digit. Exactly: x = k and k + 1 alone, of two roots close together.
printf '%s\n' 'model pair' 'param k' 'default k = 1e13' 'state x' 'eq x = (x - k)*(x - k - 1)' > "$scratch/pair.tt"
is() { # STATUS TABLE STATE: of `eigen` at this state
    jellett eigen "$scratch/$2.tt" --at "$3" > "$scratch/out" 2>&1
    local code=$?
    [ $code -eq "$1" ] || { echo "$2 at $3: status $code, not $1: $(grep -E '^residual|^jellett' "$scratch/out")"; status=1; }
}
for far in 3e13 -3e13 3e14 1e300; do is 3 pendulum "th=$far"; done
for far in 31415926535897.93 -31415926535897.93 3.14159265358979 314159265358.979; do is 0 pendulum "th=$far"; done
for there in 1e13 10000000000001; do is 0 pair "x=$there"; done
for beside in 10000000000000.5 10000000000005 9999999999998; do is 3 pair "x=$beside"; done
exit $status
