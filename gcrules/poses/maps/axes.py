r"""The coordinates of poses that a map runs over: their names, units and nodes.

>>> read_axes(["x -2:2:5 mm", "zyx1 -90:90:181 deg"], "mm")[1].text
'zyx1 -90:90:181 deg'
>>> axis = parse_axis("x -2:2:5")
>>> axis.nodes.tolist(), axis.kind
([-2.0, -1.0, 0.0, 1.0, 2.0], 'translation')
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import GcrulesError, InputError, LimitReached, Span
from gcrules.core.hints import run_together
from gcrules.screws.pose import check_unit, read_number
from gcrules.screws.rotations import check_sequence

__all__ = [
    "ACTUATOR",
    "MAX_NODES",
    "TILT",
    "TRANSLATION",
    "TURNS",
    "VECTOR",
    "GridAxis",
    "are_ranges",
    "check_turns",
    "parse_axis",
    "read_axes",
    "read_ranges",
]

Floats = NDArray[np.float64]

TRANSLATION = ("x", "y", "z")
VECTOR = ("rx", "ry", "rz")
TILT = ("azimuth", "tilt", "torsion")
TURNS = ("yaw", "pitch", "roll")
"""In the order of the Euler angles ZYX, about axes that turn along, which they are."""
ACTUATOR = "actuator"
"""The kind of axes that stand for actuators, of robots of joints."""
MAX_NODES = 100_000
"""Nodes of one axis; more are refused."""
MAX_TILES = 1_000
"""Tiles of a map of whole boxes along one coordinate."""
MOST_TILES = 10_000_000
"""Tiles of a map of whole boxes in all."""

_DRIVE = re.compile(r"q[1-9]\d*")
_BETWEEN = re.compile(r":|\.\.")  # the ends of a range, which limits write with dots
_EULER = re.compile(r"([xyz]{3}|[XYZ]{3})([123])")
_ANGLES = {"deg": "deg", "degree": "deg", "degrees": "deg", "°": "deg", "rad": "rad", "radian": "rad", "radians": "rad"}
_FORM = 'write a coordinate, start:stop:number and the unit of angles: "x -200:200:201", "rz -90:90:181 deg"'
_RANGE_FORM = 'write a coordinate, start:stop and the unit of angles: "x -200:200", "roll -20:20 deg"'
_OTHER_RANGES = {
    (
        True,
        2,
    ): 'a number of nodes is missing, as in "x -200:200:201"; without one gcrules map boxes proves whole ranges',
    (False, 3): 'whole ranges have no number of nodes, as in "x -200:200"; gcrules map shows the poses at nodes',
}
"""Hints for ranges of the other kind of map, by whether a number of nodes belongs there, and the number of parts."""
_TILES = (64, 16, 8, 5, 3, 3)  # along each coordinate, by the number of coordinates
_NAMES = (
    "x, y, z; roll, pitch, yaw; rx, ry, rz; zyx1, zyx2, zyx3 (or another sequence); azimuth, tilt, torsion; of a robot "
    "of joints its actuators q1, q2 …"
)


@dataclass(frozen=True)
class GridAxis:
    """`number` nodes of the coordinate `name`, evenly from `start` to `stop`, both included, in `unit`.

    `kind` is translation | vector | tilt | actuator | a sequence of Euler angles, `place` which of its coordinates this
    is; roll, pitch and yaw are Euler angles ZYX.
    """

    name: str
    start: Fraction
    stop: Fraction
    number: int
    unit: str = ""

    @property
    def kind(self) -> str:
        for kind, names in (("translation", TRANSLATION), ("vector", VECTOR), ("tilt", TILT)):
            if self.name in names:
                return kind
        if self.name in TURNS:
            return "ZYX"
        return ACTUATOR if _DRIVE.fullmatch(self.name) else self.name[:3]

    @property
    def place(self) -> int:
        for names in (TRANSLATION, VECTOR, TILT, TURNS):
            if self.name in names:
                return names.index(self.name)
        return int(self.name.lstrip("q") if self.kind == ACTUATOR else self.name[3]) - 1

    @property
    def step(self) -> Fraction:
        """The distance of neighbouring nodes."""
        return (self.stop - self.start) / (self.number - 1)

    @property
    def scale(self) -> float:
        """What its unit is in radians, or in the unit of lengths."""
        return math.radians(1.0) if self.unit == "deg" else 1.0

    @cached_property
    def nodes(self) -> Floats:
        """The nodes in floats, each rounded once, shape (number,)."""
        return np.array([float(self.start + k * self.step) for k in range(self.number)])

    def at(self, node: Floats) -> Floats:
        """The coordinate at any place counted in nodes, 0 at the first one."""
        found: Floats = float(self.start) + np.asarray(node, dtype=np.float64) * float(self.step)
        return found

    @property
    def label(self) -> str:
        """The name with its unit, for pictures."""
        return f"{self.name} ({self.unit})" if self.unit else self.name

    @property
    def caption(self) -> str:
        """Whose coordinate it is, and its unit, for the axes of pictures."""
        match self.kind:
            case "translation":
                words = f"translation {self.name} of the platform"
            case "vector":
                words = f"rotation vector {self.name} of the platform"
            case "actuator":
                words = f"actuator {self.name}, from home"
            case _ if self.name in (*TURNS, *TILT):
                words = f"{self.name} of the platform"
            case _:
                words = f"Euler angle {self.name} of the platform"
        return f"{words} ({self.unit})" if self.unit else words

    @property
    def meaning(self) -> str:
        """What the coordinate is, in words."""
        match self.kind:
            case "translation":
                return f"translation of the platform along {self.name}"
            case "vector":
                return f"component of the platform's rotation vector along {self.name[1]}"
            case "tilt":
                return {
                    "azimuth": "direction towards which the platform is tilted, from x",
                    "tilt": "angle by which the platform's z axis is tilted",
                    "torsion": "turn of the platform about its own z axis",
                }[self.name]
            case "actuator":
                return f"amount of the actuator {self.name}, from home"
        if self.name in TURNS:
            turn = "about fixed axes: roll about x, then pitch about y, then yaw about z"
            return f"{self.name} of the platform ({turn})"
        ordinal = ("first", "second", "third")[self.place]
        return f"{ordinal} Euler angle of the platform, sequence {self.kind}"

    @property
    def text(self) -> str:
        """What `parse_axis` takes."""
        return f"{self.name} {_plain(self.start)}:{_plain(self.stop)}:{self.number} {self.unit}".rstrip()

    def to_json(self) -> dict[str, Any]:
        return {
            "name": self.name,
            "unit": self.unit,
            "start": float(self.start),
            "stop": float(self.stop),
            "number": self.number,
        }


def _plain(number: Fraction) -> str:
    text = repr(float(number)).removesuffix(".0")
    return text if Fraction(text) == number else str(number)


def read_axes(
    over: Sequence[str | GridAxis], unit: str = "", actuators: Mapping[str, bool] | None = None
) -> tuple[GridAxis, ...]:
    """Two or three axes; of a robot of joints `actuators` tells which of them are angles. Raises InputError for another
    number, for coordinates that do not go together, and for whatever `parse_axis` refuses.
    """
    listed = [over] if isinstance(over, (str, GridAxis)) else list(over)
    axes = tuple(a if isinstance(a, GridAxis) else parse_axis(a, unit, actuators) for a in listed)
    if len(axes) not in (2, 3):
        raise InputError(f"a map is over two or three coordinates, found {len(axes)}", hint=_FORM)
    return _together(axes)


def read_ranges(
    over: Sequence[str | GridAxis], unit: str, tiles: int | None, actuators: Mapping[str, bool] | None = None
) -> tuple[GridAxis, ...]:
    """One to six ranges "NAME start:stop [unit]" of coordinates of a pose, each cut into so many tiles, whose borders
    are the nodes; without a number into as many as make some hundreds in all. Raises InputError as `read_axes`,
    LimitReached for too many tiles in all.
    """
    listed = [over] if isinstance(over, (str, GridAxis)) else list(over)
    if not 1 <= len(listed) <= len(_TILES):
        raise InputError(f"a map of whole boxes is over one to six coordinates, found {len(listed)}", hint=_RANGE_FORM)
    if tiles is not None and not 1 <= tiles <= MAX_TILES:
        raise InputError(f"{tiles} tiles along each coordinate, expected 1 to {MAX_TILES}")
    number = (tiles or _TILES[len(listed) - 1]) + 1
    axes = tuple(a if isinstance(a, GridAxis) else parse_axis(a, unit, actuators, number) for a in listed)
    every = math.prod(a.number - 1 for a in axes)
    if every > MOST_TILES:
        raise LimitReached(f"{every:,} tiles: more than {MOST_TILES:,} in one map", hint="use fewer along each range")
    return _together(axes)


def are_ranges(over: Sequence[str | GridAxis]) -> bool:
    """Whether these are ranges without numbers of nodes, which a map of whole boxes takes. Raises InputError where
    some of them have a number and others have none.
    """
    listed = [over] if isinstance(over, (str, GridAxis)) else list(over)
    colons = [2 if isinstance(a, GridAxis) else len(_BETWEEN.findall("".join(a.split()[1:2]))) for a in listed]
    if 1 in colons and 2 in colons:
        plain, numbered = (a if isinstance(a, str) else a.text for a in (listed[colons.index(n)] for n in (1, 2)))
        raise InputError(
            f'"{plain[:60]}" is a whole range, and "{numbered[:60]}" has a number of nodes',
            hint="give each coordinate a number, for a map over nodes, or none, for one of whole boxes",
        )
    return 1 in colons


def check_turns(axes: Sequence[GridAxis]) -> None:
    """Raises InputError for a range of angles that goes more than once around."""
    for a in axes:
        if a.unit in _ANGLES.values() and float(a.stop - a.start) * a.scale > math.tau:
            raise InputError(f"{a.name} goes round more than once", hint="use a range of at most one turn")


def _together(axes: tuple[GridAxis, ...]) -> tuple[GridAxis, ...]:
    """The axes. Raises InputError for coordinates that do not go together."""
    meant = [(a.kind, a.place) for a in axes]
    twice = next((a.name for i, a in enumerate(axes) if meant[i] in meant[:i]), None)
    if twice is not None:
        raise InputError(f"the coordinate {twice} is given twice", hint="each axis is a different coordinate")
    driven = [a.name for a in axes if a.kind == ACTUATOR]
    if driven:
        if len(driven) < len(axes):
            raise InputError(f"{driven[0]} is an actuator, and others are coordinates of the pose", hint="use one kind")
        return axes
    turns = [a for a in axes if a.kind != "translation"]
    if len({a.kind for a in turns}) > 1:
        raise InputError(
            f"several kinds of turns: {', '.join(a.name for a in turns)}",
            hint="use angles of one kind: rx, ry, rz, or Euler angles of one sequence, or azimuth, tilt, torsion",
        )
    if len({a.unit for a in turns}) > 1:
        raise InputError(f"mixed units: deg and rad for {', '.join(a.name for a in turns)}")
    return axes


def parse_axis(
    text: str, unit: str = "", actuators: Mapping[str, bool] | None = None, number: int | None = None
) -> GridAxis:
    """Read "NAME start:stop:number [unit]", or "NAME start:stop [unit]" where the `number` of nodes is given, also
    with dots as limits have them, "x -1..1"; lengths are in `unit`, which they may name, angles say deg or rad, those
    of `actuators` that are angles too.

    Raises InputError for what is no axis, for numbers that are not finite, for a range that is empty or runs
    backwards and for fewer than two nodes, LimitReached for more than `MAX_NODES`.
    """
    try:
        return _axis(text.replace("°", " ° ").split(), unit, actuators or {}, number)
    except GcrulesError as fault:
        raise fault.located(text, "--over", Span(0, max(len(text), 1))) from None


def _axis(words: list[str], unit: str, actuators: Mapping[str, bool], nodes: int | None) -> GridAxis:
    form = _FORM if nodes is None else _RANGE_FORM
    if not 2 <= len(words) <= 3:
        apart = run_together(words[0], (*TRANSLATION, *VECTOR, *TILT, *TURNS)) if words else None
        more = f", one --over for each of {' and '.join(apart)}" if apart else ""
        raise InputError("this is not a coordinate with its range", hint=f"{form}{more}; the coordinates are {_NAMES}")
    name, bounds = words[:2]
    angle = actuators.get(name, name not in TRANSLATION)
    euler = _EULER.fullmatch(name)
    if euler:
        check_sequence(euler[1])
    elif name not in (*TRANSLATION, *VECTOR, *TILT, *TURNS, *actuators):
        if _DRIVE.fullmatch(name):
            some = f"the actuators are {', '.join(actuators)}" if actuators else "use coordinates of the pose"
            raise InputError(f"there is no actuator {name} to map over", hint=some)
        raise InputError(f"{name[:40]!r} is not a coordinate of a pose", hint=f"the coordinates are {_NAMES}")
    parts = _BETWEEN.split(bounds)
    if len(parts) != (3 if nodes is None else 2):
        other = _OTHER_RANGES.get((nodes is None, len(parts)), form)
        raise InputError(f"{bounds[:60]!r} is not a range", hint=other)
    start, stop = read_number(parts[0]), read_number(parts[1])
    number = _number(parts[2]) if nodes is None else nodes
    if start == stop:
        raise InputError(f"the range of {name} is empty: it starts and ends at {parts[0]}")
    if start > stop:
        raise InputError(f"the range of {name} is reversed", hint=f"write {':'.join([parts[1], parts[0], *parts[2:]])}")
    word = words[2] if len(words) == 3 else None
    if not angle:
        if word is not None:
            if word.lower() in _ANGLES:
                raise InputError(f"{name} is a length, {word} a unit of angles")
            check_unit(word, unit)
        return GridAxis(name, start, stop, number, unit)
    if word is None or word.lower() not in _ANGLES:
        raise InputError(f"{name} is an angle without a unit", hint=f'end with deg or rad: "{name} {bounds} deg"')
    return GridAxis(name, start, stop, number, _ANGLES[word.lower()])


def _number(word: str) -> int:
    if not re.fullmatch(r"\d{1,12}", word):
        raise InputError(f"{word[:40]!r} is not a number of nodes", hint=_FORM)
    number = int(word)
    if number < 2:
        raise InputError(f"{number} node{'s' * (number != 1)} on an axis", hint="give two or more")
    if number > MAX_NODES:
        raise LimitReached(f"{number:,} nodes on one axis are more than {MAX_NODES:,}", hint="use a coarser grid")
    return number
