r"""A robot in a configuration, ready to be drawn: its points in space, the viewpoint, and the frame of the page."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import combinations
from math import dist

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.robot import Robot
from gcrules.poses.limbs.exact_values import Values, lines_at
from gcrules.views.drawing.bsp import XYZ, minus
from gcrules.views.drawing.frame import Frame, Unit, framed
from gcrules.views.drawing.palette import entity_role
from gcrules.views.drawing.solids import center, flat_normal
from gcrules.views.drawing.viewpoint import View, choose_view
from gcrules.views.robots.drawn_limb import DrawnLimb, plus, unit_vector
from gcrules.views.robots.forces import REACH, forces
from gcrules.views.robots.joint_chain import bodies, chains, upright

__all__ = ["HEIGHT", "TOP", "WIDTH", "Scene", "joint_names", "scene", "sketched_from"]

WIDTH, HEIGHT = 410.0, 380.0

_MARGIN = 40.0
_ELEVATIONS = (16, 22, 29, 36)
_SKETCHED = 22
TOP = 24.0  # points for the heading


@dataclass(frozen=True)
class Scene:
    """A robot in a configuration, ready to be drawn: `points` are all points in units of the robot's size, `ideal` unit
    vectors of all directions, `roles` the colour of each limb; `plate` and `base` are corners of the two bodies.
    """

    a: RobotAnalysis
    chains: tuple[DrawnLimb, ...]
    points: Mapping[str, XYZ]
    ideal: Mapping[str, XYZ]
    roles: Mapping[str, str]
    plate: tuple[XYZ, ...]
    base: tuple[XYZ, ...]
    frame: Frame
    unit: Unit
    extent: tuple[XYZ, ...]

    def holding(self, further: Sequence[XYZ]) -> Scene:
        """The same, smaller if need be, so that these places are inside the picture too."""
        frame = framed(self.frame.view, [*self.extent, *further], WIDTH, HEIGHT, _MARGIN, TOP)
        return replace(self, frame=replace(frame, size=_sign_size(frame, self.chains)))

    def role(self, limbs: Sequence[str]) -> str:
        """The colour of what belongs to these limbs."""
        return self.roles.get(limbs[0], "leg") if len(limbs) == 1 else "leg"

    @property
    def heart(self) -> XYZ:
        """The middle of the platform."""
        return center(self.plate)


def scene(a: RobotAnalysis, values: Values, normals: Sequence[XYZ] = ()) -> Scene:
    """Place the robot in space and choose the viewpoint; `normals` are those of planes not to be seen edge on."""
    robot = a.robot
    unit, made = chains(robot, values)
    points: dict[str, XYZ] = {}
    ideal: dict[str, XYZ] = {}
    for name, p in lines_at(robot.family, a.structure, values).items():
        if p[3]:
            points[name] = unit.place([c / p[3] for c in p[:3]])
        elif any(p):
            ideal[name] = unit_vector((float(p[0]), float(p[1]), float(p[2])))
    plate, base = bodies(made)
    shown = {**_joints(made), **{n: points[n] for n in _used(a) if n in points}}
    ends = [e for c in made for one in c.strokes for e in (one.start, one.end)]
    normals = [*normals, *_normals(plate), *(n for c in made for n in c.normals)]
    view = _view(robot.family.plane, shown, made, normals, _directions(a, points))
    tips = [plus(t, u, REACH) for c in made for t, u in forces(a, c, points, ideal, plate)]
    spheres = [(c.around, c.spheres[0]) for c in made if c.around]
    rims = [plus(o, u, side * r) for o, r in spheres for u in (view.right, view.up) for side in (1, -1)]
    everything = (*shown.values(), *ends, *tips, *rims)
    roles = {limb.limb.name: entity_role(i) for i, limb in enumerate(a.structure.limbs)}
    frame = framed(view, everything, WIDTH, HEIGHT, _MARGIN, TOP)
    return Scene(a, tuple(made), points, ideal, roles, plate, base, frame, unit, everything)


def sketched_from(robot: Robot, values: Values) -> View:
    """From where the links and joints of a robot alone are seen best, at the elevation of sketches."""
    _, made = chains(robot, values)
    normals = [*_normals(bodies(made)[0]), *(n for c in made for n in c.normals)]
    return _view(robot.family.plane, _joints(made), made, normals, (), (_SKETCHED,))


def _joints(made: Sequence[DrawnLimb]) -> dict[str, XYZ]:
    return {f"{i}/{k}": p.at for i, c in enumerate(made) for k, p in enumerate(c.places) if p.kind != "pin"}


def _normals(plate: Sequence[XYZ]) -> list[XYZ]:
    normal = flat_normal(plate) if len(plate) > 2 else None
    return [normal] if normal else []


def _used(a: RobotAnalysis) -> list[str]:
    """The points and directions to be labelled: those of the joints and of the lines."""
    names = joint_names(a)
    return [*names, *(n for leg in a.structure.legs for n in leg if n not in names)]


def joint_names(a: RobotAnalysis) -> list[str]:
    return list(dict.fromkeys(n for limb in a.robot.limbs for j in limb.joints for n in j.names))


def _directions(a: RobotAnalysis, points: Mapping[str, XYZ]) -> list[XYZ]:
    pairs = [(points[p], points[q]) for p, q in a.structure.legs if p in points and q in points]
    return [unit_vector(minus(q, p)) for p, q in pairs if dist(p, q) > 1e-9]


def _view(
    plane: bool,
    shown: Mapping[str, XYZ],
    made: Sequence[DrawnLimb],
    normals: Sequence[XYZ],
    directions: Sequence[XYZ],
    elevations: Sequence[int] = _ELEVATIONS,
) -> View:
    if plane:
        return View.at(-90, 90)
    places = {tuple(round(c, 6) for c in p): (n, p) for n, p in shown.items()}
    links = [[(one.start, one.end) for one in c.strokes if one.look in ("link", "bar")] for c in made]
    return choose_view(
        dict(places.values()),
        (),
        normals,
        directions,
        limbs=links,
        elevations=elevations,
        apart=0.17,
        upright=upright(made),
    )[0]


def _sign_size(frame: Frame, made: Sequence[DrawnLimb]) -> float:
    """Smaller signs where joints are near to each other on the page."""
    places = [frame.place(p.at) for c in made for p in c.places if p.kind != "pin"]
    gaps = sorted(d for p, q in combinations(places, 2) if (d := dist(p, q)) > 4)
    return min(1.0, max(0.66, round(gaps[min(1, len(gaps) - 1)] / 26, 2))) if gaps else 1.0
