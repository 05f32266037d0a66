r"""The superbracket on a slice of translations: an exact polynomial of degree ≤ 3, parted into irreducible factors.

Places are counted in nodes from the middle of the grid, w = (coordinate − middle)/step, so that cells are unit squares
or cubes with whole corners and the numbers stay small.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from math import comb
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.core.seeds import DRAWN, drawn
from gcrules.poses.loci.form import PolynomialForm
from gcrules.poses.loci.zero_set import zero_set, zeros_json
from gcrules.poses.maps.axes import TRANSLATION
from gcrules.poses.maps.grid import Grid
from gcrules.poses.numbers.cubic import FACTORED_BITS, bits, superbracket_at, translation_polynomial
from gcrules.screws.pose import Pose

__all__ = ["MEMBERS", "Polynomial", "SliceFactor", "factors", "middle", "slice_polynomial", "vanishes"]

Floats = NDArray[np.float64]
MEMBERS = 8
"""Random poses in which a superbracket is looked at that may be 0 throughout."""

Polynomial = Mapping[tuple[int, ...], Fraction]
"""Exponents for each axis: coefficient other than 0."""

Line = tuple[int | None, Fraction, Fraction]
"""What a variable is replaced by: the number k of a new one (or none), the constant, and the multiple of k."""


@dataclass(frozen=True)
class SliceFactor:
    """An irreducible factor (over the rationals) of the superbracket on the slice, in w; `form` is it in the axes'
    coordinates, up to a number.
    """

    polynomial: Polynomial
    multiplicity: int
    form: PolynomialForm

    def __post_init__(self) -> None:
        object.__setattr__(self, "polynomial", FrozenMap(self.polynomial))

    @property
    def text(self) -> str:
        """It in the axes' coordinates, exact."""
        return str(self.form)

    @property
    def degree(self) -> int:
        return max(map(sum, self.polynomial))

    @cached_property
    def tensor(self) -> Floats:
        """The coefficients in floats, shape (4, 4) or (4, 4, 4), scaled so that the largest is 1."""
        axes = len(next(iter(self.polynomial)))
        largest = max(map(abs, self.polynomial.values()))
        found = np.zeros((4,) * axes)
        for e, c in self.polynomial.items():
            found[e] = float(c / largest)
        return found

    def exact(self, place: tuple[Fraction | int, ...]) -> Fraction:
        """The value at a place in w."""
        total = Fraction(0)
        for exponents, c in self.polynomial.items():
            for w, e in zip(place, exponents, strict=True):
                c = c * Fraction(w) ** e
            total += c
        return total

    def to_json(self) -> dict[str, Any]:
        zeros = zeros_json(zero_set(self.form))
        return {"degree": self.degree, "multiplicity": self.multiplicity, "polynomial": self.text, **zeros}


def middle(shape: tuple[int, ...]) -> tuple[int, ...]:
    """The node of each axis from which w is counted."""
    return tuple((n - 1) // 2 for n in shape)


def slice_polynomial(g: Grid) -> Polynomial:
    """The superbracket in the axes' coordinates (in their unit); exact. All axes are translations."""
    r = g.rig
    size = max(abs(c) for p in r.points.values() for c in p)
    # A pose in which every leg has a length, whichever: each of the six has none in one translation at most.
    for n in range(7):
        checkpoint()
        start = [c + size * Fraction(n, d) for c, d in zip(g.at.translation, (7, 11, 13), strict=True)]
        try:
            points = r.exact(Pose((start[0], start[1], start[2]), g.at.quaternion))
            break
        except InputError:
            continue
    f = translation_polynomial(r.structure.legs, points, r.structure.platform, size)
    lines: list[Line] = []
    for name, here, there in zip(TRANSLATION, g.at.translation, start, strict=True):
        k = next((i for i, a in enumerate(g.axes) if a.name == name), None)
        lines.append((k, -there if k is not None else here - there, Fraction(1)))
    return _substituted(f.coefficients, lines, len(g.axes))


def _substituted(
    p: Polynomial | Mapping[tuple[int, int, int], Fraction], lines: Sequence[Line], number: int
) -> Polynomial:
    """p with each variable replaced by a constant, or by a multiple of one of `number` new ones plus a constant."""
    found: dict[tuple[int, ...], Fraction] = {}
    for exponents, c in p.items():
        checkpoint()
        terms = {(0,) * number: c}
        for (k, constant, slope), e in zip(lines, exponents, strict=True):
            terms = _times(terms, k, constant, slope, e)
        for key, value in terms.items():
            found[key] = found.get(key, Fraction(0)) + value
    return {e: c for e, c in found.items() if c}


def _times(
    terms: dict[tuple[int, ...], Fraction], k: int | None, constant: Fraction, slope: Fraction, power: int
) -> dict[tuple[int, ...], Fraction]:
    """Terms times (constant + slope · variable k)^power."""
    found: dict[tuple[int, ...], Fraction] = {}
    for key, c in terms.items():
        for n in range(power + 1) if k is not None else (0,):
            new = key if k is None else (*key[:k], key[k] + n, *key[k + 1 :])
            value = c * comb(power, n) * constant ** (power - n) * slope**n
            found[new] = found.get(new, Fraction(0)) + value
    return found


def vanishes(g: Grid) -> bool:
    """Whether the superbracket is exactly 0 in `MEMBERS` random poses of the slice, with any axes."""
    r, rng = g.rig, drawn("slice", "; ".join(a.text for a in g.axes))
    legs = r.structure.legs
    met = 0
    for _ in range(4 * MEMBERS):
        place = [a.start + (a.stop - a.start) * Fraction(rng.randrange(1, DRAWN), DRAWN) for a in g.axes]
        try:
            points = r.exact(g.pose(place))
        except InputError:  # a leg has no length
            continue
        if superbracket_at(legs, points, (), (Fraction(0),) * 3):
            return False
        met += 1
        if met == MEMBERS:
            break
    return met == MEMBERS


def factors(g: Grid) -> tuple[SliceFactor, ...]:
    """The irreducible factors other than constants; none for the zero polynomial too (see `slice_polynomial`).

    A polynomial with numbers too long to be factored is one factor as a whole.
    """
    import sympy  # large, and needed here only

    p = slice_polynomial(g)
    if not p:
        return ()
    symbols = sympy.symbols([a.name for a in g.axes])
    whole = sympy.Poly({e: sympy.Rational(c.numerator, c.denominator) for e, c in p.items()}, *symbols)
    listed = [(whole, 1)] if bits(p.values()) > FACTORED_BITS else whole.factor_list()[1]
    found = []
    for q, multiplicity in listed:
        exact = {tuple(e): Fraction(int(c.p), int(c.q)) for e, c in q.terms()}
        whole = q.clear_denoms(convert=True)[1].primitive()[1]
        form = PolynomialForm.ordered(tuple(a.name for a in g.axes), ((e, int(c)) for e, c in whole.terms()))
        found.append(SliceFactor(_in_nodes(exact, g), int(multiplicity), form))
    return tuple(sorted(found, key=lambda f: (f.degree, f.text)))


def _in_nodes(p: Polynomial, g: Grid) -> Polynomial:
    lines = [(k, a.start + m * a.step, a.step) for k, (a, m) in enumerate(zip(g.axes, middle(g.shape), strict=True))]
    return _substituted(p, lines, len(g.axes))
