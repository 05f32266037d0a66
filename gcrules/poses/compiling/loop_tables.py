r"""A robot's loops as plain tables, from which exported code closes them by Newton's method.

Lengths are in parts of the robot's size, so that all amounts and equations are of one kind. A motion has the one before
it and the twist that one unit of its amount makes; ratios of joints that follow others, and units, are in the twists.
Gaps are pairs of links that are to be one. The margin is the least singular value of a matrix: rows are what is
reciprocal to the twists of undriven joints, which lie between two links (`Hold`), in the frame of the platform, where
the balance of `margin` is constant. Where limbs have loops of their own it has a second block, for the twists of all
bodies, so that its least singular value is the lesser one of both.

>>> from gcrules.mechanisms.mechanism import mechanism
>>> tables = loop_tables(Solved.of(mechanism("5r"), np.zeros((1, 5))), ("x", "y"))
>>> tables.parents, tables.gaps, tables.coordinates, tables.rank
((-1, 0, 1, -1, 3), ((4, 2),), (0, 1), 5)
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cached_property

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.chains import Chain
from gcrules.mechanisms.kinematics.loops import Course, loop_rows, units_of
from gcrules.mechanisms.kinematics.margin import all_bodies_balance, balance, kept_axes
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.compiling.exact_places import at_home
from gcrules.poses.compiling.limb_factors import traced_factors
from gcrules.poses.compiling.roots import NoForm
from gcrules.poses.compiling.scalars import Graph
from gcrules.poses.compiling.tape import Operation, Program, lower
from gcrules.poses.compiling.vectors import Vector
from gcrules.poses.limbs.many import Solved
from gcrules.screws import RATIONALS
from gcrules.screws.pose_text import COORDINATES

__all__ = ["Carried", "Hold", "LoopTables", "loop_tables"]

_DEPENDENT = 1e-7  # of the largest singular value

Pairs = tuple[tuple[int, int], ...]


@dataclass(frozen=True)
class Hold:
    """Wrenches that hold a body: reciprocal to all twists of undriven joints, of this `rank`, in the way to the first
    link of each of the `pairs` less that to the second, −1 the base; `count` of them on the first pair. `end` is about
    what, from the origin, and `arm` from the centre of the ends, both with the platform at home. The `plus` and `minus`
    blocks of columns take them, −1 for none.
    """

    pairs: Pairs
    rank: int
    count: int
    end: tuple[float, ...]
    arm: tuple[float, ...]
    plus: int = 0
    minus: int = -1


@dataclass(frozen=True)
class Carried:
    """A point or direction at `home` (3,) that goes with a link, −1 the base."""

    link: int
    point: bool
    home: tuple[float, ...]


@dataclass(frozen=True, eq=False)
class LoopTables:
    """All that closes a robot's loops, and what is computed there.

    Motions have `parents`, the `amounts` that they take, of which there are `number`, and `twists` (ω; v); the link
    behind a motion has its number. `gaps` are pairs of links, `coordinates` the places of those asked for among
    x, y, z, roll, pitch, yaw, rx, ry, rz, about the `centre`, of the link `platform`; `rank` is that of the equations'
    slopes. `locked` amounts stay 0, `driven` ones are held. `actuators` are amounts, times `units` those of the file.

    `factors` is a program of the places of `places`, three numbers each, in the unit of the file; None where there are
    no factors. `holds` give rows of the wrenches, with the axes to `keep` in each block of columns; times `scale` their
    least singular value is the margin.
    """

    size: float
    number: int
    parents: tuple[int, ...]
    amounts: tuple[int, ...]
    twists: Floats
    gaps: Pairs
    coordinates: tuple[int, ...]
    platform: int
    centre: tuple[float, ...]
    rank: int
    locked: tuple[bool, ...]
    driven: tuple[bool, ...]
    actuators: tuple[int, ...]
    units: tuple[float, ...]
    factors: Program | None
    places: tuple[Carried, ...]
    holds: tuple[Hold, ...]
    keep: tuple[int, ...]
    scale: Floats

    @property
    def rows(self) -> int:
        """How many wrenches there are."""
        return sum(hold.count for hold in self.holds)

    @property
    def columns(self) -> int:
        """How many columns their matrix has."""
        return len(self.scale)


def loop_tables(solved: Solved, coordinates: Sequence[str]) -> LoopTables:
    """The tables of a robot whose pose is given by coordinates of the platform, by configurations of it near home, one
    at least. Raises InputError where it has no loops, and where its factors have no program.
    """
    m, k = solved.m, solved.m.linkage
    motions = _Motions(m)
    if not motions.gaps:
        raise InputError(f"{m.robot.id} has no loops", hint="code is written for parallel robots")
    named = _NamedPlaces(m, motions)
    try:
        factors = named.program
    except NoForm as fault:
        raise InputError(f"no program is known for the factors of {m.robot.id}: {fault}") from None
    units = units_of(k)
    actuators = tuple(motions.first[a.place] + a.coordinate for a in k.actuators)
    locked = {motions.first[place] + coordinate for place, coordinate, _ in k.locked}
    number = len(units)
    return LoopTables(
        k.size,
        number,
        motions.parents,
        motions.amounts,
        motions.twists,
        motions.gaps,
        tuple(map(COORDINATES.index, coordinates)),
        motions.link(0, -1),
        _row(k.centre / k.size),
        _rank(solved, coordinates),
        tuple(n in locked for n in range(number)),
        tuple(n in actuators for n in range(number)),
        actuators,
        _row(units[list(actuators)]),
        factors,
        tuple(named.carried.values()),
        tuple(_holds(m, motions)),
        tuple(kept_axes(k)),
        _scale(m),
    )


class _Motions:
    """The motions of all limbs one after the other."""

    def __init__(self, m: Limbs) -> None:
        self.chains = m.linkage.home.chains
        self.first = np.cumsum([0, *(len(c.turns) for c in self.chains)]).tolist()
        self.before = np.cumsum([0, *(len(c.uses) for c in self.chains)]).tolist()
        every = [(place, k) for place, c in enumerate(self.chains) for k in range(len(c.uses))]
        self.parents = tuple(self.link(place, self.chains[place].before[k]) for place, k in every)
        self.amounts = tuple(self.first[place] + self.chains[place].uses[k] for place, k in every)
        units, size = units_of(m.linkage), m.linkage.size
        screws = [self.chains[place].screws[k] * self.chains[place].signs[k] for place, k in every]
        self.twists = np.array(screws) * units[list(self.amounts), None] / np.array([1.0] * 3 + [size] * 3)

    def link(self, place: int, link: int) -> int:
        """The motion behind which a link of a limb lies, by its number there; −1 for the base."""
        chain = self.chains[place]
        if not chain.runs:
            own = link if link >= 0 else len(chain.uses)
            return self.before[place] + own - 1 if own else -1
        at = link if link >= 0 else chain.platform
        n, run = next((n, r) for n, r in enumerate(chain.runs) if r.first + n <= at <= r.stop + n)
        if at > run.first + n:
            return int(self.before[place] + at - n - 1)
        return self.link(place, run.base) if run.base else -1

    @property
    def gaps(self) -> Pairs:
        """As `loop_gaps` has them."""
        platform = self.link(0, -1)
        found = [(self.link(place, -1), platform) for place in range(1, len(self.chains))]
        return (*found, *(pair for place in range(len(self.chains)) for pair in self.loops(place)))

    def loops(self, place: int) -> Pairs:
        """Those of a limb's own."""
        return tuple((self.link(place, a), self.link(place, b)) for a, b in self.chains[place].loops)

    def span(self, place: int, coordinates: Sequence[int]) -> tuple[int, int]:
        """The links at the end and the start of a chain of a limb that has these coordinates."""
        chain: Chain = self.chains[place]
        for n, run in enumerate(chain.runs):
            if set(chain.uses[run.first : run.stop]) <= set(coordinates):
                return self.link(place, run.stop + n), self.link(place, run.base) if run.base else -1
        return self.link(place, -1), -1


