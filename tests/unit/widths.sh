#!/usr/bin/env bash
# What is written by hand fits a window: lines of source, scripts and build files have at most 132 columns, and a file of C at most
# 400 lines. Tables of models, whose claims stand one a line, generated files, pages, and the scripts that drive other programs in
# tools/bench are not looked at.
set -euo pipefail
awk() { LC_ALL=C command awk "$@"; } # numbers have points in any locale
cd "$JLT_SOURCE_DIR"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# Prints FILE:LINE of what is too wide, and FILE of what is too long; 1 when there is any, or no file.
look() {
    find "$@" -type f \( -name '*.[ch]' -o -name '*.inc' -o -name '*.cc' -o -name '*.cpp' -o -name '*.hpp' -o -name '*.sh' \
        -o -name '*.py' -o -name '*.cmake' -o -name CMakeLists.txt -o ! -name '*.*' \) ! -path 'tools/bench/*.py' \
        ! -path '*/corpus/*' ! -path tools/bench/run -exec awk '
        length($0) > 132 { print FILENAME ":" FNR ": " length($0) " columns, 132 are the most"; bad = 1 }
        FNR == 401 && FILENAME ~ /\.(c|h|inc|cc)$/ { print FILENAME ": more than 400 lines"; bad = 1 }
        END { exit bad || NR == 0 }' {} +
}

look src codegen tests tools CMakeLists.txt

awk 'BEGIN { for (i = 0; i < 400; i++) print ""; printf "%133s\n", "x" }' > "$scratch/bad.c"
! look "$scratch" > "$scratch/said" || { echo "a wide line is not found"; exit 1; }
[ "$(wc -l < "$scratch/said")" = 2 ] || { cat "$scratch/said"; exit 1; }
