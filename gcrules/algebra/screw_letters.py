r"""Letters that stand for screws of space: wrenches and twists, of which lines are those without pitch.

A screw S is a sum of two lines, Sᵃ ∨ Sᵇ + Sᶜ ∨ Sᵈ: so all six Plücker coordinates are free, and no quadratic relation
holds. Nobody can write the names of the four points.

>>> print(screw("S"), screw("S").step, points_of(screw("S")))
S 2 ('Sᵃ', 'Sᵇ', 'Sᶜ', 'Sᵈ')
>>> screw_of("Sᶜ"), screw_of("L₁"), screws_of(["a", "Sᵃ", "T'ᵇ"])
('S', None, ('S', "T'"))
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from gcrules.algebra.expr import Expr, Join, Number, Point, Product, Sum, add, mul, points_of
from gcrules.algebra.names import NAME
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError, Span

__all__ = [
    "SCREW_MARKS",
    "Screw",
    "is_screw",
    "refuse_screw",
    "screw",
    "screw_of",
    "screw_points",
    "screws_of",
    "with_whole_screws",
]

SCREW_MARKS = "ᵃᵇᶜᵈ"


@dataclass(frozen=True, slots=True)
class Screw(Sum):
    """What a letter for a screw stands for: a sum of two lines, which stays together. Build with `screw`."""

    @property
    def name(self) -> str:
        """The letter."""
        return points_of(self)[0][:-1]


def screw(name: str) -> Screw:
    """The screw of a letter."""
    a, b, c, d = map(Point, screw_points(name))
    return Screw((Join((a, b)), Join((c, d))))


def screw_points(name: str) -> tuple[str, ...]:
    """The names of the points on the two lines whose sum a screw is."""
    return tuple(name + mark for mark in SCREW_MARKS)


def screw_of(point: str) -> str | None:
    """The letter of the screw to which a point belongs; None for other points."""
    name = point[:-1]
    return name if point[-1:] in SCREW_MARKS and NAME.fullmatch(name) else None


def screws_of(names: Iterable[str]) -> tuple[str, ...]:
    """The letters of screws to which some of the points belong."""
    return tuple(dict.fromkeys(name for n in names if (name := screw_of(n)) is not None))


def is_screw(e: Expr) -> bool:
    """Whether an extensor of step 2 need not be a line, since a screw is in its sum.

    >>> from gcrules.algebra.expr import join
    >>> is_screw(screw("S")), is_screw(join(Point("a"), screw("S"))), is_screw(join(Point("a"), Point("b")))
    (True, False, False)
    """
    match e:
        case Screw():
            return True
        case Sum(terms=parts) | Product(factors=parts):
            return any(map(is_screw, parts))
    return False


def refuse_screw(e: Expr, span: Span) -> None:
    """Raises InputError for a screw where a line or a plane is meant with all its points."""
    if is_screw(e):
        shown = str(e)
        hint = r"that a screw S is reciprocal to a line ab is written S \/ ab == 0"
        raise InputError(f"{shown} is a screw, which has no points", span=span, hint=hint)


def with_whole_screws(e: Expr) -> Expr:
    """A sum in which both lines of a screw stand, with the screw in their place.

    >>> from gcrules.algebra.expr import join
    >>> a, b, c, d = map(Point, screw_points("S"))
    >>> two, one = Number(-2), join(Point("p"), Point("q"))
    >>> print(with_whole_screws(add(mul(two, join(a, b)), one, mul(two, join(c, d)))), with_whole_screws(one))
    -2 * S + pq pq
    """
    if not isinstance(e, Sum) or isinstance(e, Screw):
        return e
    lines: dict[tuple[str, ...], tuple[int, int | Fraction]] = {}
    for i, term in enumerate(e.terms):
        number, line = term.factors if isinstance(term, Product) and len(term.factors) == 2 else (_ONE, term)
        ends = points_of(line)
        if isinstance(number, Number) and isinstance(line, Join) and all(map(screw_of, ends)):
            ordered = tuple(sorted(ends, key=lambda n: SCREW_MARKS.index(n[-1])))
            lines[ordered] = i, number.value if ordered == ends else -number.value
    kept = dict(enumerate(e.terms))
    for name in screws_of(n for line in lines for n in line):
        a, b, c, d = screw_points(name)
        (i, x), (j, y) = (lines.get(line, (-1, 0)) for line in ((a, b), (c, d)))
        if x and x == y:
            kept[i] = mul(Number(x), screw(name))
            del kept[j]
    return add(*kept.values()) if len(kept) < len(e.terms) else e


_ONE = Number(1)
