r"""Rewriting the parts of an expression."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from gcrules.algebra import expr as ex
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
    meet,
    mul,
)
from gcrules.algebra.letters import named_letter, wholes
from gcrules.algebra.scalars import bracket, dotted, power, superbracket
from gcrules.algebra.screw_letters import Screw, with_whole_screws
from gcrules.core.budget import checkpoint
from gcrules.core.errors import InputError

__all__ = ["everywhere", "first_part", "rebuilt", "substitute"]

At = Callable[[Expr], Expr | None]


def rebuilt(e: Expr, children: tuple[Expr, ...], rank: int) -> Expr:
    """The same operation on other parts; −1 times a sum becomes the sum with the other signs."""
    match e:
        case Join():
            return ex.join(*children, rank=rank)
        case Meet():
            return ex.meet(*children, rank=rank)
        case Bracket():
            return bracket(*children, rank=rank)
        case Superbracket():
            return superbracket(*children, rank=e.rank)
        case Sum():
            return ex.add(*children, rank=rank)
        case Product():
            match children:
                case (Number(value=-1), Sum() as total):
                    return ex.signed(-1, total)
            return ex.mul(*children)
        case Power(exponent=n):
            return power(children[0], n, rank)
    raise TypeError(f"no parts: {e!r}")


def first_part(e: Expr, at: At, rank: int) -> Expr | None:
    """The expression with the first part, from the outside in, that `at` replaces; None where it replaces none."""
    checkpoint()
    found = at(e)
    if found is not None:
        return found
    for i, child in enumerate(e.children):
        new = first_part(child, at, rank)
        if new is not None:
            return rebuilt(e, (*e.children[:i], new, *e.children[i + 1 :]), rank)
    return None


def everywhere(e: Expr, at: At, rank: int) -> Expr:
    """The expression with all parts replaced that `at` replaces, from the inside out."""
    checkpoint()
    children = tuple(everywhere(c, at, rank) for c in e.children)
    if any(new is not old for new, old in zip(children, e.children, strict=True)):
        e = rebuilt(e, children, rank)
    found = at(e)
    return e if found is None else found


def substitute(e: Expr, names: Mapping[str, Expr], rank: int = 4) -> Expr:
    """Replace points by expressions (usually other points), and whole letters. Raises StepError where the steps do not
    fit.
    """
    letter = named_letter(e) if isinstance(e, Join) else None
    if letter is not None and letter in names:
        return names[letter]
    match e:
        case Point(name=name):
            return names.get(name, e)
        case Number():
            return e
        case Dotted(brackets=brackets):
            return dotted(*([(_name_of(names, n), d) for n, d in entries] for entries in brackets), rank=rank)
    parts = wholes(e.children) if isinstance(e, Join | Bracket) and letter is None else e.children
    children = tuple(substitute(c, names, rank) for c in parts)
    match e:
        case Screw() if children == e.children:
            return e
        case Product():
            return mul(*children)
        case Meet(rank=own):
            return meet(*children, rank=own)
        case Sum():
            return with_whole_screws(rebuilt(e, children, rank))
    return rebuilt(e, children, rank)


def _name_of(names: Mapping[str, Expr], name: str) -> str:
    target = names.get(name, Point(name))
    if not isinstance(target, Point):
        raise InputError(f"a dotted bracket can only hold points; {name} stands for something else")
    return target.name
