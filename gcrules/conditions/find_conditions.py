r"""What the superbracket of a structure equals: by rules of entities, by the catalog, by factorization."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import combinations, permutations
from math import prod

from gcrules.algebra import expr as ex
from gcrules.algebra.certificate import Certificate
from gcrules.algebra.expr import ONE, Expr, Number, Point, points_of
from gcrules.algebra.for_two_points import sign_apart, written_back
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.screw_letters import Screw
from gcrules.algebra.straightening.straighten import straighten
from gcrules.algebra.superbrackets.shortest import SuperbracketForm
from gcrules.conditions import superbracket_forms as forms
from gcrules.core.dataclass import dataclass
from gcrules.core.english import listed
from gcrules.core.errors import LimitReached
from gcrules.rules.catalog.catalog import FIVE_LEG_SCREW, Catalog, Match
from gcrules.rules.catalog.entries import SHIPPED
from gcrules.rules.claims import best_first, certify, describe, in_special_position
from gcrules.rules.condition import Condition
from gcrules.rules.condition_rule import ConditionClaim
from gcrules.rules.couples import COUPLES
from gcrules.rules.factorization import factored
from gcrules.rules.generic_lines import alive, statement_of_lines
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.rule import StructureRule
from gcrules.rules.screw_readings import of_screws
from gcrules.rules.screw_words import has_screw
from gcrules.rules.sentences import sentence
from gcrules.rules.statement import NOTHING, Quantity, Statement, say
from gcrules.rules.strategy import CATALOG, FACTORIZATION, MAX_TERMS, SHORTEST, Strategy, of_plugins, recognise

__all__ = ["Readings", "always_zero", "linear_complex", "read"]

_MOST_READINGS = 3  # of the kind of the condition itself
_OF_LEGS = 4  # readings of a rule of structure
_SAMPLES = 3


@dataclass(frozen=True)
class Readings:
    """Conditions, the first of them the one with the smallest cofactor; the claim of the rules that it comes from, if
    it does, the form of the superbracket in which it was seen, and all the `forms` that were looked at.
    """

    conditions: tuple[Condition, ...]
    form: SuperbracketForm
    forms: tuple[SuperbracketForm, ...]
    oracle: RandomWitness
    claim: ConditionClaim | None = None
    notes: tuple[str, ...] = ()


def always_zero(structure: Structure, typed: SuperbracketForm) -> Certificate | None:
    """The certificate that the superbracket is zero wherever the points may be; None where it is not."""
    if not structure.given and structure.rank == 4 and not structure.stand_ins:
        if straighten(typed.polynomial):
            return None
        return Certificate("normal-form", "proved: the normal form of the superbracket is 0")
    construction = structure.construction
    if not construction.vanishes(structure.superbracket):
        return None
    where = " at the points that satisfy the assumptions" if structure.given else ""
    try:
        if construction.is_zero(structure.superbracket):
            return Certificate("normal-form", f"proved: the normal form of the superbracket is 0{where}")
    except LimitReached as limited:
        if construction.vanishes(structure.superbracket, samples=_SAMPLES):
            sure = construction.error_below(structure.superbracket, _SAMPLES)
            detail = f"zero at {_SAMPLES} exact random points, {sure}; no proof: {limited.message}"
            return Certificate("random-points", detail)
    return None


def read(
    structure: Structure,
    matches: Sequence[Match],
    catalog: Catalog,
    strategy: Strategy,
    *,
    chosen: tuple[int, ...] | None,
    recheck: bool,
    search: float,
) -> Readings:
    """All conditions that are found: those of rules, of the catalog, and where these leave something to be wished,
    one of a factorization, sought for `search` seconds.
    """
    oracle = RandomWitness(structure)
    if structure.rank != 4:
        some = forms.shortest(structure, strategy)
        found = Readings((), some[0], some, oracle)
    elif structure.stand_ins:
        found = _of_any_lines(structure, oracle, catalog, strategy, chosen=chosen, recheck=recheck, search=search)
    else:
        found = _recognised(structure, oracle, matches, catalog, strategy, chosen=chosen, recheck=recheck)
    if FACTORIZATION in strategy.ids:
        found = _with_factorization(found, structure, matches, search)
    return found if found.conditions else replace(found, notes=(*found.notes, *_other_names(structure, oracle)))


def _other_names(structure: Structure, oracle: RandomWitness) -> list[str]:
    """What would show more under the assumptions: joints that are one point, and points on legs as their joints."""
    names = structure.construction.names if structure.given else ()
    one = [(a, b) for a, b in combinations(names, 2) if oracle.zero(ex.join(Point(a), Point(b), rank=structure.rank))]
    notes = [f"{a} and {b} are one point: one name for both shows what the legs share" for a, b in one]
    for n in names:
        on = [
            word
            for word, line in zip(structure.words, structure.lines, strict=True)
            if n not in points_of(line) and oracle.zero(ex.join(Point(n), line, rank=max(3, structure.rank)))
        ]
        if on and not any(n in pair for pair in one):
            notes.append(
                f"{n} lies on {listed(on)}: a leg may be written as any two of its points, and so as {n} and an end"
            )
    return notes


def _recognised(
    structure: Structure,
    oracle: RandomWitness,
    matches: Sequence[Match],
    catalog: Catalog,
    strategy: Strategy,
    *,
    chosen: tuple[int, ...] | None,
    recheck: bool,
) -> Readings:
    """By the entities of the shortest form, or of the form in the order chosen, and by the catalog."""
    some = forms.shortest(structure, strategy) if chosen is None else forms.in_order(structure, chosen, strategy)
    notes = [f"{m.entry.id} ({m.entry.place}) has the same graph as class {matches[0].entry.id}" for m in matches[1:]]
    claims = best_first(recognise(some, structure, oracle, strategy), structure, oracle)
    if not claims and chosen is not None and SHORTEST in strategy.ids:
        some = forms.shortest(structure, strategy)
        claims = best_first(recognise(some, structure, oracle, strategy), structure, oracle)
        notes.append("the order given shows no entities; the shortest order was used instead")
    elif chosen is not None:
        notes.append("the order of the legs was given; the shortest order may show more")
    claim = claims[0] if claims else None
    if claim is None and len(some[0].polynomial) > MAX_TERMS:
        notes.append(f"entities were not looked for: the shortest form has more than {MAX_TERMS} terms")
    brought = of_plugins(some, structure, oracle, strategy, claim.kind) if claim else ()
    told = [*claims[: 1 + _MOST_READINGS]]
    for more in brought:
        told += best_first(more, structure, oracle)[:_MOST_READINGS]
    sentences = catalog.statements, catalog.statement_sources
    described = ((describe(c, structure, oracle, *sentences), c.source) for c in told)
    conditions = [certify(c, structure, claimed_by=source) for c, source in described]
    known = list(matches) if CATALOG in strategy.ids else []

    def look_up(m: Match) -> None:
        readings = catalog.readings(structure, m, oracle, recheck=recheck)
        new = (r for r in readings if not any(_alike(r, c, oracle) for c in conditions))
        conditions.extend(
            r if r.meaning else replace(r, meaning=_meaning(r, structure, oracle), statement_source="") for r in new
        )

    for m in known:
        if m.entry.owner != SHIPPED:  # what users know of their own classes comes before what is found as a last resort
            look_up(m)
    for rule in strategy.structural:
        if not (rule.last_resort and any(c.cofactor == ONE for c in conditions)):
            of_legs = (_of_rule(rule, c, structure) for c in rule.find(structure, oracle)[:_OF_LEGS])
            conditions += [r for r in of_legs if not any(_alike(r, c, oracle) for c in conditions)]
    for m in known:
        if m.entry.owner == SHIPPED:
            look_up(m)
    notes += [
        f"a reading of class {m.entry.id} says nothing here: its cofactor {e} is zero"
        for m in known
        for e in catalog.dropped(structure, m, oracle)
    ]
    shown = [in_special_position(c, structure, oracle) for c in conditions]
    if claim is None and structure.special:
        shown.sort(key=lambda c: c.cofactor != ONE)
    return Readings(tuple(shown), claim.state.form if claim else some[0], some, oracle, claim, tuple(notes))


def _of_rule(rule: StructureRule, condition: Condition, structure: Structure) -> Condition:
    """The condition that a rule found, proved, with the rule in its certificate."""
    source = rule.named_outside
    proved = certify(condition, structure, claimed_by=source)
    c = proved.certificate
    certificate = Certificate(c.method, c.detail, {**c.data, "rule": rule.id})
    return replace(proved, certificate=certificate, statement_source=source or condition.statement_source)


def _of_any_lines(
    structure: Structure,
    oracle: RandomWitness,
    catalog: Catalog,
    strategy: Strategy,
    *,
    chosen: tuple[int, ...] | None,
    recheck: bool,
    search: float,
) -> Readings:
    """The conditions of general lines, with those that are built from points in their place."""
    lifted = structure.lifted
    some = forms.shortest(structure, strategy) if chosen is None else forms.in_order(structure, chosen, strategy)
    matches = list(catalog.matches(lifted))
    general = _recognised(lifted, RandomWitness(lifted), matches, catalog, strategy, chosen=chosen, recheck=recheck)
    if FACTORIZATION in strategy.ids:
        general = _with_factorization(general, lifted, matches, min(search, _LIFTED_SECONDS))
    found = [c for r in general.conditions if (c := _written_back(r, structure, oracle)) is not None]
    return Readings(tuple(found), some[0], some, oracle, None, (*_notes(structure), *general.notes))


def _notes(structure: Structure) -> Iterator[str]:
    """What is said of legs that are no joins of joints."""
    screws = [str(line) for _, line in structure.stand_ins if isinstance(line, Screw)]
    built = [str(line) for _, line in structure.stand_ins if not isinstance(line, Screw)]
    if built:
        said = "taken as any line through two points of its own; what is found for it holds for this one"
        yield f"{', '.join(built)}: {said}"
    if screws:
        said = "taken as any line first; what is linear in that line holds for screws, and the rest is proved of them"
        yield f"{', '.join(screws)}: {said}"


_LIFTED_SECONDS = 2.0


def _written_back(condition: Condition, structure: Structure, oracle: RandomWitness) -> Condition | None:
    """The identity with the lines written back, which is proved if that of any lines is; None where their points occur
    apart, and where it says nothing here.
    """
    expression, cofactor = (written_back(e, structure.stand_ins) for e in (condition.expression, condition.cofactor))
    if expression is None or cofactor is None:
        return None
    if oracle.zero(cofactor) or oracle.zero(expression):
        return None
    signs, (expression, cofactor) = zip(*map(sign_apart, (expression, cofactor)), strict=True)
    whole, expression = expression, alive(expression, structure)
    meaning = statement_of_lines(condition.meaning, structure.stand_ins) if expression == whole else None
    c = condition.certificate
    found = replace(
        condition,
        expression=expression,
        cofactor=cofactor,
        coefficient=condition.coefficient * prod(signs),
        meaning=meaning or sentence(expression, structure, oracle, cofactor),
        statement_source=condition.statement_source if meaning else "",
        certificate=Certificate(c.method, f"{c.detail}, for any lines in the place of those built from points", c.data),
        entities=(),
        lines=tuple(
            (n, e) for n, line in condition.lines if (e := written_back(line, structure.stand_ins)) is not None
        ),
    )
    return of_screws(found, structure, oracle) if has_screw(expression, cofactor) else found


def _with_factorization(found: Readings, structure: Structure, matches: Sequence[Match], seconds: float) -> Readings:
    """The readings with one of a factorization where there is no other; in special position also where the others have
    a cofactor. Classes of the catalog are known in general position.
    """
    known = next((c for c in found.conditions if c.kind != FIVE_LEG_SCREW), None)
    if matches and not structure.special:
        return found
    if known is not None and (known.cofactor == ONE or known.kind == COUPLES or not structure.special):
        return found
    # Without assumptions all forms are one polynomial, with them they are different ones.
    polynomials = [f.polynomial for f in (found.forms if structure.given else found.forms[:1])]
    outcome = factored(polynomials, structure, found.oracle, seconds=seconds, cofactor=known is None)
    notes = (*found.notes, outcome.note) if outcome.note else found.notes
    if outcome.condition is None:
        return replace(found, notes=notes)
    if known is None or outcome.condition.cofactor == ONE:
        conditions = (outcome.condition, *found.conditions)
        return replace(found, conditions=conditions, claim=None, form=found.forms[0], notes=notes)
    return replace(found, conditions=(*found.conditions, outcome.condition), notes=notes)


def _meaning(condition: Condition, structure: Structure, oracle: RandomWitness) -> Statement:
    """The sentence of an identity to which a catalog gives none."""
    return sentence(condition.expression, structure, oracle, condition.cofactor)


def _unordered(e: Expr) -> str:
    """An expression but for numbers and for the order of its parts."""
    if isinstance(e, Point):
        return e.name
    parts = sorted(_unordered(child) for child in e.children if not isinstance(child, Number))
    return f"{type(e).__name__}({' '.join(parts)})"


def _alike(a: Condition, b: Condition, oracle: RandomWitness) -> bool:
    """Whether two readings say the same in the same words, or compare turns about the same two lines."""
    if not a.meaning and (a.kind, _unordered(a.expression)) == (b.kind, _unordered(b.expression)):
        return True
    if str(a.expression) == str(b.expression) and a.statement == b.statement:
        return True
    mine, others = ([line for _, line in c.lines] for c in (a, b))
    return (a.kind, len(mine), len(others)) == (b.kind, 2, 2) and any(
        all(oracle.proportional(x, y) for x, y in zip(mine, order, strict=True)) for order in permutations(others)
    )


def linear_complex(structure: Structure, catalog: Catalog, *, alone: bool = False) -> Condition:
    """The reading that always holds: the superbracket itself. Where it stands `alone`, it says what follows for one leg
    against the screw that is reciprocal to the other five (half their mutual moment is Ball's virtual coefficient).
    """
    meaning, source = say(catalog.statements["linear-complex"]), catalog.statement_sources.get("linear-complex", "")
    if has_screw(*structure.lines):
        meaning, source = say(_DEPENDENT), ""
    if alone and structure.rank == 4 and not structure.ideal and not source:
        meaning = say("{} {}", meaning, more) if (more := _of_one_leg(structure)) else meaning
    if structure.rank != 4:
        number = {3: "three"}.get(len(structure.legs), str(len(structure.legs)))
        meaning, source = say("The robot is singular exactly when its {} lines are linearly dependent.", number), ""
    return Condition(
        kind="linear-complex",
        expression=structure.superbracket,
        meaning=meaning,
        statement_source=source,
        certificate=Certificate("normal-form", "holds by definition of the superbracket"),
    )


_DEPENDENT = (
    "The robot is singular exactly when its six legs are linearly dependent screws, so that the platform can make an "
    "instantaneous screw motion that is reciprocal to all of them."
)


def _of_one_leg(structure: Structure) -> Statement:
    """The last leg, and the screws of the platform without it: the mutual moment of a screw of pitch h and a line is
    proportional to h cos w − r sin w.
    """
    last = next((line for line in reversed(structure.lines) if not isinstance(line, Screw)), None)
    if last is None:
        return NOTHING
    return say(
        "Without {last} the platform can make the instantaneous screw motions that are reciprocal to the other five "
        "legs, as a rule only one; the robot is singular exactly when one of them is reciprocal to {last} too: when "
        "{reciprocal}, where {h} is its pitch, {r} the distance from its axis to {last} and {w} the angle between them,"
        " right-handed about their common perpendicular (a translation: when {w} is a right angle).",
        last=last,
        reciprocal=Quantity("h cos w = r sin w", r"h\cos w = r\sin w"),
        **{n: Quantity(n) for n in "hrw"},
    )
