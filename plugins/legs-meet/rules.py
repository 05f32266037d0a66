"""Flat tetrahedra read as legs that meet: one that stands on two legs without a common joint is flat just then."""

from itertools import combinations

from gcrules.rules.plugins import (
    ConditionRule,
    RecognitionState,
    Statement,
    bracket,
    extensor,
    listing,
    meet,
    mul,
    points,
    say,
)


def crossing(state: RecognitionState, row: tuple[int, ...]) -> tuple[tuple[str, str], tuple[str, str]] | None:
    """Two legs without a common joint among the four points of a tetrahedron."""
    names = set(state.named(row))
    legs = [leg for leg in state.structure.oriented if set(leg) <= names]
    return next(((g, h) for g, h in combinations(legs, 2) if not set(g) & set(h)), None)


def expression(state: RecognitionState):
    """The tetrahedra, each that stands on two legs as the meet of these; None where none does."""
    pairs = [crossing(state, row) for row in state.tetrahedra]
    if not any(pairs):
        return None
    return mul(
        *(
            meet(extensor(pair[0]), extensor(pair[1])) if pair else bracket(*points(state.named(row)))
            for row, pair in zip(state.tetrahedra, pairs, strict=True)
        )
    )


def statement(state: RecognitionState) -> Statement:
    meeting, flat = [], []
    for row in state.tetrahedra:
        pair = crossing(state, row)
        if pair:
            meeting.append(say("the legs {} and {} meet (possibly at infinity)", *map(extensor, pair)))
        else:
            flat.append(say("the tetrahedron {} is flat", extensor(state.named(row))))
    return say("The robot is singular exactly when {}.", listing(flat + meeting, ", or "))


RULES = (
    ConditionRule(
        id="legs-meet",
        sentence="A tetrahedron that stands on two legs without a common joint is flat just when the two legs meet.",
        source="derived here",
        fires=("Aa Ab Ac Ba Bd Ce", "Aa Ab Ac Ba Bb Cc"),
        silent=("Aa Ab Ac Bd Be Cf", "ab af cb cd ed ef"),
        degree=0,
        expression=expression,
        statement=statement,
        group="g",
    ),
)
