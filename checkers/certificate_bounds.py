"""Values in a box with bounds of what they leave out, and margins, for `check_certificate.py`, which explains them.

Numbers that are too large become NaN, which is neither above nor below anything: whatever proves something asks for a
comparison that holds, never for one that does not.
"""

from __future__ import annotations

import math
from fractions import Fraction

INF = math.inf
U = 2.0**-46
SIX = range(6)
NAMES = ("x", "y", "z", "roll", "pitch", "yaw")


class Refused(Exception):
    """The certificate does not hold, or is none."""


class Undefined(Exception):
    """A root or a quotient that may not exist in a box."""


class Beyond(Exception):
    """A rod that reaches no pose of a box."""


class Value:
    """c + sum a_j t_j + r with |t_j| <= 1 and |r| <= e; it differs from c by `reach` at most."""

    __slots__ = ("a", "c", "e", "reach")

    def __init__(self, c, a, e):
        self.c, self.a, self.e = c, a, e
        self.reach = (sum(map(abs, a)) + e) * (1 + U)

    def ends(self):
        slack = self.reach + U * (abs(self.c) + self.reach)
        return self.c - slack, self.c + slack

    def __add__(self, other):
        if not isinstance(other, Value):
            return Value(self.c + other, self.a, self.e + U * (abs(self.c) + abs(other)))
        e = self.e + other.e + U * (abs(self.c) + self.reach + abs(other.c) + other.reach)
        return Value(self.c + other.c, [x + y for x, y in zip(self.a, other.a)], e)

    def __mul__(self, other):
        p = self.c
        if not isinstance(other, Value):
            e = abs(other) * (self.e + U * (abs(p) + self.reach))
            return Value(p * other, [x * other for x in self.a], e)
        q, r, s = other.c, self.reach, other.reach
        if other is self:  # the square of what is left is between 0 and that of the reach
            half = 0.5 * r * r
            e = 2 * abs(p) * self.e + half + U * (abs(p) + r) ** 2
            return Value(p * p + half, [2 * p * x for x in self.a], e)
        e = abs(p) * other.e + abs(q) * self.e + r * s + U * (abs(p) + r) * (abs(q) + s)
        return Value(p * q, [p * y + q * x for x, y in zip(self.a, other.a)], e)

    __radd__, __rmul__ = __add__, __mul__

    def bent(self, value, slope, curve):
        """A function with this value and slope in the middle, half its second derivative between 0 and `curve`."""
        more = curve * self.reach * self.reach / 2
        e = abs(more) + abs(slope) * self.e + U * (abs(value) + abs(slope) * self.reach + abs(more))
        return Value(value + more, [slope * x for x in self.a], e)

    def root(self):
        low, high = self.ends()
        if high < 0:
            raise Beyond
        if not low > 0:
            raise Undefined
        value = math.sqrt(self.c)
        return self.bent(value, 0.5 / value, -0.125 / (low * math.sqrt(low)))

    def inverse(self):
        low = self.ends()[0]
        if not low > 0:
            raise Undefined
        return self.bent(1 / self.c, -1 / (self.c * self.c), 1 / low**3)


def mix(values, by, more=0.0):
    """The values times numbers, and one more."""
    terms = [(v, k) for v, k in zip(values, by) if k]
    if not terms:
        return Value(more, [0.0] * len(values[0].a), U * abs(more))
    e = sum([abs(k) * (v.e + U * (abs(v.c) + v.reach)) for v, k in terms]) + U * abs(more)
    a = [sum(c) for c in zip(*[[k * x for x in v.a] for v, k in terms])]
    return Value(sum([k * v.c for v, k in terms]) + more, a, e)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


class Box:
    """Coordinates between `low` and `high`."""

    def __init__(self, low, high):
        self.low, self.high = low, high
        self.middle = [(a + b) / 2 for a, b in zip(low, high)]
        self.half = [max(b - m, m - a) + U * max(abs(a), abs(b)) for a, b, m in zip(low, high, self.middle)]

    def cut(self, k):
        high, low = list(self.high), list(self.low)
        high[k] = low[k] = self.middle[k]
        return Box(self.low, high), Box(low, self.high)


def turns(cosine, sine):
    """What an angle is between, and a turn less and more."""
    at = math.atan2(sine.c, cosine.c)
    c, s = math.cos(at), math.sin(at)
    far = max(map(abs, mix((sine, cosine), (c, -s)).ends())) + U
    if mix((cosine, sine), (c, s)).ends()[0] <= 0 or far >= 1:
        return [(-INF, INF)]
    half = math.asin(far) + U
    return [(at - half + turn, at + half + turn) for turn in (-2 * math.pi, 0.0, 2 * math.pi)]


