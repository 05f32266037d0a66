"""A map over two coordinates around a pose of the page: its cells, its singular curves, and what is proved."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from math import isfinite
from typing import Any

import numpy as np

from gcrules.apps.studio.items import fact
from gcrules.apps.studio.kept import kept
from gcrules.apps.studio.moving import amounts_at
from gcrules.apps.studio.numbers import exact_pose
from gcrules.apps.studio.protocol.motion_views import CurveView, HereAnswer, MapAnswer, PlacedPose
from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.apps.studio.protocol.study_views import Axis
from gcrules.apps.studio.subject import Subject
from gcrules.apps.studio.thresholds import threshold_of
from gcrules.apps.studio.whereabouts import at_coordinates, coordinates_at, pose_json
from gcrules.core.english import as_sentence
from gcrules.core.errors import InputError, LimitReached
from gcrules.mechanisms.kinematics.amplification import INDICES
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.solve import free_coordinates
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import Mechanism
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.maps.axes import ACTUATOR, GridAxis, read_axes
from gcrules.poses.maps.cells import MEANINGS
from gcrules.poses.maps.grid import Grid, grid
from gcrules.poses.maps.limb_grid import LimbsGrid
from gcrules.poses.maps.maps import done
from gcrules.poses.maps.planned import Plan, planned
from gcrules.poses.maps.report import Curve, SingularMap
from gcrules.poses.maps.task import Slice
from gcrules.poses.methods import Methods, method
from gcrules.screws.pose_text import ANGLES
from gcrules.screws.threshold import DEFAULT, Threshold
from gcrules.views.results.map import account

__all__ = ["here_view", "map_of", "map_view", "place_view", "planned_map", "rest_of_map"]

_DUST = 1e-9  # radians, and parts of the robot's size: what rounding leaves of 0
MAX_NODES = 20_000
"""Poses of a map in the page."""


def map_view(found: SingularMap) -> MapAnswer:
    """A map over two coordinates as the page is told."""
    return {
        "axes": [_axis(a) for a in found.grid.axes],
        "curves": [stretch for c in found.curves for stretch in _stretches(c)],
        "margin": _table(found, "margin"),
        "index": _table(found, found.task.measure) if found.task.measure in INDICES else [],
        "status": [[MEANINGS[s] for s in row] for row in found.values("cell_status").tolist()],
        "fixed": _fixed(found.grid),
        "guarantee": as_sentence(found.guarantee),
        "statement": found.sentence,
        "facts": [fact(name, value) for name, value in account(found)],
    }


@kept
def map_of(
    subject: Subject, over: Sequence[str], pose: PoseJson, threshold: str | None, measure: str | None = None
) -> SingularMap:
    """The map over two coordinates, the others as they are at the pose. Raises InputError where there is none,
    LimitReached for more than `MAX_NODES` poses.
    """
    plan = planned_map(subject, over, pose, threshold_of(threshold, subject.unit), measure or "margin")
    if plan.task.grid.size > MAX_NODES:
        raise LimitReached(
            f"{plan.task.grid.size:,} poses: more than {MAX_NODES:,} in a map of the page",
            hint="use a coarser grid; `gcrules map` takes it",
        )
    return done(plan)


def place_view(subject: Subject, over: Sequence[str], pose: PoseJson, place: Sequence[float]) -> PlacedPose:
    """The pose at a place of that map. Raises InputError where the sliders do not lead there."""
    if len(place) != len(over):
        raise InputError(f"a place of {len(place)} numbers in a map over {len(over)} coordinates")
    plan = planned_map(subject, over, pose, DEFAULT, "margin")
    return {"pose": method(_PLACED, subject.mechanism, "a map")(plan.task.grid, place)}


def here_view(subject: Subject, over: Sequence[str], pose: PoseJson) -> HereAnswer:
    """Where in that map a pose is, if it lies in it: it does where what is fixed reads the same."""
    return method(_HERE, subject.mechanism, "a map")(subject, over, pose)


def planned_map(subject: Subject, over: Sequence[str], pose: PoseJson, limit: Threshold, measure: str) -> Plan:
    """The map that is to be computed, the other coordinates as they are at the pose. Raises InputError for none."""
    m = subject.mechanism
    return planned(m, over, rest_of_map(m, over, pose), None, limit, measure)


def rest_of_map(m: Mechanism, over: Sequence[str], pose: PoseJson) -> Any:
    """What the pose says of the coordinates that are no axes of the map."""
    return method(_REST, m, "a map")(over, pose)


def _here_of_legs(m: SixLegs, subject: Subject, over: Sequence[str], pose: PoseJson) -> HereAnswer:
    g = grid(m.rig, read_axes(over, m.unit), exact_pose(pose))
    return {"at": list(g.home), "fixed": _fixed(g)}


def _here_of_limbs(m: Limbs, subject: Subject, over: Sequence[str], pose: PoseJson) -> HereAnswer:
    g = planned_map(subject, over, pose, DEFAULT, "margin").task.grid
    now = _coordinates_of_limbs(m, g.axes, pose)
    return {"at": [now.get(a.name, 0.0) / a.scale for a in g.axes], "fixed": _fixed(g)}


_HERE: Methods[HereAnswer] = {SixLegs: _here_of_legs, Limbs: _here_of_limbs}


def _fixed(g: Slice) -> str:
    return g.fixed.replace("-", "−")


def _rest_of_limbs(m: Limbs, over: Sequence[str], pose: PoseJson) -> dict[str, float]:
    """What the coordinates, or the actuators, are at the pose that no axis stands for."""
    axes = read_axes(over, m.unit, {a.name: a.angle for a in leading(m.linkage)})
    names = [a.name for a in axes]
    return {n: v for n, v in _coordinates_of_limbs(m, axes, pose).items() if n not in names}


def _coordinates_of_limbs(m: Limbs, axes: Sequence[GridAxis], pose: PoseJson) -> dict[str, float]:
    """The coordinates by which poses of the map are told, or the actuators, at a pose; none of them at home."""
    amounts = amounts_at(m, pose)
    if not amounts:
        return {}
    if axes[0].kind == ACTUATOR:
        return dict(zip((a.name for a in leading(m.linkage)), amounts, strict=True))
    found = coordinates_at(m, pose, free_coordinates(m.linkage, [a.name for a in axes]))
    return {n: 0.0 if abs(c) <= _DUST * (1 if n in ANGLES else m.linkage.size) else c for n, c in found.items()}


_REST: Methods[Any] = {SixLegs: lambda m, over, pose: exact_pose(pose), Limbs: _rest_of_limbs}


def _placed_of_legs(m: SixLegs, g: Grid, place: Sequence[float]) -> PoseJson:
    return pose_json(g.pose([Fraction(c) for c in place]))


def _placed_of_limbs(m: Limbs, g: LimbsGrid, place: Sequence[float]) -> PoseJson:
    origin, steps = g.linear
    values = origin + g.places(np.array([place]))[0] @ steps
    return at_coordinates(m, g.names, values, g.driven)


_PLACED: Methods[PoseJson] = {SixLegs: _placed_of_legs, Limbs: _placed_of_limbs}


def _stretches(c: Curve) -> list[CurveView]:
    """A singular curve in stretches that keep to the limits throughout, or nowhere; neighbours share a point."""
    turns = (np.flatnonzero(np.diff(c.allowed)) + 1).tolist()
    return [
        {
            "points": [[_digits(x, 6) for x in p] for p in c.points[first : last + 1].tolist()],
            "reached": bool(c.allowed[first]),
        }
        for first, last in pairwise([0, *turns, len(c.points)])
    ]


def _axis(a: GridAxis) -> Axis:
    return {"name": a.name, "unit": a.unit, "low": float(a.start), "high": float(a.stop), "step": float(a.step)}


def _table(m: SingularMap, name: str) -> list[list[float | None]]:
    return [[_short(v) for v in row] for row in m.values(name).tolist()]


def _short(value: float) -> float | None:
    return _digits(value, 4) if isfinite(value) else None


def _digits(value: float, number: int) -> float:
    return float(f"{value:.{number}g}")
