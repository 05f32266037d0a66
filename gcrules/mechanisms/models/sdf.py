"""Reading SDF: a graph of links and joints, in which loops need no further means.

Every place is given at home, so that no loop can be open there: the frame of a joint is on its child, and meets the
parent where it is.

Source: the specification of SDFormat 1.11 (sdformat.org), elements joint, axis, pose, frame and include.
"""

from __future__ import annotations

import math

import numpy as np

from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.models.assembly import Assembly
from gcrules.mechanisms.models.model import Model
from gcrules.mechanisms.models.places import length
from gcrules.mechanisms.models.sdf_frames import MODEL, WORLD, Scope, version_of
from gcrules.mechanisms.models.xml_files import Element, quoted

__all__ = ["read_sdf"]

_KINDS = {
    "revolute": "revolute",
    "continuous": "revolute",
    "revolute2": "universal",
    "universal": "universal",
    "prismatic": "prismatic",
    "ball": "ball",
    "screw": "screw",
    "fixed": "fixed",
    "gearbox": "gearbox",
}
_AXES_ON_CHILDREN = (1, 5)  # the version from which axes are expressed in the frame of their joint
_CONTROLLERS = ("jointcontroller", "jointpositioncontroller", "jointtrajectorycontroller", "applyjointforce")


def read_sdf(root: Element) -> Model:
    """The model of an element `<sdf>`, which holds one. Raises FileError for what is at fault or not read."""
    models = [*root.each("model"), *(m for w in root.each("world") for m in w.each("model"))]
    for world in root.each("world"):
        for element in world.each("include", "joint"):
            raise element.error(f"<{element.tag}> of a world is not read", hint="give the file of the model itself")
    if len(models) != 1:
        at = models[1] if models else root
        raise at.error(f"the file holds {len(models)} models, expected one", hint="give the file of one model")
    version = version_of(root)
    old = version is not None and version < _AXES_ON_CHILDREN
    return _Sdf(models[0], old=old).model()


