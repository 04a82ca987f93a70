"""Polynomials of degree 3 in two variables with balls as coefficients, and their Taylor series along the motion of a table: what
the flow makes of all starts near one, cut off."""
from replay.balls import ONE, exact, inside, less, plus, product, quotient, root, size, sum_of
from replay.flow import Refused
from replay.series import CLOCK, Program, Series, convolve, per_step

DEGREE = 3
TERMS = [(d - k, k) for d in range(DEGREE + 1) for k in range(d + 1)]  # exponents, by degree
PAIRS = [[(s, t) for s, a in enumerate(TERMS) for t, b in enumerate(TERMS) if (a[0] + b[0], a[1] + b[1]) == c] for c in TERMS]
COUNT = len(TERMS)
ORDER = 18
REACH = 32             # rough enclosures are widened by remainders of this many steps
GOAL = ONE >> 44       # remainder of a step, of each coefficient
ZERO = (0, 0)


def constant(value):
    return [value] + [ZERO] * (COUNT - 1)


def variable(value, which):
    """value + the variable"""
    return [value] + [exact(int(which == t - 1)) for t in range(1, COUNT)]


def times(a, b):
    return [sum_of(product(a[s], b[t]) for s, t in pairs) for pairs in PAIRS]


def add(a, b):
    return [plus(x, y) for x, y in zip(a, b)]


def evaluate(polynomial, u, v):
    """polynomial(u, v) of polynomials u, v"""
    powers = {(0, 0): constant(exact(1))}
    for a, b in TERMS[1:]:
        powers[a, b] = times(powers[a - 1, b], u) if a else times(powers[a, b - 1], v)
    out = constant(ZERO)
    for coefficient, term in zip(polynomial, TERMS):
        out = add(out, [product(coefficient, x) for x in powers[term]])
    return out


class Jets(Program):
    """A program on polynomials: series by node, and by term of the polynomial."""

    def __init__(self, table, outputs, params):
        super().__init__(table, outputs, params)
        self.field = len(table.states)

    def run(self, x, step, count):
        states = self.table.states
        series = {node: [Series() for _ in TERMS] for node in self.order}
        paths = {name: [Series() for _ in TERMS] for name in states}
        for name, value in zip(states, x):
            for path, coefficient in zip(paths[name], value):
                path.append(coefficient)
        for node in self.order:
            kind = self.table.graph.nodes[node]
            if kind[0] == "v" and kind[1] in paths:
                series[node] = paths[kind[1]]
        fields = self.outputs[:self.field] if count > 1 else []
        for k in range(count):
            for node in self.order:
                if k == 0 or node in self.moving:
                    self.extend(series, node, k)
            for name, node in zip(states, fields):
                for path, rate in zip(paths[name], series[node]):
                    path.append(per_step(rate[k], k, step))
        return [paths[name] for name in states], [series[node] for node in self.outputs]

    @staticmethod
    def convolution(a, b, t, k):
        """Of the coefficient t, as far as both factors are known; that a sum of one unknown is left out is what solves for it."""
        return sum_of(convolve(a[s], b[r], max(0, k - len(b[r]) + 1), min(k, len(a[s]) - 1), k) for s, r in PAIRS[t])

    def extend(self, series, node, k):
        kind, out = self.table.graph.nodes[node], series[node]
        if kind[0] == "v":
            if kind[1] in self.params and k == 0:
                for s, value in zip(out, constant(self.params[kind[1]])):
                    s.append(value)
            return
        if kind[0] == "n":
            scalar = {node: Series()}
            super().extend(scalar, node, k)
            for s, value in zip(out, constant(scalar[node][0])):
                s.append(value)
            return
        a, b = series[kind[1]], series[kind[-1]]
        for t in range(COUNT):
            if kind[0] == "+":
                value = plus(a[t][k], b[t][k])
            elif kind[0] == "*":
                value = self.convolution(a, b, t, k)
            elif kind[0] == "/":
                value = quotient(less(a[t][k], self.convolution(b, out, t, k)), b[0][0])
            elif t == 0 and k == 0:
                value = root(a[0][0])
            else:
                value = quotient(less(a[t][k], self.convolution(out, out, t, k)), (2 * out[0].m[0], 2 * out[0].r[0]))
            out[t].append(value)

    def values(self, x):
        """Of the outputs, as polynomials."""
        return [[s[0] for s in node] for node in self.run(x, 1, 1)[1]]


def spread(series, count, remainder, at):
    """sum over k < count of series_k at^k + remainder at^count, of one coefficient"""
    out = remainder
    for k in range(count - 1, -1, -1):
        out = plus(product(out, at), series[k])
    return out


def carry(flow, jets, x, instant):
    """The polynomials x of all states after the time `instant`: Taylor's series in time, its remainder over a rough enclosure."""
    left, step = instant, 1 << (CLOCK - 4)
    whole = (ONE >> 1, ONE >> 1)
    while left > 0:
        step = min(step, left)
        try:
            hull = jets.run(x, step, ORDER)[0]
            y = [[spread(s, ORDER, ZERO, whole) for s in state] for state in hull]
            y = [[(m, r + REACH * GOAL) for m, r in state] for state in y]
            rough = jets.run(y, step, ORDER)[0]
            last = [[s[ORDER] for s in state] for state in rough]
            z = [[spread(s, ORDER, e, whole) for s, e in zip(state, end)] for state, end in zip(hull, last)]
            good = (all(inside(a, b) for p, q in zip(z, y) for a, b in zip(p, q)) and flow.allowed([state[0] for state in y])
                    and max(size(e) for end in last for e in end) <= GOAL)
        except ArithmeticError:
            good = False
        if good:
            x = [[plus(sum_of(s[k] for k in range(ORDER)), e) for s, e in zip(state, end)] for state, end in zip(hull, last)]
            left -= step
            step = step * 9 >> 3
        else:
            step = step * 3 >> 2
            if step < 1 << (CLOCK - 30):
                raise Refused("no step can be validated")
    return x
