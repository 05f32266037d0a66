r"""A plane of two lengths, the third one held: its regions, each with a witness and its number of assembly modes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import cached_property

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.poses.length_regions.asked import Range
from gcrules.poses.length_regions.integer_polynomials import root_of
from gcrules.poses.length_regions.slabs import Cell, Plane, plane
from gcrules.poses.length_regions.three_legs import ThreeLegs

__all__ = ["Part", "Section"]

_SHARES = (Fraction(1, 2), Fraction(1, 3), Fraction(3, 5), Fraction(2, 7), Fraction(5, 7))
"""Where in a cell a witness is sought."""


@dataclass(frozen=True)
class Part:
    """Cells that are connected, the squares of the lengths of all legs at a witness, and the number of modes there."""

    cells: tuple[Cell, ...]
    squares: tuple[Fraction, Fraction, Fraction]
    modes: int


@dataclass(frozen=True, eq=False)
class Section:
    """The lengths of the legs `free`, and the square at which the leg `held` is held; the plane counts with squares of
    lengths times `scale`.
    """

    legs: ThreeLegs
    free: tuple[int, int]
    held: int
    square: Fraction
    plane: Plane
    scale: int

    @classmethod
    def of(
        cls, legs: ThreeLegs, free: tuple[int, int], held: int, square: Fraction, ranges: Sequence[Range]
    ) -> Section:
        """Raises InputError where its regions cannot be had."""
        most = max(high for _, high in ranges) ** 2
        curve, scale = legs.curve(free, square, most)
        first, second = ((low**2 * scale, high**2 * scale) for low, high in ranges)
        found = plane(curve, (first, second))
        if found is None:
            raise InputError(
                f"{legs.title}: an end of the range of {legs.names[free[1]]} is singular for all lengths of"
                f" {legs.names[free[0]]}",
                hint="use another range",
            )
        return cls(legs, free, held, square, found, scale)

    def holds(self, x: Fraction, y: Fraction) -> bool:
        """Whether a place lies in the box."""
        (a, b), (c, d) = self.plane.box
        return a < x < b and c < y < d

    @cached_property
    def parts(self) -> tuple[Part, ...]:
        """The regions; of those that may be one, each by itself."""
        return tuple(self._part(cells) for cells in self.plane.parts(unsure=False))

    @cached_property
    def neighbours(self) -> dict[int, set[int]]:
        """The numbers of the regions on the other side of the curve."""
        number = {cell: n for n, part in enumerate(self.parts) for cell in part.cells}
        found: dict[int, set[int]] = {n: set() for n in range(len(self.parts))}
        for (k, n), own in number.items():
            above = number.get((k, n + 1))
            if above is not None:
                found[own].add(above)
                found[above].add(own)
        return found

    def _part(self, cells: Sequence[Cell]) -> Part:
        for cell in sorted(cells, key=self._size, reverse=True):
            for squares in self._witnesses(cell):
                checkpoint()
                modes = self.legs.modes(squares)
                if modes is not None:
                    return Part(tuple(cells), squares, modes)
        raise InputError(f"{self.legs.title}: no witness of a region was found", hint="hold another length")

    def _size(self, cell: Cell) -> float:
        """Of the cell in the middle of its strip, in lengths."""
        x = self.middle(cell[0])
        low, high = self._sides(cell, x)
        ends = [root_of(c, self.scale) for c in (*self.plane.strip(cell[0]), low, high)]
        return (ends[1] - ends[0]) * (ends[3] - ends[2])

    def middle(self, strip: int) -> Fraction:
        return _between(*self.plane.strip(strip), self.scale, _SHARES[0]) ** 2 * self.scale

    def _sides(self, cell: Cell, x: Fraction) -> Range:
        """The heights between which the cell surely is at x."""
        found = self._branches(x)
        return found[cell[1] - 1][1], found[cell[1]][0]

    def _branches(self, x: Fraction) -> list[Range]:
        known = self._known
        if x not in known:
            known[x] = self.plane.branches(x)
        return known[x]

    @cached_property
    def _known(self) -> dict[Fraction, list[Range]]:
        return {}

    def witness(self, cell: Cell) -> tuple[Fraction, Fraction]:
        """Two free lengths in the cell, with few digits."""
        x = self.middle(cell[0])
        return _between(*self.plane.strip(cell[0]), self.scale, _SHARES[0]), _between(
            *self._sides(cell, x), self.scale, _SHARES[0]
        )

    def _witnesses(self, cell: Cell) -> Iterator[tuple[Fraction, Fraction, Fraction]]:
        for share in _SHARES:
            one = _between(*self.plane.strip(cell[0]), self.scale, share)
            other = _between(*self._sides(cell, one**2 * self.scale), self.scale, share)
            squares = [self.square] * 3
            squares[self.free[0]], squares[self.free[1]] = one**2, other**2
            yield squares[0], squares[1], squares[2]


def _between(low: Fraction, high: Fraction, scale: int, share: Fraction) -> Fraction:
    """A length with few decimals whose square, times `scale`, lies between; about so far from the lower to the upper
    length.
    """
    a, b = (Fraction(root_of(c, scale)) for c in (low, high))
    place = a + (b - a) * share
    for digits in range(1, 400):
        found = Fraction(round(place * 10**digits), 10**digits)
        if low < found**2 * scale < high and abs(found - place) * 8 < b - a:
            return found
    raise ValueError("an interval too narrow for floats")
