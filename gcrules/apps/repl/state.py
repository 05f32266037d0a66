"""What a session has come to: frozen values, so that every input leads from one to the next."""

from __future__ import annotations

from dataclasses import replace
from math import inf
from typing import Any

from gcrules.algebra.expand import MAX_TERMS
from gcrules.algebra.expr import Expr
from gcrules.algebra.language.syntax import Context
from gcrules.core.dataclass import dataclass
from gcrules.rules.catalog.catalog import Catalog
from gcrules.rules.rule import RewriteRule

__all__ = ["PromptState", "Settings"]

MAX_RESULTS = 9
_NOTHING = Context()


@dataclass(frozen=True, slots=True)
class PromptState:
    """`statements` are those that were accepted, as text; `results` the last ones, the newest first.

    `ranked` tells whether the rank was stated, in which all rules stand then.
    """

    context: Context = _NOTHING
    rules: tuple[RewriteRule, ...] = ()
    statements: tuple[str, ...] = ()
    ranked: bool = False
    results: tuple[Expr, ...] = ()

    @property
    def settled(self) -> tuple[Any, ...]:
        """All but the results."""
        return self.context, self.rules, self.statements, self.ranked

    def with_result(self, e: Expr) -> PromptState:
        """The state with one more result, the oldest one forgotten where there are too many."""
        return replace(self, results=(e, *self.results)[:MAX_RESULTS])

    def script(self) -> str:
        """The statements as the text of a script."""
        return "".join(f"{s}\n" for s in self.statements)


@dataclass(frozen=True, slots=True)
class Settings:
    """How answers are shown, the number of terms beyond which none is sought, and the seconds and gigabytes that an
    input may take; those that a command may take where None.

    `short` writes many equal brackets as a power. Without `files` none is read or written. An analysis takes in the
    rules of `plugins`, folders of the user's, and the classes of `catalogs`, files or what was read from them.
    """

    unicode: bool = True
    latex: bool = False
    limit: int = MAX_TERMS
    seconds: float = inf
    gigabytes: float | None = None
    short: bool = False
    files: bool = True
    plugins: tuple[str, ...] = ()
    catalogs: tuple[str | Catalog, ...] = ()
