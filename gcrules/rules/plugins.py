r"""What a plugin imports: the value it makes, the kinds of rules, the state they look at, and the operations.

And all rules together: those of the engine, of plugins, and of files of the user's own.
"""

from __future__ import annotations

import copyreg
from collections.abc import Iterable
from os import PathLike
from typing import Any

from gcrules.algebra.expr import Expr, Point, add, join, meet, mul, sub
from gcrules.algebra.scalars import bracket
from gcrules.rules.entities import LEFT_OVER_LINE, LEFT_OVER_LINES, LEFT_OVER_PLANE, LINES, PLANES, TETRAHEDRA
from gcrules.rules.identity import Identity
from gcrules.rules.library import ENGINE, Library
from gcrules.rules.plugin import Plugin, packs, shipped
from gcrules.rules.recognition_state import RecognitionState, extensor
from gcrules.rules.rule import ConditionRule, Elementary, EntityRule, Rule
from gcrules.rules.statement import Statement, listing, say

__all__ = [
    "LEFT_OVER_LINE",
    "LEFT_OVER_LINES",
    "LEFT_OVER_PLANE",
    "LINES",
    "PLANES",
    "TETRAHEDRA",
    "ConditionRule",
    "EntityRule",
    "Expr",
    "Identity",
    "Plugin",
    "RecognitionState",
    "Rule",
    "Statement",
    "add",
    "bracket",
    "extensor",
    "join",
    "listing",
    "load_rules",
    "meet",
    "mul",
    "points",
    "say",
    "sub",
]


def points(names: Iterable[str]) -> list[Expr]:
    """Points by name."""
    return [Point(n) for n in names]


def load_rules(
    files: Iterable[str | PathLike[str]] = (), folders: Iterable[str | PathLike[str]] = (), *, identities: bool = True
) -> Library:
    """All rules that are known: those of the engine, then plugins, then files of the user's own.

    Identities of plugins are read only with `identities`; those of shipped plugins are proved by `gcrules rules check`,
    all others when they are loaded. Raises InputError where a rule is wrong or ids clash (both owners are named),
    FileError where a plugin is broken.
    """
    found = packs(folders)
    library = ENGINE.plus(r for p in found for r in p.rules)
    if identities:
        library = library.plus(i for p in found for i in p.identities(proved=p not in shipped()))
    return library.plus(Plugin(rule_files=tuple(files)).identities())


# --- copies --------------------------------------------------------------------------------------------------------


def _known(rule_id: str) -> Rule:
    return load_rules(identities=False)[rule_id]


def _by_name(rule: Rule) -> Any:
    """Rules hold functions, which may have no name; those that every process knows are pickled and copied by id."""
    if any(rule.id == known.id and rule == known for known in load_rules(identities=False)):
        return _known, (rule.id,)
    return object.__reduce_ex__(rule, 4)


for _kind in (Elementary, EntityRule, ConditionRule):
    copyreg.pickle(_kind, _by_name)
