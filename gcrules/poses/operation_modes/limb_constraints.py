r"""The equations that a limb's joints put on the platform's pose, its actuators free: found by interpolation.

Looked for are the equations of degree at most 1 in y: c(x) + a0(x) y0 + … + a3(x) y3 = 0. Those of one degree that hold
at random poses of the limb modulo a large prime form a linear space; it is computed, lifted to the rationals and tried
at fresh exact poses.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import combinations_with_replacement
from math import isqrt
from typing import Any

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached
from gcrules.core.frozen import FrozenMap
from gcrules.core.linear_algebra import echelon, kernel, rank
from gcrules.core.seeds import DRAWN, PRIME, drawn
from gcrules.poses.operation_modes.study import Motion, pose, velocities
from gcrules.screws.study import DualQuaternion

__all__ = [
    "DEGREE",
    "FRESH",
    "STUDY",
    "Equation",
    "LimbConstraints",
    "codimension",
    "gradient",
    "lifted",
    "limb_constraints",
    "of_degree",
    "residue",
    "value",
]

DEGREE = 4
"""Equations of higher degree are not looked for."""

FRESH = 3
"""At so many fresh exact poses each equation is tried."""

_PRIME = PRIME
_MORE = 8  # poses beyond the number of coefficients

Exponents = tuple[int, int, int, int]
Form = Mapping[Exponents, Fraction]
Equation = tuple[Form, Form, Form, Form, Form]
"""Forms a0 … a3 and c in x: a0 y0 + … + a3 y3 + c = 0."""


def _unit(n: int) -> Exponents:
    a, b, c, d = (int(n == k) for k in range(4))
    return a, b, c, d


STUDY: Equation = (
    FrozenMap({_unit(0): Fraction(1)}),
    FrozenMap({_unit(1): Fraction(1)}),
    FrozenMap({_unit(2): Fraction(1)}),
    FrozenMap({_unit(3): Fraction(1)}),
    FrozenMap({}),
)
"""x0 y0 + … + x3 y3 = 0, which holds for all poses."""


@dataclass(frozen=True)
class LimbConstraints:
    """The equations of one limb, without Study's own; the limb reaches `dimension`-dimensional poses. They are `enough`
    where near such a pose they allow no others.
    """

    name: str
    equations: tuple[Equation, ...]
    dimension: int
    enough: bool


def limb_constraints(name: str, moves: Sequence[Motion]) -> LimbConstraints:
    """What a limb of these motions demands of poses."""
    count = max((m.place for m in moves), default=-1) + 1
    residues = [Motion(m.place, _residues(m.C), _residues(m.D)) for m in moves]
    random = drawn("operation modes", name)

    def sample() -> list[int]:
        return [random.randrange(1, DRAWN) for _ in range(count)]

    amounts = sample()
    generic = pose(residues, amounts, _PRIME)
    dimension = rank([generic, *velocities(residues, amounts, _PRIME)], _PRIME) - 1
    found: list[Equation] = []
    fresh = [
        pose(moves, [Fraction(random.randint(-9, 9), random.randint(1, 5)) for _ in range(count)]) for _ in range(FRESH)
    ]
    for degree in range(1, DEGREE + 1):
        if degree > 2 and codimension(found, generic) == 6 - dimension:
            break
        for equation in of_degree(degree, [STUDY, *found], lambda: pose(residues, sample(), _PRIME)):
            if all(value(equation, one) == 0 for one in fresh):
                found.append(equation)
    return LimbConstraints(name, tuple(found), dimension, codimension(found, generic) == 6 - dimension)


def codimension(found: Sequence[Equation], at: DualQuaternion) -> int:
    """By how much equations lower the dimension of the poses near one of them."""
    return rank([gradient(e, at, _PRIME) for e in (STUDY, *found)], _PRIME) - 1


def _residues(numbers: DualQuaternion) -> DualQuaternion:
    return tuple(residue(c) for c in numbers)


def residue(c: Any) -> int:
    exact = Fraction(c)
    return exact.numerator * pow(exact.denominator, -1, _PRIME) % _PRIME


def _monomials(degree: int) -> list[Exponents]:
    found = []
    for chosen in combinations_with_replacement(range(4), degree):
        a, b, c, d = (chosen.count(n) for n in range(4))
        found.append((a, b, c, d))
    return found


def of_degree(degree: int, known: Sequence[Equation], sample: Any) -> Iterator[Equation]:
    """Equations of a degree that follow from no known ones of lower degree."""
    places = [(n, e) for n in range(4) for e in _monomials(degree - 1)] + [(4, e) for e in _monomials(degree)]
    column = {place: k for k, place in enumerate(places)}
    rows = []
    for _ in range(len(places) + _MORE):
        checkpoint()
        one = sample()
        rows.append([_power(e, one, _PRIME) * (one[4 + n] if n < 4 else 1) % _PRIME for n, e in places])
    # columns in reverse, so that leading ones stand at terms with y and what has no y comes out by itself
    vanishing = echelon(kernel(rows, len(places), _PRIME), _PRIME)[0]
    span: list[Sequence[int]] = [_vector(m, column) for e in known for m in _multiples(e, degree)]
    size = rank(span, _PRIME) if span else 0
    for vector in reversed(vanishing):
        more = rank([*span, vector], _PRIME)
        if more > size:
            span, size = [*span, vector], more
            forms: list[dict[Exponents, Fraction]] = [{} for _ in range(5)]
            for (n, e), c in zip(places, vector, strict=True):
                if c:
                    forms[n][e] = lifted(c)
            a0, a1, a2, a3, c0 = map(FrozenMap, forms)
            yield a0, a1, a2, a3, c0


def _multiples(equation: Equation, degree: int) -> Iterator[Equation]:
    own = _degree(equation)
    for e in _monomials(degree - own) if degree >= own else ():
        a0, a1, a2, a3, c = ({_plus(m, e): v for m, v in form.items()} for form in equation)
        yield a0, a1, a2, a3, c
    if not any(equation[:4]) and degree > own:
        for e in _monomials(degree - own - 1):
            times = {_plus(m, e): v for m, v in equation[4].items()}
            for n in range(4):
                a0, a1, a2, a3 = (times if n == k else {} for k in range(4))
                yield a0, a1, a2, a3, {}


def _degree(equation: Equation) -> int:
    return max(sum(e) + (n < 4) for n, form in enumerate(equation) for e in form)


def _plus(a: Exponents, b: Exponents) -> Exponents:
    return a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]


def _vector(equation: Equation, column: Mapping[tuple[int, Exponents], int]) -> list[int]:
    found = [0] * len(column)
    for n, form in enumerate(equation):
        for e, c in form.items():
            found[column[n, e]] = residue(c)
    return found


def lifted(c: int) -> Fraction:
    """The fraction with the least numerator and denominator that has this residue. Raises LimitReached."""
    bound = isqrt(_PRIME // 2)
    r0, r1, s0, s1 = _PRIME, c, 0, 1
    while r1 > bound:
        q = r0 // r1
        r0, r1, s0, s1 = r1, r0 - q * r1, s1, s0 - q * s1
    if not s1 or abs(s1) > bound:
        raise LimitReached(
            "the coefficients of a limb's equations are too long to be found",
            hint="give home by shorter fractions",
        )
    return Fraction(r1, s1)


def _power(e: Exponents, x: Sequence[Any], modulus: int | None = None) -> Any:
    found: Any = 1
    for base, n in zip(x[:4], e, strict=True):
        for _ in range(n):
            found = found * base if modulus is None else found * base % modulus
    return found


def value(equation: Equation, at: Sequence[Any]) -> Any:
    """The left side at a pose."""
    factors = (*at[4:], 1)
    return sum(c * _power(e, at) * factors[n] for n, form in enumerate(equation) for e, c in form.items())


def gradient(equation: Equation, at: Sequence[Any], modulus: int | None = None) -> list[Any]:
    """Its derivatives by x0 … y3 at a pose."""
    found: list[Any] = [0] * 8
    for n, form in enumerate(equation):
        for e, exact in form.items():
            c: Any = exact if modulus is None else residue(exact)
            if n < 4:
                found[4 + n] += c * _power(e, at, modulus)
            for k in range(4):
                if e[k]:
                    less = (e[0] - (k == 0), e[1] - (k == 1), e[2] - (k == 2), e[3] - (k == 3))
                    found[k] += c * e[k] * _power(less, at, modulus) * (at[4 + n] if n < 4 else 1)
    return found if modulus is None else [c % modulus for c in found]
