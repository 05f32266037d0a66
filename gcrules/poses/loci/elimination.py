r"""A robot's condition as polynomials: the product of each factor over all working modes, exact.

The closed form is run in surds. A factor of the condition is then a rational function of the free variables and of
formal roots, one for each joint that has two places; its norm, the product over all signs of the roots, is a rational
function of the variables alone. In lowest terms its numerator vanishes exactly where the factor does in one of the
working modes, so that elimination brings in no zeros. Where a cofactor divides the factor, so does its norm.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError, LimitReached
from gcrules.poses.loci.closed_form import ClosedForm
from gcrules.poses.loci.form import PolynomialForm
from gcrules.poses.loci.known import whole_ring
from gcrules.poses.loci.limb_question import LimbQuestion
from gcrules.poses.loci.surds import Surd, SurdField, norm

__all__ = ["Eliminated", "FormalRoot", "Norm", "eliminated"]


@dataclass(frozen=True)
class FormalRoot:
    """A root `name` whose square is the `radicand`, in the variables and earlier roots; it tells apart two places of
    `places`. Where the radicand is negative there is none: the robot does not assemble.
    """

    name: str
    places: str
    radicand: PolynomialForm

    def to_json(self) -> dict[str, Any]:
        return {"name": self.name, "places": self.places, "radicand": str(self.radicand)}


_MOST_BITS = 13_000  # of a coefficient
_MOST_ROOTS = 4  # more working modes than 16 are not multiplied


@dataclass(frozen=True, eq=False)
class Norm:
    """coefficient · form / ∏ below^power is the product of a factor over all signs of `roots`, numbers of them."""

    form: PolynomialForm
    coefficient: Fraction
    below: tuple[tuple[PolynomialForm, int], ...]
    roots: tuple[int, ...]


@dataclass(frozen=True, eq=False)
class Eliminated:
    """Norms of the factors, all roots, and which root each node of the graph that is a root stands for."""

    norms: tuple[Norm, ...]
    roots: tuple[FormalRoot, ...]
    numbers: Mapping[int, int]


def eliminated(form: ClosedForm, question: LimbQuestion) -> Eliminated:
    """The norms over the free variables of the question. Raises LimitReached where they grow too large, InputError
    where a limb has no definite place there.
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
    if len(field.radicands) > _MOST_ROOTS:
        raise LimitReached(
            f"{len(field.radicands)} roots make {2 ** len(field.radicands)} working modes: their product is too large a"
            " polynomial",
            hint="gcrules map, path and pose --nearest close the loops by numbers instead",
        )
    norms = tuple(_norm(field, a, b) for a, b in zip(values[::2], values[1::2], strict=True))
    names: list[str] = []
    places = [next(form.placed[n] for n, number in numbers.items() if number == k) for k in range(len(field.radicands))]
    for k, name in enumerate(places):
        names.append(f"s_{name}" if name not in places[:k] else f"s{k}_{name}")
    roots = [
        FormalRoot(name, place, _radicand(parts, question.free, names[:k]))
        for k, (name, place, parts) in enumerate(zip(names, places, field.radicands, strict=True))
    ]
    return Eliminated(norms, tuple(roots), numbers)


def _norm(field: SurdField, value: Surd, over: Surd) -> Norm:
    free = tuple(map(str, field.ring.symbols))
    if not value:
        return Norm(PolynomialForm(free, ()), Fraction(0), (), ())
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
    return Norm(PolynomialForm.of(p * sign), found.scale * sign, below, roots)


def _radicand(parts: Mapping[int, Any], free: Sequence[str], roots: Sequence[str]) -> PolynomialForm:
    terms = [
        ((*map(int, e), *(mask >> k & 1 for k in range(len(roots)))), int(c))
        for mask, p in parts.items()
        for e, c in p.terms()
    ]
    used = [k for k in range(len(roots)) if any(e[len(free) + k] for e, _ in terms)]
    kept = [*range(len(free)), *(len(free) + k for k in used)]
    names = (*free, *(roots[k] for k in used))
    return PolynomialForm.ordered(names, ((tuple(e[k] for k in kept), c) for e, c in terms))
