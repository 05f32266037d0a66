r"""Files of rules that a page has opened: read, proved, and what of them is used.

>>> text = "rule pierce: ab /\\ cde => [acde] b - [bcde] a\nrule wrong: ab /\\ cde => [acde] b + [bcde] a\n"
>>> (shown,) = checked_view([{"name": "mine.gca", "text": text, "off": []}])["files"]
>>> [(r["id"], r["verdict"], r["fault"] and r["fault"]["place"]["line"]) for r in shown["rules"]]
[('pierce', 'proved', None), ('wrong', 'refuted', 2)]
>>> [r.id for r in usable([{"name": "mine.gca", "text": text, "off": []}])]
['pierce']
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Literal, cast

from gcrules.algebra.language.rule_text import RuleText
from gcrules.algebra.language.statements import Script, parse_script
from gcrules.apps.studio.catalog_files import catalog_view, catalogs_read, is_catalog
from gcrules.apps.studio.faults import fault_view
from gcrules.apps.studio.protocol.answer_views import RuleOwner
from gcrules.apps.studio.protocol.requests import RuleFile
from gcrules.apps.studio.protocol.rule_views import CheckedRule, CheckedRuleFile, CheckedRules
from gcrules.core.budget import checkpoint, stage, within
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import GcrulesError, InputError, LimitReached
from gcrules.core.seeds import remembered
from gcrules.rules.identity import Identity
from gcrules.rules.plugins import load_rules
from gcrules.rules.rule_file import RuleCheck, check_rule, identities

__all__ = ["RuleFileRead", "all_read", "checked_view", "owners", "usable"]

_SECONDS = 20.0
"""For one rule: what takes longer is not decided here."""


@dataclass(frozen=True)
class RuleFileRead:
    """A file with the checks of its rules, or the fault that keeps it from being read."""

    script: Script | None
    checks: tuple[RuleCheck, ...] = ()
    fault: GcrulesError | None = None


def checked_view(files: Sequence[RuleFile]) -> CheckedRules:
    """What each file holds, and what is wrong with it. A rule whose id is taken is one that is wrong."""
    rules, catalogs = _of_rules(files), [file for file in files if is_catalog(file)]
    views = [_view(file, read) for file, read in zip(rules, all_read(rules), strict=True)]
    classes = [catalog_view(file, read) for file, read in zip(catalogs, catalogs_read(catalogs), strict=True)]
    return {"files": [(classes if is_catalog(file) else views).pop(0) for file in files]}


def _of_rules(files: Sequence[RuleFile]) -> list[RuleFile]:
    return [file for file in files if not is_catalog(file)]


def usable(files: Sequence[RuleFile]) -> tuple[Identity, ...]:
    """The rules that are proved and not switched off, in the order of the files."""
    files = _of_rules(files)
    return tuple(
        check.rule
        for file, read in zip(files, all_read(files), strict=True)
        for check in read.checks
        if check.ok and check.rule.id not in file["off"]
    )


def owners(files: Sequence[RuleFile]) -> Mapping[str, RuleOwner]:
    """By its id, who brought each rule that is proved and not switched off; of a class of a catalog by what analyses
    call it.
    """
    catalogs = [file for file in files if is_catalog(file)]
    classes: dict[str, RuleOwner] = {
        check.claim: {"kind": "file", "name": file["name"], "line": check.line}
        for file, read in zip(catalogs, catalogs_read(catalogs), strict=True)
        for check in read.checks
        if check.used and check.entry.id not in file["off"]
    }
    files = _of_rules(files)
    return classes | {
        check.rule.id: {"kind": "file", "name": file["name"], "line": line_of[check.rule.id]}
        for file, read in zip(files, all_read(files), strict=True)
        for line_of in [_lines(read)]
        for check in read.checks
        if check.ok and check.rule.id not in file["off"]
    }


def _lines(read: RuleFileRead) -> Mapping[str, int]:
    return {r.id: r.line for r in read.script.rules} if read.script else {}


def all_read(files: Sequence[RuleFile]) -> list[RuleFileRead]:
    """The files one after the other; ids that one before has taken, or a rule of gcrules, are faults."""
    known = {rule.id: rule.owner for rule in load_rules()}
    found = []
    for file in files:
        with stage(f"rules of {file['name']}"):
            read = _read(file["name"], file["text"])
        checks = tuple(_clashing(check, known, read.script) for check in read.checks)
        known |= {c.rule.id: c.rule.owner for c in checks if c.ok and c.rule.id not in file["off"]}
        found.append(RuleFileRead(read.script, checks, read.fault))
    return found


def _clashing(check: RuleCheck, known: Mapping[str, str], script: Script | None) -> RuleCheck:
    rule = check.rule
    if not check.ok or rule.id not in known or script is None:
        return check
    span = next(r.span for r in script.rules if r.id == rule.id)
    words = f"two rules are called {rule.id}: one of {known[rule.id]}, one of {rule.owner}"
    fault = InputError(words, hint="rename one of them, or load only one").located(script.source, script.filename, span)
    return RuleCheck(rule, check.place, "refused", check.ranks, fault)


def _is_decided(read: RuleFileRead) -> bool:
    return all(check.verdict != "undecided" for check in read.checks)


@remembered(32, keep=_is_decided)
def _read(name: str, text: str) -> RuleFileRead:
    """The file with its checks."""
    try:
        script = parse_script(text, name)
    except GcrulesError as fault:
        return RuleFileRead(None, fault=fault)
    if not script.rules:
        hint = 'rules are written  rule ID "sentence": A => B'
        return RuleFileRead(script, fault=InputError("the file holds no rules", hint=hint))
    return RuleFileRead(script, tuple(_checks(script)))


def _checks(script: Script) -> Iterator[RuleCheck]:
    for number, rule in enumerate(script.rules, 1):
        with stage(f"{number} of {len(script.rules)}, {rule.id}"):
            yield _check(rule, script)


def _check(rule: RuleText, script: Script) -> RuleCheck:
    try:
        with within(_SECONDS):
            return check_rule(rule, script, recheck=False)
    except LimitReached as limited:
        checkpoint()  # it may be that of all together
        alone = next(i for i in identities(script) if i.id == rule.id)
        words = f"the rule {rule.id} is not decided: {limited.message}"
        fault = LimitReached(words).located(script.source, script.filename, rule.span)
        return RuleCheck(alone, alone.owner, "undecided", (), fault)


# --- as the page is told -------------------------------------------------------------------------------------------


def _view(file: RuleFile, read: RuleFileRead) -> CheckedRuleFile:
    lines = _lines(read)
    return {
        "name": file["name"],
        "kind": "rules",
        "rules": [_rule_view(check, lines[check.rule.id]) for check in read.checks],
        "fault": fault_view(read.fault) if read.fault else None,
    }


def _rule_view(check: RuleCheck, line: int) -> CheckedRule:
    return {
        "id": check.rule.id,
        "sentence": check.rule.sentence,
        "text": check.rule.text,
        "line": line,
        "verdict": cast("Literal['proved', 'refuted', 'undecided', 'refused']", check.verdict),
        "reason": check.reason,
        "fault": fault_view(check.fault) if check.fault else None,
    }
