"""The limbs between base and platform as chains of motions; two equal bars side by side are one joint Pa or 4S."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import networkx as nx
import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.models.motions import Motion

__all__ = ["Bars", "Chain", "Item", "Poses", "limbs_between", "pairs_of_bars", "placed"]

Poses = Sequence[Mapping[str, Floats]]
"""How bodies have moved from home, in several configurations of which home is the first."""

_SAME = 1e-7


@dataclass(frozen=True, eq=False)
class Bars:
    """Two parallel bars of one length between two bodies, in a plane (Pa) or with ball ends (4S): their joints at the
    `start`, and at the `end`.
    """

    kind: str
    start: str
    end: str
    near: tuple[Motion, Motion]
    far: tuple[Motion, Motion]
    inner: tuple[Motion, ...] = ()  # all motions of it
    driven: bool = False

    @property
    def joint(self) -> str:
        return self.near[0].joint

    def backwards(self) -> Bars:
        return replace(self, start=self.end, end=self.start, near=self.far, far=self.near)


Item = Motion | Bars


@dataclass(frozen=True, eq=False)
class Chain:
    """Motions and bars one after the other, from one body to another."""

    start: str
    end: str
    items: tuple[Item, ...]

    def backwards(self) -> Chain:
        return Chain(self.end, self.start, tuple(item.backwards() for item in reversed(self.items)))

    def between(self, start: str, end: str) -> Chain | None:
        """The chain in this sense, if it joins these bodies."""
        if (self.start, self.end) == (start, end):
            return self
        return self.backwards() if (self.end, self.start) == (start, end) else None


def placed(poses: Poses, body: str, point: Floats) -> Floats:
    """Where a point of a body is in each configuration, (n, 3)."""
    return np.array([(at[body] @ [*point, 1.0])[:3] for at in poses])


def limbs_between(motions: Sequence[Motion], base: str, platform: str, poses: Poses) -> list[list[Chain]]:
    """Each limb as its chains, a limb being what is connected without base and platform; in the sequence of the
    motions. Each chain begins at a body that those before it reach, the first ones at the base.
    """
    found = []
    for places in _hung(motions, base, platform):
        chains = _reduced(list(_chains([motions[k] for k in places], base, platform)), (base, platform), poses)
        found.append((places[0], _from_base(chains, base, platform)))
    return [chains for _, chains in sorted(found, key=lambda one: one[0])]


def _hung(motions: Sequence[Motion], base: str, platform: str) -> Iterator[list[int]]:
    """The numbers of the motions of each limb."""
    hung: nx.Graph[Any] = nx.Graph()
    for k, m in enumerate(motions):
        hung.add_node(k)
        hung.add_edges_from((k, body) for body in (m.start, m.end) if body not in (base, platform))
    for nodes in nx.connected_components(hung):
        yield sorted(k for k in nodes if isinstance(k, int))


def _chains(motions: Sequence[Motion], base: str, platform: str) -> Iterator[Chain]:
    """What leads between base, platform and bodies of three joints or more."""
    ends: dict[str, list[int]] = {}
    for k, m in enumerate(motions):
        ends.setdefault(m.start, []).append(k)
        ends.setdefault(m.end, []).append(k)
    hubs = {body for body, own in ends.items() if len(own) > 2} | {base, platform}
    used: set[int] = set()
    for hub in (base, *sorted(hubs - {base})):
        for first in ends.get(hub, ()):
            here, k, items = hub, first, []
            while k not in used:
                used.add(k)
                m = motions[k] if motions[k].start == here else motions[k].backwards()
                items.append(m)
                here = m.end
                if here not in hubs:
                    k = next((other for other in ends[here] if other != k), k)
            if items:
                yield Chain(hub, here, tuple(items))


def _reduced(chains: list[Chain], ends: tuple[str, str], poses: Poses) -> list[Chain]:
    """With equal bars as one joint, as far as that goes."""
    while True:
        for make in (_paired, _joined):
            found = make(chains, ends, poses)
            if found is not None:
                chains = found
                break
        else:
            return chains


def _paired(chains: list[Chain], ends: tuple[str, str], poses: Poses) -> list[Chain] | None:
    for k, one in enumerate(chains):
        for other in chains[:k]:
            second = other.between(one.start, one.end)
            bars = _bars(second, one, poses) if second else None
            items = (bars,) if bars else _crossed(second, one, poses) if second else None
            if items is not None:
                rest = [c for c in chains if c is not one and c is not other]
                return [*rest, Chain(one.start, one.end, items)]
    return None


def _crossed(one: Chain, other: Chain, poses: Poses) -> tuple[Item, ...] | None:
    """Two bars with crosses at both ends, those of each side about one line: where the crosses of a side turn together
    in all configurations, they are one hinge, a parallelogram, and one hinge.
    """
    ours = [i for i in one.items if isinstance(i, Motion) and i.kind == "R" and not i.driven]
    theirs = [i for i in other.items if isinstance(i, Motion) and i.kind == "R" and not i.driven]
    if not len(ours) == len(theirs) == len(one.items) == len(other.items) == 4:
        return None
    (first, near, far, last), (second, *between, third) = ours, theirs
    if not (_on_one_line(first, second) and _on_one_line(last, third)):
        return None
    for at in poses:
        if max(np.abs(at[m.end] - at[n.end]).max() for m, n in ((first, second), (far, between[1]))) > _SAME:
            return None
    beside = (replace(between[0], start=first.end), replace(between[1], end=last.start))
    bars = _bars(Chain(first.end, last.start, (near, far)), Chain(first.end, last.start, beside), poses)
    return None if bars is None else (first, replace(bars, inner=(near, far, *theirs)), last)


def _on_one_line(one: Motion, other: Motion) -> bool:
    away = np.cross(other.at - one.at, one.axis)
    size = 1 + float(np.linalg.norm(other.at - one.at))
    return bool(np.linalg.norm(np.cross(one.axis, other.axis)) < _SAME and np.linalg.norm(away) < _SAME * size)


def _joined(chains: list[Chain], ends: tuple[str, str], poses: Poses) -> list[Chain] | None:
    """Two chains that meet at a body where nothing else is, as one."""
    beside: dict[str, list[Chain]] = {}
    for c in chains:
        for body in (c.start, c.end):
            beside.setdefault(body, []).append(c)
    for body, own in beside.items():
        if body not in ends and len(own) == 2 and own[0] is not own[1]:
            into = own[0] if own[0].end == body else own[0].backwards()
            out = own[1] if own[1].start == body else own[1].backwards()
            rest = [c for c in chains if c not in own]
            return [*rest, Chain(into.start, out.end, (*into.items, *out.items))]
    return None


def _bars(one: Chain, other: Chain, poses: Poses) -> Bars | None:
    """Two chains as the bars of a joint, if they stay parallel and of one length in all configurations."""
    found = _as_bars(one, other)
    if found is None:
        return None
    near, second = found.near
    far, last = found.far
    size = max(float(np.linalg.norm(m.at - near.at)) for m in found.inner)
    vectors = [placed(poses, one.end, f.at) - placed(poses, one.start, n.at) for n, f in ((near, far), (second, last))]
    feet = placed(poses, one.start, second.at) - placed(poses, one.start, near.at)
    apart = vectors[1] - vectors[0]
    if found.kind == "Pa":  # what lies along the axes is nothing in the plane of the bars
        axes = np.array([at[one.start][:3, :3] @ near.axis for at in poses])
        apart = apart - axes * (apart * axes).sum(axis=1, keepdims=True)
        feet = feet - axes * (feet * axes).sum(axis=1, keepdims=True)
    if np.abs(apart).max() > _SAME * size or np.linalg.norm(np.cross(feet[0], vectors[0][0])) < _SAME * size**2:
        return None
    return found


def _as_bars(one: Chain, other: Chain, least: int = 5) -> Bars | None:
    """Two chains that each hold no more than a length between two points, or two hinges, whatever the lengths are; with
    `least` 4 also bars with crosses at both ends.
    """
    if not all(isinstance(i, Motion) for c in (one, other) for i in c.items):
        return None
    motions = [i for c in (one, other) for i in c.items if isinstance(i, Motion)]
    driven = any(m.driven for m in motions)
    if all(len(c.items) == 2 and {m.kind for m in motions} == {"R"} for c in (one, other)):
        if sum(m.driven for m in motions) > 1:
            return None
        if any(np.linalg.norm(np.cross(m.axis, motions[0].axis)) > _SAME for m in motions):
            return None
        near, far, second, last = motions
        return Bars("Pa", one.start, one.end, (near, second), (far, last), tuple(motions), driven)
    ends = [_ball_ends(c, least) for c in (one, other)]
    if driven or ends[0] is None or ends[1] is None:
        return None
    (near, far), (second, last) = ends[0], ends[1]
    return Bars("4S", one.start, one.end, (near, second), (far, last), tuple(motions))


def pairs_of_bars(motions: Sequence[Motion], base: str, platform: str) -> Iterator[Bars]:
    """Two chains between the same two bodies that could be the bars of a joint, if they have one length."""
    for places in _hung(motions, base, platform):
        chains = list(_chains([motions[k] for k in places], base, platform))
        for k, one in enumerate(chains):
            for other in chains[:k]:
                second = other.between(one.start, one.end)
                bars = _as_bars(second, one, 4) if second else None
                if bars is not None:
                    yield bars


def _ball_ends(chain: Chain, least: int) -> tuple[Motion, Motion] | None:
    """The joints at the ends of a bar that have so many freedoms. With 5 of them the bar holds a length alone: ball
    joints, of which one may be a cross, which leaves out the spin of the bar; several turns through one point are such
    a joint.
    """
    motions = tuple(i for i in chain.items if isinstance(i, Motion))
    for k in range(1, len(motions)):
        near, far = _end(*motions[:k]), _end(*motions[k:])
        if near is not None and far is not None and near[1] + far[1] >= least:
            return near[0], far[0]
    return None


def _end(*motions: Motion) -> tuple[Motion, int] | None:
    """A ball joint, or two or three turns whose axes meet, with its freedoms."""
    if len(motions) == 1 and motions[0].kind == "S":
        return motions[0], 3
    if len(motions) not in (2, 3) or any(m.kind != "R" for m in motions):
        return None
    one, two = motions[:2]
    normal = np.cross(one.axis, two.axis)
    square = float(normal @ normal)
    away = two.at - one.at
    if square < _SAME or abs(away @ normal) > _SAME * (1 + float(np.linalg.norm(away))):
        return None
    along = float(np.cross(away, two.axis) @ normal) / square
    centre = replace(one, at=one.at + along * one.axis)
    for third in motions[2:]:
        off = np.cross(centre.at - third.at, third.axis)
        if np.linalg.norm(off) > _SAME * (1 + float(np.linalg.norm(away))) or abs(normal @ third.axis) < 1e-3:
            return None
    return centre, len(motions)


def _from_base(chains: list[Chain], base: str, platform: str) -> list[Chain]:
    """Turned and sorted so that each begins at a body that is reached before."""
    reached, found, left = {base}, [], list(chains)
    while left:
        for c in left:
            own = c
            if c.end == base or c.start == platform or c.start not in reached:
                own = c.backwards()
            if own.start in reached and own.start != platform:
                reached.add(own.end)
                found.append(own)
                left.remove(c)
                break
        else:
            break
    return found
