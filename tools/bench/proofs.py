"""Periodic orbits proved by jellett and by CAPD: how narrow the period's enclosure is, and how long the proof takes.

usage: proofs.py JELLETT CAPD [REPEATS]     CAPD: the program of capd_peer.cpp, built by tools/bench/run

`jellett certify` finds the orbit and its crossings; what is timed is the proof alone, by one process each, start and output included:
`jellett check` of its certificate, and CAPD with the same boxes. Output: one row an orbit, program and setting; the error is the radius
of the period. A row fails where nothing is proved."""
import json
import os
import statistics
import subprocess
import sys
import tempfile

from cycles import timed

ROESSLER = "roessler --section x=0 --direction up"
LORENZ = "lorenz --section z=27 --direction up"
ORBITS = [
    (f"{ROESSLER} --period 1 --start y=-8.381,z=0.0296", "roessler 1"),
    (f"{ROESSLER} --period 2 --start y=-5.424,z=0.0311", "roessler 2"),
    (f"{ROESSLER} --period 3 --start y=-6.2332,z=0.03064", "roessler 3"),
    (f"{LORENZ} --period 2 --start x=-13.764,y=-19.579", "lorenz AB"),
    (f"{LORENZ} --period 3 --start x=-13.5066,y=-18.9919", "lorenz AAB"),
    (f"{LORENZ} --period 5 --start x=-11.98545,y=-15.63228", "lorenz AAAAB"),
]
RADIUS = "1e-8"
DIGITS = ["12", "14", "16", "20", "30"]
ORDERS = ["8", "12", "16", "20", "30"] # of CAPD, whose steps follow from a tolerance below its rounding


def tell(orbit, program, method, setting, radius, times):
    print(f"{orbit},{program},{method},,1,{setting},{radius},{statistics.median(times):.4g},{min(times):.4g},{max(times):.4g},"
          f"{int(radius == '')}", flush=True)


def main():
    jellett, capd, repeats = sys.argv[1], sys.argv[2], int(sys.argv[3]) if len(sys.argv) > 3 else 15
    print("# " + timed([jellett, "--version"], 1)[0].strip())
    print("question,program,method,form,threads,tolerance,error,us_per_answer,us_least,us_largest,failed")
    with tempfile.TemporaryDirectory() as folder:
        for question, orbit in ORBITS:
            for digits in DIGITS:
                name = f"{folder}/{digits}.json"
                timed([jellett, "certify", "cycle", *question.split(), "--radius", RADIUS, "--digits", digits, "-o", name], 1)
                with open(name, encoding="utf-8") as file:
                    proof = json.load(file)
                _, times = timed([jellett, "check", name], repeats)
                tell(orbit, "jellett", "certify", f"1e-{digits}", proof["shown"]["period"]["radius"], times)
            points = "\n".join(" ".join(box["middle"] for box in leg["box"].values()) for leg in proof["given"]["legs"])
            for order in ORDERS if os.path.exists(capd) else []:
                command = [capd, question.split()[0], RADIUS, order, "1e-16"]
                try:
                    text, times = timed(command, repeats, input=points)
                    tell(orbit, "CAPD", f"order {order}", "1e-16", f"{float(text.split(',')[1]):.3g}", times)
                except subprocess.CalledProcessError:
                    tell(orbit, "CAPD", f"order {order}", "1e-16", "", [0])


if __name__ == "__main__":
    main()
