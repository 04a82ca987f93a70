#!/usr/bin/env bash
# ttc discover finds what tables of the house and of the literature claim, with these claims taken out of the tables: known
# integrals and densities are the oracle, `ttc prove --challenge`, which shares no code with what finds and proves, the witness.
# With the claims in place it finds nothing more, by the same rank.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
cd "$JLT_SOURCE_DIR"

# A table without its claims, and without what rests on them.
strip() {
    LC_ALL=C awk '
        BEGIN {
            count = split("integral invariant rate measure equal positive reduction embedding section lift equilibria " \
                "trace charpoly " \
                          "matrix leftnull obstructs tier eliminate pole reversor symmetry periodic time variant", names, " ")
            for (i = 1; i <= count; i++) claim[names[i]] = 1
            count = split("model title source param state root angle exp log let eq default observe valid domain", names, " ")
            for (i = 1; i <= count; i++) kept[names[i]] = 1
        }
        /^[ \t]*#/ { next }
        $1 in claim { skip = 1 }
        $1 in kept { skip = 0 }
        !skip' "$1"
}

# found TABLE FINDS WHEN OPTIONS...: that many integrals and measures, each also by challenge; none more beside the table's claims.
found() {
    local table=$1 finds=$2 when=$3 name
    shift 3
    name=$(basename "$table" .tt)
    strip "$table" > "$scratch/$name.tt"
    ttc discover "$scratch/$name.tt" ${when:+--when "$when"} "$@" > "$scratch/finds" 2> "$scratch/err" ||
        fail "$name $when: status $?"
    grep -v warning "$scratch/err" | grep -q "ttc discover" && fail "$name $when: $(cat "$scratch/err")"
    [ "$(grep -cE '^(integral|measure)' "$scratch/finds")" -eq "$finds" ] ||
        fail "$name $when: not $finds finds: $(cat "$scratch/finds")"
    grep -v '^#' "$scratch/finds" >> "$scratch/$name.tt"
    ttc prove --challenge 8 "$scratch/$name.tt" > "$scratch/proofs" 2>&1 || fail "$name $when: $(cat "$scratch/proofs")"
    [ -n "${lower-}" ] && return # combinations of what the table claims are of lower degree
    ttc discover "$table" ${when:+--when "$when"} "$@" > "$scratch/beside" 2> "$scratch/err" || fail "$name $when: status $?"
    grep -E '^(integral|measure)' "$scratch/beside" && fail "$name $when: more than the table claims"
    diff <(grep 'deg P' "$scratch/finds") <(grep 'deg P' "$scratch/beside") || fail "$name $when: other ranks"
}

# says WHEN LINE: of Lorenz's system.
says() {
    ttc discover codegen/models/lorenz.tt --when "$1" > "$scratch/lorenz" 2>&1
    grep -qxF -- "$2 when $1" "$scratch/lorenz" || fail "lorenz when $1: not $2"
}

top=codegen/models/spherical_top.tt
found $top 2 '' --seek integrals                        # E, G
found $top 3 a3=0 --seek integrals                      # and F0
lower=yes found $top 3 a3=0,I1=I3 --seek integrals --degree 2     # and the linear one
found $top 4 I3=0                                       # E1, E2, G, and rho
found codegen/models/routh_sphere.tt 4 ''               # E, Jellett's and Routh's integral, the density
found tests/proof/models/kovalevskaya_top.tt 5 ''       # the quartic, and the uniform density
found tests/proof/models/chaplygin_ball.tt 5 ''
found tests/proof/models/euler_top.tt 3 '' --degree 2
found codegen/models/lotka_volterra.tt 2 '' --degree 2
found codegen/models/toda.tt 3 '' --denominator 's1*s2' # the third is of degree 5

# The bound on leading parts, and that on the motion as it stands, where gravity is a number that hides its weights, are one.
for when in '' g=3/7; do
    ttc discover $top --seek integrals --degree 8 ${when:+--when $when} > "$scratch/bound" 2>&1
    grep -qxF '# integrals: no other P, deg P <= 8 (2079 monomials, rank 2070)' "$scratch/bound" ||
        fail "$top $when: $(cat "$scratch/bound")"
