r"""What is known to divide: powers of the quaternion's norm, and the brackets that the condition has as factors."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.poses.loci.factors import PossibleFactor, divided, primitive
from gcrules.poses.loci.form import PolynomialForm
from gcrules.poses.loci.variables import Question, images
from gcrules.rules.condition import Condition
from gcrules.screws.rotations import unscaled

__all__ = ["candidates", "rational_ring", "whole_ring"]

Vector = Sequence[Any]


def rational_ring(variables: Sequence[str]) -> Any:
    """sympy's ring of polynomials in these variables over the rationals."""
    from sympy import QQ
    from sympy.polys.rings import PolyRing

    return PolyRing(list(variables), QQ)


def whole_ring(variables: Sequence[str]) -> Any:
    """The same over the integers."""
    from sympy import ZZ
    from sympy.polys.rings import PolyRing

    return PolyRing(list(variables), ZZ)


def candidates(
    rig: MovingPlatform, question: Question, condition: Condition, norms: Sequence[PolynomialForm]
) -> list[PossibleFactor]:
    """Norms first, then the tetrahedra of the condition, each a bracket of four joints."""
    whole = whole_ring(question.free)
    norm = [whole.from_dict(dict(n.terms)) for n in norms]
    found = [PossibleFactor("norm", "", n) for n in norm]
    four = dict.fromkeys(e.points for e in condition.entities if e.kind == "tetrahedron")
    if four:
        ring = rational_ring(question.free)
        places = dict(_places(rig, question, ring))
        for names in four:
            bracket = _bracket([places[n] for n in names])
            if bracket and not bracket.is_ground:
                p = primitive(bracket)[1]
                for n in norm:
                    p = divided(p, n)[0]
                found.append(PossibleFactor("bracket", f"[{' '.join(names)}]", p))
    return found


def _places(rig: MovingPlatform, question: Question, ring: Any) -> Iterator[tuple[str, tuple[Vector, Any]]]:
    """Each joint's coordinates times its weight, and that weight: |e|² for those of the platform, else 1."""
    shift, (w, x, y, z), _ = images(question, ring)
    norm = w * w + x * x + y * y + z * z
    rows = unscaled((w, x, y, z))
    for n, p in rig.points.items():
        at = [ring.domain(c.numerator, c.denominator) for c in p]
        if rig.structure.sides[n] != "platform":
            yield n, ([ring.one * c for c in at], ring.one)
            continue
        centre = [ring.domain(c.numerator, c.denominator) for c in rig.centre]
        arm = [c - m for c, m in zip(at, centre, strict=True)]
        yield (
            n,
            (
                [
                    sum((r * c for r, c in zip(row, arm, strict=True)), norm * (m + t))
                    for row, m, t in zip(rows, centre, shift, strict=True)
                ],
                norm,
            ),
        )


def _bracket(places: Sequence[tuple[Vector, Any]]) -> Any:
    """A multiple of the bracket by a power of the norm. Differences of joints of one body hold no translation."""
    first, *others = sorted(places, key=lambda p: p[1].is_ground)
    rows = [
        [b - a for a, b in zip(first[0], at, strict=True)]
        if weight == first[1]
        else [weight * a - first[1] * b for a, b in zip(first[0], at, strict=True)]
        for at, weight in others
    ]
    (a, b, c), v, w = rows[0], rows[1], rows[2]
    return a * (v[1] * w[2] - v[2] * w[1]) + b * (v[2] * w[0] - v[0] * w[2]) + c * (v[0] * w[1] - v[1] * w[0])
