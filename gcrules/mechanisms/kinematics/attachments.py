"""Where the links of a robot carry its points and directions, and whether all that carry one agree."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from gcrules.mechanisms.description.carriers import Attachment
from gcrules.mechanisms.description.relations import AXES
from gcrules.mechanisms.kinematics.rigid_motions import Floats, crossed, lengths
from gcrules.mechanisms.robot import Robot
from gcrules.screws import FLOATS

__all__ = ["disagreement", "moved", "residual_of_relations"]

Values = Mapping[str, Floats]


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
            yield name, np.array([lengths(p - places[0]) for p in places]) / size
        else:
            first = np.array(AXES[name], dtype=float) if name in AXES else places[0]
            length = lengths(first) * lengths(values[name])
            yield name, np.array([lengths(crossed(first, p)) for p in places]) / length


def residual_of_relations(robot: Robot, values: Values, size: float) -> Iterator[tuple[str, Floats]]:
    """For each name how far (...,) it is from satisfying its relation: distances divided by `size` for points, parts of
    its length for directions. Relations are linear in the name itself, so this is a quotient.
    """
    rows = {n: (v[..., 0], v[..., 1], v[..., 2]) for n, v in values.items()}
    axes = max(v.ndim for v in values.values())
    steps = np.vstack([np.zeros(3), np.eye(3)]).reshape(4, *(1,) * (axes - 1), 3)
    for d in robot.family.definitions:
        at = values[d.name]
        tried = at + steps
        residual = d.relation.residual(d.sort, FLOATS, rows, (tried[..., 0], tried[..., 1], tried[..., 2]))
        if not residual:
            continue
        found = _vector(residual)
        zero, others = found[0], found[1:]
        steep = np.sqrt(((others - zero) ** 2).sum(axis=(0, -1)))
        off = np.where(steep > 0, lengths(zero) / np.where(steep > 0, steep, 1.0), 0.0)
        yield d.name, off / (size if d.sort == "point" else lengths(at))
