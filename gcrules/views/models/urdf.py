"""A model of links and joints as URDF, and beside it the file that closes its loops.

A joint with a ball is written as a hinge, which the second file makes a ball; loops are closed there, by pairs of
frames. Masses are placeholders, the same for each link.
"""

from __future__ import annotations

from collections.abc import Sequence

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.mechanisms.models.model import Model, ModelJoint, Vector
from gcrules.views.models.tree import LinkTree
from gcrules.views.models.xml_text import Tag

__all__ = ["UrdfFiles", "urdf_files"]

_TYPES = {"fixed": "fixed", "prismatic": "prismatic", "ball": "continuous", "free": "floating"}


@dataclass(frozen=True)
class UrdfFiles:
    """The text of a file in URDF, and of that with its closures (YAML)."""

    urdf: str
    closures: str


def urdf_files(model: Model) -> UrdfFiles:
    """Both files. Raises InputError for joints that they cannot hold."""
    tree = LinkTree(model)
    top = Tag("robot", name=model.name)
    leaders = {c.joint: c for c in model.couplings}
    for link in tree.order():
        top.add(_link(tree, link))
        for j in tree.below[link]:
            joint = _joint(j.name, _type(j), j.parent, j.child, tree.offset(j.parent, j.at))
            if j.kind not in ("fixed", "free"):
                joint.add(Tag("axis", xyz=j.axes[0] if j.axes else (0.0, 0.0, 1.0)))
            if j.limits is not None and j.kind == "ball":
                raise InputError(f"the limit of the ball {j.name} is not written in URDF")
            if j.kind in ("revolute", "prismatic"):
                low, high = j.limits or (None, None)
                joint.add(Tag("limit", lower=low, upper=high, effort=1000.0, velocity=1000.0))
            if j.name in leaders:
                c = leaders[j.name]
                joint.add(Tag("mimic", joint=c.leader, multiplier=c.ratio, offset=0.0))
            top.add(joint)
    for j in tree.closing:
        for letter, link in (("a", j.parent), ("b", j.child)):
            frame = f"{j.name}_{letter}"
            top.add(Tag("link", name=frame))
            top.add(_joint(f"{frame}_frame", "fixed", link, frame, tree.offset(link, j.at)))
    for name in model.actuated:
        top.add(_transmission(name))
    text = '<?xml version="1.0"?>\n' + top.text() + "\n"
    return UrdfFiles(text, _closures(tree))


def _type(j: ModelJoint) -> str:
    return ("revolute" if j.limits else "continuous") if j.kind == "revolute" else _TYPES[j.kind]


def _joint(name: str, kind: str, parent: str, child: str, at: Vector) -> Tag:
    joint = Tag("joint", name=name, type=kind)
    return joint.add(Tag("parent", link=parent), Tag("child", link=child), Tag("origin", xyz=at, rpy=(0, 0, 0)))


def _link(tree: LinkTree, name: str) -> Tag:
    inertia = (0.1 * tree.size) ** 2
    inertial = Tag("inertial").add(
        Tag("origin", xyz=tree.centre(name), rpy=(0, 0, 0)),
        Tag("mass", value=1.0),
        Tag("inertia", ixx=inertia, ixy=0.0, ixz=0.0, iyy=inertia, iyz=0.0, izz=inertia),
    )
    return Tag("link", name=name).add(inertial)


def _transmission(name: str) -> Tag:
    transmission = Tag("transmission", name=f"drive_{name}")
    return transmission.add(
        Tag("type", "transmission_interface/SimpleTransmission"),
        Tag("joint", name=name).add(Tag("hardwareInterface", "hardware_interface/EffortJointInterface")),
        Tag("actuator", name=f"motor_{name}"),
    )


def _closures(tree: LinkTree) -> str:
    loops = [f"[{_quoted(f'{j.name}_a')}, {_quoted(f'{j.name}_b')}]" for j in tree.closing]
    types = [{"ball": "3d", "fixed": "6d"}[j.kind] for j in tree.closing]
    balls = [_quoted(j.name) for j in tree.model.joints if j.kind == "ball" and not j.closing]
    lines = [
        _entry("closed_loop", loops),
        _entry("type", types),
        _entry("name_mot", [_quoted(name) for name in tree.model.actuated]),
    ]
    if balls:
        lines += [_entry("joint_name", balls), _entry("joint_type", ["SPHERICAL"] * len(balls))]
    return "\n".join(lines) + "\n"


def _entry(key: str, items: Sequence[str]) -> str:
    if not items:
        return f"{key}: []"
    return "\n".join([f"{key}:", *(f"  - {item}" for item in items)])


def _quoted(name: str) -> str:
    """A name as a word of YAML."""
    return name if name.replace("_", "a").isalnum() and name[:1].isalpha() else "'" + name.replace("'", "''") + "'"
