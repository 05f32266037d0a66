r"""Rules that find the entities of a bracket form: tetrahedra, planes, lines, and what the left-over points make.

The procedure is that of Ben-Horin et al. (2008), with the choices they leave to the user tried in turn.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import Row
from gcrules.algebra.expr import Expr
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.recognition_state import RecognitionState
from gcrules.rules.rule import EntityRule

__all__ = ["ENTITY_RULES", "LEFT_OVER_LINE", "LEFT_OVER_LINES", "LEFT_OVER_PLANE", "LINES", "PLANES", "TETRAHEDRA"]

_SOURCE = "SinguLab2008"


# --- tetrahedra ----------------------------------------------------------------------------------------------------


def _tetrahedra(state: RecognitionState, _: int) -> Iterator[RecognitionState]:
    monomials = list(state.rest.terms)
    common = Counter(monomials[0])
    for m in monomials[1:]:
        common &= Counter(m)
    found = tuple(sorted(common.elements()))
    terms = {}
    for m, c in state.rest.terms.items():
        remaining = list(m)
        for row in found:
            remaining.remove(row)
        terms[tuple(remaining)] = c
    rest = state.rest.with_terms(terms)
    yield replace(state, rest=rest, tetrahedra=found, homes=((),) * len(rest))


def _factored(state: RecognitionState, _: RandomWitness) -> Expr | None:
    if not state.tetrahedra:
        return None
    return ex.mul(ex.Number(state.sign), *state.brackets, state.rest.to_expr())


TETRAHEDRA = EntityRule(
    id="tetrahedra",
    sentence="Brackets common to all terms are tetrahedra: the polynomial is their product times the rest.",
    source=_SOURCE,
    fires=("Aa Ab Ac Ba Bd Ce", "Aa Ab Ac Bd Ce Df"),
    silent=("ab af cb cd ed ef",),
    find=_tetrahedra,
    after=_factored,
    why=lambda s: f"brackets common to all terms are tetrahedra: {s.labels(s.tetrahedra)}",
)


# --- planes and lines ----------------------------------------------------------------------------------------------


def _together(state: RecognitionState, size: int, number: int) -> Iterator[RecognitionState]:
    """Sets of `size` points that some bracket of every term holds, `number` of them in brackets of their own."""
    common: set[Row] | None = None
    for monomial, taken in zip(state.rest.terms, state.homes, strict=True):
        here = {s for i, row in enumerate(monomial) if i not in taken for s in combinations(row, size)}
        common = here if common is None else common & here
    yield from _chosen(state, sorted(common or ()), number)


def _chosen(state: RecognitionState, candidates: list[Row], number: int) -> Iterator[RecognitionState]:
    if number == 0:
        yield state
        return
    for n, row in enumerate(candidates):
        for grown in state.with_entity(row):
            yield from _chosen(grown, candidates[n:], number - 1)


def _collected(state: RecognitionState, _: RandomWitness) -> Expr:
    return ex.signed(state.sign, state.collected())


def _together_rule(kind: str, sets: str, size: int, fires: str) -> EntityRule:
    return EntityRule(
        id=kind,
        sentence=f"{sets} of points that stay together in one bracket of every term are {kind}.",
        source=_SOURCE,
        fires=(fires,),
        silent=("Aa Bb Cc Dd Ee Ff",),
        find=lambda s, number: _together(s, size, number),
        after=_collected,
        why=lambda s: f"{sets.lower()} that stay together in one bracket of every term: {s.labels(getattr(s, kind))}",
    )


PLANES = _together_rule("planes", "Triples", 3, "ab af cb cd ed ef")
LINES = _together_rule("lines", "Pairs", 2, "Aa Ab Ba Bb Cc Dd")


# --- left-over points ----------------------------------------------------------------------------------------------


def _left_over(state: RecognitionState, size: int) -> Iterator[RecognitionState]:
    if len(set(state.left)) == len(state.left) == size:
        yield replace(state, taken=(state.left,))


def _dotted(state: RecognitionState, oracle: RandomWitness) -> Expr | None:
    dotted = state.dotted()
    factor = oracle.coefficient(dotted)
    return None if factor is None else ex.mul(ex.Number(factor), dotted)


def _left_over_rule(kind: str, number: str, size: int, fires: str, silent: str) -> EntityRule:
    return EntityRule(
        id=f"left-over-{kind}",
        sentence=f"The {number} points that no entity has taken, shared out among the planes' brackets, are a {kind}.",
        source=_SOURCE,
        fires=(fires,),
        silent=(silent,),
        find=lambda s, _: _left_over(s, size),
        after=_dotted,
        why=lambda s: f"the left-over points {s.listed(s.left)} are shared out among the planes' brackets",
    )


LEFT_OVER_PLANE = _left_over_rule("plane", "three", 3, fires="ab af cb cd ed ef", silent="Aa Ab Ac Bd Ce Df")
LEFT_OVER_LINE = _left_over_rule("line", "two", 2, fires="Aa Ab Ac Bd Ce Df", silent="ab af cb cd ed ef")


def _pairs(state: RecognitionState, _: int) -> Iterator[RecognitionState]:
    """The test decides when no point is repeated; a repeated point can hide a vanished term, so that every pairing
    stays a candidate (a claim made from it is proved or dropped).
    """
    found = []
    a, *others = state.left
    for b in others:
        rest = list(state.left)
        rest.remove(a)
        rest.remove(b)
        pairs = ((a, b), (rest[0], rest[1]))
        if a != b and rest[0] != rest[1]:
            found.append((-sum(state.swapped_sum(*p) for p in pairs), pairs))
    yield from (replace(state, taken=pairs) for _, pairs in sorted(set(found)))


def _why_pairs(state: RecognitionState) -> str:
    tests = [state.swapped_sum(*pair) for pair in state.taken]
    shown = "P(x,y) + P(y,x) = 0" if all(tests) else "found by trial, as repeated points hide terms"
    return (
        f"the left-over points {state.listed(state.left)} as the lines {state.labels(state.taken, ' and ')} ({shown})"
    )


LEFT_OVER_LINES = EntityRule(
    id="left-over-lines",
    sentence="Four points that no entity has taken are two lines, by P(x,y) + P(y,x) = 0 or by trial.",
    source=_SOURCE,
    fires=("Aa Ab Ba Bb Cc Dd",),
    silent=("ab af cb cd ed ef",),
    find=_pairs,
    after=lambda s, o: None,
    why=_why_pairs,
)

ENTITY_RULES = (TETRAHEDRA, PLANES, LINES, LEFT_OVER_PLANE, LEFT_OVER_LINE, LEFT_OVER_LINES)
"""Written out in the order in which they are tried."""
