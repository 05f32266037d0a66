r"""The pipeline: six legs -> superbracket -> shortest form -> entities -> condition -> statement -> certificate.

>>> a = analyze("ab af cb cd ed ef")
>>> a.match.entry.id, a.group
('3-3.3', 'c')
>>> print(a.condition.expression)
abc /\ aef /\ bdf /\ cde
>>> print(a.condition.statement)
The robot is singular exactly when the four planes abc, aef, bdf and cde meet in a point (possibly at infinity).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from os import PathLike
from typing import Any

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr, Meet
from gcrules.algebra.language.legs_text import Structure, read_legs, read_order
from gcrules.algebra.language.text import Names, text
from gcrules.algebra.plain_letters import in_plain_letters, names_in
from gcrules.algebra.superbrackets.shortest import SuperbracketForm
from gcrules.conditions import superbracket_forms as forms
from gcrules.conditions.dimensions.facts import Dimensions
from gcrules.conditions.find_conditions import Readings, always_zero, linear_complex, read
from gcrules.conditions.pose_value import Coordinates, PoseValue
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import EngineFault, InputError
from gcrules.core.seeds import remark
from gcrules.core.shown import Shown
from gcrules.rules.catalog.catalog import FIVE_LEG_SCREW, Match
from gcrules.rules.catalog.file import Own, load
from gcrules.rules.condition import Condition, Entity, starred
from gcrules.rules.condition_rule import ConditionClaim
from gcrules.rules.degenerate import Degeneracy, explain
from gcrules.rules.derivation import Derivation
from gcrules.rules.deriving import derived, derived_zero
from gcrules.rules.factorization import SECONDS
from gcrules.rules.foreign import PluginFault
from gcrules.rules.plugin import packs
from gcrules.rules.plugins import load_rules
from gcrules.rules.rule import SHIPPED
from gcrules.rules.statement import say
from gcrules.rules.strategy import SHORTEST, Strategy

__all__ = ["Analysis", "analyze"]


@dataclass(frozen=True)
class Analysis(Shown):
    """All stages of the analysis of six legs, as frozen values.

    `typed` is the superbracket of the legs in the order given, `shortest` its shortest form; `match` the class of the
    catalog; `condition` the reading with the smallest cofactor and `readings` the others, each of them an identity
    cofactor · superbracket = coefficient · expression; `derivation` the steps that lead to the condition. If the legs
    came with coordinates, `platform` holds them, `pose` the numbers there and `dimensions` what they say of the bodies.
    `strategy` holds the rules that were run.
    """

    structure: Structure
    typed: SuperbracketForm
    shortest: SuperbracketForm
    match: Match | None
    condition: Condition
    readings: tuple[Condition, ...]
    derivation: Derivation
    strategy: Strategy
    claim: ConditionClaim | None = None
    degeneracy: Degeneracy | None = None
    notes: tuple[str, ...] = ()
    platform: Coordinates | None = None
    pose: PoseValue | None = None
    dimensions: Dimensions | None = None

    @property
    def entities(self) -> tuple[Entity, ...]:
        return self.condition.entities

    @property
    def group(self) -> str | None:
        """The published group of entities, a … g; None where the procedure does not reach."""
        return self.condition.group

    @property
    def lines(self) -> tuple[Expr, ...]:
        """The legs as expressions of step 2."""
        return self.structure.lines

    @property
    def assumed(self) -> tuple[tuple[str, str], ...]:
        """What must not vanish for the assumptions to say what they are taken to say, each with its meaning."""
        return self.structure.assumed

    @property
    def applied(self) -> tuple[str, ...]:
        """The rules that led to it: those of the derivation, then those of plugins that made a reading."""
        brought = {r.id for r in self.strategy.incidences if r.owner != SHIPPED}
        made = (c.kind for c in (self.condition, *self.readings) if c.certificate.method != "catalog-instance")
        return tuple(dict.fromkeys((*(s.rule for s in self.derivation), *(kind for kind in made if kind in brought))))

    @property
    def claimed(self) -> tuple[str, ...]:
        """Where sentences of the condition and the readings come from that are not gcrules' own."""
        return tuple(dict.fromkeys(c.statement_source for c in (self.condition, *self.readings) if c.statement_source))

    def unfolded(self) -> Derivation:
        """The derivation, each step with the single steps that it is made of."""
        return self.derivation.unfolded(self.strategy.rules)

    def to_json(self, *, full: bool = False) -> dict[str, Any]:
        """The interface's JSON object, schema 1; `full` gives each step of the derivation its single `steps`.
        Where legs are letters, `letters` says what points they join.
        """
        names = self.structure.names
        found = {
            "schema": 1,
            "legs": [_pair(leg, line, names) for leg, line in zip(self.structure.legs, self.lines, strict=True)],
            "lines": list(self.structure.words),
            "rank": self.structure.rank,
            "ideal": list(self.structure.ideal),
            "given": [str(a) for a in self.structure.given],
            "assumed": [e for e, _ in self.assumed],
            "class": self.match.entry.id if self.match else None,
            "mapping": dict(self.match.mapping) if self.match else None,
            "points": list(names),
            "base": list(self.structure.base),
            "platform": list(self.structure.platform),
            "superbracket": self.typed.to_json(),
            "shortest": self.shortest.to_json(),
            "entities": [e.to_json() for e in self.entities],
            "group": self.group,
            "condition": self.condition.to_json(names),
            "readings": [r.to_json(names) for r in self.readings],
            "certificate": self.condition.certificate.to_json(),
            "derivation": (self.unfolded() if full else self.derivation).to_json(names),
            "strategy": self.strategy.to_json(),
            "pose": self.pose.to_json() if self.pose else None,
            "dimensions": self.dimensions.to_json(names) if self.dimensions else None,
            "notes": list(self.notes),
        }
        return in_plain_letters(found, names_in(self.structure))

    def __repr__(self) -> str:
        name = self.match.entry.id if self.match else "no class"
        return f"<Analysis {name}: {self.condition.kind}, {self.condition.expression}>"


