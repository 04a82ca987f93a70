#!/usr/bin/env bash
# What a command cannot use it refuses before it writes anything: nothing on standard output, no file, and a message that
# names the option and says what to write. No option is accepted and then ignored.
source "$JLT_SOURCE_DIR/tests/scratch.sh"

refuse() { # STATUS WORDS COMMAND...: WORDS is a pattern for the message
    local want=$1 words=$2 code
    shift 2
    "$@" > "$scratch/.out" 2> "$scratch/.err" < /dev/null
    code=$?
    [ $code -eq "$want" ] || fail "$*: status $code, not $want"
    [ ! -s "$scratch/.out" ] || fail "$*: writes to standard output before it refuses"
    grep -qE -- "$words" "$scratch/.err" || fail "$*: says '$(head -c 300 "$scratch/.err")', not '$words'"
    [ "$(ls)" = folder ] || { fail "$*: leaves $(ls)"; find . -name '[a-z]*' ! -name folder -delete; }
}

mkdir folder
start=gamma3=0.2,v_nu=0.6,omega_tau=0.4,omega_n=1,omega3=0
point=eta=0.1,gamma3=-0.6

# A start that no row can begin with.
for command in section fates "lyapunov --returns 5" "continue --along E=2:2.2" "drift --returns 2" \
    "orbits --period 1" "manifolds --length 0.01"; do
    # shellcheck disable=SC2086
    {
        refuse 3 "gamma3 must lie strictly between -1 and 1" jellett $command --start eta=0.1,gamma3=1
        refuse 3 "gamma3 must lie strictly between -1 and 1" jellett $command --start eta=0.1,gamma3=-1
        refuse 3 "'nan' is no finite number" jellett $command --start eta=0.1,gamma3=nan
        refuse 3 "give gamma3 as well" jellett $command --start eta=0.1
        refuse 3 "no coordinate 'x'" jellett $command --start "x=1,$point"
        refuse 2 "is no start" jellett $command --start eta=0.1,gamma3=-0.6:-0.5:3
    }
done
refuse 3 "eta=-1,gamma3=0.9: the orbit ends before it returns: take another start" jellett orbits --start eta=-1,gamma3=0.9
refuse 3 "'jellett section' tells which" jellett orbits chaplygin_sleigh --section v=0 --start w=1 --set a=1
# A start that returns is not to blame for where Newton's steps lead.
refuse 4 "finds no periodic orbit from eta=1,gamma3=0.9, where .* the other way" jellett orbits --start eta=1,gamma3=0.9
refuse 3 "gamma3 must lie" jellett section --start "$point" --start eta=0,gamma3=2
for command in "continue --along =1:2" "fates --section =0" "fates --grid =0:1:2" "fates --sweep =0:1:2"; do
    # shellcheck disable=SC2086
    refuse 2 "^jellett: --[a-z]*: no name stands before '='$" jellett $command
done
refuse 3 "--grid: no state has these levels" jellett section --grid eta=0,gamma3=2:3:3 --output rows
refuse 3 "--grid: no state has these levels" jellett fates --grid eta=0,gamma3=2:3:3 --output rows
refuse 3 "--sweep: no state has these levels" jellett fates --grid 2x2 --sweep E=-5:-4:2 --output rows
refuse 3 "--sweep: there is no parameter or level 'b'; there are m, R, g, I1, I3, a3, E, G" \
    jellett section --start "$point" --sweep b=1:2:2
refuse 3 "--sweep: there is no 'r'; there are the parameters sigma, rho, beta" \
    jellett section lorenz --section z=27 --start x=1,y=1 --sweep r=1:2:2
refuse 3 "--sweep: there is no 'J'; there are the parameters mu, and the levels of jacobi" \
    jellett section restricted_three_body --section y=0 --start x=0.5,vx=0,vy=1 --sweep J=2.9:3:2
refuse 3 "--sweep: no state has these levels" jellett fates --start eta=0.1,gamma3=0.9 --sweep E=0.35:0.5:2 --plot rows.svg
refuse 3 "2 of 2 points are outside the model's domain" jellett fates --grid 2x2 --sweep m=-5:-4:2 --output rows
refuse 3 "no coordinate 'x'" jellett section --grid x=0:1:3
refuse 3 "G = 0" jellett rod --start gamma3=0.2,v_nu=0,omega_tau=0,omega_n=0,omega3=0
refuse 2 "say where to start" jellett lyapunov lorenz --section z=27
refuse 2 "say where to start" jellett section lorenz
for command in section simulate continue "certify cycle" "certify pole"; do
    refuse 3 "there is no model 'nosuch' built in" jellett $command nosuch
