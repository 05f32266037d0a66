"""What the stages of an analysis are made of: sentences, short values with a key, displayed formulas."""

from __future__ import annotations

from gcrules.algebra.expr import Expr
from gcrules.core.dataclass import dataclass

__all__ = ["Formula", "Item", "KeyValue"]


@dataclass(frozen=True)
class Formula:
    """left = right, displayed; `left` may be None."""

    left: Expr | None
    right: Expr


@dataclass(frozen=True)
class KeyValue:
    """A short key and its value."""

    key: str
    value: str


Item = str | KeyValue | Formula
