"""The twist of an elliptic cycle: the return map's Taylor polynomial of degree 3 on the levels, and the coefficient d of its normal
form z -> lambda z (1 + d |z|^2), by a change of z that takes the terms of degree 2 away (J. Moser 1973)."""
from replay.balls import ONE, exact, inside, less, plus, product, quotient, root, size
from replay.flow import must
from replay.jets import COUNT, TERMS, ZERO, Jets, add, carry, constant, evaluate, times, variable
from replay.series import CLOCK


def start(table, params, point, column, kept, integrals, slopes):
    """All starts near a point of the section: kept states move, the one left out follows from its level, degree by degree. slopes:
    of the integral by states, at the point."""
    x = [variable(a, kept.index(i)) if i in kept else constant(a) for i, a in enumerate(point)]
    left = [i for i in range(len(point)) if i != column and i not in kept]
    if left:
        jets = Jets(table, integrals, params)
        for degree in (1, 2, 3):
            (value,) = jets.values(x)
            for t, term in enumerate(TERMS):
                if sum(term) == degree:
                    x[left[0]][t] = less(x[left[0]][t], quotient(value[t], slopes[left[0]]))
    return x


def cross(jets, x, tau, column):
    """The polynomials x where they meet the section, a time within tau from here at the orbit, whose first coefficients are those
    of the section: sum over k of c_k s^k = level is solved for s(u, v), which is 0 at 0."""
    span = (0, 2 * size(tau) + 1)
    rates = jets.values(x)
    y = [[plus(a, (0, 2 * size(product(f, span)) + (a[1] >> 10) + 1)) for a, f in zip(p, q)] for p, q in zip(x, rates)]
    rates = jets.values(y)
    z = [[plus(a, product(f, span)) for a, f in zip(p, q)] for p, q in zip(x, rates)]
    must(all(inside(a, b) for p, q in zip(z, y) for a, b in zip(p, q)), "the crossing of the section is not enclosed")
    x = [[plus(a, product(f, tau)) for a, f in zip(p, q)] for p, q in zip(x, rates)]
    series = jets.run(x, 1 << CLOCK, 3)[0]
    c = [[[s[k] for s in state] for k in range(4)] for state in series]
    s = constant(ZERO)

    def moved(state):
        out = c[state][3]
        for k in (2, 1, 0):
            out = add(times(out, s), c[state][k])
        return out

    for degree in (1, 2, 3):
        value = moved(column)
        s = [less(a, quotient(value[t], c[column][1][0])) if sum(TERMS[t]) == degree else a for t, a in enumerate(s)]
    return [moved(state) for state in range(len(x))]


def return_map(flow, points, instants, taus, column, kept, integrals, slopes):
    """Both kept states after all legs, as polynomials in their distances from the orbit's first point; without constants."""
    table = flow.table
    jets = Jets(table, [table.field[s] for s in table.states], flow.full.params)
    whole = None
    for point, instant, tau, slope in zip(points, instants, taus, slopes):
        x = start(table, flow.full.params, point, column, kept, integrals, slope)
        x = cross(jets, carry(flow, jets, x, instant), tau, column)
        leg = [[ZERO] + x[q][1:] for q in kept]
        whole = leg if whole is None else [evaluate(row, *whole) for row in leg]
    return whole


# ---- complex balls: pairs of a real and an imaginary part ----

def cadd(a, b):
    return (plus(a[0], b[0]), plus(a[1], b[1]))


def cmul(a, b):
    return (less(product(a[0], b[0]), product(a[1], b[1])), plus(product(a[0], b[1]), product(a[1], b[0])))


def negative(a):
    return (-a[0], a[1])


def conj(a):
    return (a[0], negative(a[1]))


def cdiv(a, b):
    square = plus(product(b[0], b[0]), product(b[1], b[1]))
    return tuple(quotient(x, square) for x in cmul(a, conj(b)))


def real(x):
    return (x, ZERO)


def minus(a, b):
    return cadd(a, (negative(b[0]), negative(b[1])))


def normal_form(M, trace):
    """d, where z = u + i y. M: both coordinates as polynomials in u, v; trace: of their linear part."""
    half = (trace[0] >> 1, (trace[1] >> 1) + 1)
    other = root(less(exact(1), product(half, half)))
    eigenvalue = (half, other)
    a11, a12 = M[0][1], M[0][2]
    slope = cdiv(minus(eigenvalue, real(a11)), real(plus(a12, a12)))  # v = slope z + conj(slope z), u = (z + conj z)/2
    # polynomials in z and conj z, coefficients by TERMS
    middle = (ONE >> 1, 0)
    u = {(1, 0): real(middle), (0, 1): real(middle)}
    v = {(1, 0): slope, (0, 1): conj(slope)}

    def multiply(p, q):
        out = {}
        for (a, b), x in p.items():
            for (c, d), y in q.items():
                if a + b + c + d <= 3:
                    out[a + c, b + d] = cadd(out.get((a + c, b + d), (ZERO, ZERO)), cmul(x, y))
        return out

    powers = {(0, 0): {(0, 0): real(exact(1))}}
    for a, b in TERMS[1:]:
        powers[a, b] = multiply(powers[a - 1, b], u) if a else multiply(powers[a, b - 1], v)
    image = []
    for row in M:
        out = {}
        for t in range(1, COUNT):
            for term, x in powers[TERMS[t]].items():
                out[term] = cadd(out.get(term, (ZERO, ZERO)), cmul(real(row[t]), x))
        image.append(out)
    # z = u + i y with v = 2 Re(slope) u - 2 Im(slope) y
    twice = plus(slope[1], slope[1])
    weight_u = (exact(1), quotient(plus(slope[0], slope[0]), twice))
    weight_v = (ZERO, negative(quotient(exact(1), twice)))
    h = {term: cadd(cmul(weight_u, image[0][term]), cmul(weight_v, image[1][term])) for term in image[0]}
    # w + a_20 w^2 + a_11 w conj w + a_02 conj w^2 in place of z takes degree 2 away: h_jk = (lambda^j conj(lambda)^k - lambda) a_jk
    square = cmul(eigenvalue, eigenvalue)
    a20 = cdiv(h[2, 0], minus(square, eigenvalue))
    a11 = cdiv(h[1, 1], minus(real(exact(1)), eigenvalue))
    a02 = cdiv(h[0, 2], minus(conj(square), eigenvalue))
    # what w^2 conj w then has
    third = cadd(h[2, 1], cmul(h[1, 1], cadd(conj(a11), a20)))
    for _ in range(2):
        third = cadd(third, cadd(cmul(h[2, 0], a11), cmul(h[0, 2], conj(a02))))
    return cdiv(third, eigenvalue)


def pi():
    """Machin's formula."""
    def arctan(n):
        out = term = (ONE << 32) // n
        k, sign = 1, -1
        while term:
            term //= n * n
            k += 2
            out += sign * (term // k)
            sign = -sign
        return out
    return ((16 * arctan(5) - 4 * arctan(239)) >> 32, 2)


def cosine(a):
    """Of a ball |a| < 4, by halving the angle and Taylor's series."""
    x = (a[0] >> 6, (a[1] >> 6) + 1)
    square, term, out = product(x, x), exact(1), exact(1)
    for k in range(1, 30):
        term = negative(quotient(product(term, square), exact((2 * k - 1) * 2 * k)))
        out = plus(out, term)
    out = (out[0], out[1] + size(term) + 1)
    for _ in range(6):
        out = product(out, out)
        out = less(plus(out, out), exact(1))
    return out
