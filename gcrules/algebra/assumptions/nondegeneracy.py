r"""What a construction must not let vanish, and what that means in words.

>>> from gcrules.algebra.language.syntax import parse
>>> e = parse(r"ab /\ cd", rank=3)
>>> print(*fewest([parse("ab"), e]), "--", words(e))
ab /\ cd -- ab and cd meet in one point
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence

from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.construction import Construction, ConstructionStep
from gcrules.algebra.assumptions.images import PositionKind
from gcrules.algebra.assumptions.incidences import Helper
from gcrules.algebra.expr import Bracket, Expr, Join, Meet, Point, Product, Sum, points_of
from gcrules.algebra.language.text import text
from gcrules.algebra.letters import conic_of, conics_of, grouped, letter_of, letters_of, named_letter
from gcrules.algebra.parts import substitute
from gcrules.core.errors import InputError

__all__ = ["Nowhere", "assumed", "chosen", "fewest", "met", "words"]


def assumed(
    steps: Sequence[ConstructionStep],
    more: Sequence[Expr],
    free: tuple[str, ...],
    ideal: tuple[str, ...],
    helpers: Mapping[str, Helper],
    rank: int,
) -> tuple[Expr, ...] | None:
    """The extensors that a construction must not let vanish, in the user's points; None where they cannot be told."""
    found: list[Expr] = list(more)
    seen: set[str] = set()
    for s in steps:
        names = {s.name, *points_of(s.within)}
        if not (s.exact or _determinantal(s, seen, free, ideal)):
            found += s.nonzero
        seen |= names
    told = [_told(e, helpers, rank) for e in found if not _point(e, helpers)]
    if any(e is None for e in told):
        return None
    return tuple(e for e in told if e is not None)


def fewest(found: Iterable[Expr]) -> tuple[Expr, ...]:
    """Without those that cannot vanish where the others do not."""
    kept: list[Expr] = []
    for e in found:
        if not any(_implies(other, e) for other in kept):
            kept = [*(other for other in kept if not _implies(e, other)), e]
    return tuple(kept)


def chosen(found: Iterable[Expr], rank: int) -> tuple[Expr, ...]:
    """Without what does not vanish for some choice of the points of letters, which one always may take.

    A point of a line L is outside every smaller extensor A ≠ 0, wherever L is, so that L₁ ∨ A asks for A ≠ 0 only; of
    a plane P so are two points after each other: P₁₃ ∨ P₂₃ ∨ c asks for nothing.
    A point of a conic that is no pair of lines can be chosen outside any line. Choices are points of irreducible
    varieties, so that what is possible one by one is possible together.
    """
    return fewest(e for e in (_chosen(e, rank) for e in found) if e is not None)


class Nowhere(InputError):
    """What is given leads nowhere, as far as constructions of it were found."""


def _nowhere(constructions: Iterable[Construction]) -> Nowhere:
    """That nothing holds where nothing vanishes that these ask for, and what is said of points exists."""
    told = ", ".join(map(text, fewest(e for c in constructions for e in chosen(c.nonzero, c.rank))))
    what = "the assumptions hold only where something that is said of points does not exist"
    return Nowhere(f"{what}, or where one of these vanishes: {told}" if told else what)


def met(found: Sequence[PositionKind], nonzero: Sequence[Expr]) -> list[PositionKind]:
    """The kinds of positions at some of which nothing vanishes that must not. Raises Nowhere where there is none."""
    left = [kind for kind in found if not any(map(kind.construction.vanishes, nonzero))]
    if found and not left:
        raise _nowhere(kind.construction for kind in found)
    return left


def _chosen(e: Expr, rank: int) -> Expr | None:
    conics = conics_of(points_of(e)) if rank == _PLANE else ()
    if isinstance(e, Join | Bracket) and conics and all(isinstance(a, Point) for a in e.args):
        others = [a for a in e.args if isinstance(a, Point) and conic_of(a.name) is None]
        return _chosen(ex.join(*others, rank=_PLANE), rank) if len(others) > 1 else None
    if named_letter(e) is not None:
        return None
    if isinstance(e, Sum | Product):
        return _beside_a_letter(e, rank)
    if not isinstance(e, Join):
        return e
    names = [a.name for a in e.args if isinstance(a, Point)]
    alone = grouped(names)
    for letter, step in letters_of(alone).items():
        if e.step > step:
            continue
        own = {n for n in alone if (of := letter_of(n)) is not None and of[0] == letter}
        rest = [a for a in e.args if not (isinstance(a, Point) and a.name in own)]
        if letter not in letters_of(points_of(*rest)):  # it would change with the choice
            exists = not rest or (len(rest) == 1 and isinstance(rest[0], Point))
            return None if exists else _chosen(ex.join(*rest, rank=e.step), rank)
    return e


