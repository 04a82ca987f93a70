#!/usr/bin/env bash
# What a study costs beside its rows, in time of the processor, which other programs on the machine change little: by `jellett
# sweep`, with the default pieces, less than 5 % more than by `jellett run`; each of two shards at most 1/1.9
# of both. And how fast `jellett merge` is.
set -uo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
cat > study.scene << 'END'
levels = { E = 2.15; G = -0.56; };
accuracy = { tolerance = 1e-10; };
compute = ( { what = "fates"; grid = "480x320"; returns = 100; } );
END
cat > rows.scene << 'END'
levels = { E = 2.15; G = -0.56; };
accuracy = { tolerance = 1e-6; };
compute = ( { what = "section"; grid = "100x80"; returns = 100; } );
END
python3 - << 'END'
import os, resource, subprocess, sys, time
os.environ["OMP_NUM_THREADS"] = "1"
def cost(*arguments):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open("out", "w") as out, open("err", "w") as err:
        subprocess.run(arguments, stdout=out, stderr=err, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
bare, swept, halves = [], [], []
for i in range(4):
    bare.append(cost("jellett", "run", "study.scene"))
    swept.append(cost("jellett", "sweep", "study.scene", f"--into=one{i}", "--shard=1/1"))
    two = [cost("jellett", "sweep", "study.scene", f"--into=two{i}", f"--shard={k}/2") for k in (1, 2)]
    halves.append(max(two) / sum(two)) # within seconds, as the processor's speed is not the same for long
pieces = subprocess.run(["jellett", "sweep", "study.scene", "--dry-run"], capture_output=True).stdout.count(b"\n")
more, share = min(swept) / min(bare) - 1, min(halves)
print(f"{min(bare):.2f} s by run, {min(swept):.2f} s by sweep ({100 * more:+.1f} %), of which one piece "
      f"{min(swept) / pieces:.3f} s; the larger of two shards {share:.3f} of both")
for i in (1, 2): cost("jellett", "sweep", "rows.scene", "--into=rows", f"--shard={i}/2")
size = sum(os.path.getsize(os.path.join("rows", name)) for name in os.listdir("rows"))
for kind in ("csv", "npy", "sqlite"):
    spent = cost("jellett", "merge", "rows", "-o", "rows." + kind)
    if kind == "csv": rows = sum(1 for line in open("rows.csv") if line[0] != "#") - 1
    print(f"merge of {rows} rows, {size / rows:.0f} bytes a row in shards, to .{kind}: "
          f"{rows / spent / 1e6:.2f} million rows a second, {os.path.getsize('rows.' + kind) / rows:.0f} bytes a row")
sys.exit(more > 0.05 or share > 1 / 1.9)
END
