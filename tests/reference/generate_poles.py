#!/usr/bin/env python3
"""Ends at poles in 40 digits, and what lies beyond one: data/poles_creeping_51.csv, and the numbers quoted in PROVENANCE.md.

    generate_poles.py creeping     orbits that approach a pole slowly, omega_tau near 0 there
    generate_poles.py beyond       the rows of flow_generic.csv after the pole (a minute)

System (3.2) of Kilin and Ivanova (2023) in the time dtau = dt/s, s = sqrt(1 - gamma3^2) a state of its own that may be negative;
extrapolated midpoint rule (Gragg, Bulirsch, Stoer). Needs mpmath."""
import csv
import os
import sys

from mpmath import cos, lu_solve, matrix, mp, mpf, nstr, sin, sqrt

mp.dps = 40
ROWS = 16  # of the extrapolation
DATA = os.path.join(os.path.dirname(__file__), "data")


class Top:
    def __init__(self, m, R, g, I1, I3, a3):
        self.m, self.R, self.g, self.I1, self.I3, self.a3 = m, R, g, I1, I3, a3

    def field(self, x):
        """x = gamma3, v_nu, omega_tau, omega_n, omega3, s, t."""
        m, R, g, I1, I3, a3 = self.m, self.R, self.g, self.I1, self.I3, self.a3
        y, v, wt, wn, w3, s, _ = x
        b, e, D = a3 + R * y, R + a3 * y, I1 + m * a3**2 * s**2
        theta, slip = I1 * I3 + I1 * m * R**2 * s**2 + I3 * m * b**2, e * wt + v
        return [s * s * wt, wn * (b * wn + R * s * w3),
                (m * a3 * s**2 * (a3 * y * wt**2 - g) - wn * (I1 * y * wn + I3 * s * w3)) / D,
                y * wn * wt - m * I3 * b * wn * slip / theta + I3 * s * w3 * wt * (I3 + m * R * e) / theta,
                m * R * s * (s * w3 * wt * (R * y * (I1 - I3) - a3 * I3) - I1 * wn * slip) / theta, -y * s * wt, s]

    def exponent(self, x):
        """omega_n has the part C |s|^exponent at the pole x, beside its power series."""
        b = self.a3 + self.R * x[0]
        return (self.m * b * x[1] - self.I1 * x[0] * x[2]) / ((self.I1 + self.m * b * b) * x[0] * x[2])


def midpoint(field, x, h, n):
    step = h / n
    before, now = x, [a + step * b for a, b in zip(x, field(x))]
    for _ in range(n - 1):
        before, now = now, [a + 2 * step * b for a, b in zip(before, field(now))]
    return [(a + b + step * c) / 2 for a, b, c in zip(before, now, field(now))]


def step(field, x, h):
    """One step, and how far the last two columns differ."""
    table = []
    for j in range(1, ROWS + 1):
        row = [midpoint(field, x, h, 2 * j)]
        for k in range(1, j):
            factor = mpf(j * j) / (j * j - (j - k) ** 2)
            row.append([q + (p - q) * factor for p, q in zip(row[k - 1], table[-1][k - 1])])
        table.append(row)
    y, z = table[-1][-1], table[-1][-2]
    return y, max(abs(a - b) for a, b in zip(y, z))


def follow(top, x, length, done):
    """Steps of at most length(x) until done(x). s keeps its sign: with s > 0 the time t grows with tau, with s < 0 it falls."""
    h = mpf("0.02")
    while not done(x):
        wanted = length(x)
        taken = wanted if abs(wanted) < h else h * mp.sign(wanted)
        y, error = step(top.field, x, taken)
        if error > mpf(10) ** -32:
            h = abs(taken) * mpf("0.7")
            continue
        x = y
        if error < mpf(10) ** -34 and abs(taken) == h:
            h *= mpf("1.2")
    return x


def at_time(top, x, t):
    """The state at physical time t: the last steps are Newton's method on t(tau)."""
    return follow(top, x, lambda z: (t - z[6]) / z[5], lambda z: abs(t - z[6]) < mpf(10) ** -36)


