r"""The links, joints and bodies of a robot as plain data for a 3D view, as its drawing on paper has them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gcrules.mechanisms.robot import Robot
from gcrules.views.drawing.bsp import XYZ
from gcrules.views.drawing.frame import Unit
from gcrules.views.robots.joint_chain import bodies, chains
from gcrules.views.scene_data import SkeletonView, Vec3

__all__ = ["skeleton", "unit_at"]


def unit_at(robot: Robot, values: Mapping[str, Sequence[float]]) -> Unit:
    """The ball around the robot, by whose radius its signs are measured, where names have these coordinates."""
    return chains(robot, values)[0]  # type: ignore[arg-type]  # floats do as well


def skeleton(robot: Robot, values: Mapping[str, Sequence[float]], own: Unit | None = None) -> SkeletonView:
    """Strokes of the limbs, signs of their joints and corners of the bodies, where names have these coordinates; in a
    unit of its `own` where it is not the ball around the robot there.
    """
    unit, made = chains(robot, values, own)  # type: ignore[arg-type]  # floats do as well

    def at(p: XYZ) -> Vec3:
        return [m + unit.radius * c for m, c in zip(unit.middle, p, strict=True)]

    platform, base = bodies(made)
    return {
        "strokes": [{"ends": [at(r.start), at(r.end)], "look": r.look} for c in made for r in c.strokes],
        "signs": [
            {"kind": p.kind, "actuated": p.driven, "at": at(p.at), "axes": [list(u) for u in p.axes]}
            for c in made
            for p in c.places
        ],
        "platform": [at(p) for p in platform],
        "base": [at(p) for p in base],
    }
