"""What values are made of that can be compared, hashed, copied and pickled: mappings and arrays that cannot change."""

from __future__ import annotations

from collections.abc import Hashable, ItemsView, Iterable, Iterator, KeysView, Mapping, ValuesView
from dataclasses import fields
from typing import Any, TypeVar

__all__ = ["FrozenMap", "HoldsArrays"]

K = TypeVar("K")
V_co = TypeVar("V_co", covariant=True)


class FrozenMap(Mapping[K, V_co]):
    """Keys and values as in a dict of the same items, to which it is equal; hashable if its values are.

    >>> counts = FrozenMap({"a": 1, "b": 2})
    >>> counts, counts["b"], hash(counts) == hash(FrozenMap([("b", 2), ("a", 1)]))
    ({'a': 1, 'b': 2}, 2, True)
    """

    __slots__ = ("_items",)

    def __init__(self, items: Mapping[K, V_co] | Iterable[tuple[K, V_co]] = ()) -> None:
        self._items: dict[K, V_co] = items._items if isinstance(items, FrozenMap) else dict(items)

    def __getitem__(self, key: K) -> V_co:
        return self._items[key]

    def __iter__(self) -> Iterator[K]:
        return iter(self._items)

    def __len__(self) -> int:
        return len(self._items)

    def __contains__(self, key: object) -> bool:
        return key in self._items

    # The views of the dict itself: those of Mapping fetch every value through __getitem__.
    def keys(self) -> KeysView[K]:
        return self._items.keys()

    def values(self) -> ValuesView[V_co]:
        return self._items.values()

    def items(self) -> ItemsView[K, V_co]:
        return self._items.items()

    def __eq__(self, other: object) -> bool:
        return self._items == (other._items if isinstance(other, FrozenMap) else other)

    def __hash__(self) -> int:
        return hash(frozenset(self._items.items()))

    def __reduce__(self) -> tuple[Any, ...]:
        return FrozenMap, (self._items,)

    def __repr__(self) -> str:
        return repr(self._items)


class HoldsArrays:
    """The base of frozen dataclasses, made with eq=False, whose fields hold arrays: two are equal, and hash alike, if
    all that they hold is the same, entry by entry (nan is nan). Their arrays cannot be written to.

    >>> import numpy as np
    >>> from dataclasses import dataclass
    >>> @dataclass(frozen=True, eq=False)
    ... class Places(HoldsArrays):
    ...     x: np.ndarray
    >>> Places(np.zeros(3)) == Places(np.zeros(3)) != Places(np.zeros(2)), Places(np.zeros(3)).x.flags.writeable
    (True, False)
    """

    def __post_init__(self) -> None:
        for name, value in vars(self).items():
            if _is_array(value):
                sealed = value.view()
                sealed.flags.writeable = False
                object.__setattr__(self, name, sealed)

    def __setstate__(self, state: Mapping[str, Any]) -> None:
        vars(self).update(state)
        HoldsArrays.__post_init__(self)  # arrays that were copied or unpickled can be written to

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return self is other or _contents(self) == _contents(other)

    def __hash__(self) -> int:
        return hash(_contents(self))


def _is_array(value: Any) -> bool:
    return hasattr(value, "tobytes") and hasattr(value, "dtype")  # numpy is not loaded for this question


def _contents(value: Any) -> Hashable:
    """What a value holds, comparable and hashable: arrays by their bytes, nan equal to itself."""
    if _is_array(value):
        held = value.tobytes() if value.dtype.kind != "O" else tuple(map(_contents, value.ravel().tolist()))
        return "array", value.dtype.str, value.shape, held
    match value:
        case HoldsArrays():
            compared = (f.name for f in fields(value) if f.compare)  # type: ignore[arg-type]
            return type(value), *(_contents(getattr(value, name)) for name in compared)
        case Mapping():
            return frozenset((key, _contents(v)) for key, v in value.items())
        case tuple() | list():
            return tuple(map(_contents, value))
        case float() if value != value:
            return "nan"
    return value  # type: ignore[no-any-return]
