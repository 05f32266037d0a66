"""A robot as it stands where somebody works with it, in the studio: what its report shows beside the analysis."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from gcrules.conditions.pose_value import PoseValue
from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.limbs.report import RobotPose
from gcrules.poses.numbers.report import PoseReport

__all__ = ["Answered", "Repetition", "Standing", "Titled"]


@dataclass(frozen=True)
class Titled:
    """A path, a map or a locus whose section has a title of its own."""

    answer: Any
    title: str = ""


@dataclass(frozen=True)
class Repetition:
    """What is repeated by a line for the shell, and by lines of Python ("" where no function does it); `files` are the
    names of the files that they read, with their texts.
    """

    title: str
    shell: str
    python: str
    files: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True)
class Answered:
    """A part of the bench's text, as it is written, and the answers to the statement with which it ends: each how sure
    it is ("" where nothing is decided), and its text. A last part may have none.
    """

    text: str
    answers: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True)
class Standing:
    """`mechanism` is what stands there and what answers are asked of; `numbers` are those in the pose, None where there
    are none, for the reason `unset`; `drawing` is the robot in it, as SVG, or "". `start` is what takes a 3D view
    there: a `pose`, or the amounts of the actuators to `drive` to. `picture` is one of the view itself, a data address
    of an image; `notes` are titles with their texts, `bench` is the text of the bench with its answers, `link` is the
    address that opens the same state again.
    """

    mechanism: SixLegs | Limbs
    numbers: PoseReport | RobotPose | PoseValue | None
    unset: str = ""
    drawing: str = ""
    start: Mapping[str, Any] | None = None
    picture: str = ""
    notes: tuple[tuple[str, str], ...] = ()
    bench: tuple[Answered, ...] = ()
    link: str = ""
    repetitions: tuple[Repetition, ...] = ()

    def __post_init__(self) -> None:
        if self.start is not None:
            object.__setattr__(self, "start", FrozenMap(self.start))
