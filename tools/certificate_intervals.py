"""Intervals with derivatives, and norms of matrices, for `check_certificate.py`, which says what they are for."""

from __future__ import annotations

import math

INF = math.inf
EPS = 2.0**-48


def down(x):
    return math.nextafter(x, -INF)


def up(x):
    return math.nextafter(x, INF)


def add(a, b):
    return down(a[0] + b[0]), up(a[1] + b[1])


def mul(a, b):
    p, q, r, s = a[0] * b[0], a[0] * b[1], a[1] * b[0], a[1] * b[1]
    return down(min(p, q, r, s)), up(max(p, q, r, s))


def point(x):
    return (x, x)


class Undefined(Exception):
    """A root or a quotient that may not exist in a box."""


class Box:
    """Coordinates that are free in `low`..`high`; others have their values."""

    def __init__(self, low, high):
        self.low, self.high = low, high
        self.middle = [(a + b) / 2 for a, b in zip(low, high)]
        self.half = [
            up(max(b - m, m - a) * (1 + EPS) + EPS * max(abs(a), abs(b))) for a, b, m in zip(low, high, self.middle)
        ]

    def cut(self, k):
        middle = self.middle[k]
        high, low = list(self.high), list(self.low)
        high[k] = low[k] = middle
        return Box(self.low, high), Box(low, self.high)


class Value:
    """m in the middle, r over the box, g the derivatives there (None for constants)."""

    __slots__ = ("g", "half", "m", "r")

    def __init__(self, m, r, g, half):
        self.m, self.g, self.half = m, g, half
        if g is not None:
            reach = 0.0
            for d, h in zip(g, half):
                reach = up(reach + up(max(abs(d[0]), abs(d[1])) * h))
            r = max(r[0], down(m[0] - reach)), min(r[1], up(m[1] + reach))
        self.r = r

    def __add__(self, other):
        if not isinstance(other, Value):
            c = point(other)
            return Value(add(self.m, c), add(self.r, c), self.g, self.half)
        if self.g is None or other.g is None:
            g = self.g or other.g
        else:
            g = [add(a, b) for a, b in zip(self.g, other.g)]
        return Value(add(self.m, other.m), add(self.r, other.r), g, self.half)

    def __mul__(self, other):
        if not isinstance(other, Value):
            c = point(other)
            g = None if self.g is None else [mul(a, c) for a in self.g]
            return Value(mul(self.m, c), mul(self.r, c), g, self.half)
        parts = [[mul(a, v.r) for a in u.g] for u, v in ((self, other), (other, self)) if u.g is not None]
        g = None if not parts else parts[0] if len(parts) == 1 else [add(a, b) for a, b in zip(*parts)]
        return Value(mul(self.m, other.m), mul(self.r, other.r), g, self.half)

    def __neg__(self):
        g = None if self.g is None else [(-b, -a) for a, b in self.g]
        return Value((-self.m[1], -self.m[0]), (-self.r[1], -self.r[0]), g, self.half)

    def __sub__(self, other):
        return self + (-other)

    def root(self):
        if self.r[0] <= 0:
            raise Undefined
        m, r = ((down(math.sqrt(a)), up(math.sqrt(b))) for a, b in (self.m, self.r))
        slope = down(0.5 / r[1]), up(0.5 / r[0])
        return Value(m, r, None if self.g is None else [mul(a, slope) for a in self.g], self.half)

    def inverse(self):
        if self.r[0] <= 0 <= self.r[1]:
            raise Undefined
        m, r = ((down(1 / b), up(1 / a)) for a, b in (self.m, self.r))
        slope = mul(r, r)
        return Value(m, r, None if self.g is None else [mul(a, (-slope[1], -slope[0])) for a in self.g], self.half)


def dot(a, b):
    found = a[0] * b[0]
    return found + a[1] * b[1] + a[2] * b[2]


def flat(a, b):
    """The product of a vector of values and one of numbers."""
    terms = [x * c for x, c in zip(a, b) if c]
    found = terms[0]
    for t in terms[1:]:
        found = found + t
    return found


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def wave(box, k, angle, shift):
    """sin(angle + shift pi/2)."""
    m, h = angle, box.half[k] if k is not None else 0.0

    def near(x):
        c = (math.sin, math.cos)[shift % 2](x) * (1, 1, -1, -1)[shift % 4]
        return down(c - EPS), up(c + EPS)

    if k is None:
        return Value(near(m), near(m), None, box.half)
    (a, b), (c, d) = near(m), near_slope(m, shift)
    reach = up(h * 1.0)
    slope = max(down(c - reach), -1.0), min(up(d + reach), 1.0)
    zero = (0.0, 0.0)
    g = [slope if j == k else zero for j in range(len(box.half))]
    return Value((a, b), (max(down(a - reach), -1.0), min(up(b + reach), 1.0)), g, box.half)


def near_slope(x, shift):
    c = (math.cos, math.sin)[shift % 2](x) * (1, -1, -1, 1)[shift % 4]
    return down(c - EPS), up(c + EPS)


