"""Pictures of the tables that tools/bench/run has written, by gnuplot.

usage: draw.py RESULTS [svg|png]         all of them
       draw.py --best RESULTS FILE.png   the best curve of each program alone, which README.md shows

Programs and methods differ in marks as well as in colours, which are those of Okabe and Ito, told apart by the colour-blind; forms differ
in dashes. So nothing is lost in grey. Letters are to be read on a page across which a picture lies."""
import csv
import os
import subprocess
import sys

COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#555555", "#8B4513", "#999933"]
MARKS = [7, 5, 9, 13, 11, 15, 6, 4, 8, 10, 12]
DASHES = ["solid", "'-'", "'.'", "'-.'", "'_'", "'-..'"]
LIFTED = ["level", "five", "track", "level_t", "five_t"]
FORMS = LIFTED + ["level_plain", "five_plain", "level_omega_n", "level_omega3", "variational", "central", "forward"]
ROUNDING = 2.2e-16  # of the reference's values when they are read as doubles


def read(path):
    if not os.path.exists(path):
        return []
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def number(text):
    return float(text) if text else None


class Panel:
    """Curves by colour and mark (what) and by dash (how), with a key of both. Points are (x, y, y_least, y_largest, failed, known);
    those whose error is not known stand alone, at the left."""

    def __init__(self, title):
        self.title, self.curves, self.front = title, {}, []

    def add(self, what, how, point):
        self.curves.setdefault((what, how), []).append(point)

    def text(self, name, colours):
        """Data blocks and the plot command."""
        hows = sorted({how for _, how in self.curves}, key=lambda how: (FORMS.index(how) if how in FORMS else len(FORMS), how))
        blocks, items = [], []

        def plot(points, columns, style):
            if points:
                block = f"${name}{len(blocks)}"
                blocks.append("\n".join([f"{block} << END", *(" ".join(f"{x:.6g}" for x in point[:4]) for point in points), "END"]))
                items.append(f"{block} using {columns} with {style} notitle")

        plot(self.front, "1:2", "lines lc rgb '#bbbbbb' lw 6")
        marks = {what: MARKS[i % len(MARKS)] for i, what in enumerate(colours)}
        for (what, how), points in self.curves.items():
            style = f"lc rgb '{colours[what]}' dt {dash(hows, how)} pt {marks[what]} lw 1.2 ps 0.7"
            plot([point for point in points if point[5]], "1:2:3:4", "yerrorlines " + style)
            plot([point for point in points if point[4]], "1:2", f"points lc rgb '{colours[what]}' pt 2 lw 2 ps 1.1")
        items += [f"keyentry with linespoints lc rgb '{colours[what]}' pt {marks[what]} lw 1.2 title \"{what}\"" for what in colours]
        items += [f"keyentry with lines lc rgb '#bbbbbb' lw 6 title \"best of jellett\""] if self.front else []
        items += [f"keyentry with lines lc rgb 'black' dt {dash(hows, how)} lw 1.5 title \"{how}\""
                  for how in hows if len(hows) > 1]
        if any(point[4] for points in self.curves.values() for point in points):
            items.append("keyentry with points lc rgb 'black' pt 2 lw 2 title \"orbits lost\"")
        self.key_rows = (sum("keyentry" in item for item in items) + 1) // 2
        width = 1 if max(map(len, colours), default=0) < 20 else -3  # gnuplot makes columns of long names too wide, others too narrow
        head = f'set title "{self.title}"\nset key bmargin center Left reverse maxrows {self.key_rows} noenhanced samplen 2 spacing 0.9 width {width} font ",13"'
        return "\n".join(blocks), head + "\nplot " + ", \\\n  ".join(items or ["NaN notitle"])


def dash(hows, how):
    return DASHES[hows.index(how) % len(DASHES)]


def draw(path, kind, size, layout, title, lines, plots):
    """lines: data blocks and settings; plots: commands, a panel each."""
    terminal = {"svg": f"svg size {size[0]},{size[1]} dynamic background 'white' font 'Helvetica,17'",
                "png": f"pngcairo size {size[0]},{size[1]} font 'Helvetica,13'"}[kind]
    script = [f"set terminal {terminal}", f"set output '{path}.{kind}'", "set encoding utf8", *lines,
              f"set multiplot layout {layout} title \"{title}\" noenhanced font ',19'", *plots, "unset multiplot"]
    subprocess.run(["gnuplot", "-"], input="\n".join(script) + "\n", text=True, check=True)


