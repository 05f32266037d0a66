"""A platform on six legs and coordinates of poses in certificates, read strictly, and the grid of `check_map.py`."""

from __future__ import annotations

import math
import re
from fractions import Fraction

from certificate_bounds import Refused

TRANSLATION = ("x", "y", "z")
TURNS = {
    **{name: ("vector", k) for k, name in enumerate(("rx", "ry", "rz"))},
    **{name: ("tilt", k) for k, name in enumerate(("azimuth", "tilt", "torsion"))},
    **{name: ("ZYX", k) for k, name in enumerate(("yaw", "pitch", "roll"))},
}
"""The coordinates that turn: of what kind, and which of the three."""
KEYS = {"format", "made by", "title", "unit", "legs", "points", "centre", "pose", "axes", "factors", "cells", "claim"}
KEYS |= {"digest"}
MOST_CELLS = 4_000_000
_NUMBER = re.compile(r"-?[0-9]{1,400}(/[0-9]{1,400})?")


class Malformed(Refused):
    """The file is no certificate of a map that is known here."""


def expect(holds, words):
    if not holds:
        raise Malformed(words)


def whole(value, low, high):
    expect(type(value) is int and low <= value <= high, f"a whole number from {low} to {high} is expected")
    return value


def exact(text):
    expect(isinstance(text, str) and _NUMBER.fullmatch(text), 'a number is expected, as a text such as "-7/20"')
    try:
        return Fraction(text)
    except ZeroDivisionError:
        raise Malformed("a number with denominator 0") from None


def vector(texts, size=3):
    expect(isinstance(texts, list) and len(texts) == size, f"{size} numbers are expected")
    return [exact(c) for c in texts]


def euler(name):
    """The kind and the place of an Euler angle such as zyx1 or ZYZ3; None for another name."""
    letters = name[:3].lower()
    proper = len(name) == 4 and set(letters) <= set("xyz") and letters[0] != letters[1] != letters[2]
    if not proper or name[:3] not in (letters, letters.upper()) or name[3] not in "123":
        return None
    return name[:3], int(name[3]) - 1


class Axis:
    """A coordinate, at node k start + k step."""

    def __init__(self, data, turning=None):
        expect(isinstance(data, dict) and set(data) == {"name", "start", "stop", "number", "unit"}, "not an axis")
        self.name, self.unit = data["name"], data["unit"]
        expect(isinstance(self.name, str) and isinstance(self.unit, str), "an axis without a name")
        if turning is None:
            self.turn = None if self.name in TRANSLATION else TURNS.get(self.name) or euler(self.name)
            expect(self.name in TRANSLATION or self.turn, f"an unknown coordinate {self.name!r}")
        else:
            expect(self.name in turning, f"an unknown actuator {self.name!r}")
            self.turn = turning[self.name]
        expect(not self.turn or self.unit in ("deg", "rad"), "an angle without a unit")
        self.start, stop = exact(data["start"]), exact(data["stop"])
        expect(self.start < stop, "a range that is none")
        self.cells = whole(data["number"], 2, 100_000) - 1
        self.stop, self.step = stop, (stop - self.start) / self.cells
        self.words = f"{self.name} {self.start}..{stop} {self.unit}".strip() + f" in {self.cells} cells"

    @classmethod
    def of_range(cls, data, numbered=False, turning=None):
        """A coordinate as questions have it; one without a number of nodes has two, its ends. Of actuators `turning`
        tells which of them turn.
        """
        keys = {"coordinate": "name", "low": "start", "high": "stop", "unit": "unit"}
        keys |= {"number": "number"} if numbered else {}
        expect(isinstance(data, dict) and set(data) == set(keys), "not an axis")
        return cls({"number": 2, **{keys[k]: v for k, v in data.items()}}, turning)


