"""Periodic orbits followed in a parameter, by jellett and by AUTO-07p: where they double, periods and multipliers at the end of the range.

usage: cycles.py JELLETT FOLDER [REPEATS]     AUTO-07p's programs, built by tools/bench/run, lie in FOLDER

Both get the first orbit, and answer by one process, whose processor time counts, start and output included. AUTO prints multipliers
with 7 digits and the rest with 11: errors below those are its printing. Output: one row a question, program and setting."""
import csv
import os
import resource
import statistics
import subprocess
import sys

REFERENCE = "tests/reference/data/cycles.csv"
TOLERANCES = ["1e-4", "1e-5", "1e-6", "1e-7", "1e-8", "1e-9", "1e-10", "1e-11", "1e-12", "1e-13"]
MESHES = [(n, k) for k in (4, 7) for n in (8, 12, 20, 35, 60, 100, 200)]

# What is followed: the command of jellett after `jellett continue`; AUTO's dimension, parameters and constants; the start for both.
BRANCHES = {
    "roessler": ("roessler --section y=0 --set c=2 --along c=2:3.5 --start x=3.753,z=1.354",
                 3, "[1,11]", "PAR={1:2.0}\nDS=0.01\nDSMAX=5.0\nJAC=1\nUZSTOP={1:3.5}", 1,
                 "roessler --set c=2 --start x=3.753344812845396,y=0,z=1.3537123487819136", 5.709855915127721),
    "lorenz": ("lorenz --section z=20 --set rho=22 --along rho=16:22 --decreasing --start x=10.29,y=13.36",
               3, "[1,11]", "PAR={1:22.0}\nDS=-0.01\nDSMAX=5.0\nJAC=1\nUZSTOP={1:16.0}", 1,
               "lorenz --set rho=22 --start x=10.286833916691071,y=13.361932436123968,z=20", 0.7643864274261536),
    "top": ("--along E=1.9:2.15 --decreasing",
            4, "[11,1,2]", "PAR={1:0.0}\nDS=0.01\nDSMAX=0.5\nJAC=0\nUZSTOP={2:1.9}", 2,
            "spherical_top --start gamma3=-0.6135843897066381,v_nu=0,omega_tau=0,omega_n=-2.3369239814144414,omega3=1.5958321591784042",
            3.8247750046438376),
}
CONSTANTS = """dat='{name}'
NDIM={n}
IPS=2
ILP=0
ICP={icp}
NTST={ntst}
NCOL={ncol}
IAD=3
ISP=2
ISW=1
IRS=0
MXBF=0
NMX=400
EPSL=1e-10
EPSU=1e-10
EPSS=1e-10
ITMX=20
DSMIN=1e-6
NPR=0
{more}
"""


def references():
    with open(REFERENCE, encoding="utf-8") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return {row["orbit"]: row for row in rows}


def timed(command, repeats, **more):
    """Output, and the processor time of each repeat in microseconds."""
    times = []
    environment = dict(os.environ, OMP_NUM_THREADS="1")
    for _ in range(repeats):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run(command, capture_output=True, text=True, env=environment, check=True, **more)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        times.append(1e6 * (after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime))
    return done.stdout, times


def rows_of(text):
    return list(csv.DictReader(line for line in text.splitlines() if not line.startswith("#")))


def with_jellett(jellett, branch, tolerance, repeats):
    """Doubling, period and real part of the largest multiplier at the end, times."""
    text, times = timed([jellett, "continue", *BRANCHES[branch][0].split(), "--tol", tolerance], repeats)
    rows = rows_of(text)
    value = "E" if branch == "top" else "rho" if branch == "lorenz" else "c"
    doubling = next((float(row[value]) for row in rows if row["bifurcation"] == "period doubling"), None)
    return doubling, float(rows[-1]["T"]), float(rows[-1]["mu1_re"]), times


