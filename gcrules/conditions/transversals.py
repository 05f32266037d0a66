r"""The transversal conditions of six legs as one value that shows itself.

>>> print(transversals("Aa Ab Bc Bd Ce Df").condition.expression)
(AB /\ Ce)(Aab /\ Bcd /\ Df) - (AB /\ Df)(Aab /\ Bcd /\ Ce)
>>> print(transversals("Aa Bb Cc Dd Ee Ff").text())
none: no two legs share a joint, and the two lines that meet four such legs require a square root
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

from gcrules.algebra.language.legs_text import Structure, read_legs
from gcrules.algebra.language.text import Names, text
from gcrules.algebra.plain_letters import in_plain_letters, names_in
from gcrules.core.dataclass import dataclass
from gcrules.core.english import listed
from gcrules.core.shown import Shown
from gcrules.rules.claims import certify, in_special_position
from gcrules.rules.condition import Condition
from gcrules.rules.degenerate import explain
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.transversals import readings
from gcrules.rules.two_transversals import TransversalCondition

__all__ = ["Transversals", "transversals"]


@dataclass(frozen=True)
class Transversals(Shown):
    """Conditions cofactor · superbracket = coefficient · expression that compare the turns about two lines p and q.

    `readings` holds them with their legs g, h and lines p, q, each proved, the simplest first; `more` counts those that
    were found but not asked for. Where there are none, `reason` says why; `definite` tells that there can be none.
    """

    structure: Structure
    readings: tuple[TransversalCondition, ...]
    more: int = 0
    reason: str = ""
    definite: bool = True

    @property
    def exists(self) -> bool:
        """Whether there is a condition."""
        return bool(self.readings)

    @property
    def condition(self) -> Condition | None:
        """The simplest condition."""
        return self.readings[0].condition if self.readings else None

    def to_json(self) -> dict[str, Any]:
        """`{legs, readings, more, reason, assumed}`; each reading is a condition with `single` (g, h) and `lines`
        (p, q). Where legs are letters, `letters` says what points they join.
        """
        names = self.structure.names
        found = {
            "legs": [list(leg) for leg in self.structure.legs],
            "readings": [_reading(r, names) for r in self.readings],
            "more": self.more,
            "reason": self.reason or None,
            "assumed": [e for e, _ in self.structure.assumed],
        }
        return in_plain_letters(found, names_in(self.structure))


def _reading(r: TransversalCondition, names: tuple[str, ...]) -> dict[str, Any]:
    lines = {
        name: {"expression": text(line.expression, names=names), "words": line.words}
        for name, line in zip("pq", r.lines, strict=True)
    }
    return {**r.condition.to_json(names), "single": [list(leg) for leg in r.single], "lines": lines}


def transversals(
    legs: str | Iterable[str | Sequence[str]] | Structure,
    *,
    every: bool = False,
    points: Names = (),
    ideal: Names = (),
    given: str | Iterable[str] = (),
    letters: str = "",
) -> Transversals:
    """The condition of six legs that compares the turns about two lines p and q, found from their common joints alone.

    p and q meet four of the legs; g and h are the other two. The reading with the smallest cofactor is given, then the
    one with the fewest operations; with `every` all of them, each proved by normal forms. Legs, `points`, `ideal`,
    `given` and `letters` are as `analyze` takes them. Raises InputError for anything but six lines of space.

    Source: derived here.
    """
    if isinstance(legs, Structure):
        structure = legs
    else:
        structure = read_legs(legs, points=points, ideal=ideal, given=given, letters=letters, built=True)
    found = readings(structure, oracle := RandomWitness(structure))
    if not found:
        reason, definite = _reason(structure, oracle)
        return Transversals(structure, (), reason=reason, definite=definite)
    shown = found if every else found[:1]
    proved = tuple(
        replace(r, condition=in_special_position(certify(r.condition, structure), structure, oracle)) for r in shown
    )
    return Transversals(structure, proved, len(found) - len(shown))


def _reason(structure: Structure, oracle: RandomWitness) -> tuple[str, bool]:
    """Why there is no reading, and whether there can be none."""
    if oracle.zero(structure.superbracket):
        return f"the robot is singular in every pose: {explain(structure).reason}", True
    if structure.rank != 4:
        return "lines that meet four others are sought in space only, rank 4", True
    shared = [n for n in structure.names if sum(n in leg for leg in structure.legs) > 1]
    if not shared:
        if structure.special or structure.stand_ins:
            return "no two legs share a joint, and legs that meet elsewhere are not looked at", False
        return "no two legs share a joint, and the two lines that meet four such legs require a square root", True
    return f"no lines constructed from the legs with the common joints {listed(shared)} give a condition", False
