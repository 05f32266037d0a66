"""What the guide shows of dataclasses that `gcrules.core.dataclass` makes: the parameters of all dataclasses."""

from __future__ import annotations

import ast
from typing import Any

import griffe

__all__ = ["Dataclasses"]


class Dataclasses(griffe.Extension):
    """Griffe knows dataclasses by the name of their decorator; ours is the standard library's to all who only read."""

    def on_alias_instance(
        self, *, node: ast.AST | griffe.ObjectNode, alias: griffe.Alias, agent: Any, **kwargs: Any
    ) -> None:
        if alias.target_path == "gcrules.core.dataclass.dataclass":
            alias.target_path = "dataclasses.dataclass"
