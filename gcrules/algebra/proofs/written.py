"""Expressions as data: lists of the operation and its parts, in which parts that occur again have names."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from gcrules.algebra.bracket import Coefficient
from gcrules.algebra.expr import Dotted, Expr, Number, Point, Power, Sum
from gcrules.algebra.scalars import written_out

__all__ = ["Written", "number"]

_SHALLOW = 2  # joins and brackets of points are written each time


class Written:
    """Expressions as lists of the operation and its parts. Larger parts that occur again are definitions: #1, #2, …"""

    def __init__(self, exprs: Iterable[Expr]) -> None:
        self.definitions: list[list[Any]] = []
        self.named: dict[Expr, str] = {}
        self.known: set[Expr] = set()
        self.again: set[Expr] = set()
        stack = list(exprs)
        while stack:
            e = stack.pop()
            if isinstance(e, Dotted):
                e = written_out(e)
            if e in self.known:
                self.again.add(e)
                continue
            self.known.add(e)
            stack += e.children

    def of(self, e: Expr) -> Any:
        """An expression: the name of a point or definition, or a list."""
        if isinstance(e, Dotted):
            e = written_out(e)
        if isinstance(e, Point):
            return e.name
        if isinstance(e, Number):
            return ["number", number(e.value)]
        if e not in self.again or e.depth <= _SHALLOW:
            return self._parts(e)
        if e not in self.named:
            parts = self._parts(e)
            self.named[e] = f"#{len(self.definitions) + 1}"
            self.definitions.append([self.named[e], parts])
        return self.named[e]

    def _parts(self, e: Expr) -> list[Any]:
        last = [e.exponent] if isinstance(e, Power) else []
        kind = "sum" if isinstance(e, Sum) else type(e).__name__.lower()  # a screw is one, too
        return [kind, *map(self.of, e.children), *last]


def number(value: Coefficient) -> int | str:
    """A number, as a text like "1/2" where it is not whole."""
    exact = Fraction(value)
    return exact.numerator if exact.denominator == 1 else str(exact)
