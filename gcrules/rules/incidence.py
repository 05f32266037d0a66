r"""Rules that turn entities into an incidence and check it against the superbracket.

A rule makes claims superbracket = coefficient · expression. A claim is tested on the exact oracle as soon as it is
made; the one that is chosen is then proved by normal forms, so a wrong guess can never become an answer.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import Row
from gcrules.algebra.expr import Expr, Meet, Point, meet
from gcrules.algebra.shortest import SuperbracketForm
from gcrules.legs import Leg, Structure
from gcrules.rules.entities import LEFT_OVER_LINE, LEFT_OVER_LINES, LEFT_OVER_PLANE, LINES, PLANES, TETRAHEDRA
from gcrules.rules.oracle import Oracle
from gcrules.rules.rule import Rule, applied, reach
from gcrules.rules.state import State, extensor

__all__ = ["INCIDENCES", "MAX_TERMS", "Claim", "Incidence", "claims"]

MAX_TERMS = 8


@dataclass(frozen=True)
class Incidence:
    """A kind of condition: the rules that lead to its entities in a rest of `degree` brackets, and its expression.

    `pencils` gives the lines p and q about which the platform could turn without the two lines among the left-over
    points, for kinds that compare these turns.
    """

    kind: str
    sentence: str
    source: str
    degree: int
    rules: tuple[Rule, ...]
    expression: Callable[[State], Expr]
    pencils: Callable[[State], tuple[Expr, Expr]] | None = None

    def __reduce__(self) -> tuple[Callable[[str], Incidence], tuple[str]]:
        """Pickled by name: it is one of the table below."""
        return _of_kind, (self.kind,)


def _of_kind(kind: str) -> Incidence:
    return next(i for i in INCIDENCES if i.kind == kind)


@dataclass(frozen=True)
class Claim:
    """superbracket = coefficient · expression, with the state that shows the entities and how they were found."""

    incidence: Incidence
    state: State
    expression: Expr
    coefficient: int

    @property
    def kind(self) -> str:
        return self.incidence.kind

    @property
    def pencils(self) -> tuple[Expr, Expr] | None:
        """The lines p and q of a transversal reading."""
        return self.incidence.pencils(self.state) if self.incidence.pencils else None

    @property
    def single(self) -> tuple[Leg, Leg] | None:
        """The lines g and h of a transversal reading, which allow the turns about p and q in one ratio only."""
        if self.incidence.pencils is None:
            return None
        (a, b), (c, d) = (self.state.named(row) for row in self.state.taken)
        return (a, b), (c, d)


def claims(forms: Sequence[SuperbracketForm], structure: Structure, oracle: Oracle) -> list[Claim]:
    """All claims that hold for the first kind of incidence that any of the given bracket forms shows.

    Most tetrahedra come first; without tetrahedra four planes come before transversals.
    """
    short = [form for form in forms if len(form.polynomial) <= MAX_TERMS]
    states = [s for form in short for s in applied(TETRAHEDRA, State.start(form, structure.sign))]
    for incidence in INCIDENCES:
        found = [c for s in states if s.degree == incidence.degree for c in _claims(incidence, s, oracle)]
        if found:
            return found
    return []


def _claims(incidence: Incidence, state: State, oracle: Oracle) -> Iterator[Claim]:
    for reached in reach(incidence.rules, state):
        expression = incidence.expression(reached)
        coefficient = oracle.coefficient(expression)
        if coefficient == -1 and incidence is FOUR_PLANES:
            expression, coefficient = _last_two_exchanged(expression), 1
        if coefficient is not None:
            yield Claim(incidence, reached, expression, coefficient)


def _last_two_exchanged(e: Expr) -> Expr:
    """A meet of four planes with the opposite sign."""
    assert isinstance(e, Meet)
    return meet(*e.args[:2], e.args[3], e.args[2])


def _outer(state: State) -> list[Expr]:
    return [ex.bracket(*map(Point, state.named(row))) for row in state.tetrahedra]


def _extensors(state: State, *rows: Row) -> list[Expr]:
    return [extensor(state.named(row)) for row in rows]


def _ratio(state: State, pencils: tuple[Expr, Expr]) -> Expr:
    """Tetrahedra times (p ∧ g)(q ∧ h) − (p ∧ h)(q ∧ g)."""
    p, q = pencils
    g, h = _extensors(state, *state.taken)
    return ex.mul(*_outer(state), ex.sub(ex.mul(meet(p, g), meet(q, h)), ex.mul(meet(p, h), meet(q, g))))


def _two_lines(state: State) -> tuple[Expr, Expr]:
    p, q = _extensors(state, *state.lines)
    return p, q


def _line_and_meet(state: State) -> tuple[Expr, Expr]:
    (p,) = _extensors(state, *state.lines)
    return p, meet(*_extensors(state, *state.planes))


FOUR_PLANES = Incidence(
    kind="four-planes",
    sentence="Three planes X, Y, Z and a left-over plane W: X ∧ Y ∧ Z ∧ W.",
    source="SinguLab2008",
    degree=3,
    rules=(PLANES[3], LEFT_OVER_PLANE),
    expression=lambda s: meet(*sorted(_extensors(s, *s.planes, *s.taken), key=str)),
)

INCIDENCES = (
    Incidence(
        kind="three-tetrahedra",
        sentence="Three common brackets: the superbracket is their product.",
        source="SinguLab2008",
        degree=0,
        rules=(),
        expression=lambda s: ex.mul(*_outer(s)),
    ),
    Incidence(
        kind="tetrahedron-planes-line",
        sentence="A tetrahedron, two planes X, Y and a left-over line l: the tetrahedron times X ∧ Y ∧ l.",
        source="SinguLab2008",
        degree=2,
        rules=(PLANES[2], LEFT_OVER_LINE),
        expression=lambda s: ex.mul(*_outer(s), meet(*_extensors(s, *s.planes, *s.taken))),
    ),
    Incidence(
        kind="tetrahedron-four-lines",
        sentence="A tetrahedron, two lines p, q and left-over lines g, h: it times (p ∧ g)(q ∧ h) − (p ∧ h)(q ∧ g).",
        source="SinguLab2008",
        degree=2,
        rules=(LINES[2], LEFT_OVER_LINES),
        expression=lambda s: _ratio(s, _two_lines(s)),
        pencils=_two_lines,
    ),
    FOUR_PLANES,
    Incidence(
        kind="two-planes-three-lines",
        sentence="Two planes with common line q, a line p, left-over lines g, h: (p ∧ g)(q ∧ h) − (p ∧ h)(q ∧ g).",
        source="SinguLab2008",
        degree=3,
        rules=(PLANES[2], LINES[1], LEFT_OVER_LINES),
        expression=lambda s: _ratio(s, _line_and_meet(s)),
        pencils=_line_and_meet,
    ),
)
"""Written out in the order in which they are tried."""
