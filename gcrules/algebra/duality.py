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
from gcrules.algebra.letter_forms import FORMS
from gcrules.algebra.letters import conics_of, declarations, letter, letter_of, letters_of, named_letter, wholes
from gcrules.algebra.names import point_key
from gcrules.algebra.polars import Polar, check_degrees, polars_in
from gcrules.algebra.screw_letters import Screw, screw_of, screws_of
from gcrules.algebra.space import Assumption, Written
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
        case Polar(of=of, letter=of_conic):
            return Polar(dual(of, rank), of_conic, rank)
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


def dual_of(claims: Sequence[Written], given: Sequence[Assumption], rank: int) -> Dual:
    """The dual of what is claimed under assumptions.

    Raises InputError for what has no dual in the language.
    """
    assumed = [w for a in given for w in a.written or (Written(a.kind, a.args),)]
    exprs = tuple(e for w in (*claims, *assumed) for e in w.args)
    points = ex.points_of(*exprs)
    if conics_of(points):
        form = FORMS[rank]
        raise InputError(f"the dual of a {form.word} letter has no word here", hint=f"claim it of {form.instead}")
    conics = dict.fromkeys((*(w.letter for w in (*claims, *assumed)), *(p.letter for p in polars_in(exprs))))
    names = {n: rank - 1 for n in points if letter_of(n) is None and screw_of(n) is None}
    names |= {n: rank - step for n, step in letters_of(points).items()} | dict.fromkeys(screws := screws_of(points), 2)
    letters = {n: k for n, k in sorted(names.items(), key=_by_name) if k > 1}
    return Dual(
        declarations(letters, rank, screws, tuple(filter(None, conics))),
        tuple(dict.fromkeys(one for w in assumed for one in _said(w, rank, assumed=True))),
        tuple(dict.fromkeys(one for w in claims for one in _said(w, rank))),
    )


def _by_name(named: tuple[str, int]) -> tuple[str, int, int]:
    return point_key(named[0])


_WORDS = {("collinear", 3): "concurrent", ("coplanar", 4): "concurrent"}
_HYPERPLANES = {3: "collinear", 4: "coplanar"}


def _said(w: Written, rank: int, *, assumed: bool = False) -> list[str]:
    """The dual of what is written: in one word where there is one, else in equations."""
    for terms in [w.args] if w.kind == "equal" else zip(w.args):
        check_degrees(*terms)
    args = [dual(e, rank) for e in w.args]
    if w.letter:
        return [_of_letter(args[0], w.letter, rank, assumed)]
    if assumed and (on := _on_own_polar(w.kind, args, rank)) is not None:
        return [_of_letter(on.of, on.letter, rank, assumed)]
    if w.kind == "equal":
        return [" == ".join(map(text, args))]
    word = _WORDS.get((w.kind, rank), "incident" if w.kind == "incident" and _readable(args, rank) else "")
    if w.kind == "concurrent" and len(args) >= rank and all(e.step == 1 for e in args):
        word = _HYPERPLANES.get(rank, "")
    if word:
        return [f"{word}({', '.join(map(text, args))})"]
    return [f"{text(dual(e, rank))} == 0" for e in equations(Assumption(w.kind, w.args, ""), rank)]


def _readable(pair: Sequence[Expr], rank: int) -> bool:
    """Whether the language can say that one lies on the other: a point, a join of points, what is on a hyperplane."""
    steps = [e.step for e in pair]
    if min(steps) == 1 or max(steps) == rank - 1:
        return True
    joins = [e for e in pair if e.step == min(steps) and isinstance(e, ex.Join)]
    return bool(joins) and all(a.step == 1 for e in joins for a in e.args)


def _on_own_polar(kind: str, args: Sequence[Expr], rank: int) -> Polar | None:
    """The polar of what is said to lie on its own polar, or of a line of space to meet it: it touches, or is on it."""
    if len(args) != 2:
        return None
    flat, polar = sorted(args, key=lambda e: isinstance(e, Polar))
    word = "incident" if flat.step in (1, rank - 1) else "concurrent"
    return polar if kind == word and isinstance(polar, Polar) and polar.of == flat else None


def _of_letter(flat: Expr, letter: str, rank: int, assumed: bool) -> str:
    """What is on a conic or a quadric, or touches it, in the dual: that a line or a plane touches is assumed in other
    words where it is neither a letter nor a join of points.
    """
    if flat.step == 1:
        return f"incident({text(flat)}, {letter})"
    joined = isinstance(flat, ex.Join) and all(isinstance(a, ex.Point) for a in flat.args)
    if not assumed or joined or isinstance(flat, ex.Point):
        return f"touches({text(flat)}, {letter})"
    other = text(Polar(flat, letter, rank))
    return f"incident({other}, {text(flat)})" if flat.step == rank - 1 else f"concurrent({text(flat)}, {other})"
