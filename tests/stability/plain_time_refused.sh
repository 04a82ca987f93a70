#!/usr/bin/env bash
# An orbit into a pole: in plain time the command says where it stops and what to do, status 4; else it tells the end, status 0.
set -euo pipefail
orbit=(--set 'a3=0.51,I1=1/3,I3=1/3' --start gamma3=0.2,v_nu=-1.56,omega_tau=0,omega_n=-0.3,omega3=1.2 --until 20 --every 5)
said=$(mktemp)
trap 'rm -f "$said"' EXIT
for tier in five_plain level_plain level_omega_n; do
    status=0
    jellett simulate --tier "$tier" "${orbit[@]}" > "$said" 2>&1 || status=$?
    [ "$status" -eq 4 ] || { echo "$tier: status $status, expected 4"; cat "$said"; exit 1; }
    grep -q 'at t = 2.31.* near a pole .*leave out --tier' "$said" || { echo "$tier: not said"; cat "$said"; exit 1; }
    if grep -qi 'nan\|inf,' "$said"; then echo "$tier: a number that is none"; cat "$said"; exit 1; fi
done
jellett simulate "${orbit[@]}" > "$said" 2>&1
grep -q 'reaches the pole gamma3 = -1 at t = 2.31' "$said"
