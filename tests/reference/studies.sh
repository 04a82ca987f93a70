#!/usr/bin/env bash
# Studies: sweeps over several names, transients left out, a scene with other parameters, and headers that programs read.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
rows() { grep -v '^#' out | tail -n +2; }
start=gamma3=0.2,v_nu=0.6,omega_tau=0.4,omega_n=1,omega3=0

# The first name is the slowest, every row has its values, and is that of a run with these values alone.
pairs='0.1,2 0.1,3 0.3,2 0.3,3 '
expect 0 '^a3,E,starts,' jellett fates --grid 4x4 --returns 20 --sweep a3=0.1:0.3:2,E=2:3:2
[ "$(rows | cut -d, -f1,2 | tr '\n' ' ')" = "$pairs" ] || fail "fates: $(rows)"
rows | sed -n 3p | cut -d, -f2- > swept
expect 0 '^E,starts,' jellett fates --grid 4x4 --returns 20 --set a3=0.3 --sweep E=2:2:1
rows | diff - swept || fail "fates: a row of the sweep is not that of its values"
expect 0 '^a3,v_nu,E1,' jellett rod --start $start --sweep a3=0.1:0.3:2,v_nu=2:3:2
[ "$(rows | cut -d, -f1,2 | tr '\n' ' ')" = "$pairs" ] || fail "rod: $(rows | cut -d, -f1,2)"
expect 0 '^m,' jellett eigen --set a3=0 --sweep m=0.1:0.3:2,v_nu=2:3:2 --at gamma3=0.3,omega3=1.1 --csv
[ "$(rows | cut -d, -f1,3 | tr '\n' ' ')" = "$pairs" ] || fail "eigen: $(rows | cut -d, -f1-4)"
# Any command that writes rows runs over several names: rows of a point are those of the command there, behind the point's values.
compare() { # COMMAND OPTION...: at a3=0.5,0.51 and E=2.1,2.2 together
    local command=$1
    shift
    expect 0 '^a3,E,' jellett "$command" "$@" --sweep a3=0.5:0.51:2,E=2.1:2.2:2
    rows > swept
    [ "$(grep -c '^# command:' out)" -eq 1 ] || fail "$command: a sweep has not one header"
    grep '^# {' out | grep -q '"a3"' && fail "$command: the header has a value of what runs"
    for a3 in 0.5 0.51; do for E in 2.1 2.2; do
        jellett "$command" "$@" --set a3=$a3 --level E=$E 2> err | grep -v '^#' | sed -n "2,\$s/^/$a3,$E,/p"
    done; done > single
    diff single swept > difference || fail "$command: rows of a sweep are not those of its points: $(head -3 difference)"
}
compare section --start eta=0.3,gamma3=0.2 --start eta=0.1,gamma3=-0.6 --returns 3
compare section --grid eta=0.3:0.3:1,gamma3=0.2:0.2:1 --returns 3
compare section --start eta=0.3,gamma3=0.2 --returns 3 --method gauss
# One orbit at each point goes beside the others, as that of a grid: not by the method of an orbit that is the only one.
expect 0 '^a3,E,' jellett section --start eta=0.3,gamma3=0.2 --returns 3 --sweep a3=0.5:0.51:2,E=2.1:2.2:2
rows > one_start
expect 0 '^a3,E,' jellett section --grid eta=0.3:0.3:1,gamma3=0.2:0.2:1 --returns 3 --sweep a3=0.5:0.51:2,E=2.1:2.2:2
rows | diff - one_start || fail "section: an orbit of a sweep is not followed as one of a grid"
compare orbits --start eta=0,gamma3=-0.61 --period 1
compare drift --returns 4
compare separation --grid 3x3 --cells 10x10 --returns 4 --settle 5
compare manifolds --count 6 --no-crossings
compare continue --along I1=1/3:0.34
expect 0 '^0.51,2.2,4,' jellett lyapunov --start eta=0.02,gamma3=-0.61 --returns 4 --sweep a3=0.5:0.51:2,E=2.1:2.2:2
[ "$(rows | wc -l)" -eq 4 ] || fail "lyapunov: a history in a sweep is not one row"
rows > four
expect 0 '' jellett lyapunov --start eta=0.02,gamma3=-0.61 --returns 4 --sweep a3=0.5:0.51:2,E=2.1:2.2:2 --threads 1
rows | cmp - four || fail "lyapunov: rows of a sweep depend on threads"
# Histories of all points go at once, by another method than that of one which is the only one: its errors, of 1e-12 a step, grow
# some hundredfold in four returns. By a method that is named they are the same.
last=$(jellett lyapunov --start eta=0.02,gamma3=-0.61 --returns 4 --set a3=0.51 --level E=2.2 | tail -1)
printf '0.51,2.2,%s\n' "$last" | paste -d, - <(tail -1 out) | awk -F, '
    { for (i = 3; i <= 7; i++) if (!(($i - $(i + 7)) ^ 2 < 1e-16)) exit 1; exit NF != 14 }' ||
    fail "lyapunov: the row of a sweep is not the last one of its point"
