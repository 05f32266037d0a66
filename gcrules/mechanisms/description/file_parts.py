"""Parts of robot files that stand for themselves: lines, platform, facts, home, and names that stand for several."""

from __future__ import annotations

import re
from collections.abc import Iterator
from fractions import Fraction

from gcrules.algebra.language.text import SHORT_NAME
from gcrules.core.errors import InputError
from gcrules.core.hints import near
from gcrules.core.yaml_file import Node
from gcrules.mechanisms.description.family import Definition, Family
from gcrules.mechanisms.description.relations import AXES, relation
from gcrules.mechanisms.robot import Consequence

__all__ = ["MAX_TEXT", "numbered", "read_facts", "read_home", "read_lines", "read_platform"]

MAX_TEXT = 300
_FACT = re.compile(r"([A-Za-z][\w']*)\s+(.+)")


def numbered(copies: int, *texts: str) -> Iterator[tuple[str, ...]]:
    """The texts, once for each copy if one of them bears the sign %."""
    if not any("%" in text for text in texts):
        yield texts
        return
    for number in range(1, copies + 1):
        yield tuple(text.replace("%", str(number)) for text in texts)


def read_lines(node: Node, family: Family) -> tuple[tuple[str, str], ...]:
    words = (node.string() or "").split() if node.kind == "scalar" else [n.string() or "" for n in node.sequence()]
    found = []
    for word in words:
        names = SHORT_NAME.findall(word)
        if len(names) != 2 or "".join(names) != word or names[0] == names[1]:
            node.fault(f"{word[:20]!r} does not name two points", "lines are written S1A1 S2A2 …")
            continue
        for name in names:
            if name not in family.sorts:
                node.fault(f"{name} is not defined", near(name, family.sorts))
        found.append((names[0], names[1]))
    wanted = 3 if family.plane else 6
    if len(found) != wanted:
        node.fault(f"{len(found)} lines, expected {wanted}")
    return tuple(found)


def read_platform(node: Node, family: Family, copies: int) -> tuple[str, ...]:
    text = node.string() or ""
    names = tuple(n for (copy,) in numbered(copies, text) for n in copy.replace(",", " ").split())
    for name in names:
        if family.sorts.get(name) != "point":
            node.fault(f"{name[:20]} is no point", near(name, family.sorts))
    return tuple(dict.fromkeys(names))


def read_facts(node: Node, family: Family, copies: int) -> Iterator[tuple[Node, Consequence]]:
    for item in node.sequence():
        for (text,) in numbered(copies, item.string() or ""):
            match = _FACT.fullmatch(text.strip()) if len(text) <= MAX_TEXT else None
            sort = family.sorts.get(match[1]) if match else None
            if not match or sort is None:
                item.fault(f"{text[:40]!r} is no fact", "write a name and a relation: u1 perpendicular to v1")
                continue
            try:
                said = Definition(match[1], sort, relation(sort, match[2]))
            except InputError as fault:
                item.fault(fault.message, fault.hint)
                continue
            unknown = [n for n in said.relation.names if n not in family.sorts]
            for name in unknown:
                item.fault(f"{name} is not defined", near(name, family.sorts))
            if not unknown:
                yield item, Consequence(said, text.strip())


def read_home(node: Node, family: Family) -> dict[str, tuple[Fraction, Fraction, Fraction]]:
    found = {}
    for key, value in node.entries():
        numbers = [n.rational("lengths are all in one unit, which the file does not name") for n in value.sequence(3)]
        if key.text not in family.sorts or key.text in AXES:
            key.fault(f"{key.text[:20]} is not defined", near(key.text, family.sorts))
        elif len(numbers) == 3 and None not in numbers:
            a, b, c = (n or Fraction(0) for n in numbers)
            found[key.text] = a, b, c
    return found
