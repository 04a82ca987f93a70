#!/usr/bin/env bash
# No kernel takes more operations than SymPy's common subexpression elimination finds for the same functions.
#
# sympy_counts.tsv was made by tools/bench/sympy_counts.py (SymPy 1.14); an fma counts as two. One kernel is let off by
# name: a div(rho f) that is zero identically, which SymPy simplifies away and which is emitted as it stands, so that the
# compiled zero can be measured.
set -euo pipefail
cd "$JLT_SOURCE_DIR"
awk -F'\t' '
    FNR == 1 { next }
    { key = $1 " " $2 " " $3 " " $4 " " $5 }
    NR == FNR { ours[key] = $6; next }
    !(key in ours) { print key ": not in generated/counts.tsv: make sympy_counts.tsv anew"; bad++; next }
    $5 == "measure_divergences" && $6 == 0 { next }
    { compared++ }
    ours[key] > $6 + 0 { print key ": " ours[key] " operations, SymPy " $6; bad++ }
    END { print compared " kernels compared, " bad + 0 " above"; exit bad > 0 }
' generated/counts.tsv tests/property/sympy_counts.tsv
