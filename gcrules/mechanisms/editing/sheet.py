"""A robot file as a sheet: limbs as rows of joints, names with their relations, home; all of it as it is written.

A sheet may be at fault, where a `Robot` may not: a joint of an unknown kind, a name that nothing defines. % stands for
the numbers of copies, as in the file.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import field, replace

from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap

__all__ = ["FIRST", "ChainRow", "JointRow", "LimbRow", "NameRow", "Place", "Sheet", "renamed_text", "words_of"]

Place = tuple[str, str, str]
"""Three coordinates as they are written: fractions or decimals; "" for a third one that the plane spares."""

_WORD = re.compile(r"[A-Za-z][\w'%]*")

_IN_SPACE = """\
title: My robot
points:
  A1: free
  S1: in plane A1 perpendicular to r1
directions:
  r1: free
limbs:
  - name: leg 1
    joints: R(A1, r1) P*(A1 S1) S(S1)
platform: S1
mobility: 5
home:
  A1: [2, 0, 0]
  S1: [1, 0, 2]
  r1: [0, 1, 0]
"""

_IN_PLANE = """\
title: My robot
space: plane
points:
  A1: free
  B1: free
  C1: free
limbs:
  - name: leg 1
    joints: R*(A1, z) R(B1, z) R(C1, z)
platform: C1
mobility: 3
home:
  A1: [2, 0]
  B1: [1.5, 1]
  C1: [0.5, 0.5]
"""

FIRST: Mapping[bool, str] = FrozenMap({False: _IN_SPACE, True: _IN_PLANE})
"""A limb to begin with, in space and in the plane; three of it around z are a 3-RPS or a 3-RRR robot."""


@dataclass(frozen=True)
class JointRow:
    """A joint as written: `star` is "*", "*1" or "*2" where it is driven, `parts` stand in its parentheses."""

    kind: str
    parts: tuple[str, ...]
    star: str = ""
    name: str = ""

    @property
    def text(self) -> str:
        return f"{self.kind}{self.star}{':' * bool(self.name)}{self.name}({', '.join(self.parts)})"


@dataclass(frozen=True)
class ChainRow:
    """Joints one after the other; `head` says between which bodies, "base to hub", "" in a limb of one chain."""

    joints: tuple[JointRow, ...]
    head: str = ""

    @property
    def text(self) -> str:
        return " ".join(j.text for j in self.joints)


@dataclass(frozen=True)
class LimbRow:
    """A limb: chains of joints, or a `cable` between two points."""

    name: str
    chains: tuple[ChainRow, ...] = ()
    cable: str = ""
    through: str = ""
    couplings: str = ""

    @property
    def text(self) -> str:
        """All that it names."""
        return " ".join([self.cable, self.through, *(c.text for c in self.chains)])

    @property
    def numbered(self) -> bool:
        """Whether it stands for copies."""
        return "%" in self.name + self.text

    def changed(self, chain: int, joints: tuple[JointRow, ...]) -> LimbRow:
        """With other joints in a chain."""
        rows = list(self.chains)
        rows[chain] = replace(rows[chain], joints=joints)
        return replace(self, chains=tuple(rows))

    def renamed(self, names: Mapping[str, str]) -> LimbRow:
        """With names in place of others."""
        chains = tuple(
            replace(c, joints=tuple(replace(j, parts=tuple(renamed_text(p, names) for p in j.parts)) for j in c.joints))
            for c in self.chains
        )
        cable, through = (renamed_text(text, names) for text in (self.cable, self.through))
        return replace(self, chains=chains, cable=cable, through=through)


@dataclass(frozen=True)
class NameRow:
    """A point or a direction (`sort`) and the relation that makes it."""

    name: str
    sort: str
    relation: str


@dataclass(frozen=True)
class Sheet:
    """`others` are the keys that stay as they are: a text, or a list of texts, each."""

    title: str
    names: tuple[NameRow, ...]
    limbs: tuple[LimbRow, ...]
    mobility: str
    copies: int = 0
    platform: str = ""
    plane: bool = False
    home: Mapping[str, Place] = field(default_factory=FrozenMap)
    drawing: Mapping[str, Place] = field(default_factory=FrozenMap)
    others: Mapping[str, str | tuple[str, ...]] = field(default_factory=FrozenMap)

    def numbers(self, name: str) -> tuple[str, ...]:
        """The names that a row stands for."""
        if "%" not in name:
            return (name,)
        return tuple(name.replace("%", str(k)) for k in range(1, self.copies + 1))

    @property
    def every_name(self) -> frozenset[str]:
        """All names that rows define, those of copies one by one."""
        return frozenset(n for row in self.names for n in self.numbers(row.name))

    @property
    def every_limb(self) -> frozenset[str]:
        """The names of all limbs, those of copies one by one."""
        return frozenset(n for limb in self.limbs for n in self.numbers(limb.name))

    def row(self, name: str) -> NameRow | None:
        """The row that defines a name, be it that of a copy."""
        return next((row for row in self.names if name == row.name or name in self.numbers(row.name)), None)

    def uses(self) -> frozenset[str]:
        """Names of rows that limbs, relations, the platform or other keys mention."""
        texts = [self.platform, *(limb.text for limb in self.limbs), *(row.relation for row in self.names)]
        texts += [t for value in self.others.values() for t in ([value] if isinstance(value, str) else value)]
        words = {w for text in texts for w in words_of(text)}
        condition = str(self.others.get("condition", ""))  # there names stand side by side
        return frozenset(
            row.name
            for row in self.names
            if {row.name, *self.numbers(row.name)} & words or any(n in condition for n in self.numbers(row.name))
        )

    def with_limb(self, at: int, limb: LimbRow) -> Sheet:
        rows = list(self.limbs)
        rows[at] = limb
        return replace(self, limbs=tuple(rows))


def words_of(text: str) -> Iterator[str]:
    """Names in a text, and words that are none."""
    return iter(_WORD.findall(text))


def renamed_text(text: str, names: Mapping[str, str]) -> str:
    """A text with names in place of others."""
    return _WORD.sub(lambda match: names.get(match[0], match[0]), text)
