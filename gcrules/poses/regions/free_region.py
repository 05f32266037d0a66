r"""The largest box, or ball, of given proportions around a pose that is proved free of singular ones.

A scale is proved by boxes that cover the region (`cover`). Scales are doubled while they are proved, then halved
towards the first that is not. What is found is proved; that no larger one is free is not, and the answer says where its
proof ended.

>>> found = free_region("3-rpr")
>>> found.names, found.scale > 0.05
(('x', 'y', 'yaw'), True)
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.coordinates import without_rounding
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.solve import check_target, free_coordinates, solve
from gcrules.mechanisms.kinematics.targets import Target, written
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.load import Folders, Source
from gcrules.mechanisms.mechanism import Mechanism, mechanism
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.everywhere import check_architecture
from gcrules.poses.limbs.pose_report import target_of
from gcrules.poses.methods import Methods, as_six_legs, method
from gcrules.poses.numbers.pose_arguments import read_one
from gcrules.poses.plans.leg_space import row_of
from gcrules.poses.plans.limb_domain import STEEPEST, limb_space
from gcrules.poses.regions.cover import Cover, Prover, covered
from gcrules.poses.regions.extent import ACTUATORS, Extent, parse_extents
from gcrules.poses.regions.leg_prover import NAMES, LegProver
from gcrules.poses.regions.limb_prover import LimbProver
from gcrules.poses.regions.report import FreeRegion
from gcrules.screws.pose import Pose
from gcrules.screws.pose_text import ANGLES, HOME, VECTOR

__all__ = ["free_region", "region_of"]

_MOST = 1_000_000
_BOXES = 40_000, 4_000  # for a scale: of six legs, of joints
_FIRST, _LEAST, _LARGEST = 1 / 8, 1 / 4096, 8.0
_HALVINGS = 6


def free_region(
    source: Source,
    at: Any = None,
    *,
    over: str | None = None,
    ball: bool = False,
    boxes: int | None = None,
    about: str | Sequence[Any] = "centroid",
    plugins: Folders = (),
) -> FreeRegion:
    """The largest box around a pose, or with `ball` the largest ball, in which it is proved that nothing is singular.

    `source`, `at` (home without it) and `about` are those of `pose`. `over` names coordinates with their proportions:
    "x, y, z", "x 2, y 1, z 1", "rx 30 deg, ry 30 deg"; those left out are the robot's size and 1 rad. Of a platform on
    six legs they are shifts x, y, z and the components rx, ry, rz of a rotation vector by which it is turned further,
    of a robot of joints independent coordinates of its platform, the others keeping their values; or "actuators", whose
    ranges keep the robot regular on its branch. A scale is given up that so many `boxes` do not prove: by default
    40,000 of six legs, 4,000 of joints.

    Raises InputError for what is no pose and no coordinate, and where the robot is singular.
    """
    return region_of(mechanism(source, about=about, plugins=plugins), at, over, boxes, ball=ball)


def region_of(
    found: Mechanism, at: Any = None, over: str | None = None, boxes: int | None = None, *, ball: bool = False
) -> FreeRegion:
    """The free region of a mechanism; arguments and errors as for `free_region`."""
    if boxes is not None and not 1 <= boxes <= _MOST:
        raise InputError(f"{boxes} boxes, expected 1 to {_MOST:,}")
    question = method(_QUESTION, found, "a free region")(at, over)
    proved, tried = _largest(question.prover, boxes or question.boxes, question.largest, ball=ball)
    return _answer(question, proved, tried, ball=ball)


@dataclass(frozen=True, eq=False)
class _Question:
    """What is asked for: of a mechanism, if it has six legs around the pose `at`, `names` with the values `centre` in
    the middle; scales of at most `largest`.
    """

    mechanism: Mechanism
    at: Pose | None
    pose: str
    names: tuple[str, ...]
    angles: tuple[bool, ...]
    driven: bool
    centre: Floats
    prover: Prover
    largest: float
    boxes: int
    notes: tuple[str, ...] = ()


Scaled = tuple[float, Cover]


def _largest(p: Prover, most: int, largest: float, *, ball: bool) -> tuple[Scaled, Scaled | None]:
    """The largest scale that is proved, and the least one that was tried and is not. Raises InputError for none."""
    scale = min(_FIRST, largest)
    low: Scaled | None = None
    high: Scaled | None = None
    while low is None:
        found = covered(p, scale, most, ball=ball)
        if found.proved:
            low = scale, found
        elif scale < _LEAST:
            raise InputError(
                "nothing is proved, however small the region: the pose is singular, or too close to it",
                hint="choose another pose, or more --boxes",
            )
        else:
            high = scale, found
            scale /= 2
    while high is None and low[0] < largest:
        scale = min(2 * low[0], largest)
        found = covered(p, scale, most, ball=ball)
        if found.proved:
            low = scale, found
        else:
            high = scale, found
    for _ in range(_HALVINGS if high is not None else 0):
        assert high is not None
        scale = (low[0] + high[0]) / 2
        found = covered(p, scale, most, ball=ball)
        if found.proved:
            low = scale, found
        else:
            high = scale, found
    return low, high


def _answer(q: _Question, proved: Scaled, tried: Scaled | None, *, ball: bool) -> FreeRegion:
    weights = q.prover.weights
    worst = q.centre + (tried[1].worst if tried else 0.0) * weights
    return FreeRegion(
        title=q.mechanism.title,
        unit=q.mechanism.unit,
        shape="ball" if ball else "box",
        pose=q.pose,
        names=q.names,
        angles=q.angles,
        driven=q.driven,
        centre=tuple(q.centre.tolist()),
        weights=tuple(weights.tolist()),
        scale=proved[0],
        boxes=proved[1].boxes,
        tried=tried[0] if tried else None,
        worst=dict(zip(q.names, worst.tolist(), strict=True)),
        margin=tried[1].margin if tried else 0.0,
        mechanism=q.mechanism,
        at=q.at,
        notes=q.notes,
    )


def _of_legs(m: SixLegs, at: Any, over: str | None) -> _Question:
    if over is not None and over.strip().lower() == ACTUATORS:
        raise InputError(
            "ranges of the legs' lengths are for robots that are described by their joints",
            hint="describe the legs as limbs UP*S, as gough-stewart does",
        )
    check_architecture(m)
    pose = read_one(HOME if at is None else at, m.unit)
    kinds = {n: n in VECTOR for n in NAMES}
    extents = parse_extents(over if over is not None else ", ".join(NAMES), kinds, m.rig.size, m.unit)
    names, weights = _parts(extents)
    turning = float(np.linalg.norm([e.width for e in extents if kinds[e.name]]))
    largest = min(_LARGEST, np.pi / turning) if turning else _LARGEST
    prover = LegProver(m.rig, names, weights, row_of(pose))
    angles = tuple(kinds[n] for n in names)
    middle = np.zeros(len(names))
    where = "home" if at is None else str(at)
    return _Question(m, pose, where, names, angles, False, middle, prover, largest, _BOXES[0])


def _parts(extents: Sequence[Extent]) -> tuple[tuple[str, ...], Floats]:
    return tuple(e.name for e in extents), np.array([e.width for e in extents])


def _of_limbs(m: Limbs, at: Any, over: str | None) -> _Question:
    driven = over is not None and over.strip().lower() == ACTUATORS
    if not driven and (legs := as_six_legs(m)) is not None:
        return _of_legs(legs, at, over)
    k = m.linkage
    target = target_of(k, at, None)
    every = free_coordinates(k)
    named = _named(m, over) if not driven else ()
    names = free_coordinates(k, tuple(e.name for e in named)) if named else every
    lost = [e.name for e in named if e.name not in names]
    if lost:
        raise InputError(
            f"{lost[0]} follows from the other coordinates near home",
            hint=f"independent there are, for example, {', '.join(every)}",
        )
    check_target(k, Target(names, np.zeros(len(names))))
    start, place = _start(m, names, target)
    if driven:
        leads = leading(k)
        weights = np.array([1.0 if a.angle else k.size for a in leads])
        centre = np.array([start[_column(m, a.place, a.coordinate)] for a in leads])
        wanted = Target(tuple(a.name for a in leads), centre, driven=True, text=ACTUATORS)
        angles = tuple(a.angle for a in leads)
        largest = min([_LARGEST, *(np.pi / w for w, a in zip(weights, angles, strict=True) if a)])
    else:
        widths = {e.name: e.width for e in named} or {n: 1.0 if n in ANGLES else k.size for n in names}
        weights = np.array([widths.get(n, 0.0) for n in names])
        centre = place
        wanted = Target(names, centre, text="region")
        angles = tuple(n in ANGLES for n in names)
        largest = _within_angles(names, centre, weights)
    prover = LimbProver(m, wanted, centre, weights, start)
    pose = "home" if target is None else written(dict(zip(names, place.tolist(), strict=True))).strip('"')
    names, notes = wanted.names, tuple(k.notes)
    return _Question(m, None, pose, names, angles, driven, centre, prover, largest, _BOXES[1], notes)


def _named(m: Limbs, over: str | None) -> tuple[Extent, ...]:
    if over is None:
        return ()
    plane = m.linkage.robot.family.plane
    known = ("x", "y", "yaw") if plane else ("x", "y", "z", "roll", "pitch", "yaw")
    return parse_extents(over, {n: n in ANGLES for n in known}, m.linkage.size, m.unit)


def _start(m: Limbs, names: tuple[str, ...], target: Target | None) -> tuple[Floats, Floats]:
    """The amounts of all joints at the pose, and its coordinates; straight from home. Raises InputError."""
    space = limb_space(m, names, (), 0.0, None, None)
    if target is None:
        return np.zeros(space.joints), np.zeros(len(names))
    row = space.row_of(solve(m.linkage, target).configuration)
    return row[len(names) :], without_rounding(names, row[: len(names)], m.linkage.size)


def _column(m: Limbs, place: int, coordinate: int) -> int:
    """Where an amount of a limb stands among those of all."""
    return sum(len(c.turns) for c in m.linkage.home.chains[:place]) + coordinate


def _within_angles(names: Sequence[str], centre: Floats, weights: Floats) -> float:
    """The largest scale at which no angle leaves its range: half a turn both ways, the pitch nearly a right angle."""
    found = [_LARGEST]
    for name, middle, weight in zip(names, centre.tolist(), weights.tolist(), strict=True):
        if name in ANGLES and weight:
            found.append((STEEPEST - abs(middle) if name == "pitch" else np.pi) / weight)
    return min(found)


_QUESTION: Methods[_Question] = {SixLegs: _of_legs, Limbs: _of_limbs}
"""What is asked for of each kind of mechanism."""
