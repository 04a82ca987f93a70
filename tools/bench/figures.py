"""The figures of the tables that tools/bench/run has written, as Markdown.

usage: figures.py RESULTS

A ratio compares the fastest point of the peers whose error is at most the one asked for with the fastest of jellett: of those with
at most the error asked for, and, what must meet the target, at that peer's own error, where time is interpolated between two
neighbouring tolerances of one curve (logarithms of both), so that nothing hangs on where a decade happens to fall. Times are the
least of the repeats."""
import csv
import math
import os
import sys

TIME = "us_least"


def read(name):
    path = f"{sys.argv[1]}/{name}.csv"
    if not os.path.exists(path):
        return []
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def fastest(rows, error):
    fit = [row for row in rows if row["error"] and float(row["error"]) <= error and not int(row["failed"])]
    return min(fit, key=lambda row: float(row[TIME]), default=None)


def time_at(rows, error):
    """The least time of any curve at this error; None where none gets there."""
    curves = {}
    for row in rows:
        if row["error"] and not int(row["failed"]):
            curves.setdefault((row["method"], row["form"]), []).append((float(row["tolerance"]), float(row["error"]), float(row[TIME])))
    times = []
    for points in curves.values():
        points.sort(reverse=True)
        times += [time for _, found, time in points if found <= error]
        for (_, e0, t0), (_, e1, t1) in zip(points, points[1:]):
            if e1 <= error < e0:
                times.append(t0 * (t1 / t0) ** (math.log(e0 / error) / math.log(e0 / e1)))
    return min(times, default=None)


