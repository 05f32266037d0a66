r"""What the 3D viewer is told: a robot in a pose and what is to be seen of its condition, as plain data for JSON.

    scene(analysis, pose=None) -> dict          the whole scene (`Scene` of the viewer); pose None is the file's own
    scenery = Scenery.of(analysis)              the part that no pose changes: keep it for many poses
    scenery.at(pose) -> dict                    the scene at a pose
    scenery.points(pose), scenery.constructed(points), scenery.motion(points)      what changes with the pose
    scenery.entities, scenery.about (exact), scenery.size, scenery.invented, scenery.recipe
    drawable(analysis) -> bool                  whether there is anything to draw in space

A pose is a `gcrules.screws.pose.Pose`, or a mapping with `translation` and `quaternion` (scalar first); it takes each
joint p of the platform to R(p − about) + about + translation. Lengths are in the unit of the file.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from math import dist

from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.expr import Expr
from gcrules.algebra.structure import Structure
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.gained_motion import incidence_rows
from gcrules.conditions.pose_value import XYZ, line_points
from gcrules.core.dataclass import dataclass
from gcrules.core.deferred import deferred, resolved
from gcrules.core.errors import InputError
from gcrules.screws.pose import Pose
from gcrules.screws.verdict import CLOSE
from gcrules.views.drawing.figures import distinct_entities, named_lines, sample_points
from gcrules.views.drawing.scene_parts import DrawnIncidence, entity_data, incidences, nested
from gcrules.views.scene_data import (
    Constructed,
    EntityView,
    MotionView,
    NamedLineView,
    NamedPointView,
    RecipeView,
    SceneData,
)

__all__ = ["Scenery", "drawable", "entity_data", "scene"]

ROUNDING, DIGITS = "gcrules.screws.guarantees:ROUNDING", "gcrules.screws.guarantees:DIGITS"  # it loads numpy
softest_twist = deferred("gcrules.poses.numbers.motion:softest_twist")
jacobian = deferred("gcrules.screws.margin:jacobian")
on_one_line = deferred("gcrules.screws.margin:on_one_line")

Points = Mapping[str, XYZ]
Vector = tuple[Fraction, Fraction, Fraction]
AnyPose = Pose | Mapping[str, Sequence[float]] | None

NEAR = 0.03
"""Planes and lines that miss a point by less than this share of the robot's size are shown with it, marked as near."""
MET = 1e-9
"""Below this share they meet in it."""
_FARTHEST, _SEEN = 100.0, 3.0
"""In sizes of the robot: how far a point is told in which all meet, and one near which they pass."""


def scene(analysis: Analysis, pose: AnyPose = None) -> SceneData:
    """The scene of an analysis at a pose; a sample shape for legs without coordinates. Raises InputError for lines that
    are no legs between finite joints.
    """
    return Scenery.of(analysis).at(pose)


def drawable(a: Analysis) -> bool:
    """Whether the legs join finite joints in space, so that there is a robot or a sample shape to draw."""
    s = a.structure
    return bool(s.joined) and not (s.special or s.stand_ins) and s.rank == 4


