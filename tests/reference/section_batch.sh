#!/usr/bin/env bash
# Many orbits of `jellett section`, as typed: rows against quadruple precision and against those of one orbit at a time, fates,
# threads, rows that wait in the temporary file, projection, refusals, and what an interrupt leaves.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
data=$JLT_SOURCE_DIR/tests/reference/data
section() { # FILE OPTION...: rows without comments
    local file=$1
    shift
    jellett section "$@" > all.csv 2> err || fail "section $*: $(cat err)"
    grep -v '^#' all.csv > "$file"
}
starts() { awk -F, "$1"' { printf "--start eta=%s,gamma3=%s ", $('"$2"'), $('"$2"' + 1) }' "$3"; }

# Quadruple precision: all columns of all four orbits within 1e-11 at --tol 1e-13, which is what ten returns that amplify errors by
# up to 100 make of a local error of a tolerance.
section rows.csv --tol 1e-13 --returns 10 $(starts 'NR > 1 && $2 == 0' 3 "$data/returns_51.csv")
paste -d, <(tail -n +2 rows.csv) <(tail -n +2 "$data/returns_51.csv") | awk -F, '
    function abs(x) { return x < 0 ? -x : x }
    { if ($1 != $10 || $2 != $11 || $9 != "alive") print "rows differ: " $0
      d[1] = $4 - $12; d[2] = $5 - $13; d[3] = $3 - $14; d[4] = $6 - $15; d[5] = $7 - $16; d[6] = $8 - $17
      for (i in d) if (!(abs(d[i]) < 1e-11)) print "off by " d[i] ": " $0
      n++ }
    END { if (n != 44) print n " rows" }' > wrong
[ -s wrong ] && fail "quadruple precision: $(head -1 wrong)"
grep -q '^# many orbits at once by stepanov10 on ' all.csv || fail "the header does not tell the method"
command=$(sed -n 's/^# command: //p' all.csv)
eval "$command" 2> /dev/null | cmp -s - all.csv || fail "the header's command gives other rows"

# One at a time, on the regular island: the same columns and keys in the same order, and values within 1000 tolerances, which 50
# returns make of the some 10 of ten returns where errors grow as the square of time.
island=(--returns 50 --grid eta=0.40:0.48:20,gamma3=-0.635:-0.605:15)
section one.csv --method gauss "${island[@]}"
section many.csv "${island[@]}"
cmp -s <(cut -d, -f1,2,9 one.csv) <(cut -d, -f1,2,9 many.csv) || fail "orbits, returns or fates differ from those one at a time"
cmp -s <(head -1 one.csv) <(head -1 many.csv) || fail "columns differ from those one at a time"
paste -d, <(tail -n +2 one.csv) <(tail -n +2 many.csv) | awk -F, '
    function abs(x) { return x < 0 ? -x : x }
    { for (i = 3; i <= 8; i++) if (!(abs($i - $(i + 9)) < 1e-9)) print "column " i ": " $0 }' > wrong
[ -s wrong ] && fail "against one at a time: $(head -1 wrong)"

# A nearly balanced sphere creeps for 840 units of time, where explicit methods are at their limit of stability and a batch was off
# by 0.4 in t: after 400 steps it is the default method's, which at 9e-10 is off by 7e-5 (at 1e-13 it and DOP853 agree on
# 838.42538).
creeping=eta=1.1596285976164666,gamma3=-0.09498910085690882
section creeps.csv --tol 9e-10 --returns 2 --start $creeping --start $creeping \
    --set m=2.9679390030820643,R=5.7487378158665905,g=9.81,I1=4.6941652960533755,I3=4.6941652960533755,a3=0.0012273549505698084 \
    --level E=1059.5353769598159,G=108.24474604034094
awk -F, 'END { exit !($2 == 2 && $3 > 838.4247 && $3 < 838.4261) }' creeps.csv || fail "a slow return: $(tail -1 creeps.csv)"

# At a loose tolerance too all rows are the batch's: none after the start has a time that gauss has, to the bit. Few returns: errors
# of a hundredth soon carry an orbit off the island, to a pole.
loose=(--tol 1e-2 --returns 5 --grid eta=0.40:0.48:20,gamma3=-0.635:-0.605:15)
section one.csv --method gauss "${loose[@]}"
section many.csv "${loose[@]}"
cmp -s <(cut -d, -f1,2,9 one.csv) <(cut -d, -f1,2,9 many.csv) || fail "--tol 1e-2: orbits, returns or fates differ"
paste -d, one.csv many.csv | awk -F, 'NR > 1 && $2 > 0 && $3 == $12' > wrong
[ -s wrong ] && fail "--tol 1e-2: $(wc -l < wrong) rows are gauss's: $(head -1 wrong)"

