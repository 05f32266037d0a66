"""Where the robot can go: its assembly modes, its aspects, and a box or a ball around a pose free of singular ones."""

from __future__ import annotations

from gcrules.apps.studio.accounts import account_view
from gcrules.apps.studio.kept import kept
from gcrules.apps.studio.numbers import exact_pose
from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.apps.studio.protocol.where_views import (
    AspectsAnswer,
    AspectSetView,
    AssembliesAnswer,
    AssemblyModeView,
    FreeAnswer,
)
from gcrules.apps.studio.subject import Subject, robot_of
from gcrules.apps.studio.thresholds import threshold_of
from gcrules.apps.studio.whereabouts import at_coordinates, at_home, coordinates_at, pose_json
from gcrules.core.budget import report
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.solve import free_coordinates
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import Mechanism
from gcrules.poses.aspects.aspects import aspects_of
from gcrules.poses.aspects.report import Aspects, AspectSet
from gcrules.poses.modes.modes import modes_of
from gcrules.poses.modes.report import AssemblyMode, AssemblyModes
from gcrules.poses.plans.report import Waypoint
from gcrules.poses.regions.free_region import region_of
from gcrules.poses.regions.report import FreeRegion
from gcrules.screws.pose import Pose
from gcrules.views.results.aspects import changes
from gcrules.views.results.free_region import ranges
from gcrules.views.results.modes import mode_picture, mode_text
from gcrules.views.results.plan import waypoint_text

__all__ = ["aspects_from", "aspects_view", "assemblies_from", "assemblies_view", "free_around", "free_view"]


def assemblies_view(subject: Subject, found: AssemblyModes) -> AssembliesAnswer:
    """Assembly modes as the page is told."""
    return {
        **account_view(found),
        "modes": [_mode(found, one, driven=subject.limbs is not None) for one in found.modes],
    }


@kept
def assemblies_from(subject: Subject, pose: PoseJson, limit: str | None) -> AssemblyModes:
    """All poses that the platform can take with its legs as long as at the pose; of a robot with limbs those at the
    home that its file gives, whatever mode is open. Raises InputError where there is no direct kinematics.
    """
    report("following all solutions")
    if subject.limbs is None:
        return modes_of(subject.mechanism, exact_pose(pose), threshold=threshold_of(limit, subject.unit))
    return modes_of(Limbs.of(robot_of(subject.source)), threshold=threshold_of(limit, ""))


def _mode(found: AssemblyModes, m: AssemblyMode, *, driven: bool) -> AssemblyModeView:
    return {
        "number": m.number,
        "given": m.given,
        "verdict": m.verdict,
        "margin": m.margin,
        "signs": m.signs.replace("-", "−"),
        "at": mode_text(m),
        "sure": m.certificate.method,
        "svg": mode_picture(found, m).svg(),
        "pose": None if driven else pose_json(m.pose),
        "mode": None if not driven or m.given else f"assembly {m.number}",
    }


def aspects_view(subject: Subject, found: Aspects) -> AspectsAnswer:
    """Aspects as the page is told."""
    sets = [_set(subject.mechanism, one) for one in found.sets]
    words = list(changes(found))
    return {**account_view(found), "least": found.least, "most": found.most, "sets": sets, "changes": words}


@kept
def aspects_from(subject: Subject) -> Aspects:
    """In how many aspects the poses around home lie. Raises InputError where this cannot be told."""
    report("looking at poses")
    return aspects_of(subject.mechanism)


def _set(m: Mechanism, one: AspectSet) -> AspectSetView:
    return {
        "name": one.name,
        "signs": one.pattern.replace("-", "−"),
        "poses": len(one.poses),
        "modes": list(one.modes),
        "at": waypoint_text(one.witness),
        "margin": one.margin,
        "pose": _posed(m, one.witness),
    }


def _posed(m: Mechanism, at: Waypoint) -> PoseJson | None:
    """The pose for the page; None where the sliders of a robot do not lead there."""
    if isinstance(at, Pose):
        return pose_json(at)
    assert isinstance(m, Limbs)
    try:
        return at_coordinates(m, tuple(at), list(at.values()), driven=False)
    except InputError:
        return None


def free_view(found: FreeRegion) -> FreeAnswer:
    """A region as the page is told."""
    rows = [{"name": name, "low": low, "high": high, "unit": unit} for name, low, high, unit in ranges(found)]
    return {**account_view(found), "ranges": rows}  # type: ignore[typeddict-item]  # the rows are of this kind


@kept
def free_around(subject: Subject, pose: PoseJson, shape: str) -> FreeRegion:
    """The largest box or ball around the pose that is proved free of singular poses. Raises InputError for none."""
    report("proving boxes")
    m = subject.mechanism
    at: Waypoint = coordinates_at(m, pose, free_coordinates(m.linkage)) if isinstance(m, Limbs) else exact_pose(pose)
    return region_of(m, None if at_home(pose) else waypoint_text(at), ball=shape == "ball")
