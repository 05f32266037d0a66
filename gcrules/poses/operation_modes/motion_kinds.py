r"""What kind of motion a mode is, in words: seen at random poses of it modulo the prime.

Looked for are directions that the platform keeps, a point of it that stays, and a plane in which it moves.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import chain

from gcrules.core.dataclass import dataclass
from gcrules.core.linear_algebra import content, echelon, kernel, rank
from gcrules.core.seeds import PRIME
from gcrules.poses.operation_modes.limb_constraints import lifted
from gcrules.poses.operation_modes.orientations import Orientations, fraction
from gcrules.screws.study import DualQuaternion, matrix_of, shift_of

__all__ = ["POSES", "motion_in_words"]

POSES = 14
"""So many random poses are looked at."""

Vector = tuple[Fraction, ...]


@dataclass(frozen=True)
class _Seen:
    """Pairs (platform, base) of directions that go to each other in all poses, and of points."""

    directions: tuple[tuple[Vector, Vector], ...]
    point: tuple[Vector, Vector] | None


def motion_in_words(poses: Sequence[DualQuaternion], orientations: Orientations, translations: int) -> str:
    """Of a mode with this set of orientations, in each of which there are shifts of `translations` freedoms."""
    seen = _seen(poses)
    turning = orientations.dimension
    if turning == 0:
        return _translations(orientations, translations)
    if seen.point is not None and translations == 0:
        at, held = _vector(seen.point[1]), _held(*seen.point)
        if seen.directions:
            return f"turns about the axis through {at} along {_direction(seen.directions[0][1])}{held}"
        whole = "pure turns about" if turning == 3 else f"turns of {_freedoms(turning)} about"
        return f"{whole} the point {at}{held}"
    if len(seen.directions) == 1:
        return _about_one(seen.directions[0], poses, translations)
    shifts = "no shift is free" if not translations else f"shifts of {_freedoms(translations)} in each of them"
    if turning == 3:
        return f"general motion: all orientations, and {shifts}" if translations else _GENERAL
    return (
        f"{_turns(orientations, poses)}, and {shifts}"
        if translations
        else f"{_turns(orientations, poses)}, which give the shift"
    )


def _held(own: Vector, base: Vector) -> str:
    """Which point of the platform stays in a point of the base, if it is another one."""
    return "" if own == base else f", where the platform's point {_vector(own)} stays"


_GENERAL = "general motion: all orientations; each fixes the shift"


def _freedoms(n: int) -> str:
    return ("no freedom", "one freedom", "two freedoms", "three freedoms")[n]


def _translations(orientations: Orientations, freedoms: int) -> str:
    what = {
        3: "pure translations",
        2: "translations parallel to a plane",
        1: "translations along a line",
        0: "a single pose",
    }[freedoms]
    (x,) = orientations.subspace()
    if not any(x[1:]):
        return what
    turn = "a half-turn" if not x[0] else "a fixed turn"
    return f"{what} after {turn} about {_direction(x[1:])}"


def _about_one(pair: tuple[Vector, Vector], poses: Sequence[DualQuaternion], translations: int) -> str:
    own, base = pair
    if own == base:
        along = _direction(base)
    elif tuple(-c for c in own) == base:
        along = f"{_direction(base)}, the platform upside down"
    else:
        along = f"{_direction(base)}, along which the platform has its direction {_direction(own)}"
    if translations == 3:
        return f"Schönflies motion with the direction {along}"
    normal = [int(c) for c in _whole(base)]
    rows = [[sum(n * c for n, c in zip(normal, shift_of(p), strict=True)), *_size(p)] for p in poses]
    if translations == 2 and rank(rows, PRIME) < 2:
        return f"planar motion at right angles to {along}" + ", after a shift along it" * bool(rows[0][0] % PRIME)
    shifts = f"shifts of {_freedoms(translations)}" if translations else "a shift that the turn gives"
    return f"turns about the direction {along}, with {shifts}"


def _size(p: DualQuaternion) -> tuple[int]:
    return (sum(c * c for c in p[:4]),)


def _turns(orientations: Orientations, poses: Sequence[DualQuaternion]) -> str:
    if orientations.dimension == 2 and len(orientations.basis) == 1 and orientations.linear:
        ring = orientations.basis[0].ring
        q = [fraction(orientations.basis[0].coeff(x)) for x in ring.gens]
        if not any(q[1:]):
            return "half-turns about axes of all directions"
        if not q[0]:
            return f"turns about axes at right angles to {_direction(tuple(q[1:]))}"
        return "half-turns after a fixed turn"
    angle = _angle(poses) if orientations.dimension == 2 else ""
    return angle or f"general motion: orientations of {_freedoms(orientations.dimension)}"


def _angle(poses: Sequence[DualQuaternion]) -> str:
    """In words which direction of the platform keeps its angle with which of the base, as behind a universal joint."""
    rows = [[*chain.from_iterable(matrix_of(p[:4])), *_size(p)] for p in poses]
    found = kernel(rows, 10, PRIME)
    if len(found) != 1:
        return ""
    numbers = [lifted(c) for c in found[0]]
    by_row = echelon([numbers[n : n + 3] for n in (0, 3, 6)])[0]
    by_column = echelon([numbers[n:9:3] for n in range(3)])[0]
    if len(by_row) != 1:
        return ""
    angle = "at right angles" if not numbers[9] else "at a fixed angle"
    return f"turns that keep the platform's direction {_direction(by_row[0])} {angle} to {_direction(by_column[0])}"


def _seen(poses: Sequence[DualQuaternion]) -> _Seen:
    rows = []
    for p in poses:
        turn, shift, (size,) = matrix_of(p[:4]), shift_of(p), _size(p)
        for n in range(3):
            rows.append([*turn[n], *(-size * (n == k) for k in range(3)), shift[n]])
    directions = kernel([r[:6] for r in rows], 6, PRIME)
    every = kernel(rows, 7, PRIME)
    point = next((tuple(lifted(c) for c in v) for v in every if v[6]), None)
    pairs = []
    for v in directions:
        exact = tuple(lifted(c) for c in v)
        scale = content(exact) * (-1 if next(c for c in exact[3:] if c) < 0 else 1)
        pairs.append((tuple(c / scale for c in exact[:3]), tuple(c / scale for c in exact[3:])))
    return _Seen(tuple(pairs), None if point is None else (point[:3], point[3:6]))


def _whole(v: Vector) -> tuple[Fraction, ...]:
    divisor = content(v)
    return tuple(c / divisor for c in v)


_AXES = {(1, 0, 0): "x", (0, 1, 0): "y", (0, 0, 1): "z"}


def _direction(v: Sequence[Fraction]) -> str:
    whole = _whole(tuple(v))
    lead = next(c for c in whole if c)
    exact = tuple(int(c) if lead > 0 else -int(c) for c in whole)
    return next((name for axis, name in _AXES.items() if axis == exact), str(exact))


def _vector(v: Sequence[Fraction]) -> str:
    return f"({', '.join(map(str, v))})"
