"""The dataclasses of gcrules: those of the standard library, whose methods are made when they are first used.

A command loads some hundred and fifty frozen dataclasses and makes values of a third of them; `dataclasses` compiles
five methods for each, which takes half a millisecond. Here a frozen dataclass holds marks in their places. The first
use of one has the standard library make the real ones, which take these places and are as fast as ever.

>>> @dataclass(frozen=True)
... class Place:
...     x: int
...     y: int = 0
>>> type(vars(Place)["__init__"]).__name__, type(vars(Place)["__eq__"]).__name__
('_Mark', '_Mark')
>>> place = Place(1)
>>> type(vars(Place)["__init__"]).__name__, type(vars(Place)["__eq__"]).__name__
('function', '_Mark')
>>> place, place == Place(1, 0)
(Place(x=1, y=0), True)
"""

from __future__ import annotations

import dataclasses
import sys
from typing import Any

__all__ = ["dataclass"]

_LATE = {"frozen", "eq", "repr", "kw_only"}  # options of classes that are made late
_SHOWN_AND_COMPARED = ("__repr__", "__eq__", "__hash__")
_REST = (
    *("__init__", "__dataclass_fields__", "__dataclass_params__", "__match_args__"),
    *(("__replace__",) if sys.version_info >= (3, 13) else ()),
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dataclasses import dataclass
else:

    def dataclass(cls=None, /, **options):
        """As `dataclasses.dataclass`; and at once so where the class is not frozen, or is made anew for its slots."""
        if cls is None:
            return lambda made: dataclass(made, **options)
        if options.get("frozen") and options.keys() <= _LATE:
            return _marked(cls, options)
        return dataclasses.dataclass(cls, **options)


class _Mark:
    """Stands in a class for a method or a table that is made when it is asked for, with others like it.

    Whatever it does may be done twice, by two threads or after an interrupt: the outcome is the same.
    """

    __slots__ = ("cls", "name", "namespace", "options")

    def __init__(self, cls: type, name: str, namespace: dict[str, Any], options: dict[str, Any]) -> None:
        self.cls, self.name, self.namespace, self.options = cls, name, namespace, options

    def __get__(self, instance: object, owner: type | None = None) -> Any:
        if vars(self.cls)[self.name] is self:
            self._make()
        value = vars(self.cls)[self.name]
        bind = getattr(type(value), "__get__", None)
        return bind(value, instance, owner) if bind else value

    def _make(self) -> None:
        """Have a copy of the class made a dataclass, and take from it what is wanted."""
        names = _SHOWN_AND_COMPARED if self.name in _SHOWN_AND_COMPARED else _REST
        unwanted = {"repr": False, "eq": False} if names is _REST else {"init": False}
        copy = type(self.cls)(self.cls.__name__, self.cls.__bases__, dict(self.namespace))
        made = vars(dataclasses.dataclass(**{**self.options, **unwanted})(copy))
        if names is _REST:
            params = made["__dataclass_params__"]
            params.repr, params.eq = self.options.get("repr", True), self.options.get("eq", True)
        for name in names:
            if isinstance(vars(self.cls).get(name), _Mark):
                setattr(self.cls, name, made[name])


def _marked(cls: type, options: dict[str, Any]) -> type:
    """The class with marks for all that it does not define itself, and the defaults of its fields as attributes."""
    namespace = {name: value for name, value in vars(cls).items() if name not in ("__dict__", "__weakref__")}
    for name, value in namespace.items():
        if isinstance(value, dataclasses.Field):
            if value.default is dataclasses.MISSING:
                delattr(cls, name)
            else:
                setattr(cls, name, value.default)
    defined = set(namespace)
    if "__eq__" in defined and namespace["__hash__"] is None:
        defined.remove("__hash__")  # Python put it there
    if not options.get("repr", True):
        defined.add("__repr__")
    if not options.get("eq", True):
        defined.update(("__eq__", "__hash__"))
    for name in (*_SHOWN_AND_COMPARED, *_REST):
        if name not in defined:
            setattr(cls, name, _Mark(cls, name, namespace, options))
    cls.__setattr__, cls.__delattr__ = _set, _delete  # type: ignore[assignment, method-assign]
    return cls


def _set(self: Any, name: str, value: object) -> None:
    if _is_held(self, name):
        raise dataclasses.FrozenInstanceError(f"cannot assign to field {name!r}")
    object.__setattr__(self, name, value)


def _delete(self: Any, name: str) -> None:
    if _is_held(self, name):
        raise dataclasses.FrozenInstanceError(f"cannot delete field {name!r}")
    object.__delattr__(self, name)


def _is_held(value: Any, name: str) -> bool:
    """Whether a value may not change this attribute: if its class is frozen any, else those fields that it inherits."""
    return "__dataclass_fields__" in vars(type(value)) or name in value.__dataclass_fields__
