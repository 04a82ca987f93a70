# Read by tests that run in a folder of their own, which is removed in the end: where they are, and how they say what is wrong.
# Numbers have points, and tables are compiled anew.
set -uo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
export TMPDIR=$scratch XDG_CACHE_HOME=$scratch/cache LC_ALL=C
status=0
fail() { echo "$*"; status=1; }
# STATUS WORDS COMMAND...: it ends with this status, and says the words, a pattern of grep -E, on either output; '': no matter what.
expect() {
    local want=$1 words=$2 code
    shift 2
    "$@" > out 2> err < /dev/null
    code=$?
    [ $code -eq "$want" ] || fail "$*: status $code, not $want: $(head -c 300 err)"
    [ -z "$words" ] || grep -qE -- "$words" out err ||
        fail "$*: '$words' is in neither '$(head -c 300 out)' nor '$(head -c 300 err)'"
}
# The same with a text to the letter.
expect_text() { expect "$1" "$(sed 's/[][(){}.*+?^$|\\]/\\&/g' <<< "$2")" "${@:3}"; }
