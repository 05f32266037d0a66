"""Reading a model file of whatever format, which is told by its root element."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from os import PathLike, fspath

from gcrules.core.errors import FileError
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.models.closures import load_closures
from gcrules.mechanisms.models.mjcf import read_mjcf
from gcrules.mechanisms.models.model import Model
from gcrules.mechanisms.models.sdf import read_sdf
from gcrules.mechanisms.models.urdf import read_urdf
from gcrules.mechanisms.models.xml_files import Element, load_xml, parse_xml, quoted

__all__ = ["READERS", "parse_model", "read_model"]

READERS: Mapping[str, Callable[[Element], Model]] = FrozenMap(
    {"robot": read_urdf, "sdf": read_sdf, "mujoco": read_mjcf}
)
"""How the model is read of a file with this root element."""


def read_model(path: str | PathLike[str], closures: str | PathLike[str] | None = None) -> Model:
    """The links and joints of a model file: URDF (`<robot>`), SDF (`<sdf>`) or MJCF (`<mujoco>`).

    `closures` is a second file (YAML) beside one in URDF, which says how its loops are closed and what is driven.
    Raises FileError with its place for a file that cannot be read or is at fault, and for loops that are open at home.
    """
    root = load_xml(path)
    _check(root)
    if closures is not None and READERS[root.tag] is read_urdf:
        return read_urdf(root, load_closures(closures))
    if closures is not None:
        hint = f"leave it out: <{root.tag}> says itself how its loops are closed"
        raise FileError("a file of closures goes with a model in URDF", filename=fspath(closures), hint=hint)
    return READERS[root.tag](root)


def parse_model(text: str, filename: str = "<input>") -> Model:
    """The model of a text, which includes no files. Raises FileError likewise."""
    root = parse_xml(text, filename)
    _check(root)
    for element in root.below():
        if element.tag == "include":
            raise element.error("a model that is given as text cannot include files", hint="give the file by its name")
    return READERS[root.tag](root)


def _check(root: Element) -> None:
    if root.tag not in READERS:
        hint = "files of models have <robot> (URDF), <sdf> (SDF) or <mujoco> (MJCF) at their root"
        raise root.error(f"the root element is <{quoted(root.tag)[1:-1]}>: this is not a model of a robot", hint=hint)
