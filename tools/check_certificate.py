#!/usr/bin/env python3
"""Replay a certificate of `jellett certify` by a second program, which shares no code with the first and needs no library.

    tools/check_certificate.py [--table FILE.tt] CERTIFICATE.json

The table is read by a parser of its own, differentiated symbolically, and integrated by Taylor's method in interval arithmetic on
integers (tools/replay/). Steps, order and precision are chosen here. Then Krawczyk's operator is applied in the certificate's box,
and what it encloses must meet what the certificate says. Taken on trust: that the table's integrals and reversor are what it claims,
which `ttc prove` shows. Served are tables without functions but roots, with numbers for parameters and levels, one level at most, and two
coordinates.
Exit status: 0 proved, 1 refused, 2 usage, 3 not a certificate that can be replayed here.
"""
import hashlib
import json
import os
import sys
from fractions import Fraction

sys.dont_write_bytecode = True
from replay.balls import (ONE, P, ball, exact, exponential, hull, inside, less, matadd, matmul, meet, plus, product, quotient, size,
                          unit)
from replay.flow import Flow, Refused
from replay.series import CLOCK, Program
from replay.table import Table, Unserved


def inverse_of(A):
    """Near the inverse of the middles, exact numbers; nothing is claimed of it."""
    n = len(A)
    M = [[Fraction(a[0], ONE) for a in row] + [Fraction(int(i == j)) for j in range(n)] for i, row in enumerate(A)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda k: abs(M[k][i]))
        M[i], M[pivot] = M[pivot], M[i]
        M[i] = [Fraction(int(x / M[i][i] * ONE), ONE) for x in M[i]]
        for k in range(n):
            if k != i:
                M[k] = [Fraction(int((x - M[k][i] * y) * ONE), ONE) for x, y in zip(M[k], M[i])]
    return [[(int(x * ONE), 0) for x in row[n:]] for row in M]


def read_ball(value):
    return ball(Fraction(value["middle"]), Fraction(value["radius"])) if isinstance(value, dict) else ball(Fraction(value))


def must(holds, what):
    if not holds:
        raise Refused(what)


