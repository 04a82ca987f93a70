#!/usr/bin/env bash
# `ttc prove --kernels` proves all kernels of the unseen tables, those with functions among them: in a second what
# proof.test_kernels says of every table.
set -u
cd "$JLT_SOURCE_DIR/tests/proof/models" || exit 1
status=0
for table in $(grep -L "^lift into " ./*.tt); do # coordinates of a section have no field
    # Claims of these tables are refuted as well, which the exit status says. A family that is not proved has no right kernels.
    ttc prove --kernels --json "$table" 2> /dev/null |
        jq -e '[.claims[] | select(.kind == "equilibria" and .status != "proved") | .name] as $open |
               [.claims[] | select(.kind == "kernel" and (.name | split(".")[1] | IN($open[]) | not)) | .status] |
               length > 0 and all(. == "proved")' > /dev/null ||
        { echo "$table: not all kernels are proved"; status=1; }
done
exit $status
