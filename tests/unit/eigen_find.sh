#!/usr/bin/env bash
# `jellett eigen --find` holds the states that were given, the first ones longest, and moves the others. Oracle: with a3 = 0 the
# equilibria are omega_tau = omega_n = 0, everything else free.
set -uo pipefail
status=0
finds() { # GIVEN WORDS: states that are found
    local state
    state=$(jellett eigen --set a3=0 --find --at "$1" | grep '^state ')
    for word in $2; do [[ " $state " == *" $word "* ]] || { echo "--at $1: $state, not $word"; status=1; }; done
}
finds gamma3=0.3,v_nu=0.7,omega3=1.1 "gamma3=0.3 v_nu=0.7 omega_tau=0 omega_n=0 omega3=1.1"
finds gamma3=0.3,v_nu=0.7,omega3=1.1,omega_tau=0.2,omega_n=0.1 "gamma3=0.3 v_nu=0.7 omega3=1.1"
finds v_nu=0.5,omega3=1.1,gamma3=0.25,omega_n=0.3 "gamma3=0.25 v_nu=0.5 omega3=1.1"
exit $status
