#!/usr/bin/env bash
# What generate, cost and prove --kernels cannot do they say with FILE:LINE:COLUMN and the true cause; in JSON a table that is
# wrong is an object with its problems, in every command that speaks JSON.
source "$JLT_SOURCE_DIR/tests/scratch.sh"

expect() { # STATUS WORDS COMMAND...
    local want=$1 words=$2 code
    shift 2
    "$@" > out 2> err
    code=$?
    [ $code -eq "$want" ] || fail "$*: status $code, not $want"
    [ -z "$words" ] || grep -qE -- "$words" err || fail "$*: says '$(head -2 err)', not '$words'"
}

printf 'model wide\nstate x\neq x =\n    + x\n    - 1e500*x^2\n' > wide.tt
expect 3 '^wide.tt:5:5: error: a number is beyond double precision' ttc generate --out folder wide.tt
printf 'model tiny\nparam k\nstate x\nlet h = 1e-400*k + x\neq x = h\n' > tiny.tt
expect 3 '^tiny.tt:4:5: error: a number is beyond double precision' ttc generate --out folder tiny.tt
# Of a number near 1 neither numerator nor denominator matters.
printf 'model near\nparam k\nstate x\neq x = ((10^30 + 1)/(10^30 + 3))^12*k*x\n' > near.tt
expect 0 '' ttc generate --out near near.tt
grep -q 'double t0 = 0x1p+0\*params\[0\]' near/near/general.c || fail "a number near 1 is written otherwise"
printf 'model twice\nparam k\nstate x\neq x = k*x\nvariant general : k = 1\n' > twice.tt
expect 3 "^twice.tt:5:9: error: 'twice/general.c' would be written twice" ttc generate --out folder twice.tt
printf 'model ends\nstate x in (inf, 0)\nstate y in (0, 2*inf)\nstate z in (0, oo)\neq x = x\neq y = y\neq z = z\n' > ends.tt
expect 3 "^ends.tt:2:13: error: no number is above it \(expected '-inf' as the lower end\)" ttc check ends.tt
expect 3 "^ends.tt:3:18: error: unknown name 'inf' \(expected 'inf' or '-inf', alone, as an end of" ttc check ends.tt
expect 3 "^ends.tt:4:16: error: unknown name 'oo' \(expected 'inf' or '-inf', alone, as an end of" ttc check ends.tt
# A derivative whose powers pass the limit of the graph, 256.
printf 'model power\nstate x\nlet a = x^64\nlet b = a^4\neq x = b*x\ntime u : 1/(1 + x^2)\n' > power.tt
for command in "generate --out folder" cost "prove --kernels"; do
    # shellcheck disable=SC2086
    expect 3 '^power.tt:[0-9]+:[0-9]+: error: .*power passes 256' ttc $command power.tt
done
[ ! -e folder ] || fail "files are written"

# A name that only counts as a number, which the unit of an observed quantity may be, as may rad.
printf 'model units\nparam k [kgg/s^2]\nstate x [m1*(rad/metre)]\nstate y [1/(kg^-2 m)]\neq x = k*x\neq y = 0\n' > units.tt
echo 'observe e = x [J]' >> units.tt
for warned in "2:7: warning: 'kgg' in the unit of k counts" "3:7: warning: 'm1' in" "3:7: warning: 'metre' in the unit of x"; do
    expect 0 "^units.tt:$warned" ttc check units.tt
done
grep -q 'warnings: 3$' out || fail "units: $(cat out err)"
printf 'model units\nstate x [(m/s)^2]\neq x = -x\n' > units.tt
expect 0 '' ttc check units.tt
grep -q 'warnings: 0$' out || fail "units in parentheses: $(cat out err)"

# pi is rounded, as 1/3 is: where it cancels, digits are lost.
printf 'model near_pi\nstate x\nstate y\neq x = (x - pi)*y\neq y = -x\n' > near_pi.tt
expect 0 '' ttc generate --unproved --out near near_pi.tt
grep -q 'digits are lost where terms nearly cancel in x - pi' near/near_pi/general.c || fail "x - pi is said to keep its digits"

