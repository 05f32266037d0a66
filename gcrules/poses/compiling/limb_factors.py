"""The factors of a robot's condition on the tape, from the places of the names that they are written in."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any, Protocol

from gcrules.algebra.evaluate import Evaluator
from gcrules.algebra.expr import ONE, Expr, points_of
from gcrules.mechanisms.conditions.factor_causes import ASIDE
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.lines.derived import with_derived
from gcrules.poses.compiling.roots import NoForm, inverse, root
from gcrules.poses.compiling.scalars import Ring
from gcrules.poses.compiling.vectors import Vector, add, dot, scaled, sub, total
from gcrules.screws import RATIONALS

__all__ = ["Places", "traced_factors", "vectors_of"]

Row = tuple[Ring, ...]


class Places(Protocol):
    """Where the points and directions of a robot, by their `sorts`, are on a tape."""

    @property
    def sorts(self) -> Mapping[str, str]: ...

    def at(self, name: str) -> Vector:
        """The place of a name; of a direction a vector of any length. Raises NoForm."""


def traced_factors(m: Limbs, places: Places) -> tuple[Ring, ...]:
    """The values of the factors whose zeros are singularities, as `factors` has them; none where the robot's wrenches
    are no lines. Raises NoForm where something has no closed form.
    """
    analysis = m.analysis
    if analysis.lines is None:
        raise NoForm("wrenches that are not lines through the file's points")
    structure, parts = analysis.lines.structure, analysis.parts
    live = [part.expression for part in parts if part.kind not in ASIDE]
    used = dict.fromkeys(n for part in parts for n in points_of(part.expression))
    if any(part.over != ONE for part in parts):  # the quotient is the superbracket up to a number, as in `factors`
        if len(parts) > 1:
            raise NoForm("several factors, and a cofactor")
        live = [structure.superbracket] if live else []
        used = dict.fromkeys((*structure.names, *points_of(parts[0].over)))
    rows = _rows(m, places, used)
    points = [n for n in used if places.sorts.get(n) == "point"]
    if len(points) > 1:
        centre: Vector = (0, 0, 0)
        for n in points:
            centre = add(centre, scaled(_place(rows[n]), Fraction(1, len(points))))
        rows = {n: (*sub(_place(row), scaled(centre, row[3])), row[3]) for n, row in rows.items()}
        square: Ring = 0
        for n in points:
            square = square + dot(_place(rows[n]), _place(rows[n])) * Fraction(1, len(points))
        scale = inverse(root(square))
        rows = {n: row if row[3] == 0 else (*scaled(_place(row), scale), row[3]) for n, row in rows.items()}
    return tuple(_value(e, rows, points, analysis.robot.family.plane) for e in live)


def vectors_of(m: Limbs, places: Places, names: Iterable[str]) -> dict[str, Vector]:
    """The places of these names, those that are derived for the lines among them; of directions up to their length.
    Raises NoForm where one has no closed form.
    """
    if any(d.is_point for d in m.analysis.structure.derived):
        raise NoForm
    return {n: _place(row) for n, row in _rows(m, places, names).items()}


def _rows(m: Limbs, places: Places, names: Iterable[str]) -> dict[str, Row]:
    """Homogeneous coordinates of these names, of points of the file with 1 in the last place."""
    derived = m.analysis.structure.derived
    made = {d.name for d in derived}
    own = {n: places.at(n) for d in derived for n in d.names if n not in made}
    rows: dict[str, Row] = {**with_derived(derived, own, RATIONALS)}
    return {n: rows[n] if n in rows else (*places.at(n), int(places.sorts.get(n) == "point")) for n in names}


def _place(row: Row) -> Vector:
    return row[0], row[1], row[2]


def _value(e: Expr, rows: Mapping[str, Row], points: Sequence[str], plane: bool) -> Ring:
    """As `factors` has it: divided by the lengths of the coordinates of what it joins or meets. These have the lengths
    of its directions, and of derived points, as factors, which therefore need not be 1 there.
    """
    extensors = bool(e.children) and e.children[0].step > 0
    at: dict[str, Row] = {}
    for n, row in rows.items():
        if not (extensors or n in points):
            size = inverse(root(total(c * c for c in row)))
            row = tuple(c * size for c in row)
        at[n] = (row[0], row[1], row[3]) if plane else row
    evaluator = Evaluator(at, rank=3 if plane else 4)
    value: Any = evaluator.value(e)[0]
    if not extensors:
        return value  # type: ignore[no-any-return]
    sizes: Ring = 1
    for child in e.children:
        square: Ring = 0
        for c in evaluator.value(child):
            square = square + c * c
        sizes = sizes * square
    return value * inverse(root(sizes))  # type: ignore[no-any-return]
