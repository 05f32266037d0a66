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
from dataclasses import dataclass, replace
from os import PathLike
from typing import Any

from gcrules.algebra import expr as ex
from gcrules.algebra.shortest import SuperbracketForm, shortest_forms, superbracket_form
from gcrules.algebra.straighten import straighten
from gcrules.algebra.text import SHORT_NAME, Names, split_names
from gcrules.catalog import Catalog, Match
from gcrules.catalog_file import load
from gcrules.condition import Certificate, Condition, Entity, starred
from gcrules.errors import EngineFault, InputError
from gcrules.legs import Structure, read_legs, read_order
from gcrules.numeric.value import PoseValue, pose_value
from gcrules.plugins import load_rules
from gcrules.robots.geometry import Platform
from gcrules.rules.conditions import best_first, certify, describe
from gcrules.rules.degenerate import Degeneracy, explain
from gcrules.rules.derivation import Derivation
from gcrules.rules.deriving import derived, derived_zero
from gcrules.rules.incidence import Claim
from gcrules.rules.oracle import Oracle
from gcrules.rules.strategy import CATALOG, MAX_TERMS, SHORTEST, Strategy, of_plugins, recognise

__all__ = ["Analysis", "analyze"]

_MOST_READINGS = 3  # of the kind of the condition itself


@dataclass(frozen=True)
class Analysis:
    """All stages of the analysis of six legs, as frozen values.

    `typed` is the superbracket of the legs in the order given, `shortest` its shortest form; `match` the class of the
    catalog; `condition` the reading with the smallest cofactor and `readings` the others, each of them an identity
    cofactor · superbracket = coefficient · expression; `derivation` the steps that lead to the condition. If the legs
    came with coordinates, `platform` holds them and `pose` the numbers there. `strategy` holds the rules that were run.
    """

    structure: Structure
    typed: SuperbracketForm
    shortest: SuperbracketForm
    match: Match | None
    condition: Condition
    readings: tuple[Condition, ...]
    derivation: Derivation
    strategy: Strategy
    claim: Claim | None = None
    degeneracy: Degeneracy | None = None
    notes: tuple[str, ...] = ()
    platform: Platform | None = None
    pose: PoseValue | None = None

    @property
    def entities(self) -> tuple[Entity, ...]:
        return self.condition.entities

    @property
    def group(self) -> str | None:
        """The published group of entities, a … g; None where the procedure does not reach."""
        return self.condition.group

    def unfolded(self) -> Derivation:
        """The derivation, each step with the single steps that it is made of."""
        return self.derivation.unfolded(self.strategy.rules)

    def to_json(self, *, full: bool = False) -> dict[str, Any]:
        """The interface's JSON object, schema 1; `full` gives each step of the derivation its single `steps`."""
        names = self.structure.names
        return {
            "schema": 1,
            "legs": [list(leg) for leg in self.structure.legs],
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
            "notes": list(self.notes),
        }

    def text(self, *, unicode: bool = False, full: bool = False) -> str:
        """Every stage as plain text; `full` adds every single step of the derivation, here as in the other forms."""
        from gcrules.render.plain import as_text

        return as_text(self, unicode=unicode, full=full)

    def latex(self, *, full: bool = False) -> str:
        """Every stage as a LaTeX document that compiles with the article class and amsmath."""
        from gcrules.render.latex_document import as_latex

        return as_latex(self, full=full)

    def __str__(self) -> str:
        return self.text(unicode=True)

    def __repr__(self) -> str:
        name = self.match.entry.id if self.match else "no class"
        return f"<Analysis {name}: {self.condition.kind}, {self.condition.expression}>"

    def _repr_html_(self) -> str:
        from gcrules.render.report import fragment

        return fragment(self)

    def _repr_latex_(self) -> str:
        return self.condition.expression._repr_latex_()


