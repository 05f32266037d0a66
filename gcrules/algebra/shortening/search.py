r"""The shortest form of one homogeneous polynomial: what is known of it, and the searches that narrow it down.

From above: the forms that are given, then shorter ones as they are found. From below: the number of terms for which
it is proved that fewer do not suffice. The quick searches come first; the work ends where the two meet or at a limit.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import replace
from itertools import islice
from math import comb

import numpy as np

from gcrules.algebra.bracket import BracketPolynomial, Monomial, Row
from gcrules.algebra.certificate import Certificate
from gcrules.algebra.factoring.brackets import bracket_factors
from gcrules.algebra.factoring.modular import MODULUS, PRIMES, Ints
from gcrules.algebra.factoring.residues import random_positions, values
from gcrules.algebra.shortening.exact import combination, simplicity
from gcrules.algebra.shortening.exhaustive import Unlucky, certain, combinations_of
from gcrules.algebra.shortening.merging import merging_bound
from gcrules.algebra.shortening.monomials import Monomials, degree_vector
from gcrules.algebra.shortening.orders import shorter_order
from gcrules.algebra.shortening.result import Merging, TermBound
from gcrules.algebra.shortening.symmetry import Action, Orbits, Symmetry, orbits, symmetry
from gcrules.algebra.shortening.walk import shorter_supports
from gcrules.algebra.straightening.straighten import is_standard, straighten
from gcrules.core.budget import Count, report, seconds_left
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import EngineFault, LimitReached

__all__ = ["Divided", "SearchLimits", "ShortestSearch", "shortest_of"]

_QUICK = 1_000  # residues for each monomial that may be held: first searches
_THOROUGH = 2_000  # the last one
_WALK = 5_000
_POSITIONS = 12
_SEEDS = 3
_CANDIDATES = 40
_WALK_CELLS = 600_000
_WALK_STEPS = 400
_WALKS = 3


@dataclass(frozen=True)
class SearchLimits:
    """At most so many bracket monomials, and terms at a time."""

    monomials: int
    terms: int

    def work(self, per_monomial: int) -> Count:
        return Count(per_monomial * self.monomials, "the search handles", "residues")


@dataclass(frozen=True)
class ShortestSearch:
    """The best form, the number of terms that are needed at least, why, and what was searched."""

    best: BracketPolynomial
    lower: int
    bound: Certificate
    monomials: int = 0
    symmetries: int = 1
    notes: tuple[str, ...] = ()
    undecided: str = ""
    mergings: tuple[Merging, ...] = ()
    generators: tuple[tuple[int, tuple[tuple[str, str], ...]], ...] = ()

    @property
    def done(self) -> bool:
        return self.lower == len(self.best)

    def with_form(self, form: BracketPolynomial | None) -> ShortestSearch:
        return self if form is None else replace(self, best=min(self.best, form, key=simplicity))

    def with_bound(self, lower: int, method: str, detail: str) -> ShortestSearch:
        if lower <= self.lower:
            return self
        return replace(self, lower=lower, bound=Certificate(method, detail, {"lower": lower}))

    def term_bound(self, divided: Divided) -> TermBound:
        """The lower bound, with what proves it."""
        names = self.best.points
        degrees = degree_vector(next(iter(self.best.terms)), len(names))
        return TermBound(
            tuple((name, n) for name, n in zip(names, degrees, strict=True) if n),
            self.lower,
            self.bound.method,
            tuple(tuple(names[i] for i in row) for row in dict.fromkeys(divided.rows)),
            self.monomials,
            self.mergings,
            self.generators,
        )


@dataclass(frozen=True)
class Divided:
    """A homogeneous polynomial, not 0: brackets times a quotient in normal form, which no bracket divides.

    `complete` is False where a limit was reached: then some bracket may divide the quotient, and `note` says why.
    """

    rows: tuple[Row, ...]
    quotient: BracketPolynomial
    complete: bool = True
    note: str = ""

    @classmethod
    def of(cls, rows: tuple[Row, ...], normal: BracketPolynomial, limit: int) -> Divided:
        """The brackets times a polynomial in normal form."""
        try:
            more, quotient = bracket_factors(normal, limit=limit)
        except LimitReached as reached:
            return cls(rows, normal, False, f"division by brackets: {reached.message}")
        return cls(tuple(sorted((*rows, *more))), quotient)

    def times(self, form: BracketPolynomial) -> BracketPolynomial:
        """A form of the quotient as one of the whole; it takes no time that a search could save."""
        return form.with_terms({tuple(sorted((*m, *self.rows))): c for m, c in form.terms.items()})


def shortest_of(divided: Divided, forms: Iterable[BracketPolynomial], limits: SearchLimits) -> ShortestSearch:
    """The shortest form of a homogeneous polynomial that equals the given forms, as far as the time goes.

    Where there are more bracket monomials of the quotient's multidegree than may be held, it is `undecided` whether the
    form is the shortest. Where only those of the whole are too many, the quotient's shortest form is the best that is
    found.
    """
    quotient = divided.quotient
    simple = [divided.times(quotient), *forms]
    found = ShortestSearch(min(simple, key=simplicity), 1, Certificate("normal-form", "the normal form is not zero"))
    if divided.note:
        found = replace(found, notes=(divided.note,))
    if not quotient.ideal and divided.complete and set(quotient.terms) != {()}:
        detail = "all brackets that divide were taken out, and what is left is not a constant"
        found = found.with_bound(min(2, len(found.best)), "bracket-factors", detail)
    if found.done:
        return found
    if not divided.rows:
        try:
            return _searched(found, quotient, limits)
        except LimitReached as reached:
            return _without_monomials(found, quotient, reached)
    inner = shortest_of(replace(divided, rows=()), (), limits)
    found = replace(found.with_form(divided.times(inner.best)), notes=inner.notes, undecided=inner.undecided)
    if found.done:
        return found
    try:
        whole = straighten(divided.times(quotient), limit=limits.terms)
        assert isinstance(whole, BracketPolynomial)
        return _searched(found, whole, limits)
    except LimitReached as reached:
        return replace(found, notes=(*found.notes, f"search with the brackets that divide: {reached.message}"))


def _searched(found: ShortestSearch, normal: BracketPolynomial, limits: SearchLimits) -> ShortestSearch:
    """The searches among all bracket monomials, as far as the time goes."""
    try:
        return _Stages(found, normal, limits).run()
    except LimitReached as reached:
        if seconds_left() > 0:
            raise
        return replace(found, notes=(*found.notes, f"search among bracket monomials: {reached.message}"))


def _without_monomials(found: ShortestSearch, normal: BracketPolynomial, reached: LimitReached) -> ShortestSearch:
    """What can be sought without a list of the bracket monomials: normal forms in other orders of the points."""
    report("normal forms in other orders of the points")
    found = replace(found, undecided=reached.message)
    try:
        return found.with_form(shorter_order(normal, len(found.best)))
    except LimitReached as ended:
        return replace(found, notes=(*found.notes, f"normal forms in other orders: {ended.message}"))


class _Stages:
    """The searches among all bracket monomials of the multidegree."""

    def __init__(self, found: ShortestSearch, normal: BracketPolynomial, limits: SearchLimits) -> None:
        self.normal = normal
        self.limits = limits
        self.monomials = Monomials.of(normal, limits.monomials)
        self.action = Action(self.monomials)
        self.symmetry: Symmetry | None = None
        self.classes: Orbits | None = None
        self.likely: list[np.ndarray[tuple[int], np.dtype[np.bool_]]] = []
        self.found = replace(found, monomials=len(self.monomials))

    def run(self) -> ShortestSearch:
        for stage in (
            self.few_terms,
            self.symmetries,
            self.three_terms,
            self.mergings,
            self.orders,
            self.walks,
            self.more_terms,
        ):
            if self.found.done:
                break
            try:
                stage()
            except LimitReached as fault:
                self.found = replace(self.found, notes=(*self.found.notes, f"{stage.__doc__}: {fault.message}"))
                if seconds_left() <= 0:
                    break
        return self.found

    def few_terms(self) -> None:
        """search for one and two terms"""
        work = self.limits.work(_QUICK)
        while self.found.lower < min(3, len(self.found.best)) and self.exhaust(self.found.lower, work):
            pass

    def symmetries(self) -> None:
        """symmetries"""
        report("symmetries")
        self.symmetry = symmetry(self.normal, self.limits.terms)
        self.found = replace(self.found, symmetries=self.symmetry.order)

    def three_terms(self) -> None:
        """search for three terms"""
        if self.found.lower == 3:
            self.exhaust(3, self.limits.work(_QUICK))

    def mergings(self) -> None:
        """lower bound by merging points"""
        if self.symmetry is None:
            return
        report("merging points")
        self.classes = orbits(self.monomials, self.symmetry)
        work = self.limits.work(_QUICK)
        bound = merging_bound(self.normal, self.monomials, self.classes, work, len(self.found.best))
        if bound is not None:
            self.found = replace(self.found, mergings=bound.conditions, generators=self._generators(self.symmetry))
            names = np.unique(self.classes.label)
            tight = np.array(bound.tight)[np.searchsorted(names, self.classes.label)]
            # The signed average of the polynomial's images is the polynomial: what does not cancel spans it.
            self.likely = [tight & ~self.classes.cancels, tight, ~self.classes.cancels]
            if bound.lower > len(self.found.best):
                raise EngineFault(f"a lower bound of {bound.lower} for a form of {len(self.found.best)} terms")
            detail = f"at least {sum(c.weight * c.least for c in bound.conditions)} = " + " + ".join(
                str(c) for c in bound.conditions
            )
            self.found = self.found.with_bound(bound.lower, "merging", detail)

    def _generators(self, known: Symmetry) -> tuple[tuple[int, tuple[tuple[str, str], ...]], ...]:
        """Of symmetries that generate the others the sign, and each point with its image."""
        names = self.normal.points
        return tuple(
            (sign, tuple((names[i], names[k]) for i, k in enumerate(moved) if i != k))
            for moved, sign in zip(known.generators.tolist(), known.signs.tolist(), strict=True)
        )

    def orders(self) -> None:
        """normal forms in other orders"""
        report("normal forms in other orders of the points")
        form = shorter_order(self.normal, len(self.found.best))
        self.found = self.found.with_form(form)

    def walks(self) -> None:
        """walk from form to form"""
        place = self.monomials.place
        best = [place[m] for m in self.found.best.terms if m in place]
        standard = [i for i, m in enumerate(self.monomials.all) if is_standard(m)]
        every = np.arange(len(self.monomials))
        for kept in self.likely:
            if not self.found.done and kept.any() and not kept.all():
                self.walk(every[kept], [], len(standard))
        if not self.found.done:
            self.walk(every, [*best, *standard], len(standard))

    def walk(self, columns: Ints, first: list[int], dimension: int) -> None:
        """Walks among some of the monomials, from the basis that begins with the first ones."""
        if dimension * len(columns) > _WALK_CELLS:
            return
        value, target = self._values(dimension + 1, _SEEDS)
        work = self.limits.work(_WALK)
        for seed in range(_WALKS):
            report(f"walk {seed + 1} of {_WALKS} among {len(columns):,} monomials")
            start = first if seed < 2 else []
            for support in shorter_supports(value[columns], target, start, _WALK_STEPS, seed, work):
                if len(support) < len(self.found.best):
                    self.found = self.found.with_form(self.exact(columns[list(support)].tolist()))
                if self.found.done or work.left < 0:
                    return

    def more_terms(self) -> None:
        """search for more terms"""
        work = self.limits.work(_THOROUGH)
        while not self.found.done:
            if not self.feasible(self.found.lower, work):
                raise LimitReached(f"{self.found.lower} of {len(self.monomials):,} monomials are too many to try")
            if not self.exhaust(self.found.lower, work):
                break

    def feasible(self, terms: int, work: Count) -> bool:
        """Whether the work suffices, to judge by the number of choices of all monomials but one up to symmetry."""
        return comb(len(self.monomials), terms - 1) <= work.left * self.found.symmetries

    def exhaust(self, terms: int, work: Count) -> bool:
        """Look for exactly so many terms, given that fewer do not suffice; whether something was decided."""
        report(f"{terms} of {len(self.monomials):,} monomials")
        for candidates in self.candidates(terms, work, MODULUS):
            exact = [form for form in map(self.exact, candidates) if form is not None]
            if exact:
                self.found = self.found.with_form(min(exact, key=simplicity))
                return True
            if not candidates:
                break
        else:
            return False
        if not self.certain(terms, work):
            return False
        detail = f"none of the sets of {terms} of the {len(self.monomials):,} bracket monomials has it in its span"
        self.found = self.found.with_bound(terms + 1, "exhaustive-search", detail)
        return True

    def candidates(self, terms: int, work: Count, p: int) -> Iterator[list[tuple[int, ...]]]:
        """The sets of so many monomials that may have the polynomial in their span, by values at several positions."""
        elements = Symmetry.none(self.normal) if self.symmetry is None else self.symmetry.elements
        for seed in range(_SEEDS):
            value, target = self._values(_POSITIONS + terms, seed, p)
            sets = combinations_of(terms, value, target, self.action, elements, work, p)
            with suppress(Unlucky):
                yield list(islice(sets, _CANDIDATES))

    def certain(self, terms: int, work: Count) -> bool:
        """Whether it is certain that no set of so many monomials exists, none being found modulo the first prime: by
        searches modulo as many others as it takes.
        """
        for number in range(1, len(PRIMES)):
            if certain(self.monomials, terms, PRIMES[:number]):
                return True
            report(f"{terms} of {len(self.monomials):,} monomials, modulo another prime")
            for fewer in range(1, terms + 1):
                if all(self.candidates(fewer, work, PRIMES[number])):
                    return False
        return certain(self.monomials, terms, PRIMES)

    def exact(self, places: Iterable[int]) -> BracketPolynomial | None:
        chosen: list[Monomial] = [self.monomials.all[i] for i in places]
        return combination(self.normal, chosen, self.limits.terms)

    def _values(self, positions: int, seed: int, p: int = MODULUS) -> tuple[Ints, Ints]:
        normal = self.normal
        at = random_positions(positions, len(normal.points), normal.rank, p, ideal=normal.ideal, seed=seed)
        return self.monomials.values(at, p), values(normal, at, p)
