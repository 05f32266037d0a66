r"""Checking rules: identities are proved, and every rule is tried on the cases where it fires and where it does not."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from os import PathLike, fspath
from pathlib import Path
from typing import Any

from gcrules.algebra.evaluate import evaluate, random_rational_points
from gcrules.algebra.expr import mul
from gcrules.algebra.language.legs_text import read_legs
from gcrules.algebra.language.statements import parse_script
from gcrules.algebra.language.syntax import parse
from gcrules.algebra.space import Space
from gcrules.algebra.superbrackets.shortest import shortest_forms
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import FileError, GcrulesError, InputError
from gcrules.core.yaml_file import read_text
from gcrules.rules.entities import TETRAHEDRA
from gcrules.rules.foreign import place_of
from gcrules.rules.library import ENGINE, Library
from gcrules.rules.plugin import packs
from gcrules.rules.plugins import load_rules
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.recognition_state import RecognitionState
from gcrules.rules.rule import SHIPPED, ConditionRule, EntityRule, RewriteRule, Rule, StructureRule
from gcrules.rules.rule_file import RuleCheck, check_rule, check_script, identities
from gcrules.rules.strategy import Strategy, recognise

__all__ = ["CaseCheck", "check_cases", "check_rules", "fires_on"]


@dataclass(frozen=True)
class CaseCheck:
    """A rule given in Python, tried on its cases: `cases` is their number, `fault` names the one that fails."""

    rule: Rule
    cases: int
    fault: GcrulesError | None = None
    verdict: str = "proved"

    @property
    def ok(self) -> bool:
        return self.fault is None

    @property
    def reason(self) -> str:
        if self.fault is not None:
            return self.fault.message
        return "1 case holds" if self.cases == 1 else f"{self.cases} cases hold"

    def to_json(self) -> dict[str, Any]:
        return {
            "id": self.rule.id,
            "place": self.rule.owner,
            "verdict": "holds" if self.ok else "wrong",
            "cases": self.cases,
            "fault": self.fault.message if self.fault else None,
        }


def check_rules(
    files: Iterable[str | PathLike[str]] = (), folders: Iterable[str | PathLike[str]] = (), ids: Iterable[str] = ()
) -> Iterator[RuleCheck | CaseCheck]:
    """The rules of the files and those named; by default all rules that are known, those of the folders among them.

    Raises FileError where a file holds no rules or a plugin is broken, InputError where a file cannot be read as rules,
    ids clash or a rule is not there; what is wrong with a rule stands in its check.
    """
    paths, found, named = [fspath(f) for f in files], packs(folders), set(ids)
    everything = not paths and not named
    library = ENGINE.plus(r for p in found for r in p.rules)
    known = library.plus(i for p in found for i in p.identities(proved=False))
    for one in sorted(named):
        known[one]  # raises where it is not there
    yield from (check_cases(rule, library) for rule in library if everything or rule.id in named)
    brought = [fspath(f) for p in found for f in p.rule_files]
    for path in brought if everything or named else ():
        script = parse_script(read_text(path), path)
        yield from (check_rule(rule, script) for rule in script.rules if everything or rule.id in named)
    own = {Path(f).resolve() for f in brought}
    for path in paths:
        script = parse_script(read_text(path), path)
        if Path(path).resolve() not in own:
            known = known.plus(identities(script))  # raises where an id is taken
        if not script.rules:
            raise FileError("the file holds no rules", filename=path)
        yield from check_script(script)


def check_cases(rule: Rule, library: Library | None = None) -> CaseCheck:
    """Whether a rule fires on the cases where it should, and stays silent where it should, among the rules of a library
    (all that are known by default).
    """
    cases = [*((c, True) for c in rule.fires), *((c, False) for c in rule.silent)]
    for case, expected in cases:
        if fires_on(rule, case, library) != expected:
            what = "stays silent on" if expected else "fires on"
            refuted = _refuted_claim(rule, case) if expected and isinstance(rule, ConditionRule) else ""
            place = place_of(getattr(rule, "expression", None), rule.owner)
            fault = InputError(f"the rule {rule.id} {what} {case}{refuted}", filename=place)
            return CaseCheck(rule, len(cases), fault)
    if not rule.fires:
        return CaseCheck(rule, 0, InputError(f"the rule {rule.id} has no case where it fires", filename=rule.owner))
    return CaseCheck(rule, len(cases))


def _refuted_claim(rule: ConditionRule, case: str) -> str:
    """The first claim that a rule makes on six legs and that is wrong, with exact points that refute it."""
    structure = read_legs(case)
    forms = shortest_forms(structure.neutral, points=structure.points, ideal=structure.ideal)
    states = [s for form in forms for s in TETRAHEDRA.applied(RecognitionState.start(form, structure))]
    for state in (reached for s in states for reached in rule.reached(s)):
        e = rule.expression(state)
        if e is None or e.step:
            continue
        ratios: dict[Fraction | None, str] = {}
        for seed in range(60):
            points = random_rational_points(structure.names, ideal=structure.ideal, seed=seed, size=2)
            left = evaluate(mul(rule.cofactor(state), structure.superbracket), points)
            right = evaluate(e, points)
            if left or right:
                shown = "; ".join(f"{n} = ({', '.join(map(str, c))})" for n, c in points.items())
                ratios[Fraction(left, right) if right else None] = f"at {shown} the sides are {left} and {right}"
            if len(ratios) > 1:
                one, other = list(ratios.values())[:2]
                return f": its claim that the superbracket is a multiple of {e} is wrong: {one}, but {other}"
    return ""


def fires_on(rule: Rule, case: str, library: Library | None = None) -> bool:
    """Whether a rule fires: a rewriting rule on an expression, a rule of recognition on six legs.

    An entity rule fires where it has a part in the first claim of the library's strategy; one that a plugin brought,
    where it has a part in the first claim of the incidence rules that use it, as those of the engine run before them.
    """
    if isinstance(rule, RewriteRule):
        return rule.rewrite(parse(case), Space()) is not None
    legs, _, ideal = case.partition(" ideal ")
    structure = read_legs(legs, ideal=ideal)
    oracle = RandomWitness(structure)
    if isinstance(rule, StructureRule):
        return bool(rule.find(structure, oracle))
    forms = shortest_forms(structure.neutral, points=structure.points, ideal=structure.ideal)
    if isinstance(rule, ConditionRule):
        alone = Strategy((TETRAHEDRA, *(used for used, _ in rule.uses), rule))
        return bool(recognise(forms, structure, oracle, alone))
    assert isinstance(rule, EntityRule)
    strategy = (library or load_rules(identities=False)).strategy()
    if rule.owner != SHIPPED:
        others = {r.id for r in strategy.incidences if rule.id not in {used.id for used, _ in r.uses}}
        strategy = strategy.without(others)
    trails = (claim.state.trail for claim in recognise(forms, structure, oracle, strategy))
    return any(
        step.id == rule.id and (rule is not TETRAHEDRA or bool(state.tetrahedra)) for t in trails for step, state in t
    )
