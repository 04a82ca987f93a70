#!/usr/bin/env bash
# A study gives the same bytes by 1, 3 and 7 shards, in CSV, NumPy and SQLite, and after crashes; its rows are those that the
# command itself prints, also for each value of what it runs over. A shard's file is one process's, and of one study.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
trap 'kill $(jobs -p) 2>/dev/null; wait; rm -rf "$scratch"' EXIT
unset OMPI_COMM_WORLD_RANK PMI_RANK PMIX_RANK SLURM_PROCID SLURM_ARRAY_TASK_ID PARALLEL_SEQ
expect() { # STATUS TEXT COMMAND...
    local want=$1 text=$2 code
    shift 2
    "$@" > out 2> err
    code=$?
    [ $code -eq "$want" ] || fail "$*: status $code, not $want: $(head -3 err)"
    [ -z "$text" ] || grep -qF -- "$text" out err || fail "$*: nothing is said of '$text': $(head -3 err)"
}
rows() { grep -v '^#' "$@"; }

cat > map.scene << 'END'
levels = { E = 2.15; G = -0.56; };
accuracy = { tolerance = 1e-9; };
piece = 7;
compute = ( { what = "section"; grid = { eta = (-3, 3, 9); gamma3 = (-0.9999, 0.9999, 15); }; returns = 3; } );
END
sed 's/section"/fates"/; s/piece = 7/piece = 11/' map.scene > ends.scene

# Shards, of which orbits are counted on through the points without a state.
for study in map ends; do
    expect 0 "" jellett run $study.scene
    rows out > $study.rows
    for n in 1 3 7; do
        for i in $(seq $n | shuf --random-source=<(yes $n)); do expect 0 "" jellett sweep $study.scene --into=$study.$n \
            --shard=$i/$n; done
        expect 0 "" jellett merge $study.$n -o $study.$n.csv -o $study.$n.npy -o $study.$n.sqlite
        rows $study.$n.csv | diff -q - $study.rows > /dev/null || fail "$study in $n shards: other rows than jellett run"
        for kind in csv npy sqlite; do cmp $study.1.$kind $study.$n.$kind || fail "$study in $n shards: another $kind"; done
    done
done
[ "$(wc -l < map.rows)" -gt 300 ] || fail "only $(wc -l < map.rows) rows of returns"

# NumPy and SQLite have what CSV has.
python3 - map.1 << 'END' || fail "the files differ"
import ast, csv, math, sqlite3, struct, sys
rows = list(csv.reader(l for l in open(sys.argv[1] + ".csv") if l[0] != "#"))
names, rows = rows[0], rows[1:]
data = open(sys.argv[1] + ".npy", "rb").read()
assert data[:8] == b"\x93NUMPY\x01\x00"
length = 10 + struct.unpack("<H", data[8:10])[0]
assert length % 64 == 0
form = ast.literal_eval(data[10:length].decode())
assert form["shape"] == (len(rows),) and not form["fortran_order"] and [n for n, _ in form["descr"]] == names
assert form["descr"][-1][0] == "fate" and form["descr"][-1][1].startswith("|S") and form["descr"][0][1] == "<f8"
code = "<" + "".join("d" if kind == "<f8" else kind[2:] + "s" for _, kind in form["descr"])
end = length + len(rows) * struct.calcsize(code)
assert data[end:].decode() == "".join(l for l in open(sys.argv[1] + ".csv") if l[0] == "#")
stored = list(sqlite3.connect(sys.argv[1] + ".sqlite").execute("SELECT * FROM rows ORDER BY rowid"))
assert len(stored) == len(rows)
empty = 0
for row, packed, kept in zip(rows, struct.iter_unpack(code, data[length:end]), stored):
    for field, number, value in zip(row, packed, kept):
        empty += field == ""
        if isinstance(number, bytes): assert number.rstrip(b"\0").decode() == field == value
        elif field == "": assert math.isnan(number) and value is None
        else: assert number == float(field) == value
