"""The plugins that the studio was started with and those that come with gcrules: what they bring, and their checks.

No page adds one: their Python runs, and stands in folders that whoever starts the studio names.

>>> shown = plugins_view()["plugins"]
>>> [(p["name"], rule["reason"]) for p in shown for rule in p["rules"] if rule["family"] == "incidence"]
[('plugin legs-meet', '4 cases hold')]
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Literal

from gcrules.apps.studio.protocol.rule_views import PluginRule, PluginsAnswer, PluginView
from gcrules.core.budget import report
from gcrules.rules.check import CaseCheck, check_rules
from gcrules.rules.identity import Identity
from gcrules.rules.plugin import Plugin, installed, plugins_in, shipped
from gcrules.rules.rule import Rule
from gcrules.rules.rule_file import RuleCheck

__all__ = ["plugins_view"]

_Kind = Literal["shipped", "package", "folder"]


def plugins_view(folders: Sequence[str] = ()) -> PluginsAnswer:
    """Plugins with rules or catalogs, and all from outside; every rule of them is checked. Raises GcrulesError where
    one is broken.
    """
    with_robots_only = [p for p in shipped() if not (p.rules or p.rule_files or p.catalogs)]
    sorts: list[tuple[_Kind, Plugin]] = [
        *(("shipped", p) for p in shipped() if p not in with_robots_only),
        *(("package", p) for p in installed()),
        *(("folder", p) for folder in folders for p in plugins_in(Path(folder))),
    ]
    rules = {p.owner: [*p.rules, *p.identities(proved=False)] for _, p in sorts}
    checks = _checks(folders, [rule.id for brought in rules.values() for rule in brought])
    return {
        "plugins": [_view(kind, p, [_rule_view(r, checks[r.id]) for r in rules[p.owner]]) for kind, p in sorts],
        "folders": list(folders),
        "robots": len(with_robots_only),
    }


def _checks(folders: Sequence[str], ids: Sequence[str]) -> Mapping[str, CaseCheck | RuleCheck]:
    found: dict[str, CaseCheck | RuleCheck] = {}
    report("checking the rules of plugins")
    for check in check_rules(folders=folders, ids=ids) if ids else ():
        found[check.rule.id] = check
        report(f"checking the rules of plugins, {len(found)} of {len(ids)}")
    return found


def _view(kind: _Kind, plugin: Plugin, rules: list[PluginRule]) -> PluginView:
    return {
        "name": plugin.owner,
        "kind": kind,
        "rules": rules,
        "robots": [_robot(os.fspath(path)) for path in plugin.robots],
        "catalogs": [os.path.basename(path) for path in plugin.catalogs],
    }


def _robot(path: str) -> str:
    """The name of its folder, where its file is named as all are."""
    return os.path.basename(os.path.dirname(path)) if path.endswith("robot.yaml") else os.path.basename(path)


def _rule_view(rule: Rule, check: CaseCheck | RuleCheck) -> PluginRule:
    return {
        "id": rule.id,
        "family": rule.family,
        "sentence": rule.sentence,
        "text": rule.text if isinstance(rule, Identity) else "",
        "holds": check.ok,
        "reason": check.reason,
    }
