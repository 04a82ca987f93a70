"""Sets carried along by a table's flow, to a section: x + C r0 + Q r, with the derivative V + B R (R. J. Lohner 1988;
P. Zgliczynski 2002)."""
from replay.balls import (ONE, P, axes_of, ball, exact, exponential, inside, less, matadd, matmul, norm, plus, product, quotient,
                          size, split, sum_of, unit)
from replay.series import CLOCK, Program, Series, convolve, per_step

ORDER = 24
GOAL = 1 << (P - 72)  # remainder of a step


class Refused(Exception):
    """The certificate is not shown to be right."""


def must(holds, what):
    if not holds:
        raise Refused(what)


def lower(bounds, value):
    """Bounds of a least value, low and high, where there is one more; None: there was none before."""
    here = (value[0] - value[1], value[0] + value[1])
    return here if bounds is None else tuple(map(min, bounds, here))


class Flow:
    def __init__(self, table, params):
        self.table, self.n = table, len(table.states)
        graph, f = table.graph, [table.field[s] for s in table.states]
        slopes = [graph.partial(a, s) for a in f for s in table.states]
        divergence = graph.number(0)
        for a, s in zip(f, table.states):
            divergence = graph.add(divergence, graph.partial(a, s))
        self.valids = sorted(table.valids)
        self.point = Program(table, f, params)
        self.walls = Program(table, table.domains, params)
        self.full = Program(table, f + slopes + [divergence] + [table.valids[v] for v in self.valids], params)
        self.step = 1 << (CLOCK - 5)

    def vary(self, slopes, count):
        """Series of V in V' = Df V, V(0) = 1, in units of the step."""
        n = self.n
        V = [[Series() for _ in range(n)] for _ in range(n)]
        for i in range(n):
            for j in range(n):
                V[i][j].append(exact(int(i == j)))
        for k in range(count):
            rows = [[sum_of(self.part(slopes[i * n + m], V[m][j], k) for m in range(n)) for j in range(n)] for i in range(n)]
            for i in range(n):
                for j in range(n):
                    V[i][j].append(per_step(rows[i][j], k, self.step))
        return V

    @staticmethod
    def part(a, b, k):
        return convolve(a, b, max(0, k - len(b) + 1), min(k, len(a) - 1), k)

    def spread(self, series, count, remainder, at):
        """sum over k < count of series_k at^k + remainder at^count"""
        out = remainder
        for k in range(count - 1, -1, -1):
            out = product(out, at)
            out = plus(out, series[k])
        return out

    def enclose(self, x):
        """Series over the set, and over a rough enclosure of it during the step, which is shortened until it is one."""
        whole = (ONE >> 1, ONE >> 1)
        while self.step >> (CLOCK - 30):
            try:
                hull_x, hull_out = self.full.run(x, self.step, ORDER)
                y = [self.spread(s, ORDER, (0, 0), whole) for s in hull_x]
                y = [(m, r + 64 * GOAL) for m, r in y]
                rough_x, rough_out = self.full.run(y, self.step, ORDER)
                z = [self.spread(s, ORDER, r[ORDER], whole) for s, r in zip(hull_x, rough_x)]
                if all(map(inside, z, y)) and max(size(r[ORDER]) for r in rough_x) <= GOAL and self.allowed(y):
                    return hull_x, hull_out, rough_x, rough_out
            except ArithmeticError:
                pass
            self.step = self.step * 3 >> 2
        raise Refused("no step can be validated")

    def allowed(self, y):
        for name, value in zip(self.table.states, y):
            if name in self.table.intervals:
                low, high = self.table.intervals[name]
                if ball(low)[0] + 2 >= value[0] - value[1] or ball(high)[0] - 2 <= value[0] + value[1]:
                    return False
        return all(wall[0][0] > wall[0][1] for wall in self.walls.run(y, 1, 1)[1])

    def carry(self, x, instant):
        """The set x, its derivative, the integral of the divergence and bounds of the least values of the conditions, after the
        time `instant`."""
        n, left = self.n, instant
        center, box = [[(a[0], 0)] for a in x], [[(0, a[1])] for a in x]
        C, Q, V, B = unit(n), unit(n), unit(n), unit(n)
        r, R = [[(0, 0)] for _ in range(n)], [[(0, 0)] * n for _ in range(n)]
        expansion, least = (0, 0), [None] * len(self.valids)
        while left > 0:
            self.step = min(self.step * 11 // 10, left)
            hull_set = [row[0] for row in matadd(center, matadd(matmul(C, box), matmul(Q, r)))]
            hull_x, hull_out, rough_x, rough_out = self.enclose(hull_set)
            left -= self.step
            S, W = self.vary(hull_out[n:n + n * n], ORDER), self.vary(rough_out[n:n + n * n], ORDER)
            A = [[sum_of(S[i][j][k] for k in range(ORDER)) for j in range(n)] for i in range(n)]
            bound = norm([[rough_out[n + i * n + j][0] for j in range(n)] for i in range(n)]) * self.step >> CLOCK
            growth = exponential((0, bound + 1))
            growth = growth[0] + growth[1] - ONE
            around = [[(m, growth) for m, _ in row] for row in unit(n)]
            D = matadd(A, matmul([[W[i][j][ORDER] for j in range(n)] for i in range(n)], around))
            points, _ = self.point.run([row[0] for row in center], self.step, ORDER)
            image = [[plus(sum_of(s[k] for k in range(ORDER)), rx[ORDER])] for s, rx in zip(points, rough_x)]
            center, more = split(image)
            C, rest = split(matmul(A, C))
            more = matadd(more, matmul(rest, box))
            Q, r = self.turn(A, Q, r, more)
            V, more = split(matmul(D, V))
            B, R = self.turn(D, B, R, more)
            d, last = hull_out[n + n * n], rough_out[n + n * n]
            for k in range(ORDER - 1):
                expansion = plus(expansion, per_step(d[k], k, self.step))
            expansion = plus(expansion, per_step(last[ORDER - 1], ORDER - 1, self.step))
            for i in range(len(self.valids)):
                for piece in range(16):
                    value = self.spread(hull_out[n + n * n + 1 + i], ORDER - 1, rough_out[n + n * n + 1 + i][ORDER - 1],
                                        ((2 * piece + 1) * ONE >> 5, ONE >> 5))
                    least[i] = lower(least[i], value)
        hull_set = [row[0] for row in matadd(center, matadd(matmul(C, box), matmul(Q, r)))]
        return hull_set, matadd(V, matmul(B, R)), expansion, least

    @staticmethod
    def turn(A, axes, rest, more):
        moved = matmul(A, axes)
        weights = [max(size(a) for a in row) for row in rest]
        new, inverse = axes_of(moved, weights)
        return new, matadd(matmul(matmul(inverse, moved), rest), matmul(inverse, more))

    def values(self, x):
        return [s[0] for s in self.full.run(x, 1, 1)[1]]

    def arrive(self, x, instant, column, level, direction):
        """On the section: state, derivative, time after `instant`, integral of the divergence, bounds of the conditions; the time
        around `instant` in which each start crosses once."""
        n = self.n
        x, V, expansion, least = self.carry(x, instant)
        out = self.values(x)
        tau = quotient(less(level, x[column]), out[column])
        span = (0, 2 * size(tau) + 1)
        y = [plus(a, (0, 2 * size(product(f, span)) + (a[1] >> 10) + 1)) for a, f in zip(x, out)]
        out = self.values(y)
        if not all(inside(plus(a, product(f, span)), b) for a, f, b in zip(x, out, y)) or not self.allowed(y):
            raise Refused("the crossing of the section is not enclosed")
        if out[column][0] * direction <= out[column][1]:
            raise Refused("the section may be met tangentially, or from the other side")
        tau = quotient(less(level, x[column]), out[column])
        if size(tau) > span[1]:
            raise Refused("the crossing of the section is not enclosed")
        slopes = [out[n + i * n:n + (i + 1) * n] for i in range(n)]
        growth = exponential((0, (norm(slopes) * size(tau) >> P) + 1))
        around = [[(m, growth[0] + growth[1] - ONE) for m, _ in row] for row in unit(n)]
        step = matadd(unit(n), [[product(tau, a) for a in row] for row in matmul(slopes, around)])
        V = matmul(step, V)
        D = [[less(V[i][j], product(quotient(out[i], out[column]), V[column][j])) for j in range(n)] for i in range(n)]
        state = [plus(a, product(f, tau)) for a, f in zip(x, out)]
        least = [lower(bounds, v) for bounds, v in zip(least, out[n + n * n + 1:])]
        return state, D, tau, plus(expansion, product(tau, out[n + n * n])), least, span