done
refuse 2 "unrecognized option '--grdi'; did you mean '--grid'\?" jellett section --grdi=2x2
refuse 2 "unrecognized option '--verbos_'; did you mean '--verbose'\?" ttc prove --verbos_ lorenz.tt
refuse 2 "unrecognized option '--nothing'$" jellett section --nothing

# Ranges.
for range in E E=1 E=1:2:5 E=2:1; do refuse 2 "is no range \(write NAME=LOW:HIGH, LOW below HIGH\)" jellett continue \
    --along $range; done
refuse 3 "the branch starts at E=2.15: choose LOW:HIGH around it" jellett continue --along E=3:4
refuse 3 "I1 = -1: spherical_top needs I1 > 0" jellett rod --start "$start" --set I1=-1
refuse 3 "--sweep: more than 3 names" jellett rod --start "$start" --sweep v_nu=0:1:2,omega_n=1:2:2,gamma3=0:1:2,I1=1:2:2
refuse 3 "--cells: '0' is no whole number" jellett separation --grid 2x2 --cells 0x0
refuse 3 "--cells: eta has no width" jellett separation --grid 2x2 --cells eta=0.3,gamma3=-1:1:20
refuse 3 "--cells: the range of the angle eta is longer than its period" \
    jellett separation --grid 2x2 --cells eta=-4:4:20,gamma3=-1:1:20
refuse 3 "needs a section of two coordinates, not of 1$" jellett separation lotka_volterra --section x=1 --grid y=0.5:1:3
refuse 3 "--near: '-1' is not positive" jellett orbits --near -1
refuse 2 "is no section \(write STATE=VALUE\)" jellett section lorenz --start x=1,y=1 --section z
refuse 3 "--section: gamma3 must lie strictly between -1 and 1" jellett section --section gamma3=2 \
    --start v_nu=0,omega_tau=0,omega_n=0,omega3=0
refuse 2 "is no section \(write STATE=VALUE\)" jellett section lorenz --start x=1,y=1 --section z=1:2:3

lorenz=(jellett orbits lorenz --section z=27 --start x=1,y=1 --period 1)
refuse 4 "finds no periodic orbit from .* crossed the other way: try --direction down, or another --start" "${lorenz[@]}"
refuse 4 "finds no periodic orbit from .*: try another --start or --period" "${lorenz[@]}" --direction down

# Options that say nothing here.
refuse 2 "--mirror goes with --section" jellett section --start "$point" --mirror v_nu
refuse 3 "--mirror x: the field of lorenz is not reversed" "${lorenz[@]}" --direction down --mirror x
refuse 3 "--level: lorenz claims no integral .E." jellett section lorenz --start x=1,y=1 --section z=27 --level E=1 --solve x=1
refuse 2 "lorenz has no record .valid.: leave out --contact" jellett section lorenz --start x=1,y=1 --section z=27 --contact report
refuse 2 "unrecognized option '--contact" jellett orbits --contact report
refuse 2 "unrecognized option '--contact" jellett lyapunov --contact end
refuse 2 "--contact report writes a column of orbits, and rows here are boxes" jellett transfer --contact report --boxes 8x8
refuse 2 "--contact report writes a column of orbits, and rows of --sweep are shares" jellett fates --contact report --sweep E=1:2:2
refuse 2 "unrecognized option .--plot" jellett certify sink --plot picture.svg
for command in fates eigen lyapunov "rod --start $start"; do
    # shellcheck disable=SC2086
    refuse 2 "--sweep: no range is given" jellett $command --sweep ""
done
refuse 4 "a3 = 1e.300 is the farthest from 1: rescale the units" jellett section --set a3=1e300 --start "$point"
refuse 2 "--threads needs --sweep: add it" jellett eigen --threads 2
refuse 2 "--threads needs --grid or --sweep: add one" jellett lyapunov --threads 2
refuse 2 "the tier quadrature takes no steps: leave out --project" jellett simulate --set I3=0 --start "$start" --until 1 \
    --tier quadrature --project
refuse 3 "more points than can be counted" jellett rod --start "$start" --sweep \
    omega_n=1:2:4194304,v_nu=0:1:4194304,gamma3=0:0.1:2097152
refuse 3 "more points than can be counted" jellett fates --sweep E=1:2:4194304,G=0:1:2097152,a3=0:1:2097152
refuse 3 "has 1000000000000000000 points; at most 1000000000000 are computed" jellett section --grid 1000000000x1000000000
refuse 2 "--hold keeps coordinates of --start" jellett orbits --hold eta
refuse 3 "--hold eta,gamma3: no coordinate is left to solve for" jellett orbits --start "$point" --hold eta,gamma3
refuse 2 "--start and --grid exclude each other" jellett orbits --start "$point" --grid 3x3
refuse 2 "--start and --grid exclude each other" jellett lyapunov --start "$point" --grid 3x3
refuse 3 "--line: the section has no coordinate 'x'; it has eta, gamma3" jellett orbits --start "$point" --line x=0:1:3
for line in -0.6:-0.6:5 -0.5:-0.6:5 -0.7:-0.6:1; do
    refuse 3 "--line: gamma3 needs LOW below HIGH, and a COUNT of 2 or more" jellett orbits --start "$point" --line gamma3=$line