def draw_panels(path, kind, size, layout, title, settings, panels):
    """panels: (Panel, colours, settings of its own)."""
    texts = [(panel.text(f"p{i}_", colours), extra) for i, (panel, colours, extra) in enumerate(panels)]
    below = f"set bmargin {4.5 + 0.8 * max(panel.key_rows for panel, _, _ in panels)}"  # one for all, so that their axes are level
    draw(path, kind, size, layout, title, [*(blocks for (blocks, _), _ in texts), settings, below],
         [extra + "\n" + plot for (_, plot), extra in texts])


AXES = """set logscale xy
set format x '10^{%T}'
set format y '10^{%T}'
set grid xtics ytics lc rgb '#dddddd'
set border lw 0.8
set tics font ',15'
set bars 0.4"""


def programs(rows):
    """Colours by program and method, in the order of the table."""
    names = list(dict.fromkeys(name_of(row) for row in rows))
    return {name: COLOURS[i % len(COLOURS)] for i, name in enumerate(names)}


def name_of(row):
    return row["method"] if row["program"] == "jellett" else f"{row['program']} {row['method']}"


def point_of(row, column, time, left):
    error = number(row[column])
    shown = max(error, 1e-32) if error is not None else left
    return shown, *(float(row[key]) for key in time), error is None or int(row["failed"]) > 0, error is not None


def front(rows, column, time, left):
    """The points of jellett that no other point beats in both time and error."""
    points = sorted((point_of(row, column, time, left) for row in rows if row[column] and not int(row["failed"])), key=lambda p: p[1])
    best, kept = float("inf"), []
    for point in points:
        if point[0] < best:
            best = point[0]
            kept.append(point)
    return kept


TIME = ("us_per_return", "us_least", "us_largest")


def work_panels(rows, column, groups, left, time=TIME):
    """A panel for each (title, chosen): what chosen(row) is true for, with jellett's front behind."""
    single = [row for row in rows if row["threads"] == "1"]
    best = front([row for row in single if row["program"] == "jellett"], column, time, left)
    panels = []
    for title, chosen in groups:
        mine = [row for row in single if chosen(row)]
        panel = Panel(title)
        panel.front = best
        for row in mine:
            panel.add(name_of(row), row["form"], point_of(row, column, time, left))
        panels.append((panel, programs(mine), ""))
    return panels


def batched(row):
    return row["program"] == "jellett" and " " in row["method"]


def scalar(row):
    return row["program"] == "jellett" and " " not in row["method"]


def peer(row):
    return row["program"] != "jellett"


def section(results, kind, table, title):
    rows = read(f"{results}/{table}.csv")
    if not rows:
        return
    groups = [(f"{who}, {how}", lambda row, c=chosen, lifted=lifted: c(row) and (row["form"] in LIFTED) == lifted)
              for lifted, how in ((True, "1/s lifted away"), (False, "1/s left in"))
              for who, chosen in (("jellett, batches", batched), ("jellett, one orbit at a time", scalar), ("peers", peer))]
    settings = AXES + f"""
set xrange [1e-1:5e-17]
set yrange [0.1:4000]
set xlabel 'largest error of 10 returns'
set ylabel 'time per return [µs]'
set arrow 1 from {ROUNDING}, graph 0 to {ROUNDING}, graph 1 nohead dt '-' lc rgb '#888888'
set label 1 'reference, as doubles' at {ROUNDING}, graph 0.02 rotate by 90 font ',13' tc rgb '#666666' offset -0.5,0"""
    draw_panels(f"{results}/{table}", kind, (1800, 1300), "2,3", title, settings, work_panels(rows, "error", groups, 5e-2))