assert empty > 0
about = dict(sqlite3.connect(sys.argv[1] + ".sqlite").execute("SELECT name, value FROM provenance"))
assert about["command"] == "section" and "spherical_top_level.tt" in about["kernels"]
indices = "SELECT name FROM sqlite_master WHERE type = 'index' AND name LIKE 'rows%'"
assert [n for n, in sqlite3.connect(sys.argv[1] + ".sqlite").execute(indices)] == ["rows_by_fate"]
END

# Crashes: the file ends anywhere, or its end is garbage, or it is empty.
file=map.3/2-of-3.shard
cp $file whole
size=$(stat -c %s whole)
for cut in 0 3 100 $((size / 3)) $((size / 2)) $((size - 1)); do
    head -c $cut whole > $file
    [ $cut = $((size / 2)) ] && head -c 5000 /dev/zero >> $file
    expect 0 "" jellett sweep map.scene --into=map.3 --shard=2/3 --resume
    expect 0 "" jellett merge map.3 -o again.csv -o again.sqlite
    cmp again.csv map.1.csv && cmp again.sqlite map.1.sqlite || fail "cut at $cut of $size: other bytes"
done
expect 0 "0 of them now" jellett sweep map.scene --into=map.3 --shard=2/3 --resume
# No more is said of the start of a piece than is known: one that took less than a millisecond was told to start in a millisecond.
sed 's/piece = 11/piece = 1/; s/returns = 3/returns = 1/' ends.scene > short.scene
expect 0 "much of which may be its start: 'piece = " jellett sweep short.scene --into=short
printf x | dd of=$file bs=1 seek=$((size / 2)) conv=notrunc 2> dd
expect 1 "pieces are missing" jellett merge map.3 -o none.csv
[ ! -e none.csv ] || fail "pieces are missing, and something is written"
expect 0 "bytes among its records are damaged" jellett sweep map.scene --into=map.3 --shard=2/3 --resume
grep -q '; 1 of them now' err || fail "one record is damaged, and more than its piece is computed again: $(cat err)"
mkdir full
for kind in csv npy sqlite; do # a full disk, played by a limit on the size of files
    (ulimit -f 1; trap '' XFSZ; jellett merge map.1 -o full/rows.$kind) 2> err
    [ $? -eq 5 ] && grep -q "cannot write 'full/rows.$kind'" err && [ -z "$(ls -A full)" ] || fail "no room, $kind: $(cat err)"
done
expect 0 "" jellett merge map.3 -o again.csv
cmp again.csv map.1.csv || fail "a record in the middle is damaged: other bytes"
# The damage is in the line of a record, which then seems to end elsewhere, or behind the file.
for digits in 0 1 99999999; do
    LC_ALL=C sed "0,/^piece \([0-9]*\) \([0-9]*\) [0-9]*/s//piece \1 \2 $digits/" whole > $file
    expect 0 "" jellett sweep map.scene --into=map.3 --shard=2/3 --resume
    grep -q '; 1 of them now' err || fail "a record says it has $digits bytes, and more than its piece is computed: $(cat err)"
    expect 0 "" jellett merge map.3 map.7 -o again.csv
    cmp again.csv map.1.csv || fail "shards of two runs at once: other bytes"
done
cp whole $file

# A file whose beginning is damaged is not begun anew over what it has, also where its first record seems to end behind the file.
cp $file whole
for damage in 1s/^study.0.0./\&9999/ 2s/./x/; do
    LC_ALL=C sed "$damage" whole > damaged
    cp damaged $file
    for resume in "" --resume; do
        # shellcheck disable=SC2086
        expect 3 "its beginning is damaged" jellett sweep map.scene --into=map.3 --shard=2/3 $resume
        cmp $file damaged || fail "$damage: a damaged file is written to"
    done
