r"""Pairs of points in a file: the legs of a platform, the lines of a robot.

They are written as one text, "ab af cb", or as a list of ab, S1A1, "S1 A1" or [left, right]. Where lines may be meets
of planes, `abc /\ def`, lines that stand in one text are set apart by commas.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

from gcrules.algebra.language.text import SHORT_NAME
from gcrules.core.errors import InputError
from gcrules.core.yaml_file import Node

__all__ = ["MEET", "numbered", "point_pairs"]

MEET = re.compile(r"/\\|\^")
_COMMAS, _SPACES = r"[,;]+", r"[\s,;]+"
_MAX_SHOWN = 40


def numbered(node: Node, copies: int, *texts: str) -> Iterator[tuple[str, ...]]:
    """The texts of a node, once for each copy if one of them bears the sign %. Faults: no copies, and that sign."""
    if not any("%" in text for text in texts):
        yield texts
        return
    if not copies:
        node.fault("% stands for the numbers of copies, and there is no key copies", "copies: 3")
    for number in range(1, copies + 1):
        yield tuple(text.replace("%", str(number)) for text in texts)


def point_pairs(
    node: Node, noun: str, copies: int | None = None, meet: Callable[[str], tuple[str, str]] | None = None
) -> list[tuple[Node, tuple[str, str]]]:
    """Each pair with its node; what is at fault is left out. `noun` is what a pair stands for, a leg or a line; where
    there are `copies` the sign % stands for their numbers. `meet` makes a pair of a meet of planes, or raises
    InputError.
    """
    parts: list[tuple[Node, tuple[str, ...]]]
    if node.kind == "scalar" and not node.is_nothing:
        parts = [
            (node, (word.strip(),))
            for word in re.split(_COMMAS if meet and MEET.search(node.text) else _SPACES, node.text.strip())
        ]
    else:
        parts = [(item, _texts(item)) for item in node.sequence()]
        if node.kind == "sequence" and not parts:
            node.fault(f"there are no {noun}s")
    if copies is not None:
        parts = [(item, copy) for item, texts in parts for copy in numbered(item, copies, *texts)]
    return [(item, pair) for item, texts in parts if (pair := _pair(item, texts, noun, meet))]


def _texts(item: Node) -> tuple[str, ...]:
    """What an item of a list says: one text, or the texts of two names; none where it is at fault."""
    if item.kind == "scalar":
        return (item.text,)
    names = tuple(name for part in item.sequence(length=2) if (name := part.string()))
    return names if len(names) == 2 else ()


def _pair(
    item: Node, texts: tuple[str, ...], noun: str, meet: Callable[[str], tuple[str, str]] | None
) -> tuple[str, str] | None:
    if len(texts) != 1:
        return (texts[0], texts[1]) if texts else None
    if meet and MEET.search(texts[0]):
        try:
            return meet(texts[0])
        except InputError as fault:
            item.fault(fault.message, fault.hint)
            return None
    words = texts[0].split()
    names = words if len(words) > 1 else SHORT_NAME.findall(texts[0])
    if len(names) != 2 or (len(words) == 1 and "".join(names) != texts[0]):
        item.fault(
            f"the {noun} {texts[0][:_MAX_SHOWN]!r} does not name two points"
            if words
            else f"this {noun} names no points",
            'write ab, S1A1, "S1 A1" or [left, right]',
        )
        return None
    return names[0], names[1]
