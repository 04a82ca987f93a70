#!/usr/bin/env bash
# No verdict on any table of the project, or of these tests, is contradicted at random points of its domain. Tables of the
# tests make false claims as well, so that every status but that of a contradiction, and of a signal, will do.
set -euo pipefail
points=40
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
awk -v folder="$scratch" '/^model /{n++} n{print > sprintf("%s/divisors%d.tt", folder, n)}' \
    "$JLT_SOURCE_DIR/tests/proof/claims/divisors.tt"
# A level that is a parameter of the integral itself: z = -x^2 - y^2 wherever the integral is k.
cat > "$scratch/own_level.tt" << 'TABLE'
model own_level
param k
state x
state y
state z
eq x = y
eq y = -x
eq z = 0
integral G = z + x^2 + y^2 + k
eliminate whole : z by G = k
TABLE
for table in "$JLT_SOURCE_DIR"/codegen/models/*.tt "$JLT_SOURCE_DIR"/tests/proof/models/*.tt "$scratch"/*.tt; do
    status=0
    said=$(ttc prove --challenge $points "$table" 2>&1) || status=$?
    if [ $status -eq 70 ] || [ $status -ge 124 ]; then
        printf '%s\n' "$said"
        echo "$table: status $status"
        exit 1
    fi
    printf '%s\n' "$said" | tail -n 1
done
