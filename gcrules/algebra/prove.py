r"""Equality of expressions, decided: proved by equal normal forms, or refuted by exact points.

Under assumptions both sides are written out with the points that satisfy them by construction (see `given`).

>>> from gcrules.algebra.language.syntax import parse_equation
>>> print(prove(*parse_equation("ab /\\ cd == [abcd]")).verdict)
proved
>>> print(prove(*parse_equation("ab /\\ cde == cde /\\ ab")).verdict)
proved
>>> print(prove(*parse_equation("a /\\ bcd == bcd /\\ a")).verdict)
refuted
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field, replace
from fractions import Fraction
from itertools import combinations
from typing import Any

from gcrules.algebra.assumptions.assumed import kinds
from gcrules.algebra.assumptions.building import coinciding
from gcrules.algebra.assumptions.construction import Construction
from gcrules.algebra.assumptions.frame import Frame, zero_by
from gcrules.algebra.assumptions.nondegeneracy import chosen, fewest, met, words
from gcrules.algebra.bracket import tableau_order
from gcrules.algebra.claims import error_below
from gcrules.algebra.duality import Dual
from gcrules.algebra.evaluate import evaluate, random_rational_points, vanishes
from gcrules.algebra.expand import MAX_TERMS
from gcrules.algebra.expr import MAX_COEFFICIENT_BITS, ZERO, Expr, common_rank, neg, points_of, sub
from gcrules.algebra.language.text import number_text, text
from gcrules.algebra.letters import marks_in
from gcrules.algebra.space import Assumption, Space
from gcrules.algebra.straightening.straighten import is_zero
from gcrules.algebra.weights import unit_weights
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached, StepError
from gcrules.core.frozen import FrozenMap
from gcrules.core.shown import Shown

__all__ = ["KindVerdict", "Proof", "assuming", "difference_of", "prove"]

_SAMPLES = 3
_TRIES = 400  # small positions that are tried
_BETTER = 60  # among these a counterexample is sought whose points all differ
_EQUAL = f"; equal at {_SAMPLES} exact random points"
_SATISFYING = ", which satisfy the assumptions"
_ANY_WEIGHT = ", of any weight); they are equal wherever every finite point has last coordinate 1"
_VERDICTS, _DO = ("refuted", "undecided", "proved"), ("does", "do")


@dataclass(frozen=True)
class KindVerdict:
    """The verdict for one kind of positions, at which the scalars of `where` vanish (texts of the language)."""

    where: tuple[str, ...]
    verdict: str
    assumed: tuple[str, ...] = ()
    together: tuple[tuple[str, str], ...] = ()

    def to_json(self) -> dict[str, Any]:
        """`{where, verdict, assumed, together}`."""
        return {
            "where": list(self.where),
            "verdict": self.verdict,
            "assumed": list(self.assumed),
            "together": list(map(list, self.together)),
        }

    def __str__(self) -> str:
        where = " and ".join(f"{e} == 0" for e in self.where)
        condition = f", where {' and '.join(self.assumed)} {_DO[len(self.assumed) > 1]} not vanish"
        one = f" ({'; '.join(f'{a} and {b} coincide there' for a, b in self.together)})"
        return f"where {where}: {self.verdict}{condition if self.assumed else ''}{one if self.together else ''}"


@dataclass(frozen=True)
class Proof(Shown):
    """The answer to LHS == RHS and how sure it is.

    `verdict` is "proved" (the normal form of the difference is 0, or with the method "frame" what it is in
    coordinates), "refuted" (`counterexample` holds exact homogeneous coordinates at which the sides, `values`, differ)
    or "undecided" (`reason` names the limit and what is known).
    `assumed` lists, as text, what was assumed not to vanish (`conditions`): a claim that is proved holds wherever its
    assumptions hold and none of these is zero. Without assumptions that is everywhere; a refutation assumes nothing.
    `together` lists pairs of points or letters that coincide at all positions that the proof reaches, though nothing
    says so: then it does not speak of others. Where assumptions allow several kinds of positions, `kinds` holds the
    verdict for each; proved is what is proved for all of them, refuted what is refuted for one. A claim that is one
    `relation` may be several equations; then `parts` holds the proofs of all, and the sides are those of the one that
    decides. A claim is about all homogeneous coordinates of its points; `unit_weights` says that one that is refuted
    holds nevertheless wherever finite points have last coordinate 1. `rank`, `ideal` and `given` are those of the
    claim, which is about positions at which nothing of `nonzero` vanishes. With a `dual` that is what is claimed, of
    hyperplanes; all else is about points.
    """

    left: Expr
    right: Expr
    verdict: str
    method: str
    reason: str = ""
    counterexample: Mapping[str, tuple[int | Fraction, ...]] | None = None
    values: tuple[Any, Any] | None = None
    assumed: tuple[str, ...] = ()
    meanings: tuple[str, ...] = field(default=(), compare=False, repr=False)
    conditions: tuple[Expr, ...] = field(default=(), compare=False, repr=False)
    nonzero: tuple[Expr, ...] = field(default=(), compare=False, repr=False)
    together: tuple[tuple[str, str], ...] = ()
    kinds: tuple[KindVerdict, ...] = ()
    unit_weights: bool = False
    relation: str = ""
    parts: tuple[Proof, ...] = field(default=(), compare=False, repr=False)
    rank: int = field(default=4, compare=False, repr=False)
    ideal: tuple[str, ...] = field(default=(), compare=False, repr=False)
    given: tuple[Assumption, ...] = field(default=(), compare=False, repr=False)
    dual: Dual | None = None

    def __post_init__(self) -> None:
        if self.counterexample is not None:
            object.__setattr__(self, "counterexample", FrozenMap(self.counterexample))

    @property
    def proved(self) -> bool:
        """Whether the verdict is "proved"; False may also mean that it is undecided."""
        return self.verdict == "proved"

    def to_json(self) -> dict[str, Any]:
        """`{verdict, method, reason, counterexample {point: coordinates}, values [left, right], assumed, together,
        kinds, unit_weights}`, and of a dual `dual {letters, given, claims}`.
        """
        points = {n: _plain(c) for n, c in self.counterexample.items()} if self.counterexample is not None else None
        values = [_plain(v) for v in self.values] if self.values else None
        found = {
            "verdict": self.verdict,
            "method": self.method,
            "reason": self.reason,
            "counterexample": points,
            "values": values,
            "assumed": list(self.assumed),
            "together": list(map(list, self.together)),
            "kinds": [k.to_json() for k in self.kinds],
            "unit_weights": self.unit_weights,
        }
        if self.dual is None:
            return found
        told = {"letters": list(self.dual.letters), "given": list(self.dual.given), "claims": list(self.dual.claims)}
        return found | {"dual": told}


def prove(
    left: Expr,
    right: Expr,
    *,
    points: Iterable[str] = (),
    ideal: Iterable[str] = (),
    rank: int | None = None,
    given: Iterable[Assumption] = (),
    nonzero: Iterable[Expr] = (),
    limit: int = MAX_TERMS,
) -> Proof:
    """Decide whether two expressions of equal step are equal for all positions of their points.

    Points in `ideal` are at infinity (last coordinate 0). With `given` only positions that satisfy these assumptions
    count, and with `nonzero` only those at which none of these expressions vanishes: a counterexample is sought there,
    and what is proved may hold elsewhere too.
    Raises StepError for unlike steps (zero goes with any), InputError for assumptions that are not resolved.
    """
    if left.step != right.step and ZERO not in (left, right):
        raise StepError(f"an expression of step {left.step} cannot equal one of step {right.step}")
    assumptions = tuple(given)
    rank = common_rank(rank, left, right, *(e for a in assumptions for e in a.args))
    difference = difference_of(left, right, rank)
    order, at_infinity = tuple(points), tuple(ideal)
    space, where = Space(rank, order, at_infinity, assumptions), _Positions.of(assumptions, nonzero)
    proof = (_under_assumptions if assumptions else _everywhere)(left, right, difference, space, where, limit)
    return replace(proof, rank=rank, ideal=at_infinity, given=assumptions, nonzero=where.nonzero)


@dataclass(frozen=True)
class _Positions:
    """Those that a claim is about, beside its assumptions: where expressions vanish, and others do not."""

    zero: tuple[Expr, ...]
    nonzero: tuple[Expr, ...]

    @classmethod
    def of(cls, given: Sequence[Assumption], nonzero: Iterable[Expr]) -> _Positions:
        existing = dict.fromkeys((*nonzero, *(e for a in given for e in a.exists)))
        return cls(tuple(dict.fromkeys(e for a in given for e in a.also)), tuple(existing))

    @property
    def names(self) -> tuple[str, ...]:
        return points_of(*self.zero, *self.nonzero)

    def counts(self, points: Mapping[str, Sequence[Any]]) -> bool:
        """Whether a position is one of them."""
        return all(_differ(evaluate(e, points), 0) for e in self.nonzero) and not any(
            _differ(evaluate(e, points), 0) for e in self.zero
        )


def difference_of(left: Expr, right: Expr, rank: int) -> Expr:
    """left − right, where 0 may stand for an extensor of any step. Raises StepError where the steps differ."""
    return neg(right) if left == ZERO else left if right == ZERO else sub(left, right, rank=rank)


def _everywhere(left: Expr, right: Expr, difference: Expr, space: Space, where: _Positions, limit: int) -> Proof:
    """Random points first, then the normal form."""
    rank, ideal, known = space.rank, space.ideal, ""
    try:
        if not vanishes(difference, rank=rank, ideal=ideal, samples=_SAMPLES):
            return _refuted(left, right, difference, space, where, limit)
        known = f"{_EQUAL} ({error_below(difference, _SAMPLES)})"
        zero = zero_by(
            _anywhere(points_of(left, right), rank, ideal),
            difference,
            lambda most: is_zero(difference, points=space.points, ideal=ideal, rank=rank, limit=most),
            limit,
        )
        if not zero:  # the coefficients of the difference are multiples of that prime
            return _refuted(left, right, difference, space, where, limit)
    except LimitReached as limited:
        return Proof(left, right, "undecided", "random-points", _reason(limited, known))
    if isinstance(zero, Frame):
        return Proof(left, right, "proved", "frame", _in_frame(zero))
    return Proof(left, right, "proved", "normal-form", "both sides have the same normal form of standard tableaux")


def _anywhere(names: tuple[str, ...], rank: int, ideal: tuple[str, ...]) -> Construction:
    """The construction of points of which nothing is given."""
    at_infinity = tuple(n for n in names if n in ideal)
    return Construction(rank, tableau_order(names, (), at_infinity), at_infinity, points=names)


def _in_frame(frame: Frame) -> str:
    """Both sides are equal, in which coordinates."""
    *others, last = frame.base
    told = f"{', '.join(others)} and {last}" if others else last
    if frame.unit:
        told += f" are the basis and {frame.unit} is their sum"
    else:
        told += " are the basis" if others else " is the first point of the basis"
    if any(":" in n or marks_in(n) for n in (*frame.base, frame.unit or "")):
        told = "points of the construction are the basis"
    return f"both sides are the same polynomial in coordinates in which {told}"


def _under_assumptions(left: Expr, right: Expr, difference: Expr, space: Space, where: _Positions, limit: int) -> Proof:
    """The proof at each kind of position that the assumptions allow, taken together."""
    try:
        found = met(kinds(space, (*points_of(left, right), *where.names), (difference,)), where.nonzero)
    except LimitReached as limited:
        reason = _reason(limited, "; the assumptions are not resolved")
        return Proof(left, right, "undecided", "random-points", reason)
    names = space.declared()
    proofs = [_at_one_kind(left, right, difference, kind.construction, space, where, limit) for kind in found]
    if len(proofs) == 1:
        return proofs[0]
    told = tuple(
        KindVerdict(tuple(text(e, names=names) for e in kind.where), p.verdict, p.assumed, p.together)
        for kind, p in zip(found, proofs, strict=True)
    )
    worst = min(proofs, key=lambda p: (_VERDICTS.index(p.verdict), p.unit_weights))
    if not worst.proved:
        return replace(worst, assumed=(), meanings=(), together=(), kinds=told)
    # Each kind says what it leaves out; what an image leaves out is of that kind, and not left out by all.
    assumed = fewest(e for kind in found if not kind.image for e in kind.construction.nonzero)
    return replace(assuming(proofs[0], assumed, space), together=(), kinds=told)


def assuming(proof: Proof, nonzero: Iterable[Expr], space: Space) -> Proof:
    """The proof with what it assumes not to vanish."""
    found, names = chosen(nonzero, space.rank), space.declared()
    assumed, told = tuple(text(e, names=names) for e in found), tuple(words(e, names) for e in found)
    return replace(proof, assumed=assumed, meanings=told, conditions=found)


def _at_one_kind(
    left: Expr,
    right: Expr,
    difference: Expr,
    construction: Construction,
    space: Space,
    where: _Positions,
    limit: int,
) -> Proof:
    """Random points of the construction first, then its normal form."""
    known = ""
    try:
        if not construction.vanishes(difference, samples=_SAMPLES):
            return _refuted_under(left, right, difference, construction, where, limit)
        known = f"{_EQUAL} that satisfy the assumptions ({construction.error_below(difference, _SAMPLES)})"
        zero = zero_by(construction, difference, lambda most: construction.is_zero(difference, limit=most), limit)
        if not zero:
            return _refuted_under(left, right, difference, construction, where, limit)
    except LimitReached as limited:
        found = Proof(left, right, "undecided", "random-points", _reason(limited, known))
    else:
        reason = "both sides have the same normal form at the points that satisfy the assumptions"
        if isinstance(zero, Frame):
            reason = f"{_in_frame(zero)}, at all points that satisfy the assumptions"
        method = "frame" if isinstance(zero, Frame) else "normal-form"
        found = Proof(left, right, "proved", method, reason)
    found = assuming(found, construction.nonzero, space)
    return replace(found, together=coinciding(construction, space.given))


def _reason(limited: LimitReached, known: str) -> str:
    return limited.message + known + (f"; {limited.hint}" if limited.hint else "")


def _refuted_under(
    left: Expr,
    right: Expr,
    difference: Expr,
    construction: Construction,
    where: _Positions,
    limit: int,
    which: str = _SATISFYING,
) -> Proof:
    """Small exact coordinates that satisfy the assumptions, at which the sides differ; best if no two points agree."""
    best: tuple[bool, Mapping[str, Any], tuple[Any, Any]] | None = None
    for seed in range(_TRIES):
        checkpoint()
        found = construction.rational_points(seed, 1 + seed // 8)
        if found is None or not where.counts(found):
            continue
        values = evaluate(left, found), evaluate(right, found)
        if _differ(*values) and (best is None or _all_differ(found)):
            best = _all_differ(found), found, values
        if best is not None and (best[0] or seed >= _BETTER):
            break
    if best is None:
        raise LimitReached("the sides differ modulo a prime, but no small coordinates that show it were found")
    shown = {n: best[1][n] for n in tableau_order(best[1], construction.points, construction.ideal)}
    units = any(value[-1] not in (0, 1) for value in shown.values()) and _at_unit_weights(
        difference, construction, limit
    )
    reason = f"the sides differ at these points{which} (homogeneous coordinates{_ANY_WEIGHT if units else ')'}"
    return Proof(left, right, "refuted", "counterexample", reason, shown, best[2], unit_weights=units)


def _at_unit_weights(difference: Expr, construction: Construction, limit: int) -> bool:
    try:
        return unit_weights(difference, construction, limit=limit)
    except LimitReached:
        return False


def _all_differ(points: Mapping[str, Sequence[Any]]) -> bool:
    return all(
        any(a[i] * b[j] != a[j] * b[i] for i, j in combinations(range(len(a)), 2))
        for a, b in combinations(points.values(), 2)
    )


def _refuted(left: Expr, right: Expr, difference: Expr, space: Space, where: _Positions, limit: int) -> Proof:
    """Small whole coordinates at which the sides differ; wider ranges are tried if the first ones do not separate, then
    other last coordinates than 1.
    """
    names = tuple(dict.fromkeys((*points_of(left, right), *where.names)))
    for seed in range(200):
        checkpoint()
        found = random_rational_points(names, rank=space.rank, ideal=space.ideal, seed=seed, size=1 + seed // 4)
        if not where.counts(found):
            continue
        values = evaluate(left, found), evaluate(right, found)
        if _differ(*values):
            reason = "the sides differ at these points (homogeneous coordinates)"
            return Proof(left, right, "refuted", "counterexample", reason, found, values)
    anywhere = _anywhere(names, space.rank, space.ideal)
    return _refuted_under(left, right, difference, anywhere, where, limit, which="")


def _differ(left: Any, right: Any) -> bool:
    if isinstance(left, tuple) and isinstance(right, tuple):
        return left != right
    if isinstance(left, tuple) or isinstance(right, tuple):  # one side is the number 0
        return any(left if isinstance(left, tuple) else right)
    return bool(left != right)


def _plain(value: Any) -> Any:
    if isinstance(value, tuple):
        return [_plain(v) for v in value]
    return value if isinstance(value, int) and value.bit_length() <= MAX_COEFFICIENT_BITS else number_text(value)