def analyze(
    legs: str | Iterable[str | Sequence[str]] | Structure,
    *,
    order: str | Sequence[int | str] | None = None,
    points: Names = (),
    ideal: Names = (),
    given: str | Iterable[str] = (),
    letters: str = "",
    rank: int = 4,
    catalogs: Iterable[Own] = (),
    recheck: bool = False,
    strategy: Strategy | None = None,
    search: float = SECONDS,
    plugins: Iterable[str | PathLike[str]] = (),
) -> Analysis:
    """Analyse six legs: when is the platform singular, and why.

    `legs` is text ("ab af cb cd ed ef") or pairs of names, a leg written with one body's joint first throughout. A line
    that is no pair of joints is built from points: "abc /\\ def". `order` keeps the user's own order of legs instead of
    the shortest one; `points` declares long names, `ideal` the points at infinity, `given` what is assumed of points
    (as `gcrules.prove` takes it), `letters` which stand for lines or planes
    ("line L M"), and `rank` another space, in which there are n (n − 1) / 2 lines.

    `catalogs` adds files of the user's own, `plugins` folders whose rules and catalogs take part; `strategy` says which
    rules run, then those of `plugins` too where it names them. With `recheck` readings that are instances of catalog
    identities are proved from scratch. Where no rule finds a condition, a factorization is sought for `search` seconds.
    Raises InputError for the wrong number of lines, for what is no line, and for assumptions that are not
    resolved.
    """
    if isinstance(legs, Structure):
        if points or ideal or given or letters or rank not in (4, legs.rank):
            raise InputError("a structure has its own points, letters, assumptions and rank")
        structure = legs
    else:
        structure = read_legs(legs, points=points, ideal=ideal, given=given, letters=letters, rank=rank, built=True)
    folders = tuple(plugins)
    strategy = strategy or load_rules(folders=folders, identities=bool(folders)).strategy()
    catalog = load(catalogs, (r.id for r in strategy.incidences), packs(folders, "catalogs"))
    typed = forms.typed_form(structure)
    chosen = _chosen(order, structure, strategy)
    matches = [] if structure.stand_ins else list(catalog.matches(structure))
    match = matches[0] if matches else None
    zero = always_zero(structure, typed)
    if zero is not None:
        why = explain(structure)
        condition = Condition(
            kind="always-singular",
            expression=ex.ZERO,
            meaning=say(catalog.statements["always-singular"], reason=why.reason),
            statement_source=catalog.statement_sources.get("always-singular", ""),
            certificate=zero,
            entities=starred([("line", tuple(map(str, why.line.children)))]) if isinstance(why.line, ex.Join) else (),
            lines=(("", why.line),) if isinstance(why.line, Meet) else (),
        )
        shortest = forms.shortest(structure, strategy)[0]
        derivation = derived_zero(structure, typed, shortest)
        return Analysis(
            structure, typed, shortest, match, condition, (), derivation, strategy, degeneracy=why, notes=_seed_note()
        )
    found = read(structure, matches, catalog, strategy, chosen=chosen, recheck=recheck, search=search)
    alone = all(c.kind == FIVE_LEG_SCREW for c in found.conditions)
    known = (*found.conditions, linear_complex(structure, catalog, alone=alone))
    conditions = tuple(sorted(known, key=lambda c: c.kind == FIVE_LEG_SCREW))
    derivation = _derivation(found, structure, conditions[0], chosen)
    sign = 1 if structure.rank != 4 else structure.sign
    shown = SuperbracketForm(found.form.form, found.form.order, found.form.polynomial * sign)
    if not derivation.check():
        for rule, _ in found.claim.state.trail if found.claim is not None else ():
            if rule.foreign:
                raise PluginFault(f"{rule.blame}a step of the rule {rule.id} is not an identity", filename=rule.owner)
        raise EngineFault(f"the derivation of {structure.superbracket} does not replay")
    claim = found.claim
    if claim is not None:  # what the rules did stands in the derivation
        claim = replace(claim, state=replace(claim.state, trail=()))
    return Analysis(
        structure,
        typed,
        shown,
        match,
        conditions[0],
        conditions[1:],
        derivation,
        strategy,
        claim,
        notes=(*found.notes, *_seed_note()),
    )


