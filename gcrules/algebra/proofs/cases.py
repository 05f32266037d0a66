r"""A claim under assumptions of which one is a product in disguise: a factor vanishes, and the claim holds for each.

The assumptions of a case are those of the whole claim and a factor. That a product of all factors is what vanishes is
a theorem of its own, under those of the assumptions by which the other terms of what is given vanish.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from gcrules.algebra.assumptions.assumed import PositionKind, kinds
from gcrules.algebra.assumptions.construction import Construction
from gcrules.algebra.assumptions.nondegeneracy import fewest
from gcrules.algebra.assumptions.position_kinds import parts
from gcrules.algebra.bracket import Coefficient, tableau_order
from gcrules.algebra.expr import ZERO, Bracket, Expr, Number, Point, Product, mul, points_of, sub
from gcrules.algebra.proofs.coverage import quotient
from gcrules.algebra.proofs.multiples import cofactor
from gcrules.algebra.proofs.theorem import Theorem, asked, placed_theorem
from gcrules.algebra.prove import difference_of
from gcrules.algebra.space import Assumption, Space
from gcrules.core.budget import checkpoint
from gcrules.core.errors import InputError

__all__ = ["by_cases"]


def by_cases(
    name: str, left: Expr, right: Expr, found: Sequence[PositionKind], limit: int, *, apart: bool = True
) -> Theorem:
    """The proof that two expressions are equal at all kinds of positions that were `found`, where what any of these
    asks for does not vanish: at once if the points can be placed, else in cases, unless nothing may be taken apart.

    Raises EngineFault where they are not equal, InputError where the proof cannot be written down yet, LimitReached
    where it is too long.
    """
    c = found[0].construction
    if not apart:
        return placed_theorem(name, left, right, c, asked(c), limit)
    one = [replace(found[0], where=())] if len(found) == 1 else found
    return _Cases(left, right, one, limit).proof(name, c.equations, c.equations)


class _Cases:
    """A claim with the kinds of positions that it is about."""

    def __init__(self, left: Expr, right: Expr, found: Sequence[PositionKind], limit: int) -> None:
        self.left, self.right, self.found, self.limit = left, right, found, limit
        c = found[0].construction
        ideal = tuple(n for n in c.points if n in c.ideal)
        self.space = Space(c.rank, tableau_order(c.points, c.points, ideal), ideal)
        self.anywhere = Construction(c.rank, self.space.points, ideal, points=self.space.points)
        nonzero = tuple(e for kind in found for e in asked(kind.construction))
        self.nonzero = fewest(nonzero) if len(found) > 1 else nonzero

    def proof(self, name: str, given: tuple[Expr, ...], whole: tuple[Expr, ...]) -> Theorem:
        """The proof under assumptions; of them those of `whole` may be taken apart."""
        checkpoint()
        failure: InputError | None = None
        for kind in self.found:
            if all(any(self._ratio(e, other) for other in given) for e in kind.where):
                try:
                    return self._placed(name, self.left, self.right, kind.construction, given)
                except InputError as fault:
                    failure = failure or fault
        for e in whole:
            found = self._lemma(name, e, given)
            if found is None:
                continue
            lemma, factors = found
            left = tuple(other for other in whole if other != e)
            try:
                cases = [self.proof(f"{name}, where {f} == 0", (*given, f), (*left, f)) for f in factors]
            except InputError as fault:
                raise failure or fault from None
            points, ideal = self.space.points, len(self.space.ideal)
            return Theorem(
                *(name, self.space.rank, self.left, self.right, points, ideal, (), given, self.nonzero),
                cases=(lemma, *cases),
            )
        return self._apart(name, given, failure)

    def _placed(self, name: str, left: Expr, right: Expr, c: Construction, given: tuple[Expr, ...]) -> Theorem:
        c = replace(c, equations=given)
        try:
            return placed_theorem(name, left, right, c, self.nonzero, self.limit)
        except InputError:
            fewer = _of_claim(c, points_of(left, right))
            if fewer == c:
                raise
            return placed_theorem(name, left, right, fewer, self.nonzero, self.limit)

    def _lemma(self, name: str, e: Expr, given: Sequence[Expr]) -> tuple[Theorem, list[Expr]] | None:
        """That something given is a product of factors, and those of them that may vanish; None where it is none."""
        if e.step or _of_points(e) or not self._named(e):
            return None
        plain = tuple(g for g in given if g != e and self._named(g) and (g.step or _of_points(g)))
        base = self._construction(plain) or self.anywhere
        found = parts(e, base, self.space)
        if found is None or not found[0] or found[0] == (e,):
            return None
        factors = [next((n for n in self.nonzero if self._ratio(f, n)), f) for f in found[0]]
        product = mul(*factors)
        open_ones = [f for f in dict.fromkeys(factors) if f not in self.nonzero]
        for c in (self.anywhere, base):
            number = quotient(e, product, c)
            right = mul(Number(number), product)
            if number and self._asks(asked(c)) and c.vanishes(difference_of(e, right, c.rank)):
                said = self.nonzero if c is base else ()
                return placed_theorem(f"{name}: {e}", e, right, c, said, self.limit), open_ones
        # It is the product and a multiple of something else that is given.
        for g in plain if number else ():
            if g.step == 0 and (times := cofactor(sub(e, right), g, self.space.rank, self.space.ideal)) is not None:
                both = sub(Product((Number(1), e)), mul(times, g))
                return placed_theorem(f"{name}: {e}", both, right, self.anywhere, (), self.limit), open_ones
        return None

    def _apart(self, name: str, given: tuple[Expr, ...], failure: InputError | None) -> Theorem:
        """The proof at positions that are of no kind by themselves: the claim holds there too, or something vanishes
        that must not.
        """
        why = failure or InputError("that the claim holds at all positions does not follow from cases")
        c = self._construction(given)
        if c is None or not self._asks(asked(c)):
            raise why
        for left, right in ((self.left, self.right), *((e, ZERO) for e in self.nonzero)):
            if c.vanishes(difference_of(left, right, c.rank)):
                return self._placed(name, left, right, c, given)
        raise why

    def _construction(self, given: tuple[Expr, ...]) -> Construction | None:
        """Of all points at which some things vanish; None where there is none, or none for all of them."""
        assumptions = tuple(Assumption("zero", (e,), f"{e} == 0") for e in given)
        try:
            found = kinds(Space(self.space.rank, (), self.space.ideal, assumptions), self.space.points)
        except InputError:
            return None
        return replace(found[0].construction, equations=given) if len(found) == 1 else None

    def _named(self, e: Expr) -> bool:
        """Whether it is about points of the claim, and not about all points."""
        return {*points_of(e)} <= {*self.space.points}

    def _asks(self, nonzero: Iterable[Expr]) -> bool:
        """Whether the claim asks of these not to vanish, too."""
        return {*fewest((*self.nonzero, *nonzero))} <= {*self.nonzero}

    def _ratio(self, e: Expr, other: Expr) -> Coefficient:
        """What an expression is wherever the points are, by what another one is; 0 where that is no number."""
        if e == other:
            return 1
        alike = {*points_of(e)} == {*points_of(other)} and e.step == other.step
        return quotient(e, other, self.anywhere) if alike and self._named(e) else 0


def _of_claim(c: Construction, names: Iterable[str]) -> Construction:
    """The construction of some points alone; of the others nothing is used."""
    wanted = {*names}
    kept = []
    for step in reversed(c.steps):
        if step.name in wanted or step.name in c.meets:
            kept.append(step)
            wanted |= {*points_of(step.within)}
    loose = tuple(s.name for s in c.steps if s not in kept)
    return replace(c, free=(*c.free, *loose), steps=tuple(reversed(kept)))


def _of_points(e: Expr) -> bool:
    return isinstance(e, Bracket) and all(isinstance(a, Point) for a in e.args)
