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
    ridden = [d.name for d in robot.family.definitions if d.name in own]
    places = _carried(robot, [(name, own[name][0]) for name in ridden], values, links)
    places_of = dict(zip(ridden, places, strict=True))
    for d in robot.family.definitions:
        if d.name in places_of:
            found[d.name] = places_of[d.name]
        elif d.parameters:
            found[d.name] = values[d.name]
        else:
            others = {name: found[name].T for name in d.relation.names}
            found[d.name] = _vector(d.relation.value(d.sort, FLOATS, others, ()))
    return found


def _vector(components: Sequence[Any]) -> Floats:
    return np.stack(np.broadcast_arrays(*components), axis=-1).astype(float)


def _carried(robot: Robot, rides: Sequence[tuple[str, Attachment]], values: Values, links: Sequence[Floats]) -> Floats:
    """Where links carry names, (rides, ..., 3)."""
    if not rides:
        return np.zeros((0, 3))
    motions = np.stack([links[r.limb][..., r.link, :, :] for _, r in rides])
    before = [values[name] for name, _ in rides]
    if len({v.shape for v in before}) > 1:
        before = list(np.broadcast_arrays(*before))
    several = np.stack(before)
    several = several.reshape(len(rides), *(1,) * (motions.ndim - 1 - several.ndim), *several.shape[1:])
    turned = (motions[..., :3, :3] @ several[..., None])[..., 0]
    points = np.array([robot.family.sorts.get(name) == "point" for name, _ in rides])
    return np.asarray(turned + np.where(points.reshape(-1, *(1,) * (turned.ndim - 1)), motions[..., :3, 3], 0.0))


def disagreement(
    robot: Robot, own: Mapping[str, tuple[Attachment, ...]], values: Values, links: Sequence[Floats], size: float
) -> Iterator[tuple[str, Floats]]:
    """For each name how far (rides, ...) the links that carry it carry it from where the first one does: distances
    divided by `size` for points, sines of angles for directions.
    """
    rides = [(name, ride) for name, several in own.items() for ride in several]
    places = _carried(robot, rides, values, links)
    stop = 0
    for name, several in own.items():
        start, stop = stop, stop + len(several)
        here = places[start:stop]
        if robot.family.sorts[name] == "point":
            yield name, lengths(here - here[0]) / size
        else:
            first = np.array(AXES[name], dtype=float) if name in AXES else here[0]
            yield name, lengths(crossed(first, here)) / (lengths(first) * lengths(values[name]))


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
