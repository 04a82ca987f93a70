"""How orbits of (5.1) end within ten returns, by heyoka: at which pole and when, or not.

usage: heyoka_fates.py reference STARTS.csv               in quadruple precision, to standard output: tests/reference/data/fates_51.csv
       heyoka_fates.py peer FATES.csv REPEATS DECADES     rows of tools/bench/fates.py; DECADES of the tolerance, as 5,6,7

STARTS.csv: eta, gamma3, v_nu, omega_n, omega3 of points of the section. Form level with 1/s lifted away and time among the states: a pole is
where s falls to 1e-8, and what is left of the time is s/(gamma3 omega_tau), to s^2 of itself. One orbit at a time, since a batch goes
on until its last orbit has ended; heyoka's events, and its propagation until one of them says stop. Compilation is not counted. Starts
are doubles here, which an error of 1e-16 tells apart from those that jellett lifts from eta and gamma3."""
import sys
import time

import heyoka as hy
import numpy as np

from heyoka_peer import a3, system

RETURNS, POLE, LIMIT = 10, 1e-8, 1e4


class Followed:
    """One orbit after another to its end."""

    def __init__(self, tolerance, kind):
        s, w = hy.make_vars("s", "w")
        self.kind, self.made = kind, 0
        crossing = hy.t_event(w, callback=self.cross, direction=hy.event_direction.positive, fp_type=kind)
        pole = hy.t_event(s - POLE, fp_type=kind)
        self.integrator = hy.taylor_adaptive(system("level_t"), np.array([0.1, 0.1, 0.0, 0.1, 0.9, 0.0], dtype=kind),
                                             tol=kind(tolerance), t_events=[crossing, pole], fp_type=kind)

    def __deepcopy__(self, memo):
        return self  # heyoka copies its callbacks

    def cross(self, ta, sign):
        self.made += 1
        return self.made < RETURNS

    def follow(self, x0):
        """Fate and time of the end."""
        ta = self.integrator
        self.made = 0
        ta.time = self.kind(0)
        ta.state[:] = x0
        ta.reset_cooldowns()
        ta.propagate_until(self.kind(1e-3))  # off the section
        self.made = 0
        outcome = ta.propagate_until(self.kind(LIMIT))[0]
        x = ta.state
        if int(outcome) == 1 or int(outcome) == -2:
            return ("pole+" if x[0] > 0 else "pole-"), x[5] + abs(x[4] / (x[0] * x[2]))
        return "alive", x[5]


def read(path):
    with open(path, encoding="utf-8") as file:
        return np.genfromtxt((line for line in file if not line.startswith("#")), delimiter=",", names=True, dtype=None, encoding="utf-8")


def starts_of(data, kind):
    gamma3, v, n, three = (np.array([row[name] for row in data]).astype(kind) for name in ("gamma3", "v_nu", "omega_n", "omega3"))
    s = np.sqrt((kind(1) - gamma3) * (kind(1) + gamma3))
    return np.array([gamma3, v, kind(0) * v, (kind(a3) + gamma3) * n + s * three, s, kind(0) * v])


def reference(path):
    data, kind = read(path), hy.real128
    x0 = starts_of(data, kind)
    one = Followed("1e-30", kind)
    print("# written by tools/bench/heyoka_fates.py: heyoka " + hy.__version__ + ", real128 at 1e-30; ten returns at most")
    print("eta,gamma3,v_nu,omega_n,omega3,fate,t_end")
    for i, row in enumerate(data):
        fate, t = one.follow(x0[:, i])
        print(",".join(repr(float(row[name])) for name in ("eta", "gamma3", "v_nu", "omega_n", "omega3")) + f",{fate},{float(t)!r}", flush=True)


def peer(path, repeats, decades):
    data = read(path)
    x0 = starts_of(data, np.float64)
    for tolerance in decades:
        one, seconds, found = Followed(tolerance, np.float64), [], []
        for _ in range(repeats):
            begin = time.process_time()
            found = [one.follow(x0[:, i]) for i in range(x0.shape[1])]
            seconds.append(time.process_time() - begin)
        wrong = [fate != row["fate"] for (fate, _), row in zip(found, data)]
        off = sorted(np.inf if bad else abs(t - row["t_end"]) for (_, t), row, bad in zip(found, data, wrong) if row["fate"] != "alive")
        unit = 1e6 / len(data)
        print(f"heyoka,taylor events,level_t,1,{tolerance:g},{off[int(0.9 * len(off))]:.3e},{unit * np.median(seconds):.4g},"
              f"{unit * min(seconds):.4g},{unit * max(seconds):.4g},{sum(wrong)}", flush=True)


if len(sys.argv) == 3 and sys.argv[1] == "reference":
    reference(sys.argv[2])
elif len(sys.argv) == 5 and sys.argv[1] == "peer":
    peer(sys.argv[2], int(sys.argv[3]), [10.0 ** -int(k) for k in sys.argv[4].split(",")])
else:
    sys.exit(__doc__)
