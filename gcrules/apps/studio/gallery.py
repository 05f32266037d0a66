"""What there is to begin with: the classes of the catalog, robots and examples, each with a small drawing.

Nothing is analysed here: the first page is there at once.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cache
from pathlib import Path

from gcrules.algebra.language.legs_text import legs_text
from gcrules.algebra.structure import Structure
from gcrules.apps.studio.drawings import sketch
from gcrules.apps.studio.protocol.study_views import Gallery, GalleryItem, Theorem
from gcrules.core.errors import GcrulesError
from gcrules.mechanisms.description.discovery import RobotFile, examples, robots, theorems
from gcrules.mechanisms.load import read_example, read_robot
from gcrules.mechanisms.robot import Robot
from gcrules.rules.catalog.entries import Entry
from gcrules.rules.catalog.file import load as load_catalog
from gcrules.rules.plugin import packs
from gcrules.views.drawing.sample import sample_coordinates
from gcrules.views.robots.scene import sketched_from
from gcrules.views.robots.skeleton import skeleton

__all__ = ["classes_and_theorems", "gallery"]

KIND_WORDS = {
    "three-tetrahedra": "Singular when one of the tetrahedra {0}, {1} and {2} is flat.",
    "tetrahedron-planes-line": "Singular when the tetrahedron {0} is flat, or the planes {1} and {2} and the line {3}"
    " meet in a point.",
    "tetrahedron-four-lines": "Singular when the tetrahedron {0} is flat, or the legs {2} and {4} allow two turns in"
    " one ratio.",
    "four-planes": "Singular when the planes {0}, {1}, {2} and {3} meet in a point.",
    "two-planes-three-lines": "Singular when the legs {1} and {4} allow two turns in one ratio.",
    "transversals": "Singular when two legs allow the turns about two transversals in one ratio.",
    "one-incidence": "Singular when constructed planes and lines meet in a point.",
    "linear-complex": "Singular when the six legs belong to one linear complex.",
    "always-singular": "Singular in every pose.",
}
"""The kinds of conditions in a few words, with the joins of the expression in their sequence."""

GROUPS = {
    "a": "Six lines",
    "b": "Two planes and three lines",
    "c": "Four planes",
    "d": "A tetrahedron, two planes and a line",
    "e": "A tetrahedron and four lines",
    "f": "Two tetrahedra and two lines",
    "g": "Three tetrahedra",
}


FAMILIAR = (
    ("example", "octahedral"),
    ("robot", "gough-stewart"),
    ("robot", "delta"),
    ("robot", "3-rpr"),
    ("robot", "3-rps"),
)
"""The cards that a newcomer knows, which come first."""

_SIX_LEGS = "Gough Stewart platform hexapod six legs 6-SPS 6-UPS 6-dof"
_LIMBS = {2: "two limbs", 3: "tripod three limbs", 4: "four limbs", 5: "five limbs", 6: "hexapod six limbs"}
_WORDS = {
    "3-crr": "Cartesian gantry",
    "3-rrr-spherical": "wrist orientation",
    "5-rpur": "five axes",
    "6-pus": "linear hexapod",
    "8-cables": "cable-driven crane",
    "agile-eye": "wrist camera orientation",
    "delta": "pick and place Clavel",
    "exechon": "machine tool five axes",
    "gough-stewart": "hexapod",
    "gough-stewart-63": "hexapod TSSM",
    "h4": "Schoenflies SCARA 3T1R pick and place",
    "par4": "Quattro Schoenflies SCARA 3T1R pick and place",
    "quadrupteron": "SCARA 3T1R",
    "4-ruu": "SCARA 3T1R",
    "4-upu": "SCARA 3T1R",
    "reachy-mini-head": "hexapod",
    "tricept": "machine tool",
}
"""What people call robots beside their titles; what begins with a word that is sought comes before what has it."""
_OF_CLASSES = {"3-3.3": "octahedron MSSM", "6-3.2": "TSSM"}
_OF_EXAMPLES = {"octahedral": "octahedron MSSM"}


@cache
def gallery() -> Gallery:
    """All that can be opened by name."""
    return {
        **classes_and_theorems(),
        "robots": [item for one in robots() if (item := _of_robot(one))],
        "examples": [_of_example(name) for name in examples()],
    }


@cache
def classes_and_theorems() -> Gallery:
    """Those without dimensions."""
    return {
        "classes": [_of_class(e) for e in load_catalog(plugins=packs(bringing="catalogs")).entries],
        "robots": [],
        "examples": [],
        "theorems": [_of_theorem(path) for path in theorems().values()],
    }


def _of_theorem(path: Path) -> Theorem:
    text = path.read_text(encoding="utf-8")
    return {"title": text.partition("\n")[0].removeprefix("# "), "text": text}


def _of_class(e: Entry) -> GalleryItem:
    kind = e.condition.kind
    regular = GROUPS.get(e.group or "", "Beyond the published procedure")
    return {
        "id": e.id,
        "title": e.id + (f" · {e.name}" if e.name else ""),
        "detail": legs_text(e.legs),
        "group": "Always singular" if kind == "always-singular" else regular,
        "statement": _in_few_words(e),
        "words": _joined(_OF_CLASSES.get(e.id), _SIX_LEGS, "-".join(reversed(e.id.split(".")[0].split("-")))),
        "familiar": _familiar("class", e.id),
        "svg": _of_structure(e.structure),
        "source": {"kind": "class", "id": e.id},
    }


def _familiar(kind: str, name: str) -> int | None:
    """The place among the cards that come first."""
    return FAMILIAR.index((kind, name)) if (kind, name) in FAMILIAR else None


def _in_few_words(e: Entry) -> str:
    """The kind of the condition with what it is about; nothing for the kind of a user's own."""
    words = KIND_WORDS.get(e.condition.kind, "")
    try:
        return words.format(*re.findall(r"\w+", e.condition.expression_text))
    except IndexError:  # the catalog of a user has another expression of that kind
        return ""