def replay(certificate, table):
    given, shown, states = certificate["given"], certificate["shown"], table.states
    if any(isinstance(v, dict) for part in ("parameters", "levels") for v in given[part].values()):
        raise Unserved("parameters or levels are intervals")
    must(sorted(given["parameters"]) == sorted(table.params), "its parameters are not the table's")
    flow = Flow(table, {name: read_ball(value) for name, value in given["parameters"].items()})
    column, level = states.index(given["section"]["state"]), ball(Fraction(given["section"]["value"]))
    others = [i for i in range(len(states)) if i != column]
    kept = [states.index(name) for name in given["coordinates"]]
    instant = int(Fraction(given["instant"]) * 2 ** CLOCK)
    integrals = sorted(given["levels"])
    levels = Program(table, [table.integrals[name] for name in integrals]
                     + [table.graph.partial(table.integrals[name], s) for name in integrals for s in states], flow.full.params)

    def place(y):
        x = list(y)
        x.insert(column, level)
        return x

    def gradients(y):
        out = [s[0] for s in levels.run(place(y), 1, 1)[1]]
        m, n = len(integrals), len(states)
        return out[:m], [[out[m + j * n + i] for i in others] for j in range(m)]

    def equations(y):
        state, D, tau, expansion, least = flow.arrive(place(y), instant, column, level)
        values, slopes = gradients(y)
        G = [[less(state[i], place(y)[i])] for i in kept]
        DG = [[less(D[i][j], exact(int(i == j))) for j in others] for i in kept] + slopes
        G += [[less(v, ball(Fraction(given["levels"][name])))] for v, name in zip(values, integrals)]
        return G, DG, (state, D, tau, expansion, least)

    box = [read_ball(given["box"][states[i]]) for i in others]
    middle = [(a[0], 0) for a in box]
    G, DG, _ = equations(middle)
    M = inverse_of(DG)
    offset = matmul(M, G)

    def krawczyk(y):
        _, DG, arrival = equations(y)
        rest = matadd(unit(len(y)), [[(-a, r) for a, r in row] for row in matmul(M, DG)])
        away = matmul(rest, [[less(a, b)] for a, b in zip(y, middle)])
        return [plus(less(m, o[0]), a[0]) for m, o, a in zip(middle, offset, away)], arrival

    K, _ = krawczyk(box)
    must(all(map(inside, K, box)), "Krawczyk's operator does not map the box into itself")
    orbit, (state, D, tau, expansion, least) = krawczyk(K)
    for i, value in zip(others, orbit):
        must(meet(value, read_ball(shown["orbit"][states[i]])), "the orbit's point is elsewhere")
    must(meet(plus((instant << (P - CLOCK), 0), tau), read_ball(shown["period"])), "the period is another one")

    # on the levels: dw = -F_w^-1 F_q dq; one level is what is served
    left = [i for i in others if i not in kept]
    if len(left) > 1 or len(kept) != 2:
        raise Unserved("more than one level, or not two coordinates")
    wide = [hull(a, state[i]) if i in left else a for i, a in zip(others, K)]
    slopes = gradients(wide)[1]
    if left:
        by = slopes[0][others.index(left[0])]
        must(abs(by[0]) > by[1], "the integral does not determine the state left out")
        follow = [quotient((-slopes[0][others.index(q)][0], slopes[0][others.index(q)][1]), by) for q in kept]
    R = [[plus(D[i][q], product(D[i][left[0]], follow[k])) if left else D[i][q] for k, q in enumerate(kept)] for i in kept]
    trace = plus(R[0][0], R[1][1])
    determinant = exponential(expansion)
    matrix = less(product(R[0][0], R[1][1]), product(R[0][1], R[1][0]))
    must(meet(determinant, matrix), "the two determinants exclude each other")
    for name, value in (("trace", trace), ("determinant", determinant), ("determinant_of_matrix", matrix)):
        must(meet(value, read_ball(shown[name])), name + " is another one")
    for name, low in zip(flow.valids, least):
        said = Fraction(shown["conditions"][name])
        must(said <= 0 or low > 0, "the condition " + name + " is not shown to hold")
    if certificate["kind"] == "sink":
        must(size(determinant) < ONE and size(trace) < ONE + determinant[0] - determinant[1], "it is not shown to attract")
        must(table.reversor is not None, "the table claims no reversor without a condition")
    return trace, determinant, least


def decimal(a, digits=15):
    return "%.*g" % (digits, a / ONE)


def main(arguments):
    table_file = None
    if arguments[:1] == ["--table"] and len(arguments) > 2:
        table_file, arguments = arguments[1], arguments[2:]
    if len(arguments) != 1 or arguments[0].startswith("-"):
        print(__doc__, file=sys.stderr)
        return 2
    path = arguments[0]
    try:
        certificate = json.load(open(path))
        digest = certificate.pop("digest")
        text = json.dumps(certificate, sort_keys=True, separators=(",", ":"))
        must(hashlib.sha256(text.encode()).hexdigest() == digest, "its digest is not that of its text")
        name = certificate["given"]["table"]["name"]
        if table_file is None:
            table_file = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "codegen", "models", name + ".tt")
        table = open(table_file, "rb").read()
        if hashlib.sha256(table).hexdigest() != certificate["given"]["table"]["sha256"]:
            raise Unserved("the table %s has another SHA-256" % table_file)
        trace, determinant, least = replay(certificate, Table(table.decode()))
    except Refused as problem:
        print("%s: refused: %s" % (path, problem), file=sys.stderr)
        return 1
    except (Unserved, OSError, KeyError, ValueError, TypeError, AttributeError) as problem:
        print("%s: %s: cannot be replayed here" % (path, problem), file=sys.stderr)
        return 3
    print("%s: proved by a second program: det %s +- %.2g, trace %s +- %.2g, conditions above %s"
          % (path, decimal(determinant[0]), determinant[1] / ONE, decimal(trace[0]), trace[1] / ONE,
             [float(decimal(a, 5)) for a in least]))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
