"""Reading MJCF, the format of MuJoCo: bodies in a tree, equalities that close loops or couple joints, actuators.

Home is the keyframe named home, where there is one, else the state in which the file places its bodies. Several joints
of one body are joints of their own, with links between them.

Source: the XML reference of MuJoCo, and its chapter on computation (joints of one body move it one after the other).
"""

from __future__ import annotations

import numpy as np

from gcrules.core.hints import near
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.models.assembly import Assembly
from gcrules.mechanisms.models.mjcf_document import Defaults, compiler_of, expanded, sections
from gcrules.mechanisms.models.mjcf_tree import WORLD, BodyJoint, Site, bodies_of, elements, value_count
from gcrules.mechanisms.models.model import Model
from gcrules.mechanisms.models.places import frame, from_quaternion
from gcrules.mechanisms.models.xml_files import Element, quoted

__all__ = ["read_mjcf"]

_KINDS = {"hinge": "revolute", "slide": "prismatic", "ball": "ball", "free": "free"}
_IDLE = ("adhesion", "damper", "plugin")  # they drive no joint
_TRANSMISSIONS = ("tendon", "cranksite", "slidersite", "site", "body", "refsite")


def read_mjcf(root: Element) -> Model:
    """The model of an element `<mujoco>`. Raises FileError for what is at fault, for parts that hold the mechanism and
    are not read, and for loops that are open at home.
    """
    return _Mjcf(expanded(root)).model()


