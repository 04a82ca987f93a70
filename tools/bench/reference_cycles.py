"""Periodic orbits and their period doublings in quadruple precision, what tools/bench/questions holds its answers against.

usage: build/bench/bin/python tools/bench/reference_cycles.py > tests/reference/data/cycles.csv

heyoka's variational equations in real128 at 1e-32, Newton's method on the closed orbit in mpmath with 40 digits. The trivial multiplier, 1,
is a check that each row shows: twice for the top, whose energy is conserved. Five minutes."""
import heyoka as hy
import mpmath as mp
import numpy as np

mp.mp.dps = 40
quad = hy.real128


def roessler(c):
    x, y, z = hy.make_vars("x", "y", "z")
    return [(x, -y - z), (y, x + y / quad("5")), (z, quad("1") / quad("5") + z * (x - c))]


def lorenz(rho):
    x, y, z = hy.make_vars("x", "y", "z")
    return [(x, quad("10") * (y - x)), (y, x * (rho - z) - y), (z, x * y - quad("8") / quad("3") * z)]


def top(_):
    """(5.1) on the level G = -0.56: gamma3, v_nu, omega_tau, v_tau in physical time; m = R = g = 1."""
    gamma3, v, w, u = hy.make_vars("gamma3", "v", "w", "u")
    I, a3, G = quad("1") / quad("3"), quad("0.51"), quad("-0.56")
    s = hy.sqrt(1 - gamma3 * gamma3)
    b, e = a3 + gamma3, 1 + a3 * gamma3
    K = I * (s * s + b * b)
    theta, D, V = K + I * I, I + a3 * a3 * s * s, e * w + v
    n, three = (s * G + I * b * u) / K, (I * s * u - b * G) / K
    return [(gamma3, s * w), (v, n * u / s),
            (w, (a3 * s * s * (a3 * gamma3 * w * w - 1) - n * (I * gamma3 * n + I * s * three)) / D / s),
            (u, -n * v / s + I * (I * n * V / s + three * w * a3 * I) / theta)]


def energy_of_top(x):
    I, a3, G = mp.mpf(1) / 3, mp.mpf("0.51"), mp.mpf("-0.56")
    s2, b = 1 - x[0] ** 2, a3 + x[0]
    K = I * (s2 + b * b)
    n, three = (mp.sqrt(s2) * G + I * b * x[3]) / K, (I * mp.sqrt(s2) * x[3] - b * G) / K
    return (x[1] ** 2 + (I + a3 * a3 * s2) * x[2] ** 2 + I * n * n + I * three * three + x[3] ** 2) / 2 + a3 * x[0]


def flow(system, value, x, T):
    """The state at T, the matrix of its derivatives by the state, the field there."""
    n = len(x)
    field = system(quad(mp.nstr(value, 36)))
    pairs = [hy.expression(v) if isinstance(v, str) else v for v, _ in field]
    start = np.array([quad(mp.nstr(value, 36)) for value in x], dtype=quad)
    ta = hy.taylor_adaptive(hy.var_ode_sys(field, hy.var_args.vars, order=1), start, fp_type=quad, tol=quad("1e-32"))
    ta.propagate_until(quad(mp.nstr(T, 36)))
    state = [mp.mpf(str(value)) for value in ta.state]
    rate = hy.cfunc([f for _, f in field], pairs, fp_type=quad)(np.array([quad(mp.nstr(value, 36)) for value in state[:n]], dtype=quad))
    return state[:n], mp.matrix(n, n) + mp.matrix([state[n + n * i:2 * n + n * i] for i in range(n)]), [mp.mpf(str(f)) for f in rate]


def cycle(system, value, section, x, T, level=None):
    """Newton's method for (x, T): the orbit closes, meets the section, and lies on the level of energy."""
    n = len(x)
    for _ in range(20):
        end, M, rate = flow(system, value, x, T)
        rows = n + 1 + (level is not None)
        A, r = mp.zeros(rows, n + 1), mp.zeros(rows, 1)
        for i in range(n):
            r[i] = x[i] - end[i]
            A[i, n] = rate[i]
            for j in range(n):
                A[i, j] = M[i, j] - (i == j)
        A[n, section[0]], r[n] = 1, section[1] - x[section[0]]
        if level is not None:
            r[n + 1] = level - energy_of_top(x)
            for j in range(n):
                A[n + 1, j] = mp.diff(lambda t: energy_of_top([t if k == j else x[k] for k in range(n)]), x[j])
        step, _ = mp.qr_solve(A, r)
        x, T = [x[i] + step[i] for i in range(n)], T + step[n]
        if mp.norm(step) < mp.mpf(10) ** -28:
            break
    return x, T, flow(system, value, x, T)[1]


def row(name, system, value, section, x, T, level=None):
    x, T, M = cycle(system, value, section, x, T, level)
    values = sorted(mp.eig(M, left=False, right=False), key=lambda value: abs(value - 1))
    trivial, others = abs(values[0] - 1), values[1 if level is None else 2:]
    largest = max(others, key=abs)
    print(f"{name},{mp.nstr(level if level is not None else value, 30)},{mp.nstr(T, 30)},{mp.nstr(mp.re(largest), 30)},{mp.nstr(trivial, 2)}",
          flush=True)
    return x, T


def doubling(name, system, section, x, T, low, high, energy=False):
    """The value between low and high where the determinant of M + 1 changes sign, by the secant method."""
    def defect(value):
        nonlocal x, T
        x, T, M = cycle(system, value, section, x, T, value if energy else None)
        return mp.det(M + mp.eye(len(x)))
    a, b = mp.mpf(low), mp.mpf(high)
    fa, fb = defect(a), defect(b)
    while abs(b - a) > mp.mpf(10) ** -26:
        a, b, fa = b, b - fb * (b - a) / (fb - fa), fb
        fb = defect(b)
    row(name, system, b, section, x, T, b if energy else None)


print("# written by tools/bench/reference_cycles.py: heyoka " + hy.__version__ + ", real128, Newton's method in mpmath")
print("orbit,value,T,multiplier,trivial")
m = mp.mpf
row("roessler_c", roessler, m("3.5"), (1, m(0)), [m("6.128"), m(0), m("1.8589")], m("5.8041"))
doubling("roessler_doubling", roessler, (1, m(0)), [m("5.0"), m(0), m("1.62")], m("5.766"), "2.83", "2.835")
row("lorenz_rho", lorenz, m("16"), (2, m(20)), [m("11.885374853"), m("12.846575415"), m(20)], m("1.3024974742"))
x, T = [m("-0.6135843897066381"), m(0), m(0), m("1.5023231786")], m("3.8247750046438376")
doubling("top_doubling", top, (2, m(0)), x, T, "1.99", "1.981", energy=True)
row("top_E", top, m(0), (2, m(0)), x, T, m("1.9"))
