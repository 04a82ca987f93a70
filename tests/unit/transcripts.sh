#!/usr/bin/env bash
# tests/transcripts/run.sh passes what agrees and nothing else: each page below is one transcript, that must pass or fail.
set -uo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
run=$JLT_SOURCE_DIR/tests/transcripts/run.sh
status=0
fail() { echo "$*"; status=1; }
page() { printf '%s\n' "${within:+<!-- within $within -->}" '```console' "$@" '```' > "$scratch/page.md"; }
passes() { page "$@"; bash "$run" "$scratch/page.md" > "$scratch/out" 2>&1 || fail "does not pass: $*: $(cat "$scratch/out")"; }
fails() { page "$@"; bash "$run" "$scratch/page.md" > "$scratch/out" 2>&1 && fail "passes: $*"; }
within=

passes '$ true'
fails '$ true' 'word'
fails '$ echo word'
fails '$ false'
passes '$ false' '[status 1]'
fails '$ false' '[status 2]'
passes '$ echo out; echo err >&2' out err
passes '$ echo a \' '    b' 'a b'
passes '$ printf unfinished' unfinished '[no end of line]'
fails '$ printf unfinished' unfinished
fails '$ echo finished' finished '[no end of line]'
passes '$ echo one > file' '$ cat file' one
passes '$ cat' # nothing to read
passes '$ ls' codegen generated tests tools

passes '$ echo x=0.5000001,y' x=0.5,y
fails '$ echo x=0.500001,y' x=0.5,y
fails '$ echo x=0.5,z' x=0.5,y
passes '$ echo 1e-10' -2e-11
fails '$ echo 1.1e-9' 0
passes '$ echo -0.0' 0
fails '$ echo 1000001' 1000000
fails '$ echo 1/3' 2/3
fails '$ echo 5' -5
fails '$ echo "  1"' '1'
passes '$ echo "| 1.5 |"' '|  1.50000001 |'
passes '$ echo a-1.5' a-1.50000001
passes '$ echo nan' nan
fails '$ echo nan' inf
fails '$ echo "1.5 2.5"' 1.5
within=1e-9
fails '$ echo 0.5000001' 0.5
passes '$ echo 0.5000000001' 0.5
fails '$ echo 1e-10' 2e-11
within=0
fails '$ echo 1e-300' 0
within=

passes '$ seq 9' ... 9
passes '$ seq 9' 1 ... 4 5 ... 9
passes '$ seq 9' 1 ...
passes '$ true' ...
passes '$ printf "1\n2\n1\n3\n"' ... 1 3
fails '$ seq 9' 1 ... 8
fails '$ seq 9' ... 5 4 ...
fails '$ seq 9' 2 ...
fails '$ echo 1' 1 ... 1
passes '$ echo table 1 a' 'table 1 ...'
fails '$ echo table 2 a' 'table 1 ...'
fails '$ echo table 2 a' 'table...'

printf '%s\n' text '```console' '$ echo 2.00000001' 2 '$ seq 9' 1 ... 9 '$ echo new; false' old '```' end > "$scratch/page.md"
bash "$run" --update "$scratch/page.md" > "$scratch/out" && fail "--update: a page that was wrong passes"
grep -qx -- '-old' "$scratch/out" || fail "what differs is not shown: $(cat "$scratch/out")"
grep -q -- 'echo 2' "$scratch/out" && fail "what agrees is shown: $(cat "$scratch/out")"
printf '%s\n' text '```console' '$ echo 2.00000001' 2 '$ seq 9' 1 ... 9 '$ echo new; false' new '[status 1]' '```' end |
    diff - "$scratch/page.md" || fail "--update writes another page"
printf '%s\n' '```console' '$ true' > "$scratch/page.md"
bash "$run" "$scratch/page.md" > "$scratch/out" && fail "a block without an end passes"
bash "$run" > "$scratch/out" 2>&1
[ $? -eq 2 ] || fail "no page: status"
exit $status