# Two threads: the same bytes; more orbits than are followed at once, those that end at poles with them.
section chaos1.csv --threads 1 --grid 23x17 --returns 40
section chaos2.csv --threads 2 --grid 23x17 --returns 40
cmp -s chaos1.csv chaos2.csv || fail "two threads give other rows"
[ "$(cut -d, -f1 chaos1.csv | uniq | wc -l)" -gt 257 ] || fail "fewer orbits than a block"

# Rows that do not fit into memory go through a file that is left nowhere: more than 2048 returns of an orbit, whose first 900 are
# those of a run that needs none.
section long.csv --threads 2 --start eta=0.44,gamma3=-0.62 --returns 2500 --start eta=0.41,gamma3=-0.61
section short.csv --threads 1 --start eta=0.44,gamma3=-0.62 --returns 900 --start eta=0.41,gamma3=-0.61
[ "$(tail -n +2 long.csv | awk -F, '$1 != int((NR - 1)/2501) || $2 != (NR - 1)%2501 || $9 != "alive"' | wc -l)" -eq 0 ] ||
    fail "long orbits: rows are missing or out of order"
[ "$(wc -l < long.csv)" -eq 5003 ] || fail "long orbits: $(wc -l < long.csv) lines"
awk -F, '$2 == "return" || $2 <= 900' long.csv | cmp -s - short.csv || fail "the first returns depend on how many there are"
ls "$scratch"/jellett.* > /dev/null 2>&1 && fail "a temporary file is left"

# Ends at poles, as the reference has them: side, time, velocities, within what the command keeps one at a time.
for file in poles_51 poles_creeping_51; do
    section ends.csv --tol 1e-13 --returns 100 $(starts 'NR > 1' 1 "$data/$file.csv")
    paste -d, <(grep ',pole' ends.csv) <(tail -n +2 "$data/$file.csv") | awk -F, '
        function abs(x) { return x < 0 ? -x : x }
        $9 != ($12 > 0 ? "pole+" : "pole-") || !(abs($3 - $13) < 1e-11 && abs($6 - $14) < 1e-10 && abs($8 - $16) < 1e-10)
        END { if (NR < 2) print NR " ends" }' > wrong
    [ -s wrong ] && fail "$file: $(head -1 wrong)"
done

# The same numbers and fates as one at a time: ends after few returns, before chaos tells the methods apart; starts without a
# state among the others; orbits that come to rest (a3 = 0, equilibria (4.4)); crossings in either direction.
same_fates() { # OPTION...
    section one.csv --method gauss "$@"
    section many.csv "$@"
    cmp -s <(cut -d, -f1,2,9 one.csv) <(cut -d, -f1,2,9 many.csv) || fail "fates differ: $*"
}
same_fates --grid 12x9 --returns 6
grep -q ',pole-$' many.csv && grep -q ',pole+$' many.csv || fail "no orbit ended at a pole"
same_fates --level E=0.8 --grid eta=-3:3:6,gamma3=-0.95:0.95:20 --returns 4
grep -q 'points of the grid there is no state' err || fail "no start was passed over"
same_fates --set a3=0 --start eta=1.0471975511965974,gamma3=0.3 --start eta=0.3,gamma3=0.2 --returns 1000
grep -q ',equilibrium$' many.csv || fail "no orbit came to rest"
same_fates --direction both --grid 3x3 --returns 5
same_fates --direction down --grid 3x3 --returns 5
same_fates --backward --grid 3x3 --returns 5
same_fates --backward --direction both --level E=1.5 --grid 4x3 --returns 5
same_fates lorenz --section z=27 --direction down --start x=-13.76,y=-19.58 --start x=1,y=2 --returns 3
same_fates lorenz --section z=27 --direction down --backward --start x=-13.76,y=-19.58 --start x=1,y=2 --returns 3
same_fates roessler --section y=0 --direction down --start x=-7,z=0.02 --start x=-6,z=0.02 --returns 20

