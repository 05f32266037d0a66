"""Hypothesis strategies: arbitrary well-typed expressions and exact coordinates for their points."""

from __future__ import annotations

from fractions import Fraction
from math import comb

from hypothesis import strategies as st

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr
from gcrules.algebra.scalars import bracket, dotted, power, superbracket

SHORT_NAMES = ("a", "b", "c", "d", "e", "f", "A", "S1", "S_2", "A'", "B2''", "p10")
LONG_NAMES = ("left", "right", "top", "base", "ab", "arm_1")
RANKS = st.integers(2, 6)

fractions = st.builds(Fraction, st.integers(-12, 12), st.integers(1, 9))


@st.composite
def compositions(draw: st.DrawFn, total: int, parts: int) -> list[int]:
    """`total` as an ordered sum of `parts` positive whole numbers."""
    cuts = sorted(draw(st.permutations(range(1, total)))[: parts - 1])
    return [b - a for a, b in zip([0, *cuts], [*cuts, total], strict=True)]


@st.composite
def expressions(
    draw: st.DrawFn, rank: int, step: int | None = None, *, depth: int = 3, names: tuple[str, ...] = SHORT_NAMES
) -> Expr:
    """Any expression of the given rank (and step), built by the checking functions, of every kind of node."""

    def of(step: int, depth: int) -> Expr:
        if depth == 0:
            kind = "points" if step else "bracket"
        else:
            kind = draw(st.sampled_from(_EXTENSORS if step else _SCALARS))
        match kind:
            case "number":
                return ex.Number(draw(fractions))
            case "points":
                return ex.join(*map(point, range(step)), rank=rank)
            case "bracket":
                return bracket(*map(point, range(rank)), rank=rank)
            case "extensors":
                return bracket(*(of(k, depth - 1) for k in split(rank)), rank=rank)
            case "join":
                return ex.join(*(of(k, depth - 1) for k in split(step)), rank=rank)
            case "dotted":
                return dotted(*(entries() for _ in range(draw(st.integers(1, 3)))), rank=rank)
            case "superbracket" if rank <= 4:
                lines = (of(2, draw(st.integers(0, depth - 1))) for _ in range(comb(rank, 2)))
                return superbracket(*lines, rank=rank)
            case "meet" | "superbracket":
                return meet(step, depth)
            case "sum":
                return ex.add(*(of(step, depth - 1) for _ in range(draw(st.integers(2, 3)))), rank=rank)
            case "minus":
                return ex.sub(of(step, depth - 1), of(step, depth - 1), rank=rank)
            case "product":
                scalars = [of(0, depth - 1) for _ in range(draw(st.integers(1, 2)))]
                place = draw(st.integers(0, len(scalars)))
                return ex.mul(*scalars[:place], of(step, depth - 1), *scalars[place:])
            case "negated":
                return ex.mul(ex.Number(-1), of(step, depth - 1))
        return power(of(0, depth - 1), draw(st.integers(0, 4)), rank=rank)

    def meet(step: int, depth: int) -> Expr:
        # The larger step comes first: flattening `line ∧ (line ∧ whole space)` would meet a scalar on the way.
        first = draw(st.integers((step + rank + 1) // 2, min(rank, step + rank - 1)))
        return ex.meet(of(first, depth - 1), of(step + rank - first, depth - 1), rank=rank)

    def point(_: int = 0) -> ex.Point:
        return ex.Point(draw(st.sampled_from(names)))

    def split(total: int) -> list[int]:
        return draw(compositions(total, draw(st.integers(1, total))))

    def entries() -> list[tuple[str, bool]]:
        return [(point().name, draw(st.booleans())) for _ in range(rank)]

    return of(draw(st.integers(0, rank)) if step is None else step, depth)


_COMMON = ("meet", "sum", "minus", "product", "negated")
_SCALARS = ("number", "bracket", "extensors", "dotted", "superbracket", "power", *_COMMON)
_EXTENSORS = ("points", "join", *_COMMON)


def coordinates(names: tuple[str, ...], rank: int, *, size: int = 6) -> st.SearchStrategy[dict[str, tuple[int, ...]]]:
    """Small whole homogeneous coordinates for each name."""
    column = st.tuples(*[st.integers(-size, size)] * rank)
    return st.fixed_dictionaries(dict.fromkeys(names, column))