@dataclass(frozen=True)
class Scenery:
    """The part of a scene that no pose changes. `home` holds the exact places of the joints in the file's pose, `about`
    the centroid of the platform's joints there, `size` the radius of a ball around all joints; `invented` says that
    they are a sample shape. `lines` are constructed lines with their names.
    """

    structure: Structure
    home: Mapping[str, Vector]
    about: Vector
    size: float
    unit: str
    invented: bool
    entities: tuple[EntityView, ...]
    lines: tuple[tuple[str, Expr], ...]
    incidences: tuple[DrawnIncidence, ...]

    @classmethod
    def of(cls, a: Analysis) -> Scenery:
        """Raises InputError for lines that are no legs between finite joints, and where there is no leg."""
        if not drawable(a):
            raise InputError("there is no robot to draw: these are not legs between finite joints in space")
        s = a.structure
        if a.platform:
            home = {n: a.platform.points[n] for n in s.names}
        else:
            home = {n: _exact(p) for n, p in sample_points(a).items()}
        moving = [home[n] for n in s.platform] or list(home.values())
        floats = [_floats(p) for p in home.values()]
        middle = _floats(_mean(list(home.values())))
        shown = distinct_entities(a)
        data = tuple(entity_data(e, i) for i, e in enumerate(shown))
        return cls(
            structure=s,
            home=home,
            about=_mean(moving),
            size=max(dist(p, middle) for p in floats),
            unit=a.platform.units if a.platform else "",
            invented=a.platform is None,
            entities=data,
            lines=tuple(named_lines(a)),
            incidences=tuple(incidences(a, shown)),
        )

    def at(self, pose: AnyPose = None) -> SceneData:
        """The whole scene at a pose."""
        points = self.points(pose)
        found: SceneData = {
            "points": {n: list(p) for n, p in points.items()},
            "base": list(self.structure.base),
            "platform": list(self.structure.platform),
            "legs": [list(leg) for leg in self.structure.oriented],
            "about": list(_floats(self.about)),
            "size": self.size,
            "unit": self.unit,
            "entities": list(self.entities),
            "constructed": self.constructed(points),
            "motion": self.motion(points),
        }
        if self.movable:
            found["recipe"] = self.recipe
        return found

    @property
    def movable(self) -> bool:
        """Whether every leg joins the base to the platform, so that there is something to move."""
        return len(self.structure.sides) == len(self.structure.names)

    @cached_property
    def _plain(self) -> dict[str, XYZ]:
        return {n: _floats(p) for n, p in self.home.items()}

    def points(self, pose: AnyPose = None) -> dict[str, XYZ]:
        """Where the joints are at a pose."""
        if pose is None:
            return dict(self._plain)
        shift, turn = _parts(pose)
        moving, about = set(self.structure.platform), _floats(self.about)
        return {n: _moved(p, shift, turn, about) if n in moving else p for n, p in self._plain.items()}

    def constructed(self, points: Points) -> list[Constructed]:
        """The named lines of the condition, and the point in which its planes and lines meet or nearly do so."""
        at = {n: (*p, 1.0) for n, p in points.items()}
        found: list[Constructed] = []
        for i, (name, e) in enumerate(self.lines):
            ends = line_points(evaluate(e, at), _middle(points), self.size)
            if ends:
                along = [(q - p) / (2 * self.size) for p, q in zip(*ends, strict=True)]
                start = [(q + p) / 2 for p, q in zip(*ends, strict=True)]
                line: NamedLineView = {"kind": "line", "label": name, "at": start, "direction": along, "entities": []}
                found.append({**line, "colour": len(self.entities) + i})
        for one in self.incidences:
            place, miss = self._common(one, points)
            if place is not None and miss <= NEAR:
                label = one.name if miss <= MET else f"≈ {one.name}"
                ids = list(one.entities)
                point: NamedPointView = {"kind": "point", "label": label, "at": list(place), "entities": ids}
                found.append(point)
        return found

    def _common(self, one: DrawnIncidence, points: Points) -> tuple[XYZ | None, float]:
        """The finite point nearest to all parts, in the robot's own unit of size, and how far off they are."""
        import numpy as np

        m = _middle(points)
        at = {n: (*((c - o) / self.size for c, o in zip(p, m, strict=True)), 1.0) for n, p in points.items()}
        rows = np.array([row for part in one.parts for row in incidence_rows(evaluate(part, at), part.step)], float)
        lengths = np.linalg.norm(rows, axis=1)
        if not lengths.any():
            return None, 1.0
        rows = rows[lengths > 0] / lengths[lengths > 0, None]
        _, sizes, right = np.linalg.svd(rows)
        if len(sizes) < 4 or sizes[2] < MET:
            return None, 1.0
        *xyz, w = map(float, right[3])
        reach = _FARTHEST if sizes[3] <= MET * abs(w) else _SEEN
        if abs(w) * reach < max(map(abs, xyz)):  # at infinity, or too far away to be told
            return None, 1.0
        x, y, z = (c / w * self.size + o for c, o in zip(xyz, m, strict=True))
        return (x, y, z), float(sizes[3] / abs(w))

    def motion(self, points: Points) -> MotionView | None:
        """The motion that the legs hardly notice, where the pose is singular or close to it; else None."""
        if not self.movable:
            return None
        import numpy as np

        base, ends = (np.array([points[leg[i]] for leg in self.structure.oriented]) for i in (0, 1))
        if np.linalg.norm(ends - base, axis=1).min() <= 1e-12 * self.size:
            return None
        if on_one_line(ends):
            return None
        j = jacobian(base, ends[None])
        if float(j.sigma[0]) >= CLOSE:
            return None
        twist = softest_twist(j)
        through = twist.point or tuple(map(float, j.centroid[0]))
        words = f"the platform can {twist.text(self.unit)}"
        return {"axis": list(twist.axis), "through": list(through), "pitch": twist.pitch, "text": words}

    @property
    def recipe(self) -> RecipeView:
        """How lines and common points are constructed from joints, as nested lists: a page without a server evaluates
        them by itself. ["join", "a", "b"] and ["meet", …] have further ones as operands; sums are left out.
        """
        lines = [(i, name, nested(e)) for i, (name, e) in enumerate(self.lines, len(self.entities))]
        points = [(one, [of for p in one.parts if (of := nested(p))]) for one in self.incidences]
        return {
            "lines": [{"label": name, "colour": i, "of": of} for i, name, of in lines if of],
            "points": [
                {"label": one.name, "of": of, "entities": list(one.entities)}
                for one, of in points
                if len(of) == len(one.parts)
            ],
            "sign": 1 if self.structure.orientation > 0 else -1,
            "thresholds": {
                "close": CLOSE,
                "rounding": resolved(ROUNDING),
                "digits": resolved(DIGITS),
                "near": NEAR,
                "met": MET,
            },
            "size": self.size,
        }


