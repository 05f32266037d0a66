r"""The wrenches of all limbs in closed form on the tape, from the lines that the analysis finds for each limb.

They are seen from the platform, where its own joints stay, each limb's an orthonormal basis at its end, and are brought
to the balance in which the margin σ is measured, so that σ is the least singular value of what is made here. Whether
the lines of a limb are its wrenches in each pose is not taken for granted: σ is compared with that of the joint screws
(`limb_programs`). Derived here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.margin import balance, kept_axes
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.compiling.limb_places import LimbPlaces
from gcrules.poses.compiling.roots import NoForm, inverse, root
from gcrules.poses.compiling.scalars import Ring, Scalar
from gcrules.poses.compiling.tape import Program, lower
from gcrules.poses.compiling.vectors import Vector, add, cross, exact, scaled, sub, total

__all__ = ["BalancedLines", "balanced_lines", "balanced_wrenches", "dot_rows", "limb_lines", "plain_wrenches"]

_ROUNDING = 1e-14  # of entries of the balance, which is near 1

Row = tuple[Ring, ...]


@dataclass(frozen=True)
class BalancedLines:
    """Programs of the entries of wrenches of any length, row by row in the `balance`, and of the `products` of those of
    each limb, as their lengths are measured; `groups` are how many each limb has.
    """

    rows: Program
    products: Program
    groups: tuple[int, ...]


def balanced_wrenches(m: Limbs, places: LimbPlaces) -> tuple[Row, ...]:
    """The wrenches, rows whose least singular value is the margin σ (at most 1): six columns, three in the plane.
    Raises NoForm where a limb's wrenches are no lines, or lines of which something has no closed form.
    """
    rows: list[Row] = []
    for limb in _limbs(m, places):
        rows += [limb.balanced(row) for row in _orthonormal(limb.lines)]
    return tuple(rows)


def balanced_lines(m: Limbs, places: LimbPlaces) -> BalancedLines:
    """The same wrenches, of any length, and their products. Raises NoForm, too."""
    limbs = list(_limbs(m, places))
    rows = [c for limb in limbs for row in limb.lines for c in limb.balanced(row)]
    products = [dot_rows(a, b) for limb in limbs for a in limb.lines for b in limb.lines]
    groups = tuple(len(limb.lines) for limb in limbs)
    return BalancedLines(lower(places.graph, *rows), lower(places.graph, *products), groups)


def limb_lines(m: Limbs, places: LimbPlaces) -> tuple[Program, tuple[int, ...]]:
    """The entries of each limb's wrenches, six each, (f; m / size) of any length about the limb's end and seen from the
    platform, and how many wrenches each limb has. Raises NoForm, too.
    """
    limbs = [limb.lines for limb in _limbs(m, places)]
    return lower(places.graph, *(c for lines in limbs for row in lines for c in row)), tuple(map(len, limbs))


@dataclass(frozen=True, eq=False)
class _Limb:
    """The lines of a limb about its end, to which an `arm` leads from the middle of all ends, and the balance."""

    lines: list[Row]
    arm: Vector
    keep: list[int]
    columns: list[list[Fraction]]

    def balanced(self, row: Row) -> Row:
        """A wrench about the limb's end, in the balance of all."""
        force, moment = (row[0], row[1], row[2]), (row[3], row[4], row[5])
        whole = (*force, *add(moment, cross(self.arm, force)))
        wrench = [whole[n] for n in self.keep]
        return tuple(total(a * b for a, b in zip(wrench, column, strict=True)) for column in self.columns)


def _limbs(m: Limbs, places: LimbPlaces) -> Iterator[_Limb]:
    k = m.linkage
    middle = k.ends.mean(axis=0)
    arms = (k.ends - middle) / k.size
    keep = kept_axes(k)
    scale = np.where(np.abs(found := balance(arms[None], k.ball_ended, keep)[0]) > _ROUNDING, found, 0.0)
    columns = [[Fraction(float(c)) for c in column] for column in scale.T]
    for limb, end, arm in zip(m.analysis.structure.limbs, k.ends, arms, strict=True):
        lines = [_line(places.seen, places, line.ends, end) for line in _lines_of(limb)]
        yield _Limb(lines, exact(arm), keep, columns)


def dot_rows(one: Row, other: Row) -> Ring:
    """The sum of the products of their entries."""
    return total(a * b for a, b in zip(one, other, strict=True))


def plain_wrenches(m: Limbs, places: LimbPlaces, more: Sequence[Ring] = ()) -> Program:
    """The entries of the same wrenches, row by row, as the lines are: of any length, about one point, seen from the
    platform or from the base, whichever takes fewer operations; and then what `more` is wanted. Raises NoForm, too.
    """
    keep = kept_axes(m.linkage)
    found = []
    for see, origin in ((places.seen, m.linkage.ends.mean(axis=0)), (places.at, np.zeros(3))):
        rows = [
            _line(see, places, line.ends, origin) for limb in m.analysis.structure.limbs for line in _lines_of(limb)
        ]
        found.append(lower(places.graph, *(row[n] for row in rows for n in keep), *more))
    return min(found, key=lambda program: program.operations)


def _lines_of(limb: Any) -> tuple[Any, ...]:
    if limb.lines is None or limb.derived:
        raise NoForm("wrenches that are not lines through the file's points")
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


def _orthonormal(rows: Sequence[Row]) -> list[Row]:
    """Wrenches (f; m) of length 1 that span the same, one after the other."""
    done: list[Row] = []
    for row in rows:
        for other in done:
            along = dot_rows(row, other)
            row = tuple(a - along * b for a, b in zip(row, other, strict=True))
        size = inverse(root(dot_rows(row, row)))
        done.append(tuple(a * size for a in row))
    return done
