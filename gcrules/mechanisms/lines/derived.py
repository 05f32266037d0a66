r"""Directions and points that a robot's file does not name, made from those that it does, for lines to go through.

>>> from gcrules.mechanisms.description.relations import pair_or_name
>>> from gcrules.screws import RATIONALS
>>> u, v, w = map(pair_or_name, ("u", "v", "w"))
>>> normal, place = Derived("n", (u, v)), Derived("p", (pair_or_name("A"), w, pair_or_name("B"), pair_or_name("n")))
>>> at = {"u": (1, 0, 0), "v": (0, 1, 0), "w": (1, 0, 2), "A": (5, 5, 0), "B": (0, 0, 4)}
>>> rows = with_derived((normal, place), at, RATIONALS)
>>> [list(map(int, rows[name])) for name in ("n", "p")]
[[0, 0, 1, 0], [14, 10, 8, 2]]
>>> in_words((normal, place), "p")
'the point of the line through A along w in the plane through B along u and v'
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from fractions import Fraction

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.description.relations import Term, Values, Vector, combined, name_of
from gcrules.screws import Field
from gcrules.screws.field import Row

__all__ = ["Derived", "in_words", "needed", "with_derived"]


@dataclass(frozen=True)
class Derived:
    """The direction u × v of two `args`; of four, (P, u, Q, n), the point in which the line through P along u meets the
    plane through Q perpendicular to n. They may name derived directions before it.
    """

    name: str
    args: tuple[Term, ...]

    @property
    def is_point(self) -> bool:
        """Whether it is a point, which may lie at infinity, and no direction."""
        return len(self.args) > 2

    @property
    def names(self) -> tuple[str, ...]:
        """All names that it is made from."""
        return tuple(dict.fromkeys(n for term in self.args for _, n in term))

    def renamed(self, new: Mapping[str, str]) -> Derived:
        """With other names for derived ones."""
        args = tuple(tuple((c, new.get(n, n)) for c, n in term) for term in self.args)
        return Derived(new.get(self.name, self.name), args)

    def row(self, values: Values, field: Field) -> Row:
        """Its homogeneous coordinates (x, y, z, w), polynomials in those of the names that it is made from."""
        vectors = [combined(term, values, field) for term in self.args]
        if not self.is_point:
            return (*field.cross(*vectors), field.number(0))
        p, u, q, n = vectors
        below, above = field.dot(n, u), field.dot(n, tuple(b - a for a, b in zip(p, q, strict=True)))
        return tuple(field.reduced(x) for x in (*(a * below + d * above for a, d in zip(p, u, strict=True)), below))


def with_derived(derived: Iterable[Derived], values: Values, field: Field) -> dict[str, Row]:
    """Homogeneous coordinates of derived names at a member, in their order. With floats each coordinate may be an array
    for many members.
    """
    known: dict[str, Vector] = dict(values)
    rows: dict[str, Row] = {}
    for d in derived:
        rows[d.name] = row = d.row(known, field)
        if not d.is_point:
            known[d.name] = (row[0], row[1], row[2])
    return rows


def needed(derived: Iterable[Derived], names: Collection[str]) -> tuple[Derived, ...]:
    """Those of these names, and those that they are made from, in order."""
    every, wanted = tuple(derived), set(names)
    for d in reversed(every):
        if d.name in wanted:
            wanted.update(d.names)
    return tuple(d for d in every if d.name in wanted)


def _multiple(number: Fraction, name: str) -> str:
    size = abs(number)
    return f" {'−' if number < 0 else '+'} {'' if size == 1 else f'{size} '}{name}"


def in_words(derived: Iterable[Derived], name: str) -> str:
    """What a derived name is, in names of the file: "the direction u × v"."""
    known = {d.name: d for d in derived}

    def term(t: Term) -> str:
        if not any(n in known for _, n in t):
            return name_of(t)
        parts = "".join(_multiple(c, product(known[n]) if n in known else n) for c, n in t)
        return f"({parts.removeprefix(' + ').strip()})"

    def product(d: Derived) -> str:
        return " × ".join(map(term, d.args))

    one = known[name]
    if not one.is_point:
        return f"the direction {product(one)}"
    p, u, q, n = one.args
    normal = known.get(n[0][1]) if len(n) == 1 else None
    plane = f"along {' and '.join(map(term, normal.args))}" if normal else f"perpendicular to {name_of(n)}"
    line = f"line through {name_of(p)} along {term(u)}" if len(u) == 1 else f"line {name_of(u)}"
    return f"the point of the {line} in the plane through {name_of(q)} {plane}"
