#!/usr/bin/env bash
# No kernel takes more operations than generated/counts.tsv says: a change of the optimizer that costs operations is seen,
# and has to be made known by regenerating that file.
set -euo pipefail
cd "$JLT_SOURCE_DIR"
LC_ALL=C ttc cost --effort full codegen/models/*.tt | awk -F'\t' '
    NR == FNR { if (FNR > 1) known[$1 FS $2 FS $3 FS $4 FS $5] = $6; next }
    FNR > 1 {
        key = $1 FS $2 FS $3 FS $4 FS $5
        if (!(key in known)) { print key ": not in generated/counts.tsv"; failed = 1 }
        else if ($6 > known[key]) { print key ": " $6 " operations, " known[key] " in generated/counts.tsv"; failed = 1 }
        seen++
    }
    END { if (seen == 0) { print "no kernels"; failed = 1 } exit failed }' generated/counts.tsv -
