#!/usr/bin/env bash
# Every kernel takes at most the operations of sympy.cse on the same functions, as recorded in sympy_counts.tsv by
# tools/bench/sympy_counts.py from the tables that there are; a fused multiply-add counts as two. One kernel, whose products are all
# there is, takes one more: its s is sqrt((1 - gamma3)(1 + gamma3)), which keeps digits that sqrt(1 - gamma3^2) loses.
set -euo pipefail
awk() { LC_ALL=C command awk "$@"; } # numbers have points in any locale
cd "$JLT_SOURCE_DIR"
awk -F'\t' '
    FILENAME ~ /manifest/ { if (FNR > 1) table[$1] = $5; next }
    FILENAME ~ /sympy/ && FNR > 1 && $8 != table[$1] && !($1 in stale) {
        print $1 ": SymPy counted another table (tools/bench/sympy_counts.py counts anew)"; stale[$1] = failed = 1
    }
    FILENAME ~ /sympy/ { if (FNR > 1) theirs[$1 FS $2 FS $3 FS $4 FS $5] = $6; next }
    BEGIN { more["spherical_top_track" FS "-" FS "-" FS "-" FS "observe_values"] = 1 }
    FNR > 1 {
        key = $1 FS $2 FS $3 FS $4 FS $5
        if (!(key in theirs)) { print key ": not in sympy_counts.tsv"; failed = 1; next }
        if ($6 > theirs[key] + more[key]) { print key ": " $6 " operations, SymPy " theirs[key]; failed = 1 }
        seen++; ours += $6; sympy += theirs[key]
    }
    END {
        print seen + 0 " kernels: " ours " operations, SymPy " sympy
        exit failed || seen == 0
    }' generated/manifest.tsv tests/bench/sympy_counts.tsv generated/counts.tsv
