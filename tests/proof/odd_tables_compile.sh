#!/usr/bin/env bash
# Whatever a table may leave out or be called, what is written of it compiles as C11 without a warning, scalar, batched and ball
# kernels: tables without parameters, without claims, of zero fields, with families that nothing is free in, an eliminated state
# that nothing uses, and names that C or the code written gives a meaning to. Every kernel of theirs is proved.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
warnings=(-std=c11 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wstrict-prototypes -Werror)
tables=("$JLT_SOURCE_DIR"/tests/proof/odd/*.tt)
[ "${#tables[@]}" -ge 20 ]
ttc generate --out "$scratch" "${tables[@]}"
ttc prove --kernels "${tables[@]}" > /dev/null
cd "$scratch"
for source in *.c */*.c; do "$JLT_CC" "${warnings[@]}" -I. -fsyntax-only "$source"; done
