r"""Six rods, or legs, for `check_certificate.py`: their wrenches in a box, from points and axes alone.

The wrench of rod i on the platform is the unit force f_i along it through its end p_i: W_i = (f_i; p_i x f_i), moments
about the mean of the ends. The margin is the s with s^2 = the least value over twists t of |W t|^2 / sum |v_i(t)|^2,
v_i the velocity of p_i; with the columns of K orthonormal in the second form it is the least singular value of W K.
In a box W K = M + D. Let B be near the inverse of M, |1 - B M| <= A_0, |1 - B (M + D)| <= A and |D| <= F in all
entries, alpha_0, alpha and phi the norms of these bounds. If alpha < 1, then W K is regular, and its margin is at least
(1 - alpha) / |B|, and at least (1 - alpha_0) / |B| - phi. |B| <= b is proved by b^2 - B^T B being positive definite.
"""

from __future__ import annotations

import copy
import math
from fractions import Fraction

from certificate_bounds import (
    INF,
    NAMES,
    SIX,
    Beyond,
    Refused,
    U,
    Undefined,
    Value,
    balance,
    branch,
    cosine_of,
    cross,
    dot,
    holds,
    minus,
    mix,
    turns,
)


class Rods:
    """Six rods from the geometry of a certificate."""

    def __init__(self, data):
        q, geometry = data["question"], data["geometry"]
        if len(geometry["rods"]) != 6:
            raise Refused("no independent checker yet for this robot")
        self.free = [NAMES.index(r["coordinate"]) for r in q["over"]]
        if len(set(self.free)) != len(self.free):
            raise Refused("a coordinate occurs twice")
        self.rest = [float(q["rest"].get(n, 0.0)) for n in NAMES]
        missing = [n for k, n in enumerate(NAMES) if k not in self.free and n not in q["rest"]]
        if missing or not all(map(math.isfinite, self.rest)):
            raise Refused("the rest of the pose is missing")
        self.centre, self.rods = [float(c) for c in geometry["centre"]], geometry["rods"]
        points, legs = (q["robot"].get(name) for name in ("points", "legs"))
        points = points or q["robot"].get("home")
        if points and any(
            len(r["names"]) != 2
            or [[float(Fraction(c)) for c in points[n]] for n in r["names"]]
            != [[float(c) for c in e] for e in r["ends"]]
            for r in self.rods
        ):
            raise Refused("the geometry is not that of the robot's points")
        for rod in self.rods:
            if rod["drive"] not in ("leg", "turn", "slide"):
                raise Refused(f"no independent checker yet for a drive that is a {rod['drive']!r}")
        if legs and [[r["drive"], *r["names"]] for r in self.rods] != [["leg", *ends] for ends in legs]:
            raise Refused("the rods are not the robot's legs")
        names = [rod.get("actuator") or "".join(rod["names"]) for rod in self.rods]
        ends = {tuple(rod["ends"][1]) for rod in self.rods}
        middle = [sum(e[j] for e in ends) / len(ends) for j in range(3)]
        about = {"origin": [0.0] * 3, "centroid": middle}.get(str(q["about"]), self.centre)
        if any(abs(a - b) > 1e-9 * (1 + abs(a)) for a, b in zip(about, self.centre)):
            raise Refused("the centre of turns is another one than it is said to be")
        self.words = "of six rods: " + ", ".join(f"{rod['drive']} {rod['names']!r}" for rod in self.rods)
        self.limits = [(-INF, INF)] * 6
        if q["limits"]:
            if len(set(names)) != 6 or set(names) != set(q["limits"]):
                raise Refused("the limits are not those of six drives")
            for name, (low, high) in q["limits"].items():
                ends = (-INF if low is None else low, INF if high is None else high)
                if not ends[0] < ends[1]:
                    raise Refused(f"limits of {name!r} that are none")
                self.limits[names.index(name)] = ends
        self.cones = [[] for _ in SIX]
        for c in q["cones"]:
            k = next((k for k, rod in enumerate(self.rods) if rod["names"] == c["rod"]), None)
            if k is None or c["end"] not in ("base", "platform"):
                raise Refused("a cone of an unknown rod")
            self.cones[k].append((c["end"], cosine_of(c["angle"])))
        self.tilt = None if q["tilt"] is None else cosine_of(q["tilt"])
        self.parts = [self._parts(rod) for rod in self.rods]
        ends = [rod["ends"][1] for rod in self.rods]
        mean = [sum(e[j] for e in ends) / 6 for j in range(3)]
        arms = [minus(e, mean) for e in ends]
        k = balance(arms)
        moments = [[[0, -z, y], [z, 0, -x], [-y, x, 0]] for x, y, z in arms]
        # a row of W K is that of the force times such three rows
        self.wrenches = [
            [[k[j][c] + sum(m[i][j] * k[3 + i][c] for i in range(3)) for c in SIX] for j in range(3)] for m in moments
        ]

    @staticmethod
    def _parts(rod):
        """Numbers for a drive: the rod at home and its length, the axis, what else `look` needs of it."""
        start, end = rod["ends"]
        home = minus(end, start)
        size = math.sqrt(dot(home, home))
        if rod["drive"] == "leg":
            return home, size, None, None
        along = math.sqrt(dot(rod["axis"], rod["axis"]))
        if not 1e-6 < along < 1e6:
            raise Refused("an axis of no length, or of an endless one")
        axis = [c / along for c in rod["axis"]]
        if rod["drive"] == "slide":
            return home, size, axis, branch(dot(home, axis), size)
        height = dot(minus(start, rod["through"]), axis)
        foot = [t + height * a for t, a in zip(rod["through"], axis)]
        radius = minus(start, foot)
        h = math.sqrt(dot(radius, radius))
        one = [c / h for c in radius]
        other = cross(axis, one)
        return home, size, axis, (foot, h, one, other, branch(dot(minus(end, foot), other), size))

    def over(self):
        """The same rods over all coordinates, and their names."""
        found = copy.copy(self)
        found.free = list(SIX)
        return found, NAMES

    def steady(self, forces):
        """Rods have one wrench each, of length 1."""
        return True

    def pose(self, box):
        """The shift of the centre, a number where it does not change, and the rotation."""
        at, none = {k: n for n, k in enumerate(self.free)}, [0.0] * len(self.free)

        def slope(n, by):
            return [by * box.half[j] if j == n else 0.0 for j in range(len(none))]

        shift = [Value(box.middle[at[k]], slope(at[k], 1.0), 0.0) if k in at else self.rest[k] for k in range(3)]
        waves = []
        for k in (3, 4, 5):
            n = at.get(k)
            angle, h = (self.rest[k], 0.0) if n is None else (box.middle[n], box.half[n])
            s, c = math.sin(angle), math.cos(angle)
            waves.append(Value(s, slope(n, c), h * h / 2 * min(1.0, abs(s) + h) + U))
            waves.append(Value(c, slope(n, -s), h * h / 2 * min(1.0, abs(c) + h) + U))
        sr, cr, sp, cp, sy, cy = waves
        a, b = sp * sr, sp * cr
        turn = [
            [cy * cp, cy * a + sy * cr * -1.0, cy * b + sy * sr],
            [sy * cp, sy * a + cy * cr, sy * b + cy * sr * -1.0],
            [sp * -1.0, cp * sr, cp * cr],
        ]
        return shift, turn

    def look(self, box):
        """Whether all poses of a box are outside, whether all are inside, and the rods' forces, None where unknown."""
        shift, turn = self.pose(box)
        inside, forces = True, []
        if self.tilt is not None:
            low, high = (turn[2][2] + -self.tilt).ends()
            if high < -U:
                return True, False, None
            inside = low > U
        for k in SIX:
            try:
                force, leans, amount = self.rod(k, shift, turn)
            except Beyond:
                return True, False, None
            except Undefined:
                forces.append(None)
                continue
            least, most = self.limits[k]
            away, within = True, False
            for low, high in amount:
                away &= high < least - U * 8 or low > most + U * 8
                within |= low > least + U * 8 and high < most - U * 8
            inside &= within
            for value in leans:
                low, high = value.ends()
                away |= high < -U * 8
                inside &= low > U * 8
            if away:
                return True, False, None
            forces.append(force)
        known = None not in forces
        return False, inside and known, forces if known else None

    def holds(self, forces, margin):
        """Whether the margin is at least this one in a box (0: it is regular), as in `holds_matrix`."""
        return holds(self.wrenches, forces, margin)

    def rod(self, k, shift, turn):
        """The unit force in the platform's frame, the cosines of the cones' angles less those allowed, what the
        amount of the drive is between. Raises Undefined where it may not exist; `Beyond` where it does not.
        """
        rod, (home, size, axis, more) = self.rods[k], self.parts[k]
        arm = minus(rod["ends"][1], self.centre)
        carried = [mix(turn[j], arm) for j in range(3)]
        from_ = more[0] if rod["drive"] == "turn" else rod["ends"][0]
        way = [shift[j] + (self.centre[j] - from_[j]) for j in range(3)]  # the end is at way + carried, from there
        square = dot(way, way) + dot(arm, arm) + 2.0 * dot(way, carried)
        free = [c if isinstance(c, Value) else mix(turn[0], (0, 0, 0), c) for c in way]
        far = [carried[j] + way[j] for j in range(3)]
        if rod["drive"] == "leg":
            length = square.root()
            by, rest, amount = length.inverse(), way, [length.ends()]
        elif rod["drive"] == "slide":  # |D - q d| = L, D from the start at home
            along = mix(far, axis)
            under = along * along + square * -1.0 + size * size
            q = along + under.root() * more
            by, amount = 1 / size, [q.ends()]
            rest = [free[j] + q * -axis[j] for j in range(3)]
        else:
            _, h, one, other, sign = more
            u, w = mix(far, one), mix(far, other)
            reach = (square + (h * h - size * size)) * (0.5 / h)
            both = u * u + w * w
            s, over = (both + reach * reach * -1.0).root() * sign, both.inverse()
            cosine, sine = (u * reach + w * s * -1.0) * over, (w * reach + u * s) * over
            by, amount = 1 / size, turns(cosine, sine)
            rest = [mix((free[j], cosine, sine), (1.0, -h * one[j], -h * other[j])) for j in range(3)]
        force = [(turn[0][i] * rest[0] + turn[1][i] * rest[1] + turn[2][i] * rest[2] + arm[i]) * by for i in range(3)]
        leans, unit = [], [c / size for c in home]
        for end, least in self.cones[k]:
            if end == "platform":
                value = mix(force, unit)
            elif rod["drive"] == "turn":  # the direction at home turns with the horn
                a = dot(unit, axis)
                across = [c - a * d for c, d in zip(unit, axis)]
                value = mix(far, across) * cosine + mix(far, cross(axis, across)) * sine
                value = (value + mix(far, [a * c for c in axis], -h * dot(one, unit))) * by
            else:
                value = mix([far[j] + q * -axis[j] for j in range(3)] if axis else far, unit) * by
            leans.append(value + -least)
        return force, leans, amount
