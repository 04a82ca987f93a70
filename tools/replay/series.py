"""Taylor series of balls along the motion of a table, in units of the step: coefficient k carries h^k."""
from operator import mul

from replay.balls import P, ball, less, plus, product, quotient, root

CLOCK = 64  # times are multiples of 2^-CLOCK


class Series:
    """A growing power series of balls: middles, radii, and absolute values of middles, apart. That of a number ends with
    order 0."""
    __slots__ = ("m", "r", "a")

    def __init__(self):
        self.m, self.r, self.a = [], [], []

    def append(self, value):
        self.m.append(value[0])
        self.r.append(value[1])
        self.a.append(abs(value[0]))

    def __getitem__(self, k):
        return (self.m[k], self.r[k]) if k < len(self.m) else (0, 0)

    def __len__(self):
        return len(self.m)


def convolve(a, b, low, high, k):
    """sum over j = low .. high of a_j b_(k-j)"""
    if high < low:
        return (0, 0)
    stop = k - high - 1
    other = slice(k - low, stop if stop >= 0 else None, -1)
    middle = sum(map(mul, a.m[low:high + 1], b.m[other]))
    back, wide = b.r[other], a.r[low:high + 1]
    radius = sum(map(mul, a.a[low:high + 1], back)) + sum(map(mul, wide, b.a[other])) + sum(map(mul, wide, back))
    return (middle >> P, (radius >> P) + 2)


def per_step(a, k, step):
    """a h/(k + 1)"""
    return (a[0] * step // (k + 1) >> CLOCK, (a[1] * step // (k + 1) >> CLOCK) + 4)


class Program:
    """Outputs as series along the motion; which, in the order of the parts they need."""

    def __init__(self, table, outputs, params):
        self.table, self.outputs, self.params = table, outputs, params
        nodes, seen, self.order = table.graph.nodes, set(), []
        for start in outputs:
            stack = [(start, False)]
            while stack:
                node, ready = stack.pop()
                if ready:
                    self.order.append(node)
                elif node not in seen:
                    seen.add(node)
                    stack.append((node, True))
                    stack += [(part, False) for part in nodes[node][1:] if nodes[node][0] not in "nv"]
        self.moving = set()
        for node in self.order:
            kind = nodes[node]
            if (kind[0] == "v" and kind[1] in table.states) or (kind[0] not in "nv" and any(p in self.moving for p in kind[1:])):
                self.moving.add(node)

    def run(self, x, step, count):
        """Series of states (count + 1 coefficients) and outputs (count), over the balls x, in units of the step;
        count 1 is values."""
        nodes, states = self.table.graph.nodes, self.table.states
        series = {node: Series() for node in self.order}
        paths = {name: Series() for name in states}
        for name, value in zip(states, x):
            paths[name].append(value)
        for node in self.order:
            if nodes[node][0] == "v" and nodes[node][1] in paths:
                series[node] = paths[nodes[node][1]]
        fields = self.outputs[:len(states)] if count > 1 else []  # values alone need no motion
        for k in range(count):
            for node in self.order:
                if k == 0 or node in self.moving:
                    self.extend(series, node, k)
            for name, node in zip(states, fields):
                paths[name].append(per_step(series[node][k], k, step))
        return [paths[name] for name in states], [series[node] for node in self.outputs]

    def extend(self, series, node, k):
        kind = self.table.graph.nodes[node]
        out = series[node]
        if kind[0] == "v":
            if kind[1] in self.params and k == 0:
                out.append(self.params[kind[1]])
            return
        if kind[0] == "n":
            out.append(ball(kind[1]))
            return
        a = series[kind[1]]
        if kind[0] == "r":
            if k == 0:
                out.append(root(a[0]))
            else:
                rest = less(a[k], convolve(out, out, 1, k - 1, k))
                out.append(quotient(rest, (2 * out.m[0], 2 * out.r[0])))
            return
        b = series[kind[2]]
        if kind[0] == "+":
            out.append(plus(a[k], b[k]))
        elif kind[0] == "*":
            low, high = max(0, k - len(b) + 1), min(k, len(a) - 1)
            out.append(convolve(a, b, low, high, k))
        else:
            high = min(k, len(b) - 1)
            out.append(quotient(less(a[k], convolve(b, out, 1, high, k)), b[0]))
