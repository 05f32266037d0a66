"""The frames of an SDF model: those of its links, joints, frames and models inside, each given relative to another one.

Source: the specification of SDFormat 1.11, "pose frame semantics".
"""

from __future__ import annotations

import os
import re

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.hints import near
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.models.places import frame, from_quaternion, roll_pitch_yaw
from gcrules.mechanisms.models.xml_files import Element, inside, load_xml, quoted

__all__ = ["MODEL", "WORLD", "Scope", "version_of"]

WORLD = "world"
MODEL = "__model__"
_DEPTH = 20
_CONFIG = "model.config"  # names the file of a model in its folder, for each version of the format


@dataclass(eq=False)
class _Frame:
    """A frame as written: its scope, its element, and the kind of thing that it belongs to."""

    kind: str  # model, link, joint, frame
    element: Element


class Scope:
    """The names of a model, and of those inside it; places are in the frame of the outermost one."""

    def __init__(
        self, element: Element, name: str = "", outer: Scope | None = None, source: Element | None = None
    ) -> None:
        self.element = element
        self.name = name
        self.outer = outer
        self.placed = source if source is not None else element  # whose <pose> says where it is
        self.frames: dict[str, _Frame] = {MODEL: _Frame("model", self.placed)}
        self.inner: dict[str, Scope] = {}
        self.places: dict[str, Floats] = {}
        self.depth: int = outer.depth + 1 if outer else 0
        if self.depth > _DEPTH:
            raise element.error(f"models inside models more than {_DEPTH} deep")
        for child in element.children:
            if child.tag in ("link", "joint", "frame"):
                self._add(child.needed("name"), _Frame(child.tag, child))
            elif child.tag == "model":
                self._inside(child.needed("name"), child, child)
            elif child.tag == "include":
                self._include(child)

    def _add(self, name: str, found: _Frame) -> None:
        if name in self.frames or name == WORLD or "::" in name:
            what = "is not allowed" if name not in self.frames else "occurs twice"
            raise found.element.error(f"the name {quoted(name)} {what}", "name")
        self.frames[name] = found

    def _inside(self, name: str, element: Element, source: Element) -> None:
        self._add(name, _Frame("model", source))
        self.inner[name] = Scope(element, f"{self.name}{name}::", self, source)

    def _include(self, include: Element) -> None:
        """A model in another file, which lies in the folder of the first one."""
        for attribute in ("merge", "placement_frame"):
            if include.attributes.get(attribute, "false") not in ("false", "0") or include.one(attribute):
                raise include.error(f"{attribute} of <include> is not read", attribute)
        uri = include.need("uri")
        path = uri.text.strip()
        for scheme in ("model://", "file://"):
            path = path.removeprefix(scheme)
        if "://" in path:
            raise uri.error(
                f"{quoted(path)} is not on this machine, and is not read", hint="write a name in the folder"
            )
        folder = os.path.dirname(os.path.abspath(self._top.element.file.filename))
        found = inside(uri, None, path, folder)
        if os.path.isdir(found):
            found = inside(uri, None, os.path.join(path, _named(found)), folder)
        scope: Scope | None = self
        while scope is not None:
            if os.path.realpath(scope.element.file.filename) == found:
                raise uri.error(f"{quoted(path)} includes itself")
            scope = scope.outer
        root = load_xml(found)
        model = root.one("model") if root.tag == "sdf" else None
        if model is None:
            raise root.error("a file that is included holds one <model> in <sdf>")
        own = include.one("name")
        self._inside((own.text.strip() if own else "") or model.needed("name"), model, include)

    @property
    def _top(self) -> Scope:
        return self.outer._top if self.outer else self

    @property
    def is_static(self) -> bool:
        """Whether its links do not move: it says so, or what includes it, or the model that it is in."""
        said = self.placed.one("static") or self.element.one("static")
        own = said is not None and said.text.strip().lower() in ("1", "true")
        return own or (self.outer is not None and self.outer.is_static)

    # --- places ----------------------------------------------------------------------------------------------------

    def place(self, name: str, asker: Element, seen: tuple[str, ...] = ()) -> Floats:
        """Where a frame of this scope is, in the outermost model. Raises FileError for unknown names and rings."""
        scope, short = self.find(name, asker)
        if scope is not self:
            return scope.place(short, asker, seen)
        if name not in self.places:
            whole = self.name + name
            if whole in seen:
                raise asker.error(f"the place of {quoted(name)} is given relative to itself, by way of others")
            self.places[name] = self._place(name, (*seen, whole))
        return self.places[name]

    def _place(self, name: str, seen: tuple[str, ...]) -> Floats:
        found = self.frames[name]
        if name == MODEL and self.outer is None:
            return np.eye(4)
        if name == MODEL:
            assert self.outer is not None
            return self.outer.place(self.name[:-2].rsplit("::", 1)[-1], found.element, seen)
        pose = found.element.one("pose")
        other = pose.attributes.get("relative_to", "") if pose is not None else ""
        asker = pose if pose is not None else found.element
        if not other:
            if found.kind == "joint":
                other = found.element.need("child").text.strip()
            else:
                other = found.element.attributes.get("attached_to", "") if found.kind == "frame" else ""
        if found.kind == "model" and (placement := self.inner[name].element.attributes.get("placement_frame")):
            raise self.inner[name].element.error(f"placement_frame={quoted(placement)} is not read", "placement_frame")
        if other == WORLD and found.kind == "joint":
            other = MODEL
        at = self.place(other or MODEL, asker, seen)
        return at @ read_pose(pose) if pose is not None else at

    def find(self, name: str, asker: Element) -> tuple[Scope, str]:
        """The scope in which a name like `arm::hand` is, and what it is called there."""
        first, _, rest = name.partition("::")
        if rest and first in self.inner:
            return self.inner[first].find(rest, asker)
        if name not in self.frames:
            raise asker.error(f"there is no frame {quoted(name)}", hint=near(name, self.frames))
        return self, name

    def link(self, name: str, asker: Element, seen: tuple[str, ...] = ()) -> str:
        """The link that a frame is fixed to, by its whole name. Raises FileError for rings of frames."""
        if name == WORLD:
            return WORLD
        scope, short = self.find(name, asker)
        found = scope.frames[short]
        whole = scope.name + short
        if whole in seen:
            raise asker.error(f"the frame {quoted(name)} is attached to itself, by way of others")
        if found.kind == "link":
            return whole
        if found.kind == "joint":
            return scope.link(found.element.need("child").text.strip(), found.element, (*seen, whole))
        if found.kind == "frame":
            other = found.element.attributes.get("attached_to") or MODEL
            return scope.link(other, found.element, (*seen, whole))
        model = scope if short == MODEL else scope.inner[short]
        return model.canonical(asker, (*seen, whole))

    def canonical(self, asker: Element, seen: tuple[str, ...]) -> str:
        """The link that stands for the model: the one that it names, or its first one."""
        named = self.element.attributes.get("canonical_link")
        if named:
            return self.link(named, self.element, seen)
        for name, found in self.frames.items():
            if found.kind == "link":
                return self.name + name
        for one in self.inner.values():
            return one.canonical(asker, seen)
        raise asker.error("a model without a link stands for none")

    def every(self) -> list[Scope]:
        """This scope, and those inside."""
        return [self, *(s for one in self.inner.values() for s in one.every())]


