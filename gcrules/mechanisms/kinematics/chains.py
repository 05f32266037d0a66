r"""A limb as a chain of elementary motions: turns, slides and screws, each with one amount.

The platform's place is the product of their exponentials, in order from the base. Joints with several freedoms are
several motions. Bars that swing are pairs of opposite turns: with the turn of a bar about its near end and the same
turn back about its far end what the bar carries moves along a circle and keeps its orientation, as a parallelogram
does; so two motions may share one amount.

>>> from gcrules.mechanisms.description.limb_file import read_joints
>>> [m.name for joint in read_joints("R(A, z) Pa(A B, n)") for m in shape_of(joint.kind).motions]
['turn about the axis', 'swing', 'swing back']
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import cache, cached_property
from typing import Any

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.english import listed
from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.description.carriers import sample_of
from gcrules.mechanisms.description.limb_file import BASE, PLATFORM, JointSpec, LimbSpec
from gcrules.mechanisms.kinematics.rigid_motions import Floats, carried, crossed, exponential, lengths
from gcrules.screws import FLOATS, JOINTS, RATIONALS, JointKind

__all__ = ["Chain", "ElementaryMotion", "Run", "Shape", "chain_of", "geometry_of", "moved", "products", "shape_of"]

Values = Mapping[str, Floats]
"""Places of names, (3,) each; of many configurations at once where there are axes before."""

Geometry = Mapping[str, Any]


@dataclass(frozen=True)
class ElementaryMotion:
    """An elementary motion: the place of the joint's freedom whose amount it takes, with its sign, whether it turns (an
    angle) or slides (a length), and its screw made from the joint's geometry, directions of length 1 (bars excepted).
    """

    name: str
    freedom: int
    sign: int
    turns: bool
    screw: Callable[[Geometry], Floats]


@dataclass(frozen=True)
class Shape:
    """The motions of a kind of joint; `locked` are freedoms that have to stay at 0 for the joint to be one of its kind.
    On which of its links its parts ride is told by `riding` of the same kind.
    """

    motions: tuple[ElementaryMotion, ...]
    locked: tuple[int, ...] = ()
    kind: JointKind | None = None  # where the motions are its twists

    def screws(self, g: Geometry) -> Sequence[Floats]:
        """The screws of all motions."""
        return [m.screw(g) for m in self.motions] if self.kind is None else _rows(self.kind, g)


def _turn(point: Floats, axis: Floats) -> Floats:
    moment = crossed(point, axis)
    return np.concatenate([np.broadcast_to(axis, moment.shape), moment], axis=-1)


def _slide(axis: Floats) -> Floats:
    return np.concatenate([np.zeros_like(axis), axis], axis=-1)


def _across(axis: Floats, place: int) -> Floats:
    """One of two directions that are perpendicular to an axis and to each other."""
    first = _unit(crossed(axis, np.eye(3)[np.argmin(np.abs(axis), axis=-1)]))
    return first if place == 0 else crossed(axis, first)


def _unit(v: Floats) -> Floats:
    return np.asarray(v / lengths(v, keepdims=True))


def _about(point: str, axis: str) -> Callable[[Geometry], Floats]:
    return lambda g: _turn(g[point], g[axis])


def _swing(place: int, back: bool) -> Callable[[Geometry], Floats]:
    return lambda g: _turn(g["first"] + g["bars"] * back, _across(_unit(g["bars"]), place))


_OWN: Mapping[str, Shape] = FrozenMap(
    {
        "E": Shape(
            (
                ElementaryMotion("slide", 0, 1, False, lambda g: _slide(_across(g["normal"], 0))),
                ElementaryMotion("slide across", 1, 1, False, lambda g: _slide(_across(g["normal"], 1))),
                ElementaryMotion("turn", 2, 1, True, _about("point", "normal")),
            ),
        ),
        "Pa": Shape(
            (
                ElementaryMotion("swing", 0, 1, True, _about("near", "axis")),
                ElementaryMotion("swing back", 0, -1, True, _about("far", "axis")),
            ),
        ),
        "4S": Shape(
            (
                ElementaryMotion("swing", 0, 1, True, _swing(0, back=False)),
                ElementaryMotion("swing across", 1, 1, True, _swing(1, back=False)),
                ElementaryMotion(
                    "turn about the bar", 2, 1, True, lambda g: _turn(g["first"] + g["bars"], _unit(g["bars"]))
                ),
                ElementaryMotion("swing across, back", 1, -1, True, _swing(1, back=True)),
                ElementaryMotion("swing back", 0, -1, True, _swing(0, back=True)),
                ElementaryMotion(
                    "turn about the side",
                    3,
                    1,
                    True,
                    lambda g: _turn(g["first"] + g["bars"], _unit(g["second"] - g["first"])),
                ),
            ),
            locked=(2,),
        ),
    }
)
"""Kinds that move otherwise than by their twists one after the other: the slides of E are lengths; bars swing. The turn
of 4S about the bar is 0 wherever its bars are parallel; other places, where its twists are others, are refused. It
stands where the bar is, so that its axis goes with it.
"""


def shape_of(symbol: str) -> Shape:
    """How a kind of joint moves: by the twists of its row in `JOINTS`, one after the other from the base, unless it is
    one of those that move in a way of their own.
    """
    return _OWN.get(symbol) or _by_twists(JOINTS[symbol])


@cache
def _by_twists(kind: JointKind) -> Shape:
    twists = kind.twists(sample_of(kind), RATIONALS)
    motions = tuple(
        ElementaryMotion(freedom, n, 1, any(twists[n][:3]), _twist(kind, n)) for n, freedom in enumerate(kind.freedoms)
    )
    return Shape(motions, kind=kind)


def _twist(kind: JointKind, place: int) -> Callable[[Geometry], Floats]:
    return lambda g: _rows(kind, g)[place]


def _rows(kind: JointKind, g: Geometry) -> Sequence[Floats]:
    """The twists of a joint; those of one configuration from plain numbers, with which NumPy is slow."""
    several = any(np.ndim(v) > 1 for v in g.values())
    parts = {part: (v.T if several else v.tolist()) if isinstance(v, np.ndarray) else v for part, v in g.items()}
    made = FLOATS.matrix(kind.rows(FLOATS, parts))
    return [made[..., k, :] for k in range(made.shape[-2])]


def geometry_of(joint: JointSpec, values: Values) -> dict[str, Any]:
    """The parts of a joint in floats, with directions of length 1; bars keep the length that they have.

    Raises InputError for a direction that is zero.
    """
    found: dict[str, Any] = {}
    for (part, form), arg in zip(JOINTS[joint.kind].parts.items(), joint.args, strict=True):
        if not isinstance(arg, tuple):
            found[part] = float(arg)
            continue
        vector = sum((float(c) * values[n] for c, n in arg), np.zeros(3))
        if form == "direction":
            size = lengths(vector, keepdims=True)
            if size.min() <= 1e-12 * max(1e-300, *(float(np.abs(values[n]).max()) for _, n in arg)):
                raise InputError(f"the {part} of {joint} has no direction here: {listed(joint.names)} coincide")
            vector = vector if part == "bars" else vector / size
        found[part] = vector
    if joint.kind == "Pa":
        bars = joint.args[0]
        start = values[bars[1][1]] if isinstance(bars, tuple) and len(bars) == 2 else np.zeros(3)
        found |= {"near": start, "far": start + found["bars"]}
    return found


@dataclass(frozen=True)
class Run:
    """Motions of a limb, from the `first` to the one before `stop`, one after the other: they begin on the link `base`
    and end on a body. `reached` is the link by which an earlier run reaches the same body, -1 where there is none.
    """

    first: int
    stop: int
    base: int
    reached: int = -1


@dataclass(frozen=True, eq=False)
class Chain:
    """The motions of one limb where it is now: `screws` (..., K, 6), of many configurations at once where there are
    further axes, `uses` the coordinate that each takes, with `signs`, for joints that follow others times the ratio, in
    radians or lengths for each unit of the coordinate; `turns` tells of each coordinate whether it is an
    angle.

    A limb with bodies of its own has several `runs`; its links are those of all runs one after the other, each with the
    one on which it begins, and last the platform. `shares` (coordinates, 1 + loops) tells with which sign a coordinate
    counts in the platform's twist and in each loop, a run that leads to a body that is `reached` already.
    """

    screws: Floats
    uses: tuple[int, ...]
    signs: Floats
    turns: tuple[bool, ...]
    runs: tuple[Run, ...] = ()
    platform: int = -1
    shares: Floats | None = None

    def links(self, amounts: Floats) -> Floats:
        """Where each link goes from here, (..., K + 1, 4, 4), of several runs (..., K + runs + 1, 4, 4): first the
        base, last the platform.
        """
        steps = exponential(self.screws, self.signs * amounts[..., list(self.uses)])
        if not self.runs:
            return products(steps)
        made: list[Floats] = []
        for run in self.runs:
            own = products(steps[..., run.first : run.stop, :, :])
            placed = made[run.base][..., None, :, :] @ own if made and run.base else own
            made += [placed[..., k, :, :] for k in range(placed.shape[-3])]
        return np.stack([*made, made[self.platform]], axis=-3)

    @property
    def count(self) -> int:
        """How many links it has."""
        return int(self.screws.shape[-2]) + 1 + len(self.runs)

    @property
    def before(self) -> Sequence[int]:
        """The link on which each motion begins."""
        if not self.runs:
            return range(self.screws.shape[-2])
        return [k + n for n, run in enumerate(self.runs) for k in range(run.first, run.stop)]

    def way(self, link: int = -1) -> tuple[int, ...]:
        """The motions from the base to a link, one after the other; to the platform, if none is named."""
        if not self.runs:
            return tuple(range(self.screws.shape[-2]))[: link if link >= 0 else None]
        at = link if link >= 0 else self.platform
        n, run = next((n, r) for n, r in enumerate(self.runs) if r.first + n <= at <= r.stop + n)
        return (*(self.way(run.base) if run.base else ()), *range(run.first, at - n))

    @property
    def loops(self) -> tuple[tuple[int, int], ...]:
        """The links that are one in each loop: of the run that closes it, and of the body that is reached already."""
        return tuple((run.stop + n, run.reached) for n, run in enumerate(self.runs) if run.reached >= 0)

    def twists(self, links: Floats | None = None, motions: slice = slice(None)) -> Floats:
        """The twist of each coordinate, (..., 6, coordinates), where the links are, else here; of all motions, or what
        some of them have in it.
        """
        rows = self.screws if links is None else self._carried(links)
        return np.swapaxes(rows[..., motions, :], -1, -2) @ self.parts[motions]

    @property
    def shared_twists(self) -> Floats:
        """What each coordinate adds here to the platform's twist and to the gap of each loop, (..., 1 + loops, 6,
        coordinates).
        """
        every = self.twists()[..., None, :, :]
        return every if self.shares is None else every * self.shares.T[:, None]

    def after(self, links: Floats) -> Chain:
        """The chain as it stands where the links have gone."""
        return self.placed(self._carried(links))

    def placed(self, screws: Floats) -> Chain:
        """The same chain with its screws elsewhere."""
        found = Chain(screws, self.uses, self.signs, self.turns, self.runs, self.platform, self.shares)
        found.__dict__["parts"] = self.parts  # the same ones
        return found

    def _carried(self, links: Floats) -> Floats:
        return carried(links[..., :-1, :, :] if not self.runs else links[..., self.before, :, :], self.screws)

    @cached_property
    def parts(self) -> Floats:
        """The sign, or ratio, with which each motion takes each coordinate, (K, coordinates)."""
        found = np.zeros((len(self.uses), len(self.turns)))
        found[np.arange(len(self.uses)), list(self.uses)] = self.signs
        return found


def moved(chains: Sequence[Chain], amounts: Sequence[Floats]) -> tuple[list[Floats], list[Chain]]:
    """What `links` and `after` give of each chain for its amounts: chains with as many motions are moved at once."""
    links, screws = [np.empty(0)] * len(chains), [np.empty(0)] * len(chains)
    alike: dict[int, list[int]] = {}
    for k, chain in enumerate(chains):
        if chain.runs:
            links[k] = chain.links(amounts[k])
            screws[k] = chain.after(links[k]).screws
        else:
            alike.setdefault(len(chain.uses), []).append(k)
    for places in alike.values():
        every = np.stack([chains[k].screws for k in places], axis=-3)
        far = np.stack([chains[k].signs * amounts[k][..., list(chains[k].uses)] for k in places], axis=-2)
        made = products(exponential(every, far))
        there = carried(made[..., :-1, :, :], every)
        for n, k in enumerate(places):
            links[k], screws[k] = made[..., n, :, :, :], there[..., n, :, :]
    return links, [c.placed(s) for c, s in zip(chains, screws, strict=True)]


def products(steps: Floats) -> Floats:
    """The motions before, between and after K steps (..., K, 4, 4): (..., K + 1, 4, 4)."""
    number = steps.shape[-3]
    found = np.empty((*steps.shape[:-3], number + 1, 4, 4))
    found[..., 0, :, :] = np.eye(4)
    for k in range(number):
        found[..., k + 1, :, :] = found[..., k, :, :] @ steps[..., k, :, :]
    return found


def chain_of(limb: LimbSpec, values: Values) -> Chain:
    """The chain of a limb whose points and directions have these places. Raises InputError for lost directions."""
    screws: list[Floats] = []
    uses: list[int] = []
    signs: list[float] = []
    turns = [True] * limb.freedoms
    for k, (joint, own) in enumerate(zip(limb.joints, limb.coordinates, strict=True)):
        geometry = geometry_of(joint, values)
        ratio = limb.ratios.get(k)
        shape = shape_of(joint.kind)
        screws.extend(shape.screws(geometry))
        for m in shape.motions:
            uses.append(own[m.freedom])
            signs.append(m.sign if ratio is None else m.sign * float(ratio))
            if ratio is None:
                turns[own[m.freedom]] = m.turns
    several = np.broadcast_shapes(*(s.shape for s in screws))
    every = np.stack([np.broadcast_to(s, several) for s in screws], axis=-2)
    chain = Chain(every, tuple(uses), np.array(signs, dtype=float), tuple(turns))
    return _with_runs(chain, limb) if limb.subchains else chain


def _with_runs(chain: Chain, limb: LimbSpec) -> Chain:
    """The chain of a limb with bodies of its own."""
    runs: list[Run] = []
    reached = {BASE: 0}
    for own, joints in limb.parts:
        first = runs[-1].stop if runs else 0
        stop = first + sum(len(shape_of(j.kind).motions) for j in joints)
        runs.append(Run(first, stop, reached[own.start], reached.get(own.end, -1)))
        reached.setdefault(own.end, stop + len(runs) - 1)
    shares = np.zeros((limb.freedoms, 1 + limb.loops))
    for counted, places in zip(limb.shares, limb.coordinates, strict=True):
        shares[list(places)] = counted
    return replace(chain, runs=tuple(runs), platform=reached[PLATFORM], shares=shares)
