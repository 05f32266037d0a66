r"""A robot that can be moved: which joints belong to the platform, where they are in the file, and in a pose."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.algebra.language.legs_text import Structure, leg_text
from gcrules.conditions.pose_value import Coordinates
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.floats import decimal
from gcrules.core.frozen import FrozenMap
from gcrules.core.linear_algebra import kernel
from gcrules.screws.pose import FAR, Pose, too_far
from gcrules.screws.pose_text import read_centre
from gcrules.screws.rotations import Vector

__all__ = ["MovingPlatform", "rig"]

Floats = NDArray[np.float64]

ORIGIN: Vector = (Fraction(0), Fraction(0), Fraction(0))


@dataclass(frozen=True)
class MovingPlatform:
    """Six legs between a base that stays and a platform that moves; the file's coordinates are the identity pose.

    A pose moves each joint p of the platform to R(p − c) + c + t, c being `centre` (exact, in `unit`).
    """

    structure: Structure
    points: Mapping[str, Vector]
    centre: Vector = ORIGIN
    unit: str = ""
    title: str = ""

    def __post_init__(self) -> None:
        object.__setattr__(self, "points", FrozenMap(self.points))

    @property
    def legs(self) -> tuple[tuple[str, str], ...]:
        """The legs with the base joint first."""
        return self.structure.oriented

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Each leg as it is written."""
        return tuple(map(leg_text, self.structure.legs))

    @cached_property
    def base(self) -> Floats:
        """The base ends of the legs, shape (6, 3)."""
        return np.array([[float(c) for c in self.points[a]] for a, _ in self.legs])

    @cached_property
    def centre_of_turns(self) -> Floats:
        """The centre as floats, shape (3,)."""
        return np.array([float(c) for c in self.centre])

    @cached_property
    def arms(self) -> Floats:
        """The platform ends of the legs in the file less the centre, shape (6, 3)."""
        return np.array(
            [[float(c - m) for c, m in zip(self.points[b], self.centre, strict=True)] for _, b in self.legs]
        )

    @cached_property
    def size(self) -> float:
        """The root-mean-square distance of the joints of the file from their centroid."""
        all_points = np.array([[float(c) for c in p] for p in self.points.values()])
        return float(np.sqrt(((all_points - all_points.mean(axis=0)) ** 2).sum(axis=1).mean()))

    def exact(self, pose: Pose) -> dict[str, tuple[Fraction, ...]]:
        """Exact homogeneous coordinates (x, y, z, 1) of every joint. Raises InputError for a leg of no length."""
        turn = pose.rotation
        found: dict[str, tuple[Fraction, ...]] = {}
        for name in self.structure.names:
            place = self.points[name]
            if self.structure.sides[name] == "platform":
                arm = [c - m for c, m in zip(place, self.centre, strict=True)]
                turned = [r * arm[0] + s * arm[1] + t * arm[2] for r, s, t in turn]
                place = _vector([a + m + t for a, m, t in zip(turned, self.centre, pose.translation, strict=True)])
            found[name] = (*place, Fraction(1))
        for a, b in self.legs:
            if found[a] == found[b]:
                raise _no_length((a, b))
        return found

    def ends(self, translations: Floats, rotations: Floats, first: int = 0) -> Floats:
        """The platform ends of the legs in N poses given by arrays (N, 3) and (N, 3, 3): shape (N, 6, 3).

        Raises InputError where a leg has no length (below 1e-12 of the robot's size); `first` is the number of the
        first of these poses in what the user gave.
        """
        found: Floats = np.einsum("nij,kj->nki", rotations, self.arms)
        found += (self.centre_of_turns + translations)[:, None, :]
        if np.abs(found - self.base).max() > FAR * self.size:
            raise too_far("a pose is")
        short = np.linalg.norm(found - self.base, axis=2) <= 1e-12 * self.size
        if short.any():
            n, k = map(int, np.argwhere(short)[0])
            raise _no_length(self.legs[k], f" in pose {first + n}" if len(found) > 1 or first else "")
        return found


