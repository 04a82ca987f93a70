#!/usr/bin/env bash
# The documentation keeps pace with the programs: every command that --help names is in the man page with its options, and in the
# page of commands; man pages are well-formed; every page is reached from README.md, and stands in the contents of
# the site; every program and file that a page names exists; examples can be copied.
set -euo pipefail
awk() { LC_ALL=C command awk "$@"; } # numbers have points in any locale
cd "$JLT_SOURCE_DIR"
status=0
fail() { echo "$*"; status=1; }
# Where a line just fits, argp decides by memory that it never wrote.
comes_out_once() {
    [ "$(MALLOC_PERTURB_=33 "$@" --help)" = "$(MALLOC_PERTURB_=223 "$@" --help)" ] ||
        fail "$* --help: a line that is as wide as the page comes out in two ways (word it otherwise)"
}

for program in ttc jellett; do
    # A command stands first on its line, indented by two: alone, or followed by its arguments or its description.
    commands=$($program --help | awk -v name=$program '/^  [a-z][a-z-]*( |$)/ && $1 != name { print $1 }' | sort -u)
    [ -n "$commands" ] || fail "$program --help: no line '  COMMAND ...' found"
    comes_out_once $program
    ! $program --help | grep -nE '^.{80}' || fail "$program --help: a line is longer than those of its commands"
    for command in $commands; do
        page=$JLT_BINARY_DIR/man/$program-$command.1
        grep -qx "\.It Xr $program-$command 1" "$JLT_BINARY_DIR/man/$program.1" || fail "$program.1: '$command' is missing"
        for section in NAME SYNOPSIS DESCRIPTION OPTIONS ENVIRONMENT FILES 'EXIT STATUS' 'SEE ALSO'; do
            [ "$(grep -cx "\.Sh $section" "$page")" = 1 ] || fail "$page: no section $section"
        done
        ! grep -nE '^ +(jellett|ttc) ' "$page" > /dev/null || grep -qx '\.Sh EXAMPLES' "$page" || fail "$page: no examples"
        grep -qE "\b$program $command\b" tools/docs/commands.md ||
            fail "tools/docs/commands.md: '$program $command' is not mentioned"
        comes_out_once $program "$command"
        # An indented line behind the options that argp has wrapped goes on at the left edge.
        $program "$command" --help | awk -v what="$program $command --help" '
            indented && /^[^ ]/ { print what ": wrapped: " last; wrapped = 1 }
            { indented = behind && /^  /; last = $0 }
            / --usage / { behind = 1 }
            END { exit wrapped }' || status=1
        while IFS= read -r name; do
            [ -e "$name" ] || fail "$program $command --help: an example names $name, which does not exist"
        done < <($program "$command" --help | grep -E '^  (jellett|ttc) |^    --' | grep -oE '\b(tools|codegen|tests)/[^ ]+')
        # Where an option's line is full, argp may write the margin of what follows before it: another length of either mends it.
        ! $program "$command" --help | grep -nE '^  -.,  +--' || fail "$program $command --help: an option stands behind the margin"
        # Likewise before a line of a description, which stands in column 30 of jellett, in 29 of ttc.
        ! $program "$command" --help | awk '/^ +-\?, --help/ { exit }
            /^(  -., |      )--/ { options = 1; next } options && !/^$/ && !/^ [A-Z]/' | grep -vE '^ {29,30}[^ ]' ||
            fail "$program $command --help: a description stands beside its margin"
        for option in $($program "$command" --help | grep -oE -- '--[a-z][a-z-]*' | sort -u); do
            option=${option#-}
            grep -qF -- "${option//-/\\-}" "$page" || fail "$page: -$option is missing"
        done
        listed=$($program "$command" --help | grep -cE '^(  -., |      )--[a-z]')
        [ "$(grep -c '^\.It Fl ' "$page")" = "$listed" ] || fail "$page: other options than --help lists"
    done
done

! grep -nE '^@|^  .{100}' "$JLT_BINARY_DIR"/man/*.1 ||
    fail "^ a man page has what its template was to be replaced by, or a line that no terminal shows whole"
if command -v mandoc > /dev/null; then
    mandoc -T lint -W warning "$JLT_BINARY_DIR"/man/*.1 || status=1
else echo "skipped: mandoc, which looks at man pages, is not installed"; fi

# What a page types in code: scripts and files of the source exist, commands of the programs exist. (Transcripts of refusals, which
# are run, type what does not.)
mapfile -t pages < <(find README.md codegen generated src tests tools -name '*.md' ! -path '*/results/*' ! \
    -path 'tests/transcripts/*' | sort)
[ ${#pages[@]} -ge 10 ] || fail "only ${#pages[@]} pages are found"
for page in "${pages[@]}"; do
    while IFS= read -r name; do
        [ -e "$name" ] || fail "$page: $name does not exist"
    done < <(grep -oE '\b(tools|codegen|src|tests|generated)/[A-Za-z0-9_./-]*[A-Za-z0-9_/]' "$page" | grep -vE 'NAME|ROOM' |
        sort -u)
    while read -r program command; do
        help=$($program --help)
        grep -qE "^  $command\b" <<< "$help" || fail "$page: '$program $command' is no command"
    done < <(grep -oE '(^    |^\$ |`)(build/bin/)?(ttc|jellett) [a-z]+' "$page" | sed -E 's/^( +|\$ |`)(build\/bin\/)?//' | sort -u)
done

# The walk through the source: rows "| step | `file` | `function` | ..." name a function that the file has.
walked=0
while IFS='|' read -r _ _ file function _; do
    file=${file//[\` ]/} function=${function//[\` ]/}
    walked=$((walked + 1))
    grep -qE "^[a-z].*\b$function\(" "$file" || fail "src/README.md: $file has no function $function"
done < <(grep -E '^\| [a-zA-Z]+ \| `[a-z]+/[a-z_/]+\.c` \| `[a-z_0-9]+` \|' src/README.md)
[ $walked -ge 20 ] || fail "src/README.md: only $walked steps name a file and a function"

# The page of the library: functions that it names are declared, and it names every header that jellett.h includes.
mapfile -t headers < <(sed -n 's/^#include "\(.*\)"/\1/p' src/jellett.h)
for function in $(grep -oE '\bjlt_[a-z_0-9]+' tools/docs/library.md | sort -u); do
    (cd src && grep -qwE "$function" "${headers[@]}") ||
        fail "tools/docs/library.md: no header that jellett.h includes has $function"
done
for header in "${headers[@]}"; do
    grep -qF "\`$header\`" tools/docs/library.md || fail "tools/docs/library.md: $header is not mentioned"
done

# Every script of the tools says on --help how it is used, and does nothing else.
scripts=0
while IFS= read -r script; do
    scripts=$((scripts + 1))
    usage=$("$script" --help < /dev/null 2> /dev/null) && [[ ${usage%%$'\n'*} = *usage:* ]] || fail "$script --help: '$usage'"
done < <(grep -rlE '^(# |""")?usage: (tools|sbatch)' tools | xargs -I{} find {} -perm -u+x)
[ $scripts -ge 15 ] || fail "only $scripts scripts say how they are used"

[ "$(wc -l < README.md)" -le 150 ] || fail "README.md is longer than 150 lines"

# From README.md every page is at most two links away.
linked() { grep -oE '\]\([^)# ]+\.md\)' "$1" | sed -E 's/^\]\(|\)$//g' |
    while IFS= read -r to; do realpath -m --relative-to=. "$(dirname "$1")/$to"; done; }
reached=$({ echo README.md; linked README.md; linked README.md | while IFS= read -r page; do linked "$page"; done; } | sort -u)
for page in "${pages[@]}"; do
    case $page in tests/reference/data/*) continue ;; esac
    grep -qxF "$page" <<< "$reached" || fail "$page is not reached from README.md"
done

# tools/docs/render takes no page that the site's contents leave out.
for page in "${pages[@]}"; do
    case $page in README.md | generated/*) continue ;; esac
    grep -qxF "${page%.md}" tools/docs/site/contents.md.in || fail "tools/docs/site/contents.md.in: $page is not mentioned"
done
exit $status
