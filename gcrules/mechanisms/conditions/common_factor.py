r"""The common factor of the superbrackets of all six-subsets of a robot's lines, and what is left of each.

The limbs of an over-constrained robot, or of one with more actuators than freedoms, apply more than six wrenches. It is
singular exactly where ALL superbrackets of six of their lines vanish; in codimension one these are the zeros of their
common factor. On a random line in the
parameters of the family superbrackets are polynomials in one variable modulo the prime, so that the common factor, and
what is left of each subset, its cofactor, are found by division, exactly. A cofactor gets an expression, and words,
from a table of candidates; one is taken if it is the same polynomial up to a number.

Where there are as many actuators as freedoms subsets differ only in which constraints they take: the minors of these,
in random coordinates of the space that they span, are in the ratio of the superbrackets (Laplace). Derived here.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import combinations
from math import comb

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import ONE, Expr
from gcrules.algebra.language.text import text
from gcrules.algebra.scalars import bracket, superbracket
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import EngineFault, LimitReached
from gcrules.mechanisms.conditions.factor_causes import ASIDE, FactorCause
from gcrules.mechanisms.conditions.words import RobotWords
from gcrules.mechanisms.description.family import Family
from gcrules.mechanisms.lines.equivalent import Equivalent
from gcrules.mechanisms.lines.random_lines import LineOfLimbs
from gcrules.mechanisms.lines.singular import PRIME, Poly, divided, gcd, radical
from gcrules.mechanisms.lines.wrenches import WrenchLine
from gcrules.rules.statement import NOTHING, Statement, listing, say
from gcrules.screws import RESIDUES

__all__ = ["CommonFactor", "Subset", "common_factor", "sees_constraints"]

_MOST = 200  # subsets that are listed
_COMPARED = 100_000  # and that are looked at
Pair = tuple[str, str]


@dataclass(frozen=True)
class Subset:
    """Constraints that stand beside the actuations in a subset, or all its lines where there are more actuators than
    freedoms: its superbracket is `cofactor` · the common factor.

    `cofactor` is None where no expression in points was found; `meaning` says when it vanishes, "" if it cannot or if
    that is not known. `degree` is its degree along the line: 0 for a number.
    """

    lines: tuple[Pair, ...]
    cofactor: Expr | None
    degree: int
    meaning: Statement = NOTHING

    @property
    def statement(self) -> str:
        """The meaning in words."""
        return str(self.meaning)

    def to_json(self, names: Sequence[str] = ()) -> dict[str, object]:
        return {
            "constraints": [list(ends) for ends in self.lines],
            "cofactor": None if self.cofactor is None else text(self.cofactor, names=names),
            "statement": self.statement,
        }


@dataclass(frozen=True)
class CommonFactor:
    """What the subsets of the `lines` different lines of all limbs have in common.

    `subsets` counts the sets of six (in the plane three), `independent` those whose superbracket does not vanish in the
    whole family, `listed` them (not more than 200); `chosen` is that of the equivalent structure. `degree` is that of
    the common factor along a line in the parameters: 0 where no single condition makes all of them vanish.
    """

    lines: int
    subsets: int
    independent: int
    listed: tuple[Subset, ...]
    chosen: Subset
    degree: int

    def to_json(self, names: Sequence[str] = ()) -> dict[str, object]:
        return {
            "degree": self.degree,
            "lines": self.lines,
            "subsets": self.subsets,
            "independent": self.independent,
            "chosen": self.chosen.to_json(names),
            "cofactors": [one.to_json(names) for one in self.listed],
        }


def common_factor(
    family: Family,
    structure: Equivalent,
    superbracket: Expr,
    cofactors: Sequence[Expr],
    parts: Sequence[FactorCause],
    words: RobotWords,
) -> CommonFactor | None:
    """The subsets of a robot that is over-constrained or has more actuators than freedoms; None for others, for
    families of too high a degree, and where there are too many subsets.

    Raises EngineFault if the factors told apart by ranks at members (`parts`) are not those of the common factor.
    """
    if not (structure.over or structure.redundant) or structure.lines is None:
        return None
    try:
        return _common_factor(family, structure, superbracket, cofactors, parts, words)
    except LimitReached:
        return None


def _common_factor(
    family: Family,
    structure: Equivalent,
    superbracket: Expr,
    cofactors: Sequence[Expr],
    parts: Sequence[FactorCause],
    words: RobotWords,
) -> CommonFactor:
    along = LineOfLimbs(family, structure)
    if comb(len(along.group), along.size) > _COMPARED:
        raise LimitReached(f"more than {_COMPARED:,} subsets of lines")
    words = replace(words, ideal=frozenset(n for n, row in along.points(1).items() if not row[3]))
    group, size = along.group, along.size
    some = [s for s in combinations(group, size) if along.minor(s, 1)]
    common = along.common
    listed_subsets = tuple(_subset(along, words, s, common) for s in some[:_MOST])
    held = [line for line in structure.lines or () if along.held(line)]
    chosen = _subset(along, words, held, common)
    left = divided(along.polynomial(lambda t: along.minor(held, t)), common)[0]
    _check(along, superbracket, left, cofactors, parts)
    number = len(along.lines)
    return CommonFactor(number, comb(number, along.full), len(some), listed_subsets, chosen, len(common) - 1)


def sees_constraints(family: Family, structure: Equivalent) -> bool:
    """Whether the structure's lines depend on each other wherever one condition makes the constraints of all limbs lose
    rank. Lines that stand for them all, and are none of a single limb, may not. True where that cannot be told.
    """
    along = LineOfLimbs(family, structure)
    held = [line for line in structure.lines or () if along.held(line)]
    try:
        return not divided(along.polynomial(lambda t: along.minor(held, t)), along.common)[1]
    except LimitReached:
        return True


def _subset(along: LineOfLimbs, words: RobotWords, lines: Sequence[WrenchLine], common: Poly) -> Subset:
    own = along.polynomial(lambda t: along.minor(lines, t))
    left, rest = divided(own, common)
    ends = tuple(line.ends for line in lines)
    if rest or len(left) == 1:
        return Subset(ends, ONE, 0)
    for e in _candidates(along, ends):
        checkpoint()
        if _alike(along.polynomial(lambda t, e=e: along.value(e, t)), left):  # type: ignore[misc]
            factors = e.factors if isinstance(e, ex.Product) else (e,)
            clauses = (words.clause(f) or say("{} = 0", f) for f in factors)
            return Subset(ends, e, len(left) - 1, listing(clauses, ", or "))
    return Subset(ends, None, len(left) - 1, _coincidence(along, ends, left))


def _alike(a: Poly, b: Poly) -> bool:
    """Whether one is a number times the other."""
    return len(a) == len(b) and all((x * b[-1] - y * a[-1]) % PRIME == 0 for x, y in zip(a, b, strict=True))


def _candidates(along: LineOfLimbs, lines: Sequence[Pair]) -> Iterator[Expr]:
    """Expressions in the lines' points that such a cofactor may be: the first that fits is taken."""
    points = along.points(1)
    far = {n for pair in lines for n in pair if not points[n][3]}
    finite = next((n for line in along.lines for n in line.ends if points[n][3]), None)
    rank = 3 if along.family.plane else 4
    if finite is None:
        return
    shared = set(lines[0]).intersection(*lines[1:])
    others = [n for pair in lines for n in pair if n not in shared]
    if len(shared) == 1:
        span = [*shared, *others]
        if len(span) == rank:
            yield _bracket(span, rank)
        if len(span) == rank - 1 and set(span) <= far:
            yield _bracket([*span, finite], rank)
    if len(lines) == 3 and all(set(pair) <= far for pair in lines):
        for (a, b), third in (((a, b), c) for a, b, c in ((0, 1, 2), (0, 2, 1), (1, 2, 0))):
            one, two, other = lines[a], lines[b], lines[third]
            for n in set(one) & set(two):
                p, q = (next(m for m in pair if m != n) for pair in (one, two))
                yield ex.mul(_bracket([n, p, q, finite], 4), _bracket([n, *other, finite], 4))
        planes = [ex.join(*map(ex.Point, (*pair, finite))) for pair in lines[:2]]
        yield ex.meet(*planes, ex.join(*map(ex.Point, lines[2])))
    if along.whole:
        joins = [ex.join(*map(ex.Point, pair)) for pair in lines]
        yield ex.meet(*joins, rank=3) if along.family.plane else superbracket(*joins)


