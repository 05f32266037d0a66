"""Random vectors, points and screws in both fields."""

from __future__ import annotations

import random
from collections.abc import Callable
from fractions import Fraction
from itertools import combinations
from typing import Any

import pytest

from gcrules.screws import (
    FLOATS,
    RATIONALS,
    RESIDUES,
    Field,
    Limb,
    ScrewSystem,
    joint,
    limb,
    prismatic,
    revolute,
)

__all__ = [
    "FIELDS",
    "LIMBS",
    "O",
    "Random",
    "X",
    "Y",
    "Z",
    "add",
    "cross",
    "dot",
    "driven_rps",
    "fields",
    "leg_of",
    "orthoglide",
    "prs",
    "quaternion",
    "rods",
    "rps",
    "rpur",
    "ruu",
    "span",
    "spherical_rr",
    "spr",
    "sub",
    "times",
    "up",
    "upr",
    "upu",
]

Vec = tuple[Any, ...]
FIELDS = {"rationals": RATIONALS, "residues": RESIDUES, "floats": FLOATS}
X, Y, Z, O = (1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 0, 0)
fields = pytest.mark.parametrize("field", FIELDS.values(), ids=FIELDS)


class Random:
    """Random exact geometry: small fractions, in general position."""

    def __init__(self, seed: Any) -> None:
        self.rng = random.Random(str(seed))

    def scalar(self) -> Fraction:
        return Fraction(self.rng.randint(-9, 9), self.rng.randint(1, 4))

    def vector(self) -> Vec:
        while not any(v := tuple(self.scalar() for _ in range(3))):
            pass
        return v

    def nonzero(self) -> Fraction:
        return Fraction(self.rng.choice([-5, -3, -2, -1, 1, 2, 3, 5]), self.rng.randint(1, 3))

    def vectors(self, count: int) -> list[Vec]:
        """Any three of them independent."""
        while True:
            found = [self.vector() for _ in range(count)]
            if all(dot(a, cross(b, c)) for a, b, c in combinations(found, 3)):
                return found

    def rotation(self) -> list[Vec]:
        """An exact rotation, from a quaternion."""
        a, b, c, d = (self.rng.randint(-4, 4) for _ in range(4))
        return quaternion(a or 1, b, c, d)

    def mixed(self, rows: list[Vec]) -> list[Vec]:
        """Other rows with the same span, one more than needed."""
        while True:
            mixing = [[self.rng.randint(-3, 3) for _ in rows] for _ in range(len(rows) + 1)]
            if RATIONALS.rank(mixing) == len(rows):
                return [tuple(dot(m, column) for column in zip(*rows, strict=True)) for m in mixing]


def quaternion(a: int, b: int, c: int, d: int) -> list[Vec]:
    n = a * a + b * b + c * c + d * d
    rows = (
        (a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)),
        (2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)),
        (2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d),
    )
    return [tuple(Fraction(x, n) for x in row) for row in rows]


def dot(a: Any, b: Any) -> Any:
    return sum(x * y for x, y in zip(a, b, strict=True))


def cross(a: Vec, b: Vec) -> Vec:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def sub(a: Vec, b: Vec) -> Vec:
    return tuple(x - y for x, y in zip(a, b, strict=True))


def add(a: Vec, b: Vec) -> Vec:
    return tuple(x + y for x, y in zip(a, b, strict=True))


def times(s: Any, a: Vec) -> Vec:
    return tuple(s * x for x in a)


def span(rows: Any, field: Field) -> ScrewSystem:
    """In floats the fractions become floats, in residues residues."""
    if field.floating:
        rows = [[float(x) for x in row] for row in rows]
    return ScrewSystem.span(rows, field)


Lines = tuple[Limb, list[Any], str]


def rps(r: Random) -> Lines:
    a, s, axis_ = r.vector(), r.vector(), r.vector()
    leg = limb(
        joint("R", point=a, axis=axis_), joint("P", direction=sub(s, a), actuated=True), joint("S", point=s), name="RPS"
    )
    return leg, [revolute(s, sub(s, a)), revolute(s, axis_)], "planar pencil"


def prs(r: Random) -> Lines:
    a, s, axis_ = r.vector(), r.vector(), r.vector()
    leg = limb(joint("P", direction=r.vector(), actuated=True), joint("R", point=a, axis=axis_), joint("S", point=s))
    return leg, [revolute(s, sub(s, a)), revolute(s, axis_)], "planar pencil"


def driven_rps(r: Random) -> Lines:
    a, s, d = r.vector(), r.vector(), r.vector()
    leg = limb(joint("R", point=a, axis=r.vector(), actuated=True), joint("P", direction=d), joint("S", point=s))
    u, v = cross(d, X), cross(d, Y)
    return leg, [revolute(s, u), revolute(s, v)], "planar pencil"


