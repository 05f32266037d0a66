r"""A map of a robot of joints: the slice of coordinates or actuators, and what is computed over it.

>>> from gcrules.mechanisms.mechanism import mechanism
>>> task = limbs_task(mechanism("3-rpr"), ["x -0.1:0.1:5", "yaw 10:60:5 deg"])
>>> task.grid.names, task.grid.rest
(('x', 'yaw', 'y'), 'y = 0')
>>> [int((task.compute(0)["cell_status"] == k).sum()) for k in range(4)]  # free, crossed, undecided, outside
[8, 4, 4, 0]
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import fields, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.english import listed
from gcrules.core.errors import InputError, LimitReached
from gcrules.core.frozen import HoldsArrays
from gcrules.core.version import __version__
from gcrules.mechanisms.kinematics.amplification import INDICES
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.loops import Course
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.solve import check_target, free_coordinates, solve
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.limbs.boxes import proved_cells
from gcrules.poses.limbs.sweep import Sweep
from gcrules.poses.limits import LengthLimits, parse_limits
from gcrules.poses.maps.axes import ACTUATOR, TRANSLATION, TURNS, GridAxis, read_axes
from gcrules.poses.maps.summary import MapSummary
from gcrules.poses.maps.task import Chunk
from gcrules.screws.pose import exact_float
from gcrules.screws.pose_text import ANGLES, COORDINATES, Amount, check_known, read_named

__all__ = ["MAX_POSES", "LimbsGrid", "LimbsTask", "coordinates_of", "limbs_task"]

MAX_POSES = 1_000_000
_ALL_ROUND = 2 * math.pi


@dataclass(frozen=True)
class LimbsGrid:
    """Poses over `axes`: `names` are the coordinates that determine a pose, or all actuators where `driven`, `values`
    what they are (from home, in radians and the file's unit) where no axis stands for them.
    """

    axes: tuple[GridAxis, ...]
    names: tuple[str, ...]
    values: tuple[float, ...]
    driven: bool
    title: str
    actuators: tuple[str, ...]
    angles_driven: tuple[bool, ...]
    unit: str = ""
    notes: tuple[str, ...] = ()

    @property
    def shape(self) -> tuple[int, ...]:
        return tuple(a.number for a in self.axes)

    @property
    def size(self) -> int:
        return math.prod(self.shape)

    @property
    def moved(self) -> bool:
        """Whether home is not in the slice."""
        return any(self.values)

    @property
    def home(self) -> tuple[float, ...]:
        """Home in the axes' coordinates, not a number where it is not in the slice."""
        return tuple(math.nan if self.moved else 0.0 for _ in self.axes)

    @property
    def rest(self) -> str:
        """What the other coordinates are, in words."""
        over = {a.name for a in self.axes}
        pairs = [(n, v) for n, v in zip(self.names, self.values, strict=True) if n not in over]
        named = ", ".join(f"{n} = {math.degrees(v):.6g}°" if n in TURNS and v else f"{n} = {v:.6g}" for n, v in pairs)
        return named or "none: the axes are all that the robot has"

    def coordinates(self, nodes: NDArray[Any]) -> Floats:
        """The coordinates (N, axes) of places (N, axes) that are counted in nodes."""
        return np.stack([a.at(nodes[:, k]) for k, a in enumerate(self.axes)], axis=1)

    def places(self, coordinates: Floats) -> Floats:
        """The places (N, axes), counted in nodes, of coordinates."""
        start, step = (np.array([float(c) for c in several]) for several in zip(*self._ends, strict=True))
        return np.asarray((coordinates - start) / step)

    @property
    def _ends(self) -> list[tuple[Any, Any]]:
        return [(a.start, a.step) for a in self.axes]

    @cached_property
    def linear(self) -> tuple[Floats, Floats]:
        """The coordinates `names` at the first node, and by how much they grow from node to node, (axes, names)."""
        origin, steps = np.array(self.values), np.zeros((len(self.axes), len(self.names)))
        for k, axis in enumerate(self.axes):
            n = self.names.index(axis.name)
            origin[n], steps[k, n] = float(axis.start) * axis.scale, float(axis.step) * axis.scale
        return origin, steps

    def to_json(self) -> dict[str, Any]:
        over = {a.name for a in self.axes}
        rest = {n: v for n, v in zip(self.names, self.values, strict=True) if n not in over}
        return {"axes": [a.to_json() for a in self.axes], "at": rest}


@dataclass(frozen=True, eq=False)
class LimbsTask(HoldsArrays):
    """A `MapTask` of a robot of joints, one chunk: all is solved from node to node."""

    mechanism: Limbs
    grid: LimbsGrid
    limits: LengthLimits | None = None
    measure: str = "margin"

    factors = None
    everywhere = False
    number = 1
    halvings = 14

    def __getstate__(self) -> dict[str, Any]:
        return {f.name: getattr(self, f.name) for f in fields(self)}  # the sweep is made anew

    @property
    def names(self) -> tuple[str, ...]:
        """The arrays of the chunk."""
        index = (self.measure,) if self.measure in INDICES else ()
        return ("margin", "sign", "actuator", "allowed", *index, "cell_status")

    @property
    def layers(self) -> int:
        return self.grid.shape[0]

    def span(self, chunk: int) -> tuple[int, int]:
        """All layers."""
        return 0, self.layers

    @property
    def linkage(self) -> Linkage:
        return self.mechanism.linkage

    @cached_property
    def _swept(self) -> tuple[Sweep, NDArray[np.uint8]]:
        """The solved nodes, and the status of all cells. Raises InputError where the first node is not reached."""
        m, g = self.linkage, self.grid
        origin, steps = g.linear
        place = np.clip(np.rint(g.places(np.zeros((1, len(g.axes))))), 0, np.array(g.shape) - 1)
        target = Target(g.names, (origin + place @ steps)[0], g.driven, text=self._named(place))
        first = solve(m, target)
        if first.doubt is not None:
            raise InputError(
                f"it is not proved that {m.robot.id} is on home's branch at {target.text}, from which the map starts",
                hint="take a range nearer to home",
            )
        node = int(np.ravel_multi_index(tuple(place[0].astype(int)), g.shape))
        course = Course(m, replace(target, values=np.zeros(len(g.names))))
        sweep = Sweep(course, g.shape, origin, steps, node, first.configuration)
        return sweep, proved_cells(sweep)

    def _named(self, place: Floats) -> str:
        pairs = zip(self.grid.axes, self.grid.coordinates(place)[0].tolist(), strict=True)
        return ", ".join(f"{a.name} = {c:.6g} {a.unit}".rstrip() for a, c in pairs)

    def compute(self, chunk: int) -> Chunk:
        """All arrays."""
        sweep, status = self._swept
        shape = self.grid.shape
        amounts = self._amounts(np.arange(len(sweep.reached)))
        allowed = sweep.reached.copy()
        if self.limits is not None:
            allowed &= self.limits.allow(amounts)
        return {
            "margin": sweep.sigma.astype(np.float32).reshape(shape),
            "sign": sweep.signs.reshape(shape),
            "actuator": amounts.astype(np.float32).reshape(*shape, -1),
            "allowed": allowed.astype(np.uint8).reshape(shape),
            **{n: sweep.index(INDICES[n]).astype(np.float32).reshape(shape) for n in self.names if n in INDICES},
            "cell_status": status,
        }

    def _amounts(self, nodes: NDArray[np.intp]) -> Floats:
        """The amounts of the actuators from home at nodes (K, actuators)."""
        sweep, m = self._swept[0], self.linkage
        there = sweep.at(sweep.amounts[nodes])
        return np.stack([there.joint_values[a.place][:, a.coordinate] for a in m.actuators], axis=1)

    def level(self, chunk: Chunk) -> Floats:
        """The margin with the sign of the determinant of all wrenches."""
        signed = chunk["margin"].astype(np.float64) * chunk["sign"]
        return np.asarray(np.where(chunk["sign"] == 0, np.nan, signed))

    def value(self, places: Floats) -> Floats:
        """The level at places (N, axes) counted in nodes: solved anew for two axes, else between the nodes around."""
        sweep = self._swept[0]
        return sweep.signed(places) if len(self.grid.axes) == 2 else self._between(places)

    def _between(self, places: Floats) -> Floats:
        sweep, shape = self._swept[0], self.grid.shape
        level = (sweep.sigma * np.where(sweep.signs == 0, np.nan, sweep.signs)).reshape(shape)
        low = np.clip(np.floor(places), 0, np.array(shape) - 2).astype(int)
        t = places - low
        found = np.zeros(len(places))
        for corner in np.ndindex(*(2,) * len(shape)):
            weight = np.where(corner, t, 1 - t).prod(axis=1)
            found += weight * level[tuple((low + np.array(corner)).T)]
        return found

    def spare(self, coordinates: Floats) -> Floats:
        """By how much poses keep to the limits of the actuators, as the nearest node does; below 0: not, or not
        reached.
        """
        sweep, shape = self._swept[0], self.grid.shape
        index = np.clip(np.rint(self.grid.places(coordinates)), 0, np.array(shape) - 1).astype(int)
        node = np.ravel_multi_index(tuple(index.T), shape)
        found = np.where(sweep.reached[node], 1.0, -1.0)
        if self.limits is not None and len(node):
            kept = self.limits.margin(np.nan_to_num(self._amounts(node)))
            found = np.where(sweep.reached[node], kept, -1.0)
        return found

    @property
    def accuracy(self) -> str:
        """How curves are found."""
        if self.linkage.robot.redundant:
            return (
                "no curves or surfaces are drawn: with more actuators than freedoms no determinant changes its sign, "
                "and singular poses lie in undecided cells only"
            )
        if len(self.grid.axes) == 3:
            return "the surface is drawn between the nodes, where the determinant changes its sign"
        return (
            "curves are traced from the signs of the determinant at the nodes, zeros on edges found by halving; pieces "
            "smaller than a cell may be missed, but in undecided cells only"
        )

    @property
    def guard(self) -> str:
        """What a margin guarantees."""
        if self.linkage.looped:
            return "where sigma is not 0 no body of the robot can move with the actuators locked"
        return (
            "no pose is singular before the wrenches of some limb have turned by asin(sigma) relative to the platform"
        )

    def about(self, sentence: str) -> dict[str, str]:
        """The robot, its condition and the other coordinates."""
        return {
            "robot": self.grid.title,
            "actuators": ", ".join(map(str, self.linkage.actuators)),
            "condition": sentence,
            "coordinates_of_the_rest": self.grid.rest,
            "centre_of_turns": " ".join(f"{float(c):.17g}" for c in self.linkage.centre),
        }

    def subject(self) -> dict[str, Any]:
        """The robot and its actuators."""
        return {
            "robot": self.mechanism.robot.id,
            "title": self.grid.title,
            "actuators": [str(a) for a in self.linkage.actuators],
            "about": self.linkage.centre.tolist(),
        }

    def guarantee(self, summary: MapSummary) -> str:
        """What is proved, in one sentence."""
        free, crossed, undecided = summary.cells
        others = crossed + undecided + summary.outside
        proved = (
            f"{'' if others else 'all '}{free:,} cells are proved free, by Krawczyk's operator: for all their "
            "coordinates the robot has one configuration near those of the nodes, and none of these is singular"
        )
        if not others:
            return proved
        left = f"{crossed:,} crossed, {undecided:,} undecided, {summary.outside:,} with a corner that is not reached"
        return f"{proved}; singular poses that hang together with home lie in the {others:,} other cells ({left})"

    @property
    def manifest(self) -> dict[str, Any]:
        """Of what the chunk is."""
        robot = self.mechanism.robot
        return {
            "version": __version__,
            "robot": [robot.id, str(robot.home), [str(limb) for limb in robot.limbs]],
            "centre": [str(c) for c in self.linkage.centre],
            "over": [a.text for a in self.grid.axes],
            "rest": self.grid.to_json()["at"],
            "limits": self.limits.to_json() if self.limits else None,
            "measure": self.measure,
        }


def limbs_task(m: Limbs, over: Any, at: Any = None, limits: str | None = None, measure: str = "margin") -> LimbsTask:
    """The map of a robot of joints over coordinates of its pose or over actuators; `at` says what the others are, home
    where they are not named. Raises InputError for what makes no sense, LimitReached for too many poses.
    """
    k = m.linkage
    angles = {a.name: a.angle for a in k.actuators}
    axes = read_axes(over, m.unit, {a.name: a.angle for a in leading(k)})
    if measure == "value":
        raise InputError("a robot of joints has no superbracket of its legs", hint="leave --measure out")
    driven = axes[0].kind == ACTUATOR
    names, values = coordinates_of(k, axes, at, driven)
    reach = parse_limits(limits, tuple(angles), m.unit, tuple(angles.values())) if limits is not None else None
    grid = LimbsGrid(
        axes, names, values, driven, m.title or k.robot.id, tuple(angles), tuple(angles.values()), m.unit, k.notes
    )
    if grid.size > MAX_POSES:
        raise LimitReached(
            f"{grid.size:,} poses: more than {MAX_POSES:,} in one map of a robot of joints", hint="take a coarser grid"
        )
    for a in axes:
        if a.unit and (float(a.stop) - float(a.start)) * a.scale > _ALL_ROUND:
            raise InputError(f"{a.name} goes more than once around", hint="take a range of one turn at most")
    check_target(k, Target(names, np.zeros(len(names)), driven, text="home"))
    return LimbsTask(m, grid, reach, measure)


def coordinates_of(
    m: Linkage, axes: Sequence[GridAxis], at: Any, driven: bool
) -> tuple[tuple[str, ...], tuple[float, ...]]:
    """All coordinates by which poses are told, and what they are where no axis stands for them. Raises InputError."""
    over = [a.name for a in axes]
    given = {} if at is None else _given(m, at, driven)
    twice = [n for n in given if n in over]
    if twice:
        raise InputError(f"{twice[0]} is an axis of the map, and given as well", hint="leave it out of --at")
    if driven:
        names = tuple(a.name for a in leading(m))
        return names, tuple(given.get(n, 0.0) for n in names)
    foreign = next((n for n in (*over, *given) if n not in (*TRANSLATION, *TURNS)), None)
    if foreign is not None:
        raise InputError(
            f"a robot of joints is not mapped by {foreign}",
            hint="its coordinates are x, y, z, roll, pitch, yaw, or its actuators "
            + ", ".join(a.name for a in leading(m)),
        )
    named = [*over, *(n for n in given if n not in over)]
    if len(named) > m.robot.mobility:
        raise InputError(
            f"{len(named)} coordinates are named, and the platform has mobility {m.robot.mobility}",
            hint=f"name {m.robot.mobility} at most: the others follow",
        )
    names = tuple(named) if len(named) == m.robot.mobility else free_coordinates(m, named)
    missing = [n for n in named if n not in names]
    if missing:
        others = listed([n for n in named if n != missing[0]])
        beside = f" beside {others}" if others else ""
        raise InputError(
            f"{missing[0]} tells nothing of the pose of {m.robot.id} near home{beside}",
            hint=f"independent there are, for example, {', '.join(free_coordinates(m))}",
        )
    return names, tuple(given.get(n, 0.0) for n in names)


def _given(m: Linkage, at: Any, driven: bool) -> dict[str, float]:
    """The values of those coordinates, or of actuators, that are named: text or a mapping, angles in radians."""
    if isinstance(at, str):
        known = {a.name: a.angle for a in leading(m)} if driven else {n: n in ANGLES for n in COORDINATES}
        return {n: float(v) for n, v in read_named(at, known).items()}
    if isinstance(at, Mapping):
        known = {a.name: a.angle for a in leading(m)} if driven else {n: n in ANGLES for n in COORDINATES}
        check_known(at, tuple(known), "actuator" if driven else "coordinate of a pose")
        return {n: float(v) if isinstance(v, Amount) else exact_float(v, n) for n, v in at.items()}
    raise InputError(
        f"{str(at)[:60]!r} names no coordinates", hint='write what the other ones are: "z=0.1, yaw=5deg" or "q3=0.1"'
    )
