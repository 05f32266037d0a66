"""The poses of a way as a table, and back."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from gcrules.apps.studio.numbers import exact_pose
from gcrules.apps.studio.protocol.motion_views import WaypointsAnswer
from gcrules.apps.studio.protocol.requests import MOST_WAYPOINTS, PoseJson
from gcrules.apps.studio.subject import Subject
from gcrules.apps.studio.whereabouts import at_coordinates, coordinates_at, pose_json
from gcrules.core.errors import InputError, LimitReached
from gcrules.mechanisms.kinematics.solve import free_coordinates
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.methods import Methods, method
from gcrules.poses.paths.table import read_poses, read_targets, table_text
from gcrules.screws.pose import Pose

__all__ = ["waypoints_view"]


def waypoints_view(subject: Subject, poses: Sequence[PoseJson] | None, table: str | None) -> WaypointsAnswer:
    """Poses of the page as a table; where a table is given its poses. Raises InputError for tables at fault, and where
    the sliders do not lead to a pose.
    """
    m = subject.mechanism
    if table is not None:
        found, notes = method(_READERS, m, "a table of poses")(table)
        if len(found) < 2:
            raise InputError(f"a way needs two poses or more, found {len(found)}")
    elif poses is not None:
        found, notes = list(poses), ()
    else:
        raise InputError("neither poses nor a table of poses is given")
    return {"poses": found, "table": method(_WRITERS, m, "a table of poses")(found), "notes": list(notes)}


def _few(poses: Sequence[Any]) -> Sequence[Any]:
    if len(poses) > MOST_WAYPOINTS:
        raise LimitReached(
            f"{len(poses):,} poses are more than {MOST_WAYPOINTS}, the most of a way in the page",
            hint="gcrules path takes the whole table",
        )
    return poses


def _read_of_legs(m: SixLegs, table: str) -> tuple[list[PoseJson], Sequence[str]]:
    poses, notes = read_poses(table, m.unit)
    return [pose_json(p) for p in _few(poses)], notes


def _read_of_limbs(m: Limbs, table: str) -> tuple[list[PoseJson], Sequence[str]]:
    found: list[PoseJson] = []
    for pose in _few(read_targets(table, m.unit)):
        if isinstance(pose, Pose):
            names = ", ".join(free_coordinates(m.linkage))
            raise InputError("this robot does not take whole poses", hint=f"name its coordinates as columns: {names}")
        found.append(at_coordinates(m, list(pose), list(pose.values()), driven=False))
    return found, ()


def _written_of_legs(m: SixLegs, poses: Sequence[PoseJson]) -> str:
    return table_text([exact_pose(p) for p in poses], m.unit)


def _written_of_limbs(m: Limbs, poses: Sequence[PoseJson]) -> str:
    names = free_coordinates(m.linkage)
    return table_text([coordinates_at(m, p, names) for p in poses], m.unit)


_READERS: Methods[tuple[list[PoseJson], Sequence[str]]] = {SixLegs: _read_of_legs, Limbs: _read_of_limbs}
_WRITERS: Methods[str] = {SixLegs: _written_of_legs, Limbs: _written_of_limbs}