def cholesky(a, floor):
    """The lower factor; None where a pivot is not above `floor`."""
    low = [[0.0] * len(a) for _ in a]
    for i in range(len(a)):
        for j in range(i + 1):
            rest = a[i][j] - sum([x * y for x, y in zip(low[i][:j], low[j])])
            if i == j and not rest > floor:
                return None
            low[i][j] = math.sqrt(rest) if i == j else rest / low[j][j]
    return low


def inverse(a):
    size = range(len(a))
    rows = [[*row, *((1.0 if i == j else 0.0) for j in size)] for i, row in enumerate(a)]
    for i in size:
        p = max(range(i, len(a)), key=lambda k: abs(rows[k][i]))
        if rows[p][i] == 0:
            return None
        rows[i], rows[p] = rows[p], rows[i]
        by = 1 / rows[i][i]
        top = rows[i] = [x * by for x in rows[i]]
        for k in size:
            if k != i and rows[k][i]:
                c = rows[k][i]
                rows[k] = [x - c * y for x, y in zip(rows[k], top)]
    return [row[len(a) :] for row in rows]


def times(a, b):
    columns = list(zip(*b))
    return [[sum([x * y for x, y in zip(row, col)]) for col in columns] for row in a]


def sizes(a):
    return [[abs(x) for x in row] for row in a]


def plus(a, b):
    return [[x + y for x, y in zip(*xy)] for xy in zip(a, b)]


def norm(a):
    """No less than the largest singular value of matrices with entries of these sizes: for all x > 0 the largest
    eigenvalue of a^T a is at most max (a^T a x)_i / x_i. Endless where numbers are too large, or none.
    """
    x, across = [1.0] * len(a[0]), list(zip(*a))
    for _ in range(4):
        y = [sum([p * q for p, q in zip(row, x)]) for row in a]
        new = [sum([p * q for p, q in zip(row, y)]) + 1e-200 for row in across]
        if not all(c < INF for c in new):
            return INF
        found = max([p / q for p, q in zip(new, x)])
        x = new
    return math.sqrt(found) * (1 + 1e-9)


def radius(a):
    """No less than the largest eigenvalue in size of matrices with entries of these sizes: for all x > 0 this is at
    most max (a x)_i / x_i. Where it is below 1 no 1 - E with |E| <= a is singular.
    """
    if not all(0 <= c < 1e100 for row in a for c in row):
        return INF
    x = [1.0] * len(a)
    for _ in range(6):
        x = [sum([p * q for p, q in zip(row, x)]) + 0.1 * q for row, q in zip(a, x)]
        top = max(x)
        x = [c / top + 1e-6 for c in x]
    return max([sum([p * q for p, q in zip(row, x)]) / q for row, q in zip(a, x)]) * (1 + 1e-9)


def holds(wrenches, forces, margin):
    """Whether the margin of rods is at least this one in a box, as in `holds_matrix`; what keeps from it; and M."""

    def wrench(of, by=wrenches):  # rows of forces times K, and its moments
        return [[sum([f * k for f, k in zip(force, col)]) for col in zip(*rows)] for force, rows in zip(of, by)]

    known = [sizes(rows) for rows in wrenches]
    middle = wrench([[f.c for f in force] for force in forces])
    rest = wrench([[f.e + U * (abs(f.c) + f.reach) for f in force] for force in forces], known)
    moves = (wrench([[f.a[j] for f in force] for force in forces]) for j in range(len(forces[0][0].a)))
    return _holds(middle, rest, moves, margin)


def holds_matrix(matrix, margin):
    """Whether the least singular value of a matrix is at least this one in a box (0: its columns are independent); what
    keeps from it by coordinates; and the matrix in the middle.
    """
    middle = [[v.c for v in row] for row in matrix]
    rest = [[v.e + U * (abs(v.c) + v.reach) for v in row] for row in matrix]
    moves = ([[v.a[j] for v in row] for row in matrix] for j in range(len(matrix[0][0].a)))
    return _holds(middle, rest, moves, margin)


def _holds(middle, rest, moves, margin):
    across = list(zip(*middle))
    back = inverse(middle) if len(middle) == len(across) else inverse(times(across, middle))
    if back is None:
        return False, None, middle
    if len(middle) != len(across):
        back = times(back, across)
    size, off = sizes(back), [[(i == j) - x for j, x in enumerate(row)] for i, row in enumerate(times(back, middle))]
    start = plus(sizes(off), times(size, rest))
    whole, far, parts = start, rest, []
    for moved in moves:
        part = sizes(times(back, moved))
        parts.append(sum([x * x for row in part for x in row]))
        whole, far = plus(whole, part), plus(far, sizes(moved))
    alpha = norm(whole)
    if not alpha < 1 or not margin:
        return alpha < 1 or (not margin and radius(whole) < 1), parts, middle
    most = max((1 - alpha) / margin, (1 - norm(start)) / (margin + norm(far))) * (1 - 1e-9)
    square = times(back, list(zip(*back)))
    slack = 1e-10 * sum([square[i][i] for i in range(len(square))])
    rest = [[(most * most if i == j else 0.0) - x for j, x in enumerate(row)] for i, row in enumerate(square)]
    return cholesky(rest, slack) is not None, parts, middle


