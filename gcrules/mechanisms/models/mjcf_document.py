"""An MJCF file with what it includes put in its place, its classes of defaults, and the settings of its compiler.

Source: the XML reference of MuJoCo (sections include, compiler, default, and frame orientations).
"""

from __future__ import annotations

import math
import os
from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.hints import near
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.models.places import about_axis, euler, frame, from_axes, from_quaternion, from_z, length
from gcrules.mechanisms.models.xml_files import Element, inside, load_xml, quoted

__all__ = ["Compiler", "Defaults", "compiler_of", "expanded", "sections"]

MAX_INCLUDES = 200
_TURNS = ("quat", "axisangle", "xyaxes", "zaxis", "euler")


def expanded(root: Element) -> Element:
    """The same tree with each `<include>` replaced by what is in the file that it names, from the folder of the main
    file. Raises FileError for files outside that folder, and for one that is included twice, or by itself.
    """
    folder = os.path.dirname(os.path.abspath(root.file.filename))
    seen = {os.path.realpath(root.file.filename)}
    return _expanded(root, folder, seen)


def _expanded(element: Element, folder: str, seen: set[str]) -> Element:
    if not any(e.tag == "include" for e in element.below()):
        return element
    children: list[Element] = []
    for child in element.children:
        children += _included(child, folder, seen) if child.tag == "include" else [_expanded(child, folder, seen)]
    return replace(element, children=children)


def _included(element: Element, folder: str, seen: set[str]) -> list[Element]:
    name = element.needed("file")
    path = inside(element, "file", name, folder)
    if path in seen:
        raise element.error(f"{quoted(name)} is included twice, or by itself", "file", "MJCF includes a file once")
    if len(seen) > MAX_INCLUDES:
        raise element.error(f"more than {MAX_INCLUDES} files are included")
    seen.add(path)
    return _expanded(load_xml(path), folder, seen).children


# --- the compiler's settings ---------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Compiler:
    """Settings that say how numbers are to be read: the unit of angles in radians, the sequence of Euler angles."""

    angle: float = math.pi / 180
    sequence: str = "xyz"
    autolimits: bool = True

    def place(self, element: Element) -> Floats:
        """The frame that an element gives with `pos` and one of the ways to write a turn."""
        return frame(element.numbers("pos", (0.0, 0.0, 0.0)), self.turn(element))

    def turn(self, element: Element) -> Floats:
        """The turn (3, 3) of an element. Raises FileError for several, and for what is none."""
        written = [a for a in _TURNS if a in element.attributes]
        if not written:
            return np.eye(3)
        if len(written) > 1:
            raise element.error(f"a turn is written in one way, not as {written[0]} and {written[1]}", written[1])
        numbers = np.array(element.read_numbers(element.attributes[written[0]], _COUNTS[written[0]], written[0]))
        found = self._turn(written[0], numbers)
        if found is None:
            raise element.error(f"{written[0]} is not a turn: a direction has no length", written[0])
        return found

    def _turn(self, written: str, n: Floats) -> Floats | None:
        match written:
            case "quat":
                return from_quaternion(*n)
            case "axisangle":
                size = length(n[:3])
                return about_axis(n[:3] / size, n[3] * self.angle) if size > 1e-12 else None
            case "xyaxes":
                return from_axes(n[:3], n[3:])
            case "zaxis":
                return from_z(n)
            case _:
                return euler(n * self.angle, self.sequence)


_COUNTS = {"quat": (4,), "axisangle": (4,), "xyaxes": (6,), "zaxis": (3,), "euler": (3,)}


def compiler_of(root: Element) -> Compiler:
    """The settings of a file; those of a later `<compiler>` have precedence. Raises FileError for unknown ones."""
    found = Compiler()
    for element in root.each("compiler"):
        if "angle" in element.attributes:
            radian = element.choice("angle", ("radian", "degree")) == "radian"
            found = replace(found, angle=1.0 if radian else math.pi / 180)
        if "eulerseq" in element.attributes:
            sequence = element.needed("eulerseq")
            if len(sequence) != 3 or set(sequence) - set("xyzXYZ"):
                raise element.error("eulerseq is three letters of xyz, XYZ", "eulerseq")
            found = replace(found, sequence=sequence)
        if element.choice("coordinate", ("local", "global"), "local") == "global":
            raise element.error(
                "global coordinates are not read",
                "coordinate",
                "older versions of MuJoCo save such a model with local ones",
            )
        if "autolimits" in element.attributes:
            found = replace(found, autolimits=element.choice("autolimits", ("true", "false")) == "true")
    return found


# --- defaults ------------------------------------------------------------------------------------------------------


class Defaults:
    """Classes of defaults: what each says of elements with each tag, with what its parents say."""

    def __init__(self, root: Element) -> None:
        self.classes: dict[str, dict[str, dict[str, str]]] = {"main": {}}
        for element in root.each("default"):
            self._add(element, "main", top=True)

    def _add(self, element: Element, parent: str, *, top: bool = False) -> None:
        name = element.attributes.get("class", "main" if top else "")
        if not name:
            raise element.error("a class of defaults inside another one needs a name", hint='write class="…"')
        if top and name != "main" and not any(self.classes["main"].values()):
            self.classes.setdefault(name, self.classes["main"])  # the outermost class may bear a name of its own
            self.classes["main"] = self.classes[name]
        elif not top and name in self.classes:
            raise element.error(f"a second class of defaults named {quoted(name)}", "class")
        elif not top:
            self.classes[name] = {tag: dict(said) for tag, said in self.classes[parent].items()}
        own = self.classes.setdefault(name, {})
        for child in element.children:
            if child.tag != "default":
                own[child.tag] = {**own.get(child.tag, {}), **child.attributes}
        for child in element.each("default"):
            self._add(child, name)

    def of(self, element: Element, inherited: str = "main") -> Element:
        """The element with its class's defaults among its attributes. Raises FileError for an unknown class."""
        name = element.attributes.get("class", inherited)
        self.known(element, name, "class")
        said: Mapping[str, str] = self.classes[name].get(element.tag, {})
        return replace(element, attributes={**said, **element.attributes}) if said else element

    def known(self, element: Element, name: str, attribute: str) -> None:
        if name not in self.classes:
            raise element.error(f"there is no class of defaults {quoted(name)}", attribute, near(name, self.classes))


def sections(root: Element, tag: str) -> Iterator[Element]:
    """What is in all sections with this tag."""
    for section in root.each(tag):
        yield from section.children
