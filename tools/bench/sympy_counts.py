#!/usr/bin/env python3
"""Operation counts of SymPy's common subexpression elimination on the functions that ttc compiles.

usage: tools/bench/sympy_counts.py FILE.tt... > tests/bench/sympy_counts.tsv

Reads the tables on its own, builds the field of every variant, time and elimination, differentiates with SymPy, and
counts the operations of sympy.cse's result: the smaller of the plain run and of optimizations='basic'. A negative term
of a sum is subtracted, any other negation is one operation, as in ttc's own counts; a power costs its multiplications, a quotient one division, an integer or half-integer power of one base
one division or root more. Each row carries the SHA-256 of its table, which the test of the counts holds against the tables there
are. Needs SymPy; neither the build nor the tests run it.
"""
import hashlib
import re
import sys

import sympy as sp

KEYWORDS = {"model", "title", "source", "param", "state", "root", "angle", "let", "eq", "variant", "time", "eliminate",
            "default", "integral", "invariant", "measure", "reversor", "equilibria", "trace", "charpoly", "obstructs",
            "equal", "matrix", "leftnull", "reduction", "rate", "symmetry", "exp", "log", "domain",
            "embedding", "positive", "observe", "valid", "periodic", "pole", "section", "lift", "start", "turns", "tier"}


def records(path):
    """The records of a table as (keyword, rest)."""
    found = []
    for line in open(path, encoding="utf-8"):
        line = line.split("#")[0].strip() if '"' not in line else line.strip()
        if not line or line.startswith("#"):
            continue
        word, _, rest = line.partition(" ")
        if word in KEYWORDS:
            found.append([word, rest.strip()])
        else:
            found[-1][1] += " " + line
    return found


class Model:
    def __init__(self, path):
        self.symbols, self.values = {}, {}
        self.name, self.params, self.states, self.roots = "", [], [], {}
        self.fields, self.variants, self.times, self.eliminations = {}, [], [], []
        self.integrals, self.measures, self.observed, self.valid, self.domain = [], [], [], [], []
        for keyword, rest in records(path):
            handler = getattr(self, "read_" + keyword, None)
            if handler is not None:
                handler(rest)

    def symbol(self, name, **assumptions):
        self.symbols[name] = sp.Symbol(name, **(assumptions or {"real": True}))
        return self.symbols[name]

    def expression(self, text):
        """A table's expression with lets and roots written out."""
        names = {"pi": sp.pi, **self.symbols, **self.values}
        return sp.sympify(text.replace("^", "**"), locals=names, rational=True)

    def bindings(self, text):
        pairs = []
        for item in text.split(","):
            if item.strip():
                name, _, value = item.partition("=")
                pairs.append((self.symbols[name.strip()], self.expression(value)))
        return pairs

    def read_model(self, rest):
        self.name = rest.split()[0]

    def read_param(self, rest):
        positive = re.match(r"\w+\s*>\s*0", rest) is not None
        self.params.append(self.symbol(rest.split()[0], **({"positive": True} if positive else {"real": True})))

    def read_state(self, rest):
        self.states.append(self.symbol(rest.split()[0]))

    def read_root(self, rest):
        name, _, value = rest.partition("=")
        radicand = self.expression(re.match(r"\s*sqrt\((.*)\)\s*$", value).group(1))
        self.roots[name.strip()] = (self.symbol(name.strip(), positive=True), radicand)

    def read_angle(self, rest):
        names, values = rest.split("=")
        angle = self.expression(re.match(r"\s*cos\((.*)\)\s*sin\(", values).group(1))
        for name, value in zip(names.split(), (sp.cos(angle), sp.sin(angle))):
            self.values[name] = value

    def read_exp(self, rest):
        name, argument = re.match(r"(\w+)\s*=\s*exp\((.*)\)$", rest).groups()
        self.values[name] = sp.exp(self.expression(argument))

    def read_log(self, rest):
        name, argument = re.match(r"(\w+)\s*=\s*log\((.*)\)$", rest).groups()
        self.values[name] = sp.log(self.expression(argument))

    def read_let(self, rest):
        name, _, value = rest.partition("=")
        self.values[name.strip()] = self.expression(value)

    def rate(self, e):
        """Along the motion; terms of equations stay terms."""
        total = sum(sp.diff(e, s) * f for s, f in self.fields.items())
        for root, radicand in self.roots.values():
            inner = sum(sp.diff(radicand, s) * f for s, f in self.fields.items())
            total += sp.diff(e, root) * inner / (2 * root)
        return sp.expand_mul(total)

    def read_observe(self, rest):
        name, _, value = re.split(r"\[|\"", rest)[0].partition("=")
        if value:
            self.values["rate"] = self.rate
            self.values[name.strip()] = self.expression(value)
            del self.values["rate"]
        self.observed.append(self.values[name.strip()])

    def read_valid(self, rest):
        value = re.split(r"\[|\"", rest)[0].partition(":")[2].partition(">")[0]
        self.valid.append(self.expression(value))

    def read_domain(self, rest):
        value = re.split(r"\[|\"", rest)[0].partition(":")[2].partition(">")[0]
        self.domain.append(self.expression(value))

    def read_eq(self, rest):
        name, _, value = rest.partition("=")
        self.fields[self.symbols[name.strip()]] = self.expression(value)

    def read_variant(self, rest):
        name, _, bound = rest.partition(":")
        self.variants.append((name.strip(), self.bindings(bound)))

    def read_time(self, rest):
        name, _, rest = rest.partition(":")
        factor, _, lifted = rest.partition("lifting")
        self.times.append((name.strip(), self.expression(factor), [x.strip() for x in lifted.split(",") if x.strip()]))

    def read_eliminate(self, rest):
        name, state, integral, level = re.match(r"(\w+)\s*:\s*(\w+)\s+by\s+(\w+)\s*=\s*(\w+)", rest).groups()
        self.eliminations.append((name, self.symbols[state], integral, self.symbol(level)))

    def claim(self, rest):
        body, _, when = re.split(r"\bmodulo\b", rest)[0].partition(" when ")
        name, _, value = body.partition("=")
        return name.strip(), self.expression(value), self.bindings(when)

    def read_integral(self, rest):
        if "modulo" not in rest:
            self.integrals.append(self.claim(rest))

    def read_measure(self, rest):
        if "modulo" not in rest:
            self.measures.append(self.claim(rest))


