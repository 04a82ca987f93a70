#!/usr/bin/env bash
# What a command of ttc says of several tables is what it says of each alone, one after the other.
set -uo pipefail
awk() { LC_ALL=C command awk "$@"; } # numbers have points in any locale
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$JLT_SOURCE_DIR/codegen/models" || exit 1
status=0
tables=(lorenz.tt lotka_volterra.tt nose_hoover.tt)

alike() { # COMMAND...
    for table in "${tables[@]}"; do "$@" "$table" || exit 1; done > "$scratch/alone"
    "$@" "${tables[@]}" > "$scratch/together" || { echo "$*: status $?"; status=1; }
    # Counts have one line of titles.
    awk 'NR == 1 || !/^model\t/' "$scratch/alone" | cmp - "$scratch/together" ||
        { echo "$*: together is not what each is alone"; status=1; }
}
alike ttc check
alike ttc cost
alike ttc prove
alike ttc show
for command in check prove cost; do
    ttc $command --json "${tables[@]}" > "$scratch/together"
    for table in "${tables[@]}"; do ttc $command --json "$table"; done |
        jq -s 'map(if type == "array" then .[] else . end)' > "$scratch/alone"
    jq . "$scratch/together" | cmp - "$scratch/alone" ||
        { echo "ttc $command --json: together is not what each is alone"; status=1; }
done
exit $status
