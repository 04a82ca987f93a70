#!/usr/bin/env bash
# That conditions have no real point is believed if Z3 and QEPCAD both find it: not with a QEPCAD that finds a point, that is not
# sure, that says nothing, breaks off or waits, and nothing is proved without one. What signs of terms decide, or complete squares,
# needs neither.
source "$JLT_SOURCE_DIR/tests/scratch.sh"

cat > asked.tt <<'TABLE'
model asked
state x
state y
eq x = y
eq y = -x
positive asked : x^4 - x^3*y + y^4 + 1/8
positive by_terms : x^4 + x^2 + 1
TABLE
mkdir -p bin empty/qepcad # a folder of that name is no program
real=$(command -v qepcad) || fail "qepcad is not in PATH"

verdicts() { # WORDS, of "asked" and of "by_terms"
    PATH=$PWD/bin:$PATH ttc prove asked.tt > out 2> err
    local said
    said=$(sed -nE 's/^(proved|refuted|not settled) +positive .*/\1/p' out | paste -sd,)
    [ "$said" = "$1" ] || fail "'$(sed -n 2,9p bin/qepcad)': $said, not $1"
}
other() { # COMMANDS: what stands in for QEPCAD
    printf '#!/bin/sh\n%s\n' "$1" > bin/qepcad
    chmod +x bin/qepcad
}

other "exec '$real' \"\$@\""
verdicts "proved,proved"
other 'cat > question; printf "An equivalent quantifier-free formula:\n\nTRUE\n"'
verdicts "not settled,proved"
grep -q '^(E x' question || fail "the question is not one for QEPCAD: $(cat question)"
other 'printf "An equivalent quantifier-free formula:\n\nFALSE\n"'
verdicts "proved,proved"
other 'printf "Warning! The projection may not be valid.\nAn equivalent quantifier-free formula:\n\nFALSE\n"'
verdicts "not settled,proved"
other 'printf "FALSE\n"'
verdicts "not settled,proved"
other 'printf "An equivalent quantifier-free formula:\n\n%0255dFALSE\n" 0'
verdicts "not settled,proved"
other 'printf "An equivalent quantifier-free formula:\n%0252dError\n\nFALSE\n" 0'
verdicts "not settled,proved"
other 'kill -9 $$'
verdicts "not settled,proved"
other 'while :; do :; done'
verdicts "not settled,proved"
other 'echo >> asked; [ "$(wc -l < asked)" -gt 1 ] || exec sleep 300'
verdicts "not settled,proved"
[ "$(wc -l < asked)" -eq 2 ] || fail "without roots, there is one order, for each of two searches"

ttc=$(command -v ttc)
for command in prove "generate --out folder" discover build; do
    # shellcheck disable=SC2086
    PATH=$PWD/empty "$ttc" $command asked.tt > out 2> err
    [ $? -eq 5 ] || fail "ttc $command without qepcad: not status 5"
    grep -q 'install it' err || fail "ttc $command without qepcad: says '$(cat err)'"
done
# Without PATH, programs are found where the system has its own.
if [ -x /usr/bin/qepcad ] || [ -x /bin/qepcad ]; then
    env -u PATH "$ttc" build asked.tt > out 2> err || fail "ttc build without PATH: $(cat err)"
fi
# Nor does the verdict of a QEPCAD that failed outlast it in the cache.
{ cat asked.tt; echo 'root r = sqrt(x^4 - x^3*y + y^4 + 1/8)'; echo 'observe side = r'; } > kept.tt
other 'exit 1'
PATH=$PWD/bin:$PATH ttc build kept.tt > out 2> err
grep -q "the root claim 'r' is not settled" err || fail "without an answer of QEPCAD: $(cat out err)"
other "exec '$real' \"\$@\""
PATH=$PWD/bin:$PATH ttc build kept.tt > again 2> err
cmp -s out again && fail "the object made with another QEPCAD is taken: $(cat again err)"
grep -q 'not settled' err && fail "with QEPCAD: $(cat err)"
# Signs alone say that the claim's opposite has no point where x is not 0, the solver that the domain has none at x = 0, where
# x/(1 + r) = (r - 1)/x has a value and its normal form has none.
cat > at_denominator.tt <<'TABLE'
model at_denominator
state x
state y
state z
state g
root r = sqrt(1 + x^2)
domain above : g + x/(1 + r) > 0
domain beside : x - (y^4 + y^3*z + z^4 - y + 1) > 0
eq x = 0
eq y = 0
eq z = 0
eq g = 0
positive same : g + x/(1 + r)
TABLE
ttc prove -v at_denominator.tt > out || fail "at_denominator.tt is not proved"
sed -n '/same/,/proved/p' out | grep -q 'relies on the solver' || fail "the solver is not named: $(cat out)"
PATH=$PWD/empty "$ttc" check asked.tt || fail "ttc check without qepcad fails"
exit $status
