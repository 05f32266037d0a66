r"""The determinant of six legs on a slice whose coordinates turn the platform, for `check_map.py`.

In a box every entry of the matrix W of the rows (f, r x v) is c + sum a_j t_j + e with |t_j| <= 1 and a bound of e, as
in `certificate_bounds.py`: f = r + v along a leg, r from the centre c to the leg's end, v from its base to the centre.
Where |1 - B W| has norm below 1 for all such entries, B near the inverse of W in the middle, each W is regular, and all
determinants have the sign of the one in the middle, which is exact. Turns are products of three turns about coordinate
axes, or 1 + a [r] + b (r r^T - s), s = r r^T, a = sin(q)/q and b = (1 - cos q)/q^2 of q^2 = s, whose second derivatives
by s are at most 1/60 and 1/360. sin and cos are taken to be right to U; angles in degrees are reduced exactly.
"""

from __future__ import annotations

import math
from fractions import Fraction

from certificate_bounds import U, Value, cross, holds_matrix, mix, sign_of
from map_slice import expect

QUARTER = ((1, 0), (0, 1), (-1, 0), (0, -1))  # cosine and sine


def product_of(a, b):
    return [[a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j] for j in range(3)] for i in range(3)]


def about(letter, cosine, sine, none, one):
    """The turn about a coordinate axis."""
    k = "xyz".index(letter)
    i, j = (k + 1) % 3, (k + 2) % 3
    turn = [[one if a == b == k else none for b in range(3)] for a in range(3)]
    turn[i][i] = turn[j][j] = cosine
    turn[i][j], turn[j][i] = sine * -1, sine
    return turn


class Turned:
    """The determinant on a slice with turns; boxes and places are counted in 2^-depth cells."""

    def __init__(self, s):
        self.s, self.known = s, {}
        self.size = max(abs(c) for p in s.bases + s.arms for c in p) or Fraction(1)
        self.arms = [[float(c / self.size) for c in p] for p in s.arms]
        ends = [c for a in s.axes if a.turn for c in (a.start, a.start + a.cells * a.step)]
        expect(
            s.kind != "vector" or max(map(abs, [*s.angles, *ends])) <= {"deg": 720, "rad": 12}[s.unit],
            "a rotation vector that goes round more than twice",
        )

    def _angles(self, place):
        """The shift and the three angles, exact, at a place counted in cells."""
        s = self.s
        shift, angles = list(s.shift), list(s.angles)
        for a, u in zip(s.axes, place):
            value = a.start + u * a.step
            if a.turn:
                angles[a.turn[1]] = value
            else:
                shift["xyz".index(a.name)] = value
        return shift, angles

    def _rows(self, place, half):
        """The matrix around a place, within so much of each axis; the place and `half` are counted in cells."""
        s, none = self.s, [0.0] * len(self.s.axes)
        unit = math.pi / 180 if s.unit == "deg" else 1.0
        shift, angles = self._angles(place)
        turns = [[0.0] * len(none) for _ in range(3)]
        shifts = [[0.0] * len(none) for _ in range(3)]
        for j, (a, h) in enumerate(zip(s.axes, half)):
            if a.turn:
                turns[a.turn[1]][j] = float(h * a.step) * unit * (1 + U)
            else:
                shifts["xyz".index(a.name)][j] = float(h * a.step / self.size) * (1 + U)
        if s.kind == "tilt":  # Rz(azimuth) Ry(tilt) Rz(torsion - azimuth)
            angles[2] -= angles[0]
            turns[2] = [p - q for p, q in zip(turns[2], turns[0])]
        turn = self._vector(angles, turns, unit) if s.kind == "vector" else self._euler(angles, turns, unit)
        rows = []
        for base, arm in zip(s.bases, self.arms):
            r = [mix(turn[i], arm) for i in range(3)]
            way = []
            for i in range(3):
                c = float((shift[i] - base[i]) / self.size)
                way.append(Value(c, shifts[i], U * (abs(c) + sum(shifts[i]))))
            rows.append([*(p + q for p, q in zip(r, way)), *cross_of(r, way)])
        return rows

    def _euler(self, angles, turns, unit):
        s, none = self.s, [0.0] * len(self.s.axes)
        sequence = "ZYZ" if s.kind == "tilt" else s.kind
        zero, one = Value(0.0, none, 0.0), Value(1.0, none, 0.0)
        found = None
        for letter, angle, a in zip(sequence.lower(), angles, turns):
            c = float(angle % 360 if s.unit == "deg" else angle) * unit
            cosine, sine = waves(Value(c, a, U * (1 + abs(c))))
            turn = about(letter, cosine, sine, zero, one)
            if found is None:
                found = turn
            else:  # about axes that turn along, or about fixed ones
                found = product_of(found, turn) if sequence.isupper() else product_of(turn, found)
        return found

    @staticmethod
    def _vector(angles, turns, unit):
        r = []
        for angle, a in zip(angles, turns):
            c = float(angle) * unit
            r.append(Value(c, a, U * (1 + abs(c))))
        s = r[0] * r[0] + r[1] * r[1] + r[2] * r[2]
        a, b = entire(s, *sinc(s.c), 1 / 60), entire(s, *coversed(s.c), 1 / 360)
        x, y, z = r
        skew = [[None, z * -1.0, y], [z, None, x * -1.0], [y * -1.0, x, None]]
        found = []
        for i in range(3):
            row = [b * (r[i] * r[j]) for j in range(3)]
            row = [p if i == j else p + a * skew[i][j] for j, p in enumerate(row)]
            row[i] = row[i] + b * s * -1.0 + 1.0
            found.append(row)
        return found

    def sign(self, depth, low, width):
        """That of all determinants in a box; 0 where it is not known."""
        by = 2 * 2**depth
        rows = self._rows([Fraction(2 * a + w, by) for a, w in zip(low, width)], [Fraction(w, by) for w in width])
        return sign_in(rows)

    def regular(self, low, width):
        """Whether all matrices in a box, counted in cells, are regular, and what keeps from it by coordinates."""
        fine, parts, _ = regular_in(self._rows([a + w / 2 for a, w in zip(low, width)], [w / 2 for w in width]))
        return fine, parts

    def corner(self, depth, place):
        """The sign at a place, None where it is not known."""
        key = tuple(Fraction(u, 2**depth) for u in place)
        if key not in self.known:
            found = sign_in(self._rows(key, [0] * len(key)))
            self.known[key] = found or self._exact(key)
        return self.known[key]

    def _exact(self, place):
        """The sign at a place with quarter turns, None at others."""
        s = self.s
        shift, angles = self._angles(place)
        if s.kind == "tilt":
            angles[2] -= angles[0]
        if s.unit == "deg":
            angles = [c / 90 for c in angles]
        elif any(angles):
            return None
        if any(c.denominator != 1 for c in angles) or (s.kind == "vector" and sum(map(bool, angles)) > 1):
            return None
        sequence = {"tilt": "ZYZ", "vector": "xyz"}.get(s.kind, s.kind)
        turn = [[int(i == j) for j in range(3)] for i in range(3)]
        for letter, c in zip(sequence.lower(), angles):
            one = about(letter, *QUARTER[int(c) % 4], 0, 1)
            turn = product_of(turn, one) if sequence.isupper() else product_of(one, turn)
        return exact_sign(s, turn, shift)


