#!/usr/bin/env python3
"""Eigenvalues at equilibria in 60 digits, for test_eigen_digits.c: writes data/eigen_digits.csv.

Independent of everything here: the top's Jacobian is that of generate_eigen.py, those of the other systems are typed in below;
equilibria that are not rational are given by their formulas. Eigenvalues by mpmath with 900 digits: what is below 1e-200 of the
matrix is zero, and multiple eigenvalues keep more than 100 digits. Verdicts stand beside the cases, with their reasons. Needs
mpmath and sympy; the test needs only the file.
"""
import sys

import mpmath

import generate_eigen as top

mpmath.mp.dps = 900
mp = mpmath.mpf


def top_point(sets, at, precession=False):
    p = {**{"m": "1", "R": "1", "g": "1", "a3": "0.51", "I1": "1/3", "I3": "1/3"}, **top.values(sets)}
    x = {**{str(q): "0" for q in top.states}, **top.values(at)}
    p = {k: top.number(v) for k, v in p.items()}
    x = {k: top.number(v) for k, v in x.items()}
    if precession:  # steady motion of the paper: omega_n^2 (I3 b - I1 R gamma3) = m g a3 R s^2, R s omega3 = -b omega_n
        s2, b = 1 - x["gamma3"] ** 2, p["a3"] + p["R"] * x["gamma3"]
        x["omega_n"] = mpmath.sqrt(p["m"] * p["g"] * p["a3"] * p["R"] * s2 / (p["I3"] * b - p["I1"] * p["R"] * x["gamma3"]))
        x["omega3"] = -b * x["omega_n"] / (p["R"] * mpmath.sqrt(s2))
    return top.evaluate(*[x[str(q)] for q in top.states], *[p[str(q)] for q in top.params])


def lorenz(rho, x):
    sigma, beta = mp(10), mp(8) / 3
    z = rho - 1 if x else mp(0)
    return mpmath.matrix([[-sigma, sigma, 0], [rho - z, -1, -x], [x, x, -beta]])


def toda():
    """q_i'' = exp(q_(i-1) - q_i) - exp(q_i - q_(i+1)), three particles on a ring, at rest."""
    a = mpmath.zeros(6)
    for i in range(3):
        a[i, 3 + i] = 1
        a[3 + i, i] = -2
        a[3 + i, (i + 1) % 3] = a[3 + i, (i + 2) % 3] = 1
    return a


def triangular(mu):
    """Szebehely: at L4 U_xx = 3/4, U_xy = (3 sqrt(3)/4)(1 - 2 mu), U_yy = 9/4."""
    k = 3 * mpmath.sqrt(3) / 4 * (1 - 2 * mu)
    return mpmath.matrix([[0, 0, 1, 0], [0, 0, 0, 1], [mp(3) / 4, k, 0, 2], [k, mp(9) / 4, -2, 0]])


TOP = [
    # title, --set, --at, verdict: for a3 = 0 the nonzero pair solves (4.5), lambda^2 + p lambda + q = 0 with q > 0 where omega3
    # is not zero: p decides, which has the sign of gamma3 v_nu; zero is threefold, with E, G, F0.
    ("near the north pole", "a3=0", "gamma3=0.999999,v_nu=0.7,omega3=1.1", "stable"),
    ("near the south pole", "a3=0", "gamma3=-0.999999,v_nu=0.7,omega3=1.1", "unstable"),
    ("1e-12 from the pole", "a3=0", "gamma3=0.999999999999,v_nu=0.7,omega3=1.1", "stable"),
    ("on the equator: p = 0", "a3=0,I1=2/5", "gamma3=0,v_nu=0.7,omega3=1.1", "centre"),
    ("no slipping: p = 0", "a3=0,I1=2/5", "gamma3=0.3,v_nu=0,omega3=1.1", "centre"),
    ("1e-40 off the equator", "a3=0,I1=2/5", "gamma3=1e-40,v_nu=0.7,omega3=1.1", "stable"),
    ("no spin: q = 0, zero is defective", "a3=0,I1=2/5", "gamma3=0.3,v_nu=0.7,omega3=0", "unstable"),
    ("spin of 1e-60", "a3=0,I1=2/5", "gamma3=0.3,v_nu=0.7,omega3=1e-60", "stable"),
    # p^2 = 4 q: gamma3 = 3/5, s = 4/5, m = R = 1, I1 = I3 = 1/3: Theta = I1 (I1 + 1), p = gamma3 v/(s (I1 + 1)) = 9 v/16, q = w^2.
    ("a double eigenvalue", "a3=0", "gamma3=3/5,v_nu=32/9,omega3=1", "stable"),
    ("almost a double eigenvalue", "a3=0", "gamma3=3/5,v_nu=32/9,omega3=1.0000000000000000000000000000001", "stable"),
    ("no axial inertia", "a3=0,I3=0", "gamma3=0.3,v_nu=0.7,omega3=1.1", "unstable"),
    ("axial inertia of 1e-30", "a3=0,I3=1e-30", "gamma3=0.3,v_nu=0.7,omega3=1.1", "stable"),
    ("axial inertia of 1e-140", "a3=0,I3=1e-140", "gamma3=0.3,v_nu=0.7,omega3=1.1", "stable"),
    ("parameters to 1e150", "a3=0,m=1e150,R=1e-75,I1=1.5,I3=1.2", "gamma3=0.3,v_nu=1e-75,omega3=1.1", "stable"),
    ("parameters to 1e-150", "a3=0,m=1e-150,R=1e75,I1=1.5,I3=1.2", "gamma3=0.3,v_nu=1e75,omega3=1.1", "stable"),
    ("without weight", "g=0", "gamma3=0.3,v_nu=0.7,omega3=1.1", "stable"),
]


