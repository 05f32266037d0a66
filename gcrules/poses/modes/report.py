r"""All solutions of a direct kinematics as values: the modes, what is proved of each, and whether they are all."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from math import isfinite
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap
from gcrules.core.shown import Shown
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.limbs.report import RobotPose
from gcrules.poses.numbers.report import PoseReport
from gcrules.poses.signs.sign import FactorSign, signs_of
from gcrules.screws.pose import Pose

__all__ = [
    "AssemblyMode",
    "AssemblyModes",
    "BoxCertificate",
    "Completeness",
    "SolutionCurve",
    "factor_signs",
    "in_order",
]


@dataclass(frozen=True)
class BoxCertificate:
    """What is proved of a solution. Where it is `proved`, there is exactly one solution near the pose that is given: by
    the motion from it the platform turns by no more than `turn` (rad) and its centre moves by no more than `shift` (in
    the unit of lengths); None where this is told by joints. Where it is only `unique` it is proved that there is no
    other one nearby, and that it is one is numerical. `method` says how, or why it is not proved.
    """

    proved: bool
    method: str
    unique: bool = False
    turn: float | None = None
    shift: float | None = None

    def to_json(self) -> dict[str, Any]:
        return {
            "proved": self.proved,
            "unique": self.unique or self.proved,
            "method": self.method,
            "turn": self.turn,
            "shift": self.shift,
        }


_ZERO = 1e-6  # of a factor, where the robot is singular


def factor_signs(found: RobotPose) -> tuple[FactorSign, ...]:
    """The factors of a robot's condition whose zeros are singularities; 0 only where it is singular."""
    zero = _ZERO if found.verdict == "singular" else 0.0
    live = (f for f in found.factors if f.live and isfinite(f.value))
    return tuple(FactorSign(f.expression, f.value, (f.value > zero) - (f.value < -zero)) for f in live)


@dataclass(frozen=True)
class AssemblyMode:
    """One real solution: the platform's pose from that of the file, about the same centre as the poses of `gc.pose`.

    `coordinates` are x, y, z (unit of the file), roll, pitch, yaw (rad); `actuators` what is held, by name: lengths of
    legs, amounts of driven joints from home. `margin` and `verdict` are those of `report`, all numbers of the
    configuration. `given` tells that it is the pose the actuators' values were taken from. `multiplicity` is the number
    of paths that end there, 1 at a regular solution.
    """

    number: int
    pose: Pose
    coordinates: Mapping[str, float]
    actuators: tuple[tuple[str, float], ...]
    margin: float
    verdict: str
    factors: tuple[FactorSign, ...]
    certificate: BoxCertificate
    report: PoseReport | RobotPose
    given: bool = False
    multiplicity: int = 1

    def __post_init__(self) -> None:
        object.__setattr__(self, "coordinates", FrozenMap(self.coordinates))

    @property
    def signs(self) -> str:
        """The signs of the factors, such as "+-+"; 0 where one vanishes."""
        return signs_of(self.factors)

    def to_json(self) -> dict[str, Any]:
        return {
            "number": self.number,
            "given": self.given,
            "pose": self.pose.to_json(),
            "coordinates": dict(self.coordinates),
            "actuators": dict(self.actuators),
            "margin": self.margin,
            "verdict": self.verdict,
            "factors": [f.to_json() for f in self.factors],
            "signs": self.signs,
            "multiplicity": self.multiplicity,
            "certificate": self.certificate.to_json(),
        }

    def __repr__(self) -> str:
        return f"<AssemblyMode {self.number}: {self.verdict}, margin {self.margin:.4g}>"


def in_order(modes: Iterable[AssemblyMode]) -> tuple[AssemblyMode, ...]:
    """Numbered: the given pose first, then by margins, and alike ones by their poses."""

    def key(one: AssemblyMode) -> tuple[Any, ...]:
        return not one.given, -round(one.margin, 9), [-round(v, 6) for v in one.coordinates.values()]

    return tuple(replace(one, number=n) for n, one in enumerate(sorted(modes, key=key), 1))


@dataclass(frozen=True)
class SolutionCurve:
    """A curve of solutions: a self-motion, the platform moves with its actuators held. `poses` lie on it, one after the
    other; `closed` tells that it comes back to the first one. `through_given` tells that it goes through the pose the
    actuators' values were taken from. Followed numerically: no proof.
    """

    poses: tuple[Pose, ...]
    closed: bool
    through_given: bool

    def to_json(self) -> dict[str, Any]:
        return {
            "poses": [p.to_json() for p in self.poses],
            "closed": self.closed,
            "through_given": self.through_given,
        }


