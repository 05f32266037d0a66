r"""Lines that are given as the meet of two planes, `A1B1C1 /\ A2B2C2`, as two points that are derived from them.

One plane meets the sides of the other's triangle in points of the line; where the planes share a point that one is
taken. Which of them differ is seen at a random member.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from fractions import Fraction
from itertools import combinations

from gcrules.algebra.language.text import SHORT_NAME
from gcrules.core.errors import InputError
from gcrules.core.hints import near
from gcrules.mechanisms.description.family import Family
from gcrules.mechanisms.description.point_pairs import MEET
from gcrules.mechanisms.description.relations import Term
from gcrules.mechanisms.lines.derived import Derived, with_derived
from gcrules.screws import RESIDUES
from gcrules.screws.field import Row

__all__ = ["line_of_planes"]

_EXAMPLE = r"write A1B1C1 /\ A2B2C2, or A1 B1 C1 /\ A2 B2 C2"


def line_of_planes(
    text: str, family: Family, taken: Collection[str] = ()
) -> tuple[tuple[str, str], tuple[Derived, ...]]:
    """Two points of the line, with what is derived for them; `taken` are names of others. Raises InputError."""
    sides = MEET.split(text)
    if len(sides) != 2:
        raise InputError(f"{text.strip()[:40]!r} is not a meet of two planes", hint=_EXAMPLE)
    first, second = (_plane(side, family) for side in sides)
    used = {*family.sorts, *taken}
    member = family.member("planes")
    rows: dict[str, Row] = dict(family.homogeneous(member))
    if RESIDUES.rank([rows[n] for n in (*first, *second)]) < 4:
        raise InputError(f"{text.strip()[:40]} is not a line: its planes coincide", hint="name two different planes")
    base, one, other = second
    normal = Derived(_fresh("n", used), (_towards(base, one, family), _towards(base, other, family)))
    found = [Derived(n, ()) for n in first if n in second]  # as they are
    for a, b in combinations(first, 2):
        if family.sorts[a] == "point":
            plane = ((Fraction(1), base),), ((Fraction(1), normal.name),)
            found.append(Derived(f":{a}{b}", (((Fraction(1), a),), _towards(a, b, family), *plane)))
    rows |= with_derived([normal, *(d for d in found if d.args)], member, RESIDUES)
    for pair in combinations(found, 2):
        if RESIDUES.rank([rows[d.name] for d in pair]) == 2:
            named = [Derived(_fresh("p", used), d.args) if d.args else d for d in pair]
            own = tuple(d for d in named if d.args)
            return (named[0].name, named[1].name), ((normal, *own) if own else ())
    raise InputError(f"{text.strip()[:40]} names no line", hint=_EXAMPLE)


def _fresh(letter: str, used: set[str]) -> str:
    name = next(f"{letter}{k}" for k in range(1, len(used) + 2) if f"{letter}{k}" not in used)
    used.add(name)
    return name


def _plane(text: str, family: Family) -> tuple[str, str, str]:
    """The three names of a plane, a point first."""
    words = text.replace(",", " ").split()
    names: Sequence[str] = words if len(words) > 1 else SHORT_NAME.findall(text)
    for name in names:
        if name not in family.sorts:
            raise InputError(f"{name[:20]} is not defined", hint=near(name, family.sorts))
    if len(names) != 3 or len(set(names)) < 3:
        raise InputError(f"{text.strip()[:40]!r} does not name a plane by three points or directions", hint=_EXAMPLE)
    a, b, c = sorted(names, key=lambda n: family.sorts[n] != "point")
    if family.sorts[a] != "point":
        raise InputError(f"the plane {text.strip()[:40]} has no point", hint="at least one of the three is a point")
    return a, b, c


def _towards(point: str, other: str, family: Family) -> Term:
    one = (Fraction(1), other)
    return (one,) if family.sorts[other] == "direction" else (one, (Fraction(-1), point))
