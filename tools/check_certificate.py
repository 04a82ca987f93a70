#!/usr/bin/env python3
"""Replay a certificate of `jellett certify` by a second program, which shares no code with the first and needs no library.

    tools/check_certificate.py [--table FILE.tt] CERTIFICATE.json

The table is read by a parser of its own, differentiated symbolically, and integrated by Taylor's method in interval arithmetic on
integers (tools/replay/). Steps, order and precision are chosen here. Then Krawczyk's operator is applied in the certificate's
box, and what it encloses must meet what the certificate says; the words of its theorem are not read. Taken on trust: that the
table's integrals, families, traces and poles are what it claims, which `ttc prove` shows. Served are cycles in tables without
functions but roots, with numbers for parameters and levels, one level at most, and two coordinates: a leg takes some ten seconds,
with a twist a minute; families of equilibria in such tables, over boxes; and motions that end at a pole, in tables with one root.
Exit status: 0 proved, 1 refused, 2 usage, 3 not a certificate that can be replayed here.
"""
import hashlib
import json
import os
import re
import sys
from fractions import Fraction
from math import isqrt

sys.dont_write_bytecode = True
from replay import family, form, pole
from replay.balls import (ONE, P, ball, exact, exponential, hull, inside, less, matadd, matmul, meet, plus, product, quotient, root,
                          size, sum_of, unit)
from replay.flow import Flow, Refused, must
from replay.series import CLOCK, Program
from replay.table import Table, Unserved, parity
from replay.twist import cosine, normal_form, pi, return_map


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
    if not isinstance(value, dict):
        return ball(Fraction(value))
    must(set(value) == {"middle", "radius"} and Fraction(value["radius"]) >= 0, "a ball has no middle and radius")
    return ball(Fraction(value["middle"]), Fraction(value["radius"]))


def multipliers_of(trace, determinant):
    """The roots of mu^2 - trace mu + determinant, as (re, im): (trace + root)/2 first, the root's real part >= 0, else its
    imaginary part."""
    half = (trace[0] >> 1, (trace[1] >> 1) + 1)
    square = less(product(half, half), determinant)
    apart = root((abs(square[0]), square[1])) if abs(square[0]) > square[1] else (0, isqrt(size(square) << P) + 1)
    re, im = (apart, (0, 0)) if square[0] > square[1] else ((0, 0), apart) if square[0] < -square[1] else (apart, apart)
    return [(plus(half, re), im), (less(half, re), less((0, 0), im))]