def upu(r: Random) -> Lines:
    a, b, (u, v) = r.vector(), r.vector(), r.vectors(2)
    leg = limb(
        joint("U", point=a, first=u, second=v),
        joint("P", direction=sub(b, a), actuated=True),
        joint("U", point=b, first=v, second=u),
    )
    return leg, [revolute(a, sub(b, a)), prismatic(cross(u, v))], "force and couple"


def ruu(r: Random) -> Lines:
    a, b, c, (x, z) = r.vector(), r.vector(), r.vector(), r.vectors(2)
    leg = limb(
        joint("R", point=a, axis=z, actuated=True),
        joint("U", point=b, first=z, second=x),
        joint("U", point=c, first=x, second=z),
    )
    return leg, [revolute(b, sub(c, b)), prismatic(cross(z, x))], "force and couple"


def spherical_rr(r: Random) -> Lines:
    o, (u, v, w) = r.vector(), r.vectors(3)
    leg = limb(joint("R", point=o, axis=w, actuated=True), joint("R", point=o, axis=u), joint("R", point=o, axis=v))
    return leg, [*(revolute(o, a) for a in (X, Y, Z)), prismatic(cross(u, v))], "bundle and plane field"


def up(r: Random) -> Lines:
    o, (u, v, w) = r.vector(), r.vectors(3)
    leg = limb(joint("U", point=o, first=u, second=v), joint("P", direction=w))
    forces = [revolute(o, cross(w, a)) for a in r.vectors(2)]
    return leg, [*forces, prismatic(cross(u, v))], "planar pencil and couple"


def upr(r: Random) -> Lines:
    a, b, (u, v) = r.vector(), r.vector(), r.vectors(2)
    leg = limb(
        joint("U", point=a, first=u, second=v),
        joint("P", direction=sub(b, a), actuated=True),
        joint("R", point=b, axis=v),
    )
    return leg, [revolute(a, sub(b, a)), revolute(a, v), prismatic(cross(u, v))], "planar pencil and couple"


def spr(r: Random) -> Lines:
    a, b, s = r.vector(), r.vector(), r.vector()
    leg = limb(joint("S", point=a), joint("P", direction=sub(b, a), actuated=True), joint("R", point=b, axis=s))
    return leg, [revolute(a, sub(b, a)), revolute(a, s)], "planar pencil"


def rpur(r: Random) -> Lines:
    a, b, c, (e, f) = r.vector(), r.vector(), r.vector(), r.vectors(2)
    leg = limb(
        joint("R", point=a, axis=e),
        joint("P", direction=r.vector()),
        joint("U", point=b, first=e, second=f),
        joint("R", point=c, axis=f),
    )
    return leg, [prismatic(cross(e, f))], "couple"


def rods(r: Random) -> Lines:
    a, d, side = r.vector(), *r.vectors(2)
    leg = limb(
        joint("R", point=r.vector(), axis=r.vector(), actuated=True),
        joint("4S", first=a, second=add(a, side), bars=d),
    )
    return leg, [revolute(a, d), revolute(add(a, side), d)], "parallel pencil"


def orthoglide(r: Random) -> Lines:
    a, (d, e, n) = r.vector(), r.vectors(3)
    leg = limb(
        joint("P", direction=r.vector(), actuated=True),
        joint("R", point=a, axis=e),
        joint("Pa", bars=d, axis=n),
        joint("R", point=add(a, times(r.nonzero(), d)), axis=e),
    )
    normal = [prismatic(cross(e, x)) for x in r.vectors(2)]
    return leg, [revolute(a, d), *normal], "force and two couples"


LIMBS: dict[str, Callable[[Random], Lines]] = {
    "RPS, P actuated": rps,
    "PRS, P actuated": prs,
    "RPS, R actuated": driven_rps,
    "UPU, parallel pairs": upu,
    "RUU, Schönflies": ruu,
    "RR, spherical": spherical_rr,
    "UP, passive": up,
    "UPR": upr,
    "SPR": spr,
    "RPUR, 3T2R": rpur,
    "two rods with ball ends": rods,
    "R-Pa-R, Orthoglide": orthoglide,
}


def leg_of(kinds: str, r: Random, *, base: Vec | None = None, top: Vec | None = None) -> Limb:
    """A leg like "UPS" or "RPS" from a random point to another, the slider along it and actuated."""
    a, b = base or r.vector(), top or r.vector()
    middle = joint("P", direction=sub(b, a), actuated=True)
    u, v = r.vectors(2)
    ends = {"U": {"first": u, "second": v}, "R": {"axis": u}, "S": {}}
    first, _, last = kinds
    return limb(joint(first, point=a, **ends[first]), middle, joint(last, point=b, **ends[last]))