class _Mjcf:
    def __init__(self, root: Element) -> None:
        self.root = root
        self.compiler = compiler_of(root)
        self.defaults = Defaults(root)
        self.bodies, self.sites = bodies_of(root, self.compiler, self.defaults)
        self.joints: dict[str, BodyJoint] = {j.name: j for b in self.bodies for j in b.joints}
        self.values = {j.name: self._reference(j) for j in self.joints.values()}
        self.made = Assembly(root.attributes.get("model", ""), "mjcf", root, root.file.filename)
        self.made.link(WORLD, root)
        self.reference = self._frames(self.values)
        self._go_home()
        self.frames = self._frames(self.values)

    def model(self) -> Model:
        for body in self.bodies:
            self.made.link(body.name, body.element)
        self._add_tree()
        followers: dict[str, tuple[str, float, Element]] = {}
        for element in elements(self.root, "equality", self.defaults):
            if element.choice("active", ("true", "false"), "true") == "true":
                self._equality(element, followers)
        self.made.couple(followers)
        self._refuse_tendons()
        for element in elements(self.root, "actuator", self.defaults):
            self._actuator(element)
        return self.made.model(WORLD)

    # --- the tree at home ------------------------------------------------------------------------------------------

    def _reference(self, j: BodyJoint) -> list[float]:
        """The state of a joint where the file places its body; of a free one it is found from the place."""
        return {"ball": [1.0, 0.0, 0.0, 0.0], "free": []}.get(j.kind, [j.reference])

    def _go_home(self) -> None:
        """Take the state of the keyframe named home, if there is one."""
        keys = [k for k in sections(self.root, "keyframe") if k.attributes.get("name") == "home"]
        if not keys or "qpos" not in keys[0].attributes:
            return
        count = sum(value_count(j.kind) for j in self.joints.values())
        numbers = keys[0].read_numbers(keys[0].attributes["qpos"], (count,), "qpos")
        first = 0
        for j in self.joints.values():
            last = first + value_count(j.kind)
            self.values[j.name] = list(numbers[first:last])
            first = last

    def _frames(self, values: dict[str, list[float]]) -> dict[str, Floats]:
        """Where all bodies are in a state."""
        found = {WORLD: np.eye(4)}
        for body in self.bodies:
            here = found[body.parent] @ body.place
            for j in body.joints:
                here = j.motion(here, values[j.name]) @ here if values[j.name] else here
            found[body.name] = here
        return found

    def _add_tree(self) -> None:
        for body in self.bodies:
            here, last = self.frames[body.parent] @ body.place, body.parent
            if not body.joints:
                self.made.joint(f"{body.name} fixed", "fixed", (last, body.name), here[:3, 3], (), body.element)
            for k, j in enumerate(body.joints, start=1):
                link = body.name if k == len(body.joints) else f"{body.name} link {k}"
                if link != body.name:
                    self.made.link(link, body.element)
                at = (here @ [*j.at, 1.0])[:3]
                axes = (here[:3, :3] @ j.axis,) if j.kind in ("hinge", "slide") else ()
                self.made.joint(j.name, _KINDS[j.kind], (last, link), at, axes, j.element, limits=self._limits(j))
                here = j.motion(here, self.values[j.name]) @ here if self.values[j.name] else here
                last = link

    def _limits(self, j: BodyJoint) -> tuple[float, float] | None:
        """From home on; of a ball those of its angle."""
        if j.limits is None or j.kind == "ball":
            return j.limits
        home = self.values[j.name][0]
        return j.limits[0] - home, j.limits[1] - home

    # --- equalities ------------------------------------------------------------------------------------------------

    def _equality(self, element: Element, followers: dict[str, tuple[str, float, Element]]) -> None:
        if element.tag == "joint":
            self._coupled(element, followers)
        elif element.tag not in ("connect", "weld"):
            raise element.error(
                f"an equality <{quoted(element.tag)[1:-1]}> is not read", hint="loops are closed by connect and weld"
            )
        else:
            name = element.attributes.get("name") or f"{element.tag} {len(self.made.loops) + 1}"
            ends, places = self._ends(element)
            kind = {"connect": "ball", "weld": "fixed"}[element.tag]
            self.made.loop(name, kind, ends, places, None, element)

    def _ends(self, element: Element) -> tuple[tuple[str, str], tuple[Floats, Floats]]:
        """The two bodies that an equality holds together, and the frames on them that coincide, at home."""
        if "site1" in element.attributes or "site2" in element.attributes:
            sites = [self._site(element, attribute) for attribute in ("site1", "site2")]
            one, other = (self.frames[s.body] @ s.place for s in sites)
            return (sites[0].body, sites[1].body), (one, other)
        bodies = self._body(element, "body1"), self._body(element, "body2")
        first, second = bodies
        if element.tag == "connect":
            anchor = frame(element.read_numbers(element.needed("anchor"), (3,), "anchor"))
            meant = np.linalg.inv(self.reference[second]) @ self.reference[first] @ anchor
            return bodies, (self.frames[first] @ anchor, self.frames[second] @ meant)
        pose = element.numbers("relpose", (0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0))
        turn = from_quaternion(*pose[3:])
        related = (
            np.linalg.inv(self.reference[first]) @ self.reference[second] if turn is None else frame(pose[:3], turn)
        )
        anchor = frame(element.numbers("anchor", (0.0, 0.0, 0.0)))
        return bodies, (self.frames[first] @ related @ anchor, self.frames[second] @ anchor)

    def _body(self, element: Element, attribute: str) -> str:
        if attribute == "body2" and attribute not in element.attributes:
            return WORLD
        name = element.needed(attribute)
        if name not in self.frames:
            raise element.error(f"there is no body {quoted(name)}", attribute, near(name, self.frames))
        return name

    def _site(self, element: Element, attribute: str) -> Site:
        name = element.needed(attribute)
        if name not in self.sites:
            raise element.error(f"there is no site {quoted(name)}", attribute, near(name, self.sites))
        return self.sites[name]

    def _joint(self, element: Element, attribute: str) -> BodyJoint:
        name = element.needed(attribute)
        if name not in self.joints:
            raise element.error(f"there is no joint {quoted(name)}", attribute, near(name, self.joints))
        if attribute in ("joint1", "joint2") and self.joints[name].kind not in ("hinge", "slide"):
            raise element.error(
                f"joint {quoted(name)} is {self.joints[name].kind}: coupled joints have one freedom", attribute
            )
        return self.joints[name]

    def _coupled(self, element: Element, followers: dict[str, tuple[str, float, Element]]) -> None:
        """A joint whose value is a polynomial in that of another one, read where that is linear; with no other one it
        is held where it is.
        """
        joint = self._joint(element, "joint1")
        text = element.attributes.get("polycoef", "0 1 0 0 0")
        numbers = element.read_numbers(text, (1, 2, 3, 4, 5), "polycoef")
        constant, ratio, *rest = (*numbers, *(0.0, 1.0, 0.0, 0.0, 0.0)[len(numbers) :])
        if "joint2" not in element.attributes:
            self._held(joint, constant, element)
            return
        leader = self._joint(element, "joint2")
        if any(rest):
            raise element.error(
                f"joint {quoted(joint.name)} follows {quoted(leader.name)} by a polynomial that is not linear",
                "polycoef",
            )
        if joint.name in followers:
            raise element.error(f"joint {quoted(joint.name)} follows two others", "joint1")
        self._holds(joint, constant + ratio * self._from_reference(leader), element)
        if ratio:
            followers[joint.name] = (leader.name, ratio, element)
        else:
            self._held(joint, constant, element)

    def _held(self, joint: BodyJoint, value: float, element: Element) -> None:
        self._holds(joint, value, element)
        self.made.hold(joint.name)

    def _holds(self, joint: BodyJoint, value: float, element: Element) -> None:
        """A joint has to have a value at home, measured from where the file places its body."""
        off = self._from_reference(joint) - value
        turns = joint.kind == "hinge"
        self.made.askew(joint.name, 0.0 if turns else off, off if turns else 0.0, element)

    def _from_reference(self, joint: BodyJoint) -> float:
        return self.values[joint.name][0] - joint.reference

    # --- tendons, actuators ----------------------------------------------------------------------------------------

    def _refuse_tendons(self) -> None:
        """A tendon that is limited holds the mechanism as a cable does; springs and dampers do not."""
        for element in elements(self.root, "tendon", self.defaults):
            word = element.choice("limited", ("auto", "true", "false"), "auto")
            if word == "true" or (word == "auto" and self.compiler.autolimits and "range" in element.attributes):
                name = quoted(element.attributes.get("name", ""))
                raise element.error(
                    f"the tendon {name} has a limited length: it holds the mechanism as a cable does, and is not read"
                )

    def _actuator(self, element: Element) -> None:
        if element.tag in _IDLE:
            return
        name = quoted(element.attributes.get("name", element.tag))
        for attribute in ("joint", "jointinparent"):
            if attribute in element.attributes:
                self.made.drive(self._joint(element, attribute).name, element, attribute)
                return
        for attribute in _TRANSMISSIONS:
            if attribute in element.attributes:
                raise element.error(
                    f"the actuator {name} acts by a {attribute}: only those of joints are read", attribute
                )
        raise element.error(f"the actuator {name} acts on no joint", hint='write joint="…"')
