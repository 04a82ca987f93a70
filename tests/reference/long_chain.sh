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
mode() { # N [AMPLITUDE]: the first mode, at rest
    awk -v n="$1" -v a="${2:-1}" 'BEGIN { for (i = 1; i <= n; i++)
        printf "%sq%d=%.17g,p%d=0", (i > 1 ? "," : ""), i, a*sin(atan2(0, -1)*i/(n + 1)), i; print "" }'
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
# 62 states fill a row of the lanes beside the clock: the first mode of 31 masses, of two amplitudes, pushed where it is at rest.
# 64 states go one orbit at a time.
for n in 31 32; do
    chain $n
    for amplitude in 1 3; do mode $n $amplitude | sed -E 's/(q[0-9]+)=([^,]*),(p[0-9]+)=0/\1=0,\3=\2/g; s/q16=0,//'; done > starts
    expect 0 '' jellett section ./chain$n.tt --section q16=0 --returns 5 --tol 1e-11 -o returns$n.csv \
        --start "$(head -n 1 starts)" --start "$(tail -n 1 starts)"
    awk -F, -v n=$n '/^orbit,/ { for (i = 1; i <= NF; i++) column[$i] = i }
        /^[01],[1-5],/ { pi = atan2(0, -1); d = $column["t"]/($2*pi/sin(pi/(2*n + 2))) - 1
            e = $column["p16"]/((1 + 2*$1)*sin(16*pi/(n + 1))) - 1; if (d^2 + e^2 > 1e-20) bad = 1; rows++ }
        END { exit rows != 10 || bad }' returns$n.csv || fail "returns of $n masses: $(grep -v '^#' returns$n.csv | cut -c1-80)"
done
grep -q 'stepanov10' returns31.csv || fail "62 states are not in lanes: $(grep '^# ' returns31.csv)"
grep -q 'more states than lanes take' returns32.csv || fail "64 states: $(grep '^# ' returns32.csv)"
# 50 masses with friction, the first one driven: its motion at phase 0, and the 2-norm of DP, are known mode by mode. But for the
# longest step allowed, one step of Newton's method from rest would do; with wrong singular values of 100 columns, 80 did not.
chain 50
sed -Ei 's/^eq p([0-9]+) = .*/& - p\1\/10/; s/^eq p1 = .*/& + c\/2/
    s/^eq q1 .*/state ph\nangle c s = cos(ph) sin(ph)\neq ph = 3\/2\nperiodic ph = 2*pi\n&/' chain50.tt
rest=$(mode 50 | sed 's/=[^,]*/=0/g')
known() { # response|growth
    awk -v what="$1" 'BEGIN {
        pi = atan2(0, -1); w = 3/2; T = 2*pi/w
        for (k = 1; k <= 50; k++) {
            square = 4*sin(pi*k/102)^2; off = square - w^2
            response += 2/51*sin(pi*k/51)^2*off/2/(off^2 + w^2/100)
            f = sqrt(square - 1/400); c = cos(f*T); s = sin(f*T)/f
            sum = 2*c^2 + 2*(s/20)^2 + s^2 + (square*s)^2
            norm = (sum + sqrt(sum^2 - 4))/2*exp(-T/10)
            if (norm > largest) largest = norm
        }
        printf "%.17g", what == "growth" ? log(largest)/2/T : response }'
}
expect 0 ',attracting,' jellett orbits ./chain50.tt --section ph=0 --period 1 --start "$rest"
awk -F, -v known="$(known response)" '/^1,/ { n++; d = $2 - known } END { exit !(n == 1 && d^2 < 1e-24) }' out ||
    fail "driven: $(known response), found $(grep '^1,' out | cut -d, -f2)"
expect 0 '' jellett lyapunov ./chain50.tt --section ph=0 --returns 1 --grid "$(sed 's/=0/=0:0:1/g' <<< "$rest")"
awk -F, -v known="$(known growth)" '/^0,/ { n++; d = $(NF - 1) - known } END { exit !(n == 1 && d^2 < 1e-24) }' out ||
    fail "growth: $(known growth), found $(tail -n 1 out | cut -c200-)"
exit $status