def table(title, head, rows):
    lines = [f"**{title}**", "", "| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]) + "\n" if rows else ""


def rate(row):
    return f"{1e6 / float(row[TIME]):,.0f}".replace(",", " ")


def told(row):
    return f"{row['program']} {row['method']}, {row['form']}"


def against(title, peers, mine, wanted):
    """wanted: (error, target ratio)."""
    rows = []
    for error, target in wanted:
        peer = fastest(peers, error)
        if peer is None:
            rows.append((f"{error:g}", "none so accurate", *[""] * 5))
            continue
        there, ours = time_at(mine, float(peer["error"])), fastest(mine, error)
        ratio = lambda time: f"{float(peer[TIME]) / time:.1f}" if time else "none so accurate"
        rows.append((f"{error:g}", f"{told(peer)}: {rate(peer)} at {float(peer['error']):.1e}",
                     f"{ours['method']}, {ours['form']}: {rate(ours)} at {float(ours['error']):.1e}" if ours else "", ratio(ours and float(ours[TIME])),
                     ratio(there), f"{target:g}", "yes" if there and float(peer[TIME]) >= target * there else "no"))
    return table(title, ("error at most", "fastest peer: returns/s", "jellett: returns/s", "ratio", "at the peer's own error", "wanted", "met"), rows)


def sections():
    # heyoka measures errors of a step against the largest state: with time among them its tolerance loosens as time goes on, which the
    # first ten returns do not show.
    rows = [row for row in read("section") if row["threads"] == "1" and not (row["program"] == "heyoka" and row["form"].endswith("_t"))]
    mine = [row for row in rows if row["program"] == "jellett"]
    batch, scalar = [row for row in mine if " " in row["method"]], [row for row in mine if " " not in row["method"]]
    heyoka = [row for row in rows if row["program"] == "heyoka"]
    others = [row for row in rows if row["program"] not in ("jellett", "heyoka")]
    errors = [1e-4, 1e-6, 5e-9, 1e-10, 3e-12, 2e-13]
    published = [row for row in heyoka if not row["form"].startswith("level")]
    targets = [(2e-7, 5), (3e-10, 5), (1e-12, 4), (1.3e-13, 3)]
    return [against("Batches against heyoka, batches of 8, on the paper's states: five in t, or lifted to six", published, batch, targets) if heyoka else "",
            against("The same with jellett's own form, level, given to heyoka as well", heyoka, batch, targets) if heyoka else "",
            against("One orbit at a time against the fastest of GSL, Boost.odeint, SUNDIALS", others, scalar, [(error, 2.5) for error in errors])
            if others else "",
            against("Batches against the fastest of GSL, Boost.odeint, SUNDIALS", others, batch, [(error, 10) for error in errors]) if others else ""]


def grazing():
    rows = [row for row in read("grazing") if row["threads"] == "1" and not row["form"].endswith("_t") and row["error"]]
    best = {}
    for row in rows:
        key = row["program"] if row["program"] != "jellett" else "jellett, batches" if " " in row["method"] else "jellett, one at a time"
        form = "lifted" if row["form"] in ("level", "five", "track") else "plain"
        if int(row["failed"]) == 0 and ((key, form) not in best or float(row["error"]) < float(best[key, form]["error"])):
            best[key, form] = row
    keys = list(dict.fromkeys(key for key, _ in best))
    cell = lambda key, form: f"{float(best[key, form]['error']):.1e} ({best[key, form]['method']}, {best[key, form]['form']}, " \
        f"{float(best[key, form][TIME]):.3g} µs)" if (key, form) in best else "every run lost orbits"
    return table("Grid that grazes the pole: the smallest error reached without losing an orbit, and its time per return",
                 ("program", "1/s lifted away", "1/s left in"), [(key, cell(key, "lifted"), cell(key, "plain")) for key in keys])


def threads():
    rows = read("threads")
    pairs = [(one, two) for one in rows for two in rows if one["threads"] == "1" and two["threads"] != "1"
             and one["method"] == two["method"] and one["tolerance"] == two["tolerance"]]
    return table("Threads, batches", ("tolerance", "1 thread: returns/s", "2 threads: returns/s", "ratio"),
                 [(one["tolerance"], rate(one), rate(two), f"{float(one[TIME]) / float(two[TIME]):.2f}") for one, two in pairs])


def tiers():
    rows = [row for row in read("tiers") if float(row["tolerance"]) in (1e-11, 1e-12) and row["error"]]
    tolerance = max((row["tolerance"] for row in rows), key=lambda text: -float(text), default=None)
    rows = [row for row in rows if row["tolerance"] == tolerance]
    return table(f"Tiers, the same question at tolerance {tolerance}", ("orbit", "tier", "states", "time [µs]", "steps", "evaluations", "error"),
                 [(row["scene"], row["tier"], row["dimension"], f"{float(row['us_least']):.3g}", row["steps"], row["evaluations"],
                f"{float(row['error']):.1e}") for row in rows])


def questions(name, title, peers, errors):
    """What processes take for the same answers, at errors that both reach."""
    rows = []
    for question in dict.fromkeys(row["question"] for row in read(name)):
        all_of = [row for row in read(name) if row["question"] == question]
        mine = [row for row in all_of if row["program"] == "jellett"]
        for error in errors:
            peer = fastest([row for row in all_of if row["program"] != "jellett"], error)
            there = time_at(mine, float(peer["error"])) if peer else None
            ours = fastest(mine, error)
            rows.append((question, f"{error:g}", f"{peer['program']} {peer['method']}: {float(peer[TIME]) / 1000:.3g} at {float(peer['error']):.1e}"
                         if peer else "none so accurate", f"{float(ours[TIME]) / 1000:.3g} at {float(ours['error']):.1e}" if ours else "none so accurate",
                         f"{float(peer[TIME]) / there:.2f}" if there else ""))
    return table(f"{title}, ms an answer", ("question", "error at most", peers, "jellett", "ratio at the peer's own error"), rows)


def cycles():
    return questions("cycles", "Periodic orbits followed in a parameter", "AUTO-07p", (1e-5, 1e-8, 1e-10))


def proofs():
    return questions("proofs", "Periodic orbits proved, by the half-width of the period's enclosure", "CAPD", (1e-11, 1e-13, 1e-19))


def chaos():
    return questions("chaos", "Exponents of an orbit over 20 returns, and the angle at a homoclinic point, where heyoka's time is that of the integration alone",
                     "heyoka", (1e-5, 1e-7, 1e-9))


def fates():
    rows = read("fates")
    mine, peers = [row for row in rows if row["program"] == "jellett"], [row for row in rows if row["program"] != "jellett"]
    cells = []
    for error in (1e-4, 1e-7, 1e-10):
        fit = [row for row in peers if row["error"] and float(row["error"]) <= error]
        peer = min(fit, key=lambda row: float(row[TIME]), default=None)
        ours = min((row for row in mine if float(row["error"]) <= (float(peer["error"]) if peer else error)), key=lambda row: float(row[TIME]), default=None)
        if peer and ours:
            cells.append((f"{error:g}", *(f"{float(row[TIME]):.1f} at {float(row['error']):.1e}, {row['failed']} wrong" for row in (peer, ours)),
                          f"{float(peer[TIME]) / float(ours[TIME]):.1f}"))
    return table("How orbits end within ten returns, us an orbit", ("error at most", "heyoka, events", "jellett fates, one thread", "ratio"), cells)


def kernels():
    rows = read("kernels")
    codes = list(dict.fromkeys(row["code"] for row in rows))
    modes = [("rhs", "throughput"), ("rhs", "chain"), ("rhs_jacobian", "throughput"), ("rhs_jacobian", "chain")]
    found = {(row["code"], row["kernel"], row["mode"]): row["ns_least"] for row in rows}
    return table("Kernels of (3.2), ns an evaluation (of one lane in batches)", ("code", "field", "field, chain", "field and Jacobian", "both, chain"),
                 [(code, *(found.get((code, *mode), "") for mode in modes)) for code in codes])


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    print("\n".join(part for part in ["# Figures, row by row\n", *sections(), grazing(), threads(), kernels(), cycles(), proofs(), fates(), chaos(), tiers()] if part))


main()
