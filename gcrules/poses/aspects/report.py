r"""The answer to how the poses of a robot are connected: sets that are joined without a singularity."""

from __future__ import annotations

from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.shown import Shown
from gcrules.poses.modes.report import AssemblyModes
from gcrules.poses.plans.report import Search, Waypoint, pose_json
from gcrules.poses.signs.sign import ConditionSign, signs_of

__all__ = ["AspectSet", "Aspects", "Join", "LeftOut"]


@dataclass(frozen=True)
class Join:
    """A way between two poses of one set, by their numbers, straight through `poses`: it is proved that nothing on it
    is singular; its margin is `least` at least, everywhere (`proved`) or at the samples of the path.
    """

    one: int
    other: int
    poses: tuple[Waypoint, ...]
    least: float
    proved: bool

    def to_json(self) -> dict[str, Any]:
        return {
            "one": self.one,
            "other": self.other,
            "poses": [pose_json(p) for p in self.poses],
            "least_margin": self.least,
            "margin_proved": self.proved,
        }


@dataclass(frozen=True)
class AspectSet:
    """Poses that proved ways join: `poses` are their numbers, `modes` those of the assembly modes among them. Of these
    the `witness` has the largest `margin`; all have the same `signs`.
    """

    name: str
    signs: tuple[ConditionSign, ...]
    poses: tuple[int, ...]
    modes: tuple[int, ...]
    witness: Waypoint
    margin: float

    @property
    def pattern(self) -> str:
        """The signs, such as "+-+"."""
        return signs_of(self.signs)

    def to_json(self) -> dict[str, Any]:
        return {
            "name": self.name,
            "pattern": self.pattern,
            "signs": [s.to_json() for s in self.signs],
            "poses": list(self.poses),
            "modes": list(self.modes),
            "witness": pose_json(self.witness),
            "margin": self.margin,
        }


@dataclass(frozen=True)
class LeftOut:
    """A pose that lies in no set, "home" or "mode 3", and why."""

    pose: str
    reason: str

    def to_json(self) -> dict[str, Any]:
        return {"pose": self.pose, "reason": self.reason}


@dataclass(frozen=True)
class Aspects(Shown):
    """How the poses of a robot are connected without singularities.

    Of all `poses` that were looked at (home, assembly modes, others at random) those of one of the `sets` are in one
    aspect, proved: the `joins` lead from each to each. Poses with other signs are in different aspects, proved; there
    are `least` of these patterns of signs. Sets with the same signs may belong together. So these poses lie in `least`
    aspects at least and in as many as there are sets at most; aspects that no pose fell into may be beside them.

    `modes` are the assembly modes for the actuators' values at home, None where they were not asked for. Home and modes
    that are `left_out` lie in no set.
    """

    title: str
    unit: str
    asked: float
    proved: bool
    poses: tuple[Waypoint, ...]
    sets: tuple[AspectSet, ...]
    joins: tuple[Join, ...]
    modes: AssemblyModes | None
    left_out: tuple[LeftOut, ...]
    search: Search
    notes: tuple[str, ...] = ()

    @property
    def least(self) -> int:
        """How many aspects there are at least."""
        return len({s.pattern for s in self.sets})

    @property
    def most(self) -> int:
        """In how many aspects the poses lie at most."""
        return len(self.sets)

    @property
    def decided(self) -> bool:
        """Whether it is known in how many aspects the poses lie."""
        return self.least == self.most

    @property
    def changes(self) -> tuple[AspectSet, ...]:
        """The sets in which assembly modes are joined: the robot changes from one to another without a singularity."""
        return tuple(s for s in self.sets if len(s.modes) > 1)

    @property
    def cuspidal(self) -> bool | None:
        """True where such a change is proved; None else: the modes are those for one value of each actuator."""
        return bool(self.changes) or None

    def way(self, one: int, other: int) -> tuple[Waypoint, ...]:
        """The proved way between two poses of one set, by their numbers; empty where they are in different ones."""
        reached: dict[int, tuple[Waypoint, ...]] = {one: (self.poses[one],)}
        ahead = [one]
        for here in ahead:
            for join in self.joins:
                if here in (join.one, join.other):
                    there = join.other if here == join.one else join.one
                    if there not in reached:
                        way = join.poses if here == join.one else join.poses[::-1]
                        reached[there] = (*reached[here], *way[1:])
                        ahead.append(there)
        return reached.get(other, ())

    def to_json(self) -> dict[str, Any]:
        """One JSON object, with all ways."""
        return {
            "schema": 1,
            "title": self.title,
            "unit": self.unit,
            "least": self.least,
            "most": self.most,
            "decided": self.decided,
            "margin_asked": self.asked,
            "margin_proved": self.proved,
            "poses": [pose_json(p) for p in self.poses],
            "sets": [s.to_json() for s in self.sets],
            "joins": [j.to_json() for j in self.joins],
            "modes": self.modes.to_json() if self.modes else None,
            "cuspidal": self.cuspidal,
            "left_out": [m.to_json() for m in self.left_out],
            "search": self.search.to_json(),
            "notes": list(self.notes),
        }

    def picture(self) -> Any:
        """The poses over the two coordinates that tell the sets apart best, with the proved ways: a drawing with
        `svg()`. Raises InputError where they differ in fewer than two.
        """
        return self._show("picture")

    def __repr__(self) -> str:
        number = str(self.least) if self.decided else f"{self.least} to {self.most}"
        return f"<Aspects: {len(self.poses)} poses in {number}>"
