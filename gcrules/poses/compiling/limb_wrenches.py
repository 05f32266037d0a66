r"""The wrenches of all limbs in closed form on the tape, from the lines that the analysis finds for each limb.

They are seen from the platform, where its own joints stay, each limb's an orthonormal basis at its end, and are brought
to the balance in which the margin σ is measured, so that σ is the least singular value of what is made here. Whether
the lines of a limb are its wrenches in each pose is not taken for granted: σ is compared with that of the joint screws
(`limb_programs`). Derived here.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import numpy as np

from gcrules.mechanisms.kinematics.margin import balance, kept_axes
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.compiling.limb_places import LimbPlaces
from gcrules.poses.compiling.roots import NoForm, inverse, root
from gcrules.poses.compiling.scalars import Ring
from gcrules.poses.compiling.vectors import Vector, add, cross, exact, scaled, sub, total

__all__ = ["balanced_wrenches"]

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
        if limb.lines is None or limb.derived:
            raise NoForm("wrenches that are no lines of the file's points")
        seen = _Seen(places, end, k.size)
        for force, moment in _orthonormal([seen.line(*line.ends) for line in limb.lines]):
            whole = (*force, *add(moment, cross(exact(arm), force)))
            wrench = [whole[n] for n in keep]
            rows.append(tuple(total(a * b for a, b in zip(wrench, column, strict=True)) for column in columns))
    return tuple(rows)


class _Seen:
    """Lines seen from the platform, about the end of a limb at home, in parts of the robot's size."""

    def __init__(self, places: LimbPlaces, end: np.ndarray, size: float) -> None:
        self.places, self.end, self.by = places, end, Fraction(1) / Fraction(size)

    def line(self, first: str, last: str) -> Row:
        """(f; m) of the line through two names: a couple where both are directions."""
        p, q = (self._point(n) for n in (first, last))
        if p is None and q is None:
            force: Vector = (0, 0, 0)
            return (*force, *cross(self.places.seen(first), self.places.seen(last)))
        if p is None:
            first, last, p, q = last, first, q, p
        assert p is not None
        force = sub(q, p) if q is not None else self.places.seen(last)
        return (*force, *cross(p, force))

    def _point(self, name: str) -> Vector | None:
        if self.places.sorts[name] != "point":
            return None
        return scaled(sub(self.places.seen(name), exact(self.end)), self.by)


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
