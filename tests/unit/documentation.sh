#!/usr/bin/env bash
# The documentation keeps pace with the programs: every command that --help names is in the man page with its
# options, and in the README, every program and file that the README names exists, and examples can be copied.
set -euo pipefail
awk() { LC_ALL=C command awk "$@"; } # numbers have points in any locale
cd "$JLT_SOURCE_DIR"
status=0
fail() { echo "$*"; status=1; }

for program in ttc jellett; do
    # A command stands first on its line, indented by two: alone, or followed by its arguments or its description.
    commands=$($program --help | awk -v name=$program '/^  [a-z][a-z-]*( |$)/ && $1 != name { print $1 }' | sort -u)
    [ -n "$commands" ] || fail "$program --help: no line '  COMMAND ...' found"
    for command in $commands; do
        grep -qx "\.Ss $command" "$JLT_BINARY_DIR/man/$program.1" || fail "$program.1: '$command' is missing"
        grep -qE "\b$program $command\b" README.md || fail "README.md: '$program $command' is not mentioned"
        # An indented example that argp has wrapped goes on at the left edge.
        $program "$command" --help | awk -v what="$program $command --help" '
            example && /^[^ ]/ { print what ": wrapped example: " last; wrapped = 1 }
            { example = /^  (jellett|ttc) |^    --/; last = $0 }
            END { exit wrapped }' || status=1
        for option in $($program "$command" --help | grep -oE -- '--[a-z][a-z-]*' | sort -u); do
            grep -qF -- "${option//-/\\-}" "$JLT_BINARY_DIR/man/$program.1" || fail "$program.1: $option is missing"
        done
    done
done

# What README.md types in code: scripts of tools/ exist, commands of the programs exist.
while IFS= read -r script; do
    [ -e "$script" ] || fail "README.md: $script does not exist"
done < <(grep -oE '\b(tools|codegen|src|tests|generated)/[A-Za-z0-9_./-]*[A-Za-z0-9_/]' README.md | grep -vw NAME | sort -u)
while read -r program command; do
    help=$($program --help)
    grep -qE "^  $command\b" <<< "$help" || fail "README.md: '$program $command' is no command"
done < <(grep -oE '(^    |`)(build/bin/)?(ttc|jellett) [a-z]+' README.md | sed -E 's/^( +|`)(build\/bin\/)?//' | sort -u)
exit $status
