"""Functions whose modules load large libraries: imported when they are first called.

>>> dumps = deferred("json:dumps")
>>> dumps([1])
'[1]'

They are written at the head of a module like any import, so that a reader sees them, and are held to the order of the
rooms like imports (`tests/project/test_rooms.py`).
"""

from __future__ import annotations

from importlib import import_module

TYPE_CHECKING = False  # the command line begins here, and hears no signals while typing is loaded
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

__all__ = ["deferred", "resolved"]


def resolved(where: str) -> Any:
    """What `package.module:name` names."""
    module, _, name = where.partition(":")
    return getattr(import_module(module), name)


def deferred(where: str) -> Callable[..., Any]:
    """The function `package.module:name`, imported when it is called."""

    def function(*args: Any, **options: Any) -> Any:
        return resolved(where)(*args, **options)

    return function
