#!/usr/bin/env python3
"""Eigenvalues at equilibria in 50 digits, for test_eigen.c: writes data/eigen.csv.

Independent of everything here: system (3.2) of Kilin and Ivanova (2023) typed in once more, its Jacobian by SymPy,
evaluated and decomposed by mpmath with 160 digits at the exact decimal or rational values. Needs sympy and mpmath; the
tests need only the file.
"""
import sys

import mpmath
import sympy as sp

mpmath.mp.dps = 160

c, v, wt, wn, w3 = states = sp.symbols("gamma3 v_nu omega_tau omega_n omega3", real=True)
m, R, g, a3, I1, I3 = params = sp.symbols("m R g a3 I1 I3", real=True)
s = sp.sqrt(1 - c**2)
b = a3 + R * c
e = R + a3 * c
Theta = I1 * I3 + I1 * m * R**2 * s**2 + I3 * m * b**2
D = I1 + m * a3**2 * s**2
V = e * wt + v
field = [
    s * wt,
    wn * (b * wn + R * s * w3) / s,
    (m * a3 * s**2 * (a3 * c * wt**2 - g) - wn * (I1 * c * wn + I3 * s * w3)) / (s * D),
    c * wn * wt / s - m * I3 * b * wn * V / (s * Theta) + I3 * w3 * wt * (I3 + m * R * e) / Theta,
    -m * R * I1 * wn * V / Theta + m * R * s * w3 * wt * (R * c * (I1 - I3) - a3 * I3) / Theta,
]
jacobian = sp.Matrix(field).jacobian(states)
evaluate = sp.lambdify(states + params, jacobian, modules="mpmath")

ULP_ABOVE_THIRD = str(sp.Rational(6004799503160661 + 1, 2**54))
CASES = [
    # title, --set, --at
    ("generic", "m=1.3,R=0.7,g=9.81,I1=0.29,I3=0.21,a3=0", "gamma3=0.25,v_nu=0.8,omega3=-2.3"),
    ("as in the report", "a3=0", "gamma3=0.3,v_nu=0.7,omega3=1.1"),
    ("unstable focus", "a3=0,I1=2/5", "gamma3=-0.6,v_nu=0.7,omega3=1.1"),
    ("unstable node", "a3=0,I1=2/5", "gamma3=-0.99,v_nu=0.7,omega3=1.1"),
    ("centre on the equator", "a3=0,I1=2/5", "gamma3=0,v_nu=0.7,omega3=1.1"),
    ("no slipping velocity", "a3=0,I1=2/5", "gamma3=0.3,v_nu=0,omega3=1.1"),
    ("no spin: defective zero", "a3=0,I1=2/5", "gamma3=0.3,v_nu=0.7,omega3=0"),
    ("almost no spin", "a3=0,I1=2/5", "gamma3=0.3,v_nu=0.7,omega3=1e-8"),
    ("spin of a rounding unit", "a3=0,I1=2/5", "gamma3=0.3,v_nu=0.7,omega3=1e-16"),
    ("spin far below the rounding unit", "a3=0,I1=2/5", "gamma3=0.3,v_nu=0.7,omega3=1e-60"),
    ("almost a double root", "a3=0,I1=2/5", "gamma3=0.9692198168046667,v_nu=0.7,omega3=1.1"),
    ("at the north pole", "a3=0,I1=2/5", "gamma3=0.999999999999,v_nu=0.7,omega3=1.1"),
    ("at the south pole", "a3=0,I1=2/5", "gamma3=-0.999999999999,v_nu=0.7,omega3=1.1"),
    ("at the north pole without spin", "a3=0,I1=2/5", "gamma3=0.999999999999,v_nu=1,omega3=1e-9"),
    ("hardly any axial inertia", "a3=0,I1=2/5,I3=1e-12", "gamma3=0.3,v_nu=0.7,omega3=1.1"),
    ("no axial inertia", "a3=0,I1=2/5,I3=0", "gamma3=0.3,v_nu=0.7,omega3=1.1"),
    ("equal moments", "a3=0,I1=1/3,I3=1/3", "gamma3=0.5,v_nu=-2,omega3=0.7"),
    ("moments one ulp apart", "a3=0,I1=1/3,I3=" + ULP_ABOVE_THIRD, "gamma3=0.5,v_nu=-2,omega3=0.7"),
    ("tiny sphere", "a3=0,m=1e-9,R=1e-3,I1=4e-16,I3=3.5e-16", "gamma3=0.3,v_nu=0.01,omega3=300"),
    ("parameters to 1e150", "a3=0,m=1e150,R=1e-75,I1=1.5,I3=1.2", "gamma3=0.3,v_nu=1e-75,omega3=1.1"),
    ("parameters to 1e-150", "a3=0,m=1e-150,R=1e75,I1=1.5,I3=1.2", "gamma3=0.3,v_nu=1e75,omega3=1.1"),
    ("without weight", "g=0,a3=0.51,I1=1/3,I3=1/3", "gamma3=0.3,v_nu=0.7,omega3=0"),
    ("steady precession", "g=2,a3=1/2,m=1,R=1,I1=1/3,I3=1/3,m=1", "gamma3=-3/5,omega_n=PRECESSION,omega3=PRECESSION"),
]


