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
from dataclasses import fields, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError, LimitReached
from gcrules.core.frozen import HoldsArrays
from gcrules.core.version import __version__
from gcrules.mechanisms.description.limits import LengthLimits
from gcrules.mechanisms.kinematics.amplification import INDICES
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.loops import Course
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.solve import check_target, solve
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import limits_of
from gcrules.poses.limbs.lattice import Lattice
from gcrules.poses.maps.axes import ACTUATOR, check_turns, read_axes
from gcrules.poses.maps.limb_cells import LARGEST, proved_cells
from gcrules.poses.maps.limb_grid import LimbsGrid, coordinates_of
from gcrules.poses.maps.patches import Patches
from gcrules.poses.maps.spreading import spread
from gcrules.poses.maps.summary import MapSummary
from gcrules.poses.maps.sweep import Sweep
from gcrules.poses.maps.task import Chunk, InLayers
from gcrules.poses.tiles.task import Stage

__all__ = ["MAX_POSES", "LimbsTask", "limbs_task"]

MAX_POSES = 1_000_000
_NODES = 1_000  # in one chunk, about
_SINGULAR = 1e-10  # of the margin: less is 0, and has no sign


@dataclass(frozen=True, eq=False)
class LimbsTask(InLayers, HoldsArrays):
    """A `MapTask` of a robot of joints. Its stage is home's branch over the whole grid, in short, from which each chunk
    is solved by itself.
    """

    mechanism: Limbs
    grid: LimbsGrid
    limits: LengthLimits | None = None
    measure: str = "margin"

    factors = None
    everywhere = False
    halvings = 14

    def __getstate__(self) -> dict[str, Any]:
        return {f.name: getattr(self, f.name) for f in fields(self)}  # the branch is made anew

    @property
    def names(self) -> tuple[str, ...]:
        """The arrays of the chunk."""
        index = (self.measure,) if self.measure in INDICES else ()
        return ("margin", "sign", "actuator", "allowed", *index, "cell_status")

    @property
    def layers(self) -> int:
        """Layers of a chunk: so many that the largest boxes fit."""
        inner = math.prod(self.grid.shape[1:])
        return max(LARGEST, _NODES // inner // LARGEST * LARGEST)

    @property
    def linkage(self) -> Linkage:
        return self.mechanism.linkage

    @cached_property
    def _start(self) -> tuple[Lattice, int]:
        """The nodes, and the one nearest to home, whose configuration is the lattice's. Raises InputError where it is
        not reached.
        """
        m, g = self.linkage, self.grid
        origin, steps = g.linear
        place = np.clip(np.rint(g.places(np.zeros((1, len(g.axes))))), 0, np.array(g.shape) - 1)
        target = Target(g.names, (origin + place @ steps)[0], g.driven, text=self._named(place))
        first = solve(m, target)
        if first.doubt is not None:
            raise InputError(
                f"it is not proved that {m.robot.id} is on home's branch at {target.text}, from which the map starts",
                hint="use a range closer to home",
            )
        node = int(np.ravel_multi_index(tuple(place[0].astype(int)), g.shape))
        course = Course(m, replace(target, values=np.zeros(len(g.names))))
        return Lattice(course, g.shape, origin, steps, first.configuration), node

    @property
    def stage(self) -> Stage:
        """Home's branch."""
        return self

    @property
    def known(self) -> bool:
        """Whether home's branch is computed, or was taken."""
        return "_branch" in self.__dict__

    def staged(self) -> bytes:
        """Home's branch over the grid, computed here."""
        return self._branch.to_bytes()

    def take(self, data: bytes) -> None:
        """Go on from home's branch as it was computed elsewhere. Raises ValueError and KeyError for what is none."""
        if not self.known:
            self.__dict__["_branch"] = Patches.of_bytes(self._start[0], data)

    @cached_property
    def _branch(self) -> Patches:
        return spread(*self._start)

    @cached_property
    def _levels(self) -> Floats:
        """The margins with the sign of the determinant at the nodes, those that are known; else infinite."""
        return np.full(self.grid.size, np.inf)

    def _named(self, place: Floats) -> str:
        pairs = zip(self.grid.axes, self.grid.coordinates(place)[0].tolist(), strict=True)
        return ", ".join(f"{a.name} = {c:.6g} {a.unit}".rstrip() for a, c in pairs)

    def compute(self, chunk: int) -> Chunk:
        """All arrays."""
        first, last = self.span(chunk)
        stop = min(last + 1, self.grid.shape[0])  # one layer more: the cells between it and the chunk belong here
        sweep = Sweep(self._branch, first, stop)
        shape = (stop - first, *self.grid.shape[1:])
        none = np.zeros((0, *(n - 1 for n in shape[1:])), dtype=np.uint8)
        status = proved_cells(sweep) if shape[0] > 1 else none
        amounts = self._driven(sweep.amounts)
        allowed = sweep.reached.copy()
        if self.limits is not None:
            allowed &= self.limits.allow(amounts)
        found = {
            "margin": sweep.sigma.astype(np.float32).reshape(shape),
            "sign": sweep.signs.reshape(shape),
            "actuator": amounts.astype(np.float32).reshape(*shape, -1),
            "allowed": allowed.astype(np.uint8).reshape(shape),
            **{n: sweep.index(INDICES[n]).astype(np.float32).reshape(shape) for n in self.names if n in INDICES},
        }
        return {**{name: values[: last - first] for name, values in found.items()}, "cell_status": status}

    def _driven(self, amounts: Floats) -> Floats:
        """The amounts of the actuators from home (K, actuators), of those of all joints."""
        m = self.linkage
        there = self._start[0].at(amounts)
        return np.stack([there.joint_values[a.place][:, a.coordinate] for a in m.actuators], axis=1)

    def level(self, chunk: Chunk) -> Floats:
        """The margin with the sign of the determinant of all wrenches: 0 at a singular node, not a number where the
        sign is not known.
        """
        signed = chunk["margin"].astype(np.float64) * chunk["sign"]
        unknown = (chunk["sign"] == 0) & ~(chunk["margin"] < _SINGULAR)
        return np.asarray(np.where(unknown, np.nan, signed))

    def value(self, places: Floats) -> Floats:
        """The level at places (N, axes) counted in nodes: solved anew for two axes, else between the nodes around."""
        return self._branch.signed(places) if len(self.grid.axes) == 2 else self._between(places)

    def _between(self, places: Floats) -> Floats:
        shape = self.grid.shape
        low = np.clip(np.floor(places), 0, np.array(shape) - 2).astype(int)
        t = places - low
        found = np.zeros(len(places))
        for corner in np.ndindex(*(2,) * len(shape)):
            weight = np.where(corner, t, 1 - t).prod(axis=1)
            some = weight > 0
            nodes = np.ravel_multi_index(tuple((low[some] + np.array(corner)).T), shape)
            found[some] += weight[some] * self._level_at(nodes)
        return found

    def _level_at(self, nodes: NDArray[np.intp]) -> Floats:
        """The level at nodes, computed where it is not known."""
        new = np.unique(nodes[np.isinf(self._levels[nodes])])
        if len(new):
            values = self._branch.signed(self._start[0].places(new))
            self._levels[new] = np.where(values == 0, np.nan, values)
        return np.asarray(self._levels[nodes])

    def spare(self, coordinates: Floats) -> Floats:
        """By how much poses keep to the limits of the actuators, as the nearest node does; below 0: not, or not
        followed to.
        """
        shape = self.grid.shape
        index = np.clip(np.rint(self.grid.places(coordinates)), 0, np.array(shape) - 1).astype(int)
        nodes, which = np.unique(np.ravel_multi_index(tuple(index.T), shape), return_inverse=True)
        if self.limits is None:
            found = np.where(self._branch.owner[nodes] >= 0, 1.0, -1.0)
        else:
            amounts = self._branch.amounts_at(nodes)
            kept = self.limits.margin(np.nan_to_num(self._driven(amounts)))
            found = np.where(np.isnan(amounts[:, 0]), -1.0, kept)
        return np.asarray(found[which])

    @property
    def beyond(self) -> str:
        """What is said of poses that are not allowed."""
        return "not followed from home" + (", or beyond the limits" if self.limits else "")

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
            "smaller than a cell may be missed, but only in undecided cells"
        )

    @property
    def guard(self) -> str:
        """What a margin guarantees."""
        if self.linkage.looped:
            return "where sigma is not 0 no body of the robot can move with the actuators locked"
        return (
            "apart from the limbs' own singularities, no pose is singular while the wrenches of every limb turn by "
            "less than asin(sigma) relative to the platform"
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
        kinds = {"crossed": crossed, "undecided": undecided, "not followed to a corner": summary.outside}
        others = sum(kinds.values())
        proved = (
            f"{'' if others else 'all '}{free:,} cells are proved free, by Krawczyk's operator: for all their "
            "coordinates the robot has one configuration near those of the nodes, and none of these is singular"
        )
        if not others:
            return proved
        left = ", ".join(f"{count:,} {kind}" for kind, count in kinds.items() if count)
        if not free:
            return f"No cell is proved free: {left}"
        which = f"{others:,} other cells" if others > 1 else "other cell"
        return f"{proved}; every singular pose that is connected with home lies in the {which} ({left})"

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
            "layers": self.layers,
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
    reach = limits_of(m, limits)
    grid = LimbsGrid(
        axes, names, values, driven, m.title or k.robot.id, tuple(angles), tuple(angles.values()), m.unit, k.notes
    )
    if grid.size > MAX_POSES:
        raise LimitReached(
            f"{grid.size:,} poses: more than {MAX_POSES:,} in one map of a robot of joints", hint="use a coarser grid"
        )
    check_turns(axes)
    check_target(k, Target(names, np.zeros(len(names)), driven, text="home"))
    return LimbsTask(m, grid, reach, measure)
