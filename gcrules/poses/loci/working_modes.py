r"""Which working modes the factors of a locus belong to, seen at zeros of them; and the polynomials computed a second
time.

A working mode is a choice of sign for each root, + being home's. All real zeros of a factor in one variable are
isolated exactly; in several variables those on random lines through home's surroundings are bisected. There the factor
of the condition is computed from the joints' places in long decimals, for every choice of signs: it vanishes in the
modes to which the zero belongs, unless a radicand is negative there and on both sides. That is seen at the zeros that
were met, and proves nothing of others.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise, product
from math import lcm, prod
from typing import Any

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import EngineFault, InputError
from gcrules.core.seeds import drawn
from gcrules.poses.loci.closed_form import ClosedFactor, ClosedForm
from gcrules.poses.loci.elimination import Eliminated, Numerator
from gcrules.poses.loci.form import PolynomialForm
from gcrules.poses.loci.limb_question import LimbQuestion
from gcrules.screws.pose_text import SHIFTS

__all__ = ["CHECKS", "Modes", "Sightings"]

CHECKS = 3  # poses at which polynomials are computed again
_DIGITS = 80
_SAME = 40  # digits that have to agree
_LINES = 10
_STEPS = 24  # of a line to each side
_ZEROS = 12  # that are looked at
_RUNS = 600  # of the closed form, for one factor
_NEAR = 10**-7  # of a zero, in parts of the line
_HALVINGS = 220  # of an interval, so that even a square root of what is left is less than _VANISHES
_VANISHES = 1e-12  # of the value that near


@dataclass(frozen=True)
class Sightings:
    """At how many real zeros of a factor modes were looked for (`zeros`), at how many of them the robot is assembled
    and singular in some mode, the modes, a sign for each root, and whether these are `every` real zero that it has.
    """

    zeros: int
    assembled: int
    modes: tuple[str, ...]
    every: bool


@dataclass(frozen=True, eq=False)
class Modes:
    """The working modes of a robot over the free variables; lengths are like `size`."""

    form: ClosedForm
    question: LimbQuestion
    eliminated: Eliminated
    size: float

    def signs(self, norm: Numerator) -> Iterator[tuple[int, ...]]:
        """All choices of signs of the norm's roots, home's first."""
        return product((1, -1), repeat=len(norm.roots))

    def value(self, factor: ClosedFactor, norm: Numerator, signs: Sequence[int], at: Sequence[Any]) -> Any:
        """The factor of the condition in a mode, complex where a radicand is negative."""
        from mpmath import mp, mpf

        by = dict(zip(norm.roots, signs, strict=True))
        free = dict(zip(self.question.free, at, strict=True))
        known = {n: mpf(c.numerator) / c.denominator for n, c in self.question.fixed.items()} | free
        inputs = [known[n] for n in self.question.variables]

        def root(node: int, x: Any) -> Any:
            return mp.sqrt(x) * by.get(self.eliminated.numbers.get(node, -1), 1)

        above, below = self.form.values(inputs, root, lambda x: 1 / x, [factor.value, factor.over])
        found = above / below
        return mpf(found.numerator) / found.denominator if isinstance(found, Fraction) else found

    def check(self, factor: ClosedFactor, norm: Numerator) -> None:
        """Two roads: the factor in all modes in long decimals. Raises EngineFault where the product of them, or with
        the roots one of them, is another number; InputError where it is 0 in some mode at each of these poses.
        """
        from mpmath import mp, mpf

        every = list(self.signs(norm))
        zero = set(every)
        rng = drawn("norm", factor.expression, str(norm.coefficient))
        for k in range(CHECKS):
            checkpoint()
            exact = [Fraction(rng.randint(-(1 << 30), 1 << 30), 1 << 30) * self._reach(n) for n in self.question.free]
            with mp.workdps(_DIGITS):
                at = [mpf(x.numerator) / x.denominator for x in exact]
                modes = every if self.eliminated.multiplied or not k else [every[0], *zero]
                values = {signs: self.value(factor, norm, signs, at) for signs in modes}
                if self.eliminated.multiplied:
                    agrees = _same(prod(values.values()), self._expected(norm, exact))
                else:
                    least = max(map(abs, values.values())) * mpf(10) ** -_SAME
                    zero &= {m for m, v in values.items() if abs(v) <= least}
                    roots = {signs: self._root_values(norm, signs, exact) for signs in modes}
                    agrees = all(_same(v, self._expected(norm, [*at, *roots[m]]), least) for m, v in values.items())
            if not agrees:
                raise EngineFault(f"{factor.expression} over the working modes is another number")
        if not self.eliminated.multiplied and zero:
            raise InputError(
                "in one of the working modes every pose is singular there",
                hint="leave another coordinate free; gcrules map, path and pose --nearest keep to home's working mode",
            )

    def _expected(self, norm: Numerator, at: Sequence[Any]) -> Any:
        """What the numerator says; exact for Fractions."""
        found = norm.form(at) * norm.coefficient.numerator / norm.coefficient.denominator
        for p, n in norm.below:
            found /= p(at[: len(p.variables)]) ** n
        return found

    def _root_values(self, norm: Numerator, signs: Sequence[int], exact: Sequence[Fraction]) -> list[Any]:
        """The roots by their radicands and signs, in long decimals."""
        from mpmath import mp, mpf

        by = dict(zip(norm.roots, signs, strict=True))
        known: dict[str, Any] = dict(zip(self.question.free, exact, strict=True))
        for k, root in enumerate(self.eliminated.roots):
            home = prod(1 if p([known[n] for n in p.variables]) > 0 else -1 for p in root.sign)
            values = [known[n] for n in root.radicand.variables]
            if not all(isinstance(v, Fraction) for v in values):
                values = [mpf(v.numerator) / v.denominator if isinstance(v, Fraction) else v for v in values]
            radicand = root.radicand(values)
            if isinstance(radicand, Fraction):
                radicand = mpf(radicand.numerator) / radicand.denominator
            known[root.name] = mp.sqrt(radicand) * by.get(k, 1) * home
        return [known[root.name] for root in self.eliminated.roots]

    def _reach(self, name: str) -> Fraction:
        """How far lines go: a whole number of lengths, so that points have short coordinates; 1 for half-tangents."""
        return max(Fraction(round(self.size * 16), 16), Fraction(1, 16)) * 2 if name in SHIFTS else Fraction(1)

    def sightings(self, factor: ClosedFactor, norm: Numerator, p: PolynomialForm) -> Sightings:
        """The modes of an irreducible factor of the norm, where zeros of it are met."""
        from mpmath import mp

        zeros = assembled = 0
        modes: dict[str, None] = {}
        most = max(2, min(_ZEROS, _RUNS >> len(norm.roots)))
        alone = len(p.variables) == 1
        with mp.workdps(_DIGITS + 4 * p.degree):
            for at, sides in self._all_zeros(p) if alone else self._zeros(p):
                if zeros == most:
                    return Sightings(zeros, assembled, tuple(sorted(modes)), every=False)
                there = [m for m in self.signs(norm) if self._vanishes(factor, norm, m, at, sides)]
                modes |= dict.fromkeys("".join("+" if s > 0 else "-" for s in m) for m in there)
                zeros, assembled = zeros + 1, assembled + bool(there)
        return Sightings(zeros, assembled, tuple(sorted(modes)), every=alone)

    def _vanishes(self, factor: ClosedFactor, norm: Numerator, signs: Sequence[int], at: Any, sides: Any) -> bool:
        """Whether the factor is 0 at a zero of the norm, and real there or at its border: where a radicand is 0, too,
        it is real on one side only, or by rounding on none.
        """
        from mpmath import mpc

        try:
            here, *beside = (self.value(factor, norm, signs, x) for x in (at, *sides))
        except ZeroDivisionError:
            return False
        real = [x for x in beside if not isinstance(x, mpc)]
        if not real and isinstance(here, mpc):
            return False
        return bool(abs(here) <= _VANISHES * max(map(abs, real or beside)))

    def _all_zeros(self, p: PolynomialForm) -> Iterator[tuple[list[Any], list[list[Any]]]]:
        """All real zeros of an irreducible polynomial in one variable, the nearest to home first, and points a little
        to both sides.
        """
        from mpmath import mpf

        step = self._reach(p.variables[0]) * _NEAR
        ends_of = (ends for ends, _ in p.poly.intervals())
        intervals = [(Fraction(int(a.p), int(a.q)), Fraction(int(b.p), int(b.q))) for a, b in ends_of]
        for low, high in sorted(intervals, key=lambda ends: abs(ends[0] + ends[1])):
            checkpoint()
            left, right = (mpf(c.numerator) / c.denominator for c in (low, high))
            zero = left if low == high else _bisected(lambda x: p([x]), left, right, p([low]))
            yield [zero], [[zero - step], [zero + step]]

    def _zeros(self, p: PolynomialForm) -> Iterator[tuple[list[Any], list[list[Any]]]]:
        """Points where the polynomial changes its sign on random lines, and points a little to both sides."""
        from mpmath import mpf

        rng = drawn("lines", str(p.terms[:3]))
        reach = [self._reach(n) for n in p.variables]
        for _ in range(_LINES):
            rows = zip(
                *((rng.randint(-32, 32), rng.choice((-1, 1)) * rng.randint(32, 128)) for _ in reach), strict=True
            )
            start, along = ([Fraction(c, 128) * r for c, r in zip(row, reach, strict=True)] for row in rows)
            differences = _differences(p, start, along)

            def value(t: Any, differences: Sequence[Any] = differences) -> Any:
                found = mpf(0)
                for k in range(len(differences) - 1, -1, -1):
                    found = found * (t - k) / (k + 1) + differences[k]
                return found

            def point(t: Any, start: Any = start, along: Any = along) -> list[Any]:
                return [
                    mpf(a.numerator) / a.denominator + t * v.numerator / v.denominator
                    for a, v in zip(start, along, strict=True)
                ]

            steps = [mpf(k) / _STEPS for k in range(-_STEPS, _STEPS + 1)]
            values = [value(t) for t in steps]
            for left, right, low, high in zip(steps, steps[1:], values, values[1:], strict=False):
                checkpoint()
                if low * high < 0:
                    t = _bisected(value, left, right, low)
                    yield point(t), [point(t - mpf(_NEAR)), point(t + mpf(_NEAR))]


def _same(found: Any, expected: Any, least: Any = 0) -> bool:
    """Whether two numbers agree, or both are less than what counts as 0."""
    from mpmath import mpf

    wanted = mpf(expected.numerator) / expected.denominator if isinstance(expected, Fraction) else expected
    return bool(abs(found - wanted) <= max(mpf(10) ** -_SAME * abs(wanted), least))


def _differences(p: PolynomialForm, start: Sequence[Fraction], along: Sequence[Fraction]) -> list[Any]:
    """Δᵏf(0), long decimals of whole numbers, of a positive multiple f(t) of p(start + t along): Newton's form
    f(t) = Σ Δᵏ (t over k).
    """
    from mpmath import mpf

    below = lcm(*(c.denominator for c in (*start, *along)))
    first, step = ([int(c * below) for c in row] for row in (start, along))
    row = [p.scaled([a + k * v for a, v in zip(first, step, strict=True)], below) for k in range(p.degree + 1)]
    found = []
    while row:
        checkpoint()
        found.append(mpf(row[0]))
        row = [b - a for a, b in pairwise(row)]
    return found


def _bisected(value: Any, left: Any, right: Any, low: Any) -> Any:
    for _ in range(_HALVINGS):
        middle = (left + right) / 2
        here = value(middle)
        if here == 0:
            return middle
        if (here < 0) == (low < 0):
            left = middle
        else:
            right = middle
    return (left + right) / 2