class _Sdf:
    """`old` files have axes in the frame of the model where they do not say in which."""

    def __init__(self, element: Element, *, old: bool) -> None:
        self.old = old
        self.element = element
        self.top = Scope(element)
        self.scopes = self.top.every()
        self.made = Assembly(element.attributes.get("name", ""), "sdf", element, element.file.filename)
        self.joined: dict[str, str] = {}  # links of the tree, and those that they hang on

    def model(self) -> Model:
        joints = [(s, name, f.element) for s in self.scopes for name, f in s.frames.items() if f.kind == "joint"]
        if self.top.is_static:
            raise self.element.error("the model is static: nothing in it moves", hint="take out <static>")
        still = [(s.name + name, f.element) for s in self.scopes if s.is_static
                 for name, f in s.frames.items() if f.kind == "link"]  # fmt: skip
        if still or any(e.need(tag).text.strip() == WORLD for _, _, e in joints for tag in ("parent", "child")):
            self.made.link(WORLD, self.element)
        for scope in self.scopes:
            for name, found in scope.frames.items():
                if found.kind == "link":
                    self.made.link(scope.name + name, found.element)
        if not self.made.links:
            raise self.element.error("there are no links in this model")
        for name, element in still:
            self.joined[name] = WORLD
            self.made.joint(f"{name} static", "fixed", (WORLD, name), np.zeros(3), (), element)
        for scope, name, element in joints:
            self._joint(scope, name, element)
        followers: dict[str, tuple[str, float, Element]] = {}
        for scope, name, element in joints:
            self._mimic(scope, name, element, followers)
        self.made.couple(followers)
        for scope in self.scopes:
            self._controllers(scope)
        return self.made.model(next(iter(self.made.links)))

    def _joint(self, scope: Scope, name: str, element: Element) -> None:
        kind = _KINDS[element.choice("type", tuple(_KINDS))]
        if kind == "gearbox":
            raise element.error(
                f"joint {quoted(name)} is a gearbox, which is not read", "type", "couple its two joints by <mimic>"
            )
        ends = [scope.link(element.need(tag).text.strip(), element.need(tag)) for tag in ("parent", "child")]
        at = scope.place(name, element)
        tags = {"universal": ("axis", "axis2"), "ball": (), "fixed": ()}.get(kind, ("axis",))
        axes = tuple(self._axis(scope, element, tag, at) for tag in tags)
        limits = self._limits(element.one("axis")) if kind in ("revolute", "prismatic", "screw") else None
        if element.attributes["type"] == "continuous":
            limits = None
        parent, child = ends
        closing = self._root(parent) == self._root(child)
        if not closing:
            self.joined[self._root(child)] = self._root(parent)
        self.made.joint(
            scope.name + name,
            kind,
            (parent, child),
            at[:3, 3],
            axes,
            element,
            limits=limits,
            pitch=_pitch(element) if kind == "screw" else 0.0,
            closing=closing,
        )

    def _root(self, link: str) -> str:
        """What stands for all links that are joined already."""
        while link in self.joined:
            link = self.joined[link]
        return link

    def _axis(self, scope: Scope, element: Element, tag: str, at: Floats) -> Floats:
        axis = element.need(tag)
        xyz = axis.one("xyz")
        numbers = xyz.read_numbers(xyz.text, (3,)) if xyz is not None else (0.0, 0.0, 1.0)
        if xyz is not None and length(numbers) < 1e-9:
            raise xyz.error(f"the axis of joint {quoted(element.needed('name'))} has no direction")
        within = at
        old = axis.one("use_parent_model_frame")
        if xyz is not None and "expressed_in" in xyz.attributes:
            name = xyz.attributes["expressed_in"]
            within = scope.place(name if name != WORLD else MODEL, xyz)
        elif (old.text.strip() in ("1", "true")) if old is not None else self.old:
            within = scope.place(MODEL, axis)
        return np.asarray(within[:3, :3] @ np.array(numbers))

    def _limits(self, axis: Element | None) -> tuple[float, float] | None:
        limit = axis.one("limit") if axis is not None else None
        if limit is None:
            return None
        ends = [limit.one(tag) for tag in ("lower", "upper")]
        low, high = (e.read_numbers(e.text, (1,), unlimited=True)[0] if e is not None else math.inf for e in ends)
        if math.isinf(low) or math.isinf(high):
            return None
        if low > high:
            raise limit.error("the lower limit is above the upper one")
        return low, high

    def _mimic(
        self, scope: Scope, name: str, element: Element, followers: dict[str, tuple[str, float, Element]]
    ) -> None:
        axis = element.one("axis")
        mimic = axis.one("mimic") if axis is not None else None
        if mimic is None:
            return
        if mimic.attributes.get("axis", "axis") != "axis":
            raise mimic.error("a joint that follows the second axis of another one is not read", "axis")
        multiplier, offset, reference = (
            e.read_numbers(e.text, (1,))[0] if (e := mimic.one(tag)) is not None else default
            for tag, default in (("multiplier", 1.0), ("offset", 0.0), ("reference", 0.0))
        )
        leader = mimic.needed("joint")
        found, short = scope.find(leader, mimic)
        off = offset - multiplier * reference
        slides = self.made.joints[scope.name + name].kind == "prismatic"
        self.made.askew(scope.name + name, off if slides else 0.0, 0.0 if slides else off, mimic)
        followers[scope.name + name] = (found.name + short, multiplier, mimic)

    def _controllers(self, scope: Scope) -> None:
        """Joints that plugins for controllers name are driven."""
        for plugin in scope.element.each("plugin"):
            said = f"{plugin.attributes.get('filename', '')} {plugin.attributes.get('name', '')}".lower()
            if any(word in said.replace("-", "").replace("_", "") for word in _CONTROLLERS):
                for element in plugin.each("joint_name"):
                    found, short = scope.find(element.text.strip(), element)
                    self.made.drive(found.name + short, element)


def _pitch(element: Element) -> float:
    """Metres for each radian, from either way to write it: metres for each turn, or the older one with radians for each
    metre the other way round.
    """
    new, old = element.one("screw_thread_pitch"), element.one("thread_pitch")
    if new is not None:
        return new.read_numbers(new.text, (1,))[0] / (2 * math.pi)
    value = old.read_numbers(old.text, (1,))[0] if old is not None else 1.0
    if value == 0 or old is None:
        raise (old or element).error("a screw needs a pitch other than 0", hint="write <screw_thread_pitch>")
    return -1.0 / value
