r"""Claims about screws that are assumed to be reciprocal to a line or to a screw, which are written so that they are.

Let E be of step 2 and not zero. The screws S with S ∨ E = 0 are the combinations (E ∨ Y) X − (E ∨ X) Y of any screw X
and any line Y: each is one, and S itself is that of X = S and of a Y with E ∨ Y = 1. So what is proved of X and Y holds
for every S.

>>> from gcrules.algebra.language.relations import parse_claim
>>> from gcrules.algebra.language.statements import parse_assumption
>>> from gcrules.algebra.language.syntax import Context
>>> at = parse_assumption("screw S, S \\/ ab == 0, collinear(a, b, c)", Context())
>>> found = reciprocal(parse_claim("S \\/ ac == 0", at), at)
>>> print(*found.nonzero, *found.space.given, *found.values)
ab collinear(a, b, c) S
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import combinations
from typing import Any

from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.assumed import kinds
from gcrules.algebra.assumptions.incidences import fault
from gcrules.algebra.evaluate import plucker, vanishes
from gcrules.algebra.expr import Bracket, Expr, Join, Meet, Number, Product, Sum, points_of
from gcrules.algebra.language.relations import Claimed
from gcrules.algebra.language.text import text
from gcrules.algebra.letters import letter, names_of, wholes
from gcrules.algebra.names import primed
from gcrules.algebra.parts import everywhere, first_part, rebuilt
from gcrules.algebra.prove import Proof, assuming
from gcrules.algebra.scalars import bracket
from gcrules.algebra.screw_letters import Screw, screw, screw_points, screws_of
from gcrules.algebra.space import Assumption, Space
from gcrules.core.dataclass import dataclass
from gcrules.core.english import listed
from gcrules.core.errors import InputError, LimitReached

__all__ = ["Reciprocal", "reciprocal", "screws_in"]

_RANK = 4


@dataclass(frozen=True, slots=True)
class Reciprocal:
    """A claim with what is given, in which screws are written as the `values`, of a screw and a line that are called by
    a name of `stems`; `nonzero` is what they are reciprocal to, by the assumptions `used`. `before` is the claim as it
    was, `given` what was given.
    """

    claimed: Claimed
    space: Space
    before: Claimed
    given: tuple[Assumption, ...]
    values: Mapping[str, Expr]
    stems: tuple[str, ...]
    nonzero: tuple[Expr, ...]
    used: tuple[Assumption, ...]

    def told(self, proof: Proof, number: int) -> Proof:
        """The proof of an equation, as one of the equation that was claimed; undecided where what it assumes cannot be
        said of the screws.
        """
        left, right = self.before.equations[number]
        are = "is" if len(self.values) == 1 else "are"
        what = listed(list(dict.fromkeys(a.text for a in self.used)))
        told = _EQUAL if self._tells(proof.reason) else proof.reason
        reason = f"{told}; {listed(list(self.values))} {are} written so that {what}"
        found = replace(proof, left=left, right=right, given=self.given, reason=reason)
        beside = self._tells(*map(str, proof.kinds), *(n for pair in proof.together for n in pair))
        if proof.counterexample is None:
            return self._assuming(found, beside) if proof.proved else found
        auxiliary = self._auxiliary
        points = {n: c for n, c in proof.counterexample.items() if n not in auxiliary}
        known = (pair for pair in self.values.items() if {*points_of(pair[1])} <= {*proof.counterexample})
        for name, value in known:
            points |= dict(zip(screw_points(name), _four(plucker(value, proof.counterexample)), strict=True))
        return replace(found, counterexample=points, kinds=() if beside else proof.kinds)

    def fault(self, raised: InputError) -> InputError:
        """A fault of the claim as it is written here, told of the assumptions that were made."""
        if not self._tells(raised.message):
            return raised
        return fault(self.used[0], "the other assumptions allow no position at which it says something")

    @property
    def _auxiliary(self) -> set[str]:
        return {n for stem in self.stems for n in _names_of(stem)}

    def _tells(self, *texts: str) -> bool:
        """Whether texts speak of the screws and lines that stand for the screws of the claim."""
        return any(stem in shown for stem in self.stems for shown in texts)

    def _assuming(self, proof: Proof, beside: bool) -> Proof:
        conditions = tuple(map(self._in_screws, proof.conditions))
        if beside or not self._auxiliary.isdisjoint(points_of(*conditions)):
            reason = _UNSAID.format(listed(list(self.values)))
            left, right = proof.left, proof.right
            return Proof(
                left, right, "undecided", "random-points", reason, rank=_RANK, ideal=proof.ideal, given=self.given
            )
        return assuming(proof, (*conditions, *self.nonzero), self.space)

    def _in_screws(self, e: Expr) -> Expr:
        """A condition with the screws back in place of their values."""

        def back(part: Expr) -> Expr | None:
            if not isinstance(part, Sum) or part.step != 2 or self._auxiliary.isdisjoint(points_of(part)):
                return None
            for name, value in self.values.items():
                for sign in (1, -1):
                    if vanishes(ex.sub(part, ex.signed(sign, value)), rank=_RANK):
                        return ex.signed(sign, screw(name))
            return None

        while (found := first_part(e, back, _RANK)) is not None:
            e = found
        return _without_numbers(e)


_EQUAL = "both sides are equal at all points that satisfy the assumptions"
_UNSAID = "both sides are equal where something does not vanish that cannot be said of {}"


def reciprocal(claimed: Claimed, at: Space) -> Reciprocal | None:
    """The claim, with screws written as reciprocal to what is given; None where nothing of the kind is.

    Raises InputError where two such assumptions are about one screw, and where one says nothing.
    """
    chosen: dict[str, Expr] = {}
    used: list[Assumption] = []
    for a in at.given if at.rank == _RANK else ():
        options = screws_in(a)
        free = next(((s, e) for s, e in options if s not in chosen and s not in _behind(e, chosen)), None)
        if free is not None:
            chosen[free[0]] = free[1]
            used.append(a)
        elif options:
            why = f"{options[0][0]} is assumed to be reciprocal to something else already"
            raise fault(a, why, "one such assumption is made of each screw")
    if not chosen:
        return None
    taken = {*points_of(*(e for pair in claimed.equations for e in pair)), *points_of(*_of_given(at.given))}
    values: dict[str, Expr] = {}
    stems: dict[str, str] = {}

    def put(e: Expr) -> Expr:
        return everywhere(e, lambda part: values.get(part.name) if isinstance(part, Screw) else None, _RANK)

    def is_taken(stem: str) -> bool:
        """Whether a letter has this name of which points are taken."""
        return not {*taken, *points_of(*values.values())}.isdisjoint(_names_of(stem))

    for name in sorted(chosen, key=lambda n: len(_behind(chosen[n], chosen))):
        e = put(chosen[name])
        stems[name] = primed(name, is_taken)
        line, x = letter(stems[name], 2), screw(stems[name])
        values[name] = ex.sub(ex.mul(bracket(e, line), x), ex.mul(bracket(e, x), line))
    to = tuple(put(e) for e in chosen.values())
    rest = replace(at, given=tuple(_put(a, put) for a in at.given if a not in used))
    _refuse_zero(to, tuple(chosen.values()), used, rest)
    written = replace(
        claimed,
        equations=tuple((put(left), put(right)) for left, right in claimed.equations),
        required=tuple(replace(r, expr=put(r.expr)) for r in claimed.required),
        nonzero=(*map(put, claimed.nonzero), *to),
        args=tuple(map(put, claimed.args)),
    )
    return Reciprocal(
        written, rest, claimed, at.given, values, tuple(stems.values()), tuple(chosen.values()), tuple(used)
    )


def _refuse_zero(to: Sequence[Expr], shown: Sequence[Expr], used: Sequence[Assumption], rest: Space) -> None:
    """Raises InputError for an assumption that every screw satisfies, as what it is reciprocal to vanishes."""
    for e, one, a in zip(to, shown, used, strict=True):
        where = "everywhere"
        if not vanishes(one, rank=_RANK, ideal=rest.ideal):
            try:
                found = kinds(rest, points_of(e)) if rest.given else ()
            except LimitReached:  # it stays undecided
                found = ()
            if not vanishes(e, rank=_RANK, ideal=rest.ideal) and not (
                found and all(kind.construction.vanishes(e) for kind in found)
            ):
                continue
            where = "wherever the other assumptions hold"
        why = f"it holds for every screw, since {text(one, names=rest.declared())} is zero {where}"
        raise fault(a, why, "assume that the screw is reciprocal to a line or to another screw")


def _names_of(stem: str) -> tuple[str, ...]:
    return (*screw_points(stem), *names_of(stem, 2))


def _put(a: Assumption, put: Any) -> Assumption:
    args, also, exists = (tuple(map(put, some)) for some in (a.args, a.also, a.exists))
    return replace(a, args=args, also=also, exists=exists)


def _of_given(given: Sequence[Assumption]) -> tuple[Expr, ...]:
    return tuple(e for a in given for e in (*a.args, *a.also, *a.exists))


def screws_in(a: Assumption) -> list[tuple[str, Expr]]:
    """The screws of which an assumption says that they are reciprocal to an extensor in which they are not."""
    e = _without_numbers(a.args[0])
    if a.kind != "zero" or not isinstance(e, Join | Bracket | Meet) or e.step not in (0, _RANK):
        return []
    found = []
    for i, part in enumerate(parts := e.args if isinstance(e, Meet) else wholes(e.args)):
        rest = (*parts[:i], *parts[i + 1 :])
        if isinstance(part, Screw) and part.name not in screws_of(points_of(*rest)):
            found.append((part.name, (ex.meet if isinstance(e, Meet) else ex.join)(*rest, rank=_RANK)))
    return found


def _without_numbers(e: Expr) -> Expr:
    """The expression without numbers that are factors of it, or of what it joins or meets."""
    match e:
        case Product(factors=factors):
            return ex.mul(*(_without_numbers(f) for f in factors if not isinstance(f, Number)))
        case Join(args=args) | Meet(args=args) | Bracket(args=args):
            return rebuilt(e, tuple(map(_without_numbers, args)), _RANK)
    return e


def _behind(e: Expr, chosen: Mapping[str, Expr]) -> set[str]:
    """The screws of an extensor, and those of what they are reciprocal to."""
    own = set(screws_of(points_of(e)))
    return own.union(*(_behind(chosen[s], chosen) for s in own if s in chosen))


def _four(value: Sequence[Any]) -> list[tuple[Any, ...]]:
    """Four points, the sum of whose two joins has these Plücker coordinates."""
    rows = [[Fraction(0)] * _RANK for _ in range(_RANK)]
    for (i, j), c in zip(combinations(range(_RANK), 2), value, strict=True):
        rows[i][j], rows[j][i] = Fraction(c), -Fraction(c)
    i, j = next((i, j) for i, j in combinations(range(_RANK), 2) if rows[i][j])
    k, m = (n for n in range(_RANK) if n not in (i, j))
    first, second = [c / rows[i][j] for c in rows[i]], rows[j]
    left = rows[k][m] - (first[k] * second[m] - first[m] * second[k])
    units = [[Fraction(n == here) for n in range(_RANK)] for here in (k, m)]
    third = [left * c for c in units[0]] if left else units[1]
    return [tuple(ex.Number(c).value for c in point) for point in (first, second, third, units[1])]
