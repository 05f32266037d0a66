"""The shapes of the data that a 3D view draws limbs from; they load nothing heavy."""

from __future__ import annotations

from typing import Literal, TypedDict

__all__ = ["JointView", "LimbView", "LineView", "Vec3"]

Vec3 = list[float]


class JointView(TypedDict):
    kind: str
    actuated: bool
    point: Vec3 | None
    axes: list[Vec3]


class LineView(TypedDict):
    text: str
    wrench: Literal["force", "couple"]
    point: Vec3 | None
    direction: Vec3


class LimbView(TypedDict):
    name: str
    colour: int
    wrenches: list[str]
    joints: list[JointView]
    lines: list[LineView]
