r"""Planar robots on three legs of variable length: their dimensions, exact, and their singular lengths.

>>> from gcrules.mechanisms.mechanism import mechanism
>>> three_legs(mechanism("3-rpr")).squares
(Fraction(25, 4), Fraction(5, 1), Fraction(4, 1))
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import isqrt, lcm

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.limb_file import LimbSpec
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import Mechanism
from gcrules.poses.length_regions.closing import Closing
from gcrules.poses.length_regions.curve import SingularCurve

__all__ = ["ThreeLegs", "three_legs"]

_PARTS = 30  # of the squares of reachable lengths, between places where the curve is evaluated
_HINT = "each limb is a leg R(A, z) P*(A B) R(B, z) of a robot in the plane, such as 3-rpr"

Place = tuple[Fraction, Fraction]


@dataclass(frozen=True)
class ThreeLegs:
    """The ends of the legs at home on the base and on the platform, and the `names` of their actuators; `forward` is 1
    where an actuator lengthens its leg and −1 where it shortens it.
    """

    title: str
    names: tuple[str, str, str]
    base: tuple[Place, Place, Place]
    platform: tuple[Place, Place, Place]
    forward: tuple[int, int, int]

    @property
    def squares(self) -> tuple[Fraction, Fraction, Fraction]:
        """Of the lengths at home."""
        one, two, three = (_square(a, b) for a, b in zip(self.base, self.platform, strict=True))
        return one, two, three

    def reach(self, k: int, other: int, square: Fraction) -> Fraction:
        """A length that leg k cannot have while the other one has this square of its length: a little more than it
        can.
        """
        sides = (_square(points[k], points[other]) for points in (self.base, self.platform))
        most = sum((_root(s) for s in (square, *sides)), Fraction(0))
        parts = 20  # of a unit, finer for small robots
        while most * parts < 20:
            parts *= 10
        return Fraction(int(most * parts * 21 / 20) + 1, parts)

    def closing(self, denominator: int = 1) -> tuple[Closing, int]:
        """In whole coordinates, and how many times as large they are: by a multiple of the denominator."""
        both = (*self.base, *self.platform)
        scale = lcm(denominator, *(c.denominator for p in both for c in p))
        parts = [[_whole(p[k], p[0], scale) for k in (1, 2)] for p in (self.base, self.platform)]
        return Closing.of(*parts), scale

    def modes(self, squares: Sequence[Fraction]) -> int | None:
        """The number of assembly modes for lengths with these squares, which are not singular; exact. None where two
        modes have the same turn.
        """
        closing, scale = self.closing()
        return closing.modes([s * scale * scale for s in squares])

    def curve(self, free: tuple[int, int], square: Fraction, most: Fraction) -> tuple[SingularCurve, int]:
        """The singular lengths over two legs, as a curve in the squares of their lengths times the number beside it,
        the third one held at this square; its values are taken up to lengths of that square or so.

        Raises InputError where they are no such curve.
        """
        closing, scale = self.closing(square.denominator)
        held = next(k for k in range(3) if k not in free)
        whole = int(square * scale * scale)

        def value(x: int, y: int) -> Fraction | None:
            squares = [whole] * 3
            squares[free[0]], squares[free[1]] = x, y
            squares[held] = whole
            return closing.singular(squares)

        found = SingularCurve.of(value, max(1, int(most * scale * scale) // _PARTS))
        if found is None or found.elimination is None:
            raise InputError(
                (
                    f"{self.title}: the singular lengths are not a curve without multiple parts: the dimensions"
                    " are special"
                ),
                hint="hold another leg, or change the dimensions or the length that is held by a little",
            )
        return found, scale * scale


def three_legs(m: Mechanism) -> ThreeLegs:
    """Raises InputError, which says why, for other mechanisms."""
    what = "regions of lengths are for planar robots on three legs of variable length"
    if not isinstance(m, Limbs):
        raise InputError(f"{what}; this is a platform on six legs", hint=_HINT)
    robot = m.robot
    reason = ""
    if not robot.family.plane:
        reason = "it moves in space"
    elif len(robot.limbs) != 3:
        reason = f"it has {len(robot.limbs) or 'no'} limbs"
    elif robot.home is None:
        reason = "it has no home configuration"
    legs = [_leg(limb) for limb in robot.limbs]
    other = next((limb for limb, leg in zip(robot.limbs, legs, strict=True) if leg is None), None)
    if not reason and other is not None:
        reason = f"{other.name or 'a limb'} ({other.chain}) is not a leg RP*R whose ends the slide joins"
    if reason:
        raise InputError(f"{what}; {robot.id}: {reason}", hint=_HINT)
    values = robot.values_at()
    found = [leg for leg in legs if leg is not None]
    one, two, three = ((values[a], values[b], way) for a, b, way in found)
    first, second, third = m.actuators
    return ThreeLegs(
        title=m.title,
        names=(first, second, third),
        base=(_flat(one[0]), _flat(two[0]), _flat(three[0])),
        platform=(_flat(one[1]), _flat(two[1]), _flat(three[1])),
        forward=(one[2], two[2], three[2]),
    )


def _leg(limb: LimbSpec) -> tuple[str, str, int] | None:
    """The ends of the leg, and whether its actuator makes it longer."""
    if [j.kind for j in limb.joints] != ["R", "P", "R"] or limb.subchains or limb.couplings or limb.cable:
        return None
    first, slide, last = limb.joints
    if first.actuated or last.actuated or not slide.actuated:
        return None
    (start,), (end,), (along,) = first.points, last.points, slide.directions
    shares = {name: c for c, name in along}
    if start == end or set(shares) != {start, end} or shares[start] + shares[end]:
        return None
    return start, end, 1 if shares[end] > 0 else -1


def _flat(point: Sequence[Fraction]) -> Place:
    return Fraction(point[0]), Fraction(point[1])


def _square(a: Place, b: Place) -> Fraction:
    return (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2


def _root(x: Fraction) -> Fraction:
    """Not less than the square root, by less than a thousandth of it or so."""
    fine = 1 << 40
    return Fraction(isqrt(int(x * fine * fine)) + 1, fine)


def _whole(p: Place, origin: Place, scale: int) -> tuple[int, int]:
    return int((p[0] - origin[0]) * scale), int((p[1] - origin[1]) * scale)
