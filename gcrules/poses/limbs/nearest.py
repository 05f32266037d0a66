r"""The nearest singular configuration of a robot of joints: where it was found, and a box proved free of all of them.

The pose is told by as many coordinates as the platform has freedoms. Their changes are measured with lengths divided by
the robot's size ρ and angles in radians; of ways in many directions the one that comes soonest to a change of sign of
the determinant is bent towards the foot of the surface of zeros until it grows no shorter. That is a search. The other
bound is a proof, by Krawczyk's operator on boxes: there is one branch of configurations over the box, none is singular.

>>> from gcrules.mechanisms.mechanism import mechanism
>>> found = nearest_singular(mechanism("3-rpr").linkage)
>>> found.names, round(found.distance, 4), found.free < found.distance
(('x', 'y', 'yaw'), 0.3044, True)
"""

from __future__ import annotations

from itertools import product

import numpy as np

from gcrules.core.budget import checkpoint, report
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.branch import Cells
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.determinants import relative_sign
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.margin import margins
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.solve import Solution, free_coordinates, solve
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.poses.limbs.rays import ZERO, Bundle, Ends
from gcrules.screws.verdict import SOLVED

__all__ = ["NearestSingular", "directions_around", "nearest_singular"]

_FEW = 4  # freedoms up to which all neighbours in a grid are directions
_DRAWN = 60  # directions beside the axes, where there are more
_KEPT = 4  # ways that are bent
_BENDS = 12
_SLOPE = 1e-3  # of the differences that make a gradient
_GAIN = 1e-6  # of the distance
_ALIKE = 1e-3  # rad: between a way and the normal at its end; the distance then changes by a millionth
_LEAST = 0.01  # of the turn of a way towards the normal
_PARTS = (1.0, 1 - 1e-6, 1 - 1e-4)  # of the way
_HALVINGS = 10  # of the box that is proved


@dataclass(frozen=True, eq=False)
class NearestSingular:
    """The nearest singular configuration that was found, at changes of the coordinates `names` (radians and the unit of
    the file) from where the search began, and its `solution`; None where nothing was found up to `reach`, or where it
    is not reached itself. `distance` is √Σ of the squares of angles and of shifts / ρ. No configuration is singular
    where every coordinate changes by less than `free` (times ρ for shifts), proved. Ways were followed in `directions`,
    `stopped` of them end sooner: there the loops do not close beyond, or a limb is singular. Of a robot with more
    actuators than freedoms only the box is proved; `directions` is 0.
    """

    names: tuple[str, ...]
    changes: Floats | None
    distance: float
    free: float
    reach: float
    solution: Solution | None
    directions: int
    stopped: int


def nearest_singular(m: Linkage) -> NearestSingular | None:
    """That around the home of a linkage (`begun_at` moves it); None where no coordinates tell the pose there."""
    names = free_coordinates(m)
    if len(names) < m.robot.mobility:
        return None
    bundle = Bundle(m, names)
    if m.robot.redundant:  # no determinant is there whose sign could change
        reach = _reach(m)
        return NearestSingular(names, None, float("inf"), _free(bundle, reach), reach, None, 0, 0)
    report("looking for singular configurations in all directions")
    directions, reach = directions_around(len(names)), _reach(m)
    ends = bundle.ends(directions, reach, nearest=True)
    way, distance = _bent(bundle, directions, ends)
    changes = None if way is None else distance * way * bundle.weights
    found = None if changes is None else _reached(bundle, changes)
    if found is not None and margins(m, Configurations.of([found.configuration])).sigma[0] > ZERO:
        changes, distance, found = None, float("inf"), None
    report("proving that a box around the configuration is free")
    limit = min(distance, reach)
    stopped = int(((ends.followed < limit * (1 - _GAIN)) & np.isinf(ends.distance)).sum())
    return NearestSingular(names, changes, distance, _free(bundle, limit), reach, found, len(directions), stopped)


def _reach(m: Linkage) -> float:
    """How far it is looked, in parts of the robot's size or radians: a half turn, or the extent of the robot."""
    points = [m.home.values[d.name] for d in m.robot.family.definitions if d.sort == "point"]
    extent = float(np.linalg.norm(np.array(points) - m.centre, axis=1).max(initial=0.0))
    return max(np.pi, extent / m.size)