done
refuse 2 "exclude each other" jellett manifolds --no-crossings --crossings file
refuse 2 "--times and --until exclude each other" jellett simulate --start "$start" --times 1 --until 2
refuse 2 "two tables" jellett portrait --level E=1,G=-0.2,F0=0.15 --trajectories -
refuse 2 "two tables" jellett manifolds --length 0.01 --crossings -
refuse 2 "--project cannot be used with the multistep method msadams: take gauss or dop853" \
    jellett simulate --start "$start" --until 1 --project --method msadams
refuse 2 "say which section of lorenz" jellett fates lorenz
refuse 2 "say where orbits start" jellett fates lorenz --section z=27
{
    printf '%s\n' 'model many' 'state x' 'state y' 'eq x = y' 'eq y = -x'
    for i in {1..20}; do echo "valid v$i : x + $i > 0"; done
} > .many.tt
XDG_CACHE_HOME=$scratch/.cache refuse 3 "many has more records .valid. than can end an orbit: take --contact report" \
    jellett section ./.many.tt --section x=0 --start y=0.5 --returns 1 --contact end
printf 'model still\nstate x\neq x = -x\n' > .still.tt
XDG_CACHE_HOME=$scratch/.cache refuse 3 "still has no parameter 'c'; it has none\$" \
    jellett simulate ./.still.tt --start x=1 --set c=1 --times 1
# Certificates, boxes, shards.
saddle=(jellett certify cycle --start eta=0,gamma3=-0.6135)
refuse 3 "neither a parameter nor a level 'Q' here" "${saddle[@]}" --spread Q=0.1
refuse 3 "the radius of a3 is a number > 0" "${saddle[@]}" --spread a3=0
refuse 2 "counts crossings one way, up or down" "${saddle[@]}" --direction both
refuse 2 "'foo' is no kind of certificate: write cycle, elliptic" jellett certify foo
refuse 2 "say what to certify: cycle, elliptic" jellett certify
refuse 2 "say near which orbit: --start" jellett certify cycle
refuse 3 "give every state of spherical_top; v_nu has no value" jellett certify pole --start gamma3=0.2
refuse 3 "--family, one of spin, spin_weightless, precession" jellett certify equilibria --box gamma3=0.1:0.5
refuse 2 "'2' is not from 0 to 1" jellett transfer --boxes 10x10 --noise 2
refuse 2 "--noise: no value" jellett transfer --boxes 10x10 --noise ""
refuse 2 "leave out --eigenvalues 0" jellett transfer --boxes 10x10 --eigenvalues 0 --plot folder/p.svg
refuse 3 "no point of them has a state from which the section is crossed" \
    jellett transfer lorenz --section z=27 --boxes x=-1:1:4,y=-1:1:4
refuse 3 "2 have states; eigenvalues are of 3 boxes or more" jellett transfer --boxes eta=0:1e-3:2,gamma3=-0.9:-0.899:1
refuse 3 "nothing stays in them, for no box leads back to itself" jellett transfer --boxes eta=0:1e-3:4,gamma3=-0.9:-0.899:4
refuse 2 "'4/3': shards are counted from 1 to 3" jellett sweep none --shard 4/3
refuse 2 "'x' is no shard \(write I/N" jellett sweep none --shard x
refuse 3 "p1 is an angle by --modulo, for which a level has many solutions" \
    jellett section toda --section q1=0 --solve p1=1 --modulo p1=1 --level H=1 --start q2=0
data=$JLT_SOURCE_DIR/tests/reference/data
refuse 2 "jacobian knows no --method" jellett bench jacobian --method gauss
refuse 2 "slope knows no --form" jellett bench slope --reference "$data/slopes_regular_51.csv" --form five
refuse 2 "eigenvalues knows no --reference" jellett bench eigenvalues --reference "$data/grid_regular_51.csv"
refuse 3 "section: nothing goes by these names" jellett bench section --reference "$data/grid_regular_51.csv" --form none
refuse 3 "slope: nothing goes by these names; without --method" \
    jellett bench slope --reference "$data/slopes_regular_51.csv" --method none
refuse 5 "cannot read 'none': No such file" jellett bench section --reference none
refuse 3 "is no such table" jellett bench section --reference /dev/null
refuse 5 "cannot read 'folder': Is a directory" jellett check folder
refuse 5 "cannot read 'none': No such file" jellett check none
refuse 2 "there is no command 'sectoin' .did you mean 'section'" jellett help sectoin
cmp <(jellett help section) <(jellett section --help) && cmp <(ttc help prove) <(ttc prove --help) ||
    fail "help COMMAND is not COMMAND --help"