done

# Polynomials with a constant cofactor: J. Llibre, X. Zhang, Invariant algebraic surfaces of the Lorenz system, J. Math. Phys. 43
# (2002).
says 'sigma=1/2, beta=1, rho=0' 'integral F3 = (x^2 - z)^2/(y^2 + z^2)'
says 'beta=2*sigma' 'rate P1 : x^2 - 2*sigma*z = -2*sigma*(x^2 - 2*sigma*z)'
says 'beta=1, rho=0' 'rate P1 : y^2 + z^2 = -2*(y^2 + z^2)'
says 'sigma=1, beta=1' 'rate P1 : -rho*x^2 + y^2 + z^2 = -2*(-rho*x^2 + y^2 + z^2)'
for when in 'beta=6*sigma-2, rho=2*sigma-1' 'beta=4, sigma=1'; do
    ttc discover codegen/models/lorenz.tt --when "$when" --seek factors --degree 4 > "$scratch/lorenz" 2>&1
    grep -qE '^rate P1 : -x\^4 \+ 4\*(sigma\*)?x\^2\*z' "$scratch/lorenz" || fail "lorenz when $when: no quartic"
done
# What the table claims, and is proved, may have no value under the conditions: it is then not known, and what has one is found.
printf '%s\n' 'model spring' 'param a' 'param b' 'param c' 'state x' 'state y' 'eq x = y' 'eq y = -b*x' \
    'integral G = (b*x^2 + y^2)/a' 'integral L = y when b = c/a' 'measure rho = 1/a' > "$scratch/spring.tt"
ttc discover "$scratch/spring.tt" --when a=0 --denominator x^2+1 > "$scratch/finds" 2> "$scratch/err" ||
    fail "spring: $(cat "$scratch/err")"
for line in 'integral F1 = b*x^2 + y^2 when a=0' 'measure rho2 = 1 when a=0' \
    '# integrals: no other P/(x^2+1), deg P <= 4 (15 monomials, rank 13)'; do
    grep -qxF -- "$line" "$scratch/finds" || fail "spring: not said: $line: $(cat "$scratch/finds")"
done
# Conditions that no point of the domain meets are told of once, before anything is looked for.
sed 's/param b/param b > 0/' "$scratch/spring.tt" > "$scratch/stiff.tt"
# What is wrong in the command line is no line of the table.
ttc discover "$scratch/stiff.tt" --when 'b=2 a' > "$scratch/finds" 2> "$scratch/err"
[ $? -eq 3 ] && grep -q "^ttc discover: --when: unexpected 'a'" "$scratch/err" && ! grep -q 'error:' "$scratch/err" ||
    fail "an operator is missing: $(cat "$scratch/err")"
ttc discover "$scratch/stiff.tt" --when b=-1 > "$scratch/finds" 2> "$scratch/err"
[ $? -eq 3 ] && [ ! -s "$scratch/finds" ] && grep -q "^ttc discover: --when 'b=-1': no point of the domain of spring is known" \
    "$scratch/err" || fail "stiff: $(cat "$scratch/finds" "$scratch/err")"
