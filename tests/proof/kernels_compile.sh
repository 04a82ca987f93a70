#!/usr/bin/env bash
# Kernels of tables that are not the project's own compile as C11 without a warning, with and without the instruction sets
# that the batched ones are meant for. One table has claims that are false, for provers to refute: hence --unproved.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
warnings=(-std=c11 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wstrict-prototypes -Werror)
ttc generate --unproved --out "$scratch" "$JLT_SOURCE_DIR"/tests/proof/models/*.tt
cd "$scratch"
for source in */[!b]*.c; do
    case $source in *_ball.c) continue ;; esac
    "$JLT_CC" "${warnings[@]}" -I. -fsyntax-only "$source"
done
for source in */batch_*.c; do "$JLT_CC" "${warnings[@]}" -I. -c "$source" -o /dev/null; done
