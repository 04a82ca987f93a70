"""Motions from a box that end at a pole: carried in a time that lifts the root which is 0 there, to a neighbourhood of equilibria
that attracts them."""
import re
from fractions import Fraction

from replay.balls import ONE, ball, exact, hull, meet, root, size
from replay.flow import Flow, must
from replay.series import CLOCK, Program
from replay.table import Table, Unserved


class LiftedTable(Table):
    """A table in a time tau that lifts its only root r: r and the table's time are states, and nothing is divided by r."""
    TIME = "time of the table"

    def __init__(self, text, time):
        record = re.search(r"^time +%s *: *(.*?) +lifting +(\w+) *$" % re.escape(time), text, re.M)
        if not record:
            raise Unserved("the table has no time %s that lifts one root" % time)
        self.lifted = record.group(2)
        super().__init__(text)
        factor, variable = self.parse(record.group(1)), self.names[self.lifted]
        half_rate = self.graph.times(self.graph.number(Fraction(1, 2)), self.along(self.radicand))  # of r^2, by t
        self.field = {state: self.cleared(self.graph.times(factor, rate)) for state, rate in self.field.items()}
        self.field[self.lifted] = self.cleared(self.graph.over(self.graph.times(factor, half_rate), variable))
        self.field[self.TIME] = self.cleared(factor)
        self.valids = {name: self.cleared(value) for name, value in self.valids.items()}
        self.domains = [self.cleared(value) for value in self.domains]
        self.states += [self.lifted, self.TIME]
        self.names[self.TIME] = self.graph.put("v", self.TIME)

    def root(self, name, radicand):
        if name != self.lifted:
            raise Unserved("the table has another root, " + name)
        self.radicand = radicand
        return self.graph.put("v", name)

    def rate(self, a):
        through = self.graph.over(self.graph.times(self.graph.partial(a, self.lifted), self.along(self.radicand)),
                                  self.graph.times(self.graph.number(2), self.names[self.lifted]))
        return self.graph.add(self.along(a), through)

    def along(self, a):
        """The rate of what does not contain r."""
        out = self.graph.number(0)
        for state, rate in self.field.items():
            out = self.graph.add(out, self.graph.times(self.graph.partial(a, state), rate))
        return out

    def cleared(self, a):
        """The same as r^k times an expression that is not divided by r; k < 0 is not served."""
        known = {}

        def shift(node, k):
            return self.graph.times(self.graph.power(self.names[self.lifted], k), node)

        def look(node):
            kind = self.graph.nodes[node]
            if kind == ("v", self.lifted):
                return 1, self.graph.number(1)
            if kind[0] in "nv":
                return 0, node
            (i, x), (j, y) = order(kind[1]), order(kind[2])
            if kind[0] == "+":
                if 0 in (self.graph.value(x), self.graph.value(y)):
                    return (j, y) if self.graph.value(x) == 0 else (i, x)
                return min(i, j), self.graph.add(shift(x, i - min(i, j)), shift(y, j - min(i, j)))
            return (i + j, self.graph.times(x, y)) if kind[0] == "*" else (i - j, self.graph.over(x, y))

        def order(node):
            if node not in known:
                known[node] = look(node)
            return known[node]

        k, rest = order(a)
        if k < 0 and self.graph.value(rest) != 0:
            raise Unserved("the time %s leaves divisions by its root" % self.TIME)
        return shift(rest, max(k, 0))

    def where(self, a, values):
        """The expression where the named states have these values."""
        known = {}

        def put(node):
            if node not in known:
                kind = self.graph.nodes[node]
                if kind[0] in "nv":
                    known[node] = self.graph.number(values[kind[1]]) if kind[0] == "v" and kind[1] in values else node
                else:
                    known[node] = {"+": self.graph.add, "*": self.graph.times, "/": self.graph.over}[kind[0]](*map(put, kind[1:]))
            return known[node]

        return put(a)

    def is_zero(self, a, values):
        return self.graph.value(self.where(a, values)) == 0


