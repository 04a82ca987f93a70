#!/usr/bin/env bash
# Closed forms of the spherical top serve for a table of one's own by a proved reduction, in whatever order its states
# stand; else the record is named that is missing, or the claim that fails.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
set -e
models=$JLT_SOURCE_DIR/codegen/models
rows() { grep -v '^#' "$1" | tail -n +2; }

# same A B BOUND: the numbers of the rows, one after another
same() {
    [ "$(rows "$1" | wc -l)" -gt 0 ] || fail "$1: no row"
    paste <(rows "$1" | tr , '\n') <(rows "$2" | tr , '\n') | awk -F'\t' -v bound="$3" '
        $1 ~ /^[-+0-9.]/ { d = $1 - $2; if (!(d * d <= bound * bound)) { bad++ } }
        $1 !~ /^[-+0-9.]/ && $1 != $2 { bad++ }
        END { if (bad) print bad, "fields differ"; exit bad > 0 }' || fail "$1 and $2 differ"
}
# run STATUS OUT ARGUMENTS...
run() {
    local want=$1 out=$2 got=0
    shift 2
    jellett "$@" > "$scratch/$out" 2> "$scratch/err" || got=$?
    [ "$got" = "$want" ] || fail "$*: status $got, not $want: $(tail -1 "$scratch/err")"
}
says() { grep -qF -- "$1" "$scratch/err" || fail "does not say '$1': $(tail -1 "$scratch/err")"; }

# The top with v_nu as its first state.
sed -e '/^eliminate/d; /^observe/d; /^valid/d; /^# Fixed points/,/^leftnull precession/d; /^# Energy on the section/,/^    when/d' \
    -e '/^equal/,/^    when/d; /^lift/,$d; s/^model .*/model other/' \
    -e '/^state gamma3/{h; d}; /^state v_nu/G' \
    "$models/spherical_top.tt" > "$scratch/other.tt"
cp "$models/spherical_top_level.tt" "$models/spherical_top_balanced.tt" "$models/spherical_top_plane.tt" "$scratch"

surface=(--set I1=2/5,I3=1/4 --level E=1,G=-0.2,F0=0.15)
run 0 known portrait "${surface[@]}"
run 0 own portrait "$scratch/other.tt" "${surface[@]}"
same "$scratch/own" "$scratch/known" 0
start=gamma3=0.5,v_nu=0.8,omega_n=0.1,omega3=0.9
from=(--set I1=2/5,I3=1/4 --start $start,omega_tau=0.15 --orbits 3)
run 0 known portrait "${from[@]}" --trajectories "$scratch/known_orbits"
run 0 own portrait "$scratch/other.tt" "${from[@]}" --trajectories "$scratch/own_orbits"
for name in "" _orbits; do same "$scratch/own$name" "$scratch/known$name" 0; done

rod=(--set I1=0.7,a3=0.3 --check)
start=gamma3=0.2,v_nu=0.6,omega_n=1.3,omega3=-0.8
run 0 known rod "${rod[@]}" --start $start,omega_tau=0.4
run 0 own rod "$scratch/other.tt" "${rod[@]}" --start $start,omega_tau=0.4
same "$scratch/own" "$scratch/known" 1e-14
orbit=(--set I1=0.7,a3=0.3,I3=0 --until 7 --every 1)
run 0 known simulate "$scratch/other.tt" "${orbit[@]}" --start $start,omega_tau=0.4 --tier level
run 0 own simulate "$scratch/other.tt" "${orbit[@]}" --start $start,omega_tau=0.4 --tier quadrature
for name in known own; do grep -v '^#' "$scratch/$name" | cut -d, -f 1-6 > "$scratch/$name.cut"; done
same "$scratch/own.cut" "$scratch/known.cut" 1e-11 # ten times the tolerance, as of a return
# A condition that breaks between the rows of quadratures is told as along an orbit, with its time and depth, both ways.
for until in 3 -3; do
    loss=(--set I3=0 --start gamma3=0.26,v_nu=0.8,omega_tau=1.26,omega_n=1.27,omega3=0 --times 0.1,$until)
    [ $until = 3 ] || loss=("${loss[@]/0.1/-0.1}")
    run 0 known simulate "${loss[@]}" --tier level
    lost=$(grep 'contact is lost' "$scratch/err") || fail "no loss by $until"
    run 0 own simulate "${loss[@]}"
    grep -q '# tier quadrature' "$scratch/own" || fail "quadratures do not answer: $(cat "$scratch/own")"
    says "$lost"
    [ "$(rows "$scratch/own" | sed 's/.*,//' | xargs)" = "alive lost_contact" ] || fail "by $until: $(rows "$scratch/own")"
done
# Beyond the steps of that motion quadratures go on, to a state with the integrals of the start.
run 0 own simulate --set I3=0 --start gamma3=-0.1,v_nu=0.8,omega_tau=0.26,omega_n=1.27,omega3=0 --times 0.1,4e6
says "whether contact holds from there on is not known"
rows "$scratch/own" | awk -F, '{ ok = $7 < 1e-14 && $8 < 1e-14; fates = fates $NF }
    END { exit !(ok && fates == "aliveunknown_contact") }' || fail "a late time: $(rows "$scratch/own")"

# What is missing, and what is false.
run 3 out portrait lorenz
says "known of the states of spherical_top alone, and lorenz differs in the state gamma3"
awk '/^[a-z]/ { out = $1 == "reduction" } !out' "$scratch/other.tt" > "$scratch/bare.tt"
run 3 out portrait "$scratch/bare.tt" "${surface[@]}"
says "'reduction NAME : by spherical_top_balanced.tt with gamma3 = ..., v_slip = ..., psi = ...'"
run 3 out rod "$scratch/bare.tt" --set I1=0.7,a3=0.3 --start $start,omega_tau=0.4
says "'reduction NAME : by spherical_top_level.tt with gamma3 = ..., v_nu = ..., omega_tau = ..., v_tau = ...'"
sed -i 's/^    - m\*R\*I1\*omega_n\*V\/Theta/&\n    - omega_n*I3\/I1/' "$scratch/other.tt"
run 3 out portrait "$scratch/other.tt" "${surface[@]}"
says "'reduction momentum'"
run 3 out rod "$scratch/other.tt" --set I1=0.7,a3=0.3 --start $start,omega_tau=0.4
says "'reduction level'"
exit $status
