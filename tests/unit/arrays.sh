#!/usr/bin/env bash
# -o FILE.npy has what -o FILE.csv has, of every command that writes rows: the same names, doubles bit for bit, texts, and the
# comments behind the array; in a form that NumPy reads. An interrupt and a full disk leave an array of the rows so far.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
trap 'kill $(jobs -p) 2>/dev/null; wait; rm -rf "$scratch"' EXIT

# The array read by what its format says, and by NumPy where there is one.
cat > read.py << 'END'
import ast, csv, struct, sys
def read(path):
    data = open(path, "rb").read()
    assert data[:8] == b"\x93NUMPY\x01\x00", data[:8]
    start = 10 + struct.unpack("<H", data[8:10])[0]
    assert start % 64 == 0 and data[start - 1:start] == b"\n"
    form = ast.literal_eval(data[10:start].decode())
    code = "<" + "".join("d" if kind == "<f8" else kind[2:] + "s" for _, kind in form["descr"])
    (count,) = form["shape"]
    end = start + count * struct.calcsize(code)
    assert not form["fortran_order"] and struct.calcsize(code) % 8 == 0 and end <= len(data)
    try:
        import numpy
        with open(path, "rb") as stream:
            whole, tail = numpy.load(stream), stream.read()
        assert whole.tobytes() == data[start:end] and tail == data[end:] and len(numpy.load(path, mmap_mode="r")) == count
    except ImportError: pass
    return [name for name, _ in form["descr"]], list(struct.iter_unpack(code, data[start:end])), data[end:].decode()
def same(array, text):
    lines = open(text).read().split("\n")
    names, *rows = csv.reader(l for l in lines if l and l[0] != "#")
    has, values, tail = read(array)
    assert has == names and len(set(names)) == len(names) and len(values) == len(rows) > 0, (has, names, len(values), len(rows))
    said = [l for l in lines if l[:1] == "#"]
    assert [l.replace(array, text) for l in tail.split("\n")[:-1]] == said, tail
    kinds = set()
    for row, value in zip(rows, values):
        for field, got in zip(row, value):
            if isinstance(got, bytes): assert got.rstrip(b"\0").decode() == field, (got, field)
            elif field == "": assert got != got
            else: assert struct.pack("d", got) == struct.pack("d", float(field)), (got, field)
            kinds.add(type(got))
    return kinds
END
pair() { # COMMAND...
    "$@" -o rows.csv 2> err || { fail "$*: $(cat err)"; return; }
    "$@" -o rows.npy 2> err || { fail "$*, an array: $(cat err)"; return; }
    python3 -c 'from read import *; same("rows.npy", "rows.csv")' || fail "$*: the array has something else"
}
pair jellett section --grid 12x8 --returns 20 --contact end
pair jellett section --start eta=0.1,gamma3=-0.6 --returns 5 --check
pair jellett simulate --start gamma3=-0.6,v_nu=0.5,omega_tau=0.3,omega_n=1,omega3=0.8 --until 10 --every 5 --track
pair jellett fates --grid 12x8 --returns 5 --contact end
pair jellett fates --grid 6x4 --returns 5 --sweep a3=0.4:0.5:3
pair jellett orbits --period 1
pair jellett lyapunov --returns 30
pair jellett lyapunov --sweep a3=0.45:0.55:3 --returns 20
pair jellett drift --returns 64
pair jellett separation --grid 4x4 --returns 5
pair jellett manifolds --length 0.2 --tol 1e-8
pair jellett continue --along E=1.9:2.15
pair jellett transfer --boxes 10x10 --tol 1e-4
pair jellett eigen --at v_nu=0.7,omega3=1.1 --sweep a3=0:0:1,gamma3=0.3:0.3:1
pair jellett rod --start gamma3=0.2,v_nu=0.6,omega_tau=0.4,omega_n=1,omega3=0 --sweep omega_n=0.2:2:9

# States and parameters may be called as columns of commands are: a second one of a name has another name, the same in both.
export XDG_CACHE_HOME=$scratch/cache
printf '%s\n' 'model named' 'param drift_E' 'default drift_E = 1' 'state t' 'state fate' 'state T' 'state orbit' \
    'eq t = -drift_E*fate' 'eq fate = t' 'eq T = -T/2' 'eq orbit = -orbit' 'integral E = t^2 + drift_E*fate^2' > named.tt
