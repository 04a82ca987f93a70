#!/usr/bin/env bash
# The kernels of the small tables are, byte for byte, what ttc writes: in a few seconds what unit.regenerated says of all tables.
set -uo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$JLT_SOURCE_DIR" || exit 1
status=0
for model in lorenz roessler lotka_volterra nose_hoover toda chaplygin_sleigh restricted_three_body spherical_top_balanced \
             spherical_top_plane; do
    ttc generate --effort full --out "$scratch" "codegen/models/$model.tt" &&
        diff -r "$scratch/$model" "generated/$model" > "$scratch/difference" ||
        { echo "generated/$model is not what the table says:"; head -20 "$scratch/difference"; status=1; }
done
exit $status
