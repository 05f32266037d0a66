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
from gcrules.algebra.assumptions.incidences import fault
from gcrules.algebra.evaluate import plucker
from gcrules.algebra.expr import Bracket, Expr, Join, Meet, Point, points_of
from gcrules.algebra.language.relations import Claimed
from gcrules.algebra.letters import wholes
from gcrules.algebra.linear_in_lines import fresh_line
from gcrules.algebra.parts import everywhere
from gcrules.algebra.prove import Proof, assuming
from gcrules.algebra.scalars import bracket
from gcrules.algebra.screw_letters import Screw, screw, screw_points, screws_of
from gcrules.algebra.space import Assumption, Space
from gcrules.core.dataclass import dataclass
from gcrules.core.english import listed

__all__ = ["Reciprocal", "reciprocal"]

_RANK = 4


@dataclass(frozen=True, slots=True)
class Reciprocal:
    """A claim with what is given, in which screws are written as the `values`, with the points of `lines`; `nonzero` is
    what they are reciprocal to, by the assumptions `used`. `before` is the claim as it was, `given` what was given.
    """

    claimed: Claimed
    space: Space
    before: Claimed
    given: tuple[Assumption, ...]
    values: Mapping[str, Expr]
    lines: tuple[str, ...]
    nonzero: tuple[Expr, ...]
    used: tuple[Assumption, ...]

    def told(self, proof: Proof, number: int) -> Proof:
        """The proof of an equation, as one of the equation that was claimed."""
        left, right = self.before.equations[number]
        are = "is" if len(self.values) == 1 else "are"
        what = listed(list(dict.fromkeys(a.text for a in self.used)))
        reason = f"{proof.reason}; {listed(list(self.values))} {are} written so that {what}"
        found = replace(proof, left=left, right=right, given=self.given, reason=reason)
        if proof.counterexample is None:
            return assuming(found, (*proof.conditions, *self.nonzero), self.space) if proof.proved else found
        points = {n: c for n, c in proof.counterexample.items() if n not in self.lines}
        told = (pair for pair in self.values.items() if {*points_of(pair[1])} <= {*proof.counterexample})
        for name, value in told:
            points |= dict(zip(screw_points(name), _four(plucker(value, proof.counterexample)), strict=True))
        return replace(found, counterexample=points)


def reciprocal(claimed: Claimed, at: Space) -> Reciprocal | None:
    """The claim, with screws written as reciprocal to what is given; None where nothing of the kind is.

    Raises InputError where two such assumptions are about one screw.
    """
    chosen: dict[str, Expr] = {}
    used: list[Assumption] = []
    for a in at.given:
        options = _options(a)
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
    lines: list[str] = []

    def put(e: Expr) -> Expr:
        return everywhere(e, lambda part: values.get(part.name) if isinstance(part, Screw) else None, _RANK)

    for name in sorted(chosen, key=lambda n: len(_behind(chosen[n], chosen))):
        e = put(chosen[name])
        two = fresh_line(name, {*taken, *lines})
        line, x = ex.join(*map(Point, two)), screw(name)
        lines += two
        values[name] = ex.sub(ex.mul(bracket(e, line), x), ex.mul(bracket(e, x), line))
    written = replace(
        claimed,
        equations=tuple((put(left), put(right)) for left, right in claimed.equations),
        required=tuple(replace(r, expr=put(r.expr)) for r in claimed.required),
        nonzero=tuple(map(put, claimed.nonzero)),
        args=tuple(map(put, claimed.args)),
    )
    rest = tuple(_put(a, put) for a in at.given if a not in used)
    return Reciprocal(
        written, replace(at, given=rest), claimed, at.given, values, tuple(lines), tuple(chosen.values()), tuple(used)
    )


def _put(a: Assumption, put: Any) -> Assumption:
    args, also, exists = (tuple(map(put, some)) for some in (a.args, a.also, a.exists))
    return replace(a, args=args, also=also, exists=exists)


def _of_given(given: Sequence[Assumption]) -> tuple[Expr, ...]:
    return tuple(e for a in given for e in (*a.args, *a.also, *a.exists))


def _options(a: Assumption) -> list[tuple[str, Expr]]:
    """The screws of which an assumption says that they are reciprocal to an extensor in which they are not."""
    e = a.args[0]
    if a.kind != "zero" or not isinstance(e, Join | Bracket | Meet) or e.step not in (0, _RANK):
        return []
    found = []
    for i, part in enumerate(parts := e.args if isinstance(e, Meet) else wholes(e.args)):
        rest = (*parts[:i], *parts[i + 1 :])
        if isinstance(part, Screw) and part.name not in screws_of(points_of(*rest)):
            found.append((part.name, (ex.meet if isinstance(e, Meet) else ex.join)(*rest, rank=_RANK)))
    return found


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
