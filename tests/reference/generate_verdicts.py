#!/usr/bin/env python3
"""Verdicts at random equilibria of random tops, for test_verdicts.c: writes data/verdicts.csv.

The field and its Jacobian are those of generate_eigen.py, here at rational points with a rational root s, so that matrix,
characteristic polynomial and ranks are exact. The field must vanish exactly. Verdicts: eigenvalues with 400 digits; what is below
1e-200 of its eigenvalue is zero; zero and multiple eigenvalues are judged by exact ranks. Needs sympy and mpmath.
"""
import random
import sys
from fractions import Fraction as Q

import mpmath
import sympy as sp

import generate_eigen as top

mpmath.mp.dps = 400
random.seed(5)
root = sp.Symbol("s")
evaluate_field = sp.lambdify(top.states + top.params + (root,), [f.subs(top.s, root) for f in top.field])
# By the chain rule, d s / d gamma3 = -gamma3 / s.
chain = [sp.diff(f.subs(top.s, root), q) + (sp.diff(f.subs(top.s, root), root) * (-top.c / root) if q == top.c else 0)
         for f in top.field for q in top.states]
evaluate_matrix = sp.lambdify(top.states + top.params + (root,), chain)


def magnitude(low, high, digits=4):
    """A positive rational of a few digits, its logarithm even between powers of ten."""
    exponent = random.uniform(low, high)
    return Q(round(10 ** (digits + exponent % 1)), 10**digits) * Q(10) ** int(exponent // 1)


def sign():
    return random.choice((-1, 1))


def axis(kind):
    """gamma3 and s, rational: cos and sin of twice the angle with tangent k, as near to a pole as 1e-7 for kind 0."""
    k = magnitude(-4, -1) if kind == 0 else magnitude(-1, 1)
    return sign() * (1 - k * k) / (1 + k * k), 2 * k / (1 + k * k)


def draw(family, kind):
    m, R, I1 = magnitude(-1, 1), magnitude(-1, 1), magnitude(-2, 1)
    I3 = I1 * random.choice((magnitude(-6, -3), magnitude(-1, 0), Q(1), magnitude(0, 0.3),
                             Q(0) if family != "precession" else Q(1, 7)))
    c, s = axis(kind)
    wn = wt = v = w3 = Q(0)
    g, a3 = magnitude(-1, 2), sign() * R * magnitude(-2, 0.5)
    if family == "precession":
        wn = sign() * magnitude(-1, 1)
        b = a3 + R * c
        w3 = -b * wn / (R * s)
        g = wn**2 * (I3 * b - I1 * R * c) / (m * a3 * R * s**2)
    else:
        a3, g = (Q(0), g) if family == "spin" else (a3, Q(0))
        v = random.choice((Q(0), sign() * magnitude(-2, 1), sign() * magnitude(-1, 1)))
        w3 = random.choice((Q(0), sign() * magnitude(-9, -3), sign() * magnitude(-1, 1), sign() * magnitude(-1, 1)))
    return (c, v, wt, wn, w3), (m, R, g, a3, I1, I3), s


def rational(value):
    return sp.Rational(value.numerator, value.denominator)


def judge(a):
    """stable, unstable or centre; the eigenvalues in 50 digits."""
    x = sp.Symbol("x")
    factors = sp.factor_list(sp.Poly(a.charpoly(x).as_expr(), x))[1]
    found, moves, negative, grows = [], False, True, False
    for factor, multiplicity in factors:
        degree = factor.degree()
        coefficients = [mpmath.mpf(int(q.p)) / int(q.q) for q in factor.all_coeffs()]
        if degree == 1:
            roots = [-coefficients[1] / coefficients[0]]
        else:
            roots = mpmath.polyroots(coefficients, maxsteps=2000, extraprec=8000)
        semisimple = multiplicity == 1 or power(factor, a, 1).rank() == power(factor, a, 2).rank()
        for z in map(mpmath.mpc, roots):
            if abs(z.real) < mpmath.mpf(10) ** -200 * abs(z):
                z = mpmath.mpc(0, z.imag)
            if abs(z.imag) < mpmath.mpf(10) ** -200 * abs(z):
                z = mpmath.mpc(z.real, 0)
            found += multiplicity * [z]
            grows = grows or z.real > 0 or (z.real == 0 and not semisimple)
            if z != 0:
                moves = True
                negative = negative and z.real < 0
    verdict = "unstable" if grows else "stable" if moves and negative else "centre"
    return verdict, sorted(found, key=lambda z: (abs(z), z.imag))


def power(factor, a, k):
    value = sp.zeros(5, 5)
    for q in factor.all_coeffs():
        value = value * a + q * sp.eye(5)
    return value**k


def main(path):
    rows, counts = [], {}
    for family, count in (("precession", 300), ("spin", 80), ("spin_weightless", 80)):
        made = 0
        while made < count:
            states, params, s = draw(family, made % 3 % 2)
            if params[2] < 0:
                continue
            numbers = [rational(q) for q in states + params + (s,)]
            assert all(sp.Rational(f) == 0 for f in evaluate_field(*numbers)), (family, states, params)
            a = sp.Matrix(5, 5, [sp.Rational(q) for q in evaluate_matrix(*numbers)])
            verdict, eigenvalues = judge(a)
            names = lambda symbols, values: ",".join(f"{n}={v}" for n, v in zip(symbols, values)
                                                     if v != 0 or str(n) in ("g", "a3", "I3"))
            row = [family, names(top.params, params), names(top.states, states), verdict]
            for z in eigenvalues:
                row += [mpmath.nstr(z.real, 20), mpmath.nstr(z.imag, 20)]
            rows.append(row)
            counts[family, verdict] = counts.get((family, verdict), 0) + 1
            made += 1
    print(counts)
    with open(path, "w", encoding="ascii") as out:
        out.write("# written by generate_verdicts.py; zeros first, then by magnitude\n")
        out.write("family;set;at;verdict" + "".join(f";re{i};im{i}" for i in range(1, 6)) + "\n")
        for row in rows:
            out.write(";".join(row) + "\n")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "data/verdicts.csv")
