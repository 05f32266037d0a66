r"""Equality of expressions, decided: proved by equal normal forms, or refuted by exact points.

>>> from gcrules.algebra.syntax import parse_equation
>>> print(prove(*parse_equation("ab /\\ cd == [abcd]")).verdict)
proved
>>> print(prove(*parse_equation("ab /\\ cde == cde /\\ ab")).verdict)
proved
>>> print(prove(*parse_equation("a /\\ bcd == bcd /\\ a")).verdict)
refuted
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from gcrules.algebra.evaluate import evaluate, random_rational_points, vanishes
from gcrules.algebra.expand import MAX_TERMS
from gcrules.algebra.expr import MAX_COEFFICIENT_BITS, ZERO, Expr, common_rank, neg, points_of, sub
from gcrules.algebra.straighten import straighten
from gcrules.algebra.text import text
from gcrules.errors import LimitReached, StepError
from gcrules.frozen import FrozenMap

__all__ = ["Proof", "prove"]

_SAMPLES = 3
_SIGNS = {"proved": "=", "refuted": "\\neq", "undecided": "\\stackrel{?}{=}"}


@dataclass(frozen=True)
class Proof:
    """The answer to LHS == RHS and how sure it is.

    `verdict` is "proved" (the normal form of the difference is 0), "refuted" (`counterexample` holds exact homogeneous
    coordinates at which the sides, `values`, differ) or "undecided" (`reason` names the limit and what is known).
    `assumed` lists what was assumed not to vanish: nothing, an identity holds everywhere.
    """

    left: Expr
    right: Expr
    verdict: str
    method: str
    reason: str = ""
    counterexample: Mapping[str, tuple[int, ...]] | None = None
    values: tuple[Any, Any] | None = None
    assumed: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        if self.counterexample is not None:
            object.__setattr__(self, "counterexample", FrozenMap(self.counterexample))

    @property
    def proved(self) -> bool:
        """Whether the verdict is "proved"; False may also mean that it is undecided."""
        return self.verdict == "proved"

    def to_json(self) -> dict[str, Any]:
        """`{verdict, method, reason, counterexample {point: coordinates}, values [left, right], assumed}`."""
        points = {n: list(c) for n, c in self.counterexample.items()} if self.counterexample is not None else None
        values = [_plain(v) for v in self.values] if self.values else None
        return {
            "verdict": self.verdict,
            "method": self.method,
            "reason": self.reason,
            "counterexample": points,
            "values": values,
            "assumed": list(self.assumed),
        }

    def text(self, *, unicode: bool = False) -> str:
        """The verdict in words, with the counterexample if there is one."""
        claim = f"{text(self.left, unicode=unicode)} == {text(self.right, unicode=unicode)}"
        lines = [f"{self.verdict}: {claim}", f"  {self.reason}"]
        if self.counterexample is not None and self.values is not None:
            lines += [f"  {name} = ({', '.join(map(str, c))})" for name, c in self.counterexample.items()]
            lines += [f"  left side  = {_shown(self.values[0])}", f"  right side = {_shown(self.values[1])}"]
        return "\n".join(lines)

    def latex(self) -> str:
        """The sides with the sign that the verdict calls for, without dollar signs."""
        from gcrules.render.latex import latex  # needed for LaTeX only

        return f"{latex(self.left)} {_SIGNS[self.verdict]} {latex(self.right)}"

    def __str__(self) -> str:
        return self.text()

    def _repr_latex_(self) -> str:
        return f"$\\displaystyle {self.latex()}$"


def prove(
    left: Expr,
    right: Expr,
    *,
    points: Iterable[str] = (),
    ideal: Iterable[str] = (),
    rank: int | None = None,
    limit: int = MAX_TERMS,
) -> Proof:
    """Decide whether two expressions of equal step are equal for all positions of their points.

    Points in `ideal` are at infinity (last coordinate 0). Raises StepError for unlike steps (zero goes with any).
    """
    if left.step != right.step and ZERO not in (left, right):
        raise StepError(f"an expression of step {left.step} cannot equal one of step {right.step}")
    rank = common_rank(rank, left, right)
    at_infinity = tuple(ideal)
    difference = neg(right) if left == ZERO else left if right == ZERO else sub(left, right, rank=rank)
    known = ""
    try:
        if not vanishes(difference, rank=rank, ideal=at_infinity, samples=_SAMPLES):
            return _refuted(left, right, rank, at_infinity)
        known = f"; equal at {_SAMPLES} exact random points modulo a prime near 2**61 (error below 1e-30)"
        if straighten(difference, points=points, ideal=at_infinity, rank=rank, limit=limit):
            # The coefficients of the difference are multiples of that prime.
            return _refuted(left, right, rank, at_infinity)
    except LimitReached as limited:
        advice = f"; {limited.hint}" if limited.hint else ""
        return Proof(left, right, "undecided", "random-points", limited.message + known + advice)
    return Proof(left, right, "proved", "normal-form", "both sides have the same normal form of standard tableaux")


def _refuted(left: Expr, right: Expr, rank: int, ideal: tuple[str, ...]) -> Proof:
    """Small whole coordinates at which the sides differ; wider ranges are tried if the first ones do not separate."""
    for seed in range(200):
        found = random_rational_points(points_of(left, right), rank=rank, ideal=ideal, seed=seed, size=1 + seed // 4)
        values = evaluate(left, found), evaluate(right, found)
        if _differ(*values):
            reason = "the sides differ at these points (homogeneous coordinates)"
            return Proof(left, right, "refuted", "counterexample", reason, found, values)
    raise LimitReached("the sides differ modulo a prime, but no small whole coordinates that show it were found")


def _differ(left: Any, right: Any) -> bool:
    if isinstance(left, tuple) and isinstance(right, tuple):
        return left != right
    if isinstance(left, tuple) or isinstance(right, tuple):  # one side is the number 0
        return any(left if isinstance(left, tuple) else right)
    return bool(left != right)


def _plain(value: Any) -> Any:
    if isinstance(value, tuple):
        return [_plain(v) for v in value]
    return value if isinstance(value, int) and value.bit_length() <= MAX_COEFFICIENT_BITS else _shown(value)


def _shown(value: Any) -> str:
    if isinstance(value, tuple):
        return f"({', '.join(map(_shown, value))})"
    bits = max(abs(value.numerator), value.denominator).bit_length()
    return str(value) if bits <= MAX_COEFFICIENT_BITS else f"a number of {bits:,} bits"