def _vector(numbers: Sequence[Fraction]) -> Vector:
    x, y, z = numbers
    return x, y, z


def _no_length(leg: tuple[str, str], where: str = " in this pose") -> InputError:
    return InputError(f"the leg {leg_text(leg)} has no length{where}: {leg[0]} and {leg[1]} are in the same place")


def rig(structure: Structure, platform: Coordinates, about: str | Sequence[Any] = "centroid") -> MovingPlatform:
    """The robot of a geometry file, turned about the centroid of the platform's joints, or another centre (see
    `read_centre`), in the file's unit and frame.

    Raises InputError where the legs do not tell base from platform, and for bodies whose joints lie on one line.
    """
    unknown = [n for n in structure.names if n not in structure.sides]
    if unknown:
        raise InputError(
            f"the legs do not tell whether {', '.join(unknown)} belong to the base or the platform",
            hint="a leg joins a joint of the base to a joint of the platform",
        )
    points = {n: platform.points[n] for n in structure.names}
    for side, names in (("base", structure.base), ("platform", structure.platform)):
        _check_body(side, names, points)
    body = [points[n] for n in structure.platform]
    centroid = _vector([sum(c, Fraction(0)) / len(body) for c in zip(*body, strict=True)])
    centre = read_centre(about, centroid, platform.units)
    _check_floats(points, structure.platform, platform.filename)
    return MovingPlatform(structure, points, centre, platform.units, platform.title)


def _check_body(side: str, names: Sequence[str], points: Mapping[str, Vector]) -> None:
    first = points[names[0]]
    arms = [[c - o for c, o in zip(points[n], first, strict=True)] for n in names[1:]]
    rank = 3 - len(kernel(arms, 3))
    if rank < 2:
        what = "lie on one line" if rank else "are in one place" if len(names) > 1 else "is the only one"
        joints = f"the joint{'s' if len(names) > 1 else ''} {', '.join(names)} of the {side}"
        raise InputError(
            f"{joints} {what}, so the robot is singular in every pose",
            hint="every leg then meets a line about which the platform can turn: move one of the joints off it",
        )


def _check_floats(points: Mapping[str, Vector], body: Sequence[str], filename: str) -> None:
    """Raises InputError for coordinates that are exact but of which floats cannot tell the joints of the body apart."""
    largest = max(abs(c) for p in points.values() for c in p) or Fraction(1)
    if not _SMALL < largest < 1 / _SMALL:
        raise InputError(
            f"the coordinates are too {'small' if largest < 1 else 'large'} for floats: the largest is"
            f" {decimal(largest, 3)}, expected one between {decimal(_SMALL)} and {decimal(1 / _SMALL)}",
            filename=filename,
            hint="choose another unit",
        )
    far = max(abs(c) for n in body for c in points[n])
    first = points[body[0]]  # differences are exact
    arms = np.array([[float((c - o) / far) for c, o in zip(points[n], first, strict=True)] for n in body])
    sizes = np.linalg.svd(arms - arms.mean(axis=0), compute_uv=False)
    if sizes[1] <= _THIN * sizes[0]:
        raise InputError(
            f"the joints {', '.join(body)} of the platform lie on one line but for {sizes[1] / sizes[0]:.1g} of their"
            f" extent: too thin for floats, expected {_THIN:g} or more",
            filename=filename,
            hint="every leg then meets a line about which the platform can turn",
        )
    if sizes[1] <= _FINE:
        raise InputError(
            f"the platform is too small for floats: {sizes[1]:.1g} of its largest coordinate"
            f" {decimal(far, 3)}, expected {_FINE:g} or more",
            filename=filename,
            hint="choose an origin near the robot, and check the units of its coordinates",
        )


_SMALL = Fraction(1, 10**60)
_THIN = 1e-9
"""A platform is refused whose second extent is less of its first one."""
_FINE = 1e-8
"""A platform is refused that is smaller, in parts of its largest coordinate, which a float knows to 1e-16 of itself."""
