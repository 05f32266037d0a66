r"""What a public function takes: a table of kinds of arguments, checked in one place before anything is computed.

>>> @checked("gc.double", number=WHOLE, name=optional(TEXT))
... def double(number: int, name: str | None = None) -> int:
...     return 2 * number
>>> double(4)
8
>>> double("4")
Traceback (most recent call last):
    ...
gcrules.core.errors.InputError: gc.double: `number` must be a whole number, got '4'

A missing argument and an unknown keyword stay Python's own TypeError of the call.
"""

from __future__ import annotations

import inspect
import math
import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import field, replace
from fractions import Fraction
from functools import wraps
from numbers import Integral, Real
from os import PathLike
from typing import Any, ParamSpec, TypeVar

from gcrules.core.dataclass import dataclass
from gcrules.core.english import with_article
from gcrules.core.errors import InputError

__all__ = [
    "ANYTHING",
    "COUNT",
    "DURATION",
    "FILE",
    "FLAG",
    "NAMES",
    "NUMBER",
    "NUMBERS",
    "ROW",
    "TEXT",
    "TEXTS",
    "WHOLE",
    "ArgumentKind",
    "Unfit",
    "checked",
    "described",
    "each",
    "either",
    "instance",
    "is_truth",
    "listed",
    "mapping",
    "optional",
    "read",
    "row",
]

P = ParamSpec("P")
T = TypeVar("T")


class Unfit(Exception):
    """Raised by `ArgumentKind.read` for a value that is not of the kind, with the value in it that does not fit."""


@dataclass(frozen=True)
class ArgumentKind:
    """`words` say after "must be" what is expected; `read` gives the value as the engine takes it, or raises Unfit.
    `hints` say, by the name of its class, what to do with a value of another kind. `several` is for *arguments and
    **arguments, of which each is read by itself.
    """

    words: str
    read: Callable[[Any], Any]
    hints: Mapping[str, str] = field(default_factory=dict)
    several: bool = False

    def hinting(self, words: str = "", **hints: str) -> ArgumentKind:
        """With more hints, and other words if they are given."""
        return replace(self, words=words or self.words, hints={**self.hints, **hints})


def read(kind: ArgumentKind, value: Any, what: str) -> Any:
    """The value as the engine takes it. Raises InputError that begins with `what`."""
    try:
        return kind.read(tuple(value) if isinstance(value, Iterator) else value)
    except Unfit as unfit:
        hint = next((kind.hints[c.__name__] for c in type(value).__mro__ if c.__name__ in kind.hints), None)
        inside = "".join(f" that holds {described(one)}" for one in unfit.args)
        raise InputError(f"{what} must be {kind.words}, got {described(value)}{inside}", hint=hint) from None


def checked(called: str, /, **kinds: ArgumentKind) -> Callable[[Callable[P, T]], Callable[P, T]]:
    """A function whose arguments are read by their kinds; `called` is how users write it."""

    def decorate(function: Callable[P, T]) -> Callable[P, T]:
        signature = inspect.signature(function)
        unknown = kinds.keys() - signature.parameters.keys()
        assert not unknown, unknown

        @wraps(function)
        def call(*args: P.args, **options: P.kwargs) -> T:
            try:
                bound = signature.bind(*args, **options)
            except TypeError:
                return function(*args, **options)  # Python says better what is missing
            for key, value in bound.arguments.items():
                if key in kinds:
                    bound.arguments[key] = _argument(kinds[key], value, called, key)
            return function(*bound.args, **bound.kwargs)

        call.kinds = kinds  # type: ignore[attr-defined]
        return call

    return decorate


def _argument(kind: ArgumentKind, value: Any, called: str, key: str) -> Any:
    if not kind.several:
        return read(kind, value, f"{called}: `{key}`")
    if isinstance(value, dict):
        return {k: read(kind, v, f"{called}: `{k}`") for k, v in value.items()}
    return tuple(read(kind, v, f"{called}: `{key}`") for v in value)


def described(value: Any) -> str:
    """A value in a few words; those of a short text or number itself."""
    if value is None or isinstance(value, (bool, float, complex)):
        return repr(value)
    if isinstance(value, int):
        return repr(value) if value.bit_length() <= 128 else f"a whole number of {value.bit_length()} bits"
    if isinstance(value, (str, bytes)):
        return repr(value[:40]) + ("…" if len(value) > 40 else "")
    if isinstance(value, type):
        return f"the class {value.__name__}"
    shape = getattr(value, "shape", None)
    if isinstance(shape, tuple):
        return f"an array of shape {shape}"
    kind = type(value).__name__
    count = f" of {len(value)}" if type(value) in _SIZED else ""
    return f"{with_article(kind)}{count}"


_SIZED = (list, tuple, dict, set, frozenset)
_UNORDERED = (str, bytes, bytearray, memoryview, Mapping, set, frozenset)


# --- kinds ---------------------------------------------------------------------------------------------------------


def instance(words: str, *classes: type) -> ArgumentKind:
    """Values of these classes."""

    def fits(value: Any) -> Any:
        if not isinstance(value, classes):
            raise Unfit
        return value

    return ArgumentKind(words, fits)


