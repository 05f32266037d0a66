"""What the server tells the page of rules: those of files that the user has opened, and those of plugins."""

from __future__ import annotations

from typing import Literal, TypedDict

from gcrules.apps.studio.protocol.study_views import FaultView

__all__ = ["CheckedRule", "CheckedRuleFile", "CheckedRules", "PluginRule", "PluginView", "PluginsAnswer"]


class CheckedRule(TypedDict):
    id: str
    sentence: str
    text: str
    """As it is written."""
    line: int
    verdict: Literal["proved", "refuted", "undecided", "refused"]
    reason: str
    fault: FaultView | None
    """What is wrong with it, with its place in the file; it is not used then. Without a fault, a class that is not
    decided is used, and answers say that it is unproved.
    """


class CheckedRuleFile(TypedDict):
    name: str
    kind: Literal["rules", "catalog"]
    rules: list[CheckedRule]
    """The rules, or the classes of a catalog."""
    fault: FaultView | None
    """Where the file as a whole cannot be read."""


class CheckedRules(TypedDict):
    files: list[CheckedRuleFile]


class PluginRule(TypedDict):
    id: str
    family: str
    sentence: str
    text: str
    """An identity as it is written; "" for rules given in Python."""
    holds: bool
    reason: str
    """What was checked, or what is wrong."""


class PluginView(TypedDict):
    """A plugin with what it brings; its checks are those of `gcrules rules check`."""

    name: str
    kind: Literal["shipped", "package", "folder"]
    rules: list[PluginRule]
    robots: list[str]
    catalogs: list[str]


class PluginsAnswer(TypedDict):
    plugins: list[PluginView]
    folders: list[str]
    """Those that the studio was started with."""
    robots: int
    """How many plugins that come with gcrules bring a robot only."""
