r"""Rules that turn entities into an incidence and check it against the superbracket.

A rule makes claims cofactor · superbracket = coefficient · expression. A claim is tested on the exact oracle as soon as
it is made; the one that is chosen is then proved by normal forms, so a wrong guess can never become an answer.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import Row
from gcrules.algebra.expr import ONE, Expr, Meet, meet
from gcrules.algebra.language.legs_text import Leg
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import StepError
from gcrules.rules.entities import LEFT_OVER_LINE, LEFT_OVER_LINES, LEFT_OVER_PLANE, LINES, PLANES
from gcrules.rules.foreign import foreign, place_of
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.recognition_state import RecognitionState, extensor
from gcrules.rules.rule import ConditionRule
from gcrules.rules.statement import Statement

__all__ = ["INCIDENCES", "ConditionClaim", "claims"]


@dataclass(frozen=True)
class ConditionClaim:
    """cofactor · superbracket = coefficient · expression, with the state that shows the entities and how they were
    found. `kind`, `sentence`, `statement` and `group` are the rule's; `pencils` are the lines p and q of a transversal
    reading. `source` names a rule that comes from outside.
    """

    kind: str
    sentence: str
    state: RecognitionState
    expression: Expr
    coefficient: int
    cofactor: Expr = ONE
    pencils: tuple[Expr, Expr] | None = None
    statement: str | Statement = ""
    group: str | None = None
    source: str = ""

    @property
    def single(self) -> tuple[Leg, Leg] | None:
        """The lines g and h of a transversal reading, which allow the turns about p and q in one ratio only."""
        if self.pencils is None:
            return None
        (a, b), (c, d) = (self.state.named(row) for row in self.state.taken)
        return (a, b), (c, d)


def claims(
    incidence: ConditionRule, states: Sequence[RecognitionState], oracle: RandomWitness
) -> Iterator[ConditionClaim]:
    """The claims of one rule that hold, in any of the states.

    Raises PluginFault, with the plugin's file and line, where the code of a plugin's rule fails.
    """
    if not incidence.foreign:
        yield from _claims(incidence, states, oracle)
        return
    with foreign(f"{incidence.blame}the rule {incidence.id} fails", place_of(incidence.expression, incidence.owner)):
        found = list(_claims(incidence, states, oracle))  # what it gives is at its cost
    yield from found


def _claims(
    incidence: ConditionRule, states: Sequence[RecognitionState], oracle: RandomWitness
) -> Iterator[ConditionClaim]:
    for state in states:
        for reached in incidence.reached(state):
            expression = incidence.expression(reached)
            if expression is None:
                continue
            cofactor = incidence.cofactor(reached)
            for e in (expression, cofactor):
                if e.step:
                    raise StepError(f"{e} has step {e.step}; a claim is about scalars")
            coefficient = oracle.coefficient(expression, cofactor)
            if coefficient == -1 and isinstance(expression, Meet) and len(expression.args) == 4:
                expression, coefficient = _last_two_exchanged(expression), 1
            if coefficient is not None:
                yield ConditionClaim(
                    kind=incidence.id,
                    sentence=incidence.sentence,
                    state=reached,
                    expression=expression,
                    coefficient=coefficient,
                    cofactor=cofactor,
                    pencils=incidence.pencils(reached) if incidence.pencils else None,
                    statement=incidence.meaning(reached),
                    group=incidence.group,
                    source=incidence.named_outside,
                )


def _last_two_exchanged(e: Meet) -> Expr:
    """A meet of four planes with the opposite sign."""
    return meet(*e.args[:2], e.args[3], e.args[2])


def _extensors(state: RecognitionState, *rows: Row) -> list[Expr]:
    return [extensor(state.named(row)) for row in rows]


def _ratio(state: RecognitionState, pencils: tuple[Expr, Expr]) -> Expr:
    """Tetrahedra times (p ∧ g)(q ∧ h) − (p ∧ h)(q ∧ g)."""
    p, q = pencils
    g, h = _extensors(state, *state.taken)
    return ex.mul(*state.brackets, ex.sub(ex.mul(meet(p, g), meet(q, h)), ex.mul(meet(p, h), meet(q, g))))


def _two_lines(state: RecognitionState) -> tuple[Expr, Expr]:
    p, q = _extensors(state, *state.lines)
    return p, q


def _line_and_meet(state: RecognitionState) -> tuple[Expr, Expr]:
    (p,) = _extensors(state, *state.lines)
    return p, meet(*_extensors(state, *state.planes))


INCIDENCES = (
    ConditionRule(
        id="three-tetrahedra",
        sentence="Three common brackets: the superbracket is their product.",
        source="SinguLab2008",
        fires=("Aa Ab Ac Bd Be Cf", "S1A1 S1B1 S1C1 S2A2 S3A3 S3B3"),
        silent=("ab af cb cd ed ef",),
        group="g",
        degree=0,
        expression=lambda s: ex.mul(*s.brackets),
    ),
    ConditionRule(
        id="tetrahedron-planes-line",
        sentence="A tetrahedron, two planes X, Y and a left-over line l: the tetrahedron times X ∧ Y ∧ l.",
        source="SinguLab2008",
        fires=("Aa Ab Ac Bd Ce Df",),
        silent=("Aa Ab Ba Bb Cc Dd",),
        group="d",
        degree=2,
        uses=((PLANES, 2), (LEFT_OVER_LINE, 1)),
        expression=lambda s: ex.mul(*s.brackets, meet(*_extensors(s, *s.planes, *s.taken))),
    ),
    ConditionRule(
        id="tetrahedron-four-lines",
        sentence="A tetrahedron, two lines p, q and left-over lines g, h: it times (p ∧ g)(q ∧ h) − (p ∧ h)(q ∧ g).",
        source="SinguLab2008",
        fires=("Aa Ab Ba Bb Cc Dd",),
        silent=("Aa Ab Bc Bd Ce Cf",),
        group="e",
        degree=2,
        uses=((LINES, 2), (LEFT_OVER_LINES, 1)),
        expression=lambda s: _ratio(s, _two_lines(s)),
        pencils=_two_lines,
    ),
    ConditionRule(
        id="four-planes",
        sentence="Three planes X, Y, Z and a left-over plane W: X ∧ Y ∧ Z ∧ W.",
        source="SinguLab2008",
        fires=("ab af cb cd ed ef", "Aa Ab Bc Bd Ce Cf"),
        silent=("Aa Ab Bc Bd Ce Df",),
        group="c",
        degree=3,
        uses=((PLANES, 3), (LEFT_OVER_PLANE, 1)),
        expression=lambda s: meet(*sorted(_extensors(s, *s.planes, *s.taken), key=str)),
    ),
    ConditionRule(
        id="two-planes-three-lines",
        sentence="Two planes with common line q, a line p, left-over lines g, h: (p ∧ g)(q ∧ h) − (p ∧ h)(q ∧ g).",
        source="SinguLab2008",
        fires=("Aa Ab Bc Bd Ce Df",),
        silent=("Aa Bb Cc Dd Ee Ff",),
        group="b",
        degree=3,
        uses=((PLANES, 2), (LINES, 1), (LEFT_OVER_LINES, 1)),
        expression=lambda s: _ratio(s, _line_and_meet(s)),
        pencils=_line_and_meet,
    ),
)
"""Written out in the order in which they are tried."""
