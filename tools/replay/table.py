"""A term table, read and differentiated by code of its own: what `check_certificate.py` needs of the language, and no more."""
import re
from fractions import Fraction


class Unserved(Exception):
    """Something that cannot be replayed here."""



KEYWORDS = ("model title source param state root angle let eq variant time eliminate default integral invariant measure reversor "
            "equilibria trace charpoly obstructs matrix leftnull reduction embedding rate positive domain symmetry periodic exp "
            "log observe valid pole section lift start turns tier equal").split()


class Graph:
    """Expressions, equal ones once: ("n", value), ("v", name), ("+", a, b), ("*", a, b), ("/", a, b), ("r", a) a root."""

    def __init__(self):
        self.nodes, self.index, self.partials = [], {}, {}

    def put(self, *node):
        if node not in self.index:
            self.index[node] = len(self.nodes)
            self.nodes.append(node)
        return self.index[node]

    def number(self, value):
        return self.put("n", Fraction(value))

    def value(self, a):
        return self.nodes[a][1] if self.nodes[a][0] == "n" else None

    def add(self, a, b):
        x, y = self.value(a), self.value(b)
        if x is not None and y is not None:
            return self.number(x + y)
        return b if x == 0 else a if y == 0 else self.put("+", a, b)

    def times(self, a, b):
        x, y = self.value(a), self.value(b)
        if x is not None and y is not None:
            return self.number(x * y)
        if x == 0 or y == 0:
            return self.number(0)
        return b if x == 1 else a if y == 1 else self.put("*", a, b)

    def over(self, a, b):
        if self.value(a) == 0:
            return a
        if self.value(b) is not None:
            return self.times(a, self.number(1 / self.value(b)))
        return self.put("/", a, b)

    def minus(self, a):
        return self.times(self.number(-1), a)

    def power(self, a, n):
        if n < 0:
            return self.over(self.number(1), self.power(a, -n))
        out = self.number(1)
        for _ in range(n):
            out = self.times(out, a)
        return out

    def partial(self, a, name):
        key = (a, name)
        if key not in self.partials:
            node = self.nodes[a]
            if node[0] == "n":
                out = self.number(0)
            elif node[0] == "v":
                out = self.number(int(node[1] == name))
            elif node[0] == "+":
                out = self.add(self.partial(node[1], name), self.partial(node[2], name))
            elif node[0] == "*":
                out = self.add(self.times(self.partial(node[1], name), node[2]), self.times(node[1], self.partial(node[2], name)))
            elif node[0] == "/":
                change = self.minus(self.times(a, self.partial(node[2], name)))
                out = self.over(self.add(self.partial(node[1], name), change), node[2])
            else:
                out = self.over(self.partial(node[1], name), self.times(self.number(2), a))
            self.partials[key] = out
        return self.partials[key]


def parity(graph, a, flipped):
    """Of an expression where the names in `flipped` change sign: 1 even, -1 odd, 0 zero, None neither or not known."""
    node = graph.nodes[a]
    if node[0] == "n":
        return 1 if node[1] != 0 else 0
    if node[0] == "v":
        return -1 if node[1] in flipped else 1
    parts = [parity(graph, b, flipped) for b in node[1:]]
    if None in parts:
        return None
    if node[0] == "r":
        return 1 if parts[0] == 1 else None
    if node[0] != "+":
        return parts[0] * parts[1]
    return sum(set(parts)) if len(set(parts) - {0}) < 2 else None


