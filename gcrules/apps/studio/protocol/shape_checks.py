"""The check of an argument, made of its type.

>>> from gcrules.apps.studio.protocol.requests import ClassSource
>>> check_of(ClassSource)({"kind": "class", "id": 3}, "source")
Traceback (most recent call last):
gcrules.core.errors.InputError: source.id is 3, expected a text
"""

from __future__ import annotations

from types import UnionType
from typing import Annotated, Any, Literal, NotRequired, Union, get_args, get_origin, get_type_hints, is_typeddict

from gcrules.apps.studio.protocol.checking import Check, choice, listed, mapped, one_of, record, tuple_of
from gcrules.core.shapes import EntryCount

__all__ = ["check_of"]


def check_of(shape: Any) -> Check:
    """The check of a typed dictionary, a list or object of bounded size, a choice of words, a union by `kind`, or of
    a type that is annotated with its check. Raises TypeError for any other: nothing is taken without a bound.
    """
    inner, *marks = get_args(shape) if get_origin(shape) is Annotated else (shape,)
    own = [mark for mark in marks if callable(mark)]
    if own:
        found: Check = own[-1]
        return found
    parts = get_args(inner)
    if is_typeddict(inner):
        return _record(inner)
    if get_origin(inner) in (Union, UnionType):
        return one_of("kind", {_kind(part): check_of(part) for part in parts})
    if get_origin(inner) is Literal:
        return choice(*parts)
    for size in marks:
        if isinstance(size, EntryCount) and get_origin(inner) is dict:
            return mapped(check_of(parts[0]), check_of(parts[1]), size.most)
        if isinstance(size, EntryCount) and get_origin(inner) is list:
            item = check_of(parts[0])
            same = size.least == size.most
            return tuple_of(*[item] * size.most) if same else listed(item, size.most, size.least)
    raise TypeError(f"{shape} does not say what is taken")


def _record(shape: Any) -> Check:
    required: dict[str, Check] = {}
    optional: dict[str, Check] = {}
    for name, hint in get_type_hints(shape, include_extras=True).items():
        if get_origin(hint) is NotRequired:
            optional[name] = check_of(get_args(hint)[0])
        else:
            required[name] = check_of(hint)
    return record(required, optional)


def _kind(shape: Any) -> str:
    (word,) = get_args(get_type_hints(shape)["kind"])
    return str(word)