BEST = [  # what is shown of a program, its name and the place of it, mark, dash, colour: in grey, marks, dashes and names tell them apart
    (batched, "jellett, many orbits at once", (1e-7, 3.2e6), 7, "solid", "#0072B2", 4),
    (scalar, "jellett, one at a time", (2e-9, 1.15e5), 5, "solid", "#0072B2", 4),
    (lambda row: row["program"] == "heyoka", "heyoka, 8 at once", (1e-10, 4.3e5), 9, "'-'", "#D55E00", 2),
    (lambda row: row["program"] == "odeint", "Boost.odeint (▼) and GSL (◆)", (6e-5, 5.5e4), 11, "'-.'", "#009E73", 2),
    (lambda row: row["program"] == "gsl", "", (1, 1), 13, "'.'", "#AA4499", 2),
    (lambda row: row["program"] == "sundials", "SUNDIALS", (1e-8, 5e3), 15, "'_'", "#555555", 2),
]


def best(results, path):
    """Returns a second against error: of each program the points that none of its own beats in both. heyoka's runs with time among
    the states are left out, as in figures.py, which says why."""
    rows = [row for row in read(f"{results}/section.csv")
            if row["threads"] == "1" and not (row["program"] == "heyoka" and row["form"].endswith("_t"))]
    blocks, items, names = [], [], []
    for i, (chosen, name, (x, y), mark_type, dashes, colour, width) in enumerate(BEST):
        points = front([row for row in rows if chosen(row)], "error", TIME, 5e-2)
        points = [(error, 1e6 / least) for error, _, least, *_ in points if 1e-14 <= error <= 1e-4]
        blocks.append("\n".join([f"$b{i} << END", *(f"{error:.4g} {rate:.6g}" for error, rate in points), "END"]))
        items.append(f"$b{i} using 1:2 with linespoints lc rgb '{colour}' dt {dashes} pt {mark_type} lw {width} ps 1.6 notitle")
        names.append(f"set label '{name}' at {x},{y} tc rgb '{'#333333' if 'GSL' in name else colour}'")
    ends = ", ".join(f"'10^{{{power}}}' 1e{power}" for power in range(-14, -3, 2))
    script = ["set terminal pngcairo size 1600,1000 font 'DejaVu Sans,31' lw 2", f"set output '{path}'", "set encoding utf8", *blocks, AXES,
              "set margins 8.5,2,3.4,0.8", f"set xtics ({ends}) font ',31' scale 0.6", "set ytics font ',31' scale 0.6", "set format y '10^{%T}'",
              "set xrange [1e-4:8e-15]", "set yrange [400:6e6]", "set xlabel 'error of ten returns   (more accurate →)' offset 0,0.3",
              "set ylabel 'returns a second   (faster →)' offset 0.8,0", *names]
    script.append("plot " + ", \\\n  ".join(items))
    subprocess.run(["gnuplot", "-"], input="\n".join(script) + "\n", text=True, check=True)


def times(results, kind):
    rows = [row for row in read(f"{results}/section.csv") if row["time_error"] or row["form"].endswith("_t")]
    if not rows:
        return
    groups = [("jellett, one orbit at a time, 1/s lifted away", lambda row: scalar(row) and row["form"] in LIFTED),
              ("jellett, 1/s left in", lambda row: scalar(row) and row["form"] not in LIFTED),
              ("peers (time carried as a state where lifted)", peer)]
    settings = AXES + f"""
set xrange [1e-1:5e-17]
set yrange [1:4000]
set xlabel 'largest error of a crossing time, 10 returns'
set ylabel 'time per return [µs]'"""
    draw_panels(f"{results}/times", kind, (1500, 700), "1,3", "Crossing times of the section map at (5.1), regular grid", settings,
         work_panels(rows, "time_error", groups, 5e-2))


def drift(results, kind):
    rows = [row for row in read(f"{results}/section.csv") if row["form"] in ("level", "five", "five_plain")]
    if not rows:
        return
    panels = []
    for column, name in (("drift_E", "E"), ("drift_G", "G")):
        groups = [(f"{name}: {who}", chosen) for who, chosen in (("jellett, batches", batched), ("jellett, one orbit at a time", scalar), ("peers", peer))]
        moved = [row for row in rows if number(row[column])]  # no drift is known where no return was made
        for panel, colours, _ in work_panels(moved, column, groups, 5e-2):
            panels.append((panel, colours, f"set xlabel 'largest drift of {name} over all returns'"))
    draw_panels(f"{results}/drift", kind, (1800, 1300), "2,3", "Drift of the integrals along the section map at (5.1), regular grid",
         AXES + "\nset xrange [1e-1:5e-17]\nset yrange [0.1:4000]\nset ylabel 'time per return [µs]'", panels)