done
expect 3 "jellett: map.3/2-of-3.shard is no shard of a study, or its beginning is damaged" jellett merge map.3
mv whole $file
# The study of a program whose kernels for one orbit have a fused multiply-add, and other last digits, is another one. A compiler
# that is told of it, as by -march=native, sees another text of the file that describes a study.
python3 - "$JLT_BINARY_DIR/compile_commands.json" << 'END' || fail "kernels with a fused multiply-add make the same study"
import json, shlex, subprocess, sys
[unit] = [u for u in json.load(open(sys.argv[1])) if u["file"].endswith("/src/cli/study.c")]
words = shlex.split(unit["command"])
words[words.index("-o"):words.index("-o") + 2] = ["-E", "-P"]
texts = [subprocess.run(words + [x + "__FP_FAST_FMA"], cwd=unit["directory"], capture_output=True).stdout for x in ("-U", "-D")]
sys.exit(texts[0] == texts[1] or b"" in texts)
END
# Names of files and folders are taken to the letter.
mkdir "map[3]"
cp map.3/*.shard "map[3]"
cp "map[3]/1-of-3.shard" "[1].shard"
echo > 1.shard
expect 0 "" jellett merge "map[3]" -o again.csv
cmp again.csv map.1.csv || fail "a folder called map[3]: other bytes"
expect 1 "pieces are missing" jellett merge "[1].shard"

# Refusals.
expect 3 "--resume" jellett sweep map.scene --into=map.3 --shard=2/3
sed 's/1e-9/1e-8/' map.scene > other.scene
expect 3 'options.tol: there "1e-09", here "1e-08"' jellett sweep other.scene --into=map.3 --shard=2/3 --resume
expect 3 "options.set" jellett sweep map.scene --set=a3=0.5 --into=map.3 --shard=2/3 --resume
expect 0 "" jellett sweep other.scene --into=other --shard=2/3
expect 3 "jellett: other/2-of-3.shard is of another study" jellett merge map.1 other
cp "$JLT_SOURCE_DIR/codegen/models/lorenz.tt" own.tt
cat > own.scene << 'END'
model = "./own.tt";
compute = ( { what = "fates"; section = { z = 27; }; grid = { x = (-20, 20, 3); y = (-20, 20, 3); }; returns = 3; } );
END
export XDG_CACHE_HOME=$scratch/cache
expect 0 "" jellett sweep own.scene
if grep -qw fma /proc/cpuinfo; then # else vectors are alike
    expect 3 'arithmetic: there "fused", here "plain"' env JELLETT_LANES=2 jellett sweep own.scene --resume
fi
# Vectors of four and of eight numbers have the same rows, functions in the table or not: their shards may be merged.
printf '%s\n' 'model waves' 'state phi' 'state q' 'state p' 'angle c s = cos(q) sin(q)' 'angle C S = cos(phi) sin(phi)' \
    'exp e = exp(-p^2)' 'log l = log(2 + c)' 'eq phi = 1' 'eq q = p' 'eq p = -s + 3*S*s/10 + e/10 - l*p/100' \
    'periodic phi = 2*pi' 'periodic q = 2*pi' > waves.tt
for lanes in 4 8; do
    for ask in "--section phi=0 --grid q=-3:3:9,p=-2:2:9" "--section p=0 --grid q=3:3:1,phi=0.5:0.5:1"; do # the latter for long
        JELLETT_LANES=$lanes jellett section ./waves.tt $ask --returns 5 2> err | rows
    done > lanes.$lanes
done
[ "$(grep -c 'alive$' lanes.4)" -eq 490 ] && cmp lanes.4 lanes.8 || fail "eight lanes have other rows than four"
echo "# edited" >> own.tt
expect 3 "kernels.lorenz: there" jellett sweep own.scene --resume
# A coordinate called as what a command counts orbits by is a coordinate.
printf '%s\n' 'model counted' 'state orbit' 'state y' 'eq orbit = y' 'eq y = -orbit' > counted.tt
cat > counted.scene << 'END'
model = "./counted.tt";
compute = ( { what = "fates"; section = { y = 0; }; grid = { orbit = (0.1, 0.5, 3); }; returns = 2; } );
END
expect 0 "" jellett sweep counted.scene
expect 0 "" jellett merge counted.shards
[ "$(rows out | cut -d, -f1 | tr '\n' ' ')" = "orbit 0.1 0.3 0.5 " ] || fail "a state is counted: $(rows out)"
# In SQL names that differ in capitals are the same.
printf '%s\n' 'model capitals' 'state x' 'state X' 'eq x = X' 'eq X = -x' > capitals.tt
printf '%s\n' 'model = "./capitals.tt";' 'compute = ( { what = "simulate"; start = { x = 0; X = 1; }; times = (1); } );' \
    > capitals.scene
expect 0 "" jellett sweep capitals.scene
expect 0 "" jellett merge capitals.shards -o capitals.sqlite
python3 -c 'import sqlite3
print([about[0] for about in sqlite3.connect("capitals.sqlite").execute("SELECT * FROM rows").description])' > out
grep -qxF "['t', 'x', 'X_2', 'fate']" out || fail "names in SQL: $(cat out)"
# What runs has no value beside.
sed 's/^levels/over = { a3 = (0.1, 0.3, 2); }; levels/' ends.scene > over.scene
expect 2 "over.scene runs over a3" jellett sweep over.scene --set a3=0.5 --into=none
expect 3 ":1: error: 'over' runs over a3, which the scene also sets or sweeps elsewhere: remove one" \
    jellett sweep <(sed 's/^over/parameters = { a3 = 0.2; }; over/' over.scene) --into=none
sed 's/returns = 3/sweep = { E = (2, 3, 2); }; &/; s/ E = 2.15;//' over.scene > inner.scene
expect 3 "'over' runs over E" jellett sweep <(sed 's/ a3 = (0.1/ E = (0.1/' inner.scene) --into=none
# What the command does not take does not run either, nor does nothing.
cat > sleigh.scene << 'END'
model = "chaplygin_sleigh";
over = { E = (1, 2, 3); };
compute = ( { what = "simulate"; start = { v = 1; w = 1; }; times = (1); } );
END
expect 3 "sleigh.scene:2: error: 'over' runs over E, and simulate takes no levels" jellett sweep sleigh.scene --into=none
sed -i 's/^over.*/over = { };/' sleigh.scene
expect 3 "sleigh.scene:2: error: 'over' is empty" jellett sweep sleigh.scene --into=none
[ ! -e none ] || fail "a study that is refused has begun"
# A sweep within each piece begins runs of its own.
cat > inside.scene << 'END'
over = { a3 = (0.3, 0.5, 2); };
piece = 1;
compute = ( { what = "lyapunov"; sweep = { E = (2.15, 2.2, 2); }; start = { eta = 0.02; gamma3 = -0.61; }; returns = 4; } );
END
expect 0 "" jellett sweep inside.scene
expect 0 "" jellett merge inside.shards
rows out | tail -n +2 > inside.rows
for a3 in 0.3 0.5; do
    jellett lyapunov --set a3=$a3 --sweep E=2.15:2.2:2 --start eta=0.02,gamma3=-0.61 --returns 4 | rows | sed "1d; s/^/$a3,/"
