"""The printed form of an expression as a short list of signs, which LaTeX and MathML each spell in their own way.

What needs parentheses, which sign a term carries and where commas stand is decided here, once.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import groupby

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
from gcrules.core.budget import watched

__all__ = ["Digits", "Mark", "Name", "Raised", "Sign", "Term", "signs", "split_name", "terms"]


@dataclass(frozen=True, slots=True)
class Name:
    """A point, with a dot above where the dotted notation puts one."""

    name: str
    dotted: bool = False


@dataclass(frozen=True, slots=True)
class Digits:
    """A rational number without its sign."""

    value: int | Fraction


@dataclass(frozen=True, slots=True)
class Mark:
    """A sign: one of ∨ ∧ + − , [ ] [[ ]] ( ), a thin `space`, or `negative` (the minus sign before a term)."""

    sign: str


@dataclass(frozen=True, slots=True)
class Raised:
    """A base with an exponent."""

    base: tuple[Sign, ...]
    exponent: int


Sign = Name | Digits | Mark | Raised
Term = tuple[Sign, ...]


def signs(e: Expr) -> Term:
    """All signs of an expression from left to right."""
    return tuple(_signs(e))


def terms(e: Expr) -> list[Term]:
    """The terms of a sum, each with the sign that stands before it (none before a first term that is positive)."""
    if not isinstance(e, Sum):
        return [signs(e)]
    return [signs(e.terms[0]), *(tuple(_later_term(t)) for t in watched(e.terms[1:]))]


def split_name(name: str) -> tuple[str, str, str]:
    """Stem, subscript and primes of the name of a point.

    >>> split_name("S_12'"), split_name("left")
    (('S', '12', "'"), ('left', '', ''))
    """
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
            yield Name(name)
        case Join(args=args):
            if _side_by_side(e):
                yield from _points(args)
            else:
                yield from _joined(args)
        case Meet(args=args):
            yield from _listed(args, Mark("∧"), bare=(Point,))
        case Bracket(args=args):
            yield Mark("[")
            yield from _points(args) if all(isinstance(a, Point) for a in args) else _comma_separated(args)
            yield Mark("]")
        case Dotted(brackets=brackets):
            for entries in brackets:
                yield Mark("[")
                yield from _spaced([Name(n, d) for n, d in entries])
                yield Mark("]")
        case Superbracket(lines=lines):
            yield Mark("[[")
            yield from _comma_separated(lines)
            yield Mark("]]")
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
    first = e.factors[0] if isinstance(e, Product) else e
    negative = isinstance(first, Number) and first.value < 0
    yield Mark("−" if negative else "+")
    yield from _wrapped(neg(e), _ALL_BUT_SUMS) if negative else _signs(e)


_ALL_BUT_SUMS = (Number, Point, Join, Meet, Bracket, Dotted, Superbracket, Power, Product)


def _product(factors: tuple[Expr, ...]) -> Iterator[Sign]:
    for i, f in enumerate(watched(factors)):
        if isinstance(f, Number):
            yield from _signs(f) if f.value != -1 else (Mark("negative"),)
            continue
        bare = (Bracket, Superbracket, Dotted, Power, Point)
        if (isinstance(f, Point) or _side_by_side(f)) and i and factors[i - 1] != Number(-1):
            yield Mark("space")
        yield from _wrapped(f, bare)


def _joined(args: tuple[Expr, ...]) -> Iterator[Sign]:
    """Neighbouring points side by side, everything else in parentheses."""
    first = True
    for is_point, run in groupby(args, lambda a: isinstance(a, Point)):
        for part in [_points(tuple(run))] if is_point else [_wrapped(a, ()) for a in run]:
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
    for i, a in enumerate(args):
        if i:
            yield Mark(",")
        yield from _signs(a)


def _points(args: tuple[Expr, ...]) -> Iterator[Sign]:
    return _spaced([Name(a.name) for a in args if isinstance(a, Point)])


def _spaced(names: list[Name]) -> Iterator[Sign]:
    """Names side by side, set apart by thin spaces if one of them is a word."""
    words = any(len(split_name(n.name)[0]) > 1 for n in names)
    for i, n in enumerate(names):
        if i and words:
            yield Mark("space")
        yield n


def _side_by_side(e: Expr) -> bool:
    return isinstance(e, Join) and all(isinstance(a, Point) for a in e.args)


def _wrapped(e: Expr, bare: tuple[type[Expr], ...]) -> Iterator[Sign]:
    if isinstance(e, bare) or _side_by_side(e):
        yield from _signs(e)
    else:
        yield Mark("(")
        yield from _signs(e)
        yield Mark(")")