class Platform:
    """A platform on six legs, all numbers exact: `bases` and `arms` are the ends of legs from the centre."""

    def __init__(self, data):
        unit = data["unit"]
        expect(isinstance(unit, str) and len(unit) < 13 and (unit.isalnum() or not unit), "no unit")
        legs, points = data["legs"], data["points"]
        expect(isinstance(legs, list) and len(legs) == 6 and isinstance(points, dict), "not six legs")
        expect(all(isinstance(p, list) and len(p) == 2 and all(isinstance(n, str) for n in p) for p in legs), "legs")
        base, platform = ({leg[k] for leg in legs} for k in (0, 1))
        expect(not base & platform and base | platform == set(points), "points of the base and of the platform")
        self.length, self.legs, self.points = unit, legs, {n: vector(p) for n, p in points.items()}
        self.centre = vector(data["centre"])
        ends = [[[c - m for c, m in zip(self.points[n], self.centre)] for n in leg] for leg in legs]
        self.bases, self.arms = [e[0] for e in ends], [e[1] for e in ends]

    def check(self, axes):
        """Raises Malformed for coordinates that do not go together."""
        meant = [a.turn or a.name for a in axes]
        expect(len(set(meant)) == len(meant), "a coordinate occurs twice")
        expect(len({(a.turn[0], a.unit) for a in axes if a.turn}) < 2, "turns of several kinds")
        expect(all(a.unit == self.length for a in axes if not a.turn), "lengths in another unit")

    def words(self):
        return [
            "of legs, base first: " + ", ".join(f"{a!r} {b!r}" for a, b in self.legs),
            "points: " + ", ".join(f"{n!r} {' '.join(map(str, p))}" for n, p in self.points.items()),
            f"turned about {' '.join(map(str, self.centre))}",
        ]


class Slice(Platform):
    """The platform and the poses of a map."""

    def __init__(self, data):
        expect(data.get("format") == "gcrules map certificate 1", "no certificate of a map")
        expect(set(data) == KEYS, "names are missing, or there are too many")
        super().__init__(data)
        axes = data["axes"]
        expect(isinstance(axes, list) and 2 <= len(axes) <= 3, "two or three axes are expected")
        self.axes = [Axis(a) for a in axes]
        self.check(self.axes)
        turning = [a for a in self.axes if a.turn]
        pose = data["pose"]
        expect(isinstance(pose, dict) and set(pose) == {"translation", "quaternion", "angles"}, "no pose")
        self.shift = vector(pose["translation"])
        expect((pose["quaternion"] is None) == bool(turning), "a turn is given twice, or not at all")
        expect((pose["angles"] is None) != bool(turning), "angles are given twice, or not at all")
        self.kind, self.unit = (turning[0].turn[0], turning[0].unit) if turning else (None, "")
        self.angles = vector(pose["angles"]) if turning else None
        self.quaternion = None if turning else vector(pose["quaternion"], 4)
        self.turn = None if turning else rotation(self.quaternion)
        self.shape = tuple(a.cells for a in self.axes)
        expect(math.prod(self.shape) <= MOST_CELLS, f"more than {MOST_CELLS:,} cells")

    def words(self):
        rest = [f"{n} {self.shift[k]}" for k, n in enumerate(TRANSLATION) if n not in {a.name for a in self.axes}]
        if self.kind:
            words = f"angles {self.kind} {' '.join(map(str, self.angles))} {self.unit} but for those above"
        else:
            words = f"turned by the quaternion {' '.join(map(str, self.quaternion))}"
        return [
            *super().words(),
            f"over {', '.join(a.words for a in self.axes)}",
            f"at {', '.join([*rest, words])}",
        ]


def rotation(q):
    """The rotation by a quaternion of any length but 0."""
    w, x, y, z = q
    n = w * w + x * x + y * y + z * z
    expect(n, "a quaternion that is 0")
    return [
        [1 - 2 * (y * y + z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n],
        [2 * (x * y + w * z) / n, 1 - 2 * (x * x + z * z) / n, 2 * (y * z - w * x) / n],
        [2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, 1 - 2 * (x * x + y * y) / n],
    ]
