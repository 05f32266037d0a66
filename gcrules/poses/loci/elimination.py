r"""A robot's condition as polynomials, exact: with its roots, or the product of each factor over all working modes.

The closed form is run in surds. A factor of the condition is then a rational function of the free variables and of
formal roots, one for each joint that has two places; its norm, the product over all signs of the roots, is a rational
function of the variables alone. In lowest terms its numerator vanishes exactly where the factor does in one of the
working modes, so that elimination brings in no zeros. Where a cofactor divides the factor, so does its norm.

Norms are long: over r roots their degrees are 2^r times those of the factor. Where that may be too much the roots stay
in the numerator, a polynomial in the variables and the roots, each to a power of at most one.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from math import comb
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError, LimitReached
from gcrules.poses.loci.closed_form import ClosedForm
from gcrules.poses.loci.form import PolynomialForm
from gcrules.poses.loci.known import whole_ring
from gcrules.poses.loci.limb_question import LimbQuestion
from gcrules.poses.loci.surds import Surd, SurdField, eliminated_roots, norm

__all__ = ["Eliminated", "FormalRoot", "Numerator", "eliminated"]


@dataclass(frozen=True)
class FormalRoot:
    """A root `name` whose square is the `radicand`, in the variables and earlier roots; it tells apart two places of
    `places`. Where the radicand is negative there is none: the robot does not assemble. In home's working mode it has
    the sign of the product of `sign`, + where that is empty.
    """

    name: str
    places: str
    radicand: PolynomialForm
    sign: tuple[PolynomialForm, ...] = ()

    def to_json(self) -> dict[str, Any]:
        sign = [str(p) for p in self.sign]
        return {"name": self.name, "places": self.places, "radicand": str(self.radicand), "sign_at_home": sign}


_MOST_BITS = 13_000  # of a coefficient
_MOST_TERMS = 20_000  # of a norm, as far as its degrees tell: longer ones are computed on demand
_MOST_ROOTS = 4  # more working modes than 16 are not multiplied


@dataclass(frozen=True, eq=False)
class Numerator:
    """coefficient · form / ∏ below^power is the product of a factor over all signs of `roots`, numbers of them; or the
    factor itself, if the roots are kept, and their names are variables of the forms.
    """

    form: PolynomialForm
    coefficient: Fraction
    below: tuple[tuple[PolynomialForm, int], ...]
    roots: tuple[int, ...]


@dataclass(frozen=True, eq=False)
class Eliminated:
    """Numerators of the factors, all roots, which root each node of the graph that is a root stands for; and whether
    the roots are `multiplied` out.
    """

    numerators: tuple[Numerator, ...]
    roots: tuple[FormalRoot, ...]
    numbers: Mapping[int, int]
    multiplied: bool


def eliminated(form: ClosedForm, question: LimbQuestion, product: bool | None) -> Eliminated:
    """The numerators over the free variables of the question: products over the working modes, or with the roots; if
    it is left open (None) products that may be long are not computed. Raises LimitReached where they grow too large,
    InputError where a limb has no definite place there.
    """
    ring = whole_ring(question.free)
    field = SurdField(ring)
    free = dict(zip(question.free, field.gens, strict=True))
    inputs = [free[n] if n in free else field.number(question.fixed[n]) for n in question.variables]
    numbers: dict[int, int] = {}

    def root(node: int, x: Surd) -> Surd:
        found = x.root()
        if found:
            numbers[node] = found.roots.bit_length() - 1
        return found

    of = [r for f in form.factors for r in (f.value, f.over)]
    values = [field.number(v) if not isinstance(v, Surd) else v for v in form.values(inputs, root, Surd.inverse, of)]
    count = len(field.radicands)
    if product and count > _MOST_ROOTS:
        raise LimitReached(
            f"{count} roots make {2**count} working modes: their product is too large a polynomial",
            hint="leave the roots in: without --product (in Python product=False) the polynomial has them as variables",
        )
    if product is None:
        product = count <= _MOST_ROOTS and max(map(_terms_of_norm, values), default=0) <= _MOST_TERMS
    roots = tuple(_roots(field, form, numbers, question.free))
    pairs = list(zip(values[::2], values[1::2], strict=True))
    if product or not roots:
        return Eliminated(tuple(_norm(field, a, b) for a, b in pairs), roots, numbers, True)
    return Eliminated(tuple(_kept(field, a, b, [r.name for r in roots]) for a, b in pairs), roots, numbers, False)


def _roots(field: SurdField, form: ClosedForm, numbers: Mapping[int, int], free: Sequence[str]) -> Iterator[FormalRoot]:
    """All roots, named by what they place."""
    places = [next(form.placed[n] for n, number in numbers.items() if number == k) for k in range(len(field.radicands))]
    names = [f"s_{name}" if name not in places[:k] else f"s{k}_{name}" for k, name in enumerate(places)]
    for k, (name, place, parts) in enumerate(zip(names, places, field.radicands, strict=True)):
        every = _with_roots(parts, free, names[:k])
        used = [n for n in every.variables if n in free or every.degree_in([n]) > 0]
        at = [every.variables.index(n) for n in used]
        radicand = PolynomialForm.ordered(tuple(used), ((tuple(e[i] for i in at), c) for e, c in every.terms))
        squares = [p[0].primitive()[1] for p in field.radicands[:k] if set(p) == {0}]  # of roots that are there, too
        sign = [PolynomialForm.of(p) for d in field.signs[k] if (p := field.divisors[d]) not in squares]
        yield FormalRoot(name, place, radicand, tuple(p for p in sign if not _positive(p)))


def _positive(p: PolynomialForm) -> bool:
    """Whether it is seen at once that a polynomial is nowhere negative: a sum of squares of monomials, or of degree 2
    with a matrix that is.
    """
    if all(c > 0 and not any(n % 2 for n in e) for e, c in p.terms):
        return True
    if p.degree != 2:
        return False
    from sympy import Matrix, Rational

    n = len(p.variables)
    rows = Matrix.zeros(n + 1, n + 1)
    for e, c in p.terms:
        i, j = [*(k for k, power in enumerate(e) for _ in range(power)), n, n][:2]
        rows[i, j] += Rational(c, 2)
        rows[j, i] += Rational(c, 2)
    return bool(rows.is_positive_semidefinite)


def _terms_of_norm(x: Surd) -> int:
    """The number of terms that its norm has at most, by the degrees."""
    field, count = x.field, len(x.field.ring.gens)
    every = eliminated_roots(x)
    weights: list[float] = []  # the degrees of roots
    for parts in field.radicands:
        weights.append(_degree(parts, weights) / 2)
    return comb(count + int(_degree(x.parts, weights) * 2 ** len(every)), count)


def _degree(parts: Mapping[int, Any], weights: Sequence[float]) -> float:
    """The degree of parts, where roots have those of `weights`."""
    return max(
        (
            max(map(sum, p.monoms())) + sum(w for k, w in enumerate(weights) if mask >> k & 1)
            for mask, p in parts.items()
        ),
        default=0,
    )


def _kept(field: SurdField, value: Surd, over: Surd, names: Sequence[str]) -> Numerator:
    """The numerator of value / over, with the roots."""
    free = tuple(map(str, field.ring.symbols))
    roots = tuple(sorted({*eliminated_roots(value), *eliminated_roots(over)}))
    if not value:
        return Numerator(PolynomialForm((*free, *names), ()), Fraction(0), (), roots)
    if not over.roots:
        value, over = value * over.inverse(), field.number(1)
    powers = {k: value.below.get(k, 0) - over.below.get(k, 0) for k in (*value.below, *over.below)}
    above = field.power({k: -n for k, n in powers.items() if n < 0})
    form = _with_roots({mask: p * above for mask, p in value.parts.items()}, free, names)
    below = [(PolynomialForm.of(field.divisors[k]), n) for k, n in powers.items() if n > 0]
    if over.roots:
        below.append((_with_roots(over.parts, free, names), 1))
    sign = -1 if form.terms[0][1] < 0 else 1
    form = PolynomialForm(form.variables, tuple((e, c * sign) for e, c in form.terms))
    return Numerator(form, value.scale / over.scale * sign, tuple(below), roots)


def _norm(field: SurdField, value: Surd, over: Surd) -> Numerator:
    free = tuple(map(str, field.ring.symbols))
    if not value:
        return Numerator(PolynomialForm(free, ()), Fraction(0), (), ())
    above, first = norm(value)
    under, second = norm(over)
    roots = tuple(sorted({*first, *second}))
    for _ in range(len(roots) - len(first)):
        above = above * above
    for _ in range(len(roots) - len(second)):
        under = under * under
    if not above or not under:
        raise InputError(
            "in one of the working modes every pose is singular there, or none has a definite value: the product over"
            " the modes is 0",
            hint="leave another coordinate free; gcrules map, path and pose --nearest keep to home's working mode",
        )
    found = above * under.inverse()
    (p,) = found.parts.values()
    if max(abs(int(c)).bit_length() for c in p.coeffs()) > _MOST_BITS:
        raise LimitReached(
            "the polynomial has coefficients of more than 4,000 digits", hint="give coordinates with fewer digits"
        )
    sign = -1 if p.LC < 0 else 1
    below = tuple((PolynomialForm.of(field.divisors[k]), n) for k, n in found.below.items())
    return Numerator(PolynomialForm.of(p * sign), found.scale * sign, below, roots)


def _with_roots(parts: Mapping[int, Any], free: Sequence[str], roots: Sequence[str]) -> PolynomialForm:
    """Parts as a polynomial in the variables and the roots."""
    terms = (
        ((*map(int, e), *(mask >> k & 1 for k in range(len(roots)))), int(c))
        for mask, p in parts.items()
        for e, c in p.terms()
    )
    return PolynomialForm.ordered((*free, *roots), terms)