def flops(expressions):
    """Operations, and divisions among them, of straight-line code for the replacements and results of sympy.cse."""
    total, divisions = 0, 0

    def visit(e):
        nonlocal total, divisions
        if e.is_Atom:
            return
        if isinstance(e, sp.Add):
            total += len(e.args) - 1
            signs = []
            for a in e.args:
                c, rest = a.as_coeff_Mul()
                signs.append(c < 0)
                visit(rest if c == -1 else a)
            total += all(signs)
        elif isinstance(e, sp.Mul):
            up, down = [], []
            for a in e.args:
                if a.is_Pow and a.exp.is_number and a.exp.is_negative:
                    down.append(sp.Pow(a.base, -a.exp))
                elif a.is_Rational and not a.is_Integer:
                    if abs(a.p) != 1:
                        up.append(sp.Integer(a.p))
                    down.append(sp.Integer(a.q))
                elif a != -1:
                    up.append(a)
                else:
                    total += 1
            for a in up + down:
                visit(a)
            total += max(len(up) - 1, 0) + max(len(down) - 1, 0) + (1 if down else 0)
            divisions += 1 if down else 0
        elif isinstance(e, sp.Pow):
            visit(e.base)
            exponent = e.exp
            if exponent.is_negative:
                total, divisions, exponent = total + 1, divisions + 1, -exponent
            if exponent.q == 2:  # x^(k + 1/2) = x^k sqrt(x)
                total += 1 if exponent.p == 1 else 2
            total += {0: 0, 1: 0, 2: 1, 3: 2, 4: 2, 5: 3, 6: 3, 7: 4, 8: 3}[int(exponent.p // exponent.q)]
        elif isinstance(e, sp.Function):
            total += 1
            for a in e.args:
                visit(a)
        else:
            raise ValueError(f"no count for {e}")

    for e in expressions:
        visit(sp.sympify(e))
    return total, divisions


def cheapest(functions):
    counts = []
    for optimizations in (None, "basic"):
        replacements, results = sp.cse(functions, optimizations=optimizations)
        counts.append(flops([e for _, e in replacements] + list(results)))
    return min(counts)


def kernels(model, variant, time, elimination):
    """Functions by kernel name; None where the field does not exist."""
    states = list(model.states)
    bound = list(variant[1]) if variant else []
    factor, lifted = (time[1], time[2]) if time else (sp.Integer(1), [])
    kept = {model.roots[r][0] for r in lifted}
    written_out = [(s, sp.sqrt(q)) for s, q in model.roots.values() if s not in kept]
    rules = list(bound)
    if elimination:
        state, integral, level = elimination[1:]
        value = next(v for n, v, _ in model.integrals if n == integral)
        slope = sp.diff(value, state)
        solution = (level - value.subs(state, 0)) / slope
        if slope.subs(bound).subs(bound) == 0:
            return None
        rules.append((state, solution))
        states.remove(state)

    def field_expression(e):
        e = sp.sympify(e)
        for _ in range(2):
            for old, new in rules:
                e = e.subs(old, new)
        return e

    f = [field_expression(sum(sp.expand_mul(t) * factor for t in sp.Add.make_args(model.fields[s]))) for s in states]
    for r in lifted:
        root, radicand = model.roots[r]
        inner = sum(sp.diff(radicand, s) * g for s, g in zip(states, f))
        f.append(sp.expand_mul(inner / (2 * root)) if not isinstance(inner, sp.Add) else inner / (2 * root))
        states.append(root)
    f = [e.subs(written_out) for e in f]
    final = lambda e: field_expression(e).subs(written_out)

    def holds(when):
        return all(sp.simplify(final(a) - final(b)) == 0 for a, b in when)

    jacobian = [sp.diff(e, s) for e in f for s in states]
    n = len(states)
    trace = sum(jacobian[i * n + i] for i in range(n))
    values = [final(v) for name, v, when in model.integrals
              if holds(when) and not (elimination and name == elimination[2])]
    result = {"rhs": f, "jacobian": jacobian, "rhs_jacobian": f + jacobian, "divergence": [trace]}
    if values:
        result["integral_values"] = values
        result["integral_gradients"] = [sp.diff(v, s) for v in values for s in states]
    if not lifted:
        slope = sp.diff(next(v for m, v, _ in model.integrals if m == elimination[2]), elimination[1]) if elimination else 1
        densities = [final(v / factor / slope) for _, v, when in model.measures if holds(when)]
        if densities:
            result["measure_values"] = densities
            result["measure_divergences"] = [trace * rho + sum(sp.diff(rho, s) * g for s, g in zip(states, f))
                                             for rho in densities]
    if not variant and not elimination:
        result["observe_values"] = [final(e) for e in model.observed]
        result["valid_values"] = [final(e) for e in model.valid]
    if model.domain:
        result["domain_values"] = [final(e) for e in model.domain]
        result["domain_gradients"] = [sp.diff(v, s) for v in result["domain_values"] for s in states]
    if time:
        result["time_factor"] = [final(factor)]
    if elimination:
        result["eliminated"] = [final(elimination[1])]
    return result


def main(paths):
    print("model\tvariant\ttime\telimination\tkernel\tsympy_flops\tsympy_div\tsha256")
    for path in paths:
        model = Model(path)
        with open(path, "rb") as table:
            digest = hashlib.sha256(table.read()).hexdigest()
        for variant in [None] + model.variants:
            for time in [None] + model.times:
                for elimination in [None] + model.eliminations:
                    found = kernels(model, variant, time, elimination)
                    for name, functions in (found or {}).items():
                        if not functions:
                            continue
                        key = [model.name] + [x[0] if x else "-" for x in (variant, time, elimination)] + [name]
                        print("\t".join(key + [str(n) for n in cheapest(functions)] + [digest]), flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(sys.argv[1:])