def analyze(
    legs: str | Iterable[str | Sequence[str]] | Structure | Platform,
    *,
    order: str | Sequence[int | str] | None = None,
    points: Names = (),
    ideal: Names = (),
    catalogs: Iterable[str | PathLike[str]] = (),
    recheck: bool = False,
    strategy: Strategy | None = None,
) -> Analysis:
    """Analyse six legs: when is the platform singular, and why.

    `legs` is text ("ab af cb cd ed ef") or pairs of names, a leg written with one body's joint first throughout, or a
    platform with coordinates (`load_platform`), for which the numbers in its pose are given too;
    `order` keeps the user's own order of legs instead of the shortest one; `points` declares long names, `ideal` the
    points at infinity; `catalogs` adds files of the user's own; `strategy` says which rules run. With `recheck`
    readings that are instances of catalog identities are proved from scratch. Raises InputError for anything but six
    legs between different points.
    """
    if isinstance(legs, Platform):
        return _in_pose(legs, order, split_names(points), split_names(ideal), catalogs, recheck, strategy)
    structure = legs if isinstance(legs, Structure) else read_legs(legs, points=points, ideal=ideal)
    strategy = strategy or load_rules(identities=False).strategy()
    catalog = load(catalogs, (r.id for r in strategy.incidences))
    typed = superbracket_form(structure.legs, points=structure.points, ideal=structure.ideal)
    chosen = None if order is None else read_order(order, structure)
    if chosen is None and SHORTEST not in strategy.ids:
        chosen = tuple(range(6))
    forms = _shortest(structure, strategy) if chosen is None else _in_order(structure, chosen, strategy)
    matches = list(catalog.matches(structure))
    match = matches[0] if matches else None
    if not straighten(typed.polynomial):
        return _always_singular(structure, typed, match, catalog, strategy)
    notes = [f"{m.entry.id} ({m.entry.place}) has the same graph as class {matches[0].entry.id}" for m in matches[1:]]
    if structure.ideal:
        notes.append(
            "points at infinity: classes are not matched, and a turn about a line at infinity is a translation"
        )
    oracle = Oracle(structure)
    found = best_first(recognise(forms, structure, oracle, strategy), structure, oracle)
    if not found and chosen is not None and SHORTEST in strategy.ids:
        forms = _shortest(structure, strategy)
        found = best_first(recognise(forms, structure, oracle, strategy), structure, oracle)
        notes.append("the order given shows no entities; the shortest order was used instead")
    elif chosen is not None:
        notes.append("the order of the legs was given; the shortest order may show more")
    most = found[: 1 + _MOST_READINGS]
    conditions = [certify(describe(c, structure, oracle, catalog.statements), structure) for c in most]
    claim = found[0] if found else None
    shortest = claim.state.form if claim else forms[0]
    if claim is None and len(forms[0].polynomial) > MAX_TERMS:
        notes.append(f"entities were not looked for: the shortest form has more than {MAX_TERMS} terms")
    for more in of_plugins(forms, structure, oracle, strategy, claim.kind) if claim else ():
        conditions += [
            certify(describe(c, structure, oracle, catalog.statements), structure)
            for c in best_first(more, structure, oracle)[:_MOST_READINGS]
        ]
    for m in matches if CATALOG in strategy.ids else ():
        known = catalog.readings(structure, m, oracle, recheck=recheck)
        conditions += [r for r in known if not any(_alike(r, c) for c in conditions)]
    conditions.append(_linear_complex(structure, catalog))
    own_order = chosen is not None and shortest.order == chosen
    derivation = derived(structure, shortest, conditions[0], claim, oracle, own_order=own_order)
    shown = SuperbracketForm(shortest.form, shortest.order, shortest.polynomial * structure.sign)
    if not derivation.check():
        raise EngineFault(f"the derivation of {structure.superbracket} does not replay")
    if claim is not None:  # what the rules did stands in the derivation
        claim = replace(claim, state=replace(claim.state, trail=()))
    return Analysis(
        structure,
        typed,
        shown,
        match,
        conditions[0],
        tuple(conditions[1:]),
        derivation,
        strategy,
        claim,
        notes=tuple(notes),
    )


def _in_pose(
    platform: Platform,
    order: str | Sequence[int | str] | None,
    points: tuple[str, ...],
    ideal: tuple[str, ...],
    catalogs: Iterable[str | PathLike[str]],
    recheck: bool,
    strategy: Strategy | None,
) -> Analysis:
    """The analysis of a platform's legs with the numbers in its pose."""
    if ideal:
        raise InputError(f"{', '.join(ideal)} cannot lie at infinity: {platform.filename} gives finite coordinates")
    long_names = (n for n in platform.points if not SHORT_NAME.fullmatch(n))
    try:
        structure = read_legs(platform.legs, points=tuple(dict.fromkeys((*points, *long_names))))
    except InputError as fault:
        fault.filename = platform.filename
        raise
    found = analyze(structure, order=order, catalogs=catalogs, recheck=recheck, strategy=strategy)
    pose = pose_value(found.structure, found.condition, platform.homogeneous(), unit=platform.units)
    return replace(found, platform=platform, pose=pose)


def _shortest(structure: Structure, strategy: Strategy) -> tuple[SuperbracketForm, ...]:
    at = {"points": structure.points, "ideal": structure.ideal}
    return shortest_forms(structure.neutral, **at, forms=strategy.forms)


def _in_order(structure: Structure, order: tuple[int, ...], strategy: Strategy) -> tuple[SuperbracketForm, ...]:
    """Both forms in the user's own order, the shorter one first."""
    forms = (
        superbracket_form(structure.neutral, order, form, points=structure.points, ideal=structure.ideal)
        for form in strategy.forms
    )
    return tuple(sorted(forms, key=lambda f: len(f.polynomial)))


def _always_singular(
    structure: Structure,
    typed: SuperbracketForm,
    match: Match | None,
    catalog: Catalog,
    strategy: Strategy,
) -> Analysis:
    why = explain(structure)
    entities = starred([("line", tuple(str(p) for p in why.line.children))]) if isinstance(why.line, ex.Join) else ()
    condition = Condition(
        kind="always-singular",
        expression=ex.ZERO,
        statement=catalog.statements["always-singular"].format(reason=why.reason),
        certificate=Certificate("normal-form", "proved: the normal form of the superbracket is 0"),
        entities=entities,
        lines=(("", why.line),) if isinstance(why.line, ex.Meet) else (),
    )
    shortest = _shortest(structure, strategy)[0]
    derivation = derived_zero(structure, typed, shortest)
    return Analysis(structure, typed, shortest, match, condition, (), derivation, strategy, degeneracy=why)


def _alike(a: Condition, b: Condition) -> bool:
    """Whether two readings say the same in the same words."""
    return str(a.expression) == str(b.expression) and a.statement in ("", b.statement)


def _linear_complex(structure: Structure, catalog: Catalog) -> Condition:
    return Condition(
        kind="linear-complex",
        expression=structure.superbracket,
        statement=catalog.statements["linear-complex"],
        certificate=Certificate("normal-form", "holds by definition of the superbracket"),
    )