def times(a, b):
    columns = list(zip(*b))
    return [[sum(x * y for x, y in zip(row, col)) for col in columns] for row in a]


def inverse(a):
    n = len(a)
    rows = [[*row, *((1.0 if i == j else 0.0) for j in range(n))] for i, row in enumerate(a)]
    for i in range(n):
        p = max(range(i, n), key=lambda k: abs(rows[k][i]))
        if rows[p][i] == 0:
            return None
        rows[i], rows[p] = rows[p], rows[i]
        by = rows[i][i]
        rows[i] = [x / by for x in rows[i]]
        for k in range(n):
            if k != i and rows[k][i]:
                c = rows[k][i]
                rows[k] = [x - c * y for x, y in zip(rows[k], rows[i])]
    return [row[n:] for row in rows]


def sizes(a):
    return [[abs(x) for x in row] for row in a]


def plus(a, b):
    return [[x + y for x, y in zip(*xy)] for xy in zip(a, b)]


def norm(a):
    """No less than the largest singular value of matrices with entries of these sizes."""
    return math.sqrt(max(map(sum, a)) * max(map(sum, zip(*a)))) * (1 + 1e-12)


def spectral(b):
    """No less than the largest singular value of b: |(b b^T)^64|^(1/128), in the norm of Frobenius."""
    power, found = times(b, list(zip(*b))), 1.0
    for k in range(6):
        size = math.sqrt(sum(x * x for row in power for x in row))
        found *= size ** (0.5 ** (k + 1))
        power = [[x / size for x in row] for row in power]
        power = times(power, power)
    return found * math.sqrt(sum(x * x for row in power for x in row)) ** (0.5**7) * (1 + 1e-9)


def by_rows(whole, back):
    """1/|v| with v >= A v + l."""
    lengths = [math.sqrt(sum(x * x for x in row)) for row in back]
    v = lengths
    for _ in range(60):
        new = [sum(a * x for a, x in zip(row, v)) + c for row, c in zip(whole, lengths)]
        if max(new) > 1e9 * max(lengths):
            return 0.0
        done = max(abs(a - b) for a, b in zip(new, v)) <= 1e-4 * max(new)
        v = new
        if done:
            break
    v = [x * 1.001 for x in v]
    if any(x < (sum(a * y for a, y in zip(row, v)) + c) * (1 + 1e-12) for x, row, c in zip(v, whole, lengths)):
        return 0.0
    return (1 - 1e-9) / math.sqrt(sum(x * x for x in v))


class Beyond(Exception):
    """A rod that reaches no pose of a box."""


def check(under):
    if under.r[1] < 0:
        raise Beyond


def span(amount):
    """The interval of an amount; of a turn from its cosine and sine."""
    if isinstance(amount, Value):
        return amount.r
    c, s = amount
    at = math.atan2(s.m[0], c.m[0])
    off = s * math.cos(at) - c * math.sin(at)
    along = c * math.cos(at) + s * math.sin(at)
    far = max(abs(off.r[0]), abs(off.r[1])) + EPS
    if along.r[0] <= 0 or far >= 1:
        return -10.0, 10.0
    half = math.asin(far) + EPS
    return at - half, at + half


def least_margin(scale, rows, half):
    """What the margin is at least in a box; 0 where nothing is proved. And how much each coordinate keeps from it."""
    n = len(half)
    middle = [[(c.m[0] + c.m[1]) / 2 for c in row] for row in rows]
    off = [[(c.m[1] - c.m[0]) for c in row] for row in rows]
    scaled = times(middle, scale)
    back = inverse(scaled)
    if back is None:
        return 0.0, [1.0] * n
    size, k_size = sizes(back), sizes(scale)
    start = sizes([[(i == j) - x for j, x in enumerate(row)] for i, row in enumerate(times(back, scaled))])
    whole, far, rest, most, parts = start, [[0.0] * 6 for _ in start], off, sizes(middle), []
    for j in range(n):
        slope = [[(0.0, 0.0) if c.g is None else c.g[j] for c in row] for row in rows]
        centre = [[(a + b) / 2 * half[j] for a, b in row] for row in slope]
        rest = [[r + (b - a) * 0.5001 * half[j] for r, (a, b) in zip(*rr)] for rr in zip(rest, slope)]
        most = plus(most, sizes(centre))
        moved = times(centre, scale)
        part = sizes(times(back, moved))
        parts.append(norm(part))
        whole, far = plus(whole, part), plus(far, sizes(moved))
    rest = times([[r * (1 + 1e-9) + 1e-13 * m for r, m in zip(*rm)] for rm in zip(rest, most)], k_size)
    more = times(size, rest)
    whole, far, start = plus(whole, more), plus(far, rest), plus(start, more)
    large = spectral(back)
    found = max((1 - norm(whole)) / large, (1 - norm(start)) / large - norm(far))
    return max(found * (1 - 1e-9), by_rows(whole, back), 0.0), parts
