#!/usr/bin/env bash
# What a command refuses before it follows an orbit, its plan refuses as well, with the same words and status.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
cat > damped.tt << 'T'
model damped
param c
default c = 1/10
state x
state v
state w
eq x = v
eq v = - x - c*v
eq w = - w
integral H = (x^2 + v^2)/2
equilibria moved : x = 1, v = 0, w = 0
T
both() { # STATUS TEXT COMMAND...
    expect "$1" "$2" jellett "${@:3}"
    tail -1 err > said
    expect "$1" "$2" jellett plan "${@:3}"
    tail -1 err | cmp -s - said || fail "jellett plan ${*:3}: $(tail -1 err)"
}

start=x=0.5,w=0.1
both 3 "H is not proved to be an integral" section ./damped.tt --section v=0 --start $start --project
both 3 "H is not proved to be an integral" section ./damped.tt --section v=0 --grid x=0:1:2,w=0 --project
both 3 "proves no integral" drift ./damped.tt --section v=0 --start $start
both 2 "no integrals to go back to" section lorenz --section z=27 --start x=-13,y=-19 --project
both 2 "multistep" section toda --section q1=0 --start q2=0.1,q3=-0.1,p1=0.2,p2=0,p3=-0.2 --project --method msadams
both 3 "a reversor that takes the section to itself" separation ./damped.tt --section v=0 --grid x=0:1:2,w=0:1:2 --cells 4x4
both 3 "two coordinates, not of 5" separation toda --section q1=0 --grid 2x2 --cells 4x4
both 3 "a section of two coordinates" manifolds toda --section q1=0 --start q2=0.1,q3=-0.1,p1=0.2,p2=0,p3=-0.2
both 3 "a section of two coordinates" manifolds toda --section q1=0
both 2 "say where to search" orbits lorenz --section z=27
both 3 "the section has no coordinate 'q'" orbits lorenz --section z=27 --start x=-13,y=-19 --hold q
both 3 "no coordinate 'q'" orbits lorenz --section z=27 --start x=-13,y=-19 --line q=0:1:3
both 2 "say where orbits start" fates lorenz --section z=27
both 2 "say which boxes" transfer lorenz --section z=27
both 3 "there is no 'q'" continue lorenz --section z=27 --start x=-13,y=-19 --along q=1:2
both 3 "the branch starts at rho=28" continue lorenz --section z=27 --start x=-13,y=-19 --along rho=1:2
both 3 "has no state 'q'" eigen lorenz --at q=1
both 3 "no family of equilibria 'q'" certify equilibria lorenz --family q
both 3 "the equilibria claim moved of this table is not proved: dv/dt on the family = -1" certify equilibria ./damped.tt
both 3 "'q'" certify equilibria lorenz --family conduction --box q=1
expect 2 "check follows no motion" jellett plan check "$JLT_SOURCE_DIR/tools/certificates/sink.json"
expect 2 "merge follows no motion" jellett plan merge study.shards
expect 2 "the plan of a scene is 'jellett plan SCENE'" jellett plan sweep study.scene
# The square of a parameter may be 0 in doubles though the parameter is not.
cat > tiny.tt << 'T'
model tiny
param a > 0
default a = 1
state x
state v
eq x = v
eq v = - x/a^2
T
both 3 "divides by what is 0 or underflows" simulate ./tiny.tt --set a=1e-300 --start x=1,v=0 --times 0,1
expect 3 "divides here by what is 0, or underflows" jellett eigen ./tiny.tt --set a=1e-300 --at x=0,v=0

exit $status
