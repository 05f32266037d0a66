r"""Expressions in which polars and poles for letters of conics and quadrics stay what they are, for duals of claims.

>>> from gcrules.algebra.language.parse_tree import read
>>> from gcrules.algebra.language.statements import parse_assumption
>>> at = parse_assumption("conic K", Context(3))
>>> print(read("second_on_conic(p, a, K)", "expression", "<input>", lambda t: WithPolars(at).value(t.children[0])))
[p, polar(a, K)] * p - 1/2[p, polar(p, K)] * a
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr
from gcrules.algebra.language.conic_words import conic_behind
from gcrules.algebra.language.letter_words import CONSTRUCTIONS_OF_LETTERS
from gcrules.algebra.language.parse_tree import Node
from gcrules.algebra.language.syntax import Builder, Context
from gcrules.algebra.language.words import CONSTRUCTIONS
from gcrules.algebra.polars import Polar, form_at, second_of
from gcrules.algebra.space import Written

__all__ = ["WithPolars"]

_Made = Callable[..., Expr]

_MADE: Mapping[str, _Made] = {
    "polar": Polar,
    "pole": Polar,
    "tangent": Polar,
    "conic": form_at,
    "quadric": form_at,
    "second_on_conic": second_of,
    "second_on_quadric": second_of,
}
"""What the words make of their arguments, the letter and the rank."""


class WithPolars(Builder):
    """Builds what a `Builder` has read before, and found to be in order."""

    def __init__(self, context: Context) -> None:
        super().__init__(context)
        self.forms: dict[Expr, Written] = {}  # those of letters at points, with what it says that they are zero

    def construction(self, tree: Node) -> Expr:
        token, *parts = tree.children
        of_letters = CONSTRUCTIONS_OF_LETTERS.get(self.rank, {})
        parts, letter = conic_behind(str(token), of_letters, CONSTRUCTIONS, parts, self.context.conics, self.rank)
        if not letter:
            return super().construction(tree)
        args = tuple(map(self.value, parts))
        made = _MADE[str(token)](*args, letter, self.rank)
        if not made.step:
            self.forms[made] = Written("on", args, letter)
        return made

    def named(self, name: str) -> Expr:
        found = self.context.with_polars.get(name)
        return super().named(name) if found is None else found

    def said(self, left: Expr, right: Expr) -> Written:
        """What an equation says: that a point is on a conic or a quadric where it says that a form is zero."""
        other = left if right == ex.ZERO else right if left == ex.ZERO else None
        found = None if other is None else self.forms.get(other)
        return found or Written("equal", (left, right))
