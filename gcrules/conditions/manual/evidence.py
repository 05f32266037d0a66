r"""Why an expression is not the superbracket: exact points that show it, and whether one divides the other."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache
from itertools import combinations, pairwise

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.claims import digest
from gcrules.algebra.evaluate import PRIME, Evaluator, evaluate, random_points, random_rational_points
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import Expr, Number, Point, mul
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.scalars import bracket
from gcrules.algebra.straightening.straighten import straighten
from gcrules.algebra.superbrackets.shortest import superbracket_form
from gcrules.conditions.example_poses import singular_poses
from gcrules.conditions.gained_motion import factors
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.floats import int_if_whole
from gcrules.core.frozen import FrozenMap

__all__ = ["Evidence", "bracket_divides", "dividing_brackets", "flat", "relation", "separating"]

Points = Mapping[str, Sequence[int | Fraction]]
_SEEDS = 60


@dataclass(frozen=True)
class Evidence:
    """Exact homogeneous coordinates and the values there. `kind` is singular (the superbracket is zero, the expression
    is not), regular (the other way round) or ratio (`other` are the values at small whole coordinates elsewhere).
    """

    kind: str
    points: Points
    superbracket: Fraction
    expression: Fraction
    cofactor: Fraction = Fraction(1)
    other: Evidence | None = None

    @property
    def ratio(self) -> Fraction:
        """cofactor · superbracket : expression"""
        return self.cofactor * self.superbracket / self.expression


# --- brackets ------------------------------------------------------------------------------------------------------


def bracket_divides(structure: Structure, names: tuple[str, ...]) -> bool:
    """Whether the bracket of four points divides the superbracket.

    Decided by the normal form with these points first: the bracket divides exactly when it is the first row of every
    standard tableau, as putting that row on top keeps tableaux standard. Where points lie at infinity (they come
    first, whatever one wants) it is decided at exact random points with the four in a plane.
    """
    if not _zero_where_flat(structure, names):
        return False
    if structure.ideal:
        return True
    first = (*names, *(n for n in structure.names if n not in names))
    normal = straighten(superbracket_form(structure.neutral, points=first).polynomial)
    return all((0, 1, 2, 3) in m for m in normal.terms)  # type: ignore[union-attr]


def _zero_where_flat(structure: Structure, names: tuple[str, ...]) -> bool:
    for n in range(2):
        points = random_points(structure.names, ideal=structure.ideal, seed=("flat", structure.text(), n))
        for name in names:
            x, y, _, w = points[name]
            points[name] = (x, y, (3 * x + 5 * y + 7 * w) % PRIME, w)
        if Evaluator(points, 4, PRIME).value(structure.superbracket)[0]:
            return False
    return True


@lru_cache(maxsize=32)
def dividing_brackets(structure: Structure) -> tuple[tuple[str, ...], ...]:
    """All brackets of different points that divide the superbracket."""
    return tuple(names for names in combinations(structure.names, 4) if bracket_divides(structure, names))


def flat(structure: Structure, names: tuple[str, ...]) -> Evidence | None:
    """Small whole coordinates at which the four points lie in a plane and the superbracket is not zero."""
    volume = bracket(*map(Point, names))
    for seed in range(_SEEDS):
        checkpoint()
        points = _small(structure, seed)
        points |= {n: (points[n][0], points[n][1], 0, points[n][3]) for n in names}
        value = Fraction(evaluate(structure.superbracket, points))
        if value and _apart(points):
            return Evidence("regular", FrozenMap(points), value, Fraction(evaluate(volume, points)))
    return None


# --- expressions ---------------------------------------------------------------------------------------------------


def separating(structure: Structure, e: Expr, cofactor: Expr) -> Evidence | None:
    """Points that tell the expression from the superbracket, the most telling kind first. Where a constant ratio
    cofactor · superbracket : expression cannot be refuted, None.
    """
    ways = (_singular_pose, _one_zero, _ratios)
    return next((found for way in ways if (found := way(structure, e, cofactor))), None)


def _singular_pose(structure: Structure, e: Expr, cofactor: Expr) -> Evidence | None:
    """A singular pose of a platform above its base at which the expression does not vanish."""
    if structure.ideal:
        return None
    pose = next(singular_poses(structure, (e, cofactor)), None)
    return _values("singular", structure, e, cofactor, pose.points) if pose else None


def _one_zero(structure: Structure, e: Expr, cofactor: Expr) -> Evidence | None:
    left = mul(cofactor, structure.superbracket)
    tries = [("singular", structure.superbracket, mul(e, cofactor)), *(("regular", f, left) for f in factors(e))]
    for kind, zero, other in tries:
        for points in _zeros(structure, zero):
            if evaluate(other, points) and _apart(points):
                return _values(kind, structure, e, cofactor, points)
    return None


def _ratios(structure: Structure, e: Expr, cofactor: Expr) -> Evidence | None:
    left = mul(cofactor, structure.superbracket)
    first: Evidence | None = None
    for seed in range(_SEEDS):
        checkpoint()
        points = _small(structure, seed)
        if not evaluate(left, points) or not evaluate(e, points):
            continue
        here = _values("ratio", structure, e, cofactor, points)
        if first is None:
            first = here
        elif first.ratio != here.ratio:
            return replace(here, other=first)
    return None


def _values(kind: str, structure: Structure, e: Expr, cofactor: Expr, points: Points) -> Evidence:
    value, right, factor = (Fraction(evaluate(x, points)) for x in (structure.superbracket, e, cofactor))
    return Evidence(kind, FrozenMap(points), value, right, factor)


def _apart(points: Points) -> bool:
    """Whether no two points coincide."""
    return len(set(map(tuple, points.values()))) == len(points)


def _small(structure: Structure, seed: int) -> dict[str, tuple[int, ...]]:
    return random_rational_points(structure.names, ideal=structure.ideal, seed=seed, size=3 + seed // 10)


def _zeros(structure: Structure, e: Expr) -> Iterator[Points]:
    """Points at which an expression vanishes: one of them is moved along a line on which it is linear."""
    if isinstance(e, Number):
        return
    for seed in range(4):
        checkpoint()
        start = _small(structure, seed)
        for name in structure.names:
            for direction in _directions(start, name):
                at = [_moved(start, name, direction, t) for t in (Fraction(0), Fraction(1), Fraction(2))]
                zero, one, two = (Fraction(evaluate(e, points)) for points in at)
                if zero == one or two - one != one - zero:
                    continue
                points = _moved(start, name, direction, zero / (zero - one))
                if not evaluate(e, points):
                    yield points


def _directions(points: Mapping[str, tuple[int, ...]], name: str) -> Iterator[tuple[int, ...]]:
    yield from ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0))
    here = points[name]
    for n, there in points.items():
        if n != name and there[3] == here[3] and there != here:
            yield tuple(q - p for p, q in zip(here, there, strict=True))


def _moved(points: Points, name: str, direction: Sequence[int], t: Fraction) -> dict[str, Sequence[int | Fraction]]:
    moved = tuple(int_if_whole(p + t * d) for p, d in zip(points[name], direction, strict=True))
    return {**points, name: moved}


# --- divisibility --------------------------------------------------------------------------------------------------


def relation(structure: Structure, e: Expr, cofactor: Expr, degree: int) -> str:
    """How the expression divides cofactor · superbracket: "factor" of it, "multiple" of it, "shares" a factor with it,
    or "none". All points move along random lines, on which both are polynomials in one variable (of the expression's
    `degree` and 12 more than the cofactor's at most); what divides there divides everywhere (error
    below 10⁻¹⁵).
    """
    left = mul(cofactor, structure.superbracket)
    size = max(degree, 12 + _degree(cofactor)) + 1
    claim = (digest(left), digest(e))
    start, step = (random_points(structure.names, ideal=structure.ideal, seed=(*claim, n)) for n in range(2))
    samples: tuple[list[int], list[int]] = ([], [])
    for t in range(size):
        points = {n: tuple((p + t * d) % PRIME for p, d in zip(start[n], step[n], strict=True)) for n in start}
        at = Evaluator(points, 4, PRIME)
        for values, x in zip(samples, (left, e), strict=True):
            values.append(at.value(x)[0])
    a, b = (_interpolated(values) for values in samples)
    common = len(_gcd(a, b))
    if common == len(b) or common == len(a):
        return "factor" if common == len(b) else "multiple"
    return "shares" if common > 1 else "none"


def _degree(e: Expr) -> int:
    """The highest degree of a term in all points together."""
    found = expand(e, rank=4)
    assert isinstance(found, BracketPolynomial)
    return max((4 * len(monomial) for monomial in found.terms), default=0)


def _interpolated(values: Sequence[int]) -> list[int]:
    """Coefficients (lowest first, no zeros at the end) of the polynomial with these values at 0, 1, 2, …"""
    differences, row = [], list(values)
    while row:
        differences.append(row[0])
        row = [(b - a) % PRIME for a, b in pairwise(row)]
    found: list[int] = []
    for k in reversed(range(len(differences))):  # Newton's form, from the inside out: d_k + (t − k)/(k + 1) · found
        inverse = pow(k + 1, -1, PRIME)
        scaled = [c * inverse % PRIME for c in found]
        found = [(s - k * c) % PRIME for s, c in zip([0, *scaled], [*scaled, 0], strict=True)] or [0]
        found[0] = (found[0] + differences[k]) % PRIME
    return _trimmed(found)


def _trimmed(p: list[int]) -> list[int]:
    while p and not p[-1]:
        p.pop()
    return p


def _gcd(a: list[int], b: list[int]) -> list[int]:
    while b:
        a, b = b, _remainder(a, b)
    return a


def _remainder(a: list[int], b: list[int]) -> list[int]:
    a, inverse = list(a), pow(b[-1], -1, PRIME)
    while len(a) >= len(b):
        factor = a[-1] * inverse % PRIME
        shift = len(a) - len(b)
        for i, c in enumerate(b):
            a[shift + i] = (a[shift + i] - factor * c) % PRIME
        a.pop()
        _trimmed(a)
    return a
