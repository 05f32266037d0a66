"""Reading what a page sends: each argument has a shape, and what does not fit it is refused in words.

A check takes the value and where it stands ("source.id") and returns it, or raises InputError.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping
from typing import Any, NoReturn

from gcrules.core.errors import InputError

__all__ = ["Check", "choice", "decoded", "listed", "mapped", "number", "one_of", "record", "text", "tuple_of"]

Check = Callable[[Any, str], Any]

_LARGEST = 1e15


def decoded(message: str | bytes, longest: int) -> dict[str, Any]:
    """The JSON object of a message. Raises InputError for anything else."""
    if isinstance(message, bytes):
        raise InputError("messages are text, this one is binary")
    if len(message) > longest:
        raise InputError(f"the message has {len(message):,} characters, at most {longest:,} are read")
    try:
        found = json.loads(message, parse_constant=_not_finite)
    except RecursionError:
        raise InputError("the message is nested too deeply") from None
    except ValueError as fault:
        raise InputError(f"the message is not JSON: {fault}") from None
    if not isinstance(found, dict):
        raise InputError("the message is not an object")
    return found


def _not_finite(word: str) -> NoReturn:
    raise ValueError(f"{word} is not a number")


def _expected(what: str, value: Any, where: str) -> InputError:
    shown = json.dumps(value) if not isinstance(value, (dict, list)) else "a list" if isinstance(value, list) else "{…}"
    return InputError(f"{where} is {shown[:40]}, expected {what}")


def text(longest: int, *, empty: bool = False) -> Check:
    """A text of at most so many characters, without lone surrogates and null characters."""

    def check(value: Any, where: str) -> str:
        if not isinstance(value, str):
            raise _expected("a text", value, where)
        if len(value) > longest:
            raise InputError(f"{where} has {len(value):,} characters, at most {longest:,} are read")
        if not empty and not value.strip():
            raise InputError(f"{where} is empty")
        if "\0" in value or any("\ud800" <= c <= "\udfff" for c in value):
            raise InputError(f"{where} holds characters that are not text")
        return value

    return check


def number(least: float = -_LARGEST, most: float = _LARGEST, *, whole: bool = False) -> Check:
    """A finite number within bounds."""

    def check(value: Any, where: str) -> float | int:
        if isinstance(value, bool) or not isinstance(value, int if whole else (int, float)):
            raise _expected("a whole number" if whole else "a number", value, where)
        if not least <= value <= most or (isinstance(value, float) and not math.isfinite(value)):
            raise InputError(f"{where} is {value!r:.40}, expected a number from {least:g} to {most:g}")
        return value if whole else float(value)

    return check


def choice(*words: str) -> Check:
    """One of some words."""

    def check(value: Any, where: str) -> str:
        if not isinstance(value, str) or value not in words:
            raise _expected(f"one of {', '.join(words)}", value, where)
        return value

    return check


def listed(item: Check, most: int, least: int = 0) -> Check:
    """A list of things of one shape."""

    def check(value: Any, where: str) -> list[Any]:
        if not isinstance(value, list):
            raise _expected("a list", value, where)
        if not least <= len(value) <= most:
            raise InputError(f"{where} has {len(value):,} entries, expected {least} to {most:,}")
        return [item(v, f"{where}[{i}]") for i, v in enumerate(value)]

    return check


def tuple_of(*items: Check) -> Check:
    """A list of so many things, each of its shape."""

    def check(value: Any, where: str) -> list[Any]:
        if not isinstance(value, list) or len(value) != len(items):
            raise _expected(f"a list of {len(items)}", value, where)
        return [item(v, f"{where}[{i}]") for i, (item, v) in enumerate(zip(items, value, strict=True))]

    return check


def mapped(key: Check, item: Check, most: int) -> Check:
    """An object whose keys are no fixed names."""

    def check(value: Any, where: str) -> dict[str, Any]:
        if not isinstance(value, dict):
            raise _expected("an object", value, where)
        if len(value) > most:
            raise InputError(f"{where} has {len(value):,} entries, at most {most:,} are read")
        return {key(k, f"a key of {where}"): item(v, f"{where}.{k[:40]}") for k, v in value.items()}

    return check


def record(required: Mapping[str, Check], optional: Mapping[str, Check] | None = None) -> Check:
    """An object with these keys and no others."""
    known = {**required, **(optional or {})}

    def check(value: Any, where: str) -> dict[str, Any]:
        if not isinstance(value, dict):
            raise _expected("an object", value, where)
        strange = next((k for k in value if k not in known), None)
        if strange is not None:
            raise InputError(f"{where} has no key {strange[:40]!r}", hint=f"there are {', '.join(known) or 'none'}")
        missing = next((k for k in required if k not in value), None)
        if missing is not None:
            raise InputError(f"{where} lacks {missing}")
        return {k: known[k](v, f"{where}.{k}") for k, v in value.items()}

    return check


def one_of(key: str, shapes: Mapping[str, Check]) -> Check:
    """An object whose `key` says which of several shapes it has."""
    which = choice(*shapes)

    def check(value: Any, where: str) -> dict[str, Any]:
        if not isinstance(value, dict):
            raise _expected("an object", value, where)
        kind = which(value.get(key), f"{where}.{key}")
        found: dict[str, Any] = shapes[kind](value, where)
        return found

    return check
