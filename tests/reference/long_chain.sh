#!/usr/bin/env bash
# A chain of 64 masses, 128 states: most of the 16384 entries of its Jacobian are 0, and kernels do not spell them out, so that a C
# compiler takes seconds and not minutes. Oracle: the modes of the linear chain, of frequencies 2 sin(pi k/(2 (n + 1))).
source "$JLT_SOURCE_DIR/tests/scratch.sh"
chain() { # N
    awk -v n="$1" 'function pull(a, b) { return "(" a " - " b ")" }
        BEGIN {
            print "model chain" n "\nparam al\ndefault al = 0"
            for (i = 1; i <= n; i++) print "state q" i
            for (i = 1; i <= n; i++) print "state p" i
            for (i = 1; i <= n; i++) {
                left = i > 1 ? "(q" i " - q" i - 1 ")" : "q1"
                right = i < n ? "(q" i + 1 " - q" i ")" : "(-q" n ")"
                print "eq q" i " = p" i "\neq p" i " = " right " - " left " + al*" right "^2 - al*" left "^2"
            }
        }' > "chain$1.tt"
}
mode() { # N: the first mode, at rest
    awk -v n="$1" 'BEGIN { for (i = 1; i <= n; i++)
        printf "%sq%d=%.17g,p%d=0", (i > 1 ? "," : ""), i, sin(atan2(0, -1)*i/(n + 1)), i }'
}
chain 64
expect 0 'proved +kernel .* rhs jacobian rhs_jacobian' ttc prove --kernels chain64.tt
expect 0 '' ttc generate --out kernels chain64.tt
for file in kernels/chain64/*; do
    [ "$(wc -c < "$file")" -lt 800000 ] || fail "$file has $(wc -c < "$file") bytes"
done
expect 0 '^10,' jellett simulate ./chain64.tt --start "$(mode 64)" --until 10 --every 10
awk -F, '/^10,/ { pi = atan2(0, -1); w = 2*sin(pi/130); d = $33 - sin(32*pi/65)*cos(10*w); exit !(d^2 < 1e-22) }' out ||
    fail "states: $(tail -n 1 out)"
chain 16
expect 0 'characteristic' jellett eigen ./chain16.tt --at "$(mode 16 | sed 's/=[^,]*/=0/g')"
for k in 1 7 16; do
    frequency=$(awk -v k=$k 'BEGIN { print substr(sprintf("%.12f", 2*sin(atan2(0, -1)*k/34)), 1, 11) }')
    grep -qF "$frequency" out || fail "no eigenvalue ${frequency}i"
done
exit $status