def replay(certificate, table):
    given, shown, states = certificate["given"], certificate["shown"], table.states
    if any(isinstance(v, dict) for part in ("parameters", "levels") for v in given[part].values()):
        raise Unserved("parameters or levels are intervals")
    must(sorted(given["parameters"]) == sorted(table.params), "its parameters are not the table's")
    for name, sign in table.signs.items():
        value = Fraction(given["parameters"][name])
        must({">": value > 0, ">=": value >= 0, "!=": value != 0}[sign], name + " is outside the table's domain")
    flow = Flow(table, {name: read_ball(value) for name, value in given["parameters"].items()})
    column, level = states.index(given["section"]["state"]), ball(Fraction(given["section"]["value"]))
    others = [i for i in range(len(states)) if i != column]
    kept = [states.index(name) for name in given["coordinates"]]
    legs = given["legs"]
    instants = [int(Fraction(leg["instant"]) * 2 ** CLOCK) for leg in legs]
    integrals = sorted(given["levels"])
    levels = Program(table, [table.integrals[name] for name in integrals]
                     + [table.graph.partial(table.integrals[name], s) for name in integrals for s in states], flow.full.params)
    width = len(others)
    unknowns = width * len(legs)

    def place(y):
        x = list(y)
        x.insert(column, level)
        return x

    def gradients(y):
        out = [s[0] for s in levels.run(place(y), 1, 1)[1]]
        m, n = len(integrals), len(states)
        return out[:m], [[out[m + j * n + i] for i in others] for j in range(m)]

    def equations(y):
        """Of all legs: P_q(y_i) = q_(i+1), F(y_i) = c."""
        G, DG, arrivals = [], [], []
        for i, instant in enumerate(instants):
            here, there = i * width, (i + 1) % len(legs) * width
            start, end = y[here:here + width], place(y[there:there + width])
            arrival = flow.arrive(place(start), instant, column, level, given["section"]["direction"])
            arrivals.append(arrival)
            values, slopes = gradients(start)
            for q in kept:
                row = [exact(0)] * unknowns
                row[here:here + width] = [arrival[1][q][j] for j in others]
                row[there + others.index(q)] = less(row[there + others.index(q)], exact(1))
                DG.append(row)
                G.append([less(arrival[0][q], end[q])])
            for value, name, slope in zip(values, integrals, slopes):
                row = [exact(0)] * unknowns
                row[here:here + width] = slope
                DG.append(row)
                G.append([less(value, ball(Fraction(given["levels"][name])))])
        return G, DG, arrivals

    def is_mirror_image(flipped, solution, arrivals, windows, k):
        """Whether the cycle's image, in the order that k says, passes through the boxes when starts of them do."""
        good = True
        for j in range(len(legs)):
            source = (k - j) % len(legs)
            before = (source - 1) % len(legs)
            image = [(-a[0], a[1]) if states[i] in flipped else a
                     for i, a in zip(others, solution[source * width:(source + 1) * width])]
            good = good and all(map(inside, image, box[j * width:(j + 1) * width]))
            time = plus(arrivals[before][2], ((instants[before] - instants[j]) * 2 ** (P - CLOCK), 0))
            good = good and inside(time, windows[j])
        return good

    box = [read_ball(leg["box"][states[i]]) for leg in legs for i in others]
    middle = [(a[0], 0) for a in box]
    G, DG, _ = equations(middle)
    M = inverse_of(DG)
    offset = matmul(M, G)

    def krawczyk(y):
        _, DG, arrivals = equations(y)
        rest = matadd(unit(len(y)), [[(-a, r) for a, r in row] for row in matmul(M, DG)])
        away = matmul(rest, [[less(a, b)] for a, b in zip(y, middle)])
        return [plus(less(m, o[0]), a[0]) for m, o, a in zip(middle, offset, away)], arrivals

    K, wide = krawczyk(box)
    must(all(map(inside, K, box)), "Krawczyk's operator does not map the box into itself")
    orbit, arrivals = krawczyk(K)
    must(len(shown["orbit"]) == len(legs), "its points are not as many as its legs")
    for i, point in enumerate(shown["orbit"]):
        for j, value in zip(others, orbit[i * width:(i + 1) * width]):
            must(meet(value, read_ball(point[states[j]])), "a point of the orbit is elsewhere")
    times = [plus((instant << (P - CLOCK), 0), arrival[2]) for instant, arrival in zip(instants, arrivals)]
    must(all(time[0] > time[1] for time in times), "a leg of the orbit is not shown to take time")
    period = sum_of(times)
    must(meet(period, read_ball(shown["period"])), "the period is another one")

    # on the levels: dw = -F_w^-1 F_q dq; one level is what is served
    left = [i for i in others if i not in kept]
    if len(left) > 1 or len(kept) != 2:
        raise Unserved("more than one level, or not two coordinates")

    def follow(y):
        """dw by dq"""
        slopes = gradients(y)[1]
        by = slopes[0][others.index(left[0])]
        must(abs(by[0]) > by[1], "the integral does not determine the state left out")
        return [quotient((-slopes[0][others.index(q)][0], slopes[0][others.index(q)][1]), by) for q in kept]

    R, expansion, least, more = unit(2), exact(0), None, ""
    for i, (state, D, _, growth, low, _) in enumerate(arrivals):
        there = (i + 1) % len(legs) * width
        if left:
            follow([hull(a, state[j]) if j in left else a for j, a in zip(others, K[there:there + width])])  # the legs meet
            w = follow(K[i * width:(i + 1) * width])
        D = [[plus(D[a][q], product(D[a][left[0]], w[k])) if left else D[a][q] for k, q in enumerate(kept)] for a in kept]
        R = matmul(D, R)
        expansion = plus(expansion, growth)
        least = low if least is None else [tuple(map(min, a, b)) for a, b in zip(least, low)]
    trace = plus(R[0][0], R[1][1])
    determinant = exponential(expansion)
    matrix = less(product(R[0][0], R[1][1]), product(R[0][1], R[1][0]))
    must(meet(determinant, matrix), "the two determinants exclude each other")
    for name, value in (("trace", trace), ("determinant", determinant), ("determinant_of_matrix", matrix)):
        must(meet(value, read_ball(shown[name])), name + " is another one")
    must(len(shown["multipliers"]) == 2, "its multipliers are not as many as its coordinates")
    for (re_part, im_part), said in zip(multipliers_of(trace, determinant), shown["multipliers"]):
        must(meet(re_part, read_ball(said["re"])) and meet(im_part, read_ball(said["im"])), "a multiplier is another one")
    for name, (low, high) in zip(flow.valids, least):
        said = Fraction(shown["conditions"][name])
        must(said <= 0 or low > 0, "the condition " + name + " is not shown to hold")
        must(said * ONE <= high, "the condition " + name + " has less than the bound that is said")
    if certificate["kind"] == "obstruction":
        must(abs(determinant[0] - ONE) > determinant[1], "its determinant may be 1")
    if certificate["kind"] in ("symmetric", "elliptic"):
        flipped = set(shown["symmetry"]["reversor"])
        must(flipped and table.reverses(flipped), "the table claims another reversor, or none")
        must(states[column] in flipped and Fraction(given["section"]["value"]) == 0, "the section is not its own image")
        for name in integrals:
            even = parity(table.graph, table.integrals[name], flipped)
            must(even in (0, 1) or (even == -1 and Fraction(given["levels"][name]) == 0),
                 "the level of %s is not its own image" % name)
        must(any(is_mirror_image(flipped, K, arrivals, [a[5] for a in wide], k) for k in range(len(legs))),
             "it is not shown to be its own mirror image")
        kind = shown["symmetry"]["type"]
        must({"elliptic": size(trace) < 2 * ONE, "hyperbolic": trace[0] - trace[1] > 2 * ONE,
              "inverse hyperbolic": trace[0] + trace[1] < -2 * ONE, "not settled": True}[kind], "it is not " + kind)
        if kind == "elliptic":
            rotation = read_ball(shown["symmetry"]["rotation"])
            must(rotation[1] < rotation[0] < (ONE >> 1) - rotation[1], "the rotation number is not between 0 and 1/2")
            must(meet(product(exact(2), cosine(product(exact(2), product(pi(), rotation)))), trace),
                 "the rotation number is another one")
    if certificate["kind"] == "elliptic":
        must(size(trace) < 2 * ONE, "it is not elliptic")
        must(all(abs(trace[0] - n * ONE) > trace[1] for n in (0, -1)), "a multiplier may be a root of unity of order 3 or 4")
        points = [place(orbit[i * width:(i + 1) * width]) for i in range(len(legs))]
        slopes = [dict(zip(others, gradients(orbit[i * width:(i + 1) * width])[1][0])) if left else {} for i in range(len(legs))]
        M = return_map(flow, points, instants, [a[2] for a in arrivals], column, kept,
                       [table.integrals[name] for name in integrals], slopes)
        must(meet(plus(M[0][1], M[1][2]), trace), "two enclosures of the trace exclude each other")
        growth, twist = normal_form(M, trace)
        said = shown["twist"]
        must(said["coordinate"] == states[kept[0]], "the twist is that by the amplitude of another state")
        must(meet(growth, (0, 0)) and meet(growth, read_ball(said["growth"])), "the map is not shown to be reversible")
        must(abs(twist[0]) > twist[1], "the twist may be 0")
        must(meet(twist, read_ball(said["coefficient"])), "the twist is another one")
        more = ", twist %s +- %.2g" % (decimal(twist[0]), twist[1] / ONE)
    if certificate["kind"] == "sink":
        must(size(determinant) < ONE and size(trace) < ONE + determinant[0] - determinant[1], "it is not shown to attract")
        must("reversor" not in shown["claims"]
             or any(table.reverses(set(re.findall(r"(\w+) *->", rest))) for rest in table.reversors),
             "the table claims no reversor that changes signs")
    return ("det %s +- %.2g, trace %s +- %.2g%s, conditions above %s"
            % (decimal(determinant[0]), determinant[1] / ONE, decimal(trace[0]), trace[1] / ONE, more,
               [float(decimal(low, 5)) for low, _ in least]))


