"""Frozen values that compute their hash once: what is nested deeply is looked up at every step of a computation."""

from __future__ import annotations

from typing import Any

__all__ = ["Hashed"]


class Hashed:
    """The base of frozen dataclasses with slots. The hash is no field: it is another one in each process."""

    __slots__ = ("_hash",)
    __match_args__: tuple[str, ...] = ()
    _hash: int

    def __init_subclass__(cls, **options: Any) -> None:
        super().__init_subclass__(**options)
        type.__setattr__(cls, "__hash__", Hashed.__hash__)  # else the decorator `dataclass` writes one

    def __hash__(self) -> int:
        try:
            return self._hash
        except AttributeError:
            found = hash((type(self).__name__, *(getattr(self, name) for name in self.__match_args__)))
            object.__setattr__(self, "_hash", found)
            return found