expect 0 '^0.51,2.2,4,' jellett lyapunov --start eta=0.02,gamma3=-0.61 --returns 4 --method gauss --sweep a3=0.5:0.51:2,E=2.1:2.2:2
[ "0.51,2.2,$last" = "$(tail -1 out)" ] || fail "lyapunov: by gauss the row of a sweep is not the last one of its point"
expect 0 '^E,I1,gamma3,' jellett portrait --level G=0.5,F0=0.1 --set a3=0 --sweep E=2:3:2,I1=0.3:0.4:2
# Columns of integrals that hold for special values alone are empty elsewhere, or left out, which is said.
expect 0 'drift_F0, drift_F_linear: no columns here' jellett simulate --start $start --times 1 --sweep a3=0:0.2:2
[ "$(rows | awk -F, '{ print NF }' | sort -u | wc -l)" -eq 1 ] || fail "simulate: rows of a sweep have different columns"
expect 0 'columns that the first point has not' jellett simulate --start $start --times 1 --sweep a3=0.2:0:2
# A study's table has the same rows, whichever columns its points have.
for ends in 0,0.2 0.2,0; do
    printf '%s\n' "over = { a3 = ($ends,2); };" 'compute = ( { what = "simulate"; times = (1, 2);' \
        'start = { gamma3 = 0.2; v_nu = 0.6; omega_tau = 0.4; omega_n = 1; omega3 = 0; }; } );' > from$ends.scene
    expect 0 '' jellett simulate --start $start --times 1,2 --sweep a3=${ends/,/:}:2
    rows > swept
    for i in 1/2 2/2 1/1; do
        expect 0 '' jellett sweep from$ends.scene --shard $i
        [ $i = 1/2 ] && continue
        expect 0 'at a3=0.*: .*drift_F_linear: .*columns' jellett merge from$ends.shards
        rows | diff - swept || fail "merge: rows of a study are not those of a sweep"
        rm from$ends.shards/*
    done
done
# A point without states has no rows; where no point has any, that is bad input.
expect 0 'at E=0:' jellett section --start eta=0.3,gamma3=0.2 --returns 1 --sweep E=0:2:2
[ "$(rows | wc -l)" -eq 2 ] || fail "section: a point without states is not left out"
expect 3 'no state with' jellett section --start eta=0.3,gamma3=0.2 --returns 1 --sweep E=0:0.1:2
expect 3 "has no parameter 'E'" jellett simulate --start $start --times 1 --sweep E=1:2:2
expect 2 "unrecognized option" jellett section --start eta=0.3,gamma3=0.2 --sweep E=2:3:2 --nonsense
expect 2 "given twice" jellett section --start eta=0.3,gamma3=0.2 --sweep E=2:3:2 --sweep a3=0:1:2
# What runs has no other value beside, by any command.
for command in "simulate --start $start --times 1" "section --start eta=0.3,gamma3=0.2" "fates --grid 2x2" "rod --start $start" \
    "eigen --at gamma3=0.3,v_nu=0.7,omega3=1.1" "portrait --level G=0.5,F0=0.1,E=2"; do
    # shellcheck disable=SC2086
    expect 2 "--set: --sweep gives a3 its values" jellett $command --set a3=0 --sweep I1=0.3:0.4:2,a3=0.1:0.2:2
done
for command in "section --start eta=0.3,gamma3=0.2" "fates --grid 2x2" "portrait"; do
    # shellcheck disable=SC2086
    expect 2 "--level: --sweep gives E its values" jellett $command --level E=2 --sweep E=2:3:2
done
expect 2 "one file for all points" jellett manifolds --sweep E=2:3:2 --crossings c.csv
expect 0 'at a3=0.1, the first of 2 points' jellett plan section --start eta=0.3,gamma3=0.2 --sweep a3=0.1:0.2:2
jellett lyapunov --returns 4 --sweep a3=0.5:0.51:3 --plot over.svg --output over.csv || fail "lyapunov: no picture of a sweep"
grep -q '<svg' over.svg || fail "lyapunov: a sweep draws no picture"
# What is not proved of a table is said once, by the compiler that proves or, later, by the command.
printf 'model bad\nparam k\ndefault k = 1\nstate x\nstate y\neq x = y\neq y = -k*x\nintegral X = x\n' > bad.tt
for said in 'integral claim .X. is refuted' 'kernels of bad rest on claims'; do
    expect 0 "$said" jellett section ./bad.tt --section y=0 --direction down --start x=1 --returns 1 --sweep k=1:2:2
    [ "$(grep -cE 'claim|claims' err)" -eq 1 ] || fail "what is not proved is said more than once: $(cat err)"
done
# The plan of a scene with other parameters.
printf 'model = "lorenz";\ncompute = ( { what = "section"; section = { z = 27; }; start = { x = 1; y = 1; }; } );\n' > plan.scene
expect 0 'section z=27' jellett plan plan.scene --set rho=28
expect 3 "no command of plan.scene has a parameter 'q'" jellett plan plan.scene --set q=1
expect 2 "name a scene" jellett plan --set rho=28

expect 3 "there is no 'q'" jellett fates --sweep a3=0.1:0.3:2,q=1:2:2
expect 3 "more than 3 names" jellett fates --sweep a3=0:1:2,E=1:2:2,G=0:1:2,m=1:2:2
expect 2 "--plot needs a --sweep of one quantity" jellett fates --sweep a3=0.1:0.3:2,E=2:3:2 --plot p.svg

# Rows after a transient are those of the whole run.
orbit=(roessler --section y=0 --direction down --start x=-7,z=0.02)
expect 0 '^0,40,' jellett section "${orbit[@]}" --returns 40
rows | tail -10 > late
expect 0 '^0,31,' jellett section "${orbit[@]}" --skip 30 --returns 10
rows | diff - late || fail "--skip: not the last ten rows"
expect 0 '^0,40,' jellett section --start eta=0.44,gamma3=-0.62 --start eta=2,gamma3=-0.5 --returns 40
rows | grep '^0,' | tail -10 > late
expect 0 '^0,31,' jellett section --start eta=0.44,gamma3=-0.62 --start eta=2,gamma3=-0.5 --skip 30 --returns 10
rows | grep '^0,' | diff - late || fail "--skip, in lanes: not the last ten rows"
expect 0 'pole' jellett section --start eta=2,gamma3=-0.5 --skip 1000 --returns 1
[ "$(rows | wc -l)" -eq 1 ] || fail "the end of an orbit is left out: $(rows)"
# Exponents from where the section is after so many returns; chaos takes the tolerance up by exp(30*0.53).
expect 0 '^0,30,' jellett section "${orbit[@]}" --skip 29 --returns 1
there=$(awk -F, '/^0,30,/ { print "x=" $4 ",z=" $5 }' out)
expect 0 '^4,' jellett lyapunov "${orbit[@]}" --skip 30 --returns 4
rows | tail -1 > skipped
expect 0 '^4,' jellett lyapunov "${orbit[@]:0:5}" --start "$there" --returns 4
rows | tail -1 | paste -d , - skipped | awk -F, '{ exit !(($2 - $7)^2 < 1e-8 && ($3 - $8)^2 < 1e-8) }' ||
    fail "lyapunov --skip: $(cat skipped), not $(rows | tail -1)"

# A scene with another parameter: in all commands, in place of its own or beside them.
cat > a.scene <<'S'
parameters = { a3 = 0.3; I1 = "1/3"; };
compute = ( { what = "section"; start = { eta = 0.1; gamma3 = -0.6; }; returns = 2; },
            { what = "verify"; },
            { what = "eigen"; at = { gamma3 = 0.3; v_nu = 0.7; omega3 = 1.1; }; } );
S
expect 0 '^jellett section --set=I1=1/3,a3=1/2,R=2 ' jellett run a.scene --dry-run --set a3=1/2,R=2
grep -q '^jellett verify$' out || fail "a command without parameters gets them: $(cat out)"
grep -q '^jellett eigen --set=I1=1/3,a3=1/2,R=2 ' out || fail "not in all commands: $(cat out)"
expect 3 "no command of a.scene has a parameter 'b'" jellett run a.scene --set b=1
expect 2 "is no assignment" jellett run a.scene --set a3

# One line of JSON: the same keys in the same order by every command, numbers that read back, what runs over the rows left out.
json() { grep '^# {' out | sed 's/^# //'; }
keys() { json | sed 's/^{//; s/}$//; s/{[^{}]*}/0/g' | grep -oE '"[a-z]+":' | tr -d '":' | tr '\n' ' '; }
says() { json | grep -qF -- "$1" || fail "'$1' is not in $(json)"; }
for command in "section --start eta=0.1,gamma3=-0.6 --returns 1" "fates --grid 2x2 --returns 1" \
    "orbits --period 1 --grid 0x0 --samples 9" \
    "lyapunov --returns 1" "drift --returns 1" "rod --start $start" "simulate --start $start --times 1" "measure --set I3=0 --csv" \
    "eigen --set a3=0 --at gamma3=0.3,v_nu=0.7,omega3=1.1 --csv" "separation --grid 2x2 --returns 1 --settle 0" \
    "continue --along E=2.14:2.16"; do
    # shellcheck disable=SC2086
    expect 0 '^# {' jellett $command
    [ "$(json | wc -l)" -eq 1 ] || fail "$command: $(json | wc -l) lines of JSON"
    [ "$(keys)" = "command version model variant time elimination table generator parameters levels method tolerance " ] ||
        fail "$command: keys $(keys)"
    says "\"command\":\"jellett $command\","
done
expect 0 '^# {' jellett section --set a3=1/3 --level E=2.1 --start eta=0.1,gamma3=-0.6 --returns 1 --tol 1e-9 --method taylor
says '"a3":0.3333333333333333,'
says '"levels":{"E":2.1,"G":-0.56},"method":"taylor","tolerance":1e-09}'
says '"model":"spherical_top_level","variant":'
expect 0 '^# {' jellett fates --grid 2x2 --returns 1 --sweep a3=0.1:0.3:2,E=2:3:2
says '"levels":{"G":-0.56}'
json | grep -q '"a3"' && fail "what runs has a value: $(json)"
expect 0 '^# {' jellett lyapunov roessler --section y=0 --direction down --start 'x=-7,z=1/50' --returns 1
says '"levels":{},"method":"gauss","tolerance":1e-12}'

# A table is the same in a file as on standard output, but for the command line in its header.
for command in "section --start eta=0.1,gamma3=-0.6 --returns 2" "section --grid 2x2 --returns 2" "fates --grid 2x2 --returns 1" \
    "fates --grid 2x2 --returns 1 --sweep a3=0.5:0.51:2" "orbits --period 1 --grid 0x0 --samples 9" "lyapunov --returns 2" \
    "drift --returns 2" "rod --start $start" "simulate --start $start --times 1" "measure --set I3=0 --csv" \
    "eigen --set a3=0 --at gamma3=0.3,v_nu=0.7,omega3=1.1 --csv" "separation --grid 2x2 --returns 1 --settle 0" \
    "continue --along E=2.14:2.16" "manifolds --length 0.002 --seed 1e-3 --no-crossings"; do
    # shellcheck disable=SC2086
    jellett $command 2> /dev/null | grep -v '^#' > shown
    # shellcheck disable=SC2086
    jellett $command -o saved.csv > out 2> /dev/null || fail "$command -o: status $?"
    [ ! -s out ] || fail "$command -o: standard output says $(head -1 out)"
    grep -v '^#' saved.csv | cmp -s - shown ||
        fail "$command: the file holds $(grep -vc '^#' saved.csv) rows, standard output $(wc -l < shown)"
done

# A density of one state, tabulated where the state may be, with the table's own beside it.
expect 0 '"closed_form":' jellett measure --set I3=0 --points 3 --json
jq -e '[.table[] | (.density/.closed_form - 1) | . < 1e-12 and . > -1e-12] == [true, true, true]' out > /dev/null ||
    fail "densities: $(cat out)"
half() { # INTERVAL: at of three rows
    printf '%s\n' 'model half' "state z in $1" 'state q' 'eq z = z*z' 'eq q = 1' 'measure rho = 1/z^2' > half.tt
    jellett measure ./half.tt --points 3 --csv | awk -F, '/^z,/ { printf "%s ", $2 }'
}
[ "$(half '(-inf, 0)')" = "-4.05 -2.05 -0.05 " ] || fail "(-inf, 0): $(half '(-inf, 0)')"
[ "$(half '(2, inf)')" = "2.05 4.05 6.05 " ] || fail "(2, inf): $(half '(2, inf)')"
[ "$(half '(1, 3)')" = "1.02 2 2.98 " ] || fail "(1, 3): $(half '(1, 3)')"
exit $status
