#!/usr/bin/env bash
# Every kernel takes at most the operations of sympy.cse on the same functions (a fused multiply-add counts as two), as
# recorded in sympy_counts.tsv by tools/bench/sympy_counts.py. Exceptions, by intent: where SymPy's count is 0 the function
# is identically zero, while the kernel measures by how much rounding misses that; a kernel that takes a root may spend one
# more operation on 1 - x^2 = (1 - x)(1 + x), which keeps the digits; and one that has fewer divisions than SymPy's code
# may spend two more operations for each, as a division costs more than those.
set -euo pipefail
cd "$JLT_SOURCE_DIR"
awk -F'\t' '
    NR == FNR { key = $1 FS $2 FS $3 FS $4 FS $5; if (FNR > 1) { theirs[key] = $6; divisions[key] = $7 } next }
    FNR > 1 {
        key = $1 FS $2 FS $3 FS $4 FS $5
        if (!(key in theirs)) next
        allowed = theirs[key] + ($11 > 0 ? 1 : 0) + 2 * (divisions[key] > $10 ? divisions[key] - $10 : 0)
        if (theirs[key] > 0 && $6 > allowed) { print key ": " $6 " operations, SymPy " theirs[key]; failed = 1 }
        if ($6 > theirs[key]) more++
        seen++; ours += $6; sympy += theirs[key]
    }
    END {
        print seen " kernels: " ours " operations, SymPy " sympy "; more than SymPy in " more + 0 " kernels"
        if (seen < 200 || more > 5) { print "too few kernels compared, or too many exceptions"; failed = 1 }
        exit failed
    }' tests/bench/sympy_counts.tsv generated/counts.tsv
