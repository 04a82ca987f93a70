#!/usr/bin/env bash
# The exit statuses of ttc and jellett are the documented ones, results go to standard output, and every failure says what
# is wrong on standard error.
source "$JLT_SOURCE_DIR/tests/scratch.sh"

expect() { # STATUS COMMAND...
    local want=$1 code
    shift
    "$@" > "$scratch/out" 2> "$scratch/err" < /dev/null
    code=$?
    if [ $code -ne "$want" ]; then
        fail "$*: status $code, not $want"
        head -5 "$scratch/err"
    elif [ "$want" -ge 2 ] && [ ! -s "$scratch/err" ]; then
        fail "$*: status $want, and nothing on standard error"
    fi
}
into_full() { "$@" > /dev/full; }

cat > "$scratch/good.tt" <<'TABLE'
model oscillator
param k > 0
state x
state v
eq x =
    + v
eq v =
    - k*x
integral E = k*x^2/2 + v^2/2
TABLE
sed 's/+ v^2/+ v^2*x/' "$scratch/good.tt" > "$scratch/refuted.tt"
sed 's/k\*x$/k*y/' "$scratch/good.tt" > "$scratch/bad.tt"
head -c 2000 /dev/urandom > "$scratch/noise.tt"
: > "$scratch/empty.tt"
mkdir "$scratch/folder.tt"

for program in ttc jellett; do
    expect 0 $program --help
    expect 0 $program --version
    expect 2 $program
    expect 2 $program no-such-command
    expect 2 $program --no-such-option
    expect 5 into_full $program --help
    expect 5 into_full $program --version
done

for together in --challenge=3 --kernels --verbose; do expect 2 ttc prove --mutate $together "$scratch/good.tt"; done
expect 2 ttc prove --seed=3 "$scratch/good.tt"

for command in check prove cost show discover; do
    expect 0 ttc $command "$scratch/good.tt"
    expect 3 ttc $command "$scratch/bad.tt"
    expect 3 ttc $command "$scratch/noise.tt"
    expect 3 ttc $command "$scratch/empty.tt"
    expect 5 ttc $command "$scratch/missing.tt"
    expect 5 ttc $command "$scratch/folder.tt"
    expect 2 ttc $command
    expect 2 ttc $command --no-such-option "$scratch/good.tt"
done
for command in prove cost show discover; do
    expect 5 into_full ttc $command "$scratch/good.tt"
    grep -q "No space left on device" "$scratch/err" || fail "ttc $command to a full device: $(cat "$scratch/err")"
    expect 5 into_full ttc $command --help
done
expect 5 into_full ttc prove --json "$scratch/good.tt"
expect 1 ttc prove "$scratch/refuted.tt"
expect 1 ttc prove --json "$scratch/refuted.tt"
expect 0 ttc check "$scratch/refuted.tt"
expect 2 ttc generate "$scratch/good.tt"
expect 2 ttc generate "$scratch/good.tt" --out
expect 3 ttc generate "$scratch/bad.tt" --out "$scratch/generated"
[ ! -e "$scratch/generated" ] || fail "ttc generate touched its output folder for a bad table"

