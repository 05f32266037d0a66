"""What the type of a piece of JSON leaves open, as metadata of `Annotated`: how many things there are, which words."""

from __future__ import annotations

from gcrules.core.dataclass import dataclass

__all__ = ["EntryCount", "OneOf"]


@dataclass(frozen=True)
class EntryCount:
    """How many entries a list or an object has: `least` to `most`."""

    least: int
    most: int


@dataclass(frozen=True)
class OneOf:
    """A text that is one of these, where the type checker takes any."""

    words: tuple[str, ...]