# Units that are too deep, or whose exponents are too large, have no dimension; no kernel then may be scaled with them.
printf 'model units\nparam k > 0 [1/s]\nstate x [%s]\neq x = -k*x\n' "$(printf '(%.0s' {1..200000})m" > units.tt
expect 0 '' ttc generate --unproved --out folder units.tt
printf 'model units\nparam k > 0 [1/s]\nstate x [(((m^64)^64)^64)^16]\nstate y\neq x = k*y\neq y = -k*x\n' > units.tt
expect 0 '' ttc generate --unproved --out folder units.tt
! grep -rq 'scales = 1' folder || fail "units of exponents that wrap count as numbers"
for power in 65 -9223372036854775808; do # the latter has no absolute value in a long
    printf 'model units\nparam k > 0 [1/s]\nstate x [m^%s]\nstate y\neq x = k*y\neq y = -k*x\n' "$power" > units.tt
    expect 0 '' ttc generate --unproved --out folder units.tt
    ! grep -rq 'scales = 1' folder || fail "m^$power counts as a number"
done
rm -r folder

# A table of coordinates alone; beside its model's it is passed over.
printf 'model points\nparam E\nstate q\ndomain inside : E > 0\nroot r = sqrt(2*E)\nlift into moves.tt with q = q, x = 0, u = r\n' \
    > points.tt
printf 'model moves\nstate q\nstate x\nstate u\neq q = u\neq x = u\neq u = 0*u\nintegral E = u^2/2\n' > moves.tt
printf 'section cut : by points.tt at x = 0 with q = q, E = E\n' >> moves.tt
for command in "generate --out folder" cost build; do
    # shellcheck disable=SC2086
    expect 3 '^points.tt:6:1: error: the coordinates of a section have no kernels of their own .expected moves.tt' ttc $command \
        points.tt
done
# An integral's bare name means a level, which no coordinate is.
sed '9s/q = q/q = E/' moves.tt > moves_bare.tt
expect 3 "^moves_bare.tt:9:9: .* q of points.tt is given by an integral's bare name.*in parentheses" ttc prove moves_bare.tt
expect 0 '' ttc generate --out folder points.tt moves.tt
grep -q '\.chart = "points"' folder/moves/general.c || fail "the kernels of a model lack those of its section"
[ ! -e folder/points ] || fail "a table of coordinates has kernels"
rm -r folder
expect 0 '' ttc cost points.tt moves.tt
expect 0 '' ttc prove --kernels points.tt moves.tt

# A way that is not proved is told with its place; its kernels are written all the same, as those of a table that is right.
printf 'model small\nstate x\neq x = x\nembedding all : into large.tt with x = x, y = 0\n' > small.tt
printf 'model large\nstate x\nstate y\neq x = x\neq y = y\ntier both "the whole"\nreduction zero : by small.tt with x = x\n' > \
    large.tt
sed '7s/x = x$/x = x, x = y/' large.tt > large_twice.tt
expect 3 "^large_twice.tt:7:42: error: 'x' is set twice" ttc check large_twice.tt
sed '6s/both/both while y/' large.tt > large_tier.tt
expect 3 "^large_tier.tt:6:19: error: unexpected text in quotes .expected '>' after the expression" ttc check large_tier.tt
sed '6s/"the whole"//' large.tt > large_name.tt
expect 3 '^large_name.tt:6:10: error: the record ends too early .expected a text in quotes' ttc check large_name.tt
for how in "" --unproved; do
    expect 0 "^large.tt:7:11: warning: the reduction claim 'zero' is refuted: small.tt and this table no longer serve" \
        ttc generate $how --out folder large.tt small.tt
done
grep -q '\.kind = "reduction"' folder/large/general.c || fail "the kernels of a table lack those of its way"
grep -q '"reduction", "zero", "", JLT_REFUTED' folder/large/table.c || fail "the verdict on a way is not with its table"
rm -r folder

# What is wrong with a table that a claim leads to is said with its own place, also when kernels are there already.
printf 'model points\nparam E\nstate q\ndomain inside : E > 0\nroot r = sqrt(2*E)\n'\
'lift into moves.tt with q = q +* 2, x = 0, u = r\n' > points.tt
printf 'model still\nstate q\neq z = q\n' > still.tt
printf 'reduction at_rest : onto still.tt with q = u\n' >> moves.tt
export XDG_CACHE_HOME=$scratch/cache
expect 3 'coordinates points.tt could not be read: points.tt:6:32: unexpected' ttc prove moves.tt
expect 3 'target still.tt could not be read: still.tt:2:7: ' ttc prove moves.tt
expect 1 'coordinates points.tt could not be read: points.tt:6:32: unexpected' ttc generate --out folder moves.tt
for turn in first second; do
    expect 3 'coordinates points.tt could not be read: ./points.tt:6:32: unexpected' jellett simulate ./moves.tt --start q=0 \
        --times 1
    expect 3 'target still.tt could not be read: ./still.tt:2:7: ' jellett simulate ./moves.tt --start q=0 --times 1