def decimal(a, digits=15):
    return "%.*g" % (digits, a / ONE)


def main(arguments):
    table_file = None
    if arguments[:1] == ["--table"] and len(arguments) > 2:
        table_file, arguments = arguments[1], arguments[2:]
    if len(arguments) != 1 or arguments[0].startswith("-"):
        asked = arguments[:1] in (["-h"], ["--help"])
        print(__doc__.rstrip(), file=sys.stdout if asked else sys.stderr)
        return 0 if asked else 2
    path = arguments[0]
    try:
        certificate = json.load(open(path))
        digest = certificate.pop("digest")
        text = json.dumps(certificate, sort_keys=True, separators=(",", ":"))
        must(hashlib.sha256(text.encode()).hexdigest() == digest, "its digest is not that of its text")
        name = certificate["given"]["table"]["name"]
        if table_file is None:
            table_file = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "codegen", "models", name + ".tt")
            if not os.path.exists(table_file):
                raise Unserved("there is no table %s in codegen/models: name its file by --table" % name)
        table = open(table_file, "rb").read()
        if hashlib.sha256(table).hexdigest() != certificate["given"]["table"]["sha256"]:
            raise Unserved("the table %s has another SHA-256" % table_file)
        form.check(certificate, Table(table.decode()))
        if certificate["kind"] == "equilibria":
            bounds, boxes = family.replay(certificate, Table(table.decode()))
            print("%s: proved by a second program: trace from %.5g to %.5g, %d boxes" % (path, *bounds, boxes))
            return 0
        if certificate["kind"] == "pole":
            proved = pole.replay(certificate, table.decode(), read_ball)
        else:
            proved = replay(certificate, Table(table.decode()))
    except (Refused, ArithmeticError) as problem:
        print("%s: refused: %s" % (path, problem), file=sys.stderr)
        return 1
    except (Unserved, OSError, KeyError, ValueError, TypeError, AttributeError) as problem:
        print("%s: %s: cannot be replayed here" % (path, problem), file=sys.stderr)
        return 3
    print("%s: %s proved by a second program: %s" % (path, certificate["kind"], proved))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