def slope(results, kind):
    rows = read(f"{results}/slope.csv")
    if not rows:
        return
    groups = [("variational equations: jellett", lambda row: row["program"] == "jellett" and row["form"] == "variational"),
              ("differences: jellett", lambda row: row["program"] == "jellett" and row["form"] != "variational"),
              ("peers", peer)]
    settings = AXES + """
set xrange [1:1e-15]
set yrange [1:6000]
set xlabel 'largest error of DP, relative to its largest entry'
set ylabel 'time per derivative [µs]'"""
    draw_panels(f"{results}/slope", kind, (1500, 700), "1,3", "Derivative DP of the section map at (5.1), regular grid", settings,
         work_panels(rows, "error", groups, 0.5, ("us_per_derivative", "us_least", "us_largest")))


def questions(results, kind, name, ranges, size, layout, title):
    """One panel a question."""
    rows = read(f"{results}/{name}.csv")
    if not rows:
        return
    settings = AXES + f"""
set xrange [{ranges[0]}]
set yrange [{ranges[1]}]
set xlabel 'error, relative to the larger of the value and 1'
set ylabel 'time of an answer [µs]'"""
    panels = [(panel, colours, "") for question in dict.fromkeys(row["question"] for row in rows) for panel, colours, _ in
              work_panels([row for row in rows if row["question"] == question], "error", [(question, lambda row: True)], 0.5,
                          ("us_per_answer", "us_least", "us_largest"))]
    draw_panels(f"{results}/{name}", kind, size, layout, title, settings, panels)


def fates(results, kind):
    rows = read(f"{results}/fates.csv")
    if not rows:
        return
    settings = AXES + """
set xrange [10:1e-15]
set yrange [10:1000]
set xlabel '90th percentile of the error of the time at a pole'
set ylabel 'time per orbit [µs]'"""
    for row in rows:  # of 600 orbits, that many have a wrong fate: none is lost
        row["failed"] = "0"
    panels = work_panels(rows, "error", [("600 orbits of the whole section", lambda row: True)], 1, ("us_per_orbit", "us_least", "us_largest"))
    draw_panels(f"{results}/fates", kind, (800, 700), "1,1", "How orbits of (5.1) end within ten returns", settings, panels)


def spread_panels(rows, time, least):
    """A panel for each kind of points: error (median, with least and largest as bars) against time."""
    colours = {name: COLOURS[i % len(COLOURS)] for i, name in enumerate(dict.fromkeys(row["method"] for row in rows))}
    panels = []
    for points in dict.fromkeys(row["points"] for row in rows):
        lines, keys = [], []
        mine = [row for row in rows if row["points"] == points]
        for name in dict.fromkeys(row["method"] for row in mine):
            block = [f"${points}{len(lines)} << END"]
            for row in mine:
                if row["method"] == name:
                    refused = int(row.get("failed") or 0)
                    low, middle, high = (min(max(float(row[key]), least), 50) for key in ("error_least", "error", "error_largest"))
                    block.append(f"{middle:.4g} {float(row[time]):.5g} {low:.4g} {high:.4g}")
            lines.append("\n".join(block + ["END"]))
            joined = f", ${points}{len(lines) - 1} using 1:2 with lines lc rgb '{colours[name]}' notitle" if len(block) > 2 else ""
            keys.append(f"${points}{len(lines) - 1} using 1:2:3:4 with xerrorbars lc rgb '{colours[name]}' pt {MARKS[len(keys) % len(MARKS)]} ps 0.9 "
                        f"lw 1.3 title \"{name}{f' ({refused} refused)' if refused else ''}\"" + joined)
        panels.append((points, "\n".join(lines), ", \\\n  ".join(keys)))
    return panels


def spreads(results, kind, table, title, time, ylabel, xrange, yrange, layout, size, names):
    rows = read(f"{results}/{table}.csv")
    if not rows:
        return
    panels = spread_panels(rows, time, 1e-18)
    settings = [AXES, f"set xrange [{xrange}]", f"set yrange [{yrange}]", f"set ylabel '{ylabel}'",
                "set xlabel 'error: median; bars from the least to the largest'", "set key bmargin center Left reverse maxrows 2 noenhanced samplen 2 font ',14'", "set bmargin 7"]
    draw(f"{results}/{table}", kind, size, layout, title, [*(blocks for _, blocks, _ in panels), *settings],
         [f"set title \"{names.get(points, points)}\"\nplot {plot}" for points, _, plot in panels])


