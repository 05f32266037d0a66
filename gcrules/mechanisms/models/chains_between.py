"""The limbs between base and platform as chains of motions; two equal bars side by side are one joint Pa or 4S."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import networkx as nx
import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.models.motions import Motion

__all__ = ["Bars", "Chain", "Item", "Poses", "limbs_between", "placed"]

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
    """Each limb as its chains, a limb being what hangs together without base and platform; in the sequence of the
    motions. Each chain begins at a body that those before it reach, the first ones at the base.
    """
    hung: nx.Graph[Any] = nx.Graph()
    for k, m in enumerate(motions):
        hung.add_node(k)
        hung.add_edges_from((k, body) for body in (m.start, m.end) if body not in (base, platform))
    found = []
    for nodes in nx.connected_components(hung):
        places = sorted(k for k in nodes if isinstance(k, int))
        chains = _reduced(list(_chains([motions[k] for k in places], base, platform)), (base, platform), poses)
        found.append((places[0], _from_base(chains, base, platform)))
    return [chains for _, chains in sorted(found, key=lambda one: one[0])]


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
            if bars is not None:
                rest = [c for c in chains if c is not one and c is not other]
                return [*rest, Chain(one.start, one.end, (bars,))]
    return None


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
    kinds: Callable[[Chain], str] = lambda c: "".join(i.kind for i in c.items)  # noqa: E731
    if not all(isinstance(i, Motion) for c in (one, other) for i in c.items):
        return None
    ball = all(kinds(c) in ("SS", "RRS", "SRR") for c in (one, other))
    if not ball and not (kinds(one) == kinds(other) == "RR"):
        return None
    motions: list[Motion] = [i for c in (one, other) for i in c.items if isinstance(i, Motion)]
    driven = [m for m in motions if m.driven]
    if len(driven) > (0 if ball else 1):
        return None
    joined = [(_end(*c), _end(*d)) for c, d in (_ends(one, ball=ball), _ends(other, ball=ball))]
    (near, far), (second, last) = joined
    if near is None or far is None or second is None or last is None:
        return None
    if not ball and any(np.linalg.norm(np.cross(m.axis, motions[0].axis)) > _SAME for m in motions):
        return None
    size = max(float(np.linalg.norm(m.at - motions[0].at)) for m in motions)
    vectors = [placed(poses, one.end, f.at) - placed(poses, one.start, n.at) for n, f in ((near, far), (second, last))]
    feet = placed(poses, one.start, second.at) - placed(poses, one.start, near.at)
    apart = vectors[1] - vectors[0]
    if not ball:  # what lies along the axes is nothing in the plane of the bars
        axes = np.array([at[one.start][:3, :3] @ motions[0].axis for at in poses])
        apart = apart - axes * (apart * axes).sum(axis=1, keepdims=True)
        feet = feet - axes * (feet * axes).sum(axis=1, keepdims=True)
    if np.abs(apart).max() > _SAME * size or np.linalg.norm(np.cross(feet[0], vectors[0][0])) < _SAME * size**2:
        return None
    kind = "4S" if ball else "Pa"
    return Bars(kind, one.start, one.end, (near, second), (far, last), tuple(motions), bool(driven))


def _ends(chain: Chain, *, ball: bool) -> tuple[tuple[Motion, ...], tuple[Motion, ...]]:
    """The motions at both ends of a bar."""
    motions = tuple(i for i in chain.items if isinstance(i, Motion))
    near = motions[:-1] if ball and motions[-1].kind == "S" else motions[:1]
    return near, motions[len(near) :]


def _end(*motions: Motion) -> Motion | None:
    """The joint at the end of a bar, a ball joint or two turns whose axes meet."""
    if len(motions) < 2:
        return motions[0]
    one, two = motions
    normal = np.cross(one.axis, two.axis)
    square = float(normal @ normal)
    away = two.at - one.at
    if square < _SAME or abs(away @ normal) > _SAME * (1 + float(np.linalg.norm(away))):
        return None
    along = float(np.cross(away, two.axis) @ normal) / square
    return replace(one, at=one.at + along * one.axis)


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