done 2> /dev/null | diff - inside.rows || fail "a sweep within a study has other rows than alone"
expect 3 "portrait cannot be a study; these can: section, fates, lyapunov, eigen" jellett sweep \
    <(sed 's/"section"/"portrait"/; s/grid = .*; returns = 3;//' map.scene)
expect 3 "add 'grid': a study of section is cut into pieces along it" jellett sweep <(sed 's/grid = .*; returns/returns/' map.scene)
for study in map ends; do # a sweep, whose columns come first, is no part of a study of section; fates are cut along it
    sed 's/; returns/; sweep = { E = (2.1, 2.2, 2); }; returns/; s/ E = 2.15;//' $study.scene > swept.scene
    [ $study = map ] && expect 3 "by 'over', not by 'sweep': write them there" jellett sweep swept.scene --into=swept
    [ $study = map ] || expect 0 "" jellett sweep swept.scene --into=swept
done
# The plan of a study is that of its first point, not of defaults that no piece has.
sed '1s/ E = 2.15;//; 1i over = { a3 = (0, 0.5, 2); E = (1, 2, 2); };' map.scene > over.scene
expect 0 "at a3=0, E=1, the first of 4 points:" jellett plan over.scene
grep -q '\* level .* balanced ' out && grep -q 'on levels E=1 ' out || fail "the plan of a study: $(tail -4 out)"
# What is refused as a study has no plan.
expect 2 "runs over a3 by itself" jellett plan over.scene --set a3=0.2
expect 3 "portrait cannot be a study" jellett plan <(sed 's/"section"/"portrait"/; s/grid = .*; returns = 3;//' over.scene)
expect 3 "which the scene also sets" jellett plan <(sed 's/G = -0.56;/& E = 2;/' over.scene)
expect 3 "leave out 'output'" jellett sweep <(sed 's/returns = 3;/& output = "o.csv";/' map.scene)
expect 3 "a second entry" jellett sweep "$JLT_SOURCE_DIR/tools/scenes/fig3a.scene"
expect 5 "" jellett sweep map.scene --into=own.tt
# A piece with rows as another program might write them: one column has another name, or a row has one field more.
for change in gamma3/gamma4 alive/alive,1; do
    rm -rf other
    cp -r map.3 other
    python3 - other/2-of-3.shard $change << 'END' || fail "$change: the shard is not rewritten"
