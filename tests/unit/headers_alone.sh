#!/usr/bin/env bash
# Every header compiles alone, and twice over, under the strict warnings, with the compiler of the build. A header that a source
# file includes before all others was compiled alone with that file; the rest is compiled here. What has a guard may come twice.
set -euo pipefail
cd "$JLT_SOURCE_DIR"
warnings=(-std=c11 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wstrict-prototypes -Werror -D_POSIX_C_SOURCE=200809L)
# lanes.h is compiled once for each width, which its includer defines.
flags=(-Isrc -Igenerated -Icodegen -DJLT_LANES=2)
folders=(src codegen generated tools/bench/program)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

find "${folders[@]}" -name '*.c' -o -name '*.cc' | xargs awk '
    FNR == 1 { first = 1 }
    /^#include/ && first { first = 0; if ($2 ~ /^"/) print substr($2, 2, length($2) - 2) }' | sort -u > "$scratch/first"
find "${folders[@]}" -name '*.h' | sort > "$scratch/headers"
xargs awk '
    FNR == 1 { line = 0 }
    /^#/ && ++line == 1 { name = $1 == "#ifndef" ? $2 : "" }
    /^#/ && line == 2 && $1 == "#define" && $2 == name { print FILENAME }
' < "$scratch/headers" > "$scratch/guarded"
status=0 compiled=0
while IFS= read -r header; do
    name=${header#*/}
    name=${name#bench/program/}
    grep -qxF "$header" "$scratch/guarded" || { echo "$header: does not begin with #ifndef NAME, #define NAME"; status=1; }
    ! grep -qxF "$name" "$scratch/first" || continue
    compiled=$((compiled + 1))
    # Macros are the whole of some headers, and an empty translation unit is not C: hence the declaration.
    printf '#include "%s"\nextern int nothing;\n' "$PWD/$header" > "$scratch/alone.c"
    "$JLT_CC" "${warnings[@]}" "${flags[@]}" -fsyntax-only "$scratch/alone.c" ||
        { echo "$header: does not compile alone"; status=1; }
done < "$scratch/headers"
[ $status -ne 0 ] || echo "$(wc -l < "$scratch/headers") headers compile alone, $compiled of them here"
exit $status
