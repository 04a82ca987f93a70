"""What is asked of chaos at (5.1), by jellett: finite-time exponents, and the angle at which the saddle's separatrices cross.

usage: chaos.py JELLETT EXPONENTS.csv SEPARATRIX.csv [REPEATS]

Exponents: of 144 starts across the saddle's chaos and the islands in it, over 20 returns; the error is the largest. Angle: at the
symmetric homoclinic point near eta = 0.34, gamma3 = -0.62, which `jellett manifolds` finds among others, each with an error bar; its
time is shared among them. Processor time of the process, on one thread, start and output included.
Output: one row a question, program and setting, as of cycles.py."""
import csv
import statistics
import sys

from cycles import rows_of, timed

GRID = "eta=0.1:0.5:12,gamma3=-0.66:-0.58:12"


def tell(question, method, decade, error, times, answers):
    unit = 1 / answers
    print(f"{question},jellett,{method},level,1,1e-{decade:02},{error:.3e},{unit * statistics.median(times):.4g},{unit * min(times):.4g},"
          f"{unit * max(times):.4g},0", flush=True)


def read(path):
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(file))


def main():
    jellett, repeats = sys.argv[1], int(sys.argv[4]) if len(sys.argv) > 4 else 15
    known = [float(row["exponent"]) for row in read(sys.argv[2])]
    q = {name: float(value) for name, value in read(sys.argv[3])[0].items()}
    print("# " + timed([jellett, "--version"], 1)[0].strip())
    print("question,program,method,form,threads,tolerance,error,us_per_answer,us_least,us_largest,failed")
    for decade in range(4, 15):
        text, times = timed([jellett, "lyapunov", "--grid", GRID, "--returns", "20", "--threads", "1", "--tol", f"1e-{decade}"], repeats)
        found = {(row["eta"], row["gamma3"]): float(row["exponent"]) for row in rows_of(text)}
        by_start = [value for _, value in sorted(found.items(), key=lambda item: [float(word) for word in item[0]])]
        tell("exponents", "lyapunov", decade, max(abs(a - b) for a, b in zip(by_start, known, strict=True)), times, len(known))
    for decade in range(6, 15):
        text, times = timed([jellett, "manifolds", "--length", "0.5", "--threads", "1", "--tol", f"1e-{decade}", "--crossings", "-",
                             "-o", "/dev/null"], max(1, repeats // 3))
        found = rows_of(text)
        near = min(found, key=lambda row: abs(float(row["eta"]) - q["eta"]) + abs(float(row["gamma3"]) - q["gamma3"]))
        tell("angle", "manifolds", decade, abs(abs(float(near["angle"])) - q["angle"]), times, len(found))


main()