# Names that promise another kind of file.
for name in out.png out.PNG out.Pdf out.eps out.JPG; do
    refuse 2 "'folder/$name' would be text under a picture's name" jellett section --start "$point" -o folder/$name
done
refuse 2 "--keep: 'folder/p.PDF' would be a script under" jellett section --start "$point" --plot folder/p.svg --keep folder/p.PDF
refuse 2 "'folder/out.DB' would be a database" jellett section --start "$point" -o folder/out.DB
refuse 2 "a report is no table" jellett transfer --boxes 8x8 --json -o folder/out.npy

# The file that cannot be written is the one that is named.
refuse 5 "cannot write 'none/script'" jellett measure --set I3=0 --plot folder/p.svg --keep none/script --output folder/out
refuse 5 "cannot write 'none/p.svg'" jellett measure --set I3=0 --plot none/p.svg --output folder/out
refuse 5 "cannot write 'none/out'" jellett manifolds --output none/out
refuse 5 "cannot write 'none/crossings'" jellett manifolds --output folder/out --crossings none/crossings
[ -z "$(ls folder)" ] || fail "left in the folder: $(ls folder)"
refuse 5 "Is a directory" jellett run folder
refuse 5 "Is a directory" jellett plan folder
refuse 5 "cannot read 'none': No such file" jellett check none
refuse 3 "expected a certificate that .jellett certify. wrote" jellett check "$JLT_SOURCE_DIR/README.md"
printf 'model = lorenz;\n' > folder/bare.scene
refuse 3 "bare.scene:1: error: syntax error \(expected NAME = VALUE; each name once, texts in quotation marks" \
    jellett run folder/bare.scene
rm folder/bare.scene

# As many quantities as the limit allows, and one more.
{ printf 'model wide\nstate x\neq x = x\n'; for i in {2..4096}; do echo "let q$i = 1"; done; } > folder/wide.tt
ttc check folder/wide.tt 2>&1 | grep -q 'is well formed' || fail "4096 quantities are refused"
echo 'let more = 1' >> folder/wide.tt
refuse 3 "too many names \(expected at most 4096\)" ttc check folder/wide.tt
# Nor may powers within powers, which C spells as products, fill the memory.
power=x
for _ in {1..16}; do power="(1 + $power)^2"; done
printf 'model powers\nstate x\neq x = %s\n' "$power" > folder/wide.tt
ttc check folder/wide.tt 2>&1 | grep -q 'is well formed' || fail "powers in 16 powers are refused"
printf 'model powers\nstate x\neq x = ((1 + %s)^8)^-8\n' "$power" > folder/wide.tt
refuse 3 "written out in full is too large \(expected at most 1000000 operands" ttc check folder/wide.tt
rm folder/wide.tt

# ttc generate: why it cannot.
mkdir .tables
printf 'model large\nstate x\neq x = 1e400*x\n' > .tables/large.tt
sleigh=$JLT_SOURCE_DIR/codegen/models/chaplygin_sleigh.tt
refuse 3 "beyond double precision" ttc generate --out folder/out .tables/large.tt
refuse 3 "'chaplygin_sleigh/table.c' would be written twice" ttc generate --out folder/out "$sleigh" "$sleigh"
printf 'model a\nparam k\nstate x\neq x = k*x\nvariant b_c : k = 1\n' > .tables/a.tt
printf 'model a_b\nparam k\nstate x\neq x = k*x\nvariant c : k = 2\n' > .tables/a_b.tt
refuse 3 "a_b.tt:5:9: error: 'a/b_c.c' would be written twice, or names in it" \
    ttc generate --out folder/out .tables/a.tt .tables/a_b.tt
# Sections of two tables have names of their own.
printf 'model half\nstate x\nlift into a.tt with x = x, z = 0\n' > .tables/half.tt
for section in a.b_c a_b.c; do
    printf 'model %s\nstate x\nstate z\neq x = x\neq z = 1\nsection %s : by half.tt at z = 0 with x = x\n' \
        "${section%.*}" "${section#*.}" > ".tables/${section%.*}.tt"
done
ttc generate --out .tables/out .tables/a.tt .tables/a_b.tt || fail "sections b_c of a and c of a_b: no kernels"
[ "$(cat .tables/out/*/table.c | grep -o '^const char jlt_chart_[a-z0-9_]*' | sort -u | wc -l)" -eq 2 ] ||
    fail "sections b_c of a and c of a_b share a name"
refuse 5 "cannot make the folder none/out: No such file or directory" ttc generate --out none/out "$sleigh"
exit $status
