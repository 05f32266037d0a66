r"""From claims to conditions: the most telling claim is chosen, described in words, and proved."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from gcrules.algebra import expr as ex
from gcrules.algebra.certificate import Certificate
from gcrules.algebra.expr import Expr, Join, Meet, Point
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.letters import letters_of
from gcrules.algebra.straightening.straighten import is_zero
from gcrules.core.english import listed
from gcrules.core.errors import EngineFault, LimitReached
from gcrules.core.frozen import FrozenMap
from gcrules.rules.common_lines import line_of_joints
from gcrules.rules.condition import Condition, Entity, starred
from gcrules.rules.condition_rule import ConditionClaim
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.recognition_state import extensor
from gcrules.rules.sentences import sentence
from gcrules.rules.statement import Part, Statement, filled, listing, say

__all__ = ["PROVED", "PROVED_HERE", "best_first", "certify", "describe", "entities_of", "in_special_position", "listed"]

PROVED = Certificate("normal-form", "proved: both sides have the same normal form of standard tableaux")
PROVED_HERE = Certificate(
    "normal-form", "proved under the assumptions: both sides have the same normal form at the points that satisfy them"
)
_TESTED = Certificate("random-points", "holds at exact random points")


def best_first(claims: Sequence[ConditionClaim], structure: Structure, oracle: RandomWitness) -> list[ConditionClaim]:
    """Claims by how much they tell: lines that all other legs meet, planes of legs and of the two bodies, then text.

    Neither signs nor the way the legs are written play a part.
    """

    def key(claim: ConditionClaim) -> tuple[int, int, str]:
        planes = [claim.state.named(row) for row in claim.state.planes]
        planes += [claim.state.named(row) for row in claim.state.taken if len(row) == 3]
        legs = -sum(_legs_in(plane, structure) for plane in planes)
        return (-turns(claim, structure, oracle), legs, "/".join(sorted(map(str, claim.expression.children))))

    distinct: dict[str, ConditionClaim] = {}
    for claim in sorted(claims, key=key):
        distinct.setdefault(str(claim.expression), claim)
    return list(distinct.values())


def _legs_in(plane: tuple[str, ...], structure: Structure) -> int:
    """Legs in a plane of three joints."""
    return sum(set(leg) <= set(plane) for leg in structure.legs)


def turns(claim: ConditionClaim, structure: Structure, oracle: RandomWitness) -> bool:
    """Whether g and h are legs and p and q meet all the others, so that the platform could turn about p and q."""
    if claim.pencils is None or claim.single is None:
        return False
    singles = [frozenset(leg) for leg in claim.single]
    legs = [frozenset(leg) for leg in structure.legs]
    if not all(g in legs for g in singles):
        return False
    others = [extensor(leg) for leg in structure.legs if frozenset(leg) not in singles]
    return all(oracle.zero(ex.meet(line, leg)) for line in claim.pencils for leg in others)


def entities_of(claim: ConditionClaim) -> tuple[Entity, ...]:
    """The entities of a claim: tetrahedra, planes, lines, and what the left-over points make."""
    named = claim.state.named
    found = [("tetrahedron", named(row)) for row in claim.state.tetrahedra]
    found += [("plane", named(row)) for row in claim.state.planes]
    found += [("line", named(row)) for row in claim.state.lines]
    found += [("plane" if len(row) == 3 else "line", named(row)) for row in claim.state.taken]
    return starred(found)


def describe(
    claim: ConditionClaim,
    structure: Structure,
    oracle: RandomWitness,
    statements: Mapping[str, str],
    sources: Mapping[str, str] = FrozenMap(),
) -> Condition:
    """The condition of a claim, not yet proved, with its statement from the template of its kind; `sources` names where
    templates come from that are not gcrules' own.
    """
    turning = turns(claim, structure, oracle)
    kind = claim.kind
    key = f"{kind}/no-turn" if claim.pencils and not turning else kind
    entities = entities_of(claim)
    flats = {k: [extensor(e.points) for e in entities if e.kind == k] for k in ("tetrahedron", "plane", "line")}
    parts: dict[str, Part] = {
        "tetrahedra": listing(flats["tetrahedron"]),
        "planes": listing(sorted(flats["plane"], key=str)),
        "lines": listing(flats["line"]),
        "expression": claim.expression,
    }
    if kind == "three-tetrahedra" and len(set(flats["tetrahedron"])) == 1:
        key = "three-tetrahedra/one"
    if kind == "tetrahedron-planes-line":
        parts["line"] = extensor(entities[-1].points)
    if claim.pencils and claim.single:
        parts |= {name: _line_in_words(line, structure) for name, line in zip("pq", claim.pencils, strict=True)}
        parts |= {name: extensor(leg) for name, leg in zip("gh", claim.single, strict=True)}
    said = statements.get(key, claim.statement)
    return Condition(
        kind=kind,
        expression=claim.expression,
        cofactor=claim.cofactor,
        coefficient=claim.coefficient,
        group=claim.group,
        meaning=said if isinstance(said, Statement) else filled(said, parts.__getitem__),
        statement_source=sources.get(key, "") if key in statements else claim.source,
        certificate=_TESTED,
        entities=entities,
        lines=tuple(zip("pq", claim.pencils, strict=True)) if claim.pencils else (),
    )


def _line_in_words(line: Expr, structure: Structure) -> Statement:
    """ "the line AB through the joints A and B", "the common line of the leg planes Aab and Bcd"."""
    match line:
        case Join(args=(Point(name=a), Point(name=b))):
            return line_of_joints(a, b, structure.ideal)
        case Meet(args=(Join() as x, Join() as y)):
            names = [tuple(str(p) for p in plane.args) for plane in (x, y)]
            word = "leg planes" if all(sum(set(g) <= set(n) for g in structure.legs) > 1 for n in names) else "planes"
            return say("the common line of the {} {} and {}", word, x, y)
    return say("the line {}", line)


def certify(condition: Condition, structure: Structure, *, claimed_by: str = "") -> Condition:
    """The condition with the certificate of a proof by normal forms: for all points, else for those that satisfy what
    is assumed. Where a proof takes more terms than the limit, it stays tested at random points, and `claimed_by` who
    brought it from outside.

    Raises EngineFault where it is no identity.
    """
    identity = condition.identity(structure.superbracket)
    try:
        if is_zero(identity, points=structure.points, ideal=structure.ideal, rank=structure.rank):
            return replace(condition, certificate=PROVED)
        if structure.given and structure.construction.is_zero(identity):
            return replace(condition, certificate=PROVED_HERE)
    except LimitReached as limited:
        if structure.construction.vanishes(identity, samples=_SAMPLES):
            sure = structure.construction.error_below(identity, _SAMPLES)
            whose = f"claimed by {claimed_by}, unproved; " if claimed_by else ""
            detail = f"{whose}holds at {_SAMPLES} exact random points, {sure}; no proof: {limited.message}"
            return replace(condition, certificate=Certificate("random-points", detail))
    raise EngineFault(f"{condition.cofactor} * superbracket != {condition.coefficient} * ({condition.expression})")


def in_special_position(condition: Condition, structure: Structure, oracle: RandomWitness) -> Condition:
    """The condition with a sentence that takes account of points at infinity, and of letters as a whole."""
    if not structure.ideal and not letters_of(structure.names):
        return condition
    if condition.kind in _SAID_BY_WORDS:
        words = sentence(condition.expression, structure, oracle, condition.cofactor)
        return replace(condition, meaning=words, statement_source="")
    far = [name for name, line in condition.lines if name and oracle.at_infinity(line)]
    if not far:
        return condition
    lies = "lies at infinity: a turn about it is a translation" if len(far) == 1 else _BOTH
    where = f"{listed(far)} {lies} at right angles to the directions in it."
    return replace(condition, meaning=say("{} Here {}", condition.meaning, where))


_SAMPLES = 3
_BOTH = "lie at infinity: a turn about one of them is a translation"
_SAID_BY_WORDS = ("three-tetrahedra", "tetrahedron-planes-line", "four-planes")
