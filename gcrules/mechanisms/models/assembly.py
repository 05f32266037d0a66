"""A model as it is put together from links and joints, whatever its format: what is said twice or of
nothing is a fault, and so is a loop that is open at home.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Protocol

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import FileError
from gcrules.core.hints import near
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.models.closing import Loop, Tree, closed, gaps
from gcrules.mechanisms.models.model import AXES, Model, ModelCoupling, ModelJoint
from gcrules.mechanisms.models.places import angle_between, length, vector
from gcrules.mechanisms.models.xml_files import quoted

__all__ = ["OPEN", "Assembly", "Origin"]

OPEN = 1e-4  # parts of the model's size, and radians: loops that are farther open are not closed
MAX_JOINTS = 2000
HINT = "in MJCF a keyframe named home says where a model begins"


class Origin(Protocol):
    """Where something stands in a file: an element."""

    @property
    def line(self) -> int: ...
    @property
    def column(self) -> int: ...
    def error(self, message: str, attribute: str | None = None, hint: str | None = None) -> FileError: ...


@dataclass(frozen=True)
class _Gap:
    """How far something that closes a loop is open at home: a length, an angle, and who says so."""

    name: str
    distance: float
    angle: float
    origin: Origin


class Assembly:
    """Links by their names with their frames at home, joints, couplings; `model` checks them, and gives the value."""

    def __init__(self, name: str, form: str, root: Origin, filename: str) -> None:
        self.name = name or "model"
        self.form = form
        self.root = root
        self.filename = filename
        self.links: dict[str, Origin] = {}
        self.joints: dict[str, ModelJoint] = {}
        self.origins: dict[str, Origin] = {}
        self.couplings: list[ModelCoupling] = []
        self.actuated: dict[str, None] = {}
        self.gaps: list[_Gap] = []
        self.loops: list[Loop] = []
        self.notes: list[str] = []

    # --- what there is ---------------------------------------------------------------------------------------------

    def link(self, name: str, origin: Origin) -> None:
        """Raises FileError for a name that occurred before."""
        if name in self.links:
            first = self.links[name].line
            raise origin.error(f"a second link named {quoted(name)} (the first in line {first})", "name")
        self.links[name] = origin

    def known(self, name: str, origin: Origin, attribute: str | None = None) -> str:
        """The name of a link. Raises FileError for others."""
        if name not in self.links:
            raise origin.error(f"there is no link {quoted(name)}", attribute, near(name, self.links))
        return name

    def joint(
        self,
        name: str,
        kind: str,
        ends: tuple[str, str],
        at: Floats,
        axes: Sequence[Floats],
        origin: Origin,
        *,
        limits: tuple[float, float] | None = None,
        pitch: float = 0.0,
        closing: bool = False,
    ) -> None:
        """Add a joint between two links, at its place in the frame of the base at home, its axes of any length.

        Raises FileError for a name that occurred before, an axis of no direction, and a joint of a link with itself.
        """
        if name in self.joints:
            first = self.joints[name].line
            raise origin.error(f"a second joint named {quoted(name)} (the first in line {first})", "name")
        if len(self.joints) >= MAX_JOINTS:
            raise origin.error(f"more than {MAX_JOINTS} joints")
        parent, child = ends
        if parent == child:
            raise origin.error(f"joint {quoted(name)} joins {quoted(parent)} with itself")
        if any(length(a) < 1e-9 for a in axes):
            raise origin.error(f"the axis of joint {quoted(name)} has no direction")
        if limits is not None and limits[0] > limits[1]:
            raise origin.error(f"the lower limit of joint {quoted(name)} is above the upper one")
        units = tuple(vector(a / length(a)) for a in axes)
        assert len(units) == AXES[kind]
        if len(units) == 2 and angle_between(np.array(units[0]), np.array(units[1])) < OPEN:
            raise origin.error(f"the two axes of joint {quoted(name)} are parallel")
        self.origins[name] = origin
        self.joints[name] = ModelJoint(
            name, kind, parent, child, vector(at), units, limits, pitch, closing, origin.line, origin.column
        )

    def drive(self, name: str, origin: Origin, attribute: str | None = None) -> None:
        """A joint is driven. Raises FileError for a name that no joint has."""
        if name not in self.joints:
            raise origin.error(f"there is no joint {quoted(name)}", attribute, near(name, self.joints))
        if self.joints[name].kind == "fixed":
            raise origin.error(f"joint {quoted(name)} is fixed, and cannot be driven", attribute)
        self.actuated[name] = None

    def hold(self, name: str) -> None:
        """A joint stays at its value at home."""
        self.joints[name] = replace(self.joints[name], kind="fixed", axes=(), limits=None)

    def loop(
        self,
        name: str,
        kind: str,
        ends: tuple[str, str],
        frames: tuple[Floats, Floats],
        axes: tuple[Floats, Floats] | None,
        origin: Origin,
    ) -> None:
        """Add a joint that closes a loop, with a frame on each of its links, and an axis on each if it has such.

        Raises FileError as `joint` does.
        """
        if axes is not None and any(length(a) < 1e-9 for a in axes):
            raise origin.error(f"the axis of joint {quoted(name)} has no direction")
        own = () if axes is None else axes if kind == "universal" else axes[:1]
        self.joint(name, kind, ends, frames[0][:3, 3], own, origin, closing=True)
        self.loops.append(Loop(name, kind, ends, frames, axes))

    def askew(self, name: str, distance: float, angle: float, origin: Origin) -> None:
        """Something should be 0 at home: a distance, an angle."""
        self.gaps.append(_Gap(name, abs(distance), abs(angle), origin))

    def couple(self, followers: Mapping[str, tuple[str, float, Origin]]) -> None:
        """Joints that follow others, with their ratios; of one that follows a follower the ratio to the first leader.

        Raises FileError for a ring of joints that follow each other, and for joints with no or several freedoms.
        """
        for name, (leader, ratio, origin) in followers.items():
            seen = {name}
            while leader in followers:
                if leader in seen:
                    raise origin.error(f"joint {quoted(name)} follows itself, by way of others")
                seen.add(leader)
                leader, factor, _ = followers[leader]
                ratio *= factor
            for one in (name, leader):
                if one not in self.joints:
                    raise origin.error(f"there is no joint {quoted(one)}", "joint", near(one, self.joints))
                if self.joints[one].kind not in ("revolute", "prismatic", "screw"):
                    kind = self.joints[one].kind
                    raise origin.error(f"joint {quoted(one)} is {kind}: joints that follow have one freedom")
            self.couplings.append(ModelCoupling(name, leader, ratio))

    # --- the value -------------------------------------------------------------------------------------------------

    def model(self, base: str | None = None) -> Model:
        """The model, its base first among the links. Raises FileError where a loop is open at home, or a link hangs on
        nothing.
        """
        links = self._reached(base or next(iter(self.links), ""))
        self._check_gaps()
        self._close(links[0])
        return Model(
            self.name,
            self.form,
            self.filename,
            links,
            tuple(self._merged()),
            tuple(self.actuated),
            tuple(self.couplings),
            tuple(self.notes),
        )

    @property
    def size(self) -> float:
        """The diagonal of the box around all joints, and both sides of each loop."""
        sides = [f[:3, 3] for loop in self.loops for f in loop.frames]
        places = np.array([*(j.at for j in self.joints.values()), *sides] or [(0.0, 0.0, 0.0)])
        return length(places.max(axis=0) - places.min(axis=0))

    def _check_gaps(self) -> None:
        """Raises FileError where what should be 0 at home is not."""
        for gap in self.gaps:
            if gap.distance > OPEN * self.size or gap.angle > OPEN:
                off = f"{gap.distance:.3g} m" if gap.distance else f"{gap.angle:.3g} rad"
                raise gap.origin.error(
                    f"joint {quoted(gap.name)} is off by {off} at home from what it has to be", hint=HINT
                )

    def _close(self, base: str) -> None:
        """Where loops are open in the state that the file gives, move the joints until they are closed."""
        size = self.size
        is_open = [loop for loop in self.loops if not _is_closed(loop, size)]
        if not is_open:
            return
        tree = Tree(base, [j for j in self.joints.values() if not j.closing], self.couplings)
        amounts = closed(tree, self.loops, size, tuple(self.actuated))
        if amounts is None:
            distance, angle = gaps(is_open[0])
            off = (
                f"{distance:.3g} m, {distance / size:.2g} of the size of the model," if distance else f"{angle:.3g} rad"
            )
            raise self.origins[is_open[0].name].error(
                f"the loop that {quoted(is_open[0].name)} closes is open by {off} at home,"
                " and no values of the joints were found that close it",
                hint=HINT,
            )
        motions, _ = tree.motions(amounts)
        values = {j.name: float((tree.parts @ amounts)[own][0]) for j, own in tree.steps if own.stop == own.start + 1}
        for name, j in self.joints.items():
            self.joints[name] = _carried(j, motions[j.parent], values.get(name, 0.0))
        most = max(values.items(), key=lambda v: abs(v[1]), default=("", 0.0))
        unit = "m" if most[0] and self.joints[most[0]].kind == "prismatic" else "rad"
        self.notes.append(
            f"{len(is_open)} of {len(self.loops)} loops are open in the state that the file gives, by up to"
            f" {max(gaps(loop)[0] for loop in is_open):.3g} m; home is one near it in which all are closed"
            + (f" (joint {most[0]} moved by {most[1]:.3g} {unit}, the others by less)" if most[0] else "")
        )

    def _reached(self, base: str) -> tuple[str, ...]:
        if not self.joints:
            raise self.root.error("there are no joints in this model")
        beside: dict[str, list[str]] = {name: [] for name in self.links}
        for j in self.joints.values():
            beside[j.parent].append(j.child)
            beside[j.child].append(j.parent)
        found = {base: None}
        waiting = [base]
        while waiting:
            for other in beside[waiting.pop()]:
                if other not in found:
                    found[other] = None
                    waiting.append(other)
        for name, origin in self.links.items():
            if name not in found:
                raise origin.error(f"link {quoted(name)} is not joined to the base {quoted(base)}", "name")
        return (base, *(name for name in self.links if name != base))

    def _merged(self) -> Iterable[ModelJoint]:
        """The joints; several balls that close loops between the same two links, as formats without other means write
        them, are one hinge, or fix the links.
        """
        balls: dict[frozenset[str], list[ModelJoint]] = {}
        for j in self.joints.values():
            if j.closing and j.kind == "ball":
                balls.setdefault(frozenset((j.parent, j.child)), []).append(j)
        gone: set[str] = set()
        made: dict[str, ModelJoint] = {}
        for several in balls.values():
            if len(several) > 1:
                gone |= {j.name for j in several[1:]}
                made[several[0].name] = _one_of(several, self.size)
        return (made.get(j.name, j) for j in self.joints.values() if j.name not in gone)


def _is_closed(loop: Loop, size: float) -> bool:
    distance, angle = gaps(loop)
    return distance <= OPEN * size and angle <= OPEN


def _carried(j: ModelJoint, motion: Floats, value: float) -> ModelJoint:
    """The joint where its parent has moved to, when its own value is no longer 0."""
    at = vector((motion @ [*j.at, 1.0])[:3])
    axes = tuple(vector(motion[:3, :3] @ a) for a in j.axes)
    limits = j.limits if j.limits is None or j.kind == "ball" else (j.limits[0] - value, j.limits[1] - value)
    return replace(j, at=at, axes=axes, limits=limits)


def _one_of(balls: Sequence[ModelJoint], size: float) -> ModelJoint:
    """What several balls between the same two links are together."""
    first = balls[0]
    arms = np.array([j.at for j in balls]) - np.array(first.at)
    _, sizes, axes = np.linalg.svd(arms)
    rank = int((sizes > OPEN * size).sum())
    if rank == 0:
        return first
    if rank == 1:
        return replace(first, kind="revolute", axes=(vector(axes[0]),))
    return replace(first, kind="fixed")
