r"""Three forces and three couples: directions of forces and axes of couples, each three times dependent.

A couple is a line at infinity. Let π be the plane at infinity. Three lines f, g, h are parallel to one plane just where
((π ∧ f) ∨ g) ∧ h lies at infinity, and the common point c of two couples lies on the third, l, just where c ∨ l is no
plane. In the superbracket both are one product, (c ∨ l) ∧ ((π ∧ f) ∨ g) ∧ h, where π is the join of three of the points
at infinity. Where no two couples share a point, a cofactor keeps π a plane. Derived here.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations

from gcrules.algebra import expr as ex
from gcrules.algebra.certificate import Certificate
from gcrules.algebra.expr import ONE, Expr, Point
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.scalars import bracket
from gcrules.rules.condition import Condition
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.rule import StructureRule
from gcrules.rules.sentences import sentence

__all__ = ["COUPLES", "FORCES_AND_COUPLES", "forces_and_couples"]

COUPLES = "forces-and-couples"

_TESTED = Certificate("random-points", "holds at exact random points")


def forces_and_couples(structure: Structure, oracle: RandomWitness) -> list[Condition]:
    """The condition, not yet proved, of a structure in rank 4 with three lines at infinity and three others."""
    place = structure.names.index
    legs = sorted(structure.neutral, key=lambda leg: [place(n) for n in leg])
    lines = [ex.join(*map(Point, leg)) for leg in legs]
    far = [line for line in lines if oracle.at_infinity(line)]
    near = [line for line in lines if line not in far]
    if len(far) != 3 or len(near) != 3:
        return []
    for cofactor, plane, common in _planes(far, near, oracle):
        for f, g, h in permutations(near):
            e = ex.meet(common, ex.join(ex.meet(plane, f), g), h)
            coefficient = oracle.coefficient(e, cofactor)
            if coefficient is not None:
                meaning = sentence(e, structure, oracle, cofactor)
                return [Condition(COUPLES, e, meaning, _TESTED, cofactor, coefficient)]
    return []


def _planes(far: list[Expr], near: list[Expr], oracle: RandomWitness) -> Iterator[tuple[Expr, Expr, Expr]]:
    """A cofactor, three points at infinity joined, and (the common point of two couples) ∨ (the third)."""
    for one, two, three in permutations(far):
        shared = [p for p in one.children if p in two.children]
        if len(shared) == 1:
            (own,) = (p for p in two.children if p not in shared)
            if shared[0] not in three.children:
                yield ONE, ex.join(one, own), ex.join(*shared, three)
    for one, two, three in permutations(far):
        for new in two.children:
            for finite in (p for line in near for p in line.children if not oracle.at_infinity(p)):
                if new not in one.children:
                    common = ex.join(ex.meet(ex.join(one, finite), two), three)
                    yield bracket(one, new, finite), ex.join(one, new), common


FORCES_AND_COUPLES = StructureRule(
    id=COUPLES,
    sentence="Three lines at infinity and three other lines: the directions of the lines and the axes of the couples.",
    fires=("Aa Bb Cc ij jk ki ideal i j k",),
    silent=("Aa Bb Cc Dd ij jk ideal i j k", "ab af cb cd ed ef"),
    find=forces_and_couples,
)