# Invariant lines, planes and conics, whose cofactors are polynomials: made so. With u = x + 2 y - 1 and v = 3 x - y, u' = u (a + v)
# and v' = v (b + u); three kinds that eat each other; a limit cycle; Euler's equations, whose planes are irrational.
kinds() { # NAME LINE...: the lines that are no comments
    local name=$1
    shift
    ttc discover --seek factors "$scratch/$name.tt" > "$scratch/finds" 2> "$scratch/err" ||
        fail "$name: status $?, $(cat "$scratch/err")"
    diff <(grep -v '^#' "$scratch/finds" | grep -v ^measure) <([ $# = 0 ] || printf '%s\n' "$@") || fail "$name: not these factors"
    grep -v '^#' "$scratch/finds" >> "$scratch/$name.tt"
    ttc prove --challenge 8 "$scratch/$name.tt" > "$scratch/proofs" 2>&1 || fail "$name: $(cat "$scratch/proofs")"
}
printf '%s\n' 'model lines' 'title "two lines"' 'param a' 'param b' 'state x' 'state y' \
    'eq x = + (x + 2*y - 1)*(a + 3*x - y)/7 + 2*(3*x - y)*(b + x + 2*y - 1)/7' \
    'eq y = + 3*(x + 2*y - 1)*(a + 3*x - y)/7 - (3*x - y)*(b + x + 2*y - 1)/7' > "$scratch/lines.tt"
kinds lines 'rate P1 : 3*x - y = (x + 2*y + (b-1))*(3*x - y)' 'rate P2 : x + 2*y - 1 = (3*x - y + a)*(x + 2*y - 1)'
printf '%s\n' 'model eaten' 'title "May and Leonard"' 'param a' 'param b' 'param c' 'state x' 'state y' 'state z' \
    'eq x = + x*y - c*x*z' 'eq y = + y*z - a*y*x' 'eq z = + z*x - b*z*y' > "$scratch/eaten.tt"
kinds eaten 'rate P1 : x = (y - c*z)*x' 'rate P2 : y = (-a*x + z)*y' 'rate P3 : z = (x - b*y)*z'
printf '%s\n' 'model circle' 'title "a limit cycle"' 'param mu' 'state x' 'state y' 'eq x = - y + mu*x*(x^2 + y^2 - 1)' \
    'eq y = + x + mu*y*(x^2 + y^2 - 1)' > "$scratch/circle.tt"
kinds circle 'rate P1 : x^2 + y^2 = (2*mu*x^2 + 2*mu*y^2 - 2*mu)*(x^2 + y^2)' \
    'rate P2 : x^2 + y^2 - 1 = (2*mu*x^2 + 2*mu*y^2)*(x^2 + y^2 - 1)'
printf '%s\n' 'model euler' 'title "Euler"' 'param A' 'param B' 'param C' 'state x' 'state y' 'state z' \
    'eq x = + A*y*z' 'eq y = + B*z*x' 'eq z = + C*x*y' > "$scratch/euler.tt"
kinds euler

# What is said not to be there, at degree 1: lines that are said, and those that are not, behind an exclamation mark.
extactic() { # STATUS STATES EQUATIONS-AND-LETS LINE...
    local want=$1 code
    { printf '%s\n' 'model own' 'title "own"'; printf 'state %s\n' $2; printf '%s\n' "$3"; } > "$scratch/own.tt"
    shift 3
    ttc discover --seek factors --degree 1 "$scratch/own.tt" > "$scratch/finds" 2>&1
    code=$?
    [ $code -eq "$want" ] || fail "extactic: status $code, not $want: $(cut -c1-200 "$scratch/finds")"
    for line; do
        if [ "${line#!}" != "$line" ]; then grep -qF -- "${line#!}" "$scratch/finds" && fail "extactic: said: $line"
        else grep -qxF -- "$line" "$scratch/finds" || fail "extactic: not said: $line: $(cut -c1-200 "$scratch/finds")"
        fi
    done
}
rational='#          coefficients rational in the parameters (they divide the extactic polynomial, of degree'
none="# factors: no irreducible P with P' = K P, K without P in its denominator, deg P <= 1,"
# A factor of a high degree that is not invariant does not hide x and y (such exponents cannot be read in claims: status 3); an
# invariant one whose cofactor is beyond the limits of expressions.
extactic 3 'x y' 'let w = y^55
let v = x^53
eq x = x*(1 + w^20)
eq y = y*(2 + v^20)' 'rate P1 : x = (y^1100 + 1)*x' 'rate P2 : y = (x^1060 + 2)*y' '!no irreducible'
extactic 3 'x y' 'let w = x^64
eq x = y + w^33
eq y = y*(y + w^33)' '# factors with other cofactors: others not looked for, a polynomial passes the limit of degree 4096, of '\
'2^26 products of terms a multiplication, or of 131072 bits a coefficient' '!irreducible'
# Orbits in planes: y/x and such ratios are no integrals, though one exists.
extactic 0 'x y z' 'eq x = y^2
eq y = -x*y
eq z = (x^2 + y^2)^2 - x*z' '# factors with other cofactors: some integral is a ratio of two P, of degrees not known' '!deg P <= 1,'
extactic 0 'x y' 'eq x = x
eq y = y' '# factors with other cofactors: some integral is a ratio of two P, deg P <= 1'
# Irrational lines of a saddle, whose product is an integral; of a focus, whose product has a constant cofactor.
extactic 0 'x y' 'eq x = y
eq y = 2*x' '# factors: of a higher degree, and an integral: P = 2*x^2 - y^2' "$none" "$rational 2)"
extactic 0 'x y' 'eq x = x - y
eq y = x + y' 'rate P1 : x^2 + y^2 = 2*(x^2 + y^2)' "${none/no /no other }"
extactic 3 x "eq x = $(printf '(x-%d)*' {1..129})(x-130)" '!irreducible' \
    '# factors with other cofactors: others not looked for, there are too many of them'
# x' = 1/x is 1/x^2 times x, and that of y' = 1/x + y says nothing of x either; but where x' = x y it does.
extactic 0 x 'eq x = 1/x' "$none" "$rational 0)" '!rate'
extactic 0 'x y' 'eq x = 1
eq y = 1/x + y' "$none" '!rate'
extactic 0 'x y' 'eq x = x*y
eq y = 1/x + y^2' 'rate P1 : x = (y)*x' "${none/no /no other }"

# denied LINE... -- STATES EQUATIONS OPTIONS...: lines that are said, and behind an exclamation mark those that are not.
denied() {
    local lines=()
    while [ "$1" != -- ]; do lines+=("$1"); shift; done
    { printf '%s\n' 'model own' 'title "own"'; printf 'state %s\n' $2; printf '%s\n' "$3"; } > "$scratch/own.tt"
    ttc discover "$scratch/own.tt" "${@:4}" > "$scratch/finds" 2>&1
    for line in "${lines[@]}"; do
        if [ "${line#!}" != "$line" ]; then grep -qF -- "${line#!}" "$scratch/finds" && fail "denied: said: $line"
        else grep -qF -- "$line" "$scratch/finds" || fail "denied: not said: $line: $(cut -c1-200 "$scratch/finds")"
        fi
    done
}
# (x - a y)^2 (y - a x) is an integral: 3 is no square mod 2^62 - 57, and what holds where a is 0 says nothing of it.
denied '!no integral P' '!no other P' '1 more P, deg P <= 3, may exist' -- 'x y' 'root a = sqrt(3)
eq x = -7/2*x + 3/2*a*y
eq y = -3/2*a*x + 5/2*y' --degree 3
# Cofactors that no residue tells: with more than 30 bits; 0 mod 2^62 - 57; 1/0.
denied "!# factors: no P with P' = c P" "# factors: P with P' = c P, c != 0 rational in the parameters, deg P <= 3, may exist" -- \
    'x y z' \
    'eq x = 1.2345678901*x - y
eq y = x + 1.2345678901*y
eq z = 1 + z^2 + x' --degree 3 --seek factors
for c in '4611686018427387847*x' 'x/4611686018427387847'; do
    denied "!# factors: no P with P' = c P" '!deg P <= -1' -- 'x y z' "eq x = $c
eq y = x + y^2 + z^2
eq z = 1 + x*y*z" --degree 2
done
# The integral y/z, claimed, is none of the form P/x, and explains nothing of what is.
denied 'integral F1 = (v^2)/(x)' '# integrals: no other P/(x), deg P <= 2 (15 monomials, rank 13)' -- 'x v y z' 'eq x = 2*x
eq v = v
eq y = 5*y
eq z = 5*z
integral K = y/z' --degree 2 --denominator x --seek integrals
# y^2 + x^3 is no product of x and y, but a sum of such; integrals that are not asked for explain that 0 is a cofactor.
denied "# factors: no other P with P' = c P, c != 0 rational in the parameters, deg P <= 3, but sums of products of these" \
    '! and of integrals' -- 'x y' 'eq x = 2*x
eq y = 3*y' --degree 3
for seek in factors integrals,factors; do
    denied 'deg P <= 2, but sums of products of these and of integrals' -- 'x y z' 'eq x = y
eq y = -x
eq z = z' --degree 2 --seek $seek
done
denied "# factors: no P with P' = c P, c != 0 rational in the parameters, deg P <= 2" -- 'x y' 'eq x = y^2
eq y = -x^2' --degree 2 --seek factors

# A root of a quotient takes the quotient's poles out of the domain, here where Rabinovich's system comes to rest; one of 1 + x^2
# takes out nothing.
denied 'is positive and smooth where its root does not divide by zero' '!on the domain' -- 'x y z' 'eq x = y*z - x
eq y = -2*x*z - y
eq z = x*y - z'
denied 'is positive and smooth on the domain' '!where its root' -- 'x y' 'eq x = 1 + x^2
eq y = -3*x*y' --seek densities --degree 2

ttc discover codegen/models/lorenz.tt > "$scratch/lorenz" 2>&1
grep '^[^#]' "$scratch/lorenz" && fail 'lorenz: finds for parameters in general'

# --json has the same claims, which prove when they are added, and the same ranks; a table that cannot be read is an object too.
strip $top > "$scratch/stripped.tt"
ttc discover --when I3=0 "$scratch/stripped.tt" > "$scratch/finds" 2> "$scratch/err" || fail "text: $(cat "$scratch/err")"
ttc discover --json --when I3=0 "$scratch/stripped.tt" "$scratch/absent.tt" > "$scratch/json" 2> "$scratch/err"
[ $? -eq 5 ] || fail "json: another status than 5"
python3 - "$scratch/json" "$scratch/finds" "$scratch/stripped.tt" << 'END' || fail "json: not what the text says"
import hashlib, json, re, sys
found, absent = json.load(open(sys.argv[1]))
text = open(sys.argv[2]).read()
said = [l for l in text.splitlines() if not l.startswith("#")]
assert "\n".join(c["text"] for c in found["claims"]).splitlines() == said
assert [(c["kind"], c["name"]) for c in found["claims"]] == [tuple(l.split()[:2]) for l in said if not l.startswith(" ")]
ranks = re.findall(r"deg P <= (\d+) \((\d+) monomials, rank (\d+)\)", text)
settled = [s for s in found["settled"] if s["seek"] == "integrals"]
assert [(str(s["degree"]), str(s["monomials"]), str(s["rank"])) for s in settled] == ranks != []
assert all(s["complete"] for s in found["settled"]) and found["prime"] == 2 ** 62 - 57 and found["when"] == "I3=0"
assert found["remarks"] == [l[2:] for l in text.splitlines()[2:] if l.startswith("#")]
assert found["sha256"] == hashlib.sha256(open(sys.argv[3], "rb").read()).hexdigest() and found["unlifted"] == 0
assert not absent["ok"] and "No such file" in absent["problems"][0]["message"]
END
printf '%s\n' 'model own' 'title "own"' 'state x' 'state y' 'root a = sqrt(3)' 'eq x = -7/2*x + 3/2*a*y' 'eq y = -3/2*a*x + 5/2*y' \
    > "$scratch/own.tt"
ttc discover --json --degree 3 "$scratch/own.tt" > "$scratch/json" 2> "$scratch/err"
python3 -c '
import json, sys
(o,) = json.load(sys.stdin)
expected = {"seek": "integrals", "form": "P", "degree": 3, "complete": False, "monomials": 10, "rank": 8}
assert o["settled"][0] == expected, o["settled"]
assert o["prime"] < 2 ** 62 - 57 and o["unlifted"] > 0' < "$scratch/json" || fail "json: of what is open"

# refused STATUS WORDS ARGUMENTS...
refused() {
    local want=$1 words=$2
    shift 2
    ttc discover "$@" > "$scratch/out" 2> "$scratch/err"
    local code=$?
    [ $code -eq "$want" ] || fail "$*: status $code, not $want"
    grep -qF -- "$words" "$scratch/err" || fail "$*: no '$words' in: $(cat "$scratch/err")"
    [ ! -s "$scratch/out" ] || fail "$*: says $(head -1 "$scratch/out")"
}
# An invariant conic (3 x^2 - 2 x y + 2 y^2 + x + 2 k) too long to be looked for is left out with a word.
printf '%s\n' 'model conic' 'param k' 'state x' 'state y' 'let Q = 3*x^2 - 2*x*y + 2*y^2 + x + 2*k' \
    'eq x = Q*(3*x - 2*y + 2) + (4*y - 2*x)*2' 'eq y = -Q*(3*x + y + 2) - (6*x - 2*y + 1)*2' > "$scratch/conic.tt"
ttc discover --seek factors --degree 2 "$scratch/conic.tt" | grep -q "# factors of degree 2 are left out: the extactic" ||
    fail "conics: $(ttc discover --seek factors --degree 2 "$scratch/conic.tt")"
printf '%s\n' 'model hyperbola' 'state x' 'state y' 'eq x = x' 'eq y = -y' > "$scratch/hyperbola.tt"
refused 3 "has no parameter 'q' (expected one of sigma rho beta)" --when q=1 codegen/models/lorenz.tt
refused 3 "ttc discover: --when: " --when 'rho=(1' codegen/models/lorenz.tt
refused 2 "sets nothing" --when rho codegen/models/lorenz.tt
refused 3 "expected" --denominator 'x+unknown' codegen/models/lorenz.tt
for seek in integrals,factors,densities factors; do
    refused 3 "--denominator 'a' is zero, or no ratio" --seek $seek --when a=0 --denominator x^2+1,a "$scratch/spring.tt"
    refused 3 "--denominator 'x-x' is zero, or no ratio" --seek $seek --denominator x,x-x codegen/models/lorenz.tt
    # x*y is an integral y/(1/x): a ratio in place of a polynomial would be said to have none.
    refused 3 "--denominator '1/x' divides by what moves (expected a polynomial)" --seek $seek --denominator 1/x --degree 1 \
        "$scratch/hyperbola.tt"
done
refused 2 "unknown kind 'all'" --seek all codegen/models/lorenz.tt
refused 3 "has no equations" tests/proof/models/henon_heiles_section.tt
refused 5 "absent.tt" "$scratch/absent.tt"
# Said before anything is allocated: 100 MiB would not hold a thousandth of it.
(ulimit -v 400000; refused 4 "takes a matrix of 28856 columns, 9.47 GiB" --degree 40 $top; exit $status) || status=1
# Where memory is out while the table is read with the conditions, this is said, and no fault of theirs. Sanitizers have an
# allocator of their own.
if ! nm "$(command -v ttc)" | grep -E '__(asan|tsan)_init' > "$scratch/out"; then
    cat > "$scratch/scarce.c" << 'LIBRARY'
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdlib.h>
static long left = -1;
void *malloc(size_t size)
{
    static void *(*usual)(size_t);
    if (usual == NULL) {
        usual = (void *(*)(size_t))dlsym(RTLD_NEXT, "malloc");
        left = atol(getenv("ALLOCATIONS"));
    }
    return left > 0 ? left--, usual(size) : NULL;
}
LIBRARY
    "$JLT_CC" -shared -fPIC -o "$scratch/scarce.so" "$scratch/scarce.c" || fail "the library is not compiled"
    printf '%s\n' 'model scarce' 'param b' 'state x' 'state y' 'eq x = b*y' 'eq y = -x' > "$scratch/scarce.tt"
    for allocations in $(seq 10 4 200); do
        ALLOCATIONS=$allocations LD_PRELOAD=$scratch/scarce.so ttc discover "$scratch/scarce.tt" --when b=1 --degree 1 \
            > "$scratch/finds" 2> "$scratch/err"
        code=$?
        [ $code -ne 3 ] || grep -q . "$scratch/err" || fail "$allocations allocations: status 3 without a word"
        [ $code -eq 4 ] || ! grep '^ttc discover: memory is out$' "$scratch/err" ||
            fail "$allocations allocations: status $code"
    done
fi
exit $status
