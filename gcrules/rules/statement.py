r"""What a condition says, as a value: words, and the flats that are named between them. It is put into words last.

>>> from gcrules.algebra.language.syntax import parse
>>> met = say("{} meet in a point", listing(map(parse, ("abc", "ade"))))
>>> print(met)
abc and ade meet in a point
>>> lines = {"ade": parse("ade"), "abc": parse(r"(def /\ gh) \/ a")}
>>> print(met.with_flats(lambda e: lines[str(e)]))
(def /\ gh) \/ a and ade meet in a point
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import groupby
from string import Formatter

from gcrules.algebra.expr import Expr, Meet, points_of
from gcrules.algebra.language.text import text
from gcrules.core.dataclass import dataclass

__all__ = [
    "NOTHING",
    "Flat",
    "Part",
    "Piece",
    "Quantity",
    "Statement",
    "filled",
    "listing",
    "of_kind",
    "say",
    "together",
]


@dataclass(frozen=True, slots=True)
class Flat:
    """A flat that a statement names; `names` are the declared points, as for `algebra.language.text.text`."""

    expression: Expr
    names: tuple[str, ...] = ()

    def __str__(self) -> str:
        shown = text(self.expression, names=self.names)
        return f"({shown})" if isinstance(self.expression, Meet) and self.expression.step else shown


@dataclass(frozen=True, slots=True)
class Term:
    """A word for what the lines are: legs of a platform, or the lines of a robot's forces."""

    of_legs: str
    of_forces: str

    def __str__(self) -> str:
        return self.of_legs


_LEGS = (Term("Without the legs", "Without the wrenches along"), Term("the legs", "the lines"))
_TERMS = {term.of_legs: term for term in _LEGS}
_SPLIT = re.compile(f"({'|'.join(_TERMS)})")


@dataclass(frozen=True, slots=True)
class Quantity:
    """A number by its letter, or an equation between numbers, as text and as LaTeX; the letters where none is given."""

    shown: str
    latex: str = ""

    def __str__(self) -> str:
        return self.shown


Piece = str | Flat | Term | Quantity


@dataclass(frozen=True)
class Statement:
    """Words and flats in sequence; none of both says nothing, and counts as false.

    Two statements are equal where they say the same of the same flats.
    """

    pieces: tuple[Piece, ...] = ()

    def __str__(self) -> str:
        return "".join(map(str, self.pieces))

    def __bool__(self) -> bool:
        return bool(self.pieces)

    @property
    def flats(self) -> tuple[Expr, ...]:
        """The flats that it names, in sequence."""
        return tuple(p.expression for p in self.pieces if isinstance(p, Flat))

    @property
    def points(self) -> frozenset[str]:
        """The points of these flats."""
        return frozenset(n for e in self.flats for n in points_of(e))

    def with_flats(self, change: Callable[[Expr], Expr]) -> Statement:
        """The same said of other flats."""
        return Statement(
            tuple(replace(p, expression=change(p.expression)) if isinstance(p, Flat) else p for p in self.pieces)
        )

    @property
    def of_forces(self) -> Statement:
        """The same said of the lines of forces and couples in the place of legs."""
        return _joined(p.of_forces if isinstance(p, Term) else p for p in self.pieces)

    @property
    def capitalised(self) -> Statement:
        """With an upper-case letter at its beginning, where it begins with a word."""
        match self.pieces:
            case (str(first), *rest):
                return Statement((first[:1].upper() + first[1:], *rest))
        return self


NOTHING = Statement()

Part = str | Expr | Flat | Quantity | Statement
"""What is filled into words: more words, a flat, or what was said before."""


def filled(template: str, part: Callable[[str], Part]) -> Statement:
    """A template with its places {name} filled; braces that are none stand twice. Raises ValueError for a template
    with a brace that has no partner.
    """
    return _joined(_filled(template, part))


def _filled(template: str, part: Callable[[str], Part]) -> Iterator[Piece]:
    for words, name, _, _ in Formatter().parse(template):
        yield from (_TERMS.get(some, some) for some in _SPLIT.split(words))
        if name is not None:
            yield from _pieces(part(name))


def say(template: str, *parts: Part, **named: Part) -> Statement:
    """A template with its places {} filled one after the other, those with a name by the part of that name."""
    rest = iter(parts)
    return filled(template, lambda name: named[name] if name else next(rest))


def _pieces(part: Part) -> Iterable[Piece]:
    match part:
        case str():
            return (part,)
        case Statement(pieces=pieces):
            return pieces
        case Flat() | Quantity():
            return (part,)
    return (Flat(part),)


def _joined(pieces: Iterable[Piece]) -> Statement:
    """With words side by side as one, so that equal statements are equal values."""
    found: list[Piece] = []
    for is_words, run in groupby((p for p in pieces if p != ""), lambda p: isinstance(p, str)):
        some = list(run)
        found += ["".join(map(str, some))] if is_words else some
    return Statement(tuple(found))


# --- lists ---------------------------------------------------------------------------------------------------------


def listing(parts: Iterable[Part], last: str = " and ") -> Statement:
    """ "ab, cd and ef", each once."""
    some = list(dict.fromkeys(parts))
    between = [", "] * (len(some) - 2) + [last]
    places = "{}".join(["", *between[: max(0, len(some) - 1)], ""]) if some else ""
    return say(places, *some)


def of_kind(kind: str, parts: Sequence[Part]) -> Statement:
    """ "the plane abc", "the planes abc and bcd"; nothing of nothing."""
    return say(f"the {kind}{'s' * (len(dict.fromkeys(parts)) > 1)} {{}}", listing(parts)) if parts else Statement()


def together(items: Sequence[tuple[str, Part]]) -> Statement:
    """ "the lines Aa and Bb and the direction i" of kinds with what is of that kind; "" for no kind comes last."""
    kinds: dict[str, list[Part]] = {}
    for kind, item in items:
        kinds.setdefault(kind, []).append(item)
    others = kinds.pop("", [])
    return listing([*(of_kind(kind, some) for kind, some in kinds.items()), *others])
