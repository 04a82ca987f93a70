#!/usr/bin/env bash
# Tables of a family are those that lie beside each other: where one is edited, broken or gone, what the others claim of it is
# proved anew, or the claim is named; also of tables that are to the letter what is built in. Levels, conditions and poles are those
# of the table that is asked.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
expect() { # STATUS TEXT COMMAND...: the text is in what it says
    local want=$1 text=$2 got=0
    shift 2
    "$@" > out 2> err || got=$?
    [ $got -eq "$want" ] && grep -q -- "$text" out err ||
        fail "$*: status $got, wanted $want and '$text' in '$(tail -3 out)' or '$(cat err)'"
}
# Each edit is compiled; how fast its kernels are is not asked.
printf '#!/bin/sh\nexec cc "$@" -O0\n' > compiler
chmod +x compiler
export CC=$PWD/compiler
anew() { cp "$JLT_SOURCE_DIR"/codegen/models/*.tt .; }
last() { tail -1 out | cut -d, -f"$1"; }
section=(--start eta=0.1,gamma3=-0.6 --returns 1)
start=gamma3=-0.6,v_nu=0.5,omega_tau=0.3,omega_n=1,omega3=0.8

# The table of coordinates: a lift that is none, another level, gone, no table.
anew
expect 0 'levels E=2.15' jellett section ./spherical_top.tt "${section[@]}"
built_in=$(last 1-9)
sed -i 's/v_tau = W\*stretch\*cos_eta/v_tau = -W*stretch*cos_eta/' spherical_top_section.tt
for model in ./spherical_top.tt ./spherical_top_level.tt ./spherical_top_track.tt; do
    expect 3 'the way back does not lead to eta' jellett section $model "${section[@]}"
    expect 3 'ask for one of the table itself' jellett fates $model --grid 2x2
done
anew
sed -i 's/E = 2.15/E = 2/' spherical_top_section.tt
for model in ./spherical_top.tt ./spherical_top_level.tt ./spherical_top_track.tt; do
    expect 0 'levels E=2\( \|$\)' jellett section $model "${section[@]}"
    [ "$(last 1-9)" != "$built_in" ] || fail "$model on another level answers as on the one built in"
done
# A parameter that both tables have has the default of the model; that of the other table is not passed over in silence.
sed -i 's/G = -0.56/G = -0.7/' spherical_top_section.tt
expect 0 'the default of G in spherical_top_section.tt has no effect' jellett section ./spherical_top.tt "${section[@]}"
grep -q 'levels E=2 G=-0.56$' out || fail "the default of G is that of the model: $(cat out)"
rm spherical_top_section.tt
expect 3 'section turning .* could not be read' jellett section ./spherical_top.tt "${section[@]}"

# Larger tables are asked whether they reduce to the edited one.
anew
echo '# a comment' >> spherical_top.tt
expect 0 'tier track' jellett simulate ./spherical_top.tt --start $start --times 1 --track
expect 0 alive jellett simulate ./spherical_top.tt --start $start --times 1
anew
rm spherical_top_plane.tt
expect 0 'tier balanced' jellett simulate ./spherical_top.tt --set a3=0,I1=2/5,I3=1/4 --start $start --times 1

# One name of an integral is one quantity, also on levels; what is refuted is named though nothing of it is left.
anew
sed -i 's/^integral E = energy/integral E = 2*energy/' spherical_top.tt
expect 3 'reduction level is not proved of this table: integral E of spherical_top_level - of spherical_top = ' \
    jellett section ./spherical_top.tt "${section[@]}"
anew
sed -i 's/^valid contact : contact_force > 0/valid contact : contact_force - 1.3 > 0/' spherical_top.tt
expect 3 'valid contact of spherical_top_level - of spherical_top = (13)/(10)$' \
    jellett section ./spherical_top.tt "${section[@]}"
anew
sed -i 's/^param a3/param mu >= 0\n&/; s/^default /&mu = 0, /; s/^eq omega_tau =/&\n    - mu*omega_tau/' spherical_top.tt
echo '# a comment' >> spherical_top_level.tt
for time in first second; do
    expect 3 'E is no integral of this table: d(E)/dt' jellett section ./spherical_top.tt "${section[@]}"
    grep -q 'reduction level is not proved' err || fail "the $time run does not name the reduction: $(cat err)"
done

# A scene, which names coordinates of the section that is lost, is told why it is.
anew
sed -i '/^eq v_nu =/a \    + v_nu/10' spherical_top_level.tt
echo 'model = "./spherical_top.tt"; compute = ( { what = "section"; start = { eta = 0.1; gamma3 = -0.6; }; } );' > lost.scene
expect 3 'reduction level is not proved of this table' jellett run lost.scene

# So is a command, also which table's claim it is.
anew
sed -i 's/ at omega_tau = 0 with/ at omega_tau = 1\/10 with/' spherical_top_level.tt
expect 3 'section turning is not proved of spherical_top_level: ' jellett section ./spherical_top.tt "${section[@]}"

# A file that is broken is told of while it is there.
anew
echo 'garbage here' >> spherical_top_level.tt
expect 3 "spherical_top_level.tt:[0-9]*:1: 'garbage' opens no record" \
    jellett simulate ./spherical_top.tt --start $start --times 1 --tier level
rm spherical_top_level.tt
expect 3 'No such file' jellett simulate ./spherical_top.tt --start $start --times 1 --tier level
grep -q garbage out err && fail "a file that is gone is told of: $(cat out err)"

# Poles and conditions are those of the table asked for; what is known of one table alone names that one.
anew
sed -i '/^pole/d' routh_sphere.tt
expect 4 left_domain jellett simulate ./routh_sphere.tt --start gamma3=0.6,omega_tau=3,omega_n=0,omega3=0 --times 0.1,3
anew
sed -i '/^valid/d' spherical_top.tt
expect 2 "--contact end: spherical_top has no record 'valid'" jellett fates ./spherical_top.tt --grid 3x3 --contact end
expect 0 'turn over$' jellett fates ./spherical_top.tt --grid 3x3
grep contact out err && fail 'a condition is told of that the table asked for has not'
expect 0 'turned,turned_error$' jellett fates ./spherical_top.tt --grid 3x3 --sweep E=1:2:2
anew
for table in spherical_top spherical_top_balanced; do echo '# a comment' >> $table.tt; done
expect 3 'spherical_top_balanced.tt beside it: put the one that is built in there, or follow yours by jellett simulate' \
    jellett portrait ./spherical_top.tt --set a3=0,I1=2/5,I3=1/4 --start gamma3=0.5,v_nu=0.8,omega_tau=0,omega_n=0.1,omega3=0.9

# So also where a tier's table has a pole that this one, whose first state is another, does not name.
anew
sed -i -e '/^pole/d' -e '/^matrix/,/^charpoly/d' -e '/^state gamma3/{h;d}' -e '/^state omega3/{p;x}' spherical_top.tt
expect 0 'spherical_top names none (record .pole.)' jellett simulate ./spherical_top.tt --start $start --times 1,10
grep -q '^t,v_nu' out && [ "$(last 10)" = left_domain ] || fail "at a pole that is not named: $(tail -2 out)"

# On sections as well, and by the states of the table asked for: here c = -gamma3.
anew
sed -i '/^pole/d' spherical_top.tt
for what in "section --returns 9" "drift --returns 9 --method gauss" "fates"; do
    jellett $what ./spherical_top.tt --start eta=0.1,gamma3=-0.97 > out 2> err || true
    grep -q left_domain out && ! grep pole. out || fail "$what, at a pole that is not named: $(tail -2 out)"
done
expect 0 '^E,starts,lost_contact,equilibrium,left_domain,alive,budget,failed,contact_held$' \
    jellett fates ./spherical_top.tt --grid 3x3 --sweep E=1:2:2
# Where the pole is named but not proved, as for a time of which ttc cannot tell that it comes there, no orbit ends at it.
anew
sed -i 's/^time regular : s lifting s/time regular : s^2 lifting s/' spherical_top.tt spherical_top_level.tt
expect 0 '^-2,0.5,left_domain' jellett fates ./spherical_top.tt --start eta=-2,gamma3=0.5
# A time that does not run forwards everywhere is not taken: rows are those of the table without the edit.
anew
sed -i 's/^time regular : s lifting s/time regular : s*(1 - 2*gamma3) lifting s/' spherical_top.tt spherical_top_level.tt
expect 0 '^0,2,3.963135032' jellett section ./spherical_top.tt --start eta=0.1,gamma3=0.6 --returns 2
expect 0 '^5,-0.2084521262' jellett simulate ./spherical_top.tt --times 5 \
    --start gamma3=0.7,v_nu=0.5,omega_tau=0.3,omega_n=1,omega3=0.8
anew
sed -i -e 's/^state gamma3 in/state c in/' -e 's/^root s = .*/let gamma3 = -c\nroot s = sqrt(1 - c^2)/' \
    -e 's/^eq gamma3 =/eq c =/' -e 's/^    + s\*omega_tau$/    - s*omega_tau/' -e 's/^pole gamma3/pole c/' \
    -e 's/rate(gamma3)/rate(-c)/' -e '/^# The horizontal momentum/,$d' spherical_top.tt
sed -i 's/^    gamma3 = gamma3\(, v_nu = v_nu, omega_tau = omega_tau, omega_n\)/    c = -gamma3\1/' spherical_top_level.tt
for what in "section --returns 9" "drift --returns 9 --method gauss" "fates"; do
    jellett $what ./spherical_top.tt --start eta=0.1,gamma3=-0.97 > out 2> err || true
    grep -q pole- out && ! grep pole+ out || fail "$what, at the lower end of c: $(tail -2 out)"
done
expect 0 '12 starts: .*; of 6 .* turn over' jellett fates ./spherical_top.tt --grid 3x4
turned=$(sed -n 's/.*; of 6 \(.*\) turn over.*/\1/p' err)
expect 0 "; of 6 $turned turn over" jellett fates spherical_top --grid 3x4

# What turns over is told by the section's own coordinate, whatever it is called: the top and its mirror image turn over alike.
expect 0 '24 starts: .*; of 12 .* turn over' jellett fates spherical_top --set a3=0.5 --grid 6x4
turned=$(sed -n 's/.*; of 12 \(.*\) turn over.*/\1/p' err)
anew
sed -i -e 's/\<gamma3\>/z/g' -e 's/ z = z,/ gamma3 = z,/' spherical_top_section.tt
sed -i 's/ gamma3 = gamma3, E = E$/ z = gamma3, E = E/' spherical_top_level.tt
expect 0 "; of 12 $turned turn over" jellett fates ./spherical_top.tt --set a3=-0.5 --grid 6x4

# Every integral that the table asked for proves drifts along one orbit, and none that it does not, whatever levels and states are
# called in the tables beside it.
drifts() { # COLUMNS MODEL ARGUMENTS...
    local columns=$1
    shift
    expect 0 "^method,returns,t,evaluations,$columns$" jellett drift "$@" --method gauss --returns 2
    awk -F, '/^gauss/ { for (i = 5; i <= NF; i++) bad += $i > 1e-12; t = $3 }
        END { exit bad || (t - 6.976234469625) ^ 2 > 1e-22 }' out || fail "drift $*: $(tail -2 out)"
}
drifts drift_E,drift_G spherical_top
anew
sed -i -e 's/^integral E = .*/&\nintegral twice = 2*energy/' -e 's/^integral G/integral Jellett/' -e 's/G = G\>/G = Jellett/' \
    -e 's/by G =/by Jellett =/' -e 's/^\(leftnull.*\) G/\1 Jellett/' spherical_top.tt
drifts drift_E,drift_twice,drift_Jellett ./spherical_top.tt
drifts drift_E,drift_twice,drift_Jellett ./spherical_top.tt --project
sed -i 's/^integral E = .*/&\nintegral none = v_nu/' spherical_top.tt
drifts drift_E,drift_twice,drift_Jellett ./spherical_top.tt
expect 3 'none is not proved to be an integral' jellett drift ./spherical_top.tt --project --returns 2
for k in 3 4 5 6 7 8; do sed -i "s/^integral twice/integral times$k = $k*energy\n&/" spherical_top.tt; done
expect 2 'spherical_top proves more than 8 integrals' jellett drift ./spherical_top.tt --returns 2
expect 0 'drift_E,drift_G,drift_E1,drift_E2$' jellett drift --set I3=0 --returns 1
anew
sed -i -e 's/\<omega_tau\>/first/g' -e 's/\<omega_n\>/omega_tau/g' -e 's/\<first\>/omega_n/g' -e '/^# The horizontal momentum/,$d' \
    -e 's/omega_n = omega_n, v_tau/omega_tau = omega_n, v_tau/' spherical_top.tt
sed -i 's/omega_tau = omega_tau, omega_n = omega_n, omega3/omega_tau = omega_n, omega_n = omega_tau, omega3/' spherical_top_level.tt
drifts drift_E,drift_G ./spherical_top.tt
anew
sed -i '/^pole/d' spherical_top_level.tt
expect 3 '^# gauss: ends by left_domain at t = 1.75701[67]' \
    jellett drift ./spherical_top.tt --start eta=0.1,gamma3=-0.97 --returns 9 --method gauss
anew
sed -i -e '/^time regular/d' -e '/^pole/d' spherical_top.tt
expect 0 'G has no drift: the orbit is followed in spherical_top_level, where it is a parameter' \
    jellett drift ./spherical_top.tt --returns 2 --method gauss

# A level and a parameter of one name could not be told apart.
anew
sed -i -e 's/\<E\>/H/g' -e 's/^param I1/param E\n&/' -e 's/^default /&E = 7, /' -e 's/^observe /observe squeezed = E*gamma3\n&/' \
    spherical_top.tt
expect 3 'the section turning of spherical_top_level has a level E, which is a parameter of spherical_top: rename one' \
    jellett section ./spherical_top.tt "${section[@]}" --level E=2
# Nor a level and an integral that holds under a condition, which the reduction does not compare with it.
anew
sed -i -e 's/^integral E = .*/integral H = energy/; s/^integral F0/integral E/; s/ : E, G, F0$/ : H, G, E/; s/ : E, G$/ : H, G/' \
    spherical_top.tt
expect 3 'the section turning of spherical_top_level has a level E, which is a conditional integral of spherical_top: rename one' \
    jellett section ./spherical_top.tt "${section[@]}" --set a3=0 --level E=2

# What is advised can be done: names are those of the table asked for, and what no record could mend is not asked to be written.
anew
sed -i -e 's/\<omega_tau\>/wt/g' -e 's/\<wt = wt\>/omega_tau = wt/' spherical_top.tt
expect 3 'ask for one of the table itself, --section STATE=VALUE' jellett section ./spherical_top.tt "${section[@]}"
expect 3 'known of the states of spherical_top alone, and ./spherical_top.tt differs in the state omega_tau' \
    jellett rod ./spherical_top.tt --start ${start/omega_tau/wt}
anew
sed -i '/^reversor/d' spherical_top_level.tt
expect 3 "write 'reversor STATE -> -STATE' in the table of spherical_top_level$" \
    jellett separation ./spherical_top.tt --grid 2x2 --cells 2x2
expect 3 "write 'reversor STATE -> -STATE' in the table of spherical_top_level$" \
    jellett orbits ./spherical_top.tt --line gamma3=-0.7:-0.6:3 --start eta=0,gamma3=-0.61
anew
sed -i 's/\<g\>/grav/g' spherical_top.tt
expect 3 "there is no section turning, then" jellett section ./spherical_top.tt "${section[@]}"
expect 3 "the claim 'reduction level' of ./spherical_top.tt, .* the parameter g of spherical_top_level.tt is given no value" \
    jellett rod ./spherical_top.tt --start $start

anew
sed -i 's/^eq v_slip =/&\n    - v_slip/' spherical_top_balanced.tt
expect 3 'reduction half is not proved of this table: dF0/dt' jellett section ./spherical_top_balanced.tt "${section[@]}"
grep 'embedded' err && fail 'a table is called embedded though that is refuted'
anew
echo 'garbage here' >> spherical_top_balanced.tt
expect 3 "'reduction momentum' of ./spherical_top.tt, .* not be read: ./spherical_top_balanced.tt:[0-9]*:1: 'garbage'" \
    jellett portrait ./spherical_top.tt --set a3=0 --start $start

# The same where the table asked for is to the letter what is built in, and tables at one remove.
anew
sed -i 's/^    + R\*omega_n\*omega3$/    + 2*R*omega_n*omega3/' spherical_top_balanced.tt
expect 3 'the reduction momentum of ./spherical_top.tt leads to another one, spherical_top_balanced.tt beside it' \
    jellett portrait ./spherical_top.tt --set a3=0 --start gamma3=0.25,v_nu=0.8,omega_tau=-0.6,omega_n=0.1,omega3=-0.3
anew
sed -i 's/^    + omega_n\/s$/    + 2*omega_n\/s/' spherical_top_plane.tt
expect 3 'the reduction half is not proved of spherical_top_balanced: chain rule' \
    jellett simulate ./spherical_top.tt --tier plane --set a3=0 --start $start --times 1

# What no parameters and no start would mend is not said to be mended by them, but what they would mend is.
anew
sed -i -e 's/^eq omega_tau =/&\n    - gamma3*s\/D/' -e '/^lift track/,+1d' spherical_top.tt
expect 3 'reduction momentum: .*: leave this tier out$' \
    jellett simulate ./spherical_top.tt --tier plane --set a3=0,I1=2/5,I3=1/4 --start $start --times 1
expect 3 'where I3 > 0: leave this tier out, or change --set or --start$' \
    jellett simulate --tier full --set I3=0 --start $start --times 1
anew
sed -e 's/^model spherical_top$/model my_top/' -e '/^lift track/,+1d' spherical_top.tt > my.tt
expect 3 'spherical_top, not for this one: leave this tier out$' jellett simulate ./my.tt --tier full --start $start --times 1
sed -i '/^lift track/,+1d' spherical_top.tt
expect 3 '^jellett: --track: no table that observes more than this one serves' \
    jellett simulate ./spherical_top.tt --track --set I3=0 --start $start --times 1
expect 0 'tier full' jellett simulate ./spherical_top.tt --track --start $start --times 1

# A density that is none is a check that failed.
anew
sed -i 's/^measure rho = s\*(I1 + m/measure rho = s*(I1 + 2*m/' spherical_top.tt
expect 1 'the density rho is not invariant' jellett measure ./spherical_top.tt --set I3=0
# Headers name what is no integral of the table asked for, whichever table serves.
anew
sed -i '/^integral E = energy/a integral H = energy + v_nu' spherical_top.tt
expect 0 '^# these rest on claims that are not proved: integral H$' jellett simulate ./spherical_top.tt --start $start --times 0,1
grep -q '^# tier level' out && grep -q '"unproved":"integral H"' out || fail "the header: $(head -6 out)"

# An end of an interval that is no pole is called by its name.
anew
sed -i 's/^state gamma3 in (-1, 1)/state gamma3 in (-1, 1\/2)/' spherical_top.tt
expect 4 'gamma3 is at the end 0.5 of its interval' jellett simulate ./spherical_top.tt --times 0,5 \
    --start gamma3=0.25,v_nu=0.8,omega_tau=-0.6,omega_n=1.1,omega3=-2.3

# A sweep tells how many of its points were refused.
expect 0 '2 of 3 points refused what was asked, and have no rows' \
    jellett simulate --sweep a3=0:0.2:3 --tier balanced --start $start --times 0,1

# A larger table beside a copy of this one under another name: which one it is proved for, and what would have to be written.
anew
sed 's/^model spherical_top$/model my_top/' spherical_top.tt > my.tt
expect 3 "another table, spherical_top, not for this one; a record 'reduction NAME : onto FILE with" \
    jellett simulate ./my.tt --track --start $start --times 1
sed -i 's/^eq omega3 =/&\n    + omega3/' spherical_top_track.tt
expect 3 "it is proved to serve for no table; a record 'reduction NAME" jellett simulate ./my.tt --track --start $start --times 1

# A table beside that is edited once the first one was read, here while that is compiled, is neither taken nor done without.
anew
echo '# a comment' >> spherical_top.tt
sed 's/^eq x =/&\n    + 1/' spherical_top_track.tt > edited
printf '#!/bin/sh\ncp "%s/edited" "%s/spherical_top_track.tt"\nexec cc "$@" -O0\n' "$PWD" "$PWD" > editor
chmod +x editor
expect 5 'spherical_top_track.tt was edited after this computation had begun with it: begin again' \
    env CC="$PWD/editor" jellett simulate ./spherical_top.tt --start $start --times 1 --track

# A chain of reductions `onto` tables of one's own leads to the section of the last one; but not from the level of an integral that
# the table between does not have: its value there may be another.
cp "$JLT_SOURCE_DIR"/tools/docs/henon*.tt .
sed -i 's/ in (-1, 1)$//' henon_section.tt
sed 's/^model henon$/model between/; /^reversor/,$d' henon.tt > between.tt
printf '%s\n' 'state u' 'eq u = x' 'reduction inner : onto henon.tt with x = x, y = y, px = px, py = py' >> between.tt
sed 's/^model between$/model outer/; s/^reduction.*/state w/; s/^integral H = \(.*\)/integral H = 2*(\1)/' between.tt > outer.tt
printf '%s\n' 'eq w = u' 'reduction inner : onto between.tt with x = x, y = y, px = px, py = py, u = u' >> outer.tt
expect 0 '^0,1,' jellett section ./henon.tt --start y=0.1,py=0 --returns 1
direct=$(last 1-9)
expect 1 'integral H of outer - of between = ' ttc prove outer.tt
sed -i '/^integral H/d' between.tt
expect 3 'an integral that no proof compares with it' jellett section ./outer.tt --start y=0.1,py=0 --returns 1
sed -i 's/^integral H = 2\*(\(.*\))/integral J = 2*(\1)/' outer.tt
expect 0 '^0,1,' jellett section ./outer.tt --start y=0.1,py=0 --returns 1
[ "$(last 1-9)" = "$direct" ] || fail "a chain of reductions: $(last 1-9), not $direct"
# Nor is an integral compared that is claimed only where another quantity vanishes.
sed 's/^model henon$/model outer/; /^reversor/,$d; s/^integral H = \(.*\)/integral H = 2*(\1) modulo Z/' henon.tt > outer.tt
printf '%s\n' 'state u' 'eq u = x*u' 'invariant Z = u' >> outer.tt
echo 'reduction inner : onto henon.tt with x = x, y = y, px = px, py = py' >> outer.tt
expect 3 'a level H, which is a conditional integral of outer' jellett section ./outer.tt --start y=0.1,py=0 --returns 1

# Nor to a level that the section gives by an integral of another name, of this table or the last one; nor to a parameter of the
# last table that is a level of a table behind the first. Plans and scenes follow the others.
sed -i 's/^integral H = \(.*\)/integral E = \1/; s/H = H beside/H = E beside/' henon.tt
sed -i 's/^reduction/integral H = 2*(px^2 + py^2 + x^2 + y^2) + 4*x^2*y - 4*y^3\/3\n&/' between.tt
expect 0 '^0,1,' jellett section ./henon.tt --start y=0.1,py=0 --returns 1
expect 3 'a level H, which is an integral that no proof' jellett section ./between.tt --start y=0.1,py=0 --returns 1
sed -i 's/^integral E = \(.*\)/&\nintegral H = 2*(\1)/' henon.tt
expect 3 'a level H, which is an integral that no proof' jellett section ./henon.tt --start y=0.1,py=0 --returns 1
printf '%s\n' 'model last' 'param G > 0' 'default G = 1' 'state x' 'state p' 'eq x = p' 'eq p = -x*G' \
    'embedding up : into third.tt with x = x, p = p, z = G' 'section s : by rows.tt at x = 0 with p = p' > last.tt
printf '%s\n' 'model rows' 'param G > 0' 'default G = 1' 'state p' 'lift into last.tt with x = 0, p = p' > rows.tt
printf '%s\n' 'model third' 'state x' 'state p' 'state z in (0, inf)' 'eq x = p' 'eq p = -x*z' 'eq z = 0' > third.tt
sed 's/^model third$/model second/' third.tt > second.tt
printf '%s\n' 'state u' 'eq u = x' 'reduction down : onto third.tt with x = x, p = p, z = z' >> second.tt
sed 's/^model second$/model first/; s/^reduction.*/integral G = 4*z\nstate w\neq w = u/' second.tt > first.tt
echo 'reduction down : onto second.tt with x = x, p = p, z = z, u = u' >> first.tt
printf '%s\n' 'integral G = z' 'reduction down : by last.tt with x = x, p = p, G = G' >> third.tt
for table in third second; do expect 0 '^0,1,3.14159' jellett section ./$table.tt --start p=1 --returns 1 --level G=4; done
printf '%s\n' 'model = "./second.tt"; levels = { G = 4; };' \
    'compute = ({ what = "section"; start = { p = 1; }; returns = 1; });' > second.scene
expect 0 '^0,1,3.14159' jellett run second.scene
expect 0 ' 2  last .*taken: its table describes the section' jellett plan section ./second.tt --start p=1 --level G=4
expect 3 'a level G, which is an integral that no proof' jellett section ./first.tt --start p=1 --returns 1 --level G=4
# Nor is that level the parameter of its name in a table between, of which it is not made.
sed -i 's/^state x$/param G\ndefault G = 1\n&/; s/^eq u = x/eq u = G*x/' second.tt
sed -i 's/^integral G.*/state y\neq y = 0\neq u = y*x\nintegral G = y/; /^eq u = x/d; s/u = u$/&, G = G/' first.tt
expect 0 'proved      reduction   down' ttc prove first.tt
expect 3 'a level G, which is an integral that no proof' jellett section ./first.tt --start p=1 --returns 1 --level G=4

# Nor does a chain lead past a reduction that holds on zero levels alone: no orbit of first.tt, where z > 0, is one of last.tt. Nor
# past one onto a table whose domain is wider: there motions go on where those of the asked table have ended.
printf '%s\n' 'model last' 'state x' 'state p' 'eq x = p' 'eq p = -x' 'section s : by rows.tt at x = 0 with p = p' > last.tt
printf '%s\n' 'model rows' 'state p' 'lift into last.tt with x = 0, p = p' > rows.tt
printf '%s\n' 'model second' 'state x' 'state p' 'state z' 'eq x = (1 + z)*p' 'eq p = -(1 + z)*x' 'eq z = 0' 'integral Z = z' \
    'reduction on : onto last.tt with x = x, p = p modulo Z' > second.tt
sed 's/^model second/model first/; s/^state z/& in (0, inf)/; /^integral/,$d' second.tt > first.tt
echo 'reduction down : onto second.tt with x = x, p = p, z = z' >> first.tt
for table in first second; do
    expect 3 'the reduction on of .* holds only where Z = 0' jellett section ./$table.tt --start p=1 --returns 1
done
sed -i 's/^eq z = 0/eq z = x/; s/(1 + z)\*//' first.tt
sed -i '/^reduction/d; s/^model first/model second/; s/ in (0, inf)//' first.tt
echo 'reduction on : onto last.tt with x = x, p = p' >> first.tt
expect 0 '^0,1,6.28318530' jellett section ./first.tt --start p=1 --returns 1
for bound in 's/^state z/& in (-1, 1)/' 's/^state x/& in (-2, 2)/' '/^state z/a domain z : 1 - z^2 > 0'; do
    sed "$bound" first.tt > second.tt
    expect 0 'proved      reduction   on' ttc prove second.tt
    expect 3 'the reduction on of second leads onto last, where [xz] does not bound the motion' \
        jellett section ./second.tt --start p=1 --returns 1
done

# A claim is about the table of the file's name, whatever model that calls itself.
printf '%s\n' 'model left' 'state x' 'eq x = -x' 'lift up : into both.tt with X = x, Y = 0' > right.tt
printf '%s\n' 'model both' 'state X' 'state Y' 'eq X = -X' 'eq Y = -Y' 'reduction other : onto left.tt with x = 2*X' \
    'reduction back : onto right.tt with x = X' > both.tt
expect 0 '1 of 1 proved' jellett verify ./right.tt
sed -i 's/other : onto left/other : onto right/; s/back : onto right/back : onto left/' both.tt
expect 1 'right.tt:4: where the way leads is elsewhere' jellett verify ./right.tt

# A larger table whose own reduction is refuted does not serve, and each command that has looked at it says so: also where its
# kernels are in the cache. What lists the table alone does not say that the larger one serves.
printf '%s\n' 'model small' 'state x' 'eq x = -x' 'tier small "small"' 'lift up : into large.tt with x = x, y = 0' > small.tt
printf '%s\n' 'model large' 'state x' 'state y' 'eq x = -2*x' 'eq y = x' 'tier large "large"' \
    'reduction back : onto small.tt with x = x' > large.tt
for cached in no yes; do
    expect 0 'large .* no: .*reduction back: chain rule' jellett plan simulate ./small.tt --start x=1 --until 1
    grep -q "back' is refuted\|reduction back of large is refuted" err ||
        fail "nobody warns of the larger table (in the cache: $cached): $(cat err)"
done
expect 0 'up  *part of large  if its reduction is proved' jellett models ./small.tt
exit $status