class Settling:
    """A neighbourhood in which the states p that vanish decay at a rate in the norm max |p_i|/w_i, and the others have room."""
    ATTEMPTS = 20

    def __init__(self, table, flow, x, vanishing):
        self.flow, self.x = flow, x
        self.p = [i for i, s in enumerate(table.states) if s in vanishing]
        self.lifted = table.states.index(table.lifted)
        fields = [table.field[s] for s in table.states]
        must(all(table.is_zero(f, dict.fromkeys(vanishing, 0)) for f in fields), "there are no equilibria where it settles")
        self.slopes = Program(table, [table.graph.partial(f, table.states[j]) for f in fields for j in self.p], flow.full.params)
        self.weights = [max(size(x[i]), 1) for i in self.p]

    def prove(self):
        """The limits, and the box in which all that still happens does."""
        room = [0] * len(self.x)
        for _ in range(self.ATTEMPTS):
            reach = max((size(self.x[i]) << 64) // w + 1 for i, w in zip(self.p, self.weights))  # |p(0)|, in 2^-64
            box = [(m, r + more) for (m, r), more in zip(self.x, room)]
            for i, w in zip(self.p, self.weights):
                edge = (reach * w >> 64) + 1
                box[i] = hull((0, 0), (edge, 0)) if i == self.lifted else (0, edge)
            must(self.flow.allowed(box), "where it settles is not shown to be in the table's domain")
            out = [s[0] for s in self.slopes.run(box, 1, 1)[1]]
            M = [out[i * len(self.p):(i + 1) * len(self.p)] for i in range(len(self.x))]
            moves = [[size(M[i][j]) for j in range(len(self.p))] for i in self.p]
            for k, i in enumerate(self.p):
                moves[k][k] = M[i][k][0] + M[i][k][1]
            change = [sum(a * w for a, w in zip(row, self.weights)) for row in moves]
            if not all(row[k] < 0 for k, row in enumerate(moves)):
                break
            if all(c < 0 for c in change):
                rate = min(-c // w for c, w in zip(change, self.weights))  # in 2^-P
                drift = [-(-sum(size(a) * w for a, w in zip(row, self.weights)) * reach // (max(rate, 1) << 64)) for row in M]
                if rate > 0 and all(i in self.p or d < room[i] for i, d in enumerate(drift)):
                    return [(0, 0) if i in self.p else (m, r + room[i]) for i, (m, r) in enumerate(self.x)], box
                room = [max(2 * d, more) + 1 for d, more in zip(drift, room)]
            else:  # nearer to where every row decays: one sweep of Jacobi's for moves w = -1
                scale = max(self.weights)
                self.weights = [max(1, (scale + sum(a * w for j, (a, w) in enumerate(zip(row, self.weights)) if j != k))
                                    // -row[k]) for k, row in enumerate(moves)]
        must(False, "the motions are not shown to settle")


def ends_of(value):
    middle, radius = (value["middle"], value["radius"]) if isinstance(value, dict) else (value, 0)
    return Fraction(middle) - Fraction(radius), Fraction(middle) + Fraction(radius)


def replay(certificate, text, read_ball):
    """In words, what was shown."""
    given, shown = certificate["given"], certificate["shown"]
    table = LiftedTable(text, given["time"])
    states, pole = table.states[:-2], given["pole"]
    must(sorted(given["parameters"]) == sorted(table.params), "its parameters are not the table's")
    must(sorted(given["box"]) == sorted(states), "its box is not of the table's states")
    must(sorted([pole, *shown["vanish"], *shown["limit"]]) == sorted(states), "its limits are not of the table's states")
    for name, sign in table.signs.items():
        low, high = ends_of(given["parameters"][name])
        must({">": low > 0, ">=": low >= 0, "!=": low > 0 or high < 0}[sign], name + " is outside the table's domain")
    must(pole in table.poles, "the table claims no pole " + pole)
    ends, sides = table.intervals.pop(pole), ends_of(given["box"][pole])
    must(ends[0] < sides[0] and sides[1] < ends[1], "it begins outside the interval of " + pole)
    must(table.is_zero(table.field[table.lifted], {table.lifted: 0}), "the lifted root may become 0")
    must(all(table.is_zero(table.radicand, {pole: end}) for end in ends), "the lifted root is not 0 at the pole")
    flow = Flow(table, {name: read_ball(value) for name, value in given["parameters"].items()})
    start = [read_ball(given["box"][s]) for s in states]
    square = Program(table, [table.radicand], flow.full.params).run(start + [exact(1), exact(0)], 1, 1)[1][0][0]
    instant = int(Fraction(given["instant"]) * 2 ** CLOCK)
    must(instant > 0, "it settles before it moves")
    x, _, _, least = flow.carry(start + [root(square), exact(0)], instant)
    limit, box = Settling(table, flow, x, {*shown["vanish"], table.lifted}).prove()
    for name, (low, high), (middle, radius) in zip(flow.valids, least, flow.values(box)[len(x) + len(x) ** 2 + 1:]):
        said = Fraction(shown["conditions"][name])
        must(said <= 0 or min(low, middle - radius) > 0, "the condition " + name + " is not shown to hold")
        must(said * ONE <= min(high, middle + radius), "the condition " + name + " has less than the bound that is said")
    at = states.index(pole)
    must([end for end in ends if meet(limit[at], ball(end))] == [Fraction(shown["end"])], "it is not shown to end there")
    for name, value in shown["limit"].items():
        must(meet(limit[states.index(name)], read_ball(value)), "the limit of %s is another one" % name)
    must(meet(limit[-1], read_ball(shown["time"])), "the time is another one")
    return "%s = %s after %.6g +- %.2g" % (pole, shown["end"], limit[-1][0] / ONE, limit[-1][1] / ONE)
