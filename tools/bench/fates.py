"""How orbits of (5.1) end within ten returns, by `jellett fates`: rows like those of heyoka_fates.py, which has the same 600 starts.

usage: fates.py JELLETT FATES.csv [REPEATS]

The error is that of the time of the end at a pole which nine of ten orbits keep, one with the wrong fate counting as infinite; `failed` is
how many have a wrong fate. Processor time of the process, on one thread, start and output included."""
import csv
import math
import statistics
import sys

from cycles import rows_of, timed


def main():
    jellett, path, repeats = sys.argv[1], sys.argv[2], int(sys.argv[3]) if len(sys.argv) > 3 else 15
    with open(path, encoding="utf-8") as file:
        known = list(csv.DictReader(line for line in file if not line.startswith("#")))
    print("# " + timed([jellett, "--version"], 1)[0].strip())
    print("program,method,form,threads,tolerance,error,us_per_orbit,us_least,us_largest,failed")
    for decade in range(4, 15):
        text, times = timed([jellett, "fates", "--grid", "30x20", "--returns", "10", "--threads", "1", "--tol", f"1e-{decade}"], repeats)
        found = rows_of(text)
        wrong = [mine["fate"] != true["fate"] for mine, true in zip(found, known, strict=True)]
        off = sorted(math.inf if bad else abs(float(mine["t_end"]) - float(true["t_end"]))
                     for mine, true, bad in zip(found, known, wrong) if true["fate"] != "alive")
        unit = 1 / len(known)
        print(f"jellett,batches,level,1,1e-{decade:02},{off[int(0.9 * len(off))]:.3e},{unit * statistics.median(times):.4g},{unit * min(times):.4g},"
              f"{unit * max(times):.4g},{sum(wrong)}", flush=True)


main()