def cases():
    for title, sets, at, verdict in TOP:
        yield title, f"spherical_top --set {sets} --at {at}", verdict, top_point(sets, at)
    # Steady precession: the reversor leaves it where it is, so that eigenvalues come in pairs of either sign.
    for title, sets, at in (("precession, rational", "g=1/3,a3=1/2", "gamma3=-3/5,omega_n=4/5,omega3=1/10"),
                            ("precession", "", "gamma3=-0.6,omega_n=1"), ("precession of a rod", "I3=0", "gamma3=-0.6,omega_n=1")):
        options = (f"--set {sets} " if sets else "") + f"--at {at}" + ("" if "rational" in title else " --find")
        a = top_point(sets or "m=1", at, True)
        growth = max(z.real for z in eigenvalues(a))
        yield title, "spherical_top " + options, "unstable" if growth > 0 else "centre", a
    # Routh and Hurwitz: (sigma + 1 + beta) beta (sigma + rho) > 2 sigma beta (rho - 1) for rho below 470/19.
    yield "Lorenz, origin", "lorenz", "unstable", lorenz(mp(28), mp(0))
    yield "Lorenz, convection", "lorenz --at x=8,y=8 --find", "unstable", lorenz(mp(28), mpmath.sqrt(mp(72)))
    yield "Lorenz, steady convection", "lorenz --set rho=24 --at x=8,y=8 --find", "stable", lorenz(mp(24), mpmath.sqrt(mp(184) / 3))
    # The centre of mass moves on: growth that is linear in time. The rest are two pairs at sqrt(3) i.
    yield "Toda's ring at rest", "toda", "unstable", toda()
    # lambda^2 = -a c.
    yield "Lotka and Volterra", "lotka_volterra --set a=2/3,c=3/7", "centre", mpmath.matrix([[0, -mp(3) / 7], [mp(2) / 3, 0]])
    # Below Routh's critical ratio of 0.0385 L4 is a centre.
    yield "L4", "restricted_three_body", "centre", triangular(mp("0.012277471"))
    yield "L4 found", "restricted_three_body --at x=0.4877,y=0.866 --find", "centre", triangular(mp("0.012277471"))
    yield "L4 above the critical ratio", "restricted_three_body --set mu=1/20", "unstable", triangular(mp(1) / 20)


def eigenvalues(a):
    size = max(abs(q) for q in a)
    found = mpmath.eig(a / size, left=False, right=False)
    least = mp(10) ** -200
    values = []
    for z in map(mpmath.mpc, found):
        drop = lambda part: part if abs(part) > least * abs(z) else mp(0)
        values.append(mpmath.mpc(0) if abs(z) < least else mpmath.mpc(drop(z.real), drop(z.imag)) * size)
    return values


def main(path):
    with open(path, "w", encoding="ascii") as out:
        out.write("# written by generate_eigen_digits.py: title;options;verdict;re1;im1;re2;im2;...\n")
        for title, options, verdict, a in cases():
            row = [title, options, verdict]
            for z in sorted(eigenvalues(a), key=lambda z: (z.real, z.imag)):
                row += [mpmath.nstr(z.real, 60, strip_zeros=False), mpmath.nstr(z.imag, 60, strip_zeros=False)]
            out.write(";".join(row) + "\n")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "data/eigen_digits.csv")
