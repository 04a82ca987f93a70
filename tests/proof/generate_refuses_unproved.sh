#!/usr/bin/env bash
# Kernels that rest on a claim which is refuted, or not settled, are not written: `ttc generate` ends with status 1 and names
# the claim, its place and the kernels. With --unproved it writes them, and every file of the model and every descriptor that
# rests on such a claim says so; the others do not. Claims that no kernel rests on are no matter of `generate`.
source "$JLT_SOURCE_DIR/tests/scratch.sh"

table() { # NAME LINE...: an oscillator, and more records
    local name=$1
    shift
    {
        printf 'model %s\nparam k > 0\nstate x\nstate v\neq x = v\neq v = -k*x\nintegral E = v^2/2 + k*x^2/2\n' "$name"
        printf '%s\n' "$@"
    } > "$name.tt"
}

refused() { # PLACE WORDS NAME LINE...
    local place=$1 words=$2 name=$3 code
    shift 2
    table "$@"
    ttc generate --out out "$name.tt" > said 2>&1
    code=$?
    [ $code -eq 1 ] || fail "$name: status $code, not 1"
    grep -q "^$name.tt:$place: error: .*$words" said || fail "$name: says $(head -3 said)"
    [ ! -e out ] || fail "$name: files are written"
    ttc generate --unproved --out out "$name.tt" > said 2>&1 || fail "$name: --unproved does not write: $(head -3 said)"
    for file in out/"$name"/*; do
        head -1 "$file" | grep -q UNPROVED || fail "$name: $file does not say that it is unproved"
    done
    grep -q '\.unproved = "' out/"$name"/general*.c || fail "$name: no descriptor says that it is unproved"
    rm -rf out
}

refused 8:10 "integral claim 'F' is refuted, and kernels rest on it (general: integral_values, integral_gradients)" \
    integral_refuted 'integral F = v^2/2 + k*x^3/2'
refused 8:10 "integral claim 'c' is not settled" integral_constant 'integral c = k'
refused 8:9 "measure claim 'r' is refuted, and kernels rest on it (general: measure_values, measure_divergences)" \
    measure_refuted 'measure r = x^2 + 1'
refused 8:10 "general_on_e: all kernels" elimination 'integral F = x + v' 'eliminate e : x by F = level'
refused 8:12 "equilibria claim 'rest' is refuted" family 'equilibria rest : x = 1, v = 0'
refused 9:9 "trace claim 'rest' is refuted" wrong_trace 'equilibria rest : x = 0, v = 0' '  trace rest = k'
refused 8:5 "log claim 'f' is refuted, and kernels rest on it (general: all kernels)" logarithm 'log f = log(x)' 'observe h = f'
refused 8:9 "observe claim 'h' is refuted, and kernels rest on it (general: all kernels)" looked_at 'observe h = x/(k - 1)'
refused 8:6 "time claim 'back' is .*general_in_back: all kernels" backwards 'time back : -1 - x^2'

printf 'model points\nparam k > 0\nparam E\nstate v\ndomain inside : 2*E - v^2 > 0\n' > points.tt
printf 'root r = sqrt((2*E - v^2)/k)\nlift into outside.tt with x = r, v = v\n' >> points.tt
refused 8:9 "section claim 'cut' is refuted, and kernels rest on it (general: sections)" \
    outside 'section cut : by points.tt at x = 0 with v = v, E = E'

# Only what rests on the claim is marked.
table two 'integral F = x + v' 'eliminate e : x by F = level' 'variant unit : k = 1'
ttc generate --unproved --out out two.tt > said 2>&1 || fail "two: $(head -3 said)"
grep -q 'unproved = "integral F, eliminate e"' out/two/general_on_e.c || fail "two: the elimination does not name both claims"
rm -rf out

# Nothing is served of an invariant, a reversor, an identity or a rate.
table unserved 'equal wrong : x = v' 'reversor x -> -x' 'invariant no = x + 1'
ttc generate --out out unserved.tt > said 2>&1 || fail "unserved: $(head -3 said)"
! grep -rq -i unproved --include='*.c' out/unserved || fail "unserved: a file says that it is unproved"
rm -rf out
# An integral under a condition that no field meets has no kernel either.
table conditional 'param a' 'integral F = a*v when a = 0'
sed -i 's/^eq v = .*/eq v = -k*x + 0*a/' conditional.tt
ttc generate --out out conditional.tt > said 2>&1
grep -q "F'" said && fail "conditional: $(head -3 said)"
rm -rf out
# Where a root is rational under a variant, by which an elimination then divides by zero, there is no such field, nor one in a time
# that lifts the root.
table rational 'param a' 'root r = sqrt(1 + a^2)' 'state z' 'eq z = 0' 'integral F = (r - 1)*z' 'variant flat : a = 0' \
    'eliminate e : z by F = level' 'time t : r lifting r'
ttc generate --out out rational.tt > said 2>&1 || fail "rational: $(head -3 said)"
for time in - t; do
    grep -q $'\tflat\t'$time$'\te\t.*none: divides by zero identically' out/manifest.tsv ||
        fail "rational, in $time: $(cat out/manifest.tsv)"
done
rm -rf out
# A family of equilibria that divides by what a variant sets to zero has kernels where it does not, and none under the variant; so
# has one whose trace does.
table still 'param c' 'state z' 'eq z = 1 - c*z' 'variant free : c = 0' 'equilibria rest : x = 0, v = 0, z = 1/c'
table traced 'param c' 'state z' 'eq z = -c*z' 'variant free : c = 0' 'equilibria rest : x = 0, v = 0, z = 0' \
    'trace rest = (c - c^2)/c - 1'
for name in still traced; do
    ttc generate --out out $name.tt > said 2>&1 || fail "$name: $(head -3 said)"
    grep -q 'equilibria = equilibria' out/$name/general.c || fail "$name: the general field has no family"
    ! grep -q 'equilibria = equilibria' out/$name/free.c || fail "$name: there is a family under the variant"
    ttc prove --kernels $name.tt > said 2>&1 || fail "$name: $(cat said)"
    rm -rf out
done
exit $status
