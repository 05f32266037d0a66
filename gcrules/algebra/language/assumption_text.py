r"""Reading what is assumed of points: collinear(a, b, c), coplanar(…), concurrent(…), incident(X, Y), LHS == RHS."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr
from gcrules.algebra.language.parse_tree import Node, span_of
from gcrules.algebra.language.syntax import Builder
from gcrules.algebra.names import step_name
from gcrules.algebra.space import Assumption, SourcePlace
from gcrules.core.errors import InputError, StepError

__all__ = ["read_assumption"]


def read_assumption(tree: Node, builder: Builder, text: str, place: SourcePlace | None = None) -> Assumption:
    """The assumption of a parse tree; `text` is how it was written, `place` where. Raises StepError, InputError."""
    if tree.data == "equal":
        left, right = builder.equation(tree.children[0])
        zero = left if right == ex.ZERO else right if left == ex.ZERO else ex.sub(left, right, rank=builder.rank)
        return Assumption("zero", (zero,), text, place)
    token, *parts = tree.children
    kind = str(token)
    args = tuple(map(builder.value, parts))
    _RELATIONS[kind](args, parts, builder.rank)
    return Assumption(kind, args, text, place)


def _points_only(number: int) -> Callable[[tuple[Expr, ...], list[Node], int], None]:
    """A check that all arguments are points, at least so many."""

    def check(args: tuple[Expr, ...], trees: list[Node], rank: int) -> None:
        for arg, tree in zip(args, trees, strict=True):
            if arg.step != 1:
                hint = "separate the points with commas" if isinstance(arg, ex.Join) else None
                what = f"{step_name(arg.step, rank)} where a point is expected"
                raise StepError(what, span=span_of(tree), hint=hint)
        if len(args) < number:
            found = "1 point is" if len(args) == 1 else f"{len(args)} points are"
            raise InputError(f"{found} always so; at least {number} are expected")

    return check


def _steps_between(number: int) -> Callable[[tuple[Expr, ...], list[Node], int], None]:
    """At least `number` extensors that are neither scalars nor the whole space."""

    def check(args: tuple[Expr, ...], trees: list[Node], rank: int) -> None:
        for arg, tree in zip(args, trees, strict=True):
            if not 1 <= arg.step < rank:
                raise StepError(f"{step_name(arg.step, rank)} where an extensor is expected", span=span_of(tree))
        if len(args) < number:
            raise InputError(f"at least {number} extensors are expected, found {len(args)}")

    return check


def _pair(args: tuple[Expr, ...], trees: list[Node], rank: int) -> None:
    _steps_between(2)(args, trees, rank)
    if len(args) != 2:
        raise InputError(f"incident(X, Y) has two extensors, found {len(args)}")


_RELATIONS: Mapping[str, Callable[[tuple[Expr, ...], list[Node], int], None]] = {
    "collinear": _points_only(3),
    "coplanar": _points_only(4),
    "concurrent": _steps_between(2),
    "incident": _pair,
}
