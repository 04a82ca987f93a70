"""The section map of `jellett bench` by heyoka, in batches of 8: propagation over a fixed time, whose dense output is searched for
changes of sign of omega_tau and refined by Newton's method on the polynomials; the clock runs for the propagation alone, which
favours it. Compilation is excluded.

usage: section_heyoka.py REFERENCE.csv RETURNS REPEATS; output: the rows of `jellett bench`, without a header."""
import sys
import time

import heyoka as hy
import numpy as np

m = R = g = 1.0
I1 = I3 = 1 / 3
a3, G = 0.51, -0.56


def forms():
    gamma3, v, w, wn, w3, u, lifted = hy.make_vars("gamma3", "v", "w", "wn", "w3", "u", "s")

    def level(s):
        b, e = a3 + R * gamma3, R + a3 * gamma3
        K = I1 * R * R * s * s + I3 * b * b
        Theta, D, V = m * K + I1 * I3, I1 + m * a3 * a3 * s * s, e * w + v
        n, three = (R * s * G + I3 * b * u) / K, (I1 * R * s * u - b * G) / K
        return [(gamma3, s * s * w), (v, n * u),
                (w, (m * a3 * s * s * (a3 * gamma3 * w * w - g) - n * (I1 * gamma3 * n + I3 * s * three)) / D),
                (u, -n * v + I3 * (I1 * n * V - s * three * w * (R * gamma3 * (I1 - I3) - a3 * I3)) / Theta)]

    def reduced(s):
        b, e = a3 + R * gamma3, R + a3 * gamma3
        Theta, D, V = I1 * I3 + I1 * m * R * R * s * s + I3 * m * b * b, I1 + m * a3 * a3 * s * s, e * w + v
        return [(gamma3, s * s * w), (v, wn * (b * wn + R * s * w3)),
                (w, (m * a3 * s * s * (a3 * gamma3 * w * w - g) - wn * (I1 * gamma3 * wn + I3 * s * w3)) / D),
                (wn, gamma3 * wn * w - m * I3 * b * wn * V / Theta + s * I3 * w3 * w * (I3 + m * R * e) / Theta),
                (w3, s * (-m * R * I1 * wn * V + m * R * s * w3 * w * (R * gamma3 * (I1 - I3) - a3 * I3)) / Theta)]

    root = hy.sqrt(1 - gamma3 * gamma3)
    lift = [(lifted, -gamma3 * lifted * w)]
    return {"level": level(lifted) + lift, "level_plain": [(x, f / root) for x, f in level(root)],
            "regular": reduced(lifted) + lift, "plain": [(x, f / root) for x, f in reduced(root)]}


def start(form, p):
    s = np.sqrt((1 - p[:, 0]) * (1 + p[:, 0]))
    zero = np.zeros(len(p))
    u = (a3 + R * p[:, 0]) * p[:, 2] + R * s * p[:, 3]
    states = [p[:, 0], p[:, 1], zero, u] if form.startswith("level") else [p[:, 0], p[:, 1], zero, p[:, 2], p[:, 3]]
    return np.array(states + ([s] if form in ("level", "regular") else []))


def omega3(form, x):
    if not form.startswith("level"):
        return x[4]
    s = x[4] if form == "level" else np.sqrt((1 - x[0]) * (1 + x[0]))
    b = a3 + R * x[0]
    return (I1 * R * s * x[3] - b * G) / (I1 * R * R * s * s + I3 * b * b)


def crossings(coefficients, steps, wanted):
    """First `wanted` upward zeros of state 2: coefficients (steps, states, order + 1) of one orbit, step lengths."""
    w0 = coefficients[:, 2, 0]
    w1 = np.append(w0[1:], np.nan)
    found = []
    for k in np.nonzero((w0 < 0) & (w1 >= 0))[0][:wanted]:
        polynomial = coefficients[k][:, ::-1]
        slope = np.polyder(polynomial[2])
        h = steps[k] * w0[k] / (w0[k] - w1[k])
        for _ in range(8):
            h -= np.polyval(polynomial[2], h) / np.polyval(slope, h)
        found.append([np.polyval(row, h) for row in polynomial])
    return found


def main():
    path, returns, repeats = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    data = np.genfromtxt(path, delimiter=",", skip_header=1)
    first = data[data[:, 1] == 0]
    checked = int(data[:, 1].max())
    points, expected = first[:, 3:7], data[data[:, 1] > 0].reshape(len(first), checked, 7)[:, :, 3:7]
    for form, system in forms().items():
        # Time of so many returns, from the reference; regularised time runs slower by the mean of 1/s, taken as measured.
        span = data[data[:, 1] == checked][:, 2].max() / checked
        for decade in range(-5, -16, -1):
            tolerance = 10.0 ** decade
            x0 = start(form, points)
            integrator = hy.taylor_adaptive_batch(system, np.ascontiguousarray(x0[:, :8]), tol=tolerance)
            scale = 1.9 if form in ("level", "regular") else 1.05

            def reset(batch):
                integrator.set_time(0.0)
                integrator.state[:] = x0[:, 8 * batch:8 * batch + 8]

            # Errors, from the dense output of the first returns.
            worst, length, made = 0.0, scale * span * (checked + 1), []
            for batch in range(len(points) // 8):
                reset(batch)
                rows, lengths = [], []
                while integrator.time.min() < length:
                    integrator.step(write_tc=True)
                    rows.append(integrator.tc.copy())
                    lengths.append([outcome[1] for outcome in integrator.step_res])
                rows, lengths = np.array(rows), np.array(lengths)
                for lane in range(8):
                    found = crossings(rows[:, :, :, lane], lengths[:, lane], checked)
                    if len(found) < checked:
                        worst = np.nan
                        continue
                    x = np.array(found).T
                    off = np.array([x[0], x[1], omega3(form, x)]) - expected[8 * batch + lane][:, [0, 1, 3]].T
                    worst = np.fmax(worst, np.abs(off).max()) if np.isfinite(worst) else worst
                w = rows[:, 2, 0, :]
                made.append(((w[:-1] < 0) & (w[1:] >= 0)).sum() / lengths.sum())
            rate = np.mean(made)  # returns for each unit of the form's time, of one lane
            seconds = []
            for k in range(repeats + 1):
                total = 0.0
                for batch in range(len(points) // 8):
                    reset(batch)
                    begin = time.perf_counter()
                    integrator.propagate_until(returns / rate)
                    total += time.perf_counter() - begin
                if k > 0:
                    seconds.append(total)
            count = returns * len(points)
            steps = np.mean([outcome[3] for outcome in integrator.propagate_res]) / returns
            error = f"{worst:.3e}" if np.isfinite(worst) else ""
            print(f"peer,heyoka x8,{form},1,{tolerance:g},{error},{count / np.median(seconds):.0f},"
                  f"{count / max(seconds):.0f},{count / min(seconds):.0f},{steps:.2f},0", flush=True)


main()
