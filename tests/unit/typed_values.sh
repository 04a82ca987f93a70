#!/usr/bin/env bash
# Values are what was typed: a name given twice, a number in another base, a spacing that cannot be are refused by name; what a
# sweep runs over prints as the decimal that it is, and headers do not claim a value for it.
source "$JLT_SOURCE_DIR/tests/scratch.sh"

with_status() { # STATUS TEXT COMMAND...
    local wanted=$1 text=$2 code
    shift 2
    timeout 10 "$@" > "$scratch/out" 2> "$scratch/err"
    code=$?
    [ $code -eq "$wanted" ] && grep -qF -- "$text" "$scratch/err" || fail "$*: status $code, says '$(cat "$scratch/err")'"
}
refused() { with_status 3 "$@"; } # TEXT COMMAND...
twice() { with_status 2 "--$1 is given twice, as '$2' and as '$3'" "${@:4}"; } # OPTION VALUE VALUE COMMAND...
refused "--set: 'a3' is given twice" jellett measure --set a3=1,a3=2
refused "--set: 'a3' is given twice" jellett measure --set a3=1 --set a3=1
refused "--at: 'gamma3' is given twice" jellett eigen --at gamma3=0.1,gamma3=0.2
refused "--level: 'E' is given twice" jellett section --grid 2x2 --level E=2,E=2.15
refused "--start: 'eta' is given twice" jellett section --start eta=0.1,gamma3=-0.6,eta=0.2
refused "--grid: 'eta' is given twice" jellett section --grid eta=0:1:2,eta=1:2:3
refused "--times: '1e-320' is outside the range of doubles" jellett simulate lorenz --start x=1,y=1,z=1 --times 1e-320
refused "--spacing: '1e-300'" jellett manifolds --spacing 1e-300
for number in 0x10 0X1F 0b11; do
    printf 'compute = ( { what = "section";\n grid = "2x2"; returns = %s; } );\n' $number > "$scratch/s.scene"
    refused "s.scene:2: error: " jellett run "$scratch/s.scene"
done
printf '\xef\xbb\xbfmodel = "lorenz";\n' > "$scratch/s.scene"
refused "s.scene:1: error: a byte order mark" jellett run "$scratch/s.scene"
# An option with one value is not overridden by its second: however spelled, by every program, also where nothing else is computed.
twice tol 1e-8 1e-9 jellett simulate --start x=1,y=1,z=1 lorenz -t 1e-8 --times 1 --to=1e-9
twice times 1 2 jellett simulate lorenz --start x=1,y=1,z=1 --times 1 --times 2
twice section z=27 z=20 jellett plan section lorenz --section z=27 --section z=20
twice start gamma3=0.1 gamma3=0.1 jellett certify pole --start gamma3=0.1 --start gamma3=0.1
twice reference a b jellett bench section --reference a --reference b
twice when g=1 g=2 ttc discover --when g=1 --when g=2 "$JLT_SOURCE_DIR/codegen/models/lorenz.tt"
jellett simulate lorenz --start x=1 --start y=1,z=1 --times 0 > "$scratch/out" || fail "the values of --start do not add up"
[ "$(grep -c alive "$scratch/out")" -eq 1 ] || fail "the values of --start do not add up"

start=gamma3=0.2,v_nu=0.6,omega_tau=0.4,omega_n=1,omega3=0
rows() { grep -v '^#' "$scratch/out" | tail -n +2 | cut -d, -f1 | tr '\n' ' '; }
claims() { grep '^# ' "$scratch/out" | grep -vE '^# (command|\{"command")' | grep -c "[ #]$1="; }
jellett rod --start $start --sweep a3=0.1:0.7:7 > "$scratch/out"
[ "$(rows)" = "0.1 0.2 0.3 0.4 0.5 0.6 0.7 " ] || fail "rod: prints $(rows)"
[ "$(claims a3)" -eq 0 ] && [ "$(claims I1)" -eq 1 ] || fail "rod: the header claims a value of a3"
jellett rod --start $start --sweep omega_n=1/3:1:3 > "$scratch/out"
[ "$(rows)" = "0.3333333333333333 0.6666666666666666 1 " ] || fail "rod: prints $(rows)"
[ "$(claims omega_n)" -eq 0 ] || fail "rod: the header claims a value of omega_n"
# Times are multiples of the step as typed, each rounded once; a hundredth of T ends at T.
decay=$scratch/decay.tt
printf 'model decay\nstate x\neq x = -x\n' > "$decay"
jellett simulate "$decay" --start x=1 --until -0.7 --every 0.1 > "$scratch/out"
[ "$(rows)" = "0 -0.1 -0.2 -0.3 -0.4 -0.5 -0.6 -0.7 " ] || fail "simulate --every 0.1: times $(rows)"
jellett simulate "$decay" --start x=1 --until 1/3 --every 1/9 > "$scratch/out"
[ "$(rows)" = "0 0.1111111111111111 0.2222222222222222 0.3333333333333333 " ] || fail "simulate --every 1/9: times $(rows)"
jellett simulate "$decay" --start x=1 --until 0.7 > "$scratch/out"
[ "$(rows)" = "$(awk 'BEGIN { for (k = 0; k <= 100; k++) printf "%.15g ", k*7/1000 }')" ] ||
    fail "simulate --until 0.7: times $(rows)"
jellett fates --grid 2x2 --returns 2 --sweep E=1.1:1.7:7 > "$scratch/out" 2> /dev/null
[ "$(rows)" = "1.1 1.2 1.3 1.4 1.5 1.6 1.7 " ] || fail "fates: prints $(rows)"
[ "$(claims E)" -eq 0 ] && [ "$(claims G)" -eq 2 ] || fail "fates: the header claims a value of E"
jellett eigen --at v_nu=0.7,omega3=1.1 --sweep a3=0:0:1,gamma3=0.1:0.7:7 > "$scratch/out"
[ "$(claims a3)" -eq 0 ] || fail "eigen: the header claims a value of a3"

# The command in a header is one line of UTF-8 that does the same again, whatever bytes a file's name has.
cd "$scratch" || exit 1
for name in $'two\nlines' $'\xff' $'a\rb' "it's \\ü" $'ü\n\\\'' 'a b'; do
    jellett simulate lorenz --start x=1,y=1,z=1 --times 1 -o "$name" && mv "$name" first || fail "no file '$name'"
    iconv -f UTF-8 -t UTF-8 first > "$scratch/out" && [ "$(grep -cv '^#' first)" -eq 2 ] || fail "the header of '$name' is no text"
    (eval "$(sed -n 's/^# command: //p' first)") && cmp first "$name" || fail "the header of '$name': $(head -1 first)"
done
exit $status
