r"""The working modes of a robot, with its numbers in each: all ways in which its limbs hold the platform in one place.

>>> found = working_modes("3-rrr")
>>> len(found.modes), found.modes[0].name, found.modes[1].name
(8, '+++', '++-')
>>> [mode.pose.verdict for mode in found.modes[:2]]
['regular', 'regular']
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import islice
from typing import Any

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.floats import without_noise
from gcrules.core.frozen import FrozenMap
from gcrules.core.shown import Shown
from gcrules.mechanisms.kinematics.linkage import Actuator
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.load import Folders, Source
from gcrules.mechanisms.mechanism import mechanism
from gcrules.mechanisms.modes.limb_solutions import STARTS
from gcrules.mechanisms.modes.working_modes import LimbChoices, choices_of, in_working_mode
from gcrules.poses.limbs.pose_report import report_of_limbs
from gcrules.poses.limbs.report import RobotPose
from gcrules.poses.modes.report import factor_signs
from gcrules.poses.signs.sign import signs_of
from gcrules.screws.threshold import DEFAULT, Threshold

__all__ = ["LISTED", "LimbWays", "WorkingMode", "WorkingModes", "working_modes"]

LISTED = 256  # modes; of more only those that differ from home's in one limb


@dataclass(frozen=True)
class LimbWays:
    """How many ways of a limb to hold the platform at home were found, and from how many of the random starts the
    rarest of them was reached; `moving` if the limb can move with the platform at rest, so that there is no number.
    """

    limb: str
    ways: int
    rarest: int
    moving: bool = False


@dataclass(frozen=True)
class WorkingMode:
    """A working mode by name. `offsets` are the amounts of the actuators at its home, from the home of the file (rad,
    the file's unit of length); `pose` has the numbers in the pose that was asked for, None with the `fault` where the
    robot does not assemble there in this mode.
    """

    name: str
    offsets: Mapping[str, float]
    pose: RobotPose | None
    fault: str = ""

    def __post_init__(self) -> None:
        object.__setattr__(self, "offsets", FrozenMap(self.offsets))

    @property
    def drives(self) -> dict[str, float]:
        """The amounts of the actuators in the pose, from the home of the file."""
        own = self.pose.actuator_values if self.pose else {}
        return {name: without_noise(value + own.get(name, 0.0)) for name, value in self.offsets.items()}

    @property
    def signs(self) -> str:
        """The signs of the condition's factors whose zeros are singularities: +, -, or 0 where one vanishes."""
        return "" if self.pose is None else signs_of(factor_signs(self.pose))

    def to_json(self) -> dict[str, Any]:
        return {
            "name": self.name,
            "drives": self.drives,
            "verdict": self.pose.verdict if self.pose else None,
            "margin": self.pose.margin if self.pose else None,
            "signs": self.signs,
            "fault": self.fault or None,
        }


@dataclass(frozen=True)
class WorkingModes(Shown):
    """The working modes that were found of a robot, home's first; `number` of them in all, `missing` left their family.

    The ways of each limb are those of a search from `starts` random places of its joints: another one may exist.
    """

    robot: str
    title: str
    target: str
    limbs: tuple[LimbWays, ...]
    actuators: tuple[Actuator, ...]
    modes: tuple[WorkingMode, ...]
    number: int
    missing: int = 0
    starts: int = STARTS

    def __len__(self) -> int:
        return len(self.modes)

    def to_json(self) -> dict[str, Any]:
        """One JSON object; angles in radians."""
        return {
            "schema": 1,
            "robot": self.robot,
            "title": self.title,
            "target": self.target,
            "number": self.number,
            "missing": self.missing,
            "limbs": [
                {"name": w.limb, "ways": None if w.moving else w.ways, "rarest": w.rarest, "starts": self.starts}
                for w in self.limbs
            ],
            "modes": [mode.to_json() for mode in self.modes],
        }

    def __repr__(self) -> str:
        return f"<WorkingModes {self.robot}: {self.number}>"


def working_modes(
    source: Source,
    at: Any = None,
    *,
    about: str | Sequence[Any] = "centroid",
    threshold: str | Threshold = DEFAULT.text,
    plugins: Folders = (),
) -> WorkingModes:
    """All ways in which the limbs of a robot of joints hold its platform at home, and the numbers of each mode `at` a
    pose (at home if None), which is reached from home in that mode.

    `source`, `at`, `about`, `threshold` and `plugins` are those of `pose`. The robot in a mode, for all that takes
    robots, is `gc.load(source, mode=name)`. Raises InputError for what has no limbs of joints or no home, and for poses
    that are none.
    """
    m = mechanism(source, about=about, plugins=plugins)
    if not isinstance(m, Limbs):
        raise InputError(
            "legs between two points have only one way to hold the platform, and so one working mode",
            hint="they are those of robots that are described by their joints, such as delta",
        )
    choices = choices_of(m.robot)
    names = m.linkage.actuators
    found: list[WorkingMode] = []
    missing = 0
    target = "home"
    for number in _listed(choices):
        checkpoint()
        try:
            robot = in_working_mode(choices, number)
        except InputError:
            missing += 1
            continue
        offsets = {a.name: float(choices.limbs[a.place].amounts[number[a.place]][a.coordinate]) for a in names}
        here = Limbs(robot, m.about, replace(m.analysis, robot=robot))
        try:
            pose = report_of_limbs(here, at, threshold=threshold)
        except InputError as fault:
            if not any(number):
                raise
            found.append(WorkingMode(choices.name(number), offsets, None, fault.message))
            continue
        target = pose.target
        found.append(WorkingMode(choices.name(number), offsets, pose))
    ways = [
        LimbWays(limb.name, len(own), min(own.hits), own.moving)
        for limb, own in zip(m.robot.limbs, choices.limbs, strict=True)
    ]
    total = len(choices)
    return WorkingModes(m.robot.id, m.robot.title, target, tuple(ways), names, tuple(found), total, missing)


def _listed(choices: LimbChoices) -> list[tuple[int, ...]]:
    """All modes, or where there are too many those that differ from home's in one limb."""
    if len(choices) <= LISTED:
        return list(choices.modes())
    home = (0,) * len(choices.limbs)
    single = (
        (*home[:place], k, *home[place + 1 :]) for place, own in enumerate(choices.limbs) for k in range(1, len(own))
    )
    return [home, *islice(single, LISTED)]
