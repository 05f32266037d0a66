"""Parts of robot files that stand for themselves: lines, platform, facts, home, drawing."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from fractions import Fraction

from gcrules.core.errors import InputError
from gcrules.core.hints import near
from gcrules.core.yaml_file import Node
from gcrules.mechanisms.description.family import Definition, Family
from gcrules.mechanisms.description.plane_meets import line_of_planes
from gcrules.mechanisms.description.point_pairs import numbered, point_pairs
from gcrules.mechanisms.description.relations import AXES, relation
from gcrules.mechanisms.description.units import UNIT_ONCE
from gcrules.mechanisms.lines.derived import Derived
from gcrules.mechanisms.robot import Consequence

__all__ = ["MAX_TEXT", "read_drawing", "read_facts", "read_home", "read_lines", "read_platform"]

MAX_TEXT = 300
_FACT = re.compile(r"([A-Za-z][\w']*)\s+(.+)")


def read_lines(node: Node, family: Family, copies: int) -> tuple[tuple[tuple[str, str], ...], tuple[Derived, ...]]:
    """The lines as pairs of names, and the points that are derived for lines which are meets of planes."""
    before = len(node.document.faults)
    derived: dict[str, Derived] = {}

    def meet(text: str) -> tuple[str, str]:
        ends, own = line_of_planes(text, family, derived)
        derived.update((d.name, d) for d in own)
        return ends

    pairs = point_pairs(node, "line", copies, meet)
    for item, (first, second) in pairs:
        for name in dict.fromkeys((first, second)):
            if name not in family.sorts and name not in derived:
                item.fault(f"{name[:20]} is not defined", near(name, family.sorts))
        if first == second:
            item.fault(f"the line {first[:20]}{second[:20]} goes from a point to itself")
    wanted = 3 if family.plane else 6
    if len(node.document.faults) == before and len(pairs) != wanted:
        node.fault(f"{len(pairs)} line{'s' * (len(pairs) != 1)}, expected {wanted}")
    return tuple(pair for _, pair in pairs), tuple(derived.values())


def read_platform(node: Node, family: Family, copies: int) -> tuple[str, ...]:
    """The points that move with the platform: a list, or a text with spaces between them."""
    names: list[str] = []
    for item in node.sequence() if node.kind == "sequence" else (node,):
        text = item.string() or ""
        own = [n for (copy,) in numbered(item, copies, text) for n in copy.replace(",", " ").split()]
        for name in own:
            if family.sorts.get(name) != "point":
                item.fault(f"{name[:20]} is not a point", near(name, family.sorts))
        names += own
    return tuple(dict.fromkeys(names))


def read_facts(node: Node, family: Family, copies: int) -> Iterator[tuple[Node, Consequence]]:
    for item in node.sequence():
        for (text,) in numbered(item, copies, item.string() or ""):
            match = _FACT.fullmatch(text.strip()) if len(text) <= MAX_TEXT else None
            sort = family.sorts.get(match[1]) if match else None
            if not match or sort is None:
                item.fault(f"{text[:40]!r} is not a fact", "write a name and a relation: u1 perpendicular to v1")
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
    """Three coordinates for each name; of planar robots two will do, z being 0."""
    found = {}
    for key, value in node.entries():
        flat = family.plane and len(value.children) == 2
        given = value.sequence(2 if flat else 3)
        numbers = [n.rational(UNIT_ONCE) for n in given]
        if flat and len(numbers) == 2:
            numbers.append(Fraction(0))
        if key.text not in family.sorts or key.text in AXES:
            key.fault(f"{key.text[:20]} is not defined", near(key.text, family.sorts))
        elif len(numbers) == 3 and None not in numbers:
            a, b, c = (n or Fraction(0) for n in numbers)
            found[key.text] = a, b, c
    return found


def read_drawing(
    node: Node, family: Family, home: Mapping[str, tuple[Fraction, Fraction, Fraction]] | None
) -> dict[str, tuple[Fraction, Fraction, Fraction]]:
    """The configuration for drawings: what it leaves out is as at home, unless the relations determine it."""
    if home is None:
        node.fault("a drawing changes places of home, and there is no home", "give one configuration as home")
    free = {d.name for d in family.definitions if d.parameters}
    return {**{n: at for n, at in (home or {}).items() if n in free}, **read_home(node, family)}
