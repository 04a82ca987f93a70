#!/usr/bin/env bash
# The documentation keeps pace with the programs: every command that --help names is in the man page and in the README, every
# option in the man page, and every program and file that the README names exists.
set -euo pipefail
cd "$JLT_SOURCE_DIR"
status=0
fail() { echo "$*"; status=1; }

for program in ttc jellett; do
    help=$($program --help)
    page=$(sed 's/\\-/-/g' "tools/man/$program.1")
    # A command stands first on its line, indented by two: alone, or followed by its arguments or its description.
    commands=$(awk '/^  [a-z][a-z-]*( |$)/ { print $1 }' <<< "$help" | sort -u | grep -vx "$program" || true)
    [ -n "$commands" ] || fail "$program --help: no line '  COMMAND ...' found"
    for command in $commands; do
        grep -qE "^\.It Cm $command( |$)" <<< "$page" || fail "$program.1: no '.It Cm $command'"
        grep -qE "\b$program $command\b" README.md || fail "README.md: '$program $command' is not mentioned"
    done
    for command in $commands; do help+=$'\n'$($program "$command" --help); done
    for option in $(grep -oE -- '--[a-z][a-z-]*' <<< "$help" | grep -vx -- --usage | sort -u); do
        grep -qE "Fl -${option#--}( |$)" <<< "$page" || fail "$program.1: option $option is not mentioned"
    done
    for command in $(sed -n 's/^\.It Cm \([a-z-]*\).*/\1/p' <<< "$page"); do
        grep -qw -- "$command" <<< "$commands" || fail "$program.1: '$command' is no command of $program"
    done
done

# What README.md types in code: scripts of tools/ exist, commands of the programs exist.
while IFS= read -r script; do
    [ -e "$script" ] || fail "README.md: $script does not exist"
done < <(grep -oE '\b(tools|codegen|src|tests|generated)/[A-Za-z0-9_./-]*[A-Za-z0-9_/]' README.md | grep -vw NAME | sort -u)
while read -r program command; do
    $program --help | grep -qE "^  $command\b" || fail "README.md: '$program $command' is no command"
done < <(grep -oE '(^    |`)(build/bin/)?(ttc|jellett) [a-z]+' README.md | sed -E 's/^( +|`)(build\/bin\/)?//' | sort -u)
exit $status
