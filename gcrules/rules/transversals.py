r"""The transversal condition of six legs, found from their incidences.

Without two of the legs, g and h, the platform can turn about the two lines p and q that meet the other four. Each of g
and h allows these turns in one ratio only; the robot is singular where the ratios agree:

    cofactor · superbracket = c · tetrahedra · ((p ∧ g)(q ∧ h) − (p ∧ h)(q ∧ g)).

Every choice of g and h is tried. p and q are rational in the joints where two of the other legs share one.

>>> from gcrules.algebra.language.legs_text import read_legs
>>> structure = read_legs("Aa Ab Ba Cc Dd Ee")
>>> best = find(structure, RandomWitness(structure))[0]
>>> print(best.cofactor, "|", *(line for _, line in best.lines))
[ACac] | ABa /\ ACc Aab /\ Cac
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.language.text import text
from gcrules.core.budget import checkpoint
from gcrules.rules.common_lines import FourLegs
from gcrules.rules.condition import Condition
from gcrules.rules.line_cofactors import balance
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.rule import StructureRule
from gcrules.rules.two_transversals import KIND, TransversalCondition, reading_of, written_into

__all__ = ["TRANSVERSALS", "find", "readings"]


def find(structure: Structure, oracle: RandomWitness) -> list[Condition]:
    """All transversal conditions, as `readings` orders them."""
    return [reading.condition for reading in readings(structure, oracle)]


def readings(structure: Structure, oracle: RandomWitness) -> list[TransversalCondition]:
    """All transversal conditions, not yet proved: those with the smallest cofactor first, then those with the fewest
    operations, then those whose lines p and q are alike.

    None where the robot is always singular, where no two legs share a joint, and outside rank 4.
    """
    found: dict[tuple[str, str], TransversalCondition] = {}
    for r in _of_lines(structure, oracle) if structure.stand_ins else _of_joints(structure, oracle):
        found.setdefault((str(r.condition.expression), str(r.condition.cofactor)), r)
    return sorted(found.values(), key=lambda r: _key(r.condition, structure.names))


def _key(condition: Condition, names: tuple[str, ...]) -> tuple[int, int, int, str]:
    p, q = (line for _, line in condition.lines)
    shown = text(condition.expression, names=names)
    return _letters(condition.cofactor), _operations(condition), _shape(p) != _shape(q), shown


def _letters(e: Expr) -> int:
    return sum(isinstance(part, ex.Point) for part in ex.subexpressions(e))


def _operations(condition: Condition) -> int:
    """Joins, meets and products of two on both sides, and the sum."""
    sides = (condition.expression, condition.cofactor)
    return sum(len(part.children) - 1 for e in sides for part in ex.subexpressions(e) if part.children)


def _shape(e: Expr) -> str:
    """The expression with all points alike."""
    return "." if not e.children else f"{type(e).__name__}({' '.join(map(_shape, e.children))})"


def _of_lines(structure: Structure, oracle: RandomWitness) -> Iterator[TransversalCondition]:
    """Those of general lines in the place of legs that are lines built from points, with these written back."""
    for r in readings(structure.lifted, RandomWitness(structure.lifted)):
        found = written_into(r, structure, oracle)
        if found is not None:
            yield found


def _of_joints(structure: Structure, oracle: RandomWitness) -> Iterator[TransversalCondition]:
    names = structure.names
    legs = sorted(structure.neutral, key=lambda leg: [names.index(n) for n in leg])
    if structure.rank != 4 or oracle.zero(structure.superbracket):
        return
    for single in combinations(legs, 2):
        checkpoint()
        four = FourLegs(tuple(leg for leg in legs if leg not in single), names, structure.ideal)
        for p, q in combinations(four.lines, 2):
            factors = balance(four, p, q)
            reading = factors and reading_of(structure, single, (p, q), factors, oracle)
            if reading:
                yield reading


TRANSVERSALS = StructureRule(
    id=KIND,
    sentence="Two lines p and q that meet four legs, and legs g, h: (p ∧ g)(q ∧ h) − (p ∧ h)(q ∧ g), with a cofactor.",
    fires=("Aa Ab Ba Cc Dd Ee", "Aa Ab Bc Cd De Ef", "ab bc ca de fg hi"),
    silent=("Aa Bb Cc Dd Ee Ff", "Aa Ba Ca Db Eb Fb"),
    find=find,
    last_resort=True,
)
