#!/usr/bin/env bash
# What generate, cost and prove --kernels cannot do they say with FILE:LINE:COLUMN and the true cause; in JSON a table that is
# wrong is an object with its problems, in every command that speaks JSON.
set -uo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
status=0
fail() { echo "$*"; status=1; }

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
printf 'model twice\nparam k\nstate x\neq x = k*x\nvariant general : k = 1\n' > twice.tt
expect 3 "^twice.tt:5:9: error: 'twice/general.c' would be written twice" ttc generate --out folder twice.tt
# A derivative whose powers pass the limit of the graph, 256.
printf 'model power\nstate x\nlet a = x^64\nlet b = a^4\neq x = b*x\ntime u : 1/(1 + x^2)\n' > power.tt
for command in "generate --out folder" cost "prove --kernels"; do
    # shellcheck disable=SC2086
    expect 3 '^power.tt:[0-9]+:[0-9]+: error: .*power passes 256' ttc $command power.tt
done
[ ! -e folder ] || fail "files are written"

# A table of coordinates alone; beside its model's it is passed over.
printf 'model points\nparam E\nstate q\ndomain inside : E > 0\nroot r = sqrt(2*E)\nlift into moves.tt with q = q, x = 0, u = r\n' > points.tt
printf 'model moves\nstate q\nstate x\nstate u\neq q = u\neq x = u\neq u = 0*u\nintegral E = u^2/2\n' > moves.tt
printf 'section cut : by points.tt at x = 0 with q = q, E = E\n' >> moves.tt
for command in "generate --out folder" cost build; do
    # shellcheck disable=SC2086
    expect 3 '^points.tt:6:1: error: the coordinates of a section have no kernels of their own .expected moves.tt' ttc $command points.tt
done
expect 0 '' ttc generate --out folder points.tt moves.tt
grep -q '\.chart = "points"' folder/moves/general.c || fail "the kernels of a model lack those of its section"
[ ! -e folder/points ] || fail "a table of coordinates has kernels"
rm -r folder
expect 0 '' ttc cost points.tt moves.tt
expect 0 '' ttc prove --kernels points.tt moves.tt

printf 'model broken\nstate x\neq x = y\n' > broken.tt
for command in check prove cost; do
    expect 3 '' ttc $command --json broken.tt
    jq -e 'if type == "array" then .[0] else . end
        | .file == "broken.tt" and .ok == false and (.problems | length) == 1
          and (.problems[0] | [.file, .line, .column, .severity] == ["broken.tt", 3, 8, "error"]
               and (.message | contains("unknown name \u0027y\u0027")))' out > /dev/null || fail "$command --json does not say what is wrong"
    expect 5 '' ttc $command --json missing.tt
    jq -e 'if type == "array" then .[0] else . end | .problems[0].message | contains("cannot open")' out > /dev/null ||
        fail "$command --json does not say that the file is missing"
done
exit $status
