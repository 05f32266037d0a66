r"""Duality: points and hyperplanes change places, and with them joins and meets.

A linear map from points to hyperplanes that takes a basis of unit volume to hyperplanes whose meet is 1 takes joins to
meets, meets to joins and brackets to meets, without signs. So a claim holds of all points exactly where its dual holds
of all hyperplanes; a letter of step k, in rank d, becomes one of step d - k of the same name, and a screw
of space, whose Plücker coordinates change places, a screw.

>>> from gcrules.algebra.language.syntax import parse
>>> print(dual(parse("ab /\\ cd", rank=3), 3))
(a /\ b) \/ (c /\ d)
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gcrules.algebra import expr as ex
from gcrules.algebra import scalars
from gcrules.algebra.assumptions.incidences import equations
from gcrules.algebra.expr import Expr
from gcrules.algebra.language.text import text
from gcrules.algebra.letters import declarations, letter, letter_of, letters_of, named_letter, wholes
from gcrules.algebra.names import point_key
from gcrules.algebra.screw_letters import Screw, screw_of, screws_of
from gcrules.algebra.space import Assumption
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError

__all__ = ["Dual", "dual", "dual_of"]


@dataclass(frozen=True, slots=True)
class Dual:
    """A dual as text of the language: the `letters` that it declares ("line a b c"), what is `given` and what is
    claimed, in equations or in one relation; all are claimed together.
    """

    letters: tuple[str, ...]
    given: tuple[str, ...]
    claims: tuple[str, ...]


def dual(e: Expr, rank: int) -> Expr:
    """The dual of an expression. Raises InputError for superbrackets of more than six lines."""
    match e:
        case ex.Number():
            return e
        case ex.Point(name=name):
            return _named(name, rank - 1)
        case ex.Join(args=args) | ex.Bracket(args=args):
            return ex.meet(*_duals(args, rank), rank=rank)
        case ex.Meet(args=args):
            parts = [dual(a, rank) for a in args]
            return ex.join(*parts, rank=rank) if e.step else scalars.bracket(*parts, rank=rank)
        case Screw():
            return e
        case ex.Sum(terms=terms):
            return ex.add(*(dual(t, rank) for t in terms), rank=rank)
        case ex.Product(factors=factors):
            return ex.mul(*(dual(f, rank) for f in factors))
        case ex.Power(base=base, exponent=n):
            return scalars.power(dual(base, rank), n, rank=rank)
        case ex.Dotted():
            return dual(scalars.written_out(e), rank)
        case ex.Superbracket(lines=lines):
            return _superbracket(lines, rank)
    raise TypeError(f"not an expression: {e!r}")


def _superbracket(lines: Sequence[Expr], rank: int) -> Expr:
    """In the plane the lines become points; in space the map of their coordinates has the determinant -1."""
    parts = [dual(line, rank) for line in lines]
    if rank == 3:
        return scalars.bracket(*parts, rank=rank)
    if rank == 4:
        return ex.neg(scalars.superbracket(*parts, rank=rank))
    raise InputError(
        f"a superbracket in rank {rank} has no dual here", hint="superbrackets have duals in ranks 3 and 4"
    )


def _duals(args: Sequence[Expr], rank: int) -> Iterator[Expr]:
    """The duals of what is joined, of letters as a whole."""
    for part in wholes(args):
        name = named_letter(part)
        if name is not None and not isinstance(part, Screw):
            yield _named(name, rank - part.step)
        else:
            assert not isinstance(part, ex.Point) or letter_of(part.name) is None, "a point of a letter stands alone"
            yield dual(part, rank)


def _named(name: str, step: int) -> Expr:
    return ex.Point(name) if step == 1 else letter(name, step)


def dual_of(
    sides: Sequence[tuple[Expr, Expr]], relation: Assumption | None, given: Sequence[Assumption], rank: int
) -> Dual:
    """The dual of claimed equations, or of the incidence by which they were claimed, under assumptions.

    Raises InputError for what has no dual in the language.
    """
    written = (*(e for pair in sides for e in pair), *(e for a in given for e in a.args))
    points = ex.points_of(*written)
    names = {n: rank - 1 for n in points if letter_of(n) is None and screw_of(n) is None}
    names |= {n: rank - step for n, step in letters_of(points).items()} | dict.fromkeys(screws := screws_of(points), 2)
    claims = _said(relation, rank) if relation else [_equation(*pair, rank) for pair in sides]
    return Dual(
        declarations({n: k for n, k in sorted(names.items(), key=_by_name) if k > 1}, rank, screws),
        tuple(dict.fromkeys(one for a in given for one in _said(a, rank))),
        tuple(claims),
    )


def _equation(left: Expr, right: Expr, rank: int) -> str:
    return f"{text(dual(left, rank))} == {text(dual(right, rank))}"


def _by_name(named: tuple[str, int]) -> tuple[str, int, int]:
    return point_key(named[0])


_WORDS = {("collinear", 3): "concurrent", ("coplanar", 4): "concurrent"}
_HYPERPLANES = {3: "collinear", 4: "coplanar"}


def _said(a: Assumption, rank: int) -> list[str]:
    """The dual of a relation: in one word where there is one, else in equations."""
    word = _WORDS.get((a.kind, rank), "incident" if a.kind == "incident" else "")
    if a.kind == "concurrent" and len(a.args) >= rank and all(e.step == rank - 1 for e in a.args):
        word = _HYPERPLANES.get(rank, "")
    if word:
        return [f"{word}({', '.join(text(dual(e, rank)) for e in a.args)})"]
    return [f"{text(dual(e, rank))} == 0" for e in equations(a, rank)]