import sys, zlib
data = open(sys.argv[1], "rb").read()
at = data.rindex(b"\npiece ", 0, data.index(b",alive")) + 1
head, rest = data[at:].split(b"\n", 1)
head = head.split(b" ")[:6]
size = int(head[3])
rows = rest[:size].replace(*sys.argv[2].encode().split(b"/"), 1)
head[3] = b"%d" % len(rows)
head = b" ".join(head)
rest = rest[size:]
line = b"%s %08x\n" % (head, zlib.crc32(rows + rest[:int(head.split(b" ")[4])], zlib.crc32(head)))
open(sys.argv[1], "wb").write(data[:at] + line + rows + rest)
END
    expect 3 "and run jellett sweep --resume" jellett merge other
    grep -q '^jellett: other/2-of-3.shard: .*gamma' err || fail "$change: $(cat err)"
done
expect 3 "no files" jellett merge cache
: > empty.shard
expect 1 "no file holds a study yet: run jellett sweep STUDY.scene first" jellett merge empty.shard
expect 2 "no .csv" jellett merge map.1 -o rows.txt
ln -s map.1/1-of-1.shard shard.csv
cp -L shard.csv shard
expect 2 "shard.csv is a shard that is merged" jellett merge map.1 -o shard.csv
cmp shard map.1/1-of-1.shard || fail "a shard is written over by what is merged of it"

# Parts of a grid by hand.
jellett fates --grid 5x4 --returns 3 2> log | rows > all
jellett fates --grid 5x4@7:6 --returns 3 2> log | rows | diff -q - <(sed -n '1p; 9,14p' all) > log ||
    fail "points 7 to 12 of a grid are others"
expect 3 "beyond the last of 9" jellett fates --grid 3x3@5:5
expect 2 "@FIRST:COUNT" jellett fates --grid 3x3@5
expect 2 "leave out @0:4" jellett orbits --grid 4x4@0:4

