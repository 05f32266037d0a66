r"""All poses in which the legs of a platform have given lengths."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.coordinates import coordinates, without_rounding
from gcrules.mechanisms.kinematics.rigid_motions import Floats, change_about
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.modes.conditions import forms_of_pairs, motions
from gcrules.poses.modes.report import (
    AssemblyMode,
    AssemblyModes,
    BoxCertificate,
    Completeness,
    SolutionCurve,
    in_order,
)
from gcrules.poses.modes.singular_ends import MultipleSolution, SelfMotion, curves_of, grouped
from gcrules.poses.modes.zeros import NEEDED, Zeros, rank_of, zeros_of
from gcrules.poses.numbers.arrays import from_poses
from gcrules.poses.numbers.report import PoseReport
from gcrules.poses.pose_report import report_of_legs
from gcrules.poses.signs.of_legs import signs_of_legs
from gcrules.poses.signs.sign import FactorSign
from gcrules.screws.pose import FAR, Pose, exact_float, too_far
from gcrules.screws.pose_text import COORDINATES, Amount, read_named
from gcrules.screws.study import study
from gcrules.screws.threshold import Threshold

__all__ = ["modes_of_legs"]

_LONGEST = 1000  # sizes: of longer legs the conditions are nearly alike
_NEAR = 1e-3  # rad, and sizes: a multiple solution is known to a root of the accuracy of floats
_ROUNDING = 1e-12  # rad, and sizes
_ZERO = 1e-9  # of a factor, where the platform is singular, in parts of its value in the pose of the file
_METHOD = "exactly one solution in its box (Krawczyk's operator)"
_MULTIPLE = "singular: its box cannot hold exactly one regular solution"
_UNPROVED = "not proved: floats do not show that its box holds exactly one solution"


def modes_of_legs(m: SixLegs, at: Pose | None, actuators: Any, threshold: Threshold) -> AssemblyModes:
    """All of them, for the lengths at a pose, those of the file if there is none, or for lengths that are given."""
    legs = _Legs.of(m, at, actuators)
    zeros: Zeros | None = None
    several: list[MultipleSolution] = []
    unclear = 0
    if rank_of(legs.forms) < NEEDED:
        curves = curves_of(legs.forms, legs.given_parameters)
    else:
        zeros = zeros_of(legs.forms, legs.sizes)
        several, curves, unclear = grouped(legs.forms, zeros.singular)
    places = [] if zeros is None else _regular(legs, zeros)
    places += [_Place(s.x, BoxCertificate(False, _MULTIPLE), s.paths) for s in several]
    given = _given(legs, places)
    found = [_mode(legs, one, threshold, given=one is given) for one in places]
    return AssemblyModes(
        mechanism=m,
        title=m.title,
        unit=m.unit,
        asked=legs.asked,
        actuators=legs.actuators,
        centre=tuple(map(float, m.rig.centre)),
        modes=in_order(found),
        curves=tuple(_curve(legs, c) for c in curves),
        completeness=replace(
            Completeness(dependent=True) if zeros is None else _counts(zeros, unclear),
            missed=legs.given is not None and not any(m.given for m in found) and not any(map(legs.holds, curves)),
        ),
        notes=() if at is None else at.notes,
    )


@dataclass(frozen=True, eq=False)
class _Legs:
    """The legs with their lengths, as forms, of motions whose shift is that of the middle of the platform in sizes; the
    centre of poses is `away` from it, in sizes. The `given` pose is that from which the lengths come, if there is one.
    """

    m: SixLegs
    forms: Floats
    sizes: Floats
    lengths: Floats
    away: Floats
    given: Pose | None
    asked: str

    @classmethod
    def of(cls, m: SixLegs, at: Pose | None, actuators: Any) -> _Legs:
        moving = m.rig
        pose = at or Pose()
        shift, turn = from_poses([pose])
        body = np.array([[float(c) for c in moving.points[b]] for _, b in moving.legs])
        middle = body.mean(axis=0)
        away = (moving.centre_of_turns - middle) / moving.size
        if not np.abs(away).max() <= FAR:
            raise too_far("the centre is")
        ends = moving.ends(shift, turn)[0] if actuators is None else body
        lengths = np.linalg.norm(ends - moving.base, axis=1)
        given, asked = pose if actuators is None else None, "the lengths at the pose of the file"
        if actuators is not None:
            lengths = _lengths(m, actuators, lengths)
            asked = "the lengths that are given"
        elif at is not None:
            asked = f"the lengths at {at}"
        if not lengths.max() <= _LONGEST * moving.size:
            raise InputError(
                f"a leg is more than {_LONGEST:,} times as long as the robot's size, too long for floats",
                hint="check the unit, and the pose",
            )
        if not (lengths > 0).all():
            raise InputError(
                f"the leg {moving.names[int(np.argmin(lengths))]} has no length in the pose of the file",
                hint="give its length, too",
            )
        base, arms = ((p - middle) / moving.size for p in (moving.base, body))
        forms, sizes = forms_of_pairs(base, arms, lengths / moving.size)
        return cls(m, forms, sizes, lengths, away, given, asked)

    @property
    def actuators(self) -> tuple[tuple[str, float], ...]:
        return tuple(zip(self.m.actuators, self.lengths.tolist(), strict=True))

    @property
    def given_parameters(self) -> Floats | None:
        """The Study parameters of the given pose."""
        if self.given is None:
            return None
        (shift,), (turn,) = from_poses([self.given])
        motion = np.eye(4)
        motion[:3, :3], motion[:3, 3] = turn, shift / self.m.rig.size + self.away - turn @ self.away
        return study(motion)

    def holds(self, c: SelfMotion) -> bool:
        """Whether the given pose lies on a curve."""
        known = self.given_parameters
        return known is not None and c.near(known)

    def motion(self, x: Floats) -> Floats:
        """The motion (4, 4) with these Study parameters, the shift being that of the centre, in the unit."""
        found: Floats = motions(x[None])[0]
        found[:3, 3] = (found[:3, 3] + found[:3, :3] @ self.away - self.away) * self.m.rig.size
        return found

    def pose(self, x: Floats) -> Pose:
        """The pose with these Study parameters."""
        tx, ty, tz = (Fraction(c) for c in self.motion(x)[:3, 3].tolist())
        w, i, j, k = (Fraction(c) for c in (x[:4] / np.linalg.norm(x[:4])).tolist())
        return Pose((tx, ty, tz), (w, i, j, k))


def _lengths(m: SixLegs, given: Any, before: Floats) -> Floats:
    """The lengths by the names of the legs, those that are not named as `before`; or all six in their order."""
    names = m.actuators
    if isinstance(given, str):
        words = given.replace(",", " ").split()
        if "=" in given:
            named: Mapping[str, Any] = read_named(given, dict.fromkeys(names, False), m.unit, "--actuators", "leg")
            return _lengths(m, named, before)
        given = [_number(word) for word in words]
    if isinstance(given, Mapping):
        unknown = [n for n in given if n not in names]
        if unknown:
            raise InputError(f"there is no leg {str(unknown[0])[:40]!r}", hint=f"the legs are {', '.join(names)}")
        values = [_length(given[n], n) if n in given else float(b) for n, b in zip(names, before, strict=True)]
    else:
        listed: Sequence[Any] = list(given)
        if len(listed) != len(names):
            raise InputError(f"{len(listed)} lengths, and the platform has six legs", hint=f"give {', '.join(names)}")
        values = [_length(v, n) for v, n in zip(listed, names, strict=True)]
    return np.array(values)


def _number(word: str) -> float:
    try:
        return float(Fraction(word))
    except (ValueError, ZeroDivisionError):
        raise InputError(
            f"{word[:40]!r} is not a length", hint='give six lengths, "1 1 1 1 1 1", or some by name, "ab=1.2"'
        ) from None


def _length(value: Any, name: str) -> float:
    length = float(value) if isinstance(value, Amount) else exact_float(value, name)
    if length <= 0:
        raise InputError(f"the length of the leg {name} is not positive")
    return length


@dataclass(frozen=True, eq=False)
class _Place:
    """Study parameters x (8,) of a solution, what is proved of it, and how many paths end there."""

    x: Floats
    certificate: BoxCertificate
    paths: int = 1


def _regular(legs: _Legs, zeros: Zeros) -> list[_Place]:
    found, b = [], zeros.boxes
    proved, away = b.proved, float(np.linalg.norm(legs.away))
    for k in range(len(b.y)):
        checkpoint()
        if b.unreal[k] or (np.abs(b.y[k].imag).max() > 0):
            continue
        turn, shift = b.bounds(k)
        certificate = BoxCertificate(False, _UNPROVED)
        if proved[k]:
            certificate = BoxCertificate(True, _METHOD, True, turn, (shift + turn * away) * legs.m.rig.size)
        found.append(_Place(b.y[k].real, certificate))
    return found


def _given(legs: _Legs, places: Sequence[_Place]) -> _Place | None:
    """The solution that is the pose from which the lengths come: the nearest one, if that pose lies in its box, or near
    to it where no box is known.
    """
    known = legs.given_parameters
    if known is None or not places:
        return None
    there = legs.motion(known)

    def apart(one: _Place) -> tuple[float, float]:
        change = change_about(legs.away * legs.m.rig.size, there, legs.motion(one.x))
        return float(np.linalg.norm(change[3:])), float(np.linalg.norm(change[:3])) / legs.m.rig.size

    one = min(places, key=lambda one: sum(apart(one)))
    turn, shift = apart(one)
    if not one.certificate.proved:
        return one if turn + shift <= _NEAR else None
    box = one.certificate.turn or 0.0, (one.certificate.shift or 0.0) / legs.m.rig.size
    return one if turn <= 2 * box[0] + _ROUNDING and shift <= 2 * box[1] + _ROUNDING else None


def _mode(legs: _Legs, place: _Place, threshold: Threshold, *, given: bool) -> AssemblyMode:
    x = place.x
    if given and (known := legs.given_parameters) is not None:
        x = known
    pose = legs.given if given and legs.given is not None else legs.pose(x)
    report = report_of_legs(legs.m, pose, threshold=threshold, nearest=False, quick=True)
    moved = coordinates(COORDINATES, legs.motion(x)[None], np.zeros(3))[0]
    values = without_rounding(COORDINATES, moved, legs.m.rig.size)
    return AssemblyMode(
        number=0,
        pose=pose,
        coordinates=dict(zip(COORDINATES, values.tolist(), strict=True)),
        actuators=legs.actuators,
        margin=report.margin,
        verdict=report.verdict,
        factors=_signs(legs.m, report),
        certificate=place.certificate,
        report=report,
        given=given,
        multiplicity=place.paths,
    )


def _signs(m: SixLegs, report: PoseReport) -> tuple[FactorSign, ...]:
    """The signs that its poses have; where it is singular floats do not give the pose so well that rounding has one."""
    there = signs_of_legs(m, report.pose)
    if report.verdict != "singular":
        return there
    if len(there) == 1:
        return (replace(there[0], sign=0),)
    home = signs_of_legs(m, Pose())
    return tuple(
        replace(s, value=0.0, sign=0) if abs(s.value) <= _ZERO * abs(h.value) else s
        for s, h in zip(there, home, strict=True)
    )


def _counts(z: Zeros, unclear: int) -> Completeness:
    real = ~z.boxes.unreal & (np.abs(z.boxes.y.imag).max(axis=1, initial=0.0) == 0)
    return Completeness(
        paths=z.paths,
        real=int(real.sum()),
        unreal=int((~real).sum()),
        certified=int(z.boxes.proved.sum()),
        at_infinity=z.at_infinity,
        singular=len(z.singular) - unclear,
        beside=z.beside,
        lost=z.lost + unclear,
    )


def _curve(legs: _Legs, c: SelfMotion) -> SolutionCurve:
    return SolutionCurve(tuple(map(legs.pose, c.x)), c.closed, legs.holds(c))
