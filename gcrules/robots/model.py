r"""Robots for users: `gc.Robot.load(id or path)`, `.analyze()`."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, fields
from os import PathLike

from gcrules.robots.discovery import find_robot
from gcrules.robots.robot_analysis import RobotAnalysis, analyze_robot
from gcrules.robots.robot_file import load_robot, parse_robot
from gcrules.robots.robot_text import RobotText
from gcrules.rules.factorization import SECONDS

__all__ = ["Robot"]


@dataclass(frozen=True, repr=False)
class Robot(RobotText):
    """A robot that can be analysed; made by `Robot.load` or `Robot.parse`."""

    @classmethod
    def load(cls, name: str | PathLike[str], *, plugins: Iterable[str | PathLike[str]] = ()) -> Robot:
        """The robot of this id, or of a robot file; `plugins` are further folders of plugins.

        Raises InputError for an unknown id or one that two plugins bring, FileError with all faults of the file.
        """
        found = find_robot(name, plugins)
        return cls._of(load_robot(found.path, found.owner))

    @classmethod
    def parse(cls, text: str, filename: str = "<input>") -> Robot:
        """The robot that the text of a robot file describes. Raises FileError with all its faults."""
        return cls._of(parse_robot(text, filename))

    @classmethod
    def _of(cls, text: RobotText) -> Robot:
        return cls(**{f.name: getattr(text, f.name) for f in fields(text)})

    def analyze(self, *, search: float = SECONDS) -> RobotAnalysis:
        """When and why the robot is singular; `search` as for `gcrules.analyze`."""
        return analyze_robot(self, search=search)
