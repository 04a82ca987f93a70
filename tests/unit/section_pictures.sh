#!/usr/bin/env bash
# The picture of a section shows all orbits alike, however many returns there are, and shows them where they are.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
gnuplot --version > /dev/null 2>&1 || exit 77

# Of more returns than a picture holds a random share is drawn, of the last orbits as of the first, and the title says so: within
# six standard deviations of a half. Where no return lies in the ranges of the grid, the picture shows where they are.
jellett section --grid eta=0.40:0.48:21,gamma3=-0.63:-0.61:20 --returns 1000 --tol 1e-6 --plot p.png --keep p.gp -o rows.csv 2> log
awk -F, 'FNR == NR { if (/^END/) over = 1; if (!over && split($0, v, " ") == 3) drawn[v[1] " " v[2]]; next }
    !/^[#o]/ && $2 > 0 { all[$1]++; total++; if (($4 " " $5) in drawn) seen[$1]++ }
    END { for (i in all) { half += seen[i]; if ((2 * seen[i] - all[i])^2 > 36 * all[i]) { print "orbit " i ": " seen[i]; bad = 1 } }
          if (total <= 400000 || (2 * half - total)^2 > 36 * total) { print half " of " total; bad = 1 }; exit bad }' \
    <(sed '1,/^\$POINTS/d' p.gp) rows.csv || fail "a random half of the returns is not drawn"
grep -q "^set title .* 1000 returns, one in 2 drawn'" p.gp || fail "the title does not say that a half is drawn"
grep -q '^plot .* with dots ' p.gp || fail "so many points are no dots"
jellett section --grid eta=0.40:0.48:8,gamma3=-0.63:-0.61:8 --returns 1000 --tol 1e-6 --style points=3 --plot p.png --keep p.gp \
    -o rows.csv 2> log
grep -q '^plot .* with points .* ps 0.6 ' p.gp || fail "--style points=3 is not followed: $(grep -o 'with dots' p.gp)"
jellett section --grid gamma3=0.95:0.99:2,eta=3:3.1:2 --returns 5 --plot p.svg --keep p.gp -o rows.csv 2> log
grep -q "up to 5 returns'" p.gp || fail "a title: $(grep title p.gp)"
grep '^set yrange' p.gp | tr '[:]' '   ' | awk '{ exit !($3 < -0.648 && $4 > -0.584) }' ||
    fail "no return lies in the ranges of the grid, and none is seen: $(grep '^set yrange' p.gp)"
# Orbits that are followed backwards are said to be: they come to other sets.
jellett section --start eta=0.1,gamma3=-0.6 --returns 5 --backward --plot p.svg --keep p.gp -o rows.csv 2> log
grep -q "up to 5 returns backwards'" p.gp || fail "backwards: $(grep title p.gp)"
# Lines on the cylinder go around it: no step of them is longer than half a period. The orbit follows theta = a over the end of the
# period; the separatrices of the pendulum are those of a forcing of size 0.
printf '%s\n' 'model follower' 'param a' 'state phi' 'state theta' 'state v' 'angle c s = cos(theta - a) sin(theta - a)' \
    'eq phi = 1' 'eq theta = -s' 'eq v = -v' 'periodic phi = 2*pi' 'periodic theta = 2*pi' > follower.tt
printf '%s\n' 'model pendulum' 'state phi' 'state theta' 'state v' 'angle c s = cos(theta) sin(theta)' \
    'eq phi = 1' 'eq theta = v' 'eq v = -s' 'periodic phi = 2*pi' 'periodic theta = 2*pi' > pendulum.tt
for command in "continue ./follower.tt --set a=3 --along a=3:3.3 --axes a,theta --start theta=3,v=0" \
    "manifolds ./pendulum.tt --start theta=3.14,v=0 --length 8"; do
    # shellcheck disable=SC2086
    jellett $command --section phi=0 --plot p.svg --keep p.gp -o rows.csv 2> log || fail "$command: $(cat log)"
    awk -v k=$([[ $command == continue* ]] && echo 2 || echo 1) '/<< END$/ { data = 1; next } /^END$/ { data = 0 }
        !data || NF < 2 { last = ""; next }
        { if (last != "" && ($k - last)^2 > 9) bad = 1; last = $k; ends += $k^2 > 3.1415^2 }
        END { exit bad || ends < 2 }' <(sed '/^.CROSSINGS/,/^END/d' p.gp) || fail "a line leads across the picture: $command"
done
exit $status