class _NamedPlaces:
    """The places of names on a tape: inputs for what links carry, as many as are needed."""

    def __init__(self, m: Limbs, motions: _Motions) -> None:
        self.m, self.motions = m, motions
        self.home = at_home(m.linkage)
        self.definitions = {d.name: d for d in m.robot.family.definitions}
        riding = [n for n in self.home if self._link(n) >= 0]
        self.graph = Graph(3 * len(riding))
        self.inputs: dict[str, int] = {n: 3 * k for k, n in enumerate(riding)}
        self.known: dict[str, Vector] = {}
        self.carried: dict[str, Carried] = {}

    @property
    def sorts(self) -> Mapping[str, str]:
        """Those of the file's names."""
        return self.m.robot.family.sorts

    def _link(self, name: str) -> int:
        own = self.m.linkage.attachments.get(name)
        return self.motions.link(own[0].limb, own[0].link) if own and name in self.definitions else -1

    def at(self, name: str) -> Vector:
        """As `moved` has it."""
        if name not in self.known:
            self.known[name] = self._place(name)
        return self.known[name]

    def _place(self, name: str) -> Vector:
        if name in self.inputs:
            x, y, z = self.graph.inputs[self.inputs[name] : self.inputs[name] + 3]
            return x, y, z
        own = self.definitions.get(name)
        if own is None or own.parameters or name in self.m.linkage.attachments:
            return self.home[name]
        others = {n: self.at(n) for n in own.relation.names}
        return own.relation.value(own.sort, RATIONALS, others, ())

    @cached_property
    def program(self) -> Program | None:
        """That of the factors, of the places of those names alone that it needs (`carried`). What is constant is made
        of a place too, so that it is not a number where the pose is not reached.
        """
        if self.m.analysis.lines is None:
            return None
        whole = lower(self.graph, *traced_factors(self.m, self))
        if not whole.results:
            return None
        read = {line.args[0] // 3 for line in whole.lines if line.op == "input"}
        k = self.m.linkage
        for n in (n for n, at in self.inputs.items() if at // 3 in read):
            point = self.sorts[n] == "point"
            self.carried[n] = Carried(self._link(n), point, _row(k.home.values[n] / (k.size if point else 1.0)))
        places = {self.inputs[n] + c: 3 * at + c for at, n in enumerate(self.carried) for c in range(3)}
        lines = [replace(x, args=(places[x.args[0]],)) if x.op == "input" else x for x in whole.lines]
        if not self.carried:
            self.carried[""] = Carried(self.motions.link(0, -1), True, _row(k.centre / k.size))
        results: list[int | Fraction] = []
        for result in whole.results:
            if not isinstance(result, int):
                first = len(lines)
                nothing = Operation("scale", (first,), Fraction(0))
                lines += [Operation("input", (0,)), nothing, Operation("shift", (first + 1,), result)]
                result = first + 2
            results.append(result)
        return Program(3 * len(self.carried), tuple(lines), tuple(results))


def _holds(m: Limbs, motions: _Motions) -> Iterator[Hold]:
    k = m.linkage
    ends, arms = k.ends / k.size, (k.ends - k.ends.mean(axis=0)) / k.size
    for place, rank in enumerate(k.passive_ranks):
        pairs = ((motions.link(place, -1), -1), *motions.loops(place))
        count = k.elsewhere.applied[place][1] if len(pairs) > 1 else 6 - rank
        yield Hold(pairs, rank, count, _row(ends[place]), _row(arms[place]))
    for span in k.spans if k.looped else ():
        pair, rank = motions.span(span.limb, span.every), span.passive_rank
        blocks = (1 + b if b >= 0 else -1 for b in (span.end, span.start))
        yield Hold((pair,), rank, 6 - rank, _row(ends[span.limb]), _row(arms[span.limb]), *blocks)


def _scale(m: Limbs) -> Floats:
    """The balance of the margin, with that of all bodies in a further block."""
    k = m.linkage
    arms, keep = ((k.ends - k.ends.mean(axis=0)) / k.size)[None], kept_axes(k)
    first = balance(arms, k.ball_ended, keep)[0]
    if not k.looped:
        return np.asarray(first)
    second = all_bodies_balance(k, arms, keep)[0]
    found = np.zeros((len(first) + len(second),) * 2)
    found[: len(first), : len(first)], found[len(first) :, len(first) :] = first, second
    return found


def _rank(solved: Solved, coordinates: Sequence[str]) -> int:
    """The rank of the slopes of all equations by all amounts, the largest one of these configurations."""
    k, here = solved.m.linkage, solved.here
    course = Course(k, Target(tuple(coordinates), np.zeros(len(coordinates))))
    twists = [c.shared_twists for c in here.chains]
    rows = np.concatenate([loop_rows(twists, here.platform, k), course.rows(here.platform, twists)], axis=1)
    sizes = np.linalg.svd(rows * units_of(k), compute_uv=False)
    return int((sizes > _DEPENDENT * sizes[:, :1]).sum(axis=1).max())


def _row(v: Floats) -> tuple[float, ...]:
    return tuple(v.tolist())
