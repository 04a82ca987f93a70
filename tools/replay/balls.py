"""Interval arithmetic on integers: a ball is (middle, radius), both in units of 2^-P."""
from fractions import Fraction
from math import isqrt
from operator import mul

P = 112  # bits after the point
ONE = 1 << P


def ball(value, radius=0):
    """The rational value, with the rational radius around it."""
    return (int(value * ONE // 1), int(radius * ONE // 1) + 2)


def exact(n):
    return (n * ONE, 0)


def plus(a, b):
    return (a[0] + b[0], a[1] + b[1])


def less(a, b):
    return (a[0] - b[0], a[1] + b[1])


def product(a, b):
    return ((a[0] * b[0]) >> P, ((abs(a[0]) * b[1] + a[1] * (abs(b[0]) + b[1])) >> P) + 2)


def quotient(a, b):
    low = abs(b[0]) - b[1]
    if low <= 0:
        raise ArithmeticError("division by a ball around zero")
    middle = (a[0] << P) // b[0]
    # |a'/b' - middle| <= (|a' - a| + |a - middle b| + |middle| |b - b'|)/low, where |a - middle b| < |b| units
    return (middle, ((a[1] << P) + abs(b[0]) + abs(middle) * b[1]) // low + 1)


def root(a):
    low, high = a[0] - a[1], a[0] + a[1]
    if low <= 0:
        raise ArithmeticError("root of a ball around zero")
    down, up = isqrt(low << P), isqrt(high << P) + 1
    return ((down + up) >> 1, ((up - down) >> 1) + 1)


def size(a):
    return abs(a[0]) + a[1]


def inside(inner, outer):
    """Within the interior."""
    return inner[0] - inner[1] > outer[0] - outer[1] and inner[0] + inner[1] < outer[0] + outer[1]


def meet(a, b):
    return abs(a[0] - b[0]) <= a[1] + b[1]


def hull(a, b):
    low, high = min(a[0] - a[1], b[0] - b[1]), max(a[0] + a[1], b[0] + b[1])
    return ((low + high) >> 1, ((high - low) >> 1) + 1)


def exponential(a):
    """exp by halving until the argument is small, Taylor's series, and squaring."""
    halvings = max(0, (size(a) >> P).bit_length() + 8)
    x = (a[0] >> halvings, (a[1] >> halvings) + 1)
    out, term = exact(1), exact(1)
    for k in range(1, 40):
        term = quotient(product(term, x), exact(k))
        out = plus(out, term)
    out = (out[0], out[1] + size(term) + 1)  # |x| < 1/2: the tail is below the last term
    for _ in range(halvings):
        out = product(out, out)
    return out


# ---- matrices of balls ----

def matmul(A, B):
    return [[sum_of(product(a, B[j][k]) for j, a in enumerate(row)) for k in range(len(B[0]))] for row in A]


def sum_of(balls):
    middle = radius = 0
    for m, r in balls:
        middle += m
        radius += r
    return (middle, radius)


def matadd(A, B):
    return [[plus(a, b) for a, b in zip(x, y)] for x, y in zip(A, B)]


def split(A):
    """Exact middles, and what is left."""
    return [[(a[0], 0) for a in row] for row in A], [[(0, a[1]) for a in row] for row in A]


def unit(n):
    return [[exact(int(i == j)) for j in range(n)] for i in range(n)]


def norm(A):
    return max(sum(size(a) for a in row) for row in A)


def axes_of(A, weights):
    """Nearly orthogonal axes Q, the longest edge first, and an enclosure of their inverse: with Q^T Q = 1 + E, it is
    (1 + E)^-1 Q^T."""
    n = len(A)
    columns = [[A[i][j][0] for i in range(n)] for j in range(n)]
    order = sorted(range(n), key=lambda j: -sum(c * c for c in columns[j]) * weights[j] ** 2)
    out = []
    for j in order:
        c = columns[j]
        for _ in range(2):
            for q in out:
                along = sum(map(mul, c, q)) >> P
                c = [x - (along * y >> P) for x, y in zip(c, q)]
        length = isqrt(sum(x * x for x in c))
        if length == 0:
            return unit(n), unit(n)
        out.append([(x << P) // length for x in c])
    Q = [[(out[j][i], 0) for j in range(n)] for i in range(n)]
    T = [[(out[i][j], 0) for j in range(n)] for i in range(n)]
    E = matmul(T, Q)
    for i in range(n):
        E[i][i] = less(E[i][i], exact(1))
    e = norm(E)
    if e > ONE >> 2:
        return unit(n), unit(n)
    slack = 2 * e * norm(T) // ONE + 1  # |(1 + E)^-1 - 1| <= e/(1 - e) <= 2 e
    return Q, [[(t[0], t[1] + slack) for t in row] for row in T]
