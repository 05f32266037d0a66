r"""The equivalent structure: six lines that span all wrenches of the limbs, and what is special about their points."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations, product
from typing import Any

from gcrules.algebra.expr import Point
from gcrules.algebra.space import Assumption
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.description.family import Family
from gcrules.mechanisms.description.limb_file import LimbSpec
from gcrules.mechanisms.description.relations import AXES, Values
from gcrules.mechanisms.lines.derived import Derived, in_words, needed, with_derived
from gcrules.mechanisms.lines.names import Sample, directions, home_sample, key, sample, samples
from gcrules.mechanisms.lines.wrenches import PLANAR, LimbWrenches, WrenchLine, limb_wrenches, reciprocal_to
from gcrules.screws import RESIDUES, Field
from gcrules.screws.field import Row

__all__ = ["FRAME", "Equivalent", "equivalent"]

FRAME = "frame"
"""Stands for the limb of a line that all limbs together hold, and no single one."""


@dataclass(frozen=True)
class Equivalent:
    """Lines as pairs of points, six in space or three in the plane (fewer where `rank` says that the robot is always
    singular); None in place of `lines` where a limb's wrenches are no lines.

    `ideal` are the points at infinity, `given` brackets of points that vanish in the whole family, `derived` directions
    and points made from those of the file. `mobility` = 6 − rank of the constraints (3 − in the plane), `over` the
    number of constraints of the platform that are there twice, `inner` of those that close the loops within limbs,
    `idle` the motions inside limbs that leave the platform at rest, `rank` that of all wrenches, `redundant` the number
    of actuators beyond the freedoms.
    """

    limbs: tuple[LimbWrenches, ...]
    lines: tuple[WrenchLine, ...] | None
    mobility: int
    over: int
    idle: int
    rank: int
    ideal: tuple[str, ...] = ()
    given: tuple[tuple[str, ...], ...] = ()
    derived: tuple[Derived, ...] = ()
    redundant: int = 0
    inner: int = 0

    @property
    def overconstraints(self) -> int:
        """All constraints that are there twice: 6 (3 in the plane) for each independent loop, less the freedoms of the
        joints, and those of the robot with its idle ones again.
        """
        return self.over + self.inner

    @property
    def legs(self) -> tuple[tuple[str, str], ...]:
        """The lines as pairs of names."""
        return tuple(line.ends for line in self.lines or ())

    @property
    def drawn(self) -> tuple[WrenchLine, ...]:
        """The lines; where there are more actuators than freedoms, those of all limbs that need no more names."""
        if not self.redundant or self.lines is None:
            return self.lines or ()
        apart = {d.name for limb in self.limbs for d in limb.derived} - {d.name for d in self.derived}
        every = [line for limb in self.limbs for line in limb.lines or () if not apart.intersection(line.ends)]
        return tuple({line.ends: line for line in (*self.lines, *every)}.values())

    @property
    def incidences(self) -> tuple[Assumption, ...]:
        """`given` as assumptions; their text is that of the language."""
        kinds = (("coplanar" if len(some) == 4 else "collinear", some) for some in self.given)
        return tuple(Assumption(kind, tuple(map(Point, some)), f"{kind}({', '.join(some)})") for kind, some in kinds)

    @property
    def named(self) -> tuple[tuple[str, str], ...]:
        """Derived names through which lines go, with what they are in words: the direction u × v."""
        ends = {n for leg in self.legs for n in leg}
        return tuple((d.name, in_words(self.derived, d.name)) for d in self.derived if d.name in ends)

    @property
    def names(self) -> tuple[str, ...]:
        """All names that the lines and what is derived for them use."""
        every = [n for leg in self.legs for n in leg] + [n for d in self.derived for n in d.names]
        return tuple(dict.fromkeys(every))

    def points(self, family: Family, values: Values, field: Field = RESIDUES) -> dict[str, Row]:
        """Homogeneous coordinates of all points at a member in this field, derived ones among them."""
        return family.homogeneous(values) | with_derived(self.derived, values, field)

    def to_json(self) -> dict[str, object]:
        return {
            "legs": [list(leg) for leg in self.legs],
            "ideal": list(self.ideal),
            "given": [str(a) for a in self.incidences],
            "derived points": dict(self.named),
        }


def equivalent(
    family: Family,
    limbs: Sequence[LimbSpec],
    home: Mapping[str, Any] | None = None,
    *,
    frame: bool = True,
    lost: Mapping[str, Sequence[Values]] | None = None,
) -> Equivalent:
    """Choose the equivalent structure of a robot on exact random members of its family.

    Where lines can be chosen, those are that do not depend on each other at `home` (coordinates of all points and
    directions), so that the condition holds near it. With `frame` constraints that limbs have in common may be replaced
    by lines that all limbs together hold. `lost` are members at which a limb, by its name, has fewer wrenches than
    elsewhere: lines of it are chosen that depend on each other there.
    """
    at, here = samples(family, limbs), home_sample(family, limbs, home)
    one = directions(family, at)
    name = {n: one[key(s.values[n] for s in at)] if sort == "direction" else n for n, sort in family.sorts.items()}
    shared = Counter(n for limb in limbs for n in {name[n] for j in limb.joints for n in j.names} | set(limb.through))
    fewer = {n: tuple(sample(family, limbs, v) for v in own) for n, own in (lost or {}).items()}
    found = _alike(
        [
            limb_wrenches(family, limb, place, at, one, shared, here, fewer.get(limb.name, ()))
            for place, limb in enumerate(limbs)
        ]
    )
    trivial = PLANAR if family.plane else ()
    full = 6 - len(trivial)
    held = [row for limb in at[0].limbs for row in limb.constraints(RESIDUES)]
    mobility = 6 - RESIDUES.rank([*trivial, *held])
    every = [row for limb in at[0].limbs for row in limb.locked(RESIDUES)]
    result = Equivalent(
        limbs=found,
        lines=None,
        mobility=mobility,
        over=sum(limb.constraints for limb in found) - (full - mobility),
        idle=sum(limb.freedoms - limb.rank for limb in found),
        rank=RESIDUES.rank([*trivial, *every]) - len(trivial),
        redundant=sum(limb.actuators for limb in limbs) - mobility,
        inner=sum(full * (1 + limb.loops) - own.rank - own.constraints for limb, own in zip(limbs, found, strict=True)),
    )
    if any(limb.lines is None for limb in found) or result.rank < full:
        return result
    constraints = [line for limb in found for line in limb.lines or () if line.role == "constraint"]
    if len(constraints) > full - mobility:
        names = [limb.name for limb in limbs]
        constraints = _over_constrained(family, names if frame else (), constraints, at, here, full - mobility, trivial)
    rest = [line for limb in found for line in limb.lines or () if line.role != "constraint"]
    lines = _independent(constraints, rest, at[0], here, full, trivial)
    if len(lines) < full:
        return result
    order = {limb.limb.name: place for place, limb in enumerate(found)}
    lines.sort(key=lambda line: order.get(line.limb, -1))
    used = dict.fromkeys(n for line in lines for n in line.ends)
    return replace(
        result,
        lines=tuple(lines),
        ideal=tuple(n for n in used if at[0].points[n][3] == 0),
        given=tuple(_incidences(family, tuple(used), at)),
        derived=tuple(d for limb in found for d in needed(limb.derived, used)),
    )


def _alike(limbs: Sequence[LimbWrenches]) -> tuple[LimbWrenches, ...]:
    """Limbs of the same joints under one description, the most general one, where no lines span their wrenches."""
    kinds: dict[tuple[str, int, int], str] = {}
    for one in limbs:
        alike = one.limb.chain, one.dimension, one.constraints
        if one.lines is None and (alike not in kinds or "-system" in one.kind):
            kinds[alike] = one.kind
    return tuple(
        one if one.lines is not None else replace(one, kind=kinds[one.limb.chain, one.dimension, one.constraints])
        for one in limbs
    )


def _over_constrained(
    family: Family,
    names: Sequence[str],
    lines: Sequence[WrenchLine],
    at: Sequence[Sample],
    home: Sample | None,
    size: int,
    trivial: tuple[Row, ...],
) -> list[WrenchLine]:
    """A basis of the constraints of all limbs together. Lines through fixed directions of the frame are preferred, so
    that what depends on the choice of some limbs does not appear in the condition; without `names` of limbs there are
    none.
    """
    twists = [RESIDUES.kernel([(*r[3:], *r[:3]) for r in _constraints(s)]) for s in at]
    finite = [n for n in dict.fromkeys(n for line in lines for n in line.ends) if at[0].points[n][3]]
    frame = []
    for a, b in [*combinations(AXES, 2), *product(finite, AXES)] if names and not family.plane else ():
        line = WrenchLine((a, b), FRAME, a in AXES, "constraint")
        rows = [line.row(s.points) for s in at]
        if all(map(reciprocal_to, twists, rows)):
            every = [[limb.system(RESIDUES).basis for limb in s.limbs] for s in at]
            own = (n for n, *alike in zip(names, *every, strict=True) if all(map(reciprocal_to, alike, rows)))
            frame.append(replace(line, limb=next(own, FRAME)))
    fixed = {*AXES, *finite}

    def moving(line: WrenchLine) -> tuple[int, int]:
        return sum(n not in fixed for n in line.ends), sum(n not in AXES for n in line.ends)

    return _independent((), sorted((*lines, *frame), key=moving), at[0], home, size, trivial)


def _independent(
    first: Sequence[WrenchLine],
    lines: Sequence[WrenchLine],
    at: Sample,
    home: Sample | None,
    size: int,
    trivial: tuple[Row, ...],
) -> list[WrenchLine]:
    """The `first` lines and, as far as `size`, further ones: those that are independent at home too before others."""
    chosen, rows = list(first), {s: [*trivial, *(one.row(s.points) for one in first)] for s in (at, home) if s}
    for every in ((at, home), (at,)):
        for line in lines:
            new = {s: [*rows[s], line.row(s.points)] for s in rows}
            if len(chosen) < size and all(RESIDUES.rank(new[s]) == len(new[s]) for s in every if s):
                chosen.append(line)
                rows = new
    return chosen


def _constraints(one: Sample) -> list[Row]:
    return [row for limb in one.limbs for row in limb.constraints(RESIDUES)]


def _incidences(family: Family, names: tuple[str, ...], at: Sequence[Sample]) -> Iterator[tuple[str, ...]]:
    """Points that lie on one line or in one plane (in the plane: on one line) in the whole family, points at infinity
    apart; planes that follow from the lines are left out.
    """
    keep = (0, 1, 3) if family.plane else (0, 1, 2, 3)

    def rank(some: Iterable[str]) -> int:
        return max(RESIDUES.rank([[s.points[n][i] for i in keep] for n in some]) for s in at)

    def finite(some: Iterable[str]) -> bool:
        return any(at[0].points[n][3] for n in some)

    lines = set()
    for some in combinations(names, 3):
        checkpoint()
        if finite(some) and rank(some) < 3:
            lines.add(frozenset(some))
            yield some

    def crossing(a: str, b: str, c: str, d: str) -> bool:
        return any({a, b, x} in lines and {c, d, x} in lines for x in names)

    for a, b, c, d in combinations(names, 4) if not family.plane else ():
        checkpoint()
        follows = any(line < {a, b, c, d} for line in lines)
        follows = follows or crossing(a, b, c, d) or crossing(a, c, b, d) or crossing(a, d, b, c)
        if not follows and finite((a, b, c, d)) and rank((a, b, c, d)) < 4:
            yield a, b, c, d
