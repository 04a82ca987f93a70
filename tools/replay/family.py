"""The trace of the linearization along a family of equilibria over a box: intervals (low, high) with rational ends, halves of the
longest side until the table's expressions say what the certificate says."""
from fractions import Fraction
from itertools import islice, product as choices
from math import isqrt

from replay.flow import must
from replay.table import Unserved

P = 160          # bits after the point, where ends are rounded
BOXES_MAX, CORNERS_MAX = 5000, 256


def rounded(a):
    """Outwards, where fractions have grown long."""
    low, high = a
    if low.denominator.bit_length() > P:
        low = Fraction((low.numerator << P) // low.denominator, 1 << P)
    if high.denominator.bit_length() > P:
        high = Fraction(-((-high.numerator << P) // high.denominator), 1 << P)
    return low, high


def root(a):
    if a[0] < 0:
        raise ArithmeticError("root of what may be negative")
    low, high = isqrt((a[0].numerator << 2 * P) // a[0].denominator), isqrt((a[1].numerator << 2 * P) // a[1].denominator) + 1
    return Fraction(low, 1 << P), Fraction(high, 1 << P)


def product(a, b):
    ends = [x * y for x in a for y in b]
    return rounded((min(ends), max(ends)))


def square(a):
    low, high = sorted((a[0] * a[0], a[1] * a[1]))
    return rounded((Fraction(0) if a[0] < 0 < a[1] else low, high))


def inverse(a):
    if a[0] <= 0 <= a[1]:
        raise ArithmeticError("division by what may be 0")
    return rounded((1 / a[1], 1 / a[0]))


class Family:
    def __init__(self, table, name):
        self.table, self.graph = table, table.graph
        if name not in table.families:
            raise Unserved("the table has no family " + name)
        self.given = table.families[name]
        self.free = [p for p in table.params + table.states if p not in self.given]
        self.trace = self.graph.number(0)
        for state in table.states:
            self.trace = self.graph.add(self.trace, self.graph.partial(table.field[state], state))

    def over(self, box):
        """A function that encloses nodes of the graph over the box."""
        known = {}

        def enclose(node):
            if node not in known:
                known[node] = look(self.graph.nodes[node])
            return known[node]

        def look(kind):
            if kind[0] == "n":
                return kind[1], kind[1]
            if kind[0] == "v":
                return enclose(self.given[kind[1]]) if kind[1] in self.given else box[kind[1]]
            if kind[0] == "r":
                return root(enclose(kind[1]))
            if kind[0] == "*" and kind[1] == kind[2]:
                return square(enclose(kind[1]))
            a, b = enclose(kind[1]), enclose(kind[2])
            if kind[0] == "+":
                return rounded((a[0] + b[0], a[1] + b[1]))
            return product(a, b) if kind[0] == "*" else product(a, inverse(b))

        return enclose


def read_box(given, family):
    box = {}
    for name, value in given["box"].items():
        low, high = (value["low"], value["high"]) if isinstance(value, dict) else (value, value)
        box[name] = Fraction(low), Fraction(high)
        must(box[name][0] <= box[name][1], "the range of %s is empty" % name)
    must(sorted(box) == sorted(family.free), "its box is not of what the family leaves free")
    for name, condition in family.table.signs.items():
        if name in box:
            low, high = box[name]
            must({">": low > 0, ">=": low >= 0, "!=": low > 0 or high < 0}[condition], name + " is outside the table's domain")
    for name, (low, high) in family.table.intervals.items():
        must(name not in box or low < box[name][0] and box[name][1] < high, name + " is outside the table's domain")
    return box


def replay(certificate, table):
    """The bounds of the trace that were shown, and in how many boxes."""
    given, shown = certificate["given"], certificate["shown"]
    name = given["family"]
    family = Family(table, name)
    box = read_box(given, family)
    said = Fraction(shown["trace"]["low"]), Fraction(shown["trace"]["high"])
    must(said[0] > 0 or said[1] < 0, "the trace may be 0")
    formula = table.traces[name] if "trace " + name in shown["claims"] else family.trace
    bounds = [(table.valids[v], Fraction(low)) for v, low in shown["conditions"].items() if low != "-inf"]

    def holds(part):
        """Whether what is said holds all over a part of the box, as far as that is in the domain."""
        enclose = family.over(part)
        try:
            if any(enclose(node)[1] <= 0 for node in table.domains):
                return True
            for node in table.field.values():
                low, high = enclose(node)
                must(low <= 0 <= high, "they are no equilibria")
            a, b = enclose(family.trace), enclose(formula)
            must(a[0] <= b[1] and b[0] <= a[1], "the trace is not what the table claims")
            return said[0] <= max(a[0], b[0]) and min(a[1], b[1]) <= said[1] and all(enclose(v)[0] >= low for v, low in bounds)
        except ArithmeticError:
            return False

    point = {n: (Fraction(x), Fraction(x)) for n, x in shown["point"].items()}
    must(sorted(point) == sorted(box), "its point is not of the box")
    must(all(box[n][0] <= x[0] <= box[n][1] for n, x in point.items()), "its point is not in the box")
    must(all(family.over(point)(node)[0] > 0 for node in table.domains) and holds(point), "its point is not in the table's domain")
    for corner in islice(choices(*(sorted(set(box[n])) for n in box)), CORNERS_MAX):  # most of what is false, at once
        must(holds({n: (x, x) for n, x in zip(box, corner)}), "what it says is not shown at a corner of the box")
    boxes, left = 0, [box]
    while left:
        part, boxes = left.pop(), boxes + 1
        if holds(part):
            continue
        must(boxes < BOXES_MAX, "what it says is not shown in %d boxes" % boxes)
        side = max(box, key=lambda n: (part[n][1] - part[n][0]) / (box[n][1] - box[n][0]) if box[n][1] > box[n][0] else -1)
        low, high = part[side]
        must(low < high, "what it says does not hold at its point")
        left += [dict(part, **{side: half}) for half in ((low, (low + high) / 2), ((low + high) / 2, high))]
    return said, boxes
