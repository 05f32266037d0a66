"""Motions of a chain as joints of a robot file: turns whose axes meet are U or S, a turn and a slide C or H."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.models.chains_between import Bars, Chain, Item, Poses, placed
from gcrules.mechanisms.models.feet import SAME, meet, off, with_feet
from gcrules.mechanisms.models.motions import Motion

__all__ = ["Part", "Ratios", "Slot", "apart", "parts_of"]

Ratios = Mapping[str, tuple[str, float]]
"""Of each joint that follows another one its leader, and how much it moves for each unit of it."""


@dataclass(frozen=True, eq=False)
class Slot:
    """A point or direction of a joint, with its values in all configurations, (n, 3); directions have length 1. Bars
    have a `length`, 0 otherwise.
    """

    sort: str
    values: Floats
    length: float = 0.0


@dataclass(frozen=True, eq=False)
class Part:
    """A joint of a robot file: its kind, its points and directions, the joints of the model that it is made of;
    `driven` is the star behind its symbol. `axis` is that of the model, along which a value of it counts.
    """

    kind: str
    slots: tuple[Slot, ...]
    joints: tuple[str, ...]
    driven: str = ""
    pitch: float = 0.0
    axis: Floats = field(default_factory=lambda: np.zeros(3))

    @property
    def merged(self) -> bool:
        """Whether several joints of the model have become one."""
        return len(self.joints) > 1


def apart(limbs: Sequence[Sequence[Part]], size: float) -> list[list[Part]]:
    """The joints of limbs with no two points in one place at home that part elsewhere: the point of a turn goes along
    its axis.
    """
    taken = [
        s.values
        for parts in limbs
        for p in parts
        if p.kind not in ("R", "H", "C")
        for s in p.slots
        if s.sort == "point"
    ]

    def clear(part: Part) -> Part:
        if part.kind not in ("R", "H", "C"):
            return part
        point, axis = part.slots
        for step in range(12):
            values = point.values + axis.values * (0.05 * size * step)
            near = [v for v in taken if np.linalg.norm(v[0] - values[0]) < SAME * size]
            if all(np.abs(v - values).max() < SAME * size for v in near):
                taken.append(values)
                return part if step == 0 else replace(part, slots=(Slot("point", values), axis))
        return part

    return [[clear(p) for p in parts] for parts in limbs]


def parts_of(chain: Chain, poses: Poses, coupled: Ratios) -> list[Part]:
    """The joints of a chain. Joints that are coupled to others stay by themselves, but for a pair that is a screw, or a
    parallelogram.
    """
    items = with_feet(chain.items)
    size = max((float(np.linalg.norm(_at(i) - _at(items[0]))) for i in items), default=0.0) or 1.0
    tied = {*coupled, *(leader for leader, _ in coupled.values())}
    return list(_merged(items, poses, coupled, tied, size))


def _at(item: Item) -> Floats:
    return item.at if isinstance(item, Motion) else item.near[0].at


def _merged(items: Sequence[Item], poses: Poses, coupled: Ratios, tied: set[str], size: float) -> Iterator[Part]:
    k = 0
    while k < len(items):
        here = items[k]
        if isinstance(here, Bars):
            yield _bars(here, poses)
            k += 1
            continue
        run: list[Motion] = []
        for other in items[k : k + 3]:
            if not isinstance(other, Motion) or other.joint in tied or other.driven:
                break
            run.append(other)
        pair = items[k : k + 2]
        part, taken = (
            _spherical(run, poses, size) or _pair(run, poses, size) or _geared(pair, poses, coupled) or (None, 0)
        )
        if part is None and here.kind == "R" and here.driven and len(pair) == 2:
            part, taken = _driven_universal(pair, poses, size) or (None, 0)
        if part is None:
            part, taken = _single(here, poses), 1
        yield part
        k += taken


def _turned(poses: Poses, body: str, direction: Floats) -> Floats:
    return np.array([at[body][:3, :3] @ direction for at in poses])


def _point(poses: Poses, body: str, at: Floats) -> Slot:
    return Slot("point", placed(poses, body, at))


def _direction(poses: Poses, body: str, axis: Floats) -> Slot:
    return Slot("direction", _turned(poses, body, axis))


def _single(m: Motion, poses: Poses) -> Part:
    at, along = _point(poses, m.start, m.at), _direction(poses, m.start, m.axis)
    slots = {"P": (along,), "S": (at,)}.get(m.kind, (at, along))
    return Part(m.kind, slots, (m.joint,), "*" if m.driven else "", m.pitch, m.axis)


def _spherical(run: Sequence[Motion], poses: Poses, size: float) -> tuple[Part, int] | None:
    """Three turns about axes through one point that are not in one plane."""
    if len(run) < 3 or any(m.kind != "R" for m in run):
        return None
    first, second, third = run
    centre = meet(first, second, size)
    if centre is None:
        centre = meet(second, third, size)
    if centre is None or any(off(m, centre) > SAME * size for m in run):
        return None
    if abs(np.cross(first.axis, second.axis) @ third.axis) < 1e-3:
        return None
    return Part("S", (_point(poses, first.start, centre),), _names(run)), 3


def _pair(run: Sequence[Motion], poses: Poses, size: float) -> tuple[Part, int] | None:
    """Two turns whose axes meet, or a turn and a slide along its axis."""
    if len(run) < 2:
        return None
    one, two = run[:2]
    if one.kind == two.kind == "R":
        found = _universal(one, two, poses, size)
        return (found, 2) if found else None
    if {one.kind, two.kind} == {"R", "P"} and np.linalg.norm(np.cross(one.axis, two.axis)) < SAME:
        turn = one if one.kind == "R" else two
        slots = (_point(poses, turn.start, turn.at), _direction(poses, turn.start, turn.axis))
        return Part("C", slots, _names((one, two))), 2
    return None


def _universal(one: Motion, two: Motion, poses: Poses, size: float, driven: str = "") -> Part | None:
    centre = meet(one, two, size)
    if centre is None:
        return None
    slots = (
        _point(poses, one.start, centre),
        _direction(poses, one.start, one.axis),
        _direction(poses, two.end, two.axis),
    )
    return Part("U", slots, _names((one, two)), driven)


def _driven_universal(pair: Sequence[Item], poses: Poses, size: float) -> tuple[Part, int] | None:
    one, two = pair
    if not (isinstance(one, Motion) and isinstance(two, Motion)) or one.joint != two.joint:
        return None
    found = _universal(one, two, poses, size, "*")
    return (found, 2) if found else None


def _geared(pair: Sequence[Item], poses: Poses, coupled: Ratios) -> tuple[Part, int] | None:
    """A turn and a slide along its axis that are coupled, a screw; two turns about parallel axes that go against each
    other, a parallelogram.
    """
    if len(pair) < 2 or not (isinstance(pair[0], Motion) and isinstance(pair[1], Motion)):
        return None
    one, two = pair
    assert isinstance(one, Motion)
    assert isinstance(two, Motion)
    leads = {
        m.joint: other for m, other in ((one, two), (two, one)) if coupled.get(m.joint, ("", 0.0))[0] == other.joint
    }
    others = {leader for name, (leader, _) in coupled.items() if name not in leads}
    if len(leads) != 1 or not others.isdisjoint((one.joint, two.joint)):
        return None
    if np.linalg.norm(np.cross(one.axis, two.axis)) > SAME:
        return None
    ratio = next(coupled[name][1] for name in leads) * float(np.sign(one.axis @ two.axis))
    star = "*" if one.driven or two.driven else ""
    if {one.kind, two.kind} == {"R", "P"}:
        turn = one if one.kind == "R" else two
        pitch = ratio if next(iter(leads)) != turn.joint else 1 / ratio
        slots = (_point(poses, turn.start, turn.at), _direction(poses, turn.start, turn.axis))
        return Part("H", slots, _names(pair), star, pitch), 2
    if one.kind == two.kind == "R" and abs(ratio + 1) < 1e-9:
        across = two.at - one.at
        across = across - one.axis * (across @ one.axis)
        if np.linalg.norm(across) < SAME:
            return None
        bars = placed(poses, one.end, one.at + across) - placed(poses, one.end, one.at)
        return Part("Pa", (_bar(bars), _direction(poses, one.start, one.axis)), _names(pair), star), 2
    return None


def _bars(item: Bars, poses: Poses) -> Part:
    names = tuple(dict.fromkeys(m.joint for m in item.inner))
    near, far = item.near, item.far
    vectors = placed(poses, item.end, far[0].at) - placed(poses, item.start, near[0].at)
    if item.kind == "4S":
        return Part("4S", (*(_point(poses, item.start, m.at) for m in near), _bar(vectors)), names)
    axes = _turned(poses, item.start, near[0].axis)
    vectors = vectors - axes * (vectors * axes).sum(axis=1, keepdims=True)
    return Part("Pa", (_bar(vectors), Slot("direction", axes)), names, "*" if item.driven else "")


def _bar(vectors: Floats) -> Slot:
    length = float(np.linalg.norm(vectors[0]))
    return Slot("direction", vectors / length, length)


def _names(motions: Sequence[Item]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(m.joint for m in motions))