done
expect 3 '' ttc prove --json moves.tt
jq -e 'tostring | contains("points.tt:6:32: ")' out > /dev/null ||
    fail "prove --json does not say where the other table is wrong"

printf 'model broken\nstate x\neq x = y\n' > broken.tt
for command in check prove cost; do
    expect 3 '' ttc $command --json broken.tt
    jq -e 'if type == "array" then .[0] else . end
        | .file == "broken.tt" and .ok == false and (.problems | length) == 1
          and (.problems[0] | [.file, .line, .column, .severity] == ["broken.tt", 3, 8, "error"]
               and (.message | contains("unknown name \u0027y\u0027")))' out > /dev/null ||
                   fail "$command --json does not say what is wrong"
    expect 5 '' ttc $command --json missing.tt
    jq -e 'if type == "array" then .[0] else . end | .problems[0].message | contains("cannot open")' out > /dev/null ||
        fail "$command --json does not say that the file is missing"
done

# A root that a point needs has no name that a quantity of the table may have.
printf '%s\n' 'model named' 'state root1' 'state y' 'eq root1 = 0' 'eq y = 0' 'integral L = root1^2 + root1*y - 3' \
    'equal apart : root1 = 0 modulo L' > named.tt
expect 1 '' ttc prove named.tt
grep -qF 'root1 = root[1] - 1/2, y = 1, root[1] = sqrt(13/4)' out || fail "a root that a point needs is called: $(grep at out)"
# Where an expression uses such a root, it is said what the root is.
printf '%s\n' 'model around' 'state q' 'state k in (0, inf)' 'angle c s = cos(q) sin(q)' 'domain d : 1 - c > 0' 'root r = sqrt(k)' \
    'lift into plane.tt with x = r*c, y = 0, z = r*s' > around.tt
printf '%s\n' 'model plane' 'state x' 'state y' 'state z' 'eq x = y' 'eq y = 1' 'eq z = 0' \
    'section up : by around.tt at y = 0 with q = atan2(z, x), k = x^2 + z^2' > plane.tt
expect 1 '' ttc prove plane.tt
grep -qF '(x^2-x*root[1]+z^2)/(x^2+z^2), root[1] = sqrt(x^2+z^2)' out || fail "nobody says what a root is: $(cat out)"

# Cosine and sine of pi/7 have no common part with others that a record could name: it is said which parts of pi may be used.
printf '%s\n' 'model seventh' 'param p' 'state x' 'angle c s = cos(p) sin(p)' 'eq x = c' 'variant v : p = pi/7' > seventh.tt
expect 3 '' ttc prove seventh.tt
grep -qF 'of pi, a multiple of pi/n, where n divides 240' err || fail "of pi/7 it is said: $(cat err)"

# What is wrong with a claim is said in terms of a quotient that the table names, if that is shorter.
printf '%s\n' 'model pushed' 'param k' 'state x' 'state u' 'let N = (1 + k*x^2)/(1 + x^2 + u^4)' 'eq x = u' 'eq u = -x - N*u' \
    'integral E = (x^2 + u^2)/2' > pushed.tt
expect 1 '' ttc prove pushed.tt
grep -qF 'd(E)/dt = -u^2*N' out || fail "the rate of E is said as: $(grep 'd(E)' out)"

# JSON has no byte that is not UTF-8; a file whose name has one is told all the same.
printf 'model named\nstate x\neq x = x\npositive e : 1 + x^2\n' > $'named\xff.tt'
for command in check prove discover; do
    ttc $command --json $'named\xff.tt' 2> err | jq -e '[.] | flatten | .[0].file == "named?.tt"' > /dev/null ||
        fail "$command --json loses a table whose name is not UTF-8"
done

# The value that refutes a claim is that of the point: left of a jump, -1/2.
printf '%s\n' 'model jumps' 'state x' 'root q = sqrt((x - 1)^2)' 'exp e = exp(x)' 'eq x = 0' \
    'positive jump : (x - 1)/q + 1/2' > jumps.tt
ttc prove jumps.tt > out 2> err
grep -A 1 'not positive: jump = (-1)/(2)$' out | grep -q 'false at x = 0' || fail "a jump is refuted by: $(grep -A 1 positive: out)"
exit $status
