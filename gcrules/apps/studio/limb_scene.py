"""A robot at home as it is drawn, be it at fault or not finished yet."""

from __future__ import annotations

from gcrules.core.errors import GcrulesError
from gcrules.mechanisms.conditions.checks import stays_in_plane
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.lines.equivalent import Equivalent, equivalent
from gcrules.mechanisms.robot import Robot
from gcrules.rules.statement import say
from gcrules.views.robots.limb_views import limb_views, unit_directions
from gcrules.views.robots.skeleton import skeleton
from gcrules.views.scene_data import SceneData

__all__ = ["home_scene", "outline"]


def outline(robot: Robot | None) -> Equivalent | None:
    """Mobility and wrenches of the limbs; None where the joints make none."""
    if robot is None or not robot.limbs:
        return None
    try:
        home = robot.values_at() if robot.home is not None else None
    except GcrulesError:  # coordinates that are not given yet
        home = None
    try:
        return equivalent(robot.family, robot.limbs, home) if stays_in_plane(robot) else None
    except GcrulesError:
        return None


def home_scene(robot: Robot | None, structure: Equivalent | None) -> SceneData | None:
    """The robot at home with its joints, links and wrenches; None where it cannot be drawn."""
    if robot is None or robot.home is None or not robot.limbs:
        return None
    try:
        values = {n: [float(c) for c in v] for n, v in robot.values_at().items()}
        links = skeleton(robot, values)
    except (GcrulesError, ZeroDivisionError):
        return None
    sorts = robot.family.sorts
    points = {n: v for n, v in values.items() if sorts.get(n) == "point"}
    bodies = Limbs(robot).bodies
    middle = [sum(p[i] for p in points.values()) / max(len(points), 1) for i in range(3)]
    square = sum(sum((c - m) ** 2 for c, m in zip(p, middle, strict=True)) for p in points.values())
    scene: SceneData = {
        "points": points,
        "base": [n for n in bodies["base"] if n in points],
        "platform": [n for n in bodies["platform"] if n in points],
        "legs": [],
        "about": middle,
        "size": (square / max(len(points), 1)) ** 0.5 or 1.0,
        "unit": robot.units,
        "entities": [],
        "skeleton": links,
    }
    if structure is not None:
        shown = RobotAnalysis(robot, structure, None, None, (), (), say(""), "")
        scene["limbs"] = limb_views(shown, values)
        scene["directions"] = unit_directions(shown, values)
    return scene
