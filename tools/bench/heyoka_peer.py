"""The questions of `jellett bench` put to heyoka. Compilation is excluded from all times.

usage: heyoka_peer.py section REFERENCE.csv RETURNS REPEATS FORM DECADES
       heyoka_peer.py slope REFERENCE.csv REPEATS DECADES

DECADES: of the tolerance, as 5,6,7 for 1e-5, 1e-6, 1e-7. FORM: level, five, five_plain, level_t, five_t, as for peers.cpp. Two ways, in batches of 8: plain propagation, whose dense
output is searched for changes of sign of omega_tau and refined by Newton's method (the clock runs for the propagation alone, which
favours it), and heyoka's own events, with the state at each crossing taken from its dense output. Derivatives DP: heyoka's
variational equations. From one pass to the next its times vary by up to 40 %, so there are four times the repeats, each with a new integrator.
Output: the rows of `jellett bench`, without a header."""
import sys
import time

import heyoka as hy
import numpy as np

m = R = g = 1.0
I1 = I3 = 1 / 3
a3, E, G = 0.51, 2.15, -0.56
LANES, BUDGET = 8, 200000  # steps of one pass


def system(form):
    gamma3, v, w, wn, w3, u, lifted, t = hy.make_vars("gamma3", "v", "w", "wn", "w3", "u", "s", "t")

    def level(s):
        b, e = a3 + R * gamma3, R + a3 * gamma3
        K = I1 * R * R * s * s + I3 * b * b
        Theta, D, V = m * K + I1 * I3, I1 + m * a3 * a3 * s * s, e * w + v
        n, three = (R * s * G + I3 * b * u) / K, (I1 * R * s * u - b * G) / K
        return [(gamma3, s * s * w), (v, n * u),
                (w, (m * a3 * s * s * (a3 * gamma3 * w * w - g) - n * (I1 * gamma3 * n + I3 * s * three)) / D),
                (u, -n * v + I3 * (I1 * n * V - s * three * w * (R * gamma3 * (I1 - I3) - a3 * I3)) / Theta)]

    def five(s):
        b, e = a3 + R * gamma3, R + a3 * gamma3
        Theta, D, V = I1 * I3 + I1 * m * R * R * s * s + I3 * m * b * b, I1 + m * a3 * a3 * s * s, e * w + v
        return [(gamma3, s * s * w), (v, wn * (b * wn + R * s * w3)),
                (w, (m * a3 * s * s * (a3 * gamma3 * w * w - g) - wn * (I1 * gamma3 * wn + I3 * s * w3)) / D),
                (wn, gamma3 * wn * w - m * I3 * b * wn * V / Theta + s * I3 * w3 * w * (I3 + m * R * e) / Theta),
                (w3, s * (-m * R * I1 * wn * V + m * R * s * w3 * w * (R * gamma3 * (I1 - I3) - a3 * I3)) / Theta)]

    if form == "five_plain":
        root = hy.sqrt(1 - gamma3 * gamma3)
        return [(x, f / root) for x, f in five(root)]
    field = (level if form.startswith("level") else five)(lifted) + [(lifted, -gamma3 * lifted * w)]
    return field + [(t, lifted)] if form.endswith("_t") else field


def start(form, p):
    s = np.sqrt((1 - p[:, 0]) * (1 + p[:, 0]))
    zero = np.zeros(len(p))
    u = (a3 + R * p[:, 0]) * p[:, 2] + R * s * p[:, 3]
    states = [p[:, 0], p[:, 1], zero] + ([u] if form.startswith("level") else [p[:, 2], p[:, 3]])
    return np.array(states + ([] if form == "five_plain" else [s]) + ([zero] if form.endswith("_t") else []))


def five_states(form, x):
    """gamma3, v_nu, omega_tau, omega_n, omega3 from rows of states."""
    if not form.startswith("level"):
        return x[:5]
    s, b = x[4], a3 + R * x[0]
    K = I1 * R * R * s * s + I3 * b * b
    return np.array([x[0], x[1], x[2], (R * s * G + I3 * b * x[3]) / K, (I1 * R * s * x[3] - b * G) / K])


