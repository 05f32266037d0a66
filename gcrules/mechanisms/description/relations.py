r"""How a point or direction of a robot is made from others: one relation each, so that no equations need be solved.

Each row of the table below says how the relation is written, how a value is made from parameters, and what must vanish
for a given value to satisfy it.

>>> relation("point", "on line A along u")
Relation(kind='on line', args=(((Fraction(1, 1), 'A'),), ((Fraction(1, 1), 'u'),)))
>>> relation("point", "B1 + A2 - A1").names
('B1', 'A2', 'A1')
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any

from gcrules.algebra.language.text import SHORT_NAME
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.screws import Field

__all__ = ["AXES", "RELATIONS", "Relation", "Term", "Values", "combined", "name_of", "pair_or_name", "relation"]

Vector = tuple[Any, Any, Any]
Values = Mapping[str, Vector]
Term = tuple[tuple[Fraction, str], ...]
"""A linear combination of names: (number, name) for each."""

AXES = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}
"""Directions that every robot has: those of the frame."""

Make = Callable[[Field, Sequence[Any], Sequence[Any]], Vector]
Residual = Callable[[Field, Sequence[Any], Vector], Sequence[Any]]


def _plus(field: Field, a: Vector, *parts: tuple[Any, Vector]) -> Vector:
    x, y, z = (field.reduced(a[i] + sum(s * d[i] for s, d in parts)) for i in range(3))
    return x, y, z


def _minus(field: Field, a: Vector, b: Vector) -> Vector:
    return _plus(field, a, (-1, b))


def _triple(field: Field, a: Vector, b: Vector, c: Vector) -> tuple[Any]:
    return (field.dot(field.cross(a, b), c),)


def _mirrored(field: Field, u: Vector, n: Vector) -> Vector:
    """(n · n) u − 2 (u · n) n: u as a mirror perpendicular to n shows it, times n · n, so that nothing is divided."""
    square, part = field.dot(n, n), field.dot(u, n)
    x, y, z = (field.reduced(square * a - 2 * part * b) for a, b in zip(u, n, strict=True))
    return x, y, z


@dataclass(frozen=True)
class RelationForm:
    """One kind of relation: `pattern` with the groups of its arguments (each names a point or a direction, `sorts`),
    how many random parameters it takes, how a value is made and what vanishes for a value that satisfies it.
    """

    words: str
    pattern: re.Pattern[str]
    sorts: tuple[str, ...]
    parameters: int
    make: Make
    residual: Residual


_D = r"([A-Za-z][\w']*(?:\s+[A-Za-z][\w']*)?)"  # a direction, or two points
_P = r"([A-Za-z][\w']*)"


def _form(words: str, pattern: str, sorts: str, parameters: int, make: Make, residual: Residual) -> RelationForm:
    return RelationForm(
        words, re.compile(pattern.replace(" ", r"\s+")), tuple(sorts.split()), parameters, make, residual
    )


_FREE_MAKE: Make = lambda f, a, t: (t[0], t[1], t[2])  # noqa: E731
_FREE: Residual = lambda f, a, own: ()  # noqa: E731

RELATIONS: Mapping[str, Mapping[str, RelationForm]] = {
    "point": {
        "free": _form("free", "free", "", 3, _FREE_MAKE, _FREE),
        "on line": _form(
            "on line A B, on line A along u",
            rf"on line {_P} (?:along )?{_D}",
            "point direction",
            1,
            lambda f, a, t: _plus(f, a[0], (t[0], a[1])),
            lambda f, a, own: f.cross(_minus(f, own, a[0]), a[1]),
        ),
        "in plane": _form(
            "in plane A B C, in plane A along u, v",
            rf"in plane {_P} along {_D}\s*, {_D}",
            "point direction direction",
            2,
            lambda f, a, t: _plus(f, a[0], (t[0], a[1]), (t[1], a[2])),
            lambda f, a, own: _triple(f, _minus(f, own, a[0]), a[1], a[2]),
        ),
        "in plane normal to": _form(
            "in plane A perpendicular to n",
            rf"in plane {_P} (?:perpendicular|normal) to {_D}",
            "point direction",
            3,
            lambda f, a, t: _plus(f, a[0], (1, f.cross(a[1], (t[0], t[1], t[2])))),
            lambda f, a, own: (f.dot(_minus(f, own, a[0]), a[1]),),
        ),
    },
    "direction": {
        "free": _form("free", "free", "", 3, _FREE_MAKE, _FREE),
        "along": _form(
            "along A B, parallel to u",
            rf"(?:along|parallel to) {_D}",
            "direction",
            0,
            lambda f, a, t: a[0],
            lambda f, a, own: f.cross(a[0], own),
        ),
        "perpendicular to both": _form(
            "perpendicular to u, v",
            rf"perpendicular to {_D}\s*, {_D}",
            "direction direction",
            0,
            lambda f, a, t: f.cross(a[0], a[1]),
            lambda f, a, own: f.cross(f.cross(a[0], a[1]), own),
        ),
        "perpendicular to": _form(
            "perpendicular to u",
            rf"perpendicular to {_D}",
            "direction",
            3,
            lambda f, a, t: f.cross(a[0], (t[0], t[1], t[2])),
            lambda f, a, own: (f.dot(a[0], own),),
        ),
        "in span": _form(
            "in span u, v",
            rf"in span {_D}\s*, {_D}",
            "direction direction",
            2,
            lambda f, a, t: _plus(f, (0, 0, 0), (t[0], a[0]), (t[1], a[1])),
            lambda f, a, own: _triple(f, a[0], a[1], own),
        ),
        "mirror": _form(
            "mirror of u in plane perpendicular to n",
            rf"mirror of {_D} in plane (?:perpendicular|normal) to {_D}",
            "direction direction",
            0,
            lambda f, a, t: _mirrored(f, a[0], a[1]),
            lambda f, a, own: f.cross(_mirrored(f, a[0], a[1]), own),
        ),
    },
}

_THREE_POINTS = re.compile(rf"in plane {_P} {_P} {_P}".replace(" ", r"\s+"))
_SUM: Mapping[str, Residual] = {
    "point": lambda f, a, own: _minus(f, own, a[0]),
    "direction": lambda f, a, own: f.cross(own, a[0]),
}
_ADDEND = re.compile(r"\s*([+-])?\s*(\d+(?:/\d+)?)?\s*\*?\s*([A-Za-z][\w']*)\s*")


@dataclass(frozen=True)
class Relation:
    """A relation of a kind of the table (or `sum`, a linear combination) with its arguments."""

    kind: str
    args: tuple[Term, ...] = ()

    @property
    def names(self) -> tuple[str, ...]:
        """All names that it uses."""
        return tuple(dict.fromkeys(name for term in self.args for _, name in term))

    def parameters(self, sort: str) -> int:
        """How many random numbers a value takes."""
        return 0 if self.kind == "sum" else RELATIONS[sort][self.kind].parameters

    def value(self, sort: str, field: Field, values: Values, parameters: Sequence[Any]) -> Vector:
        """The value of the point or direction at a member where the others have these values."""
        args = [combined(term, values, field) for term in self.args]
        return args[0] if self.kind == "sum" else RELATIONS[sort][self.kind].make(field, args, parameters)

    def residual(self, sort: str, field: Field, values: Values, own: Vector) -> tuple[Any, ...]:
        """Zeros if the value satisfies the relation."""
        args = [combined(term, values, field) for term in self.args]
        return tuple(_SUM[sort](field, args, own) if self.kind == "sum" else self._form(sort)(field, args, own))

    def _form(self, sort: str) -> Residual:
        return RELATIONS[sort][self.kind].residual


def name_of(term: Term) -> str:
    """A name, or the two points of a difference in the order in which one goes: AB for B − A."""
    return term[0][1] if len(term) == 1 else "".join(n for _, n in reversed(term))


def combined(term: Term, values: Values, field: Field) -> Vector:
    """The value of a linear combination."""
    if len(term) == 1 and term[0][0] == 1:
        return values[term[0][1]]
    if len(term) == 2:  # mostly from one point to another
        (c, m), (d, n) = term
        a, b, v, w = field.number(c), field.number(d), values[m], values[n]
        sums = [0 + a * v[0] + b * w[0], 0 + a * v[1] + b * w[1], 0 + a * v[2] + b * w[2]]
    else:
        parts = [(field.number(c), values[n]) for c, n in term]
        sums = [sum([c * v[i] for c, v in parts]) for i in range(3)]
    x, y, z = map(field.reduced, sums)
    return x, y, z


def relation(sort: str, text: str) -> Relation:
    """Read the relation of a `point` or `direction`. Raises InputError for what is none."""
    words = text.strip()
    three = _THREE_POINTS.fullmatch(words) if sort == "point" else None
    if three:
        a, b, c = three.groups()
        return Relation("in plane", (_one(a), pair_or_name(f"{a} {b}"), pair_or_name(f"{a} {c}")))
    for kind, form in RELATIONS[sort].items():
        match = form.pattern.fullmatch(words)
        if match and kind == "on line" and len(match[2].split()) == 1 and " along " not in f" {words} ":
            return Relation(kind, (_one(match[1]), pair_or_name(f"{match[1]} {match[2]}")))
        if match:
            read = (
                pair_or_name(g) if s == "direction" else _one(g)
                for g, s in zip(match.groups(), form.sorts, strict=True)
            )
            return Relation(kind, tuple(read))
    return Relation("sum", (_sum(sort, words),))


def _one(name: str) -> Term:
    return ((Fraction(1), name),)


def pair_or_name(text: str) -> Term:
    """A direction by its name, or from one point to another: "u", "A B"."""
    names = text.split()
    return _one(names[0]) if len(names) == 1 else ((Fraction(1), names[1]), (Fraction(-1), names[0]))


def _sum(sort: str, text: str) -> Term:
    found: dict[str, Fraction] = {}
    at = 0
    while at < len(text):
        match = _ADDEND.match(text, at)
        if not match or (at and not match[1]) or not SHORT_NAME.fullmatch(match[3]):
            forms = "; ".join(form.words for form in RELATIONS[sort].values())
            raise InputError(f"{text[:60]!r} is not a relation for a {sort}", hint=f"{forms}; or a sum: B1 + A2 - A1")
        try:
            number = Fraction(match[2] or 1)
        except ZeroDivisionError:
            raise InputError(f"division by zero in {text[:60]!r}") from None
        found[match[3]] = found.get(match[3], Fraction(0)) + (-number if match[1] == "-" else number)
        at = match.end()
    return tuple((c, name) for name, c in found.items())