def either(words: str, *kinds: ArgumentKind) -> ArgumentKind:
    """The first of the kinds that fits."""

    def first(value: Any) -> Any:
        for kind in kinds:
            try:
                return kind.read(value)
            except Unfit:
                continue
        raise Unfit

    return ArgumentKind(words, first, {k: v for kind in kinds for k, v in kind.hints.items()})


def optional(kind: ArgumentKind) -> ArgumentKind:
    """None too."""
    return ArgumentKind(kind.words, lambda value: None if value is None else kind.read(value), kind.hints)


def listed(words: str, item: ArgumentKind, *, alone: bool = False, ordered: bool = True) -> ArgumentKind:
    """An iterable of values of one kind, as a tuple; with `alone` one of these by itself, too. Sets are refused unless
    the order makes no difference.
    """

    def read_all(value: Any) -> Any:
        if alone:
            try:
                return (item.read(value),)
            except Unfit:
                pass
        if not ordered and isinstance(value, (set, frozenset)):
            value = list(value)
        if isinstance(value, (*_UNORDERED, type)) or not isinstance(value, Iterable):
            raise Unfit
        try:
            values = tuple(value)
        except TypeError:  # what calls itself iterable and is not, such as an array without dimensions
            raise Unfit from None
        return tuple(_item(item, one) for one in values)

    return ArgumentKind(words, read_all, item.hints)


def row(words: str, *items: ArgumentKind) -> ArgumentKind:
    """As many values as there are kinds, one of each in order, as a tuple."""
    some = listed(words, ArgumentKind("", lambda value: value))

    def read_each(value: Any) -> Any:
        values = some.read(value)
        if len(values) != len(items):
            raise Unfit
        return tuple(item.read(v) for item, v in zip(items, values, strict=True))

    return ArgumentKind(words, read_each)


def _item(kind: ArgumentKind, value: Any) -> Any:
    try:
        return kind.read(value)
    except Unfit:
        raise Unfit(value) from None


def mapping(words: str, item: ArgumentKind) -> ArgumentKind:
    """A mapping from texts to values of one kind, as a dict."""

    def read_all(value: Any) -> Any:
        if not isinstance(value, Mapping):
            raise Unfit
        return {TEXT.read(k): item.read(v) for k, v in value.items()}

    return ArgumentKind(words, read_all)


def each(kind: ArgumentKind) -> ArgumentKind:
    """For the values of *arguments and **arguments."""

    return replace(kind, several=True)


def _whole(value: Any) -> int:
    if is_truth(value) or not isinstance(value, Integral):
        raise Unfit
    return int(value)


def _number(value: Any) -> Any:
    """A real number that is not nan; numpy's become Python's."""
    if is_truth(value) or not isinstance(value, Real) or value != value:
        raise Unfit
    if isinstance(value, Fraction):
        return value
    return int(value) if isinstance(value, Integral) else float(value)


def _duration(value: Any) -> float:
    """Seconds as a float; what is too large for one is no limit."""
    if (found := _number(value)) < 0:
        raise Unfit
    try:
        return float(found)
    except OverflowError:
        return math.inf


def _positive(value: Any) -> int:
    if (found := _whole(value)) < 1:
        raise Unfit
    return found


def is_truth(value: Any) -> bool:
    """Whether a value is True or False, numpy's among them: they are no numbers here."""
    return type(value).__name__ in ("bool", "bool_")


def _flag(value: Any) -> bool:
    if is_truth(value):
        return bool(value)
    raise Unfit


def _file(value: Any) -> Any:
    if isinstance(value, PathLike):
        value = value.__fspath__()
    if not isinstance(value, str) or "\0" in value:
        raise Unfit
    try:
        os.fsencode(value)
    except UnicodeEncodeError:
        raise Unfit from None
    return value


ANYTHING = ArgumentKind("anything", lambda value: value)
TEXT = instance("text", str)
TEXTS = listed("text or a sequence of texts", TEXT, alone=True)
NAMES = either("names of points as text or as a sequence of texts", TEXT, listed("", TEXT))
FILE = ArgumentKind("the name of a file", _file)
FLAG = ArgumentKind("True or False", _flag)
WHOLE = ArgumentKind("a whole number", _whole)
COUNT = ArgumentKind("a whole number, 1 or more", _positive)
NUMBER = ArgumentKind("a number", _number)
DURATION = ArgumentKind("a number of seconds, 0 or more", _duration)


def _numbers(value: Any) -> Any:
    """Numbers, and rows of them to any depth; arrays as they are. What they are worth is for their reader to say."""
    if is_truth(value) or isinstance(value, (*_UNORDERED, type)):
        raise Unfit
    if hasattr(value, "__array__") or hasattr(value, "__float__"):
        return value
    if not isinstance(value, Iterable):
        raise Unfit
    return list(map(_numbers, value))


def _row(value: Any) -> Any:
    """One row of numbers, which may be written as texts, as a list."""
    found = value.tolist() if hasattr(value, "tolist") else value
    if isinstance(found, (*_UNORDERED, type)) or not isinstance(found, Iterable):
        raise Unfit
    entries = [c if isinstance(c, str) else _numbers(c) for c in found]
    if any(isinstance(c, list) for c in entries):
        raise Unfit
    return entries


NUMBERS = ArgumentKind("numbers or an array of them", _numbers)
ROW = ArgumentKind("numbers in a row", _row)