_PLANE = 3


def _beside_a_letter(e: Expr, rank: int) -> Expr | None:
    """What is joined with one point of a letter in all terms, so that only this must not vanish; else the whole."""
    names = points_of(e)
    for letter, step in letters_of(names).items():
        own = [n for n in names if (of := letter_of(n)) is not None and of[0] == letter]
        rest = _beside(e, own[0]) if len(own) == 1 and 0 < e.step <= step else None
        if rest is not None:
            return _chosen(rest, rank)
    return e


def _beside(e: Expr, name: str) -> Expr | None:
    """X where the expression is the join of a point and X, term by term."""
    match e:
        case Join(args=args) if Point(name) in args:
            i = args.index(Point(name))
            rest = ex.join(*args[:i], *args[i + 1 :], rank=e.step)
            return ex.signed(-1 if sum(a.step for a in args[:i]) % 2 else 1, rest)
        case Product(factors=factors):
            parts = [_beside(f, name) if f.step else f for f in factors]
            alone = all(f.step or name not in points_of(f) for f in factors)
            return ex.mul(*(p for p in parts if p is not None)) if alone and None not in parts else None
        case Sum(terms=terms):
            found = [_beside(t, name) for t in terms]
            return None if None in found else ex.add(*(t for t in found if t is not None), rank=e.step)
    return None


def _point(e: Expr, helpers: Mapping[str, Helper]) -> bool:
    """Whether it is a point that exists, and so is not zero."""
    return isinstance(e, Point) and (e.name not in helpers or helpers[e.name].meet is None)


def _determinantal(s: ConstructionStep, seen: set[str], free: tuple[str, ...], ideal: tuple[str, ...]) -> bool:
    """Whether the step says no more than that free points and the new one, none of them used before, are dependent.

    Such matrices of less than full rank form an irreducible variety, and so do the positions of independent groups of
    points. Later steps add a linear space over each position, of one dimension as long as their extensors do not
    vanish, which leaves it irreducible. The positions that this step reaches are dense there, so that an identity that
    holds on them holds everywhere.
    """
    args = s.within.args if isinstance(s.within, Join) else (s.within,)
    names = [a.name for a in args if isinstance(a, Point)]
    return (
        len(names) == len(args)
        and all(n in free and n not in ideal and n not in seen and ":" not in n for n in names)
        and s.name not in seen
    )


def _told(e: Expr, helpers: Mapping[str, Helper], rank: int) -> Expr | None:
    """The extensor without helpers: their meets in their place; or one that vanishes wherever it does."""
    names: dict[str, Expr] = {}
    for n in points_of(e):
        h = helpers.get(n)
        if h is not None and h.meet is not None:
            names[n] = h.meet
        elif h is not None:
            # A ∨ q for some point q of the line L is not zero if A ∨ L is not.
            if not (isinstance(e, Join) and Point(n) in e.args and h.line is not None):
                return None
            rest = [a for a in e.args if a != Point(n)]
            if any(n in points_of(a) for a in rest) or sum(a.step for a in rest) + h.line.step > rank:
                return None
            return _told(ex.join(*rest, h.line, rank=rank), helpers, rank)
    return substitute(e, names, rank) if names else e


def _implies(whole: Expr, part: Expr) -> bool:
    """Whether an extensor that is not zero has this part, which then is not zero either."""
    if whole == part:
        return True
    match whole:
        case Join(args=args) | Bracket(args=args):
            if isinstance(part, Join) and not Counter(part.args) - Counter(args):
                return True
            return any(_implies(a, part) for a in args)
        case Meet(args=args):
            return any(_implies(a, part) for a in args)
        case Product(factors=factors):
            return any(_implies(f, part) for f in factors)
    return False


def words(e: Expr, names: Iterable[str] = ()) -> str:
    """What it means that an extensor does not vanish, where there are short words for it."""
    shown = [text(a, names=names) for a in e.children]
    if any(isinstance(a, Point) and letter_of(a.name) for a in e.children):
        return ""
    match e:
        case Join(args=args) | Bracket(args=args) if (
            all(isinstance(a, Point) for a in args) and len(args) <= len(_WORDS) + 1
        ):
            return _WORDS[len(args) - 2].format(", ".join(shown[:-1]), shown[-1])
        case Meet() if e.step == 1:
            return f"{', '.join(shown[:-1])} and {shown[-1]} meet in one point"
        case Meet() if e.step == 2:
            return f"{', '.join(shown[:-1])} and {shown[-1]} meet in one line"
    return ""


_WORDS = ("the points {} and {} differ", "{} and {} are not on a line", "{} and {} are not in a plane")