def _seed_note() -> tuple[str, ...]:
    """What an analysis has to say of points that could be foreseen; nothing as a rule."""
    return (f"checks at random points:{remark()}",) if remark() else ()


def _chosen(
    order: str | Sequence[int | str] | None, structure: Structure, strategy: Strategy
) -> tuple[int, ...] | None:
    """The order of the legs that the user wants; None for the shortest one."""
    if structure.rank != 4:
        if order is not None:
            raise InputError("an order of the legs makes a difference for six legs in space only")
        return None
    chosen = None if order is None else read_order(order, structure)
    return tuple(range(6)) if chosen is None and SHORTEST not in strategy.ids else chosen


def _derivation(
    found: Readings, structure: Structure, condition: Condition, chosen: tuple[int, ...] | None
) -> Derivation:
    own_order = chosen is not None and found.form.order == chosen
    return derived(structure, found.form, condition, found.claim, found.oracle, own_order=own_order)


def _pair(leg: tuple[str, str], line: Expr, names: tuple[str, ...]) -> list[str] | None:
    """The two joints of a leg, the two planes of a line built as their meet; None for any other line."""
    if ex.points_of(line) == leg:
        return list(leg)
    if isinstance(line, Meet) and len(line.args) == 2:
        return [text(e, names=names) for e in line.args]
    return None
