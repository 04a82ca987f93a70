#!/usr/bin/env bash
# Nothing in src/ knows a model: no name of a model, state, parameter, or observed quantity of the project's tables, of two letters
# or more, stands outside src/top/, but in examples of help texts: lines of a parser's text that are indented, as --help shows them.
# What spells Greek letters is left out: it has all of them.
set -euo pipefail
cd "$JLT_SOURCE_DIR"

# Greek letters are everybody's.
common=' alpha beta chi gamma mu psi rho sigma '
names=$({ echo eta; awk '$1 ~ /^(model|state|param|observe)$/ && length($2) > 1 { print $2 }' codegen/models/*.tt | sort -u; } |
    while read -r name; do [[ $common == *" $name "* ]] || printf '%s|' "$name"; done)

mapfile -t files < <(find src -type f ! -path 'src/top/*' ! -path src/report/symbol.c ! -name README.md | sort)
if found=$(awk -v names="(^|[^A-Za-z0-9_])(${names%|})([^A-Za-z0-9_]|\$)" '
    FNR == 1 { help = 0 }
    /^static const struct argp / { help = 1 }
    !(help && $0 ~ /^ +"(\\v)?  /) && $0 ~ names { print FILENAME ":" FNR ": " $0 }
    /^};/ { help = 0 }' "${files[@]}") && [ -n "$found" ]; then
    printf '%s\n^ a name of a model outside src/top/\n' "$found"
    exit 1
fi
echo "${#files[@]} files know no model (names looked for: $(tr '|' '\n' <<< "${names%|}" | wc -l))"