# Two processes, one shard.
sed 's/returns = 3/returns = 100000000/; s/0.9999, 15/0.9999, 60/' map.scene > long.scene
jellett sweep long.scene --into=long 2> first &
first=$!
for _ in $(seq 1200); do grep -q "of them are there" first && break; sleep 0.05; done
expect 5 "process $first computes this shard already" timeout 60 jellett sweep long.scene --into=long --resume
kill -TERM $first
wait $first
[ $? = 143 ] || fail "a shard that is told to end does not end by the signal"

# A file that is not where it was any more is told of.
jellett sweep long.scene --into=gone 2> first &
first=$!
for _ in $(seq 1200); do grep -q "of them are there" first && break; sleep 0.05; done
rm -r gone
kill -TERM $first
wait $first
grep -q "was moved, removed or replaced" first || fail "the file of a shard is gone: $(cat first)"

# A piece that cannot start its threads is not taken for done: no space of addresses has room for such stacks.
cat > threads.scene << 'END'
over = { a3 = (0.4, 0.5, 2); };
levels = { G = -0.56; E = 2.15; };
compute = ( { what = "fates"; grid = "6x4"; returns = 3; } );
END
huge=(env OMP_STACKSIZE=200000G OMP_NUM_THREADS=4)
expect 4 "(a3=0.4, points 0 to 23 of the grid) lacked memory or threads" "${huge[@]}" jellett sweep threads.scene
grep -q "2 pieces were left out" err || fail "two pieces without threads: $(cat err)"
expect 4 "lacked memory or threads there" "${huge[@]}" jellett section --grid 6x4 --returns 2 --sweep a3=0.4:0.5:2
expect 4 "Thread creation failed" "${huge[@]}" jellett fates --grid 6x4 -o huge.csv
[ ! -e huge.csv ] || fail "rows of a command without threads are there"
expect 0 "has its 2 pieces; 2 of them now" jellett sweep threads.scene --resume
expect 0 "" jellett merge threads.shards -o threads.csv
[ "$(grep -vc '^#' threads.csv)" = 49 ] || fail "rows of pieces that were tried again: $(grep -vc '^#' threads.csv)"

# Nor is one that lacks memory; sanitizers need more than such a limit.
if ! nm "$(command -v jellett)" | grep -E '__(asan|tsan)_init' > log; then
    cat > memory.scene << 'END'
over = { a3 = (0.4, 0.5, 2); };
levels = { G = -0.56; E = 2.15; };
compute = ( { what = "separation"; grid = "4x4"; returns = 2; settle = 0; cells = "30000x30000"; } );
END
    (ulimit -v 250000; expect 4 "piece 1 (a3=0.5) lacked memory" jellett sweep memory.scene; exit $status) || status=1
    expect 0 "has its 2 pieces; 2 of them now" jellett sweep memory.scene --resume
fi

# They are mixed: those of a shard lie at no equal distances.
gaps=$(jellett sweep map.scene --dry-run --shard=1/4 | sed 's/.*@\([0-9]*\):.*/\1/' | sort -n |
    awk 'NR > 1 { print $1 - last } { last = $1 }' | sort -u | wc -l)
[ "$gaps" -ge 2 ] || fail "pieces of a shard lie at equal distances"

# What a study runs over: the rows of the command typed for each value, behind the values. There is no orbit at E = -5.
cat > exponents.scene << 'END'
over = { a3 = (0.3, 0.6, 4); E = (-5, 2, 2); };
levels = { G = -0.56; };
compute = ( { what = "lyapunov"; start = { eta = 0.1; gamma3 = -0.6; }; returns = 3; } );
END
for i in 1 2; do expect 0 "no state with" jellett sweep exponents.scene --shard=$i/2; done
expect 0 "refused every point of refused/1-of-8.shard: none of its pieces (1) has rows" \
    jellett sweep exponents.scene --shard=1/8 --into=refused
expect 0 "4 of 8 pieces" jellett merge exponents.shards -o exponents.csv -o exponents.sqlite
for a3 in 0.3 0.4 0.5 0.6; do
    jellett lyapunov --set a3=$a3 --level E=2,G=-0.56 --start eta=0.1,gamma3=-0.6 --returns 3 2> log | rows |
        awk -v a3=$a3 '{ print (NR > 1 ? a3 ",2," : "a3,E,") $0 }'