@dataclass(frozen=True)
class Completeness:
    """Whether the solutions found are all. Of `paths` from a system with as many solutions ended: at regular solutions
    `real` and `unreal` (complex ones, in pairs), `certified` of both together; `at_infinity` where no platform is;
    `singular` at singular solutions, some of them on curves; `beside` at poses that violate a further condition of an
    over-constrained robot; `lost` nowhere that is known. `unreached` real solutions are poses that the conditions allow
    and a limb does not reach with real joints. Without paths it is a search: `starts` random ones, of which the last
    `quiet` found nothing new. `dependent` tells that the conditions depend on each other, so that no solution is
    isolated, `missed` that not even the given pose was found.
    """

    paths: int = 0
    real: int = 0
    unreal: int = 0
    certified: int = 0
    at_infinity: int = 0
    singular: int = 0
    beside: int = 0
    lost: int = 0
    unreached: int = 0
    starts: int = 0
    quiet: int = 0
    dependent: bool = False
    missed: bool = False
    method: str = "paths"

    @property
    def complete(self) -> bool | None:
        """True where all isolated solutions are known: all paths ended. None where that is not known."""
        return True if self.method == "paths" and self.paths and not self.lost and not self.missed else None

    @property
    def proved(self) -> bool:
        """Whether nothing numerical is left: as many solutions as there can be, each certified."""
        return bool(self.paths) and self.certified == self.paths

    @property
    def text(self) -> str:
        """In words."""
        if self.missed:
            return "not complete: not even the given pose is among them"
        if self.dependent:
            return (
                "the actuators' conditions depend on each other, within rounding: no solution is isolated, and"
                " whatever solution there is lies on a curve or a surface of solutions; those listed were sought"
                " from the given pose and from random ones"
            )
        if self.method == "search":
            return (
                f"not known: a search from {self.starts:,} random starts, of which the last {self.quiet:,} found"
                " nothing new"
            )
        ended = self.paths - self.lost
        parts = [f"{self.real} at real solutions", f"{self.unreal} at complex ones"]
        parts += [f"{self.at_infinity} at infinity"] * bool(self.at_infinity)
        parts += [f"{self.singular} at singular solutions"] * bool(self.singular)
        parts += [f"{self.beside} at poses that violate a further condition"] * bool(self.beside)
        ways = f"{ended} of {self.paths} paths ended, {', '.join(parts)}"
        if self.lost:
            return f"not complete: {ways}; {self.lost} lost"
        if self.proved:
            return f"complete, proved: {ways}, each certified; six conditions have no more isolated solutions"
        return f"complete: {ways}"

    def to_json(self) -> dict[str, Any]:
        counts = ("paths", "real", "unreal", "certified", "at_infinity", "singular", "beside", "lost", "unreached")
        return {
            "complete": self.complete,
            "proved": self.proved,
            "method": self.method,
            **{n: getattr(self, n) for n in (*counts, "starts", "quiet")},
            "dependent": self.dependent,
            "missed": self.missed,
            "text": self.text,
        }


@dataclass(frozen=True)
class AssemblyModes(Shown):
    """All real solutions of the direct kinematics of a mechanism for values of its actuators, `asked` in words, ordered
    by their margin, the given pose first. Isolated ones are `modes`, others lie on `curves`. `len` is that of `modes`.
    """

    mechanism: SixLegs | Limbs
    title: str
    unit: str
    asked: str
    actuators: tuple[tuple[str, float], ...]
    centre: tuple[float, ...]
    modes: tuple[AssemblyMode, ...]
    curves: tuple[SolutionCurve, ...]
    completeness: Completeness
    notes: tuple[str, ...] = ()

    def __len__(self) -> int:
        return len(self.modes)

    def __getitem__(self, place: int) -> AssemblyMode:
        return self.modes[place]

    @property
    def certified(self) -> bool:
        """Whether it is proved of each mode that it is exactly one solution."""
        return all(m.certificate.proved for m in self.modes)

    @property
    def verdict(self) -> str:
        """How many there are, in words."""
        number = len(self.modes)
        words = f"{number or 'no'} real {'solution' if number == 1 else 'solutions'}"
        if self.completeness.missed:
            words += ", besides the given pose, to which no path led"
        if self.curves:
            curves = "a curve" if len(self.curves) == 1 else f"{len(self.curves)} curves"
            met = f"{curves} of solutions (self-motion), which may lie on a surface of them"
            return met + (f", and {words} beside" if number else "")
        return words

    def picture(self) -> Any:
        """The robot in each mode, in rows, in their order: a drawing with `svg()`. Raises InputError where there is
        none.
        """
        return self._show("picture")

    def to_json(self) -> dict[str, Any]:
        """One JSON object; lengths in the unit, angles in rad."""
        return {
            "schema": 1,
            "title": self.title,
            "unit": self.unit,
            "asked": self.asked,
            "about": list(self.centre),
            "actuators": dict(self.actuators),
            "verdict": self.verdict,
            "certified": self.certified,
            "completeness": self.completeness.to_json(),
            "modes": [m.to_json() for m in self.modes],
            "curves": [c.to_json() for c in self.curves],
            "notes": list(self.notes),
        }

    def __repr__(self) -> str:
        return f"<AssemblyModes {self.title or self.asked}: {self.verdict}>"
