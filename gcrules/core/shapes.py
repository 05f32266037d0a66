"""What the type of a piece of JSON leaves open, as metadata of `Annotated`: how many things there are, which words."""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["Size", "Words"]


@dataclass(frozen=True)
class Size:
    """How many entries a list or an object has: `least` to `most`."""

    least: int
    most: int


@dataclass(frozen=True)
class Words:
    """A text that is one of these, where the type checker takes any."""

    words: tuple[str, ...]
