"""What is asked of a certificate: a range of poses, its limits, and how well it is to be known."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.frozen import HoldsArrays
from gcrules.mechanisms.mechanism import Mechanism
from gcrules.poses.boxes.deciding import Decider
from gcrules.poses.boxes.task import BoxTask, box_task
from gcrules.poses.certificates.cones import Cone, Cones, cones, kept_program, tilt_of
from gcrules.poses.compiling.tape import Program
from gcrules.poses.maps.axes import TURNS, GridAxis
from gcrules.screws.pose import read_number

__all__ = ["Asked", "asked", "share_of"]

_LEAST = 1e-12
"""The margin that all free boxes have at least, so that bounds are told where none is asked for."""


@dataclass(frozen=True, eq=False)
class Asked(HoldsArrays):
    """A box of poses (one tile of a `BoxTask`), the `cones` of joints, and the `tilt` in rad that the platform's third
    axis keeps to, if there are any.
    """

    task: BoxTask
    cones: Cones | None
    tilt: float | None

    @property
    def mechanism(self) -> Mechanism:
        return self.task.mechanism

    @property
    def axes(self) -> tuple[GridAxis, ...]:
        """The coordinates; the two nodes of each are its ends."""
        return self.task.question.axes

    @property
    def limited(self) -> bool:
        """Whether anything but the ranges limits poses."""
        return self.task.question.limits is not None or self.cones is not None or self.tilt is not None

    @cached_property
    def kept(self) -> tuple[Program | None, tuple[Cone, ...]]:
        """The program of what cones and tilt keep to, and the cones. Raises InputError where there is none."""
        return kept_program(self.mechanism, self.task.question.names, self.cones, self.tilt)

    @cached_property
    def decider(self) -> Decider:
        """What decides boxes. Raises InputError where something has no closed form."""
        return replace(self.task.decider, margin=max(self.task.margin, _LEAST), kept=self.kept[0])

    def to_json(self) -> dict[str, Any]:
        """The question as a certificate has it; angles of cones and of the tilt in rad."""
        cones = [{"rod": list(c.rod), "end": c.end, "angle": c.angle} for c in self.kept[1]]
        return {**self.task.asked, "cones": cones, "tilt": self.tilt}

    def pose_text(self, place: Sequence[float]) -> str:
        """A place of the free coordinates, in rad and the file's unit, as `gcrules pose --at` takes it."""
        return ", ".join(f"{n}={_number(c, n)}" for n, c in self.coordinates(place).items())

    def coordinates(self, place: Sequence[float]) -> dict[str, float]:
        """All coordinates at a place of the free ones, in rad and the file's unit."""
        q = self.task.question
        values = dict(zip(q.names, q.values, strict=True))
        return values | {q.names[k]: float(c) for k, c in zip(q.free, place, strict=True)}


def _number(value: float, name: str) -> str:
    return f"{math.degrees(value) + 0.0:.15g}deg" if name in TURNS else f"{value + 0.0:.15g}"


def asked(
    m: Mechanism,
    over: Sequence[str | GridAxis],
    at: Any = None,
    limits: str | None = None,
    cone: str | None = None,
    tilt: str | None = None,
    margin: float = 0.0,
) -> Asked:
    """What is asked for. Raises InputError for what makes no sense."""
    task = box_task(m, over, at, limits, margin, 1, None)
    found = Asked(task, None if cone is None else cones(cone), None if tilt is None else tilt_of(tilt))
    if found.tilt is not None and {"roll", "pitch"} - set(task.question.names):
        raise InputError("the tilt is that of roll and pitch, which this robot does not have")
    task.check()
    _ = found.decider
    return found


def share_of(text: str | float) -> float:
    """A share from "99.9%" or 0.999. Raises InputError for what is none."""
    given = str(text).strip()
    number = read_number(given.rstrip("% "))
    found = number / 100 if given.endswith("%") else number
    if not 0 < found <= 1:
        raise InputError(f"the target {given[:40]} is not a share of the range", hint='as in "99.9%", or 0.999')
    return float(found)