def _of_structure(s: Structure) -> str:
    shape = sample_coordinates(s.oriented, s.base, s.platform)
    return sketch(shape, s.oriented, {"base": s.base, "platform": s.platform})


def _of_robot(one: RobotFile) -> GalleryItem | None:
    try:
        robot = read_robot(one.path)
    except GcrulesError:  # a plugin of the user's that is at fault shows when it is asked for by name
        return None
    return {
        "id": one.id,
        "title": robot.title,
        "detail": robot.chain,
        "group": f"{robot.mobility} degrees of freedom",
        "statement": robot.note,
        "words": _joined(_WORDS.get(one.id), _LIMBS.get(len(robot.limbs)), _of_six(robot), f"{robot.mobility}-dof"),
        "familiar": _familiar("robot", one.id),
        "svg": _of_limbs(robot),
        "source": {"kind": "robot", "id": one.id},
    }


def _joined(*words: str | None) -> str:
    return " ".join(filter(None, words))


def _of_six(robot: Robot) -> str:
    return _SIX_LEGS if robot.mobility == 6 and len(robot.limbs) == 6 else ""


def _of_limbs(robot: Robot) -> str:
    """Links, rods and bodies as in the robot's drawing, from a viewpoint at which they hide each other least."""
    if robot.home is None or not robot.limbs:
        return ""
    values = robot.values_at(robot.drawing)
    drawn = skeleton(robot, {n: [float(c) for c in v] for n, v in values.items()})
    drawn["strokes"] = [one for one in drawn["strokes"] if one["look"] != "axis"]
    places = [p for stroke in drawn["strokes"] for p in stroke["ends"]]
    names: dict[tuple[float, ...], str] = {}
    for p in (*places, *drawn["platform"], *drawn["base"]):
        names.setdefault(_rounded(p), f"p{len(names)}")
    links = [[names[_rounded(p)] for p in stroke["ends"]] for stroke in drawn["strokes"]]
    bodies = {body: [names[_rounded(p)] for p in drawn[body]] for body in ("base", "platform")}
    view = sketched_from(robot, values)
    named = {name: list(p) for p, name in names.items()}
    return sketch(named, links, bodies, seen=lambda p: view.flat((p[0], p[1], p[2])))


def _rounded(place: Sequence[float]) -> tuple[float, ...]:
    """One place is one point, whatever rounding says."""
    return tuple(float(f"{c:.9g}") + 0.0 for c in place)


def _of_example(name: str) -> GalleryItem:
    given = read_example(name)
    s = Structure(given.legs)
    points = {n: [float(c) for c in p] for n, p in given.points.items() if n in s.names}
    return {
        "id": name,
        "title": given.title,
        "detail": legs_text(given.legs),
        "group": "Platforms with dimensions",
        "statement": given.note,
        "words": _joined(_OF_EXAMPLES.get(name), _SIX_LEGS),
        "familiar": _familiar("example", name),
        "svg": sketch(points, s.oriented, {"base": s.base, "platform": s.platform}),
        "source": {"kind": "example", "name": name},
    }
