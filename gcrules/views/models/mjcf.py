"""A model of links and joints as MJCF, the format of MuJoCo: bodies in a tree, equalities that close its loops.

Masses and damping are placeholders, the same for each link, so that it can be simulated; rods show its links and
touch nothing.
"""

from __future__ import annotations

from collections.abc import Iterator

from gcrules.mechanisms.models.model import Model, ModelJoint
from gcrules.views.models.tree import LinkTree
from gcrules.views.models.xml_text import Tag

__all__ = ["mjcf_text"]

_TYPES = {"revolute": "hinge", "prismatic": "slide", "ball": "ball", "free": "free"}


def mjcf_text(model: Model) -> str:
    """The text of the file. Raises InputError for joints that it cannot hold."""
    tree = LinkTree(model)
    size = tree.size
    top = Tag("mujoco", model=model.name)
    top.add(
        Tag("compiler", angle="radian", autolimits="true"),
        Tag("option", timestep=0.001, integrator="implicitfast"),
        Tag("default").add(
            Tag("joint", damping=0.01 * size**2, armature=1e-4 * size**2),
            Tag("geom", type="capsule", size=0.01 * size, contype="0", conaffinity="0", mass=0.0),
            Tag("equality", solref=(0.004, 1.0)),
        ),
        Tag("worldbody").add(_body(tree, tree.base, None)),
    )
    equalities = [*(_closing(tree, j) for j in tree.closing), *_coupled(model)]
    if equalities:
        top.add(Tag("equality").add(*equalities))
    if model.actuated:
        motors = (Tag("motor", name=f"drive_{name}", joint=name) for name in model.actuated)
        top.add(Tag("actuator").add(*motors))
    return top.text() + "\n"


def _body(tree: LinkTree, link: str, j: ModelJoint | None) -> Tag:
    at = tree.offset(j.parent, j.at) if j is not None else (0.0, 0.0, 0.0)
    body = Tag("body", name=link, pos=at)
    inertia = (0.1 * tree.size) ** 2
    body.add(Tag("inertial", pos=tree.centre(link), mass=1.0, diaginertia=(inertia, inertia, inertia)))
    if j is not None and j.kind != "fixed":
        limits = j.limits if j.kind != "free" else None
        axis = j.axes[0] if j.axes else None
        body.add(Tag("joint", name=j.name, type=_TYPES[j.kind], axis=axis, range=limits))
    body.add(*(Tag("geom", fromto=(*a, *b)) for a, b in tree.rods(link)))
    return body.add(*(_body(tree, child.child, child) for child in tree.below[link]))


def _closing(tree: LinkTree, j: ModelJoint) -> Tag:
    tag = "connect" if j.kind == "ball" else "weld"
    holder = j.parent if j.kind == "ball" else j.child  # in whose frame the anchor is
    return Tag(tag, name=j.name, body1=j.parent, body2=j.child, anchor=tree.offset(holder, j.at))


def _coupled(model: Model) -> Iterator[Tag]:
    for c in model.couplings:
        yield Tag("joint", name=f"{c.joint}_follows", joint1=c.joint, joint2=c.leader, polycoef=(0, c.ratio, 0, 0, 0))