def integrals(x):
    s, b = np.sqrt((1 - x[0]) * (1 + x[0])), a3 + R * x[0]
    u = b * x[3] + R * s * x[4]
    energy = (m * x[1] ** 2 + (I1 + m * a3 * a3 * s * s) * x[2] ** 2 + I1 * x[3] ** 2 + I3 * x[4] ** 2 + m * u * u) / 2 + m * g * a3 * x[0]
    return np.array([energy, I1 * R * s * x[3] - I3 * b * x[4]])


def crossing(polynomials, h, before, after):
    """The zero of state 2 within a step, by Newton's method: its place and the states there."""
    polynomials = polynomials[:, ::-1]
    slope = np.polyder(polynomials[2])
    at = h * before / (before - after)
    for _ in range(8):
        at -= np.polyval(polynomials[2], at) / np.polyval(slope, at)
    return at, np.array([np.polyval(row, at) for row in polynomials])


class Outcome:
    def __init__(self):
        self.error = self.time_error = 0.0
        self.drift = np.zeros(2)
        self.returns = self.steps = self.failed = 0

    def compare(self, form, states, moment, expected):
        x = five_states(form, states)
        self.error = np.maximum(self.error, np.abs(x[[0, 1, 4]] - expected[[3, 4, 6]]).max())
        moment = states[-1] if form.endswith("_t") else moment if form == "five_plain" else np.nan
        self.time_error = np.maximum(self.time_error, abs(moment - expected[2]))

    def lose(self):
        self.error = self.time_error = np.nan

    def row(self, way, form, tolerance, seconds):
        unit = 1e6 / max(1, self.returns)
        values = [self.error, self.time_error, *self.drift]
        text = ",".join(f"{x:.3e}" if np.isfinite(x) else "" for x in values)
        print(f"heyoka,{way},{form},1,{tolerance:g},{text},{unit * np.median(seconds):.4g},{unit * min(seconds):.4g},"
              f"{unit * max(seconds):.4g},{self.steps / max(1, self.returns):.2f},{self.failed}", flush=True)


def clock(repeats, batches, body, renew=None):
    """Seconds of all batches, body(batch) giving those of one; a pass longer than half a second is not repeated."""
    seconds = []
    for _ in range(repeats):
        if renew is not None:
            renew()
        seconds.append(sum(body(batch) for batch in range(batches)))
        if seconds[-1] > 0.5:
            break
    return seconds


class Propagation:
    """Plain propagation over the span of time in which the returns are made."""
    name = "taylor x8"

    def __init__(self, form, tolerance, x0, reference):
        self.form, self.tolerance, self.x0, self.reference = form, tolerance, x0, reference
        self.kept, self.span = [], []
        self.renew()

    def build(self, **more):
        return hy.taylor_adaptive_batch(system(self.form), np.ascontiguousarray(self.x0[:, :LANES]), tol=self.tolerance, **more)

    def renew(self):
        """A new integrator in other memory; its code is compiled once."""
        self.integrator = self.build()
        self.kept.append(self.integrator)

    def reset(self, batch):
        self.integrator.set_time(0.0)
        self.integrator.state[:] = self.x0[:, LANES * batch:LANES * (batch + 1)]

    def first(self, outcome, batch, returns):
        """Step by step: counts returns, finds errors, and how far the batch must be propagated."""
        ta = self.integrator
        self.reset(batch)
        checked = self.reference.shape[1] - 1
        made, alive = np.zeros(LANES, int), np.ones(LANES, bool)
        origin = integrals(five_states(self.form, ta.state))
        for step in range(BUDGET):
            before, moment = ta.state[2].copy(), ta.time.copy()
            dense = bool((made[alive] < checked).any())
            ta.step(write_tc=dense)
            alive &= np.isfinite(ta.state).all(axis=0) & (ta.time > moment)
            hit = alive & (before < 0) & (ta.state[2] >= 0)
            if hit.any():
                drift = np.abs(integrals(five_states(self.form, ta.state)) - origin)
                outcome.drift = np.maximum(outcome.drift, drift[:, hit & (made < returns)].max(axis=1, initial=0))
            for lane in np.nonzero(hit)[0]:
                made[lane] += 1
                if made[lane] <= checked:
                    at, x = crossing(ta.tc[:, :, lane], ta.step_res[lane][1], before[lane], ta.state[2, lane])
                    outcome.compare(self.form, x, moment[lane] + at, self.reference[LANES * batch + lane, made[lane]])
            if not alive.any() or made[alive].min() >= returns:
                break
        outcome.failed += int((made < returns).sum())
        if (made < checked).any():
            outcome.lose()
        # All lanes are propagated to the time at which the slowest has made its returns; all that they make counts.
        outcome.returns += int(made.sum())
        outcome.steps += (step + 1) * LANES
        self.span.append(float(ta.time[alive].max()) if alive.any() else float(ta.time.max()))
        self.limit = step + 1

    def timed(self, batch):
        self.reset(batch)
        begin = time.process_time()
        self.integrator.propagate_until(self.span[batch], max_steps=BUDGET)
        return time.process_time() - begin


