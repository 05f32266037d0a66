r"""All configurations of a robot of joints whose actuators have given values."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.floats import without_noise
from gcrules.mechanisms.kinematics.branch import Cells
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.coordinates import coordinates
from gcrules.mechanisms.kinematics.failure_reasons import NotClosed
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.solve import Solution, solve
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.limbs.pose_report import report_at, target_of
from gcrules.poses.limbs.report import RobotPose
from gcrules.poses.limbs.way_from_home import WayFromHome as Way
from gcrules.poses.modes.conditions import about_centre, forms_of_limb, motions
from gcrules.poses.modes.limb_joints import Held, configurations, same_spans, spans_of, with_turned_balls
from gcrules.poses.modes.report import (
    AssemblyMode,
    AssemblyModes,
    BoxCertificate,
    Completeness,
    SolutionCurve,
    factor_signs,
    in_order,
)
from gcrules.poses.modes.search import search
from gcrules.poses.modes.singular_ends import SelfMotion, grouped
from gcrules.poses.modes.zeros import NEEDED, zeros_of
from gcrules.poses.numbers.report import PoseReport
from gcrules.screws.pose import Pose
from gcrules.screws.pose_text import COORDINATES, SHIFTS
from gcrules.screws.study import study
from gcrules.screws.threshold import Threshold

__all__ = ["forms_of", "modes_of_limbs"]

_INDEPENDENT = 1e-9  # least singular value of independent forms of length 1
_ROUNDING = 1e-13
_SQUARE = "exactly one solution in its box of joints (Krawczyk's operator)"
_UNIQUE = "the only solution in its box of joints (Krawczyk's operator); that the over-constrained loops close there is"
_UNPROVED = "not proved: it is singular, or nearly so"


def modes_of_limbs(m: Limbs, at: Any, actuators: Any, degrees: bool, threshold: Threshold) -> AssemblyModes:
    """All of them, for the actuators at a pose, at home if there is none, or for amounts that are given."""
    robot = _HeldRobot.of(m, at, actuators, degrees)
    known = None if m.linkage.looped else forms_of(robot.linkage, robot.held)
    if known is None or len(known) < NEEDED:
        found, curves, count, notes = _sought(robot)
    else:
        found, curves, count, notes = _solved(robot, known)
    modes = _one_given(robot, [_mode(robot, c, threshold, paths) for c, paths in found])
    return AssemblyModes(
        mechanism=m,
        title=m.title,
        unit=m.unit,
        asked=robot.asked,
        actuators=robot.actuators(robot.held.amounts),
        centre=tuple(map(float, m.linkage.centre)),
        modes=in_order(modes),
        curves=tuple(curves),
        completeness=replace(count, missed=_missed(robot, modes, curves)),
        notes=(*notes, *m.linkage.notes),
    )


def _one_given(robot: _HeldRobot, modes: list[AssemblyMode]) -> list[AssemblyMode]:
    """The modes, of which only the nearest one is the configuration that the actuators come from."""
    if robot.given is None or sum(one.given for one in modes) < 2:
        return modes
    m = robot.linkage
    home = coordinates(COORDINATES, robot.given.platform[None], m.centre)[0]

    def apart(one: AssemblyMode) -> float:
        change = np.array([one.coordinates[n] for n in COORDINATES]) - home
        return float(np.abs(change / np.array([m.size if n in SHIFTS else 1.0 for n in COORDINATES])).max())

    nearest = min((one for one in modes if one.given), key=apart)
    return [one if one is nearest else replace(one, given=False, report=_elsewhere(one.report)) for one in modes]


def _elsewhere(found: PoseReport | RobotPose) -> PoseReport | RobotPose:
    """The numbers of a configuration to which no way from home is known."""
    return replace(found, assembly=Way(doubt=0.0)) if isinstance(found, RobotPose) else found


def _missed(robot: _HeldRobot, modes: Sequence[AssemblyMode], curves: Sequence[SolutionCurve]) -> bool:
    """Whether the configuration that the actuators come from is neither a mode nor on a curve."""
    return robot.given is not None and not any(one.given for one in modes) and not any(c.through_given for c in curves)


@dataclass(frozen=True, eq=False)
class _HeldRobot:
    """The robot with its actuators held at what is `asked`; `given` is the configuration that they come from."""

    m: Limbs
    linkage: Linkage
    held: Held
    given: Configuration | None
    asked: str

    @classmethod
    def of(cls, m: Limbs, at: Any, actuators: Any, degrees: bool) -> _HeldRobot:
        linkage = m.linkage
        turned = with_turned_balls(linkage)
        target = target_of(linkage, at, actuators, degrees)
        if target is None:
            return cls(m, turned, Held.of(linkage, linkage.home.joint_values), linkage.home, "the actuators at home")
        if target.driven and not m.robot.redundant:
            amounts = [a.copy() for a in linkage.home.joint_values]
            for a, value in zip(leading(linkage), target.values, strict=True):
                amounts[a.place][a.coordinate] = value
            return cls(m, turned, Held.of(linkage, amounts), None, f"the actuators at {target.text}")
        there = solve(linkage, target).configuration
        return cls(m, turned, Held.of(linkage, there.joint_values), there, f"the actuators at {target.text}")

    def holds(self, c: SelfMotion) -> bool:
        """Whether the configuration that the actuators come from lies on a curve."""
        if self.given is None:
            return False
        m = self.linkage
        return c.near(study(about_centre(self.given.platform, m.centre, m.size)))

    def actuators(self, amounts: tuple[Floats, ...]) -> tuple[tuple[str, float], ...]:
        units = ((a, 1.0 if a.angle else self.linkage.size) for a in self.m.linkage.actuators)
        return tuple((a.name, without_noise(amounts[a.place][a.coordinate], unit)) for a, unit in units)


def forms_of(m: Linkage, held: Held) -> Floats:
    """The independent linear forms (k, 17) that vanish wherever all limbs reach with their actuators held."""
    limbs = zip(m.home.chains, held.amounts, held.free, strict=True)
    every = np.concatenate([forms_of_limb(c, a, free, m.centre, m.size) for c, a, free in limbs])
    if not len(every):
        return every
    _, s, v = np.linalg.svd(every, full_matrices=False)
    return np.asarray(v[s > _INDEPENDENT])


Found = tuple[list[tuple[Configuration, int]], list[SolutionCurve], Completeness, list[str]]


def _solved(robot: _HeldRobot, forms: Floats) -> Found:
    """What the paths lead to."""
    m = robot.linkage
    zeros = zeros_of(forms, np.ones_like(forms))
    several, curves, unclear = grouped(forms, zeros.singular)
    b = zeros.boxes
    real = np.abs(b.y.imag).max(axis=1, initial=0.0) == 0
    places = [(x.real, 1) for x in b.y[real]] + [(s.x, s.paths) for s in several]
    found: list[tuple[Configuration, int]] = []
    faults: dict[str, int] = {}
    for x, paths in places:
        checkpoint()
        try:
            found += [(c, paths) for c in configurations(m, robot.held, _from_home(m, x))]
        except NotClosed as fault:
            faults[str(fault)] = faults.get(str(fault), 0) + 1
    notes = [f"{n} of the real solutions left out: {why}" for why, n in faults.items()]
    count = Completeness(
        paths=zeros.paths,
        real=int(real.sum()),
        unreal=int((~real).sum()),
        at_infinity=zeros.at_infinity,
        singular=len(zeros.singular) - unclear,
        beside=zeros.beside,
        lost=zeros.lost + unclear,
        unreached=sum(faults.values()),
    )
    return found, [_curve(robot, c) for c in curves], count, notes


def _sought(robot: _HeldRobot) -> Found:
    """What a search finds."""
    found = search(robot.linkage, robot.held)
    notes = [f"{n} of the starts led out of the robot's family: {why}" for why, n in found.outside.items()]
    if found.many:
        notes.append("the search kept finding new configurations: solutions lie on curves or surfaces (self-motion)")
    return (
        [(c, 1) for c in found.found],
        [],
        Completeness(method="search", starts=found.starts, quiet=found.quiet),
        notes,
    )


def _from_home(m: Linkage, x: Floats) -> Floats:
    """The motion of the platform from home with these Study parameters, whose shift is that of the centre in sizes."""
    motion: Floats = motions(x[None])[0]
    motion[:3, 3] = m.centre + m.size * motion[:3, 3] - motion[:3, :3] @ m.centre
    return motion


def _pose(m: Linkage, platform: Floats) -> Pose:
    """The motion from home as a pose about the centre."""
    turned = np.eye(4)
    turned[:3, :3] = platform[:3, :3]
    quaternion = study(turned)[:4]
    quaternion = np.where(np.abs(quaternion) <= _ROUNDING, 0.0, quaternion)
    shift = platform[:3, :3] @ m.centre + platform[:3, 3] - m.centre
    shift = np.where(np.abs(shift) <= _ROUNDING * m.size, 0.0, shift)
    tx, ty, tz = map(Fraction, shift.tolist())
    w, i, j, k = map(Fraction, quaternion.tolist())
    return Pose((tx, ty, tz), (w, i, j, k))


def _mode(robot: _HeldRobot, c: Configuration, threshold: Threshold, paths: int) -> AssemblyMode:
    m = robot.linkage
    solution = Solution(c, Target((), np.zeros(0), text="assembly mode"))
    found = report_at(m, robot.m.analysis, solution, threshold)
    given = robot.given is not None and same_spans(spans_of(m, robot.held, c), spans_of(m, robot.held, robot.given))
    report = replace(found, assembly=Way(at_home=robot.given is robot.m.linkage.home) if given else Way(doubt=0.0))
    return AssemblyMode(
        number=0,
        pose=_pose(m, c.platform),
        coordinates=found.coordinates,
        actuators=robot.actuators(c.joint_values),
        margin=found.margin,
        verdict=found.verdict,
        factors=factor_signs(found),
        certificate=_certificate(robot, c),
        report=report,
        given=given,
        multiplicity=paths,
    )


def _certificate(robot: _HeldRobot, c: Configuration) -> BoxCertificate:
    """By the equations of the loops, with the driven joints held."""
    m = robot.linkage
    leads = leading(m)
    wanted = Target(tuple(a.name for a in leads), np.zeros(len(leads)), driven=True)
    cells = Cells.around(m, wanted, Configurations.of([c]), np.zeros((1, len(leads))))
    if not cells.one_branch[0]:
        return BoxCertificate(False, _UNPROVED)
    if m.robot.family.plane or not _over_constrained(m, robot.held):
        return BoxCertificate(True, _SQUARE, True)
    return BoxCertificate(False, f"{_UNIQUE} numerical", True)


def _over_constrained(m: Linkage, held: Held) -> bool:
    """Whether the loops are more equations than there are unknown joints. In the plane that is no matter: what is out
    of it vanishes anyway.
    """
    loops = len(m.robot.limbs) - 1 + sum(len(c.loops) for c in m.home.chains)
    return 6 * loops > sum(map(len, held.free))


def _curve(robot: _HeldRobot, c: SelfMotion) -> SolutionCurve:
    m = robot.linkage
    return SolutionCurve(tuple(_pose(m, _from_home(m, x)) for x in c.x), c.closed, robot.holds(c))
