r"""Joints and their twists, one table for all kinds.

A joint is written with the geometry that its kind asks for, in one frame and at one configuration; with floats each
vector may be an array whose last axis holds the coordinates, so that it stands for many configurations.

    >>> hinge = joint("R", point=(1, 0, 0), axis=(0, 0, 1), actuated=True)
    >>> print(hinge, [list(map(int, twist)) for twist in hinge.twists()])
    R(actuated) [[0, 0, 1, 0, -1, 0]]
    >>> print(*(f"{kind.symbol} {kind.name}: {', '.join(kind.parts)}" for kind in JOINTS.values()), sep="\n")
    R revolute: point, axis
    P prismatic: direction
    H helical: point, axis, pitch
    C cylindrical: point, axis
    U universal: point, first, second
    S spherical: point
    E planar: point, normal
    Pa parallelogram: bars, axis
    4S parallelogram with ball ends: first, second, bars
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import cached_property
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.screws.fields import Field, Row, field_of
from gcrules.screws.screw import direction, helical_of, prismatic_of, revolute_of

__all__ = ["JOINTS", "Joint", "JointKind", "joint"]

Geometry = Mapping[str, Any]  # parts as they were read: vectors of components, numbers
_Twists = Callable[[Field, Geometry], tuple[Row, ...]]


@dataclass(frozen=True)
class JointKind:
    """`parts` names the geometry and says what each part is: point, direction or number. `freedoms` are the twists in
    words, in their order from the base; `drives` are those that the geometry determines one by one, so that they can
    be actuated.
    """

    symbol: str
    name: str
    parts: Mapping[str, str]
    freedoms: tuple[str, ...]
    drives: tuple[int, ...]
    rows: _Twists

    def twists(self, geometry: Geometry, field: Field) -> tuple[Row, ...]:
        """The twists of a joint of this kind, in the order of `freedoms`. Raises InputError."""
        read: dict[str, Any] = {}
        for part, form in self.parts.items():
            what = f"the {part} of a joint {self.symbol}"
            match form:
                case "number":
                    read[part] = field.number(geometry[part], what)
                case "direction":
                    read[part] = direction(geometry[part], field, what)
                case _:
                    read[part] = field.vector(geometry[part], what)
        field.go_together(read.values(), f"a joint {self.symbol}")
        return self.rows(field, read)

    @property
    def has_bars(self) -> bool:
        """Whether it is made of bars that swing, so that the links within it do not move by its twists."""
        return "bars" in self.parts

    @cached_property
    def slides(self) -> bool:
        """Whether no twist of it turns; seen from parts in general position."""
        general = {p: 1 if f == "number" else (k * k, k, 1) for k, (p, f) in enumerate(self.parts.items(), start=1)}
        return not any(any(row[:3]) for row in self.twists(general, field_of(1)))


def _turn(field: Field, g: Geometry) -> tuple[Row, ...]:
    return (revolute_of(field, g["point"], g["axis"]),)


def _slide(field: Field, g: Geometry) -> tuple[Row, ...]:
    return (prismatic_of(g["direction"]),)


def _helical(field: Field, g: Geometry) -> tuple[Row, ...]:
    return (helical_of(field, g["point"], g["axis"], g["pitch"]),)


def _cylindrical(field: Field, g: Geometry) -> tuple[Row, ...]:
    return revolute_of(field, g["point"], g["axis"]), prismatic_of(g["axis"])


def _universal(field: Field, g: Geometry) -> tuple[Row, ...]:
    if field.are_parallel(g["first"], g["second"]):
        raise InputError("the two axes of a joint U are parallel", hint="write one joint R, or two at different points")
    return revolute_of(field, g["point"], g["first"]), revolute_of(field, g["point"], g["second"])


def _spherical(field: Field, g: Geometry) -> tuple[Row, ...]:
    axes = (field.vector(axis) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1)))
    return tuple(revolute_of(field, g["point"], axis) for axis in axes)


def _planar(field: Field, g: Geometry) -> tuple[Row, ...]:
    one, other = field.normal_pair(g["normal"])
    return prismatic_of(one), prismatic_of(other), revolute_of(field, g["point"], g["normal"])


def _parallelogram(field: Field, g: Geometry) -> tuple[Row, ...]:
    if field.are_parallel(g["bars"], g["axis"]):
        raise InputError("the bars of a joint Pa are parallel to its axes, so that it cannot move")
    return (prismatic_of(field.cross(g["axis"], g["bars"])),)


def _ball_bars(field: Field, g: Geometry) -> tuple[Row, ...]:
    x, y, z = (field.reduced(b - a) for a, b in zip(g["first"], g["second"], strict=True))
    if field.are_zero((x, y, z)):
        raise InputError("the two bars of a joint 4S start at one point")
    if field.are_parallel((x, y, z), g["bars"]):
        raise InputError("the two bars of a joint 4S lie on one line")
    one, other = field.normal_pair(g["bars"])
    turns = (revolute_of(field, g["first"], d) for d in (g["bars"], (x, y, z)))
    return prismatic_of(one), prismatic_of(other), *turns


_TURN, _SLIDE = "turn about the axis", "slide along the axis"
_KINDS: tuple[tuple[str, str, str, tuple[str, ...], tuple[int, ...], _Twists], ...] = (
    # symbol, name, parts, freedoms, drives, twists
    ("R", "revolute", "point: point, axis: direction", (_TURN,), (0,), _turn),
    ("P", "prismatic", "direction: direction", ("slide along the direction",), (0,), _slide),
    ("H", "helical", "point: point, axis: direction, pitch: number", ("screw about the axis",), (0,), _helical),
    ("C", "cylindrical", "point: point, axis: direction", (_TURN, _SLIDE), (0, 1), _cylindrical),
    (
        "U",
        "universal",
        "point: point, first: direction, second: direction",
        ("turn about the first axis", "turn about the second axis"),
        (0, 1),
        _universal,
    ),
    ("S", "spherical", "point: point", tuple(f"turn about {c} through the centre" for c in "xyz"), (), _spherical),
    (
        "E",
        "planar",
        "point: point, normal: direction",
        ("slide in the plane", "another slide in the plane", "turn about the normal through the point"),
        (2,),
        _planar,
    ),
    ("Pa", "parallelogram", "bars: direction, axis: direction", ("slide across the bars",), (0,), _parallelogram),
    (
        "4S",
        "parallelogram with ball ends",
        "first: point, second: point, bars: direction",
        ("slide across the bars", "another slide across the bars", "turn about the first bar", "turn about the side"),
        (),
        _ball_bars,
    ),
)


def _parts(text: str) -> Mapping[str, str]:
    return FrozenMap((part, form) for part, form in (pair.split(": ") for pair in text.split(", ")))


JOINTS: Mapping[str, JointKind] = FrozenMap(
    {
        symbol: JointKind(symbol, name, _parts(parts), freedoms, drives, rows)
        for symbol, name, parts, freedoms, drives, rows in _KINDS
    }
)
"""All kinds of joints by their symbols. 4S is the forearm of a Delta robot: two parallel bars with ball ends, from
`first` and `second`; the turns of the bars about themselves are left out."""


@dataclass(frozen=True)
class Joint:
    """A joint at a configuration. `actuated` are places in `kind.freedoms`; made by `joint`, which checks them."""

    kind: JointKind
    geometry: Mapping[str, Any]
    actuated: tuple[int, ...] = ()

    @property
    def freedoms(self) -> int:
        """How many degrees of freedom it has."""
        return len(self.kind.freedoms)

    @property
    def field(self) -> Field:
        """The field that its numbers belong to: floats if one of them is a float, else fractions."""
        return field_of(*self.geometry.values())

    def twists(self, field: Field | None = None) -> tuple[Row, ...]:
        """Rows (ω; v), one for each freedom. Raises InputError for geometry that makes no joint of this kind."""
        return self.kind.twists(self.geometry, field or self.field)

    def __str__(self) -> str:
        return f"{self.kind.symbol}(actuated)" if self.actuated else self.kind.symbol


def joint(kind: str, *, actuated: bool | int | Iterable[int] = False, **geometry: Any) -> Joint:
    """A joint of a kind of `JOINTS`, with the parts that its kind names.

    `actuated` is True for all freedoms of the joint, or the places of some of them (from 0). Rates are measured in the
    directions as they are given: write unit vectors where they matter. Raises InputError for an unknown kind, missing
    or further parts, zero or infinite ones, and freedoms that cannot be actuated.
    """
    found = JOINTS.get(str(kind))
    if found is None:
        raise InputError(f"{kind!r} is not a kind of joint", hint=f"the kinds are {', '.join(JOINTS)}")
    missing = [part for part in found.parts if part not in geometry]
    if missing:
        raise InputError(f"a joint {kind} needs its {' and its '.join(missing)}")
    further = [part for part in geometry if part not in found.parts]
    if further:
        raise InputError(f"a joint {kind} has no {further[0]}", hint=f"its parts are {', '.join(found.parts)}")
    made = Joint(found, FrozenMap({part: _kept(geometry[part]) for part in found.parts}), _actuated(found, actuated))
    made.twists()
    return made


def _kept(value: Any) -> Any:
    return tuple(map(_kept, value)) if isinstance(value, list | tuple) else value


def _actuated(kind: JointKind, actuated: bool | int | Iterable[int]) -> tuple[int, ...]:
    if actuated is True:
        chosen = tuple(range(len(kind.freedoms)))
    elif actuated is False:
        chosen = ()
    else:
        chosen = tuple(sorted({actuated} if isinstance(actuated, int) else set(actuated)))
    for place in chosen:
        if place not in range(len(kind.freedoms)):
            raise InputError(f"a joint {kind.symbol} has no freedom {place!r}; freedoms are counted from 0")
        if place not in kind.drives:
            raise InputError(
                f"the {kind.freedoms[place]} of a joint {kind.symbol} cannot be actuated by itself",
                hint="write the joint as several of kind R and P",
            )
    return chosen