def kernels(results, kind):
    rows = read(f"{results}/kernels.csv")
    if not rows:
        return
    groups = [("rhs", "throughput", "field, throughput"), ("rhs", "chain", "field, dependent chain"),
              ("rhs_jacobian", "throughput", "field and Jacobian, throughput"), ("rhs_jacobian", "chain", "field and Jacobian, dependent chain")]
    blocks, plots = [], []
    for i, (kernel, mode, title) in enumerate(groups):
        mine = [row for row in rows if row["kernel"] == kernel and row["mode"] == mode]
        blocks.append(f"$k{i} << END")
        for at, row in enumerate(reversed(mine)):
            blocks.append(f"{at} {row['ns_median']} {row['ns_least']} {row['ns_largest']} \"{row['code']}\" {1 if row['code'].startswith('jellett') else 2}")
        blocks.append("END")
        top = 1.25 * max(float(row["ns_median"]) for row in mine)
        plots.append(f"set title \"{title}\"\nset xrange [0:{top}]\nset yrange [-0.7:{len(mine) - 0.3}]\n"
                     f"plot $k{i} using (0):1:(0):2:($1-0.35):($1+0.35):($6 == 1 ? 0x0072B2 : 0xBBBBBB):ytic(5) with boxxyerror fs solid lc rgb variable notitle, "
                     f"$k{i} using 2:1:3:4 with xerrorbars pt 0 lc rgb 'black' notitle, "
                     f"$k{i} using 2:1:(sprintf('%.3g', $2)) with labels left offset 1.2,0 font ',14' notitle")
    settings = ["unset key", "set border 3", "set xtics nomirror", "set ytics nomirror scale 0 noenhanced", "set grid xtics lc rgb '#dddddd'",
                "set xlabel 'ns per evaluation (of one lane in batches)'"]
    draw(f"{results}/kernels", kind, (1100, 800), "2,2", "The reduced field (3.2): all compiled by one compiler with the same flags",
         [*blocks, *settings], plots)


def main():
    if len(sys.argv) == 4 and sys.argv[1] == "--best":
        best(sys.argv[2], sys.argv[3])
        return
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    results, kind = sys.argv[1], sys.argv[2] if len(sys.argv) == 3 else "svg"
    section(results, kind, "section", "Section map of the spherical top at (5.1), regular grid: error against time")
    section(results, kind, "grazing", "Section map at (5.1), grid that grazes the pole: error against time")
    times(results, kind)
    drift(results, kind)
    slope(results, kind)
    questions(results, kind, "cycles", ("1:1e-16", "3000:1000000"), (2400, 1100), "2,4",
              "Periodic orbits followed in a parameter: jellett and AUTO-07p")
    questions(results, kind, "proofs", ("1e-9:1e-32", "10000:2000000"), (1800, 1100), "2,3",
              "Periodic orbits proved: half-width of the period's enclosure, jellett and CAPD")
    questions(results, kind, "chaos", ("1e-2:1e-15", "10:100000"), (1500, 650), "1,2",
              "Chaos at (5.1): exponents over 20 returns, and the angle of separatrices, jellett and heyoka")
    fates(results, kind)
    spreads(results, kind, "jacobian", "Jacobian of (3.2) at 256 points, against ball arithmetic", "ns_per_jacobian", "ns per Jacobian",
            "1e-17:100", "3:3000", "1,2", (1300, 560), {"generic": "generic points", "near_pole": "near a pole: 1 - γ_3 from 10^{-10} to 10^{-2}"})
    spreads(results, kind, "eigenvalues", "Eigenvalues at fixed points (4.4), the matrix being given", "ns_per_matrix", "ns per matrix",
            "1e-18:1", "30:50000", "2,2", (1300, 900),
            {"good": "ω_3 ≠ 0: zero is threefold, semisimple", "nearly_defective": "ω_3 from 10^{-9} to 10^{-3}",
             "defective": "ω_3 = 0: zero is defective, fourfold", "defective_turned": "ω_3 = 0, in coordinates turned at random"})
    kernels(results, kind)


main()
