r"""Checking rules: identities are proved, and every rule is tried on the cases where it fires and where it does not."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from os import PathLike, fspath
from typing import Any

from gcrules.algebra.shortest import shortest_forms
from gcrules.algebra.space import Space
from gcrules.algebra.statements import parse_script
from gcrules.algebra.syntax import parse
from gcrules.errors import FileError, GcrulesError, InputError
from gcrules.legs import read_legs
from gcrules.plugins import load_rules, packs
from gcrules.rules.entities import TETRAHEDRA
from gcrules.rules.library import ENGINE, Library
from gcrules.rules.oracle import Oracle
from gcrules.rules.rule import SHIPPED, EntityRule, Incidence, RewriteRule, Rule
from gcrules.rules.rule_file import RuleCheck, check_script
from gcrules.rules.strategy import Strategy, recognise
from gcrules.yamlfile import read_text

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
    files: Iterable[str | PathLike[str]] = (), folders: Iterable[str | PathLike[str]] = ()
) -> Iterator[RuleCheck | CaseCheck]:
    """The rules of the files; without files all rules that are known, those of the folders among them.

    Raises FileError where a file holds no rules or a plugin is broken, InputError where a file cannot be read as rules
    or ids clash; what is wrong with a rule stands in its check.
    """
    paths = [fspath(f) for f in files]
    if not paths:
        found = packs(folders)
        library = ENGINE.plus(r for p in found for r in p.rules)
        yield from (check_cases(rule, library) for rule in library)
        paths = [fspath(f) for p in found for f in p.files]
    for path in paths:
        script = parse_script(read_text(path), path)
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
            return CaseCheck(rule, len(cases), InputError(f"the rule {rule.id} {what} {case}", filename=rule.owner))
    if not rule.fires:
        return CaseCheck(rule, 0, InputError(f"the rule {rule.id} has no case where it fires", filename=rule.owner))
    return CaseCheck(rule, len(cases))


def fires_on(rule: Rule, case: str, library: Library | None = None) -> bool:
    """Whether a rule fires: a rewriting rule on an expression, a rule of recognition on six legs.

    An entity rule fires where it has a part in the first claim of the library's strategy; one that a plugin brought,
    where it has a part in the first claim of the incidence rules that use it, as those of the engine run before them.
    """
    if isinstance(rule, RewriteRule):
        return rule.rewrite(parse(case), Space()) is not None
    structure = read_legs(case)
    oracle = Oracle(structure)
    forms = shortest_forms(structure.neutral, points=structure.points, ideal=structure.ideal)
    if isinstance(rule, Incidence):
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
