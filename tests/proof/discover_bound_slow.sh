#!/usr/bin/env bash
# The general top has no polynomial integral of degree 16 or less but those that E and G make: by leading parts, weight after
# weight. By the motion as it stands, where gravity is a number that hides its weights, none of degree 12 or less.
set -uo pipefail
cd "$JLT_SOURCE_DIR"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
status=0
bound() { # LINE OPTIONS...
    local line=$1
    shift
    ttc discover codegen/models/spherical_top.tt --seek integrals "$@" > "$scratch/out" 2> "$scratch/err" || status=1
    grep -qxF "$line" "$scratch/out" && ! grep -q '^[^#]' "$scratch/out" && return
    cat "$scratch/out" "$scratch/err"
    status=1
}
bound '# integrals: no other P, deg P <= 16 (35853 monomials, rank 35828)' --degree 16
bound '# integrals: no other P, deg P <= 12 (10556 monomials, rank 10540)' --degree 12 --when g=3/7
exit $status
