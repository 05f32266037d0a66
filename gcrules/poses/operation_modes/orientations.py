r"""Sets of orientations that forms in x0 … x3 describe, taken apart into pieces that do not fall apart further here.

>>> ring = forms_ring()
>>> x0, x1, x2, x3 = ring.gens
>>> sorted(one.text for one in pieces([x0 * x3]))
['x0 = 0', 'x3 = 0']
>>> [one.text for one in pieces([x1**2 + x2**2])]  # of real orientations
['x1 = 0, x2 = 0']
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache
from itertools import combinations
from typing import Any

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.linear_algebra import echelon, kernel

__all__ = ["Orientations", "as_form", "forms_ring", "fraction", "pieces", "whole"]

NAMES = ("x0", "x1", "x2", "x3")

Form = Any  # an element of `forms_ring`


@cache
def forms_ring() -> Any:
    """Polynomials in x0 … x3 over the rationals."""
    from sympy import QQ
    from sympy.polys.orderings import grevlex
    from sympy.polys.rings import PolyRing

    return PolyRing(NAMES, QQ, grevlex)


def as_form(terms: Mapping[tuple[int, int, int, int], Fraction]) -> Form:
    """A polynomial from its terms."""
    ring = forms_ring()
    return ring.from_dict({e: ring.domain(c.numerator, c.denominator) for e, c in terms.items()})


@dataclass(frozen=True)
class Orientations:
    """The orientations at which all forms of a reduced Gröbner `basis` are 0; `prime` if it is shown that they do not
    fall apart over the rationals. `dimension` is that of the set: 3 for all orientations, 0 for single ones.
    """

    basis: tuple[Form, ...]

    @property
    def dimension(self) -> int:
        """The largest number of variables, less 1, of which no leading term of the basis is a product."""
        leading = [f.LM for f in self.basis]
        for size in range(4, 0, -1):
            for free in combinations(range(4), size):
                if not any(all(n in free for n, k in enumerate(m) if k) for m in leading):
                    return size - 1
        return -1

    @property
    def linear(self) -> tuple[Form, ...]:
        """Its forms of degree 1."""
        return tuple(f for f in self.basis if sum(f.LM) == 1)

    @property
    def prime(self) -> bool:
        """Linear forms with at most one irreducible form in the other variables make a prime ideal."""
        return len(self.basis) - len(self.linear) <= 1

    @property
    def text(self) -> str:
        """Its equations."""
        return ", ".join(f"{whole(f)} = 0" for f in self.basis)

    def reduced(self, f: Form) -> Form:
        """The remainder of a form: 0 if it vanishes on a prime set."""
        return f.rem(list(self.basis)) if self.basis else f

    def holds(self, other: Orientations) -> bool:
        """Whether all orientations of the other set are seen to be in this one."""
        return not any(other.reduced(f) for f in self.basis)

    def subspace(self) -> list[tuple[Fraction, ...]]:
        """A basis of the quaternions at which the linear forms are 0."""
        return kernel([_coefficients(f) for f in self.linear], 4)


def whole(f: Form) -> Form:
    """The multiple with whole coefficients without a common divisor."""
    return f.clear_denoms()[1].primitive()[1]


def _coefficients(f: Form) -> tuple[Fraction, ...]:
    return tuple(fraction(f.coeff(x)) for x in forms_ring().gens)


def fraction(c: Any) -> Fraction:
    return Fraction(int(c.numerator), int(c.denominator))


def pieces(forms: Sequence[Form]) -> list[Orientations]:
    """Sets without orientations in common but on their borders, that together are the real zeros of the forms: split
    at factors of their Gröbner basis, and where a sum of squares is 0.
    """
    found: list[Orientations] = []
    for one in _split(list(forms)):
        if not any(other.holds(one) for other in found):
            found = [other for other in found if not one.holds(other)] + [one]
    return found


def _split(forms: list[Form]) -> Iterator[Orientations]:
    from sympy.polys.groebnertools import groebner

    checkpoint()
    forms = [f for f in forms if f]
    for n, f in enumerate(forms):  # factors of what was given come first: bases of the parts are smaller
        parts = _factors(f)
        if parts:
            for g in parts:
                yield from _split([*forms[:n], g, *forms[n + 1 :]])
            return
    basis = tuple(groebner(forms, forms_ring())) if forms else ()
    found = Orientations(basis)
    if found.dimension < 0:
        return
    for n, f in enumerate(basis):
        parts = _factors(f)
        if parts:
            for g in parts:
                yield from _split([*basis[:n], g, *basis[n + 1 :]])
            return
        squares = _kernel_of_squares(f)
        if squares:
            yield from _split([*basis, *squares])
            return
    yield found


def _factors(f: Form) -> list[Form]:
    """Its different factors, none if it is irreducible."""
    if sum(f.LM) < 2:
        return []
    found = [g for g, _ in f.factor_list()[1]]
    return found if sum(found[0].LM) < sum(f.LM) else []


def _kernel_of_squares(f: Form) -> list[Form]:
    """Linear forms that are 0 wherever a quadratic form without negative, or positive, values is 0; none of others."""
    if sum(f.LM) != 2:
        return []
    ring = forms_ring()
    matrix = [[Fraction(0)] * 4 for _ in range(4)]
    for m, c in f.terms():
        places = [n for n, k in enumerate(m) for _ in range(k)]
        matrix[places[0]][places[1]] += fraction(c) / 2
        matrix[places[1]][places[0]] += fraction(c) / 2
    signs = _signs([row[:] for row in matrix])
    if {1, -1} <= set(signs):
        return []
    rows = echelon(matrix)[0]
    return [
        sum((x * ring.domain(c.numerator, c.denominator) for c, x in zip(r, ring.gens, strict=True)), ring.zero)
        for r in rows
    ]


def _signs(a: list[list[Fraction]]) -> list[int]:
    """The signs of the squares of which a symmetric matrix is the sum, by completing them."""
    left = list(range(len(a)))
    found: list[int] = []
    while left:
        n = next((i for i in left if a[i][i]), None)
        if n is None:
            pair = next(((i, j) for i, j in combinations(left, 2) if a[i][j]), None)
            return [*found, *((1, -1) if pair else ())]
        found.append(1 if a[n][n] > 0 else -1)
        left.remove(n)
        for i in left:
            factor = a[i][n] / a[n][n]
            for j in left:
                a[i][j] -= factor * a[n][j]
    return found