class Table:
    def __init__(self, text):
        self.graph = Graph()
        self.params, self.states, self.names, self.field, self.integrals, self.valids, self.reversors = [], [], {}, {}, {}, {}, []
        self.intervals, self.signs, self.families, self.traces, self.domains, self.poles = {}, {}, {}, {}, [], []
        for record in self.records(text):
            self.read(record)

    @staticmethod
    def records(text):
        out = []
        for line in text.splitlines():
            line = re.sub(r"#.*|\"[^\"]*\"|\[[^]]*\]", "", line)
            if not line.split():
                continue
            if line.split()[0] in KEYWORDS:
                out.append(line.strip())
            elif out:
                out[-1] += " " + line.strip()
        return out

    def read(self, record):
        word, rest = (record.split(None, 1) + [""])[:2]
        name = re.match(r"\w*", rest).group()
        body = rest.split("=", 1)[1] if "=" in rest else ""
        if word == "param":
            self.params.append(name)
            sign = re.search(r"(>=|>|!=) *0", rest)
            if sign:
                self.signs[name] = sign.group(1)
            self.names[name] = self.graph.put("v", name)
        elif word == "state":
            self.states.append(name)
            self.names[name] = self.graph.put("v", name)
            rest = rest[len(name):].strip()
            ends = re.fullmatch(r"in \(([-\d./]+), *([-\d./]+)\)", rest)
            if ends:
                self.intervals[name] = (Fraction(ends.group(1)), Fraction(ends.group(2)))
            elif rest:
                raise Unserved("the table has " + rest)
        elif word == "root":
            self.names[name] = self.root(name, self.parse(re.match(r"\s*sqrt(.*)", body).group(1)))
        elif word == "let" or (word == "observe" and body):
            self.names[name] = self.parse(body)
        elif word == "eq":
            self.field[name] = self.parse(body)
        elif word == "integral" and not re.search(r"\b(when|modulo)\b", body):
            self.integrals[name] = self.names[name] = self.parse(body)
        elif word == "equilibria":
            parts = [part.split("=", 1) for part in re.split(r",|\bwhen\b", rest.split(":", 1)[1])]
            self.families[name] = {state.strip(): self.parse(value) for state, value in parts}
        elif word == "trace":
            self.traces[name] = self.parse(body)
        elif word == "domain":
            self.domains.append(self.parse(rest.split(":", 1)[1].rsplit(">", 1)[0]))
        elif word == "pole":
            self.poles.append(name)
        elif word == "valid":
            self.valids[name] = self.parse(rest.split(":", 1)[1].rsplit(">", 1)[0])
        elif word == "reversor" and "when" not in rest:
            self.reversors.append(rest)
        elif word in ("angle", "exp", "log"):
            raise Unserved("the table has " + word)

    def root(self, _, radicand):
        return self.graph.put("r", radicand)

    def rate(self, a):
        out = self.graph.number(0)
        for state, rate in self.field.items():
            out = self.graph.add(out, self.graph.times(self.graph.partial(a, state), rate))
        return out

    def reverses(self, flipped):
        """Whether the table claims that a change of these signs turns the motion around, and its expressions show it."""
        claimed = any(re.fullmatch(r"\w+ *-> *-\w+( *, *\w+ *-> *-\w+)*", rest.strip())
                      and {(a, a) for a in flipped} == set(re.findall(r"(\w+) *-> *-(\w+)", rest)) for rest in self.reversors)
        return claimed and all(parity(self.graph, rate, flipped) in (0, 1 if state in flipped else -1)
                               for state, rate in self.field.items())

    def parse(self, text):
        self.tokens = re.findall(r"\d+\.?\d*(?:[eE][-+]?\d+)?|\w+|[-+*/^()]", text)
        out = self.sum()
        if self.tokens:
            raise Unserved("cannot read: " + text)
        return out

    def next_is(self, *tokens):
        return self.tokens.pop(0) if self.tokens and self.tokens[0] in tokens else None

    def sum(self):
        sign = self.next_is("+", "-")
        out = self.product()
        if sign == "-":
            out = self.graph.minus(out)
        while self.tokens and self.tokens[0] in "+-":
            sign = self.tokens.pop(0)
            term = self.product()
            out = self.graph.add(out, term if sign == "+" else self.graph.minus(term))
        return out

    def product(self):
        out = self.factor()
        while self.tokens and self.tokens[0] in "*/":
            out = (self.graph.times if self.tokens.pop(0) == "*" else self.graph.over)(out, self.factor())
        return out

    def factor(self):
        token = self.tokens.pop(0)
        if token == "(":
            out = self.sum()
            self.tokens.pop(0)
        elif token == "rate":
            self.tokens.pop(0)
            out = self.rate(self.sum())
            self.tokens.pop(0)
        else:
            out = self.graph.number(Fraction(token)) if token[0].isdigit() else self.names[token]
        if self.next_is("^"):
            bracket = self.next_is("(")
            sign = self.next_is("-")
            out = self.graph.power(out, int(self.tokens.pop(0)) * (-1 if sign else 1))
            if bracket:
                self.tokens.pop(0)
        return out
