"""Names and relations for the points and directions of joints: those that hold in all configurations.

What holds at home alone is an accident of the pose, and no relation. Relations within a limb are looked for first;
those with other limbs (`level`) only if the family would move in other ways than the model without them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations, pairwise

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.models.merging import Part, Slot

__all__ = ["LEVELS", "Known", "Level", "Named", "Naming"]

_WORDS = ("points of a limb", "points of all limbs", "points and directions of all limbs", "relations between limbs")
_SAME = 1e-6  # of the size, and radians
_POINTS = "ABCDEFGHIJKLMNPQRSTUVW"
_LETTERS = "abcdefgijkmnopqrstuvw"
_AXES = {"R": "rstpq", "H": "rstpq", "C": "rstpq", "U": "uvwjk", "P": "def", "4S": "def", "Pa": "nm", "E": "nm"}


@dataclass(frozen=True)
class Level:
    """How far relations are looked for: with points, directions and relations of other limbs (1, 2, 3); with names
    given in the sequence of the joints, points before directions if not; with mirror images.
    """

    words: str
    others: int
    in_sequence: bool = False
    mirrors: bool = False


LEVELS = (
    *(Level(words, k) for k, words in enumerate(_WORDS)),
    *(Level(f"{words}, in the sequence of the joints", k, in_sequence=True) for k, words in enumerate(_WORDS)),
    Level("points of all limbs, and mirror images", 1, mirrors=True),
)


@dataclass(frozen=True, eq=False)
class Known:
    """A point or direction that has a name: the letters before the number of its limb, -1 for what limbs share."""

    stem: str
    limb: int
    sort: str
    values: Floats
    relation: tuple[str | Known, ...] = ("free",)
    parameters: bool = True
    length: float = 0.0  # of bars

    def text(self, number: str) -> str:
        """Its name, where `number` stands for that of its limb."""
        return self.stem + (number if self.limb >= 0 else "")


Named = tuple[Known, ...]
"""What stands for a point or direction in a joint: a name, or the two points between which it leads."""


class Naming:
    """Names for the slots of limbs; `slots` has what stands for each of them."""

    def __init__(self, limbs: Sequence[Sequence[Part]], size: float, level: Level, *, plane: bool) -> None:
        self.size = size
        self.level = level.others
        self.in_sequence = level.in_sequence
        self.plane = plane
        self.known: list[Known] = []
        self.slots: dict[Slot, Named] = {}
        self.frame = [Known(n, -1, "direction", np.tile(a, (self._count(limbs), 1)), (), parameters=False)
                      for n, a in zip("xyz", np.eye(3), strict=True)]  # fmt: skip
        self.shared = self._shared(limbs)
        self.mirror = self._mirror(limbs) if level.mirrors else None
        for k, parts in enumerate(limbs):
            self._limb(k, parts)

    @staticmethod
    def _count(limbs: Sequence[Sequence[Part]]) -> int:
        return len(limbs[0][0].slots[0].values)

    def _shared(self, limbs: Sequence[Sequence[Part]]) -> dict[Slot, Known]:
        """Centres of joints that several limbs have; from level 1 on all points, from level 2 on directions too."""
        found: dict[Slot, Known] = {}
        own = [(k, p, s) for k, parts in enumerate(limbs) for p in parts for s in p.slots]
        for sort, stem in (("point", "O"), ("direction", "h")):
            wanted = [(k, s) for k, p, s in own if s.sort == sort and (self.level or p.kind in ("S", "U"))]
            if sort == "direction" and self.level < 2:
                continue
            groups: list[list[tuple[int, Slot]]] = []
            for k, slot in wanted:
                group = next((g for g in groups if self._same_slot(g[0][1], slot)), None)
                groups.append([(k, slot)]) if group is None else group.append((k, slot))
            groups = [g for g in groups if len({k for k, _ in g}) > 1]
            several = len(groups) > 1
            stems = (
                "hklg" if sort == "direction" and len(groups) < 5 else [f"{stem}{n + 1}" for n in range(len(groups))]
            )
            for n, group in enumerate(groups):
                values = group[0][1].values
                length = group[0][1].length
                one = self._of_frame(values) if sort == "direction" and not length else None
                one = one or Known(stem if not several else stems[n], -1, sort, values, length=length)
                found.update((slot, one) for _, slot in group)
        return found

    def _mirror(self, limbs: Sequence[Sequence[Part]]) -> tuple[Known, Known, Known] | None:
        """Two points that limbs share, and the middle between them, if a limb has another point at one distance of
        both: what is on one side may be the mirror image of what is on the other.
        """
        shared = [d for d in dict.fromkeys(self.shared.values()) if d.sort == "point"]
        points = [s.values for parts in limbs for p in parts for s in p.slots if s.sort == "point"]
        for one, other in combinations(shared, 2):
            if any(self._between(one, other, values) for values in points):
                slots = {d: next(slot for slot, known in self.shared.items() if known is d) for d in (one, other)}
                for d in (one, other):
                    self._add(d, (("free",), True))
                ends = [self.shared[slots[d]] for d in (one, other)]
                middle = (ends[0].values + ends[1].values) / 2
                stem = next(c for c in "MNQ" if all(d.stem != c for d in self.shared.values()))
                words = ("1/2 ", ends[0], " + 1/2 ", ends[1])
                self.known.append(Known(stem, -1, "point", middle, words, parameters=False))
                return ends[0], ends[1], self.known[-1]
        return None

    def _between(self, one: Known, other: Known, values: Floats) -> bool:
        """Whether a point that is neither has one distance of both."""
        lengths = [np.linalg.norm(values - d.values, axis=1) for d in (one, other)]
        apart = np.abs(lengths[0] - lengths[1]).max()
        return bool(apart < _SAME * self.size < lengths[0].min())

    def _of_frame(self, values: Floats) -> Known | None:
        return next((axis for axis in self.frame if self._same("direction", axis.values, values)), None)

    def _same_slot(self, one: Slot | Known, other: Slot) -> bool:
        """Whether one name does for both: bars have a length and a sense."""
        if not self._same(one.sort, one.values, other.values):
            return False
        sense = not other.length or float((one.values * other.values).sum()) > 0
        return sense and abs(one.length - other.length) < _SAME * self.size

    def _same(self, sort: str, one: Floats, other: Floats) -> bool:
        if sort == "point":
            return bool(np.abs(one - other).max() < _SAME * self.size)
        return bool(np.linalg.norm(np.cross(one, other), axis=1).max() < _SAME)

    def _limb(self, k: int, parts: Sequence[Part]) -> None:
        slots = [(p, s) for p in parts for s in p.slots]
        first = [s for s in parts[0].slots if s.sort == "point"] + [s for s in parts[0].slots if s.sort != "point"][:1]
        if parts[0].kind == "P":
            first = first if self._span_of(parts, 0) is None else []
        points = [s for _, s in slots if s.sort == "point" and s not in first]
        rest = [s for _, s in slots if s.sort == "direction" and s not in first]
        part_of = {s: p for p, s in slots}
        own: list[Known] = []
        order: list[Known] = []  # points along the limb
        held = [s for s in rest if s in self.shared]
        if self.in_sequence:
            points = [s for p, s in slots if s not in first and not (p.kind in ("P", "Pa") and s is p.slots[0])]
        for slot in (*held, *first, *points):
            self.slots[slot] = (self._name(k, slot, part_of[slot], own, order),)
            if slot.sort == "point" and (not order or order[-1] is not self.slots[slot][0]):
                order.append(self.slots[slot][0])
        for slot in rest:
            if slot not in self.slots:
                self.slots[slot] = self._direction(k, slot, part_of[slot], own, order)

    def _span_of(self, parts: Sequence[Part], k: int) -> tuple[Slot, Slot] | None:
        """The points before and after a slide, if it goes along their line."""
        values = parts[k].slots[0].values
        before = [s for p in parts[:k] for s in p.slots if s.sort == "point"]
        after = [s for p in parts[k + 1 :] for s in p.slots if s.sort == "point"]
        if before and after and self._along(values, before[-1].values, after[0].values):
            return before[-1], after[0]
        return None

    def _along(self, direction: Floats, start: Floats, end: Floats) -> bool:
        away = end - start
        lengths = np.linalg.norm(away, axis=1)
        if lengths.min() < _SAME * self.size:
            return False
        return self._same("direction", direction, away / lengths[:, None])

    def _direction(self, k: int, slot: Slot, part: Part, own: list[Known], order: Sequence[Known]) -> Named:
        if self.mirror or (part.kind in ("P", "Pa") and slot is part.slots[0]):
            for a, b in reversed([(a, b) for a, b in pairwise(order) if a is not b]):
                if self._along(slot.values, a.values, b.values):
                    return (a, b)
        return (self._name(k, slot, part, own, order),)

    def _name(self, k: int, slot: Slot, part: Part, own: list[Known], order: Sequence[Known]) -> Known:
        """The name of what has one already, or a new one with its relation."""
        shared = self.shared.get(slot)
        if shared is not None:
            if shared not in self.known and shared not in self.frame:
                self._add(shared, self._relation(slot, self.known, ()))
            shared = next((d for d in self.known if d.stem == shared.stem and d.limb < 0), shared)
            if shared not in own:
                own.append(shared)
            return shared
        if self.plane and slot.sort == "direction" and self._same("direction", slot.values, self.frame[2].values):
            return self.frame[2]
        for other in own:
            if other.sort == slot.sort and self._same_slot(other, slot):
                return other
        others = [*own, *(d for d in self.known if d not in own)] if self.level > 2 else own
        relation, parameters = self._relation(slot, others, order)
        stem = self._stem(slot, part, own)
        found = Known(stem, k, slot.sort, slot.values, relation, parameters, slot.length)
        self.known.append(found)
        own.append(found)
        return found

    def _add(self, shared: Known, relation: tuple[tuple[str | Known, ...], bool]) -> None:
        found = Known(shared.stem, -1, shared.sort, shared.values, *relation, shared.length)
        self.known.append(found)
        self.shared = {slot: found if one is shared else one for slot, one in self.shared.items()}

    def _stem(self, slot: Slot, part: Part, own: Sequence[Known]) -> str:
        letters = _POINTS if slot.sort == "point" else _AXES[part.kind] + _LETTERS
        taken = {d.stem for d in (*own, *self.shared.values())}
        return next((c for c in letters if c not in taken), f"{letters[0]}{len(own)}")

    # --- relations -------------------------------------------------------------------------------------------------

    def _relation(
        self, slot: Slot, others: Sequence[Known], order: Sequence[Known]
    ) -> tuple[tuple[str | Known, ...], bool]:
        """A relation with others that holds in all configurations, in words and names, and whether it leaves anything
        free, as it does of bars, whose length home has to say.
        """
        sort, values = slot.sort, slot.values
        directions = [d for d in others if d.sort == "direction"]
        if self.level > 1:
            directions += [d for d in self.frame if d in self.shared.values()]
        points = [d for d in others if d.sort == "point"]
        if sort == "point":
            if self.mirror and self._between(*self.mirror[:2], values):
                return ("in plane ", self.mirror[2], " perpendicular to ", *self.mirror[:2]), True
            if self.level and (found := self._fourth(values, points)):
                return found, False
            return (("free",) if self.plane else self._of_point(values, points, directions)), True
        if self.mirror and not slot.length and (image := self._image(values, directions)):
            return ("mirror of ", image, " in plane perpendicular to ", *self.mirror[:2]), False
        right: list[Named] = [(d,) for d in directions if self._perpendicular(values, d.values)]
        for a, b in pairwise(order):
            away = b.values - a.values
            lengths = np.linalg.norm(away, axis=1)
            if lengths.min() > _SAME * self.size and self._perpendicular(values, away / lengths[:, None]):
                right.append((a, b))
        for one, two in combinations(right, 2):
            if self._apart(one, two) and not slot.length:
                return ("perpendicular to ", *one, ", ", *two), False
        return (("perpendicular to ", *right[0]), True) if right else (("free",), True)

    def _fourth(self, values: Floats, points: Sequence[Known]) -> tuple[str | Known, ...]:
        """The last corner of a parallelogram that three points begin, if a point stays there."""
        for p, q, r in combinations(points, 3):
            for a, b, c in ((p, q, r), (q, r, p), (r, p, q)):
                if np.abs(a.values + b.values - c.values - values).max() < _SAME * self.size:
                    return a, " + ", b, " - ", c
        return ()

    def _image(self, values: Floats, directions: Sequence[Known]) -> Known | None:
        assert self.mirror is not None
        normal = self._unit(*self.mirror[:2])
        for d in directions:
            mirrored = d.values - 2 * normal * (normal * d.values).sum(axis=1, keepdims=True)
            if self._same("direction", mirrored, values):
                return d
        return None

    def _of_point(
        self, values: Floats, points: Sequence[Known], directions: Sequence[Known]
    ) -> tuple[str | Known, ...]:
        for p in points:
            for d in directions:
                if self._along(d.values, p.values, values):
                    return "on line ", p, " along ", d
        for p, q in self._lines(points):
            if self._along(self._unit(p, q), p.values, values):
                return "on line ", p, q
        for p in reversed(points):
            for d in directions:
                away = values - p.values
                if np.abs((away * d.values).sum(axis=1)).max() < _SAME * self.size:
                    return "in plane ", p, " perpendicular to ", d
        return ("free",)

    def _lines(self, points: Sequence[Known]) -> Iterator[tuple[Known, Known]]:
        for p, q in combinations(points, 2):
            if np.linalg.norm(p.values - q.values, axis=1).min() > _SAME * self.size:
                yield p, q

    @staticmethod
    def _unit(p: Known, q: Known) -> Floats:
        away = q.values - p.values
        found: Floats = away / np.linalg.norm(away, axis=1)[:, None]
        return found

    def _perpendicular(self, one: Floats, other: Floats) -> bool:
        return bool(np.abs((one * other).sum(axis=1)).max() < _SAME)

    def _apart(self, one: Named, two: Named) -> bool:
        first, second = (n[0].values if len(n) == 1 else self._unit(n[0], n[1]) for n in (one, two))
        return bool(np.linalg.norm(np.cross(first, second), axis=1).min() > 1e-3)
