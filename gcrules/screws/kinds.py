r"""The kinds of screw systems, by the lines (screws of pitch zero, and couples) that they hold.

On a span S the reciprocal product is a quadratic form. Its zeros are the lines of S. Its radical N (what is reciprocal
to all of S) and its rank on S / N decide, for dimensions 1 to 3:

    rank 0   all screws are lines: one linear family
    rank 1   the lines are those of N
    rank 2   two linear families that share N, or, for a definite form, only N
    rank 3   a regulus, or, for a definite form, no lines

Dimension 4 and 5 are told by the reciprocal system of dimension 2 or 1: their lines are those that meet all its lines.
The sign of a residue is unknown: modulo a prime every form counts as indefinite. Derived here.

`gcrules.poses.numbers.variety` names spans of lines in projective words, for reports of poses; it has no need of the
lines.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap
from gcrules.screws.field import Field, Row
from gcrules.screws.lines import LineFamily, family, number_text, undecided, vector_text
from gcrules.screws.screw import ScrewAxis, axis, join_of, meet_of, product

__all__ = ["KINDS", "Classification", "classify"]

KINDS: Mapping[str, str] = FrozenMap(
    {
        "nothing": "dimension 0",
        "force": "one line",
        "couple": "one line at infinity",
        "screw": "one screw of finite pitch",
        "planar pencil": "the lines through a point in a plane",
        "parallel pencil": "the parallel lines in a plane, and the couple normal to it",
        "two couples": "the couples normal to a direction",
        "two forces": "two skew lines; all other screws have a pitch",
        "force and couple": "a line and a couple that is not normal to it; all other screws have a pitch",
        "force and screw": "one line; all other screws have a pitch",
        "couple and screw": "parallel screws of one pitch in a plane, and the couple normal to it",
        "two screws": "no lines",
        "bundle": "the lines through a point",
        "parallel bundle": "the lines along a direction, and the couples normal to it",
        "plane field": "the lines in a plane, and the couple normal to it",
        "all couples": "the lines at infinity",
        "two planar pencils": "two planar pencils that share a line",
        "two parallel pencils": "two parallel pencils that share their couple",
        "planar pencil and couple": "a planar pencil, and a parallel pencil that holds one of its lines",
        "force and two couples": "two couples, and a parallel pencil that holds one of them",
        "planar pencil and screw": "a planar pencil; all other screws have a pitch",
        "parallel pencil and screw": "a parallel pencil; all other screws have a pitch",
        "two couples and screw": "two couples; all other screws have one pitch and direction",
        "force and two screws": "one line; all other screws have a pitch",
        "couple and two screws": "one couple; all other screws have a pitch",
        "regulus": "one set of lines of a hyperboloid",
        "regulus with a couple": "one set of lines of a hyperbolic paraboloid, and its line at infinity",
        "three screws": "no lines",
        "bundle and plane field": "the lines through a point and the lines in a plane that holds it",
        "parallel bundle and plane field": "the lines along a direction and the lines in a plane that holds it",
        "force and three couples": "the lines along a direction, and all couples",
        "hyperbolic congruence": "the lines that meet two skew lines",
        "hyperbolic congruence with an axis at infinity": "the lines that meet a line and are normal to a direction",
        "parabolic congruence": "the lines that meet a line, in pencils that turn about it",
        "parabolic congruence with its axis at infinity": "the lines normal to a direction, parallel in each plane",
        "elliptic congruence": "lines of which one passes through each point; no line meets all of them",
        "special complex": "the lines that meet a line",
        "special complex with its axis at infinity": "the lines normal to a direction",
        "general complex": "the lines reciprocal to a screw of finite pitch",
        "everything": "dimension 6",
    }
)
"""All kinds, with what they hold. A kind whose name ends in screw or screws is not spanned by its lines."""

_COMPLEMENTS = {
    "two forces": "hyperbolic congruence",
    "force and couple": "hyperbolic congruence with an axis at infinity",
    "planar pencil": "bundle and plane field",
    "parallel pencil": "parallel bundle and plane field",
    "two couples": "force and three couples",
    "force and screw": "parabolic congruence",
    "couple and screw": "parabolic congruence with its axis at infinity",
    "two screws": "elliptic congruence",
    "force": "special complex",
    "couple": "special complex with its axis at infinity",
    "screw": "general complex",
}
_PAIRS = {
    ("force", "force"): "two forces",
    ("couple", "force"): "force and couple",
    ("planar pencil", "planar pencil"): "two planar pencils",
    ("parallel pencil", "parallel pencil"): "two parallel pencils",
    ("parallel pencil", "planar pencil"): "planar pencil and couple",
    ("parallel pencil", "two couples"): "force and two couples",
}


@dataclass(frozen=True)
class Classification:
    """The kind of a screw system, one of `KINDS`, and its lines.

    `families` are the linear families of lines that are contained in no larger one. For "bundle and plane field" and
    its two relatives these are both; other systems of dimension 4 or 5 have infinitely many, and `axes`, the families
    of the reciprocal system, are what all their lines meet. A regulus has none. `screw` is the one screw of dimension
    1 or the one reciprocal screw of dimension 5, if it has a finite pitch. `irrational` says that the lines of the kind
    are real but have no coordinates in this field (modulo a prime: that they are real or not); their families are then
    left out.
    """

    kind: str
    dimension: int
    families: tuple[LineFamily, ...] = ()
    axes: tuple[LineFamily, ...] = ()
    screw: ScrewAxis | None = None
    irrational: bool = False

    def stretched(self, length: Any) -> Classification:
        """The classification of the system with all points so much further from the origin."""
        return replace(
            self,
            families=tuple(f.stretched(length) for f in self.families),
            axes=tuple(f.stretched(length) for f in self.axes),
            screw=self.screw and self.screw.stretched(length),
        )

    @property
    def spanned_by_lines(self) -> bool:
        """Whether forces and couples span the system."""
        return not self.kind.endswith(("screw", "screws"))

    def __str__(self) -> str:
        if len(self.families) == 1 and self.families[0].kind == self.kind:
            return str(self.families[0])
        if self.kind in ("screw", "general complex") and self.screw and self.screw.point:
            through, along = vector_text(self.screw.point), vector_text(self.screw.direction)
            return f"{self.kind} with pitch {number_text(self.screw.pitch)} through {through} along {along}"
        shown = [*map(str, self.families), *(f"axis: {a}" for a in self.axes)]
        return f"{self.kind} ({'; '.join(shown)})" if shown else self.kind


def classify(basis: Sequence[Row], field: Field) -> Classification:
    """The kind of the span of independent rows of one configuration.

    Raises LimitReached for floats so close to the tolerance that the kind of their lines cannot be decided.
    """
    if field.length != 1:
        rows = field.rows(field.scaled(field.read(basis)))
        return classify(rows, field.scaled_field()).stretched(field.length)
    size = len(basis)
    if size in (0, 6):
        return Classification("everything" if size else "nothing", size)
    if size > 3:
        return _complement(basis, field)
    rows = field.rows(field.comparable(field.read(basis)))
    gram = field.read([[product(a, b, field) for b in rows] for a in rows], size)
    radical = _combined(field, field.kernel(gram), rows)
    rest = _combined(field, field.complement(gram), rows)
    kind, families, irrational = _RULES[len(rest)](field, radical, rest)
    screw = _screw(field, rows[0]) if kind == "screw" else None
    return Classification(kind, size, families, screw=screw, irrational=irrational)


_Found = tuple[str, tuple[LineFamily, ...], bool]


def _all_lines(field: Field, radical: Sequence[Row], rest: Sequence[Row]) -> _Found:
    found = family(field, radical)
    return found.kind, (found,), False


def _rank_one(field: Field, radical: Sequence[Row], rest: Sequence[Row]) -> _Found:
    if not radical:
        return "screw", (), False
    found = family(field, radical)
    return f"{found.kind} and screw", (found,), False


def _rank_two(field: Field, radical: Sequence[Row], rest: Sequence[Row]) -> _Found:
    """Two families through the zeros x:y of a x² + 2b xy + c y²."""
    one, other = rest
    a, b, c = (product(p, q, field) for p, q in ((one, one), (one, other), (other, other)))
    discriminant = field.reduced(b * b - a * c)
    if field.sign(discriminant) == -1:
        if not radical:
            return "two screws", (), False
        found = family(field, radical)
        return f"{found.kind} and two screws", (found,), False
    root = field.root(discriminant)
    if root is None:
        # Couples and what is reciprocal to them have coordinates in the field: both families are of one kind.
        kind = family(field, radical).kind if radical else ""
        return {"": "two forces", "force": "two planar pencils"}.get(kind, "two parallel pencils"), (), True
    s = -root if field.sign(b) == -1 else root
    q = next(q for q in (field.reduced(-b - s), field.reduced(-b + s)) if q)  # the zeros are q:a and c:q
    pair = []
    for zero in ((q, a), (c, q)):
        (line,) = field.rows(field.comparable(field.read([field.combination(zero, rest)])))
        pair.append(family(field, [*radical, line]))
    first, second = sorted(pair, key=lambda f: f.kind)
    if (first.kind, second.kind) not in _PAIRS:
        raise undecided()
    return _PAIRS[first.kind, second.kind], (second, first), False


def _rank_three(field: Field, radical: Sequence[Row], rest: Sequence[Row]) -> _Found:
    gram = [[product(a, b, field) for b in rest] for a in rest]
    if field.rank(field.read([row[:3] for row in rest], 3)) < 3:
        return "regulus with a couple", (), False
    one, two, three = (field.determinant([row[:k] for row in gram[:k]]) for k in (1, 2, 3))
    definite = field.sign(two) == 1 and field.sign(one * three) == 1
    return "three screws" if definite else "regulus", (), False


_RULES = (_all_lines, _rank_one, _rank_two, _rank_three)


def _complement(basis: Sequence[Row], field: Field) -> Classification:
    """Dimension 4 or 5, from the reciprocal system."""
    size = len(basis)
    rows = field.read([(*row[3:], *row[:3]) for row in field.rows(field.comparable(field.read(basis)))])
    other = classify(field.rows(field.kernel(rows)), field)
    kind = _COMPLEMENTS[other.kind]
    families = _through_or_in(field, other.families[0]) if other.kind in _FLAGS else ()
    axes = () if families else other.families
    return Classification(kind, size, families, axes, other.screw, other.irrational)


_FLAGS = ("planar pencil", "parallel pencil", "two couples")


def _through_or_in(field: Field, pencil: LineFamily) -> tuple[LineFamily, ...]:
    """The lines that meet all lines of a pencil: those through its point, and those in its plane."""
    assert pencil.point
    assert pencil.plane
    zero, one = field.number(0), field.number(1)
    corners = [tuple(one if i == k else zero for i in range(4)) for k in range(4)]
    through = [join_of(field, pencil.point, corner) for corner in corners]
    inside = [meet_of(field, pencil.plane, corner) for corner in corners]
    bases = (field.basis(field.comparable(field.read(rows))) for rows in (through, inside))
    return tuple(family(field, field.rows(basis)) for basis in bases)


def _screw(field: Field, row: Row) -> ScrewAxis:
    found = axis(row, field)
    x, y, z = field.simplest(found.direction)
    return ScrewAxis(found.point, (x, y, z), found.pitch)


def _combined(field: Field, coefficients: Any, rows: Sequence[Row]) -> tuple[Row, ...]:
    return tuple(field.combination(c, rows) for c in field.rows(coefficients))
