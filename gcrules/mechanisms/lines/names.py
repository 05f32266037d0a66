r"""Names of points and directions through which a limb's lines may go, those derived from its own ones among them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import combinations
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.family import Family
from gcrules.mechanisms.description.limb_file import LimbSpec
from gcrules.mechanisms.description.relations import AXES, Term, Values
from gcrules.mechanisms.lines.derived import Derived
from gcrules.screws import RESIDUES, Limb
from gcrules.screws.field import Row

__all__ = [
    "Key",
    "Named",
    "Sample",
    "add_derived",
    "crosswise",
    "directions",
    "free_names",
    "home_sample",
    "key",
    "names_of_limb",
    "names_of_others",
    "sample",
    "samples",
]

_SEEDS = (1, 2, 3)
_COST = {"own": 0, "direction": 1, "axis": 2, "derived": 3, "other": 5, "other direction": 6}
_Z: Term = ((Fraction(1), "z"),)

Named = tuple[str, float, Derived | None]
"""A name, its cost, and what it is derived from, if it is."""

Key = tuple[Row, ...]


@dataclass(frozen=True, eq=False)
class Sample:
    """A member modulo the prime, with the limbs there and derived names, which begin with a colon, added to the
    points.
    """

    values: Values
    limbs: tuple[Limb, ...]
    points: dict[str, Row]

    def row(self, derived: Derived) -> Row:
        """Homogeneous coordinates of a derived name, made from others of which the derived ones were added before."""
        before = {n: (p[0], p[1], p[2]) for n, p in self.points.items() if n.startswith(":")}
        return derived.row({**self.values, **before}, RESIDUES)


def sample(family: Family, limbs: Sequence[LimbSpec], values: Values) -> Sample:
    """The limbs at a member, modulo the prime."""
    return Sample(values, tuple(limb.at(values, RESIDUES) for limb in limbs), family.homogeneous(values))


def samples(family: Family, limbs: Sequence[LimbSpec]) -> tuple[Sample, ...]:
    """The members on which lines are tested."""
    return tuple(sample(family, limbs, family.member(seed)) for seed in _SEEDS)


def home_sample(family: Family, limbs: Sequence[LimbSpec], home: Mapping[str, Any] | None) -> Sample | None:
    """Home, modulo the prime; None without one, and where a joint of it is none there."""
    if home is None:
        return None
    try:
        return sample(family, limbs, {n: RESIDUES.vector(v) for n, v in home.items()})
    except InputError:
        return None


def key(rows: Iterable[Row]) -> Key:
    """A direction at all members, the same for all multiples of it."""
    return tuple(RESIDUES.simplest(row) for row in rows)


def directions(family: Family, at: Sequence[Sample]) -> Mapping[Key, str]:
    """One name for each direction: an axis of the frame, else the first that is parallel to it in the whole family."""
    found: dict[Key, str] = {}
    for name, sort in family.sorts.items():
        if sort == "direction":
            found.setdefault(key(s.values[name] for s in at), name)
    return found


def names_of_limb(family: Family, limb: LimbSpec, at: Sequence[Sample], one: Mapping[Key, str]) -> list[Named]:
    """Points and directions of the limb, each with a cost; with directions derived from two of its joints."""
    own = dict.fromkeys((*(p for j in limb.joints for p in j.points), *limb.through))
    terms = _terms(limb)
    own.update(dict.fromkeys(n for term in terms if len(term) > 1 for _, n in reversed(term)))
    single = [term[0][1] for term in terms if len(term) == 1 and term[0][0] == 1]
    own_directions = dict.fromkeys(one[key(s.values[n] for s in at)] for n in single)
    found: list[Named] = [(n, _COST["own"], None) for n in own]
    found += [(n, _COST["direction"], None) for n in own_directions]
    if family.plane:
        found = [n for n in found if n[0] != "z"]
        return found + _derived(((_Z, t) for t in terms), at, one)
    found += [(n, _COST["axis"], None) for n in AXES if n not in own_directions]
    return found + _derived(combinations(terms, 2), at, one)


def names_of_others(family: Family, own: Sequence[Named], one: Mapping[Key, str]) -> list[Named]:
    """Points and directions of the rest of the robot."""
    known = {n for n, _, _ in own} | ({"z"} if family.plane else set())
    names = {n for n, sort in family.sorts.items() if sort == "point"} | set(one.values())
    rest = [(n, sort) for n, sort in family.sorts.items() if n in names - known]
    return [(n, _COST["other" if sort == "point" else "other direction"], None) for n, sort in rest]


def _terms(limb: LimbSpec) -> list[Term]:
    """The directions of its joints."""
    return list(dict.fromkeys(d for j in limb.joints for d in j.directions))


def _derived(
    pairs: Iterable[tuple[Term, Term]], at: Sequence[Sample], one: Mapping[Key, str], start: int = 0
) -> list[Named]:
    """Directions u × v that are none of the robot's own, with names that no point bears, numbered from `start`."""
    found: list[Named] = []
    for u, v in pairs:
        made = Derived(f":{start + len(found)}", (u, v))
        rows = [s.row(made) for s in at]
        if all(map(any, rows)) and key(row[:3] for row in rows) not in one:
            found.append((made.name, _COST["derived"], made))
    return found


def add_derived(derived: Iterable[Derived], at: Sequence[Sample]) -> None:
    """Add derived names, in their order, to the points of the samples."""
    for one in derived:
        for s in at:
            s.points[one.name] = s.row(one)


def free_names(family: Family, stem: str) -> Iterator[str]:
    """n1, n1', n1'' … for the stem n1, as far as they are free."""
    name = stem
    while True:
        if name not in family.sorts:
            yield name
        name += "'"


def crosswise(limb: LimbSpec, derived: Sequence[Derived], at: Sequence[Sample], one: Mapping[Key, str]) -> list[Named]:
    """Directions u × (u' × v) of the limb's own and its derived ones."""
    pairs = ((t, ((Fraction(1), d.name),)) for t in _terms(limb) for d in derived)
    return _derived(pairs, at, one, len(derived))
