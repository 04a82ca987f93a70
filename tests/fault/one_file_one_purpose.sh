#!/usr/bin/env bash
# No file serves two purposes: options and scenes that name one twice, or a file that they read, are refused before anything is
# written, by whatever name it goes. A file that is written is reached through its links, and keeps its permissions.
source "$JLT_SOURCE_DIR/tests/scratch.sh"

at=gamma3=0.5,v_nu=0.8,omega_tau=0,omega_n=0,omega3=0.9
section="section --start eta=0.1,gamma3=-0.6 --returns 5"
manifolds="manifolds --length 0.2 --count 20"
mkdir folder
ln -s . loop
ln -s new.svg to_new
for file in old.svg old.csv old.tt; do echo content > $file; done
ln old.svg hard
ln -s ../old.svg folder/soft
ln -s ../old.tt folder/table
cp "$JLT_SOURCE_DIR/tests/reference/data/grid_regular_51.csv" reference.csv
before=$(ls -AR)
refused() { # STATUS ARGUMENTS
    local want=$1 code
    shift
    # shellcheck disable=SC2086
    jellett $* > /dev/null 2> "$scratch.err"
    code=$?
    [ $code -eq "$want" ] || fail "$*: status $code, not $want: $(head -2 "$scratch.err")"
    [ -s "$scratch.err" ] || fail "$*: says nothing"
    [ "$(ls -AR)" = "$before" ] || fail "$*: leaves $(ls -A | tr '\n' ' ')"
    [ "$(cat old.svg old.csv old.tt | uniq -c | tr -d ' ')" = 3content ] || fail "$*: an old file is changed"
}
refused 2 "$section -o same.svg --plot same.svg"
refused 2 "$section --keep same.svg --plot loop/same.svg"
refused 2 "$section --keep ./same.svg --plot same.svg"
refused 2 "$section -o to_new --plot new.svg"
refused 2 "$section -o hard --plot old.svg"
refused 2 "$section -o folder/soft --plot old.svg"
refused 2 "$section --plot same.svg --keep same.svg"
refused 2 "$section -o same --plot p.svg --keep same"
refused 2 "$section -o old.tt"
refused 2 "$section -o folder/table"
refused 2 "$section --plot p.svg --keep old.tt"
refused 2 "$manifolds --crossings old.tt"
refused 2 "$manifolds -o same --crossings same"
refused 2 "$manifolds --crossings same.svg --plot same.svg"
refused 2 "portrait --set I1=2/5,I3=1/4 --start $at -o same --trajectories same"
refused 2 "portrait --set I1=2/5,I3=1/4 --start $at --trajectories -"
refused 2 "eigen --set a3=0 --at gamma3=0.3,v_nu=0.7,omega3=1.1 -o same.svg --plot same.svg"
refused 2 "bench section --quick --form level --reference reference.csv -o reference.csv"
jellett $section --plot shown.svg > shown.svg 2> /dev/null && fail "standard output and a picture into one file"
rm -f shown.svg
cmp -s reference.csv "$JLT_SOURCE_DIR/tests/reference/data/grid_regular_51.csv" || fail "the reference is changed"

scene() { # FILE-KEYS of two jobs
    printf 'compute = ( { what = "section"; start = { eta = 0.1; gamma3 = -0.6; }; returns = 5; %s },
                { what = "section"; start = { eta = 0.1; gamma3 = -0.6; }; returns = 5; %s } );\n' "$1" "$2" > s.scene
    before=$(ls -AR)
}
scene 'output = "s.scene";' ''
refused 3 "run s.scene"
refused 3 "run loop/s.scene"
cp s.scene copy
mkdir into
before=$(ls -AR)
refused 3 "run --into loop s.scene"
scene 'output = "t.csv";' 'output = "./t.csv";'
refused 3 "run s.scene"
scene '' 'output = "t.svg"; plot = "t.svg";'
refused 3 "run s.scene"

