r"""The lines of all limbs along a random line in the parameters of the family: their minors are polynomials there.

A common factor of polynomials in all parameters is found on such a line as that of polynomials in one variable.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache, cached_property

from gcrules.algebra.expr import Expr
from gcrules.core.errors import LimitReached
from gcrules.core.seeds import drawn
from gcrules.mechanisms.conditions.factor_causes import at_member
from gcrules.mechanisms.description.family import Family
from gcrules.mechanisms.lines.equivalent import Equivalent
from gcrules.mechanisms.lines.singular import PRIME, Poly, gcd, interpolated
from gcrules.mechanisms.lines.wrenches import PLANAR, WrenchLine
from gcrules.screws import RESIDUES

__all__ = ["LineOfLimbs"]


class LineOfLimbs:
    """The lines of all limbs along one line of members. Those of the `group` are chosen from, beside all others: the
    constraints; or all lines, a minor being the superbracket itself, where constraints of a limb are not spanned by
    lines or there are more actuators than freedoms (`whole`).
    """

    def __init__(self, family: Family, structure: Equivalent) -> None:
        self.family = family
        self.trivial = PLANAR if family.plane else ()
        self.full = 6 - len(self.trivial)
        derived = tuple(d for limb in structure.limbs for d in limb.derived)
        self.structure = replace(structure, derived=derived)
        member = family.across("subsets")
        self.member = cache(member)
        self.points = cache(lambda t: self.structure.points(family, member(t)))
        every = [line for limb in structure.limbs for line in limb.lines or ()]
        self.lines = list({self._place(line): line for line in reversed(every)}.values())[::-1]
        self.mixed_roles = any(line.role == "both" for line in every)
        self.whole = self.mixed_roles or structure.redundant > 0
        self.group = [line for line in self.lines if self.held(line)]
        self.size = self.full if self.whole else self.full - structure.mobility
        rng = drawn("coordinates")
        self.coordinates = [[rng.randrange(PRIME) for _ in range(6)] for _ in range(self.size)]
        self.row = cache(self._row)

    def _place(self, line: WrenchLine) -> object:
        """The same for lines that are one in the whole family."""
        return tuple(RESIDUES.simplest(line.row(self.points(t))) for t in (1, 2))

    def held(self, line: WrenchLine) -> bool:
        return line.role == "constraint" or self.whole

    def _row(self, line: WrenchLine, t: int) -> tuple[int, ...]:
        wrench = line.row(self.points(t))
        return tuple(int(RESIDUES.dot(wrench, c)) for c in self.coordinates)

    def minor(self, lines: Sequence[WrenchLine], t: int) -> int:
        return int(RESIDUES.determinant([self.row(line, t) for line in lines]))

    def mixed(self, t: int, seed: int) -> int:
        """A random combination of all minors: the minor of random combinations of the lines."""
        rng = drawn("mixed", seed)
        rows = [self.row(line, t) for line in self.group]
        numbers = [[rng.randrange(PRIME) for _ in rows] for _ in range(self.size)]
        return int(RESIDUES.determinant([RESIDUES.combination(some, rows) for some in numbers]))

    def value(self, e: Expr, t: int) -> int:
        return int(at_member(self.family, self.structure, self.member(t)).value(e)[0])

    @cached_property
    def common(self) -> Poly:
        """The common factor of all minors."""
        first, second = (self.polynomial(lambda t, seed=seed: self.mixed(t, seed)) for seed in (1, 2))  # type: ignore[misc]
        return gcd(first, second)

    def dependent(self, lines: Sequence[WrenchLine]) -> Poly:
        """What vanishes where these lines depend on each other: the common factor of their minors."""
        rng = drawn("dependent")
        found: Poly = []
        for _ in range(2):
            coordinates = [[rng.randrange(PRIME) for _ in range(6)] for _ in lines]

            def minor(t: int, coordinates: list[list[int]] = coordinates) -> int:
                rows = [line.row(self.points(t)) for line in lines]
                return int(RESIDUES.determinant([[RESIDUES.dot(row, c) for c in coordinates] for row in rows]))

            found = gcd(found, self.polynomial(minor))
        return found

    def polynomial(self, value: Callable[[int], int]) -> Poly:
        """The polynomial with these values. Raises LimitReached if its degree is above 63."""
        found = interpolated(value)
        if found is None:
            raise LimitReached(
                "the degree in the parameters of the family is above 63",
                hint="make points and directions from fewer others",
            )
        return found
