r"""A claim under assumptions that allow several kinds of positions, or that say more than where points lie: in cases.

That a product vanishes is a theorem of its own, under those of the assumptions by which the other terms of what is
given vanish; of each of its factors there is a case, which assumes that it vanishes. Something given makes a product
as it stands, or joined with one or two points: where b ∨ (bac ∧ bfe ∧ fad) vanishes [bfad] does, or bac ∧ bfe. Where
nothing given does, an expression vanishes or does not, and both are a case.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import chain, combinations

from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.assumed import PositionKind, kinds
from gcrules.algebra.assumptions.construction import Construction
from gcrules.algebra.assumptions.nondegeneracy import fewest
from gcrules.algebra.assumptions.position_kinds import parts
from gcrules.algebra.bracket import Coefficient, tableau_order
from gcrules.algebra.expr import ZERO, Bracket, Expr, Join, Meet, Number, Point, Product, mul, points_of, sub
from gcrules.algebra.proofs.coverage import quotient
from gcrules.algebra.proofs.factored import factored
from gcrules.algebra.proofs.multiples import multipliers
from gcrules.algebra.proofs.theorem import Theorem, asked, has_part, placed_theorem
from gcrules.algebra.prove import difference_of
from gcrules.algebra.space import Assumption, Space
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError, LimitReached

__all__ = ["by_cases"]

_MOST = 60  # cases that are tried
_DEEP = 10  # cases in cases
_JOINED = 2  # points with which something given is joined


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
    cases = _Cases(left, right, one, limit)
    return cases.proof(_Case(name, c.equations, c.equations, cases.nonzero))


@dataclass(frozen=True)
class _Case:
    """What is given and what does not vanish; of what is given, `left` was not taken apart."""

    name: str
    given: tuple[Expr, ...]
    left: tuple[Expr, ...]
    nonzero: tuple[Expr, ...]
    depth: int = 0

    def where(self, e: Expr, **more: tuple[Expr, ...]) -> _Case:
        """The case in which something vanishes, too."""
        case = replace(self, name=f"{self.name}, where {e} == 0", depth=self.depth + 1, **more)
        return replace(case, given=(*self.given, e), left=(*case.left, e))

    def apart(self, e: Expr) -> _Case:
        """The case in which something does not vanish."""
        name = f"{self.name}, where {e} != 0"
        return replace(self, name=name, depth=self.depth + 1, nonzero=(*self.nonzero, e))


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
        self.any = tuple(n for n in points_of(*c.equations) if n not in self.space.points)
        self.ratios: dict[tuple[Expr, Expr], Coefficient] = {}
        self.tried = 0

    def proof(self, case: _Case) -> Theorem:
        """The proof of a case. Raises InputError where none is found."""
        checkpoint()
        self.tried += 1
        if self.tried > _MOST or case.depth > _DEEP:
            raise InputError("that the claim holds at all positions does not follow from few cases")
        failure: InputError | None = None
        for attempt in (self._at_once, self._of_kind, self._contradiction):
            for found in attempt(case):
                if isinstance(found, Theorem):
                    return found
                failure = failure or found
        try:
            # Each of these leaves everything that is given, so that nothing is lost by the first.
            for in_cases in (self._taken_apart, self._asked, self._joined, self._told_apart):
                theorem = in_cases(case)
                if theorem is not None:
                    return theorem
        except InputError as fault:
            raise failure or fault from None
        raise failure or InputError("that the claim holds at all positions does not follow from cases")

    def _at_once(self, case: _Case) -> Iterator[Theorem]:
        """The proof where a part of the claim is given to vanish, or of something that does not vanish."""
        for e in (*((self.left,) if self.right == ZERO else ()), *case.nonzero):
            if has_part(e, case.given):
                yield replace(self._whole(case, ()), left=e, right=ZERO)

    def _of_kind(self, case: _Case) -> Iterator[Theorem | InputError]:
        """The proof at positions that are of one kind."""
        told = [k for k in self.found if all(any(self._ratio(e, other) for other in case.given) for e in k.where)]
        for kind in (*told, *(k for k in self.found if k not in told)):
            if self._asks(asked(kind.construction), case):
                try:
                    yield self._placed(case.name, self.left, self.right, kind.construction, case)
                except InputError as fault:
                    yield fault

    def _placed(self, name: str, left: Expr, right: Expr, c: Construction, case: _Case) -> Theorem:
        c = replace(c, equations=case.given)
        try:
            return placed_theorem(name, left, right, c, case.nonzero, self.limit)
        except InputError:
            fewer = _of_claim(c, points_of(left, right))
            if fewer == c:
                raise
            return placed_theorem(name, left, right, fewer, case.nonzero, self.limit)

    def _taken_apart(self, case: _Case) -> Theorem | None:
        """The proof by the factors of something that is given."""
        for e in case.left:
            found = self._lemma(e, case)
            if found is not None:
                left = tuple(other for other in case.left if other != e)
                return self._by_factors(case, *found, left=left)
        return None

    def _joined(self, case: _Case) -> Theorem | None:
        """The proof by the factors of something that is given joined with points: of as few as there can be."""
        rank, ways = self.space.rank, []
        for e in case.given:
            points = [Point(n) for n in points_of(e) if n in self.space.points]
            most = min(rank - e.step, _JOINED) if e.step else 0
            for some in chain.from_iterable(combinations(points, k) for k in range(1, most + 1)):
                # Not taken apart, since what is given has to be a part of it.
                whole = (Bracket if len(some) + e.step == rank else Join)((*some, e))
                factors = self._factors(whole, case)
                if len(factors) > 1 and not any(self._ratio(told, g) for _, told in factors for g in case.given):
                    ways.append((len([told for _, told in factors if told not in case.nonzero]), whole))
        for _, whole in sorted(ways, key=lambda way: way[0]):
            found = self._product(whole, case)
            if found is not None:
                return self._by_factors(case, *found)
        return None

    def _by_factors(self, case: _Case, lemma: Theorem, factors: Sequence[Expr], **more: tuple[Expr, ...]) -> Theorem:
        """The proof by the cases of some factors."""
        return self._whole(case, [lemma, *(self.proof(case.where(f, **more)) for f in factors)])

    def _asked(self, case: _Case) -> Theorem | None:
        """The proof by something that has to be said not to vanish, so that the claim holds."""
        for kind in self._kinds(case):
            if next(self._closed(kind.construction, case), None) is not None:
                missing = (e for e in asked(kind.construction) if not self._asks((e,), case))
                theorem = self._split(case, missing)
                if theorem is not None:
                    return theorem
        return None

    def _told_apart(self, case: _Case) -> Theorem | None:
        """The proof by what vanishes at some kinds only."""
        return self._split(case, (e for kind in self.found for e in kind.where))

    def _split(self, case: _Case, some: Iterable[Expr]) -> Theorem | None:
        """The proof where the first of some expressions of which it is not known vanishes, and where it does not."""
        for e in some:
            if self._named(e) and not any(self._ratio(e, other) for other in (*case.given, *case.nonzero)):
                return replace(self._whole(case, [self.proof(case.where(e)), self.proof(case.apart(e))]), split=e)
        return None

    def _whole(self, case: _Case, cases: Iterable[Theorem]) -> Theorem:
        s = self.space
        whole = Theorem(case.name, s.rank, self.left, self.right, s.points, len(s.ideal), (), case.given, case.nonzero)
        return replace(whole, cases=tuple(cases))

    def _lemma(self, e: Expr, case: _Case) -> tuple[Theorem, list[Expr]] | None:
        """That something given is a product of factors, and those of them that may vanish; None where it is none."""
        if _of_points(e):
            return None
        found = self._product(e, case)
        if found is not None or e.step or not self._named(e):
            return found
        plain = tuple(g for g in case.given if g != e and self._named(g) and _lies(g))
        base = self._construction(plain) or self.anywhere
        factors = parts(e, base, self.space)
        if factors is None or not factors[0] or factors[0] == (e,):
            return None
        known = [next((n for n in case.nonzero if self._ratio(f, n)), f) for f in factors[0]]
        product = mul(*known)
        open_ones = [f for f in dict.fromkeys(known) if f not in case.nonzero]
        for c in (self.anywhere, base):
            number = quotient(e, product, c)
            right = mul(Number(number), product)
            if number and self._asks(asked(c), case) and c.vanishes(difference_of(e, right, c.rank)):
                said = case.nonzero if c is base else ()
                return placed_theorem(f"{case.name}: {e}", e, right, c, said, self.limit), open_ones
        # It is the product and a multiple of something else that is given.
        for g in plain if number else ():
            if g.step == 0 and (times := multipliers(sub(e, right), [g], self.space.rank, self.space.ideal)):
                both = sub(Product((Number(1), e)), mul(*times, g))
                return placed_theorem(f"{case.name}: {e}", both, right, self.anywhere, (), self.limit), open_ones
        return None

    def _product(self, e: Expr, case: _Case) -> tuple[Theorem, list[Expr]] | None:
        """The same by what its parts have in common."""
        factors = self._factors(e, case)
        if len(factors) < 2:
            return None
        open_ones = [told for _, told in factors if told not in case.nonzero]
        c = Construction(self.space.rank, (*self.space.points, *self.any), self.space.ideal)
        product = mul(*(f for f, _ in factors))
        number = quotient(e, product, c)
        right = mul(Number(number), product)
        if not number or not all(map(self._named, open_ones)) or not c.vanishes(difference_of(e, right, c.rank)):
            return None
        try:
            return placed_theorem(f"{case.name}: {e}", e, right, c, (), self.limit), list(dict.fromkeys(open_ones))
        except LimitReached:
            return None

    def _factors(self, e: Expr, case: _Case) -> list[tuple[Expr, Expr]]:
        """The factors of an expression by what its parts have in common, each with what vanishes where it does, as it
        is said not to where it is.
        """
        found = []
        for f in factored(e, self.space.rank):
            told = self._for_all(f)
            same = next((n for n in case.nonzero if self._ratio(told, n)), told)
            found.append((f if same == f else self._of_all(same, f), same))
        return found

    def _for_all(self, f: Expr) -> Expr:
        """What vanishes where a bracket does for all points: the join of the others."""
        if not isinstance(f, Bracket) or self._named(f):
            return f
        return ex.join(*(a for a in f.args if str(a) not in self.any), rank=self.space.rank)

    def _of_all(self, told: Expr, f: Expr) -> Expr:
        """A bracket with points that stand for all, told by the join of the others."""
        if not isinstance(f, Bracket) or self._named(f):
            return told
        args = told.args if isinstance(told, Join) else (told,)
        return Bracket((*args, *(a for a in f.args if str(a) in self.any)))

    def _contradiction(self, case: _Case) -> Iterator[Theorem | InputError]:
        """The proof at positions that are of no kind by themselves: the claim holds there too, or something vanishes
        that must not.
        """
        for kind in self._kinds(case):
            c = replace(kind.construction, equations=case.given)
            if self._asks(asked(c), case):
                for left, right in self._closed(c, case):
                    try:
                        yield self._placed(case.name, left, right, c, case)
                    except InputError as fault:
                        yield fault

    def _closed(self, c: Construction, case: _Case) -> Iterator[tuple[Expr, Expr]]:
        """What holds wherever a construction leads and is enough for a case."""
        for left, right in ((self.left, self.right), *((e, ZERO) for e in case.nonzero)):
            if {*points_of(left, right)} <= {*c.points} and c.vanishes(difference_of(left, right, c.rank)):
                yield left, right

    def _kinds(self, case: _Case) -> Iterator[PositionKind]:
        """Of the positions at which that vanishes which says where points lie, and scalars, if there are others."""
        left = tuple(dict.fromkeys(e for e in case.left if self._named(e)))
        plain = tuple(e for e in left if _of_points(e))
        scalars = tuple(e for e in left if not e.step or _lies(e))
        yield from self._found(plain)
        yield from self._found(scalars) if scalars != plain else ()

    def _construction(self, given: tuple[Expr, ...]) -> Construction | None:
        """Of all points at which some things vanish; None where there is none, or none for all of them."""
        found = self._found(given)
        return replace(found[0].construction, equations=given) if len(found) == 1 else None

    def _found(self, given: tuple[Expr, ...]) -> tuple[PositionKind, ...]:
        assumptions = tuple(Assumption("zero", (e,), f"{e} == 0") for e in given)
        try:
            return kinds(Space(self.space.rank, (), self.space.ideal, assumptions), self.space.points)
        except InputError:
            return ()

    def _named(self, e: Expr) -> bool:
        """Whether it is about points of the claim, and not about all points."""
        return {*points_of(e)} <= {*self.space.points}

    def _asks(self, nonzero: Iterable[Expr], case: _Case) -> bool:
        """Whether the case says of these that they do not vanish, too."""
        return {*fewest((*case.nonzero, *nonzero))} <= {*case.nonzero}

    def _ratio(self, e: Expr, other: Expr) -> Coefficient:
        """What an expression is wherever the points are, by what another one is; 0 where that is no number."""
        if e == other:
            return 1
        alike = {*points_of(e)} == {*points_of(other)} and e.step == other.step
        if alike and self._named(e) and (e, other) not in self.ratios:
            self.ratios[e, other] = quotient(e, other, self.anywhere)
        return self.ratios.get((e, other), 0)


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


def _lies(e: Expr) -> bool:
    """Whether it is simple to construct points at which it vanishes."""
    return _of_points(e) or (e.step > 0 and not isinstance(e, Meet))


def _of_points(e: Expr) -> bool:
    return isinstance(e, Point) or (isinstance(e, Bracket | Join) and all(isinstance(a, Point) for a in e.args))