def number(text):
    if "/" in text:
        p, q = text.split("/")
        return mpmath.mpf(p) / mpmath.mpf(q)
    return mpmath.mpf(text)


def values(text):
    return {k: t for k, t in (item.split("=") for item in text.split(","))}


def main(path):
    defaults = {"m": "1", "R": "1", "g": "1", "a3": "0.51", "I1": "1/3", "I3": "1/3"}
    rows = []
    for title, sets, at in CASES:
        p = {**defaults, **values(sets)}
        if title == "without weight":
            at = "gamma3=0.3,v_nu=0.7,omega3=1.1"
        if title == "steady precession":
            # omega_n^2 (I3 b - I1 R gamma3) = m g a3 R s^2 with I1 = I3 is omega_n^2 I1 a3 = m g a3 R s^2, so that
            # omega_n = s sqrt(3 g) is rational at g = 1/3, s = 4/5: exact in every arithmetic.
            sets = "g=1/3,a3=1/2,m=1,R=1,I1=1/3,I3=1/3"
            at = "gamma3=-3/5,omega_n=4/5,omega3=1/10"
            p = {**defaults, **values(sets)}
        x = {**{str(q): "0" for q in states}, **values(at)}
        numbers = [number(x[str(q)]) for q in states] + [number(p[str(q)]) for q in params]
        residual = [abs(mpmath.mpf(f)) for f in sp.lambdify(states + params, field, modules="mpmath")(*numbers)]
        assert max(residual) < mpmath.mpf(10) ** -100, (title, residual)
        a = evaluate(*numbers)
        scale = max(abs(q) for q in a) or mpmath.mpf(1)
        found = mpmath.eig(a / scale, left=False, right=False)
        eigenvalues = [mpmath.mpc(q) * scale for q in found]
        # 160 digits leave at least 30 of a defective eigenvalue of index 5: what is below is zero.
        drop = lambda part: part if abs(part) > mpmath.mpf(10) ** -130 * scale else mpmath.mpf(0)
        eigenvalues = [mpmath.mpc(drop(q.real), drop(q.imag)) for q in eigenvalues]
        trace = sum(a[i, i] for i in range(5))
        row = [title, sets, at, mpmath.nstr(trace, 50)]
        for q in sorted(eigenvalues, key=lambda q: (abs(q), q.imag)):
            row += [mpmath.nstr(q.real, 50), mpmath.nstr(q.imag, 50)]
        rows.append(row)
    with open(path, "w", encoding="ascii") as out:
        out.write("# written by generate_eigen.py; zeros first, then by magnitude\n")
        out.write("title;set;at;trace" + "".join(f";re{i};im{i}" for i in range(1, 6)) + "\n")
        for row in rows:
            out.write(";".join(row) + "\n")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "data/eigen.csv")