done | awk 'NR == 1 || !/^a3/' | diff - <(rows exponents.csv) > diff ||
    { fail "rows over a3 and E are others than those that are typed:"; head -5 diff; }
# Rows are rows, also where the command has comments behind them.
printf '%s\n' 'over = { a3 = (0.3, 0.4, 2); };' 'compute = ( { what = "drift"; returns = 4; } );' > drift.scene
expect 0 "" jellett sweep drift.scene
expect 0 "" jellett merge drift.shards
for a3 in 0.3 0.4; do jellett drift --set a3=$a3 --returns 4 | rows | sed "s/^/$a3,/"; done |
    awk 'NR == 1 { sub(/^0.3/, "a3") } !/^0.4,method/' | diff - <(rows out) > diff || fail "drifts over a3: $(cat diff)"
cat > locus.scene << 'END'
over = { I3 = ("1/4", "1/2", 2); };
parameters = { a3 = 0; };
piece = 4;
compute = ( { what = "eigen"; at = { v_nu = 0.7; omega3 = 1.1; }; sweep = { gamma3 = (-0.9, 0.9, 10); }; } );
END
for i in 1 2 3; do expect 0 "" jellett sweep locus.scene --shard=$i/3; done
jellett merge locus.shards | rows | cut -d, -f2- > merged
for i3 in 1/4 1/2; do jellett eigen --set a3=0,I3=$i3 --at v_nu=0.7,omega3=1.1 --sweep gamma3=-0.9:0.9:10 | rows; done |
    awk 'NR == 1 || !/^gamma3/' | diff -q - merged > diff || fail "eigenvalues over I3 are others than those that are typed"
# Points of a sweep that are refused end no study of it, even if they are all that a piece has.
refused() { # SETTINGS COMMAND...: the study's rows are those of the command
    echo "parameters = { a3 = 0; }; piece = 2; compute = ( { what = \"$2\"; $1 sweep = { m = (-1.0, 1.0, 5); }; } );" > signs.scene
    expect 0 "" jellett sweep signs.scene --into="signs.$2"
    jellett merge "signs.$2" | rows > merged
    jellett "${@:2}" --set a3=0 --sweep m=-1:1:5 2> err | rows > typed
    [ "$(wc -l < typed)" -eq 6 ] && diff typed merged > diff ||
        fail "$2: a study of points some of which are refused: $(cat err diff)"
}
refused 'at = { gamma3 = 0.3; v_nu = 0.7; omega3 = 1.1; };' eigen --at gamma3=0.3,v_nu=0.7,omega3=1.1
refused 'grid = "2x2"; returns = 1;' fates --grid 2x2 --returns 1
expect 3 "'over' is of a study" jellett run locus.scene
# A model's file may have any name.
printf '%s\n' 'model line' 'param a' 'state x' 'eq x = a*x' > $'li\xffne.tt'
printf '%b\n' 'model = "li\xffne.tt"; over = { a = (1, 2, 2); };' \
    'compute = ( { what = "eigen"; sweep = { x = (0.0, 0.0, 1); }; } );' > line.scene
expect 0 "" jellett sweep line.scene
expect 0 "rows of: jellett eigen \$'li\\377ne.tt'" jellett merge line.shards
# The longest name of a database is one beside which SQLite has room for its own.
long=$(printf 'a%.0s' {1..244})
expect 0 "" jellett merge line.shards -o "$long.sqlite"
python3 -c 'import sqlite3, sys
assert len(list(sqlite3.connect(sys.argv[1]).execute("SELECT * FROM rows"))) == 2' "$long.sqlite" 2> err ||
    fail "a database with a long name cannot be read"
expect 5 "File name too long" jellett merge line.shards -o "a$long.sqlite"
exit $status
