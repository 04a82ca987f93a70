#!/usr/bin/env bash
# When an orbit comes to a pole does not depend on the time that lifts its root, and is the instant at which the motion on the
# sphere passes it: x = sin theta with theta'' = -k sin theta. Where the factor of that time is no multiple of the root the pole
# is not proved, and the orbit goes in t up to the end of the interval.
source "$JLT_SOURCE_DIR/tests/scratch.sh"

# theta' = u: from theta = 0 at rate 2, u^2/2 - k cos theta = 2 - k, k = 1/2; t = integral of dtheta/sqrt(4 - 1 + cos theta) from
# 0 to pi/2, by Gauss and Legendre with 40 points, whose error is below rounding for an integrand analytic up to cos theta = -3.
end=$(python3 - << 'P'
from math import cos, pi, sqrt
n, total = 40, 0.0
for i in range(n):
    x = cos(pi*(i + 0.75)/(n + 0.5))
    for _ in range(50):
        p, q = 1.0, 0.0
        for j in range(n): p, q = ((2*j + 1)*x*p - j*q)/(j + 1), p
        d = n*(x*p - q)/(x*x - 1)
        x -= p/d
    total += 2/((1 - x*x)*d*d)*pi/4/sqrt(3 + cos(pi/4*(1 + x)))
print(repr(total))
P
)
table() { # FACTOR
    printf '%s\n' 'model sphere' 'param k' 'default k = 1/2' 'state x in (-1, 1)' 'state u' 'root s = sqrt(1 - x^2)' 'eq x = s*u' \
        'eq u = - k*x' "time one : $1 lifting s" 'pole x' > sphere.tt
}
ends() { # FATE FACTOR WITHIN
    jellett simulate ./sphere.tt --start x=0,u=2 --times 10 > out 2> err
    tail -1 out | awk -F, -v t="$end" -v within="$3" -v fate="$1" '{ exit !($1 - t < within && t - $1 < within && $NF == fate) }' ||
        fail "dt = $2 dtau: $(tail -1 out), wanted $1 at $end; $(cat err)"
}
for factor in 's' '3*s' 's*(1 + x^2)' 's/1000' 's/1000000' 's/(2 + x)'; do
    table "$factor"
    ttc prove sphere.tt > proofs || fail "dt = $factor dtau: $(cat proofs)"
    ends pole+ "$factor" 1e-12
done
# Times just before it have their rows too: u = sqrt 3 at the pole, where u' = -1/2.
table s
before=$(python3 -c "print(*($end - d for d in (1e-7, 1e-9, 1e-11)), sep=',')")
jellett simulate ./sphere.tt --start x=0,u=2 --times "$before,10" > out 2> err || fail "before the pole: $(cat err)"
awk -F, -v t="$end" '/alive$/ { n++; off = $3 - sqrt(3) - (t - $1)/2; bad += !(off < 1e-12 && off > -1e-12) }
    END { exit !(n == 3 && !bad) }' out && grep -q 'of 4 times 3 lie before it' err || fail "before the pole: $(cat out err)"
# In t steps end where 1 - x keeps half of its digits: 1e-11 of x, and sqrt(2e-11)/1.7 = 3e-6 of t.
for factor in 's^2' '1' 's + 1'; do
    table "$factor"
    ttc prove sphere.tt > proofs 2>&1 && fail "dt = $factor dtau: the pole is proved: $(cat proofs)"
    ends left_domain "$factor" 5e-6
done
exit $status
