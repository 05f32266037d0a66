r"""Poses of a limb's platform in Study parameters x0 … x3, y0 … y3, with exact numbers.

A pose is the dual quaternion x + ε y: x turns, and y = t x / 2 for the shift t, so that x0 y0 + … + x3 y3 = 0 and x is
not 0; multiples are one pose. With half-angle tangents every elementary motion is 1 + q B for its amount q and a
constant dual quaternion B, so poses are polynomials in the amounts. Home is x = (1, 0, 0, 0), y = 0.

>>> from gcrules.mechanisms.description.limb_file import LimbSpec, read_joints
>>> limb = LimbSpec("leg", read_joints("R(A, z)"))
>>> turns = motions(limb, {"A": (1, 0, 0), "x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)})
>>> [int(c) for c in pose(turns, [Fraction(1)])]  # a quarter of a turn about the vertical line through (1, 0, 0)
[1, 0, 0, 1, 0, 0, -1, 0]
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.linear_algebra import cross
from gcrules.mechanisms.description.limb_file import JointSpec, LimbSpec
from gcrules.mechanisms.description.relations import combined
from gcrules.screws import JOINTS, RATIONALS
from gcrules.screws.study import DualQuaternion, product

__all__ = ["Motion", "coupled", "motions", "pose", "velocities"]

_ONE = (1, 0, 0, 0, 0, 0, 0, 0)


@dataclass(frozen=True)
class Motion:
    """C + q D, where q is the amount of the limb's coordinate `place`: of most motions C = 1, and q is the tangent of
    half the angle over the length of the axis, or a multiple of the length.
    """

    place: int
    C: DualQuaternion
    D: DualQuaternion


def motions(limb: LimbSpec, values: Mapping[str, Any]) -> tuple[Motion, ...]:
    """The elementary motions of a limb from the base to the platform, from places of its names as whole numbers and
    fractions.

    Raises InputError for a limb with bodies of its own, for a screw joint, whose poses no polynomials give, and for
    turns that are geared to each other otherwise than 1 : 1.
    """
    if limb.subchains:
        raise InputError(
            f"{limb.name} has bodies of its own: its poses are not a product of single motions",
            hint="loops inside a limb are not decomposed; gcrules robot pose follows the mode in which home is",
        )
    every = [list(_motions(joint, values)) for joint in limb.joints]
    leaders = {c.joint: c.leader for c in limb.couplings}
    starts: dict[int, int] = {}
    count = 0
    for k, own in enumerate(every):
        if k not in leaders:
            starts[k] = count
            count += max(n for n, _, _ in own) + 1
    found: list[Motion] = []
    for k, own in enumerate(every):
        ratio = limb.ratios.get(k, Fraction(1))
        if k in leaders:
            _check_coupling(limb, k, own, every[leaders[k]], ratio)
        start = starts[leaders.get(k, k)]
        found += [Motion(start + n, _ONE, tuple(sign * ratio * c for c in B)) for n, sign, B in own]
    return tuple(found)


Steps = Sequence[tuple[int, int, DualQuaternion]]


def _check_coupling(limb: LimbSpec, joint: int, own: Steps, leader: Steps, ratio: Fraction) -> None:
    """Raises InputError where the joint's amount is no multiple of its leader's: tangents of half angles are multiples
    of each other where the angles are equal or opposite, lengths of slides always.
    """
    turning = {any(B[:4]) for _, _, B in (*own, *leader)}
    if turning == {False} or (turning == {True} and abs(ratio) == 1):
        return
    raise InputError(
        f"{limb.joints[joint]} of {limb.name} follows another joint by the ratio {ratio}, and operation modes handle"
        " only turns that are geared 1 : 1",
        hint="slides may follow slides by any ratio",
    )


def coupled(moves: Sequence[Motion]) -> Iterator[tuple[Motion, ...]]:
    """The same limb with two of its turns about parallel axes, one after the other, in one amount: the second one turns
    back, so that what they carry swings as between parallel bars; or back and by half a turn.
    """
    turns = [k for k, m in enumerate(moves) if m.C == _ONE and any(m.D[:4])]
    for k, n in pairwise(turns):
        first, second = moves[k], moves[n]
        along, other = first.D[1:4], second.D[1:4]
        if any(cross(along, other)):
            continue
        ratio = Fraction(sum(a * b for a, b in zip(along, other, strict=True)), sum(a * a for a in along))
        B = tuple(Fraction(c) / ratio for c in second.D)
        square = sum(a * a for a in along)
        for step in (
            Motion(first.place, _ONE, tuple(-c for c in B)),
            Motion(first.place, B, tuple(square * c for c in _ONE)),
        ):
            own = [step if i == n else m for i, m in enumerate(moves)]
            places = sorted({m.place for m in own})
            yield tuple(replace(m, place=places.index(m.place)) for m in own)


def _motions(joint: JointSpec, values: Mapping[str, Any]) -> Iterator[tuple[int, int, DualQuaternion]]:
    if JOINTS[joint.kind].has_bars:
        yield from (_parallelogram if joint.kind == "Pa" else _rods)(joint, values)
        return
    for n, (a, b, c, u, v, w) in enumerate(joint.at(values, RATIONALS).twists(RATIONALS)):
        if a * u + b * v + c * w:
            raise InputError(
                f"{joint} is a screw: its angle and its length are not algebraic in each other",
                hint="operation modes need joints that turn or slide",
            )
        yield n, 1, (0, a, b, c, 0, u, v, w)


def _turn(point: Sequence[Any], axis: Sequence[Any]) -> DualQuaternion:
    return (0, *axis, 0, *cross(point, axis))


def _parts(joint: JointSpec, values: Mapping[str, Any]) -> list[Any]:
    return [combined(a, values, RATIONALS) for a in joint.args if isinstance(a, tuple)]


def _parallelogram(joint: JointSpec, values: Mapping[str, Any]) -> Iterator[tuple[int, int, DualQuaternion]]:
    bars, axis = _parts(joint, values)
    yield 0, 1, _turn((0, 0, 0), axis)
    yield 0, -1, _turn(bars, axis)


def _rods(joint: JointSpec, values: Mapping[str, Any]) -> Iterator[tuple[int, int, DualQuaternion]]:
    """The rods stay parallel; their turn about themselves is left out, as it is 0 then."""
    first, second, bars = _parts(joint, values)
    far = tuple(a + b for a, b in zip(first, bars, strict=True))
    least = min(range(3), key=lambda n: abs(bars[n]))
    across = cross(bars, tuple(int(n == least) for n in range(3)))
    other = cross(bars, across)
    yield 0, 1, _turn(first, across)
    yield 1, 1, _turn(first, other)
    yield 1, -1, _turn(far, other)
    yield 0, -1, _turn(far, across)
    yield 2, 1, _turn(far, tuple(b - a for a, b in zip(first, second, strict=True)))


def _factor(m: Motion, amounts: Sequence[Any], modulus: int | None) -> DualQuaternion:
    found = tuple(c + amounts[m.place] * d for c, d in zip(m.C, m.D, strict=True))
    return found if modulus is None else tuple(c % modulus for c in found)


def pose(moves: Sequence[Motion], amounts: Sequence[Any], modulus: int | None = None) -> DualQuaternion:
    """Where the limb takes the platform with these amounts of its coordinates."""
    found: DualQuaternion = _ONE
    for m in moves:
        found = product(found, _factor(m, amounts, modulus), modulus)
    return found


def velocities(moves: Sequence[Motion], amounts: Sequence[Any], modulus: int | None = None) -> list[DualQuaternion]:
    """The derivatives of the pose by each coordinate."""
    count = max((m.place for m in moves), default=-1) + 1
    found = [[0] * 8 for _ in range(count)]
    for k, m in enumerate(moves):
        one: DualQuaternion = _ONE
        for n, other in enumerate(moves):
            step = m.D if n == k else _factor(other, amounts, modulus)
            one = product(one, step, modulus)
        found[m.place] = [a + b for a, b in zip(found[m.place], one, strict=True)]
    return [tuple(c if modulus is None else c % modulus for c in own) for own in found]
