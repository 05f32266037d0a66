"""The bodies of an MJCF file and their joints, in the order in which MuJoCo counts them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import field

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.models.mjcf_document import Compiler, Defaults, sections
from gcrules.mechanisms.models.places import frame, from_quaternion, length, moved
from gcrules.mechanisms.models.xml_files import Element, quoted

__all__ = ["WORLD", "Body", "BodyJoint", "Site", "bodies_of", "elements", "value_count"]

WORLD = "world"
_TYPES = ("hinge", "slide", "ball", "free")
_REFUSED = {
    "composite": "bodies that are made from a pattern",
    "flexcomp": "soft bodies",
    "replicate": "bodies that are repeated",
    "attach": "parts of other models",
}


@dataclass(eq=False)
class BodyJoint:
    """A joint as written: its point and axis in the frame of its body, its value where the file places its body."""

    name: str
    kind: str  # hinge, slide, ball, free
    at: Floats
    axis: Floats
    element: Element
    reference: float = 0.0
    limits: tuple[float, float] | None = None

    def motion(self, here: Floats, value: Sequence[float]) -> Floats:
        """How it moves its body, which is `here` without it, for its values in the state of MuJoCo."""
        point, axis = (here @ [*self.at, 1.0])[:3], here[:3, :3] @ self.axis
        if self.kind in ("hinge", "slide"):
            kind = {"hinge": "revolute", "slide": "prismatic"}[self.kind]
            return moved(kind, point, axis, value[0] - self.reference)
        turn = from_quaternion(*value[-4:])
        if turn is None:
            raise self.element.error(f"joint {quoted(self.name)} has a quaternion of length 0 at home")
        if self.kind == "free":
            return frame(value[:3], turn) @ np.linalg.inv(here)
        turned = here[:3, :3] @ turn @ here[:3, :3].T
        return frame(point - turned @ point, turned)


@dataclass(frozen=True, eq=False)
class Site:
    """A named frame on a body."""

    body: str
    place: Floats


@dataclass(eq=False)
class Body:
    """A body: its parent, its place there without its joints, and these from the parent on."""

    name: str
    parent: str
    place: Floats
    element: Element
    joints: list[BodyJoint] = field(default_factory=list)


def value_count(kind: str) -> int:
    """How many numbers of MuJoCo's state a joint has."""
    return {"ball": 4, "free": 7}.get(kind, 1)


def bodies_of(root: Element, compiler: Compiler, defaults: Defaults) -> tuple[list[Body], dict[str, Site]]:
    """All bodies, parents first, and all sites. Raises FileError for what holds bodies and is not read."""
    reading = _Bodies(compiler, defaults)
    for element in root.each("worldbody"):
        reading.inside(element, WORLD, np.eye(4), "main", None)
    return reading.bodies, reading.sites


class _Bodies:
    def __init__(self, compiler: Compiler, defaults: Defaults) -> None:
        self.compiler = compiler
        self.defaults = defaults
        self.bodies: list[Body] = []
        self.sites: dict[str, Site] = {}
        self.names = {WORLD}
        self.joints: set[str] = set()

    def inside(self, element: Element, name: str, place: Floats, inherited: str, body: Body | None) -> None:
        """What an element holds, whose frame is at `place` on the body of this name."""
        for child in element.children:
            if child.tag == "body":
                self._body(child, name, place, inherited)
            elif child.tag == "frame":
                own = self._class(child, inherited)
                self.inside(child, name, place @ self.compiler.place(child), own, body)
            elif child.tag in ("joint", "freejoint"):
                if body is None:
                    raise child.error("the world has no joints")
                self._joint(child, body, place, inherited)
            elif child.tag == "site":
                site = self.defaults.of(child, inherited)
                if "name" in site.attributes:
                    at = self.compiler.place(site) if "fromto" not in site.attributes else np.eye(4)
                    self.sites[site.attributes["name"]] = Site(name, place @ at)
            elif child.tag in _REFUSED:
                what = f"<{child.tag}>: {_REFUSED[child.tag]} are not read"
                raise child.error(what, hint="write the bodies out (MuJoCo saves a compiled model so)")

    def _class(self, element: Element, inherited: str) -> str:
        own = element.attributes.get("childclass", inherited)
        self.defaults.known(element, own, "childclass")
        return own

    def _body(self, element: Element, parent: str, place: Floats, inherited: str) -> None:
        name = element.attributes.get("name") or f"body {len(self.bodies) + 1}"
        if name in self.names:
            raise element.error(f"a second body named {quoted(name)}", "name")
        self.names.add(name)
        body = Body(name, parent, place @ self.compiler.place(element), element)
        self.bodies.append(body)
        self.inside(element, name, np.eye(4), self._class(element, inherited), body)

    def _joint(self, element: Element, body: Body, place: Floats, inherited: str) -> None:
        said = self.defaults.of(element, inherited) if element.tag == "joint" else element
        kind = said.choice("type", _TYPES, "hinge") if element.tag == "joint" else "free"
        name = said.attributes.get("name") or f"{body.name} joint {len(body.joints) + 1}"
        if name in self.joints:
            raise element.error(f"a second joint named {quoted(name)}", "name")
        self.joints.add(name)
        axis = np.array(said.numbers("axis", (0.0, 0.0, 1.0)))
        if length(axis) < 1e-9:
            raise element.error(f"the axis of joint {quoted(name)} has no direction", "axis")
        if kind == "free" and (body.parent != WORLD or body.joints):
            raise element.error(f"joint {quoted(name)} is free, and so belongs to a body of the world, alone")
        unit = self.compiler.angle if kind in ("hinge", "ball") else 1.0
        at = (place @ [*said.numbers("pos", (0.0, 0.0, 0.0)), 1.0])[:3] if kind != "free" else np.zeros(3)
        reference = said.number("ref", 0.0) * unit if kind in ("hinge", "slide") else 0.0
        turned = place[:3, :3] @ (axis / length(axis))
        limits = self._limits(said, unit) if kind != "free" else None
        body.joints.append(BodyJoint(name, kind, at, turned, said, reference, limits))

    def _limits(self, element: Element, unit: float) -> tuple[float, float] | None:
        word = element.choice("limited", ("auto", "true", "false"), "auto")
        if word == "false" or (word == "auto" and not (self.compiler.autolimits and "range" in element.attributes)):
            return None
        low, high = element.numbers("range", (0.0, 0.0))
        if low > high:
            raise element.error("the lower limit is above the upper one", "range")
        return low * unit, high * unit


def elements(root: Element, tag: str, defaults: Defaults) -> Iterator[Element]:
    """The elements of all sections with this tag, with their defaults."""
    return (defaults.of(e) for e in sections(root, tag))
