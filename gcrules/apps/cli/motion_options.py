"""A path and a map that a report also shows: the options, and what is computed for them."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import TYPE_CHECKING, Any

import click

from gcrules.apps.cli.base import about_option, decorated
from gcrules.conditions.analysis import Analysis
from gcrules.core.dataclass import dataclass
from gcrules.core.deferred import deferred
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.screws.threshold import DEFAULT

if TYPE_CHECKING:
    from gcrules.poses.limbs.path_report import RobotPath
    from gcrules.poses.maps.report import SingularMap
    from gcrules.poses.paths.report import PathReport

__all__ = ["MotionOptions", "motion_options"]

path_of = deferred("gcrules.poses.path_report:path")
map_of = deferred("gcrules.poses.maps.maps:singular_map")


@dataclass(frozen=True)
class MotionOptions:
    """What --path, --poses, --over, --at, --limits, --about and --threshold say."""

    poses: tuple[str, ...] = ()
    table: str | None = None
    over: tuple[str, ...] = ()
    at: str | None = None
    limits: str | None = None
    about: str = "centroid"
    threshold: str = DEFAULT.text

    def check(self) -> None:
        """Raises UsageError for options that go with others that are not there."""
        if self.poses and self.table is not None:
            raise click.UsageError("Give the poses of the path either by --poses POSES.csv or by --path.")
        if not self.over and (self.at is not None or self.limits is not None):
            raise click.UsageError("--at and --limits are those of a map: give --over, twice or more.")

    def along(self, analysis: Analysis | RobotAnalysis) -> PathReport | RobotPath | None:
        """The path that is asked for."""
        poses = list(self.poses) if self.table is None else self.table
        if not poses:
            return None
        found: PathReport | RobotPath = path_of(analysis, poses, about=self.about, threshold=self.threshold)
        return found

    def mapped(self, analysis: Analysis | RobotAnalysis) -> SingularMap | None:
        """The map that is asked for."""
        if not self.over:
            return None
        options: dict[str, Any] = {"about": self.about, "limits": self.limits, "threshold": self.threshold}
        found: SingularMap = map_of(analysis, self.over, self.at, **options)
        return found


def motion_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """--path, --poses, --over, --at, --limits, --about, --threshold; the command receives them as `motion`."""

    @wraps(command)
    def with_motion(**options: Any) -> Any:
        names = ("poses", "table", "over", "at", "limits", "about", "threshold")
        return command(motion=MotionOptions(*(options.pop(name) for name in names)), **options)

    decorators = [
        click.option(
            "--path",
            "poses",
            multiple=True,
            metavar="POSE",
            help="Add a path through two poses or more, home among them.",
        ),
        click.option("--poses", "table", metavar="POSES.csv", help="Add the path of a table of poses."),
        click.option(
            "--over", multiple=True, metavar="RANGE", help='Add a map over two or three coordinates, "x -200:200:81".'
        ),
        click.option("--at", metavar="POSE", help="The other coordinates of the map."),
        click.option("--limits", metavar="RANGES", help='What legs or actuators reach in the map: "legs 1..3".'),
        about_option,
        click.option(
            "--threshold",
            default=DEFAULT.text,
            show_default=True,
            metavar="ANGLE",
            help="Closer than this is close, on the path and in the map (deg, rad).",
        ),
    ]
    return decorated(with_motion, decorators)
