"""Which link of which limb each point and direction of a robot rides on, so that motions carry it along."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.description.limb_file import BASE, PLATFORM, JointSpec, LimbSpec
from gcrules.mechanisms.description.relations import AXES
from gcrules.mechanisms.kinematics.chains import shape_of
from gcrules.mechanisms.kinematics.rigid_motions import Floats, crossed
from gcrules.mechanisms.robot import Robot
from gcrules.screws import FLOATS, JOINTS

__all__ = ["Attachment", "attachments", "carrier", "disagreement", "moved", "residual_of_relations"]

Values = Mapping[str, Floats]


@dataclass(frozen=True)
class Attachment:
    """A link that carries a name: the places of the limb and, from the base at 0, of the link. A `loose` one counts
    only where there is no other.
    """

    limb: int
    link: int
    loose: bool = False


def attachments(robot: Robot) -> dict[str, tuple[Attachment, ...]]:
    """All links that carry each name. Names of the platform that no joint has ride on it; names without a ride are
    made from others or stay where they are.
    """
    found: dict[str, dict[Attachment, None]] = {}
    for place, limb in enumerate(robot.limbs):
        for start, joint in _starts(limb):
            for name, link, loose in _of_joint(joint):
                found.setdefault(name, {})[Attachment(place, start + link, loose)] = None
    for name in robot.platform:
        found.setdefault(name, {Attachment(0, -1): None})
    return {name: _firm(tuple(own)) for name, own in found.items()}


def _starts(limb: LimbSpec) -> Iterator[tuple[int, JointSpec]]:
    """The link on which each joint begins, as `Chain.links` counts them, with the joint."""
    start = 0
    for _, joints in limb.parts:
        for joint in joints:
            yield start, joint
            start += len(shape_of(joint.kind).motions)
        start += 1  # the next chain begins on a link of its own


def carrier(robot: Robot, own: Attachment) -> str:
    """The link in words: the base, the platform, or what lies behind a joint of a limb."""
    limb = robot.limbs[own.limb]
    if own.link == -1:
        return "the platform"
    for chain, joints in limb.parts:
        for start, joint in _starts(limb):
            end = start + len(shape_of(joint.kind).motions)
            if joint in joints and start <= own.link <= end:
                if own.link == start and joint is joints[0]:
                    return _body(chain.start)
                if own.link == start:
                    continue
                last = joint is joints[-1] and own.link == end
                return _body(chain.end) if last else f"what {joint.text} of {limb.name} moves"
    raise AssertionError(f"{limb.name} has no link {own.link}")


def _body(name: str) -> str:
    return f"the {name}" if name in (BASE, PLATFORM) else name


def _firm(own: tuple[Attachment, ...]) -> tuple[Attachment, ...]:
    firm = tuple(r for r in own if not r.loose)
    return firm or own[:1]


def _of_joint(joint: JointSpec) -> Iterator[tuple[str, int, bool]]:
    """(name, link within the joint, loose) for all names of a joint."""
    shape = shape_of(joint.kind)
    end = len(shape.motions)
    for part, arg in zip(JOINTS[joint.kind].parts, joint.args, strict=True):
        if not isinstance(arg, tuple):
            continue
        first, last = shape.attachments[part]
        if len(arg) == 1:
            yield from ((arg[0][1], link, part in shape.loose) for link in range(first, last + 1))
            continue
        far, near = (name for _, name in arg)  # a pair A B is the vector B - A
        if joint.kind == "P" or part == "bars":
            firm = part == "bars"  # the ends of bars are their hinges
            yield near, 0, not firm
            yield far, end, not firm
        else:
            yield from ((name, link, True) for name in (near, far) for link in range(first, last + 1))


def moved(robot: Robot, own: Mapping[str, tuple[Attachment, ...]], values: Values, links: Sequence[Floats]) -> Values:
    """The places of all names after the links of each limb went as `links` (..., K + 1, 4, 4) say."""
    found: dict[str, Any] = {name: np.array(axis, dtype=float) for name, axis in AXES.items()}
    for d in robot.family.definitions:
        if d.name in own:
            found[d.name] = _by(own[d.name][0], d.sort, values[d.name], links)
        elif d.parameters:
            found[d.name] = values[d.name]
        else:
            others = {name: found[name].T for name in d.relation.names}
            found[d.name] = _vector(d.relation.value(d.sort, FLOATS, others, ()))
    return found


def _vector(components: Sequence[Any]) -> Floats:
    return np.stack(np.broadcast_arrays(*components), axis=-1).astype(float)


def _by(ride: Attachment, sort: str, value: Floats, links: Sequence[Floats]) -> Floats:
    motion = links[ride.limb][..., ride.link, :, :]
    turned = (motion[..., :3, :3] @ value[..., None])[..., 0]
    return np.asarray(turned + motion[..., :3, 3] if sort == "point" else turned)


def disagreement(
    robot: Robot, own: Mapping[str, tuple[Attachment, ...]], values: Values, links: Sequence[Floats], size: float
) -> Iterator[tuple[str, Floats]]:
    """For each name how far (rides, ...) the links that carry it carry it from where the first one does: distances
    divided by `size` for points, sines of angles for directions.
    """
    for name, several in own.items():
        sort = robot.family.sorts[name]
        places = [_by(r, sort, values[name], links) for r in several]
        if sort == "point":
            yield name, np.array([_length(p - places[0]) for p in places]) / size
        else:
            first = np.array(AXES[name], dtype=float) if name in AXES else places[0]
            length = _length(first) * _length(values[name])
            yield name, np.array([_length(crossed(first, p)) for p in places]) / length


def residual_of_relations(robot: Robot, values: Values, size: float) -> Iterator[tuple[str, Floats]]:
    """For each name how far (...,) it is from satisfying its relation: distances divided by `size` for points, parts of
    its length for directions. Relations are linear in the name itself, so this is a quotient.
    """
    rows = {n: (v[..., 0], v[..., 1], v[..., 2]) for n, v in values.items()}
    for d in robot.family.definitions:
        at = values[d.name]
        tried = [at, *(at + axis for axis in np.eye(3))]
        residual = [d.relation.residual(d.sort, FLOATS, rows, (v[..., 0], v[..., 1], v[..., 2])) for v in tried]
        if not residual[0]:
            continue
        zero, *others = map(_vector, residual)
        steep = np.sqrt(sum(((r - zero) ** 2).sum(axis=-1) for r in others))
        off = np.where(steep > 0, _length(zero) / np.where(steep > 0, steep, 1.0), 0.0)
        yield d.name, off / (size if d.sort == "point" else _length(at))


def _length(vectors: Floats) -> Floats:
    return np.asarray(np.linalg.norm(vectors, axis=-1))
