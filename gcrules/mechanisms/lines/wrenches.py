r"""From a limb to lines: the wrenches that it applies with its actuators locked, as lines through the robot's points.

A line is taken if it is reciprocal to all passive twists of the limb on several exact random members of the family:
then it is one of the limb's wrenches on all members (error below 1e-15 for each line that is wrongly taken).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.description.family import Family
from gcrules.mechanisms.description.limb_file import LimbSpec
from gcrules.mechanisms.description.relations import AXES
from gcrules.mechanisms.lines.derived import Derived, needed
from gcrules.mechanisms.lines.meets import meets
from gcrules.mechanisms.lines.names import (
    Key,
    Named,
    Sample,
    add_derived,
    crosswise,
    free_names,
    names_of_limb,
    names_of_others,
)
from gcrules.screws import RATIONALS, RESIDUES
from gcrules.screws.field import Row
from gcrules.screws.screw import join_of
from gcrules.screws.systems import ScrewSystem, reciprocal

__all__ = ["PLANAR", "LimbWrenches", "WrenchLine", "limb_wrenches", "reciprocal_to"]

PLANAR: tuple[Row, ...] = ((0, 0, 1, 0, 0, 0), (0, 0, 0, 1, 0, 0), (0, 0, 0, 0, 1, 0))
"""Wrenches that keep a body in the plane z = 0: every planar robot has them."""

_REAL_SEEDS = range(100)  # a kind that one member in eight does not have is told once in a million runs
_MOST = 11  # candidates among which a basis is chosen


@dataclass(frozen=True)
class WrenchLine:
    """The line through two points (or directions) of the robot as a wrench of a limb; a line of two directions is a
    couple. `role` is constraint (reciprocal to all twists of the limb) | actuation | both (where a limb's constraints
    are spanned by no lines of the robot's points: its other lines span actuations and constraints together).
    """

    ends: tuple[str, str]
    limb: str
    couple: bool
    role: str

    def row(self, points: Mapping[str, Row]) -> Row:
        """The wrench (f; m) of the line, modulo the prime, of homogeneous points."""
        return join_of(RESIDUES, *(points[n] for n in self.ends))

    def to_json(self) -> dict[str, object]:
        return {"line": list(self.ends), "kind": "couple" if self.couple else "force", "role": self.role}


@dataclass(frozen=True)
class LimbWrenches:
    """What a limb applies with locked actuators: the dimensions of its wrench system and of its part that holds without
    actuators, the lines that span it (None where no lines of the robot's points do), and the system in words at one
    member. `derived` are directions and points that the lines use and the file does not name.
    """

    limb: LimbSpec
    dimension: int
    constraints: int
    freedoms: int
    rank: int
    lines: tuple[WrenchLine, ...] | None
    kind: str
    derived: tuple[Derived, ...] = ()

    def to_json(self) -> dict[str, object]:
        return {
            "name": self.limb.name,
            "joints": list(self.limb.lines if self.limb.subchains else (j.text for j in self.limb.joints)),
            "couplings": [c.text for c in self.limb.couplings],
            "freedoms": self.freedoms,
            "constraints": self.constraints,
            "system": self.kind,
            "wrenches": None if self.lines is None else [line.to_json() for line in self.lines],
        }


def reciprocal_to(twists: Iterable[Row], wrench: Row) -> bool:
    """Whether a wrench has product zero with all twists, modulo the prime."""
    swapped = (*wrench[3:], *wrench[:3])
    return all(RESIDUES.dot(t, swapped) == 0 for t in twists)


def limb_wrenches(
    family: Family,
    limb: LimbSpec,
    place: int,
    at: Sequence[Sample],
    one: Mapping[Key, str],
    shared: Mapping[str, int],
    home: Sample | None,
    lost: Sequence[Sample] = (),
) -> LimbWrenches:
    """The wrenches of one limb. `one` names each direction (see `directions`); `shared` says in how many limbs a name
    stands: such points are preferred. So are lines that do not depend on each other at `home`. Where wrenches are
    `lost` only lines are taken that depend on each other there.
    """
    every = at if home is None else (*at, home)
    own = [s.limbs[place] for s in at]
    all_twists = [one.system(RESIDUES).basis for one in own]
    passive = [[one.locked_system(RESIDUES).reciprocal().basis for one in own]]
    if limb.subchains:  # each line with the one actuator that it belongs to
        passive = [[reciprocal(one.locked_by(k, RESIDUES), RESIDUES) for one in own] for k in range(limb.actuators)]
    system, constraint = own[0].locked_system(RESIDUES), own[0].constraint_system(RESIDUES)
    trivial = PLANAR if family.plane else ()
    wanted = system.dimension - len(trivial)
    held = constraint.dimension - len(trivial)
    found: tuple[WrenchLine, ...] | None = None
    made: list[Derived] = []
    for names in _names(family, limb, at, one, made, (*every, *lost)):
        candidates = _candidates(limb, names, at, all_twists, passive, shared)
        fewer = [s.points for s in lost]
        found = _basis(candidates, [s.points for s in every[:: len(at)]], wanted, held, trivial, fewer)
        if found is not None:
            break
    lines, derived = (None, ()) if found is None else _named(family, place, every, found, made)
    if lines is not None and sum(line.role == "constraint" for line in lines) < held:
        lines = tuple(replace(line, role="both") if line.role == "actuation" else line for line in lines)
    return LimbWrenches(
        limb,
        wanted,
        held,
        limb.freedoms,
        at[0].limbs[place].rank(RESIDUES),
        lines,
        _kind(system, family) if lines is not None else _real_kind(family, limb),
        derived,
    )


def _names(
    family: Family,
    limb: LimbSpec,
    at: Sequence[Sample],
    one: Mapping[Key, str],
    made: list[Derived],
    every: Sequence[Sample],
) -> Iterator[list[Named]]:
    """Names through which lines may go: those of the limb; then with directions u × (u × v), with names of other limbs,
    or with where planes of its axes meet. What is derived is added to `made`, and to the points of `every` sample.
    """
    own = names_of_limb(family, limb, at, one)
    further: tuple[Callable[[], list[Named]], ...] = (
        lambda: own,
        lambda: crosswise(limb, tuple(made), at, one),
        lambda: names_of_others(family, own, one),
        lambda: meets(family, limb, at, one),
    )
    for more in further:
        names = more()
        new = [d for _, _, d in names if d]
        add_derived(new, every)
        made += new
        yield names if names is own else [*own, *names]


def _named(
    family: Family, place: int, at: Sequence[Sample], lines: Sequence[WrenchLine], made: Sequence[Derived]
) -> tuple[tuple[WrenchLine, ...], tuple[Derived, ...]]:
    """The lines, and what they use of what was made, under names of their own: n1 for directions, p1 for points."""
    ends = {n for line in lines for n in line.ends}
    used = needed(made, ends)
    stems = {False: free_names(family, f"n{place + 1}"), True: free_names(family, f"p{place + 1}")}
    new = {d.name: next(stems[d.is_point]) for d in sorted(used, key=lambda d: d.name not in ends)}
    for s in at:
        s.points.update({name: s.points[d] for d, name in new.items()})
    pairs = [(new.get(a, a), new.get(b, b)) for a, b in (line.ends for line in lines)]
    renamed = tuple(replace(line, ends=pair) for line, pair in zip(lines, pairs, strict=True))
    return renamed, tuple(d.renamed(new) for d in used)


PLANE: tuple[Row, ...] = ((1, 0, 0, 0, 0, 0), (0, 1, 0, 0, 0, 0), (0, 0, 0, 0, 0, 1))
"""Forces in the plane z = 0 and the couple normal to it: what acts on a planar robot."""


def _kind(system: ScrewSystem, family: Family) -> str:
    """Of a planar robot only the part in the plane counts."""
    part = system & ScrewSystem.span(PLANE, system.field) if family.plane else system
    return part.classify().kind


def _real_kind(family: Family, limb: LimbSpec) -> str:
    """The kind of the system at rational members: residues have square roots that rational numbers have not. Where
    members differ, only its dimension is said; they are drawn until two do.
    """
    members = (limb.at(family.member(seed, RATIONALS, decides=True), RATIONALS) for seed in _REAL_SEEDS)
    one = next(members)
    system = one.locked_system(RATIONALS)
    kind = _kind(system, family)
    if any(_kind(other.locked_system(RATIONALS), family) != kind for other in members):
        kind = f"{system.dimension}-system of screws"
    held = one.constraint_system(RATIONALS)
    if held.dimension == 1 and held.classify().kind not in ("force", "couple"):
        return f"{kind}, its constraint a screw of finite pitch"
    return kind


_Costly = tuple[float, WrenchLine]


def _candidates(
    limb: LimbSpec,
    names: Sequence[Named],
    at: Sequence[Sample],
    twists: Sequence[Sequence[Row]],
    passive: Sequence[Sequence[Sequence[Row]]],
    shared: Mapping[str, int],
) -> list[tuple[float, WrenchLine]]:
    """Lines through two of the points that are wrenches of the limb at all members, cheapest first: reciprocal to all
    its passive twists, one of several such systems.
    """
    found: list[tuple[float, WrenchLine]] = []
    for (a, cost_a, _), (b, cost_b, _) in combinations(names, 2):
        first = join_of(RESIDUES, at[0].points[a], at[0].points[b])
        if not any(first) or not any(reciprocal_to(own[0], first) for own in passive):
            continue
        rows = [first, *(join_of(RESIDUES, s.points[a], s.points[b]) for s in at[1:])]
        if all(map(any, rows)) and any(all(map(reciprocal_to, own, rows)) for own in passive):
            couple = at[0].points[a][3] == at[0].points[b][3] == 0
            role = "constraint" if all(map(reciprocal_to, twists, rows)) else "actuation"
            cost = cost_a + cost_b - 0.4 * sum(shared.get(n, 0) > 1 for n in (a, b))
            found.append((cost, WrenchLine((a, b), limb.name, couple, role)))
    return sorted(_bundles_along_axes(found, at[0].points), key=lambda c: c[0])


def _bundles_along_axes(found: list[_Costly], points: Mapping[str, Row]) -> list[_Costly]:
    """Where all forces through a point are wrenches, those along the axes of the frame stand for all directions: in
    others the bracket of the three lines would vanish where they happen to be parallel to one plane.
    """
    ends = {line.ends for _, line in found}
    full = {p for p, _ in ends if points[p][3] and all((p, axis) in ends for axis in AXES)}
    far = {n for pair in ends for n in pair if not points[n][3]} - set(AXES)
    return [(c, line) for c, line in found if not (full & set(line.ends) and far & set(line.ends))]


def _basis(
    candidates: Sequence[tuple[float, WrenchLine]],
    at: Sequence[Mapping[str, Row]],
    size: int,
    constraints: int,
    trivial: tuple[Row, ...],
    fewer: Sequence[Mapping[str, Row]] = (),
) -> tuple[WrenchLine, ...] | None:
    """Lines that span the system at the first sample: constraints told apart, if possible so that they span it at the
    other ones too, with as few points as possible, and of least cost; where there are `fewer` they do not.
    """
    kept: list[tuple[float, WrenchLine]] = []
    spanned = len(trivial)
    rows: list[Row] = list(trivial)
    for cost, line in candidates:  # the cheapest basis, and further cheap lines beside it
        row = line.row(at[0])
        grows = spanned < size + len(trivial) and RESIDUES.rank([*rows, row]) > spanned
        if grows:
            rows.append(row)
            spanned += 1
        if grows or len(kept) < _MOST:
            kept.append((cost, line))
    if spanned < size + len(trivial):
        return None
    best: tuple[tuple[float, ...], tuple[WrenchLine, ...]] | None = None
    for some in combinations(kept, size):
        checkpoint()
        lines = tuple(line for _, line in some)
        held = min(sum(line.role == "constraint" for line in lines), constraints)
        number = len({n for line in lines for n in line.ends})
        score: tuple[float, ...] = (-held, -size - len(trivial), number, sum(cost for cost, _ in some))
        if best is not None and score >= best[0]:
            continue
        ranks = [RESIDUES.rank([*trivial, *(line.row(points) for line in lines)]) for points in at]
        score = (-held, -min(ranks), *score[2:])
        if ranks[0] < size + len(trivial) or (best is not None and score >= best[0]):
            continue
        if all(
            RESIDUES.rank([*trivial, *(line.row(points) for line in lines)]) < size + len(trivial) for points in fewer
        ):
            best = score, lines
    return best[1] if best else None if fewer else ()
