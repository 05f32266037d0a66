r"""Claims about screws that are assumed to be reciprocal to a line or to a screw, as identities.

Let E be of step 2 and not zero, and f linear in the screw S. Where S ∨ E = 0, what equals (E ∨ Y) f(S) for all lines Y,
(E ∨ S) f(Y), vanishes; and E ∨ Y does not vanish for all of them, so that f(S) does. Where f is of a higher degree, Y
stands instead of S in one place after the other, and (E ∨ Y) S − (E ∨ S) Y, at which f vanishes, in those before.

>>> from gcrules.algebra.language.relations import parse_claim
>>> from gcrules.algebra.language.statements import parse_assumption
>>> from gcrules.algebra.language.syntax import Context
>>> at = parse_assumption("screw S, S \\/ ab == 0, collinear(a, b, c)", Context())
>>> found = with_screws("claim", *parse_claim("S \\/ ac == 0", at).equations[0], at.given)
>>> print(*found.nonzero, "--", found.cases[0].left, "==", found.cases[0].right)
ab -- [abS][yzac] == [abyz]([Sac] - 0)
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from gcrules.algebra.bracket import tableau_order
from gcrules.algebra.expand import MAX_TERMS
from gcrules.algebra.expr import ZERO, Bracket, Expr, Join, Number, Point, Power, Product, Sum, join, mul, points_of
from gcrules.algebra.names import primed
from gcrules.algebra.parts import everywhere
from gcrules.algebra.proofs.proving import theorem
from gcrules.algebra.proofs.theorem import Theorem
from gcrules.algebra.reciprocal import screws_in
from gcrules.algebra.screw_letters import Screw, screw, screws_of
from gcrules.algebra.space import Assumption
from gcrules.core.budget import checkpoint
from gcrules.core.errors import EngineFault, InputError

__all__ = ["with_screws"]

_RANK = 4


def with_screws(
    name: str,
    left: Expr,
    right: Expr,
    given: Sequence[Assumption],
    *,
    ideal: Iterable[str] = (),
    limit: int = MAX_TERMS,
) -> Theorem:
    """The proof that two expressions in space are equal under assumptions, some of which are about screws.

    Raises InputError where it cannot be written down, LimitReached where it is too long.
    """
    at_infinity = tuple(ideal)
    of_screw = next((a for a in given if screws_of(points_of(*a.args))), None)
    if of_screw is None:
        return theorem(name, left, right, ideal=at_infinity, rank=_RANK, given=given, limit=limit)
    left, right = (Bracket(_parts(side)) if side.step == _RANK else side for side in (left, right))
    for a in given:
        checkpoint()
        rest = [other for other in given if other is not a]
        for letter, e in screws_in(a):
            S = screw(letter)
            for degree in _degrees(left, right, S):
                try:
                    return _Exchange(left, right, S, e, rest).theorem(name, degree, rest, at_infinity, limit)
                except (EngineFault, InputError):
                    continue  # it is not of this degree, or does not follow from the rest
        if screws_of(points_of(*a.args)):
            try:
                return with_screws(name, left, right, rest, ideal=at_infinity, limit=limit)
            except (EngineFault, InputError):
                continue  # it is needed
    raise InputError(f"{of_screw} is about a screw, and no identity is known by which the claim follows from that")


def _degrees(left: Expr, right: Expr, S: Expr) -> Iterator[int]:
    """The degrees that a claim may have in a screw: it may be linear where this occurs in several terms."""
    most = max(_occurrences(t, S) for t in (*_terms(left), *_terms(right)))
    if most:
        yield 1
    if most > 1:
        yield most


class _Exchange:
    """A claim about a screw S that is reciprocal to E, with a line Y through two points that it does not name."""

    def __init__(self, left: Expr, right: Expr, S: Expr, e: Expr, rest: Iterable[Assumption]) -> None:
        used = {*points_of(left, right, e, *(x for a in rest for x in a.args))}
        self.left, self.right, self.S, self.e = left, right, S, _parts(e)
        self.ends = [primed(n, lambda new: new in used) for n in ("y", "z")]
        self.line = join(*map(Point, self.ends), rank=_RANK)
        self.zero = Bracket((*self.e, S))
        self.of_line = Bracket((*self.e, *map(Point, self.ends)))

    def theorem(
        self, name: str, degree: int, rest: Sequence[Assumption], ideal: tuple[str, ...], limit: int
    ) -> Theorem:
        """The proof of the claim, where it is of some degree in S. Raises EngineFault where it is not."""
        vanishing = [*self._terms(self.left, degree, 1), *self._terms(self.right, degree, -1)]
        left = vanishing[0] if len(vanishing) == 1 else Sum(tuple(vanishing))
        right = Product((*[self.of_line] * degree, _difference(self.left, self.right)))
        lemma = with_screws(f"{name}: {self.zero}", left, right, rest, ideal=ideal, limit=limit)
        if not {*self.ends}.isdisjoint(points_of(*lemma.given, *lemma.nonzero)):
            raise InputError(f"that {self.left} equals {self.right} asks for something of all lines")
        given, nonzero = (self.zero, *lemma.given), tuple(dict.fromkeys((Join(self.e), *lemma.nonzero)))
        known = {*lemma.order, *(p.name for p in lemma.placed), *points_of(self.left, self.right, self.zero)}
        named = points_of(self.left, self.right, *given, *nonzero)
        points = tableau_order([n for n in named if n in known], (), ideal)
        count = sum(n in ideal for n in points)
        return Theorem(name, _RANK, self.left, self.right, points, count, (), given, nonzero, cases=(lemma,))

    def _terms(self, side: Expr, degree: int, sign: int) -> Iterator[Expr]:
        """What [E Y]ⁿ times a side is at S, but for what it is at [E Y] S − [E S] Y: multiples of [E S]."""
        signed = [] if sign == 1 else [Number(sign)]
        if degree == 1:
            if side != ZERO:
                yield Product((*signed, self.zero, self._put(side, ())))
            return
        value = Sum((Product((self.of_line, self.S)), Product((Number(-1), self.zero, self.line))))
        for t in _terms(side):
            for i in range(_occurrences(t, self.S)):
                found = self._put(t, (*[value] * i, self.line, *[self.S] * degree))
                yield Product((*signed, self.zero, *[self.of_line] * (degree - 1 - i), found))

    def _put(self, e: Expr, values: Sequence[Expr]) -> Expr:
        """The screw replaced by these, one after the other, or by the line everywhere."""
        left = iter(values)
        return everywhere(e, lambda part: (next(left) if values else self.line) if part == self.S else None, _RANK)


def _terms(e: Expr) -> tuple[Expr, ...]:
    """Of a sum, with powers as products."""
    plain = everywhere(e, lambda x: mul(*[x.base] * x.exponent) if isinstance(x, Power) else None, _RANK)
    return plain.terms if isinstance(plain, Sum) and not isinstance(plain, Screw) else (plain,)


def _occurrences(e: Expr, S: Expr) -> int:
    return 1 if e == S else sum(_occurrences(c, S) for c in e.children)


def _parts(e: Expr) -> tuple[Expr, ...]:
    return e.args if isinstance(e, Join) else (e,)


def _difference(left: Expr, right: Expr) -> Expr:
    """As the checker writes it."""
    return Sum((left, Product((Number(-1), right))))
