r"""Zeros of factors compared: what one of them implies, and which vanish for more than one reason."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cache

from gcrules.algebra.expr import Expr
from gcrules.core.errors import LimitReached
from gcrules.mechanisms.conditions.factor_causes import ASIDE, FactorCause, at_member
from gcrules.mechanisms.description.family import Family
from gcrules.mechanisms.lines.equivalent import Equivalent
from gcrules.mechanisms.lines.random_lines import LineOfLimbs
from gcrules.mechanisms.lines.singular import Poly, divided, gcd, interpolated, radical

__all__ = ["of_several_kinds", "without_repetition"]


def of_several_kinds(family: Family, structure: Equivalent, factors: Sequence[Expr]) -> frozenset[Expr]:
    """Factors that vanish, at some members and not at all, where the constraints of all limbs lose rank, or where the
    lines that were chosen for one limb depend on each other. All of them where that cannot be told.
    """
    try:
        return frozenset(_of_several_kinds(LineOfLimbs(family, structure), structure, factors))
    except LimitReached:
        return frozenset(factors)


def _of_several_kinds(along: LineOfLimbs, structure: Equivalent, factors: Sequence[Expr]) -> Iterator[Expr]:
    zeros = [along.dependent(limb.lines or ()) for limb in structure.limbs]
    if along.size and not along.whole:
        zeros.append(along.common)
    zeros = [radical(f) for f in zeros if len(f) > 1]
    for e in factors if zeros else ():
        own = radical(along.polynomial(lambda t, e=e: along.value(e, t)))  # type: ignore[misc]
        if any(1 < len(gcd(own, f)) < len(own) for f in zeros):
            yield e


def without_repetition(family: Family, structure: Equivalent, parts: Sequence[FactorCause]) -> tuple[FactorCause, ...]:
    """The parts, of which each that one of the same kind implies names that one in `same`.

    Of two that vanish together the second names the first. On a random line in the parameters of the family it is seen
    whether the zeros of one polynomial are among those of the other, exactly.
    """
    live = [p for p in parts if p.kind not in ASIDE]
    if len(live) < 2:
        return tuple(parts)
    member = cache(family.across("repetition"))

    def zeros(e: Expr) -> Poly:
        found = interpolated(lambda t: int(at_member(family, structure, member(t)).value(e)[0]))
        return radical(found or [])

    known = {p.expression: zeros(p.expression) for p in live}
    same: dict[Expr, Expr] = {}
    for p in reversed(live):
        for q in live:
            f, g = known[p.expression], known[q.expression]
            comparable = p is not q and q.expression not in same and q.kind in (p.kind, "mixed")
            if comparable and len(f) > 1 and g and not divided(g, f)[1]:
                same[p.expression] = q.expression
                break
    return tuple(replace(p, same=same.get(p.expression)) for p in parts)