at=t=1,T=0.1,orbit=0.2
pair jellett simulate ./named.tt --start fate=0,$at --times 1,2
pair jellett simulate ./named.tt --start fate=0,$at --times 1,2 --sweep drift_E=1:2:2
[ "$(grep -v '^#' rows.csv | head -1)" = drift_E,t,t_2,fate,T,orbit,drift_E_2,fate_2 ] || fail "names: $(grep -v '^#' rows.csv)"
pair jellett section ./named.tt --section fate=0 --start $at --returns 2
pair jellett fates ./named.tt --section fate=0 --start $at --returns 2
pair jellett fates ./named.tt --section fate=0 --start $at --returns 2 --sweep drift_E=1:2:2
pair jellett orbits ./named.tt --section fate=0 --start t=1,T=0,orbit=0
pair jellett continue ./named.tt --section fate=0 --start t=1,T=0,orbit=0 --along drift_E=1:1.01
pair jellett lyapunov ./named.tt --section fate=0 --grid t=1:1:1,T=0.1:0.1:1,orbit=0.1:0.1:1 --returns 2
pair jellett eigen ./named.tt --csv

# What is no table is no array, and an array is a file.
report=(jellett eigen --set a3=0 --at gamma3=0.3,v_nu=0.7,omega3=1.1)
cycle=(jellett certify cycle --set I1=0.591,I3=0.494,a3=0.548 --level E=2.15,G=0.161 --start eta=2.84,gamma3=-0.959)
cp rows.npy none.npy
refused() { # COMMAND...
    "$@" -o none.npy > out 2> err
    [ $? -eq 2 ] && grep -q "is no table: --output none.npy" err && cmp -s rows.npy none.npy || fail "$*, as an array: $(cat err)"
}
refused "${report[@]}"
refused "${report[@]}" --json
refused jellett eigen --set a3=0 --at v_nu=0.7,omega3=1.1 --sweep gamma3=0.2:0.3:2 --json
refused jellett measure --set I3=0
refused jellett measure --set I3=0 --json
refused "${cycle[@]}"
jellett certify --help | grep -q npy && fail "help promises a certificate as an array"
pair jellett measure --set I3=0 --csv
echo 'compute = ( { what = "eigen"; parameters = { a3 = 0; }; at = { v_nu = 0.7; omega3 = 1.1; }; output = "none.npy"; } );' > \
    report.scene
jellett run report.scene > out 2> err && fail "a scene wrote a report as an array"
grep -q "a report is no table" err || fail "a scene's report: $(cat err)"
for name in none.sqlite none.db; do
    jellett section --start eta=0.1,gamma3=-0.6 --returns 1 -o $name 2> err
    [ $? -eq 2 ] && grep -q "'jellett merge' alone writes" err && [ ! -e $name ] || fail "$name: $(cat err)"
done
ln -s /dev/null null.npy
jellett section --start eta=0.1,gamma3=-0.6 --returns 1 -o null.npy 2> err && fail "an array went to a device"
grep -q "arrays go to files alone" err || fail "an array for a device: $(cat err)"

# Zero has no sign.
jellett portrait --set I1=2/5,I3=1/4 --level E=0.725,G=0,F0=0.4 --orbits 1 --trajectories orbits.csv -o fixed.csv
grep -nE '(^|,)-0(,|$)' fixed.csv orbits.csv && fail "a zero with a sign"

# A full disk, and an interrupt.
(ulimit -f 16; trap '' XFSZ; jellett section --grid 20x20 --returns 100 -o limited.npy 2> err) && fail "a full disk was not told of"
grep -q "File too large; the whole rows before are saved there" err || fail "a full disk: $(cat err)"
python3 -c 'from read import *; assert len(read("limited.npy")[1]) > 50' || fail "a full disk left no array"
jellett section --start eta=0.44,gamma3=-0.62 --returns 100000000 -o stopped.npy 2> err & job=$!
sleep 1; kill -TERM $job; wait $job
[ $? -eq 143 ] || fail "an interrupt: $(cat err)"
python3 -c 'from read import *; rows = read("stopped.npy"); assert len(rows[1]) > 100 and "# command" in rows[2]' ||
    fail "an interrupt left no array"
[ -z "$(ls | grep -E 'npy\.')" ] || fail "temporary files stay: $(ls)"
exit $status
