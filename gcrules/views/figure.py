"""The figure of any analysis: the legs as a graph, the platform with its coordinates, or the robot with its joints."""

from __future__ import annotations

from gcrules.conditions.analysis import Analysis
from gcrules.core.errors import InputError
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.views.drawing.drawing import Drawing
from gcrules.views.drawing.figures import graph_figure, robot_figure
from gcrules.views.robots.robot_drawing import draw_robot

__all__ = ["figure"]


def figure(a: Analysis | RobotAnalysis) -> Drawing:
    """Robots of joints are drawn beside the lines that stand for their wrenches, in the configuration of their file for
    drawings, or else at home; those that are given by lines as a graph. Raises InputError for a robot without a home.
    """
    if isinstance(a, Analysis):
        return robot_figure(a) if a.platform else graph_figure(a)
    if not a.robot.limbs and a.lines is not None:
        return graph_figure(a.lines, bodies=False)
    if a.robot.home is None:
        raise InputError(f"{a.robot.id} has no home configuration to be drawn in", hint="its file gives one as `home`")
    return draw_robot(a)
