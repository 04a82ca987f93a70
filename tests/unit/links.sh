#!/usr/bin/env bash
# Links between pages lead to files that exist, anchors to headings; the checker finds the ones that do not.
set -euo pipefail
cd "$JLT_SOURCE_DIR"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mapfile -t pages < <(find README.md codegen generated src tests tools -name '*.md' | sort)
[ ${#pages[@]} -ge 30 ] || { echo "only ${#pages[@]} pages are found"; exit 1; }
python3 tools/docs/links "${pages[@]}"

printf '%s\n' '# One `name`, twice' '# One name, twice' '[good](#one-name-twice), [good too](#one-name-twice-1)' \
    '`[code](nowhere.md)`' '```' '# [code](nowhere.md)' '```' > "$scratch/good.md"
python3 tools/docs/links "$scratch/good.md" > "$scratch/said" || { cat "$scratch/said"; exit 1; }
printf '%s\n' '# Page' '[no file](nowhere.md)' '[no heading](good.md#one)' '[none here](#pages)' '[a folder](../)' > \
    "$scratch/bad.md"
! python3 tools/docs/links "$scratch/bad.md" > "$scratch/said" || { echo "four faults are not found"; exit 1; }
[ "$(grep -c '^/.*bad.md: the link to' "$scratch/said")" = 4 ] || { cat "$scratch/said"; exit 1; }
