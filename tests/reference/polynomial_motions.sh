#!/usr/bin/env bash
# Motions that are polynomials in time: errors limit no step then, and crossings that are near each other lie far within one. By
# every method, alone and in lanes of every width, they are at the polynomial's zeros.
source "$JLT_SOURCE_DIR/tests/scratch.sh"

# x = t (t - a) (t - b) (t - c), and its derivatives at 0.
cat > quartic.tt << 'T'
model quartic
state x
state y
state z
state w
state u
eq x = y
eq y = z
eq z = w
eq w = u
eq u = 0
T
# A B C DIRECTION TOLERANCE OPTION...: the returns. There x errs by the rounding of y, which is a b c at most, in some twenty steps
# of up to c by sums whose weights are up to 100; and by the tolerance, in lanes by 64 of it.
zeros_are() {
    local a=$1 b=$2 c=$3 direction=$4 tolerance=$5 start zeros="$1 $2 $3"
    [ "$direction" = both ] || zeros=$b
    shift 5
    start=$(awk -v a="$a" -v b="$b" -v c="$c" \
        'BEGIN { printf "y=%.17g,z=%.17g,w=%.17g,u=24", -a*b*c, 2*(a*b + b*c + c*a), -6*(a + b + c) }')
    jellett section ./quartic.tt --section x=0 --direction "$direction" --start "$start" --tol "$tolerance" "$@" > rows.csv 2> err
    awk -F, -v a="$a" -v b="$b" -v c="$c" -v tolerance="$tolerance" -v zeros="$zeros" '
        /^0,[1-9]/ { n++; off = ($3 - zero[n])*$4; if (off*off > allowed*allowed) bad = 1 }
        BEGIN { count = split(zeros, zero, " "); allowed = 64*tolerance + 2000*2.2e-16*a*b*c*c }
        END { exit n != count || bad }' rows.csv ||
        fail "$a $b $c, $direction, $*: $(grep '^0,' rows.csv | cut -d, -f2,3,8 | tr '\n' ' ') $(cat err)"
}
for place in '0.5 0.75 2' '39 41.5 42' '139 141.5 142'; do
    # shellcheck disable=SC2086 # three zeros
    for method in gauss dop853 taylor rk8pd rkf45 msadams; do
        zeros_are $place both 1e-12 --returns 3 --method $method
        zeros_are $place down 1e-12 --returns 1 --method $method
    done
    for lanes in 2 4 8; do
        for tolerance in 1e-6 1e-9 1e-12 1e-15; do
            JELLETT_LANES=$lanes zeros_are $place both $tolerance --returns 3 --start y=1,z=1,w=1,u=1
            JELLETT_LANES=$lanes zeros_are $place down $tolerance --returns 1 --start y=1,z=1,w=1,u=1
        done
    done
done

# Where t^4 passes what doubles hold, it has not come back to 0.
for method in gauss dop853 taylor; do
    jellett section ./quartic.tt --section x=0 --direction both --start y=1,z=1,w=1,u=24 --returns 2 --method $method \
        > rows.csv 2> err
    [ $? -eq 4 ] && [ "$(grep -c '^0,' rows.csv)" -eq 2 ] && grep -q 'nonfinite$' rows.csv || fail "$method: $(cat rows.csv err)"
done

# Rates at both ends of a step may be finite where their sum is not: x = exp(-t), on its way to the largest double.
printf '%s\n' 'model grown' 'state x' 'state z' 'state w' 'eq x = -x' 'eq z = w' 'eq w = -z' > grown.tt
jellett simulate ./grown.tt --start x=1,z=0,w=1 --times=-709.4,-800 --method gauss > rows.csv 2> err
[ $? -eq 4 ] &&
    awk -F, '/^-709.4,/ { off = $2/1.2260423e308 - 1; n = off*off < 1e-12 } END { exit !(n && /nonfinite$/) }' rows.csv ||
    fail "exp(-t): $(tail -2 rows.csv) $(cat err)"
exit $status