# Written through links, also one that leads nowhere yet; a pipe as /dev/stdout; permissions stay.
chmod 640 old.csv
ln -s ../old.csv folder/link
ln -s nowhere.csv dangling
jellett $section -o folder/link 2> /dev/null || fail "writing through a link"
{ [ -L folder/link ] && grep -q alive old.csv && [ "$(stat -c %a old.csv)" = 640 ]; } || fail "a link: $(ls -l folder/link old.csv)"
jellett $section -o dangling 2> /dev/null
{ [ -L dangling ] && grep -q alive nowhere.csv; } || fail "a link to nowhere: $(ls -l dangling)"
(umask 027 && jellett $section -o masked.csv 2> /dev/null)
[ "$(stat -c %a masked.csv)" = 640 ] || fail "the umask: $(ls -l masked.csv)"
[ "$(jellett $section -o /dev/stdout 2> /dev/null | grep -c alive)" -eq 6 ] || fail "-o /dev/stdout into a pipe"
[ -z "$(find . -name '*.??????')" ] || fail "left: $(find . -name '*.??????')"

# Standard output closed: no matter where it is not needed, status 5 where it is.
jellett $section -o closed.csv --plot closed.svg --keep closed.gp >&- 2> err || fail "standard output closed: $(cat err)"
[ "$(grep -c alive closed.csv)" -eq 6 ] && head -c 100 closed.svg | grep -q '<?xml' || fail "standard output closed: wrong files"
jellett $section >&- 2> err
[ $? -eq 5 ] && [ -s err ] || fail "rows to a closed standard output: $(cat err)"
jellett $section -o closed2.csv >&- 2>&- <&- || fail "all closed"
[ "$(grep -v '^#' closed2.csv | sort -u | wc -l)" -eq 7 ] || fail "all closed: $(head -5 closed2.csv)"

# A file that may not grow keeps the whole rows written so far, and says so.
(ulimit -f 4; jellett section --grid 20x20 --returns 100 -o limited.csv 2> err)
[ $? -eq 5 ] && grep -q "whole rows before are saved" err || fail "a limit on files: $(cat err)"
[ "$(tail -c 1 limited.csv | od -An -c | tr -d ' ')" = '\n' ] || fail "a limit on files: the last row is cut"
[ "$(tail -n 1 limited.csv | tr -cd , | wc -c)" -eq 8 ] || fail "a limit on files: the last row is not whole"
[ -z "$(find . -name '*.??????')" ] || fail "left: $(find . -name '*.??????')"
# A picture that cannot be drawn, as there is no gnuplot, takes no table with it; one without a folder is refused at once.
program=$(command -v jellett)
for command in "$section" "measure --set I3=0" "eigen --set a3=0 --at gamma3=0.3,v_nu=0.7,omega3=1.1" \
    "eigen --set a3=0 --at v_nu=0.7,omega3=1.1 --sweep gamma3=0:0.5:3"; do
    rm -f kept.csv
    PATH=none "$program" $command -o kept.csv --plot p.svg 2> err
    [ $? -eq 5 ] && [ -s kept.csv ] && grep -q "table is saved in kept.csv" err || fail "$command: no picture: $(cat err)"
    rm -f kept.csv
    jellett $command -o kept.csv --plot none/p.svg 2> err
    [ $? -eq 5 ] && [ ! -e kept.csv ] || fail "$command: a picture in no folder: $(cat err)"
done
# Where gnuplot cannot be run, the reason is told.
(ulimit -n 5; jellett $section -o kept.csv --plot p.svg 2> err)
[ $? -eq 5 ] && grep -q 'Too many open files' err || fail "few descriptors: $(cat err)"
# The longest name that a file can have is one for results.
long=$(printf 'a%.0s' {1..251})
jellett $section -o "$long.csv" --plot "$long.svg" 2> err && [ -s "$long.csv" ] && [ -s "$long.svg" ] || fail "long: $(cat err)"
[ "$(find . -name 'aaa*' | wc -l)" -eq 2 ] || fail "left beside long names: $(find . -name 'aaa*')"
exit $status