class Events(Propagation):
    """heyoka's own event detection; a crossing's state is taken from the dense output, in Python."""
    name = "taylor x8 events"

    def build(self):
        return super().build(nt_events=[hy.nt_event_batch(hy.make_vars("w"), self.call, direction=hy.event_direction.positive)])

    def __deepcopy__(self, memo):
        return self  # heyoka copies its callbacks

    def call(self, ta, moment, sign, lane):
        ta.update_d_output(np.full(LANES, moment))
        self.rows[lane].append((moment, ta.d_output[:, lane].copy()))

    def reset(self, batch):
        super().reset(batch)
        self.rows = [[] for _ in range(LANES)]

    def first(self, outcome, batch, returns):
        ta = self.integrator
        self.reset(batch)
        checked = self.reference.shape[1] - 1
        origin = integrals(five_states(self.form, ta.state))
        for step in range(BUDGET):
            moment = ta.time.copy()
            ta.step()
            alive = np.isfinite(ta.state).all(axis=0) & (ta.time > moment)
            made = np.array([len(rows) for rows in self.rows])
            if not alive.any() or made[alive].min() > returns:  # the start itself may count
                break
        for lane, rows in enumerate(self.rows):
            rows = [row for row in rows if row[0] > 1e-6]
            made[lane] = len(rows)
            for number, (moment, x) in enumerate(rows[:checked], 1):
                outcome.compare(self.form, x, moment, self.reference[LANES * batch + lane, number])
            if rows:
                states = five_states(self.form, np.array([x for _, x in rows[:returns]]).T)
                outcome.drift = np.maximum(outcome.drift, np.abs(integrals(states) - origin[:, lane:lane + 1]).max(axis=1))
        outcome.failed += int((made < returns).sum())
        if (made < checked).any():
            outcome.lose()
        outcome.returns += int(made.sum())
        outcome.steps += (step + 1) * LANES
        self.span.append(float(ta.time[alive].max()) if alive.any() else float(ta.time.max()))


def section(path, returns, repeats, form, decades):
    data = np.genfromtxt(path, delimiter=",", skip_header=1)
    reference = data.reshape(-1, int(data[:, 1].max()) + 1, 7)
    x0 = start(form, reference[:, 0, 3:7])
    batches = len(reference) // LANES
    for way in (Propagation, Events):
        for tolerance in decades:
            peer, outcome = way(form, tolerance, x0, reference), Outcome()
            for batch in range(batches):
                peer.first(outcome, batch, returns)
            outcome.row(way.name, form, tolerance, clock(4 * repeats, batches, peer.timed, peer.renew))