def start_of_auto(jellett, folder, branch):
    """The first orbit at 201 times, which AUTO reads."""
    arguments, period = BRANCHES[branch][5:]
    text, _ = timed([jellett, "simulate", *arguments.split(), "--until", repr(period), "--every", repr(period / 200)], 1)
    with open(f"{folder}/{branch}.dat", "w", encoding="utf-8") as file:
        for row in rows_of(text):
            if branch == "top":
                gamma3 = float(row["gamma3"])
                v_tau = (0.51 + gamma3) * float(row["omega_n"]) + (1 - gamma3 * gamma3) ** 0.5 * float(row["omega3"])
                print(row["t"], row["gamma3"], row["v_nu"], row["omega_tau"], repr(v_tau), file=file)
            else:
                print(row["t"], row["x"], row["y"], row["z"], file=file)


def with_auto(folder, branch, mesh, repeats):
    _, n, icp, more, parameter, *_ = BRANCHES[branch]
    with open(f"{folder}/fort.2", "w", encoding="utf-8") as file:
        file.write(CONSTANTS.format(name=branch, n=n, icp=icp, ntst=mesh[0], ncol=mesh[1], more=more))
    open(f"{folder}/fort.3", "w", encoding="utf-8").close()
    _, times = timed([f"./{branch}"], repeats, cwd=folder)
    places, ends = [], []
    with open(f"{folder}/fort.7", encoding="utf-8") as file:
        for words in map(str.split, file):
            if len(words) > 4 and words[0] in ("1", "-1") and words[2] != "0":
                kind, columns = int(words[2]), [float(word) for word in words[4:]]
                places += [columns[0]] if kind == 7 else []
                ends += [columns[-1] if n == 3 else columns[0]] if kind == -4 else []
    with open(f"{folder}/fort.9", encoding="utf-8") as file:
        found = [[float(words[4]), float(words[5])] for words in map(str.split, file) if len(words) > 5 and words[2] == "Multiplier"]
    # The last point's: without those at 1, one or, where energy is conserved, two.
    last = sorted(found[-n:], key=lambda mu: abs(complex(*mu) - 1))[2 if branch == "top" else 1:]
    largest = max(last, key=lambda mu: abs(complex(*mu)))[0]
    return places[0] if places else None, ends[-1] if ends else None, largest, times


def main():
    jellett, folder, repeats = sys.argv[1], sys.argv[2], int(sys.argv[3]) if len(sys.argv) > 3 else 15
    known = references()
    print("# " + timed([jellett, "--version"], 1)[0].strip())
    print("question,program,method,form,threads,tolerance,error,us_per_answer,us_least,us_largest,failed")

    def tell(branch, program, method, tolerance, answers):
        doubling, period, multiplier, times = answers
        end = known["roessler_c" if branch == "roessler" else "lorenz_rho" if branch == "lorenz" else "top_E"]
        wanted = [("doubling", doubling, known[f"{branch}_doubling"]["value"])] if f"{branch}_doubling" in known else []
        wanted += [("period", period, end["T"]), ("multiplier", multiplier, end["multiplier"])]
        for what, answer, reference in wanted:
            error = "" if answer is None else f"{abs(answer - float(reference)) / max(1, abs(float(reference))):.3e}"
            print(f"{branch} {what},{program},{method},,1,{tolerance},{error},{statistics.median(times):.4g},{min(times):.4g},{max(times):.4g},"
                  f"{int(answer is None)}", flush=True)

    for branch in BRANCHES:
        for tolerance in TOLERANCES:
            tell(branch, "jellett", "gauss", tolerance, with_jellett(jellett, branch, tolerance, repeats))
        if os.path.exists(f"{folder}/{branch}"):
            start_of_auto(jellett, folder, branch)
            for mesh in MESHES:
                tell(branch, "AUTO-07p", f"NCOL {mesh[1]}", f"{1 / mesh[0]:.4g}", with_auto(folder, branch, mesh, repeats))


if __name__ == "__main__":
    main()