def to_pole(top, x):
    """The limit, with what is left of t by s' = -gamma3 omega_tau s."""
    x = follow(top, x, lambda z: mpf(1), lambda z: abs(z[5]) < mpf(10) ** -20)
    return x[:6] + [x[6] + x[5] / (mp.nint(x[0]) * x[2])]


def creeping():
    top, E, G = Top(mpf(1), mpf(1), mpf(1), mpf(1) / 3, mpf(1) / 3, mpf("0.51")), mpf("2.15"), mpf("-0.56")
    print("eta,gamma3,fate,t_end,v_nu_end,omega_tau_end,omega3_end")
    for eta, y in (("0", "-0.99"), ("-0.785", "0.735")):
        s, b = sqrt(1 - mpf(y) ** 2), top.a3 + top.R * mpf(y)
        K = top.I1 * top.R**2 * s * s + top.I3 * b * b
        W = sqrt((2 * (E - top.m * top.g * top.a3 * mpf(y)) - G * G / K) / top.m)
        v_tau = W * sqrt(top.m * K / (top.m * K + top.I1 * top.I3)) * cos(mpf(eta))
        x = to_pole(top, [mpf(y), W * sin(mpf(eta)), mpf(0), (top.R * s * G + top.I3 * b * v_tau) / K,
                          (top.I1 * top.R * s * v_tau - b * G) / K, s, mpf(0)])
        print(",".join([eta, y, str(int(mp.nint(x[0])))] + [nstr(x[i], 25) for i in (6, 1, 2, 4)]), flush=True)


def singular_part(top, x, pole, side):
    """C of omega_n = series + C |s|^exponent on one side of the pole: collocation of omega_n/s in powers of t - t_pole and
    those powers times |t - t_pole|^(exponent - 1)."""
    regular, singular, power = 22, 8, top.exponent(pole) - 1
    count = regular + singular
    x = at_time(top, x, pole[6] + side * mpf("0.1"))
    times = [side * mpf("0.08") * (1 - cos(mp.pi * (i + mpf(1) / 2) / count)) / 2 for i in range(count)]
    a, right = matrix(count, count), matrix(count, 1)
    for i, dt in reversed(list(enumerate(times))):  # towards the pole, each from the one before
        x = at_time(top, x, pole[6] + dt)
        right[i] = x[3] / x[5]
        for k in range(count):
            a[i, k] = dt**k if k < regular else abs(dt) ** power * dt ** (k - regular)
    c = lu_solve(a, right)
    return c[0], -side * c[regular] / abs(pole[2]) ** power


def beyond():
    top = Top(*(mpf(p) for p in ("1.3", "0.7", "9.81", "0.29", "0.21", "-0.12")))
    with open(os.path.join(DATA, "flow_generic.csv")) as file:
        rows = {float(r[0]): [mpf(q) for q in r] for r in list(csv.reader(file))[1:]}

    def state(t, sign):
        return rows[t][1:] + [sign * sqrt((1 - rows[t][1]) * (1 + rows[t][1])), mpf(t)]

    before, after = state(1.0, 1), state(2.0, -1)
    there = at_time(top, after, mpf(4))
    print("row t=4 from row t=2 with s < 0: off by", nstr(max(abs(a - b) for a, b in zip(there[:5], rows[4.0][1:])), 3))
    ends = [to_pole(top, before), to_pole(top, after)]
    for name, x in zip(("forwards from t=1: ", "backwards from t=2:"), ends):
        print("pole", name, "t, v_nu, omega_tau, omega3 =", ", ".join(nstr(x[i], 25) for i in (6, 1, 2, 4)))
    print("exponent", nstr(top.exponent(ends[0]), 12))
    for name, x, end, side in (("before", before, ends[0], -1), ("after", after, ends[1], 1)):
        print(name, "the pole: omega_n/s at it %s, C = %s" % tuple(nstr(c, 12) for c in singular_part(top, x, end, side)),
              flush=True)


if __name__ == "__main__":
    {"creeping": creeping, "beyond": beyond}[sys.argv[1]]()
