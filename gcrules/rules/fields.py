"""What the fields of rules hold, and what their functions give: asked of every rule, for plugins bring rules too."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from itertools import islice
from typing import Any

from gcrules.algebra.expr import Expr, Power
from gcrules.rules.condition import Condition
from gcrules.rules.foreign import Misfit
from gcrules.rules.recognition_state import RecognitionState
from gcrules.rules.statement import Statement, say

__all__ = ["FIELDS", "MAX_WEIGHT", "RESULTS", "expression_or_none", "is_text"]

MAX_WEIGHT = 20_000
"""Points that an expression of a plugin may have when its powers are written out."""

_MOST = 10_000  # states, conditions or characters that one call may give


# --- what functions give -------------------------------------------------------------------------------------------


def _expression(value: Any) -> Expr:
    if not isinstance(value, Expr):
        raise Misfit(f"it gives {value!r:.100}, expected an expression")
    if _weight(value, {}) > MAX_WEIGHT:
        raise Misfit(f"it gives an expression of more than {MAX_WEIGHT:,} points")
    return value


def _weight(e: Expr, known: dict[int, int]) -> int:
    """The number of points of an expression, powers and parts that are shared written out."""
    if id(e) not in known:
        whole = sum(_weight(c, known) for c in e.children) or 1
        known[id(e)] = whole * e.exponent if isinstance(e, Power) else whole
    return known[id(e)]


def expression_or_none(value: Any) -> Expr | None:
    return None if value is None else _expression(value)


def _pair(value: Any) -> tuple[Expr, Expr]:
    if not isinstance(value, tuple) or len(value) != 2:
        raise Misfit(f"it gives {value!r:.100}, expected two lines")
    return _expression(value[0]), _expression(value[1])


def _text(value: Any) -> str:
    if not isinstance(value, str):
        raise Misfit(f"it gives {value!r:.100}, expected a text")
    if len(value) > _MOST:
        raise Misfit(f"it gives a text of {len(value):,} characters, more than {_MOST:,}")
    return value


def _statement(value: Any) -> Statement:
    if isinstance(value, Statement):
        _text(str(value))
        return value
    return say("{}", _text(value))


def _all(kind: type, values: Any) -> list[Any]:
    found = list(islice(values, _MOST + 1))
    if len(found) > _MOST:
        raise Misfit(f"it gives more than {_MOST:,} values")
    for value in found:
        if not isinstance(value, kind):
            raise Misfit(f"it gives {value!r:.100}, expected each a {kind.__name__}")
    return found


def _states(values: Any) -> Iterator[RecognitionState]:
    return iter(_all(RecognitionState, values))


def _conditions(values: Any) -> list[Condition]:
    return _all(Condition, values)


RESULTS: Mapping[tuple[str, str], Callable[[Any], Any]] = {
    ("rewriting", "apply"): expression_or_none,
    ("entities", "find"): _states,
    ("entities", "after"): expression_or_none,
    ("entities", "why"): _text,
    ("incidence", "expression"): expression_or_none,
    ("incidence", "cofactor"): _expression,
    ("incidence", "pencils"): _pair,
    ("incidence", "statement"): _statement,
    ("structure", "find"): _conditions,
}
"""The functions of each family of rules, and what becomes of their results where a plugin brought them."""


# --- what fields hold ----------------------------------------------------------------------------------------------


def is_text(value: Any) -> bool:
    return isinstance(value, str) and len(value) <= _MOST


def _are_texts(value: Any) -> bool:
    return isinstance(value, tuple) and all(map(is_text, value))


def _are_uses(value: Any) -> bool:
    return isinstance(value, tuple) and all(
        isinstance(u, tuple) and len(u) == 2 and hasattr(u[0], "applied") and isinstance(u[1], int) for u in value
    )


FIELDS: Mapping[str, tuple[Callable[[Any], bool], str]] = {
    "sentence": (is_text, "a text"),
    "source": (is_text, "a text"),
    "owner": (is_text, "a text"),
    "fires": (_are_texts, "a tuple of texts"),
    "silent": (_are_texts, "a tuple of texts"),
    "group": (lambda v: v is None or is_text(v), "a letter or None"),
    "degree": (lambda v: v is None or isinstance(v, int), "a number or None"),
    "uses": (_are_uses, "a tuple of pairs (entity rule, number)"),
    "statement": (lambda v: is_text(v) or callable(v), "a text or a function"),
    "pencils": (lambda v: v is None or callable(v), "a function or None"),
    **dict.fromkeys(("apply", "find", "after", "why", "expression", "cofactor"), (callable, "a function")),
}
"""What the fields of rules hold; those of them that a kind of rule has."""