at=gamma3=0.3,v_nu=0.7,omega3=1.1
expect 0 jellett models
expect 0 jellett eigen --set a3=0 --at $at
expect 0 jellett eigen --set a3=0 --at $at --json
expect 0 jellett measure --set I3=0
expect 2 jellett eigen --no-such-option
expect 2 jellett eigen --set
expect 2 jellett eigen --set a3=0 --at
expect 3 jellett eigen no_such_model --set a3=0 --at $at
expect 3 jellett eigen --set nothing=1 --at $at
expect 3 jellett eigen --set a3=0 --at gamma3=2,v_nu=0.7,omega3=1.1
expect 3 jellett eigen --set a3=0 --at $at,omega_tau=0.5
expect 3 jellett eigen --set a3=nan --at $at
expect 3 jellett eigen --set I1=-1 --at $at
expect 0 jellett verify chaplygin_sleigh
expect 3 jellett verify no_such_model
expect 2 jellett verify --seed
start=gamma3=-0.6,v_nu=0.5,omega_tau=0.3,omega_n=1,omega3=0.8
expect 2 jellett section
expect 2 jellett section --start eta=0.1,gamma3=-0.6 --method none
expect 2 jellett section --start eta=0.1,gamma3=-0.6 -o one.csv -o other.csv
expect 3 jellett section --start eta=0.1,gamma3=7
expect 3 jellett section --start eta=0.1,gamma3=-0.6 --level E=-100,G=0
expect 3 jellett section --start eta=0.1,gamma3=-0.6 --tol 0
expect 2 jellett simulate
expect 3 jellett simulate --start "$start" --until nan --every 1
expect 3 jellett simulate --start "$start" --until 1 --every 0.1 --set g=-1
for command in models verify "eigen --set a3=0 --at $at" "measure --set I3=0" "section --start eta=0.1,gamma3=-0.6 --returns 5" \
    "simulate --start $start --until 1 --every 0.1" "orbits --period 1 --grid 0x0 --samples 20"; do
    # shellcheck disable=SC2086
    expect 5 into_full jellett $command
    grep -q 'cannot write to standard output: No space' "$scratch/err" || fail "$command: $(cat "$scratch/err")"
done
# A small stack is made as large as is allowed; where that is too little, this is said before anything crashes.
on_stack() { (ulimit "$1" 256; "${@:2}"); }
expect 0 on_stack -Ss jellett continue --along E=2.1:2.15
expect 0 on_stack -Ss jellett section --start eta=0.1,gamma3=-0.6 --returns 5
expect 0 on_stack -s jellett models
grep -q 'the stack is limited to 256 KiB' "$scratch/err" || fail "nothing is said of a small stack: $(cat "$scratch/err")"
for small in OMP_STACKSIZE=64k OMP_STACKSIZE=8191 "OMP_STACKSIZE=1 m" GOMP_STACKSIZE=16; do
    expect 0 env "$small" jellett models
    grep -q "^jellett: $small limits the stacks of threads" "$scratch/err" || fail "nothing is said of $small"
done
for size in 8192 8M 1G; do
    expect 0 env OMP_STACKSIZE=$size jellett models
    [ ! -s "$scratch/err" ] || fail "OMP_STACKSIZE=$size: $(cat "$scratch/err")"
done
# Nor is the status of a child lost, or a table not compiled, where the parent ignores the ends of children.
unheeded() { env --ignore-signal=CHLD "$@"; }
cat > "$scratch/high.scene" << 'SCENE'
levels = { E = -100; G = 0.0; };
compute = ( { what = "section"; grid = "4x4"; output = "map.csv"; } );
SCENE
expect 3 jellett run "$scratch/high.scene"
expect 3 unheeded jellett run "$scratch/high.scene"
expect 0 unheeded jellett simulate "$scratch/good.tt" --set k=1 --start x=1,v=0 --times 1
for tool in build test run install-deps regenerate; do expect 0 "$JLT_SOURCE_DIR/tools/$tool" --help; done
for tool in build test run install-deps regenerate test-fresh bench/run bench/stability; do
    (cd / && "${JLT_SOURCE_DIR#/}/tools/$tool" --help) > "$scratch/out" 2> "$scratch/err"
    { [ ! -s "$scratch/err" ] && grep -q "^usage: tools/$tool" "$scratch/out"; } || fail "$tool --help: $(cat "$scratch/err")"
done
expect 2 "$JLT_SOURCE_DIR/tools/run" --none
for tool in build install-deps regenerate "test --preset"; do
    # shellcheck disable=SC2086
    expect 2 "$JLT_SOURCE_DIR"/tools/$tool none
done
exit $status
