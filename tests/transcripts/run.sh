#!/usr/bin/env bash
# usage: tests/transcripts/run.sh [--update] PAGE.md
#
# Runs what a page types, and holds what comes out against what the page shows. A page is Markdown; a block fenced as
# ```console is a transcript:
#
#     $ ttc prove codegen/models/lorenz.tt     a command; a backslash at its end continues it on the next line
#     lorenz: 2 claims                         what it says, standard output and standard error together
#     ...                                      a line of three dots alone stands for any number of lines
#     table ...                                dots after a blank at the end of a line, for any end of that line
#     [no end of line]                         follows a last line that has none
#     [status 1]                               the exit status, where it is not 0
#
# Commands of a page run one after another, each by bash with no standard input, in one new folder with links to the folders
# of the source and with a cache of its own. A line that is not the same to the letter still agrees if its text does and its
# numbers do. Whole numbers are counts and parts of fractions: they must be the same. Others, with a point or an exponent, may
# differ by 1e-6 of the larger, by their sign if they are pi, or if both are below 1e-9: machines sum in vectors of different width,
# so that results differ by some 1e-12, the default tolerance, times what an orbit amplifies, by up to 1e4 on a page; 1e-6 leaves a
# factor of a hundred, and is no more than what six digits show. Below 1e-9 are drifts and residuals, which are rounding noise. A
# line <!-- within 1e-9 --> before a block says another bound for this block alone, with noise up to a thousandth of it; within 0
# wants equal values. Blanks beside a number that differs may differ with it.
#
# The line of JSON in which tables repeat their settings is passed over: it has the digests of tables. What vectors the machine has
# is three dots always, so that no page is written that holds on one make of processor alone.
#
# --update writes what comes out into the page, where it does not agree; lines that agree stay as they are, but for three dots
# alone. Exit status: 0 the page is right, 1 it is not (or was not, with --update), 2 usage.
set -uo pipefail

update=false
if [ "${1-}" = --update ]; then
    update=true
    shift
fi
if [ $# -ne 1 ] || [ ! -r "$1" ]; then
    sed -n '2s/^# //p' "$0" >&2
    exit 2
fi
page=$(readlink -f "$1")
house=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mktemp -d)
scratch=$(mktemp -d)
trap 'rm -rf "$folder" "$scratch"' EXIT
for room in codegen generated tests tools; do ln -s "$house/$room" "$folder/$room"; done
export XDG_CACHE_HOME=$scratch/cache LC_ALL=C.UTF-8 # pictures have Greek letters

status=0
place= command= within=1e-6

# Run the command that was read, judge it, and pass on what the page is to show.
finish() {
    local code fault=
    [ -n "$command" ] || return 0
    # A pipe has buffers of the same size everywhere, on which it hangs how the two outputs mix.
    (cd "$folder" && exec bash -c "$command") 2>&1 < /dev/null |
        sed '/^# {"command":/d; s/\(many orbits at once by [a-z0-9]* on \).*/\1.../' > "$scratch/actual"
    code=${PIPESTATUS[0]}
    [ -z "$(tail -c 1 "$scratch/actual")" ] || printf '\n[no end of line]\n' >> "$scratch/actual"
    [ $code -eq 0 ] || echo "[status $code]" >> "$scratch/actual"
    if LC_ALL=C awk -v within="$within" -f "$house/tests/transcripts/agree.awk" "$scratch/expected" "$scratch/actual" > \
        "$scratch/near"; then
        cat "$scratch/expected" >> "$scratch/page"
    else
        status=1
        echo "$place: \$ $command"
        diff -u --label expected --label actual "$scratch/expected" "$scratch/near" | tail -n +3
        cat "$scratch/near" >> "$scratch/page"
    fi
    command=
}

in_block=false in_command=false number=0
: > "$scratch/page"
while IFS= read -r line || [ -n "$line" ]; do
    number=$((number + 1))
    if ! $in_block; then
        case $line in
            '```console') in_block=true ;;
            '<!-- within '*' -->') within=${line#'<!-- within '} within=${within%' -->'} ;;
        esac
    elif $in_command; then
        command+=$'\n'$line
    elif [ "$line" = '```' ]; then
        finish
        in_block=false within=1e-6
    elif [ "${line:0:2}" = '$ ' ]; then
        finish
        command=${line:2} place=${page#"$house/"}:$number
        : > "$scratch/expected"
    elif [ -n "$command" ]; then
        printf '%s\n' "$line" >> "$scratch/expected"
        continue
    fi
    printf '%s\n' "$line" >> "$scratch/page"
    in_command=false
    if $in_block && [ -n "$command" ] && [ "${line: -1}" = '\' ]; then in_command=true; fi
done < "$page"
if $in_block; then
    echo "${page#"$house/"}: the last block has no end"
    exit 1
fi
if $update && ! cmp -s "$scratch/page" "$page"; then cat "$scratch/page" > "$page"; fi
exit $status