# Projected, E = m v^2/2 + I1 omega_n^2/2 + I3 omega3^2/2 + m g a3 gamma3 with omega_tau = 0 is off by what the last return adds,
# a tolerance at most; without, by what a thousand have added. (At (5.1), v_tau = (a3 + gamma3) omega_n + s omega3.)
drift() {
    awk -F, 'function abs(x) { return x < 0 ? -x : x }
        $1 == "orbit" { next }
        { vt = (0.51 + $5)*$7 + sqrt(1 - $5^2)*$8
          E = ($6^2 + vt^2)/2 + ($7^2 + $8^2)/6 + 0.51*$5
          if (abs(E - 2.15) > worst) worst = abs(E - 2.15) }
        END { print worst }' "$1"
}
section projected.csv --project --tol 1e-10 --start eta=0.44,gamma3=-0.62 --returns 1000
section plain.csv --tol 1e-10 --start eta=0.44,gamma3=-0.62 --start eta=0.44,gamma3=-0.62 --returns 1000
awk -v a="$(drift projected.csv)" -v b="$(drift plain.csv)" 'BEGIN { exit !(a < 1e-10 && b > 20 * a) }' ||
    fail "--project: E is off by $(drift projected.csv), without it by $(drift plain.csv)"

# Followed back in time, orbits come back: 20 returns there, and 20 from where they led.
section there.csv --backward --tol 1e-13 --returns 20 --start eta=0.44,gamma3=-0.62 --start eta=0.41,gamma3=-0.61
section back.csv --tol 1e-13 --returns 20 $(starts '$2 == 20' 4 there.csv)
awk -F, 'function abs(x) { return x < 0 ? -x : x }
    $2 == 20 && !(abs($4 - ($1 == 0 ? 0.44 : 0.41)) < 1e-10 && abs($5 + ($1 == 0 ? 0.62 : 0.61)) < 1e-10)' back.csv > wrong
[ -s wrong ] || [ "$(grep -c '^[01],20,' back.csv)" -ne 2 ] && fail "back and forth: $(cat wrong)"

# Contact is looked at along every step, as one at a time: the same orbits lose it, and the least N is the same to twice 2^-20 of
# it, and to as much of 1 for errors of orbits.
section one.csv --method gauss --contact report --grid 12x9 --returns 6
cp err one.err
section many.csv --contact report --grid 12x9 --returns 6
cmp -s err one.err && grep -q 'lose contact' err || fail "contact: $(cat err), one at a time: $(cat one.err)"
paste -d, <(tail -n +2 one.csv) <(tail -n +2 many.csv) | awk -F, '
    { off = $10 - $20; if (!(off*off < 4e-12*(1 + $20*$20))) print "N: " $0; other += ($10 > 0) != ($20 > 0) }
    END { if (other > NR/100) print other " of " NR " rows differ in whether contact is lost" }' > wrong
[ -s wrong ] && fail "where contact is lost: $(head -1 wrong)"

# Orbits that end where contact is lost are followed alone from their starts: their rows are those of the method named. All others
# stay in lanes. Of the orbits here 15 go on, 23 end at poles, and 70 lose contact.
ending=(--contact end --level E=1.5,G=-0.56 --grid 12x9 --returns 20)
for threads in 1 2; do
    section ends$threads.csv "${ending[@]}" --threads $threads
    grep -q '^# many orbits at once by .*; gauss for orbits that lose a condition, from where' all.csv ||
        fail "--contact end: the header does not tell"
done
section one.csv "${ending[@]}" --method gauss
cmp -s ends1.csv ends2.csv || fail "--contact end: rows depend on threads"
cmp -s <(cut -d, -f1,2,9 ends1.csv) <(cut -d, -f1,2,9 one.csv) || fail "--contact end: orbits, returns or fates differ"
lost() { awk -F, 'NR == FNR { if ($9 == "lost_contact") ends[$1]; next } $1 in ends' "$1" "$1"; }
cmp -s <(lost ends1.csv) <(lost one.csv) || fail "--contact end: rows of orbits that lose contact differ"
[ "$(lost one.csv | wc -l)" -gt 100 ] || fail "--contact end: too few orbits lose contact"

# DP of many returns: the same on two threads; trace, determinant and divergence within 1000 tolerances of those that the other
# method gives one at a time; and the check itself, whose bound then is that of one step, passes.
checked=(--check --grid eta=0.40:0.48:20,gamma3=-0.635:-0.605:15 --returns 20)
section checked1.csv "${checked[@]}" --threads 1
grep -q 'at most 0[.][0-9]* of its bound' err || fail "--check: $(cat err)"
section checked2.csv "${checked[@]}" --threads 2
cmp -s checked1.csv checked2.csv || fail "--check: rows depend on threads"
section alone.csv "${checked[@]}" --method dop853
paste -d, <(tail -n +2 alone.csv) <(tail -n +2 checked2.csv) | awk -F, '
    function abs(x) { return x < 0 ? -x : x }
    $2 > 0 { for (i = 10; i <= 12; i++) if ($i == "" || !(abs($i - $(i + 13)) < 1e-9*(1 + abs($i)))) print "column " i ": " $0
             n++ }
    END { if (n != 6000) print n " returns" }' > wrong
