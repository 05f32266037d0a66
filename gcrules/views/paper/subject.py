"""What a section is about, alike for platforms on legs and for robots of joints."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr, Point, join
from gcrules.algebra.proofs.proof_file import ProofFile
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.pose_value import Coordinates
from gcrules.core.dataclass import dataclass
from gcrules.core.deferred import deferred
from gcrules.core.english import listed
from gcrules.core.errors import InputError
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.proofs import proof_file_or_none
from gcrules.mechanisms.robot import Robot
from gcrules.rules.condition import Condition
from gcrules.rules.statement import Statement
from gcrules.views.drawing.drawing import Drawing
from gcrules.views.drawing.figures import distinct_entities, graph_figure, robot_figure
from gcrules.views.formulas.latex_text import latex_words
from gcrules.views.paper.formulas import inline
from gcrules.views.robots.robot_drawing import draw_parts

__all__ = ["Figure", "Subject", "subject_of"]

_pose = deferred("gcrules.poses.pose:pose")  # numpy
_OF_A_MACHINE = ("pose", "dimensions", "home_wrenches")  # numbers whose last digit is not the same everywhere


@dataclass(frozen=True)
class Figure:
    """A drawing and the words below it, in LaTeX."""

    drawing: Drawing
    caption: str


@dataclass(frozen=True)
class Subject:
    """The analysis of lines with the condition that is used, and what is said of it; `analysis` is that of the robot.

    `lines` and `condition` are None where a robot's limbs apply wrenches that are no lines of its points.
    """

    analysis: Analysis | RobotAnalysis
    title: str
    lines: Analysis | None
    condition: Condition | None
    meaning: Statement
    whose: str
    source: str

    @property
    def robot(self) -> RobotAnalysis | None:
        """The analysis of a robot of joints."""
        return self.analysis if isinstance(self.analysis, RobotAnalysis) else None

    @property
    def names(self) -> tuple[str, ...]:
        """The names of points and directions."""
        if self.robot is not None:
            t = self.robot.structure
            return tuple(dict.fromkeys((*self.robot.robot.family.sorts, *t.ideal, *(n for n, _ in t.named))))
        return self.lines.structure.names if self.lines else ()

    @property
    def sides(self) -> tuple[Expr, Expr]:
        """The two sides of the identity."""
        assert self.condition is not None
        assert self.lines is not None
        return ex.mul(self.condition.cofactor, self.lines.structure.superbracket), self.condition.right_side

    @property
    def proved(self) -> bool:
        """Whether the identity is proved, and not only seen at random points."""
        return self.condition is not None and self.condition.certificate.method != "random-points"

    @property
    def digest(self) -> str:
        """SHA-256 of the analysis as JSON with sorted keys, without what is computed in floating point."""
        data = {key: value for key, value in self.analysis.to_json().items() if key not in _OF_A_MACHINE}
        written = json.dumps(data, sort_keys=True, separators=(",", ":"), ensure_ascii=True)
        return hashlib.sha256(written.encode()).hexdigest()

    @cached_property
    def proofs(self) -> ProofFile | None:
        """The proofs that others check; None where there are none to write."""
        return proof_file_or_none(self.analysis)

    @property
    def _described(self) -> Coordinates | Robot | None:
        return self.robot.robot if self.robot else self.lines.platform if self.lines else None

    @property
    def pose(self) -> str:
        """Which pose its numbers are of, in words."""
        return "the home pose" if self.robot else "the pose of the file"

    @property
    def unit(self) -> str:
        """The unit of length of the file, "" without."""
        return self._described.units if self._described else ""

    @property
    def coordinates(self) -> Mapping[str, Sequence[Fraction]]:
        """Where the points of the file are, of a robot at home its directions too; empty without dimensions."""
        d = self._described
        return {} if d is None else d.home or {} if isinstance(d, Robot) else d.points

    @property
    def ideal(self) -> frozenset[str]:
        """The names among them that are directions."""
        sorts = self.robot.robot.family.sorts if self.robot else {}
        return frozenset(name for name, sort in sorts.items() if sort == "direction")

    def numbers(self) -> Any:
        """The report of this pose, None where there are no dimensions."""
        if self.robot is None:
            assert self.lines is not None
            return _pose(self.lines.platform, nearest=False) if self.lines.platform else None
        robot = self.robot.robot
        return _pose(robot, nearest=False) if robot.limbs and robot.home is not None else None

    def figures(self) -> Iterator[Figure]:
        """What can be drawn: the platform or the graph of its legs; the robot, and the lines that stand for it."""
        a, title = self.robot, latex_words(self.title)
        if a is not None and a.robot.limbs:
            if a.robot.home is not None:
                robot, *others = draw_parts(a, a.robot.values_at())
                yield Figure(robot, f"{title} with the wrenches that its limbs apply, actuators locked")
                yield from (Figure(one, f"{title}: the lines that stand for its wrenches") for one in others)
            return
        assert self.lines is not None
        if self.lines.platform:
            yield Figure(robot_figure(self.lines, key=False), f"{title}{_coloured(self.lines)}")
        else:
            try:
                drawn = graph_figure(self.lines, key=False, bodies=a is None)
                yield Figure(drawn, f"{title}: the graph of its legs{_coloured(self.lines)}")
            except InputError:  # no line joins two joints
                return


def subject_of(a: Analysis | RobotAnalysis) -> Subject:
    """What is to be told of an analysis."""
    if isinstance(a, RobotAnalysis):
        return Subject(a, a.robot.title, a.lines, a.condition, a.meaning, "", a.robot.source)
    title = a.platform.title if a.platform else ""
    if not title:
        legs = len(a.structure.legs)
        title = f"Platform of class {a.match.entry.id}" if a.match else f"Platform on {legs} legs"
    return Subject(a, title, a, a.condition, a.condition.meaning, a.condition.whose, "")


_COLOURS = ("blue", "orange", "green", "purple", "brown", "violet")
"""In words, in the sequence of `palette.ENTITY_ROLES`."""


def _coloured(a: Analysis) -> str:
    """The flats of the condition that are drawn, with their colours."""
    shown = distinct_entities(a) if a.structure.rank == 4 else []
    if not shown or len(shown) > len(_COLOURS):
        return ""
    words = [f"the {e.kind} {inline(join(*map(Point, e.points)))} ({c})" for e, c in zip(shown, _COLOURS, strict=False)]
    return f", with {listed(words)}"