def lift(q):
    """The section on the level E: states of the level form, for real or complex q = (eta, gamma3)."""
    s, b = np.sqrt((1 - q[1]) * (1 + q[1])), a3 + R * q[1]
    K = I1 * R * R * s * s + I3 * b * b
    W = np.sqrt((2 * (E - m * g * a3 * q[1]) - G * G / K) / m)
    return np.array([q[1], W * np.sin(q[0]), 0 * s, W * np.sqrt(m * K / (m * K + I1 * I3)) * np.cos(q[0]), s])


def lower(x):
    b = a3 + R * x[0]
    K = I1 * R * R * x[4] * x[4] + I3 * b * b
    return np.array([np.arctan(x[1] / (x[3] / np.sqrt(m * K / (m * K + I1 * I3)))), x[0]])  # omega_tau's side of the section: |eta| < pi/2


def derivative(f, x, inputs):
    """Columns of df/dx by complex step."""
    columns = []
    for j in range(inputs):
        z = np.array(x, complex)
        z[j] += 1e-100j
        columns.append(f(z).imag / 1e-100)
    return np.array(columns).T


def variations(starts, returns, tolerance, repeats):
    """The derivative of the map's `returns`-th power at each of the starts, (eta, gamma3) by rows, by heyoka's variational equations in
    batches of 8, and the seconds of all, from the starts to beyond the last return."""
    field = system("level")
    rhs = hy.cfunc([f for _, f in field], [x for x, _ in field])
    x0 = np.concatenate([np.array([lift(q) for q in starts]).T, np.repeat(np.eye(5).reshape(25, 1), len(starts), axis=1)])
    ta = hy.taylor_adaptive_batch(hy.var_ode_sys(field, hy.var_args.vars, order=1), np.ascontiguousarray(x0[:, :LANES]), tol=tolerance)
    found, spans = [None] * len(starts), []

    def reset(batch):
        ta.set_time(0.0)
        ta.state[:] = x0[:, LANES * batch:LANES * (batch + 1)]

    for batch in range(len(starts) // LANES):
        reset(batch)
        made = np.zeros(LANES, int)
        while (made < returns).any():
            before = ta.state[2].copy()
            ta.step(write_tc=True)
            for lane in np.nonzero((before < 0) & (ta.state[2] >= 0))[0]:
                made[lane] += 1
                if made[lane] == returns:
                    _, x = crossing(ta.tc[:, :, lane], ta.step_res[lane][1], before[lane], ta.state[2, lane])
                    along = on_section(rhs, x[:5], x[5:].reshape(5, 5))
                    found[LANES * batch + lane] = derivative(lower, x[:5], 5) @ along @ derivative(lift, starts[LANES * batch + lane], 2)
        spans.append(float(ta.time.max()))

    def timed(batch):
        reset(batch)
        begin = time.process_time()
        ta.propagate_until(spans[batch])
        return time.process_time() - begin

    return found, clock(repeats, len(spans), timed)


def on_section(rhs, x, columns):
    """What a flow's tangent vectors, columns at x on the section, become along it."""
    f = rhs(x)
    return columns - np.outer(f, columns[2]) / f[2]


def slope(path, repeats, decades):
    data = np.genfromtxt(path, delimiter=",", skip_header=1)
    for tolerance in decades:
        found, seconds = variations(data[:, 1:3], 1, tolerance, repeats)
        error = 0.0
        for own, true in zip(found, data[:, 6:10].reshape(-1, 2, 2)):
            error = np.maximum(error, np.abs(own - true).max() / np.abs(true).max())
        unit = 1e6 / len(data)
        print(f"heyoka,taylor x8,variational,1,{tolerance:g},{error:.3e},{unit * np.median(seconds):.4g},{unit * min(seconds):.4g},"
              f"{unit * max(seconds):.4g},0", flush=True)


def main():
    words = sys.argv[1:]
    decades = [10.0 ** -int(k) for k in words[-1].split(",")] if len(words) > 3 else []
    if len(words) == 6 and words[0] == "section":
        section(words[1], int(words[2]), int(words[3]), words[4], decades)
    elif len(words) == 4 and words[0] == "slope":
        slope(words[1], int(words[2]), decades)
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
