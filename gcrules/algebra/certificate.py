"""How sure an answer is: the method that it rests on, in a word, in words and as data."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap

__all__ = ["Certificate"]


@dataclass(frozen=True)
class Certificate:
    """How sure an answer is: `method` is normal-form | catalog-instance | random-points, `detail` in words."""

    method: str
    detail: str
    data: Mapping[str, Any] = FrozenMap()

    def __post_init__(self) -> None:
        object.__setattr__(self, "data", FrozenMap(self.data))

    def to_json(self) -> dict[str, Any]:
        data = {key: dict(value) if isinstance(value, Mapping) else value for key, value in self.data.items()}
        return {"method": self.method, "detail": self.detail, **data}