def _parts(pose: Pose | Mapping[str, Sequence[float]]) -> tuple[XYZ, Sequence[Sequence[float]]]:
    """Translation and rotation matrix in floats."""
    if isinstance(pose, Pose):
        shift, turn = pose.translation, pose.rotation
        return _floats(shift), [[float(c) for c in row] for row in turn]
    return _floats(pose["translation"]), _rotation(*map(float, pose["quaternion"]))


def _rotation(w: float, x: float, y: float, z: float) -> list[list[float]]:
    """The matrix of a quaternion of any length but 0, in floats (that of `screws.rotations` is exact, and slow)."""
    n = w * w + x * x + y * y + z * z
    return [
        [(w * w + x * x - y * y - z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n],
        [2 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z - w * x) / n],
        [2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n],
    ]


def _moved(p: XYZ, shift: XYZ, turn: Sequence[Sequence[float]], about: XYZ) -> XYZ:
    arm = [c - m for c, m in zip(p, about, strict=True)]
    x, y, z = (
        sum(r * c for r, c in zip(row, arm, strict=True)) + m + t for row, m, t in zip(turn, about, shift, strict=True)
    )
    return x, y, z


def _mean(points: Sequence[Vector]) -> Vector:
    x, y, z = (sum((p[i] for p in points), Fraction(0)) / len(points) for i in range(3))
    return x, y, z


def _middle(points: Points) -> XYZ:
    x, y, z = (sum(p[i] for p in points.values()) / len(points) for i in range(3))
    return x, y, z


def _floats(p: Sequence[Fraction | float]) -> XYZ:
    x, y, z = map(float, p)
    return x, y, z


def _exact(p: Sequence[float]) -> Vector:
    x, y, z = (Fraction(repr(float(c))) for c in p)
    return x, y, z
