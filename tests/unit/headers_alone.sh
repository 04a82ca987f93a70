#!/usr/bin/env bash
# Every header compiles alone, and twice over, under the strict warnings, with the compiler of the build.
set -euo pipefail
cd "$JLT_SOURCE_DIR"
warnings=(-std=c11 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wstrict-prototypes -Werror -D_POSIX_C_SOURCE=200809L)
# lanes.h is compiled once for each width, which its includer defines.
flags=(-Isrc -Igenerated -Icodegen -DJLT_LANES=2)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

headers=()
while IFS= read -r header; do headers+=("$header"); done < <(find src codegen generated tools/bench/program -name '*.h' | sort)
# Macros are the whole of some headers, and an empty translation unit is not C: hence the declaration.
for i in "${!headers[@]}"; do
    printf '#include "%s"\n#include "%s"\nextern int nothing;\n' \
        "$PWD/${headers[i]}" "$PWD/${headers[i]}" > "$scratch/$i.c"
done

status=0
for i in "${!headers[@]}"; do
    "$JLT_CC" "${warnings[@]}" "${flags[@]}" -fsyntax-only "$scratch/$i.c" ||
        { echo "${headers[i]}: does not compile alone"; status=1; }
done
[ $status -ne 0 ] || echo "${#headers[@]} headers compile alone"
exit $status
