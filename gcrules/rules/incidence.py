r"""Rules that turn entities into an incidence and check it against the superbracket.

A rule yields claims superbracket = coefficient · expression. A claim is tested on the exact oracle as soon as it is
made; the one that is chosen is then proved by normal forms, so a wrong guess can never become an answer.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import Row
from gcrules.algebra.evaluate import PRIME, Evaluator, random_points
from gcrules.algebra.expr import Expr, Meet, Point, join, meet
from gcrules.algebra.shortest import SuperbracketForm
from gcrules.legs import Leg, Structure
from gcrules.rules.entities import left_over_lines, lines, planes, tetrahedra
from gcrules.rules.state import State, extensor

__all__ = ["MAX_TERMS", "Claim", "Oracle", "claims"]

MAX_TERMS = 8
_MOST = 1 << 30
_ONE = ex.Number(1)


@dataclass(frozen=True)
class Claim:
    """superbracket = coefficient · expression, with the entities that the expression is made of."""

    kind: str
    state: State
    expression: Expr
    coefficient: int
    pencils: tuple[Expr, Expr] | None = None
    """For transversal readings the lines p and q about which the platform could turn."""
    single: tuple[Leg, Leg] | None = None
    """The two lines g and h that allow these turns in one ratio only."""


class Oracle:
    """Exact random points of one structure, for testing claims about its superbracket quickly."""

    def __init__(self, structure: Structure) -> None:
        names, ideal = structure.names, structure.ideal
        self._at = [Evaluator(random_points(names, ideal=ideal, seed=n), 4, PRIME) for n in (1, 2)]
        self._superbracket = [at.value(structure.superbracket)[0] for at in self._at]

    def zero(self, e: Expr) -> bool:
        """Whether an expression vanishes at the points."""
        return not any(any(at.value(e)) for at in self._at)

    def coefficient(self, e: Expr, cofactor: Expr = _ONE) -> int | None:
        """The integer c with cofactor · superbracket = c · e at all points, or None; c is below 2³⁰ in size."""
        pairs = [
            (at.value(cofactor)[0] * value % PRIME, at.value(e)[0])
            for at, value in zip(self._at, self._superbracket, strict=True)
        ]
        left, right = pairs[0]
        if not left or not right:
            return None
        c = left * pow(right, -1, PRIME) % PRIME
        c = c - PRIME if c > PRIME // 2 else c
        holds = abs(c) < _MOST and not any((left - c * right) % PRIME for left, right in pairs)
        return c if holds else None


def claims(forms: Sequence[SuperbracketForm], structure: Structure, oracle: Oracle) -> list[Claim]:
    """All claims that hold for the first kind of incidence that any of the given bracket forms shows.

    Most tetrahedra come first; without tetrahedra four planes come before transversals.
    """
    states = [s for form in forms if len((s := tetrahedra(State.start(form))).rest) <= MAX_TERMS]
    for degree, rule in _RULES:
        found = []
        for state in states:
            if state.degree == degree:
                for kind, reached, expression, pencils, single in rule(state):
                    coefficient = oracle.coefficient(expression)
                    if coefficient == -1 and kind == "four-planes":
                        expression, coefficient = _last_two_exchanged(expression), 1
                    if coefficient is not None:
                        found.append(Claim(kind, reached, expression, coefficient, pencils, single))
        if found:
            return found
    return []


def _last_two_exchanged(e: Expr) -> Expr:
    """A meet of four planes with the opposite sign."""
    assert isinstance(e, Meet)
    return meet(*e.args[:2], e.args[3], e.args[2])


_Found = tuple[str, State, Expr, tuple[Expr, Expr] | None, tuple[Leg, Leg] | None]


def _with_tetrahedra(state: State, e: Expr) -> Expr:
    return ex.mul(*(ex.bracket(*map(Point, state.named(row))) for row in state.tetrahedra), e)


def _flat_tetrahedra(state: State) -> Iterator[_Found]:
    """Three common brackets: the superbracket is their product."""
    yield "three-tetrahedra", state, _with_tetrahedra(state, ex.Number(1)), None, None


def _planes_and_line(state: State) -> Iterator[_Found]:
    """Two planes, and the two left-over points as a line: X ∧ Y ∧ xy."""
    for found in planes(state, 2):
        x, y = found.left
        if x != y:
            parts = [extensor(found.named(row)) for row in (*found.planes, (x, y))]
            yield "tetrahedron-planes-line", found, _with_tetrahedra(state, meet(*parts)), None, None


def _four_lines(state: State) -> Iterator[_Found]:
    """Two lines p, q, and the left-over points as lines g, h: (p ∧ g)(q ∧ h) − (p ∧ h)(q ∧ g)."""
    for found in lines(state, 2):
        p, q = (extensor(found.named(row)) for row in found.lines)
        for g, h in left_over_lines(found):
            e = _with_tetrahedra(state, _ratio(p, q, found, g, h))
            yield "tetrahedron-four-lines", found, e, (p, q), (_leg(found, g), _leg(found, h))


def _four_planes(state: State) -> Iterator[_Found]:
    """Three planes, and the three left-over points as the fourth: X ∧ Y ∧ Z ∧ xyz."""
    for found in planes(state, 3):
        if len(set(found.left)) == 3:
            parts = sorted((extensor(found.named(row)) for row in (*found.planes, found.left)), key=str)
            yield "four-planes", found, meet(*parts), None, None


def _planes_and_three_lines(state: State) -> Iterator[_Found]:
    """Two planes with common line q, a line p, and the left-over points as lines g, h."""
    for with_planes in planes(state, 2):
        for found in lines(with_planes, 1):
            q = meet(*(extensor(found.named(row)) for row in found.planes))
            p = extensor(found.named(found.lines[0]))
            for g, h in left_over_lines(found):
                e = _ratio(p, q, found, g, h)
                yield "two-planes-three-lines", found, e, (p, q), (_leg(found, g), _leg(found, h))


def _leg(state: State, row: Row) -> Leg:
    a, b = state.named(row)
    return a, b


def _ratio(p: Expr, q: Expr, state: State, g: Row, h: Row) -> Expr:
    a, b = (join(*map(Point, state.named(row))) for row in (g, h))
    return ex.sub(ex.mul(meet(p, a), meet(q, b)), ex.mul(meet(p, b), meet(q, a)))


_RULES = (
    (0, _flat_tetrahedra),
    (2, _planes_and_line),
    (2, _four_lines),
    (3, _four_planes),
    (3, _planes_and_three_lines),
)
