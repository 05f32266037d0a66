"""Robots as their files describe them: limbs of joints over a family of points and directions, as frozen values."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import field
from fractions import Fraction
from os import PathLike
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.deferred import resolved
from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.description.family import Definition, Family
from gcrules.mechanisms.description.limb_file import LimbSpec
from gcrules.mechanisms.description.relations import AXES
from gcrules.mechanisms.lines.derived import Derived
from gcrules.screws import RATIONALS, Limb

__all__ = ["Consequence", "Robot", "read_models_by"]

_TOLERANCE = Fraction(1, 10**6)
_reader = ""

Vector = tuple[Fraction, Fraction, Fraction]


def read_models_by(where: str) -> None:
    """Let the function `package.module:name` read the models of `Robot.from_model`; it stands above robots."""
    global _reader
    _reader = where


@dataclass(frozen=True)
class Consequence:
    """What the file says follows from the relations, as a relation of a name, and as written."""

    relation: Definition
    text: str


@dataclass(frozen=True, repr=False)
class Robot:
    """A robot as its file describes it.

    `family` holds the points and directions with the relations that make them, `limbs` the joints; `lines` are
    given in place of limbs where wrenches are known already, with the points `derived` for those that are meets of
    planes. `mobility` is that expected of the platform (checked), `home` one configuration (empty for names that
    the relations determine), `limits` what its actuators reach from there, as written, `drawing` a configuration that
    shows more clearly how the robot is made, `units` that of lengths ("" if the file names none), `condition` a
    published one in the language. `text` is that of the file.
    """

    id: str
    title: str
    family: Family
    limbs: tuple[LimbSpec, ...]
    mobility: int
    lines: tuple[tuple[str, str], ...] = ()
    platform: tuple[str, ...] = ()
    home: Mapping[str, Vector] | None = None
    condition: str = ""
    source: str = ""
    note: str = ""
    facts: tuple[Consequence, ...] = ()
    filename: str = "<input>"
    owner: str = ""
    derived: tuple[Derived, ...] = ()
    limits: str = ""
    units: str = ""
    drawing: Mapping[str, Vector] | None = None
    text: str = field(default="", compare=False)

    def __post_init__(self) -> None:
        for name in ("home", "drawing"):
            if (places := getattr(self, name)) is not None:
                object.__setattr__(self, name, FrozenMap(places))

    @classmethod
    def from_model(
        cls,
        path: str | PathLike[str],
        closures: str | PathLike[str] | None = None,
        *,
        base: str | None = None,
        platform: str | None = None,
        actuators: Iterable[str] = (),
        tolerance: float = 1e-4,
    ) -> Robot:
        """The robot that a model file shows (URDF with a file of closures, SDF, MJCF); its `text` is a robot file.

        `base` and `platform` are links, by default the model's base and the link with most limbs; `actuators` joints,
        by default those that the model drives. Axes and centres that nearly coincide, meet, or are parallel or
        perpendicular are made so, within the `tolerance` (parts of the model's size, radians). Lengths are metres.
        Raises FileError for a file at fault, for what is no platform with limbs, and for joints that have no meaning.
        """
        found: Robot = resolved(_reader)(
            path, closures, base=base, platform=platform, actuators=actuators, tolerance=tolerance
        )
        return found

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.id}: {self.chain or 'given by its lines'}, mobility {self.mobility}>"

    @property
    def redundant(self) -> int:
        """The number of actuators beyond the freedoms. Where there are such, no determinant of all wrenches is left
        whose sign changes: it takes two conditions, as a rule, for them to lose rank.
        """
        return max(0, sum(limb.actuators for limb in self.limbs) - self.mobility)

    @property
    def chain(self) -> str:
        """The limbs' joints in short: 3-UP*S, 2-UP*R + SP*R."""
        counts: dict[str, int] = {}
        for limb in self.limbs:
            counts[limb.chain] = counts.get(limb.chain, 0) + 1
        return " + ".join(f"{n}-{chain}" if n > 1 else chain for chain, n in counts.items())

    def values_at(self, coordinates: Mapping[str, Any] | None = None) -> dict[str, Any]:
        """Coordinates of all points and directions, as fractions: those given (at home if None), and from them those
        that the relations determine. Whether the relations hold is not looked at.

        Raises InputError, naming what has no coordinates.
        """
        given = (self.home or {}) if coordinates is None else coordinates
        where = "home" if coordinates is None else "the configuration"
        values: dict[str, Any] = {n: RATIONALS.vector(axis) for n, axis in AXES.items()}
        for d in self.family.definitions:
            own = given.get(d.name)
            if own is None and d.parameters:
                raise InputError(f"{where} gives no coordinates for {d.name}, which the relations leave free")
            made = d.relation.value(d.sort, RATIONALS, values, ()) if own is None else own
            values[d.name] = RATIONALS.vector([Fraction(c) if isinstance(c, float) else c for c in made])
        return values

    def limbs_at(self, coordinates: Mapping[str, Any] | None = None) -> tuple[Limb, ...]:
        """The limbs in any configuration, as values of `gcrules.screws`: their Jacobian is `screws.jacobian(limbs)`.

        `coordinates` holds three numbers for each point and direction that the relations leave free (those at home if
        None). Raises InputError for coordinates that are missing or that violate a relation by more than 1e-6.
        """
        values = self.values_at(coordinates)
        for d in self.family.definitions:
            if self.violates(d, values):
                raise InputError(
                    f"the coordinates of {d.name} violate its relation: {d.text}",
                    hint="leave out what the relations determine, or change its coordinates",
                )
        return tuple(limb.at(values, RATIONALS) for limb in self.limbs)

    def violates(self, d: Definition, values: Mapping[str, Any]) -> bool:
        """Whether values violate the relation of a name by more than 1e-6 of their size."""
        size = max((abs(c) for v in values.values() for c in v), default=Fraction(1)) or Fraction(1)
        limit = _TOLERANCE * size**3
        return any(abs(r) > limit for r in d.relation.residual(d.sort, RATIONALS, values, values[d.name]))
