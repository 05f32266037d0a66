"""Reading URDF: a tree of links, and what closes its loops.

A loop is closed by a second file (`closures`), by a link that is the child of two joints, or by an element
`<loop_joint>` (two links with a frame each) or `<constraint>` (parent and child with an origin and an axis each).

Source: the elements as wiki.ros.org/urdf/XML has them; `<constraint>` as proposed in ros/urdfdom, pull request 264.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.hints import near
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.models.assembly import Assembly, Origin
from gcrules.mechanisms.models.closures import NO_CLOSURES, Closures, Loop
from gcrules.mechanisms.models.model import Model
from gcrules.mechanisms.models.places import frame, from_quaternion, length, moved, roll_pitch_yaw
from gcrules.mechanisms.models.xml_files import Element, quoted

__all__ = ["read_urdf"]

_KINDS = {
    "fixed": "fixed",
    "revolute": "revolute",
    "continuous": "revolute",
    "prismatic": "prismatic",
    "planar": "planar",
    "floating": "free",
    "spherical": "ball",
    "ball": "ball",
    "universal": "universal",
    "cylindrical": "cylindrical",
}
_LIMITED = ("revolute", "prismatic")


def read_urdf(root: Element, closures: Closures = NO_CLOSURES) -> Model:
    """The model of an element `<robot>`. Raises FileError for what is no tree, and for loops that stay open."""
    return _Urdf(root, closures).model()


@dataclass(frozen=True, eq=False)
class _Joint:
    """A joint as written: `limits` are those of its value, which at home is `value`."""

    name: str
    kind: str
    parent: str
    child: str
    origin: Floats
    axis: Floats
    element: Element
    limits: tuple[float, float] | None = None


class _Urdf:
    def __init__(self, root: Element, closures: Closures) -> None:
        self.root = root
        self.closures = closures
        self.made = Assembly(root.attributes.get("name", ""), "urdf", root, root.file.filename)
        for element in root.each("link"):
            self.made.link(element.needed("name"), element)
        if not self.made.links:
            raise root.error("there are no links in this model")
        self.joints: dict[str, _Joint] = {}
        for element in root.each("joint", "drake:joint"):
            joint = self._joint(element)
            if joint.name in self.joints:
                first = self.joints[joint.name].element.line
                raise element.error(f"a second joint named {quoted(joint.name)} (the first in line {first})", "name")
            self.joints[joint.name] = joint
        for name, place in closures.places.items():
            self._known_joint(name, place)
        self.mimics = {j.name: m for j in self.joints.values() if (m := j.element.one("mimic")) is not None}
        self.frames: dict[str, Floats] = {}

    def model(self) -> Model:
        base = self._base()
        self._place(base)
        for element in self.root.each("loop_joint"):
            self._loop_joint(element)
        for element in self.root.each("constraint"):
            self._constraint(element)
        for number, loop in enumerate(self.closures.loops, start=1):
            self._loop(loop, number)
        followers = {name: (m.needed("joint"), m.number("multiplier", 1.0), m) for name, m in self.mimics.items()}
        self.made.couple(followers)
        for name, origin in self._motors():
            self.made.drive(name, origin)
        for name, place in self.closures.motors.items():
            self.made.drive(name, place)
        return self.made.model(base)

    # --- the tree --------------------------------------------------------------------------------------------------

    def _joint(self, element: Element) -> _Joint:
        name = element.needed("name")
        kind = _KINDS[element.choice("type", tuple(_KINDS))]
        kind = {"SPHERICAL": "ball", "FIXED": "fixed"}.get(self.closures.kinds.get(name, ""), kind)
        kind = "universal" if self.closures.kinds.get(name, "").startswith("UJOINT") else kind
        parent, child = (self._end(element.need(tag)) for tag in ("parent", "child"))
        if parent == child:
            raise element.error(f"joint {quoted(name)} joins {quoted(parent)} with itself")
        axis = element.one("axis")
        direction = np.array(axis.numbers("xyz", (1.0, 0.0, 0.0)) if axis else (1.0, 0.0, 0.0))
        if axis and kind in ("revolute", "prismatic", "planar", "cylindrical") and length(direction) < 1e-9:
            raise axis.error(f"the axis of joint {quoted(name)} has no direction", "xyz")
        limits = _limits(element) if element.attributes["type"] in _LIMITED and kind in _LIMITED else None
        return _Joint(name, kind, parent, child, _origin(element.one("origin")), direction, element, limits)

    def _end(self, element: Element) -> str:
        return self.made.known(element.needed("link"), element, "link")

    def _base(self) -> str:
        children = {j.child for j in self.joints.values()}
        roots = [name for name in self.made.links if name not in children]
        if not roots:
            raise self.root.error(
                "every link is the child of a joint, so that none is the base",
                hint="a tree begins at one link; let the joint that closes a loop lead away from the base",
            )
        if len(roots) > 1:
            raise self.made.links[roots[1]].error(
                f"neither {quoted(roots[0])} nor {quoted(roots[1])} is the child of a joint: which is the base?",
                "name",
            )
        return roots[0]

    def _place(self, base: str) -> None:
        """Frames of all links at home, from the base on; of two joints that lead to one link the first in the file
        places it, and the other closes a loop.
        """
        first: dict[str, _Joint] = {}
        for j in self.joints.values():
            first.setdefault(j.child, j)
        below: dict[str, list[_Joint]] = {}
        for j in first.values():
            below.setdefault(j.parent, []).append(j)
        self.frames[base] = np.eye(4)
        waiting = [base]
        while waiting:
            parent = waiting.pop()
            for j in reversed(below.get(parent, [])):
                at = self.frames[parent] @ j.origin
                axis = at[:3, :3] @ j.axis
                value = self._home(j.name)
                motion = moved(j.kind, at[:3, 3], axis / length(axis), value) if value else np.eye(4)
                self.frames[j.child] = motion @ at
                waiting.append(j.child)
        for name, element in self.made.links.items():
            if name not in self.frames:
                raise element.error(
                    f"link {quoted(name)} is not reached from the base {quoted(base)}: its joints form a circle", "name"
                )
        for j in self.joints.values():
            self._add(j, closing=first[j.child] is not j)

    def _add(self, j: _Joint, *, closing: bool) -> None:
        at = self.frames[j.parent] @ j.origin
        ends, axes = (j.parent, j.child), self._axes(j, at)
        if closing:
            other = self.frames[j.child]
            pair = (axes[0], self._axes(j, other)[-1]) if axes else None
            self.made.loop(j.name, j.kind, ends, (at, other), pair, j.element)
            return
        value = self._home(j.name)
        limits = (j.limits[0] - value, j.limits[1] - value) if j.limits else None
        self.made.joint(j.name, j.kind, ends, at[:3, 3], axes, j.element, limits=limits)

    def _axes(self, j: _Joint, at: Floats) -> tuple[Floats, ...]:
        if j.kind == "universal":
            letters = self.closures.kinds.get(j.name, "UJOINT_XY")[-2:]
            return tuple(at[:3, "XYZ".index(letter)] for letter in letters)
        return () if j.kind in ("fixed", "ball", "free") else (at[:3, :3] @ j.axis,)

    def _home(self, name: str, seen: tuple[str, ...] = ()) -> float:
        """The value of a joint at home: 0, unless it follows another one with an offset."""
        m = self.mimics.get(name)
        if m is None:
            return 0.0
        leader = m.needed("joint")
        self._known_joint(leader, m)
        if leader in (*seen, name):
            raise m.error(f"joint {quoted(name)} follows itself, by way of others", "joint")
        if self.joints[name].kind not in ("revolute", "prismatic"):
            raise m.error(f"joint {quoted(name)} is {self.joints[name].kind}: joints that follow have one freedom")
        return m.number("multiplier", 1.0) * self._home(leader, (*seen, name)) + m.number("offset", 0.0)

    def _known_joint(self, name: str, origin: Origin) -> None:
        if name not in self.joints:
            raise origin.error(f"there is no joint {quoted(name)}", "joint", near(name, self.joints))

    # --- loops -----------------------------------------------------------------------------------------------------

    def _loop_joint(self, element: Element) -> None:
        kind = _KINDS[element.choice("type", tuple(_KINDS))]
        ends = list(element.each("link1", "link2", "parent", "child"))
        if len(ends) != 2:
            raise element.error(f"<loop_joint> has {len(ends)} links, expected <link1> and <link2>")
        axis = element.one("axis")
        direction = np.array(axis.numbers("xyz", (1.0, 0.0, 0.0)) if axis else (1.0, 0.0, 0.0))
        frames = [_origin(element.one(f"{e.tag}_origin") or e) for e in ends]
        names = (self._end(ends[0]), self._end(ends[1]))
        self._close(element, kind, names, (frames[0], frames[1]), (direction, direction))

    def _constraint(self, element: Element) -> None:
        kind = _KINDS[element.choice("type", tuple(_KINDS))]
        names = (self._end(element.need("parent")), self._end(element.need("child")))
        one, other = (_origin(element.one(f"{end}_origin")) for end in ("parent", "child"))
        axes = [element.one(f"{end}_axis") for end in ("parent", "child")]
        first, second = (np.array(a.numbers("xyz", (1.0, 0.0, 0.0)) if a else (1.0, 0.0, 0.0)) for a in axes)
        self._close(element, kind, names, (one, other), (first, second))

    def _close(
        self,
        element: Element,
        kind: str,
        names: tuple[str, str],
        places: tuple[Floats, Floats],
        axes: tuple[Floats, Floats],
    ) -> None:
        """A joint that closes a loop, with a frame and an axis on each of its links."""
        name = element.needed("name")
        one, other = (self.frames[n] @ p for n, p in zip(names, places, strict=True))
        first, second = (at[:3, :3] @ axis for at, axis in zip((one, other), axes, strict=True))
        pair = None if kind in ("fixed", "ball", "free") else (first, second)
        self.made.loop(name, kind, names, (one, other), pair, element)

    def _loop(self, loop: Loop, number: int) -> None:
        (one, at), (other, place) = (self._frame(n, loop) for n in (loop.first, loop.second))
        name = f"{loop.first} = {loop.second}"
        name = f"{name} ({number})" if name in self.made.joints else name
        self.made.loop(name, loop.kind, (one, other), (at, place), None, loop.place)

    def _frame(self, name: str, loop: Loop) -> tuple[str, Floats]:
        """The link that a frame is on, and its place: frames bear the name of a link, or of the joint before it."""
        link = self.joints[name].child if name in self.joints else name
        if name in self.joints and name in self.made.links and link != name:
            raise loop.place.error(
                f"{quoted(name)} is the name of a link and that of a joint elsewhere: which is meant?"
            )
        if link not in self.frames:
            hint = near(name, [*self.made.links, *self.joints])
            raise loop.place.error(f"there is no link or joint {quoted(name)}", hint=hint)
        return link, self.frames[link]

    # --- actuators -------------------------------------------------------------------------------------------------

    def _motors(self) -> Iterator[tuple[str, Element]]:
        """Joints of transmissions, and those with a command interface."""
        for transmission in self.root.each("transmission"):
            for element in transmission.each("joint"):
                yield element.needed("name"), element
        for control in self.root.each("ros2_control"):
            for element in control.each("joint"):
                if any(element.each("command_interface")) and element.needed("name") not in self.mimics:
                    yield element.needed("name"), element


def _origin(element: Element | None) -> Floats:
    if element is None:
        return np.eye(4)
    turn = roll_pitch_yaw(*element.numbers("rpy", (0.0, 0.0, 0.0)))
    if "quat_xyzw" in element.attributes:
        x, y, z, w = element.numbers("quat_xyzw", (0.0, 0.0, 0.0, 1.0))
        found = from_quaternion(w, x, y, z)
        if found is None:
            raise element.error("a quaternion of length 0 is not a turn", "quat_xyzw")
        turn = found
    return frame(element.numbers("xyz", (0.0, 0.0, 0.0)), turn)


def _limits(element: Element) -> tuple[float, float] | None:
    """Limits of a revolute or prismatic joint; where only effort and velocity stand, or both ends are endless, none."""
    found = element.one("limit")
    if found is None or not {"lower", "upper"} & set(found.attributes):
        return None
    ends = (
        found.read_numbers(found.attributes.get(end, "0"), (1,), end, unlimited=True)[0] for end in ("lower", "upper")
    )
    low, high = ends
    if low > high:
        raise found.error("the lower limit is above the upper one", "lower")
    return None if math.isinf(low) or math.isinf(high) else (low, high)
