"""Platforms with their dimensions: the geometry file.

A YAML file with the keys

    title: Octahedral platform            # optional; the name of the file otherwise
    note: example, invented dimensions    # optional
    source: where the dimensions are from # optional
    units: mm                             # optional; one of `gcrules.screws.pose.UNITS`
    legs: [ab, af, cb, cd, ed, ef]        # two points each: ab, S1A1, "S1 A1" or [left, right]; or one text "ab af cb"
    limits: legs 200..500                 # optional; lengths that legs reach, in these units: "ab 200..500, cd 300.."
    points:                               # Cartesian coordinates in one frame, in these units
      a: [0, 1/2, -0.25]                  # whole numbers, decimals or quotients, all exact

Every point of a leg needs coordinates; a leg has two different ends in two different places.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from os import PathLike
from pathlib import PurePath

from gcrules.algebra.language.legs_text import leg_text
from gcrules.core.arguments import ROW, TEXT, described, listed, mapping, read, row
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.floats import exact
from gcrules.core.frozen import FrozenMap
from gcrules.core.hints import near
from gcrules.core.yaml_file import Document, Node
from gcrules.mechanisms.description.limits import limits_of_legs
from gcrules.mechanisms.description.point_pairs import point_pairs
from gcrules.mechanisms.description.units import UNIT_ONCE, read_units

__all__ = ["Platform", "load_platform", "parse_platform"]


Vector = tuple[Fraction, Fraction, Fraction]

_NAME = re.compile(r"[A-Za-z](?:[A-Za-z0-9_]*[A-Za-z0-9])?'*")
_MAX_NAME = 40


_LEGS = listed("a sequence of pairs of names", row("", TEXT, TEXT))
_POINTS = mapping("a mapping from names to places of three numbers", ROW)


@dataclass(frozen=True, slots=True)
class Platform:
    """Legs and the Cartesian coordinates of their end points, in `units` ("" if the file names none).

    `legs` are pairs of points as written; `points` gives (x, y, z), exact. `warnings` are sentences with their place
    in the file, `limits` the lengths that legs reach, as written.
    """

    legs: tuple[tuple[str, str], ...]
    points: Mapping[str, Vector]
    title: str = ""
    note: str = ""
    units: str = ""
    source: str = ""
    filename: str = "<input>"
    warnings: tuple[str, ...] = ()
    limits: str = ""

    def __post_init__(self) -> None:
        object.__setattr__(self, "legs", read(_LEGS, self.legs, "gc.Platform: `legs`"))
        points = read(_POINTS, self.points, "gc.Platform: `points`")
        for name, place in points.items():
            if len(place) != 3:
                raise InputError(f"gc.Platform: the point {described(name)} has {len(place)} coordinates, expected 3")
        found = {n: tuple(exact(c, f"a coordinate of {n}") for c in place) for n, place in points.items()}
        object.__setattr__(self, "points", FrozenMap(found))
        for name in ("title", "note", "units", "source", "filename", "limits"):
            read(TEXT, getattr(self, name), f"gc.Platform: `{name}`")
        if self.limits:
            limits_of_legs(self.limits, self.legs, self.units, "gc.Platform: `limits`")

    def homogeneous(self) -> dict[str, tuple[Fraction, Fraction, Fraction, Fraction]]:
        """The points as (x, y, z, 1), as `evaluate` takes them."""
        return {name: (*xyz, Fraction(1)) for name, xyz in self.points.items()}


def load_platform(path: str | PathLike[str]) -> Platform:
    """Read a geometry file. Raises FileError with all faults of the file, each with line and column."""
    return _platform(Document.load(path))


def parse_platform(text: str, filename: str = "<input>") -> Platform:
    """Read the text of a geometry file. Raises FileError likewise."""
    return _platform(Document.parse(text, filename))


def _platform(document: Document) -> Platform:
    top = document.root.mapping(
        required=("legs", "points"),
        optional=("title", "note", "source", "units", "limits"),
        reserved={"limbs": "a robot with limbs is analysed by `gcrules robot analyze`; it is not a geometry file"},
    )
    texts = {key: top[key].string() or "" for key in ("title", "note", "source") if key in top}
    units = read_units(top)
    points = _points(top["points"]) if "points" in top else {}
    legs = point_pairs(top["legs"], "leg") if "legs" in top else []
    for node, leg in legs:
        _check_leg(node, leg, points)
    limits = _limits(top["limits"], [leg for _, leg in legs], units) if "limits" in top else ""
    document.check()
    used = {name for _, leg in legs for name in leg}
    return Platform(
        legs=tuple(leg for _, leg in legs),
        points={name: xyz for name, (_, xyz) in points.items() if xyz is not None},
        title=texts.get("title") or PurePath(document.filename).stem,
        note=texts.get("note", ""),
        units=units,
        source=texts.get("source", ""),
        filename=document.filename,
        warnings=tuple(f"{key.place}: point {n} is in no leg" for n, (key, _) in points.items() if n not in used),
        limits=limits,
    )


_Points = dict[str, tuple[Node, Vector | None]]


def _points(node: Node) -> _Points:
    """Each point with the node of its key, and None for coordinates that are at fault."""
    found: _Points = {}
    for key, value in node.entries():
        if len(key.text) > _MAX_NAME or not _NAME.fullmatch(key.text):
            key.fault(
                f"{key.text[:_MAX_NAME]!r} is not a name for a point",
                "a letter, then letters, digits or primes: a, S1, A'",
            )
        numbers = [item.rational(UNIT_ONCE) for item in value.sequence(length=3)]
        x, y, z = numbers if len(numbers) == 3 else (None, None, None)
        found[key.text] = key, None if x is None or y is None or z is None else (x, y, z)
    if node.kind == "mapping" and not found:
        node.fault("there are no points")
    return found


def _limits(node: Node, legs: Sequence[tuple[str, str]], units: str) -> str:
    text = node.string() or ""
    if text and not node.document.faults:
        try:
            limits_of_legs(text, legs, units)
        except InputError as fault:
            node.fault_inside(text, fault)
    return text


def _check_leg(node: Node, leg: tuple[str, str], points: _Points) -> None:
    first, second = leg
    if first == second:
        node.fault(f"the leg {leg_text(leg)} goes from a point to itself")
        return
    for name in leg:
        if name not in points and points:
            node.fault(f"the leg names {name}, which has no coordinates", near(name, points) or f"add {name} to points")
    ends = [points[name][1] for name in leg if name in points]
    if len(ends) == 2 and ends[0] is not None and ends[0] == ends[1]:
        node.fault(f"{first} and {second} are in the same place, so the leg has no direction")
