r"""The wrenches of all limbs in closed form on the tape, from the lines that the analysis finds for each limb.

They are seen from the platform, where its own joints stay, each limb's an orthonormal basis at its end, and are brought
to the balance in which the margin σ is measured, so that σ is the least singular value of what is made here. Whether
the lines of a limb are its wrenches in each pose is not taken for granted: σ is compared with that of the joint screws
(`limb_programs`). Derived here.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from gcrules.mechanisms.kinematics.margin import balance, kept_axes
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.compiling.limb_places import LimbPlaces
from gcrules.poses.compiling.roots import NoForm, inverse, root
from gcrules.poses.compiling.scalars import Ring, Scalar
from gcrules.poses.compiling.tape import Program, lower
from gcrules.poses.compiling.vectors import Vector, add, cross, exact, scaled, sub, total

__all__ = ["balanced_wrenches", "plain_wrenches"]

_ROUNDING = 1e-14  # of entries of the balance, which is near 1

Row = tuple[Ring, ...]


def balanced_wrenches(m: Limbs, places: LimbPlaces) -> tuple[Row, ...]:
    """The wrenches, rows whose least singular value is the margin σ (at most 1): six columns, three in the plane.
    Raises NoForm where a limb's wrenches are no lines, or lines of which something has no closed form.
    """
    k = m.linkage
    middle = k.ends.mean(axis=0)
    arms = (k.ends - middle) / k.size
    keep = kept_axes(k)
    scale = np.where(np.abs(found := balance(arms[None], k.ball_ended, keep)[0]) > _ROUNDING, found, 0.0)
    columns = [[Fraction(float(c)) for c in column] for column in scale.T]
    rows: list[Row] = []
    for limb, end, arm in zip(m.analysis.structure.limbs, k.ends, arms, strict=True):
        lines = [_line(places.seen, places, line.ends, end) for line in _lines_of(limb)]
        for force, moment in _orthonormal(lines):
            whole = (*force, *add(moment, cross(exact(arm), force)))
            wrench = [whole[n] for n in keep]
            rows.append(tuple(total(a * b for a, b in zip(wrench, column, strict=True)) for column in columns))
    return tuple(rows)


def plain_wrenches(m: Limbs, places: LimbPlaces) -> Program:
    """The entries of the same wrenches, row by row, as the lines are: of any length, about one point, seen from the
    platform or from the base, whichever takes fewer operations. Raises NoForm, too.
    """
    keep = kept_axes(m.linkage)
    found = []
    for see, origin in ((places.seen, m.linkage.ends.mean(axis=0)), (places.at, np.zeros(3))):
        rows = [
            _line(see, places, line.ends, origin) for limb in m.analysis.structure.limbs for line in _lines_of(limb)
        ]
        found.append(lower(places.graph, *(row[n] for row in rows for n in keep)))
    return min(found, key=lambda program: program.operations)


def _lines_of(limb: Any) -> tuple[Any, ...]:
    if limb.lines is None or limb.derived:
        raise NoForm("wrenches that are no lines of the file's points")
    return tuple(limb.lines)


def _line(see: Callable[[str], Vector], places: LimbPlaces, ends: tuple[str, str], origin: np.ndarray) -> Row:
    """(f; m) about a point of the line through two names, in parts of the robot's size: a couple where both are
    directions. Its foot is the one that does not move where it is seen from, if there is one.
    """
    by = Fraction(1) / Fraction(places.size)
    p, q = (scaled(sub(see(n), exact(origin)), by) if places.sorts[n] == "point" else None for n in ends)
    first, last = ends
    if p is None and q is None:
        return (0, 0, 0, *cross(see(first), see(last)))
    if p is None:
        p, q, last = q, None, first
    assert p is not None
    force = sub(q, p) if q is not None else see(last)
    foot = q if q is not None and _is_constant(q) else p
    return (*force, *cross(foot, force))


def _is_constant(v: Vector) -> bool:
    return not any(isinstance(c, Scalar) for c in v)


def _orthonormal(rows: Sequence[Row]) -> list[tuple[Vector, Vector]]:
    """Forces and moments of length 1 together that span the same, one after the other."""
    done: list[Row] = []
    for row in rows:
        for other in done:
            along = total(a * b for a, b in zip(row, other, strict=True))
            row = tuple(a - along * b for a, b in zip(row, other, strict=True))
        size = inverse(root(total(a * a for a in row)))
        done.append(tuple(a * size for a in row))
    return [((r[0], r[1], r[2]), (r[3], r[4], r[5])) for r in done]