def _named(folder: str) -> str:
    """The file of the model in a folder: that of the newest version which the folder names, or model.sdf."""
    config = os.path.join(folder, _CONFIG)
    files = load_xml(config).each("sdf") if os.path.isfile(config) else ()
    return max(files, key=lambda e: version_of(e) or (0, 0)).text.strip() if files else "model.sdf"


def version_of(element: Element) -> tuple[int, int] | None:
    """That of the format which an element gives."""
    found = re.fullmatch(r"([0-9]{1,4})\.([0-9]{1,4})", element.attributes.get("version", "").strip())
    return (int(found[1]), int(found[2])) if found else None


def read_pose(pose: Element) -> Floats:
    """The frame that a `<pose>` gives; an empty one is none."""
    kind = pose.choice("rotation_format", ("euler_rpy", "quat_xyzw"), "euler_rpy")
    if not pose.text.strip():
        return np.eye(4)
    if kind == "quat_xyzw":
        x, y, z, qx, qy, qz, qw = pose.read_numbers(pose.text, (7,))
        turn = from_quaternion(qw, qx, qy, qz)
        if turn is None:
            raise pose.error("a quaternion of length 0 is not a turn")
        return frame((x, y, z), turn)
    x, y, z, *angles = pose.read_numbers(pose.text, (6,))
    unit = np.pi / 180 if pose.attributes.get("degrees") in ("true", "1") else 1.0
    return frame((x, y, z), roll_pitch_yaw(*(a * unit for a in angles)))
