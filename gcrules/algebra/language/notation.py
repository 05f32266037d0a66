"""The printed form of an expression as a short list of signs, which text, LaTeX and MathML each spell in their own way.

What needs parentheses, which sign a term carries and where commas stand is decided here, once.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import groupby, repeat

from gcrules.algebra.expr import (
    Bracket,
    Dotted,
    Expr,
    Join,
    Meet,
    Number,
    Point,
    Power,
    Product,
    Sum,
    Superbracket,
    neg,
)
from gcrules.algebra.letters import grouped, plain_name
from gcrules.algebra.polars import Polar
from gcrules.algebra.screw_letters import Screw
from gcrules.core.budget import watched
from gcrules.core.dataclass import dataclass

__all__ = ["Digits", "Mark", "Raised", "Row", "Sign", "Term", "parts", "signs", "split_name", "terms"]


@dataclass(frozen=True, slots=True)
class Row:
    """Points side by side; `dots` says which have a dot above, in the dotted notation, and is empty elsewhere."""

    names: tuple[str, ...]
    dots: tuple[bool, ...] = ()

    @property
    def words(self) -> bool:
        """Whether one of them is longer than a letter, so that they are set apart."""
        return any(len(split_name(n)[0]) > 1 for n in self.names)

    @property
    def dotted(self) -> Iterator[tuple[str, bool]]:
        """Each name, and whether it has a dot."""
        return zip(self.names, self.dots or repeat(False), strict=False)


@dataclass(frozen=True, slots=True)
class Digits:
    """A rational number without its sign."""

    value: int | Fraction


@dataclass(frozen=True, slots=True)
class Mark:
    """A sign: one of ∨ ∧ + − , [ ] [[ ]] ( ), `negative` (the minus sign before a term), or where factors meet that a
    text joins by a sign of its own `times`, `space` if formulas set them apart too.
    """

    sign: str


@dataclass(frozen=True, slots=True)
class Raised:
    """A base with an exponent."""

    base: tuple[Sign, ...]
    exponent: int


Sign = Row | Digits | Mark | Raised
Term = tuple[Sign, ...]


def signs(e: Expr) -> Term:
    """All signs of an expression from left to right."""
    return tuple(_signs(e))


def terms(e: Expr) -> list[Term]:
    """The terms of a sum, each with the sign that stands before it (none before a first term that is positive)."""
    if not _is_sum(e):
        return [signs(e)]
    return [signs(e.children[0]), *(tuple(_later_term(t)) for t in watched(e.children[1:]))]


def parts(e: Expr) -> Iterator[tuple[Term, Expr]]:
    """The signs in pieces after which a line may end, each with the expression that it shows: terms, operands of a
    meet or join, and in products what stands in parentheses, piece by piece; brackets side by side are one piece.
    """
    match e:
        case Sum(terms=terms) if _is_sum(e):
            yield from parts(terms[0])
            for term in terms[1:]:
                mark, shown = _signed(term)
                inside = _product_parts(shown.factors) if isinstance(shown, Product) else iter([_whole(shown)])
                first, part = next(inside)
                yield (mark, *first), part
                yield from inside
        case Product(factors=factors):
            yield from _product_parts(factors)
        case Meet(args=args):
            for i, a in enumerate(args):
                yield from _operand((Mark("∧"),) * bool(i), a, (Point,))
        case Join(args=args) if not _side_by_side(e):
            before: Term = ()
            for is_point, run in groupby(args, _named):
                together = tuple(run)
                if is_point:
                    yield (*before, _points(together)), Join(together) if len(together) > 1 else together[0]
                for a in () if is_point else together:
                    yield from _operand(before, a, ())
                    before = (Mark("∨"),)
                before = (Mark("∨"),)
        case _:
            yield signs(e), e


def _operand(before: Term, e: Expr, bare: tuple[type[Expr], ...]) -> Iterator[tuple[Term, Expr]]:
    """What is joined or met, with the sign before it; of what is constructed itself the pieces, in parentheses."""
    if not isinstance(e, Meet | Join) or _side_by_side(e):
        yield (*before, *_wrapped(e, bare)), e
        return
    inner = list(parts(e))
    for i, (term, part) in enumerate(inner):
        opened, closed = [Mark("(")] * (not i), [Mark(")")] * (i == len(inner) - 1)
        yield (*before * (not i), *opened, *term, *closed), part


def _whole(e: Expr) -> tuple[Term, Expr]:
    return tuple(_wrapped(e, _ALL_BUT_SUMS)), e


def _product_parts(factors: tuple[Expr, ...]) -> Iterator[tuple[Term, Expr]]:
    """Neighbouring factors other than sums and meets are one piece, but for −1, which is the sign of the next."""
    sign: Term = ()
    for apart, run in groupby(factors, lambda f: isinstance(f, Meet) or _is_sum(f)):
        if not apart:
            together = tuple(run)
            shown = tuple(_product(together))
            if together == (Number(-1),) and len(factors) > 1:
                sign = shown
            else:
                yield shown, Product(together) if len(together) > 1 else together[0]
            continue
        for f in run:
            inner = list(parts(f))
            for i, (term, part) in enumerate(inner):
                first, last = not i, i == len(inner) - 1
                yield (*sign * first, *[Mark("(")] * first, *term, *[Mark(")")] * last), part
            sign = ()


def split_name(name: str) -> tuple[str, str, str]:
    """Stem, subscript and primes of the name of a point.

    >>> split_name("S_12'"), split_name("left")
    (('S', '12', "'"), ('left', '', ''))
    """
    if (marked := plain_name(name)) != name:  # a point of a letter, whose marks stand behind primes too
        letter = name[: next(i for i, c in enumerate(name) if c != marked[i])]
        return letter, marked[len(letter) :], ""
    plain = name.rstrip("'")
    stem = plain.rstrip("0123456789")
    return stem.rstrip("_") or stem, plain[len(stem) :], name[len(plain) :]


def _signs(e: Expr) -> Iterator[Sign]:
    match e:
        case Number(value=value):
            if value < 0:
                yield Mark("negative")
            yield Digits(abs(Fraction(value)))
        case Point(name=name):
            yield Row((name,))
        case Screw():
            yield Row((e.name,))
        case Join(args=args):
            if _side_by_side(e):
                yield _points(args)
            else:
                yield from _joined(args)
        case Meet(args=args):
            yield from _listed(args, Mark("∧"), bare=(Point,))
        case Bracket(args=args):
            yield Mark("[")
            yield from (_points(args),) if all(map(_named, args)) else _comma_separated(args)
            yield Mark("]")
        case Dotted(brackets=brackets):
            for entries in brackets:
                yield Mark("[")
                yield Row(*zip(*entries, strict=True))
                yield Mark("]")
        case Superbracket(lines=lines):
            yield Mark("[[")
            yield from _comma_separated(lines)
            yield Mark("]]")
        case Polar(of=of, letter=letter):
            yield from (Mark(f"{e.word}("), *_signs(of), Mark(","), Row((letter,)), Mark(")"))
        case Power(base=base, exponent=exponent):
            yield Raised(tuple(_wrapped(base, (Bracket, Superbracket))), exponent)
        case Product(factors=factors):
            yield from _product(factors)
        case Sum():
            for term in terms(e):
                yield from term
        case _:
            raise TypeError(f"not an expression: {e!r}")


def _later_term(e: Expr) -> Iterator[Sign]:
    mark, shown = _signed(e)
    yield mark
    yield from _wrapped(shown, _ALL_BUT_SUMS)


def _signed(e: Expr) -> tuple[Mark, Expr]:
    """The sign before a later term of a sum, and what stands after it."""
    first = e.factors[0] if isinstance(e, Product) else e
    negative = isinstance(first, Number) and first.value < 0
    return (Mark("−"), neg(e)) if negative else (Mark("+"), e)


_ALL_BUT_SUMS = (Number, Point, Join, Meet, Bracket, Dotted, Superbracket, Power, Product)


def _product(factors: tuple[Expr, ...]) -> Iterator[Sign]:
    for i, f in enumerate(watched(factors)):
        if isinstance(f, Number):
            yield from _signs(f) if f.value != -1 else (Mark("negative"),)
            continue
        if i and factors[i - 1] != Number(-1):
            if isinstance(f, Point) or _side_by_side(f):
                yield Mark("space")
            elif not (isinstance(f, (Bracket, Superbracket, Meet, Sum)) and not f.step and _closed(factors[i - 1])):
                yield Mark("times")
        yield from _wrapped(f, _BARE_FACTORS)


_BARE_FACTORS = (Bracket, Superbracket, Dotted, Power, Point)


def _closed(e: Expr) -> bool:
    """Whether what follows as a factor needs no sign between, for it begins with a bracket or parenthesis."""
    return isinstance(e, (Number, Bracket, Superbracket, Meet, Sum)) and not e.step


def _joined(args: tuple[Expr, ...]) -> Iterator[Sign]:
    """Neighbouring points side by side, everything else in parentheses."""
    first = True
    for is_point, run in groupby(args, _named):
        for part in [(_points(tuple(run)),)] if is_point else [_wrapped(a, ()) for a in run]:
            if not first:
                yield Mark("∨")
            yield from part
            first = False


def _listed(args: tuple[Expr, ...], mark: Mark, bare: tuple[type[Expr], ...]) -> Iterator[Sign]:
    for i, a in enumerate(args):
        if i:
            yield mark
        yield from _wrapped(a, bare)


def _comma_separated(args: tuple[Expr, ...]) -> Iterator[Sign]:
    first = True
    for is_point, run in groupby(args, _named):
        for part in [(Row((n,)),) for n in _points(tuple(run)).names] if is_point else map(_signs, run):
            if not first:
                yield Mark(",")
            yield from part
            first = False


def _points(args: tuple[Expr, ...]) -> Row:
    return Row(grouped([a.name for a in args if isinstance(a, Point | Screw)]))


def _side_by_side(e: Expr) -> bool:
    return isinstance(e, Screw) or (isinstance(e, Join) and all(map(_named, e.args)))


def _named(e: Expr) -> bool:
    """Whether it is a name, which stands beside others."""
    return isinstance(e, Point | Screw)


def _is_sum(e: Expr) -> bool:
    """Whether it is written as a sum, as a letter for a screw is not."""
    return isinstance(e, Sum) and not isinstance(e, Screw)


def _wrapped(e: Expr, bare: tuple[type[Expr], ...]) -> Iterator[Sign]:
    if isinstance(e, (*bare, Polar)) or _side_by_side(e):
        yield from _signs(e)
    else:
        yield Mark("(")
        yield from _signs(e)
        yield Mark(")")