def _bracket(names: Sequence[str], rank: int) -> Expr:
    if len(set(names)) < len(names):
        return ex.Number(0)
    return bracket(*map(ex.Point, names), rank=rank)


def _coincidence(along: LineOfLimbs, lines: Sequence[Pair], left: Poly) -> Statement:
    """Two points in one place, or two directions parallel, exactly where the cofactor vanishes; nothing for none."""
    names = list(dict.fromkeys(n for pair in lines for n in pair))
    sorts = along.family.sorts
    for a, b in combinations(names, 2):
        if sorts.get(a) != sorts.get(b):
            continue
        point = sorts.get(a) == "point"

        def apart(t: int, a: str = a, b: str = b, point: bool = point) -> tuple[int, ...]:
            u, v = along.points(t)[a][:3], along.points(t)[b][:3]
            return tuple(x - y for x, y in zip(u, v, strict=True)) if point else RESIDUES.cross(u, v)

        common: Poly = []
        for i in range(3):
            common = gcd(common, along.polynomial(lambda t, i=i: int(apart(t)[i]) % PRIME))  # type: ignore[misc]
        if _alike(common, left):
            how = "the points {} and {} coincide" if point else "the directions {} and {} are parallel"
            return say(how, ex.Point(a), ex.Point(b))
    return NOTHING


def _check(
    along: LineOfLimbs, superbracket: Expr, left: Poly, cofactors: Sequence[Expr], parts: Sequence[FactorCause]
) -> None:
    """The factors that count vanish exactly where the common factor does, those left aside being aside."""

    def product(es: Sequence[Expr]) -> Poly:
        return along.polynomial(lambda t: along.value(ex.mul(*es), t)) if es else [1]

    whole = along.polynomial(lambda t: along.value(ex.mul(superbracket, *cofactors), t))
    live = product([p.expression for p in parts if p.kind not in ASIDE])
    aside = product([p.expression for p in parts if p.kind in ASIDE])
    rest = divided(whole, left)[0]  # cofactors · common factor
    if not _divides(live, whole) or not _divides(rest, _times(live, aside)):
        raise EngineFault("the factors distinguished by ranks are not those of the common factor of the superbrackets")


def _times(f: Poly, g: Poly) -> Poly:
    found = [0] * (len(f) + len(g) - 1)
    for i, a in enumerate(f):
        for j, b in enumerate(g):
            found[i + j] = (found[i + j] + a * b) % PRIME
    return found


def _divides(f: Poly, g: Poly) -> bool:
    """Whether g vanishes wherever f does."""
    return not divided(radical(g), radical(f))[1]