[ -s wrong ] && fail "--check: $(head -1 wrong)"

# What cannot be done is refused, with a word on what to do instead.
refused() { # STATUS WORDS OPTION...
    local want=$1 words=$2 got
    shift 2
    jellett section "$@" --output never.csv > out 2> err < /dev/null
    got=$?
    [ $got -eq "$want" ] || fail "$*: status $got, not $want"
    grep -q -- "$words" err || fail "$*: $(cat err)"
    [ ! -e never.csv ] || fail "$*: a file is left"
}
at=(--start eta=0.1,gamma3=-0.6)
refused 2 '--project works on this section only without --method: leave out --method' --project --method gauss "${at[@]}"
refused 2 'no integrals' --project roessler --section y=0 --start x=-7,z=0.02
refused 3 'threads' --threads 0 "${at[@]}"
TMPDIR=/no/such/folder refused 5 TMPDIR "${at[@]}" --returns 3000 --start eta=0.44,gamma3=-0.62

# Without a root as well: the energy of Toda's chain, whose drift over 200 returns at --tol 1e-6 is 1e-7. Projected, it is that of a
# return, whose share of 1e-7 would be 5e-10, and of the way back to the section.
chain_drift() { # FILE: the largest relative change of the energy
    awk -F, '/^0,/ { H = ($6*$6 + $7*$7 + $8*$8)/2 + exp(-$4) + exp($4 - $5) + exp($5); if (NR == 2) first = H
                     off = H/first - 1; if (off < 0) off = -off; if (off > most) most = off; rows++ }
             END { if (rows != 201) most = 1; print most }' "$1"
}
toda=(toda --section q1=0 --start q2=0.1,q3=-0.2,p1=1,p2=-0.3,p3=-0.7 --start q2=0.1,q3=-0.2,p1=1,p2=-0.3,p3=-0.6 --returns 200 \
    --tol 1e-6)
section plain.csv "${toda[@]}"
section projected.csv "${toda[@]}" --project
awk -v plain="$(chain_drift plain.csv)" -v projected="$(chain_drift projected.csv)" \
    'BEGIN { exit !(plain < 1e-6 && 10*projected < plain) }' ||
    fail "toda: the energy drifts by $(chain_drift plain.csv), projected by $(chain_drift projected.csv)"

# An interrupt leaves whole rows, orbit after orbit without a gap, none of orbits that have no return, and says how many.
interrupt() { # RETURNS FILE STDOUT: follow a hundred orbits, as $child
    set -m
    jellett section --threads 2 --grid eta=0.40:0.48:10,gamma3=-0.635:-0.605:10 --returns "$1" --output "$2" > "$3" 2> err &
    child=$!
    set +m
}
interrupted() { # the rows of long.csv, when $child has ended
    local code=0
    wait "$child" 2> /dev/null || code=$?
    [ $code -eq 130 ] || fail "interrupted: status $code"
    grep -v '^#' long.csv | awk -F, '
        NR == 1 { next }
        NF != 9 || $9 != "alive" { print "a broken row: " $0; exit }
        $2 == 0 { if ($1 != orbits) { print "orbit " $1 " for " orbits + 0; exit } orbits++; number = 0 }
        $1 != orbits - 1 || $2 != number++ { print "out of order: " $0; exit }
        END { if (orbits < 2 || number < 2 || NR - 1 != told) print NR - 1 " rows of " orbits + 0 " orbits, the last " number + 0 }
        ' told="$(sed -n 's/.*interrupted; \([0-9]*\) whole rows.*/\1/p' err)" - > wrong
    [ -s wrong ] && fail "interrupted: $(head -1 wrong); $(cat err)"
}
interrupt 100000000 long.csv /dev/null
sleep 1
kill -INT $child
interrupted
ls long.csv.* > /dev/null 2>&1 && fail "interrupted: a temporary file is left"

# While rows are written, after all orbits have been followed: the rest is left out. It cannot have been written before the
# interrupt, as nobody reads it.
mkfifo rows
interrupt 5000 - rows
exec 3< rows
head -c 3000000 <&3 > long.csv # some 20 000 rows of the half a million
kill -INT $child
cat <&3 >> long.csv
interrupted
[ "$(grep -cv '^#' long.csv)" -lt 500000 ] || fail "interrupted while rows were written: all have been"
exit $status
