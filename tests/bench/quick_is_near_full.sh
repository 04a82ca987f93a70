#!/usr/bin/env bash
# Quick effort costs few operations: over all tables of the project, each kind of kernel takes at most 15 % more than in
# generated/counts.tsv, which full effort made.
set -euo pipefail
awk() { LC_ALL=C command awk "$@"; } # numbers have points in any locale
cd "$JLT_SOURCE_DIR"
ttc cost codegen/models/*.tt | awk -F'\t' '
    FNR == 1 { next }
    NR == FNR { full[$1 FS $2 FS $3 FS $4 FS $5] = $6; next }
    {
        key = $1 FS $2 FS $3 FS $4 FS $5
        if (!(key in full)) { print key ": not in generated/counts.tsv"; failed = 1; next }
        sum_full[$5] += full[key]; sum_quick[$5] += $6; seen++
        if (full[key] > 0 && $6 / full[key] > worst) { worst = $6 / full[key]; where = key }
    }
    END {
        for (kernel in sum_full) {
            printf "%-20s %6d operations, %6d with quick effort\n", kernel, sum_full[kernel], sum_quick[kernel]
            if (sum_quick[kernel] > 1.15 * sum_full[kernel]) { print kernel ": more than 15 % more"; failed = 1 }
        }
        printf "worst kernel: %s, %.2f times\n", where, worst
        if (seen == 0) { print "no kernels"; failed = 1 }
        exit failed
    }' generated/counts.tsv -
