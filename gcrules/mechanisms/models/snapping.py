"""Decimals of a model made exact: axes that are nearly parallel, perpendicular, or nearly meet, do so."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.models.motions import Motion

__all__ = ["TOLERANCE", "Moved", "moved_between", "size_of", "snapped"]

TOLERANCE = 1e-4  # parts of the model's size, and radians
_ONE_PLACE = 1e-4  # m


@dataclass(frozen=True)
class Moved:
    """How far the axis or centre of a joint was moved: a length across it, and an angle (rad)."""

    joint: str
    distance: float
    angle: float


def size_of(motions: Sequence[Motion]) -> float:
    """The diagonal of the box around the joints, the unit of tolerances; 1 where they are in one place but for
    decimals.
    """
    places = np.array([m.at for m in motions if m.kind != "P"] or [m.at for m in motions])
    found = float(np.linalg.norm(places.max(axis=0) - places.min(axis=0)))
    return found if found > _ONE_PLACE else 1.0


def snapped(motions: Sequence[Motion], ends: Sequence[str], tolerance: float = TOLERANCE) -> tuple[Motion, ...]:
    """The motions with exact axes and centres. Axes at base and platform, the `ends`, meet those of their own limb
    alone.
    """
    size = size_of(motions)
    axes = _directions([m.axis for m in motions], tolerance)
    turned = [replace(m, axis=a) for m, a in zip(motions, axes, strict=True)]
    places = _places(turned, ends, tolerance * size)
    return tuple(replace(m, at=at) for m, at in zip(turned, places, strict=True))


def moved_between(motions: Sequence[Motion], exact: Sequence[Motion]) -> tuple[Moved, ...]:
    """How far each joint was moved, where it was."""
    size = size_of(motions)
    moved: dict[str, Moved] = {}
    for before, after in zip(motions, exact, strict=True):
        away = before.at - after.at
        if after.has_line:
            away = away - after.axis * (away @ after.axis)
        distance = 0.0 if after.kind in ("P", "E") else float(np.linalg.norm(away))
        angle = float(np.linalg.norm(np.cross(before.axis, after.axis)))
        old = moved.get(before.joint, Moved(before.joint, 0.0, 0.0))
        moved[before.joint] = Moved(before.joint, max(distance, old.distance), max(angle, old.angle))
    worth = 1e-12
    return tuple(m for m in moved.values() if m.distance > worth * size or m.angle > worth)


def _directions(axes: Sequence[Floats], tolerance: float) -> list[Floats]:
    """Those nearly parallel made so, then those nearly perpendicular to others, the frame's axes being the first."""
    classes: list[list[int]] = []
    for k, axis in enumerate(axes):
        if not axis.any():
            continue
        for own in classes:
            if np.linalg.norm(np.cross(axes[own[0]], axis)) < tolerance:
                own.append(k)
                break
        else:
            classes.append([k])
    exact = [*np.eye(3)]
    found = [np.array(a, dtype=float) for a in axes]
    for own in sorted(classes, key=len, reverse=True):
        first = axes[own[0]]
        mean = np.sum([axes[k] * np.sign(axes[k] @ first) for k in own], axis=0)
        direction = _exact(mean / np.linalg.norm(mean), exact, tolerance)
        exact.append(direction)
        for k in own:
            found[k] = direction * np.sign(axes[k] @ direction)
    return found


def _exact(direction: Floats, others: Sequence[Floats], tolerance: float) -> Floats:
    for other in others:
        if np.linalg.norm(np.cross(other, direction)) < tolerance:
            found: Floats = other * np.sign(other @ direction)
            return found
    right = [other for other in others if abs(other @ direction) < tolerance]
    for k, one in enumerate(right):
        for two in right[:k]:
            normal = np.cross(one, two)
            if np.linalg.norm(normal) > 0.1:
                normal /= np.linalg.norm(normal)
                return normal * np.sign(normal @ direction)
    if right:
        direction = direction - right[0] * (right[0] @ direction)
    unit: Floats = direction / np.linalg.norm(direction)
    return unit


def _places(motions: Sequence[Motion], ends: Sequence[str], near: float) -> list[Floats]:
    """Centres that nearly coincide made one, axes moved to the centres that they nearly go through, and to each other
    where those of neighbours nearly meet.
    """
    found = [np.array(m.at, dtype=float) for m in motions]
    centres: list[tuple[Floats, list[int]]] = []  # places, and the motions through them

    def put(place: Floats, own: Sequence[int]) -> None:
        for other, members in centres:
            if np.linalg.norm(other - place) < near:
                members.extend(k for k in own if k not in members)
                return
        centres.append((np.array(place), list(own)))

    for k, m in enumerate(motions):
        if m.kind == "S":
            put(m.at, [k])
    balls = len(centres)
    through: set[tuple[int, int]] = set()  # axes that go through a centre, and belong elsewhere
    for k, m in enumerate(motions):
        for i, other in enumerate(motions[:k]):
            shared = {m.start, m.end} & {other.start, other.end} - {*ends}
            if m.has_line and other.has_line and shared:
                place = _meet(other, m, near)
                if place is not None:
                    put(place, [i, k])
    centred = {k for _, members in centres for k in members}
    for k, m in enumerate(motions):
        if m.has_line and k not in centred:
            for place, members in centres:
                beside = any({m.start, m.end} & {motions[i].start, motions[i].end} - {*ends} for i in members)
                if k not in members and beside and _off(m.axis, place - m.at) < near:
                    members.append(k)
                    through.add((k, id(members)))
    alone: list[int] = []  # axes that meet nothing: their points go along them into the planes of others
    for k, m in enumerate(motions):
        if m.has_line and not any(k in members for _, members in centres):
            put(m.at, [k])
            alone.append(k)
    held: set[int] = set()
    for place, members in centres[:balls] + centres[balls:]:
        lines = [k for k in members if k in held and motions[k].has_line]
        if len(lines) == 1:  # the axis stays where it is, and takes the centre
            axis, at = motions[lines[0]].axis, found[lines[0]]
            place[:] = at + axis * (axis @ (place - at))
        for k in members:
            if k not in held:
                axis, away = motions[k].axis, place - found[k]
                found[k] = found[k] + away - axis * (axis @ away) if (k, id(members)) in through else place
                held.add(k)
    for k in alone:
        for i, other in enumerate(motions):
            shared = {motions[k].start, motions[k].end} & {other.start, other.end} - {*ends}
            along = float(motions[k].axis @ (found[i] - found[k]))
            if i != k and (i not in alone or i < k) and other.kind != "P" and shared and abs(along) < near:
                found[k] = found[k] + along * motions[k].axis
    return found


def _off(axis: Floats, away: Floats) -> float:
    return float(np.linalg.norm(away - axis * (axis @ away)))


def _meet(one: Motion, other: Motion, near: float) -> Floats | None:
    """Where two axes nearly meet that are not parallel: midway, or on the centre of a joint if there is one."""
    normal = np.cross(one.axis, other.axis)
    square = float(normal @ normal)
    if square < 1e-6:
        return None
    away = other.at - one.at
    if abs(away @ normal) / square**0.5 > near:
        return None
    along = float(np.cross(away, other.axis) @ normal) / square
    back = float(np.cross(away, one.axis) @ normal) / square
    first, second = one.at + along * one.axis, other.at + back * other.axis
    for at in (one.at, other.at):
        if np.linalg.norm(first - at) < near:
            return np.array(at)
    found: Floats = (first + second) / 2
    return found