def cross_of(a, b):
    return [a[i] * b[j] + a[j] * b[i] * -1.0 for i, j in ((1, 2), (2, 0), (0, 1))]


def waves(angle):
    """Cosine and sine of an angle."""
    s, c, r = math.sin(angle.c), math.cos(angle.c), angle.reach
    rest = U * (1 + r)
    cosine = Value(c, [-s * x for x in angle.a], abs(s) * angle.e + r * r / 2 * min(1.0, abs(c) + r) + rest)
    sine = Value(s, [c * x for x in angle.a], abs(c) * angle.e + r * r / 2 * min(1.0, abs(s) + r) + rest)
    return cosine, sine


def entire(s, value, slope, curve):
    """A function of s with this value and slope in the middle, whose second derivative is at most `curve` in size."""
    r = s.reach
    return Value(value, [slope * x for x in s.a], abs(slope) * s.e + curve / 2 * r * r + U * (1 + r))


def sinc(s):
    """sin(q)/q with q^2 = s, and its derivative by s."""
    if s < 1:
        terms = [(-1) ** n / math.factorial(2 * n + 1) for n in range(12)]
        return series(terms, s)
    q = math.sqrt(s)
    value = math.sin(q) / q
    return value, (math.cos(q) - value) / (2 * s)


def coversed(s):
    """(1 - cos q)/q^2 with q^2 = s, and its derivative by s."""
    if s < 1:
        return series([(-1) ** n / math.factorial(2 * n + 2) for n in range(12)], s)
    q = math.sqrt(s)
    value = (1 - math.cos(q)) / s
    return value, (math.sin(q) / (2 * q) - value) / s


def series(terms, s):
    return (
        math.fsum(c * s**n for n, c in enumerate(terms)),
        math.fsum(n * c * s ** (n - 1) for n, c in enumerate(terms) if n),
    )


def regular_in(rows):
    """Whether a matrix with bounds is regular, what keeps from it by coordinates, and the matrix in the middle."""
    if not all(math.isfinite(v.c) and math.isfinite(v.reach) for row in rows for v in row):
        return False, None, None
    return holds_matrix(rows, 0.0)


def sign_in(rows):
    """The sign of all determinants of a matrix with bounds, 0 where it is not known."""
    fine, _, middle = regular_in(rows)
    return sign_of(middle) if fine else 0


def exact_sign(s, turn, shift):
    """The sign of the determinant of the rows (f, m) of a platform in an exact pose."""
    rows = []
    for base, arm in zip(s.bases, s.arms):
        r = [sum(p * q for p, q in zip(row, arm)) for row in turn]
        way = [p - q for p, q in zip(shift, base)]
        rows.append([*(p + q for p, q in zip(r, way)), *cross(r, way)])
    return determinant_sign(rows)


def determinant_sign(rows):
    """The sign of the determinant of an exact matrix, 0 too."""
    rows, sign = [list(map(Fraction, row)) for row in rows], 1
    for i in range(len(rows)):
        p = next((k for k in range(i, len(rows)) if rows[k][i]), None)
        if p is None:
            return 0
        if p != i:
            rows[i], rows[p], sign = rows[p], rows[i], -sign
        sign *= 1 if rows[i][i] > 0 else -1
        for k in range(i + 1, len(rows)):
            c = rows[k][i] / rows[i][i]
            rows[k] = [a - c * b for a, b in zip(rows[k], rows[i])]
    return sign


assert all(QUARTER[k] == (round(math.cos(k * math.pi / 2)), round(math.sin(k * math.pi / 2))) for k in range(4))
