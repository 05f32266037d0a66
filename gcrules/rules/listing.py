"""Lists in sentences."""

from __future__ import annotations

from collections.abc import Sequence

__all__ = ["listed", "together"]


def listed(names: Sequence[str]) -> str:
    """ "ab, cd and ef", each name once."""
    names = list(dict.fromkeys(names))
    return " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)


def together(items: Sequence[str]) -> str:
    """ "the lines Aa and Bb and the direction i" of "line Aa", "line Bb", "direction i"."""
    kinds: dict[str, list[str]] = {}
    others = []
    for item in items:
        kind, _, name = item.partition(" ")
        if kind in ("line", "direction"):
            kinds.setdefault(kind, []).append(name)
        else:
            others.append(item)
    found = [f"the {kind}{'s' * (len(names) > 1)} {listed(names)}" for kind, names in kinds.items()]
    return listed([*found, *others])
