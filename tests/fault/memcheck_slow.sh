#!/usr/bin/env bash
# No command reads or writes memory that is not its own, or loses any: valgrind's memcheck on short runs of each.
set -uo pipefail
if nm "$(command -v ttc)" | grep __asan_init > /dev/null; then echo "built with sanitizers, which do not run below valgrind"; exit \
    77; fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
models=$JLT_SOURCE_DIR/codegen/models
status=0

check() { # STATUS COMMAND...: as documented, and clean
    local want=$1 code
    shift
    valgrind --quiet --error-exitcode=99 --leak-check=full --errors-for-leak-kinds=definite,indirect \
        --log-file="$scratch/log" "$@" > "$scratch/out" 2> "$scratch/err"
    code=$?
    if [ $code -ne "$want" ]; then
        echo "$*: status $code, not $want"
        head -40 "$scratch/log" "$scratch/err"
        status=1
    fi
}

check 0 ttc check "$models/spherical_top.tt"
check 0 ttc show "$models/chaplygin_sleigh.tt"
check 0 ttc cost "$models/chaplygin_sleigh.tt"
check 0 ttc discover --when "a3 = 0, I1 = I3" --degree 2 "$models/spherical_top.tt"
check 0 ttc discover --when "sigma=1/2, beta=1, rho=0" "$models/lorenz.tt"
check 0 ttc prove "$models/chaplygin_sleigh.tt"
# Proofs are slowed down forty times here, and each may take 20 s: these are short, one of them of a section.
check 0 ttc prove --json "$models/restricted_three_body.tt"
check 0 ttc prove --challenge 5 "$models/restricted_three_body.tt"
check 3 ttc prove "$JLT_SOURCE_DIR/tests/proof/models/henon_heiles.tt"
check 0 ttc generate "$models/chaplygin_sleigh.tt" --out "$scratch/generated"
check 0 ttc generate "$models/restricted_three_body.tt" --out "$scratch/generated"
sed 's/+ a\*w^2/+ a*q^2)/' "$models/chaplygin_sleigh.tt" > "$scratch/bad.tt"
check 3 ttc check "$scratch/bad.tt"
check 0 jellett models
check 0 jellett eigen --set a3=0 --at gamma3=0.3,v_nu=0.7,omega3=1.1
check 3 jellett eigen --set a3=0 --at gamma3=3,v_nu=0.7,omega3=1.1
check 0 jellett measure --set I3=0
exit $status
