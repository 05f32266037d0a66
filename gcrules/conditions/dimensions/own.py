"""The condition of one robot: joints that coincide are one, and what holds of its bodies is given."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from random import Random

from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.expr import points_of
from gcrules.algebra.language.legs_text import Structure, legs_text, read_legs
from gcrules.algebra.language.text import text
from gcrules.conditions.analysis import Analysis, analyze
from gcrules.conditions.dimensions.architecture import lines_at, whole
from gcrules.conditions.dimensions.facts import Fact, OwnCondition
from gcrules.conditions.gained_motion import factors
from gcrules.core.budget import within
from gcrules.core.english import listed
from gcrules.core.errors import EngineFault, InputError, LimitReached
from gcrules.core.linear_algebra import whole_determinant
from gcrules.screws.rotations import rotation

__all__ = ["SECONDS", "own_condition"]

SECONDS = 5.0
"""So long the condition under the facts is sought."""

_POSES = 3
_PLANE = (
    "with bodies that are plane the condition of these legs was found to be the same: a plane base or platform changes"
    " that of no class of the catalog"
)

Vector = tuple[Fraction, Fraction, Fraction]


def own_condition(
    general: Analysis, points: Mapping[str, Vector], facts: Sequence[Fact]
) -> tuple[OwnCondition | None, str]:
    """The condition of the robot whose joints are at these exact places, if the exact facts make it another one than
    that of its legs in general position, and a sentence that says what was tried.

    Joints that coincide get one name, that of the first of them. Coplanar and collinear joints are assumed to be so;
    factors all of whose joints are of one body have the same value in all poses, and are told apart. The identity is
    compared with the determinant of the legs in random exact poses of this robot. Raises EngineFault where they differ.
    """
    exact = [fact for fact in facts if fact.exact and fact.body]
    names = {n: fact.members[0] for fact in exact if fact.kind == "coincident" for n in fact.members[1:]}
    legs = [(names.get(a, a), names.get(b, b)) for a, b in general.structure.legs]
    if len(set(legs)) < len(legs):
        return None, ""
    lines, planes = (tuple(dict.fromkeys(_assumptions(exact, names, kind))) for kind in ("collinear", "coplanar"))
    tried, like = "", general
    for given in dict.fromkeys((lines, (*lines, *planes))):
        if not names and not given:
            continue
        if given and not lines and like.match is not None and _whole(exact, names, like.structure):
            return _with_fixed_factors(general, points), _PLANE
        try:
            with within(SECONDS):
                found = _analysed(legs, general.structure, given)
        except (LimitReached, InputError) as limit:
            return None, f"what the condition becomes under these facts was not found: {limit.message}"
        if _other(found, general) and _applies(found, points):
            return _told(found, points, names, given), ""
        like = found
        told = [*(["joints that coincide taken as one"] if names else []), *given]
        tried = f"with {listed(told)} no condition was found other than that of the legs in general"
    return _with_fixed_factors(general, points), tried


def _assumptions(facts: Sequence[Fact], names: Mapping[str, str], kind: str) -> Iterator[str]:
    for fact in facts:
        members = tuple(dict.fromkeys(names.get(n, n) for n in fact.members))
        if fact.kind == kind and len(members) > (2 if kind == "collinear" else 3):
            yield f"{kind}({', '.join(members)})"


def _whole(facts: Sequence[Fact], names: Mapping[str, str], structure: Structure) -> bool:
    """Whether all joints of a body are in each plane."""
    planes = [{names.get(n, n) for n in fact.members} for fact in facts if fact.kind == "coplanar"]
    bodies = [{n for n in structure.names if structure.sides.get(n) == body} for body in ("base", "platform")]
    return all(plane in bodies for plane in planes)


def _analysed(legs: Sequence[tuple[str, str]], structure: Structure, given: Sequence[str]) -> Analysis:
    left = {n for leg in legs for n in leg}
    declared = tuple(n for n in structure.names if n in left)
    return analyze(read_legs(legs, points=declared, given=given))


def _other(found: Analysis, general: Analysis) -> bool:
    """Whether a condition says more than that the six lines depend on each other, and not what is known already."""
    return found.condition.kind != "linear-complex" and found.condition.expression != general.condition.expression


def _applies(found: Analysis, points: Mapping[str, Vector]) -> bool:
    """Whether nothing vanishes at these places that must not for the assumptions to say what they are taken to say."""
    if not found.structure.given:
        return True
    at = _homogeneous(points)
    return all(_some(evaluate(e, at)) for e in found.structure.construction.nonzero)


def _some(value: object) -> bool:
    return any(value) if isinstance(value, (tuple, list)) else bool(value)


def _with_fixed_factors(general: Analysis, points: Mapping[str, Vector]) -> OwnCondition | None:
    """The condition itself, where some of its factors keep their value in every pose; None where none does."""
    told = _told(general, points, {}, ())
    return told if told is not None and told.fixed else None


def _told(
    found: Analysis,
    points: Mapping[str, Vector],
    names: Mapping[str, str],
    given: tuple[str, ...],
) -> OwnCondition | None:
    """With its factors told apart, and compared with the legs in some poses of this robot."""
    structure, condition = found.structure, found.condition
    if len(structure.sides) < len(structure.names):
        return None
    homogeneous = _homogeneous(points)
    fixed: list[str] = []
    free: list[str] = []
    for factor in factors(condition.expression):
        bodies = {structure.sides[n] for n in points_of(factor) if n in structure.sides}
        still = len(bodies) == 1 and evaluate(factor, homogeneous) != 0
        (fixed if still else free).append(text(factor, names=structure.names))
    _compare(structure, found, points)
    return OwnCondition(
        condition=condition,
        legs=legs_text(structure.legs),
        names=tuple(names.items()),
        given=given,
        free=tuple(free),
        fixed=tuple(fixed),
        poses=_POSES,
    )


def _homogeneous(points: Mapping[str, Vector]) -> dict[str, tuple[Fraction, ...]]:
    return {n: (*p, Fraction(1)) for n, p in points.items()}


def _compare(structure: Structure, found: Analysis, points: Mapping[str, Vector]) -> None:
    """Raises EngineFault where cofactor · determinant of the legs is not what the condition says in a random pose."""
    draw = Random("poses of this robot")
    at = {n: tuple(map(Fraction, points[n])) for n in structure.names}
    base, platform = whole([at[a] for a, _ in structure.oriented], [at[b] for _, b in structure.oriented])
    ends = zip(structure.oriented, base, platform, strict=True)
    places = {n: p for leg, *pair in ends for n, p in zip(leg, pair, strict=True)}
    for _ in range(_POSES):
        q = (draw.randint(1, 99), *(draw.randint(-99, 99) for _ in range(3)))
        t = tuple(draw.randint(-999, 999) for _ in range(3))
        turn = rotation(tuple(map(Fraction, q)))  # type: ignore[arg-type]
        moved = {
            n: (*(_moved(p, turn, t) if structure.sides[n] == "platform" else p), Fraction(1))
            for n, p in places.items()
        }
        legs = whole_determinant(lines_at(base, platform, q, t))
        value = Fraction(legs, sum(c * c for c in q) ** len(base)) * -structure.orientation
        condition = found.condition
        if evaluate(condition.cofactor, moved) * value != evaluate(condition.right_side, moved):
            raise EngineFault(f"the legs and the condition {condition.expression} disagree in a pose")


def _moved(p: Sequence[int], turn: Sequence[Sequence[Fraction]], t: Sequence[int]) -> tuple[Fraction, ...]:
    return tuple(sum((r * c for r, c in zip(row, p, strict=True)), Fraction(s)) for row, s in zip(turn, t, strict=True))