def least_value(a):
    """No less than the least singular value of a matrix of floats: how long a row of length 1 becomes, one for which
    that is near the least.
    """
    across = list(zip(*a))
    square = times(across, a)
    for i in range(len(square)):
        square[i][i] += 1e-18
    back, x = inverse(square), [1.0] * len(square)
    for _ in range(40):
        x = [sum([p * q for p, q in zip(row, x)]) for row in back]
        size = math.sqrt(sum([c * c for c in x]))
        x = [c / size for c in x]
    return math.sqrt(sum([sum([p * q for p, q in zip(row, x)]) ** 2 for row in a])) * (1 + 1e-9)


def balance(arms):
    """K: columns orthonormal in sum |v_i|^2, v_i = v + w x arm."""
    rows = []
    for x, y, z in arms:
        rows += [[1, 0, 0, 0, z, -y], [0, 1, 0, -z, 0, x], [0, 0, 1, y, -x, 0]]
    return balance_of(rows)


def balance_of(rows):
    """Columns that are orthonormal in the sum of the squares of these rows, by Cholesky, and then compared exactly."""
    size = range(len(rows[0]))
    exact = [[sum(Fraction(r[i]) * Fraction(r[j]) for r in rows) for j in size] for i in size]
    low = cholesky([[float(c) for c in row] for row in exact], 0.0)
    if low is None:
        raise Refused("the ends on the platform lie on one line")
    scale = [[0.0] * len(size) for _ in size]  # the transposed inverse of low
    for c in size:
        for i in range(c, len(size)):
            scale[c][i] = ((i == c) - sum(low[i][k] * scale[c][k] for k in range(c, i))) / low[i][i]
    k = [[Fraction(x) for x in row] for row in scale]
    half = [[sum(exact[a][b] * k[b][j] for b in size) for j in size] for a in size]
    for i in size:
        for j in size:
            if abs(sum(k[a][i] * half[a][j] for a in size) - (i == j)) > Fraction(1, 10**10):
                raise Refused("the balance of the margin is not computed well enough")
    return scale


def cosine_of(angle):
    """The cosine of a cone's angle. Raises Refused where this is not between 0 and half a turn."""
    if not 0 < angle < math.pi:
        raise Refused(f"a cone of {angle} rad")
    return math.cos(angle)


def branch(at_home, size):
    """Of two solutions of a drive the one at home. Raises Refused where they are not apart there."""
    if abs(at_home) < 1e-6 * size:
        raise Refused("home is a dead point of a drive")
    return -1.0 if at_home > 0 else 1.0


def once(pairs):
    """An object whose names all differ; NaN and Infinity, which are names of no numbers, come here as text."""
    if isinstance(pairs, str) or len(dict(pairs)) != len(pairs):
        raise Refused("a name twice, or a number that is none")
    return dict(pairs)


def sign_of(rows):
    """The sign of the determinant of a matrix of floats that is regular, exact."""
    rows, value = [[Fraction(c) for c in row] for row in rows], 1
    for i in range(len(rows)):
        p = next(k for k in range(i, len(rows)) if rows[k][i])
        value *= (1 if rows[p][i] > 0 else -1) * (1 if p == i else -1)
        rows[i], rows[p] = rows[p], rows[i]
        for k in range(i + 1, len(rows)):
            c = rows[k][i] / rows[i][i]
            rows[k] = [a - c * b for a, b in zip(rows[k], rows[i])]
    return value


def leaves_of(tree, whole, share):
    """The boxes of the tree that are not cut, with their letters; `share` adds up what those of each letter fill."""
    waiting = [(whole, Fraction(1))]
    for place, letter in enumerate(tree):
        if not waiting:
            raise Refused("the tree goes on after its end")
        box, part = waiting.pop()
        if letter.isdigit() and int(letter) < len(whole.low):
            first, second = box.cut(int(letter))
            waiting += [(second, part / 2), (first, part / 2)]
            continue
        if letter not in share:
            raise Refused(f"{letter!r} in the tree")
        share[letter] += part
        yield place, letter, box.low, box.high
    if waiting:
        raise Refused("the tree ends too soon: boxes are missing")


def all_inside(robot, box, cuts):
    """Whether all poses of a box are reached within the limits, and no limb is singular there: then the determinant
    changes its sign only where it is 0.
    """
    _, inside, forces = robot.look(box)
    if inside and forces is not None and robot.steady(forces):
        return True
    return cuts > 0 and all(all_inside(robot, part, cuts - 1) for part in box.cut(box.half.index(max(box.half))))
