"""What ways of a mechanism are sought in and proved, for any kind of mechanism."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Protocol

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.mechanism import Mechanism
from gcrules.poses.limbs.path_report import RobotPath
from gcrules.poses.modes.report import AssemblyMode
from gcrules.poses.paths.report import PathReport
from gcrules.poses.plans.report import Search, Waypoint
from gcrules.poses.plans.space import Space
from gcrules.poses.signs.sign import ConditionSign

__all__ = ["Domain", "Place", "Proved", "outside", "samples_of", "search_in"]

_LOOKS = 17  # places on a piece


@dataclass(frozen=True)
class Proved:
    """What is proved of a path: its `least` margin, everywhere (`margin_proved`) or only at samples of the path, that
    it keeps to the limits everywhere (`limits_proved`) or at these; the places of the segments that do not keep to what
    is asked for (`failures`), and of those of which it is proved that they are free of singular poses, but not that the
    margin is as large as is asked for between samples too (`doubts`).
    """

    path: PathReport | RobotPath
    least: float
    failures: tuple[int, ...]
    doubts: tuple[int, ...] = ()
    margin_proved: bool = True
    limits_proved: bool = True

    @classmethod
    def of(
        cls,
        path: PathReport | RobotPath,
        asked: float,
        pieces: int,
        places: Iterable[float],
        doubts: Iterable[float],
        *,
        limits_proved: bool = True,
    ) -> Proved:
        """Of a path of so many segments with failures at these parameters, and at that of a margin less than is asked
        for; where the margin is not proved doubts are at the others.
        """
        lowest = path.least
        proved = lowest.bound >= asked
        low = [lowest.parameter] if lowest.margin < asked else []
        failures, doubtful = (_segments(pieces, own) for own in ((*places, *low), () if proved else doubts))
        return cls(path, lowest.bound if proved else lowest.margin, failures, doubtful, proved, limits_proved)


def _segments(pieces: int, places: Iterable[float]) -> tuple[int, ...]:
    return tuple(sorted({min(int(p), pieces - 1) for p in places}))


@dataclass(frozen=True, eq=False)
class Place:
    """A pose with its state `row` (width,)."""

    pose: Waypoint
    row: Floats


class Domain(Protocol):
    """The states of a mechanism `m` in a `space`, with a margin `asked` at least, whose `size` makes lengths numbers.
    `notes` is what is to be said of any answer.
    """

    @property
    def m(self) -> Mechanism: ...
    @property
    def size(self) -> float: ...
    @property
    def asked(self) -> float: ...
    @property
    def space(self) -> Space: ...
    @property
    def notes(self) -> tuple[str, ...]: ...

    def prove(self, way: Sequence[Waypoint], samples: int | None = None) -> Proved:
        """The path straight through waypoints, looked at in so many samples of each piece, and what is proved of it."""
        ...

    def waypoint(self, state: Floats, *, rounded: bool) -> Waypoint:
        """The pose of a state; rounded it has few digits."""
        ...

    def continued(self, way: Sequence[Waypoint]) -> list[Waypoint]:
        """The same way, with angles that go on where they pass half a turn."""
        ...

    def length(self, way: Sequence[Waypoint]) -> float:
        """How long the way straight through waypoints is."""
        ...

    def home(self) -> Place:
        """The pose of the file."""
        ...

    def places(self, states: Floats) -> list[Place]:
        """The poses of states, with few digits, and the states that the straight ways from home lead to there; only
        those that keep to all that is asked for.
        """
        ...

    def place_of(self, mode: AssemblyMode) -> Place | str:
        """That of an assembly mode, or why it has none."""
        ...

    def ends_at(self, path: PathReport | RobotPath, place: Place) -> bool:
        """Whether the path to its pose ends in its state."""
        ...

    def signs(self, place: Place) -> tuple[ConditionSign, ...]:
        """Numbers that are 0 in singular poses only."""
        ...


def outside(space: Space, rows: Floats) -> list[int]:
    """The pieces of the way straight through states (N, width) that are seen to leave the region, by their places."""
    found = []
    parts = np.linspace(0.0, 1.0, _LOOKS)
    for k in range(len(rows) - 1):
        start, end = (np.repeat(row[None], _LOOKS, axis=0) for row in rows[k : k + 2])
        if not space.region.holds(space.coordinates(space.between(start, end, parts))).all():
            found.append(k)
    return found


def search_in(domain: Domain, states: int, seed: int) -> Search:
    """What a search in a domain had that came to so many states."""
    space = domain.space
    return Search(space.region.text(domain.m.unit), space.limits.text if space.limits else "", states, seed)


def samples_of(usual: int, asked: int | None, pieces: int) -> int:
    """How many samples a path of so many pieces has: the usual number, or so many of each piece."""
    return max(usual, pieces) if asked is None else asked * pieces
