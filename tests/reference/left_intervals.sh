#!/usr/bin/env bash
# Orbits of a table of one's own that leave the interval of a state: where they end, one at a time and in batches.
set -uo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
export TMPDIR=$scratch XDG_CACHE_HOME=$scratch/cache
status=0
fail() { echo "$*"; status=1; }
section() { # FILE OPTION...: rows without comments
    local file=$1
    shift
    jellett section "$@" > all.csv 2> err || fail "section $*: $(cat err)"
    grep -v '^#' all.csv > "$file"
}

# g = g0 + p t - t^2/8: three orbits leave |g| < 1 before the first return, two of them over the top, and one after it.
cat > fall.tt <<'T'
model fall
state g in (-1, 1)
state p
state h
state q
eq g = p
eq p = - 1/4
eq h = q
eq q = - h
T
falling=(./fall.tt --section h=0 --returns 3)
for at in g=0,p=0.1 g=0,p=0.75 g=-0.9,p=1 g=-0.9,p=0.95; do falling+=(--start "$at,q=1"); done
section one.csv --method gauss "${falling[@]}"
section many.csv "${falling[@]}"
cmp -s <(cut -d, -f1,2,7 one.csv) <(cut -d, -f1,2,7 many.csv) || fail "where orbits leave an interval, orbits, returns or fates differ"
[ "$(grep -c ',left_domain$' many.csv)" -eq 4 ] || fail "not all orbits leave the interval: $(cat many.csv)"
exit $status
