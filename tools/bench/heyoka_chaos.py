"""The questions of chaos.py put to heyoka. Compilation is excluded from all times.

usage: heyoka_chaos.py EXPONENTS.csv SEPARATRIX.csv REPEATS DECADES

DECADES: of the tolerance, as 5,6,7 for 1e-5, 1e-6, 1e-7. Exponents: variational equations in batches of 8, without
renormalization, which 20 returns do not need; the clock runs for the propagation alone, from the starts to beyond the last return.
Time is not among the states: the reference's is taken. Angle: one orbit with one tangent vector, which begins on the eigenvector of the
saddle; what is timed is Newton's method for its distance from there, until the orbit is symmetric. Saddle, eigenvector and a start within
a percent are given. Output: rows of chaos.py."""
import sys
import time

import heyoka as hy
import numpy as np

from heyoka_peer import crossing, derivative, lift, lower, on_section, system, variations

RETURNS = 20
SADDLE, MULTIPLIER = np.array([0.0, -0.613584389706638135766]), -1.24275395055601804989106
SEED, TURNS, NEWTON = 1.07e-4, 44, 4  # begun closer, rounding and tolerance are magnified: errors are larger


def tell(question, way, tolerance, error, seconds, answers):
    unit = 1e6 / answers
    print(f"{question},heyoka,{way},level,1,{tolerance:g},{error:.3e},{unit * np.median(seconds):.4g},{unit * min(seconds):.4g},"
          f"{unit * max(seconds):.4g},0", flush=True)


def exponents(path, repeats, decades):
    data = np.genfromtxt(path, delimiter=",", names=True, comments="#")
    for tolerance in decades:
        found, seconds = variations(np.array([data["eta"], data["gamma3"]]).T, RETURNS, tolerance, repeats)
        error = max(abs(np.log(np.linalg.norm(own, 2)) / known["t"] - known["exponent"]) for own, known in zip(found, data, strict=True))
        tell("exponents", "taylor x8", tolerance, error, seconds, len(data))


def tangent(field):
    """The field with one tangent vector: states, then its entries."""
    states = [x for x, _ in field]
    entries = hy.make_vars(*(f"d_{i}" for i in range(len(states))))
    along = []
    for (_, f), entry in zip(field, entries):
        terms = [hy.diff(f, x) * e for x, e in zip(states, entries)]
        along.append((entry, sum(terms[1:], terms[0])))
    return field + along


def angle(true, repeats, decades):
    field = system("level")
    whole = tangent(field)
    rhs = hy.cfunc([f for _, f in field], [x for x, _ in field])

    def crossings(ta, q, v, numbers):
        """Points of the section after so many returns, each with what the map's derivative makes of v."""
        ta.time = 0.0
        ta.state[:] = np.concatenate([lift(q), derivative(lift, q, 2) @ v])
        made, found = 0, []
        while made < numbers[-1]:
            before = ta.state[2]
            ta.step(write_tc=made + 1 in numbers)
            if before < 0 <= ta.state[2]:
                made += 1
                if made in numbers:
                    _, x = crossing(ta.tc, ta.last_h, before, ta.state[2])
                    found.append((lower(x[:5]), derivative(lower, x[:5], 5) @ on_section(rhs, x[:5], x[5:, None])[:, 0]))
        return found

    def symmetric(ta, distance):
        """The angle where P(q) is the mirror image of q: there the stable manifold has the mirrored tangent of P(q)."""
        for _ in range(NEWTON):
            (q, v), (p, w) = crossings(ta, SADDLE + distance * direction, direction, [TURNS, TURNS + 1])
            distance -= (q[0] + p[0]) / (v[0] + w[0])
        return np.arctan(abs((v[0] * w[1] + v[1] * w[0]) / (v[1] * w[1] - v[0] * w[0])))

    ta = hy.taylor_adaptive(whole, np.zeros(10), tol=1e-15)
    slope = np.array([crossings(ta, SADDLE, e, [1])[0][1] for e in np.eye(2)]).T
    direction = np.array([slope[0, 1], MULTIPLIER - slope[0, 0]])
    direction /= np.linalg.norm(direction)
    for tolerance in decades:
        ta = hy.taylor_adaptive(whole, np.zeros(10), tol=tolerance)
        seconds = []
        for _ in range(repeats):
            begin = time.process_time()
            found = symmetric(ta, SEED)
            seconds.append(time.process_time() - begin)
        tell("angle", "taylor", tolerance, abs(found - true), seconds, 1)


if len(sys.argv) != 5:
    sys.exit(__doc__)
decades = [10.0 ** -int(k) for k in sys.argv[4].split(",")]
exponents(sys.argv[1], int(sys.argv[3]), decades)
angle(float(np.genfromtxt(sys.argv[2], delimiter=",", names=True)["angle"]), int(sys.argv[3]), decades)
