#!/usr/bin/env bash
# `jellett verify` makes every comparison it speaks of, at every point: the sleigh has 2 states and 1 integral on its family, so
# that a point gives 2 numbers of the field, 4 of a Jacobian, 1 trace, 2 of a gradient, 2 coefficients and 2 eigenvalues.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
samples=5
while IFS='|' read -r each name; do echo "$((each * samples)) $name"; done > "$scratch/expected" << 'END'
2|field on the family, which is zero
4|generated Jacobian in ball enclosures of 256 bits
4|fused field and Jacobian in ball enclosures of 256 bits
1|generated divergence in ball enclosures of 256 bits
1|table's trace in ball enclosures of 256 bits
1|generated divergence against the table's trace
4|table's matrix in ball enclosures of 256 bits
4|generated Jacobian against the table's matrix
4|generated Jacobian against complex-step differentiation
2|integrals' gradients in ball enclosures of 256 bits
2|integrals' gradients as left null vectors
2|characteristic polynomial, Faddeev-LeVerrier against the table's
2|eigenvalues against the characteristic polynomial
END
jellett verify --json --samples=$samples chaplygin_sleigh |
    jq -r '.. | objects | select(has("numbers")) | "\(.numbers) \(.name)"' > "$scratch/made"
diff "$scratch/expected" "$scratch/made"