def directions_around(number: int) -> Floats:
    """Unit vectors all around: to the neighbours in a grid, or the axes and others drawn once for all."""
    if number < _FEW:
        found = np.array([d for d in product((-1.0, 0.0, 1.0), repeat=number) if any(d)])
    else:
        drawn = np.random.default_rng(0).normal(size=(_DRAWN, number))
        found = np.concatenate([np.eye(number), -np.eye(number), drawn])
    return np.asarray(found / np.linalg.norm(found, axis=1, keepdims=True))


def _bent(bundle: Bundle, directions: Floats, ends: Ends) -> tuple[Floats | None, float]:
    """The shortest way, after the best ones were bent towards the feet of the surface of zeros; None without any."""
    order = np.argsort(ends.distance, kind="stable")
    order = order[np.isfinite(ends.distance[order])][:_KEPT]
    if not len(order):
        return None, float("inf")
    ways, distance, before = directions[order], ends.distance[order], ends.before[order]
    active = np.arange(len(ways))
    share = np.ones(len(ways))
    for _ in range(_BENDS):
        checkpoint()
        wanted = _normals(bundle, ways[active], distance[active], before[active])
        off = np.linalg.norm(wanted - ways[active], axis=1) > _ALIKE
        active, wanted = active[off], wanted[off]
        if not len(active):
            break
        mixed = ways[active] + share[active, None] * (wanted - ways[active])
        tried = mixed / np.linalg.norm(mixed, axis=1, keepdims=True)
        found = bundle.ends(tried, float(distance[active].max()) * 1.05)
        better = found.distance < distance[active] * (1 - _GAIN)
        k = active[better]
        ways[k], distance[k] = tried[better], found.distance[better]
        before = before.replaced(k, found.before[better])
        share[active[~better]] /= 4
        active = active[share[active] > _LEAST]
    best = int(np.argmin(distance))
    return ways[best], _sharpened(bundle, ways[best], float(distance[best]), before[best : best + 1])


def _sharpened(bundle: Bundle, way: Floats, distance: float, before: Configurations) -> float:
    """The distance at which the margin is 0; at zeros of higher order the determinant tells it but roughly."""
    there, good = bundle.moved(before, distance * way[None])
    if not good[0] or margins(bundle.m, there).sigma[0] <= SOLVED:
        return distance
    room = max(0.01 * distance, _SLOPE)
    return float(bundle.least(before, way[None], np.array([distance - room]), np.array([distance + room]))[0])


def _normals(bundle: Bundle, ways: Floats, distance: Floats, before: Configurations) -> Floats:
    """The unit normals of the surface of zeros at the ends of ways, outwards: differences of the signed determinant;
    not a number where configurations beside the zero are not reached.
    """
    count, n = ways.shape
    zero = distance[:, None] * ways
    base = bundle.frames(before)
    beside = (zero[:, None, None] + _SLOPE * np.array([[[1.0]], [[-1.0]]]) * np.eye(n)).reshape(-1, n)
    owner = np.repeat(np.arange(count), 2 * n)
    there, good = bundle.moved(before[owner], beside)
    new = bundle.frames(there)
    sign = np.where(good, relative_sign(base[owner], new), 0)
    value = np.where(sign != 0, sign * np.abs(new.determinant), np.nan).reshape(count, 2, n)
    slope = value[:, 0] - value[:, 1]
    found = -slope / np.linalg.norm(slope, axis=1, keepdims=True)
    return np.asarray(np.where((found * ways).sum(axis=1, keepdims=True) < 0, -found, found))


def _free(bundle: Bundle, limit: float) -> float:
    """How far all coordinates may change, in their units, so that nothing singular is met: proved, 0 if nothing is."""
    m = bundle.m
    here = Configurations.of([m.home])
    low, high = 0.0, limit
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        cells = Cells.around(m, bundle.course.target, here, (middle * bundle.weights)[None])
        if cells.one_branch[0] and cells.regular[0]:
            low = middle
        else:
            high = middle
    return low


def _reached(bundle: Bundle, changes: Floats) -> Solution | None:
    """The configuration after these changes, or just before where the loops do not close there, as at a zero of the
    constraints they may not; None where they do not close either.
    """
    for part in _PARTS:
        try:
            return solve(bundle.m, Target(bundle.names, part * changes))
        except InputError:
            continue
    return None
